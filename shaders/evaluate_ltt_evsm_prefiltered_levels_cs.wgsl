struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_10 {
    member: array<abi_Sample>,
}

struct type_14 {
    member: array<u32>,
}

struct type_18 {
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

struct type_37 {
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

struct type_41 {
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

struct type_48 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct type_54 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_5: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_41;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_54;
@group(0) @binding(5) 
var<storage> levels: type_48;
@group(0) @binding(2) 
var<storage> map: type_37;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_177_: lt_bvh_traverse_Tree;
    var phi_178_: bool;
    var phi_179_: lt_bvh_traverse_Tree;
    var phi_180_: bool;
    var phi_185_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_177_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_178_ = false;
        } else {
            phi_177_ = lt_bvh_traverse_Tree();
            phi_178_ = true;
        }
        let _e69 = phi_177_;
        let _e71 = phi_178_;
        phi_179_ = _e69;
        phi_180_ = _e71;
    } else {
        phi_179_ = lt_bvh_traverse_Tree();
        phi_180_ = true;
    }
    let _e73 = phi_179_;
    let _e75 = phi_180_;
    if _e75 {
        phi_185_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_185_ = _e73;
    }
    let _e80 = phi_185_;
    return lt_bvh_traverse_Tree(_e80.root, _e80.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_212_: f32;
    var phi_213_: f32;
    var phi_214_: f32;
    var phi_227_: bool;
    var phi_231_: f32;
    var phi_243_: f32;
    var phi_248_: f32;
    var phi_270_: f32;
    var phi_275_: f32;
    var phi_276_: bool;
    var phi_277_: f32;
    var phi_278_: bool;
    var phi_282_: f32;
    var phi_320_: f32;
    var phi_333_: bool;
    var phi_337_: f32;
    var phi_350_: f32;
    var phi_355_: f32;
    var phi_377_: f32;
    var phi_382_: f32;
    var phi_383_: bool;
    var phi_384_: f32;
    var phi_385_: bool;
    var phi_389_: f32;
    var phi_427_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_214_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_213_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_212_ = 1f;
            } else {
                phi_212_ = param_5;
            }
            let _e64 = phi_212_;
            phi_213_ = _e64;
        }
        let _e66 = phi_213_;
        phi_214_ = _e66;
    }
    let _e68 = phi_214_;
    let _e70 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_227_ = true;
    } else {
        let _e74 = (42f < _e70);
        if _e74 {
        }
        phi_227_ = _e74;
    }
    let _e76 = phi_227_;
    if _e76 {
        phi_231_ = 42f;
    } else {
        phi_231_ = _e70;
    }
    let _e78 = phi_231_;
    let _e79 = (_e78 * _e68);
    if ((bitcast<u32>(_e79) & 2147483647u) > 2139095040u) {
        phi_320_ = _e79;
    } else {
        if (_e79 < -87f) {
            phi_243_ = -87f;
        } else {
            phi_243_ = _e79;
        }
        let _e85 = phi_243_;
        if (_e85 > 88f) {
            phi_248_ = 88f;
        } else {
            phi_248_ = _e85;
        }
        let _e88 = phi_248_;
        let _e90 = ((_e88 * 1.442695f) + 0.5f);
        if (_e90 > -8388608f) {
            let _e102 = f32(select(0i, select(select(i32(_e90), i32(-2147483648), (_e90 < bitcast<f32>(3472883712u))), 2147483647i, (_e90 > bitcast<f32>(1325400063u))), (_e90 == _e90)));
            if (_e102 > _e90) {
                phi_270_ = 1f;
            } else {
                phi_270_ = 0f;
            }
            let _e105 = phi_270_;
            if (_e90 < 8388608f) {
                phi_275_ = (_e102 - _e105);
                phi_276_ = false;
            } else {
                phi_275_ = f32();
                phi_276_ = true;
            }
            let _e108 = phi_275_;
            let _e110 = phi_276_;
            phi_277_ = _e108;
            phi_278_ = _e110;
        } else {
            phi_277_ = f32();
            phi_278_ = true;
        }
        let _e112 = phi_277_;
        let _e114 = phi_278_;
        if _e114 {
            phi_282_ = _e90;
        } else {
            phi_282_ = _e112;
        }
        let _e116 = phi_282_;
        let _e120 = ((_e88 - (_e116 * 0.69314575f)) - (_e116 * 0.0000014286068f));
        phi_320_ = ((((((((((((((((1f / 5040f) * _e120) + (1f / 720f)) * _e120) + (1f / 120f)) * _e120) + (1f / 24f)) * _e120) + (1f / 6f)) * _e120) + 0.5f) * _e120) + 1f) * _e120) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e156 = phi_320_;
    let _e158 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_333_ = true;
    } else {
        let _e162 = (42f < _e158);
        if _e162 {
        }
        phi_333_ = _e162;
    }
    let _e164 = phi_333_;
    if _e164 {
        phi_337_ = 42f;
    } else {
        phi_337_ = _e158;
    }
    let _e166 = phi_337_;
    let _e168 = (-(_e166) * _e68);
    if ((bitcast<u32>(_e168) & 2147483647u) > 2139095040u) {
        phi_427_ = _e168;
    } else {
        if (_e168 < -87f) {
            phi_350_ = -87f;
        } else {
            phi_350_ = _e168;
        }
        let _e174 = phi_350_;
        if (_e174 > 88f) {
            phi_355_ = 88f;
        } else {
            phi_355_ = _e174;
        }
        let _e177 = phi_355_;
        let _e179 = ((_e177 * 1.442695f) + 0.5f);
        if (_e179 > -8388608f) {
            let _e191 = f32(select(0i, select(select(i32(_e179), i32(-2147483648), (_e179 < bitcast<f32>(3472883712u))), 2147483647i, (_e179 > bitcast<f32>(1325400063u))), (_e179 == _e179)));
            if (_e191 > _e179) {
                phi_377_ = 1f;
            } else {
                phi_377_ = 0f;
            }
            let _e194 = phi_377_;
            if (_e179 < 8388608f) {
                phi_382_ = (_e191 - _e194);
                phi_383_ = false;
            } else {
                phi_382_ = f32();
                phi_383_ = true;
            }
            let _e197 = phi_382_;
            let _e199 = phi_383_;
            phi_384_ = _e197;
            phi_385_ = _e199;
        } else {
            phi_384_ = f32();
            phi_385_ = true;
        }
        let _e201 = phi_384_;
        let _e203 = phi_385_;
        if _e203 {
            phi_389_ = _e179;
        } else {
            phi_389_ = _e201;
        }
        let _e205 = phi_389_;
        let _e209 = ((_e177 - (_e205 * 0.69314575f)) - (_e205 * 0.0000014286068f));
        phi_427_ = ((((((((((((((((1f / 5040f) * _e209) + (1f / 720f)) * _e209) + (1f / 120f)) * _e209) + (1f / 24f)) * _e209) + (1f / 6f)) * _e209) + 0.5f) * _e209) + 1f) * _e209) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e205), i32(-2147483648), (_e205 < bitcast<f32>(3472883712u))), 2147483647i, (_e205 > bitcast<f32>(1325400063u))), (_e205 == _e205)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e245 = phi_427_;
    let _e246 = -(_e245);
    return vec4<f32>(_e156, (_e156 * _e156), _e246, (_e246 * _e246));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_449_: bool;
    var phi_453_: f32;
    var phi_477_: bool;
    var phi_481_: f32;
    var phi_493_: bool;
    var phi_500_: f32;
    var phi_513_: bool;
    var phi_517_: f32;
    var phi_541_: bool;
    var phi_545_: f32;
    var phi_557_: bool;
    var phi_564_: f32;
    var phi_575_: bool;
    var phi_579_: f32;
    var phi_594_: f32;
    var phi_595_: f32;
    var phi_596_: f32;

    let _e59 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e61 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_449_ = true;
    } else {
        let _e65 = (42f < _e61);
        if _e65 {
        }
        phi_449_ = _e65;
    }
    let _e67 = phi_449_;
    if _e67 {
        phi_453_ = 42f;
    } else {
        phi_453_ = _e61;
    }
    let _e69 = phi_453_;
    let _e71 = (*param_6).min_variance;
    let _e75 = (((_e71 * _e69) * _e69) * _e59.y);
    let _e82 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
        phi_477_ = true;
    } else {
        let _e86 = (_e75 > _e82);
        if _e86 {
        }
        phi_477_ = _e86;
    }
    let _e88 = phi_477_;
    if _e88 {
        phi_481_ = _e75;
    } else {
        phi_481_ = _e82;
    }
    let _e90 = phi_481_;
    let _e91 = (_e59.x - param_7.x);
    if (_e91 <= 0f) {
        let _e95 = ((bitcast<u32>(_e90) & 2147483647u) > 2139095040u);
        if _e95 {
        }
        phi_493_ = _e95;
    } else {
        phi_493_ = true;
    }
    let _e97 = phi_493_;
    if _e97 {
        phi_500_ = (_e90 / (_e90 + (_e91 * _e91)));
    } else {
        phi_500_ = 1f;
    }
    let _e102 = phi_500_;
    let _e104 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_513_ = true;
    } else {
        let _e108 = (42f < _e104);
        if _e108 {
        }
        phi_513_ = _e108;
    }
    let _e110 = phi_513_;
    if _e110 {
        phi_517_ = 42f;
    } else {
        phi_517_ = _e104;
    }
    let _e112 = phi_517_;
    let _e114 = (*param_6).min_variance;
    let _e118 = (((_e114 * _e112) * _e112) * _e59.w);
    let _e125 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e118) & 2147483647u) > 2139095040u) {
        phi_541_ = true;
    } else {
        let _e129 = (_e118 > _e125);
        if _e129 {
        }
        phi_541_ = _e129;
    }
    let _e131 = phi_541_;
    if _e131 {
        phi_545_ = _e118;
    } else {
        phi_545_ = _e125;
    }
    let _e133 = phi_545_;
    let _e134 = (_e59.z - param_7.z);
    if (_e134 <= 0f) {
        let _e138 = ((bitcast<u32>(_e133) & 2147483647u) > 2139095040u);
        if _e138 {
        }
        phi_557_ = _e138;
    } else {
        phi_557_ = true;
    }
    let _e140 = phi_557_;
    if _e140 {
        phi_564_ = (_e133 / (_e133 + (_e134 * _e134)));
    } else {
        phi_564_ = 1f;
    }
    let _e145 = phi_564_;
    if ((bitcast<u32>(_e145) & 2147483647u) > 2139095040u) {
        phi_575_ = true;
    } else {
        let _e149 = (_e145 < _e102);
        if _e149 {
        }
        phi_575_ = _e149;
    }
    let _e151 = phi_575_;
    if _e151 {
        phi_579_ = _e145;
    } else {
        phi_579_ = _e102;
    }
    let _e153 = phi_579_;
    if ((bitcast<u32>(_e153) & 2147483647u) > 2139095040u) {
        phi_596_ = _e153;
    } else {
        if (_e153 < 0f) {
            phi_595_ = 0f;
        } else {
            if (_e153 > 1f) {
                phi_594_ = 1f;
            } else {
                phi_594_ = _e153;
            }
            let _e160 = phi_594_;
            phi_595_ = _e160;
        }
        let _e162 = phi_595_;
        phi_596_ = _e162;
    }
    let _e164 = phi_596_;
    return _e164;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_655_: bool;
    var phi_659_: bool;
    var phi_703_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_707_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_727_: lt_math_LightPoint;
    var phi_730_: u32;
    var phi_732_: lt_math_LevelPoint;
    var phi_818_: bool;
    var phi_827_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_841_: bool;
    var phi_842_: bool;
    var phi_846_: bool;
    var phi_873_: bool;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_876_: bool;
    var phi_877_: bool;
    var phi_878_: bool;
    var phi_879_: bool;
    var phi_880_: bool;
    var phi_884_: bool;
    var phi_893_: lt_math_LightPoint;
    var phi_894_: u32;
    var phi_895_: lt_math_LevelPoint;
    var phi_896_: bool;
    var phi_728_: lt_math_LightPoint;
    var phi_731_: u32;
    var phi_733_: lt_math_LevelPoint;
    var phi_897_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_937_: bool;
    var phi_938_: bool;
    var phi_939_: bool;
    var phi_940_: bool;
    var phi_944_: bool;
    var phi_1026_: f32;
    var phi_1142_: f32;
    var phi_1143_: f32;
    var phi_1146_: f32;
    var phi_1175_: f32;
    var phi_1180_: f32;
    var phi_1181_: bool;
    var phi_1182_: f32;
    var phi_1183_: bool;
    var phi_1187_: f32;
    var phi_1207_: f32;
    var phi_1212_: f32;
    var phi_1213_: bool;
    var phi_1214_: f32;
    var phi_1215_: bool;
    var phi_1219_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1272_: i32;
    var phi_1277_: i32;
    var phi_1282_: i32;
    var phi_1287_: i32;
    var phi_1296_: i32;
    var phi_1301_: i32;
    var phi_1306_: i32;
    var phi_1311_: i32;
    var phi_1406_: bool;
    var phi_1414_: bool;
    var phi_1426_: bool;
    var phi_1427_: bool;
    var phi_1431_: f32;
    var phi_1437_: f32;
    var phi_1439_: evaluate_Verdict;
    var phi_1444_: evaluate_Verdict;
    var phi_1445_: evaluate_Verdict;
    var phi_1449_: bool;
    var phi_1450_: u32;
    var phi_1461_: u32;

    let _e57 = id_1;
    let _e58 = local_5;
    let _e63 = arrayLength((&map.member));
    let _e68 = arrayLength((&levels.member));
    let _e71 = p.member.size[0u];
    let _e73 = p.member.size[1u];
    let _e74 = lt_shaders_entry_pixel_index(_e57, _e71, _e73);
    if (bitcast<i32>(_e74.root) != 0i) {
        let _e81 = p.member.level_count;
        let _e83 = p.member.light;
        let _e86 = samples.member[_e74.first_primitive].normal[0u];
        let _e88 = global[0u];
        if (_e86 == _e88) {
            let _e91 = samples.member[_e74.first_primitive].normal[1u];
            let _e93 = global[1u];
            if (_e91 == _e93) {
                let _e96 = samples.member[_e74.first_primitive].normal[2u];
                let _e98 = global[2u];
                phi_652_ = (_e96 == _e98);
                phi_653_ = false;
            } else {
                phi_652_ = bool();
                phi_653_ = true;
            }
            let _e101 = phi_652_;
            let _e103 = phi_653_;
            phi_654_ = _e101;
            phi_655_ = _e103;
        } else {
            phi_654_ = bool();
            phi_655_ = true;
        }
        let _e105 = phi_654_;
        let _e107 = phi_655_;
        if _e107 {
            phi_659_ = false;
        } else {
            phi_659_ = _e105;
        }
        let _e109 = phi_659_;
        if !(_e109) {
            let _e112 = samples.member[_e74.first_primitive].normal;
            let _e114 = samples.member[_e74.first_primitive].position;
            if ((((_e112.x * (_e83.x - (_e114.x * _e83.w))) + (_e112.y * (_e83.y - (_e114.y * _e83.w)))) + (_e112.z * (_e83.z - (_e114.z * _e83.w)))) > 0f) {
                let _e138 = samples.member[_e74.first_primitive].flags;
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e152 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e146.unnamed.visibility, false), _e146.unnamed_1);
                phi_703_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e152.unnamed, ((_e138 & 1u) == 0u));
            } else {
                let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e161.unnamed.visibility, false), _e161.unnamed_1);
                phi_703_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e167.unnamed, true);
            }
            let _e172 = phi_703_;
            phi_707_ = _e172;
        } else {
            let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e178.unnamed.visibility, false), _e178.unnamed_1);
            phi_707_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e184.unnamed, true);
        }
        let _e189 = phi_707_;
        if _e189.unnamed_1 {
            phi_1445_ = evaluate_Verdict(_e189.unnamed.visibility, _e189.unnamed.is_doubted);
        } else {
            let _e197 = samples.member[_e74.first_primitive].position;
            let _e199 = p.member.map_size;
            let _e201 = (0.5f / f32(_e199));
            let _e208 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e215 = lt_math_LightPoint(vec2<f32>(_e208.uv.x, 0f), _e208.depth, _e208.is_inside);
            let _e219 = lt_math_LightPoint(_e215.uv, 0f, _e215.is_inside);
            phi_727_ = lt_math_LightPoint();
            phi_730_ = 0u;
            phi_732_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e219.uv, _e219.depth, false));
            loop {
                let _e226 = phi_727_;
                let _e228 = phi_730_;
                let _e230 = phi_732_;
                local_2 = _e230;
                local_3 = _e230;
                local_4 = _e230;
                if (_e228 < _e81) {
                    if _e230.point.is_inside {
                        phi_893_ = lt_math_LightPoint();
                        phi_894_ = u32();
                        phi_895_ = lt_math_LevelPoint();
                        phi_896_ = false;
                    } else {
                        if (_e228 < _e68) {
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
                                phi_818_ = (_e266 <= 1f);
                            } else {
                                phi_818_ = false;
                            }
                            let _e298 = phi_818_;
                            if _e298 {
                                if (_e280 >= 0f) {
                                    phi_827_ = (_e280 <= 1f);
                                } else {
                                    phi_827_ = false;
                                }
                                let _e302 = phi_827_;
                                if _e302 {
                                    if (_e293 >= 0f) {
                                        phi_836_ = (_e293 <= 1f);
                                    } else {
                                        phi_836_ = false;
                                    }
                                    let _e306 = phi_836_;
                                    phi_837_ = _e306;
                                    phi_838_ = false;
                                } else {
                                    phi_837_ = bool();
                                    phi_838_ = true;
                                }
                                let _e308 = phi_837_;
                                let _e310 = phi_838_;
                                phi_839_ = _e308;
                                phi_840_ = _e310;
                            } else {
                                phi_839_ = bool();
                                phi_840_ = true;
                            }
                            let _e312 = phi_839_;
                            let _e314 = phi_840_;
                            phi_841_ = _e312;
                            phi_842_ = _e314;
                        } else {
                            phi_841_ = bool();
                            phi_842_ = true;
                        }
                        let _e316 = phi_841_;
                        let _e318 = phi_842_;
                        if _e318 {
                            phi_846_ = false;
                        } else {
                            phi_846_ = _e316;
                        }
                        let _e320 = phi_846_;
                        if _e320 {
                            if (_e266 >= _e201) {
                                if (_e266 <= (1f - _e201)) {
                                    if (_e280 >= _e201) {
                                        phi_873_ = (_e280 <= (1f - _e201));
                                        phi_874_ = false;
                                    } else {
                                        phi_873_ = bool();
                                        phi_874_ = true;
                                    }
                                    let _e328 = phi_873_;
                                    let _e330 = phi_874_;
                                    phi_875_ = _e328;
                                    phi_876_ = _e330;
                                } else {
                                    phi_875_ = bool();
                                    phi_876_ = true;
                                }
                                let _e332 = phi_875_;
                                let _e334 = phi_876_;
                                phi_877_ = _e332;
                                phi_878_ = _e334;
                            } else {
                                phi_877_ = bool();
                                phi_878_ = true;
                            }
                            let _e336 = phi_877_;
                            let _e338 = phi_878_;
                            phi_879_ = _e336;
                            phi_880_ = _e338;
                        } else {
                            phi_879_ = bool();
                            phi_880_ = true;
                        }
                        let _e340 = phi_879_;
                        let _e342 = phi_880_;
                        if _e342 {
                            phi_884_ = false;
                        } else {
                            phi_884_ = _e340;
                        }
                        let _e344 = phi_884_;
                        let _e351 = lt_math_LightPoint(vec2<f32>(_e266, _e226.uv.y), _e226.depth, _e226.is_inside);
                        let _e358 = lt_math_LightPoint(vec2<f32>(_e351.uv.x, _e280), _e351.depth, _e351.is_inside);
                        let _e362 = lt_math_LightPoint(_e358.uv, _e293, _e358.is_inside);
                        let _e366 = lt_math_LightPoint(_e362.uv, _e362.depth, _e344);
                        phi_893_ = _e366;
                        phi_894_ = (_e228 + 1u);
                        phi_895_ = lt_math_LevelPoint(_e228, _e366);
                        phi_896_ = true;
                    }
                    let _e370 = phi_893_;
                    let _e372 = phi_894_;
                    let _e374 = phi_895_;
                    let _e376 = phi_896_;
                    phi_728_ = _e370;
                    phi_731_ = _e372;
                    phi_733_ = _e374;
                    phi_897_ = _e376;
                } else {
                    phi_728_ = lt_math_LightPoint();
                    phi_731_ = u32();
                    phi_733_ = lt_math_LevelPoint();
                    phi_897_ = false;
                }
                let _e378 = phi_728_;
                let _e380 = phi_731_;
                let _e382 = phi_733_;
                let _e384 = phi_897_;
                continue;
                continuing {
                    phi_727_ = _e378;
                    phi_730_ = _e380;
                    phi_732_ = _e382;
                    break if !(_e384);
                }
            }
            let _e387 = local_2;
            if _e387.point.is_inside {
                if (0f > 0f) {
                    let _e393 = local_3;
                    if (_e393.level < _e68) {
                    } else {
                        return;
                    }
                    let _e398 = levels.member[(0u + _e393.level)];
                    let _e404 = global[0u];
                    if (_e398.row_w.x == _e404) {
                        let _e407 = global[1u];
                        if (_e398.row_w.y == _e407) {
                            let _e410 = global[2u];
                            phi_937_ = (_e398.row_w.z == _e410);
                            phi_938_ = false;
                        } else {
                            phi_937_ = bool();
                            phi_938_ = true;
                        }
                        let _e413 = phi_937_;
                        let _e415 = phi_938_;
                        phi_939_ = _e413;
                        phi_940_ = _e415;
                    } else {
                        phi_939_ = bool();
                        phi_940_ = true;
                    }
                    let _e417 = phi_939_;
                    let _e419 = phi_940_;
                    if _e419 {
                        phi_944_ = false;
                    } else {
                        phi_944_ = _e417;
                    }
                    let _e421 = phi_944_;
                    if _e421 {
                        let _e423 = samples.member[_e74.first_primitive].normal;
                        let _e425 = p.member.map_size;
                        let _e495 = ((abs(((((_e398.row_x.x * _e423.x) + (_e398.row_x.y * _e423.y)) + (_e398.row_x.z * _e423.z)) / (((_e398.row_x.x * _e398.row_x.x) + (_e398.row_x.y * _e398.row_x.y)) + (_e398.row_x.z * _e398.row_x.z)))) + abs(((((_e398.row_y.x * _e423.x) + (_e398.row_y.y * _e423.y)) + (_e398.row_y.z * _e423.z)) / (((_e398.row_y.x * _e398.row_y.x) + (_e398.row_y.y * _e398.row_y.y)) + (_e398.row_y.z * _e398.row_y.z))))) / (abs(((((_e398.row_z.x * _e423.x) + (_e398.row_z.y * _e423.y)) + (_e398.row_z.z * _e423.z)) / (((_e398.row_z.x * _e398.row_z.x) + (_e398.row_z.y * _e398.row_z.y)) + (_e398.row_z.z * _e398.row_z.z)))) * f32(_e425)));
                        if (_e495 < 0.002f) {
                            phi_1026_ = _e495;
                        } else {
                            phi_1026_ = 0.002f;
                        }
                        let _e498 = phi_1026_;
                        phi_1143_ = _e498;
                    } else {
                        let _e500 = p.member.map_size;
                        let _e506 = samples.member[_e74.first_primitive].position;
                        let _e517 = ((((_e398.row_w.x * _e506.x) + (_e398.row_w.y * _e506.y)) + (_e398.row_w.z * _e506.z)) + _e398.row_w.w);
                        let _e530 = ((_e398.row_x.x - (_e398.row_w.x * _e387.point.uv.x)) / _e517);
                        let _e531 = ((_e398.row_x.y - (_e398.row_w.y * _e387.point.uv.x)) / _e517);
                        let _e532 = ((_e398.row_x.z - (_e398.row_w.z * _e387.point.uv.x)) / _e517);
                        let _e545 = ((_e398.row_y.x - (_e398.row_w.x * _e387.point.uv.y)) / _e517);
                        let _e546 = ((_e398.row_y.y - (_e398.row_w.y * _e387.point.uv.y)) / _e517);
                        let _e547 = ((_e398.row_y.z - (_e398.row_w.z * _e387.point.uv.y)) / _e517);
                        let _e553 = samples.member[_e74.first_primitive].normal;
                        let _e558 = ((_e546 * _e553.z) - (_e553.y * _e547));
                        let _e563 = ((_e547 * _e553.x) - (_e553.z * _e545));
                        let _e568 = ((_e545 * _e553.y) - (_e553.x * _e546));
                        let _e570 = samples.member[_e74.first_primitive].normal;
                        let _e575 = ((_e531 * _e570.z) - (_e570.y * _e532));
                        let _e580 = ((_e532 * _e570.x) - (_e570.z * _e530));
                        let _e585 = ((_e530 * _e570.y) - (_e570.x * _e531));
                        let _e612 = ((abs(((((_e398.row_z.x * _e558) + (_e398.row_z.y * _e563)) + (_e398.row_z.z * _e568)) / (((_e530 * _e558) + (_e531 * _e563)) + (_e532 * _e568)))) + abs(((((_e398.row_z.x * _e575) + (_e398.row_z.y * _e580)) + (_e398.row_z.z * _e585)) / (((_e545 * _e575) + (_e546 * _e580)) + (_e547 * _e585))))) / f32(_e500));
                        if (_e612 < 0.002f) {
                            phi_1142_ = _e612;
                        } else {
                            phi_1142_ = 0.002f;
                        }
                        let _e615 = phi_1142_;
                        phi_1143_ = _e615;
                    }
                    let _e617 = phi_1143_;
                    phi_1146_ = (_e387.point.depth - (0f * _e617));
                } else {
                    phi_1146_ = _e387.point.depth;
                }
                let _e621 = phi_1146_;
                let _e627 = p.member.map_size;
                let _e628 = f32(_e627);
                let _e631 = ((_e387.point.uv.x * _e628) - 0.5f);
                let _e632 = ((_e387.point.uv.y * _e628) - 0.5f);
                if (_e631 > -8388608f) {
                    let _e644 = f32(select(0i, select(select(i32(_e631), i32(-2147483648), (_e631 < bitcast<f32>(3472883712u))), 2147483647i, (_e631 > bitcast<f32>(1325400063u))), (_e631 == _e631)));
                    if (_e644 > _e631) {
                        phi_1175_ = 1f;
                    } else {
                        phi_1175_ = 0f;
                    }
                    let _e647 = phi_1175_;
                    if (_e631 < 8388608f) {
                        phi_1180_ = (_e644 - _e647);
                        phi_1181_ = false;
                    } else {
                        phi_1180_ = f32();
                        phi_1181_ = true;
                    }
                    let _e650 = phi_1180_;
                    let _e652 = phi_1181_;
                    phi_1182_ = _e650;
                    phi_1183_ = _e652;
                } else {
                    phi_1182_ = f32();
                    phi_1183_ = true;
                }
                let _e654 = phi_1182_;
                let _e656 = phi_1183_;
                if _e656 {
                    phi_1187_ = _e631;
                } else {
                    phi_1187_ = _e654;
                }
                let _e658 = phi_1187_;
                if (_e632 > -8388608f) {
                    let _e670 = f32(select(0i, select(select(i32(_e632), i32(-2147483648), (_e632 < bitcast<f32>(3472883712u))), 2147483647i, (_e632 > bitcast<f32>(1325400063u))), (_e632 == _e632)));
                    if (_e670 > _e632) {
                        phi_1207_ = 1f;
                    } else {
                        phi_1207_ = 0f;
                    }
                    let _e673 = phi_1207_;
                    if (_e632 < 8388608f) {
                        phi_1212_ = (_e670 - _e673);
                        phi_1213_ = false;
                    } else {
                        phi_1212_ = f32();
                        phi_1213_ = true;
                    }
                    let _e676 = phi_1212_;
                    let _e678 = phi_1213_;
                    phi_1214_ = _e676;
                    phi_1215_ = _e678;
                } else {
                    phi_1214_ = f32();
                    phi_1215_ = true;
                }
                let _e680 = phi_1214_;
                let _e682 = phi_1215_;
                if _e682 {
                    phi_1219_ = _e632;
                } else {
                    phi_1219_ = _e680;
                }
                let _e684 = phi_1219_;
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
                let _e719 = local_4;
                local_1 = lt_math_Evsm(_e715.positive_exponent, _e715.negative_exponent, _e715.min_variance);
                let _e726 = ((_e719.level * _e717) * _e717);
                let _e728 = (bitcast<i32>(_e717) - 1i);
                if (_e695 > 0i) {
                    phi_1272_ = _e695;
                } else {
                    phi_1272_ = 0i;
                }
                let _e731 = phi_1272_;
                if (_e704 > 0i) {
                    phi_1277_ = _e704;
                } else {
                    phi_1277_ = 0i;
                }
                let _e734 = phi_1277_;
                if (_e731 < _e728) {
                    phi_1282_ = _e731;
                } else {
                    phi_1282_ = _e728;
                }
                let _e737 = phi_1282_;
                if (_e734 < _e728) {
                    phi_1287_ = _e734;
                } else {
                    phi_1287_ = _e728;
                }
                let _e740 = phi_1287_;
                let _e741 = bitcast<u32>(_e737);
                let _e743 = (_e695 + 1i);
                let _e744 = (_e704 + 1i);
                if (_e743 > 0i) {
                    phi_1296_ = _e743;
                } else {
                    phi_1296_ = 0i;
                }
                let _e747 = phi_1296_;
                if (_e744 > 0i) {
                    phi_1301_ = _e744;
                } else {
                    phi_1301_ = 0i;
                }
                let _e750 = phi_1301_;
                if (_e747 < _e728) {
                    phi_1306_ = _e747;
                } else {
                    phi_1306_ = _e728;
                }
                let _e753 = phi_1306_;
                if (_e750 < _e728) {
                    phi_1311_ = _e750;
                } else {
                    phi_1311_ = _e728;
                }
                let _e756 = phi_1311_;
                let _e757 = bitcast<u32>(_e753);
                let _e759 = (bitcast<u32>(_e740) * _e717);
                let _e760 = (bitcast<u32>(_e756) * _e717);
                let _e765 = ((_e759 + _e741) + _e726);
                let _e766 = ((_e759 + _e757) + _e726);
                let _e767 = ((_e760 + _e741) + _e726);
                let _e768 = ((_e760 + _e757) + _e726);
                if (_e765 < _e63) {
                } else {
                    return;
                }
                let _e772 = map.member[(0u + _e765)];
                if (_e766 < _e63) {
                } else {
                    return;
                }
                let _e784 = map.member[(0u + _e766)];
                if (_e767 < _e63) {
                } else {
                    return;
                }
                let _e800 = map.member[(0u + _e767)];
                if (_e768 < _e63) {
                } else {
                    return;
                }
                let _e816 = map.member[(0u + _e768)];
                let _e830 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e772.x * _e707) + (_e784.x * _e709)) + (_e800.x * _e711)) + (_e816.x * _e712)), ((((_e772.y * _e707) + (_e784.y * _e709)) + (_e800.y * _e711)) + (_e816.y * _e712)), ((((_e772.z * _e707) + (_e784.z * _e709)) + (_e800.z * _e711)) + (_e816.z * _e712)), ((((_e772.w * _e707) + (_e784.w * _e709)) + (_e800.w * _e711)) + (_e816.w * _e712))), _e621);
                let _e832 = p.member.epsilon;
                if (_e830 <= _e832) {
                    phi_1406_ = true;
                } else {
                    phi_1406_ = (_e830 >= (1f - _e832));
                }
                let _e837 = phi_1406_;
                if ((bitcast<u32>(_e830) & 2147483647u) > 2139095040u) {
                    phi_1414_ = true;
                } else {
                    phi_1414_ = !(_e837);
                }
                let _e843 = phi_1414_;
                if _e843 {
                    if (_e830 > 0f) {
                        if (_e830 < 1f) {
                            phi_1426_ = false;
                        } else {
                            phi_1426_ = true;
                        }
                        let _e847 = phi_1426_;
                        phi_1427_ = _e847;
                    } else {
                        phi_1427_ = true;
                    }
                    let _e849 = phi_1427_;
                    if _e849 {
                        phi_1431_ = 0.5f;
                    } else {
                        phi_1431_ = _e830;
                    }
                    let _e851 = phi_1431_;
                    phi_1439_ = evaluate_Verdict(_e851, true);
                } else {
                    if (_e830 > 0.5f) {
                        phi_1437_ = 1f;
                    } else {
                        phi_1437_ = 0f;
                    }
                    let _e855 = phi_1437_;
                    phi_1439_ = evaluate_Verdict(_e855, false);
                }
                let _e858 = phi_1439_;
                phi_1444_ = evaluate_Verdict(_e858.visibility, _e858.is_doubted);
            } else {
                phi_1444_ = evaluate_Verdict(0.5f, true);
            }
            let _e864 = phi_1444_;
            phi_1445_ = _e864;
        }
        let _e866 = phi_1445_;
        visibility.member[_e74.first_primitive] = _e866.visibility;
        phi_1449_ = _e866.is_doubted;
        phi_1450_ = _e74.first_primitive;
    } else {
        phi_1449_ = false;
        phi_1450_ = 0u;
    }
    let _e871 = phi_1449_;
    let _e873 = phi_1450_;
    if (_e58 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e871 {
        let _e877 = atomicAdd((&shared_[0u]), 1u);
        phi_1461_ = _e877;
    } else {
        phi_1461_ = 0u;
    }
    let _e879 = phi_1461_;
    workgroupBarrier();
    if (_e58 == 0u) {
        let _e883 = atomicLoad((&shared_[0u]));
        let _e884 = atomicAdd((&list.member[3u]), _e883);
        atomicStore((&shared_[1u]), _e884);
    }
    workgroupBarrier();
    if _e871 {
        let _e887 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e887) + _e879)]), _e873);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
