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
        let _e63 = phi_158_;
        let _e65 = phi_159_;
        phi_160_ = _e63;
        phi_161_ = _e65;
    } else {
        phi_160_ = lt_bvh_traverse_Tree();
        phi_161_ = true;
    }
    let _e67 = phi_160_;
    let _e69 = phi_161_;
    if _e69 {
        phi_166_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_166_ = _e67;
    }
    let _e74 = phi_166_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_189_: bool;
    var phi_193_: f32;
    var phi_208_: f32;
    var phi_209_: f32;
    var phi_210_: f32;
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
    var phi_301_: f32;
    var phi_306_: f32;
    var phi_328_: f32;
    var phi_333_: f32;
    var phi_334_: bool;
    var phi_335_: f32;
    var phi_336_: bool;
    var phi_340_: f32;
    var phi_378_: f32;
    var phi_389_: f32;
    var phi_394_: f32;
    var phi_416_: f32;
    var phi_421_: f32;
    var phi_422_: bool;
    var phi_423_: f32;
    var phi_424_: bool;
    var phi_428_: f32;
    var phi_466_: f32;
    var phi_477_: f32;
    var phi_482_: f32;
    var phi_504_: f32;
    var phi_509_: f32;
    var phi_510_: bool;
    var phi_511_: f32;
    var phi_512_: bool;
    var phi_516_: f32;
    var phi_554_: f32;
    var phi_565_: f32;
    var phi_570_: f32;
    var phi_592_: f32;
    var phi_597_: f32;
    var phi_598_: bool;
    var phi_599_: f32;
    var phi_600_: bool;
    var phi_604_: f32;
    var phi_642_: f32;
    var phi_668_: f32;
    var phi_669_: f32;
    var phi_670_: f32;

    let _e54 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_189_ = true;
    } else {
        let _e58 = (84f < _e54);
        if _e58 {
        }
        phi_189_ = _e58;
    }
    let _e60 = phi_189_;
    if _e60 {
        phi_193_ = 84f;
    } else {
        phi_193_ = _e54;
    }
    let _e62 = phi_193_;
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_210_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_209_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_208_ = 1f;
            } else {
                phi_208_ = param_7;
            }
            let _e69 = phi_208_;
            phi_209_ = _e69;
        }
        let _e71 = phi_209_;
        phi_210_ = _e71;
    }
    let _e73 = phi_210_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_228_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_227_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_226_ = 1f;
            } else {
                phi_226_ = param_5.x;
            }
            let _e81 = phi_226_;
            phi_227_ = _e81;
        }
        let _e83 = phi_227_;
        phi_228_ = _e83;
    }
    let _e85 = phi_228_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_246_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_245_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_244_ = 1f;
            } else {
                phi_244_ = param_5.y;
            }
            let _e93 = phi_244_;
            phi_245_ = _e93;
        }
        let _e95 = phi_245_;
        phi_246_ = _e95;
    }
    let _e97 = phi_246_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_264_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_263_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_262_ = 1f;
            } else {
                phi_262_ = param_5.z;
            }
            let _e105 = phi_262_;
            phi_263_ = _e105;
        }
        let _e107 = phi_263_;
        phi_264_ = _e107;
    }
    let _e109 = phi_264_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_282_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_281_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_280_ = 1f;
            } else {
                phi_280_ = param_5.w;
            }
            let _e117 = phi_280_;
            phi_281_ = _e117;
        }
        let _e119 = phi_281_;
        phi_282_ = _e119;
    }
    let _e121 = phi_282_;
    let _e126 = (_e62 * (_e85 - _e73));
    let _e127 = (_e62 * (_e97 - _e73));
    let _e128 = (_e62 * (_e109 - _e73));
    let _e129 = (_e62 * (_e121 - _e73));
    if ((bitcast<u32>(_e126) & 2147483647u) > 2139095040u) {
        phi_378_ = _e126;
    } else {
        if (_e126 < -87f) {
            phi_301_ = -87f;
        } else {
            phi_301_ = _e126;
        }
        let _e135 = phi_301_;
        if (_e135 > 88f) {
            phi_306_ = 88f;
        } else {
            phi_306_ = _e135;
        }
        let _e138 = phi_306_;
        let _e140 = ((_e138 * 1.442695f) + 0.5f);
        if (_e140 > -8388608f) {
            let _e152 = f32(select(0i, select(select(i32(_e140), i32(-2147483648), (_e140 < bitcast<f32>(3472883712u))), 2147483647i, (_e140 > bitcast<f32>(1325400063u))), (_e140 == _e140)));
            if (_e152 > _e140) {
                phi_328_ = 1f;
            } else {
                phi_328_ = 0f;
            }
            let _e155 = phi_328_;
            if (_e140 < 8388608f) {
                phi_333_ = (_e152 - _e155);
                phi_334_ = false;
            } else {
                phi_333_ = f32();
                phi_334_ = true;
            }
            let _e158 = phi_333_;
            let _e160 = phi_334_;
            phi_335_ = _e158;
            phi_336_ = _e160;
        } else {
            phi_335_ = f32();
            phi_336_ = true;
        }
        let _e162 = phi_335_;
        let _e164 = phi_336_;
        if _e164 {
            phi_340_ = _e140;
        } else {
            phi_340_ = _e162;
        }
        let _e166 = phi_340_;
        let _e170 = ((_e138 - (_e166 * 0.69314575f)) - (_e166 * 0.0000014286068f));
        phi_378_ = ((((((((((((((((1f / 5040f) * _e170) + (1f / 720f)) * _e170) + (1f / 120f)) * _e170) + (1f / 24f)) * _e170) + (1f / 6f)) * _e170) + 0.5f) * _e170) + 1f) * _e170) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e166), i32(-2147483648), (_e166 < bitcast<f32>(3472883712u))), 2147483647i, (_e166 > bitcast<f32>(1325400063u))), (_e166 == _e166)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e206 = phi_378_;
    if ((bitcast<u32>(_e127) & 2147483647u) > 2139095040u) {
        phi_466_ = _e127;
    } else {
        if (_e127 < -87f) {
            phi_389_ = -87f;
        } else {
            phi_389_ = _e127;
        }
        let _e212 = phi_389_;
        if (_e212 > 88f) {
            phi_394_ = 88f;
        } else {
            phi_394_ = _e212;
        }
        let _e215 = phi_394_;
        let _e217 = ((_e215 * 1.442695f) + 0.5f);
        if (_e217 > -8388608f) {
            let _e229 = f32(select(0i, select(select(i32(_e217), i32(-2147483648), (_e217 < bitcast<f32>(3472883712u))), 2147483647i, (_e217 > bitcast<f32>(1325400063u))), (_e217 == _e217)));
            if (_e229 > _e217) {
                phi_416_ = 1f;
            } else {
                phi_416_ = 0f;
            }
            let _e232 = phi_416_;
            if (_e217 < 8388608f) {
                phi_421_ = (_e229 - _e232);
                phi_422_ = false;
            } else {
                phi_421_ = f32();
                phi_422_ = true;
            }
            let _e235 = phi_421_;
            let _e237 = phi_422_;
            phi_423_ = _e235;
            phi_424_ = _e237;
        } else {
            phi_423_ = f32();
            phi_424_ = true;
        }
        let _e239 = phi_423_;
        let _e241 = phi_424_;
        if _e241 {
            phi_428_ = _e217;
        } else {
            phi_428_ = _e239;
        }
        let _e243 = phi_428_;
        let _e247 = ((_e215 - (_e243 * 0.69314575f)) - (_e243 * 0.0000014286068f));
        phi_466_ = ((((((((((((((((1f / 5040f) * _e247) + (1f / 720f)) * _e247) + (1f / 120f)) * _e247) + (1f / 24f)) * _e247) + (1f / 6f)) * _e247) + 0.5f) * _e247) + 1f) * _e247) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e243), i32(-2147483648), (_e243 < bitcast<f32>(3472883712u))), 2147483647i, (_e243 > bitcast<f32>(1325400063u))), (_e243 == _e243)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e283 = phi_466_;
    if ((bitcast<u32>(_e128) & 2147483647u) > 2139095040u) {
        phi_554_ = _e128;
    } else {
        if (_e128 < -87f) {
            phi_477_ = -87f;
        } else {
            phi_477_ = _e128;
        }
        let _e289 = phi_477_;
        if (_e289 > 88f) {
            phi_482_ = 88f;
        } else {
            phi_482_ = _e289;
        }
        let _e292 = phi_482_;
        let _e294 = ((_e292 * 1.442695f) + 0.5f);
        if (_e294 > -8388608f) {
            let _e306 = f32(select(0i, select(select(i32(_e294), i32(-2147483648), (_e294 < bitcast<f32>(3472883712u))), 2147483647i, (_e294 > bitcast<f32>(1325400063u))), (_e294 == _e294)));
            if (_e306 > _e294) {
                phi_504_ = 1f;
            } else {
                phi_504_ = 0f;
            }
            let _e309 = phi_504_;
            if (_e294 < 8388608f) {
                phi_509_ = (_e306 - _e309);
                phi_510_ = false;
            } else {
                phi_509_ = f32();
                phi_510_ = true;
            }
            let _e312 = phi_509_;
            let _e314 = phi_510_;
            phi_511_ = _e312;
            phi_512_ = _e314;
        } else {
            phi_511_ = f32();
            phi_512_ = true;
        }
        let _e316 = phi_511_;
        let _e318 = phi_512_;
        if _e318 {
            phi_516_ = _e294;
        } else {
            phi_516_ = _e316;
        }
        let _e320 = phi_516_;
        let _e324 = ((_e292 - (_e320 * 0.69314575f)) - (_e320 * 0.0000014286068f));
        phi_554_ = ((((((((((((((((1f / 5040f) * _e324) + (1f / 720f)) * _e324) + (1f / 120f)) * _e324) + (1f / 24f)) * _e324) + (1f / 6f)) * _e324) + 0.5f) * _e324) + 1f) * _e324) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e320), i32(-2147483648), (_e320 < bitcast<f32>(3472883712u))), 2147483647i, (_e320 > bitcast<f32>(1325400063u))), (_e320 == _e320)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e360 = phi_554_;
    if ((bitcast<u32>(_e129) & 2147483647u) > 2139095040u) {
        phi_642_ = _e129;
    } else {
        if (_e129 < -87f) {
            phi_565_ = -87f;
        } else {
            phi_565_ = _e129;
        }
        let _e366 = phi_565_;
        if (_e366 > 88f) {
            phi_570_ = 88f;
        } else {
            phi_570_ = _e366;
        }
        let _e369 = phi_570_;
        let _e371 = ((_e369 * 1.442695f) + 0.5f);
        if (_e371 > -8388608f) {
            let _e383 = f32(select(0i, select(select(i32(_e371), i32(-2147483648), (_e371 < bitcast<f32>(3472883712u))), 2147483647i, (_e371 > bitcast<f32>(1325400063u))), (_e371 == _e371)));
            if (_e383 > _e371) {
                phi_592_ = 1f;
            } else {
                phi_592_ = 0f;
            }
            let _e386 = phi_592_;
            if (_e371 < 8388608f) {
                phi_597_ = (_e383 - _e386);
                phi_598_ = false;
            } else {
                phi_597_ = f32();
                phi_598_ = true;
            }
            let _e389 = phi_597_;
            let _e391 = phi_598_;
            phi_599_ = _e389;
            phi_600_ = _e391;
        } else {
            phi_599_ = f32();
            phi_600_ = true;
        }
        let _e393 = phi_599_;
        let _e395 = phi_600_;
        if _e395 {
            phi_604_ = _e371;
        } else {
            phi_604_ = _e393;
        }
        let _e397 = phi_604_;
        let _e401 = ((_e369 - (_e397 * 0.69314575f)) - (_e397 * 0.0000014286068f));
        phi_642_ = ((((((((((((((((1f / 5040f) * _e401) + (1f / 720f)) * _e401) + (1f / 120f)) * _e401) + (1f / 24f)) * _e401) + (1f / 6f)) * _e401) + 0.5f) * _e401) + 1f) * _e401) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e397), i32(-2147483648), (_e397 < bitcast<f32>(3472883712u))), 2147483647i, (_e397 > bitcast<f32>(1325400063u))), (_e397 == _e397)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e437 = phi_642_;
    let _e448 = ((((_e206 * param_6.x) + (_e283 * param_6.y)) + (_e360 * param_6.z)) + (_e437 * param_6.w));
    if ((bitcast<u32>(_e448) & 2147483647u) > 2139095040u) {
        phi_670_ = _e448;
    } else {
        if (_e448 < 0f) {
            phi_669_ = 0f;
        } else {
            if (_e448 > 1f) {
                phi_668_ = 1f;
            } else {
                phi_668_ = _e448;
            }
            let _e455 = phi_668_;
            phi_669_ = _e455;
        }
        let _e457 = phi_669_;
        phi_670_ = _e457;
    }
    let _e459 = phi_670_;
    return _e459;
}

