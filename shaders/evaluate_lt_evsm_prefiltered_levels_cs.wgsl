struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
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

struct type_15 {
    member: array<abi_Sample>,
}

struct type_19 {
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

struct type_39 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(4) 
var<storage> levels: type_39;
@group(0) @binding(2) 
var<storage> map: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_170_: lt_bvh_traverse_Tree;
    var phi_171_: bool;
    var phi_172_: lt_bvh_traverse_Tree;
    var phi_173_: bool;
    var phi_178_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_170_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_171_ = false;
        } else {
            phi_170_ = lt_bvh_traverse_Tree();
            phi_171_ = true;
        }
        let _e69 = phi_170_;
        let _e71 = phi_171_;
        phi_172_ = _e69;
        phi_173_ = _e71;
    } else {
        phi_172_ = lt_bvh_traverse_Tree();
        phi_173_ = true;
    }
    let _e73 = phi_172_;
    let _e75 = phi_173_;
    if _e75 {
        phi_178_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_178_ = _e73;
    }
    let _e80 = phi_178_;
    return lt_bvh_traverse_Tree(_e80.root, _e80.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_205_: f32;
    var phi_206_: f32;
    var phi_207_: f32;
    var phi_220_: bool;
    var phi_224_: f32;
    var phi_236_: f32;
    var phi_241_: f32;
    var phi_263_: f32;
    var phi_268_: f32;
    var phi_269_: bool;
    var phi_270_: f32;
    var phi_271_: bool;
    var phi_275_: f32;
    var phi_313_: f32;
    var phi_326_: bool;
    var phi_330_: f32;
    var phi_343_: f32;
    var phi_348_: f32;
    var phi_370_: f32;
    var phi_375_: f32;
    var phi_376_: bool;
    var phi_377_: f32;
    var phi_378_: bool;
    var phi_382_: f32;
    var phi_420_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_207_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_206_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_205_ = 1f;
            } else {
                phi_205_ = param_5;
            }
            let _e64 = phi_205_;
            phi_206_ = _e64;
        }
        let _e66 = phi_206_;
        phi_207_ = _e66;
    }
    let _e68 = phi_207_;
    let _e70 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_220_ = true;
    } else {
        let _e74 = (42f < _e70);
        if _e74 {
        }
        phi_220_ = _e74;
    }
    let _e76 = phi_220_;
    if _e76 {
        phi_224_ = 42f;
    } else {
        phi_224_ = _e70;
    }
    let _e78 = phi_224_;
    let _e79 = (_e78 * _e68);
    if ((bitcast<u32>(_e79) & 2147483647u) > 2139095040u) {
        phi_313_ = _e79;
    } else {
        if (_e79 < -87f) {
            phi_236_ = -87f;
        } else {
            phi_236_ = _e79;
        }
        let _e85 = phi_236_;
        if (_e85 > 88f) {
            phi_241_ = 88f;
        } else {
            phi_241_ = _e85;
        }
        let _e88 = phi_241_;
        let _e90 = ((_e88 * 1.442695f) + 0.5f);
        if (_e90 > -8388608f) {
            let _e102 = f32(select(0i, select(select(i32(_e90), i32(-2147483648), (_e90 < bitcast<f32>(3472883712u))), 2147483647i, (_e90 > bitcast<f32>(1325400063u))), (_e90 == _e90)));
            if (_e102 > _e90) {
                phi_263_ = 1f;
            } else {
                phi_263_ = 0f;
            }
            let _e105 = phi_263_;
            if (_e90 < 8388608f) {
                phi_268_ = (_e102 - _e105);
                phi_269_ = false;
            } else {
                phi_268_ = f32();
                phi_269_ = true;
            }
            let _e108 = phi_268_;
            let _e110 = phi_269_;
            phi_270_ = _e108;
            phi_271_ = _e110;
        } else {
            phi_270_ = f32();
            phi_271_ = true;
        }
        let _e112 = phi_270_;
        let _e114 = phi_271_;
        if _e114 {
            phi_275_ = _e90;
        } else {
            phi_275_ = _e112;
        }
        let _e116 = phi_275_;
        let _e120 = ((_e88 - (_e116 * 0.69314575f)) - (_e116 * 0.0000014286068f));
        phi_313_ = ((((((((((((((((1f / 5040f) * _e120) + (1f / 720f)) * _e120) + (1f / 120f)) * _e120) + (1f / 24f)) * _e120) + (1f / 6f)) * _e120) + 0.5f) * _e120) + 1f) * _e120) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e156 = phi_313_;
    let _e158 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_326_ = true;
    } else {
        let _e162 = (42f < _e158);
        if _e162 {
        }
        phi_326_ = _e162;
    }
    let _e164 = phi_326_;
    if _e164 {
        phi_330_ = 42f;
    } else {
        phi_330_ = _e158;
    }
    let _e166 = phi_330_;
    let _e168 = (-(_e166) * _e68);
    if ((bitcast<u32>(_e168) & 2147483647u) > 2139095040u) {
        phi_420_ = _e168;
    } else {
        if (_e168 < -87f) {
            phi_343_ = -87f;
        } else {
            phi_343_ = _e168;
        }
        let _e174 = phi_343_;
        if (_e174 > 88f) {
            phi_348_ = 88f;
        } else {
            phi_348_ = _e174;
        }
        let _e177 = phi_348_;
        let _e179 = ((_e177 * 1.442695f) + 0.5f);
        if (_e179 > -8388608f) {
            let _e191 = f32(select(0i, select(select(i32(_e179), i32(-2147483648), (_e179 < bitcast<f32>(3472883712u))), 2147483647i, (_e179 > bitcast<f32>(1325400063u))), (_e179 == _e179)));
            if (_e191 > _e179) {
                phi_370_ = 1f;
            } else {
                phi_370_ = 0f;
            }
            let _e194 = phi_370_;
            if (_e179 < 8388608f) {
                phi_375_ = (_e191 - _e194);
                phi_376_ = false;
            } else {
                phi_375_ = f32();
                phi_376_ = true;
            }
            let _e197 = phi_375_;
            let _e199 = phi_376_;
            phi_377_ = _e197;
            phi_378_ = _e199;
        } else {
            phi_377_ = f32();
            phi_378_ = true;
        }
        let _e201 = phi_377_;
        let _e203 = phi_378_;
        if _e203 {
            phi_382_ = _e179;
        } else {
            phi_382_ = _e201;
        }
        let _e205 = phi_382_;
        let _e209 = ((_e177 - (_e205 * 0.69314575f)) - (_e205 * 0.0000014286068f));
        phi_420_ = ((((((((((((((((1f / 5040f) * _e209) + (1f / 720f)) * _e209) + (1f / 120f)) * _e209) + (1f / 24f)) * _e209) + (1f / 6f)) * _e209) + 0.5f) * _e209) + 1f) * _e209) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e205), i32(-2147483648), (_e205 < bitcast<f32>(3472883712u))), 2147483647i, (_e205 > bitcast<f32>(1325400063u))), (_e205 == _e205)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e245 = phi_420_;
    let _e246 = -(_e245);
    return vec4<f32>(_e156, (_e156 * _e156), _e246, (_e246 * _e246));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_442_: bool;
    var phi_446_: f32;
    var phi_470_: bool;
    var phi_474_: f32;
    var phi_486_: bool;
    var phi_493_: f32;
    var phi_506_: bool;
    var phi_510_: f32;
    var phi_534_: bool;
    var phi_538_: f32;
    var phi_550_: bool;
    var phi_557_: f32;
    var phi_568_: bool;
    var phi_572_: f32;
    var phi_587_: f32;
    var phi_588_: f32;
    var phi_589_: f32;

    let _e59 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e61 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_442_ = true;
    } else {
        let _e65 = (42f < _e61);
        if _e65 {
        }
        phi_442_ = _e65;
    }
    let _e67 = phi_442_;
    if _e67 {
        phi_446_ = 42f;
    } else {
        phi_446_ = _e61;
    }
    let _e69 = phi_446_;
    let _e71 = (*param_6).min_variance;
    let _e75 = (((_e71 * _e69) * _e69) * _e59.y);
    let _e82 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
        phi_470_ = true;
    } else {
        let _e86 = (_e75 > _e82);
        if _e86 {
        }
        phi_470_ = _e86;
    }
    let _e88 = phi_470_;
    if _e88 {
        phi_474_ = _e75;
    } else {
        phi_474_ = _e82;
    }
    let _e90 = phi_474_;
    let _e91 = (_e59.x - param_7.x);
    if (_e91 <= 0f) {
        let _e95 = ((bitcast<u32>(_e90) & 2147483647u) > 2139095040u);
        if _e95 {
        }
        phi_486_ = _e95;
    } else {
        phi_486_ = true;
    }
    let _e97 = phi_486_;
    if _e97 {
        phi_493_ = (_e90 / (_e90 + (_e91 * _e91)));
    } else {
        phi_493_ = 1f;
    }
    let _e102 = phi_493_;
    let _e104 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_506_ = true;
    } else {
        let _e108 = (42f < _e104);
        if _e108 {
        }
        phi_506_ = _e108;
    }
    let _e110 = phi_506_;
    if _e110 {
        phi_510_ = 42f;
    } else {
        phi_510_ = _e104;
    }
    let _e112 = phi_510_;
    let _e114 = (*param_6).min_variance;
    let _e118 = (((_e114 * _e112) * _e112) * _e59.w);
    let _e125 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e118) & 2147483647u) > 2139095040u) {
        phi_534_ = true;
    } else {
        let _e129 = (_e118 > _e125);
        if _e129 {
        }
        phi_534_ = _e129;
    }
    let _e131 = phi_534_;
    if _e131 {
        phi_538_ = _e118;
    } else {
        phi_538_ = _e125;
    }
    let _e133 = phi_538_;
    let _e134 = (_e59.z - param_7.z);
    if (_e134 <= 0f) {
        let _e138 = ((bitcast<u32>(_e133) & 2147483647u) > 2139095040u);
        if _e138 {
        }
        phi_550_ = _e138;
    } else {
        phi_550_ = true;
    }
    let _e140 = phi_550_;
    if _e140 {
        phi_557_ = (_e133 / (_e133 + (_e134 * _e134)));
    } else {
        phi_557_ = 1f;
    }
    let _e145 = phi_557_;
    if ((bitcast<u32>(_e145) & 2147483647u) > 2139095040u) {
        phi_568_ = true;
    } else {
        let _e149 = (_e145 < _e102);
        if _e149 {
        }
        phi_568_ = _e149;
    }
    let _e151 = phi_568_;
    if _e151 {
        phi_572_ = _e145;
    } else {
        phi_572_ = _e102;
    }
    let _e153 = phi_572_;
    if ((bitcast<u32>(_e153) & 2147483647u) > 2139095040u) {
        phi_589_ = _e153;
    } else {
        if (_e153 < 0f) {
            phi_588_ = 0f;
        } else {
            if (_e153 > 1f) {
                phi_587_ = 1f;
            } else {
                phi_587_ = _e153;
            }
            let _e160 = phi_587_;
            phi_588_ = _e160;
        }
        let _e162 = phi_588_;
        phi_589_ = _e162;
    }
    let _e164 = phi_589_;
    return _e164;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_656_: bool;
    var phi_726_: bool;
    var phi_727_: bool;
    var phi_738_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_739_: bool;
    var phi_740_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_741_: bool;
    var phi_748_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_752_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_772_: lt_math_LightPoint;
    var phi_775_: u32;
    var phi_777_: lt_math_LevelPoint;
    var phi_863_: bool;
    var phi_872_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_884_: bool;
    var phi_885_: bool;
    var phi_886_: bool;
    var phi_887_: bool;
    var phi_891_: bool;
    var phi_918_: bool;
    var phi_919_: bool;
    var phi_920_: bool;
    var phi_921_: bool;
    var phi_922_: bool;
    var phi_923_: bool;
    var phi_924_: bool;
    var phi_925_: bool;
    var phi_929_: bool;
    var phi_938_: lt_math_LightPoint;
    var phi_939_: u32;
    var phi_940_: lt_math_LevelPoint;
    var phi_941_: bool;
    var phi_773_: lt_math_LightPoint;
    var phi_776_: u32;
    var phi_778_: lt_math_LevelPoint;
    var phi_942_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_982_: bool;
    var phi_983_: bool;
    var phi_984_: bool;
    var phi_985_: bool;
    var phi_989_: bool;
    var phi_1071_: f32;
    var phi_1189_: f32;
    var phi_1190_: f32;
    var phi_1193_: f32;
    var phi_1222_: f32;
    var phi_1227_: f32;
    var phi_1228_: bool;
    var phi_1229_: f32;
    var phi_1230_: bool;
    var phi_1234_: f32;
    var phi_1254_: f32;
    var phi_1259_: f32;
    var phi_1260_: bool;
    var phi_1261_: f32;
    var phi_1262_: bool;
    var phi_1266_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1319_: i32;
    var phi_1324_: i32;
    var phi_1329_: i32;
    var phi_1334_: i32;
    var phi_1343_: i32;
    var phi_1348_: i32;
    var phi_1353_: i32;
    var phi_1358_: i32;
    var phi_1455_: bool;
    var phi_1463_: bool;
    var phi_1475_: bool;
    var phi_1476_: bool;
    var phi_1480_: f32;
    var phi_1486_: f32;
    var phi_1488_: evaluate_Verdict;
    var phi_1498_: u32;
    var phi_1507_: f32;
    var phi_1509_: evaluate_Verdict;
    var phi_1510_: bool;
    var phi_1511_: evaluate_Verdict;
    var phi_1512_: bool;
    var phi_1517_: evaluate_Verdict;
    var phi_1522_: evaluate_Verdict;
    var phi_1523_: evaluate_Verdict;

    let _e57 = id_1;
    let _e64 = arrayLength((&map.member));
    let _e70 = arrayLength((&levels.member));
    let _e73 = p.member.size[0u];
    let _e75 = p.member.size[1u];
    let _e76 = lt_shaders_entry_pixel_index(_e57, _e73, _e75);
    if (bitcast<i32>(_e76.root) != 0i) {
        let _e82 = p.member.level_count;
        if (_e76.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e89 = samples.member[(0u + _e76.first_primitive)].normal[0u];
        let _e91 = global[0u];
        if (_e89 == _e91) {
            let _e94 = samples.member[(0u + _e76.first_primitive)].normal[1u];
            let _e96 = global[1u];
            if (_e94 == _e96) {
                let _e99 = samples.member[(0u + _e76.first_primitive)].normal[2u];
                let _e101 = global[2u];
                phi_649_ = (_e99 == _e101);
                phi_650_ = false;
            } else {
                phi_649_ = bool();
                phi_650_ = true;
            }
            let _e104 = phi_649_;
            let _e106 = phi_650_;
            phi_651_ = _e104;
            phi_652_ = _e106;
        } else {
            phi_651_ = bool();
            phi_652_ = true;
        }
        let _e108 = phi_651_;
        let _e110 = phi_652_;
        if _e110 {
            phi_656_ = false;
        } else {
            phi_656_ = _e108;
        }
        let _e112 = phi_656_;
        if !(_e112) {
            let _e115 = samples.member[(0u + _e76.first_primitive)].position;
            let _e117 = p.member.light.place;
            let _e123 = p.member.light.place[3u];
            let _e130 = (_e117.x - (_e115.x * _e123));
            let _e131 = (_e117.y - (_e115.y * _e123));
            let _e132 = (_e117.z - (_e115.z * _e123));
            let _e134 = samples.member[(0u + _e76.first_primitive)].normal;
            if ((((_e134.x * _e130) + (_e134.y * _e131)) + (_e134.z * _e132)) > 0f) {
                let _e148 = (((_e130 * _e130) + (_e131 * _e131)) + (_e132 * _e132));
                let _e150 = p.member.light.axis;
                let _e162 = p.member.light.place[3u];
                if (_e162 == 0f) {
                    phi_727_ = true;
                } else {
                    let _e165 = p.member.light.range_squared;
                    if (_e148 <= _e165) {
                        let _e168 = p.member.light.cos_outer;
                        phi_726_ = (-((((_e130 * _e150.x) + (_e131 * _e150.y)) + (_e132 * _e150.z))) >= (_e168 * sqrt(_e148)));
                    } else {
                        phi_726_ = false;
                    }
                    let _e173 = phi_726_;
                    phi_727_ = _e173;
                }
                let _e175 = phi_727_;
                if _e175 {
                    let _e177 = samples.member[(0u + _e76.first_primitive)].flags;
                    let _e185 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e185.unnamed.visibility, false), _e185.unnamed_1);
                    phi_738_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e191.unnamed, ((_e177 & 1u) == 0u));
                    phi_739_ = false;
                } else {
                    phi_738_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_739_ = true;
                }
                let _e196 = phi_738_;
                let _e198 = phi_739_;
                phi_740_ = _e196;
                phi_741_ = _e198;
            } else {
                phi_740_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_741_ = true;
            }
            let _e200 = phi_740_;
            let _e202 = phi_741_;
            if _e202 {
                let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e208.unnamed.visibility, false), _e208.unnamed_1);
                phi_748_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e214.unnamed, true);
            } else {
                phi_748_ = _e200;
            }
            let _e219 = phi_748_;
            phi_752_ = _e219;
        } else {
            let _e225 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e231 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e225.unnamed.visibility, false), _e225.unnamed_1);
            phi_752_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e231.unnamed, true);
        }
        let _e236 = phi_752_;
        if _e236.unnamed_1 {
            phi_1523_ = evaluate_Verdict(_e236.unnamed.visibility, _e236.unnamed.is_doubted);
        } else {
            let _e244 = samples.member[(0u + _e76.first_primitive)].position;
            let _e246 = p.member.map_size;
            let _e248 = (0.5f / f32(_e246));
            let _e255 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e262 = lt_math_LightPoint(vec2<f32>(_e255.uv.x, 0f), _e255.depth, _e255.is_inside);
            let _e266 = lt_math_LightPoint(_e262.uv, 0f, _e262.is_inside);
            phi_772_ = lt_math_LightPoint();
            phi_775_ = 0u;
            phi_777_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e266.uv, _e266.depth, false));
            loop {
                let _e273 = phi_772_;
                let _e275 = phi_775_;
                let _e277 = phi_777_;
                local_1 = _e277;
                local_2 = _e277;
                local_3 = _e277;
                if (_e275 < _e82) {
                    if _e277.point.is_inside {
                        phi_938_ = lt_math_LightPoint();
                        phi_939_ = u32();
                        phi_940_ = lt_math_LevelPoint();
                        phi_941_ = false;
                    } else {
                        if (_e275 < _e70) {
                        } else {
                            return;
                        }
                        let _e288 = levels.member[(0u + _e275)].row_w;
                        let _e299 = ((((_e288.x * _e244.x) + (_e288.y * _e244.y)) + (_e288.z * _e244.z)) + (_e288.w * 1f));
                        let _e301 = levels.member[(0u + _e275)].row_x;
                        let _e313 = (((((_e301.x * _e244.x) + (_e301.y * _e244.y)) + (_e301.z * _e244.z)) + (_e301.w * 1f)) / _e299);
                        let _e315 = levels.member[(0u + _e275)].row_y;
                        let _e327 = (((((_e315.x * _e244.x) + (_e315.y * _e244.y)) + (_e315.z * _e244.z)) + (_e315.w * 1f)) / _e299);
                        let _e329 = levels.member[(0u + _e275)].row_z;
                        let _e340 = ((((_e329.x * _e244.x) + (_e329.y * _e244.y)) + (_e329.z * _e244.z)) + (_e329.w * 1f));
                        if (_e299 > 0f) {
                            if (_e313 >= 0f) {
                                phi_863_ = (_e313 <= 1f);
                            } else {
                                phi_863_ = false;
                            }
                            let _e345 = phi_863_;
                            if _e345 {
                                if (_e327 >= 0f) {
                                    phi_872_ = (_e327 <= 1f);
                                } else {
                                    phi_872_ = false;
                                }
                                let _e349 = phi_872_;
                                if _e349 {
                                    if (_e340 >= 0f) {
                                        phi_881_ = (_e340 <= 1f);
                                    } else {
                                        phi_881_ = false;
                                    }
                                    let _e353 = phi_881_;
                                    phi_882_ = _e353;
                                    phi_883_ = false;
                                } else {
                                    phi_882_ = bool();
                                    phi_883_ = true;
                                }
                                let _e355 = phi_882_;
                                let _e357 = phi_883_;
                                phi_884_ = _e355;
                                phi_885_ = _e357;
                            } else {
                                phi_884_ = bool();
                                phi_885_ = true;
                            }
                            let _e359 = phi_884_;
                            let _e361 = phi_885_;
                            phi_886_ = _e359;
                            phi_887_ = _e361;
                        } else {
                            phi_886_ = bool();
                            phi_887_ = true;
                        }
                        let _e363 = phi_886_;
                        let _e365 = phi_887_;
                        if _e365 {
                            phi_891_ = false;
                        } else {
                            phi_891_ = _e363;
                        }
                        let _e367 = phi_891_;
                        if _e367 {
                            if (_e313 >= _e248) {
                                if (_e313 <= (1f - _e248)) {
                                    if (_e327 >= _e248) {
                                        phi_918_ = (_e327 <= (1f - _e248));
                                        phi_919_ = false;
                                    } else {
                                        phi_918_ = bool();
                                        phi_919_ = true;
                                    }
                                    let _e375 = phi_918_;
                                    let _e377 = phi_919_;
                                    phi_920_ = _e375;
                                    phi_921_ = _e377;
                                } else {
                                    phi_920_ = bool();
                                    phi_921_ = true;
                                }
                                let _e379 = phi_920_;
                                let _e381 = phi_921_;
                                phi_922_ = _e379;
                                phi_923_ = _e381;
                            } else {
                                phi_922_ = bool();
                                phi_923_ = true;
                            }
                            let _e383 = phi_922_;
                            let _e385 = phi_923_;
                            phi_924_ = _e383;
                            phi_925_ = _e385;
                        } else {
                            phi_924_ = bool();
                            phi_925_ = true;
                        }
                        let _e387 = phi_924_;
                        let _e389 = phi_925_;
                        if _e389 {
                            phi_929_ = false;
                        } else {
                            phi_929_ = _e387;
                        }
                        let _e391 = phi_929_;
                        let _e398 = lt_math_LightPoint(vec2<f32>(_e313, _e273.uv.y), _e273.depth, _e273.is_inside);
                        let _e405 = lt_math_LightPoint(vec2<f32>(_e398.uv.x, _e327), _e398.depth, _e398.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e340, _e405.is_inside);
                        let _e413 = lt_math_LightPoint(_e409.uv, _e409.depth, _e391);
                        phi_938_ = _e413;
                        phi_939_ = (_e275 + 1u);
                        phi_940_ = lt_math_LevelPoint(_e275, _e413);
                        phi_941_ = true;
                    }
                    let _e417 = phi_938_;
                    let _e419 = phi_939_;
                    let _e421 = phi_940_;
                    let _e423 = phi_941_;
                    phi_773_ = _e417;
                    phi_776_ = _e419;
                    phi_778_ = _e421;
                    phi_942_ = _e423;
                } else {
                    phi_773_ = lt_math_LightPoint();
                    phi_776_ = u32();
                    phi_778_ = lt_math_LevelPoint();
                    phi_942_ = false;
                }
                let _e425 = phi_773_;
                let _e427 = phi_776_;
                let _e429 = phi_778_;
                let _e431 = phi_942_;
                continue;
                continuing {
                    phi_772_ = _e425;
                    phi_775_ = _e427;
                    phi_777_ = _e429;
                    break if !(_e431);
                }
            }
            let _e434 = local_1;
            if _e434.point.is_inside {
                if (0f > 0f) {
                    let _e440 = local_2;
                    if (_e440.level < _e70) {
                    } else {
                        return;
                    }
                    let _e445 = levels.member[(0u + _e440.level)];
                    let _e451 = global[0u];
                    if (_e445.row_w.x == _e451) {
                        let _e454 = global[1u];
                        if (_e445.row_w.y == _e454) {
                            let _e457 = global[2u];
                            phi_982_ = (_e445.row_w.z == _e457);
                            phi_983_ = false;
                        } else {
                            phi_982_ = bool();
                            phi_983_ = true;
                        }
                        let _e460 = phi_982_;
                        let _e462 = phi_983_;
                        phi_984_ = _e460;
                        phi_985_ = _e462;
                    } else {
                        phi_984_ = bool();
                        phi_985_ = true;
                    }
                    let _e464 = phi_984_;
                    let _e466 = phi_985_;
                    if _e466 {
                        phi_989_ = false;
                    } else {
                        phi_989_ = _e464;
                    }
                    let _e468 = phi_989_;
                    if _e468 {
                        let _e470 = samples.member[(0u + _e76.first_primitive)].normal;
                        let _e472 = p.member.map_size;
                        let _e542 = ((abs(((((_e445.row_x.x * _e470.x) + (_e445.row_x.y * _e470.y)) + (_e445.row_x.z * _e470.z)) / (((_e445.row_x.x * _e445.row_x.x) + (_e445.row_x.y * _e445.row_x.y)) + (_e445.row_x.z * _e445.row_x.z)))) + abs(((((_e445.row_y.x * _e470.x) + (_e445.row_y.y * _e470.y)) + (_e445.row_y.z * _e470.z)) / (((_e445.row_y.x * _e445.row_y.x) + (_e445.row_y.y * _e445.row_y.y)) + (_e445.row_y.z * _e445.row_y.z))))) / (abs(((((_e445.row_z.x * _e470.x) + (_e445.row_z.y * _e470.y)) + (_e445.row_z.z * _e470.z)) / (((_e445.row_z.x * _e445.row_z.x) + (_e445.row_z.y * _e445.row_z.y)) + (_e445.row_z.z * _e445.row_z.z)))) * f32(_e472)));
                        if (_e542 < 0.002f) {
                            phi_1071_ = _e542;
                        } else {
                            phi_1071_ = 0.002f;
                        }
                        let _e545 = phi_1071_;
                        phi_1190_ = _e545;
                    } else {
                        let _e547 = p.member.map_size;
                        let _e553 = samples.member[(0u + _e76.first_primitive)].position;
                        let _e564 = ((((_e445.row_w.x * _e553.x) + (_e445.row_w.y * _e553.y)) + (_e445.row_w.z * _e553.z)) + _e445.row_w.w);
                        let _e577 = ((_e445.row_x.x - (_e445.row_w.x * _e434.point.uv.x)) / _e564);
                        let _e578 = ((_e445.row_x.y - (_e445.row_w.y * _e434.point.uv.x)) / _e564);
                        let _e579 = ((_e445.row_x.z - (_e445.row_w.z * _e434.point.uv.x)) / _e564);
                        let _e592 = ((_e445.row_y.x - (_e445.row_w.x * _e434.point.uv.y)) / _e564);
                        let _e593 = ((_e445.row_y.y - (_e445.row_w.y * _e434.point.uv.y)) / _e564);
                        let _e594 = ((_e445.row_y.z - (_e445.row_w.z * _e434.point.uv.y)) / _e564);
                        let _e600 = samples.member[(0u + _e76.first_primitive)].normal;
                        let _e605 = ((_e593 * _e600.z) - (_e600.y * _e594));
                        let _e610 = ((_e594 * _e600.x) - (_e600.z * _e592));
                        let _e615 = ((_e592 * _e600.y) - (_e600.x * _e593));
                        let _e617 = samples.member[(0u + _e76.first_primitive)].normal;
                        let _e622 = ((_e578 * _e617.z) - (_e617.y * _e579));
                        let _e627 = ((_e579 * _e617.x) - (_e617.z * _e577));
                        let _e632 = ((_e577 * _e617.y) - (_e617.x * _e578));
                        let _e659 = ((abs(((((_e445.row_z.x * _e605) + (_e445.row_z.y * _e610)) + (_e445.row_z.z * _e615)) / (((_e577 * _e605) + (_e578 * _e610)) + (_e579 * _e615)))) + abs(((((_e445.row_z.x * _e622) + (_e445.row_z.y * _e627)) + (_e445.row_z.z * _e632)) / (((_e592 * _e622) + (_e593 * _e627)) + (_e594 * _e632))))) / f32(_e547));
                        let _e661 = (16f / f32(_e547));
                        if (_e659 < _e661) {
                            phi_1189_ = _e659;
                        } else {
                            phi_1189_ = _e661;
                        }
                        let _e664 = phi_1189_;
                        phi_1190_ = _e664;
                    }
                    let _e666 = phi_1190_;
                    phi_1193_ = (_e434.point.depth - (0f * _e666));
                } else {
                    phi_1193_ = _e434.point.depth;
                }
                let _e670 = phi_1193_;
                let _e676 = p.member.map_size;
                let _e677 = f32(_e676);
                let _e680 = ((_e434.point.uv.x * _e677) - 0.5f);
                let _e681 = ((_e434.point.uv.y * _e677) - 0.5f);
                if (_e680 > -8388608f) {
                    let _e693 = f32(select(0i, select(select(i32(_e680), i32(-2147483648), (_e680 < bitcast<f32>(3472883712u))), 2147483647i, (_e680 > bitcast<f32>(1325400063u))), (_e680 == _e680)));
                    if (_e693 > _e680) {
                        phi_1222_ = 1f;
                    } else {
                        phi_1222_ = 0f;
                    }
                    let _e696 = phi_1222_;
                    if (_e680 < 8388608f) {
                        phi_1227_ = (_e693 - _e696);
                        phi_1228_ = false;
                    } else {
                        phi_1227_ = f32();
                        phi_1228_ = true;
                    }
                    let _e699 = phi_1227_;
                    let _e701 = phi_1228_;
                    phi_1229_ = _e699;
                    phi_1230_ = _e701;
                } else {
                    phi_1229_ = f32();
                    phi_1230_ = true;
                }
                let _e703 = phi_1229_;
                let _e705 = phi_1230_;
                if _e705 {
                    phi_1234_ = _e680;
                } else {
                    phi_1234_ = _e703;
                }
                let _e707 = phi_1234_;
                if (_e681 > -8388608f) {
                    let _e719 = f32(select(0i, select(select(i32(_e681), i32(-2147483648), (_e681 < bitcast<f32>(3472883712u))), 2147483647i, (_e681 > bitcast<f32>(1325400063u))), (_e681 == _e681)));
                    if (_e719 > _e681) {
                        phi_1254_ = 1f;
                    } else {
                        phi_1254_ = 0f;
                    }
                    let _e722 = phi_1254_;
                    if (_e681 < 8388608f) {
                        phi_1259_ = (_e719 - _e722);
                        phi_1260_ = false;
                    } else {
                        phi_1259_ = f32();
                        phi_1260_ = true;
                    }
                    let _e725 = phi_1259_;
                    let _e727 = phi_1260_;
                    phi_1261_ = _e725;
                    phi_1262_ = _e727;
                } else {
                    phi_1261_ = f32();
                    phi_1262_ = true;
                }
                let _e729 = phi_1261_;
                let _e731 = phi_1262_;
                if _e731 {
                    phi_1266_ = _e681;
                } else {
                    phi_1266_ = _e729;
                }
                let _e733 = phi_1266_;
                let _e734 = (_e680 - _e707);
                let _e735 = (_e681 - _e733);
                let _e744 = select(0i, select(select(i32(_e707), i32(-2147483648), (_e707 < bitcast<f32>(3472883712u))), 2147483647i, (_e707 > bitcast<f32>(1325400063u))), (_e707 == _e707));
                let _e753 = select(0i, select(select(i32(_e733), i32(-2147483648), (_e733 < bitcast<f32>(3472883712u))), 2147483647i, (_e733 > bitcast<f32>(1325400063u))), (_e733 == _e733));
                let _e756 = ((1f - _e734) * (1f - _e735));
                let _e758 = (_e734 * (1f - _e735));
                let _e760 = ((1f - _e734) * _e735);
                let _e761 = (_e734 * _e735);
                let _e763 = p.member.test;
                let _e764 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e763);
                let _e766 = p.member.map_size;
                let _e768 = local_3;
                local = lt_math_Evsm(_e764.positive_exponent, _e764.negative_exponent, _e764.min_variance);
                let _e775 = ((_e768.level * _e766) * _e766);
                let _e777 = (bitcast<i32>(_e766) - 1i);
                if (_e744 > 0i) {
                    phi_1319_ = _e744;
                } else {
                    phi_1319_ = 0i;
                }
                let _e780 = phi_1319_;
                if (_e753 > 0i) {
                    phi_1324_ = _e753;
                } else {
                    phi_1324_ = 0i;
                }
                let _e783 = phi_1324_;
                if (_e780 < _e777) {
                    phi_1329_ = _e780;
                } else {
                    phi_1329_ = _e777;
                }
                let _e786 = phi_1329_;
                if (_e783 < _e777) {
                    phi_1334_ = _e783;
                } else {
                    phi_1334_ = _e777;
                }
                let _e789 = phi_1334_;
                let _e790 = bitcast<u32>(_e786);
                let _e792 = (_e744 + 1i);
                let _e793 = (_e753 + 1i);
                if (_e792 > 0i) {
                    phi_1343_ = _e792;
                } else {
                    phi_1343_ = 0i;
                }
                let _e796 = phi_1343_;
                if (_e793 > 0i) {
                    phi_1348_ = _e793;
                } else {
                    phi_1348_ = 0i;
                }
                let _e799 = phi_1348_;
                if (_e796 < _e777) {
                    phi_1353_ = _e796;
                } else {
                    phi_1353_ = _e777;
                }
                let _e802 = phi_1353_;
                if (_e799 < _e777) {
                    phi_1358_ = _e799;
                } else {
                    phi_1358_ = _e777;
                }
                let _e805 = phi_1358_;
                let _e806 = bitcast<u32>(_e802);
                let _e808 = (bitcast<u32>(_e789) * _e766);
                let _e809 = (bitcast<u32>(_e805) * _e766);
                let _e814 = ((_e808 + _e790) + _e775);
                let _e815 = ((_e808 + _e806) + _e775);
                let _e816 = ((_e809 + _e790) + _e775);
                let _e817 = ((_e809 + _e806) + _e775);
                if (_e814 < _e64) {
                } else {
                    return;
                }
                let _e821 = map.member[(0u + _e814)];
                if (_e815 < _e64) {
                } else {
                    return;
                }
                let _e833 = map.member[(0u + _e815)];
                if (_e816 < _e64) {
                } else {
                    return;
                }
                let _e849 = map.member[(0u + _e816)];
                if (_e817 < _e64) {
                } else {
                    return;
                }
                let _e865 = map.member[(0u + _e817)];
                let _e879 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e821.x * _e756) + (_e833.x * _e758)) + (_e849.x * _e760)) + (_e865.x * _e761)), ((((_e821.y * _e756) + (_e833.y * _e758)) + (_e849.y * _e760)) + (_e865.y * _e761)), ((((_e821.z * _e756) + (_e833.z * _e758)) + (_e849.z * _e760)) + (_e865.z * _e761)), ((((_e821.w * _e756) + (_e833.w * _e758)) + (_e849.w * _e760)) + (_e865.w * _e761))), _e670);
                let _e883 = p.member.epsilon;
                if (_e879 <= _e883) {
                    phi_1455_ = true;
                } else {
                    phi_1455_ = (_e879 >= (1f - _e883));
                }
                let _e888 = phi_1455_;
                if ((bitcast<u32>(_e879) & 2147483647u) > 2139095040u) {
                    phi_1463_ = true;
                } else {
                    phi_1463_ = !(_e888);
                }
                let _e894 = phi_1463_;
                if _e894 {
                    if (_e879 > 0f) {
                        if (_e879 < 1f) {
                            phi_1475_ = false;
                        } else {
                            phi_1475_ = true;
                        }
                        let _e898 = phi_1475_;
                        phi_1476_ = _e898;
                    } else {
                        phi_1476_ = true;
                    }
                    let _e900 = phi_1476_;
                    if _e900 {
                        phi_1480_ = 0.5f;
                    } else {
                        phi_1480_ = _e879;
                    }
                    let _e902 = phi_1480_;
                    phi_1488_ = evaluate_Verdict(_e902, true);
                } else {
                    if (_e879 > 0.5f) {
                        phi_1486_ = 1f;
                    } else {
                        phi_1486_ = 0f;
                    }
                    let _e906 = phi_1486_;
                    phi_1488_ = evaluate_Verdict(_e906, false);
                }
                let _e909 = phi_1488_;
                let _e912 = (_e909.visibility < 0.5f);
                if _e909.is_doubted {
                    phi_1511_ = evaluate_Verdict();
                    phi_1512_ = true;
                } else {
                    if _e912 {
                        phi_1498_ = 2u;
                    } else {
                        phi_1498_ = 1u;
                    }
                    let _e914 = phi_1498_;
                    if ((0u & _e914) != 0u) {
                        if _e912 {
                            phi_1507_ = 0.000000059604645f;
                        } else {
                            phi_1507_ = 0.99999994f;
                        }
                        let _e918 = phi_1507_;
                        phi_1509_ = evaluate_Verdict(_e918, true);
                        phi_1510_ = false;
                    } else {
                        phi_1509_ = evaluate_Verdict();
                        phi_1510_ = true;
                    }
                    let _e921 = phi_1509_;
                    let _e923 = phi_1510_;
                    phi_1511_ = _e921;
                    phi_1512_ = _e923;
                }
                let _e925 = phi_1511_;
                let _e927 = phi_1512_;
                if _e927 {
                    phi_1517_ = evaluate_Verdict(_e909.visibility, _e909.is_doubted);
                } else {
                    phi_1517_ = _e925;
                }
                let _e930 = phi_1517_;
                phi_1522_ = evaluate_Verdict(_e930.visibility, _e930.is_doubted);
            } else {
                phi_1522_ = evaluate_Verdict(0.5f, true);
            }
            let _e936 = phi_1522_;
            phi_1523_ = _e936;
        }
        let _e938 = phi_1523_;
        if (_e76.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e76.first_primitive)] = _e938.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
