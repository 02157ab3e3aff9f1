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
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_41 {
    member: abi_ShadowParams,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct type_49 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_41;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_49;
@group(0) @binding(2) 
var<storage> map: type_37;

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
        let _e64 = phi_164_;
        let _e66 = phi_165_;
        phi_166_ = _e64;
        phi_167_ = _e66;
    } else {
        phi_166_ = lt_bvh_traverse_Tree();
        phi_167_ = true;
    }
    let _e68 = phi_166_;
    let _e70 = phi_167_;
    if _e70 {
        phi_172_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_172_ = _e68;
    }
    let _e75 = phi_172_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
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
            let _e59 = phi_199_;
            phi_200_ = _e59;
        }
        let _e61 = phi_200_;
        phi_201_ = _e61;
    }
    let _e63 = phi_201_;
    let _e65 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_214_ = true;
    } else {
        let _e69 = (42f < _e65);
        if _e69 {
        }
        phi_214_ = _e69;
    }
    let _e71 = phi_214_;
    if _e71 {
        phi_218_ = 42f;
    } else {
        phi_218_ = _e65;
    }
    let _e73 = phi_218_;
    let _e74 = (_e73 * _e63);
    if ((bitcast<u32>(_e74) & 2147483647u) > 2139095040u) {
        phi_307_ = _e74;
    } else {
        if (_e74 < -87f) {
            phi_230_ = -87f;
        } else {
            phi_230_ = _e74;
        }
        let _e80 = phi_230_;
        if (_e80 > 88f) {
            phi_235_ = 88f;
        } else {
            phi_235_ = _e80;
        }
        let _e83 = phi_235_;
        let _e85 = ((_e83 * 1.442695f) + 0.5f);
        if (_e85 > -8388608f) {
            let _e97 = f32(select(0i, select(select(i32(_e85), i32(-2147483648), (_e85 < bitcast<f32>(3472883712u))), 2147483647i, (_e85 > bitcast<f32>(1325400063u))), (_e85 == _e85)));
            if (_e97 > _e85) {
                phi_257_ = 1f;
            } else {
                phi_257_ = 0f;
            }
            let _e100 = phi_257_;
            if (_e85 < 8388608f) {
                phi_262_ = (_e97 - _e100);
                phi_263_ = false;
            } else {
                phi_262_ = f32();
                phi_263_ = true;
            }
            let _e103 = phi_262_;
            let _e105 = phi_263_;
            phi_264_ = _e103;
            phi_265_ = _e105;
        } else {
            phi_264_ = f32();
            phi_265_ = true;
        }
        let _e107 = phi_264_;
        let _e109 = phi_265_;
        if _e109 {
            phi_269_ = _e85;
        } else {
            phi_269_ = _e107;
        }
        let _e111 = phi_269_;
        let _e115 = ((_e83 - (_e111 * 0.69314575f)) - (_e111 * 0.0000014286068f));
        phi_307_ = ((((((((((((((((1f / 5040f) * _e115) + (1f / 720f)) * _e115) + (1f / 120f)) * _e115) + (1f / 24f)) * _e115) + (1f / 6f)) * _e115) + 0.5f) * _e115) + 1f) * _e115) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e111), i32(-2147483648), (_e111 < bitcast<f32>(3472883712u))), 2147483647i, (_e111 > bitcast<f32>(1325400063u))), (_e111 == _e111)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e151 = phi_307_;
    let _e153 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_320_ = true;
    } else {
        let _e157 = (42f < _e153);
        if _e157 {
        }
        phi_320_ = _e157;
    }
    let _e159 = phi_320_;
    if _e159 {
        phi_324_ = 42f;
    } else {
        phi_324_ = _e153;
    }
    let _e161 = phi_324_;
    let _e163 = (-(_e161) * _e63);
    if ((bitcast<u32>(_e163) & 2147483647u) > 2139095040u) {
        phi_414_ = _e163;
    } else {
        if (_e163 < -87f) {
            phi_337_ = -87f;
        } else {
            phi_337_ = _e163;
        }
        let _e169 = phi_337_;
        if (_e169 > 88f) {
            phi_342_ = 88f;
        } else {
            phi_342_ = _e169;
        }
        let _e172 = phi_342_;
        let _e174 = ((_e172 * 1.442695f) + 0.5f);
        if (_e174 > -8388608f) {
            let _e186 = f32(select(0i, select(select(i32(_e174), i32(-2147483648), (_e174 < bitcast<f32>(3472883712u))), 2147483647i, (_e174 > bitcast<f32>(1325400063u))), (_e174 == _e174)));
            if (_e186 > _e174) {
                phi_364_ = 1f;
            } else {
                phi_364_ = 0f;
            }
            let _e189 = phi_364_;
            if (_e174 < 8388608f) {
                phi_369_ = (_e186 - _e189);
                phi_370_ = false;
            } else {
                phi_369_ = f32();
                phi_370_ = true;
            }
            let _e192 = phi_369_;
            let _e194 = phi_370_;
            phi_371_ = _e192;
            phi_372_ = _e194;
        } else {
            phi_371_ = f32();
            phi_372_ = true;
        }
        let _e196 = phi_371_;
        let _e198 = phi_372_;
        if _e198 {
            phi_376_ = _e174;
        } else {
            phi_376_ = _e196;
        }
        let _e200 = phi_376_;
        let _e204 = ((_e172 - (_e200 * 0.69314575f)) - (_e200 * 0.0000014286068f));
        phi_414_ = ((((((((((((((((1f / 5040f) * _e204) + (1f / 720f)) * _e204) + (1f / 120f)) * _e204) + (1f / 24f)) * _e204) + (1f / 6f)) * _e204) + 0.5f) * _e204) + 1f) * _e204) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e200), i32(-2147483648), (_e200 < bitcast<f32>(3472883712u))), 2147483647i, (_e200 > bitcast<f32>(1325400063u))), (_e200 == _e200)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e240 = phi_414_;
    let _e241 = -(_e240);
    return vec4<f32>(_e151, (_e151 * _e151), _e241, (_e241 * _e241));
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

    let _e54 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e56 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_436_ = true;
    } else {
        let _e60 = (42f < _e56);
        if _e60 {
        }
        phi_436_ = _e60;
    }
    let _e62 = phi_436_;
    if _e62 {
        phi_440_ = 42f;
    } else {
        phi_440_ = _e56;
    }
    let _e64 = phi_440_;
    let _e66 = (*param_6).min_variance;
    let _e70 = (((_e66 * _e64) * _e64) * _e54.y);
    let _e77 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
        phi_464_ = true;
    } else {
        let _e81 = (_e70 > _e77);
        if _e81 {
        }
        phi_464_ = _e81;
    }
    let _e83 = phi_464_;
    if _e83 {
        phi_468_ = _e70;
    } else {
        phi_468_ = _e77;
    }
    let _e85 = phi_468_;
    let _e86 = (_e54.x - param_7.x);
    if (_e86 <= 0f) {
        let _e90 = ((bitcast<u32>(_e85) & 2147483647u) > 2139095040u);
        if _e90 {
        }
        phi_480_ = _e90;
    } else {
        phi_480_ = true;
    }
    let _e92 = phi_480_;
    if _e92 {
        phi_487_ = (_e85 / (_e85 + (_e86 * _e86)));
    } else {
        phi_487_ = 1f;
    }
    let _e97 = phi_487_;
    let _e99 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_500_ = true;
    } else {
        let _e103 = (42f < _e99);
        if _e103 {
        }
        phi_500_ = _e103;
    }
    let _e105 = phi_500_;
    if _e105 {
        phi_504_ = 42f;
    } else {
        phi_504_ = _e99;
    }
    let _e107 = phi_504_;
    let _e109 = (*param_6).min_variance;
    let _e113 = (((_e109 * _e107) * _e107) * _e54.w);
    let _e120 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e113) & 2147483647u) > 2139095040u) {
        phi_528_ = true;
    } else {
        let _e124 = (_e113 > _e120);
        if _e124 {
        }
        phi_528_ = _e124;
    }
    let _e126 = phi_528_;
    if _e126 {
        phi_532_ = _e113;
    } else {
        phi_532_ = _e120;
    }
    let _e128 = phi_532_;
    let _e129 = (_e54.z - param_7.z);
    if (_e129 <= 0f) {
        let _e133 = ((bitcast<u32>(_e128) & 2147483647u) > 2139095040u);
        if _e133 {
        }
        phi_544_ = _e133;
    } else {
        phi_544_ = true;
    }
    let _e135 = phi_544_;
    if _e135 {
        phi_551_ = (_e128 / (_e128 + (_e129 * _e129)));
    } else {
        phi_551_ = 1f;
    }
    let _e140 = phi_551_;
    if ((bitcast<u32>(_e140) & 2147483647u) > 2139095040u) {
        phi_562_ = true;
    } else {
        let _e144 = (_e140 < _e97);
        if _e144 {
        }
        phi_562_ = _e144;
    }
    let _e146 = phi_562_;
    if _e146 {
        phi_566_ = _e140;
    } else {
        phi_566_ = _e97;
    }
    let _e148 = phi_566_;
    if ((bitcast<u32>(_e148) & 2147483647u) > 2139095040u) {
        phi_583_ = _e148;
    } else {
        if (_e148 < 0f) {
            phi_582_ = 0f;
        } else {
            if (_e148 > 1f) {
                phi_581_ = 1f;
            } else {
                phi_581_ = _e148;
            }
            let _e155 = phi_581_;
            phi_582_ = _e155;
        }
        let _e157 = phi_582_;
        phi_583_ = _e157;
    }
    let _e159 = phi_583_;
    return _e159;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_632_: bool;
    var phi_633_: bool;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_639_: bool;
    var phi_683_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_687_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_764_: bool;
    var phi_773_: bool;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_785_: bool;
    var phi_786_: bool;
    var phi_787_: bool;
    var phi_788_: bool;
    var phi_792_: bool;
    var phi_886_: f32;
    var phi_889_: f32;
    var phi_918_: f32;
    var phi_923_: f32;
    var phi_924_: bool;
    var phi_925_: f32;
    var phi_926_: bool;
    var phi_930_: f32;
    var phi_950_: f32;
    var phi_955_: f32;
    var phi_956_: bool;
    var phi_957_: f32;
    var phi_958_: bool;
    var phi_962_: f32;
    var phi_1012_: i32;
    var phi_1017_: i32;
    var phi_1022_: i32;
    var phi_1027_: i32;
    var phi_1036_: i32;
    var phi_1041_: i32;
    var phi_1046_: i32;
    var phi_1051_: i32;
    var phi_1142_: bool;
    var phi_1150_: bool;
    var phi_1162_: bool;
    var phi_1163_: bool;
    var phi_1167_: f32;
    var phi_1173_: f32;
    var phi_1175_: evaluate_Verdict;
    var phi_1180_: evaluate_Verdict;
    var phi_1181_: evaluate_Verdict;
    var phi_1185_: bool;
    var phi_1186_: u32;
    var phi_1197_: u32;

    let _e52 = id_1;
    let _e53 = local_2;
    let _e58 = arrayLength((&map.member));
    let _e63 = p.member.size[0u];
    let _e65 = p.member.size[1u];
    let _e66 = lt_shaders_entry_pixel_index(_e52, _e63, _e65);
    if (bitcast<i32>(_e66.root) != 0i) {
        let _e73 = p.member.light;
        let _e76 = samples.member[_e66.first_primitive].normal[0u];
        let _e78 = global[0u];
        if (_e76 == _e78) {
            let _e81 = samples.member[_e66.first_primitive].normal[1u];
            let _e83 = global[1u];
            if (_e81 == _e83) {
                let _e86 = samples.member[_e66.first_primitive].normal[2u];
                let _e88 = global[2u];
                phi_632_ = (_e86 == _e88);
                phi_633_ = false;
            } else {
                phi_632_ = bool();
                phi_633_ = true;
            }
            let _e91 = phi_632_;
            let _e93 = phi_633_;
            phi_634_ = _e91;
            phi_635_ = _e93;
        } else {
            phi_634_ = bool();
            phi_635_ = true;
        }
        let _e95 = phi_634_;
        let _e97 = phi_635_;
        if _e97 {
            phi_639_ = false;
        } else {
            phi_639_ = _e95;
        }
        let _e99 = phi_639_;
        if !(_e99) {
            let _e102 = samples.member[_e66.first_primitive].normal;
            let _e104 = samples.member[_e66.first_primitive].position;
            if ((((_e102.x * (_e73.x - (_e104.x * _e73.w))) + (_e102.y * (_e73.y - (_e104.y * _e73.w)))) + (_e102.z * (_e73.z - (_e104.z * _e73.w)))) > 0f) {
                let _e128 = samples.member[_e66.first_primitive].flags;
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e136.unnamed.visibility, false), _e136.unnamed_1);
                phi_683_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e142.unnamed, ((_e128 & 1u) == 0u));
            } else {
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e151.unnamed.visibility, false), _e151.unnamed_1);
                phi_683_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e157.unnamed, true);
            }
            let _e162 = phi_683_;
            phi_687_ = _e162;
        } else {
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
            phi_687_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
        }
        let _e179 = phi_687_;
        if _e179.unnamed_1 {
            phi_1181_ = evaluate_Verdict(_e179.unnamed.visibility, _e179.unnamed.is_doubted);
        } else {
            let _e187 = samples.member[_e66.first_primitive].position;
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
                    phi_764_ = (_e218 <= 1f);
                } else {
                    phi_764_ = false;
                }
                let _e250 = phi_764_;
                if _e250 {
                    if (_e232 >= 0f) {
                        phi_773_ = (_e232 <= 1f);
                    } else {
                        phi_773_ = false;
                    }
                    let _e254 = phi_773_;
                    if _e254 {
                        if (_e245 >= 0f) {
                            phi_782_ = (_e245 <= 1f);
                        } else {
                            phi_782_ = false;
                        }
                        let _e258 = phi_782_;
                        phi_783_ = _e258;
                        phi_784_ = false;
                    } else {
                        phi_783_ = bool();
                        phi_784_ = true;
                    }
                    let _e260 = phi_783_;
                    let _e262 = phi_784_;
                    phi_785_ = _e260;
                    phi_786_ = _e262;
                } else {
                    phi_785_ = bool();
                    phi_786_ = true;
                }
                let _e264 = phi_785_;
                let _e266 = phi_786_;
                phi_787_ = _e264;
                phi_788_ = _e266;
            } else {
                phi_787_ = bool();
                phi_788_ = true;
            }
            let _e268 = phi_787_;
            let _e270 = phi_788_;
            if _e270 {
                phi_792_ = false;
            } else {
                phi_792_ = _e268;
            }
            let _e272 = phi_792_;
            if _e272 {
                if (0f > 0f) {
                    let _e275 = samples.member[_e66.first_primitive].normal;
                    let _e277 = p.member.map_size;
                    let _e280 = p.member.projection.row_x;
                    let _e302 = p.member.projection.row_y;
                    let _e324 = p.member.projection.row_z;
                    let _e351 = ((abs(((((_e280.x * _e275.x) + (_e280.y * _e275.y)) + (_e280.z * _e275.z)) / (((_e280.x * _e280.x) + (_e280.y * _e280.y)) + (_e280.z * _e280.z)))) + abs(((((_e302.x * _e275.x) + (_e302.y * _e275.y)) + (_e302.z * _e275.z)) / (((_e302.x * _e302.x) + (_e302.y * _e302.y)) + (_e302.z * _e302.z))))) / (abs(((((_e324.x * _e275.x) + (_e324.y * _e275.y)) + (_e324.z * _e275.z)) / (((_e324.x * _e324.x) + (_e324.y * _e324.y)) + (_e324.z * _e324.z)))) * f32(_e277)));
                    if (_e351 < 0.002f) {
                        phi_886_ = _e351;
                    } else {
                        phi_886_ = 0.002f;
                    }
                    let _e354 = phi_886_;
                    phi_889_ = (_e245 - (0f * _e354));
                } else {
                    phi_889_ = _e245;
                }
                let _e358 = phi_889_;
                let _e360 = p.member.map_size;
                let _e361 = f32(_e360);
                let _e364 = ((_e218 * _e361) - 0.5f);
                let _e365 = ((_e232 * _e361) - 0.5f);
                if (_e364 > -8388608f) {
                    let _e377 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e377 > _e364) {
                        phi_918_ = 1f;
                    } else {
                        phi_918_ = 0f;
                    }
                    let _e380 = phi_918_;
                    if (_e364 < 8388608f) {
                        phi_923_ = (_e377 - _e380);
                        phi_924_ = false;
                    } else {
                        phi_923_ = f32();
                        phi_924_ = true;
                    }
                    let _e383 = phi_923_;
                    let _e385 = phi_924_;
                    phi_925_ = _e383;
                    phi_926_ = _e385;
                } else {
                    phi_925_ = f32();
                    phi_926_ = true;
                }
                let _e387 = phi_925_;
                let _e389 = phi_926_;
                if _e389 {
                    phi_930_ = _e364;
                } else {
                    phi_930_ = _e387;
                }
                let _e391 = phi_930_;
                if (_e365 > -8388608f) {
                    let _e403 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e403 > _e365) {
                        phi_950_ = 1f;
                    } else {
                        phi_950_ = 0f;
                    }
                    let _e406 = phi_950_;
                    if (_e365 < 8388608f) {
                        phi_955_ = (_e403 - _e406);
                        phi_956_ = false;
                    } else {
                        phi_955_ = f32();
                        phi_956_ = true;
                    }
                    let _e409 = phi_955_;
                    let _e411 = phi_956_;
                    phi_957_ = _e409;
                    phi_958_ = _e411;
                } else {
                    phi_957_ = f32();
                    phi_958_ = true;
                }
                let _e413 = phi_957_;
                let _e415 = phi_958_;
                if _e415 {
                    phi_962_ = _e365;
                } else {
                    phi_962_ = _e413;
                }
                let _e417 = phi_962_;
                let _e418 = (_e364 - _e391);
                let _e419 = (_e365 - _e417);
                let _e428 = select(0i, select(select(i32(_e391), i32(-2147483648), (_e391 < bitcast<f32>(3472883712u))), 2147483647i, (_e391 > bitcast<f32>(1325400063u))), (_e391 == _e391));
                let _e437 = select(0i, select(select(i32(_e417), i32(-2147483648), (_e417 < bitcast<f32>(3472883712u))), 2147483647i, (_e417 > bitcast<f32>(1325400063u))), (_e417 == _e417));
                let _e440 = ((1f - _e418) * (1f - _e419));
                let _e442 = (_e418 * (1f - _e419));
                let _e444 = ((1f - _e418) * _e419);
                let _e445 = (_e418 * _e419);
                let _e447 = p.member.test;
                let _e448 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e447);
                let _e450 = p.member.map_size;
                local_1 = lt_math_Evsm(_e448.positive_exponent, _e448.negative_exponent, _e448.min_variance);
                let _e456 = (bitcast<i32>(_e450) - 1i);
                if (_e428 > 0i) {
                    phi_1012_ = _e428;
                } else {
                    phi_1012_ = 0i;
                }
                let _e459 = phi_1012_;
                if (_e437 > 0i) {
                    phi_1017_ = _e437;
                } else {
                    phi_1017_ = 0i;
                }
                let _e462 = phi_1017_;
                if (_e459 < _e456) {
                    phi_1022_ = _e459;
                } else {
                    phi_1022_ = _e456;
                }
                let _e465 = phi_1022_;
                if (_e462 < _e456) {
                    phi_1027_ = _e462;
                } else {
                    phi_1027_ = _e456;
                }
                let _e468 = phi_1027_;
                let _e469 = bitcast<u32>(_e465);
                let _e471 = (_e428 + 1i);
                let _e472 = (_e437 + 1i);
                if (_e471 > 0i) {
                    phi_1036_ = _e471;
                } else {
                    phi_1036_ = 0i;
                }
                let _e475 = phi_1036_;
                if (_e472 > 0i) {
                    phi_1041_ = _e472;
                } else {
                    phi_1041_ = 0i;
                }
                let _e478 = phi_1041_;
                if (_e475 < _e456) {
                    phi_1046_ = _e475;
                } else {
                    phi_1046_ = _e456;
                }
                let _e481 = phi_1046_;
                if (_e478 < _e456) {
                    phi_1051_ = _e478;
                } else {
                    phi_1051_ = _e456;
                }
                let _e484 = phi_1051_;
                let _e485 = bitcast<u32>(_e481);
                let _e487 = (bitcast<u32>(_e468) * _e450);
                let _e488 = (bitcast<u32>(_e484) * _e450);
                let _e489 = (_e487 + _e469);
                let _e490 = (_e487 + _e485);
                let _e491 = (_e488 + _e469);
                let _e492 = (_e488 + _e485);
                if (_e489 < _e58) {
                } else {
                    return;
                }
                let _e496 = map.member[(0u + _e489)];
                if (_e490 < _e58) {
                } else {
                    return;
                }
                let _e508 = map.member[(0u + _e490)];
                if (_e491 < _e58) {
                } else {
                    return;
                }
                let _e524 = map.member[(0u + _e491)];
                if (_e492 < _e58) {
                } else {
                    return;
                }
                let _e540 = map.member[(0u + _e492)];
                let _e554 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e496.x * _e440) + (_e508.x * _e442)) + (_e524.x * _e444)) + (_e540.x * _e445)), ((((_e496.y * _e440) + (_e508.y * _e442)) + (_e524.y * _e444)) + (_e540.y * _e445)), ((((_e496.z * _e440) + (_e508.z * _e442)) + (_e524.z * _e444)) + (_e540.z * _e445)), ((((_e496.w * _e440) + (_e508.w * _e442)) + (_e524.w * _e444)) + (_e540.w * _e445))), _e358);
                let _e556 = p.member.epsilon;
                if (_e554 <= _e556) {
                    phi_1142_ = true;
                } else {
                    phi_1142_ = (_e554 >= (1f - _e556));
                }
                let _e561 = phi_1142_;
                if ((bitcast<u32>(_e554) & 2147483647u) > 2139095040u) {
                    phi_1150_ = true;
                } else {
                    phi_1150_ = !(_e561);
                }
                let _e567 = phi_1150_;
                if _e567 {
                    if (_e554 > 0f) {
                        if (_e554 < 1f) {
                            phi_1162_ = false;
                        } else {
                            phi_1162_ = true;
                        }
                        let _e571 = phi_1162_;
                        phi_1163_ = _e571;
                    } else {
                        phi_1163_ = true;
                    }
                    let _e573 = phi_1163_;
                    if _e573 {
                        phi_1167_ = 0.5f;
                    } else {
                        phi_1167_ = _e554;
                    }
                    let _e575 = phi_1167_;
                    phi_1175_ = evaluate_Verdict(_e575, true);
                } else {
                    if (_e554 > 0.5f) {
                        phi_1173_ = 1f;
                    } else {
                        phi_1173_ = 0f;
                    }
                    let _e579 = phi_1173_;
                    phi_1175_ = evaluate_Verdict(_e579, false);
                }
                let _e582 = phi_1175_;
                phi_1180_ = evaluate_Verdict(_e582.visibility, _e582.is_doubted);
            } else {
                phi_1180_ = evaluate_Verdict(0.5f, true);
            }
            let _e588 = phi_1180_;
            phi_1181_ = _e588;
        }
        let _e590 = phi_1181_;
        visibility.member[_e66.first_primitive] = _e590.visibility;
        phi_1185_ = _e590.is_doubted;
        phi_1186_ = _e66.first_primitive;
    } else {
        phi_1185_ = false;
        phi_1186_ = 0u;
    }
    let _e595 = phi_1185_;
    let _e597 = phi_1186_;
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e595 {
        let _e601 = atomicAdd((&shared_[0u]), 1u);
        phi_1197_ = _e601;
    } else {
        phi_1197_ = 0u;
    }
    let _e603 = phi_1197_;
    workgroupBarrier();
    if (_e53 == 0u) {
        let _e607 = atomicLoad((&shared_[0u]));
        let _e608 = atomicAdd((&list.member[3u]), _e607);
        atomicStore((&shared_[1u]), _e608);
    }
    workgroupBarrier();
    if _e595 {
        let _e611 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e611) + _e603)]), _e597);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
