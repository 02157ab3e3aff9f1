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

struct type_22 {
    member: array<abi_Sample>,
}

struct type_26 {
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

struct type_36 {
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

struct type_43 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_22;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_36;
@group(0) @binding(2) 
var<storage> map: type_26;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_26;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_43;
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_159_: lt_bvh_traverse_Tree;
    var phi_160_: bool;
    var phi_161_: lt_bvh_traverse_Tree;
    var phi_162_: bool;
    var phi_167_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_159_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_160_ = false;
        } else {
            phi_159_ = lt_bvh_traverse_Tree();
            phi_160_ = true;
        }
        let _e63 = phi_159_;
        let _e65 = phi_160_;
        phi_161_ = _e63;
        phi_162_ = _e65;
    } else {
        phi_161_ = lt_bvh_traverse_Tree();
        phi_162_ = true;
    }
    let _e67 = phi_161_;
    let _e69 = phi_162_;
    if _e69 {
        phi_167_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_167_ = _e67;
    }
    let _e74 = phi_167_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_positive(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_197_: bool;
    var phi_201_: f32;
    var phi_202_: f32;

    let _e52 = (*param_4).positive_exponent;
    if ((bitcast<u32>(_e52) & 2147483647u) > 2139095040u) {
        phi_202_ = _e52;
    } else {
        if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
            phi_197_ = true;
        } else {
            let _e59 = (42f < _e52);
            if _e59 {
            }
            phi_197_ = _e59;
        }
        let _e61 = phi_197_;
        if _e61 {
            phi_201_ = 42f;
        } else {
            phi_201_ = _e52;
        }
        let _e63 = phi_201_;
        phi_202_ = _e63;
    }
    let _e65 = phi_202_;
    return _e65;
}

fn _lt_math_evsm_Evsm_negative(param_5: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_223_: bool;
    var phi_227_: f32;
    var phi_228_: f32;

    let _e52 = (*param_5).negative_exponent;
    if ((bitcast<u32>(_e52) & 2147483647u) > 2139095040u) {
        phi_228_ = _e52;
    } else {
        if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
            phi_223_ = true;
        } else {
            let _e59 = (42f < _e52);
            if _e59 {
            }
            phi_223_ = _e59;
        }
        let _e61 = phi_223_;
        if _e61 {
            phi_227_ = 42f;
        } else {
            phi_227_ = _e52;
        }
        let _e63 = phi_227_;
        phi_228_ = _e63;
    }
    let _e65 = phi_228_;
    return _e65;
}

