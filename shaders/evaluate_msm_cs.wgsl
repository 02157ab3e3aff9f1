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
    var phi_128_: lt_bvh_traverse_Tree;
    var phi_129_: bool;
    var phi_130_: lt_bvh_traverse_Tree;
    var phi_131_: bool;
    var phi_136_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_128_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_129_ = false;
        } else {
            phi_128_ = lt_bvh_traverse_Tree();
            phi_129_ = true;
        }
        let _e49 = phi_128_;
        let _e51 = phi_129_;
        phi_130_ = _e49;
        phi_131_ = _e51;
    } else {
        phi_130_ = lt_bvh_traverse_Tree();
        phi_131_ = true;
    }
    let _e53 = phi_130_;
    let _e55 = phi_131_;
    if _e55 {
        phi_136_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_136_ = _e53;
    }
    let _e60 = phi_136_;
    return lt_bvh_traverse_Tree(_e60.root, _e60.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_689_: f32;
    var phi_690_: f32;
    var phi_691_: f32;
    var phi_708_: f32;
    var phi_709_: f32;
    var phi_710_: f32;
    var phi_726_: f32;
    var phi_727_: f32;
    var phi_728_: f32;
    var phi_744_: f32;
    var phi_745_: f32;
    var phi_746_: f32;
    var phi_762_: f32;
    var phi_763_: f32;
    var phi_764_: f32;
    var phi_799_: bool;
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_802_: bool;
    var phi_803_: bool;
    var phi_804_: bool;
    var phi_808_: bool;
    var phi_1119_: f32;
    var phi_1120_: f32;
    var phi_1121_: f32;
    var phi_1138_: f32;
    var phi_1139_: f32;
    var phi_1140_: f32;
    var phi_1157_: f32;
    var phi_1158_: f32;
    var phi_1159_: f32;
    var phi_1176_: f32;
    var phi_1177_: f32;
    var phi_1178_: f32;
    var phi_1201_: f32;
    var phi_1202_: f32;
    var phi_1203_: f32;
    var phi_1214_: f32;
    var phi_1229_: f32;
    var phi_1231_: lt_bvh_slab_Span;
    var phi_1289_: f32;
    var phi_1290_: f32;
    var phi_1291_: f32;
    var phi_1292_: f32;
    var phi_1293_: f32;
    var phi_1294_: bool;
    var phi_1298_: f32;
    var phi_1313_: f32;
    var phi_1314_: f32;
    var phi_1315_: f32;
    var phi_1316_: f32;
    var phi_1317_: f32;
    var phi_1318_: f32;
    var phi_1319_: f32;
    var phi_1320_: bool;
    var phi_1321_: f32;
    var phi_1322_: f32;
    var phi_1323_: bool;
    var phi_1327_: f32;

    let _e40 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_691_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_690_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_689_ = 1f;
            } else {
                phi_689_ = param_7;
            }
            let _e47 = phi_689_;
            phi_690_ = _e47;
        }
        let _e49 = phi_690_;
        phi_691_ = _e49;
    }
    let _e51 = phi_691_;
    let _e52 = (_e51 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_710_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_709_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_708_ = 1f;
            } else {
                phi_708_ = param_5.x;
            }
            let _e60 = phi_708_;
            phi_709_ = _e60;
        }
        let _e62 = phi_709_;
        phi_710_ = _e62;
    }
    let _e64 = phi_710_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_728_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_727_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_726_ = 1f;
            } else {
                phi_726_ = param_5.y;
            }
            let _e72 = phi_726_;
            phi_727_ = _e72;
        }
        let _e74 = phi_727_;
        phi_728_ = _e74;
    }
    let _e76 = phi_728_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_746_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_745_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_744_ = 1f;
            } else {
                phi_744_ = param_5.z;
            }
            let _e84 = phi_744_;
            phi_745_ = _e84;
        }
        let _e86 = phi_745_;
        phi_746_ = _e86;
    }
    let _e88 = phi_746_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_764_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_763_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_762_ = 1f;
            } else {
                phi_762_ = param_5.w;
            }
            let _e96 = phi_762_;
            phi_763_ = _e96;
        }
        let _e98 = phi_763_;
        phi_764_ = _e98;
    }
    let _e100 = phi_764_;
    let _e101 = (_e64 - _e52);
    let _e102 = (_e76 - _e52);
    let _e103 = (_e88 - _e52);
    let _e104 = (_e100 - _e52);
    let _e115 = ((((_e101 * param_6.x) + (_e102 * param_6.y)) + (_e103 * param_6.z)) + (_e104 * param_6.w));
    if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
        phi_1321_ = _e115;
        phi_1322_ = f32();
        phi_1323_ = true;
    } else {
        if (_e101 >= 0f) {
            if (_e102 >= 0f) {
                if (_e103 >= 0f) {
                    phi_799_ = (_e104 >= 0f);
                    phi_800_ = false;
                } else {
                    phi_799_ = bool();
                    phi_800_ = true;
                }
                let _e124 = phi_799_;
                let _e126 = phi_800_;
                phi_801_ = _e124;
                phi_802_ = _e126;
            } else {
                phi_801_ = bool();
                phi_802_ = true;
            }
            let _e128 = phi_801_;
            let _e130 = phi_802_;
            phi_803_ = _e128;
            phi_804_ = _e130;
        } else {
            phi_803_ = bool();
            phi_804_ = true;
        }
        let _e132 = phi_803_;
        let _e134 = phi_804_;
        if _e134 {
            phi_808_ = false;
        } else {
            phi_808_ = _e132;
        }
        let _e136 = phi_808_;
        if _e136 {
            phi_1318_ = 1f;
            phi_1319_ = f32();
            phi_1320_ = true;
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
            let _e424 = (_e418 < 0.0000000000000000000000000000000001f);
            if _e424 {
                if ((bitcast<u32>(_e101) & 2147483647u) > 2139095040u) {
                    phi_1121_ = _e101;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1120_ = 0f;
                    } else {
                        if (_e101 < 0f) {
                            phi_1119_ = 0f;
                        } else {
                            phi_1119_ = 1f;
                        }
                        let _e433 = phi_1119_;
                        phi_1120_ = _e433;
                    }
                    let _e435 = phi_1120_;
                    phi_1121_ = _e435;
                }
                let _e437 = phi_1121_;
                if ((bitcast<u32>(_e102) & 2147483647u) > 2139095040u) {
                    phi_1140_ = _e102;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1139_ = 0f;
                    } else {
                        if (_e102 < 0f) {
                            phi_1138_ = 0f;
                        } else {
                            phi_1138_ = 1f;
                        }
                        let _e446 = phi_1138_;
                        phi_1139_ = _e446;
                    }
                    let _e448 = phi_1139_;
                    phi_1140_ = _e448;
                }
                let _e450 = phi_1140_;
                if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
                    phi_1159_ = _e103;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1158_ = 0f;
                    } else {
                        if (_e103 < 0f) {
                            phi_1157_ = 0f;
                        } else {
                            phi_1157_ = 1f;
                        }
                        let _e459 = phi_1157_;
                        phi_1158_ = _e459;
                    }
                    let _e461 = phi_1158_;
                    phi_1159_ = _e461;
                }
                let _e463 = phi_1159_;
                if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                    phi_1178_ = _e104;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1177_ = 0f;
                    } else {
                        if (_e104 < 0f) {
                            phi_1176_ = 0f;
                        } else {
                            phi_1176_ = 1f;
                        }
                        let _e472 = phi_1176_;
                        phi_1177_ = _e472;
                    }
                    let _e474 = phi_1177_;
                    phi_1178_ = _e474;
                }
                let _e476 = phi_1178_;
                let _e484 = (((((_e437 * _e140) + (_e450 * _e142)) + (_e463 * _e144)) + (_e476 * _e146)) + _e137);
                if ((bitcast<u32>(_e484) & 2147483647u) > 2139095040u) {
                    phi_1203_ = _e484;
                } else {
                    if (_e484 < 0f) {
                        phi_1202_ = 0f;
                    } else {
                        if (_e484 > 1f) {
                            phi_1201_ = 1f;
                        } else {
                            phi_1201_ = _e484;
                        }
                        let _e491 = phi_1201_;
                        phi_1202_ = _e491;
                    }
                    let _e493 = phi_1202_;
                    phi_1203_ = _e493;
                }
                let _e495 = phi_1203_;
                phi_1316_ = _e495;
                phi_1317_ = f32();
            } else {
                let _e497 = ((0.5f * -(((((((((_e201 * (_e101 + _e102)) + (_e205 * (_e101 + _e103))) + (_e229 * (_e101 + _e147))) + (_e241 * (_e101 + _e148))) + ((((_e202 * (_e102 + _e103)) + (_e206 * (_e102 + _e104))) + (_e230 * (_e102 + _e147))) + (_e242 * (_e102 + _e148)))) + ((((_e203 * (_e103 + _e104)) + (_e207 * (_e103 + _e101))) + (_e231 * (_e103 + _e147))) + (_e243 * (_e103 + _e148)))) + ((((_e204 * (_e104 + _e101)) + (_e208 * (_e104 + _e102))) + (_e232 * (_e104 + _e147))) + (_e244 * (_e104 + _e148)))) + (_e415 * (_e147 + _e148))))) / _e418);
                let _e498 = ((((((((_e201 + _e205) + _e229) + _e241) + (((_e202 + _e206) + _e230) + _e242)) + (((_e203 + _e207) + _e231) + _e243)) + (((_e204 + _e208) + _e232) + _e244)) + _e415) / _e418);
                let _e500 = ((_e497 * _e497) - _e498);
                if (_e500 > 0f) {
                    phi_1214_ = sqrt(_e500);
                } else {
                    phi_1214_ = 0f;
                }
                let _e504 = phi_1214_;
                if (_e497 > 0f) {
                    let _e507 = (-(_e497) - _e504);
                    phi_1231_ = lt_bvh_slab_Span(_e507, (_e498 / _e507));
                } else {
                    let _e510 = (_e504 - _e497);
                    if (_e510 > 0f) {
                        phi_1229_ = (_e498 / _e510);
                    } else {
                        phi_1229_ = 0f;
                    }
                    let _e514 = phi_1229_;
                    phi_1231_ = lt_bvh_slab_Span(_e514, _e510);
                }
                let _e517 = phi_1231_;
                if (_e517.near >= 0f) {
                    phi_1292_ = 1f;
                    phi_1293_ = f32();
                    phi_1294_ = true;
                } else {
                    let _e521 = (_e517.far <= 0f);
                    if _e521 {
                        phi_1290_ = (_e412 / _e418);
                        phi_1291_ = f32();
                    } else {
                        let _e532 = (((((_e140 * _e101) + (_e142 * _e102)) + (_e144 * _e103)) + (_e146 * _e104)) + (_e137 * (_e147 + _e148)));
                        let _e548 = (((((_e140 * (_e101 * _e101)) + (_e142 * (_e102 * _e102))) + (_e144 * (_e103 * _e103))) + (_e146 * (_e104 * _e104))) + (_e137 * ((_e147 * _e147) + (_e148 * _e148))));
                        if (-(_e517.near) <= _e517.far) {
                            phi_1289_ = (1f - (((_e517.near * _e517.near) * ((_e517.far * _e548) - _e532)) / (_e517.far - _e517.near)));
                        } else {
                            phi_1289_ = ((_e412 / _e418) + (((_e517.far * _e517.far) * (_e532 - (_e517.near * _e548))) / (_e517.far - _e517.near)));
                        }
                        let _e567 = phi_1289_;
                        phi_1290_ = f32();
                        phi_1291_ = _e567;
                    }
                    let _e569 = phi_1290_;
                    let _e571 = phi_1291_;
                    phi_1292_ = _e569;
                    phi_1293_ = _e571;
                    phi_1294_ = _e521;
                }
                let _e573 = phi_1292_;
                let _e575 = phi_1293_;
                let _e577 = phi_1294_;
                if _e577 {
                    phi_1298_ = _e573;
                } else {
                    phi_1298_ = _e575;
                }
                let _e579 = phi_1298_;
                if ((bitcast<u32>(_e579) & 2147483647u) > 2139095040u) {
                    phi_1315_ = _e579;
                } else {
                    if (_e579 < 0f) {
                        phi_1314_ = 0f;
                    } else {
                        if (_e579 > 1f) {
                            phi_1313_ = 1f;
                        } else {
                            phi_1313_ = _e579;
                        }
                        let _e586 = phi_1313_;
                        phi_1314_ = _e586;
                    }
                    let _e588 = phi_1314_;
                    phi_1315_ = _e588;
                }
                let _e590 = phi_1315_;
                phi_1316_ = f32();
                phi_1317_ = _e590;
            }
            let _e592 = phi_1316_;
            let _e594 = phi_1317_;
            phi_1318_ = _e592;
            phi_1319_ = _e594;
            phi_1320_ = _e424;
        }
        let _e596 = phi_1318_;
        let _e598 = phi_1319_;
        let _e600 = phi_1320_;
        phi_1321_ = _e596;
        phi_1322_ = _e598;
        phi_1323_ = _e600;
    }
    let _e602 = phi_1321_;
    let _e604 = phi_1322_;
    let _e606 = phi_1323_;
    if _e606 {
        phi_1327_ = _e602;
    } else {
        phi_1327_ = _e604;
    }
    let _e608 = phi_1327_;
    return _e608;
}

