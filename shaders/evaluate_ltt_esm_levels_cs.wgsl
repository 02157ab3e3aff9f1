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

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_45 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
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
var<storage> levels: type_45;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_172_: lt_bvh_traverse_Tree;
    var phi_173_: bool;
    var phi_174_: lt_bvh_traverse_Tree;
    var phi_175_: bool;
    var phi_180_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_172_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_173_ = false;
        } else {
            phi_172_ = lt_bvh_traverse_Tree();
            phi_173_ = true;
        }
        let _e69 = phi_172_;
        let _e71 = phi_173_;
        phi_174_ = _e69;
        phi_175_ = _e71;
    } else {
        phi_174_ = lt_bvh_traverse_Tree();
        phi_175_ = true;
    }
    let _e73 = phi_174_;
    let _e75 = phi_175_;
    if _e75 {
        phi_180_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_180_ = _e73;
    }
    let _e80 = phi_180_;
    return lt_bvh_traverse_Tree(_e80.root, _e80.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_203_: bool;
    var phi_207_: f32;
    var phi_222_: f32;
    var phi_223_: f32;
    var phi_224_: f32;
    var phi_240_: f32;
    var phi_241_: f32;
    var phi_242_: f32;
    var phi_258_: f32;
    var phi_259_: f32;
    var phi_260_: f32;
    var phi_276_: f32;
    var phi_277_: f32;
    var phi_278_: f32;
    var phi_294_: f32;
    var phi_295_: f32;
    var phi_296_: f32;
    var phi_315_: f32;
    var phi_320_: f32;
    var phi_342_: f32;
    var phi_347_: f32;
    var phi_348_: bool;
    var phi_349_: f32;
    var phi_350_: bool;
    var phi_354_: f32;
    var phi_392_: f32;
    var phi_403_: f32;
    var phi_408_: f32;
    var phi_430_: f32;
    var phi_435_: f32;
    var phi_436_: bool;
    var phi_437_: f32;
    var phi_438_: bool;
    var phi_442_: f32;
    var phi_480_: f32;
    var phi_491_: f32;
    var phi_496_: f32;
    var phi_518_: f32;
    var phi_523_: f32;
    var phi_524_: bool;
    var phi_525_: f32;
    var phi_526_: bool;
    var phi_530_: f32;
    var phi_568_: f32;
    var phi_579_: f32;
    var phi_584_: f32;
    var phi_606_: f32;
    var phi_611_: f32;
    var phi_612_: bool;
    var phi_613_: f32;
    var phi_614_: bool;
    var phi_618_: f32;
    var phi_656_: f32;
    var phi_682_: f32;
    var phi_683_: f32;
    var phi_684_: f32;

    let _e60 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_203_ = true;
    } else {
        let _e64 = (84f < _e60);
        if _e64 {
        }
        phi_203_ = _e64;
    }
    let _e66 = phi_203_;
    if _e66 {
        phi_207_ = 84f;
    } else {
        phi_207_ = _e60;
    }
    let _e68 = phi_207_;
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_224_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_223_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_222_ = 1f;
            } else {
                phi_222_ = param_7;
            }
            let _e75 = phi_222_;
            phi_223_ = _e75;
        }
        let _e77 = phi_223_;
        phi_224_ = _e77;
    }
    let _e79 = phi_224_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_242_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_241_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_240_ = 1f;
            } else {
                phi_240_ = param_5.x;
            }
            let _e87 = phi_240_;
            phi_241_ = _e87;
        }
        let _e89 = phi_241_;
        phi_242_ = _e89;
    }
    let _e91 = phi_242_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_260_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_259_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_258_ = 1f;
            } else {
                phi_258_ = param_5.y;
            }
            let _e99 = phi_258_;
            phi_259_ = _e99;
        }
        let _e101 = phi_259_;
        phi_260_ = _e101;
    }
    let _e103 = phi_260_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_278_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_277_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_276_ = 1f;
            } else {
                phi_276_ = param_5.z;
            }
            let _e111 = phi_276_;
            phi_277_ = _e111;
        }
        let _e113 = phi_277_;
        phi_278_ = _e113;
    }
    let _e115 = phi_278_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_296_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_295_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_294_ = 1f;
            } else {
                phi_294_ = param_5.w;
            }
            let _e123 = phi_294_;
            phi_295_ = _e123;
        }
        let _e125 = phi_295_;
        phi_296_ = _e125;
    }
    let _e127 = phi_296_;
    let _e132 = (_e68 * (_e91 - _e79));
    let _e133 = (_e68 * (_e103 - _e79));
    let _e134 = (_e68 * (_e115 - _e79));
    let _e135 = (_e68 * (_e127 - _e79));
    if ((bitcast<u32>(_e132) & 2147483647u) > 2139095040u) {
        phi_392_ = _e132;
    } else {
        if (_e132 < -87f) {
            phi_315_ = -87f;
        } else {
            phi_315_ = _e132;
        }
        let _e141 = phi_315_;
        if (_e141 > 88f) {
            phi_320_ = 88f;
        } else {
            phi_320_ = _e141;
        }
        let _e144 = phi_320_;
        let _e146 = ((_e144 * 1.442695f) + 0.5f);
        if (_e146 > -8388608f) {
            let _e158 = f32(select(0i, select(select(i32(_e146), i32(-2147483648), (_e146 < bitcast<f32>(3472883712u))), 2147483647i, (_e146 > bitcast<f32>(1325400063u))), (_e146 == _e146)));
            if (_e158 > _e146) {
                phi_342_ = 1f;
            } else {
                phi_342_ = 0f;
            }
            let _e161 = phi_342_;
            if (_e146 < 8388608f) {
                phi_347_ = (_e158 - _e161);
                phi_348_ = false;
            } else {
                phi_347_ = f32();
                phi_348_ = true;
            }
            let _e164 = phi_347_;
            let _e166 = phi_348_;
            phi_349_ = _e164;
            phi_350_ = _e166;
        } else {
            phi_349_ = f32();
            phi_350_ = true;
        }
        let _e168 = phi_349_;
        let _e170 = phi_350_;
        if _e170 {
            phi_354_ = _e146;
        } else {
            phi_354_ = _e168;
        }
        let _e172 = phi_354_;
        let _e176 = ((_e144 - (_e172 * 0.69314575f)) - (_e172 * 0.0000014286068f));
        phi_392_ = ((((((((((((((((1f / 5040f) * _e176) + (1f / 720f)) * _e176) + (1f / 120f)) * _e176) + (1f / 24f)) * _e176) + (1f / 6f)) * _e176) + 0.5f) * _e176) + 1f) * _e176) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e172), i32(-2147483648), (_e172 < bitcast<f32>(3472883712u))), 2147483647i, (_e172 > bitcast<f32>(1325400063u))), (_e172 == _e172)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e212 = phi_392_;
    if ((bitcast<u32>(_e133) & 2147483647u) > 2139095040u) {
        phi_480_ = _e133;
    } else {
        if (_e133 < -87f) {
            phi_403_ = -87f;
        } else {
            phi_403_ = _e133;
        }
        let _e218 = phi_403_;
        if (_e218 > 88f) {
            phi_408_ = 88f;
        } else {
            phi_408_ = _e218;
        }
        let _e221 = phi_408_;
        let _e223 = ((_e221 * 1.442695f) + 0.5f);
        if (_e223 > -8388608f) {
            let _e235 = f32(select(0i, select(select(i32(_e223), i32(-2147483648), (_e223 < bitcast<f32>(3472883712u))), 2147483647i, (_e223 > bitcast<f32>(1325400063u))), (_e223 == _e223)));
            if (_e235 > _e223) {
                phi_430_ = 1f;
            } else {
                phi_430_ = 0f;
            }
            let _e238 = phi_430_;
            if (_e223 < 8388608f) {
                phi_435_ = (_e235 - _e238);
                phi_436_ = false;
            } else {
                phi_435_ = f32();
                phi_436_ = true;
            }
            let _e241 = phi_435_;
            let _e243 = phi_436_;
            phi_437_ = _e241;
            phi_438_ = _e243;
        } else {
            phi_437_ = f32();
            phi_438_ = true;
        }
        let _e245 = phi_437_;
        let _e247 = phi_438_;
        if _e247 {
            phi_442_ = _e223;
        } else {
            phi_442_ = _e245;
        }
        let _e249 = phi_442_;
        let _e253 = ((_e221 - (_e249 * 0.69314575f)) - (_e249 * 0.0000014286068f));
        phi_480_ = ((((((((((((((((1f / 5040f) * _e253) + (1f / 720f)) * _e253) + (1f / 120f)) * _e253) + (1f / 24f)) * _e253) + (1f / 6f)) * _e253) + 0.5f) * _e253) + 1f) * _e253) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e249), i32(-2147483648), (_e249 < bitcast<f32>(3472883712u))), 2147483647i, (_e249 > bitcast<f32>(1325400063u))), (_e249 == _e249)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e289 = phi_480_;
    if ((bitcast<u32>(_e134) & 2147483647u) > 2139095040u) {
        phi_568_ = _e134;
    } else {
        if (_e134 < -87f) {
            phi_491_ = -87f;
        } else {
            phi_491_ = _e134;
        }
        let _e295 = phi_491_;
        if (_e295 > 88f) {
            phi_496_ = 88f;
        } else {
            phi_496_ = _e295;
        }
        let _e298 = phi_496_;
        let _e300 = ((_e298 * 1.442695f) + 0.5f);
        if (_e300 > -8388608f) {
            let _e312 = f32(select(0i, select(select(i32(_e300), i32(-2147483648), (_e300 < bitcast<f32>(3472883712u))), 2147483647i, (_e300 > bitcast<f32>(1325400063u))), (_e300 == _e300)));
            if (_e312 > _e300) {
                phi_518_ = 1f;
            } else {
                phi_518_ = 0f;
            }
            let _e315 = phi_518_;
            if (_e300 < 8388608f) {
                phi_523_ = (_e312 - _e315);
                phi_524_ = false;
            } else {
                phi_523_ = f32();
                phi_524_ = true;
            }
            let _e318 = phi_523_;
            let _e320 = phi_524_;
            phi_525_ = _e318;
            phi_526_ = _e320;
        } else {
            phi_525_ = f32();
            phi_526_ = true;
        }
        let _e322 = phi_525_;
        let _e324 = phi_526_;
        if _e324 {
            phi_530_ = _e300;
        } else {
            phi_530_ = _e322;
        }
        let _e326 = phi_530_;
        let _e330 = ((_e298 - (_e326 * 0.69314575f)) - (_e326 * 0.0000014286068f));
        phi_568_ = ((((((((((((((((1f / 5040f) * _e330) + (1f / 720f)) * _e330) + (1f / 120f)) * _e330) + (1f / 24f)) * _e330) + (1f / 6f)) * _e330) + 0.5f) * _e330) + 1f) * _e330) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e326), i32(-2147483648), (_e326 < bitcast<f32>(3472883712u))), 2147483647i, (_e326 > bitcast<f32>(1325400063u))), (_e326 == _e326)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e366 = phi_568_;
    if ((bitcast<u32>(_e135) & 2147483647u) > 2139095040u) {
        phi_656_ = _e135;
    } else {
        if (_e135 < -87f) {
            phi_579_ = -87f;
        } else {
            phi_579_ = _e135;
        }
        let _e372 = phi_579_;
        if (_e372 > 88f) {
            phi_584_ = 88f;
        } else {
            phi_584_ = _e372;
        }
        let _e375 = phi_584_;
        let _e377 = ((_e375 * 1.442695f) + 0.5f);
        if (_e377 > -8388608f) {
            let _e389 = f32(select(0i, select(select(i32(_e377), i32(-2147483648), (_e377 < bitcast<f32>(3472883712u))), 2147483647i, (_e377 > bitcast<f32>(1325400063u))), (_e377 == _e377)));
            if (_e389 > _e377) {
                phi_606_ = 1f;
            } else {
                phi_606_ = 0f;
            }
            let _e392 = phi_606_;
            if (_e377 < 8388608f) {
                phi_611_ = (_e389 - _e392);
                phi_612_ = false;
            } else {
                phi_611_ = f32();
                phi_612_ = true;
            }
            let _e395 = phi_611_;
            let _e397 = phi_612_;
            phi_613_ = _e395;
            phi_614_ = _e397;
        } else {
            phi_613_ = f32();
            phi_614_ = true;
        }
        let _e399 = phi_613_;
        let _e401 = phi_614_;
        if _e401 {
            phi_618_ = _e377;
        } else {
            phi_618_ = _e399;
        }
        let _e403 = phi_618_;
        let _e407 = ((_e375 - (_e403 * 0.69314575f)) - (_e403 * 0.0000014286068f));
        phi_656_ = ((((((((((((((((1f / 5040f) * _e407) + (1f / 720f)) * _e407) + (1f / 120f)) * _e407) + (1f / 24f)) * _e407) + (1f / 6f)) * _e407) + 0.5f) * _e407) + 1f) * _e407) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e403), i32(-2147483648), (_e403 < bitcast<f32>(3472883712u))), 2147483647i, (_e403 > bitcast<f32>(1325400063u))), (_e403 == _e403)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e443 = phi_656_;
    let _e454 = ((((_e212 * param_6.x) + (_e289 * param_6.y)) + (_e366 * param_6.z)) + (_e443 * param_6.w));
    if ((bitcast<u32>(_e454) & 2147483647u) > 2139095040u) {
        phi_684_ = _e454;
    } else {
        if (_e454 < 0f) {
            phi_683_ = 0f;
        } else {
            if (_e454 > 1f) {
                phi_682_ = 1f;
            } else {
                phi_682_ = _e454;
            }
            let _e461 = phi_682_;
            phi_683_ = _e461;
        }
        let _e463 = phi_683_;
        phi_684_ = _e463;
    }
    let _e465 = phi_684_;
    return _e465;
}

