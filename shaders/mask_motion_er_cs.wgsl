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
    var phi_161_: lt_bvh_traverse_Tree;
    var phi_162_: bool;
    var phi_163_: lt_bvh_traverse_Tree;
    var phi_164_: bool;
    var phi_169_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_161_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_162_ = false;
        } else {
            phi_161_ = lt_bvh_traverse_Tree();
            phi_162_ = true;
        }
        let _e63 = phi_161_;
        let _e65 = phi_162_;
        phi_163_ = _e63;
        phi_164_ = _e65;
    } else {
        phi_163_ = lt_bvh_traverse_Tree();
        phi_164_ = true;
    }
    let _e67 = phi_163_;
    let _e69 = phi_164_;
    if _e69 {
        phi_169_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_169_ = _e67;
    }
    let _e74 = phi_169_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn function_() {
    var phi_215_: u32;
    var phi_249_: bool;
    var phi_250_: bool;
    var phi_251_: bool;
    var phi_252_: bool;
    var phi_256_: bool;
    var phi_326_: bool;
    var phi_327_: bool;
    var phi_338_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_339_: bool;
    var phi_340_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_341_: bool;
    var phi_348_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_352_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_365_: bool;
    var phi_396_: bool;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_403_: bool;
    var phi_404_: bool;
    var phi_550_: f32;
    var phi_555_: f32;
    var phi_556_: bool;
    var phi_557_: f32;
    var phi_558_: bool;
    var phi_562_: f32;
    var phi_583_: f32;
    var phi_588_: f32;
    var phi_589_: bool;
    var phi_590_: f32;
    var phi_591_: bool;
    var phi_595_: f32;
    var phi_616_: bool;
    var phi_635_: vec2<u32>;
    var phi_636_: bool;
    var phi_637_: bool;
    var phi_638_: bool;
    var phi_639_: vec2<u32>;
    var phi_640_: bool;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_643_: bool;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: vec2<u32>;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_653_: vec2<u32>;
    var phi_654_: bool;
    var phi_655_: bool;
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_666_: bool;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_669_: bool;
    var phi_673_: bool;
    var phi_674_: bool;
    var phi_675_: vec2<u32>;
    var phi_713_: bool;
    var phi_715_: lt_mask_Reprojection;
    var phi_716_: lt_mask_Reprojection;
    var phi_717_: bool;
    var phi_721_: bool;
    var phi_722_: lt_mask_Reprojection;
    var phi_723_: lt_mask_Reprojection;
    var phi_724_: bool;
    var phi_732_: bool;
    var phi_733_: lt_mask_Reprojection;
    var phi_739_: bool;
    var phi_779_: lt_mask_Neighbourhood;
    var phi_780_: lt_mask_Neighbourhood;
    var phi_781_: lt_mask_Neighbourhood;
    var phi_813_: bool;
    var phi_814_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_842_: bool;
    var phi_864_: bool;
    var phi_865_: bool;
    var phi_878_: bool;
    var phi_879_: bool;
    var phi_880_: bool;
    var phi_887_: u32;
    var phi_888_: u32;
    var phi_889_: u32;
    var phi_890_: u32;
    var phi_891_: u32;
    var phi_892_: u32;
    var phi_893_: u32;
    var phi_905_: bool;
    var phi_906_: bool;
    var phi_907_: bool;
    var phi_908_: bool;
    var phi_912_: bool;
    var phi_918_: bool;
    var phi_926_: u32;
    var phi_931_: u32;
    var phi_940_: u32;
    var phi_945_: u32;
    var phi_949_: u32;
    var phi_950_: u32;
    var phi_951_: u32;
    var phi_955_: f32;
    var phi_964_: bool;
    var phi_965_: bool;
    var phi_967_: mask_Masked;
    var phi_1019_: doubt_Listed;
    var phi_1020_: bool;
    var phi_1033_: u32;
    var phi_1050_: u32;

    let _e50 = id_1;
    let _e51 = local_1;
    let _e64 = p.member.current.size[0u];
    let _e66 = p.member.current.size[1u];
    let _e67 = lt_shaders_entry_pixel_index(_e50, _e64, _e66);
    if (bitcast<i32>(_e67.root) != 0i) {
        let _e75 = p.member.current.size[0u];
        if (32u == 0u) {
            return;
        }
        let _e77 = (_e75 / 32u);
        if (32u == 0u) {
            return;
        }
        if ((_e75 % 32u) > 0u) {
            phi_215_ = (_e77 + 1u);
        } else {
            phi_215_ = _e77;
        }
        let _e83 = phi_215_;
        let _e86 = samples.member[_e67.first_primitive].position;
        let _e88 = visibility.member[_e67.first_primitive];
        let _e94 = samples.member[_e67.first_primitive].normal[0u];
        let _e96 = global[0u];
        if (_e94 == _e96) {
            let _e99 = samples.member[_e67.first_primitive].normal[1u];
            let _e101 = global[1u];
            if (_e99 == _e101) {
                let _e104 = samples.member[_e67.first_primitive].normal[2u];
                let _e106 = global[2u];
                phi_249_ = (_e104 == _e106);
                phi_250_ = false;
            } else {
                phi_249_ = bool();
                phi_250_ = true;
            }
            let _e109 = phi_249_;
            let _e111 = phi_250_;
            phi_251_ = _e109;
            phi_252_ = _e111;
        } else {
            phi_251_ = bool();
            phi_252_ = true;
        }
        let _e113 = phi_251_;
        let _e115 = phi_252_;
        if _e115 {
            phi_256_ = false;
        } else {
            phi_256_ = _e113;
        }
        let _e117 = phi_256_;
        if !(_e117) {
            let _e120 = samples.member[_e67.first_primitive].position;
            let _e122 = p.member.light.place;
            let _e128 = p.member.light.place[3u];
            let _e135 = (_e122.x - (_e120.x * _e128));
            let _e136 = (_e122.y - (_e120.y * _e128));
            let _e137 = (_e122.z - (_e120.z * _e128));
            let _e139 = samples.member[_e67.first_primitive].normal;
            if ((((_e139.x * _e135) + (_e139.y * _e136)) + (_e139.z * _e137)) > 0f) {
                let _e153 = (((_e135 * _e135) + (_e136 * _e136)) + (_e137 * _e137));
                let _e155 = p.member.light.axis;
                let _e167 = p.member.light.place[3u];
                if (_e167 == 0f) {
                    phi_327_ = true;
                } else {
                    let _e170 = p.member.light.range_squared;
                    if (_e153 <= _e170) {
                        let _e173 = p.member.light.cos_outer;
                        phi_326_ = (-((((_e135 * _e155.x) + (_e136 * _e155.y)) + (_e137 * _e155.z))) >= (_e173 * sqrt(_e153)));
                    } else {
                        phi_326_ = false;
                    }
                    let _e178 = phi_326_;
                    phi_327_ = _e178;
                }
                let _e180 = phi_327_;
                if _e180 {
                    let _e182 = samples.member[_e67.first_primitive].flags;
                    let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e190.unnamed.visibility, false), _e190.unnamed_1);
                    phi_338_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e196.unnamed, ((_e182 & 1u) == 0u));
                    phi_339_ = false;
                } else {
                    phi_338_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_339_ = true;
                }
                let _e201 = phi_338_;
                let _e203 = phi_339_;
                phi_340_ = _e201;
                phi_341_ = _e203;
            } else {
                phi_340_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_341_ = true;
            }
            let _e205 = phi_340_;
            let _e207 = phi_341_;
            if _e207 {
                let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
                phi_348_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
            } else {
                phi_348_ = _e205;
            }
            let _e224 = phi_348_;
            phi_352_ = _e224;
        } else {
            let _e230 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e236 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e230.unnamed.visibility, false), _e230.unnamed_1);
            phi_352_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e236.unnamed, true);
        }
        let _e241 = phi_352_;
        if _e241.unnamed_1 {
            phi_967_ = mask_Masked(_e241.unnamed.visibility, 0u, false, false);
        } else {
            let _e246 = (_e88 < 0.5f);
            if (_e88 > 0f) {
                phi_365_ = (_e88 < 1f);
            } else {
                phi_365_ = false;
            }
            let _e250 = phi_365_;
            let _e257 = lt_mask_Reprojection(vec2<u32>(_e50.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e264 = lt_mask_Reprojection(vec2<u32>(_e257.pixel.x, _e50.y), _e257.is_valid, _e257.has_moved);
            let _e268 = lt_mask_Reprojection(_e264.pixel, true, _e264.has_moved);
            let _e274 = p.member.flags;
            if ((_e274 & 16u) == 0u) {
                phi_404_ = false;
            } else {
                let _e280 = samples.member[_e67.first_primitive].position[0u];
                if (_e86.x == _e280) {
                    let _e284 = samples.member[_e67.first_primitive].position[1u];
                    if (_e86.y == _e284) {
                        let _e288 = samples.member[_e67.first_primitive].position[2u];
                        phi_396_ = (_e86.z == _e288);
                        phi_397_ = false;
                    } else {
                        phi_396_ = bool();
                        phi_397_ = true;
                    }
                    let _e291 = phi_396_;
                    let _e293 = phi_397_;
                    phi_398_ = _e291;
                    phi_399_ = _e293;
                } else {
                    phi_398_ = bool();
                    phi_399_ = true;
                }
                let _e295 = phi_398_;
                let _e297 = phi_399_;
                if _e297 {
                    phi_403_ = false;
                } else {
                    phi_403_ = _e295;
                }
                let _e299 = phi_403_;
                phi_404_ = _e299;
            }
            let _e301 = phi_404_;
            if _e301 {
                phi_722_ = lt_mask_Reprojection(_e268.pixel, _e268.is_valid, false);
                phi_723_ = lt_mask_Reprojection();
                phi_724_ = true;
            } else {
                let _e305 = p.member.current.grid[0u];
                let _e307 = p.member.current.grid[1u];
                let _e321 = (f32(_e50.x) + ((f32((_e50.y & (_e307 - 1u))) + 0.5f) / f32(_e307)));
                let _e323 = (f32(_e50.y) + ((f32((_e50.x & (_e305 - 1u))) + 0.5f) / f32(_e305)));
                let _e326 = p.member.previous.eye;
                let _e329 = (_e86.x - _e326.x);
                let _e332 = (_e86.y - _e326.y);
                let _e335 = (_e86.z - _e326.z);
                let _e337 = p.member.previous.forward;
                let _e346 = (1f / (((_e329 * _e337.x) + (_e332 * _e337.y)) + (_e335 * _e337.z)));
                let _e348 = p.member.previous.right;
                let _e350 = p.member.previous.right;
                let _e362 = (1f / (((_e350.x * _e350.x) + (_e350.y * _e350.y)) + (_e350.z * _e350.z)));
                let _e370 = p.member.previous.up;
                let _e372 = p.member.previous.up;
                let _e384 = (1f / (((_e372.x * _e372.x) + (_e372.y * _e372.y)) + (_e372.z * _e372.z)));
                let _e406 = p.member.previous.size[0u];
                let _e413 = p.member.previous.size[1u];
                let _e417 = (((((((_e329 * (_e348.x * _e362)) + (_e332 * (_e348.y * _e362))) + (_e335 * (_e348.z * _e362))) * _e346) + 1f) * (0.5f * f32(_e406))) - _e321);
                let _e418 = (((1f - ((((_e329 * (_e370.x * _e384)) + (_e332 * (_e370.y * _e384))) + (_e335 * (_e370.z * _e384))) * _e346)) * (0.5f * f32(_e413))) - _e323);
                let _e422 = p.member.current.size[0u];
                let _e424 = p.member.current.size[1u];
                let _e426 = (_e321 + _e417);
                if (_e426 > -8388608f) {
                    let _e438 = f32(select(0i, select(select(i32(_e426), i32(-2147483648), (_e426 < bitcast<f32>(3472883712u))), 2147483647i, (_e426 > bitcast<f32>(1325400063u))), (_e426 == _e426)));
                    if (_e438 > _e426) {
                        phi_550_ = 1f;
                    } else {
                        phi_550_ = 0f;
                    }
                    let _e441 = phi_550_;
                    if (_e426 < 8388608f) {
                        phi_555_ = (_e438 - _e441);
                        phi_556_ = false;
                    } else {
                        phi_555_ = f32();
                        phi_556_ = true;
                    }
                    let _e444 = phi_555_;
                    let _e446 = phi_556_;
                    phi_557_ = _e444;
                    phi_558_ = _e446;
                } else {
                    phi_557_ = f32();
                    phi_558_ = true;
                }
                let _e448 = phi_557_;
                let _e450 = phi_558_;
                if _e450 {
                    phi_562_ = _e426;
                } else {
                    phi_562_ = _e448;
                }
                let _e452 = phi_562_;
                let _e453 = (_e323 + _e418);
                if (_e453 > -8388608f) {
                    let _e465 = f32(select(0i, select(select(i32(_e453), i32(-2147483648), (_e453 < bitcast<f32>(3472883712u))), 2147483647i, (_e453 > bitcast<f32>(1325400063u))), (_e453 == _e453)));
                    if (_e465 > _e453) {
                        phi_583_ = 1f;
                    } else {
                        phi_583_ = 0f;
                    }
                    let _e468 = phi_583_;
                    if (_e453 < 8388608f) {
                        phi_588_ = (_e465 - _e468);
                        phi_589_ = false;
                    } else {
                        phi_588_ = f32();
                        phi_589_ = true;
                    }
                    let _e471 = phi_588_;
                    let _e473 = phi_589_;
                    phi_590_ = _e471;
                    phi_591_ = _e473;
                } else {
                    phi_590_ = f32();
                    phi_591_ = true;
                }
                let _e475 = phi_590_;
                let _e477 = phi_591_;
                if _e477 {
                    phi_595_ = _e453;
                } else {
                    phi_595_ = _e475;
                }
                let _e479 = phi_595_;
                if (_e452 >= 0f) {
                    if (_e479 >= 0f) {
                        if (_e452 < f32(_e422)) {
                            let _e485 = (_e479 < f32(_e424));
                            if (_e417 == 0f) {
                                phi_616_ = (_e418 == 0f);
                            } else {
                                phi_616_ = false;
                            }
                            let _e489 = phi_616_;
                            if _e485 {
                                phi_635_ = vec2<u32>(select(select(u32(_e452), 0u, (_e452 < bitcast<f32>(0u))), 4294967295u, (_e452 > bitcast<f32>(1333788671u))), select(select(u32(_e479), 0u, (_e479 < bitcast<f32>(0u))), 4294967295u, (_e479 > bitcast<f32>(1333788671u))));
                                phi_636_ = false;
                            } else {
                                phi_635_ = vec2<u32>();
                                phi_636_ = true;
                            }
                            let _e506 = phi_635_;
                            let _e508 = phi_636_;
                            phi_637_ = _e489;
                            phi_638_ = _e485;
                            phi_639_ = _e506;
                            phi_640_ = _e489;
                            phi_641_ = _e485;
                            phi_642_ = false;
                            phi_643_ = _e508;
                        } else {
                            phi_637_ = bool();
                            phi_638_ = bool();
                            phi_639_ = vec2<u32>();
                            phi_640_ = bool();
                            phi_641_ = bool();
                            phi_642_ = true;
                            phi_643_ = false;
                        }
                        let _e510 = phi_637_;
                        let _e512 = phi_638_;
                        let _e514 = phi_639_;
                        let _e516 = phi_640_;
                        let _e518 = phi_641_;
                        let _e520 = phi_642_;
                        let _e522 = phi_643_;
                        phi_644_ = _e510;
                        phi_645_ = _e512;
                        phi_646_ = _e514;
                        phi_647_ = _e516;
                        phi_648_ = _e518;
                        phi_649_ = _e520;
                        phi_650_ = _e522;
                    } else {
                        phi_644_ = bool();
                        phi_645_ = bool();
                        phi_646_ = vec2<u32>();
                        phi_647_ = bool();
                        phi_648_ = bool();
                        phi_649_ = true;
                        phi_650_ = false;
                    }
                    let _e524 = phi_644_;
                    let _e526 = phi_645_;
                    let _e528 = phi_646_;
                    let _e530 = phi_647_;
                    let _e532 = phi_648_;
                    let _e534 = phi_649_;
                    let _e536 = phi_650_;
                    phi_651_ = _e524;
                    phi_652_ = _e526;
                    phi_653_ = _e528;
                    phi_654_ = _e530;
                    phi_655_ = _e532;
                    phi_656_ = _e534;
                    phi_657_ = _e536;
                } else {
                    phi_651_ = bool();
                    phi_652_ = bool();
                    phi_653_ = vec2<u32>();
                    phi_654_ = bool();
                    phi_655_ = bool();
                    phi_656_ = true;
                    phi_657_ = false;
                }
                let _e538 = phi_651_;
                let _e540 = phi_652_;
                let _e542 = phi_653_;
                let _e544 = phi_654_;
                let _e546 = phi_655_;
                let _e548 = phi_656_;
                let _e550 = phi_657_;
                if _e548 {
                    if (_e417 == 0f) {
                        phi_666_ = (_e418 == 0f);
                    } else {
                        phi_666_ = false;
                    }
                    let _e554 = phi_666_;
                    phi_667_ = _e554;
                    phi_668_ = false;
                    phi_669_ = true;
                } else {
                    phi_667_ = _e544;
                    phi_668_ = _e546;
                    phi_669_ = _e550;
                }
                let _e556 = phi_667_;
                let _e558 = phi_668_;
                let _e560 = phi_669_;
                if _e560 {
                    phi_673_ = _e556;
                    phi_674_ = _e558;
                    phi_675_ = vec2<u32>(_e50.x, _e50.y);
                } else {
                    phi_673_ = _e538;
                    phi_674_ = _e540;
                    phi_675_ = _e542;
                }
                let _e562 = phi_673_;
                let _e564 = phi_674_;
                let _e566 = phi_675_;
                let _e576 = lt_mask_Reprojection(vec2<u32>(_e566.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e583 = lt_mask_Reprojection(vec2<u32>(_e576.pixel.x, _e566.y), _e576.is_valid, _e576.has_moved);
                let _e587 = lt_mask_Reprojection(_e583.pixel, _e564, _e583.has_moved);
                let _e591 = lt_mask_Reprojection(_e587.pixel, _e587.is_valid, !(_e562));
                if _e564 {
                    let _e594 = p.member.previous.eye;
                    let _e605 = p.member.previous.forward;
                    let _e614 = (((((_e86.x - _e594.x) * _e605.x) + ((_e86.y - _e594.y) * _e605.y)) + ((_e86.z - _e594.z) * _e605.z)) > 0f);
                    let _e618 = lt_mask_Reprojection(_e591.pixel, _e614, _e591.has_moved);
                    if _e614 {
                        phi_713_ = false;
                    } else {
                        phi_713_ = true;
                    }
                    let _e620 = phi_713_;
                    phi_715_ = _e618;
                    phi_716_ = _e618;
                    phi_717_ = _e620;
                } else {
                    phi_715_ = lt_mask_Reprojection();
                    phi_716_ = lt_mask_Reprojection(_e591.pixel, false, _e591.has_moved);
                    phi_717_ = true;
                }
                let _e626 = phi_715_;
                let _e628 = phi_716_;
                let _e630 = phi_717_;
                if _e630 {
                    phi_721_ = false;
                } else {
                    phi_721_ = true;
                }
                let _e632 = phi_721_;
                phi_722_ = _e626;
                phi_723_ = _e628;
                phi_724_ = _e632;
            }
            let _e634 = phi_722_;
            let _e636 = phi_723_;
            let _e638 = phi_724_;
            if _e638 {
                let _e640 = p.member.flags;
                phi_732_ = ((_e640 & 1u) != 0u);
                phi_733_ = _e634;
            } else {
                phi_732_ = false;
                phi_733_ = _e636;
            }
            let _e644 = phi_732_;
            let _e646 = phi_733_;
            let _e650 = lt_mask_Reprojection(_e646.pixel, _e644, _e646.has_moved);
            let _e651 = lt_mask_Neighbourhood(false, true);
            if _e250 {
                phi_739_ = false;
            } else {
                phi_739_ = true;
            }
            let _e653 = phi_739_;
            if _e653 {
                if _e644 {
                    if ((0u & 2u) != 0u) {
                        phi_779_ = _e651;
                    } else {
                        let _e670 = ((((_e650.pixel.y * _e83) + (_e650.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e246) | (select(0u, 1u, _e650.has_moved) << bitcast<u32>(1i))));
                        if (_e670 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e674 = heard.member[(0u + _e670)];
                        let _e680 = (((_e674 >> bitcast<u32>(((_e650.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_779_ = lt_mask_Neighbourhood(_e680, !(_e680));
                    }
                    let _e684 = phi_779_;
                    phi_780_ = _e684;
                } else {
                    phi_780_ = _e651;
                }
                let _e686 = phi_780_;
                phi_781_ = _e686;
            } else {
                phi_781_ = _e651;
            }
            let _e688 = phi_781_;
            let _e691 = p.member.frame;
            let _e693 = p.member.refresh;
            if (_e693 == 0u) {
                phi_814_ = false;
            } else {
                if (_e693 == 0u) {
                    return;
                }
                let _e702 = ((_e50.x + (_e50.y * (((_e693 * 5u) / 8u) | 1u))) + (_e691 % _e693));
                if (_e693 == 0u) {
                    phi_813_ = (_e702 == 0u);
                } else {
                    if (_e693 == 0u) {
                        return;
                    }
                    phi_813_ = ((_e702 % _e693) == 0u);
                }
                let _e709 = phi_813_;
                phi_814_ = _e709;
            }
            let _e711 = phi_814_;
            if _e644 {
                if _e711 {
                    phi_836_ = bool();
                } else {
                    phi_836_ = ((0u & 2u) != 0u);
                }
                let _e717 = phi_836_;
                phi_837_ = _e717;
                phi_838_ = _e711;
            } else {
                phi_837_ = bool();
                phi_838_ = true;
            }
            let _e719 = phi_837_;
            let _e721 = phi_838_;
            if _e721 {
                phi_842_ = false;
            } else {
                phi_842_ = _e719;
            }
            let _e723 = phi_842_;
            if _e723 {
                phi_893_ = 7u;
            } else {
                if (_e88 != 0.5f) {
                    if _e644 {
                        if _e711 {
                            phi_890_ = 6u;
                        } else {
                            if _e250 {
                                phi_865_ = true;
                            } else {
                                if _e688.any_expands {
                                    phi_864_ = false;
                                } else {
                                    phi_864_ = true;
                                }
                                let _e725 = phi_864_;
                                phi_865_ = _e725;
                            }
                            let _e727 = phi_865_;
                            if _e727 {
                                if _e250 {
                                    if false {
                                        if _e688.all_remove {
                                            phi_878_ = false;
                                        } else {
                                            phi_878_ = true;
                                        }
                                        let _e729 = phi_878_;
                                        phi_879_ = _e729;
                                    } else {
                                        phi_879_ = true;
                                    }
                                    let _e731 = phi_879_;
                                    phi_880_ = _e731;
                                } else {
                                    phi_880_ = true;
                                }
                                let _e733 = phi_880_;
                                if _e733 {
                                    if _e250 {
                                        phi_887_ = 1u;
                                    } else {
                                        phi_887_ = 0u;
                                    }
                                    let _e735 = phi_887_;
                                    phi_888_ = _e735;
                                } else {
                                    phi_888_ = 5u;
                                }
                                let _e737 = phi_888_;
                                phi_889_ = _e737;
                            } else {
                                phi_889_ = 4u;
                            }
                            let _e739 = phi_889_;
                            phi_890_ = _e739;
                        }
                        let _e741 = phi_890_;
                        phi_891_ = _e741;
                    } else {
                        phi_891_ = 3u;
                    }
                    let _e743 = phi_891_;
                    phi_892_ = _e743;
                } else {
                    phi_892_ = 2u;
                }
                let _e745 = phi_892_;
                phi_893_ = _e745;
            }
            let _e747 = phi_893_;
            if !((_e747 == 0u)) {
                if !((_e747 == 5u)) {
                    phi_905_ = !(_e723);
                    phi_906_ = false;
                } else {
                    phi_905_ = bool();
                    phi_906_ = true;
                }
                let _e754 = phi_905_;
                let _e756 = phi_906_;
                phi_907_ = _e754;
                phi_908_ = _e756;
            } else {
                phi_907_ = bool();
                phi_908_ = true;
            }
            let _e758 = phi_907_;
            let _e760 = phi_908_;
            if _e760 {
                phi_912_ = false;
            } else {
                phi_912_ = _e758;
            }
            let _e762 = phi_912_;
            if _e723 {
                phi_918_ = ((0u & 4u) != 0u);
            } else {
                phi_918_ = _e246;
            }
            let _e766 = phi_918_;
            if _e762 {
                if _e246 {
                    phi_926_ = (2u | 1u);
                } else {
                    phi_926_ = 2u;
                }
                let _e769 = phi_926_;
                if false {
                    phi_931_ = (_e769 | 4u);
                } else {
                    phi_931_ = _e769;
                }
                let _e772 = phi_931_;
                phi_951_ = _e772;
            } else {
                if (_e747 == 7u) {
                    if _e246 {
                        phi_940_ = (2u | 1u);
                    } else {
                        phi_940_ = 2u;
                    }
                    let _e776 = phi_940_;
                    if _e766 {
                        phi_945_ = (_e776 | 4u);
                    } else {
                        phi_945_ = _e776;
                    }
                    let _e779 = phi_945_;
                    phi_950_ = _e779;
                } else {
                    if _e246 {
                        phi_949_ = 1u;
                    } else {
                        phi_949_ = 0u;
                    }
                    let _e781 = phi_949_;
                    phi_950_ = _e781;
                }
                let _e783 = phi_950_;
                phi_951_ = _e783;
            }
            let _e785 = phi_951_;
            if _e766 {
                phi_955_ = 0f;
            } else {
                phi_955_ = 1f;
            }
            let _e787 = phi_955_;
            if _e250 {
                if (_e88 == 0.99999994f) {
                    phi_964_ = true;
                } else {
                    phi_964_ = (_e88 == 0.000000059604645f);
                }
                let _e791 = phi_964_;
                phi_965_ = _e791;
            } else {
                phi_965_ = true;
            }
            let _e793 = phi_965_;
            phi_967_ = mask_Masked(_e787, _e785, _e762, _e793);
        }
        let _e796 = phi_967_;
        visibility.member[_e67.first_primitive] = _e796.visibility;
        let _e801 = p.member.light.number;
        let _e802 = (_e801 * 3u);
        let _e804 = (_e802 % 32u);
        let _e806 = p.member.light.mask_words;
        let _e808 = ((_e67.first_primitive * _e806) + (_e802 / 32u));
        let _e810 = bits.member[_e808];
        bits.member[_e808] = ((_e810 & ~((7u << bitcast<u32>((_e804 & 31u))))) | (_e796.bits << bitcast<u32>((_e804 & 31u))));
        if (_e804 > 29u) {
            let _e825 = bits.member[(_e808 + 1u)];
            let _e827 = (32u - _e804);
            bits.member[(_e808 + 1u)] = ((_e825 & ~((7u >> bitcast<u32>((_e827 & 31u))))) | (_e796.bits >> bitcast<u32>((_e827 & 31u))));
        }
        phi_1019_ = doubt_Listed(_e67.first_primitive, _e796.is_trusted);
        phi_1020_ = _e796.needs_ray;
    } else {
        phi_1019_ = doubt_Listed(0u, false);
        phi_1020_ = false;
    }
    let _e843 = phi_1019_;
    let _e845 = phi_1020_;
    if (_e51 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e845 {
        let _e851 = atomicAdd((&shared_[0u]), 1u);
        phi_1033_ = _e851;
    } else {
        phi_1033_ = 0u;
    }
    let _e853 = phi_1033_;
    workgroupBarrier();
    if (_e51 == 0u) {
        let _e857 = atomicLoad((&shared_[0u]));
        let _e858 = atomicAdd((&list.member[3u]), _e857);
        atomicStore((&shared_[1u]), _e858);
    }
    workgroupBarrier();
    if _e845 {
        if _e843.is_trusted {
            phi_1050_ = (_e843.pixel | 2147483648u);
        } else {
            phi_1050_ = _e843.pixel;
        }
        let _e862 = phi_1050_;
        let _e864 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e864) + _e853)]), _e862);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
