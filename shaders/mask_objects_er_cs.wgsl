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

struct doubt_Listed {
    pixel: u32,
    is_trusted: bool,
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
    is_trusted: bool,
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
    var phi_167_: lt_bvh_traverse_Tree;
    var phi_168_: bool;
    var phi_169_: lt_bvh_traverse_Tree;
    var phi_170_: bool;
    var phi_175_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_167_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_168_ = false;
        } else {
            phi_167_ = lt_bvh_traverse_Tree();
            phi_168_ = true;
        }
        let _e64 = phi_167_;
        let _e66 = phi_168_;
        phi_169_ = _e64;
        phi_170_ = _e66;
    } else {
        phi_169_ = lt_bvh_traverse_Tree();
        phi_170_ = true;
    }
    let _e68 = phi_169_;
    let _e70 = phi_170_;
    if _e70 {
        phi_175_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_175_ = _e68;
    }
    let _e75 = phi_175_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn function_() {
    var phi_222_: u32;
    var phi_259_: bool;
    var phi_260_: bool;
    var phi_261_: bool;
    var phi_262_: bool;
    var phi_266_: bool;
    var phi_336_: bool;
    var phi_337_: bool;
    var phi_348_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_349_: bool;
    var phi_350_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_351_: bool;
    var phi_358_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_362_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_375_: bool;
    var phi_403_: bool;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_410_: bool;
    var phi_411_: bool;
    var phi_547_: f32;
    var phi_552_: f32;
    var phi_553_: bool;
    var phi_554_: f32;
    var phi_555_: bool;
    var phi_559_: f32;
    var phi_580_: f32;
    var phi_585_: f32;
    var phi_586_: bool;
    var phi_587_: f32;
    var phi_588_: bool;
    var phi_592_: f32;
    var phi_613_: bool;
    var phi_632_: vec2<u32>;
    var phi_633_: bool;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_636_: vec2<u32>;
    var phi_637_: bool;
    var phi_638_: bool;
    var phi_639_: bool;
    var phi_640_: bool;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_643_: vec2<u32>;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_650_: vec2<u32>;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_666_: bool;
    var phi_670_: bool;
    var phi_671_: bool;
    var phi_672_: vec2<u32>;
    var phi_707_: bool;
    var phi_709_: lt_mask_Reprojection;
    var phi_710_: lt_mask_Reprojection;
    var phi_711_: bool;
    var phi_715_: bool;
    var phi_716_: lt_mask_Reprojection;
    var phi_717_: lt_mask_Reprojection;
    var phi_718_: bool;
    var phi_726_: bool;
    var phi_727_: lt_mask_Reprojection;
    var phi_733_: bool;
    var phi_773_: lt_mask_Neighbourhood;
    var phi_774_: lt_mask_Neighbourhood;
    var phi_775_: lt_mask_Neighbourhood;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_832_: bool;
    var phi_836_: bool;
    var phi_858_: bool;
    var phi_859_: bool;
    var phi_872_: bool;
    var phi_873_: bool;
    var phi_874_: bool;
    var phi_881_: u32;
    var phi_882_: u32;
    var phi_883_: u32;
    var phi_884_: u32;
    var phi_885_: u32;
    var phi_886_: u32;
    var phi_887_: u32;
    var phi_899_: bool;
    var phi_900_: bool;
    var phi_901_: bool;
    var phi_902_: bool;
    var phi_906_: bool;
    var phi_912_: bool;
    var phi_920_: u32;
    var phi_925_: u32;
    var phi_934_: u32;
    var phi_939_: u32;
    var phi_943_: u32;
    var phi_944_: u32;
    var phi_945_: u32;
    var phi_949_: f32;
    var phi_958_: bool;
    var phi_959_: bool;
    var phi_961_: mask_Masked;
    var phi_1013_: doubt_Listed;
    var phi_1014_: bool;
    var phi_1027_: u32;
    var phi_1044_: u32;

    let _e51 = id_1;
    let _e52 = local_1;
    let _e66 = p.member.current.size[0u];
    let _e68 = p.member.current.size[1u];
    let _e69 = lt_shaders_entry_pixel_index(_e51, _e66, _e68);
    if (bitcast<i32>(_e69.root) != 0i) {
        let _e77 = p.member.current.size[0u];
        if (32u == 0u) {
            return;
        }
        let _e79 = (_e77 / 32u);
        if (32u == 0u) {
            return;
        }
        if ((_e77 % 32u) > 0u) {
            phi_222_ = (_e79 + 1u);
        } else {
            phi_222_ = _e79;
        }
        let _e85 = phi_222_;
        let _e88 = past.member[_e69.first_primitive];
        let _e93 = visibility.member[_e69.first_primitive];
        let _e99 = samples.member[_e69.first_primitive].normal[0u];
        let _e101 = global[0u];
        if (_e99 == _e101) {
            let _e104 = samples.member[_e69.first_primitive].normal[1u];
            let _e106 = global[1u];
            if (_e104 == _e106) {
                let _e109 = samples.member[_e69.first_primitive].normal[2u];
                let _e111 = global[2u];
                phi_259_ = (_e109 == _e111);
                phi_260_ = false;
            } else {
                phi_259_ = bool();
                phi_260_ = true;
            }
            let _e114 = phi_259_;
            let _e116 = phi_260_;
            phi_261_ = _e114;
            phi_262_ = _e116;
        } else {
            phi_261_ = bool();
            phi_262_ = true;
        }
        let _e118 = phi_261_;
        let _e120 = phi_262_;
        if _e120 {
            phi_266_ = false;
        } else {
            phi_266_ = _e118;
        }
        let _e122 = phi_266_;
        if !(_e122) {
            let _e125 = samples.member[_e69.first_primitive].position;
            let _e127 = p.member.light.place;
            let _e133 = p.member.light.place[3u];
            let _e140 = (_e127.x - (_e125.x * _e133));
            let _e141 = (_e127.y - (_e125.y * _e133));
            let _e142 = (_e127.z - (_e125.z * _e133));
            let _e144 = samples.member[_e69.first_primitive].normal;
            if ((((_e144.x * _e140) + (_e144.y * _e141)) + (_e144.z * _e142)) > 0f) {
                let _e158 = (((_e140 * _e140) + (_e141 * _e141)) + (_e142 * _e142));
                let _e160 = p.member.light.axis;
                let _e172 = p.member.light.place[3u];
                if (_e172 == 0f) {
                    phi_337_ = true;
                } else {
                    let _e175 = p.member.light.range_squared;
                    if (_e158 <= _e175) {
                        let _e178 = p.member.light.cos_outer;
                        phi_336_ = (-((((_e140 * _e160.x) + (_e141 * _e160.y)) + (_e142 * _e160.z))) >= (_e178 * sqrt(_e158)));
                    } else {
                        phi_336_ = false;
                    }
                    let _e183 = phi_336_;
                    phi_337_ = _e183;
                }
                let _e185 = phi_337_;
                if _e185 {
                    let _e187 = samples.member[_e69.first_primitive].flags;
                    let _e195 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e195.unnamed.visibility, false), _e195.unnamed_1);
                    phi_348_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e201.unnamed, ((_e187 & 1u) == 0u));
                    phi_349_ = false;
                } else {
                    phi_348_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_349_ = true;
                }
                let _e206 = phi_348_;
                let _e208 = phi_349_;
                phi_350_ = _e206;
                phi_351_ = _e208;
            } else {
                phi_350_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_351_ = true;
            }
            let _e210 = phi_350_;
            let _e212 = phi_351_;
            if _e212 {
                let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e224 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e218.unnamed.visibility, false), _e218.unnamed_1);
                phi_358_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e224.unnamed, true);
            } else {
                phi_358_ = _e210;
            }
            let _e229 = phi_358_;
            phi_362_ = _e229;
        } else {
            let _e235 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e241 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e235.unnamed.visibility, false), _e235.unnamed_1);
            phi_362_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e241.unnamed, true);
        }
        let _e246 = phi_362_;
        if _e246.unnamed_1 {
            phi_961_ = mask_Masked(_e246.unnamed.visibility, 0u, false, false);
        } else {
            let _e251 = (_e93 < 0.5f);
            if (_e93 > 0f) {
                phi_375_ = (_e93 < 1f);
            } else {
                phi_375_ = false;
            }
            let _e255 = phi_375_;
            let _e262 = lt_mask_Reprojection(vec2<u32>(_e51.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e269 = lt_mask_Reprojection(vec2<u32>(_e262.pixel.x, _e51.y), _e262.is_valid, _e262.has_moved);
            let _e273 = lt_mask_Reprojection(_e269.pixel, true, _e269.has_moved);
            let _e279 = p.member.flags;
            if ((_e279 & 16u) == 0u) {
                phi_411_ = false;
            } else {
                let _e284 = samples.member[_e69.first_primitive].position[0u];
                if (_e88.x == _e284) {
                    let _e287 = samples.member[_e69.first_primitive].position[1u];
                    if (_e88.y == _e287) {
                        let _e290 = samples.member[_e69.first_primitive].position[2u];
                        phi_403_ = (_e88.z == _e290);
                        phi_404_ = false;
                    } else {
                        phi_403_ = bool();
                        phi_404_ = true;
                    }
                    let _e293 = phi_403_;
                    let _e295 = phi_404_;
                    phi_405_ = _e293;
                    phi_406_ = _e295;
                } else {
                    phi_405_ = bool();
                    phi_406_ = true;
                }
                let _e297 = phi_405_;
                let _e299 = phi_406_;
                if _e299 {
                    phi_410_ = false;
                } else {
                    phi_410_ = _e297;
                }
                let _e301 = phi_410_;
                phi_411_ = _e301;
            }
            let _e303 = phi_411_;
            if _e303 {
                phi_716_ = lt_mask_Reprojection(_e273.pixel, _e273.is_valid, false);
                phi_717_ = lt_mask_Reprojection();
                phi_718_ = true;
            } else {
                let _e307 = p.member.current.grid[0u];
                let _e309 = p.member.current.grid[1u];
                let _e323 = (f32(_e51.x) + ((f32((_e51.y & (_e309 - 1u))) + 0.5f) / f32(_e309)));
                let _e325 = (f32(_e51.y) + ((f32((_e51.x & (_e307 - 1u))) + 0.5f) / f32(_e307)));
                let _e328 = p.member.previous.eye;
                let _e330 = (_e88.x - _e328.x);
                let _e332 = (_e88.y - _e328.y);
                let _e334 = (_e88.z - _e328.z);
                let _e336 = p.member.previous.forward;
                let _e344 = (((_e330 * _e336.x) + (_e332 * _e336.y)) + (_e334 * _e336.z));
                let _e346 = p.member.previous.right;
                let _e356 = p.member.previous.right;
                let _e371 = p.member.previous.up;
                let _e381 = p.member.previous.up;
                let _e398 = p.member.previous.size[0u];
                let _e405 = p.member.previous.size[1u];
                let _e409 = (((((((_e330 * _e346.x) + (_e332 * _e346.y)) + (_e334 * _e346.z)) / ((((_e356.x * _e356.x) + (_e356.y * _e356.y)) + (_e356.z * _e356.z)) * _e344)) + 1f) * (0.5f * f32(_e398))) - _e323);
                let _e410 = (((1f - ((((_e330 * _e371.x) + (_e332 * _e371.y)) + (_e334 * _e371.z)) / ((((_e381.x * _e381.x) + (_e381.y * _e381.y)) + (_e381.z * _e381.z)) * _e344))) * (0.5f * f32(_e405))) - _e325);
                let _e414 = p.member.current.size[0u];
                let _e416 = p.member.current.size[1u];
                let _e418 = (_e323 + _e409);
                if (_e418 > -8388608f) {
                    let _e430 = f32(select(0i, select(select(i32(_e418), i32(-2147483648), (_e418 < bitcast<f32>(3472883712u))), 2147483647i, (_e418 > bitcast<f32>(1325400063u))), (_e418 == _e418)));
                    if (_e430 > _e418) {
                        phi_547_ = 1f;
                    } else {
                        phi_547_ = 0f;
                    }
                    let _e433 = phi_547_;
                    if (_e418 < 8388608f) {
                        phi_552_ = (_e430 - _e433);
                        phi_553_ = false;
                    } else {
                        phi_552_ = f32();
                        phi_553_ = true;
                    }
                    let _e436 = phi_552_;
                    let _e438 = phi_553_;
                    phi_554_ = _e436;
                    phi_555_ = _e438;
                } else {
                    phi_554_ = f32();
                    phi_555_ = true;
                }
                let _e440 = phi_554_;
                let _e442 = phi_555_;
                if _e442 {
                    phi_559_ = _e418;
                } else {
                    phi_559_ = _e440;
                }
                let _e444 = phi_559_;
                let _e445 = (_e325 + _e410);
                if (_e445 > -8388608f) {
                    let _e457 = f32(select(0i, select(select(i32(_e445), i32(-2147483648), (_e445 < bitcast<f32>(3472883712u))), 2147483647i, (_e445 > bitcast<f32>(1325400063u))), (_e445 == _e445)));
                    if (_e457 > _e445) {
                        phi_580_ = 1f;
                    } else {
                        phi_580_ = 0f;
                    }
                    let _e460 = phi_580_;
                    if (_e445 < 8388608f) {
                        phi_585_ = (_e457 - _e460);
                        phi_586_ = false;
                    } else {
                        phi_585_ = f32();
                        phi_586_ = true;
                    }
                    let _e463 = phi_585_;
                    let _e465 = phi_586_;
                    phi_587_ = _e463;
                    phi_588_ = _e465;
                } else {
                    phi_587_ = f32();
                    phi_588_ = true;
                }
                let _e467 = phi_587_;
                let _e469 = phi_588_;
                if _e469 {
                    phi_592_ = _e445;
                } else {
                    phi_592_ = _e467;
                }
                let _e471 = phi_592_;
                if (_e444 >= 0f) {
                    if (_e471 >= 0f) {
                        if (_e444 < f32(_e414)) {
                            let _e477 = (_e471 < f32(_e416));
                            if (_e409 == 0f) {
                                phi_613_ = (_e410 == 0f);
                            } else {
                                phi_613_ = false;
                            }
                            let _e481 = phi_613_;
                            if _e477 {
                                phi_632_ = vec2<u32>(select(select(u32(_e444), 0u, (_e444 < bitcast<f32>(0u))), 4294967295u, (_e444 > bitcast<f32>(1333788671u))), select(select(u32(_e471), 0u, (_e471 < bitcast<f32>(0u))), 4294967295u, (_e471 > bitcast<f32>(1333788671u))));
                                phi_633_ = false;
                            } else {
                                phi_632_ = vec2<u32>();
                                phi_633_ = true;
                            }
                            let _e498 = phi_632_;
                            let _e500 = phi_633_;
                            phi_634_ = _e481;
                            phi_635_ = _e477;
                            phi_636_ = _e498;
                            phi_637_ = _e481;
                            phi_638_ = _e477;
                            phi_639_ = false;
                            phi_640_ = _e500;
                        } else {
                            phi_634_ = bool();
                            phi_635_ = bool();
                            phi_636_ = vec2<u32>();
                            phi_637_ = bool();
                            phi_638_ = bool();
                            phi_639_ = true;
                            phi_640_ = false;
                        }
                        let _e502 = phi_634_;
                        let _e504 = phi_635_;
                        let _e506 = phi_636_;
                        let _e508 = phi_637_;
                        let _e510 = phi_638_;
                        let _e512 = phi_639_;
                        let _e514 = phi_640_;
                        phi_641_ = _e502;
                        phi_642_ = _e504;
                        phi_643_ = _e506;
                        phi_644_ = _e508;
                        phi_645_ = _e510;
                        phi_646_ = _e512;
                        phi_647_ = _e514;
                    } else {
                        phi_641_ = bool();
                        phi_642_ = bool();
                        phi_643_ = vec2<u32>();
                        phi_644_ = bool();
                        phi_645_ = bool();
                        phi_646_ = true;
                        phi_647_ = false;
                    }
                    let _e516 = phi_641_;
                    let _e518 = phi_642_;
                    let _e520 = phi_643_;
                    let _e522 = phi_644_;
                    let _e524 = phi_645_;
                    let _e526 = phi_646_;
                    let _e528 = phi_647_;
                    phi_648_ = _e516;
                    phi_649_ = _e518;
                    phi_650_ = _e520;
                    phi_651_ = _e522;
                    phi_652_ = _e524;
                    phi_653_ = _e526;
                    phi_654_ = _e528;
                } else {
                    phi_648_ = bool();
                    phi_649_ = bool();
                    phi_650_ = vec2<u32>();
                    phi_651_ = bool();
                    phi_652_ = bool();
                    phi_653_ = true;
                    phi_654_ = false;
                }
                let _e530 = phi_648_;
                let _e532 = phi_649_;
                let _e534 = phi_650_;
                let _e536 = phi_651_;
                let _e538 = phi_652_;
                let _e540 = phi_653_;
                let _e542 = phi_654_;
                if _e540 {
                    if (_e409 == 0f) {
                        phi_663_ = (_e410 == 0f);
                    } else {
                        phi_663_ = false;
                    }
                    let _e546 = phi_663_;
                    phi_664_ = _e546;
                    phi_665_ = false;
                    phi_666_ = true;
                } else {
                    phi_664_ = _e536;
                    phi_665_ = _e538;
                    phi_666_ = _e542;
                }
                let _e548 = phi_664_;
                let _e550 = phi_665_;
                let _e552 = phi_666_;
                if _e552 {
                    phi_670_ = _e548;
                    phi_671_ = _e550;
                    phi_672_ = vec2<u32>(_e51.x, _e51.y);
                } else {
                    phi_670_ = _e530;
                    phi_671_ = _e532;
                    phi_672_ = _e534;
                }
                let _e554 = phi_670_;
                let _e556 = phi_671_;
                let _e558 = phi_672_;
                let _e568 = lt_mask_Reprojection(vec2<u32>(_e558.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e575 = lt_mask_Reprojection(vec2<u32>(_e568.pixel.x, _e558.y), _e568.is_valid, _e568.has_moved);
                let _e579 = lt_mask_Reprojection(_e575.pixel, _e556, _e575.has_moved);
                let _e583 = lt_mask_Reprojection(_e579.pixel, _e579.is_valid, !(_e554));
                if _e556 {
                    let _e586 = p.member.previous.eye;
                    let _e594 = p.member.previous.forward;
                    let _e603 = (((((_e88.x - _e586.x) * _e594.x) + ((_e88.y - _e586.y) * _e594.y)) + ((_e88.z - _e586.z) * _e594.z)) > 0f);
                    let _e607 = lt_mask_Reprojection(_e583.pixel, _e603, _e583.has_moved);
                    if _e603 {
                        phi_707_ = false;
                    } else {
                        phi_707_ = true;
                    }
                    let _e609 = phi_707_;
                    phi_709_ = _e607;
                    phi_710_ = _e607;
                    phi_711_ = _e609;
                } else {
                    phi_709_ = lt_mask_Reprojection();
                    phi_710_ = lt_mask_Reprojection(_e583.pixel, false, _e583.has_moved);
                    phi_711_ = true;
                }
                let _e615 = phi_709_;
                let _e617 = phi_710_;
                let _e619 = phi_711_;
                if _e619 {
                    phi_715_ = false;
                } else {
                    phi_715_ = true;
                }
                let _e621 = phi_715_;
                phi_716_ = _e615;
                phi_717_ = _e617;
                phi_718_ = _e621;
            }
            let _e623 = phi_716_;
            let _e625 = phi_717_;
            let _e627 = phi_718_;
            if _e627 {
                let _e629 = p.member.flags;
                phi_726_ = ((_e629 & 1u) != 0u);
                phi_727_ = _e623;
            } else {
                phi_726_ = false;
                phi_727_ = _e625;
            }
            let _e633 = phi_726_;
            let _e635 = phi_727_;
            let _e639 = lt_mask_Reprojection(_e635.pixel, _e633, _e635.has_moved);
            let _e640 = lt_mask_Neighbourhood(false, true);
            if _e255 {
                phi_733_ = false;
            } else {
                phi_733_ = true;
            }
            let _e642 = phi_733_;
            if _e642 {
                if _e633 {
                    if ((0u & 2u) != 0u) {
                        phi_773_ = _e640;
                    } else {
                        let _e659 = ((((_e639.pixel.y * _e85) + (_e639.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e251) | (select(0u, 1u, _e639.has_moved) << bitcast<u32>(1i))));
                        if (_e659 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e663 = heard.member[(0u + _e659)];
                        let _e669 = (((_e663 >> bitcast<u32>(((_e639.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_773_ = lt_mask_Neighbourhood(_e669, !(_e669));
                    }
                    let _e673 = phi_773_;
                    phi_774_ = _e673;
                } else {
                    phi_774_ = _e640;
                }
                let _e675 = phi_774_;
                phi_775_ = _e675;
            } else {
                phi_775_ = _e640;
            }
            let _e677 = phi_775_;
            let _e680 = p.member.frame;
            let _e682 = p.member.refresh;
            if (_e682 == 0u) {
                phi_808_ = false;
            } else {
                if (_e682 == 0u) {
                    return;
                }
                let _e691 = ((_e51.x + (_e51.y * (((_e682 * 5u) / 8u) | 1u))) + (_e680 % _e682));
                if (_e682 == 0u) {
                    phi_807_ = (_e691 == 0u);
                } else {
                    if (_e682 == 0u) {
                        return;
                    }
                    phi_807_ = ((_e691 % _e682) == 0u);
                }
                let _e698 = phi_807_;
                phi_808_ = _e698;
            }
            let _e700 = phi_808_;
            if _e633 {
                if _e700 {
                    phi_830_ = bool();
                } else {
                    phi_830_ = ((0u & 2u) != 0u);
                }
                let _e706 = phi_830_;
                phi_831_ = _e706;
                phi_832_ = _e700;
            } else {
                phi_831_ = bool();
                phi_832_ = true;
            }
            let _e708 = phi_831_;
            let _e710 = phi_832_;
            if _e710 {
                phi_836_ = false;
            } else {
                phi_836_ = _e708;
            }
            let _e712 = phi_836_;
            if _e712 {
                phi_887_ = 7u;
            } else {
                if (_e93 != 0.5f) {
                    if _e633 {
                        if _e700 {
                            phi_884_ = 6u;
                        } else {
                            if _e255 {
                                phi_859_ = true;
                            } else {
                                if _e677.any_expands {
                                    phi_858_ = false;
                                } else {
                                    phi_858_ = true;
                                }
                                let _e714 = phi_858_;
                                phi_859_ = _e714;
                            }
                            let _e716 = phi_859_;
                            if _e716 {
                                if _e255 {
                                    if false {
                                        if _e677.all_remove {
                                            phi_872_ = false;
                                        } else {
                                            phi_872_ = true;
                                        }
                                        let _e718 = phi_872_;
                                        phi_873_ = _e718;
                                    } else {
                                        phi_873_ = true;
                                    }
                                    let _e720 = phi_873_;
                                    phi_874_ = _e720;
                                } else {
                                    phi_874_ = true;
                                }
                                let _e722 = phi_874_;
                                if _e722 {
                                    if _e255 {
                                        phi_881_ = 1u;
                                    } else {
                                        phi_881_ = 0u;
                                    }
                                    let _e724 = phi_881_;
                                    phi_882_ = _e724;
                                } else {
                                    phi_882_ = 5u;
                                }
                                let _e726 = phi_882_;
                                phi_883_ = _e726;
                            } else {
                                phi_883_ = 4u;
                            }
                            let _e728 = phi_883_;
                            phi_884_ = _e728;
                        }
                        let _e730 = phi_884_;
                        phi_885_ = _e730;
                    } else {
                        phi_885_ = 3u;
                    }
                    let _e732 = phi_885_;
                    phi_886_ = _e732;
                } else {
                    phi_886_ = 2u;
                }
                let _e734 = phi_886_;
                phi_887_ = _e734;
            }
            let _e736 = phi_887_;
            if !((_e736 == 0u)) {
                if !((_e736 == 5u)) {
                    phi_899_ = !(_e712);
                    phi_900_ = false;
                } else {
                    phi_899_ = bool();
                    phi_900_ = true;
                }
                let _e743 = phi_899_;
                let _e745 = phi_900_;
                phi_901_ = _e743;
                phi_902_ = _e745;
            } else {
                phi_901_ = bool();
                phi_902_ = true;
            }
            let _e747 = phi_901_;
            let _e749 = phi_902_;
            if _e749 {
                phi_906_ = false;
            } else {
                phi_906_ = _e747;
            }
            let _e751 = phi_906_;
            if _e712 {
                phi_912_ = ((0u & 4u) != 0u);
            } else {
                phi_912_ = _e251;
            }
            let _e755 = phi_912_;
            if _e751 {
                if _e251 {
                    phi_920_ = (2u | 1u);
                } else {
                    phi_920_ = 2u;
                }
                let _e758 = phi_920_;
                if false {
                    phi_925_ = (_e758 | 4u);
                } else {
                    phi_925_ = _e758;
                }
                let _e761 = phi_925_;
                phi_945_ = _e761;
            } else {
                if (_e736 == 7u) {
                    if _e251 {
                        phi_934_ = (2u | 1u);
                    } else {
                        phi_934_ = 2u;
                    }
                    let _e765 = phi_934_;
                    if _e755 {
                        phi_939_ = (_e765 | 4u);
                    } else {
                        phi_939_ = _e765;
                    }
                    let _e768 = phi_939_;
                    phi_944_ = _e768;
                } else {
                    if _e251 {
                        phi_943_ = 1u;
                    } else {
                        phi_943_ = 0u;
                    }
                    let _e770 = phi_943_;
                    phi_944_ = _e770;
                }
                let _e772 = phi_944_;
                phi_945_ = _e772;
            }
            let _e774 = phi_945_;
            if _e755 {
                phi_949_ = 0f;
            } else {
                phi_949_ = 1f;
            }
            let _e776 = phi_949_;
            if _e255 {
                if (_e93 == 0.99999994f) {
                    phi_958_ = true;
                } else {
                    phi_958_ = (_e93 == 0.000000059604645f);
                }
                let _e780 = phi_958_;
                phi_959_ = _e780;
            } else {
                phi_959_ = true;
            }
            let _e782 = phi_959_;
            phi_961_ = mask_Masked(_e776, _e774, _e751, _e782);
        }
        let _e785 = phi_961_;
        visibility.member[_e69.first_primitive] = _e785.visibility;
        let _e790 = p.member.light.number;
        let _e791 = (_e790 * 3u);
        let _e793 = (_e791 % 32u);
        let _e795 = p.member.light.mask_words;
        let _e797 = ((_e69.first_primitive * _e795) + (_e791 / 32u));
        let _e799 = bits.member[_e797];
        bits.member[_e797] = ((_e799 & ~((7u << bitcast<u32>((_e793 & 31u))))) | (_e785.bits << bitcast<u32>((_e793 & 31u))));
        if (_e793 > 29u) {
            let _e814 = bits.member[(_e797 + 1u)];
            let _e816 = (32u - _e793);
            bits.member[(_e797 + 1u)] = ((_e814 & ~((7u >> bitcast<u32>((_e816 & 31u))))) | (_e785.bits >> bitcast<u32>((_e816 & 31u))));
        }
        phi_1013_ = doubt_Listed(_e69.first_primitive, _e785.is_trusted);
        phi_1014_ = _e785.needs_ray;
    } else {
        phi_1013_ = doubt_Listed(0u, false);
        phi_1014_ = false;
    }
    let _e832 = phi_1013_;
    let _e834 = phi_1014_;
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e834 {
        let _e840 = atomicAdd((&shared_[0u]), 1u);
        phi_1027_ = _e840;
    } else {
        phi_1027_ = 0u;
    }
    let _e842 = phi_1027_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e846 = atomicLoad((&shared_[0u]));
        let _e847 = atomicAdd((&list.member[3u]), _e846);
        atomicStore((&shared_[1u]), _e847);
    }
    workgroupBarrier();
    if _e834 {
        if _e832.is_trusted {
            phi_1044_ = (_e832.pixel | 2147483648u);
        } else {
            phi_1044_ = _e832.pixel;
        }
        let _e851 = phi_1044_;
        let _e853 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e853) + _e842)]), _e851);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
