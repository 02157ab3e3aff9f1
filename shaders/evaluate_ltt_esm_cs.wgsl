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
    var phi_154_: lt_bvh_traverse_Tree;
    var phi_155_: bool;
    var phi_156_: lt_bvh_traverse_Tree;
    var phi_157_: bool;
    var phi_162_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_154_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_155_ = false;
        } else {
            phi_154_ = lt_bvh_traverse_Tree();
            phi_155_ = true;
        }
        let _e63 = phi_154_;
        let _e65 = phi_155_;
        phi_156_ = _e63;
        phi_157_ = _e65;
    } else {
        phi_156_ = lt_bvh_traverse_Tree();
        phi_157_ = true;
    }
    let _e67 = phi_156_;
    let _e69 = phi_157_;
    if _e69 {
        phi_162_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_162_ = _e67;
    }
    let _e74 = phi_162_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_182_: bool;
    var phi_186_: f32;

    let _e51 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_182_ = true;
    } else {
        let _e55 = (84f < _e51);
        if _e55 {
        }
        phi_182_ = _e55;
    }
    let _e57 = phi_182_;
    if _e57 {
        phi_186_ = 84f;
    } else {
        phi_186_ = _e51;
    }
    let _e59 = phi_186_;
    return _e59;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_207_: f32;
    var phi_208_: f32;
    var phi_209_: f32;
    var phi_225_: f32;
    var phi_226_: f32;
    var phi_227_: f32;
    var phi_243_: f32;
    var phi_244_: f32;
    var phi_245_: f32;
    var phi_261_: f32;
    var phi_262_: f32;
    var phi_263_: f32;
    var phi_279_: f32;
    var phi_280_: f32;
    var phi_281_: f32;
    var phi_300_: f32;
    var phi_305_: f32;
    var phi_327_: f32;
    var phi_332_: f32;
    var phi_333_: bool;
    var phi_334_: f32;
    var phi_335_: bool;
    var phi_339_: f32;
    var phi_377_: f32;
    var phi_388_: f32;
    var phi_393_: f32;
    var phi_415_: f32;
    var phi_420_: f32;
    var phi_421_: bool;
    var phi_422_: f32;
    var phi_423_: bool;
    var phi_427_: f32;
    var phi_465_: f32;
    var phi_476_: f32;
    var phi_481_: f32;
    var phi_503_: f32;
    var phi_508_: f32;
    var phi_509_: bool;
    var phi_510_: f32;
    var phi_511_: bool;
    var phi_515_: f32;
    var phi_553_: f32;
    var phi_564_: f32;
    var phi_569_: f32;
    var phi_591_: f32;
    var phi_596_: f32;
    var phi_597_: bool;
    var phi_598_: f32;
    var phi_599_: bool;
    var phi_603_: f32;
    var phi_641_: f32;
    var phi_667_: f32;
    var phi_668_: f32;
    var phi_669_: f32;

    let _e54 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_209_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_208_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_207_ = 1f;
            } else {
                phi_207_ = param_8;
            }
            let _e61 = phi_207_;
            phi_208_ = _e61;
        }
        let _e63 = phi_208_;
        phi_209_ = _e63;
    }
    let _e65 = phi_209_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_227_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_226_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_225_ = 1f;
            } else {
                phi_225_ = param_6.x;
            }
            let _e73 = phi_225_;
            phi_226_ = _e73;
        }
        let _e75 = phi_226_;
        phi_227_ = _e75;
    }
    let _e77 = phi_227_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_245_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_244_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_243_ = 1f;
            } else {
                phi_243_ = param_6.y;
            }
            let _e85 = phi_243_;
            phi_244_ = _e85;
        }
        let _e87 = phi_244_;
        phi_245_ = _e87;
    }
    let _e89 = phi_245_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_263_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_262_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_261_ = 1f;
            } else {
                phi_261_ = param_6.z;
            }
            let _e97 = phi_261_;
            phi_262_ = _e97;
        }
        let _e99 = phi_262_;
        phi_263_ = _e99;
    }
    let _e101 = phi_263_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_281_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_280_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_279_ = 1f;
            } else {
                phi_279_ = param_6.w;
            }
            let _e109 = phi_279_;
            phi_280_ = _e109;
        }
        let _e111 = phi_280_;
        phi_281_ = _e111;
    }
    let _e113 = phi_281_;
    let _e118 = (_e54 * (_e77 - _e65));
    let _e119 = (_e54 * (_e89 - _e65));
    let _e120 = (_e54 * (_e101 - _e65));
    let _e121 = (_e54 * (_e113 - _e65));
    if ((bitcast<u32>(_e118) & 2147483647u) > 2139095040u) {
        phi_377_ = _e118;
    } else {
        if (_e118 < -87f) {
            phi_300_ = -87f;
        } else {
            phi_300_ = _e118;
        }
        let _e127 = phi_300_;
        if (_e127 > 88f) {
            phi_305_ = 88f;
        } else {
            phi_305_ = _e127;
        }
        let _e130 = phi_305_;
        let _e132 = ((_e130 * 1.442695f) + 0.5f);
        if (_e132 > -8388608f) {
            let _e144 = f32(select(0i, select(select(i32(_e132), i32(-2147483648), (_e132 < bitcast<f32>(3472883712u))), 2147483647i, (_e132 > bitcast<f32>(1325400063u))), (_e132 == _e132)));
            if (_e144 > _e132) {
                phi_327_ = 1f;
            } else {
                phi_327_ = 0f;
            }
            let _e147 = phi_327_;
            if (_e132 < 8388608f) {
                phi_332_ = (_e144 - _e147);
                phi_333_ = false;
            } else {
                phi_332_ = f32();
                phi_333_ = true;
            }
            let _e150 = phi_332_;
            let _e152 = phi_333_;
            phi_334_ = _e150;
            phi_335_ = _e152;
        } else {
            phi_334_ = f32();
            phi_335_ = true;
        }
        let _e154 = phi_334_;
        let _e156 = phi_335_;
        if _e156 {
            phi_339_ = _e132;
        } else {
            phi_339_ = _e154;
        }
        let _e158 = phi_339_;
        let _e162 = ((_e130 - (_e158 * 0.69314575f)) - (_e158 * 0.0000014286068f));
        phi_377_ = ((((((((((((((((1f / 5040f) * _e162) + (1f / 720f)) * _e162) + (1f / 120f)) * _e162) + (1f / 24f)) * _e162) + (1f / 6f)) * _e162) + 0.5f) * _e162) + 1f) * _e162) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e158), i32(-2147483648), (_e158 < bitcast<f32>(3472883712u))), 2147483647i, (_e158 > bitcast<f32>(1325400063u))), (_e158 == _e158)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e198 = phi_377_;
    if ((bitcast<u32>(_e119) & 2147483647u) > 2139095040u) {
        phi_465_ = _e119;
    } else {
        if (_e119 < -87f) {
            phi_388_ = -87f;
        } else {
            phi_388_ = _e119;
        }
        let _e204 = phi_388_;
        if (_e204 > 88f) {
            phi_393_ = 88f;
        } else {
            phi_393_ = _e204;
        }
        let _e207 = phi_393_;
        let _e209 = ((_e207 * 1.442695f) + 0.5f);
        if (_e209 > -8388608f) {
            let _e221 = f32(select(0i, select(select(i32(_e209), i32(-2147483648), (_e209 < bitcast<f32>(3472883712u))), 2147483647i, (_e209 > bitcast<f32>(1325400063u))), (_e209 == _e209)));
            if (_e221 > _e209) {
                phi_415_ = 1f;
            } else {
                phi_415_ = 0f;
            }
            let _e224 = phi_415_;
            if (_e209 < 8388608f) {
                phi_420_ = (_e221 - _e224);
                phi_421_ = false;
            } else {
                phi_420_ = f32();
                phi_421_ = true;
            }
            let _e227 = phi_420_;
            let _e229 = phi_421_;
            phi_422_ = _e227;
            phi_423_ = _e229;
        } else {
            phi_422_ = f32();
            phi_423_ = true;
        }
        let _e231 = phi_422_;
        let _e233 = phi_423_;
        if _e233 {
            phi_427_ = _e209;
        } else {
            phi_427_ = _e231;
        }
        let _e235 = phi_427_;
        let _e239 = ((_e207 - (_e235 * 0.69314575f)) - (_e235 * 0.0000014286068f));
        phi_465_ = ((((((((((((((((1f / 5040f) * _e239) + (1f / 720f)) * _e239) + (1f / 120f)) * _e239) + (1f / 24f)) * _e239) + (1f / 6f)) * _e239) + 0.5f) * _e239) + 1f) * _e239) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e235), i32(-2147483648), (_e235 < bitcast<f32>(3472883712u))), 2147483647i, (_e235 > bitcast<f32>(1325400063u))), (_e235 == _e235)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e275 = phi_465_;
    if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
        phi_553_ = _e120;
    } else {
        if (_e120 < -87f) {
            phi_476_ = -87f;
        } else {
            phi_476_ = _e120;
        }
        let _e281 = phi_476_;
        if (_e281 > 88f) {
            phi_481_ = 88f;
        } else {
            phi_481_ = _e281;
        }
        let _e284 = phi_481_;
        let _e286 = ((_e284 * 1.442695f) + 0.5f);
        if (_e286 > -8388608f) {
            let _e298 = f32(select(0i, select(select(i32(_e286), i32(-2147483648), (_e286 < bitcast<f32>(3472883712u))), 2147483647i, (_e286 > bitcast<f32>(1325400063u))), (_e286 == _e286)));
            if (_e298 > _e286) {
                phi_503_ = 1f;
            } else {
                phi_503_ = 0f;
            }
            let _e301 = phi_503_;
            if (_e286 < 8388608f) {
                phi_508_ = (_e298 - _e301);
                phi_509_ = false;
            } else {
                phi_508_ = f32();
                phi_509_ = true;
            }
            let _e304 = phi_508_;
            let _e306 = phi_509_;
            phi_510_ = _e304;
            phi_511_ = _e306;
        } else {
            phi_510_ = f32();
            phi_511_ = true;
        }
        let _e308 = phi_510_;
        let _e310 = phi_511_;
        if _e310 {
            phi_515_ = _e286;
        } else {
            phi_515_ = _e308;
        }
        let _e312 = phi_515_;
        let _e316 = ((_e284 - (_e312 * 0.69314575f)) - (_e312 * 0.0000014286068f));
        phi_553_ = ((((((((((((((((1f / 5040f) * _e316) + (1f / 720f)) * _e316) + (1f / 120f)) * _e316) + (1f / 24f)) * _e316) + (1f / 6f)) * _e316) + 0.5f) * _e316) + 1f) * _e316) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e312), i32(-2147483648), (_e312 < bitcast<f32>(3472883712u))), 2147483647i, (_e312 > bitcast<f32>(1325400063u))), (_e312 == _e312)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e352 = phi_553_;
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_641_ = _e121;
    } else {
        if (_e121 < -87f) {
            phi_564_ = -87f;
        } else {
            phi_564_ = _e121;
        }
        let _e358 = phi_564_;
        if (_e358 > 88f) {
            phi_569_ = 88f;
        } else {
            phi_569_ = _e358;
        }
        let _e361 = phi_569_;
        let _e363 = ((_e361 * 1.442695f) + 0.5f);
        if (_e363 > -8388608f) {
            let _e375 = f32(select(0i, select(select(i32(_e363), i32(-2147483648), (_e363 < bitcast<f32>(3472883712u))), 2147483647i, (_e363 > bitcast<f32>(1325400063u))), (_e363 == _e363)));
            if (_e375 > _e363) {
                phi_591_ = 1f;
            } else {
                phi_591_ = 0f;
            }
            let _e378 = phi_591_;
            if (_e363 < 8388608f) {
                phi_596_ = (_e375 - _e378);
                phi_597_ = false;
            } else {
                phi_596_ = f32();
                phi_597_ = true;
            }
            let _e381 = phi_596_;
            let _e383 = phi_597_;
            phi_598_ = _e381;
            phi_599_ = _e383;
        } else {
            phi_598_ = f32();
            phi_599_ = true;
        }
        let _e385 = phi_598_;
        let _e387 = phi_599_;
        if _e387 {
            phi_603_ = _e363;
        } else {
            phi_603_ = _e385;
        }
        let _e389 = phi_603_;
        let _e393 = ((_e361 - (_e389 * 0.69314575f)) - (_e389 * 0.0000014286068f));
        phi_641_ = ((((((((((((((((1f / 5040f) * _e393) + (1f / 720f)) * _e393) + (1f / 120f)) * _e393) + (1f / 24f)) * _e393) + (1f / 6f)) * _e393) + 0.5f) * _e393) + 1f) * _e393) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e389), i32(-2147483648), (_e389 < bitcast<f32>(3472883712u))), 2147483647i, (_e389 > bitcast<f32>(1325400063u))), (_e389 == _e389)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e429 = phi_641_;
    let _e440 = ((((_e198 * param_7.x) + (_e275 * param_7.y)) + (_e352 * param_7.z)) + (_e429 * param_7.w));
    if ((bitcast<u32>(_e440) & 2147483647u) > 2139095040u) {
        phi_669_ = _e440;
    } else {
        if (_e440 < 0f) {
            phi_668_ = 0f;
        } else {
            if (_e440 > 1f) {
                phi_667_ = 1f;
            } else {
                phi_667_ = _e440;
            }
            let _e447 = phi_667_;
            phi_668_ = _e447;
        }
        let _e449 = phi_668_;
        phi_669_ = _e449;
    }
    let _e451 = phi_669_;
    return _e451;
}

