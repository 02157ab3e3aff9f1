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

struct type_35 {
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

struct type_42 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_22;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(2) 
var<storage> map: type_26;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_26;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_42;
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_151_: lt_bvh_traverse_Tree;
    var phi_152_: bool;
    var phi_153_: lt_bvh_traverse_Tree;
    var phi_154_: bool;
    var phi_159_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_151_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_152_ = false;
        } else {
            phi_151_ = lt_bvh_traverse_Tree();
            phi_152_ = true;
        }
        let _e62 = phi_151_;
        let _e64 = phi_152_;
        phi_153_ = _e62;
        phi_154_ = _e64;
    } else {
        phi_153_ = lt_bvh_traverse_Tree();
        phi_154_ = true;
    }
    let _e66 = phi_153_;
    let _e68 = phi_154_;
    if _e68 {
        phi_159_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_159_ = _e66;
    }
    let _e73 = phi_159_;
    return lt_bvh_traverse_Tree(_e73.root, _e73.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_185_: bool;
    var phi_189_: f32;
    var phi_190_: f32;

    let _e50 = (*param_4);
    if ((bitcast<u32>(_e50) & 2147483647u) > 2139095040u) {
        phi_190_ = _e50;
    } else {
        if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
            phi_185_ = true;
        } else {
            let _e57 = (84f < _e50);
            if _e57 {
            }
            phi_185_ = _e57;
        }
        let _e59 = phi_185_;
        if _e59 {
            phi_189_ = 84f;
        } else {
            phi_189_ = _e50;
        }
        let _e61 = phi_189_;
        phi_190_ = _e61;
    }
    let _e63 = phi_190_;
    return _e63;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_213_: f32;
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_231_: f32;
    var phi_244_: f32;
    var phi_249_: f32;
    var phi_271_: f32;
    var phi_276_: f32;
    var phi_277_: bool;
    var phi_278_: f32;
    var phi_279_: bool;
    var phi_283_: f32;
    var phi_321_: f32;
    var phi_337_: f32;
    var phi_338_: f32;
    var phi_339_: f32;
    var phi_352_: f32;
    var phi_357_: f32;
    var phi_379_: f32;
    var phi_384_: f32;
    var phi_385_: bool;
    var phi_386_: f32;
    var phi_387_: bool;
    var phi_391_: f32;
    var phi_429_: f32;
    var phi_445_: f32;
    var phi_446_: f32;
    var phi_447_: f32;
    var phi_460_: f32;
    var phi_465_: f32;
    var phi_487_: f32;
    var phi_492_: f32;
    var phi_493_: bool;
    var phi_494_: f32;
    var phi_495_: bool;
    var phi_499_: f32;
    var phi_537_: f32;
    var phi_553_: f32;
    var phi_554_: f32;
    var phi_555_: f32;
    var phi_568_: f32;
    var phi_573_: f32;
    var phi_595_: f32;
    var phi_600_: f32;
    var phi_601_: bool;
    var phi_602_: f32;
    var phi_603_: bool;
    var phi_607_: f32;
    var phi_645_: f32;
    var phi_671_: f32;
    var phi_672_: f32;
    var phi_673_: f32;

    let _e53 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_213_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_212_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_211_ = 1f;
            } else {
                phi_211_ = param_8;
            }
            let _e60 = phi_211_;
            phi_212_ = _e60;
        }
        let _e62 = phi_212_;
        phi_213_ = _e62;
    }
    let _e64 = phi_213_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_231_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_230_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_229_ = 1f;
            } else {
                phi_229_ = param_6.x;
            }
            let _e72 = phi_229_;
            phi_230_ = _e72;
        }
        let _e74 = phi_230_;
        phi_231_ = _e74;
    }
    let _e76 = phi_231_;
    let _e78 = (_e53 * (_e76 - _e64));
    if ((bitcast<u32>(_e78) & 2147483647u) > 2139095040u) {
        phi_321_ = _e78;
    } else {
        if (_e78 < -87f) {
            phi_244_ = -87f;
        } else {
            phi_244_ = _e78;
        }
        let _e84 = phi_244_;
        if (_e84 > 88f) {
            phi_249_ = 88f;
        } else {
            phi_249_ = _e84;
        }
        let _e87 = phi_249_;
        let _e89 = ((_e87 * 1.442695f) + 0.5f);
        if (_e89 > -8388608f) {
            let _e101 = f32(select(0i, select(select(i32(_e89), i32(-2147483648), (_e89 < bitcast<f32>(3472883712u))), 2147483647i, (_e89 > bitcast<f32>(1325400063u))), (_e89 == _e89)));
            if (_e101 > _e89) {
                phi_271_ = 1f;
            } else {
                phi_271_ = 0f;
            }
            let _e104 = phi_271_;
            if (_e89 < 8388608f) {
                phi_276_ = (_e101 - _e104);
                phi_277_ = false;
            } else {
                phi_276_ = f32();
                phi_277_ = true;
            }
            let _e107 = phi_276_;
            let _e109 = phi_277_;
            phi_278_ = _e107;
            phi_279_ = _e109;
        } else {
            phi_278_ = f32();
            phi_279_ = true;
        }
        let _e111 = phi_278_;
        let _e113 = phi_279_;
        if _e113 {
            phi_283_ = _e89;
        } else {
            phi_283_ = _e111;
        }
        let _e115 = phi_283_;
        let _e119 = ((_e87 - (_e115 * 0.69314575f)) - (_e115 * 0.0000014286068f));
        phi_321_ = ((((((((((((((((1f / 5040f) * _e119) + (1f / 720f)) * _e119) + (1f / 120f)) * _e119) + (1f / 24f)) * _e119) + (1f / 6f)) * _e119) + 0.5f) * _e119) + 1f) * _e119) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e115), i32(-2147483648), (_e115 < bitcast<f32>(3472883712u))), 2147483647i, (_e115 > bitcast<f32>(1325400063u))), (_e115 == _e115)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e155 = phi_321_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_339_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_338_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_337_ = 1f;
            } else {
                phi_337_ = param_6.y;
            }
            let _e163 = phi_337_;
            phi_338_ = _e163;
        }
        let _e165 = phi_338_;
        phi_339_ = _e165;
    }
    let _e167 = phi_339_;
    let _e169 = (_e53 * (_e167 - _e64));
    if ((bitcast<u32>(_e169) & 2147483647u) > 2139095040u) {
        phi_429_ = _e169;
    } else {
        if (_e169 < -87f) {
            phi_352_ = -87f;
        } else {
            phi_352_ = _e169;
        }
        let _e175 = phi_352_;
        if (_e175 > 88f) {
            phi_357_ = 88f;
        } else {
            phi_357_ = _e175;
        }
        let _e178 = phi_357_;
        let _e180 = ((_e178 * 1.442695f) + 0.5f);
        if (_e180 > -8388608f) {
            let _e192 = f32(select(0i, select(select(i32(_e180), i32(-2147483648), (_e180 < bitcast<f32>(3472883712u))), 2147483647i, (_e180 > bitcast<f32>(1325400063u))), (_e180 == _e180)));
            if (_e192 > _e180) {
                phi_379_ = 1f;
            } else {
                phi_379_ = 0f;
            }
            let _e195 = phi_379_;
            if (_e180 < 8388608f) {
                phi_384_ = (_e192 - _e195);
                phi_385_ = false;
            } else {
                phi_384_ = f32();
                phi_385_ = true;
            }
            let _e198 = phi_384_;
            let _e200 = phi_385_;
            phi_386_ = _e198;
            phi_387_ = _e200;
        } else {
            phi_386_ = f32();
            phi_387_ = true;
        }
        let _e202 = phi_386_;
        let _e204 = phi_387_;
        if _e204 {
            phi_391_ = _e180;
        } else {
            phi_391_ = _e202;
        }
        let _e206 = phi_391_;
        let _e210 = ((_e178 - (_e206 * 0.69314575f)) - (_e206 * 0.0000014286068f));
        phi_429_ = ((((((((((((((((1f / 5040f) * _e210) + (1f / 720f)) * _e210) + (1f / 120f)) * _e210) + (1f / 24f)) * _e210) + (1f / 6f)) * _e210) + 0.5f) * _e210) + 1f) * _e210) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e206), i32(-2147483648), (_e206 < bitcast<f32>(3472883712u))), 2147483647i, (_e206 > bitcast<f32>(1325400063u))), (_e206 == _e206)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e246 = phi_429_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_447_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_446_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_445_ = 1f;
            } else {
                phi_445_ = param_6.z;
            }
            let _e254 = phi_445_;
            phi_446_ = _e254;
        }
        let _e256 = phi_446_;
        phi_447_ = _e256;
    }
    let _e258 = phi_447_;
    let _e260 = (_e53 * (_e258 - _e64));
    if ((bitcast<u32>(_e260) & 2147483647u) > 2139095040u) {
        phi_537_ = _e260;
    } else {
        if (_e260 < -87f) {
            phi_460_ = -87f;
        } else {
            phi_460_ = _e260;
        }
        let _e266 = phi_460_;
        if (_e266 > 88f) {
            phi_465_ = 88f;
        } else {
            phi_465_ = _e266;
        }
        let _e269 = phi_465_;
        let _e271 = ((_e269 * 1.442695f) + 0.5f);
        if (_e271 > -8388608f) {
            let _e283 = f32(select(0i, select(select(i32(_e271), i32(-2147483648), (_e271 < bitcast<f32>(3472883712u))), 2147483647i, (_e271 > bitcast<f32>(1325400063u))), (_e271 == _e271)));
            if (_e283 > _e271) {
                phi_487_ = 1f;
            } else {
                phi_487_ = 0f;
            }
            let _e286 = phi_487_;
            if (_e271 < 8388608f) {
                phi_492_ = (_e283 - _e286);
                phi_493_ = false;
            } else {
                phi_492_ = f32();
                phi_493_ = true;
            }
            let _e289 = phi_492_;
            let _e291 = phi_493_;
            phi_494_ = _e289;
            phi_495_ = _e291;
        } else {
            phi_494_ = f32();
            phi_495_ = true;
        }
        let _e293 = phi_494_;
        let _e295 = phi_495_;
        if _e295 {
            phi_499_ = _e271;
        } else {
            phi_499_ = _e293;
        }
        let _e297 = phi_499_;
        let _e301 = ((_e269 - (_e297 * 0.69314575f)) - (_e297 * 0.0000014286068f));
        phi_537_ = ((((((((((((((((1f / 5040f) * _e301) + (1f / 720f)) * _e301) + (1f / 120f)) * _e301) + (1f / 24f)) * _e301) + (1f / 6f)) * _e301) + 0.5f) * _e301) + 1f) * _e301) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e297), i32(-2147483648), (_e297 < bitcast<f32>(3472883712u))), 2147483647i, (_e297 > bitcast<f32>(1325400063u))), (_e297 == _e297)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e337 = phi_537_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_555_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_554_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_553_ = 1f;
            } else {
                phi_553_ = param_6.w;
            }
            let _e345 = phi_553_;
            phi_554_ = _e345;
        }
        let _e347 = phi_554_;
        phi_555_ = _e347;
    }
    let _e349 = phi_555_;
    let _e351 = (_e53 * (_e349 - _e64));
    if ((bitcast<u32>(_e351) & 2147483647u) > 2139095040u) {
        phi_645_ = _e351;
    } else {
        if (_e351 < -87f) {
            phi_568_ = -87f;
        } else {
            phi_568_ = _e351;
        }
        let _e357 = phi_568_;
        if (_e357 > 88f) {
            phi_573_ = 88f;
        } else {
            phi_573_ = _e357;
        }
        let _e360 = phi_573_;
        let _e362 = ((_e360 * 1.442695f) + 0.5f);
        if (_e362 > -8388608f) {
            let _e374 = f32(select(0i, select(select(i32(_e362), i32(-2147483648), (_e362 < bitcast<f32>(3472883712u))), 2147483647i, (_e362 > bitcast<f32>(1325400063u))), (_e362 == _e362)));
            if (_e374 > _e362) {
                phi_595_ = 1f;
            } else {
                phi_595_ = 0f;
            }
            let _e377 = phi_595_;
            if (_e362 < 8388608f) {
                phi_600_ = (_e374 - _e377);
                phi_601_ = false;
            } else {
                phi_600_ = f32();
                phi_601_ = true;
            }
            let _e380 = phi_600_;
            let _e382 = phi_601_;
            phi_602_ = _e380;
            phi_603_ = _e382;
        } else {
            phi_602_ = f32();
            phi_603_ = true;
        }
        let _e384 = phi_602_;
        let _e386 = phi_603_;
        if _e386 {
            phi_607_ = _e362;
        } else {
            phi_607_ = _e384;
        }
        let _e388 = phi_607_;
        let _e392 = ((_e360 - (_e388 * 0.69314575f)) - (_e388 * 0.0000014286068f));
        phi_645_ = ((((((((((((((((1f / 5040f) * _e392) + (1f / 720f)) * _e392) + (1f / 120f)) * _e392) + (1f / 24f)) * _e392) + (1f / 6f)) * _e392) + 0.5f) * _e392) + 1f) * _e392) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e388), i32(-2147483648), (_e388 < bitcast<f32>(3472883712u))), 2147483647i, (_e388 > bitcast<f32>(1325400063u))), (_e388 == _e388)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e428 = phi_645_;
    let _e439 = ((((_e155 * param_7.x) + (_e246 * param_7.y)) + (_e337 * param_7.z)) + (_e428 * param_7.w));
    if ((bitcast<u32>(_e439) & 2147483647u) > 2139095040u) {
        phi_673_ = _e439;
    } else {
        if (_e439 < 0f) {
            phi_672_ = 0f;
        } else {
            if (_e439 > 1f) {
                phi_671_ = 1f;
            } else {
                phi_671_ = _e439;
            }
            let _e446 = phi_671_;
            phi_672_ = _e446;
        }
        let _e448 = phi_672_;
        phi_673_ = _e448;
    }
    let _e450 = phi_673_;
    return _e450;
}

