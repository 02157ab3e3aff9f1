struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_17 {
    member: array<abi_Sample>,
}

struct type_21 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
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

struct type_28 {
    member: abi_ShadowParams,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct lt_bvh_slab_Span {
    near: f32,
    far: f32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_17;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_28;
@group(0) @binding(2) 
var<storage> map: type_21;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_21;

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
        let _e50 = phi_128_;
        let _e52 = phi_129_;
        phi_130_ = _e50;
        phi_131_ = _e52;
    } else {
        phi_130_ = lt_bvh_traverse_Tree();
        phi_131_ = true;
    }
    let _e54 = phi_130_;
    let _e56 = phi_131_;
    if _e56 {
        phi_136_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_136_ = _e54;
    }
    let _e61 = phi_136_;
    return lt_bvh_traverse_Tree(_e61.root, _e61.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: vec4<f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_596_: f32;
    var phi_597_: f32;
    var phi_598_: f32;
    var phi_615_: f32;
    var phi_616_: f32;
    var phi_617_: f32;
    var phi_633_: f32;
    var phi_634_: f32;
    var phi_635_: f32;
    var phi_651_: f32;
    var phi_652_: f32;
    var phi_653_: f32;
    var phi_669_: f32;
    var phi_670_: f32;
    var phi_671_: f32;
    var phi_686_: bool;
    var phi_690_: f32;
    var phi_701_: bool;
    var phi_705_: f32;
    var phi_716_: bool;
    var phi_720_: f32;
    var phi_731_: bool;
    var phi_735_: f32;
    var phi_746_: bool;
    var phi_750_: f32;
    var phi_761_: bool;
    var phi_765_: f32;
    var phi_788_: bool;
    var phi_792_: f32;
    var phi_803_: bool;
    var phi_807_: f32;
    var phi_916_: f32;
    var phi_917_: f32;
    var phi_918_: f32;
    var phi_935_: f32;
    var phi_936_: f32;
    var phi_937_: f32;
    var phi_954_: f32;
    var phi_955_: f32;
    var phi_956_: f32;
    var phi_973_: f32;
    var phi_974_: f32;
    var phi_975_: f32;
    var phi_1001_: f32;
    var phi_1002_: f32;
    var phi_1003_: f32;
    var phi_1004_: f32;
    var phi_1005_: f32;
    var phi_1013_: bool;
    var phi_1014_: bool;
    var phi_1015_: bool;
    var phi_1019_: bool;
    var phi_1031_: bool;
    var phi_1032_: bool;
    var phi_1036_: f32;
    var phi_1047_: f32;
    var phi_1062_: f32;
    var phi_1064_: lt_bvh_slab_Span;
    var phi_1192_: f32;
    var phi_1193_: f32;
    var phi_1194_: f32;
    var phi_1195_: f32;
    var phi_1196_: f32;
    var phi_1197_: bool;
    var phi_1201_: f32;
    var phi_1216_: f32;
    var phi_1217_: f32;
    var phi_1218_: f32;
    var phi_1226_: bool;
    var phi_1227_: bool;
    var phi_1231_: f32;
    var phi_1232_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_598_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_597_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_596_ = 1f;
            } else {
                phi_596_ = param_6;
            }
            let _e46 = phi_596_;
            phi_597_ = _e46;
        }
        let _e48 = phi_597_;
        phi_598_ = _e48;
    }
    let _e50 = phi_598_;
    let _e51 = (_e50 - 0.00000047683716f);
    if ((bitcast<u32>(param_4.x) & 2147483647u) > 2139095040u) {
        phi_617_ = param_4.x;
    } else {
        if (param_4.x < 0f) {
            phi_616_ = 0f;
        } else {
            if (param_4.x > 1f) {
                phi_615_ = 1f;
            } else {
                phi_615_ = param_4.x;
            }
            let _e59 = phi_615_;
            phi_616_ = _e59;
        }
        let _e61 = phi_616_;
        phi_617_ = _e61;
    }
    let _e63 = phi_617_;
    if ((bitcast<u32>(param_4.y) & 2147483647u) > 2139095040u) {
        phi_635_ = param_4.y;
    } else {
        if (param_4.y < 0f) {
            phi_634_ = 0f;
        } else {
            if (param_4.y > 1f) {
                phi_633_ = 1f;
            } else {
                phi_633_ = param_4.y;
            }
            let _e71 = phi_633_;
            phi_634_ = _e71;
        }
        let _e73 = phi_634_;
        phi_635_ = _e73;
    }
    let _e75 = phi_635_;
    if ((bitcast<u32>(param_4.z) & 2147483647u) > 2139095040u) {
        phi_653_ = param_4.z;
    } else {
        if (param_4.z < 0f) {
            phi_652_ = 0f;
        } else {
            if (param_4.z > 1f) {
                phi_651_ = 1f;
            } else {
                phi_651_ = param_4.z;
            }
            let _e83 = phi_651_;
            phi_652_ = _e83;
        }
        let _e85 = phi_652_;
        phi_653_ = _e85;
    }
    let _e87 = phi_653_;
    if ((bitcast<u32>(param_4.w) & 2147483647u) > 2139095040u) {
        phi_671_ = param_4.w;
    } else {
        if (param_4.w < 0f) {
            phi_670_ = 0f;
        } else {
            if (param_4.w > 1f) {
                phi_669_ = 1f;
            } else {
                phi_669_ = param_4.w;
            }
            let _e95 = phi_669_;
            phi_670_ = _e95;
        }
        let _e97 = phi_670_;
        phi_671_ = _e97;
    }
    let _e99 = phi_671_;
    let _e100 = (_e63 - _e51);
    let _e101 = (_e75 - _e51);
    let _e102 = (_e87 - _e51);
    let _e103 = (_e99 - _e51);
    if ((bitcast<u32>(_e101) & 2147483647u) > 2139095040u) {
        phi_686_ = true;
    } else {
        let _e107 = (_e101 < _e100);
        if _e107 {
        }
        phi_686_ = _e107;
    }
    let _e109 = phi_686_;
    if _e109 {
        phi_690_ = _e101;
    } else {
        phi_690_ = _e100;
    }
    let _e111 = phi_690_;
    if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
        phi_701_ = true;
    } else {
        let _e115 = (_e103 < _e102);
        if _e115 {
        }
        phi_701_ = _e115;
    }
    let _e117 = phi_701_;
    if _e117 {
        phi_705_ = _e103;
    } else {
        phi_705_ = _e102;
    }
    let _e119 = phi_705_;
    if ((bitcast<u32>(_e119) & 2147483647u) > 2139095040u) {
        phi_716_ = true;
    } else {
        let _e123 = (_e119 < _e111);
        if _e123 {
        }
        phi_716_ = _e123;
    }
    let _e125 = phi_716_;
    if _e125 {
        phi_720_ = _e119;
    } else {
        phi_720_ = _e111;
    }
    let _e127 = phi_720_;
    if ((bitcast<u32>(_e101) & 2147483647u) > 2139095040u) {
        phi_731_ = true;
    } else {
        let _e131 = (_e101 > _e100);
        if _e131 {
        }
        phi_731_ = _e131;
    }
    let _e133 = phi_731_;
    if _e133 {
        phi_735_ = _e101;
    } else {
        phi_735_ = _e100;
    }
    let _e135 = phi_735_;
    if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
        phi_746_ = true;
    } else {
        let _e139 = (_e103 > _e102);
        if _e139 {
        }
        phi_746_ = _e139;
    }
    let _e141 = phi_746_;
    if _e141 {
        phi_750_ = _e103;
    } else {
        phi_750_ = _e102;
    }
    let _e143 = phi_750_;
    if ((bitcast<u32>(_e143) & 2147483647u) > 2139095040u) {
        phi_761_ = true;
    } else {
        let _e147 = (_e143 > _e135);
        if _e147 {
        }
        phi_761_ = _e147;
    }
    let _e149 = phi_761_;
    if _e149 {
        phi_765_ = _e143;
    } else {
        phi_765_ = _e135;
    }
    let _e151 = phi_765_;
    let _e162 = ((((_e100 * param_5.x) + (_e101 * param_5.y)) + (_e102 * param_5.z)) + (_e103 * param_5.w));
    let _e163 = -(_e127);
    if ((bitcast<u32>(_e151) & 2147483647u) > 2139095040u) {
        phi_788_ = true;
    } else {
        let _e167 = (_e151 > _e163);
        if _e167 {
        }
        phi_788_ = _e167;
    }
    let _e169 = phi_788_;
    if _e169 {
        phi_792_ = _e151;
    } else {
        phi_792_ = _e163;
    }
    let _e171 = phi_792_;
    if ((bitcast<u32>(0.0000009536743f) & 2147483647u) > 2139095040u) {
        phi_803_ = true;
    } else {
        let _e175 = (0.0000009536743f > _e171);
        if _e175 {
        }
        phi_803_ = _e175;
    }
    let _e177 = phi_803_;
    if _e177 {
        phi_807_ = 0.0000009536743f;
    } else {
        phi_807_ = _e171;
    }
    let _e179 = phi_807_;
    let _e183 = bitcast<f32>((2130706432u - (bitcast<u32>(_e179) & 2139095040u)));
    let _e184 = (_e100 * _e183);
    let _e185 = (_e101 * _e183);
    let _e186 = (_e102 * _e183);
    let _e187 = (_e103 * _e183);
    let _e188 = (_e184 - _e185);
    let _e189 = (_e185 - _e186);
    let _e190 = (_e186 - _e187);
    let _e191 = (_e187 - _e184);
    let _e192 = (_e188 * _e188);
    let _e193 = (_e189 * _e189);
    let _e194 = (_e190 * _e190);
    let _e195 = (_e191 * _e191);
    let _e198 = ((_e184 - _e186) * (_e184 - _e186));
    let _e201 = ((_e185 - _e187) * (_e185 - _e187));
    let _e203 = (param_5.x * _e184);
    let _e205 = (param_5.y * _e185);
    let _e207 = (param_5.z * _e186);
    let _e209 = (param_5.w * _e187);
    let _e214 = ((_e203 * _e205) * _e192);
    let _e215 = ((_e205 * _e207) * _e193);
    let _e216 = ((_e207 * _e209) * _e194);
    let _e217 = ((_e209 * _e203) * _e195);
    let _e219 = ((_e203 * _e207) * _e198);
    let _e221 = ((_e205 * _e209) * _e201);
    let _e238 = ((((((_e214 * (_e184 * _e185)) + (_e215 * (_e185 * _e186))) + (_e216 * (_e186 * _e187))) + (_e217 * (_e187 * _e184))) + (_e219 * (_e184 * _e186))) + (_e221 * (_e185 * _e187)));
    let _e262 = (_e127 >= 0f);
    let _e265 = ((bitcast<u32>(_e162) & 2147483647u) > 2139095040u);
    if _e265 {
        phi_1005_ = _e162;
    } else {
        if _e262 {
            phi_1004_ = 1f;
        } else {
            if ((bitcast<u32>(_e184) & 2147483647u) > 2139095040u) {
                phi_918_ = _e184;
            } else {
                if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                    phi_917_ = 0f;
                } else {
                    if (_e184 < 0f) {
                        phi_916_ = 0f;
                    } else {
                        phi_916_ = 1f;
                    }
                    let _e274 = phi_916_;
                    phi_917_ = _e274;
                }
                let _e276 = phi_917_;
                phi_918_ = _e276;
            }
            let _e278 = phi_918_;
            if ((bitcast<u32>(_e185) & 2147483647u) > 2139095040u) {
                phi_937_ = _e185;
            } else {
                if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                    phi_936_ = 0f;
                } else {
                    if (_e185 < 0f) {
                        phi_935_ = 0f;
                    } else {
                        phi_935_ = 1f;
                    }
                    let _e287 = phi_935_;
                    phi_936_ = _e287;
                }
                let _e289 = phi_936_;
                phi_937_ = _e289;
            }
            let _e291 = phi_937_;
            if ((bitcast<u32>(_e186) & 2147483647u) > 2139095040u) {
                phi_956_ = _e186;
            } else {
                if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                    phi_955_ = 0f;
                } else {
                    if (_e186 < 0f) {
                        phi_954_ = 0f;
                    } else {
                        phi_954_ = 1f;
                    }
                    let _e300 = phi_954_;
                    phi_955_ = _e300;
                }
                let _e302 = phi_955_;
                phi_956_ = _e302;
            }
            let _e304 = phi_956_;
            if ((bitcast<u32>(_e187) & 2147483647u) > 2139095040u) {
                phi_975_ = _e187;
            } else {
                if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                    phi_974_ = 0f;
                } else {
                    if (_e187 < 0f) {
                        phi_973_ = 0f;
                    } else {
                        phi_973_ = 1f;
                    }
                    let _e313 = phi_973_;
                    phi_974_ = _e313;
                }
                let _e315 = phi_974_;
                phi_975_ = _e315;
            }
            let _e317 = phi_975_;
            let _e328 = ((((_e278 * param_5.x) + (_e291 * param_5.y)) + (_e304 * param_5.z)) + (_e317 * param_5.w));
            if ((bitcast<u32>(_e328) & 2147483647u) > 2139095040u) {
                phi_1003_ = _e328;
            } else {
                if (_e328 < 0f) {
                    phi_1002_ = 0f;
                } else {
                    if (_e328 > 1f) {
                        phi_1001_ = 1f;
                    } else {
                        phi_1001_ = _e328;
                    }
                    let _e335 = phi_1001_;
                    phi_1002_ = _e335;
                }
                let _e337 = phi_1002_;
                phi_1003_ = _e337;
            }
            let _e339 = phi_1003_;
            phi_1004_ = _e339;
        }
        let _e341 = phi_1004_;
        phi_1005_ = _e341;
    }
    let _e343 = phi_1005_;
    if _e265 {
        phi_1014_ = bool();
        phi_1015_ = true;
    } else {
        if _e262 {
            phi_1013_ = bool();
        } else {
            phi_1013_ = (_e238 < 0.0000000000000000000000000000000001f);
        }
        let _e346 = phi_1013_;
        phi_1014_ = _e346;
        phi_1015_ = _e262;
    }
    let _e348 = phi_1014_;
    let _e350 = phi_1015_;
    if _e350 {
        phi_1019_ = true;
    } else {
        phi_1019_ = _e348;
    }
    let _e352 = phi_1019_;
    let _e353 = (_e162 >= 0f);
    if _e352 {
        if _e353 {
            if (_e343 < 0.05f) {
                phi_1031_ = false;
            } else {
                phi_1031_ = true;
            }
            let _e356 = phi_1031_;
            phi_1032_ = _e356;
        } else {
            phi_1032_ = true;
        }
        let _e358 = phi_1032_;
        if _e358 {
            phi_1036_ = _e343;
        } else {
            phi_1036_ = 0.05f;
        }
        let _e360 = phi_1036_;
        phi_1232_ = _e360;
    } else {
        let _e362 = ((0.5f * -(((((((_e214 * (_e184 + _e185)) + (_e215 * (_e185 + _e186))) + (_e216 * (_e186 + _e187))) + (_e217 * (_e187 + _e184))) + (_e219 * (_e184 + _e186))) + (_e221 * (_e185 + _e187))))) / _e238);
        let _e363 = ((((((_e214 + _e215) + _e216) + _e217) + _e219) + _e221) / _e238);
        let _e365 = ((_e362 * _e362) - _e363);
        if (_e365 > 0f) {
            phi_1047_ = sqrt(_e365);
        } else {
            phi_1047_ = 0f;
        }
        let _e369 = phi_1047_;
        if (_e362 > 0f) {
            let _e372 = (-(_e362) - _e369);
            phi_1064_ = lt_bvh_slab_Span(_e372, (_e363 / _e372));
        } else {
            let _e375 = (_e369 - _e362);
            if (_e375 > 0f) {
                phi_1062_ = (_e363 / _e375);
            } else {
                phi_1062_ = 0f;
            }
            let _e379 = phi_1062_;
            phi_1064_ = lt_bvh_slab_Span(_e379, _e375);
        }
        let _e382 = phi_1064_;
        if (_e382.near >= 0f) {
            phi_1195_ = 1f;
            phi_1196_ = f32();
            phi_1197_ = true;
        } else {
            let _e386 = (_e382.far <= 0f);
            if _e386 {
                phi_1193_ = (((((((((param_5.x * param_5.y) * param_5.z) * _e192) * _e193) * _e198) + (((((param_5.y * param_5.z) * param_5.w) * _e193) * _e194) * _e201)) + (((((param_5.z * param_5.w) * param_5.x) * _e194) * _e195) * _e198)) + (((((param_5.w * param_5.x) * param_5.y) * _e195) * _e192) * _e201)) / _e238);
                phi_1194_ = f32();
            } else {
                let _e433 = ((((param_5.x * _e184) + (param_5.y * _e185)) + (param_5.z * _e186)) + (param_5.w * _e187));
                let _e448 = ((((param_5.x * (_e184 * _e184)) + (param_5.y * (_e185 * _e185))) + (param_5.z * (_e186 * _e186))) + (param_5.w * (_e187 * _e187)));
                if (-(_e382.near) <= _e382.far) {
                    phi_1192_ = (1f - (((_e382.near * _e382.near) * ((_e382.far * _e448) - _e433)) / (_e382.far - _e382.near)));
                } else {
                    phi_1192_ = ((((((((((param_5.x * param_5.y) * param_5.z) * _e192) * _e193) * _e198) + (((((param_5.y * param_5.z) * param_5.w) * _e193) * _e194) * _e201)) + (((((param_5.z * param_5.w) * param_5.x) * _e194) * _e195) * _e198)) + (((((param_5.w * param_5.x) * param_5.y) * _e195) * _e192) * _e201)) / _e238) + (((_e382.far * _e382.far) * (_e433 - (_e382.near * _e448))) / (_e382.far - _e382.near)));
                }
                let _e502 = phi_1192_;
                phi_1193_ = f32();
                phi_1194_ = _e502;
            }
            let _e504 = phi_1193_;
            let _e506 = phi_1194_;
            phi_1195_ = _e504;
            phi_1196_ = _e506;
            phi_1197_ = _e386;
        }
        let _e508 = phi_1195_;
        let _e510 = phi_1196_;
        let _e512 = phi_1197_;
        if _e512 {
            phi_1201_ = _e508;
        } else {
            phi_1201_ = _e510;
        }
        let _e514 = phi_1201_;
        if ((bitcast<u32>(_e514) & 2147483647u) > 2139095040u) {
            phi_1218_ = _e514;
        } else {
            if (_e514 < 0f) {
                phi_1217_ = 0f;
            } else {
                if (_e514 > 1f) {
                    phi_1216_ = 1f;
                } else {
                    phi_1216_ = _e514;
                }
                let _e521 = phi_1216_;
                phi_1217_ = _e521;
            }
            let _e523 = phi_1217_;
            phi_1218_ = _e523;
        }
        let _e525 = phi_1218_;
        if _e353 {
            if (_e525 < 0.05f) {
                phi_1226_ = false;
            } else {
                phi_1226_ = true;
            }
            let _e528 = phi_1226_;
            phi_1227_ = _e528;
        } else {
            phi_1227_ = true;
        }
        let _e530 = phi_1227_;
        if _e530 {
            phi_1231_ = _e525;
        } else {
            phi_1231_ = 0.05f;
        }
        let _e532 = phi_1231_;
        phi_1232_ = _e532;
    }
    let _e534 = phi_1232_;
    return _e534;
}

