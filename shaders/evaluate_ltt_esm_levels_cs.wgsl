struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
}

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
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_39;
@group(0) @binding(2) 
var<storage> map: type_18;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_51;
@group(0) @binding(5) 
var<storage> levels: type_45;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_173_: lt_bvh_traverse_Tree;
    var phi_174_: bool;
    var phi_175_: lt_bvh_traverse_Tree;
    var phi_176_: bool;
    var phi_181_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_173_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_174_ = false;
        } else {
            phi_173_ = lt_bvh_traverse_Tree();
            phi_174_ = true;
        }
        let _e68 = phi_173_;
        let _e70 = phi_174_;
        phi_175_ = _e68;
        phi_176_ = _e70;
    } else {
        phi_175_ = lt_bvh_traverse_Tree();
        phi_176_ = true;
    }
    let _e72 = phi_175_;
    let _e74 = phi_176_;
    if _e74 {
        phi_181_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_181_ = _e72;
    }
    let _e79 = phi_181_;
    return lt_bvh_traverse_Tree(_e79.root, _e79.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_201_: bool;
    var phi_205_: f32;

    let _e56 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_201_ = true;
    } else {
        let _e60 = (84f < _e56);
        if _e60 {
        }
        phi_201_ = _e60;
    }
    let _e62 = phi_201_;
    if _e62 {
        phi_205_ = 84f;
    } else {
        phi_205_ = _e56;
    }
    let _e64 = phi_205_;
    return _e64;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_226_: f32;
    var phi_227_: f32;
    var phi_228_: f32;
    var phi_244_: f32;
    var phi_245_: f32;
    var phi_246_: f32;
    var phi_262_: f32;
    var phi_263_: f32;
    var phi_264_: f32;
    var phi_280_: f32;
    var phi_281_: f32;
    var phi_282_: f32;
    var phi_298_: f32;
    var phi_299_: f32;
    var phi_300_: f32;
    var phi_319_: f32;
    var phi_324_: f32;
    var phi_346_: f32;
    var phi_351_: f32;
    var phi_352_: bool;
    var phi_353_: f32;
    var phi_354_: bool;
    var phi_358_: f32;
    var phi_396_: f32;
    var phi_407_: f32;
    var phi_412_: f32;
    var phi_434_: f32;
    var phi_439_: f32;
    var phi_440_: bool;
    var phi_441_: f32;
    var phi_442_: bool;
    var phi_446_: f32;
    var phi_484_: f32;
    var phi_495_: f32;
    var phi_500_: f32;
    var phi_522_: f32;
    var phi_527_: f32;
    var phi_528_: bool;
    var phi_529_: f32;
    var phi_530_: bool;
    var phi_534_: f32;
    var phi_572_: f32;
    var phi_583_: f32;
    var phi_588_: f32;
    var phi_610_: f32;
    var phi_615_: f32;
    var phi_616_: bool;
    var phi_617_: f32;
    var phi_618_: bool;
    var phi_622_: f32;
    var phi_660_: f32;
    var phi_686_: f32;
    var phi_687_: f32;
    var phi_688_: f32;

    let _e59 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_228_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_227_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_226_ = 1f;
            } else {
                phi_226_ = param_8;
            }
            let _e66 = phi_226_;
            phi_227_ = _e66;
        }
        let _e68 = phi_227_;
        phi_228_ = _e68;
    }
    let _e70 = phi_228_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_246_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_245_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_244_ = 1f;
            } else {
                phi_244_ = param_6.x;
            }
            let _e78 = phi_244_;
            phi_245_ = _e78;
        }
        let _e80 = phi_245_;
        phi_246_ = _e80;
    }
    let _e82 = phi_246_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_264_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_263_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_262_ = 1f;
            } else {
                phi_262_ = param_6.y;
            }
            let _e90 = phi_262_;
            phi_263_ = _e90;
        }
        let _e92 = phi_263_;
        phi_264_ = _e92;
    }
    let _e94 = phi_264_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_282_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_281_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_280_ = 1f;
            } else {
                phi_280_ = param_6.z;
            }
            let _e102 = phi_280_;
            phi_281_ = _e102;
        }
        let _e104 = phi_281_;
        phi_282_ = _e104;
    }
    let _e106 = phi_282_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_300_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_299_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_298_ = 1f;
            } else {
                phi_298_ = param_6.w;
            }
            let _e114 = phi_298_;
            phi_299_ = _e114;
        }
        let _e116 = phi_299_;
        phi_300_ = _e116;
    }
    let _e118 = phi_300_;
    let _e123 = (_e59 * (_e82 - _e70));
    let _e124 = (_e59 * (_e94 - _e70));
    let _e125 = (_e59 * (_e106 - _e70));
    let _e126 = (_e59 * (_e118 - _e70));
    if ((bitcast<u32>(_e123) & 2147483647u) > 2139095040u) {
        phi_396_ = _e123;
    } else {
        if (_e123 < -87f) {
            phi_319_ = -87f;
        } else {
            phi_319_ = _e123;
        }
        let _e132 = phi_319_;
        if (_e132 > 88f) {
            phi_324_ = 88f;
        } else {
            phi_324_ = _e132;
        }
        let _e135 = phi_324_;
        let _e137 = ((_e135 * 1.442695f) + 0.5f);
        if (_e137 > -8388608f) {
            let _e149 = f32(select(0i, select(select(i32(_e137), i32(-2147483648), (_e137 < bitcast<f32>(3472883712u))), 2147483647i, (_e137 > bitcast<f32>(1325400063u))), (_e137 == _e137)));
            if (_e149 > _e137) {
                phi_346_ = 1f;
            } else {
                phi_346_ = 0f;
            }
            let _e152 = phi_346_;
            if (_e137 < 8388608f) {
                phi_351_ = (_e149 - _e152);
                phi_352_ = false;
            } else {
                phi_351_ = f32();
                phi_352_ = true;
            }
            let _e155 = phi_351_;
            let _e157 = phi_352_;
            phi_353_ = _e155;
            phi_354_ = _e157;
        } else {
            phi_353_ = f32();
            phi_354_ = true;
        }
        let _e159 = phi_353_;
        let _e161 = phi_354_;
        if _e161 {
            phi_358_ = _e137;
        } else {
            phi_358_ = _e159;
        }
        let _e163 = phi_358_;
        let _e167 = ((_e135 - (_e163 * 0.69314575f)) - (_e163 * 0.0000014286068f));
        phi_396_ = ((((((((((((((((1f / 5040f) * _e167) + (1f / 720f)) * _e167) + (1f / 120f)) * _e167) + (1f / 24f)) * _e167) + (1f / 6f)) * _e167) + 0.5f) * _e167) + 1f) * _e167) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e163), i32(-2147483648), (_e163 < bitcast<f32>(3472883712u))), 2147483647i, (_e163 > bitcast<f32>(1325400063u))), (_e163 == _e163)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e203 = phi_396_;
    if ((bitcast<u32>(_e124) & 2147483647u) > 2139095040u) {
        phi_484_ = _e124;
    } else {
        if (_e124 < -87f) {
            phi_407_ = -87f;
        } else {
            phi_407_ = _e124;
        }
        let _e209 = phi_407_;
        if (_e209 > 88f) {
            phi_412_ = 88f;
        } else {
            phi_412_ = _e209;
        }
        let _e212 = phi_412_;
        let _e214 = ((_e212 * 1.442695f) + 0.5f);
        if (_e214 > -8388608f) {
            let _e226 = f32(select(0i, select(select(i32(_e214), i32(-2147483648), (_e214 < bitcast<f32>(3472883712u))), 2147483647i, (_e214 > bitcast<f32>(1325400063u))), (_e214 == _e214)));
            if (_e226 > _e214) {
                phi_434_ = 1f;
            } else {
                phi_434_ = 0f;
            }
            let _e229 = phi_434_;
            if (_e214 < 8388608f) {
                phi_439_ = (_e226 - _e229);
                phi_440_ = false;
            } else {
                phi_439_ = f32();
                phi_440_ = true;
            }
            let _e232 = phi_439_;
            let _e234 = phi_440_;
            phi_441_ = _e232;
            phi_442_ = _e234;
        } else {
            phi_441_ = f32();
            phi_442_ = true;
        }
        let _e236 = phi_441_;
        let _e238 = phi_442_;
        if _e238 {
            phi_446_ = _e214;
        } else {
            phi_446_ = _e236;
        }
        let _e240 = phi_446_;
        let _e244 = ((_e212 - (_e240 * 0.69314575f)) - (_e240 * 0.0000014286068f));
        phi_484_ = ((((((((((((((((1f / 5040f) * _e244) + (1f / 720f)) * _e244) + (1f / 120f)) * _e244) + (1f / 24f)) * _e244) + (1f / 6f)) * _e244) + 0.5f) * _e244) + 1f) * _e244) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e240), i32(-2147483648), (_e240 < bitcast<f32>(3472883712u))), 2147483647i, (_e240 > bitcast<f32>(1325400063u))), (_e240 == _e240)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e280 = phi_484_;
    if ((bitcast<u32>(_e125) & 2147483647u) > 2139095040u) {
        phi_572_ = _e125;
    } else {
        if (_e125 < -87f) {
            phi_495_ = -87f;
        } else {
            phi_495_ = _e125;
        }
        let _e286 = phi_495_;
        if (_e286 > 88f) {
            phi_500_ = 88f;
        } else {
            phi_500_ = _e286;
        }
        let _e289 = phi_500_;
        let _e291 = ((_e289 * 1.442695f) + 0.5f);
        if (_e291 > -8388608f) {
            let _e303 = f32(select(0i, select(select(i32(_e291), i32(-2147483648), (_e291 < bitcast<f32>(3472883712u))), 2147483647i, (_e291 > bitcast<f32>(1325400063u))), (_e291 == _e291)));
            if (_e303 > _e291) {
                phi_522_ = 1f;
            } else {
                phi_522_ = 0f;
            }
            let _e306 = phi_522_;
            if (_e291 < 8388608f) {
                phi_527_ = (_e303 - _e306);
                phi_528_ = false;
            } else {
                phi_527_ = f32();
                phi_528_ = true;
            }
            let _e309 = phi_527_;
            let _e311 = phi_528_;
            phi_529_ = _e309;
            phi_530_ = _e311;
        } else {
            phi_529_ = f32();
            phi_530_ = true;
        }
        let _e313 = phi_529_;
        let _e315 = phi_530_;
        if _e315 {
            phi_534_ = _e291;
        } else {
            phi_534_ = _e313;
        }
        let _e317 = phi_534_;
        let _e321 = ((_e289 - (_e317 * 0.69314575f)) - (_e317 * 0.0000014286068f));
        phi_572_ = ((((((((((((((((1f / 5040f) * _e321) + (1f / 720f)) * _e321) + (1f / 120f)) * _e321) + (1f / 24f)) * _e321) + (1f / 6f)) * _e321) + 0.5f) * _e321) + 1f) * _e321) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e317), i32(-2147483648), (_e317 < bitcast<f32>(3472883712u))), 2147483647i, (_e317 > bitcast<f32>(1325400063u))), (_e317 == _e317)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e357 = phi_572_;
    if ((bitcast<u32>(_e126) & 2147483647u) > 2139095040u) {
        phi_660_ = _e126;
    } else {
        if (_e126 < -87f) {
            phi_583_ = -87f;
        } else {
            phi_583_ = _e126;
        }
        let _e363 = phi_583_;
        if (_e363 > 88f) {
            phi_588_ = 88f;
        } else {
            phi_588_ = _e363;
        }
        let _e366 = phi_588_;
        let _e368 = ((_e366 * 1.442695f) + 0.5f);
        if (_e368 > -8388608f) {
            let _e380 = f32(select(0i, select(select(i32(_e368), i32(-2147483648), (_e368 < bitcast<f32>(3472883712u))), 2147483647i, (_e368 > bitcast<f32>(1325400063u))), (_e368 == _e368)));
            if (_e380 > _e368) {
                phi_610_ = 1f;
            } else {
                phi_610_ = 0f;
            }
            let _e383 = phi_610_;
            if (_e368 < 8388608f) {
                phi_615_ = (_e380 - _e383);
                phi_616_ = false;
            } else {
                phi_615_ = f32();
                phi_616_ = true;
            }
            let _e386 = phi_615_;
            let _e388 = phi_616_;
            phi_617_ = _e386;
            phi_618_ = _e388;
        } else {
            phi_617_ = f32();
            phi_618_ = true;
        }
        let _e390 = phi_617_;
        let _e392 = phi_618_;
        if _e392 {
            phi_622_ = _e368;
        } else {
            phi_622_ = _e390;
        }
        let _e394 = phi_622_;
        let _e398 = ((_e366 - (_e394 * 0.69314575f)) - (_e394 * 0.0000014286068f));
        phi_660_ = ((((((((((((((((1f / 5040f) * _e398) + (1f / 720f)) * _e398) + (1f / 120f)) * _e398) + (1f / 24f)) * _e398) + (1f / 6f)) * _e398) + 0.5f) * _e398) + 1f) * _e398) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e394), i32(-2147483648), (_e394 < bitcast<f32>(3472883712u))), 2147483647i, (_e394 > bitcast<f32>(1325400063u))), (_e394 == _e394)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e434 = phi_660_;
    let _e445 = ((((_e203 * param_7.x) + (_e280 * param_7.y)) + (_e357 * param_7.z)) + (_e434 * param_7.w));
    if ((bitcast<u32>(_e445) & 2147483647u) > 2139095040u) {
        phi_688_ = _e445;
    } else {
        if (_e445 < 0f) {
            phi_687_ = 0f;
        } else {
            if (_e445 > 1f) {
                phi_686_ = 1f;
            } else {
                phi_686_ = _e445;
            }
            let _e452 = phi_686_;
            phi_687_ = _e452;
        }
        let _e454 = phi_687_;
        phi_688_ = _e454;
    }
    let _e456 = phi_688_;
    return _e456;
}

