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

struct type_43 {
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
var<storage> levels: type_43;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_178_: lt_bvh_traverse_Tree;
    var phi_179_: bool;
    var phi_180_: lt_bvh_traverse_Tree;
    var phi_181_: bool;
    var phi_186_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_178_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_179_ = false;
        } else {
            phi_178_ = lt_bvh_traverse_Tree();
            phi_179_ = true;
        }
        let _e73 = phi_178_;
        let _e75 = phi_179_;
        phi_180_ = _e73;
        phi_181_ = _e75;
    } else {
        phi_180_ = lt_bvh_traverse_Tree();
        phi_181_ = true;
    }
    let _e77 = phi_180_;
    let _e79 = phi_181_;
    if _e79 {
        phi_186_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_186_ = _e77;
    }
    let _e84 = phi_186_;
    return lt_bvh_traverse_Tree(_e84.root, _e84.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_209_: bool;
    var phi_213_: f32;
    var phi_228_: f32;
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_246_: f32;
    var phi_247_: f32;
    var phi_248_: f32;
    var phi_264_: f32;
    var phi_265_: f32;
    var phi_266_: f32;
    var phi_282_: f32;
    var phi_283_: f32;
    var phi_284_: f32;
    var phi_300_: f32;
    var phi_301_: f32;
    var phi_302_: f32;
    var phi_321_: f32;
    var phi_326_: f32;
    var phi_348_: f32;
    var phi_353_: f32;
    var phi_354_: bool;
    var phi_355_: f32;
    var phi_356_: bool;
    var phi_360_: f32;
    var phi_398_: f32;
    var phi_409_: f32;
    var phi_414_: f32;
    var phi_436_: f32;
    var phi_441_: f32;
    var phi_442_: bool;
    var phi_443_: f32;
    var phi_444_: bool;
    var phi_448_: f32;
    var phi_486_: f32;
    var phi_497_: f32;
    var phi_502_: f32;
    var phi_524_: f32;
    var phi_529_: f32;
    var phi_530_: bool;
    var phi_531_: f32;
    var phi_532_: bool;
    var phi_536_: f32;
    var phi_574_: f32;
    var phi_585_: f32;
    var phi_590_: f32;
    var phi_612_: f32;
    var phi_617_: f32;
    var phi_618_: bool;
    var phi_619_: f32;
    var phi_620_: bool;
    var phi_624_: f32;
    var phi_662_: f32;
    var phi_688_: f32;
    var phi_689_: f32;
    var phi_690_: f32;

    let _e64 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_209_ = true;
    } else {
        let _e68 = (84f < _e64);
        if _e68 {
        }
        phi_209_ = _e68;
    }
    let _e70 = phi_209_;
    if _e70 {
        phi_213_ = 84f;
    } else {
        phi_213_ = _e64;
    }
    let _e72 = phi_213_;
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_230_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_229_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_228_ = 1f;
            } else {
                phi_228_ = param_7;
            }
            let _e79 = phi_228_;
            phi_229_ = _e79;
        }
        let _e81 = phi_229_;
        phi_230_ = _e81;
    }
    let _e83 = phi_230_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_248_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_247_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_246_ = 1f;
            } else {
                phi_246_ = param_5.x;
            }
            let _e91 = phi_246_;
            phi_247_ = _e91;
        }
        let _e93 = phi_247_;
        phi_248_ = _e93;
    }
    let _e95 = phi_248_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_266_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_265_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_264_ = 1f;
            } else {
                phi_264_ = param_5.y;
            }
            let _e103 = phi_264_;
            phi_265_ = _e103;
        }
        let _e105 = phi_265_;
        phi_266_ = _e105;
    }
    let _e107 = phi_266_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_284_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_283_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_282_ = 1f;
            } else {
                phi_282_ = param_5.z;
            }
            let _e115 = phi_282_;
            phi_283_ = _e115;
        }
        let _e117 = phi_283_;
        phi_284_ = _e117;
    }
    let _e119 = phi_284_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_302_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_301_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_300_ = 1f;
            } else {
                phi_300_ = param_5.w;
            }
            let _e127 = phi_300_;
            phi_301_ = _e127;
        }
        let _e129 = phi_301_;
        phi_302_ = _e129;
    }
    let _e131 = phi_302_;
    let _e136 = (_e72 * (_e95 - _e83));
    let _e137 = (_e72 * (_e107 - _e83));
    let _e138 = (_e72 * (_e119 - _e83));
    let _e139 = (_e72 * (_e131 - _e83));
    if ((bitcast<u32>(_e136) & 2147483647u) > 2139095040u) {
        phi_398_ = _e136;
    } else {
        if (_e136 < -87f) {
            phi_321_ = -87f;
        } else {
            phi_321_ = _e136;
        }
        let _e145 = phi_321_;
        if (_e145 > 88f) {
            phi_326_ = 88f;
        } else {
            phi_326_ = _e145;
        }
        let _e148 = phi_326_;
        let _e150 = ((_e148 * 1.442695f) + 0.5f);
        if (_e150 > -8388608f) {
            let _e162 = f32(select(0i, select(select(i32(_e150), i32(-2147483648), (_e150 < bitcast<f32>(3472883712u))), 2147483647i, (_e150 > bitcast<f32>(1325400063u))), (_e150 == _e150)));
            if (_e162 > _e150) {
                phi_348_ = 1f;
            } else {
                phi_348_ = 0f;
            }
            let _e165 = phi_348_;
            if (_e150 < 8388608f) {
                phi_353_ = (_e162 - _e165);
                phi_354_ = false;
            } else {
                phi_353_ = f32();
                phi_354_ = true;
            }
            let _e168 = phi_353_;
            let _e170 = phi_354_;
            phi_355_ = _e168;
            phi_356_ = _e170;
        } else {
            phi_355_ = f32();
            phi_356_ = true;
        }
        let _e172 = phi_355_;
        let _e174 = phi_356_;
        if _e174 {
            phi_360_ = _e150;
        } else {
            phi_360_ = _e172;
        }
        let _e176 = phi_360_;
        let _e180 = ((_e148 - (_e176 * 0.69314575f)) - (_e176 * 0.0000014286068f));
        phi_398_ = ((((((((((((((((1f / 5040f) * _e180) + (1f / 720f)) * _e180) + (1f / 120f)) * _e180) + (1f / 24f)) * _e180) + (1f / 6f)) * _e180) + 0.5f) * _e180) + 1f) * _e180) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e176), i32(-2147483648), (_e176 < bitcast<f32>(3472883712u))), 2147483647i, (_e176 > bitcast<f32>(1325400063u))), (_e176 == _e176)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e216 = phi_398_;
    if ((bitcast<u32>(_e137) & 2147483647u) > 2139095040u) {
        phi_486_ = _e137;
    } else {
        if (_e137 < -87f) {
            phi_409_ = -87f;
        } else {
            phi_409_ = _e137;
        }
        let _e222 = phi_409_;
        if (_e222 > 88f) {
            phi_414_ = 88f;
        } else {
            phi_414_ = _e222;
        }
        let _e225 = phi_414_;
        let _e227 = ((_e225 * 1.442695f) + 0.5f);
        if (_e227 > -8388608f) {
            let _e239 = f32(select(0i, select(select(i32(_e227), i32(-2147483648), (_e227 < bitcast<f32>(3472883712u))), 2147483647i, (_e227 > bitcast<f32>(1325400063u))), (_e227 == _e227)));
            if (_e239 > _e227) {
                phi_436_ = 1f;
            } else {
                phi_436_ = 0f;
            }
            let _e242 = phi_436_;
            if (_e227 < 8388608f) {
                phi_441_ = (_e239 - _e242);
                phi_442_ = false;
            } else {
                phi_441_ = f32();
                phi_442_ = true;
            }
            let _e245 = phi_441_;
            let _e247 = phi_442_;
            phi_443_ = _e245;
            phi_444_ = _e247;
        } else {
            phi_443_ = f32();
            phi_444_ = true;
        }
        let _e249 = phi_443_;
        let _e251 = phi_444_;
        if _e251 {
            phi_448_ = _e227;
        } else {
            phi_448_ = _e249;
        }
        let _e253 = phi_448_;
        let _e257 = ((_e225 - (_e253 * 0.69314575f)) - (_e253 * 0.0000014286068f));
        phi_486_ = ((((((((((((((((1f / 5040f) * _e257) + (1f / 720f)) * _e257) + (1f / 120f)) * _e257) + (1f / 24f)) * _e257) + (1f / 6f)) * _e257) + 0.5f) * _e257) + 1f) * _e257) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e253), i32(-2147483648), (_e253 < bitcast<f32>(3472883712u))), 2147483647i, (_e253 > bitcast<f32>(1325400063u))), (_e253 == _e253)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e293 = phi_486_;
    if ((bitcast<u32>(_e138) & 2147483647u) > 2139095040u) {
        phi_574_ = _e138;
    } else {
        if (_e138 < -87f) {
            phi_497_ = -87f;
        } else {
            phi_497_ = _e138;
        }
        let _e299 = phi_497_;
        if (_e299 > 88f) {
            phi_502_ = 88f;
        } else {
            phi_502_ = _e299;
        }
        let _e302 = phi_502_;
        let _e304 = ((_e302 * 1.442695f) + 0.5f);
        if (_e304 > -8388608f) {
            let _e316 = f32(select(0i, select(select(i32(_e304), i32(-2147483648), (_e304 < bitcast<f32>(3472883712u))), 2147483647i, (_e304 > bitcast<f32>(1325400063u))), (_e304 == _e304)));
            if (_e316 > _e304) {
                phi_524_ = 1f;
            } else {
                phi_524_ = 0f;
            }
            let _e319 = phi_524_;
            if (_e304 < 8388608f) {
                phi_529_ = (_e316 - _e319);
                phi_530_ = false;
            } else {
                phi_529_ = f32();
                phi_530_ = true;
            }
            let _e322 = phi_529_;
            let _e324 = phi_530_;
            phi_531_ = _e322;
            phi_532_ = _e324;
        } else {
            phi_531_ = f32();
            phi_532_ = true;
        }
        let _e326 = phi_531_;
        let _e328 = phi_532_;
        if _e328 {
            phi_536_ = _e304;
        } else {
            phi_536_ = _e326;
        }
        let _e330 = phi_536_;
        let _e334 = ((_e302 - (_e330 * 0.69314575f)) - (_e330 * 0.0000014286068f));
        phi_574_ = ((((((((((((((((1f / 5040f) * _e334) + (1f / 720f)) * _e334) + (1f / 120f)) * _e334) + (1f / 24f)) * _e334) + (1f / 6f)) * _e334) + 0.5f) * _e334) + 1f) * _e334) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e330), i32(-2147483648), (_e330 < bitcast<f32>(3472883712u))), 2147483647i, (_e330 > bitcast<f32>(1325400063u))), (_e330 == _e330)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e370 = phi_574_;
    if ((bitcast<u32>(_e139) & 2147483647u) > 2139095040u) {
        phi_662_ = _e139;
    } else {
        if (_e139 < -87f) {
            phi_585_ = -87f;
        } else {
            phi_585_ = _e139;
        }
        let _e376 = phi_585_;
        if (_e376 > 88f) {
            phi_590_ = 88f;
        } else {
            phi_590_ = _e376;
        }
        let _e379 = phi_590_;
        let _e381 = ((_e379 * 1.442695f) + 0.5f);
        if (_e381 > -8388608f) {
            let _e393 = f32(select(0i, select(select(i32(_e381), i32(-2147483648), (_e381 < bitcast<f32>(3472883712u))), 2147483647i, (_e381 > bitcast<f32>(1325400063u))), (_e381 == _e381)));
            if (_e393 > _e381) {
                phi_612_ = 1f;
            } else {
                phi_612_ = 0f;
            }
            let _e396 = phi_612_;
            if (_e381 < 8388608f) {
                phi_617_ = (_e393 - _e396);
                phi_618_ = false;
            } else {
                phi_617_ = f32();
                phi_618_ = true;
            }
            let _e399 = phi_617_;
            let _e401 = phi_618_;
            phi_619_ = _e399;
            phi_620_ = _e401;
        } else {
            phi_619_ = f32();
            phi_620_ = true;
        }
        let _e403 = phi_619_;
        let _e405 = phi_620_;
        if _e405 {
            phi_624_ = _e381;
        } else {
            phi_624_ = _e403;
        }
        let _e407 = phi_624_;
        let _e411 = ((_e379 - (_e407 * 0.69314575f)) - (_e407 * 0.0000014286068f));
        phi_662_ = ((((((((((((((((1f / 5040f) * _e411) + (1f / 720f)) * _e411) + (1f / 120f)) * _e411) + (1f / 24f)) * _e411) + (1f / 6f)) * _e411) + 0.5f) * _e411) + 1f) * _e411) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < bitcast<f32>(3472883712u))), 2147483647i, (_e407 > bitcast<f32>(1325400063u))), (_e407 == _e407)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e447 = phi_662_;
    let _e458 = ((((_e216 * param_6.x) + (_e293 * param_6.y)) + (_e370 * param_6.z)) + (_e447 * param_6.w));
    if ((bitcast<u32>(_e458) & 2147483647u) > 2139095040u) {
        phi_690_ = _e458;
    } else {
        if (_e458 < 0f) {
            phi_689_ = 0f;
        } else {
            if (_e458 > 1f) {
                phi_688_ = 1f;
            } else {
                phi_688_ = _e458;
            }
            let _e465 = phi_688_;
            phi_689_ = _e465;
        }
        let _e467 = phi_689_;
        phi_690_ = _e467;
    }
    let _e469 = phi_690_;
    return _e469;
}