fn function_() {
    var local_1: f32;
    var phi_723_: bool;
    var phi_724_: bool;
    var phi_725_: bool;
    var phi_726_: bool;
    var phi_730_: bool;
    var phi_774_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_778_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_855_: bool;
    var phi_864_: bool;
    var phi_873_: bool;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_876_: bool;
    var phi_877_: bool;
    var phi_878_: bool;
    var phi_879_: bool;
    var phi_883_: bool;
    var phi_977_: f32;
    var phi_980_: f32;
    var phi_1009_: f32;
    var phi_1014_: f32;
    var phi_1015_: bool;
    var phi_1016_: f32;
    var phi_1017_: bool;
    var phi_1021_: f32;
    var phi_1041_: f32;
    var phi_1046_: f32;
    var phi_1047_: bool;
    var phi_1048_: f32;
    var phi_1049_: bool;
    var phi_1053_: f32;
    var phi_1099_: i32;
    var phi_1104_: i32;
    var phi_1109_: i32;
    var phi_1114_: i32;
    var phi_1123_: i32;
    var phi_1128_: i32;
    var phi_1133_: i32;
    var phi_1138_: i32;
    var phi_1185_: bool;
    var phi_1193_: bool;
    var phi_1198_: f32;
    var phi_1201_: evaluate_Verdict;
    var phi_1202_: evaluate_Verdict;
    var phi_1206_: bool;
    var phi_1207_: u32;
    var phi_1213_: u32;

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
                phi_723_ = (_e87 == _e89);
                phi_724_ = false;
            } else {
                phi_723_ = bool();
                phi_724_ = true;
            }
            let _e92 = phi_723_;
            let _e94 = phi_724_;
            phi_725_ = _e92;
            phi_726_ = _e94;
        } else {
            phi_725_ = bool();
            phi_726_ = true;
        }
        let _e96 = phi_725_;
        let _e98 = phi_726_;
        if _e98 {
            phi_730_ = false;
        } else {
            phi_730_ = _e96;
        }
        let _e100 = phi_730_;
        if !(_e100) {
            let _e103 = samples.member[_e67.first_primitive].normal;
            let _e105 = samples.member[_e67.first_primitive].position;
            if ((((_e103.x * (_e74.x - (_e105.x * _e74.w))) + (_e103.y * (_e74.y - (_e105.y * _e74.w)))) + (_e103.z * (_e74.z - (_e105.z * _e74.w)))) > 0f) {
                let _e129 = samples.member[_e67.first_primitive].flags;
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_774_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, ((_e129 & 1u) == 0u));
            } else {
                let _e152 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e152.unnamed.visibility, false), _e152.unnamed_1);
                phi_774_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e158.unnamed, true);
            }
            let _e163 = phi_774_;
            phi_778_ = _e163;
        } else {
            let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e169.unnamed.visibility, false), _e169.unnamed_1);
            phi_778_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e175.unnamed, true);
        }
        let _e180 = phi_778_;
        if _e180.unnamed_1 {
            phi_1202_ = evaluate_Verdict(_e180.unnamed.visibility, _e180.unnamed.is_doubted);
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
                    phi_855_ = (_e219 <= 1f);
                } else {
                    phi_855_ = false;
                }
                let _e251 = phi_855_;
                if _e251 {
                    if (_e233 >= 0f) {
                        phi_864_ = (_e233 <= 1f);
                    } else {
                        phi_864_ = false;
                    }
                    let _e255 = phi_864_;
                    if _e255 {
                        if (_e246 >= 0f) {
                            phi_873_ = (_e246 <= 1f);
                        } else {
                            phi_873_ = false;
                        }
                        let _e259 = phi_873_;
                        phi_874_ = _e259;
                        phi_875_ = false;
                    } else {
                        phi_874_ = bool();
                        phi_875_ = true;
                    }
                    let _e261 = phi_874_;
                    let _e263 = phi_875_;
                    phi_876_ = _e261;
                    phi_877_ = _e263;
                } else {
                    phi_876_ = bool();
                    phi_877_ = true;
                }
                let _e265 = phi_876_;
                let _e267 = phi_877_;
                phi_878_ = _e265;
                phi_879_ = _e267;
            } else {
                phi_878_ = bool();
                phi_879_ = true;
            }
            let _e269 = phi_878_;
            let _e271 = phi_879_;
            if _e271 {
                phi_883_ = false;
            } else {
                phi_883_ = _e269;
            }
            let _e273 = phi_883_;
            if _e273 {
                if (0f > 0f) {
                    let _e276 = samples.member[_e67.first_primitive].normal;
                    let _e278 = p.member.map_size;
                    let _e281 = p.member.projection.row_x;
                    let _e303 = p.member.projection.row_y;
                    let _e325 = p.member.projection.row_z;
                    let _e352 = ((abs(((((_e281.x * _e276.x) + (_e281.y * _e276.y)) + (_e281.z * _e276.z)) / (((_e281.x * _e281.x) + (_e281.y * _e281.y)) + (_e281.z * _e281.z)))) + abs(((((_e303.x * _e276.x) + (_e303.y * _e276.y)) + (_e303.z * _e276.z)) / (((_e303.x * _e303.x) + (_e303.y * _e303.y)) + (_e303.z * _e303.z))))) / (abs(((((_e325.x * _e276.x) + (_e325.y * _e276.y)) + (_e325.z * _e276.z)) / (((_e325.x * _e325.x) + (_e325.y * _e325.y)) + (_e325.z * _e325.z)))) * f32(_e278)));
                    if (_e352 < 0.002f) {
                        phi_977_ = _e352;
                    } else {
                        phi_977_ = 0.002f;
                    }
                    let _e355 = phi_977_;
                    phi_980_ = (_e246 - (0f * _e355));
                } else {
                    phi_980_ = _e246;
                }
                let _e359 = phi_980_;
                let _e361 = p.member.map_size;
                let _e362 = f32(_e361);
                let _e365 = ((_e219 * _e362) - 0.5f);
                let _e366 = ((_e233 * _e362) - 0.5f);
                if (_e365 > -8388608f) {
                    let _e378 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e378 > _e365) {
                        phi_1009_ = 1f;
                    } else {
                        phi_1009_ = 0f;
                    }
                    let _e381 = phi_1009_;
                    if (_e365 < 8388608f) {
                        phi_1014_ = (_e378 - _e381);
                        phi_1015_ = false;
                    } else {
                        phi_1014_ = f32();
                        phi_1015_ = true;
                    }
                    let _e384 = phi_1014_;
                    let _e386 = phi_1015_;
                    phi_1016_ = _e384;
                    phi_1017_ = _e386;
                } else {
                    phi_1016_ = f32();
                    phi_1017_ = true;
                }
                let _e388 = phi_1016_;
                let _e390 = phi_1017_;
                if _e390 {
                    phi_1021_ = _e365;
                } else {
                    phi_1021_ = _e388;
                }
                let _e392 = phi_1021_;
                if (_e366 > -8388608f) {
                    let _e404 = f32(select(0i, select(select(i32(_e366), i32(-2147483648), (_e366 < bitcast<f32>(3472883712u))), 2147483647i, (_e366 > bitcast<f32>(1325400063u))), (_e366 == _e366)));
                    if (_e404 > _e366) {
                        phi_1041_ = 1f;
                    } else {
                        phi_1041_ = 0f;
                    }
                    let _e407 = phi_1041_;
                    if (_e366 < 8388608f) {
                        phi_1046_ = (_e404 - _e407);
                        phi_1047_ = false;
                    } else {
                        phi_1046_ = f32();
                        phi_1047_ = true;
                    }
                    let _e410 = phi_1046_;
                    let _e412 = phi_1047_;
                    phi_1048_ = _e410;
                    phi_1049_ = _e412;
                } else {
                    phi_1048_ = f32();
                    phi_1049_ = true;
                }
                let _e414 = phi_1048_;
                let _e416 = phi_1049_;
                if _e416 {
                    phi_1053_ = _e366;
                } else {
                    phi_1053_ = _e414;
                }
                let _e418 = phi_1053_;
                let _e419 = (_e365 - _e392);
                let _e420 = (_e366 - _e418);
                let _e429 = select(0i, select(select(i32(_e392), i32(-2147483648), (_e392 < bitcast<f32>(3472883712u))), 2147483647i, (_e392 > bitcast<f32>(1325400063u))), (_e392 == _e392));
                let _e438 = select(0i, select(select(i32(_e418), i32(-2147483648), (_e418 < bitcast<f32>(3472883712u))), 2147483647i, (_e418 > bitcast<f32>(1325400063u))), (_e418 == _e418));
                let _e449 = p.member.test;
                let _e450 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e449);
                let _e452 = p.member.map_size;
                local_1 = _e450;
                let _e454 = (bitcast<i32>(_e452) - 1i);
                if (_e429 > 0i) {
                    phi_1099_ = _e429;
                } else {
                    phi_1099_ = 0i;
                }
                let _e457 = phi_1099_;
                if (_e438 > 0i) {
                    phi_1104_ = _e438;
                } else {
                    phi_1104_ = 0i;
                }
                let _e460 = phi_1104_;
                if (_e457 < _e454) {
                    phi_1109_ = _e457;
                } else {
                    phi_1109_ = _e454;
                }
                let _e463 = phi_1109_;
                if (_e460 < _e454) {
                    phi_1114_ = _e460;
                } else {
                    phi_1114_ = _e454;
                }
                let _e466 = phi_1114_;
                let _e467 = bitcast<u32>(_e463);
                let _e469 = (_e429 + 1i);
                let _e470 = (_e438 + 1i);
                if (_e469 > 0i) {
                    phi_1123_ = _e469;
                } else {
                    phi_1123_ = 0i;
                }
                let _e473 = phi_1123_;
                if (_e470 > 0i) {
                    phi_1128_ = _e470;
                } else {
                    phi_1128_ = 0i;
                }
                let _e476 = phi_1128_;
                if (_e473 < _e454) {
                    phi_1133_ = _e473;
                } else {
                    phi_1133_ = _e454;
                }
                let _e479 = phi_1133_;
                if (_e476 < _e454) {
                    phi_1138_ = _e476;
                } else {
                    phi_1138_ = _e454;
                }
                let _e482 = phi_1138_;
                let _e483 = bitcast<u32>(_e479);
                let _e485 = (bitcast<u32>(_e466) * _e452);
                let _e486 = (bitcast<u32>(_e482) * _e452);
                let _e487 = (_e485 + _e467);
                let _e488 = (_e485 + _e483);
                let _e489 = (_e486 + _e467);
                let _e490 = (_e486 + _e483);
                if (_e487 < _e57) {
                } else {
                    return;
                }
                let _e494 = map.member[(0u + _e487)];
                if (_e488 < _e57) {
                } else {
                    return;
                }
                let _e498 = map.member[(0u + _e488)];
                if (_e489 < _e57) {
                } else {
                    return;
                }
                let _e502 = map.member[(0u + _e489)];
                if (_e490 < _e57) {
                } else {
                    return;
                }
                let _e506 = map.member[(0u + _e490)];
                let _e508 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e494, _e498, _e502, _e506), vec4<f32>(((1f - _e419) * (1f - _e420)), (_e419 * (1f - _e420)), ((1f - _e419) * _e420), (_e419 * _e420)), _e359);
                let _e510 = p.member.epsilon;
                if (_e508 <= _e510) {
                    phi_1185_ = true;
                } else {
                    phi_1185_ = (_e508 >= (1f - _e510));
                }
                let _e515 = phi_1185_;
                if ((bitcast<u32>(_e508) & 2147483647u) > 2139095040u) {
                    phi_1193_ = true;
                } else {
                    phi_1193_ = !(_e515);
                }
                let _e521 = phi_1193_;
                if (_e508 > 0.5f) {
                    phi_1198_ = 1f;
                } else {
                    phi_1198_ = 0f;
                }
                let _e524 = phi_1198_;
                phi_1201_ = evaluate_Verdict(_e524, _e521);
            } else {
                phi_1201_ = evaluate_Verdict(1f, true);
            }
            let _e528 = phi_1201_;
            phi_1202_ = _e528;
        }
        let _e530 = phi_1202_;
        visibility.member[_e67.first_primitive] = _e530.visibility;
        phi_1206_ = _e530.is_doubted;
        phi_1207_ = _e67.first_primitive;
    } else {
        phi_1206_ = false;
        phi_1207_ = 0u;
    }
    let _e535 = phi_1206_;
    let _e537 = phi_1207_;
    if _e535 {
        let _e539 = atomicAdd((&shared_[0u]), 1u);
        phi_1213_ = _e539;
    } else {
        phi_1213_ = 0u;
    }
    let _e541 = phi_1213_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e545 = atomicLoad((&shared_[0u]));
        let _e546 = atomicAdd((&list.member[3u]), _e545);
        atomicStore((&shared_[1u]), _e546);
    }
    workgroupBarrier();
    if _e535 {
        let _e549 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e549) + _e541)]), _e537);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