fn function_() {
    var local_1: f32;
    var phi_743_: bool;
    var phi_744_: bool;
    var phi_745_: bool;
    var phi_746_: bool;
    var phi_750_: bool;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_832_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_833_: bool;
    var phi_834_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_835_: bool;
    var phi_842_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_846_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_866_: lt_math_LightPoint;
    var phi_869_: u32;
    var phi_871_: lt_math_LevelPoint;
    var phi_957_: bool;
    var phi_966_: bool;
    var phi_975_: bool;
    var phi_976_: bool;
    var phi_977_: bool;
    var phi_978_: bool;
    var phi_979_: bool;
    var phi_980_: bool;
    var phi_981_: bool;
    var phi_985_: bool;
    var phi_1012_: bool;
    var phi_1013_: bool;
    var phi_1014_: bool;
    var phi_1015_: bool;
    var phi_1016_: bool;
    var phi_1017_: bool;
    var phi_1018_: bool;
    var phi_1019_: bool;
    var phi_1023_: bool;
    var phi_1032_: lt_math_LightPoint;
    var phi_1033_: u32;
    var phi_1034_: lt_math_LevelPoint;
    var phi_1035_: bool;
    var phi_867_: lt_math_LightPoint;
    var phi_870_: u32;
    var phi_872_: lt_math_LevelPoint;
    var phi_1036_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1076_: bool;
    var phi_1077_: bool;
    var phi_1078_: bool;
    var phi_1079_: bool;
    var phi_1083_: bool;
    var phi_1165_: f32;
    var phi_1281_: f32;
    var phi_1282_: f32;
    var phi_1285_: f32;
    var phi_1314_: f32;
    var phi_1319_: f32;
    var phi_1320_: bool;
    var phi_1321_: f32;
    var phi_1322_: bool;
    var phi_1326_: f32;
    var phi_1346_: f32;
    var phi_1351_: f32;
    var phi_1352_: bool;
    var phi_1353_: f32;
    var phi_1354_: bool;
    var phi_1358_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1407_: i32;
    var phi_1412_: i32;
    var phi_1417_: i32;
    var phi_1422_: i32;
    var phi_1431_: i32;
    var phi_1436_: i32;
    var phi_1441_: i32;
    var phi_1446_: i32;
    var phi_1497_: bool;
    var phi_1505_: bool;
    var phi_1517_: bool;
    var phi_1518_: bool;
    var phi_1522_: f32;
    var phi_1528_: f32;
    var phi_1530_: evaluate_Verdict;
    var phi_1535_: evaluate_Verdict;
    var phi_1536_: evaluate_Verdict;
    var phi_1540_: bool;
    var phi_1541_: u32;
    var phi_1552_: u32;

    let _e56 = id_1;
    let _e57 = local_5;
    let _e62 = arrayLength((&map.member));
    let _e67 = arrayLength((&levels.member));
    let _e70 = p.member.size[0u];
    let _e72 = p.member.size[1u];
    let _e73 = lt_shaders_entry_pixel_index(_e56, _e70, _e72);
    if (bitcast<i32>(_e73.root) != 0i) {
        let _e80 = p.member.level_count;
        let _e84 = samples.member[_e73.first_primitive].normal[0u];
        let _e86 = global[0u];
        if (_e84 == _e86) {
            let _e89 = samples.member[_e73.first_primitive].normal[1u];
            let _e91 = global[1u];
            if (_e89 == _e91) {
                let _e94 = samples.member[_e73.first_primitive].normal[2u];
                let _e96 = global[2u];
                phi_743_ = (_e94 == _e96);
                phi_744_ = false;
            } else {
                phi_743_ = bool();
                phi_744_ = true;
            }
            let _e99 = phi_743_;
            let _e101 = phi_744_;
            phi_745_ = _e99;
            phi_746_ = _e101;
        } else {
            phi_745_ = bool();
            phi_746_ = true;
        }
        let _e103 = phi_745_;
        let _e105 = phi_746_;
        if _e105 {
            phi_750_ = false;
        } else {
            phi_750_ = _e103;
        }
        let _e107 = phi_750_;
        if !(_e107) {
            let _e110 = samples.member[_e73.first_primitive].position;
            let _e112 = p.member.light.place;
            let _e118 = p.member.light.place[3u];
            let _e125 = (_e112.x - (_e110.x * _e118));
            let _e126 = (_e112.y - (_e110.y * _e118));
            let _e127 = (_e112.z - (_e110.z * _e118));
            let _e129 = samples.member[_e73.first_primitive].normal;
            if ((((_e129.x * _e125) + (_e129.y * _e126)) + (_e129.z * _e127)) > 0f) {
                let _e143 = (((_e125 * _e125) + (_e126 * _e126)) + (_e127 * _e127));
                let _e145 = p.member.light.axis;
                let _e157 = p.member.light.place[3u];
                if (_e157 == 0f) {
                    phi_821_ = true;
                } else {
                    let _e160 = p.member.light.range_squared;
                    if (_e143 <= _e160) {
                        let _e163 = p.member.light.cos_outer;
                        phi_820_ = (-((((_e125 * _e145.x) + (_e126 * _e145.y)) + (_e127 * _e145.z))) >= (_e163 * sqrt(_e143)));
                    } else {
                        phi_820_ = false;
                    }
                    let _e168 = phi_820_;
                    phi_821_ = _e168;
                }
                let _e170 = phi_821_;
                if _e170 {
                    let _e172 = samples.member[_e73.first_primitive].flags;
                    let _e180 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e180.unnamed.visibility, false), _e180.unnamed_1);
                    phi_832_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e186.unnamed, ((_e172 & 1u) == 0u));
                    phi_833_ = false;
                } else {
                    phi_832_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_833_ = true;
                }
                let _e191 = phi_832_;
                let _e193 = phi_833_;
                phi_834_ = _e191;
                phi_835_ = _e193;
            } else {
                phi_834_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_835_ = true;
            }
            let _e195 = phi_834_;
            let _e197 = phi_835_;
            if _e197 {
                let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e203.unnamed.visibility, false), _e203.unnamed_1);
                phi_842_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e209.unnamed, true);
            } else {
                phi_842_ = _e195;
            }
            let _e214 = phi_842_;
            phi_846_ = _e214;
        } else {
            let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e226 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e220.unnamed.visibility, false), _e220.unnamed_1);
            phi_846_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e226.unnamed, true);
        }
        let _e231 = phi_846_;
        if _e231.unnamed_1 {
            phi_1536_ = evaluate_Verdict(_e231.unnamed.visibility, _e231.unnamed.is_doubted);
        } else {
            let _e239 = samples.member[_e73.first_primitive].position;
            let _e241 = p.member.map_size;
            let _e243 = (0.5f / f32(_e241));
            let _e250 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e257 = lt_math_LightPoint(vec2<f32>(_e250.uv.x, 0f), _e250.depth, _e250.is_inside);
            let _e261 = lt_math_LightPoint(_e257.uv, 0f, _e257.is_inside);
            phi_866_ = lt_math_LightPoint();
            phi_869_ = 0u;
            phi_871_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e261.uv, _e261.depth, false));
            loop {
                let _e268 = phi_866_;
                let _e270 = phi_869_;
                let _e272 = phi_871_;
                local_2 = _e272;
                local_3 = _e272;
                local_4 = _e272;
                if (_e270 < _e80) {
                    if _e272.point.is_inside {
                        phi_1032_ = lt_math_LightPoint();
                        phi_1033_ = u32();
                        phi_1034_ = lt_math_LevelPoint();
                        phi_1035_ = false;
                    } else {
                        if (_e270 < _e67) {
                        } else {
                            return;
                        }
                        let _e283 = levels.member[(0u + _e270)].row_w;
                        let _e294 = ((((_e283.x * _e239.x) + (_e283.y * _e239.y)) + (_e283.z * _e239.z)) + (_e283.w * 1f));
                        let _e296 = levels.member[(0u + _e270)].row_x;
                        let _e308 = (((((_e296.x * _e239.x) + (_e296.y * _e239.y)) + (_e296.z * _e239.z)) + (_e296.w * 1f)) / _e294);
                        let _e310 = levels.member[(0u + _e270)].row_y;
                        let _e322 = (((((_e310.x * _e239.x) + (_e310.y * _e239.y)) + (_e310.z * _e239.z)) + (_e310.w * 1f)) / _e294);
                        let _e324 = levels.member[(0u + _e270)].row_z;
                        let _e335 = ((((_e324.x * _e239.x) + (_e324.y * _e239.y)) + (_e324.z * _e239.z)) + (_e324.w * 1f));
                        if (_e294 > 0f) {
                            if (_e308 >= 0f) {
                                phi_957_ = (_e308 <= 1f);
                            } else {
                                phi_957_ = false;
                            }
                            let _e340 = phi_957_;
                            if _e340 {
                                if (_e322 >= 0f) {
                                    phi_966_ = (_e322 <= 1f);
                                } else {
                                    phi_966_ = false;
                                }
                                let _e344 = phi_966_;
                                if _e344 {
                                    if (_e335 >= 0f) {
                                        phi_975_ = (_e335 <= 1f);
                                    } else {
                                        phi_975_ = false;
                                    }
                                    let _e348 = phi_975_;
                                    phi_976_ = _e348;
                                    phi_977_ = false;
                                } else {
                                    phi_976_ = bool();
                                    phi_977_ = true;
                                }
                                let _e350 = phi_976_;
                                let _e352 = phi_977_;
                                phi_978_ = _e350;
                                phi_979_ = _e352;
                            } else {
                                phi_978_ = bool();
                                phi_979_ = true;
                            }
                            let _e354 = phi_978_;
                            let _e356 = phi_979_;
                            phi_980_ = _e354;
                            phi_981_ = _e356;
                        } else {
                            phi_980_ = bool();
                            phi_981_ = true;
                        }
                        let _e358 = phi_980_;
                        let _e360 = phi_981_;
                        if _e360 {
                            phi_985_ = false;
                        } else {
                            phi_985_ = _e358;
                        }
                        let _e362 = phi_985_;
                        if _e362 {
                            if (_e308 >= _e243) {
                                if (_e308 <= (1f - _e243)) {
                                    if (_e322 >= _e243) {
                                        phi_1012_ = (_e322 <= (1f - _e243));
                                        phi_1013_ = false;
                                    } else {
                                        phi_1012_ = bool();
                                        phi_1013_ = true;
                                    }
                                    let _e370 = phi_1012_;
                                    let _e372 = phi_1013_;
                                    phi_1014_ = _e370;
                                    phi_1015_ = _e372;
                                } else {
                                    phi_1014_ = bool();
                                    phi_1015_ = true;
                                }
                                let _e374 = phi_1014_;
                                let _e376 = phi_1015_;
                                phi_1016_ = _e374;
                                phi_1017_ = _e376;
                            } else {
                                phi_1016_ = bool();
                                phi_1017_ = true;
                            }
                            let _e378 = phi_1016_;
                            let _e380 = phi_1017_;
                            phi_1018_ = _e378;
                            phi_1019_ = _e380;
                        } else {
                            phi_1018_ = bool();
                            phi_1019_ = true;
                        }
                        let _e382 = phi_1018_;
                        let _e384 = phi_1019_;
                        if _e384 {
                            phi_1023_ = false;
                        } else {
                            phi_1023_ = _e382;
                        }
                        let _e386 = phi_1023_;
                        let _e393 = lt_math_LightPoint(vec2<f32>(_e308, _e268.uv.y), _e268.depth, _e268.is_inside);
                        let _e400 = lt_math_LightPoint(vec2<f32>(_e393.uv.x, _e322), _e393.depth, _e393.is_inside);
                        let _e404 = lt_math_LightPoint(_e400.uv, _e335, _e400.is_inside);
                        let _e408 = lt_math_LightPoint(_e404.uv, _e404.depth, _e386);
                        phi_1032_ = _e408;
                        phi_1033_ = (_e270 + 1u);
                        phi_1034_ = lt_math_LevelPoint(_e270, _e408);
                        phi_1035_ = true;
                    }
                    let _e412 = phi_1032_;
                    let _e414 = phi_1033_;
                    let _e416 = phi_1034_;
                    let _e418 = phi_1035_;
                    phi_867_ = _e412;
                    phi_870_ = _e414;
                    phi_872_ = _e416;
                    phi_1036_ = _e418;
                } else {
                    phi_867_ = lt_math_LightPoint();
                    phi_870_ = u32();
                    phi_872_ = lt_math_LevelPoint();
                    phi_1036_ = false;
                }
                let _e420 = phi_867_;
                let _e422 = phi_870_;
                let _e424 = phi_872_;
                let _e426 = phi_1036_;
                continue;
                continuing {
                    phi_866_ = _e420;
                    phi_869_ = _e422;
                    phi_871_ = _e424;
                    break if !(_e426);
                }
            }
            let _e429 = local_2;
            if _e429.point.is_inside {
                if (0f > 0f) {
                    let _e435 = local_3;
                    if (_e435.level < _e67) {
                    } else {
                        return;
                    }
                    let _e440 = levels.member[(0u + _e435.level)];
                    let _e446 = global[0u];
                    if (_e440.row_w.x == _e446) {
                        let _e449 = global[1u];
                        if (_e440.row_w.y == _e449) {
                            let _e452 = global[2u];
                            phi_1076_ = (_e440.row_w.z == _e452);
                            phi_1077_ = false;
                        } else {
                            phi_1076_ = bool();
                            phi_1077_ = true;
                        }
                        let _e455 = phi_1076_;
                        let _e457 = phi_1077_;
                        phi_1078_ = _e455;
                        phi_1079_ = _e457;
                    } else {
                        phi_1078_ = bool();
                        phi_1079_ = true;
                    }
                    let _e459 = phi_1078_;
                    let _e461 = phi_1079_;
                    if _e461 {
                        phi_1083_ = false;
                    } else {
                        phi_1083_ = _e459;
                    }
                    let _e463 = phi_1083_;
                    if _e463 {
                        let _e465 = samples.member[_e73.first_primitive].normal;
                        let _e467 = p.member.map_size;
                        let _e537 = ((abs(((((_e440.row_x.x * _e465.x) + (_e440.row_x.y * _e465.y)) + (_e440.row_x.z * _e465.z)) / (((_e440.row_x.x * _e440.row_x.x) + (_e440.row_x.y * _e440.row_x.y)) + (_e440.row_x.z * _e440.row_x.z)))) + abs(((((_e440.row_y.x * _e465.x) + (_e440.row_y.y * _e465.y)) + (_e440.row_y.z * _e465.z)) / (((_e440.row_y.x * _e440.row_y.x) + (_e440.row_y.y * _e440.row_y.y)) + (_e440.row_y.z * _e440.row_y.z))))) / (abs(((((_e440.row_z.x * _e465.x) + (_e440.row_z.y * _e465.y)) + (_e440.row_z.z * _e465.z)) / (((_e440.row_z.x * _e440.row_z.x) + (_e440.row_z.y * _e440.row_z.y)) + (_e440.row_z.z * _e440.row_z.z)))) * f32(_e467)));
                        if (_e537 < 0.002f) {
                            phi_1165_ = _e537;
                        } else {
                            phi_1165_ = 0.002f;
                        }
                        let _e540 = phi_1165_;
                        phi_1282_ = _e540;
                    } else {
                        let _e542 = p.member.map_size;
                        let _e548 = samples.member[_e73.first_primitive].position;
                        let _e559 = ((((_e440.row_w.x * _e548.x) + (_e440.row_w.y * _e548.y)) + (_e440.row_w.z * _e548.z)) + _e440.row_w.w);
                        let _e572 = ((_e440.row_x.x - (_e440.row_w.x * _e429.point.uv.x)) / _e559);
                        let _e573 = ((_e440.row_x.y - (_e440.row_w.y * _e429.point.uv.x)) / _e559);
                        let _e574 = ((_e440.row_x.z - (_e440.row_w.z * _e429.point.uv.x)) / _e559);
                        let _e587 = ((_e440.row_y.x - (_e440.row_w.x * _e429.point.uv.y)) / _e559);
                        let _e588 = ((_e440.row_y.y - (_e440.row_w.y * _e429.point.uv.y)) / _e559);
                        let _e589 = ((_e440.row_y.z - (_e440.row_w.z * _e429.point.uv.y)) / _e559);
                        let _e595 = samples.member[_e73.first_primitive].normal;
                        let _e600 = ((_e588 * _e595.z) - (_e595.y * _e589));
                        let _e605 = ((_e589 * _e595.x) - (_e595.z * _e587));
                        let _e610 = ((_e587 * _e595.y) - (_e595.x * _e588));
                        let _e612 = samples.member[_e73.first_primitive].normal;
                        let _e617 = ((_e573 * _e612.z) - (_e612.y * _e574));
                        let _e622 = ((_e574 * _e612.x) - (_e612.z * _e572));
                        let _e627 = ((_e572 * _e612.y) - (_e612.x * _e573));
                        let _e654 = ((abs(((((_e440.row_z.x * _e600) + (_e440.row_z.y * _e605)) + (_e440.row_z.z * _e610)) / (((_e572 * _e600) + (_e573 * _e605)) + (_e574 * _e610)))) + abs(((((_e440.row_z.x * _e617) + (_e440.row_z.y * _e622)) + (_e440.row_z.z * _e627)) / (((_e587 * _e617) + (_e588 * _e622)) + (_e589 * _e627))))) / f32(_e542));
                        if (_e654 < 0.002f) {
                            phi_1281_ = _e654;
                        } else {
                            phi_1281_ = 0.002f;
                        }
                        let _e657 = phi_1281_;
                        phi_1282_ = _e657;
                    }
                    let _e659 = phi_1282_;
                    phi_1285_ = (_e429.point.depth - (0f * _e659));
                } else {
                    phi_1285_ = _e429.point.depth;
                }
                let _e663 = phi_1285_;
                let _e669 = p.member.map_size;
                let _e670 = f32(_e669);
                let _e673 = ((_e429.point.uv.x * _e670) - 0.5f);
                let _e674 = ((_e429.point.uv.y * _e670) - 0.5f);
                if (_e673 > -8388608f) {
                    let _e686 = f32(select(0i, select(select(i32(_e673), i32(-2147483648), (_e673 < bitcast<f32>(3472883712u))), 2147483647i, (_e673 > bitcast<f32>(1325400063u))), (_e673 == _e673)));
                    if (_e686 > _e673) {
                        phi_1314_ = 1f;
                    } else {
                        phi_1314_ = 0f;
                    }
                    let _e689 = phi_1314_;
                    if (_e673 < 8388608f) {
                        phi_1319_ = (_e686 - _e689);
                        phi_1320_ = false;
                    } else {
                        phi_1319_ = f32();
                        phi_1320_ = true;
                    }
                    let _e692 = phi_1319_;
                    let _e694 = phi_1320_;
                    phi_1321_ = _e692;
                    phi_1322_ = _e694;
                } else {
                    phi_1321_ = f32();
                    phi_1322_ = true;
                }
                let _e696 = phi_1321_;
                let _e698 = phi_1322_;
                if _e698 {
                    phi_1326_ = _e673;
                } else {
                    phi_1326_ = _e696;
                }
                let _e700 = phi_1326_;
                if (_e674 > -8388608f) {
                    let _e712 = f32(select(0i, select(select(i32(_e674), i32(-2147483648), (_e674 < bitcast<f32>(3472883712u))), 2147483647i, (_e674 > bitcast<f32>(1325400063u))), (_e674 == _e674)));
                    if (_e712 > _e674) {
                        phi_1346_ = 1f;
                    } else {
                        phi_1346_ = 0f;
                    }
                    let _e715 = phi_1346_;
                    if (_e674 < 8388608f) {
                        phi_1351_ = (_e712 - _e715);
                        phi_1352_ = false;
                    } else {
                        phi_1351_ = f32();
                        phi_1352_ = true;
                    }
                    let _e718 = phi_1351_;
                    let _e720 = phi_1352_;
                    phi_1353_ = _e718;
                    phi_1354_ = _e720;
                } else {
                    phi_1353_ = f32();
                    phi_1354_ = true;
                }
                let _e722 = phi_1353_;
                let _e724 = phi_1354_;
                if _e724 {
                    phi_1358_ = _e674;
                } else {
                    phi_1358_ = _e722;
                }
                let _e726 = phi_1358_;
                let _e727 = (_e673 - _e700);
                let _e728 = (_e674 - _e726);
                let _e737 = select(0i, select(select(i32(_e700), i32(-2147483648), (_e700 < bitcast<f32>(3472883712u))), 2147483647i, (_e700 > bitcast<f32>(1325400063u))), (_e700 == _e700));
                let _e746 = select(0i, select(select(i32(_e726), i32(-2147483648), (_e726 < bitcast<f32>(3472883712u))), 2147483647i, (_e726 > bitcast<f32>(1325400063u))), (_e726 == _e726));
                let _e757 = p.member.test;
                let _e758 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e757);
                let _e760 = p.member.map_size;
                let _e762 = local_4;
                local_1 = _e758;
                let _e765 = ((_e762.level * _e760) * _e760);
                let _e767 = (bitcast<i32>(_e760) - 1i);
                if (_e737 > 0i) {
                    phi_1407_ = _e737;
                } else {
                    phi_1407_ = 0i;
                }
                let _e770 = phi_1407_;
                if (_e746 > 0i) {
                    phi_1412_ = _e746;
                } else {
                    phi_1412_ = 0i;
                }
                let _e773 = phi_1412_;
                if (_e770 < _e767) {
                    phi_1417_ = _e770;
                } else {
                    phi_1417_ = _e767;
                }
                let _e776 = phi_1417_;
                if (_e773 < _e767) {
                    phi_1422_ = _e773;
                } else {
                    phi_1422_ = _e767;
                }
                let _e779 = phi_1422_;
                let _e780 = bitcast<u32>(_e776);
                let _e782 = (_e737 + 1i);
                let _e783 = (_e746 + 1i);
                if (_e782 > 0i) {
                    phi_1431_ = _e782;
                } else {
                    phi_1431_ = 0i;
                }
                let _e786 = phi_1431_;
                if (_e783 > 0i) {
                    phi_1436_ = _e783;
                } else {
                    phi_1436_ = 0i;
                }
                let _e789 = phi_1436_;
                if (_e786 < _e767) {
                    phi_1441_ = _e786;
                } else {
                    phi_1441_ = _e767;
                }
                let _e792 = phi_1441_;
                if (_e789 < _e767) {
                    phi_1446_ = _e789;
                } else {
                    phi_1446_ = _e767;
                }
                let _e795 = phi_1446_;
                let _e796 = bitcast<u32>(_e792);
                let _e798 = (bitcast<u32>(_e779) * _e760);
                let _e799 = (bitcast<u32>(_e795) * _e760);
                let _e804 = ((_e798 + _e780) + _e765);
                let _e805 = ((_e798 + _e796) + _e765);
                let _e806 = ((_e799 + _e780) + _e765);
                let _e807 = ((_e799 + _e796) + _e765);
                if (_e804 < _e62) {
                } else {
                    return;
                }
                let _e811 = map.member[(0u + _e804)];
                if (_e805 < _e62) {
                } else {
                    return;
                }
                let _e815 = map.member[(0u + _e805)];
                if (_e806 < _e62) {
                } else {
                    return;
                }
                let _e819 = map.member[(0u + _e806)];
                if (_e807 < _e62) {
                } else {
                    return;
                }
                let _e823 = map.member[(0u + _e807)];
                let _e825 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e811, _e815, _e819, _e823), vec4<f32>(((1f - _e727) * (1f - _e728)), (_e727 * (1f - _e728)), ((1f - _e727) * _e728), (_e727 * _e728)), _e663);
                let _e827 = p.member.epsilon;
                if (_e825 <= _e827) {
                    phi_1497_ = true;
                } else {
                    phi_1497_ = (_e825 >= (1f - _e827));
                }
                let _e832 = phi_1497_;
                if ((bitcast<u32>(_e825) & 2147483647u) > 2139095040u) {
                    phi_1505_ = true;
                } else {
                    phi_1505_ = !(_e832);
                }
                let _e838 = phi_1505_;
                if _e838 {
                    if (_e825 > 0f) {
                        if (_e825 < 1f) {
                            phi_1517_ = false;
                        } else {
                            phi_1517_ = true;
                        }
                        let _e842 = phi_1517_;
                        phi_1518_ = _e842;
                    } else {
                        phi_1518_ = true;
                    }
                    let _e844 = phi_1518_;
                    if _e844 {
                        phi_1522_ = 0.5f;
                    } else {
                        phi_1522_ = _e825;
                    }
                    let _e846 = phi_1522_;
                    phi_1530_ = evaluate_Verdict(_e846, true);
                } else {
                    if (_e825 > 0.5f) {
                        phi_1528_ = 1f;
                    } else {
                        phi_1528_ = 0f;
                    }
                    let _e850 = phi_1528_;
                    phi_1530_ = evaluate_Verdict(_e850, false);
                }
                let _e853 = phi_1530_;
                phi_1535_ = evaluate_Verdict(_e853.visibility, _e853.is_doubted);
            } else {
                phi_1535_ = evaluate_Verdict(0.5f, true);
            }
            let _e859 = phi_1535_;
            phi_1536_ = _e859;
        }
        let _e861 = phi_1536_;
        visibility.member[_e73.first_primitive] = _e861.visibility;
        phi_1540_ = _e861.is_doubted;
        phi_1541_ = _e73.first_primitive;
    } else {
        phi_1540_ = false;
        phi_1541_ = 0u;
    }
    let _e866 = phi_1540_;
    let _e868 = phi_1541_;
    if (_e57 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e866 {
        let _e872 = atomicAdd((&shared_[0u]), 1u);
        phi_1552_ = _e872;
    } else {
        phi_1552_ = 0u;
    }
    let _e874 = phi_1552_;
    workgroupBarrier();
    if (_e57 == 0u) {
        let _e878 = atomicLoad((&shared_[0u]));
        let _e879 = atomicAdd((&list.member[3u]), _e878);
        atomicStore((&shared_[1u]), _e879);
    }
    workgroupBarrier();
    if _e866 {
        let _e882 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e882) + _e874)]), _e868);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
