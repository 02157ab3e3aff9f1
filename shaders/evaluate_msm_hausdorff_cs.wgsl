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
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_27 {
    member: abi_ShadowParams,
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
    var phi_130_: lt_bvh_traverse_Tree;
    var phi_131_: bool;
    var phi_132_: lt_bvh_traverse_Tree;
    var phi_133_: bool;
    var phi_138_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_130_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_131_ = false;
        } else {
            phi_130_ = lt_bvh_traverse_Tree();
            phi_131_ = true;
        }
        let _e51 = phi_130_;
        let _e53 = phi_131_;
        phi_132_ = _e51;
        phi_133_ = _e53;
    } else {
        phi_132_ = lt_bvh_traverse_Tree();
        phi_133_ = true;
    }
    let _e55 = phi_132_;
    let _e57 = phi_133_;
    if _e57 {
        phi_138_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_138_ = _e55;
    }
    let _e62 = phi_138_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_691_: f32;
    var phi_692_: f32;
    var phi_693_: f32;
    var phi_710_: f32;
    var phi_711_: f32;
    var phi_712_: f32;
    var phi_728_: f32;
    var phi_729_: f32;
    var phi_730_: f32;
    var phi_746_: f32;
    var phi_747_: f32;
    var phi_748_: f32;
    var phi_764_: f32;
    var phi_765_: f32;
    var phi_766_: f32;
    var phi_801_: bool;
    var phi_802_: bool;
    var phi_803_: bool;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_810_: bool;
    var phi_1121_: f32;
    var phi_1122_: f32;
    var phi_1123_: f32;
    var phi_1140_: f32;
    var phi_1141_: f32;
    var phi_1142_: f32;
    var phi_1159_: f32;
    var phi_1160_: f32;
    var phi_1161_: f32;
    var phi_1178_: f32;
    var phi_1179_: f32;
    var phi_1180_: f32;
    var phi_1203_: f32;
    var phi_1204_: f32;
    var phi_1205_: f32;
    var phi_1216_: f32;
    var phi_1231_: f32;
    var phi_1233_: lt_bvh_slab_Span;
    var phi_1291_: f32;
    var phi_1292_: f32;
    var phi_1293_: f32;
    var phi_1294_: f32;
    var phi_1295_: f32;
    var phi_1296_: bool;
    var phi_1300_: f32;
    var phi_1310_: bool;
    var phi_1323_: bool;
    var phi_1327_: bool;
    var phi_1328_: bool;
    var phi_1338_: bool;
    var phi_1339_: bool;
    var phi_1340_: bool;
    var phi_1344_: bool;
    var phi_1395_: f32;
    var phi_1396_: f32;
    var phi_1397_: f32;
    var phi_1414_: f32;
    var phi_1415_: f32;
    var phi_1416_: f32;
    var phi_1433_: f32;
    var phi_1434_: f32;
    var phi_1435_: f32;
    var phi_1452_: f32;
    var phi_1453_: f32;
    var phi_1454_: f32;
    var phi_1477_: f32;
    var phi_1478_: f32;
    var phi_1479_: f32;
    var phi_1566_: f32;
    var phi_1567_: f32;
    var phi_1578_: bool;
    var phi_1582_: f32;
    var phi_1583_: f32;
    var phi_1598_: f32;
    var phi_1599_: f32;
    var phi_1600_: f32;
    var phi_1601_: f32;
    var phi_1602_: f32;
    var phi_1603_: f32;
    var phi_1604_: f32;
    var phi_1605_: bool;
    var phi_1606_: f32;
    var phi_1607_: f32;
    var phi_1608_: bool;
    var phi_1612_: f32;

    let _e42 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_693_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_692_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_691_ = 1f;
            } else {
                phi_691_ = param_7;
            }
            let _e49 = phi_691_;
            phi_692_ = _e49;
        }
        let _e51 = phi_692_;
        phi_693_ = _e51;
    }
    let _e53 = phi_693_;
    let _e54 = (_e53 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_712_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_711_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_710_ = 1f;
            } else {
                phi_710_ = param_5.x;
            }
            let _e62 = phi_710_;
            phi_711_ = _e62;
        }
        let _e64 = phi_711_;
        phi_712_ = _e64;
    }
    let _e66 = phi_712_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_730_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_729_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_728_ = 1f;
            } else {
                phi_728_ = param_5.y;
            }
            let _e74 = phi_728_;
            phi_729_ = _e74;
        }
        let _e76 = phi_729_;
        phi_730_ = _e76;
    }
    let _e78 = phi_730_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_748_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_747_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_746_ = 1f;
            } else {
                phi_746_ = param_5.z;
            }
            let _e86 = phi_746_;
            phi_747_ = _e86;
        }
        let _e88 = phi_747_;
        phi_748_ = _e88;
    }
    let _e90 = phi_748_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_766_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_765_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_764_ = 1f;
            } else {
                phi_764_ = param_5.w;
            }
            let _e98 = phi_764_;
            phi_765_ = _e98;
        }
        let _e100 = phi_765_;
        phi_766_ = _e100;
    }
    let _e102 = phi_766_;
    let _e103 = (_e66 - _e54);
    let _e104 = (_e78 - _e54);
    let _e105 = (_e90 - _e54);
    let _e106 = (_e102 - _e54);
    let _e117 = ((((_e103 * param_6.x) + (_e104 * param_6.y)) + (_e105 * param_6.z)) + (_e106 * param_6.w));
    if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
        phi_1606_ = _e117;
        phi_1607_ = f32();
        phi_1608_ = true;
    } else {
        if (_e103 >= 0f) {
            if (_e104 >= 0f) {
                if (_e105 >= 0f) {
                    phi_801_ = (_e106 >= 0f);
                    phi_802_ = false;
                } else {
                    phi_801_ = bool();
                    phi_802_ = true;
                }
                let _e126 = phi_801_;
                let _e128 = phi_802_;
                phi_803_ = _e126;
                phi_804_ = _e128;
            } else {
                phi_803_ = bool();
                phi_804_ = true;
            }
            let _e130 = phi_803_;
            let _e132 = phi_804_;
            phi_805_ = _e130;
            phi_806_ = _e132;
        } else {
            phi_805_ = bool();
            phi_806_ = true;
        }
        let _e134 = phi_805_;
        let _e136 = phi_806_;
        if _e136 {
            phi_810_ = false;
        } else {
            phi_810_ = _e134;
        }
        let _e138 = phi_810_;
        if _e138 {
            phi_1603_ = 1f;
            phi_1604_ = f32();
            phi_1605_ = true;
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
                    phi_1123_ = _e103;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1122_ = 0f;
                    } else {
                        if (_e103 < 0f) {
                            phi_1121_ = 0f;
                        } else {
                            phi_1121_ = 1f;
                        }
                        let _e435 = phi_1121_;
                        phi_1122_ = _e435;
                    }
                    let _e437 = phi_1122_;
                    phi_1123_ = _e437;
                }
                let _e439 = phi_1123_;
                if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                    phi_1142_ = _e104;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1141_ = 0f;
                    } else {
                        if (_e104 < 0f) {
                            phi_1140_ = 0f;
                        } else {
                            phi_1140_ = 1f;
                        }
                        let _e448 = phi_1140_;
                        phi_1141_ = _e448;
                    }
                    let _e450 = phi_1141_;
                    phi_1142_ = _e450;
                }
                let _e452 = phi_1142_;
                if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
                    phi_1161_ = _e105;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1160_ = 0f;
                    } else {
                        if (_e105 < 0f) {
                            phi_1159_ = 0f;
                        } else {
                            phi_1159_ = 1f;
                        }
                        let _e461 = phi_1159_;
                        phi_1160_ = _e461;
                    }
                    let _e463 = phi_1160_;
                    phi_1161_ = _e463;
                }
                let _e465 = phi_1161_;
                if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                    phi_1180_ = _e106;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1179_ = 0f;
                    } else {
                        if (_e106 < 0f) {
                            phi_1178_ = 0f;
                        } else {
                            phi_1178_ = 1f;
                        }
                        let _e474 = phi_1178_;
                        phi_1179_ = _e474;
                    }
                    let _e476 = phi_1179_;
                    phi_1180_ = _e476;
                }
                let _e478 = phi_1180_;
                let _e486 = (((((_e439 * _e142) + (_e452 * _e144)) + (_e465 * _e146)) + (_e478 * _e148)) + _e139);
                if ((bitcast<u32>(_e486) & 2147483647u) > 2139095040u) {
                    phi_1205_ = _e486;
                } else {
                    if (_e486 < 0f) {
                        phi_1204_ = 0f;
                    } else {
                        if (_e486 > 1f) {
                            phi_1203_ = 1f;
                        } else {
                            phi_1203_ = _e486;
                        }
                        let _e493 = phi_1203_;
                        phi_1204_ = _e493;
                    }
                    let _e495 = phi_1204_;
                    phi_1205_ = _e495;
                }
                let _e497 = phi_1205_;
                phi_1601_ = _e497;
                phi_1602_ = f32();
            } else {
                let _e499 = ((0.5f * -(((((((((_e203 * (_e103 + _e104)) + (_e207 * (_e103 + _e105))) + (_e231 * (_e103 + _e149))) + (_e243 * (_e103 + _e150))) + ((((_e204 * (_e104 + _e105)) + (_e208 * (_e104 + _e106))) + (_e232 * (_e104 + _e149))) + (_e244 * (_e104 + _e150)))) + ((((_e205 * (_e105 + _e106)) + (_e209 * (_e105 + _e103))) + (_e233 * (_e105 + _e149))) + (_e245 * (_e105 + _e150)))) + ((((_e206 * (_e106 + _e103)) + (_e210 * (_e106 + _e104))) + (_e234 * (_e106 + _e149))) + (_e246 * (_e106 + _e150)))) + (_e417 * (_e149 + _e150))))) / _e420);
                let _e500 = ((((((((_e203 + _e207) + _e231) + _e243) + (((_e204 + _e208) + _e232) + _e244)) + (((_e205 + _e209) + _e233) + _e245)) + (((_e206 + _e210) + _e234) + _e246)) + _e417) / _e420);
                let _e502 = ((_e499 * _e499) - _e500);
                if (_e502 > 0f) {
                    phi_1216_ = sqrt(_e502);
                } else {
                    phi_1216_ = 0f;
                }
                let _e506 = phi_1216_;
                if (_e499 > 0f) {
                    let _e509 = (-(_e499) - _e506);
                    phi_1233_ = lt_bvh_slab_Span(_e509, (_e500 / _e509));
                } else {
                    let _e512 = (_e506 - _e499);
                    if (_e512 > 0f) {
                        phi_1231_ = (_e500 / _e512);
                    } else {
                        phi_1231_ = 0f;
                    }
                    let _e516 = phi_1231_;
                    phi_1233_ = lt_bvh_slab_Span(_e516, _e512);
                }
                let _e519 = phi_1233_;
                if (_e519.near >= 0f) {
                    phi_1294_ = 1f;
                    phi_1295_ = f32();
                    phi_1296_ = true;
                } else {
                    let _e523 = (_e519.far <= 0f);
                    if _e523 {
                        phi_1292_ = (_e414 / _e420);
                        phi_1293_ = f32();
                    } else {
                        let _e534 = (((((_e142 * _e103) + (_e144 * _e104)) + (_e146 * _e105)) + (_e148 * _e106)) + (_e139 * (_e149 + _e150)));
                        let _e550 = (((((_e142 * (_e103 * _e103)) + (_e144 * (_e104 * _e104))) + (_e146 * (_e105 * _e105))) + (_e148 * (_e106 * _e106))) + (_e139 * ((_e149 * _e149) + (_e150 * _e150))));
                        if (-(_e519.near) <= _e519.far) {
                            phi_1291_ = (1f - (((_e519.near * _e519.near) * ((_e519.far * _e550) - _e534)) / (_e519.far - _e519.near)));
                        } else {
                            phi_1291_ = ((_e414 / _e420) + (((_e519.far * _e519.far) * (_e534 - (_e519.near * _e550))) / (_e519.far - _e519.near)));
                        }
                        let _e569 = phi_1291_;
                        phi_1292_ = f32();
                        phi_1293_ = _e569;
                    }
                    let _e571 = phi_1292_;
                    let _e573 = phi_1293_;
                    phi_1294_ = _e571;
                    phi_1295_ = _e573;
                    phi_1296_ = _e523;
                }
                let _e575 = phi_1294_;
                let _e577 = phi_1295_;
                let _e579 = phi_1296_;
                if _e579 {
                    phi_1300_ = _e575;
                } else {
                    phi_1300_ = _e577;
                }
                let _e581 = phi_1300_;
                if ((_e519.near * _e149) >= (1f - 0.00001f)) {
                    phi_1310_ = true;
                } else {
                    phi_1310_ = ((_e519.near * _e150) >= (1f - 0.00001f));
                }
                let _e589 = phi_1310_;
                if _e589 {
                    if ((_e519.far * _e149) >= (1f - 0.00001f)) {
                        phi_1323_ = true;
                    } else {
                        phi_1323_ = ((_e519.far * _e150) >= (1f - 0.00001f));
                    }
                    let _e597 = phi_1323_;
                    if _e597 {
                        phi_1327_ = false;
                    } else {
                        phi_1327_ = true;
                    }
                    let _e599 = phi_1327_;
                    phi_1328_ = _e599;
                } else {
                    phi_1328_ = true;
                }
                let _e601 = phi_1328_;
                if _e601 {
                    let _e603 = (-(_e149) < 0.0001f);
                    if _e603 {
                        phi_1338_ = bool();
                    } else {
                        phi_1338_ = (_e150 < 0.0001f);
                    }
                    let _e606 = phi_1338_;
                    phi_1339_ = _e606;
                    phi_1340_ = _e603;
                } else {
                    phi_1339_ = bool();
                    phi_1340_ = true;
                }
                let _e608 = phi_1339_;
                let _e610 = phi_1340_;
                if _e610 {
                    phi_1344_ = true;
                } else {
                    phi_1344_ = _e608;
                }
                let _e612 = phi_1344_;
                if !(_e612) {
                    let _e618 = ((_e142 * _e66) * _e152);
                    let _e619 = ((_e144 * _e78) * _e154);
                    let _e620 = ((_e146 * _e90) * _e156);
                    let _e621 = ((_e148 * _e102) * _e158);
                    let _e639 = ((((_e618 * (_e103 * _e103)) + (_e619 * (_e104 * _e104))) + (_e620 * (_e105 * _e105))) + (_e621 * (_e106 * _e106)));
                    if (_e639 < 0.0000000000000000000000000000000001f) {
                        if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
                            phi_1397_ = _e103;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_1396_ = 0f;
                            } else {
                                if (_e103 < 0f) {
                                    phi_1395_ = 0f;
                                } else {
                                    phi_1395_ = 1f;
                                }
                                let _e649 = phi_1395_;
                                phi_1396_ = _e649;
                            }
                            let _e651 = phi_1396_;
                            phi_1397_ = _e651;
                        }
                        let _e653 = phi_1397_;
                        if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                            phi_1416_ = _e104;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_1415_ = 0f;
                            } else {
                                if (_e104 < 0f) {
                                    phi_1414_ = 0f;
                                } else {
                                    phi_1414_ = 1f;
                                }
                                let _e662 = phi_1414_;
                                phi_1415_ = _e662;
                            }
                            let _e664 = phi_1415_;
                            phi_1416_ = _e664;
                        }
                        let _e666 = phi_1416_;
                        if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
                            phi_1435_ = _e105;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_1434_ = 0f;
                            } else {
                                if (_e105 < 0f) {
                                    phi_1433_ = 0f;
                                } else {
                                    phi_1433_ = 1f;
                                }
                                let _e675 = phi_1433_;
                                phi_1434_ = _e675;
                            }
                            let _e677 = phi_1434_;
                            phi_1435_ = _e677;
                        }
                        let _e679 = phi_1435_;
                        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                            phi_1454_ = _e106;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_1453_ = 0f;
                            } else {
                                if (_e106 < 0f) {
                                    phi_1452_ = 0f;
                                } else {
                                    phi_1452_ = 1f;
                                }
                                let _e688 = phi_1452_;
                                phi_1453_ = _e688;
                            }
                            let _e690 = phi_1453_;
                            phi_1454_ = _e690;
                        }
                        let _e692 = phi_1454_;
                        let _e700 = (((((_e653 * _e142) + (_e666 * _e144)) + (_e679 * _e146)) + (_e692 * _e148)) + _e139);
                        if ((bitcast<u32>(_e700) & 2147483647u) > 2139095040u) {
                            phi_1479_ = _e700;
                        } else {
                            if (_e700 < 0f) {
                                phi_1478_ = 0f;
                            } else {
                                if (_e700 > 1f) {
                                    phi_1477_ = 1f;
                                } else {
                                    phi_1477_ = _e700;
                                }
                                let _e707 = phi_1477_;
                                phi_1478_ = _e707;
                            }
                            let _e709 = phi_1478_;
                            phi_1479_ = _e709;
                        }
                        let _e711 = phi_1479_;
                        phi_1567_ = _e711;
                    } else {
                        let _e712 = (((((_e618 * _e103) + (_e619 * _e104)) + (_e620 * _e105)) + (_e621 * _e106)) / _e639);
                        let _e729 = ((_e142 * _e103) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e712 * _e103)));
                        let _e730 = ((_e144 * _e104) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e712 * _e104)));
                        let _e731 = ((_e146 * _e105) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e712 * _e105)));
                        let _e732 = ((_e148 * _e106) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e712 * _e106)));
                        if (_e712 > 0f) {
                            phi_1566_ = ((1f - _e139) - (((((_e729 * _e152) + (_e730 * _e154)) + (_e731 * _e156)) + (_e732 * _e158)) / (_e149 * (1f - (_e149 * _e712)))));
                        } else {
                            phi_1566_ = ((((((((_e618 * ((_e619 * _e163) + ((0.5f * _e620) * _e171))) * vec4<f32>(1f, 1f, 1f, 1f).x) + ((_e619 * ((_e620 * _e164) + ((0.5f * _e621) * _e172))) * vec4<f32>(1f, 1f, 1f, 1f).y)) + ((_e620 * ((_e621 * _e165) + ((0.5f * _e618) * _e173))) * vec4<f32>(1f, 1f, 1f, 1f).z)) + ((_e621 * ((_e618 * _e166) + ((0.5f * _e619) * _e174))) * vec4<f32>(1f, 1f, 1f, 1f).w)) / (_e639 * (-(_e149) * _e150))) + _e139) + (((((_e729 * _e66) + (_e730 * _e78)) + (_e731 * _e90)) + (_e732 * _e102)) / (_e150 * (1f - (_e712 * _e150)))));
                        }
                        let _e796 = phi_1566_;
                        phi_1567_ = _e796;
                    }
                    let _e798 = phi_1567_;
                    if ((bitcast<u32>(_e581) & 2147483647u) > 2139095040u) {
                        phi_1578_ = true;
                    } else {
                        let _e802 = (_e581 < _e798);
                        if _e802 {
                        }
                        phi_1578_ = _e802;
                    }
                    let _e804 = phi_1578_;
                    if _e804 {
                        phi_1582_ = _e581;
                    } else {
                        phi_1582_ = _e798;
                    }
                    let _e806 = phi_1582_;
                    phi_1583_ = _e806;
                } else {
                    phi_1583_ = _e581;
                }
                let _e808 = phi_1583_;
                if ((bitcast<u32>(_e808) & 2147483647u) > 2139095040u) {
                    phi_1600_ = _e808;
                } else {
                    if (_e808 < 0f) {
                        phi_1599_ = 0f;
                    } else {
                        if (_e808 > 1f) {
                            phi_1598_ = 1f;
                        } else {
                            phi_1598_ = _e808;
                        }
                        let _e815 = phi_1598_;
                        phi_1599_ = _e815;
                    }
                    let _e817 = phi_1599_;
                    phi_1600_ = _e817;
                }
                let _e819 = phi_1600_;
                phi_1601_ = f32();
                phi_1602_ = _e819;
            }
            let _e821 = phi_1601_;
            let _e823 = phi_1602_;
            phi_1603_ = _e821;
            phi_1604_ = _e823;
            phi_1605_ = _e426;
        }
        let _e825 = phi_1603_;
        let _e827 = phi_1604_;
        let _e829 = phi_1605_;
        phi_1606_ = _e825;
        phi_1607_ = _e827;
        phi_1608_ = _e829;
    }
    let _e831 = phi_1606_;
    let _e833 = phi_1607_;
    let _e835 = phi_1608_;
    if _e835 {
        phi_1612_ = _e831;
    } else {
        phi_1612_ = _e833;
    }
    let _e837 = phi_1612_;
    return _e837;
}

