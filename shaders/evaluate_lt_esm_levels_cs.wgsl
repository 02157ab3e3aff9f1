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

struct type_31 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_37 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> map: type_19;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(4) 
var<storage> levels: type_37;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_156_: lt_bvh_traverse_Tree;
    var phi_157_: bool;
    var phi_158_: lt_bvh_traverse_Tree;
    var phi_159_: bool;
    var phi_164_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_156_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_157_ = false;
        } else {
            phi_156_ = lt_bvh_traverse_Tree();
            phi_157_ = true;
        }
        let _e65 = phi_156_;
        let _e67 = phi_157_;
        phi_158_ = _e65;
        phi_159_ = _e67;
    } else {
        phi_158_ = lt_bvh_traverse_Tree();
        phi_159_ = true;
    }
    let _e69 = phi_158_;
    let _e71 = phi_159_;
    if _e71 {
        phi_164_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_164_ = _e69;
    }
    let _e76 = phi_164_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_187_: bool;
    var phi_191_: f32;
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

    let _e56 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_187_ = true;
    } else {
        let _e60 = (84f < _e56);
        if _e60 {
        }
        phi_187_ = _e60;
    }
    let _e62 = phi_187_;
    if _e62 {
        phi_191_ = 84f;
    } else {
        phi_191_ = _e56;
    }
    let _e64 = phi_191_;
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_208_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_207_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_206_ = 1f;
            } else {
                phi_206_ = param_7;
            }
            let _e71 = phi_206_;
            phi_207_ = _e71;
        }
        let _e73 = phi_207_;
        phi_208_ = _e73;
    }
    let _e75 = phi_208_;
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
            let _e83 = phi_224_;
            phi_225_ = _e83;
        }
        let _e85 = phi_225_;
        phi_226_ = _e85;
    }
    let _e87 = phi_226_;
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
            let _e95 = phi_242_;
            phi_243_ = _e95;
        }
        let _e97 = phi_243_;
        phi_244_ = _e97;
    }
    let _e99 = phi_244_;
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
            let _e107 = phi_260_;
            phi_261_ = _e107;
        }
        let _e109 = phi_261_;
        phi_262_ = _e109;
    }
    let _e111 = phi_262_;
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
            let _e119 = phi_278_;
            phi_279_ = _e119;
        }
        let _e121 = phi_279_;
        phi_280_ = _e121;
    }
    let _e123 = phi_280_;
    let _e128 = (_e64 * (_e87 - _e75));
    let _e129 = (_e64 * (_e99 - _e75));
    let _e130 = (_e64 * (_e111 - _e75));
    let _e131 = (_e64 * (_e123 - _e75));
    if ((bitcast<u32>(_e128) & 2147483647u) > 2139095040u) {
        phi_376_ = _e128;
    } else {
        if (_e128 < -87f) {
            phi_299_ = -87f;
        } else {
            phi_299_ = _e128;
        }
        let _e137 = phi_299_;
        if (_e137 > 88f) {
            phi_304_ = 88f;
        } else {
            phi_304_ = _e137;
        }
        let _e140 = phi_304_;
        let _e142 = ((_e140 * 1.442695f) + 0.5f);
        if (_e142 > -8388608f) {
            let _e154 = f32(select(0i, select(select(i32(_e142), i32(-2147483648), (_e142 < bitcast<f32>(3472883712u))), 2147483647i, (_e142 > bitcast<f32>(1325400063u))), (_e142 == _e142)));
            if (_e154 > _e142) {
                phi_326_ = 1f;
            } else {
                phi_326_ = 0f;
            }
            let _e157 = phi_326_;
            if (_e142 < 8388608f) {
                phi_331_ = (_e154 - _e157);
                phi_332_ = false;
            } else {
                phi_331_ = f32();
                phi_332_ = true;
            }
            let _e160 = phi_331_;
            let _e162 = phi_332_;
            phi_333_ = _e160;
            phi_334_ = _e162;
        } else {
            phi_333_ = f32();
            phi_334_ = true;
        }
        let _e164 = phi_333_;
        let _e166 = phi_334_;
        if _e166 {
            phi_338_ = _e142;
        } else {
            phi_338_ = _e164;
        }
        let _e168 = phi_338_;
        let _e172 = ((_e140 - (_e168 * 0.69314575f)) - (_e168 * 0.0000014286068f));
        phi_376_ = ((((((((((((((((1f / 5040f) * _e172) + (1f / 720f)) * _e172) + (1f / 120f)) * _e172) + (1f / 24f)) * _e172) + (1f / 6f)) * _e172) + 0.5f) * _e172) + 1f) * _e172) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e168), i32(-2147483648), (_e168 < bitcast<f32>(3472883712u))), 2147483647i, (_e168 > bitcast<f32>(1325400063u))), (_e168 == _e168)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e208 = phi_376_;
    if ((bitcast<u32>(_e129) & 2147483647u) > 2139095040u) {
        phi_464_ = _e129;
    } else {
        if (_e129 < -87f) {
            phi_387_ = -87f;
        } else {
            phi_387_ = _e129;
        }
        let _e214 = phi_387_;
        if (_e214 > 88f) {
            phi_392_ = 88f;
        } else {
            phi_392_ = _e214;
        }
        let _e217 = phi_392_;
        let _e219 = ((_e217 * 1.442695f) + 0.5f);
        if (_e219 > -8388608f) {
            let _e231 = f32(select(0i, select(select(i32(_e219), i32(-2147483648), (_e219 < bitcast<f32>(3472883712u))), 2147483647i, (_e219 > bitcast<f32>(1325400063u))), (_e219 == _e219)));
            if (_e231 > _e219) {
                phi_414_ = 1f;
            } else {
                phi_414_ = 0f;
            }
            let _e234 = phi_414_;
            if (_e219 < 8388608f) {
                phi_419_ = (_e231 - _e234);
                phi_420_ = false;
            } else {
                phi_419_ = f32();
                phi_420_ = true;
            }
            let _e237 = phi_419_;
            let _e239 = phi_420_;
            phi_421_ = _e237;
            phi_422_ = _e239;
        } else {
            phi_421_ = f32();
            phi_422_ = true;
        }
        let _e241 = phi_421_;
        let _e243 = phi_422_;
        if _e243 {
            phi_426_ = _e219;
        } else {
            phi_426_ = _e241;
        }
        let _e245 = phi_426_;
        let _e249 = ((_e217 - (_e245 * 0.69314575f)) - (_e245 * 0.0000014286068f));
        phi_464_ = ((((((((((((((((1f / 5040f) * _e249) + (1f / 720f)) * _e249) + (1f / 120f)) * _e249) + (1f / 24f)) * _e249) + (1f / 6f)) * _e249) + 0.5f) * _e249) + 1f) * _e249) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e245), i32(-2147483648), (_e245 < bitcast<f32>(3472883712u))), 2147483647i, (_e245 > bitcast<f32>(1325400063u))), (_e245 == _e245)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e285 = phi_464_;
    if ((bitcast<u32>(_e130) & 2147483647u) > 2139095040u) {
        phi_552_ = _e130;
    } else {
        if (_e130 < -87f) {
            phi_475_ = -87f;
        } else {
            phi_475_ = _e130;
        }
        let _e291 = phi_475_;
        if (_e291 > 88f) {
            phi_480_ = 88f;
        } else {
            phi_480_ = _e291;
        }
        let _e294 = phi_480_;
        let _e296 = ((_e294 * 1.442695f) + 0.5f);
        if (_e296 > -8388608f) {
            let _e308 = f32(select(0i, select(select(i32(_e296), i32(-2147483648), (_e296 < bitcast<f32>(3472883712u))), 2147483647i, (_e296 > bitcast<f32>(1325400063u))), (_e296 == _e296)));
            if (_e308 > _e296) {
                phi_502_ = 1f;
            } else {
                phi_502_ = 0f;
            }
            let _e311 = phi_502_;
            if (_e296 < 8388608f) {
                phi_507_ = (_e308 - _e311);
                phi_508_ = false;
            } else {
                phi_507_ = f32();
                phi_508_ = true;
            }
            let _e314 = phi_507_;
            let _e316 = phi_508_;
            phi_509_ = _e314;
            phi_510_ = _e316;
        } else {
            phi_509_ = f32();
            phi_510_ = true;
        }
        let _e318 = phi_509_;
        let _e320 = phi_510_;
        if _e320 {
            phi_514_ = _e296;
        } else {
            phi_514_ = _e318;
        }
        let _e322 = phi_514_;
        let _e326 = ((_e294 - (_e322 * 0.69314575f)) - (_e322 * 0.0000014286068f));
        phi_552_ = ((((((((((((((((1f / 5040f) * _e326) + (1f / 720f)) * _e326) + (1f / 120f)) * _e326) + (1f / 24f)) * _e326) + (1f / 6f)) * _e326) + 0.5f) * _e326) + 1f) * _e326) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e322), i32(-2147483648), (_e322 < bitcast<f32>(3472883712u))), 2147483647i, (_e322 > bitcast<f32>(1325400063u))), (_e322 == _e322)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e362 = phi_552_;
    if ((bitcast<u32>(_e131) & 2147483647u) > 2139095040u) {
        phi_640_ = _e131;
    } else {
        if (_e131 < -87f) {
            phi_563_ = -87f;
        } else {
            phi_563_ = _e131;
        }
        let _e368 = phi_563_;
        if (_e368 > 88f) {
            phi_568_ = 88f;
        } else {
            phi_568_ = _e368;
        }
        let _e371 = phi_568_;
        let _e373 = ((_e371 * 1.442695f) + 0.5f);
        if (_e373 > -8388608f) {
            let _e385 = f32(select(0i, select(select(i32(_e373), i32(-2147483648), (_e373 < bitcast<f32>(3472883712u))), 2147483647i, (_e373 > bitcast<f32>(1325400063u))), (_e373 == _e373)));
            if (_e385 > _e373) {
                phi_590_ = 1f;
            } else {
                phi_590_ = 0f;
            }
            let _e388 = phi_590_;
            if (_e373 < 8388608f) {
                phi_595_ = (_e385 - _e388);
                phi_596_ = false;
            } else {
                phi_595_ = f32();
                phi_596_ = true;
            }
            let _e391 = phi_595_;
            let _e393 = phi_596_;
            phi_597_ = _e391;
            phi_598_ = _e393;
        } else {
            phi_597_ = f32();
            phi_598_ = true;
        }
        let _e395 = phi_597_;
        let _e397 = phi_598_;
        if _e397 {
            phi_602_ = _e373;
        } else {
            phi_602_ = _e395;
        }
        let _e399 = phi_602_;
        let _e403 = ((_e371 - (_e399 * 0.69314575f)) - (_e399 * 0.0000014286068f));
        phi_640_ = ((((((((((((((((1f / 5040f) * _e403) + (1f / 720f)) * _e403) + (1f / 120f)) * _e403) + (1f / 24f)) * _e403) + (1f / 6f)) * _e403) + 0.5f) * _e403) + 1f) * _e403) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e399), i32(-2147483648), (_e399 < bitcast<f32>(3472883712u))), 2147483647i, (_e399 > bitcast<f32>(1325400063u))), (_e399 == _e399)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e439 = phi_640_;
    let _e450 = ((((_e208 * param_6.x) + (_e285 * param_6.y)) + (_e362 * param_6.z)) + (_e439 * param_6.w));
    if ((bitcast<u32>(_e450) & 2147483647u) > 2139095040u) {
        phi_668_ = _e450;
    } else {
        if (_e450 < 0f) {
            phi_667_ = 0f;
        } else {
            if (_e450 > 1f) {
                phi_666_ = 1f;
            } else {
                phi_666_ = _e450;
            }
            let _e457 = phi_666_;
            phi_667_ = _e457;
        }
        let _e459 = phi_667_;
        phi_668_ = _e459;
    }
    let _e461 = phi_668_;
    return _e461;
}

