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

struct type_19 {
    member: array<abi_Sample>,
}

struct type_23 {
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

struct type_34 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_19;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_34;
@group(0) @binding(2) 
var<storage> map: type_23;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_23;
@group(0) @binding(4) 
var<storage> marks: type_9;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_148_: lt_bvh_traverse_Tree;
    var phi_149_: bool;
    var phi_150_: lt_bvh_traverse_Tree;
    var phi_151_: bool;
    var phi_156_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_148_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_149_ = false;
        } else {
            phi_148_ = lt_bvh_traverse_Tree();
            phi_149_ = true;
        }
        let _e52 = phi_148_;
        let _e54 = phi_149_;
        phi_150_ = _e52;
        phi_151_ = _e54;
    } else {
        phi_150_ = lt_bvh_traverse_Tree();
        phi_151_ = true;
    }
    let _e56 = phi_150_;
    let _e58 = phi_151_;
    if _e58 {
        phi_156_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_156_ = _e56;
    }
    let _e63 = phi_156_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_182_: f32;
    var phi_183_: f32;
    var phi_184_: f32;
    var phi_200_: f32;
    var phi_201_: f32;
    var phi_202_: f32;
    var phi_218_: f32;
    var phi_219_: f32;
    var phi_220_: f32;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_238_: f32;
    var phi_254_: f32;
    var phi_255_: f32;
    var phi_256_: f32;
    var phi_302_: bool;
    var phi_306_: f32;
    var phi_318_: bool;
    var phi_325_: f32;
    var phi_340_: f32;
    var phi_341_: f32;
    var phi_342_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_184_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_183_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_182_ = 1f;
            } else {
                phi_182_ = param_7;
            }
            let _e49 = phi_182_;
            phi_183_ = _e49;
        }
        let _e51 = phi_183_;
        phi_184_ = _e51;
    }
    let _e53 = phi_184_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_202_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_201_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_200_ = 1f;
            } else {
                phi_200_ = param_5.x;
            }
            let _e61 = phi_200_;
            phi_201_ = _e61;
        }
        let _e63 = phi_201_;
        phi_202_ = _e63;
    }
    let _e65 = phi_202_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_220_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_219_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_218_ = 1f;
            } else {
                phi_218_ = param_5.y;
            }
            let _e73 = phi_218_;
            phi_219_ = _e73;
        }
        let _e75 = phi_219_;
        phi_220_ = _e75;
    }
    let _e77 = phi_220_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_238_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_237_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_236_ = 1f;
            } else {
                phi_236_ = param_5.z;
            }
            let _e85 = phi_236_;
            phi_237_ = _e85;
        }
        let _e87 = phi_237_;
        phi_238_ = _e87;
    }
    let _e89 = phi_238_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_256_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_255_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_254_ = 1f;
            } else {
                phi_254_ = param_5.w;
            }
            let _e97 = phi_254_;
            phi_255_ = _e97;
        }
        let _e99 = phi_255_;
        phi_256_ = _e99;
    }
    let _e101 = phi_256_;
    let _e102 = (_e65 - _e53);
    let _e103 = (_e77 - _e53);
    let _e104 = (_e89 - _e53);
    let _e105 = (_e101 - _e53);
    let _e106 = (*param_4);
    let _e117 = ((((_e102 * param_6.x) + (_e103 * param_6.y)) + (_e104 * param_6.z)) + (_e105 * param_6.w));
    let _e118 = (_e102 - _e117);
    let _e119 = (_e103 - _e117);
    let _e120 = (_e104 - _e117);
    let _e121 = (_e105 - _e117);
    let _e136 = (((((_e118 * _e118) * param_6.x) + ((_e119 * _e119) * param_6.y)) + ((_e120 * _e120) * param_6.z)) + ((_e121 * _e121) * param_6.w));
    if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
        phi_302_ = true;
    } else {
        let _e140 = (_e106 > _e136);
        if _e140 {
        }
        phi_302_ = _e140;
    }
    let _e142 = phi_302_;
    if _e142 {
        phi_306_ = _e106;
    } else {
        phi_306_ = _e136;
    }
    let _e144 = phi_306_;
    let _e145 = -(_e117);
    if (_e145 <= 0f) {
        let _e149 = ((bitcast<u32>(_e144) & 2147483647u) > 2139095040u);
        if _e149 {
        }
        phi_318_ = _e149;
    } else {
        phi_318_ = true;
    }
    let _e151 = phi_318_;
    if _e151 {
        phi_325_ = (_e144 / (_e144 + (_e145 * _e145)));
    } else {
        phi_325_ = 1f;
    }
    let _e156 = phi_325_;
    if ((bitcast<u32>(_e156) & 2147483647u) > 2139095040u) {
        phi_342_ = _e156;
    } else {
        if (_e156 < 0f) {
            phi_341_ = 0f;
        } else {
            if (_e156 > 1f) {
                phi_340_ = 1f;
            } else {
                phi_340_ = _e156;
            }
            let _e163 = phi_340_;
            phi_341_ = _e163;
        }
        let _e165 = phi_341_;
        phi_342_ = _e165;
    }
    let _e167 = phi_342_;
    return _e167;
}

