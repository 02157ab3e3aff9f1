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

struct type_25 {
    member: array<abi_Sample>,
}

struct type_29 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_38 {
    member: array<vec4<f32>>,
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

struct type_41 {
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

struct type_48 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_25;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_41;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_29;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_48;
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(2) 
var<storage> map: type_38;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_160_: lt_bvh_traverse_Tree;
    var phi_161_: bool;
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_168_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_160_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_161_ = false;
        } else {
            phi_160_ = lt_bvh_traverse_Tree();
            phi_161_ = true;
        }
        let _e59 = phi_160_;
        let _e61 = phi_161_;
        phi_162_ = _e59;
        phi_163_ = _e61;
    } else {
        phi_162_ = lt_bvh_traverse_Tree();
        phi_163_ = true;
    }
    let _e63 = phi_162_;
    let _e65 = phi_163_;
    if _e65 {
        phi_168_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_168_ = _e63;
    }
    let _e70 = phi_168_;
    return lt_bvh_traverse_Tree(_e70.root, _e70.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_194_: bool;
    var phi_198_: f32;
    var phi_199_: f32;

    let _e47 = (*param_4);
    if ((bitcast<u32>(_e47) & 2147483647u) > 2139095040u) {
        phi_199_ = _e47;
    } else {
        if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
            phi_194_ = true;
        } else {
            let _e54 = (84f < _e47);
            if _e54 {
            }
            phi_194_ = _e54;
        }
        let _e56 = phi_194_;
        if _e56 {
            phi_198_ = 84f;
        } else {
            phi_198_ = _e47;
        }
        let _e58 = phi_198_;
        phi_199_ = _e58;
    }
    let _e60 = phi_199_;
    return _e60;
}

fn lt_shaders_evaluate_to_light(param_5: vec3<f32>, param_6: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_6.x - (param_5.x * param_6.w)), (param_6.y - (param_5.y * param_6.w)), (param_6.z - (param_5.z * param_6.w)));
}

