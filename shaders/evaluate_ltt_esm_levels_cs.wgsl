struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_10 {
    member: array<abi_Sample>,
}

struct type_14 {
    member: array<u32>,
}

struct type_18 {
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

struct type_37 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_43 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct type_49 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_5: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_37;
@group(0) @binding(2) 
var<storage> map: type_18;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_49;
@group(0) @binding(5) 
var<storage> levels: type_43;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_169_: lt_bvh_traverse_Tree;
    var phi_170_: bool;
    var phi_171_: lt_bvh_traverse_Tree;
    var phi_172_: bool;
    var phi_177_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_169_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_170_ = false;
        } else {
            phi_169_ = lt_bvh_traverse_Tree();
            phi_170_ = true;
        }
        let _e68 = phi_169_;
        let _e70 = phi_170_;
        phi_171_ = _e68;
        phi_172_ = _e70;
    } else {
        phi_171_ = lt_bvh_traverse_Tree();
        phi_172_ = true;
    }
    let _e72 = phi_171_;
    let _e74 = phi_172_;
    if _e74 {
        phi_177_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_177_ = _e72;
    }
    let _e79 = phi_177_;
    return lt_bvh_traverse_Tree(_e79.root, _e79.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_197_: bool;
    var phi_201_: f32;

    let _e56 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_197_ = true;
    } else {
        let _e60 = (84f < _e56);
        if _e60 {
        }
        phi_197_ = _e60;
    }
    let _e62 = phi_197_;
    if _e62 {
        phi_201_ = 84f;
    } else {
        phi_201_ = _e56;
    }
    let _e64 = phi_201_;
    return _e64;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
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

    let _e59 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_224_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_223_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_222_ = 1f;
            } else {
                phi_222_ = param_8;
            }
            let _e66 = phi_222_;
            phi_223_ = _e66;
        }
        let _e68 = phi_223_;
        phi_224_ = _e68;
    }
    let _e70 = phi_224_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_242_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_241_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_240_ = 1f;
            } else {
                phi_240_ = param_6.x;
            }
            let _e78 = phi_240_;
            phi_241_ = _e78;
        }
        let _e80 = phi_241_;
        phi_242_ = _e80;
    }
    let _e82 = phi_242_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_260_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_259_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_258_ = 1f;
            } else {
                phi_258_ = param_6.y;
            }
            let _e90 = phi_258_;
            phi_259_ = _e90;
        }
        let _e92 = phi_259_;
        phi_260_ = _e92;
    }
    let _e94 = phi_260_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_278_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_277_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_276_ = 1f;
            } else {
                phi_276_ = param_6.z;
            }
            let _e102 = phi_276_;
            phi_277_ = _e102;
        }
        let _e104 = phi_277_;
        phi_278_ = _e104;
    }
    let _e106 = phi_278_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_296_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_295_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_294_ = 1f;
            } else {
                phi_294_ = param_6.w;
            }
            let _e114 = phi_294_;
            phi_295_ = _e114;
        }
        let _e116 = phi_295_;
        phi_296_ = _e116;
    }
    let _e118 = phi_296_;
    let _e123 = (_e59 * (_e82 - _e70));
    let _e124 = (_e59 * (_e94 - _e70));
    let _e125 = (_e59 * (_e106 - _e70));
    let _e126 = (_e59 * (_e118 - _e70));
    if ((bitcast<u32>(_e123) & 2147483647u) > 2139095040u) {
        phi_392_ = _e123;
    } else {
        if (_e123 < -87f) {
            phi_315_ = -87f;
        } else {
            phi_315_ = _e123;
        }
        let _e132 = phi_315_;
        if (_e132 > 88f) {
            phi_320_ = 88f;
        } else {
            phi_320_ = _e132;
        }
        let _e135 = phi_320_;
        let _e137 = ((_e135 * 1.442695f) + 0.5f);
        if (_e137 > -8388608f) {
            let _e149 = f32(select(0i, select(select(i32(_e137), i32(-2147483648), (_e137 < bitcast<f32>(3472883712u))), 2147483647i, (_e137 > bitcast<f32>(1325400063u))), (_e137 == _e137)));
            if (_e149 > _e137) {
                phi_342_ = 1f;
            } else {
                phi_342_ = 0f;
            }
            let _e152 = phi_342_;
            if (_e137 < 8388608f) {
                phi_347_ = (_e149 - _e152);
                phi_348_ = false;
            } else {
                phi_347_ = f32();
                phi_348_ = true;
            }
            let _e155 = phi_347_;
            let _e157 = phi_348_;
            phi_349_ = _e155;
            phi_350_ = _e157;
        } else {
            phi_349_ = f32();
            phi_350_ = true;
        }
        let _e159 = phi_349_;
        let _e161 = phi_350_;
        if _e161 {
            phi_354_ = _e137;
        } else {
            phi_354_ = _e159;
        }
        let _e163 = phi_354_;
        let _e167 = ((_e135 - (_e163 * 0.69314575f)) - (_e163 * 0.0000014286068f));
        phi_392_ = ((((((((((((((((1f / 5040f) * _e167) + (1f / 720f)) * _e167) + (1f / 120f)) * _e167) + (1f / 24f)) * _e167) + (1f / 6f)) * _e167) + 0.5f) * _e167) + 1f) * _e167) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e163), i32(-2147483648), (_e163 < bitcast<f32>(3472883712u))), 2147483647i, (_e163 > bitcast<f32>(1325400063u))), (_e163 == _e163)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e203 = phi_392_;
    if ((bitcast<u32>(_e124) & 2147483647u) > 2139095040u) {
        phi_480_ = _e124;
    } else {
        if (_e124 < -87f) {
            phi_403_ = -87f;
        } else {
            phi_403_ = _e124;
        }
        let _e209 = phi_403_;
        if (_e209 > 88f) {
            phi_408_ = 88f;
        } else {
            phi_408_ = _e209;
        }
        let _e212 = phi_408_;
        let _e214 = ((_e212 * 1.442695f) + 0.5f);
        if (_e214 > -8388608f) {
            let _e226 = f32(select(0i, select(select(i32(_e214), i32(-2147483648), (_e214 < bitcast<f32>(3472883712u))), 2147483647i, (_e214 > bitcast<f32>(1325400063u))), (_e214 == _e214)));
            if (_e226 > _e214) {
                phi_430_ = 1f;
            } else {
                phi_430_ = 0f;
            }
            let _e229 = phi_430_;
            if (_e214 < 8388608f) {
                phi_435_ = (_e226 - _e229);
                phi_436_ = false;
            } else {
                phi_435_ = f32();
                phi_436_ = true;
            }
            let _e232 = phi_435_;
            let _e234 = phi_436_;
            phi_437_ = _e232;
            phi_438_ = _e234;
        } else {
            phi_437_ = f32();
            phi_438_ = true;
        }
        let _e236 = phi_437_;
        let _e238 = phi_438_;
        if _e238 {
            phi_442_ = _e214;
        } else {
            phi_442_ = _e236;
        }
        let _e240 = phi_442_;
        let _e244 = ((_e212 - (_e240 * 0.69314575f)) - (_e240 * 0.0000014286068f));
        phi_480_ = ((((((((((((((((1f / 5040f) * _e244) + (1f / 720f)) * _e244) + (1f / 120f)) * _e244) + (1f / 24f)) * _e244) + (1f / 6f)) * _e244) + 0.5f) * _e244) + 1f) * _e244) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e240), i32(-2147483648), (_e240 < bitcast<f32>(3472883712u))), 2147483647i, (_e240 > bitcast<f32>(1325400063u))), (_e240 == _e240)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e280 = phi_480_;
    if ((bitcast<u32>(_e125) & 2147483647u) > 2139095040u) {
        phi_568_ = _e125;
    } else {
        if (_e125 < -87f) {
            phi_491_ = -87f;
        } else {
            phi_491_ = _e125;
        }
        let _e286 = phi_491_;
        if (_e286 > 88f) {
            phi_496_ = 88f;
        } else {
            phi_496_ = _e286;
        }
        let _e289 = phi_496_;
        let _e291 = ((_e289 * 1.442695f) + 0.5f);
        if (_e291 > -8388608f) {
            let _e303 = f32(select(0i, select(select(i32(_e291), i32(-2147483648), (_e291 < bitcast<f32>(3472883712u))), 2147483647i, (_e291 > bitcast<f32>(1325400063u))), (_e291 == _e291)));
            if (_e303 > _e291) {
                phi_518_ = 1f;
            } else {
                phi_518_ = 0f;
            }
            let _e306 = phi_518_;
            if (_e291 < 8388608f) {
                phi_523_ = (_e303 - _e306);
                phi_524_ = false;
            } else {
                phi_523_ = f32();
                phi_524_ = true;
            }
            let _e309 = phi_523_;
            let _e311 = phi_524_;
            phi_525_ = _e309;
            phi_526_ = _e311;
        } else {
            phi_525_ = f32();
            phi_526_ = true;
        }
        let _e313 = phi_525_;
        let _e315 = phi_526_;
        if _e315 {
            phi_530_ = _e291;
        } else {
            phi_530_ = _e313;
        }
        let _e317 = phi_530_;
        let _e321 = ((_e289 - (_e317 * 0.69314575f)) - (_e317 * 0.0000014286068f));
        phi_568_ = ((((((((((((((((1f / 5040f) * _e321) + (1f / 720f)) * _e321) + (1f / 120f)) * _e321) + (1f / 24f)) * _e321) + (1f / 6f)) * _e321) + 0.5f) * _e321) + 1f) * _e321) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e317), i32(-2147483648), (_e317 < bitcast<f32>(3472883712u))), 2147483647i, (_e317 > bitcast<f32>(1325400063u))), (_e317 == _e317)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e357 = phi_568_;
    if ((bitcast<u32>(_e126) & 2147483647u) > 2139095040u) {
        phi_656_ = _e126;
    } else {
        if (_e126 < -87f) {
            phi_579_ = -87f;
        } else {
            phi_579_ = _e126;
        }
        let _e363 = phi_579_;
        if (_e363 > 88f) {
            phi_584_ = 88f;
        } else {
            phi_584_ = _e363;
        }
        let _e366 = phi_584_;
        let _e368 = ((_e366 * 1.442695f) + 0.5f);
        if (_e368 > -8388608f) {
            let _e380 = f32(select(0i, select(select(i32(_e368), i32(-2147483648), (_e368 < bitcast<f32>(3472883712u))), 2147483647i, (_e368 > bitcast<f32>(1325400063u))), (_e368 == _e368)));
            if (_e380 > _e368) {
                phi_606_ = 1f;
            } else {
                phi_606_ = 0f;
            }
            let _e383 = phi_606_;
            if (_e368 < 8388608f) {
                phi_611_ = (_e380 - _e383);
                phi_612_ = false;
            } else {
                phi_611_ = f32();
                phi_612_ = true;
            }
            let _e386 = phi_611_;
            let _e388 = phi_612_;
            phi_613_ = _e386;
            phi_614_ = _e388;
        } else {
            phi_613_ = f32();
            phi_614_ = true;
        }
        let _e390 = phi_613_;
        let _e392 = phi_614_;
        if _e392 {
            phi_618_ = _e368;
        } else {
            phi_618_ = _e390;
        }
        let _e394 = phi_618_;
        let _e398 = ((_e366 - (_e394 * 0.69314575f)) - (_e394 * 0.0000014286068f));
        phi_656_ = ((((((((((((((((1f / 5040f) * _e398) + (1f / 720f)) * _e398) + (1f / 120f)) * _e398) + (1f / 24f)) * _e398) + (1f / 6f)) * _e398) + 0.5f) * _e398) + 1f) * _e398) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e394), i32(-2147483648), (_e394 < bitcast<f32>(3472883712u))), 2147483647i, (_e394 > bitcast<f32>(1325400063u))), (_e394 == _e394)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e434 = phi_656_;
    let _e445 = ((((_e203 * param_7.x) + (_e280 * param_7.y)) + (_e357 * param_7.z)) + (_e434 * param_7.w));
    if ((bitcast<u32>(_e445) & 2147483647u) > 2139095040u) {
        phi_684_ = _e445;
    } else {
        if (_e445 < 0f) {
            phi_683_ = 0f;
        } else {
            if (_e445 > 1f) {
                phi_682_ = 1f;
            } else {
                phi_682_ = _e445;
            }
            let _e452 = phi_682_;
            phi_683_ = _e452;
        }
        let _e454 = phi_683_;
        phi_684_ = _e454;
    }
    let _e456 = phi_684_;
    return _e456;
}

