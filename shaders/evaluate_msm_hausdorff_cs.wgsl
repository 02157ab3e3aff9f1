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

struct type_30 {
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
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> map: type_19;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_133_: lt_bvh_traverse_Tree;
    var phi_134_: bool;
    var phi_135_: lt_bvh_traverse_Tree;
    var phi_136_: bool;
    var phi_141_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_133_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_134_ = false;
        } else {
            phi_133_ = lt_bvh_traverse_Tree();
            phi_134_ = true;
        }
        let _e49 = phi_133_;
        let _e51 = phi_134_;
        phi_135_ = _e49;
        phi_136_ = _e51;
    } else {
        phi_135_ = lt_bvh_traverse_Tree();
        phi_136_ = true;
    }
    let _e53 = phi_135_;
    let _e55 = phi_136_;
    if _e55 {
        phi_141_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_141_ = _e53;
    }
    let _e60 = phi_141_;
    return lt_bvh_traverse_Tree(_e60.root, _e60.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_743_: f32;
    var phi_744_: f32;
    var phi_745_: f32;
    var phi_762_: f32;
    var phi_763_: f32;
    var phi_764_: f32;
    var phi_780_: f32;
    var phi_781_: f32;
    var phi_782_: f32;
    var phi_798_: f32;
    var phi_799_: f32;
    var phi_800_: f32;
    var phi_816_: f32;
    var phi_817_: f32;
    var phi_818_: f32;
    var phi_853_: bool;
    var phi_854_: bool;
    var phi_855_: bool;
    var phi_856_: bool;
    var phi_857_: bool;
    var phi_858_: bool;
    var phi_862_: bool;
    var phi_1173_: f32;
    var phi_1174_: f32;
    var phi_1175_: f32;
    var phi_1192_: f32;
    var phi_1193_: f32;
    var phi_1194_: f32;
    var phi_1211_: f32;
    var phi_1212_: f32;
    var phi_1213_: f32;
    var phi_1230_: f32;
    var phi_1231_: f32;
    var phi_1232_: f32;
    var phi_1255_: f32;
    var phi_1256_: f32;
    var phi_1257_: f32;
    var phi_1304_: f32;
    var phi_1305_: f32;
    var phi_1306_: f32;
    var phi_1323_: f32;
    var phi_1324_: f32;
    var phi_1325_: f32;
    var phi_1342_: f32;
    var phi_1343_: f32;
    var phi_1344_: f32;
    var phi_1361_: f32;
    var phi_1362_: f32;
    var phi_1363_: f32;
    var phi_1386_: f32;
    var phi_1387_: f32;
    var phi_1388_: f32;
    var phi_1467_: bool;
    var phi_1511_: f32;
    var phi_1512_: f32;
    var phi_1513_: bool;
    var phi_1514_: f32;
    var phi_1515_: bool;
    var phi_1516_: f32;
    var phi_1517_: bool;
    var phi_1521_: f32;
    var phi_1522_: f32;
    var phi_1541_: f32;
    var phi_1542_: f32;
    var phi_1543_: f32;
    var phi_1554_: f32;
    var phi_1569_: f32;
    var phi_1571_: lt_bvh_slab_Span;
    var phi_1629_: f32;
    var phi_1630_: f32;
    var phi_1631_: f32;
    var phi_1632_: f32;
    var phi_1633_: f32;
    var phi_1634_: bool;
    var phi_1638_: f32;
    var phi_1653_: f32;
    var phi_1654_: f32;
    var phi_1655_: f32;
    var phi_1656_: f32;
    var phi_1657_: f32;
    var phi_1658_: f32;
    var phi_1659_: f32;
    var phi_1660_: bool;
    var phi_1664_: f32;
    var phi_1665_: f32;
    var phi_1666_: bool;
    var phi_1667_: f32;
    var phi_1668_: f32;
    var phi_1669_: bool;
    var phi_1673_: f32;

    let _e40 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_745_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_744_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_743_ = 1f;
            } else {
                phi_743_ = param_7;
            }
            let _e47 = phi_743_;
            phi_744_ = _e47;
        }
        let _e49 = phi_744_;
        phi_745_ = _e49;
    }
    let _e51 = phi_745_;
    let _e52 = (_e51 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_764_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_763_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_762_ = 1f;
            } else {
                phi_762_ = param_5.x;
            }
            let _e60 = phi_762_;
            phi_763_ = _e60;
        }
        let _e62 = phi_763_;
        phi_764_ = _e62;
    }
    let _e64 = phi_764_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_782_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_781_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_780_ = 1f;
            } else {
                phi_780_ = param_5.y;
            }
            let _e72 = phi_780_;
            phi_781_ = _e72;
        }
        let _e74 = phi_781_;
        phi_782_ = _e74;
    }
    let _e76 = phi_782_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_800_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_799_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_798_ = 1f;
            } else {
                phi_798_ = param_5.z;
            }
            let _e84 = phi_798_;
            phi_799_ = _e84;
        }
        let _e86 = phi_799_;
        phi_800_ = _e86;
    }
    let _e88 = phi_800_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_818_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_817_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_816_ = 1f;
            } else {
                phi_816_ = param_5.w;
            }
            let _e96 = phi_816_;
            phi_817_ = _e96;
        }
        let _e98 = phi_817_;
        phi_818_ = _e98;
    }
    let _e100 = phi_818_;
    let _e101 = (_e64 - _e52);
    let _e102 = (_e76 - _e52);
    let _e103 = (_e88 - _e52);
    let _e104 = (_e100 - _e52);
    let _e115 = ((((_e101 * param_6.x) + (_e102 * param_6.y)) + (_e103 * param_6.z)) + (_e104 * param_6.w));
    if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
        phi_1667_ = _e115;
        phi_1668_ = f32();
        phi_1669_ = true;
    } else {
        if (_e101 >= 0f) {
            if (_e102 >= 0f) {
                if (_e103 >= 0f) {
                    phi_853_ = (_e104 >= 0f);
                    phi_854_ = false;
                } else {
                    phi_853_ = bool();
                    phi_854_ = true;
                }
                let _e124 = phi_853_;
                let _e126 = phi_854_;
                phi_855_ = _e124;
                phi_856_ = _e126;
            } else {
                phi_855_ = bool();
                phi_856_ = true;
            }
            let _e128 = phi_855_;
            let _e130 = phi_856_;
            phi_857_ = _e128;
            phi_858_ = _e130;
        } else {
            phi_857_ = bool();
            phi_858_ = true;
        }
        let _e132 = phi_857_;
        let _e134 = phi_858_;
        if _e134 {
            phi_862_ = false;
        } else {
            phi_862_ = _e132;
        }
        let _e136 = phi_862_;
        if _e136 {
            phi_1664_ = 1f;
            phi_1665_ = f32();
            phi_1666_ = true;
        } else {
            let _e137 = (0.5f * _e40);
            let _e138 = (1f - _e40);
            let _e140 = (param_6.x * _e138);
            let _e142 = (param_6.y * _e138);
            let _e144 = (param_6.z * _e138);
            let _e146 = (param_6.w * _e138);
            let _e147 = -(_e52);
            let _e148 = (1f - _e52);
            let _e150 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e64);
            let _e152 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e76);
            let _e154 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e88);
            let _e156 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e100);
            let _e157 = (_e101 - _e102);
            let _e158 = (_e102 - _e103);
            let _e159 = (_e103 - _e104);
            let _e160 = (_e104 - _e101);
            let _e161 = (_e157 * _e157);
            let _e162 = (_e158 * _e158);
            let _e163 = (_e159 * _e159);
            let _e164 = (_e160 * _e160);
            let _e165 = (_e101 - _e103);
            let _e166 = (_e102 - _e104);
            let _e167 = (_e103 - _e101);
            let _e168 = (_e104 - _e102);
            let _e169 = (_e165 * _e165);
            let _e170 = (_e166 * _e166);
            let _e171 = (_e167 * _e167);
            let _e172 = (_e168 * _e168);
            let _e177 = ((_e140 * _e142) * _e161);
            let _e178 = ((_e142 * _e144) * _e162);
            let _e179 = ((_e144 * _e146) * _e163);
            let _e180 = ((_e146 * _e140) * _e164);
            let _e189 = (((0.5f * _e140) * _e144) * _e169);
            let _e190 = (((0.5f * _e142) * _e146) * _e170);
            let _e191 = (((0.5f * _e144) * _e140) * _e171);
            let _e192 = (((0.5f * _e146) * _e142) * _e172);
            let _e193 = (_e101 * _e102);
            let _e194 = (_e102 * _e103);
            let _e195 = (_e103 * _e104);
            let _e196 = (_e104 * _e101);
            let _e197 = (_e101 * _e103);
            let _e198 = (_e102 * _e104);
            let _e199 = (_e103 * _e101);
            let _e200 = (_e104 * _e102);
            let _e201 = (_e177 * _e193);
            let _e202 = (_e178 * _e194);
            let _e203 = (_e179 * _e195);
            let _e204 = (_e180 * _e196);
            let _e205 = (_e189 * _e197);
            let _e206 = (_e190 * _e198);
            let _e207 = (_e191 * _e199);
            let _e208 = (_e192 * _e200);
            let _e209 = (_e64 * _e64);
            let _e210 = (_e76 * _e76);
            let _e211 = (_e88 * _e88);
            let _e212 = (_e100 * _e100);
            let _e213 = (_e150 * _e150);
            let _e214 = (_e152 * _e152);
            let _e215 = (_e154 * _e154);
            let _e216 = (_e156 * _e156);
            let _e217 = (_e137 * _e140);
            let _e218 = (_e137 * _e142);
            let _e219 = (_e137 * _e144);
            let _e220 = (_e137 * _e146);
            let _e229 = (((_e217 * _e101) * _e209) * _e147);
            let _e230 = (((_e218 * _e102) * _e210) * _e147);
            let _e231 = (((_e219 * _e103) * _e211) * _e147);
            let _e232 = (((_e220 * _e104) * _e212) * _e147);
            let _e241 = (((_e217 * _e101) * _e213) * _e148);
            let _e242 = (((_e218 * _e102) * _e214) * _e148);
            let _e243 = (((_e219 * _e103) * _e215) * _e148);
            let _e244 = (((_e220 * _e104) * _e216) * _e148);
            let _e412 = (((((((_e177 * _e144) * _e162) * _e169) + (_e137 * (((_e177 * ((_e209 * _e210) + (_e213 * _e214))) + (_e189 * ((_e209 * _e211) + (_e213 * _e215)))) + ((_e217 * _e209) * _e213)))) + ((((_e178 * _e146) * _e163) * _e170) + (_e137 * (((_e178 * ((_e210 * _e211) + (_e214 * _e215))) + (_e190 * ((_e210 * _e212) + (_e214 * _e216)))) + ((_e218 * _e210) * _e214))))) + ((((_e179 * _e140) * _e164) * _e171) + (_e137 * (((_e179 * ((_e211 * _e212) + (_e215 * _e216))) + (_e191 * ((_e211 * _e209) + (_e215 * _e213)))) + ((_e219 * _e211) * _e215))))) + ((((_e180 * _e142) * _e161) * _e172) + (_e137 * (((_e180 * ((_e212 * _e209) + (_e216 * _e213))) + (_e192 * ((_e212 * _e210) + (_e216 * _e214)))) + ((_e220 * _e212) * _e216)))));
            let _e415 = (((_e137 * _e137) * _e147) * _e148);
            let _e418 = (((((((_e201 * _e193) + (_e205 * _e197)) + (_e101 * ((_e229 * _e147) + (_e241 * _e148)))) + (((_e202 * _e194) + (_e206 * _e198)) + (_e102 * ((_e230 * _e147) + (_e242 * _e148))))) + (((_e203 * _e195) + (_e207 * _e199)) + (_e103 * ((_e231 * _e147) + (_e243 * _e148))))) + (((_e204 * _e196) + (_e208 * _e200)) + (_e104 * ((_e232 * _e147) + (_e244 * _e148))))) + ((_e415 * _e147) * _e148));
            if (_e418 < 0.0000000000000000000000000000000001f) {
                if ((bitcast<u32>(_e101) & 2147483647u) > 2139095040u) {
                    phi_1175_ = _e101;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1174_ = 0f;
                    } else {
                        if (_e101 < 0f) {
                            phi_1173_ = 0f;
                        } else {
                            phi_1173_ = 1f;
                        }
                        let _e433 = phi_1173_;
                        phi_1174_ = _e433;
                    }
                    let _e435 = phi_1174_;
                    phi_1175_ = _e435;
                }
                let _e437 = phi_1175_;
                if ((bitcast<u32>(_e102) & 2147483647u) > 2139095040u) {
                    phi_1194_ = _e102;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1193_ = 0f;
                    } else {
                        if (_e102 < 0f) {
                            phi_1192_ = 0f;
                        } else {
                            phi_1192_ = 1f;
                        }
                        let _e446 = phi_1192_;
                        phi_1193_ = _e446;
                    }
                    let _e448 = phi_1193_;
                    phi_1194_ = _e448;
                }
                let _e450 = phi_1194_;
                if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
                    phi_1213_ = _e103;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1212_ = 0f;
                    } else {
                        if (_e103 < 0f) {
                            phi_1211_ = 0f;
                        } else {
                            phi_1211_ = 1f;
                        }
                        let _e459 = phi_1211_;
                        phi_1212_ = _e459;
                    }
                    let _e461 = phi_1212_;
                    phi_1213_ = _e461;
                }
                let _e463 = phi_1213_;
                if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                    phi_1232_ = _e104;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1231_ = 0f;
                    } else {
                        if (_e104 < 0f) {
                            phi_1230_ = 0f;
                        } else {
                            phi_1230_ = 1f;
                        }
                        let _e472 = phi_1230_;
                        phi_1231_ = _e472;
                    }
                    let _e474 = phi_1231_;
                    phi_1232_ = _e474;
                }
                let _e476 = phi_1232_;
                let _e484 = (((((_e437 * _e140) + (_e450 * _e142)) + (_e463 * _e144)) + (_e476 * _e146)) + _e137);
                if ((bitcast<u32>(_e484) & 2147483647u) > 2139095040u) {
                    phi_1257_ = _e484;
                } else {
                    if (_e484 < 0f) {
                        phi_1256_ = 0f;
                    } else {
                        if (_e484 > 1f) {
                            phi_1255_ = 1f;
                        } else {
                            phi_1255_ = _e484;
                        }
                        let _e491 = phi_1255_;
                        phi_1256_ = _e491;
                    }
                    let _e493 = phi_1256_;
                    phi_1257_ = _e493;
                }
                let _e495 = phi_1257_;
                phi_1658_ = _e495;
                phi_1659_ = f32();
                phi_1660_ = true;
            } else {
                let _e500 = ((_e140 * _e64) * _e150);
                let _e501 = ((_e142 * _e76) * _e152);
                let _e502 = ((_e144 * _e88) * _e154);
                let _e503 = ((_e146 * _e100) * _e156);
                let _e510 = ((((_e500 * _e101) + (_e501 * _e102)) + (_e502 * _e103)) + (_e503 * _e104));
                let _e521 = ((((_e500 * (_e101 * _e101)) + (_e501 * (_e102 * _e102))) + (_e502 * (_e103 * _e103))) + (_e503 * (_e104 * _e104)));
                if (_e521 < 0.0000000000000000000000000000000001f) {
                    if ((bitcast<u32>(_e101) & 2147483647u) > 2139095040u) {
                        phi_1306_ = _e101;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_1305_ = 0f;
                        } else {
                            if (_e101 < 0f) {
                                phi_1304_ = 0f;
                            } else {
                                phi_1304_ = 1f;
                            }
                            let _e531 = phi_1304_;
                            phi_1305_ = _e531;
                        }
                        let _e533 = phi_1305_;
                        phi_1306_ = _e533;
                    }
                    let _e535 = phi_1306_;
                    if ((bitcast<u32>(_e102) & 2147483647u) > 2139095040u) {
                        phi_1325_ = _e102;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_1324_ = 0f;
                        } else {
                            if (_e102 < 0f) {
                                phi_1323_ = 0f;
                            } else {
                                phi_1323_ = 1f;
                            }
                            let _e544 = phi_1323_;
                            phi_1324_ = _e544;
                        }
                        let _e546 = phi_1324_;
                        phi_1325_ = _e546;
                    }
                    let _e548 = phi_1325_;
                    if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
                        phi_1344_ = _e103;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_1343_ = 0f;
                        } else {
                            if (_e103 < 0f) {
                                phi_1342_ = 0f;
                            } else {
                                phi_1342_ = 1f;
                            }
                            let _e557 = phi_1342_;
                            phi_1343_ = _e557;
                        }
                        let _e559 = phi_1343_;
                        phi_1344_ = _e559;
                    }
                    let _e561 = phi_1344_;
                    if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                        phi_1363_ = _e104;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_1362_ = 0f;
                        } else {
                            if (_e104 < 0f) {
                                phi_1361_ = 0f;
                            } else {
                                phi_1361_ = 1f;
                            }
                            let _e570 = phi_1361_;
                            phi_1362_ = _e570;
                        }
                        let _e572 = phi_1362_;
                        phi_1363_ = _e572;
                    }
                    let _e574 = phi_1363_;
                    let _e582 = (((((_e535 * _e140) + (_e548 * _e142)) + (_e561 * _e144)) + (_e574 * _e146)) + _e137);
                    if ((bitcast<u32>(_e582) & 2147483647u) > 2139095040u) {
                        phi_1388_ = _e582;
                    } else {
                        if (_e582 < 0f) {
                            phi_1387_ = 0f;
                        } else {
                            if (_e582 > 1f) {
                                phi_1386_ = 1f;
                            } else {
                                phi_1386_ = _e582;
                            }
                            let _e589 = phi_1386_;
                            phi_1387_ = _e589;
                        }
                        let _e591 = phi_1387_;
                        phi_1388_ = _e591;
                    }
                    let _e593 = phi_1388_;
                    phi_1522_ = _e593;
                } else {
                    let _e595 = (_e521 - (_e147 * _e510));
                    let _e597 = ((_e148 * _e510) - _e521);
                    let _e602 = ((_e140 * _e101) * _e150);
                    let _e603 = ((_e142 * _e102) * _e152);
                    let _e604 = ((_e144 * _e103) * _e154);
                    let _e605 = ((_e146 * _e104) * _e156);
                    let _e631 = (_e137 + (((((_e602 * ((_e603 * _e161) + ((0.5f * _e604) * _e169))) + (_e603 * ((_e604 * _e162) + ((0.5f * _e605) * _e170)))) + (_e604 * ((_e605 * _e163) + ((0.5f * _e602) * _e171)))) + (_e605 * ((_e602 * _e164) + ((0.5f * _e603) * _e172)))) / (_e147 * _e595)));
                    let _e636 = ((_e140 * _e101) * _e64);
                    let _e637 = ((_e142 * _e102) * _e76);
                    let _e638 = ((_e144 * _e103) * _e88);
                    let _e639 = ((_e146 * _e104) * _e100);
                    let _e665 = (_e137 + (((((_e636 * ((_e637 * _e161) + ((0.5f * _e638) * _e169))) + (_e637 * ((_e638 * _e162) + ((0.5f * _e639) * _e170)))) + (_e638 * ((_e639 * _e163) + ((0.5f * _e636) * _e171)))) + (_e639 * ((_e636 * _e164) + ((0.5f * _e637) * _e172)))) / (_e148 * _e597)));
                    let _e666 = (_e510 > 0f);
                    if _e666 {
                        phi_1467_ = (_e597 > 0f);
                    } else {
                        phi_1467_ = (_e595 < 0f);
                    }
                    let _e670 = phi_1467_;
                    if _e670 {
                        if (_e631 >= 0f) {
                            if (_e665 >= 0f) {
                                if _e666 {
                                    phi_1511_ = (1f - _e631);
                                } else {
                                    phi_1511_ = ((((((_e500 * ((_e501 * _e161) + ((0.5f * _e502) * _e169))) + (_e501 * ((_e502 * _e162) + ((0.5f * _e503) * _e170)))) + (_e502 * ((_e503 * _e163) + ((0.5f * _e500) * _e171)))) + (_e503 * ((_e500 * _e164) + ((0.5f * _e501) * _e172)))) / (_e521 * (-(_e147) * _e148))) + _e665);
                                }
                                let _e703 = phi_1511_;
                                phi_1512_ = _e703;
                                phi_1513_ = false;
                            } else {
                                phi_1512_ = f32();
                                phi_1513_ = true;
                            }
                            let _e705 = phi_1512_;
                            let _e707 = phi_1513_;
                            phi_1514_ = _e705;
                            phi_1515_ = _e707;
                        } else {
                            phi_1514_ = f32();
                            phi_1515_ = true;
                        }
                        let _e709 = phi_1514_;
                        let _e711 = phi_1515_;
                        phi_1516_ = _e709;
                        phi_1517_ = _e711;
                    } else {
                        phi_1516_ = f32();
                        phi_1517_ = true;
                    }
                    let _e713 = phi_1516_;
                    let _e715 = phi_1517_;
                    if _e715 {
                        phi_1521_ = 1f;
                    } else {
                        phi_1521_ = _e713;
                    }
                    let _e717 = phi_1521_;
                    phi_1522_ = _e717;
                }
                let _e719 = phi_1522_;
                let _e720 = (_e719 < 1f);
                if _e720 {
                    if ((bitcast<u32>(_e719) & 2147483647u) > 2139095040u) {
                        phi_1543_ = _e719;
                    } else {
                        if (_e719 < 0f) {
                            phi_1542_ = 0f;
                        } else {
                            if (_e719 > 1f) {
                                phi_1541_ = 1f;
                            } else {
                                phi_1541_ = _e719;
                            }
                            let _e727 = phi_1541_;
                            phi_1542_ = _e727;
                        }
                        let _e729 = phi_1542_;
                        phi_1543_ = _e729;
                    }
                    let _e731 = phi_1543_;
                    phi_1656_ = _e731;
                    phi_1657_ = f32();
                } else {
                    let _e733 = ((0.5f * -(((((((((_e201 * (_e101 + _e102)) + (_e205 * (_e101 + _e103))) + (_e229 * (_e101 + _e147))) + (_e241 * (_e101 + _e148))) + ((((_e202 * (_e102 + _e103)) + (_e206 * (_e102 + _e104))) + (_e230 * (_e102 + _e147))) + (_e242 * (_e102 + _e148)))) + ((((_e203 * (_e103 + _e104)) + (_e207 * (_e103 + _e101))) + (_e231 * (_e103 + _e147))) + (_e243 * (_e103 + _e148)))) + ((((_e204 * (_e104 + _e101)) + (_e208 * (_e104 + _e102))) + (_e232 * (_e104 + _e147))) + (_e244 * (_e104 + _e148)))) + (_e415 * (_e147 + _e148))))) / _e418);
                    let _e734 = ((((((((_e201 + _e205) + _e229) + _e241) + (((_e202 + _e206) + _e230) + _e242)) + (((_e203 + _e207) + _e231) + _e243)) + (((_e204 + _e208) + _e232) + _e244)) + _e415) / _e418);
                    let _e736 = ((_e733 * _e733) - _e734);
                    if (_e736 > 0f) {
                        phi_1554_ = sqrt(_e736);
                    } else {
                        phi_1554_ = 0f;
                    }
                    let _e740 = phi_1554_;
                    if (_e733 > 0f) {
                        let _e743 = (-(_e733) - _e740);
                        phi_1571_ = lt_bvh_slab_Span(_e743, (_e734 / _e743));
                    } else {
                        let _e746 = (_e740 - _e733);
                        if (_e746 > 0f) {
                            phi_1569_ = (_e734 / _e746);
                        } else {
                            phi_1569_ = 0f;
                        }
                        let _e750 = phi_1569_;
                        phi_1571_ = lt_bvh_slab_Span(_e750, _e746);
                    }
                    let _e753 = phi_1571_;
                    if (_e753.near >= 0f) {
                        phi_1632_ = 1f;
                        phi_1633_ = f32();
                        phi_1634_ = true;
                    } else {
                        let _e757 = (_e753.far <= 0f);
                        if _e757 {
                            phi_1630_ = (_e412 / _e418);
                            phi_1631_ = f32();
                        } else {
                            let _e768 = (((((_e140 * _e101) + (_e142 * _e102)) + (_e144 * _e103)) + (_e146 * _e104)) + (_e137 * (_e147 + _e148)));
                            let _e784 = (((((_e140 * (_e101 * _e101)) + (_e142 * (_e102 * _e102))) + (_e144 * (_e103 * _e103))) + (_e146 * (_e104 * _e104))) + (_e137 * ((_e147 * _e147) + (_e148 * _e148))));
                            if (-(_e753.near) <= _e753.far) {
                                phi_1629_ = (1f - (((_e753.near * _e753.near) * ((_e753.far * _e784) - _e768)) / (_e753.far - _e753.near)));
                            } else {
                                phi_1629_ = ((_e412 / _e418) + (((_e753.far * _e753.far) * (_e768 - (_e753.near * _e784))) / (_e753.far - _e753.near)));
                            }
                            let _e803 = phi_1629_;
                            phi_1630_ = f32();
                            phi_1631_ = _e803;
                        }
                        let _e805 = phi_1630_;
                        let _e807 = phi_1631_;
                        phi_1632_ = _e805;
                        phi_1633_ = _e807;
                        phi_1634_ = _e757;
                    }
                    let _e809 = phi_1632_;
                    let _e811 = phi_1633_;
                    let _e813 = phi_1634_;
                    if _e813 {
                        phi_1638_ = _e809;
                    } else {
                        phi_1638_ = _e811;
                    }
                    let _e815 = phi_1638_;
                    if ((bitcast<u32>(_e815) & 2147483647u) > 2139095040u) {
                        phi_1655_ = _e815;
                    } else {
                        if (_e815 < 0f) {
                            phi_1654_ = 0f;
                        } else {
                            if (_e815 > 1f) {
                                phi_1653_ = 1f;
                            } else {
                                phi_1653_ = _e815;
                            }
                            let _e822 = phi_1653_;
                            phi_1654_ = _e822;
                        }
                        let _e824 = phi_1654_;
                        phi_1655_ = _e824;
                    }
                    let _e826 = phi_1655_;
                    phi_1656_ = f32();
                    phi_1657_ = _e826;
                }
                let _e828 = phi_1656_;
                let _e830 = phi_1657_;
                phi_1658_ = _e828;
                phi_1659_ = _e830;
                phi_1660_ = _e720;
            }
            let _e832 = phi_1658_;
            let _e834 = phi_1659_;
            let _e836 = phi_1660_;
            if _e836 {
            }
            phi_1664_ = _e832;
            phi_1665_ = _e834;
            phi_1666_ = _e836;
        }
        let _e838 = phi_1664_;
        let _e840 = phi_1665_;
        let _e842 = phi_1666_;
        phi_1667_ = _e838;
        phi_1668_ = _e840;
        phi_1669_ = _e842;
    }
    let _e844 = phi_1667_;
    let _e846 = phi_1668_;
    let _e848 = phi_1669_;
    if _e848 {
        phi_1673_ = _e844;
    } else {
        phi_1673_ = _e846;
    }
    let _e850 = phi_1673_;
    return _e850;
}