fn lt_shaders_evaluate_quad_indices(param_7: i32, param_8: i32, param_9: u32) -> array<u32, 4> {
    var phi_227_: i32;
    var phi_232_: i32;
    var phi_237_: i32;
    var phi_242_: i32;
    var phi_251_: i32;
    var phi_256_: i32;
    var phi_261_: i32;
    var phi_266_: i32;

    let _e50 = (bitcast<i32>(param_9) - 1i);
    if (param_7 > 0i) {
        phi_227_ = param_7;
    } else {
        phi_227_ = 0i;
    }
    let _e53 = phi_227_;
    if (param_8 > 0i) {
        phi_232_ = param_8;
    } else {
        phi_232_ = 0i;
    }
    let _e56 = phi_232_;
    if (_e53 < _e50) {
        phi_237_ = _e53;
    } else {
        phi_237_ = _e50;
    }
    let _e59 = phi_237_;
    if (_e56 < _e50) {
        phi_242_ = _e56;
    } else {
        phi_242_ = _e50;
    }
    let _e62 = phi_242_;
    let _e63 = bitcast<u32>(_e59);
    let _e65 = (param_7 + 1i);
    let _e66 = (param_8 + 1i);
    if (_e65 > 0i) {
        phi_251_ = _e65;
    } else {
        phi_251_ = 0i;
    }
    let _e69 = phi_251_;
    if (_e66 > 0i) {
        phi_256_ = _e66;
    } else {
        phi_256_ = 0i;
    }
    let _e72 = phi_256_;
    if (_e69 < _e50) {
        phi_261_ = _e69;
    } else {
        phi_261_ = _e50;
    }
    let _e75 = phi_261_;
    if (_e72 < _e50) {
        phi_266_ = _e72;
    } else {
        phi_266_ = _e50;
    }
    let _e78 = phi_266_;
    let _e79 = bitcast<u32>(_e75);
    let _e81 = (bitcast<u32>(_e62) * param_9);
    let _e82 = (bitcast<u32>(_e78) * param_9);
    return array<u32, 4>((_e81 + _e63), (_e81 + _e79), (_e82 + _e63), (_e82 + _e79));
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_10: ptr<function, f32>, param_11: vec4<f32>, param_12: f32) -> f32 {
    var phi_294_: f32;
    var phi_295_: f32;
    var phi_296_: f32;
    var phi_323_: bool;
    var phi_327_: f32;
    var phi_328_: f32;
    var phi_345_: bool;
    var phi_349_: f32;
    var phi_350_: f32;
    var phi_391_: f32;
    var phi_407_: f32;
    var phi_408_: f32;
    var phi_409_: f32;

    if ((bitcast<u32>(param_12) & 2147483647u) > 2139095040u) {
        phi_296_ = param_12;
    } else {
        if (param_12 < 0f) {
            phi_295_ = 0f;
        } else {
            if (param_12 > 1f) {
                phi_294_ = 1f;
            } else {
                phi_294_ = param_12;
            }
            let _e55 = phi_294_;
            phi_295_ = _e55;
        }
        let _e57 = phi_295_;
        phi_296_ = _e57;
    }
    let _e59 = phi_296_;
    let _e61 = _lt_math_esm_Esm_clamped_exponent(param_10);
    let _e63 = (_e61 * (1f - _e59));
    if ((bitcast<u32>(_e63) & 2147483647u) > 2139095040u) {
        phi_391_ = _e63;
    } else {
        if ((bitcast<u32>(_e63) & 2147483647u) > 2139095040u) {
            phi_328_ = _e63;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_323_ = true;
            } else {
                let _e73 = (-87f > _e63);
                if _e73 {
                }
                phi_323_ = _e73;
            }
            let _e75 = phi_323_;
            if _e75 {
                phi_327_ = -87f;
            } else {
                phi_327_ = _e63;
            }
            let _e77 = phi_327_;
            phi_328_ = _e77;
        }
        let _e79 = phi_328_;
        if ((bitcast<u32>(_e79) & 2147483647u) > 2139095040u) {
            phi_350_ = _e79;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_345_ = true;
            } else {
                let _e86 = (88f < _e79);
                if _e86 {
                }
                phi_345_ = _e86;
            }
            let _e88 = phi_345_;
            if _e88 {
                phi_349_ = 88f;
            } else {
                phi_349_ = _e79;
            }
            let _e90 = phi_349_;
            phi_350_ = _e90;
        }
        let _e92 = phi_350_;
        let _e95 = floor(((_e92 * 1.442695f) + 0.5f));
        let _e99 = ((_e92 - (_e95 * 0.69314575f)) - (_e95 * 0.0000014286068f));
        phi_391_ = ((((((((((((((((1f / 5040f) * _e99) + (1f / 720f)) * _e99) + (1f / 120f)) * _e99) + (1f / 24f)) * _e99) + (1f / 6f)) * _e99) + 0.5f) * _e99) + 1f) * _e99) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e95), i32(-2147483648), (_e95 < bitcast<f32>(3472883712u))), 2147483647i, (_e95 > bitcast<f32>(1325400063u))), (_e95 == _e95)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e135 = phi_391_;
    let _e136 = (param_11.x * _e135);
    if ((bitcast<u32>(_e136) & 2147483647u) > 2139095040u) {
        phi_409_ = _e136;
    } else {
        if (_e136 < 0f) {
            phi_408_ = 0f;
        } else {
            if (_e136 > 1f) {
                phi_407_ = 1f;
            } else {
                phi_407_ = _e136;
            }
            let _e143 = phi_407_;
            phi_408_ = _e143;
        }
        let _e145 = phi_408_;
        phi_409_ = _e145;
    }
    let _e147 = phi_409_;
    return _e147;
}

