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

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_36 {
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
var<storage> levels: type_36;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_158_: lt_bvh_traverse_Tree;
    var phi_159_: bool;
    var phi_160_: lt_bvh_traverse_Tree;
    var phi_161_: bool;
    var phi_166_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_158_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_159_ = false;
        } else {
            phi_158_ = lt_bvh_traverse_Tree();
            phi_159_ = true;
        }
        let _e65 = phi_158_;
        let _e67 = phi_159_;
        phi_160_ = _e65;
        phi_161_ = _e67;
    } else {
        phi_160_ = lt_bvh_traverse_Tree();
        phi_161_ = true;
    }
    let _e69 = phi_160_;
    let _e71 = phi_161_;
    if _e71 {
        phi_166_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_166_ = _e69;
    }
    let _e76 = phi_166_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_346_: bool;
    var phi_350_: f32;
    var phi_369_: f32;
    var phi_374_: f32;
    var phi_396_: f32;
    var phi_401_: f32;
    var phi_402_: bool;
    var phi_403_: f32;
    var phi_404_: bool;
    var phi_408_: f32;
    var phi_446_: f32;
    var phi_457_: f32;
    var phi_462_: f32;
    var phi_484_: f32;
    var phi_489_: f32;
    var phi_490_: bool;
    var phi_491_: f32;
    var phi_492_: bool;
    var phi_496_: f32;
    var phi_534_: f32;
    var phi_545_: f32;
    var phi_550_: f32;
    var phi_572_: f32;
    var phi_577_: f32;
    var phi_578_: bool;
    var phi_579_: f32;
    var phi_580_: bool;
    var phi_584_: f32;
    var phi_622_: f32;
    var phi_633_: f32;
    var phi_638_: f32;
    var phi_660_: f32;
    var phi_665_: f32;
    var phi_666_: bool;
    var phi_667_: f32;
    var phi_668_: bool;
    var phi_672_: f32;
    var phi_710_: f32;
    var phi_763_: bool;
    var phi_767_: f32;
    var phi_779_: bool;
    var phi_786_: f32;
    var phi_799_: bool;
    var phi_803_: f32;
    var phi_823_: f32;
    var phi_828_: f32;
    var phi_850_: f32;
    var phi_855_: f32;
    var phi_856_: bool;
    var phi_857_: f32;
    var phi_858_: bool;
    var phi_862_: f32;
    var phi_900_: f32;
    var phi_911_: f32;
    var phi_916_: f32;
    var phi_938_: f32;
    var phi_943_: f32;
    var phi_944_: bool;
    var phi_945_: f32;
    var phi_946_: bool;
    var phi_950_: f32;
    var phi_988_: f32;
    var phi_999_: f32;
    var phi_1004_: f32;
    var phi_1026_: f32;
    var phi_1031_: f32;
    var phi_1032_: bool;
    var phi_1033_: f32;
    var phi_1034_: bool;
    var phi_1038_: f32;
    var phi_1076_: f32;
    var phi_1087_: f32;
    var phi_1092_: f32;
    var phi_1114_: f32;
    var phi_1119_: f32;
    var phi_1120_: bool;
    var phi_1121_: f32;
    var phi_1122_: bool;
    var phi_1126_: f32;
    var phi_1164_: f32;
    var phi_1217_: bool;
    var phi_1221_: f32;
    var phi_1233_: bool;
    var phi_1240_: f32;
    var phi_1251_: bool;
    var phi_1255_: f32;
    var phi_1270_: f32;
    var phi_1271_: f32;
    var phi_1272_: f32;

    let _e56 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_346_ = true;
    } else {
        let _e60 = (42f < _e56);
        if _e60 {
        }
        phi_346_ = _e60;
    }
    let _e62 = phi_346_;
    if _e62 {
        phi_350_ = 42f;
    } else {
        phi_350_ = _e56;
    }
    let _e64 = phi_350_;
    let _e66 = (_e64 * param_5.x);
    let _e68 = (_e64 * param_5.y);
    let _e70 = (_e64 * param_5.z);
    let _e72 = (_e64 * param_5.w);
    if ((bitcast<u32>(_e66) & 2147483647u) > 2139095040u) {
        phi_446_ = _e66;
    } else {
        if (_e66 < -87f) {
            phi_369_ = -87f;
        } else {
            phi_369_ = _e66;
        }
        let _e78 = phi_369_;
        if (_e78 > 88f) {
            phi_374_ = 88f;
        } else {
            phi_374_ = _e78;
        }
        let _e81 = phi_374_;
        let _e83 = ((_e81 * 1.442695f) + 0.5f);
        if (_e83 > -8388608f) {
            let _e95 = f32(select(0i, select(select(i32(_e83), i32(-2147483648), (_e83 < bitcast<f32>(3472883712u))), 2147483647i, (_e83 > bitcast<f32>(1325400063u))), (_e83 == _e83)));
            if (_e95 > _e83) {
                phi_396_ = 1f;
            } else {
                phi_396_ = 0f;
            }
            let _e98 = phi_396_;
            if (_e83 < 8388608f) {
                phi_401_ = (_e95 - _e98);
                phi_402_ = false;
            } else {
                phi_401_ = f32();
                phi_402_ = true;
            }
            let _e101 = phi_401_;
            let _e103 = phi_402_;
            phi_403_ = _e101;
            phi_404_ = _e103;
        } else {
            phi_403_ = f32();
            phi_404_ = true;
        }
        let _e105 = phi_403_;
        let _e107 = phi_404_;
        if _e107 {
            phi_408_ = _e83;
        } else {
            phi_408_ = _e105;
        }
        let _e109 = phi_408_;
        let _e113 = ((_e81 - (_e109 * 0.69314575f)) - (_e109 * 0.0000014286068f));
        phi_446_ = ((((((((((((((((1f / 5040f) * _e113) + (1f / 720f)) * _e113) + (1f / 120f)) * _e113) + (1f / 24f)) * _e113) + (1f / 6f)) * _e113) + 0.5f) * _e113) + 1f) * _e113) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e109), i32(-2147483648), (_e109 < bitcast<f32>(3472883712u))), 2147483647i, (_e109 > bitcast<f32>(1325400063u))), (_e109 == _e109)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e149 = phi_446_;
    if ((bitcast<u32>(_e68) & 2147483647u) > 2139095040u) {
        phi_534_ = _e68;
    } else {
        if (_e68 < -87f) {
            phi_457_ = -87f;
        } else {
            phi_457_ = _e68;
        }
        let _e155 = phi_457_;
        if (_e155 > 88f) {
            phi_462_ = 88f;
        } else {
            phi_462_ = _e155;
        }
        let _e158 = phi_462_;
        let _e160 = ((_e158 * 1.442695f) + 0.5f);
        if (_e160 > -8388608f) {
            let _e172 = f32(select(0i, select(select(i32(_e160), i32(-2147483648), (_e160 < bitcast<f32>(3472883712u))), 2147483647i, (_e160 > bitcast<f32>(1325400063u))), (_e160 == _e160)));
            if (_e172 > _e160) {
                phi_484_ = 1f;
            } else {
                phi_484_ = 0f;
            }
            let _e175 = phi_484_;
            if (_e160 < 8388608f) {
                phi_489_ = (_e172 - _e175);
                phi_490_ = false;
            } else {
                phi_489_ = f32();
                phi_490_ = true;
            }
            let _e178 = phi_489_;
            let _e180 = phi_490_;
            phi_491_ = _e178;
            phi_492_ = _e180;
        } else {
            phi_491_ = f32();
            phi_492_ = true;
        }
        let _e182 = phi_491_;
        let _e184 = phi_492_;
        if _e184 {
            phi_496_ = _e160;
        } else {
            phi_496_ = _e182;
        }
        let _e186 = phi_496_;
        let _e190 = ((_e158 - (_e186 * 0.69314575f)) - (_e186 * 0.0000014286068f));
        phi_534_ = ((((((((((((((((1f / 5040f) * _e190) + (1f / 720f)) * _e190) + (1f / 120f)) * _e190) + (1f / 24f)) * _e190) + (1f / 6f)) * _e190) + 0.5f) * _e190) + 1f) * _e190) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e186), i32(-2147483648), (_e186 < bitcast<f32>(3472883712u))), 2147483647i, (_e186 > bitcast<f32>(1325400063u))), (_e186 == _e186)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e226 = phi_534_;
    if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
        phi_622_ = _e70;
    } else {
        if (_e70 < -87f) {
            phi_545_ = -87f;
        } else {
            phi_545_ = _e70;
        }
        let _e232 = phi_545_;
        if (_e232 > 88f) {
            phi_550_ = 88f;
        } else {
            phi_550_ = _e232;
        }
        let _e235 = phi_550_;
        let _e237 = ((_e235 * 1.442695f) + 0.5f);
        if (_e237 > -8388608f) {
            let _e249 = f32(select(0i, select(select(i32(_e237), i32(-2147483648), (_e237 < bitcast<f32>(3472883712u))), 2147483647i, (_e237 > bitcast<f32>(1325400063u))), (_e237 == _e237)));
            if (_e249 > _e237) {
                phi_572_ = 1f;
            } else {
                phi_572_ = 0f;
            }
            let _e252 = phi_572_;
            if (_e237 < 8388608f) {
                phi_577_ = (_e249 - _e252);
                phi_578_ = false;
            } else {
                phi_577_ = f32();
                phi_578_ = true;
            }
            let _e255 = phi_577_;
            let _e257 = phi_578_;
            phi_579_ = _e255;
            phi_580_ = _e257;
        } else {
            phi_579_ = f32();
            phi_580_ = true;
        }
        let _e259 = phi_579_;
        let _e261 = phi_580_;
        if _e261 {
            phi_584_ = _e237;
        } else {
            phi_584_ = _e259;
        }
        let _e263 = phi_584_;
        let _e267 = ((_e235 - (_e263 * 0.69314575f)) - (_e263 * 0.0000014286068f));
        phi_622_ = ((((((((((((((((1f / 5040f) * _e267) + (1f / 720f)) * _e267) + (1f / 120f)) * _e267) + (1f / 24f)) * _e267) + (1f / 6f)) * _e267) + 0.5f) * _e267) + 1f) * _e267) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e263), i32(-2147483648), (_e263 < bitcast<f32>(3472883712u))), 2147483647i, (_e263 > bitcast<f32>(1325400063u))), (_e263 == _e263)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e303 = phi_622_;
    if ((bitcast<u32>(_e72) & 2147483647u) > 2139095040u) {
        phi_710_ = _e72;
    } else {
        if (_e72 < -87f) {
            phi_633_ = -87f;
        } else {
            phi_633_ = _e72;
        }
        let _e309 = phi_633_;
        if (_e309 > 88f) {
            phi_638_ = 88f;
        } else {
            phi_638_ = _e309;
        }
        let _e312 = phi_638_;
        let _e314 = ((_e312 * 1.442695f) + 0.5f);
        if (_e314 > -8388608f) {
            let _e326 = f32(select(0i, select(select(i32(_e314), i32(-2147483648), (_e314 < bitcast<f32>(3472883712u))), 2147483647i, (_e314 > bitcast<f32>(1325400063u))), (_e314 == _e314)));
            if (_e326 > _e314) {
                phi_660_ = 1f;
            } else {
                phi_660_ = 0f;
            }
            let _e329 = phi_660_;
            if (_e314 < 8388608f) {
                phi_665_ = (_e326 - _e329);
                phi_666_ = false;
            } else {
                phi_665_ = f32();
                phi_666_ = true;
            }
            let _e332 = phi_665_;
            let _e334 = phi_666_;
            phi_667_ = _e332;
            phi_668_ = _e334;
        } else {
            phi_667_ = f32();
            phi_668_ = true;
        }
        let _e336 = phi_667_;
        let _e338 = phi_668_;
        if _e338 {
            phi_672_ = _e314;
        } else {
            phi_672_ = _e336;
        }
        let _e340 = phi_672_;
        let _e344 = ((_e312 - (_e340 * 0.69314575f)) - (_e340 * 0.0000014286068f));
        phi_710_ = ((((((((((((((((1f / 5040f) * _e344) + (1f / 720f)) * _e344) + (1f / 120f)) * _e344) + (1f / 24f)) * _e344) + (1f / 6f)) * _e344) + 0.5f) * _e344) + 1f) * _e344) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e340), i32(-2147483648), (_e340 < bitcast<f32>(3472883712u))), 2147483647i, (_e340 > bitcast<f32>(1325400063u))), (_e340 == _e340)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e380 = phi_710_;
    let _e382 = (_e149 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e384 = (_e226 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e386 = (_e303 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e388 = (_e380 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e390 = (*param_4).min_variance;
    let _e392 = ((_e390 * _e64) * _e64);
    let _e403 = ((((_e382 * param_6.x) + (_e384 * param_6.y)) + (_e386 * param_6.z)) + (_e388 * param_6.w));
    let _e404 = (_e382 - _e403);
    let _e405 = (_e384 - _e403);
    let _e406 = (_e386 - _e403);
    let _e407 = (_e388 - _e403);
    let _e422 = (((((_e404 * _e404) * param_6.x) + ((_e405 * _e405) * param_6.y)) + ((_e406 * _e406) * param_6.z)) + ((_e407 * _e407) * param_6.w));
    if ((bitcast<u32>(_e392) & 2147483647u) > 2139095040u) {
        phi_763_ = true;
    } else {
        let _e426 = (_e392 > _e422);
        if _e426 {
        }
        phi_763_ = _e426;
    }
    let _e428 = phi_763_;
    if _e428 {
        phi_767_ = _e392;
    } else {
        phi_767_ = _e422;
    }
    let _e430 = phi_767_;
    let _e431 = -(_e403);
    if (_e431 <= 0f) {
        let _e435 = ((bitcast<u32>(_e430) & 2147483647u) > 2139095040u);
        if _e435 {
        }
        phi_779_ = _e435;
    } else {
        phi_779_ = true;
    }
    let _e437 = phi_779_;
    if _e437 {
        phi_786_ = (_e430 / (_e430 + (_e431 * _e431)));
    } else {
        phi_786_ = 1f;
    }
    let _e442 = phi_786_;
    let _e444 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_799_ = true;
    } else {
        let _e448 = (42f < _e444);
        if _e448 {
        }
        phi_799_ = _e448;
    }
    let _e450 = phi_799_;
    if _e450 {
        phi_803_ = 42f;
    } else {
        phi_803_ = _e444;
    }
    let _e452 = phi_803_;
    let _e453 = -(_e452);
    let _e455 = (_e453 * param_5.x);
    let _e457 = (_e453 * param_5.y);
    let _e459 = (_e453 * param_5.z);
    let _e461 = (_e453 * param_5.w);
    if ((bitcast<u32>(_e455) & 2147483647u) > 2139095040u) {
        phi_900_ = _e455;
    } else {
        if (_e455 < -87f) {
            phi_823_ = -87f;
        } else {
            phi_823_ = _e455;
        }
        let _e467 = phi_823_;
        if (_e467 > 88f) {
            phi_828_ = 88f;
        } else {
            phi_828_ = _e467;
        }
        let _e470 = phi_828_;
        let _e472 = ((_e470 * 1.442695f) + 0.5f);
        if (_e472 > -8388608f) {
            let _e484 = f32(select(0i, select(select(i32(_e472), i32(-2147483648), (_e472 < bitcast<f32>(3472883712u))), 2147483647i, (_e472 > bitcast<f32>(1325400063u))), (_e472 == _e472)));
            if (_e484 > _e472) {
                phi_850_ = 1f;
            } else {
                phi_850_ = 0f;
            }
            let _e487 = phi_850_;
            if (_e472 < 8388608f) {
                phi_855_ = (_e484 - _e487);
                phi_856_ = false;
            } else {
                phi_855_ = f32();
                phi_856_ = true;
            }
            let _e490 = phi_855_;
            let _e492 = phi_856_;
            phi_857_ = _e490;
            phi_858_ = _e492;
        } else {
            phi_857_ = f32();
            phi_858_ = true;
        }
        let _e494 = phi_857_;
        let _e496 = phi_858_;
        if _e496 {
            phi_862_ = _e472;
        } else {
            phi_862_ = _e494;
        }
        let _e498 = phi_862_;
        let _e502 = ((_e470 - (_e498 * 0.69314575f)) - (_e498 * 0.0000014286068f));
        phi_900_ = ((((((((((((((((1f / 5040f) * _e502) + (1f / 720f)) * _e502) + (1f / 120f)) * _e502) + (1f / 24f)) * _e502) + (1f / 6f)) * _e502) + 0.5f) * _e502) + 1f) * _e502) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e498), i32(-2147483648), (_e498 < bitcast<f32>(3472883712u))), 2147483647i, (_e498 > bitcast<f32>(1325400063u))), (_e498 == _e498)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e538 = phi_900_;
    if ((bitcast<u32>(_e457) & 2147483647u) > 2139095040u) {
        phi_988_ = _e457;
    } else {
        if (_e457 < -87f) {
            phi_911_ = -87f;
        } else {
            phi_911_ = _e457;
        }
        let _e544 = phi_911_;
        if (_e544 > 88f) {
            phi_916_ = 88f;
        } else {
            phi_916_ = _e544;
        }
        let _e547 = phi_916_;
        let _e549 = ((_e547 * 1.442695f) + 0.5f);
        if (_e549 > -8388608f) {
            let _e561 = f32(select(0i, select(select(i32(_e549), i32(-2147483648), (_e549 < bitcast<f32>(3472883712u))), 2147483647i, (_e549 > bitcast<f32>(1325400063u))), (_e549 == _e549)));
            if (_e561 > _e549) {
                phi_938_ = 1f;
            } else {
                phi_938_ = 0f;
            }
            let _e564 = phi_938_;
            if (_e549 < 8388608f) {
                phi_943_ = (_e561 - _e564);
                phi_944_ = false;
            } else {
                phi_943_ = f32();
                phi_944_ = true;
            }
            let _e567 = phi_943_;
            let _e569 = phi_944_;
            phi_945_ = _e567;
            phi_946_ = _e569;
        } else {
            phi_945_ = f32();
            phi_946_ = true;
        }
        let _e571 = phi_945_;
        let _e573 = phi_946_;
        if _e573 {
            phi_950_ = _e549;
        } else {
            phi_950_ = _e571;
        }
        let _e575 = phi_950_;
        let _e579 = ((_e547 - (_e575 * 0.69314575f)) - (_e575 * 0.0000014286068f));
        phi_988_ = ((((((((((((((((1f / 5040f) * _e579) + (1f / 720f)) * _e579) + (1f / 120f)) * _e579) + (1f / 24f)) * _e579) + (1f / 6f)) * _e579) + 0.5f) * _e579) + 1f) * _e579) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e575), i32(-2147483648), (_e575 < bitcast<f32>(3472883712u))), 2147483647i, (_e575 > bitcast<f32>(1325400063u))), (_e575 == _e575)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e615 = phi_988_;
    if ((bitcast<u32>(_e459) & 2147483647u) > 2139095040u) {
        phi_1076_ = _e459;
    } else {
        if (_e459 < -87f) {
            phi_999_ = -87f;
        } else {
            phi_999_ = _e459;
        }
        let _e621 = phi_999_;
        if (_e621 > 88f) {
            phi_1004_ = 88f;
        } else {
            phi_1004_ = _e621;
        }
        let _e624 = phi_1004_;
        let _e626 = ((_e624 * 1.442695f) + 0.5f);
        if (_e626 > -8388608f) {
            let _e638 = f32(select(0i, select(select(i32(_e626), i32(-2147483648), (_e626 < bitcast<f32>(3472883712u))), 2147483647i, (_e626 > bitcast<f32>(1325400063u))), (_e626 == _e626)));
            if (_e638 > _e626) {
                phi_1026_ = 1f;
            } else {
                phi_1026_ = 0f;
            }
            let _e641 = phi_1026_;
            if (_e626 < 8388608f) {
                phi_1031_ = (_e638 - _e641);
                phi_1032_ = false;
            } else {
                phi_1031_ = f32();
                phi_1032_ = true;
            }
            let _e644 = phi_1031_;
            let _e646 = phi_1032_;
            phi_1033_ = _e644;
            phi_1034_ = _e646;
        } else {
            phi_1033_ = f32();
            phi_1034_ = true;
        }
        let _e648 = phi_1033_;
        let _e650 = phi_1034_;
        if _e650 {
            phi_1038_ = _e626;
        } else {
            phi_1038_ = _e648;
        }
        let _e652 = phi_1038_;
        let _e656 = ((_e624 - (_e652 * 0.69314575f)) - (_e652 * 0.0000014286068f));
        phi_1076_ = ((((((((((((((((1f / 5040f) * _e656) + (1f / 720f)) * _e656) + (1f / 120f)) * _e656) + (1f / 24f)) * _e656) + (1f / 6f)) * _e656) + 0.5f) * _e656) + 1f) * _e656) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e652), i32(-2147483648), (_e652 < bitcast<f32>(3472883712u))), 2147483647i, (_e652 > bitcast<f32>(1325400063u))), (_e652 == _e652)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e692 = phi_1076_;
    if ((bitcast<u32>(_e461) & 2147483647u) > 2139095040u) {
        phi_1164_ = _e461;
    } else {
        if (_e461 < -87f) {
            phi_1087_ = -87f;
        } else {
            phi_1087_ = _e461;
        }
        let _e698 = phi_1087_;
        if (_e698 > 88f) {
            phi_1092_ = 88f;
        } else {
            phi_1092_ = _e698;
        }
        let _e701 = phi_1092_;
        let _e703 = ((_e701 * 1.442695f) + 0.5f);
        if (_e703 > -8388608f) {
            let _e715 = f32(select(0i, select(select(i32(_e703), i32(-2147483648), (_e703 < bitcast<f32>(3472883712u))), 2147483647i, (_e703 > bitcast<f32>(1325400063u))), (_e703 == _e703)));
            if (_e715 > _e703) {
                phi_1114_ = 1f;
            } else {
                phi_1114_ = 0f;
            }
            let _e718 = phi_1114_;
            if (_e703 < 8388608f) {
                phi_1119_ = (_e715 - _e718);
                phi_1120_ = false;
            } else {
                phi_1119_ = f32();
                phi_1120_ = true;
            }
            let _e721 = phi_1119_;
            let _e723 = phi_1120_;
            phi_1121_ = _e721;
            phi_1122_ = _e723;
        } else {
            phi_1121_ = f32();
            phi_1122_ = true;
        }
        let _e725 = phi_1121_;
        let _e727 = phi_1122_;
        if _e727 {
            phi_1126_ = _e703;
        } else {
            phi_1126_ = _e725;
        }
        let _e729 = phi_1126_;
        let _e733 = ((_e701 - (_e729 * 0.69314575f)) - (_e729 * 0.0000014286068f));
        phi_1164_ = ((((((((((((((((1f / 5040f) * _e733) + (1f / 720f)) * _e733) + (1f / 120f)) * _e733) + (1f / 24f)) * _e733) + (1f / 6f)) * _e733) + 0.5f) * _e733) + 1f) * _e733) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e729), i32(-2147483648), (_e729 < bitcast<f32>(3472883712u))), 2147483647i, (_e729 > bitcast<f32>(1325400063u))), (_e729 == _e729)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e769 = phi_1164_;
    let _e771 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e538);
    let _e773 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e615);
    let _e775 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e692);
    let _e777 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e769);
    let _e779 = (*param_4).min_variance;
    let _e781 = ((_e779 * _e452) * _e452);
    let _e792 = ((((_e771 * param_6.x) + (_e773 * param_6.y)) + (_e775 * param_6.z)) + (_e777 * param_6.w));
    let _e793 = (_e771 - _e792);
    let _e794 = (_e773 - _e792);
    let _e795 = (_e775 - _e792);
    let _e796 = (_e777 - _e792);
    let _e811 = (((((_e793 * _e793) * param_6.x) + ((_e794 * _e794) * param_6.y)) + ((_e795 * _e795) * param_6.z)) + ((_e796 * _e796) * param_6.w));
    if ((bitcast<u32>(_e781) & 2147483647u) > 2139095040u) {
        phi_1217_ = true;
    } else {
        let _e815 = (_e781 > _e811);
        if _e815 {
        }
        phi_1217_ = _e815;
    }
    let _e817 = phi_1217_;
    if _e817 {
        phi_1221_ = _e781;
    } else {
        phi_1221_ = _e811;
    }
    let _e819 = phi_1221_;
    let _e820 = -(_e792);
    if (_e820 <= 0f) {
        let _e824 = ((bitcast<u32>(_e819) & 2147483647u) > 2139095040u);
        if _e824 {
        }
        phi_1233_ = _e824;
    } else {
        phi_1233_ = true;
    }
    let _e826 = phi_1233_;
    if _e826 {
        phi_1240_ = (_e819 / (_e819 + (_e820 * _e820)));
    } else {
        phi_1240_ = 1f;
    }
    let _e831 = phi_1240_;
    if ((bitcast<u32>(_e831) & 2147483647u) > 2139095040u) {
        phi_1251_ = true;
    } else {
        let _e835 = (_e831 < _e442);
        if _e835 {
        }
        phi_1251_ = _e835;
    }
    let _e837 = phi_1251_;
    if _e837 {
        phi_1255_ = _e831;
    } else {
        phi_1255_ = _e442;
    }
    let _e839 = phi_1255_;
    if ((bitcast<u32>(_e839) & 2147483647u) > 2139095040u) {
        phi_1272_ = _e839;
    } else {
        if (_e839 < 0f) {
            phi_1271_ = 0f;
        } else {
            if (_e839 > 1f) {
                phi_1270_ = 1f;
            } else {
                phi_1270_ = _e839;
            }
            let _e846 = phi_1270_;
            phi_1271_ = _e846;
        }
        let _e848 = phi_1271_;
        phi_1272_ = _e848;
    }
    let _e850 = phi_1272_;
    return _e850;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_195_: f32;
    var phi_196_: f32;
    var phi_197_: f32;
    var phi_213_: f32;
    var phi_214_: f32;
    var phi_215_: f32;
    var phi_231_: f32;
    var phi_232_: f32;
    var phi_233_: f32;
    var phi_249_: f32;
    var phi_250_: f32;
    var phi_251_: f32;
    var phi_267_: f32;
    var phi_268_: f32;
    var phi_269_: f32;
    var phi_306_: bool;
    var phi_307_: bool;
    var phi_308_: bool;
    var phi_309_: bool;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_314_: bool;
    var phi_315_: bool;
    var phi_316_: bool;
    var phi_320_: bool;
    var phi_324_: bool;
    var phi_329_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_197_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_196_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_195_ = 1f;
            } else {
                phi_195_ = param_10;
            }
            let _e62 = phi_195_;
            phi_196_ = _e62;
        }
        let _e64 = phi_196_;
        phi_197_ = _e64;
    }
    let _e66 = phi_197_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_215_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_214_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_213_ = 1f;
            } else {
                phi_213_ = param_8.x;
            }
            let _e74 = phi_213_;
            phi_214_ = _e74;
        }
        let _e76 = phi_214_;
        phi_215_ = _e76;
    }
    let _e78 = phi_215_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_233_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_232_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_231_ = 1f;
            } else {
                phi_231_ = param_8.y;
            }
            let _e86 = phi_231_;
            phi_232_ = _e86;
        }
        let _e88 = phi_232_;
        phi_233_ = _e88;
    }
    let _e90 = phi_233_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_251_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_250_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_249_ = 1f;
            } else {
                phi_249_ = param_8.z;
            }
            let _e98 = phi_249_;
            phi_250_ = _e98;
        }
        let _e100 = phi_250_;
        phi_251_ = _e100;
    }
    let _e102 = phi_251_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_269_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_268_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_267_ = 1f;
            } else {
                phi_267_ = param_8.w;
            }
            let _e110 = phi_267_;
            phi_268_ = _e110;
        }
        let _e112 = phi_268_;
        phi_269_ = _e112;
    }
    let _e114 = phi_269_;
    let _e115 = (_e78 - _e66);
    let _e116 = (_e90 - _e66);
    let _e117 = (_e102 - _e66);
    let _e118 = (_e114 - _e66);
    if (_e115 >= 0f) {
        if (_e116 >= 0f) {
            if (_e117 >= 0f) {
                if (_e118 >= 0f) {
                    phi_306_ = !(((bitcast<u32>(((((_e115 * param_9.x) + (_e116 * param_9.y)) + (_e117 * param_9.z)) + (_e118 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_307_ = false;
                } else {
                    phi_306_ = bool();
                    phi_307_ = true;
                }
                let _e140 = phi_306_;
                let _e142 = phi_307_;
                phi_308_ = _e140;
                phi_309_ = false;
                phi_310_ = _e142;
            } else {
                phi_308_ = bool();
                phi_309_ = true;
                phi_310_ = false;
            }
            let _e144 = phi_308_;
            let _e146 = phi_309_;
            let _e148 = phi_310_;
            phi_311_ = _e144;
            phi_312_ = _e146;
            phi_313_ = _e148;
        } else {
            phi_311_ = bool();
            phi_312_ = true;
            phi_313_ = false;
        }
        let _e150 = phi_311_;
        let _e152 = phi_312_;
        let _e154 = phi_313_;
        phi_314_ = _e150;
        phi_315_ = _e152;
        phi_316_ = _e154;
    } else {
        phi_314_ = bool();
        phi_315_ = true;
        phi_316_ = false;
    }
    let _e156 = phi_314_;
    let _e158 = phi_315_;
    let _e160 = phi_316_;
    if _e158 {
        phi_320_ = true;
    } else {
        phi_320_ = _e160;
    }
    let _e162 = phi_320_;
    if _e162 {
        phi_324_ = false;
    } else {
        phi_324_ = _e156;
    }
    let _e164 = phi_324_;
    if _e164 {
        phi_329_ = 1f;
    } else {
        let _e165 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e115, _e116, _e117, _e118), param_9);
        phi_329_ = _e165;
    }
    let _e167 = phi_329_;
    return _e167;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_1333_: bool;
    var phi_1334_: bool;
    var phi_1335_: bool;
    var phi_1336_: bool;
    var phi_1340_: bool;
    var phi_1384_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1388_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1408_: lt_math_LightPoint;
    var phi_1411_: u32;
    var phi_1413_: lt_math_LevelPoint;
    var phi_1499_: bool;
    var phi_1508_: bool;
    var phi_1517_: bool;
    var phi_1518_: bool;
    var phi_1519_: bool;
    var phi_1520_: bool;
    var phi_1521_: bool;
    var phi_1522_: bool;
    var phi_1523_: bool;
    var phi_1527_: bool;
    var phi_1554_: bool;
    var phi_1555_: bool;
    var phi_1556_: bool;
    var phi_1557_: bool;
    var phi_1558_: bool;
    var phi_1559_: bool;
    var phi_1560_: bool;
    var phi_1561_: bool;
    var phi_1565_: bool;
    var phi_1574_: lt_math_LightPoint;
    var phi_1575_: u32;
    var phi_1576_: lt_math_LevelPoint;
    var phi_1577_: bool;
    var phi_1409_: lt_math_LightPoint;
    var phi_1412_: u32;
    var phi_1414_: lt_math_LevelPoint;
    var phi_1578_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1618_: bool;
    var phi_1619_: bool;
    var phi_1620_: bool;
    var phi_1621_: bool;
    var phi_1625_: bool;
    var phi_1707_: f32;
    var phi_1823_: f32;
    var phi_1824_: f32;
    var phi_1827_: f32;
    var phi_1856_: f32;
    var phi_1861_: f32;
    var phi_1862_: bool;
    var phi_1863_: f32;
    var phi_1864_: bool;
    var phi_1868_: f32;
    var phi_1888_: f32;
    var phi_1893_: f32;
    var phi_1894_: bool;
    var phi_1895_: f32;
    var phi_1896_: bool;
    var phi_1900_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1953_: i32;
    var phi_1958_: i32;
    var phi_1963_: i32;
    var phi_1968_: i32;
    var phi_1977_: i32;
    var phi_1982_: i32;
    var phi_1987_: i32;
    var phi_1992_: i32;
    var phi_2043_: bool;
    var phi_2051_: bool;
    var phi_2063_: bool;
    var phi_2064_: bool;
    var phi_2068_: f32;
    var phi_2074_: f32;
    var phi_2076_: evaluate_Verdict;
    var phi_2081_: evaluate_Verdict;
    var phi_2082_: evaluate_Verdict;

    let _e53 = id_1;
    let _e60 = arrayLength((&map.member));
    let _e66 = arrayLength((&levels.member));
    let _e69 = p.member.size[0u];
    let _e71 = p.member.size[1u];
    let _e72 = lt_shaders_entry_pixel_index(_e53, _e69, _e71);
    if (bitcast<i32>(_e72.root) != 0i) {
        let _e78 = p.member.level_count;
        if (_e72.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e83 = p.member.light;
        let _e86 = samples.member[(0u + _e72.first_primitive)].normal[0u];
        let _e88 = global[0u];
        if (_e86 == _e88) {
            let _e91 = samples.member[(0u + _e72.first_primitive)].normal[1u];
            let _e93 = global[1u];
            if (_e91 == _e93) {
                let _e96 = samples.member[(0u + _e72.first_primitive)].normal[2u];
                let _e98 = global[2u];
                phi_1333_ = (_e96 == _e98);
                phi_1334_ = false;
            } else {
                phi_1333_ = bool();
                phi_1334_ = true;
            }
            let _e101 = phi_1333_;
            let _e103 = phi_1334_;
            phi_1335_ = _e101;
            phi_1336_ = _e103;
        } else {
            phi_1335_ = bool();
            phi_1336_ = true;
        }
        let _e105 = phi_1335_;
        let _e107 = phi_1336_;
        if _e107 {
            phi_1340_ = false;
        } else {
            phi_1340_ = _e105;
        }
        let _e109 = phi_1340_;
        if !(_e109) {
            let _e112 = samples.member[(0u + _e72.first_primitive)].normal;
            let _e114 = samples.member[(0u + _e72.first_primitive)].position;
            if ((((_e112.x * (_e83.x - (_e114.x * _e83.w))) + (_e112.y * (_e83.y - (_e114.y * _e83.w)))) + (_e112.z * (_e83.z - (_e114.z * _e83.w)))) > 0f) {
                let _e138 = samples.member[(0u + _e72.first_primitive)].flags;
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e152 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e146.unnamed.visibility, false), _e146.unnamed_1);
                phi_1384_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e152.unnamed, ((_e138 & 1u) == 0u));
            } else {
                let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e161.unnamed.visibility, false), _e161.unnamed_1);
                phi_1384_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e167.unnamed, true);
            }
            let _e172 = phi_1384_;
            phi_1388_ = _e172;
        } else {
            let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e178.unnamed.visibility, false), _e178.unnamed_1);
            phi_1388_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e184.unnamed, true);
        }
        let _e189 = phi_1388_;
        if _e189.unnamed_1 {
            phi_2082_ = evaluate_Verdict(_e189.unnamed.visibility, _e189.unnamed.is_doubted);
        } else {
            let _e197 = samples.member[(0u + _e72.first_primitive)].position;
            let _e199 = p.member.map_size;
            let _e201 = (0.5f / f32(_e199));
            let _e208 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e215 = lt_math_LightPoint(vec2<f32>(_e208.uv.x, 0f), _e208.depth, _e208.is_inside);
            let _e219 = lt_math_LightPoint(_e215.uv, 0f, _e215.is_inside);
            phi_1408_ = lt_math_LightPoint();
            phi_1411_ = 0u;
            phi_1413_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e219.uv, _e219.depth, false));
            loop {
                let _e226 = phi_1408_;
                let _e228 = phi_1411_;
                let _e230 = phi_1413_;
                local_1 = _e230;
                local_2 = _e230;
                local_3 = _e230;
                if (_e228 < _e78) {
                    if _e230.point.is_inside {
                        phi_1574_ = lt_math_LightPoint();
                        phi_1575_ = u32();
                        phi_1576_ = lt_math_LevelPoint();
                        phi_1577_ = false;
                    } else {
                        if (_e228 < _e66) {
                        } else {
                            return;
                        }
                        let _e241 = levels.member[(0u + _e228)].row_w;
                        let _e252 = ((((_e241.x * _e197.x) + (_e241.y * _e197.y)) + (_e241.z * _e197.z)) + (_e241.w * 1f));
                        let _e254 = levels.member[(0u + _e228)].row_x;
                        let _e266 = (((((_e254.x * _e197.x) + (_e254.y * _e197.y)) + (_e254.z * _e197.z)) + (_e254.w * 1f)) / _e252);
                        let _e268 = levels.member[(0u + _e228)].row_y;
                        let _e280 = (((((_e268.x * _e197.x) + (_e268.y * _e197.y)) + (_e268.z * _e197.z)) + (_e268.w * 1f)) / _e252);
                        let _e282 = levels.member[(0u + _e228)].row_z;
                        let _e293 = ((((_e282.x * _e197.x) + (_e282.y * _e197.y)) + (_e282.z * _e197.z)) + (_e282.w * 1f));
                        if (_e252 > 0f) {
                            if (_e266 >= 0f) {
                                phi_1499_ = (_e266 <= 1f);
                            } else {
                                phi_1499_ = false;
                            }
                            let _e298 = phi_1499_;
                            if _e298 {
                                if (_e280 >= 0f) {
                                    phi_1508_ = (_e280 <= 1f);
                                } else {
                                    phi_1508_ = false;
                                }
                                let _e302 = phi_1508_;
                                if _e302 {
                                    if (_e293 >= 0f) {
                                        phi_1517_ = (_e293 <= 1f);
                                    } else {
                                        phi_1517_ = false;
                                    }
                                    let _e306 = phi_1517_;
                                    phi_1518_ = _e306;
                                    phi_1519_ = false;
                                } else {
                                    phi_1518_ = bool();
                                    phi_1519_ = true;
                                }
                                let _e308 = phi_1518_;
                                let _e310 = phi_1519_;
                                phi_1520_ = _e308;
                                phi_1521_ = _e310;
                            } else {
                                phi_1520_ = bool();
                                phi_1521_ = true;
                            }
                            let _e312 = phi_1520_;
                            let _e314 = phi_1521_;
                            phi_1522_ = _e312;
                            phi_1523_ = _e314;
                        } else {
                            phi_1522_ = bool();
                            phi_1523_ = true;
                        }
                        let _e316 = phi_1522_;
                        let _e318 = phi_1523_;
                        if _e318 {
                            phi_1527_ = false;
                        } else {
                            phi_1527_ = _e316;
                        }
                        let _e320 = phi_1527_;
                        if _e320 {
                            if (_e266 >= _e201) {
                                if (_e266 <= (1f - _e201)) {
                                    if (_e280 >= _e201) {
                                        phi_1554_ = (_e280 <= (1f - _e201));
                                        phi_1555_ = false;
                                    } else {
                                        phi_1554_ = bool();
                                        phi_1555_ = true;
                                    }
                                    let _e328 = phi_1554_;
                                    let _e330 = phi_1555_;
                                    phi_1556_ = _e328;
                                    phi_1557_ = _e330;
                                } else {
                                    phi_1556_ = bool();
                                    phi_1557_ = true;
                                }
                                let _e332 = phi_1556_;
                                let _e334 = phi_1557_;
                                phi_1558_ = _e332;
                                phi_1559_ = _e334;
                            } else {
                                phi_1558_ = bool();
                                phi_1559_ = true;
                            }
                            let _e336 = phi_1558_;
                            let _e338 = phi_1559_;
                            phi_1560_ = _e336;
                            phi_1561_ = _e338;
                        } else {
                            phi_1560_ = bool();
                            phi_1561_ = true;
                        }
                        let _e340 = phi_1560_;
                        let _e342 = phi_1561_;
                        if _e342 {
                            phi_1565_ = false;
                        } else {
                            phi_1565_ = _e340;
                        }
                        let _e344 = phi_1565_;
                        let _e351 = lt_math_LightPoint(vec2<f32>(_e266, _e226.uv.y), _e226.depth, _e226.is_inside);
                        let _e358 = lt_math_LightPoint(vec2<f32>(_e351.uv.x, _e280), _e351.depth, _e351.is_inside);
                        let _e362 = lt_math_LightPoint(_e358.uv, _e293, _e358.is_inside);
                        let _e366 = lt_math_LightPoint(_e362.uv, _e362.depth, _e344);
                        phi_1574_ = _e366;
                        phi_1575_ = (_e228 + 1u);
                        phi_1576_ = lt_math_LevelPoint(_e228, _e366);
                        phi_1577_ = true;
                    }
                    let _e370 = phi_1574_;
                    let _e372 = phi_1575_;
                    let _e374 = phi_1576_;
                    let _e376 = phi_1577_;
                    phi_1409_ = _e370;
                    phi_1412_ = _e372;
                    phi_1414_ = _e374;
                    phi_1578_ = _e376;
                } else {
                    phi_1409_ = lt_math_LightPoint();
                    phi_1412_ = u32();
                    phi_1414_ = lt_math_LevelPoint();
                    phi_1578_ = false;
                }
                let _e378 = phi_1409_;
                let _e380 = phi_1412_;
                let _e382 = phi_1414_;
                let _e384 = phi_1578_;
                continue;
                continuing {
                    phi_1408_ = _e378;
                    phi_1411_ = _e380;
                    phi_1413_ = _e382;
                    break if !(_e384);
                }
            }
            let _e387 = local_1;
            if _e387.point.is_inside {
                if (0f > 0f) {
                    let _e393 = local_2;
                    if (_e393.level < _e66) {
                    } else {
                        return;
                    }
                    let _e398 = levels.member[(0u + _e393.level)];
                    let _e404 = global[0u];
                    if (_e398.row_w.x == _e404) {
                        let _e407 = global[1u];
                        if (_e398.row_w.y == _e407) {
                            let _e410 = global[2u];
                            phi_1618_ = (_e398.row_w.z == _e410);
                            phi_1619_ = false;
                        } else {
                            phi_1618_ = bool();
                            phi_1619_ = true;
                        }
                        let _e413 = phi_1618_;
                        let _e415 = phi_1619_;
                        phi_1620_ = _e413;
                        phi_1621_ = _e415;
                    } else {
                        phi_1620_ = bool();
                        phi_1621_ = true;
                    }
                    let _e417 = phi_1620_;
                    let _e419 = phi_1621_;
                    if _e419 {
                        phi_1625_ = false;
                    } else {
                        phi_1625_ = _e417;
                    }
                    let _e421 = phi_1625_;
                    if _e421 {
                        let _e423 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e425 = p.member.map_size;
                        let _e495 = ((abs(((((_e398.row_x.x * _e423.x) + (_e398.row_x.y * _e423.y)) + (_e398.row_x.z * _e423.z)) / (((_e398.row_x.x * _e398.row_x.x) + (_e398.row_x.y * _e398.row_x.y)) + (_e398.row_x.z * _e398.row_x.z)))) + abs(((((_e398.row_y.x * _e423.x) + (_e398.row_y.y * _e423.y)) + (_e398.row_y.z * _e423.z)) / (((_e398.row_y.x * _e398.row_y.x) + (_e398.row_y.y * _e398.row_y.y)) + (_e398.row_y.z * _e398.row_y.z))))) / (abs(((((_e398.row_z.x * _e423.x) + (_e398.row_z.y * _e423.y)) + (_e398.row_z.z * _e423.z)) / (((_e398.row_z.x * _e398.row_z.x) + (_e398.row_z.y * _e398.row_z.y)) + (_e398.row_z.z * _e398.row_z.z)))) * f32(_e425)));
                        if (_e495 < 0.002f) {
                            phi_1707_ = _e495;
                        } else {
                            phi_1707_ = 0.002f;
                        }
                        let _e498 = phi_1707_;
                        phi_1824_ = _e498;
                    } else {
                        let _e500 = p.member.map_size;
                        let _e506 = samples.member[(0u + _e72.first_primitive)].position;
                        let _e517 = ((((_e398.row_w.x * _e506.x) + (_e398.row_w.y * _e506.y)) + (_e398.row_w.z * _e506.z)) + _e398.row_w.w);
                        let _e530 = ((_e398.row_x.x - (_e398.row_w.x * _e387.point.uv.x)) / _e517);
                        let _e531 = ((_e398.row_x.y - (_e398.row_w.y * _e387.point.uv.x)) / _e517);
                        let _e532 = ((_e398.row_x.z - (_e398.row_w.z * _e387.point.uv.x)) / _e517);
                        let _e545 = ((_e398.row_y.x - (_e398.row_w.x * _e387.point.uv.y)) / _e517);
                        let _e546 = ((_e398.row_y.y - (_e398.row_w.y * _e387.point.uv.y)) / _e517);
                        let _e547 = ((_e398.row_y.z - (_e398.row_w.z * _e387.point.uv.y)) / _e517);
                        let _e553 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e558 = ((_e546 * _e553.z) - (_e553.y * _e547));
                        let _e563 = ((_e547 * _e553.x) - (_e553.z * _e545));
                        let _e568 = ((_e545 * _e553.y) - (_e553.x * _e546));
                        let _e570 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e575 = ((_e531 * _e570.z) - (_e570.y * _e532));
                        let _e580 = ((_e532 * _e570.x) - (_e570.z * _e530));
                        let _e585 = ((_e530 * _e570.y) - (_e570.x * _e531));
                        let _e612 = ((abs(((((_e398.row_z.x * _e558) + (_e398.row_z.y * _e563)) + (_e398.row_z.z * _e568)) / (((_e530 * _e558) + (_e531 * _e563)) + (_e532 * _e568)))) + abs(((((_e398.row_z.x * _e575) + (_e398.row_z.y * _e580)) + (_e398.row_z.z * _e585)) / (((_e545 * _e575) + (_e546 * _e580)) + (_e547 * _e585))))) / f32(_e500));
                        if (_e612 < 0.002f) {
                            phi_1823_ = _e612;
                        } else {
                            phi_1823_ = 0.002f;
                        }
                        let _e615 = phi_1823_;
                        phi_1824_ = _e615;
                    }
                    let _e617 = phi_1824_;
                    phi_1827_ = (_e387.point.depth - (0f * _e617));
                } else {
                    phi_1827_ = _e387.point.depth;
                }
                let _e621 = phi_1827_;
                let _e627 = p.member.map_size;
                let _e628 = f32(_e627);
                let _e631 = ((_e387.point.uv.x * _e628) - 0.5f);
                let _e632 = ((_e387.point.uv.y * _e628) - 0.5f);
                if (_e631 > -8388608f) {
                    let _e644 = f32(select(0i, select(select(i32(_e631), i32(-2147483648), (_e631 < bitcast<f32>(3472883712u))), 2147483647i, (_e631 > bitcast<f32>(1325400063u))), (_e631 == _e631)));
                    if (_e644 > _e631) {
                        phi_1856_ = 1f;
                    } else {
                        phi_1856_ = 0f;
                    }
                    let _e647 = phi_1856_;
                    if (_e631 < 8388608f) {
                        phi_1861_ = (_e644 - _e647);
                        phi_1862_ = false;
                    } else {
                        phi_1861_ = f32();
                        phi_1862_ = true;
                    }
                    let _e650 = phi_1861_;
                    let _e652 = phi_1862_;
                    phi_1863_ = _e650;
                    phi_1864_ = _e652;
                } else {
                    phi_1863_ = f32();
                    phi_1864_ = true;
                }
                let _e654 = phi_1863_;
                let _e656 = phi_1864_;
                if _e656 {
                    phi_1868_ = _e631;
                } else {
                    phi_1868_ = _e654;
                }
                let _e658 = phi_1868_;
                if (_e632 > -8388608f) {
                    let _e670 = f32(select(0i, select(select(i32(_e632), i32(-2147483648), (_e632 < bitcast<f32>(3472883712u))), 2147483647i, (_e632 > bitcast<f32>(1325400063u))), (_e632 == _e632)));
                    if (_e670 > _e632) {
                        phi_1888_ = 1f;
                    } else {
                        phi_1888_ = 0f;
                    }
                    let _e673 = phi_1888_;
                    if (_e632 < 8388608f) {
                        phi_1893_ = (_e670 - _e673);
                        phi_1894_ = false;
                    } else {
                        phi_1893_ = f32();
                        phi_1894_ = true;
                    }
                    let _e676 = phi_1893_;
                    let _e678 = phi_1894_;
                    phi_1895_ = _e676;
                    phi_1896_ = _e678;
                } else {
                    phi_1895_ = f32();
                    phi_1896_ = true;
                }
                let _e680 = phi_1895_;
                let _e682 = phi_1896_;
                if _e682 {
                    phi_1900_ = _e632;
                } else {
                    phi_1900_ = _e680;
                }
                let _e684 = phi_1900_;
                let _e685 = (_e631 - _e658);
                let _e686 = (_e632 - _e684);
                let _e695 = select(0i, select(select(i32(_e658), i32(-2147483648), (_e658 < bitcast<f32>(3472883712u))), 2147483647i, (_e658 > bitcast<f32>(1325400063u))), (_e658 == _e658));
                let _e704 = select(0i, select(select(i32(_e684), i32(-2147483648), (_e684 < bitcast<f32>(3472883712u))), 2147483647i, (_e684 > bitcast<f32>(1325400063u))), (_e684 == _e684));
                let _e715 = p.member.test;
                let _e716 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e715);
                let _e718 = p.member.map_size;
                let _e720 = local_3;
                local = lt_math_Evsm(_e716.positive_exponent, _e716.negative_exponent, _e716.min_variance);
                let _e727 = ((_e720.level * _e718) * _e718);
                let _e729 = (bitcast<i32>(_e718) - 1i);
                if (_e695 > 0i) {
                    phi_1953_ = _e695;
                } else {
                    phi_1953_ = 0i;
                }
                let _e732 = phi_1953_;
                if (_e704 > 0i) {
                    phi_1958_ = _e704;
                } else {
                    phi_1958_ = 0i;
                }
                let _e735 = phi_1958_;
                if (_e732 < _e729) {
                    phi_1963_ = _e732;
                } else {
                    phi_1963_ = _e729;
                }
                let _e738 = phi_1963_;
                if (_e735 < _e729) {
                    phi_1968_ = _e735;
                } else {
                    phi_1968_ = _e729;
                }
                let _e741 = phi_1968_;
                let _e742 = bitcast<u32>(_e738);
                let _e744 = (_e695 + 1i);
                let _e745 = (_e704 + 1i);
                if (_e744 > 0i) {
                    phi_1977_ = _e744;
                } else {
                    phi_1977_ = 0i;
                }
                let _e748 = phi_1977_;
                if (_e745 > 0i) {
                    phi_1982_ = _e745;
                } else {
                    phi_1982_ = 0i;
                }
                let _e751 = phi_1982_;
                if (_e748 < _e729) {
                    phi_1987_ = _e748;
                } else {
                    phi_1987_ = _e729;
                }
                let _e754 = phi_1987_;
                if (_e751 < _e729) {
                    phi_1992_ = _e751;
                } else {
                    phi_1992_ = _e729;
                }
                let _e757 = phi_1992_;
                let _e758 = bitcast<u32>(_e754);
                let _e760 = (bitcast<u32>(_e741) * _e718);
                let _e761 = (bitcast<u32>(_e757) * _e718);
                let _e766 = ((_e760 + _e742) + _e727);
                let _e767 = ((_e760 + _e758) + _e727);
                let _e768 = ((_e761 + _e742) + _e727);
                let _e769 = ((_e761 + _e758) + _e727);
                if (_e766 < _e60) {
                } else {
                    return;
                }
                let _e773 = map.member[(0u + _e766)];
                if (_e767 < _e60) {
                } else {
                    return;
                }
                let _e777 = map.member[(0u + _e767)];
                if (_e768 < _e60) {
                } else {
                    return;
                }
                let _e781 = map.member[(0u + _e768)];
                if (_e769 < _e60) {
                } else {
                    return;
                }
                let _e785 = map.member[(0u + _e769)];
                let _e787 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e773, _e777, _e781, _e785), vec4<f32>(((1f - _e685) * (1f - _e686)), (_e685 * (1f - _e686)), ((1f - _e685) * _e686), (_e685 * _e686)), _e621);
                let _e789 = p.member.epsilon;
                if (_e787 <= _e789) {
                    phi_2043_ = true;
                } else {
                    phi_2043_ = (_e787 >= (1f - _e789));
                }
                let _e794 = phi_2043_;
                if ((bitcast<u32>(_e787) & 2147483647u) > 2139095040u) {
                    phi_2051_ = true;
                } else {
                    phi_2051_ = !(_e794);
                }
                let _e800 = phi_2051_;
                if _e800 {
                    if (_e787 > 0f) {
                        if (_e787 < 1f) {
                            phi_2063_ = false;
                        } else {
                            phi_2063_ = true;
                        }
                        let _e804 = phi_2063_;
                        phi_2064_ = _e804;
                    } else {
                        phi_2064_ = true;
                    }
                    let _e806 = phi_2064_;
                    if _e806 {
                        phi_2068_ = 0.5f;
                    } else {
                        phi_2068_ = _e787;
                    }
                    let _e808 = phi_2068_;
                    phi_2076_ = evaluate_Verdict(_e808, true);
                } else {
                    if (_e787 > 0.5f) {
                        phi_2074_ = 1f;
                    } else {
                        phi_2074_ = 0f;
                    }
                    let _e812 = phi_2074_;
                    phi_2076_ = evaluate_Verdict(_e812, false);
                }
                let _e815 = phi_2076_;
                phi_2081_ = evaluate_Verdict(_e815.visibility, _e815.is_doubted);
            } else {
                phi_2081_ = evaluate_Verdict(0.5f, true);
            }
            let _e821 = phi_2081_;
            phi_2082_ = _e821;
        }
        let _e823 = phi_2082_;
        if (_e72.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e72.first_primitive)] = _e823.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
