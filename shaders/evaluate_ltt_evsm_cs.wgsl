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

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
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
    var phi_165_: lt_bvh_traverse_Tree;
    var phi_166_: bool;
    var phi_167_: lt_bvh_traverse_Tree;
    var phi_168_: bool;
    var phi_173_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_165_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_166_ = false;
        } else {
            phi_165_ = lt_bvh_traverse_Tree();
            phi_166_ = true;
        }
        let _e64 = phi_165_;
        let _e66 = phi_166_;
        phi_167_ = _e64;
        phi_168_ = _e66;
    } else {
        phi_167_ = lt_bvh_traverse_Tree();
        phi_168_ = true;
    }
    let _e68 = phi_167_;
    let _e70 = phi_168_;
    if _e70 {
        phi_173_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_173_ = _e68;
    }
    let _e75 = phi_173_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_353_: bool;
    var phi_357_: f32;
    var phi_376_: f32;
    var phi_381_: f32;
    var phi_403_: f32;
    var phi_408_: f32;
    var phi_409_: bool;
    var phi_410_: f32;
    var phi_411_: bool;
    var phi_415_: f32;
    var phi_453_: f32;
    var phi_464_: f32;
    var phi_469_: f32;
    var phi_491_: f32;
    var phi_496_: f32;
    var phi_497_: bool;
    var phi_498_: f32;
    var phi_499_: bool;
    var phi_503_: f32;
    var phi_541_: f32;
    var phi_552_: f32;
    var phi_557_: f32;
    var phi_579_: f32;
    var phi_584_: f32;
    var phi_585_: bool;
    var phi_586_: f32;
    var phi_587_: bool;
    var phi_591_: f32;
    var phi_629_: f32;
    var phi_640_: f32;
    var phi_645_: f32;
    var phi_667_: f32;
    var phi_672_: f32;
    var phi_673_: bool;
    var phi_674_: f32;
    var phi_675_: bool;
    var phi_679_: f32;
    var phi_717_: f32;
    var phi_770_: bool;
    var phi_774_: f32;
    var phi_786_: bool;
    var phi_793_: f32;
    var phi_806_: bool;
    var phi_810_: f32;
    var phi_830_: f32;
    var phi_835_: f32;
    var phi_857_: f32;
    var phi_862_: f32;
    var phi_863_: bool;
    var phi_864_: f32;
    var phi_865_: bool;
    var phi_869_: f32;
    var phi_907_: f32;
    var phi_918_: f32;
    var phi_923_: f32;
    var phi_945_: f32;
    var phi_950_: f32;
    var phi_951_: bool;
    var phi_952_: f32;
    var phi_953_: bool;
    var phi_957_: f32;
    var phi_995_: f32;
    var phi_1006_: f32;
    var phi_1011_: f32;
    var phi_1033_: f32;
    var phi_1038_: f32;
    var phi_1039_: bool;
    var phi_1040_: f32;
    var phi_1041_: bool;
    var phi_1045_: f32;
    var phi_1083_: f32;
    var phi_1094_: f32;
    var phi_1099_: f32;
    var phi_1121_: f32;
    var phi_1126_: f32;
    var phi_1127_: bool;
    var phi_1128_: f32;
    var phi_1129_: bool;
    var phi_1133_: f32;
    var phi_1171_: f32;
    var phi_1224_: bool;
    var phi_1228_: f32;
    var phi_1240_: bool;
    var phi_1247_: f32;
    var phi_1258_: bool;
    var phi_1262_: f32;
    var phi_1277_: f32;
    var phi_1278_: f32;
    var phi_1279_: f32;

    let _e55 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_353_ = true;
    } else {
        let _e59 = (42f < _e55);
        if _e59 {
        }
        phi_353_ = _e59;
    }
    let _e61 = phi_353_;
    if _e61 {
        phi_357_ = 42f;
    } else {
        phi_357_ = _e55;
    }
    let _e63 = phi_357_;
    let _e65 = (_e63 * param_5.x);
    let _e67 = (_e63 * param_5.y);
    let _e69 = (_e63 * param_5.z);
    let _e71 = (_e63 * param_5.w);
    if ((bitcast<u32>(_e65) & 2147483647u) > 2139095040u) {
        phi_453_ = _e65;
    } else {
        if (_e65 < -87f) {
            phi_376_ = -87f;
        } else {
            phi_376_ = _e65;
        }
        let _e77 = phi_376_;
        if (_e77 > 88f) {
            phi_381_ = 88f;
        } else {
            phi_381_ = _e77;
        }
        let _e80 = phi_381_;
        let _e82 = ((_e80 * 1.442695f) + 0.5f);
        if (_e82 > -8388608f) {
            let _e94 = f32(select(0i, select(select(i32(_e82), i32(-2147483648), (_e82 < bitcast<f32>(3472883712u))), 2147483647i, (_e82 > bitcast<f32>(1325400063u))), (_e82 == _e82)));
            if (_e94 > _e82) {
                phi_403_ = 1f;
            } else {
                phi_403_ = 0f;
            }
            let _e97 = phi_403_;
            if (_e82 < 8388608f) {
                phi_408_ = (_e94 - _e97);
                phi_409_ = false;
            } else {
                phi_408_ = f32();
                phi_409_ = true;
            }
            let _e100 = phi_408_;
            let _e102 = phi_409_;
            phi_410_ = _e100;
            phi_411_ = _e102;
        } else {
            phi_410_ = f32();
            phi_411_ = true;
        }
        let _e104 = phi_410_;
        let _e106 = phi_411_;
        if _e106 {
            phi_415_ = _e82;
        } else {
            phi_415_ = _e104;
        }
        let _e108 = phi_415_;
        let _e112 = ((_e80 - (_e108 * 0.69314575f)) - (_e108 * 0.0000014286068f));
        phi_453_ = ((((((((((((((((1f / 5040f) * _e112) + (1f / 720f)) * _e112) + (1f / 120f)) * _e112) + (1f / 24f)) * _e112) + (1f / 6f)) * _e112) + 0.5f) * _e112) + 1f) * _e112) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e108), i32(-2147483648), (_e108 < bitcast<f32>(3472883712u))), 2147483647i, (_e108 > bitcast<f32>(1325400063u))), (_e108 == _e108)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e148 = phi_453_;
    if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
        phi_541_ = _e67;
    } else {
        if (_e67 < -87f) {
            phi_464_ = -87f;
        } else {
            phi_464_ = _e67;
        }
        let _e154 = phi_464_;
        if (_e154 > 88f) {
            phi_469_ = 88f;
        } else {
            phi_469_ = _e154;
        }
        let _e157 = phi_469_;
        let _e159 = ((_e157 * 1.442695f) + 0.5f);
        if (_e159 > -8388608f) {
            let _e171 = f32(select(0i, select(select(i32(_e159), i32(-2147483648), (_e159 < bitcast<f32>(3472883712u))), 2147483647i, (_e159 > bitcast<f32>(1325400063u))), (_e159 == _e159)));
            if (_e171 > _e159) {
                phi_491_ = 1f;
            } else {
                phi_491_ = 0f;
            }
            let _e174 = phi_491_;
            if (_e159 < 8388608f) {
                phi_496_ = (_e171 - _e174);
                phi_497_ = false;
            } else {
                phi_496_ = f32();
                phi_497_ = true;
            }
            let _e177 = phi_496_;
            let _e179 = phi_497_;
            phi_498_ = _e177;
            phi_499_ = _e179;
        } else {
            phi_498_ = f32();
            phi_499_ = true;
        }
        let _e181 = phi_498_;
        let _e183 = phi_499_;
        if _e183 {
            phi_503_ = _e159;
        } else {
            phi_503_ = _e181;
        }
        let _e185 = phi_503_;
        let _e189 = ((_e157 - (_e185 * 0.69314575f)) - (_e185 * 0.0000014286068f));
        phi_541_ = ((((((((((((((((1f / 5040f) * _e189) + (1f / 720f)) * _e189) + (1f / 120f)) * _e189) + (1f / 24f)) * _e189) + (1f / 6f)) * _e189) + 0.5f) * _e189) + 1f) * _e189) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e185), i32(-2147483648), (_e185 < bitcast<f32>(3472883712u))), 2147483647i, (_e185 > bitcast<f32>(1325400063u))), (_e185 == _e185)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e225 = phi_541_;
    if ((bitcast<u32>(_e69) & 2147483647u) > 2139095040u) {
        phi_629_ = _e69;
    } else {
        if (_e69 < -87f) {
            phi_552_ = -87f;
        } else {
            phi_552_ = _e69;
        }
        let _e231 = phi_552_;
        if (_e231 > 88f) {
            phi_557_ = 88f;
        } else {
            phi_557_ = _e231;
        }
        let _e234 = phi_557_;
        let _e236 = ((_e234 * 1.442695f) + 0.5f);
        if (_e236 > -8388608f) {
            let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
            if (_e248 > _e236) {
                phi_579_ = 1f;
            } else {
                phi_579_ = 0f;
            }
            let _e251 = phi_579_;
            if (_e236 < 8388608f) {
                phi_584_ = (_e248 - _e251);
                phi_585_ = false;
            } else {
                phi_584_ = f32();
                phi_585_ = true;
            }
            let _e254 = phi_584_;
            let _e256 = phi_585_;
            phi_586_ = _e254;
            phi_587_ = _e256;
        } else {
            phi_586_ = f32();
            phi_587_ = true;
        }
        let _e258 = phi_586_;
        let _e260 = phi_587_;
        if _e260 {
            phi_591_ = _e236;
        } else {
            phi_591_ = _e258;
        }
        let _e262 = phi_591_;
        let _e266 = ((_e234 - (_e262 * 0.69314575f)) - (_e262 * 0.0000014286068f));
        phi_629_ = ((((((((((((((((1f / 5040f) * _e266) + (1f / 720f)) * _e266) + (1f / 120f)) * _e266) + (1f / 24f)) * _e266) + (1f / 6f)) * _e266) + 0.5f) * _e266) + 1f) * _e266) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e262), i32(-2147483648), (_e262 < bitcast<f32>(3472883712u))), 2147483647i, (_e262 > bitcast<f32>(1325400063u))), (_e262 == _e262)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e302 = phi_629_;
    if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
        phi_717_ = _e71;
    } else {
        if (_e71 < -87f) {
            phi_640_ = -87f;
        } else {
            phi_640_ = _e71;
        }
        let _e308 = phi_640_;
        if (_e308 > 88f) {
            phi_645_ = 88f;
        } else {
            phi_645_ = _e308;
        }
        let _e311 = phi_645_;
        let _e313 = ((_e311 * 1.442695f) + 0.5f);
        if (_e313 > -8388608f) {
            let _e325 = f32(select(0i, select(select(i32(_e313), i32(-2147483648), (_e313 < bitcast<f32>(3472883712u))), 2147483647i, (_e313 > bitcast<f32>(1325400063u))), (_e313 == _e313)));
            if (_e325 > _e313) {
                phi_667_ = 1f;
            } else {
                phi_667_ = 0f;
            }
            let _e328 = phi_667_;
            if (_e313 < 8388608f) {
                phi_672_ = (_e325 - _e328);
                phi_673_ = false;
            } else {
                phi_672_ = f32();
                phi_673_ = true;
            }
            let _e331 = phi_672_;
            let _e333 = phi_673_;
            phi_674_ = _e331;
            phi_675_ = _e333;
        } else {
            phi_674_ = f32();
            phi_675_ = true;
        }
        let _e335 = phi_674_;
        let _e337 = phi_675_;
        if _e337 {
            phi_679_ = _e313;
        } else {
            phi_679_ = _e335;
        }
        let _e339 = phi_679_;
        let _e343 = ((_e311 - (_e339 * 0.69314575f)) - (_e339 * 0.0000014286068f));
        phi_717_ = ((((((((((((((((1f / 5040f) * _e343) + (1f / 720f)) * _e343) + (1f / 120f)) * _e343) + (1f / 24f)) * _e343) + (1f / 6f)) * _e343) + 0.5f) * _e343) + 1f) * _e343) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e339), i32(-2147483648), (_e339 < bitcast<f32>(3472883712u))), 2147483647i, (_e339 > bitcast<f32>(1325400063u))), (_e339 == _e339)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e379 = phi_717_;
    let _e381 = (_e148 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e383 = (_e225 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e385 = (_e302 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e387 = (_e379 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e389 = (*param_4).min_variance;
    let _e391 = ((_e389 * _e63) * _e63);
    let _e402 = ((((_e381 * param_6.x) + (_e383 * param_6.y)) + (_e385 * param_6.z)) + (_e387 * param_6.w));
    let _e403 = (_e381 - _e402);
    let _e404 = (_e383 - _e402);
    let _e405 = (_e385 - _e402);
    let _e406 = (_e387 - _e402);
    let _e421 = (((((_e403 * _e403) * param_6.x) + ((_e404 * _e404) * param_6.y)) + ((_e405 * _e405) * param_6.z)) + ((_e406 * _e406) * param_6.w));
    if ((bitcast<u32>(_e391) & 2147483647u) > 2139095040u) {
        phi_770_ = true;
    } else {
        let _e425 = (_e391 > _e421);
        if _e425 {
        }
        phi_770_ = _e425;
    }
    let _e427 = phi_770_;
    if _e427 {
        phi_774_ = _e391;
    } else {
        phi_774_ = _e421;
    }
    let _e429 = phi_774_;
    let _e430 = -(_e402);
    if (_e430 <= 0f) {
        let _e434 = ((bitcast<u32>(_e429) & 2147483647u) > 2139095040u);
        if _e434 {
        }
        phi_786_ = _e434;
    } else {
        phi_786_ = true;
    }
    let _e436 = phi_786_;
    if _e436 {
        phi_793_ = (_e429 / (_e429 + (_e430 * _e430)));
    } else {
        phi_793_ = 1f;
    }
    let _e441 = phi_793_;
    let _e443 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_806_ = true;
    } else {
        let _e447 = (42f < _e443);
        if _e447 {
        }
        phi_806_ = _e447;
    }
    let _e449 = phi_806_;
    if _e449 {
        phi_810_ = 42f;
    } else {
        phi_810_ = _e443;
    }
    let _e451 = phi_810_;
    let _e452 = -(_e451);
    let _e454 = (_e452 * param_5.x);
    let _e456 = (_e452 * param_5.y);
    let _e458 = (_e452 * param_5.z);
    let _e460 = (_e452 * param_5.w);
    if ((bitcast<u32>(_e454) & 2147483647u) > 2139095040u) {
        phi_907_ = _e454;
    } else {
        if (_e454 < -87f) {
            phi_830_ = -87f;
        } else {
            phi_830_ = _e454;
        }
        let _e466 = phi_830_;
        if (_e466 > 88f) {
            phi_835_ = 88f;
        } else {
            phi_835_ = _e466;
        }
        let _e469 = phi_835_;
        let _e471 = ((_e469 * 1.442695f) + 0.5f);
        if (_e471 > -8388608f) {
            let _e483 = f32(select(0i, select(select(i32(_e471), i32(-2147483648), (_e471 < bitcast<f32>(3472883712u))), 2147483647i, (_e471 > bitcast<f32>(1325400063u))), (_e471 == _e471)));
            if (_e483 > _e471) {
                phi_857_ = 1f;
            } else {
                phi_857_ = 0f;
            }
            let _e486 = phi_857_;
            if (_e471 < 8388608f) {
                phi_862_ = (_e483 - _e486);
                phi_863_ = false;
            } else {
                phi_862_ = f32();
                phi_863_ = true;
            }
            let _e489 = phi_862_;
            let _e491 = phi_863_;
            phi_864_ = _e489;
            phi_865_ = _e491;
        } else {
            phi_864_ = f32();
            phi_865_ = true;
        }
        let _e493 = phi_864_;
        let _e495 = phi_865_;
        if _e495 {
            phi_869_ = _e471;
        } else {
            phi_869_ = _e493;
        }
        let _e497 = phi_869_;
        let _e501 = ((_e469 - (_e497 * 0.69314575f)) - (_e497 * 0.0000014286068f));
        phi_907_ = ((((((((((((((((1f / 5040f) * _e501) + (1f / 720f)) * _e501) + (1f / 120f)) * _e501) + (1f / 24f)) * _e501) + (1f / 6f)) * _e501) + 0.5f) * _e501) + 1f) * _e501) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e497), i32(-2147483648), (_e497 < bitcast<f32>(3472883712u))), 2147483647i, (_e497 > bitcast<f32>(1325400063u))), (_e497 == _e497)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e537 = phi_907_;
    if ((bitcast<u32>(_e456) & 2147483647u) > 2139095040u) {
        phi_995_ = _e456;
    } else {
        if (_e456 < -87f) {
            phi_918_ = -87f;
        } else {
            phi_918_ = _e456;
        }
        let _e543 = phi_918_;
        if (_e543 > 88f) {
            phi_923_ = 88f;
        } else {
            phi_923_ = _e543;
        }
        let _e546 = phi_923_;
        let _e548 = ((_e546 * 1.442695f) + 0.5f);
        if (_e548 > -8388608f) {
            let _e560 = f32(select(0i, select(select(i32(_e548), i32(-2147483648), (_e548 < bitcast<f32>(3472883712u))), 2147483647i, (_e548 > bitcast<f32>(1325400063u))), (_e548 == _e548)));
            if (_e560 > _e548) {
                phi_945_ = 1f;
            } else {
                phi_945_ = 0f;
            }
            let _e563 = phi_945_;
            if (_e548 < 8388608f) {
                phi_950_ = (_e560 - _e563);
                phi_951_ = false;
            } else {
                phi_950_ = f32();
                phi_951_ = true;
            }
            let _e566 = phi_950_;
            let _e568 = phi_951_;
            phi_952_ = _e566;
            phi_953_ = _e568;
        } else {
            phi_952_ = f32();
            phi_953_ = true;
        }
        let _e570 = phi_952_;
        let _e572 = phi_953_;
        if _e572 {
            phi_957_ = _e548;
        } else {
            phi_957_ = _e570;
        }
        let _e574 = phi_957_;
        let _e578 = ((_e546 - (_e574 * 0.69314575f)) - (_e574 * 0.0000014286068f));
        phi_995_ = ((((((((((((((((1f / 5040f) * _e578) + (1f / 720f)) * _e578) + (1f / 120f)) * _e578) + (1f / 24f)) * _e578) + (1f / 6f)) * _e578) + 0.5f) * _e578) + 1f) * _e578) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e574), i32(-2147483648), (_e574 < bitcast<f32>(3472883712u))), 2147483647i, (_e574 > bitcast<f32>(1325400063u))), (_e574 == _e574)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e614 = phi_995_;
    if ((bitcast<u32>(_e458) & 2147483647u) > 2139095040u) {
        phi_1083_ = _e458;
    } else {
        if (_e458 < -87f) {
            phi_1006_ = -87f;
        } else {
            phi_1006_ = _e458;
        }
        let _e620 = phi_1006_;
        if (_e620 > 88f) {
            phi_1011_ = 88f;
        } else {
            phi_1011_ = _e620;
        }
        let _e623 = phi_1011_;
        let _e625 = ((_e623 * 1.442695f) + 0.5f);
        if (_e625 > -8388608f) {
            let _e637 = f32(select(0i, select(select(i32(_e625), i32(-2147483648), (_e625 < bitcast<f32>(3472883712u))), 2147483647i, (_e625 > bitcast<f32>(1325400063u))), (_e625 == _e625)));
            if (_e637 > _e625) {
                phi_1033_ = 1f;
            } else {
                phi_1033_ = 0f;
            }
            let _e640 = phi_1033_;
            if (_e625 < 8388608f) {
                phi_1038_ = (_e637 - _e640);
                phi_1039_ = false;
            } else {
                phi_1038_ = f32();
                phi_1039_ = true;
            }
            let _e643 = phi_1038_;
            let _e645 = phi_1039_;
            phi_1040_ = _e643;
            phi_1041_ = _e645;
        } else {
            phi_1040_ = f32();
            phi_1041_ = true;
        }
        let _e647 = phi_1040_;
        let _e649 = phi_1041_;
        if _e649 {
            phi_1045_ = _e625;
        } else {
            phi_1045_ = _e647;
        }
        let _e651 = phi_1045_;
        let _e655 = ((_e623 - (_e651 * 0.69314575f)) - (_e651 * 0.0000014286068f));
        phi_1083_ = ((((((((((((((((1f / 5040f) * _e655) + (1f / 720f)) * _e655) + (1f / 120f)) * _e655) + (1f / 24f)) * _e655) + (1f / 6f)) * _e655) + 0.5f) * _e655) + 1f) * _e655) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e651), i32(-2147483648), (_e651 < bitcast<f32>(3472883712u))), 2147483647i, (_e651 > bitcast<f32>(1325400063u))), (_e651 == _e651)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e691 = phi_1083_;
    if ((bitcast<u32>(_e460) & 2147483647u) > 2139095040u) {
        phi_1171_ = _e460;
    } else {
        if (_e460 < -87f) {
            phi_1094_ = -87f;
        } else {
            phi_1094_ = _e460;
        }
        let _e697 = phi_1094_;
        if (_e697 > 88f) {
            phi_1099_ = 88f;
        } else {
            phi_1099_ = _e697;
        }
        let _e700 = phi_1099_;
        let _e702 = ((_e700 * 1.442695f) + 0.5f);
        if (_e702 > -8388608f) {
            let _e714 = f32(select(0i, select(select(i32(_e702), i32(-2147483648), (_e702 < bitcast<f32>(3472883712u))), 2147483647i, (_e702 > bitcast<f32>(1325400063u))), (_e702 == _e702)));
            if (_e714 > _e702) {
                phi_1121_ = 1f;
            } else {
                phi_1121_ = 0f;
            }
            let _e717 = phi_1121_;
            if (_e702 < 8388608f) {
                phi_1126_ = (_e714 - _e717);
                phi_1127_ = false;
            } else {
                phi_1126_ = f32();
                phi_1127_ = true;
            }
            let _e720 = phi_1126_;
            let _e722 = phi_1127_;
            phi_1128_ = _e720;
            phi_1129_ = _e722;
        } else {
            phi_1128_ = f32();
            phi_1129_ = true;
        }
        let _e724 = phi_1128_;
        let _e726 = phi_1129_;
        if _e726 {
            phi_1133_ = _e702;
        } else {
            phi_1133_ = _e724;
        }
        let _e728 = phi_1133_;
        let _e732 = ((_e700 - (_e728 * 0.69314575f)) - (_e728 * 0.0000014286068f));
        phi_1171_ = ((((((((((((((((1f / 5040f) * _e732) + (1f / 720f)) * _e732) + (1f / 120f)) * _e732) + (1f / 24f)) * _e732) + (1f / 6f)) * _e732) + 0.5f) * _e732) + 1f) * _e732) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e728), i32(-2147483648), (_e728 < bitcast<f32>(3472883712u))), 2147483647i, (_e728 > bitcast<f32>(1325400063u))), (_e728 == _e728)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e768 = phi_1171_;
    let _e770 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e537);
    let _e772 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e614);
    let _e774 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e691);
    let _e776 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e768);
    let _e778 = (*param_4).min_variance;
    let _e780 = ((_e778 * _e451) * _e451);
    let _e791 = ((((_e770 * param_6.x) + (_e772 * param_6.y)) + (_e774 * param_6.z)) + (_e776 * param_6.w));
    let _e792 = (_e770 - _e791);
    let _e793 = (_e772 - _e791);
    let _e794 = (_e774 - _e791);
    let _e795 = (_e776 - _e791);
    let _e810 = (((((_e792 * _e792) * param_6.x) + ((_e793 * _e793) * param_6.y)) + ((_e794 * _e794) * param_6.z)) + ((_e795 * _e795) * param_6.w));
    if ((bitcast<u32>(_e780) & 2147483647u) > 2139095040u) {
        phi_1224_ = true;
    } else {
        let _e814 = (_e780 > _e810);
        if _e814 {
        }
        phi_1224_ = _e814;
    }
    let _e816 = phi_1224_;
    if _e816 {
        phi_1228_ = _e780;
    } else {
        phi_1228_ = _e810;
    }
    let _e818 = phi_1228_;
    let _e819 = -(_e791);
    if (_e819 <= 0f) {
        let _e823 = ((bitcast<u32>(_e818) & 2147483647u) > 2139095040u);
        if _e823 {
        }
        phi_1240_ = _e823;
    } else {
        phi_1240_ = true;
    }
    let _e825 = phi_1240_;
    if _e825 {
        phi_1247_ = (_e818 / (_e818 + (_e819 * _e819)));
    } else {
        phi_1247_ = 1f;
    }
    let _e830 = phi_1247_;
    if ((bitcast<u32>(_e830) & 2147483647u) > 2139095040u) {
        phi_1258_ = true;
    } else {
        let _e834 = (_e830 < _e441);
        if _e834 {
        }
        phi_1258_ = _e834;
    }
    let _e836 = phi_1258_;
    if _e836 {
        phi_1262_ = _e830;
    } else {
        phi_1262_ = _e441;
    }
    let _e838 = phi_1262_;
    if ((bitcast<u32>(_e838) & 2147483647u) > 2139095040u) {
        phi_1279_ = _e838;
    } else {
        if (_e838 < 0f) {
            phi_1278_ = 0f;
        } else {
            if (_e838 > 1f) {
                phi_1277_ = 1f;
            } else {
                phi_1277_ = _e838;
            }
            let _e845 = phi_1277_;
            phi_1278_ = _e845;
        }
        let _e847 = phi_1278_;
        phi_1279_ = _e847;
    }
    let _e849 = phi_1279_;
    return _e849;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_202_: f32;
    var phi_203_: f32;
    var phi_204_: f32;
    var phi_220_: f32;
    var phi_221_: f32;
    var phi_222_: f32;
    var phi_238_: f32;
    var phi_239_: f32;
    var phi_240_: f32;
    var phi_256_: f32;
    var phi_257_: f32;
    var phi_258_: f32;
    var phi_274_: f32;
    var phi_275_: f32;
    var phi_276_: f32;
    var phi_313_: bool;
    var phi_314_: bool;
    var phi_315_: bool;
    var phi_316_: bool;
    var phi_317_: bool;
    var phi_318_: bool;
    var phi_319_: bool;
    var phi_320_: bool;
    var phi_321_: bool;
    var phi_322_: bool;
    var phi_323_: bool;
    var phi_327_: bool;
    var phi_331_: bool;
    var phi_336_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_204_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_203_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_202_ = 1f;
            } else {
                phi_202_ = param_10;
            }
            let _e61 = phi_202_;
            phi_203_ = _e61;
        }
        let _e63 = phi_203_;
        phi_204_ = _e63;
    }
    let _e65 = phi_204_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_222_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_221_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_220_ = 1f;
            } else {
                phi_220_ = param_8.x;
            }
            let _e73 = phi_220_;
            phi_221_ = _e73;
        }
        let _e75 = phi_221_;
        phi_222_ = _e75;
    }
    let _e77 = phi_222_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_240_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_239_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_238_ = 1f;
            } else {
                phi_238_ = param_8.y;
            }
            let _e85 = phi_238_;
            phi_239_ = _e85;
        }
        let _e87 = phi_239_;
        phi_240_ = _e87;
    }
    let _e89 = phi_240_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_258_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_257_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_256_ = 1f;
            } else {
                phi_256_ = param_8.z;
            }
            let _e97 = phi_256_;
            phi_257_ = _e97;
        }
        let _e99 = phi_257_;
        phi_258_ = _e99;
    }
    let _e101 = phi_258_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_276_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_275_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_274_ = 1f;
            } else {
                phi_274_ = param_8.w;
            }
            let _e109 = phi_274_;
            phi_275_ = _e109;
        }
        let _e111 = phi_275_;
        phi_276_ = _e111;
    }
    let _e113 = phi_276_;
    let _e114 = (_e77 - _e65);
    let _e115 = (_e89 - _e65);
    let _e116 = (_e101 - _e65);
    let _e117 = (_e113 - _e65);
    if (_e114 >= 0f) {
        if (_e115 >= 0f) {
            if (_e116 >= 0f) {
                if (_e117 >= 0f) {
                    phi_313_ = !(((bitcast<u32>(((((_e114 * param_9.x) + (_e115 * param_9.y)) + (_e116 * param_9.z)) + (_e117 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_314_ = false;
                } else {
                    phi_313_ = bool();
                    phi_314_ = true;
                }
                let _e139 = phi_313_;
                let _e141 = phi_314_;
                phi_315_ = _e139;
                phi_316_ = false;
                phi_317_ = _e141;
            } else {
                phi_315_ = bool();
                phi_316_ = true;
                phi_317_ = false;
            }
            let _e143 = phi_315_;
            let _e145 = phi_316_;
            let _e147 = phi_317_;
            phi_318_ = _e143;
            phi_319_ = _e145;
            phi_320_ = _e147;
        } else {
            phi_318_ = bool();
            phi_319_ = true;
            phi_320_ = false;
        }
        let _e149 = phi_318_;
        let _e151 = phi_319_;
        let _e153 = phi_320_;
        phi_321_ = _e149;
        phi_322_ = _e151;
        phi_323_ = _e153;
    } else {
        phi_321_ = bool();
        phi_322_ = true;
        phi_323_ = false;
    }
    let _e155 = phi_321_;
    let _e157 = phi_322_;
    let _e159 = phi_323_;
    if _e157 {
        phi_327_ = true;
    } else {
        phi_327_ = _e159;
    }
    let _e161 = phi_327_;
    if _e161 {
        phi_331_ = false;
    } else {
        phi_331_ = _e155;
    }
    let _e163 = phi_331_;
    if _e163 {
        phi_336_ = 1f;
    } else {
        let _e164 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e114, _e115, _e116, _e117), param_9);
        phi_336_ = _e164;
    }
    let _e166 = phi_336_;
    return _e166;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_1330_: bool;
    var phi_1331_: bool;
    var phi_1332_: bool;
    var phi_1333_: bool;
    var phi_1337_: bool;
    var phi_1407_: bool;
    var phi_1408_: bool;
    var phi_1419_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1420_: bool;
    var phi_1421_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1422_: bool;
    var phi_1429_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1433_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1507_: bool;
    var phi_1516_: bool;
    var phi_1525_: bool;
    var phi_1526_: bool;
    var phi_1527_: bool;
    var phi_1528_: bool;
    var phi_1529_: bool;
    var phi_1530_: bool;
    var phi_1531_: bool;
    var phi_1535_: bool;
    var phi_1625_: f32;
    var phi_1628_: f32;
    var phi_1657_: f32;
    var phi_1662_: f32;
    var phi_1663_: bool;
    var phi_1664_: f32;
    var phi_1665_: bool;
    var phi_1669_: f32;
    var phi_1689_: f32;
    var phi_1694_: f32;
    var phi_1695_: bool;
    var phi_1696_: f32;
    var phi_1697_: bool;
    var phi_1701_: f32;
    var phi_1753_: i32;
    var phi_1758_: i32;
    var phi_1763_: i32;
    var phi_1768_: i32;
    var phi_1777_: i32;
    var phi_1782_: i32;
    var phi_1787_: i32;
    var phi_1792_: i32;
    var phi_1843_: bool;
    var phi_1851_: bool;
    var phi_1863_: bool;
    var phi_1864_: bool;
    var phi_1868_: f32;
    var phi_1874_: f32;
    var phi_1876_: evaluate_Verdict;
    var phi_1881_: evaluate_Verdict;
    var phi_1882_: evaluate_Verdict;
    var phi_1886_: bool;
    var phi_1887_: u32;
    var phi_1898_: u32;

    let _e52 = id_1;
    let _e53 = local_2;
    let _e58 = arrayLength((&map.member));
    let _e63 = p.member.size[0u];
    let _e65 = p.member.size[1u];
    let _e66 = lt_shaders_entry_pixel_index(_e52, _e63, _e65);
    if (bitcast<i32>(_e66.root) != 0i) {
        let _e73 = p.member.projection;
        let _e74 = lt_math_OneLevel(_e73);
        let _e78 = samples.member[_e66.first_primitive].normal[0u];
        let _e80 = global[0u];
        if (_e78 == _e80) {
            let _e83 = samples.member[_e66.first_primitive].normal[1u];
            let _e85 = global[1u];
            if (_e83 == _e85) {
                let _e88 = samples.member[_e66.first_primitive].normal[2u];
                let _e90 = global[2u];
                phi_1330_ = (_e88 == _e90);
                phi_1331_ = false;
            } else {
                phi_1330_ = bool();
                phi_1331_ = true;
            }
            let _e93 = phi_1330_;
            let _e95 = phi_1331_;
            phi_1332_ = _e93;
            phi_1333_ = _e95;
        } else {
            phi_1332_ = bool();
            phi_1333_ = true;
        }
        let _e97 = phi_1332_;
        let _e99 = phi_1333_;
        if _e99 {
            phi_1337_ = false;
        } else {
            phi_1337_ = _e97;
        }
        let _e101 = phi_1337_;
        if !(_e101) {
            let _e104 = samples.member[_e66.first_primitive].position;
            let _e106 = p.member.light.place;
            let _e112 = p.member.light.place[3u];
            let _e119 = (_e106.x - (_e104.x * _e112));
            let _e120 = (_e106.y - (_e104.y * _e112));
            let _e121 = (_e106.z - (_e104.z * _e112));
            let _e123 = samples.member[_e66.first_primitive].normal;
            if ((((_e123.x * _e119) + (_e123.y * _e120)) + (_e123.z * _e121)) > 0f) {
                let _e137 = (((_e119 * _e119) + (_e120 * _e120)) + (_e121 * _e121));
                let _e139 = p.member.light.axis;
                let _e151 = p.member.light.place[3u];
                if (_e151 == 0f) {
                    phi_1408_ = true;
                } else {
                    let _e154 = p.member.light.range_squared;
                    if (_e137 <= _e154) {
                        let _e157 = p.member.light.cos_outer;
                        phi_1407_ = (-((((_e119 * _e139.x) + (_e120 * _e139.y)) + (_e121 * _e139.z))) >= (_e157 * sqrt(_e137)));
                    } else {
                        phi_1407_ = false;
                    }
                    let _e162 = phi_1407_;
                    phi_1408_ = _e162;
                }
                let _e164 = phi_1408_;
                if _e164 {
                    let _e166 = samples.member[_e66.first_primitive].flags;
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e180 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e174.unnamed.visibility, false), _e174.unnamed_1);
                    phi_1419_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e180.unnamed, ((_e166 & 1u) == 0u));
                    phi_1420_ = false;
                } else {
                    phi_1419_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1420_ = true;
                }
                let _e185 = phi_1419_;
                let _e187 = phi_1420_;
                phi_1421_ = _e185;
                phi_1422_ = _e187;
            } else {
                phi_1421_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1422_ = true;
            }
            let _e189 = phi_1421_;
            let _e191 = phi_1422_;
            if _e191 {
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e197.unnamed.visibility, false), _e197.unnamed_1);
                phi_1429_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e203.unnamed, true);
            } else {
                phi_1429_ = _e189;
            }
            let _e208 = phi_1429_;
            phi_1433_ = _e208;
        } else {
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e214.unnamed.visibility, false), _e214.unnamed_1);
            phi_1433_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e220.unnamed, true);
        }
        let _e225 = phi_1433_;
        if _e225.unnamed_1 {
            phi_1882_ = evaluate_Verdict(_e225.unnamed.visibility, _e225.unnamed.is_doubted);
        } else {
            let _e233 = samples.member[_e66.first_primitive].position;
            let _e251 = ((((_e74.projection.row_w.x * _e233.x) + (_e74.projection.row_w.y * _e233.y)) + (_e74.projection.row_w.z * _e233.z)) + (_e74.projection.row_w.w * 1f));
            let _e265 = (((((_e74.projection.row_x.x * _e233.x) + (_e74.projection.row_x.y * _e233.y)) + (_e74.projection.row_x.z * _e233.z)) + (_e74.projection.row_x.w * 1f)) / _e251);
            let _e279 = (((((_e74.projection.row_y.x * _e233.x) + (_e74.projection.row_y.y * _e233.y)) + (_e74.projection.row_y.z * _e233.z)) + (_e74.projection.row_y.w * 1f)) / _e251);
            let _e292 = ((((_e74.projection.row_z.x * _e233.x) + (_e74.projection.row_z.y * _e233.y)) + (_e74.projection.row_z.z * _e233.z)) + (_e74.projection.row_z.w * 1f));
            if (_e251 > 0f) {
                if (_e265 >= 0f) {
                    phi_1507_ = (_e265 <= 1f);
                } else {
                    phi_1507_ = false;
                }
                let _e297 = phi_1507_;
                if _e297 {
                    if (_e279 >= 0f) {
                        phi_1516_ = (_e279 <= 1f);
                    } else {
                        phi_1516_ = false;
                    }
                    let _e301 = phi_1516_;
                    if _e301 {
                        if (_e292 >= 0f) {
                            phi_1525_ = (_e292 <= 1f);
                        } else {
                            phi_1525_ = false;
                        }
                        let _e305 = phi_1525_;
                        phi_1526_ = _e305;
                        phi_1527_ = false;
                    } else {
                        phi_1526_ = bool();
                        phi_1527_ = true;
                    }
                    let _e307 = phi_1526_;
                    let _e309 = phi_1527_;
                    phi_1528_ = _e307;
                    phi_1529_ = _e309;
                } else {
                    phi_1528_ = bool();
                    phi_1529_ = true;
                }
                let _e311 = phi_1528_;
                let _e313 = phi_1529_;
                phi_1530_ = _e311;
                phi_1531_ = _e313;
            } else {
                phi_1530_ = bool();
                phi_1531_ = true;
            }
            let _e315 = phi_1530_;
            let _e317 = phi_1531_;
            if _e317 {
                phi_1535_ = false;
            } else {
                phi_1535_ = _e315;
            }
            let _e319 = phi_1535_;
            if _e319 {
                if (0f > 0f) {
                    let _e322 = samples.member[_e66.first_primitive].normal;
                    let _e324 = p.member.map_size;
                    let _e394 = ((abs(((((_e73.row_x.x * _e322.x) + (_e73.row_x.y * _e322.y)) + (_e73.row_x.z * _e322.z)) / (((_e73.row_x.x * _e73.row_x.x) + (_e73.row_x.y * _e73.row_x.y)) + (_e73.row_x.z * _e73.row_x.z)))) + abs(((((_e73.row_y.x * _e322.x) + (_e73.row_y.y * _e322.y)) + (_e73.row_y.z * _e322.z)) / (((_e73.row_y.x * _e73.row_y.x) + (_e73.row_y.y * _e73.row_y.y)) + (_e73.row_y.z * _e73.row_y.z))))) / (abs(((((_e73.row_z.x * _e322.x) + (_e73.row_z.y * _e322.y)) + (_e73.row_z.z * _e322.z)) / (((_e73.row_z.x * _e73.row_z.x) + (_e73.row_z.y * _e73.row_z.y)) + (_e73.row_z.z * _e73.row_z.z)))) * f32(_e324)));
                    if (_e394 < 0.002f) {
                        phi_1625_ = _e394;
                    } else {
                        phi_1625_ = 0.002f;
                    }
                    let _e397 = phi_1625_;
                    phi_1628_ = (_e292 - (0f * _e397));
                } else {
                    phi_1628_ = _e292;
                }
                let _e401 = phi_1628_;
                let _e403 = p.member.map_size;
                let _e404 = f32(_e403);
                let _e407 = ((_e265 * _e404) - 0.5f);
                let _e408 = ((_e279 * _e404) - 0.5f);
                if (_e407 > -8388608f) {
                    let _e420 = f32(select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < bitcast<f32>(3472883712u))), 2147483647i, (_e407 > bitcast<f32>(1325400063u))), (_e407 == _e407)));
                    if (_e420 > _e407) {
                        phi_1657_ = 1f;
                    } else {
                        phi_1657_ = 0f;
                    }
                    let _e423 = phi_1657_;
                    if (_e407 < 8388608f) {
                        phi_1662_ = (_e420 - _e423);
                        phi_1663_ = false;
                    } else {
                        phi_1662_ = f32();
                        phi_1663_ = true;
                    }
                    let _e426 = phi_1662_;
                    let _e428 = phi_1663_;
                    phi_1664_ = _e426;
                    phi_1665_ = _e428;
                } else {
                    phi_1664_ = f32();
                    phi_1665_ = true;
                }
                let _e430 = phi_1664_;
                let _e432 = phi_1665_;
                if _e432 {
                    phi_1669_ = _e407;
                } else {
                    phi_1669_ = _e430;
                }
                let _e434 = phi_1669_;
                if (_e408 > -8388608f) {
                    let _e446 = f32(select(0i, select(select(i32(_e408), i32(-2147483648), (_e408 < bitcast<f32>(3472883712u))), 2147483647i, (_e408 > bitcast<f32>(1325400063u))), (_e408 == _e408)));
                    if (_e446 > _e408) {
                        phi_1689_ = 1f;
                    } else {
                        phi_1689_ = 0f;
                    }
                    let _e449 = phi_1689_;
                    if (_e408 < 8388608f) {
                        phi_1694_ = (_e446 - _e449);
                        phi_1695_ = false;
                    } else {
                        phi_1694_ = f32();
                        phi_1695_ = true;
                    }
                    let _e452 = phi_1694_;
                    let _e454 = phi_1695_;
                    phi_1696_ = _e452;
                    phi_1697_ = _e454;
                } else {
                    phi_1696_ = f32();
                    phi_1697_ = true;
                }
                let _e456 = phi_1696_;
                let _e458 = phi_1697_;
                if _e458 {
                    phi_1701_ = _e408;
                } else {
                    phi_1701_ = _e456;
                }
                let _e460 = phi_1701_;
                let _e461 = (_e407 - _e434);
                let _e462 = (_e408 - _e460);
                let _e471 = select(0i, select(select(i32(_e434), i32(-2147483648), (_e434 < bitcast<f32>(3472883712u))), 2147483647i, (_e434 > bitcast<f32>(1325400063u))), (_e434 == _e434));
                let _e480 = select(0i, select(select(i32(_e460), i32(-2147483648), (_e460 < bitcast<f32>(3472883712u))), 2147483647i, (_e460 > bitcast<f32>(1325400063u))), (_e460 == _e460));
                let _e491 = p.member.test;
                let _e492 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e491);
                let _e494 = p.member.map_size;
                local_1 = lt_math_Evsm(_e492.positive_exponent, _e492.negative_exponent, _e492.min_variance);
                let _e500 = ((0u * _e494) * _e494);
                let _e502 = (bitcast<i32>(_e494) - 1i);
                if (_e471 > 0i) {
                    phi_1753_ = _e471;
                } else {
                    phi_1753_ = 0i;
                }
                let _e505 = phi_1753_;
                if (_e480 > 0i) {
                    phi_1758_ = _e480;
                } else {
                    phi_1758_ = 0i;
                }
                let _e508 = phi_1758_;
                if (_e505 < _e502) {
                    phi_1763_ = _e505;
                } else {
                    phi_1763_ = _e502;
                }
                let _e511 = phi_1763_;
                if (_e508 < _e502) {
                    phi_1768_ = _e508;
                } else {
                    phi_1768_ = _e502;
                }
                let _e514 = phi_1768_;
                let _e515 = bitcast<u32>(_e511);
                let _e517 = (_e471 + 1i);
                let _e518 = (_e480 + 1i);
                if (_e517 > 0i) {
                    phi_1777_ = _e517;
                } else {
                    phi_1777_ = 0i;
                }
                let _e521 = phi_1777_;
                if (_e518 > 0i) {
                    phi_1782_ = _e518;
                } else {
                    phi_1782_ = 0i;
                }
                let _e524 = phi_1782_;
                if (_e521 < _e502) {
                    phi_1787_ = _e521;
                } else {
                    phi_1787_ = _e502;
                }
                let _e527 = phi_1787_;
                if (_e524 < _e502) {
                    phi_1792_ = _e524;
                } else {
                    phi_1792_ = _e502;
                }
                let _e530 = phi_1792_;
                let _e531 = bitcast<u32>(_e527);
                let _e533 = (bitcast<u32>(_e514) * _e494);
                let _e534 = (bitcast<u32>(_e530) * _e494);
                let _e539 = ((_e533 + _e515) + _e500);
                let _e540 = ((_e533 + _e531) + _e500);
                let _e541 = ((_e534 + _e515) + _e500);
                let _e542 = ((_e534 + _e531) + _e500);
                if (_e539 < _e58) {
                } else {
                    return;
                }
                let _e546 = map.member[(0u + _e539)];
                if (_e540 < _e58) {
                } else {
                    return;
                }
                let _e550 = map.member[(0u + _e540)];
                if (_e541 < _e58) {
                } else {
                    return;
                }
                let _e554 = map.member[(0u + _e541)];
                if (_e542 < _e58) {
                } else {
                    return;
                }
                let _e558 = map.member[(0u + _e542)];
                let _e560 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e546, _e550, _e554, _e558), vec4<f32>(((1f - _e461) * (1f - _e462)), (_e461 * (1f - _e462)), ((1f - _e461) * _e462), (_e461 * _e462)), _e401);
                let _e562 = p.member.epsilon;
                if (_e560 <= _e562) {
                    phi_1843_ = true;
                } else {
                    phi_1843_ = (_e560 >= (1f - _e562));
                }
                let _e567 = phi_1843_;
                if ((bitcast<u32>(_e560) & 2147483647u) > 2139095040u) {
                    phi_1851_ = true;
                } else {
                    phi_1851_ = !(_e567);
                }
                let _e573 = phi_1851_;
                if _e573 {
                    if (_e560 > 0f) {
                        if (_e560 < 1f) {
                            phi_1863_ = false;
                        } else {
                            phi_1863_ = true;
                        }
                        let _e577 = phi_1863_;
                        phi_1864_ = _e577;
                    } else {
                        phi_1864_ = true;
                    }
                    let _e579 = phi_1864_;
                    if _e579 {
                        phi_1868_ = 0.5f;
                    } else {
                        phi_1868_ = _e560;
                    }
                    let _e581 = phi_1868_;
                    phi_1876_ = evaluate_Verdict(_e581, true);
                } else {
                    if (_e560 > 0.5f) {
                        phi_1874_ = 1f;
                    } else {
                        phi_1874_ = 0f;
                    }
                    let _e585 = phi_1874_;
                    phi_1876_ = evaluate_Verdict(_e585, false);
                }
                let _e588 = phi_1876_;
                phi_1881_ = evaluate_Verdict(_e588.visibility, _e588.is_doubted);
            } else {
                phi_1881_ = evaluate_Verdict(0.5f, true);
            }
            let _e594 = phi_1881_;
            phi_1882_ = _e594;
        }
        let _e596 = phi_1882_;
        visibility.member[_e66.first_primitive] = _e596.visibility;
        phi_1886_ = _e596.is_doubted;
        phi_1887_ = _e66.first_primitive;
    } else {
        phi_1886_ = false;
        phi_1887_ = 0u;
    }
    let _e601 = phi_1886_;
    let _e603 = phi_1887_;
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e601 {
        let _e607 = atomicAdd((&shared_[0u]), 1u);
        phi_1898_ = _e607;
    } else {
        phi_1898_ = 0u;
    }
    let _e609 = phi_1898_;
    workgroupBarrier();
    if (_e53 == 0u) {
        let _e613 = atomicLoad((&shared_[0u]));
        let _e614 = atomicAdd((&list.member[3u]), _e613);
        atomicStore((&shared_[1u]), _e614);
    }
    workgroupBarrier();
    if _e601 {
        let _e617 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e617) + _e609)]), _e603);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
