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

struct type_35 {
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
var<storage> levels: type_35;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_155_: lt_bvh_traverse_Tree;
    var phi_156_: bool;
    var phi_157_: lt_bvh_traverse_Tree;
    var phi_158_: bool;
    var phi_163_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_155_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_156_ = false;
        } else {
            phi_155_ = lt_bvh_traverse_Tree();
            phi_156_ = true;
        }
        let _e65 = phi_155_;
        let _e67 = phi_156_;
        phi_157_ = _e65;
        phi_158_ = _e67;
    } else {
        phi_157_ = lt_bvh_traverse_Tree();
        phi_158_ = true;
    }
    let _e69 = phi_157_;
    let _e71 = phi_158_;
    if _e71 {
        phi_163_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_163_ = _e69;
    }
    let _e76 = phi_163_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_186_: bool;
    var phi_190_: f32;
    var phi_205_: f32;
    var phi_206_: f32;
    var phi_207_: f32;
    var phi_223_: f32;
    var phi_224_: f32;
    var phi_225_: f32;
    var phi_241_: f32;
    var phi_242_: f32;
    var phi_243_: f32;
    var phi_259_: f32;
    var phi_260_: f32;
    var phi_261_: f32;
    var phi_277_: f32;
    var phi_278_: f32;
    var phi_279_: f32;
    var phi_298_: f32;
    var phi_303_: f32;
    var phi_325_: f32;
    var phi_330_: f32;
    var phi_331_: bool;
    var phi_332_: f32;
    var phi_333_: bool;
    var phi_337_: f32;
    var phi_375_: f32;
    var phi_386_: f32;
    var phi_391_: f32;
    var phi_413_: f32;
    var phi_418_: f32;
    var phi_419_: bool;
    var phi_420_: f32;
    var phi_421_: bool;
    var phi_425_: f32;
    var phi_463_: f32;
    var phi_474_: f32;
    var phi_479_: f32;
    var phi_501_: f32;
    var phi_506_: f32;
    var phi_507_: bool;
    var phi_508_: f32;
    var phi_509_: bool;
    var phi_513_: f32;
    var phi_551_: f32;
    var phi_562_: f32;
    var phi_567_: f32;
    var phi_589_: f32;
    var phi_594_: f32;
    var phi_595_: bool;
    var phi_596_: f32;
    var phi_597_: bool;
    var phi_601_: f32;
    var phi_639_: f32;
    var phi_665_: f32;
    var phi_666_: f32;
    var phi_667_: f32;

    let _e56 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_186_ = true;
    } else {
        let _e60 = (84f < _e56);
        if _e60 {
        }
        phi_186_ = _e60;
    }
    let _e62 = phi_186_;
    if _e62 {
        phi_190_ = 84f;
    } else {
        phi_190_ = _e56;
    }
    let _e64 = phi_190_;
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
            let _e71 = phi_205_;
            phi_206_ = _e71;
        }
        let _e73 = phi_206_;
        phi_207_ = _e73;
    }
    let _e75 = phi_207_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_225_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_224_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_223_ = 1f;
            } else {
                phi_223_ = param_5.x;
            }
            let _e83 = phi_223_;
            phi_224_ = _e83;
        }
        let _e85 = phi_224_;
        phi_225_ = _e85;
    }
    let _e87 = phi_225_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_243_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_242_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_241_ = 1f;
            } else {
                phi_241_ = param_5.y;
            }
            let _e95 = phi_241_;
            phi_242_ = _e95;
        }
        let _e97 = phi_242_;
        phi_243_ = _e97;
    }
    let _e99 = phi_243_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_261_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_260_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_259_ = 1f;
            } else {
                phi_259_ = param_5.z;
            }
            let _e107 = phi_259_;
            phi_260_ = _e107;
        }
        let _e109 = phi_260_;
        phi_261_ = _e109;
    }
    let _e111 = phi_261_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_279_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_278_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_277_ = 1f;
            } else {
                phi_277_ = param_5.w;
            }
            let _e119 = phi_277_;
            phi_278_ = _e119;
        }
        let _e121 = phi_278_;
        phi_279_ = _e121;
    }
    let _e123 = phi_279_;
    let _e128 = (_e64 * (_e87 - _e75));
    let _e129 = (_e64 * (_e99 - _e75));
    let _e130 = (_e64 * (_e111 - _e75));
    let _e131 = (_e64 * (_e123 - _e75));
    if ((bitcast<u32>(_e128) & 2147483647u) > 2139095040u) {
        phi_375_ = _e128;
    } else {
        if (_e128 < -87f) {
            phi_298_ = -87f;
        } else {
            phi_298_ = _e128;
        }
        let _e137 = phi_298_;
        if (_e137 > 88f) {
            phi_303_ = 88f;
        } else {
            phi_303_ = _e137;
        }
        let _e140 = phi_303_;
        let _e142 = ((_e140 * 1.442695f) + 0.5f);
        if (_e142 > -8388608f) {
            let _e154 = f32(select(0i, select(select(i32(_e142), i32(-2147483648), (_e142 < bitcast<f32>(3472883712u))), 2147483647i, (_e142 > bitcast<f32>(1325400063u))), (_e142 == _e142)));
            if (_e154 > _e142) {
                phi_325_ = 1f;
            } else {
                phi_325_ = 0f;
            }
            let _e157 = phi_325_;
            if (_e142 < 8388608f) {
                phi_330_ = (_e154 - _e157);
                phi_331_ = false;
            } else {
                phi_330_ = f32();
                phi_331_ = true;
            }
            let _e160 = phi_330_;
            let _e162 = phi_331_;
            phi_332_ = _e160;
            phi_333_ = _e162;
        } else {
            phi_332_ = f32();
            phi_333_ = true;
        }
        let _e164 = phi_332_;
        let _e166 = phi_333_;
        if _e166 {
            phi_337_ = _e142;
        } else {
            phi_337_ = _e164;
        }
        let _e168 = phi_337_;
        let _e172 = ((_e140 - (_e168 * 0.69314575f)) - (_e168 * 0.0000014286068f));
        phi_375_ = ((((((((((((((((1f / 5040f) * _e172) + (1f / 720f)) * _e172) + (1f / 120f)) * _e172) + (1f / 24f)) * _e172) + (1f / 6f)) * _e172) + 0.5f) * _e172) + 1f) * _e172) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e168), i32(-2147483648), (_e168 < bitcast<f32>(3472883712u))), 2147483647i, (_e168 > bitcast<f32>(1325400063u))), (_e168 == _e168)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e208 = phi_375_;
    if ((bitcast<u32>(_e129) & 2147483647u) > 2139095040u) {
        phi_463_ = _e129;
    } else {
        if (_e129 < -87f) {
            phi_386_ = -87f;
        } else {
            phi_386_ = _e129;
        }
        let _e214 = phi_386_;
        if (_e214 > 88f) {
            phi_391_ = 88f;
        } else {
            phi_391_ = _e214;
        }
        let _e217 = phi_391_;
        let _e219 = ((_e217 * 1.442695f) + 0.5f);
        if (_e219 > -8388608f) {
            let _e231 = f32(select(0i, select(select(i32(_e219), i32(-2147483648), (_e219 < bitcast<f32>(3472883712u))), 2147483647i, (_e219 > bitcast<f32>(1325400063u))), (_e219 == _e219)));
            if (_e231 > _e219) {
                phi_413_ = 1f;
            } else {
                phi_413_ = 0f;
            }
            let _e234 = phi_413_;
            if (_e219 < 8388608f) {
                phi_418_ = (_e231 - _e234);
                phi_419_ = false;
            } else {
                phi_418_ = f32();
                phi_419_ = true;
            }
            let _e237 = phi_418_;
            let _e239 = phi_419_;
            phi_420_ = _e237;
            phi_421_ = _e239;
        } else {
            phi_420_ = f32();
            phi_421_ = true;
        }
        let _e241 = phi_420_;
        let _e243 = phi_421_;
        if _e243 {
            phi_425_ = _e219;
        } else {
            phi_425_ = _e241;
        }
        let _e245 = phi_425_;
        let _e249 = ((_e217 - (_e245 * 0.69314575f)) - (_e245 * 0.0000014286068f));
        phi_463_ = ((((((((((((((((1f / 5040f) * _e249) + (1f / 720f)) * _e249) + (1f / 120f)) * _e249) + (1f / 24f)) * _e249) + (1f / 6f)) * _e249) + 0.5f) * _e249) + 1f) * _e249) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e245), i32(-2147483648), (_e245 < bitcast<f32>(3472883712u))), 2147483647i, (_e245 > bitcast<f32>(1325400063u))), (_e245 == _e245)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e285 = phi_463_;
    if ((bitcast<u32>(_e130) & 2147483647u) > 2139095040u) {
        phi_551_ = _e130;
    } else {
        if (_e130 < -87f) {
            phi_474_ = -87f;
        } else {
            phi_474_ = _e130;
        }
        let _e291 = phi_474_;
        if (_e291 > 88f) {
            phi_479_ = 88f;
        } else {
            phi_479_ = _e291;
        }
        let _e294 = phi_479_;
        let _e296 = ((_e294 * 1.442695f) + 0.5f);
        if (_e296 > -8388608f) {
            let _e308 = f32(select(0i, select(select(i32(_e296), i32(-2147483648), (_e296 < bitcast<f32>(3472883712u))), 2147483647i, (_e296 > bitcast<f32>(1325400063u))), (_e296 == _e296)));
            if (_e308 > _e296) {
                phi_501_ = 1f;
            } else {
                phi_501_ = 0f;
            }
            let _e311 = phi_501_;
            if (_e296 < 8388608f) {
                phi_506_ = (_e308 - _e311);
                phi_507_ = false;
            } else {
                phi_506_ = f32();
                phi_507_ = true;
            }
            let _e314 = phi_506_;
            let _e316 = phi_507_;
            phi_508_ = _e314;
            phi_509_ = _e316;
        } else {
            phi_508_ = f32();
            phi_509_ = true;
        }
        let _e318 = phi_508_;
        let _e320 = phi_509_;
        if _e320 {
            phi_513_ = _e296;
        } else {
            phi_513_ = _e318;
        }
        let _e322 = phi_513_;
        let _e326 = ((_e294 - (_e322 * 0.69314575f)) - (_e322 * 0.0000014286068f));
        phi_551_ = ((((((((((((((((1f / 5040f) * _e326) + (1f / 720f)) * _e326) + (1f / 120f)) * _e326) + (1f / 24f)) * _e326) + (1f / 6f)) * _e326) + 0.5f) * _e326) + 1f) * _e326) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e322), i32(-2147483648), (_e322 < bitcast<f32>(3472883712u))), 2147483647i, (_e322 > bitcast<f32>(1325400063u))), (_e322 == _e322)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e362 = phi_551_;
    if ((bitcast<u32>(_e131) & 2147483647u) > 2139095040u) {
        phi_639_ = _e131;
    } else {
        if (_e131 < -87f) {
            phi_562_ = -87f;
        } else {
            phi_562_ = _e131;
        }
        let _e368 = phi_562_;
        if (_e368 > 88f) {
            phi_567_ = 88f;
        } else {
            phi_567_ = _e368;
        }
        let _e371 = phi_567_;
        let _e373 = ((_e371 * 1.442695f) + 0.5f);
        if (_e373 > -8388608f) {
            let _e385 = f32(select(0i, select(select(i32(_e373), i32(-2147483648), (_e373 < bitcast<f32>(3472883712u))), 2147483647i, (_e373 > bitcast<f32>(1325400063u))), (_e373 == _e373)));
            if (_e385 > _e373) {
                phi_589_ = 1f;
            } else {
                phi_589_ = 0f;
            }
            let _e388 = phi_589_;
            if (_e373 < 8388608f) {
                phi_594_ = (_e385 - _e388);
                phi_595_ = false;
            } else {
                phi_594_ = f32();
                phi_595_ = true;
            }
            let _e391 = phi_594_;
            let _e393 = phi_595_;
            phi_596_ = _e391;
            phi_597_ = _e393;
        } else {
            phi_596_ = f32();
            phi_597_ = true;
        }
        let _e395 = phi_596_;
        let _e397 = phi_597_;
        if _e397 {
            phi_601_ = _e373;
        } else {
            phi_601_ = _e395;
        }
        let _e399 = phi_601_;
        let _e403 = ((_e371 - (_e399 * 0.69314575f)) - (_e399 * 0.0000014286068f));
        phi_639_ = ((((((((((((((((1f / 5040f) * _e403) + (1f / 720f)) * _e403) + (1f / 120f)) * _e403) + (1f / 24f)) * _e403) + (1f / 6f)) * _e403) + 0.5f) * _e403) + 1f) * _e403) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e399), i32(-2147483648), (_e399 < bitcast<f32>(3472883712u))), 2147483647i, (_e399 > bitcast<f32>(1325400063u))), (_e399 == _e399)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e439 = phi_639_;
    let _e450 = ((((_e208 * param_6.x) + (_e285 * param_6.y)) + (_e362 * param_6.z)) + (_e439 * param_6.w));
    if ((bitcast<u32>(_e450) & 2147483647u) > 2139095040u) {
        phi_667_ = _e450;
    } else {
        if (_e450 < 0f) {
            phi_666_ = 0f;
        } else {
            if (_e450 > 1f) {
                phi_665_ = 1f;
            } else {
                phi_665_ = _e450;
            }
            let _e457 = phi_665_;
            phi_666_ = _e457;
        }
        let _e459 = phi_666_;
        phi_667_ = _e459;
    }
    let _e461 = phi_667_;
    return _e461;
}