fn function_() {
    var local_1: f32;
    var phi_740_: bool;
    var phi_741_: bool;
    var phi_742_: bool;
    var phi_743_: bool;
    var phi_747_: bool;
    var phi_791_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_795_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_815_: lt_math_LightPoint;
    var phi_818_: u32;
    var phi_820_: lt_math_LevelPoint;
    var phi_906_: bool;
    var phi_915_: bool;
    var phi_924_: bool;
    var phi_925_: bool;
    var phi_926_: bool;
    var phi_927_: bool;
    var phi_928_: bool;
    var phi_929_: bool;
    var phi_930_: bool;
    var phi_934_: bool;
    var phi_961_: bool;
    var phi_962_: bool;
    var phi_963_: bool;
    var phi_964_: bool;
    var phi_965_: bool;
    var phi_966_: bool;
    var phi_967_: bool;
    var phi_968_: bool;
    var phi_972_: bool;
    var phi_981_: lt_math_LightPoint;
    var phi_982_: u32;
    var phi_983_: lt_math_LevelPoint;
    var phi_984_: bool;
    var phi_816_: lt_math_LightPoint;
    var phi_819_: u32;
    var phi_821_: lt_math_LevelPoint;
    var phi_985_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1025_: bool;
    var phi_1026_: bool;
    var phi_1027_: bool;
    var phi_1028_: bool;
    var phi_1032_: bool;
    var phi_1114_: f32;
    var phi_1230_: f32;
    var phi_1231_: f32;
    var phi_1234_: f32;
    var phi_1263_: f32;
    var phi_1268_: f32;
    var phi_1269_: bool;
    var phi_1270_: f32;
    var phi_1271_: bool;
    var phi_1275_: f32;
    var phi_1295_: f32;
    var phi_1300_: f32;
    var phi_1301_: bool;
    var phi_1302_: f32;
    var phi_1303_: bool;
    var phi_1307_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1356_: i32;
    var phi_1361_: i32;
    var phi_1366_: i32;
    var phi_1371_: i32;
    var phi_1380_: i32;
    var phi_1385_: i32;
    var phi_1390_: i32;
    var phi_1395_: i32;
    var phi_1446_: bool;
    var phi_1454_: bool;
    var phi_1466_: bool;
    var phi_1467_: bool;
    var phi_1471_: f32;
    var phi_1477_: f32;
    var phi_1479_: evaluate_Verdict;
    var phi_1484_: evaluate_Verdict;
    var phi_1485_: evaluate_Verdict;
    var phi_1489_: bool;
    var phi_1490_: u32;
    var phi_1501_: u32;

    let _e56 = id_1;
    let _e57 = local_5;
    let _e62 = arrayLength((&map.member));
    let _e67 = arrayLength((&levels.member));
    let _e70 = p.member.size[0u];
    let _e72 = p.member.size[1u];
    let _e73 = lt_shaders_entry_pixel_index(_e56, _e70, _e72);
    if (bitcast<i32>(_e73.root) != 0i) {
        let _e80 = p.member.level_count;
        let _e82 = p.member.light;
        let _e85 = samples.member[_e73.first_primitive].normal[0u];
        let _e87 = global[0u];
        if (_e85 == _e87) {
            let _e90 = samples.member[_e73.first_primitive].normal[1u];
            let _e92 = global[1u];
            if (_e90 == _e92) {
                let _e95 = samples.member[_e73.first_primitive].normal[2u];
                let _e97 = global[2u];
                phi_740_ = (_e95 == _e97);
                phi_741_ = false;
            } else {
                phi_740_ = bool();
                phi_741_ = true;
            }
            let _e100 = phi_740_;
            let _e102 = phi_741_;
            phi_742_ = _e100;
            phi_743_ = _e102;
        } else {
            phi_742_ = bool();
            phi_743_ = true;
        }
        let _e104 = phi_742_;
        let _e106 = phi_743_;
        if _e106 {
            phi_747_ = false;
        } else {
            phi_747_ = _e104;
        }
        let _e108 = phi_747_;
        if !(_e108) {
            let _e111 = samples.member[_e73.first_primitive].normal;
            let _e113 = samples.member[_e73.first_primitive].position;
            if ((((_e111.x * (_e82.x - (_e113.x * _e82.w))) + (_e111.y * (_e82.y - (_e113.y * _e82.w)))) + (_e111.z * (_e82.z - (_e113.z * _e82.w)))) > 0f) {
                let _e137 = samples.member[_e73.first_primitive].flags;
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e145.unnamed.visibility, false), _e145.unnamed_1);
                phi_791_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e151.unnamed, ((_e137 & 1u) == 0u));
            } else {
                let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e160.unnamed.visibility, false), _e160.unnamed_1);
                phi_791_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e166.unnamed, true);
            }
            let _e171 = phi_791_;
            phi_795_ = _e171;
        } else {
            let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e183 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e177.unnamed.visibility, false), _e177.unnamed_1);
            phi_795_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e183.unnamed, true);
        }
        let _e188 = phi_795_;
        if _e188.unnamed_1 {
            phi_1485_ = evaluate_Verdict(_e188.unnamed.visibility, _e188.unnamed.is_doubted);
        } else {
            let _e196 = samples.member[_e73.first_primitive].position;
            let _e198 = p.member.map_size;
            let _e200 = (0.5f / f32(_e198));
            let _e207 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e214 = lt_math_LightPoint(vec2<f32>(_e207.uv.x, 0f), _e207.depth, _e207.is_inside);
            let _e218 = lt_math_LightPoint(_e214.uv, 0f, _e214.is_inside);
            phi_815_ = lt_math_LightPoint();
            phi_818_ = 0u;
            phi_820_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e218.uv, _e218.depth, false));
            loop {
                let _e225 = phi_815_;
                let _e227 = phi_818_;
                let _e229 = phi_820_;
                local_2 = _e229;
                local_3 = _e229;
                local_4 = _e229;
                if (_e227 < _e80) {
                    if _e229.point.is_inside {
                        phi_981_ = lt_math_LightPoint();
                        phi_982_ = u32();
                        phi_983_ = lt_math_LevelPoint();
                        phi_984_ = false;
                    } else {
                        if (_e227 < _e67) {
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
                                phi_906_ = (_e265 <= 1f);
                            } else {
                                phi_906_ = false;
                            }
                            let _e297 = phi_906_;
                            if _e297 {
                                if (_e279 >= 0f) {
                                    phi_915_ = (_e279 <= 1f);
                                } else {
                                    phi_915_ = false;
                                }
                                let _e301 = phi_915_;
                                if _e301 {
                                    if (_e292 >= 0f) {
                                        phi_924_ = (_e292 <= 1f);
                                    } else {
                                        phi_924_ = false;
                                    }
                                    let _e305 = phi_924_;
                                    phi_925_ = _e305;
                                    phi_926_ = false;
                                } else {
                                    phi_925_ = bool();
                                    phi_926_ = true;
                                }
                                let _e307 = phi_925_;
                                let _e309 = phi_926_;
                                phi_927_ = _e307;
                                phi_928_ = _e309;
                            } else {
                                phi_927_ = bool();
                                phi_928_ = true;
                            }
                            let _e311 = phi_927_;
                            let _e313 = phi_928_;
                            phi_929_ = _e311;
                            phi_930_ = _e313;
                        } else {
                            phi_929_ = bool();
                            phi_930_ = true;
                        }
                        let _e315 = phi_929_;
                        let _e317 = phi_930_;
                        if _e317 {
                            phi_934_ = false;
                        } else {
                            phi_934_ = _e315;
                        }
                        let _e319 = phi_934_;
                        if _e319 {
                            if (_e265 >= _e200) {
                                if (_e265 <= (1f - _e200)) {
                                    if (_e279 >= _e200) {
                                        phi_961_ = (_e279 <= (1f - _e200));
                                        phi_962_ = false;
                                    } else {
                                        phi_961_ = bool();
                                        phi_962_ = true;
                                    }
                                    let _e327 = phi_961_;
                                    let _e329 = phi_962_;
                                    phi_963_ = _e327;
                                    phi_964_ = _e329;
                                } else {
                                    phi_963_ = bool();
                                    phi_964_ = true;
                                }
                                let _e331 = phi_963_;
                                let _e333 = phi_964_;
                                phi_965_ = _e331;
                                phi_966_ = _e333;
                            } else {
                                phi_965_ = bool();
                                phi_966_ = true;
                            }
                            let _e335 = phi_965_;
                            let _e337 = phi_966_;
                            phi_967_ = _e335;
                            phi_968_ = _e337;
                        } else {
                            phi_967_ = bool();
                            phi_968_ = true;
                        }
                        let _e339 = phi_967_;
                        let _e341 = phi_968_;
                        if _e341 {
                            phi_972_ = false;
                        } else {
                            phi_972_ = _e339;
                        }
                        let _e343 = phi_972_;
                        let _e350 = lt_math_LightPoint(vec2<f32>(_e265, _e225.uv.y), _e225.depth, _e225.is_inside);
                        let _e357 = lt_math_LightPoint(vec2<f32>(_e350.uv.x, _e279), _e350.depth, _e350.is_inside);
                        let _e361 = lt_math_LightPoint(_e357.uv, _e292, _e357.is_inside);
                        let _e365 = lt_math_LightPoint(_e361.uv, _e361.depth, _e343);
                        phi_981_ = _e365;
                        phi_982_ = (_e227 + 1u);
                        phi_983_ = lt_math_LevelPoint(_e227, _e365);
                        phi_984_ = true;
                    }
                    let _e369 = phi_981_;
                    let _e371 = phi_982_;
                    let _e373 = phi_983_;
                    let _e375 = phi_984_;
                    phi_816_ = _e369;
                    phi_819_ = _e371;
                    phi_821_ = _e373;
                    phi_985_ = _e375;
                } else {
                    phi_816_ = lt_math_LightPoint();
                    phi_819_ = u32();
                    phi_821_ = lt_math_LevelPoint();
                    phi_985_ = false;
                }
                let _e377 = phi_816_;
                let _e379 = phi_819_;
                let _e381 = phi_821_;
                let _e383 = phi_985_;
                continue;
                continuing {
                    phi_815_ = _e377;
                    phi_818_ = _e379;
                    phi_820_ = _e381;
                    break if !(_e383);
                }
            }
            let _e386 = local_2;
            if _e386.point.is_inside {
                if (0f > 0f) {
                    let _e392 = local_3;
                    if (_e392.level < _e67) {
                    } else {
                        return;
                    }
                    let _e397 = levels.member[(0u + _e392.level)];
                    let _e403 = global[0u];
                    if (_e397.row_w.x == _e403) {
                        let _e406 = global[1u];
                        if (_e397.row_w.y == _e406) {
                            let _e409 = global[2u];
                            phi_1025_ = (_e397.row_w.z == _e409);
                            phi_1026_ = false;
                        } else {
                            phi_1025_ = bool();
                            phi_1026_ = true;
                        }
                        let _e412 = phi_1025_;
                        let _e414 = phi_1026_;
                        phi_1027_ = _e412;
                        phi_1028_ = _e414;
                    } else {
                        phi_1027_ = bool();
                        phi_1028_ = true;
                    }
                    let _e416 = phi_1027_;
                    let _e418 = phi_1028_;
                    if _e418 {
                        phi_1032_ = false;
                    } else {
                        phi_1032_ = _e416;
                    }
                    let _e420 = phi_1032_;
                    if _e420 {
                        let _e422 = samples.member[_e73.first_primitive].normal;
                        let _e424 = p.member.map_size;
                        let _e494 = ((abs(((((_e397.row_x.x * _e422.x) + (_e397.row_x.y * _e422.y)) + (_e397.row_x.z * _e422.z)) / (((_e397.row_x.x * _e397.row_x.x) + (_e397.row_x.y * _e397.row_x.y)) + (_e397.row_x.z * _e397.row_x.z)))) + abs(((((_e397.row_y.x * _e422.x) + (_e397.row_y.y * _e422.y)) + (_e397.row_y.z * _e422.z)) / (((_e397.row_y.x * _e397.row_y.x) + (_e397.row_y.y * _e397.row_y.y)) + (_e397.row_y.z * _e397.row_y.z))))) / (abs(((((_e397.row_z.x * _e422.x) + (_e397.row_z.y * _e422.y)) + (_e397.row_z.z * _e422.z)) / (((_e397.row_z.x * _e397.row_z.x) + (_e397.row_z.y * _e397.row_z.y)) + (_e397.row_z.z * _e397.row_z.z)))) * f32(_e424)));
                        if (_e494 < 0.002f) {
                            phi_1114_ = _e494;
                        } else {
                            phi_1114_ = 0.002f;
                        }
                        let _e497 = phi_1114_;
                        phi_1231_ = _e497;
                    } else {
                        let _e499 = p.member.map_size;
                        let _e505 = samples.member[_e73.first_primitive].position;
                        let _e516 = ((((_e397.row_w.x * _e505.x) + (_e397.row_w.y * _e505.y)) + (_e397.row_w.z * _e505.z)) + _e397.row_w.w);
                        let _e529 = ((_e397.row_x.x - (_e397.row_w.x * _e386.point.uv.x)) / _e516);
                        let _e530 = ((_e397.row_x.y - (_e397.row_w.y * _e386.point.uv.x)) / _e516);
                        let _e531 = ((_e397.row_x.z - (_e397.row_w.z * _e386.point.uv.x)) / _e516);
                        let _e544 = ((_e397.row_y.x - (_e397.row_w.x * _e386.point.uv.y)) / _e516);
                        let _e545 = ((_e397.row_y.y - (_e397.row_w.y * _e386.point.uv.y)) / _e516);
                        let _e546 = ((_e397.row_y.z - (_e397.row_w.z * _e386.point.uv.y)) / _e516);
                        let _e552 = samples.member[_e73.first_primitive].normal;
                        let _e557 = ((_e545 * _e552.z) - (_e552.y * _e546));
                        let _e562 = ((_e546 * _e552.x) - (_e552.z * _e544));
                        let _e567 = ((_e544 * _e552.y) - (_e552.x * _e545));
                        let _e569 = samples.member[_e73.first_primitive].normal;
                        let _e574 = ((_e530 * _e569.z) - (_e569.y * _e531));
                        let _e579 = ((_e531 * _e569.x) - (_e569.z * _e529));
                        let _e584 = ((_e529 * _e569.y) - (_e569.x * _e530));
                        let _e611 = ((abs(((((_e397.row_z.x * _e557) + (_e397.row_z.y * _e562)) + (_e397.row_z.z * _e567)) / (((_e529 * _e557) + (_e530 * _e562)) + (_e531 * _e567)))) + abs(((((_e397.row_z.x * _e574) + (_e397.row_z.y * _e579)) + (_e397.row_z.z * _e584)) / (((_e544 * _e574) + (_e545 * _e579)) + (_e546 * _e584))))) / f32(_e499));
                        if (_e611 < 0.002f) {
                            phi_1230_ = _e611;
                        } else {
                            phi_1230_ = 0.002f;
                        }
                        let _e614 = phi_1230_;
                        phi_1231_ = _e614;
                    }
                    let _e616 = phi_1231_;
                    phi_1234_ = (_e386.point.depth - (0f * _e616));
                } else {
                    phi_1234_ = _e386.point.depth;
                }
                let _e620 = phi_1234_;
                let _e626 = p.member.map_size;
                let _e627 = f32(_e626);
                let _e630 = ((_e386.point.uv.x * _e627) - 0.5f);
                let _e631 = ((_e386.point.uv.y * _e627) - 0.5f);
                if (_e630 > -8388608f) {
                    let _e643 = f32(select(0i, select(select(i32(_e630), i32(-2147483648), (_e630 < bitcast<f32>(3472883712u))), 2147483647i, (_e630 > bitcast<f32>(1325400063u))), (_e630 == _e630)));
                    if (_e643 > _e630) {
                        phi_1263_ = 1f;
                    } else {
                        phi_1263_ = 0f;
                    }
                    let _e646 = phi_1263_;
                    if (_e630 < 8388608f) {
                        phi_1268_ = (_e643 - _e646);
                        phi_1269_ = false;
                    } else {
                        phi_1268_ = f32();
                        phi_1269_ = true;
                    }
                    let _e649 = phi_1268_;
                    let _e651 = phi_1269_;
                    phi_1270_ = _e649;
                    phi_1271_ = _e651;
                } else {
                    phi_1270_ = f32();
                    phi_1271_ = true;
                }
                let _e653 = phi_1270_;
                let _e655 = phi_1271_;
                if _e655 {
                    phi_1275_ = _e630;
                } else {
                    phi_1275_ = _e653;
                }
                let _e657 = phi_1275_;
                if (_e631 > -8388608f) {
                    let _e669 = f32(select(0i, select(select(i32(_e631), i32(-2147483648), (_e631 < bitcast<f32>(3472883712u))), 2147483647i, (_e631 > bitcast<f32>(1325400063u))), (_e631 == _e631)));
                    if (_e669 > _e631) {
                        phi_1295_ = 1f;
                    } else {
                        phi_1295_ = 0f;
                    }
                    let _e672 = phi_1295_;
                    if (_e631 < 8388608f) {
                        phi_1300_ = (_e669 - _e672);
                        phi_1301_ = false;
                    } else {
                        phi_1300_ = f32();
                        phi_1301_ = true;
                    }
                    let _e675 = phi_1300_;
                    let _e677 = phi_1301_;
                    phi_1302_ = _e675;
                    phi_1303_ = _e677;
                } else {
                    phi_1302_ = f32();
                    phi_1303_ = true;
                }
                let _e679 = phi_1302_;
                let _e681 = phi_1303_;
                if _e681 {
                    phi_1307_ = _e631;
                } else {
                    phi_1307_ = _e679;
                }
                let _e683 = phi_1307_;
                let _e684 = (_e630 - _e657);
                let _e685 = (_e631 - _e683);
                let _e694 = select(0i, select(select(i32(_e657), i32(-2147483648), (_e657 < bitcast<f32>(3472883712u))), 2147483647i, (_e657 > bitcast<f32>(1325400063u))), (_e657 == _e657));
                let _e703 = select(0i, select(select(i32(_e683), i32(-2147483648), (_e683 < bitcast<f32>(3472883712u))), 2147483647i, (_e683 > bitcast<f32>(1325400063u))), (_e683 == _e683));
                let _e714 = p.member.test;
                let _e715 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e714);
                let _e717 = p.member.map_size;
                let _e719 = local_4;
                local_1 = _e715;
                let _e722 = ((_e719.level * _e717) * _e717);
                let _e724 = (bitcast<i32>(_e717) - 1i);
                if (_e694 > 0i) {
                    phi_1356_ = _e694;
                } else {
                    phi_1356_ = 0i;
                }
                let _e727 = phi_1356_;
                if (_e703 > 0i) {
                    phi_1361_ = _e703;
                } else {
                    phi_1361_ = 0i;
                }
                let _e730 = phi_1361_;
                if (_e727 < _e724) {
                    phi_1366_ = _e727;
                } else {
                    phi_1366_ = _e724;
                }
                let _e733 = phi_1366_;
                if (_e730 < _e724) {
                    phi_1371_ = _e730;
                } else {
                    phi_1371_ = _e724;
                }
                let _e736 = phi_1371_;
                let _e737 = bitcast<u32>(_e733);
                let _e739 = (_e694 + 1i);
                let _e740 = (_e703 + 1i);
                if (_e739 > 0i) {
                    phi_1380_ = _e739;
                } else {
                    phi_1380_ = 0i;
                }
                let _e743 = phi_1380_;
                if (_e740 > 0i) {
                    phi_1385_ = _e740;
                } else {
                    phi_1385_ = 0i;
                }
                let _e746 = phi_1385_;
                if (_e743 < _e724) {
                    phi_1390_ = _e743;
                } else {
                    phi_1390_ = _e724;
                }
                let _e749 = phi_1390_;
                if (_e746 < _e724) {
                    phi_1395_ = _e746;
                } else {
                    phi_1395_ = _e724;
                }
                let _e752 = phi_1395_;
                let _e753 = bitcast<u32>(_e749);
                let _e755 = (bitcast<u32>(_e736) * _e717);
                let _e756 = (bitcast<u32>(_e752) * _e717);
                let _e761 = ((_e755 + _e737) + _e722);
                let _e762 = ((_e755 + _e753) + _e722);
                let _e763 = ((_e756 + _e737) + _e722);
                let _e764 = ((_e756 + _e753) + _e722);
                if (_e761 < _e62) {
                } else {
                    return;
                }
                let _e768 = map.member[(0u + _e761)];
                if (_e762 < _e62) {
                } else {
                    return;
                }
                let _e772 = map.member[(0u + _e762)];
                if (_e763 < _e62) {
                } else {
                    return;
                }
                let _e776 = map.member[(0u + _e763)];
                if (_e764 < _e62) {
                } else {
                    return;
                }
                let _e780 = map.member[(0u + _e764)];
                let _e782 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e768, _e772, _e776, _e780), vec4<f32>(((1f - _e684) * (1f - _e685)), (_e684 * (1f - _e685)), ((1f - _e684) * _e685), (_e684 * _e685)), _e620);
                let _e784 = p.member.epsilon;
                if (_e782 <= _e784) {
                    phi_1446_ = true;
                } else {
                    phi_1446_ = (_e782 >= (1f - _e784));
                }
                let _e789 = phi_1446_;
                if ((bitcast<u32>(_e782) & 2147483647u) > 2139095040u) {
                    phi_1454_ = true;
                } else {
                    phi_1454_ = !(_e789);
                }
                let _e795 = phi_1454_;
                if _e795 {
                    if (_e782 > 0f) {
                        if (_e782 < 1f) {
                            phi_1466_ = false;
                        } else {
                            phi_1466_ = true;
                        }
                        let _e799 = phi_1466_;
                        phi_1467_ = _e799;
                    } else {
                        phi_1467_ = true;
                    }
                    let _e801 = phi_1467_;
                    if _e801 {
                        phi_1471_ = 0.5f;
                    } else {
                        phi_1471_ = _e782;
                    }
                    let _e803 = phi_1471_;
                    phi_1479_ = evaluate_Verdict(_e803, true);
                } else {
                    if (_e782 > 0.5f) {
                        phi_1477_ = 1f;
                    } else {
                        phi_1477_ = 0f;
                    }
                    let _e807 = phi_1477_;
                    phi_1479_ = evaluate_Verdict(_e807, false);
                }
                let _e810 = phi_1479_;
                phi_1484_ = evaluate_Verdict(_e810.visibility, _e810.is_doubted);
            } else {
                phi_1484_ = evaluate_Verdict(0.5f, true);
            }
            let _e816 = phi_1484_;
            phi_1485_ = _e816;
        }
        let _e818 = phi_1485_;
        visibility.member[_e73.first_primitive] = _e818.visibility;
        phi_1489_ = _e818.is_doubted;
        phi_1490_ = _e73.first_primitive;
    } else {
        phi_1489_ = false;
        phi_1490_ = 0u;
    }
    let _e823 = phi_1489_;
    let _e825 = phi_1490_;
    if (_e57 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e823 {
        let _e829 = atomicAdd((&shared_[0u]), 1u);
        phi_1501_ = _e829;
    } else {
        phi_1501_ = 0u;
    }
    let _e831 = phi_1501_;
    workgroupBarrier();
    if (_e57 == 0u) {
        let _e835 = atomicLoad((&shared_[0u]));
        let _e836 = atomicAdd((&list.member[3u]), _e835);
        atomicStore((&shared_[1u]), _e836);
    }
    workgroupBarrier();
    if _e823 {
        let _e839 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e839) + _e831)]), _e825);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
