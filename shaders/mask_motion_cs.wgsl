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
    var phi_158_: lt_bvh_traverse_Tree;
    var phi_159_: bool;
    var phi_160_: lt_bvh_traverse_Tree;
    var phi_161_: bool;
    var phi_166_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_158_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_159_ = false;
        } else {
            phi_158_ = lt_bvh_traverse_Tree();
            phi_159_ = true;
        }
        let _e62 = phi_158_;
        let _e64 = phi_159_;
        phi_160_ = _e62;
        phi_161_ = _e64;
    } else {
        phi_160_ = lt_bvh_traverse_Tree();
        phi_161_ = true;
    }
    let _e66 = phi_160_;
    let _e68 = phi_161_;
    if _e68 {
        phi_166_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_166_ = _e66;
    }
    let _e73 = phi_166_;
    return lt_bvh_traverse_Tree(_e73.root, _e73.first_primitive);
}

fn function_() {
    var phi_211_: u32;
    var phi_245_: bool;
    var phi_246_: bool;
    var phi_247_: bool;
    var phi_248_: bool;
    var phi_252_: bool;
    var phi_322_: bool;
    var phi_323_: bool;
    var phi_334_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_335_: bool;
    var phi_336_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_337_: bool;
    var phi_344_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_348_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_361_: bool;
    var phi_392_: bool;
    var phi_393_: bool;
    var phi_394_: bool;
    var phi_395_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_611_: f32;
    var phi_616_: f32;
    var phi_617_: bool;
    var phi_618_: f32;
    var phi_619_: bool;
    var phi_623_: f32;
    var phi_644_: f32;
    var phi_649_: f32;
    var phi_650_: bool;
    var phi_651_: f32;
    var phi_652_: bool;
    var phi_656_: f32;
    var phi_677_: bool;
    var phi_696_: vec2<u32>;
    var phi_697_: bool;
    var phi_698_: bool;
    var phi_699_: bool;
    var phi_700_: vec2<u32>;
    var phi_701_: bool;
    var phi_702_: bool;
    var phi_703_: bool;
    var phi_704_: bool;
    var phi_705_: bool;
    var phi_706_: bool;
    var phi_707_: vec2<u32>;
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_710_: bool;
    var phi_711_: bool;
    var phi_712_: bool;
    var phi_713_: bool;
    var phi_714_: vec2<u32>;
    var phi_715_: bool;
    var phi_716_: bool;
    var phi_717_: bool;
    var phi_718_: bool;
    var phi_727_: bool;
    var phi_728_: bool;
    var phi_729_: bool;
    var phi_730_: bool;
    var phi_734_: bool;
    var phi_735_: bool;
    var phi_736_: vec2<u32>;
    var phi_774_: bool;
    var phi_776_: lt_mask_Reprojection;
    var phi_777_: lt_mask_Reprojection;
    var phi_778_: bool;
    var phi_782_: bool;
    var phi_783_: lt_mask_Reprojection;
    var phi_784_: lt_mask_Reprojection;
    var phi_785_: bool;
    var phi_793_: bool;
    var phi_794_: lt_mask_Reprojection;
    var phi_860_: u32;
    var phi_865_: u32;
    var phi_866_: u32;
    var phi_867_: u32;
    var phi_868_: bool;
    var phi_869_: u32;
    var phi_870_: bool;
    var phi_871_: bool;
    var phi_872_: u32;
    var phi_873_: bool;
    var phi_874_: bool;
    var phi_878_: bool;
    var phi_882_: u32;
    var phi_887_: bool;
    var phi_927_: lt_mask_Neighbourhood;
    var phi_928_: lt_mask_Neighbourhood;
    var phi_929_: lt_mask_Neighbourhood;
    var phi_961_: bool;
    var phi_962_: bool;
    var phi_984_: bool;
    var phi_985_: bool;
    var phi_986_: bool;
    var phi_990_: bool;
    var phi_1012_: bool;
    var phi_1013_: bool;
    var phi_1026_: bool;
    var phi_1027_: bool;
    var phi_1028_: bool;
    var phi_1035_: u32;
    var phi_1036_: u32;
    var phi_1037_: u32;
    var phi_1038_: u32;
    var phi_1039_: u32;
    var phi_1040_: u32;
    var phi_1041_: u32;
    var phi_1053_: bool;
    var phi_1054_: bool;
    var phi_1055_: bool;
    var phi_1056_: bool;
    var phi_1060_: bool;
    var phi_1066_: bool;
    var phi_1074_: u32;
    var phi_1079_: u32;
    var phi_1088_: u32;
    var phi_1093_: u32;
    var phi_1097_: u32;
    var phi_1098_: u32;
    var phi_1099_: u32;
    var phi_1103_: f32;
    var phi_1105_: mask_Masked;
    var phi_1155_: bool;
    var phi_1156_: u32;
    var phi_1167_: u32;

    let _e49 = id_1;
    let _e50 = local_1;
    let _e55 = arrayLength((&heard.member));
    let _e62 = p.member.current.size[0u];
    let _e64 = p.member.current.size[1u];
    let _e65 = lt_shaders_entry_pixel_index(_e49, _e62, _e64);
    if (bitcast<i32>(_e65.root) != 0i) {
        let _e73 = p.member.current.size[0u];
        if (32u == 0u) {
            return;
        }
        let _e75 = (_e73 / 32u);
        if (32u == 0u) {
            return;
        }
        if ((_e73 % 32u) > 0u) {
            phi_211_ = (_e75 + 1u);
        } else {
            phi_211_ = _e75;
        }
        let _e81 = phi_211_;
        let _e84 = samples.member[_e65.first_primitive].position;
        let _e86 = visibility.member[_e65.first_primitive];
        let _e92 = samples.member[_e65.first_primitive].normal[0u];
        let _e94 = global[0u];
        if (_e92 == _e94) {
            let _e97 = samples.member[_e65.first_primitive].normal[1u];
            let _e99 = global[1u];
            if (_e97 == _e99) {
                let _e102 = samples.member[_e65.first_primitive].normal[2u];
                let _e104 = global[2u];
                phi_245_ = (_e102 == _e104);
                phi_246_ = false;
            } else {
                phi_245_ = bool();
                phi_246_ = true;
            }
            let _e107 = phi_245_;
            let _e109 = phi_246_;
            phi_247_ = _e107;
            phi_248_ = _e109;
        } else {
            phi_247_ = bool();
            phi_248_ = true;
        }
        let _e111 = phi_247_;
        let _e113 = phi_248_;
        if _e113 {
            phi_252_ = false;
        } else {
            phi_252_ = _e111;
        }
        let _e115 = phi_252_;
        if !(_e115) {
            let _e118 = samples.member[_e65.first_primitive].position;
            let _e120 = p.member.light.place;
            let _e126 = p.member.light.place[3u];
            let _e133 = (_e120.x - (_e118.x * _e126));
            let _e134 = (_e120.y - (_e118.y * _e126));
            let _e135 = (_e120.z - (_e118.z * _e126));
            let _e137 = samples.member[_e65.first_primitive].normal;
            if ((((_e137.x * _e133) + (_e137.y * _e134)) + (_e137.z * _e135)) > 0f) {
                let _e151 = (((_e133 * _e133) + (_e134 * _e134)) + (_e135 * _e135));
                let _e153 = p.member.light.axis;
                let _e165 = p.member.light.place[3u];
                if (_e165 == 0f) {
                    phi_323_ = true;
                } else {
                    let _e168 = p.member.light.range_squared;
                    if (_e151 <= _e168) {
                        let _e171 = p.member.light.cos_outer;
                        phi_322_ = (-((((_e133 * _e153.x) + (_e134 * _e153.y)) + (_e135 * _e153.z))) >= (_e171 * sqrt(_e151)));
                    } else {
                        phi_322_ = false;
                    }
                    let _e176 = phi_322_;
                    phi_323_ = _e176;
                }
                let _e178 = phi_323_;
                if _e178 {
                    let _e180 = samples.member[_e65.first_primitive].flags;
                    let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e194 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e188.unnamed.visibility, false), _e188.unnamed_1);
                    phi_334_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e194.unnamed, ((_e180 & 1u) == 0u));
                    phi_335_ = false;
                } else {
                    phi_334_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_335_ = true;
                }
                let _e199 = phi_334_;
                let _e201 = phi_335_;
                phi_336_ = _e199;
                phi_337_ = _e201;
            } else {
                phi_336_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_337_ = true;
            }
            let _e203 = phi_336_;
            let _e205 = phi_337_;
            if _e205 {
                let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e211.unnamed.visibility, false), _e211.unnamed_1);
                phi_344_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e217.unnamed, true);
            } else {
                phi_344_ = _e203;
            }
            let _e222 = phi_344_;
            phi_348_ = _e222;
        } else {
            let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e234 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e228.unnamed.visibility, false), _e228.unnamed_1);
            phi_348_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e234.unnamed, true);
        }
        let _e239 = phi_348_;
        if _e239.unnamed_1 {
            phi_1105_ = mask_Masked(_e239.unnamed.visibility, 0u, false);
        } else {
            let _e244 = (_e86 < 0.5f);
            if (_e86 > 0f) {
                phi_361_ = (_e86 < 1f);
            } else {
                phi_361_ = false;
            }
            let _e248 = phi_361_;
            let _e255 = lt_mask_Reprojection(vec2<u32>(_e49.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e262 = lt_mask_Reprojection(vec2<u32>(_e255.pixel.x, _e49.y), _e255.is_valid, _e255.has_moved);
            let _e266 = lt_mask_Reprojection(_e262.pixel, true, _e262.has_moved);
            let _e272 = p.member.flags;
            if ((_e272 & 16u) == 0u) {
                phi_400_ = false;
            } else {
                let _e278 = samples.member[_e65.first_primitive].position[0u];
                if (_e84.x == _e278) {
                    let _e282 = samples.member[_e65.first_primitive].position[1u];
                    if (_e84.y == _e282) {
                        let _e286 = samples.member[_e65.first_primitive].position[2u];
                        phi_392_ = (_e84.z == _e286);
                        phi_393_ = false;
                    } else {
                        phi_392_ = bool();
                        phi_393_ = true;
                    }
                    let _e289 = phi_392_;
                    let _e291 = phi_393_;
                    phi_394_ = _e289;
                    phi_395_ = _e291;
                } else {
                    phi_394_ = bool();
                    phi_395_ = true;
                }
                let _e293 = phi_394_;
                let _e295 = phi_395_;
                if _e295 {
                    phi_399_ = false;
                } else {
                    phi_399_ = _e293;
                }
                let _e297 = phi_399_;
                phi_400_ = _e297;
            }
            let _e299 = phi_400_;
            if _e299 {
                phi_783_ = lt_mask_Reprojection(_e266.pixel, _e266.is_valid, false);
                phi_784_ = lt_mask_Reprojection();
                phi_785_ = true;
            } else {
                let _e301 = samples.member[_e65.first_primitive].position;
                let _e305 = p.member.previous.eye;
                let _e308 = (_e84.x - _e305.x);
                let _e311 = (_e84.y - _e305.y);
                let _e314 = (_e84.z - _e305.z);
                let _e316 = p.member.previous.forward;
                let _e324 = (((_e308 * _e316.x) + (_e311 * _e316.y)) + (_e314 * _e316.z));
                let _e326 = p.member.previous.right;
                let _e336 = p.member.previous.right;
                let _e351 = p.member.previous.up;
                let _e361 = p.member.previous.up;
                let _e376 = p.member.current.eye;
                let _e379 = (_e301.x - _e376.x);
                let _e382 = (_e301.y - _e376.y);
                let _e385 = (_e301.z - _e376.z);
                let _e387 = p.member.current.forward;
                let _e395 = (((_e379 * _e387.x) + (_e382 * _e387.y)) + (_e385 * _e387.z));
                let _e397 = p.member.current.right;
                let _e407 = p.member.current.right;
                let _e422 = p.member.current.up;
                let _e432 = p.member.current.up;
                let _e451 = p.member.current.size[0u];
                let _e453 = (((((((_e308 * _e326.x) + (_e311 * _e326.y)) + (_e314 * _e326.z)) / ((((_e336.x * _e336.x) + (_e336.y * _e336.y)) + (_e336.z * _e336.z)) * _e324)) - ((((_e379 * _e397.x) + (_e382 * _e397.y)) + (_e385 * _e397.z)) / ((((_e407.x * _e407.x) + (_e407.y * _e407.y)) + (_e407.z * _e407.z)) * _e395))) * 0.5f) * f32(_e451));
                let _e457 = p.member.current.size[1u];
                let _e459 = (((((((_e308 * _e351.x) + (_e311 * _e351.y)) + (_e314 * _e351.z)) / ((((_e361.x * _e361.x) + (_e361.y * _e361.y)) + (_e361.z * _e361.z)) * _e324)) - ((((_e379 * _e422.x) + (_e382 * _e422.y)) + (_e385 * _e422.z)) / ((((_e432.x * _e432.x) + (_e432.y * _e432.y)) + (_e432.z * _e432.z)) * _e395))) * -0.5f) * f32(_e457));
                let _e463 = p.member.current.grid[0u];
                let _e465 = p.member.current.grid[1u];
                let _e485 = p.member.current.size[0u];
                let _e487 = p.member.current.size[1u];
                let _e489 = ((f32(_e49.x) + ((f32((_e49.y & (_e465 - 1u))) + 0.5f) / f32(_e465))) + _e453);
                if (_e489 > -8388608f) {
                    let _e501 = f32(select(0i, select(select(i32(_e489), i32(-2147483648), (_e489 < bitcast<f32>(3472883712u))), 2147483647i, (_e489 > bitcast<f32>(1325400063u))), (_e489 == _e489)));
                    if (_e501 > _e489) {
                        phi_611_ = 1f;
                    } else {
                        phi_611_ = 0f;
                    }
                    let _e504 = phi_611_;
                    if (_e489 < 8388608f) {
                        phi_616_ = (_e501 - _e504);
                        phi_617_ = false;
                    } else {
                        phi_616_ = f32();
                        phi_617_ = true;
                    }
                    let _e507 = phi_616_;
                    let _e509 = phi_617_;
                    phi_618_ = _e507;
                    phi_619_ = _e509;
                } else {
                    phi_618_ = f32();
                    phi_619_ = true;
                }
                let _e511 = phi_618_;
                let _e513 = phi_619_;
                if _e513 {
                    phi_623_ = _e489;
                } else {
                    phi_623_ = _e511;
                }
                let _e515 = phi_623_;
                let _e516 = ((f32(_e49.y) + ((f32((_e49.x & (_e463 - 1u))) + 0.5f) / f32(_e463))) + _e459);
                if (_e516 > -8388608f) {
                    let _e528 = f32(select(0i, select(select(i32(_e516), i32(-2147483648), (_e516 < bitcast<f32>(3472883712u))), 2147483647i, (_e516 > bitcast<f32>(1325400063u))), (_e516 == _e516)));
                    if (_e528 > _e516) {
                        phi_644_ = 1f;
                    } else {
                        phi_644_ = 0f;
                    }
                    let _e531 = phi_644_;
                    if (_e516 < 8388608f) {
                        phi_649_ = (_e528 - _e531);
                        phi_650_ = false;
                    } else {
                        phi_649_ = f32();
                        phi_650_ = true;
                    }
                    let _e534 = phi_649_;
                    let _e536 = phi_650_;
                    phi_651_ = _e534;
                    phi_652_ = _e536;
                } else {
                    phi_651_ = f32();
                    phi_652_ = true;
                }
                let _e538 = phi_651_;
                let _e540 = phi_652_;
                if _e540 {
                    phi_656_ = _e516;
                } else {
                    phi_656_ = _e538;
                }
                let _e542 = phi_656_;
                if (_e515 >= 0f) {
                    if (_e542 >= 0f) {
                        if (_e515 < f32(_e485)) {
                            let _e548 = (_e542 < f32(_e487));
                            if (_e453 == 0f) {
                                phi_677_ = (_e459 == 0f);
                            } else {
                                phi_677_ = false;
                            }
                            let _e552 = phi_677_;
                            if _e548 {
                                phi_696_ = vec2<u32>(select(select(u32(_e515), 0u, (_e515 < bitcast<f32>(0u))), 4294967295u, (_e515 > bitcast<f32>(1333788671u))), select(select(u32(_e542), 0u, (_e542 < bitcast<f32>(0u))), 4294967295u, (_e542 > bitcast<f32>(1333788671u))));
                                phi_697_ = false;
                            } else {
                                phi_696_ = vec2<u32>();
                                phi_697_ = true;
                            }
                            let _e569 = phi_696_;
                            let _e571 = phi_697_;
                            phi_698_ = _e552;
                            phi_699_ = _e548;
                            phi_700_ = _e569;
                            phi_701_ = _e552;
                            phi_702_ = _e548;
                            phi_703_ = false;
                            phi_704_ = _e571;
                        } else {
                            phi_698_ = bool();
                            phi_699_ = bool();
                            phi_700_ = vec2<u32>();
                            phi_701_ = bool();
                            phi_702_ = bool();
                            phi_703_ = true;
                            phi_704_ = false;
                        }
                        let _e573 = phi_698_;
                        let _e575 = phi_699_;
                        let _e577 = phi_700_;
                        let _e579 = phi_701_;
                        let _e581 = phi_702_;
                        let _e583 = phi_703_;
                        let _e585 = phi_704_;
                        phi_705_ = _e573;
                        phi_706_ = _e575;
                        phi_707_ = _e577;
                        phi_708_ = _e579;
                        phi_709_ = _e581;
                        phi_710_ = _e583;
                        phi_711_ = _e585;
                    } else {
                        phi_705_ = bool();
                        phi_706_ = bool();
                        phi_707_ = vec2<u32>();
                        phi_708_ = bool();
                        phi_709_ = bool();
                        phi_710_ = true;
                        phi_711_ = false;
                    }
                    let _e587 = phi_705_;
                    let _e589 = phi_706_;
                    let _e591 = phi_707_;
                    let _e593 = phi_708_;
                    let _e595 = phi_709_;
                    let _e597 = phi_710_;
                    let _e599 = phi_711_;
                    phi_712_ = _e587;
                    phi_713_ = _e589;
                    phi_714_ = _e591;
                    phi_715_ = _e593;
                    phi_716_ = _e595;
                    phi_717_ = _e597;
                    phi_718_ = _e599;
                } else {
                    phi_712_ = bool();
                    phi_713_ = bool();
                    phi_714_ = vec2<u32>();
                    phi_715_ = bool();
                    phi_716_ = bool();
                    phi_717_ = true;
                    phi_718_ = false;
                }
                let _e601 = phi_712_;
                let _e603 = phi_713_;
                let _e605 = phi_714_;
                let _e607 = phi_715_;
                let _e609 = phi_716_;
                let _e611 = phi_717_;
                let _e613 = phi_718_;
                if _e611 {
                    if (_e453 == 0f) {
                        phi_727_ = (_e459 == 0f);
                    } else {
                        phi_727_ = false;
                    }
                    let _e617 = phi_727_;
                    phi_728_ = _e617;
                    phi_729_ = false;
                    phi_730_ = true;
                } else {
                    phi_728_ = _e607;
                    phi_729_ = _e609;
                    phi_730_ = _e613;
                }
                let _e619 = phi_728_;
                let _e621 = phi_729_;
                let _e623 = phi_730_;
                if _e623 {
                    phi_734_ = _e619;
                    phi_735_ = _e621;
                    phi_736_ = vec2<u32>(_e49.x, _e49.y);
                } else {
                    phi_734_ = _e601;
                    phi_735_ = _e603;
                    phi_736_ = _e605;
                }
                let _e625 = phi_734_;
                let _e627 = phi_735_;
                let _e629 = phi_736_;
                let _e639 = lt_mask_Reprojection(vec2<u32>(_e629.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e646 = lt_mask_Reprojection(vec2<u32>(_e639.pixel.x, _e629.y), _e639.is_valid, _e639.has_moved);
                let _e650 = lt_mask_Reprojection(_e646.pixel, _e627, _e646.has_moved);
                let _e654 = lt_mask_Reprojection(_e650.pixel, _e650.is_valid, !(_e625));
                if _e627 {
                    let _e657 = p.member.previous.eye;
                    let _e668 = p.member.previous.forward;
                    let _e677 = (((((_e84.x - _e657.x) * _e668.x) + ((_e84.y - _e657.y) * _e668.y)) + ((_e84.z - _e657.z) * _e668.z)) > 0f);
                    let _e681 = lt_mask_Reprojection(_e654.pixel, _e677, _e654.has_moved);
                    if _e677 {
                        phi_774_ = false;
                    } else {
                        phi_774_ = true;
                    }
                    let _e683 = phi_774_;
                    phi_776_ = _e681;
                    phi_777_ = _e681;
                    phi_778_ = _e683;
                } else {
                    phi_776_ = lt_mask_Reprojection();
                    phi_777_ = lt_mask_Reprojection(_e654.pixel, false, _e654.has_moved);
                    phi_778_ = true;
                }
                let _e689 = phi_776_;
                let _e691 = phi_777_;
                let _e693 = phi_778_;
                if _e693 {
                    phi_782_ = false;
                } else {
                    phi_782_ = true;
                }
                let _e695 = phi_782_;
                phi_783_ = _e689;
                phi_784_ = _e691;
                phi_785_ = _e695;
            }
            let _e697 = phi_783_;
            let _e699 = phi_784_;
            let _e701 = phi_785_;
            if _e701 {
                let _e703 = p.member.flags;
                phi_793_ = ((_e703 & 1u) != 0u);
                phi_794_ = _e697;
            } else {
                phi_793_ = false;
                phi_794_ = _e699;
            }
            let _e707 = phi_793_;
            let _e709 = phi_794_;
            let _e713 = lt_mask_Reprojection(_e709.pixel, _e707, _e709.has_moved);
            let _e715 = p.member.flags;
            let _e717 = ((_e715 & 2u) != 0u);
            let _e719 = p.member.flags;
            if ((_e719 & 4u) == 0u) {
                phi_872_ = u32();
                phi_873_ = true;
                phi_874_ = false;
            } else {
                if _e707 {
                    if !(_e713.has_moved) {
                        let _e728 = ((((_e49.y * _e81) + (_e49.x / 32u)) * 6u) + 4u);
                        if (_e728 < _e55) {
                        } else {
                            return;
                        }
                        let _e732 = heard.member[(0u + _e728)];
                        if (((_e732 >> bitcast<u32>(((_e49.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e743 = ((((_e49.y * _e81) + (_e49.x / 32u)) * 6u) + 5u);
                            if (_e743 < _e55) {
                            } else {
                                return;
                            }
                            let _e747 = heard.member[(0u + _e743)];
                            if false {
                                phi_860_ = (2u | 1u);
                            } else {
                                phi_860_ = 2u;
                            }
                            let _e756 = phi_860_;
                            if (((_e747 >> bitcast<u32>(((_e49.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_865_ = (_e756 | 4u);
                            } else {
                                phi_865_ = _e756;
                            }
                            let _e759 = phi_865_;
                            phi_866_ = _e759;
                        } else {
                            phi_866_ = 0u;
                        }
                        let _e761 = phi_866_;
                        phi_867_ = _e761;
                        phi_868_ = false;
                    } else {
                        phi_867_ = u32();
                        phi_868_ = true;
                    }
                    let _e763 = phi_867_;
                    let _e765 = phi_868_;
                    phi_869_ = _e763;
                    phi_870_ = false;
                    phi_871_ = _e765;
                } else {
                    phi_869_ = u32();
                    phi_870_ = true;
                    phi_871_ = false;
                }
                let _e767 = phi_869_;
                let _e769 = phi_870_;
                let _e771 = phi_871_;
                phi_872_ = _e767;
                phi_873_ = _e769;
                phi_874_ = _e771;
            }
            let _e773 = phi_872_;
            let _e775 = phi_873_;
            let _e777 = phi_874_;
            if _e775 {
                phi_878_ = true;
            } else {
                phi_878_ = _e777;
            }
            let _e779 = phi_878_;
            if _e779 {
                phi_882_ = 0u;
            } else {
                phi_882_ = _e773;
            }
            let _e781 = phi_882_;
            let _e782 = lt_mask_Neighbourhood(false, true);
            if _e248 {
                phi_887_ = _e717;
            } else {
                phi_887_ = true;
            }
            let _e784 = phi_887_;
            if _e784 {
                if _e707 {
                    if ((_e781 & 2u) != 0u) {
                        phi_927_ = _e782;
                    } else {
                        let _e801 = ((((_e713.pixel.y * _e81) + (_e713.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e244) | (select(0u, 1u, _e713.has_moved) << bitcast<u32>(1i))));
                        if (_e801 < _e55) {
                        } else {
                            return;
                        }
                        let _e805 = heard.member[(0u + _e801)];
                        let _e811 = (((_e805 >> bitcast<u32>(((_e713.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_927_ = lt_mask_Neighbourhood(_e811, !(_e811));
                    }
                    let _e815 = phi_927_;
                    phi_928_ = _e815;
                } else {
                    phi_928_ = _e782;
                }
                let _e817 = phi_928_;
                phi_929_ = _e817;
            } else {
                phi_929_ = _e782;
            }
            let _e819 = phi_929_;
            let _e822 = p.member.frame;
            let _e824 = p.member.refresh;
            if (_e824 == 0u) {
                phi_962_ = false;
            } else {
                if (_e824 == 0u) {
                    return;
                }
                let _e833 = ((_e49.x + (_e49.y * (((_e824 * 5u) / 8u) | 1u))) + (_e822 % _e824));
                if (_e824 == 0u) {
                    phi_961_ = (_e833 == 0u);
                } else {
                    if (_e824 == 0u) {
                        return;
                    }
                    phi_961_ = ((_e833 % _e824) == 0u);
                }
                let _e840 = phi_961_;
                phi_962_ = _e840;
            }
            let _e842 = phi_962_;
            if _e707 {
                if _e842 {
                    phi_984_ = bool();
                } else {
                    phi_984_ = ((_e781 & 2u) != 0u);
                }
                let _e848 = phi_984_;
                phi_985_ = _e848;
                phi_986_ = _e842;
            } else {
                phi_985_ = bool();
                phi_986_ = true;
            }
            let _e850 = phi_985_;
            let _e852 = phi_986_;
            if _e852 {
                phi_990_ = false;
            } else {
                phi_990_ = _e850;
            }
            let _e854 = phi_990_;
            if _e854 {
                phi_1041_ = 7u;
            } else {
                if (_e86 != 0.5f) {
                    if _e707 {
                        if _e842 {
                            phi_1038_ = 6u;
                        } else {
                            if _e248 {
                                phi_1013_ = true;
                            } else {
                                if _e819.any_expands {
                                    phi_1012_ = false;
                                } else {
                                    phi_1012_ = true;
                                }
                                let _e856 = phi_1012_;
                                phi_1013_ = _e856;
                            }
                            let _e858 = phi_1013_;
                            if _e858 {
                                if _e248 {
                                    if _e717 {
                                        if _e819.all_remove {
                                            phi_1026_ = false;
                                        } else {
                                            phi_1026_ = true;
                                        }
                                        let _e860 = phi_1026_;
                                        phi_1027_ = _e860;
                                    } else {
                                        phi_1027_ = true;
                                    }
                                    let _e862 = phi_1027_;
                                    phi_1028_ = _e862;
                                } else {
                                    phi_1028_ = true;
                                }
                                let _e864 = phi_1028_;
                                if _e864 {
                                    if _e248 {
                                        phi_1035_ = 1u;
                                    } else {
                                        phi_1035_ = 0u;
                                    }
                                    let _e866 = phi_1035_;
                                    phi_1036_ = _e866;
                                } else {
                                    phi_1036_ = 5u;
                                }
                                let _e868 = phi_1036_;
                                phi_1037_ = _e868;
                            } else {
                                phi_1037_ = 4u;
                            }
                            let _e870 = phi_1037_;
                            phi_1038_ = _e870;
                        }
                        let _e872 = phi_1038_;
                        phi_1039_ = _e872;
                    } else {
                        phi_1039_ = 3u;
                    }
                    let _e874 = phi_1039_;
                    phi_1040_ = _e874;
                } else {
                    phi_1040_ = 2u;
                }
                let _e876 = phi_1040_;
                phi_1041_ = _e876;
            }
            let _e878 = phi_1041_;
            if !((_e878 == 0u)) {
                if !((_e878 == 5u)) {
                    phi_1053_ = !(_e854);
                    phi_1054_ = false;
                } else {
                    phi_1053_ = bool();
                    phi_1054_ = true;
                }
                let _e885 = phi_1053_;
                let _e887 = phi_1054_;
                phi_1055_ = _e885;
                phi_1056_ = _e887;
            } else {
                phi_1055_ = bool();
                phi_1056_ = true;
            }
            let _e889 = phi_1055_;
            let _e891 = phi_1056_;
            if _e891 {
                phi_1060_ = false;
            } else {
                phi_1060_ = _e889;
            }
            let _e893 = phi_1060_;
            if _e854 {
                phi_1066_ = ((_e781 & 4u) != 0u);
            } else {
                phi_1066_ = _e244;
            }
            let _e897 = phi_1066_;
            if _e893 {
                if _e244 {
                    phi_1074_ = (2u | 1u);
                } else {
                    phi_1074_ = 2u;
                }
                let _e900 = phi_1074_;
                if false {
                    phi_1079_ = (_e900 | 4u);
                } else {
                    phi_1079_ = _e900;
                }
                let _e903 = phi_1079_;
                phi_1099_ = _e903;
            } else {
                if (_e878 == 7u) {
                    if _e244 {
                        phi_1088_ = (2u | 1u);
                    } else {
                        phi_1088_ = 2u;
                    }
                    let _e907 = phi_1088_;
                    if _e897 {
                        phi_1093_ = (_e907 | 4u);
                    } else {
                        phi_1093_ = _e907;
                    }
                    let _e910 = phi_1093_;
                    phi_1098_ = _e910;
                } else {
                    if _e244 {
                        phi_1097_ = 1u;
                    } else {
                        phi_1097_ = 0u;
                    }
                    let _e912 = phi_1097_;
                    phi_1098_ = _e912;
                }
                let _e914 = phi_1098_;
                phi_1099_ = _e914;
            }
            let _e916 = phi_1099_;
            if _e897 {
                phi_1103_ = 0f;
            } else {
                phi_1103_ = 1f;
            }
            let _e918 = phi_1103_;
            phi_1105_ = mask_Masked(_e918, _e916, _e893);
        }
        let _e921 = phi_1105_;
        visibility.member[_e65.first_primitive] = _e921.visibility;
        let _e926 = p.member.light.number;
        let _e927 = (_e926 * 3u);
        let _e929 = (_e927 % 32u);
        let _e931 = p.member.light.mask_words;
        let _e933 = ((_e65.first_primitive * _e931) + (_e927 / 32u));
        let _e935 = bits.member[_e933];
        bits.member[_e933] = ((_e935 & ~((7u << bitcast<u32>((_e929 & 31u))))) | (_e921.bits << bitcast<u32>((_e929 & 31u))));
        if (_e929 > 29u) {
            let _e950 = bits.member[(_e933 + 1u)];
            let _e952 = (32u - _e929);
            bits.member[(_e933 + 1u)] = ((_e950 & ~((7u >> bitcast<u32>((_e952 & 31u))))) | (_e921.bits >> bitcast<u32>((_e952 & 31u))));
        }
        phi_1155_ = _e921.needs_ray;
        phi_1156_ = _e65.first_primitive;
    } else {
        phi_1155_ = false;
        phi_1156_ = 0u;
    }
    let _e966 = phi_1155_;
    let _e968 = phi_1156_;
    if (_e50 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e966 {
        let _e972 = atomicAdd((&shared_[0u]), 1u);
        phi_1167_ = _e972;
    } else {
        phi_1167_ = 0u;
    }
    let _e974 = phi_1167_;
    workgroupBarrier();
    if (_e50 == 0u) {
        let _e978 = atomicLoad((&shared_[0u]));
        let _e979 = atomicAdd((&list.member[3u]), _e978);
        atomicStore((&shared_[1u]), _e979);
    }
    workgroupBarrier();
    if _e966 {
        let _e982 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e982) + _e974)]), _e968);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
