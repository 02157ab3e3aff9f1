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
    var phi_146_: lt_bvh_traverse_Tree;
    var phi_147_: bool;
    var phi_148_: lt_bvh_traverse_Tree;
    var phi_149_: bool;
    var phi_154_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_146_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_147_ = false;
        } else {
            phi_146_ = lt_bvh_traverse_Tree();
            phi_147_ = true;
        }
        let _e62 = phi_146_;
        let _e64 = phi_147_;
        phi_148_ = _e62;
        phi_149_ = _e64;
    } else {
        phi_148_ = lt_bvh_traverse_Tree();
        phi_149_ = true;
    }
    let _e66 = phi_148_;
    let _e68 = phi_149_;
    if _e68 {
        phi_154_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_154_ = _e66;
    }
    let _e73 = phi_154_;
    return lt_bvh_traverse_Tree(_e73.root, _e73.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_177_: bool;
    var phi_181_: f32;
    var phi_196_: f32;
    var phi_197_: f32;
    var phi_198_: f32;
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
    var phi_289_: f32;
    var phi_294_: f32;
    var phi_316_: f32;
    var phi_321_: f32;
    var phi_322_: bool;
    var phi_323_: f32;
    var phi_324_: bool;
    var phi_328_: f32;
    var phi_366_: f32;
    var phi_377_: f32;
    var phi_382_: f32;
    var phi_404_: f32;
    var phi_409_: f32;
    var phi_410_: bool;
    var phi_411_: f32;
    var phi_412_: bool;
    var phi_416_: f32;
    var phi_454_: f32;
    var phi_465_: f32;
    var phi_470_: f32;
    var phi_492_: f32;
    var phi_497_: f32;
    var phi_498_: bool;
    var phi_499_: f32;
    var phi_500_: bool;
    var phi_504_: f32;
    var phi_542_: f32;
    var phi_553_: f32;
    var phi_558_: f32;
    var phi_580_: f32;
    var phi_585_: f32;
    var phi_586_: bool;
    var phi_587_: f32;
    var phi_588_: bool;
    var phi_592_: f32;
    var phi_630_: f32;
    var phi_656_: f32;
    var phi_657_: f32;
    var phi_658_: f32;

    let _e53 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_177_ = true;
    } else {
        let _e57 = (84f < _e53);
        if _e57 {
        }
        phi_177_ = _e57;
    }
    let _e59 = phi_177_;
    if _e59 {
        phi_181_ = 84f;
    } else {
        phi_181_ = _e53;
    }
    let _e61 = phi_181_;
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_198_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_197_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_196_ = 1f;
            } else {
                phi_196_ = param_7;
            }
            let _e68 = phi_196_;
            phi_197_ = _e68;
        }
        let _e70 = phi_197_;
        phi_198_ = _e70;
    }
    let _e72 = phi_198_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_216_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_215_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_214_ = 1f;
            } else {
                phi_214_ = param_5.x;
            }
            let _e80 = phi_214_;
            phi_215_ = _e80;
        }
        let _e82 = phi_215_;
        phi_216_ = _e82;
    }
    let _e84 = phi_216_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_234_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_233_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_232_ = 1f;
            } else {
                phi_232_ = param_5.y;
            }
            let _e92 = phi_232_;
            phi_233_ = _e92;
        }
        let _e94 = phi_233_;
        phi_234_ = _e94;
    }
    let _e96 = phi_234_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_252_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_251_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_250_ = 1f;
            } else {
                phi_250_ = param_5.z;
            }
            let _e104 = phi_250_;
            phi_251_ = _e104;
        }
        let _e106 = phi_251_;
        phi_252_ = _e106;
    }
    let _e108 = phi_252_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_270_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_269_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_268_ = 1f;
            } else {
                phi_268_ = param_5.w;
            }
            let _e116 = phi_268_;
            phi_269_ = _e116;
        }
        let _e118 = phi_269_;
        phi_270_ = _e118;
    }
    let _e120 = phi_270_;
    let _e125 = (_e61 * (_e84 - _e72));
    let _e126 = (_e61 * (_e96 - _e72));
    let _e127 = (_e61 * (_e108 - _e72));
    let _e128 = (_e61 * (_e120 - _e72));
    if ((bitcast<u32>(_e125) & 2147483647u) > 2139095040u) {
        phi_366_ = _e125;
    } else {
        if (_e125 < -87f) {
            phi_289_ = -87f;
        } else {
            phi_289_ = _e125;
        }
        let _e134 = phi_289_;
        if (_e134 > 88f) {
            phi_294_ = 88f;
        } else {
            phi_294_ = _e134;
        }
        let _e137 = phi_294_;
        let _e139 = ((_e137 * 1.442695f) + 0.5f);
        if (_e139 > -8388608f) {
            let _e151 = f32(select(0i, select(select(i32(_e139), i32(-2147483648), (_e139 < bitcast<f32>(3472883712u))), 2147483647i, (_e139 > bitcast<f32>(1325400063u))), (_e139 == _e139)));
            if (_e151 > _e139) {
                phi_316_ = 1f;
            } else {
                phi_316_ = 0f;
            }
            let _e154 = phi_316_;
            if (_e139 < 8388608f) {
                phi_321_ = (_e151 - _e154);
                phi_322_ = false;
            } else {
                phi_321_ = f32();
                phi_322_ = true;
            }
            let _e157 = phi_321_;
            let _e159 = phi_322_;
            phi_323_ = _e157;
            phi_324_ = _e159;
        } else {
            phi_323_ = f32();
            phi_324_ = true;
        }
        let _e161 = phi_323_;
        let _e163 = phi_324_;
        if _e163 {
            phi_328_ = _e139;
        } else {
            phi_328_ = _e161;
        }
        let _e165 = phi_328_;
        let _e169 = ((_e137 - (_e165 * 0.69314575f)) - (_e165 * 0.0000014286068f));
        phi_366_ = ((((((((((((((((1f / 5040f) * _e169) + (1f / 720f)) * _e169) + (1f / 120f)) * _e169) + (1f / 24f)) * _e169) + (1f / 6f)) * _e169) + 0.5f) * _e169) + 1f) * _e169) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e165), i32(-2147483648), (_e165 < bitcast<f32>(3472883712u))), 2147483647i, (_e165 > bitcast<f32>(1325400063u))), (_e165 == _e165)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e205 = phi_366_;
    if ((bitcast<u32>(_e126) & 2147483647u) > 2139095040u) {
        phi_454_ = _e126;
    } else {
        if (_e126 < -87f) {
            phi_377_ = -87f;
        } else {
            phi_377_ = _e126;
        }
        let _e211 = phi_377_;
        if (_e211 > 88f) {
            phi_382_ = 88f;
        } else {
            phi_382_ = _e211;
        }
        let _e214 = phi_382_;
        let _e216 = ((_e214 * 1.442695f) + 0.5f);
        if (_e216 > -8388608f) {
            let _e228 = f32(select(0i, select(select(i32(_e216), i32(-2147483648), (_e216 < bitcast<f32>(3472883712u))), 2147483647i, (_e216 > bitcast<f32>(1325400063u))), (_e216 == _e216)));
            if (_e228 > _e216) {
                phi_404_ = 1f;
            } else {
                phi_404_ = 0f;
            }
            let _e231 = phi_404_;
            if (_e216 < 8388608f) {
                phi_409_ = (_e228 - _e231);
                phi_410_ = false;
            } else {
                phi_409_ = f32();
                phi_410_ = true;
            }
            let _e234 = phi_409_;
            let _e236 = phi_410_;
            phi_411_ = _e234;
            phi_412_ = _e236;
        } else {
            phi_411_ = f32();
            phi_412_ = true;
        }
        let _e238 = phi_411_;
        let _e240 = phi_412_;
        if _e240 {
            phi_416_ = _e216;
        } else {
            phi_416_ = _e238;
        }
        let _e242 = phi_416_;
        let _e246 = ((_e214 - (_e242 * 0.69314575f)) - (_e242 * 0.0000014286068f));
        phi_454_ = ((((((((((((((((1f / 5040f) * _e246) + (1f / 720f)) * _e246) + (1f / 120f)) * _e246) + (1f / 24f)) * _e246) + (1f / 6f)) * _e246) + 0.5f) * _e246) + 1f) * _e246) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e242), i32(-2147483648), (_e242 < bitcast<f32>(3472883712u))), 2147483647i, (_e242 > bitcast<f32>(1325400063u))), (_e242 == _e242)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e282 = phi_454_;
    if ((bitcast<u32>(_e127) & 2147483647u) > 2139095040u) {
        phi_542_ = _e127;
    } else {
        if (_e127 < -87f) {
            phi_465_ = -87f;
        } else {
            phi_465_ = _e127;
        }
        let _e288 = phi_465_;
        if (_e288 > 88f) {
            phi_470_ = 88f;
        } else {
            phi_470_ = _e288;
        }
        let _e291 = phi_470_;
        let _e293 = ((_e291 * 1.442695f) + 0.5f);
        if (_e293 > -8388608f) {
            let _e305 = f32(select(0i, select(select(i32(_e293), i32(-2147483648), (_e293 < bitcast<f32>(3472883712u))), 2147483647i, (_e293 > bitcast<f32>(1325400063u))), (_e293 == _e293)));
            if (_e305 > _e293) {
                phi_492_ = 1f;
            } else {
                phi_492_ = 0f;
            }
            let _e308 = phi_492_;
            if (_e293 < 8388608f) {
                phi_497_ = (_e305 - _e308);
                phi_498_ = false;
            } else {
                phi_497_ = f32();
                phi_498_ = true;
            }
            let _e311 = phi_497_;
            let _e313 = phi_498_;
            phi_499_ = _e311;
            phi_500_ = _e313;
        } else {
            phi_499_ = f32();
            phi_500_ = true;
        }
        let _e315 = phi_499_;
        let _e317 = phi_500_;
        if _e317 {
            phi_504_ = _e293;
        } else {
            phi_504_ = _e315;
        }
        let _e319 = phi_504_;
        let _e323 = ((_e291 - (_e319 * 0.69314575f)) - (_e319 * 0.0000014286068f));
        phi_542_ = ((((((((((((((((1f / 5040f) * _e323) + (1f / 720f)) * _e323) + (1f / 120f)) * _e323) + (1f / 24f)) * _e323) + (1f / 6f)) * _e323) + 0.5f) * _e323) + 1f) * _e323) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e319), i32(-2147483648), (_e319 < bitcast<f32>(3472883712u))), 2147483647i, (_e319 > bitcast<f32>(1325400063u))), (_e319 == _e319)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e359 = phi_542_;
    if ((bitcast<u32>(_e128) & 2147483647u) > 2139095040u) {
        phi_630_ = _e128;
    } else {
        if (_e128 < -87f) {
            phi_553_ = -87f;
        } else {
            phi_553_ = _e128;
        }
        let _e365 = phi_553_;
        if (_e365 > 88f) {
            phi_558_ = 88f;
        } else {
            phi_558_ = _e365;
        }
        let _e368 = phi_558_;
        let _e370 = ((_e368 * 1.442695f) + 0.5f);
        if (_e370 > -8388608f) {
            let _e382 = f32(select(0i, select(select(i32(_e370), i32(-2147483648), (_e370 < bitcast<f32>(3472883712u))), 2147483647i, (_e370 > bitcast<f32>(1325400063u))), (_e370 == _e370)));
            if (_e382 > _e370) {
                phi_580_ = 1f;
            } else {
                phi_580_ = 0f;
            }
            let _e385 = phi_580_;
            if (_e370 < 8388608f) {
                phi_585_ = (_e382 - _e385);
                phi_586_ = false;
            } else {
                phi_585_ = f32();
                phi_586_ = true;
            }
            let _e388 = phi_585_;
            let _e390 = phi_586_;
            phi_587_ = _e388;
            phi_588_ = _e390;
        } else {
            phi_587_ = f32();
            phi_588_ = true;
        }
        let _e392 = phi_587_;
        let _e394 = phi_588_;
        if _e394 {
            phi_592_ = _e370;
        } else {
            phi_592_ = _e392;
        }
        let _e396 = phi_592_;
        let _e400 = ((_e368 - (_e396 * 0.69314575f)) - (_e396 * 0.0000014286068f));
        phi_630_ = ((((((((((((((((1f / 5040f) * _e400) + (1f / 720f)) * _e400) + (1f / 120f)) * _e400) + (1f / 24f)) * _e400) + (1f / 6f)) * _e400) + 0.5f) * _e400) + 1f) * _e400) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e396), i32(-2147483648), (_e396 < bitcast<f32>(3472883712u))), 2147483647i, (_e396 > bitcast<f32>(1325400063u))), (_e396 == _e396)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e436 = phi_630_;
    let _e447 = ((((_e205 * param_6.x) + (_e282 * param_6.y)) + (_e359 * param_6.z)) + (_e436 * param_6.w));
    if ((bitcast<u32>(_e447) & 2147483647u) > 2139095040u) {
        phi_658_ = _e447;
    } else {
        if (_e447 < 0f) {
            phi_657_ = 0f;
        } else {
            if (_e447 > 1f) {
                phi_656_ = 1f;
            } else {
                phi_656_ = _e447;
            }
            let _e454 = phi_656_;
            phi_657_ = _e454;
        }
        let _e456 = phi_657_;
        phi_658_ = _e456;
    }
    let _e458 = phi_658_;
    return _e458;
}