fn function_() {
    var local_1: f32;
    var phi_463_: bool;
    var phi_464_: bool;
    var phi_465_: bool;
    var phi_466_: bool;
    var phi_470_: bool;
    var phi_505_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_509_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_602_: bool;
    var phi_603_: bool;
    var phi_604_: bool;
    var phi_605_: bool;
    var phi_606_: bool;
    var phi_607_: bool;
    var phi_608_: bool;
    var phi_609_: bool;
    var phi_610_: bool;
    var phi_611_: bool;
    var phi_612_: bool;
    var phi_613_: bool;
    var phi_617_: bool;
    var phi_762_: bool;
    var phi_770_: bool;
    var phi_775_: f32;
    var phi_778_: evaluate_Verdict;
    var phi_779_: evaluate_Verdict;
    var phi_783_: bool;
    var phi_784_: u32;
    var phi_790_: u32;

    let _e47 = id_1;
    let _e48 = local_2;
    let _e53 = arrayLength((&map.member));
    if (_e48 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e60 = p.member.size[0u];
    let _e62 = p.member.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e47, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        let _e70 = p.member.light;
        let _e73 = samples.member[_e63.first_primitive].normal[0u];
        let _e75 = global[0u];
        if (_e73 == _e75) {
            let _e78 = samples.member[_e63.first_primitive].normal[1u];
            let _e80 = global[1u];
            if (_e78 == _e80) {
                let _e83 = samples.member[_e63.first_primitive].normal[2u];
                let _e85 = global[2u];
                phi_463_ = (_e83 == _e85);
                phi_464_ = false;
            } else {
                phi_463_ = bool();
                phi_464_ = true;
            }
            let _e88 = phi_463_;
            let _e90 = phi_464_;
            phi_465_ = _e88;
            phi_466_ = _e90;
        } else {
            phi_465_ = bool();
            phi_466_ = true;
        }
        let _e92 = phi_465_;
        let _e94 = phi_466_;
        if _e94 {
            phi_470_ = false;
        } else {
            phi_470_ = _e92;
        }
        let _e96 = phi_470_;
        if !(_e96) {
            let _e99 = samples.member[_e63.first_primitive].normal;
            let _e101 = samples.member[_e63.first_primitive].position;
            let _e102 = lt_shaders_evaluate_to_light(_e101, _e70);
            if ((((_e99.x * _e102.x) + (_e99.y * _e102.y)) + (_e99.z * _e102.z)) > 0f) {
                let _e116 = samples.member[_e63.first_primitive].flags;
                let _e124 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e130 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e124.unnamed.visibility, false), _e124.unnamed_1);
                phi_505_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e130.unnamed, ((_e116 & 1u) == 0u));
            } else {
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e139.unnamed.visibility, false), _e139.unnamed_1);
                phi_505_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e145.unnamed, true);
            }
            let _e150 = phi_505_;
            phi_509_ = _e150;
        } else {
            let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e162 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e156.unnamed.visibility, false), _e156.unnamed_1);
            phi_509_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e162.unnamed, true);
        }
        let _e167 = phi_509_;
        if _e167.unnamed_1 {
            phi_779_ = evaluate_Verdict(_e167.unnamed.visibility, _e167.unnamed.is_doubted);
        } else {
            let _e175 = samples.member[_e63.first_primitive].position;
            let _e181 = p.member.projection.row_w;
            let _e192 = ((((_e181.x * _e175.x) + (_e181.y * _e175.y)) + (_e181.z * _e175.z)) + (_e181.w * 1f));
            let _e194 = p.member.projection.row_x;
            let _e206 = (((((_e194.x * _e175.x) + (_e194.y * _e175.y)) + (_e194.z * _e175.z)) + (_e194.w * 1f)) / _e192);
            let _e208 = p.member.projection.row_y;
            let _e220 = (((((_e208.x * _e175.x) + (_e208.y * _e175.y)) + (_e208.z * _e175.z)) + (_e208.w * 1f)) / _e192);
            let _e222 = p.member.projection.row_z;
            let _e233 = ((((_e222.x * _e175.x) + (_e222.y * _e175.y)) + (_e222.z * _e175.z)) + (_e222.w * 1f));
            if (_e192 > 0f) {
                if (_e206 >= 0f) {
                    if (_e206 <= 1f) {
                        if (_e220 >= 0f) {
                            if (_e220 <= 1f) {
                                if (_e233 >= 0f) {
                                    phi_602_ = (_e233 <= 1f);
                                    phi_603_ = false;
                                } else {
                                    phi_602_ = bool();
                                    phi_603_ = true;
                                }
                                let _e242 = phi_602_;
                                let _e244 = phi_603_;
                                phi_604_ = _e242;
                                phi_605_ = _e244;
                            } else {
                                phi_604_ = bool();
                                phi_605_ = true;
                            }
                            let _e246 = phi_604_;
                            let _e248 = phi_605_;
                            phi_606_ = _e246;
                            phi_607_ = _e248;
                        } else {
                            phi_606_ = bool();
                            phi_607_ = true;
                        }
                        let _e250 = phi_606_;
                        let _e252 = phi_607_;
                        phi_608_ = _e250;
                        phi_609_ = _e252;
                    } else {
                        phi_608_ = bool();
                        phi_609_ = true;
                    }
                    let _e254 = phi_608_;
                    let _e256 = phi_609_;
                    phi_610_ = _e254;
                    phi_611_ = _e256;
                } else {
                    phi_610_ = bool();
                    phi_611_ = true;
                }
                let _e258 = phi_610_;
                let _e260 = phi_611_;
                phi_612_ = _e258;
                phi_613_ = _e260;
            } else {
                phi_612_ = bool();
                phi_613_ = true;
            }
            let _e262 = phi_612_;
            let _e264 = phi_613_;
            if _e264 {
                phi_617_ = false;
            } else {
                phi_617_ = _e262;
            }
            let _e266 = phi_617_;
            if _e266 {
                let _e268 = p.member.map_size;
                let _e269 = f32(_e268);
                let _e272 = ((_e206 * _e269) - 0.5f);
                let _e273 = ((_e220 * _e269) - 0.5f);
                let _e274 = floor(_e272);
                let _e275 = floor(_e273);
                let _e276 = (_e272 - _e274);
                let _e277 = (_e273 - _e275);
                let _e298 = ((1f - _e276) * (1f - _e277));
                let _e300 = (_e276 * (1f - _e277));
                let _e302 = ((1f - _e276) * _e277);
                let _e303 = (_e276 * _e277);
                let _e305 = p.member.test;
                let _e306 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e305);
                let _e308 = p.member.map_size;
                local_1 = _e306;
                let _e309 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e274), i32(-2147483648), (_e274 < bitcast<f32>(3472883712u))), 2147483647i, (_e274 > bitcast<f32>(1325400063u))), (_e274 == _e274)), select(0i, select(select(i32(_e275), i32(-2147483648), (_e275 < bitcast<f32>(3472883712u))), 2147483647i, (_e275 > bitcast<f32>(1325400063u))), (_e275 == _e275)), _e308);
                if (_e309[0] < _e53) {
                } else {
                    return;
                }
                let _e314 = map.member[(0u + _e309[0])];
                if (_e309[1] < _e53) {
                } else {
                    return;
                }
                let _e327 = map.member[(0u + _e309[1])];
                if (_e309[2] < _e53) {
                } else {
                    return;
                }
                let _e344 = map.member[(0u + _e309[2])];
                if (_e309[3] < _e53) {
                } else {
                    return;
                }
                let _e361 = map.member[(0u + _e309[3])];
                let _e375 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e314.x * _e298) + (_e327.x * _e300)) + (_e344.x * _e302)) + (_e361.x * _e303)), ((((_e314.y * _e298) + (_e327.y * _e300)) + (_e344.y * _e302)) + (_e361.y * _e303)), ((((_e314.z * _e298) + (_e327.z * _e300)) + (_e344.z * _e302)) + (_e361.z * _e303)), ((((_e314.w * _e298) + (_e327.w * _e300)) + (_e344.w * _e302)) + (_e361.w * _e303))), _e233);
                let _e377 = p.member.epsilon;
                if (_e375 <= _e377) {
                    phi_762_ = true;
                } else {
                    phi_762_ = (_e375 >= (1f - _e377));
                }
                let _e382 = phi_762_;
                if ((bitcast<u32>(_e375) & 2147483647u) > 2139095040u) {
                    phi_770_ = true;
                } else {
                    phi_770_ = !(_e382);
                }
                let _e388 = phi_770_;
                if (_e375 > 0.5f) {
                    phi_775_ = 1f;
                } else {
                    phi_775_ = 0f;
                }
                let _e391 = phi_775_;
                phi_778_ = evaluate_Verdict(_e391, _e388);
            } else {
                phi_778_ = evaluate_Verdict(1f, true);
            }
            let _e395 = phi_778_;
            phi_779_ = _e395;
        }
        let _e397 = phi_779_;
        visibility.member[_e63.first_primitive] = _e397.visibility;
        phi_783_ = _e397.is_doubted;
        phi_784_ = _e63.first_primitive;
    } else {
        phi_783_ = false;
        phi_784_ = 0u;
    }
    let _e402 = phi_783_;
    let _e404 = phi_784_;
    if _e402 {
        let _e406 = atomicAdd((&shared_[0u]), 1u);
        phi_790_ = _e406;
    } else {
        phi_790_ = 0u;
    }
    let _e408 = phi_790_;
    workgroupBarrier();
    if (_e48 == 0u) {
        let _e412 = atomicLoad((&shared_[0u]));
        let _e413 = atomicAdd((&list.member[3u]), _e412);
        atomicStore((&shared_[1u]), _e413);
    }
    workgroupBarrier();
    if _e402 {
        let _e416 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e416) + _e408)]), _e404);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
