struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct type_8 {
    member: array<u32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_22 {
    member: array<abi_Sample>,
}

struct type_26 {
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

struct type_34 {
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

struct type_41 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_22;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_34;
@group(0) @binding(2) 
var<storage> map: type_26;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_26;
var<private> local_1: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_41;
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_145_: lt_bvh_traverse_Tree;
    var phi_146_: bool;
    var phi_147_: lt_bvh_traverse_Tree;
    var phi_148_: bool;
    var phi_153_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_145_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_146_ = false;
        } else {
            phi_145_ = lt_bvh_traverse_Tree();
            phi_146_ = true;
        }
        let _e54 = phi_145_;
        let _e56 = phi_146_;
        phi_147_ = _e54;
        phi_148_ = _e56;
    } else {
        phi_147_ = lt_bvh_traverse_Tree();
        phi_148_ = true;
    }
    let _e58 = phi_147_;
    let _e60 = phi_148_;
    if _e60 {
        phi_153_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_153_ = _e58;
    }
    let _e65 = phi_153_;
    return lt_bvh_traverse_Tree(_e65.root, _e65.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: vec4<f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_178_: f32;
    var phi_179_: f32;
    var phi_180_: f32;
    var phi_197_: f32;
    var phi_198_: f32;
    var phi_199_: f32;
    var phi_215_: f32;
    var phi_216_: f32;
    var phi_217_: f32;
    var phi_233_: f32;
    var phi_234_: f32;
    var phi_235_: f32;
    var phi_251_: f32;
    var phi_252_: f32;
    var phi_253_: f32;
    var phi_268_: bool;
    var phi_272_: f32;
    var phi_283_: bool;
    var phi_287_: f32;
    var phi_298_: bool;
    var phi_302_: f32;
    var phi_313_: bool;
    var phi_317_: f32;
    var phi_328_: bool;
    var phi_332_: f32;
    var phi_343_: bool;
    var phi_347_: f32;
    var phi_370_: bool;
    var phi_374_: f32;
    var phi_385_: bool;
    var phi_389_: f32;
    var phi_498_: f32;
    var phi_499_: f32;
    var phi_500_: f32;
    var phi_517_: f32;
    var phi_518_: f32;
    var phi_519_: f32;
    var phi_536_: f32;
    var phi_537_: f32;
    var phi_538_: f32;
    var phi_555_: f32;
    var phi_556_: f32;
    var phi_557_: f32;
    var phi_583_: f32;
    var phi_584_: f32;
    var phi_585_: f32;
    var phi_586_: f32;
    var phi_587_: f32;
    var phi_595_: bool;
    var phi_596_: bool;
    var phi_597_: bool;
    var phi_601_: bool;
    var phi_613_: bool;
    var phi_614_: bool;
    var phi_618_: f32;
    var phi_629_: f32;
    var phi_644_: f32;
    var phi_646_: lt_bvh_slab_Span;
    var phi_774_: f32;
    var phi_775_: f32;
    var phi_776_: f32;
    var phi_777_: f32;
    var phi_778_: f32;
    var phi_779_: bool;
    var phi_783_: f32;
    var phi_798_: f32;
    var phi_799_: f32;
    var phi_800_: f32;
    var phi_808_: bool;
    var phi_809_: bool;
    var phi_813_: f32;
    var phi_814_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_180_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_179_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_178_ = 1f;
            } else {
                phi_178_ = param_6;
            }
            let _e50 = phi_178_;
            phi_179_ = _e50;
        }
        let _e52 = phi_179_;
        phi_180_ = _e52;
    }
    let _e54 = phi_180_;
    let _e55 = (_e54 - 0.00000047683716f);
    if ((bitcast<u32>(param_4.x) & 2147483647u) > 2139095040u) {
        phi_199_ = param_4.x;
    } else {
        if (param_4.x < 0f) {
            phi_198_ = 0f;
        } else {
            if (param_4.x > 1f) {
                phi_197_ = 1f;
            } else {
                phi_197_ = param_4.x;
            }
            let _e63 = phi_197_;
            phi_198_ = _e63;
        }
        let _e65 = phi_198_;
        phi_199_ = _e65;
    }
    let _e67 = phi_199_;
    if ((bitcast<u32>(param_4.y) & 2147483647u) > 2139095040u) {
        phi_217_ = param_4.y;
    } else {
        if (param_4.y < 0f) {
            phi_216_ = 0f;
        } else {
            if (param_4.y > 1f) {
                phi_215_ = 1f;
            } else {
                phi_215_ = param_4.y;
            }
            let _e75 = phi_215_;
            phi_216_ = _e75;
        }
        let _e77 = phi_216_;
        phi_217_ = _e77;
    }
    let _e79 = phi_217_;
    if ((bitcast<u32>(param_4.z) & 2147483647u) > 2139095040u) {
        phi_235_ = param_4.z;
    } else {
        if (param_4.z < 0f) {
            phi_234_ = 0f;
        } else {
            if (param_4.z > 1f) {
                phi_233_ = 1f;
            } else {
                phi_233_ = param_4.z;
            }
            let _e87 = phi_233_;
            phi_234_ = _e87;
        }
        let _e89 = phi_234_;
        phi_235_ = _e89;
    }
    let _e91 = phi_235_;
    if ((bitcast<u32>(param_4.w) & 2147483647u) > 2139095040u) {
        phi_253_ = param_4.w;
    } else {
        if (param_4.w < 0f) {
            phi_252_ = 0f;
        } else {
            if (param_4.w > 1f) {
                phi_251_ = 1f;
            } else {
                phi_251_ = param_4.w;
            }
            let _e99 = phi_251_;
            phi_252_ = _e99;
        }
        let _e101 = phi_252_;
        phi_253_ = _e101;
    }
    let _e103 = phi_253_;
    let _e104 = (_e67 - _e55);
    let _e105 = (_e79 - _e55);
    let _e106 = (_e91 - _e55);
    let _e107 = (_e103 - _e55);
    if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
        phi_268_ = true;
    } else {
        let _e111 = (_e105 < _e104);
        if _e111 {
        }
        phi_268_ = _e111;
    }
    let _e113 = phi_268_;
    if _e113 {
        phi_272_ = _e105;
    } else {
        phi_272_ = _e104;
    }
    let _e115 = phi_272_;
    if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
        phi_283_ = true;
    } else {
        let _e119 = (_e107 < _e106);
        if _e119 {
        }
        phi_283_ = _e119;
    }
    let _e121 = phi_283_;
    if _e121 {
        phi_287_ = _e107;
    } else {
        phi_287_ = _e106;
    }
    let _e123 = phi_287_;
    if ((bitcast<u32>(_e123) & 2147483647u) > 2139095040u) {
        phi_298_ = true;
    } else {
        let _e127 = (_e123 < _e115);
        if _e127 {
        }
        phi_298_ = _e127;
    }
    let _e129 = phi_298_;
    if _e129 {
        phi_302_ = _e123;
    } else {
        phi_302_ = _e115;
    }
    let _e131 = phi_302_;
    if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
        phi_313_ = true;
    } else {
        let _e135 = (_e105 > _e104);
        if _e135 {
        }
        phi_313_ = _e135;
    }
    let _e137 = phi_313_;
    if _e137 {
        phi_317_ = _e105;
    } else {
        phi_317_ = _e104;
    }
    let _e139 = phi_317_;
    if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
        phi_328_ = true;
    } else {
        let _e143 = (_e107 > _e106);
        if _e143 {
        }
        phi_328_ = _e143;
    }
    let _e145 = phi_328_;
    if _e145 {
        phi_332_ = _e107;
    } else {
        phi_332_ = _e106;
    }
    let _e147 = phi_332_;
    if ((bitcast<u32>(_e147) & 2147483647u) > 2139095040u) {
        phi_343_ = true;
    } else {
        let _e151 = (_e147 > _e139);
        if _e151 {
        }
        phi_343_ = _e151;
    }
    let _e153 = phi_343_;
    if _e153 {
        phi_347_ = _e147;
    } else {
        phi_347_ = _e139;
    }
    let _e155 = phi_347_;
    let _e166 = ((((_e104 * param_5.x) + (_e105 * param_5.y)) + (_e106 * param_5.z)) + (_e107 * param_5.w));
    let _e167 = -(_e131);
    if ((bitcast<u32>(_e155) & 2147483647u) > 2139095040u) {
        phi_370_ = true;
    } else {
        let _e171 = (_e155 > _e167);
        if _e171 {
        }
        phi_370_ = _e171;
    }
    let _e173 = phi_370_;
    if _e173 {
        phi_374_ = _e155;
    } else {
        phi_374_ = _e167;
    }
    let _e175 = phi_374_;
    if ((bitcast<u32>(0.0000009536743f) & 2147483647u) > 2139095040u) {
        phi_385_ = true;
    } else {
        let _e179 = (0.0000009536743f > _e175);
        if _e179 {
        }
        phi_385_ = _e179;
    }
    let _e181 = phi_385_;
    if _e181 {
        phi_389_ = 0.0000009536743f;
    } else {
        phi_389_ = _e175;
    }
    let _e183 = phi_389_;
    let _e187 = bitcast<f32>((2130706432u - (bitcast<u32>(_e183) & 2139095040u)));
    let _e188 = (_e104 * _e187);
    let _e189 = (_e105 * _e187);
    let _e190 = (_e106 * _e187);
    let _e191 = (_e107 * _e187);
    let _e192 = (_e188 - _e189);
    let _e193 = (_e189 - _e190);
    let _e194 = (_e190 - _e191);
    let _e195 = (_e191 - _e188);
    let _e196 = (_e192 * _e192);
    let _e197 = (_e193 * _e193);
    let _e198 = (_e194 * _e194);
    let _e199 = (_e195 * _e195);
    let _e202 = ((_e188 - _e190) * (_e188 - _e190));
    let _e205 = ((_e189 - _e191) * (_e189 - _e191));
    let _e207 = (param_5.x * _e188);
    let _e209 = (param_5.y * _e189);
    let _e211 = (param_5.z * _e190);
    let _e213 = (param_5.w * _e191);
    let _e218 = ((_e207 * _e209) * _e196);
    let _e219 = ((_e209 * _e211) * _e197);
    let _e220 = ((_e211 * _e213) * _e198);
    let _e221 = ((_e213 * _e207) * _e199);
    let _e223 = ((_e207 * _e211) * _e202);
    let _e225 = ((_e209 * _e213) * _e205);
    let _e242 = ((((((_e218 * (_e188 * _e189)) + (_e219 * (_e189 * _e190))) + (_e220 * (_e190 * _e191))) + (_e221 * (_e191 * _e188))) + (_e223 * (_e188 * _e190))) + (_e225 * (_e189 * _e191)));
    let _e266 = (_e131 >= 0f);
    let _e269 = ((bitcast<u32>(_e166) & 2147483647u) > 2139095040u);
    if _e269 {
        phi_587_ = _e166;
    } else {
        if _e266 {
            phi_586_ = 1f;
        } else {
            if ((bitcast<u32>(_e188) & 2147483647u) > 2139095040u) {
                phi_500_ = _e188;
            } else {
                if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                    phi_499_ = 0f;
                } else {
                    if (_e188 < 0f) {
                        phi_498_ = 0f;
                    } else {
                        phi_498_ = 1f;
                    }
                    let _e278 = phi_498_;
                    phi_499_ = _e278;
                }
                let _e280 = phi_499_;
                phi_500_ = _e280;
            }
            let _e282 = phi_500_;
            if ((bitcast<u32>(_e189) & 2147483647u) > 2139095040u) {
                phi_519_ = _e189;
            } else {
                if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                    phi_518_ = 0f;
                } else {
                    if (_e189 < 0f) {
                        phi_517_ = 0f;
                    } else {
                        phi_517_ = 1f;
                    }
                    let _e291 = phi_517_;
                    phi_518_ = _e291;
                }
                let _e293 = phi_518_;
                phi_519_ = _e293;
            }
            let _e295 = phi_519_;
            if ((bitcast<u32>(_e190) & 2147483647u) > 2139095040u) {
                phi_538_ = _e190;
            } else {
                if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                    phi_537_ = 0f;
                } else {
                    if (_e190 < 0f) {
                        phi_536_ = 0f;
                    } else {
                        phi_536_ = 1f;
                    }
                    let _e304 = phi_536_;
                    phi_537_ = _e304;
                }
                let _e306 = phi_537_;
                phi_538_ = _e306;
            }
            let _e308 = phi_538_;
            if ((bitcast<u32>(_e191) & 2147483647u) > 2139095040u) {
                phi_557_ = _e191;
            } else {
                if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                    phi_556_ = 0f;
                } else {
                    if (_e191 < 0f) {
                        phi_555_ = 0f;
                    } else {
                        phi_555_ = 1f;
                    }
                    let _e317 = phi_555_;
                    phi_556_ = _e317;
                }
                let _e319 = phi_556_;
                phi_557_ = _e319;
            }
            let _e321 = phi_557_;
            let _e332 = ((((_e282 * param_5.x) + (_e295 * param_5.y)) + (_e308 * param_5.z)) + (_e321 * param_5.w));
            if ((bitcast<u32>(_e332) & 2147483647u) > 2139095040u) {
                phi_585_ = _e332;
            } else {
                if (_e332 < 0f) {
                    phi_584_ = 0f;
                } else {
                    if (_e332 > 1f) {
                        phi_583_ = 1f;
                    } else {
                        phi_583_ = _e332;
                    }
                    let _e339 = phi_583_;
                    phi_584_ = _e339;
                }
                let _e341 = phi_584_;
                phi_585_ = _e341;
            }
            let _e343 = phi_585_;
            phi_586_ = _e343;
        }
        let _e345 = phi_586_;
        phi_587_ = _e345;
    }
    let _e347 = phi_587_;
    if _e269 {
        phi_596_ = bool();
        phi_597_ = true;
    } else {
        if _e266 {
            phi_595_ = bool();
        } else {
            phi_595_ = (_e242 < 0.0000000000000000000000000000000001f);
        }
        let _e350 = phi_595_;
        phi_596_ = _e350;
        phi_597_ = _e266;
    }
    let _e352 = phi_596_;
    let _e354 = phi_597_;
    if _e354 {
        phi_601_ = true;
    } else {
        phi_601_ = _e352;
    }
    let _e356 = phi_601_;
    let _e357 = (_e166 >= 0f);
    if _e356 {
        if _e357 {
            if (_e347 < 0.05f) {
                phi_613_ = false;
            } else {
                phi_613_ = true;
            }
            let _e360 = phi_613_;
            phi_614_ = _e360;
        } else {
            phi_614_ = true;
        }
        let _e362 = phi_614_;
        if _e362 {
            phi_618_ = _e347;
        } else {
            phi_618_ = 0.05f;
        }
        let _e364 = phi_618_;
        phi_814_ = _e364;
    } else {
        let _e366 = ((0.5f * -(((((((_e218 * (_e188 + _e189)) + (_e219 * (_e189 + _e190))) + (_e220 * (_e190 + _e191))) + (_e221 * (_e191 + _e188))) + (_e223 * (_e188 + _e190))) + (_e225 * (_e189 + _e191))))) / _e242);
        let _e367 = ((((((_e218 + _e219) + _e220) + _e221) + _e223) + _e225) / _e242);
        let _e369 = ((_e366 * _e366) - _e367);
        if (_e369 > 0f) {
            phi_629_ = sqrt(_e369);
        } else {
            phi_629_ = 0f;
        }
        let _e373 = phi_629_;
        if (_e366 > 0f) {
            let _e376 = (-(_e366) - _e373);
            phi_646_ = lt_bvh_slab_Span(_e376, (_e367 / _e376));
        } else {
            let _e379 = (_e373 - _e366);
            if (_e379 > 0f) {
                phi_644_ = (_e367 / _e379);
            } else {
                phi_644_ = 0f;
            }
            let _e383 = phi_644_;
            phi_646_ = lt_bvh_slab_Span(_e383, _e379);
        }
        let _e386 = phi_646_;
        if (_e386.near >= 0f) {
            phi_777_ = 1f;
            phi_778_ = f32();
            phi_779_ = true;
        } else {
            let _e390 = (_e386.far <= 0f);
            if _e390 {
                phi_775_ = (((((((((param_5.x * param_5.y) * param_5.z) * _e196) * _e197) * _e202) + (((((param_5.y * param_5.z) * param_5.w) * _e197) * _e198) * _e205)) + (((((param_5.z * param_5.w) * param_5.x) * _e198) * _e199) * _e202)) + (((((param_5.w * param_5.x) * param_5.y) * _e199) * _e196) * _e205)) / _e242);
                phi_776_ = f32();
            } else {
                let _e437 = ((((param_5.x * _e188) + (param_5.y * _e189)) + (param_5.z * _e190)) + (param_5.w * _e191));
                let _e452 = ((((param_5.x * (_e188 * _e188)) + (param_5.y * (_e189 * _e189))) + (param_5.z * (_e190 * _e190))) + (param_5.w * (_e191 * _e191)));
                if (-(_e386.near) <= _e386.far) {
                    phi_774_ = (1f - (((_e386.near * _e386.near) * ((_e386.far * _e452) - _e437)) / (_e386.far - _e386.near)));
                } else {
                    phi_774_ = ((((((((((param_5.x * param_5.y) * param_5.z) * _e196) * _e197) * _e202) + (((((param_5.y * param_5.z) * param_5.w) * _e197) * _e198) * _e205)) + (((((param_5.z * param_5.w) * param_5.x) * _e198) * _e199) * _e202)) + (((((param_5.w * param_5.x) * param_5.y) * _e199) * _e196) * _e205)) / _e242) + (((_e386.far * _e386.far) * (_e437 - (_e386.near * _e452))) / (_e386.far - _e386.near)));
                }
                let _e506 = phi_774_;
                phi_775_ = f32();
                phi_776_ = _e506;
            }
            let _e508 = phi_775_;
            let _e510 = phi_776_;
            phi_777_ = _e508;
            phi_778_ = _e510;
            phi_779_ = _e390;
        }
        let _e512 = phi_777_;
        let _e514 = phi_778_;
        let _e516 = phi_779_;
        if _e516 {
            phi_783_ = _e512;
        } else {
            phi_783_ = _e514;
        }
        let _e518 = phi_783_;
        if ((bitcast<u32>(_e518) & 2147483647u) > 2139095040u) {
            phi_800_ = _e518;
        } else {
            if (_e518 < 0f) {
                phi_799_ = 0f;
            } else {
                if (_e518 > 1f) {
                    phi_798_ = 1f;
                } else {
                    phi_798_ = _e518;
                }
                let _e525 = phi_798_;
                phi_799_ = _e525;
            }
            let _e527 = phi_799_;
            phi_800_ = _e527;
        }
        let _e529 = phi_800_;
        if _e357 {
            if (_e529 < 0.05f) {
                phi_808_ = false;
            } else {
                phi_808_ = true;
            }
            let _e532 = phi_808_;
            phi_809_ = _e532;
        } else {
            phi_809_ = true;
        }
        let _e534 = phi_809_;
        if _e534 {
            phi_813_ = _e529;
        } else {
            phi_813_ = 0.05f;
        }
        let _e536 = phi_813_;
        phi_814_ = _e536;
    }
    let _e538 = phi_814_;
    return _e538;
}

