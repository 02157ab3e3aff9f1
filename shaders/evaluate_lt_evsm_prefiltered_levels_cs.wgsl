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
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(4) 
var<storage> levels: type_42;
@group(0) @binding(2) 
var<storage> map: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_166_: lt_bvh_traverse_Tree;
    var phi_167_: bool;
    var phi_168_: lt_bvh_traverse_Tree;
    var phi_169_: bool;
    var phi_174_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_166_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_167_ = false;
        } else {
            phi_166_ = lt_bvh_traverse_Tree();
            phi_167_ = true;
        }
        let _e66 = phi_166_;
        let _e68 = phi_167_;
        phi_168_ = _e66;
        phi_169_ = _e68;
    } else {
        phi_168_ = lt_bvh_traverse_Tree();
        phi_169_ = true;
    }
    let _e70 = phi_168_;
    let _e72 = phi_169_;
    if _e72 {
        phi_174_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_174_ = _e70;
    }
    let _e77 = phi_174_;
    return lt_bvh_traverse_Tree(_e77.root, _e77.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_201_: f32;
    var phi_202_: f32;
    var phi_203_: f32;
    var phi_216_: bool;
    var phi_220_: f32;
    var phi_232_: f32;
    var phi_237_: f32;
    var phi_259_: f32;
    var phi_264_: f32;
    var phi_265_: bool;
    var phi_266_: f32;
    var phi_267_: bool;
    var phi_271_: f32;
    var phi_309_: f32;
    var phi_322_: bool;
    var phi_326_: f32;
    var phi_339_: f32;
    var phi_344_: f32;
    var phi_366_: f32;
    var phi_371_: f32;
    var phi_372_: bool;
    var phi_373_: f32;
    var phi_374_: bool;
    var phi_378_: f32;
    var phi_416_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_203_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_202_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_201_ = 1f;
            } else {
                phi_201_ = param_5;
            }
            let _e61 = phi_201_;
            phi_202_ = _e61;
        }
        let _e63 = phi_202_;
        phi_203_ = _e63;
    }
    let _e65 = phi_203_;
    let _e67 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_216_ = true;
    } else {
        let _e71 = (42f < _e67);
        if _e71 {
        }
        phi_216_ = _e71;
    }
    let _e73 = phi_216_;
    if _e73 {
        phi_220_ = 42f;
    } else {
        phi_220_ = _e67;
    }
    let _e75 = phi_220_;
    let _e76 = (_e75 * _e65);
    if ((bitcast<u32>(_e76) & 2147483647u) > 2139095040u) {
        phi_309_ = _e76;
    } else {
        if (_e76 < -87f) {
            phi_232_ = -87f;
        } else {
            phi_232_ = _e76;
        }
        let _e82 = phi_232_;
        if (_e82 > 88f) {
            phi_237_ = 88f;
        } else {
            phi_237_ = _e82;
        }
        let _e85 = phi_237_;
        let _e87 = ((_e85 * 1.442695f) + 0.5f);
        if (_e87 > -8388608f) {
            let _e99 = f32(select(0i, select(select(i32(_e87), i32(-2147483648), (_e87 < bitcast<f32>(3472883712u))), 2147483647i, (_e87 > bitcast<f32>(1325400063u))), (_e87 == _e87)));
            if (_e99 > _e87) {
                phi_259_ = 1f;
            } else {
                phi_259_ = 0f;
            }
            let _e102 = phi_259_;
            if (_e87 < 8388608f) {
                phi_264_ = (_e99 - _e102);
                phi_265_ = false;
            } else {
                phi_264_ = f32();
                phi_265_ = true;
            }
            let _e105 = phi_264_;
            let _e107 = phi_265_;
            phi_266_ = _e105;
            phi_267_ = _e107;
        } else {
            phi_266_ = f32();
            phi_267_ = true;
        }
        let _e109 = phi_266_;
        let _e111 = phi_267_;
        if _e111 {
            phi_271_ = _e87;
        } else {
            phi_271_ = _e109;
        }
        let _e113 = phi_271_;
        let _e117 = ((_e85 - (_e113 * 0.69314575f)) - (_e113 * 0.0000014286068f));
        phi_309_ = ((((((((((((((((1f / 5040f) * _e117) + (1f / 720f)) * _e117) + (1f / 120f)) * _e117) + (1f / 24f)) * _e117) + (1f / 6f)) * _e117) + 0.5f) * _e117) + 1f) * _e117) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e113), i32(-2147483648), (_e113 < bitcast<f32>(3472883712u))), 2147483647i, (_e113 > bitcast<f32>(1325400063u))), (_e113 == _e113)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e153 = phi_309_;
    let _e155 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_322_ = true;
    } else {
        let _e159 = (42f < _e155);
        if _e159 {
        }
        phi_322_ = _e159;
    }
    let _e161 = phi_322_;
    if _e161 {
        phi_326_ = 42f;
    } else {
        phi_326_ = _e155;
    }
    let _e163 = phi_326_;
    let _e165 = (-(_e163) * _e65);
    if ((bitcast<u32>(_e165) & 2147483647u) > 2139095040u) {
        phi_416_ = _e165;
    } else {
        if (_e165 < -87f) {
            phi_339_ = -87f;
        } else {
            phi_339_ = _e165;
        }
        let _e171 = phi_339_;
        if (_e171 > 88f) {
            phi_344_ = 88f;
        } else {
            phi_344_ = _e171;
        }
        let _e174 = phi_344_;
        let _e176 = ((_e174 * 1.442695f) + 0.5f);
        if (_e176 > -8388608f) {
            let _e188 = f32(select(0i, select(select(i32(_e176), i32(-2147483648), (_e176 < bitcast<f32>(3472883712u))), 2147483647i, (_e176 > bitcast<f32>(1325400063u))), (_e176 == _e176)));
            if (_e188 > _e176) {
                phi_366_ = 1f;
            } else {
                phi_366_ = 0f;
            }
            let _e191 = phi_366_;
            if (_e176 < 8388608f) {
                phi_371_ = (_e188 - _e191);
                phi_372_ = false;
            } else {
                phi_371_ = f32();
                phi_372_ = true;
            }
            let _e194 = phi_371_;
            let _e196 = phi_372_;
            phi_373_ = _e194;
            phi_374_ = _e196;
        } else {
            phi_373_ = f32();
            phi_374_ = true;
        }
        let _e198 = phi_373_;
        let _e200 = phi_374_;
        if _e200 {
            phi_378_ = _e176;
        } else {
            phi_378_ = _e198;
        }
        let _e202 = phi_378_;
        let _e206 = ((_e174 - (_e202 * 0.69314575f)) - (_e202 * 0.0000014286068f));
        phi_416_ = ((((((((((((((((1f / 5040f) * _e206) + (1f / 720f)) * _e206) + (1f / 120f)) * _e206) + (1f / 24f)) * _e206) + (1f / 6f)) * _e206) + 0.5f) * _e206) + 1f) * _e206) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e202), i32(-2147483648), (_e202 < bitcast<f32>(3472883712u))), 2147483647i, (_e202 > bitcast<f32>(1325400063u))), (_e202 == _e202)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e242 = phi_416_;
    let _e243 = -(_e242);
    return vec4<f32>(_e153, (_e153 * _e153), _e243, (_e243 * _e243));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_438_: bool;
    var phi_442_: f32;
    var phi_466_: bool;
    var phi_470_: f32;
    var phi_482_: bool;
    var phi_489_: f32;
    var phi_502_: bool;
    var phi_506_: f32;
    var phi_530_: bool;
    var phi_534_: f32;
    var phi_546_: bool;
    var phi_553_: f32;
    var phi_564_: bool;
    var phi_568_: f32;
    var phi_583_: f32;
    var phi_584_: f32;
    var phi_585_: f32;

    let _e56 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e58 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_438_ = true;
    } else {
        let _e62 = (42f < _e58);
        if _e62 {
        }
        phi_438_ = _e62;
    }
    let _e64 = phi_438_;
    if _e64 {
        phi_442_ = 42f;
    } else {
        phi_442_ = _e58;
    }
    let _e66 = phi_442_;
    let _e68 = (*param_6).min_variance;
    let _e72 = (((_e68 * _e66) * _e66) * _e56.y);
    let _e79 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e72) & 2147483647u) > 2139095040u) {
        phi_466_ = true;
    } else {
        let _e83 = (_e72 > _e79);
        if _e83 {
        }
        phi_466_ = _e83;
    }
    let _e85 = phi_466_;
    if _e85 {
        phi_470_ = _e72;
    } else {
        phi_470_ = _e79;
    }
    let _e87 = phi_470_;
    let _e88 = (_e56.x - param_7.x);
    if (_e88 <= 0f) {
        let _e92 = ((bitcast<u32>(_e87) & 2147483647u) > 2139095040u);
        if _e92 {
        }
        phi_482_ = _e92;
    } else {
        phi_482_ = true;
    }
    let _e94 = phi_482_;
    if _e94 {
        phi_489_ = (_e87 / (_e87 + (_e88 * _e88)));
    } else {
        phi_489_ = 1f;
    }
    let _e99 = phi_489_;
    let _e101 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_502_ = true;
    } else {
        let _e105 = (42f < _e101);
        if _e105 {
        }
        phi_502_ = _e105;
    }
    let _e107 = phi_502_;
    if _e107 {
        phi_506_ = 42f;
    } else {
        phi_506_ = _e101;
    }
    let _e109 = phi_506_;
    let _e111 = (*param_6).min_variance;
    let _e115 = (((_e111 * _e109) * _e109) * _e56.w);
    let _e122 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
        phi_530_ = true;
    } else {
        let _e126 = (_e115 > _e122);
        if _e126 {
        }
        phi_530_ = _e126;
    }
    let _e128 = phi_530_;
    if _e128 {
        phi_534_ = _e115;
    } else {
        phi_534_ = _e122;
    }
    let _e130 = phi_534_;
    let _e131 = (_e56.z - param_7.z);
    if (_e131 <= 0f) {
        let _e135 = ((bitcast<u32>(_e130) & 2147483647u) > 2139095040u);
        if _e135 {
        }
        phi_546_ = _e135;
    } else {
        phi_546_ = true;
    }
    let _e137 = phi_546_;
    if _e137 {
        phi_553_ = (_e130 / (_e130 + (_e131 * _e131)));
    } else {
        phi_553_ = 1f;
    }
    let _e142 = phi_553_;
    if ((bitcast<u32>(_e142) & 2147483647u) > 2139095040u) {
        phi_564_ = true;
    } else {
        let _e146 = (_e142 < _e99);
        if _e146 {
        }
        phi_564_ = _e146;
    }
    let _e148 = phi_564_;
    if _e148 {
        phi_568_ = _e142;
    } else {
        phi_568_ = _e99;
    }
    let _e150 = phi_568_;
    if ((bitcast<u32>(_e150) & 2147483647u) > 2139095040u) {
        phi_585_ = _e150;
    } else {
        if (_e150 < 0f) {
            phi_584_ = 0f;
        } else {
            if (_e150 > 1f) {
                phi_583_ = 1f;
            } else {
                phi_583_ = _e150;
            }
            let _e157 = phi_583_;
            phi_584_ = _e157;
        }
        let _e159 = phi_584_;
        phi_585_ = _e159;
    }
    let _e161 = phi_585_;
    return _e161;
}

