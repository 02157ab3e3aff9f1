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

struct type_39 {
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

struct type_43 {
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

struct type_50 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct type_56 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_5: u32;
@group(0) @binding(1) 
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(4) 
var<storage, read_write> list: type_56;
@group(0) @binding(5) 
var<storage> levels: type_50;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_182_: lt_bvh_traverse_Tree;
    var phi_183_: bool;
    var phi_184_: lt_bvh_traverse_Tree;
    var phi_185_: bool;
    var phi_190_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_182_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_183_ = false;
        } else {
            phi_182_ = lt_bvh_traverse_Tree();
            phi_183_ = true;
        }
        let _e70 = phi_182_;
        let _e72 = phi_183_;
        phi_184_ = _e70;
        phi_185_ = _e72;
    } else {
        phi_184_ = lt_bvh_traverse_Tree();
        phi_185_ = true;
    }
    let _e74 = phi_184_;
    let _e76 = phi_185_;
    if _e76 {
        phi_190_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_190_ = _e74;
    }
    let _e81 = phi_190_;
    return lt_bvh_traverse_Tree(_e81.root, _e81.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_217_: f32;
    var phi_218_: f32;
    var phi_219_: f32;
    var phi_232_: bool;
    var phi_236_: f32;
    var phi_248_: f32;
    var phi_253_: f32;
    var phi_275_: f32;
    var phi_280_: f32;
    var phi_281_: bool;
    var phi_282_: f32;
    var phi_283_: bool;
    var phi_287_: f32;
    var phi_325_: f32;
    var phi_338_: bool;
    var phi_342_: f32;
    var phi_355_: f32;
    var phi_360_: f32;
    var phi_382_: f32;
    var phi_387_: f32;
    var phi_388_: bool;
    var phi_389_: f32;
    var phi_390_: bool;
    var phi_394_: f32;
    var phi_432_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_219_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_218_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_217_ = 1f;
            } else {
                phi_217_ = param_5;
            }
            let _e65 = phi_217_;
            phi_218_ = _e65;
        }
        let _e67 = phi_218_;
        phi_219_ = _e67;
    }
    let _e69 = phi_219_;
    let _e71 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_232_ = true;
    } else {
        let _e75 = (42f < _e71);
        if _e75 {
        }
        phi_232_ = _e75;
    }
    let _e77 = phi_232_;
    if _e77 {
        phi_236_ = 42f;
    } else {
        phi_236_ = _e71;
    }
    let _e79 = phi_236_;
    let _e80 = (_e79 * _e69);
    if ((bitcast<u32>(_e80) & 2147483647u) > 2139095040u) {
        phi_325_ = _e80;
    } else {
        if (_e80 < -87f) {
            phi_248_ = -87f;
        } else {
            phi_248_ = _e80;
        }
        let _e86 = phi_248_;
        if (_e86 > 88f) {
            phi_253_ = 88f;
        } else {
            phi_253_ = _e86;
        }
        let _e89 = phi_253_;
        let _e91 = ((_e89 * 1.442695f) + 0.5f);
        if (_e91 > -8388608f) {
            let _e103 = f32(select(0i, select(select(i32(_e91), i32(-2147483648), (_e91 < bitcast<f32>(3472883712u))), 2147483647i, (_e91 > bitcast<f32>(1325400063u))), (_e91 == _e91)));
            if (_e103 > _e91) {
                phi_275_ = 1f;
            } else {
                phi_275_ = 0f;
            }
            let _e106 = phi_275_;
            if (_e91 < 8388608f) {
                phi_280_ = (_e103 - _e106);
                phi_281_ = false;
            } else {
                phi_280_ = f32();
                phi_281_ = true;
            }
            let _e109 = phi_280_;
            let _e111 = phi_281_;
            phi_282_ = _e109;
            phi_283_ = _e111;
        } else {
            phi_282_ = f32();
            phi_283_ = true;
        }
        let _e113 = phi_282_;
        let _e115 = phi_283_;
        if _e115 {
            phi_287_ = _e91;
        } else {
            phi_287_ = _e113;
        }
        let _e117 = phi_287_;
        let _e121 = ((_e89 - (_e117 * 0.69314575f)) - (_e117 * 0.0000014286068f));
        phi_325_ = ((((((((((((((((1f / 5040f) * _e121) + (1f / 720f)) * _e121) + (1f / 120f)) * _e121) + (1f / 24f)) * _e121) + (1f / 6f)) * _e121) + 0.5f) * _e121) + 1f) * _e121) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e117), i32(-2147483648), (_e117 < bitcast<f32>(3472883712u))), 2147483647i, (_e117 > bitcast<f32>(1325400063u))), (_e117 == _e117)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e157 = phi_325_;
    let _e159 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_338_ = true;
    } else {
        let _e163 = (42f < _e159);
        if _e163 {
        }
        phi_338_ = _e163;
    }
    let _e165 = phi_338_;
    if _e165 {
        phi_342_ = 42f;
    } else {
        phi_342_ = _e159;
    }
    let _e167 = phi_342_;
    let _e169 = (-(_e167) * _e69);
    if ((bitcast<u32>(_e169) & 2147483647u) > 2139095040u) {
        phi_432_ = _e169;
    } else {
        if (_e169 < -87f) {
            phi_355_ = -87f;
        } else {
            phi_355_ = _e169;
        }
        let _e175 = phi_355_;
        if (_e175 > 88f) {
            phi_360_ = 88f;
        } else {
            phi_360_ = _e175;
        }
        let _e178 = phi_360_;
        let _e180 = ((_e178 * 1.442695f) + 0.5f);
        if (_e180 > -8388608f) {
            let _e192 = f32(select(0i, select(select(i32(_e180), i32(-2147483648), (_e180 < bitcast<f32>(3472883712u))), 2147483647i, (_e180 > bitcast<f32>(1325400063u))), (_e180 == _e180)));
            if (_e192 > _e180) {
                phi_382_ = 1f;
            } else {
                phi_382_ = 0f;
            }
            let _e195 = phi_382_;
            if (_e180 < 8388608f) {
                phi_387_ = (_e192 - _e195);
                phi_388_ = false;
            } else {
                phi_387_ = f32();
                phi_388_ = true;
            }
            let _e198 = phi_387_;
            let _e200 = phi_388_;
            phi_389_ = _e198;
            phi_390_ = _e200;
        } else {
            phi_389_ = f32();
            phi_390_ = true;
        }
        let _e202 = phi_389_;
        let _e204 = phi_390_;
        if _e204 {
            phi_394_ = _e180;
        } else {
            phi_394_ = _e202;
        }
        let _e206 = phi_394_;
        let _e210 = ((_e178 - (_e206 * 0.69314575f)) - (_e206 * 0.0000014286068f));
        phi_432_ = ((((((((((((((((1f / 5040f) * _e210) + (1f / 720f)) * _e210) + (1f / 120f)) * _e210) + (1f / 24f)) * _e210) + (1f / 6f)) * _e210) + 0.5f) * _e210) + 1f) * _e210) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e206), i32(-2147483648), (_e206 < bitcast<f32>(3472883712u))), 2147483647i, (_e206 > bitcast<f32>(1325400063u))), (_e206 == _e206)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e246 = phi_432_;
    let _e247 = -(_e246);
    return vec4<f32>(_e157, (_e157 * _e157), _e247, (_e247 * _e247));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_454_: bool;
    var phi_458_: f32;
    var phi_482_: bool;
    var phi_486_: f32;
    var phi_498_: bool;
    var phi_505_: f32;
    var phi_518_: bool;
    var phi_522_: f32;
    var phi_546_: bool;
    var phi_550_: f32;
    var phi_562_: bool;
    var phi_569_: f32;
    var phi_580_: bool;
    var phi_584_: f32;
    var phi_599_: f32;
    var phi_600_: f32;
    var phi_601_: f32;

    let _e60 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e62 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_454_ = true;
    } else {
        let _e66 = (42f < _e62);
        if _e66 {
        }
        phi_454_ = _e66;
    }
    let _e68 = phi_454_;
    if _e68 {
        phi_458_ = 42f;
    } else {
        phi_458_ = _e62;
    }
    let _e70 = phi_458_;
    let _e72 = (*param_6).min_variance;
    let _e76 = (((_e72 * _e70) * _e70) * _e60.y);
    let _e83 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e76) & 2147483647u) > 2139095040u) {
        phi_482_ = true;
    } else {
        let _e87 = (_e76 > _e83);
        if _e87 {
        }
        phi_482_ = _e87;
    }
    let _e89 = phi_482_;
    if _e89 {
        phi_486_ = _e76;
    } else {
        phi_486_ = _e83;
    }
    let _e91 = phi_486_;
    let _e92 = (_e60.x - param_7.x);
    if (_e92 <= 0f) {
        let _e96 = ((bitcast<u32>(_e91) & 2147483647u) > 2139095040u);
        if _e96 {
        }
        phi_498_ = _e96;
    } else {
        phi_498_ = true;
    }
    let _e98 = phi_498_;
    if _e98 {
        phi_505_ = (_e91 / (_e91 + (_e92 * _e92)));
    } else {
        phi_505_ = 1f;
    }
    let _e103 = phi_505_;
    let _e105 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_518_ = true;
    } else {
        let _e109 = (42f < _e105);
        if _e109 {
        }
        phi_518_ = _e109;
    }
    let _e111 = phi_518_;
    if _e111 {
        phi_522_ = 42f;
    } else {
        phi_522_ = _e105;
    }
    let _e113 = phi_522_;
    let _e115 = (*param_6).min_variance;
    let _e119 = (((_e115 * _e113) * _e113) * _e60.w);
    let _e126 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e119) & 2147483647u) > 2139095040u) {
        phi_546_ = true;
    } else {
        let _e130 = (_e119 > _e126);
        if _e130 {
        }
        phi_546_ = _e130;
    }
    let _e132 = phi_546_;
    if _e132 {
        phi_550_ = _e119;
    } else {
        phi_550_ = _e126;
    }
    let _e134 = phi_550_;
    let _e135 = (_e60.z - param_7.z);
    if (_e135 <= 0f) {
        let _e139 = ((bitcast<u32>(_e134) & 2147483647u) > 2139095040u);
        if _e139 {
        }
        phi_562_ = _e139;
    } else {
        phi_562_ = true;
    }
    let _e141 = phi_562_;
    if _e141 {
        phi_569_ = (_e134 / (_e134 + (_e135 * _e135)));
    } else {
        phi_569_ = 1f;
    }
    let _e146 = phi_569_;
    if ((bitcast<u32>(_e146) & 2147483647u) > 2139095040u) {
        phi_580_ = true;
    } else {
        let _e150 = (_e146 < _e103);
        if _e150 {
        }
        phi_580_ = _e150;
    }
    let _e152 = phi_580_;
    if _e152 {
        phi_584_ = _e146;
    } else {
        phi_584_ = _e103;
    }
    let _e154 = phi_584_;
    if ((bitcast<u32>(_e154) & 2147483647u) > 2139095040u) {
        phi_601_ = _e154;
    } else {
        if (_e154 < 0f) {
            phi_600_ = 0f;
        } else {
            if (_e154 > 1f) {
                phi_599_ = 1f;
            } else {
                phi_599_ = _e154;
            }
            let _e161 = phi_599_;
            phi_600_ = _e161;
        }
        let _e163 = phi_600_;
        phi_601_ = _e163;
    }
    let _e165 = phi_601_;
    return _e165;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_663_: bool;
    var phi_733_: bool;
    var phi_734_: bool;
    var phi_745_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_746_: bool;
    var phi_747_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_748_: bool;
    var phi_755_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_759_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_779_: lt_math_LightPoint;
    var phi_782_: u32;
    var phi_784_: lt_math_LevelPoint;
    var phi_870_: bool;
    var phi_879_: bool;
    var phi_888_: bool;
    var phi_889_: bool;
    var phi_890_: bool;
    var phi_891_: bool;
    var phi_892_: bool;
    var phi_893_: bool;
    var phi_894_: bool;
    var phi_898_: bool;
    var phi_925_: bool;
    var phi_926_: bool;
    var phi_927_: bool;
    var phi_928_: bool;
    var phi_929_: bool;
    var phi_930_: bool;
    var phi_931_: bool;
    var phi_932_: bool;
    var phi_936_: bool;
    var phi_945_: lt_math_LightPoint;
    var phi_946_: u32;
    var phi_947_: lt_math_LevelPoint;
    var phi_948_: bool;
    var phi_780_: lt_math_LightPoint;
    var phi_783_: u32;
    var phi_785_: lt_math_LevelPoint;
    var phi_949_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_989_: bool;
    var phi_990_: bool;
    var phi_991_: bool;
    var phi_992_: bool;
    var phi_996_: bool;
    var phi_1078_: f32;
    var phi_1196_: f32;
    var phi_1197_: f32;
    var phi_1200_: f32;
    var phi_1229_: f32;
    var phi_1234_: f32;
    var phi_1235_: bool;
    var phi_1236_: f32;
    var phi_1237_: bool;
    var phi_1241_: f32;
    var phi_1261_: f32;
    var phi_1266_: f32;
    var phi_1267_: bool;
    var phi_1268_: f32;
    var phi_1269_: bool;
    var phi_1273_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1326_: i32;
    var phi_1331_: i32;
    var phi_1336_: i32;
    var phi_1341_: i32;
    var phi_1350_: i32;
    var phi_1355_: i32;
    var phi_1360_: i32;
    var phi_1365_: i32;
    var phi_1460_: bool;
    var phi_1468_: bool;
    var phi_1480_: bool;
    var phi_1481_: bool;
    var phi_1485_: f32;
    var phi_1491_: f32;
    var phi_1493_: evaluate_Verdict;
    var phi_1498_: evaluate_Verdict;
    var phi_1499_: evaluate_Verdict;
    var phi_1503_: bool;
    var phi_1504_: u32;
    var phi_1515_: u32;

    let _e58 = id_1;
    let _e59 = local_5;
    let _e64 = arrayLength((&map.member));
    let _e69 = arrayLength((&levels.member));
    let _e72 = p.member.size[0u];
    let _e74 = p.member.size[1u];
    let _e75 = lt_shaders_entry_pixel_index(_e58, _e72, _e74);
    if (bitcast<i32>(_e75.root) != 0i) {
        let _e82 = p.member.level_count;
        let _e86 = samples.member[_e75.first_primitive].normal[0u];
        let _e88 = global[0u];
        if (_e86 == _e88) {
            let _e91 = samples.member[_e75.first_primitive].normal[1u];
            let _e93 = global[1u];
            if (_e91 == _e93) {
                let _e96 = samples.member[_e75.first_primitive].normal[2u];
                let _e98 = global[2u];
                phi_656_ = (_e96 == _e98);
                phi_657_ = false;
            } else {
                phi_656_ = bool();
                phi_657_ = true;
            }
            let _e101 = phi_656_;
            let _e103 = phi_657_;
            phi_658_ = _e101;
            phi_659_ = _e103;
        } else {
            phi_658_ = bool();
            phi_659_ = true;
        }
        let _e105 = phi_658_;
        let _e107 = phi_659_;
        if _e107 {
            phi_663_ = false;
        } else {
            phi_663_ = _e105;
        }
        let _e109 = phi_663_;
        if !(_e109) {
            let _e112 = samples.member[_e75.first_primitive].position;
            let _e114 = p.member.light.place;
            let _e120 = p.member.light.place[3u];
            let _e127 = (_e114.x - (_e112.x * _e120));
            let _e128 = (_e114.y - (_e112.y * _e120));
            let _e129 = (_e114.z - (_e112.z * _e120));
            let _e131 = samples.member[_e75.first_primitive].normal;
            if ((((_e131.x * _e127) + (_e131.y * _e128)) + (_e131.z * _e129)) > 0f) {
                let _e145 = (((_e127 * _e127) + (_e128 * _e128)) + (_e129 * _e129));
                let _e147 = p.member.light.axis;
                let _e159 = p.member.light.place[3u];
                if (_e159 == 0f) {
                    phi_734_ = true;
                } else {
                    let _e162 = p.member.light.range_squared;
                    if (_e145 <= _e162) {
                        let _e165 = p.member.light.cos_outer;
                        phi_733_ = (-((((_e127 * _e147.x) + (_e128 * _e147.y)) + (_e129 * _e147.z))) >= (_e165 * sqrt(_e145)));
                    } else {
                        phi_733_ = false;
                    }
                    let _e170 = phi_733_;
                    phi_734_ = _e170;
                }
                let _e172 = phi_734_;
                if _e172 {
                    let _e174 = samples.member[_e75.first_primitive].flags;
                    let _e182 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e182.unnamed.visibility, false), _e182.unnamed_1);
                    phi_745_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e188.unnamed, ((_e174 & 1u) == 0u));
                    phi_746_ = false;
                } else {
                    phi_745_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_746_ = true;
                }
                let _e193 = phi_745_;
                let _e195 = phi_746_;
                phi_747_ = _e193;
                phi_748_ = _e195;
            } else {
                phi_747_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_748_ = true;
            }
            let _e197 = phi_747_;
            let _e199 = phi_748_;
            if _e199 {
                let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
                phi_755_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, true);
            } else {
                phi_755_ = _e197;
            }
            let _e216 = phi_755_;
            phi_759_ = _e216;
        } else {
            let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e222.unnamed.visibility, false), _e222.unnamed_1);
            phi_759_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e228.unnamed, true);
        }
        let _e233 = phi_759_;
        if _e233.unnamed_1 {
            phi_1499_ = evaluate_Verdict(_e233.unnamed.visibility, _e233.unnamed.is_doubted);
        } else {
            let _e241 = samples.member[_e75.first_primitive].position;
            let _e243 = p.member.map_size;
            let _e245 = (0.5f / f32(_e243));
            let _e252 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e259 = lt_math_LightPoint(vec2<f32>(_e252.uv.x, 0f), _e252.depth, _e252.is_inside);
            let _e263 = lt_math_LightPoint(_e259.uv, 0f, _e259.is_inside);
            phi_779_ = lt_math_LightPoint();
            phi_782_ = 0u;
            phi_784_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e263.uv, _e263.depth, false));
            loop {
                let _e270 = phi_779_;
                let _e272 = phi_782_;
                let _e274 = phi_784_;
                local_2 = _e274;
                local_3 = _e274;
                local_4 = _e274;
                if (_e272 < _e82) {
                    if _e274.point.is_inside {
                        phi_945_ = lt_math_LightPoint();
                        phi_946_ = u32();
                        phi_947_ = lt_math_LevelPoint();
                        phi_948_ = false;
                    } else {
                        if (_e272 < _e69) {
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
                                phi_870_ = (_e310 <= 1f);
                            } else {
                                phi_870_ = false;
                            }
                            let _e342 = phi_870_;
                            if _e342 {
                                if (_e324 >= 0f) {
                                    phi_879_ = (_e324 <= 1f);
                                } else {
                                    phi_879_ = false;
                                }
                                let _e346 = phi_879_;
                                if _e346 {
                                    if (_e337 >= 0f) {
                                        phi_888_ = (_e337 <= 1f);
                                    } else {
                                        phi_888_ = false;
                                    }
                                    let _e350 = phi_888_;
                                    phi_889_ = _e350;
                                    phi_890_ = false;
                                } else {
                                    phi_889_ = bool();
                                    phi_890_ = true;
                                }
                                let _e352 = phi_889_;
                                let _e354 = phi_890_;
                                phi_891_ = _e352;
                                phi_892_ = _e354;
                            } else {
                                phi_891_ = bool();
                                phi_892_ = true;
                            }
                            let _e356 = phi_891_;
                            let _e358 = phi_892_;
                            phi_893_ = _e356;
                            phi_894_ = _e358;
                        } else {
                            phi_893_ = bool();
                            phi_894_ = true;
                        }
                        let _e360 = phi_893_;
                        let _e362 = phi_894_;
                        if _e362 {
                            phi_898_ = false;
                        } else {
                            phi_898_ = _e360;
                        }
                        let _e364 = phi_898_;
                        if _e364 {
                            if (_e310 >= _e245) {
                                if (_e310 <= (1f - _e245)) {
                                    if (_e324 >= _e245) {
                                        phi_925_ = (_e324 <= (1f - _e245));
                                        phi_926_ = false;
                                    } else {
                                        phi_925_ = bool();
                                        phi_926_ = true;
                                    }
                                    let _e372 = phi_925_;
                                    let _e374 = phi_926_;
                                    phi_927_ = _e372;
                                    phi_928_ = _e374;
                                } else {
                                    phi_927_ = bool();
                                    phi_928_ = true;
                                }
                                let _e376 = phi_927_;
                                let _e378 = phi_928_;
                                phi_929_ = _e376;
                                phi_930_ = _e378;
                            } else {
                                phi_929_ = bool();
                                phi_930_ = true;
                            }
                            let _e380 = phi_929_;
                            let _e382 = phi_930_;
                            phi_931_ = _e380;
                            phi_932_ = _e382;
                        } else {
                            phi_931_ = bool();
                            phi_932_ = true;
                        }
                        let _e384 = phi_931_;
                        let _e386 = phi_932_;
                        if _e386 {
                            phi_936_ = false;
                        } else {
                            phi_936_ = _e384;
                        }
                        let _e388 = phi_936_;
                        let _e395 = lt_math_LightPoint(vec2<f32>(_e310, _e270.uv.y), _e270.depth, _e270.is_inside);
                        let _e402 = lt_math_LightPoint(vec2<f32>(_e395.uv.x, _e324), _e395.depth, _e395.is_inside);
                        let _e406 = lt_math_LightPoint(_e402.uv, _e337, _e402.is_inside);
                        let _e410 = lt_math_LightPoint(_e406.uv, _e406.depth, _e388);
                        phi_945_ = _e410;
                        phi_946_ = (_e272 + 1u);
                        phi_947_ = lt_math_LevelPoint(_e272, _e410);
                        phi_948_ = true;
                    }
                    let _e414 = phi_945_;
                    let _e416 = phi_946_;
                    let _e418 = phi_947_;
                    let _e420 = phi_948_;
                    phi_780_ = _e414;
                    phi_783_ = _e416;
                    phi_785_ = _e418;
                    phi_949_ = _e420;
                } else {
                    phi_780_ = lt_math_LightPoint();
                    phi_783_ = u32();
                    phi_785_ = lt_math_LevelPoint();
                    phi_949_ = false;
                }
                let _e422 = phi_780_;
                let _e424 = phi_783_;
                let _e426 = phi_785_;
                let _e428 = phi_949_;
                continue;
                continuing {
                    phi_779_ = _e422;
                    phi_782_ = _e424;
                    phi_784_ = _e426;
                    break if !(_e428);
                }
            }
            let _e431 = local_2;
            if _e431.point.is_inside {
                if (0f > 0f) {
                    let _e437 = local_3;
                    if (_e437.level < _e69) {
                    } else {
                        return;
                    }
                    let _e442 = levels.member[(0u + _e437.level)];
                    let _e448 = global[0u];
                    if (_e442.row_w.x == _e448) {
                        let _e451 = global[1u];
                        if (_e442.row_w.y == _e451) {
                            let _e454 = global[2u];
                            phi_989_ = (_e442.row_w.z == _e454);
                            phi_990_ = false;
                        } else {
                            phi_989_ = bool();
                            phi_990_ = true;
                        }
                        let _e457 = phi_989_;
                        let _e459 = phi_990_;
                        phi_991_ = _e457;
                        phi_992_ = _e459;
                    } else {
                        phi_991_ = bool();
                        phi_992_ = true;
                    }
                    let _e461 = phi_991_;
                    let _e463 = phi_992_;
                    if _e463 {
                        phi_996_ = false;
                    } else {
                        phi_996_ = _e461;
                    }
                    let _e465 = phi_996_;
                    if _e465 {
                        let _e467 = samples.member[_e75.first_primitive].normal;
                        let _e469 = p.member.map_size;
                        let _e539 = ((abs(((((_e442.row_x.x * _e467.x) + (_e442.row_x.y * _e467.y)) + (_e442.row_x.z * _e467.z)) / (((_e442.row_x.x * _e442.row_x.x) + (_e442.row_x.y * _e442.row_x.y)) + (_e442.row_x.z * _e442.row_x.z)))) + abs(((((_e442.row_y.x * _e467.x) + (_e442.row_y.y * _e467.y)) + (_e442.row_y.z * _e467.z)) / (((_e442.row_y.x * _e442.row_y.x) + (_e442.row_y.y * _e442.row_y.y)) + (_e442.row_y.z * _e442.row_y.z))))) / (abs(((((_e442.row_z.x * _e467.x) + (_e442.row_z.y * _e467.y)) + (_e442.row_z.z * _e467.z)) / (((_e442.row_z.x * _e442.row_z.x) + (_e442.row_z.y * _e442.row_z.y)) + (_e442.row_z.z * _e442.row_z.z)))) * f32(_e469)));
                        if (_e539 < 0.002f) {
                            phi_1078_ = _e539;
                        } else {
                            phi_1078_ = 0.002f;
                        }
                        let _e542 = phi_1078_;
                        phi_1197_ = _e542;
                    } else {
                        let _e544 = p.member.map_size;
                        let _e550 = samples.member[_e75.first_primitive].position;
                        let _e561 = ((((_e442.row_w.x * _e550.x) + (_e442.row_w.y * _e550.y)) + (_e442.row_w.z * _e550.z)) + _e442.row_w.w);
                        let _e574 = ((_e442.row_x.x - (_e442.row_w.x * _e431.point.uv.x)) / _e561);
                        let _e575 = ((_e442.row_x.y - (_e442.row_w.y * _e431.point.uv.x)) / _e561);
                        let _e576 = ((_e442.row_x.z - (_e442.row_w.z * _e431.point.uv.x)) / _e561);
                        let _e589 = ((_e442.row_y.x - (_e442.row_w.x * _e431.point.uv.y)) / _e561);
                        let _e590 = ((_e442.row_y.y - (_e442.row_w.y * _e431.point.uv.y)) / _e561);
                        let _e591 = ((_e442.row_y.z - (_e442.row_w.z * _e431.point.uv.y)) / _e561);
                        let _e597 = samples.member[_e75.first_primitive].normal;
                        let _e602 = ((_e590 * _e597.z) - (_e597.y * _e591));
                        let _e607 = ((_e591 * _e597.x) - (_e597.z * _e589));
                        let _e612 = ((_e589 * _e597.y) - (_e597.x * _e590));
                        let _e614 = samples.member[_e75.first_primitive].normal;
                        let _e619 = ((_e575 * _e614.z) - (_e614.y * _e576));
                        let _e624 = ((_e576 * _e614.x) - (_e614.z * _e574));
                        let _e629 = ((_e574 * _e614.y) - (_e614.x * _e575));
                        let _e656 = ((abs(((((_e442.row_z.x * _e602) + (_e442.row_z.y * _e607)) + (_e442.row_z.z * _e612)) / (((_e574 * _e602) + (_e575 * _e607)) + (_e576 * _e612)))) + abs(((((_e442.row_z.x * _e619) + (_e442.row_z.y * _e624)) + (_e442.row_z.z * _e629)) / (((_e589 * _e619) + (_e590 * _e624)) + (_e591 * _e629))))) / f32(_e544));
                        let _e658 = (16f / f32(_e544));
                        if (_e656 < _e658) {
                            phi_1196_ = _e656;
                        } else {
                            phi_1196_ = _e658;
                        }
                        let _e661 = phi_1196_;
                        phi_1197_ = _e661;
                    }
                    let _e663 = phi_1197_;
                    phi_1200_ = (_e431.point.depth - (0f * _e663));
                } else {
                    phi_1200_ = _e431.point.depth;
                }
                let _e667 = phi_1200_;
                let _e673 = p.member.map_size;
                let _e674 = f32(_e673);
                let _e677 = ((_e431.point.uv.x * _e674) - 0.5f);
                let _e678 = ((_e431.point.uv.y * _e674) - 0.5f);
                if (_e677 > -8388608f) {
                    let _e690 = f32(select(0i, select(select(i32(_e677), i32(-2147483648), (_e677 < bitcast<f32>(3472883712u))), 2147483647i, (_e677 > bitcast<f32>(1325400063u))), (_e677 == _e677)));
                    if (_e690 > _e677) {
                        phi_1229_ = 1f;
                    } else {
                        phi_1229_ = 0f;
                    }
                    let _e693 = phi_1229_;
                    if (_e677 < 8388608f) {
                        phi_1234_ = (_e690 - _e693);
                        phi_1235_ = false;
                    } else {
                        phi_1234_ = f32();
                        phi_1235_ = true;
                    }
                    let _e696 = phi_1234_;
                    let _e698 = phi_1235_;
                    phi_1236_ = _e696;
                    phi_1237_ = _e698;
                } else {
                    phi_1236_ = f32();
                    phi_1237_ = true;
                }
                let _e700 = phi_1236_;
                let _e702 = phi_1237_;
                if _e702 {
                    phi_1241_ = _e677;
                } else {
                    phi_1241_ = _e700;
                }
                let _e704 = phi_1241_;
                if (_e678 > -8388608f) {
                    let _e716 = f32(select(0i, select(select(i32(_e678), i32(-2147483648), (_e678 < bitcast<f32>(3472883712u))), 2147483647i, (_e678 > bitcast<f32>(1325400063u))), (_e678 == _e678)));
                    if (_e716 > _e678) {
                        phi_1261_ = 1f;
                    } else {
                        phi_1261_ = 0f;
                    }
                    let _e719 = phi_1261_;
                    if (_e678 < 8388608f) {
                        phi_1266_ = (_e716 - _e719);
                        phi_1267_ = false;
                    } else {
                        phi_1266_ = f32();
                        phi_1267_ = true;
                    }
                    let _e722 = phi_1266_;
                    let _e724 = phi_1267_;
                    phi_1268_ = _e722;
                    phi_1269_ = _e724;
                } else {
                    phi_1268_ = f32();
                    phi_1269_ = true;
                }
                let _e726 = phi_1268_;
                let _e728 = phi_1269_;
                if _e728 {
                    phi_1273_ = _e678;
                } else {
                    phi_1273_ = _e726;
                }
                let _e730 = phi_1273_;
                let _e731 = (_e677 - _e704);
                let _e732 = (_e678 - _e730);
                let _e741 = select(0i, select(select(i32(_e704), i32(-2147483648), (_e704 < bitcast<f32>(3472883712u))), 2147483647i, (_e704 > bitcast<f32>(1325400063u))), (_e704 == _e704));
                let _e750 = select(0i, select(select(i32(_e730), i32(-2147483648), (_e730 < bitcast<f32>(3472883712u))), 2147483647i, (_e730 > bitcast<f32>(1325400063u))), (_e730 == _e730));
                let _e753 = ((1f - _e731) * (1f - _e732));
                let _e755 = (_e731 * (1f - _e732));
                let _e757 = ((1f - _e731) * _e732);
                let _e758 = (_e731 * _e732);
                let _e760 = p.member.test;
                let _e761 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e760);
                let _e763 = p.member.map_size;
                let _e765 = local_4;
                local_1 = lt_math_Evsm(_e761.positive_exponent, _e761.negative_exponent, _e761.min_variance);
                let _e772 = ((_e765.level * _e763) * _e763);
                let _e774 = (bitcast<i32>(_e763) - 1i);
                if (_e741 > 0i) {
                    phi_1326_ = _e741;
                } else {
                    phi_1326_ = 0i;
                }
                let _e777 = phi_1326_;
                if (_e750 > 0i) {
                    phi_1331_ = _e750;
                } else {
                    phi_1331_ = 0i;
                }
                let _e780 = phi_1331_;
                if (_e777 < _e774) {
                    phi_1336_ = _e777;
                } else {
                    phi_1336_ = _e774;
                }
                let _e783 = phi_1336_;
                if (_e780 < _e774) {
                    phi_1341_ = _e780;
                } else {
                    phi_1341_ = _e774;
                }
                let _e786 = phi_1341_;
                let _e787 = bitcast<u32>(_e783);
                let _e789 = (_e741 + 1i);
                let _e790 = (_e750 + 1i);
                if (_e789 > 0i) {
                    phi_1350_ = _e789;
                } else {
                    phi_1350_ = 0i;
                }
                let _e793 = phi_1350_;
                if (_e790 > 0i) {
                    phi_1355_ = _e790;
                } else {
                    phi_1355_ = 0i;
                }
                let _e796 = phi_1355_;
                if (_e793 < _e774) {
                    phi_1360_ = _e793;
                } else {
                    phi_1360_ = _e774;
                }
                let _e799 = phi_1360_;
                if (_e796 < _e774) {
                    phi_1365_ = _e796;
                } else {
                    phi_1365_ = _e774;
                }
                let _e802 = phi_1365_;
                let _e803 = bitcast<u32>(_e799);
                let _e805 = (bitcast<u32>(_e786) * _e763);
                let _e806 = (bitcast<u32>(_e802) * _e763);
                let _e811 = ((_e805 + _e787) + _e772);
                let _e812 = ((_e805 + _e803) + _e772);
                let _e813 = ((_e806 + _e787) + _e772);
                let _e814 = ((_e806 + _e803) + _e772);
                if (_e811 < _e64) {
                } else {
                    return;
                }
                let _e818 = map.member[(0u + _e811)];
                if (_e812 < _e64) {
                } else {
                    return;
                }
                let _e830 = map.member[(0u + _e812)];
                if (_e813 < _e64) {
                } else {
                    return;
                }
                let _e846 = map.member[(0u + _e813)];
                if (_e814 < _e64) {
                } else {
                    return;
                }
                let _e862 = map.member[(0u + _e814)];
                let _e876 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e818.x * _e753) + (_e830.x * _e755)) + (_e846.x * _e757)) + (_e862.x * _e758)), ((((_e818.y * _e753) + (_e830.y * _e755)) + (_e846.y * _e757)) + (_e862.y * _e758)), ((((_e818.z * _e753) + (_e830.z * _e755)) + (_e846.z * _e757)) + (_e862.z * _e758)), ((((_e818.w * _e753) + (_e830.w * _e755)) + (_e846.w * _e757)) + (_e862.w * _e758))), _e667);
                let _e878 = p.member.epsilon;
                if (_e876 <= _e878) {
                    phi_1460_ = true;
                } else {
                    phi_1460_ = (_e876 >= (1f - _e878));
                }
                let _e883 = phi_1460_;
                if ((bitcast<u32>(_e876) & 2147483647u) > 2139095040u) {
                    phi_1468_ = true;
                } else {
                    phi_1468_ = !(_e883);
                }
                let _e889 = phi_1468_;
                if _e889 {
                    if (_e876 > 0f) {
                        if (_e876 < 1f) {
                            phi_1480_ = false;
                        } else {
                            phi_1480_ = true;
                        }
                        let _e893 = phi_1480_;
                        phi_1481_ = _e893;
                    } else {
                        phi_1481_ = true;
                    }
                    let _e895 = phi_1481_;
                    if _e895 {
                        phi_1485_ = 0.5f;
                    } else {
                        phi_1485_ = _e876;
                    }
                    let _e897 = phi_1485_;
                    phi_1493_ = evaluate_Verdict(_e897, true);
                } else {
                    if (_e876 > 0.5f) {
                        phi_1491_ = 1f;
                    } else {
                        phi_1491_ = 0f;
                    }
                    let _e901 = phi_1491_;
                    phi_1493_ = evaluate_Verdict(_e901, false);
                }
                let _e904 = phi_1493_;
                phi_1498_ = evaluate_Verdict(_e904.visibility, _e904.is_doubted);
            } else {
                phi_1498_ = evaluate_Verdict(0.5f, true);
            }
            let _e910 = phi_1498_;
            phi_1499_ = _e910;
        }
        let _e912 = phi_1499_;
        visibility.member[_e75.first_primitive] = _e912.visibility;
        phi_1503_ = _e912.is_doubted;
        phi_1504_ = _e75.first_primitive;
    } else {
        phi_1503_ = false;
        phi_1504_ = 0u;
    }
    let _e917 = phi_1503_;
    let _e919 = phi_1504_;
    if (_e59 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e917 {
        let _e923 = atomicAdd((&shared_[0u]), 1u);
        phi_1515_ = _e923;
    } else {
        phi_1515_ = 0u;
    }
    let _e925 = phi_1515_;
    workgroupBarrier();
    if (_e59 == 0u) {
        let _e929 = atomicLoad((&shared_[0u]));
        let _e930 = atomicAdd((&list.member[3u]), _e929);
        atomicStore((&shared_[1u]), _e930);
    }
    workgroupBarrier();
    if _e917 {
        let _e933 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e933) + _e925)]), _e919);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
