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
        let _e65 = phi_164_;
        let _e67 = phi_165_;
        phi_166_ = _e65;
        phi_167_ = _e67;
    } else {
        phi_166_ = lt_bvh_traverse_Tree();
        phi_167_ = true;
    }
    let _e69 = phi_166_;
    let _e71 = phi_167_;
    if _e71 {
        phi_172_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_172_ = _e69;
    }
    let _e76 = phi_172_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_199_: f32;
    var phi_200_: f32;
    var phi_201_: f32;
    var phi_214_: bool;
    var phi_218_: f32;
    var phi_230_: f32;
    var phi_235_: f32;
    var phi_257_: f32;
    var phi_262_: f32;
    var phi_263_: bool;
    var phi_264_: f32;
    var phi_265_: bool;
    var phi_269_: f32;
    var phi_307_: f32;
    var phi_320_: bool;
    var phi_324_: f32;
    var phi_337_: f32;
    var phi_342_: f32;
    var phi_364_: f32;
    var phi_369_: f32;
    var phi_370_: bool;
    var phi_371_: f32;
    var phi_372_: bool;
    var phi_376_: f32;
    var phi_414_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_201_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_200_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_199_ = 1f;
            } else {
                phi_199_ = param_5;
            }
            let _e60 = phi_199_;
            phi_200_ = _e60;
        }
        let _e62 = phi_200_;
        phi_201_ = _e62;
    }
    let _e64 = phi_201_;
    let _e66 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_214_ = true;
    } else {
        let _e70 = (42f < _e66);
        if _e70 {
        }
        phi_214_ = _e70;
    }
    let _e72 = phi_214_;
    if _e72 {
        phi_218_ = 42f;
    } else {
        phi_218_ = _e66;
    }
    let _e74 = phi_218_;
    let _e75 = (_e74 * _e64);
    if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
        phi_307_ = _e75;
    } else {
        if (_e75 < -87f) {
            phi_230_ = -87f;
        } else {
            phi_230_ = _e75;
        }
        let _e81 = phi_230_;
        if (_e81 > 88f) {
            phi_235_ = 88f;
        } else {
            phi_235_ = _e81;
        }
        let _e84 = phi_235_;
        let _e86 = ((_e84 * 1.442695f) + 0.5f);
        if (_e86 > -8388608f) {
            let _e98 = f32(select(0i, select(select(i32(_e86), i32(-2147483648), (_e86 < bitcast<f32>(3472883712u))), 2147483647i, (_e86 > bitcast<f32>(1325400063u))), (_e86 == _e86)));
            if (_e98 > _e86) {
                phi_257_ = 1f;
            } else {
                phi_257_ = 0f;
            }
            let _e101 = phi_257_;
            if (_e86 < 8388608f) {
                phi_262_ = (_e98 - _e101);
                phi_263_ = false;
            } else {
                phi_262_ = f32();
                phi_263_ = true;
            }
            let _e104 = phi_262_;
            let _e106 = phi_263_;
            phi_264_ = _e104;
            phi_265_ = _e106;
        } else {
            phi_264_ = f32();
            phi_265_ = true;
        }
        let _e108 = phi_264_;
        let _e110 = phi_265_;
        if _e110 {
            phi_269_ = _e86;
        } else {
            phi_269_ = _e108;
        }
        let _e112 = phi_269_;
        let _e116 = ((_e84 - (_e112 * 0.69314575f)) - (_e112 * 0.0000014286068f));
        phi_307_ = ((((((((((((((((1f / 5040f) * _e116) + (1f / 720f)) * _e116) + (1f / 120f)) * _e116) + (1f / 24f)) * _e116) + (1f / 6f)) * _e116) + 0.5f) * _e116) + 1f) * _e116) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e112), i32(-2147483648), (_e112 < bitcast<f32>(3472883712u))), 2147483647i, (_e112 > bitcast<f32>(1325400063u))), (_e112 == _e112)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e152 = phi_307_;
    let _e154 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_320_ = true;
    } else {
        let _e158 = (42f < _e154);
        if _e158 {
        }
        phi_320_ = _e158;
    }
    let _e160 = phi_320_;
    if _e160 {
        phi_324_ = 42f;
    } else {
        phi_324_ = _e154;
    }
    let _e162 = phi_324_;
    let _e164 = (-(_e162) * _e64);
    if ((bitcast<u32>(_e164) & 2147483647u) > 2139095040u) {
        phi_414_ = _e164;
    } else {
        if (_e164 < -87f) {
            phi_337_ = -87f;
        } else {
            phi_337_ = _e164;
        }
        let _e170 = phi_337_;
        if (_e170 > 88f) {
            phi_342_ = 88f;
        } else {
            phi_342_ = _e170;
        }
        let _e173 = phi_342_;
        let _e175 = ((_e173 * 1.442695f) + 0.5f);
        if (_e175 > -8388608f) {
            let _e187 = f32(select(0i, select(select(i32(_e175), i32(-2147483648), (_e175 < bitcast<f32>(3472883712u))), 2147483647i, (_e175 > bitcast<f32>(1325400063u))), (_e175 == _e175)));
            if (_e187 > _e175) {
                phi_364_ = 1f;
            } else {
                phi_364_ = 0f;
            }
            let _e190 = phi_364_;
            if (_e175 < 8388608f) {
                phi_369_ = (_e187 - _e190);
                phi_370_ = false;
            } else {
                phi_369_ = f32();
                phi_370_ = true;
            }
            let _e193 = phi_369_;
            let _e195 = phi_370_;
            phi_371_ = _e193;
            phi_372_ = _e195;
        } else {
            phi_371_ = f32();
            phi_372_ = true;
        }
        let _e197 = phi_371_;
        let _e199 = phi_372_;
        if _e199 {
            phi_376_ = _e175;
        } else {
            phi_376_ = _e197;
        }
        let _e201 = phi_376_;
        let _e205 = ((_e173 - (_e201 * 0.69314575f)) - (_e201 * 0.0000014286068f));
        phi_414_ = ((((((((((((((((1f / 5040f) * _e205) + (1f / 720f)) * _e205) + (1f / 120f)) * _e205) + (1f / 24f)) * _e205) + (1f / 6f)) * _e205) + 0.5f) * _e205) + 1f) * _e205) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e201), i32(-2147483648), (_e201 < bitcast<f32>(3472883712u))), 2147483647i, (_e201 > bitcast<f32>(1325400063u))), (_e201 == _e201)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e241 = phi_414_;
    let _e242 = -(_e241);
    return vec4<f32>(_e152, (_e152 * _e152), _e242, (_e242 * _e242));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_436_: bool;
    var phi_440_: f32;
    var phi_464_: bool;
    var phi_468_: f32;
    var phi_480_: bool;
    var phi_487_: f32;
    var phi_500_: bool;
    var phi_504_: f32;
    var phi_528_: bool;
    var phi_532_: f32;
    var phi_544_: bool;
    var phi_551_: f32;
    var phi_562_: bool;
    var phi_566_: f32;
    var phi_581_: f32;
    var phi_582_: f32;
    var phi_583_: f32;

    let _e55 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e57 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_436_ = true;
    } else {
        let _e61 = (42f < _e57);
        if _e61 {
        }
        phi_436_ = _e61;
    }
    let _e63 = phi_436_;
    if _e63 {
        phi_440_ = 42f;
    } else {
        phi_440_ = _e57;
    }
    let _e65 = phi_440_;
    let _e67 = (*param_6).min_variance;
    let _e71 = (((_e67 * _e65) * _e65) * _e55.y);
    let _e78 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
        phi_464_ = true;
    } else {
        let _e82 = (_e71 > _e78);
        if _e82 {
        }
        phi_464_ = _e82;
    }
    let _e84 = phi_464_;
    if _e84 {
        phi_468_ = _e71;
    } else {
        phi_468_ = _e78;
    }
    let _e86 = phi_468_;
    let _e87 = (_e55.x - param_7.x);
    if (_e87 <= 0f) {
        let _e91 = ((bitcast<u32>(_e86) & 2147483647u) > 2139095040u);
        if _e91 {
        }
        phi_480_ = _e91;
    } else {
        phi_480_ = true;
    }
    let _e93 = phi_480_;
    if _e93 {
        phi_487_ = (_e86 / (_e86 + (_e87 * _e87)));
    } else {
        phi_487_ = 1f;
    }
    let _e98 = phi_487_;
    let _e100 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_500_ = true;
    } else {
        let _e104 = (42f < _e100);
        if _e104 {
        }
        phi_500_ = _e104;
    }
    let _e106 = phi_500_;
    if _e106 {
        phi_504_ = 42f;
    } else {
        phi_504_ = _e100;
    }
    let _e108 = phi_504_;
    let _e110 = (*param_6).min_variance;
    let _e114 = (((_e110 * _e108) * _e108) * _e55.w);
    let _e121 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
        phi_528_ = true;
    } else {
        let _e125 = (_e114 > _e121);
        if _e125 {
        }
        phi_528_ = _e125;
    }
    let _e127 = phi_528_;
    if _e127 {
        phi_532_ = _e114;
    } else {
        phi_532_ = _e121;
    }
    let _e129 = phi_532_;
    let _e130 = (_e55.z - param_7.z);
    if (_e130 <= 0f) {
        let _e134 = ((bitcast<u32>(_e129) & 2147483647u) > 2139095040u);
        if _e134 {
        }
        phi_544_ = _e134;
    } else {
        phi_544_ = true;
    }
    let _e136 = phi_544_;
    if _e136 {
        phi_551_ = (_e129 / (_e129 + (_e130 * _e130)));
    } else {
        phi_551_ = 1f;
    }
    let _e141 = phi_551_;
    if ((bitcast<u32>(_e141) & 2147483647u) > 2139095040u) {
        phi_562_ = true;
    } else {
        let _e145 = (_e141 < _e98);
        if _e145 {
        }
        phi_562_ = _e145;
    }
    let _e147 = phi_562_;
    if _e147 {
        phi_566_ = _e141;
    } else {
        phi_566_ = _e98;
    }
    let _e149 = phi_566_;
    if ((bitcast<u32>(_e149) & 2147483647u) > 2139095040u) {
        phi_583_ = _e149;
    } else {
        if (_e149 < 0f) {
            phi_582_ = 0f;
        } else {
            if (_e149 > 1f) {
                phi_581_ = 1f;
            } else {
                phi_581_ = _e149;
            }
            let _e156 = phi_581_;
            phi_582_ = _e156;
        }
        let _e158 = phi_582_;
        phi_583_ = _e158;
    }
    let _e160 = phi_583_;
    return _e160;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_643_: bool;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_650_: bool;
    var phi_720_: bool;
    var phi_721_: bool;
    var phi_732_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_733_: bool;
    var phi_734_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_735_: bool;
    var phi_742_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_746_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_766_: lt_math_LightPoint;
    var phi_769_: u32;
    var phi_771_: lt_math_LevelPoint;
    var phi_857_: bool;
    var phi_866_: bool;
    var phi_875_: bool;
    var phi_876_: bool;
    var phi_877_: bool;
    var phi_878_: bool;
    var phi_879_: bool;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_885_: bool;
    var phi_912_: bool;
    var phi_913_: bool;
    var phi_914_: bool;
    var phi_915_: bool;
    var phi_916_: bool;
    var phi_917_: bool;
    var phi_918_: bool;
    var phi_919_: bool;
    var phi_923_: bool;
    var phi_932_: lt_math_LightPoint;
    var phi_933_: u32;
    var phi_934_: lt_math_LevelPoint;
    var phi_935_: bool;
    var phi_767_: lt_math_LightPoint;
    var phi_770_: u32;
    var phi_772_: lt_math_LevelPoint;
    var phi_936_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_976_: bool;
    var phi_977_: bool;
    var phi_978_: bool;
    var phi_979_: bool;
    var phi_983_: bool;
    var phi_1065_: f32;
    var phi_1181_: f32;
    var phi_1182_: f32;
    var phi_1185_: f32;
    var phi_1214_: f32;
    var phi_1219_: f32;
    var phi_1220_: bool;
    var phi_1221_: f32;
    var phi_1222_: bool;
    var phi_1226_: f32;
    var phi_1246_: f32;
    var phi_1251_: f32;
    var phi_1252_: bool;
    var phi_1253_: f32;
    var phi_1254_: bool;
    var phi_1258_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1311_: i32;
    var phi_1316_: i32;
    var phi_1321_: i32;
    var phi_1326_: i32;
    var phi_1335_: i32;
    var phi_1340_: i32;
    var phi_1345_: i32;
    var phi_1350_: i32;
    var phi_1439_: evaluate_Verdict;
    var phi_1440_: evaluate_Verdict;
    var phi_1441_: bool;
    var phi_1442_: evaluate_Verdict;
    var phi_1443_: evaluate_Verdict;
    var phi_1444_: bool;
    var phi_1448_: evaluate_Verdict;

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
                phi_643_ = (_e95 == _e97);
                phi_644_ = false;
            } else {
                phi_643_ = bool();
                phi_644_ = true;
            }
            let _e100 = phi_643_;
            let _e102 = phi_644_;
            phi_645_ = _e100;
            phi_646_ = _e102;
        } else {
            phi_645_ = bool();
            phi_646_ = true;
        }
        let _e104 = phi_645_;
        let _e106 = phi_646_;
        if _e106 {
            phi_650_ = false;
        } else {
            phi_650_ = _e104;
        }
        let _e108 = phi_650_;
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
                    phi_721_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_720_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_720_ = false;
                    }
                    let _e169 = phi_720_;
                    phi_721_ = _e169;
                }
                let _e171 = phi_721_;
                if _e171 {
                    let _e173 = samples.member[(0u + _e72.first_primitive)].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_732_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_733_ = false;
                } else {
                    phi_732_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_733_ = true;
                }
                let _e192 = phi_732_;
                let _e194 = phi_733_;
                phi_734_ = _e192;
                phi_735_ = _e194;
            } else {
                phi_734_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_735_ = true;
            }
            let _e196 = phi_734_;
            let _e198 = phi_735_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_742_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_742_ = _e196;
            }
            let _e215 = phi_742_;
            phi_746_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_746_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_746_;
        if _e232.unnamed_1 {
            phi_1442_ = evaluate_Verdict(_e232.unnamed.visibility, _e232.unnamed.is_doubted);
            phi_1443_ = evaluate_Verdict();
            phi_1444_ = true;
        } else {
            let _e240 = samples.member[(0u + _e72.first_primitive)].position;
            let _e242 = p.member.map_size;
            let _e244 = (0.5f / f32(_e242));
            let _e251 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e258 = lt_math_LightPoint(vec2<f32>(_e251.uv.x, 0f), _e251.depth, _e251.is_inside);
            let _e262 = lt_math_LightPoint(_e258.uv, 0f, _e258.is_inside);
            phi_766_ = lt_math_LightPoint();
            phi_769_ = 0u;
            phi_771_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e262.uv, _e262.depth, false));
            loop {
                let _e269 = phi_766_;
                let _e271 = phi_769_;
                let _e273 = phi_771_;
                local_1 = _e273;
                local_2 = _e273;
                local_3 = _e273;
                if (_e271 < _e78) {
                    if _e273.point.is_inside {
                        phi_932_ = lt_math_LightPoint();
                        phi_933_ = u32();
                        phi_934_ = lt_math_LevelPoint();
                        phi_935_ = false;
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
                                phi_857_ = (_e309 <= 1f);
                            } else {
                                phi_857_ = false;
                            }
                            let _e341 = phi_857_;
                            if _e341 {
                                if (_e323 >= 0f) {
                                    phi_866_ = (_e323 <= 1f);
                                } else {
                                    phi_866_ = false;
                                }
                                let _e345 = phi_866_;
                                if _e345 {
                                    if (_e336 >= 0f) {
                                        phi_875_ = (_e336 <= 1f);
                                    } else {
                                        phi_875_ = false;
                                    }
                                    let _e349 = phi_875_;
                                    phi_876_ = _e349;
                                    phi_877_ = false;
                                } else {
                                    phi_876_ = bool();
                                    phi_877_ = true;
                                }
                                let _e351 = phi_876_;
                                let _e353 = phi_877_;
                                phi_878_ = _e351;
                                phi_879_ = _e353;
                            } else {
                                phi_878_ = bool();
                                phi_879_ = true;
                            }
                            let _e355 = phi_878_;
                            let _e357 = phi_879_;
                            phi_880_ = _e355;
                            phi_881_ = _e357;
                        } else {
                            phi_880_ = bool();
                            phi_881_ = true;
                        }
                        let _e359 = phi_880_;
                        let _e361 = phi_881_;
                        if _e361 {
                            phi_885_ = false;
                        } else {
                            phi_885_ = _e359;
                        }
                        let _e363 = phi_885_;
                        if _e363 {
                            if (_e309 >= _e244) {
                                if (_e309 <= (1f - _e244)) {
                                    if (_e323 >= _e244) {
                                        phi_912_ = (_e323 <= (1f - _e244));
                                        phi_913_ = false;
                                    } else {
                                        phi_912_ = bool();
                                        phi_913_ = true;
                                    }
                                    let _e371 = phi_912_;
                                    let _e373 = phi_913_;
                                    phi_914_ = _e371;
                                    phi_915_ = _e373;
                                } else {
                                    phi_914_ = bool();
                                    phi_915_ = true;
                                }
                                let _e375 = phi_914_;
                                let _e377 = phi_915_;
                                phi_916_ = _e375;
                                phi_917_ = _e377;
                            } else {
                                phi_916_ = bool();
                                phi_917_ = true;
                            }
                            let _e379 = phi_916_;
                            let _e381 = phi_917_;
                            phi_918_ = _e379;
                            phi_919_ = _e381;
                        } else {
                            phi_918_ = bool();
                            phi_919_ = true;
                        }
                        let _e383 = phi_918_;
                        let _e385 = phi_919_;
                        if _e385 {
                            phi_923_ = false;
                        } else {
                            phi_923_ = _e383;
                        }
                        let _e387 = phi_923_;
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e309, _e269.uv.y), _e269.depth, _e269.is_inside);
                        let _e401 = lt_math_LightPoint(vec2<f32>(_e394.uv.x, _e323), _e394.depth, _e394.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e336, _e401.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e405.depth, _e387);
                        phi_932_ = _e409;
                        phi_933_ = (_e271 + 1u);
                        phi_934_ = lt_math_LevelPoint(_e271, _e409);
                        phi_935_ = true;
                    }
                    let _e413 = phi_932_;
                    let _e415 = phi_933_;
                    let _e417 = phi_934_;
                    let _e419 = phi_935_;
                    phi_767_ = _e413;
                    phi_770_ = _e415;
                    phi_772_ = _e417;
                    phi_936_ = _e419;
                } else {
                    phi_767_ = lt_math_LightPoint();
                    phi_770_ = u32();
                    phi_772_ = lt_math_LevelPoint();
                    phi_936_ = false;
                }
                let _e421 = phi_767_;
                let _e423 = phi_770_;
                let _e425 = phi_772_;
                let _e427 = phi_936_;
                continue;
                continuing {
                    phi_766_ = _e421;
                    phi_769_ = _e423;
                    phi_771_ = _e425;
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
                            phi_976_ = (_e441.row_w.z == _e453);
                            phi_977_ = false;
                        } else {
                            phi_976_ = bool();
                            phi_977_ = true;
                        }
                        let _e456 = phi_976_;
                        let _e458 = phi_977_;
                        phi_978_ = _e456;
                        phi_979_ = _e458;
                    } else {
                        phi_978_ = bool();
                        phi_979_ = true;
                    }
                    let _e460 = phi_978_;
                    let _e462 = phi_979_;
                    if _e462 {
                        phi_983_ = false;
                    } else {
                        phi_983_ = _e460;
                    }
                    let _e464 = phi_983_;
                    if _e464 {
                        let _e466 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e468 = p.member.map_size;
                        let _e538 = ((abs(((((_e441.row_x.x * _e466.x) + (_e441.row_x.y * _e466.y)) + (_e441.row_x.z * _e466.z)) / (((_e441.row_x.x * _e441.row_x.x) + (_e441.row_x.y * _e441.row_x.y)) + (_e441.row_x.z * _e441.row_x.z)))) + abs(((((_e441.row_y.x * _e466.x) + (_e441.row_y.y * _e466.y)) + (_e441.row_y.z * _e466.z)) / (((_e441.row_y.x * _e441.row_y.x) + (_e441.row_y.y * _e441.row_y.y)) + (_e441.row_y.z * _e441.row_y.z))))) / (abs(((((_e441.row_z.x * _e466.x) + (_e441.row_z.y * _e466.y)) + (_e441.row_z.z * _e466.z)) / (((_e441.row_z.x * _e441.row_z.x) + (_e441.row_z.y * _e441.row_z.y)) + (_e441.row_z.z * _e441.row_z.z)))) * f32(_e468)));
                        if (_e538 < 0.002f) {
                            phi_1065_ = _e538;
                        } else {
                            phi_1065_ = 0.002f;
                        }
                        let _e541 = phi_1065_;
                        phi_1182_ = _e541;
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
                            phi_1181_ = _e655;
                        } else {
                            phi_1181_ = 0.002f;
                        }
                        let _e658 = phi_1181_;
                        phi_1182_ = _e658;
                    }
                    let _e660 = phi_1182_;
                    phi_1185_ = (_e430.point.depth - (0f * _e660));
                } else {
                    phi_1185_ = _e430.point.depth;
                }
                let _e664 = phi_1185_;
                let _e670 = p.member.map_size;
                let _e671 = f32(_e670);
                let _e674 = ((_e430.point.uv.x * _e671) - 0.5f);
                let _e675 = ((_e430.point.uv.y * _e671) - 0.5f);
                if (_e674 > -8388608f) {
                    let _e687 = f32(select(0i, select(select(i32(_e674), i32(-2147483648), (_e674 < bitcast<f32>(3472883712u))), 2147483647i, (_e674 > bitcast<f32>(1325400063u))), (_e674 == _e674)));
                    if (_e687 > _e674) {
                        phi_1214_ = 1f;
                    } else {
                        phi_1214_ = 0f;
                    }
                    let _e690 = phi_1214_;
                    if (_e674 < 8388608f) {
                        phi_1219_ = (_e687 - _e690);
                        phi_1220_ = false;
                    } else {
                        phi_1219_ = f32();
                        phi_1220_ = true;
                    }
                    let _e693 = phi_1219_;
                    let _e695 = phi_1220_;
                    phi_1221_ = _e693;
                    phi_1222_ = _e695;
                } else {
                    phi_1221_ = f32();
                    phi_1222_ = true;
                }
                let _e697 = phi_1221_;
                let _e699 = phi_1222_;
                if _e699 {
                    phi_1226_ = _e674;
                } else {
                    phi_1226_ = _e697;
                }
                let _e701 = phi_1226_;
                if (_e675 > -8388608f) {
                    let _e713 = f32(select(0i, select(select(i32(_e675), i32(-2147483648), (_e675 < bitcast<f32>(3472883712u))), 2147483647i, (_e675 > bitcast<f32>(1325400063u))), (_e675 == _e675)));
                    if (_e713 > _e675) {
                        phi_1246_ = 1f;
                    } else {
                        phi_1246_ = 0f;
                    }
                    let _e716 = phi_1246_;
                    if (_e675 < 8388608f) {
                        phi_1251_ = (_e713 - _e716);
                        phi_1252_ = false;
                    } else {
                        phi_1251_ = f32();
                        phi_1252_ = true;
                    }
                    let _e719 = phi_1251_;
                    let _e721 = phi_1252_;
                    phi_1253_ = _e719;
                    phi_1254_ = _e721;
                } else {
                    phi_1253_ = f32();
                    phi_1254_ = true;
                }
                let _e723 = phi_1253_;
                let _e725 = phi_1254_;
                if _e725 {
                    phi_1258_ = _e675;
                } else {
                    phi_1258_ = _e723;
                }
                let _e727 = phi_1258_;
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
                    phi_1311_ = _e738;
                } else {
                    phi_1311_ = 0i;
                }
                let _e774 = phi_1311_;
                if (_e747 > 0i) {
                    phi_1316_ = _e747;
                } else {
                    phi_1316_ = 0i;
                }
                let _e777 = phi_1316_;
                if (_e774 < _e771) {
                    phi_1321_ = _e774;
                } else {
                    phi_1321_ = _e771;
                }
                let _e780 = phi_1321_;
                if (_e777 < _e771) {
                    phi_1326_ = _e777;
                } else {
                    phi_1326_ = _e771;
                }
                let _e783 = phi_1326_;
                let _e784 = bitcast<u32>(_e780);
                let _e786 = (_e738 + 1i);
                let _e787 = (_e747 + 1i);
                if (_e786 > 0i) {
                    phi_1335_ = _e786;
                } else {
                    phi_1335_ = 0i;
                }
                let _e790 = phi_1335_;
                if (_e787 > 0i) {
                    phi_1340_ = _e787;
                } else {
                    phi_1340_ = 0i;
                }
                let _e793 = phi_1340_;
                if (_e790 < _e771) {
                    phi_1345_ = _e790;
                } else {
                    phi_1345_ = _e771;
                }
                let _e796 = phi_1345_;
                if (_e793 < _e771) {
                    phi_1350_ = _e793;
                } else {
                    phi_1350_ = _e771;
                }
                let _e799 = phi_1350_;
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
                phi_1439_ = evaluate_Verdict(_e873, false);
                phi_1440_ = evaluate_Verdict();
                phi_1441_ = false;
            } else {
                phi_1439_ = evaluate_Verdict();
                phi_1440_ = evaluate_Verdict(1f, false);
                phi_1441_ = true;
            }
            let _e877 = phi_1439_;
            let _e879 = phi_1440_;
            let _e881 = phi_1441_;
            phi_1442_ = _e879;
            phi_1443_ = _e877;
            phi_1444_ = _e881;
        }
        let _e883 = phi_1442_;
        let _e885 = phi_1443_;
        let _e887 = phi_1444_;
        if _e887 {
            phi_1448_ = _e883;
        } else {
            phi_1448_ = _e885;
        }
        let _e889 = phi_1448_;
        if (_e72.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e72.first_primitive)] = _e889.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
