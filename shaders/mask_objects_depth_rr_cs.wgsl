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
var<storage> last_depths: type_27;
@group(0) @binding(7) 
var<storage, read_write> depths: type_27;
@group(0) @binding(8) 
var<storage> past: type_43;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_172_: lt_bvh_traverse_Tree;
    var phi_173_: bool;
    var phi_174_: lt_bvh_traverse_Tree;
    var phi_175_: bool;
    var phi_180_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_172_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_173_ = false;
        } else {
            phi_172_ = lt_bvh_traverse_Tree();
            phi_173_ = true;
        }
        let _e67 = phi_172_;
        let _e69 = phi_173_;
        phi_174_ = _e67;
        phi_175_ = _e69;
    } else {
        phi_174_ = lt_bvh_traverse_Tree();
        phi_175_ = true;
    }
    let _e71 = phi_174_;
    let _e73 = phi_175_;
    if _e73 {
        phi_180_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_180_ = _e71;
    }
    let _e78 = phi_180_;
    return lt_bvh_traverse_Tree(_e78.root, _e78.first_primitive);
}

fn function_() {
    var phi_252_: bool;
    var phi_253_: bool;
    var phi_254_: bool;
    var phi_255_: bool;
    var phi_259_: bool;
    var phi_329_: bool;
    var phi_330_: bool;
    var phi_341_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_342_: bool;
    var phi_343_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_344_: bool;
    var phi_351_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_355_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_368_: bool;
    var phi_396_: bool;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_403_: bool;
    var phi_404_: bool;
    var phi_612_: f32;
    var phi_617_: f32;
    var phi_618_: bool;
    var phi_619_: f32;
    var phi_620_: bool;
    var phi_624_: f32;
    var phi_645_: f32;
    var phi_650_: f32;
    var phi_651_: bool;
    var phi_652_: f32;
    var phi_653_: bool;
    var phi_657_: f32;
    var phi_678_: bool;
    var phi_697_: vec2<u32>;
    var phi_698_: bool;
    var phi_699_: bool;
    var phi_700_: bool;
    var phi_701_: vec2<u32>;
    var phi_702_: bool;
    var phi_703_: bool;
    var phi_704_: bool;
    var phi_705_: bool;
    var phi_706_: bool;
    var phi_707_: bool;
    var phi_708_: vec2<u32>;
    var phi_709_: bool;
    var phi_710_: bool;
    var phi_711_: bool;
    var phi_712_: bool;
    var phi_713_: bool;
    var phi_714_: bool;
    var phi_715_: vec2<u32>;
    var phi_716_: bool;
    var phi_717_: bool;
    var phi_718_: bool;
    var phi_719_: bool;
    var phi_728_: bool;
    var phi_729_: bool;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_735_: bool;
    var phi_736_: bool;
    var phi_737_: vec2<u32>;
    var phi_772_: bool;
    var phi_774_: lt_mask_Reprojection;
    var phi_775_: lt_mask_Reprojection;
    var phi_776_: lt_mask_Reprojection;
    var phi_777_: bool;
    var phi_778_: bool;
    var phi_779_: lt_mask_Reprojection;
    var phi_780_: lt_mask_Reprojection;
    var phi_781_: lt_mask_Reprojection;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_835_: bool;
    var phi_839_: f32;
    var phi_843_: lt_mask_Reprojection;
    var phi_844_: bool;
    var phi_856_: bool;
    var phi_857_: bool;
    var phi_858_: bool;
    var phi_859_: lt_mask_Reprojection;
    var phi_860_: bool;
    var phi_864_: bool;
    var phi_865_: lt_mask_Reprojection;
    var phi_903_: u32;
    var phi_952_: u32;
    var phi_957_: u32;
    var phi_958_: u32;
    var phi_959_: u32;
    var phi_960_: bool;
    var phi_961_: u32;
    var phi_962_: bool;
    var phi_963_: bool;
    var phi_964_: u32;
    var phi_965_: bool;
    var phi_966_: bool;
    var phi_970_: bool;
    var phi_974_: u32;
    var phi_979_: bool;
    var phi_1011_: u32;
    var phi_1040_: lt_mask_Neighbourhood;
    var phi_1041_: lt_mask_Neighbourhood;
    var phi_1042_: lt_mask_Neighbourhood;
    var phi_1074_: bool;
    var phi_1075_: bool;
    var phi_1097_: bool;
    var phi_1098_: bool;
    var phi_1099_: bool;
    var phi_1103_: bool;
    var phi_1125_: bool;
    var phi_1126_: bool;
    var phi_1139_: bool;
    var phi_1140_: bool;
    var phi_1141_: bool;
    var phi_1148_: u32;
    var phi_1149_: u32;
    var phi_1150_: u32;
    var phi_1151_: u32;
    var phi_1152_: u32;
    var phi_1153_: u32;
    var phi_1154_: u32;
    var phi_1166_: bool;
    var phi_1167_: bool;
    var phi_1168_: bool;
    var phi_1169_: bool;
    var phi_1173_: bool;
    var phi_1179_: bool;
    var phi_1187_: u32;
    var phi_1192_: u32;
    var phi_1201_: u32;
    var phi_1206_: u32;
    var phi_1210_: u32;
    var phi_1211_: u32;
    var phi_1212_: u32;
    var phi_1216_: f32;
    var phi_1218_: mask_Masked;
    var phi_1290_: bool;
    var phi_1291_: bool;
    var phi_1292_: bool;
    var phi_1293_: bool;
    var phi_1297_: bool;
    var phi_1325_: f32;
    var phi_1328_: bool;
    var phi_1329_: u32;
    var phi_1340_: u32;

    let _e54 = id_1;
    let _e55 = local_1;
    let _e60 = arrayLength((&heard.member));
    let _e72 = p.member.current.size[0u];
    let _e74 = p.member.current.size[1u];
    let _e75 = lt_shaders_entry_pixel_index(_e54, _e72, _e74);
    if (bitcast<i32>(_e75.root) != 0i) {
        let _e83 = p.member.current.size[0u];
        let _e86 = past.member[_e75.first_primitive];
        let _e91 = visibility.member[_e75.first_primitive];
        let _e97 = samples.member[_e75.first_primitive].normal[0u];
        let _e99 = global[0u];
        if (_e97 == _e99) {
            let _e102 = samples.member[_e75.first_primitive].normal[1u];
            let _e104 = global[1u];
            if (_e102 == _e104) {
                let _e107 = samples.member[_e75.first_primitive].normal[2u];
                let _e109 = global[2u];
                phi_252_ = (_e107 == _e109);
                phi_253_ = false;
            } else {
                phi_252_ = bool();
                phi_253_ = true;
            }
            let _e112 = phi_252_;
            let _e114 = phi_253_;
            phi_254_ = _e112;
            phi_255_ = _e114;
        } else {
            phi_254_ = bool();
            phi_255_ = true;
        }
        let _e116 = phi_254_;
        let _e118 = phi_255_;
        if _e118 {
            phi_259_ = false;
        } else {
            phi_259_ = _e116;
        }
        let _e120 = phi_259_;
        if !(_e120) {
            let _e123 = samples.member[_e75.first_primitive].position;
            let _e125 = p.member.light.place;
            let _e131 = p.member.light.place[3u];
            let _e138 = (_e125.x - (_e123.x * _e131));
            let _e139 = (_e125.y - (_e123.y * _e131));
            let _e140 = (_e125.z - (_e123.z * _e131));
            let _e142 = samples.member[_e75.first_primitive].normal;
            if ((((_e142.x * _e138) + (_e142.y * _e139)) + (_e142.z * _e140)) > 0f) {
                let _e156 = (((_e138 * _e138) + (_e139 * _e139)) + (_e140 * _e140));
                let _e158 = p.member.light.axis;
                let _e170 = p.member.light.place[3u];
                if (_e170 == 0f) {
                    phi_330_ = true;
                } else {
                    let _e173 = p.member.light.range_squared;
                    if (_e156 <= _e173) {
                        let _e176 = p.member.light.cos_outer;
                        phi_329_ = (-((((_e138 * _e158.x) + (_e139 * _e158.y)) + (_e140 * _e158.z))) >= (_e176 * sqrt(_e156)));
                    } else {
                        phi_329_ = false;
                    }
                    let _e181 = phi_329_;
                    phi_330_ = _e181;
                }
                let _e183 = phi_330_;
                if _e183 {
                    let _e185 = samples.member[_e75.first_primitive].flags;
                    let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e199 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e193.unnamed.visibility, false), _e193.unnamed_1);
                    phi_341_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e199.unnamed, ((_e185 & 1u) == 0u));
                    phi_342_ = false;
                } else {
                    phi_341_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_342_ = true;
                }
                let _e204 = phi_341_;
                let _e206 = phi_342_;
                phi_343_ = _e204;
                phi_344_ = _e206;
            } else {
                phi_343_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_344_ = true;
            }
            let _e208 = phi_343_;
            let _e210 = phi_344_;
            if _e210 {
                let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e216.unnamed.visibility, false), _e216.unnamed_1);
                phi_351_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e222.unnamed, true);
            } else {
                phi_351_ = _e208;
            }
            let _e227 = phi_351_;
            phi_355_ = _e227;
        } else {
            let _e233 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e239 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e233.unnamed.visibility, false), _e233.unnamed_1);
            phi_355_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e239.unnamed, true);
        }
        let _e244 = phi_355_;
        if _e244.unnamed_1 {
            phi_1218_ = mask_Masked(_e244.unnamed.visibility, 0u, false);
        } else {
            let _e249 = (_e91 < 0.5f);
            if (_e91 > 0f) {
                phi_368_ = (_e91 < 1f);
            } else {
                phi_368_ = false;
            }
            let _e253 = phi_368_;
            let _e260 = lt_mask_Reprojection(vec2<u32>(_e54.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e267 = lt_mask_Reprojection(vec2<u32>(_e260.pixel.x, _e54.y), _e260.is_valid, _e260.has_moved);
            let _e271 = lt_mask_Reprojection(_e267.pixel, true, _e267.has_moved);
            let _e277 = p.member.flags;
            if ((_e277 & 16u) == 0u) {
                phi_404_ = false;
            } else {
                let _e282 = samples.member[_e75.first_primitive].position[0u];
                if (_e86.x == _e282) {
                    let _e285 = samples.member[_e75.first_primitive].position[1u];
                    if (_e86.y == _e285) {
                        let _e288 = samples.member[_e75.first_primitive].position[2u];
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
                phi_779_ = lt_mask_Reprojection(_e271.pixel, _e271.is_valid, false);
                phi_780_ = lt_mask_Reprojection();
                phi_781_ = lt_mask_Reprojection();
                phi_782_ = true;
                phi_783_ = false;
            } else {
                let _e303 = samples.member[_e75.first_primitive].position;
                let _e307 = p.member.previous.eye;
                let _e309 = (_e86.x - _e307.x);
                let _e311 = (_e86.y - _e307.y);
                let _e313 = (_e86.z - _e307.z);
                let _e315 = p.member.previous.forward;
                let _e323 = (((_e309 * _e315.x) + (_e311 * _e315.y)) + (_e313 * _e315.z));
                let _e325 = p.member.previous.right;
                let _e335 = p.member.previous.right;
                let _e350 = p.member.previous.up;
                let _e360 = p.member.previous.up;
                let _e375 = p.member.current.eye;
                let _e378 = (_e303.x - _e375.x);
                let _e381 = (_e303.y - _e375.y);
                let _e384 = (_e303.z - _e375.z);
                let _e386 = p.member.current.forward;
                let _e394 = (((_e378 * _e386.x) + (_e381 * _e386.y)) + (_e384 * _e386.z));
                let _e396 = p.member.current.right;
                let _e406 = p.member.current.right;
                let _e421 = p.member.current.up;
                let _e431 = p.member.current.up;
                let _e450 = p.member.current.size[0u];
                let _e452 = (((((((_e309 * _e325.x) + (_e311 * _e325.y)) + (_e313 * _e325.z)) / ((((_e335.x * _e335.x) + (_e335.y * _e335.y)) + (_e335.z * _e335.z)) * _e323)) - ((((_e378 * _e396.x) + (_e381 * _e396.y)) + (_e384 * _e396.z)) / ((((_e406.x * _e406.x) + (_e406.y * _e406.y)) + (_e406.z * _e406.z)) * _e394))) * 0.5f) * f32(_e450));
                let _e456 = p.member.current.size[1u];
                let _e458 = (((((((_e309 * _e350.x) + (_e311 * _e350.y)) + (_e313 * _e350.z)) / ((((_e360.x * _e360.x) + (_e360.y * _e360.y)) + (_e360.z * _e360.z)) * _e323)) - ((((_e378 * _e421.x) + (_e381 * _e421.y)) + (_e384 * _e421.z)) / ((((_e431.x * _e431.x) + (_e431.y * _e431.y)) + (_e431.z * _e431.z)) * _e394))) * -0.5f) * f32(_e456));
                let _e462 = p.member.current.grid[0u];
                let _e464 = p.member.current.grid[1u];
                let _e484 = p.member.current.size[0u];
                let _e486 = p.member.current.size[1u];
                let _e488 = ((f32(_e54.x) + ((f32((_e54.y & (_e464 - 1u))) + 0.5f) / f32(_e464))) + _e452);
                if (_e488 > -8388608f) {
                    let _e500 = f32(select(0i, select(select(i32(_e488), i32(-2147483648), (_e488 < bitcast<f32>(3472883712u))), 2147483647i, (_e488 > bitcast<f32>(1325400063u))), (_e488 == _e488)));
                    if (_e500 > _e488) {
                        phi_612_ = 1f;
                    } else {
                        phi_612_ = 0f;
                    }
                    let _e503 = phi_612_;
                    if (_e488 < 8388608f) {
                        phi_617_ = (_e500 - _e503);
                        phi_618_ = false;
                    } else {
                        phi_617_ = f32();
                        phi_618_ = true;
                    }
                    let _e506 = phi_617_;
                    let _e508 = phi_618_;
                    phi_619_ = _e506;
                    phi_620_ = _e508;
                } else {
                    phi_619_ = f32();
                    phi_620_ = true;
                }
                let _e510 = phi_619_;
                let _e512 = phi_620_;
                if _e512 {
                    phi_624_ = _e488;
                } else {
                    phi_624_ = _e510;
                }
                let _e514 = phi_624_;
                let _e515 = ((f32(_e54.y) + ((f32((_e54.x & (_e462 - 1u))) + 0.5f) / f32(_e462))) + _e458);
                if (_e515 > -8388608f) {
                    let _e527 = f32(select(0i, select(select(i32(_e515), i32(-2147483648), (_e515 < bitcast<f32>(3472883712u))), 2147483647i, (_e515 > bitcast<f32>(1325400063u))), (_e515 == _e515)));
                    if (_e527 > _e515) {
                        phi_645_ = 1f;
                    } else {
                        phi_645_ = 0f;
                    }
                    let _e530 = phi_645_;
                    if (_e515 < 8388608f) {
                        phi_650_ = (_e527 - _e530);
                        phi_651_ = false;
                    } else {
                        phi_650_ = f32();
                        phi_651_ = true;
                    }
                    let _e533 = phi_650_;
                    let _e535 = phi_651_;
                    phi_652_ = _e533;
                    phi_653_ = _e535;
                } else {
                    phi_652_ = f32();
                    phi_653_ = true;
                }
                let _e537 = phi_652_;
                let _e539 = phi_653_;
                if _e539 {
                    phi_657_ = _e515;
                } else {
                    phi_657_ = _e537;
                }
                let _e541 = phi_657_;
                if (_e514 >= 0f) {
                    if (_e541 >= 0f) {
                        if (_e514 < f32(_e484)) {
                            let _e547 = (_e541 < f32(_e486));
                            if (_e452 == 0f) {
                                phi_678_ = (_e458 == 0f);
                            } else {
                                phi_678_ = false;
                            }
                            let _e551 = phi_678_;
                            if _e547 {
                                phi_697_ = vec2<u32>(select(select(u32(_e514), 0u, (_e514 < bitcast<f32>(0u))), 4294967295u, (_e514 > bitcast<f32>(1333788671u))), select(select(u32(_e541), 0u, (_e541 < bitcast<f32>(0u))), 4294967295u, (_e541 > bitcast<f32>(1333788671u))));
                                phi_698_ = false;
                            } else {
                                phi_697_ = vec2<u32>();
                                phi_698_ = true;
                            }
                            let _e568 = phi_697_;
                            let _e570 = phi_698_;
                            phi_699_ = _e551;
                            phi_700_ = _e547;
                            phi_701_ = _e568;
                            phi_702_ = _e551;
                            phi_703_ = _e547;
                            phi_704_ = false;
                            phi_705_ = _e570;
                        } else {
                            phi_699_ = bool();
                            phi_700_ = bool();
                            phi_701_ = vec2<u32>();
                            phi_702_ = bool();
                            phi_703_ = bool();
                            phi_704_ = true;
                            phi_705_ = false;
                        }
                        let _e572 = phi_699_;
                        let _e574 = phi_700_;
                        let _e576 = phi_701_;
                        let _e578 = phi_702_;
                        let _e580 = phi_703_;
                        let _e582 = phi_704_;
                        let _e584 = phi_705_;
                        phi_706_ = _e572;
                        phi_707_ = _e574;
                        phi_708_ = _e576;
                        phi_709_ = _e578;
                        phi_710_ = _e580;
                        phi_711_ = _e582;
                        phi_712_ = _e584;
                    } else {
                        phi_706_ = bool();
                        phi_707_ = bool();
                        phi_708_ = vec2<u32>();
                        phi_709_ = bool();
                        phi_710_ = bool();
                        phi_711_ = true;
                        phi_712_ = false;
                    }
                    let _e586 = phi_706_;
                    let _e588 = phi_707_;
                    let _e590 = phi_708_;
                    let _e592 = phi_709_;
                    let _e594 = phi_710_;
                    let _e596 = phi_711_;
                    let _e598 = phi_712_;
                    phi_713_ = _e586;
                    phi_714_ = _e588;
                    phi_715_ = _e590;
                    phi_716_ = _e592;
                    phi_717_ = _e594;
                    phi_718_ = _e596;
                    phi_719_ = _e598;
                } else {
                    phi_713_ = bool();
                    phi_714_ = bool();
                    phi_715_ = vec2<u32>();
                    phi_716_ = bool();
                    phi_717_ = bool();
                    phi_718_ = true;
                    phi_719_ = false;
                }
                let _e600 = phi_713_;
                let _e602 = phi_714_;
                let _e604 = phi_715_;
                let _e606 = phi_716_;
                let _e608 = phi_717_;
                let _e610 = phi_718_;
                let _e612 = phi_719_;
                if _e610 {
                    if (_e452 == 0f) {
                        phi_728_ = (_e458 == 0f);
                    } else {
                        phi_728_ = false;
                    }
                    let _e616 = phi_728_;
                    phi_729_ = _e616;
                    phi_730_ = false;
                    phi_731_ = true;
                } else {
                    phi_729_ = _e606;
                    phi_730_ = _e608;
                    phi_731_ = _e612;
                }
                let _e618 = phi_729_;
                let _e620 = phi_730_;
                let _e622 = phi_731_;
                if _e622 {
                    phi_735_ = _e618;
                    phi_736_ = _e620;
                    phi_737_ = vec2<u32>(_e54.x, _e54.y);
                } else {
                    phi_735_ = _e600;
                    phi_736_ = _e602;
                    phi_737_ = _e604;
                }
                let _e624 = phi_735_;
                let _e626 = phi_736_;
                let _e628 = phi_737_;
                let _e638 = lt_mask_Reprojection(vec2<u32>(_e628.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e645 = lt_mask_Reprojection(vec2<u32>(_e638.pixel.x, _e628.y), _e638.is_valid, _e638.has_moved);
                let _e649 = lt_mask_Reprojection(_e645.pixel, _e626, _e645.has_moved);
                let _e653 = lt_mask_Reprojection(_e649.pixel, _e649.is_valid, !(_e624));
                if _e626 {
                    let _e656 = p.member.previous.eye;
                    let _e664 = p.member.previous.forward;
                    let _e673 = (((((_e86.x - _e656.x) * _e664.x) + ((_e86.y - _e656.y) * _e664.y)) + ((_e86.z - _e656.z) * _e664.z)) > 0f);
                    let _e677 = lt_mask_Reprojection(_e653.pixel, _e673, _e653.has_moved);
                    if _e673 {
                        phi_772_ = false;
                    } else {
                        phi_772_ = true;
                    }
                    let _e679 = phi_772_;
                    phi_774_ = _e677;
                    phi_775_ = _e677;
                    phi_776_ = lt_mask_Reprojection();
                    phi_777_ = _e673;
                    phi_778_ = _e679;
                } else {
                    phi_774_ = lt_mask_Reprojection();
                    phi_775_ = lt_mask_Reprojection();
                    phi_776_ = lt_mask_Reprojection(_e653.pixel, false, _e653.has_moved);
                    phi_777_ = false;
                    phi_778_ = false;
                }
                let _e685 = phi_774_;
                let _e687 = phi_775_;
                let _e689 = phi_776_;
                let _e691 = phi_777_;
                let _e693 = phi_778_;
                phi_779_ = _e685;
                phi_780_ = _e687;
                phi_781_ = _e689;
                phi_782_ = _e691;
                phi_783_ = _e693;
            }
            let _e695 = phi_779_;
            let _e697 = phi_780_;
            let _e699 = phi_781_;
            let _e701 = phi_782_;
            let _e703 = phi_783_;
            if _e701 {
                let _e706 = p.member.previous.eye;
                let _e714 = p.member.previous.forward;
                let _e722 = ((((_e86.x - _e706.x) * _e714.x) + ((_e86.y - _e706.y) * _e714.y)) + ((_e86.z - _e706.z) * _e714.z));
                let _e728 = ((_e695.pixel.y * _e83) + _e695.pixel.x);
                if (_e728 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e732 = last_depths.member[(0u + _e728)];
                let _e734 = p.member.depth_tolerance;
                let _e737 = abs(_e722);
                let _e738 = abs(_e732);
                if ((bitcast<u32>(_e738) & 2147483647u) > 2139095040u) {
                    phi_835_ = true;
                } else {
                    let _e742 = (_e738 > _e737);
                    if _e742 {
                    }
                    phi_835_ = _e742;
                }
                let _e744 = phi_835_;
                if _e744 {
                    phi_839_ = _e738;
                } else {
                    phi_839_ = _e737;
                }
                let _e746 = phi_839_;
                phi_843_ = lt_mask_Reprojection(_e695.pixel, (abs((_e722 - _e732)) <= (_e734 * _e746)), _e695.has_moved);
                phi_844_ = true;
            } else {
                phi_843_ = _e697;
                phi_844_ = _e703;
            }
            let _e754 = phi_843_;
            let _e756 = phi_844_;
            if _e756 {
                if _e754.is_valid {
                    let _e759 = p.member.flags;
                    phi_856_ = ((_e759 & 1u) != 0u);
                    phi_857_ = false;
                } else {
                    phi_856_ = bool();
                    phi_857_ = true;
                }
                let _e763 = phi_856_;
                let _e765 = phi_857_;
                phi_858_ = _e763;
                phi_859_ = _e754;
                phi_860_ = _e765;
            } else {
                phi_858_ = bool();
                phi_859_ = _e699;
                phi_860_ = true;
            }
            let _e767 = phi_858_;
            let _e769 = phi_859_;
            let _e771 = phi_860_;
            if _e771 {
                phi_864_ = false;
                phi_865_ = _e769;
            } else {
                phi_864_ = _e767;
                phi_865_ = _e754;
            }
            let _e773 = phi_864_;
            let _e775 = phi_865_;
            let _e779 = lt_mask_Reprojection(_e775.pixel, _e773, _e775.has_moved);
            let _e781 = p.member.flags;
            let _e783 = ((_e781 & 2u) != 0u);
            let _e785 = p.member.flags;
            if ((_e785 & 4u) == 0u) {
                phi_964_ = u32();
                phi_965_ = true;
                phi_966_ = false;
            } else {
                if _e773 {
                    if !(_e779.has_moved) {
                        if (32u == 0u) {
                            return;
                        }
                        let _e791 = (_e83 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e83 % 32u) > 0u) {
                            phi_903_ = (_e791 + 1u);
                        } else {
                            phi_903_ = _e791;
                        }
                        let _e797 = phi_903_;
                        let _e802 = ((((_e54.y * _e797) + (_e54.x / 32u)) * 6u) + 4u);
                        if (_e802 < _e60) {
                        } else {
                            return;
                        }
                        let _e806 = heard.member[(0u + _e802)];
                        if (((_e806 >> bitcast<u32>(((_e54.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e817 = ((((_e54.y * _e797) + (_e54.x / 32u)) * 6u) + 5u);
                            if (_e817 < _e60) {
                            } else {
                                return;
                            }
                            let _e821 = heard.member[(0u + _e817)];
                            if false {
                                phi_952_ = (2u | 1u);
                            } else {
                                phi_952_ = 2u;
                            }
                            let _e830 = phi_952_;
                            if (((_e821 >> bitcast<u32>(((_e54.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_957_ = (_e830 | 4u);
                            } else {
                                phi_957_ = _e830;
                            }
                            let _e833 = phi_957_;
                            phi_958_ = _e833;
                        } else {
                            phi_958_ = 0u;
                        }
                        let _e835 = phi_958_;
                        phi_959_ = _e835;
                        phi_960_ = false;
                    } else {
                        phi_959_ = u32();
                        phi_960_ = true;
                    }
                    let _e837 = phi_959_;
                    let _e839 = phi_960_;
                    phi_961_ = _e837;
                    phi_962_ = false;
                    phi_963_ = _e839;
                } else {
                    phi_961_ = u32();
                    phi_962_ = true;
                    phi_963_ = false;
                }
                let _e841 = phi_961_;
                let _e843 = phi_962_;
                let _e845 = phi_963_;
                phi_964_ = _e841;
                phi_965_ = _e843;
                phi_966_ = _e845;
            }
            let _e847 = phi_964_;
            let _e849 = phi_965_;
            let _e851 = phi_966_;
            if _e849 {
                phi_970_ = true;
            } else {
                phi_970_ = _e851;
            }
            let _e853 = phi_970_;
            if _e853 {
                phi_974_ = 0u;
            } else {
                phi_974_ = _e847;
            }
            let _e855 = phi_974_;
            let _e856 = lt_mask_Neighbourhood(false, true);
            if _e253 {
                phi_979_ = _e783;
            } else {
                phi_979_ = false;
            }
            let _e858 = phi_979_;
            if _e858 {
                if _e773 {
                    if ((_e855 & 2u) != 0u) {
                        phi_1040_ = _e856;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e867 = (_e83 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e83 % 32u) > 0u) {
                            phi_1011_ = (_e867 + 1u);
                        } else {
                            phi_1011_ = _e867;
                        }
                        let _e873 = phi_1011_;
                        let _e883 = ((((_e779.pixel.y * _e873) + (_e779.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e249) | (select(0u, 1u, _e779.has_moved) << bitcast<u32>(1i))));
                        if (_e883 < _e60) {
                        } else {
                            return;
                        }
                        let _e887 = heard.member[(0u + _e883)];
                        let _e893 = (((_e887 >> bitcast<u32>(((_e779.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_1040_ = lt_mask_Neighbourhood(_e893, !(_e893));
                    }
                    let _e897 = phi_1040_;
                    phi_1041_ = _e897;
                } else {
                    phi_1041_ = _e856;
                }
                let _e899 = phi_1041_;
                phi_1042_ = _e899;
            } else {
                phi_1042_ = _e856;
            }
            let _e901 = phi_1042_;
            let _e904 = p.member.frame;
            let _e906 = p.member.refresh;
            if (_e906 == 0u) {
                phi_1075_ = false;
            } else {
                if (_e906 == 0u) {
                    return;
                }
                let _e915 = ((_e54.x + (_e54.y * (((_e906 * 5u) / 8u) | 1u))) + (_e904 % _e906));
                if (_e906 == 0u) {
                    phi_1074_ = (_e915 == 0u);
                } else {
                    if (_e906 == 0u) {
                        return;
                    }
                    phi_1074_ = ((_e915 % _e906) == 0u);
                }
                let _e922 = phi_1074_;
                phi_1075_ = _e922;
            }
            let _e924 = phi_1075_;
            if _e773 {
                if _e924 {
                    phi_1097_ = bool();
                } else {
                    phi_1097_ = ((_e855 & 2u) != 0u);
                }
                let _e930 = phi_1097_;
                phi_1098_ = _e930;
                phi_1099_ = _e924;
            } else {
                phi_1098_ = bool();
                phi_1099_ = true;
            }
            let _e932 = phi_1098_;
            let _e934 = phi_1099_;
            if _e934 {
                phi_1103_ = false;
            } else {
                phi_1103_ = _e932;
            }
            let _e936 = phi_1103_;
            if _e936 {
                phi_1154_ = 7u;
            } else {
                if (_e91 != 0.5f) {
                    if _e773 {
                        if _e924 {
                            phi_1151_ = 6u;
                        } else {
                            if _e253 {
                                phi_1126_ = true;
                            } else {
                                if _e901.any_expands {
                                    phi_1125_ = false;
                                } else {
                                    phi_1125_ = true;
                                }
                                let _e938 = phi_1125_;
                                phi_1126_ = _e938;
                            }
                            let _e940 = phi_1126_;
                            if _e940 {
                                if _e253 {
                                    if _e783 {
                                        if _e901.all_remove {
                                            phi_1139_ = false;
                                        } else {
                                            phi_1139_ = true;
                                        }
                                        let _e942 = phi_1139_;
                                        phi_1140_ = _e942;
                                    } else {
                                        phi_1140_ = true;
                                    }
                                    let _e944 = phi_1140_;
                                    phi_1141_ = _e944;
                                } else {
                                    phi_1141_ = true;
                                }
                                let _e946 = phi_1141_;
                                if _e946 {
                                    if _e253 {
                                        phi_1148_ = 1u;
                                    } else {
                                        phi_1148_ = 0u;
                                    }
                                    let _e948 = phi_1148_;
                                    phi_1149_ = _e948;
                                } else {
                                    phi_1149_ = 5u;
                                }
                                let _e950 = phi_1149_;
                                phi_1150_ = _e950;
                            } else {
                                phi_1150_ = 4u;
                            }
                            let _e952 = phi_1150_;
                            phi_1151_ = _e952;
                        }
                        let _e954 = phi_1151_;
                        phi_1152_ = _e954;
                    } else {
                        phi_1152_ = 3u;
                    }
                    let _e956 = phi_1152_;
                    phi_1153_ = _e956;
                } else {
                    phi_1153_ = 2u;
                }
                let _e958 = phi_1153_;
                phi_1154_ = _e958;
            }
            let _e960 = phi_1154_;
            if !((_e960 == 0u)) {
                if !((_e960 == 5u)) {
                    phi_1166_ = !(_e936);
                    phi_1167_ = false;
                } else {
                    phi_1166_ = bool();
                    phi_1167_ = true;
                }
                let _e967 = phi_1166_;
                let _e969 = phi_1167_;
                phi_1168_ = _e967;
                phi_1169_ = _e969;
            } else {
                phi_1168_ = bool();
                phi_1169_ = true;
            }
            let _e971 = phi_1168_;
            let _e973 = phi_1169_;
            if _e973 {
                phi_1173_ = false;
            } else {
                phi_1173_ = _e971;
            }
            let _e975 = phi_1173_;
            if _e936 {
                phi_1179_ = ((_e855 & 4u) != 0u);
            } else {
                phi_1179_ = _e249;
            }
            let _e979 = phi_1179_;
            if _e975 {
                if _e249 {
                    phi_1187_ = (2u | 1u);
                } else {
                    phi_1187_ = 2u;
                }
                let _e982 = phi_1187_;
                if false {
                    phi_1192_ = (_e982 | 4u);
                } else {
                    phi_1192_ = _e982;
                }
                let _e985 = phi_1192_;
                phi_1212_ = _e985;
            } else {
                if (_e960 == 7u) {
                    if _e249 {
                        phi_1201_ = (2u | 1u);
                    } else {
                        phi_1201_ = 2u;
                    }
                    let _e989 = phi_1201_;
                    if _e979 {
                        phi_1206_ = (_e989 | 4u);
                    } else {
                        phi_1206_ = _e989;
                    }
                    let _e992 = phi_1206_;
                    phi_1211_ = _e992;
                } else {
                    if _e249 {
                        phi_1210_ = 1u;
                    } else {
                        phi_1210_ = 0u;
                    }
                    let _e994 = phi_1210_;
                    phi_1211_ = _e994;
                }
                let _e996 = phi_1211_;
                phi_1212_ = _e996;
            }
            let _e998 = phi_1212_;
            if _e979 {
                phi_1216_ = 0f;
            } else {
                phi_1216_ = 1f;
            }
            let _e1000 = phi_1216_;
            phi_1218_ = mask_Masked(_e1000, _e998, _e975);
        }
        let _e1003 = phi_1218_;
        visibility.member[_e75.first_primitive] = _e1003.visibility;
        let _e1008 = p.member.light.number;
        let _e1009 = (_e1008 * 3u);
        let _e1011 = (_e1009 % 32u);
        let _e1013 = p.member.light.mask_words;
        let _e1015 = ((_e75.first_primitive * _e1013) + (_e1009 / 32u));
        let _e1017 = bits.member[_e1015];
        bits.member[_e1015] = ((_e1017 & ~((7u << bitcast<u32>((_e1011 & 31u))))) | (_e1003.bits << bitcast<u32>((_e1011 & 31u))));
        if (_e1011 > 29u) {
            let _e1032 = bits.member[(_e1015 + 1u)];
            let _e1034 = (32u - _e1011);
            bits.member[(_e1015 + 1u)] = ((_e1032 & ~((7u >> bitcast<u32>((_e1034 & 31u))))) | (_e1003.bits >> bitcast<u32>((_e1034 & 31u))));
        }
        let _e1049 = samples.member[_e75.first_primitive].normal[0u];
        let _e1051 = global[0u];
        if (_e1049 == _e1051) {
            let _e1054 = samples.member[_e75.first_primitive].normal[1u];
            let _e1056 = global[1u];
            if (_e1054 == _e1056) {
                let _e1059 = samples.member[_e75.first_primitive].normal[2u];
                let _e1061 = global[2u];
                phi_1290_ = (_e1059 == _e1061);
                phi_1291_ = false;
            } else {
                phi_1290_ = bool();
                phi_1291_ = true;
            }
            let _e1064 = phi_1290_;
            let _e1066 = phi_1291_;
            phi_1292_ = _e1064;
            phi_1293_ = _e1066;
        } else {
            phi_1292_ = bool();
            phi_1293_ = true;
        }
        let _e1068 = phi_1292_;
        let _e1070 = phi_1293_;
        if _e1070 {
            phi_1297_ = false;
        } else {
            phi_1297_ = _e1068;
        }
        let _e1072 = phi_1297_;
        if !(_e1072) {
            let _e1075 = samples.member[_e75.first_primitive].position;
            let _e1077 = p.member.current.eye;
            let _e1088 = p.member.current.forward;
            phi_1325_ = ((((_e1075.x - _e1077.x) * _e1088.x) + ((_e1075.y - _e1077.y) * _e1088.y)) + ((_e1075.z - _e1077.z) * _e1088.z));
        } else {
            phi_1325_ = 0f;
        }
        let _e1098 = phi_1325_;
        depths.member[_e75.first_primitive] = _e1098;
        phi_1328_ = _e1003.needs_ray;
        phi_1329_ = _e75.first_primitive;
    } else {
        phi_1328_ = false;
        phi_1329_ = 0u;
    }
    let _e1102 = phi_1328_;
    let _e1104 = phi_1329_;
    if (_e55 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1102 {
        let _e1108 = atomicAdd((&shared_[0u]), 1u);
        phi_1340_ = _e1108;
    } else {
        phi_1340_ = 0u;
    }
    let _e1110 = phi_1340_;
    workgroupBarrier();
    if (_e55 == 0u) {
        let _e1114 = atomicLoad((&shared_[0u]));
        let _e1115 = atomicAdd((&list.member[3u]), _e1114);
        atomicStore((&shared_[1u]), _e1115);
    }
    workgroupBarrier();
    if _e1102 {
        let _e1118 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1118) + _e1110)]), _e1104);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
