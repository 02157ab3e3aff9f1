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

struct type_31 {
    member: array<vec4<f32>>,
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

struct type_35 {
    member: abi_ShadowParams,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_42 {
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
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_42;
@group(0) @binding(2) 
var<storage> map: type_31;

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
        let _e65 = phi_165_;
        let _e67 = phi_166_;
        phi_167_ = _e65;
        phi_168_ = _e67;
    } else {
        phi_167_ = lt_bvh_traverse_Tree();
        phi_168_ = true;
    }
    let _e69 = phi_167_;
    let _e71 = phi_168_;
    if _e71 {
        phi_173_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_173_ = _e69;
    }
    let _e76 = phi_173_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_200_: f32;
    var phi_201_: f32;
    var phi_202_: f32;
    var phi_215_: bool;
    var phi_219_: f32;
    var phi_231_: f32;
    var phi_236_: f32;
    var phi_258_: f32;
    var phi_263_: f32;
    var phi_264_: bool;
    var phi_265_: f32;
    var phi_266_: bool;
    var phi_270_: f32;
    var phi_308_: f32;
    var phi_321_: bool;
    var phi_325_: f32;
    var phi_338_: f32;
    var phi_343_: f32;
    var phi_365_: f32;
    var phi_370_: f32;
    var phi_371_: bool;
    var phi_372_: f32;
    var phi_373_: bool;
    var phi_377_: f32;
    var phi_415_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_202_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_201_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_200_ = 1f;
            } else {
                phi_200_ = param_5;
            }
            let _e60 = phi_200_;
            phi_201_ = _e60;
        }
        let _e62 = phi_201_;
        phi_202_ = _e62;
    }
    let _e64 = phi_202_;
    let _e66 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_215_ = true;
    } else {
        let _e70 = (42f < _e66);
        if _e70 {
        }
        phi_215_ = _e70;
    }
    let _e72 = phi_215_;
    if _e72 {
        phi_219_ = 42f;
    } else {
        phi_219_ = _e66;
    }
    let _e74 = phi_219_;
    let _e75 = (_e74 * _e64);
    if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
        phi_308_ = _e75;
    } else {
        if (_e75 < -87f) {
            phi_231_ = -87f;
        } else {
            phi_231_ = _e75;
        }
        let _e81 = phi_231_;
        if (_e81 > 88f) {
            phi_236_ = 88f;
        } else {
            phi_236_ = _e81;
        }
        let _e84 = phi_236_;
        let _e86 = ((_e84 * 1.442695f) + 0.5f);
        if (_e86 > -8388608f) {
            let _e98 = f32(select(0i, select(select(i32(_e86), i32(-2147483648), (_e86 < bitcast<f32>(3472883712u))), 2147483647i, (_e86 > bitcast<f32>(1325400063u))), (_e86 == _e86)));
            if (_e98 > _e86) {
                phi_258_ = 1f;
            } else {
                phi_258_ = 0f;
            }
            let _e101 = phi_258_;
            if (_e86 < 8388608f) {
                phi_263_ = (_e98 - _e101);
                phi_264_ = false;
            } else {
                phi_263_ = f32();
                phi_264_ = true;
            }
            let _e104 = phi_263_;
            let _e106 = phi_264_;
            phi_265_ = _e104;
            phi_266_ = _e106;
        } else {
            phi_265_ = f32();
            phi_266_ = true;
        }
        let _e108 = phi_265_;
        let _e110 = phi_266_;
        if _e110 {
            phi_270_ = _e86;
        } else {
            phi_270_ = _e108;
        }
        let _e112 = phi_270_;
        let _e116 = ((_e84 - (_e112 * 0.69314575f)) - (_e112 * 0.0000014286068f));
        phi_308_ = ((((((((((((((((1f / 5040f) * _e116) + (1f / 720f)) * _e116) + (1f / 120f)) * _e116) + (1f / 24f)) * _e116) + (1f / 6f)) * _e116) + 0.5f) * _e116) + 1f) * _e116) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e112), i32(-2147483648), (_e112 < bitcast<f32>(3472883712u))), 2147483647i, (_e112 > bitcast<f32>(1325400063u))), (_e112 == _e112)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e152 = phi_308_;
    let _e154 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_321_ = true;
    } else {
        let _e158 = (42f < _e154);
        if _e158 {
        }
        phi_321_ = _e158;
    }
    let _e160 = phi_321_;
    if _e160 {
        phi_325_ = 42f;
    } else {
        phi_325_ = _e154;
    }
    let _e162 = phi_325_;
    let _e164 = (-(_e162) * _e64);
    if ((bitcast<u32>(_e164) & 2147483647u) > 2139095040u) {
        phi_415_ = _e164;
    } else {
        if (_e164 < -87f) {
            phi_338_ = -87f;
        } else {
            phi_338_ = _e164;
        }
        let _e170 = phi_338_;
        if (_e170 > 88f) {
            phi_343_ = 88f;
        } else {
            phi_343_ = _e170;
        }
        let _e173 = phi_343_;
        let _e175 = ((_e173 * 1.442695f) + 0.5f);
        if (_e175 > -8388608f) {
            let _e187 = f32(select(0i, select(select(i32(_e175), i32(-2147483648), (_e175 < bitcast<f32>(3472883712u))), 2147483647i, (_e175 > bitcast<f32>(1325400063u))), (_e175 == _e175)));
            if (_e187 > _e175) {
                phi_365_ = 1f;
            } else {
                phi_365_ = 0f;
            }
            let _e190 = phi_365_;
            if (_e175 < 8388608f) {
                phi_370_ = (_e187 - _e190);
                phi_371_ = false;
            } else {
                phi_370_ = f32();
                phi_371_ = true;
            }
            let _e193 = phi_370_;
            let _e195 = phi_371_;
            phi_372_ = _e193;
            phi_373_ = _e195;
        } else {
            phi_372_ = f32();
            phi_373_ = true;
        }
        let _e197 = phi_372_;
        let _e199 = phi_373_;
        if _e199 {
            phi_377_ = _e175;
        } else {
            phi_377_ = _e197;
        }
        let _e201 = phi_377_;
        let _e205 = ((_e173 - (_e201 * 0.69314575f)) - (_e201 * 0.0000014286068f));
        phi_415_ = ((((((((((((((((1f / 5040f) * _e205) + (1f / 720f)) * _e205) + (1f / 120f)) * _e205) + (1f / 24f)) * _e205) + (1f / 6f)) * _e205) + 0.5f) * _e205) + 1f) * _e205) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e201), i32(-2147483648), (_e201 < bitcast<f32>(3472883712u))), 2147483647i, (_e201 > bitcast<f32>(1325400063u))), (_e201 == _e201)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e241 = phi_415_;
    let _e242 = -(_e241);
    return vec4<f32>(_e152, (_e152 * _e152), _e242, (_e242 * _e242));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_437_: bool;
    var phi_441_: f32;
    var phi_465_: bool;
    var phi_469_: f32;
    var phi_481_: bool;
    var phi_488_: f32;
    var phi_501_: bool;
    var phi_505_: f32;
    var phi_529_: bool;
    var phi_533_: f32;
    var phi_545_: bool;
    var phi_552_: f32;
    var phi_563_: bool;
    var phi_567_: f32;
    var phi_582_: f32;
    var phi_583_: f32;
    var phi_584_: f32;

    let _e55 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e57 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_437_ = true;
    } else {
        let _e61 = (42f < _e57);
        if _e61 {
        }
        phi_437_ = _e61;
    }
    let _e63 = phi_437_;
    if _e63 {
        phi_441_ = 42f;
    } else {
        phi_441_ = _e57;
    }
    let _e65 = phi_441_;
    let _e67 = (*param_6).min_variance;
    let _e71 = (((_e67 * _e65) * _e65) * _e55.y);
    let _e78 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
        phi_465_ = true;
    } else {
        let _e82 = (_e71 > _e78);
        if _e82 {
        }
        phi_465_ = _e82;
    }
    let _e84 = phi_465_;
    if _e84 {
        phi_469_ = _e71;
    } else {
        phi_469_ = _e78;
    }
    let _e86 = phi_469_;
    let _e87 = (_e55.x - param_7.x);
    if (_e87 <= 0f) {
        let _e91 = ((bitcast<u32>(_e86) & 2147483647u) > 2139095040u);
        if _e91 {
        }
        phi_481_ = _e91;
    } else {
        phi_481_ = true;
    }
    let _e93 = phi_481_;
    if _e93 {
        phi_488_ = (_e86 / (_e86 + (_e87 * _e87)));
    } else {
        phi_488_ = 1f;
    }
    let _e98 = phi_488_;
    let _e100 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_501_ = true;
    } else {
        let _e104 = (42f < _e100);
        if _e104 {
        }
        phi_501_ = _e104;
    }
    let _e106 = phi_501_;
    if _e106 {
        phi_505_ = 42f;
    } else {
        phi_505_ = _e100;
    }
    let _e108 = phi_505_;
    let _e110 = (*param_6).min_variance;
    let _e114 = (((_e110 * _e108) * _e108) * _e55.w);
    let _e121 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
        phi_529_ = true;
    } else {
        let _e125 = (_e114 > _e121);
        if _e125 {
        }
        phi_529_ = _e125;
    }
    let _e127 = phi_529_;
    if _e127 {
        phi_533_ = _e114;
    } else {
        phi_533_ = _e121;
    }
    let _e129 = phi_533_;
    let _e130 = (_e55.z - param_7.z);
    if (_e130 <= 0f) {
        let _e134 = ((bitcast<u32>(_e129) & 2147483647u) > 2139095040u);
        if _e134 {
        }
        phi_545_ = _e134;
    } else {
        phi_545_ = true;
    }
    let _e136 = phi_545_;
    if _e136 {
        phi_552_ = (_e129 / (_e129 + (_e130 * _e130)));
    } else {
        phi_552_ = 1f;
    }
    let _e141 = phi_552_;
    if ((bitcast<u32>(_e141) & 2147483647u) > 2139095040u) {
        phi_563_ = true;
    } else {
        let _e145 = (_e141 < _e98);
        if _e145 {
        }
        phi_563_ = _e145;
    }
    let _e147 = phi_563_;
    if _e147 {
        phi_567_ = _e141;
    } else {
        phi_567_ = _e98;
    }
    let _e149 = phi_567_;
    if ((bitcast<u32>(_e149) & 2147483647u) > 2139095040u) {
        phi_584_ = _e149;
    } else {
        if (_e149 < 0f) {
            phi_583_ = 0f;
        } else {
            if (_e149 > 1f) {
                phi_582_ = 1f;
            } else {
                phi_582_ = _e149;
            }
            let _e156 = phi_582_;
            phi_583_ = _e156;
        }
        let _e158 = phi_583_;
        phi_584_ = _e158;
    }
    let _e160 = phi_584_;
    return _e160;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_651_: bool;
    var phi_721_: bool;
    var phi_722_: bool;
    var phi_733_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_734_: bool;
    var phi_735_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_736_: bool;
    var phi_743_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_747_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_767_: lt_math_LightPoint;
    var phi_770_: u32;
    var phi_772_: lt_math_LevelPoint;
    var phi_858_: bool;
    var phi_867_: bool;
    var phi_876_: bool;
    var phi_877_: bool;
    var phi_878_: bool;
    var phi_879_: bool;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_886_: bool;
    var phi_913_: bool;
    var phi_914_: bool;
    var phi_915_: bool;
    var phi_916_: bool;
    var phi_917_: bool;
    var phi_918_: bool;
    var phi_919_: bool;
    var phi_920_: bool;
    var phi_924_: bool;
    var phi_933_: lt_math_LightPoint;
    var phi_934_: u32;
    var phi_935_: lt_math_LevelPoint;
    var phi_936_: bool;
    var phi_768_: lt_math_LightPoint;
    var phi_771_: u32;
    var phi_773_: lt_math_LevelPoint;
    var phi_937_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_977_: bool;
    var phi_978_: bool;
    var phi_979_: bool;
    var phi_980_: bool;
    var phi_984_: bool;
    var phi_1066_: f32;
    var phi_1182_: f32;
    var phi_1183_: f32;
    var phi_1186_: f32;
    var phi_1215_: f32;
    var phi_1220_: f32;
    var phi_1221_: bool;
    var phi_1222_: f32;
    var phi_1223_: bool;
    var phi_1227_: f32;
    var phi_1247_: f32;
    var phi_1252_: f32;
    var phi_1253_: bool;
    var phi_1254_: f32;
    var phi_1255_: bool;
    var phi_1259_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1312_: i32;
    var phi_1317_: i32;
    var phi_1322_: i32;
    var phi_1327_: i32;
    var phi_1336_: i32;
    var phi_1341_: i32;
    var phi_1346_: i32;
    var phi_1351_: i32;
    var phi_1446_: bool;
    var phi_1454_: bool;
    var phi_1466_: bool;
    var phi_1467_: bool;
    var phi_1471_: f32;
    var phi_1477_: f32;
    var phi_1479_: evaluate_Verdict;
    var phi_1484_: evaluate_Verdict;
    var phi_1485_: evaluate_Verdict;

    let _e53 = id_1;
    let _e60 = arrayLength((&map.member));
    let _e66 = arrayLength((&levels.member));
    let _e69 = p.member.size[0u];
    let _e71 = p.member.size[1u];
    let _e72 = lt_shaders_entry_pixel_index(_e53, _e69, _e71);
    if (bitcast<i32>(_e72.root) != 0i) {
        let _e78 = p.member.level_count;
        if (_e72.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e85 = samples.member[(0u + _e72.first_primitive)].normal[0u];
        let _e87 = global[0u];
        if (_e85 == _e87) {
            let _e90 = samples.member[(0u + _e72.first_primitive)].normal[1u];
            let _e92 = global[1u];
            if (_e90 == _e92) {
                let _e95 = samples.member[(0u + _e72.first_primitive)].normal[2u];
                let _e97 = global[2u];
                phi_644_ = (_e95 == _e97);
                phi_645_ = false;
            } else {
                phi_644_ = bool();
                phi_645_ = true;
            }
            let _e100 = phi_644_;
            let _e102 = phi_645_;
            phi_646_ = _e100;
            phi_647_ = _e102;
        } else {
            phi_646_ = bool();
            phi_647_ = true;
        }
        let _e104 = phi_646_;
        let _e106 = phi_647_;
        if _e106 {
            phi_651_ = false;
        } else {
            phi_651_ = _e104;
        }
        let _e108 = phi_651_;
        if !(_e108) {
            let _e111 = samples.member[(0u + _e72.first_primitive)].position;
            let _e113 = p.member.light.place;
            let _e119 = p.member.light.place[3u];
            let _e126 = (_e113.x - (_e111.x * _e119));
            let _e127 = (_e113.y - (_e111.y * _e119));
            let _e128 = (_e113.z - (_e111.z * _e119));
            let _e130 = samples.member[(0u + _e72.first_primitive)].normal;
            if ((((_e130.x * _e126) + (_e130.y * _e127)) + (_e130.z * _e128)) > 0f) {
                let _e144 = (((_e126 * _e126) + (_e127 * _e127)) + (_e128 * _e128));
                let _e146 = p.member.light.axis;
                let _e158 = p.member.light.place[3u];
                if (_e158 == 0f) {
                    phi_722_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_721_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_721_ = false;
                    }
                    let _e169 = phi_721_;
                    phi_722_ = _e169;
                }
                let _e171 = phi_722_;
                if _e171 {
                    let _e173 = samples.member[(0u + _e72.first_primitive)].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_733_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_734_ = false;
                } else {
                    phi_733_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_734_ = true;
                }
                let _e192 = phi_733_;
                let _e194 = phi_734_;
                phi_735_ = _e192;
                phi_736_ = _e194;
            } else {
                phi_735_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_736_ = true;
            }
            let _e196 = phi_735_;
            let _e198 = phi_736_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_743_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_743_ = _e196;
            }
            let _e215 = phi_743_;
            phi_747_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_747_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_747_;
        if _e232.unnamed_1 {
            phi_1485_ = evaluate_Verdict(_e232.unnamed.visibility, _e232.unnamed.is_doubted);
        } else {
            let _e240 = samples.member[(0u + _e72.first_primitive)].position;
            let _e242 = p.member.map_size;
            let _e244 = (0.5f / f32(_e242));
            let _e251 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e258 = lt_math_LightPoint(vec2<f32>(_e251.uv.x, 0f), _e251.depth, _e251.is_inside);
            let _e262 = lt_math_LightPoint(_e258.uv, 0f, _e258.is_inside);
            phi_767_ = lt_math_LightPoint();
            phi_770_ = 0u;
            phi_772_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e262.uv, _e262.depth, false));
            loop {
                let _e269 = phi_767_;
                let _e271 = phi_770_;
                let _e273 = phi_772_;
                local_1 = _e273;
                local_2 = _e273;
                local_3 = _e273;
                if (_e271 < _e78) {
                    if _e273.point.is_inside {
                        phi_933_ = lt_math_LightPoint();
                        phi_934_ = u32();
                        phi_935_ = lt_math_LevelPoint();
                        phi_936_ = false;
                    } else {
                        if (_e271 < _e66) {
                        } else {
                            return;
                        }
                        let _e284 = levels.member[(0u + _e271)].row_w;
                        let _e295 = ((((_e284.x * _e240.x) + (_e284.y * _e240.y)) + (_e284.z * _e240.z)) + (_e284.w * 1f));
                        let _e297 = levels.member[(0u + _e271)].row_x;
                        let _e309 = (((((_e297.x * _e240.x) + (_e297.y * _e240.y)) + (_e297.z * _e240.z)) + (_e297.w * 1f)) / _e295);
                        let _e311 = levels.member[(0u + _e271)].row_y;
                        let _e323 = (((((_e311.x * _e240.x) + (_e311.y * _e240.y)) + (_e311.z * _e240.z)) + (_e311.w * 1f)) / _e295);
                        let _e325 = levels.member[(0u + _e271)].row_z;
                        let _e336 = ((((_e325.x * _e240.x) + (_e325.y * _e240.y)) + (_e325.z * _e240.z)) + (_e325.w * 1f));
                        if (_e295 > 0f) {
                            if (_e309 >= 0f) {
                                phi_858_ = (_e309 <= 1f);
                            } else {
                                phi_858_ = false;
                            }
                            let _e341 = phi_858_;
                            if _e341 {
                                if (_e323 >= 0f) {
                                    phi_867_ = (_e323 <= 1f);
                                } else {
                                    phi_867_ = false;
                                }
                                let _e345 = phi_867_;
                                if _e345 {
                                    if (_e336 >= 0f) {
                                        phi_876_ = (_e336 <= 1f);
                                    } else {
                                        phi_876_ = false;
                                    }
                                    let _e349 = phi_876_;
                                    phi_877_ = _e349;
                                    phi_878_ = false;
                                } else {
                                    phi_877_ = bool();
                                    phi_878_ = true;
                                }
                                let _e351 = phi_877_;
                                let _e353 = phi_878_;
                                phi_879_ = _e351;
                                phi_880_ = _e353;
                            } else {
                                phi_879_ = bool();
                                phi_880_ = true;
                            }
                            let _e355 = phi_879_;
                            let _e357 = phi_880_;
                            phi_881_ = _e355;
                            phi_882_ = _e357;
                        } else {
                            phi_881_ = bool();
                            phi_882_ = true;
                        }
                        let _e359 = phi_881_;
                        let _e361 = phi_882_;
                        if _e361 {
                            phi_886_ = false;
                        } else {
                            phi_886_ = _e359;
                        }
                        let _e363 = phi_886_;
                        if _e363 {
                            if (_e309 >= _e244) {
                                if (_e309 <= (1f - _e244)) {
                                    if (_e323 >= _e244) {
                                        phi_913_ = (_e323 <= (1f - _e244));
                                        phi_914_ = false;
                                    } else {
                                        phi_913_ = bool();
                                        phi_914_ = true;
                                    }
                                    let _e371 = phi_913_;
                                    let _e373 = phi_914_;
                                    phi_915_ = _e371;
                                    phi_916_ = _e373;
                                } else {
                                    phi_915_ = bool();
                                    phi_916_ = true;
                                }
                                let _e375 = phi_915_;
                                let _e377 = phi_916_;
                                phi_917_ = _e375;
                                phi_918_ = _e377;
                            } else {
                                phi_917_ = bool();
                                phi_918_ = true;
                            }
                            let _e379 = phi_917_;
                            let _e381 = phi_918_;
                            phi_919_ = _e379;
                            phi_920_ = _e381;
                        } else {
                            phi_919_ = bool();
                            phi_920_ = true;
                        }
                        let _e383 = phi_919_;
                        let _e385 = phi_920_;
                        if _e385 {
                            phi_924_ = false;
                        } else {
                            phi_924_ = _e383;
                        }
                        let _e387 = phi_924_;
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e309, _e269.uv.y), _e269.depth, _e269.is_inside);
                        let _e401 = lt_math_LightPoint(vec2<f32>(_e394.uv.x, _e323), _e394.depth, _e394.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e336, _e401.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e405.depth, _e387);
                        phi_933_ = _e409;
                        phi_934_ = (_e271 + 1u);
                        phi_935_ = lt_math_LevelPoint(_e271, _e409);
                        phi_936_ = true;
                    }
                    let _e413 = phi_933_;
                    let _e415 = phi_934_;
                    let _e417 = phi_935_;
                    let _e419 = phi_936_;
                    phi_768_ = _e413;
                    phi_771_ = _e415;
                    phi_773_ = _e417;
                    phi_937_ = _e419;
                } else {
                    phi_768_ = lt_math_LightPoint();
                    phi_771_ = u32();
                    phi_773_ = lt_math_LevelPoint();
                    phi_937_ = false;
                }
                let _e421 = phi_768_;
                let _e423 = phi_771_;
                let _e425 = phi_773_;
                let _e427 = phi_937_;
                continue;
                continuing {
                    phi_767_ = _e421;
                    phi_770_ = _e423;
                    phi_772_ = _e425;
                    break if !(_e427);
                }
            }
            let _e430 = local_1;
            if _e430.point.is_inside {
                if (0f > 0f) {
                    let _e436 = local_2;
                    if (_e436.level < _e66) {
                    } else {
                        return;
                    }
                    let _e441 = levels.member[(0u + _e436.level)];
                    let _e447 = global[0u];
                    if (_e441.row_w.x == _e447) {
                        let _e450 = global[1u];
                        if (_e441.row_w.y == _e450) {
                            let _e453 = global[2u];
                            phi_977_ = (_e441.row_w.z == _e453);
                            phi_978_ = false;
                        } else {
                            phi_977_ = bool();
                            phi_978_ = true;
                        }
                        let _e456 = phi_977_;
                        let _e458 = phi_978_;
                        phi_979_ = _e456;
                        phi_980_ = _e458;
                    } else {
                        phi_979_ = bool();
                        phi_980_ = true;
                    }
                    let _e460 = phi_979_;
                    let _e462 = phi_980_;
                    if _e462 {
                        phi_984_ = false;
                    } else {
                        phi_984_ = _e460;
                    }
                    let _e464 = phi_984_;
                    if _e464 {
                        let _e466 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e468 = p.member.map_size;
                        let _e538 = ((abs(((((_e441.row_x.x * _e466.x) + (_e441.row_x.y * _e466.y)) + (_e441.row_x.z * _e466.z)) / (((_e441.row_x.x * _e441.row_x.x) + (_e441.row_x.y * _e441.row_x.y)) + (_e441.row_x.z * _e441.row_x.z)))) + abs(((((_e441.row_y.x * _e466.x) + (_e441.row_y.y * _e466.y)) + (_e441.row_y.z * _e466.z)) / (((_e441.row_y.x * _e441.row_y.x) + (_e441.row_y.y * _e441.row_y.y)) + (_e441.row_y.z * _e441.row_y.z))))) / (abs(((((_e441.row_z.x * _e466.x) + (_e441.row_z.y * _e466.y)) + (_e441.row_z.z * _e466.z)) / (((_e441.row_z.x * _e441.row_z.x) + (_e441.row_z.y * _e441.row_z.y)) + (_e441.row_z.z * _e441.row_z.z)))) * f32(_e468)));
                        if (_e538 < 0.002f) {
                            phi_1066_ = _e538;
                        } else {
                            phi_1066_ = 0.002f;
                        }
                        let _e541 = phi_1066_;
                        phi_1183_ = _e541;
                    } else {
                        let _e543 = p.member.map_size;
                        let _e549 = samples.member[(0u + _e72.first_primitive)].position;
                        let _e560 = ((((_e441.row_w.x * _e549.x) + (_e441.row_w.y * _e549.y)) + (_e441.row_w.z * _e549.z)) + _e441.row_w.w);
                        let _e573 = ((_e441.row_x.x - (_e441.row_w.x * _e430.point.uv.x)) / _e560);
                        let _e574 = ((_e441.row_x.y - (_e441.row_w.y * _e430.point.uv.x)) / _e560);
                        let _e575 = ((_e441.row_x.z - (_e441.row_w.z * _e430.point.uv.x)) / _e560);
                        let _e588 = ((_e441.row_y.x - (_e441.row_w.x * _e430.point.uv.y)) / _e560);
                        let _e589 = ((_e441.row_y.y - (_e441.row_w.y * _e430.point.uv.y)) / _e560);
                        let _e590 = ((_e441.row_y.z - (_e441.row_w.z * _e430.point.uv.y)) / _e560);
                        let _e596 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e601 = ((_e589 * _e596.z) - (_e596.y * _e590));
                        let _e606 = ((_e590 * _e596.x) - (_e596.z * _e588));
                        let _e611 = ((_e588 * _e596.y) - (_e596.x * _e589));
                        let _e613 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e618 = ((_e574 * _e613.z) - (_e613.y * _e575));
                        let _e623 = ((_e575 * _e613.x) - (_e613.z * _e573));
                        let _e628 = ((_e573 * _e613.y) - (_e613.x * _e574));
                        let _e655 = ((abs(((((_e441.row_z.x * _e601) + (_e441.row_z.y * _e606)) + (_e441.row_z.z * _e611)) / (((_e573 * _e601) + (_e574 * _e606)) + (_e575 * _e611)))) + abs(((((_e441.row_z.x * _e618) + (_e441.row_z.y * _e623)) + (_e441.row_z.z * _e628)) / (((_e588 * _e618) + (_e589 * _e623)) + (_e590 * _e628))))) / f32(_e543));
                        if (_e655 < 0.002f) {
                            phi_1182_ = _e655;
                        } else {
                            phi_1182_ = 0.002f;
                        }
                        let _e658 = phi_1182_;
                        phi_1183_ = _e658;
                    }
                    let _e660 = phi_1183_;
                    phi_1186_ = (_e430.point.depth - (0f * _e660));
                } else {
                    phi_1186_ = _e430.point.depth;
                }
                let _e664 = phi_1186_;
                let _e670 = p.member.map_size;
                let _e671 = f32(_e670);
                let _e674 = ((_e430.point.uv.x * _e671) - 0.5f);
                let _e675 = ((_e430.point.uv.y * _e671) - 0.5f);
                if (_e674 > -8388608f) {
                    let _e687 = f32(select(0i, select(select(i32(_e674), i32(-2147483648), (_e674 < bitcast<f32>(3472883712u))), 2147483647i, (_e674 > bitcast<f32>(1325400063u))), (_e674 == _e674)));
                    if (_e687 > _e674) {
                        phi_1215_ = 1f;
                    } else {
                        phi_1215_ = 0f;
                    }
                    let _e690 = phi_1215_;
                    if (_e674 < 8388608f) {
                        phi_1220_ = (_e687 - _e690);
                        phi_1221_ = false;
                    } else {
                        phi_1220_ = f32();
                        phi_1221_ = true;
                    }
                    let _e693 = phi_1220_;
                    let _e695 = phi_1221_;
                    phi_1222_ = _e693;
                    phi_1223_ = _e695;
                } else {
                    phi_1222_ = f32();
                    phi_1223_ = true;
                }
                let _e697 = phi_1222_;
                let _e699 = phi_1223_;
                if _e699 {
                    phi_1227_ = _e674;
                } else {
                    phi_1227_ = _e697;
                }
                let _e701 = phi_1227_;
                if (_e675 > -8388608f) {
                    let _e713 = f32(select(0i, select(select(i32(_e675), i32(-2147483648), (_e675 < bitcast<f32>(3472883712u))), 2147483647i, (_e675 > bitcast<f32>(1325400063u))), (_e675 == _e675)));
                    if (_e713 > _e675) {
                        phi_1247_ = 1f;
                    } else {
                        phi_1247_ = 0f;
                    }
                    let _e716 = phi_1247_;
                    if (_e675 < 8388608f) {
                        phi_1252_ = (_e713 - _e716);
                        phi_1253_ = false;
                    } else {
                        phi_1252_ = f32();
                        phi_1253_ = true;
                    }
                    let _e719 = phi_1252_;
                    let _e721 = phi_1253_;
                    phi_1254_ = _e719;
                    phi_1255_ = _e721;
                } else {
                    phi_1254_ = f32();
                    phi_1255_ = true;
                }
                let _e723 = phi_1254_;
                let _e725 = phi_1255_;
                if _e725 {
                    phi_1259_ = _e675;
                } else {
                    phi_1259_ = _e723;
                }
                let _e727 = phi_1259_;
                let _e728 = (_e674 - _e701);
                let _e729 = (_e675 - _e727);
                let _e738 = select(0i, select(select(i32(_e701), i32(-2147483648), (_e701 < bitcast<f32>(3472883712u))), 2147483647i, (_e701 > bitcast<f32>(1325400063u))), (_e701 == _e701));
                let _e747 = select(0i, select(select(i32(_e727), i32(-2147483648), (_e727 < bitcast<f32>(3472883712u))), 2147483647i, (_e727 > bitcast<f32>(1325400063u))), (_e727 == _e727));
                let _e750 = ((1f - _e728) * (1f - _e729));
                let _e752 = (_e728 * (1f - _e729));
                let _e754 = ((1f - _e728) * _e729);
                let _e755 = (_e728 * _e729);
                let _e757 = p.member.test;
                let _e758 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e757);
                let _e760 = p.member.map_size;
                let _e762 = local_3;
                local = lt_math_Evsm(_e758.positive_exponent, _e758.negative_exponent, _e758.min_variance);
                let _e769 = ((_e762.level * _e760) * _e760);
                let _e771 = (bitcast<i32>(_e760) - 1i);
                if (_e738 > 0i) {
                    phi_1312_ = _e738;
                } else {
                    phi_1312_ = 0i;
                }
                let _e774 = phi_1312_;
                if (_e747 > 0i) {
                    phi_1317_ = _e747;
                } else {
                    phi_1317_ = 0i;
                }
                let _e777 = phi_1317_;
                if (_e774 < _e771) {
                    phi_1322_ = _e774;
                } else {
                    phi_1322_ = _e771;
                }
                let _e780 = phi_1322_;
                if (_e777 < _e771) {
                    phi_1327_ = _e777;
                } else {
                    phi_1327_ = _e771;
                }
                let _e783 = phi_1327_;
                let _e784 = bitcast<u32>(_e780);
                let _e786 = (_e738 + 1i);
                let _e787 = (_e747 + 1i);
                if (_e786 > 0i) {
                    phi_1336_ = _e786;
                } else {
                    phi_1336_ = 0i;
                }
                let _e790 = phi_1336_;
                if (_e787 > 0i) {
                    phi_1341_ = _e787;
                } else {
                    phi_1341_ = 0i;
                }
                let _e793 = phi_1341_;
                if (_e790 < _e771) {
                    phi_1346_ = _e790;
                } else {
                    phi_1346_ = _e771;
                }
                let _e796 = phi_1346_;
                if (_e793 < _e771) {
                    phi_1351_ = _e793;
                } else {
                    phi_1351_ = _e771;
                }
                let _e799 = phi_1351_;
                let _e800 = bitcast<u32>(_e796);
                let _e802 = (bitcast<u32>(_e783) * _e760);
                let _e803 = (bitcast<u32>(_e799) * _e760);
                let _e808 = ((_e802 + _e784) + _e769);
                let _e809 = ((_e802 + _e800) + _e769);
                let _e810 = ((_e803 + _e784) + _e769);
                let _e811 = ((_e803 + _e800) + _e769);
                if (_e808 < _e60) {
                } else {
                    return;
                }
                let _e815 = map.member[(0u + _e808)];
                if (_e809 < _e60) {
                } else {
                    return;
                }
                let _e827 = map.member[(0u + _e809)];
                if (_e810 < _e60) {
                } else {
                    return;
                }
                let _e843 = map.member[(0u + _e810)];
                if (_e811 < _e60) {
                } else {
                    return;
                }
                let _e859 = map.member[(0u + _e811)];
                let _e873 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e815.x * _e750) + (_e827.x * _e752)) + (_e843.x * _e754)) + (_e859.x * _e755)), ((((_e815.y * _e750) + (_e827.y * _e752)) + (_e843.y * _e754)) + (_e859.y * _e755)), ((((_e815.z * _e750) + (_e827.z * _e752)) + (_e843.z * _e754)) + (_e859.z * _e755)), ((((_e815.w * _e750) + (_e827.w * _e752)) + (_e843.w * _e754)) + (_e859.w * _e755))), _e664);
                let _e875 = p.member.epsilon;
                if (_e873 <= _e875) {
                    phi_1446_ = true;
                } else {
                    phi_1446_ = (_e873 >= (1f - _e875));
                }
                let _e880 = phi_1446_;
                if ((bitcast<u32>(_e873) & 2147483647u) > 2139095040u) {
                    phi_1454_ = true;
                } else {
                    phi_1454_ = !(_e880);
                }
                let _e886 = phi_1454_;
                if _e886 {
                    if (_e873 > 0f) {
                        if (_e873 < 1f) {
                            phi_1466_ = false;
                        } else {
                            phi_1466_ = true;
                        }
                        let _e890 = phi_1466_;
                        phi_1467_ = _e890;
                    } else {
                        phi_1467_ = true;
                    }
                    let _e892 = phi_1467_;
                    if _e892 {
                        phi_1471_ = 0.5f;
                    } else {
                        phi_1471_ = _e873;
                    }
                    let _e894 = phi_1471_;
                    phi_1479_ = evaluate_Verdict(_e894, true);
                } else {
                    if (_e873 > 0.5f) {
                        phi_1477_ = 1f;
                    } else {
                        phi_1477_ = 0f;
                    }
                    let _e898 = phi_1477_;
                    phi_1479_ = evaluate_Verdict(_e898, false);
                }
                let _e901 = phi_1479_;
                phi_1484_ = evaluate_Verdict(_e901.visibility, _e901.is_doubted);
            } else {
                phi_1484_ = evaluate_Verdict(0.5f, true);
            }
            let _e907 = phi_1484_;
            phi_1485_ = _e907;
        }
        let _e909 = phi_1485_;
        if (_e72.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e72.first_primitive)] = _e909.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
