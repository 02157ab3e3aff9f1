struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct type_8 {
    member: array<u32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_24 {
    member: array<abi_Sample>,
}

struct type_28 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_37 {
    member: abi_ShadowParams,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct type_44 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_24;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_37;
@group(0) @binding(2) 
var<storage> map: type_28;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_28;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_44;
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_163_: lt_bvh_traverse_Tree;
    var phi_164_: bool;
    var phi_165_: lt_bvh_traverse_Tree;
    var phi_166_: bool;
    var phi_171_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_163_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_164_ = false;
        } else {
            phi_163_ = lt_bvh_traverse_Tree();
            phi_164_ = true;
        }
        let _e60 = phi_163_;
        let _e62 = phi_164_;
        phi_165_ = _e60;
        phi_166_ = _e62;
    } else {
        phi_165_ = lt_bvh_traverse_Tree();
        phi_166_ = true;
    }
    let _e64 = phi_165_;
    let _e66 = phi_166_;
    if _e66 {
        phi_171_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_171_ = _e64;
    }
    let _e71 = phi_171_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_positive(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_201_: bool;
    var phi_205_: f32;
    var phi_206_: f32;

    let _e49 = (*param_4).positive_exponent;
    if ((bitcast<u32>(_e49) & 2147483647u) > 2139095040u) {
        phi_206_ = _e49;
    } else {
        if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
            phi_201_ = true;
        } else {
            let _e56 = (42f < _e49);
            if _e56 {
            }
            phi_201_ = _e56;
        }
        let _e58 = phi_201_;
        if _e58 {
            phi_205_ = 42f;
        } else {
            phi_205_ = _e49;
        }
        let _e60 = phi_205_;
        phi_206_ = _e60;
    }
    let _e62 = phi_206_;
    return _e62;
}

fn _lt_math_evsm_Evsm_negative(param_5: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_227_: bool;
    var phi_231_: f32;
    var phi_232_: f32;

    let _e49 = (*param_5).negative_exponent;
    if ((bitcast<u32>(_e49) & 2147483647u) > 2139095040u) {
        phi_232_ = _e49;
    } else {
        if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
            phi_227_ = true;
        } else {
            let _e56 = (42f < _e49);
            if _e56 {
            }
            phi_227_ = _e56;
        }
        let _e58 = phi_227_;
        if _e58 {
            phi_231_ = 42f;
        } else {
            phi_231_ = _e49;
        }
        let _e60 = phi_231_;
        phi_232_ = _e60;
    }
    let _e62 = phi_232_;
    return _e62;
}

fn lt_shaders_evaluate_to_light(param_6: vec3<f32>, param_7: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_7.x - (param_6.x * param_7.w)), (param_7.y - (param_6.y * param_7.w)), (param_7.z - (param_6.z * param_7.w)));
}

fn lt_shaders_evaluate_quad_indices(param_8: i32, param_9: i32, param_10: u32) -> array<u32, 4> {
    var phi_260_: i32;
    var phi_265_: i32;
    var phi_270_: i32;
    var phi_275_: i32;
    var phi_284_: i32;
    var phi_289_: i32;
    var phi_294_: i32;
    var phi_299_: i32;

    let _e51 = (bitcast<i32>(param_10) - 1i);
    if (param_8 > 0i) {
        phi_260_ = param_8;
    } else {
        phi_260_ = 0i;
    }
    let _e54 = phi_260_;
    if (param_9 > 0i) {
        phi_265_ = param_9;
    } else {
        phi_265_ = 0i;
    }
    let _e57 = phi_265_;
    if (_e54 < _e51) {
        phi_270_ = _e54;
    } else {
        phi_270_ = _e51;
    }
    let _e60 = phi_270_;
    if (_e57 < _e51) {
        phi_275_ = _e57;
    } else {
        phi_275_ = _e51;
    }
    let _e63 = phi_275_;
    let _e64 = bitcast<u32>(_e60);
    let _e66 = (param_8 + 1i);
    let _e67 = (param_9 + 1i);
    if (_e66 > 0i) {
        phi_284_ = _e66;
    } else {
        phi_284_ = 0i;
    }
    let _e70 = phi_284_;
    if (_e67 > 0i) {
        phi_289_ = _e67;
    } else {
        phi_289_ = 0i;
    }
    let _e73 = phi_289_;
    if (_e70 < _e51) {
        phi_294_ = _e70;
    } else {
        phi_294_ = _e51;
    }
    let _e76 = phi_294_;
    if (_e73 < _e51) {
        phi_299_ = _e73;
    } else {
        phi_299_ = _e51;
    }
    let _e79 = phi_299_;
    let _e80 = bitcast<u32>(_e76);
    let _e82 = (bitcast<u32>(_e63) * param_10);
    let _e83 = (bitcast<u32>(_e79) * param_10);
    return array<u32, 4>((_e82 + _e64), (_e82 + _e80), (_e83 + _e64), (_e83 + _e80));
}

