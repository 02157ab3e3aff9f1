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
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_56;
@group(0) @binding(5) 
var<storage> levels: type_50;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_181_: lt_bvh_traverse_Tree;
    var phi_182_: bool;
    var phi_183_: lt_bvh_traverse_Tree;
    var phi_184_: bool;
    var phi_189_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_181_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_182_ = false;
        } else {
            phi_181_ = lt_bvh_traverse_Tree();
            phi_182_ = true;
        }
        let _e69 = phi_181_;
        let _e71 = phi_182_;
        phi_183_ = _e69;
        phi_184_ = _e71;
    } else {
        phi_183_ = lt_bvh_traverse_Tree();
        phi_184_ = true;
    }
    let _e73 = phi_183_;
    let _e75 = phi_184_;
    if _e75 {
        phi_189_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_189_ = _e73;
    }
    let _e80 = phi_189_;
    return lt_bvh_traverse_Tree(_e80.root, _e80.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_216_: f32;
    var phi_217_: f32;
    var phi_218_: f32;
    var phi_231_: bool;
    var phi_235_: f32;
    var phi_247_: f32;
    var phi_252_: f32;
    var phi_274_: f32;
    var phi_279_: f32;
    var phi_280_: bool;
    var phi_281_: f32;
    var phi_282_: bool;
    var phi_286_: f32;
    var phi_324_: f32;
    var phi_337_: bool;
    var phi_341_: f32;
    var phi_354_: f32;
    var phi_359_: f32;
    var phi_381_: f32;
    var phi_386_: f32;
    var phi_387_: bool;
    var phi_388_: f32;
    var phi_389_: bool;
    var phi_393_: f32;
    var phi_431_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_218_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_217_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_216_ = 1f;
            } else {
                phi_216_ = param_5;
            }
            let _e64 = phi_216_;
            phi_217_ = _e64;
        }
        let _e66 = phi_217_;
        phi_218_ = _e66;
    }
    let _e68 = phi_218_;
    let _e70 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_231_ = true;
    } else {
        let _e74 = (42f < _e70);
        if _e74 {
        }
        phi_231_ = _e74;
    }
    let _e76 = phi_231_;
    if _e76 {
        phi_235_ = 42f;
    } else {
        phi_235_ = _e70;
    }
    let _e78 = phi_235_;
    let _e79 = (_e78 * _e68);
    if ((bitcast<u32>(_e79) & 2147483647u) > 2139095040u) {
        phi_324_ = _e79;
    } else {
        if (_e79 < -87f) {
            phi_247_ = -87f;
        } else {
            phi_247_ = _e79;
        }
        let _e85 = phi_247_;
        if (_e85 > 88f) {
            phi_252_ = 88f;
        } else {
            phi_252_ = _e85;
        }
        let _e88 = phi_252_;
        let _e90 = ((_e88 * 1.442695f) + 0.5f);
        if (_e90 > -8388608f) {
            let _e102 = f32(select(0i, select(select(i32(_e90), i32(-2147483648), (_e90 < bitcast<f32>(3472883712u))), 2147483647i, (_e90 > bitcast<f32>(1325400063u))), (_e90 == _e90)));
            if (_e102 > _e90) {
                phi_274_ = 1f;
            } else {
                phi_274_ = 0f;
            }
            let _e105 = phi_274_;
            if (_e90 < 8388608f) {
                phi_279_ = (_e102 - _e105);
                phi_280_ = false;
            } else {
                phi_279_ = f32();
                phi_280_ = true;
            }
            let _e108 = phi_279_;
            let _e110 = phi_280_;
            phi_281_ = _e108;
            phi_282_ = _e110;
        } else {
            phi_281_ = f32();
            phi_282_ = true;
        }
        let _e112 = phi_281_;
        let _e114 = phi_282_;
        if _e114 {
            phi_286_ = _e90;
        } else {
            phi_286_ = _e112;
        }
        let _e116 = phi_286_;
        let _e120 = ((_e88 - (_e116 * 0.69314575f)) - (_e116 * 0.0000014286068f));
        phi_324_ = ((((((((((((((((1f / 5040f) * _e120) + (1f / 720f)) * _e120) + (1f / 120f)) * _e120) + (1f / 24f)) * _e120) + (1f / 6f)) * _e120) + 0.5f) * _e120) + 1f) * _e120) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e156 = phi_324_;
    let _e158 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_337_ = true;
    } else {
        let _e162 = (42f < _e158);
        if _e162 {
        }
        phi_337_ = _e162;
    }
    let _e164 = phi_337_;
    if _e164 {
        phi_341_ = 42f;
    } else {
        phi_341_ = _e158;
    }
    let _e166 = phi_341_;
    let _e168 = (-(_e166) * _e68);
    if ((bitcast<u32>(_e168) & 2147483647u) > 2139095040u) {
        phi_431_ = _e168;
    } else {
        if (_e168 < -87f) {
            phi_354_ = -87f;
        } else {
            phi_354_ = _e168;
        }
        let _e174 = phi_354_;
        if (_e174 > 88f) {
            phi_359_ = 88f;
        } else {
            phi_359_ = _e174;
        }
        let _e177 = phi_359_;
        let _e179 = ((_e177 * 1.442695f) + 0.5f);
        if (_e179 > -8388608f) {
            let _e191 = f32(select(0i, select(select(i32(_e179), i32(-2147483648), (_e179 < bitcast<f32>(3472883712u))), 2147483647i, (_e179 > bitcast<f32>(1325400063u))), (_e179 == _e179)));
            if (_e191 > _e179) {
                phi_381_ = 1f;
            } else {
                phi_381_ = 0f;
            }
            let _e194 = phi_381_;
            if (_e179 < 8388608f) {
                phi_386_ = (_e191 - _e194);
                phi_387_ = false;
            } else {
                phi_386_ = f32();
                phi_387_ = true;
            }
            let _e197 = phi_386_;
            let _e199 = phi_387_;
            phi_388_ = _e197;
            phi_389_ = _e199;
        } else {
            phi_388_ = f32();
            phi_389_ = true;
        }
        let _e201 = phi_388_;
        let _e203 = phi_389_;
        if _e203 {
            phi_393_ = _e179;
        } else {
            phi_393_ = _e201;
        }
        let _e205 = phi_393_;
        let _e209 = ((_e177 - (_e205 * 0.69314575f)) - (_e205 * 0.0000014286068f));
        phi_431_ = ((((((((((((((((1f / 5040f) * _e209) + (1f / 720f)) * _e209) + (1f / 120f)) * _e209) + (1f / 24f)) * _e209) + (1f / 6f)) * _e209) + 0.5f) * _e209) + 1f) * _e209) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e205), i32(-2147483648), (_e205 < bitcast<f32>(3472883712u))), 2147483647i, (_e205 > bitcast<f32>(1325400063u))), (_e205 == _e205)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e245 = phi_431_;
    let _e246 = -(_e245);
    return vec4<f32>(_e156, (_e156 * _e156), _e246, (_e246 * _e246));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_453_: bool;
    var phi_457_: f32;
    var phi_481_: bool;
    var phi_485_: f32;
    var phi_497_: bool;
    var phi_504_: f32;
    var phi_517_: bool;
    var phi_521_: f32;
    var phi_545_: bool;
    var phi_549_: f32;
    var phi_561_: bool;
    var phi_568_: f32;
    var phi_579_: bool;
    var phi_583_: f32;
    var phi_598_: f32;
    var phi_599_: f32;
    var phi_600_: f32;

    let _e59 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e61 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_453_ = true;
    } else {
        let _e65 = (42f < _e61);
        if _e65 {
        }
        phi_453_ = _e65;
    }
    let _e67 = phi_453_;
    if _e67 {
        phi_457_ = 42f;
    } else {
        phi_457_ = _e61;
    }
    let _e69 = phi_457_;
    let _e71 = (*param_6).min_variance;
    let _e75 = (((_e71 * _e69) * _e69) * _e59.y);
    let _e82 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
        phi_481_ = true;
    } else {
        let _e86 = (_e75 > _e82);
        if _e86 {
        }
        phi_481_ = _e86;
    }
    let _e88 = phi_481_;
    if _e88 {
        phi_485_ = _e75;
    } else {
        phi_485_ = _e82;
    }
    let _e90 = phi_485_;
    let _e91 = (_e59.x - param_7.x);
    if (_e91 <= 0f) {
        let _e95 = ((bitcast<u32>(_e90) & 2147483647u) > 2139095040u);
        if _e95 {
        }
        phi_497_ = _e95;
    } else {
        phi_497_ = true;
    }
    let _e97 = phi_497_;
    if _e97 {
        phi_504_ = (_e90 / (_e90 + (_e91 * _e91)));
    } else {
        phi_504_ = 1f;
    }
    let _e102 = phi_504_;
    let _e104 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_517_ = true;
    } else {
        let _e108 = (42f < _e104);
        if _e108 {
        }
        phi_517_ = _e108;
    }
    let _e110 = phi_517_;
    if _e110 {
        phi_521_ = 42f;
    } else {
        phi_521_ = _e104;
    }
    let _e112 = phi_521_;
    let _e114 = (*param_6).min_variance;
    let _e118 = (((_e114 * _e112) * _e112) * _e59.w);
    let _e125 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e118) & 2147483647u) > 2139095040u) {
        phi_545_ = true;
    } else {
        let _e129 = (_e118 > _e125);
        if _e129 {
        }
        phi_545_ = _e129;
    }
    let _e131 = phi_545_;
    if _e131 {
        phi_549_ = _e118;
    } else {
        phi_549_ = _e125;
    }
    let _e133 = phi_549_;
    let _e134 = (_e59.z - param_7.z);
    if (_e134 <= 0f) {
        let _e138 = ((bitcast<u32>(_e133) & 2147483647u) > 2139095040u);
        if _e138 {
        }
        phi_561_ = _e138;
    } else {
        phi_561_ = true;
    }
    let _e140 = phi_561_;
    if _e140 {
        phi_568_ = (_e133 / (_e133 + (_e134 * _e134)));
    } else {
        phi_568_ = 1f;
    }
    let _e145 = phi_568_;
    if ((bitcast<u32>(_e145) & 2147483647u) > 2139095040u) {
        phi_579_ = true;
    } else {
        let _e149 = (_e145 < _e102);
        if _e149 {
        }
        phi_579_ = _e149;
    }
    let _e151 = phi_579_;
    if _e151 {
        phi_583_ = _e145;
    } else {
        phi_583_ = _e102;
    }
    let _e153 = phi_583_;
    if ((bitcast<u32>(_e153) & 2147483647u) > 2139095040u) {
        phi_600_ = _e153;
    } else {
        if (_e153 < 0f) {
            phi_599_ = 0f;
        } else {
            if (_e153 > 1f) {
                phi_598_ = 1f;
            } else {
                phi_598_ = _e153;
            }
            let _e160 = phi_598_;
            phi_599_ = _e160;
        }
        let _e162 = phi_599_;
        phi_600_ = _e162;
    }
    let _e164 = phi_600_;
    return _e164;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_655_: bool;
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_662_: bool;
    var phi_732_: bool;
    var phi_733_: bool;
    var phi_744_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_745_: bool;
    var phi_746_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_747_: bool;
    var phi_754_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_758_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_778_: lt_math_LightPoint;
    var phi_781_: u32;
    var phi_783_: lt_math_LevelPoint;
    var phi_869_: bool;
    var phi_878_: bool;
    var phi_887_: bool;
    var phi_888_: bool;
    var phi_889_: bool;
    var phi_890_: bool;
    var phi_891_: bool;
    var phi_892_: bool;
    var phi_893_: bool;
    var phi_897_: bool;
    var phi_924_: bool;
    var phi_925_: bool;
    var phi_926_: bool;
    var phi_927_: bool;
    var phi_928_: bool;
    var phi_929_: bool;
    var phi_930_: bool;
    var phi_931_: bool;
    var phi_935_: bool;
    var phi_944_: lt_math_LightPoint;
    var phi_945_: u32;
    var phi_946_: lt_math_LevelPoint;
    var phi_947_: bool;
    var phi_779_: lt_math_LightPoint;
    var phi_782_: u32;
    var phi_784_: lt_math_LevelPoint;
    var phi_948_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_988_: bool;
    var phi_989_: bool;
    var phi_990_: bool;
    var phi_991_: bool;
    var phi_995_: bool;
    var phi_1077_: f32;
    var phi_1193_: f32;
    var phi_1194_: f32;
    var phi_1197_: f32;
    var phi_1226_: f32;
    var phi_1231_: f32;
    var phi_1232_: bool;
    var phi_1233_: f32;
    var phi_1234_: bool;
    var phi_1238_: f32;
    var phi_1258_: f32;
    var phi_1263_: f32;
    var phi_1264_: bool;
    var phi_1265_: f32;
    var phi_1266_: bool;
    var phi_1270_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1323_: i32;
    var phi_1328_: i32;
    var phi_1333_: i32;
    var phi_1338_: i32;
    var phi_1347_: i32;
    var phi_1352_: i32;
    var phi_1357_: i32;
    var phi_1362_: i32;
    var phi_1457_: bool;
    var phi_1465_: bool;
    var phi_1477_: bool;
    var phi_1478_: bool;
    var phi_1482_: f32;
    var phi_1488_: f32;
    var phi_1490_: evaluate_Verdict;
    var phi_1495_: evaluate_Verdict;
    var phi_1496_: evaluate_Verdict;
    var phi_1500_: bool;
    var phi_1501_: u32;
    var phi_1512_: u32;

    let _e57 = id_1;
    let _e58 = local_5;
    let _e63 = arrayLength((&map.member));
    let _e68 = arrayLength((&levels.member));
    let _e71 = p.member.size[0u];
    let _e73 = p.member.size[1u];
    let _e74 = lt_shaders_entry_pixel_index(_e57, _e71, _e73);
    if (bitcast<i32>(_e74.root) != 0i) {
        let _e81 = p.member.level_count;
        let _e85 = samples.member[_e74.first_primitive].normal[0u];
        let _e87 = global[0u];
        if (_e85 == _e87) {
            let _e90 = samples.member[_e74.first_primitive].normal[1u];
            let _e92 = global[1u];
            if (_e90 == _e92) {
                let _e95 = samples.member[_e74.first_primitive].normal[2u];
                let _e97 = global[2u];
                phi_655_ = (_e95 == _e97);
                phi_656_ = false;
            } else {
                phi_655_ = bool();
                phi_656_ = true;
            }
            let _e100 = phi_655_;
            let _e102 = phi_656_;
            phi_657_ = _e100;
            phi_658_ = _e102;
        } else {
            phi_657_ = bool();
            phi_658_ = true;
        }
        let _e104 = phi_657_;
        let _e106 = phi_658_;
        if _e106 {
            phi_662_ = false;
        } else {
            phi_662_ = _e104;
        }
        let _e108 = phi_662_;
        if !(_e108) {
            let _e111 = samples.member[_e74.first_primitive].position;
            let _e113 = p.member.light.place;
            let _e119 = p.member.light.place[3u];
            let _e126 = (_e113.x - (_e111.x * _e119));
            let _e127 = (_e113.y - (_e111.y * _e119));
            let _e128 = (_e113.z - (_e111.z * _e119));
            let _e130 = samples.member[_e74.first_primitive].normal;
            if ((((_e130.x * _e126) + (_e130.y * _e127)) + (_e130.z * _e128)) > 0f) {
                let _e144 = (((_e126 * _e126) + (_e127 * _e127)) + (_e128 * _e128));
                let _e146 = p.member.light.axis;
                let _e158 = p.member.light.place[3u];
                if (_e158 == 0f) {
                    phi_733_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_732_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_732_ = false;
                    }
                    let _e169 = phi_732_;
                    phi_733_ = _e169;
                }
                let _e171 = phi_733_;
                if _e171 {
                    let _e173 = samples.member[_e74.first_primitive].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_744_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_745_ = false;
                } else {
                    phi_744_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_745_ = true;
                }
                let _e192 = phi_744_;
                let _e194 = phi_745_;
                phi_746_ = _e192;
                phi_747_ = _e194;
            } else {
                phi_746_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_747_ = true;
            }
            let _e196 = phi_746_;
            let _e198 = phi_747_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_754_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_754_ = _e196;
            }
            let _e215 = phi_754_;
            phi_758_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_758_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_758_;
        if _e232.unnamed_1 {
            phi_1496_ = evaluate_Verdict(_e232.unnamed.visibility, _e232.unnamed.is_doubted);
        } else {
            let _e240 = samples.member[_e74.first_primitive].position;
            let _e242 = p.member.map_size;
            let _e244 = (0.5f / f32(_e242));
            let _e251 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e258 = lt_math_LightPoint(vec2<f32>(_e251.uv.x, 0f), _e251.depth, _e251.is_inside);
            let _e262 = lt_math_LightPoint(_e258.uv, 0f, _e258.is_inside);
            phi_778_ = lt_math_LightPoint();
            phi_781_ = 0u;
            phi_783_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e262.uv, _e262.depth, false));
            loop {
                let _e269 = phi_778_;
                let _e271 = phi_781_;
                let _e273 = phi_783_;
                local_2 = _e273;
                local_3 = _e273;
                local_4 = _e273;
                if (_e271 < _e81) {
                    if _e273.point.is_inside {
                        phi_944_ = lt_math_LightPoint();
                        phi_945_ = u32();
                        phi_946_ = lt_math_LevelPoint();
                        phi_947_ = false;
                    } else {
                        if (_e271 < _e68) {
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
                                phi_869_ = (_e309 <= 1f);
                            } else {
                                phi_869_ = false;
                            }
                            let _e341 = phi_869_;
                            if _e341 {
                                if (_e323 >= 0f) {
                                    phi_878_ = (_e323 <= 1f);
                                } else {
                                    phi_878_ = false;
                                }
                                let _e345 = phi_878_;
                                if _e345 {
                                    if (_e336 >= 0f) {
                                        phi_887_ = (_e336 <= 1f);
                                    } else {
                                        phi_887_ = false;
                                    }
                                    let _e349 = phi_887_;
                                    phi_888_ = _e349;
                                    phi_889_ = false;
                                } else {
                                    phi_888_ = bool();
                                    phi_889_ = true;
                                }
                                let _e351 = phi_888_;
                                let _e353 = phi_889_;
                                phi_890_ = _e351;
                                phi_891_ = _e353;
                            } else {
                                phi_890_ = bool();
                                phi_891_ = true;
                            }
                            let _e355 = phi_890_;
                            let _e357 = phi_891_;
                            phi_892_ = _e355;
                            phi_893_ = _e357;
                        } else {
                            phi_892_ = bool();
                            phi_893_ = true;
                        }
                        let _e359 = phi_892_;
                        let _e361 = phi_893_;
                        if _e361 {
                            phi_897_ = false;
                        } else {
                            phi_897_ = _e359;
                        }
                        let _e363 = phi_897_;
                        if _e363 {
                            if (_e309 >= _e244) {
                                if (_e309 <= (1f - _e244)) {
                                    if (_e323 >= _e244) {
                                        phi_924_ = (_e323 <= (1f - _e244));
                                        phi_925_ = false;
                                    } else {
                                        phi_924_ = bool();
                                        phi_925_ = true;
                                    }
                                    let _e371 = phi_924_;
                                    let _e373 = phi_925_;
                                    phi_926_ = _e371;
                                    phi_927_ = _e373;
                                } else {
                                    phi_926_ = bool();
                                    phi_927_ = true;
                                }
                                let _e375 = phi_926_;
                                let _e377 = phi_927_;
                                phi_928_ = _e375;
                                phi_929_ = _e377;
                            } else {
                                phi_928_ = bool();
                                phi_929_ = true;
                            }
                            let _e379 = phi_928_;
                            let _e381 = phi_929_;
                            phi_930_ = _e379;
                            phi_931_ = _e381;
                        } else {
                            phi_930_ = bool();
                            phi_931_ = true;
                        }
                        let _e383 = phi_930_;
                        let _e385 = phi_931_;
                        if _e385 {
                            phi_935_ = false;
                        } else {
                            phi_935_ = _e383;
                        }
                        let _e387 = phi_935_;
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e309, _e269.uv.y), _e269.depth, _e269.is_inside);
                        let _e401 = lt_math_LightPoint(vec2<f32>(_e394.uv.x, _e323), _e394.depth, _e394.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e336, _e401.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e405.depth, _e387);
                        phi_944_ = _e409;
                        phi_945_ = (_e271 + 1u);
                        phi_946_ = lt_math_LevelPoint(_e271, _e409);
                        phi_947_ = true;
                    }
                    let _e413 = phi_944_;
                    let _e415 = phi_945_;
                    let _e417 = phi_946_;
                    let _e419 = phi_947_;
                    phi_779_ = _e413;
                    phi_782_ = _e415;
                    phi_784_ = _e417;
                    phi_948_ = _e419;
                } else {
                    phi_779_ = lt_math_LightPoint();
                    phi_782_ = u32();
                    phi_784_ = lt_math_LevelPoint();
                    phi_948_ = false;
                }
                let _e421 = phi_779_;
                let _e423 = phi_782_;
                let _e425 = phi_784_;
                let _e427 = phi_948_;
                continue;
                continuing {
                    phi_778_ = _e421;
                    phi_781_ = _e423;
                    phi_783_ = _e425;
                    break if !(_e427);
                }
            }
            let _e430 = local_2;
            if _e430.point.is_inside {
                if (0f > 0f) {
                    let _e436 = local_3;
                    if (_e436.level < _e68) {
                    } else {
                        return;
                    }
                    let _e441 = levels.member[(0u + _e436.level)];
                    let _e447 = global[0u];
                    if (_e441.row_w.x == _e447) {
                        let _e450 = global[1u];
                        if (_e441.row_w.y == _e450) {
                            let _e453 = global[2u];
                            phi_988_ = (_e441.row_w.z == _e453);
                            phi_989_ = false;
                        } else {
                            phi_988_ = bool();
                            phi_989_ = true;
                        }
                        let _e456 = phi_988_;
                        let _e458 = phi_989_;
                        phi_990_ = _e456;
                        phi_991_ = _e458;
                    } else {
                        phi_990_ = bool();
                        phi_991_ = true;
                    }
                    let _e460 = phi_990_;
                    let _e462 = phi_991_;
                    if _e462 {
                        phi_995_ = false;
                    } else {
                        phi_995_ = _e460;
                    }
                    let _e464 = phi_995_;
                    if _e464 {
                        let _e466 = samples.member[_e74.first_primitive].normal;
                        let _e468 = p.member.map_size;
                        let _e538 = ((abs(((((_e441.row_x.x * _e466.x) + (_e441.row_x.y * _e466.y)) + (_e441.row_x.z * _e466.z)) / (((_e441.row_x.x * _e441.row_x.x) + (_e441.row_x.y * _e441.row_x.y)) + (_e441.row_x.z * _e441.row_x.z)))) + abs(((((_e441.row_y.x * _e466.x) + (_e441.row_y.y * _e466.y)) + (_e441.row_y.z * _e466.z)) / (((_e441.row_y.x * _e441.row_y.x) + (_e441.row_y.y * _e441.row_y.y)) + (_e441.row_y.z * _e441.row_y.z))))) / (abs(((((_e441.row_z.x * _e466.x) + (_e441.row_z.y * _e466.y)) + (_e441.row_z.z * _e466.z)) / (((_e441.row_z.x * _e441.row_z.x) + (_e441.row_z.y * _e441.row_z.y)) + (_e441.row_z.z * _e441.row_z.z)))) * f32(_e468)));
                        if (_e538 < 0.002f) {
                            phi_1077_ = _e538;
                        } else {
                            phi_1077_ = 0.002f;
                        }
                        let _e541 = phi_1077_;
                        phi_1194_ = _e541;
                    } else {
                        let _e543 = p.member.map_size;
                        let _e549 = samples.member[_e74.first_primitive].position;
                        let _e560 = ((((_e441.row_w.x * _e549.x) + (_e441.row_w.y * _e549.y)) + (_e441.row_w.z * _e549.z)) + _e441.row_w.w);
                        let _e573 = ((_e441.row_x.x - (_e441.row_w.x * _e430.point.uv.x)) / _e560);
                        let _e574 = ((_e441.row_x.y - (_e441.row_w.y * _e430.point.uv.x)) / _e560);
                        let _e575 = ((_e441.row_x.z - (_e441.row_w.z * _e430.point.uv.x)) / _e560);
                        let _e588 = ((_e441.row_y.x - (_e441.row_w.x * _e430.point.uv.y)) / _e560);
                        let _e589 = ((_e441.row_y.y - (_e441.row_w.y * _e430.point.uv.y)) / _e560);
                        let _e590 = ((_e441.row_y.z - (_e441.row_w.z * _e430.point.uv.y)) / _e560);
                        let _e596 = samples.member[_e74.first_primitive].normal;
                        let _e601 = ((_e589 * _e596.z) - (_e596.y * _e590));
                        let _e606 = ((_e590 * _e596.x) - (_e596.z * _e588));
                        let _e611 = ((_e588 * _e596.y) - (_e596.x * _e589));
                        let _e613 = samples.member[_e74.first_primitive].normal;
                        let _e618 = ((_e574 * _e613.z) - (_e613.y * _e575));
                        let _e623 = ((_e575 * _e613.x) - (_e613.z * _e573));
                        let _e628 = ((_e573 * _e613.y) - (_e613.x * _e574));
                        let _e655 = ((abs(((((_e441.row_z.x * _e601) + (_e441.row_z.y * _e606)) + (_e441.row_z.z * _e611)) / (((_e573 * _e601) + (_e574 * _e606)) + (_e575 * _e611)))) + abs(((((_e441.row_z.x * _e618) + (_e441.row_z.y * _e623)) + (_e441.row_z.z * _e628)) / (((_e588 * _e618) + (_e589 * _e623)) + (_e590 * _e628))))) / f32(_e543));
                        if (_e655 < 0.002f) {
                            phi_1193_ = _e655;
                        } else {
                            phi_1193_ = 0.002f;
                        }
                        let _e658 = phi_1193_;
                        phi_1194_ = _e658;
                    }
                    let _e660 = phi_1194_;
                    phi_1197_ = (_e430.point.depth - (0f * _e660));
                } else {
                    phi_1197_ = _e430.point.depth;
                }
                let _e664 = phi_1197_;
                let _e670 = p.member.map_size;
                let _e671 = f32(_e670);
                let _e674 = ((_e430.point.uv.x * _e671) - 0.5f);
                let _e675 = ((_e430.point.uv.y * _e671) - 0.5f);
                if (_e674 > -8388608f) {
                    let _e687 = f32(select(0i, select(select(i32(_e674), i32(-2147483648), (_e674 < bitcast<f32>(3472883712u))), 2147483647i, (_e674 > bitcast<f32>(1325400063u))), (_e674 == _e674)));
                    if (_e687 > _e674) {
                        phi_1226_ = 1f;
                    } else {
                        phi_1226_ = 0f;
                    }
                    let _e690 = phi_1226_;
                    if (_e674 < 8388608f) {
                        phi_1231_ = (_e687 - _e690);
                        phi_1232_ = false;
                    } else {
                        phi_1231_ = f32();
                        phi_1232_ = true;
                    }
                    let _e693 = phi_1231_;
                    let _e695 = phi_1232_;
                    phi_1233_ = _e693;
                    phi_1234_ = _e695;
                } else {
                    phi_1233_ = f32();
                    phi_1234_ = true;
                }
                let _e697 = phi_1233_;
                let _e699 = phi_1234_;
                if _e699 {
                    phi_1238_ = _e674;
                } else {
                    phi_1238_ = _e697;
                }
                let _e701 = phi_1238_;
                if (_e675 > -8388608f) {
                    let _e713 = f32(select(0i, select(select(i32(_e675), i32(-2147483648), (_e675 < bitcast<f32>(3472883712u))), 2147483647i, (_e675 > bitcast<f32>(1325400063u))), (_e675 == _e675)));
                    if (_e713 > _e675) {
                        phi_1258_ = 1f;
                    } else {
                        phi_1258_ = 0f;
                    }
                    let _e716 = phi_1258_;
                    if (_e675 < 8388608f) {
                        phi_1263_ = (_e713 - _e716);
                        phi_1264_ = false;
                    } else {
                        phi_1263_ = f32();
                        phi_1264_ = true;
                    }
                    let _e719 = phi_1263_;
                    let _e721 = phi_1264_;
                    phi_1265_ = _e719;
                    phi_1266_ = _e721;
                } else {
                    phi_1265_ = f32();
                    phi_1266_ = true;
                }
                let _e723 = phi_1265_;
                let _e725 = phi_1266_;
                if _e725 {
                    phi_1270_ = _e675;
                } else {
                    phi_1270_ = _e723;
                }
                let _e727 = phi_1270_;
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
                let _e762 = local_4;
                local_1 = lt_math_Evsm(_e758.positive_exponent, _e758.negative_exponent, _e758.min_variance);
                let _e769 = ((_e762.level * _e760) * _e760);
                let _e771 = (bitcast<i32>(_e760) - 1i);
                if (_e738 > 0i) {
                    phi_1323_ = _e738;
                } else {
                    phi_1323_ = 0i;
                }
                let _e774 = phi_1323_;
                if (_e747 > 0i) {
                    phi_1328_ = _e747;
                } else {
                    phi_1328_ = 0i;
                }
                let _e777 = phi_1328_;
                if (_e774 < _e771) {
                    phi_1333_ = _e774;
                } else {
                    phi_1333_ = _e771;
                }
                let _e780 = phi_1333_;
                if (_e777 < _e771) {
                    phi_1338_ = _e777;
                } else {
                    phi_1338_ = _e771;
                }
                let _e783 = phi_1338_;
                let _e784 = bitcast<u32>(_e780);
                let _e786 = (_e738 + 1i);
                let _e787 = (_e747 + 1i);
                if (_e786 > 0i) {
                    phi_1347_ = _e786;
                } else {
                    phi_1347_ = 0i;
                }
                let _e790 = phi_1347_;
                if (_e787 > 0i) {
                    phi_1352_ = _e787;
                } else {
                    phi_1352_ = 0i;
                }
                let _e793 = phi_1352_;
                if (_e790 < _e771) {
                    phi_1357_ = _e790;
                } else {
                    phi_1357_ = _e771;
                }
                let _e796 = phi_1357_;
                if (_e793 < _e771) {
                    phi_1362_ = _e793;
                } else {
                    phi_1362_ = _e771;
                }
                let _e799 = phi_1362_;
                let _e800 = bitcast<u32>(_e796);
                let _e802 = (bitcast<u32>(_e783) * _e760);
                let _e803 = (bitcast<u32>(_e799) * _e760);
                let _e808 = ((_e802 + _e784) + _e769);
                let _e809 = ((_e802 + _e800) + _e769);
                let _e810 = ((_e803 + _e784) + _e769);
                let _e811 = ((_e803 + _e800) + _e769);
                if (_e808 < _e63) {
                } else {
                    return;
                }
                let _e815 = map.member[(0u + _e808)];
                if (_e809 < _e63) {
                } else {
                    return;
                }
                let _e827 = map.member[(0u + _e809)];
                if (_e810 < _e63) {
                } else {
                    return;
                }
                let _e843 = map.member[(0u + _e810)];
                if (_e811 < _e63) {
                } else {
                    return;
                }
                let _e859 = map.member[(0u + _e811)];
                let _e873 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e815.x * _e750) + (_e827.x * _e752)) + (_e843.x * _e754)) + (_e859.x * _e755)), ((((_e815.y * _e750) + (_e827.y * _e752)) + (_e843.y * _e754)) + (_e859.y * _e755)), ((((_e815.z * _e750) + (_e827.z * _e752)) + (_e843.z * _e754)) + (_e859.z * _e755)), ((((_e815.w * _e750) + (_e827.w * _e752)) + (_e843.w * _e754)) + (_e859.w * _e755))), _e664);
                let _e875 = p.member.epsilon;
                if (_e873 <= _e875) {
                    phi_1457_ = true;
                } else {
                    phi_1457_ = (_e873 >= (1f - _e875));
                }
                let _e880 = phi_1457_;
                if ((bitcast<u32>(_e873) & 2147483647u) > 2139095040u) {
                    phi_1465_ = true;
                } else {
                    phi_1465_ = !(_e880);
                }
                let _e886 = phi_1465_;
                if _e886 {
                    if (_e873 > 0f) {
                        if (_e873 < 1f) {
                            phi_1477_ = false;
                        } else {
                            phi_1477_ = true;
                        }
                        let _e890 = phi_1477_;
                        phi_1478_ = _e890;
                    } else {
                        phi_1478_ = true;
                    }
                    let _e892 = phi_1478_;
                    if _e892 {
                        phi_1482_ = 0.5f;
                    } else {
                        phi_1482_ = _e873;
                    }
                    let _e894 = phi_1482_;
                    phi_1490_ = evaluate_Verdict(_e894, true);
                } else {
                    if (_e873 > 0.5f) {
                        phi_1488_ = 1f;
                    } else {
                        phi_1488_ = 0f;
                    }
                    let _e898 = phi_1488_;
                    phi_1490_ = evaluate_Verdict(_e898, false);
                }
                let _e901 = phi_1490_;
                phi_1495_ = evaluate_Verdict(_e901.visibility, _e901.is_doubted);
            } else {
                phi_1495_ = evaluate_Verdict(0.5f, true);
            }
            let _e907 = phi_1495_;
            phi_1496_ = _e907;
        }
        let _e909 = phi_1496_;
        visibility.member[_e74.first_primitive] = _e909.visibility;
        phi_1500_ = _e909.is_doubted;
        phi_1501_ = _e74.first_primitive;
    } else {
        phi_1500_ = false;
        phi_1501_ = 0u;
    }
    let _e914 = phi_1500_;
    let _e916 = phi_1501_;
    if (_e58 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e914 {
        let _e920 = atomicAdd((&shared_[0u]), 1u);
        phi_1512_ = _e920;
    } else {
        phi_1512_ = 0u;
    }
    let _e922 = phi_1512_;
    workgroupBarrier();
    if (_e58 == 0u) {
        let _e926 = atomicLoad((&shared_[0u]));
        let _e927 = atomicAdd((&list.member[3u]), _e926);
        atomicStore((&shared_[1u]), _e927);
    }
    workgroupBarrier();
    if _e914 {
        let _e930 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e930) + _e922)]), _e916);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