fn function_() {
    var local: lt_math_Evsm;
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
    var phi_768_: lt_math_LightPoint;
    var phi_771_: u32;
    var phi_773_: lt_math_LevelPoint;
    var phi_859_: bool;
    var phi_868_: bool;
    var phi_877_: bool;
    var phi_878_: bool;
    var phi_879_: bool;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_887_: bool;
    var phi_914_: bool;
    var phi_915_: bool;
    var phi_916_: bool;
    var phi_917_: bool;
    var phi_918_: bool;
    var phi_919_: bool;
    var phi_920_: bool;
    var phi_921_: bool;
    var phi_925_: bool;
    var phi_934_: lt_math_LightPoint;
    var phi_935_: u32;
    var phi_936_: lt_math_LevelPoint;
    var phi_937_: bool;
    var phi_769_: lt_math_LightPoint;
    var phi_772_: u32;
    var phi_774_: lt_math_LevelPoint;
    var phi_938_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_978_: bool;
    var phi_979_: bool;
    var phi_980_: bool;
    var phi_981_: bool;
    var phi_985_: bool;
    var phi_1067_: f32;
    var phi_1185_: f32;
    var phi_1186_: f32;
    var phi_1189_: f32;
    var phi_1218_: f32;
    var phi_1223_: f32;
    var phi_1224_: bool;
    var phi_1225_: f32;
    var phi_1226_: bool;
    var phi_1230_: f32;
    var phi_1250_: f32;
    var phi_1255_: f32;
    var phi_1256_: bool;
    var phi_1257_: f32;
    var phi_1258_: bool;
    var phi_1262_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1315_: i32;
    var phi_1320_: i32;
    var phi_1325_: i32;
    var phi_1330_: i32;
    var phi_1339_: i32;
    var phi_1344_: i32;
    var phi_1349_: i32;
    var phi_1354_: i32;
    var phi_1449_: bool;
    var phi_1457_: bool;
    var phi_1469_: bool;
    var phi_1470_: bool;
    var phi_1474_: f32;
    var phi_1480_: f32;
    var phi_1482_: evaluate_Verdict;
    var phi_1487_: evaluate_Verdict;
    var phi_1488_: evaluate_Verdict;

    let _e54 = id_1;
    let _e61 = arrayLength((&map.member));
    let _e67 = arrayLength((&levels.member));
    let _e70 = p.member.size[0u];
    let _e72 = p.member.size[1u];
    let _e73 = lt_shaders_entry_pixel_index(_e54, _e70, _e72);
    if (bitcast<i32>(_e73.root) != 0i) {
        let _e79 = p.member.level_count;
        if (_e73.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e86 = samples.member[(0u + _e73.first_primitive)].normal[0u];
        let _e88 = global[0u];
        if (_e86 == _e88) {
            let _e91 = samples.member[(0u + _e73.first_primitive)].normal[1u];
            let _e93 = global[1u];
            if (_e91 == _e93) {
                let _e96 = samples.member[(0u + _e73.first_primitive)].normal[2u];
                let _e98 = global[2u];
                phi_645_ = (_e96 == _e98);
                phi_646_ = false;
            } else {
                phi_645_ = bool();
                phi_646_ = true;
            }
            let _e101 = phi_645_;
            let _e103 = phi_646_;
            phi_647_ = _e101;
            phi_648_ = _e103;
        } else {
            phi_647_ = bool();
            phi_648_ = true;
        }
        let _e105 = phi_647_;
        let _e107 = phi_648_;
        if _e107 {
            phi_652_ = false;
        } else {
            phi_652_ = _e105;
        }
        let _e109 = phi_652_;
        if !(_e109) {
            let _e112 = samples.member[(0u + _e73.first_primitive)].position;
            let _e114 = p.member.light.place;
            let _e120 = p.member.light.place[3u];
            let _e127 = (_e114.x - (_e112.x * _e120));
            let _e128 = (_e114.y - (_e112.y * _e120));
            let _e129 = (_e114.z - (_e112.z * _e120));
            let _e131 = samples.member[(0u + _e73.first_primitive)].normal;
            if ((((_e131.x * _e127) + (_e131.y * _e128)) + (_e131.z * _e129)) > 0f) {
                let _e145 = (((_e127 * _e127) + (_e128 * _e128)) + (_e129 * _e129));
                let _e147 = p.member.light.axis;
                let _e159 = p.member.light.place[3u];
                if (_e159 == 0f) {
                    phi_723_ = true;
                } else {
                    let _e162 = p.member.light.range_squared;
                    if (_e145 <= _e162) {
                        let _e165 = p.member.light.cos_outer;
                        phi_722_ = (-((((_e127 * _e147.x) + (_e128 * _e147.y)) + (_e129 * _e147.z))) >= (_e165 * sqrt(_e145)));
                    } else {
                        phi_722_ = false;
                    }
                    let _e170 = phi_722_;
                    phi_723_ = _e170;
                }
                let _e172 = phi_723_;
                if _e172 {
                    let _e174 = samples.member[(0u + _e73.first_primitive)].flags;
                    let _e182 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e182.unnamed.visibility, false), _e182.unnamed_1);
                    phi_734_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e188.unnamed, ((_e174 & 1u) == 0u));
                    phi_735_ = false;
                } else {
                    phi_734_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_735_ = true;
                }
                let _e193 = phi_734_;
                let _e195 = phi_735_;
                phi_736_ = _e193;
                phi_737_ = _e195;
            } else {
                phi_736_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_737_ = true;
            }
            let _e197 = phi_736_;
            let _e199 = phi_737_;
            if _e199 {
                let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
                phi_744_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, true);
            } else {
                phi_744_ = _e197;
            }
            let _e216 = phi_744_;
            phi_748_ = _e216;
        } else {
            let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e222.unnamed.visibility, false), _e222.unnamed_1);
            phi_748_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e228.unnamed, true);
        }
        let _e233 = phi_748_;
        if _e233.unnamed_1 {
            phi_1488_ = evaluate_Verdict(_e233.unnamed.visibility, _e233.unnamed.is_doubted);
        } else {
            let _e241 = samples.member[(0u + _e73.first_primitive)].position;
            let _e243 = p.member.map_size;
            let _e245 = (0.5f / f32(_e243));
            let _e252 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e259 = lt_math_LightPoint(vec2<f32>(_e252.uv.x, 0f), _e252.depth, _e252.is_inside);
            let _e263 = lt_math_LightPoint(_e259.uv, 0f, _e259.is_inside);
            phi_768_ = lt_math_LightPoint();
            phi_771_ = 0u;
            phi_773_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e263.uv, _e263.depth, false));
            loop {
                let _e270 = phi_768_;
                let _e272 = phi_771_;
                let _e274 = phi_773_;
                local_1 = _e274;
                local_2 = _e274;
                local_3 = _e274;
                if (_e272 < _e79) {
                    if _e274.point.is_inside {
                        phi_934_ = lt_math_LightPoint();
                        phi_935_ = u32();
                        phi_936_ = lt_math_LevelPoint();
                        phi_937_ = false;
                    } else {
                        if (_e272 < _e67) {
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
                                phi_859_ = (_e310 <= 1f);
                            } else {
                                phi_859_ = false;
                            }
                            let _e342 = phi_859_;
                            if _e342 {
                                if (_e324 >= 0f) {
                                    phi_868_ = (_e324 <= 1f);
                                } else {
                                    phi_868_ = false;
                                }
                                let _e346 = phi_868_;
                                if _e346 {
                                    if (_e337 >= 0f) {
                                        phi_877_ = (_e337 <= 1f);
                                    } else {
                                        phi_877_ = false;
                                    }
                                    let _e350 = phi_877_;
                                    phi_878_ = _e350;
                                    phi_879_ = false;
                                } else {
                                    phi_878_ = bool();
                                    phi_879_ = true;
                                }
                                let _e352 = phi_878_;
                                let _e354 = phi_879_;
                                phi_880_ = _e352;
                                phi_881_ = _e354;
                            } else {
                                phi_880_ = bool();
                                phi_881_ = true;
                            }
                            let _e356 = phi_880_;
                            let _e358 = phi_881_;
                            phi_882_ = _e356;
                            phi_883_ = _e358;
                        } else {
                            phi_882_ = bool();
                            phi_883_ = true;
                        }
                        let _e360 = phi_882_;
                        let _e362 = phi_883_;
                        if _e362 {
                            phi_887_ = false;
                        } else {
                            phi_887_ = _e360;
                        }
                        let _e364 = phi_887_;
                        if _e364 {
                            if (_e310 >= _e245) {
                                if (_e310 <= (1f - _e245)) {
                                    if (_e324 >= _e245) {
                                        phi_914_ = (_e324 <= (1f - _e245));
                                        phi_915_ = false;
                                    } else {
                                        phi_914_ = bool();
                                        phi_915_ = true;
                                    }
                                    let _e372 = phi_914_;
                                    let _e374 = phi_915_;
                                    phi_916_ = _e372;
                                    phi_917_ = _e374;
                                } else {
                                    phi_916_ = bool();
                                    phi_917_ = true;
                                }
                                let _e376 = phi_916_;
                                let _e378 = phi_917_;
                                phi_918_ = _e376;
                                phi_919_ = _e378;
                            } else {
                                phi_918_ = bool();
                                phi_919_ = true;
                            }
                            let _e380 = phi_918_;
                            let _e382 = phi_919_;
                            phi_920_ = _e380;
                            phi_921_ = _e382;
                        } else {
                            phi_920_ = bool();
                            phi_921_ = true;
                        }
                        let _e384 = phi_920_;
                        let _e386 = phi_921_;
                        if _e386 {
                            phi_925_ = false;
                        } else {
                            phi_925_ = _e384;
                        }
                        let _e388 = phi_925_;
                        let _e395 = lt_math_LightPoint(vec2<f32>(_e310, _e270.uv.y), _e270.depth, _e270.is_inside);
                        let _e402 = lt_math_LightPoint(vec2<f32>(_e395.uv.x, _e324), _e395.depth, _e395.is_inside);
                        let _e406 = lt_math_LightPoint(_e402.uv, _e337, _e402.is_inside);
                        let _e410 = lt_math_LightPoint(_e406.uv, _e406.depth, _e388);
                        phi_934_ = _e410;
                        phi_935_ = (_e272 + 1u);
                        phi_936_ = lt_math_LevelPoint(_e272, _e410);
                        phi_937_ = true;
                    }
                    let _e414 = phi_934_;
                    let _e416 = phi_935_;
                    let _e418 = phi_936_;
                    let _e420 = phi_937_;
                    phi_769_ = _e414;
                    phi_772_ = _e416;
                    phi_774_ = _e418;
                    phi_938_ = _e420;
                } else {
                    phi_769_ = lt_math_LightPoint();
                    phi_772_ = u32();
                    phi_774_ = lt_math_LevelPoint();
                    phi_938_ = false;
                }
                let _e422 = phi_769_;
                let _e424 = phi_772_;
                let _e426 = phi_774_;
                let _e428 = phi_938_;
                continue;
                continuing {
                    phi_768_ = _e422;
                    phi_771_ = _e424;
                    phi_773_ = _e426;
                    break if !(_e428);
                }
            }
            let _e431 = local_1;
            if _e431.point.is_inside {
                if (0f > 0f) {
                    let _e437 = local_2;
                    if (_e437.level < _e67) {
                    } else {
                        return;
                    }
                    let _e442 = levels.member[(0u + _e437.level)];
                    let _e448 = global[0u];
                    if (_e442.row_w.x == _e448) {
                        let _e451 = global[1u];
                        if (_e442.row_w.y == _e451) {
                            let _e454 = global[2u];
                            phi_978_ = (_e442.row_w.z == _e454);
                            phi_979_ = false;
                        } else {
                            phi_978_ = bool();
                            phi_979_ = true;
                        }
                        let _e457 = phi_978_;
                        let _e459 = phi_979_;
                        phi_980_ = _e457;
                        phi_981_ = _e459;
                    } else {
                        phi_980_ = bool();
                        phi_981_ = true;
                    }
                    let _e461 = phi_980_;
                    let _e463 = phi_981_;
                    if _e463 {
                        phi_985_ = false;
                    } else {
                        phi_985_ = _e461;
                    }
                    let _e465 = phi_985_;
                    if _e465 {
                        let _e467 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e469 = p.member.map_size;
                        let _e539 = ((abs(((((_e442.row_x.x * _e467.x) + (_e442.row_x.y * _e467.y)) + (_e442.row_x.z * _e467.z)) / (((_e442.row_x.x * _e442.row_x.x) + (_e442.row_x.y * _e442.row_x.y)) + (_e442.row_x.z * _e442.row_x.z)))) + abs(((((_e442.row_y.x * _e467.x) + (_e442.row_y.y * _e467.y)) + (_e442.row_y.z * _e467.z)) / (((_e442.row_y.x * _e442.row_y.x) + (_e442.row_y.y * _e442.row_y.y)) + (_e442.row_y.z * _e442.row_y.z))))) / (abs(((((_e442.row_z.x * _e467.x) + (_e442.row_z.y * _e467.y)) + (_e442.row_z.z * _e467.z)) / (((_e442.row_z.x * _e442.row_z.x) + (_e442.row_z.y * _e442.row_z.y)) + (_e442.row_z.z * _e442.row_z.z)))) * f32(_e469)));
                        if (_e539 < 0.002f) {
                            phi_1067_ = _e539;
                        } else {
                            phi_1067_ = 0.002f;
                        }
                        let _e542 = phi_1067_;
                        phi_1186_ = _e542;
                    } else {
                        let _e544 = p.member.map_size;
                        let _e550 = samples.member[(0u + _e73.first_primitive)].position;
                        let _e561 = ((((_e442.row_w.x * _e550.x) + (_e442.row_w.y * _e550.y)) + (_e442.row_w.z * _e550.z)) + _e442.row_w.w);
                        let _e574 = ((_e442.row_x.x - (_e442.row_w.x * _e431.point.uv.x)) / _e561);
                        let _e575 = ((_e442.row_x.y - (_e442.row_w.y * _e431.point.uv.x)) / _e561);
                        let _e576 = ((_e442.row_x.z - (_e442.row_w.z * _e431.point.uv.x)) / _e561);
                        let _e589 = ((_e442.row_y.x - (_e442.row_w.x * _e431.point.uv.y)) / _e561);
                        let _e590 = ((_e442.row_y.y - (_e442.row_w.y * _e431.point.uv.y)) / _e561);
                        let _e591 = ((_e442.row_y.z - (_e442.row_w.z * _e431.point.uv.y)) / _e561);
                        let _e597 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e602 = ((_e590 * _e597.z) - (_e597.y * _e591));
                        let _e607 = ((_e591 * _e597.x) - (_e597.z * _e589));
                        let _e612 = ((_e589 * _e597.y) - (_e597.x * _e590));
                        let _e614 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e619 = ((_e575 * _e614.z) - (_e614.y * _e576));
                        let _e624 = ((_e576 * _e614.x) - (_e614.z * _e574));
                        let _e629 = ((_e574 * _e614.y) - (_e614.x * _e575));
                        let _e656 = ((abs(((((_e442.row_z.x * _e602) + (_e442.row_z.y * _e607)) + (_e442.row_z.z * _e612)) / (((_e574 * _e602) + (_e575 * _e607)) + (_e576 * _e612)))) + abs(((((_e442.row_z.x * _e619) + (_e442.row_z.y * _e624)) + (_e442.row_z.z * _e629)) / (((_e589 * _e619) + (_e590 * _e624)) + (_e591 * _e629))))) / f32(_e544));
                        let _e658 = (16f / f32(_e544));
                        if (_e656 < _e658) {
                            phi_1185_ = _e656;
                        } else {
                            phi_1185_ = _e658;
                        }
                        let _e661 = phi_1185_;
                        phi_1186_ = _e661;
                    }
                    let _e663 = phi_1186_;
                    phi_1189_ = (_e431.point.depth - (0f * _e663));
                } else {
                    phi_1189_ = _e431.point.depth;
                }
                let _e667 = phi_1189_;
                let _e673 = p.member.map_size;
                let _e674 = f32(_e673);
                let _e677 = ((_e431.point.uv.x * _e674) - 0.5f);
                let _e678 = ((_e431.point.uv.y * _e674) - 0.5f);
                if (_e677 > -8388608f) {
                    let _e690 = f32(select(0i, select(select(i32(_e677), i32(-2147483648), (_e677 < bitcast<f32>(3472883712u))), 2147483647i, (_e677 > bitcast<f32>(1325400063u))), (_e677 == _e677)));
                    if (_e690 > _e677) {
                        phi_1218_ = 1f;
                    } else {
                        phi_1218_ = 0f;
                    }
                    let _e693 = phi_1218_;
                    if (_e677 < 8388608f) {
                        phi_1223_ = (_e690 - _e693);
                        phi_1224_ = false;
                    } else {
                        phi_1223_ = f32();
                        phi_1224_ = true;
                    }
                    let _e696 = phi_1223_;
                    let _e698 = phi_1224_;
                    phi_1225_ = _e696;
                    phi_1226_ = _e698;
                } else {
                    phi_1225_ = f32();
                    phi_1226_ = true;
                }
                let _e700 = phi_1225_;
                let _e702 = phi_1226_;
                if _e702 {
                    phi_1230_ = _e677;
                } else {
                    phi_1230_ = _e700;
                }
                let _e704 = phi_1230_;
                if (_e678 > -8388608f) {
                    let _e716 = f32(select(0i, select(select(i32(_e678), i32(-2147483648), (_e678 < bitcast<f32>(3472883712u))), 2147483647i, (_e678 > bitcast<f32>(1325400063u))), (_e678 == _e678)));
                    if (_e716 > _e678) {
                        phi_1250_ = 1f;
                    } else {
                        phi_1250_ = 0f;
                    }
                    let _e719 = phi_1250_;
                    if (_e678 < 8388608f) {
                        phi_1255_ = (_e716 - _e719);
                        phi_1256_ = false;
                    } else {
                        phi_1255_ = f32();
                        phi_1256_ = true;
                    }
                    let _e722 = phi_1255_;
                    let _e724 = phi_1256_;
                    phi_1257_ = _e722;
                    phi_1258_ = _e724;
                } else {
                    phi_1257_ = f32();
                    phi_1258_ = true;
                }
                let _e726 = phi_1257_;
                let _e728 = phi_1258_;
                if _e728 {
                    phi_1262_ = _e678;
                } else {
                    phi_1262_ = _e726;
                }
                let _e730 = phi_1262_;
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
                let _e765 = local_3;
                local = lt_math_Evsm(_e761.positive_exponent, _e761.negative_exponent, _e761.min_variance);
                let _e772 = ((_e765.level * _e763) * _e763);
                let _e774 = (bitcast<i32>(_e763) - 1i);
                if (_e741 > 0i) {
                    phi_1315_ = _e741;
                } else {
                    phi_1315_ = 0i;
                }
                let _e777 = phi_1315_;
                if (_e750 > 0i) {
                    phi_1320_ = _e750;
                } else {
                    phi_1320_ = 0i;
                }
                let _e780 = phi_1320_;
                if (_e777 < _e774) {
                    phi_1325_ = _e777;
                } else {
                    phi_1325_ = _e774;
                }
                let _e783 = phi_1325_;
                if (_e780 < _e774) {
                    phi_1330_ = _e780;
                } else {
                    phi_1330_ = _e774;
                }
                let _e786 = phi_1330_;
                let _e787 = bitcast<u32>(_e783);
                let _e789 = (_e741 + 1i);
                let _e790 = (_e750 + 1i);
                if (_e789 > 0i) {
                    phi_1339_ = _e789;
                } else {
                    phi_1339_ = 0i;
                }
                let _e793 = phi_1339_;
                if (_e790 > 0i) {
                    phi_1344_ = _e790;
                } else {
                    phi_1344_ = 0i;
                }
                let _e796 = phi_1344_;
                if (_e793 < _e774) {
                    phi_1349_ = _e793;
                } else {
                    phi_1349_ = _e774;
                }
                let _e799 = phi_1349_;
                if (_e796 < _e774) {
                    phi_1354_ = _e796;
                } else {
                    phi_1354_ = _e774;
                }
                let _e802 = phi_1354_;
                let _e803 = bitcast<u32>(_e799);
                let _e805 = (bitcast<u32>(_e786) * _e763);
                let _e806 = (bitcast<u32>(_e802) * _e763);
                let _e811 = ((_e805 + _e787) + _e772);
                let _e812 = ((_e805 + _e803) + _e772);
                let _e813 = ((_e806 + _e787) + _e772);
                let _e814 = ((_e806 + _e803) + _e772);
                if (_e811 < _e61) {
                } else {
                    return;
                }
                let _e818 = map.member[(0u + _e811)];
                if (_e812 < _e61) {
                } else {
                    return;
                }
                let _e830 = map.member[(0u + _e812)];
                if (_e813 < _e61) {
                } else {
                    return;
                }
                let _e846 = map.member[(0u + _e813)];
                if (_e814 < _e61) {
                } else {
                    return;
                }
                let _e862 = map.member[(0u + _e814)];
                let _e876 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e818.x * _e753) + (_e830.x * _e755)) + (_e846.x * _e757)) + (_e862.x * _e758)), ((((_e818.y * _e753) + (_e830.y * _e755)) + (_e846.y * _e757)) + (_e862.y * _e758)), ((((_e818.z * _e753) + (_e830.z * _e755)) + (_e846.z * _e757)) + (_e862.z * _e758)), ((((_e818.w * _e753) + (_e830.w * _e755)) + (_e846.w * _e757)) + (_e862.w * _e758))), _e667);
                let _e878 = p.member.epsilon;
                if (_e876 <= _e878) {
                    phi_1449_ = true;
                } else {
                    phi_1449_ = (_e876 >= (1f - _e878));
                }
                let _e883 = phi_1449_;
                if ((bitcast<u32>(_e876) & 2147483647u) > 2139095040u) {
                    phi_1457_ = true;
                } else {
                    phi_1457_ = !(_e883);
                }
                let _e889 = phi_1457_;
                if _e889 {
                    if (_e876 > 0f) {
                        if (_e876 < 1f) {
                            phi_1469_ = false;
                        } else {
                            phi_1469_ = true;
                        }
                        let _e893 = phi_1469_;
                        phi_1470_ = _e893;
                    } else {
                        phi_1470_ = true;
                    }
                    let _e895 = phi_1470_;
                    if _e895 {
                        phi_1474_ = 0.5f;
                    } else {
                        phi_1474_ = _e876;
                    }
                    let _e897 = phi_1474_;
                    phi_1482_ = evaluate_Verdict(_e897, true);
                } else {
                    if (_e876 > 0.5f) {
                        phi_1480_ = 1f;
                    } else {
                        phi_1480_ = 0f;
                    }
                    let _e901 = phi_1480_;
                    phi_1482_ = evaluate_Verdict(_e901, false);
                }
                let _e904 = phi_1482_;
                phi_1487_ = evaluate_Verdict(_e904.visibility, _e904.is_doubted);
            } else {
                phi_1487_ = evaluate_Verdict(0.5f, true);
            }
            let _e910 = phi_1487_;
            phi_1488_ = _e910;
        }
        let _e912 = phi_1488_;
        if (_e73.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e73.first_primitive)] = _e912.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