fn lt_math_evsm_warp(param_6: vec4<f32>, param_7: f32) -> vec4<f32> {
    var phi_561_: f32;
    var phi_566_: f32;
    var phi_588_: f32;
    var phi_593_: f32;
    var phi_594_: bool;
    var phi_595_: f32;
    var phi_596_: bool;
    var phi_600_: f32;
    var phi_638_: f32;
    var phi_651_: f32;
    var phi_656_: f32;
    var phi_678_: f32;
    var phi_683_: f32;
    var phi_684_: bool;
    var phi_685_: f32;
    var phi_686_: bool;
    var phi_690_: f32;
    var phi_728_: f32;
    var phi_741_: f32;
    var phi_746_: f32;
    var phi_768_: f32;
    var phi_773_: f32;
    var phi_774_: bool;
    var phi_775_: f32;
    var phi_776_: bool;
    var phi_780_: f32;
    var phi_818_: f32;
    var phi_831_: f32;
    var phi_836_: f32;
    var phi_858_: f32;
    var phi_863_: f32;
    var phi_864_: bool;
    var phi_865_: f32;
    var phi_866_: bool;
    var phi_870_: f32;
    var phi_908_: f32;

    let _e53 = (param_7 * param_6.x);
    if ((bitcast<u32>(_e53) & 2147483647u) > 2139095040u) {
        phi_638_ = _e53;
    } else {
        if (_e53 < -87f) {
            phi_561_ = -87f;
        } else {
            phi_561_ = _e53;
        }
        let _e59 = phi_561_;
        if (_e59 > 88f) {
            phi_566_ = 88f;
        } else {
            phi_566_ = _e59;
        }
        let _e62 = phi_566_;
        let _e64 = ((_e62 * 1.442695f) + 0.5f);
        if (_e64 > -8388608f) {
            let _e76 = f32(select(0i, select(select(i32(_e64), i32(-2147483648), (_e64 < bitcast<f32>(3472883712u))), 2147483647i, (_e64 > bitcast<f32>(1325400063u))), (_e64 == _e64)));
            if (_e76 > _e64) {
                phi_588_ = 1f;
            } else {
                phi_588_ = 0f;
            }
            let _e79 = phi_588_;
            if (_e64 < 8388608f) {
                phi_593_ = (_e76 - _e79);
                phi_594_ = false;
            } else {
                phi_593_ = f32();
                phi_594_ = true;
            }
            let _e82 = phi_593_;
            let _e84 = phi_594_;
            phi_595_ = _e82;
            phi_596_ = _e84;
        } else {
            phi_595_ = f32();
            phi_596_ = true;
        }
        let _e86 = phi_595_;
        let _e88 = phi_596_;
        if _e88 {
            phi_600_ = _e64;
        } else {
            phi_600_ = _e86;
        }
        let _e90 = phi_600_;
        let _e94 = ((_e62 - (_e90 * 0.69314575f)) - (_e90 * 0.0000014286068f));
        phi_638_ = ((((((((((((((((1f / 5040f) * _e94) + (1f / 720f)) * _e94) + (1f / 120f)) * _e94) + (1f / 24f)) * _e94) + (1f / 6f)) * _e94) + 0.5f) * _e94) + 1f) * _e94) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e90), i32(-2147483648), (_e90 < bitcast<f32>(3472883712u))), 2147483647i, (_e90 > bitcast<f32>(1325400063u))), (_e90 == _e90)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e130 = phi_638_;
    let _e132 = (param_7 * param_6.y);
    if ((bitcast<u32>(_e132) & 2147483647u) > 2139095040u) {
        phi_728_ = _e132;
    } else {
        if (_e132 < -87f) {
            phi_651_ = -87f;
        } else {
            phi_651_ = _e132;
        }
        let _e138 = phi_651_;
        if (_e138 > 88f) {
            phi_656_ = 88f;
        } else {
            phi_656_ = _e138;
        }
        let _e141 = phi_656_;
        let _e143 = ((_e141 * 1.442695f) + 0.5f);
        if (_e143 > -8388608f) {
            let _e155 = f32(select(0i, select(select(i32(_e143), i32(-2147483648), (_e143 < bitcast<f32>(3472883712u))), 2147483647i, (_e143 > bitcast<f32>(1325400063u))), (_e143 == _e143)));
            if (_e155 > _e143) {
                phi_678_ = 1f;
            } else {
                phi_678_ = 0f;
            }
            let _e158 = phi_678_;
            if (_e143 < 8388608f) {
                phi_683_ = (_e155 - _e158);
                phi_684_ = false;
            } else {
                phi_683_ = f32();
                phi_684_ = true;
            }
            let _e161 = phi_683_;
            let _e163 = phi_684_;
            phi_685_ = _e161;
            phi_686_ = _e163;
        } else {
            phi_685_ = f32();
            phi_686_ = true;
        }
        let _e165 = phi_685_;
        let _e167 = phi_686_;
        if _e167 {
            phi_690_ = _e143;
        } else {
            phi_690_ = _e165;
        }
        let _e169 = phi_690_;
        let _e173 = ((_e141 - (_e169 * 0.69314575f)) - (_e169 * 0.0000014286068f));
        phi_728_ = ((((((((((((((((1f / 5040f) * _e173) + (1f / 720f)) * _e173) + (1f / 120f)) * _e173) + (1f / 24f)) * _e173) + (1f / 6f)) * _e173) + 0.5f) * _e173) + 1f) * _e173) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e169), i32(-2147483648), (_e169 < bitcast<f32>(3472883712u))), 2147483647i, (_e169 > bitcast<f32>(1325400063u))), (_e169 == _e169)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e209 = phi_728_;
    let _e211 = (param_7 * param_6.z);
    if ((bitcast<u32>(_e211) & 2147483647u) > 2139095040u) {
        phi_818_ = _e211;
    } else {
        if (_e211 < -87f) {
            phi_741_ = -87f;
        } else {
            phi_741_ = _e211;
        }
        let _e217 = phi_741_;
        if (_e217 > 88f) {
            phi_746_ = 88f;
        } else {
            phi_746_ = _e217;
        }
        let _e220 = phi_746_;
        let _e222 = ((_e220 * 1.442695f) + 0.5f);
        if (_e222 > -8388608f) {
            let _e234 = f32(select(0i, select(select(i32(_e222), i32(-2147483648), (_e222 < bitcast<f32>(3472883712u))), 2147483647i, (_e222 > bitcast<f32>(1325400063u))), (_e222 == _e222)));
            if (_e234 > _e222) {
                phi_768_ = 1f;
            } else {
                phi_768_ = 0f;
            }
            let _e237 = phi_768_;
            if (_e222 < 8388608f) {
                phi_773_ = (_e234 - _e237);
                phi_774_ = false;
            } else {
                phi_773_ = f32();
                phi_774_ = true;
            }
            let _e240 = phi_773_;
            let _e242 = phi_774_;
            phi_775_ = _e240;
            phi_776_ = _e242;
        } else {
            phi_775_ = f32();
            phi_776_ = true;
        }
        let _e244 = phi_775_;
        let _e246 = phi_776_;
        if _e246 {
            phi_780_ = _e222;
        } else {
            phi_780_ = _e244;
        }
        let _e248 = phi_780_;
        let _e252 = ((_e220 - (_e248 * 0.69314575f)) - (_e248 * 0.0000014286068f));
        phi_818_ = ((((((((((((((((1f / 5040f) * _e252) + (1f / 720f)) * _e252) + (1f / 120f)) * _e252) + (1f / 24f)) * _e252) + (1f / 6f)) * _e252) + 0.5f) * _e252) + 1f) * _e252) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e248), i32(-2147483648), (_e248 < bitcast<f32>(3472883712u))), 2147483647i, (_e248 > bitcast<f32>(1325400063u))), (_e248 == _e248)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e288 = phi_818_;
    let _e290 = (param_7 * param_6.w);
    if ((bitcast<u32>(_e290) & 2147483647u) > 2139095040u) {
        phi_908_ = _e290;
    } else {
        if (_e290 < -87f) {
            phi_831_ = -87f;
        } else {
            phi_831_ = _e290;
        }
        let _e296 = phi_831_;
        if (_e296 > 88f) {
            phi_836_ = 88f;
        } else {
            phi_836_ = _e296;
        }
        let _e299 = phi_836_;
        let _e301 = ((_e299 * 1.442695f) + 0.5f);
        if (_e301 > -8388608f) {
            let _e313 = f32(select(0i, select(select(i32(_e301), i32(-2147483648), (_e301 < bitcast<f32>(3472883712u))), 2147483647i, (_e301 > bitcast<f32>(1325400063u))), (_e301 == _e301)));
            if (_e313 > _e301) {
                phi_858_ = 1f;
            } else {
                phi_858_ = 0f;
            }
            let _e316 = phi_858_;
            if (_e301 < 8388608f) {
                phi_863_ = (_e313 - _e316);
                phi_864_ = false;
            } else {
                phi_863_ = f32();
                phi_864_ = true;
            }
            let _e319 = phi_863_;
            let _e321 = phi_864_;
            phi_865_ = _e319;
            phi_866_ = _e321;
        } else {
            phi_865_ = f32();
            phi_866_ = true;
        }
        let _e323 = phi_865_;
        let _e325 = phi_866_;
        if _e325 {
            phi_870_ = _e301;
        } else {
            phi_870_ = _e323;
        }
        let _e327 = phi_870_;
        let _e331 = ((_e299 - (_e327 * 0.69314575f)) - (_e327 * 0.0000014286068f));
        phi_908_ = ((((((((((((((((1f / 5040f) * _e331) + (1f / 720f)) * _e331) + (1f / 120f)) * _e331) + (1f / 24f)) * _e331) + (1f / 6f)) * _e331) + 0.5f) * _e331) + 1f) * _e331) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e327), i32(-2147483648), (_e327 < bitcast<f32>(3472883712u))), 2147483647i, (_e327 > bitcast<f32>(1325400063u))), (_e327 == _e327)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e367 = phi_908_;
    return vec4<f32>(_e130, _e209, _e288, _e367);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_8: ptr<function, lt_math_Evsm>, param_9: vec4<f32>, param_10: vec4<f32>, param_11: f32) -> f32 {
    var phi_248_: f32;
    var phi_249_: f32;
    var phi_250_: f32;
    var phi_266_: f32;
    var phi_267_: f32;
    var phi_268_: f32;
    var phi_285_: f32;
    var phi_286_: f32;
    var phi_287_: f32;
    var phi_304_: f32;
    var phi_305_: f32;
    var phi_306_: f32;
    var phi_323_: f32;
    var phi_324_: f32;
    var phi_325_: f32;
    var phi_392_: bool;
    var phi_396_: f32;
    var phi_397_: f32;
    var phi_409_: bool;
    var phi_416_: f32;
    var phi_482_: bool;
    var phi_486_: f32;
    var phi_487_: f32;
    var phi_499_: bool;
    var phi_506_: f32;
    var phi_523_: bool;
    var phi_527_: f32;
    var phi_528_: f32;
    var phi_543_: f32;
    var phi_544_: f32;
    var phi_545_: f32;

    if ((bitcast<u32>(param_11) & 2147483647u) > 2139095040u) {
        phi_250_ = param_11;
    } else {
        if (param_11 < 0f) {
            phi_249_ = 0f;
        } else {
            if (param_11 > 1f) {
                phi_248_ = 1f;
            } else {
                phi_248_ = param_11;
            }
            let _e60 = phi_248_;
            phi_249_ = _e60;
        }
        let _e62 = phi_249_;
        phi_250_ = _e62;
    }
    let _e64 = phi_250_;
    if ((bitcast<u32>(param_9.x) & 2147483647u) > 2139095040u) {
        phi_268_ = param_9.x;
    } else {
        if (param_9.x < 0f) {
            phi_267_ = 0f;
        } else {
            if (param_9.x > 1f) {
                phi_266_ = 1f;
            } else {
                phi_266_ = param_9.x;
            }
            let _e72 = phi_266_;
            phi_267_ = _e72;
        }
        let _e74 = phi_267_;
        phi_268_ = _e74;
    }
    let _e76 = phi_268_;
    if ((bitcast<u32>(param_9.y) & 2147483647u) > 2139095040u) {
        phi_287_ = param_9.y;
    } else {
        if (param_9.y < 0f) {
            phi_286_ = 0f;
        } else {
            if (param_9.y > 1f) {
                phi_285_ = 1f;
            } else {
                phi_285_ = param_9.y;
            }
            let _e85 = phi_285_;
            phi_286_ = _e85;
        }
        let _e87 = phi_286_;
        phi_287_ = _e87;
    }
    let _e89 = phi_287_;
    if ((bitcast<u32>(param_9.z) & 2147483647u) > 2139095040u) {
        phi_306_ = param_9.z;
    } else {
        if (param_9.z < 0f) {
            phi_305_ = 0f;
        } else {
            if (param_9.z > 1f) {
                phi_304_ = 1f;
            } else {
                phi_304_ = param_9.z;
            }
            let _e98 = phi_304_;
            phi_305_ = _e98;
        }
        let _e100 = phi_305_;
        phi_306_ = _e100;
    }
    let _e102 = phi_306_;
    if ((bitcast<u32>(param_9.w) & 2147483647u) > 2139095040u) {
        phi_325_ = param_9.w;
    } else {
        if (param_9.w < 0f) {
            phi_324_ = 0f;
        } else {
            if (param_9.w > 1f) {
                phi_323_ = 1f;
            } else {
                phi_323_ = param_9.w;
            }
            let _e111 = phi_323_;
            phi_324_ = _e111;
        }
        let _e113 = phi_324_;
        phi_325_ = _e113;
    }
    let _e115 = phi_325_;
    let _e117 = vec4<f32>((_e76 - _e64), (_e89 - _e64), (_e102 - _e64), (_e115 - _e64));
    let _e118 = _lt_math_evsm_Evsm_positive(param_8);
    let _e119 = lt_math_evsm_warp(_e117, _e118);
    let _e122 = (_e119.x - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e125 = (_e119.y - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e128 = (_e119.z - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e131 = (_e119.w - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e133 = (*param_8).min_variance;
    let _e135 = ((_e133 * _e118) * _e118);
    let _e146 = ((((_e122 * param_10.x) + (_e125 * param_10.y)) + (_e128 * param_10.z)) + (_e131 * param_10.w));
    let _e147 = (_e122 - _e146);
    let _e148 = (_e125 - _e146);
    let _e149 = (_e128 - _e146);
    let _e150 = (_e131 - _e146);
    let _e165 = (((((_e147 * _e147) * param_10.x) + ((_e148 * _e148) * param_10.y)) + ((_e149 * _e149) * param_10.z)) + ((_e150 * _e150) * param_10.w));
    if ((bitcast<u32>(_e165) & 2147483647u) > 2139095040u) {
        phi_397_ = _e165;
    } else {
        if ((bitcast<u32>(_e135) & 2147483647u) > 2139095040u) {
            phi_392_ = true;
        } else {
            let _e172 = (_e135 > _e165);
            if _e172 {
            }
            phi_392_ = _e172;
        }
        let _e174 = phi_392_;
        if _e174 {
            phi_396_ = _e135;
        } else {
            phi_396_ = _e165;
        }
        let _e176 = phi_396_;
        phi_397_ = _e176;
    }
    let _e178 = phi_397_;
    let _e179 = -(_e146);
    if (_e179 <= 0f) {
        let _e183 = ((bitcast<u32>(_e178) & 2147483647u) > 2139095040u);
        if _e183 {
        }
        phi_409_ = _e183;
    } else {
        phi_409_ = true;
    }
    let _e185 = phi_409_;
    if _e185 {
        phi_416_ = (_e178 / (_e178 + (_e179 * _e179)));
    } else {
        phi_416_ = 1f;
    }
    let _e190 = phi_416_;
    let _e191 = _lt_math_evsm_Evsm_negative(param_8);
    let _e193 = lt_math_evsm_warp(_e117, -(_e191));
    let _e196 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e193.x);
    let _e199 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e193.y);
    let _e202 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e193.z);
    let _e205 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e193.w);
    let _e207 = (*param_8).min_variance;
    let _e209 = ((_e207 * _e191) * _e191);
    let _e220 = ((((_e196 * param_10.x) + (_e199 * param_10.y)) + (_e202 * param_10.z)) + (_e205 * param_10.w));
    let _e221 = (_e196 - _e220);
    let _e222 = (_e199 - _e220);
    let _e223 = (_e202 - _e220);
    let _e224 = (_e205 - _e220);
    let _e239 = (((((_e221 * _e221) * param_10.x) + ((_e222 * _e222) * param_10.y)) + ((_e223 * _e223) * param_10.z)) + ((_e224 * _e224) * param_10.w));
    if ((bitcast<u32>(_e239) & 2147483647u) > 2139095040u) {
        phi_487_ = _e239;
    } else {
        if ((bitcast<u32>(_e209) & 2147483647u) > 2139095040u) {
            phi_482_ = true;
        } else {
            let _e246 = (_e209 > _e239);
            if _e246 {
            }
            phi_482_ = _e246;
        }
        let _e248 = phi_482_;
        if _e248 {
            phi_486_ = _e209;
        } else {
            phi_486_ = _e239;
        }
        let _e250 = phi_486_;
        phi_487_ = _e250;
    }
    let _e252 = phi_487_;
    let _e253 = -(_e220);
    if (_e253 <= 0f) {
        let _e257 = ((bitcast<u32>(_e252) & 2147483647u) > 2139095040u);
        if _e257 {
        }
        phi_499_ = _e257;
    } else {
        phi_499_ = true;
    }
    let _e259 = phi_499_;
    if _e259 {
        phi_506_ = (_e252 / (_e252 + (_e253 * _e253)));
    } else {
        phi_506_ = 1f;
    }
    let _e264 = phi_506_;
    if ((bitcast<u32>(_e190) & 2147483647u) > 2139095040u) {
        phi_528_ = _e190;
    } else {
        if ((bitcast<u32>(_e264) & 2147483647u) > 2139095040u) {
            phi_523_ = true;
        } else {
            let _e271 = (_e264 < _e190);
            if _e271 {
            }
            phi_523_ = _e271;
        }
        let _e273 = phi_523_;
        if _e273 {
            phi_527_ = _e264;
        } else {
            phi_527_ = _e190;
        }
        let _e275 = phi_527_;
        phi_528_ = _e275;
    }
    let _e277 = phi_528_;
    if ((bitcast<u32>(_e277) & 2147483647u) > 2139095040u) {
        phi_545_ = _e277;
    } else {
        if (_e277 < 0f) {
            phi_544_ = 0f;
        } else {
            if (_e277 > 1f) {
                phi_543_ = 1f;
            } else {
                phi_543_ = _e277;
            }
            let _e284 = phi_543_;
            phi_544_ = _e284;
        }
        let _e286 = phi_544_;
        phi_545_ = _e286;
    }
    let _e288 = phi_545_;
    return _e288;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_963_: bool;
    var phi_964_: bool;
    var phi_965_: bool;
    var phi_966_: bool;
    var phi_970_: bool;
    var phi_1014_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1018_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1095_: bool;
    var phi_1104_: bool;
    var phi_1113_: bool;
    var phi_1114_: bool;
    var phi_1115_: bool;
    var phi_1116_: bool;
    var phi_1117_: bool;
    var phi_1118_: bool;
    var phi_1119_: bool;
    var phi_1123_: bool;
    var phi_1159_: f32;
    var phi_1164_: f32;
    var phi_1165_: bool;
    var phi_1166_: f32;
    var phi_1167_: bool;
    var phi_1171_: f32;
    var phi_1191_: f32;
    var phi_1196_: f32;
    var phi_1197_: bool;
    var phi_1198_: f32;
    var phi_1199_: bool;
    var phi_1203_: f32;
    var phi_1253_: i32;
    var phi_1258_: i32;
    var phi_1263_: i32;
    var phi_1268_: i32;
    var phi_1277_: i32;
    var phi_1282_: i32;
    var phi_1287_: i32;
    var phi_1292_: i32;
    var phi_1339_: bool;
    var phi_1347_: bool;
    var phi_1352_: f32;
    var phi_1355_: evaluate_Verdict;
    var phi_1356_: evaluate_Verdict;
    var phi_1360_: bool;
    var phi_1361_: u32;
    var phi_1367_: u32;

    let _e51 = id_1;
    let _e52 = local_2;
    let _e57 = arrayLength((&map.member));
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e64 = p.member.size[0u];
    let _e66 = p.member.size[1u];
    let _e67 = lt_shaders_entry_pixel_index(_e51, _e64, _e66);
    if (bitcast<i32>(_e67.root) != 0i) {
        let _e74 = p.member.light;
        let _e77 = samples.member[_e67.first_primitive].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[_e67.first_primitive].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[_e67.first_primitive].normal[2u];
                let _e89 = global[2u];
                phi_963_ = (_e87 == _e89);
                phi_964_ = false;
            } else {
                phi_963_ = bool();
                phi_964_ = true;
            }
            let _e92 = phi_963_;
            let _e94 = phi_964_;
            phi_965_ = _e92;
            phi_966_ = _e94;
        } else {
            phi_965_ = bool();
            phi_966_ = true;
        }
        let _e96 = phi_965_;
        let _e98 = phi_966_;
        if _e98 {
            phi_970_ = false;
        } else {
            phi_970_ = _e96;
        }
        let _e100 = phi_970_;
        if !(_e100) {
            let _e103 = samples.member[_e67.first_primitive].normal;
            let _e105 = samples.member[_e67.first_primitive].position;
            if ((((_e103.x * (_e74.x - (_e105.x * _e74.w))) + (_e103.y * (_e74.y - (_e105.y * _e74.w)))) + (_e103.z * (_e74.z - (_e105.z * _e74.w)))) > 0f) {
                let _e129 = samples.member[_e67.first_primitive].flags;
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_1014_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, ((_e129 & 1u) == 0u));
            } else {
                let _e152 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e152.unnamed.visibility, false), _e152.unnamed_1);
                phi_1014_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e158.unnamed, true);
            }
            let _e163 = phi_1014_;
            phi_1018_ = _e163;
        } else {
            let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e169.unnamed.visibility, false), _e169.unnamed_1);
            phi_1018_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e175.unnamed, true);
        }
        let _e180 = phi_1018_;
        if _e180.unnamed_1 {
            phi_1356_ = evaluate_Verdict(_e180.unnamed.visibility, _e180.unnamed.is_doubted);
        } else {
            let _e188 = samples.member[_e67.first_primitive].position;
            let _e194 = p.member.projection.row_w;
            let _e205 = ((((_e194.x * _e188.x) + (_e194.y * _e188.y)) + (_e194.z * _e188.z)) + (_e194.w * 1f));
            let _e207 = p.member.projection.row_x;
            let _e219 = (((((_e207.x * _e188.x) + (_e207.y * _e188.y)) + (_e207.z * _e188.z)) + (_e207.w * 1f)) / _e205);
            let _e221 = p.member.projection.row_y;
            let _e233 = (((((_e221.x * _e188.x) + (_e221.y * _e188.y)) + (_e221.z * _e188.z)) + (_e221.w * 1f)) / _e205);
            let _e235 = p.member.projection.row_z;
            let _e246 = ((((_e235.x * _e188.x) + (_e235.y * _e188.y)) + (_e235.z * _e188.z)) + (_e235.w * 1f));
            if (_e205 > 0f) {
                if (_e219 >= 0f) {
                    phi_1095_ = (_e219 <= 1f);
                } else {
                    phi_1095_ = false;
                }
                let _e251 = phi_1095_;
                if _e251 {
                    if (_e233 >= 0f) {
                        phi_1104_ = (_e233 <= 1f);
                    } else {
                        phi_1104_ = false;
                    }
                    let _e255 = phi_1104_;
                    if _e255 {
                        if (_e246 >= 0f) {
                            phi_1113_ = (_e246 <= 1f);
                        } else {
                            phi_1113_ = false;
                        }
                        let _e259 = phi_1113_;
                        phi_1114_ = _e259;
                        phi_1115_ = false;
                    } else {
                        phi_1114_ = bool();
                        phi_1115_ = true;
                    }
                    let _e261 = phi_1114_;
                    let _e263 = phi_1115_;
                    phi_1116_ = _e261;
                    phi_1117_ = _e263;
                } else {
                    phi_1116_ = bool();
                    phi_1117_ = true;
                }
                let _e265 = phi_1116_;
                let _e267 = phi_1117_;
                phi_1118_ = _e265;
                phi_1119_ = _e267;
            } else {
                phi_1118_ = bool();
                phi_1119_ = true;
            }
            let _e269 = phi_1118_;
            let _e271 = phi_1119_;
            if _e271 {
                phi_1123_ = false;
            } else {
                phi_1123_ = _e269;
            }
            let _e273 = phi_1123_;
            if _e273 {
                let _e275 = p.member.map_size;
                let _e276 = f32(_e275);
                let _e279 = ((_e219 * _e276) - 0.5f);
                let _e280 = ((_e233 * _e276) - 0.5f);
                if (_e279 > -8388608f) {
                    let _e292 = f32(select(0i, select(select(i32(_e279), i32(-2147483648), (_e279 < bitcast<f32>(3472883712u))), 2147483647i, (_e279 > bitcast<f32>(1325400063u))), (_e279 == _e279)));
                    if (_e292 > _e279) {
                        phi_1159_ = 1f;
                    } else {
                        phi_1159_ = 0f;
                    }
                    let _e295 = phi_1159_;
                    if (_e279 < 8388608f) {
                        phi_1164_ = (_e292 - _e295);
                        phi_1165_ = false;
                    } else {
                        phi_1164_ = f32();
                        phi_1165_ = true;
                    }
                    let _e298 = phi_1164_;
                    let _e300 = phi_1165_;
                    phi_1166_ = _e298;
                    phi_1167_ = _e300;
                } else {
                    phi_1166_ = f32();
                    phi_1167_ = true;
                }
                let _e302 = phi_1166_;
                let _e304 = phi_1167_;
                if _e304 {
                    phi_1171_ = _e279;
                } else {
                    phi_1171_ = _e302;
                }
                let _e306 = phi_1171_;
                if (_e280 > -8388608f) {
                    let _e318 = f32(select(0i, select(select(i32(_e280), i32(-2147483648), (_e280 < bitcast<f32>(3472883712u))), 2147483647i, (_e280 > bitcast<f32>(1325400063u))), (_e280 == _e280)));
                    if (_e318 > _e280) {
                        phi_1191_ = 1f;
                    } else {
                        phi_1191_ = 0f;
                    }
                    let _e321 = phi_1191_;
                    if (_e280 < 8388608f) {
                        phi_1196_ = (_e318 - _e321);
                        phi_1197_ = false;
                    } else {
                        phi_1196_ = f32();
                        phi_1197_ = true;
                    }
                    let _e324 = phi_1196_;
                    let _e326 = phi_1197_;
                    phi_1198_ = _e324;
                    phi_1199_ = _e326;
                } else {
                    phi_1198_ = f32();
                    phi_1199_ = true;
                }
                let _e328 = phi_1198_;
                let _e330 = phi_1199_;
                if _e330 {
                    phi_1203_ = _e280;
                } else {
                    phi_1203_ = _e328;
                }
                let _e332 = phi_1203_;
                let _e333 = (_e279 - _e306);
                let _e334 = (_e280 - _e332);
                let _e343 = select(0i, select(select(i32(_e306), i32(-2147483648), (_e306 < bitcast<f32>(3472883712u))), 2147483647i, (_e306 > bitcast<f32>(1325400063u))), (_e306 == _e306));
                let _e352 = select(0i, select(select(i32(_e332), i32(-2147483648), (_e332 < bitcast<f32>(3472883712u))), 2147483647i, (_e332 > bitcast<f32>(1325400063u))), (_e332 == _e332));
                let _e363 = p.member.test;
                let _e364 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e363);
                let _e366 = p.member.map_size;
                local_1 = lt_math_Evsm(_e364.positive_exponent, _e364.negative_exponent, _e364.min_variance);
                let _e372 = (bitcast<i32>(_e366) - 1i);
                if (_e343 > 0i) {
                    phi_1253_ = _e343;
                } else {
                    phi_1253_ = 0i;
                }
                let _e375 = phi_1253_;
                if (_e352 > 0i) {
                    phi_1258_ = _e352;
                } else {
                    phi_1258_ = 0i;
                }
                let _e378 = phi_1258_;
                if (_e375 < _e372) {
                    phi_1263_ = _e375;
                } else {
                    phi_1263_ = _e372;
                }
                let _e381 = phi_1263_;
                if (_e378 < _e372) {
                    phi_1268_ = _e378;
                } else {
                    phi_1268_ = _e372;
                }
                let _e384 = phi_1268_;
                let _e385 = bitcast<u32>(_e381);
                let _e387 = (_e343 + 1i);
                let _e388 = (_e352 + 1i);
                if (_e387 > 0i) {
                    phi_1277_ = _e387;
                } else {
                    phi_1277_ = 0i;
                }
                let _e391 = phi_1277_;
                if (_e388 > 0i) {
                    phi_1282_ = _e388;
                } else {
                    phi_1282_ = 0i;
                }
                let _e394 = phi_1282_;
                if (_e391 < _e372) {
                    phi_1287_ = _e391;
                } else {
                    phi_1287_ = _e372;
                }
                let _e397 = phi_1287_;
                if (_e394 < _e372) {
                    phi_1292_ = _e394;
                } else {
                    phi_1292_ = _e372;
                }
                let _e400 = phi_1292_;
                let _e401 = bitcast<u32>(_e397);
                let _e403 = (bitcast<u32>(_e384) * _e366);
                let _e404 = (bitcast<u32>(_e400) * _e366);
                let _e405 = (_e403 + _e385);
                let _e406 = (_e403 + _e401);
                let _e407 = (_e404 + _e385);
                let _e408 = (_e404 + _e401);
                if (_e405 < _e57) {
                } else {
                    return;
                }
                let _e412 = map.member[(0u + _e405)];
                if (_e406 < _e57) {
                } else {
                    return;
                }
                let _e416 = map.member[(0u + _e406)];
                if (_e407 < _e57) {
                } else {
                    return;
                }
                let _e420 = map.member[(0u + _e407)];
                if (_e408 < _e57) {
                } else {
                    return;
                }
                let _e424 = map.member[(0u + _e408)];
                let _e426 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e412, _e416, _e420, _e424), vec4<f32>(((1f - _e333) * (1f - _e334)), (_e333 * (1f - _e334)), ((1f - _e333) * _e334), (_e333 * _e334)), _e246);
                let _e428 = p.member.epsilon;
                if (_e426 <= _e428) {
                    phi_1339_ = true;
                } else {
                    phi_1339_ = (_e426 >= (1f - _e428));
                }
                let _e433 = phi_1339_;
                if ((bitcast<u32>(_e426) & 2147483647u) > 2139095040u) {
                    phi_1347_ = true;
                } else {
                    phi_1347_ = !(_e433);
                }
                let _e439 = phi_1347_;
                if (_e426 > 0.5f) {
                    phi_1352_ = 1f;
                } else {
                    phi_1352_ = 0f;
                }
                let _e442 = phi_1352_;
                phi_1355_ = evaluate_Verdict(_e442, _e439);
            } else {
                phi_1355_ = evaluate_Verdict(1f, true);
            }
            let _e446 = phi_1355_;
            phi_1356_ = _e446;
        }
        let _e448 = phi_1356_;
        visibility.member[_e67.first_primitive] = _e448.visibility;
        phi_1360_ = _e448.is_doubted;
        phi_1361_ = _e67.first_primitive;
    } else {
        phi_1360_ = false;
        phi_1361_ = 0u;
    }
    let _e453 = phi_1360_;
    let _e455 = phi_1361_;
    if _e453 {
        let _e457 = atomicAdd((&shared_[0u]), 1u);
        phi_1367_ = _e457;
    } else {
        phi_1367_ = 0u;
    }
    let _e459 = phi_1367_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e463 = atomicLoad((&shared_[0u]));
        let _e464 = atomicAdd((&list.member[3u]), _e463);
        atomicStore((&shared_[1u]), _e464);
    }
    workgroupBarrier();
    if _e453 {
        let _e467 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e467) + _e459)]), _e455);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
