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

struct type_20 {
    member: array<abi_Sample>,
}

struct type_24 {
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

struct type_38 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct lt_bvh_slab_Span {
    near: f32,
    far: f32,
}

struct type_45 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_38;
@group(0) @binding(2) 
var<storage> map: type_24;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(4) 
var<storage, read_write> list: type_45;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_156_: lt_bvh_traverse_Tree;
    var phi_157_: bool;
    var phi_158_: lt_bvh_traverse_Tree;
    var phi_159_: bool;
    var phi_164_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_156_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_157_ = false;
        } else {
            phi_156_ = lt_bvh_traverse_Tree();
            phi_157_ = true;
        }
        let _e57 = phi_156_;
        let _e59 = phi_157_;
        phi_158_ = _e57;
        phi_159_ = _e59;
    } else {
        phi_158_ = lt_bvh_traverse_Tree();
        phi_159_ = true;
    }
    let _e61 = phi_158_;
    let _e63 = phi_159_;
    if _e63 {
        phi_164_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_164_ = _e61;
    }
    let _e68 = phi_164_;
    return lt_bvh_traverse_Tree(_e68.root, _e68.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_191_: f32;
    var phi_192_: f32;
    var phi_193_: f32;
    var phi_210_: f32;
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_228_: f32;
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_246_: f32;
    var phi_247_: f32;
    var phi_248_: f32;
    var phi_264_: f32;
    var phi_265_: f32;
    var phi_266_: f32;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_303_: bool;
    var phi_304_: bool;
    var phi_305_: bool;
    var phi_306_: bool;
    var phi_310_: bool;
    var phi_621_: f32;
    var phi_622_: f32;
    var phi_623_: f32;
    var phi_640_: f32;
    var phi_641_: f32;
    var phi_642_: f32;
    var phi_659_: f32;
    var phi_660_: f32;
    var phi_661_: f32;
    var phi_678_: f32;
    var phi_679_: f32;
    var phi_680_: f32;
    var phi_703_: f32;
    var phi_704_: f32;
    var phi_705_: f32;
    var phi_716_: f32;
    var phi_731_: f32;
    var phi_733_: lt_bvh_slab_Span;
    var phi_791_: f32;
    var phi_792_: f32;
    var phi_793_: f32;
    var phi_794_: f32;
    var phi_795_: f32;
    var phi_796_: bool;
    var phi_800_: f32;
    var phi_815_: f32;
    var phi_816_: f32;
    var phi_817_: f32;
    var phi_818_: f32;
    var phi_819_: f32;
    var phi_820_: f32;
    var phi_821_: f32;
    var phi_822_: bool;
    var phi_823_: f32;
    var phi_824_: f32;
    var phi_825_: bool;
    var phi_829_: f32;

    let _e48 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_193_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_192_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_191_ = 1f;
            } else {
                phi_191_ = param_7;
            }
            let _e55 = phi_191_;
            phi_192_ = _e55;
        }
        let _e57 = phi_192_;
        phi_193_ = _e57;
    }
    let _e59 = phi_193_;
    let _e60 = (_e59 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_212_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_211_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_210_ = 1f;
            } else {
                phi_210_ = param_5.x;
            }
            let _e68 = phi_210_;
            phi_211_ = _e68;
        }
        let _e70 = phi_211_;
        phi_212_ = _e70;
    }
    let _e72 = phi_212_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_230_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_229_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_228_ = 1f;
            } else {
                phi_228_ = param_5.y;
            }
            let _e80 = phi_228_;
            phi_229_ = _e80;
        }
        let _e82 = phi_229_;
        phi_230_ = _e82;
    }
    let _e84 = phi_230_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_248_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_247_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_246_ = 1f;
            } else {
                phi_246_ = param_5.z;
            }
            let _e92 = phi_246_;
            phi_247_ = _e92;
        }
        let _e94 = phi_247_;
        phi_248_ = _e94;
    }
    let _e96 = phi_248_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_266_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_265_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_264_ = 1f;
            } else {
                phi_264_ = param_5.w;
            }
            let _e104 = phi_264_;
            phi_265_ = _e104;
        }
        let _e106 = phi_265_;
        phi_266_ = _e106;
    }
    let _e108 = phi_266_;
    let _e109 = (_e72 - _e60);
    let _e110 = (_e84 - _e60);
    let _e111 = (_e96 - _e60);
    let _e112 = (_e108 - _e60);
    let _e123 = ((((_e109 * param_6.x) + (_e110 * param_6.y)) + (_e111 * param_6.z)) + (_e112 * param_6.w));
    if ((bitcast<u32>(_e123) & 2147483647u) > 2139095040u) {
        phi_823_ = _e123;
        phi_824_ = f32();
        phi_825_ = true;
    } else {
        if (_e109 >= 0f) {
            if (_e110 >= 0f) {
                if (_e111 >= 0f) {
                    phi_301_ = (_e112 >= 0f);
                    phi_302_ = false;
                } else {
                    phi_301_ = bool();
                    phi_302_ = true;
                }
                let _e132 = phi_301_;
                let _e134 = phi_302_;
                phi_303_ = _e132;
                phi_304_ = _e134;
            } else {
                phi_303_ = bool();
                phi_304_ = true;
            }
            let _e136 = phi_303_;
            let _e138 = phi_304_;
            phi_305_ = _e136;
            phi_306_ = _e138;
        } else {
            phi_305_ = bool();
            phi_306_ = true;
        }
        let _e140 = phi_305_;
        let _e142 = phi_306_;
        if _e142 {
            phi_310_ = false;
        } else {
            phi_310_ = _e140;
        }
        let _e144 = phi_310_;
        if _e144 {
            phi_820_ = 1f;
            phi_821_ = f32();
            phi_822_ = true;
        } else {
            let _e145 = (0.5f * _e48);
            let _e146 = (1f - _e48);
            let _e148 = (param_6.x * _e146);
            let _e150 = (param_6.y * _e146);
            let _e152 = (param_6.z * _e146);
            let _e154 = (param_6.w * _e146);
            let _e155 = -(_e60);
            let _e156 = (1f - _e60);
            let _e158 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e72);
            let _e160 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e84);
            let _e162 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e96);
            let _e164 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e108);
            let _e165 = (_e109 - _e110);
            let _e166 = (_e110 - _e111);
            let _e167 = (_e111 - _e112);
            let _e168 = (_e112 - _e109);
            let _e169 = (_e165 * _e165);
            let _e170 = (_e166 * _e166);
            let _e171 = (_e167 * _e167);
            let _e172 = (_e168 * _e168);
            let _e173 = (_e109 - _e111);
            let _e174 = (_e110 - _e112);
            let _e175 = (_e111 - _e109);
            let _e176 = (_e112 - _e110);
            let _e177 = (_e173 * _e173);
            let _e178 = (_e174 * _e174);
            let _e179 = (_e175 * _e175);
            let _e180 = (_e176 * _e176);
            let _e185 = ((_e148 * _e150) * _e169);
            let _e186 = ((_e150 * _e152) * _e170);
            let _e187 = ((_e152 * _e154) * _e171);
            let _e188 = ((_e154 * _e148) * _e172);
            let _e197 = (((0.5f * _e148) * _e152) * _e177);
            let _e198 = (((0.5f * _e150) * _e154) * _e178);
            let _e199 = (((0.5f * _e152) * _e148) * _e179);
            let _e200 = (((0.5f * _e154) * _e150) * _e180);
            let _e201 = (_e109 * _e110);
            let _e202 = (_e110 * _e111);
            let _e203 = (_e111 * _e112);
            let _e204 = (_e112 * _e109);
            let _e205 = (_e109 * _e111);
            let _e206 = (_e110 * _e112);
            let _e207 = (_e111 * _e109);
            let _e208 = (_e112 * _e110);
            let _e209 = (_e185 * _e201);
            let _e210 = (_e186 * _e202);
            let _e211 = (_e187 * _e203);
            let _e212 = (_e188 * _e204);
            let _e213 = (_e197 * _e205);
            let _e214 = (_e198 * _e206);
            let _e215 = (_e199 * _e207);
            let _e216 = (_e200 * _e208);
            let _e217 = (_e72 * _e72);
            let _e218 = (_e84 * _e84);
            let _e219 = (_e96 * _e96);
            let _e220 = (_e108 * _e108);
            let _e221 = (_e158 * _e158);
            let _e222 = (_e160 * _e160);
            let _e223 = (_e162 * _e162);
            let _e224 = (_e164 * _e164);
            let _e225 = (_e145 * _e148);
            let _e226 = (_e145 * _e150);
            let _e227 = (_e145 * _e152);
            let _e228 = (_e145 * _e154);
            let _e237 = (((_e225 * _e109) * _e217) * _e155);
            let _e238 = (((_e226 * _e110) * _e218) * _e155);
            let _e239 = (((_e227 * _e111) * _e219) * _e155);
            let _e240 = (((_e228 * _e112) * _e220) * _e155);
            let _e249 = (((_e225 * _e109) * _e221) * _e156);
            let _e250 = (((_e226 * _e110) * _e222) * _e156);
            let _e251 = (((_e227 * _e111) * _e223) * _e156);
            let _e252 = (((_e228 * _e112) * _e224) * _e156);
            let _e420 = (((((((_e185 * _e152) * _e170) * _e177) + (_e145 * (((_e185 * ((_e217 * _e218) + (_e221 * _e222))) + (_e197 * ((_e217 * _e219) + (_e221 * _e223)))) + ((_e225 * _e217) * _e221)))) + ((((_e186 * _e154) * _e171) * _e178) + (_e145 * (((_e186 * ((_e218 * _e219) + (_e222 * _e223))) + (_e198 * ((_e218 * _e220) + (_e222 * _e224)))) + ((_e226 * _e218) * _e222))))) + ((((_e187 * _e148) * _e172) * _e179) + (_e145 * (((_e187 * ((_e219 * _e220) + (_e223 * _e224))) + (_e199 * ((_e219 * _e217) + (_e223 * _e221)))) + ((_e227 * _e219) * _e223))))) + ((((_e188 * _e150) * _e169) * _e180) + (_e145 * (((_e188 * ((_e220 * _e217) + (_e224 * _e221))) + (_e200 * ((_e220 * _e218) + (_e224 * _e222)))) + ((_e228 * _e220) * _e224)))));
            let _e423 = (((_e145 * _e145) * _e155) * _e156);
            let _e426 = (((((((_e209 * _e201) + (_e213 * _e205)) + (_e109 * ((_e237 * _e155) + (_e249 * _e156)))) + (((_e210 * _e202) + (_e214 * _e206)) + (_e110 * ((_e238 * _e155) + (_e250 * _e156))))) + (((_e211 * _e203) + (_e215 * _e207)) + (_e111 * ((_e239 * _e155) + (_e251 * _e156))))) + (((_e212 * _e204) + (_e216 * _e208)) + (_e112 * ((_e240 * _e155) + (_e252 * _e156))))) + ((_e423 * _e155) * _e156));
            let _e432 = (_e426 < 0.0000000000000000000000000000000001f);
            if _e432 {
                if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                    phi_623_ = _e109;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_622_ = 0f;
                    } else {
                        if (_e109 < 0f) {
                            phi_621_ = 0f;
                        } else {
                            phi_621_ = 1f;
                        }
                        let _e441 = phi_621_;
                        phi_622_ = _e441;
                    }
                    let _e443 = phi_622_;
                    phi_623_ = _e443;
                }
                let _e445 = phi_623_;
                if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                    phi_642_ = _e110;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_641_ = 0f;
                    } else {
                        if (_e110 < 0f) {
                            phi_640_ = 0f;
                        } else {
                            phi_640_ = 1f;
                        }
                        let _e454 = phi_640_;
                        phi_641_ = _e454;
                    }
                    let _e456 = phi_641_;
                    phi_642_ = _e456;
                }
                let _e458 = phi_642_;
                if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                    phi_661_ = _e111;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_660_ = 0f;
                    } else {
                        if (_e111 < 0f) {
                            phi_659_ = 0f;
                        } else {
                            phi_659_ = 1f;
                        }
                        let _e467 = phi_659_;
                        phi_660_ = _e467;
                    }
                    let _e469 = phi_660_;
                    phi_661_ = _e469;
                }
                let _e471 = phi_661_;
                if ((bitcast<u32>(_e112) & 2147483647u) > 2139095040u) {
                    phi_680_ = _e112;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_679_ = 0f;
                    } else {
                        if (_e112 < 0f) {
                            phi_678_ = 0f;
                        } else {
                            phi_678_ = 1f;
                        }
                        let _e480 = phi_678_;
                        phi_679_ = _e480;
                    }
                    let _e482 = phi_679_;
                    phi_680_ = _e482;
                }
                let _e484 = phi_680_;
                let _e492 = (((((_e445 * _e148) + (_e458 * _e150)) + (_e471 * _e152)) + (_e484 * _e154)) + _e145);
                if ((bitcast<u32>(_e492) & 2147483647u) > 2139095040u) {
                    phi_705_ = _e492;
                } else {
                    if (_e492 < 0f) {
                        phi_704_ = 0f;
                    } else {
                        if (_e492 > 1f) {
                            phi_703_ = 1f;
                        } else {
                            phi_703_ = _e492;
                        }
                        let _e499 = phi_703_;
                        phi_704_ = _e499;
                    }
                    let _e501 = phi_704_;
                    phi_705_ = _e501;
                }
                let _e503 = phi_705_;
                phi_818_ = _e503;
                phi_819_ = f32();
            } else {
                let _e505 = ((0.5f * -(((((((((_e209 * (_e109 + _e110)) + (_e213 * (_e109 + _e111))) + (_e237 * (_e109 + _e155))) + (_e249 * (_e109 + _e156))) + ((((_e210 * (_e110 + _e111)) + (_e214 * (_e110 + _e112))) + (_e238 * (_e110 + _e155))) + (_e250 * (_e110 + _e156)))) + ((((_e211 * (_e111 + _e112)) + (_e215 * (_e111 + _e109))) + (_e239 * (_e111 + _e155))) + (_e251 * (_e111 + _e156)))) + ((((_e212 * (_e112 + _e109)) + (_e216 * (_e112 + _e110))) + (_e240 * (_e112 + _e155))) + (_e252 * (_e112 + _e156)))) + (_e423 * (_e155 + _e156))))) / _e426);
                let _e506 = ((((((((_e209 + _e213) + _e237) + _e249) + (((_e210 + _e214) + _e238) + _e250)) + (((_e211 + _e215) + _e239) + _e251)) + (((_e212 + _e216) + _e240) + _e252)) + _e423) / _e426);
                let _e508 = ((_e505 * _e505) - _e506);
                if (_e508 > 0f) {
                    phi_716_ = sqrt(_e508);
                } else {
                    phi_716_ = 0f;
                }
                let _e512 = phi_716_;
                if (_e505 > 0f) {
                    let _e515 = (-(_e505) - _e512);
                    phi_733_ = lt_bvh_slab_Span(_e515, (_e506 / _e515));
                } else {
                    let _e518 = (_e512 - _e505);
                    if (_e518 > 0f) {
                        phi_731_ = (_e506 / _e518);
                    } else {
                        phi_731_ = 0f;
                    }
                    let _e522 = phi_731_;
                    phi_733_ = lt_bvh_slab_Span(_e522, _e518);
                }
                let _e525 = phi_733_;
                if (_e525.near >= 0f) {
                    phi_794_ = 1f;
                    phi_795_ = f32();
                    phi_796_ = true;
                } else {
                    let _e529 = (_e525.far <= 0f);
                    if _e529 {
                        phi_792_ = (_e420 / _e426);
                        phi_793_ = f32();
                    } else {
                        let _e540 = (((((_e148 * _e109) + (_e150 * _e110)) + (_e152 * _e111)) + (_e154 * _e112)) + (_e145 * (_e155 + _e156)));
                        let _e556 = (((((_e148 * (_e109 * _e109)) + (_e150 * (_e110 * _e110))) + (_e152 * (_e111 * _e111))) + (_e154 * (_e112 * _e112))) + (_e145 * ((_e155 * _e155) + (_e156 * _e156))));
                        if (-(_e525.near) <= _e525.far) {
                            phi_791_ = (1f - (((_e525.near * _e525.near) * ((_e525.far * _e556) - _e540)) / (_e525.far - _e525.near)));
                        } else {
                            phi_791_ = ((_e420 / _e426) + (((_e525.far * _e525.far) * (_e540 - (_e525.near * _e556))) / (_e525.far - _e525.near)));
                        }
                        let _e575 = phi_791_;
                        phi_792_ = f32();
                        phi_793_ = _e575;
                    }
                    let _e577 = phi_792_;
                    let _e579 = phi_793_;
                    phi_794_ = _e577;
                    phi_795_ = _e579;
                    phi_796_ = _e529;
                }
                let _e581 = phi_794_;
                let _e583 = phi_795_;
                let _e585 = phi_796_;
                if _e585 {
                    phi_800_ = _e581;
                } else {
                    phi_800_ = _e583;
                }
                let _e587 = phi_800_;
                if ((bitcast<u32>(_e587) & 2147483647u) > 2139095040u) {
                    phi_817_ = _e587;
                } else {
                    if (_e587 < 0f) {
                        phi_816_ = 0f;
                    } else {
                        if (_e587 > 1f) {
                            phi_815_ = 1f;
                        } else {
                            phi_815_ = _e587;
                        }
                        let _e594 = phi_815_;
                        phi_816_ = _e594;
                    }
                    let _e596 = phi_816_;
                    phi_817_ = _e596;
                }
                let _e598 = phi_817_;
                phi_818_ = f32();
                phi_819_ = _e598;
            }
            let _e600 = phi_818_;
            let _e602 = phi_819_;
            phi_820_ = _e600;
            phi_821_ = _e602;
            phi_822_ = _e432;
        }
        let _e604 = phi_820_;
        let _e606 = phi_821_;
        let _e608 = phi_822_;
        phi_823_ = _e604;
        phi_824_ = _e606;
        phi_825_ = _e608;
    }
    let _e610 = phi_823_;
    let _e612 = phi_824_;
    let _e614 = phi_825_;
    if _e614 {
        phi_829_ = _e610;
    } else {
        phi_829_ = _e612;
    }
    let _e616 = phi_829_;
    return _e616;
}