fn function_() {
    var local_1: f32;
    var phi_739_: bool;
    var phi_740_: bool;
    var phi_741_: bool;
    var phi_742_: bool;
    var phi_746_: bool;
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_828_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_829_: bool;
    var phi_830_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_831_: bool;
    var phi_838_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_842_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_862_: lt_math_LightPoint;
    var phi_865_: u32;
    var phi_867_: lt_math_LevelPoint;
    var phi_953_: bool;
    var phi_962_: bool;
    var phi_971_: bool;
    var phi_972_: bool;
    var phi_973_: bool;
    var phi_974_: bool;
    var phi_975_: bool;
    var phi_976_: bool;
    var phi_977_: bool;
    var phi_981_: bool;
    var phi_1008_: bool;
    var phi_1009_: bool;
    var phi_1010_: bool;
    var phi_1011_: bool;
    var phi_1012_: bool;
    var phi_1013_: bool;
    var phi_1014_: bool;
    var phi_1015_: bool;
    var phi_1019_: bool;
    var phi_1028_: lt_math_LightPoint;
    var phi_1029_: u32;
    var phi_1030_: lt_math_LevelPoint;
    var phi_1031_: bool;
    var phi_863_: lt_math_LightPoint;
    var phi_866_: u32;
    var phi_868_: lt_math_LevelPoint;
    var phi_1032_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1072_: bool;
    var phi_1073_: bool;
    var phi_1074_: bool;
    var phi_1075_: bool;
    var phi_1079_: bool;
    var phi_1161_: f32;
    var phi_1279_: f32;
    var phi_1280_: f32;
    var phi_1283_: f32;
    var phi_1312_: f32;
    var phi_1317_: f32;
    var phi_1318_: bool;
    var phi_1319_: f32;
    var phi_1320_: bool;
    var phi_1324_: f32;
    var phi_1344_: f32;
    var phi_1349_: f32;
    var phi_1350_: bool;
    var phi_1351_: f32;
    var phi_1352_: bool;
    var phi_1356_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1405_: i32;
    var phi_1410_: i32;
    var phi_1415_: i32;
    var phi_1420_: i32;
    var phi_1429_: i32;
    var phi_1434_: i32;
    var phi_1439_: i32;
    var phi_1444_: i32;
    var phi_1495_: bool;
    var phi_1503_: bool;
    var phi_1515_: bool;
    var phi_1516_: bool;
    var phi_1520_: f32;
    var phi_1526_: f32;
    var phi_1528_: evaluate_Verdict;
    var phi_1533_: evaluate_Verdict;
    var phi_1534_: evaluate_Verdict;
    var phi_1538_: bool;
    var phi_1539_: u32;
    var phi_1550_: u32;

    let _e57 = id_1;
    let _e58 = local_5;
    let _e63 = arrayLength((&map.member));
    let _e68 = arrayLength((&levels.member));
    let _e71 = p.member.size[0u];
    let _e73 = p.member.size[1u];
    let _e74 = lt_shaders_entry_pixel_index(_e57, _e71, _e73);
    if (bitcast<i32>(_e74.root) != 0i) {
        let _e81 = p.member.level_count;
        let _e85 = samples.member[_e74.first_primitive].normal[0u];
        let _e87 = global[0u];
        if (_e85 == _e87) {
            let _e90 = samples.member[_e74.first_primitive].normal[1u];
            let _e92 = global[1u];
            if (_e90 == _e92) {
                let _e95 = samples.member[_e74.first_primitive].normal[2u];
                let _e97 = global[2u];
                phi_739_ = (_e95 == _e97);
                phi_740_ = false;
            } else {
                phi_739_ = bool();
                phi_740_ = true;
            }
            let _e100 = phi_739_;
            let _e102 = phi_740_;
            phi_741_ = _e100;
            phi_742_ = _e102;
        } else {
            phi_741_ = bool();
            phi_742_ = true;
        }
        let _e104 = phi_741_;
        let _e106 = phi_742_;
        if _e106 {
            phi_746_ = false;
        } else {
            phi_746_ = _e104;
        }
        let _e108 = phi_746_;
        if !(_e108) {
            let _e111 = samples.member[_e74.first_primitive].position;
            let _e113 = p.member.light.place;
            let _e119 = p.member.light.place[3u];
            let _e126 = (_e113.x - (_e111.x * _e119));
            let _e127 = (_e113.y - (_e111.y * _e119));
            let _e128 = (_e113.z - (_e111.z * _e119));
            let _e130 = samples.member[_e74.first_primitive].normal;
            if ((((_e130.x * _e126) + (_e130.y * _e127)) + (_e130.z * _e128)) > 0f) {
                let _e144 = (((_e126 * _e126) + (_e127 * _e127)) + (_e128 * _e128));
                let _e146 = p.member.light.axis;
                let _e158 = p.member.light.place[3u];
                if (_e158 == 0f) {
                    phi_817_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_816_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_816_ = false;
                    }
                    let _e169 = phi_816_;
                    phi_817_ = _e169;
                }
                let _e171 = phi_817_;
                if _e171 {
                    let _e173 = samples.member[_e74.first_primitive].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_828_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_829_ = false;
                } else {
                    phi_828_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_829_ = true;
                }
                let _e192 = phi_828_;
                let _e194 = phi_829_;
                phi_830_ = _e192;
                phi_831_ = _e194;
            } else {
                phi_830_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_831_ = true;
            }
            let _e196 = phi_830_;
            let _e198 = phi_831_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_838_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_838_ = _e196;
            }
            let _e215 = phi_838_;
            phi_842_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_842_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_842_;
        if _e232.unnamed_1 {
            phi_1534_ = evaluate_Verdict(_e232.unnamed.visibility, _e232.unnamed.is_doubted);
        } else {
            let _e240 = samples.member[_e74.first_primitive].position;
            let _e242 = p.member.map_size;
            let _e244 = (0.5f / f32(_e242));
            let _e251 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e258 = lt_math_LightPoint(vec2<f32>(_e251.uv.x, 0f), _e251.depth, _e251.is_inside);
            let _e262 = lt_math_LightPoint(_e258.uv, 0f, _e258.is_inside);
            phi_862_ = lt_math_LightPoint();
            phi_865_ = 0u;
            phi_867_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e262.uv, _e262.depth, false));
            loop {
                let _e269 = phi_862_;
                let _e271 = phi_865_;
                let _e273 = phi_867_;
                local_2 = _e273;
                local_3 = _e273;
                local_4 = _e273;
                if (_e271 < _e81) {
                    if _e273.point.is_inside {
                        phi_1028_ = lt_math_LightPoint();
                        phi_1029_ = u32();
                        phi_1030_ = lt_math_LevelPoint();
                        phi_1031_ = false;
                    } else {
                        if (_e271 < _e68) {
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
                                phi_953_ = (_e309 <= 1f);
                            } else {
                                phi_953_ = false;
                            }
                            let _e341 = phi_953_;
                            if _e341 {
                                if (_e323 >= 0f) {
                                    phi_962_ = (_e323 <= 1f);
                                } else {
                                    phi_962_ = false;
                                }
                                let _e345 = phi_962_;
                                if _e345 {
                                    if (_e336 >= 0f) {
                                        phi_971_ = (_e336 <= 1f);
                                    } else {
                                        phi_971_ = false;
                                    }
                                    let _e349 = phi_971_;
                                    phi_972_ = _e349;
                                    phi_973_ = false;
                                } else {
                                    phi_972_ = bool();
                                    phi_973_ = true;
                                }
                                let _e351 = phi_972_;
                                let _e353 = phi_973_;
                                phi_974_ = _e351;
                                phi_975_ = _e353;
                            } else {
                                phi_974_ = bool();
                                phi_975_ = true;
                            }
                            let _e355 = phi_974_;
                            let _e357 = phi_975_;
                            phi_976_ = _e355;
                            phi_977_ = _e357;
                        } else {
                            phi_976_ = bool();
                            phi_977_ = true;
                        }
                        let _e359 = phi_976_;
                        let _e361 = phi_977_;
                        if _e361 {
                            phi_981_ = false;
                        } else {
                            phi_981_ = _e359;
                        }
                        let _e363 = phi_981_;
                        if _e363 {
                            if (_e309 >= _e244) {
                                if (_e309 <= (1f - _e244)) {
                                    if (_e323 >= _e244) {
                                        phi_1008_ = (_e323 <= (1f - _e244));
                                        phi_1009_ = false;
                                    } else {
                                        phi_1008_ = bool();
                                        phi_1009_ = true;
                                    }
                                    let _e371 = phi_1008_;
                                    let _e373 = phi_1009_;
                                    phi_1010_ = _e371;
                                    phi_1011_ = _e373;
                                } else {
                                    phi_1010_ = bool();
                                    phi_1011_ = true;
                                }
                                let _e375 = phi_1010_;
                                let _e377 = phi_1011_;
                                phi_1012_ = _e375;
                                phi_1013_ = _e377;
                            } else {
                                phi_1012_ = bool();
                                phi_1013_ = true;
                            }
                            let _e379 = phi_1012_;
                            let _e381 = phi_1013_;
                            phi_1014_ = _e379;
                            phi_1015_ = _e381;
                        } else {
                            phi_1014_ = bool();
                            phi_1015_ = true;
                        }
                        let _e383 = phi_1014_;
                        let _e385 = phi_1015_;
                        if _e385 {
                            phi_1019_ = false;
                        } else {
                            phi_1019_ = _e383;
                        }
                        let _e387 = phi_1019_;
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e309, _e269.uv.y), _e269.depth, _e269.is_inside);
                        let _e401 = lt_math_LightPoint(vec2<f32>(_e394.uv.x, _e323), _e394.depth, _e394.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e336, _e401.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e405.depth, _e387);
                        phi_1028_ = _e409;
                        phi_1029_ = (_e271 + 1u);
                        phi_1030_ = lt_math_LevelPoint(_e271, _e409);
                        phi_1031_ = true;
                    }
                    let _e413 = phi_1028_;
                    let _e415 = phi_1029_;
                    let _e417 = phi_1030_;
                    let _e419 = phi_1031_;
                    phi_863_ = _e413;
                    phi_866_ = _e415;
                    phi_868_ = _e417;
                    phi_1032_ = _e419;
                } else {
                    phi_863_ = lt_math_LightPoint();
                    phi_866_ = u32();
                    phi_868_ = lt_math_LevelPoint();
                    phi_1032_ = false;
                }
                let _e421 = phi_863_;
                let _e423 = phi_866_;
                let _e425 = phi_868_;
                let _e427 = phi_1032_;
                continue;
                continuing {
                    phi_862_ = _e421;
                    phi_865_ = _e423;
                    phi_867_ = _e425;
                    break if !(_e427);
                }
            }
            let _e430 = local_2;
            if _e430.point.is_inside {
                if (0f > 0f) {
                    let _e436 = local_3;
                    if (_e436.level < _e68) {
                    } else {
                        return;
                    }
                    let _e441 = levels.member[(0u + _e436.level)];
                    let _e447 = global[0u];
                    if (_e441.row_w.x == _e447) {
                        let _e450 = global[1u];
                        if (_e441.row_w.y == _e450) {
                            let _e453 = global[2u];
                            phi_1072_ = (_e441.row_w.z == _e453);
                            phi_1073_ = false;
                        } else {
                            phi_1072_ = bool();
                            phi_1073_ = true;
                        }
                        let _e456 = phi_1072_;
                        let _e458 = phi_1073_;
                        phi_1074_ = _e456;
                        phi_1075_ = _e458;
                    } else {
                        phi_1074_ = bool();
                        phi_1075_ = true;
                    }
                    let _e460 = phi_1074_;
                    let _e462 = phi_1075_;
                    if _e462 {
                        phi_1079_ = false;
                    } else {
                        phi_1079_ = _e460;
                    }
                    let _e464 = phi_1079_;
                    if _e464 {
                        let _e466 = samples.member[_e74.first_primitive].normal;
                        let _e468 = p.member.map_size;
                        let _e538 = ((abs(((((_e441.row_x.x * _e466.x) + (_e441.row_x.y * _e466.y)) + (_e441.row_x.z * _e466.z)) / (((_e441.row_x.x * _e441.row_x.x) + (_e441.row_x.y * _e441.row_x.y)) + (_e441.row_x.z * _e441.row_x.z)))) + abs(((((_e441.row_y.x * _e466.x) + (_e441.row_y.y * _e466.y)) + (_e441.row_y.z * _e466.z)) / (((_e441.row_y.x * _e441.row_y.x) + (_e441.row_y.y * _e441.row_y.y)) + (_e441.row_y.z * _e441.row_y.z))))) / (abs(((((_e441.row_z.x * _e466.x) + (_e441.row_z.y * _e466.y)) + (_e441.row_z.z * _e466.z)) / (((_e441.row_z.x * _e441.row_z.x) + (_e441.row_z.y * _e441.row_z.y)) + (_e441.row_z.z * _e441.row_z.z)))) * f32(_e468)));
                        if (_e538 < 0.002f) {
                            phi_1161_ = _e538;
                        } else {
                            phi_1161_ = 0.002f;
                        }
                        let _e541 = phi_1161_;
                        phi_1280_ = _e541;
                    } else {
                        let _e543 = p.member.map_size;
                        let _e549 = samples.member[_e74.first_primitive].position;
                        let _e560 = ((((_e441.row_w.x * _e549.x) + (_e441.row_w.y * _e549.y)) + (_e441.row_w.z * _e549.z)) + _e441.row_w.w);
                        let _e573 = ((_e441.row_x.x - (_e441.row_w.x * _e430.point.uv.x)) / _e560);
                        let _e574 = ((_e441.row_x.y - (_e441.row_w.y * _e430.point.uv.x)) / _e560);
                        let _e575 = ((_e441.row_x.z - (_e441.row_w.z * _e430.point.uv.x)) / _e560);
                        let _e588 = ((_e441.row_y.x - (_e441.row_w.x * _e430.point.uv.y)) / _e560);
                        let _e589 = ((_e441.row_y.y - (_e441.row_w.y * _e430.point.uv.y)) / _e560);
                        let _e590 = ((_e441.row_y.z - (_e441.row_w.z * _e430.point.uv.y)) / _e560);
                        let _e596 = samples.member[_e74.first_primitive].normal;
                        let _e601 = ((_e589 * _e596.z) - (_e596.y * _e590));
                        let _e606 = ((_e590 * _e596.x) - (_e596.z * _e588));
                        let _e611 = ((_e588 * _e596.y) - (_e596.x * _e589));
                        let _e613 = samples.member[_e74.first_primitive].normal;
                        let _e618 = ((_e574 * _e613.z) - (_e613.y * _e575));
                        let _e623 = ((_e575 * _e613.x) - (_e613.z * _e573));
                        let _e628 = ((_e573 * _e613.y) - (_e613.x * _e574));
                        let _e655 = ((abs(((((_e441.row_z.x * _e601) + (_e441.row_z.y * _e606)) + (_e441.row_z.z * _e611)) / (((_e573 * _e601) + (_e574 * _e606)) + (_e575 * _e611)))) + abs(((((_e441.row_z.x * _e618) + (_e441.row_z.y * _e623)) + (_e441.row_z.z * _e628)) / (((_e588 * _e618) + (_e589 * _e623)) + (_e590 * _e628))))) / f32(_e543));
                        let _e657 = (16f / f32(_e543));
                        if (_e655 < _e657) {
                            phi_1279_ = _e655;
                        } else {
                            phi_1279_ = _e657;
                        }
                        let _e660 = phi_1279_;
                        phi_1280_ = _e660;
                    }
                    let _e662 = phi_1280_;
                    phi_1283_ = (_e430.point.depth - (0f * _e662));
                } else {
                    phi_1283_ = _e430.point.depth;
                }
                let _e666 = phi_1283_;
                let _e672 = p.member.map_size;
                let _e673 = f32(_e672);
                let _e676 = ((_e430.point.uv.x * _e673) - 0.5f);
                let _e677 = ((_e430.point.uv.y * _e673) - 0.5f);
                if (_e676 > -8388608f) {
                    let _e689 = f32(select(0i, select(select(i32(_e676), i32(-2147483648), (_e676 < bitcast<f32>(3472883712u))), 2147483647i, (_e676 > bitcast<f32>(1325400063u))), (_e676 == _e676)));
                    if (_e689 > _e676) {
                        phi_1312_ = 1f;
                    } else {
                        phi_1312_ = 0f;
                    }
                    let _e692 = phi_1312_;
                    if (_e676 < 8388608f) {
                        phi_1317_ = (_e689 - _e692);
                        phi_1318_ = false;
                    } else {
                        phi_1317_ = f32();
                        phi_1318_ = true;
                    }
                    let _e695 = phi_1317_;
                    let _e697 = phi_1318_;
                    phi_1319_ = _e695;
                    phi_1320_ = _e697;
                } else {
                    phi_1319_ = f32();
                    phi_1320_ = true;
                }
                let _e699 = phi_1319_;
                let _e701 = phi_1320_;
                if _e701 {
                    phi_1324_ = _e676;
                } else {
                    phi_1324_ = _e699;
                }
                let _e703 = phi_1324_;
                if (_e677 > -8388608f) {
                    let _e715 = f32(select(0i, select(select(i32(_e677), i32(-2147483648), (_e677 < bitcast<f32>(3472883712u))), 2147483647i, (_e677 > bitcast<f32>(1325400063u))), (_e677 == _e677)));
                    if (_e715 > _e677) {
                        phi_1344_ = 1f;
                    } else {
                        phi_1344_ = 0f;
                    }
                    let _e718 = phi_1344_;
                    if (_e677 < 8388608f) {
                        phi_1349_ = (_e715 - _e718);
                        phi_1350_ = false;
                    } else {
                        phi_1349_ = f32();
                        phi_1350_ = true;
                    }
                    let _e721 = phi_1349_;
                    let _e723 = phi_1350_;
                    phi_1351_ = _e721;
                    phi_1352_ = _e723;
                } else {
                    phi_1351_ = f32();
                    phi_1352_ = true;
                }
                let _e725 = phi_1351_;
                let _e727 = phi_1352_;
                if _e727 {
                    phi_1356_ = _e677;
                } else {
                    phi_1356_ = _e725;
                }
                let _e729 = phi_1356_;
                let _e730 = (_e676 - _e703);
                let _e731 = (_e677 - _e729);
                let _e740 = select(0i, select(select(i32(_e703), i32(-2147483648), (_e703 < bitcast<f32>(3472883712u))), 2147483647i, (_e703 > bitcast<f32>(1325400063u))), (_e703 == _e703));
                let _e749 = select(0i, select(select(i32(_e729), i32(-2147483648), (_e729 < bitcast<f32>(3472883712u))), 2147483647i, (_e729 > bitcast<f32>(1325400063u))), (_e729 == _e729));
                let _e760 = p.member.test;
                let _e761 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e760);
                let _e763 = p.member.map_size;
                let _e765 = local_4;
                local_1 = _e761;
                let _e768 = ((_e765.level * _e763) * _e763);
                let _e770 = (bitcast<i32>(_e763) - 1i);
                if (_e740 > 0i) {
                    phi_1405_ = _e740;
                } else {
                    phi_1405_ = 0i;
                }
                let _e773 = phi_1405_;
                if (_e749 > 0i) {
                    phi_1410_ = _e749;
                } else {
                    phi_1410_ = 0i;
                }
                let _e776 = phi_1410_;
                if (_e773 < _e770) {
                    phi_1415_ = _e773;
                } else {
                    phi_1415_ = _e770;
                }
                let _e779 = phi_1415_;
                if (_e776 < _e770) {
                    phi_1420_ = _e776;
                } else {
                    phi_1420_ = _e770;
                }
                let _e782 = phi_1420_;
                let _e783 = bitcast<u32>(_e779);
                let _e785 = (_e740 + 1i);
                let _e786 = (_e749 + 1i);
                if (_e785 > 0i) {
                    phi_1429_ = _e785;
                } else {
                    phi_1429_ = 0i;
                }
                let _e789 = phi_1429_;
                if (_e786 > 0i) {
                    phi_1434_ = _e786;
                } else {
                    phi_1434_ = 0i;
                }
                let _e792 = phi_1434_;
                if (_e789 < _e770) {
                    phi_1439_ = _e789;
                } else {
                    phi_1439_ = _e770;
                }
                let _e795 = phi_1439_;
                if (_e792 < _e770) {
                    phi_1444_ = _e792;
                } else {
                    phi_1444_ = _e770;
                }
                let _e798 = phi_1444_;
                let _e799 = bitcast<u32>(_e795);
                let _e801 = (bitcast<u32>(_e782) * _e763);
                let _e802 = (bitcast<u32>(_e798) * _e763);
                let _e807 = ((_e801 + _e783) + _e768);
                let _e808 = ((_e801 + _e799) + _e768);
                let _e809 = ((_e802 + _e783) + _e768);
                let _e810 = ((_e802 + _e799) + _e768);
                if (_e807 < _e63) {
                } else {
                    return;
                }
                let _e814 = map.member[(0u + _e807)];
                if (_e808 < _e63) {
                } else {
                    return;
                }
                let _e818 = map.member[(0u + _e808)];
                if (_e809 < _e63) {
                } else {
                    return;
                }
                let _e822 = map.member[(0u + _e809)];
                if (_e810 < _e63) {
                } else {
                    return;
                }
                let _e826 = map.member[(0u + _e810)];
                let _e828 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e814, _e818, _e822, _e826), vec4<f32>(((1f - _e730) * (1f - _e731)), (_e730 * (1f - _e731)), ((1f - _e730) * _e731), (_e730 * _e731)), _e666);
                let _e830 = p.member.epsilon;
                if (_e828 <= _e830) {
                    phi_1495_ = true;
                } else {
                    phi_1495_ = (_e828 >= (1f - _e830));
                }
                let _e835 = phi_1495_;
                if ((bitcast<u32>(_e828) & 2147483647u) > 2139095040u) {
                    phi_1503_ = true;
                } else {
                    phi_1503_ = !(_e835);
                }
                let _e841 = phi_1503_;
                if _e841 {
                    if (_e828 > 0f) {
                        if (_e828 < 1f) {
                            phi_1515_ = false;
                        } else {
                            phi_1515_ = true;
                        }
                        let _e845 = phi_1515_;
                        phi_1516_ = _e845;
                    } else {
                        phi_1516_ = true;
                    }
                    let _e847 = phi_1516_;
                    if _e847 {
                        phi_1520_ = 0.5f;
                    } else {
                        phi_1520_ = _e828;
                    }
                    let _e849 = phi_1520_;
                    phi_1528_ = evaluate_Verdict(_e849, true);
                } else {
                    if (_e828 > 0.5f) {
                        phi_1526_ = 1f;
                    } else {
                        phi_1526_ = 0f;
                    }
                    let _e853 = phi_1526_;
                    phi_1528_ = evaluate_Verdict(_e853, false);
                }
                let _e856 = phi_1528_;
                phi_1533_ = evaluate_Verdict(_e856.visibility, _e856.is_doubted);
            } else {
                phi_1533_ = evaluate_Verdict(0.5f, true);
            }
            let _e862 = phi_1533_;
            phi_1534_ = _e862;
        }
        let _e864 = phi_1534_;
        visibility.member[_e74.first_primitive] = _e864.visibility;
        phi_1538_ = _e864.is_doubted;
        phi_1539_ = _e74.first_primitive;
    } else {
        phi_1538_ = false;
        phi_1539_ = 0u;
    }
    let _e869 = phi_1538_;
    let _e871 = phi_1539_;
    if (_e58 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e869 {
        let _e875 = atomicAdd((&shared_[0u]), 1u);
        phi_1550_ = _e875;
    } else {
        phi_1550_ = 0u;
    }
    let _e877 = phi_1550_;
    workgroupBarrier();
    if (_e58 == 0u) {
        let _e881 = atomicLoad((&shared_[0u]));
        let _e882 = atomicAdd((&list.member[3u]), _e881);
        atomicStore((&shared_[1u]), _e882);
    }
    workgroupBarrier();
    if _e869 {
        let _e885 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e885) + _e877)]), _e871);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
