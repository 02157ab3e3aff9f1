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

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct type_52 {
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
var<storage, read_write> list: type_52;
@group(0) @binding(5) 
var<storage> levels: type_43;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_185_: lt_bvh_traverse_Tree;
    var phi_186_: bool;
    var phi_187_: lt_bvh_traverse_Tree;
    var phi_188_: bool;
    var phi_193_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_185_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_186_ = false;
        } else {
            phi_185_ = lt_bvh_traverse_Tree();
            phi_186_ = true;
        }
        let _e74 = phi_185_;
        let _e76 = phi_186_;
        phi_187_ = _e74;
        phi_188_ = _e76;
    } else {
        phi_187_ = lt_bvh_traverse_Tree();
        phi_188_ = true;
    }
    let _e78 = phi_187_;
    let _e80 = phi_188_;
    if _e80 {
        phi_193_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_193_ = _e78;
    }
    let _e85 = phi_193_;
    return lt_bvh_traverse_Tree(_e85.root, _e85.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_373_: bool;
    var phi_377_: f32;
    var phi_396_: f32;
    var phi_401_: f32;
    var phi_423_: f32;
    var phi_428_: f32;
    var phi_429_: bool;
    var phi_430_: f32;
    var phi_431_: bool;
    var phi_435_: f32;
    var phi_473_: f32;
    var phi_484_: f32;
    var phi_489_: f32;
    var phi_511_: f32;
    var phi_516_: f32;
    var phi_517_: bool;
    var phi_518_: f32;
    var phi_519_: bool;
    var phi_523_: f32;
    var phi_561_: f32;
    var phi_572_: f32;
    var phi_577_: f32;
    var phi_599_: f32;
    var phi_604_: f32;
    var phi_605_: bool;
    var phi_606_: f32;
    var phi_607_: bool;
    var phi_611_: f32;
    var phi_649_: f32;
    var phi_660_: f32;
    var phi_665_: f32;
    var phi_687_: f32;
    var phi_692_: f32;
    var phi_693_: bool;
    var phi_694_: f32;
    var phi_695_: bool;
    var phi_699_: f32;
    var phi_737_: f32;
    var phi_790_: bool;
    var phi_794_: f32;
    var phi_806_: bool;
    var phi_813_: f32;
    var phi_826_: bool;
    var phi_830_: f32;
    var phi_850_: f32;
    var phi_855_: f32;
    var phi_877_: f32;
    var phi_882_: f32;
    var phi_883_: bool;
    var phi_884_: f32;
    var phi_885_: bool;
    var phi_889_: f32;
    var phi_927_: f32;
    var phi_938_: f32;
    var phi_943_: f32;
    var phi_965_: f32;
    var phi_970_: f32;
    var phi_971_: bool;
    var phi_972_: f32;
    var phi_973_: bool;
    var phi_977_: f32;
    var phi_1015_: f32;
    var phi_1026_: f32;
    var phi_1031_: f32;
    var phi_1053_: f32;
    var phi_1058_: f32;
    var phi_1059_: bool;
    var phi_1060_: f32;
    var phi_1061_: bool;
    var phi_1065_: f32;
    var phi_1103_: f32;
    var phi_1114_: f32;
    var phi_1119_: f32;
    var phi_1141_: f32;
    var phi_1146_: f32;
    var phi_1147_: bool;
    var phi_1148_: f32;
    var phi_1149_: bool;
    var phi_1153_: f32;
    var phi_1191_: f32;
    var phi_1244_: bool;
    var phi_1248_: f32;
    var phi_1260_: bool;
    var phi_1267_: f32;
    var phi_1278_: bool;
    var phi_1282_: f32;
    var phi_1297_: f32;
    var phi_1298_: f32;
    var phi_1299_: f32;

    let _e65 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_373_ = true;
    } else {
        let _e69 = (42f < _e65);
        if _e69 {
        }
        phi_373_ = _e69;
    }
    let _e71 = phi_373_;
    if _e71 {
        phi_377_ = 42f;
    } else {
        phi_377_ = _e65;
    }
    let _e73 = phi_377_;
    let _e75 = (_e73 * param_5.x);
    let _e77 = (_e73 * param_5.y);
    let _e79 = (_e73 * param_5.z);
    let _e81 = (_e73 * param_5.w);
    if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
        phi_473_ = _e75;
    } else {
        if (_e75 < -87f) {
            phi_396_ = -87f;
        } else {
            phi_396_ = _e75;
        }
        let _e87 = phi_396_;
        if (_e87 > 88f) {
            phi_401_ = 88f;
        } else {
            phi_401_ = _e87;
        }
        let _e90 = phi_401_;
        let _e92 = ((_e90 * 1.442695f) + 0.5f);
        if (_e92 > -8388608f) {
            let _e104 = f32(select(0i, select(select(i32(_e92), i32(-2147483648), (_e92 < bitcast<f32>(3472883712u))), 2147483647i, (_e92 > bitcast<f32>(1325400063u))), (_e92 == _e92)));
            if (_e104 > _e92) {
                phi_423_ = 1f;
            } else {
                phi_423_ = 0f;
            }
            let _e107 = phi_423_;
            if (_e92 < 8388608f) {
                phi_428_ = (_e104 - _e107);
                phi_429_ = false;
            } else {
                phi_428_ = f32();
                phi_429_ = true;
            }
            let _e110 = phi_428_;
            let _e112 = phi_429_;
            phi_430_ = _e110;
            phi_431_ = _e112;
        } else {
            phi_430_ = f32();
            phi_431_ = true;
        }
        let _e114 = phi_430_;
        let _e116 = phi_431_;
        if _e116 {
            phi_435_ = _e92;
        } else {
            phi_435_ = _e114;
        }
        let _e118 = phi_435_;
        let _e122 = ((_e90 - (_e118 * 0.69314575f)) - (_e118 * 0.0000014286068f));
        phi_473_ = ((((((((((((((((1f / 5040f) * _e122) + (1f / 720f)) * _e122) + (1f / 120f)) * _e122) + (1f / 24f)) * _e122) + (1f / 6f)) * _e122) + 0.5f) * _e122) + 1f) * _e122) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < bitcast<f32>(3472883712u))), 2147483647i, (_e118 > bitcast<f32>(1325400063u))), (_e118 == _e118)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e158 = phi_473_;
    if ((bitcast<u32>(_e77) & 2147483647u) > 2139095040u) {
        phi_561_ = _e77;
    } else {
        if (_e77 < -87f) {
            phi_484_ = -87f;
        } else {
            phi_484_ = _e77;
        }
        let _e164 = phi_484_;
        if (_e164 > 88f) {
            phi_489_ = 88f;
        } else {
            phi_489_ = _e164;
        }
        let _e167 = phi_489_;
        let _e169 = ((_e167 * 1.442695f) + 0.5f);
        if (_e169 > -8388608f) {
            let _e181 = f32(select(0i, select(select(i32(_e169), i32(-2147483648), (_e169 < bitcast<f32>(3472883712u))), 2147483647i, (_e169 > bitcast<f32>(1325400063u))), (_e169 == _e169)));
            if (_e181 > _e169) {
                phi_511_ = 1f;
            } else {
                phi_511_ = 0f;
            }
            let _e184 = phi_511_;
            if (_e169 < 8388608f) {
                phi_516_ = (_e181 - _e184);
                phi_517_ = false;
            } else {
                phi_516_ = f32();
                phi_517_ = true;
            }
            let _e187 = phi_516_;
            let _e189 = phi_517_;
            phi_518_ = _e187;
            phi_519_ = _e189;
        } else {
            phi_518_ = f32();
            phi_519_ = true;
        }
        let _e191 = phi_518_;
        let _e193 = phi_519_;
        if _e193 {
            phi_523_ = _e169;
        } else {
            phi_523_ = _e191;
        }
        let _e195 = phi_523_;
        let _e199 = ((_e167 - (_e195 * 0.69314575f)) - (_e195 * 0.0000014286068f));
        phi_561_ = ((((((((((((((((1f / 5040f) * _e199) + (1f / 720f)) * _e199) + (1f / 120f)) * _e199) + (1f / 24f)) * _e199) + (1f / 6f)) * _e199) + 0.5f) * _e199) + 1f) * _e199) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e195), i32(-2147483648), (_e195 < bitcast<f32>(3472883712u))), 2147483647i, (_e195 > bitcast<f32>(1325400063u))), (_e195 == _e195)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e235 = phi_561_;
    if ((bitcast<u32>(_e79) & 2147483647u) > 2139095040u) {
        phi_649_ = _e79;
    } else {
        if (_e79 < -87f) {
            phi_572_ = -87f;
        } else {
            phi_572_ = _e79;
        }
        let _e241 = phi_572_;
        if (_e241 > 88f) {
            phi_577_ = 88f;
        } else {
            phi_577_ = _e241;
        }
        let _e244 = phi_577_;
        let _e246 = ((_e244 * 1.442695f) + 0.5f);
        if (_e246 > -8388608f) {
            let _e258 = f32(select(0i, select(select(i32(_e246), i32(-2147483648), (_e246 < bitcast<f32>(3472883712u))), 2147483647i, (_e246 > bitcast<f32>(1325400063u))), (_e246 == _e246)));
            if (_e258 > _e246) {
                phi_599_ = 1f;
            } else {
                phi_599_ = 0f;
            }
            let _e261 = phi_599_;
            if (_e246 < 8388608f) {
                phi_604_ = (_e258 - _e261);
                phi_605_ = false;
            } else {
                phi_604_ = f32();
                phi_605_ = true;
            }
            let _e264 = phi_604_;
            let _e266 = phi_605_;
            phi_606_ = _e264;
            phi_607_ = _e266;
        } else {
            phi_606_ = f32();
            phi_607_ = true;
        }
        let _e268 = phi_606_;
        let _e270 = phi_607_;
        if _e270 {
            phi_611_ = _e246;
        } else {
            phi_611_ = _e268;
        }
        let _e272 = phi_611_;
        let _e276 = ((_e244 - (_e272 * 0.69314575f)) - (_e272 * 0.0000014286068f));
        phi_649_ = ((((((((((((((((1f / 5040f) * _e276) + (1f / 720f)) * _e276) + (1f / 120f)) * _e276) + (1f / 24f)) * _e276) + (1f / 6f)) * _e276) + 0.5f) * _e276) + 1f) * _e276) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e272), i32(-2147483648), (_e272 < bitcast<f32>(3472883712u))), 2147483647i, (_e272 > bitcast<f32>(1325400063u))), (_e272 == _e272)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e312 = phi_649_;
    if ((bitcast<u32>(_e81) & 2147483647u) > 2139095040u) {
        phi_737_ = _e81;
    } else {
        if (_e81 < -87f) {
            phi_660_ = -87f;
        } else {
            phi_660_ = _e81;
        }
        let _e318 = phi_660_;
        if (_e318 > 88f) {
            phi_665_ = 88f;
        } else {
            phi_665_ = _e318;
        }
        let _e321 = phi_665_;
        let _e323 = ((_e321 * 1.442695f) + 0.5f);
        if (_e323 > -8388608f) {
            let _e335 = f32(select(0i, select(select(i32(_e323), i32(-2147483648), (_e323 < bitcast<f32>(3472883712u))), 2147483647i, (_e323 > bitcast<f32>(1325400063u))), (_e323 == _e323)));
            if (_e335 > _e323) {
                phi_687_ = 1f;
            } else {
                phi_687_ = 0f;
            }
            let _e338 = phi_687_;
            if (_e323 < 8388608f) {
                phi_692_ = (_e335 - _e338);
                phi_693_ = false;
            } else {
                phi_692_ = f32();
                phi_693_ = true;
            }
            let _e341 = phi_692_;
            let _e343 = phi_693_;
            phi_694_ = _e341;
            phi_695_ = _e343;
        } else {
            phi_694_ = f32();
            phi_695_ = true;
        }
        let _e345 = phi_694_;
        let _e347 = phi_695_;
        if _e347 {
            phi_699_ = _e323;
        } else {
            phi_699_ = _e345;
        }
        let _e349 = phi_699_;
        let _e353 = ((_e321 - (_e349 * 0.69314575f)) - (_e349 * 0.0000014286068f));
        phi_737_ = ((((((((((((((((1f / 5040f) * _e353) + (1f / 720f)) * _e353) + (1f / 120f)) * _e353) + (1f / 24f)) * _e353) + (1f / 6f)) * _e353) + 0.5f) * _e353) + 1f) * _e353) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e349), i32(-2147483648), (_e349 < bitcast<f32>(3472883712u))), 2147483647i, (_e349 > bitcast<f32>(1325400063u))), (_e349 == _e349)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e389 = phi_737_;
    let _e391 = (_e158 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e393 = (_e235 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e395 = (_e312 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e397 = (_e389 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e399 = (*param_4).min_variance;
    let _e401 = ((_e399 * _e73) * _e73);
    let _e412 = ((((_e391 * param_6.x) + (_e393 * param_6.y)) + (_e395 * param_6.z)) + (_e397 * param_6.w));
    let _e413 = (_e391 - _e412);
    let _e414 = (_e393 - _e412);
    let _e415 = (_e395 - _e412);
    let _e416 = (_e397 - _e412);
    let _e431 = (((((_e413 * _e413) * param_6.x) + ((_e414 * _e414) * param_6.y)) + ((_e415 * _e415) * param_6.z)) + ((_e416 * _e416) * param_6.w));
    if ((bitcast<u32>(_e401) & 2147483647u) > 2139095040u) {
        phi_790_ = true;
    } else {
        let _e435 = (_e401 > _e431);
        if _e435 {
        }
        phi_790_ = _e435;
    }
    let _e437 = phi_790_;
    if _e437 {
        phi_794_ = _e401;
    } else {
        phi_794_ = _e431;
    }
    let _e439 = phi_794_;
    let _e440 = -(_e412);
    if (_e440 <= 0f) {
        let _e444 = ((bitcast<u32>(_e439) & 2147483647u) > 2139095040u);
        if _e444 {
        }
        phi_806_ = _e444;
    } else {
        phi_806_ = true;
    }
    let _e446 = phi_806_;
    if _e446 {
        phi_813_ = (_e439 / (_e439 + (_e440 * _e440)));
    } else {
        phi_813_ = 1f;
    }
    let _e451 = phi_813_;
    let _e453 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_826_ = true;
    } else {
        let _e457 = (42f < _e453);
        if _e457 {
        }
        phi_826_ = _e457;
    }
    let _e459 = phi_826_;
    if _e459 {
        phi_830_ = 42f;
    } else {
        phi_830_ = _e453;
    }
    let _e461 = phi_830_;
    let _e462 = -(_e461);
    let _e464 = (_e462 * param_5.x);
    let _e466 = (_e462 * param_5.y);
    let _e468 = (_e462 * param_5.z);
    let _e470 = (_e462 * param_5.w);
    if ((bitcast<u32>(_e464) & 2147483647u) > 2139095040u) {
        phi_927_ = _e464;
    } else {
        if (_e464 < -87f) {
            phi_850_ = -87f;
        } else {
            phi_850_ = _e464;
        }
        let _e476 = phi_850_;
        if (_e476 > 88f) {
            phi_855_ = 88f;
        } else {
            phi_855_ = _e476;
        }
        let _e479 = phi_855_;
        let _e481 = ((_e479 * 1.442695f) + 0.5f);
        if (_e481 > -8388608f) {
            let _e493 = f32(select(0i, select(select(i32(_e481), i32(-2147483648), (_e481 < bitcast<f32>(3472883712u))), 2147483647i, (_e481 > bitcast<f32>(1325400063u))), (_e481 == _e481)));
            if (_e493 > _e481) {
                phi_877_ = 1f;
            } else {
                phi_877_ = 0f;
            }
            let _e496 = phi_877_;
            if (_e481 < 8388608f) {
                phi_882_ = (_e493 - _e496);
                phi_883_ = false;
            } else {
                phi_882_ = f32();
                phi_883_ = true;
            }
            let _e499 = phi_882_;
            let _e501 = phi_883_;
            phi_884_ = _e499;
            phi_885_ = _e501;
        } else {
            phi_884_ = f32();
            phi_885_ = true;
        }
        let _e503 = phi_884_;
        let _e505 = phi_885_;
        if _e505 {
            phi_889_ = _e481;
        } else {
            phi_889_ = _e503;
        }
        let _e507 = phi_889_;
        let _e511 = ((_e479 - (_e507 * 0.69314575f)) - (_e507 * 0.0000014286068f));
        phi_927_ = ((((((((((((((((1f / 5040f) * _e511) + (1f / 720f)) * _e511) + (1f / 120f)) * _e511) + (1f / 24f)) * _e511) + (1f / 6f)) * _e511) + 0.5f) * _e511) + 1f) * _e511) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e507), i32(-2147483648), (_e507 < bitcast<f32>(3472883712u))), 2147483647i, (_e507 > bitcast<f32>(1325400063u))), (_e507 == _e507)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e547 = phi_927_;
    if ((bitcast<u32>(_e466) & 2147483647u) > 2139095040u) {
        phi_1015_ = _e466;
    } else {
        if (_e466 < -87f) {
            phi_938_ = -87f;
        } else {
            phi_938_ = _e466;
        }
        let _e553 = phi_938_;
        if (_e553 > 88f) {
            phi_943_ = 88f;
        } else {
            phi_943_ = _e553;
        }
        let _e556 = phi_943_;
        let _e558 = ((_e556 * 1.442695f) + 0.5f);
        if (_e558 > -8388608f) {
            let _e570 = f32(select(0i, select(select(i32(_e558), i32(-2147483648), (_e558 < bitcast<f32>(3472883712u))), 2147483647i, (_e558 > bitcast<f32>(1325400063u))), (_e558 == _e558)));
            if (_e570 > _e558) {
                phi_965_ = 1f;
            } else {
                phi_965_ = 0f;
            }
            let _e573 = phi_965_;
            if (_e558 < 8388608f) {
                phi_970_ = (_e570 - _e573);
                phi_971_ = false;
            } else {
                phi_970_ = f32();
                phi_971_ = true;
            }
            let _e576 = phi_970_;
            let _e578 = phi_971_;
            phi_972_ = _e576;
            phi_973_ = _e578;
        } else {
            phi_972_ = f32();
            phi_973_ = true;
        }
        let _e580 = phi_972_;
        let _e582 = phi_973_;
        if _e582 {
            phi_977_ = _e558;
        } else {
            phi_977_ = _e580;
        }
        let _e584 = phi_977_;
        let _e588 = ((_e556 - (_e584 * 0.69314575f)) - (_e584 * 0.0000014286068f));
        phi_1015_ = ((((((((((((((((1f / 5040f) * _e588) + (1f / 720f)) * _e588) + (1f / 120f)) * _e588) + (1f / 24f)) * _e588) + (1f / 6f)) * _e588) + 0.5f) * _e588) + 1f) * _e588) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e584), i32(-2147483648), (_e584 < bitcast<f32>(3472883712u))), 2147483647i, (_e584 > bitcast<f32>(1325400063u))), (_e584 == _e584)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e624 = phi_1015_;
    if ((bitcast<u32>(_e468) & 2147483647u) > 2139095040u) {
        phi_1103_ = _e468;
    } else {
        if (_e468 < -87f) {
            phi_1026_ = -87f;
        } else {
            phi_1026_ = _e468;
        }
        let _e630 = phi_1026_;
        if (_e630 > 88f) {
            phi_1031_ = 88f;
        } else {
            phi_1031_ = _e630;
        }
        let _e633 = phi_1031_;
        let _e635 = ((_e633 * 1.442695f) + 0.5f);
        if (_e635 > -8388608f) {
            let _e647 = f32(select(0i, select(select(i32(_e635), i32(-2147483648), (_e635 < bitcast<f32>(3472883712u))), 2147483647i, (_e635 > bitcast<f32>(1325400063u))), (_e635 == _e635)));
            if (_e647 > _e635) {
                phi_1053_ = 1f;
            } else {
                phi_1053_ = 0f;
            }
            let _e650 = phi_1053_;
            if (_e635 < 8388608f) {
                phi_1058_ = (_e647 - _e650);
                phi_1059_ = false;
            } else {
                phi_1058_ = f32();
                phi_1059_ = true;
            }
            let _e653 = phi_1058_;
            let _e655 = phi_1059_;
            phi_1060_ = _e653;
            phi_1061_ = _e655;
        } else {
            phi_1060_ = f32();
            phi_1061_ = true;
        }
        let _e657 = phi_1060_;
        let _e659 = phi_1061_;
        if _e659 {
            phi_1065_ = _e635;
        } else {
            phi_1065_ = _e657;
        }
        let _e661 = phi_1065_;
        let _e665 = ((_e633 - (_e661 * 0.69314575f)) - (_e661 * 0.0000014286068f));
        phi_1103_ = ((((((((((((((((1f / 5040f) * _e665) + (1f / 720f)) * _e665) + (1f / 120f)) * _e665) + (1f / 24f)) * _e665) + (1f / 6f)) * _e665) + 0.5f) * _e665) + 1f) * _e665) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e661), i32(-2147483648), (_e661 < bitcast<f32>(3472883712u))), 2147483647i, (_e661 > bitcast<f32>(1325400063u))), (_e661 == _e661)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e701 = phi_1103_;
    if ((bitcast<u32>(_e470) & 2147483647u) > 2139095040u) {
        phi_1191_ = _e470;
    } else {
        if (_e470 < -87f) {
            phi_1114_ = -87f;
        } else {
            phi_1114_ = _e470;
        }
        let _e707 = phi_1114_;
        if (_e707 > 88f) {
            phi_1119_ = 88f;
        } else {
            phi_1119_ = _e707;
        }
        let _e710 = phi_1119_;
        let _e712 = ((_e710 * 1.442695f) + 0.5f);
        if (_e712 > -8388608f) {
            let _e724 = f32(select(0i, select(select(i32(_e712), i32(-2147483648), (_e712 < bitcast<f32>(3472883712u))), 2147483647i, (_e712 > bitcast<f32>(1325400063u))), (_e712 == _e712)));
            if (_e724 > _e712) {
                phi_1141_ = 1f;
            } else {
                phi_1141_ = 0f;
            }
            let _e727 = phi_1141_;
            if (_e712 < 8388608f) {
                phi_1146_ = (_e724 - _e727);
                phi_1147_ = false;
            } else {
                phi_1146_ = f32();
                phi_1147_ = true;
            }
            let _e730 = phi_1146_;
            let _e732 = phi_1147_;
            phi_1148_ = _e730;
            phi_1149_ = _e732;
        } else {
            phi_1148_ = f32();
            phi_1149_ = true;
        }
        let _e734 = phi_1148_;
        let _e736 = phi_1149_;
        if _e736 {
            phi_1153_ = _e712;
        } else {
            phi_1153_ = _e734;
        }
        let _e738 = phi_1153_;
        let _e742 = ((_e710 - (_e738 * 0.69314575f)) - (_e738 * 0.0000014286068f));
        phi_1191_ = ((((((((((((((((1f / 5040f) * _e742) + (1f / 720f)) * _e742) + (1f / 120f)) * _e742) + (1f / 24f)) * _e742) + (1f / 6f)) * _e742) + 0.5f) * _e742) + 1f) * _e742) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e738), i32(-2147483648), (_e738 < bitcast<f32>(3472883712u))), 2147483647i, (_e738 > bitcast<f32>(1325400063u))), (_e738 == _e738)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e778 = phi_1191_;
    let _e780 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e547);
    let _e782 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e624);
    let _e784 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e701);
    let _e786 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e778);
    let _e788 = (*param_4).min_variance;
    let _e790 = ((_e788 * _e461) * _e461);
    let _e801 = ((((_e780 * param_6.x) + (_e782 * param_6.y)) + (_e784 * param_6.z)) + (_e786 * param_6.w));
    let _e802 = (_e780 - _e801);
    let _e803 = (_e782 - _e801);
    let _e804 = (_e784 - _e801);
    let _e805 = (_e786 - _e801);
    let _e820 = (((((_e802 * _e802) * param_6.x) + ((_e803 * _e803) * param_6.y)) + ((_e804 * _e804) * param_6.z)) + ((_e805 * _e805) * param_6.w));
    if ((bitcast<u32>(_e790) & 2147483647u) > 2139095040u) {
        phi_1244_ = true;
    } else {
        let _e824 = (_e790 > _e820);
        if _e824 {
        }
        phi_1244_ = _e824;
    }
    let _e826 = phi_1244_;
    if _e826 {
        phi_1248_ = _e790;
    } else {
        phi_1248_ = _e820;
    }
    let _e828 = phi_1248_;
    let _e829 = -(_e801);
    if (_e829 <= 0f) {
        let _e833 = ((bitcast<u32>(_e828) & 2147483647u) > 2139095040u);
        if _e833 {
        }
        phi_1260_ = _e833;
    } else {
        phi_1260_ = true;
    }
    let _e835 = phi_1260_;
    if _e835 {
        phi_1267_ = (_e828 / (_e828 + (_e829 * _e829)));
    } else {
        phi_1267_ = 1f;
    }
    let _e840 = phi_1267_;
    if ((bitcast<u32>(_e840) & 2147483647u) > 2139095040u) {
        phi_1278_ = true;
    } else {
        let _e844 = (_e840 < _e451);
        if _e844 {
        }
        phi_1278_ = _e844;
    }
    let _e846 = phi_1278_;
    if _e846 {
        phi_1282_ = _e840;
    } else {
        phi_1282_ = _e451;
    }
    let _e848 = phi_1282_;
    if ((bitcast<u32>(_e848) & 2147483647u) > 2139095040u) {
        phi_1299_ = _e848;
    } else {
        if (_e848 < 0f) {
            phi_1298_ = 0f;
        } else {
            if (_e848 > 1f) {
                phi_1297_ = 1f;
            } else {
                phi_1297_ = _e848;
            }
            let _e855 = phi_1297_;
            phi_1298_ = _e855;
        }
        let _e857 = phi_1298_;
        phi_1299_ = _e857;
    }
    let _e859 = phi_1299_;
    return _e859;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
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
    var phi_333_: bool;
    var phi_334_: bool;
    var phi_335_: bool;
    var phi_336_: bool;
    var phi_337_: bool;
    var phi_338_: bool;
    var phi_339_: bool;
    var phi_340_: bool;
    var phi_341_: bool;
    var phi_342_: bool;
    var phi_343_: bool;
    var phi_347_: bool;
    var phi_351_: bool;
    var phi_356_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_224_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_223_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_222_ = 1f;
            } else {
                phi_222_ = param_10;
            }
            let _e71 = phi_222_;
            phi_223_ = _e71;
        }
        let _e73 = phi_223_;
        phi_224_ = _e73;
    }
    let _e75 = phi_224_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_242_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_241_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_240_ = 1f;
            } else {
                phi_240_ = param_8.x;
            }
            let _e83 = phi_240_;
            phi_241_ = _e83;
        }
        let _e85 = phi_241_;
        phi_242_ = _e85;
    }
    let _e87 = phi_242_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_260_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_259_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_258_ = 1f;
            } else {
                phi_258_ = param_8.y;
            }
            let _e95 = phi_258_;
            phi_259_ = _e95;
        }
        let _e97 = phi_259_;
        phi_260_ = _e97;
    }
    let _e99 = phi_260_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_278_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_277_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_276_ = 1f;
            } else {
                phi_276_ = param_8.z;
            }
            let _e107 = phi_276_;
            phi_277_ = _e107;
        }
        let _e109 = phi_277_;
        phi_278_ = _e109;
    }
    let _e111 = phi_278_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_296_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_295_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_294_ = 1f;
            } else {
                phi_294_ = param_8.w;
            }
            let _e119 = phi_294_;
            phi_295_ = _e119;
        }
        let _e121 = phi_295_;
        phi_296_ = _e121;
    }
    let _e123 = phi_296_;
    let _e124 = (_e87 - _e75);
    let _e125 = (_e99 - _e75);
    let _e126 = (_e111 - _e75);
    let _e127 = (_e123 - _e75);
    if (_e124 >= 0f) {
        if (_e125 >= 0f) {
            if (_e126 >= 0f) {
                if (_e127 >= 0f) {
                    phi_333_ = !(((bitcast<u32>(((((_e124 * param_9.x) + (_e125 * param_9.y)) + (_e126 * param_9.z)) + (_e127 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_334_ = false;
                } else {
                    phi_333_ = bool();
                    phi_334_ = true;
                }
                let _e149 = phi_333_;
                let _e151 = phi_334_;
                phi_335_ = _e149;
                phi_336_ = false;
                phi_337_ = _e151;
            } else {
                phi_335_ = bool();
                phi_336_ = true;
                phi_337_ = false;
            }
            let _e153 = phi_335_;
            let _e155 = phi_336_;
            let _e157 = phi_337_;
            phi_338_ = _e153;
            phi_339_ = _e155;
            phi_340_ = _e157;
        } else {
            phi_338_ = bool();
            phi_339_ = true;
            phi_340_ = false;
        }
        let _e159 = phi_338_;
        let _e161 = phi_339_;
        let _e163 = phi_340_;
        phi_341_ = _e159;
        phi_342_ = _e161;
        phi_343_ = _e163;
    } else {
        phi_341_ = bool();
        phi_342_ = true;
        phi_343_ = false;
    }
    let _e165 = phi_341_;
    let _e167 = phi_342_;
    let _e169 = phi_343_;
    if _e167 {
        phi_347_ = true;
    } else {
        phi_347_ = _e169;
    }
    let _e171 = phi_347_;
    if _e171 {
        phi_351_ = false;
    } else {
        phi_351_ = _e165;
    }
    let _e173 = phi_351_;
    if _e173 {
        phi_356_ = 1f;
    } else {
        let _e174 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e124, _e125, _e126, _e127), param_9);
        phi_356_ = _e174;
    }
    let _e176 = phi_356_;
    return _e176;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_1354_: bool;
    var phi_1355_: bool;
    var phi_1356_: bool;
    var phi_1357_: bool;
    var phi_1361_: bool;
    var phi_1431_: bool;
    var phi_1432_: bool;
    var phi_1443_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1444_: bool;
    var phi_1445_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1446_: bool;
    var phi_1453_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1457_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1477_: lt_math_LightPoint;
    var phi_1480_: u32;
    var phi_1482_: lt_math_LevelPoint;
    var phi_1568_: bool;
    var phi_1577_: bool;
    var phi_1586_: bool;
    var phi_1587_: bool;
    var phi_1588_: bool;
    var phi_1589_: bool;
    var phi_1590_: bool;
    var phi_1591_: bool;
    var phi_1592_: bool;
    var phi_1596_: bool;
    var phi_1623_: bool;
    var phi_1624_: bool;
    var phi_1625_: bool;
    var phi_1626_: bool;
    var phi_1627_: bool;
    var phi_1628_: bool;
    var phi_1629_: bool;
    var phi_1630_: bool;
    var phi_1634_: bool;
    var phi_1643_: lt_math_LightPoint;
    var phi_1644_: u32;
    var phi_1645_: lt_math_LevelPoint;
    var phi_1646_: bool;
    var phi_1478_: lt_math_LightPoint;
    var phi_1481_: u32;
    var phi_1483_: lt_math_LevelPoint;
    var phi_1647_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1687_: bool;
    var phi_1688_: bool;
    var phi_1689_: bool;
    var phi_1690_: bool;
    var phi_1694_: bool;
    var phi_1776_: f32;
    var phi_1894_: f32;
    var phi_1895_: f32;
    var phi_1898_: f32;
    var phi_1927_: f32;
    var phi_1932_: f32;
    var phi_1933_: bool;
    var phi_1934_: f32;
    var phi_1935_: bool;
    var phi_1939_: f32;
    var phi_1959_: f32;
    var phi_1964_: f32;
    var phi_1965_: bool;
    var phi_1966_: f32;
    var phi_1967_: bool;
    var phi_1971_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_2024_: i32;
    var phi_2029_: i32;
    var phi_2034_: i32;
    var phi_2039_: i32;
    var phi_2048_: i32;
    var phi_2053_: i32;
    var phi_2058_: i32;
    var phi_2063_: i32;
    var phi_2116_: bool;
    var phi_2124_: bool;
    var phi_2136_: bool;
    var phi_2137_: bool;
    var phi_2141_: f32;
    var phi_2147_: f32;
    var phi_2149_: evaluate_Verdict;
    var phi_2159_: u32;
    var phi_2168_: f32;
    var phi_2170_: evaluate_Verdict;
    var phi_2171_: bool;
    var phi_2172_: evaluate_Verdict;
    var phi_2173_: bool;
    var phi_2178_: evaluate_Verdict;
    var phi_2183_: evaluate_Verdict;
    var phi_2184_: evaluate_Verdict;
    var phi_2188_: bool;
    var phi_2189_: u32;
    var phi_2200_: u32;
    var phi_2217_: u32;

    let _e62 = id_1;
    let _e63 = local_5;
    let _e68 = arrayLength((&map.member));
    let _e73 = arrayLength((&levels.member));
    let _e76 = p.member.size[0u];
    let _e78 = p.member.size[1u];
    let _e79 = lt_shaders_entry_pixel_index(_e62, _e76, _e78);
    if (bitcast<i32>(_e79.root) != 0i) {
        let _e86 = p.member.level_count;
        let _e90 = samples.member[_e79.first_primitive].normal[0u];
        let _e92 = global[0u];
        if (_e90 == _e92) {
            let _e95 = samples.member[_e79.first_primitive].normal[1u];
            let _e97 = global[1u];
            if (_e95 == _e97) {
                let _e100 = samples.member[_e79.first_primitive].normal[2u];
                let _e102 = global[2u];
                phi_1354_ = (_e100 == _e102);
                phi_1355_ = false;
            } else {
                phi_1354_ = bool();
                phi_1355_ = true;
            }
            let _e105 = phi_1354_;
            let _e107 = phi_1355_;
            phi_1356_ = _e105;
            phi_1357_ = _e107;
        } else {
            phi_1356_ = bool();
            phi_1357_ = true;
        }
        let _e109 = phi_1356_;
        let _e111 = phi_1357_;
        if _e111 {
            phi_1361_ = false;
        } else {
            phi_1361_ = _e109;
        }
        let _e113 = phi_1361_;
        if !(_e113) {
            let _e116 = samples.member[_e79.first_primitive].position;
            let _e118 = p.member.light.place;
            let _e124 = p.member.light.place[3u];
            let _e131 = (_e118.x - (_e116.x * _e124));
            let _e132 = (_e118.y - (_e116.y * _e124));
            let _e133 = (_e118.z - (_e116.z * _e124));
            let _e135 = samples.member[_e79.first_primitive].normal;
            if ((((_e135.x * _e131) + (_e135.y * _e132)) + (_e135.z * _e133)) > 0f) {
                let _e149 = (((_e131 * _e131) + (_e132 * _e132)) + (_e133 * _e133));
                let _e151 = p.member.light.axis;
                let _e163 = p.member.light.place[3u];
                if (_e163 == 0f) {
                    phi_1432_ = true;
                } else {
                    let _e166 = p.member.light.range_squared;
                    if (_e149 <= _e166) {
                        let _e169 = p.member.light.cos_outer;
                        phi_1431_ = (-((((_e131 * _e151.x) + (_e132 * _e151.y)) + (_e133 * _e151.z))) >= (_e169 * sqrt(_e149)));
                    } else {
                        phi_1431_ = false;
                    }
                    let _e174 = phi_1431_;
                    phi_1432_ = _e174;
                }
                let _e176 = phi_1432_;
                if _e176 {
                    let _e178 = samples.member[_e79.first_primitive].flags;
                    let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e186.unnamed.visibility, false), _e186.unnamed_1);
                    phi_1443_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e192.unnamed, ((_e178 & 1u) == 0u));
                    phi_1444_ = false;
                } else {
                    phi_1443_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1444_ = true;
                }
                let _e197 = phi_1443_;
                let _e199 = phi_1444_;
                phi_1445_ = _e197;
                phi_1446_ = _e199;
            } else {
                phi_1445_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1446_ = true;
            }
            let _e201 = phi_1445_;
            let _e203 = phi_1446_;
            if _e203 {
                let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e215 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e209.unnamed.visibility, false), _e209.unnamed_1);
                phi_1453_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e215.unnamed, true);
            } else {
                phi_1453_ = _e201;
            }
            let _e220 = phi_1453_;
            phi_1457_ = _e220;
        } else {
            let _e226 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e232 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e226.unnamed.visibility, false), _e226.unnamed_1);
            phi_1457_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e232.unnamed, true);
        }
        let _e237 = phi_1457_;
        if _e237.unnamed_1 {
            phi_2184_ = evaluate_Verdict(_e237.unnamed.visibility, _e237.unnamed.is_doubted);
        } else {
            let _e245 = samples.member[_e79.first_primitive].position;
            let _e247 = p.member.map_size;
            let _e249 = (0.5f / f32(_e247));
            let _e256 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e263 = lt_math_LightPoint(vec2<f32>(_e256.uv.x, 0f), _e256.depth, _e256.is_inside);
            let _e267 = lt_math_LightPoint(_e263.uv, 0f, _e263.is_inside);
            phi_1477_ = lt_math_LightPoint();
            phi_1480_ = 0u;
            phi_1482_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e267.uv, _e267.depth, false));
            loop {
                let _e274 = phi_1477_;
                let _e276 = phi_1480_;
                let _e278 = phi_1482_;
                local_2 = _e278;
                local_3 = _e278;
                local_4 = _e278;
                if (_e276 < _e86) {
                    if _e278.point.is_inside {
                        phi_1643_ = lt_math_LightPoint();
                        phi_1644_ = u32();
                        phi_1645_ = lt_math_LevelPoint();
                        phi_1646_ = false;
                    } else {
                        if (_e276 < _e73) {
                        } else {
                            return;
                        }
                        let _e289 = levels.member[(0u + _e276)].row_w;
                        let _e300 = ((((_e289.x * _e245.x) + (_e289.y * _e245.y)) + (_e289.z * _e245.z)) + (_e289.w * 1f));
                        let _e302 = levels.member[(0u + _e276)].row_x;
                        let _e314 = (((((_e302.x * _e245.x) + (_e302.y * _e245.y)) + (_e302.z * _e245.z)) + (_e302.w * 1f)) / _e300);
                        let _e316 = levels.member[(0u + _e276)].row_y;
                        let _e328 = (((((_e316.x * _e245.x) + (_e316.y * _e245.y)) + (_e316.z * _e245.z)) + (_e316.w * 1f)) / _e300);
                        let _e330 = levels.member[(0u + _e276)].row_z;
                        let _e341 = ((((_e330.x * _e245.x) + (_e330.y * _e245.y)) + (_e330.z * _e245.z)) + (_e330.w * 1f));
                        if (_e300 > 0f) {
                            if (_e314 >= 0f) {
                                phi_1568_ = (_e314 <= 1f);
                            } else {
                                phi_1568_ = false;
                            }
                            let _e346 = phi_1568_;
                            if _e346 {
                                if (_e328 >= 0f) {
                                    phi_1577_ = (_e328 <= 1f);
                                } else {
                                    phi_1577_ = false;
                                }
                                let _e350 = phi_1577_;
                                if _e350 {
                                    if (_e341 >= 0f) {
                                        phi_1586_ = (_e341 <= 1f);
                                    } else {
                                        phi_1586_ = false;
                                    }
                                    let _e354 = phi_1586_;
                                    phi_1587_ = _e354;
                                    phi_1588_ = false;
                                } else {
                                    phi_1587_ = bool();
                                    phi_1588_ = true;
                                }
                                let _e356 = phi_1587_;
                                let _e358 = phi_1588_;
                                phi_1589_ = _e356;
                                phi_1590_ = _e358;
                            } else {
                                phi_1589_ = bool();
                                phi_1590_ = true;
                            }
                            let _e360 = phi_1589_;
                            let _e362 = phi_1590_;
                            phi_1591_ = _e360;
                            phi_1592_ = _e362;
                        } else {
                            phi_1591_ = bool();
                            phi_1592_ = true;
                        }
                        let _e364 = phi_1591_;
                        let _e366 = phi_1592_;
                        if _e366 {
                            phi_1596_ = false;
                        } else {
                            phi_1596_ = _e364;
                        }
                        let _e368 = phi_1596_;
                        if _e368 {
                            if (_e314 >= _e249) {
                                if (_e314 <= (1f - _e249)) {
                                    if (_e328 >= _e249) {
                                        phi_1623_ = (_e328 <= (1f - _e249));
                                        phi_1624_ = false;
                                    } else {
                                        phi_1623_ = bool();
                                        phi_1624_ = true;
                                    }
                                    let _e376 = phi_1623_;
                                    let _e378 = phi_1624_;
                                    phi_1625_ = _e376;
                                    phi_1626_ = _e378;
                                } else {
                                    phi_1625_ = bool();
                                    phi_1626_ = true;
                                }
                                let _e380 = phi_1625_;
                                let _e382 = phi_1626_;
                                phi_1627_ = _e380;
                                phi_1628_ = _e382;
                            } else {
                                phi_1627_ = bool();
                                phi_1628_ = true;
                            }
                            let _e384 = phi_1627_;
                            let _e386 = phi_1628_;
                            phi_1629_ = _e384;
                            phi_1630_ = _e386;
                        } else {
                            phi_1629_ = bool();
                            phi_1630_ = true;
                        }
                        let _e388 = phi_1629_;
                        let _e390 = phi_1630_;
                        if _e390 {
                            phi_1634_ = false;
                        } else {
                            phi_1634_ = _e388;
                        }
                        let _e392 = phi_1634_;
                        let _e399 = lt_math_LightPoint(vec2<f32>(_e314, _e274.uv.y), _e274.depth, _e274.is_inside);
                        let _e406 = lt_math_LightPoint(vec2<f32>(_e399.uv.x, _e328), _e399.depth, _e399.is_inside);
                        let _e410 = lt_math_LightPoint(_e406.uv, _e341, _e406.is_inside);
                        let _e414 = lt_math_LightPoint(_e410.uv, _e410.depth, _e392);
                        phi_1643_ = _e414;
                        phi_1644_ = (_e276 + 1u);
                        phi_1645_ = lt_math_LevelPoint(_e276, _e414);
                        phi_1646_ = true;
                    }
                    let _e418 = phi_1643_;
                    let _e420 = phi_1644_;
                    let _e422 = phi_1645_;
                    let _e424 = phi_1646_;
                    phi_1478_ = _e418;
                    phi_1481_ = _e420;
                    phi_1483_ = _e422;
                    phi_1647_ = _e424;
                } else {
                    phi_1478_ = lt_math_LightPoint();
                    phi_1481_ = u32();
                    phi_1483_ = lt_math_LevelPoint();
                    phi_1647_ = false;
                }
                let _e426 = phi_1478_;
                let _e428 = phi_1481_;
                let _e430 = phi_1483_;
                let _e432 = phi_1647_;
                continue;
                continuing {
                    phi_1477_ = _e426;
                    phi_1480_ = _e428;
                    phi_1482_ = _e430;
                    break if !(_e432);
                }
            }
            let _e435 = local_2;
            if _e435.point.is_inside {
                if (0f > 0f) {
                    let _e441 = local_3;
                    if (_e441.level < _e73) {
                    } else {
                        return;
                    }
                    let _e446 = levels.member[(0u + _e441.level)];
                    let _e452 = global[0u];
                    if (_e446.row_w.x == _e452) {
                        let _e455 = global[1u];
                        if (_e446.row_w.y == _e455) {
                            let _e458 = global[2u];
                            phi_1687_ = (_e446.row_w.z == _e458);
                            phi_1688_ = false;
                        } else {
                            phi_1687_ = bool();
                            phi_1688_ = true;
                        }
                        let _e461 = phi_1687_;
                        let _e463 = phi_1688_;
                        phi_1689_ = _e461;
                        phi_1690_ = _e463;
                    } else {
                        phi_1689_ = bool();
                        phi_1690_ = true;
                    }
                    let _e465 = phi_1689_;
                    let _e467 = phi_1690_;
                    if _e467 {
                        phi_1694_ = false;
                    } else {
                        phi_1694_ = _e465;
                    }
                    let _e469 = phi_1694_;
                    if _e469 {
                        let _e471 = samples.member[_e79.first_primitive].normal;
                        let _e473 = p.member.map_size;
                        let _e543 = ((abs(((((_e446.row_x.x * _e471.x) + (_e446.row_x.y * _e471.y)) + (_e446.row_x.z * _e471.z)) / (((_e446.row_x.x * _e446.row_x.x) + (_e446.row_x.y * _e446.row_x.y)) + (_e446.row_x.z * _e446.row_x.z)))) + abs(((((_e446.row_y.x * _e471.x) + (_e446.row_y.y * _e471.y)) + (_e446.row_y.z * _e471.z)) / (((_e446.row_y.x * _e446.row_y.x) + (_e446.row_y.y * _e446.row_y.y)) + (_e446.row_y.z * _e446.row_y.z))))) / (abs(((((_e446.row_z.x * _e471.x) + (_e446.row_z.y * _e471.y)) + (_e446.row_z.z * _e471.z)) / (((_e446.row_z.x * _e446.row_z.x) + (_e446.row_z.y * _e446.row_z.y)) + (_e446.row_z.z * _e446.row_z.z)))) * f32(_e473)));
                        if (_e543 < 0.002f) {
                            phi_1776_ = _e543;
                        } else {
                            phi_1776_ = 0.002f;
                        }
                        let _e546 = phi_1776_;
                        phi_1895_ = _e546;
                    } else {
                        let _e548 = p.member.map_size;
                        let _e554 = samples.member[_e79.first_primitive].position;
                        let _e565 = ((((_e446.row_w.x * _e554.x) + (_e446.row_w.y * _e554.y)) + (_e446.row_w.z * _e554.z)) + _e446.row_w.w);
                        let _e578 = ((_e446.row_x.x - (_e446.row_w.x * _e435.point.uv.x)) / _e565);
                        let _e579 = ((_e446.row_x.y - (_e446.row_w.y * _e435.point.uv.x)) / _e565);
                        let _e580 = ((_e446.row_x.z - (_e446.row_w.z * _e435.point.uv.x)) / _e565);
                        let _e593 = ((_e446.row_y.x - (_e446.row_w.x * _e435.point.uv.y)) / _e565);
                        let _e594 = ((_e446.row_y.y - (_e446.row_w.y * _e435.point.uv.y)) / _e565);
                        let _e595 = ((_e446.row_y.z - (_e446.row_w.z * _e435.point.uv.y)) / _e565);
                        let _e601 = samples.member[_e79.first_primitive].normal;
                        let _e606 = ((_e594 * _e601.z) - (_e601.y * _e595));
                        let _e611 = ((_e595 * _e601.x) - (_e601.z * _e593));
                        let _e616 = ((_e593 * _e601.y) - (_e601.x * _e594));
                        let _e618 = samples.member[_e79.first_primitive].normal;
                        let _e623 = ((_e579 * _e618.z) - (_e618.y * _e580));
                        let _e628 = ((_e580 * _e618.x) - (_e618.z * _e578));
                        let _e633 = ((_e578 * _e618.y) - (_e618.x * _e579));
                        let _e660 = ((abs(((((_e446.row_z.x * _e606) + (_e446.row_z.y * _e611)) + (_e446.row_z.z * _e616)) / (((_e578 * _e606) + (_e579 * _e611)) + (_e580 * _e616)))) + abs(((((_e446.row_z.x * _e623) + (_e446.row_z.y * _e628)) + (_e446.row_z.z * _e633)) / (((_e593 * _e623) + (_e594 * _e628)) + (_e595 * _e633))))) / f32(_e548));
                        let _e662 = (16f / f32(_e548));
                        if (_e660 < _e662) {
                            phi_1894_ = _e660;
                        } else {
                            phi_1894_ = _e662;
                        }
                        let _e665 = phi_1894_;
                        phi_1895_ = _e665;
                    }
                    let _e667 = phi_1895_;
                    phi_1898_ = (_e435.point.depth - (0f * _e667));
                } else {
                    phi_1898_ = _e435.point.depth;
                }
                let _e671 = phi_1898_;
                let _e677 = p.member.map_size;
                let _e678 = f32(_e677);
                let _e681 = ((_e435.point.uv.x * _e678) - 0.5f);
                let _e682 = ((_e435.point.uv.y * _e678) - 0.5f);
                if (_e681 > -8388608f) {
                    let _e694 = f32(select(0i, select(select(i32(_e681), i32(-2147483648), (_e681 < bitcast<f32>(3472883712u))), 2147483647i, (_e681 > bitcast<f32>(1325400063u))), (_e681 == _e681)));
                    if (_e694 > _e681) {
                        phi_1927_ = 1f;
                    } else {
                        phi_1927_ = 0f;
                    }
                    let _e697 = phi_1927_;
                    if (_e681 < 8388608f) {
                        phi_1932_ = (_e694 - _e697);
                        phi_1933_ = false;
                    } else {
                        phi_1932_ = f32();
                        phi_1933_ = true;
                    }
                    let _e700 = phi_1932_;
                    let _e702 = phi_1933_;
                    phi_1934_ = _e700;
                    phi_1935_ = _e702;
                } else {
                    phi_1934_ = f32();
                    phi_1935_ = true;
                }
                let _e704 = phi_1934_;
                let _e706 = phi_1935_;
                if _e706 {
                    phi_1939_ = _e681;
                } else {
                    phi_1939_ = _e704;
                }
                let _e708 = phi_1939_;
                if (_e682 > -8388608f) {
                    let _e720 = f32(select(0i, select(select(i32(_e682), i32(-2147483648), (_e682 < bitcast<f32>(3472883712u))), 2147483647i, (_e682 > bitcast<f32>(1325400063u))), (_e682 == _e682)));
                    if (_e720 > _e682) {
                        phi_1959_ = 1f;
                    } else {
                        phi_1959_ = 0f;
                    }
                    let _e723 = phi_1959_;
                    if (_e682 < 8388608f) {
                        phi_1964_ = (_e720 - _e723);
                        phi_1965_ = false;
                    } else {
                        phi_1964_ = f32();
                        phi_1965_ = true;
                    }
                    let _e726 = phi_1964_;
                    let _e728 = phi_1965_;
                    phi_1966_ = _e726;
                    phi_1967_ = _e728;
                } else {
                    phi_1966_ = f32();
                    phi_1967_ = true;
                }
                let _e730 = phi_1966_;
                let _e732 = phi_1967_;
                if _e732 {
                    phi_1971_ = _e682;
                } else {
                    phi_1971_ = _e730;
                }
                let _e734 = phi_1971_;
                let _e735 = (_e681 - _e708);
                let _e736 = (_e682 - _e734);
                let _e745 = select(0i, select(select(i32(_e708), i32(-2147483648), (_e708 < bitcast<f32>(3472883712u))), 2147483647i, (_e708 > bitcast<f32>(1325400063u))), (_e708 == _e708));
                let _e754 = select(0i, select(select(i32(_e734), i32(-2147483648), (_e734 < bitcast<f32>(3472883712u))), 2147483647i, (_e734 > bitcast<f32>(1325400063u))), (_e734 == _e734));
                let _e765 = p.member.test;
                let _e766 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e765);
                let _e768 = p.member.map_size;
                let _e770 = local_4;
                local_1 = lt_math_Evsm(_e766.positive_exponent, _e766.negative_exponent, _e766.min_variance);
                let _e777 = ((_e770.level * _e768) * _e768);
                let _e779 = (bitcast<i32>(_e768) - 1i);
                if (_e745 > 0i) {
                    phi_2024_ = _e745;
                } else {
                    phi_2024_ = 0i;
                }
                let _e782 = phi_2024_;
                if (_e754 > 0i) {
                    phi_2029_ = _e754;
                } else {
                    phi_2029_ = 0i;
                }
                let _e785 = phi_2029_;
                if (_e782 < _e779) {
                    phi_2034_ = _e782;
                } else {
                    phi_2034_ = _e779;
                }
                let _e788 = phi_2034_;
                if (_e785 < _e779) {
                    phi_2039_ = _e785;
                } else {
                    phi_2039_ = _e779;
                }
                let _e791 = phi_2039_;
                let _e792 = bitcast<u32>(_e788);
                let _e794 = (_e745 + 1i);
                let _e795 = (_e754 + 1i);
                if (_e794 > 0i) {
                    phi_2048_ = _e794;
                } else {
                    phi_2048_ = 0i;
                }
                let _e798 = phi_2048_;
                if (_e795 > 0i) {
                    phi_2053_ = _e795;
                } else {
                    phi_2053_ = 0i;
                }
                let _e801 = phi_2053_;
                if (_e798 < _e779) {
                    phi_2058_ = _e798;
                } else {
                    phi_2058_ = _e779;
                }
                let _e804 = phi_2058_;
                if (_e801 < _e779) {
                    phi_2063_ = _e801;
                } else {
                    phi_2063_ = _e779;
                }
                let _e807 = phi_2063_;
                let _e808 = bitcast<u32>(_e804);
                let _e810 = (bitcast<u32>(_e791) * _e768);
                let _e811 = (bitcast<u32>(_e807) * _e768);
                let _e816 = ((_e810 + _e792) + _e777);
                let _e817 = ((_e810 + _e808) + _e777);
                let _e818 = ((_e811 + _e792) + _e777);
                let _e819 = ((_e811 + _e808) + _e777);
                if (_e816 < _e68) {
                } else {
                    return;
                }
                let _e823 = map.member[(0u + _e816)];
                if (_e817 < _e68) {
                } else {
                    return;
                }
                let _e827 = map.member[(0u + _e817)];
                if (_e818 < _e68) {
                } else {
                    return;
                }
                let _e831 = map.member[(0u + _e818)];
                if (_e819 < _e68) {
                } else {
                    return;
                }
                let _e835 = map.member[(0u + _e819)];
                let _e837 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e823, _e827, _e831, _e835), vec4<f32>(((1f - _e735) * (1f - _e736)), (_e735 * (1f - _e736)), ((1f - _e735) * _e736), (_e735 * _e736)), _e671);
                let _e841 = p.member.epsilon;
                if (_e837 <= _e841) {
                    phi_2116_ = true;
                } else {
                    phi_2116_ = (_e837 >= (1f - _e841));
                }
                let _e846 = phi_2116_;
                if ((bitcast<u32>(_e837) & 2147483647u) > 2139095040u) {
                    phi_2124_ = true;
                } else {
                    phi_2124_ = !(_e846);
                }
                let _e852 = phi_2124_;
                if _e852 {
                    if (_e837 > 0f) {
                        if (_e837 < 1f) {
                            phi_2136_ = false;
                        } else {
                            phi_2136_ = true;
                        }
                        let _e856 = phi_2136_;
                        phi_2137_ = _e856;
                    } else {
                        phi_2137_ = true;
                    }
                    let _e858 = phi_2137_;
                    if _e858 {
                        phi_2141_ = 0.5f;
                    } else {
                        phi_2141_ = _e837;
                    }
                    let _e860 = phi_2141_;
                    phi_2149_ = evaluate_Verdict(_e860, true);
                } else {
                    if (_e837 > 0.5f) {
                        phi_2147_ = 1f;
                    } else {
                        phi_2147_ = 0f;
                    }
                    let _e864 = phi_2147_;
                    phi_2149_ = evaluate_Verdict(_e864, false);
                }
                let _e867 = phi_2149_;
                let _e870 = (_e867.visibility < 0.5f);
                if _e867.is_doubted {
                    phi_2172_ = evaluate_Verdict();
                    phi_2173_ = true;
                } else {
                    if _e870 {
                        phi_2159_ = 2u;
                    } else {
                        phi_2159_ = 1u;
                    }
                    let _e872 = phi_2159_;
                    if ((0u & _e872) != 0u) {
                        if _e870 {
                            phi_2168_ = 0.000000059604645f;
                        } else {
                            phi_2168_ = 0.99999994f;
                        }
                        let _e876 = phi_2168_;
                        phi_2170_ = evaluate_Verdict(_e876, true);
                        phi_2171_ = false;
                    } else {
                        phi_2170_ = evaluate_Verdict();
                        phi_2171_ = true;
                    }
                    let _e879 = phi_2170_;
                    let _e881 = phi_2171_;
                    phi_2172_ = _e879;
                    phi_2173_ = _e881;
                }
                let _e883 = phi_2172_;
                let _e885 = phi_2173_;
                if _e885 {
                    phi_2178_ = evaluate_Verdict(_e867.visibility, _e867.is_doubted);
                } else {
                    phi_2178_ = _e883;
                }
                let _e888 = phi_2178_;
                phi_2183_ = evaluate_Verdict(_e888.visibility, _e888.is_doubted);
            } else {
                phi_2183_ = evaluate_Verdict(0.5f, true);
            }
            let _e894 = phi_2183_;
            phi_2184_ = _e894;
        }
        let _e896 = phi_2184_;
        visibility.member[_e79.first_primitive] = _e896.visibility;
        phi_2188_ = _e896.is_doubted;
        phi_2189_ = _e79.first_primitive;
    } else {
        phi_2188_ = false;
        phi_2189_ = 0u;
    }
    let _e901 = phi_2188_;
    let _e903 = phi_2189_;
    if (_e63 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e901 {
        let _e907 = atomicAdd((&shared_[0u]), 1u);
        phi_2200_ = _e907;
    } else {
        phi_2200_ = 0u;
    }
    let _e909 = phi_2200_;
    workgroupBarrier();
    if (_e63 == 0u) {
        let _e913 = atomicLoad((&shared_[0u]));
        let _e914 = atomicAdd((&list.member[3u]), _e913);
        atomicStore((&shared_[1u]), _e914);
    }
    workgroupBarrier();
    if _e901 {
        if false {
            phi_2217_ = (_e903 | 2147483648u);
        } else {
            phi_2217_ = _e903;
        }
        let _e918 = phi_2217_;
        let _e920 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e920) + _e909)]), _e918);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