fn function_() {
    var local_1: f32;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_887_: bool;
    var phi_957_: bool;
    var phi_958_: bool;
    var phi_969_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_970_: bool;
    var phi_971_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_972_: bool;
    var phi_979_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_983_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1057_: bool;
    var phi_1066_: bool;
    var phi_1075_: bool;
    var phi_1076_: bool;
    var phi_1077_: bool;
    var phi_1078_: bool;
    var phi_1079_: bool;
    var phi_1080_: bool;
    var phi_1081_: bool;
    var phi_1085_: bool;
    var phi_1175_: f32;
    var phi_1178_: f32;
    var phi_1207_: f32;
    var phi_1212_: f32;
    var phi_1213_: bool;
    var phi_1214_: f32;
    var phi_1215_: bool;
    var phi_1219_: f32;
    var phi_1239_: f32;
    var phi_1244_: f32;
    var phi_1245_: bool;
    var phi_1246_: f32;
    var phi_1247_: bool;
    var phi_1251_: f32;
    var phi_1299_: i32;
    var phi_1304_: i32;
    var phi_1309_: i32;
    var phi_1314_: i32;
    var phi_1323_: i32;
    var phi_1328_: i32;
    var phi_1333_: i32;
    var phi_1338_: i32;
    var phi_1391_: bool;
    var phi_1399_: bool;
    var phi_1411_: bool;
    var phi_1412_: bool;
    var phi_1416_: f32;
    var phi_1422_: f32;
    var phi_1424_: evaluate_Verdict;
    var phi_1434_: u32;
    var phi_1443_: f32;
    var phi_1445_: evaluate_Verdict;
    var phi_1446_: bool;
    var phi_1447_: evaluate_Verdict;
    var phi_1448_: bool;
    var phi_1453_: evaluate_Verdict;
    var phi_1458_: evaluate_Verdict;
    var phi_1459_: evaluate_Verdict;
    var phi_1463_: bool;
    var phi_1464_: u32;
    var phi_1475_: u32;
    var phi_1492_: u32;

    let _e45 = id_1;
    let _e46 = local_2;
    let _e51 = arrayLength((&map.member));
    let _e56 = p.member.size[0u];
    let _e58 = p.member.size[1u];
    let _e59 = lt_shaders_entry_pixel_index(_e45, _e56, _e58);
    if (bitcast<i32>(_e59.root) != 0i) {
        let _e66 = p.member.projection;
        let _e67 = lt_math_OneLevel(_e66);
        let _e71 = samples.member[_e59.first_primitive].normal[0u];
        let _e73 = global[0u];
        if (_e71 == _e73) {
            let _e76 = samples.member[_e59.first_primitive].normal[1u];
            let _e78 = global[1u];
            if (_e76 == _e78) {
                let _e81 = samples.member[_e59.first_primitive].normal[2u];
                let _e83 = global[2u];
                phi_880_ = (_e81 == _e83);
                phi_881_ = false;
            } else {
                phi_880_ = bool();
                phi_881_ = true;
            }
            let _e86 = phi_880_;
            let _e88 = phi_881_;
            phi_882_ = _e86;
            phi_883_ = _e88;
        } else {
            phi_882_ = bool();
            phi_883_ = true;
        }
        let _e90 = phi_882_;
        let _e92 = phi_883_;
        if _e92 {
            phi_887_ = false;
        } else {
            phi_887_ = _e90;
        }
        let _e94 = phi_887_;
        if !(_e94) {
            let _e97 = samples.member[_e59.first_primitive].position;
            let _e99 = p.member.light.place;
            let _e105 = p.member.light.place[3u];
            let _e112 = (_e99.x - (_e97.x * _e105));
            let _e113 = (_e99.y - (_e97.y * _e105));
            let _e114 = (_e99.z - (_e97.z * _e105));
            let _e116 = samples.member[_e59.first_primitive].normal;
            if ((((_e116.x * _e112) + (_e116.y * _e113)) + (_e116.z * _e114)) > 0f) {
                let _e130 = (((_e112 * _e112) + (_e113 * _e113)) + (_e114 * _e114));
                let _e132 = p.member.light.axis;
                let _e144 = p.member.light.place[3u];
                if (_e144 == 0f) {
                    phi_958_ = true;
                } else {
                    let _e147 = p.member.light.range_squared;
                    if (_e130 <= _e147) {
                        let _e150 = p.member.light.cos_outer;
                        phi_957_ = (-((((_e112 * _e132.x) + (_e113 * _e132.y)) + (_e114 * _e132.z))) >= (_e150 * sqrt(_e130)));
                    } else {
                        phi_957_ = false;
                    }
                    let _e155 = phi_957_;
                    phi_958_ = _e155;
                }
                let _e157 = phi_958_;
                if _e157 {
                    let _e159 = samples.member[_e59.first_primitive].flags;
                    let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
                    phi_969_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, ((_e159 & 1u) == 0u));
                    phi_970_ = false;
                } else {
                    phi_969_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_970_ = true;
                }
                let _e178 = phi_969_;
                let _e180 = phi_970_;
                phi_971_ = _e178;
                phi_972_ = _e180;
            } else {
                phi_971_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_972_ = true;
            }
            let _e182 = phi_971_;
            let _e184 = phi_972_;
            if _e184 {
                let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e190.unnamed.visibility, false), _e190.unnamed_1);
                phi_979_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e196.unnamed, true);
            } else {
                phi_979_ = _e182;
            }
            let _e201 = phi_979_;
            phi_983_ = _e201;
        } else {
            let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e207.unnamed.visibility, false), _e207.unnamed_1);
            phi_983_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e213.unnamed, true);
        }
        let _e218 = phi_983_;
        if _e218.unnamed_1 {
            phi_1459_ = evaluate_Verdict(_e218.unnamed.visibility, _e218.unnamed.is_doubted);
        } else {
            let _e226 = samples.member[_e59.first_primitive].position;
            let _e244 = ((((_e67.projection.row_w.x * _e226.x) + (_e67.projection.row_w.y * _e226.y)) + (_e67.projection.row_w.z * _e226.z)) + (_e67.projection.row_w.w * 1f));
            let _e258 = (((((_e67.projection.row_x.x * _e226.x) + (_e67.projection.row_x.y * _e226.y)) + (_e67.projection.row_x.z * _e226.z)) + (_e67.projection.row_x.w * 1f)) / _e244);
            let _e272 = (((((_e67.projection.row_y.x * _e226.x) + (_e67.projection.row_y.y * _e226.y)) + (_e67.projection.row_y.z * _e226.z)) + (_e67.projection.row_y.w * 1f)) / _e244);
            let _e285 = ((((_e67.projection.row_z.x * _e226.x) + (_e67.projection.row_z.y * _e226.y)) + (_e67.projection.row_z.z * _e226.z)) + (_e67.projection.row_z.w * 1f));
            if (_e244 > 0f) {
                if (_e258 >= 0f) {
                    phi_1057_ = (_e258 <= 1f);
                } else {
                    phi_1057_ = false;
                }
                let _e290 = phi_1057_;
                if _e290 {
                    if (_e272 >= 0f) {
                        phi_1066_ = (_e272 <= 1f);
                    } else {
                        phi_1066_ = false;
                    }
                    let _e294 = phi_1066_;
                    if _e294 {
                        if (_e285 >= 0f) {
                            phi_1075_ = (_e285 <= 1f);
                        } else {
                            phi_1075_ = false;
                        }
                        let _e298 = phi_1075_;
                        phi_1076_ = _e298;
                        phi_1077_ = false;
                    } else {
                        phi_1076_ = bool();
                        phi_1077_ = true;
                    }
                    let _e300 = phi_1076_;
                    let _e302 = phi_1077_;
                    phi_1078_ = _e300;
                    phi_1079_ = _e302;
                } else {
                    phi_1078_ = bool();
                    phi_1079_ = true;
                }
                let _e304 = phi_1078_;
                let _e306 = phi_1079_;
                phi_1080_ = _e304;
                phi_1081_ = _e306;
            } else {
                phi_1080_ = bool();
                phi_1081_ = true;
            }
            let _e308 = phi_1080_;
            let _e310 = phi_1081_;
            if _e310 {
                phi_1085_ = false;
            } else {
                phi_1085_ = _e308;
            }
            let _e312 = phi_1085_;
            if _e312 {
                if (0f > 0f) {
                    let _e315 = samples.member[_e59.first_primitive].normal;
                    let _e317 = p.member.map_size;
                    let _e387 = ((abs(((((_e66.row_x.x * _e315.x) + (_e66.row_x.y * _e315.y)) + (_e66.row_x.z * _e315.z)) / (((_e66.row_x.x * _e66.row_x.x) + (_e66.row_x.y * _e66.row_x.y)) + (_e66.row_x.z * _e66.row_x.z)))) + abs(((((_e66.row_y.x * _e315.x) + (_e66.row_y.y * _e315.y)) + (_e66.row_y.z * _e315.z)) / (((_e66.row_y.x * _e66.row_y.x) + (_e66.row_y.y * _e66.row_y.y)) + (_e66.row_y.z * _e66.row_y.z))))) / (abs(((((_e66.row_z.x * _e315.x) + (_e66.row_z.y * _e315.y)) + (_e66.row_z.z * _e315.z)) / (((_e66.row_z.x * _e66.row_z.x) + (_e66.row_z.y * _e66.row_z.y)) + (_e66.row_z.z * _e66.row_z.z)))) * f32(_e317)));
                    if (_e387 < 0.002f) {
                        phi_1175_ = _e387;
                    } else {
                        phi_1175_ = 0.002f;
                    }
                    let _e390 = phi_1175_;
                    phi_1178_ = (_e285 - (0f * _e390));
                } else {
                    phi_1178_ = _e285;
                }
                let _e394 = phi_1178_;
                let _e396 = p.member.map_size;
                let _e397 = f32(_e396);
                let _e400 = ((_e258 * _e397) - 0.5f);
                let _e401 = ((_e272 * _e397) - 0.5f);
                if (_e400 > -8388608f) {
                    let _e413 = f32(select(0i, select(select(i32(_e400), i32(-2147483648), (_e400 < bitcast<f32>(3472883712u))), 2147483647i, (_e400 > bitcast<f32>(1325400063u))), (_e400 == _e400)));
                    if (_e413 > _e400) {
                        phi_1207_ = 1f;
                    } else {
                        phi_1207_ = 0f;
                    }
                    let _e416 = phi_1207_;
                    if (_e400 < 8388608f) {
                        phi_1212_ = (_e413 - _e416);
                        phi_1213_ = false;
                    } else {
                        phi_1212_ = f32();
                        phi_1213_ = true;
                    }
                    let _e419 = phi_1212_;
                    let _e421 = phi_1213_;
                    phi_1214_ = _e419;
                    phi_1215_ = _e421;
                } else {
                    phi_1214_ = f32();
                    phi_1215_ = true;
                }
                let _e423 = phi_1214_;
                let _e425 = phi_1215_;
                if _e425 {
                    phi_1219_ = _e400;
                } else {
                    phi_1219_ = _e423;
                }
                let _e427 = phi_1219_;
                if (_e401 > -8388608f) {
                    let _e439 = f32(select(0i, select(select(i32(_e401), i32(-2147483648), (_e401 < bitcast<f32>(3472883712u))), 2147483647i, (_e401 > bitcast<f32>(1325400063u))), (_e401 == _e401)));
                    if (_e439 > _e401) {
                        phi_1239_ = 1f;
                    } else {
                        phi_1239_ = 0f;
                    }
                    let _e442 = phi_1239_;
                    if (_e401 < 8388608f) {
                        phi_1244_ = (_e439 - _e442);
                        phi_1245_ = false;
                    } else {
                        phi_1244_ = f32();
                        phi_1245_ = true;
                    }
                    let _e445 = phi_1244_;
                    let _e447 = phi_1245_;
                    phi_1246_ = _e445;
                    phi_1247_ = _e447;
                } else {
                    phi_1246_ = f32();
                    phi_1247_ = true;
                }
                let _e449 = phi_1246_;
                let _e451 = phi_1247_;
                if _e451 {
                    phi_1251_ = _e401;
                } else {
                    phi_1251_ = _e449;
                }
                let _e453 = phi_1251_;
                let _e454 = (_e400 - _e427);
                let _e455 = (_e401 - _e453);
                let _e464 = select(0i, select(select(i32(_e427), i32(-2147483648), (_e427 < bitcast<f32>(3472883712u))), 2147483647i, (_e427 > bitcast<f32>(1325400063u))), (_e427 == _e427));
                let _e473 = select(0i, select(select(i32(_e453), i32(-2147483648), (_e453 < bitcast<f32>(3472883712u))), 2147483647i, (_e453 > bitcast<f32>(1325400063u))), (_e453 == _e453));
                let _e484 = p.member.test;
                let _e485 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e484);
                let _e487 = p.member.map_size;
                local_1 = _e485;
                let _e489 = ((0u * _e487) * _e487);
                let _e491 = (bitcast<i32>(_e487) - 1i);
                if (_e464 > 0i) {
                    phi_1299_ = _e464;
                } else {
                    phi_1299_ = 0i;
                }
                let _e494 = phi_1299_;
                if (_e473 > 0i) {
                    phi_1304_ = _e473;
                } else {
                    phi_1304_ = 0i;
                }
                let _e497 = phi_1304_;
                if (_e494 < _e491) {
                    phi_1309_ = _e494;
                } else {
                    phi_1309_ = _e491;
                }
                let _e500 = phi_1309_;
                if (_e497 < _e491) {
                    phi_1314_ = _e497;
                } else {
                    phi_1314_ = _e491;
                }
                let _e503 = phi_1314_;
                let _e504 = bitcast<u32>(_e500);
                let _e506 = (_e464 + 1i);
                let _e507 = (_e473 + 1i);
                if (_e506 > 0i) {
                    phi_1323_ = _e506;
                } else {
                    phi_1323_ = 0i;
                }
                let _e510 = phi_1323_;
                if (_e507 > 0i) {
                    phi_1328_ = _e507;
                } else {
                    phi_1328_ = 0i;
                }
                let _e513 = phi_1328_;
                if (_e510 < _e491) {
                    phi_1333_ = _e510;
                } else {
                    phi_1333_ = _e491;
                }
                let _e516 = phi_1333_;
                if (_e513 < _e491) {
                    phi_1338_ = _e513;
                } else {
                    phi_1338_ = _e491;
                }
                let _e519 = phi_1338_;
                let _e520 = bitcast<u32>(_e516);
                let _e522 = (bitcast<u32>(_e503) * _e487);
                let _e523 = (bitcast<u32>(_e519) * _e487);
                let _e528 = ((_e522 + _e504) + _e489);
                let _e529 = ((_e522 + _e520) + _e489);
                let _e530 = ((_e523 + _e504) + _e489);
                let _e531 = ((_e523 + _e520) + _e489);
                if (_e528 < _e51) {
                } else {
                    return;
                }
                let _e535 = map.member[(0u + _e528)];
                if (_e529 < _e51) {
                } else {
                    return;
                }
                let _e539 = map.member[(0u + _e529)];
                if (_e530 < _e51) {
                } else {
                    return;
                }
                let _e543 = map.member[(0u + _e530)];
                if (_e531 < _e51) {
                } else {
                    return;
                }
                let _e547 = map.member[(0u + _e531)];
                let _e549 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e535, _e539, _e543, _e547), vec4<f32>(((1f - _e454) * (1f - _e455)), (_e454 * (1f - _e455)), ((1f - _e454) * _e455), (_e454 * _e455)), _e394);
                let _e553 = p.member.epsilon;
                if (_e549 <= _e553) {
                    phi_1391_ = true;
                } else {
                    phi_1391_ = (_e549 >= (1f - _e553));
                }
                let _e558 = phi_1391_;
                if ((bitcast<u32>(_e549) & 2147483647u) > 2139095040u) {
                    phi_1399_ = true;
                } else {
                    phi_1399_ = !(_e558);
                }
                let _e564 = phi_1399_;
                if _e564 {
                    if (_e549 > 0f) {
                        if (_e549 < 1f) {
                            phi_1411_ = false;
                        } else {
                            phi_1411_ = true;
                        }
                        let _e568 = phi_1411_;
                        phi_1412_ = _e568;
                    } else {
                        phi_1412_ = true;
                    }
                    let _e570 = phi_1412_;
                    if _e570 {
                        phi_1416_ = 0.5f;
                    } else {
                        phi_1416_ = _e549;
                    }
                    let _e572 = phi_1416_;
                    phi_1424_ = evaluate_Verdict(_e572, true);
                } else {
                    if (_e549 > 0.5f) {
                        phi_1422_ = 1f;
                    } else {
                        phi_1422_ = 0f;
                    }
                    let _e576 = phi_1422_;
                    phi_1424_ = evaluate_Verdict(_e576, false);
                }
                let _e579 = phi_1424_;
                let _e582 = (_e579.visibility < 0.5f);
                if _e579.is_doubted {
                    phi_1447_ = evaluate_Verdict();
                    phi_1448_ = true;
                } else {
                    if _e582 {
                        phi_1434_ = 2u;
                    } else {
                        phi_1434_ = 1u;
                    }
                    let _e584 = phi_1434_;
                    if ((0u & _e584) != 0u) {
                        if _e582 {
                            phi_1443_ = 0.000000059604645f;
                        } else {
                            phi_1443_ = 0.99999994f;
                        }
                        let _e588 = phi_1443_;
                        phi_1445_ = evaluate_Verdict(_e588, true);
                        phi_1446_ = false;
                    } else {
                        phi_1445_ = evaluate_Verdict();
                        phi_1446_ = true;
                    }
                    let _e591 = phi_1445_;
                    let _e593 = phi_1446_;
                    phi_1447_ = _e591;
                    phi_1448_ = _e593;
                }
                let _e595 = phi_1447_;
                let _e597 = phi_1448_;
                if _e597 {
                    phi_1453_ = evaluate_Verdict(_e579.visibility, _e579.is_doubted);
                } else {
                    phi_1453_ = _e595;
                }
                let _e600 = phi_1453_;
                phi_1458_ = evaluate_Verdict(_e600.visibility, _e600.is_doubted);
            } else {
                phi_1458_ = evaluate_Verdict(0.5f, true);
            }
            let _e606 = phi_1458_;
            phi_1459_ = _e606;
        }
        let _e608 = phi_1459_;
        visibility.member[_e59.first_primitive] = _e608.visibility;
        phi_1463_ = _e608.is_doubted;
        phi_1464_ = _e59.first_primitive;
    } else {
        phi_1463_ = false;
        phi_1464_ = 0u;
    }
    let _e613 = phi_1463_;
    let _e615 = phi_1464_;
    if (_e46 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e613 {
        let _e619 = atomicAdd((&shared_[0u]), 1u);
        phi_1475_ = _e619;
    } else {
        phi_1475_ = 0u;
    }
    let _e621 = phi_1475_;
    workgroupBarrier();
    if (_e46 == 0u) {
        let _e625 = atomicLoad((&shared_[0u]));
        let _e626 = atomicAdd((&list.member[3u]), _e625);
        atomicStore((&shared_[1u]), _e626);
    }
    workgroupBarrier();
    if _e613 {
        if false {
            phi_1492_ = (_e615 | 2147483648u);
        } else {
            phi_1492_ = _e615;
        }
        let _e630 = phi_1492_;
        let _e632 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e632) + _e621)]), _e630);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