fn function_() {
    var local: f32;
    var phi_198_: bool;
    var phi_199_: bool;
    var phi_200_: bool;
    var phi_201_: bool;
    var phi_205_: bool;
    var phi_249_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_253_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_330_: bool;
    var phi_339_: bool;
    var phi_348_: bool;
    var phi_349_: bool;
    var phi_350_: bool;
    var phi_351_: bool;
    var phi_352_: bool;
    var phi_353_: bool;
    var phi_354_: bool;
    var phi_358_: bool;
    var phi_452_: f32;
    var phi_455_: f32;
    var phi_484_: f32;
    var phi_489_: f32;
    var phi_490_: bool;
    var phi_491_: f32;
    var phi_492_: bool;
    var phi_496_: f32;
    var phi_516_: f32;
    var phi_521_: f32;
    var phi_522_: bool;
    var phi_523_: f32;
    var phi_524_: bool;
    var phi_528_: f32;
    var phi_574_: i32;
    var phi_579_: i32;
    var phi_584_: i32;
    var phi_589_: i32;
    var phi_598_: i32;
    var phi_603_: i32;
    var phi_608_: i32;
    var phi_613_: i32;
    var phi_654_: evaluate_Verdict;
    var phi_655_: evaluate_Verdict;
    var phi_656_: bool;
    var phi_657_: evaluate_Verdict;
    var phi_658_: evaluate_Verdict;
    var phi_659_: bool;
    var phi_663_: evaluate_Verdict;

    let _e39 = id_1;
    let _e46 = arrayLength((&map.member));
    let _e52 = p.member.size[0u];
    let _e54 = p.member.size[1u];
    let _e55 = lt_shaders_entry_pixel_index(_e39, _e52, _e54);
    if (bitcast<i32>(_e55.root) != 0i) {
        if (_e55.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e64 = p.member.light;
        let _e67 = samples.member[(0u + _e55.first_primitive)].normal[0u];
        let _e69 = global[0u];
        if (_e67 == _e69) {
            let _e72 = samples.member[(0u + _e55.first_primitive)].normal[1u];
            let _e74 = global[1u];
            if (_e72 == _e74) {
                let _e77 = samples.member[(0u + _e55.first_primitive)].normal[2u];
                let _e79 = global[2u];
                phi_198_ = (_e77 == _e79);
                phi_199_ = false;
            } else {
                phi_198_ = bool();
                phi_199_ = true;
            }
            let _e82 = phi_198_;
            let _e84 = phi_199_;
            phi_200_ = _e82;
            phi_201_ = _e84;
        } else {
            phi_200_ = bool();
            phi_201_ = true;
        }
        let _e86 = phi_200_;
        let _e88 = phi_201_;
        if _e88 {
            phi_205_ = false;
        } else {
            phi_205_ = _e86;
        }
        let _e90 = phi_205_;
        if !(_e90) {
            let _e93 = samples.member[(0u + _e55.first_primitive)].normal;
            let _e95 = samples.member[(0u + _e55.first_primitive)].position;
            if ((((_e93.x * (_e64.x - (_e95.x * _e64.w))) + (_e93.y * (_e64.y - (_e95.y * _e64.w)))) + (_e93.z * (_e64.z - (_e95.z * _e64.w)))) > 0f) {
                let _e119 = samples.member[(0u + _e55.first_primitive)].flags;
                let _e127 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e127.unnamed.visibility, false), _e127.unnamed_1);
                phi_249_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e133.unnamed, ((_e119 & 1u) == 0u));
            } else {
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e142.unnamed.visibility, false), _e142.unnamed_1);
                phi_249_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e148.unnamed, true);
            }
            let _e153 = phi_249_;
            phi_253_ = _e153;
        } else {
            let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e159.unnamed.visibility, false), _e159.unnamed_1);
            phi_253_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e165.unnamed, true);
        }
        let _e170 = phi_253_;
        if _e170.unnamed_1 {
            phi_657_ = evaluate_Verdict(_e170.unnamed.visibility, _e170.unnamed.is_doubted);
            phi_658_ = evaluate_Verdict();
            phi_659_ = true;
        } else {
            let _e178 = samples.member[(0u + _e55.first_primitive)].position;
            let _e184 = p.member.projection.row_w;
            let _e195 = ((((_e184.x * _e178.x) + (_e184.y * _e178.y)) + (_e184.z * _e178.z)) + (_e184.w * 1f));
            let _e197 = p.member.projection.row_x;
            let _e209 = (((((_e197.x * _e178.x) + (_e197.y * _e178.y)) + (_e197.z * _e178.z)) + (_e197.w * 1f)) / _e195);
            let _e211 = p.member.projection.row_y;
            let _e223 = (((((_e211.x * _e178.x) + (_e211.y * _e178.y)) + (_e211.z * _e178.z)) + (_e211.w * 1f)) / _e195);
            let _e225 = p.member.projection.row_z;
            let _e236 = ((((_e225.x * _e178.x) + (_e225.y * _e178.y)) + (_e225.z * _e178.z)) + (_e225.w * 1f));
            if (_e195 > 0f) {
                if (_e209 >= 0f) {
                    phi_330_ = (_e209 <= 1f);
                } else {
                    phi_330_ = false;
                }
                let _e241 = phi_330_;
                if _e241 {
                    if (_e223 >= 0f) {
                        phi_339_ = (_e223 <= 1f);
                    } else {
                        phi_339_ = false;
                    }
                    let _e245 = phi_339_;
                    if _e245 {
                        if (_e236 >= 0f) {
                            phi_348_ = (_e236 <= 1f);
                        } else {
                            phi_348_ = false;
                        }
                        let _e249 = phi_348_;
                        phi_349_ = _e249;
                        phi_350_ = false;
                    } else {
                        phi_349_ = bool();
                        phi_350_ = true;
                    }
                    let _e251 = phi_349_;
                    let _e253 = phi_350_;
                    phi_351_ = _e251;
                    phi_352_ = _e253;
                } else {
                    phi_351_ = bool();
                    phi_352_ = true;
                }
                let _e255 = phi_351_;
                let _e257 = phi_352_;
                phi_353_ = _e255;
                phi_354_ = _e257;
            } else {
                phi_353_ = bool();
                phi_354_ = true;
            }
            let _e259 = phi_353_;
            let _e261 = phi_354_;
            if _e261 {
                phi_358_ = false;
            } else {
                phi_358_ = _e259;
            }
            let _e263 = phi_358_;
            if _e263 {
                if (0f > 0f) {
                    let _e266 = samples.member[(0u + _e55.first_primitive)].normal;
                    let _e268 = p.member.map_size;
                    let _e271 = p.member.projection.row_x;
                    let _e293 = p.member.projection.row_y;
                    let _e315 = p.member.projection.row_z;
                    let _e342 = ((abs(((((_e271.x * _e266.x) + (_e271.y * _e266.y)) + (_e271.z * _e266.z)) / (((_e271.x * _e271.x) + (_e271.y * _e271.y)) + (_e271.z * _e271.z)))) + abs(((((_e293.x * _e266.x) + (_e293.y * _e266.y)) + (_e293.z * _e266.z)) / (((_e293.x * _e293.x) + (_e293.y * _e293.y)) + (_e293.z * _e293.z))))) / (abs(((((_e315.x * _e266.x) + (_e315.y * _e266.y)) + (_e315.z * _e266.z)) / (((_e315.x * _e315.x) + (_e315.y * _e315.y)) + (_e315.z * _e315.z)))) * f32(_e268)));
                    if (_e342 < 0.002f) {
                        phi_452_ = _e342;
                    } else {
                        phi_452_ = 0.002f;
                    }
                    let _e345 = phi_452_;
                    phi_455_ = (_e236 - (0f * _e345));
                } else {
                    phi_455_ = _e236;
                }
                let _e349 = phi_455_;
                let _e351 = p.member.map_size;
                let _e352 = f32(_e351);
                let _e355 = ((_e209 * _e352) - 0.5f);
                let _e356 = ((_e223 * _e352) - 0.5f);
                if (_e355 > -8388608f) {
                    let _e368 = f32(select(0i, select(select(i32(_e355), i32(-2147483648), (_e355 < bitcast<f32>(3472883712u))), 2147483647i, (_e355 > bitcast<f32>(1325400063u))), (_e355 == _e355)));
                    if (_e368 > _e355) {
                        phi_484_ = 1f;
                    } else {
                        phi_484_ = 0f;
                    }
                    let _e371 = phi_484_;
                    if (_e355 < 8388608f) {
                        phi_489_ = (_e368 - _e371);
                        phi_490_ = false;
                    } else {
                        phi_489_ = f32();
                        phi_490_ = true;
                    }
                    let _e374 = phi_489_;
                    let _e376 = phi_490_;
                    phi_491_ = _e374;
                    phi_492_ = _e376;
                } else {
                    phi_491_ = f32();
                    phi_492_ = true;
                }
                let _e378 = phi_491_;
                let _e380 = phi_492_;
                if _e380 {
                    phi_496_ = _e355;
                } else {
                    phi_496_ = _e378;
                }
                let _e382 = phi_496_;
                if (_e356 > -8388608f) {
                    let _e394 = f32(select(0i, select(select(i32(_e356), i32(-2147483648), (_e356 < bitcast<f32>(3472883712u))), 2147483647i, (_e356 > bitcast<f32>(1325400063u))), (_e356 == _e356)));
                    if (_e394 > _e356) {
                        phi_516_ = 1f;
                    } else {
                        phi_516_ = 0f;
                    }
                    let _e397 = phi_516_;
                    if (_e356 < 8388608f) {
                        phi_521_ = (_e394 - _e397);
                        phi_522_ = false;
                    } else {
                        phi_521_ = f32();
                        phi_522_ = true;
                    }
                    let _e400 = phi_521_;
                    let _e402 = phi_522_;
                    phi_523_ = _e400;
                    phi_524_ = _e402;
                } else {
                    phi_523_ = f32();
                    phi_524_ = true;
                }
                let _e404 = phi_523_;
                let _e406 = phi_524_;
                if _e406 {
                    phi_528_ = _e356;
                } else {
                    phi_528_ = _e404;
                }
                let _e408 = phi_528_;
                let _e409 = (_e355 - _e382);
                let _e410 = (_e356 - _e408);
                let _e419 = select(0i, select(select(i32(_e382), i32(-2147483648), (_e382 < bitcast<f32>(3472883712u))), 2147483647i, (_e382 > bitcast<f32>(1325400063u))), (_e382 == _e382));
                let _e428 = select(0i, select(select(i32(_e408), i32(-2147483648), (_e408 < bitcast<f32>(3472883712u))), 2147483647i, (_e408 > bitcast<f32>(1325400063u))), (_e408 == _e408));
                let _e439 = p.member.test;
                let _e440 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e439);
                let _e442 = p.member.map_size;
                local = _e440;
                let _e444 = (bitcast<i32>(_e442) - 1i);
                if (_e419 > 0i) {
                    phi_574_ = _e419;
                } else {
                    phi_574_ = 0i;
                }
                let _e447 = phi_574_;
                if (_e428 > 0i) {
                    phi_579_ = _e428;
                } else {
                    phi_579_ = 0i;
                }
                let _e450 = phi_579_;
                if (_e447 < _e444) {
                    phi_584_ = _e447;
                } else {
                    phi_584_ = _e444;
                }
                let _e453 = phi_584_;
                if (_e450 < _e444) {
                    phi_589_ = _e450;
                } else {
                    phi_589_ = _e444;
                }
                let _e456 = phi_589_;
                let _e457 = bitcast<u32>(_e453);
                let _e459 = (_e419 + 1i);
                let _e460 = (_e428 + 1i);
                if (_e459 > 0i) {
                    phi_598_ = _e459;
                } else {
                    phi_598_ = 0i;
                }
                let _e463 = phi_598_;
                if (_e460 > 0i) {
                    phi_603_ = _e460;
                } else {
                    phi_603_ = 0i;
                }
                let _e466 = phi_603_;
                if (_e463 < _e444) {
                    phi_608_ = _e463;
                } else {
                    phi_608_ = _e444;
                }
                let _e469 = phi_608_;
                if (_e466 < _e444) {
                    phi_613_ = _e466;
                } else {
                    phi_613_ = _e444;
                }
                let _e472 = phi_613_;
                let _e473 = bitcast<u32>(_e469);
                let _e475 = (bitcast<u32>(_e456) * _e442);
                let _e476 = (bitcast<u32>(_e472) * _e442);
                let _e477 = (_e475 + _e457);
                let _e478 = (_e475 + _e473);
                let _e479 = (_e476 + _e457);
                let _e480 = (_e476 + _e473);
                if (_e477 < _e46) {
                } else {
                    return;
                }
                let _e484 = map.member[(0u + _e477)];
                if (_e478 < _e46) {
                } else {
                    return;
                }
                let _e488 = map.member[(0u + _e478)];
                if (_e479 < _e46) {
                } else {
                    return;
                }
                let _e492 = map.member[(0u + _e479)];
                if (_e480 < _e46) {
                } else {
                    return;
                }
                let _e496 = map.member[(0u + _e480)];
                let _e498 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e484, _e488, _e492, _e496), vec4<f32>(((1f - _e409) * (1f - _e410)), (_e409 * (1f - _e410)), ((1f - _e409) * _e410), (_e409 * _e410)), _e349);
                phi_654_ = evaluate_Verdict(_e498, false);
                phi_655_ = evaluate_Verdict();
                phi_656_ = false;
            } else {
                phi_654_ = evaluate_Verdict();
                phi_655_ = evaluate_Verdict(1f, false);
                phi_656_ = true;
            }
            let _e502 = phi_654_;
            let _e504 = phi_655_;
            let _e506 = phi_656_;
            phi_657_ = _e504;
            phi_658_ = _e502;
            phi_659_ = _e506;
        }
        let _e508 = phi_657_;
        let _e510 = phi_658_;
        let _e512 = phi_659_;
        if _e512 {
            phi_663_ = _e508;
        } else {
            phi_663_ = _e510;
        }
        let _e514 = phi_663_;
        if (_e55.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e55.first_primitive)] = _e514.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