fn function_() {
    var local_1: f32;
    var phi_721_: bool;
    var phi_722_: bool;
    var phi_723_: bool;
    var phi_724_: bool;
    var phi_728_: bool;
    var phi_798_: bool;
    var phi_799_: bool;
    var phi_810_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_811_: bool;
    var phi_812_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_813_: bool;
    var phi_820_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_824_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_898_: bool;
    var phi_907_: bool;
    var phi_916_: bool;
    var phi_917_: bool;
    var phi_918_: bool;
    var phi_919_: bool;
    var phi_920_: bool;
    var phi_921_: bool;
    var phi_922_: bool;
    var phi_926_: bool;
    var phi_1016_: f32;
    var phi_1019_: f32;
    var phi_1048_: f32;
    var phi_1053_: f32;
    var phi_1054_: bool;
    var phi_1055_: f32;
    var phi_1056_: bool;
    var phi_1060_: f32;
    var phi_1080_: f32;
    var phi_1085_: f32;
    var phi_1086_: bool;
    var phi_1087_: f32;
    var phi_1088_: bool;
    var phi_1092_: f32;
    var phi_1140_: i32;
    var phi_1145_: i32;
    var phi_1150_: i32;
    var phi_1155_: i32;
    var phi_1164_: i32;
    var phi_1169_: i32;
    var phi_1174_: i32;
    var phi_1179_: i32;
    var phi_1230_: bool;
    var phi_1238_: bool;
    var phi_1250_: bool;
    var phi_1251_: bool;
    var phi_1255_: f32;
    var phi_1261_: f32;
    var phi_1263_: evaluate_Verdict;
    var phi_1268_: evaluate_Verdict;
    var phi_1269_: evaluate_Verdict;
    var phi_1273_: bool;
    var phi_1274_: u32;
    var phi_1285_: u32;

    let _e51 = id_1;
    let _e52 = local_2;
    let _e57 = arrayLength((&map.member));
    let _e62 = p.member.size[0u];
    let _e64 = p.member.size[1u];
    let _e65 = lt_shaders_entry_pixel_index(_e51, _e62, _e64);
    if (bitcast<i32>(_e65.root) != 0i) {
        let _e72 = p.member.projection;
        let _e73 = lt_math_OneLevel(_e72);
        let _e77 = samples.member[_e65.first_primitive].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[_e65.first_primitive].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[_e65.first_primitive].normal[2u];
                let _e89 = global[2u];
                phi_721_ = (_e87 == _e89);
                phi_722_ = false;
            } else {
                phi_721_ = bool();
                phi_722_ = true;
            }
            let _e92 = phi_721_;
            let _e94 = phi_722_;
            phi_723_ = _e92;
            phi_724_ = _e94;
        } else {
            phi_723_ = bool();
            phi_724_ = true;
        }
        let _e96 = phi_723_;
        let _e98 = phi_724_;
        if _e98 {
            phi_728_ = false;
        } else {
            phi_728_ = _e96;
        }
        let _e100 = phi_728_;
        if !(_e100) {
            let _e103 = samples.member[_e65.first_primitive].position;
            let _e105 = p.member.light.place;
            let _e111 = p.member.light.place[3u];
            let _e118 = (_e105.x - (_e103.x * _e111));
            let _e119 = (_e105.y - (_e103.y * _e111));
            let _e120 = (_e105.z - (_e103.z * _e111));
            let _e122 = samples.member[_e65.first_primitive].normal;
            if ((((_e122.x * _e118) + (_e122.y * _e119)) + (_e122.z * _e120)) > 0f) {
                let _e136 = (((_e118 * _e118) + (_e119 * _e119)) + (_e120 * _e120));
                let _e138 = p.member.light.axis;
                let _e150 = p.member.light.place[3u];
                if (_e150 == 0f) {
                    phi_799_ = true;
                } else {
                    let _e153 = p.member.light.range_squared;
                    if (_e136 <= _e153) {
                        let _e156 = p.member.light.cos_outer;
                        phi_798_ = (-((((_e118 * _e138.x) + (_e119 * _e138.y)) + (_e120 * _e138.z))) >= (_e156 * sqrt(_e136)));
                    } else {
                        phi_798_ = false;
                    }
                    let _e161 = phi_798_;
                    phi_799_ = _e161;
                }
                let _e163 = phi_799_;
                if _e163 {
                    let _e165 = samples.member[_e65.first_primitive].flags;
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
                    phi_810_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, ((_e165 & 1u) == 0u));
                    phi_811_ = false;
                } else {
                    phi_810_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_811_ = true;
                }
                let _e184 = phi_810_;
                let _e186 = phi_811_;
                phi_812_ = _e184;
                phi_813_ = _e186;
            } else {
                phi_812_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_813_ = true;
            }
            let _e188 = phi_812_;
            let _e190 = phi_813_;
            if _e190 {
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                phi_820_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, true);
            } else {
                phi_820_ = _e188;
            }
            let _e207 = phi_820_;
            phi_824_ = _e207;
        } else {
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
            phi_824_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
        }
        let _e224 = phi_824_;
        if _e224.unnamed_1 {
            phi_1269_ = evaluate_Verdict(_e224.unnamed.visibility, _e224.unnamed.is_doubted);
        } else {
            let _e232 = samples.member[_e65.first_primitive].position;
            let _e250 = ((((_e73.projection.row_w.x * _e232.x) + (_e73.projection.row_w.y * _e232.y)) + (_e73.projection.row_w.z * _e232.z)) + (_e73.projection.row_w.w * 1f));
            let _e264 = (((((_e73.projection.row_x.x * _e232.x) + (_e73.projection.row_x.y * _e232.y)) + (_e73.projection.row_x.z * _e232.z)) + (_e73.projection.row_x.w * 1f)) / _e250);
            let _e278 = (((((_e73.projection.row_y.x * _e232.x) + (_e73.projection.row_y.y * _e232.y)) + (_e73.projection.row_y.z * _e232.z)) + (_e73.projection.row_y.w * 1f)) / _e250);
            let _e291 = ((((_e73.projection.row_z.x * _e232.x) + (_e73.projection.row_z.y * _e232.y)) + (_e73.projection.row_z.z * _e232.z)) + (_e73.projection.row_z.w * 1f));
            if (_e250 > 0f) {
                if (_e264 >= 0f) {
                    phi_898_ = (_e264 <= 1f);
                } else {
                    phi_898_ = false;
                }
                let _e296 = phi_898_;
                if _e296 {
                    if (_e278 >= 0f) {
                        phi_907_ = (_e278 <= 1f);
                    } else {
                        phi_907_ = false;
                    }
                    let _e300 = phi_907_;
                    if _e300 {
                        if (_e291 >= 0f) {
                            phi_916_ = (_e291 <= 1f);
                        } else {
                            phi_916_ = false;
                        }
                        let _e304 = phi_916_;
                        phi_917_ = _e304;
                        phi_918_ = false;
                    } else {
                        phi_917_ = bool();
                        phi_918_ = true;
                    }
                    let _e306 = phi_917_;
                    let _e308 = phi_918_;
                    phi_919_ = _e306;
                    phi_920_ = _e308;
                } else {
                    phi_919_ = bool();
                    phi_920_ = true;
                }
                let _e310 = phi_919_;
                let _e312 = phi_920_;
                phi_921_ = _e310;
                phi_922_ = _e312;
            } else {
                phi_921_ = bool();
                phi_922_ = true;
            }
            let _e314 = phi_921_;
            let _e316 = phi_922_;
            if _e316 {
                phi_926_ = false;
            } else {
                phi_926_ = _e314;
            }
            let _e318 = phi_926_;
            if _e318 {
                if (0f > 0f) {
                    let _e321 = samples.member[_e65.first_primitive].normal;
                    let _e323 = p.member.map_size;
                    let _e393 = ((abs(((((_e72.row_x.x * _e321.x) + (_e72.row_x.y * _e321.y)) + (_e72.row_x.z * _e321.z)) / (((_e72.row_x.x * _e72.row_x.x) + (_e72.row_x.y * _e72.row_x.y)) + (_e72.row_x.z * _e72.row_x.z)))) + abs(((((_e72.row_y.x * _e321.x) + (_e72.row_y.y * _e321.y)) + (_e72.row_y.z * _e321.z)) / (((_e72.row_y.x * _e72.row_y.x) + (_e72.row_y.y * _e72.row_y.y)) + (_e72.row_y.z * _e72.row_y.z))))) / (abs(((((_e72.row_z.x * _e321.x) + (_e72.row_z.y * _e321.y)) + (_e72.row_z.z * _e321.z)) / (((_e72.row_z.x * _e72.row_z.x) + (_e72.row_z.y * _e72.row_z.y)) + (_e72.row_z.z * _e72.row_z.z)))) * f32(_e323)));
                    if (_e393 < 0.002f) {
                        phi_1016_ = _e393;
                    } else {
                        phi_1016_ = 0.002f;
                    }
                    let _e396 = phi_1016_;
                    phi_1019_ = (_e291 - (0f * _e396));
                } else {
                    phi_1019_ = _e291;
                }
                let _e400 = phi_1019_;
                let _e402 = p.member.map_size;
                let _e403 = f32(_e402);
                let _e406 = ((_e264 * _e403) - 0.5f);
                let _e407 = ((_e278 * _e403) - 0.5f);
                if (_e406 > -8388608f) {
                    let _e419 = f32(select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406)));
                    if (_e419 > _e406) {
                        phi_1048_ = 1f;
                    } else {
                        phi_1048_ = 0f;
                    }
                    let _e422 = phi_1048_;
                    if (_e406 < 8388608f) {
                        phi_1053_ = (_e419 - _e422);
                        phi_1054_ = false;
                    } else {
                        phi_1053_ = f32();
                        phi_1054_ = true;
                    }
                    let _e425 = phi_1053_;
                    let _e427 = phi_1054_;
                    phi_1055_ = _e425;
                    phi_1056_ = _e427;
                } else {
                    phi_1055_ = f32();
                    phi_1056_ = true;
                }
                let _e429 = phi_1055_;
                let _e431 = phi_1056_;
                if _e431 {
                    phi_1060_ = _e406;
                } else {
                    phi_1060_ = _e429;
                }
                let _e433 = phi_1060_;
                if (_e407 > -8388608f) {
                    let _e445 = f32(select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < bitcast<f32>(3472883712u))), 2147483647i, (_e407 > bitcast<f32>(1325400063u))), (_e407 == _e407)));
                    if (_e445 > _e407) {
                        phi_1080_ = 1f;
                    } else {
                        phi_1080_ = 0f;
                    }
                    let _e448 = phi_1080_;
                    if (_e407 < 8388608f) {
                        phi_1085_ = (_e445 - _e448);
                        phi_1086_ = false;
                    } else {
                        phi_1085_ = f32();
                        phi_1086_ = true;
                    }
                    let _e451 = phi_1085_;
                    let _e453 = phi_1086_;
                    phi_1087_ = _e451;
                    phi_1088_ = _e453;
                } else {
                    phi_1087_ = f32();
                    phi_1088_ = true;
                }
                let _e455 = phi_1087_;
                let _e457 = phi_1088_;
                if _e457 {
                    phi_1092_ = _e407;
                } else {
                    phi_1092_ = _e455;
                }
                let _e459 = phi_1092_;
                let _e460 = (_e406 - _e433);
                let _e461 = (_e407 - _e459);
                let _e470 = select(0i, select(select(i32(_e433), i32(-2147483648), (_e433 < bitcast<f32>(3472883712u))), 2147483647i, (_e433 > bitcast<f32>(1325400063u))), (_e433 == _e433));
                let _e479 = select(0i, select(select(i32(_e459), i32(-2147483648), (_e459 < bitcast<f32>(3472883712u))), 2147483647i, (_e459 > bitcast<f32>(1325400063u))), (_e459 == _e459));
                let _e490 = p.member.test;
                let _e491 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e490);
                let _e493 = p.member.map_size;
                local_1 = _e491;
                let _e495 = ((0u * _e493) * _e493);
                let _e497 = (bitcast<i32>(_e493) - 1i);
                if (_e470 > 0i) {
                    phi_1140_ = _e470;
                } else {
                    phi_1140_ = 0i;
                }
                let _e500 = phi_1140_;
                if (_e479 > 0i) {
                    phi_1145_ = _e479;
                } else {
                    phi_1145_ = 0i;
                }
                let _e503 = phi_1145_;
                if (_e500 < _e497) {
                    phi_1150_ = _e500;
                } else {
                    phi_1150_ = _e497;
                }
                let _e506 = phi_1150_;
                if (_e503 < _e497) {
                    phi_1155_ = _e503;
                } else {
                    phi_1155_ = _e497;
                }
                let _e509 = phi_1155_;
                let _e510 = bitcast<u32>(_e506);
                let _e512 = (_e470 + 1i);
                let _e513 = (_e479 + 1i);
                if (_e512 > 0i) {
                    phi_1164_ = _e512;
                } else {
                    phi_1164_ = 0i;
                }
                let _e516 = phi_1164_;
                if (_e513 > 0i) {
                    phi_1169_ = _e513;
                } else {
                    phi_1169_ = 0i;
                }
                let _e519 = phi_1169_;
                if (_e516 < _e497) {
                    phi_1174_ = _e516;
                } else {
                    phi_1174_ = _e497;
                }
                let _e522 = phi_1174_;
                if (_e519 < _e497) {
                    phi_1179_ = _e519;
                } else {
                    phi_1179_ = _e497;
                }
                let _e525 = phi_1179_;
                let _e526 = bitcast<u32>(_e522);
                let _e528 = (bitcast<u32>(_e509) * _e493);
                let _e529 = (bitcast<u32>(_e525) * _e493);
                let _e534 = ((_e528 + _e510) + _e495);
                let _e535 = ((_e528 + _e526) + _e495);
                let _e536 = ((_e529 + _e510) + _e495);
                let _e537 = ((_e529 + _e526) + _e495);
                if (_e534 < _e57) {
                } else {
                    return;
                }
                let _e541 = map.member[(0u + _e534)];
                if (_e535 < _e57) {
                } else {
                    return;
                }
                let _e545 = map.member[(0u + _e535)];
                if (_e536 < _e57) {
                } else {
                    return;
                }
                let _e549 = map.member[(0u + _e536)];
                if (_e537 < _e57) {
                } else {
                    return;
                }
                let _e553 = map.member[(0u + _e537)];
                let _e555 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e541, _e545, _e549, _e553), vec4<f32>(((1f - _e460) * (1f - _e461)), (_e460 * (1f - _e461)), ((1f - _e460) * _e461), (_e460 * _e461)), _e400);
                let _e557 = p.member.epsilon;
                if (_e555 <= _e557) {
                    phi_1230_ = true;
                } else {
                    phi_1230_ = (_e555 >= (1f - _e557));
                }
                let _e562 = phi_1230_;
                if ((bitcast<u32>(_e555) & 2147483647u) > 2139095040u) {
                    phi_1238_ = true;
                } else {
                    phi_1238_ = !(_e562);
                }
                let _e568 = phi_1238_;
                if _e568 {
                    if (_e555 > 0f) {
                        if (_e555 < 1f) {
                            phi_1250_ = false;
                        } else {
                            phi_1250_ = true;
                        }
                        let _e572 = phi_1250_;
                        phi_1251_ = _e572;
                    } else {
                        phi_1251_ = true;
                    }
                    let _e574 = phi_1251_;
                    if _e574 {
                        phi_1255_ = 0.5f;
                    } else {
                        phi_1255_ = _e555;
                    }
                    let _e576 = phi_1255_;
                    phi_1263_ = evaluate_Verdict(_e576, true);
                } else {
                    if (_e555 > 0.5f) {
                        phi_1261_ = 1f;
                    } else {
                        phi_1261_ = 0f;
                    }
                    let _e580 = phi_1261_;
                    phi_1263_ = evaluate_Verdict(_e580, false);
                }
                let _e583 = phi_1263_;
                phi_1268_ = evaluate_Verdict(_e583.visibility, _e583.is_doubted);
            } else {
                phi_1268_ = evaluate_Verdict(0.5f, true);
            }
            let _e589 = phi_1268_;
            phi_1269_ = _e589;
        }
        let _e591 = phi_1269_;
        visibility.member[_e65.first_primitive] = _e591.visibility;
        phi_1273_ = _e591.is_doubted;
        phi_1274_ = _e65.first_primitive;
    } else {
        phi_1273_ = false;
        phi_1274_ = 0u;
    }
    let _e596 = phi_1273_;
    let _e598 = phi_1274_;
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e596 {
        let _e602 = atomicAdd((&shared_[0u]), 1u);
        phi_1285_ = _e602;
    } else {
        phi_1285_ = 0u;
    }
    let _e604 = phi_1285_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e608 = atomicLoad((&shared_[0u]));
        let _e609 = atomicAdd((&list.member[3u]), _e608);
        atomicStore((&shared_[1u]), _e609);
    }
    workgroupBarrier();
    if _e596 {
        let _e612 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e612) + _e604)]), _e598);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