fn function_() {
    var local: f32;
    var phi_714_: bool;
    var phi_715_: bool;
    var phi_716_: bool;
    var phi_717_: bool;
    var phi_721_: bool;
    var phi_791_: bool;
    var phi_792_: bool;
    var phi_803_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_804_: bool;
    var phi_805_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_806_: bool;
    var phi_813_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_817_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_891_: bool;
    var phi_900_: bool;
    var phi_909_: bool;
    var phi_910_: bool;
    var phi_911_: bool;
    var phi_912_: bool;
    var phi_913_: bool;
    var phi_914_: bool;
    var phi_915_: bool;
    var phi_919_: bool;
    var phi_1009_: f32;
    var phi_1012_: f32;
    var phi_1041_: f32;
    var phi_1046_: f32;
    var phi_1047_: bool;
    var phi_1048_: f32;
    var phi_1049_: bool;
    var phi_1053_: f32;
    var phi_1073_: f32;
    var phi_1078_: f32;
    var phi_1079_: bool;
    var phi_1080_: f32;
    var phi_1081_: bool;
    var phi_1085_: f32;
    var phi_1133_: i32;
    var phi_1138_: i32;
    var phi_1143_: i32;
    var phi_1148_: i32;
    var phi_1157_: i32;
    var phi_1162_: i32;
    var phi_1167_: i32;
    var phi_1172_: i32;
    var phi_1225_: bool;
    var phi_1233_: bool;
    var phi_1245_: bool;
    var phi_1246_: bool;
    var phi_1250_: f32;
    var phi_1256_: f32;
    var phi_1258_: evaluate_Verdict;
    var phi_1268_: u32;
    var phi_1277_: f32;
    var phi_1279_: evaluate_Verdict;
    var phi_1280_: bool;
    var phi_1281_: evaluate_Verdict;
    var phi_1282_: bool;
    var phi_1287_: evaluate_Verdict;
    var phi_1292_: evaluate_Verdict;
    var phi_1293_: evaluate_Verdict;

    let _e50 = id_1;
    let _e57 = arrayLength((&map.member));
    let _e63 = p.member.size[0u];
    let _e65 = p.member.size[1u];
    let _e66 = lt_shaders_entry_pixel_index(_e50, _e63, _e65);
    if (bitcast<i32>(_e66.root) != 0i) {
        let _e72 = p.member.projection;
        if (_e66.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e76 = lt_math_OneLevel(_e72);
        let _e80 = samples.member[(0u + _e66.first_primitive)].normal[0u];
        let _e82 = global[0u];
        if (_e80 == _e82) {
            let _e85 = samples.member[(0u + _e66.first_primitive)].normal[1u];
            let _e87 = global[1u];
            if (_e85 == _e87) {
                let _e90 = samples.member[(0u + _e66.first_primitive)].normal[2u];
                let _e92 = global[2u];
                phi_714_ = (_e90 == _e92);
                phi_715_ = false;
            } else {
                phi_714_ = bool();
                phi_715_ = true;
            }
            let _e95 = phi_714_;
            let _e97 = phi_715_;
            phi_716_ = _e95;
            phi_717_ = _e97;
        } else {
            phi_716_ = bool();
            phi_717_ = true;
        }
        let _e99 = phi_716_;
        let _e101 = phi_717_;
        if _e101 {
            phi_721_ = false;
        } else {
            phi_721_ = _e99;
        }
        let _e103 = phi_721_;
        if !(_e103) {
            let _e106 = samples.member[(0u + _e66.first_primitive)].position;
            let _e108 = p.member.light.place;
            let _e114 = p.member.light.place[3u];
            let _e121 = (_e108.x - (_e106.x * _e114));
            let _e122 = (_e108.y - (_e106.y * _e114));
            let _e123 = (_e108.z - (_e106.z * _e114));
            let _e125 = samples.member[(0u + _e66.first_primitive)].normal;
            if ((((_e125.x * _e121) + (_e125.y * _e122)) + (_e125.z * _e123)) > 0f) {
                let _e139 = (((_e121 * _e121) + (_e122 * _e122)) + (_e123 * _e123));
                let _e141 = p.member.light.axis;
                let _e153 = p.member.light.place[3u];
                if (_e153 == 0f) {
                    phi_792_ = true;
                } else {
                    let _e156 = p.member.light.range_squared;
                    if (_e139 <= _e156) {
                        let _e159 = p.member.light.cos_outer;
                        phi_791_ = (-((((_e121 * _e141.x) + (_e122 * _e141.y)) + (_e123 * _e141.z))) >= (_e159 * sqrt(_e139)));
                    } else {
                        phi_791_ = false;
                    }
                    let _e164 = phi_791_;
                    phi_792_ = _e164;
                }
                let _e166 = phi_792_;
                if _e166 {
                    let _e168 = samples.member[(0u + _e66.first_primitive)].flags;
                    let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e182 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e176.unnamed.visibility, false), _e176.unnamed_1);
                    phi_803_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e182.unnamed, ((_e168 & 1u) == 0u));
                    phi_804_ = false;
                } else {
                    phi_803_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_804_ = true;
                }
                let _e187 = phi_803_;
                let _e189 = phi_804_;
                phi_805_ = _e187;
                phi_806_ = _e189;
            } else {
                phi_805_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_806_ = true;
            }
            let _e191 = phi_805_;
            let _e193 = phi_806_;
            if _e193 {
                let _e199 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e199.unnamed.visibility, false), _e199.unnamed_1);
                phi_813_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e205.unnamed, true);
            } else {
                phi_813_ = _e191;
            }
            let _e210 = phi_813_;
            phi_817_ = _e210;
        } else {
            let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e216.unnamed.visibility, false), _e216.unnamed_1);
            phi_817_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e222.unnamed, true);
        }
        let _e227 = phi_817_;
        if _e227.unnamed_1 {
            phi_1293_ = evaluate_Verdict(_e227.unnamed.visibility, _e227.unnamed.is_doubted);
        } else {
            let _e235 = samples.member[(0u + _e66.first_primitive)].position;
            let _e253 = ((((_e76.projection.row_w.x * _e235.x) + (_e76.projection.row_w.y * _e235.y)) + (_e76.projection.row_w.z * _e235.z)) + (_e76.projection.row_w.w * 1f));
            let _e267 = (((((_e76.projection.row_x.x * _e235.x) + (_e76.projection.row_x.y * _e235.y)) + (_e76.projection.row_x.z * _e235.z)) + (_e76.projection.row_x.w * 1f)) / _e253);
            let _e281 = (((((_e76.projection.row_y.x * _e235.x) + (_e76.projection.row_y.y * _e235.y)) + (_e76.projection.row_y.z * _e235.z)) + (_e76.projection.row_y.w * 1f)) / _e253);
            let _e294 = ((((_e76.projection.row_z.x * _e235.x) + (_e76.projection.row_z.y * _e235.y)) + (_e76.projection.row_z.z * _e235.z)) + (_e76.projection.row_z.w * 1f));
            if (_e253 > 0f) {
                if (_e267 >= 0f) {
                    phi_891_ = (_e267 <= 1f);
                } else {
                    phi_891_ = false;
                }
                let _e299 = phi_891_;
                if _e299 {
                    if (_e281 >= 0f) {
                        phi_900_ = (_e281 <= 1f);
                    } else {
                        phi_900_ = false;
                    }
                    let _e303 = phi_900_;
                    if _e303 {
                        if (_e294 >= 0f) {
                            phi_909_ = (_e294 <= 1f);
                        } else {
                            phi_909_ = false;
                        }
                        let _e307 = phi_909_;
                        phi_910_ = _e307;
                        phi_911_ = false;
                    } else {
                        phi_910_ = bool();
                        phi_911_ = true;
                    }
                    let _e309 = phi_910_;
                    let _e311 = phi_911_;
                    phi_912_ = _e309;
                    phi_913_ = _e311;
                } else {
                    phi_912_ = bool();
                    phi_913_ = true;
                }
                let _e313 = phi_912_;
                let _e315 = phi_913_;
                phi_914_ = _e313;
                phi_915_ = _e315;
            } else {
                phi_914_ = bool();
                phi_915_ = true;
            }
            let _e317 = phi_914_;
            let _e319 = phi_915_;
            if _e319 {
                phi_919_ = false;
            } else {
                phi_919_ = _e317;
            }
            let _e321 = phi_919_;
            if _e321 {
                if (0f > 0f) {
                    let _e324 = samples.member[(0u + _e66.first_primitive)].normal;
                    let _e326 = p.member.map_size;
                    let _e396 = ((abs(((((_e72.row_x.x * _e324.x) + (_e72.row_x.y * _e324.y)) + (_e72.row_x.z * _e324.z)) / (((_e72.row_x.x * _e72.row_x.x) + (_e72.row_x.y * _e72.row_x.y)) + (_e72.row_x.z * _e72.row_x.z)))) + abs(((((_e72.row_y.x * _e324.x) + (_e72.row_y.y * _e324.y)) + (_e72.row_y.z * _e324.z)) / (((_e72.row_y.x * _e72.row_y.x) + (_e72.row_y.y * _e72.row_y.y)) + (_e72.row_y.z * _e72.row_y.z))))) / (abs(((((_e72.row_z.x * _e324.x) + (_e72.row_z.y * _e324.y)) + (_e72.row_z.z * _e324.z)) / (((_e72.row_z.x * _e72.row_z.x) + (_e72.row_z.y * _e72.row_z.y)) + (_e72.row_z.z * _e72.row_z.z)))) * f32(_e326)));
                    if (_e396 < 0.002f) {
                        phi_1009_ = _e396;
                    } else {
                        phi_1009_ = 0.002f;
                    }
                    let _e399 = phi_1009_;
                    phi_1012_ = (_e294 - (0f * _e399));
                } else {
                    phi_1012_ = _e294;
                }
                let _e403 = phi_1012_;
                let _e405 = p.member.map_size;
                let _e406 = f32(_e405);
                let _e409 = ((_e267 * _e406) - 0.5f);
                let _e410 = ((_e281 * _e406) - 0.5f);
                if (_e409 > -8388608f) {
                    let _e422 = f32(select(0i, select(select(i32(_e409), i32(-2147483648), (_e409 < bitcast<f32>(3472883712u))), 2147483647i, (_e409 > bitcast<f32>(1325400063u))), (_e409 == _e409)));
                    if (_e422 > _e409) {
                        phi_1041_ = 1f;
                    } else {
                        phi_1041_ = 0f;
                    }
                    let _e425 = phi_1041_;
                    if (_e409 < 8388608f) {
                        phi_1046_ = (_e422 - _e425);
                        phi_1047_ = false;
                    } else {
                        phi_1046_ = f32();
                        phi_1047_ = true;
                    }
                    let _e428 = phi_1046_;
                    let _e430 = phi_1047_;
                    phi_1048_ = _e428;
                    phi_1049_ = _e430;
                } else {
                    phi_1048_ = f32();
                    phi_1049_ = true;
                }
                let _e432 = phi_1048_;
                let _e434 = phi_1049_;
                if _e434 {
                    phi_1053_ = _e409;
                } else {
                    phi_1053_ = _e432;
                }
                let _e436 = phi_1053_;
                if (_e410 > -8388608f) {
                    let _e448 = f32(select(0i, select(select(i32(_e410), i32(-2147483648), (_e410 < bitcast<f32>(3472883712u))), 2147483647i, (_e410 > bitcast<f32>(1325400063u))), (_e410 == _e410)));
                    if (_e448 > _e410) {
                        phi_1073_ = 1f;
                    } else {
                        phi_1073_ = 0f;
                    }
                    let _e451 = phi_1073_;
                    if (_e410 < 8388608f) {
                        phi_1078_ = (_e448 - _e451);
                        phi_1079_ = false;
                    } else {
                        phi_1078_ = f32();
                        phi_1079_ = true;
                    }
                    let _e454 = phi_1078_;
                    let _e456 = phi_1079_;
                    phi_1080_ = _e454;
                    phi_1081_ = _e456;
                } else {
                    phi_1080_ = f32();
                    phi_1081_ = true;
                }
                let _e458 = phi_1080_;
                let _e460 = phi_1081_;
                if _e460 {
                    phi_1085_ = _e410;
                } else {
                    phi_1085_ = _e458;
                }
                let _e462 = phi_1085_;
                let _e463 = (_e409 - _e436);
                let _e464 = (_e410 - _e462);
                let _e473 = select(0i, select(select(i32(_e436), i32(-2147483648), (_e436 < bitcast<f32>(3472883712u))), 2147483647i, (_e436 > bitcast<f32>(1325400063u))), (_e436 == _e436));
                let _e482 = select(0i, select(select(i32(_e462), i32(-2147483648), (_e462 < bitcast<f32>(3472883712u))), 2147483647i, (_e462 > bitcast<f32>(1325400063u))), (_e462 == _e462));
                let _e493 = p.member.test;
                let _e494 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e493);
                let _e496 = p.member.map_size;
                local = _e494;
                let _e498 = ((0u * _e496) * _e496);
                let _e500 = (bitcast<i32>(_e496) - 1i);
                if (_e473 > 0i) {
                    phi_1133_ = _e473;
                } else {
                    phi_1133_ = 0i;
                }
                let _e503 = phi_1133_;
                if (_e482 > 0i) {
                    phi_1138_ = _e482;
                } else {
                    phi_1138_ = 0i;
                }
                let _e506 = phi_1138_;
                if (_e503 < _e500) {
                    phi_1143_ = _e503;
                } else {
                    phi_1143_ = _e500;
                }
                let _e509 = phi_1143_;
                if (_e506 < _e500) {
                    phi_1148_ = _e506;
                } else {
                    phi_1148_ = _e500;
                }
                let _e512 = phi_1148_;
                let _e513 = bitcast<u32>(_e509);
                let _e515 = (_e473 + 1i);
                let _e516 = (_e482 + 1i);
                if (_e515 > 0i) {
                    phi_1157_ = _e515;
                } else {
                    phi_1157_ = 0i;
                }
                let _e519 = phi_1157_;
                if (_e516 > 0i) {
                    phi_1162_ = _e516;
                } else {
                    phi_1162_ = 0i;
                }
                let _e522 = phi_1162_;
                if (_e519 < _e500) {
                    phi_1167_ = _e519;
                } else {
                    phi_1167_ = _e500;
                }
                let _e525 = phi_1167_;
                if (_e522 < _e500) {
                    phi_1172_ = _e522;
                } else {
                    phi_1172_ = _e500;
                }
                let _e528 = phi_1172_;
                let _e529 = bitcast<u32>(_e525);
                let _e531 = (bitcast<u32>(_e512) * _e496);
                let _e532 = (bitcast<u32>(_e528) * _e496);
                let _e537 = ((_e531 + _e513) + _e498);
                let _e538 = ((_e531 + _e529) + _e498);
                let _e539 = ((_e532 + _e513) + _e498);
                let _e540 = ((_e532 + _e529) + _e498);
                if (_e537 < _e57) {
                } else {
                    return;
                }
                let _e544 = map.member[(0u + _e537)];
                if (_e538 < _e57) {
                } else {
                    return;
                }
                let _e548 = map.member[(0u + _e538)];
                if (_e539 < _e57) {
                } else {
                    return;
                }
                let _e552 = map.member[(0u + _e539)];
                if (_e540 < _e57) {
                } else {
                    return;
                }
                let _e556 = map.member[(0u + _e540)];
                let _e558 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e544, _e548, _e552, _e556), vec4<f32>(((1f - _e463) * (1f - _e464)), (_e463 * (1f - _e464)), ((1f - _e463) * _e464), (_e463 * _e464)), _e403);
                let _e562 = p.member.epsilon;
                if (_e558 <= _e562) {
                    phi_1225_ = true;
                } else {
                    phi_1225_ = (_e558 >= (1f - _e562));
                }
                let _e567 = phi_1225_;
                if ((bitcast<u32>(_e558) & 2147483647u) > 2139095040u) {
                    phi_1233_ = true;
                } else {
                    phi_1233_ = !(_e567);
                }
                let _e573 = phi_1233_;
                if _e573 {
                    if (_e558 > 0f) {
                        if (_e558 < 1f) {
                            phi_1245_ = false;
                        } else {
                            phi_1245_ = true;
                        }
                        let _e577 = phi_1245_;
                        phi_1246_ = _e577;
                    } else {
                        phi_1246_ = true;
                    }
                    let _e579 = phi_1246_;
                    if _e579 {
                        phi_1250_ = 0.5f;
                    } else {
                        phi_1250_ = _e558;
                    }
                    let _e581 = phi_1250_;
                    phi_1258_ = evaluate_Verdict(_e581, true);
                } else {
                    if (_e558 > 0.5f) {
                        phi_1256_ = 1f;
                    } else {
                        phi_1256_ = 0f;
                    }
                    let _e585 = phi_1256_;
                    phi_1258_ = evaluate_Verdict(_e585, false);
                }
                let _e588 = phi_1258_;
                let _e591 = (_e588.visibility < 0.5f);
                if _e588.is_doubted {
                    phi_1281_ = evaluate_Verdict();
                    phi_1282_ = true;
                } else {
                    if _e591 {
                        phi_1268_ = 2u;
                    } else {
                        phi_1268_ = 1u;
                    }
                    let _e593 = phi_1268_;
                    if ((0u & _e593) != 0u) {
                        if _e591 {
                            phi_1277_ = 0.000000059604645f;
                        } else {
                            phi_1277_ = 0.99999994f;
                        }
                        let _e597 = phi_1277_;
                        phi_1279_ = evaluate_Verdict(_e597, true);
                        phi_1280_ = false;
                    } else {
                        phi_1279_ = evaluate_Verdict();
                        phi_1280_ = true;
                    }
                    let _e600 = phi_1279_;
                    let _e602 = phi_1280_;
                    phi_1281_ = _e600;
                    phi_1282_ = _e602;
                }
                let _e604 = phi_1281_;
                let _e606 = phi_1282_;
                if _e606 {
                    phi_1287_ = evaluate_Verdict(_e588.visibility, _e588.is_doubted);
                } else {
                    phi_1287_ = _e604;
                }
                let _e609 = phi_1287_;
                phi_1292_ = evaluate_Verdict(_e609.visibility, _e609.is_doubted);
            } else {
                phi_1292_ = evaluate_Verdict(0.5f, true);
            }
            let _e615 = phi_1292_;
            phi_1293_ = _e615;
        }
        let _e617 = phi_1293_;
        if (_e66.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e66.first_primitive)] = _e617.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
