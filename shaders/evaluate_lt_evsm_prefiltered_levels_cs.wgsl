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

struct type_29 {
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
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_33 {
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

struct type_40 {
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
var<uniform> p: type_33;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_40;
@group(0) @binding(2) 
var<storage> map: type_29;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_161_: lt_bvh_traverse_Tree;
    var phi_162_: bool;
    var phi_163_: lt_bvh_traverse_Tree;
    var phi_164_: bool;
    var phi_169_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_161_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_162_ = false;
        } else {
            phi_161_ = lt_bvh_traverse_Tree();
            phi_162_ = true;
        }
        let _e65 = phi_161_;
        let _e67 = phi_162_;
        phi_163_ = _e65;
        phi_164_ = _e67;
    } else {
        phi_163_ = lt_bvh_traverse_Tree();
        phi_164_ = true;
    }
    let _e69 = phi_163_;
    let _e71 = phi_164_;
    if _e71 {
        phi_169_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_169_ = _e69;
    }
    let _e76 = phi_169_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_196_: f32;
    var phi_197_: f32;
    var phi_198_: f32;
    var phi_211_: bool;
    var phi_215_: f32;
    var phi_227_: f32;
    var phi_232_: f32;
    var phi_254_: f32;
    var phi_259_: f32;
    var phi_260_: bool;
    var phi_261_: f32;
    var phi_262_: bool;
    var phi_266_: f32;
    var phi_304_: f32;
    var phi_317_: bool;
    var phi_321_: f32;
    var phi_334_: f32;
    var phi_339_: f32;
    var phi_361_: f32;
    var phi_366_: f32;
    var phi_367_: bool;
    var phi_368_: f32;
    var phi_369_: bool;
    var phi_373_: f32;
    var phi_411_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_198_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_197_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_196_ = 1f;
            } else {
                phi_196_ = param_5;
            }
            let _e60 = phi_196_;
            phi_197_ = _e60;
        }
        let _e62 = phi_197_;
        phi_198_ = _e62;
    }
    let _e64 = phi_198_;
    let _e66 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_211_ = true;
    } else {
        let _e70 = (42f < _e66);
        if _e70 {
        }
        phi_211_ = _e70;
    }
    let _e72 = phi_211_;
    if _e72 {
        phi_215_ = 42f;
    } else {
        phi_215_ = _e66;
    }
    let _e74 = phi_215_;
    let _e75 = (_e74 * _e64);
    if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
        phi_304_ = _e75;
    } else {
        if (_e75 < -87f) {
            phi_227_ = -87f;
        } else {
            phi_227_ = _e75;
        }
        let _e81 = phi_227_;
        if (_e81 > 88f) {
            phi_232_ = 88f;
        } else {
            phi_232_ = _e81;
        }
        let _e84 = phi_232_;
        let _e86 = ((_e84 * 1.442695f) + 0.5f);
        if (_e86 > -8388608f) {
            let _e98 = f32(select(0i, select(select(i32(_e86), i32(-2147483648), (_e86 < bitcast<f32>(3472883712u))), 2147483647i, (_e86 > bitcast<f32>(1325400063u))), (_e86 == _e86)));
            if (_e98 > _e86) {
                phi_254_ = 1f;
            } else {
                phi_254_ = 0f;
            }
            let _e101 = phi_254_;
            if (_e86 < 8388608f) {
                phi_259_ = (_e98 - _e101);
                phi_260_ = false;
            } else {
                phi_259_ = f32();
                phi_260_ = true;
            }
            let _e104 = phi_259_;
            let _e106 = phi_260_;
            phi_261_ = _e104;
            phi_262_ = _e106;
        } else {
            phi_261_ = f32();
            phi_262_ = true;
        }
        let _e108 = phi_261_;
        let _e110 = phi_262_;
        if _e110 {
            phi_266_ = _e86;
        } else {
            phi_266_ = _e108;
        }
        let _e112 = phi_266_;
        let _e116 = ((_e84 - (_e112 * 0.69314575f)) - (_e112 * 0.0000014286068f));
        phi_304_ = ((((((((((((((((1f / 5040f) * _e116) + (1f / 720f)) * _e116) + (1f / 120f)) * _e116) + (1f / 24f)) * _e116) + (1f / 6f)) * _e116) + 0.5f) * _e116) + 1f) * _e116) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e112), i32(-2147483648), (_e112 < bitcast<f32>(3472883712u))), 2147483647i, (_e112 > bitcast<f32>(1325400063u))), (_e112 == _e112)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e152 = phi_304_;
    let _e154 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_317_ = true;
    } else {
        let _e158 = (42f < _e154);
        if _e158 {
        }
        phi_317_ = _e158;
    }
    let _e160 = phi_317_;
    if _e160 {
        phi_321_ = 42f;
    } else {
        phi_321_ = _e154;
    }
    let _e162 = phi_321_;
    let _e164 = (-(_e162) * _e64);
    if ((bitcast<u32>(_e164) & 2147483647u) > 2139095040u) {
        phi_411_ = _e164;
    } else {
        if (_e164 < -87f) {
            phi_334_ = -87f;
        } else {
            phi_334_ = _e164;
        }
        let _e170 = phi_334_;
        if (_e170 > 88f) {
            phi_339_ = 88f;
        } else {
            phi_339_ = _e170;
        }
        let _e173 = phi_339_;
        let _e175 = ((_e173 * 1.442695f) + 0.5f);
        if (_e175 > -8388608f) {
            let _e187 = f32(select(0i, select(select(i32(_e175), i32(-2147483648), (_e175 < bitcast<f32>(3472883712u))), 2147483647i, (_e175 > bitcast<f32>(1325400063u))), (_e175 == _e175)));
            if (_e187 > _e175) {
                phi_361_ = 1f;
            } else {
                phi_361_ = 0f;
            }
            let _e190 = phi_361_;
            if (_e175 < 8388608f) {
                phi_366_ = (_e187 - _e190);
                phi_367_ = false;
            } else {
                phi_366_ = f32();
                phi_367_ = true;
            }
            let _e193 = phi_366_;
            let _e195 = phi_367_;
            phi_368_ = _e193;
            phi_369_ = _e195;
        } else {
            phi_368_ = f32();
            phi_369_ = true;
        }
        let _e197 = phi_368_;
        let _e199 = phi_369_;
        if _e199 {
            phi_373_ = _e175;
        } else {
            phi_373_ = _e197;
        }
        let _e201 = phi_373_;
        let _e205 = ((_e173 - (_e201 * 0.69314575f)) - (_e201 * 0.0000014286068f));
        phi_411_ = ((((((((((((((((1f / 5040f) * _e205) + (1f / 720f)) * _e205) + (1f / 120f)) * _e205) + (1f / 24f)) * _e205) + (1f / 6f)) * _e205) + 0.5f) * _e205) + 1f) * _e205) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e201), i32(-2147483648), (_e201 < bitcast<f32>(3472883712u))), 2147483647i, (_e201 > bitcast<f32>(1325400063u))), (_e201 == _e201)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e241 = phi_411_;
    let _e242 = -(_e241);
    return vec4<f32>(_e152, (_e152 * _e152), _e242, (_e242 * _e242));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_433_: bool;
    var phi_437_: f32;
    var phi_461_: bool;
    var phi_465_: f32;
    var phi_477_: bool;
    var phi_484_: f32;
    var phi_497_: bool;
    var phi_501_: f32;
    var phi_525_: bool;
    var phi_529_: f32;
    var phi_541_: bool;
    var phi_548_: f32;
    var phi_559_: bool;
    var phi_563_: f32;
    var phi_578_: f32;
    var phi_579_: f32;
    var phi_580_: f32;

    let _e55 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e57 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_433_ = true;
    } else {
        let _e61 = (42f < _e57);
        if _e61 {
        }
        phi_433_ = _e61;
    }
    let _e63 = phi_433_;
    if _e63 {
        phi_437_ = 42f;
    } else {
        phi_437_ = _e57;
    }
    let _e65 = phi_437_;
    let _e67 = (*param_6).min_variance;
    let _e71 = (((_e67 * _e65) * _e65) * _e55.y);
    let _e78 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
        phi_461_ = true;
    } else {
        let _e82 = (_e71 > _e78);
        if _e82 {
        }
        phi_461_ = _e82;
    }
    let _e84 = phi_461_;
    if _e84 {
        phi_465_ = _e71;
    } else {
        phi_465_ = _e78;
    }
    let _e86 = phi_465_;
    let _e87 = (_e55.x - param_7.x);
    if (_e87 <= 0f) {
        let _e91 = ((bitcast<u32>(_e86) & 2147483647u) > 2139095040u);
        if _e91 {
        }
        phi_477_ = _e91;
    } else {
        phi_477_ = true;
    }
    let _e93 = phi_477_;
    if _e93 {
        phi_484_ = (_e86 / (_e86 + (_e87 * _e87)));
    } else {
        phi_484_ = 1f;
    }
    let _e98 = phi_484_;
    let _e100 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_497_ = true;
    } else {
        let _e104 = (42f < _e100);
        if _e104 {
        }
        phi_497_ = _e104;
    }
    let _e106 = phi_497_;
    if _e106 {
        phi_501_ = 42f;
    } else {
        phi_501_ = _e100;
    }
    let _e108 = phi_501_;
    let _e110 = (*param_6).min_variance;
    let _e114 = (((_e110 * _e108) * _e108) * _e55.w);
    let _e121 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
        phi_525_ = true;
    } else {
        let _e125 = (_e114 > _e121);
        if _e125 {
        }
        phi_525_ = _e125;
    }
    let _e127 = phi_525_;
    if _e127 {
        phi_529_ = _e114;
    } else {
        phi_529_ = _e121;
    }
    let _e129 = phi_529_;
    let _e130 = (_e55.z - param_7.z);
    if (_e130 <= 0f) {
        let _e134 = ((bitcast<u32>(_e129) & 2147483647u) > 2139095040u);
        if _e134 {
        }
        phi_541_ = _e134;
    } else {
        phi_541_ = true;
    }
    let _e136 = phi_541_;
    if _e136 {
        phi_548_ = (_e129 / (_e129 + (_e130 * _e130)));
    } else {
        phi_548_ = 1f;
    }
    let _e141 = phi_548_;
    if ((bitcast<u32>(_e141) & 2147483647u) > 2139095040u) {
        phi_559_ = true;
    } else {
        let _e145 = (_e141 < _e98);
        if _e145 {
        }
        phi_559_ = _e145;
    }
    let _e147 = phi_559_;
    if _e147 {
        phi_563_ = _e141;
    } else {
        phi_563_ = _e98;
    }
    let _e149 = phi_563_;
    if ((bitcast<u32>(_e149) & 2147483647u) > 2139095040u) {
        phi_580_ = _e149;
    } else {
        if (_e149 < 0f) {
            phi_579_ = 0f;
        } else {
            if (_e149 > 1f) {
                phi_578_ = 1f;
            } else {
                phi_578_ = _e149;
            }
            let _e156 = phi_578_;
            phi_579_ = _e156;
        }
        let _e158 = phi_579_;
        phi_580_ = _e158;
    }
    let _e160 = phi_580_;
    return _e160;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_643_: bool;
    var phi_644_: bool;
    var phi_648_: bool;
    var phi_692_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_696_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_716_: lt_math_LightPoint;
    var phi_719_: u32;
    var phi_721_: lt_math_LevelPoint;
    var phi_807_: bool;
    var phi_816_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_835_: bool;
    var phi_862_: bool;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_865_: bool;
    var phi_866_: bool;
    var phi_867_: bool;
    var phi_868_: bool;
    var phi_869_: bool;
    var phi_873_: bool;
    var phi_882_: lt_math_LightPoint;
    var phi_883_: u32;
    var phi_884_: lt_math_LevelPoint;
    var phi_885_: bool;
    var phi_717_: lt_math_LightPoint;
    var phi_720_: u32;
    var phi_722_: lt_math_LevelPoint;
    var phi_886_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_926_: bool;
    var phi_927_: bool;
    var phi_928_: bool;
    var phi_929_: bool;
    var phi_933_: bool;
    var phi_1015_: f32;
    var phi_1131_: f32;
    var phi_1132_: f32;
    var phi_1135_: f32;
    var phi_1164_: f32;
    var phi_1169_: f32;
    var phi_1170_: bool;
    var phi_1171_: f32;
    var phi_1172_: bool;
    var phi_1176_: f32;
    var phi_1196_: f32;
    var phi_1201_: f32;
    var phi_1202_: bool;
    var phi_1203_: f32;
    var phi_1204_: bool;
    var phi_1208_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1261_: i32;
    var phi_1266_: i32;
    var phi_1271_: i32;
    var phi_1276_: i32;
    var phi_1285_: i32;
    var phi_1290_: i32;
    var phi_1295_: i32;
    var phi_1300_: i32;
    var phi_1395_: bool;
    var phi_1403_: bool;
    var phi_1415_: bool;
    var phi_1416_: bool;
    var phi_1420_: f32;
    var phi_1426_: f32;
    var phi_1428_: evaluate_Verdict;
    var phi_1433_: evaluate_Verdict;
    var phi_1434_: evaluate_Verdict;

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
        let _e83 = p.member.light;
        let _e86 = samples.member[(0u + _e72.first_primitive)].normal[0u];
        let _e88 = global[0u];
        if (_e86 == _e88) {
            let _e91 = samples.member[(0u + _e72.first_primitive)].normal[1u];
            let _e93 = global[1u];
            if (_e91 == _e93) {
                let _e96 = samples.member[(0u + _e72.first_primitive)].normal[2u];
                let _e98 = global[2u];
                phi_641_ = (_e96 == _e98);
                phi_642_ = false;
            } else {
                phi_641_ = bool();
                phi_642_ = true;
            }
            let _e101 = phi_641_;
            let _e103 = phi_642_;
            phi_643_ = _e101;
            phi_644_ = _e103;
        } else {
            phi_643_ = bool();
            phi_644_ = true;
        }
        let _e105 = phi_643_;
        let _e107 = phi_644_;
        if _e107 {
            phi_648_ = false;
        } else {
            phi_648_ = _e105;
        }
        let _e109 = phi_648_;
        if !(_e109) {
            let _e112 = samples.member[(0u + _e72.first_primitive)].normal;
            let _e114 = samples.member[(0u + _e72.first_primitive)].position;
            if ((((_e112.x * (_e83.x - (_e114.x * _e83.w))) + (_e112.y * (_e83.y - (_e114.y * _e83.w)))) + (_e112.z * (_e83.z - (_e114.z * _e83.w)))) > 0f) {
                let _e138 = samples.member[(0u + _e72.first_primitive)].flags;
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e152 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e146.unnamed.visibility, false), _e146.unnamed_1);
                phi_692_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e152.unnamed, ((_e138 & 1u) == 0u));
            } else {
                let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e161.unnamed.visibility, false), _e161.unnamed_1);
                phi_692_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e167.unnamed, true);
            }
            let _e172 = phi_692_;
            phi_696_ = _e172;
        } else {
            let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e178.unnamed.visibility, false), _e178.unnamed_1);
            phi_696_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e184.unnamed, true);
        }
        let _e189 = phi_696_;
        if _e189.unnamed_1 {
            phi_1434_ = evaluate_Verdict(_e189.unnamed.visibility, _e189.unnamed.is_doubted);
        } else {
            let _e197 = samples.member[(0u + _e72.first_primitive)].position;
            let _e199 = p.member.map_size;
            let _e201 = (0.5f / f32(_e199));
            let _e208 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e215 = lt_math_LightPoint(vec2<f32>(_e208.uv.x, 0f), _e208.depth, _e208.is_inside);
            let _e219 = lt_math_LightPoint(_e215.uv, 0f, _e215.is_inside);
            phi_716_ = lt_math_LightPoint();
            phi_719_ = 0u;
            phi_721_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e219.uv, _e219.depth, false));
            loop {
                let _e226 = phi_716_;
                let _e228 = phi_719_;
                let _e230 = phi_721_;
                local_1 = _e230;
                local_2 = _e230;
                local_3 = _e230;
                if (_e228 < _e78) {
                    if _e230.point.is_inside {
                        phi_882_ = lt_math_LightPoint();
                        phi_883_ = u32();
                        phi_884_ = lt_math_LevelPoint();
                        phi_885_ = false;
                    } else {
                        if (_e228 < _e66) {
                        } else {
                            return;
                        }
                        let _e241 = levels.member[(0u + _e228)].row_w;
                        let _e252 = ((((_e241.x * _e197.x) + (_e241.y * _e197.y)) + (_e241.z * _e197.z)) + (_e241.w * 1f));
                        let _e254 = levels.member[(0u + _e228)].row_x;
                        let _e266 = (((((_e254.x * _e197.x) + (_e254.y * _e197.y)) + (_e254.z * _e197.z)) + (_e254.w * 1f)) / _e252);
                        let _e268 = levels.member[(0u + _e228)].row_y;
                        let _e280 = (((((_e268.x * _e197.x) + (_e268.y * _e197.y)) + (_e268.z * _e197.z)) + (_e268.w * 1f)) / _e252);
                        let _e282 = levels.member[(0u + _e228)].row_z;
                        let _e293 = ((((_e282.x * _e197.x) + (_e282.y * _e197.y)) + (_e282.z * _e197.z)) + (_e282.w * 1f));
                        if (_e252 > 0f) {
                            if (_e266 >= 0f) {
                                phi_807_ = (_e266 <= 1f);
                            } else {
                                phi_807_ = false;
                            }
                            let _e298 = phi_807_;
                            if _e298 {
                                if (_e280 >= 0f) {
                                    phi_816_ = (_e280 <= 1f);
                                } else {
                                    phi_816_ = false;
                                }
                                let _e302 = phi_816_;
                                if _e302 {
                                    if (_e293 >= 0f) {
                                        phi_825_ = (_e293 <= 1f);
                                    } else {
                                        phi_825_ = false;
                                    }
                                    let _e306 = phi_825_;
                                    phi_826_ = _e306;
                                    phi_827_ = false;
                                } else {
                                    phi_826_ = bool();
                                    phi_827_ = true;
                                }
                                let _e308 = phi_826_;
                                let _e310 = phi_827_;
                                phi_828_ = _e308;
                                phi_829_ = _e310;
                            } else {
                                phi_828_ = bool();
                                phi_829_ = true;
                            }
                            let _e312 = phi_828_;
                            let _e314 = phi_829_;
                            phi_830_ = _e312;
                            phi_831_ = _e314;
                        } else {
                            phi_830_ = bool();
                            phi_831_ = true;
                        }
                        let _e316 = phi_830_;
                        let _e318 = phi_831_;
                        if _e318 {
                            phi_835_ = false;
                        } else {
                            phi_835_ = _e316;
                        }
                        let _e320 = phi_835_;
                        if _e320 {
                            if (_e266 >= _e201) {
                                if (_e266 <= (1f - _e201)) {
                                    if (_e280 >= _e201) {
                                        phi_862_ = (_e280 <= (1f - _e201));
                                        phi_863_ = false;
                                    } else {
                                        phi_862_ = bool();
                                        phi_863_ = true;
                                    }
                                    let _e328 = phi_862_;
                                    let _e330 = phi_863_;
                                    phi_864_ = _e328;
                                    phi_865_ = _e330;
                                } else {
                                    phi_864_ = bool();
                                    phi_865_ = true;
                                }
                                let _e332 = phi_864_;
                                let _e334 = phi_865_;
                                phi_866_ = _e332;
                                phi_867_ = _e334;
                            } else {
                                phi_866_ = bool();
                                phi_867_ = true;
                            }
                            let _e336 = phi_866_;
                            let _e338 = phi_867_;
                            phi_868_ = _e336;
                            phi_869_ = _e338;
                        } else {
                            phi_868_ = bool();
                            phi_869_ = true;
                        }
                        let _e340 = phi_868_;
                        let _e342 = phi_869_;
                        if _e342 {
                            phi_873_ = false;
                        } else {
                            phi_873_ = _e340;
                        }
                        let _e344 = phi_873_;
                        let _e351 = lt_math_LightPoint(vec2<f32>(_e266, _e226.uv.y), _e226.depth, _e226.is_inside);
                        let _e358 = lt_math_LightPoint(vec2<f32>(_e351.uv.x, _e280), _e351.depth, _e351.is_inside);
                        let _e362 = lt_math_LightPoint(_e358.uv, _e293, _e358.is_inside);
                        let _e366 = lt_math_LightPoint(_e362.uv, _e362.depth, _e344);
                        phi_882_ = _e366;
                        phi_883_ = (_e228 + 1u);
                        phi_884_ = lt_math_LevelPoint(_e228, _e366);
                        phi_885_ = true;
                    }
                    let _e370 = phi_882_;
                    let _e372 = phi_883_;
                    let _e374 = phi_884_;
                    let _e376 = phi_885_;
                    phi_717_ = _e370;
                    phi_720_ = _e372;
                    phi_722_ = _e374;
                    phi_886_ = _e376;
                } else {
                    phi_717_ = lt_math_LightPoint();
                    phi_720_ = u32();
                    phi_722_ = lt_math_LevelPoint();
                    phi_886_ = false;
                }
                let _e378 = phi_717_;
                let _e380 = phi_720_;
                let _e382 = phi_722_;
                let _e384 = phi_886_;
                continue;
                continuing {
                    phi_716_ = _e378;
                    phi_719_ = _e380;
                    phi_721_ = _e382;
                    break if !(_e384);
                }
            }
            let _e387 = local_1;
            if _e387.point.is_inside {
                if (0f > 0f) {
                    let _e393 = local_2;
                    if (_e393.level < _e66) {
                    } else {
                        return;
                    }
                    let _e398 = levels.member[(0u + _e393.level)];
                    let _e404 = global[0u];
                    if (_e398.row_w.x == _e404) {
                        let _e407 = global[1u];
                        if (_e398.row_w.y == _e407) {
                            let _e410 = global[2u];
                            phi_926_ = (_e398.row_w.z == _e410);
                            phi_927_ = false;
                        } else {
                            phi_926_ = bool();
                            phi_927_ = true;
                        }
                        let _e413 = phi_926_;
                        let _e415 = phi_927_;
                        phi_928_ = _e413;
                        phi_929_ = _e415;
                    } else {
                        phi_928_ = bool();
                        phi_929_ = true;
                    }
                    let _e417 = phi_928_;
                    let _e419 = phi_929_;
                    if _e419 {
                        phi_933_ = false;
                    } else {
                        phi_933_ = _e417;
                    }
                    let _e421 = phi_933_;
                    if _e421 {
                        let _e423 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e425 = p.member.map_size;
                        let _e495 = ((abs(((((_e398.row_x.x * _e423.x) + (_e398.row_x.y * _e423.y)) + (_e398.row_x.z * _e423.z)) / (((_e398.row_x.x * _e398.row_x.x) + (_e398.row_x.y * _e398.row_x.y)) + (_e398.row_x.z * _e398.row_x.z)))) + abs(((((_e398.row_y.x * _e423.x) + (_e398.row_y.y * _e423.y)) + (_e398.row_y.z * _e423.z)) / (((_e398.row_y.x * _e398.row_y.x) + (_e398.row_y.y * _e398.row_y.y)) + (_e398.row_y.z * _e398.row_y.z))))) / (abs(((((_e398.row_z.x * _e423.x) + (_e398.row_z.y * _e423.y)) + (_e398.row_z.z * _e423.z)) / (((_e398.row_z.x * _e398.row_z.x) + (_e398.row_z.y * _e398.row_z.y)) + (_e398.row_z.z * _e398.row_z.z)))) * f32(_e425)));
                        if (_e495 < 0.002f) {
                            phi_1015_ = _e495;
                        } else {
                            phi_1015_ = 0.002f;
                        }
                        let _e498 = phi_1015_;
                        phi_1132_ = _e498;
                    } else {
                        let _e500 = p.member.map_size;
                        let _e506 = samples.member[(0u + _e72.first_primitive)].position;
                        let _e517 = ((((_e398.row_w.x * _e506.x) + (_e398.row_w.y * _e506.y)) + (_e398.row_w.z * _e506.z)) + _e398.row_w.w);
                        let _e530 = ((_e398.row_x.x - (_e398.row_w.x * _e387.point.uv.x)) / _e517);
                        let _e531 = ((_e398.row_x.y - (_e398.row_w.y * _e387.point.uv.x)) / _e517);
                        let _e532 = ((_e398.row_x.z - (_e398.row_w.z * _e387.point.uv.x)) / _e517);
                        let _e545 = ((_e398.row_y.x - (_e398.row_w.x * _e387.point.uv.y)) / _e517);
                        let _e546 = ((_e398.row_y.y - (_e398.row_w.y * _e387.point.uv.y)) / _e517);
                        let _e547 = ((_e398.row_y.z - (_e398.row_w.z * _e387.point.uv.y)) / _e517);
                        let _e553 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e558 = ((_e546 * _e553.z) - (_e553.y * _e547));
                        let _e563 = ((_e547 * _e553.x) - (_e553.z * _e545));
                        let _e568 = ((_e545 * _e553.y) - (_e553.x * _e546));
                        let _e570 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e575 = ((_e531 * _e570.z) - (_e570.y * _e532));
                        let _e580 = ((_e532 * _e570.x) - (_e570.z * _e530));
                        let _e585 = ((_e530 * _e570.y) - (_e570.x * _e531));
                        let _e612 = ((abs(((((_e398.row_z.x * _e558) + (_e398.row_z.y * _e563)) + (_e398.row_z.z * _e568)) / (((_e530 * _e558) + (_e531 * _e563)) + (_e532 * _e568)))) + abs(((((_e398.row_z.x * _e575) + (_e398.row_z.y * _e580)) + (_e398.row_z.z * _e585)) / (((_e545 * _e575) + (_e546 * _e580)) + (_e547 * _e585))))) / f32(_e500));
                        if (_e612 < 0.002f) {
                            phi_1131_ = _e612;
                        } else {
                            phi_1131_ = 0.002f;
                        }
                        let _e615 = phi_1131_;
                        phi_1132_ = _e615;
                    }
                    let _e617 = phi_1132_;
                    phi_1135_ = (_e387.point.depth - (0f * _e617));
                } else {
                    phi_1135_ = _e387.point.depth;
                }
                let _e621 = phi_1135_;
                let _e627 = p.member.map_size;
                let _e628 = f32(_e627);
                let _e631 = ((_e387.point.uv.x * _e628) - 0.5f);
                let _e632 = ((_e387.point.uv.y * _e628) - 0.5f);
                if (_e631 > -8388608f) {
                    let _e644 = f32(select(0i, select(select(i32(_e631), i32(-2147483648), (_e631 < bitcast<f32>(3472883712u))), 2147483647i, (_e631 > bitcast<f32>(1325400063u))), (_e631 == _e631)));
                    if (_e644 > _e631) {
                        phi_1164_ = 1f;
                    } else {
                        phi_1164_ = 0f;
                    }
                    let _e647 = phi_1164_;
                    if (_e631 < 8388608f) {
                        phi_1169_ = (_e644 - _e647);
                        phi_1170_ = false;
                    } else {
                        phi_1169_ = f32();
                        phi_1170_ = true;
                    }
                    let _e650 = phi_1169_;
                    let _e652 = phi_1170_;
                    phi_1171_ = _e650;
                    phi_1172_ = _e652;
                } else {
                    phi_1171_ = f32();
                    phi_1172_ = true;
                }
                let _e654 = phi_1171_;
                let _e656 = phi_1172_;
                if _e656 {
                    phi_1176_ = _e631;
                } else {
                    phi_1176_ = _e654;
                }
                let _e658 = phi_1176_;
                if (_e632 > -8388608f) {
                    let _e670 = f32(select(0i, select(select(i32(_e632), i32(-2147483648), (_e632 < bitcast<f32>(3472883712u))), 2147483647i, (_e632 > bitcast<f32>(1325400063u))), (_e632 == _e632)));
                    if (_e670 > _e632) {
                        phi_1196_ = 1f;
                    } else {
                        phi_1196_ = 0f;
                    }
                    let _e673 = phi_1196_;
                    if (_e632 < 8388608f) {
                        phi_1201_ = (_e670 - _e673);
                        phi_1202_ = false;
                    } else {
                        phi_1201_ = f32();
                        phi_1202_ = true;
                    }
                    let _e676 = phi_1201_;
                    let _e678 = phi_1202_;
                    phi_1203_ = _e676;
                    phi_1204_ = _e678;
                } else {
                    phi_1203_ = f32();
                    phi_1204_ = true;
                }
                let _e680 = phi_1203_;
                let _e682 = phi_1204_;
                if _e682 {
                    phi_1208_ = _e632;
                } else {
                    phi_1208_ = _e680;
                }
                let _e684 = phi_1208_;
                let _e685 = (_e631 - _e658);
                let _e686 = (_e632 - _e684);
                let _e695 = select(0i, select(select(i32(_e658), i32(-2147483648), (_e658 < bitcast<f32>(3472883712u))), 2147483647i, (_e658 > bitcast<f32>(1325400063u))), (_e658 == _e658));
                let _e704 = select(0i, select(select(i32(_e684), i32(-2147483648), (_e684 < bitcast<f32>(3472883712u))), 2147483647i, (_e684 > bitcast<f32>(1325400063u))), (_e684 == _e684));
                let _e707 = ((1f - _e685) * (1f - _e686));
                let _e709 = (_e685 * (1f - _e686));
                let _e711 = ((1f - _e685) * _e686);
                let _e712 = (_e685 * _e686);
                let _e714 = p.member.test;
                let _e715 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e714);
                let _e717 = p.member.map_size;
                let _e719 = local_3;
                local = lt_math_Evsm(_e715.positive_exponent, _e715.negative_exponent, _e715.min_variance);
                let _e726 = ((_e719.level * _e717) * _e717);
                let _e728 = (bitcast<i32>(_e717) - 1i);
                if (_e695 > 0i) {
                    phi_1261_ = _e695;
                } else {
                    phi_1261_ = 0i;
                }
                let _e731 = phi_1261_;
                if (_e704 > 0i) {
                    phi_1266_ = _e704;
                } else {
                    phi_1266_ = 0i;
                }
                let _e734 = phi_1266_;
                if (_e731 < _e728) {
                    phi_1271_ = _e731;
                } else {
                    phi_1271_ = _e728;
                }
                let _e737 = phi_1271_;
                if (_e734 < _e728) {
                    phi_1276_ = _e734;
                } else {
                    phi_1276_ = _e728;
                }
                let _e740 = phi_1276_;
                let _e741 = bitcast<u32>(_e737);
                let _e743 = (_e695 + 1i);
                let _e744 = (_e704 + 1i);
                if (_e743 > 0i) {
                    phi_1285_ = _e743;
                } else {
                    phi_1285_ = 0i;
                }
                let _e747 = phi_1285_;
                if (_e744 > 0i) {
                    phi_1290_ = _e744;
                } else {
                    phi_1290_ = 0i;
                }
                let _e750 = phi_1290_;
                if (_e747 < _e728) {
                    phi_1295_ = _e747;
                } else {
                    phi_1295_ = _e728;
                }
                let _e753 = phi_1295_;
                if (_e750 < _e728) {
                    phi_1300_ = _e750;
                } else {
                    phi_1300_ = _e728;
                }
                let _e756 = phi_1300_;
                let _e757 = bitcast<u32>(_e753);
                let _e759 = (bitcast<u32>(_e740) * _e717);
                let _e760 = (bitcast<u32>(_e756) * _e717);
                let _e765 = ((_e759 + _e741) + _e726);
                let _e766 = ((_e759 + _e757) + _e726);
                let _e767 = ((_e760 + _e741) + _e726);
                let _e768 = ((_e760 + _e757) + _e726);
                if (_e765 < _e60) {
                } else {
                    return;
                }
                let _e772 = map.member[(0u + _e765)];
                if (_e766 < _e60) {
                } else {
                    return;
                }
                let _e784 = map.member[(0u + _e766)];
                if (_e767 < _e60) {
                } else {
                    return;
                }
                let _e800 = map.member[(0u + _e767)];
                if (_e768 < _e60) {
                } else {
                    return;
                }
                let _e816 = map.member[(0u + _e768)];
                let _e830 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e772.x * _e707) + (_e784.x * _e709)) + (_e800.x * _e711)) + (_e816.x * _e712)), ((((_e772.y * _e707) + (_e784.y * _e709)) + (_e800.y * _e711)) + (_e816.y * _e712)), ((((_e772.z * _e707) + (_e784.z * _e709)) + (_e800.z * _e711)) + (_e816.z * _e712)), ((((_e772.w * _e707) + (_e784.w * _e709)) + (_e800.w * _e711)) + (_e816.w * _e712))), _e621);
                let _e832 = p.member.epsilon;
                if (_e830 <= _e832) {
                    phi_1395_ = true;
                } else {
                    phi_1395_ = (_e830 >= (1f - _e832));
                }
                let _e837 = phi_1395_;
                if ((bitcast<u32>(_e830) & 2147483647u) > 2139095040u) {
                    phi_1403_ = true;
                } else {
                    phi_1403_ = !(_e837);
                }
                let _e843 = phi_1403_;
                if _e843 {
                    if (_e830 > 0f) {
                        if (_e830 < 1f) {
                            phi_1415_ = false;
                        } else {
                            phi_1415_ = true;
                        }
                        let _e847 = phi_1415_;
                        phi_1416_ = _e847;
                    } else {
                        phi_1416_ = true;
                    }
                    let _e849 = phi_1416_;
                    if _e849 {
                        phi_1420_ = 0.5f;
                    } else {
                        phi_1420_ = _e830;
                    }
                    let _e851 = phi_1420_;
                    phi_1428_ = evaluate_Verdict(_e851, true);
                } else {
                    if (_e830 > 0.5f) {
                        phi_1426_ = 1f;
                    } else {
                        phi_1426_ = 0f;
                    }
                    let _e855 = phi_1426_;
                    phi_1428_ = evaluate_Verdict(_e855, false);
                }
                let _e858 = phi_1428_;
                phi_1433_ = evaluate_Verdict(_e858.visibility, _e858.is_doubted);
            } else {
                phi_1433_ = evaluate_Verdict(0.5f, true);
            }
            let _e864 = phi_1433_;
            phi_1434_ = _e864;
        }
        let _e866 = phi_1434_;
        if (_e72.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e72.first_primitive)] = _e866.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
