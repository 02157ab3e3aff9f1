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

struct type_27 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct lt_bvh_slab_Span {
    near: f32,
    far: f32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_27;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_131_: lt_bvh_traverse_Tree;
    var phi_132_: bool;
    var phi_133_: lt_bvh_traverse_Tree;
    var phi_134_: bool;
    var phi_139_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_131_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_132_ = false;
        } else {
            phi_131_ = lt_bvh_traverse_Tree();
            phi_132_ = true;
        }
        let _e51 = phi_131_;
        let _e53 = phi_132_;
        phi_133_ = _e51;
        phi_134_ = _e53;
    } else {
        phi_133_ = lt_bvh_traverse_Tree();
        phi_134_ = true;
    }
    let _e55 = phi_133_;
    let _e57 = phi_134_;
    if _e57 {
        phi_139_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_139_ = _e55;
    }
    let _e62 = phi_139_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_694_: f32;
    var phi_695_: f32;
    var phi_696_: f32;
    var phi_713_: f32;
    var phi_714_: f32;
    var phi_715_: f32;
    var phi_731_: f32;
    var phi_732_: f32;
    var phi_733_: f32;
    var phi_749_: f32;
    var phi_750_: f32;
    var phi_751_: f32;
    var phi_767_: f32;
    var phi_768_: f32;
    var phi_769_: f32;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_809_: bool;
    var phi_813_: bool;
    var phi_1124_: f32;
    var phi_1125_: f32;
    var phi_1126_: f32;
    var phi_1143_: f32;
    var phi_1144_: f32;
    var phi_1145_: f32;
    var phi_1162_: f32;
    var phi_1163_: f32;
    var phi_1164_: f32;
    var phi_1181_: f32;
    var phi_1182_: f32;
    var phi_1183_: f32;
    var phi_1206_: f32;
    var phi_1207_: f32;
    var phi_1208_: f32;
    var phi_1219_: f32;
    var phi_1234_: f32;
    var phi_1236_: lt_bvh_slab_Span;
    var phi_1294_: f32;
    var phi_1295_: f32;
    var phi_1296_: f32;
    var phi_1297_: f32;
    var phi_1298_: f32;
    var phi_1299_: bool;
    var phi_1303_: f32;
    var phi_1313_: bool;
    var phi_1326_: bool;
    var phi_1330_: bool;
    var phi_1331_: bool;
    var phi_1341_: bool;
    var phi_1342_: bool;
    var phi_1343_: bool;
    var phi_1347_: bool;
    var phi_1398_: f32;
    var phi_1399_: f32;
    var phi_1400_: f32;
    var phi_1417_: f32;
    var phi_1418_: f32;
    var phi_1419_: f32;
    var phi_1436_: f32;
    var phi_1437_: f32;
    var phi_1438_: f32;
    var phi_1455_: f32;
    var phi_1456_: f32;
    var phi_1457_: f32;
    var phi_1480_: f32;
    var phi_1481_: f32;
    var phi_1482_: f32;
    var phi_1569_: f32;
    var phi_1570_: f32;
    var phi_1581_: bool;
    var phi_1585_: f32;
    var phi_1586_: f32;
    var phi_1601_: f32;
    var phi_1602_: f32;
    var phi_1603_: f32;
    var phi_1604_: f32;
    var phi_1605_: f32;
    var phi_1606_: f32;
    var phi_1607_: f32;
    var phi_1608_: bool;
    var phi_1609_: f32;
    var phi_1610_: f32;
    var phi_1611_: bool;
    var phi_1615_: f32;

    let _e42 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_696_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_695_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_694_ = 1f;
            } else {
                phi_694_ = param_7;
            }
            let _e49 = phi_694_;
            phi_695_ = _e49;
        }
        let _e51 = phi_695_;
        phi_696_ = _e51;
    }
    let _e53 = phi_696_;
    let _e54 = (_e53 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_715_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_714_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_713_ = 1f;
            } else {
                phi_713_ = param_5.x;
            }
            let _e62 = phi_713_;
            phi_714_ = _e62;
        }
        let _e64 = phi_714_;
        phi_715_ = _e64;
    }
    let _e66 = phi_715_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_733_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_732_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_731_ = 1f;
            } else {
                phi_731_ = param_5.y;
            }
            let _e74 = phi_731_;
            phi_732_ = _e74;
        }
        let _e76 = phi_732_;
        phi_733_ = _e76;
    }
    let _e78 = phi_733_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_751_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_750_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_749_ = 1f;
            } else {
                phi_749_ = param_5.z;
            }
            let _e86 = phi_749_;
            phi_750_ = _e86;
        }
        let _e88 = phi_750_;
        phi_751_ = _e88;
    }
    let _e90 = phi_751_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_769_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_768_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_767_ = 1f;
            } else {
                phi_767_ = param_5.w;
            }
            let _e98 = phi_767_;
            phi_768_ = _e98;
        }
        let _e100 = phi_768_;
        phi_769_ = _e100;
    }
    let _e102 = phi_769_;
    let _e103 = (_e66 - _e54);
    let _e104 = (_e78 - _e54);
    let _e105 = (_e90 - _e54);
    let _e106 = (_e102 - _e54);
    let _e117 = ((((_e103 * param_6.x) + (_e104 * param_6.y)) + (_e105 * param_6.z)) + (_e106 * param_6.w));
    if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
        phi_1609_ = _e117;
        phi_1610_ = f32();
        phi_1611_ = true;
    } else {
        if (_e103 >= 0f) {
            if (_e104 >= 0f) {
                if (_e105 >= 0f) {
                    phi_804_ = (_e106 >= 0f);
                    phi_805_ = false;
                } else {
                    phi_804_ = bool();
                    phi_805_ = true;
                }
                let _e126 = phi_804_;
                let _e128 = phi_805_;
                phi_806_ = _e126;
                phi_807_ = _e128;
            } else {
                phi_806_ = bool();
                phi_807_ = true;
            }
            let _e130 = phi_806_;
            let _e132 = phi_807_;
            phi_808_ = _e130;
            phi_809_ = _e132;
        } else {
            phi_808_ = bool();
            phi_809_ = true;
        }
        let _e134 = phi_808_;
        let _e136 = phi_809_;
        if _e136 {
            phi_813_ = false;
        } else {
            phi_813_ = _e134;
        }
        let _e138 = phi_813_;
        if _e138 {
            phi_1606_ = 1f;
            phi_1607_ = f32();
            phi_1608_ = true;
        } else {
            let _e139 = (0.5f * _e42);
            let _e140 = (1f - _e42);
            let _e142 = (param_6.x * _e140);
            let _e144 = (param_6.y * _e140);
            let _e146 = (param_6.z * _e140);
            let _e148 = (param_6.w * _e140);
            let _e149 = -(_e54);
            let _e150 = (1f - _e54);
            let _e152 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e66);
            let _e154 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e78);
            let _e156 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e90);
            let _e158 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e102);
            let _e159 = (_e103 - _e104);
            let _e160 = (_e104 - _e105);
            let _e161 = (_e105 - _e106);
            let _e162 = (_e106 - _e103);
            let _e163 = (_e159 * _e159);
            let _e164 = (_e160 * _e160);
            let _e165 = (_e161 * _e161);
            let _e166 = (_e162 * _e162);
            let _e167 = (_e103 - _e105);
            let _e168 = (_e104 - _e106);
            let _e169 = (_e105 - _e103);
            let _e170 = (_e106 - _e104);
            let _e171 = (_e167 * _e167);
            let _e172 = (_e168 * _e168);
            let _e173 = (_e169 * _e169);
            let _e174 = (_e170 * _e170);
            let _e179 = ((_e142 * _e144) * _e163);
            let _e180 = ((_e144 * _e146) * _e164);
            let _e181 = ((_e146 * _e148) * _e165);
            let _e182 = ((_e148 * _e142) * _e166);
            let _e191 = (((0.5f * _e142) * _e146) * _e171);
            let _e192 = (((0.5f * _e144) * _e148) * _e172);
            let _e193 = (((0.5f * _e146) * _e142) * _e173);
            let _e194 = (((0.5f * _e148) * _e144) * _e174);
            let _e195 = (_e103 * _e104);
            let _e196 = (_e104 * _e105);
            let _e197 = (_e105 * _e106);
            let _e198 = (_e106 * _e103);
            let _e199 = (_e103 * _e105);
            let _e200 = (_e104 * _e106);
            let _e201 = (_e105 * _e103);
            let _e202 = (_e106 * _e104);
            let _e203 = (_e179 * _e195);
            let _e204 = (_e180 * _e196);
            let _e205 = (_e181 * _e197);
            let _e206 = (_e182 * _e198);
            let _e207 = (_e191 * _e199);
            let _e208 = (_e192 * _e200);
            let _e209 = (_e193 * _e201);
            let _e210 = (_e194 * _e202);
            let _e211 = (_e66 * _e66);
            let _e212 = (_e78 * _e78);
            let _e213 = (_e90 * _e90);
            let _e214 = (_e102 * _e102);
            let _e215 = (_e152 * _e152);
            let _e216 = (_e154 * _e154);
            let _e217 = (_e156 * _e156);
            let _e218 = (_e158 * _e158);
            let _e219 = (_e139 * _e142);
            let _e220 = (_e139 * _e144);
            let _e221 = (_e139 * _e146);
            let _e222 = (_e139 * _e148);
            let _e231 = (((_e219 * _e103) * _e211) * _e149);
            let _e232 = (((_e220 * _e104) * _e212) * _e149);
            let _e233 = (((_e221 * _e105) * _e213) * _e149);
            let _e234 = (((_e222 * _e106) * _e214) * _e149);
            let _e243 = (((_e219 * _e103) * _e215) * _e150);
            let _e244 = (((_e220 * _e104) * _e216) * _e150);
            let _e245 = (((_e221 * _e105) * _e217) * _e150);
            let _e246 = (((_e222 * _e106) * _e218) * _e150);
            let _e414 = (((((((_e179 * _e146) * _e164) * _e171) + (_e139 * (((_e179 * ((_e211 * _e212) + (_e215 * _e216))) + (_e191 * ((_e211 * _e213) + (_e215 * _e217)))) + ((_e219 * _e211) * _e215)))) + ((((_e180 * _e148) * _e165) * _e172) + (_e139 * (((_e180 * ((_e212 * _e213) + (_e216 * _e217))) + (_e192 * ((_e212 * _e214) + (_e216 * _e218)))) + ((_e220 * _e212) * _e216))))) + ((((_e181 * _e142) * _e166) * _e173) + (_e139 * (((_e181 * ((_e213 * _e214) + (_e217 * _e218))) + (_e193 * ((_e213 * _e211) + (_e217 * _e215)))) + ((_e221 * _e213) * _e217))))) + ((((_e182 * _e144) * _e163) * _e174) + (_e139 * (((_e182 * ((_e214 * _e211) + (_e218 * _e215))) + (_e194 * ((_e214 * _e212) + (_e218 * _e216)))) + ((_e222 * _e214) * _e218)))));
            let _e417 = (((_e139 * _e139) * _e149) * _e150);
            let _e420 = (((((((_e203 * _e195) + (_e207 * _e199)) + (_e103 * ((_e231 * _e149) + (_e243 * _e150)))) + (((_e204 * _e196) + (_e208 * _e200)) + (_e104 * ((_e232 * _e149) + (_e244 * _e150))))) + (((_e205 * _e197) + (_e209 * _e201)) + (_e105 * ((_e233 * _e149) + (_e245 * _e150))))) + (((_e206 * _e198) + (_e210 * _e202)) + (_e106 * ((_e234 * _e149) + (_e246 * _e150))))) + ((_e417 * _e149) * _e150));
            let _e426 = (_e420 < 0.0000000000000000000000000000000001f);
            if _e426 {
                if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
                    phi_1126_ = _e103;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1125_ = 0f;
                    } else {
                        if (_e103 < 0f) {
                            phi_1124_ = 0f;
                        } else {
                            phi_1124_ = 1f;
                        }
                        let _e435 = phi_1124_;
                        phi_1125_ = _e435;
                    }
                    let _e437 = phi_1125_;
                    phi_1126_ = _e437;
                }
                let _e439 = phi_1126_;
                if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                    phi_1145_ = _e104;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1144_ = 0f;
                    } else {
                        if (_e104 < 0f) {
                            phi_1143_ = 0f;
                        } else {
                            phi_1143_ = 1f;
                        }
                        let _e448 = phi_1143_;
                        phi_1144_ = _e448;
                    }
                    let _e450 = phi_1144_;
                    phi_1145_ = _e450;
                }
                let _e452 = phi_1145_;
                if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
                    phi_1164_ = _e105;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1163_ = 0f;
                    } else {
                        if (_e105 < 0f) {
                            phi_1162_ = 0f;
                        } else {
                            phi_1162_ = 1f;
                        }
                        let _e461 = phi_1162_;
                        phi_1163_ = _e461;
                    }
                    let _e463 = phi_1163_;
                    phi_1164_ = _e463;
                }
                let _e465 = phi_1164_;
                if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                    phi_1183_ = _e106;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1182_ = 0f;
                    } else {
                        if (_e106 < 0f) {
                            phi_1181_ = 0f;
                        } else {
                            phi_1181_ = 1f;
                        }
                        let _e474 = phi_1181_;
                        phi_1182_ = _e474;
                    }
                    let _e476 = phi_1182_;
                    phi_1183_ = _e476;
                }
                let _e478 = phi_1183_;
                let _e486 = (((((_e439 * _e142) + (_e452 * _e144)) + (_e465 * _e146)) + (_e478 * _e148)) + _e139);
                if ((bitcast<u32>(_e486) & 2147483647u) > 2139095040u) {
                    phi_1208_ = _e486;
                } else {
                    if (_e486 < 0f) {
                        phi_1207_ = 0f;
                    } else {
                        if (_e486 > 1f) {
                            phi_1206_ = 1f;
                        } else {
                            phi_1206_ = _e486;
                        }
                        let _e493 = phi_1206_;
                        phi_1207_ = _e493;
                    }
                    let _e495 = phi_1207_;
                    phi_1208_ = _e495;
                }
                let _e497 = phi_1208_;
                phi_1604_ = _e497;
                phi_1605_ = f32();
            } else {
                let _e499 = ((0.5f * -(((((((((_e203 * (_e103 + _e104)) + (_e207 * (_e103 + _e105))) + (_e231 * (_e103 + _e149))) + (_e243 * (_e103 + _e150))) + ((((_e204 * (_e104 + _e105)) + (_e208 * (_e104 + _e106))) + (_e232 * (_e104 + _e149))) + (_e244 * (_e104 + _e150)))) + ((((_e205 * (_e105 + _e106)) + (_e209 * (_e105 + _e103))) + (_e233 * (_e105 + _e149))) + (_e245 * (_e105 + _e150)))) + ((((_e206 * (_e106 + _e103)) + (_e210 * (_e106 + _e104))) + (_e234 * (_e106 + _e149))) + (_e246 * (_e106 + _e150)))) + (_e417 * (_e149 + _e150))))) / _e420);
                let _e500 = ((((((((_e203 + _e207) + _e231) + _e243) + (((_e204 + _e208) + _e232) + _e244)) + (((_e205 + _e209) + _e233) + _e245)) + (((_e206 + _e210) + _e234) + _e246)) + _e417) / _e420);
                let _e502 = ((_e499 * _e499) - _e500);
                if (_e502 > 0f) {
                    phi_1219_ = sqrt(_e502);
                } else {
                    phi_1219_ = 0f;
                }
                let _e506 = phi_1219_;
                if (_e499 > 0f) {
                    let _e509 = (-(_e499) - _e506);
                    phi_1236_ = lt_bvh_slab_Span(_e509, (_e500 / _e509));
                } else {
                    let _e512 = (_e506 - _e499);
                    if (_e512 > 0f) {
                        phi_1234_ = (_e500 / _e512);
                    } else {
                        phi_1234_ = 0f;
                    }
                    let _e516 = phi_1234_;
                    phi_1236_ = lt_bvh_slab_Span(_e516, _e512);
                }
                let _e519 = phi_1236_;
                if (_e519.near >= 0f) {
                    phi_1297_ = 1f;
                    phi_1298_ = f32();
                    phi_1299_ = true;
                } else {
                    let _e523 = (_e519.far <= 0f);
                    if _e523 {
                        phi_1295_ = (_e414 / _e420);
                        phi_1296_ = f32();
                    } else {
                        let _e534 = (((((_e142 * _e103) + (_e144 * _e104)) + (_e146 * _e105)) + (_e148 * _e106)) + (_e139 * (_e149 + _e150)));
                        let _e550 = (((((_e142 * (_e103 * _e103)) + (_e144 * (_e104 * _e104))) + (_e146 * (_e105 * _e105))) + (_e148 * (_e106 * _e106))) + (_e139 * ((_e149 * _e149) + (_e150 * _e150))));
                        if (-(_e519.near) <= _e519.far) {
                            phi_1294_ = (1f - (((_e519.near * _e519.near) * ((_e519.far * _e550) - _e534)) / (_e519.far - _e519.near)));
                        } else {
                            phi_1294_ = ((_e414 / _e420) + (((_e519.far * _e519.far) * (_e534 - (_e519.near * _e550))) / (_e519.far - _e519.near)));
                        }
                        let _e569 = phi_1294_;
                        phi_1295_ = f32();
                        phi_1296_ = _e569;
                    }
                    let _e571 = phi_1295_;
                    let _e573 = phi_1296_;
                    phi_1297_ = _e571;
                    phi_1298_ = _e573;
                    phi_1299_ = _e523;
                }
                let _e575 = phi_1297_;
                let _e577 = phi_1298_;
                let _e579 = phi_1299_;
                if _e579 {
                    phi_1303_ = _e575;
                } else {
                    phi_1303_ = _e577;
                }
                let _e581 = phi_1303_;
                if ((_e519.near * _e149) >= (1f - 0.00001f)) {
                    phi_1313_ = true;
                } else {
                    phi_1313_ = ((_e519.near * _e150) >= (1f - 0.00001f));
                }
                let _e589 = phi_1313_;
                if _e589 {
                    if ((_e519.far * _e149) >= (1f - 0.00001f)) {
                        phi_1326_ = true;
                    } else {
                        phi_1326_ = ((_e519.far * _e150) >= (1f - 0.00001f));
                    }
                    let _e597 = phi_1326_;
                    if _e597 {
                        phi_1330_ = false;
                    } else {
                        phi_1330_ = true;
                    }
                    let _e599 = phi_1330_;
                    phi_1331_ = _e599;
                } else {
                    phi_1331_ = true;
                }
                let _e601 = phi_1331_;
                if _e601 {
                    let _e603 = (-(_e149) < 0.0001f);
                    if _e603 {
                        phi_1341_ = bool();
                    } else {
                        phi_1341_ = (_e150 < 0.0001f);
                    }
                    let _e606 = phi_1341_;
                    phi_1342_ = _e606;
                    phi_1343_ = _e603;
                } else {
                    phi_1342_ = bool();
                    phi_1343_ = true;
                }
                let _e608 = phi_1342_;
                let _e610 = phi_1343_;
                if _e610 {
                    phi_1347_ = true;
                } else {
                    phi_1347_ = _e608;
                }
                let _e612 = phi_1347_;
                if !(_e612) {
                    let _e618 = ((_e142 * _e66) * _e152);
                    let _e619 = ((_e144 * _e78) * _e154);
                    let _e620 = ((_e146 * _e90) * _e156);
                    let _e621 = ((_e148 * _e102) * _e158);
                    let _e639 = ((((_e618 * (_e103 * _e103)) + (_e619 * (_e104 * _e104))) + (_e620 * (_e105 * _e105))) + (_e621 * (_e106 * _e106)));
                    if (_e639 < 0.0000000000000000000000000000000001f) {
                        if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
                            phi_1400_ = _e103;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_1399_ = 0f;
                            } else {
                                if (_e103 < 0f) {
                                    phi_1398_ = 0f;
                                } else {
                                    phi_1398_ = 1f;
                                }
                                let _e649 = phi_1398_;
                                phi_1399_ = _e649;
                            }
                            let _e651 = phi_1399_;
                            phi_1400_ = _e651;
                        }
                        let _e653 = phi_1400_;
                        if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                            phi_1419_ = _e104;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_1418_ = 0f;
                            } else {
                                if (_e104 < 0f) {
                                    phi_1417_ = 0f;
                                } else {
                                    phi_1417_ = 1f;
                                }
                                let _e662 = phi_1417_;
                                phi_1418_ = _e662;
                            }
                            let _e664 = phi_1418_;
                            phi_1419_ = _e664;
                        }
                        let _e666 = phi_1419_;
                        if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
                            phi_1438_ = _e105;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_1437_ = 0f;
                            } else {
                                if (_e105 < 0f) {
                                    phi_1436_ = 0f;
                                } else {
                                    phi_1436_ = 1f;
                                }
                                let _e675 = phi_1436_;
                                phi_1437_ = _e675;
                            }
                            let _e677 = phi_1437_;
                            phi_1438_ = _e677;
                        }
                        let _e679 = phi_1438_;
                        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                            phi_1457_ = _e106;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_1456_ = 0f;
                            } else {
                                if (_e106 < 0f) {
                                    phi_1455_ = 0f;
                                } else {
                                    phi_1455_ = 1f;
                                }
                                let _e688 = phi_1455_;
                                phi_1456_ = _e688;
                            }
                            let _e690 = phi_1456_;
                            phi_1457_ = _e690;
                        }
                        let _e692 = phi_1457_;
                        let _e700 = (((((_e653 * _e142) + (_e666 * _e144)) + (_e679 * _e146)) + (_e692 * _e148)) + _e139);
                        if ((bitcast<u32>(_e700) & 2147483647u) > 2139095040u) {
                            phi_1482_ = _e700;
                        } else {
                            if (_e700 < 0f) {
                                phi_1481_ = 0f;
                            } else {
                                if (_e700 > 1f) {
                                    phi_1480_ = 1f;
                                } else {
                                    phi_1480_ = _e700;
                                }
                                let _e707 = phi_1480_;
                                phi_1481_ = _e707;
                            }
                            let _e709 = phi_1481_;
                            phi_1482_ = _e709;
                        }
                        let _e711 = phi_1482_;
                        phi_1570_ = _e711;
                    } else {
                        let _e712 = (((((_e618 * _e103) + (_e619 * _e104)) + (_e620 * _e105)) + (_e621 * _e106)) / _e639);
                        let _e729 = ((_e142 * _e103) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e712 * _e103)));
                        let _e730 = ((_e144 * _e104) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e712 * _e104)));
                        let _e731 = ((_e146 * _e105) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e712 * _e105)));
                        let _e732 = ((_e148 * _e106) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e712 * _e106)));
                        if (_e712 > 0f) {
                            phi_1569_ = ((1f - _e139) - (((((_e729 * _e152) + (_e730 * _e154)) + (_e731 * _e156)) + (_e732 * _e158)) / (_e149 * (1f - (_e149 * _e712)))));
                        } else {
                            phi_1569_ = ((((((((_e618 * ((_e619 * _e163) + ((0.5f * _e620) * _e171))) * vec4<f32>(1f, 1f, 1f, 1f).x) + ((_e619 * ((_e620 * _e164) + ((0.5f * _e621) * _e172))) * vec4<f32>(1f, 1f, 1f, 1f).y)) + ((_e620 * ((_e621 * _e165) + ((0.5f * _e618) * _e173))) * vec4<f32>(1f, 1f, 1f, 1f).z)) + ((_e621 * ((_e618 * _e166) + ((0.5f * _e619) * _e174))) * vec4<f32>(1f, 1f, 1f, 1f).w)) / (_e639 * (-(_e149) * _e150))) + _e139) + (((((_e729 * _e66) + (_e730 * _e78)) + (_e731 * _e90)) + (_e732 * _e102)) / (_e150 * (1f - (_e712 * _e150)))));
                        }
                        let _e796 = phi_1569_;
                        phi_1570_ = _e796;
                    }
                    let _e798 = phi_1570_;
                    if ((bitcast<u32>(_e581) & 2147483647u) > 2139095040u) {
                        phi_1581_ = true;
                    } else {
                        let _e802 = (_e581 < _e798);
                        if _e802 {
                        }
                        phi_1581_ = _e802;
                    }
                    let _e804 = phi_1581_;
                    if _e804 {
                        phi_1585_ = _e581;
                    } else {
                        phi_1585_ = _e798;
                    }
                    let _e806 = phi_1585_;
                    phi_1586_ = _e806;
                } else {
                    phi_1586_ = _e581;
                }
                let _e808 = phi_1586_;
                if ((bitcast<u32>(_e808) & 2147483647u) > 2139095040u) {
                    phi_1603_ = _e808;
                } else {
                    if (_e808 < 0f) {
                        phi_1602_ = 0f;
                    } else {
                        if (_e808 > 1f) {
                            phi_1601_ = 1f;
                        } else {
                            phi_1601_ = _e808;
                        }
                        let _e815 = phi_1601_;
                        phi_1602_ = _e815;
                    }
                    let _e817 = phi_1602_;
                    phi_1603_ = _e817;
                }
                let _e819 = phi_1603_;
                phi_1604_ = f32();
                phi_1605_ = _e819;
            }
            let _e821 = phi_1604_;
            let _e823 = phi_1605_;
            phi_1606_ = _e821;
            phi_1607_ = _e823;
            phi_1608_ = _e426;
        }
        let _e825 = phi_1606_;
        let _e827 = phi_1607_;
        let _e829 = phi_1608_;
        phi_1609_ = _e825;
        phi_1610_ = _e827;
        phi_1611_ = _e829;
    }
    let _e831 = phi_1609_;
    let _e833 = phi_1610_;
    let _e835 = phi_1611_;
    if _e835 {
        phi_1615_ = _e831;
    } else {
        phi_1615_ = _e833;
    }
    let _e837 = phi_1615_;
    return _e837;
}

