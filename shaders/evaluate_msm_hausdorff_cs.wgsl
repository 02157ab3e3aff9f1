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
        let _e53 = phi_131_;
        let _e55 = phi_132_;
        phi_133_ = _e53;
        phi_134_ = _e55;
    } else {
        phi_133_ = lt_bvh_traverse_Tree();
        phi_134_ = true;
    }
    let _e57 = phi_133_;
    let _e59 = phi_134_;
    if _e59 {
        phi_139_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_139_ = _e57;
    }
    let _e64 = phi_139_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: vec4<f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_599_: f32;
    var phi_600_: f32;
    var phi_601_: f32;
    var phi_618_: f32;
    var phi_619_: f32;
    var phi_620_: f32;
    var phi_636_: f32;
    var phi_637_: f32;
    var phi_638_: f32;
    var phi_654_: f32;
    var phi_655_: f32;
    var phi_656_: f32;
    var phi_672_: f32;
    var phi_673_: f32;
    var phi_674_: f32;
    var phi_689_: bool;
    var phi_693_: f32;
    var phi_704_: bool;
    var phi_708_: f32;
    var phi_719_: bool;
    var phi_723_: f32;
    var phi_734_: bool;
    var phi_738_: f32;
    var phi_749_: bool;
    var phi_753_: f32;
    var phi_764_: bool;
    var phi_768_: f32;
    var phi_791_: bool;
    var phi_795_: f32;
    var phi_806_: bool;
    var phi_810_: f32;
    var phi_919_: f32;
    var phi_920_: f32;
    var phi_921_: f32;
    var phi_938_: f32;
    var phi_939_: f32;
    var phi_940_: f32;
    var phi_957_: f32;
    var phi_958_: f32;
    var phi_959_: f32;
    var phi_976_: f32;
    var phi_977_: f32;
    var phi_978_: f32;
    var phi_1004_: f32;
    var phi_1005_: f32;
    var phi_1006_: f32;
    var phi_1007_: f32;
    var phi_1008_: f32;
    var phi_1020_: bool;
    var phi_1021_: bool;
    var phi_1022_: bool;
    var phi_1026_: bool;
    var phi_1038_: bool;
    var phi_1039_: bool;
    var phi_1043_: f32;
    var phi_1054_: f32;
    var phi_1069_: f32;
    var phi_1071_: lt_bvh_slab_Span;
    var phi_1199_: f32;
    var phi_1200_: f32;
    var phi_1201_: f32;
    var phi_1202_: f32;
    var phi_1203_: f32;
    var phi_1204_: bool;
    var phi_1208_: f32;
    var phi_1218_: bool;
    var phi_1231_: bool;
    var phi_1240_: bool;
    var phi_1245_: bool;
    var phi_1246_: bool;
    var phi_1247_: bool;
    var phi_1248_: bool;
    var phi_1255_: bool;
    var phi_1256_: bool;
    var phi_1257_: bool;
    var phi_1258_: bool;
    var phi_1259_: bool;
    var phi_1263_: bool;
    var phi_1328_: f32;
    var phi_1329_: f32;
    var phi_1330_: f32;
    var phi_1347_: f32;
    var phi_1348_: f32;
    var phi_1349_: f32;
    var phi_1366_: f32;
    var phi_1367_: f32;
    var phi_1368_: f32;
    var phi_1385_: f32;
    var phi_1386_: f32;
    var phi_1387_: f32;
    var phi_1477_: f32;
    var phi_1478_: f32;
    var phi_1489_: bool;
    var phi_1493_: f32;
    var phi_1494_: f32;
    var phi_1495_: f32;
    var phi_1496_: bool;
    var phi_1500_: f32;
    var phi_1515_: f32;
    var phi_1516_: f32;
    var phi_1517_: f32;
    var phi_1525_: bool;
    var phi_1526_: bool;
    var phi_1530_: f32;
    var phi_1531_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_601_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_600_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_599_ = 1f;
            } else {
                phi_599_ = param_6;
            }
            let _e49 = phi_599_;
            phi_600_ = _e49;
        }
        let _e51 = phi_600_;
        phi_601_ = _e51;
    }
    let _e53 = phi_601_;
    let _e54 = (_e53 - 0.00000047683716f);
    if ((bitcast<u32>(param_4.x) & 2147483647u) > 2139095040u) {
        phi_620_ = param_4.x;
    } else {
        if (param_4.x < 0f) {
            phi_619_ = 0f;
        } else {
            if (param_4.x > 1f) {
                phi_618_ = 1f;
            } else {
                phi_618_ = param_4.x;
            }
            let _e62 = phi_618_;
            phi_619_ = _e62;
        }
        let _e64 = phi_619_;
        phi_620_ = _e64;
    }
    let _e66 = phi_620_;
    if ((bitcast<u32>(param_4.y) & 2147483647u) > 2139095040u) {
        phi_638_ = param_4.y;
    } else {
        if (param_4.y < 0f) {
            phi_637_ = 0f;
        } else {
            if (param_4.y > 1f) {
                phi_636_ = 1f;
            } else {
                phi_636_ = param_4.y;
            }
            let _e74 = phi_636_;
            phi_637_ = _e74;
        }
        let _e76 = phi_637_;
        phi_638_ = _e76;
    }
    let _e78 = phi_638_;
    if ((bitcast<u32>(param_4.z) & 2147483647u) > 2139095040u) {
        phi_656_ = param_4.z;
    } else {
        if (param_4.z < 0f) {
            phi_655_ = 0f;
        } else {
            if (param_4.z > 1f) {
                phi_654_ = 1f;
            } else {
                phi_654_ = param_4.z;
            }
            let _e86 = phi_654_;
            phi_655_ = _e86;
        }
        let _e88 = phi_655_;
        phi_656_ = _e88;
    }
    let _e90 = phi_656_;
    if ((bitcast<u32>(param_4.w) & 2147483647u) > 2139095040u) {
        phi_674_ = param_4.w;
    } else {
        if (param_4.w < 0f) {
            phi_673_ = 0f;
        } else {
            if (param_4.w > 1f) {
                phi_672_ = 1f;
            } else {
                phi_672_ = param_4.w;
            }
            let _e98 = phi_672_;
            phi_673_ = _e98;
        }
        let _e100 = phi_673_;
        phi_674_ = _e100;
    }
    let _e102 = phi_674_;
    let _e103 = (_e66 - _e54);
    let _e104 = (_e78 - _e54);
    let _e105 = (_e90 - _e54);
    let _e106 = (_e102 - _e54);
    if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
        phi_689_ = true;
    } else {
        let _e110 = (_e104 < _e103);
        if _e110 {
        }
        phi_689_ = _e110;
    }
    let _e112 = phi_689_;
    if _e112 {
        phi_693_ = _e104;
    } else {
        phi_693_ = _e103;
    }
    let _e114 = phi_693_;
    if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
        phi_704_ = true;
    } else {
        let _e118 = (_e106 < _e105);
        if _e118 {
        }
        phi_704_ = _e118;
    }
    let _e120 = phi_704_;
    if _e120 {
        phi_708_ = _e106;
    } else {
        phi_708_ = _e105;
    }
    let _e122 = phi_708_;
    if ((bitcast<u32>(_e122) & 2147483647u) > 2139095040u) {
        phi_719_ = true;
    } else {
        let _e126 = (_e122 < _e114);
        if _e126 {
        }
        phi_719_ = _e126;
    }
    let _e128 = phi_719_;
    if _e128 {
        phi_723_ = _e122;
    } else {
        phi_723_ = _e114;
    }
    let _e130 = phi_723_;
    if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
        phi_734_ = true;
    } else {
        let _e134 = (_e104 > _e103);
        if _e134 {
        }
        phi_734_ = _e134;
    }
    let _e136 = phi_734_;
    if _e136 {
        phi_738_ = _e104;
    } else {
        phi_738_ = _e103;
    }
    let _e138 = phi_738_;
    if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
        phi_749_ = true;
    } else {
        let _e142 = (_e106 > _e105);
        if _e142 {
        }
        phi_749_ = _e142;
    }
    let _e144 = phi_749_;
    if _e144 {
        phi_753_ = _e106;
    } else {
        phi_753_ = _e105;
    }
    let _e146 = phi_753_;
    if ((bitcast<u32>(_e146) & 2147483647u) > 2139095040u) {
        phi_764_ = true;
    } else {
        let _e150 = (_e146 > _e138);
        if _e150 {
        }
        phi_764_ = _e150;
    }
    let _e152 = phi_764_;
    if _e152 {
        phi_768_ = _e146;
    } else {
        phi_768_ = _e138;
    }
    let _e154 = phi_768_;
    let _e165 = ((((_e103 * param_5.x) + (_e104 * param_5.y)) + (_e105 * param_5.z)) + (_e106 * param_5.w));
    let _e166 = -(_e130);
    if ((bitcast<u32>(_e154) & 2147483647u) > 2139095040u) {
        phi_791_ = true;
    } else {
        let _e170 = (_e154 > _e166);
        if _e170 {
        }
        phi_791_ = _e170;
    }
    let _e172 = phi_791_;
    if _e172 {
        phi_795_ = _e154;
    } else {
        phi_795_ = _e166;
    }
    let _e174 = phi_795_;
    if ((bitcast<u32>(0.0000009536743f) & 2147483647u) > 2139095040u) {
        phi_806_ = true;
    } else {
        let _e178 = (0.0000009536743f > _e174);
        if _e178 {
        }
        phi_806_ = _e178;
    }
    let _e180 = phi_806_;
    if _e180 {
        phi_810_ = 0.0000009536743f;
    } else {
        phi_810_ = _e174;
    }
    let _e182 = phi_810_;
    let _e186 = bitcast<f32>((2130706432u - (bitcast<u32>(_e182) & 2139095040u)));
    let _e187 = (_e103 * _e186);
    let _e188 = (_e104 * _e186);
    let _e189 = (_e105 * _e186);
    let _e190 = (_e106 * _e186);
    let _e191 = (_e187 - _e188);
    let _e192 = (_e188 - _e189);
    let _e193 = (_e189 - _e190);
    let _e194 = (_e190 - _e187);
    let _e195 = (_e191 * _e191);
    let _e196 = (_e192 * _e192);
    let _e197 = (_e193 * _e193);
    let _e198 = (_e194 * _e194);
    let _e201 = ((_e187 - _e189) * (_e187 - _e189));
    let _e204 = ((_e188 - _e190) * (_e188 - _e190));
    let _e206 = (param_5.x * _e187);
    let _e208 = (param_5.y * _e188);
    let _e210 = (param_5.z * _e189);
    let _e212 = (param_5.w * _e190);
    let _e217 = ((_e206 * _e208) * _e195);
    let _e218 = ((_e208 * _e210) * _e196);
    let _e219 = ((_e210 * _e212) * _e197);
    let _e220 = ((_e212 * _e206) * _e198);
    let _e222 = ((_e206 * _e210) * _e201);
    let _e224 = ((_e208 * _e212) * _e204);
    let _e241 = ((((((_e217 * (_e187 * _e188)) + (_e218 * (_e188 * _e189))) + (_e219 * (_e189 * _e190))) + (_e220 * (_e190 * _e187))) + (_e222 * (_e187 * _e189))) + (_e224 * (_e188 * _e190)));
    let _e265 = (_e130 >= 0f);
    let _e268 = ((bitcast<u32>(_e165) & 2147483647u) > 2139095040u);
    if _e268 {
        phi_1008_ = _e165;
    } else {
        if _e265 {
            phi_1007_ = 1f;
        } else {
            if ((bitcast<u32>(_e187) & 2147483647u) > 2139095040u) {
                phi_921_ = _e187;
            } else {
                if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                    phi_920_ = 0f;
                } else {
                    if (_e187 < 0f) {
                        phi_919_ = 0f;
                    } else {
                        phi_919_ = 1f;
                    }
                    let _e277 = phi_919_;
                    phi_920_ = _e277;
                }
                let _e279 = phi_920_;
                phi_921_ = _e279;
            }
            let _e281 = phi_921_;
            if ((bitcast<u32>(_e188) & 2147483647u) > 2139095040u) {
                phi_940_ = _e188;
            } else {
                if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                    phi_939_ = 0f;
                } else {
                    if (_e188 < 0f) {
                        phi_938_ = 0f;
                    } else {
                        phi_938_ = 1f;
                    }
                    let _e290 = phi_938_;
                    phi_939_ = _e290;
                }
                let _e292 = phi_939_;
                phi_940_ = _e292;
            }
            let _e294 = phi_940_;
            if ((bitcast<u32>(_e189) & 2147483647u) > 2139095040u) {
                phi_959_ = _e189;
            } else {
                if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                    phi_958_ = 0f;
                } else {
                    if (_e189 < 0f) {
                        phi_957_ = 0f;
                    } else {
                        phi_957_ = 1f;
                    }
                    let _e303 = phi_957_;
                    phi_958_ = _e303;
                }
                let _e305 = phi_958_;
                phi_959_ = _e305;
            }
            let _e307 = phi_959_;
            if ((bitcast<u32>(_e190) & 2147483647u) > 2139095040u) {
                phi_978_ = _e190;
            } else {
                if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                    phi_977_ = 0f;
                } else {
                    if (_e190 < 0f) {
                        phi_976_ = 0f;
                    } else {
                        phi_976_ = 1f;
                    }
                    let _e316 = phi_976_;
                    phi_977_ = _e316;
                }
                let _e318 = phi_977_;
                phi_978_ = _e318;
            }
            let _e320 = phi_978_;
            let _e331 = ((((_e281 * param_5.x) + (_e294 * param_5.y)) + (_e307 * param_5.z)) + (_e320 * param_5.w));
            if ((bitcast<u32>(_e331) & 2147483647u) > 2139095040u) {
                phi_1006_ = _e331;
            } else {
                if (_e331 < 0f) {
                    phi_1005_ = 0f;
                } else {
                    if (_e331 > 1f) {
                        phi_1004_ = 1f;
                    } else {
                        phi_1004_ = _e331;
                    }
                    let _e338 = phi_1004_;
                    phi_1005_ = _e338;
                }
                let _e340 = phi_1005_;
                phi_1006_ = _e340;
            }
            let _e342 = phi_1006_;
            phi_1007_ = _e342;
        }
        let _e344 = phi_1007_;
        phi_1008_ = _e344;
    }
    let _e346 = phi_1008_;
    let _e348 = (-(_e54) * _e186);
    let _e350 = ((1f - _e54) * _e186);
    if _e268 {
        phi_1021_ = bool();
        phi_1022_ = true;
    } else {
        if _e265 {
            phi_1020_ = bool();
        } else {
            phi_1020_ = (_e241 < 0.0000000000000000000000000000000001f);
        }
        let _e353 = phi_1020_;
        phi_1021_ = _e353;
        phi_1022_ = _e265;
    }
    let _e355 = phi_1021_;
    let _e357 = phi_1022_;
    if _e357 {
        phi_1026_ = true;
    } else {
        phi_1026_ = _e355;
    }
    let _e359 = phi_1026_;
    let _e360 = (_e165 >= 0f);
    if _e359 {
        if _e360 {
            if (_e346 < 0.05f) {
                phi_1038_ = false;
            } else {
                phi_1038_ = true;
            }
            let _e363 = phi_1038_;
            phi_1039_ = _e363;
        } else {
            phi_1039_ = true;
        }
        let _e365 = phi_1039_;
        if _e365 {
            phi_1043_ = _e346;
        } else {
            phi_1043_ = 0.05f;
        }
        let _e367 = phi_1043_;
        phi_1531_ = _e367;
    } else {
        let _e369 = ((0.5f * -(((((((_e217 * (_e187 + _e188)) + (_e218 * (_e188 + _e189))) + (_e219 * (_e189 + _e190))) + (_e220 * (_e190 + _e187))) + (_e222 * (_e187 + _e189))) + (_e224 * (_e188 + _e190))))) / _e241);
        let _e370 = ((((((_e217 + _e218) + _e219) + _e220) + _e222) + _e224) / _e241);
        let _e372 = ((_e369 * _e369) - _e370);
        if (_e372 > 0f) {
            phi_1054_ = sqrt(_e372);
        } else {
            phi_1054_ = 0f;
        }
        let _e376 = phi_1054_;
        if (_e369 > 0f) {
            let _e379 = (-(_e369) - _e376);
            phi_1071_ = lt_bvh_slab_Span(_e379, (_e370 / _e379));
        } else {
            let _e382 = (_e376 - _e369);
            if (_e382 > 0f) {
                phi_1069_ = (_e370 / _e382);
            } else {
                phi_1069_ = 0f;
            }
            let _e386 = phi_1069_;
            phi_1071_ = lt_bvh_slab_Span(_e386, _e382);
        }
        let _e389 = phi_1071_;
        if (_e389.near >= 0f) {
            phi_1202_ = 1f;
            phi_1203_ = f32();
            phi_1204_ = true;
        } else {
            let _e393 = (_e389.far <= 0f);
            if _e393 {
                phi_1200_ = (((((((((param_5.x * param_5.y) * param_5.z) * _e195) * _e196) * _e201) + (((((param_5.y * param_5.z) * param_5.w) * _e196) * _e197) * _e204)) + (((((param_5.z * param_5.w) * param_5.x) * _e197) * _e198) * _e201)) + (((((param_5.w * param_5.x) * param_5.y) * _e198) * _e195) * _e204)) / _e241);
                phi_1201_ = f32();
            } else {
                let _e440 = ((((param_5.x * _e187) + (param_5.y * _e188)) + (param_5.z * _e189)) + (param_5.w * _e190));
                let _e455 = ((((param_5.x * (_e187 * _e187)) + (param_5.y * (_e188 * _e188))) + (param_5.z * (_e189 * _e189))) + (param_5.w * (_e190 * _e190)));
                if (-(_e389.near) <= _e389.far) {
                    phi_1199_ = (1f - (((_e389.near * _e389.near) * ((_e389.far * _e455) - _e440)) / (_e389.far - _e389.near)));
                } else {
                    phi_1199_ = ((((((((((param_5.x * param_5.y) * param_5.z) * _e195) * _e196) * _e201) + (((((param_5.y * param_5.z) * param_5.w) * _e196) * _e197) * _e204)) + (((((param_5.z * param_5.w) * param_5.x) * _e197) * _e198) * _e201)) + (((((param_5.w * param_5.x) * param_5.y) * _e198) * _e195) * _e204)) / _e241) + (((_e389.far * _e389.far) * (_e440 - (_e389.near * _e455))) / (_e389.far - _e389.near)));
                }
                let _e509 = phi_1199_;
                phi_1200_ = f32();
                phi_1201_ = _e509;
            }
            let _e511 = phi_1200_;
            let _e513 = phi_1201_;
            phi_1202_ = _e511;
            phi_1203_ = _e513;
            phi_1204_ = _e393;
        }
        let _e515 = phi_1202_;
        let _e517 = phi_1203_;
        let _e519 = phi_1204_;
        if _e519 {
            phi_1208_ = _e515;
        } else {
            phi_1208_ = _e517;
        }
        let _e521 = phi_1208_;
        if ((_e389.near * _e348) >= (1f - 0.00001f)) {
            phi_1218_ = true;
        } else {
            phi_1218_ = ((_e389.near * _e350) >= (1f - 0.00001f));
        }
        let _e529 = phi_1218_;
        if _e529 {
            if ((_e389.far * _e348) >= (1f - 0.00001f)) {
                phi_1231_ = true;
            } else {
                phi_1231_ = ((_e389.far * _e350) >= (1f - 0.00001f));
            }
            let _e537 = phi_1231_;
            if (-(_e348) < 0.0001f) {
                if _e537 {
                    phi_1240_ = false;
                } else {
                    phi_1240_ = true;
                }
                let _e541 = phi_1240_;
                phi_1246_ = bool();
                phi_1247_ = _e541;
                phi_1248_ = false;
            } else {
                if _e537 {
                    phi_1245_ = false;
                } else {
                    phi_1245_ = true;
                }
                let _e544 = phi_1245_;
                phi_1246_ = (_e350 < 0.0001f);
                phi_1247_ = false;
                phi_1248_ = _e544;
            }
            let _e546 = phi_1246_;
            let _e548 = phi_1247_;
            let _e550 = phi_1248_;
            phi_1257_ = _e546;
            phi_1258_ = _e548;
            phi_1259_ = _e550;
        } else {
            let _e552 = (-(_e348) < 0.0001f);
            if _e552 {
                phi_1255_ = bool();
                phi_1256_ = false;
            } else {
                phi_1255_ = (_e350 < 0.0001f);
                phi_1256_ = true;
            }
            let _e555 = phi_1255_;
            let _e557 = phi_1256_;
            phi_1257_ = _e555;
            phi_1258_ = _e552;
            phi_1259_ = _e557;
        }
        let _e559 = phi_1257_;
        let _e561 = phi_1258_;
        let _e563 = phi_1259_;
        if _e561 {
            phi_1263_ = false;
        } else {
            phi_1263_ = _e563;
        }
        let _e565 = phi_1263_;
        if _e565 {
            if _e559 {
                phi_1494_ = f32();
            } else {
                let _e566 = (_e187 - _e348);
                let _e567 = (_e188 - _e348);
                let _e568 = (_e189 - _e348);
                let _e569 = (_e190 - _e348);
                let _e570 = (_e350 - _e187);
                let _e571 = (_e350 - _e188);
                let _e572 = (_e350 - _e189);
                let _e573 = (_e350 - _e190);
                let _e582 = ((param_5.x * _e566) * _e570);
                let _e583 = ((param_5.y * _e567) * _e571);
                let _e584 = ((param_5.z * _e568) * _e572);
                let _e585 = ((param_5.w * _e569) * _e573);
                let _e603 = ((((_e582 * (_e187 * _e187)) + (_e583 * (_e188 * _e188))) + (_e584 * (_e189 * _e189))) + (_e585 * (_e190 * _e190)));
                if (_e603 < 0.0000000000000000000000000000000001f) {
                    if ((bitcast<u32>(_e187) & 2147483647u) > 2139095040u) {
                        phi_1330_ = _e187;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_1329_ = 0f;
                        } else {
                            if (_e187 < 0f) {
                                phi_1328_ = 0f;
                            } else {
                                phi_1328_ = 1f;
                            }
                            let _e613 = phi_1328_;
                            phi_1329_ = _e613;
                        }
                        let _e615 = phi_1329_;
                        phi_1330_ = _e615;
                    }
                    let _e617 = phi_1330_;
                    if ((bitcast<u32>(_e188) & 2147483647u) > 2139095040u) {
                        phi_1349_ = _e188;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_1348_ = 0f;
                        } else {
                            if (_e188 < 0f) {
                                phi_1347_ = 0f;
                            } else {
                                phi_1347_ = 1f;
                            }
                            let _e626 = phi_1347_;
                            phi_1348_ = _e626;
                        }
                        let _e628 = phi_1348_;
                        phi_1349_ = _e628;
                    }
                    let _e630 = phi_1349_;
                    if ((bitcast<u32>(_e189) & 2147483647u) > 2139095040u) {
                        phi_1368_ = _e189;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_1367_ = 0f;
                        } else {
                            if (_e189 < 0f) {
                                phi_1366_ = 0f;
                            } else {
                                phi_1366_ = 1f;
                            }
                            let _e639 = phi_1366_;
                            phi_1367_ = _e639;
                        }
                        let _e641 = phi_1367_;
                        phi_1368_ = _e641;
                    }
                    let _e643 = phi_1368_;
                    if ((bitcast<u32>(_e190) & 2147483647u) > 2139095040u) {
                        phi_1387_ = _e190;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_1386_ = 0f;
                        } else {
                            if (_e190 < 0f) {
                                phi_1385_ = 0f;
                            } else {
                                phi_1385_ = 1f;
                            }
                            let _e652 = phi_1385_;
                            phi_1386_ = _e652;
                        }
                        let _e654 = phi_1386_;
                        phi_1387_ = _e654;
                    }
                    let _e656 = phi_1387_;
                    phi_1478_ = ((((_e617 * param_5.x) + (_e630 * param_5.y)) + (_e643 * param_5.z)) + (_e656 * param_5.w));
                } else {
                    let _e668 = (((((_e582 * _e187) + (_e583 * _e188)) + (_e584 * _e189)) + (_e585 * _e190)) / _e603);
                    let _e689 = ((param_5.x * _e187) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e668 * _e187)));
                    let _e690 = ((param_5.y * _e188) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e668 * _e188)));
                    let _e691 = ((param_5.z * _e189) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e668 * _e189)));
                    let _e692 = ((param_5.w * _e190) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e668 * _e190)));
                    if (_e668 > 0f) {
                        phi_1477_ = (1f - (((((_e689 * _e570) + (_e690 * _e571)) + (_e691 * _e572)) + (_e692 * _e573)) / ((_e348 * ((_e348 * _e668) - 1f)) * (_e348 - _e350))));
                    } else {
                        phi_1477_ = (((((((((_e582 * _e583) * _e195) + ((_e583 * _e584) * _e196)) + ((_e584 * _e585) * _e197)) + ((_e585 * _e582) * _e198)) + ((_e582 * _e584) * _e201)) + ((_e583 * _e585) * _e204)) / (_e603 * (-(_e348) * _e350))) + (((((_e689 * _e566) + (_e690 * _e567)) + (_e691 * _e568)) + (_e692 * _e569)) / ((_e350 * (1f - (_e668 * _e350))) * (_e350 - _e348))));
                    }
                    let _e744 = phi_1477_;
                    phi_1478_ = _e744;
                }
                let _e746 = phi_1478_;
                if ((bitcast<u32>(_e521) & 2147483647u) > 2139095040u) {
                    phi_1489_ = true;
                } else {
                    let _e750 = (_e521 < _e746);
                    if _e750 {
                    }
                    phi_1489_ = _e750;
                }
                let _e752 = phi_1489_;
                if _e752 {
                    phi_1493_ = _e521;
                } else {
                    phi_1493_ = _e746;
                }
                let _e754 = phi_1493_;
                phi_1494_ = _e754;
            }
            let _e756 = phi_1494_;
            phi_1495_ = _e756;
            phi_1496_ = _e559;
        } else {
            phi_1495_ = f32();
            phi_1496_ = true;
        }
        let _e758 = phi_1495_;
        let _e760 = phi_1496_;
        if _e760 {
            phi_1500_ = _e521;
        } else {
            phi_1500_ = _e758;
        }
        let _e762 = phi_1500_;
        if ((bitcast<u32>(_e762) & 2147483647u) > 2139095040u) {
            phi_1517_ = _e762;
        } else {
            if (_e762 < 0f) {
                phi_1516_ = 0f;
            } else {
                if (_e762 > 1f) {
                    phi_1515_ = 1f;
                } else {
                    phi_1515_ = _e762;
                }
                let _e769 = phi_1515_;
                phi_1516_ = _e769;
            }
            let _e771 = phi_1516_;
            phi_1517_ = _e771;
        }
        let _e773 = phi_1517_;
        if _e360 {
            if (_e773 < 0.05f) {
                phi_1525_ = false;
            } else {
                phi_1525_ = true;
            }
            let _e776 = phi_1525_;
            phi_1526_ = _e776;
        } else {
            phi_1526_ = true;
        }
        let _e778 = phi_1526_;
        if _e778 {
            phi_1530_ = _e773;
        } else {
            phi_1530_ = 0.05f;
        }
        let _e780 = phi_1530_;
        phi_1531_ = _e780;
    }
    let _e782 = phi_1531_;
    return _e782;
}

