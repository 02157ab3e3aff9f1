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

struct type_9 {
    member: array<abi_Sample>,
}

struct type_13 {
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

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
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
    fade_uv: f32,
    pad0_: u32,
}

struct type_33 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_38 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_33;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_38;

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
        let _e66 = phi_164_;
        let _e68 = phi_165_;
        phi_166_ = _e66;
        phi_167_ = _e68;
    } else {
        phi_166_ = lt_bvh_traverse_Tree();
        phi_167_ = true;
    }
    let _e70 = phi_166_;
    let _e72 = phi_167_;
    if _e72 {
        phi_172_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_172_ = _e70;
    }
    let _e77 = phi_172_;
    return lt_bvh_traverse_Tree(_e77.root, _e77.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_352_: bool;
    var phi_356_: f32;
    var phi_375_: f32;
    var phi_380_: f32;
    var phi_402_: f32;
    var phi_407_: f32;
    var phi_408_: bool;
    var phi_409_: f32;
    var phi_410_: bool;
    var phi_414_: f32;
    var phi_452_: f32;
    var phi_463_: f32;
    var phi_468_: f32;
    var phi_490_: f32;
    var phi_495_: f32;
    var phi_496_: bool;
    var phi_497_: f32;
    var phi_498_: bool;
    var phi_502_: f32;
    var phi_540_: f32;
    var phi_551_: f32;
    var phi_556_: f32;
    var phi_578_: f32;
    var phi_583_: f32;
    var phi_584_: bool;
    var phi_585_: f32;
    var phi_586_: bool;
    var phi_590_: f32;
    var phi_628_: f32;
    var phi_639_: f32;
    var phi_644_: f32;
    var phi_666_: f32;
    var phi_671_: f32;
    var phi_672_: bool;
    var phi_673_: f32;
    var phi_674_: bool;
    var phi_678_: f32;
    var phi_716_: f32;
    var phi_769_: bool;
    var phi_773_: f32;
    var phi_785_: bool;
    var phi_792_: f32;
    var phi_805_: bool;
    var phi_809_: f32;
    var phi_829_: f32;
    var phi_834_: f32;
    var phi_856_: f32;
    var phi_861_: f32;
    var phi_862_: bool;
    var phi_863_: f32;
    var phi_864_: bool;
    var phi_868_: f32;
    var phi_906_: f32;
    var phi_917_: f32;
    var phi_922_: f32;
    var phi_944_: f32;
    var phi_949_: f32;
    var phi_950_: bool;
    var phi_951_: f32;
    var phi_952_: bool;
    var phi_956_: f32;
    var phi_994_: f32;
    var phi_1005_: f32;
    var phi_1010_: f32;
    var phi_1032_: f32;
    var phi_1037_: f32;
    var phi_1038_: bool;
    var phi_1039_: f32;
    var phi_1040_: bool;
    var phi_1044_: f32;
    var phi_1082_: f32;
    var phi_1093_: f32;
    var phi_1098_: f32;
    var phi_1120_: f32;
    var phi_1125_: f32;
    var phi_1126_: bool;
    var phi_1127_: f32;
    var phi_1128_: bool;
    var phi_1132_: f32;
    var phi_1170_: f32;
    var phi_1223_: bool;
    var phi_1227_: f32;
    var phi_1239_: bool;
    var phi_1246_: f32;
    var phi_1257_: bool;
    var phi_1261_: f32;
    var phi_1276_: f32;
    var phi_1277_: f32;
    var phi_1278_: f32;

    let _e57 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_352_ = true;
    } else {
        let _e61 = (42f < _e57);
        if _e61 {
        }
        phi_352_ = _e61;
    }
    let _e63 = phi_352_;
    if _e63 {
        phi_356_ = 42f;
    } else {
        phi_356_ = _e57;
    }
    let _e65 = phi_356_;
    let _e67 = (_e65 * param_5.x);
    let _e69 = (_e65 * param_5.y);
    let _e71 = (_e65 * param_5.z);
    let _e73 = (_e65 * param_5.w);
    if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
        phi_452_ = _e67;
    } else {
        if (_e67 < -87f) {
            phi_375_ = -87f;
        } else {
            phi_375_ = _e67;
        }
        let _e79 = phi_375_;
        if (_e79 > 88f) {
            phi_380_ = 88f;
        } else {
            phi_380_ = _e79;
        }
        let _e82 = phi_380_;
        let _e84 = ((_e82 * 1.442695f) + 0.5f);
        if (_e84 > -8388608f) {
            let _e96 = f32(select(0i, select(select(i32(_e84), i32(-2147483648), (_e84 < bitcast<f32>(3472883712u))), 2147483647i, (_e84 > bitcast<f32>(1325400063u))), (_e84 == _e84)));
            if (_e96 > _e84) {
                phi_402_ = 1f;
            } else {
                phi_402_ = 0f;
            }
            let _e99 = phi_402_;
            if (_e84 < 8388608f) {
                phi_407_ = (_e96 - _e99);
                phi_408_ = false;
            } else {
                phi_407_ = f32();
                phi_408_ = true;
            }
            let _e102 = phi_407_;
            let _e104 = phi_408_;
            phi_409_ = _e102;
            phi_410_ = _e104;
        } else {
            phi_409_ = f32();
            phi_410_ = true;
        }
        let _e106 = phi_409_;
        let _e108 = phi_410_;
        if _e108 {
            phi_414_ = _e84;
        } else {
            phi_414_ = _e106;
        }
        let _e110 = phi_414_;
        let _e114 = ((_e82 - (_e110 * 0.69314575f)) - (_e110 * 0.0000014286068f));
        phi_452_ = ((((((((((((((((1f / 5040f) * _e114) + (1f / 720f)) * _e114) + (1f / 120f)) * _e114) + (1f / 24f)) * _e114) + (1f / 6f)) * _e114) + 0.5f) * _e114) + 1f) * _e114) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e110), i32(-2147483648), (_e110 < bitcast<f32>(3472883712u))), 2147483647i, (_e110 > bitcast<f32>(1325400063u))), (_e110 == _e110)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e150 = phi_452_;
    if ((bitcast<u32>(_e69) & 2147483647u) > 2139095040u) {
        phi_540_ = _e69;
    } else {
        if (_e69 < -87f) {
            phi_463_ = -87f;
        } else {
            phi_463_ = _e69;
        }
        let _e156 = phi_463_;
        if (_e156 > 88f) {
            phi_468_ = 88f;
        } else {
            phi_468_ = _e156;
        }
        let _e159 = phi_468_;
        let _e161 = ((_e159 * 1.442695f) + 0.5f);
        if (_e161 > -8388608f) {
            let _e173 = f32(select(0i, select(select(i32(_e161), i32(-2147483648), (_e161 < bitcast<f32>(3472883712u))), 2147483647i, (_e161 > bitcast<f32>(1325400063u))), (_e161 == _e161)));
            if (_e173 > _e161) {
                phi_490_ = 1f;
            } else {
                phi_490_ = 0f;
            }
            let _e176 = phi_490_;
            if (_e161 < 8388608f) {
                phi_495_ = (_e173 - _e176);
                phi_496_ = false;
            } else {
                phi_495_ = f32();
                phi_496_ = true;
            }
            let _e179 = phi_495_;
            let _e181 = phi_496_;
            phi_497_ = _e179;
            phi_498_ = _e181;
        } else {
            phi_497_ = f32();
            phi_498_ = true;
        }
        let _e183 = phi_497_;
        let _e185 = phi_498_;
        if _e185 {
            phi_502_ = _e161;
        } else {
            phi_502_ = _e183;
        }
        let _e187 = phi_502_;
        let _e191 = ((_e159 - (_e187 * 0.69314575f)) - (_e187 * 0.0000014286068f));
        phi_540_ = ((((((((((((((((1f / 5040f) * _e191) + (1f / 720f)) * _e191) + (1f / 120f)) * _e191) + (1f / 24f)) * _e191) + (1f / 6f)) * _e191) + 0.5f) * _e191) + 1f) * _e191) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e187), i32(-2147483648), (_e187 < bitcast<f32>(3472883712u))), 2147483647i, (_e187 > bitcast<f32>(1325400063u))), (_e187 == _e187)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e227 = phi_540_;
    if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
        phi_628_ = _e71;
    } else {
        if (_e71 < -87f) {
            phi_551_ = -87f;
        } else {
            phi_551_ = _e71;
        }
        let _e233 = phi_551_;
        if (_e233 > 88f) {
            phi_556_ = 88f;
        } else {
            phi_556_ = _e233;
        }
        let _e236 = phi_556_;
        let _e238 = ((_e236 * 1.442695f) + 0.5f);
        if (_e238 > -8388608f) {
            let _e250 = f32(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < bitcast<f32>(3472883712u))), 2147483647i, (_e238 > bitcast<f32>(1325400063u))), (_e238 == _e238)));
            if (_e250 > _e238) {
                phi_578_ = 1f;
            } else {
                phi_578_ = 0f;
            }
            let _e253 = phi_578_;
            if (_e238 < 8388608f) {
                phi_583_ = (_e250 - _e253);
                phi_584_ = false;
            } else {
                phi_583_ = f32();
                phi_584_ = true;
            }
            let _e256 = phi_583_;
            let _e258 = phi_584_;
            phi_585_ = _e256;
            phi_586_ = _e258;
        } else {
            phi_585_ = f32();
            phi_586_ = true;
        }
        let _e260 = phi_585_;
        let _e262 = phi_586_;
        if _e262 {
            phi_590_ = _e238;
        } else {
            phi_590_ = _e260;
        }
        let _e264 = phi_590_;
        let _e268 = ((_e236 - (_e264 * 0.69314575f)) - (_e264 * 0.0000014286068f));
        phi_628_ = ((((((((((((((((1f / 5040f) * _e268) + (1f / 720f)) * _e268) + (1f / 120f)) * _e268) + (1f / 24f)) * _e268) + (1f / 6f)) * _e268) + 0.5f) * _e268) + 1f) * _e268) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e264), i32(-2147483648), (_e264 < bitcast<f32>(3472883712u))), 2147483647i, (_e264 > bitcast<f32>(1325400063u))), (_e264 == _e264)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e304 = phi_628_;
    if ((bitcast<u32>(_e73) & 2147483647u) > 2139095040u) {
        phi_716_ = _e73;
    } else {
        if (_e73 < -87f) {
            phi_639_ = -87f;
        } else {
            phi_639_ = _e73;
        }
        let _e310 = phi_639_;
        if (_e310 > 88f) {
            phi_644_ = 88f;
        } else {
            phi_644_ = _e310;
        }
        let _e313 = phi_644_;
        let _e315 = ((_e313 * 1.442695f) + 0.5f);
        if (_e315 > -8388608f) {
            let _e327 = f32(select(0i, select(select(i32(_e315), i32(-2147483648), (_e315 < bitcast<f32>(3472883712u))), 2147483647i, (_e315 > bitcast<f32>(1325400063u))), (_e315 == _e315)));
            if (_e327 > _e315) {
                phi_666_ = 1f;
            } else {
                phi_666_ = 0f;
            }
            let _e330 = phi_666_;
            if (_e315 < 8388608f) {
                phi_671_ = (_e327 - _e330);
                phi_672_ = false;
            } else {
                phi_671_ = f32();
                phi_672_ = true;
            }
            let _e333 = phi_671_;
            let _e335 = phi_672_;
            phi_673_ = _e333;
            phi_674_ = _e335;
        } else {
            phi_673_ = f32();
            phi_674_ = true;
        }
        let _e337 = phi_673_;
        let _e339 = phi_674_;
        if _e339 {
            phi_678_ = _e315;
        } else {
            phi_678_ = _e337;
        }
        let _e341 = phi_678_;
        let _e345 = ((_e313 - (_e341 * 0.69314575f)) - (_e341 * 0.0000014286068f));
        phi_716_ = ((((((((((((((((1f / 5040f) * _e345) + (1f / 720f)) * _e345) + (1f / 120f)) * _e345) + (1f / 24f)) * _e345) + (1f / 6f)) * _e345) + 0.5f) * _e345) + 1f) * _e345) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e341), i32(-2147483648), (_e341 < bitcast<f32>(3472883712u))), 2147483647i, (_e341 > bitcast<f32>(1325400063u))), (_e341 == _e341)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e381 = phi_716_;
    let _e383 = (_e150 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e385 = (_e227 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e387 = (_e304 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e389 = (_e381 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e391 = (*param_4).min_variance;
    let _e393 = ((_e391 * _e65) * _e65);
    let _e404 = ((((_e383 * param_6.x) + (_e385 * param_6.y)) + (_e387 * param_6.z)) + (_e389 * param_6.w));
    let _e405 = (_e383 - _e404);
    let _e406 = (_e385 - _e404);
    let _e407 = (_e387 - _e404);
    let _e408 = (_e389 - _e404);
    let _e423 = (((((_e405 * _e405) * param_6.x) + ((_e406 * _e406) * param_6.y)) + ((_e407 * _e407) * param_6.z)) + ((_e408 * _e408) * param_6.w));
    if ((bitcast<u32>(_e393) & 2147483647u) > 2139095040u) {
        phi_769_ = true;
    } else {
        let _e427 = (_e393 > _e423);
        if _e427 {
        }
        phi_769_ = _e427;
    }
    let _e429 = phi_769_;
    if _e429 {
        phi_773_ = _e393;
    } else {
        phi_773_ = _e423;
    }
    let _e431 = phi_773_;
    let _e432 = -(_e404);
    if (_e432 <= 0f) {
        let _e436 = ((bitcast<u32>(_e431) & 2147483647u) > 2139095040u);
        if _e436 {
        }
        phi_785_ = _e436;
    } else {
        phi_785_ = true;
    }
    let _e438 = phi_785_;
    if _e438 {
        phi_792_ = (_e431 / (_e431 + (_e432 * _e432)));
    } else {
        phi_792_ = 1f;
    }
    let _e443 = phi_792_;
    let _e445 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_805_ = true;
    } else {
        let _e449 = (42f < _e445);
        if _e449 {
        }
        phi_805_ = _e449;
    }
    let _e451 = phi_805_;
    if _e451 {
        phi_809_ = 42f;
    } else {
        phi_809_ = _e445;
    }
    let _e453 = phi_809_;
    let _e454 = -(_e453);
    let _e456 = (_e454 * param_5.x);
    let _e458 = (_e454 * param_5.y);
    let _e460 = (_e454 * param_5.z);
    let _e462 = (_e454 * param_5.w);
    if ((bitcast<u32>(_e456) & 2147483647u) > 2139095040u) {
        phi_906_ = _e456;
    } else {
        if (_e456 < -87f) {
            phi_829_ = -87f;
        } else {
            phi_829_ = _e456;
        }
        let _e468 = phi_829_;
        if (_e468 > 88f) {
            phi_834_ = 88f;
        } else {
            phi_834_ = _e468;
        }
        let _e471 = phi_834_;
        let _e473 = ((_e471 * 1.442695f) + 0.5f);
        if (_e473 > -8388608f) {
            let _e485 = f32(select(0i, select(select(i32(_e473), i32(-2147483648), (_e473 < bitcast<f32>(3472883712u))), 2147483647i, (_e473 > bitcast<f32>(1325400063u))), (_e473 == _e473)));
            if (_e485 > _e473) {
                phi_856_ = 1f;
            } else {
                phi_856_ = 0f;
            }
            let _e488 = phi_856_;
            if (_e473 < 8388608f) {
                phi_861_ = (_e485 - _e488);
                phi_862_ = false;
            } else {
                phi_861_ = f32();
                phi_862_ = true;
            }
            let _e491 = phi_861_;
            let _e493 = phi_862_;
            phi_863_ = _e491;
            phi_864_ = _e493;
        } else {
            phi_863_ = f32();
            phi_864_ = true;
        }
        let _e495 = phi_863_;
        let _e497 = phi_864_;
        if _e497 {
            phi_868_ = _e473;
        } else {
            phi_868_ = _e495;
        }
        let _e499 = phi_868_;
        let _e503 = ((_e471 - (_e499 * 0.69314575f)) - (_e499 * 0.0000014286068f));
        phi_906_ = ((((((((((((((((1f / 5040f) * _e503) + (1f / 720f)) * _e503) + (1f / 120f)) * _e503) + (1f / 24f)) * _e503) + (1f / 6f)) * _e503) + 0.5f) * _e503) + 1f) * _e503) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e499), i32(-2147483648), (_e499 < bitcast<f32>(3472883712u))), 2147483647i, (_e499 > bitcast<f32>(1325400063u))), (_e499 == _e499)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e539 = phi_906_;
    if ((bitcast<u32>(_e458) & 2147483647u) > 2139095040u) {
        phi_994_ = _e458;
    } else {
        if (_e458 < -87f) {
            phi_917_ = -87f;
        } else {
            phi_917_ = _e458;
        }
        let _e545 = phi_917_;
        if (_e545 > 88f) {
            phi_922_ = 88f;
        } else {
            phi_922_ = _e545;
        }
        let _e548 = phi_922_;
        let _e550 = ((_e548 * 1.442695f) + 0.5f);
        if (_e550 > -8388608f) {
            let _e562 = f32(select(0i, select(select(i32(_e550), i32(-2147483648), (_e550 < bitcast<f32>(3472883712u))), 2147483647i, (_e550 > bitcast<f32>(1325400063u))), (_e550 == _e550)));
            if (_e562 > _e550) {
                phi_944_ = 1f;
            } else {
                phi_944_ = 0f;
            }
            let _e565 = phi_944_;
            if (_e550 < 8388608f) {
                phi_949_ = (_e562 - _e565);
                phi_950_ = false;
            } else {
                phi_949_ = f32();
                phi_950_ = true;
            }
            let _e568 = phi_949_;
            let _e570 = phi_950_;
            phi_951_ = _e568;
            phi_952_ = _e570;
        } else {
            phi_951_ = f32();
            phi_952_ = true;
        }
        let _e572 = phi_951_;
        let _e574 = phi_952_;
        if _e574 {
            phi_956_ = _e550;
        } else {
            phi_956_ = _e572;
        }
        let _e576 = phi_956_;
        let _e580 = ((_e548 - (_e576 * 0.69314575f)) - (_e576 * 0.0000014286068f));
        phi_994_ = ((((((((((((((((1f / 5040f) * _e580) + (1f / 720f)) * _e580) + (1f / 120f)) * _e580) + (1f / 24f)) * _e580) + (1f / 6f)) * _e580) + 0.5f) * _e580) + 1f) * _e580) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e576), i32(-2147483648), (_e576 < bitcast<f32>(3472883712u))), 2147483647i, (_e576 > bitcast<f32>(1325400063u))), (_e576 == _e576)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e616 = phi_994_;
    if ((bitcast<u32>(_e460) & 2147483647u) > 2139095040u) {
        phi_1082_ = _e460;
    } else {
        if (_e460 < -87f) {
            phi_1005_ = -87f;
        } else {
            phi_1005_ = _e460;
        }
        let _e622 = phi_1005_;
        if (_e622 > 88f) {
            phi_1010_ = 88f;
        } else {
            phi_1010_ = _e622;
        }
        let _e625 = phi_1010_;
        let _e627 = ((_e625 * 1.442695f) + 0.5f);
        if (_e627 > -8388608f) {
            let _e639 = f32(select(0i, select(select(i32(_e627), i32(-2147483648), (_e627 < bitcast<f32>(3472883712u))), 2147483647i, (_e627 > bitcast<f32>(1325400063u))), (_e627 == _e627)));
            if (_e639 > _e627) {
                phi_1032_ = 1f;
            } else {
                phi_1032_ = 0f;
            }
            let _e642 = phi_1032_;
            if (_e627 < 8388608f) {
                phi_1037_ = (_e639 - _e642);
                phi_1038_ = false;
            } else {
                phi_1037_ = f32();
                phi_1038_ = true;
            }
            let _e645 = phi_1037_;
            let _e647 = phi_1038_;
            phi_1039_ = _e645;
            phi_1040_ = _e647;
        } else {
            phi_1039_ = f32();
            phi_1040_ = true;
        }
        let _e649 = phi_1039_;
        let _e651 = phi_1040_;
        if _e651 {
            phi_1044_ = _e627;
        } else {
            phi_1044_ = _e649;
        }
        let _e653 = phi_1044_;
        let _e657 = ((_e625 - (_e653 * 0.69314575f)) - (_e653 * 0.0000014286068f));
        phi_1082_ = ((((((((((((((((1f / 5040f) * _e657) + (1f / 720f)) * _e657) + (1f / 120f)) * _e657) + (1f / 24f)) * _e657) + (1f / 6f)) * _e657) + 0.5f) * _e657) + 1f) * _e657) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e653), i32(-2147483648), (_e653 < bitcast<f32>(3472883712u))), 2147483647i, (_e653 > bitcast<f32>(1325400063u))), (_e653 == _e653)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e693 = phi_1082_;
    if ((bitcast<u32>(_e462) & 2147483647u) > 2139095040u) {
        phi_1170_ = _e462;
    } else {
        if (_e462 < -87f) {
            phi_1093_ = -87f;
        } else {
            phi_1093_ = _e462;
        }
        let _e699 = phi_1093_;
        if (_e699 > 88f) {
            phi_1098_ = 88f;
        } else {
            phi_1098_ = _e699;
        }
        let _e702 = phi_1098_;
        let _e704 = ((_e702 * 1.442695f) + 0.5f);
        if (_e704 > -8388608f) {
            let _e716 = f32(select(0i, select(select(i32(_e704), i32(-2147483648), (_e704 < bitcast<f32>(3472883712u))), 2147483647i, (_e704 > bitcast<f32>(1325400063u))), (_e704 == _e704)));
            if (_e716 > _e704) {
                phi_1120_ = 1f;
            } else {
                phi_1120_ = 0f;
            }
            let _e719 = phi_1120_;
            if (_e704 < 8388608f) {
                phi_1125_ = (_e716 - _e719);
                phi_1126_ = false;
            } else {
                phi_1125_ = f32();
                phi_1126_ = true;
            }
            let _e722 = phi_1125_;
            let _e724 = phi_1126_;
            phi_1127_ = _e722;
            phi_1128_ = _e724;
        } else {
            phi_1127_ = f32();
            phi_1128_ = true;
        }
        let _e726 = phi_1127_;
        let _e728 = phi_1128_;
        if _e728 {
            phi_1132_ = _e704;
        } else {
            phi_1132_ = _e726;
        }
        let _e730 = phi_1132_;
        let _e734 = ((_e702 - (_e730 * 0.69314575f)) - (_e730 * 0.0000014286068f));
        phi_1170_ = ((((((((((((((((1f / 5040f) * _e734) + (1f / 720f)) * _e734) + (1f / 120f)) * _e734) + (1f / 24f)) * _e734) + (1f / 6f)) * _e734) + 0.5f) * _e734) + 1f) * _e734) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e730), i32(-2147483648), (_e730 < bitcast<f32>(3472883712u))), 2147483647i, (_e730 > bitcast<f32>(1325400063u))), (_e730 == _e730)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e770 = phi_1170_;
    let _e772 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e539);
    let _e774 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e616);
    let _e776 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e693);
    let _e778 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e770);
    let _e780 = (*param_4).min_variance;
    let _e782 = ((_e780 * _e453) * _e453);
    let _e793 = ((((_e772 * param_6.x) + (_e774 * param_6.y)) + (_e776 * param_6.z)) + (_e778 * param_6.w));
    let _e794 = (_e772 - _e793);
    let _e795 = (_e774 - _e793);
    let _e796 = (_e776 - _e793);
    let _e797 = (_e778 - _e793);
    let _e812 = (((((_e794 * _e794) * param_6.x) + ((_e795 * _e795) * param_6.y)) + ((_e796 * _e796) * param_6.z)) + ((_e797 * _e797) * param_6.w));
    if ((bitcast<u32>(_e782) & 2147483647u) > 2139095040u) {
        phi_1223_ = true;
    } else {
        let _e816 = (_e782 > _e812);
        if _e816 {
        }
        phi_1223_ = _e816;
    }
    let _e818 = phi_1223_;
    if _e818 {
        phi_1227_ = _e782;
    } else {
        phi_1227_ = _e812;
    }
    let _e820 = phi_1227_;
    let _e821 = -(_e793);
    if (_e821 <= 0f) {
        let _e825 = ((bitcast<u32>(_e820) & 2147483647u) > 2139095040u);
        if _e825 {
        }
        phi_1239_ = _e825;
    } else {
        phi_1239_ = true;
    }
    let _e827 = phi_1239_;
    if _e827 {
        phi_1246_ = (_e820 / (_e820 + (_e821 * _e821)));
    } else {
        phi_1246_ = 1f;
    }
    let _e832 = phi_1246_;
    if ((bitcast<u32>(_e832) & 2147483647u) > 2139095040u) {
        phi_1257_ = true;
    } else {
        let _e836 = (_e832 < _e443);
        if _e836 {
        }
        phi_1257_ = _e836;
    }
    let _e838 = phi_1257_;
    if _e838 {
        phi_1261_ = _e832;
    } else {
        phi_1261_ = _e443;
    }
    let _e840 = phi_1261_;
    if ((bitcast<u32>(_e840) & 2147483647u) > 2139095040u) {
        phi_1278_ = _e840;
    } else {
        if (_e840 < 0f) {
            phi_1277_ = 0f;
        } else {
            if (_e840 > 1f) {
                phi_1276_ = 1f;
            } else {
                phi_1276_ = _e840;
            }
            let _e847 = phi_1276_;
            phi_1277_ = _e847;
        }
        let _e849 = phi_1277_;
        phi_1278_ = _e849;
    }
    let _e851 = phi_1278_;
    return _e851;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_201_: f32;
    var phi_202_: f32;
    var phi_203_: f32;
    var phi_219_: f32;
    var phi_220_: f32;
    var phi_221_: f32;
    var phi_237_: f32;
    var phi_238_: f32;
    var phi_239_: f32;
    var phi_255_: f32;
    var phi_256_: f32;
    var phi_257_: f32;
    var phi_273_: f32;
    var phi_274_: f32;
    var phi_275_: f32;
    var phi_312_: bool;
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
    var phi_326_: bool;
    var phi_330_: bool;
    var phi_335_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_203_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_202_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_201_ = 1f;
            } else {
                phi_201_ = param_10;
            }
            let _e63 = phi_201_;
            phi_202_ = _e63;
        }
        let _e65 = phi_202_;
        phi_203_ = _e65;
    }
    let _e67 = phi_203_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_221_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_220_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_219_ = 1f;
            } else {
                phi_219_ = param_8.x;
            }
            let _e75 = phi_219_;
            phi_220_ = _e75;
        }
        let _e77 = phi_220_;
        phi_221_ = _e77;
    }
    let _e79 = phi_221_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_239_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_238_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_237_ = 1f;
            } else {
                phi_237_ = param_8.y;
            }
            let _e87 = phi_237_;
            phi_238_ = _e87;
        }
        let _e89 = phi_238_;
        phi_239_ = _e89;
    }
    let _e91 = phi_239_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_257_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_256_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_255_ = 1f;
            } else {
                phi_255_ = param_8.z;
            }
            let _e99 = phi_255_;
            phi_256_ = _e99;
        }
        let _e101 = phi_256_;
        phi_257_ = _e101;
    }
    let _e103 = phi_257_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_275_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_274_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_273_ = 1f;
            } else {
                phi_273_ = param_8.w;
            }
            let _e111 = phi_273_;
            phi_274_ = _e111;
        }
        let _e113 = phi_274_;
        phi_275_ = _e113;
    }
    let _e115 = phi_275_;
    let _e116 = (_e79 - _e67);
    let _e117 = (_e91 - _e67);
    let _e118 = (_e103 - _e67);
    let _e119 = (_e115 - _e67);
    if (_e116 >= 0f) {
        if (_e117 >= 0f) {
            if (_e118 >= 0f) {
                if (_e119 >= 0f) {
                    phi_312_ = !(((bitcast<u32>(((((_e116 * param_9.x) + (_e117 * param_9.y)) + (_e118 * param_9.z)) + (_e119 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_313_ = false;
                } else {
                    phi_312_ = bool();
                    phi_313_ = true;
                }
                let _e141 = phi_312_;
                let _e143 = phi_313_;
                phi_314_ = _e141;
                phi_315_ = false;
                phi_316_ = _e143;
            } else {
                phi_314_ = bool();
                phi_315_ = true;
                phi_316_ = false;
            }
            let _e145 = phi_314_;
            let _e147 = phi_315_;
            let _e149 = phi_316_;
            phi_317_ = _e145;
            phi_318_ = _e147;
            phi_319_ = _e149;
        } else {
            phi_317_ = bool();
            phi_318_ = true;
            phi_319_ = false;
        }
        let _e151 = phi_317_;
        let _e153 = phi_318_;
        let _e155 = phi_319_;
        phi_320_ = _e151;
        phi_321_ = _e153;
        phi_322_ = _e155;
    } else {
        phi_320_ = bool();
        phi_321_ = true;
        phi_322_ = false;
    }
    let _e157 = phi_320_;
    let _e159 = phi_321_;
    let _e161 = phi_322_;
    if _e159 {
        phi_326_ = true;
    } else {
        phi_326_ = _e161;
    }
    let _e163 = phi_326_;
    if _e163 {
        phi_330_ = false;
    } else {
        phi_330_ = _e157;
    }
    let _e165 = phi_330_;
    if _e165 {
        phi_335_ = 1f;
    } else {
        let _e166 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e116, _e117, _e118, _e119), param_9);
        phi_335_ = _e166;
    }
    let _e168 = phi_335_;
    return _e168;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_11: f32, param_12: f32) -> f32 {
    var phi_1286_: f32;

    if (param_11 < param_12) {
        phi_1286_ = param_11;
    } else {
        phi_1286_ = param_12;
    }
    let _e57 = phi_1286_;
    return _e57;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_1346_: bool;
    var phi_1347_: bool;
    var phi_1348_: bool;
    var phi_1349_: bool;
    var phi_1353_: bool;
    var phi_1423_: bool;
    var phi_1424_: bool;
    var phi_1435_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1436_: bool;
    var phi_1437_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1438_: bool;
    var phi_1445_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1449_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1469_: lt_math_LightPoint;
    var phi_1472_: u32;
    var phi_1474_: lt_math_LevelPoint;
    var phi_1560_: bool;
    var phi_1569_: bool;
    var phi_1578_: bool;
    var phi_1579_: bool;
    var phi_1580_: bool;
    var phi_1581_: bool;
    var phi_1582_: bool;
    var phi_1583_: bool;
    var phi_1584_: bool;
    var phi_1588_: bool;
    var phi_1615_: bool;
    var phi_1616_: bool;
    var phi_1617_: bool;
    var phi_1618_: bool;
    var phi_1619_: bool;
    var phi_1620_: bool;
    var phi_1621_: bool;
    var phi_1622_: bool;
    var phi_1626_: bool;
    var phi_1635_: lt_math_LightPoint;
    var phi_1636_: u32;
    var phi_1637_: lt_math_LevelPoint;
    var phi_1638_: bool;
    var phi_1470_: lt_math_LightPoint;
    var phi_1473_: u32;
    var phi_1475_: lt_math_LevelPoint;
    var phi_1639_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1679_: bool;
    var phi_1680_: bool;
    var phi_1681_: bool;
    var phi_1682_: bool;
    var phi_1686_: bool;
    var phi_1768_: f32;
    var phi_1884_: f32;
    var phi_1885_: f32;
    var phi_1888_: f32;
    var phi_1917_: f32;
    var phi_1922_: f32;
    var phi_1923_: bool;
    var phi_1924_: f32;
    var phi_1925_: bool;
    var phi_1929_: f32;
    var phi_1949_: f32;
    var phi_1954_: f32;
    var phi_1955_: bool;
    var phi_1956_: f32;
    var phi_1957_: bool;
    var phi_1961_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_2014_: i32;
    var phi_2019_: i32;
    var phi_2024_: i32;
    var phi_2029_: i32;
    var phi_2038_: i32;
    var phi_2043_: i32;
    var phi_2048_: i32;
    var phi_2053_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_2125_: f32;
    var phi_2127_: evaluate_Verdict;
    var phi_2128_: bool;
    var phi_2129_: evaluate_Verdict;
    var phi_2130_: bool;
    var phi_2135_: evaluate_Verdict;
    var phi_2136_: bool;
    var phi_2138_: evaluate_Verdict;
    var phi_2139_: evaluate_Verdict;
    var phi_2140_: bool;
    var phi_2144_: evaluate_Verdict;
    var phi_2145_: evaluate_Verdict;
    var phi_2146_: bool;
    var phi_2150_: evaluate_Verdict;

    let _e54 = id_1;
    let _e61 = arrayLength((&map.member));
    let _e67 = arrayLength((&levels.member));
    let _e70 = p.member.size[0u];
    let _e72 = p.member.size[1u];
    let _e73 = lt_shaders_entry_pixel_index(_e54, _e70, _e72);
    if (bitcast<i32>(_e73.root) != 0i) {
        let _e79 = p.member.level_count;
        if (_e73.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e86 = samples.member[(0u + _e73.first_primitive)].normal[0u];
        let _e88 = global[0u];
        if (_e86 == _e88) {
            let _e91 = samples.member[(0u + _e73.first_primitive)].normal[1u];
            let _e93 = global[1u];
            if (_e91 == _e93) {
                let _e96 = samples.member[(0u + _e73.first_primitive)].normal[2u];
                let _e98 = global[2u];
                phi_1346_ = (_e96 == _e98);
                phi_1347_ = false;
            } else {
                phi_1346_ = bool();
                phi_1347_ = true;
            }
            let _e101 = phi_1346_;
            let _e103 = phi_1347_;
            phi_1348_ = _e101;
            phi_1349_ = _e103;
        } else {
            phi_1348_ = bool();
            phi_1349_ = true;
        }
        let _e105 = phi_1348_;
        let _e107 = phi_1349_;
        if _e107 {
            phi_1353_ = false;
        } else {
            phi_1353_ = _e105;
        }
        let _e109 = phi_1353_;
        if !(_e109) {
            let _e112 = samples.member[(0u + _e73.first_primitive)].position;
            let _e114 = p.member.light.place;
            let _e120 = p.member.light.place[3u];
            let _e127 = (_e114.x - (_e112.x * _e120));
            let _e128 = (_e114.y - (_e112.y * _e120));
            let _e129 = (_e114.z - (_e112.z * _e120));
            let _e131 = samples.member[(0u + _e73.first_primitive)].normal;
            if ((((_e131.x * _e127) + (_e131.y * _e128)) + (_e131.z * _e129)) > 0f) {
                let _e145 = (((_e127 * _e127) + (_e128 * _e128)) + (_e129 * _e129));
                let _e147 = p.member.light.axis;
                let _e159 = p.member.light.place[3u];
                if (_e159 == 0f) {
                    phi_1424_ = true;
                } else {
                    let _e162 = p.member.light.range_squared;
                    if (_e145 <= _e162) {
                        let _e165 = p.member.light.cos_outer;
                        phi_1423_ = (-((((_e127 * _e147.x) + (_e128 * _e147.y)) + (_e129 * _e147.z))) >= (_e165 * sqrt(_e145)));
                    } else {
                        phi_1423_ = false;
                    }
                    let _e170 = phi_1423_;
                    phi_1424_ = _e170;
                }
                let _e172 = phi_1424_;
                if _e172 {
                    let _e174 = samples.member[(0u + _e73.first_primitive)].flags;
                    let _e182 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e182.unnamed.visibility, false), _e182.unnamed_1);
                    phi_1435_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e188.unnamed, ((_e174 & 1u) == 0u));
                    phi_1436_ = false;
                } else {
                    phi_1435_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1436_ = true;
                }
                let _e193 = phi_1435_;
                let _e195 = phi_1436_;
                phi_1437_ = _e193;
                phi_1438_ = _e195;
            } else {
                phi_1437_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1438_ = true;
            }
            let _e197 = phi_1437_;
            let _e199 = phi_1438_;
            if _e199 {
                let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
                phi_1445_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, true);
            } else {
                phi_1445_ = _e197;
            }
            let _e216 = phi_1445_;
            phi_1449_ = _e216;
        } else {
            let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e222.unnamed.visibility, false), _e222.unnamed_1);
            phi_1449_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e228.unnamed, true);
        }
        let _e233 = phi_1449_;
        if _e233.unnamed_1 {
            phi_2144_ = evaluate_Verdict(_e233.unnamed.visibility, _e233.unnamed.is_doubted);
            phi_2145_ = evaluate_Verdict();
            phi_2146_ = true;
        } else {
            let _e241 = samples.member[(0u + _e73.first_primitive)].position;
            let _e243 = p.member.map_size;
            let _e245 = (0.5f / f32(_e243));
            let _e252 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e259 = lt_math_LightPoint(vec2<f32>(_e252.uv.x, 0f), _e252.depth, _e252.is_inside);
            let _e263 = lt_math_LightPoint(_e259.uv, 0f, _e259.is_inside);
            phi_1469_ = lt_math_LightPoint();
            phi_1472_ = 0u;
            phi_1474_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e263.uv, _e263.depth, false));
            loop {
                let _e270 = phi_1469_;
                let _e272 = phi_1472_;
                let _e274 = phi_1474_;
                local_1 = _e274;
                local_2 = _e274;
                local_3 = _e274;
                local_4 = _e274;
                if (_e272 < _e79) {
                    if _e274.point.is_inside {
                        phi_1635_ = lt_math_LightPoint();
                        phi_1636_ = u32();
                        phi_1637_ = lt_math_LevelPoint();
                        phi_1638_ = false;
                    } else {
                        if (_e272 < _e67) {
                        } else {
                            return;
                        }
                        let _e285 = levels.member[(0u + _e272)].row_w;
                        let _e296 = ((((_e285.x * _e241.x) + (_e285.y * _e241.y)) + (_e285.z * _e241.z)) + (_e285.w * 1f));
                        let _e298 = levels.member[(0u + _e272)].row_x;
                        let _e310 = (((((_e298.x * _e241.x) + (_e298.y * _e241.y)) + (_e298.z * _e241.z)) + (_e298.w * 1f)) / _e296);
                        let _e312 = levels.member[(0u + _e272)].row_y;
                        let _e324 = (((((_e312.x * _e241.x) + (_e312.y * _e241.y)) + (_e312.z * _e241.z)) + (_e312.w * 1f)) / _e296);
                        let _e326 = levels.member[(0u + _e272)].row_z;
                        let _e337 = ((((_e326.x * _e241.x) + (_e326.y * _e241.y)) + (_e326.z * _e241.z)) + (_e326.w * 1f));
                        if (_e296 > 0f) {
                            if (_e310 >= 0f) {
                                phi_1560_ = (_e310 <= 1f);
                            } else {
                                phi_1560_ = false;
                            }
                            let _e342 = phi_1560_;
                            if _e342 {
                                if (_e324 >= 0f) {
                                    phi_1569_ = (_e324 <= 1f);
                                } else {
                                    phi_1569_ = false;
                                }
                                let _e346 = phi_1569_;
                                if _e346 {
                                    if (_e337 >= 0f) {
                                        phi_1578_ = (_e337 <= 1f);
                                    } else {
                                        phi_1578_ = false;
                                    }
                                    let _e350 = phi_1578_;
                                    phi_1579_ = _e350;
                                    phi_1580_ = false;
                                } else {
                                    phi_1579_ = bool();
                                    phi_1580_ = true;
                                }
                                let _e352 = phi_1579_;
                                let _e354 = phi_1580_;
                                phi_1581_ = _e352;
                                phi_1582_ = _e354;
                            } else {
                                phi_1581_ = bool();
                                phi_1582_ = true;
                            }
                            let _e356 = phi_1581_;
                            let _e358 = phi_1582_;
                            phi_1583_ = _e356;
                            phi_1584_ = _e358;
                        } else {
                            phi_1583_ = bool();
                            phi_1584_ = true;
                        }
                        let _e360 = phi_1583_;
                        let _e362 = phi_1584_;
                        if _e362 {
                            phi_1588_ = false;
                        } else {
                            phi_1588_ = _e360;
                        }
                        let _e364 = phi_1588_;
                        if _e364 {
                            if (_e310 >= _e245) {
                                if (_e310 <= (1f - _e245)) {
                                    if (_e324 >= _e245) {
                                        phi_1615_ = (_e324 <= (1f - _e245));
                                        phi_1616_ = false;
                                    } else {
                                        phi_1615_ = bool();
                                        phi_1616_ = true;
                                    }
                                    let _e372 = phi_1615_;
                                    let _e374 = phi_1616_;
                                    phi_1617_ = _e372;
                                    phi_1618_ = _e374;
                                } else {
                                    phi_1617_ = bool();
                                    phi_1618_ = true;
                                }
                                let _e376 = phi_1617_;
                                let _e378 = phi_1618_;
                                phi_1619_ = _e376;
                                phi_1620_ = _e378;
                            } else {
                                phi_1619_ = bool();
                                phi_1620_ = true;
                            }
                            let _e380 = phi_1619_;
                            let _e382 = phi_1620_;
                            phi_1621_ = _e380;
                            phi_1622_ = _e382;
                        } else {
                            phi_1621_ = bool();
                            phi_1622_ = true;
                        }
                        let _e384 = phi_1621_;
                        let _e386 = phi_1622_;
                        if _e386 {
                            phi_1626_ = false;
                        } else {
                            phi_1626_ = _e384;
                        }
                        let _e388 = phi_1626_;
                        let _e395 = lt_math_LightPoint(vec2<f32>(_e310, _e270.uv.y), _e270.depth, _e270.is_inside);
                        let _e402 = lt_math_LightPoint(vec2<f32>(_e395.uv.x, _e324), _e395.depth, _e395.is_inside);
                        let _e406 = lt_math_LightPoint(_e402.uv, _e337, _e402.is_inside);
                        let _e410 = lt_math_LightPoint(_e406.uv, _e406.depth, _e388);
                        phi_1635_ = _e410;
                        phi_1636_ = (_e272 + 1u);
                        phi_1637_ = lt_math_LevelPoint(_e272, _e410);
                        phi_1638_ = true;
                    }
                    let _e414 = phi_1635_;
                    let _e416 = phi_1636_;
                    let _e418 = phi_1637_;
                    let _e420 = phi_1638_;
                    phi_1470_ = _e414;
                    phi_1473_ = _e416;
                    phi_1475_ = _e418;
                    phi_1639_ = _e420;
                } else {
                    phi_1470_ = lt_math_LightPoint();
                    phi_1473_ = u32();
                    phi_1475_ = lt_math_LevelPoint();
                    phi_1639_ = false;
                }
                let _e422 = phi_1470_;
                let _e424 = phi_1473_;
                let _e426 = phi_1475_;
                let _e428 = phi_1639_;
                continue;
                continuing {
                    phi_1469_ = _e422;
                    phi_1472_ = _e424;
                    phi_1474_ = _e426;
                    break if !(_e428);
                }
            }
            let _e431 = local_1;
            if _e431.point.is_inside {
                if (0f > 0f) {
                    let _e437 = local_2;
                    if (_e437.level < _e67) {
                    } else {
                        return;
                    }
                    let _e442 = levels.member[(0u + _e437.level)];
                    let _e448 = global[0u];
                    if (_e442.row_w.x == _e448) {
                        let _e451 = global[1u];
                        if (_e442.row_w.y == _e451) {
                            let _e454 = global[2u];
                            phi_1679_ = (_e442.row_w.z == _e454);
                            phi_1680_ = false;
                        } else {
                            phi_1679_ = bool();
                            phi_1680_ = true;
                        }
                        let _e457 = phi_1679_;
                        let _e459 = phi_1680_;
                        phi_1681_ = _e457;
                        phi_1682_ = _e459;
                    } else {
                        phi_1681_ = bool();
                        phi_1682_ = true;
                    }
                    let _e461 = phi_1681_;
                    let _e463 = phi_1682_;
                    if _e463 {
                        phi_1686_ = false;
                    } else {
                        phi_1686_ = _e461;
                    }
                    let _e465 = phi_1686_;
                    if _e465 {
                        let _e467 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e469 = p.member.map_size;
                        let _e539 = ((abs(((((_e442.row_x.x * _e467.x) + (_e442.row_x.y * _e467.y)) + (_e442.row_x.z * _e467.z)) / (((_e442.row_x.x * _e442.row_x.x) + (_e442.row_x.y * _e442.row_x.y)) + (_e442.row_x.z * _e442.row_x.z)))) + abs(((((_e442.row_y.x * _e467.x) + (_e442.row_y.y * _e467.y)) + (_e442.row_y.z * _e467.z)) / (((_e442.row_y.x * _e442.row_y.x) + (_e442.row_y.y * _e442.row_y.y)) + (_e442.row_y.z * _e442.row_y.z))))) / (abs(((((_e442.row_z.x * _e467.x) + (_e442.row_z.y * _e467.y)) + (_e442.row_z.z * _e467.z)) / (((_e442.row_z.x * _e442.row_z.x) + (_e442.row_z.y * _e442.row_z.y)) + (_e442.row_z.z * _e442.row_z.z)))) * f32(_e469)));
                        if (_e539 < 0.002f) {
                            phi_1768_ = _e539;
                        } else {
                            phi_1768_ = 0.002f;
                        }
                        let _e542 = phi_1768_;
                        phi_1885_ = _e542;
                    } else {
                        let _e544 = p.member.map_size;
                        let _e550 = samples.member[(0u + _e73.first_primitive)].position;
                        let _e561 = ((((_e442.row_w.x * _e550.x) + (_e442.row_w.y * _e550.y)) + (_e442.row_w.z * _e550.z)) + _e442.row_w.w);
                        let _e574 = ((_e442.row_x.x - (_e442.row_w.x * _e431.point.uv.x)) / _e561);
                        let _e575 = ((_e442.row_x.y - (_e442.row_w.y * _e431.point.uv.x)) / _e561);
                        let _e576 = ((_e442.row_x.z - (_e442.row_w.z * _e431.point.uv.x)) / _e561);
                        let _e589 = ((_e442.row_y.x - (_e442.row_w.x * _e431.point.uv.y)) / _e561);
                        let _e590 = ((_e442.row_y.y - (_e442.row_w.y * _e431.point.uv.y)) / _e561);
                        let _e591 = ((_e442.row_y.z - (_e442.row_w.z * _e431.point.uv.y)) / _e561);
                        let _e597 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e602 = ((_e590 * _e597.z) - (_e597.y * _e591));
                        let _e607 = ((_e591 * _e597.x) - (_e597.z * _e589));
                        let _e612 = ((_e589 * _e597.y) - (_e597.x * _e590));
                        let _e614 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e619 = ((_e575 * _e614.z) - (_e614.y * _e576));
                        let _e624 = ((_e576 * _e614.x) - (_e614.z * _e574));
                        let _e629 = ((_e574 * _e614.y) - (_e614.x * _e575));
                        let _e656 = ((abs(((((_e442.row_z.x * _e602) + (_e442.row_z.y * _e607)) + (_e442.row_z.z * _e612)) / (((_e574 * _e602) + (_e575 * _e607)) + (_e576 * _e612)))) + abs(((((_e442.row_z.x * _e619) + (_e442.row_z.y * _e624)) + (_e442.row_z.z * _e629)) / (((_e589 * _e619) + (_e590 * _e624)) + (_e591 * _e629))))) / f32(_e544));
                        if (_e656 < 0.002f) {
                            phi_1884_ = _e656;
                        } else {
                            phi_1884_ = 0.002f;
                        }
                        let _e659 = phi_1884_;
                        phi_1885_ = _e659;
                    }
                    let _e661 = phi_1885_;
                    phi_1888_ = (_e431.point.depth - (0f * _e661));
                } else {
                    phi_1888_ = _e431.point.depth;
                }
                let _e665 = phi_1888_;
                let _e671 = p.member.map_size;
                let _e672 = f32(_e671);
                let _e675 = ((_e431.point.uv.x * _e672) - 0.5f);
                let _e676 = ((_e431.point.uv.y * _e672) - 0.5f);
                if (_e675 > -8388608f) {
                    let _e688 = f32(select(0i, select(select(i32(_e675), i32(-2147483648), (_e675 < bitcast<f32>(3472883712u))), 2147483647i, (_e675 > bitcast<f32>(1325400063u))), (_e675 == _e675)));
                    if (_e688 > _e675) {
                        phi_1917_ = 1f;
                    } else {
                        phi_1917_ = 0f;
                    }
                    let _e691 = phi_1917_;
                    if (_e675 < 8388608f) {
                        phi_1922_ = (_e688 - _e691);
                        phi_1923_ = false;
                    } else {
                        phi_1922_ = f32();
                        phi_1923_ = true;
                    }
                    let _e694 = phi_1922_;
                    let _e696 = phi_1923_;
                    phi_1924_ = _e694;
                    phi_1925_ = _e696;
                } else {
                    phi_1924_ = f32();
                    phi_1925_ = true;
                }
                let _e698 = phi_1924_;
                let _e700 = phi_1925_;
                if _e700 {
                    phi_1929_ = _e675;
                } else {
                    phi_1929_ = _e698;
                }
                let _e702 = phi_1929_;
                if (_e676 > -8388608f) {
                    let _e714 = f32(select(0i, select(select(i32(_e676), i32(-2147483648), (_e676 < bitcast<f32>(3472883712u))), 2147483647i, (_e676 > bitcast<f32>(1325400063u))), (_e676 == _e676)));
                    if (_e714 > _e676) {
                        phi_1949_ = 1f;
                    } else {
                        phi_1949_ = 0f;
                    }
                    let _e717 = phi_1949_;
                    if (_e676 < 8388608f) {
                        phi_1954_ = (_e714 - _e717);
                        phi_1955_ = false;
                    } else {
                        phi_1954_ = f32();
                        phi_1955_ = true;
                    }
                    let _e720 = phi_1954_;
                    let _e722 = phi_1955_;
                    phi_1956_ = _e720;
                    phi_1957_ = _e722;
                } else {
                    phi_1956_ = f32();
                    phi_1957_ = true;
                }
                let _e724 = phi_1956_;
                let _e726 = phi_1957_;
                if _e726 {
                    phi_1961_ = _e676;
                } else {
                    phi_1961_ = _e724;
                }
                let _e728 = phi_1961_;
                let _e729 = (_e675 - _e702);
                let _e730 = (_e676 - _e728);
                let _e739 = select(0i, select(select(i32(_e702), i32(-2147483648), (_e702 < bitcast<f32>(3472883712u))), 2147483647i, (_e702 > bitcast<f32>(1325400063u))), (_e702 == _e702));
                let _e748 = select(0i, select(select(i32(_e728), i32(-2147483648), (_e728 < bitcast<f32>(3472883712u))), 2147483647i, (_e728 > bitcast<f32>(1325400063u))), (_e728 == _e728));
                let _e759 = p.member.test;
                let _e760 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e759);
                let _e762 = p.member.map_size;
                let _e764 = local_3;
                local = lt_math_Evsm(_e760.positive_exponent, _e760.negative_exponent, _e760.min_variance);
                let _e771 = ((_e764.level * _e762) * _e762);
                let _e773 = (bitcast<i32>(_e762) - 1i);
                if (_e739 > 0i) {
                    phi_2014_ = _e739;
                } else {
                    phi_2014_ = 0i;
                }
                let _e776 = phi_2014_;
                if (_e748 > 0i) {
                    phi_2019_ = _e748;
                } else {
                    phi_2019_ = 0i;
                }
                let _e779 = phi_2019_;
                if (_e776 < _e773) {
                    phi_2024_ = _e776;
                } else {
                    phi_2024_ = _e773;
                }
                let _e782 = phi_2024_;
                if (_e779 < _e773) {
                    phi_2029_ = _e779;
                } else {
                    phi_2029_ = _e773;
                }
                let _e785 = phi_2029_;
                let _e786 = bitcast<u32>(_e782);
                let _e788 = (_e739 + 1i);
                let _e789 = (_e748 + 1i);
                if (_e788 > 0i) {
                    phi_2038_ = _e788;
                } else {
                    phi_2038_ = 0i;
                }
                let _e792 = phi_2038_;
                if (_e789 > 0i) {
                    phi_2043_ = _e789;
                } else {
                    phi_2043_ = 0i;
                }
                let _e795 = phi_2043_;
                if (_e792 < _e773) {
                    phi_2048_ = _e792;
                } else {
                    phi_2048_ = _e773;
                }
                let _e798 = phi_2048_;
                if (_e795 < _e773) {
                    phi_2053_ = _e795;
                } else {
                    phi_2053_ = _e773;
                }
                let _e801 = phi_2053_;
                let _e802 = bitcast<u32>(_e798);
                let _e804 = (bitcast<u32>(_e785) * _e762);
                let _e805 = (bitcast<u32>(_e801) * _e762);
                let _e810 = ((_e804 + _e786) + _e771);
                let _e811 = ((_e804 + _e802) + _e771);
                let _e812 = ((_e805 + _e786) + _e771);
                let _e813 = ((_e805 + _e802) + _e771);
                if (_e810 < _e61) {
                } else {
                    return;
                }
                let _e817 = map.member[(0u + _e810)];
                if (_e811 < _e61) {
                } else {
                    return;
                }
                let _e821 = map.member[(0u + _e811)];
                if (_e812 < _e61) {
                } else {
                    return;
                }
                let _e825 = map.member[(0u + _e812)];
                if (_e813 < _e61) {
                } else {
                    return;
                }
                let _e829 = map.member[(0u + _e813)];
                let _e831 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e817, _e821, _e825, _e829), vec4<f32>(((1f - _e729) * (1f - _e730)), (_e729 * (1f - _e730)), ((1f - _e729) * _e730), (_e729 * _e730)), _e665);
                let _e833 = p.member.fade_uv;
                if (_e833 > 0f) {
                    let _e836 = local_4;
                    if ((_e836.level + 1u) == _e79) {
                        let _e845 = p.member.fade_uv;
                        let _e847 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e431.point.uv.x, (1f - _e431.point.uv.x));
                        let _e849 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e431.point.uv.y, (1f - _e431.point.uv.y));
                        let _e850 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e847, _e849);
                        if (_e850 < _e845) {
                            phi_2125_ = (1f - ((1f - _e831) * (_e850 / _e845)));
                        } else {
                            phi_2125_ = _e831;
                        }
                        let _e857 = phi_2125_;
                        phi_2127_ = evaluate_Verdict(_e857, false);
                        phi_2128_ = false;
                    } else {
                        phi_2127_ = evaluate_Verdict();
                        phi_2128_ = true;
                    }
                    let _e860 = phi_2127_;
                    let _e862 = phi_2128_;
                    phi_2129_ = _e860;
                    phi_2130_ = _e862;
                } else {
                    phi_2129_ = evaluate_Verdict();
                    phi_2130_ = true;
                }
                let _e864 = phi_2129_;
                let _e866 = phi_2130_;
                if _e866 {
                    phi_2135_ = evaluate_Verdict(_e831, false);
                    phi_2136_ = false;
                } else {
                    phi_2135_ = evaluate_Verdict();
                    phi_2136_ = true;
                }
                let _e869 = phi_2135_;
                let _e871 = phi_2136_;
                phi_2138_ = _e869;
                phi_2139_ = _e864;
                phi_2140_ = _e871;
            } else {
                phi_2138_ = evaluate_Verdict();
                phi_2139_ = evaluate_Verdict(1f, false);
                phi_2140_ = true;
            }
            let _e874 = phi_2138_;
            let _e876 = phi_2139_;
            let _e878 = phi_2140_;
            if _e878 {
            }
            phi_2144_ = _e876;
            phi_2145_ = _e874;
            phi_2146_ = _e878;
        }
        let _e880 = phi_2144_;
        let _e882 = phi_2145_;
        let _e884 = phi_2146_;
        if _e884 {
            phi_2150_ = _e880;
        } else {
            phi_2150_ = _e882;
        }
        let _e886 = phi_2150_;
        if (_e73.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e73.first_primitive)] = _e886.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
