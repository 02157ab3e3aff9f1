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
    var phi_135_: lt_bvh_traverse_Tree;
    var phi_136_: bool;
    var phi_137_: lt_bvh_traverse_Tree;
    var phi_138_: bool;
    var phi_143_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_135_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_136_ = false;
        } else {
            phi_135_ = lt_bvh_traverse_Tree();
            phi_136_ = true;
        }
        let _e51 = phi_135_;
        let _e53 = phi_136_;
        phi_137_ = _e51;
        phi_138_ = _e53;
    } else {
        phi_137_ = lt_bvh_traverse_Tree();
        phi_138_ = true;
    }
    let _e55 = phi_137_;
    let _e57 = phi_138_;
    if _e57 {
        phi_143_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_143_ = _e55;
    }
    let _e62 = phi_143_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_745_: f32;
    var phi_746_: f32;
    var phi_747_: f32;
    var phi_764_: f32;
    var phi_765_: f32;
    var phi_766_: f32;
    var phi_782_: f32;
    var phi_783_: f32;
    var phi_784_: f32;
    var phi_800_: f32;
    var phi_801_: f32;
    var phi_802_: f32;
    var phi_818_: f32;
    var phi_819_: f32;
    var phi_820_: f32;
    var phi_855_: bool;
    var phi_856_: bool;
    var phi_857_: bool;
    var phi_858_: bool;
    var phi_859_: bool;
    var phi_860_: bool;
    var phi_864_: bool;
    var phi_1175_: f32;
    var phi_1176_: f32;
    var phi_1177_: f32;
    var phi_1194_: f32;
    var phi_1195_: f32;
    var phi_1196_: f32;
    var phi_1213_: f32;
    var phi_1214_: f32;
    var phi_1215_: f32;
    var phi_1232_: f32;
    var phi_1233_: f32;
    var phi_1234_: f32;
    var phi_1257_: f32;
    var phi_1258_: f32;
    var phi_1259_: f32;
    var phi_1270_: f32;
    var phi_1285_: f32;
    var phi_1287_: lt_bvh_slab_Span;
    var phi_1345_: f32;
    var phi_1346_: f32;
    var phi_1347_: f32;
    var phi_1348_: f32;
    var phi_1349_: f32;
    var phi_1350_: bool;
    var phi_1354_: f32;
    var phi_1364_: bool;
    var phi_1377_: bool;
    var phi_1381_: bool;
    var phi_1382_: bool;
    var phi_1392_: bool;
    var phi_1393_: bool;
    var phi_1394_: bool;
    var phi_1398_: bool;
    var phi_1449_: f32;
    var phi_1450_: f32;
    var phi_1451_: f32;
    var phi_1468_: f32;
    var phi_1469_: f32;
    var phi_1470_: f32;
    var phi_1487_: f32;
    var phi_1488_: f32;
    var phi_1489_: f32;
    var phi_1506_: f32;
    var phi_1507_: f32;
    var phi_1508_: f32;
    var phi_1531_: f32;
    var phi_1532_: f32;
    var phi_1533_: f32;
    var phi_1620_: f32;
    var phi_1621_: f32;
    var phi_1632_: bool;
    var phi_1636_: f32;
    var phi_1637_: f32;
    var phi_1652_: f32;
    var phi_1653_: f32;
    var phi_1654_: f32;
    var phi_1655_: f32;
    var phi_1656_: f32;
    var phi_1657_: f32;
    var phi_1658_: f32;
    var phi_1659_: bool;
    var phi_1660_: f32;
    var phi_1661_: f32;
    var phi_1662_: bool;
    var phi_1666_: f32;

    let _e42 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_747_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_746_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_745_ = 1f;
            } else {
                phi_745_ = param_7;
            }
            let _e49 = phi_745_;
            phi_746_ = _e49;
        }
        let _e51 = phi_746_;
        phi_747_ = _e51;
    }
    let _e53 = phi_747_;
    let _e54 = (_e53 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_766_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_765_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_764_ = 1f;
            } else {
                phi_764_ = param_5.x;
            }
            let _e62 = phi_764_;
            phi_765_ = _e62;
        }
        let _e64 = phi_765_;
        phi_766_ = _e64;
    }
    let _e66 = phi_766_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_784_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_783_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_782_ = 1f;
            } else {
                phi_782_ = param_5.y;
            }
            let _e74 = phi_782_;
            phi_783_ = _e74;
        }
        let _e76 = phi_783_;
        phi_784_ = _e76;
    }
    let _e78 = phi_784_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_802_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_801_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_800_ = 1f;
            } else {
                phi_800_ = param_5.z;
            }
            let _e86 = phi_800_;
            phi_801_ = _e86;
        }
        let _e88 = phi_801_;
        phi_802_ = _e88;
    }
    let _e90 = phi_802_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_820_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_819_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_818_ = 1f;
            } else {
                phi_818_ = param_5.w;
            }
            let _e98 = phi_818_;
            phi_819_ = _e98;
        }
        let _e100 = phi_819_;
        phi_820_ = _e100;
    }
    let _e102 = phi_820_;
    let _e103 = (_e66 - _e54);
    let _e104 = (_e78 - _e54);
    let _e105 = (_e90 - _e54);
    let _e106 = (_e102 - _e54);
    let _e117 = ((((_e103 * param_6.x) + (_e104 * param_6.y)) + (_e105 * param_6.z)) + (_e106 * param_6.w));
    if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
        phi_1660_ = _e117;
        phi_1661_ = f32();
        phi_1662_ = true;
    } else {
        if (_e103 >= 0f) {
            if (_e104 >= 0f) {
                if (_e105 >= 0f) {
                    phi_855_ = (_e106 >= 0f);
                    phi_856_ = false;
                } else {
                    phi_855_ = bool();
                    phi_856_ = true;
                }
                let _e126 = phi_855_;
                let _e128 = phi_856_;
                phi_857_ = _e126;
                phi_858_ = _e128;
            } else {
                phi_857_ = bool();
                phi_858_ = true;
            }
            let _e130 = phi_857_;
            let _e132 = phi_858_;
            phi_859_ = _e130;
            phi_860_ = _e132;
        } else {
            phi_859_ = bool();
            phi_860_ = true;
        }
        let _e134 = phi_859_;
        let _e136 = phi_860_;
        if _e136 {
            phi_864_ = false;
        } else {
            phi_864_ = _e134;
        }
        let _e138 = phi_864_;
        if _e138 {
            phi_1657_ = 1f;
            phi_1658_ = f32();
            phi_1659_ = true;
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
                    phi_1177_ = _e103;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1176_ = 0f;
                    } else {
                        if (_e103 < 0f) {
                            phi_1175_ = 0f;
                        } else {
                            phi_1175_ = 1f;
                        }
                        let _e435 = phi_1175_;
                        phi_1176_ = _e435;
                    }
                    let _e437 = phi_1176_;
                    phi_1177_ = _e437;
                }
                let _e439 = phi_1177_;
                if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                    phi_1196_ = _e104;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1195_ = 0f;
                    } else {
                        if (_e104 < 0f) {
                            phi_1194_ = 0f;
                        } else {
                            phi_1194_ = 1f;
                        }
                        let _e448 = phi_1194_;
                        phi_1195_ = _e448;
                    }
                    let _e450 = phi_1195_;
                    phi_1196_ = _e450;
                }
                let _e452 = phi_1196_;
                if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
                    phi_1215_ = _e105;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1214_ = 0f;
                    } else {
                        if (_e105 < 0f) {
                            phi_1213_ = 0f;
                        } else {
                            phi_1213_ = 1f;
                        }
                        let _e461 = phi_1213_;
                        phi_1214_ = _e461;
                    }
                    let _e463 = phi_1214_;
                    phi_1215_ = _e463;
                }
                let _e465 = phi_1215_;
                if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                    phi_1234_ = _e106;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_1233_ = 0f;
                    } else {
                        if (_e106 < 0f) {
                            phi_1232_ = 0f;
                        } else {
                            phi_1232_ = 1f;
                        }
                        let _e474 = phi_1232_;
                        phi_1233_ = _e474;
                    }
                    let _e476 = phi_1233_;
                    phi_1234_ = _e476;
                }
                let _e478 = phi_1234_;
                let _e486 = (((((_e439 * _e142) + (_e452 * _e144)) + (_e465 * _e146)) + (_e478 * _e148)) + _e139);
                if ((bitcast<u32>(_e486) & 2147483647u) > 2139095040u) {
                    phi_1259_ = _e486;
                } else {
                    if (_e486 < 0f) {
                        phi_1258_ = 0f;
                    } else {
                        if (_e486 > 1f) {
                            phi_1257_ = 1f;
                        } else {
                            phi_1257_ = _e486;
                        }
                        let _e493 = phi_1257_;
                        phi_1258_ = _e493;
                    }
                    let _e495 = phi_1258_;
                    phi_1259_ = _e495;
                }
                let _e497 = phi_1259_;
                phi_1655_ = _e497;
                phi_1656_ = f32();
            } else {
                let _e499 = ((0.5f * -(((((((((_e203 * (_e103 + _e104)) + (_e207 * (_e103 + _e105))) + (_e231 * (_e103 + _e149))) + (_e243 * (_e103 + _e150))) + ((((_e204 * (_e104 + _e105)) + (_e208 * (_e104 + _e106))) + (_e232 * (_e104 + _e149))) + (_e244 * (_e104 + _e150)))) + ((((_e205 * (_e105 + _e106)) + (_e209 * (_e105 + _e103))) + (_e233 * (_e105 + _e149))) + (_e245 * (_e105 + _e150)))) + ((((_e206 * (_e106 + _e103)) + (_e210 * (_e106 + _e104))) + (_e234 * (_e106 + _e149))) + (_e246 * (_e106 + _e150)))) + (_e417 * (_e149 + _e150))))) / _e420);
                let _e500 = ((((((((_e203 + _e207) + _e231) + _e243) + (((_e204 + _e208) + _e232) + _e244)) + (((_e205 + _e209) + _e233) + _e245)) + (((_e206 + _e210) + _e234) + _e246)) + _e417) / _e420);
                let _e502 = ((_e499 * _e499) - _e500);
                if (_e502 > 0f) {
                    phi_1270_ = sqrt(_e502);
                } else {
                    phi_1270_ = 0f;
                }
                let _e506 = phi_1270_;
                if (_e499 > 0f) {
                    let _e509 = (-(_e499) - _e506);
                    phi_1287_ = lt_bvh_slab_Span(_e509, (_e500 / _e509));
                } else {
                    let _e512 = (_e506 - _e499);
                    if (_e512 > 0f) {
                        phi_1285_ = (_e500 / _e512);
                    } else {
                        phi_1285_ = 0f;
                    }
                    let _e516 = phi_1285_;
                    phi_1287_ = lt_bvh_slab_Span(_e516, _e512);
                }
                let _e519 = phi_1287_;
                if (_e519.near >= 0f) {
                    phi_1348_ = 1f;
                    phi_1349_ = f32();
                    phi_1350_ = true;
                } else {
                    let _e523 = (_e519.far <= 0f);
                    if _e523 {
                        phi_1346_ = (_e414 / _e420);
                        phi_1347_ = f32();
                    } else {
                        let _e534 = (((((_e142 * _e103) + (_e144 * _e104)) + (_e146 * _e105)) + (_e148 * _e106)) + (_e139 * (_e149 + _e150)));
                        let _e550 = (((((_e142 * (_e103 * _e103)) + (_e144 * (_e104 * _e104))) + (_e146 * (_e105 * _e105))) + (_e148 * (_e106 * _e106))) + (_e139 * ((_e149 * _e149) + (_e150 * _e150))));
                        if (-(_e519.near) <= _e519.far) {
                            phi_1345_ = (1f - (((_e519.near * _e519.near) * ((_e519.far * _e550) - _e534)) / (_e519.far - _e519.near)));
                        } else {
                            phi_1345_ = ((_e414 / _e420) + (((_e519.far * _e519.far) * (_e534 - (_e519.near * _e550))) / (_e519.far - _e519.near)));
                        }
                        let _e569 = phi_1345_;
                        phi_1346_ = f32();
                        phi_1347_ = _e569;
                    }
                    let _e571 = phi_1346_;
                    let _e573 = phi_1347_;
                    phi_1348_ = _e571;
                    phi_1349_ = _e573;
                    phi_1350_ = _e523;
                }
                let _e575 = phi_1348_;
                let _e577 = phi_1349_;
                let _e579 = phi_1350_;
                if _e579 {
                    phi_1354_ = _e575;
                } else {
                    phi_1354_ = _e577;
                }
                let _e581 = phi_1354_;
                if ((_e519.near * _e149) >= (1f - 0.00001f)) {
                    phi_1364_ = true;
                } else {
                    phi_1364_ = ((_e519.near * _e150) >= (1f - 0.00001f));
                }
                let _e589 = phi_1364_;
                if _e589 {
                    if ((_e519.far * _e149) >= (1f - 0.00001f)) {
                        phi_1377_ = true;
                    } else {
                        phi_1377_ = ((_e519.far * _e150) >= (1f - 0.00001f));
                    }
                    let _e597 = phi_1377_;
                    if _e597 {
                        phi_1381_ = false;
                    } else {
                        phi_1381_ = true;
                    }
                    let _e599 = phi_1381_;
                    phi_1382_ = _e599;
                } else {
                    phi_1382_ = true;
                }
                let _e601 = phi_1382_;
                if _e601 {
                    let _e603 = (-(_e149) < 0.0001f);
                    if _e603 {
                        phi_1392_ = bool();
                    } else {
                        phi_1392_ = (_e150 < 0.0001f);
                    }
                    let _e606 = phi_1392_;
                    phi_1393_ = _e606;
                    phi_1394_ = _e603;
                } else {
                    phi_1393_ = bool();
                    phi_1394_ = true;
                }
                let _e608 = phi_1393_;
                let _e610 = phi_1394_;
                if _e610 {
                    phi_1398_ = true;
                } else {
                    phi_1398_ = _e608;
                }
                let _e612 = phi_1398_;
                if !(_e612) {
                    let _e618 = ((_e142 * _e66) * _e152);
                    let _e619 = ((_e144 * _e78) * _e154);
                    let _e620 = ((_e146 * _e90) * _e156);
                    let _e621 = ((_e148 * _e102) * _e158);
                    let _e639 = ((((_e618 * (_e103 * _e103)) + (_e619 * (_e104 * _e104))) + (_e620 * (_e105 * _e105))) + (_e621 * (_e106 * _e106)));
                    if (_e639 < 0.0000000000000000000000000000000001f) {
                        if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
                            phi_1451_ = _e103;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_1450_ = 0f;
                            } else {
                                if (_e103 < 0f) {
                                    phi_1449_ = 0f;
                                } else {
                                    phi_1449_ = 1f;
                                }
                                let _e649 = phi_1449_;
                                phi_1450_ = _e649;
                            }
                            let _e651 = phi_1450_;
                            phi_1451_ = _e651;
                        }
                        let _e653 = phi_1451_;
                        if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                            phi_1470_ = _e104;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_1469_ = 0f;
                            } else {
                                if (_e104 < 0f) {
                                    phi_1468_ = 0f;
                                } else {
                                    phi_1468_ = 1f;
                                }
                                let _e662 = phi_1468_;
                                phi_1469_ = _e662;
                            }
                            let _e664 = phi_1469_;
                            phi_1470_ = _e664;
                        }
                        let _e666 = phi_1470_;
                        if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
                            phi_1489_ = _e105;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_1488_ = 0f;
                            } else {
                                if (_e105 < 0f) {
                                    phi_1487_ = 0f;
                                } else {
                                    phi_1487_ = 1f;
                                }
                                let _e675 = phi_1487_;
                                phi_1488_ = _e675;
                            }
                            let _e677 = phi_1488_;
                            phi_1489_ = _e677;
                        }
                        let _e679 = phi_1489_;
                        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                            phi_1508_ = _e106;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_1507_ = 0f;
                            } else {
                                if (_e106 < 0f) {
                                    phi_1506_ = 0f;
                                } else {
                                    phi_1506_ = 1f;
                                }
                                let _e688 = phi_1506_;
                                phi_1507_ = _e688;
                            }
                            let _e690 = phi_1507_;
                            phi_1508_ = _e690;
                        }
                        let _e692 = phi_1508_;
                        let _e700 = (((((_e653 * _e142) + (_e666 * _e144)) + (_e679 * _e146)) + (_e692 * _e148)) + _e139);
                        if ((bitcast<u32>(_e700) & 2147483647u) > 2139095040u) {
                            phi_1533_ = _e700;
                        } else {
                            if (_e700 < 0f) {
                                phi_1532_ = 0f;
                            } else {
                                if (_e700 > 1f) {
                                    phi_1531_ = 1f;
                                } else {
                                    phi_1531_ = _e700;
                                }
                                let _e707 = phi_1531_;
                                phi_1532_ = _e707;
                            }
                            let _e709 = phi_1532_;
                            phi_1533_ = _e709;
                        }
                        let _e711 = phi_1533_;
                        phi_1621_ = _e711;
                    } else {
                        let _e712 = (((((_e618 * _e103) + (_e619 * _e104)) + (_e620 * _e105)) + (_e621 * _e106)) / _e639);
                        let _e729 = ((_e142 * _e103) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e712 * _e103)));
                        let _e730 = ((_e144 * _e104) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e712 * _e104)));
                        let _e731 = ((_e146 * _e105) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e712 * _e105)));
                        let _e732 = ((_e148 * _e106) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e712 * _e106)));
                        if (_e712 > 0f) {
                            phi_1620_ = ((1f - _e139) - (((((_e729 * _e152) + (_e730 * _e154)) + (_e731 * _e156)) + (_e732 * _e158)) / (_e149 * (1f - (_e149 * _e712)))));
                        } else {
                            phi_1620_ = ((((((((_e618 * ((_e619 * _e163) + ((0.5f * _e620) * _e171))) * vec4<f32>(1f, 1f, 1f, 1f).x) + ((_e619 * ((_e620 * _e164) + ((0.5f * _e621) * _e172))) * vec4<f32>(1f, 1f, 1f, 1f).y)) + ((_e620 * ((_e621 * _e165) + ((0.5f * _e618) * _e173))) * vec4<f32>(1f, 1f, 1f, 1f).z)) + ((_e621 * ((_e618 * _e166) + ((0.5f * _e619) * _e174))) * vec4<f32>(1f, 1f, 1f, 1f).w)) / (_e639 * (-(_e149) * _e150))) + _e139) + (((((_e729 * _e66) + (_e730 * _e78)) + (_e731 * _e90)) + (_e732 * _e102)) / (_e150 * (1f - (_e712 * _e150)))));
                        }
                        let _e796 = phi_1620_;
                        phi_1621_ = _e796;
                    }
                    let _e798 = phi_1621_;
                    if ((bitcast<u32>(_e581) & 2147483647u) > 2139095040u) {
                        phi_1632_ = true;
                    } else {
                        let _e802 = (_e581 < _e798);
                        if _e802 {
                        }
                        phi_1632_ = _e802;
                    }
                    let _e804 = phi_1632_;
                    if _e804 {
                        phi_1636_ = _e581;
                    } else {
                        phi_1636_ = _e798;
                    }
                    let _e806 = phi_1636_;
                    phi_1637_ = _e806;
                } else {
                    phi_1637_ = _e581;
                }
                let _e808 = phi_1637_;
                if ((bitcast<u32>(_e808) & 2147483647u) > 2139095040u) {
                    phi_1654_ = _e808;
                } else {
                    if (_e808 < 0f) {
                        phi_1653_ = 0f;
                    } else {
                        if (_e808 > 1f) {
                            phi_1652_ = 1f;
                        } else {
                            phi_1652_ = _e808;
                        }
                        let _e815 = phi_1652_;
                        phi_1653_ = _e815;
                    }
                    let _e817 = phi_1653_;
                    phi_1654_ = _e817;
                }
                let _e819 = phi_1654_;
                phi_1655_ = f32();
                phi_1656_ = _e819;
            }
            let _e821 = phi_1655_;
            let _e823 = phi_1656_;
            phi_1657_ = _e821;
            phi_1658_ = _e823;
            phi_1659_ = _e426;
        }
        let _e825 = phi_1657_;
        let _e827 = phi_1658_;
        let _e829 = phi_1659_;
        phi_1660_ = _e825;
        phi_1661_ = _e827;
        phi_1662_ = _e829;
    }
    let _e831 = phi_1660_;
    let _e833 = phi_1661_;
    let _e835 = phi_1662_;
    if _e835 {
        phi_1666_ = _e831;
    } else {
        phi_1666_ = _e833;
    }
    let _e837 = phi_1666_;
    return _e837;
}

