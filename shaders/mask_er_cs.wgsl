struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    layers_behind: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    grid: vec2<u32>,
}

struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct abi_MaskParams {
    current: abi_CameraParams,
    previous: abi_CameraParams,
    light: abi_LightParams,
    still: vec2<u32>,
    moving: vec2<u32>,
    frame: u32,
    flags: u32,
    depth_tolerance: f32,
    refresh: u32,
    expansion: u32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_8 {
    member: abi_MaskParams,
}

struct type_12 {
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

struct type_23 {
    member: array<abi_Sample>,
}

struct type_27 {
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

struct mask_Masked {
    visibility: f32,
    bits: u32,
    needs_ray: bool,
}

struct lt_mask_Neighbourhood {
    any_expands: bool,
    all_remove: bool,
}

struct type_42 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> p: type_8;
var<private> local_1: u32;
@group(0) @binding(1) 
var<storage> samples: type_23;
@group(0) @binding(2) 
var<storage> heard: type_12;
@group(0) @binding(3) 
var<storage, read_write> bits: type_12;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_27;
@group(0) @binding(5) 
var<storage, read_write> list: type_42;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_642_: lt_bvh_traverse_Tree;
    var phi_643_: bool;
    var phi_644_: lt_bvh_traverse_Tree;
    var phi_645_: bool;
    var phi_650_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_642_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_643_ = false;
        } else {
            phi_642_ = lt_bvh_traverse_Tree();
            phi_643_ = true;
        }
        let _e47 = phi_642_;
        let _e49 = phi_643_;
        phi_644_ = _e47;
        phi_645_ = _e49;
    } else {
        phi_644_ = lt_bvh_traverse_Tree();
        phi_645_ = true;
    }
    let _e51 = phi_644_;
    let _e53 = phi_645_;
    if _e53 {
        phi_650_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_650_ = _e51;
    }
    let _e58 = phi_650_;
    return lt_bvh_traverse_Tree(_e58.root, _e58.first_primitive);
}