fn function_() {
    var local: f32;
    var phi_728_: bool;
    var phi_729_: bool;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_735_: bool;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_817_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_818_: bool;
    var phi_819_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_820_: bool;
    var phi_827_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_831_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_851_: lt_math_LightPoint;
    var phi_854_: u32;
    var phi_856_: lt_math_LevelPoint;
    var phi_942_: bool;
    var phi_951_: bool;
    var phi_960_: bool;
    var phi_961_: bool;
    var phi_962_: bool;
    var phi_963_: bool;
    var phi_964_: bool;
    var phi_965_: bool;
    var phi_966_: bool;
    var phi_970_: bool;
    var phi_997_: bool;
    var phi_998_: bool;
    var phi_999_: bool;
    var phi_1000_: bool;
    var phi_1001_: bool;
    var phi_1002_: bool;
    var phi_1003_: bool;
    var phi_1004_: bool;
    var phi_1008_: bool;
    var phi_1017_: lt_math_LightPoint;
    var phi_1018_: u32;
    var phi_1019_: lt_math_LevelPoint;
    var phi_1020_: bool;
    var phi_852_: lt_math_LightPoint;
    var phi_855_: u32;
    var phi_857_: lt_math_LevelPoint;
    var phi_1021_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1061_: bool;
    var phi_1062_: bool;
    var phi_1063_: bool;
    var phi_1064_: bool;
    var phi_1068_: bool;
    var phi_1150_: f32;
    var phi_1268_: f32;
    var phi_1269_: f32;
    var phi_1272_: f32;
    var phi_1301_: f32;
    var phi_1306_: f32;
    var phi_1307_: bool;
    var phi_1308_: f32;
    var phi_1309_: bool;
    var phi_1313_: f32;
    var phi_1333_: f32;
    var phi_1338_: f32;
    var phi_1339_: bool;
    var phi_1340_: f32;
    var phi_1341_: bool;
    var phi_1345_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1394_: i32;
    var phi_1399_: i32;
    var phi_1404_: i32;
    var phi_1409_: i32;
    var phi_1418_: i32;
    var phi_1423_: i32;
    var phi_1428_: i32;
    var phi_1433_: i32;
    var phi_1484_: bool;
    var phi_1492_: bool;
    var phi_1504_: bool;
    var phi_1505_: bool;
    var phi_1509_: f32;
    var phi_1515_: f32;
    var phi_1517_: evaluate_Verdict;
    var phi_1522_: evaluate_Verdict;
    var phi_1523_: evaluate_Verdict;

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
        let _e85 = samples.member[(0u + _e72.first_primitive)].normal[0u];
        let _e87 = global[0u];
        if (_e85 == _e87) {
            let _e90 = samples.member[(0u + _e72.first_primitive)].normal[1u];
            let _e92 = global[1u];
            if (_e90 == _e92) {
                let _e95 = samples.member[(0u + _e72.first_primitive)].normal[2u];
                let _e97 = global[2u];
                phi_728_ = (_e95 == _e97);
                phi_729_ = false;
            } else {
                phi_728_ = bool();
                phi_729_ = true;
            }
            let _e100 = phi_728_;
            let _e102 = phi_729_;
            phi_730_ = _e100;
            phi_731_ = _e102;
        } else {
            phi_730_ = bool();
            phi_731_ = true;
        }
        let _e104 = phi_730_;
        let _e106 = phi_731_;
        if _e106 {
            phi_735_ = false;
        } else {
            phi_735_ = _e104;
        }
        let _e108 = phi_735_;
        if !(_e108) {
            let _e111 = samples.member[(0u + _e72.first_primitive)].position;
            let _e113 = p.member.light.place;
            let _e119 = p.member.light.place[3u];
            let _e126 = (_e113.x - (_e111.x * _e119));
            let _e127 = (_e113.y - (_e111.y * _e119));
            let _e128 = (_e113.z - (_e111.z * _e119));
            let _e130 = samples.member[(0u + _e72.first_primitive)].normal;
            if ((((_e130.x * _e126) + (_e130.y * _e127)) + (_e130.z * _e128)) > 0f) {
                let _e144 = (((_e126 * _e126) + (_e127 * _e127)) + (_e128 * _e128));
                let _e146 = p.member.light.axis;
                let _e158 = p.member.light.place[3u];
                if (_e158 == 0f) {
                    phi_806_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_805_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_805_ = false;
                    }
                    let _e169 = phi_805_;
                    phi_806_ = _e169;
                }
                let _e171 = phi_806_;
                if _e171 {
                    let _e173 = samples.member[(0u + _e72.first_primitive)].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_817_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_818_ = false;
                } else {
                    phi_817_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_818_ = true;
                }
                let _e192 = phi_817_;
                let _e194 = phi_818_;
                phi_819_ = _e192;
                phi_820_ = _e194;
            } else {
                phi_819_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_820_ = true;
            }
            let _e196 = phi_819_;
            let _e198 = phi_820_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_827_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_827_ = _e196;
            }
            let _e215 = phi_827_;
            phi_831_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_831_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_831_;
        if _e232.unnamed_1 {
            phi_1523_ = evaluate_Verdict(_e232.unnamed.visibility, _e232.unnamed.is_doubted);
        } else {
            let _e240 = samples.member[(0u + _e72.first_primitive)].position;
            let _e242 = p.member.map_size;
            let _e244 = (0.5f / f32(_e242));
            let _e251 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e258 = lt_math_LightPoint(vec2<f32>(_e251.uv.x, 0f), _e251.depth, _e251.is_inside);
            let _e262 = lt_math_LightPoint(_e258.uv, 0f, _e258.is_inside);
            phi_851_ = lt_math_LightPoint();
            phi_854_ = 0u;
            phi_856_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e262.uv, _e262.depth, false));
            loop {
                let _e269 = phi_851_;
                let _e271 = phi_854_;
                let _e273 = phi_856_;
                local_1 = _e273;
                local_2 = _e273;
                local_3 = _e273;
                if (_e271 < _e78) {
                    if _e273.point.is_inside {
                        phi_1017_ = lt_math_LightPoint();
                        phi_1018_ = u32();
                        phi_1019_ = lt_math_LevelPoint();
                        phi_1020_ = false;
                    } else {
                        if (_e271 < _e66) {
                        } else {
                            return;
                        }
                        let _e284 = levels.member[(0u + _e271)].row_w;
                        let _e295 = ((((_e284.x * _e240.x) + (_e284.y * _e240.y)) + (_e284.z * _e240.z)) + (_e284.w * 1f));
                        let _e297 = levels.member[(0u + _e271)].row_x;
                        let _e309 = (((((_e297.x * _e240.x) + (_e297.y * _e240.y)) + (_e297.z * _e240.z)) + (_e297.w * 1f)) / _e295);
                        let _e311 = levels.member[(0u + _e271)].row_y;
                        let _e323 = (((((_e311.x * _e240.x) + (_e311.y * _e240.y)) + (_e311.z * _e240.z)) + (_e311.w * 1f)) / _e295);
                        let _e325 = levels.member[(0u + _e271)].row_z;
                        let _e336 = ((((_e325.x * _e240.x) + (_e325.y * _e240.y)) + (_e325.z * _e240.z)) + (_e325.w * 1f));
                        if (_e295 > 0f) {
                            if (_e309 >= 0f) {
                                phi_942_ = (_e309 <= 1f);
                            } else {
                                phi_942_ = false;
                            }
                            let _e341 = phi_942_;
                            if _e341 {
                                if (_e323 >= 0f) {
                                    phi_951_ = (_e323 <= 1f);
                                } else {
                                    phi_951_ = false;
                                }
                                let _e345 = phi_951_;
                                if _e345 {
                                    if (_e336 >= 0f) {
                                        phi_960_ = (_e336 <= 1f);
                                    } else {
                                        phi_960_ = false;
                                    }
                                    let _e349 = phi_960_;
                                    phi_961_ = _e349;
                                    phi_962_ = false;
                                } else {
                                    phi_961_ = bool();
                                    phi_962_ = true;
                                }
                                let _e351 = phi_961_;
                                let _e353 = phi_962_;
                                phi_963_ = _e351;
                                phi_964_ = _e353;
                            } else {
                                phi_963_ = bool();
                                phi_964_ = true;
                            }
                            let _e355 = phi_963_;
                            let _e357 = phi_964_;
                            phi_965_ = _e355;
                            phi_966_ = _e357;
                        } else {
                            phi_965_ = bool();
                            phi_966_ = true;
                        }
                        let _e359 = phi_965_;
                        let _e361 = phi_966_;
                        if _e361 {
                            phi_970_ = false;
                        } else {
                            phi_970_ = _e359;
                        }
                        let _e363 = phi_970_;
                        if _e363 {
                            if (_e309 >= _e244) {
                                if (_e309 <= (1f - _e244)) {
                                    if (_e323 >= _e244) {
                                        phi_997_ = (_e323 <= (1f - _e244));
                                        phi_998_ = false;
                                    } else {
                                        phi_997_ = bool();
                                        phi_998_ = true;
                                    }
                                    let _e371 = phi_997_;
                                    let _e373 = phi_998_;
                                    phi_999_ = _e371;
                                    phi_1000_ = _e373;
                                } else {
                                    phi_999_ = bool();
                                    phi_1000_ = true;
                                }
                                let _e375 = phi_999_;
                                let _e377 = phi_1000_;
                                phi_1001_ = _e375;
                                phi_1002_ = _e377;
                            } else {
                                phi_1001_ = bool();
                                phi_1002_ = true;
                            }
                            let _e379 = phi_1001_;
                            let _e381 = phi_1002_;
                            phi_1003_ = _e379;
                            phi_1004_ = _e381;
                        } else {
                            phi_1003_ = bool();
                            phi_1004_ = true;
                        }
                        let _e383 = phi_1003_;
                        let _e385 = phi_1004_;
                        if _e385 {
                            phi_1008_ = false;
                        } else {
                            phi_1008_ = _e383;
                        }
                        let _e387 = phi_1008_;
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e309, _e269.uv.y), _e269.depth, _e269.is_inside);
                        let _e401 = lt_math_LightPoint(vec2<f32>(_e394.uv.x, _e323), _e394.depth, _e394.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e336, _e401.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e405.depth, _e387);
                        phi_1017_ = _e409;
                        phi_1018_ = (_e271 + 1u);
                        phi_1019_ = lt_math_LevelPoint(_e271, _e409);
                        phi_1020_ = true;
                    }
                    let _e413 = phi_1017_;
                    let _e415 = phi_1018_;
                    let _e417 = phi_1019_;
                    let _e419 = phi_1020_;
                    phi_852_ = _e413;
                    phi_855_ = _e415;
                    phi_857_ = _e417;
                    phi_1021_ = _e419;
                } else {
                    phi_852_ = lt_math_LightPoint();
                    phi_855_ = u32();
                    phi_857_ = lt_math_LevelPoint();
                    phi_1021_ = false;
                }
                let _e421 = phi_852_;
                let _e423 = phi_855_;
                let _e425 = phi_857_;
                let _e427 = phi_1021_;
                continue;
                continuing {
                    phi_851_ = _e421;
                    phi_854_ = _e423;
                    phi_856_ = _e425;
                    break if !(_e427);
                }
            }
            let _e430 = local_1;
            if _e430.point.is_inside {
                if (0f > 0f) {
                    let _e436 = local_2;
                    if (_e436.level < _e66) {
                    } else {
                        return;
                    }
                    let _e441 = levels.member[(0u + _e436.level)];
                    let _e447 = global[0u];
                    if (_e441.row_w.x == _e447) {
                        let _e450 = global[1u];
                        if (_e441.row_w.y == _e450) {
                            let _e453 = global[2u];
                            phi_1061_ = (_e441.row_w.z == _e453);
                            phi_1062_ = false;
                        } else {
                            phi_1061_ = bool();
                            phi_1062_ = true;
                        }
                        let _e456 = phi_1061_;
                        let _e458 = phi_1062_;
                        phi_1063_ = _e456;
                        phi_1064_ = _e458;
                    } else {
                        phi_1063_ = bool();
                        phi_1064_ = true;
                    }
                    let _e460 = phi_1063_;
                    let _e462 = phi_1064_;
                    if _e462 {
                        phi_1068_ = false;
                    } else {
                        phi_1068_ = _e460;
                    }
                    let _e464 = phi_1068_;
                    if _e464 {
                        let _e466 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e468 = p.member.map_size;
                        let _e538 = ((abs(((((_e441.row_x.x * _e466.x) + (_e441.row_x.y * _e466.y)) + (_e441.row_x.z * _e466.z)) / (((_e441.row_x.x * _e441.row_x.x) + (_e441.row_x.y * _e441.row_x.y)) + (_e441.row_x.z * _e441.row_x.z)))) + abs(((((_e441.row_y.x * _e466.x) + (_e441.row_y.y * _e466.y)) + (_e441.row_y.z * _e466.z)) / (((_e441.row_y.x * _e441.row_y.x) + (_e441.row_y.y * _e441.row_y.y)) + (_e441.row_y.z * _e441.row_y.z))))) / (abs(((((_e441.row_z.x * _e466.x) + (_e441.row_z.y * _e466.y)) + (_e441.row_z.z * _e466.z)) / (((_e441.row_z.x * _e441.row_z.x) + (_e441.row_z.y * _e441.row_z.y)) + (_e441.row_z.z * _e441.row_z.z)))) * f32(_e468)));
                        if (_e538 < 0.002f) {
                            phi_1150_ = _e538;
                        } else {
                            phi_1150_ = 0.002f;
                        }
                        let _e541 = phi_1150_;
                        phi_1269_ = _e541;
                    } else {
                        let _e543 = p.member.map_size;
                        let _e549 = samples.member[(0u + _e72.first_primitive)].position;
                        let _e560 = ((((_e441.row_w.x * _e549.x) + (_e441.row_w.y * _e549.y)) + (_e441.row_w.z * _e549.z)) + _e441.row_w.w);
                        let _e573 = ((_e441.row_x.x - (_e441.row_w.x * _e430.point.uv.x)) / _e560);
                        let _e574 = ((_e441.row_x.y - (_e441.row_w.y * _e430.point.uv.x)) / _e560);
                        let _e575 = ((_e441.row_x.z - (_e441.row_w.z * _e430.point.uv.x)) / _e560);
                        let _e588 = ((_e441.row_y.x - (_e441.row_w.x * _e430.point.uv.y)) / _e560);
                        let _e589 = ((_e441.row_y.y - (_e441.row_w.y * _e430.point.uv.y)) / _e560);
                        let _e590 = ((_e441.row_y.z - (_e441.row_w.z * _e430.point.uv.y)) / _e560);
                        let _e596 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e601 = ((_e589 * _e596.z) - (_e596.y * _e590));
                        let _e606 = ((_e590 * _e596.x) - (_e596.z * _e588));
                        let _e611 = ((_e588 * _e596.y) - (_e596.x * _e589));
                        let _e613 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e618 = ((_e574 * _e613.z) - (_e613.y * _e575));
                        let _e623 = ((_e575 * _e613.x) - (_e613.z * _e573));
                        let _e628 = ((_e573 * _e613.y) - (_e613.x * _e574));
                        let _e655 = ((abs(((((_e441.row_z.x * _e601) + (_e441.row_z.y * _e606)) + (_e441.row_z.z * _e611)) / (((_e573 * _e601) + (_e574 * _e606)) + (_e575 * _e611)))) + abs(((((_e441.row_z.x * _e618) + (_e441.row_z.y * _e623)) + (_e441.row_z.z * _e628)) / (((_e588 * _e618) + (_e589 * _e623)) + (_e590 * _e628))))) / f32(_e543));
                        let _e657 = (16f / f32(_e543));
                        if (_e655 < _e657) {
                            phi_1268_ = _e655;
                        } else {
                            phi_1268_ = _e657;
                        }
                        let _e660 = phi_1268_;
                        phi_1269_ = _e660;
                    }
                    let _e662 = phi_1269_;
                    phi_1272_ = (_e430.point.depth - (0f * _e662));
                } else {
                    phi_1272_ = _e430.point.depth;
                }
                let _e666 = phi_1272_;
                let _e672 = p.member.map_size;
                let _e673 = f32(_e672);
                let _e676 = ((_e430.point.uv.x * _e673) - 0.5f);
                let _e677 = ((_e430.point.uv.y * _e673) - 0.5f);
                if (_e676 > -8388608f) {
                    let _e689 = f32(select(0i, select(select(i32(_e676), i32(-2147483648), (_e676 < bitcast<f32>(3472883712u))), 2147483647i, (_e676 > bitcast<f32>(1325400063u))), (_e676 == _e676)));
                    if (_e689 > _e676) {
                        phi_1301_ = 1f;
                    } else {
                        phi_1301_ = 0f;
                    }
                    let _e692 = phi_1301_;
                    if (_e676 < 8388608f) {
                        phi_1306_ = (_e689 - _e692);
                        phi_1307_ = false;
                    } else {
                        phi_1306_ = f32();
                        phi_1307_ = true;
                    }
                    let _e695 = phi_1306_;
                    let _e697 = phi_1307_;
                    phi_1308_ = _e695;
                    phi_1309_ = _e697;
                } else {
                    phi_1308_ = f32();
                    phi_1309_ = true;
                }
                let _e699 = phi_1308_;
                let _e701 = phi_1309_;
                if _e701 {
                    phi_1313_ = _e676;
                } else {
                    phi_1313_ = _e699;
                }
                let _e703 = phi_1313_;
                if (_e677 > -8388608f) {
                    let _e715 = f32(select(0i, select(select(i32(_e677), i32(-2147483648), (_e677 < bitcast<f32>(3472883712u))), 2147483647i, (_e677 > bitcast<f32>(1325400063u))), (_e677 == _e677)));
                    if (_e715 > _e677) {
                        phi_1333_ = 1f;
                    } else {
                        phi_1333_ = 0f;
                    }
                    let _e718 = phi_1333_;
                    if (_e677 < 8388608f) {
                        phi_1338_ = (_e715 - _e718);
                        phi_1339_ = false;
                    } else {
                        phi_1338_ = f32();
                        phi_1339_ = true;
                    }
                    let _e721 = phi_1338_;
                    let _e723 = phi_1339_;
                    phi_1340_ = _e721;
                    phi_1341_ = _e723;
                } else {
                    phi_1340_ = f32();
                    phi_1341_ = true;
                }
                let _e725 = phi_1340_;
                let _e727 = phi_1341_;
                if _e727 {
                    phi_1345_ = _e677;
                } else {
                    phi_1345_ = _e725;
                }
                let _e729 = phi_1345_;
                let _e730 = (_e676 - _e703);
                let _e731 = (_e677 - _e729);
                let _e740 = select(0i, select(select(i32(_e703), i32(-2147483648), (_e703 < bitcast<f32>(3472883712u))), 2147483647i, (_e703 > bitcast<f32>(1325400063u))), (_e703 == _e703));
                let _e749 = select(0i, select(select(i32(_e729), i32(-2147483648), (_e729 < bitcast<f32>(3472883712u))), 2147483647i, (_e729 > bitcast<f32>(1325400063u))), (_e729 == _e729));
                let _e760 = p.member.test;
                let _e761 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e760);
                let _e763 = p.member.map_size;
                let _e765 = local_3;
                local = _e761;
                let _e768 = ((_e765.level * _e763) * _e763);
                let _e770 = (bitcast<i32>(_e763) - 1i);
                if (_e740 > 0i) {
                    phi_1394_ = _e740;
                } else {
                    phi_1394_ = 0i;
                }
                let _e773 = phi_1394_;
                if (_e749 > 0i) {
                    phi_1399_ = _e749;
                } else {
                    phi_1399_ = 0i;
                }
                let _e776 = phi_1399_;
                if (_e773 < _e770) {
                    phi_1404_ = _e773;
                } else {
                    phi_1404_ = _e770;
                }
                let _e779 = phi_1404_;
                if (_e776 < _e770) {
                    phi_1409_ = _e776;
                } else {
                    phi_1409_ = _e770;
                }
                let _e782 = phi_1409_;
                let _e783 = bitcast<u32>(_e779);
                let _e785 = (_e740 + 1i);
                let _e786 = (_e749 + 1i);
                if (_e785 > 0i) {
                    phi_1418_ = _e785;
                } else {
                    phi_1418_ = 0i;
                }
                let _e789 = phi_1418_;
                if (_e786 > 0i) {
                    phi_1423_ = _e786;
                } else {
                    phi_1423_ = 0i;
                }
                let _e792 = phi_1423_;
                if (_e789 < _e770) {
                    phi_1428_ = _e789;
                } else {
                    phi_1428_ = _e770;
                }
                let _e795 = phi_1428_;
                if (_e792 < _e770) {
                    phi_1433_ = _e792;
                } else {
                    phi_1433_ = _e770;
                }
                let _e798 = phi_1433_;
                let _e799 = bitcast<u32>(_e795);
                let _e801 = (bitcast<u32>(_e782) * _e763);
                let _e802 = (bitcast<u32>(_e798) * _e763);
                let _e807 = ((_e801 + _e783) + _e768);
                let _e808 = ((_e801 + _e799) + _e768);
                let _e809 = ((_e802 + _e783) + _e768);
                let _e810 = ((_e802 + _e799) + _e768);
                if (_e807 < _e60) {
                } else {
                    return;
                }
                let _e814 = map.member[(0u + _e807)];
                if (_e808 < _e60) {
                } else {
                    return;
                }
                let _e818 = map.member[(0u + _e808)];
                if (_e809 < _e60) {
                } else {
                    return;
                }
                let _e822 = map.member[(0u + _e809)];
                if (_e810 < _e60) {
                } else {
                    return;
                }
                let _e826 = map.member[(0u + _e810)];
                let _e828 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e814, _e818, _e822, _e826), vec4<f32>(((1f - _e730) * (1f - _e731)), (_e730 * (1f - _e731)), ((1f - _e730) * _e731), (_e730 * _e731)), _e666);
                let _e830 = p.member.epsilon;
                if (_e828 <= _e830) {
                    phi_1484_ = true;
                } else {
                    phi_1484_ = (_e828 >= (1f - _e830));
                }
                let _e835 = phi_1484_;
                if ((bitcast<u32>(_e828) & 2147483647u) > 2139095040u) {
                    phi_1492_ = true;
                } else {
                    phi_1492_ = !(_e835);
                }
                let _e841 = phi_1492_;
                if _e841 {
                    if (_e828 > 0f) {
                        if (_e828 < 1f) {
                            phi_1504_ = false;
                        } else {
                            phi_1504_ = true;
                        }
                        let _e845 = phi_1504_;
                        phi_1505_ = _e845;
                    } else {
                        phi_1505_ = true;
                    }
                    let _e847 = phi_1505_;
                    if _e847 {
                        phi_1509_ = 0.5f;
                    } else {
                        phi_1509_ = _e828;
                    }
                    let _e849 = phi_1509_;
                    phi_1517_ = evaluate_Verdict(_e849, true);
                } else {
                    if (_e828 > 0.5f) {
                        phi_1515_ = 1f;
                    } else {
                        phi_1515_ = 0f;
                    }
                    let _e853 = phi_1515_;
                    phi_1517_ = evaluate_Verdict(_e853, false);
                }
                let _e856 = phi_1517_;
                phi_1522_ = evaluate_Verdict(_e856.visibility, _e856.is_doubted);
            } else {
                phi_1522_ = evaluate_Verdict(0.5f, true);
            }
            let _e862 = phi_1522_;
            phi_1523_ = _e862;
        }
        let _e864 = phi_1523_;
        if (_e72.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e72.first_primitive)] = _e864.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
