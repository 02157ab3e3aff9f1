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

struct type_38 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct type_45 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_38;
@group(0) @binding(2) 
var<storage> map: type_24;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(4) 
var<storage, read_write> list: type_45;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_164_: lt_bvh_traverse_Tree;
    var phi_165_: bool;
    var phi_166_: lt_bvh_traverse_Tree;
    var phi_167_: bool;
    var phi_172_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_164_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_165_ = false;
        } else {
            phi_164_ = lt_bvh_traverse_Tree();
            phi_165_ = true;
        }
        let _e67 = phi_164_;
        let _e69 = phi_165_;
        phi_166_ = _e67;
        phi_167_ = _e69;
    } else {
        phi_166_ = lt_bvh_traverse_Tree();
        phi_167_ = true;
    }
    let _e71 = phi_166_;
    let _e73 = phi_167_;
    if _e73 {
        phi_172_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_172_ = _e71;
    }
    let _e78 = phi_172_;
    return lt_bvh_traverse_Tree(_e78.root, _e78.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_195_: bool;
    var phi_199_: f32;
    var phi_214_: f32;
    var phi_215_: f32;
    var phi_216_: f32;
    var phi_232_: f32;
    var phi_233_: f32;
    var phi_234_: f32;
    var phi_250_: f32;
    var phi_251_: f32;
    var phi_252_: f32;
    var phi_268_: f32;
    var phi_269_: f32;
    var phi_270_: f32;
    var phi_286_: f32;
    var phi_287_: f32;
    var phi_288_: f32;
    var phi_307_: f32;
    var phi_312_: f32;
    var phi_334_: f32;
    var phi_339_: f32;
    var phi_340_: bool;
    var phi_341_: f32;
    var phi_342_: bool;
    var phi_346_: f32;
    var phi_384_: f32;
    var phi_395_: f32;
    var phi_400_: f32;
    var phi_422_: f32;
    var phi_427_: f32;
    var phi_428_: bool;
    var phi_429_: f32;
    var phi_430_: bool;
    var phi_434_: f32;
    var phi_472_: f32;
    var phi_483_: f32;
    var phi_488_: f32;
    var phi_510_: f32;
    var phi_515_: f32;
    var phi_516_: bool;
    var phi_517_: f32;
    var phi_518_: bool;
    var phi_522_: f32;
    var phi_560_: f32;
    var phi_571_: f32;
    var phi_576_: f32;
    var phi_598_: f32;
    var phi_603_: f32;
    var phi_604_: bool;
    var phi_605_: f32;
    var phi_606_: bool;
    var phi_610_: f32;
    var phi_648_: f32;
    var phi_674_: f32;
    var phi_675_: f32;
    var phi_676_: f32;

    let _e58 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_195_ = true;
    } else {
        let _e62 = (84f < _e58);
        if _e62 {
        }
        phi_195_ = _e62;
    }
    let _e64 = phi_195_;
    if _e64 {
        phi_199_ = 84f;
    } else {
        phi_199_ = _e58;
    }
    let _e66 = phi_199_;
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_216_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_215_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_214_ = 1f;
            } else {
                phi_214_ = param_7;
            }
            let _e73 = phi_214_;
            phi_215_ = _e73;
        }
        let _e75 = phi_215_;
        phi_216_ = _e75;
    }
    let _e77 = phi_216_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_234_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_233_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_232_ = 1f;
            } else {
                phi_232_ = param_5.x;
            }
            let _e85 = phi_232_;
            phi_233_ = _e85;
        }
        let _e87 = phi_233_;
        phi_234_ = _e87;
    }
    let _e89 = phi_234_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_252_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_251_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_250_ = 1f;
            } else {
                phi_250_ = param_5.y;
            }
            let _e97 = phi_250_;
            phi_251_ = _e97;
        }
        let _e99 = phi_251_;
        phi_252_ = _e99;
    }
    let _e101 = phi_252_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_270_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_269_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_268_ = 1f;
            } else {
                phi_268_ = param_5.z;
            }
            let _e109 = phi_268_;
            phi_269_ = _e109;
        }
        let _e111 = phi_269_;
        phi_270_ = _e111;
    }
    let _e113 = phi_270_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_288_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_287_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_286_ = 1f;
            } else {
                phi_286_ = param_5.w;
            }
            let _e121 = phi_286_;
            phi_287_ = _e121;
        }
        let _e123 = phi_287_;
        phi_288_ = _e123;
    }
    let _e125 = phi_288_;
    let _e130 = (_e66 * (_e89 - _e77));
    let _e131 = (_e66 * (_e101 - _e77));
    let _e132 = (_e66 * (_e113 - _e77));
    let _e133 = (_e66 * (_e125 - _e77));
    if ((bitcast<u32>(_e130) & 2147483647u) > 2139095040u) {
        phi_384_ = _e130;
    } else {
        if (_e130 < -87f) {
            phi_307_ = -87f;
        } else {
            phi_307_ = _e130;
        }
        let _e139 = phi_307_;
        if (_e139 > 88f) {
            phi_312_ = 88f;
        } else {
            phi_312_ = _e139;
        }
        let _e142 = phi_312_;
        let _e144 = ((_e142 * 1.442695f) + 0.5f);
        if (_e144 > -8388608f) {
            let _e156 = f32(select(0i, select(select(i32(_e144), i32(-2147483648), (_e144 < bitcast<f32>(3472883712u))), 2147483647i, (_e144 > bitcast<f32>(1325400063u))), (_e144 == _e144)));
            if (_e156 > _e144) {
                phi_334_ = 1f;
            } else {
                phi_334_ = 0f;
            }
            let _e159 = phi_334_;
            if (_e144 < 8388608f) {
                phi_339_ = (_e156 - _e159);
                phi_340_ = false;
            } else {
                phi_339_ = f32();
                phi_340_ = true;
            }
            let _e162 = phi_339_;
            let _e164 = phi_340_;
            phi_341_ = _e162;
            phi_342_ = _e164;
        } else {
            phi_341_ = f32();
            phi_342_ = true;
        }
        let _e166 = phi_341_;
        let _e168 = phi_342_;
        if _e168 {
            phi_346_ = _e144;
        } else {
            phi_346_ = _e166;
        }
        let _e170 = phi_346_;
        let _e174 = ((_e142 - (_e170 * 0.69314575f)) - (_e170 * 0.0000014286068f));
        phi_384_ = ((((((((((((((((1f / 5040f) * _e174) + (1f / 720f)) * _e174) + (1f / 120f)) * _e174) + (1f / 24f)) * _e174) + (1f / 6f)) * _e174) + 0.5f) * _e174) + 1f) * _e174) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e170), i32(-2147483648), (_e170 < bitcast<f32>(3472883712u))), 2147483647i, (_e170 > bitcast<f32>(1325400063u))), (_e170 == _e170)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e210 = phi_384_;
    if ((bitcast<u32>(_e131) & 2147483647u) > 2139095040u) {
        phi_472_ = _e131;
    } else {
        if (_e131 < -87f) {
            phi_395_ = -87f;
        } else {
            phi_395_ = _e131;
        }
        let _e216 = phi_395_;
        if (_e216 > 88f) {
            phi_400_ = 88f;
        } else {
            phi_400_ = _e216;
        }
        let _e219 = phi_400_;
        let _e221 = ((_e219 * 1.442695f) + 0.5f);
        if (_e221 > -8388608f) {
            let _e233 = f32(select(0i, select(select(i32(_e221), i32(-2147483648), (_e221 < bitcast<f32>(3472883712u))), 2147483647i, (_e221 > bitcast<f32>(1325400063u))), (_e221 == _e221)));
            if (_e233 > _e221) {
                phi_422_ = 1f;
            } else {
                phi_422_ = 0f;
            }
            let _e236 = phi_422_;
            if (_e221 < 8388608f) {
                phi_427_ = (_e233 - _e236);
                phi_428_ = false;
            } else {
                phi_427_ = f32();
                phi_428_ = true;
            }
            let _e239 = phi_427_;
            let _e241 = phi_428_;
            phi_429_ = _e239;
            phi_430_ = _e241;
        } else {
            phi_429_ = f32();
            phi_430_ = true;
        }
        let _e243 = phi_429_;
        let _e245 = phi_430_;
        if _e245 {
            phi_434_ = _e221;
        } else {
            phi_434_ = _e243;
        }
        let _e247 = phi_434_;
        let _e251 = ((_e219 - (_e247 * 0.69314575f)) - (_e247 * 0.0000014286068f));
        phi_472_ = ((((((((((((((((1f / 5040f) * _e251) + (1f / 720f)) * _e251) + (1f / 120f)) * _e251) + (1f / 24f)) * _e251) + (1f / 6f)) * _e251) + 0.5f) * _e251) + 1f) * _e251) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e247), i32(-2147483648), (_e247 < bitcast<f32>(3472883712u))), 2147483647i, (_e247 > bitcast<f32>(1325400063u))), (_e247 == _e247)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e287 = phi_472_;
    if ((bitcast<u32>(_e132) & 2147483647u) > 2139095040u) {
        phi_560_ = _e132;
    } else {
        if (_e132 < -87f) {
            phi_483_ = -87f;
        } else {
            phi_483_ = _e132;
        }
        let _e293 = phi_483_;
        if (_e293 > 88f) {
            phi_488_ = 88f;
        } else {
            phi_488_ = _e293;
        }
        let _e296 = phi_488_;
        let _e298 = ((_e296 * 1.442695f) + 0.5f);
        if (_e298 > -8388608f) {
            let _e310 = f32(select(0i, select(select(i32(_e298), i32(-2147483648), (_e298 < bitcast<f32>(3472883712u))), 2147483647i, (_e298 > bitcast<f32>(1325400063u))), (_e298 == _e298)));
            if (_e310 > _e298) {
                phi_510_ = 1f;
            } else {
                phi_510_ = 0f;
            }
            let _e313 = phi_510_;
            if (_e298 < 8388608f) {
                phi_515_ = (_e310 - _e313);
                phi_516_ = false;
            } else {
                phi_515_ = f32();
                phi_516_ = true;
            }
            let _e316 = phi_515_;
            let _e318 = phi_516_;
            phi_517_ = _e316;
            phi_518_ = _e318;
        } else {
            phi_517_ = f32();
            phi_518_ = true;
        }
        let _e320 = phi_517_;
        let _e322 = phi_518_;
        if _e322 {
            phi_522_ = _e298;
        } else {
            phi_522_ = _e320;
        }
        let _e324 = phi_522_;
        let _e328 = ((_e296 - (_e324 * 0.69314575f)) - (_e324 * 0.0000014286068f));
        phi_560_ = ((((((((((((((((1f / 5040f) * _e328) + (1f / 720f)) * _e328) + (1f / 120f)) * _e328) + (1f / 24f)) * _e328) + (1f / 6f)) * _e328) + 0.5f) * _e328) + 1f) * _e328) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e324), i32(-2147483648), (_e324 < bitcast<f32>(3472883712u))), 2147483647i, (_e324 > bitcast<f32>(1325400063u))), (_e324 == _e324)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e364 = phi_560_;
    if ((bitcast<u32>(_e133) & 2147483647u) > 2139095040u) {
        phi_648_ = _e133;
    } else {
        if (_e133 < -87f) {
            phi_571_ = -87f;
        } else {
            phi_571_ = _e133;
        }
        let _e370 = phi_571_;
        if (_e370 > 88f) {
            phi_576_ = 88f;
        } else {
            phi_576_ = _e370;
        }
        let _e373 = phi_576_;
        let _e375 = ((_e373 * 1.442695f) + 0.5f);
        if (_e375 > -8388608f) {
            let _e387 = f32(select(0i, select(select(i32(_e375), i32(-2147483648), (_e375 < bitcast<f32>(3472883712u))), 2147483647i, (_e375 > bitcast<f32>(1325400063u))), (_e375 == _e375)));
            if (_e387 > _e375) {
                phi_598_ = 1f;
            } else {
                phi_598_ = 0f;
            }
            let _e390 = phi_598_;
            if (_e375 < 8388608f) {
                phi_603_ = (_e387 - _e390);
                phi_604_ = false;
            } else {
                phi_603_ = f32();
                phi_604_ = true;
            }
            let _e393 = phi_603_;
            let _e395 = phi_604_;
            phi_605_ = _e393;
            phi_606_ = _e395;
        } else {
            phi_605_ = f32();
            phi_606_ = true;
        }
        let _e397 = phi_605_;
        let _e399 = phi_606_;
        if _e399 {
            phi_610_ = _e375;
        } else {
            phi_610_ = _e397;
        }
        let _e401 = phi_610_;
        let _e405 = ((_e373 - (_e401 * 0.69314575f)) - (_e401 * 0.0000014286068f));
        phi_648_ = ((((((((((((((((1f / 5040f) * _e405) + (1f / 720f)) * _e405) + (1f / 120f)) * _e405) + (1f / 24f)) * _e405) + (1f / 6f)) * _e405) + 0.5f) * _e405) + 1f) * _e405) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e401), i32(-2147483648), (_e401 < bitcast<f32>(3472883712u))), 2147483647i, (_e401 > bitcast<f32>(1325400063u))), (_e401 == _e401)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e441 = phi_648_;
    let _e452 = ((((_e210 * param_6.x) + (_e287 * param_6.y)) + (_e364 * param_6.z)) + (_e441 * param_6.w));
    if ((bitcast<u32>(_e452) & 2147483647u) > 2139095040u) {
        phi_676_ = _e452;
    } else {
        if (_e452 < 0f) {
            phi_675_ = 0f;
        } else {
            if (_e452 > 1f) {
                phi_674_ = 1f;
            } else {
                phi_674_ = _e452;
            }
            let _e459 = phi_674_;
            phi_675_ = _e459;
        }
        let _e461 = phi_675_;
        phi_676_ = _e461;
    }
    let _e463 = phi_676_;
    return _e463;
}

