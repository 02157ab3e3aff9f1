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

struct type_19 {
    member: array<abi_Sample>,
}

struct type_23 {
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

struct type_35 {
    member: abi_ShadowParams,
}

struct type_39 {
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
var<storage> samples: type_19;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(2) 
var<storage> map: type_23;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_23;
@group(0) @binding(4) 
var<storage> marks: type_9;
@group(0) @binding(5) 
var<storage> levels: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_174_: lt_bvh_traverse_Tree;
    var phi_175_: bool;
    var phi_176_: lt_bvh_traverse_Tree;
    var phi_177_: bool;
    var phi_182_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_174_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_175_ = false;
        } else {
            phi_174_ = lt_bvh_traverse_Tree();
            phi_175_ = true;
        }
        let _e71 = phi_174_;
        let _e73 = phi_175_;
        phi_176_ = _e71;
        phi_177_ = _e73;
    } else {
        phi_176_ = lt_bvh_traverse_Tree();
        phi_177_ = true;
    }
    let _e75 = phi_176_;
    let _e77 = phi_177_;
    if _e77 {
        phi_182_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_182_ = _e75;
    }
    let _e82 = phi_182_;
    return lt_bvh_traverse_Tree(_e82.root, _e82.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_205_: bool;
    var phi_209_: f32;
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
    var phi_296_: f32;
    var phi_297_: f32;
    var phi_298_: f32;
    var phi_317_: f32;
    var phi_322_: f32;
    var phi_344_: f32;
    var phi_349_: f32;
    var phi_350_: bool;
    var phi_351_: f32;
    var phi_352_: bool;
    var phi_356_: f32;
    var phi_394_: f32;
    var phi_405_: f32;
    var phi_410_: f32;
    var phi_432_: f32;
    var phi_437_: f32;
    var phi_438_: bool;
    var phi_439_: f32;
    var phi_440_: bool;
    var phi_444_: f32;
    var phi_482_: f32;
    var phi_493_: f32;
    var phi_498_: f32;
    var phi_520_: f32;
    var phi_525_: f32;
    var phi_526_: bool;
    var phi_527_: f32;
    var phi_528_: bool;
    var phi_532_: f32;
    var phi_570_: f32;
    var phi_581_: f32;
    var phi_586_: f32;
    var phi_608_: f32;
    var phi_613_: f32;
    var phi_614_: bool;
    var phi_615_: f32;
    var phi_616_: bool;
    var phi_620_: f32;
    var phi_658_: f32;
    var phi_684_: f32;
    var phi_685_: f32;
    var phi_686_: f32;

    let _e62 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_205_ = true;
    } else {
        let _e66 = (84f < _e62);
        if _e66 {
        }
        phi_205_ = _e66;
    }
    let _e68 = phi_205_;
    if _e68 {
        phi_209_ = 84f;
    } else {
        phi_209_ = _e62;
    }
    let _e70 = phi_209_;
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_226_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_225_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_224_ = 1f;
            } else {
                phi_224_ = param_7;
            }
            let _e77 = phi_224_;
            phi_225_ = _e77;
        }
        let _e79 = phi_225_;
        phi_226_ = _e79;
    }
    let _e81 = phi_226_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_244_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_243_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_242_ = 1f;
            } else {
                phi_242_ = param_5.x;
            }
            let _e89 = phi_242_;
            phi_243_ = _e89;
        }
        let _e91 = phi_243_;
        phi_244_ = _e91;
    }
    let _e93 = phi_244_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_262_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_261_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_260_ = 1f;
            } else {
                phi_260_ = param_5.y;
            }
            let _e101 = phi_260_;
            phi_261_ = _e101;
        }
        let _e103 = phi_261_;
        phi_262_ = _e103;
    }
    let _e105 = phi_262_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_280_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_279_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_278_ = 1f;
            } else {
                phi_278_ = param_5.z;
            }
            let _e113 = phi_278_;
            phi_279_ = _e113;
        }
        let _e115 = phi_279_;
        phi_280_ = _e115;
    }
    let _e117 = phi_280_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_298_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_297_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_296_ = 1f;
            } else {
                phi_296_ = param_5.w;
            }
            let _e125 = phi_296_;
            phi_297_ = _e125;
        }
        let _e127 = phi_297_;
        phi_298_ = _e127;
    }
    let _e129 = phi_298_;
    let _e134 = (_e70 * (_e93 - _e81));
    let _e135 = (_e70 * (_e105 - _e81));
    let _e136 = (_e70 * (_e117 - _e81));
    let _e137 = (_e70 * (_e129 - _e81));
    if ((bitcast<u32>(_e134) & 2147483647u) > 2139095040u) {
        phi_394_ = _e134;
    } else {
        if (_e134 < -87f) {
            phi_317_ = -87f;
        } else {
            phi_317_ = _e134;
        }
        let _e143 = phi_317_;
        if (_e143 > 88f) {
            phi_322_ = 88f;
        } else {
            phi_322_ = _e143;
        }
        let _e146 = phi_322_;
        let _e148 = ((_e146 * 1.442695f) + 0.5f);
        if (_e148 > -8388608f) {
            let _e160 = f32(select(0i, select(select(i32(_e148), i32(-2147483648), (_e148 < bitcast<f32>(3472883712u))), 2147483647i, (_e148 > bitcast<f32>(1325400063u))), (_e148 == _e148)));
            if (_e160 > _e148) {
                phi_344_ = 1f;
            } else {
                phi_344_ = 0f;
            }
            let _e163 = phi_344_;
            if (_e148 < 8388608f) {
                phi_349_ = (_e160 - _e163);
                phi_350_ = false;
            } else {
                phi_349_ = f32();
                phi_350_ = true;
            }
            let _e166 = phi_349_;
            let _e168 = phi_350_;
            phi_351_ = _e166;
            phi_352_ = _e168;
        } else {
            phi_351_ = f32();
            phi_352_ = true;
        }
        let _e170 = phi_351_;
        let _e172 = phi_352_;
        if _e172 {
            phi_356_ = _e148;
        } else {
            phi_356_ = _e170;
        }
        let _e174 = phi_356_;
        let _e178 = ((_e146 - (_e174 * 0.69314575f)) - (_e174 * 0.0000014286068f));
        phi_394_ = ((((((((((((((((1f / 5040f) * _e178) + (1f / 720f)) * _e178) + (1f / 120f)) * _e178) + (1f / 24f)) * _e178) + (1f / 6f)) * _e178) + 0.5f) * _e178) + 1f) * _e178) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e174), i32(-2147483648), (_e174 < bitcast<f32>(3472883712u))), 2147483647i, (_e174 > bitcast<f32>(1325400063u))), (_e174 == _e174)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e214 = phi_394_;
    if ((bitcast<u32>(_e135) & 2147483647u) > 2139095040u) {
        phi_482_ = _e135;
    } else {
        if (_e135 < -87f) {
            phi_405_ = -87f;
        } else {
            phi_405_ = _e135;
        }
        let _e220 = phi_405_;
        if (_e220 > 88f) {
            phi_410_ = 88f;
        } else {
            phi_410_ = _e220;
        }
        let _e223 = phi_410_;
        let _e225 = ((_e223 * 1.442695f) + 0.5f);
        if (_e225 > -8388608f) {
            let _e237 = f32(select(0i, select(select(i32(_e225), i32(-2147483648), (_e225 < bitcast<f32>(3472883712u))), 2147483647i, (_e225 > bitcast<f32>(1325400063u))), (_e225 == _e225)));
            if (_e237 > _e225) {
                phi_432_ = 1f;
            } else {
                phi_432_ = 0f;
            }
            let _e240 = phi_432_;
            if (_e225 < 8388608f) {
                phi_437_ = (_e237 - _e240);
                phi_438_ = false;
            } else {
                phi_437_ = f32();
                phi_438_ = true;
            }
            let _e243 = phi_437_;
            let _e245 = phi_438_;
            phi_439_ = _e243;
            phi_440_ = _e245;
        } else {
            phi_439_ = f32();
            phi_440_ = true;
        }
        let _e247 = phi_439_;
        let _e249 = phi_440_;
        if _e249 {
            phi_444_ = _e225;
        } else {
            phi_444_ = _e247;
        }
        let _e251 = phi_444_;
        let _e255 = ((_e223 - (_e251 * 0.69314575f)) - (_e251 * 0.0000014286068f));
        phi_482_ = ((((((((((((((((1f / 5040f) * _e255) + (1f / 720f)) * _e255) + (1f / 120f)) * _e255) + (1f / 24f)) * _e255) + (1f / 6f)) * _e255) + 0.5f) * _e255) + 1f) * _e255) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e251), i32(-2147483648), (_e251 < bitcast<f32>(3472883712u))), 2147483647i, (_e251 > bitcast<f32>(1325400063u))), (_e251 == _e251)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e291 = phi_482_;
    if ((bitcast<u32>(_e136) & 2147483647u) > 2139095040u) {
        phi_570_ = _e136;
    } else {
        if (_e136 < -87f) {
            phi_493_ = -87f;
        } else {
            phi_493_ = _e136;
        }
        let _e297 = phi_493_;
        if (_e297 > 88f) {
            phi_498_ = 88f;
        } else {
            phi_498_ = _e297;
        }
        let _e300 = phi_498_;
        let _e302 = ((_e300 * 1.442695f) + 0.5f);
        if (_e302 > -8388608f) {
            let _e314 = f32(select(0i, select(select(i32(_e302), i32(-2147483648), (_e302 < bitcast<f32>(3472883712u))), 2147483647i, (_e302 > bitcast<f32>(1325400063u))), (_e302 == _e302)));
            if (_e314 > _e302) {
                phi_520_ = 1f;
            } else {
                phi_520_ = 0f;
            }
            let _e317 = phi_520_;
            if (_e302 < 8388608f) {
                phi_525_ = (_e314 - _e317);
                phi_526_ = false;
            } else {
                phi_525_ = f32();
                phi_526_ = true;
            }
            let _e320 = phi_525_;
            let _e322 = phi_526_;
            phi_527_ = _e320;
            phi_528_ = _e322;
        } else {
            phi_527_ = f32();
            phi_528_ = true;
        }
        let _e324 = phi_527_;
        let _e326 = phi_528_;
        if _e326 {
            phi_532_ = _e302;
        } else {
            phi_532_ = _e324;
        }
        let _e328 = phi_532_;
        let _e332 = ((_e300 - (_e328 * 0.69314575f)) - (_e328 * 0.0000014286068f));
        phi_570_ = ((((((((((((((((1f / 5040f) * _e332) + (1f / 720f)) * _e332) + (1f / 120f)) * _e332) + (1f / 24f)) * _e332) + (1f / 6f)) * _e332) + 0.5f) * _e332) + 1f) * _e332) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e328), i32(-2147483648), (_e328 < bitcast<f32>(3472883712u))), 2147483647i, (_e328 > bitcast<f32>(1325400063u))), (_e328 == _e328)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e368 = phi_570_;
    if ((bitcast<u32>(_e137) & 2147483647u) > 2139095040u) {
        phi_658_ = _e137;
    } else {
        if (_e137 < -87f) {
            phi_581_ = -87f;
        } else {
            phi_581_ = _e137;
        }
        let _e374 = phi_581_;
        if (_e374 > 88f) {
            phi_586_ = 88f;
        } else {
            phi_586_ = _e374;
        }
        let _e377 = phi_586_;
        let _e379 = ((_e377 * 1.442695f) + 0.5f);
        if (_e379 > -8388608f) {
            let _e391 = f32(select(0i, select(select(i32(_e379), i32(-2147483648), (_e379 < bitcast<f32>(3472883712u))), 2147483647i, (_e379 > bitcast<f32>(1325400063u))), (_e379 == _e379)));
            if (_e391 > _e379) {
                phi_608_ = 1f;
            } else {
                phi_608_ = 0f;
            }
            let _e394 = phi_608_;
            if (_e379 < 8388608f) {
                phi_613_ = (_e391 - _e394);
                phi_614_ = false;
            } else {
                phi_613_ = f32();
                phi_614_ = true;
            }
            let _e397 = phi_613_;
            let _e399 = phi_614_;
            phi_615_ = _e397;
            phi_616_ = _e399;
        } else {
            phi_615_ = f32();
            phi_616_ = true;
        }
        let _e401 = phi_615_;
        let _e403 = phi_616_;
        if _e403 {
            phi_620_ = _e379;
        } else {
            phi_620_ = _e401;
        }
        let _e405 = phi_620_;
        let _e409 = ((_e377 - (_e405 * 0.69314575f)) - (_e405 * 0.0000014286068f));
        phi_658_ = ((((((((((((((((1f / 5040f) * _e409) + (1f / 720f)) * _e409) + (1f / 120f)) * _e409) + (1f / 24f)) * _e409) + (1f / 6f)) * _e409) + 0.5f) * _e409) + 1f) * _e409) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e405), i32(-2147483648), (_e405 < bitcast<f32>(3472883712u))), 2147483647i, (_e405 > bitcast<f32>(1325400063u))), (_e405 == _e405)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e445 = phi_658_;
    let _e456 = ((((_e214 * param_6.x) + (_e291 * param_6.y)) + (_e368 * param_6.z)) + (_e445 * param_6.w));
    if ((bitcast<u32>(_e456) & 2147483647u) > 2139095040u) {
        phi_686_ = _e456;
    } else {
        if (_e456 < 0f) {
            phi_685_ = 0f;
        } else {
            if (_e456 > 1f) {
                phi_684_ = 1f;
            } else {
                phi_684_ = _e456;
            }
            let _e463 = phi_684_;
            phi_685_ = _e463;
        }
        let _e465 = phi_685_;
        phi_686_ = _e465;
    }
    let _e467 = phi_686_;
    return _e467;
}

