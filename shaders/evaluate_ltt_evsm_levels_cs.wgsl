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

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_46 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct type_52 {
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
var<storage, read_write> list: type_52;
@group(0) @binding(5) 
var<storage> levels: type_46;

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
        let _e69 = phi_178_;
        let _e71 = phi_179_;
        phi_180_ = _e69;
        phi_181_ = _e71;
    } else {
        phi_180_ = lt_bvh_traverse_Tree();
        phi_181_ = true;
    }
    let _e73 = phi_180_;
    let _e75 = phi_181_;
    if _e75 {
        phi_186_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_186_ = _e73;
    }
    let _e80 = phi_186_;
    return lt_bvh_traverse_Tree(_e80.root, _e80.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_366_: bool;
    var phi_370_: f32;
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
    var phi_653_: f32;
    var phi_658_: f32;
    var phi_680_: f32;
    var phi_685_: f32;
    var phi_686_: bool;
    var phi_687_: f32;
    var phi_688_: bool;
    var phi_692_: f32;
    var phi_730_: f32;
    var phi_783_: bool;
    var phi_787_: f32;
    var phi_799_: bool;
    var phi_806_: f32;
    var phi_819_: bool;
    var phi_823_: f32;
    var phi_843_: f32;
    var phi_848_: f32;
    var phi_870_: f32;
    var phi_875_: f32;
    var phi_876_: bool;
    var phi_877_: f32;
    var phi_878_: bool;
    var phi_882_: f32;
    var phi_920_: f32;
    var phi_931_: f32;
    var phi_936_: f32;
    var phi_958_: f32;
    var phi_963_: f32;
    var phi_964_: bool;
    var phi_965_: f32;
    var phi_966_: bool;
    var phi_970_: f32;
    var phi_1008_: f32;
    var phi_1019_: f32;
    var phi_1024_: f32;
    var phi_1046_: f32;
    var phi_1051_: f32;
    var phi_1052_: bool;
    var phi_1053_: f32;
    var phi_1054_: bool;
    var phi_1058_: f32;
    var phi_1096_: f32;
    var phi_1107_: f32;
    var phi_1112_: f32;
    var phi_1134_: f32;
    var phi_1139_: f32;
    var phi_1140_: bool;
    var phi_1141_: f32;
    var phi_1142_: bool;
    var phi_1146_: f32;
    var phi_1184_: f32;
    var phi_1237_: bool;
    var phi_1241_: f32;
    var phi_1253_: bool;
    var phi_1260_: f32;
    var phi_1271_: bool;
    var phi_1275_: f32;
    var phi_1290_: f32;
    var phi_1291_: f32;
    var phi_1292_: f32;

    let _e60 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_366_ = true;
    } else {
        let _e64 = (42f < _e60);
        if _e64 {
        }
        phi_366_ = _e64;
    }
    let _e66 = phi_366_;
    if _e66 {
        phi_370_ = 42f;
    } else {
        phi_370_ = _e60;
    }
    let _e68 = phi_370_;
    let _e70 = (_e68 * param_5.x);
    let _e72 = (_e68 * param_5.y);
    let _e74 = (_e68 * param_5.z);
    let _e76 = (_e68 * param_5.w);
    if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
        phi_466_ = _e70;
    } else {
        if (_e70 < -87f) {
            phi_389_ = -87f;
        } else {
            phi_389_ = _e70;
        }
        let _e82 = phi_389_;
        if (_e82 > 88f) {
            phi_394_ = 88f;
        } else {
            phi_394_ = _e82;
        }
        let _e85 = phi_394_;
        let _e87 = ((_e85 * 1.442695f) + 0.5f);
        if (_e87 > -8388608f) {
            let _e99 = f32(select(0i, select(select(i32(_e87), i32(-2147483648), (_e87 < bitcast<f32>(3472883712u))), 2147483647i, (_e87 > bitcast<f32>(1325400063u))), (_e87 == _e87)));
            if (_e99 > _e87) {
                phi_416_ = 1f;
            } else {
                phi_416_ = 0f;
            }
            let _e102 = phi_416_;
            if (_e87 < 8388608f) {
                phi_421_ = (_e99 - _e102);
                phi_422_ = false;
            } else {
                phi_421_ = f32();
                phi_422_ = true;
            }
            let _e105 = phi_421_;
            let _e107 = phi_422_;
            phi_423_ = _e105;
            phi_424_ = _e107;
        } else {
            phi_423_ = f32();
            phi_424_ = true;
        }
        let _e109 = phi_423_;
        let _e111 = phi_424_;
        if _e111 {
            phi_428_ = _e87;
        } else {
            phi_428_ = _e109;
        }
        let _e113 = phi_428_;
        let _e117 = ((_e85 - (_e113 * 0.69314575f)) - (_e113 * 0.0000014286068f));
        phi_466_ = ((((((((((((((((1f / 5040f) * _e117) + (1f / 720f)) * _e117) + (1f / 120f)) * _e117) + (1f / 24f)) * _e117) + (1f / 6f)) * _e117) + 0.5f) * _e117) + 1f) * _e117) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e113), i32(-2147483648), (_e113 < bitcast<f32>(3472883712u))), 2147483647i, (_e113 > bitcast<f32>(1325400063u))), (_e113 == _e113)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e153 = phi_466_;
    if ((bitcast<u32>(_e72) & 2147483647u) > 2139095040u) {
        phi_554_ = _e72;
    } else {
        if (_e72 < -87f) {
            phi_477_ = -87f;
        } else {
            phi_477_ = _e72;
        }
        let _e159 = phi_477_;
        if (_e159 > 88f) {
            phi_482_ = 88f;
        } else {
            phi_482_ = _e159;
        }
        let _e162 = phi_482_;
        let _e164 = ((_e162 * 1.442695f) + 0.5f);
        if (_e164 > -8388608f) {
            let _e176 = f32(select(0i, select(select(i32(_e164), i32(-2147483648), (_e164 < bitcast<f32>(3472883712u))), 2147483647i, (_e164 > bitcast<f32>(1325400063u))), (_e164 == _e164)));
            if (_e176 > _e164) {
                phi_504_ = 1f;
            } else {
                phi_504_ = 0f;
            }
            let _e179 = phi_504_;
            if (_e164 < 8388608f) {
                phi_509_ = (_e176 - _e179);
                phi_510_ = false;
            } else {
                phi_509_ = f32();
                phi_510_ = true;
            }
            let _e182 = phi_509_;
            let _e184 = phi_510_;
            phi_511_ = _e182;
            phi_512_ = _e184;
        } else {
            phi_511_ = f32();
            phi_512_ = true;
        }
        let _e186 = phi_511_;
        let _e188 = phi_512_;
        if _e188 {
            phi_516_ = _e164;
        } else {
            phi_516_ = _e186;
        }
        let _e190 = phi_516_;
        let _e194 = ((_e162 - (_e190 * 0.69314575f)) - (_e190 * 0.0000014286068f));
        phi_554_ = ((((((((((((((((1f / 5040f) * _e194) + (1f / 720f)) * _e194) + (1f / 120f)) * _e194) + (1f / 24f)) * _e194) + (1f / 6f)) * _e194) + 0.5f) * _e194) + 1f) * _e194) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e190), i32(-2147483648), (_e190 < bitcast<f32>(3472883712u))), 2147483647i, (_e190 > bitcast<f32>(1325400063u))), (_e190 == _e190)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e230 = phi_554_;
    if ((bitcast<u32>(_e74) & 2147483647u) > 2139095040u) {
        phi_642_ = _e74;
    } else {
        if (_e74 < -87f) {
            phi_565_ = -87f;
        } else {
            phi_565_ = _e74;
        }
        let _e236 = phi_565_;
        if (_e236 > 88f) {
            phi_570_ = 88f;
        } else {
            phi_570_ = _e236;
        }
        let _e239 = phi_570_;
        let _e241 = ((_e239 * 1.442695f) + 0.5f);
        if (_e241 > -8388608f) {
            let _e253 = f32(select(0i, select(select(i32(_e241), i32(-2147483648), (_e241 < bitcast<f32>(3472883712u))), 2147483647i, (_e241 > bitcast<f32>(1325400063u))), (_e241 == _e241)));
            if (_e253 > _e241) {
                phi_592_ = 1f;
            } else {
                phi_592_ = 0f;
            }
            let _e256 = phi_592_;
            if (_e241 < 8388608f) {
                phi_597_ = (_e253 - _e256);
                phi_598_ = false;
            } else {
                phi_597_ = f32();
                phi_598_ = true;
            }
            let _e259 = phi_597_;
            let _e261 = phi_598_;
            phi_599_ = _e259;
            phi_600_ = _e261;
        } else {
            phi_599_ = f32();
            phi_600_ = true;
        }
        let _e263 = phi_599_;
        let _e265 = phi_600_;
        if _e265 {
            phi_604_ = _e241;
        } else {
            phi_604_ = _e263;
        }
        let _e267 = phi_604_;
        let _e271 = ((_e239 - (_e267 * 0.69314575f)) - (_e267 * 0.0000014286068f));
        phi_642_ = ((((((((((((((((1f / 5040f) * _e271) + (1f / 720f)) * _e271) + (1f / 120f)) * _e271) + (1f / 24f)) * _e271) + (1f / 6f)) * _e271) + 0.5f) * _e271) + 1f) * _e271) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e267), i32(-2147483648), (_e267 < bitcast<f32>(3472883712u))), 2147483647i, (_e267 > bitcast<f32>(1325400063u))), (_e267 == _e267)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e307 = phi_642_;
    if ((bitcast<u32>(_e76) & 2147483647u) > 2139095040u) {
        phi_730_ = _e76;
    } else {
        if (_e76 < -87f) {
            phi_653_ = -87f;
        } else {
            phi_653_ = _e76;
        }
        let _e313 = phi_653_;
        if (_e313 > 88f) {
            phi_658_ = 88f;
        } else {
            phi_658_ = _e313;
        }
        let _e316 = phi_658_;
        let _e318 = ((_e316 * 1.442695f) + 0.5f);
        if (_e318 > -8388608f) {
            let _e330 = f32(select(0i, select(select(i32(_e318), i32(-2147483648), (_e318 < bitcast<f32>(3472883712u))), 2147483647i, (_e318 > bitcast<f32>(1325400063u))), (_e318 == _e318)));
            if (_e330 > _e318) {
                phi_680_ = 1f;
            } else {
                phi_680_ = 0f;
            }
            let _e333 = phi_680_;
            if (_e318 < 8388608f) {
                phi_685_ = (_e330 - _e333);
                phi_686_ = false;
            } else {
                phi_685_ = f32();
                phi_686_ = true;
            }
            let _e336 = phi_685_;
            let _e338 = phi_686_;
            phi_687_ = _e336;
            phi_688_ = _e338;
        } else {
            phi_687_ = f32();
            phi_688_ = true;
        }
        let _e340 = phi_687_;
        let _e342 = phi_688_;
        if _e342 {
            phi_692_ = _e318;
        } else {
            phi_692_ = _e340;
        }
        let _e344 = phi_692_;
        let _e348 = ((_e316 - (_e344 * 0.69314575f)) - (_e344 * 0.0000014286068f));
        phi_730_ = ((((((((((((((((1f / 5040f) * _e348) + (1f / 720f)) * _e348) + (1f / 120f)) * _e348) + (1f / 24f)) * _e348) + (1f / 6f)) * _e348) + 0.5f) * _e348) + 1f) * _e348) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e344), i32(-2147483648), (_e344 < bitcast<f32>(3472883712u))), 2147483647i, (_e344 > bitcast<f32>(1325400063u))), (_e344 == _e344)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e384 = phi_730_;
    let _e386 = (_e153 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e388 = (_e230 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e390 = (_e307 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e392 = (_e384 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e394 = (*param_4).min_variance;
    let _e396 = ((_e394 * _e68) * _e68);
    let _e407 = ((((_e386 * param_6.x) + (_e388 * param_6.y)) + (_e390 * param_6.z)) + (_e392 * param_6.w));
    let _e408 = (_e386 - _e407);
    let _e409 = (_e388 - _e407);
    let _e410 = (_e390 - _e407);
    let _e411 = (_e392 - _e407);
    let _e426 = (((((_e408 * _e408) * param_6.x) + ((_e409 * _e409) * param_6.y)) + ((_e410 * _e410) * param_6.z)) + ((_e411 * _e411) * param_6.w));
    if ((bitcast<u32>(_e396) & 2147483647u) > 2139095040u) {
        phi_783_ = true;
    } else {
        let _e430 = (_e396 > _e426);
        if _e430 {
        }
        phi_783_ = _e430;
    }
    let _e432 = phi_783_;
    if _e432 {
        phi_787_ = _e396;
    } else {
        phi_787_ = _e426;
    }
    let _e434 = phi_787_;
    let _e435 = -(_e407);
    if (_e435 <= 0f) {
        let _e439 = ((bitcast<u32>(_e434) & 2147483647u) > 2139095040u);
        if _e439 {
        }
        phi_799_ = _e439;
    } else {
        phi_799_ = true;
    }
    let _e441 = phi_799_;
    if _e441 {
        phi_806_ = (_e434 / (_e434 + (_e435 * _e435)));
    } else {
        phi_806_ = 1f;
    }
    let _e446 = phi_806_;
    let _e448 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_819_ = true;
    } else {
        let _e452 = (42f < _e448);
        if _e452 {
        }
        phi_819_ = _e452;
    }
    let _e454 = phi_819_;
    if _e454 {
        phi_823_ = 42f;
    } else {
        phi_823_ = _e448;
    }
    let _e456 = phi_823_;
    let _e457 = -(_e456);
    let _e459 = (_e457 * param_5.x);
    let _e461 = (_e457 * param_5.y);
    let _e463 = (_e457 * param_5.z);
    let _e465 = (_e457 * param_5.w);
    if ((bitcast<u32>(_e459) & 2147483647u) > 2139095040u) {
        phi_920_ = _e459;
    } else {
        if (_e459 < -87f) {
            phi_843_ = -87f;
        } else {
            phi_843_ = _e459;
        }
        let _e471 = phi_843_;
        if (_e471 > 88f) {
            phi_848_ = 88f;
        } else {
            phi_848_ = _e471;
        }
        let _e474 = phi_848_;
        let _e476 = ((_e474 * 1.442695f) + 0.5f);
        if (_e476 > -8388608f) {
            let _e488 = f32(select(0i, select(select(i32(_e476), i32(-2147483648), (_e476 < bitcast<f32>(3472883712u))), 2147483647i, (_e476 > bitcast<f32>(1325400063u))), (_e476 == _e476)));
            if (_e488 > _e476) {
                phi_870_ = 1f;
            } else {
                phi_870_ = 0f;
            }
            let _e491 = phi_870_;
            if (_e476 < 8388608f) {
                phi_875_ = (_e488 - _e491);
                phi_876_ = false;
            } else {
                phi_875_ = f32();
                phi_876_ = true;
            }
            let _e494 = phi_875_;
            let _e496 = phi_876_;
            phi_877_ = _e494;
            phi_878_ = _e496;
        } else {
            phi_877_ = f32();
            phi_878_ = true;
        }
        let _e498 = phi_877_;
        let _e500 = phi_878_;
        if _e500 {
            phi_882_ = _e476;
        } else {
            phi_882_ = _e498;
        }
        let _e502 = phi_882_;
        let _e506 = ((_e474 - (_e502 * 0.69314575f)) - (_e502 * 0.0000014286068f));
        phi_920_ = ((((((((((((((((1f / 5040f) * _e506) + (1f / 720f)) * _e506) + (1f / 120f)) * _e506) + (1f / 24f)) * _e506) + (1f / 6f)) * _e506) + 0.5f) * _e506) + 1f) * _e506) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e502), i32(-2147483648), (_e502 < bitcast<f32>(3472883712u))), 2147483647i, (_e502 > bitcast<f32>(1325400063u))), (_e502 == _e502)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e542 = phi_920_;
    if ((bitcast<u32>(_e461) & 2147483647u) > 2139095040u) {
        phi_1008_ = _e461;
    } else {
        if (_e461 < -87f) {
            phi_931_ = -87f;
        } else {
            phi_931_ = _e461;
        }
        let _e548 = phi_931_;
        if (_e548 > 88f) {
            phi_936_ = 88f;
        } else {
            phi_936_ = _e548;
        }
        let _e551 = phi_936_;
        let _e553 = ((_e551 * 1.442695f) + 0.5f);
        if (_e553 > -8388608f) {
            let _e565 = f32(select(0i, select(select(i32(_e553), i32(-2147483648), (_e553 < bitcast<f32>(3472883712u))), 2147483647i, (_e553 > bitcast<f32>(1325400063u))), (_e553 == _e553)));
            if (_e565 > _e553) {
                phi_958_ = 1f;
            } else {
                phi_958_ = 0f;
            }
            let _e568 = phi_958_;
            if (_e553 < 8388608f) {
                phi_963_ = (_e565 - _e568);
                phi_964_ = false;
            } else {
                phi_963_ = f32();
                phi_964_ = true;
            }
            let _e571 = phi_963_;
            let _e573 = phi_964_;
            phi_965_ = _e571;
            phi_966_ = _e573;
        } else {
            phi_965_ = f32();
            phi_966_ = true;
        }
        let _e575 = phi_965_;
        let _e577 = phi_966_;
        if _e577 {
            phi_970_ = _e553;
        } else {
            phi_970_ = _e575;
        }
        let _e579 = phi_970_;
        let _e583 = ((_e551 - (_e579 * 0.69314575f)) - (_e579 * 0.0000014286068f));
        phi_1008_ = ((((((((((((((((1f / 5040f) * _e583) + (1f / 720f)) * _e583) + (1f / 120f)) * _e583) + (1f / 24f)) * _e583) + (1f / 6f)) * _e583) + 0.5f) * _e583) + 1f) * _e583) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e579), i32(-2147483648), (_e579 < bitcast<f32>(3472883712u))), 2147483647i, (_e579 > bitcast<f32>(1325400063u))), (_e579 == _e579)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e619 = phi_1008_;
    if ((bitcast<u32>(_e463) & 2147483647u) > 2139095040u) {
        phi_1096_ = _e463;
    } else {
        if (_e463 < -87f) {
            phi_1019_ = -87f;
        } else {
            phi_1019_ = _e463;
        }
        let _e625 = phi_1019_;
        if (_e625 > 88f) {
            phi_1024_ = 88f;
        } else {
            phi_1024_ = _e625;
        }
        let _e628 = phi_1024_;
        let _e630 = ((_e628 * 1.442695f) + 0.5f);
        if (_e630 > -8388608f) {
            let _e642 = f32(select(0i, select(select(i32(_e630), i32(-2147483648), (_e630 < bitcast<f32>(3472883712u))), 2147483647i, (_e630 > bitcast<f32>(1325400063u))), (_e630 == _e630)));
            if (_e642 > _e630) {
                phi_1046_ = 1f;
            } else {
                phi_1046_ = 0f;
            }
            let _e645 = phi_1046_;
            if (_e630 < 8388608f) {
                phi_1051_ = (_e642 - _e645);
                phi_1052_ = false;
            } else {
                phi_1051_ = f32();
                phi_1052_ = true;
            }
            let _e648 = phi_1051_;
            let _e650 = phi_1052_;
            phi_1053_ = _e648;
            phi_1054_ = _e650;
        } else {
            phi_1053_ = f32();
            phi_1054_ = true;
        }
        let _e652 = phi_1053_;
        let _e654 = phi_1054_;
        if _e654 {
            phi_1058_ = _e630;
        } else {
            phi_1058_ = _e652;
        }
        let _e656 = phi_1058_;
        let _e660 = ((_e628 - (_e656 * 0.69314575f)) - (_e656 * 0.0000014286068f));
        phi_1096_ = ((((((((((((((((1f / 5040f) * _e660) + (1f / 720f)) * _e660) + (1f / 120f)) * _e660) + (1f / 24f)) * _e660) + (1f / 6f)) * _e660) + 0.5f) * _e660) + 1f) * _e660) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e656), i32(-2147483648), (_e656 < bitcast<f32>(3472883712u))), 2147483647i, (_e656 > bitcast<f32>(1325400063u))), (_e656 == _e656)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e696 = phi_1096_;
    if ((bitcast<u32>(_e465) & 2147483647u) > 2139095040u) {
        phi_1184_ = _e465;
    } else {
        if (_e465 < -87f) {
            phi_1107_ = -87f;
        } else {
            phi_1107_ = _e465;
        }
        let _e702 = phi_1107_;
        if (_e702 > 88f) {
            phi_1112_ = 88f;
        } else {
            phi_1112_ = _e702;
        }
        let _e705 = phi_1112_;
        let _e707 = ((_e705 * 1.442695f) + 0.5f);
        if (_e707 > -8388608f) {
            let _e719 = f32(select(0i, select(select(i32(_e707), i32(-2147483648), (_e707 < bitcast<f32>(3472883712u))), 2147483647i, (_e707 > bitcast<f32>(1325400063u))), (_e707 == _e707)));
            if (_e719 > _e707) {
                phi_1134_ = 1f;
            } else {
                phi_1134_ = 0f;
            }
            let _e722 = phi_1134_;
            if (_e707 < 8388608f) {
                phi_1139_ = (_e719 - _e722);
                phi_1140_ = false;
            } else {
                phi_1139_ = f32();
                phi_1140_ = true;
            }
            let _e725 = phi_1139_;
            let _e727 = phi_1140_;
            phi_1141_ = _e725;
            phi_1142_ = _e727;
        } else {
            phi_1141_ = f32();
            phi_1142_ = true;
        }
        let _e729 = phi_1141_;
        let _e731 = phi_1142_;
        if _e731 {
            phi_1146_ = _e707;
        } else {
            phi_1146_ = _e729;
        }
        let _e733 = phi_1146_;
        let _e737 = ((_e705 - (_e733 * 0.69314575f)) - (_e733 * 0.0000014286068f));
        phi_1184_ = ((((((((((((((((1f / 5040f) * _e737) + (1f / 720f)) * _e737) + (1f / 120f)) * _e737) + (1f / 24f)) * _e737) + (1f / 6f)) * _e737) + 0.5f) * _e737) + 1f) * _e737) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e733), i32(-2147483648), (_e733 < bitcast<f32>(3472883712u))), 2147483647i, (_e733 > bitcast<f32>(1325400063u))), (_e733 == _e733)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e773 = phi_1184_;
    let _e775 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e542);
    let _e777 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e619);
    let _e779 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e696);
    let _e781 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e773);
    let _e783 = (*param_4).min_variance;
    let _e785 = ((_e783 * _e456) * _e456);
    let _e796 = ((((_e775 * param_6.x) + (_e777 * param_6.y)) + (_e779 * param_6.z)) + (_e781 * param_6.w));
    let _e797 = (_e775 - _e796);
    let _e798 = (_e777 - _e796);
    let _e799 = (_e779 - _e796);
    let _e800 = (_e781 - _e796);
    let _e815 = (((((_e797 * _e797) * param_6.x) + ((_e798 * _e798) * param_6.y)) + ((_e799 * _e799) * param_6.z)) + ((_e800 * _e800) * param_6.w));
    if ((bitcast<u32>(_e785) & 2147483647u) > 2139095040u) {
        phi_1237_ = true;
    } else {
        let _e819 = (_e785 > _e815);
        if _e819 {
        }
        phi_1237_ = _e819;
    }
    let _e821 = phi_1237_;
    if _e821 {
        phi_1241_ = _e785;
    } else {
        phi_1241_ = _e815;
    }
    let _e823 = phi_1241_;
    let _e824 = -(_e796);
    if (_e824 <= 0f) {
        let _e828 = ((bitcast<u32>(_e823) & 2147483647u) > 2139095040u);
        if _e828 {
        }
        phi_1253_ = _e828;
    } else {
        phi_1253_ = true;
    }
    let _e830 = phi_1253_;
    if _e830 {
        phi_1260_ = (_e823 / (_e823 + (_e824 * _e824)));
    } else {
        phi_1260_ = 1f;
    }
    let _e835 = phi_1260_;
    if ((bitcast<u32>(_e835) & 2147483647u) > 2139095040u) {
        phi_1271_ = true;
    } else {
        let _e839 = (_e835 < _e446);
        if _e839 {
        }
        phi_1271_ = _e839;
    }
    let _e841 = phi_1271_;
    if _e841 {
        phi_1275_ = _e835;
    } else {
        phi_1275_ = _e446;
    }
    let _e843 = phi_1275_;
    if ((bitcast<u32>(_e843) & 2147483647u) > 2139095040u) {
        phi_1292_ = _e843;
    } else {
        if (_e843 < 0f) {
            phi_1291_ = 0f;
        } else {
            if (_e843 > 1f) {
                phi_1290_ = 1f;
            } else {
                phi_1290_ = _e843;
            }
            let _e850 = phi_1290_;
            phi_1291_ = _e850;
        }
        let _e852 = phi_1291_;
        phi_1292_ = _e852;
    }
    let _e854 = phi_1292_;
    return _e854;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_215_: f32;
    var phi_216_: f32;
    var phi_217_: f32;
    var phi_233_: f32;
    var phi_234_: f32;
    var phi_235_: f32;
    var phi_251_: f32;
    var phi_252_: f32;
    var phi_253_: f32;
    var phi_269_: f32;
    var phi_270_: f32;
    var phi_271_: f32;
    var phi_287_: f32;
    var phi_288_: f32;
    var phi_289_: f32;
    var phi_326_: bool;
    var phi_327_: bool;
    var phi_328_: bool;
    var phi_329_: bool;
    var phi_330_: bool;
    var phi_331_: bool;
    var phi_332_: bool;
    var phi_333_: bool;
    var phi_334_: bool;
    var phi_335_: bool;
    var phi_336_: bool;
    var phi_340_: bool;
    var phi_344_: bool;
    var phi_349_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_217_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_216_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_215_ = 1f;
            } else {
                phi_215_ = param_10;
            }
            let _e66 = phi_215_;
            phi_216_ = _e66;
        }
        let _e68 = phi_216_;
        phi_217_ = _e68;
    }
    let _e70 = phi_217_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_235_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_234_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_233_ = 1f;
            } else {
                phi_233_ = param_8.x;
            }
            let _e78 = phi_233_;
            phi_234_ = _e78;
        }
        let _e80 = phi_234_;
        phi_235_ = _e80;
    }
    let _e82 = phi_235_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_253_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_252_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_251_ = 1f;
            } else {
                phi_251_ = param_8.y;
            }
            let _e90 = phi_251_;
            phi_252_ = _e90;
        }
        let _e92 = phi_252_;
        phi_253_ = _e92;
    }
    let _e94 = phi_253_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_271_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_270_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_269_ = 1f;
            } else {
                phi_269_ = param_8.z;
            }
            let _e102 = phi_269_;
            phi_270_ = _e102;
        }
        let _e104 = phi_270_;
        phi_271_ = _e104;
    }
    let _e106 = phi_271_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_289_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_288_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_287_ = 1f;
            } else {
                phi_287_ = param_8.w;
            }
            let _e114 = phi_287_;
            phi_288_ = _e114;
        }
        let _e116 = phi_288_;
        phi_289_ = _e116;
    }
    let _e118 = phi_289_;
    let _e119 = (_e82 - _e70);
    let _e120 = (_e94 - _e70);
    let _e121 = (_e106 - _e70);
    let _e122 = (_e118 - _e70);
    if (_e119 >= 0f) {
        if (_e120 >= 0f) {
            if (_e121 >= 0f) {
                if (_e122 >= 0f) {
                    phi_326_ = !(((bitcast<u32>(((((_e119 * param_9.x) + (_e120 * param_9.y)) + (_e121 * param_9.z)) + (_e122 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_327_ = false;
                } else {
                    phi_326_ = bool();
                    phi_327_ = true;
                }
                let _e144 = phi_326_;
                let _e146 = phi_327_;
                phi_328_ = _e144;
                phi_329_ = false;
                phi_330_ = _e146;
            } else {
                phi_328_ = bool();
                phi_329_ = true;
                phi_330_ = false;
            }
            let _e148 = phi_328_;
            let _e150 = phi_329_;
            let _e152 = phi_330_;
            phi_331_ = _e148;
            phi_332_ = _e150;
            phi_333_ = _e152;
        } else {
            phi_331_ = bool();
            phi_332_ = true;
            phi_333_ = false;
        }
        let _e154 = phi_331_;
        let _e156 = phi_332_;
        let _e158 = phi_333_;
        phi_334_ = _e154;
        phi_335_ = _e156;
        phi_336_ = _e158;
    } else {
        phi_334_ = bool();
        phi_335_ = true;
        phi_336_ = false;
    }
    let _e160 = phi_334_;
    let _e162 = phi_335_;
    let _e164 = phi_336_;
    if _e162 {
        phi_340_ = true;
    } else {
        phi_340_ = _e164;
    }
    let _e166 = phi_340_;
    if _e166 {
        phi_344_ = false;
    } else {
        phi_344_ = _e160;
    }
    let _e168 = phi_344_;
    if _e168 {
        phi_349_ = 1f;
    } else {
        let _e169 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e119, _e120, _e121, _e122), param_9);
        phi_349_ = _e169;
    }
    let _e171 = phi_349_;
    return _e171;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_1347_: bool;
    var phi_1348_: bool;
    var phi_1349_: bool;
    var phi_1350_: bool;
    var phi_1354_: bool;
    var phi_1424_: bool;
    var phi_1425_: bool;
    var phi_1436_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1437_: bool;
    var phi_1438_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1439_: bool;
    var phi_1446_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1450_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1470_: lt_math_LightPoint;
    var phi_1473_: u32;
    var phi_1475_: lt_math_LevelPoint;
    var phi_1561_: bool;
    var phi_1570_: bool;
    var phi_1579_: bool;
    var phi_1580_: bool;
    var phi_1581_: bool;
    var phi_1582_: bool;
    var phi_1583_: bool;
    var phi_1584_: bool;
    var phi_1585_: bool;
    var phi_1589_: bool;
    var phi_1616_: bool;
    var phi_1617_: bool;
    var phi_1618_: bool;
    var phi_1619_: bool;
    var phi_1620_: bool;
    var phi_1621_: bool;
    var phi_1622_: bool;
    var phi_1623_: bool;
    var phi_1627_: bool;
    var phi_1636_: lt_math_LightPoint;
    var phi_1637_: u32;
    var phi_1638_: lt_math_LevelPoint;
    var phi_1639_: bool;
    var phi_1471_: lt_math_LightPoint;
    var phi_1474_: u32;
    var phi_1476_: lt_math_LevelPoint;
    var phi_1640_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1680_: bool;
    var phi_1681_: bool;
    var phi_1682_: bool;
    var phi_1683_: bool;
    var phi_1687_: bool;
    var phi_1769_: f32;
    var phi_1885_: f32;
    var phi_1886_: f32;
    var phi_1889_: f32;
    var phi_1918_: f32;
    var phi_1923_: f32;
    var phi_1924_: bool;
    var phi_1925_: f32;
    var phi_1926_: bool;
    var phi_1930_: f32;
    var phi_1950_: f32;
    var phi_1955_: f32;
    var phi_1956_: bool;
    var phi_1957_: f32;
    var phi_1958_: bool;
    var phi_1962_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_2015_: i32;
    var phi_2020_: i32;
    var phi_2025_: i32;
    var phi_2030_: i32;
    var phi_2039_: i32;
    var phi_2044_: i32;
    var phi_2049_: i32;
    var phi_2054_: i32;
    var phi_2105_: bool;
    var phi_2113_: bool;
    var phi_2125_: bool;
    var phi_2126_: bool;
    var phi_2130_: f32;
    var phi_2136_: f32;
    var phi_2138_: evaluate_Verdict;
    var phi_2143_: evaluate_Verdict;
    var phi_2144_: evaluate_Verdict;
    var phi_2148_: bool;
    var phi_2149_: u32;
    var phi_2160_: u32;

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
                phi_1347_ = (_e95 == _e97);
                phi_1348_ = false;
            } else {
                phi_1347_ = bool();
                phi_1348_ = true;
            }
            let _e100 = phi_1347_;
            let _e102 = phi_1348_;
            phi_1349_ = _e100;
            phi_1350_ = _e102;
        } else {
            phi_1349_ = bool();
            phi_1350_ = true;
        }
        let _e104 = phi_1349_;
        let _e106 = phi_1350_;
        if _e106 {
            phi_1354_ = false;
        } else {
            phi_1354_ = _e104;
        }
        let _e108 = phi_1354_;
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
                    phi_1425_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_1424_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_1424_ = false;
                    }
                    let _e169 = phi_1424_;
                    phi_1425_ = _e169;
                }
                let _e171 = phi_1425_;
                if _e171 {
                    let _e173 = samples.member[_e74.first_primitive].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_1436_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_1437_ = false;
                } else {
                    phi_1436_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1437_ = true;
                }
                let _e192 = phi_1436_;
                let _e194 = phi_1437_;
                phi_1438_ = _e192;
                phi_1439_ = _e194;
            } else {
                phi_1438_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1439_ = true;
            }
            let _e196 = phi_1438_;
            let _e198 = phi_1439_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_1446_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_1446_ = _e196;
            }
            let _e215 = phi_1446_;
            phi_1450_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_1450_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_1450_;
        if _e232.unnamed_1 {
            phi_2144_ = evaluate_Verdict(_e232.unnamed.visibility, _e232.unnamed.is_doubted);
        } else {
            let _e240 = samples.member[_e74.first_primitive].position;
            let _e242 = p.member.map_size;
            let _e244 = (0.5f / f32(_e242));
            let _e251 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e258 = lt_math_LightPoint(vec2<f32>(_e251.uv.x, 0f), _e251.depth, _e251.is_inside);
            let _e262 = lt_math_LightPoint(_e258.uv, 0f, _e258.is_inside);
            phi_1470_ = lt_math_LightPoint();
            phi_1473_ = 0u;
            phi_1475_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e262.uv, _e262.depth, false));
            loop {
                let _e269 = phi_1470_;
                let _e271 = phi_1473_;
                let _e273 = phi_1475_;
                local_2 = _e273;
                local_3 = _e273;
                local_4 = _e273;
                if (_e271 < _e81) {
                    if _e273.point.is_inside {
                        phi_1636_ = lt_math_LightPoint();
                        phi_1637_ = u32();
                        phi_1638_ = lt_math_LevelPoint();
                        phi_1639_ = false;
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
                                phi_1561_ = (_e309 <= 1f);
                            } else {
                                phi_1561_ = false;
                            }
                            let _e341 = phi_1561_;
                            if _e341 {
                                if (_e323 >= 0f) {
                                    phi_1570_ = (_e323 <= 1f);
                                } else {
                                    phi_1570_ = false;
                                }
                                let _e345 = phi_1570_;
                                if _e345 {
                                    if (_e336 >= 0f) {
                                        phi_1579_ = (_e336 <= 1f);
                                    } else {
                                        phi_1579_ = false;
                                    }
                                    let _e349 = phi_1579_;
                                    phi_1580_ = _e349;
                                    phi_1581_ = false;
                                } else {
                                    phi_1580_ = bool();
                                    phi_1581_ = true;
                                }
                                let _e351 = phi_1580_;
                                let _e353 = phi_1581_;
                                phi_1582_ = _e351;
                                phi_1583_ = _e353;
                            } else {
                                phi_1582_ = bool();
                                phi_1583_ = true;
                            }
                            let _e355 = phi_1582_;
                            let _e357 = phi_1583_;
                            phi_1584_ = _e355;
                            phi_1585_ = _e357;
                        } else {
                            phi_1584_ = bool();
                            phi_1585_ = true;
                        }
                        let _e359 = phi_1584_;
                        let _e361 = phi_1585_;
                        if _e361 {
                            phi_1589_ = false;
                        } else {
                            phi_1589_ = _e359;
                        }
                        let _e363 = phi_1589_;
                        if _e363 {
                            if (_e309 >= _e244) {
                                if (_e309 <= (1f - _e244)) {
                                    if (_e323 >= _e244) {
                                        phi_1616_ = (_e323 <= (1f - _e244));
                                        phi_1617_ = false;
                                    } else {
                                        phi_1616_ = bool();
                                        phi_1617_ = true;
                                    }
                                    let _e371 = phi_1616_;
                                    let _e373 = phi_1617_;
                                    phi_1618_ = _e371;
                                    phi_1619_ = _e373;
                                } else {
                                    phi_1618_ = bool();
                                    phi_1619_ = true;
                                }
                                let _e375 = phi_1618_;
                                let _e377 = phi_1619_;
                                phi_1620_ = _e375;
                                phi_1621_ = _e377;
                            } else {
                                phi_1620_ = bool();
                                phi_1621_ = true;
                            }
                            let _e379 = phi_1620_;
                            let _e381 = phi_1621_;
                            phi_1622_ = _e379;
                            phi_1623_ = _e381;
                        } else {
                            phi_1622_ = bool();
                            phi_1623_ = true;
                        }
                        let _e383 = phi_1622_;
                        let _e385 = phi_1623_;
                        if _e385 {
                            phi_1627_ = false;
                        } else {
                            phi_1627_ = _e383;
                        }
                        let _e387 = phi_1627_;
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e309, _e269.uv.y), _e269.depth, _e269.is_inside);
                        let _e401 = lt_math_LightPoint(vec2<f32>(_e394.uv.x, _e323), _e394.depth, _e394.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e336, _e401.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e405.depth, _e387);
                        phi_1636_ = _e409;
                        phi_1637_ = (_e271 + 1u);
                        phi_1638_ = lt_math_LevelPoint(_e271, _e409);
                        phi_1639_ = true;
                    }
                    let _e413 = phi_1636_;
                    let _e415 = phi_1637_;
                    let _e417 = phi_1638_;
                    let _e419 = phi_1639_;
                    phi_1471_ = _e413;
                    phi_1474_ = _e415;
                    phi_1476_ = _e417;
                    phi_1640_ = _e419;
                } else {
                    phi_1471_ = lt_math_LightPoint();
                    phi_1474_ = u32();
                    phi_1476_ = lt_math_LevelPoint();
                    phi_1640_ = false;
                }
                let _e421 = phi_1471_;
                let _e423 = phi_1474_;
                let _e425 = phi_1476_;
                let _e427 = phi_1640_;
                continue;
                continuing {
                    phi_1470_ = _e421;
                    phi_1473_ = _e423;
                    phi_1475_ = _e425;
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
                            phi_1680_ = (_e441.row_w.z == _e453);
                            phi_1681_ = false;
                        } else {
                            phi_1680_ = bool();
                            phi_1681_ = true;
                        }
                        let _e456 = phi_1680_;
                        let _e458 = phi_1681_;
                        phi_1682_ = _e456;
                        phi_1683_ = _e458;
                    } else {
                        phi_1682_ = bool();
                        phi_1683_ = true;
                    }
                    let _e460 = phi_1682_;
                    let _e462 = phi_1683_;
                    if _e462 {
                        phi_1687_ = false;
                    } else {
                        phi_1687_ = _e460;
                    }
                    let _e464 = phi_1687_;
                    if _e464 {
                        let _e466 = samples.member[_e74.first_primitive].normal;
                        let _e468 = p.member.map_size;
                        let _e538 = ((abs(((((_e441.row_x.x * _e466.x) + (_e441.row_x.y * _e466.y)) + (_e441.row_x.z * _e466.z)) / (((_e441.row_x.x * _e441.row_x.x) + (_e441.row_x.y * _e441.row_x.y)) + (_e441.row_x.z * _e441.row_x.z)))) + abs(((((_e441.row_y.x * _e466.x) + (_e441.row_y.y * _e466.y)) + (_e441.row_y.z * _e466.z)) / (((_e441.row_y.x * _e441.row_y.x) + (_e441.row_y.y * _e441.row_y.y)) + (_e441.row_y.z * _e441.row_y.z))))) / (abs(((((_e441.row_z.x * _e466.x) + (_e441.row_z.y * _e466.y)) + (_e441.row_z.z * _e466.z)) / (((_e441.row_z.x * _e441.row_z.x) + (_e441.row_z.y * _e441.row_z.y)) + (_e441.row_z.z * _e441.row_z.z)))) * f32(_e468)));
                        if (_e538 < 0.002f) {
                            phi_1769_ = _e538;
                        } else {
                            phi_1769_ = 0.002f;
                        }
                        let _e541 = phi_1769_;
                        phi_1886_ = _e541;
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
                        if (_e655 < 0.002f) {
                            phi_1885_ = _e655;
                        } else {
                            phi_1885_ = 0.002f;
                        }
                        let _e658 = phi_1885_;
                        phi_1886_ = _e658;
                    }
                    let _e660 = phi_1886_;
                    phi_1889_ = (_e430.point.depth - (0f * _e660));
                } else {
                    phi_1889_ = _e430.point.depth;
                }
                let _e664 = phi_1889_;
                let _e670 = p.member.map_size;
                let _e671 = f32(_e670);
                let _e674 = ((_e430.point.uv.x * _e671) - 0.5f);
                let _e675 = ((_e430.point.uv.y * _e671) - 0.5f);
                if (_e674 > -8388608f) {
                    let _e687 = f32(select(0i, select(select(i32(_e674), i32(-2147483648), (_e674 < bitcast<f32>(3472883712u))), 2147483647i, (_e674 > bitcast<f32>(1325400063u))), (_e674 == _e674)));
                    if (_e687 > _e674) {
                        phi_1918_ = 1f;
                    } else {
                        phi_1918_ = 0f;
                    }
                    let _e690 = phi_1918_;
                    if (_e674 < 8388608f) {
                        phi_1923_ = (_e687 - _e690);
                        phi_1924_ = false;
                    } else {
                        phi_1923_ = f32();
                        phi_1924_ = true;
                    }
                    let _e693 = phi_1923_;
                    let _e695 = phi_1924_;
                    phi_1925_ = _e693;
                    phi_1926_ = _e695;
                } else {
                    phi_1925_ = f32();
                    phi_1926_ = true;
                }
                let _e697 = phi_1925_;
                let _e699 = phi_1926_;
                if _e699 {
                    phi_1930_ = _e674;
                } else {
                    phi_1930_ = _e697;
                }
                let _e701 = phi_1930_;
                if (_e675 > -8388608f) {
                    let _e713 = f32(select(0i, select(select(i32(_e675), i32(-2147483648), (_e675 < bitcast<f32>(3472883712u))), 2147483647i, (_e675 > bitcast<f32>(1325400063u))), (_e675 == _e675)));
                    if (_e713 > _e675) {
                        phi_1950_ = 1f;
                    } else {
                        phi_1950_ = 0f;
                    }
                    let _e716 = phi_1950_;
                    if (_e675 < 8388608f) {
                        phi_1955_ = (_e713 - _e716);
                        phi_1956_ = false;
                    } else {
                        phi_1955_ = f32();
                        phi_1956_ = true;
                    }
                    let _e719 = phi_1955_;
                    let _e721 = phi_1956_;
                    phi_1957_ = _e719;
                    phi_1958_ = _e721;
                } else {
                    phi_1957_ = f32();
                    phi_1958_ = true;
                }
                let _e723 = phi_1957_;
                let _e725 = phi_1958_;
                if _e725 {
                    phi_1962_ = _e675;
                } else {
                    phi_1962_ = _e723;
                }
                let _e727 = phi_1962_;
                let _e728 = (_e674 - _e701);
                let _e729 = (_e675 - _e727);
                let _e738 = select(0i, select(select(i32(_e701), i32(-2147483648), (_e701 < bitcast<f32>(3472883712u))), 2147483647i, (_e701 > bitcast<f32>(1325400063u))), (_e701 == _e701));
                let _e747 = select(0i, select(select(i32(_e727), i32(-2147483648), (_e727 < bitcast<f32>(3472883712u))), 2147483647i, (_e727 > bitcast<f32>(1325400063u))), (_e727 == _e727));
                let _e758 = p.member.test;
                let _e759 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e758);
                let _e761 = p.member.map_size;
                let _e763 = local_4;
                local_1 = lt_math_Evsm(_e759.positive_exponent, _e759.negative_exponent, _e759.min_variance);
                let _e770 = ((_e763.level * _e761) * _e761);
                let _e772 = (bitcast<i32>(_e761) - 1i);
                if (_e738 > 0i) {
                    phi_2015_ = _e738;
                } else {
                    phi_2015_ = 0i;
                }
                let _e775 = phi_2015_;
                if (_e747 > 0i) {
                    phi_2020_ = _e747;
                } else {
                    phi_2020_ = 0i;
                }
                let _e778 = phi_2020_;
                if (_e775 < _e772) {
                    phi_2025_ = _e775;
                } else {
                    phi_2025_ = _e772;
                }
                let _e781 = phi_2025_;
                if (_e778 < _e772) {
                    phi_2030_ = _e778;
                } else {
                    phi_2030_ = _e772;
                }
                let _e784 = phi_2030_;
                let _e785 = bitcast<u32>(_e781);
                let _e787 = (_e738 + 1i);
                let _e788 = (_e747 + 1i);
                if (_e787 > 0i) {
                    phi_2039_ = _e787;
                } else {
                    phi_2039_ = 0i;
                }
                let _e791 = phi_2039_;
                if (_e788 > 0i) {
                    phi_2044_ = _e788;
                } else {
                    phi_2044_ = 0i;
                }
                let _e794 = phi_2044_;
                if (_e791 < _e772) {
                    phi_2049_ = _e791;
                } else {
                    phi_2049_ = _e772;
                }
                let _e797 = phi_2049_;
                if (_e794 < _e772) {
                    phi_2054_ = _e794;
                } else {
                    phi_2054_ = _e772;
                }
                let _e800 = phi_2054_;
                let _e801 = bitcast<u32>(_e797);
                let _e803 = (bitcast<u32>(_e784) * _e761);
                let _e804 = (bitcast<u32>(_e800) * _e761);
                let _e809 = ((_e803 + _e785) + _e770);
                let _e810 = ((_e803 + _e801) + _e770);
                let _e811 = ((_e804 + _e785) + _e770);
                let _e812 = ((_e804 + _e801) + _e770);
                if (_e809 < _e63) {
                } else {
                    return;
                }
                let _e816 = map.member[(0u + _e809)];
                if (_e810 < _e63) {
                } else {
                    return;
                }
                let _e820 = map.member[(0u + _e810)];
                if (_e811 < _e63) {
                } else {
                    return;
                }
                let _e824 = map.member[(0u + _e811)];
                if (_e812 < _e63) {
                } else {
                    return;
                }
                let _e828 = map.member[(0u + _e812)];
                let _e830 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e816, _e820, _e824, _e828), vec4<f32>(((1f - _e728) * (1f - _e729)), (_e728 * (1f - _e729)), ((1f - _e728) * _e729), (_e728 * _e729)), _e664);
                let _e832 = p.member.epsilon;
                if (_e830 <= _e832) {
                    phi_2105_ = true;
                } else {
                    phi_2105_ = (_e830 >= (1f - _e832));
                }
                let _e837 = phi_2105_;
                if ((bitcast<u32>(_e830) & 2147483647u) > 2139095040u) {
                    phi_2113_ = true;
                } else {
                    phi_2113_ = !(_e837);
                }
                let _e843 = phi_2113_;
                if _e843 {
                    if (_e830 > 0f) {
                        if (_e830 < 1f) {
                            phi_2125_ = false;
                        } else {
                            phi_2125_ = true;
                        }
                        let _e847 = phi_2125_;
                        phi_2126_ = _e847;
                    } else {
                        phi_2126_ = true;
                    }
                    let _e849 = phi_2126_;
                    if _e849 {
                        phi_2130_ = 0.5f;
                    } else {
                        phi_2130_ = _e830;
                    }
                    let _e851 = phi_2130_;
                    phi_2138_ = evaluate_Verdict(_e851, true);
                } else {
                    if (_e830 > 0.5f) {
                        phi_2136_ = 1f;
                    } else {
                        phi_2136_ = 0f;
                    }
                    let _e855 = phi_2136_;
                    phi_2138_ = evaluate_Verdict(_e855, false);
                }
                let _e858 = phi_2138_;
                phi_2143_ = evaluate_Verdict(_e858.visibility, _e858.is_doubted);
            } else {
                phi_2143_ = evaluate_Verdict(0.5f, true);
            }
            let _e864 = phi_2143_;
            phi_2144_ = _e864;
        }
        let _e866 = phi_2144_;
        visibility.member[_e74.first_primitive] = _e866.visibility;
        phi_2148_ = _e866.is_doubted;
        phi_2149_ = _e74.first_primitive;
    } else {
        phi_2148_ = false;
        phi_2149_ = 0u;
    }
    let _e871 = phi_2148_;
    let _e873 = phi_2149_;
    if (_e58 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e871 {
        let _e877 = atomicAdd((&shared_[0u]), 1u);
        phi_2160_ = _e877;
    } else {
        phi_2160_ = 0u;
    }
    let _e879 = phi_2160_;
    workgroupBarrier();
    if (_e58 == 0u) {
        let _e883 = atomicLoad((&shared_[0u]));
        let _e884 = atomicAdd((&list.member[3u]), _e883);
        atomicStore((&shared_[1u]), _e884);
    }
    workgroupBarrier();
    if _e871 {
        let _e887 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e887) + _e879)]), _e873);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