fn function_() {
    var phi_867_: bool;
    var phi_868_: bool;
    var phi_869_: bool;
    var phi_870_: bool;
    var phi_874_: bool;
    var phi_918_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_922_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_999_: bool;
    var phi_1008_: bool;
    var phi_1017_: bool;
    var phi_1018_: bool;
    var phi_1019_: bool;
    var phi_1020_: bool;
    var phi_1021_: bool;
    var phi_1022_: bool;
    var phi_1023_: bool;
    var phi_1027_: bool;
    var phi_1063_: f32;
    var phi_1068_: f32;
    var phi_1069_: bool;
    var phi_1070_: f32;
    var phi_1071_: bool;
    var phi_1075_: f32;
    var phi_1095_: f32;
    var phi_1100_: f32;
    var phi_1101_: bool;
    var phi_1102_: f32;
    var phi_1103_: bool;
    var phi_1107_: f32;
    var phi_1153_: i32;
    var phi_1158_: i32;
    var phi_1163_: i32;
    var phi_1168_: i32;
    var phi_1177_: i32;
    var phi_1182_: i32;
    var phi_1187_: i32;
    var phi_1192_: i32;
    var phi_1239_: bool;
    var phi_1247_: bool;
    var phi_1252_: f32;
    var phi_1255_: evaluate_Verdict;
    var phi_1256_: evaluate_Verdict;
    var phi_1260_: bool;
    var phi_1261_: u32;
    var phi_1267_: u32;

    let _e41 = id_1;
    let _e42 = local_1;
    let _e47 = arrayLength((&map.member));
    if (_e42 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e54 = p.member.size[0u];
    let _e56 = p.member.size[1u];
    let _e57 = lt_shaders_entry_pixel_index(_e41, _e54, _e56);
    if (bitcast<i32>(_e57.root) != 0i) {
        let _e64 = p.member.light;
        let _e67 = samples.member[_e57.first_primitive].normal[0u];
        let _e69 = global[0u];
        if (_e67 == _e69) {
            let _e72 = samples.member[_e57.first_primitive].normal[1u];
            let _e74 = global[1u];
            if (_e72 == _e74) {
                let _e77 = samples.member[_e57.first_primitive].normal[2u];
                let _e79 = global[2u];
                phi_867_ = (_e77 == _e79);
                phi_868_ = false;
            } else {
                phi_867_ = bool();
                phi_868_ = true;
            }
            let _e82 = phi_867_;
            let _e84 = phi_868_;
            phi_869_ = _e82;
            phi_870_ = _e84;
        } else {
            phi_869_ = bool();
            phi_870_ = true;
        }
        let _e86 = phi_869_;
        let _e88 = phi_870_;
        if _e88 {
            phi_874_ = false;
        } else {
            phi_874_ = _e86;
        }
        let _e90 = phi_874_;
        if !(_e90) {
            let _e93 = samples.member[_e57.first_primitive].normal;
            let _e95 = samples.member[_e57.first_primitive].position;
            if ((((_e93.x * (_e64.x - (_e95.x * _e64.w))) + (_e93.y * (_e64.y - (_e95.y * _e64.w)))) + (_e93.z * (_e64.z - (_e95.z * _e64.w)))) > 0f) {
                let _e119 = samples.member[_e57.first_primitive].flags;
                let _e127 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e127.unnamed.visibility, false), _e127.unnamed_1);
                phi_918_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e133.unnamed, ((_e119 & 1u) == 0u));
            } else {
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e142.unnamed.visibility, false), _e142.unnamed_1);
                phi_918_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e148.unnamed, true);
            }
            let _e153 = phi_918_;
            phi_922_ = _e153;
        } else {
            let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e159.unnamed.visibility, false), _e159.unnamed_1);
            phi_922_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e165.unnamed, true);
        }
        let _e170 = phi_922_;
        if _e170.unnamed_1 {
            phi_1256_ = evaluate_Verdict(_e170.unnamed.visibility, _e170.unnamed.is_doubted);
        } else {
            let _e178 = samples.member[_e57.first_primitive].position;
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
                    phi_999_ = (_e209 <= 1f);
                } else {
                    phi_999_ = false;
                }
                let _e241 = phi_999_;
                if _e241 {
                    if (_e223 >= 0f) {
                        phi_1008_ = (_e223 <= 1f);
                    } else {
                        phi_1008_ = false;
                    }
                    let _e245 = phi_1008_;
                    if _e245 {
                        if (_e236 >= 0f) {
                            phi_1017_ = (_e236 <= 1f);
                        } else {
                            phi_1017_ = false;
                        }
                        let _e249 = phi_1017_;
                        phi_1018_ = _e249;
                        phi_1019_ = false;
                    } else {
                        phi_1018_ = bool();
                        phi_1019_ = true;
                    }
                    let _e251 = phi_1018_;
                    let _e253 = phi_1019_;
                    phi_1020_ = _e251;
                    phi_1021_ = _e253;
                } else {
                    phi_1020_ = bool();
                    phi_1021_ = true;
                }
                let _e255 = phi_1020_;
                let _e257 = phi_1021_;
                phi_1022_ = _e255;
                phi_1023_ = _e257;
            } else {
                phi_1022_ = bool();
                phi_1023_ = true;
            }
            let _e259 = phi_1022_;
            let _e261 = phi_1023_;
            if _e261 {
                phi_1027_ = false;
            } else {
                phi_1027_ = _e259;
            }
            let _e263 = phi_1027_;
            if _e263 {
                let _e265 = p.member.map_size;
                let _e266 = f32(_e265);
                let _e269 = ((_e209 * _e266) - 0.5f);
                let _e270 = ((_e223 * _e266) - 0.5f);
                if (_e269 > -8388608f) {
                    let _e282 = f32(select(0i, select(select(i32(_e269), i32(-2147483648), (_e269 < bitcast<f32>(3472883712u))), 2147483647i, (_e269 > bitcast<f32>(1325400063u))), (_e269 == _e269)));
                    if (_e282 > _e269) {
                        phi_1063_ = 1f;
                    } else {
                        phi_1063_ = 0f;
                    }
                    let _e285 = phi_1063_;
                    if (_e269 < 8388608f) {
                        phi_1068_ = (_e282 - _e285);
                        phi_1069_ = false;
                    } else {
                        phi_1068_ = f32();
                        phi_1069_ = true;
                    }
                    let _e288 = phi_1068_;
                    let _e290 = phi_1069_;
                    phi_1070_ = _e288;
                    phi_1071_ = _e290;
                } else {
                    phi_1070_ = f32();
                    phi_1071_ = true;
                }
                let _e292 = phi_1070_;
                let _e294 = phi_1071_;
                if _e294 {
                    phi_1075_ = _e269;
                } else {
                    phi_1075_ = _e292;
                }
                let _e296 = phi_1075_;
                if (_e270 > -8388608f) {
                    let _e308 = f32(select(0i, select(select(i32(_e270), i32(-2147483648), (_e270 < bitcast<f32>(3472883712u))), 2147483647i, (_e270 > bitcast<f32>(1325400063u))), (_e270 == _e270)));
                    if (_e308 > _e270) {
                        phi_1095_ = 1f;
                    } else {
                        phi_1095_ = 0f;
                    }
                    let _e311 = phi_1095_;
                    if (_e270 < 8388608f) {
                        phi_1100_ = (_e308 - _e311);
                        phi_1101_ = false;
                    } else {
                        phi_1100_ = f32();
                        phi_1101_ = true;
                    }
                    let _e314 = phi_1100_;
                    let _e316 = phi_1101_;
                    phi_1102_ = _e314;
                    phi_1103_ = _e316;
                } else {
                    phi_1102_ = f32();
                    phi_1103_ = true;
                }
                let _e318 = phi_1102_;
                let _e320 = phi_1103_;
                if _e320 {
                    phi_1107_ = _e270;
                } else {
                    phi_1107_ = _e318;
                }
                let _e322 = phi_1107_;
                let _e323 = (_e269 - _e296);
                let _e324 = (_e270 - _e322);
                let _e333 = select(0i, select(select(i32(_e296), i32(-2147483648), (_e296 < bitcast<f32>(3472883712u))), 2147483647i, (_e296 > bitcast<f32>(1325400063u))), (_e296 == _e296));
                let _e342 = select(0i, select(select(i32(_e322), i32(-2147483648), (_e322 < bitcast<f32>(3472883712u))), 2147483647i, (_e322 > bitcast<f32>(1325400063u))), (_e322 == _e322));
                let _e353 = p.member.test;
                let _e354 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e353);
                let _e356 = p.member.map_size;
                let _e358 = (bitcast<i32>(_e356) - 1i);
                if (_e333 > 0i) {
                    phi_1153_ = _e333;
                } else {
                    phi_1153_ = 0i;
                }
                let _e361 = phi_1153_;
                if (_e342 > 0i) {
                    phi_1158_ = _e342;
                } else {
                    phi_1158_ = 0i;
                }
                let _e364 = phi_1158_;
                if (_e361 < _e358) {
                    phi_1163_ = _e361;
                } else {
                    phi_1163_ = _e358;
                }
                let _e367 = phi_1163_;
                if (_e364 < _e358) {
                    phi_1168_ = _e364;
                } else {
                    phi_1168_ = _e358;
                }
                let _e370 = phi_1168_;
                let _e371 = bitcast<u32>(_e367);
                let _e373 = (_e333 + 1i);
                let _e374 = (_e342 + 1i);
                if (_e373 > 0i) {
                    phi_1177_ = _e373;
                } else {
                    phi_1177_ = 0i;
                }
                let _e377 = phi_1177_;
                if (_e374 > 0i) {
                    phi_1182_ = _e374;
                } else {
                    phi_1182_ = 0i;
                }
                let _e380 = phi_1182_;
                if (_e377 < _e358) {
                    phi_1187_ = _e377;
                } else {
                    phi_1187_ = _e358;
                }
                let _e383 = phi_1187_;
                if (_e380 < _e358) {
                    phi_1192_ = _e380;
                } else {
                    phi_1192_ = _e358;
                }
                let _e386 = phi_1192_;
                let _e387 = bitcast<u32>(_e383);
                let _e389 = (bitcast<u32>(_e370) * _e356);
                let _e390 = (bitcast<u32>(_e386) * _e356);
                let _e391 = (_e389 + _e371);
                let _e392 = (_e389 + _e387);
                let _e393 = (_e390 + _e371);
                let _e394 = (_e390 + _e387);
                if (_e391 < _e47) {
                } else {
                    return;
                }
                let _e398 = map.member[(0u + _e391)];
                if (_e392 < _e47) {
                } else {
                    return;
                }
                let _e402 = map.member[(0u + _e392)];
                if (_e393 < _e47) {
                } else {
                    return;
                }
                let _e406 = map.member[(0u + _e393)];
                if (_e394 < _e47) {
                } else {
                    return;
                }
                let _e410 = map.member[(0u + _e394)];
                let _e412 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(vec4<f32>(_e398, _e402, _e406, _e410), vec4<f32>(((1f - _e323) * (1f - _e324)), (_e323 * (1f - _e324)), ((1f - _e323) * _e324), (_e323 * _e324)), _e236);
                let _e414 = p.member.epsilon;
                if (_e412 <= _e414) {
                    phi_1239_ = true;
                } else {
                    phi_1239_ = (_e412 >= (1f - _e414));
                }
                let _e419 = phi_1239_;
                if ((bitcast<u32>(_e412) & 2147483647u) > 2139095040u) {
                    phi_1247_ = true;
                } else {
                    phi_1247_ = !(_e419);
                }
                let _e425 = phi_1247_;
                if (_e412 > 0.5f) {
                    phi_1252_ = 1f;
                } else {
                    phi_1252_ = 0f;
                }
                let _e428 = phi_1252_;
                phi_1255_ = evaluate_Verdict(_e428, _e425);
            } else {
                phi_1255_ = evaluate_Verdict(1f, true);
            }
            let _e432 = phi_1255_;
            phi_1256_ = _e432;
        }
        let _e434 = phi_1256_;
        visibility.member[_e57.first_primitive] = _e434.visibility;
        phi_1260_ = _e434.is_doubted;
        phi_1261_ = _e57.first_primitive;
    } else {
        phi_1260_ = false;
        phi_1261_ = 0u;
    }
    let _e439 = phi_1260_;
    let _e441 = phi_1261_;
    if _e439 {
        let _e443 = atomicAdd((&shared_[0u]), 1u);
        phi_1267_ = _e443;
    } else {
        phi_1267_ = 0u;
    }
    let _e445 = phi_1267_;
    workgroupBarrier();
    if (_e42 == 0u) {
        let _e449 = atomicLoad((&shared_[0u]));
        let _e450 = atomicAdd((&list.member[3u]), _e449);
        atomicStore((&shared_[1u]), _e450);
    }
    workgroupBarrier();
    if _e439 {
        let _e453 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e453) + _e445)]), _e441);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