fn function_() {
    var phi_195_: bool;
    var phi_196_: bool;
    var phi_197_: bool;
    var phi_198_: bool;
    var phi_202_: bool;
    var phi_246_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_250_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_327_: bool;
    var phi_336_: bool;
    var phi_345_: bool;
    var phi_346_: bool;
    var phi_347_: bool;
    var phi_348_: bool;
    var phi_349_: bool;
    var phi_350_: bool;
    var phi_351_: bool;
    var phi_355_: bool;
    var phi_391_: f32;
    var phi_396_: f32;
    var phi_397_: bool;
    var phi_398_: f32;
    var phi_399_: bool;
    var phi_403_: f32;
    var phi_423_: f32;
    var phi_428_: f32;
    var phi_429_: bool;
    var phi_430_: f32;
    var phi_431_: bool;
    var phi_435_: f32;
    var phi_481_: i32;
    var phi_486_: i32;
    var phi_491_: i32;
    var phi_496_: i32;
    var phi_505_: i32;
    var phi_510_: i32;
    var phi_515_: i32;
    var phi_520_: i32;
    var phi_561_: evaluate_Verdict;
    var phi_562_: evaluate_Verdict;
    var phi_563_: bool;
    var phi_564_: evaluate_Verdict;
    var phi_565_: evaluate_Verdict;
    var phi_566_: bool;
    var phi_570_: evaluate_Verdict;

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
                phi_195_ = (_e75 == _e77);
                phi_196_ = false;
            } else {
                phi_195_ = bool();
                phi_196_ = true;
            }
            let _e80 = phi_195_;
            let _e82 = phi_196_;
            phi_197_ = _e80;
            phi_198_ = _e82;
        } else {
            phi_197_ = bool();
            phi_198_ = true;
        }
        let _e84 = phi_197_;
        let _e86 = phi_198_;
        if _e86 {
            phi_202_ = false;
        } else {
            phi_202_ = _e84;
        }
        let _e88 = phi_202_;
        if !(_e88) {
            let _e91 = samples.member[(0u + _e53.first_primitive)].normal;
            let _e93 = samples.member[(0u + _e53.first_primitive)].position;
            if ((((_e91.x * (_e62.x - (_e93.x * _e62.w))) + (_e91.y * (_e62.y - (_e93.y * _e62.w)))) + (_e91.z * (_e62.z - (_e93.z * _e62.w)))) > 0f) {
                let _e117 = samples.member[(0u + _e53.first_primitive)].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_246_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_246_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_246_;
            phi_250_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_250_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_250_;
        if _e168.unnamed_1 {
            phi_564_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
            phi_565_ = evaluate_Verdict();
            phi_566_ = true;
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
                    phi_327_ = (_e207 <= 1f);
                } else {
                    phi_327_ = false;
                }
                let _e239 = phi_327_;
                if _e239 {
                    if (_e221 >= 0f) {
                        phi_336_ = (_e221 <= 1f);
                    } else {
                        phi_336_ = false;
                    }
                    let _e243 = phi_336_;
                    if _e243 {
                        if (_e234 >= 0f) {
                            phi_345_ = (_e234 <= 1f);
                        } else {
                            phi_345_ = false;
                        }
                        let _e247 = phi_345_;
                        phi_346_ = _e247;
                        phi_347_ = false;
                    } else {
                        phi_346_ = bool();
                        phi_347_ = true;
                    }
                    let _e249 = phi_346_;
                    let _e251 = phi_347_;
                    phi_348_ = _e249;
                    phi_349_ = _e251;
                } else {
                    phi_348_ = bool();
                    phi_349_ = true;
                }
                let _e253 = phi_348_;
                let _e255 = phi_349_;
                phi_350_ = _e253;
                phi_351_ = _e255;
            } else {
                phi_350_ = bool();
                phi_351_ = true;
            }
            let _e257 = phi_350_;
            let _e259 = phi_351_;
            if _e259 {
                phi_355_ = false;
            } else {
                phi_355_ = _e257;
            }
            let _e261 = phi_355_;
            if _e261 {
                let _e263 = p.member.map_size;
                let _e264 = f32(_e263);
                let _e267 = ((_e207 * _e264) - 0.5f);
                let _e268 = ((_e221 * _e264) - 0.5f);
                if (_e267 > -8388608f) {
                    let _e280 = f32(select(0i, select(select(i32(_e267), i32(-2147483648), (_e267 < bitcast<f32>(3472883712u))), 2147483647i, (_e267 > bitcast<f32>(1325400063u))), (_e267 == _e267)));
                    if (_e280 > _e267) {
                        phi_391_ = 1f;
                    } else {
                        phi_391_ = 0f;
                    }
                    let _e283 = phi_391_;
                    if (_e267 < 8388608f) {
                        phi_396_ = (_e280 - _e283);
                        phi_397_ = false;
                    } else {
                        phi_396_ = f32();
                        phi_397_ = true;
                    }
                    let _e286 = phi_396_;
                    let _e288 = phi_397_;
                    phi_398_ = _e286;
                    phi_399_ = _e288;
                } else {
                    phi_398_ = f32();
                    phi_399_ = true;
                }
                let _e290 = phi_398_;
                let _e292 = phi_399_;
                if _e292 {
                    phi_403_ = _e267;
                } else {
                    phi_403_ = _e290;
                }
                let _e294 = phi_403_;
                if (_e268 > -8388608f) {
                    let _e306 = f32(select(0i, select(select(i32(_e268), i32(-2147483648), (_e268 < bitcast<f32>(3472883712u))), 2147483647i, (_e268 > bitcast<f32>(1325400063u))), (_e268 == _e268)));
                    if (_e306 > _e268) {
                        phi_423_ = 1f;
                    } else {
                        phi_423_ = 0f;
                    }
                    let _e309 = phi_423_;
                    if (_e268 < 8388608f) {
                        phi_428_ = (_e306 - _e309);
                        phi_429_ = false;
                    } else {
                        phi_428_ = f32();
                        phi_429_ = true;
                    }
                    let _e312 = phi_428_;
                    let _e314 = phi_429_;
                    phi_430_ = _e312;
                    phi_431_ = _e314;
                } else {
                    phi_430_ = f32();
                    phi_431_ = true;
                }
                let _e316 = phi_430_;
                let _e318 = phi_431_;
                if _e318 {
                    phi_435_ = _e268;
                } else {
                    phi_435_ = _e316;
                }
                let _e320 = phi_435_;
                let _e321 = (_e267 - _e294);
                let _e322 = (_e268 - _e320);
                let _e331 = select(0i, select(select(i32(_e294), i32(-2147483648), (_e294 < bitcast<f32>(3472883712u))), 2147483647i, (_e294 > bitcast<f32>(1325400063u))), (_e294 == _e294));
                let _e340 = select(0i, select(select(i32(_e320), i32(-2147483648), (_e320 < bitcast<f32>(3472883712u))), 2147483647i, (_e320 > bitcast<f32>(1325400063u))), (_e320 == _e320));
                let _e351 = p.member.test;
                let _e352 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e351);
                let _e354 = p.member.map_size;
                let _e356 = (bitcast<i32>(_e354) - 1i);
                if (_e331 > 0i) {
                    phi_481_ = _e331;
                } else {
                    phi_481_ = 0i;
                }
                let _e359 = phi_481_;
                if (_e340 > 0i) {
                    phi_486_ = _e340;
                } else {
                    phi_486_ = 0i;
                }
                let _e362 = phi_486_;
                if (_e359 < _e356) {
                    phi_491_ = _e359;
                } else {
                    phi_491_ = _e356;
                }
                let _e365 = phi_491_;
                if (_e362 < _e356) {
                    phi_496_ = _e362;
                } else {
                    phi_496_ = _e356;
                }
                let _e368 = phi_496_;
                let _e369 = bitcast<u32>(_e365);
                let _e371 = (_e331 + 1i);
                let _e372 = (_e340 + 1i);
                if (_e371 > 0i) {
                    phi_505_ = _e371;
                } else {
                    phi_505_ = 0i;
                }
                let _e375 = phi_505_;
                if (_e372 > 0i) {
                    phi_510_ = _e372;
                } else {
                    phi_510_ = 0i;
                }
                let _e378 = phi_510_;
                if (_e375 < _e356) {
                    phi_515_ = _e375;
                } else {
                    phi_515_ = _e356;
                }
                let _e381 = phi_515_;
                if (_e378 < _e356) {
                    phi_520_ = _e378;
                } else {
                    phi_520_ = _e356;
                }
                let _e384 = phi_520_;
                let _e385 = bitcast<u32>(_e381);
                let _e387 = (bitcast<u32>(_e368) * _e354);
                let _e388 = (bitcast<u32>(_e384) * _e354);
                let _e389 = (_e387 + _e369);
                let _e390 = (_e387 + _e385);
                let _e391 = (_e388 + _e369);
                let _e392 = (_e388 + _e385);
                if (_e389 < _e44) {
                } else {
                    return;
                }
                let _e396 = map.member[(0u + _e389)];
                if (_e390 < _e44) {
                } else {
                    return;
                }
                let _e400 = map.member[(0u + _e390)];
                if (_e391 < _e44) {
                } else {
                    return;
                }
                let _e404 = map.member[(0u + _e391)];
                if (_e392 < _e44) {
                } else {
                    return;
                }
                let _e408 = map.member[(0u + _e392)];
                let _e410 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(vec4<f32>(_e396, _e400, _e404, _e408), vec4<f32>(((1f - _e321) * (1f - _e322)), (_e321 * (1f - _e322)), ((1f - _e321) * _e322), (_e321 * _e322)), _e234);
                phi_561_ = evaluate_Verdict(_e410, false);
                phi_562_ = evaluate_Verdict();
                phi_563_ = false;
            } else {
                phi_561_ = evaluate_Verdict();
                phi_562_ = evaluate_Verdict(1f, false);
                phi_563_ = true;
            }
            let _e414 = phi_561_;
            let _e416 = phi_562_;
            let _e418 = phi_563_;
            phi_564_ = _e416;
            phi_565_ = _e414;
            phi_566_ = _e418;
        }
        let _e420 = phi_564_;
        let _e422 = phi_565_;
        let _e424 = phi_566_;
        if _e424 {
            phi_570_ = _e420;
        } else {
            phi_570_ = _e422;
        }
        let _e426 = phi_570_;
        if (_e53.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e53.first_primitive)] = _e426.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