fn function_() {
    var local: f32;
    var phi_203_: bool;
    var phi_204_: bool;
    var phi_205_: bool;
    var phi_206_: bool;
    var phi_210_: bool;
    var phi_280_: bool;
    var phi_281_: bool;
    var phi_292_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_293_: bool;
    var phi_294_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_295_: bool;
    var phi_302_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_306_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_380_: bool;
    var phi_389_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_401_: bool;
    var phi_402_: bool;
    var phi_403_: bool;
    var phi_404_: bool;
    var phi_408_: bool;
    var phi_498_: f32;
    var phi_501_: f32;
    var phi_530_: f32;
    var phi_535_: f32;
    var phi_536_: bool;
    var phi_537_: f32;
    var phi_538_: bool;
    var phi_542_: f32;
    var phi_562_: f32;
    var phi_567_: f32;
    var phi_568_: bool;
    var phi_569_: f32;
    var phi_570_: bool;
    var phi_574_: f32;
    var phi_622_: i32;
    var phi_627_: i32;
    var phi_632_: i32;
    var phi_637_: i32;
    var phi_646_: i32;
    var phi_651_: i32;
    var phi_656_: i32;
    var phi_661_: i32;
    var phi_706_: evaluate_Verdict;
    var phi_707_: evaluate_Verdict;
    var phi_708_: bool;
    var phi_709_: evaluate_Verdict;
    var phi_710_: evaluate_Verdict;
    var phi_711_: bool;
    var phi_715_: evaluate_Verdict;

    let _e37 = id_1;
    let _e44 = arrayLength((&map.member));
    let _e50 = p.member.size[0u];
    let _e52 = p.member.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e37, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        let _e59 = p.member.projection;
        if (_e53.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e63 = lt_math_OneLevel(_e59);
        let _e67 = samples.member[(0u + _e53.first_primitive)].normal[0u];
        let _e69 = global[0u];
        if (_e67 == _e69) {
            let _e72 = samples.member[(0u + _e53.first_primitive)].normal[1u];
            let _e74 = global[1u];
            if (_e72 == _e74) {
                let _e77 = samples.member[(0u + _e53.first_primitive)].normal[2u];
                let _e79 = global[2u];
                phi_203_ = (_e77 == _e79);
                phi_204_ = false;
            } else {
                phi_203_ = bool();
                phi_204_ = true;
            }
            let _e82 = phi_203_;
            let _e84 = phi_204_;
            phi_205_ = _e82;
            phi_206_ = _e84;
        } else {
            phi_205_ = bool();
            phi_206_ = true;
        }
        let _e86 = phi_205_;
        let _e88 = phi_206_;
        if _e88 {
            phi_210_ = false;
        } else {
            phi_210_ = _e86;
        }
        let _e90 = phi_210_;
        if !(_e90) {
            let _e93 = samples.member[(0u + _e53.first_primitive)].position;
            let _e95 = p.member.light.place;
            let _e101 = p.member.light.place[3u];
            let _e108 = (_e95.x - (_e93.x * _e101));
            let _e109 = (_e95.y - (_e93.y * _e101));
            let _e110 = (_e95.z - (_e93.z * _e101));
            let _e112 = samples.member[(0u + _e53.first_primitive)].normal;
            if ((((_e112.x * _e108) + (_e112.y * _e109)) + (_e112.z * _e110)) > 0f) {
                let _e126 = (((_e108 * _e108) + (_e109 * _e109)) + (_e110 * _e110));
                let _e128 = p.member.light.axis;
                let _e140 = p.member.light.place[3u];
                if (_e140 == 0f) {
                    phi_281_ = true;
                } else {
                    let _e143 = p.member.light.range_squared;
                    if (_e126 <= _e143) {
                        let _e146 = p.member.light.cos_outer;
                        phi_280_ = (-((((_e108 * _e128.x) + (_e109 * _e128.y)) + (_e110 * _e128.z))) >= (_e146 * sqrt(_e126)));
                    } else {
                        phi_280_ = false;
                    }
                    let _e151 = phi_280_;
                    phi_281_ = _e151;
                }
                let _e153 = phi_281_;
                if _e153 {
                    let _e155 = samples.member[(0u + _e53.first_primitive)].flags;
                    let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e163.unnamed.visibility, false), _e163.unnamed_1);
                    phi_292_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e169.unnamed, ((_e155 & 1u) == 0u));
                    phi_293_ = false;
                } else {
                    phi_292_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_293_ = true;
                }
                let _e174 = phi_292_;
                let _e176 = phi_293_;
                phi_294_ = _e174;
                phi_295_ = _e176;
            } else {
                phi_294_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_295_ = true;
            }
            let _e178 = phi_294_;
            let _e180 = phi_295_;
            if _e180 {
                let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e186.unnamed.visibility, false), _e186.unnamed_1);
                phi_302_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e192.unnamed, true);
            } else {
                phi_302_ = _e178;
            }
            let _e197 = phi_302_;
            phi_306_ = _e197;
        } else {
            let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e203.unnamed.visibility, false), _e203.unnamed_1);
            phi_306_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e209.unnamed, true);
        }
        let _e214 = phi_306_;
        if _e214.unnamed_1 {
            phi_709_ = evaluate_Verdict(_e214.unnamed.visibility, _e214.unnamed.is_doubted);
            phi_710_ = evaluate_Verdict();
            phi_711_ = true;
        } else {
            let _e222 = samples.member[(0u + _e53.first_primitive)].position;
            let _e240 = ((((_e63.projection.row_w.x * _e222.x) + (_e63.projection.row_w.y * _e222.y)) + (_e63.projection.row_w.z * _e222.z)) + (_e63.projection.row_w.w * 1f));
            let _e254 = (((((_e63.projection.row_x.x * _e222.x) + (_e63.projection.row_x.y * _e222.y)) + (_e63.projection.row_x.z * _e222.z)) + (_e63.projection.row_x.w * 1f)) / _e240);
            let _e268 = (((((_e63.projection.row_y.x * _e222.x) + (_e63.projection.row_y.y * _e222.y)) + (_e63.projection.row_y.z * _e222.z)) + (_e63.projection.row_y.w * 1f)) / _e240);
            let _e281 = ((((_e63.projection.row_z.x * _e222.x) + (_e63.projection.row_z.y * _e222.y)) + (_e63.projection.row_z.z * _e222.z)) + (_e63.projection.row_z.w * 1f));
            if (_e240 > 0f) {
                if (_e254 >= 0f) {
                    phi_380_ = (_e254 <= 1f);
                } else {
                    phi_380_ = false;
                }
                let _e286 = phi_380_;
                if _e286 {
                    if (_e268 >= 0f) {
                        phi_389_ = (_e268 <= 1f);
                    } else {
                        phi_389_ = false;
                    }
                    let _e290 = phi_389_;
                    if _e290 {
                        if (_e281 >= 0f) {
                            phi_398_ = (_e281 <= 1f);
                        } else {
                            phi_398_ = false;
                        }
                        let _e294 = phi_398_;
                        phi_399_ = _e294;
                        phi_400_ = false;
                    } else {
                        phi_399_ = bool();
                        phi_400_ = true;
                    }
                    let _e296 = phi_399_;
                    let _e298 = phi_400_;
                    phi_401_ = _e296;
                    phi_402_ = _e298;
                } else {
                    phi_401_ = bool();
                    phi_402_ = true;
                }
                let _e300 = phi_401_;
                let _e302 = phi_402_;
                phi_403_ = _e300;
                phi_404_ = _e302;
            } else {
                phi_403_ = bool();
                phi_404_ = true;
            }
            let _e304 = phi_403_;
            let _e306 = phi_404_;
            if _e306 {
                phi_408_ = false;
            } else {
                phi_408_ = _e304;
            }
            let _e308 = phi_408_;
            if _e308 {
                if (0f > 0f) {
                    let _e311 = samples.member[(0u + _e53.first_primitive)].normal;
                    let _e313 = p.member.map_size;
                    let _e383 = ((abs(((((_e59.row_x.x * _e311.x) + (_e59.row_x.y * _e311.y)) + (_e59.row_x.z * _e311.z)) / (((_e59.row_x.x * _e59.row_x.x) + (_e59.row_x.y * _e59.row_x.y)) + (_e59.row_x.z * _e59.row_x.z)))) + abs(((((_e59.row_y.x * _e311.x) + (_e59.row_y.y * _e311.y)) + (_e59.row_y.z * _e311.z)) / (((_e59.row_y.x * _e59.row_y.x) + (_e59.row_y.y * _e59.row_y.y)) + (_e59.row_y.z * _e59.row_y.z))))) / (abs(((((_e59.row_z.x * _e311.x) + (_e59.row_z.y * _e311.y)) + (_e59.row_z.z * _e311.z)) / (((_e59.row_z.x * _e59.row_z.x) + (_e59.row_z.y * _e59.row_z.y)) + (_e59.row_z.z * _e59.row_z.z)))) * f32(_e313)));
                    if (_e383 < 0.002f) {
                        phi_498_ = _e383;
                    } else {
                        phi_498_ = 0.002f;
                    }
                    let _e386 = phi_498_;
                    phi_501_ = (_e281 - (0f * _e386));
                } else {
                    phi_501_ = _e281;
                }
                let _e390 = phi_501_;
                let _e392 = p.member.map_size;
                let _e393 = f32(_e392);
                let _e396 = ((_e254 * _e393) - 0.5f);
                let _e397 = ((_e268 * _e393) - 0.5f);
                if (_e396 > -8388608f) {
                    let _e409 = f32(select(0i, select(select(i32(_e396), i32(-2147483648), (_e396 < bitcast<f32>(3472883712u))), 2147483647i, (_e396 > bitcast<f32>(1325400063u))), (_e396 == _e396)));
                    if (_e409 > _e396) {
                        phi_530_ = 1f;
                    } else {
                        phi_530_ = 0f;
                    }
                    let _e412 = phi_530_;
                    if (_e396 < 8388608f) {
                        phi_535_ = (_e409 - _e412);
                        phi_536_ = false;
                    } else {
                        phi_535_ = f32();
                        phi_536_ = true;
                    }
                    let _e415 = phi_535_;
                    let _e417 = phi_536_;
                    phi_537_ = _e415;
                    phi_538_ = _e417;
                } else {
                    phi_537_ = f32();
                    phi_538_ = true;
                }
                let _e419 = phi_537_;
                let _e421 = phi_538_;
                if _e421 {
                    phi_542_ = _e396;
                } else {
                    phi_542_ = _e419;
                }
                let _e423 = phi_542_;
                if (_e397 > -8388608f) {
                    let _e435 = f32(select(0i, select(select(i32(_e397), i32(-2147483648), (_e397 < bitcast<f32>(3472883712u))), 2147483647i, (_e397 > bitcast<f32>(1325400063u))), (_e397 == _e397)));
                    if (_e435 > _e397) {
                        phi_562_ = 1f;
                    } else {
                        phi_562_ = 0f;
                    }
                    let _e438 = phi_562_;
                    if (_e397 < 8388608f) {
                        phi_567_ = (_e435 - _e438);
                        phi_568_ = false;
                    } else {
                        phi_567_ = f32();
                        phi_568_ = true;
                    }
                    let _e441 = phi_567_;
                    let _e443 = phi_568_;
                    phi_569_ = _e441;
                    phi_570_ = _e443;
                } else {
                    phi_569_ = f32();
                    phi_570_ = true;
                }
                let _e445 = phi_569_;
                let _e447 = phi_570_;
                if _e447 {
                    phi_574_ = _e397;
                } else {
                    phi_574_ = _e445;
                }
                let _e449 = phi_574_;
                let _e450 = (_e396 - _e423);
                let _e451 = (_e397 - _e449);
                let _e460 = select(0i, select(select(i32(_e423), i32(-2147483648), (_e423 < bitcast<f32>(3472883712u))), 2147483647i, (_e423 > bitcast<f32>(1325400063u))), (_e423 == _e423));
                let _e469 = select(0i, select(select(i32(_e449), i32(-2147483648), (_e449 < bitcast<f32>(3472883712u))), 2147483647i, (_e449 > bitcast<f32>(1325400063u))), (_e449 == _e449));
                let _e480 = p.member.test;
                let _e481 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e480);
                let _e483 = p.member.map_size;
                local = _e481;
                let _e485 = ((0u * _e483) * _e483);
                let _e487 = (bitcast<i32>(_e483) - 1i);
                if (_e460 > 0i) {
                    phi_622_ = _e460;
                } else {
                    phi_622_ = 0i;
                }
                let _e490 = phi_622_;
                if (_e469 > 0i) {
                    phi_627_ = _e469;
                } else {
                    phi_627_ = 0i;
                }
                let _e493 = phi_627_;
                if (_e490 < _e487) {
                    phi_632_ = _e490;
                } else {
                    phi_632_ = _e487;
                }
                let _e496 = phi_632_;
                if (_e493 < _e487) {
                    phi_637_ = _e493;
                } else {
                    phi_637_ = _e487;
                }
                let _e499 = phi_637_;
                let _e500 = bitcast<u32>(_e496);
                let _e502 = (_e460 + 1i);
                let _e503 = (_e469 + 1i);
                if (_e502 > 0i) {
                    phi_646_ = _e502;
                } else {
                    phi_646_ = 0i;
                }
                let _e506 = phi_646_;
                if (_e503 > 0i) {
                    phi_651_ = _e503;
                } else {
                    phi_651_ = 0i;
                }
                let _e509 = phi_651_;
                if (_e506 < _e487) {
                    phi_656_ = _e506;
                } else {
                    phi_656_ = _e487;
                }
                let _e512 = phi_656_;
                if (_e509 < _e487) {
                    phi_661_ = _e509;
                } else {
                    phi_661_ = _e487;
                }
                let _e515 = phi_661_;
                let _e516 = bitcast<u32>(_e512);
                let _e518 = (bitcast<u32>(_e499) * _e483);
                let _e519 = (bitcast<u32>(_e515) * _e483);
                let _e524 = ((_e518 + _e500) + _e485);
                let _e525 = ((_e518 + _e516) + _e485);
                let _e526 = ((_e519 + _e500) + _e485);
                let _e527 = ((_e519 + _e516) + _e485);
                if (_e524 < _e44) {
                } else {
                    return;
                }
                let _e531 = map.member[(0u + _e524)];
                if (_e525 < _e44) {
                } else {
                    return;
                }
                let _e535 = map.member[(0u + _e525)];
                if (_e526 < _e44) {
                } else {
                    return;
                }
                let _e539 = map.member[(0u + _e526)];
                if (_e527 < _e44) {
                } else {
                    return;
                }
                let _e543 = map.member[(0u + _e527)];
                let _e545 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e531, _e535, _e539, _e543), vec4<f32>(((1f - _e450) * (1f - _e451)), (_e450 * (1f - _e451)), ((1f - _e450) * _e451), (_e450 * _e451)), _e390);
                phi_706_ = evaluate_Verdict(_e545, false);
                phi_707_ = evaluate_Verdict();
                phi_708_ = false;
            } else {
                phi_706_ = evaluate_Verdict();
                phi_707_ = evaluate_Verdict(1f, false);
                phi_708_ = true;
            }
            let _e549 = phi_706_;
            let _e551 = phi_707_;
            let _e553 = phi_708_;
            phi_709_ = _e551;
            phi_710_ = _e549;
            phi_711_ = _e553;
        }
        let _e555 = phi_709_;
        let _e557 = phi_710_;
        let _e559 = phi_711_;
        if _e559 {
            phi_715_ = _e555;
        } else {
            phi_715_ = _e557;
        }
        let _e561 = phi_715_;
        if (_e53.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e53.first_primitive)] = _e561.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