fn function_() {
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
    var phi_394_: f32;
    var phi_399_: f32;
    var phi_400_: bool;
    var phi_401_: f32;
    var phi_402_: bool;
    var phi_406_: f32;
    var phi_426_: f32;
    var phi_431_: f32;
    var phi_432_: bool;
    var phi_433_: f32;
    var phi_434_: bool;
    var phi_438_: f32;
    var phi_484_: i32;
    var phi_489_: i32;
    var phi_494_: i32;
    var phi_499_: i32;
    var phi_508_: i32;
    var phi_513_: i32;
    var phi_518_: i32;
    var phi_523_: i32;
    var phi_564_: evaluate_Verdict;
    var phi_565_: evaluate_Verdict;
    var phi_566_: bool;
    var phi_567_: evaluate_Verdict;
    var phi_568_: evaluate_Verdict;
    var phi_569_: bool;
    var phi_573_: evaluate_Verdict;

    let _e40 = id_1;
    let _e47 = arrayLength((&map.member));
    let _e53 = p.member.size[0u];
    let _e55 = p.member.size[1u];
    let _e56 = lt_shaders_entry_pixel_index(_e40, _e53, _e55);
    if (bitcast<i32>(_e56.root) != 0i) {
        if (_e56.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e65 = p.member.light;
        let _e68 = samples.member[(0u + _e56.first_primitive)].normal[0u];
        let _e70 = global[0u];
        if (_e68 == _e70) {
            let _e73 = samples.member[(0u + _e56.first_primitive)].normal[1u];
            let _e75 = global[1u];
            if (_e73 == _e75) {
                let _e78 = samples.member[(0u + _e56.first_primitive)].normal[2u];
                let _e80 = global[2u];
                phi_198_ = (_e78 == _e80);
                phi_199_ = false;
            } else {
                phi_198_ = bool();
                phi_199_ = true;
            }
            let _e83 = phi_198_;
            let _e85 = phi_199_;
            phi_200_ = _e83;
            phi_201_ = _e85;
        } else {
            phi_200_ = bool();
            phi_201_ = true;
        }
        let _e87 = phi_200_;
        let _e89 = phi_201_;
        if _e89 {
            phi_205_ = false;
        } else {
            phi_205_ = _e87;
        }
        let _e91 = phi_205_;
        if !(_e91) {
            let _e94 = samples.member[(0u + _e56.first_primitive)].normal;
            let _e96 = samples.member[(0u + _e56.first_primitive)].position;
            if ((((_e94.x * (_e65.x - (_e96.x * _e65.w))) + (_e94.y * (_e65.y - (_e96.y * _e65.w)))) + (_e94.z * (_e65.z - (_e96.z * _e65.w)))) > 0f) {
                let _e120 = samples.member[(0u + _e56.first_primitive)].flags;
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e134 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e128.unnamed.visibility, false), _e128.unnamed_1);
                phi_249_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e134.unnamed, ((_e120 & 1u) == 0u));
            } else {
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e149 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e143.unnamed.visibility, false), _e143.unnamed_1);
                phi_249_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e149.unnamed, true);
            }
            let _e154 = phi_249_;
            phi_253_ = _e154;
        } else {
            let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e160.unnamed.visibility, false), _e160.unnamed_1);
            phi_253_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e166.unnamed, true);
        }
        let _e171 = phi_253_;
        if _e171.unnamed_1 {
            phi_567_ = evaluate_Verdict(_e171.unnamed.visibility, _e171.unnamed.is_doubted);
            phi_568_ = evaluate_Verdict();
            phi_569_ = true;
        } else {
            let _e179 = samples.member[(0u + _e56.first_primitive)].position;
            let _e185 = p.member.projection.row_w;
            let _e196 = ((((_e185.x * _e179.x) + (_e185.y * _e179.y)) + (_e185.z * _e179.z)) + (_e185.w * 1f));
            let _e198 = p.member.projection.row_x;
            let _e210 = (((((_e198.x * _e179.x) + (_e198.y * _e179.y)) + (_e198.z * _e179.z)) + (_e198.w * 1f)) / _e196);
            let _e212 = p.member.projection.row_y;
            let _e224 = (((((_e212.x * _e179.x) + (_e212.y * _e179.y)) + (_e212.z * _e179.z)) + (_e212.w * 1f)) / _e196);
            let _e226 = p.member.projection.row_z;
            let _e237 = ((((_e226.x * _e179.x) + (_e226.y * _e179.y)) + (_e226.z * _e179.z)) + (_e226.w * 1f));
            if (_e196 > 0f) {
                if (_e210 >= 0f) {
                    phi_330_ = (_e210 <= 1f);
                } else {
                    phi_330_ = false;
                }
                let _e242 = phi_330_;
                if _e242 {
                    if (_e224 >= 0f) {
                        phi_339_ = (_e224 <= 1f);
                    } else {
                        phi_339_ = false;
                    }
                    let _e246 = phi_339_;
                    if _e246 {
                        if (_e237 >= 0f) {
                            phi_348_ = (_e237 <= 1f);
                        } else {
                            phi_348_ = false;
                        }
                        let _e250 = phi_348_;
                        phi_349_ = _e250;
                        phi_350_ = false;
                    } else {
                        phi_349_ = bool();
                        phi_350_ = true;
                    }
                    let _e252 = phi_349_;
                    let _e254 = phi_350_;
                    phi_351_ = _e252;
                    phi_352_ = _e254;
                } else {
                    phi_351_ = bool();
                    phi_352_ = true;
                }
                let _e256 = phi_351_;
                let _e258 = phi_352_;
                phi_353_ = _e256;
                phi_354_ = _e258;
            } else {
                phi_353_ = bool();
                phi_354_ = true;
            }
            let _e260 = phi_353_;
            let _e262 = phi_354_;
            if _e262 {
                phi_358_ = false;
            } else {
                phi_358_ = _e260;
            }
            let _e264 = phi_358_;
            if _e264 {
                let _e266 = p.member.map_size;
                let _e267 = f32(_e266);
                let _e270 = ((_e210 * _e267) - 0.5f);
                let _e271 = ((_e224 * _e267) - 0.5f);
                if (_e270 > -8388608f) {
                    let _e283 = f32(select(0i, select(select(i32(_e270), i32(-2147483648), (_e270 < bitcast<f32>(3472883712u))), 2147483647i, (_e270 > bitcast<f32>(1325400063u))), (_e270 == _e270)));
                    if (_e283 > _e270) {
                        phi_394_ = 1f;
                    } else {
                        phi_394_ = 0f;
                    }
                    let _e286 = phi_394_;
                    if (_e270 < 8388608f) {
                        phi_399_ = (_e283 - _e286);
                        phi_400_ = false;
                    } else {
                        phi_399_ = f32();
                        phi_400_ = true;
                    }
                    let _e289 = phi_399_;
                    let _e291 = phi_400_;
                    phi_401_ = _e289;
                    phi_402_ = _e291;
                } else {
                    phi_401_ = f32();
                    phi_402_ = true;
                }
                let _e293 = phi_401_;
                let _e295 = phi_402_;
                if _e295 {
                    phi_406_ = _e270;
                } else {
                    phi_406_ = _e293;
                }
                let _e297 = phi_406_;
                if (_e271 > -8388608f) {
                    let _e309 = f32(select(0i, select(select(i32(_e271), i32(-2147483648), (_e271 < bitcast<f32>(3472883712u))), 2147483647i, (_e271 > bitcast<f32>(1325400063u))), (_e271 == _e271)));
                    if (_e309 > _e271) {
                        phi_426_ = 1f;
                    } else {
                        phi_426_ = 0f;
                    }
                    let _e312 = phi_426_;
                    if (_e271 < 8388608f) {
                        phi_431_ = (_e309 - _e312);
                        phi_432_ = false;
                    } else {
                        phi_431_ = f32();
                        phi_432_ = true;
                    }
                    let _e315 = phi_431_;
                    let _e317 = phi_432_;
                    phi_433_ = _e315;
                    phi_434_ = _e317;
                } else {
                    phi_433_ = f32();
                    phi_434_ = true;
                }
                let _e319 = phi_433_;
                let _e321 = phi_434_;
                if _e321 {
                    phi_438_ = _e271;
                } else {
                    phi_438_ = _e319;
                }
                let _e323 = phi_438_;
                let _e324 = (_e270 - _e297);
                let _e325 = (_e271 - _e323);
                let _e334 = select(0i, select(select(i32(_e297), i32(-2147483648), (_e297 < bitcast<f32>(3472883712u))), 2147483647i, (_e297 > bitcast<f32>(1325400063u))), (_e297 == _e297));
                let _e343 = select(0i, select(select(i32(_e323), i32(-2147483648), (_e323 < bitcast<f32>(3472883712u))), 2147483647i, (_e323 > bitcast<f32>(1325400063u))), (_e323 == _e323));
                let _e354 = p.member.test;
                let _e355 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e354);
                let _e357 = p.member.map_size;
                let _e359 = (bitcast<i32>(_e357) - 1i);
                if (_e334 > 0i) {
                    phi_484_ = _e334;
                } else {
                    phi_484_ = 0i;
                }
                let _e362 = phi_484_;
                if (_e343 > 0i) {
                    phi_489_ = _e343;
                } else {
                    phi_489_ = 0i;
                }
                let _e365 = phi_489_;
                if (_e362 < _e359) {
                    phi_494_ = _e362;
                } else {
                    phi_494_ = _e359;
                }
                let _e368 = phi_494_;
                if (_e365 < _e359) {
                    phi_499_ = _e365;
                } else {
                    phi_499_ = _e359;
                }
                let _e371 = phi_499_;
                let _e372 = bitcast<u32>(_e368);
                let _e374 = (_e334 + 1i);
                let _e375 = (_e343 + 1i);
                if (_e374 > 0i) {
                    phi_508_ = _e374;
                } else {
                    phi_508_ = 0i;
                }
                let _e378 = phi_508_;
                if (_e375 > 0i) {
                    phi_513_ = _e375;
                } else {
                    phi_513_ = 0i;
                }
                let _e381 = phi_513_;
                if (_e378 < _e359) {
                    phi_518_ = _e378;
                } else {
                    phi_518_ = _e359;
                }
                let _e384 = phi_518_;
                if (_e381 < _e359) {
                    phi_523_ = _e381;
                } else {
                    phi_523_ = _e359;
                }
                let _e387 = phi_523_;
                let _e388 = bitcast<u32>(_e384);
                let _e390 = (bitcast<u32>(_e371) * _e357);
                let _e391 = (bitcast<u32>(_e387) * _e357);
                let _e392 = (_e390 + _e372);
                let _e393 = (_e390 + _e388);
                let _e394 = (_e391 + _e372);
                let _e395 = (_e391 + _e388);
                if (_e392 < _e47) {
                } else {
                    return;
                }
                let _e399 = map.member[(0u + _e392)];
                if (_e393 < _e47) {
                } else {
                    return;
                }
                let _e403 = map.member[(0u + _e393)];
                if (_e394 < _e47) {
                } else {
                    return;
                }
                let _e407 = map.member[(0u + _e394)];
                if (_e395 < _e47) {
                } else {
                    return;
                }
                let _e411 = map.member[(0u + _e395)];
                let _e413 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(vec4<f32>(_e399, _e403, _e407, _e411), vec4<f32>(((1f - _e324) * (1f - _e325)), (_e324 * (1f - _e325)), ((1f - _e324) * _e325), (_e324 * _e325)), _e237);
                phi_564_ = evaluate_Verdict(_e413, false);
                phi_565_ = evaluate_Verdict();
                phi_566_ = false;
            } else {
                phi_564_ = evaluate_Verdict();
                phi_565_ = evaluate_Verdict(1f, false);
                phi_566_ = true;
            }
            let _e417 = phi_564_;
            let _e419 = phi_565_;
            let _e421 = phi_566_;
            phi_567_ = _e419;
            phi_568_ = _e417;
            phi_569_ = _e421;
        }
        let _e423 = phi_567_;
        let _e425 = phi_568_;
        let _e427 = phi_569_;
        if _e427 {
            phi_573_ = _e423;
        } else {
            phi_573_ = _e425;
        }
        let _e429 = phi_573_;
        if (_e56.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e56.first_primitive)] = _e429.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
