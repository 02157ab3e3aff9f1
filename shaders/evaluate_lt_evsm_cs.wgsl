struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
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

struct type_15 {
    member: array<abi_Sample>,
}

struct type_19 {
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

struct type_30 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> map: type_19;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;

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
        let _e63 = phi_153_;
        let _e65 = phi_154_;
        phi_155_ = _e63;
        phi_156_ = _e65;
    } else {
        phi_155_ = lt_bvh_traverse_Tree();
        phi_156_ = true;
    }
    let _e67 = phi_155_;
    let _e69 = phi_156_;
    if _e69 {
        phi_161_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_161_ = _e67;
    }
    let _e74 = phi_161_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_341_: bool;
    var phi_345_: f32;
    var phi_364_: f32;
    var phi_369_: f32;
    var phi_391_: f32;
    var phi_396_: f32;
    var phi_397_: bool;
    var phi_398_: f32;
    var phi_399_: bool;
    var phi_403_: f32;
    var phi_441_: f32;
    var phi_452_: f32;
    var phi_457_: f32;
    var phi_479_: f32;
    var phi_484_: f32;
    var phi_485_: bool;
    var phi_486_: f32;
    var phi_487_: bool;
    var phi_491_: f32;
    var phi_529_: f32;
    var phi_540_: f32;
    var phi_545_: f32;
    var phi_567_: f32;
    var phi_572_: f32;
    var phi_573_: bool;
    var phi_574_: f32;
    var phi_575_: bool;
    var phi_579_: f32;
    var phi_617_: f32;
    var phi_628_: f32;
    var phi_633_: f32;
    var phi_655_: f32;
    var phi_660_: f32;
    var phi_661_: bool;
    var phi_662_: f32;
    var phi_663_: bool;
    var phi_667_: f32;
    var phi_705_: f32;
    var phi_758_: bool;
    var phi_762_: f32;
    var phi_774_: bool;
    var phi_781_: f32;
    var phi_794_: bool;
    var phi_798_: f32;
    var phi_818_: f32;
    var phi_823_: f32;
    var phi_845_: f32;
    var phi_850_: f32;
    var phi_851_: bool;
    var phi_852_: f32;
    var phi_853_: bool;
    var phi_857_: f32;
    var phi_895_: f32;
    var phi_906_: f32;
    var phi_911_: f32;
    var phi_933_: f32;
    var phi_938_: f32;
    var phi_939_: bool;
    var phi_940_: f32;
    var phi_941_: bool;
    var phi_945_: f32;
    var phi_983_: f32;
    var phi_994_: f32;
    var phi_999_: f32;
    var phi_1021_: f32;
    var phi_1026_: f32;
    var phi_1027_: bool;
    var phi_1028_: f32;
    var phi_1029_: bool;
    var phi_1033_: f32;
    var phi_1071_: f32;
    var phi_1082_: f32;
    var phi_1087_: f32;
    var phi_1109_: f32;
    var phi_1114_: f32;
    var phi_1115_: bool;
    var phi_1116_: f32;
    var phi_1117_: bool;
    var phi_1121_: f32;
    var phi_1159_: f32;
    var phi_1212_: bool;
    var phi_1216_: f32;
    var phi_1228_: bool;
    var phi_1235_: f32;
    var phi_1246_: bool;
    var phi_1250_: f32;
    var phi_1265_: f32;
    var phi_1266_: f32;
    var phi_1267_: f32;

    let _e54 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_341_ = true;
    } else {
        let _e58 = (42f < _e54);
        if _e58 {
        }
        phi_341_ = _e58;
    }
    let _e60 = phi_341_;
    if _e60 {
        phi_345_ = 42f;
    } else {
        phi_345_ = _e54;
    }
    let _e62 = phi_345_;
    let _e64 = (_e62 * param_5.x);
    let _e66 = (_e62 * param_5.y);
    let _e68 = (_e62 * param_5.z);
    let _e70 = (_e62 * param_5.w);
    if ((bitcast<u32>(_e64) & 2147483647u) > 2139095040u) {
        phi_441_ = _e64;
    } else {
        if (_e64 < -87f) {
            phi_364_ = -87f;
        } else {
            phi_364_ = _e64;
        }
        let _e76 = phi_364_;
        if (_e76 > 88f) {
            phi_369_ = 88f;
        } else {
            phi_369_ = _e76;
        }
        let _e79 = phi_369_;
        let _e81 = ((_e79 * 1.442695f) + 0.5f);
        if (_e81 > -8388608f) {
            let _e93 = f32(select(0i, select(select(i32(_e81), i32(-2147483648), (_e81 < bitcast<f32>(3472883712u))), 2147483647i, (_e81 > bitcast<f32>(1325400063u))), (_e81 == _e81)));
            if (_e93 > _e81) {
                phi_391_ = 1f;
            } else {
                phi_391_ = 0f;
            }
            let _e96 = phi_391_;
            if (_e81 < 8388608f) {
                phi_396_ = (_e93 - _e96);
                phi_397_ = false;
            } else {
                phi_396_ = f32();
                phi_397_ = true;
            }
            let _e99 = phi_396_;
            let _e101 = phi_397_;
            phi_398_ = _e99;
            phi_399_ = _e101;
        } else {
            phi_398_ = f32();
            phi_399_ = true;
        }
        let _e103 = phi_398_;
        let _e105 = phi_399_;
        if _e105 {
            phi_403_ = _e81;
        } else {
            phi_403_ = _e103;
        }
        let _e107 = phi_403_;
        let _e111 = ((_e79 - (_e107 * 0.69314575f)) - (_e107 * 0.0000014286068f));
        phi_441_ = ((((((((((((((((1f / 5040f) * _e111) + (1f / 720f)) * _e111) + (1f / 120f)) * _e111) + (1f / 24f)) * _e111) + (1f / 6f)) * _e111) + 0.5f) * _e111) + 1f) * _e111) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e107), i32(-2147483648), (_e107 < bitcast<f32>(3472883712u))), 2147483647i, (_e107 > bitcast<f32>(1325400063u))), (_e107 == _e107)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e147 = phi_441_;
    if ((bitcast<u32>(_e66) & 2147483647u) > 2139095040u) {
        phi_529_ = _e66;
    } else {
        if (_e66 < -87f) {
            phi_452_ = -87f;
        } else {
            phi_452_ = _e66;
        }
        let _e153 = phi_452_;
        if (_e153 > 88f) {
            phi_457_ = 88f;
        } else {
            phi_457_ = _e153;
        }
        let _e156 = phi_457_;
        let _e158 = ((_e156 * 1.442695f) + 0.5f);
        if (_e158 > -8388608f) {
            let _e170 = f32(select(0i, select(select(i32(_e158), i32(-2147483648), (_e158 < bitcast<f32>(3472883712u))), 2147483647i, (_e158 > bitcast<f32>(1325400063u))), (_e158 == _e158)));
            if (_e170 > _e158) {
                phi_479_ = 1f;
            } else {
                phi_479_ = 0f;
            }
            let _e173 = phi_479_;
            if (_e158 < 8388608f) {
                phi_484_ = (_e170 - _e173);
                phi_485_ = false;
            } else {
                phi_484_ = f32();
                phi_485_ = true;
            }
            let _e176 = phi_484_;
            let _e178 = phi_485_;
            phi_486_ = _e176;
            phi_487_ = _e178;
        } else {
            phi_486_ = f32();
            phi_487_ = true;
        }
        let _e180 = phi_486_;
        let _e182 = phi_487_;
        if _e182 {
            phi_491_ = _e158;
        } else {
            phi_491_ = _e180;
        }
        let _e184 = phi_491_;
        let _e188 = ((_e156 - (_e184 * 0.69314575f)) - (_e184 * 0.0000014286068f));
        phi_529_ = ((((((((((((((((1f / 5040f) * _e188) + (1f / 720f)) * _e188) + (1f / 120f)) * _e188) + (1f / 24f)) * _e188) + (1f / 6f)) * _e188) + 0.5f) * _e188) + 1f) * _e188) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e184), i32(-2147483648), (_e184 < bitcast<f32>(3472883712u))), 2147483647i, (_e184 > bitcast<f32>(1325400063u))), (_e184 == _e184)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e224 = phi_529_;
    if ((bitcast<u32>(_e68) & 2147483647u) > 2139095040u) {
        phi_617_ = _e68;
    } else {
        if (_e68 < -87f) {
            phi_540_ = -87f;
        } else {
            phi_540_ = _e68;
        }
        let _e230 = phi_540_;
        if (_e230 > 88f) {
            phi_545_ = 88f;
        } else {
            phi_545_ = _e230;
        }
        let _e233 = phi_545_;
        let _e235 = ((_e233 * 1.442695f) + 0.5f);
        if (_e235 > -8388608f) {
            let _e247 = f32(select(0i, select(select(i32(_e235), i32(-2147483648), (_e235 < bitcast<f32>(3472883712u))), 2147483647i, (_e235 > bitcast<f32>(1325400063u))), (_e235 == _e235)));
            if (_e247 > _e235) {
                phi_567_ = 1f;
            } else {
                phi_567_ = 0f;
            }
            let _e250 = phi_567_;
            if (_e235 < 8388608f) {
                phi_572_ = (_e247 - _e250);
                phi_573_ = false;
            } else {
                phi_572_ = f32();
                phi_573_ = true;
            }
            let _e253 = phi_572_;
            let _e255 = phi_573_;
            phi_574_ = _e253;
            phi_575_ = _e255;
        } else {
            phi_574_ = f32();
            phi_575_ = true;
        }
        let _e257 = phi_574_;
        let _e259 = phi_575_;
        if _e259 {
            phi_579_ = _e235;
        } else {
            phi_579_ = _e257;
        }
        let _e261 = phi_579_;
        let _e265 = ((_e233 - (_e261 * 0.69314575f)) - (_e261 * 0.0000014286068f));
        phi_617_ = ((((((((((((((((1f / 5040f) * _e265) + (1f / 720f)) * _e265) + (1f / 120f)) * _e265) + (1f / 24f)) * _e265) + (1f / 6f)) * _e265) + 0.5f) * _e265) + 1f) * _e265) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e261), i32(-2147483648), (_e261 < bitcast<f32>(3472883712u))), 2147483647i, (_e261 > bitcast<f32>(1325400063u))), (_e261 == _e261)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e301 = phi_617_;
    if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
        phi_705_ = _e70;
    } else {
        if (_e70 < -87f) {
            phi_628_ = -87f;
        } else {
            phi_628_ = _e70;
        }
        let _e307 = phi_628_;
        if (_e307 > 88f) {
            phi_633_ = 88f;
        } else {
            phi_633_ = _e307;
        }
        let _e310 = phi_633_;
        let _e312 = ((_e310 * 1.442695f) + 0.5f);
        if (_e312 > -8388608f) {
            let _e324 = f32(select(0i, select(select(i32(_e312), i32(-2147483648), (_e312 < bitcast<f32>(3472883712u))), 2147483647i, (_e312 > bitcast<f32>(1325400063u))), (_e312 == _e312)));
            if (_e324 > _e312) {
                phi_655_ = 1f;
            } else {
                phi_655_ = 0f;
            }
            let _e327 = phi_655_;
            if (_e312 < 8388608f) {
                phi_660_ = (_e324 - _e327);
                phi_661_ = false;
            } else {
                phi_660_ = f32();
                phi_661_ = true;
            }
            let _e330 = phi_660_;
            let _e332 = phi_661_;
            phi_662_ = _e330;
            phi_663_ = _e332;
        } else {
            phi_662_ = f32();
            phi_663_ = true;
        }
        let _e334 = phi_662_;
        let _e336 = phi_663_;
        if _e336 {
            phi_667_ = _e312;
        } else {
            phi_667_ = _e334;
        }
        let _e338 = phi_667_;
        let _e342 = ((_e310 - (_e338 * 0.69314575f)) - (_e338 * 0.0000014286068f));
        phi_705_ = ((((((((((((((((1f / 5040f) * _e342) + (1f / 720f)) * _e342) + (1f / 120f)) * _e342) + (1f / 24f)) * _e342) + (1f / 6f)) * _e342) + 0.5f) * _e342) + 1f) * _e342) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e338), i32(-2147483648), (_e338 < bitcast<f32>(3472883712u))), 2147483647i, (_e338 > bitcast<f32>(1325400063u))), (_e338 == _e338)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e378 = phi_705_;
    let _e380 = (_e147 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e382 = (_e224 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e384 = (_e301 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e386 = (_e378 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e388 = (*param_4).min_variance;
    let _e390 = ((_e388 * _e62) * _e62);
    let _e401 = ((((_e380 * param_6.x) + (_e382 * param_6.y)) + (_e384 * param_6.z)) + (_e386 * param_6.w));
    let _e402 = (_e380 - _e401);
    let _e403 = (_e382 - _e401);
    let _e404 = (_e384 - _e401);
    let _e405 = (_e386 - _e401);
    let _e420 = (((((_e402 * _e402) * param_6.x) + ((_e403 * _e403) * param_6.y)) + ((_e404 * _e404) * param_6.z)) + ((_e405 * _e405) * param_6.w));
    if ((bitcast<u32>(_e390) & 2147483647u) > 2139095040u) {
        phi_758_ = true;
    } else {
        let _e424 = (_e390 > _e420);
        if _e424 {
        }
        phi_758_ = _e424;
    }
    let _e426 = phi_758_;
    if _e426 {
        phi_762_ = _e390;
    } else {
        phi_762_ = _e420;
    }
    let _e428 = phi_762_;
    let _e429 = -(_e401);
    if (_e429 <= 0f) {
        let _e433 = ((bitcast<u32>(_e428) & 2147483647u) > 2139095040u);
        if _e433 {
        }
        phi_774_ = _e433;
    } else {
        phi_774_ = true;
    }
    let _e435 = phi_774_;
    if _e435 {
        phi_781_ = (_e428 / (_e428 + (_e429 * _e429)));
    } else {
        phi_781_ = 1f;
    }
    let _e440 = phi_781_;
    let _e442 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_794_ = true;
    } else {
        let _e446 = (42f < _e442);
        if _e446 {
        }
        phi_794_ = _e446;
    }
    let _e448 = phi_794_;
    if _e448 {
        phi_798_ = 42f;
    } else {
        phi_798_ = _e442;
    }
    let _e450 = phi_798_;
    let _e451 = -(_e450);
    let _e453 = (_e451 * param_5.x);
    let _e455 = (_e451 * param_5.y);
    let _e457 = (_e451 * param_5.z);
    let _e459 = (_e451 * param_5.w);
    if ((bitcast<u32>(_e453) & 2147483647u) > 2139095040u) {
        phi_895_ = _e453;
    } else {
        if (_e453 < -87f) {
            phi_818_ = -87f;
        } else {
            phi_818_ = _e453;
        }
        let _e465 = phi_818_;
        if (_e465 > 88f) {
            phi_823_ = 88f;
        } else {
            phi_823_ = _e465;
        }
        let _e468 = phi_823_;
        let _e470 = ((_e468 * 1.442695f) + 0.5f);
        if (_e470 > -8388608f) {
            let _e482 = f32(select(0i, select(select(i32(_e470), i32(-2147483648), (_e470 < bitcast<f32>(3472883712u))), 2147483647i, (_e470 > bitcast<f32>(1325400063u))), (_e470 == _e470)));
            if (_e482 > _e470) {
                phi_845_ = 1f;
            } else {
                phi_845_ = 0f;
            }
            let _e485 = phi_845_;
            if (_e470 < 8388608f) {
                phi_850_ = (_e482 - _e485);
                phi_851_ = false;
            } else {
                phi_850_ = f32();
                phi_851_ = true;
            }
            let _e488 = phi_850_;
            let _e490 = phi_851_;
            phi_852_ = _e488;
            phi_853_ = _e490;
        } else {
            phi_852_ = f32();
            phi_853_ = true;
        }
        let _e492 = phi_852_;
        let _e494 = phi_853_;
        if _e494 {
            phi_857_ = _e470;
        } else {
            phi_857_ = _e492;
        }
        let _e496 = phi_857_;
        let _e500 = ((_e468 - (_e496 * 0.69314575f)) - (_e496 * 0.0000014286068f));
        phi_895_ = ((((((((((((((((1f / 5040f) * _e500) + (1f / 720f)) * _e500) + (1f / 120f)) * _e500) + (1f / 24f)) * _e500) + (1f / 6f)) * _e500) + 0.5f) * _e500) + 1f) * _e500) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e496), i32(-2147483648), (_e496 < bitcast<f32>(3472883712u))), 2147483647i, (_e496 > bitcast<f32>(1325400063u))), (_e496 == _e496)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e536 = phi_895_;
    if ((bitcast<u32>(_e455) & 2147483647u) > 2139095040u) {
        phi_983_ = _e455;
    } else {
        if (_e455 < -87f) {
            phi_906_ = -87f;
        } else {
            phi_906_ = _e455;
        }
        let _e542 = phi_906_;
        if (_e542 > 88f) {
            phi_911_ = 88f;
        } else {
            phi_911_ = _e542;
        }
        let _e545 = phi_911_;
        let _e547 = ((_e545 * 1.442695f) + 0.5f);
        if (_e547 > -8388608f) {
            let _e559 = f32(select(0i, select(select(i32(_e547), i32(-2147483648), (_e547 < bitcast<f32>(3472883712u))), 2147483647i, (_e547 > bitcast<f32>(1325400063u))), (_e547 == _e547)));
            if (_e559 > _e547) {
                phi_933_ = 1f;
            } else {
                phi_933_ = 0f;
            }
            let _e562 = phi_933_;
            if (_e547 < 8388608f) {
                phi_938_ = (_e559 - _e562);
                phi_939_ = false;
            } else {
                phi_938_ = f32();
                phi_939_ = true;
            }
            let _e565 = phi_938_;
            let _e567 = phi_939_;
            phi_940_ = _e565;
            phi_941_ = _e567;
        } else {
            phi_940_ = f32();
            phi_941_ = true;
        }
        let _e569 = phi_940_;
        let _e571 = phi_941_;
        if _e571 {
            phi_945_ = _e547;
        } else {
            phi_945_ = _e569;
        }
        let _e573 = phi_945_;
        let _e577 = ((_e545 - (_e573 * 0.69314575f)) - (_e573 * 0.0000014286068f));
        phi_983_ = ((((((((((((((((1f / 5040f) * _e577) + (1f / 720f)) * _e577) + (1f / 120f)) * _e577) + (1f / 24f)) * _e577) + (1f / 6f)) * _e577) + 0.5f) * _e577) + 1f) * _e577) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e573), i32(-2147483648), (_e573 < bitcast<f32>(3472883712u))), 2147483647i, (_e573 > bitcast<f32>(1325400063u))), (_e573 == _e573)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e613 = phi_983_;
    if ((bitcast<u32>(_e457) & 2147483647u) > 2139095040u) {
        phi_1071_ = _e457;
    } else {
        if (_e457 < -87f) {
            phi_994_ = -87f;
        } else {
            phi_994_ = _e457;
        }
        let _e619 = phi_994_;
        if (_e619 > 88f) {
            phi_999_ = 88f;
        } else {
            phi_999_ = _e619;
        }
        let _e622 = phi_999_;
        let _e624 = ((_e622 * 1.442695f) + 0.5f);
        if (_e624 > -8388608f) {
            let _e636 = f32(select(0i, select(select(i32(_e624), i32(-2147483648), (_e624 < bitcast<f32>(3472883712u))), 2147483647i, (_e624 > bitcast<f32>(1325400063u))), (_e624 == _e624)));
            if (_e636 > _e624) {
                phi_1021_ = 1f;
            } else {
                phi_1021_ = 0f;
            }
            let _e639 = phi_1021_;
            if (_e624 < 8388608f) {
                phi_1026_ = (_e636 - _e639);
                phi_1027_ = false;
            } else {
                phi_1026_ = f32();
                phi_1027_ = true;
            }
            let _e642 = phi_1026_;
            let _e644 = phi_1027_;
            phi_1028_ = _e642;
            phi_1029_ = _e644;
        } else {
            phi_1028_ = f32();
            phi_1029_ = true;
        }
        let _e646 = phi_1028_;
        let _e648 = phi_1029_;
        if _e648 {
            phi_1033_ = _e624;
        } else {
            phi_1033_ = _e646;
        }
        let _e650 = phi_1033_;
        let _e654 = ((_e622 - (_e650 * 0.69314575f)) - (_e650 * 0.0000014286068f));
        phi_1071_ = ((((((((((((((((1f / 5040f) * _e654) + (1f / 720f)) * _e654) + (1f / 120f)) * _e654) + (1f / 24f)) * _e654) + (1f / 6f)) * _e654) + 0.5f) * _e654) + 1f) * _e654) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e650), i32(-2147483648), (_e650 < bitcast<f32>(3472883712u))), 2147483647i, (_e650 > bitcast<f32>(1325400063u))), (_e650 == _e650)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e690 = phi_1071_;
    if ((bitcast<u32>(_e459) & 2147483647u) > 2139095040u) {
        phi_1159_ = _e459;
    } else {
        if (_e459 < -87f) {
            phi_1082_ = -87f;
        } else {
            phi_1082_ = _e459;
        }
        let _e696 = phi_1082_;
        if (_e696 > 88f) {
            phi_1087_ = 88f;
        } else {
            phi_1087_ = _e696;
        }
        let _e699 = phi_1087_;
        let _e701 = ((_e699 * 1.442695f) + 0.5f);
        if (_e701 > -8388608f) {
            let _e713 = f32(select(0i, select(select(i32(_e701), i32(-2147483648), (_e701 < bitcast<f32>(3472883712u))), 2147483647i, (_e701 > bitcast<f32>(1325400063u))), (_e701 == _e701)));
            if (_e713 > _e701) {
                phi_1109_ = 1f;
            } else {
                phi_1109_ = 0f;
            }
            let _e716 = phi_1109_;
            if (_e701 < 8388608f) {
                phi_1114_ = (_e713 - _e716);
                phi_1115_ = false;
            } else {
                phi_1114_ = f32();
                phi_1115_ = true;
            }
            let _e719 = phi_1114_;
            let _e721 = phi_1115_;
            phi_1116_ = _e719;
            phi_1117_ = _e721;
        } else {
            phi_1116_ = f32();
            phi_1117_ = true;
        }
        let _e723 = phi_1116_;
        let _e725 = phi_1117_;
        if _e725 {
            phi_1121_ = _e701;
        } else {
            phi_1121_ = _e723;
        }
        let _e727 = phi_1121_;
        let _e731 = ((_e699 - (_e727 * 0.69314575f)) - (_e727 * 0.0000014286068f));
        phi_1159_ = ((((((((((((((((1f / 5040f) * _e731) + (1f / 720f)) * _e731) + (1f / 120f)) * _e731) + (1f / 24f)) * _e731) + (1f / 6f)) * _e731) + 0.5f) * _e731) + 1f) * _e731) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e727), i32(-2147483648), (_e727 < bitcast<f32>(3472883712u))), 2147483647i, (_e727 > bitcast<f32>(1325400063u))), (_e727 == _e727)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e767 = phi_1159_;
    let _e769 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e536);
    let _e771 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e613);
    let _e773 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e690);
    let _e775 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e767);
    let _e777 = (*param_4).min_variance;
    let _e779 = ((_e777 * _e450) * _e450);
    let _e790 = ((((_e769 * param_6.x) + (_e771 * param_6.y)) + (_e773 * param_6.z)) + (_e775 * param_6.w));
    let _e791 = (_e769 - _e790);
    let _e792 = (_e771 - _e790);
    let _e793 = (_e773 - _e790);
    let _e794 = (_e775 - _e790);
    let _e809 = (((((_e791 * _e791) * param_6.x) + ((_e792 * _e792) * param_6.y)) + ((_e793 * _e793) * param_6.z)) + ((_e794 * _e794) * param_6.w));
    if ((bitcast<u32>(_e779) & 2147483647u) > 2139095040u) {
        phi_1212_ = true;
    } else {
        let _e813 = (_e779 > _e809);
        if _e813 {
        }
        phi_1212_ = _e813;
    }
    let _e815 = phi_1212_;
    if _e815 {
        phi_1216_ = _e779;
    } else {
        phi_1216_ = _e809;
    }
    let _e817 = phi_1216_;
    let _e818 = -(_e790);
    if (_e818 <= 0f) {
        let _e822 = ((bitcast<u32>(_e817) & 2147483647u) > 2139095040u);
        if _e822 {
        }
        phi_1228_ = _e822;
    } else {
        phi_1228_ = true;
    }
    let _e824 = phi_1228_;
    if _e824 {
        phi_1235_ = (_e817 / (_e817 + (_e818 * _e818)));
    } else {
        phi_1235_ = 1f;
    }
    let _e829 = phi_1235_;
    if ((bitcast<u32>(_e829) & 2147483647u) > 2139095040u) {
        phi_1246_ = true;
    } else {
        let _e833 = (_e829 < _e440);
        if _e833 {
        }
        phi_1246_ = _e833;
    }
    let _e835 = phi_1246_;
    if _e835 {
        phi_1250_ = _e829;
    } else {
        phi_1250_ = _e440;
    }
    let _e837 = phi_1250_;
    if ((bitcast<u32>(_e837) & 2147483647u) > 2139095040u) {
        phi_1267_ = _e837;
    } else {
        if (_e837 < 0f) {
            phi_1266_ = 0f;
        } else {
            if (_e837 > 1f) {
                phi_1265_ = 1f;
            } else {
                phi_1265_ = _e837;
            }
            let _e844 = phi_1265_;
            phi_1266_ = _e844;
        }
        let _e846 = phi_1266_;
        phi_1267_ = _e846;
    }
    let _e848 = phi_1267_;
    return _e848;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_190_: f32;
    var phi_191_: f32;
    var phi_192_: f32;
    var phi_208_: f32;
    var phi_209_: f32;
    var phi_210_: f32;
    var phi_226_: f32;
    var phi_227_: f32;
    var phi_228_: f32;
    var phi_244_: f32;
    var phi_245_: f32;
    var phi_246_: f32;
    var phi_262_: f32;
    var phi_263_: f32;
    var phi_264_: f32;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_303_: bool;
    var phi_304_: bool;
    var phi_305_: bool;
    var phi_306_: bool;
    var phi_307_: bool;
    var phi_308_: bool;
    var phi_309_: bool;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_315_: bool;
    var phi_319_: bool;
    var phi_324_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_192_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_191_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_190_ = 1f;
            } else {
                phi_190_ = param_10;
            }
            let _e60 = phi_190_;
            phi_191_ = _e60;
        }
        let _e62 = phi_191_;
        phi_192_ = _e62;
    }
    let _e64 = phi_192_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_210_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_209_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_208_ = 1f;
            } else {
                phi_208_ = param_8.x;
            }
            let _e72 = phi_208_;
            phi_209_ = _e72;
        }
        let _e74 = phi_209_;
        phi_210_ = _e74;
    }
    let _e76 = phi_210_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_228_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_227_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_226_ = 1f;
            } else {
                phi_226_ = param_8.y;
            }
            let _e84 = phi_226_;
            phi_227_ = _e84;
        }
        let _e86 = phi_227_;
        phi_228_ = _e86;
    }
    let _e88 = phi_228_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_246_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_245_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_244_ = 1f;
            } else {
                phi_244_ = param_8.z;
            }
            let _e96 = phi_244_;
            phi_245_ = _e96;
        }
        let _e98 = phi_245_;
        phi_246_ = _e98;
    }
    let _e100 = phi_246_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_264_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_263_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_262_ = 1f;
            } else {
                phi_262_ = param_8.w;
            }
            let _e108 = phi_262_;
            phi_263_ = _e108;
        }
        let _e110 = phi_263_;
        phi_264_ = _e110;
    }
    let _e112 = phi_264_;
    let _e113 = (_e76 - _e64);
    let _e114 = (_e88 - _e64);
    let _e115 = (_e100 - _e64);
    let _e116 = (_e112 - _e64);
    if (_e113 >= 0f) {
        if (_e114 >= 0f) {
            if (_e115 >= 0f) {
                if (_e116 >= 0f) {
                    phi_301_ = !(((bitcast<u32>(((((_e113 * param_9.x) + (_e114 * param_9.y)) + (_e115 * param_9.z)) + (_e116 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_302_ = false;
                } else {
                    phi_301_ = bool();
                    phi_302_ = true;
                }
                let _e138 = phi_301_;
                let _e140 = phi_302_;
                phi_303_ = _e138;
                phi_304_ = false;
                phi_305_ = _e140;
            } else {
                phi_303_ = bool();
                phi_304_ = true;
                phi_305_ = false;
            }
            let _e142 = phi_303_;
            let _e144 = phi_304_;
            let _e146 = phi_305_;
            phi_306_ = _e142;
            phi_307_ = _e144;
            phi_308_ = _e146;
        } else {
            phi_306_ = bool();
            phi_307_ = true;
            phi_308_ = false;
        }
        let _e148 = phi_306_;
        let _e150 = phi_307_;
        let _e152 = phi_308_;
        phi_309_ = _e148;
        phi_310_ = _e150;
        phi_311_ = _e152;
    } else {
        phi_309_ = bool();
        phi_310_ = true;
        phi_311_ = false;
    }
    let _e154 = phi_309_;
    let _e156 = phi_310_;
    let _e158 = phi_311_;
    if _e156 {
        phi_315_ = true;
    } else {
        phi_315_ = _e158;
    }
    let _e160 = phi_315_;
    if _e160 {
        phi_319_ = false;
    } else {
        phi_319_ = _e154;
    }
    let _e162 = phi_319_;
    if _e162 {
        phi_324_ = 1f;
    } else {
        let _e163 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e113, _e114, _e115, _e116), param_9);
        phi_324_ = _e163;
    }
    let _e165 = phi_324_;
    return _e165;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_1323_: bool;
    var phi_1324_: bool;
    var phi_1325_: bool;
    var phi_1326_: bool;
    var phi_1330_: bool;
    var phi_1400_: bool;
    var phi_1401_: bool;
    var phi_1412_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1413_: bool;
    var phi_1414_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1415_: bool;
    var phi_1422_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1426_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1500_: bool;
    var phi_1509_: bool;
    var phi_1518_: bool;
    var phi_1519_: bool;
    var phi_1520_: bool;
    var phi_1521_: bool;
    var phi_1522_: bool;
    var phi_1523_: bool;
    var phi_1524_: bool;
    var phi_1528_: bool;
    var phi_1618_: f32;
    var phi_1621_: f32;
    var phi_1650_: f32;
    var phi_1655_: f32;
    var phi_1656_: bool;
    var phi_1657_: f32;
    var phi_1658_: bool;
    var phi_1662_: f32;
    var phi_1682_: f32;
    var phi_1687_: f32;
    var phi_1688_: bool;
    var phi_1689_: f32;
    var phi_1690_: bool;
    var phi_1694_: f32;
    var phi_1746_: i32;
    var phi_1751_: i32;
    var phi_1756_: i32;
    var phi_1761_: i32;
    var phi_1770_: i32;
    var phi_1775_: i32;
    var phi_1780_: i32;
    var phi_1785_: i32;
    var phi_1838_: bool;
    var phi_1846_: bool;
    var phi_1858_: bool;
    var phi_1859_: bool;
    var phi_1863_: f32;
    var phi_1869_: f32;
    var phi_1871_: evaluate_Verdict;
    var phi_1881_: u32;
    var phi_1890_: f32;
    var phi_1892_: evaluate_Verdict;
    var phi_1893_: bool;
    var phi_1894_: evaluate_Verdict;
    var phi_1895_: bool;
    var phi_1900_: evaluate_Verdict;
    var phi_1905_: evaluate_Verdict;
    var phi_1906_: evaluate_Verdict;

    let _e51 = id_1;
    let _e58 = arrayLength((&map.member));
    let _e64 = p.member.size[0u];
    let _e66 = p.member.size[1u];
    let _e67 = lt_shaders_entry_pixel_index(_e51, _e64, _e66);
    if (bitcast<i32>(_e67.root) != 0i) {
        let _e73 = p.member.projection;
        if (_e67.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e77 = lt_math_OneLevel(_e73);
        let _e81 = samples.member[(0u + _e67.first_primitive)].normal[0u];
        let _e83 = global[0u];
        if (_e81 == _e83) {
            let _e86 = samples.member[(0u + _e67.first_primitive)].normal[1u];
            let _e88 = global[1u];
            if (_e86 == _e88) {
                let _e91 = samples.member[(0u + _e67.first_primitive)].normal[2u];
                let _e93 = global[2u];
                phi_1323_ = (_e91 == _e93);
                phi_1324_ = false;
            } else {
                phi_1323_ = bool();
                phi_1324_ = true;
            }
            let _e96 = phi_1323_;
            let _e98 = phi_1324_;
            phi_1325_ = _e96;
            phi_1326_ = _e98;
        } else {
            phi_1325_ = bool();
            phi_1326_ = true;
        }
        let _e100 = phi_1325_;
        let _e102 = phi_1326_;
        if _e102 {
            phi_1330_ = false;
        } else {
            phi_1330_ = _e100;
        }
        let _e104 = phi_1330_;
        if !(_e104) {
            let _e107 = samples.member[(0u + _e67.first_primitive)].position;
            let _e109 = p.member.light.place;
            let _e115 = p.member.light.place[3u];
            let _e122 = (_e109.x - (_e107.x * _e115));
            let _e123 = (_e109.y - (_e107.y * _e115));
            let _e124 = (_e109.z - (_e107.z * _e115));
            let _e126 = samples.member[(0u + _e67.first_primitive)].normal;
            if ((((_e126.x * _e122) + (_e126.y * _e123)) + (_e126.z * _e124)) > 0f) {
                let _e140 = (((_e122 * _e122) + (_e123 * _e123)) + (_e124 * _e124));
                let _e142 = p.member.light.axis;
                let _e154 = p.member.light.place[3u];
                if (_e154 == 0f) {
                    phi_1401_ = true;
                } else {
                    let _e157 = p.member.light.range_squared;
                    if (_e140 <= _e157) {
                        let _e160 = p.member.light.cos_outer;
                        phi_1400_ = (-((((_e122 * _e142.x) + (_e123 * _e142.y)) + (_e124 * _e142.z))) >= (_e160 * sqrt(_e140)));
                    } else {
                        phi_1400_ = false;
                    }
                    let _e165 = phi_1400_;
                    phi_1401_ = _e165;
                }
                let _e167 = phi_1401_;
                if _e167 {
                    let _e169 = samples.member[(0u + _e67.first_primitive)].flags;
                    let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e183 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e177.unnamed.visibility, false), _e177.unnamed_1);
                    phi_1412_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e183.unnamed, ((_e169 & 1u) == 0u));
                    phi_1413_ = false;
                } else {
                    phi_1412_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1413_ = true;
                }
                let _e188 = phi_1412_;
                let _e190 = phi_1413_;
                phi_1414_ = _e188;
                phi_1415_ = _e190;
            } else {
                phi_1414_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1415_ = true;
            }
            let _e192 = phi_1414_;
            let _e194 = phi_1415_;
            if _e194 {
                let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e206 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e200.unnamed.visibility, false), _e200.unnamed_1);
                phi_1422_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e206.unnamed, true);
            } else {
                phi_1422_ = _e192;
            }
            let _e211 = phi_1422_;
            phi_1426_ = _e211;
        } else {
            let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e223 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e217.unnamed.visibility, false), _e217.unnamed_1);
            phi_1426_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e223.unnamed, true);
        }
        let _e228 = phi_1426_;
        if _e228.unnamed_1 {
            phi_1906_ = evaluate_Verdict(_e228.unnamed.visibility, _e228.unnamed.is_doubted);
        } else {
            let _e236 = samples.member[(0u + _e67.first_primitive)].position;
            let _e254 = ((((_e77.projection.row_w.x * _e236.x) + (_e77.projection.row_w.y * _e236.y)) + (_e77.projection.row_w.z * _e236.z)) + (_e77.projection.row_w.w * 1f));
            let _e268 = (((((_e77.projection.row_x.x * _e236.x) + (_e77.projection.row_x.y * _e236.y)) + (_e77.projection.row_x.z * _e236.z)) + (_e77.projection.row_x.w * 1f)) / _e254);
            let _e282 = (((((_e77.projection.row_y.x * _e236.x) + (_e77.projection.row_y.y * _e236.y)) + (_e77.projection.row_y.z * _e236.z)) + (_e77.projection.row_y.w * 1f)) / _e254);
            let _e295 = ((((_e77.projection.row_z.x * _e236.x) + (_e77.projection.row_z.y * _e236.y)) + (_e77.projection.row_z.z * _e236.z)) + (_e77.projection.row_z.w * 1f));
            if (_e254 > 0f) {
                if (_e268 >= 0f) {
                    phi_1500_ = (_e268 <= 1f);
                } else {
                    phi_1500_ = false;
                }
                let _e300 = phi_1500_;
                if _e300 {
                    if (_e282 >= 0f) {
                        phi_1509_ = (_e282 <= 1f);
                    } else {
                        phi_1509_ = false;
                    }
                    let _e304 = phi_1509_;
                    if _e304 {
                        if (_e295 >= 0f) {
                            phi_1518_ = (_e295 <= 1f);
                        } else {
                            phi_1518_ = false;
                        }
                        let _e308 = phi_1518_;
                        phi_1519_ = _e308;
                        phi_1520_ = false;
                    } else {
                        phi_1519_ = bool();
                        phi_1520_ = true;
                    }
                    let _e310 = phi_1519_;
                    let _e312 = phi_1520_;
                    phi_1521_ = _e310;
                    phi_1522_ = _e312;
                } else {
                    phi_1521_ = bool();
                    phi_1522_ = true;
                }
                let _e314 = phi_1521_;
                let _e316 = phi_1522_;
                phi_1523_ = _e314;
                phi_1524_ = _e316;
            } else {
                phi_1523_ = bool();
                phi_1524_ = true;
            }
            let _e318 = phi_1523_;
            let _e320 = phi_1524_;
            if _e320 {
                phi_1528_ = false;
            } else {
                phi_1528_ = _e318;
            }
            let _e322 = phi_1528_;
            if _e322 {
                if (0f > 0f) {
                    let _e325 = samples.member[(0u + _e67.first_primitive)].normal;
                    let _e327 = p.member.map_size;
                    let _e397 = ((abs(((((_e73.row_x.x * _e325.x) + (_e73.row_x.y * _e325.y)) + (_e73.row_x.z * _e325.z)) / (((_e73.row_x.x * _e73.row_x.x) + (_e73.row_x.y * _e73.row_x.y)) + (_e73.row_x.z * _e73.row_x.z)))) + abs(((((_e73.row_y.x * _e325.x) + (_e73.row_y.y * _e325.y)) + (_e73.row_y.z * _e325.z)) / (((_e73.row_y.x * _e73.row_y.x) + (_e73.row_y.y * _e73.row_y.y)) + (_e73.row_y.z * _e73.row_y.z))))) / (abs(((((_e73.row_z.x * _e325.x) + (_e73.row_z.y * _e325.y)) + (_e73.row_z.z * _e325.z)) / (((_e73.row_z.x * _e73.row_z.x) + (_e73.row_z.y * _e73.row_z.y)) + (_e73.row_z.z * _e73.row_z.z)))) * f32(_e327)));
                    if (_e397 < 0.002f) {
                        phi_1618_ = _e397;
                    } else {
                        phi_1618_ = 0.002f;
                    }
                    let _e400 = phi_1618_;
                    phi_1621_ = (_e295 - (0f * _e400));
                } else {
                    phi_1621_ = _e295;
                }
                let _e404 = phi_1621_;
                let _e406 = p.member.map_size;
                let _e407 = f32(_e406);
                let _e410 = ((_e268 * _e407) - 0.5f);
                let _e411 = ((_e282 * _e407) - 0.5f);
                if (_e410 > -8388608f) {
                    let _e423 = f32(select(0i, select(select(i32(_e410), i32(-2147483648), (_e410 < bitcast<f32>(3472883712u))), 2147483647i, (_e410 > bitcast<f32>(1325400063u))), (_e410 == _e410)));
                    if (_e423 > _e410) {
                        phi_1650_ = 1f;
                    } else {
                        phi_1650_ = 0f;
                    }
                    let _e426 = phi_1650_;
                    if (_e410 < 8388608f) {
                        phi_1655_ = (_e423 - _e426);
                        phi_1656_ = false;
                    } else {
                        phi_1655_ = f32();
                        phi_1656_ = true;
                    }
                    let _e429 = phi_1655_;
                    let _e431 = phi_1656_;
                    phi_1657_ = _e429;
                    phi_1658_ = _e431;
                } else {
                    phi_1657_ = f32();
                    phi_1658_ = true;
                }
                let _e433 = phi_1657_;
                let _e435 = phi_1658_;
                if _e435 {
                    phi_1662_ = _e410;
                } else {
                    phi_1662_ = _e433;
                }
                let _e437 = phi_1662_;
                if (_e411 > -8388608f) {
                    let _e449 = f32(select(0i, select(select(i32(_e411), i32(-2147483648), (_e411 < bitcast<f32>(3472883712u))), 2147483647i, (_e411 > bitcast<f32>(1325400063u))), (_e411 == _e411)));
                    if (_e449 > _e411) {
                        phi_1682_ = 1f;
                    } else {
                        phi_1682_ = 0f;
                    }
                    let _e452 = phi_1682_;
                    if (_e411 < 8388608f) {
                        phi_1687_ = (_e449 - _e452);
                        phi_1688_ = false;
                    } else {
                        phi_1687_ = f32();
                        phi_1688_ = true;
                    }
                    let _e455 = phi_1687_;
                    let _e457 = phi_1688_;
                    phi_1689_ = _e455;
                    phi_1690_ = _e457;
                } else {
                    phi_1689_ = f32();
                    phi_1690_ = true;
                }
                let _e459 = phi_1689_;
                let _e461 = phi_1690_;
                if _e461 {
                    phi_1694_ = _e411;
                } else {
                    phi_1694_ = _e459;
                }
                let _e463 = phi_1694_;
                let _e464 = (_e410 - _e437);
                let _e465 = (_e411 - _e463);
                let _e474 = select(0i, select(select(i32(_e437), i32(-2147483648), (_e437 < bitcast<f32>(3472883712u))), 2147483647i, (_e437 > bitcast<f32>(1325400063u))), (_e437 == _e437));
                let _e483 = select(0i, select(select(i32(_e463), i32(-2147483648), (_e463 < bitcast<f32>(3472883712u))), 2147483647i, (_e463 > bitcast<f32>(1325400063u))), (_e463 == _e463));
                let _e494 = p.member.test;
                let _e495 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e494);
                let _e497 = p.member.map_size;
                local = lt_math_Evsm(_e495.positive_exponent, _e495.negative_exponent, _e495.min_variance);
                let _e503 = ((0u * _e497) * _e497);
                let _e505 = (bitcast<i32>(_e497) - 1i);
                if (_e474 > 0i) {
                    phi_1746_ = _e474;
                } else {
                    phi_1746_ = 0i;
                }
                let _e508 = phi_1746_;
                if (_e483 > 0i) {
                    phi_1751_ = _e483;
                } else {
                    phi_1751_ = 0i;
                }
                let _e511 = phi_1751_;
                if (_e508 < _e505) {
                    phi_1756_ = _e508;
                } else {
                    phi_1756_ = _e505;
                }
                let _e514 = phi_1756_;
                if (_e511 < _e505) {
                    phi_1761_ = _e511;
                } else {
                    phi_1761_ = _e505;
                }
                let _e517 = phi_1761_;
                let _e518 = bitcast<u32>(_e514);
                let _e520 = (_e474 + 1i);
                let _e521 = (_e483 + 1i);
                if (_e520 > 0i) {
                    phi_1770_ = _e520;
                } else {
                    phi_1770_ = 0i;
                }
                let _e524 = phi_1770_;
                if (_e521 > 0i) {
                    phi_1775_ = _e521;
                } else {
                    phi_1775_ = 0i;
                }
                let _e527 = phi_1775_;
                if (_e524 < _e505) {
                    phi_1780_ = _e524;
                } else {
                    phi_1780_ = _e505;
                }
                let _e530 = phi_1780_;
                if (_e527 < _e505) {
                    phi_1785_ = _e527;
                } else {
                    phi_1785_ = _e505;
                }
                let _e533 = phi_1785_;
                let _e534 = bitcast<u32>(_e530);
                let _e536 = (bitcast<u32>(_e517) * _e497);
                let _e537 = (bitcast<u32>(_e533) * _e497);
                let _e542 = ((_e536 + _e518) + _e503);
                let _e543 = ((_e536 + _e534) + _e503);
                let _e544 = ((_e537 + _e518) + _e503);
                let _e545 = ((_e537 + _e534) + _e503);
                if (_e542 < _e58) {
                } else {
                    return;
                }
                let _e549 = map.member[(0u + _e542)];
                if (_e543 < _e58) {
                } else {
                    return;
                }
                let _e553 = map.member[(0u + _e543)];
                if (_e544 < _e58) {
                } else {
                    return;
                }
                let _e557 = map.member[(0u + _e544)];
                if (_e545 < _e58) {
                } else {
                    return;
                }
                let _e561 = map.member[(0u + _e545)];
                let _e563 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e549, _e553, _e557, _e561), vec4<f32>(((1f - _e464) * (1f - _e465)), (_e464 * (1f - _e465)), ((1f - _e464) * _e465), (_e464 * _e465)), _e404);
                let _e567 = p.member.epsilon;
                if (_e563 <= _e567) {
                    phi_1838_ = true;
                } else {
                    phi_1838_ = (_e563 >= (1f - _e567));
                }
                let _e572 = phi_1838_;
                if ((bitcast<u32>(_e563) & 2147483647u) > 2139095040u) {
                    phi_1846_ = true;
                } else {
                    phi_1846_ = !(_e572);
                }
                let _e578 = phi_1846_;
                if _e578 {
                    if (_e563 > 0f) {
                        if (_e563 < 1f) {
                            phi_1858_ = false;
                        } else {
                            phi_1858_ = true;
                        }
                        let _e582 = phi_1858_;
                        phi_1859_ = _e582;
                    } else {
                        phi_1859_ = true;
                    }
                    let _e584 = phi_1859_;
                    if _e584 {
                        phi_1863_ = 0.5f;
                    } else {
                        phi_1863_ = _e563;
                    }
                    let _e586 = phi_1863_;
                    phi_1871_ = evaluate_Verdict(_e586, true);
                } else {
                    if (_e563 > 0.5f) {
                        phi_1869_ = 1f;
                    } else {
                        phi_1869_ = 0f;
                    }
                    let _e590 = phi_1869_;
                    phi_1871_ = evaluate_Verdict(_e590, false);
                }
                let _e593 = phi_1871_;
                let _e596 = (_e593.visibility < 0.5f);
                if _e593.is_doubted {
                    phi_1894_ = evaluate_Verdict();
                    phi_1895_ = true;
                } else {
                    if _e596 {
                        phi_1881_ = 2u;
                    } else {
                        phi_1881_ = 1u;
                    }
                    let _e598 = phi_1881_;
                    if ((0u & _e598) != 0u) {
                        if _e596 {
                            phi_1890_ = 0.000000059604645f;
                        } else {
                            phi_1890_ = 0.99999994f;
                        }
                        let _e602 = phi_1890_;
                        phi_1892_ = evaluate_Verdict(_e602, true);
                        phi_1893_ = false;
                    } else {
                        phi_1892_ = evaluate_Verdict();
                        phi_1893_ = true;
                    }
                    let _e605 = phi_1892_;
                    let _e607 = phi_1893_;
                    phi_1894_ = _e605;
                    phi_1895_ = _e607;
                }
                let _e609 = phi_1894_;
                let _e611 = phi_1895_;
                if _e611 {
                    phi_1900_ = evaluate_Verdict(_e593.visibility, _e593.is_doubted);
                } else {
                    phi_1900_ = _e609;
                }
                let _e614 = phi_1900_;
                phi_1905_ = evaluate_Verdict(_e614.visibility, _e614.is_doubted);
            } else {
                phi_1905_ = evaluate_Verdict(0.5f, true);
            }
            let _e620 = phi_1905_;
            phi_1906_ = _e620;
        }
        let _e622 = phi_1906_;
        if (_e67.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e67.first_primitive)] = _e622.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
