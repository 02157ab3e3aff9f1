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

struct type_31 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_147_: lt_bvh_traverse_Tree;
    var phi_148_: bool;
    var phi_149_: lt_bvh_traverse_Tree;
    var phi_150_: bool;
    var phi_155_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_147_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_148_ = false;
        } else {
            phi_147_ = lt_bvh_traverse_Tree();
            phi_148_ = true;
        }
        let _e60 = phi_147_;
        let _e62 = phi_148_;
        phi_149_ = _e60;
        phi_150_ = _e62;
    } else {
        phi_149_ = lt_bvh_traverse_Tree();
        phi_150_ = true;
    }
    let _e64 = phi_149_;
    let _e66 = phi_150_;
    if _e66 {
        phi_155_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_155_ = _e64;
    }
    let _e71 = phi_155_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_positive(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_179_: bool;
    var phi_183_: f32;

    let _e49 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_179_ = true;
    } else {
        let _e53 = (42f < _e49);
        if _e53 {
        }
        phi_179_ = _e53;
    }
    let _e55 = phi_179_;
    if _e55 {
        phi_183_ = 42f;
    } else {
        phi_183_ = _e49;
    }
    let _e57 = phi_183_;
    return _e57;
}

fn _lt_math_evsm_Evsm_negative(param_5: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_198_: bool;
    var phi_202_: f32;

    let _e49 = (*param_5).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_198_ = true;
    } else {
        let _e53 = (42f < _e49);
        if _e53 {
        }
        phi_198_ = _e53;
    }
    let _e55 = phi_198_;
    if _e55 {
        phi_202_ = 42f;
    } else {
        phi_202_ = _e49;
    }
    let _e57 = phi_202_;
    return _e57;
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: vec4<f32>) -> f32 {
    var phi_380_: f32;
    var phi_385_: f32;
    var phi_407_: f32;
    var phi_412_: f32;
    var phi_413_: bool;
    var phi_414_: f32;
    var phi_415_: bool;
    var phi_419_: f32;
    var phi_457_: f32;
    var phi_468_: f32;
    var phi_473_: f32;
    var phi_495_: f32;
    var phi_500_: f32;
    var phi_501_: bool;
    var phi_502_: f32;
    var phi_503_: bool;
    var phi_507_: f32;
    var phi_545_: f32;
    var phi_556_: f32;
    var phi_561_: f32;
    var phi_583_: f32;
    var phi_588_: f32;
    var phi_589_: bool;
    var phi_590_: f32;
    var phi_591_: bool;
    var phi_595_: f32;
    var phi_633_: f32;
    var phi_644_: f32;
    var phi_649_: f32;
    var phi_671_: f32;
    var phi_676_: f32;
    var phi_677_: bool;
    var phi_678_: f32;
    var phi_679_: bool;
    var phi_683_: f32;
    var phi_721_: f32;
    var phi_774_: bool;
    var phi_778_: f32;
    var phi_790_: bool;
    var phi_797_: f32;
    var phi_818_: f32;
    var phi_823_: f32;
    var phi_845_: f32;
    var phi_850_: f32;
    var phi_851_: bool;
    var phi_852_: f32;
    var phi_853_: bool;
    var phi_857_: f32;
    var phi_895_: f32;
    var phi_906_: f32;
    var phi_911_: f32;
    var phi_933_: f32;
    var phi_938_: f32;
    var phi_939_: bool;
    var phi_940_: f32;
    var phi_941_: bool;
    var phi_945_: f32;
    var phi_983_: f32;
    var phi_994_: f32;
    var phi_999_: f32;
    var phi_1021_: f32;
    var phi_1026_: f32;
    var phi_1027_: bool;
    var phi_1028_: f32;
    var phi_1029_: bool;
    var phi_1033_: f32;
    var phi_1071_: f32;
    var phi_1082_: f32;
    var phi_1087_: f32;
    var phi_1109_: f32;
    var phi_1114_: f32;
    var phi_1115_: bool;
    var phi_1116_: f32;
    var phi_1117_: bool;
    var phi_1121_: f32;
    var phi_1159_: f32;
    var phi_1212_: bool;
    var phi_1216_: f32;
    var phi_1228_: bool;
    var phi_1235_: f32;
    var phi_1246_: bool;
    var phi_1250_: f32;
    var phi_1265_: f32;
    var phi_1266_: f32;
    var phi_1267_: f32;

    let _e50 = _lt_math_evsm_Evsm_positive(param_6);
    let _e52 = (_e50 * param_7.x);
    let _e54 = (_e50 * param_7.y);
    let _e56 = (_e50 * param_7.z);
    let _e58 = (_e50 * param_7.w);
    if ((bitcast<u32>(_e52) & 2147483647u) > 2139095040u) {
        phi_457_ = _e52;
    } else {
        if (_e52 < -87f) {
            phi_380_ = -87f;
        } else {
            phi_380_ = _e52;
        }
        let _e64 = phi_380_;
        if (_e64 > 88f) {
            phi_385_ = 88f;
        } else {
            phi_385_ = _e64;
        }
        let _e67 = phi_385_;
        let _e69 = ((_e67 * 1.442695f) + 0.5f);
        if (_e69 > -8388608f) {
            let _e81 = f32(select(0i, select(select(i32(_e69), i32(-2147483648), (_e69 < bitcast<f32>(3472883712u))), 2147483647i, (_e69 > bitcast<f32>(1325400063u))), (_e69 == _e69)));
            if (_e81 > _e69) {
                phi_407_ = 1f;
            } else {
                phi_407_ = 0f;
            }
            let _e84 = phi_407_;
            if (_e69 < 8388608f) {
                phi_412_ = (_e81 - _e84);
                phi_413_ = false;
            } else {
                phi_412_ = f32();
                phi_413_ = true;
            }
            let _e87 = phi_412_;
            let _e89 = phi_413_;
            phi_414_ = _e87;
            phi_415_ = _e89;
        } else {
            phi_414_ = f32();
            phi_415_ = true;
        }
        let _e91 = phi_414_;
        let _e93 = phi_415_;
        if _e93 {
            phi_419_ = _e69;
        } else {
            phi_419_ = _e91;
        }
        let _e95 = phi_419_;
        let _e99 = ((_e67 - (_e95 * 0.69314575f)) - (_e95 * 0.0000014286068f));
        phi_457_ = ((((((((((((((((1f / 5040f) * _e99) + (1f / 720f)) * _e99) + (1f / 120f)) * _e99) + (1f / 24f)) * _e99) + (1f / 6f)) * _e99) + 0.5f) * _e99) + 1f) * _e99) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e95), i32(-2147483648), (_e95 < bitcast<f32>(3472883712u))), 2147483647i, (_e95 > bitcast<f32>(1325400063u))), (_e95 == _e95)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e135 = phi_457_;
    if ((bitcast<u32>(_e54) & 2147483647u) > 2139095040u) {
        phi_545_ = _e54;
    } else {
        if (_e54 < -87f) {
            phi_468_ = -87f;
        } else {
            phi_468_ = _e54;
        }
        let _e141 = phi_468_;
        if (_e141 > 88f) {
            phi_473_ = 88f;
        } else {
            phi_473_ = _e141;
        }
        let _e144 = phi_473_;
        let _e146 = ((_e144 * 1.442695f) + 0.5f);
        if (_e146 > -8388608f) {
            let _e158 = f32(select(0i, select(select(i32(_e146), i32(-2147483648), (_e146 < bitcast<f32>(3472883712u))), 2147483647i, (_e146 > bitcast<f32>(1325400063u))), (_e146 == _e146)));
            if (_e158 > _e146) {
                phi_495_ = 1f;
            } else {
                phi_495_ = 0f;
            }
            let _e161 = phi_495_;
            if (_e146 < 8388608f) {
                phi_500_ = (_e158 - _e161);
                phi_501_ = false;
            } else {
                phi_500_ = f32();
                phi_501_ = true;
            }
            let _e164 = phi_500_;
            let _e166 = phi_501_;
            phi_502_ = _e164;
            phi_503_ = _e166;
        } else {
            phi_502_ = f32();
            phi_503_ = true;
        }
        let _e168 = phi_502_;
        let _e170 = phi_503_;
        if _e170 {
            phi_507_ = _e146;
        } else {
            phi_507_ = _e168;
        }
        let _e172 = phi_507_;
        let _e176 = ((_e144 - (_e172 * 0.69314575f)) - (_e172 * 0.0000014286068f));
        phi_545_ = ((((((((((((((((1f / 5040f) * _e176) + (1f / 720f)) * _e176) + (1f / 120f)) * _e176) + (1f / 24f)) * _e176) + (1f / 6f)) * _e176) + 0.5f) * _e176) + 1f) * _e176) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e172), i32(-2147483648), (_e172 < bitcast<f32>(3472883712u))), 2147483647i, (_e172 > bitcast<f32>(1325400063u))), (_e172 == _e172)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e212 = phi_545_;
    if ((bitcast<u32>(_e56) & 2147483647u) > 2139095040u) {
        phi_633_ = _e56;
    } else {
        if (_e56 < -87f) {
            phi_556_ = -87f;
        } else {
            phi_556_ = _e56;
        }
        let _e218 = phi_556_;
        if (_e218 > 88f) {
            phi_561_ = 88f;
        } else {
            phi_561_ = _e218;
        }
        let _e221 = phi_561_;
        let _e223 = ((_e221 * 1.442695f) + 0.5f);
        if (_e223 > -8388608f) {
            let _e235 = f32(select(0i, select(select(i32(_e223), i32(-2147483648), (_e223 < bitcast<f32>(3472883712u))), 2147483647i, (_e223 > bitcast<f32>(1325400063u))), (_e223 == _e223)));
            if (_e235 > _e223) {
                phi_583_ = 1f;
            } else {
                phi_583_ = 0f;
            }
            let _e238 = phi_583_;
            if (_e223 < 8388608f) {
                phi_588_ = (_e235 - _e238);
                phi_589_ = false;
            } else {
                phi_588_ = f32();
                phi_589_ = true;
            }
            let _e241 = phi_588_;
            let _e243 = phi_589_;
            phi_590_ = _e241;
            phi_591_ = _e243;
        } else {
            phi_590_ = f32();
            phi_591_ = true;
        }
        let _e245 = phi_590_;
        let _e247 = phi_591_;
        if _e247 {
            phi_595_ = _e223;
        } else {
            phi_595_ = _e245;
        }
        let _e249 = phi_595_;
        let _e253 = ((_e221 - (_e249 * 0.69314575f)) - (_e249 * 0.0000014286068f));
        phi_633_ = ((((((((((((((((1f / 5040f) * _e253) + (1f / 720f)) * _e253) + (1f / 120f)) * _e253) + (1f / 24f)) * _e253) + (1f / 6f)) * _e253) + 0.5f) * _e253) + 1f) * _e253) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e249), i32(-2147483648), (_e249 < bitcast<f32>(3472883712u))), 2147483647i, (_e249 > bitcast<f32>(1325400063u))), (_e249 == _e249)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e289 = phi_633_;
    if ((bitcast<u32>(_e58) & 2147483647u) > 2139095040u) {
        phi_721_ = _e58;
    } else {
        if (_e58 < -87f) {
            phi_644_ = -87f;
        } else {
            phi_644_ = _e58;
        }
        let _e295 = phi_644_;
        if (_e295 > 88f) {
            phi_649_ = 88f;
        } else {
            phi_649_ = _e295;
        }
        let _e298 = phi_649_;
        let _e300 = ((_e298 * 1.442695f) + 0.5f);
        if (_e300 > -8388608f) {
            let _e312 = f32(select(0i, select(select(i32(_e300), i32(-2147483648), (_e300 < bitcast<f32>(3472883712u))), 2147483647i, (_e300 > bitcast<f32>(1325400063u))), (_e300 == _e300)));
            if (_e312 > _e300) {
                phi_671_ = 1f;
            } else {
                phi_671_ = 0f;
            }
            let _e315 = phi_671_;
            if (_e300 < 8388608f) {
                phi_676_ = (_e312 - _e315);
                phi_677_ = false;
            } else {
                phi_676_ = f32();
                phi_677_ = true;
            }
            let _e318 = phi_676_;
            let _e320 = phi_677_;
            phi_678_ = _e318;
            phi_679_ = _e320;
        } else {
            phi_678_ = f32();
            phi_679_ = true;
        }
        let _e322 = phi_678_;
        let _e324 = phi_679_;
        if _e324 {
            phi_683_ = _e300;
        } else {
            phi_683_ = _e322;
        }
        let _e326 = phi_683_;
        let _e330 = ((_e298 - (_e326 * 0.69314575f)) - (_e326 * 0.0000014286068f));
        phi_721_ = ((((((((((((((((1f / 5040f) * _e330) + (1f / 720f)) * _e330) + (1f / 120f)) * _e330) + (1f / 24f)) * _e330) + (1f / 6f)) * _e330) + 0.5f) * _e330) + 1f) * _e330) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e326), i32(-2147483648), (_e326 < bitcast<f32>(3472883712u))), 2147483647i, (_e326 > bitcast<f32>(1325400063u))), (_e326 == _e326)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e366 = phi_721_;
    let _e368 = (_e135 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e370 = (_e212 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e372 = (_e289 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e374 = (_e366 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e376 = (*param_6).min_variance;
    let _e378 = ((_e376 * _e50) * _e50);
    let _e389 = ((((_e368 * param_8.x) + (_e370 * param_8.y)) + (_e372 * param_8.z)) + (_e374 * param_8.w));
    let _e390 = (_e368 - _e389);
    let _e391 = (_e370 - _e389);
    let _e392 = (_e372 - _e389);
    let _e393 = (_e374 - _e389);
    let _e408 = (((((_e390 * _e390) * param_8.x) + ((_e391 * _e391) * param_8.y)) + ((_e392 * _e392) * param_8.z)) + ((_e393 * _e393) * param_8.w));
    if ((bitcast<u32>(_e378) & 2147483647u) > 2139095040u) {
        phi_774_ = true;
    } else {
        let _e412 = (_e378 > _e408);
        if _e412 {
        }
        phi_774_ = _e412;
    }
    let _e414 = phi_774_;
    if _e414 {
        phi_778_ = _e378;
    } else {
        phi_778_ = _e408;
    }
    let _e416 = phi_778_;
    let _e417 = -(_e389);
    if (_e417 <= 0f) {
        let _e421 = ((bitcast<u32>(_e416) & 2147483647u) > 2139095040u);
        if _e421 {
        }
        phi_790_ = _e421;
    } else {
        phi_790_ = true;
    }
    let _e423 = phi_790_;
    if _e423 {
        phi_797_ = (_e416 / (_e416 + (_e417 * _e417)));
    } else {
        phi_797_ = 1f;
    }
    let _e428 = phi_797_;
    let _e429 = _lt_math_evsm_Evsm_negative(param_6);
    let _e430 = -(_e429);
    let _e432 = (_e430 * param_7.x);
    let _e434 = (_e430 * param_7.y);
    let _e436 = (_e430 * param_7.z);
    let _e438 = (_e430 * param_7.w);
    if ((bitcast<u32>(_e432) & 2147483647u) > 2139095040u) {
        phi_895_ = _e432;
    } else {
        if (_e432 < -87f) {
            phi_818_ = -87f;
        } else {
            phi_818_ = _e432;
        }
        let _e444 = phi_818_;
        if (_e444 > 88f) {
            phi_823_ = 88f;
        } else {
            phi_823_ = _e444;
        }
        let _e447 = phi_823_;
        let _e449 = ((_e447 * 1.442695f) + 0.5f);
        if (_e449 > -8388608f) {
            let _e461 = f32(select(0i, select(select(i32(_e449), i32(-2147483648), (_e449 < bitcast<f32>(3472883712u))), 2147483647i, (_e449 > bitcast<f32>(1325400063u))), (_e449 == _e449)));
            if (_e461 > _e449) {
                phi_845_ = 1f;
            } else {
                phi_845_ = 0f;
            }
            let _e464 = phi_845_;
            if (_e449 < 8388608f) {
                phi_850_ = (_e461 - _e464);
                phi_851_ = false;
            } else {
                phi_850_ = f32();
                phi_851_ = true;
            }
            let _e467 = phi_850_;
            let _e469 = phi_851_;
            phi_852_ = _e467;
            phi_853_ = _e469;
        } else {
            phi_852_ = f32();
            phi_853_ = true;
        }
        let _e471 = phi_852_;
        let _e473 = phi_853_;
        if _e473 {
            phi_857_ = _e449;
        } else {
            phi_857_ = _e471;
        }
        let _e475 = phi_857_;
        let _e479 = ((_e447 - (_e475 * 0.69314575f)) - (_e475 * 0.0000014286068f));
        phi_895_ = ((((((((((((((((1f / 5040f) * _e479) + (1f / 720f)) * _e479) + (1f / 120f)) * _e479) + (1f / 24f)) * _e479) + (1f / 6f)) * _e479) + 0.5f) * _e479) + 1f) * _e479) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e475), i32(-2147483648), (_e475 < bitcast<f32>(3472883712u))), 2147483647i, (_e475 > bitcast<f32>(1325400063u))), (_e475 == _e475)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e515 = phi_895_;
    if ((bitcast<u32>(_e434) & 2147483647u) > 2139095040u) {
        phi_983_ = _e434;
    } else {
        if (_e434 < -87f) {
            phi_906_ = -87f;
        } else {
            phi_906_ = _e434;
        }
        let _e521 = phi_906_;
        if (_e521 > 88f) {
            phi_911_ = 88f;
        } else {
            phi_911_ = _e521;
        }
        let _e524 = phi_911_;
        let _e526 = ((_e524 * 1.442695f) + 0.5f);
        if (_e526 > -8388608f) {
            let _e538 = f32(select(0i, select(select(i32(_e526), i32(-2147483648), (_e526 < bitcast<f32>(3472883712u))), 2147483647i, (_e526 > bitcast<f32>(1325400063u))), (_e526 == _e526)));
            if (_e538 > _e526) {
                phi_933_ = 1f;
            } else {
                phi_933_ = 0f;
            }
            let _e541 = phi_933_;
            if (_e526 < 8388608f) {
                phi_938_ = (_e538 - _e541);
                phi_939_ = false;
            } else {
                phi_938_ = f32();
                phi_939_ = true;
            }
            let _e544 = phi_938_;
            let _e546 = phi_939_;
            phi_940_ = _e544;
            phi_941_ = _e546;
        } else {
            phi_940_ = f32();
            phi_941_ = true;
        }
        let _e548 = phi_940_;
        let _e550 = phi_941_;
        if _e550 {
            phi_945_ = _e526;
        } else {
            phi_945_ = _e548;
        }
        let _e552 = phi_945_;
        let _e556 = ((_e524 - (_e552 * 0.69314575f)) - (_e552 * 0.0000014286068f));
        phi_983_ = ((((((((((((((((1f / 5040f) * _e556) + (1f / 720f)) * _e556) + (1f / 120f)) * _e556) + (1f / 24f)) * _e556) + (1f / 6f)) * _e556) + 0.5f) * _e556) + 1f) * _e556) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e552), i32(-2147483648), (_e552 < bitcast<f32>(3472883712u))), 2147483647i, (_e552 > bitcast<f32>(1325400063u))), (_e552 == _e552)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e592 = phi_983_;
    if ((bitcast<u32>(_e436) & 2147483647u) > 2139095040u) {
        phi_1071_ = _e436;
    } else {
        if (_e436 < -87f) {
            phi_994_ = -87f;
        } else {
            phi_994_ = _e436;
        }
        let _e598 = phi_994_;
        if (_e598 > 88f) {
            phi_999_ = 88f;
        } else {
            phi_999_ = _e598;
        }
        let _e601 = phi_999_;
        let _e603 = ((_e601 * 1.442695f) + 0.5f);
        if (_e603 > -8388608f) {
            let _e615 = f32(select(0i, select(select(i32(_e603), i32(-2147483648), (_e603 < bitcast<f32>(3472883712u))), 2147483647i, (_e603 > bitcast<f32>(1325400063u))), (_e603 == _e603)));
            if (_e615 > _e603) {
                phi_1021_ = 1f;
            } else {
                phi_1021_ = 0f;
            }
            let _e618 = phi_1021_;
            if (_e603 < 8388608f) {
                phi_1026_ = (_e615 - _e618);
                phi_1027_ = false;
            } else {
                phi_1026_ = f32();
                phi_1027_ = true;
            }
            let _e621 = phi_1026_;
            let _e623 = phi_1027_;
            phi_1028_ = _e621;
            phi_1029_ = _e623;
        } else {
            phi_1028_ = f32();
            phi_1029_ = true;
        }
        let _e625 = phi_1028_;
        let _e627 = phi_1029_;
        if _e627 {
            phi_1033_ = _e603;
        } else {
            phi_1033_ = _e625;
        }
        let _e629 = phi_1033_;
        let _e633 = ((_e601 - (_e629 * 0.69314575f)) - (_e629 * 0.0000014286068f));
        phi_1071_ = ((((((((((((((((1f / 5040f) * _e633) + (1f / 720f)) * _e633) + (1f / 120f)) * _e633) + (1f / 24f)) * _e633) + (1f / 6f)) * _e633) + 0.5f) * _e633) + 1f) * _e633) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e629), i32(-2147483648), (_e629 < bitcast<f32>(3472883712u))), 2147483647i, (_e629 > bitcast<f32>(1325400063u))), (_e629 == _e629)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e669 = phi_1071_;
    if ((bitcast<u32>(_e438) & 2147483647u) > 2139095040u) {
        phi_1159_ = _e438;
    } else {
        if (_e438 < -87f) {
            phi_1082_ = -87f;
        } else {
            phi_1082_ = _e438;
        }
        let _e675 = phi_1082_;
        if (_e675 > 88f) {
            phi_1087_ = 88f;
        } else {
            phi_1087_ = _e675;
        }
        let _e678 = phi_1087_;
        let _e680 = ((_e678 * 1.442695f) + 0.5f);
        if (_e680 > -8388608f) {
            let _e692 = f32(select(0i, select(select(i32(_e680), i32(-2147483648), (_e680 < bitcast<f32>(3472883712u))), 2147483647i, (_e680 > bitcast<f32>(1325400063u))), (_e680 == _e680)));
            if (_e692 > _e680) {
                phi_1109_ = 1f;
            } else {
                phi_1109_ = 0f;
            }
            let _e695 = phi_1109_;
            if (_e680 < 8388608f) {
                phi_1114_ = (_e692 - _e695);
                phi_1115_ = false;
            } else {
                phi_1114_ = f32();
                phi_1115_ = true;
            }
            let _e698 = phi_1114_;
            let _e700 = phi_1115_;
            phi_1116_ = _e698;
            phi_1117_ = _e700;
        } else {
            phi_1116_ = f32();
            phi_1117_ = true;
        }
        let _e702 = phi_1116_;
        let _e704 = phi_1117_;
        if _e704 {
            phi_1121_ = _e680;
        } else {
            phi_1121_ = _e702;
        }
        let _e706 = phi_1121_;
        let _e710 = ((_e678 - (_e706 * 0.69314575f)) - (_e706 * 0.0000014286068f));
        phi_1159_ = ((((((((((((((((1f / 5040f) * _e710) + (1f / 720f)) * _e710) + (1f / 120f)) * _e710) + (1f / 24f)) * _e710) + (1f / 6f)) * _e710) + 0.5f) * _e710) + 1f) * _e710) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e706), i32(-2147483648), (_e706 < bitcast<f32>(3472883712u))), 2147483647i, (_e706 > bitcast<f32>(1325400063u))), (_e706 == _e706)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e746 = phi_1159_;
    let _e748 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e515);
    let _e750 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e592);
    let _e752 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e669);
    let _e754 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e746);
    let _e756 = (*param_6).min_variance;
    let _e758 = ((_e756 * _e429) * _e429);
    let _e769 = ((((_e748 * param_8.x) + (_e750 * param_8.y)) + (_e752 * param_8.z)) + (_e754 * param_8.w));
    let _e770 = (_e748 - _e769);
    let _e771 = (_e750 - _e769);
    let _e772 = (_e752 - _e769);
    let _e773 = (_e754 - _e769);
    let _e788 = (((((_e770 * _e770) * param_8.x) + ((_e771 * _e771) * param_8.y)) + ((_e772 * _e772) * param_8.z)) + ((_e773 * _e773) * param_8.w));
    if ((bitcast<u32>(_e758) & 2147483647u) > 2139095040u) {
        phi_1212_ = true;
    } else {
        let _e792 = (_e758 > _e788);
        if _e792 {
        }
        phi_1212_ = _e792;
    }
    let _e794 = phi_1212_;
    if _e794 {
        phi_1216_ = _e758;
    } else {
        phi_1216_ = _e788;
    }
    let _e796 = phi_1216_;
    let _e797 = -(_e769);
    if (_e797 <= 0f) {
        let _e801 = ((bitcast<u32>(_e796) & 2147483647u) > 2139095040u);
        if _e801 {
        }
        phi_1228_ = _e801;
    } else {
        phi_1228_ = true;
    }
    let _e803 = phi_1228_;
    if _e803 {
        phi_1235_ = (_e796 / (_e796 + (_e797 * _e797)));
    } else {
        phi_1235_ = 1f;
    }
    let _e808 = phi_1235_;
    if ((bitcast<u32>(_e808) & 2147483647u) > 2139095040u) {
        phi_1246_ = true;
    } else {
        let _e812 = (_e808 < _e428);
        if _e812 {
        }
        phi_1246_ = _e812;
    }
    let _e814 = phi_1246_;
    if _e814 {
        phi_1250_ = _e808;
    } else {
        phi_1250_ = _e428;
    }
    let _e816 = phi_1250_;
    if ((bitcast<u32>(_e816) & 2147483647u) > 2139095040u) {
        phi_1267_ = _e816;
    } else {
        if (_e816 < 0f) {
            phi_1266_ = 0f;
        } else {
            if (_e816 > 1f) {
                phi_1265_ = 1f;
            } else {
                phi_1265_ = _e816;
            }
            let _e823 = phi_1265_;
            phi_1266_ = _e823;
        }
        let _e825 = phi_1266_;
        phi_1267_ = _e825;
    }
    let _e827 = phi_1267_;
    return _e827;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_9: ptr<function, lt_math_Evsm>, param_10: vec4<f32>, param_11: vec4<f32>, param_12: f32) -> f32 {
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

    if ((bitcast<u32>(param_12) & 2147483647u) > 2139095040u) {
        phi_224_ = param_12;
    } else {
        if (param_12 < 0f) {
            phi_223_ = 0f;
        } else {
            if (param_12 > 1f) {
                phi_222_ = 1f;
            } else {
                phi_222_ = param_12;
            }
            let _e57 = phi_222_;
            phi_223_ = _e57;
        }
        let _e59 = phi_223_;
        phi_224_ = _e59;
    }
    let _e61 = phi_224_;
    if ((bitcast<u32>(param_10.x) & 2147483647u) > 2139095040u) {
        phi_242_ = param_10.x;
    } else {
        if (param_10.x < 0f) {
            phi_241_ = 0f;
        } else {
            if (param_10.x > 1f) {
                phi_240_ = 1f;
            } else {
                phi_240_ = param_10.x;
            }
            let _e69 = phi_240_;
            phi_241_ = _e69;
        }
        let _e71 = phi_241_;
        phi_242_ = _e71;
    }
    let _e73 = phi_242_;
    if ((bitcast<u32>(param_10.y) & 2147483647u) > 2139095040u) {
        phi_260_ = param_10.y;
    } else {
        if (param_10.y < 0f) {
            phi_259_ = 0f;
        } else {
            if (param_10.y > 1f) {
                phi_258_ = 1f;
            } else {
                phi_258_ = param_10.y;
            }
            let _e81 = phi_258_;
            phi_259_ = _e81;
        }
        let _e83 = phi_259_;
        phi_260_ = _e83;
    }
    let _e85 = phi_260_;
    if ((bitcast<u32>(param_10.z) & 2147483647u) > 2139095040u) {
        phi_278_ = param_10.z;
    } else {
        if (param_10.z < 0f) {
            phi_277_ = 0f;
        } else {
            if (param_10.z > 1f) {
                phi_276_ = 1f;
            } else {
                phi_276_ = param_10.z;
            }
            let _e93 = phi_276_;
            phi_277_ = _e93;
        }
        let _e95 = phi_277_;
        phi_278_ = _e95;
    }
    let _e97 = phi_278_;
    if ((bitcast<u32>(param_10.w) & 2147483647u) > 2139095040u) {
        phi_296_ = param_10.w;
    } else {
        if (param_10.w < 0f) {
            phi_295_ = 0f;
        } else {
            if (param_10.w > 1f) {
                phi_294_ = 1f;
            } else {
                phi_294_ = param_10.w;
            }
            let _e105 = phi_294_;
            phi_295_ = _e105;
        }
        let _e107 = phi_295_;
        phi_296_ = _e107;
    }
    let _e109 = phi_296_;
    let _e110 = (_e73 - _e61);
    let _e111 = (_e85 - _e61);
    let _e112 = (_e97 - _e61);
    let _e113 = (_e109 - _e61);
    if (_e110 >= 0f) {
        if (_e111 >= 0f) {
            if (_e112 >= 0f) {
                if (_e113 >= 0f) {
                    phi_333_ = !(((bitcast<u32>(((((_e110 * param_11.x) + (_e111 * param_11.y)) + (_e112 * param_11.z)) + (_e113 * param_11.w))) & 2147483647u) > 2139095040u));
                    phi_334_ = false;
                } else {
                    phi_333_ = bool();
                    phi_334_ = true;
                }
                let _e135 = phi_333_;
                let _e137 = phi_334_;
                phi_335_ = _e135;
                phi_336_ = false;
                phi_337_ = _e137;
            } else {
                phi_335_ = bool();
                phi_336_ = true;
                phi_337_ = false;
            }
            let _e139 = phi_335_;
            let _e141 = phi_336_;
            let _e143 = phi_337_;
            phi_338_ = _e139;
            phi_339_ = _e141;
            phi_340_ = _e143;
        } else {
            phi_338_ = bool();
            phi_339_ = true;
            phi_340_ = false;
        }
        let _e145 = phi_338_;
        let _e147 = phi_339_;
        let _e149 = phi_340_;
        phi_341_ = _e145;
        phi_342_ = _e147;
        phi_343_ = _e149;
    } else {
        phi_341_ = bool();
        phi_342_ = true;
        phi_343_ = false;
    }
    let _e151 = phi_341_;
    let _e153 = phi_342_;
    let _e155 = phi_343_;
    if _e153 {
        phi_347_ = true;
    } else {
        phi_347_ = _e155;
    }
    let _e157 = phi_347_;
    if _e157 {
        phi_351_ = false;
    } else {
        phi_351_ = _e151;
    }
    let _e159 = phi_351_;
    if _e159 {
        phi_356_ = 1f;
    } else {
        let _e160 = _lt_math_evsm_Evsm_bound_of_offsets(param_9, vec4<f32>(_e110, _e111, _e112, _e113), param_11);
        phi_356_ = _e160;
    }
    let _e162 = phi_356_;
    return _e162;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_1321_: bool;
    var phi_1322_: bool;
    var phi_1323_: bool;
    var phi_1324_: bool;
    var phi_1328_: bool;
    var phi_1372_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1376_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1453_: bool;
    var phi_1462_: bool;
    var phi_1471_: bool;
    var phi_1472_: bool;
    var phi_1473_: bool;
    var phi_1474_: bool;
    var phi_1475_: bool;
    var phi_1476_: bool;
    var phi_1477_: bool;
    var phi_1481_: bool;
    var phi_1575_: f32;
    var phi_1578_: f32;
    var phi_1607_: f32;
    var phi_1612_: f32;
    var phi_1613_: bool;
    var phi_1614_: f32;
    var phi_1615_: bool;
    var phi_1619_: f32;
    var phi_1639_: f32;
    var phi_1644_: f32;
    var phi_1645_: bool;
    var phi_1646_: f32;
    var phi_1647_: bool;
    var phi_1651_: f32;
    var phi_1701_: i32;
    var phi_1706_: i32;
    var phi_1711_: i32;
    var phi_1716_: i32;
    var phi_1725_: i32;
    var phi_1730_: i32;
    var phi_1735_: i32;
    var phi_1740_: i32;
    var phi_1787_: bool;
    var phi_1795_: bool;
    var phi_1807_: bool;
    var phi_1808_: bool;
    var phi_1812_: f32;
    var phi_1818_: f32;
    var phi_1820_: evaluate_Verdict;
    var phi_1825_: evaluate_Verdict;
    var phi_1826_: evaluate_Verdict;

    let _e48 = id_1;
    let _e55 = arrayLength((&map.member));
    let _e61 = p.member.size[0u];
    let _e63 = p.member.size[1u];
    let _e64 = lt_shaders_entry_pixel_index(_e48, _e61, _e63);
    if (bitcast<i32>(_e64.root) != 0i) {
        if (_e64.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e73 = p.member.light;
        let _e76 = samples.member[(0u + _e64.first_primitive)].normal[0u];
        let _e78 = global[0u];
        if (_e76 == _e78) {
            let _e81 = samples.member[(0u + _e64.first_primitive)].normal[1u];
            let _e83 = global[1u];
            if (_e81 == _e83) {
                let _e86 = samples.member[(0u + _e64.first_primitive)].normal[2u];
                let _e88 = global[2u];
                phi_1321_ = (_e86 == _e88);
                phi_1322_ = false;
            } else {
                phi_1321_ = bool();
                phi_1322_ = true;
            }
            let _e91 = phi_1321_;
            let _e93 = phi_1322_;
            phi_1323_ = _e91;
            phi_1324_ = _e93;
        } else {
            phi_1323_ = bool();
            phi_1324_ = true;
        }
        let _e95 = phi_1323_;
        let _e97 = phi_1324_;
        if _e97 {
            phi_1328_ = false;
        } else {
            phi_1328_ = _e95;
        }
        let _e99 = phi_1328_;
        if !(_e99) {
            let _e102 = samples.member[(0u + _e64.first_primitive)].normal;
            let _e104 = samples.member[(0u + _e64.first_primitive)].position;
            if ((((_e102.x * (_e73.x - (_e104.x * _e73.w))) + (_e102.y * (_e73.y - (_e104.y * _e73.w)))) + (_e102.z * (_e73.z - (_e104.z * _e73.w)))) > 0f) {
                let _e128 = samples.member[(0u + _e64.first_primitive)].flags;
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e136.unnamed.visibility, false), _e136.unnamed_1);
                phi_1372_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e142.unnamed, ((_e128 & 1u) == 0u));
            } else {
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e151.unnamed.visibility, false), _e151.unnamed_1);
                phi_1372_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e157.unnamed, true);
            }
            let _e162 = phi_1372_;
            phi_1376_ = _e162;
        } else {
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
            phi_1376_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
        }
        let _e179 = phi_1376_;
        if _e179.unnamed_1 {
            phi_1826_ = evaluate_Verdict(_e179.unnamed.visibility, _e179.unnamed.is_doubted);
        } else {
            let _e187 = samples.member[(0u + _e64.first_primitive)].position;
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
                    phi_1453_ = (_e218 <= 1f);
                } else {
                    phi_1453_ = false;
                }
                let _e250 = phi_1453_;
                if _e250 {
                    if (_e232 >= 0f) {
                        phi_1462_ = (_e232 <= 1f);
                    } else {
                        phi_1462_ = false;
                    }
                    let _e254 = phi_1462_;
                    if _e254 {
                        if (_e245 >= 0f) {
                            phi_1471_ = (_e245 <= 1f);
                        } else {
                            phi_1471_ = false;
                        }
                        let _e258 = phi_1471_;
                        phi_1472_ = _e258;
                        phi_1473_ = false;
                    } else {
                        phi_1472_ = bool();
                        phi_1473_ = true;
                    }
                    let _e260 = phi_1472_;
                    let _e262 = phi_1473_;
                    phi_1474_ = _e260;
                    phi_1475_ = _e262;
                } else {
                    phi_1474_ = bool();
                    phi_1475_ = true;
                }
                let _e264 = phi_1474_;
                let _e266 = phi_1475_;
                phi_1476_ = _e264;
                phi_1477_ = _e266;
            } else {
                phi_1476_ = bool();
                phi_1477_ = true;
            }
            let _e268 = phi_1476_;
            let _e270 = phi_1477_;
            if _e270 {
                phi_1481_ = false;
            } else {
                phi_1481_ = _e268;
            }
            let _e272 = phi_1481_;
            if _e272 {
                if (0f > 0f) {
                    let _e275 = samples.member[(0u + _e64.first_primitive)].normal;
                    let _e277 = p.member.map_size;
                    let _e280 = p.member.projection.row_x;
                    let _e302 = p.member.projection.row_y;
                    let _e324 = p.member.projection.row_z;
                    let _e351 = ((abs(((((_e280.x * _e275.x) + (_e280.y * _e275.y)) + (_e280.z * _e275.z)) / (((_e280.x * _e280.x) + (_e280.y * _e280.y)) + (_e280.z * _e280.z)))) + abs(((((_e302.x * _e275.x) + (_e302.y * _e275.y)) + (_e302.z * _e275.z)) / (((_e302.x * _e302.x) + (_e302.y * _e302.y)) + (_e302.z * _e302.z))))) / (abs(((((_e324.x * _e275.x) + (_e324.y * _e275.y)) + (_e324.z * _e275.z)) / (((_e324.x * _e324.x) + (_e324.y * _e324.y)) + (_e324.z * _e324.z)))) * f32(_e277)));
                    if (_e351 < 0.002f) {
                        phi_1575_ = _e351;
                    } else {
                        phi_1575_ = 0.002f;
                    }
                    let _e354 = phi_1575_;
                    phi_1578_ = (_e245 - (0f * _e354));
                } else {
                    phi_1578_ = _e245;
                }
                let _e358 = phi_1578_;
                let _e360 = p.member.map_size;
                let _e361 = f32(_e360);
                let _e364 = ((_e218 * _e361) - 0.5f);
                let _e365 = ((_e232 * _e361) - 0.5f);
                if (_e364 > -8388608f) {
                    let _e377 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e377 > _e364) {
                        phi_1607_ = 1f;
                    } else {
                        phi_1607_ = 0f;
                    }
                    let _e380 = phi_1607_;
                    if (_e364 < 8388608f) {
                        phi_1612_ = (_e377 - _e380);
                        phi_1613_ = false;
                    } else {
                        phi_1612_ = f32();
                        phi_1613_ = true;
                    }
                    let _e383 = phi_1612_;
                    let _e385 = phi_1613_;
                    phi_1614_ = _e383;
                    phi_1615_ = _e385;
                } else {
                    phi_1614_ = f32();
                    phi_1615_ = true;
                }
                let _e387 = phi_1614_;
                let _e389 = phi_1615_;
                if _e389 {
                    phi_1619_ = _e364;
                } else {
                    phi_1619_ = _e387;
                }
                let _e391 = phi_1619_;
                if (_e365 > -8388608f) {
                    let _e403 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e403 > _e365) {
                        phi_1639_ = 1f;
                    } else {
                        phi_1639_ = 0f;
                    }
                    let _e406 = phi_1639_;
                    if (_e365 < 8388608f) {
                        phi_1644_ = (_e403 - _e406);
                        phi_1645_ = false;
                    } else {
                        phi_1644_ = f32();
                        phi_1645_ = true;
                    }
                    let _e409 = phi_1644_;
                    let _e411 = phi_1645_;
                    phi_1646_ = _e409;
                    phi_1647_ = _e411;
                } else {
                    phi_1646_ = f32();
                    phi_1647_ = true;
                }
                let _e413 = phi_1646_;
                let _e415 = phi_1647_;
                if _e415 {
                    phi_1651_ = _e365;
                } else {
                    phi_1651_ = _e413;
                }
                let _e417 = phi_1651_;
                let _e418 = (_e364 - _e391);
                let _e419 = (_e365 - _e417);
                let _e428 = select(0i, select(select(i32(_e391), i32(-2147483648), (_e391 < bitcast<f32>(3472883712u))), 2147483647i, (_e391 > bitcast<f32>(1325400063u))), (_e391 == _e391));
                let _e437 = select(0i, select(select(i32(_e417), i32(-2147483648), (_e417 < bitcast<f32>(3472883712u))), 2147483647i, (_e417 > bitcast<f32>(1325400063u))), (_e417 == _e417));
                let _e448 = p.member.test;
                let _e449 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e448);
                let _e451 = p.member.map_size;
                local = lt_math_Evsm(_e449.positive_exponent, _e449.negative_exponent, _e449.min_variance);
                let _e457 = (bitcast<i32>(_e451) - 1i);
                if (_e428 > 0i) {
                    phi_1701_ = _e428;
                } else {
                    phi_1701_ = 0i;
                }
                let _e460 = phi_1701_;
                if (_e437 > 0i) {
                    phi_1706_ = _e437;
                } else {
                    phi_1706_ = 0i;
                }
                let _e463 = phi_1706_;
                if (_e460 < _e457) {
                    phi_1711_ = _e460;
                } else {
                    phi_1711_ = _e457;
                }
                let _e466 = phi_1711_;
                if (_e463 < _e457) {
                    phi_1716_ = _e463;
                } else {
                    phi_1716_ = _e457;
                }
                let _e469 = phi_1716_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (_e428 + 1i);
                let _e473 = (_e437 + 1i);
                if (_e472 > 0i) {
                    phi_1725_ = _e472;
                } else {
                    phi_1725_ = 0i;
                }
                let _e476 = phi_1725_;
                if (_e473 > 0i) {
                    phi_1730_ = _e473;
                } else {
                    phi_1730_ = 0i;
                }
                let _e479 = phi_1730_;
                if (_e476 < _e457) {
                    phi_1735_ = _e476;
                } else {
                    phi_1735_ = _e457;
                }
                let _e482 = phi_1735_;
                if (_e479 < _e457) {
                    phi_1740_ = _e479;
                } else {
                    phi_1740_ = _e457;
                }
                let _e485 = phi_1740_;
                let _e486 = bitcast<u32>(_e482);
                let _e488 = (bitcast<u32>(_e469) * _e451);
                let _e489 = (bitcast<u32>(_e485) * _e451);
                let _e490 = (_e488 + _e470);
                let _e491 = (_e488 + _e486);
                let _e492 = (_e489 + _e470);
                let _e493 = (_e489 + _e486);
                if (_e490 < _e55) {
                } else {
                    return;
                }
                let _e497 = map.member[(0u + _e490)];
                if (_e491 < _e55) {
                } else {
                    return;
                }
                let _e501 = map.member[(0u + _e491)];
                if (_e492 < _e55) {
                } else {
                    return;
                }
                let _e505 = map.member[(0u + _e492)];
                if (_e493 < _e55) {
                } else {
                    return;
                }
                let _e509 = map.member[(0u + _e493)];
                let _e511 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e497, _e501, _e505, _e509), vec4<f32>(((1f - _e418) * (1f - _e419)), (_e418 * (1f - _e419)), ((1f - _e418) * _e419), (_e418 * _e419)), _e358);
                let _e513 = p.member.epsilon;
                if (_e511 <= _e513) {
                    phi_1787_ = true;
                } else {
                    phi_1787_ = (_e511 >= (1f - _e513));
                }
                let _e518 = phi_1787_;
                if ((bitcast<u32>(_e511) & 2147483647u) > 2139095040u) {
                    phi_1795_ = true;
                } else {
                    phi_1795_ = !(_e518);
                }
                let _e524 = phi_1795_;
                if _e524 {
                    if (_e511 > 0f) {
                        if (_e511 < 1f) {
                            phi_1807_ = false;
                        } else {
                            phi_1807_ = true;
                        }
                        let _e528 = phi_1807_;
                        phi_1808_ = _e528;
                    } else {
                        phi_1808_ = true;
                    }
                    let _e530 = phi_1808_;
                    if _e530 {
                        phi_1812_ = 0.5f;
                    } else {
                        phi_1812_ = _e511;
                    }
                    let _e532 = phi_1812_;
                    phi_1820_ = evaluate_Verdict(_e532, true);
                } else {
                    if (_e511 > 0.5f) {
                        phi_1818_ = 1f;
                    } else {
                        phi_1818_ = 0f;
                    }
                    let _e536 = phi_1818_;
                    phi_1820_ = evaluate_Verdict(_e536, false);
                }
                let _e539 = phi_1820_;
                phi_1825_ = evaluate_Verdict(_e539.visibility, _e539.is_doubted);
            } else {
                phi_1825_ = evaluate_Verdict(0.5f, true);
            }
            let _e545 = phi_1825_;
            phi_1826_ = _e545;
        }
        let _e547 = phi_1826_;
        if (_e64.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e64.first_primitive)] = _e547.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
