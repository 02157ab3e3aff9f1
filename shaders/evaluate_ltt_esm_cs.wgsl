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
    var phi_152_: lt_bvh_traverse_Tree;
    var phi_153_: bool;
    var phi_154_: lt_bvh_traverse_Tree;
    var phi_155_: bool;
    var phi_160_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_152_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_153_ = false;
        } else {
            phi_152_ = lt_bvh_traverse_Tree();
            phi_153_ = true;
        }
        let _e62 = phi_152_;
        let _e64 = phi_153_;
        phi_154_ = _e62;
        phi_155_ = _e64;
    } else {
        phi_154_ = lt_bvh_traverse_Tree();
        phi_155_ = true;
    }
    let _e66 = phi_154_;
    let _e68 = phi_155_;
    if _e68 {
        phi_160_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_160_ = _e66;
    }
    let _e73 = phi_160_;
    return lt_bvh_traverse_Tree(_e73.root, _e73.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_180_: bool;
    var phi_184_: f32;

    let _e50 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_180_ = true;
    } else {
        let _e54 = (84f < _e50);
        if _e54 {
        }
        phi_180_ = _e54;
    }
    let _e56 = phi_180_;
    if _e56 {
        phi_184_ = 84f;
    } else {
        phi_184_ = _e50;
    }
    let _e58 = phi_184_;
    return _e58;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_205_: f32;
    var phi_206_: f32;
    var phi_207_: f32;
    var phi_223_: f32;
    var phi_224_: f32;
    var phi_225_: f32;
    var phi_241_: f32;
    var phi_242_: f32;
    var phi_243_: f32;
    var phi_259_: f32;
    var phi_260_: f32;
    var phi_261_: f32;
    var phi_277_: f32;
    var phi_278_: f32;
    var phi_279_: f32;
    var phi_298_: f32;
    var phi_303_: f32;
    var phi_325_: f32;
    var phi_330_: f32;
    var phi_331_: bool;
    var phi_332_: f32;
    var phi_333_: bool;
    var phi_337_: f32;
    var phi_375_: f32;
    var phi_386_: f32;
    var phi_391_: f32;
    var phi_413_: f32;
    var phi_418_: f32;
    var phi_419_: bool;
    var phi_420_: f32;
    var phi_421_: bool;
    var phi_425_: f32;
    var phi_463_: f32;
    var phi_474_: f32;
    var phi_479_: f32;
    var phi_501_: f32;
    var phi_506_: f32;
    var phi_507_: bool;
    var phi_508_: f32;
    var phi_509_: bool;
    var phi_513_: f32;
    var phi_551_: f32;
    var phi_562_: f32;
    var phi_567_: f32;
    var phi_589_: f32;
    var phi_594_: f32;
    var phi_595_: bool;
    var phi_596_: f32;
    var phi_597_: bool;
    var phi_601_: f32;
    var phi_639_: f32;
    var phi_665_: f32;
    var phi_666_: f32;
    var phi_667_: f32;

    let _e53 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_207_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_206_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_205_ = 1f;
            } else {
                phi_205_ = param_8;
            }
            let _e60 = phi_205_;
            phi_206_ = _e60;
        }
        let _e62 = phi_206_;
        phi_207_ = _e62;
    }
    let _e64 = phi_207_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_225_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_224_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_223_ = 1f;
            } else {
                phi_223_ = param_6.x;
            }
            let _e72 = phi_223_;
            phi_224_ = _e72;
        }
        let _e74 = phi_224_;
        phi_225_ = _e74;
    }
    let _e76 = phi_225_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_243_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_242_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_241_ = 1f;
            } else {
                phi_241_ = param_6.y;
            }
            let _e84 = phi_241_;
            phi_242_ = _e84;
        }
        let _e86 = phi_242_;
        phi_243_ = _e86;
    }
    let _e88 = phi_243_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_261_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_260_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_259_ = 1f;
            } else {
                phi_259_ = param_6.z;
            }
            let _e96 = phi_259_;
            phi_260_ = _e96;
        }
        let _e98 = phi_260_;
        phi_261_ = _e98;
    }
    let _e100 = phi_261_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_279_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_278_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_277_ = 1f;
            } else {
                phi_277_ = param_6.w;
            }
            let _e108 = phi_277_;
            phi_278_ = _e108;
        }
        let _e110 = phi_278_;
        phi_279_ = _e110;
    }
    let _e112 = phi_279_;
    let _e117 = (_e53 * (_e76 - _e64));
    let _e118 = (_e53 * (_e88 - _e64));
    let _e119 = (_e53 * (_e100 - _e64));
    let _e120 = (_e53 * (_e112 - _e64));
    if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
        phi_375_ = _e117;
    } else {
        if (_e117 < -87f) {
            phi_298_ = -87f;
        } else {
            phi_298_ = _e117;
        }
        let _e126 = phi_298_;
        if (_e126 > 88f) {
            phi_303_ = 88f;
        } else {
            phi_303_ = _e126;
        }
        let _e129 = phi_303_;
        let _e131 = ((_e129 * 1.442695f) + 0.5f);
        if (_e131 > -8388608f) {
            let _e143 = f32(select(0i, select(select(i32(_e131), i32(-2147483648), (_e131 < bitcast<f32>(3472883712u))), 2147483647i, (_e131 > bitcast<f32>(1325400063u))), (_e131 == _e131)));
            if (_e143 > _e131) {
                phi_325_ = 1f;
            } else {
                phi_325_ = 0f;
            }
            let _e146 = phi_325_;
            if (_e131 < 8388608f) {
                phi_330_ = (_e143 - _e146);
                phi_331_ = false;
            } else {
                phi_330_ = f32();
                phi_331_ = true;
            }
            let _e149 = phi_330_;
            let _e151 = phi_331_;
            phi_332_ = _e149;
            phi_333_ = _e151;
        } else {
            phi_332_ = f32();
            phi_333_ = true;
        }
        let _e153 = phi_332_;
        let _e155 = phi_333_;
        if _e155 {
            phi_337_ = _e131;
        } else {
            phi_337_ = _e153;
        }
        let _e157 = phi_337_;
        let _e161 = ((_e129 - (_e157 * 0.69314575f)) - (_e157 * 0.0000014286068f));
        phi_375_ = ((((((((((((((((1f / 5040f) * _e161) + (1f / 720f)) * _e161) + (1f / 120f)) * _e161) + (1f / 24f)) * _e161) + (1f / 6f)) * _e161) + 0.5f) * _e161) + 1f) * _e161) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e157), i32(-2147483648), (_e157 < bitcast<f32>(3472883712u))), 2147483647i, (_e157 > bitcast<f32>(1325400063u))), (_e157 == _e157)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e197 = phi_375_;
    if ((bitcast<u32>(_e118) & 2147483647u) > 2139095040u) {
        phi_463_ = _e118;
    } else {
        if (_e118 < -87f) {
            phi_386_ = -87f;
        } else {
            phi_386_ = _e118;
        }
        let _e203 = phi_386_;
        if (_e203 > 88f) {
            phi_391_ = 88f;
        } else {
            phi_391_ = _e203;
        }
        let _e206 = phi_391_;
        let _e208 = ((_e206 * 1.442695f) + 0.5f);
        if (_e208 > -8388608f) {
            let _e220 = f32(select(0i, select(select(i32(_e208), i32(-2147483648), (_e208 < bitcast<f32>(3472883712u))), 2147483647i, (_e208 > bitcast<f32>(1325400063u))), (_e208 == _e208)));
            if (_e220 > _e208) {
                phi_413_ = 1f;
            } else {
                phi_413_ = 0f;
            }
            let _e223 = phi_413_;
            if (_e208 < 8388608f) {
                phi_418_ = (_e220 - _e223);
                phi_419_ = false;
            } else {
                phi_418_ = f32();
                phi_419_ = true;
            }
            let _e226 = phi_418_;
            let _e228 = phi_419_;
            phi_420_ = _e226;
            phi_421_ = _e228;
        } else {
            phi_420_ = f32();
            phi_421_ = true;
        }
        let _e230 = phi_420_;
        let _e232 = phi_421_;
        if _e232 {
            phi_425_ = _e208;
        } else {
            phi_425_ = _e230;
        }
        let _e234 = phi_425_;
        let _e238 = ((_e206 - (_e234 * 0.69314575f)) - (_e234 * 0.0000014286068f));
        phi_463_ = ((((((((((((((((1f / 5040f) * _e238) + (1f / 720f)) * _e238) + (1f / 120f)) * _e238) + (1f / 24f)) * _e238) + (1f / 6f)) * _e238) + 0.5f) * _e238) + 1f) * _e238) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e234), i32(-2147483648), (_e234 < bitcast<f32>(3472883712u))), 2147483647i, (_e234 > bitcast<f32>(1325400063u))), (_e234 == _e234)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e274 = phi_463_;
    if ((bitcast<u32>(_e119) & 2147483647u) > 2139095040u) {
        phi_551_ = _e119;
    } else {
        if (_e119 < -87f) {
            phi_474_ = -87f;
        } else {
            phi_474_ = _e119;
        }
        let _e280 = phi_474_;
        if (_e280 > 88f) {
            phi_479_ = 88f;
        } else {
            phi_479_ = _e280;
        }
        let _e283 = phi_479_;
        let _e285 = ((_e283 * 1.442695f) + 0.5f);
        if (_e285 > -8388608f) {
            let _e297 = f32(select(0i, select(select(i32(_e285), i32(-2147483648), (_e285 < bitcast<f32>(3472883712u))), 2147483647i, (_e285 > bitcast<f32>(1325400063u))), (_e285 == _e285)));
            if (_e297 > _e285) {
                phi_501_ = 1f;
            } else {
                phi_501_ = 0f;
            }
            let _e300 = phi_501_;
            if (_e285 < 8388608f) {
                phi_506_ = (_e297 - _e300);
                phi_507_ = false;
            } else {
                phi_506_ = f32();
                phi_507_ = true;
            }
            let _e303 = phi_506_;
            let _e305 = phi_507_;
            phi_508_ = _e303;
            phi_509_ = _e305;
        } else {
            phi_508_ = f32();
            phi_509_ = true;
        }
        let _e307 = phi_508_;
        let _e309 = phi_509_;
        if _e309 {
            phi_513_ = _e285;
        } else {
            phi_513_ = _e307;
        }
        let _e311 = phi_513_;
        let _e315 = ((_e283 - (_e311 * 0.69314575f)) - (_e311 * 0.0000014286068f));
        phi_551_ = ((((((((((((((((1f / 5040f) * _e315) + (1f / 720f)) * _e315) + (1f / 120f)) * _e315) + (1f / 24f)) * _e315) + (1f / 6f)) * _e315) + 0.5f) * _e315) + 1f) * _e315) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e311), i32(-2147483648), (_e311 < bitcast<f32>(3472883712u))), 2147483647i, (_e311 > bitcast<f32>(1325400063u))), (_e311 == _e311)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e351 = phi_551_;
    if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
        phi_639_ = _e120;
    } else {
        if (_e120 < -87f) {
            phi_562_ = -87f;
        } else {
            phi_562_ = _e120;
        }
        let _e357 = phi_562_;
        if (_e357 > 88f) {
            phi_567_ = 88f;
        } else {
            phi_567_ = _e357;
        }
        let _e360 = phi_567_;
        let _e362 = ((_e360 * 1.442695f) + 0.5f);
        if (_e362 > -8388608f) {
            let _e374 = f32(select(0i, select(select(i32(_e362), i32(-2147483648), (_e362 < bitcast<f32>(3472883712u))), 2147483647i, (_e362 > bitcast<f32>(1325400063u))), (_e362 == _e362)));
            if (_e374 > _e362) {
                phi_589_ = 1f;
            } else {
                phi_589_ = 0f;
            }
            let _e377 = phi_589_;
            if (_e362 < 8388608f) {
                phi_594_ = (_e374 - _e377);
                phi_595_ = false;
            } else {
                phi_594_ = f32();
                phi_595_ = true;
            }
            let _e380 = phi_594_;
            let _e382 = phi_595_;
            phi_596_ = _e380;
            phi_597_ = _e382;
        } else {
            phi_596_ = f32();
            phi_597_ = true;
        }
        let _e384 = phi_596_;
        let _e386 = phi_597_;
        if _e386 {
            phi_601_ = _e362;
        } else {
            phi_601_ = _e384;
        }
        let _e388 = phi_601_;
        let _e392 = ((_e360 - (_e388 * 0.69314575f)) - (_e388 * 0.0000014286068f));
        phi_639_ = ((((((((((((((((1f / 5040f) * _e392) + (1f / 720f)) * _e392) + (1f / 120f)) * _e392) + (1f / 24f)) * _e392) + (1f / 6f)) * _e392) + 0.5f) * _e392) + 1f) * _e392) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e388), i32(-2147483648), (_e388 < bitcast<f32>(3472883712u))), 2147483647i, (_e388 > bitcast<f32>(1325400063u))), (_e388 == _e388)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e428 = phi_639_;
    let _e439 = ((((_e197 * param_7.x) + (_e274 * param_7.y)) + (_e351 * param_7.z)) + (_e428 * param_7.w));
    if ((bitcast<u32>(_e439) & 2147483647u) > 2139095040u) {
        phi_667_ = _e439;
    } else {
        if (_e439 < 0f) {
            phi_666_ = 0f;
        } else {
            if (_e439 > 1f) {
                phi_665_ = 1f;
            } else {
                phi_665_ = _e439;
            }
            let _e446 = phi_665_;
            phi_666_ = _e446;
        }
        let _e448 = phi_666_;
        phi_667_ = _e448;
    }
    let _e450 = phi_667_;
    return _e450;
}