fn function_() {
    var local: f32;
    var phi_205_: bool;
    var phi_206_: bool;
    var phi_207_: bool;
    var phi_208_: bool;
    var phi_212_: bool;
    var phi_282_: bool;
    var phi_283_: bool;
    var phi_294_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_295_: bool;
    var phi_296_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_297_: bool;
    var phi_304_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_308_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_382_: bool;
    var phi_391_: bool;
    var phi_400_: bool;
    var phi_401_: bool;
    var phi_402_: bool;
    var phi_403_: bool;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_410_: bool;
    var phi_500_: f32;
    var phi_503_: f32;
    var phi_532_: f32;
    var phi_537_: f32;
    var phi_538_: bool;
    var phi_539_: f32;
    var phi_540_: bool;
    var phi_544_: f32;
    var phi_564_: f32;
    var phi_569_: f32;
    var phi_570_: bool;
    var phi_571_: f32;
    var phi_572_: bool;
    var phi_576_: f32;
    var phi_624_: i32;
    var phi_629_: i32;
    var phi_634_: i32;
    var phi_639_: i32;
    var phi_648_: i32;
    var phi_653_: i32;
    var phi_658_: i32;
    var phi_663_: i32;
    var phi_708_: evaluate_Verdict;
    var phi_709_: evaluate_Verdict;
    var phi_710_: bool;
    var phi_711_: evaluate_Verdict;
    var phi_712_: evaluate_Verdict;
    var phi_713_: bool;
    var phi_717_: evaluate_Verdict;

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
        let _e69 = samples.member[(0u + _e55.first_primitive)].normal[0u];
        let _e71 = global[0u];
        if (_e69 == _e71) {
            let _e74 = samples.member[(0u + _e55.first_primitive)].normal[1u];
            let _e76 = global[1u];
            if (_e74 == _e76) {
                let _e79 = samples.member[(0u + _e55.first_primitive)].normal[2u];
                let _e81 = global[2u];
                phi_205_ = (_e79 == _e81);
                phi_206_ = false;
            } else {
                phi_205_ = bool();
                phi_206_ = true;
            }
            let _e84 = phi_205_;
            let _e86 = phi_206_;
            phi_207_ = _e84;
            phi_208_ = _e86;
        } else {
            phi_207_ = bool();
            phi_208_ = true;
        }
        let _e88 = phi_207_;
        let _e90 = phi_208_;
        if _e90 {
            phi_212_ = false;
        } else {
            phi_212_ = _e88;
        }
        let _e92 = phi_212_;
        if !(_e92) {
            let _e95 = samples.member[(0u + _e55.first_primitive)].position;
            let _e97 = p.member.light.place;
            let _e103 = p.member.light.place[3u];
            let _e110 = (_e97.x - (_e95.x * _e103));
            let _e111 = (_e97.y - (_e95.y * _e103));
            let _e112 = (_e97.z - (_e95.z * _e103));
            let _e114 = samples.member[(0u + _e55.first_primitive)].normal;
            if ((((_e114.x * _e110) + (_e114.y * _e111)) + (_e114.z * _e112)) > 0f) {
                let _e128 = (((_e110 * _e110) + (_e111 * _e111)) + (_e112 * _e112));
                let _e130 = p.member.light.axis;
                let _e142 = p.member.light.place[3u];
                if (_e142 == 0f) {
                    phi_283_ = true;
                } else {
                    let _e145 = p.member.light.range_squared;
                    if (_e128 <= _e145) {
                        let _e148 = p.member.light.cos_outer;
                        phi_282_ = (-((((_e110 * _e130.x) + (_e111 * _e130.y)) + (_e112 * _e130.z))) >= (_e148 * sqrt(_e128)));
                    } else {
                        phi_282_ = false;
                    }
                    let _e153 = phi_282_;
                    phi_283_ = _e153;
                }
                let _e155 = phi_283_;
                if _e155 {
                    let _e157 = samples.member[(0u + _e55.first_primitive)].flags;
                    let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e165.unnamed.visibility, false), _e165.unnamed_1);
                    phi_294_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e171.unnamed, ((_e157 & 1u) == 0u));
                    phi_295_ = false;
                } else {
                    phi_294_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_295_ = true;
                }
                let _e176 = phi_294_;
                let _e178 = phi_295_;
                phi_296_ = _e176;
                phi_297_ = _e178;
            } else {
                phi_296_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_297_ = true;
            }
            let _e180 = phi_296_;
            let _e182 = phi_297_;
            if _e182 {
                let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e194 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e188.unnamed.visibility, false), _e188.unnamed_1);
                phi_304_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e194.unnamed, true);
            } else {
                phi_304_ = _e180;
            }
            let _e199 = phi_304_;
            phi_308_ = _e199;
        } else {
            let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
            phi_308_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, true);
        }
        let _e216 = phi_308_;
        if _e216.unnamed_1 {
            phi_711_ = evaluate_Verdict(_e216.unnamed.visibility, _e216.unnamed.is_doubted);
            phi_712_ = evaluate_Verdict();
            phi_713_ = true;
        } else {
            let _e224 = samples.member[(0u + _e55.first_primitive)].position;
            let _e242 = ((((_e65.projection.row_w.x * _e224.x) + (_e65.projection.row_w.y * _e224.y)) + (_e65.projection.row_w.z * _e224.z)) + (_e65.projection.row_w.w * 1f));
            let _e256 = (((((_e65.projection.row_x.x * _e224.x) + (_e65.projection.row_x.y * _e224.y)) + (_e65.projection.row_x.z * _e224.z)) + (_e65.projection.row_x.w * 1f)) / _e242);
            let _e270 = (((((_e65.projection.row_y.x * _e224.x) + (_e65.projection.row_y.y * _e224.y)) + (_e65.projection.row_y.z * _e224.z)) + (_e65.projection.row_y.w * 1f)) / _e242);
            let _e283 = ((((_e65.projection.row_z.x * _e224.x) + (_e65.projection.row_z.y * _e224.y)) + (_e65.projection.row_z.z * _e224.z)) + (_e65.projection.row_z.w * 1f));
            if (_e242 > 0f) {
                if (_e256 >= 0f) {
                    phi_382_ = (_e256 <= 1f);
                } else {
                    phi_382_ = false;
                }
                let _e288 = phi_382_;
                if _e288 {
                    if (_e270 >= 0f) {
                        phi_391_ = (_e270 <= 1f);
                    } else {
                        phi_391_ = false;
                    }
                    let _e292 = phi_391_;
                    if _e292 {
                        if (_e283 >= 0f) {
                            phi_400_ = (_e283 <= 1f);
                        } else {
                            phi_400_ = false;
                        }
                        let _e296 = phi_400_;
                        phi_401_ = _e296;
                        phi_402_ = false;
                    } else {
                        phi_401_ = bool();
                        phi_402_ = true;
                    }
                    let _e298 = phi_401_;
                    let _e300 = phi_402_;
                    phi_403_ = _e298;
                    phi_404_ = _e300;
                } else {
                    phi_403_ = bool();
                    phi_404_ = true;
                }
                let _e302 = phi_403_;
                let _e304 = phi_404_;
                phi_405_ = _e302;
                phi_406_ = _e304;
            } else {
                phi_405_ = bool();
                phi_406_ = true;
            }
            let _e306 = phi_405_;
            let _e308 = phi_406_;
            if _e308 {
                phi_410_ = false;
            } else {
                phi_410_ = _e306;
            }
            let _e310 = phi_410_;
            if _e310 {
                if (0f > 0f) {
                    let _e313 = samples.member[(0u + _e55.first_primitive)].normal;
                    let _e315 = p.member.map_size;
                    let _e385 = ((abs(((((_e61.row_x.x * _e313.x) + (_e61.row_x.y * _e313.y)) + (_e61.row_x.z * _e313.z)) / (((_e61.row_x.x * _e61.row_x.x) + (_e61.row_x.y * _e61.row_x.y)) + (_e61.row_x.z * _e61.row_x.z)))) + abs(((((_e61.row_y.x * _e313.x) + (_e61.row_y.y * _e313.y)) + (_e61.row_y.z * _e313.z)) / (((_e61.row_y.x * _e61.row_y.x) + (_e61.row_y.y * _e61.row_y.y)) + (_e61.row_y.z * _e61.row_y.z))))) / (abs(((((_e61.row_z.x * _e313.x) + (_e61.row_z.y * _e313.y)) + (_e61.row_z.z * _e313.z)) / (((_e61.row_z.x * _e61.row_z.x) + (_e61.row_z.y * _e61.row_z.y)) + (_e61.row_z.z * _e61.row_z.z)))) * f32(_e315)));
                    if (_e385 < 0.002f) {
                        phi_500_ = _e385;
                    } else {
                        phi_500_ = 0.002f;
                    }
                    let _e388 = phi_500_;
                    phi_503_ = (_e283 - (0f * _e388));
                } else {
                    phi_503_ = _e283;
                }
                let _e392 = phi_503_;
                let _e394 = p.member.map_size;
                let _e395 = f32(_e394);
                let _e398 = ((_e256 * _e395) - 0.5f);
                let _e399 = ((_e270 * _e395) - 0.5f);
                if (_e398 > -8388608f) {
                    let _e411 = f32(select(0i, select(select(i32(_e398), i32(-2147483648), (_e398 < bitcast<f32>(3472883712u))), 2147483647i, (_e398 > bitcast<f32>(1325400063u))), (_e398 == _e398)));
                    if (_e411 > _e398) {
                        phi_532_ = 1f;
                    } else {
                        phi_532_ = 0f;
                    }
                    let _e414 = phi_532_;
                    if (_e398 < 8388608f) {
                        phi_537_ = (_e411 - _e414);
                        phi_538_ = false;
                    } else {
                        phi_537_ = f32();
                        phi_538_ = true;
                    }
                    let _e417 = phi_537_;
                    let _e419 = phi_538_;
                    phi_539_ = _e417;
                    phi_540_ = _e419;
                } else {
                    phi_539_ = f32();
                    phi_540_ = true;
                }
                let _e421 = phi_539_;
                let _e423 = phi_540_;
                if _e423 {
                    phi_544_ = _e398;
                } else {
                    phi_544_ = _e421;
                }
                let _e425 = phi_544_;
                if (_e399 > -8388608f) {
                    let _e437 = f32(select(0i, select(select(i32(_e399), i32(-2147483648), (_e399 < bitcast<f32>(3472883712u))), 2147483647i, (_e399 > bitcast<f32>(1325400063u))), (_e399 == _e399)));
                    if (_e437 > _e399) {
                        phi_564_ = 1f;
                    } else {
                        phi_564_ = 0f;
                    }
                    let _e440 = phi_564_;
                    if (_e399 < 8388608f) {
                        phi_569_ = (_e437 - _e440);
                        phi_570_ = false;
                    } else {
                        phi_569_ = f32();
                        phi_570_ = true;
                    }
                    let _e443 = phi_569_;
                    let _e445 = phi_570_;
                    phi_571_ = _e443;
                    phi_572_ = _e445;
                } else {
                    phi_571_ = f32();
                    phi_572_ = true;
                }
                let _e447 = phi_571_;
                let _e449 = phi_572_;
                if _e449 {
                    phi_576_ = _e399;
                } else {
                    phi_576_ = _e447;
                }
                let _e451 = phi_576_;
                let _e452 = (_e398 - _e425);
                let _e453 = (_e399 - _e451);
                let _e462 = select(0i, select(select(i32(_e425), i32(-2147483648), (_e425 < bitcast<f32>(3472883712u))), 2147483647i, (_e425 > bitcast<f32>(1325400063u))), (_e425 == _e425));
                let _e471 = select(0i, select(select(i32(_e451), i32(-2147483648), (_e451 < bitcast<f32>(3472883712u))), 2147483647i, (_e451 > bitcast<f32>(1325400063u))), (_e451 == _e451));
                let _e482 = p.member.test;
                let _e483 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e482);
                let _e485 = p.member.map_size;
                local = _e483;
                let _e487 = ((0u * _e485) * _e485);
                let _e489 = (bitcast<i32>(_e485) - 1i);
                if (_e462 > 0i) {
                    phi_624_ = _e462;
                } else {
                    phi_624_ = 0i;
                }
                let _e492 = phi_624_;
                if (_e471 > 0i) {
                    phi_629_ = _e471;
                } else {
                    phi_629_ = 0i;
                }
                let _e495 = phi_629_;
                if (_e492 < _e489) {
                    phi_634_ = _e492;
                } else {
                    phi_634_ = _e489;
                }
                let _e498 = phi_634_;
                if (_e495 < _e489) {
                    phi_639_ = _e495;
                } else {
                    phi_639_ = _e489;
                }
                let _e501 = phi_639_;
                let _e502 = bitcast<u32>(_e498);
                let _e504 = (_e462 + 1i);
                let _e505 = (_e471 + 1i);
                if (_e504 > 0i) {
                    phi_648_ = _e504;
                } else {
                    phi_648_ = 0i;
                }
                let _e508 = phi_648_;
                if (_e505 > 0i) {
                    phi_653_ = _e505;
                } else {
                    phi_653_ = 0i;
                }
                let _e511 = phi_653_;
                if (_e508 < _e489) {
                    phi_658_ = _e508;
                } else {
                    phi_658_ = _e489;
                }
                let _e514 = phi_658_;
                if (_e511 < _e489) {
                    phi_663_ = _e511;
                } else {
                    phi_663_ = _e489;
                }
                let _e517 = phi_663_;
                let _e518 = bitcast<u32>(_e514);
                let _e520 = (bitcast<u32>(_e501) * _e485);
                let _e521 = (bitcast<u32>(_e517) * _e485);
                let _e526 = ((_e520 + _e502) + _e487);
                let _e527 = ((_e520 + _e518) + _e487);
                let _e528 = ((_e521 + _e502) + _e487);
                let _e529 = ((_e521 + _e518) + _e487);
                if (_e526 < _e46) {
                } else {
                    return;
                }
                let _e533 = map.member[(0u + _e526)];
                if (_e527 < _e46) {
                } else {
                    return;
                }
                let _e537 = map.member[(0u + _e527)];
                if (_e528 < _e46) {
                } else {
                    return;
                }
                let _e541 = map.member[(0u + _e528)];
                if (_e529 < _e46) {
                } else {
                    return;
                }
                let _e545 = map.member[(0u + _e529)];
                let _e547 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e533, _e537, _e541, _e545), vec4<f32>(((1f - _e452) * (1f - _e453)), (_e452 * (1f - _e453)), ((1f - _e452) * _e453), (_e452 * _e453)), _e392);
                phi_708_ = evaluate_Verdict(_e547, false);
                phi_709_ = evaluate_Verdict();
                phi_710_ = false;
            } else {
                phi_708_ = evaluate_Verdict();
                phi_709_ = evaluate_Verdict(1f, false);
                phi_710_ = true;
            }
            let _e551 = phi_708_;
            let _e553 = phi_709_;
            let _e555 = phi_710_;
            phi_711_ = _e553;
            phi_712_ = _e551;
            phi_713_ = _e555;
        }
        let _e557 = phi_711_;
        let _e559 = phi_712_;
        let _e561 = phi_713_;
        if _e561 {
            phi_717_ = _e557;
        } else {
            phi_717_ = _e559;
        }
        let _e563 = phi_717_;
        if (_e55.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e55.first_primitive)] = _e563.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