fn lt_math_evsm_warp(param_11: vec4<f32>, param_12: f32) -> vec4<f32> {
    var phi_653_: bool;
    var phi_657_: f32;
    var phi_658_: f32;
    var phi_675_: bool;
    var phi_679_: f32;
    var phi_680_: f32;
    var phi_721_: f32;
    var phi_746_: bool;
    var phi_750_: f32;
    var phi_751_: f32;
    var phi_768_: bool;
    var phi_772_: f32;
    var phi_773_: f32;
    var phi_814_: f32;
    var phi_839_: bool;
    var phi_843_: f32;
    var phi_844_: f32;
    var phi_861_: bool;
    var phi_865_: f32;
    var phi_866_: f32;
    var phi_907_: f32;
    var phi_932_: bool;
    var phi_936_: f32;
    var phi_937_: f32;
    var phi_954_: bool;
    var phi_958_: f32;
    var phi_959_: f32;
    var phi_1000_: f32;

    let _e50 = (param_12 * param_11.x);
    if ((bitcast<u32>(_e50) & 2147483647u) > 2139095040u) {
        phi_721_ = _e50;
    } else {
        if ((bitcast<u32>(_e50) & 2147483647u) > 2139095040u) {
            phi_658_ = _e50;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_653_ = true;
            } else {
                let _e60 = (-87f > _e50);
                if _e60 {
                }
                phi_653_ = _e60;
            }
            let _e62 = phi_653_;
            if _e62 {
                phi_657_ = -87f;
            } else {
                phi_657_ = _e50;
            }
            let _e64 = phi_657_;
            phi_658_ = _e64;
        }
        let _e66 = phi_658_;
        if ((bitcast<u32>(_e66) & 2147483647u) > 2139095040u) {
            phi_680_ = _e66;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_675_ = true;
            } else {
                let _e73 = (88f < _e66);
                if _e73 {
                }
                phi_675_ = _e73;
            }
            let _e75 = phi_675_;
            if _e75 {
                phi_679_ = 88f;
            } else {
                phi_679_ = _e66;
            }
            let _e77 = phi_679_;
            phi_680_ = _e77;
        }
        let _e79 = phi_680_;
        let _e82 = floor(((_e79 * 1.442695f) + 0.5f));
        let _e86 = ((_e79 - (_e82 * 0.69314575f)) - (_e82 * 0.0000014286068f));
        phi_721_ = ((((((((((((((((1f / 5040f) * _e86) + (1f / 720f)) * _e86) + (1f / 120f)) * _e86) + (1f / 24f)) * _e86) + (1f / 6f)) * _e86) + 0.5f) * _e86) + 1f) * _e86) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e82), i32(-2147483648), (_e82 < bitcast<f32>(3472883712u))), 2147483647i, (_e82 > bitcast<f32>(1325400063u))), (_e82 == _e82)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e122 = phi_721_;
    let _e124 = (param_12 * param_11.y);
    if ((bitcast<u32>(_e124) & 2147483647u) > 2139095040u) {
        phi_814_ = _e124;
    } else {
        if ((bitcast<u32>(_e124) & 2147483647u) > 2139095040u) {
            phi_751_ = _e124;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_746_ = true;
            } else {
                let _e134 = (-87f > _e124);
                if _e134 {
                }
                phi_746_ = _e134;
            }
            let _e136 = phi_746_;
            if _e136 {
                phi_750_ = -87f;
            } else {
                phi_750_ = _e124;
            }
            let _e138 = phi_750_;
            phi_751_ = _e138;
        }
        let _e140 = phi_751_;
        if ((bitcast<u32>(_e140) & 2147483647u) > 2139095040u) {
            phi_773_ = _e140;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_768_ = true;
            } else {
                let _e147 = (88f < _e140);
                if _e147 {
                }
                phi_768_ = _e147;
            }
            let _e149 = phi_768_;
            if _e149 {
                phi_772_ = 88f;
            } else {
                phi_772_ = _e140;
            }
            let _e151 = phi_772_;
            phi_773_ = _e151;
        }
        let _e153 = phi_773_;
        let _e156 = floor(((_e153 * 1.442695f) + 0.5f));
        let _e160 = ((_e153 - (_e156 * 0.69314575f)) - (_e156 * 0.0000014286068f));
        phi_814_ = ((((((((((((((((1f / 5040f) * _e160) + (1f / 720f)) * _e160) + (1f / 120f)) * _e160) + (1f / 24f)) * _e160) + (1f / 6f)) * _e160) + 0.5f) * _e160) + 1f) * _e160) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e156), i32(-2147483648), (_e156 < bitcast<f32>(3472883712u))), 2147483647i, (_e156 > bitcast<f32>(1325400063u))), (_e156 == _e156)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e196 = phi_814_;
    let _e198 = (param_12 * param_11.z);
    if ((bitcast<u32>(_e198) & 2147483647u) > 2139095040u) {
        phi_907_ = _e198;
    } else {
        if ((bitcast<u32>(_e198) & 2147483647u) > 2139095040u) {
            phi_844_ = _e198;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_839_ = true;
            } else {
                let _e208 = (-87f > _e198);
                if _e208 {
                }
                phi_839_ = _e208;
            }
            let _e210 = phi_839_;
            if _e210 {
                phi_843_ = -87f;
            } else {
                phi_843_ = _e198;
            }
            let _e212 = phi_843_;
            phi_844_ = _e212;
        }
        let _e214 = phi_844_;
        if ((bitcast<u32>(_e214) & 2147483647u) > 2139095040u) {
            phi_866_ = _e214;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_861_ = true;
            } else {
                let _e221 = (88f < _e214);
                if _e221 {
                }
                phi_861_ = _e221;
            }
            let _e223 = phi_861_;
            if _e223 {
                phi_865_ = 88f;
            } else {
                phi_865_ = _e214;
            }
            let _e225 = phi_865_;
            phi_866_ = _e225;
        }
        let _e227 = phi_866_;
        let _e230 = floor(((_e227 * 1.442695f) + 0.5f));
        let _e234 = ((_e227 - (_e230 * 0.69314575f)) - (_e230 * 0.0000014286068f));
        phi_907_ = ((((((((((((((((1f / 5040f) * _e234) + (1f / 720f)) * _e234) + (1f / 120f)) * _e234) + (1f / 24f)) * _e234) + (1f / 6f)) * _e234) + 0.5f) * _e234) + 1f) * _e234) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e230), i32(-2147483648), (_e230 < bitcast<f32>(3472883712u))), 2147483647i, (_e230 > bitcast<f32>(1325400063u))), (_e230 == _e230)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e270 = phi_907_;
    let _e272 = (param_12 * param_11.w);
    if ((bitcast<u32>(_e272) & 2147483647u) > 2139095040u) {
        phi_1000_ = _e272;
    } else {
        if ((bitcast<u32>(_e272) & 2147483647u) > 2139095040u) {
            phi_937_ = _e272;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_932_ = true;
            } else {
                let _e282 = (-87f > _e272);
                if _e282 {
                }
                phi_932_ = _e282;
            }
            let _e284 = phi_932_;
            if _e284 {
                phi_936_ = -87f;
            } else {
                phi_936_ = _e272;
            }
            let _e286 = phi_936_;
            phi_937_ = _e286;
        }
        let _e288 = phi_937_;
        if ((bitcast<u32>(_e288) & 2147483647u) > 2139095040u) {
            phi_959_ = _e288;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_954_ = true;
            } else {
                let _e295 = (88f < _e288);
                if _e295 {
                }
                phi_954_ = _e295;
            }
            let _e297 = phi_954_;
            if _e297 {
                phi_958_ = 88f;
            } else {
                phi_958_ = _e288;
            }
            let _e299 = phi_958_;
            phi_959_ = _e299;
        }
        let _e301 = phi_959_;
        let _e304 = floor(((_e301 * 1.442695f) + 0.5f));
        let _e308 = ((_e301 - (_e304 * 0.69314575f)) - (_e304 * 0.0000014286068f));
        phi_1000_ = ((((((((((((((((1f / 5040f) * _e308) + (1f / 720f)) * _e308) + (1f / 120f)) * _e308) + (1f / 24f)) * _e308) + (1f / 6f)) * _e308) + 0.5f) * _e308) + 1f) * _e308) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e304), i32(-2147483648), (_e304 < bitcast<f32>(3472883712u))), 2147483647i, (_e304 > bitcast<f32>(1325400063u))), (_e304 == _e304)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e344 = phi_1000_;
    return vec4<f32>(_e122, _e196, _e270, _e344);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_13: ptr<function, lt_math_Evsm>, param_14: vec4<f32>, param_15: vec4<f32>, param_16: f32) -> f32 {
    var phi_328_: f32;
    var phi_329_: f32;
    var phi_330_: f32;
    var phi_346_: f32;
    var phi_347_: f32;
    var phi_348_: f32;
    var phi_365_: f32;
    var phi_366_: f32;
    var phi_367_: f32;
    var phi_384_: f32;
    var phi_385_: f32;
    var phi_386_: f32;
    var phi_403_: f32;
    var phi_404_: f32;
    var phi_405_: f32;
    var phi_472_: bool;
    var phi_476_: f32;
    var phi_477_: f32;
    var phi_489_: bool;
    var phi_496_: f32;
    var phi_562_: bool;
    var phi_566_: f32;
    var phi_567_: f32;
    var phi_579_: bool;
    var phi_586_: f32;
    var phi_603_: bool;
    var phi_607_: f32;
    var phi_608_: f32;
    var phi_623_: f32;
    var phi_624_: f32;
    var phi_625_: f32;

    if ((bitcast<u32>(param_16) & 2147483647u) > 2139095040u) {
        phi_330_ = param_16;
    } else {
        if (param_16 < 0f) {
            phi_329_ = 0f;
        } else {
            if (param_16 > 1f) {
                phi_328_ = 1f;
            } else {
                phi_328_ = param_16;
            }
            let _e57 = phi_328_;
            phi_329_ = _e57;
        }
        let _e59 = phi_329_;
        phi_330_ = _e59;
    }
    let _e61 = phi_330_;
    if ((bitcast<u32>(param_14.x) & 2147483647u) > 2139095040u) {
        phi_348_ = param_14.x;
    } else {
        if (param_14.x < 0f) {
            phi_347_ = 0f;
        } else {
            if (param_14.x > 1f) {
                phi_346_ = 1f;
            } else {
                phi_346_ = param_14.x;
            }
            let _e69 = phi_346_;
            phi_347_ = _e69;
        }
        let _e71 = phi_347_;
        phi_348_ = _e71;
    }
    let _e73 = phi_348_;
    if ((bitcast<u32>(param_14.y) & 2147483647u) > 2139095040u) {
        phi_367_ = param_14.y;
    } else {
        if (param_14.y < 0f) {
            phi_366_ = 0f;
        } else {
            if (param_14.y > 1f) {
                phi_365_ = 1f;
            } else {
                phi_365_ = param_14.y;
            }
            let _e82 = phi_365_;
            phi_366_ = _e82;
        }
        let _e84 = phi_366_;
        phi_367_ = _e84;
    }
    let _e86 = phi_367_;
    if ((bitcast<u32>(param_14.z) & 2147483647u) > 2139095040u) {
        phi_386_ = param_14.z;
    } else {
        if (param_14.z < 0f) {
            phi_385_ = 0f;
        } else {
            if (param_14.z > 1f) {
                phi_384_ = 1f;
            } else {
                phi_384_ = param_14.z;
            }
            let _e95 = phi_384_;
            phi_385_ = _e95;
        }
        let _e97 = phi_385_;
        phi_386_ = _e97;
    }
    let _e99 = phi_386_;
    if ((bitcast<u32>(param_14.w) & 2147483647u) > 2139095040u) {
        phi_405_ = param_14.w;
    } else {
        if (param_14.w < 0f) {
            phi_404_ = 0f;
        } else {
            if (param_14.w > 1f) {
                phi_403_ = 1f;
            } else {
                phi_403_ = param_14.w;
            }
            let _e108 = phi_403_;
            phi_404_ = _e108;
        }
        let _e110 = phi_404_;
        phi_405_ = _e110;
    }
    let _e112 = phi_405_;
    let _e114 = vec4<f32>((_e73 - _e61), (_e86 - _e61), (_e99 - _e61), (_e112 - _e61));
    let _e115 = _lt_math_evsm_Evsm_positive(param_13);
    let _e116 = lt_math_evsm_warp(_e114, _e115);
    let _e119 = (_e116.x - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e122 = (_e116.y - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e125 = (_e116.z - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e128 = (_e116.w - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e130 = (*param_13).min_variance;
    let _e132 = ((_e130 * _e115) * _e115);
    let _e143 = ((((_e119 * param_15.x) + (_e122 * param_15.y)) + (_e125 * param_15.z)) + (_e128 * param_15.w));
    let _e144 = (_e119 - _e143);
    let _e145 = (_e122 - _e143);
    let _e146 = (_e125 - _e143);
    let _e147 = (_e128 - _e143);
    let _e162 = (((((_e144 * _e144) * param_15.x) + ((_e145 * _e145) * param_15.y)) + ((_e146 * _e146) * param_15.z)) + ((_e147 * _e147) * param_15.w));
    if ((bitcast<u32>(_e162) & 2147483647u) > 2139095040u) {
        phi_477_ = _e162;
    } else {
        if ((bitcast<u32>(_e132) & 2147483647u) > 2139095040u) {
            phi_472_ = true;
        } else {
            let _e169 = (_e132 > _e162);
            if _e169 {
            }
            phi_472_ = _e169;
        }
        let _e171 = phi_472_;
        if _e171 {
            phi_476_ = _e132;
        } else {
            phi_476_ = _e162;
        }
        let _e173 = phi_476_;
        phi_477_ = _e173;
    }
    let _e175 = phi_477_;
    let _e176 = -(_e143);
    if (_e176 <= 0f) {
        let _e180 = ((bitcast<u32>(_e175) & 2147483647u) > 2139095040u);
        if _e180 {
        }
        phi_489_ = _e180;
    } else {
        phi_489_ = true;
    }
    let _e182 = phi_489_;
    if _e182 {
        phi_496_ = (_e175 / (_e175 + (_e176 * _e176)));
    } else {
        phi_496_ = 1f;
    }
    let _e187 = phi_496_;
    let _e188 = _lt_math_evsm_Evsm_negative(param_13);
    let _e190 = lt_math_evsm_warp(_e114, -(_e188));
    let _e193 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e190.x);
    let _e196 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e190.y);
    let _e199 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e190.z);
    let _e202 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e190.w);
    let _e204 = (*param_13).min_variance;
    let _e206 = ((_e204 * _e188) * _e188);
    let _e217 = ((((_e193 * param_15.x) + (_e196 * param_15.y)) + (_e199 * param_15.z)) + (_e202 * param_15.w));
    let _e218 = (_e193 - _e217);
    let _e219 = (_e196 - _e217);
    let _e220 = (_e199 - _e217);
    let _e221 = (_e202 - _e217);
    let _e236 = (((((_e218 * _e218) * param_15.x) + ((_e219 * _e219) * param_15.y)) + ((_e220 * _e220) * param_15.z)) + ((_e221 * _e221) * param_15.w));
    if ((bitcast<u32>(_e236) & 2147483647u) > 2139095040u) {
        phi_567_ = _e236;
    } else {
        if ((bitcast<u32>(_e206) & 2147483647u) > 2139095040u) {
            phi_562_ = true;
        } else {
            let _e243 = (_e206 > _e236);
            if _e243 {
            }
            phi_562_ = _e243;
        }
        let _e245 = phi_562_;
        if _e245 {
            phi_566_ = _e206;
        } else {
            phi_566_ = _e236;
        }
        let _e247 = phi_566_;
        phi_567_ = _e247;
    }
    let _e249 = phi_567_;
    let _e250 = -(_e217);
    if (_e250 <= 0f) {
        let _e254 = ((bitcast<u32>(_e249) & 2147483647u) > 2139095040u);
        if _e254 {
        }
        phi_579_ = _e254;
    } else {
        phi_579_ = true;
    }
    let _e256 = phi_579_;
    if _e256 {
        phi_586_ = (_e249 / (_e249 + (_e250 * _e250)));
    } else {
        phi_586_ = 1f;
    }
    let _e261 = phi_586_;
    if ((bitcast<u32>(_e187) & 2147483647u) > 2139095040u) {
        phi_608_ = _e187;
    } else {
        if ((bitcast<u32>(_e261) & 2147483647u) > 2139095040u) {
            phi_603_ = true;
        } else {
            let _e268 = (_e261 < _e187);
            if _e268 {
            }
            phi_603_ = _e268;
        }
        let _e270 = phi_603_;
        if _e270 {
            phi_607_ = _e261;
        } else {
            phi_607_ = _e187;
        }
        let _e272 = phi_607_;
        phi_608_ = _e272;
    }
    let _e274 = phi_608_;
    if ((bitcast<u32>(_e274) & 2147483647u) > 2139095040u) {
        phi_625_ = _e274;
    } else {
        if (_e274 < 0f) {
            phi_624_ = 0f;
        } else {
            if (_e274 > 1f) {
                phi_623_ = 1f;
            } else {
                phi_623_ = _e274;
            }
            let _e281 = phi_623_;
            phi_624_ = _e281;
        }
        let _e283 = phi_624_;
        phi_625_ = _e283;
    }
    let _e285 = phi_625_;
    return _e285;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_1055_: bool;
    var phi_1056_: bool;
    var phi_1057_: bool;
    var phi_1058_: bool;
    var phi_1062_: bool;
    var phi_1097_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1101_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1194_: bool;
    var phi_1195_: bool;
    var phi_1196_: bool;
    var phi_1197_: bool;
    var phi_1198_: bool;
    var phi_1199_: bool;
    var phi_1200_: bool;
    var phi_1201_: bool;
    var phi_1202_: bool;
    var phi_1203_: bool;
    var phi_1204_: bool;
    var phi_1205_: bool;
    var phi_1209_: bool;
    var phi_1314_: bool;
    var phi_1322_: bool;
    var phi_1327_: f32;
    var phi_1330_: evaluate_Verdict;
    var phi_1331_: evaluate_Verdict;
    var phi_1335_: bool;
    var phi_1336_: u32;
    var phi_1342_: u32;

    let _e48 = id_1;
    let _e49 = local_2;
    let _e54 = arrayLength((&map.member));
    if (_e49 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e61 = p.member.size[0u];
    let _e63 = p.member.size[1u];
    let _e64 = lt_shaders_entry_pixel_index(_e48, _e61, _e63);
    if (bitcast<i32>(_e64.root) != 0i) {
        let _e71 = p.member.light;
        let _e74 = samples.member[_e64.first_primitive].normal[0u];
        let _e76 = global[0u];
        if (_e74 == _e76) {
            let _e79 = samples.member[_e64.first_primitive].normal[1u];
            let _e81 = global[1u];
            if (_e79 == _e81) {
                let _e84 = samples.member[_e64.first_primitive].normal[2u];
                let _e86 = global[2u];
                phi_1055_ = (_e84 == _e86);
                phi_1056_ = false;
            } else {
                phi_1055_ = bool();
                phi_1056_ = true;
            }
            let _e89 = phi_1055_;
            let _e91 = phi_1056_;
            phi_1057_ = _e89;
            phi_1058_ = _e91;
        } else {
            phi_1057_ = bool();
            phi_1058_ = true;
        }
        let _e93 = phi_1057_;
        let _e95 = phi_1058_;
        if _e95 {
            phi_1062_ = false;
        } else {
            phi_1062_ = _e93;
        }
        let _e97 = phi_1062_;
        if !(_e97) {
            let _e100 = samples.member[_e64.first_primitive].normal;
            let _e102 = samples.member[_e64.first_primitive].position;
            let _e103 = lt_shaders_evaluate_to_light(_e102, _e71);
            if ((((_e100.x * _e103.x) + (_e100.y * _e103.y)) + (_e100.z * _e103.z)) > 0f) {
                let _e117 = samples.member[_e64.first_primitive].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_1097_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_1097_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_1097_;
            phi_1101_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_1101_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_1101_;
        if _e168.unnamed_1 {
            phi_1331_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
        } else {
            let _e176 = samples.member[_e64.first_primitive].position;
            let _e182 = p.member.projection.row_w;
            let _e193 = ((((_e182.x * _e176.x) + (_e182.y * _e176.y)) + (_e182.z * _e176.z)) + (_e182.w * 1f));
            let _e195 = p.member.projection.row_x;
            let _e207 = (((((_e195.x * _e176.x) + (_e195.y * _e176.y)) + (_e195.z * _e176.z)) + (_e195.w * 1f)) / _e193);
            let _e209 = p.member.projection.row_y;
            let _e221 = (((((_e209.x * _e176.x) + (_e209.y * _e176.y)) + (_e209.z * _e176.z)) + (_e209.w * 1f)) / _e193);
            let _e223 = p.member.projection.row_z;
            let _e234 = ((((_e223.x * _e176.x) + (_e223.y * _e176.y)) + (_e223.z * _e176.z)) + (_e223.w * 1f));
            if (_e193 > 0f) {
                if (_e207 >= 0f) {
                    if (_e207 <= 1f) {
                        if (_e221 >= 0f) {
                            if (_e221 <= 1f) {
                                if (_e234 >= 0f) {
                                    phi_1194_ = (_e234 <= 1f);
                                    phi_1195_ = false;
                                } else {
                                    phi_1194_ = bool();
                                    phi_1195_ = true;
                                }
                                let _e243 = phi_1194_;
                                let _e245 = phi_1195_;
                                phi_1196_ = _e243;
                                phi_1197_ = _e245;
                            } else {
                                phi_1196_ = bool();
                                phi_1197_ = true;
                            }
                            let _e247 = phi_1196_;
                            let _e249 = phi_1197_;
                            phi_1198_ = _e247;
                            phi_1199_ = _e249;
                        } else {
                            phi_1198_ = bool();
                            phi_1199_ = true;
                        }
                        let _e251 = phi_1198_;
                        let _e253 = phi_1199_;
                        phi_1200_ = _e251;
                        phi_1201_ = _e253;
                    } else {
                        phi_1200_ = bool();
                        phi_1201_ = true;
                    }
                    let _e255 = phi_1200_;
                    let _e257 = phi_1201_;
                    phi_1202_ = _e255;
                    phi_1203_ = _e257;
                } else {
                    phi_1202_ = bool();
                    phi_1203_ = true;
                }
                let _e259 = phi_1202_;
                let _e261 = phi_1203_;
                phi_1204_ = _e259;
                phi_1205_ = _e261;
            } else {
                phi_1204_ = bool();
                phi_1205_ = true;
            }
            let _e263 = phi_1204_;
            let _e265 = phi_1205_;
            if _e265 {
                phi_1209_ = false;
            } else {
                phi_1209_ = _e263;
            }
            let _e267 = phi_1209_;
            if _e267 {
                let _e269 = p.member.map_size;
                let _e270 = f32(_e269);
                let _e273 = ((_e207 * _e270) - 0.5f);
                let _e274 = ((_e221 * _e270) - 0.5f);
                let _e275 = floor(_e273);
                let _e276 = floor(_e274);
                let _e277 = (_e273 - _e275);
                let _e278 = (_e274 - _e276);
                let _e307 = p.member.test;
                let _e308 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e307);
                let _e310 = p.member.map_size;
                local_1 = lt_math_Evsm(_e308.positive_exponent, _e308.negative_exponent, _e308.min_variance);
                let _e315 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e275), i32(-2147483648), (_e275 < bitcast<f32>(3472883712u))), 2147483647i, (_e275 > bitcast<f32>(1325400063u))), (_e275 == _e275)), select(0i, select(select(i32(_e276), i32(-2147483648), (_e276 < bitcast<f32>(3472883712u))), 2147483647i, (_e276 > bitcast<f32>(1325400063u))), (_e276 == _e276)), _e310);
                if (_e315[0] < _e54) {
                } else {
                    return;
                }
                let _e320 = map.member[(0u + _e315[0])];
                if (_e315[1] < _e54) {
                } else {
                    return;
                }
                let _e325 = map.member[(0u + _e315[1])];
                if (_e315[2] < _e54) {
                } else {
                    return;
                }
                let _e330 = map.member[(0u + _e315[2])];
                if (_e315[3] < _e54) {
                } else {
                    return;
                }
                let _e335 = map.member[(0u + _e315[3])];
                let _e337 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e320, _e325, _e330, _e335), vec4<f32>(((1f - _e277) * (1f - _e278)), (_e277 * (1f - _e278)), ((1f - _e277) * _e278), (_e277 * _e278)), _e234);
                let _e339 = p.member.epsilon;
                if (_e337 <= _e339) {
                    phi_1314_ = true;
                } else {
                    phi_1314_ = (_e337 >= (1f - _e339));
                }
                let _e344 = phi_1314_;
                if ((bitcast<u32>(_e337) & 2147483647u) > 2139095040u) {
                    phi_1322_ = true;
                } else {
                    phi_1322_ = !(_e344);
                }
                let _e350 = phi_1322_;
                if (_e337 > 0.5f) {
                    phi_1327_ = 1f;
                } else {
                    phi_1327_ = 0f;
                }
                let _e353 = phi_1327_;
                phi_1330_ = evaluate_Verdict(_e353, _e350);
            } else {
                phi_1330_ = evaluate_Verdict(1f, true);
            }
            let _e357 = phi_1330_;
            phi_1331_ = _e357;
        }
        let _e359 = phi_1331_;
        visibility.member[_e64.first_primitive] = _e359.visibility;
        phi_1335_ = _e359.is_doubted;
        phi_1336_ = _e64.first_primitive;
    } else {
        phi_1335_ = false;
        phi_1336_ = 0u;
    }
    let _e364 = phi_1335_;
    let _e366 = phi_1336_;
    if _e364 {
        let _e368 = atomicAdd((&shared_[0u]), 1u);
        phi_1342_ = _e368;
    } else {
        phi_1342_ = 0u;
    }
    let _e370 = phi_1342_;
    workgroupBarrier();
    if (_e49 == 0u) {
        let _e374 = atomicLoad((&shared_[0u]));
        let _e375 = atomicAdd((&list.member[3u]), _e374);
        atomicStore((&shared_[1u]), _e375);
    }
    workgroupBarrier();
    if _e364 {
        let _e378 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e378) + _e370)]), _e366);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