fn function_() {
    var local: f32;
    var phi_727_: bool;
    var phi_728_: bool;
    var phi_729_: bool;
    var phi_730_: bool;
    var phi_734_: bool;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_816_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_817_: bool;
    var phi_818_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_819_: bool;
    var phi_826_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_830_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_850_: lt_math_LightPoint;
    var phi_853_: u32;
    var phi_855_: lt_math_LevelPoint;
    var phi_941_: bool;
    var phi_950_: bool;
    var phi_959_: bool;
    var phi_960_: bool;
    var phi_961_: bool;
    var phi_962_: bool;
    var phi_963_: bool;
    var phi_964_: bool;
    var phi_965_: bool;
    var phi_969_: bool;
    var phi_996_: bool;
    var phi_997_: bool;
    var phi_998_: bool;
    var phi_999_: bool;
    var phi_1000_: bool;
    var phi_1001_: bool;
    var phi_1002_: bool;
    var phi_1003_: bool;
    var phi_1007_: bool;
    var phi_1016_: lt_math_LightPoint;
    var phi_1017_: u32;
    var phi_1018_: lt_math_LevelPoint;
    var phi_1019_: bool;
    var phi_851_: lt_math_LightPoint;
    var phi_854_: u32;
    var phi_856_: lt_math_LevelPoint;
    var phi_1020_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1060_: bool;
    var phi_1061_: bool;
    var phi_1062_: bool;
    var phi_1063_: bool;
    var phi_1067_: bool;
    var phi_1149_: f32;
    var phi_1267_: f32;
    var phi_1268_: f32;
    var phi_1271_: f32;
    var phi_1300_: f32;
    var phi_1305_: f32;
    var phi_1306_: bool;
    var phi_1307_: f32;
    var phi_1308_: bool;
    var phi_1312_: f32;
    var phi_1332_: f32;
    var phi_1337_: f32;
    var phi_1338_: bool;
    var phi_1339_: f32;
    var phi_1340_: bool;
    var phi_1344_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1393_: i32;
    var phi_1398_: i32;
    var phi_1403_: i32;
    var phi_1408_: i32;
    var phi_1417_: i32;
    var phi_1422_: i32;
    var phi_1427_: i32;
    var phi_1432_: i32;
    var phi_1477_: evaluate_Verdict;
    var phi_1478_: evaluate_Verdict;
    var phi_1479_: bool;
    var phi_1480_: evaluate_Verdict;
    var phi_1481_: evaluate_Verdict;
    var phi_1482_: bool;
    var phi_1486_: evaluate_Verdict;

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
                phi_727_ = (_e95 == _e97);
                phi_728_ = false;
            } else {
                phi_727_ = bool();
                phi_728_ = true;
            }
            let _e100 = phi_727_;
            let _e102 = phi_728_;
            phi_729_ = _e100;
            phi_730_ = _e102;
        } else {
            phi_729_ = bool();
            phi_730_ = true;
        }
        let _e104 = phi_729_;
        let _e106 = phi_730_;
        if _e106 {
            phi_734_ = false;
        } else {
            phi_734_ = _e104;
        }
        let _e108 = phi_734_;
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
                    phi_805_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_804_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_804_ = false;
                    }
                    let _e169 = phi_804_;
                    phi_805_ = _e169;
                }
                let _e171 = phi_805_;
                if _e171 {
                    let _e173 = samples.member[(0u + _e72.first_primitive)].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_816_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_817_ = false;
                } else {
                    phi_816_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_817_ = true;
                }
                let _e192 = phi_816_;
                let _e194 = phi_817_;
                phi_818_ = _e192;
                phi_819_ = _e194;
            } else {
                phi_818_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_819_ = true;
            }
            let _e196 = phi_818_;
            let _e198 = phi_819_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_826_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_826_ = _e196;
            }
            let _e215 = phi_826_;
            phi_830_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_830_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_830_;
        if _e232.unnamed_1 {
            phi_1480_ = evaluate_Verdict(_e232.unnamed.visibility, _e232.unnamed.is_doubted);
            phi_1481_ = evaluate_Verdict();
            phi_1482_ = true;
        } else {
            let _e240 = samples.member[(0u + _e72.first_primitive)].position;
            let _e242 = p.member.map_size;
            let _e244 = (0.5f / f32(_e242));
            let _e251 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e258 = lt_math_LightPoint(vec2<f32>(_e251.uv.x, 0f), _e251.depth, _e251.is_inside);
            let _e262 = lt_math_LightPoint(_e258.uv, 0f, _e258.is_inside);
            phi_850_ = lt_math_LightPoint();
            phi_853_ = 0u;
            phi_855_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e262.uv, _e262.depth, false));
            loop {
                let _e269 = phi_850_;
                let _e271 = phi_853_;
                let _e273 = phi_855_;
                local_1 = _e273;
                local_2 = _e273;
                local_3 = _e273;
                if (_e271 < _e78) {
                    if _e273.point.is_inside {
                        phi_1016_ = lt_math_LightPoint();
                        phi_1017_ = u32();
                        phi_1018_ = lt_math_LevelPoint();
                        phi_1019_ = false;
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
                                phi_941_ = (_e309 <= 1f);
                            } else {
                                phi_941_ = false;
                            }
                            let _e341 = phi_941_;
                            if _e341 {
                                if (_e323 >= 0f) {
                                    phi_950_ = (_e323 <= 1f);
                                } else {
                                    phi_950_ = false;
                                }
                                let _e345 = phi_950_;
                                if _e345 {
                                    if (_e336 >= 0f) {
                                        phi_959_ = (_e336 <= 1f);
                                    } else {
                                        phi_959_ = false;
                                    }
                                    let _e349 = phi_959_;
                                    phi_960_ = _e349;
                                    phi_961_ = false;
                                } else {
                                    phi_960_ = bool();
                                    phi_961_ = true;
                                }
                                let _e351 = phi_960_;
                                let _e353 = phi_961_;
                                phi_962_ = _e351;
                                phi_963_ = _e353;
                            } else {
                                phi_962_ = bool();
                                phi_963_ = true;
                            }
                            let _e355 = phi_962_;
                            let _e357 = phi_963_;
                            phi_964_ = _e355;
                            phi_965_ = _e357;
                        } else {
                            phi_964_ = bool();
                            phi_965_ = true;
                        }
                        let _e359 = phi_964_;
                        let _e361 = phi_965_;
                        if _e361 {
                            phi_969_ = false;
                        } else {
                            phi_969_ = _e359;
                        }
                        let _e363 = phi_969_;
                        if _e363 {
                            if (_e309 >= _e244) {
                                if (_e309 <= (1f - _e244)) {
                                    if (_e323 >= _e244) {
                                        phi_996_ = (_e323 <= (1f - _e244));
                                        phi_997_ = false;
                                    } else {
                                        phi_996_ = bool();
                                        phi_997_ = true;
                                    }
                                    let _e371 = phi_996_;
                                    let _e373 = phi_997_;
                                    phi_998_ = _e371;
                                    phi_999_ = _e373;
                                } else {
                                    phi_998_ = bool();
                                    phi_999_ = true;
                                }
                                let _e375 = phi_998_;
                                let _e377 = phi_999_;
                                phi_1000_ = _e375;
                                phi_1001_ = _e377;
                            } else {
                                phi_1000_ = bool();
                                phi_1001_ = true;
                            }
                            let _e379 = phi_1000_;
                            let _e381 = phi_1001_;
                            phi_1002_ = _e379;
                            phi_1003_ = _e381;
                        } else {
                            phi_1002_ = bool();
                            phi_1003_ = true;
                        }
                        let _e383 = phi_1002_;
                        let _e385 = phi_1003_;
                        if _e385 {
                            phi_1007_ = false;
                        } else {
                            phi_1007_ = _e383;
                        }
                        let _e387 = phi_1007_;
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e309, _e269.uv.y), _e269.depth, _e269.is_inside);
                        let _e401 = lt_math_LightPoint(vec2<f32>(_e394.uv.x, _e323), _e394.depth, _e394.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e336, _e401.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e405.depth, _e387);
                        phi_1016_ = _e409;
                        phi_1017_ = (_e271 + 1u);
                        phi_1018_ = lt_math_LevelPoint(_e271, _e409);
                        phi_1019_ = true;
                    }
                    let _e413 = phi_1016_;
                    let _e415 = phi_1017_;
                    let _e417 = phi_1018_;
                    let _e419 = phi_1019_;
                    phi_851_ = _e413;
                    phi_854_ = _e415;
                    phi_856_ = _e417;
                    phi_1020_ = _e419;
                } else {
                    phi_851_ = lt_math_LightPoint();
                    phi_854_ = u32();
                    phi_856_ = lt_math_LevelPoint();
                    phi_1020_ = false;
                }
                let _e421 = phi_851_;
                let _e423 = phi_854_;
                let _e425 = phi_856_;
                let _e427 = phi_1020_;
                continue;
                continuing {
                    phi_850_ = _e421;
                    phi_853_ = _e423;
                    phi_855_ = _e425;
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
                            phi_1060_ = (_e441.row_w.z == _e453);
                            phi_1061_ = false;
                        } else {
                            phi_1060_ = bool();
                            phi_1061_ = true;
                        }
                        let _e456 = phi_1060_;
                        let _e458 = phi_1061_;
                        phi_1062_ = _e456;
                        phi_1063_ = _e458;
                    } else {
                        phi_1062_ = bool();
                        phi_1063_ = true;
                    }
                    let _e460 = phi_1062_;
                    let _e462 = phi_1063_;
                    if _e462 {
                        phi_1067_ = false;
                    } else {
                        phi_1067_ = _e460;
                    }
                    let _e464 = phi_1067_;
                    if _e464 {
                        let _e466 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e468 = p.member.map_size;
                        let _e538 = ((abs(((((_e441.row_x.x * _e466.x) + (_e441.row_x.y * _e466.y)) + (_e441.row_x.z * _e466.z)) / (((_e441.row_x.x * _e441.row_x.x) + (_e441.row_x.y * _e441.row_x.y)) + (_e441.row_x.z * _e441.row_x.z)))) + abs(((((_e441.row_y.x * _e466.x) + (_e441.row_y.y * _e466.y)) + (_e441.row_y.z * _e466.z)) / (((_e441.row_y.x * _e441.row_y.x) + (_e441.row_y.y * _e441.row_y.y)) + (_e441.row_y.z * _e441.row_y.z))))) / (abs(((((_e441.row_z.x * _e466.x) + (_e441.row_z.y * _e466.y)) + (_e441.row_z.z * _e466.z)) / (((_e441.row_z.x * _e441.row_z.x) + (_e441.row_z.y * _e441.row_z.y)) + (_e441.row_z.z * _e441.row_z.z)))) * f32(_e468)));
                        if (_e538 < 0.002f) {
                            phi_1149_ = _e538;
                        } else {
                            phi_1149_ = 0.002f;
                        }
                        let _e541 = phi_1149_;
                        phi_1268_ = _e541;
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
                            phi_1267_ = _e655;
                        } else {
                            phi_1267_ = _e657;
                        }
                        let _e660 = phi_1267_;
                        phi_1268_ = _e660;
                    }
                    let _e662 = phi_1268_;
                    phi_1271_ = (_e430.point.depth - (0f * _e662));
                } else {
                    phi_1271_ = _e430.point.depth;
                }
                let _e666 = phi_1271_;
                let _e672 = p.member.map_size;
                let _e673 = f32(_e672);
                let _e676 = ((_e430.point.uv.x * _e673) - 0.5f);
                let _e677 = ((_e430.point.uv.y * _e673) - 0.5f);
                if (_e676 > -8388608f) {
                    let _e689 = f32(select(0i, select(select(i32(_e676), i32(-2147483648), (_e676 < bitcast<f32>(3472883712u))), 2147483647i, (_e676 > bitcast<f32>(1325400063u))), (_e676 == _e676)));
                    if (_e689 > _e676) {
                        phi_1300_ = 1f;
                    } else {
                        phi_1300_ = 0f;
                    }
                    let _e692 = phi_1300_;
                    if (_e676 < 8388608f) {
                        phi_1305_ = (_e689 - _e692);
                        phi_1306_ = false;
                    } else {
                        phi_1305_ = f32();
                        phi_1306_ = true;
                    }
                    let _e695 = phi_1305_;
                    let _e697 = phi_1306_;
                    phi_1307_ = _e695;
                    phi_1308_ = _e697;
                } else {
                    phi_1307_ = f32();
                    phi_1308_ = true;
                }
                let _e699 = phi_1307_;
                let _e701 = phi_1308_;
                if _e701 {
                    phi_1312_ = _e676;
                } else {
                    phi_1312_ = _e699;
                }
                let _e703 = phi_1312_;
                if (_e677 > -8388608f) {
                    let _e715 = f32(select(0i, select(select(i32(_e677), i32(-2147483648), (_e677 < bitcast<f32>(3472883712u))), 2147483647i, (_e677 > bitcast<f32>(1325400063u))), (_e677 == _e677)));
                    if (_e715 > _e677) {
                        phi_1332_ = 1f;
                    } else {
                        phi_1332_ = 0f;
                    }
                    let _e718 = phi_1332_;
                    if (_e677 < 8388608f) {
                        phi_1337_ = (_e715 - _e718);
                        phi_1338_ = false;
                    } else {
                        phi_1337_ = f32();
                        phi_1338_ = true;
                    }
                    let _e721 = phi_1337_;
                    let _e723 = phi_1338_;
                    phi_1339_ = _e721;
                    phi_1340_ = _e723;
                } else {
                    phi_1339_ = f32();
                    phi_1340_ = true;
                }
                let _e725 = phi_1339_;
                let _e727 = phi_1340_;
                if _e727 {
                    phi_1344_ = _e677;
                } else {
                    phi_1344_ = _e725;
                }
                let _e729 = phi_1344_;
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
                    phi_1393_ = _e740;
                } else {
                    phi_1393_ = 0i;
                }
                let _e773 = phi_1393_;
                if (_e749 > 0i) {
                    phi_1398_ = _e749;
                } else {
                    phi_1398_ = 0i;
                }
                let _e776 = phi_1398_;
                if (_e773 < _e770) {
                    phi_1403_ = _e773;
                } else {
                    phi_1403_ = _e770;
                }
                let _e779 = phi_1403_;
                if (_e776 < _e770) {
                    phi_1408_ = _e776;
                } else {
                    phi_1408_ = _e770;
                }
                let _e782 = phi_1408_;
                let _e783 = bitcast<u32>(_e779);
                let _e785 = (_e740 + 1i);
                let _e786 = (_e749 + 1i);
                if (_e785 > 0i) {
                    phi_1417_ = _e785;
                } else {
                    phi_1417_ = 0i;
                }
                let _e789 = phi_1417_;
                if (_e786 > 0i) {
                    phi_1422_ = _e786;
                } else {
                    phi_1422_ = 0i;
                }
                let _e792 = phi_1422_;
                if (_e789 < _e770) {
                    phi_1427_ = _e789;
                } else {
                    phi_1427_ = _e770;
                }
                let _e795 = phi_1427_;
                if (_e792 < _e770) {
                    phi_1432_ = _e792;
                } else {
                    phi_1432_ = _e770;
                }
                let _e798 = phi_1432_;
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
                phi_1477_ = evaluate_Verdict(_e828, false);
                phi_1478_ = evaluate_Verdict();
                phi_1479_ = false;
            } else {
                phi_1477_ = evaluate_Verdict();
                phi_1478_ = evaluate_Verdict(1f, false);
                phi_1479_ = true;
            }
            let _e832 = phi_1477_;
            let _e834 = phi_1478_;
            let _e836 = phi_1479_;
            phi_1480_ = _e834;
            phi_1481_ = _e832;
            phi_1482_ = _e836;
        }
        let _e838 = phi_1480_;
        let _e840 = phi_1481_;
        let _e842 = phi_1482_;
        if _e842 {
            phi_1486_ = _e838;
        } else {
            phi_1486_ = _e840;
        }
        let _e844 = phi_1486_;
        if (_e72.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e72.first_primitive)] = _e844.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