fn function_() {
    var local_1: f32;
    var phi_727_: bool;
    var phi_728_: bool;
    var phi_729_: bool;
    var phi_730_: bool;
    var phi_734_: bool;
    var phi_778_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_782_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_859_: bool;
    var phi_868_: bool;
    var phi_877_: bool;
    var phi_878_: bool;
    var phi_879_: bool;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_887_: bool;
    var phi_923_: f32;
    var phi_928_: f32;
    var phi_929_: bool;
    var phi_930_: f32;
    var phi_931_: bool;
    var phi_935_: f32;
    var phi_955_: f32;
    var phi_960_: f32;
    var phi_961_: bool;
    var phi_962_: f32;
    var phi_963_: bool;
    var phi_967_: f32;
    var phi_1013_: i32;
    var phi_1018_: i32;
    var phi_1023_: i32;
    var phi_1028_: i32;
    var phi_1037_: i32;
    var phi_1042_: i32;
    var phi_1047_: i32;
    var phi_1052_: i32;
    var phi_1099_: bool;
    var phi_1107_: bool;
    var phi_1112_: f32;
    var phi_1115_: evaluate_Verdict;
    var phi_1116_: evaluate_Verdict;
    var phi_1120_: bool;
    var phi_1121_: u32;
    var phi_1127_: u32;

    let _e50 = id_1;
    let _e51 = local_2;
    let _e56 = arrayLength((&map.member));
    if (_e51 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e63 = p.member.size[0u];
    let _e65 = p.member.size[1u];
    let _e66 = lt_shaders_entry_pixel_index(_e50, _e63, _e65);
    if (bitcast<i32>(_e66.root) != 0i) {
        let _e73 = p.member.light;
        let _e76 = samples.member[_e66.first_primitive].normal[0u];
        let _e78 = global[0u];
        if (_e76 == _e78) {
            let _e81 = samples.member[_e66.first_primitive].normal[1u];
            let _e83 = global[1u];
            if (_e81 == _e83) {
                let _e86 = samples.member[_e66.first_primitive].normal[2u];
                let _e88 = global[2u];
                phi_727_ = (_e86 == _e88);
                phi_728_ = false;
            } else {
                phi_727_ = bool();
                phi_728_ = true;
            }
            let _e91 = phi_727_;
            let _e93 = phi_728_;
            phi_729_ = _e91;
            phi_730_ = _e93;
        } else {
            phi_729_ = bool();
            phi_730_ = true;
        }
        let _e95 = phi_729_;
        let _e97 = phi_730_;
        if _e97 {
            phi_734_ = false;
        } else {
            phi_734_ = _e95;
        }
        let _e99 = phi_734_;
        if !(_e99) {
            let _e102 = samples.member[_e66.first_primitive].normal;
            let _e104 = samples.member[_e66.first_primitive].position;
            if ((((_e102.x * (_e73.x - (_e104.x * _e73.w))) + (_e102.y * (_e73.y - (_e104.y * _e73.w)))) + (_e102.z * (_e73.z - (_e104.z * _e73.w)))) > 0f) {
                let _e128 = samples.member[_e66.first_primitive].flags;
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e136.unnamed.visibility, false), _e136.unnamed_1);
                phi_778_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e142.unnamed, ((_e128 & 1u) == 0u));
            } else {
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e151.unnamed.visibility, false), _e151.unnamed_1);
                phi_778_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e157.unnamed, true);
            }
            let _e162 = phi_778_;
            phi_782_ = _e162;
        } else {
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
            phi_782_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
        }
        let _e179 = phi_782_;
        if _e179.unnamed_1 {
            phi_1116_ = evaluate_Verdict(_e179.unnamed.visibility, _e179.unnamed.is_doubted);
        } else {
            let _e187 = samples.member[_e66.first_primitive].position;
            let _e193 = p.member.projection.row_w;
            let _e204 = ((((_e193.x * _e187.x) + (_e193.y * _e187.y)) + (_e193.z * _e187.z)) + (_e193.w * 1f));
            let _e206 = p.member.projection.row_x;
            let _e218 = (((((_e206.x * _e187.x) + (_e206.y * _e187.y)) + (_e206.z * _e187.z)) + (_e206.w * 1f)) / _e204);
            let _e220 = p.member.projection.row_y;
            let _e232 = (((((_e220.x * _e187.x) + (_e220.y * _e187.y)) + (_e220.z * _e187.z)) + (_e220.w * 1f)) / _e204);
            let _e234 = p.member.projection.row_z;
            let _e245 = ((((_e234.x * _e187.x) + (_e234.y * _e187.y)) + (_e234.z * _e187.z)) + (_e234.w * 1f));
            if (_e204 > 0f) {
                if (_e218 >= 0f) {
                    phi_859_ = (_e218 <= 1f);
                } else {
                    phi_859_ = false;
                }
                let _e250 = phi_859_;
                if _e250 {
                    if (_e232 >= 0f) {
                        phi_868_ = (_e232 <= 1f);
                    } else {
                        phi_868_ = false;
                    }
                    let _e254 = phi_868_;
                    if _e254 {
                        if (_e245 >= 0f) {
                            phi_877_ = (_e245 <= 1f);
                        } else {
                            phi_877_ = false;
                        }
                        let _e258 = phi_877_;
                        phi_878_ = _e258;
                        phi_879_ = false;
                    } else {
                        phi_878_ = bool();
                        phi_879_ = true;
                    }
                    let _e260 = phi_878_;
                    let _e262 = phi_879_;
                    phi_880_ = _e260;
                    phi_881_ = _e262;
                } else {
                    phi_880_ = bool();
                    phi_881_ = true;
                }
                let _e264 = phi_880_;
                let _e266 = phi_881_;
                phi_882_ = _e264;
                phi_883_ = _e266;
            } else {
                phi_882_ = bool();
                phi_883_ = true;
            }
            let _e268 = phi_882_;
            let _e270 = phi_883_;
            if _e270 {
                phi_887_ = false;
            } else {
                phi_887_ = _e268;
            }
            let _e272 = phi_887_;
            if _e272 {
                let _e274 = p.member.map_size;
                let _e275 = f32(_e274);
                let _e278 = ((_e218 * _e275) - 0.5f);
                let _e279 = ((_e232 * _e275) - 0.5f);
                if (_e278 > -8388608f) {
                    let _e291 = f32(select(0i, select(select(i32(_e278), i32(-2147483648), (_e278 < bitcast<f32>(3472883712u))), 2147483647i, (_e278 > bitcast<f32>(1325400063u))), (_e278 == _e278)));
                    if (_e291 > _e278) {
                        phi_923_ = 1f;
                    } else {
                        phi_923_ = 0f;
                    }
                    let _e294 = phi_923_;
                    if (_e278 < 8388608f) {
                        phi_928_ = (_e291 - _e294);
                        phi_929_ = false;
                    } else {
                        phi_928_ = f32();
                        phi_929_ = true;
                    }
                    let _e297 = phi_928_;
                    let _e299 = phi_929_;
                    phi_930_ = _e297;
                    phi_931_ = _e299;
                } else {
                    phi_930_ = f32();
                    phi_931_ = true;
                }
                let _e301 = phi_930_;
                let _e303 = phi_931_;
                if _e303 {
                    phi_935_ = _e278;
                } else {
                    phi_935_ = _e301;
                }
                let _e305 = phi_935_;
                if (_e279 > -8388608f) {
                    let _e317 = f32(select(0i, select(select(i32(_e279), i32(-2147483648), (_e279 < bitcast<f32>(3472883712u))), 2147483647i, (_e279 > bitcast<f32>(1325400063u))), (_e279 == _e279)));
                    if (_e317 > _e279) {
                        phi_955_ = 1f;
                    } else {
                        phi_955_ = 0f;
                    }
                    let _e320 = phi_955_;
                    if (_e279 < 8388608f) {
                        phi_960_ = (_e317 - _e320);
                        phi_961_ = false;
                    } else {
                        phi_960_ = f32();
                        phi_961_ = true;
                    }
                    let _e323 = phi_960_;
                    let _e325 = phi_961_;
                    phi_962_ = _e323;
                    phi_963_ = _e325;
                } else {
                    phi_962_ = f32();
                    phi_963_ = true;
                }
                let _e327 = phi_962_;
                let _e329 = phi_963_;
                if _e329 {
                    phi_967_ = _e279;
                } else {
                    phi_967_ = _e327;
                }
                let _e331 = phi_967_;
                let _e332 = (_e278 - _e305);
                let _e333 = (_e279 - _e331);
                let _e342 = select(0i, select(select(i32(_e305), i32(-2147483648), (_e305 < bitcast<f32>(3472883712u))), 2147483647i, (_e305 > bitcast<f32>(1325400063u))), (_e305 == _e305));
                let _e351 = select(0i, select(select(i32(_e331), i32(-2147483648), (_e331 < bitcast<f32>(3472883712u))), 2147483647i, (_e331 > bitcast<f32>(1325400063u))), (_e331 == _e331));
                let _e362 = p.member.test;
                let _e363 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e362);
                let _e365 = p.member.map_size;
                local_1 = _e363;
                let _e367 = (bitcast<i32>(_e365) - 1i);
                if (_e342 > 0i) {
                    phi_1013_ = _e342;
                } else {
                    phi_1013_ = 0i;
                }
                let _e370 = phi_1013_;
                if (_e351 > 0i) {
                    phi_1018_ = _e351;
                } else {
                    phi_1018_ = 0i;
                }
                let _e373 = phi_1018_;
                if (_e370 < _e367) {
                    phi_1023_ = _e370;
                } else {
                    phi_1023_ = _e367;
                }
                let _e376 = phi_1023_;
                if (_e373 < _e367) {
                    phi_1028_ = _e373;
                } else {
                    phi_1028_ = _e367;
                }
                let _e379 = phi_1028_;
                let _e380 = bitcast<u32>(_e376);
                let _e382 = (_e342 + 1i);
                let _e383 = (_e351 + 1i);
                if (_e382 > 0i) {
                    phi_1037_ = _e382;
                } else {
                    phi_1037_ = 0i;
                }
                let _e386 = phi_1037_;
                if (_e383 > 0i) {
                    phi_1042_ = _e383;
                } else {
                    phi_1042_ = 0i;
                }
                let _e389 = phi_1042_;
                if (_e386 < _e367) {
                    phi_1047_ = _e386;
                } else {
                    phi_1047_ = _e367;
                }
                let _e392 = phi_1047_;
                if (_e389 < _e367) {
                    phi_1052_ = _e389;
                } else {
                    phi_1052_ = _e367;
                }
                let _e395 = phi_1052_;
                let _e396 = bitcast<u32>(_e392);
                let _e398 = (bitcast<u32>(_e379) * _e365);
                let _e399 = (bitcast<u32>(_e395) * _e365);
                let _e400 = (_e398 + _e380);
                let _e401 = (_e398 + _e396);
                let _e402 = (_e399 + _e380);
                let _e403 = (_e399 + _e396);
                if (_e400 < _e56) {
                } else {
                    return;
                }
                let _e407 = map.member[(0u + _e400)];
                if (_e401 < _e56) {
                } else {
                    return;
                }
                let _e411 = map.member[(0u + _e401)];
                if (_e402 < _e56) {
                } else {
                    return;
                }
                let _e415 = map.member[(0u + _e402)];
                if (_e403 < _e56) {
                } else {
                    return;
                }
                let _e419 = map.member[(0u + _e403)];
                let _e421 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e407, _e411, _e415, _e419), vec4<f32>(((1f - _e332) * (1f - _e333)), (_e332 * (1f - _e333)), ((1f - _e332) * _e333), (_e332 * _e333)), _e245);
                let _e423 = p.member.epsilon;
                if (_e421 <= _e423) {
                    phi_1099_ = true;
                } else {
                    phi_1099_ = (_e421 >= (1f - _e423));
                }
                let _e428 = phi_1099_;
                if ((bitcast<u32>(_e421) & 2147483647u) > 2139095040u) {
                    phi_1107_ = true;
                } else {
                    phi_1107_ = !(_e428);
                }
                let _e434 = phi_1107_;
                if (_e421 > 0.5f) {
                    phi_1112_ = 1f;
                } else {
                    phi_1112_ = 0f;
                }
                let _e437 = phi_1112_;
                phi_1115_ = evaluate_Verdict(_e437, _e434);
            } else {
                phi_1115_ = evaluate_Verdict(1f, true);
            }
            let _e441 = phi_1115_;
            phi_1116_ = _e441;
        }
        let _e443 = phi_1116_;
        visibility.member[_e66.first_primitive] = _e443.visibility;
        phi_1120_ = _e443.is_doubted;
        phi_1121_ = _e66.first_primitive;
    } else {
        phi_1120_ = false;
        phi_1121_ = 0u;
    }
    let _e448 = phi_1120_;
    let _e450 = phi_1121_;
    if _e448 {
        let _e452 = atomicAdd((&shared_[0u]), 1u);
        phi_1127_ = _e452;
    } else {
        phi_1127_ = 0u;
    }
    let _e454 = phi_1127_;
    workgroupBarrier();
    if (_e51 == 0u) {
        let _e458 = atomicLoad((&shared_[0u]));
        let _e459 = atomicAdd((&list.member[3u]), _e458);
        atomicStore((&shared_[1u]), _e459);
    }
    workgroupBarrier();
    if _e448 {
        let _e462 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e462) + _e454)]), _e450);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