fn function_() {
    var local_1: f32;
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
    var phi_904_: bool;
    var phi_913_: bool;
    var phi_922_: bool;
    var phi_923_: bool;
    var phi_924_: bool;
    var phi_925_: bool;
    var phi_926_: bool;
    var phi_927_: bool;
    var phi_928_: bool;
    var phi_932_: bool;
    var phi_1022_: f32;
    var phi_1025_: f32;
    var phi_1054_: f32;
    var phi_1059_: f32;
    var phi_1060_: bool;
    var phi_1061_: f32;
    var phi_1062_: bool;
    var phi_1066_: f32;
    var phi_1086_: f32;
    var phi_1091_: f32;
    var phi_1092_: bool;
    var phi_1093_: f32;
    var phi_1094_: bool;
    var phi_1098_: f32;
    var phi_1146_: i32;
    var phi_1151_: i32;
    var phi_1156_: i32;
    var phi_1161_: i32;
    var phi_1170_: i32;
    var phi_1175_: i32;
    var phi_1180_: i32;
    var phi_1185_: i32;
    var phi_1238_: bool;
    var phi_1246_: bool;
    var phi_1258_: bool;
    var phi_1259_: bool;
    var phi_1263_: f32;
    var phi_1269_: f32;
    var phi_1271_: evaluate_Verdict;
    var phi_1281_: u32;
    var phi_1290_: f32;
    var phi_1292_: evaluate_Verdict;
    var phi_1293_: bool;
    var phi_1294_: evaluate_Verdict;
    var phi_1295_: bool;
    var phi_1300_: evaluate_Verdict;
    var phi_1305_: evaluate_Verdict;
    var phi_1306_: evaluate_Verdict;
    var phi_1310_: bool;
    var phi_1311_: u32;
    var phi_1322_: u32;
    var phi_1339_: u32;

    let _e55 = id_1;
    let _e56 = local_2;
    let _e61 = arrayLength((&map.member));
    let _e66 = p.member.size[0u];
    let _e68 = p.member.size[1u];
    let _e69 = lt_shaders_entry_pixel_index(_e55, _e66, _e68);
    if (bitcast<i32>(_e69.root) != 0i) {
        let _e76 = p.member.projection;
        let _e77 = lt_math_OneLevel(_e76);
        let _e81 = samples.member[_e69.first_primitive].normal[0u];
        let _e83 = global[0u];
        if (_e81 == _e83) {
            let _e86 = samples.member[_e69.first_primitive].normal[1u];
            let _e88 = global[1u];
            if (_e86 == _e88) {
                let _e91 = samples.member[_e69.first_primitive].normal[2u];
                let _e93 = global[2u];
                phi_727_ = (_e91 == _e93);
                phi_728_ = false;
            } else {
                phi_727_ = bool();
                phi_728_ = true;
            }
            let _e96 = phi_727_;
            let _e98 = phi_728_;
            phi_729_ = _e96;
            phi_730_ = _e98;
        } else {
            phi_729_ = bool();
            phi_730_ = true;
        }
        let _e100 = phi_729_;
        let _e102 = phi_730_;
        if _e102 {
            phi_734_ = false;
        } else {
            phi_734_ = _e100;
        }
        let _e104 = phi_734_;
        if !(_e104) {
            let _e107 = samples.member[_e69.first_primitive].position;
            let _e109 = p.member.light.place;
            let _e115 = p.member.light.place[3u];
            let _e122 = (_e109.x - (_e107.x * _e115));
            let _e123 = (_e109.y - (_e107.y * _e115));
            let _e124 = (_e109.z - (_e107.z * _e115));
            let _e126 = samples.member[_e69.first_primitive].normal;
            if ((((_e126.x * _e122) + (_e126.y * _e123)) + (_e126.z * _e124)) > 0f) {
                let _e140 = (((_e122 * _e122) + (_e123 * _e123)) + (_e124 * _e124));
                let _e142 = p.member.light.axis;
                let _e154 = p.member.light.place[3u];
                if (_e154 == 0f) {
                    phi_805_ = true;
                } else {
                    let _e157 = p.member.light.range_squared;
                    if (_e140 <= _e157) {
                        let _e160 = p.member.light.cos_outer;
                        phi_804_ = (-((((_e122 * _e142.x) + (_e123 * _e142.y)) + (_e124 * _e142.z))) >= (_e160 * sqrt(_e140)));
                    } else {
                        phi_804_ = false;
                    }
                    let _e165 = phi_804_;
                    phi_805_ = _e165;
                }
                let _e167 = phi_805_;
                if _e167 {
                    let _e169 = samples.member[_e69.first_primitive].flags;
                    let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e183 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e177.unnamed.visibility, false), _e177.unnamed_1);
                    phi_816_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e183.unnamed, ((_e169 & 1u) == 0u));
                    phi_817_ = false;
                } else {
                    phi_816_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_817_ = true;
                }
                let _e188 = phi_816_;
                let _e190 = phi_817_;
                phi_818_ = _e188;
                phi_819_ = _e190;
            } else {
                phi_818_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_819_ = true;
            }
            let _e192 = phi_818_;
            let _e194 = phi_819_;
            if _e194 {
                let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e206 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e200.unnamed.visibility, false), _e200.unnamed_1);
                phi_826_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e206.unnamed, true);
            } else {
                phi_826_ = _e192;
            }
            let _e211 = phi_826_;
            phi_830_ = _e211;
        } else {
            let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e223 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e217.unnamed.visibility, false), _e217.unnamed_1);
            phi_830_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e223.unnamed, true);
        }
        let _e228 = phi_830_;
        if _e228.unnamed_1 {
            phi_1306_ = evaluate_Verdict(_e228.unnamed.visibility, _e228.unnamed.is_doubted);
        } else {
            let _e236 = samples.member[_e69.first_primitive].position;
            let _e254 = ((((_e77.projection.row_w.x * _e236.x) + (_e77.projection.row_w.y * _e236.y)) + (_e77.projection.row_w.z * _e236.z)) + (_e77.projection.row_w.w * 1f));
            let _e268 = (((((_e77.projection.row_x.x * _e236.x) + (_e77.projection.row_x.y * _e236.y)) + (_e77.projection.row_x.z * _e236.z)) + (_e77.projection.row_x.w * 1f)) / _e254);
            let _e282 = (((((_e77.projection.row_y.x * _e236.x) + (_e77.projection.row_y.y * _e236.y)) + (_e77.projection.row_y.z * _e236.z)) + (_e77.projection.row_y.w * 1f)) / _e254);
            let _e295 = ((((_e77.projection.row_z.x * _e236.x) + (_e77.projection.row_z.y * _e236.y)) + (_e77.projection.row_z.z * _e236.z)) + (_e77.projection.row_z.w * 1f));
            if (_e254 > 0f) {
                if (_e268 >= 0f) {
                    phi_904_ = (_e268 <= 1f);
                } else {
                    phi_904_ = false;
                }
                let _e300 = phi_904_;
                if _e300 {
                    if (_e282 >= 0f) {
                        phi_913_ = (_e282 <= 1f);
                    } else {
                        phi_913_ = false;
                    }
                    let _e304 = phi_913_;
                    if _e304 {
                        if (_e295 >= 0f) {
                            phi_922_ = (_e295 <= 1f);
                        } else {
                            phi_922_ = false;
                        }
                        let _e308 = phi_922_;
                        phi_923_ = _e308;
                        phi_924_ = false;
                    } else {
                        phi_923_ = bool();
                        phi_924_ = true;
                    }
                    let _e310 = phi_923_;
                    let _e312 = phi_924_;
                    phi_925_ = _e310;
                    phi_926_ = _e312;
                } else {
                    phi_925_ = bool();
                    phi_926_ = true;
                }
                let _e314 = phi_925_;
                let _e316 = phi_926_;
                phi_927_ = _e314;
                phi_928_ = _e316;
            } else {
                phi_927_ = bool();
                phi_928_ = true;
            }
            let _e318 = phi_927_;
            let _e320 = phi_928_;
            if _e320 {
                phi_932_ = false;
            } else {
                phi_932_ = _e318;
            }
            let _e322 = phi_932_;
            if _e322 {
                if (0f > 0f) {
                    let _e325 = samples.member[_e69.first_primitive].normal;
                    let _e327 = p.member.map_size;
                    let _e397 = ((abs(((((_e76.row_x.x * _e325.x) + (_e76.row_x.y * _e325.y)) + (_e76.row_x.z * _e325.z)) / (((_e76.row_x.x * _e76.row_x.x) + (_e76.row_x.y * _e76.row_x.y)) + (_e76.row_x.z * _e76.row_x.z)))) + abs(((((_e76.row_y.x * _e325.x) + (_e76.row_y.y * _e325.y)) + (_e76.row_y.z * _e325.z)) / (((_e76.row_y.x * _e76.row_y.x) + (_e76.row_y.y * _e76.row_y.y)) + (_e76.row_y.z * _e76.row_y.z))))) / (abs(((((_e76.row_z.x * _e325.x) + (_e76.row_z.y * _e325.y)) + (_e76.row_z.z * _e325.z)) / (((_e76.row_z.x * _e76.row_z.x) + (_e76.row_z.y * _e76.row_z.y)) + (_e76.row_z.z * _e76.row_z.z)))) * f32(_e327)));
                    if (_e397 < 0.002f) {
                        phi_1022_ = _e397;
                    } else {
                        phi_1022_ = 0.002f;
                    }
                    let _e400 = phi_1022_;
                    phi_1025_ = (_e295 - (0f * _e400));
                } else {
                    phi_1025_ = _e295;
                }
                let _e404 = phi_1025_;
                let _e406 = p.member.map_size;
                let _e407 = f32(_e406);
                let _e410 = ((_e268 * _e407) - 0.5f);
                let _e411 = ((_e282 * _e407) - 0.5f);
                if (_e410 > -8388608f) {
                    let _e423 = f32(select(0i, select(select(i32(_e410), i32(-2147483648), (_e410 < bitcast<f32>(3472883712u))), 2147483647i, (_e410 > bitcast<f32>(1325400063u))), (_e410 == _e410)));
                    if (_e423 > _e410) {
                        phi_1054_ = 1f;
                    } else {
                        phi_1054_ = 0f;
                    }
                    let _e426 = phi_1054_;
                    if (_e410 < 8388608f) {
                        phi_1059_ = (_e423 - _e426);
                        phi_1060_ = false;
                    } else {
                        phi_1059_ = f32();
                        phi_1060_ = true;
                    }
                    let _e429 = phi_1059_;
                    let _e431 = phi_1060_;
                    phi_1061_ = _e429;
                    phi_1062_ = _e431;
                } else {
                    phi_1061_ = f32();
                    phi_1062_ = true;
                }
                let _e433 = phi_1061_;
                let _e435 = phi_1062_;
                if _e435 {
                    phi_1066_ = _e410;
                } else {
                    phi_1066_ = _e433;
                }
                let _e437 = phi_1066_;
                if (_e411 > -8388608f) {
                    let _e449 = f32(select(0i, select(select(i32(_e411), i32(-2147483648), (_e411 < bitcast<f32>(3472883712u))), 2147483647i, (_e411 > bitcast<f32>(1325400063u))), (_e411 == _e411)));
                    if (_e449 > _e411) {
                        phi_1086_ = 1f;
                    } else {
                        phi_1086_ = 0f;
                    }
                    let _e452 = phi_1086_;
                    if (_e411 < 8388608f) {
                        phi_1091_ = (_e449 - _e452);
                        phi_1092_ = false;
                    } else {
                        phi_1091_ = f32();
                        phi_1092_ = true;
                    }
                    let _e455 = phi_1091_;
                    let _e457 = phi_1092_;
                    phi_1093_ = _e455;
                    phi_1094_ = _e457;
                } else {
                    phi_1093_ = f32();
                    phi_1094_ = true;
                }
                let _e459 = phi_1093_;
                let _e461 = phi_1094_;
                if _e461 {
                    phi_1098_ = _e411;
                } else {
                    phi_1098_ = _e459;
                }
                let _e463 = phi_1098_;
                let _e464 = (_e410 - _e437);
                let _e465 = (_e411 - _e463);
                let _e474 = select(0i, select(select(i32(_e437), i32(-2147483648), (_e437 < bitcast<f32>(3472883712u))), 2147483647i, (_e437 > bitcast<f32>(1325400063u))), (_e437 == _e437));
                let _e483 = select(0i, select(select(i32(_e463), i32(-2147483648), (_e463 < bitcast<f32>(3472883712u))), 2147483647i, (_e463 > bitcast<f32>(1325400063u))), (_e463 == _e463));
                let _e494 = p.member.test;
                let _e495 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e494);
                let _e497 = p.member.map_size;
                local_1 = _e495;
                let _e499 = ((0u * _e497) * _e497);
                let _e501 = (bitcast<i32>(_e497) - 1i);
                if (_e474 > 0i) {
                    phi_1146_ = _e474;
                } else {
                    phi_1146_ = 0i;
                }
                let _e504 = phi_1146_;
                if (_e483 > 0i) {
                    phi_1151_ = _e483;
                } else {
                    phi_1151_ = 0i;
                }
                let _e507 = phi_1151_;
                if (_e504 < _e501) {
                    phi_1156_ = _e504;
                } else {
                    phi_1156_ = _e501;
                }
                let _e510 = phi_1156_;
                if (_e507 < _e501) {
                    phi_1161_ = _e507;
                } else {
                    phi_1161_ = _e501;
                }
                let _e513 = phi_1161_;
                let _e514 = bitcast<u32>(_e510);
                let _e516 = (_e474 + 1i);
                let _e517 = (_e483 + 1i);
                if (_e516 > 0i) {
                    phi_1170_ = _e516;
                } else {
                    phi_1170_ = 0i;
                }
                let _e520 = phi_1170_;
                if (_e517 > 0i) {
                    phi_1175_ = _e517;
                } else {
                    phi_1175_ = 0i;
                }
                let _e523 = phi_1175_;
                if (_e520 < _e501) {
                    phi_1180_ = _e520;
                } else {
                    phi_1180_ = _e501;
                }
                let _e526 = phi_1180_;
                if (_e523 < _e501) {
                    phi_1185_ = _e523;
                } else {
                    phi_1185_ = _e501;
                }
                let _e529 = phi_1185_;
                let _e530 = bitcast<u32>(_e526);
                let _e532 = (bitcast<u32>(_e513) * _e497);
                let _e533 = (bitcast<u32>(_e529) * _e497);
                let _e538 = ((_e532 + _e514) + _e499);
                let _e539 = ((_e532 + _e530) + _e499);
                let _e540 = ((_e533 + _e514) + _e499);
                let _e541 = ((_e533 + _e530) + _e499);
                if (_e538 < _e61) {
                } else {
                    return;
                }
                let _e545 = map.member[(0u + _e538)];
                if (_e539 < _e61) {
                } else {
                    return;
                }
                let _e549 = map.member[(0u + _e539)];
                if (_e540 < _e61) {
                } else {
                    return;
                }
                let _e553 = map.member[(0u + _e540)];
                if (_e541 < _e61) {
                } else {
                    return;
                }
                let _e557 = map.member[(0u + _e541)];
                let _e559 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e545, _e549, _e553, _e557), vec4<f32>(((1f - _e464) * (1f - _e465)), (_e464 * (1f - _e465)), ((1f - _e464) * _e465), (_e464 * _e465)), _e404);
                let _e563 = p.member.epsilon;
                if (_e559 <= _e563) {
                    phi_1238_ = true;
                } else {
                    phi_1238_ = (_e559 >= (1f - _e563));
                }
                let _e568 = phi_1238_;
                if ((bitcast<u32>(_e559) & 2147483647u) > 2139095040u) {
                    phi_1246_ = true;
                } else {
                    phi_1246_ = !(_e568);
                }
                let _e574 = phi_1246_;
                if _e574 {
                    if (_e559 > 0f) {
                        if (_e559 < 1f) {
                            phi_1258_ = false;
                        } else {
                            phi_1258_ = true;
                        }
                        let _e578 = phi_1258_;
                        phi_1259_ = _e578;
                    } else {
                        phi_1259_ = true;
                    }
                    let _e580 = phi_1259_;
                    if _e580 {
                        phi_1263_ = 0.5f;
                    } else {
                        phi_1263_ = _e559;
                    }
                    let _e582 = phi_1263_;
                    phi_1271_ = evaluate_Verdict(_e582, true);
                } else {
                    if (_e559 > 0.5f) {
                        phi_1269_ = 1f;
                    } else {
                        phi_1269_ = 0f;
                    }
                    let _e586 = phi_1269_;
                    phi_1271_ = evaluate_Verdict(_e586, false);
                }
                let _e589 = phi_1271_;
                let _e592 = (_e589.visibility < 0.5f);
                if _e589.is_doubted {
                    phi_1294_ = evaluate_Verdict();
                    phi_1295_ = true;
                } else {
                    if _e592 {
                        phi_1281_ = 2u;
                    } else {
                        phi_1281_ = 1u;
                    }
                    let _e594 = phi_1281_;
                    if ((0u & _e594) != 0u) {
                        if _e592 {
                            phi_1290_ = 0.000000059604645f;
                        } else {
                            phi_1290_ = 0.99999994f;
                        }
                        let _e598 = phi_1290_;
                        phi_1292_ = evaluate_Verdict(_e598, true);
                        phi_1293_ = false;
                    } else {
                        phi_1292_ = evaluate_Verdict();
                        phi_1293_ = true;
                    }
                    let _e601 = phi_1292_;
                    let _e603 = phi_1293_;
                    phi_1294_ = _e601;
                    phi_1295_ = _e603;
                }
                let _e605 = phi_1294_;
                let _e607 = phi_1295_;
                if _e607 {
                    phi_1300_ = evaluate_Verdict(_e589.visibility, _e589.is_doubted);
                } else {
                    phi_1300_ = _e605;
                }
                let _e610 = phi_1300_;
                phi_1305_ = evaluate_Verdict(_e610.visibility, _e610.is_doubted);
            } else {
                phi_1305_ = evaluate_Verdict(0.5f, true);
            }
            let _e616 = phi_1305_;
            phi_1306_ = _e616;
        }
        let _e618 = phi_1306_;
        visibility.member[_e69.first_primitive] = _e618.visibility;
        phi_1310_ = _e618.is_doubted;
        phi_1311_ = _e69.first_primitive;
    } else {
        phi_1310_ = false;
        phi_1311_ = 0u;
    }
    let _e623 = phi_1310_;
    let _e625 = phi_1311_;
    if (_e56 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e623 {
        let _e629 = atomicAdd((&shared_[0u]), 1u);
        phi_1322_ = _e629;
    } else {
        phi_1322_ = 0u;
    }
    let _e631 = phi_1322_;
    workgroupBarrier();
    if (_e56 == 0u) {
        let _e635 = atomicLoad((&shared_[0u]));
        let _e636 = atomicAdd((&list.member[3u]), _e635);
        atomicStore((&shared_[1u]), _e636);
    }
    workgroupBarrier();
    if _e623 {
        if false {
            phi_1339_ = (_e625 | 2147483648u);
        } else {
            phi_1339_ = _e625;
        }
        let _e640 = phi_1339_;
        let _e642 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e642) + _e631)]), _e640);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
