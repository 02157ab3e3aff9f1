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
var<storage, read_write> list: type_43;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;

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
        let _e60 = phi_156_;
        let _e62 = phi_157_;
        phi_158_ = _e60;
        phi_159_ = _e62;
    } else {
        phi_158_ = lt_bvh_traverse_Tree();
        phi_159_ = true;
    }
    let _e64 = phi_158_;
    let _e66 = phi_159_;
    if _e66 {
        phi_164_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_164_ = _e64;
    }
    let _e71 = phi_164_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn function_() {
    var phi_209_: u32;
    var phi_243_: bool;
    var phi_244_: bool;
    var phi_245_: bool;
    var phi_246_: bool;
    var phi_250_: bool;
    var phi_320_: bool;
    var phi_321_: bool;
    var phi_332_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_333_: bool;
    var phi_334_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_335_: bool;
    var phi_342_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_346_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_359_: bool;
    var phi_390_: bool;
    var phi_391_: bool;
    var phi_392_: bool;
    var phi_393_: bool;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_537_: f32;
    var phi_542_: f32;
    var phi_543_: bool;
    var phi_544_: f32;
    var phi_545_: bool;
    var phi_549_: f32;
    var phi_570_: f32;
    var phi_575_: f32;
    var phi_576_: bool;
    var phi_577_: f32;
    var phi_578_: bool;
    var phi_582_: f32;
    var phi_603_: bool;
    var phi_622_: vec2<u32>;
    var phi_623_: bool;
    var phi_624_: bool;
    var phi_625_: bool;
    var phi_626_: vec2<u32>;
    var phi_627_: bool;
    var phi_628_: bool;
    var phi_629_: bool;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_632_: bool;
    var phi_633_: vec2<u32>;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_636_: bool;
    var phi_637_: bool;
    var phi_638_: bool;
    var phi_639_: bool;
    var phi_640_: vec2<u32>;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_643_: bool;
    var phi_644_: bool;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_655_: bool;
    var phi_656_: bool;
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_662_: vec2<u32>;
    var phi_700_: bool;
    var phi_702_: lt_mask_Reprojection;
    var phi_703_: lt_mask_Reprojection;
    var phi_704_: bool;
    var phi_708_: bool;
    var phi_709_: lt_mask_Reprojection;
    var phi_710_: lt_mask_Reprojection;
    var phi_711_: bool;
    var phi_719_: bool;
    var phi_720_: lt_mask_Reprojection;
    var phi_726_: bool;
    var phi_766_: lt_mask_Neighbourhood;
    var phi_767_: lt_mask_Neighbourhood;
    var phi_768_: lt_mask_Neighbourhood;
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_829_: bool;
    var phi_851_: bool;
    var phi_852_: bool;
    var phi_865_: bool;
    var phi_866_: bool;
    var phi_867_: bool;
    var phi_874_: u32;
    var phi_875_: u32;
    var phi_876_: u32;
    var phi_877_: u32;
    var phi_878_: u32;
    var phi_879_: u32;
    var phi_880_: u32;
    var phi_892_: bool;
    var phi_893_: bool;
    var phi_894_: bool;
    var phi_895_: bool;
    var phi_899_: bool;
    var phi_905_: bool;
    var phi_913_: u32;
    var phi_918_: u32;
    var phi_927_: u32;
    var phi_932_: u32;
    var phi_936_: u32;
    var phi_937_: u32;
    var phi_938_: u32;
    var phi_942_: f32;
    var phi_944_: mask_Masked;
    var phi_994_: bool;
    var phi_995_: u32;
    var phi_1006_: u32;

    let _e47 = id_1;
    let _e48 = local_1;
    let _e60 = p.member.current.size[0u];
    let _e62 = p.member.current.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e47, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        let _e71 = p.member.current.size[0u];
        if (32u == 0u) {
            return;
        }
        let _e73 = (_e71 / 32u);
        if (32u == 0u) {
            return;
        }
        if ((_e71 % 32u) > 0u) {
            phi_209_ = (_e73 + 1u);
        } else {
            phi_209_ = _e73;
        }
        let _e79 = phi_209_;
        let _e82 = samples.member[_e63.first_primitive].position;
        let _e84 = visibility.member[_e63.first_primitive];
        let _e90 = samples.member[_e63.first_primitive].normal[0u];
        let _e92 = global[0u];
        if (_e90 == _e92) {
            let _e95 = samples.member[_e63.first_primitive].normal[1u];
            let _e97 = global[1u];
            if (_e95 == _e97) {
                let _e100 = samples.member[_e63.first_primitive].normal[2u];
                let _e102 = global[2u];
                phi_243_ = (_e100 == _e102);
                phi_244_ = false;
            } else {
                phi_243_ = bool();
                phi_244_ = true;
            }
            let _e105 = phi_243_;
            let _e107 = phi_244_;
            phi_245_ = _e105;
            phi_246_ = _e107;
        } else {
            phi_245_ = bool();
            phi_246_ = true;
        }
        let _e109 = phi_245_;
        let _e111 = phi_246_;
        if _e111 {
            phi_250_ = false;
        } else {
            phi_250_ = _e109;
        }
        let _e113 = phi_250_;
        if !(_e113) {
            let _e116 = samples.member[_e63.first_primitive].position;
            let _e118 = p.member.light.place;
            let _e124 = p.member.light.place[3u];
            let _e131 = (_e118.x - (_e116.x * _e124));
            let _e132 = (_e118.y - (_e116.y * _e124));
            let _e133 = (_e118.z - (_e116.z * _e124));
            let _e135 = samples.member[_e63.first_primitive].normal;
            if ((((_e135.x * _e131) + (_e135.y * _e132)) + (_e135.z * _e133)) > 0f) {
                let _e149 = (((_e131 * _e131) + (_e132 * _e132)) + (_e133 * _e133));
                let _e151 = p.member.light.axis;
                let _e163 = p.member.light.place[3u];
                if (_e163 == 0f) {
                    phi_321_ = true;
                } else {
                    let _e166 = p.member.light.range_squared;
                    if (_e149 <= _e166) {
                        let _e169 = p.member.light.cos_outer;
                        phi_320_ = (-((((_e131 * _e151.x) + (_e132 * _e151.y)) + (_e133 * _e151.z))) >= (_e169 * sqrt(_e149)));
                    } else {
                        phi_320_ = false;
                    }
                    let _e174 = phi_320_;
                    phi_321_ = _e174;
                }
                let _e176 = phi_321_;
                if _e176 {
                    let _e178 = samples.member[_e63.first_primitive].flags;
                    let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e186.unnamed.visibility, false), _e186.unnamed_1);
                    phi_332_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e192.unnamed, ((_e178 & 1u) == 0u));
                    phi_333_ = false;
                } else {
                    phi_332_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_333_ = true;
                }
                let _e197 = phi_332_;
                let _e199 = phi_333_;
                phi_334_ = _e197;
                phi_335_ = _e199;
            } else {
                phi_334_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_335_ = true;
            }
            let _e201 = phi_334_;
            let _e203 = phi_335_;
            if _e203 {
                let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e215 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e209.unnamed.visibility, false), _e209.unnamed_1);
                phi_342_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e215.unnamed, true);
            } else {
                phi_342_ = _e201;
            }
            let _e220 = phi_342_;
            phi_346_ = _e220;
        } else {
            let _e226 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e232 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e226.unnamed.visibility, false), _e226.unnamed_1);
            phi_346_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e232.unnamed, true);
        }
        let _e237 = phi_346_;
        if _e237.unnamed_1 {
            phi_944_ = mask_Masked(_e237.unnamed.visibility, 0u, false);
        } else {
            let _e242 = (_e84 < 0.5f);
            if (_e84 > 0f) {
                phi_359_ = (_e84 < 1f);
            } else {
                phi_359_ = false;
            }
            let _e246 = phi_359_;
            let _e253 = lt_mask_Reprojection(vec2<u32>(_e47.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e260 = lt_mask_Reprojection(vec2<u32>(_e253.pixel.x, _e47.y), _e253.is_valid, _e253.has_moved);
            let _e264 = lt_mask_Reprojection(_e260.pixel, true, _e260.has_moved);
            let _e270 = p.member.flags;
            if ((_e270 & 16u) == 0u) {
                phi_398_ = false;
            } else {
                let _e276 = samples.member[_e63.first_primitive].position[0u];
                if (_e82.x == _e276) {
                    let _e280 = samples.member[_e63.first_primitive].position[1u];
                    if (_e82.y == _e280) {
                        let _e284 = samples.member[_e63.first_primitive].position[2u];
                        phi_390_ = (_e82.z == _e284);
                        phi_391_ = false;
                    } else {
                        phi_390_ = bool();
                        phi_391_ = true;
                    }
                    let _e287 = phi_390_;
                    let _e289 = phi_391_;
                    phi_392_ = _e287;
                    phi_393_ = _e289;
                } else {
                    phi_392_ = bool();
                    phi_393_ = true;
                }
                let _e291 = phi_392_;
                let _e293 = phi_393_;
                if _e293 {
                    phi_397_ = false;
                } else {
                    phi_397_ = _e291;
                }
                let _e295 = phi_397_;
                phi_398_ = _e295;
            }
            let _e297 = phi_398_;
            if _e297 {
                phi_709_ = lt_mask_Reprojection(_e264.pixel, _e264.is_valid, false);
                phi_710_ = lt_mask_Reprojection();
                phi_711_ = true;
            } else {
                let _e301 = p.member.current.grid[0u];
                let _e303 = p.member.current.grid[1u];
                let _e317 = (f32(_e47.x) + ((f32((_e47.y & (_e303 - 1u))) + 0.5f) / f32(_e303)));
                let _e319 = (f32(_e47.y) + ((f32((_e47.x & (_e301 - 1u))) + 0.5f) / f32(_e301)));
                let _e322 = p.member.previous.eye;
                let _e325 = (_e82.x - _e322.x);
                let _e328 = (_e82.y - _e322.y);
                let _e331 = (_e82.z - _e322.z);
                let _e333 = p.member.previous.forward;
                let _e341 = (((_e325 * _e333.x) + (_e328 * _e333.y)) + (_e331 * _e333.z));
                let _e343 = p.member.previous.right;
                let _e353 = p.member.previous.right;
                let _e368 = p.member.previous.up;
                let _e378 = p.member.previous.up;
                let _e395 = p.member.previous.size[0u];
                let _e402 = p.member.previous.size[1u];
                let _e406 = (((((((_e325 * _e343.x) + (_e328 * _e343.y)) + (_e331 * _e343.z)) / ((((_e353.x * _e353.x) + (_e353.y * _e353.y)) + (_e353.z * _e353.z)) * _e341)) + 1f) * (0.5f * f32(_e395))) - _e317);
                let _e407 = (((1f - ((((_e325 * _e368.x) + (_e328 * _e368.y)) + (_e331 * _e368.z)) / ((((_e378.x * _e378.x) + (_e378.y * _e378.y)) + (_e378.z * _e378.z)) * _e341))) * (0.5f * f32(_e402))) - _e319);
                let _e411 = p.member.current.size[0u];
                let _e413 = p.member.current.size[1u];
                let _e415 = (_e317 + _e406);
                if (_e415 > -8388608f) {
                    let _e427 = f32(select(0i, select(select(i32(_e415), i32(-2147483648), (_e415 < bitcast<f32>(3472883712u))), 2147483647i, (_e415 > bitcast<f32>(1325400063u))), (_e415 == _e415)));
                    if (_e427 > _e415) {
                        phi_537_ = 1f;
                    } else {
                        phi_537_ = 0f;
                    }
                    let _e430 = phi_537_;
                    if (_e415 < 8388608f) {
                        phi_542_ = (_e427 - _e430);
                        phi_543_ = false;
                    } else {
                        phi_542_ = f32();
                        phi_543_ = true;
                    }
                    let _e433 = phi_542_;
                    let _e435 = phi_543_;
                    phi_544_ = _e433;
                    phi_545_ = _e435;
                } else {
                    phi_544_ = f32();
                    phi_545_ = true;
                }
                let _e437 = phi_544_;
                let _e439 = phi_545_;
                if _e439 {
                    phi_549_ = _e415;
                } else {
                    phi_549_ = _e437;
                }
                let _e441 = phi_549_;
                let _e442 = (_e319 + _e407);
                if (_e442 > -8388608f) {
                    let _e454 = f32(select(0i, select(select(i32(_e442), i32(-2147483648), (_e442 < bitcast<f32>(3472883712u))), 2147483647i, (_e442 > bitcast<f32>(1325400063u))), (_e442 == _e442)));
                    if (_e454 > _e442) {
                        phi_570_ = 1f;
                    } else {
                        phi_570_ = 0f;
                    }
                    let _e457 = phi_570_;
                    if (_e442 < 8388608f) {
                        phi_575_ = (_e454 - _e457);
                        phi_576_ = false;
                    } else {
                        phi_575_ = f32();
                        phi_576_ = true;
                    }
                    let _e460 = phi_575_;
                    let _e462 = phi_576_;
                    phi_577_ = _e460;
                    phi_578_ = _e462;
                } else {
                    phi_577_ = f32();
                    phi_578_ = true;
                }
                let _e464 = phi_577_;
                let _e466 = phi_578_;
                if _e466 {
                    phi_582_ = _e442;
                } else {
                    phi_582_ = _e464;
                }
                let _e468 = phi_582_;
                if (_e441 >= 0f) {
                    if (_e468 >= 0f) {
                        if (_e441 < f32(_e411)) {
                            let _e474 = (_e468 < f32(_e413));
                            if (_e406 == 0f) {
                                phi_603_ = (_e407 == 0f);
                            } else {
                                phi_603_ = false;
                            }
                            let _e478 = phi_603_;
                            if _e474 {
                                phi_622_ = vec2<u32>(select(select(u32(_e441), 0u, (_e441 < bitcast<f32>(0u))), 4294967295u, (_e441 > bitcast<f32>(1333788671u))), select(select(u32(_e468), 0u, (_e468 < bitcast<f32>(0u))), 4294967295u, (_e468 > bitcast<f32>(1333788671u))));
                                phi_623_ = false;
                            } else {
                                phi_622_ = vec2<u32>();
                                phi_623_ = true;
                            }
                            let _e495 = phi_622_;
                            let _e497 = phi_623_;
                            phi_624_ = _e478;
                            phi_625_ = _e474;
                            phi_626_ = _e495;
                            phi_627_ = _e478;
                            phi_628_ = _e474;
                            phi_629_ = false;
                            phi_630_ = _e497;
                        } else {
                            phi_624_ = bool();
                            phi_625_ = bool();
                            phi_626_ = vec2<u32>();
                            phi_627_ = bool();
                            phi_628_ = bool();
                            phi_629_ = true;
                            phi_630_ = false;
                        }
                        let _e499 = phi_624_;
                        let _e501 = phi_625_;
                        let _e503 = phi_626_;
                        let _e505 = phi_627_;
                        let _e507 = phi_628_;
                        let _e509 = phi_629_;
                        let _e511 = phi_630_;
                        phi_631_ = _e499;
                        phi_632_ = _e501;
                        phi_633_ = _e503;
                        phi_634_ = _e505;
                        phi_635_ = _e507;
                        phi_636_ = _e509;
                        phi_637_ = _e511;
                    } else {
                        phi_631_ = bool();
                        phi_632_ = bool();
                        phi_633_ = vec2<u32>();
                        phi_634_ = bool();
                        phi_635_ = bool();
                        phi_636_ = true;
                        phi_637_ = false;
                    }
                    let _e513 = phi_631_;
                    let _e515 = phi_632_;
                    let _e517 = phi_633_;
                    let _e519 = phi_634_;
                    let _e521 = phi_635_;
                    let _e523 = phi_636_;
                    let _e525 = phi_637_;
                    phi_638_ = _e513;
                    phi_639_ = _e515;
                    phi_640_ = _e517;
                    phi_641_ = _e519;
                    phi_642_ = _e521;
                    phi_643_ = _e523;
                    phi_644_ = _e525;
                } else {
                    phi_638_ = bool();
                    phi_639_ = bool();
                    phi_640_ = vec2<u32>();
                    phi_641_ = bool();
                    phi_642_ = bool();
                    phi_643_ = true;
                    phi_644_ = false;
                }
                let _e527 = phi_638_;
                let _e529 = phi_639_;
                let _e531 = phi_640_;
                let _e533 = phi_641_;
                let _e535 = phi_642_;
                let _e537 = phi_643_;
                let _e539 = phi_644_;
                if _e537 {
                    if (_e406 == 0f) {
                        phi_653_ = (_e407 == 0f);
                    } else {
                        phi_653_ = false;
                    }
                    let _e543 = phi_653_;
                    phi_654_ = _e543;
                    phi_655_ = false;
                    phi_656_ = true;
                } else {
                    phi_654_ = _e533;
                    phi_655_ = _e535;
                    phi_656_ = _e539;
                }
                let _e545 = phi_654_;
                let _e547 = phi_655_;
                let _e549 = phi_656_;
                if _e549 {
                    phi_660_ = _e545;
                    phi_661_ = _e547;
                    phi_662_ = vec2<u32>(_e47.x, _e47.y);
                } else {
                    phi_660_ = _e527;
                    phi_661_ = _e529;
                    phi_662_ = _e531;
                }
                let _e551 = phi_660_;
                let _e553 = phi_661_;
                let _e555 = phi_662_;
                let _e565 = lt_mask_Reprojection(vec2<u32>(_e555.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e572 = lt_mask_Reprojection(vec2<u32>(_e565.pixel.x, _e555.y), _e565.is_valid, _e565.has_moved);
                let _e576 = lt_mask_Reprojection(_e572.pixel, _e553, _e572.has_moved);
                let _e580 = lt_mask_Reprojection(_e576.pixel, _e576.is_valid, !(_e551));
                if _e553 {
                    let _e583 = p.member.previous.eye;
                    let _e594 = p.member.previous.forward;
                    let _e603 = (((((_e82.x - _e583.x) * _e594.x) + ((_e82.y - _e583.y) * _e594.y)) + ((_e82.z - _e583.z) * _e594.z)) > 0f);
                    let _e607 = lt_mask_Reprojection(_e580.pixel, _e603, _e580.has_moved);
                    if _e603 {
                        phi_700_ = false;
                    } else {
                        phi_700_ = true;
                    }
                    let _e609 = phi_700_;
                    phi_702_ = _e607;
                    phi_703_ = _e607;
                    phi_704_ = _e609;
                } else {
                    phi_702_ = lt_mask_Reprojection();
                    phi_703_ = lt_mask_Reprojection(_e580.pixel, false, _e580.has_moved);
                    phi_704_ = true;
                }
                let _e615 = phi_702_;
                let _e617 = phi_703_;
                let _e619 = phi_704_;
                if _e619 {
                    phi_708_ = false;
                } else {
                    phi_708_ = true;
                }
                let _e621 = phi_708_;
                phi_709_ = _e615;
                phi_710_ = _e617;
                phi_711_ = _e621;
            }
            let _e623 = phi_709_;
            let _e625 = phi_710_;
            let _e627 = phi_711_;
            if _e627 {
                let _e629 = p.member.flags;
                phi_719_ = ((_e629 & 1u) != 0u);
                phi_720_ = _e623;
            } else {
                phi_719_ = false;
                phi_720_ = _e625;
            }
            let _e633 = phi_719_;
            let _e635 = phi_720_;
            let _e639 = lt_mask_Reprojection(_e635.pixel, _e633, _e635.has_moved);
            let _e640 = lt_mask_Neighbourhood(false, true);
            if _e246 {
                phi_726_ = false;
            } else {
                phi_726_ = true;
            }
            let _e642 = phi_726_;
            if _e642 {
                if _e633 {
                    if ((0u & 2u) != 0u) {
                        phi_766_ = _e640;
                    } else {
                        let _e659 = ((((_e639.pixel.y * _e79) + (_e639.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e242) | (select(0u, 1u, _e639.has_moved) << bitcast<u32>(1i))));
                        if (_e659 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e663 = heard.member[(0u + _e659)];
                        let _e669 = (((_e663 >> bitcast<u32>(((_e639.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_766_ = lt_mask_Neighbourhood(_e669, !(_e669));
                    }
                    let _e673 = phi_766_;
                    phi_767_ = _e673;
                } else {
                    phi_767_ = _e640;
                }
                let _e675 = phi_767_;
                phi_768_ = _e675;
            } else {
                phi_768_ = _e640;
            }
            let _e677 = phi_768_;
            let _e680 = p.member.frame;
            let _e682 = p.member.refresh;
            if (_e682 == 0u) {
                phi_801_ = false;
            } else {
                if (_e682 == 0u) {
                    return;
                }
                let _e691 = ((_e47.x + (_e47.y * (((_e682 * 5u) / 8u) | 1u))) + (_e680 % _e682));
                if (_e682 == 0u) {
                    phi_800_ = (_e691 == 0u);
                } else {
                    if (_e682 == 0u) {
                        return;
                    }
                    phi_800_ = ((_e691 % _e682) == 0u);
                }
                let _e698 = phi_800_;
                phi_801_ = _e698;
            }
            let _e700 = phi_801_;
            if _e633 {
                if _e700 {
                    phi_823_ = bool();
                } else {
                    phi_823_ = ((0u & 2u) != 0u);
                }
                let _e706 = phi_823_;
                phi_824_ = _e706;
                phi_825_ = _e700;
            } else {
                phi_824_ = bool();
                phi_825_ = true;
            }
            let _e708 = phi_824_;
            let _e710 = phi_825_;
            if _e710 {
                phi_829_ = false;
            } else {
                phi_829_ = _e708;
            }
            let _e712 = phi_829_;
            if _e712 {
                phi_880_ = 7u;
            } else {
                if (_e84 != 0.5f) {
                    if _e633 {
                        if _e700 {
                            phi_877_ = 6u;
                        } else {
                            if _e246 {
                                phi_852_ = true;
                            } else {
                                if _e677.any_expands {
                                    phi_851_ = false;
                                } else {
                                    phi_851_ = true;
                                }
                                let _e714 = phi_851_;
                                phi_852_ = _e714;
                            }
                            let _e716 = phi_852_;
                            if _e716 {
                                if _e246 {
                                    if false {
                                        if _e677.all_remove {
                                            phi_865_ = false;
                                        } else {
                                            phi_865_ = true;
                                        }
                                        let _e718 = phi_865_;
                                        phi_866_ = _e718;
                                    } else {
                                        phi_866_ = true;
                                    }
                                    let _e720 = phi_866_;
                                    phi_867_ = _e720;
                                } else {
                                    phi_867_ = true;
                                }
                                let _e722 = phi_867_;
                                if _e722 {
                                    if _e246 {
                                        phi_874_ = 1u;
                                    } else {
                                        phi_874_ = 0u;
                                    }
                                    let _e724 = phi_874_;
                                    phi_875_ = _e724;
                                } else {
                                    phi_875_ = 5u;
                                }
                                let _e726 = phi_875_;
                                phi_876_ = _e726;
                            } else {
                                phi_876_ = 4u;
                            }
                            let _e728 = phi_876_;
                            phi_877_ = _e728;
                        }
                        let _e730 = phi_877_;
                        phi_878_ = _e730;
                    } else {
                        phi_878_ = 3u;
                    }
                    let _e732 = phi_878_;
                    phi_879_ = _e732;
                } else {
                    phi_879_ = 2u;
                }
                let _e734 = phi_879_;
                phi_880_ = _e734;
            }
            let _e736 = phi_880_;
            if !((_e736 == 0u)) {
                if !((_e736 == 5u)) {
                    phi_892_ = !(_e712);
                    phi_893_ = false;
                } else {
                    phi_892_ = bool();
                    phi_893_ = true;
                }
                let _e743 = phi_892_;
                let _e745 = phi_893_;
                phi_894_ = _e743;
                phi_895_ = _e745;
            } else {
                phi_894_ = bool();
                phi_895_ = true;
            }
            let _e747 = phi_894_;
            let _e749 = phi_895_;
            if _e749 {
                phi_899_ = false;
            } else {
                phi_899_ = _e747;
            }
            let _e751 = phi_899_;
            if _e712 {
                phi_905_ = ((0u & 4u) != 0u);
            } else {
                phi_905_ = _e242;
            }
            let _e755 = phi_905_;
            if _e751 {
                if _e242 {
                    phi_913_ = (2u | 1u);
                } else {
                    phi_913_ = 2u;
                }
                let _e758 = phi_913_;
                if false {
                    phi_918_ = (_e758 | 4u);
                } else {
                    phi_918_ = _e758;
                }
                let _e761 = phi_918_;
                phi_938_ = _e761;
            } else {
                if (_e736 == 7u) {
                    if _e242 {
                        phi_927_ = (2u | 1u);
                    } else {
                        phi_927_ = 2u;
                    }
                    let _e765 = phi_927_;
                    if _e755 {
                        phi_932_ = (_e765 | 4u);
                    } else {
                        phi_932_ = _e765;
                    }
                    let _e768 = phi_932_;
                    phi_937_ = _e768;
                } else {
                    if _e242 {
                        phi_936_ = 1u;
                    } else {
                        phi_936_ = 0u;
                    }
                    let _e770 = phi_936_;
                    phi_937_ = _e770;
                }
                let _e772 = phi_937_;
                phi_938_ = _e772;
            }
            let _e774 = phi_938_;
            if _e755 {
                phi_942_ = 0f;
            } else {
                phi_942_ = 1f;
            }
            let _e776 = phi_942_;
            phi_944_ = mask_Masked(_e776, _e774, _e751);
        }
        let _e779 = phi_944_;
        visibility.member[_e63.first_primitive] = _e779.visibility;
        let _e784 = p.member.light.number;
        let _e785 = (_e784 * 3u);
        let _e787 = (_e785 % 32u);
        let _e789 = p.member.light.mask_words;
        let _e791 = ((_e63.first_primitive * _e789) + (_e785 / 32u));
        let _e793 = bits.member[_e791];
        bits.member[_e791] = ((_e793 & ~((7u << bitcast<u32>((_e787 & 31u))))) | (_e779.bits << bitcast<u32>((_e787 & 31u))));
        if (_e787 > 29u) {
            let _e808 = bits.member[(_e791 + 1u)];
            let _e810 = (32u - _e787);
            bits.member[(_e791 + 1u)] = ((_e808 & ~((7u >> bitcast<u32>((_e810 & 31u))))) | (_e779.bits >> bitcast<u32>((_e810 & 31u))));
        }
        phi_994_ = _e779.needs_ray;
        phi_995_ = _e63.first_primitive;
    } else {
        phi_994_ = false;
        phi_995_ = 0u;
    }
    let _e824 = phi_994_;
    let _e826 = phi_995_;
    if (_e48 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e824 {
        let _e830 = atomicAdd((&shared_[0u]), 1u);
        phi_1006_ = _e830;
    } else {
        phi_1006_ = 0u;
    }
    let _e832 = phi_1006_;
    workgroupBarrier();
    if (_e48 == 0u) {
        let _e836 = atomicLoad((&shared_[0u]));
        let _e837 = atomicAdd((&list.member[3u]), _e836);
        atomicStore((&shared_[1u]), _e837);
    }
    workgroupBarrier();
    if _e824 {
        let _e840 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e840) + _e832)]), _e826);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