fn function_() {
    var local: f32;
    var phi_196_: bool;
    var phi_197_: bool;
    var phi_198_: bool;
    var phi_199_: bool;
    var phi_203_: bool;
    var phi_247_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_251_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_328_: bool;
    var phi_337_: bool;
    var phi_346_: bool;
    var phi_347_: bool;
    var phi_348_: bool;
    var phi_349_: bool;
    var phi_350_: bool;
    var phi_351_: bool;
    var phi_352_: bool;
    var phi_356_: bool;
    var phi_450_: f32;
    var phi_453_: f32;
    var phi_482_: f32;
    var phi_487_: f32;
    var phi_488_: bool;
    var phi_489_: f32;
    var phi_490_: bool;
    var phi_494_: f32;
    var phi_514_: f32;
    var phi_519_: f32;
    var phi_520_: bool;
    var phi_521_: f32;
    var phi_522_: bool;
    var phi_526_: f32;
    var phi_572_: i32;
    var phi_577_: i32;
    var phi_582_: i32;
    var phi_587_: i32;
    var phi_596_: i32;
    var phi_601_: i32;
    var phi_606_: i32;
    var phi_611_: i32;
    var phi_652_: evaluate_Verdict;
    var phi_653_: evaluate_Verdict;
    var phi_654_: bool;
    var phi_655_: evaluate_Verdict;
    var phi_656_: evaluate_Verdict;
    var phi_657_: bool;
    var phi_661_: evaluate_Verdict;

    let _e37 = id_1;
    let _e44 = arrayLength((&map.member));
    let _e50 = p.member.size[0u];
    let _e52 = p.member.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e37, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        if (_e53.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e62 = p.member.light;
        let _e65 = samples.member[(0u + _e53.first_primitive)].normal[0u];
        let _e67 = global[0u];
        if (_e65 == _e67) {
            let _e70 = samples.member[(0u + _e53.first_primitive)].normal[1u];
            let _e72 = global[1u];
            if (_e70 == _e72) {
                let _e75 = samples.member[(0u + _e53.first_primitive)].normal[2u];
                let _e77 = global[2u];
                phi_196_ = (_e75 == _e77);
                phi_197_ = false;
            } else {
                phi_196_ = bool();
                phi_197_ = true;
            }
            let _e80 = phi_196_;
            let _e82 = phi_197_;
            phi_198_ = _e80;
            phi_199_ = _e82;
        } else {
            phi_198_ = bool();
            phi_199_ = true;
        }
        let _e84 = phi_198_;
        let _e86 = phi_199_;
        if _e86 {
            phi_203_ = false;
        } else {
            phi_203_ = _e84;
        }
        let _e88 = phi_203_;
        if !(_e88) {
            let _e91 = samples.member[(0u + _e53.first_primitive)].normal;
            let _e93 = samples.member[(0u + _e53.first_primitive)].position;
            if ((((_e91.x * (_e62.x - (_e93.x * _e62.w))) + (_e91.y * (_e62.y - (_e93.y * _e62.w)))) + (_e91.z * (_e62.z - (_e93.z * _e62.w)))) > 0f) {
                let _e117 = samples.member[(0u + _e53.first_primitive)].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_247_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_247_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_247_;
            phi_251_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_251_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_251_;
        if _e168.unnamed_1 {
            phi_655_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
            phi_656_ = evaluate_Verdict();
            phi_657_ = true;
        } else {
            let _e176 = samples.member[(0u + _e53.first_primitive)].position;
            let _e182 = p.member.projection.row_w;
            let _e193 = ((((_e182.x * _e176.x) + (_e182.y * _e176.y)) + (_e182.z * _e176.z)) + (_e182.w * 1f));
            let _e195 = p.member.projection.row_x;
            let _e207 = (((((_e195.x * _e176.x) + (_e195.y * _e176.y)) + (_e195.z * _e176.z)) + (_e195.w * 1f)) / _e193);
            let _e209 = p.member.projection.row_y;
            let _e221 = (((((_e209.x * _e176.x) + (_e209.y * _e176.y)) + (_e209.z * _e176.z)) + (_e209.w * 1f)) / _e193);
            let _e223 = p.member.projection.row_z;
            let _e234 = ((((_e223.x * _e176.x) + (_e223.y * _e176.y)) + (_e223.z * _e176.z)) + (_e223.w * 1f));
            if (_e193 > 0f) {
                if (_e207 >= 0f) {
                    phi_328_ = (_e207 <= 1f);
                } else {
                    phi_328_ = false;
                }
                let _e239 = phi_328_;
                if _e239 {
                    if (_e221 >= 0f) {
                        phi_337_ = (_e221 <= 1f);
                    } else {
                        phi_337_ = false;
                    }
                    let _e243 = phi_337_;
                    if _e243 {
                        if (_e234 >= 0f) {
                            phi_346_ = (_e234 <= 1f);
                        } else {
                            phi_346_ = false;
                        }
                        let _e247 = phi_346_;
                        phi_347_ = _e247;
                        phi_348_ = false;
                    } else {
                        phi_347_ = bool();
                        phi_348_ = true;
                    }
                    let _e249 = phi_347_;
                    let _e251 = phi_348_;
                    phi_349_ = _e249;
                    phi_350_ = _e251;
                } else {
                    phi_349_ = bool();
                    phi_350_ = true;
                }
                let _e253 = phi_349_;
                let _e255 = phi_350_;
                phi_351_ = _e253;
                phi_352_ = _e255;
            } else {
                phi_351_ = bool();
                phi_352_ = true;
            }
            let _e257 = phi_351_;
            let _e259 = phi_352_;
            if _e259 {
                phi_356_ = false;
            } else {
                phi_356_ = _e257;
            }
            let _e261 = phi_356_;
            if _e261 {
                if (0f > 0f) {
                    let _e264 = samples.member[(0u + _e53.first_primitive)].normal;
                    let _e266 = p.member.map_size;
                    let _e269 = p.member.projection.row_x;
                    let _e291 = p.member.projection.row_y;
                    let _e313 = p.member.projection.row_z;
                    let _e340 = ((abs(((((_e269.x * _e264.x) + (_e269.y * _e264.y)) + (_e269.z * _e264.z)) / (((_e269.x * _e269.x) + (_e269.y * _e269.y)) + (_e269.z * _e269.z)))) + abs(((((_e291.x * _e264.x) + (_e291.y * _e264.y)) + (_e291.z * _e264.z)) / (((_e291.x * _e291.x) + (_e291.y * _e291.y)) + (_e291.z * _e291.z))))) / (abs(((((_e313.x * _e264.x) + (_e313.y * _e264.y)) + (_e313.z * _e264.z)) / (((_e313.x * _e313.x) + (_e313.y * _e313.y)) + (_e313.z * _e313.z)))) * f32(_e266)));
                    if (_e340 < 0.002f) {
                        phi_450_ = _e340;
                    } else {
                        phi_450_ = 0.002f;
                    }
                    let _e343 = phi_450_;
                    phi_453_ = (_e234 - (0f * _e343));
                } else {
                    phi_453_ = _e234;
                }
                let _e347 = phi_453_;
                let _e349 = p.member.map_size;
                let _e350 = f32(_e349);
                let _e353 = ((_e207 * _e350) - 0.5f);
                let _e354 = ((_e221 * _e350) - 0.5f);
                if (_e353 > -8388608f) {
                    let _e366 = f32(select(0i, select(select(i32(_e353), i32(-2147483648), (_e353 < bitcast<f32>(3472883712u))), 2147483647i, (_e353 > bitcast<f32>(1325400063u))), (_e353 == _e353)));
                    if (_e366 > _e353) {
                        phi_482_ = 1f;
                    } else {
                        phi_482_ = 0f;
                    }
                    let _e369 = phi_482_;
                    if (_e353 < 8388608f) {
                        phi_487_ = (_e366 - _e369);
                        phi_488_ = false;
                    } else {
                        phi_487_ = f32();
                        phi_488_ = true;
                    }
                    let _e372 = phi_487_;
                    let _e374 = phi_488_;
                    phi_489_ = _e372;
                    phi_490_ = _e374;
                } else {
                    phi_489_ = f32();
                    phi_490_ = true;
                }
                let _e376 = phi_489_;
                let _e378 = phi_490_;
                if _e378 {
                    phi_494_ = _e353;
                } else {
                    phi_494_ = _e376;
                }
                let _e380 = phi_494_;
                if (_e354 > -8388608f) {
                    let _e392 = f32(select(0i, select(select(i32(_e354), i32(-2147483648), (_e354 < bitcast<f32>(3472883712u))), 2147483647i, (_e354 > bitcast<f32>(1325400063u))), (_e354 == _e354)));
                    if (_e392 > _e354) {
                        phi_514_ = 1f;
                    } else {
                        phi_514_ = 0f;
                    }
                    let _e395 = phi_514_;
                    if (_e354 < 8388608f) {
                        phi_519_ = (_e392 - _e395);
                        phi_520_ = false;
                    } else {
                        phi_519_ = f32();
                        phi_520_ = true;
                    }
                    let _e398 = phi_519_;
                    let _e400 = phi_520_;
                    phi_521_ = _e398;
                    phi_522_ = _e400;
                } else {
                    phi_521_ = f32();
                    phi_522_ = true;
                }
                let _e402 = phi_521_;
                let _e404 = phi_522_;
                if _e404 {
                    phi_526_ = _e354;
                } else {
                    phi_526_ = _e402;
                }
                let _e406 = phi_526_;
                let _e407 = (_e353 - _e380);
                let _e408 = (_e354 - _e406);
                let _e417 = select(0i, select(select(i32(_e380), i32(-2147483648), (_e380 < bitcast<f32>(3472883712u))), 2147483647i, (_e380 > bitcast<f32>(1325400063u))), (_e380 == _e380));
                let _e426 = select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406));
                let _e437 = p.member.test;
                let _e438 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e437);
                let _e440 = p.member.map_size;
                local = _e438;
                let _e442 = (bitcast<i32>(_e440) - 1i);
                if (_e417 > 0i) {
                    phi_572_ = _e417;
                } else {
                    phi_572_ = 0i;
                }
                let _e445 = phi_572_;
                if (_e426 > 0i) {
                    phi_577_ = _e426;
                } else {
                    phi_577_ = 0i;
                }
                let _e448 = phi_577_;
                if (_e445 < _e442) {
                    phi_582_ = _e445;
                } else {
                    phi_582_ = _e442;
                }
                let _e451 = phi_582_;
                if (_e448 < _e442) {
                    phi_587_ = _e448;
                } else {
                    phi_587_ = _e442;
                }
                let _e454 = phi_587_;
                let _e455 = bitcast<u32>(_e451);
                let _e457 = (_e417 + 1i);
                let _e458 = (_e426 + 1i);
                if (_e457 > 0i) {
                    phi_596_ = _e457;
                } else {
                    phi_596_ = 0i;
                }
                let _e461 = phi_596_;
                if (_e458 > 0i) {
                    phi_601_ = _e458;
                } else {
                    phi_601_ = 0i;
                }
                let _e464 = phi_601_;
                if (_e461 < _e442) {
                    phi_606_ = _e461;
                } else {
                    phi_606_ = _e442;
                }
                let _e467 = phi_606_;
                if (_e464 < _e442) {
                    phi_611_ = _e464;
                } else {
                    phi_611_ = _e442;
                }
                let _e470 = phi_611_;
                let _e471 = bitcast<u32>(_e467);
                let _e473 = (bitcast<u32>(_e454) * _e440);
                let _e474 = (bitcast<u32>(_e470) * _e440);
                let _e475 = (_e473 + _e455);
                let _e476 = (_e473 + _e471);
                let _e477 = (_e474 + _e455);
                let _e478 = (_e474 + _e471);
                if (_e475 < _e44) {
                } else {
                    return;
                }
                let _e482 = map.member[(0u + _e475)];
                if (_e476 < _e44) {
                } else {
                    return;
                }
                let _e486 = map.member[(0u + _e476)];
                if (_e477 < _e44) {
                } else {
                    return;
                }
                let _e490 = map.member[(0u + _e477)];
                if (_e478 < _e44) {
                } else {
                    return;
                }
                let _e494 = map.member[(0u + _e478)];
                let _e496 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e482, _e486, _e490, _e494), vec4<f32>(((1f - _e407) * (1f - _e408)), (_e407 * (1f - _e408)), ((1f - _e407) * _e408), (_e407 * _e408)), _e347);
                phi_652_ = evaluate_Verdict(_e496, false);
                phi_653_ = evaluate_Verdict();
                phi_654_ = false;
            } else {
                phi_652_ = evaluate_Verdict();
                phi_653_ = evaluate_Verdict(1f, false);
                phi_654_ = true;
            }
            let _e500 = phi_652_;
            let _e502 = phi_653_;
            let _e504 = phi_654_;
            phi_655_ = _e502;
            phi_656_ = _e500;
            phi_657_ = _e504;
        }
        let _e506 = phi_655_;
        let _e508 = phi_656_;
        let _e510 = phi_657_;
        if _e510 {
            phi_661_ = _e506;
        } else {
            phi_661_ = _e508;
        }
        let _e512 = phi_661_;
        if (_e53.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e53.first_primitive)] = _e512.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