fn function_() {
    var local: f32;
    var phi_202_: bool;
    var phi_203_: bool;
    var phi_204_: bool;
    var phi_205_: bool;
    var phi_209_: bool;
    var phi_253_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_257_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_331_: bool;
    var phi_340_: bool;
    var phi_349_: bool;
    var phi_350_: bool;
    var phi_351_: bool;
    var phi_352_: bool;
    var phi_353_: bool;
    var phi_354_: bool;
    var phi_355_: bool;
    var phi_359_: bool;
    var phi_449_: f32;
    var phi_452_: f32;
    var phi_481_: f32;
    var phi_486_: f32;
    var phi_487_: bool;
    var phi_488_: f32;
    var phi_489_: bool;
    var phi_493_: f32;
    var phi_513_: f32;
    var phi_518_: f32;
    var phi_519_: bool;
    var phi_520_: f32;
    var phi_521_: bool;
    var phi_525_: f32;
    var phi_573_: i32;
    var phi_578_: i32;
    var phi_583_: i32;
    var phi_588_: i32;
    var phi_597_: i32;
    var phi_602_: i32;
    var phi_607_: i32;
    var phi_612_: i32;
    var phi_657_: evaluate_Verdict;
    var phi_658_: evaluate_Verdict;
    var phi_659_: bool;
    var phi_660_: evaluate_Verdict;
    var phi_661_: evaluate_Verdict;
    var phi_662_: bool;
    var phi_666_: evaluate_Verdict;

    let _e39 = id_1;
    let _e46 = arrayLength((&map.member));
    let _e52 = p.member.size[0u];
    let _e54 = p.member.size[1u];
    let _e55 = lt_shaders_entry_pixel_index(_e39, _e52, _e54);
    if (bitcast<i32>(_e55.root) != 0i) {
        let _e61 = p.member.projection;
        if (_e55.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e65 = lt_math_OneLevel(_e61);
        let _e67 = p.member.light;
        let _e70 = samples.member[(0u + _e55.first_primitive)].normal[0u];
        let _e72 = global[0u];
        if (_e70 == _e72) {
            let _e75 = samples.member[(0u + _e55.first_primitive)].normal[1u];
            let _e77 = global[1u];
            if (_e75 == _e77) {
                let _e80 = samples.member[(0u + _e55.first_primitive)].normal[2u];
                let _e82 = global[2u];
                phi_202_ = (_e80 == _e82);
                phi_203_ = false;
            } else {
                phi_202_ = bool();
                phi_203_ = true;
            }
            let _e85 = phi_202_;
            let _e87 = phi_203_;
            phi_204_ = _e85;
            phi_205_ = _e87;
        } else {
            phi_204_ = bool();
            phi_205_ = true;
        }
        let _e89 = phi_204_;
        let _e91 = phi_205_;
        if _e91 {
            phi_209_ = false;
        } else {
            phi_209_ = _e89;
        }
        let _e93 = phi_209_;
        if !(_e93) {
            let _e96 = samples.member[(0u + _e55.first_primitive)].normal;
            let _e98 = samples.member[(0u + _e55.first_primitive)].position;
            if ((((_e96.x * (_e67.x - (_e98.x * _e67.w))) + (_e96.y * (_e67.y - (_e98.y * _e67.w)))) + (_e96.z * (_e67.z - (_e98.z * _e67.w)))) > 0f) {
                let _e122 = samples.member[(0u + _e55.first_primitive)].flags;
                let _e130 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e130.unnamed.visibility, false), _e130.unnamed_1);
                phi_253_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e136.unnamed, ((_e122 & 1u) == 0u));
            } else {
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e145.unnamed.visibility, false), _e145.unnamed_1);
                phi_253_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e151.unnamed, true);
            }
            let _e156 = phi_253_;
            phi_257_ = _e156;
        } else {
            let _e162 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e162.unnamed.visibility, false), _e162.unnamed_1);
            phi_257_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e168.unnamed, true);
        }
        let _e173 = phi_257_;
        if _e173.unnamed_1 {
            phi_660_ = evaluate_Verdict(_e173.unnamed.visibility, _e173.unnamed.is_doubted);
            phi_661_ = evaluate_Verdict();
            phi_662_ = true;
        } else {
            let _e181 = samples.member[(0u + _e55.first_primitive)].position;
            let _e199 = ((((_e65.projection.row_w.x * _e181.x) + (_e65.projection.row_w.y * _e181.y)) + (_e65.projection.row_w.z * _e181.z)) + (_e65.projection.row_w.w * 1f));
            let _e213 = (((((_e65.projection.row_x.x * _e181.x) + (_e65.projection.row_x.y * _e181.y)) + (_e65.projection.row_x.z * _e181.z)) + (_e65.projection.row_x.w * 1f)) / _e199);
            let _e227 = (((((_e65.projection.row_y.x * _e181.x) + (_e65.projection.row_y.y * _e181.y)) + (_e65.projection.row_y.z * _e181.z)) + (_e65.projection.row_y.w * 1f)) / _e199);
            let _e240 = ((((_e65.projection.row_z.x * _e181.x) + (_e65.projection.row_z.y * _e181.y)) + (_e65.projection.row_z.z * _e181.z)) + (_e65.projection.row_z.w * 1f));
            if (_e199 > 0f) {
                if (_e213 >= 0f) {
                    phi_331_ = (_e213 <= 1f);
                } else {
                    phi_331_ = false;
                }
                let _e245 = phi_331_;
                if _e245 {
                    if (_e227 >= 0f) {
                        phi_340_ = (_e227 <= 1f);
                    } else {
                        phi_340_ = false;
                    }
                    let _e249 = phi_340_;
                    if _e249 {
                        if (_e240 >= 0f) {
                            phi_349_ = (_e240 <= 1f);
                        } else {
                            phi_349_ = false;
                        }
                        let _e253 = phi_349_;
                        phi_350_ = _e253;
                        phi_351_ = false;
                    } else {
                        phi_350_ = bool();
                        phi_351_ = true;
                    }
                    let _e255 = phi_350_;
                    let _e257 = phi_351_;
                    phi_352_ = _e255;
                    phi_353_ = _e257;
                } else {
                    phi_352_ = bool();
                    phi_353_ = true;
                }
                let _e259 = phi_352_;
                let _e261 = phi_353_;
                phi_354_ = _e259;
                phi_355_ = _e261;
            } else {
                phi_354_ = bool();
                phi_355_ = true;
            }
            let _e263 = phi_354_;
            let _e265 = phi_355_;
            if _e265 {
                phi_359_ = false;
            } else {
                phi_359_ = _e263;
            }
            let _e267 = phi_359_;
            if _e267 {
                if (0f > 0f) {
                    let _e270 = samples.member[(0u + _e55.first_primitive)].normal;
                    let _e272 = p.member.map_size;
                    let _e342 = ((abs(((((_e61.row_x.x * _e270.x) + (_e61.row_x.y * _e270.y)) + (_e61.row_x.z * _e270.z)) / (((_e61.row_x.x * _e61.row_x.x) + (_e61.row_x.y * _e61.row_x.y)) + (_e61.row_x.z * _e61.row_x.z)))) + abs(((((_e61.row_y.x * _e270.x) + (_e61.row_y.y * _e270.y)) + (_e61.row_y.z * _e270.z)) / (((_e61.row_y.x * _e61.row_y.x) + (_e61.row_y.y * _e61.row_y.y)) + (_e61.row_y.z * _e61.row_y.z))))) / (abs(((((_e61.row_z.x * _e270.x) + (_e61.row_z.y * _e270.y)) + (_e61.row_z.z * _e270.z)) / (((_e61.row_z.x * _e61.row_z.x) + (_e61.row_z.y * _e61.row_z.y)) + (_e61.row_z.z * _e61.row_z.z)))) * f32(_e272)));
                    if (_e342 < 0.002f) {
                        phi_449_ = _e342;
                    } else {
                        phi_449_ = 0.002f;
                    }
                    let _e345 = phi_449_;
                    phi_452_ = (_e240 - (0f * _e345));
                } else {
                    phi_452_ = _e240;
                }
                let _e349 = phi_452_;
                let _e351 = p.member.map_size;
                let _e352 = f32(_e351);
                let _e355 = ((_e213 * _e352) - 0.5f);
                let _e356 = ((_e227 * _e352) - 0.5f);
                if (_e355 > -8388608f) {
                    let _e368 = f32(select(0i, select(select(i32(_e355), i32(-2147483648), (_e355 < bitcast<f32>(3472883712u))), 2147483647i, (_e355 > bitcast<f32>(1325400063u))), (_e355 == _e355)));
                    if (_e368 > _e355) {
                        phi_481_ = 1f;
                    } else {
                        phi_481_ = 0f;
                    }
                    let _e371 = phi_481_;
                    if (_e355 < 8388608f) {
                        phi_486_ = (_e368 - _e371);
                        phi_487_ = false;
                    } else {
                        phi_486_ = f32();
                        phi_487_ = true;
                    }
                    let _e374 = phi_486_;
                    let _e376 = phi_487_;
                    phi_488_ = _e374;
                    phi_489_ = _e376;
                } else {
                    phi_488_ = f32();
                    phi_489_ = true;
                }
                let _e378 = phi_488_;
                let _e380 = phi_489_;
                if _e380 {
                    phi_493_ = _e355;
                } else {
                    phi_493_ = _e378;
                }
                let _e382 = phi_493_;
                if (_e356 > -8388608f) {
                    let _e394 = f32(select(0i, select(select(i32(_e356), i32(-2147483648), (_e356 < bitcast<f32>(3472883712u))), 2147483647i, (_e356 > bitcast<f32>(1325400063u))), (_e356 == _e356)));
                    if (_e394 > _e356) {
                        phi_513_ = 1f;
                    } else {
                        phi_513_ = 0f;
                    }
                    let _e397 = phi_513_;
                    if (_e356 < 8388608f) {
                        phi_518_ = (_e394 - _e397);
                        phi_519_ = false;
                    } else {
                        phi_518_ = f32();
                        phi_519_ = true;
                    }
                    let _e400 = phi_518_;
                    let _e402 = phi_519_;
                    phi_520_ = _e400;
                    phi_521_ = _e402;
                } else {
                    phi_520_ = f32();
                    phi_521_ = true;
                }
                let _e404 = phi_520_;
                let _e406 = phi_521_;
                if _e406 {
                    phi_525_ = _e356;
                } else {
                    phi_525_ = _e404;
                }
                let _e408 = phi_525_;
                let _e409 = (_e355 - _e382);
                let _e410 = (_e356 - _e408);
                let _e419 = select(0i, select(select(i32(_e382), i32(-2147483648), (_e382 < bitcast<f32>(3472883712u))), 2147483647i, (_e382 > bitcast<f32>(1325400063u))), (_e382 == _e382));
                let _e428 = select(0i, select(select(i32(_e408), i32(-2147483648), (_e408 < bitcast<f32>(3472883712u))), 2147483647i, (_e408 > bitcast<f32>(1325400063u))), (_e408 == _e408));
                let _e439 = p.member.test;
                let _e440 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e439);
                let _e442 = p.member.map_size;
                local = _e440;
                let _e444 = ((0u * _e442) * _e442);
                let _e446 = (bitcast<i32>(_e442) - 1i);
                if (_e419 > 0i) {
                    phi_573_ = _e419;
                } else {
                    phi_573_ = 0i;
                }
                let _e449 = phi_573_;
                if (_e428 > 0i) {
                    phi_578_ = _e428;
                } else {
                    phi_578_ = 0i;
                }
                let _e452 = phi_578_;
                if (_e449 < _e446) {
                    phi_583_ = _e449;
                } else {
                    phi_583_ = _e446;
                }
                let _e455 = phi_583_;
                if (_e452 < _e446) {
                    phi_588_ = _e452;
                } else {
                    phi_588_ = _e446;
                }
                let _e458 = phi_588_;
                let _e459 = bitcast<u32>(_e455);
                let _e461 = (_e419 + 1i);
                let _e462 = (_e428 + 1i);
                if (_e461 > 0i) {
                    phi_597_ = _e461;
                } else {
                    phi_597_ = 0i;
                }
                let _e465 = phi_597_;
                if (_e462 > 0i) {
                    phi_602_ = _e462;
                } else {
                    phi_602_ = 0i;
                }
                let _e468 = phi_602_;
                if (_e465 < _e446) {
                    phi_607_ = _e465;
                } else {
                    phi_607_ = _e446;
                }
                let _e471 = phi_607_;
                if (_e468 < _e446) {
                    phi_612_ = _e468;
                } else {
                    phi_612_ = _e446;
                }
                let _e474 = phi_612_;
                let _e475 = bitcast<u32>(_e471);
                let _e477 = (bitcast<u32>(_e458) * _e442);
                let _e478 = (bitcast<u32>(_e474) * _e442);
                let _e483 = ((_e477 + _e459) + _e444);
                let _e484 = ((_e477 + _e475) + _e444);
                let _e485 = ((_e478 + _e459) + _e444);
                let _e486 = ((_e478 + _e475) + _e444);
                if (_e483 < _e46) {
                } else {
                    return;
                }
                let _e490 = map.member[(0u + _e483)];
                if (_e484 < _e46) {
                } else {
                    return;
                }
                let _e494 = map.member[(0u + _e484)];
                if (_e485 < _e46) {
                } else {
                    return;
                }
                let _e498 = map.member[(0u + _e485)];
                if (_e486 < _e46) {
                } else {
                    return;
                }
                let _e502 = map.member[(0u + _e486)];
                let _e504 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e490, _e494, _e498, _e502), vec4<f32>(((1f - _e409) * (1f - _e410)), (_e409 * (1f - _e410)), ((1f - _e409) * _e410), (_e409 * _e410)), _e349);
                phi_657_ = evaluate_Verdict(_e504, false);
                phi_658_ = evaluate_Verdict();
                phi_659_ = false;
            } else {
                phi_657_ = evaluate_Verdict();
                phi_658_ = evaluate_Verdict(1f, false);
                phi_659_ = true;
            }
            let _e508 = phi_657_;
            let _e510 = phi_658_;
            let _e512 = phi_659_;
            phi_660_ = _e510;
            phi_661_ = _e508;
            phi_662_ = _e512;
        }
        let _e514 = phi_660_;
        let _e516 = phi_661_;
        let _e518 = phi_662_;
        if _e518 {
            phi_666_ = _e514;
        } else {
            phi_666_ = _e516;
        }
        let _e520 = phi_666_;
        if (_e55.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e55.first_primitive)] = _e520.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