fn function_() {
    var local_1: f32;
    var phi_745_: bool;
    var phi_746_: bool;
    var phi_747_: bool;
    var phi_748_: bool;
    var phi_752_: bool;
    var phi_822_: bool;
    var phi_823_: bool;
    var phi_834_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_835_: bool;
    var phi_836_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_837_: bool;
    var phi_844_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_848_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_868_: lt_math_LightPoint;
    var phi_871_: u32;
    var phi_873_: lt_math_LevelPoint;
    var phi_959_: bool;
    var phi_968_: bool;
    var phi_977_: bool;
    var phi_978_: bool;
    var phi_979_: bool;
    var phi_980_: bool;
    var phi_981_: bool;
    var phi_982_: bool;
    var phi_983_: bool;
    var phi_987_: bool;
    var phi_1014_: bool;
    var phi_1015_: bool;
    var phi_1016_: bool;
    var phi_1017_: bool;
    var phi_1018_: bool;
    var phi_1019_: bool;
    var phi_1020_: bool;
    var phi_1021_: bool;
    var phi_1025_: bool;
    var phi_1034_: lt_math_LightPoint;
    var phi_1035_: u32;
    var phi_1036_: lt_math_LevelPoint;
    var phi_1037_: bool;
    var phi_869_: lt_math_LightPoint;
    var phi_872_: u32;
    var phi_874_: lt_math_LevelPoint;
    var phi_1038_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1078_: bool;
    var phi_1079_: bool;
    var phi_1080_: bool;
    var phi_1081_: bool;
    var phi_1085_: bool;
    var phi_1167_: f32;
    var phi_1285_: f32;
    var phi_1286_: f32;
    var phi_1289_: f32;
    var phi_1318_: f32;
    var phi_1323_: f32;
    var phi_1324_: bool;
    var phi_1325_: f32;
    var phi_1326_: bool;
    var phi_1330_: f32;
    var phi_1350_: f32;
    var phi_1355_: f32;
    var phi_1356_: bool;
    var phi_1357_: f32;
    var phi_1358_: bool;
    var phi_1362_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1411_: i32;
    var phi_1416_: i32;
    var phi_1421_: i32;
    var phi_1426_: i32;
    var phi_1435_: i32;
    var phi_1440_: i32;
    var phi_1445_: i32;
    var phi_1450_: i32;
    var phi_1503_: bool;
    var phi_1511_: bool;
    var phi_1523_: bool;
    var phi_1524_: bool;
    var phi_1528_: f32;
    var phi_1534_: f32;
    var phi_1536_: evaluate_Verdict;
    var phi_1546_: u32;
    var phi_1555_: f32;
    var phi_1557_: evaluate_Verdict;
    var phi_1558_: bool;
    var phi_1559_: evaluate_Verdict;
    var phi_1560_: bool;
    var phi_1565_: evaluate_Verdict;
    var phi_1570_: evaluate_Verdict;
    var phi_1571_: evaluate_Verdict;
    var phi_1575_: bool;
    var phi_1576_: u32;
    var phi_1587_: u32;
    var phi_1604_: u32;

    let _e61 = id_1;
    let _e62 = local_5;
    let _e67 = arrayLength((&map.member));
    let _e72 = arrayLength((&levels.member));
    let _e75 = p.member.size[0u];
    let _e77 = p.member.size[1u];
    let _e78 = lt_shaders_entry_pixel_index(_e61, _e75, _e77);
    if (bitcast<i32>(_e78.root) != 0i) {
        let _e85 = p.member.level_count;
        let _e89 = samples.member[_e78.first_primitive].normal[0u];
        let _e91 = global[0u];
        if (_e89 == _e91) {
            let _e94 = samples.member[_e78.first_primitive].normal[1u];
            let _e96 = global[1u];
            if (_e94 == _e96) {
                let _e99 = samples.member[_e78.first_primitive].normal[2u];
                let _e101 = global[2u];
                phi_745_ = (_e99 == _e101);
                phi_746_ = false;
            } else {
                phi_745_ = bool();
                phi_746_ = true;
            }
            let _e104 = phi_745_;
            let _e106 = phi_746_;
            phi_747_ = _e104;
            phi_748_ = _e106;
        } else {
            phi_747_ = bool();
            phi_748_ = true;
        }
        let _e108 = phi_747_;
        let _e110 = phi_748_;
        if _e110 {
            phi_752_ = false;
        } else {
            phi_752_ = _e108;
        }
        let _e112 = phi_752_;
        if !(_e112) {
            let _e115 = samples.member[_e78.first_primitive].position;
            let _e117 = p.member.light.place;
            let _e123 = p.member.light.place[3u];
            let _e130 = (_e117.x - (_e115.x * _e123));
            let _e131 = (_e117.y - (_e115.y * _e123));
            let _e132 = (_e117.z - (_e115.z * _e123));
            let _e134 = samples.member[_e78.first_primitive].normal;
            if ((((_e134.x * _e130) + (_e134.y * _e131)) + (_e134.z * _e132)) > 0f) {
                let _e148 = (((_e130 * _e130) + (_e131 * _e131)) + (_e132 * _e132));
                let _e150 = p.member.light.axis;
                let _e162 = p.member.light.place[3u];
                if (_e162 == 0f) {
                    phi_823_ = true;
                } else {
                    let _e165 = p.member.light.range_squared;
                    if (_e148 <= _e165) {
                        let _e168 = p.member.light.cos_outer;
                        phi_822_ = (-((((_e130 * _e150.x) + (_e131 * _e150.y)) + (_e132 * _e150.z))) >= (_e168 * sqrt(_e148)));
                    } else {
                        phi_822_ = false;
                    }
                    let _e173 = phi_822_;
                    phi_823_ = _e173;
                }
                let _e175 = phi_823_;
                if _e175 {
                    let _e177 = samples.member[_e78.first_primitive].flags;
                    let _e185 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e185.unnamed.visibility, false), _e185.unnamed_1);
                    phi_834_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e191.unnamed, ((_e177 & 1u) == 0u));
                    phi_835_ = false;
                } else {
                    phi_834_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_835_ = true;
                }
                let _e196 = phi_834_;
                let _e198 = phi_835_;
                phi_836_ = _e196;
                phi_837_ = _e198;
            } else {
                phi_836_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_837_ = true;
            }
            let _e200 = phi_836_;
            let _e202 = phi_837_;
            if _e202 {
                let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e208.unnamed.visibility, false), _e208.unnamed_1);
                phi_844_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e214.unnamed, true);
            } else {
                phi_844_ = _e200;
            }
            let _e219 = phi_844_;
            phi_848_ = _e219;
        } else {
            let _e225 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e231 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e225.unnamed.visibility, false), _e225.unnamed_1);
            phi_848_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e231.unnamed, true);
        }
        let _e236 = phi_848_;
        if _e236.unnamed_1 {
            phi_1571_ = evaluate_Verdict(_e236.unnamed.visibility, _e236.unnamed.is_doubted);
        } else {
            let _e244 = samples.member[_e78.first_primitive].position;
            let _e246 = p.member.map_size;
            let _e248 = (0.5f / f32(_e246));
            let _e255 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e262 = lt_math_LightPoint(vec2<f32>(_e255.uv.x, 0f), _e255.depth, _e255.is_inside);
            let _e266 = lt_math_LightPoint(_e262.uv, 0f, _e262.is_inside);
            phi_868_ = lt_math_LightPoint();
            phi_871_ = 0u;
            phi_873_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e266.uv, _e266.depth, false));
            loop {
                let _e273 = phi_868_;
                let _e275 = phi_871_;
                let _e277 = phi_873_;
                local_2 = _e277;
                local_3 = _e277;
                local_4 = _e277;
                if (_e275 < _e85) {
                    if _e277.point.is_inside {
                        phi_1034_ = lt_math_LightPoint();
                        phi_1035_ = u32();
                        phi_1036_ = lt_math_LevelPoint();
                        phi_1037_ = false;
                    } else {
                        if (_e275 < _e72) {
                        } else {
                            return;
                        }
                        let _e288 = levels.member[(0u + _e275)].row_w;
                        let _e299 = ((((_e288.x * _e244.x) + (_e288.y * _e244.y)) + (_e288.z * _e244.z)) + (_e288.w * 1f));
                        let _e301 = levels.member[(0u + _e275)].row_x;
                        let _e313 = (((((_e301.x * _e244.x) + (_e301.y * _e244.y)) + (_e301.z * _e244.z)) + (_e301.w * 1f)) / _e299);
                        let _e315 = levels.member[(0u + _e275)].row_y;
                        let _e327 = (((((_e315.x * _e244.x) + (_e315.y * _e244.y)) + (_e315.z * _e244.z)) + (_e315.w * 1f)) / _e299);
                        let _e329 = levels.member[(0u + _e275)].row_z;
                        let _e340 = ((((_e329.x * _e244.x) + (_e329.y * _e244.y)) + (_e329.z * _e244.z)) + (_e329.w * 1f));
                        if (_e299 > 0f) {
                            if (_e313 >= 0f) {
                                phi_959_ = (_e313 <= 1f);
                            } else {
                                phi_959_ = false;
                            }
                            let _e345 = phi_959_;
                            if _e345 {
                                if (_e327 >= 0f) {
                                    phi_968_ = (_e327 <= 1f);
                                } else {
                                    phi_968_ = false;
                                }
                                let _e349 = phi_968_;
                                if _e349 {
                                    if (_e340 >= 0f) {
                                        phi_977_ = (_e340 <= 1f);
                                    } else {
                                        phi_977_ = false;
                                    }
                                    let _e353 = phi_977_;
                                    phi_978_ = _e353;
                                    phi_979_ = false;
                                } else {
                                    phi_978_ = bool();
                                    phi_979_ = true;
                                }
                                let _e355 = phi_978_;
                                let _e357 = phi_979_;
                                phi_980_ = _e355;
                                phi_981_ = _e357;
                            } else {
                                phi_980_ = bool();
                                phi_981_ = true;
                            }
                            let _e359 = phi_980_;
                            let _e361 = phi_981_;
                            phi_982_ = _e359;
                            phi_983_ = _e361;
                        } else {
                            phi_982_ = bool();
                            phi_983_ = true;
                        }
                        let _e363 = phi_982_;
                        let _e365 = phi_983_;
                        if _e365 {
                            phi_987_ = false;
                        } else {
                            phi_987_ = _e363;
                        }
                        let _e367 = phi_987_;
                        if _e367 {
                            if (_e313 >= _e248) {
                                if (_e313 <= (1f - _e248)) {
                                    if (_e327 >= _e248) {
                                        phi_1014_ = (_e327 <= (1f - _e248));
                                        phi_1015_ = false;
                                    } else {
                                        phi_1014_ = bool();
                                        phi_1015_ = true;
                                    }
                                    let _e375 = phi_1014_;
                                    let _e377 = phi_1015_;
                                    phi_1016_ = _e375;
                                    phi_1017_ = _e377;
                                } else {
                                    phi_1016_ = bool();
                                    phi_1017_ = true;
                                }
                                let _e379 = phi_1016_;
                                let _e381 = phi_1017_;
                                phi_1018_ = _e379;
                                phi_1019_ = _e381;
                            } else {
                                phi_1018_ = bool();
                                phi_1019_ = true;
                            }
                            let _e383 = phi_1018_;
                            let _e385 = phi_1019_;
                            phi_1020_ = _e383;
                            phi_1021_ = _e385;
                        } else {
                            phi_1020_ = bool();
                            phi_1021_ = true;
                        }
                        let _e387 = phi_1020_;
                        let _e389 = phi_1021_;
                        if _e389 {
                            phi_1025_ = false;
                        } else {
                            phi_1025_ = _e387;
                        }
                        let _e391 = phi_1025_;
                        let _e398 = lt_math_LightPoint(vec2<f32>(_e313, _e273.uv.y), _e273.depth, _e273.is_inside);
                        let _e405 = lt_math_LightPoint(vec2<f32>(_e398.uv.x, _e327), _e398.depth, _e398.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e340, _e405.is_inside);
                        let _e413 = lt_math_LightPoint(_e409.uv, _e409.depth, _e391);
                        phi_1034_ = _e413;
                        phi_1035_ = (_e275 + 1u);
                        phi_1036_ = lt_math_LevelPoint(_e275, _e413);
                        phi_1037_ = true;
                    }
                    let _e417 = phi_1034_;
                    let _e419 = phi_1035_;
                    let _e421 = phi_1036_;
                    let _e423 = phi_1037_;
                    phi_869_ = _e417;
                    phi_872_ = _e419;
                    phi_874_ = _e421;
                    phi_1038_ = _e423;
                } else {
                    phi_869_ = lt_math_LightPoint();
                    phi_872_ = u32();
                    phi_874_ = lt_math_LevelPoint();
                    phi_1038_ = false;
                }
                let _e425 = phi_869_;
                let _e427 = phi_872_;
                let _e429 = phi_874_;
                let _e431 = phi_1038_;
                continue;
                continuing {
                    phi_868_ = _e425;
                    phi_871_ = _e427;
                    phi_873_ = _e429;
                    break if !(_e431);
                }
            }
            let _e434 = local_2;
            if _e434.point.is_inside {
                if (0f > 0f) {
                    let _e440 = local_3;
                    if (_e440.level < _e72) {
                    } else {
                        return;
                    }
                    let _e445 = levels.member[(0u + _e440.level)];
                    let _e451 = global[0u];
                    if (_e445.row_w.x == _e451) {
                        let _e454 = global[1u];
                        if (_e445.row_w.y == _e454) {
                            let _e457 = global[2u];
                            phi_1078_ = (_e445.row_w.z == _e457);
                            phi_1079_ = false;
                        } else {
                            phi_1078_ = bool();
                            phi_1079_ = true;
                        }
                        let _e460 = phi_1078_;
                        let _e462 = phi_1079_;
                        phi_1080_ = _e460;
                        phi_1081_ = _e462;
                    } else {
                        phi_1080_ = bool();
                        phi_1081_ = true;
                    }
                    let _e464 = phi_1080_;
                    let _e466 = phi_1081_;
                    if _e466 {
                        phi_1085_ = false;
                    } else {
                        phi_1085_ = _e464;
                    }
                    let _e468 = phi_1085_;
                    if _e468 {
                        let _e470 = samples.member[_e78.first_primitive].normal;
                        let _e472 = p.member.map_size;
                        let _e542 = ((abs(((((_e445.row_x.x * _e470.x) + (_e445.row_x.y * _e470.y)) + (_e445.row_x.z * _e470.z)) / (((_e445.row_x.x * _e445.row_x.x) + (_e445.row_x.y * _e445.row_x.y)) + (_e445.row_x.z * _e445.row_x.z)))) + abs(((((_e445.row_y.x * _e470.x) + (_e445.row_y.y * _e470.y)) + (_e445.row_y.z * _e470.z)) / (((_e445.row_y.x * _e445.row_y.x) + (_e445.row_y.y * _e445.row_y.y)) + (_e445.row_y.z * _e445.row_y.z))))) / (abs(((((_e445.row_z.x * _e470.x) + (_e445.row_z.y * _e470.y)) + (_e445.row_z.z * _e470.z)) / (((_e445.row_z.x * _e445.row_z.x) + (_e445.row_z.y * _e445.row_z.y)) + (_e445.row_z.z * _e445.row_z.z)))) * f32(_e472)));
                        if (_e542 < 0.002f) {
                            phi_1167_ = _e542;
                        } else {
                            phi_1167_ = 0.002f;
                        }
                        let _e545 = phi_1167_;
                        phi_1286_ = _e545;
                    } else {
                        let _e547 = p.member.map_size;
                        let _e553 = samples.member[_e78.first_primitive].position;
                        let _e564 = ((((_e445.row_w.x * _e553.x) + (_e445.row_w.y * _e553.y)) + (_e445.row_w.z * _e553.z)) + _e445.row_w.w);
                        let _e577 = ((_e445.row_x.x - (_e445.row_w.x * _e434.point.uv.x)) / _e564);
                        let _e578 = ((_e445.row_x.y - (_e445.row_w.y * _e434.point.uv.x)) / _e564);
                        let _e579 = ((_e445.row_x.z - (_e445.row_w.z * _e434.point.uv.x)) / _e564);
                        let _e592 = ((_e445.row_y.x - (_e445.row_w.x * _e434.point.uv.y)) / _e564);
                        let _e593 = ((_e445.row_y.y - (_e445.row_w.y * _e434.point.uv.y)) / _e564);
                        let _e594 = ((_e445.row_y.z - (_e445.row_w.z * _e434.point.uv.y)) / _e564);
                        let _e600 = samples.member[_e78.first_primitive].normal;
                        let _e605 = ((_e593 * _e600.z) - (_e600.y * _e594));
                        let _e610 = ((_e594 * _e600.x) - (_e600.z * _e592));
                        let _e615 = ((_e592 * _e600.y) - (_e600.x * _e593));
                        let _e617 = samples.member[_e78.first_primitive].normal;
                        let _e622 = ((_e578 * _e617.z) - (_e617.y * _e579));
                        let _e627 = ((_e579 * _e617.x) - (_e617.z * _e577));
                        let _e632 = ((_e577 * _e617.y) - (_e617.x * _e578));
                        let _e659 = ((abs(((((_e445.row_z.x * _e605) + (_e445.row_z.y * _e610)) + (_e445.row_z.z * _e615)) / (((_e577 * _e605) + (_e578 * _e610)) + (_e579 * _e615)))) + abs(((((_e445.row_z.x * _e622) + (_e445.row_z.y * _e627)) + (_e445.row_z.z * _e632)) / (((_e592 * _e622) + (_e593 * _e627)) + (_e594 * _e632))))) / f32(_e547));
                        let _e661 = (16f / f32(_e547));
                        if (_e659 < _e661) {
                            phi_1285_ = _e659;
                        } else {
                            phi_1285_ = _e661;
                        }
                        let _e664 = phi_1285_;
                        phi_1286_ = _e664;
                    }
                    let _e666 = phi_1286_;
                    phi_1289_ = (_e434.point.depth - (0f * _e666));
                } else {
                    phi_1289_ = _e434.point.depth;
                }
                let _e670 = phi_1289_;
                let _e676 = p.member.map_size;
                let _e677 = f32(_e676);
                let _e680 = ((_e434.point.uv.x * _e677) - 0.5f);
                let _e681 = ((_e434.point.uv.y * _e677) - 0.5f);
                if (_e680 > -8388608f) {
                    let _e693 = f32(select(0i, select(select(i32(_e680), i32(-2147483648), (_e680 < bitcast<f32>(3472883712u))), 2147483647i, (_e680 > bitcast<f32>(1325400063u))), (_e680 == _e680)));
                    if (_e693 > _e680) {
                        phi_1318_ = 1f;
                    } else {
                        phi_1318_ = 0f;
                    }
                    let _e696 = phi_1318_;
                    if (_e680 < 8388608f) {
                        phi_1323_ = (_e693 - _e696);
                        phi_1324_ = false;
                    } else {
                        phi_1323_ = f32();
                        phi_1324_ = true;
                    }
                    let _e699 = phi_1323_;
                    let _e701 = phi_1324_;
                    phi_1325_ = _e699;
                    phi_1326_ = _e701;
                } else {
                    phi_1325_ = f32();
                    phi_1326_ = true;
                }
                let _e703 = phi_1325_;
                let _e705 = phi_1326_;
                if _e705 {
                    phi_1330_ = _e680;
                } else {
                    phi_1330_ = _e703;
                }
                let _e707 = phi_1330_;
                if (_e681 > -8388608f) {
                    let _e719 = f32(select(0i, select(select(i32(_e681), i32(-2147483648), (_e681 < bitcast<f32>(3472883712u))), 2147483647i, (_e681 > bitcast<f32>(1325400063u))), (_e681 == _e681)));
                    if (_e719 > _e681) {
                        phi_1350_ = 1f;
                    } else {
                        phi_1350_ = 0f;
                    }
                    let _e722 = phi_1350_;
                    if (_e681 < 8388608f) {
                        phi_1355_ = (_e719 - _e722);
                        phi_1356_ = false;
                    } else {
                        phi_1355_ = f32();
                        phi_1356_ = true;
                    }
                    let _e725 = phi_1355_;
                    let _e727 = phi_1356_;
                    phi_1357_ = _e725;
                    phi_1358_ = _e727;
                } else {
                    phi_1357_ = f32();
                    phi_1358_ = true;
                }
                let _e729 = phi_1357_;
                let _e731 = phi_1358_;
                if _e731 {
                    phi_1362_ = _e681;
                } else {
                    phi_1362_ = _e729;
                }
                let _e733 = phi_1362_;
                let _e734 = (_e680 - _e707);
                let _e735 = (_e681 - _e733);
                let _e744 = select(0i, select(select(i32(_e707), i32(-2147483648), (_e707 < bitcast<f32>(3472883712u))), 2147483647i, (_e707 > bitcast<f32>(1325400063u))), (_e707 == _e707));
                let _e753 = select(0i, select(select(i32(_e733), i32(-2147483648), (_e733 < bitcast<f32>(3472883712u))), 2147483647i, (_e733 > bitcast<f32>(1325400063u))), (_e733 == _e733));
                let _e764 = p.member.test;
                let _e765 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e764);
                let _e767 = p.member.map_size;
                let _e769 = local_4;
                local_1 = _e765;
                let _e772 = ((_e769.level * _e767) * _e767);
                let _e774 = (bitcast<i32>(_e767) - 1i);
                if (_e744 > 0i) {
                    phi_1411_ = _e744;
                } else {
                    phi_1411_ = 0i;
                }
                let _e777 = phi_1411_;
                if (_e753 > 0i) {
                    phi_1416_ = _e753;
                } else {
                    phi_1416_ = 0i;
                }
                let _e780 = phi_1416_;
                if (_e777 < _e774) {
                    phi_1421_ = _e777;
                } else {
                    phi_1421_ = _e774;
                }
                let _e783 = phi_1421_;
                if (_e780 < _e774) {
                    phi_1426_ = _e780;
                } else {
                    phi_1426_ = _e774;
                }
                let _e786 = phi_1426_;
                let _e787 = bitcast<u32>(_e783);
                let _e789 = (_e744 + 1i);
                let _e790 = (_e753 + 1i);
                if (_e789 > 0i) {
                    phi_1435_ = _e789;
                } else {
                    phi_1435_ = 0i;
                }
                let _e793 = phi_1435_;
                if (_e790 > 0i) {
                    phi_1440_ = _e790;
                } else {
                    phi_1440_ = 0i;
                }
                let _e796 = phi_1440_;
                if (_e793 < _e774) {
                    phi_1445_ = _e793;
                } else {
                    phi_1445_ = _e774;
                }
                let _e799 = phi_1445_;
                if (_e796 < _e774) {
                    phi_1450_ = _e796;
                } else {
                    phi_1450_ = _e774;
                }
                let _e802 = phi_1450_;
                let _e803 = bitcast<u32>(_e799);
                let _e805 = (bitcast<u32>(_e786) * _e767);
                let _e806 = (bitcast<u32>(_e802) * _e767);
                let _e811 = ((_e805 + _e787) + _e772);
                let _e812 = ((_e805 + _e803) + _e772);
                let _e813 = ((_e806 + _e787) + _e772);
                let _e814 = ((_e806 + _e803) + _e772);
                if (_e811 < _e67) {
                } else {
                    return;
                }
                let _e818 = map.member[(0u + _e811)];
                if (_e812 < _e67) {
                } else {
                    return;
                }
                let _e822 = map.member[(0u + _e812)];
                if (_e813 < _e67) {
                } else {
                    return;
                }
                let _e826 = map.member[(0u + _e813)];
                if (_e814 < _e67) {
                } else {
                    return;
                }
                let _e830 = map.member[(0u + _e814)];
                let _e832 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e818, _e822, _e826, _e830), vec4<f32>(((1f - _e734) * (1f - _e735)), (_e734 * (1f - _e735)), ((1f - _e734) * _e735), (_e734 * _e735)), _e670);
                let _e836 = p.member.epsilon;
                if (_e832 <= _e836) {
                    phi_1503_ = true;
                } else {
                    phi_1503_ = (_e832 >= (1f - _e836));
                }
                let _e841 = phi_1503_;
                if ((bitcast<u32>(_e832) & 2147483647u) > 2139095040u) {
                    phi_1511_ = true;
                } else {
                    phi_1511_ = !(_e841);
                }
                let _e847 = phi_1511_;
                if _e847 {
                    if (_e832 > 0f) {
                        if (_e832 < 1f) {
                            phi_1523_ = false;
                        } else {
                            phi_1523_ = true;
                        }
                        let _e851 = phi_1523_;
                        phi_1524_ = _e851;
                    } else {
                        phi_1524_ = true;
                    }
                    let _e853 = phi_1524_;
                    if _e853 {
                        phi_1528_ = 0.5f;
                    } else {
                        phi_1528_ = _e832;
                    }
                    let _e855 = phi_1528_;
                    phi_1536_ = evaluate_Verdict(_e855, true);
                } else {
                    if (_e832 > 0.5f) {
                        phi_1534_ = 1f;
                    } else {
                        phi_1534_ = 0f;
                    }
                    let _e859 = phi_1534_;
                    phi_1536_ = evaluate_Verdict(_e859, false);
                }
                let _e862 = phi_1536_;
                let _e865 = (_e862.visibility < 0.5f);
                if _e862.is_doubted {
                    phi_1559_ = evaluate_Verdict();
                    phi_1560_ = true;
                } else {
                    if _e865 {
                        phi_1546_ = 2u;
                    } else {
                        phi_1546_ = 1u;
                    }
                    let _e867 = phi_1546_;
                    if ((0u & _e867) != 0u) {
                        if _e865 {
                            phi_1555_ = 0.000000059604645f;
                        } else {
                            phi_1555_ = 0.99999994f;
                        }
                        let _e871 = phi_1555_;
                        phi_1557_ = evaluate_Verdict(_e871, true);
                        phi_1558_ = false;
                    } else {
                        phi_1557_ = evaluate_Verdict();
                        phi_1558_ = true;
                    }
                    let _e874 = phi_1557_;
                    let _e876 = phi_1558_;
                    phi_1559_ = _e874;
                    phi_1560_ = _e876;
                }
                let _e878 = phi_1559_;
                let _e880 = phi_1560_;
                if _e880 {
                    phi_1565_ = evaluate_Verdict(_e862.visibility, _e862.is_doubted);
                } else {
                    phi_1565_ = _e878;
                }
                let _e883 = phi_1565_;
                phi_1570_ = evaluate_Verdict(_e883.visibility, _e883.is_doubted);
            } else {
                phi_1570_ = evaluate_Verdict(0.5f, true);
            }
            let _e889 = phi_1570_;
            phi_1571_ = _e889;
        }
        let _e891 = phi_1571_;
        visibility.member[_e78.first_primitive] = _e891.visibility;
        phi_1575_ = _e891.is_doubted;
        phi_1576_ = _e78.first_primitive;
    } else {
        phi_1575_ = false;
        phi_1576_ = 0u;
    }
    let _e896 = phi_1575_;
    let _e898 = phi_1576_;
    if (_e62 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e896 {
        let _e902 = atomicAdd((&shared_[0u]), 1u);
        phi_1587_ = _e902;
    } else {
        phi_1587_ = 0u;
    }
    let _e904 = phi_1587_;
    workgroupBarrier();
    if (_e62 == 0u) {
        let _e908 = atomicLoad((&shared_[0u]));
        let _e909 = atomicAdd((&list.member[3u]), _e908);
        atomicStore((&shared_[1u]), _e909);
    }
    workgroupBarrier();
    if _e896 {
        if false {
            phi_1604_ = (_e898 | 2147483648u);
        } else {
            phi_1604_ = _e898;
        }
        let _e913 = phi_1604_;
        let _e915 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e915) + _e904)]), _e913);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
