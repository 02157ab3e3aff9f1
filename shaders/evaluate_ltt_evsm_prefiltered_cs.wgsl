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

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct type_51 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(4) 
var<storage, read_write> list: type_51;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_175_: lt_bvh_traverse_Tree;
    var phi_176_: bool;
    var phi_177_: lt_bvh_traverse_Tree;
    var phi_178_: bool;
    var phi_183_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_175_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_176_ = false;
        } else {
            phi_175_ = lt_bvh_traverse_Tree();
            phi_176_ = true;
        }
        let _e68 = phi_175_;
        let _e70 = phi_176_;
        phi_177_ = _e68;
        phi_178_ = _e70;
    } else {
        phi_177_ = lt_bvh_traverse_Tree();
        phi_178_ = true;
    }
    let _e72 = phi_177_;
    let _e74 = phi_178_;
    if _e74 {
        phi_183_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_183_ = _e72;
    }
    let _e79 = phi_183_;
    return lt_bvh_traverse_Tree(_e79.root, _e79.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_210_: f32;
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_225_: bool;
    var phi_229_: f32;
    var phi_241_: f32;
    var phi_246_: f32;
    var phi_268_: f32;
    var phi_273_: f32;
    var phi_274_: bool;
    var phi_275_: f32;
    var phi_276_: bool;
    var phi_280_: f32;
    var phi_318_: f32;
    var phi_331_: bool;
    var phi_335_: f32;
    var phi_348_: f32;
    var phi_353_: f32;
    var phi_375_: f32;
    var phi_380_: f32;
    var phi_381_: bool;
    var phi_382_: f32;
    var phi_383_: bool;
    var phi_387_: f32;
    var phi_425_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_212_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_211_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_210_ = 1f;
            } else {
                phi_210_ = param_5;
            }
            let _e63 = phi_210_;
            phi_211_ = _e63;
        }
        let _e65 = phi_211_;
        phi_212_ = _e65;
    }
    let _e67 = phi_212_;
    let _e69 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_225_ = true;
    } else {
        let _e73 = (42f < _e69);
        if _e73 {
        }
        phi_225_ = _e73;
    }
    let _e75 = phi_225_;
    if _e75 {
        phi_229_ = 42f;
    } else {
        phi_229_ = _e69;
    }
    let _e77 = phi_229_;
    let _e78 = (_e77 * _e67);
    if ((bitcast<u32>(_e78) & 2147483647u) > 2139095040u) {
        phi_318_ = _e78;
    } else {
        if (_e78 < -87f) {
            phi_241_ = -87f;
        } else {
            phi_241_ = _e78;
        }
        let _e84 = phi_241_;
        if (_e84 > 88f) {
            phi_246_ = 88f;
        } else {
            phi_246_ = _e84;
        }
        let _e87 = phi_246_;
        let _e89 = ((_e87 * 1.442695f) + 0.5f);
        if (_e89 > -8388608f) {
            let _e101 = f32(select(0i, select(select(i32(_e89), i32(-2147483648), (_e89 < bitcast<f32>(3472883712u))), 2147483647i, (_e89 > bitcast<f32>(1325400063u))), (_e89 == _e89)));
            if (_e101 > _e89) {
                phi_268_ = 1f;
            } else {
                phi_268_ = 0f;
            }
            let _e104 = phi_268_;
            if (_e89 < 8388608f) {
                phi_273_ = (_e101 - _e104);
                phi_274_ = false;
            } else {
                phi_273_ = f32();
                phi_274_ = true;
            }
            let _e107 = phi_273_;
            let _e109 = phi_274_;
            phi_275_ = _e107;
            phi_276_ = _e109;
        } else {
            phi_275_ = f32();
            phi_276_ = true;
        }
        let _e111 = phi_275_;
        let _e113 = phi_276_;
        if _e113 {
            phi_280_ = _e89;
        } else {
            phi_280_ = _e111;
        }
        let _e115 = phi_280_;
        let _e119 = ((_e87 - (_e115 * 0.69314575f)) - (_e115 * 0.0000014286068f));
        phi_318_ = ((((((((((((((((1f / 5040f) * _e119) + (1f / 720f)) * _e119) + (1f / 120f)) * _e119) + (1f / 24f)) * _e119) + (1f / 6f)) * _e119) + 0.5f) * _e119) + 1f) * _e119) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e115), i32(-2147483648), (_e115 < bitcast<f32>(3472883712u))), 2147483647i, (_e115 > bitcast<f32>(1325400063u))), (_e115 == _e115)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e155 = phi_318_;
    let _e157 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_331_ = true;
    } else {
        let _e161 = (42f < _e157);
        if _e161 {
        }
        phi_331_ = _e161;
    }
    let _e163 = phi_331_;
    if _e163 {
        phi_335_ = 42f;
    } else {
        phi_335_ = _e157;
    }
    let _e165 = phi_335_;
    let _e167 = (-(_e165) * _e67);
    if ((bitcast<u32>(_e167) & 2147483647u) > 2139095040u) {
        phi_425_ = _e167;
    } else {
        if (_e167 < -87f) {
            phi_348_ = -87f;
        } else {
            phi_348_ = _e167;
        }
        let _e173 = phi_348_;
        if (_e173 > 88f) {
            phi_353_ = 88f;
        } else {
            phi_353_ = _e173;
        }
        let _e176 = phi_353_;
        let _e178 = ((_e176 * 1.442695f) + 0.5f);
        if (_e178 > -8388608f) {
            let _e190 = f32(select(0i, select(select(i32(_e178), i32(-2147483648), (_e178 < bitcast<f32>(3472883712u))), 2147483647i, (_e178 > bitcast<f32>(1325400063u))), (_e178 == _e178)));
            if (_e190 > _e178) {
                phi_375_ = 1f;
            } else {
                phi_375_ = 0f;
            }
            let _e193 = phi_375_;
            if (_e178 < 8388608f) {
                phi_380_ = (_e190 - _e193);
                phi_381_ = false;
            } else {
                phi_380_ = f32();
                phi_381_ = true;
            }
            let _e196 = phi_380_;
            let _e198 = phi_381_;
            phi_382_ = _e196;
            phi_383_ = _e198;
        } else {
            phi_382_ = f32();
            phi_383_ = true;
        }
        let _e200 = phi_382_;
        let _e202 = phi_383_;
        if _e202 {
            phi_387_ = _e178;
        } else {
            phi_387_ = _e200;
        }
        let _e204 = phi_387_;
        let _e208 = ((_e176 - (_e204 * 0.69314575f)) - (_e204 * 0.0000014286068f));
        phi_425_ = ((((((((((((((((1f / 5040f) * _e208) + (1f / 720f)) * _e208) + (1f / 120f)) * _e208) + (1f / 24f)) * _e208) + (1f / 6f)) * _e208) + 0.5f) * _e208) + 1f) * _e208) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e204), i32(-2147483648), (_e204 < bitcast<f32>(3472883712u))), 2147483647i, (_e204 > bitcast<f32>(1325400063u))), (_e204 == _e204)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e244 = phi_425_;
    let _e245 = -(_e244);
    return vec4<f32>(_e155, (_e155 * _e155), _e245, (_e245 * _e245));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_447_: bool;
    var phi_451_: f32;
    var phi_475_: bool;
    var phi_479_: f32;
    var phi_491_: bool;
    var phi_498_: f32;
    var phi_511_: bool;
    var phi_515_: f32;
    var phi_539_: bool;
    var phi_543_: f32;
    var phi_555_: bool;
    var phi_562_: f32;
    var phi_573_: bool;
    var phi_577_: f32;
    var phi_592_: f32;
    var phi_593_: f32;
    var phi_594_: f32;

    let _e58 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e60 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_447_ = true;
    } else {
        let _e64 = (42f < _e60);
        if _e64 {
        }
        phi_447_ = _e64;
    }
    let _e66 = phi_447_;
    if _e66 {
        phi_451_ = 42f;
    } else {
        phi_451_ = _e60;
    }
    let _e68 = phi_451_;
    let _e70 = (*param_6).min_variance;
    let _e74 = (((_e70 * _e68) * _e68) * _e58.y);
    let _e81 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e74) & 2147483647u) > 2139095040u) {
        phi_475_ = true;
    } else {
        let _e85 = (_e74 > _e81);
        if _e85 {
        }
        phi_475_ = _e85;
    }
    let _e87 = phi_475_;
    if _e87 {
        phi_479_ = _e74;
    } else {
        phi_479_ = _e81;
    }
    let _e89 = phi_479_;
    let _e90 = (_e58.x - param_7.x);
    if (_e90 <= 0f) {
        let _e94 = ((bitcast<u32>(_e89) & 2147483647u) > 2139095040u);
        if _e94 {
        }
        phi_491_ = _e94;
    } else {
        phi_491_ = true;
    }
    let _e96 = phi_491_;
    if _e96 {
        phi_498_ = (_e89 / (_e89 + (_e90 * _e90)));
    } else {
        phi_498_ = 1f;
    }
    let _e101 = phi_498_;
    let _e103 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_511_ = true;
    } else {
        let _e107 = (42f < _e103);
        if _e107 {
        }
        phi_511_ = _e107;
    }
    let _e109 = phi_511_;
    if _e109 {
        phi_515_ = 42f;
    } else {
        phi_515_ = _e103;
    }
    let _e111 = phi_515_;
    let _e113 = (*param_6).min_variance;
    let _e117 = (((_e113 * _e111) * _e111) * _e58.w);
    let _e124 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
        phi_539_ = true;
    } else {
        let _e128 = (_e117 > _e124);
        if _e128 {
        }
        phi_539_ = _e128;
    }
    let _e130 = phi_539_;
    if _e130 {
        phi_543_ = _e117;
    } else {
        phi_543_ = _e124;
    }
    let _e132 = phi_543_;
    let _e133 = (_e58.z - param_7.z);
    if (_e133 <= 0f) {
        let _e137 = ((bitcast<u32>(_e132) & 2147483647u) > 2139095040u);
        if _e137 {
        }
        phi_555_ = _e137;
    } else {
        phi_555_ = true;
    }
    let _e139 = phi_555_;
    if _e139 {
        phi_562_ = (_e132 / (_e132 + (_e133 * _e133)));
    } else {
        phi_562_ = 1f;
    }
    let _e144 = phi_562_;
    if ((bitcast<u32>(_e144) & 2147483647u) > 2139095040u) {
        phi_573_ = true;
    } else {
        let _e148 = (_e144 < _e101);
        if _e148 {
        }
        phi_573_ = _e148;
    }
    let _e150 = phi_573_;
    if _e150 {
        phi_577_ = _e144;
    } else {
        phi_577_ = _e101;
    }
    let _e152 = phi_577_;
    if ((bitcast<u32>(_e152) & 2147483647u) > 2139095040u) {
        phi_594_ = _e152;
    } else {
        if (_e152 < 0f) {
            phi_593_ = 0f;
        } else {
            if (_e152 > 1f) {
                phi_592_ = 1f;
            } else {
                phi_592_ = _e152;
            }
            let _e159 = phi_592_;
            phi_593_ = _e159;
        }
        let _e161 = phi_593_;
        phi_594_ = _e161;
    }
    let _e163 = phi_594_;
    return _e163;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_652_: bool;
    var phi_722_: bool;
    var phi_723_: bool;
    var phi_734_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_735_: bool;
    var phi_736_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_737_: bool;
    var phi_744_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_748_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_822_: bool;
    var phi_831_: bool;
    var phi_840_: bool;
    var phi_841_: bool;
    var phi_842_: bool;
    var phi_843_: bool;
    var phi_844_: bool;
    var phi_845_: bool;
    var phi_846_: bool;
    var phi_850_: bool;
    var phi_940_: f32;
    var phi_943_: f32;
    var phi_972_: f32;
    var phi_977_: f32;
    var phi_978_: bool;
    var phi_979_: f32;
    var phi_980_: bool;
    var phi_984_: f32;
    var phi_1004_: f32;
    var phi_1009_: f32;
    var phi_1010_: bool;
    var phi_1011_: f32;
    var phi_1012_: bool;
    var phi_1016_: f32;
    var phi_1068_: i32;
    var phi_1073_: i32;
    var phi_1078_: i32;
    var phi_1083_: i32;
    var phi_1092_: i32;
    var phi_1097_: i32;
    var phi_1102_: i32;
    var phi_1107_: i32;
    var phi_1204_: bool;
    var phi_1212_: bool;
    var phi_1224_: bool;
    var phi_1225_: bool;
    var phi_1229_: f32;
    var phi_1235_: f32;
    var phi_1237_: evaluate_Verdict;
    var phi_1247_: u32;
    var phi_1256_: f32;
    var phi_1258_: evaluate_Verdict;
    var phi_1259_: bool;
    var phi_1260_: evaluate_Verdict;
    var phi_1261_: bool;
    var phi_1266_: evaluate_Verdict;
    var phi_1271_: evaluate_Verdict;
    var phi_1272_: evaluate_Verdict;
    var phi_1276_: bool;
    var phi_1277_: u32;
    var phi_1288_: u32;
    var phi_1305_: u32;

    let _e56 = id_1;
    let _e57 = local_2;
    let _e62 = arrayLength((&map.member));
    let _e67 = p.member.size[0u];
    let _e69 = p.member.size[1u];
    let _e70 = lt_shaders_entry_pixel_index(_e56, _e67, _e69);
    if (bitcast<i32>(_e70.root) != 0i) {
        let _e77 = p.member.projection;
        let _e78 = lt_math_OneLevel(_e77);
        let _e82 = samples.member[_e70.first_primitive].normal[0u];
        let _e84 = global[0u];
        if (_e82 == _e84) {
            let _e87 = samples.member[_e70.first_primitive].normal[1u];
            let _e89 = global[1u];
            if (_e87 == _e89) {
                let _e92 = samples.member[_e70.first_primitive].normal[2u];
                let _e94 = global[2u];
                phi_645_ = (_e92 == _e94);
                phi_646_ = false;
            } else {
                phi_645_ = bool();
                phi_646_ = true;
            }
            let _e97 = phi_645_;
            let _e99 = phi_646_;
            phi_647_ = _e97;
            phi_648_ = _e99;
        } else {
            phi_647_ = bool();
            phi_648_ = true;
        }
        let _e101 = phi_647_;
        let _e103 = phi_648_;
        if _e103 {
            phi_652_ = false;
        } else {
            phi_652_ = _e101;
        }
        let _e105 = phi_652_;
        if !(_e105) {
            let _e108 = samples.member[_e70.first_primitive].position;
            let _e110 = p.member.light.place;
            let _e116 = p.member.light.place[3u];
            let _e123 = (_e110.x - (_e108.x * _e116));
            let _e124 = (_e110.y - (_e108.y * _e116));
            let _e125 = (_e110.z - (_e108.z * _e116));
            let _e127 = samples.member[_e70.first_primitive].normal;
            if ((((_e127.x * _e123) + (_e127.y * _e124)) + (_e127.z * _e125)) > 0f) {
                let _e141 = (((_e123 * _e123) + (_e124 * _e124)) + (_e125 * _e125));
                let _e143 = p.member.light.axis;
                let _e155 = p.member.light.place[3u];
                if (_e155 == 0f) {
                    phi_723_ = true;
                } else {
                    let _e158 = p.member.light.range_squared;
                    if (_e141 <= _e158) {
                        let _e161 = p.member.light.cos_outer;
                        phi_722_ = (-((((_e123 * _e143.x) + (_e124 * _e143.y)) + (_e125 * _e143.z))) >= (_e161 * sqrt(_e141)));
                    } else {
                        phi_722_ = false;
                    }
                    let _e166 = phi_722_;
                    phi_723_ = _e166;
                }
                let _e168 = phi_723_;
                if _e168 {
                    let _e170 = samples.member[_e70.first_primitive].flags;
                    let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e178.unnamed.visibility, false), _e178.unnamed_1);
                    phi_734_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e184.unnamed, ((_e170 & 1u) == 0u));
                    phi_735_ = false;
                } else {
                    phi_734_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_735_ = true;
                }
                let _e189 = phi_734_;
                let _e191 = phi_735_;
                phi_736_ = _e189;
                phi_737_ = _e191;
            } else {
                phi_736_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_737_ = true;
            }
            let _e193 = phi_736_;
            let _e195 = phi_737_;
            if _e195 {
                let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e201.unnamed.visibility, false), _e201.unnamed_1);
                phi_744_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e207.unnamed, true);
            } else {
                phi_744_ = _e193;
            }
            let _e212 = phi_744_;
            phi_748_ = _e212;
        } else {
            let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e224 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e218.unnamed.visibility, false), _e218.unnamed_1);
            phi_748_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e224.unnamed, true);
        }
        let _e229 = phi_748_;
        if _e229.unnamed_1 {
            phi_1272_ = evaluate_Verdict(_e229.unnamed.visibility, _e229.unnamed.is_doubted);
        } else {
            let _e237 = samples.member[_e70.first_primitive].position;
            let _e255 = ((((_e78.projection.row_w.x * _e237.x) + (_e78.projection.row_w.y * _e237.y)) + (_e78.projection.row_w.z * _e237.z)) + (_e78.projection.row_w.w * 1f));
            let _e269 = (((((_e78.projection.row_x.x * _e237.x) + (_e78.projection.row_x.y * _e237.y)) + (_e78.projection.row_x.z * _e237.z)) + (_e78.projection.row_x.w * 1f)) / _e255);
            let _e283 = (((((_e78.projection.row_y.x * _e237.x) + (_e78.projection.row_y.y * _e237.y)) + (_e78.projection.row_y.z * _e237.z)) + (_e78.projection.row_y.w * 1f)) / _e255);
            let _e296 = ((((_e78.projection.row_z.x * _e237.x) + (_e78.projection.row_z.y * _e237.y)) + (_e78.projection.row_z.z * _e237.z)) + (_e78.projection.row_z.w * 1f));
            if (_e255 > 0f) {
                if (_e269 >= 0f) {
                    phi_822_ = (_e269 <= 1f);
                } else {
                    phi_822_ = false;
                }
                let _e301 = phi_822_;
                if _e301 {
                    if (_e283 >= 0f) {
                        phi_831_ = (_e283 <= 1f);
                    } else {
                        phi_831_ = false;
                    }
                    let _e305 = phi_831_;
                    if _e305 {
                        if (_e296 >= 0f) {
                            phi_840_ = (_e296 <= 1f);
                        } else {
                            phi_840_ = false;
                        }
                        let _e309 = phi_840_;
                        phi_841_ = _e309;
                        phi_842_ = false;
                    } else {
                        phi_841_ = bool();
                        phi_842_ = true;
                    }
                    let _e311 = phi_841_;
                    let _e313 = phi_842_;
                    phi_843_ = _e311;
                    phi_844_ = _e313;
                } else {
                    phi_843_ = bool();
                    phi_844_ = true;
                }
                let _e315 = phi_843_;
                let _e317 = phi_844_;
                phi_845_ = _e315;
                phi_846_ = _e317;
            } else {
                phi_845_ = bool();
                phi_846_ = true;
            }
            let _e319 = phi_845_;
            let _e321 = phi_846_;
            if _e321 {
                phi_850_ = false;
            } else {
                phi_850_ = _e319;
            }
            let _e323 = phi_850_;
            if _e323 {
                if (0f > 0f) {
                    let _e326 = samples.member[_e70.first_primitive].normal;
                    let _e328 = p.member.map_size;
                    let _e398 = ((abs(((((_e77.row_x.x * _e326.x) + (_e77.row_x.y * _e326.y)) + (_e77.row_x.z * _e326.z)) / (((_e77.row_x.x * _e77.row_x.x) + (_e77.row_x.y * _e77.row_x.y)) + (_e77.row_x.z * _e77.row_x.z)))) + abs(((((_e77.row_y.x * _e326.x) + (_e77.row_y.y * _e326.y)) + (_e77.row_y.z * _e326.z)) / (((_e77.row_y.x * _e77.row_y.x) + (_e77.row_y.y * _e77.row_y.y)) + (_e77.row_y.z * _e77.row_y.z))))) / (abs(((((_e77.row_z.x * _e326.x) + (_e77.row_z.y * _e326.y)) + (_e77.row_z.z * _e326.z)) / (((_e77.row_z.x * _e77.row_z.x) + (_e77.row_z.y * _e77.row_z.y)) + (_e77.row_z.z * _e77.row_z.z)))) * f32(_e328)));
                    if (_e398 < 0.002f) {
                        phi_940_ = _e398;
                    } else {
                        phi_940_ = 0.002f;
                    }
                    let _e401 = phi_940_;
                    phi_943_ = (_e296 - (0f * _e401));
                } else {
                    phi_943_ = _e296;
                }
                let _e405 = phi_943_;
                let _e407 = p.member.map_size;
                let _e408 = f32(_e407);
                let _e411 = ((_e269 * _e408) - 0.5f);
                let _e412 = ((_e283 * _e408) - 0.5f);
                if (_e411 > -8388608f) {
                    let _e424 = f32(select(0i, select(select(i32(_e411), i32(-2147483648), (_e411 < bitcast<f32>(3472883712u))), 2147483647i, (_e411 > bitcast<f32>(1325400063u))), (_e411 == _e411)));
                    if (_e424 > _e411) {
                        phi_972_ = 1f;
                    } else {
                        phi_972_ = 0f;
                    }
                    let _e427 = phi_972_;
                    if (_e411 < 8388608f) {
                        phi_977_ = (_e424 - _e427);
                        phi_978_ = false;
                    } else {
                        phi_977_ = f32();
                        phi_978_ = true;
                    }
                    let _e430 = phi_977_;
                    let _e432 = phi_978_;
                    phi_979_ = _e430;
                    phi_980_ = _e432;
                } else {
                    phi_979_ = f32();
                    phi_980_ = true;
                }
                let _e434 = phi_979_;
                let _e436 = phi_980_;
                if _e436 {
                    phi_984_ = _e411;
                } else {
                    phi_984_ = _e434;
                }
                let _e438 = phi_984_;
                if (_e412 > -8388608f) {
                    let _e450 = f32(select(0i, select(select(i32(_e412), i32(-2147483648), (_e412 < bitcast<f32>(3472883712u))), 2147483647i, (_e412 > bitcast<f32>(1325400063u))), (_e412 == _e412)));
                    if (_e450 > _e412) {
                        phi_1004_ = 1f;
                    } else {
                        phi_1004_ = 0f;
                    }
                    let _e453 = phi_1004_;
                    if (_e412 < 8388608f) {
                        phi_1009_ = (_e450 - _e453);
                        phi_1010_ = false;
                    } else {
                        phi_1009_ = f32();
                        phi_1010_ = true;
                    }
                    let _e456 = phi_1009_;
                    let _e458 = phi_1010_;
                    phi_1011_ = _e456;
                    phi_1012_ = _e458;
                } else {
                    phi_1011_ = f32();
                    phi_1012_ = true;
                }
                let _e460 = phi_1011_;
                let _e462 = phi_1012_;
                if _e462 {
                    phi_1016_ = _e412;
                } else {
                    phi_1016_ = _e460;
                }
                let _e464 = phi_1016_;
                let _e465 = (_e411 - _e438);
                let _e466 = (_e412 - _e464);
                let _e475 = select(0i, select(select(i32(_e438), i32(-2147483648), (_e438 < bitcast<f32>(3472883712u))), 2147483647i, (_e438 > bitcast<f32>(1325400063u))), (_e438 == _e438));
                let _e484 = select(0i, select(select(i32(_e464), i32(-2147483648), (_e464 < bitcast<f32>(3472883712u))), 2147483647i, (_e464 > bitcast<f32>(1325400063u))), (_e464 == _e464));
                let _e487 = ((1f - _e465) * (1f - _e466));
                let _e489 = (_e465 * (1f - _e466));
                let _e491 = ((1f - _e465) * _e466);
                let _e492 = (_e465 * _e466);
                let _e494 = p.member.test;
                let _e495 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e494);
                let _e497 = p.member.map_size;
                local_1 = lt_math_Evsm(_e495.positive_exponent, _e495.negative_exponent, _e495.min_variance);
                let _e503 = ((0u * _e497) * _e497);
                let _e505 = (bitcast<i32>(_e497) - 1i);
                if (_e475 > 0i) {
                    phi_1068_ = _e475;
                } else {
                    phi_1068_ = 0i;
                }
                let _e508 = phi_1068_;
                if (_e484 > 0i) {
                    phi_1073_ = _e484;
                } else {
                    phi_1073_ = 0i;
                }
                let _e511 = phi_1073_;
                if (_e508 < _e505) {
                    phi_1078_ = _e508;
                } else {
                    phi_1078_ = _e505;
                }
                let _e514 = phi_1078_;
                if (_e511 < _e505) {
                    phi_1083_ = _e511;
                } else {
                    phi_1083_ = _e505;
                }
                let _e517 = phi_1083_;
                let _e518 = bitcast<u32>(_e514);
                let _e520 = (_e475 + 1i);
                let _e521 = (_e484 + 1i);
                if (_e520 > 0i) {
                    phi_1092_ = _e520;
                } else {
                    phi_1092_ = 0i;
                }
                let _e524 = phi_1092_;
                if (_e521 > 0i) {
                    phi_1097_ = _e521;
                } else {
                    phi_1097_ = 0i;
                }
                let _e527 = phi_1097_;
                if (_e524 < _e505) {
                    phi_1102_ = _e524;
                } else {
                    phi_1102_ = _e505;
                }
                let _e530 = phi_1102_;
                if (_e527 < _e505) {
                    phi_1107_ = _e527;
                } else {
                    phi_1107_ = _e505;
                }
                let _e533 = phi_1107_;
                let _e534 = bitcast<u32>(_e530);
                let _e536 = (bitcast<u32>(_e517) * _e497);
                let _e537 = (bitcast<u32>(_e533) * _e497);
                let _e542 = ((_e536 + _e518) + _e503);
                let _e543 = ((_e536 + _e534) + _e503);
                let _e544 = ((_e537 + _e518) + _e503);
                let _e545 = ((_e537 + _e534) + _e503);
                if (_e542 < _e62) {
                } else {
                    return;
                }
                let _e549 = map.member[(0u + _e542)];
                if (_e543 < _e62) {
                } else {
                    return;
                }
                let _e561 = map.member[(0u + _e543)];
                if (_e544 < _e62) {
                } else {
                    return;
                }
                let _e577 = map.member[(0u + _e544)];
                if (_e545 < _e62) {
                } else {
                    return;
                }
                let _e593 = map.member[(0u + _e545)];
                let _e607 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e549.x * _e487) + (_e561.x * _e489)) + (_e577.x * _e491)) + (_e593.x * _e492)), ((((_e549.y * _e487) + (_e561.y * _e489)) + (_e577.y * _e491)) + (_e593.y * _e492)), ((((_e549.z * _e487) + (_e561.z * _e489)) + (_e577.z * _e491)) + (_e593.z * _e492)), ((((_e549.w * _e487) + (_e561.w * _e489)) + (_e577.w * _e491)) + (_e593.w * _e492))), _e405);
                let _e611 = p.member.epsilon;
                if (_e607 <= _e611) {
                    phi_1204_ = true;
                } else {
                    phi_1204_ = (_e607 >= (1f - _e611));
                }
                let _e616 = phi_1204_;
                if ((bitcast<u32>(_e607) & 2147483647u) > 2139095040u) {
                    phi_1212_ = true;
                } else {
                    phi_1212_ = !(_e616);
                }
                let _e622 = phi_1212_;
                if _e622 {
                    if (_e607 > 0f) {
                        if (_e607 < 1f) {
                            phi_1224_ = false;
                        } else {
                            phi_1224_ = true;
                        }
                        let _e626 = phi_1224_;
                        phi_1225_ = _e626;
                    } else {
                        phi_1225_ = true;
                    }
                    let _e628 = phi_1225_;
                    if _e628 {
                        phi_1229_ = 0.5f;
                    } else {
                        phi_1229_ = _e607;
                    }
                    let _e630 = phi_1229_;
                    phi_1237_ = evaluate_Verdict(_e630, true);
                } else {
                    if (_e607 > 0.5f) {
                        phi_1235_ = 1f;
                    } else {
                        phi_1235_ = 0f;
                    }
                    let _e634 = phi_1235_;
                    phi_1237_ = evaluate_Verdict(_e634, false);
                }
                let _e637 = phi_1237_;
                let _e640 = (_e637.visibility < 0.5f);
                if _e637.is_doubted {
                    phi_1260_ = evaluate_Verdict();
                    phi_1261_ = true;
                } else {
                    if _e640 {
                        phi_1247_ = 2u;
                    } else {
                        phi_1247_ = 1u;
                    }
                    let _e642 = phi_1247_;
                    if ((0u & _e642) != 0u) {
                        if _e640 {
                            phi_1256_ = 0.000000059604645f;
                        } else {
                            phi_1256_ = 0.99999994f;
                        }
                        let _e646 = phi_1256_;
                        phi_1258_ = evaluate_Verdict(_e646, true);
                        phi_1259_ = false;
                    } else {
                        phi_1258_ = evaluate_Verdict();
                        phi_1259_ = true;
                    }
                    let _e649 = phi_1258_;
                    let _e651 = phi_1259_;
                    phi_1260_ = _e649;
                    phi_1261_ = _e651;
                }
                let _e653 = phi_1260_;
                let _e655 = phi_1261_;
                if _e655 {
                    phi_1266_ = evaluate_Verdict(_e637.visibility, _e637.is_doubted);
                } else {
                    phi_1266_ = _e653;
                }
                let _e658 = phi_1266_;
                phi_1271_ = evaluate_Verdict(_e658.visibility, _e658.is_doubted);
            } else {
                phi_1271_ = evaluate_Verdict(0.5f, true);
            }
            let _e664 = phi_1271_;
            phi_1272_ = _e664;
        }
        let _e666 = phi_1272_;
        visibility.member[_e70.first_primitive] = _e666.visibility;
        phi_1276_ = _e666.is_doubted;
        phi_1277_ = _e70.first_primitive;
    } else {
        phi_1276_ = false;
        phi_1277_ = 0u;
    }
    let _e671 = phi_1276_;
    let _e673 = phi_1277_;
    if (_e57 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e671 {
        let _e677 = atomicAdd((&shared_[0u]), 1u);
        phi_1288_ = _e677;
    } else {
        phi_1288_ = 0u;
    }
    let _e679 = phi_1288_;
    workgroupBarrier();
    if (_e57 == 0u) {
        let _e683 = atomicLoad((&shared_[0u]));
        let _e684 = atomicAdd((&list.member[3u]), _e683);
        atomicStore((&shared_[1u]), _e684);
    }
    workgroupBarrier();
    if _e671 {
        if false {
            phi_1305_ = (_e673 | 2147483648u);
        } else {
            phi_1305_ = _e673;
        }
        let _e688 = phi_1305_;
        let _e690 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e690) + _e679)]), _e688);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