fn function_() {
    var local: f32;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_754_: bool;
    var phi_755_: bool;
    var phi_759_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_841_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_842_: bool;
    var phi_843_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_844_: bool;
    var phi_851_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_855_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_875_: lt_math_LightPoint;
    var phi_878_: u32;
    var phi_880_: lt_math_LevelPoint;
    var phi_966_: bool;
    var phi_975_: bool;
    var phi_984_: bool;
    var phi_985_: bool;
    var phi_986_: bool;
    var phi_987_: bool;
    var phi_988_: bool;
    var phi_989_: bool;
    var phi_990_: bool;
    var phi_994_: bool;
    var phi_1021_: bool;
    var phi_1022_: bool;
    var phi_1023_: bool;
    var phi_1024_: bool;
    var phi_1025_: bool;
    var phi_1026_: bool;
    var phi_1027_: bool;
    var phi_1028_: bool;
    var phi_1032_: bool;
    var phi_1041_: lt_math_LightPoint;
    var phi_1042_: u32;
    var phi_1043_: lt_math_LevelPoint;
    var phi_1044_: bool;
    var phi_876_: lt_math_LightPoint;
    var phi_879_: u32;
    var phi_881_: lt_math_LevelPoint;
    var phi_1045_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1085_: bool;
    var phi_1086_: bool;
    var phi_1087_: bool;
    var phi_1088_: bool;
    var phi_1092_: bool;
    var phi_1174_: f32;
    var phi_1292_: f32;
    var phi_1293_: f32;
    var phi_1296_: f32;
    var phi_1325_: f32;
    var phi_1330_: f32;
    var phi_1331_: bool;
    var phi_1332_: f32;
    var phi_1333_: bool;
    var phi_1337_: f32;
    var phi_1357_: f32;
    var phi_1362_: f32;
    var phi_1363_: bool;
    var phi_1364_: f32;
    var phi_1365_: bool;
    var phi_1369_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1420_: i32;
    var phi_1425_: i32;
    var phi_1430_: i32;
    var phi_1435_: i32;
    var phi_1444_: i32;
    var phi_1449_: i32;
    var phi_1454_: i32;
    var phi_1459_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1515_: i32;
    var phi_1520_: i32;
    var phi_1525_: i32;
    var phi_1530_: i32;
    var phi_1549_: i32;
    var phi_1554_: i32;
    var phi_1559_: i32;
    var phi_1564_: i32;
    var phi_1583_: i32;
    var phi_1588_: i32;
    var phi_1593_: i32;
    var phi_1598_: i32;
    var phi_1617_: i32;
    var phi_1622_: i32;
    var phi_1627_: i32;
    var phi_1632_: i32;
    var phi_1710_: bool;
    var phi_1718_: bool;
    var phi_1730_: bool;
    var phi_1731_: bool;
    var phi_1735_: f32;
    var phi_1741_: f32;
    var phi_1743_: evaluate_Verdict;
    var phi_1753_: u32;
    var phi_1762_: f32;
    var phi_1764_: evaluate_Verdict;
    var phi_1765_: bool;
    var phi_1766_: evaluate_Verdict;
    var phi_1767_: bool;
    var phi_1772_: evaluate_Verdict;
    var phi_1777_: evaluate_Verdict;
    var phi_1778_: evaluate_Verdict;

    let _e59 = id_1;
    let _e66 = arrayLength((&map.member));
    let _e72 = arrayLength((&marks.member));
    let _e75 = arrayLength((&levels.member));
    let _e78 = p.member.size[0u];
    let _e80 = p.member.size[1u];
    let _e81 = lt_shaders_entry_pixel_index(_e59, _e78, _e80);
    if (bitcast<i32>(_e81.root) != 0i) {
        let _e87 = p.member.level_count;
        if (_e81.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e94 = samples.member[(0u + _e81.first_primitive)].normal[0u];
        let _e96 = global[0u];
        if (_e94 == _e96) {
            let _e99 = samples.member[(0u + _e81.first_primitive)].normal[1u];
            let _e101 = global[1u];
            if (_e99 == _e101) {
                let _e104 = samples.member[(0u + _e81.first_primitive)].normal[2u];
                let _e106 = global[2u];
                phi_752_ = (_e104 == _e106);
                phi_753_ = false;
            } else {
                phi_752_ = bool();
                phi_753_ = true;
            }
            let _e109 = phi_752_;
            let _e111 = phi_753_;
            phi_754_ = _e109;
            phi_755_ = _e111;
        } else {
            phi_754_ = bool();
            phi_755_ = true;
        }
        let _e113 = phi_754_;
        let _e115 = phi_755_;
        if _e115 {
            phi_759_ = false;
        } else {
            phi_759_ = _e113;
        }
        let _e117 = phi_759_;
        if !(_e117) {
            let _e120 = samples.member[(0u + _e81.first_primitive)].position;
            let _e122 = p.member.light.place;
            let _e128 = p.member.light.place[3u];
            let _e135 = (_e122.x - (_e120.x * _e128));
            let _e136 = (_e122.y - (_e120.y * _e128));
            let _e137 = (_e122.z - (_e120.z * _e128));
            let _e139 = samples.member[(0u + _e81.first_primitive)].normal;
            if ((((_e139.x * _e135) + (_e139.y * _e136)) + (_e139.z * _e137)) > 0f) {
                let _e153 = (((_e135 * _e135) + (_e136 * _e136)) + (_e137 * _e137));
                let _e155 = p.member.light.axis;
                let _e167 = p.member.light.place[3u];
                if (_e167 == 0f) {
                    phi_830_ = true;
                } else {
                    let _e170 = p.member.light.range_squared;
                    if (_e153 <= _e170) {
                        let _e173 = p.member.light.cos_outer;
                        phi_829_ = (-((((_e135 * _e155.x) + (_e136 * _e155.y)) + (_e137 * _e155.z))) >= (_e173 * sqrt(_e153)));
                    } else {
                        phi_829_ = false;
                    }
                    let _e178 = phi_829_;
                    phi_830_ = _e178;
                }
                let _e180 = phi_830_;
                if _e180 {
                    let _e182 = samples.member[(0u + _e81.first_primitive)].flags;
                    let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e190.unnamed.visibility, false), _e190.unnamed_1);
                    phi_841_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e196.unnamed, ((_e182 & 1u) == 0u));
                    phi_842_ = false;
                } else {
                    phi_841_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_842_ = true;
                }
                let _e201 = phi_841_;
                let _e203 = phi_842_;
                phi_843_ = _e201;
                phi_844_ = _e203;
            } else {
                phi_843_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_844_ = true;
            }
            let _e205 = phi_843_;
            let _e207 = phi_844_;
            if _e207 {
                let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
                phi_851_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
            } else {
                phi_851_ = _e205;
            }
            let _e224 = phi_851_;
            phi_855_ = _e224;
        } else {
            let _e230 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e236 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e230.unnamed.visibility, false), _e230.unnamed_1);
            phi_855_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e236.unnamed, true);
        }
        let _e241 = phi_855_;
        if _e241.unnamed_1 {
            phi_1778_ = evaluate_Verdict(_e241.unnamed.visibility, _e241.unnamed.is_doubted);
        } else {
            let _e249 = samples.member[(0u + _e81.first_primitive)].position;
            let _e251 = p.member.map_size;
            let _e253 = (0.5f / f32(_e251));
            let _e260 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e267 = lt_math_LightPoint(vec2<f32>(_e260.uv.x, 0f), _e260.depth, _e260.is_inside);
            let _e271 = lt_math_LightPoint(_e267.uv, 0f, _e267.is_inside);
            phi_875_ = lt_math_LightPoint();
            phi_878_ = 0u;
            phi_880_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e271.uv, _e271.depth, false));
            loop {
                let _e278 = phi_875_;
                let _e280 = phi_878_;
                let _e282 = phi_880_;
                local_1 = _e282;
                local_2 = _e282;
                local_3 = _e282;
                local_4 = _e282;
                if (_e280 < _e87) {
                    if _e282.point.is_inside {
                        phi_1041_ = lt_math_LightPoint();
                        phi_1042_ = u32();
                        phi_1043_ = lt_math_LevelPoint();
                        phi_1044_ = false;
                    } else {
                        if (_e280 < _e75) {
                        } else {
                            return;
                        }
                        let _e293 = levels.member[(0u + _e280)].row_w;
                        let _e304 = ((((_e293.x * _e249.x) + (_e293.y * _e249.y)) + (_e293.z * _e249.z)) + (_e293.w * 1f));
                        let _e306 = levels.member[(0u + _e280)].row_x;
                        let _e318 = (((((_e306.x * _e249.x) + (_e306.y * _e249.y)) + (_e306.z * _e249.z)) + (_e306.w * 1f)) / _e304);
                        let _e320 = levels.member[(0u + _e280)].row_y;
                        let _e332 = (((((_e320.x * _e249.x) + (_e320.y * _e249.y)) + (_e320.z * _e249.z)) + (_e320.w * 1f)) / _e304);
                        let _e334 = levels.member[(0u + _e280)].row_z;
                        let _e345 = ((((_e334.x * _e249.x) + (_e334.y * _e249.y)) + (_e334.z * _e249.z)) + (_e334.w * 1f));
                        if (_e304 > 0f) {
                            if (_e318 >= 0f) {
                                phi_966_ = (_e318 <= 1f);
                            } else {
                                phi_966_ = false;
                            }
                            let _e350 = phi_966_;
                            if _e350 {
                                if (_e332 >= 0f) {
                                    phi_975_ = (_e332 <= 1f);
                                } else {
                                    phi_975_ = false;
                                }
                                let _e354 = phi_975_;
                                if _e354 {
                                    if (_e345 >= 0f) {
                                        phi_984_ = (_e345 <= 1f);
                                    } else {
                                        phi_984_ = false;
                                    }
                                    let _e358 = phi_984_;
                                    phi_985_ = _e358;
                                    phi_986_ = false;
                                } else {
                                    phi_985_ = bool();
                                    phi_986_ = true;
                                }
                                let _e360 = phi_985_;
                                let _e362 = phi_986_;
                                phi_987_ = _e360;
                                phi_988_ = _e362;
                            } else {
                                phi_987_ = bool();
                                phi_988_ = true;
                            }
                            let _e364 = phi_987_;
                            let _e366 = phi_988_;
                            phi_989_ = _e364;
                            phi_990_ = _e366;
                        } else {
                            phi_989_ = bool();
                            phi_990_ = true;
                        }
                        let _e368 = phi_989_;
                        let _e370 = phi_990_;
                        if _e370 {
                            phi_994_ = false;
                        } else {
                            phi_994_ = _e368;
                        }
                        let _e372 = phi_994_;
                        if _e372 {
                            if (_e318 >= _e253) {
                                if (_e318 <= (1f - _e253)) {
                                    if (_e332 >= _e253) {
                                        phi_1021_ = (_e332 <= (1f - _e253));
                                        phi_1022_ = false;
                                    } else {
                                        phi_1021_ = bool();
                                        phi_1022_ = true;
                                    }
                                    let _e380 = phi_1021_;
                                    let _e382 = phi_1022_;
                                    phi_1023_ = _e380;
                                    phi_1024_ = _e382;
                                } else {
                                    phi_1023_ = bool();
                                    phi_1024_ = true;
                                }
                                let _e384 = phi_1023_;
                                let _e386 = phi_1024_;
                                phi_1025_ = _e384;
                                phi_1026_ = _e386;
                            } else {
                                phi_1025_ = bool();
                                phi_1026_ = true;
                            }
                            let _e388 = phi_1025_;
                            let _e390 = phi_1026_;
                            phi_1027_ = _e388;
                            phi_1028_ = _e390;
                        } else {
                            phi_1027_ = bool();
                            phi_1028_ = true;
                        }
                        let _e392 = phi_1027_;
                        let _e394 = phi_1028_;
                        if _e394 {
                            phi_1032_ = false;
                        } else {
                            phi_1032_ = _e392;
                        }
                        let _e396 = phi_1032_;
                        let _e403 = lt_math_LightPoint(vec2<f32>(_e318, _e278.uv.y), _e278.depth, _e278.is_inside);
                        let _e410 = lt_math_LightPoint(vec2<f32>(_e403.uv.x, _e332), _e403.depth, _e403.is_inside);
                        let _e414 = lt_math_LightPoint(_e410.uv, _e345, _e410.is_inside);
                        let _e418 = lt_math_LightPoint(_e414.uv, _e414.depth, _e396);
                        phi_1041_ = _e418;
                        phi_1042_ = (_e280 + 1u);
                        phi_1043_ = lt_math_LevelPoint(_e280, _e418);
                        phi_1044_ = true;
                    }
                    let _e422 = phi_1041_;
                    let _e424 = phi_1042_;
                    let _e426 = phi_1043_;
                    let _e428 = phi_1044_;
                    phi_876_ = _e422;
                    phi_879_ = _e424;
                    phi_881_ = _e426;
                    phi_1045_ = _e428;
                } else {
                    phi_876_ = lt_math_LightPoint();
                    phi_879_ = u32();
                    phi_881_ = lt_math_LevelPoint();
                    phi_1045_ = false;
                }
                let _e430 = phi_876_;
                let _e432 = phi_879_;
                let _e434 = phi_881_;
                let _e436 = phi_1045_;
                continue;
                continuing {
                    phi_875_ = _e430;
                    phi_878_ = _e432;
                    phi_880_ = _e434;
                    break if !(_e436);
                }
            }
            let _e439 = local_1;
            if _e439.point.is_inside {
                if (0f > 0f) {
                    let _e445 = local_2;
                    if (_e445.level < _e75) {
                    } else {
                        return;
                    }
                    let _e450 = levels.member[(0u + _e445.level)];
                    let _e456 = global[0u];
                    if (_e450.row_w.x == _e456) {
                        let _e459 = global[1u];
                        if (_e450.row_w.y == _e459) {
                            let _e462 = global[2u];
                            phi_1085_ = (_e450.row_w.z == _e462);
                            phi_1086_ = false;
                        } else {
                            phi_1085_ = bool();
                            phi_1086_ = true;
                        }
                        let _e465 = phi_1085_;
                        let _e467 = phi_1086_;
                        phi_1087_ = _e465;
                        phi_1088_ = _e467;
                    } else {
                        phi_1087_ = bool();
                        phi_1088_ = true;
                    }
                    let _e469 = phi_1087_;
                    let _e471 = phi_1088_;
                    if _e471 {
                        phi_1092_ = false;
                    } else {
                        phi_1092_ = _e469;
                    }
                    let _e473 = phi_1092_;
                    if _e473 {
                        let _e475 = samples.member[(0u + _e81.first_primitive)].normal;
                        let _e477 = p.member.map_size;
                        let _e547 = ((abs(((((_e450.row_x.x * _e475.x) + (_e450.row_x.y * _e475.y)) + (_e450.row_x.z * _e475.z)) / (((_e450.row_x.x * _e450.row_x.x) + (_e450.row_x.y * _e450.row_x.y)) + (_e450.row_x.z * _e450.row_x.z)))) + abs(((((_e450.row_y.x * _e475.x) + (_e450.row_y.y * _e475.y)) + (_e450.row_y.z * _e475.z)) / (((_e450.row_y.x * _e450.row_y.x) + (_e450.row_y.y * _e450.row_y.y)) + (_e450.row_y.z * _e450.row_y.z))))) / (abs(((((_e450.row_z.x * _e475.x) + (_e450.row_z.y * _e475.y)) + (_e450.row_z.z * _e475.z)) / (((_e450.row_z.x * _e450.row_z.x) + (_e450.row_z.y * _e450.row_z.y)) + (_e450.row_z.z * _e450.row_z.z)))) * f32(_e477)));
                        if (_e547 < 0.002f) {
                            phi_1174_ = _e547;
                        } else {
                            phi_1174_ = 0.002f;
                        }
                        let _e550 = phi_1174_;
                        phi_1293_ = _e550;
                    } else {
                        let _e552 = p.member.map_size;
                        let _e558 = samples.member[(0u + _e81.first_primitive)].position;
                        let _e569 = ((((_e450.row_w.x * _e558.x) + (_e450.row_w.y * _e558.y)) + (_e450.row_w.z * _e558.z)) + _e450.row_w.w);
                        let _e582 = ((_e450.row_x.x - (_e450.row_w.x * _e439.point.uv.x)) / _e569);
                        let _e583 = ((_e450.row_x.y - (_e450.row_w.y * _e439.point.uv.x)) / _e569);
                        let _e584 = ((_e450.row_x.z - (_e450.row_w.z * _e439.point.uv.x)) / _e569);
                        let _e597 = ((_e450.row_y.x - (_e450.row_w.x * _e439.point.uv.y)) / _e569);
                        let _e598 = ((_e450.row_y.y - (_e450.row_w.y * _e439.point.uv.y)) / _e569);
                        let _e599 = ((_e450.row_y.z - (_e450.row_w.z * _e439.point.uv.y)) / _e569);
                        let _e605 = samples.member[(0u + _e81.first_primitive)].normal;
                        let _e610 = ((_e598 * _e605.z) - (_e605.y * _e599));
                        let _e615 = ((_e599 * _e605.x) - (_e605.z * _e597));
                        let _e620 = ((_e597 * _e605.y) - (_e605.x * _e598));
                        let _e622 = samples.member[(0u + _e81.first_primitive)].normal;
                        let _e627 = ((_e583 * _e622.z) - (_e622.y * _e584));
                        let _e632 = ((_e584 * _e622.x) - (_e622.z * _e582));
                        let _e637 = ((_e582 * _e622.y) - (_e622.x * _e583));
                        let _e664 = ((abs(((((_e450.row_z.x * _e610) + (_e450.row_z.y * _e615)) + (_e450.row_z.z * _e620)) / (((_e582 * _e610) + (_e583 * _e615)) + (_e584 * _e620)))) + abs(((((_e450.row_z.x * _e627) + (_e450.row_z.y * _e632)) + (_e450.row_z.z * _e637)) / (((_e597 * _e627) + (_e598 * _e632)) + (_e599 * _e637))))) / f32(_e552));
                        let _e666 = (16f / f32(_e552));
                        if (_e664 < _e666) {
                            phi_1292_ = _e664;
                        } else {
                            phi_1292_ = _e666;
                        }
                        let _e669 = phi_1292_;
                        phi_1293_ = _e669;
                    }
                    let _e671 = phi_1293_;
                    phi_1296_ = (_e439.point.depth - (0f * _e671));
                } else {
                    phi_1296_ = _e439.point.depth;
                }
                let _e675 = phi_1296_;
                let _e681 = p.member.map_size;
                let _e682 = f32(_e681);
                let _e685 = ((_e439.point.uv.x * _e682) - 0.5f);
                let _e686 = ((_e439.point.uv.y * _e682) - 0.5f);
                if (_e685 > -8388608f) {
                    let _e698 = f32(select(0i, select(select(i32(_e685), i32(-2147483648), (_e685 < bitcast<f32>(3472883712u))), 2147483647i, (_e685 > bitcast<f32>(1325400063u))), (_e685 == _e685)));
                    if (_e698 > _e685) {
                        phi_1325_ = 1f;
                    } else {
                        phi_1325_ = 0f;
                    }
                    let _e701 = phi_1325_;
                    if (_e685 < 8388608f) {
                        phi_1330_ = (_e698 - _e701);
                        phi_1331_ = false;
                    } else {
                        phi_1330_ = f32();
                        phi_1331_ = true;
                    }
                    let _e704 = phi_1330_;
                    let _e706 = phi_1331_;
                    phi_1332_ = _e704;
                    phi_1333_ = _e706;
                } else {
                    phi_1332_ = f32();
                    phi_1333_ = true;
                }
                let _e708 = phi_1332_;
                let _e710 = phi_1333_;
                if _e710 {
                    phi_1337_ = _e685;
                } else {
                    phi_1337_ = _e708;
                }
                let _e712 = phi_1337_;
                if (_e686 > -8388608f) {
                    let _e724 = f32(select(0i, select(select(i32(_e686), i32(-2147483648), (_e686 < bitcast<f32>(3472883712u))), 2147483647i, (_e686 > bitcast<f32>(1325400063u))), (_e686 == _e686)));
                    if (_e724 > _e686) {
                        phi_1357_ = 1f;
                    } else {
                        phi_1357_ = 0f;
                    }
                    let _e727 = phi_1357_;
                    if (_e686 < 8388608f) {
                        phi_1362_ = (_e724 - _e727);
                        phi_1363_ = false;
                    } else {
                        phi_1362_ = f32();
                        phi_1363_ = true;
                    }
                    let _e730 = phi_1362_;
                    let _e732 = phi_1363_;
                    phi_1364_ = _e730;
                    phi_1365_ = _e732;
                } else {
                    phi_1364_ = f32();
                    phi_1365_ = true;
                }
                let _e734 = phi_1364_;
                let _e736 = phi_1365_;
                if _e736 {
                    phi_1369_ = _e686;
                } else {
                    phi_1369_ = _e734;
                }
                let _e738 = phi_1369_;
                let _e739 = (_e685 - _e712);
                let _e740 = (_e686 - _e738);
                let _e749 = select(0i, select(select(i32(_e712), i32(-2147483648), (_e712 < bitcast<f32>(3472883712u))), 2147483647i, (_e712 > bitcast<f32>(1325400063u))), (_e712 == _e712));
                let _e758 = select(0i, select(select(i32(_e738), i32(-2147483648), (_e738 < bitcast<f32>(3472883712u))), 2147483647i, (_e738 > bitcast<f32>(1325400063u))), (_e738 == _e738));
                let _e769 = p.member.test;
                let _e770 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e769);
                let _e772 = p.member.map_size;
                let _e774 = local_3;
                local = _e770;
                let _e777 = ((_e774.level * _e772) * _e772);
                let _e779 = (bitcast<i32>(_e772) - 1i);
                if (_e749 > 0i) {
                    phi_1420_ = _e749;
                } else {
                    phi_1420_ = 0i;
                }
                let _e782 = phi_1420_;
                if (_e758 > 0i) {
                    phi_1425_ = _e758;
                } else {
                    phi_1425_ = 0i;
                }
                let _e785 = phi_1425_;
                if (_e782 < _e779) {
                    phi_1430_ = _e782;
                } else {
                    phi_1430_ = _e779;
                }
                let _e788 = phi_1430_;
                if (_e785 < _e779) {
                    phi_1435_ = _e785;
                } else {
                    phi_1435_ = _e779;
                }
                let _e791 = phi_1435_;
                let _e792 = bitcast<u32>(_e788);
                let _e794 = (_e749 + 1i);
                let _e795 = (_e758 + 1i);
                if (_e794 > 0i) {
                    phi_1444_ = _e794;
                } else {
                    phi_1444_ = 0i;
                }
                let _e798 = phi_1444_;
                if (_e795 > 0i) {
                    phi_1449_ = _e795;
                } else {
                    phi_1449_ = 0i;
                }
                let _e801 = phi_1449_;
                if (_e798 < _e779) {
                    phi_1454_ = _e798;
                } else {
                    phi_1454_ = _e779;
                }
                let _e804 = phi_1454_;
                if (_e801 < _e779) {
                    phi_1459_ = _e801;
                } else {
                    phi_1459_ = _e779;
                }
                let _e807 = phi_1459_;
                let _e808 = bitcast<u32>(_e804);
                let _e810 = (bitcast<u32>(_e791) * _e772);
                let _e811 = (bitcast<u32>(_e807) * _e772);
                let _e816 = ((_e810 + _e792) + _e777);
                let _e817 = ((_e810 + _e808) + _e777);
                let _e818 = ((_e811 + _e792) + _e777);
                let _e819 = ((_e811 + _e808) + _e777);
                if (_e816 < _e66) {
                } else {
                    return;
                }
                let _e823 = map.member[(0u + _e816)];
                if (_e817 < _e66) {
                } else {
                    return;
                }
                let _e827 = map.member[(0u + _e817)];
                if (_e818 < _e66) {
                } else {
                    return;
                }
                let _e831 = map.member[(0u + _e818)];
                if (_e819 < _e66) {
                } else {
                    return;
                }
                let _e835 = map.member[(0u + _e819)];
                let _e837 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e823, _e827, _e831, _e835), vec4<f32>(((1f - _e739) * (1f - _e740)), (_e739 * (1f - _e740)), ((1f - _e739) * _e740), (_e739 * _e740)), _e675);
                let _e839 = p.member.map_size;
                let _e841 = local_4;
                let _e844 = (bitcast<i32>(_e839) - 1i);
                if (_e749 > 0i) {
                    phi_1515_ = _e749;
                } else {
                    phi_1515_ = 0i;
                }
                let _e847 = phi_1515_;
                if (_e758 > 0i) {
                    phi_1520_ = _e758;
                } else {
                    phi_1520_ = 0i;
                }
                let _e850 = phi_1520_;
                if (_e847 < _e844) {
                    phi_1525_ = _e847;
                } else {
                    phi_1525_ = _e844;
                }
                let _e853 = phi_1525_;
                if (_e850 < _e844) {
                    phi_1530_ = _e850;
                } else {
                    phi_1530_ = _e844;
                }
                let _e856 = phi_1530_;
                let _e857 = bitcast<u32>(_e853);
                let _e864 = ((((_e841.level * _e839) + bitcast<u32>(_e856)) * (_e839 / 16u)) + (_e857 / 16u));
                let _e867 = (_e749 + 1i);
                let _e868 = (_e758 + 0i);
                let _e870 = (bitcast<i32>(_e839) - 1i);
                if (_e867 > 0i) {
                    phi_1549_ = _e867;
                } else {
                    phi_1549_ = 0i;
                }
                let _e873 = phi_1549_;
                if (_e868 > 0i) {
                    phi_1554_ = _e868;
                } else {
                    phi_1554_ = 0i;
                }
                let _e876 = phi_1554_;
                if (_e873 < _e870) {
                    phi_1559_ = _e873;
                } else {
                    phi_1559_ = _e870;
                }
                let _e879 = phi_1559_;
                if (_e876 < _e870) {
                    phi_1564_ = _e876;
                } else {
                    phi_1564_ = _e870;
                }
                let _e882 = phi_1564_;
                let _e883 = bitcast<u32>(_e879);
                let _e890 = ((((_e841.level * _e839) + bitcast<u32>(_e882)) * (_e839 / 16u)) + (_e883 / 16u));
                let _e893 = (_e749 + 0i);
                let _e894 = (_e758 + 1i);
                let _e896 = (bitcast<i32>(_e839) - 1i);
                if (_e893 > 0i) {
                    phi_1583_ = _e893;
                } else {
                    phi_1583_ = 0i;
                }
                let _e899 = phi_1583_;
                if (_e894 > 0i) {
                    phi_1588_ = _e894;
                } else {
                    phi_1588_ = 0i;
                }
                let _e902 = phi_1588_;
                if (_e899 < _e896) {
                    phi_1593_ = _e899;
                } else {
                    phi_1593_ = _e896;
                }
                let _e905 = phi_1593_;
                if (_e902 < _e896) {
                    phi_1598_ = _e902;
                } else {
                    phi_1598_ = _e896;
                }
                let _e908 = phi_1598_;
                let _e909 = bitcast<u32>(_e905);
                let _e916 = ((((_e841.level * _e839) + bitcast<u32>(_e908)) * (_e839 / 16u)) + (_e909 / 16u));
                let _e919 = (_e749 + 1i);
                let _e920 = (_e758 + 1i);
                let _e922 = (bitcast<i32>(_e839) - 1i);
                if (_e919 > 0i) {
                    phi_1617_ = _e919;
                } else {
                    phi_1617_ = 0i;
                }
                let _e925 = phi_1617_;
                if (_e920 > 0i) {
                    phi_1622_ = _e920;
                } else {
                    phi_1622_ = 0i;
                }
                let _e928 = phi_1622_;
                if (_e925 < _e922) {
                    phi_1627_ = _e925;
                } else {
                    phi_1627_ = _e922;
                }
                let _e931 = phi_1627_;
                if (_e928 < _e922) {
                    phi_1632_ = _e928;
                } else {
                    phi_1632_ = _e922;
                }
                let _e934 = phi_1632_;
                let _e935 = bitcast<u32>(_e931);
                let _e942 = ((((_e841.level * _e839) + bitcast<u32>(_e934)) * (_e839 / 16u)) + (_e935 / 16u));
                if (_e864 < _e72) {
                } else {
                    return;
                }
                let _e948 = marks.member[(0u + _e864)];
                if (_e890 < _e72) {
                } else {
                    return;
                }
                let _e956 = marks.member[(0u + _e890)];
                if (_e916 < _e72) {
                } else {
                    return;
                }
                let _e965 = marks.member[(0u + _e916)];
                if (_e942 < _e72) {
                } else {
                    return;
                }
                let _e973 = marks.member[(0u + _e942)];
                let _e981 = p.member.epsilon;
                if (_e837 <= _e981) {
                    phi_1710_ = true;
                } else {
                    phi_1710_ = (_e837 >= (1f - _e981));
                }
                let _e986 = phi_1710_;
                if ((bitcast<u32>(_e837) & 2147483647u) > 2139095040u) {
                    phi_1718_ = true;
                } else {
                    phi_1718_ = !(_e986);
                }
                let _e992 = phi_1718_;
                if _e992 {
                    if (_e837 > 0f) {
                        if (_e837 < 1f) {
                            phi_1730_ = false;
                        } else {
                            phi_1730_ = true;
                        }
                        let _e996 = phi_1730_;
                        phi_1731_ = _e996;
                    } else {
                        phi_1731_ = true;
                    }
                    let _e998 = phi_1731_;
                    if _e998 {
                        phi_1735_ = 0.5f;
                    } else {
                        phi_1735_ = _e837;
                    }
                    let _e1000 = phi_1735_;
                    phi_1743_ = evaluate_Verdict(_e1000, true);
                } else {
                    if (_e837 > 0.5f) {
                        phi_1741_ = 1f;
                    } else {
                        phi_1741_ = 0f;
                    }
                    let _e1004 = phi_1741_;
                    phi_1743_ = evaluate_Verdict(_e1004, false);
                }
                let _e1007 = phi_1743_;
                let _e1010 = (_e1007.visibility < 0.5f);
                if _e1007.is_doubted {
                    phi_1766_ = evaluate_Verdict();
                    phi_1767_ = true;
                } else {
                    if _e1010 {
                        phi_1753_ = 2u;
                    } else {
                        phi_1753_ = 1u;
                    }
                    let _e1012 = phi_1753_;
                    if ((((((_e948 >> bitcast<u32>((((_e857 % 16u) * 2u) & 31u))) & 3u) | ((_e956 >> bitcast<u32>((((_e883 % 16u) * 2u) & 31u))) & 3u)) | (((_e965 >> bitcast<u32>((((_e909 % 16u) * 2u) & 31u))) & 3u) | ((_e973 >> bitcast<u32>((((_e935 % 16u) * 2u) & 31u))) & 3u))) & _e1012) != 0u) {
                        if _e1010 {
                            phi_1762_ = 0.000000059604645f;
                        } else {
                            phi_1762_ = 0.99999994f;
                        }
                        let _e1016 = phi_1762_;
                        phi_1764_ = evaluate_Verdict(_e1016, true);
                        phi_1765_ = false;
                    } else {
                        phi_1764_ = evaluate_Verdict();
                        phi_1765_ = true;
                    }
                    let _e1019 = phi_1764_;
                    let _e1021 = phi_1765_;
                    phi_1766_ = _e1019;
                    phi_1767_ = _e1021;
                }
                let _e1023 = phi_1766_;
                let _e1025 = phi_1767_;
                if _e1025 {
                    phi_1772_ = evaluate_Verdict(_e1007.visibility, _e1007.is_doubted);
                } else {
                    phi_1772_ = _e1023;
                }
                let _e1028 = phi_1772_;
                phi_1777_ = evaluate_Verdict(_e1028.visibility, _e1028.is_doubted);
            } else {
                phi_1777_ = evaluate_Verdict(0.5f, true);
            }
            let _e1034 = phi_1777_;
            phi_1778_ = _e1034;
        }
        let _e1036 = phi_1778_;
        if (_e81.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e81.first_primitive)] = _e1036.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_levels_marks_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