fn function_() {
    var local_1: f32;
    var phi_721_: bool;
    var phi_722_: bool;
    var phi_723_: bool;
    var phi_724_: bool;
    var phi_728_: bool;
    var phi_772_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_776_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_853_: bool;
    var phi_862_: bool;
    var phi_871_: bool;
    var phi_872_: bool;
    var phi_873_: bool;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_876_: bool;
    var phi_877_: bool;
    var phi_881_: bool;
    var phi_917_: f32;
    var phi_922_: f32;
    var phi_923_: bool;
    var phi_924_: f32;
    var phi_925_: bool;
    var phi_929_: f32;
    var phi_949_: f32;
    var phi_954_: f32;
    var phi_955_: bool;
    var phi_956_: f32;
    var phi_957_: bool;
    var phi_961_: f32;
    var phi_1007_: i32;
    var phi_1012_: i32;
    var phi_1017_: i32;
    var phi_1022_: i32;
    var phi_1031_: i32;
    var phi_1036_: i32;
    var phi_1041_: i32;
    var phi_1046_: i32;
    var phi_1093_: bool;
    var phi_1101_: bool;
    var phi_1106_: f32;
    var phi_1109_: evaluate_Verdict;
    var phi_1110_: evaluate_Verdict;
    var phi_1114_: bool;
    var phi_1115_: u32;
    var phi_1121_: u32;

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
                phi_721_ = (_e86 == _e88);
                phi_722_ = false;
            } else {
                phi_721_ = bool();
                phi_722_ = true;
            }
            let _e91 = phi_721_;
            let _e93 = phi_722_;
            phi_723_ = _e91;
            phi_724_ = _e93;
        } else {
            phi_723_ = bool();
            phi_724_ = true;
        }
        let _e95 = phi_723_;
        let _e97 = phi_724_;
        if _e97 {
            phi_728_ = false;
        } else {
            phi_728_ = _e95;
        }
        let _e99 = phi_728_;
        if !(_e99) {
            let _e102 = samples.member[_e66.first_primitive].normal;
            let _e104 = samples.member[_e66.first_primitive].position;
            if ((((_e102.x * (_e73.x - (_e104.x * _e73.w))) + (_e102.y * (_e73.y - (_e104.y * _e73.w)))) + (_e102.z * (_e73.z - (_e104.z * _e73.w)))) > 0f) {
                let _e128 = samples.member[_e66.first_primitive].flags;
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e136.unnamed.visibility, false), _e136.unnamed_1);
                phi_772_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e142.unnamed, ((_e128 & 1u) == 0u));
            } else {
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e151.unnamed.visibility, false), _e151.unnamed_1);
                phi_772_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e157.unnamed, true);
            }
            let _e162 = phi_772_;
            phi_776_ = _e162;
        } else {
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
            phi_776_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
        }
        let _e179 = phi_776_;
        if _e179.unnamed_1 {
            phi_1110_ = evaluate_Verdict(_e179.unnamed.visibility, _e179.unnamed.is_doubted);
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
                    phi_853_ = (_e218 <= 1f);
                } else {
                    phi_853_ = false;
                }
                let _e250 = phi_853_;
                if _e250 {
                    if (_e232 >= 0f) {
                        phi_862_ = (_e232 <= 1f);
                    } else {
                        phi_862_ = false;
                    }
                    let _e254 = phi_862_;
                    if _e254 {
                        if (_e245 >= 0f) {
                            phi_871_ = (_e245 <= 1f);
                        } else {
                            phi_871_ = false;
                        }
                        let _e258 = phi_871_;
                        phi_872_ = _e258;
                        phi_873_ = false;
                    } else {
                        phi_872_ = bool();
                        phi_873_ = true;
                    }
                    let _e260 = phi_872_;
                    let _e262 = phi_873_;
                    phi_874_ = _e260;
                    phi_875_ = _e262;
                } else {
                    phi_874_ = bool();
                    phi_875_ = true;
                }
                let _e264 = phi_874_;
                let _e266 = phi_875_;
                phi_876_ = _e264;
                phi_877_ = _e266;
            } else {
                phi_876_ = bool();
                phi_877_ = true;
            }
            let _e268 = phi_876_;
            let _e270 = phi_877_;
            if _e270 {
                phi_881_ = false;
            } else {
                phi_881_ = _e268;
            }
            let _e272 = phi_881_;
            if _e272 {
                let _e274 = p.member.map_size;
                let _e275 = f32(_e274);
                let _e278 = ((_e218 * _e275) - 0.5f);
                let _e279 = ((_e232 * _e275) - 0.5f);
                if (_e278 > -8388608f) {
                    let _e291 = f32(select(0i, select(select(i32(_e278), i32(-2147483648), (_e278 < bitcast<f32>(3472883712u))), 2147483647i, (_e278 > bitcast<f32>(1325400063u))), (_e278 == _e278)));
                    if (_e291 > _e278) {
                        phi_917_ = 1f;
                    } else {
                        phi_917_ = 0f;
                    }
                    let _e294 = phi_917_;
                    if (_e278 < 8388608f) {
                        phi_922_ = (_e291 - _e294);
                        phi_923_ = false;
                    } else {
                        phi_922_ = f32();
                        phi_923_ = true;
                    }
                    let _e297 = phi_922_;
                    let _e299 = phi_923_;
                    phi_924_ = _e297;
                    phi_925_ = _e299;
                } else {
                    phi_924_ = f32();
                    phi_925_ = true;
                }
                let _e301 = phi_924_;
                let _e303 = phi_925_;
                if _e303 {
                    phi_929_ = _e278;
                } else {
                    phi_929_ = _e301;
                }
                let _e305 = phi_929_;
                if (_e279 > -8388608f) {
                    let _e317 = f32(select(0i, select(select(i32(_e279), i32(-2147483648), (_e279 < bitcast<f32>(3472883712u))), 2147483647i, (_e279 > bitcast<f32>(1325400063u))), (_e279 == _e279)));
                    if (_e317 > _e279) {
                        phi_949_ = 1f;
                    } else {
                        phi_949_ = 0f;
                    }
                    let _e320 = phi_949_;
                    if (_e279 < 8388608f) {
                        phi_954_ = (_e317 - _e320);
                        phi_955_ = false;
                    } else {
                        phi_954_ = f32();
                        phi_955_ = true;
                    }
                    let _e323 = phi_954_;
                    let _e325 = phi_955_;
                    phi_956_ = _e323;
                    phi_957_ = _e325;
                } else {
                    phi_956_ = f32();
                    phi_957_ = true;
                }
                let _e327 = phi_956_;
                let _e329 = phi_957_;
                if _e329 {
                    phi_961_ = _e279;
                } else {
                    phi_961_ = _e327;
                }
                let _e331 = phi_961_;
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
                    phi_1007_ = _e342;
                } else {
                    phi_1007_ = 0i;
                }
                let _e370 = phi_1007_;
                if (_e351 > 0i) {
                    phi_1012_ = _e351;
                } else {
                    phi_1012_ = 0i;
                }
                let _e373 = phi_1012_;
                if (_e370 < _e367) {
                    phi_1017_ = _e370;
                } else {
                    phi_1017_ = _e367;
                }
                let _e376 = phi_1017_;
                if (_e373 < _e367) {
                    phi_1022_ = _e373;
                } else {
                    phi_1022_ = _e367;
                }
                let _e379 = phi_1022_;
                let _e380 = bitcast<u32>(_e376);
                let _e382 = (_e342 + 1i);
                let _e383 = (_e351 + 1i);
                if (_e382 > 0i) {
                    phi_1031_ = _e382;
                } else {
                    phi_1031_ = 0i;
                }
                let _e386 = phi_1031_;
                if (_e383 > 0i) {
                    phi_1036_ = _e383;
                } else {
                    phi_1036_ = 0i;
                }
                let _e389 = phi_1036_;
                if (_e386 < _e367) {
                    phi_1041_ = _e386;
                } else {
                    phi_1041_ = _e367;
                }
                let _e392 = phi_1041_;
                if (_e389 < _e367) {
                    phi_1046_ = _e389;
                } else {
                    phi_1046_ = _e367;
                }
                let _e395 = phi_1046_;
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
                    phi_1093_ = true;
                } else {
                    phi_1093_ = (_e421 >= (1f - _e423));
                }
                let _e428 = phi_1093_;
                if ((bitcast<u32>(_e421) & 2147483647u) > 2139095040u) {
                    phi_1101_ = true;
                } else {
                    phi_1101_ = !(_e428);
                }
                let _e434 = phi_1101_;
                if (_e421 > 0.5f) {
                    phi_1106_ = 1f;
                } else {
                    phi_1106_ = 0f;
                }
                let _e437 = phi_1106_;
                phi_1109_ = evaluate_Verdict(_e437, _e434);
            } else {
                phi_1109_ = evaluate_Verdict(1f, true);
            }
            let _e441 = phi_1109_;
            phi_1110_ = _e441;
        }
        let _e443 = phi_1110_;
        visibility.member[_e66.first_primitive] = _e443.visibility;
        phi_1114_ = _e443.is_doubted;
        phi_1115_ = _e66.first_primitive;
    } else {
        phi_1114_ = false;
        phi_1115_ = 0u;
    }
    let _e448 = phi_1114_;
    let _e450 = phi_1115_;
    if _e448 {
        let _e452 = atomicAdd((&shared_[0u]), 1u);
        phi_1121_ = _e452;
    } else {
        phi_1121_ = 0u;
    }
    let _e454 = phi_1121_;
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
