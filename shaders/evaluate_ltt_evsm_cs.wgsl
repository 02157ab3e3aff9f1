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

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct type_46 {
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
var<storage, read_write> list: type_46;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_171_: lt_bvh_traverse_Tree;
    var phi_172_: bool;
    var phi_173_: lt_bvh_traverse_Tree;
    var phi_174_: bool;
    var phi_179_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_171_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_172_ = false;
        } else {
            phi_171_ = lt_bvh_traverse_Tree();
            phi_172_ = true;
        }
        let _e68 = phi_171_;
        let _e70 = phi_172_;
        phi_173_ = _e68;
        phi_174_ = _e70;
    } else {
        phi_173_ = lt_bvh_traverse_Tree();
        phi_174_ = true;
    }
    let _e72 = phi_173_;
    let _e74 = phi_174_;
    if _e74 {
        phi_179_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_179_ = _e72;
    }
    let _e79 = phi_179_;
    return lt_bvh_traverse_Tree(_e79.root, _e79.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_359_: bool;
    var phi_363_: f32;
    var phi_382_: f32;
    var phi_387_: f32;
    var phi_409_: f32;
    var phi_414_: f32;
    var phi_415_: bool;
    var phi_416_: f32;
    var phi_417_: bool;
    var phi_421_: f32;
    var phi_459_: f32;
    var phi_470_: f32;
    var phi_475_: f32;
    var phi_497_: f32;
    var phi_502_: f32;
    var phi_503_: bool;
    var phi_504_: f32;
    var phi_505_: bool;
    var phi_509_: f32;
    var phi_547_: f32;
    var phi_558_: f32;
    var phi_563_: f32;
    var phi_585_: f32;
    var phi_590_: f32;
    var phi_591_: bool;
    var phi_592_: f32;
    var phi_593_: bool;
    var phi_597_: f32;
    var phi_635_: f32;
    var phi_646_: f32;
    var phi_651_: f32;
    var phi_673_: f32;
    var phi_678_: f32;
    var phi_679_: bool;
    var phi_680_: f32;
    var phi_681_: bool;
    var phi_685_: f32;
    var phi_723_: f32;
    var phi_776_: bool;
    var phi_780_: f32;
    var phi_792_: bool;
    var phi_799_: f32;
    var phi_812_: bool;
    var phi_816_: f32;
    var phi_836_: f32;
    var phi_841_: f32;
    var phi_863_: f32;
    var phi_868_: f32;
    var phi_869_: bool;
    var phi_870_: f32;
    var phi_871_: bool;
    var phi_875_: f32;
    var phi_913_: f32;
    var phi_924_: f32;
    var phi_929_: f32;
    var phi_951_: f32;
    var phi_956_: f32;
    var phi_957_: bool;
    var phi_958_: f32;
    var phi_959_: bool;
    var phi_963_: f32;
    var phi_1001_: f32;
    var phi_1012_: f32;
    var phi_1017_: f32;
    var phi_1039_: f32;
    var phi_1044_: f32;
    var phi_1045_: bool;
    var phi_1046_: f32;
    var phi_1047_: bool;
    var phi_1051_: f32;
    var phi_1089_: f32;
    var phi_1100_: f32;
    var phi_1105_: f32;
    var phi_1127_: f32;
    var phi_1132_: f32;
    var phi_1133_: bool;
    var phi_1134_: f32;
    var phi_1135_: bool;
    var phi_1139_: f32;
    var phi_1177_: f32;
    var phi_1230_: bool;
    var phi_1234_: f32;
    var phi_1246_: bool;
    var phi_1253_: f32;
    var phi_1264_: bool;
    var phi_1268_: f32;
    var phi_1283_: f32;
    var phi_1284_: f32;
    var phi_1285_: f32;

    let _e59 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_359_ = true;
    } else {
        let _e63 = (42f < _e59);
        if _e63 {
        }
        phi_359_ = _e63;
    }
    let _e65 = phi_359_;
    if _e65 {
        phi_363_ = 42f;
    } else {
        phi_363_ = _e59;
    }
    let _e67 = phi_363_;
    let _e69 = (_e67 * param_5.x);
    let _e71 = (_e67 * param_5.y);
    let _e73 = (_e67 * param_5.z);
    let _e75 = (_e67 * param_5.w);
    if ((bitcast<u32>(_e69) & 2147483647u) > 2139095040u) {
        phi_459_ = _e69;
    } else {
        if (_e69 < -87f) {
            phi_382_ = -87f;
        } else {
            phi_382_ = _e69;
        }
        let _e81 = phi_382_;
        if (_e81 > 88f) {
            phi_387_ = 88f;
        } else {
            phi_387_ = _e81;
        }
        let _e84 = phi_387_;
        let _e86 = ((_e84 * 1.442695f) + 0.5f);
        if (_e86 > -8388608f) {
            let _e98 = f32(select(0i, select(select(i32(_e86), i32(-2147483648), (_e86 < bitcast<f32>(3472883712u))), 2147483647i, (_e86 > bitcast<f32>(1325400063u))), (_e86 == _e86)));
            if (_e98 > _e86) {
                phi_409_ = 1f;
            } else {
                phi_409_ = 0f;
            }
            let _e101 = phi_409_;
            if (_e86 < 8388608f) {
                phi_414_ = (_e98 - _e101);
                phi_415_ = false;
            } else {
                phi_414_ = f32();
                phi_415_ = true;
            }
            let _e104 = phi_414_;
            let _e106 = phi_415_;
            phi_416_ = _e104;
            phi_417_ = _e106;
        } else {
            phi_416_ = f32();
            phi_417_ = true;
        }
        let _e108 = phi_416_;
        let _e110 = phi_417_;
        if _e110 {
            phi_421_ = _e86;
        } else {
            phi_421_ = _e108;
        }
        let _e112 = phi_421_;
        let _e116 = ((_e84 - (_e112 * 0.69314575f)) - (_e112 * 0.0000014286068f));
        phi_459_ = ((((((((((((((((1f / 5040f) * _e116) + (1f / 720f)) * _e116) + (1f / 120f)) * _e116) + (1f / 24f)) * _e116) + (1f / 6f)) * _e116) + 0.5f) * _e116) + 1f) * _e116) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e112), i32(-2147483648), (_e112 < bitcast<f32>(3472883712u))), 2147483647i, (_e112 > bitcast<f32>(1325400063u))), (_e112 == _e112)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e152 = phi_459_;
    if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
        phi_547_ = _e71;
    } else {
        if (_e71 < -87f) {
            phi_470_ = -87f;
        } else {
            phi_470_ = _e71;
        }
        let _e158 = phi_470_;
        if (_e158 > 88f) {
            phi_475_ = 88f;
        } else {
            phi_475_ = _e158;
        }
        let _e161 = phi_475_;
        let _e163 = ((_e161 * 1.442695f) + 0.5f);
        if (_e163 > -8388608f) {
            let _e175 = f32(select(0i, select(select(i32(_e163), i32(-2147483648), (_e163 < bitcast<f32>(3472883712u))), 2147483647i, (_e163 > bitcast<f32>(1325400063u))), (_e163 == _e163)));
            if (_e175 > _e163) {
                phi_497_ = 1f;
            } else {
                phi_497_ = 0f;
            }
            let _e178 = phi_497_;
            if (_e163 < 8388608f) {
                phi_502_ = (_e175 - _e178);
                phi_503_ = false;
            } else {
                phi_502_ = f32();
                phi_503_ = true;
            }
            let _e181 = phi_502_;
            let _e183 = phi_503_;
            phi_504_ = _e181;
            phi_505_ = _e183;
        } else {
            phi_504_ = f32();
            phi_505_ = true;
        }
        let _e185 = phi_504_;
        let _e187 = phi_505_;
        if _e187 {
            phi_509_ = _e163;
        } else {
            phi_509_ = _e185;
        }
        let _e189 = phi_509_;
        let _e193 = ((_e161 - (_e189 * 0.69314575f)) - (_e189 * 0.0000014286068f));
        phi_547_ = ((((((((((((((((1f / 5040f) * _e193) + (1f / 720f)) * _e193) + (1f / 120f)) * _e193) + (1f / 24f)) * _e193) + (1f / 6f)) * _e193) + 0.5f) * _e193) + 1f) * _e193) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e189), i32(-2147483648), (_e189 < bitcast<f32>(3472883712u))), 2147483647i, (_e189 > bitcast<f32>(1325400063u))), (_e189 == _e189)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e229 = phi_547_;
    if ((bitcast<u32>(_e73) & 2147483647u) > 2139095040u) {
        phi_635_ = _e73;
    } else {
        if (_e73 < -87f) {
            phi_558_ = -87f;
        } else {
            phi_558_ = _e73;
        }
        let _e235 = phi_558_;
        if (_e235 > 88f) {
            phi_563_ = 88f;
        } else {
            phi_563_ = _e235;
        }
        let _e238 = phi_563_;
        let _e240 = ((_e238 * 1.442695f) + 0.5f);
        if (_e240 > -8388608f) {
            let _e252 = f32(select(0i, select(select(i32(_e240), i32(-2147483648), (_e240 < bitcast<f32>(3472883712u))), 2147483647i, (_e240 > bitcast<f32>(1325400063u))), (_e240 == _e240)));
            if (_e252 > _e240) {
                phi_585_ = 1f;
            } else {
                phi_585_ = 0f;
            }
            let _e255 = phi_585_;
            if (_e240 < 8388608f) {
                phi_590_ = (_e252 - _e255);
                phi_591_ = false;
            } else {
                phi_590_ = f32();
                phi_591_ = true;
            }
            let _e258 = phi_590_;
            let _e260 = phi_591_;
            phi_592_ = _e258;
            phi_593_ = _e260;
        } else {
            phi_592_ = f32();
            phi_593_ = true;
        }
        let _e262 = phi_592_;
        let _e264 = phi_593_;
        if _e264 {
            phi_597_ = _e240;
        } else {
            phi_597_ = _e262;
        }
        let _e266 = phi_597_;
        let _e270 = ((_e238 - (_e266 * 0.69314575f)) - (_e266 * 0.0000014286068f));
        phi_635_ = ((((((((((((((((1f / 5040f) * _e270) + (1f / 720f)) * _e270) + (1f / 120f)) * _e270) + (1f / 24f)) * _e270) + (1f / 6f)) * _e270) + 0.5f) * _e270) + 1f) * _e270) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e266), i32(-2147483648), (_e266 < bitcast<f32>(3472883712u))), 2147483647i, (_e266 > bitcast<f32>(1325400063u))), (_e266 == _e266)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e306 = phi_635_;
    if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
        phi_723_ = _e75;
    } else {
        if (_e75 < -87f) {
            phi_646_ = -87f;
        } else {
            phi_646_ = _e75;
        }
        let _e312 = phi_646_;
        if (_e312 > 88f) {
            phi_651_ = 88f;
        } else {
            phi_651_ = _e312;
        }
        let _e315 = phi_651_;
        let _e317 = ((_e315 * 1.442695f) + 0.5f);
        if (_e317 > -8388608f) {
            let _e329 = f32(select(0i, select(select(i32(_e317), i32(-2147483648), (_e317 < bitcast<f32>(3472883712u))), 2147483647i, (_e317 > bitcast<f32>(1325400063u))), (_e317 == _e317)));
            if (_e329 > _e317) {
                phi_673_ = 1f;
            } else {
                phi_673_ = 0f;
            }
            let _e332 = phi_673_;
            if (_e317 < 8388608f) {
                phi_678_ = (_e329 - _e332);
                phi_679_ = false;
            } else {
                phi_678_ = f32();
                phi_679_ = true;
            }
            let _e335 = phi_678_;
            let _e337 = phi_679_;
            phi_680_ = _e335;
            phi_681_ = _e337;
        } else {
            phi_680_ = f32();
            phi_681_ = true;
        }
        let _e339 = phi_680_;
        let _e341 = phi_681_;
        if _e341 {
            phi_685_ = _e317;
        } else {
            phi_685_ = _e339;
        }
        let _e343 = phi_685_;
        let _e347 = ((_e315 - (_e343 * 0.69314575f)) - (_e343 * 0.0000014286068f));
        phi_723_ = ((((((((((((((((1f / 5040f) * _e347) + (1f / 720f)) * _e347) + (1f / 120f)) * _e347) + (1f / 24f)) * _e347) + (1f / 6f)) * _e347) + 0.5f) * _e347) + 1f) * _e347) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e343), i32(-2147483648), (_e343 < bitcast<f32>(3472883712u))), 2147483647i, (_e343 > bitcast<f32>(1325400063u))), (_e343 == _e343)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e383 = phi_723_;
    let _e385 = (_e152 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e387 = (_e229 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e389 = (_e306 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e391 = (_e383 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e393 = (*param_4).min_variance;
    let _e395 = ((_e393 * _e67) * _e67);
    let _e406 = ((((_e385 * param_6.x) + (_e387 * param_6.y)) + (_e389 * param_6.z)) + (_e391 * param_6.w));
    let _e407 = (_e385 - _e406);
    let _e408 = (_e387 - _e406);
    let _e409 = (_e389 - _e406);
    let _e410 = (_e391 - _e406);
    let _e425 = (((((_e407 * _e407) * param_6.x) + ((_e408 * _e408) * param_6.y)) + ((_e409 * _e409) * param_6.z)) + ((_e410 * _e410) * param_6.w));
    if ((bitcast<u32>(_e395) & 2147483647u) > 2139095040u) {
        phi_776_ = true;
    } else {
        let _e429 = (_e395 > _e425);
        if _e429 {
        }
        phi_776_ = _e429;
    }
    let _e431 = phi_776_;
    if _e431 {
        phi_780_ = _e395;
    } else {
        phi_780_ = _e425;
    }
    let _e433 = phi_780_;
    let _e434 = -(_e406);
    if (_e434 <= 0f) {
        let _e438 = ((bitcast<u32>(_e433) & 2147483647u) > 2139095040u);
        if _e438 {
        }
        phi_792_ = _e438;
    } else {
        phi_792_ = true;
    }
    let _e440 = phi_792_;
    if _e440 {
        phi_799_ = (_e433 / (_e433 + (_e434 * _e434)));
    } else {
        phi_799_ = 1f;
    }
    let _e445 = phi_799_;
    let _e447 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_812_ = true;
    } else {
        let _e451 = (42f < _e447);
        if _e451 {
        }
        phi_812_ = _e451;
    }
    let _e453 = phi_812_;
    if _e453 {
        phi_816_ = 42f;
    } else {
        phi_816_ = _e447;
    }
    let _e455 = phi_816_;
    let _e456 = -(_e455);
    let _e458 = (_e456 * param_5.x);
    let _e460 = (_e456 * param_5.y);
    let _e462 = (_e456 * param_5.z);
    let _e464 = (_e456 * param_5.w);
    if ((bitcast<u32>(_e458) & 2147483647u) > 2139095040u) {
        phi_913_ = _e458;
    } else {
        if (_e458 < -87f) {
            phi_836_ = -87f;
        } else {
            phi_836_ = _e458;
        }
        let _e470 = phi_836_;
        if (_e470 > 88f) {
            phi_841_ = 88f;
        } else {
            phi_841_ = _e470;
        }
        let _e473 = phi_841_;
        let _e475 = ((_e473 * 1.442695f) + 0.5f);
        if (_e475 > -8388608f) {
            let _e487 = f32(select(0i, select(select(i32(_e475), i32(-2147483648), (_e475 < bitcast<f32>(3472883712u))), 2147483647i, (_e475 > bitcast<f32>(1325400063u))), (_e475 == _e475)));
            if (_e487 > _e475) {
                phi_863_ = 1f;
            } else {
                phi_863_ = 0f;
            }
            let _e490 = phi_863_;
            if (_e475 < 8388608f) {
                phi_868_ = (_e487 - _e490);
                phi_869_ = false;
            } else {
                phi_868_ = f32();
                phi_869_ = true;
            }
            let _e493 = phi_868_;
            let _e495 = phi_869_;
            phi_870_ = _e493;
            phi_871_ = _e495;
        } else {
            phi_870_ = f32();
            phi_871_ = true;
        }
        let _e497 = phi_870_;
        let _e499 = phi_871_;
        if _e499 {
            phi_875_ = _e475;
        } else {
            phi_875_ = _e497;
        }
        let _e501 = phi_875_;
        let _e505 = ((_e473 - (_e501 * 0.69314575f)) - (_e501 * 0.0000014286068f));
        phi_913_ = ((((((((((((((((1f / 5040f) * _e505) + (1f / 720f)) * _e505) + (1f / 120f)) * _e505) + (1f / 24f)) * _e505) + (1f / 6f)) * _e505) + 0.5f) * _e505) + 1f) * _e505) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e501), i32(-2147483648), (_e501 < bitcast<f32>(3472883712u))), 2147483647i, (_e501 > bitcast<f32>(1325400063u))), (_e501 == _e501)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e541 = phi_913_;
    if ((bitcast<u32>(_e460) & 2147483647u) > 2139095040u) {
        phi_1001_ = _e460;
    } else {
        if (_e460 < -87f) {
            phi_924_ = -87f;
        } else {
            phi_924_ = _e460;
        }
        let _e547 = phi_924_;
        if (_e547 > 88f) {
            phi_929_ = 88f;
        } else {
            phi_929_ = _e547;
        }
        let _e550 = phi_929_;
        let _e552 = ((_e550 * 1.442695f) + 0.5f);
        if (_e552 > -8388608f) {
            let _e564 = f32(select(0i, select(select(i32(_e552), i32(-2147483648), (_e552 < bitcast<f32>(3472883712u))), 2147483647i, (_e552 > bitcast<f32>(1325400063u))), (_e552 == _e552)));
            if (_e564 > _e552) {
                phi_951_ = 1f;
            } else {
                phi_951_ = 0f;
            }
            let _e567 = phi_951_;
            if (_e552 < 8388608f) {
                phi_956_ = (_e564 - _e567);
                phi_957_ = false;
            } else {
                phi_956_ = f32();
                phi_957_ = true;
            }
            let _e570 = phi_956_;
            let _e572 = phi_957_;
            phi_958_ = _e570;
            phi_959_ = _e572;
        } else {
            phi_958_ = f32();
            phi_959_ = true;
        }
        let _e574 = phi_958_;
        let _e576 = phi_959_;
        if _e576 {
            phi_963_ = _e552;
        } else {
            phi_963_ = _e574;
        }
        let _e578 = phi_963_;
        let _e582 = ((_e550 - (_e578 * 0.69314575f)) - (_e578 * 0.0000014286068f));
        phi_1001_ = ((((((((((((((((1f / 5040f) * _e582) + (1f / 720f)) * _e582) + (1f / 120f)) * _e582) + (1f / 24f)) * _e582) + (1f / 6f)) * _e582) + 0.5f) * _e582) + 1f) * _e582) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e578), i32(-2147483648), (_e578 < bitcast<f32>(3472883712u))), 2147483647i, (_e578 > bitcast<f32>(1325400063u))), (_e578 == _e578)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e618 = phi_1001_;
    if ((bitcast<u32>(_e462) & 2147483647u) > 2139095040u) {
        phi_1089_ = _e462;
    } else {
        if (_e462 < -87f) {
            phi_1012_ = -87f;
        } else {
            phi_1012_ = _e462;
        }
        let _e624 = phi_1012_;
        if (_e624 > 88f) {
            phi_1017_ = 88f;
        } else {
            phi_1017_ = _e624;
        }
        let _e627 = phi_1017_;
        let _e629 = ((_e627 * 1.442695f) + 0.5f);
        if (_e629 > -8388608f) {
            let _e641 = f32(select(0i, select(select(i32(_e629), i32(-2147483648), (_e629 < bitcast<f32>(3472883712u))), 2147483647i, (_e629 > bitcast<f32>(1325400063u))), (_e629 == _e629)));
            if (_e641 > _e629) {
                phi_1039_ = 1f;
            } else {
                phi_1039_ = 0f;
            }
            let _e644 = phi_1039_;
            if (_e629 < 8388608f) {
                phi_1044_ = (_e641 - _e644);
                phi_1045_ = false;
            } else {
                phi_1044_ = f32();
                phi_1045_ = true;
            }
            let _e647 = phi_1044_;
            let _e649 = phi_1045_;
            phi_1046_ = _e647;
            phi_1047_ = _e649;
        } else {
            phi_1046_ = f32();
            phi_1047_ = true;
        }
        let _e651 = phi_1046_;
        let _e653 = phi_1047_;
        if _e653 {
            phi_1051_ = _e629;
        } else {
            phi_1051_ = _e651;
        }
        let _e655 = phi_1051_;
        let _e659 = ((_e627 - (_e655 * 0.69314575f)) - (_e655 * 0.0000014286068f));
        phi_1089_ = ((((((((((((((((1f / 5040f) * _e659) + (1f / 720f)) * _e659) + (1f / 120f)) * _e659) + (1f / 24f)) * _e659) + (1f / 6f)) * _e659) + 0.5f) * _e659) + 1f) * _e659) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e655), i32(-2147483648), (_e655 < bitcast<f32>(3472883712u))), 2147483647i, (_e655 > bitcast<f32>(1325400063u))), (_e655 == _e655)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e695 = phi_1089_;
    if ((bitcast<u32>(_e464) & 2147483647u) > 2139095040u) {
        phi_1177_ = _e464;
    } else {
        if (_e464 < -87f) {
            phi_1100_ = -87f;
        } else {
            phi_1100_ = _e464;
        }
        let _e701 = phi_1100_;
        if (_e701 > 88f) {
            phi_1105_ = 88f;
        } else {
            phi_1105_ = _e701;
        }
        let _e704 = phi_1105_;
        let _e706 = ((_e704 * 1.442695f) + 0.5f);
        if (_e706 > -8388608f) {
            let _e718 = f32(select(0i, select(select(i32(_e706), i32(-2147483648), (_e706 < bitcast<f32>(3472883712u))), 2147483647i, (_e706 > bitcast<f32>(1325400063u))), (_e706 == _e706)));
            if (_e718 > _e706) {
                phi_1127_ = 1f;
            } else {
                phi_1127_ = 0f;
            }
            let _e721 = phi_1127_;
            if (_e706 < 8388608f) {
                phi_1132_ = (_e718 - _e721);
                phi_1133_ = false;
            } else {
                phi_1132_ = f32();
                phi_1133_ = true;
            }
            let _e724 = phi_1132_;
            let _e726 = phi_1133_;
            phi_1134_ = _e724;
            phi_1135_ = _e726;
        } else {
            phi_1134_ = f32();
            phi_1135_ = true;
        }
        let _e728 = phi_1134_;
        let _e730 = phi_1135_;
        if _e730 {
            phi_1139_ = _e706;
        } else {
            phi_1139_ = _e728;
        }
        let _e732 = phi_1139_;
        let _e736 = ((_e704 - (_e732 * 0.69314575f)) - (_e732 * 0.0000014286068f));
        phi_1177_ = ((((((((((((((((1f / 5040f) * _e736) + (1f / 720f)) * _e736) + (1f / 120f)) * _e736) + (1f / 24f)) * _e736) + (1f / 6f)) * _e736) + 0.5f) * _e736) + 1f) * _e736) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e732), i32(-2147483648), (_e732 < bitcast<f32>(3472883712u))), 2147483647i, (_e732 > bitcast<f32>(1325400063u))), (_e732 == _e732)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e772 = phi_1177_;
    let _e774 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e541);
    let _e776 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e618);
    let _e778 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e695);
    let _e780 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e772);
    let _e782 = (*param_4).min_variance;
    let _e784 = ((_e782 * _e455) * _e455);
    let _e795 = ((((_e774 * param_6.x) + (_e776 * param_6.y)) + (_e778 * param_6.z)) + (_e780 * param_6.w));
    let _e796 = (_e774 - _e795);
    let _e797 = (_e776 - _e795);
    let _e798 = (_e778 - _e795);
    let _e799 = (_e780 - _e795);
    let _e814 = (((((_e796 * _e796) * param_6.x) + ((_e797 * _e797) * param_6.y)) + ((_e798 * _e798) * param_6.z)) + ((_e799 * _e799) * param_6.w));
    if ((bitcast<u32>(_e784) & 2147483647u) > 2139095040u) {
        phi_1230_ = true;
    } else {
        let _e818 = (_e784 > _e814);
        if _e818 {
        }
        phi_1230_ = _e818;
    }
    let _e820 = phi_1230_;
    if _e820 {
        phi_1234_ = _e784;
    } else {
        phi_1234_ = _e814;
    }
    let _e822 = phi_1234_;
    let _e823 = -(_e795);
    if (_e823 <= 0f) {
        let _e827 = ((bitcast<u32>(_e822) & 2147483647u) > 2139095040u);
        if _e827 {
        }
        phi_1246_ = _e827;
    } else {
        phi_1246_ = true;
    }
    let _e829 = phi_1246_;
    if _e829 {
        phi_1253_ = (_e822 / (_e822 + (_e823 * _e823)));
    } else {
        phi_1253_ = 1f;
    }
    let _e834 = phi_1253_;
    if ((bitcast<u32>(_e834) & 2147483647u) > 2139095040u) {
        phi_1264_ = true;
    } else {
        let _e838 = (_e834 < _e445);
        if _e838 {
        }
        phi_1264_ = _e838;
    }
    let _e840 = phi_1264_;
    if _e840 {
        phi_1268_ = _e834;
    } else {
        phi_1268_ = _e445;
    }
    let _e842 = phi_1268_;
    if ((bitcast<u32>(_e842) & 2147483647u) > 2139095040u) {
        phi_1285_ = _e842;
    } else {
        if (_e842 < 0f) {
            phi_1284_ = 0f;
        } else {
            if (_e842 > 1f) {
                phi_1283_ = 1f;
            } else {
                phi_1283_ = _e842;
            }
            let _e849 = phi_1283_;
            phi_1284_ = _e849;
        }
        let _e851 = phi_1284_;
        phi_1285_ = _e851;
    }
    let _e853 = phi_1285_;
    return _e853;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
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
    var phi_319_: bool;
    var phi_320_: bool;
    var phi_321_: bool;
    var phi_322_: bool;
    var phi_323_: bool;
    var phi_324_: bool;
    var phi_325_: bool;
    var phi_326_: bool;
    var phi_327_: bool;
    var phi_328_: bool;
    var phi_329_: bool;
    var phi_333_: bool;
    var phi_337_: bool;
    var phi_342_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_210_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_209_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_208_ = 1f;
            } else {
                phi_208_ = param_10;
            }
            let _e65 = phi_208_;
            phi_209_ = _e65;
        }
        let _e67 = phi_209_;
        phi_210_ = _e67;
    }
    let _e69 = phi_210_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_228_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_227_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_226_ = 1f;
            } else {
                phi_226_ = param_8.x;
            }
            let _e77 = phi_226_;
            phi_227_ = _e77;
        }
        let _e79 = phi_227_;
        phi_228_ = _e79;
    }
    let _e81 = phi_228_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_246_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_245_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_244_ = 1f;
            } else {
                phi_244_ = param_8.y;
            }
            let _e89 = phi_244_;
            phi_245_ = _e89;
        }
        let _e91 = phi_245_;
        phi_246_ = _e91;
    }
    let _e93 = phi_246_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_264_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_263_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_262_ = 1f;
            } else {
                phi_262_ = param_8.z;
            }
            let _e101 = phi_262_;
            phi_263_ = _e101;
        }
        let _e103 = phi_263_;
        phi_264_ = _e103;
    }
    let _e105 = phi_264_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_282_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_281_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_280_ = 1f;
            } else {
                phi_280_ = param_8.w;
            }
            let _e113 = phi_280_;
            phi_281_ = _e113;
        }
        let _e115 = phi_281_;
        phi_282_ = _e115;
    }
    let _e117 = phi_282_;
    let _e118 = (_e81 - _e69);
    let _e119 = (_e93 - _e69);
    let _e120 = (_e105 - _e69);
    let _e121 = (_e117 - _e69);
    if (_e118 >= 0f) {
        if (_e119 >= 0f) {
            if (_e120 >= 0f) {
                if (_e121 >= 0f) {
                    phi_319_ = !(((bitcast<u32>(((((_e118 * param_9.x) + (_e119 * param_9.y)) + (_e120 * param_9.z)) + (_e121 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_320_ = false;
                } else {
                    phi_319_ = bool();
                    phi_320_ = true;
                }
                let _e143 = phi_319_;
                let _e145 = phi_320_;
                phi_321_ = _e143;
                phi_322_ = false;
                phi_323_ = _e145;
            } else {
                phi_321_ = bool();
                phi_322_ = true;
                phi_323_ = false;
            }
            let _e147 = phi_321_;
            let _e149 = phi_322_;
            let _e151 = phi_323_;
            phi_324_ = _e147;
            phi_325_ = _e149;
            phi_326_ = _e151;
        } else {
            phi_324_ = bool();
            phi_325_ = true;
            phi_326_ = false;
        }
        let _e153 = phi_324_;
        let _e155 = phi_325_;
        let _e157 = phi_326_;
        phi_327_ = _e153;
        phi_328_ = _e155;
        phi_329_ = _e157;
    } else {
        phi_327_ = bool();
        phi_328_ = true;
        phi_329_ = false;
    }
    let _e159 = phi_327_;
    let _e161 = phi_328_;
    let _e163 = phi_329_;
    if _e161 {
        phi_333_ = true;
    } else {
        phi_333_ = _e163;
    }
    let _e165 = phi_333_;
    if _e165 {
        phi_337_ = false;
    } else {
        phi_337_ = _e159;
    }
    let _e167 = phi_337_;
    if _e167 {
        phi_342_ = 1f;
    } else {
        let _e168 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e118, _e119, _e120, _e121), param_9);
        phi_342_ = _e168;
    }
    let _e170 = phi_342_;
    return _e170;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_1336_: bool;
    var phi_1337_: bool;
    var phi_1338_: bool;
    var phi_1339_: bool;
    var phi_1343_: bool;
    var phi_1413_: bool;
    var phi_1414_: bool;
    var phi_1425_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1426_: bool;
    var phi_1427_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1428_: bool;
    var phi_1435_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1439_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1513_: bool;
    var phi_1522_: bool;
    var phi_1531_: bool;
    var phi_1532_: bool;
    var phi_1533_: bool;
    var phi_1534_: bool;
    var phi_1535_: bool;
    var phi_1536_: bool;
    var phi_1537_: bool;
    var phi_1541_: bool;
    var phi_1631_: f32;
    var phi_1634_: f32;
    var phi_1663_: f32;
    var phi_1668_: f32;
    var phi_1669_: bool;
    var phi_1670_: f32;
    var phi_1671_: bool;
    var phi_1675_: f32;
    var phi_1695_: f32;
    var phi_1700_: f32;
    var phi_1701_: bool;
    var phi_1702_: f32;
    var phi_1703_: bool;
    var phi_1707_: f32;
    var phi_1759_: i32;
    var phi_1764_: i32;
    var phi_1769_: i32;
    var phi_1774_: i32;
    var phi_1783_: i32;
    var phi_1788_: i32;
    var phi_1793_: i32;
    var phi_1798_: i32;
    var phi_1851_: bool;
    var phi_1859_: bool;
    var phi_1871_: bool;
    var phi_1872_: bool;
    var phi_1876_: f32;
    var phi_1882_: f32;
    var phi_1884_: evaluate_Verdict;
    var phi_1894_: u32;
    var phi_1903_: f32;
    var phi_1905_: evaluate_Verdict;
    var phi_1906_: bool;
    var phi_1907_: evaluate_Verdict;
    var phi_1908_: bool;
    var phi_1913_: evaluate_Verdict;
    var phi_1918_: evaluate_Verdict;
    var phi_1919_: evaluate_Verdict;
    var phi_1923_: bool;
    var phi_1924_: u32;
    var phi_1935_: u32;
    var phi_1952_: u32;

    let _e56 = id_1;
    let _e57 = local_2;
    let _e62 = arrayLength((&map.member));
    let _e67 = p.member.size[0u];
    let _e69 = p.member.size[1u];
    let _e70 = lt_shaders_entry_pixel_index(_e56, _e67, _e69);
    if (bitcast<i32>(_e70.root) != 0i) {
        let _e77 = p.member.projection;
        let _e78 = lt_math_OneLevel(_e77);
        let _e82 = samples.member[_e70.first_primitive].normal[0u];
        let _e84 = global[0u];
        if (_e82 == _e84) {
            let _e87 = samples.member[_e70.first_primitive].normal[1u];
            let _e89 = global[1u];
            if (_e87 == _e89) {
                let _e92 = samples.member[_e70.first_primitive].normal[2u];
                let _e94 = global[2u];
                phi_1336_ = (_e92 == _e94);
                phi_1337_ = false;
            } else {
                phi_1336_ = bool();
                phi_1337_ = true;
            }
            let _e97 = phi_1336_;
            let _e99 = phi_1337_;
            phi_1338_ = _e97;
            phi_1339_ = _e99;
        } else {
            phi_1338_ = bool();
            phi_1339_ = true;
        }
        let _e101 = phi_1338_;
        let _e103 = phi_1339_;
        if _e103 {
            phi_1343_ = false;
        } else {
            phi_1343_ = _e101;
        }
        let _e105 = phi_1343_;
        if !(_e105) {
            let _e108 = samples.member[_e70.first_primitive].position;
            let _e110 = p.member.light.place;
            let _e116 = p.member.light.place[3u];
            let _e123 = (_e110.x - (_e108.x * _e116));
            let _e124 = (_e110.y - (_e108.y * _e116));
            let _e125 = (_e110.z - (_e108.z * _e116));
            let _e127 = samples.member[_e70.first_primitive].normal;
            if ((((_e127.x * _e123) + (_e127.y * _e124)) + (_e127.z * _e125)) > 0f) {
                let _e141 = (((_e123 * _e123) + (_e124 * _e124)) + (_e125 * _e125));
                let _e143 = p.member.light.axis;
                let _e155 = p.member.light.place[3u];
                if (_e155 == 0f) {
                    phi_1414_ = true;
                } else {
                    let _e158 = p.member.light.range_squared;
                    if (_e141 <= _e158) {
                        let _e161 = p.member.light.cos_outer;
                        phi_1413_ = (-((((_e123 * _e143.x) + (_e124 * _e143.y)) + (_e125 * _e143.z))) >= (_e161 * sqrt(_e141)));
                    } else {
                        phi_1413_ = false;
                    }
                    let _e166 = phi_1413_;
                    phi_1414_ = _e166;
                }
                let _e168 = phi_1414_;
                if _e168 {
                    let _e170 = samples.member[_e70.first_primitive].flags;
                    let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e178.unnamed.visibility, false), _e178.unnamed_1);
                    phi_1425_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e184.unnamed, ((_e170 & 1u) == 0u));
                    phi_1426_ = false;
                } else {
                    phi_1425_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1426_ = true;
                }
                let _e189 = phi_1425_;
                let _e191 = phi_1426_;
                phi_1427_ = _e189;
                phi_1428_ = _e191;
            } else {
                phi_1427_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1428_ = true;
            }
            let _e193 = phi_1427_;
            let _e195 = phi_1428_;
            if _e195 {
                let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e201.unnamed.visibility, false), _e201.unnamed_1);
                phi_1435_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e207.unnamed, true);
            } else {
                phi_1435_ = _e193;
            }
            let _e212 = phi_1435_;
            phi_1439_ = _e212;
        } else {
            let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e224 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e218.unnamed.visibility, false), _e218.unnamed_1);
            phi_1439_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e224.unnamed, true);
        }
        let _e229 = phi_1439_;
        if _e229.unnamed_1 {
            phi_1919_ = evaluate_Verdict(_e229.unnamed.visibility, _e229.unnamed.is_doubted);
        } else {
            let _e237 = samples.member[_e70.first_primitive].position;
            let _e255 = ((((_e78.projection.row_w.x * _e237.x) + (_e78.projection.row_w.y * _e237.y)) + (_e78.projection.row_w.z * _e237.z)) + (_e78.projection.row_w.w * 1f));
            let _e269 = (((((_e78.projection.row_x.x * _e237.x) + (_e78.projection.row_x.y * _e237.y)) + (_e78.projection.row_x.z * _e237.z)) + (_e78.projection.row_x.w * 1f)) / _e255);
            let _e283 = (((((_e78.projection.row_y.x * _e237.x) + (_e78.projection.row_y.y * _e237.y)) + (_e78.projection.row_y.z * _e237.z)) + (_e78.projection.row_y.w * 1f)) / _e255);
            let _e296 = ((((_e78.projection.row_z.x * _e237.x) + (_e78.projection.row_z.y * _e237.y)) + (_e78.projection.row_z.z * _e237.z)) + (_e78.projection.row_z.w * 1f));
            if (_e255 > 0f) {
                if (_e269 >= 0f) {
                    phi_1513_ = (_e269 <= 1f);
                } else {
                    phi_1513_ = false;
                }
                let _e301 = phi_1513_;
                if _e301 {
                    if (_e283 >= 0f) {
                        phi_1522_ = (_e283 <= 1f);
                    } else {
                        phi_1522_ = false;
                    }
                    let _e305 = phi_1522_;
                    if _e305 {
                        if (_e296 >= 0f) {
                            phi_1531_ = (_e296 <= 1f);
                        } else {
                            phi_1531_ = false;
                        }
                        let _e309 = phi_1531_;
                        phi_1532_ = _e309;
                        phi_1533_ = false;
                    } else {
                        phi_1532_ = bool();
                        phi_1533_ = true;
                    }
                    let _e311 = phi_1532_;
                    let _e313 = phi_1533_;
                    phi_1534_ = _e311;
                    phi_1535_ = _e313;
                } else {
                    phi_1534_ = bool();
                    phi_1535_ = true;
                }
                let _e315 = phi_1534_;
                let _e317 = phi_1535_;
                phi_1536_ = _e315;
                phi_1537_ = _e317;
            } else {
                phi_1536_ = bool();
                phi_1537_ = true;
            }
            let _e319 = phi_1536_;
            let _e321 = phi_1537_;
            if _e321 {
                phi_1541_ = false;
            } else {
                phi_1541_ = _e319;
            }
            let _e323 = phi_1541_;
            if _e323 {
                if (0f > 0f) {
                    let _e326 = samples.member[_e70.first_primitive].normal;
                    let _e328 = p.member.map_size;
                    let _e398 = ((abs(((((_e77.row_x.x * _e326.x) + (_e77.row_x.y * _e326.y)) + (_e77.row_x.z * _e326.z)) / (((_e77.row_x.x * _e77.row_x.x) + (_e77.row_x.y * _e77.row_x.y)) + (_e77.row_x.z * _e77.row_x.z)))) + abs(((((_e77.row_y.x * _e326.x) + (_e77.row_y.y * _e326.y)) + (_e77.row_y.z * _e326.z)) / (((_e77.row_y.x * _e77.row_y.x) + (_e77.row_y.y * _e77.row_y.y)) + (_e77.row_y.z * _e77.row_y.z))))) / (abs(((((_e77.row_z.x * _e326.x) + (_e77.row_z.y * _e326.y)) + (_e77.row_z.z * _e326.z)) / (((_e77.row_z.x * _e77.row_z.x) + (_e77.row_z.y * _e77.row_z.y)) + (_e77.row_z.z * _e77.row_z.z)))) * f32(_e328)));
                    if (_e398 < 0.002f) {
                        phi_1631_ = _e398;
                    } else {
                        phi_1631_ = 0.002f;
                    }
                    let _e401 = phi_1631_;
                    phi_1634_ = (_e296 - (0f * _e401));
                } else {
                    phi_1634_ = _e296;
                }
                let _e405 = phi_1634_;
                let _e407 = p.member.map_size;
                let _e408 = f32(_e407);
                let _e411 = ((_e269 * _e408) - 0.5f);
                let _e412 = ((_e283 * _e408) - 0.5f);
                if (_e411 > -8388608f) {
                    let _e424 = f32(select(0i, select(select(i32(_e411), i32(-2147483648), (_e411 < bitcast<f32>(3472883712u))), 2147483647i, (_e411 > bitcast<f32>(1325400063u))), (_e411 == _e411)));
                    if (_e424 > _e411) {
                        phi_1663_ = 1f;
                    } else {
                        phi_1663_ = 0f;
                    }
                    let _e427 = phi_1663_;
                    if (_e411 < 8388608f) {
                        phi_1668_ = (_e424 - _e427);
                        phi_1669_ = false;
                    } else {
                        phi_1668_ = f32();
                        phi_1669_ = true;
                    }
                    let _e430 = phi_1668_;
                    let _e432 = phi_1669_;
                    phi_1670_ = _e430;
                    phi_1671_ = _e432;
                } else {
                    phi_1670_ = f32();
                    phi_1671_ = true;
                }
                let _e434 = phi_1670_;
                let _e436 = phi_1671_;
                if _e436 {
                    phi_1675_ = _e411;
                } else {
                    phi_1675_ = _e434;
                }
                let _e438 = phi_1675_;
                if (_e412 > -8388608f) {
                    let _e450 = f32(select(0i, select(select(i32(_e412), i32(-2147483648), (_e412 < bitcast<f32>(3472883712u))), 2147483647i, (_e412 > bitcast<f32>(1325400063u))), (_e412 == _e412)));
                    if (_e450 > _e412) {
                        phi_1695_ = 1f;
                    } else {
                        phi_1695_ = 0f;
                    }
                    let _e453 = phi_1695_;
                    if (_e412 < 8388608f) {
                        phi_1700_ = (_e450 - _e453);
                        phi_1701_ = false;
                    } else {
                        phi_1700_ = f32();
                        phi_1701_ = true;
                    }
                    let _e456 = phi_1700_;
                    let _e458 = phi_1701_;
                    phi_1702_ = _e456;
                    phi_1703_ = _e458;
                } else {
                    phi_1702_ = f32();
                    phi_1703_ = true;
                }
                let _e460 = phi_1702_;
                let _e462 = phi_1703_;
                if _e462 {
                    phi_1707_ = _e412;
                } else {
                    phi_1707_ = _e460;
                }
                let _e464 = phi_1707_;
                let _e465 = (_e411 - _e438);
                let _e466 = (_e412 - _e464);
                let _e475 = select(0i, select(select(i32(_e438), i32(-2147483648), (_e438 < bitcast<f32>(3472883712u))), 2147483647i, (_e438 > bitcast<f32>(1325400063u))), (_e438 == _e438));
                let _e484 = select(0i, select(select(i32(_e464), i32(-2147483648), (_e464 < bitcast<f32>(3472883712u))), 2147483647i, (_e464 > bitcast<f32>(1325400063u))), (_e464 == _e464));
                let _e495 = p.member.test;
                let _e496 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e495);
                let _e498 = p.member.map_size;
                local_1 = lt_math_Evsm(_e496.positive_exponent, _e496.negative_exponent, _e496.min_variance);
                let _e504 = ((0u * _e498) * _e498);
                let _e506 = (bitcast<i32>(_e498) - 1i);
                if (_e475 > 0i) {
                    phi_1759_ = _e475;
                } else {
                    phi_1759_ = 0i;
                }
                let _e509 = phi_1759_;
                if (_e484 > 0i) {
                    phi_1764_ = _e484;
                } else {
                    phi_1764_ = 0i;
                }
                let _e512 = phi_1764_;
                if (_e509 < _e506) {
                    phi_1769_ = _e509;
                } else {
                    phi_1769_ = _e506;
                }
                let _e515 = phi_1769_;
                if (_e512 < _e506) {
                    phi_1774_ = _e512;
                } else {
                    phi_1774_ = _e506;
                }
                let _e518 = phi_1774_;
                let _e519 = bitcast<u32>(_e515);
                let _e521 = (_e475 + 1i);
                let _e522 = (_e484 + 1i);
                if (_e521 > 0i) {
                    phi_1783_ = _e521;
                } else {
                    phi_1783_ = 0i;
                }
                let _e525 = phi_1783_;
                if (_e522 > 0i) {
                    phi_1788_ = _e522;
                } else {
                    phi_1788_ = 0i;
                }
                let _e528 = phi_1788_;
                if (_e525 < _e506) {
                    phi_1793_ = _e525;
                } else {
                    phi_1793_ = _e506;
                }
                let _e531 = phi_1793_;
                if (_e528 < _e506) {
                    phi_1798_ = _e528;
                } else {
                    phi_1798_ = _e506;
                }
                let _e534 = phi_1798_;
                let _e535 = bitcast<u32>(_e531);
                let _e537 = (bitcast<u32>(_e518) * _e498);
                let _e538 = (bitcast<u32>(_e534) * _e498);
                let _e543 = ((_e537 + _e519) + _e504);
                let _e544 = ((_e537 + _e535) + _e504);
                let _e545 = ((_e538 + _e519) + _e504);
                let _e546 = ((_e538 + _e535) + _e504);
                if (_e543 < _e62) {
                } else {
                    return;
                }
                let _e550 = map.member[(0u + _e543)];
                if (_e544 < _e62) {
                } else {
                    return;
                }
                let _e554 = map.member[(0u + _e544)];
                if (_e545 < _e62) {
                } else {
                    return;
                }
                let _e558 = map.member[(0u + _e545)];
                if (_e546 < _e62) {
                } else {
                    return;
                }
                let _e562 = map.member[(0u + _e546)];
                let _e564 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e550, _e554, _e558, _e562), vec4<f32>(((1f - _e465) * (1f - _e466)), (_e465 * (1f - _e466)), ((1f - _e465) * _e466), (_e465 * _e466)), _e405);
                let _e568 = p.member.epsilon;
                if (_e564 <= _e568) {
                    phi_1851_ = true;
                } else {
                    phi_1851_ = (_e564 >= (1f - _e568));
                }
                let _e573 = phi_1851_;
                if ((bitcast<u32>(_e564) & 2147483647u) > 2139095040u) {
                    phi_1859_ = true;
                } else {
                    phi_1859_ = !(_e573);
                }
                let _e579 = phi_1859_;
                if _e579 {
                    if (_e564 > 0f) {
                        if (_e564 < 1f) {
                            phi_1871_ = false;
                        } else {
                            phi_1871_ = true;
                        }
                        let _e583 = phi_1871_;
                        phi_1872_ = _e583;
                    } else {
                        phi_1872_ = true;
                    }
                    let _e585 = phi_1872_;
                    if _e585 {
                        phi_1876_ = 0.5f;
                    } else {
                        phi_1876_ = _e564;
                    }
                    let _e587 = phi_1876_;
                    phi_1884_ = evaluate_Verdict(_e587, true);
                } else {
                    if (_e564 > 0.5f) {
                        phi_1882_ = 1f;
                    } else {
                        phi_1882_ = 0f;
                    }
                    let _e591 = phi_1882_;
                    phi_1884_ = evaluate_Verdict(_e591, false);
                }
                let _e594 = phi_1884_;
                let _e597 = (_e594.visibility < 0.5f);
                if _e594.is_doubted {
                    phi_1907_ = evaluate_Verdict();
                    phi_1908_ = true;
                } else {
                    if _e597 {
                        phi_1894_ = 2u;
                    } else {
                        phi_1894_ = 1u;
                    }
                    let _e599 = phi_1894_;
                    if ((0u & _e599) != 0u) {
                        if _e597 {
                            phi_1903_ = 0.000000059604645f;
                        } else {
                            phi_1903_ = 0.99999994f;
                        }
                        let _e603 = phi_1903_;
                        phi_1905_ = evaluate_Verdict(_e603, true);
                        phi_1906_ = false;
                    } else {
                        phi_1905_ = evaluate_Verdict();
                        phi_1906_ = true;
                    }
                    let _e606 = phi_1905_;
                    let _e608 = phi_1906_;
                    phi_1907_ = _e606;
                    phi_1908_ = _e608;
                }
                let _e610 = phi_1907_;
                let _e612 = phi_1908_;
                if _e612 {
                    phi_1913_ = evaluate_Verdict(_e594.visibility, _e594.is_doubted);
                } else {
                    phi_1913_ = _e610;
                }
                let _e615 = phi_1913_;
                phi_1918_ = evaluate_Verdict(_e615.visibility, _e615.is_doubted);
            } else {
                phi_1918_ = evaluate_Verdict(0.5f, true);
            }
            let _e621 = phi_1918_;
            phi_1919_ = _e621;
        }
        let _e623 = phi_1919_;
        visibility.member[_e70.first_primitive] = _e623.visibility;
        phi_1923_ = _e623.is_doubted;
        phi_1924_ = _e70.first_primitive;
    } else {
        phi_1923_ = false;
        phi_1924_ = 0u;
    }
    let _e628 = phi_1923_;
    let _e630 = phi_1924_;
    if (_e57 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e628 {
        let _e634 = atomicAdd((&shared_[0u]), 1u);
        phi_1935_ = _e634;
    } else {
        phi_1935_ = 0u;
    }
    let _e636 = phi_1935_;
    workgroupBarrier();
    if (_e57 == 0u) {
        let _e640 = atomicLoad((&shared_[0u]));
        let _e641 = atomicAdd((&list.member[3u]), _e640);
        atomicStore((&shared_[1u]), _e641);
    }
    workgroupBarrier();
    if _e628 {
        if false {
            phi_1952_ = (_e630 | 2147483648u);
        } else {
            phi_1952_ = _e630;
        }
        let _e645 = phi_1952_;
        let _e647 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e647) + _e636)]), _e645);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
