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

struct lt_mask_Reprojection {
    pixel: vec2<u32>,
    is_valid: bool,
    has_moved: bool,
}

struct lt_mask_Neighbourhood {
    any_expands: bool,
    all_remove: bool,
}

struct type_43 {
    member: array<vec4<f32>>,
}

struct type_48 {
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
var<storage, read_write> list: type_48;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(6) 
var<storage> past: type_43;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_163_: lt_bvh_traverse_Tree;
    var phi_164_: bool;
    var phi_165_: lt_bvh_traverse_Tree;
    var phi_166_: bool;
    var phi_171_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_163_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_164_ = false;
        } else {
            phi_163_ = lt_bvh_traverse_Tree();
            phi_164_ = true;
        }
        let _e62 = phi_163_;
        let _e64 = phi_164_;
        phi_165_ = _e62;
        phi_166_ = _e64;
    } else {
        phi_165_ = lt_bvh_traverse_Tree();
        phi_166_ = true;
    }
    let _e66 = phi_165_;
    let _e68 = phi_166_;
    if _e68 {
        phi_171_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_171_ = _e66;
    }
    let _e73 = phi_171_;
    return lt_bvh_traverse_Tree(_e73.root, _e73.first_primitive);
}

fn function_() {
    var phi_217_: u32;
    var phi_254_: bool;
    var phi_255_: bool;
    var phi_256_: bool;
    var phi_257_: bool;
    var phi_261_: bool;
    var phi_331_: bool;
    var phi_332_: bool;
    var phi_343_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_344_: bool;
    var phi_345_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_346_: bool;
    var phi_353_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_357_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_370_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_401_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_542_: f32;
    var phi_547_: f32;
    var phi_548_: bool;
    var phi_549_: f32;
    var phi_550_: bool;
    var phi_554_: f32;
    var phi_575_: f32;
    var phi_580_: f32;
    var phi_581_: bool;
    var phi_582_: f32;
    var phi_583_: bool;
    var phi_587_: f32;
    var phi_608_: bool;
    var phi_627_: vec2<u32>;
    var phi_628_: bool;
    var phi_629_: bool;
    var phi_630_: bool;
    var phi_631_: vec2<u32>;
    var phi_632_: bool;
    var phi_633_: bool;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_636_: bool;
    var phi_637_: bool;
    var phi_638_: vec2<u32>;
    var phi_639_: bool;
    var phi_640_: bool;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_643_: bool;
    var phi_644_: bool;
    var phi_645_: vec2<u32>;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_665_: bool;
    var phi_666_: bool;
    var phi_667_: vec2<u32>;
    var phi_702_: bool;
    var phi_704_: lt_mask_Reprojection;
    var phi_705_: lt_mask_Reprojection;
    var phi_706_: bool;
    var phi_710_: bool;
    var phi_711_: lt_mask_Reprojection;
    var phi_712_: lt_mask_Reprojection;
    var phi_713_: bool;
    var phi_721_: bool;
    var phi_722_: lt_mask_Reprojection;
    var phi_788_: u32;
    var phi_793_: u32;
    var phi_794_: u32;
    var phi_795_: u32;
    var phi_796_: bool;
    var phi_797_: u32;
    var phi_798_: bool;
    var phi_799_: bool;
    var phi_800_: u32;
    var phi_801_: bool;
    var phi_802_: bool;
    var phi_806_: bool;
    var phi_810_: u32;
    var phi_815_: bool;
    var phi_855_: lt_mask_Neighbourhood;
    var phi_856_: lt_mask_Neighbourhood;
    var phi_857_: lt_mask_Neighbourhood;
    var phi_889_: bool;
    var phi_890_: bool;
    var phi_912_: bool;
    var phi_913_: bool;
    var phi_914_: bool;
    var phi_918_: bool;
    var phi_940_: bool;
    var phi_941_: bool;
    var phi_954_: bool;
    var phi_955_: bool;
    var phi_956_: bool;
    var phi_963_: u32;
    var phi_964_: u32;
    var phi_965_: u32;
    var phi_966_: u32;
    var phi_967_: u32;
    var phi_968_: u32;
    var phi_969_: u32;
    var phi_981_: bool;
    var phi_982_: bool;
    var phi_983_: bool;
    var phi_984_: bool;
    var phi_988_: bool;
    var phi_994_: bool;
    var phi_1002_: u32;
    var phi_1007_: u32;
    var phi_1016_: u32;
    var phi_1021_: u32;
    var phi_1025_: u32;
    var phi_1026_: u32;
    var phi_1027_: u32;
    var phi_1031_: f32;
    var phi_1033_: mask_Masked;
    var phi_1083_: bool;
    var phi_1084_: u32;
    var phi_1095_: u32;

    let _e49 = id_1;
    let _e50 = local_1;
    let _e55 = arrayLength((&heard.member));
    let _e63 = p.member.current.size[0u];
    let _e65 = p.member.current.size[1u];
    let _e66 = lt_shaders_entry_pixel_index(_e49, _e63, _e65);
    if (bitcast<i32>(_e66.root) != 0i) {
        let _e74 = p.member.current.size[0u];
        if (32u == 0u) {
            return;
        }
        let _e76 = (_e74 / 32u);
        if (32u == 0u) {
            return;
        }
        if ((_e74 % 32u) > 0u) {
            phi_217_ = (_e76 + 1u);
        } else {
            phi_217_ = _e76;
        }
        let _e82 = phi_217_;
        let _e85 = past.member[_e66.first_primitive];
        let _e90 = visibility.member[_e66.first_primitive];
        let _e96 = samples.member[_e66.first_primitive].normal[0u];
        let _e98 = global[0u];
        if (_e96 == _e98) {
            let _e101 = samples.member[_e66.first_primitive].normal[1u];
            let _e103 = global[1u];
            if (_e101 == _e103) {
                let _e106 = samples.member[_e66.first_primitive].normal[2u];
                let _e108 = global[2u];
                phi_254_ = (_e106 == _e108);
                phi_255_ = false;
            } else {
                phi_254_ = bool();
                phi_255_ = true;
            }
            let _e111 = phi_254_;
            let _e113 = phi_255_;
            phi_256_ = _e111;
            phi_257_ = _e113;
        } else {
            phi_256_ = bool();
            phi_257_ = true;
        }
        let _e115 = phi_256_;
        let _e117 = phi_257_;
        if _e117 {
            phi_261_ = false;
        } else {
            phi_261_ = _e115;
        }
        let _e119 = phi_261_;
        if !(_e119) {
            let _e122 = samples.member[_e66.first_primitive].position;
            let _e124 = p.member.light.place;
            let _e130 = p.member.light.place[3u];
            let _e137 = (_e124.x - (_e122.x * _e130));
            let _e138 = (_e124.y - (_e122.y * _e130));
            let _e139 = (_e124.z - (_e122.z * _e130));
            let _e141 = samples.member[_e66.first_primitive].normal;
            if ((((_e141.x * _e137) + (_e141.y * _e138)) + (_e141.z * _e139)) > 0f) {
                let _e155 = (((_e137 * _e137) + (_e138 * _e138)) + (_e139 * _e139));
                let _e157 = p.member.light.axis;
                let _e169 = p.member.light.place[3u];
                if (_e169 == 0f) {
                    phi_332_ = true;
                } else {
                    let _e172 = p.member.light.range_squared;
                    if (_e155 <= _e172) {
                        let _e175 = p.member.light.cos_outer;
                        phi_331_ = (-((((_e137 * _e157.x) + (_e138 * _e157.y)) + (_e139 * _e157.z))) >= (_e175 * sqrt(_e155)));
                    } else {
                        phi_331_ = false;
                    }
                    let _e180 = phi_331_;
                    phi_332_ = _e180;
                }
                let _e182 = phi_332_;
                if _e182 {
                    let _e184 = samples.member[_e66.first_primitive].flags;
                    let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e198 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e192.unnamed.visibility, false), _e192.unnamed_1);
                    phi_343_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e198.unnamed, ((_e184 & 1u) == 0u));
                    phi_344_ = false;
                } else {
                    phi_343_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_344_ = true;
                }
                let _e203 = phi_343_;
                let _e205 = phi_344_;
                phi_345_ = _e203;
                phi_346_ = _e205;
            } else {
                phi_345_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_346_ = true;
            }
            let _e207 = phi_345_;
            let _e209 = phi_346_;
            if _e209 {
                let _e215 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e215.unnamed.visibility, false), _e215.unnamed_1);
                phi_353_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e221.unnamed, true);
            } else {
                phi_353_ = _e207;
            }
            let _e226 = phi_353_;
            phi_357_ = _e226;
        } else {
            let _e232 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e238 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e232.unnamed.visibility, false), _e232.unnamed_1);
            phi_357_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e238.unnamed, true);
        }
        let _e243 = phi_357_;
        if _e243.unnamed_1 {
            phi_1033_ = mask_Masked(_e243.unnamed.visibility, 0u, false);
        } else {
            let _e248 = (_e90 < 0.5f);
            if (_e90 > 0f) {
                phi_370_ = (_e90 < 1f);
            } else {
                phi_370_ = false;
            }
            let _e252 = phi_370_;
            let _e259 = lt_mask_Reprojection(vec2<u32>(_e49.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e266 = lt_mask_Reprojection(vec2<u32>(_e259.pixel.x, _e49.y), _e259.is_valid, _e259.has_moved);
            let _e270 = lt_mask_Reprojection(_e266.pixel, true, _e266.has_moved);
            let _e276 = p.member.flags;
            if ((_e276 & 16u) == 0u) {
                phi_406_ = false;
            } else {
                let _e281 = samples.member[_e66.first_primitive].position[0u];
                if (_e85.x == _e281) {
                    let _e284 = samples.member[_e66.first_primitive].position[1u];
                    if (_e85.y == _e284) {
                        let _e287 = samples.member[_e66.first_primitive].position[2u];
                        phi_398_ = (_e85.z == _e287);
                        phi_399_ = false;
                    } else {
                        phi_398_ = bool();
                        phi_399_ = true;
                    }
                    let _e290 = phi_398_;
                    let _e292 = phi_399_;
                    phi_400_ = _e290;
                    phi_401_ = _e292;
                } else {
                    phi_400_ = bool();
                    phi_401_ = true;
                }
                let _e294 = phi_400_;
                let _e296 = phi_401_;
                if _e296 {
                    phi_405_ = false;
                } else {
                    phi_405_ = _e294;
                }
                let _e298 = phi_405_;
                phi_406_ = _e298;
            }
            let _e300 = phi_406_;
            if _e300 {
                phi_711_ = lt_mask_Reprojection(_e270.pixel, _e270.is_valid, false);
                phi_712_ = lt_mask_Reprojection();
                phi_713_ = true;
            } else {
                let _e304 = p.member.current.grid[0u];
                let _e306 = p.member.current.grid[1u];
                let _e320 = (f32(_e49.x) + ((f32((_e49.y & (_e306 - 1u))) + 0.5f) / f32(_e306)));
                let _e322 = (f32(_e49.y) + ((f32((_e49.x & (_e304 - 1u))) + 0.5f) / f32(_e304)));
                let _e325 = p.member.previous.eye;
                let _e327 = (_e85.x - _e325.x);
                let _e329 = (_e85.y - _e325.y);
                let _e331 = (_e85.z - _e325.z);
                let _e333 = p.member.previous.forward;
                let _e341 = (((_e327 * _e333.x) + (_e329 * _e333.y)) + (_e331 * _e333.z));
                let _e343 = p.member.previous.right;
                let _e353 = p.member.previous.right;
                let _e368 = p.member.previous.up;
                let _e378 = p.member.previous.up;
                let _e395 = p.member.previous.size[0u];
                let _e402 = p.member.previous.size[1u];
                let _e406 = (((((((_e327 * _e343.x) + (_e329 * _e343.y)) + (_e331 * _e343.z)) / ((((_e353.x * _e353.x) + (_e353.y * _e353.y)) + (_e353.z * _e353.z)) * _e341)) + 1f) * (0.5f * f32(_e395))) - _e320);
                let _e407 = (((1f - ((((_e327 * _e368.x) + (_e329 * _e368.y)) + (_e331 * _e368.z)) / ((((_e378.x * _e378.x) + (_e378.y * _e378.y)) + (_e378.z * _e378.z)) * _e341))) * (0.5f * f32(_e402))) - _e322);
                let _e411 = p.member.current.size[0u];
                let _e413 = p.member.current.size[1u];
                let _e415 = (_e320 + _e406);
                if (_e415 > -8388608f) {
                    let _e427 = f32(select(0i, select(select(i32(_e415), i32(-2147483648), (_e415 < bitcast<f32>(3472883712u))), 2147483647i, (_e415 > bitcast<f32>(1325400063u))), (_e415 == _e415)));
                    if (_e427 > _e415) {
                        phi_542_ = 1f;
                    } else {
                        phi_542_ = 0f;
                    }
                    let _e430 = phi_542_;
                    if (_e415 < 8388608f) {
                        phi_547_ = (_e427 - _e430);
                        phi_548_ = false;
                    } else {
                        phi_547_ = f32();
                        phi_548_ = true;
                    }
                    let _e433 = phi_547_;
                    let _e435 = phi_548_;
                    phi_549_ = _e433;
                    phi_550_ = _e435;
                } else {
                    phi_549_ = f32();
                    phi_550_ = true;
                }
                let _e437 = phi_549_;
                let _e439 = phi_550_;
                if _e439 {
                    phi_554_ = _e415;
                } else {
                    phi_554_ = _e437;
                }
                let _e441 = phi_554_;
                let _e442 = (_e322 + _e407);
                if (_e442 > -8388608f) {
                    let _e454 = f32(select(0i, select(select(i32(_e442), i32(-2147483648), (_e442 < bitcast<f32>(3472883712u))), 2147483647i, (_e442 > bitcast<f32>(1325400063u))), (_e442 == _e442)));
                    if (_e454 > _e442) {
                        phi_575_ = 1f;
                    } else {
                        phi_575_ = 0f;
                    }
                    let _e457 = phi_575_;
                    if (_e442 < 8388608f) {
                        phi_580_ = (_e454 - _e457);
                        phi_581_ = false;
                    } else {
                        phi_580_ = f32();
                        phi_581_ = true;
                    }
                    let _e460 = phi_580_;
                    let _e462 = phi_581_;
                    phi_582_ = _e460;
                    phi_583_ = _e462;
                } else {
                    phi_582_ = f32();
                    phi_583_ = true;
                }
                let _e464 = phi_582_;
                let _e466 = phi_583_;
                if _e466 {
                    phi_587_ = _e442;
                } else {
                    phi_587_ = _e464;
                }
                let _e468 = phi_587_;
                if (_e441 >= 0f) {
                    if (_e468 >= 0f) {
                        if (_e441 < f32(_e411)) {
                            let _e474 = (_e468 < f32(_e413));
                            if (_e406 == 0f) {
                                phi_608_ = (_e407 == 0f);
                            } else {
                                phi_608_ = false;
                            }
                            let _e478 = phi_608_;
                            if _e474 {
                                phi_627_ = vec2<u32>(select(select(u32(_e441), 0u, (_e441 < bitcast<f32>(0u))), 4294967295u, (_e441 > bitcast<f32>(1333788671u))), select(select(u32(_e468), 0u, (_e468 < bitcast<f32>(0u))), 4294967295u, (_e468 > bitcast<f32>(1333788671u))));
                                phi_628_ = false;
                            } else {
                                phi_627_ = vec2<u32>();
                                phi_628_ = true;
                            }
                            let _e495 = phi_627_;
                            let _e497 = phi_628_;
                            phi_629_ = _e478;
                            phi_630_ = _e474;
                            phi_631_ = _e495;
                            phi_632_ = _e478;
                            phi_633_ = _e474;
                            phi_634_ = false;
                            phi_635_ = _e497;
                        } else {
                            phi_629_ = bool();
                            phi_630_ = bool();
                            phi_631_ = vec2<u32>();
                            phi_632_ = bool();
                            phi_633_ = bool();
                            phi_634_ = true;
                            phi_635_ = false;
                        }
                        let _e499 = phi_629_;
                        let _e501 = phi_630_;
                        let _e503 = phi_631_;
                        let _e505 = phi_632_;
                        let _e507 = phi_633_;
                        let _e509 = phi_634_;
                        let _e511 = phi_635_;
                        phi_636_ = _e499;
                        phi_637_ = _e501;
                        phi_638_ = _e503;
                        phi_639_ = _e505;
                        phi_640_ = _e507;
                        phi_641_ = _e509;
                        phi_642_ = _e511;
                    } else {
                        phi_636_ = bool();
                        phi_637_ = bool();
                        phi_638_ = vec2<u32>();
                        phi_639_ = bool();
                        phi_640_ = bool();
                        phi_641_ = true;
                        phi_642_ = false;
                    }
                    let _e513 = phi_636_;
                    let _e515 = phi_637_;
                    let _e517 = phi_638_;
                    let _e519 = phi_639_;
                    let _e521 = phi_640_;
                    let _e523 = phi_641_;
                    let _e525 = phi_642_;
                    phi_643_ = _e513;
                    phi_644_ = _e515;
                    phi_645_ = _e517;
                    phi_646_ = _e519;
                    phi_647_ = _e521;
                    phi_648_ = _e523;
                    phi_649_ = _e525;
                } else {
                    phi_643_ = bool();
                    phi_644_ = bool();
                    phi_645_ = vec2<u32>();
                    phi_646_ = bool();
                    phi_647_ = bool();
                    phi_648_ = true;
                    phi_649_ = false;
                }
                let _e527 = phi_643_;
                let _e529 = phi_644_;
                let _e531 = phi_645_;
                let _e533 = phi_646_;
                let _e535 = phi_647_;
                let _e537 = phi_648_;
                let _e539 = phi_649_;
                if _e537 {
                    if (_e406 == 0f) {
                        phi_658_ = (_e407 == 0f);
                    } else {
                        phi_658_ = false;
                    }
                    let _e543 = phi_658_;
                    phi_659_ = _e543;
                    phi_660_ = false;
                    phi_661_ = true;
                } else {
                    phi_659_ = _e533;
                    phi_660_ = _e535;
                    phi_661_ = _e539;
                }
                let _e545 = phi_659_;
                let _e547 = phi_660_;
                let _e549 = phi_661_;
                if _e549 {
                    phi_665_ = _e545;
                    phi_666_ = _e547;
                    phi_667_ = vec2<u32>(_e49.x, _e49.y);
                } else {
                    phi_665_ = _e527;
                    phi_666_ = _e529;
                    phi_667_ = _e531;
                }
                let _e551 = phi_665_;
                let _e553 = phi_666_;
                let _e555 = phi_667_;
                let _e565 = lt_mask_Reprojection(vec2<u32>(_e555.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e572 = lt_mask_Reprojection(vec2<u32>(_e565.pixel.x, _e555.y), _e565.is_valid, _e565.has_moved);
                let _e576 = lt_mask_Reprojection(_e572.pixel, _e553, _e572.has_moved);
                let _e580 = lt_mask_Reprojection(_e576.pixel, _e576.is_valid, !(_e551));
                if _e553 {
                    let _e583 = p.member.previous.eye;
                    let _e591 = p.member.previous.forward;
                    let _e600 = (((((_e85.x - _e583.x) * _e591.x) + ((_e85.y - _e583.y) * _e591.y)) + ((_e85.z - _e583.z) * _e591.z)) > 0f);
                    let _e604 = lt_mask_Reprojection(_e580.pixel, _e600, _e580.has_moved);
                    if _e600 {
                        phi_702_ = false;
                    } else {
                        phi_702_ = true;
                    }
                    let _e606 = phi_702_;
                    phi_704_ = _e604;
                    phi_705_ = _e604;
                    phi_706_ = _e606;
                } else {
                    phi_704_ = lt_mask_Reprojection();
                    phi_705_ = lt_mask_Reprojection(_e580.pixel, false, _e580.has_moved);
                    phi_706_ = true;
                }
                let _e612 = phi_704_;
                let _e614 = phi_705_;
                let _e616 = phi_706_;
                if _e616 {
                    phi_710_ = false;
                } else {
                    phi_710_ = true;
                }
                let _e618 = phi_710_;
                phi_711_ = _e612;
                phi_712_ = _e614;
                phi_713_ = _e618;
            }
            let _e620 = phi_711_;
            let _e622 = phi_712_;
            let _e624 = phi_713_;
            if _e624 {
                let _e626 = p.member.flags;
                phi_721_ = ((_e626 & 1u) != 0u);
                phi_722_ = _e620;
            } else {
                phi_721_ = false;
                phi_722_ = _e622;
            }
            let _e630 = phi_721_;
            let _e632 = phi_722_;
            let _e636 = lt_mask_Reprojection(_e632.pixel, _e630, _e632.has_moved);
            let _e638 = p.member.flags;
            let _e640 = ((_e638 & 2u) != 0u);
            let _e642 = p.member.flags;
            if ((_e642 & 4u) == 0u) {
                phi_800_ = u32();
                phi_801_ = true;
                phi_802_ = false;
            } else {
                if _e630 {
                    if !(_e636.has_moved) {
                        let _e651 = ((((_e49.y * _e82) + (_e49.x / 32u)) * 6u) + 4u);
                        if (_e651 < _e55) {
                        } else {
                            return;
                        }
                        let _e655 = heard.member[(0u + _e651)];
                        if (((_e655 >> bitcast<u32>(((_e49.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e666 = ((((_e49.y * _e82) + (_e49.x / 32u)) * 6u) + 5u);
                            if (_e666 < _e55) {
                            } else {
                                return;
                            }
                            let _e670 = heard.member[(0u + _e666)];
                            if false {
                                phi_788_ = (2u | 1u);
                            } else {
                                phi_788_ = 2u;
                            }
                            let _e679 = phi_788_;
                            if (((_e670 >> bitcast<u32>(((_e49.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_793_ = (_e679 | 4u);
                            } else {
                                phi_793_ = _e679;
                            }
                            let _e682 = phi_793_;
                            phi_794_ = _e682;
                        } else {
                            phi_794_ = 0u;
                        }
                        let _e684 = phi_794_;
                        phi_795_ = _e684;
                        phi_796_ = false;
                    } else {
                        phi_795_ = u32();
                        phi_796_ = true;
                    }
                    let _e686 = phi_795_;
                    let _e688 = phi_796_;
                    phi_797_ = _e686;
                    phi_798_ = false;
                    phi_799_ = _e688;
                } else {
                    phi_797_ = u32();
                    phi_798_ = true;
                    phi_799_ = false;
                }
                let _e690 = phi_797_;
                let _e692 = phi_798_;
                let _e694 = phi_799_;
                phi_800_ = _e690;
                phi_801_ = _e692;
                phi_802_ = _e694;
            }
            let _e696 = phi_800_;
            let _e698 = phi_801_;
            let _e700 = phi_802_;
            if _e698 {
                phi_806_ = true;
            } else {
                phi_806_ = _e700;
            }
            let _e702 = phi_806_;
            if _e702 {
                phi_810_ = 0u;
            } else {
                phi_810_ = _e696;
            }
            let _e704 = phi_810_;
            let _e705 = lt_mask_Neighbourhood(false, true);
            if _e252 {
                phi_815_ = _e640;
            } else {
                phi_815_ = false;
            }
            let _e707 = phi_815_;
            if _e707 {
                if _e630 {
                    if ((_e704 & 2u) != 0u) {
                        phi_855_ = _e705;
                    } else {
                        let _e724 = ((((_e636.pixel.y * _e82) + (_e636.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e248) | (select(0u, 1u, _e636.has_moved) << bitcast<u32>(1i))));
                        if (_e724 < _e55) {
                        } else {
                            return;
                        }
                        let _e728 = heard.member[(0u + _e724)];
                        let _e734 = (((_e728 >> bitcast<u32>(((_e636.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_855_ = lt_mask_Neighbourhood(_e734, !(_e734));
                    }
                    let _e738 = phi_855_;
                    phi_856_ = _e738;
                } else {
                    phi_856_ = _e705;
                }
                let _e740 = phi_856_;
                phi_857_ = _e740;
            } else {
                phi_857_ = _e705;
            }
            let _e742 = phi_857_;
            let _e745 = p.member.frame;
            let _e747 = p.member.refresh;
            if (_e747 == 0u) {
                phi_890_ = false;
            } else {
                if (_e747 == 0u) {
                    return;
                }
                let _e756 = ((_e49.x + (_e49.y * (((_e747 * 5u) / 8u) | 1u))) + (_e745 % _e747));
                if (_e747 == 0u) {
                    phi_889_ = (_e756 == 0u);
                } else {
                    if (_e747 == 0u) {
                        return;
                    }
                    phi_889_ = ((_e756 % _e747) == 0u);
                }
                let _e763 = phi_889_;
                phi_890_ = _e763;
            }
            let _e765 = phi_890_;
            if _e630 {
                if _e765 {
                    phi_912_ = bool();
                } else {
                    phi_912_ = ((_e704 & 2u) != 0u);
                }
                let _e771 = phi_912_;
                phi_913_ = _e771;
                phi_914_ = _e765;
            } else {
                phi_913_ = bool();
                phi_914_ = true;
            }
            let _e773 = phi_913_;
            let _e775 = phi_914_;
            if _e775 {
                phi_918_ = false;
            } else {
                phi_918_ = _e773;
            }
            let _e777 = phi_918_;
            if _e777 {
                phi_969_ = 7u;
            } else {
                if (_e90 != 0.5f) {
                    if _e630 {
                        if _e765 {
                            phi_966_ = 6u;
                        } else {
                            if _e252 {
                                phi_941_ = true;
                            } else {
                                if _e742.any_expands {
                                    phi_940_ = false;
                                } else {
                                    phi_940_ = true;
                                }
                                let _e779 = phi_940_;
                                phi_941_ = _e779;
                            }
                            let _e781 = phi_941_;
                            if _e781 {
                                if _e252 {
                                    if _e640 {
                                        if _e742.all_remove {
                                            phi_954_ = false;
                                        } else {
                                            phi_954_ = true;
                                        }
                                        let _e783 = phi_954_;
                                        phi_955_ = _e783;
                                    } else {
                                        phi_955_ = true;
                                    }
                                    let _e785 = phi_955_;
                                    phi_956_ = _e785;
                                } else {
                                    phi_956_ = true;
                                }
                                let _e787 = phi_956_;
                                if _e787 {
                                    if _e252 {
                                        phi_963_ = 1u;
                                    } else {
                                        phi_963_ = 0u;
                                    }
                                    let _e789 = phi_963_;
                                    phi_964_ = _e789;
                                } else {
                                    phi_964_ = 5u;
                                }
                                let _e791 = phi_964_;
                                phi_965_ = _e791;
                            } else {
                                phi_965_ = 4u;
                            }
                            let _e793 = phi_965_;
                            phi_966_ = _e793;
                        }
                        let _e795 = phi_966_;
                        phi_967_ = _e795;
                    } else {
                        phi_967_ = 3u;
                    }
                    let _e797 = phi_967_;
                    phi_968_ = _e797;
                } else {
                    phi_968_ = 2u;
                }
                let _e799 = phi_968_;
                phi_969_ = _e799;
            }
            let _e801 = phi_969_;
            if !((_e801 == 0u)) {
                if !((_e801 == 5u)) {
                    phi_981_ = !(_e777);
                    phi_982_ = false;
                } else {
                    phi_981_ = bool();
                    phi_982_ = true;
                }
                let _e808 = phi_981_;
                let _e810 = phi_982_;
                phi_983_ = _e808;
                phi_984_ = _e810;
            } else {
                phi_983_ = bool();
                phi_984_ = true;
            }
            let _e812 = phi_983_;
            let _e814 = phi_984_;
            if _e814 {
                phi_988_ = false;
            } else {
                phi_988_ = _e812;
            }
            let _e816 = phi_988_;
            if _e777 {
                phi_994_ = ((_e704 & 4u) != 0u);
            } else {
                phi_994_ = _e248;
            }
            let _e820 = phi_994_;
            if _e816 {
                if _e248 {
                    phi_1002_ = (2u | 1u);
                } else {
                    phi_1002_ = 2u;
                }
                let _e823 = phi_1002_;
                if false {
                    phi_1007_ = (_e823 | 4u);
                } else {
                    phi_1007_ = _e823;
                }
                let _e826 = phi_1007_;
                phi_1027_ = _e826;
            } else {
                if (_e801 == 7u) {
                    if _e248 {
                        phi_1016_ = (2u | 1u);
                    } else {
                        phi_1016_ = 2u;
                    }
                    let _e830 = phi_1016_;
                    if _e820 {
                        phi_1021_ = (_e830 | 4u);
                    } else {
                        phi_1021_ = _e830;
                    }
                    let _e833 = phi_1021_;
                    phi_1026_ = _e833;
                } else {
                    if _e248 {
                        phi_1025_ = 1u;
                    } else {
                        phi_1025_ = 0u;
                    }
                    let _e835 = phi_1025_;
                    phi_1026_ = _e835;
                }
                let _e837 = phi_1026_;
                phi_1027_ = _e837;
            }
            let _e839 = phi_1027_;
            if _e820 {
                phi_1031_ = 0f;
            } else {
                phi_1031_ = 1f;
            }
            let _e841 = phi_1031_;
            phi_1033_ = mask_Masked(_e841, _e839, _e816);
        }
        let _e844 = phi_1033_;
        visibility.member[_e66.first_primitive] = _e844.visibility;
        let _e849 = p.member.light.number;
        let _e850 = (_e849 * 3u);
        let _e852 = (_e850 % 32u);
        let _e854 = p.member.light.mask_words;
        let _e856 = ((_e66.first_primitive * _e854) + (_e850 / 32u));
        let _e858 = bits.member[_e856];
        bits.member[_e856] = ((_e858 & ~((7u << bitcast<u32>((_e852 & 31u))))) | (_e844.bits << bitcast<u32>((_e852 & 31u))));
        if (_e852 > 29u) {
            let _e873 = bits.member[(_e856 + 1u)];
            let _e875 = (32u - _e852);
            bits.member[(_e856 + 1u)] = ((_e873 & ~((7u >> bitcast<u32>((_e875 & 31u))))) | (_e844.bits >> bitcast<u32>((_e875 & 31u))));
        }
        phi_1083_ = _e844.needs_ray;
        phi_1084_ = _e66.first_primitive;
    } else {
        phi_1083_ = false;
        phi_1084_ = 0u;
    }
    let _e889 = phi_1083_;
    let _e891 = phi_1084_;
    if (_e50 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e889 {
        let _e895 = atomicAdd((&shared_[0u]), 1u);
        phi_1095_ = _e895;
    } else {
        phi_1095_ = 0u;
    }
    let _e897 = phi_1095_;
    workgroupBarrier();
    if (_e50 == 0u) {
        let _e901 = atomicLoad((&shared_[0u]));
        let _e902 = atomicAdd((&list.member[3u]), _e901);
        atomicStore((&shared_[1u]), _e902);
    }
    workgroupBarrier();
    if _e889 {
        let _e905 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e905) + _e897)]), _e891);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