fn function_() {
    var phi_162_: u32;
    var phi_196_: bool;
    var phi_197_: bool;
    var phi_198_: bool;
    var phi_199_: bool;
    var phi_203_: bool;
    var phi_273_: bool;
    var phi_274_: bool;
    var phi_285_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_286_: bool;
    var phi_287_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_288_: bool;
    var phi_295_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_299_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_312_: bool;
    var phi_326_: bool;
    var phi_365_: lt_mask_Neighbourhood;
    var phi_366_: lt_mask_Neighbourhood;
    var phi_367_: lt_mask_Neighbourhood;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_422_: bool;
    var phi_423_: bool;
    var phi_424_: bool;
    var phi_428_: bool;
    var phi_450_: bool;
    var phi_451_: bool;
    var phi_464_: bool;
    var phi_465_: bool;
    var phi_466_: bool;
    var phi_473_: u32;
    var phi_474_: u32;
    var phi_475_: u32;
    var phi_476_: u32;
    var phi_477_: u32;
    var phi_478_: u32;
    var phi_479_: u32;
    var phi_491_: bool;
    var phi_492_: bool;
    var phi_493_: bool;
    var phi_494_: bool;
    var phi_498_: bool;
    var phi_504_: bool;
    var phi_512_: u32;
    var phi_517_: u32;
    var phi_526_: u32;
    var phi_531_: u32;
    var phi_535_: u32;
    var phi_536_: u32;
    var phi_537_: u32;
    var phi_541_: f32;
    var phi_543_: mask_Masked;
    var phi_593_: bool;
    var phi_594_: u32;
    var phi_605_: u32;

    let _e34 = id_1;
    let _e35 = local_1;
    let _e47 = p.member.current.size[0u];
    let _e49 = p.member.current.size[1u];
    let _e50 = lt_shaders_entry_pixel_index(_e34, _e47, _e49);
    if (bitcast<i32>(_e50.root) != 0i) {
        let _e58 = p.member.current.size[0u];
        if (32u == 0u) {
            return;
        }
        let _e60 = (_e58 / 32u);
        if (32u == 0u) {
            return;
        }
        if ((_e58 % 32u) > 0u) {
            phi_162_ = (_e60 + 1u);
        } else {
            phi_162_ = _e60;
        }
        let _e66 = phi_162_;
        let _e71 = visibility.member[_e50.first_primitive];
        let _e77 = samples.member[_e50.first_primitive].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[_e50.first_primitive].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[_e50.first_primitive].normal[2u];
                let _e89 = global[2u];
                phi_196_ = (_e87 == _e89);
                phi_197_ = false;
            } else {
                phi_196_ = bool();
                phi_197_ = true;
            }
            let _e92 = phi_196_;
            let _e94 = phi_197_;
            phi_198_ = _e92;
            phi_199_ = _e94;
        } else {
            phi_198_ = bool();
            phi_199_ = true;
        }
        let _e96 = phi_198_;
        let _e98 = phi_199_;
        if _e98 {
            phi_203_ = false;
        } else {
            phi_203_ = _e96;
        }
        let _e100 = phi_203_;
        if !(_e100) {
            let _e103 = samples.member[_e50.first_primitive].position;
            let _e105 = p.member.light.place;
            let _e111 = p.member.light.place[3u];
            let _e118 = (_e105.x - (_e103.x * _e111));
            let _e119 = (_e105.y - (_e103.y * _e111));
            let _e120 = (_e105.z - (_e103.z * _e111));
            let _e122 = samples.member[_e50.first_primitive].normal;
            if ((((_e122.x * _e118) + (_e122.y * _e119)) + (_e122.z * _e120)) > 0f) {
                let _e136 = (((_e118 * _e118) + (_e119 * _e119)) + (_e120 * _e120));
                let _e138 = p.member.light.axis;
                let _e150 = p.member.light.place[3u];
                if (_e150 == 0f) {
                    phi_274_ = true;
                } else {
                    let _e153 = p.member.light.range_squared;
                    if (_e136 <= _e153) {
                        let _e156 = p.member.light.cos_outer;
                        phi_273_ = (-((((_e118 * _e138.x) + (_e119 * _e138.y)) + (_e120 * _e138.z))) >= (_e156 * sqrt(_e136)));
                    } else {
                        phi_273_ = false;
                    }
                    let _e161 = phi_273_;
                    phi_274_ = _e161;
                }
                let _e163 = phi_274_;
                if _e163 {
                    let _e165 = samples.member[_e50.first_primitive].flags;
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
                    phi_285_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, ((_e165 & 1u) == 0u));
                    phi_286_ = false;
                } else {
                    phi_285_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_286_ = true;
                }
                let _e184 = phi_285_;
                let _e186 = phi_286_;
                phi_287_ = _e184;
                phi_288_ = _e186;
            } else {
                phi_287_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_288_ = true;
            }
            let _e188 = phi_287_;
            let _e190 = phi_288_;
            if _e190 {
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                phi_295_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, true);
            } else {
                phi_295_ = _e188;
            }
            let _e207 = phi_295_;
            phi_299_ = _e207;
        } else {
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
            phi_299_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
        }
        let _e224 = phi_299_;
        if _e224.unnamed_1 {
            phi_543_ = mask_Masked(_e224.unnamed.visibility, 0u, false);
        } else {
            let _e229 = (_e71 < 0.5f);
            if (_e71 > 0f) {
                phi_312_ = (_e71 < 1f);
            } else {
                phi_312_ = false;
            }
            let _e233 = phi_312_;
            let _e235 = p.member.flags;
            let _e237 = ((_e235 & 1u) != 0u);
            let _e238 = lt_mask_Neighbourhood(false, true);
            if _e233 {
                phi_326_ = false;
            } else {
                phi_326_ = true;
            }
            let _e240 = phi_326_;
            if _e240 {
                if _e237 {
                    if ((0u & 2u) != 0u) {
                        phi_365_ = _e238;
                    } else {
                        let _e252 = ((((_e34.y * _e66) + (_e34.x / 32u)) * 6u) + (select(0u, 1u, _e229) | (select(0u, 1u, false) << bitcast<u32>(1i))));
                        if (_e252 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e256 = heard.member[(0u + _e252)];
                        let _e262 = (((_e256 >> bitcast<u32>(((_e34.x % 32u) & 31u))) & 1u) != 0u);
                        phi_365_ = lt_mask_Neighbourhood(_e262, !(_e262));
                    }
                    let _e266 = phi_365_;
                    phi_366_ = _e266;
                } else {
                    phi_366_ = _e238;
                }
                let _e268 = phi_366_;
                phi_367_ = _e268;
            } else {
                phi_367_ = _e238;
            }
            let _e270 = phi_367_;
            let _e273 = p.member.frame;
            let _e275 = p.member.refresh;
            if (_e275 == 0u) {
                phi_400_ = false;
            } else {
                if (_e275 == 0u) {
                    return;
                }
                let _e284 = ((_e34.x + (_e34.y * (((_e275 * 5u) / 8u) | 1u))) + (_e273 % _e275));
                if (_e275 == 0u) {
                    phi_399_ = (_e284 == 0u);
                } else {
                    if (_e275 == 0u) {
                        return;
                    }
                    phi_399_ = ((_e284 % _e275) == 0u);
                }
                let _e291 = phi_399_;
                phi_400_ = _e291;
            }
            let _e293 = phi_400_;
            if _e237 {
                if _e293 {
                    phi_422_ = bool();
                } else {
                    phi_422_ = ((0u & 2u) != 0u);
                }
                let _e299 = phi_422_;
                phi_423_ = _e299;
                phi_424_ = _e293;
            } else {
                phi_423_ = bool();
                phi_424_ = true;
            }
            let _e301 = phi_423_;
            let _e303 = phi_424_;
            if _e303 {
                phi_428_ = false;
            } else {
                phi_428_ = _e301;
            }
            let _e305 = phi_428_;
            if _e305 {
                phi_479_ = 7u;
            } else {
                if (_e71 != 0.5f) {
                    if _e237 {
                        if _e293 {
                            phi_476_ = 6u;
                        } else {
                            if _e233 {
                                phi_451_ = true;
                            } else {
                                if _e270.any_expands {
                                    phi_450_ = false;
                                } else {
                                    phi_450_ = true;
                                }
                                let _e307 = phi_450_;
                                phi_451_ = _e307;
                            }
                            let _e309 = phi_451_;
                            if _e309 {
                                if _e233 {
                                    if false {
                                        if _e270.all_remove {
                                            phi_464_ = false;
                                        } else {
                                            phi_464_ = true;
                                        }
                                        let _e311 = phi_464_;
                                        phi_465_ = _e311;
                                    } else {
                                        phi_465_ = true;
                                    }
                                    let _e313 = phi_465_;
                                    phi_466_ = _e313;
                                } else {
                                    phi_466_ = true;
                                }
                                let _e315 = phi_466_;
                                if _e315 {
                                    if _e233 {
                                        phi_473_ = 1u;
                                    } else {
                                        phi_473_ = 0u;
                                    }
                                    let _e317 = phi_473_;
                                    phi_474_ = _e317;
                                } else {
                                    phi_474_ = 5u;
                                }
                                let _e319 = phi_474_;
                                phi_475_ = _e319;
                            } else {
                                phi_475_ = 4u;
                            }
                            let _e321 = phi_475_;
                            phi_476_ = _e321;
                        }
                        let _e323 = phi_476_;
                        phi_477_ = _e323;
                    } else {
                        phi_477_ = 3u;
                    }
                    let _e325 = phi_477_;
                    phi_478_ = _e325;
                } else {
                    phi_478_ = 2u;
                }
                let _e327 = phi_478_;
                phi_479_ = _e327;
            }
            let _e329 = phi_479_;
            if !((_e329 == 0u)) {
                if !((_e329 == 5u)) {
                    phi_491_ = !(_e305);
                    phi_492_ = false;
                } else {
                    phi_491_ = bool();
                    phi_492_ = true;
                }
                let _e336 = phi_491_;
                let _e338 = phi_492_;
                phi_493_ = _e336;
                phi_494_ = _e338;
            } else {
                phi_493_ = bool();
                phi_494_ = true;
            }
            let _e340 = phi_493_;
            let _e342 = phi_494_;
            if _e342 {
                phi_498_ = false;
            } else {
                phi_498_ = _e340;
            }
            let _e344 = phi_498_;
            if _e305 {
                phi_504_ = ((0u & 4u) != 0u);
            } else {
                phi_504_ = _e229;
            }
            let _e348 = phi_504_;
            if _e344 {
                if _e229 {
                    phi_512_ = (2u | 1u);
                } else {
                    phi_512_ = 2u;
                }
                let _e351 = phi_512_;
                if false {
                    phi_517_ = (_e351 | 4u);
                } else {
                    phi_517_ = _e351;
                }
                let _e354 = phi_517_;
                phi_537_ = _e354;
            } else {
                if (_e329 == 7u) {
                    if _e229 {
                        phi_526_ = (2u | 1u);
                    } else {
                        phi_526_ = 2u;
                    }
                    let _e358 = phi_526_;
                    if _e348 {
                        phi_531_ = (_e358 | 4u);
                    } else {
                        phi_531_ = _e358;
                    }
                    let _e361 = phi_531_;
                    phi_536_ = _e361;
                } else {
                    if _e229 {
                        phi_535_ = 1u;
                    } else {
                        phi_535_ = 0u;
                    }
                    let _e363 = phi_535_;
                    phi_536_ = _e363;
                }
                let _e365 = phi_536_;
                phi_537_ = _e365;
            }
            let _e367 = phi_537_;
            if _e348 {
                phi_541_ = 0f;
            } else {
                phi_541_ = 1f;
            }
            let _e369 = phi_541_;
            phi_543_ = mask_Masked(_e369, _e367, _e344);
        }
        let _e372 = phi_543_;
        visibility.member[_e50.first_primitive] = _e372.visibility;
        let _e377 = p.member.light.number;
        let _e378 = (_e377 * 3u);
        let _e380 = (_e378 % 32u);
        let _e382 = p.member.light.mask_words;
        let _e384 = ((_e50.first_primitive * _e382) + (_e378 / 32u));
        let _e386 = bits.member[_e384];
        bits.member[_e384] = ((_e386 & ~((7u << bitcast<u32>((_e380 & 31u))))) | (_e372.bits << bitcast<u32>((_e380 & 31u))));
        if (_e380 > 29u) {
            let _e401 = bits.member[(_e384 + 1u)];
            let _e403 = (32u - _e380);
            bits.member[(_e384 + 1u)] = ((_e401 & ~((7u >> bitcast<u32>((_e403 & 31u))))) | (_e372.bits >> bitcast<u32>((_e403 & 31u))));
        }
        phi_593_ = _e372.needs_ray;
        phi_594_ = _e50.first_primitive;
    } else {
        phi_593_ = false;
        phi_594_ = 0u;
    }
    let _e417 = phi_593_;
    let _e419 = phi_594_;
    if (_e35 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e417 {
        let _e423 = atomicAdd((&shared_[0u]), 1u);
        phi_605_ = _e423;
    } else {
        phi_605_ = 0u;
    }
    let _e425 = phi_605_;
    workgroupBarrier();
    if (_e35 == 0u) {
        let _e429 = atomicLoad((&shared_[0u]));
        let _e430 = atomicAdd((&list.member[3u]), _e429);
        atomicStore((&shared_[1u]), _e430);
    }
    workgroupBarrier();
    if _e417 {
        let _e433 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e433) + _e425)]), _e419);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