fn function_() {
    var local: f32;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_411_: bool;
    var phi_481_: bool;
    var phi_482_: bool;
    var phi_493_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_494_: bool;
    var phi_495_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_496_: bool;
    var phi_503_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_507_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_581_: bool;
    var phi_590_: bool;
    var phi_599_: bool;
    var phi_600_: bool;
    var phi_601_: bool;
    var phi_602_: bool;
    var phi_603_: bool;
    var phi_604_: bool;
    var phi_605_: bool;
    var phi_609_: bool;
    var phi_699_: f32;
    var phi_702_: f32;
    var phi_731_: f32;
    var phi_736_: f32;
    var phi_737_: bool;
    var phi_738_: f32;
    var phi_739_: bool;
    var phi_743_: f32;
    var phi_763_: f32;
    var phi_768_: f32;
    var phi_769_: bool;
    var phi_770_: f32;
    var phi_771_: bool;
    var phi_775_: f32;
    var phi_825_: i32;
    var phi_830_: i32;
    var phi_835_: i32;
    var phi_840_: i32;
    var phi_849_: i32;
    var phi_854_: i32;
    var phi_859_: i32;
    var phi_864_: i32;
    var phi_919_: i32;
    var phi_924_: i32;
    var phi_929_: i32;
    var phi_934_: i32;
    var phi_953_: i32;
    var phi_958_: i32;
    var phi_963_: i32;
    var phi_968_: i32;
    var phi_987_: i32;
    var phi_992_: i32;
    var phi_997_: i32;
    var phi_1002_: i32;
    var phi_1021_: i32;
    var phi_1026_: i32;
    var phi_1031_: i32;
    var phi_1036_: i32;
    var phi_1114_: bool;
    var phi_1122_: bool;
    var phi_1134_: bool;
    var phi_1135_: bool;
    var phi_1139_: f32;
    var phi_1145_: f32;
    var phi_1147_: evaluate_Verdict;
    var phi_1157_: u32;
    var phi_1166_: f32;
    var phi_1168_: evaluate_Verdict;
    var phi_1169_: bool;
    var phi_1170_: evaluate_Verdict;
    var phi_1171_: bool;
    var phi_1176_: evaluate_Verdict;
    var phi_1181_: evaluate_Verdict;
    var phi_1182_: evaluate_Verdict;

    let _e40 = id_1;
    let _e47 = arrayLength((&map.member));
    let _e53 = arrayLength((&marks.member));
    let _e56 = p.member.size[0u];
    let _e58 = p.member.size[1u];
    let _e59 = lt_shaders_entry_pixel_index(_e40, _e56, _e58);
    if (bitcast<i32>(_e59.root) != 0i) {
        let _e65 = p.member.projection;
        if (_e59.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e69 = lt_math_OneLevel(_e65);
        let _e73 = samples.member[(0u + _e59.first_primitive)].normal[0u];
        let _e75 = global[0u];
        if (_e73 == _e75) {
            let _e78 = samples.member[(0u + _e59.first_primitive)].normal[1u];
            let _e80 = global[1u];
            if (_e78 == _e80) {
                let _e83 = samples.member[(0u + _e59.first_primitive)].normal[2u];
                let _e85 = global[2u];
                phi_404_ = (_e83 == _e85);
                phi_405_ = false;
            } else {
                phi_404_ = bool();
                phi_405_ = true;
            }
            let _e88 = phi_404_;
            let _e90 = phi_405_;
            phi_406_ = _e88;
            phi_407_ = _e90;
        } else {
            phi_406_ = bool();
            phi_407_ = true;
        }
        let _e92 = phi_406_;
        let _e94 = phi_407_;
        if _e94 {
            phi_411_ = false;
        } else {
            phi_411_ = _e92;
        }
        let _e96 = phi_411_;
        if !(_e96) {
            let _e99 = samples.member[(0u + _e59.first_primitive)].position;
            let _e101 = p.member.light.place;
            let _e107 = p.member.light.place[3u];
            let _e114 = (_e101.x - (_e99.x * _e107));
            let _e115 = (_e101.y - (_e99.y * _e107));
            let _e116 = (_e101.z - (_e99.z * _e107));
            let _e118 = samples.member[(0u + _e59.first_primitive)].normal;
            if ((((_e118.x * _e114) + (_e118.y * _e115)) + (_e118.z * _e116)) > 0f) {
                let _e132 = (((_e114 * _e114) + (_e115 * _e115)) + (_e116 * _e116));
                let _e134 = p.member.light.axis;
                let _e146 = p.member.light.place[3u];
                if (_e146 == 0f) {
                    phi_482_ = true;
                } else {
                    let _e149 = p.member.light.range_squared;
                    if (_e132 <= _e149) {
                        let _e152 = p.member.light.cos_outer;
                        phi_481_ = (-((((_e114 * _e134.x) + (_e115 * _e134.y)) + (_e116 * _e134.z))) >= (_e152 * sqrt(_e132)));
                    } else {
                        phi_481_ = false;
                    }
                    let _e157 = phi_481_;
                    phi_482_ = _e157;
                }
                let _e159 = phi_482_;
                if _e159 {
                    let _e161 = samples.member[(0u + _e59.first_primitive)].flags;
                    let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e169.unnamed.visibility, false), _e169.unnamed_1);
                    phi_493_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e175.unnamed, ((_e161 & 1u) == 0u));
                    phi_494_ = false;
                } else {
                    phi_493_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_494_ = true;
                }
                let _e180 = phi_493_;
                let _e182 = phi_494_;
                phi_495_ = _e180;
                phi_496_ = _e182;
            } else {
                phi_495_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_496_ = true;
            }
            let _e184 = phi_495_;
            let _e186 = phi_496_;
            if _e186 {
                let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e198 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e192.unnamed.visibility, false), _e192.unnamed_1);
                phi_503_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e198.unnamed, true);
            } else {
                phi_503_ = _e184;
            }
            let _e203 = phi_503_;
            phi_507_ = _e203;
        } else {
            let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e215 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e209.unnamed.visibility, false), _e209.unnamed_1);
            phi_507_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e215.unnamed, true);
        }
        let _e220 = phi_507_;
        if _e220.unnamed_1 {
            phi_1182_ = evaluate_Verdict(_e220.unnamed.visibility, _e220.unnamed.is_doubted);
        } else {
            let _e228 = samples.member[(0u + _e59.first_primitive)].position;
            let _e246 = ((((_e69.projection.row_w.x * _e228.x) + (_e69.projection.row_w.y * _e228.y)) + (_e69.projection.row_w.z * _e228.z)) + (_e69.projection.row_w.w * 1f));
            let _e260 = (((((_e69.projection.row_x.x * _e228.x) + (_e69.projection.row_x.y * _e228.y)) + (_e69.projection.row_x.z * _e228.z)) + (_e69.projection.row_x.w * 1f)) / _e246);
            let _e274 = (((((_e69.projection.row_y.x * _e228.x) + (_e69.projection.row_y.y * _e228.y)) + (_e69.projection.row_y.z * _e228.z)) + (_e69.projection.row_y.w * 1f)) / _e246);
            let _e287 = ((((_e69.projection.row_z.x * _e228.x) + (_e69.projection.row_z.y * _e228.y)) + (_e69.projection.row_z.z * _e228.z)) + (_e69.projection.row_z.w * 1f));
            if (_e246 > 0f) {
                if (_e260 >= 0f) {
                    phi_581_ = (_e260 <= 1f);
                } else {
                    phi_581_ = false;
                }
                let _e292 = phi_581_;
                if _e292 {
                    if (_e274 >= 0f) {
                        phi_590_ = (_e274 <= 1f);
                    } else {
                        phi_590_ = false;
                    }
                    let _e296 = phi_590_;
                    if _e296 {
                        if (_e287 >= 0f) {
                            phi_599_ = (_e287 <= 1f);
                        } else {
                            phi_599_ = false;
                        }
                        let _e300 = phi_599_;
                        phi_600_ = _e300;
                        phi_601_ = false;
                    } else {
                        phi_600_ = bool();
                        phi_601_ = true;
                    }
                    let _e302 = phi_600_;
                    let _e304 = phi_601_;
                    phi_602_ = _e302;
                    phi_603_ = _e304;
                } else {
                    phi_602_ = bool();
                    phi_603_ = true;
                }
                let _e306 = phi_602_;
                let _e308 = phi_603_;
                phi_604_ = _e306;
                phi_605_ = _e308;
            } else {
                phi_604_ = bool();
                phi_605_ = true;
            }
            let _e310 = phi_604_;
            let _e312 = phi_605_;
            if _e312 {
                phi_609_ = false;
            } else {
                phi_609_ = _e310;
            }
            let _e314 = phi_609_;
            if _e314 {
                if (0f > 0f) {
                    let _e317 = samples.member[(0u + _e59.first_primitive)].normal;
                    let _e319 = p.member.map_size;
                    let _e389 = ((abs(((((_e65.row_x.x * _e317.x) + (_e65.row_x.y * _e317.y)) + (_e65.row_x.z * _e317.z)) / (((_e65.row_x.x * _e65.row_x.x) + (_e65.row_x.y * _e65.row_x.y)) + (_e65.row_x.z * _e65.row_x.z)))) + abs(((((_e65.row_y.x * _e317.x) + (_e65.row_y.y * _e317.y)) + (_e65.row_y.z * _e317.z)) / (((_e65.row_y.x * _e65.row_y.x) + (_e65.row_y.y * _e65.row_y.y)) + (_e65.row_y.z * _e65.row_y.z))))) / (abs(((((_e65.row_z.x * _e317.x) + (_e65.row_z.y * _e317.y)) + (_e65.row_z.z * _e317.z)) / (((_e65.row_z.x * _e65.row_z.x) + (_e65.row_z.y * _e65.row_z.y)) + (_e65.row_z.z * _e65.row_z.z)))) * f32(_e319)));
                    if (_e389 < 0.002f) {
                        phi_699_ = _e389;
                    } else {
                        phi_699_ = 0.002f;
                    }
                    let _e392 = phi_699_;
                    phi_702_ = (_e287 - (0f * _e392));
                } else {
                    phi_702_ = _e287;
                }
                let _e396 = phi_702_;
                let _e398 = p.member.map_size;
                let _e399 = f32(_e398);
                let _e402 = ((_e260 * _e399) - 0.5f);
                let _e403 = ((_e274 * _e399) - 0.5f);
                if (_e402 > -8388608f) {
                    let _e415 = f32(select(0i, select(select(i32(_e402), i32(-2147483648), (_e402 < bitcast<f32>(3472883712u))), 2147483647i, (_e402 > bitcast<f32>(1325400063u))), (_e402 == _e402)));
                    if (_e415 > _e402) {
                        phi_731_ = 1f;
                    } else {
                        phi_731_ = 0f;
                    }
                    let _e418 = phi_731_;
                    if (_e402 < 8388608f) {
                        phi_736_ = (_e415 - _e418);
                        phi_737_ = false;
                    } else {
                        phi_736_ = f32();
                        phi_737_ = true;
                    }
                    let _e421 = phi_736_;
                    let _e423 = phi_737_;
                    phi_738_ = _e421;
                    phi_739_ = _e423;
                } else {
                    phi_738_ = f32();
                    phi_739_ = true;
                }
                let _e425 = phi_738_;
                let _e427 = phi_739_;
                if _e427 {
                    phi_743_ = _e402;
                } else {
                    phi_743_ = _e425;
                }
                let _e429 = phi_743_;
                if (_e403 > -8388608f) {
                    let _e441 = f32(select(0i, select(select(i32(_e403), i32(-2147483648), (_e403 < bitcast<f32>(3472883712u))), 2147483647i, (_e403 > bitcast<f32>(1325400063u))), (_e403 == _e403)));
                    if (_e441 > _e403) {
                        phi_763_ = 1f;
                    } else {
                        phi_763_ = 0f;
                    }
                    let _e444 = phi_763_;
                    if (_e403 < 8388608f) {
                        phi_768_ = (_e441 - _e444);
                        phi_769_ = false;
                    } else {
                        phi_768_ = f32();
                        phi_769_ = true;
                    }
                    let _e447 = phi_768_;
                    let _e449 = phi_769_;
                    phi_770_ = _e447;
                    phi_771_ = _e449;
                } else {
                    phi_770_ = f32();
                    phi_771_ = true;
                }
                let _e451 = phi_770_;
                let _e453 = phi_771_;
                if _e453 {
                    phi_775_ = _e403;
                } else {
                    phi_775_ = _e451;
                }
                let _e455 = phi_775_;
                let _e456 = (_e402 - _e429);
                let _e457 = (_e403 - _e455);
                let _e466 = select(0i, select(select(i32(_e429), i32(-2147483648), (_e429 < bitcast<f32>(3472883712u))), 2147483647i, (_e429 > bitcast<f32>(1325400063u))), (_e429 == _e429));
                let _e475 = select(0i, select(select(i32(_e455), i32(-2147483648), (_e455 < bitcast<f32>(3472883712u))), 2147483647i, (_e455 > bitcast<f32>(1325400063u))), (_e455 == _e455));
                let _e486 = p.member.test;
                let _e487 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e486);
                let _e489 = p.member.map_size;
                local = _e487;
                let _e491 = ((0u * _e489) * _e489);
                let _e493 = (bitcast<i32>(_e489) - 1i);
                if (_e466 > 0i) {
                    phi_825_ = _e466;
                } else {
                    phi_825_ = 0i;
                }
                let _e496 = phi_825_;
                if (_e475 > 0i) {
                    phi_830_ = _e475;
                } else {
                    phi_830_ = 0i;
                }
                let _e499 = phi_830_;
                if (_e496 < _e493) {
                    phi_835_ = _e496;
                } else {
                    phi_835_ = _e493;
                }
                let _e502 = phi_835_;
                if (_e499 < _e493) {
                    phi_840_ = _e499;
                } else {
                    phi_840_ = _e493;
                }
                let _e505 = phi_840_;
                let _e506 = bitcast<u32>(_e502);
                let _e508 = (_e466 + 1i);
                let _e509 = (_e475 + 1i);
                if (_e508 > 0i) {
                    phi_849_ = _e508;
                } else {
                    phi_849_ = 0i;
                }
                let _e512 = phi_849_;
                if (_e509 > 0i) {
                    phi_854_ = _e509;
                } else {
                    phi_854_ = 0i;
                }
                let _e515 = phi_854_;
                if (_e512 < _e493) {
                    phi_859_ = _e512;
                } else {
                    phi_859_ = _e493;
                }
                let _e518 = phi_859_;
                if (_e515 < _e493) {
                    phi_864_ = _e515;
                } else {
                    phi_864_ = _e493;
                }
                let _e521 = phi_864_;
                let _e522 = bitcast<u32>(_e518);
                let _e524 = (bitcast<u32>(_e505) * _e489);
                let _e525 = (bitcast<u32>(_e521) * _e489);
                let _e530 = ((_e524 + _e506) + _e491);
                let _e531 = ((_e524 + _e522) + _e491);
                let _e532 = ((_e525 + _e506) + _e491);
                let _e533 = ((_e525 + _e522) + _e491);
                if (_e530 < _e47) {
                } else {
                    return;
                }
                let _e537 = map.member[(0u + _e530)];
                if (_e531 < _e47) {
                } else {
                    return;
                }
                let _e541 = map.member[(0u + _e531)];
                if (_e532 < _e47) {
                } else {
                    return;
                }
                let _e545 = map.member[(0u + _e532)];
                if (_e533 < _e47) {
                } else {
                    return;
                }
                let _e549 = map.member[(0u + _e533)];
                let _e551 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e537, _e541, _e545, _e549), vec4<f32>(((1f - _e456) * (1f - _e457)), (_e456 * (1f - _e457)), ((1f - _e456) * _e457), (_e456 * _e457)), _e396);
                let _e553 = p.member.map_size;
                let _e555 = (bitcast<i32>(_e553) - 1i);
                if (_e466 > 0i) {
                    phi_919_ = _e466;
                } else {
                    phi_919_ = 0i;
                }
                let _e558 = phi_919_;
                if (_e475 > 0i) {
                    phi_924_ = _e475;
                } else {
                    phi_924_ = 0i;
                }
                let _e561 = phi_924_;
                if (_e558 < _e555) {
                    phi_929_ = _e558;
                } else {
                    phi_929_ = _e555;
                }
                let _e564 = phi_929_;
                if (_e561 < _e555) {
                    phi_934_ = _e561;
                } else {
                    phi_934_ = _e555;
                }
                let _e567 = phi_934_;
                let _e568 = bitcast<u32>(_e564);
                let _e575 = ((((0u * _e553) + bitcast<u32>(_e567)) * (_e553 / 16u)) + (_e568 / 16u));
                let _e578 = (_e466 + 1i);
                let _e579 = (_e475 + 0i);
                let _e581 = (bitcast<i32>(_e553) - 1i);
                if (_e578 > 0i) {
                    phi_953_ = _e578;
                } else {
                    phi_953_ = 0i;
                }
                let _e584 = phi_953_;
                if (_e579 > 0i) {
                    phi_958_ = _e579;
                } else {
                    phi_958_ = 0i;
                }
                let _e587 = phi_958_;
                if (_e584 < _e581) {
                    phi_963_ = _e584;
                } else {
                    phi_963_ = _e581;
                }
                let _e590 = phi_963_;
                if (_e587 < _e581) {
                    phi_968_ = _e587;
                } else {
                    phi_968_ = _e581;
                }
                let _e593 = phi_968_;
                let _e594 = bitcast<u32>(_e590);
                let _e601 = ((((0u * _e553) + bitcast<u32>(_e593)) * (_e553 / 16u)) + (_e594 / 16u));
                let _e604 = (_e466 + 0i);
                let _e605 = (_e475 + 1i);
                let _e607 = (bitcast<i32>(_e553) - 1i);
                if (_e604 > 0i) {
                    phi_987_ = _e604;
                } else {
                    phi_987_ = 0i;
                }
                let _e610 = phi_987_;
                if (_e605 > 0i) {
                    phi_992_ = _e605;
                } else {
                    phi_992_ = 0i;
                }
                let _e613 = phi_992_;
                if (_e610 < _e607) {
                    phi_997_ = _e610;
                } else {
                    phi_997_ = _e607;
                }
                let _e616 = phi_997_;
                if (_e613 < _e607) {
                    phi_1002_ = _e613;
                } else {
                    phi_1002_ = _e607;
                }
                let _e619 = phi_1002_;
                let _e620 = bitcast<u32>(_e616);
                let _e627 = ((((0u * _e553) + bitcast<u32>(_e619)) * (_e553 / 16u)) + (_e620 / 16u));
                let _e630 = (_e466 + 1i);
                let _e631 = (_e475 + 1i);
                let _e633 = (bitcast<i32>(_e553) - 1i);
                if (_e630 > 0i) {
                    phi_1021_ = _e630;
                } else {
                    phi_1021_ = 0i;
                }
                let _e636 = phi_1021_;
                if (_e631 > 0i) {
                    phi_1026_ = _e631;
                } else {
                    phi_1026_ = 0i;
                }
                let _e639 = phi_1026_;
                if (_e636 < _e633) {
                    phi_1031_ = _e636;
                } else {
                    phi_1031_ = _e633;
                }
                let _e642 = phi_1031_;
                if (_e639 < _e633) {
                    phi_1036_ = _e639;
                } else {
                    phi_1036_ = _e633;
                }
                let _e645 = phi_1036_;
                let _e646 = bitcast<u32>(_e642);
                let _e653 = ((((0u * _e553) + bitcast<u32>(_e645)) * (_e553 / 16u)) + (_e646 / 16u));
                if (_e575 < _e53) {
                } else {
                    return;
                }
                let _e659 = marks.member[(0u + _e575)];
                if (_e601 < _e53) {
                } else {
                    return;
                }
                let _e667 = marks.member[(0u + _e601)];
                if (_e627 < _e53) {
                } else {
                    return;
                }
                let _e676 = marks.member[(0u + _e627)];
                if (_e653 < _e53) {
                } else {
                    return;
                }
                let _e684 = marks.member[(0u + _e653)];
                let _e692 = p.member.epsilon;
                if (_e551 <= _e692) {
                    phi_1114_ = true;
                } else {
                    phi_1114_ = (_e551 >= (1f - _e692));
                }
                let _e697 = phi_1114_;
                if ((bitcast<u32>(_e551) & 2147483647u) > 2139095040u) {
                    phi_1122_ = true;
                } else {
                    phi_1122_ = !(_e697);
                }
                let _e703 = phi_1122_;
                if _e703 {
                    if (_e551 > 0f) {
                        if (_e551 < 1f) {
                            phi_1134_ = false;
                        } else {
                            phi_1134_ = true;
                        }
                        let _e707 = phi_1134_;
                        phi_1135_ = _e707;
                    } else {
                        phi_1135_ = true;
                    }
                    let _e709 = phi_1135_;
                    if _e709 {
                        phi_1139_ = 0.5f;
                    } else {
                        phi_1139_ = _e551;
                    }
                    let _e711 = phi_1139_;
                    phi_1147_ = evaluate_Verdict(_e711, true);
                } else {
                    if (_e551 > 0.5f) {
                        phi_1145_ = 1f;
                    } else {
                        phi_1145_ = 0f;
                    }
                    let _e715 = phi_1145_;
                    phi_1147_ = evaluate_Verdict(_e715, false);
                }
                let _e718 = phi_1147_;
                let _e721 = (_e718.visibility < 0.5f);
                if _e718.is_doubted {
                    phi_1170_ = evaluate_Verdict();
                    phi_1171_ = true;
                } else {
                    if _e721 {
                        phi_1157_ = 2u;
                    } else {
                        phi_1157_ = 1u;
                    }
                    let _e723 = phi_1157_;
                    if ((((((_e659 >> bitcast<u32>((((_e568 % 16u) * 2u) & 31u))) & 3u) | ((_e667 >> bitcast<u32>((((_e594 % 16u) * 2u) & 31u))) & 3u)) | (((_e676 >> bitcast<u32>((((_e620 % 16u) * 2u) & 31u))) & 3u) | ((_e684 >> bitcast<u32>((((_e646 % 16u) * 2u) & 31u))) & 3u))) & _e723) != 0u) {
                        if _e721 {
                            phi_1166_ = 0.000000059604645f;
                        } else {
                            phi_1166_ = 0.99999994f;
                        }
                        let _e727 = phi_1166_;
                        phi_1168_ = evaluate_Verdict(_e727, true);
                        phi_1169_ = false;
                    } else {
                        phi_1168_ = evaluate_Verdict();
                        phi_1169_ = true;
                    }
                    let _e730 = phi_1168_;
                    let _e732 = phi_1169_;
                    phi_1170_ = _e730;
                    phi_1171_ = _e732;
                }
                let _e734 = phi_1170_;
                let _e736 = phi_1171_;
                if _e736 {
                    phi_1176_ = evaluate_Verdict(_e718.visibility, _e718.is_doubted);
                } else {
                    phi_1176_ = _e734;
                }
                let _e739 = phi_1176_;
                phi_1181_ = evaluate_Verdict(_e739.visibility, _e739.is_doubted);
            } else {
                phi_1181_ = evaluate_Verdict(0.5f, true);
            }
            let _e745 = phi_1181_;
            phi_1182_ = _e745;
        }
        let _e747 = phi_1182_;
        if (_e59.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e59.first_primitive)] = _e747.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_vsm_marks_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
