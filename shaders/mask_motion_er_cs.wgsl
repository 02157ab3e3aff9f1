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
    var phi_157_: lt_bvh_traverse_Tree;
    var phi_158_: bool;
    var phi_159_: lt_bvh_traverse_Tree;
    var phi_160_: bool;
    var phi_165_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_157_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_158_ = false;
        } else {
            phi_157_ = lt_bvh_traverse_Tree();
            phi_158_ = true;
        }
        let _e61 = phi_157_;
        let _e63 = phi_158_;
        phi_159_ = _e61;
        phi_160_ = _e63;
    } else {
        phi_159_ = lt_bvh_traverse_Tree();
        phi_160_ = true;
    }
    let _e65 = phi_159_;
    let _e67 = phi_160_;
    if _e67 {
        phi_165_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_165_ = _e65;
    }
    let _e72 = phi_165_;
    return lt_bvh_traverse_Tree(_e72.root, _e72.first_primitive);
}

fn function_() {
    var phi_210_: u32;
    var phi_244_: bool;
    var phi_245_: bool;
    var phi_246_: bool;
    var phi_247_: bool;
    var phi_251_: bool;
    var phi_321_: bool;
    var phi_322_: bool;
    var phi_333_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_334_: bool;
    var phi_335_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_336_: bool;
    var phi_343_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_347_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_360_: bool;
    var phi_391_: bool;
    var phi_392_: bool;
    var phi_393_: bool;
    var phi_394_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_610_: f32;
    var phi_615_: f32;
    var phi_616_: bool;
    var phi_617_: f32;
    var phi_618_: bool;
    var phi_622_: f32;
    var phi_643_: f32;
    var phi_648_: f32;
    var phi_649_: bool;
    var phi_650_: f32;
    var phi_651_: bool;
    var phi_655_: f32;
    var phi_676_: bool;
    var phi_695_: vec2<u32>;
    var phi_696_: bool;
    var phi_697_: bool;
    var phi_698_: bool;
    var phi_699_: vec2<u32>;
    var phi_700_: bool;
    var phi_701_: bool;
    var phi_702_: bool;
    var phi_703_: bool;
    var phi_704_: bool;
    var phi_705_: bool;
    var phi_706_: vec2<u32>;
    var phi_707_: bool;
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_710_: bool;
    var phi_711_: bool;
    var phi_712_: bool;
    var phi_713_: vec2<u32>;
    var phi_714_: bool;
    var phi_715_: bool;
    var phi_716_: bool;
    var phi_717_: bool;
    var phi_726_: bool;
    var phi_727_: bool;
    var phi_728_: bool;
    var phi_729_: bool;
    var phi_733_: bool;
    var phi_734_: bool;
    var phi_735_: vec2<u32>;
    var phi_773_: bool;
    var phi_775_: lt_mask_Reprojection;
    var phi_776_: lt_mask_Reprojection;
    var phi_777_: bool;
    var phi_781_: bool;
    var phi_782_: lt_mask_Reprojection;
    var phi_783_: lt_mask_Reprojection;
    var phi_784_: bool;
    var phi_792_: bool;
    var phi_793_: lt_mask_Reprojection;
    var phi_799_: bool;
    var phi_839_: lt_mask_Neighbourhood;
    var phi_840_: lt_mask_Neighbourhood;
    var phi_841_: lt_mask_Neighbourhood;
    var phi_873_: bool;
    var phi_874_: bool;
    var phi_896_: bool;
    var phi_897_: bool;
    var phi_898_: bool;
    var phi_902_: bool;
    var phi_924_: bool;
    var phi_925_: bool;
    var phi_938_: bool;
    var phi_939_: bool;
    var phi_940_: bool;
    var phi_947_: u32;
    var phi_948_: u32;
    var phi_949_: u32;
    var phi_950_: u32;
    var phi_951_: u32;
    var phi_952_: u32;
    var phi_953_: u32;
    var phi_965_: bool;
    var phi_966_: bool;
    var phi_967_: bool;
    var phi_968_: bool;
    var phi_972_: bool;
    var phi_978_: bool;
    var phi_986_: u32;
    var phi_991_: u32;
    var phi_1000_: u32;
    var phi_1005_: u32;
    var phi_1009_: u32;
    var phi_1010_: u32;
    var phi_1011_: u32;
    var phi_1015_: f32;
    var phi_1017_: mask_Masked;
    var phi_1067_: bool;
    var phi_1068_: u32;
    var phi_1079_: u32;

    let _e48 = id_1;
    let _e49 = local_1;
    let _e61 = p.member.current.size[0u];
    let _e63 = p.member.current.size[1u];
    let _e64 = lt_shaders_entry_pixel_index(_e48, _e61, _e63);
    if (bitcast<i32>(_e64.root) != 0i) {
        let _e72 = p.member.current.size[0u];
        if (32u == 0u) {
            return;
        }
        let _e74 = (_e72 / 32u);
        if (32u == 0u) {
            return;
        }
        if ((_e72 % 32u) > 0u) {
            phi_210_ = (_e74 + 1u);
        } else {
            phi_210_ = _e74;
        }
        let _e80 = phi_210_;
        let _e83 = samples.member[_e64.first_primitive].position;
        let _e85 = visibility.member[_e64.first_primitive];
        let _e91 = samples.member[_e64.first_primitive].normal[0u];
        let _e93 = global[0u];
        if (_e91 == _e93) {
            let _e96 = samples.member[_e64.first_primitive].normal[1u];
            let _e98 = global[1u];
            if (_e96 == _e98) {
                let _e101 = samples.member[_e64.first_primitive].normal[2u];
                let _e103 = global[2u];
                phi_244_ = (_e101 == _e103);
                phi_245_ = false;
            } else {
                phi_244_ = bool();
                phi_245_ = true;
            }
            let _e106 = phi_244_;
            let _e108 = phi_245_;
            phi_246_ = _e106;
            phi_247_ = _e108;
        } else {
            phi_246_ = bool();
            phi_247_ = true;
        }
        let _e110 = phi_246_;
        let _e112 = phi_247_;
        if _e112 {
            phi_251_ = false;
        } else {
            phi_251_ = _e110;
        }
        let _e114 = phi_251_;
        if !(_e114) {
            let _e117 = samples.member[_e64.first_primitive].position;
            let _e119 = p.member.light.place;
            let _e125 = p.member.light.place[3u];
            let _e132 = (_e119.x - (_e117.x * _e125));
            let _e133 = (_e119.y - (_e117.y * _e125));
            let _e134 = (_e119.z - (_e117.z * _e125));
            let _e136 = samples.member[_e64.first_primitive].normal;
            if ((((_e136.x * _e132) + (_e136.y * _e133)) + (_e136.z * _e134)) > 0f) {
                let _e150 = (((_e132 * _e132) + (_e133 * _e133)) + (_e134 * _e134));
                let _e152 = p.member.light.axis;
                let _e164 = p.member.light.place[3u];
                if (_e164 == 0f) {
                    phi_322_ = true;
                } else {
                    let _e167 = p.member.light.range_squared;
                    if (_e150 <= _e167) {
                        let _e170 = p.member.light.cos_outer;
                        phi_321_ = (-((((_e132 * _e152.x) + (_e133 * _e152.y)) + (_e134 * _e152.z))) >= (_e170 * sqrt(_e150)));
                    } else {
                        phi_321_ = false;
                    }
                    let _e175 = phi_321_;
                    phi_322_ = _e175;
                }
                let _e177 = phi_322_;
                if _e177 {
                    let _e179 = samples.member[_e64.first_primitive].flags;
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e187.unnamed.visibility, false), _e187.unnamed_1);
                    phi_333_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e193.unnamed, ((_e179 & 1u) == 0u));
                    phi_334_ = false;
                } else {
                    phi_333_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_334_ = true;
                }
                let _e198 = phi_333_;
                let _e200 = phi_334_;
                phi_335_ = _e198;
                phi_336_ = _e200;
            } else {
                phi_335_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_336_ = true;
            }
            let _e202 = phi_335_;
            let _e204 = phi_336_;
            if _e204 {
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e210.unnamed.visibility, false), _e210.unnamed_1);
                phi_343_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e216.unnamed, true);
            } else {
                phi_343_ = _e202;
            }
            let _e221 = phi_343_;
            phi_347_ = _e221;
        } else {
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e233 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e227.unnamed.visibility, false), _e227.unnamed_1);
            phi_347_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e233.unnamed, true);
        }
        let _e238 = phi_347_;
        if _e238.unnamed_1 {
            phi_1017_ = mask_Masked(_e238.unnamed.visibility, 0u, false);
        } else {
            let _e243 = (_e85 < 0.5f);
            if (_e85 > 0f) {
                phi_360_ = (_e85 < 1f);
            } else {
                phi_360_ = false;
            }
            let _e247 = phi_360_;
            let _e254 = lt_mask_Reprojection(vec2<u32>(_e48.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e261 = lt_mask_Reprojection(vec2<u32>(_e254.pixel.x, _e48.y), _e254.is_valid, _e254.has_moved);
            let _e265 = lt_mask_Reprojection(_e261.pixel, true, _e261.has_moved);
            let _e271 = p.member.flags;
            if ((_e271 & 16u) == 0u) {
                phi_399_ = false;
            } else {
                let _e277 = samples.member[_e64.first_primitive].position[0u];
                if (_e83.x == _e277) {
                    let _e281 = samples.member[_e64.first_primitive].position[1u];
                    if (_e83.y == _e281) {
                        let _e285 = samples.member[_e64.first_primitive].position[2u];
                        phi_391_ = (_e83.z == _e285);
                        phi_392_ = false;
                    } else {
                        phi_391_ = bool();
                        phi_392_ = true;
                    }
                    let _e288 = phi_391_;
                    let _e290 = phi_392_;
                    phi_393_ = _e288;
                    phi_394_ = _e290;
                } else {
                    phi_393_ = bool();
                    phi_394_ = true;
                }
                let _e292 = phi_393_;
                let _e294 = phi_394_;
                if _e294 {
                    phi_398_ = false;
                } else {
                    phi_398_ = _e292;
                }
                let _e296 = phi_398_;
                phi_399_ = _e296;
            }
            let _e298 = phi_399_;
            if _e298 {
                phi_782_ = lt_mask_Reprojection(_e265.pixel, _e265.is_valid, false);
                phi_783_ = lt_mask_Reprojection();
                phi_784_ = true;
            } else {
                let _e300 = samples.member[_e64.first_primitive].position;
                let _e304 = p.member.previous.eye;
                let _e307 = (_e83.x - _e304.x);
                let _e310 = (_e83.y - _e304.y);
                let _e313 = (_e83.z - _e304.z);
                let _e315 = p.member.previous.forward;
                let _e323 = (((_e307 * _e315.x) + (_e310 * _e315.y)) + (_e313 * _e315.z));
                let _e325 = p.member.previous.right;
                let _e335 = p.member.previous.right;
                let _e350 = p.member.previous.up;
                let _e360 = p.member.previous.up;
                let _e375 = p.member.current.eye;
                let _e378 = (_e300.x - _e375.x);
                let _e381 = (_e300.y - _e375.y);
                let _e384 = (_e300.z - _e375.z);
                let _e386 = p.member.current.forward;
                let _e394 = (((_e378 * _e386.x) + (_e381 * _e386.y)) + (_e384 * _e386.z));
                let _e396 = p.member.current.right;
                let _e406 = p.member.current.right;
                let _e421 = p.member.current.up;
                let _e431 = p.member.current.up;
                let _e450 = p.member.current.size[0u];
                let _e452 = (((((((_e307 * _e325.x) + (_e310 * _e325.y)) + (_e313 * _e325.z)) / ((((_e335.x * _e335.x) + (_e335.y * _e335.y)) + (_e335.z * _e335.z)) * _e323)) - ((((_e378 * _e396.x) + (_e381 * _e396.y)) + (_e384 * _e396.z)) / ((((_e406.x * _e406.x) + (_e406.y * _e406.y)) + (_e406.z * _e406.z)) * _e394))) * 0.5f) * f32(_e450));
                let _e456 = p.member.current.size[1u];
                let _e458 = (((((((_e307 * _e350.x) + (_e310 * _e350.y)) + (_e313 * _e350.z)) / ((((_e360.x * _e360.x) + (_e360.y * _e360.y)) + (_e360.z * _e360.z)) * _e323)) - ((((_e378 * _e421.x) + (_e381 * _e421.y)) + (_e384 * _e421.z)) / ((((_e431.x * _e431.x) + (_e431.y * _e431.y)) + (_e431.z * _e431.z)) * _e394))) * -0.5f) * f32(_e456));
                let _e462 = p.member.current.grid[0u];
                let _e464 = p.member.current.grid[1u];
                let _e484 = p.member.current.size[0u];
                let _e486 = p.member.current.size[1u];
                let _e488 = ((f32(_e48.x) + ((f32((_e48.y & (_e464 - 1u))) + 0.5f) / f32(_e464))) + _e452);
                if (_e488 > -8388608f) {
                    let _e500 = f32(select(0i, select(select(i32(_e488), i32(-2147483648), (_e488 < bitcast<f32>(3472883712u))), 2147483647i, (_e488 > bitcast<f32>(1325400063u))), (_e488 == _e488)));
                    if (_e500 > _e488) {
                        phi_610_ = 1f;
                    } else {
                        phi_610_ = 0f;
                    }
                    let _e503 = phi_610_;
                    if (_e488 < 8388608f) {
                        phi_615_ = (_e500 - _e503);
                        phi_616_ = false;
                    } else {
                        phi_615_ = f32();
                        phi_616_ = true;
                    }
                    let _e506 = phi_615_;
                    let _e508 = phi_616_;
                    phi_617_ = _e506;
                    phi_618_ = _e508;
                } else {
                    phi_617_ = f32();
                    phi_618_ = true;
                }
                let _e510 = phi_617_;
                let _e512 = phi_618_;
                if _e512 {
                    phi_622_ = _e488;
                } else {
                    phi_622_ = _e510;
                }
                let _e514 = phi_622_;
                let _e515 = ((f32(_e48.y) + ((f32((_e48.x & (_e462 - 1u))) + 0.5f) / f32(_e462))) + _e458);
                if (_e515 > -8388608f) {
                    let _e527 = f32(select(0i, select(select(i32(_e515), i32(-2147483648), (_e515 < bitcast<f32>(3472883712u))), 2147483647i, (_e515 > bitcast<f32>(1325400063u))), (_e515 == _e515)));
                    if (_e527 > _e515) {
                        phi_643_ = 1f;
                    } else {
                        phi_643_ = 0f;
                    }
                    let _e530 = phi_643_;
                    if (_e515 < 8388608f) {
                        phi_648_ = (_e527 - _e530);
                        phi_649_ = false;
                    } else {
                        phi_648_ = f32();
                        phi_649_ = true;
                    }
                    let _e533 = phi_648_;
                    let _e535 = phi_649_;
                    phi_650_ = _e533;
                    phi_651_ = _e535;
                } else {
                    phi_650_ = f32();
                    phi_651_ = true;
                }
                let _e537 = phi_650_;
                let _e539 = phi_651_;
                if _e539 {
                    phi_655_ = _e515;
                } else {
                    phi_655_ = _e537;
                }
                let _e541 = phi_655_;
                if (_e514 >= 0f) {
                    if (_e541 >= 0f) {
                        if (_e514 < f32(_e484)) {
                            let _e547 = (_e541 < f32(_e486));
                            if (_e452 == 0f) {
                                phi_676_ = (_e458 == 0f);
                            } else {
                                phi_676_ = false;
                            }
                            let _e551 = phi_676_;
                            if _e547 {
                                phi_695_ = vec2<u32>(select(select(u32(_e514), 0u, (_e514 < bitcast<f32>(0u))), 4294967295u, (_e514 > bitcast<f32>(1333788671u))), select(select(u32(_e541), 0u, (_e541 < bitcast<f32>(0u))), 4294967295u, (_e541 > bitcast<f32>(1333788671u))));
                                phi_696_ = false;
                            } else {
                                phi_695_ = vec2<u32>();
                                phi_696_ = true;
                            }
                            let _e568 = phi_695_;
                            let _e570 = phi_696_;
                            phi_697_ = _e551;
                            phi_698_ = _e547;
                            phi_699_ = _e568;
                            phi_700_ = _e551;
                            phi_701_ = _e547;
                            phi_702_ = false;
                            phi_703_ = _e570;
                        } else {
                            phi_697_ = bool();
                            phi_698_ = bool();
                            phi_699_ = vec2<u32>();
                            phi_700_ = bool();
                            phi_701_ = bool();
                            phi_702_ = true;
                            phi_703_ = false;
                        }
                        let _e572 = phi_697_;
                        let _e574 = phi_698_;
                        let _e576 = phi_699_;
                        let _e578 = phi_700_;
                        let _e580 = phi_701_;
                        let _e582 = phi_702_;
                        let _e584 = phi_703_;
                        phi_704_ = _e572;
                        phi_705_ = _e574;
                        phi_706_ = _e576;
                        phi_707_ = _e578;
                        phi_708_ = _e580;
                        phi_709_ = _e582;
                        phi_710_ = _e584;
                    } else {
                        phi_704_ = bool();
                        phi_705_ = bool();
                        phi_706_ = vec2<u32>();
                        phi_707_ = bool();
                        phi_708_ = bool();
                        phi_709_ = true;
                        phi_710_ = false;
                    }
                    let _e586 = phi_704_;
                    let _e588 = phi_705_;
                    let _e590 = phi_706_;
                    let _e592 = phi_707_;
                    let _e594 = phi_708_;
                    let _e596 = phi_709_;
                    let _e598 = phi_710_;
                    phi_711_ = _e586;
                    phi_712_ = _e588;
                    phi_713_ = _e590;
                    phi_714_ = _e592;
                    phi_715_ = _e594;
                    phi_716_ = _e596;
                    phi_717_ = _e598;
                } else {
                    phi_711_ = bool();
                    phi_712_ = bool();
                    phi_713_ = vec2<u32>();
                    phi_714_ = bool();
                    phi_715_ = bool();
                    phi_716_ = true;
                    phi_717_ = false;
                }
                let _e600 = phi_711_;
                let _e602 = phi_712_;
                let _e604 = phi_713_;
                let _e606 = phi_714_;
                let _e608 = phi_715_;
                let _e610 = phi_716_;
                let _e612 = phi_717_;
                if _e610 {
                    if (_e452 == 0f) {
                        phi_726_ = (_e458 == 0f);
                    } else {
                        phi_726_ = false;
                    }
                    let _e616 = phi_726_;
                    phi_727_ = _e616;
                    phi_728_ = false;
                    phi_729_ = true;
                } else {
                    phi_727_ = _e606;
                    phi_728_ = _e608;
                    phi_729_ = _e612;
                }
                let _e618 = phi_727_;
                let _e620 = phi_728_;
                let _e622 = phi_729_;
                if _e622 {
                    phi_733_ = _e618;
                    phi_734_ = _e620;
                    phi_735_ = vec2<u32>(_e48.x, _e48.y);
                } else {
                    phi_733_ = _e600;
                    phi_734_ = _e602;
                    phi_735_ = _e604;
                }
                let _e624 = phi_733_;
                let _e626 = phi_734_;
                let _e628 = phi_735_;
                let _e638 = lt_mask_Reprojection(vec2<u32>(_e628.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e645 = lt_mask_Reprojection(vec2<u32>(_e638.pixel.x, _e628.y), _e638.is_valid, _e638.has_moved);
                let _e649 = lt_mask_Reprojection(_e645.pixel, _e626, _e645.has_moved);
                let _e653 = lt_mask_Reprojection(_e649.pixel, _e649.is_valid, !(_e624));
                if _e626 {
                    let _e656 = p.member.previous.eye;
                    let _e667 = p.member.previous.forward;
                    let _e676 = (((((_e83.x - _e656.x) * _e667.x) + ((_e83.y - _e656.y) * _e667.y)) + ((_e83.z - _e656.z) * _e667.z)) > 0f);
                    let _e680 = lt_mask_Reprojection(_e653.pixel, _e676, _e653.has_moved);
                    if _e676 {
                        phi_773_ = false;
                    } else {
                        phi_773_ = true;
                    }
                    let _e682 = phi_773_;
                    phi_775_ = _e680;
                    phi_776_ = _e680;
                    phi_777_ = _e682;
                } else {
                    phi_775_ = lt_mask_Reprojection();
                    phi_776_ = lt_mask_Reprojection(_e653.pixel, false, _e653.has_moved);
                    phi_777_ = true;
                }
                let _e688 = phi_775_;
                let _e690 = phi_776_;
                let _e692 = phi_777_;
                if _e692 {
                    phi_781_ = false;
                } else {
                    phi_781_ = true;
                }
                let _e694 = phi_781_;
                phi_782_ = _e688;
                phi_783_ = _e690;
                phi_784_ = _e694;
            }
            let _e696 = phi_782_;
            let _e698 = phi_783_;
            let _e700 = phi_784_;
            if _e700 {
                let _e702 = p.member.flags;
                phi_792_ = ((_e702 & 1u) != 0u);
                phi_793_ = _e696;
            } else {
                phi_792_ = false;
                phi_793_ = _e698;
            }
            let _e706 = phi_792_;
            let _e708 = phi_793_;
            let _e712 = lt_mask_Reprojection(_e708.pixel, _e706, _e708.has_moved);
            let _e713 = lt_mask_Neighbourhood(false, true);
            if _e247 {
                phi_799_ = false;
            } else {
                phi_799_ = true;
            }
            let _e715 = phi_799_;
            if _e715 {
                if _e706 {
                    if ((0u & 2u) != 0u) {
                        phi_839_ = _e713;
                    } else {
                        let _e732 = ((((_e712.pixel.y * _e80) + (_e712.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e243) | (select(0u, 1u, _e712.has_moved) << bitcast<u32>(1i))));
                        if (_e732 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e736 = heard.member[(0u + _e732)];
                        let _e742 = (((_e736 >> bitcast<u32>(((_e712.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_839_ = lt_mask_Neighbourhood(_e742, !(_e742));
                    }
                    let _e746 = phi_839_;
                    phi_840_ = _e746;
                } else {
                    phi_840_ = _e713;
                }
                let _e748 = phi_840_;
                phi_841_ = _e748;
            } else {
                phi_841_ = _e713;
            }
            let _e750 = phi_841_;
            let _e753 = p.member.frame;
            let _e755 = p.member.refresh;
            if (_e755 == 0u) {
                phi_874_ = false;
            } else {
                if (_e755 == 0u) {
                    return;
                }
                let _e764 = ((_e48.x + (_e48.y * (((_e755 * 5u) / 8u) | 1u))) + (_e753 % _e755));
                if (_e755 == 0u) {
                    phi_873_ = (_e764 == 0u);
                } else {
                    if (_e755 == 0u) {
                        return;
                    }
                    phi_873_ = ((_e764 % _e755) == 0u);
                }
                let _e771 = phi_873_;
                phi_874_ = _e771;
            }
            let _e773 = phi_874_;
            if _e706 {
                if _e773 {
                    phi_896_ = bool();
                } else {
                    phi_896_ = ((0u & 2u) != 0u);
                }
                let _e779 = phi_896_;
                phi_897_ = _e779;
                phi_898_ = _e773;
            } else {
                phi_897_ = bool();
                phi_898_ = true;
            }
            let _e781 = phi_897_;
            let _e783 = phi_898_;
            if _e783 {
                phi_902_ = false;
            } else {
                phi_902_ = _e781;
            }
            let _e785 = phi_902_;
            if _e785 {
                phi_953_ = 7u;
            } else {
                if (_e85 != 0.5f) {
                    if _e706 {
                        if _e773 {
                            phi_950_ = 6u;
                        } else {
                            if _e247 {
                                phi_925_ = true;
                            } else {
                                if _e750.any_expands {
                                    phi_924_ = false;
                                } else {
                                    phi_924_ = true;
                                }
                                let _e787 = phi_924_;
                                phi_925_ = _e787;
                            }
                            let _e789 = phi_925_;
                            if _e789 {
                                if _e247 {
                                    if false {
                                        if _e750.all_remove {
                                            phi_938_ = false;
                                        } else {
                                            phi_938_ = true;
                                        }
                                        let _e791 = phi_938_;
                                        phi_939_ = _e791;
                                    } else {
                                        phi_939_ = true;
                                    }
                                    let _e793 = phi_939_;
                                    phi_940_ = _e793;
                                } else {
                                    phi_940_ = true;
                                }
                                let _e795 = phi_940_;
                                if _e795 {
                                    if _e247 {
                                        phi_947_ = 1u;
                                    } else {
                                        phi_947_ = 0u;
                                    }
                                    let _e797 = phi_947_;
                                    phi_948_ = _e797;
                                } else {
                                    phi_948_ = 5u;
                                }
                                let _e799 = phi_948_;
                                phi_949_ = _e799;
                            } else {
                                phi_949_ = 4u;
                            }
                            let _e801 = phi_949_;
                            phi_950_ = _e801;
                        }
                        let _e803 = phi_950_;
                        phi_951_ = _e803;
                    } else {
                        phi_951_ = 3u;
                    }
                    let _e805 = phi_951_;
                    phi_952_ = _e805;
                } else {
                    phi_952_ = 2u;
                }
                let _e807 = phi_952_;
                phi_953_ = _e807;
            }
            let _e809 = phi_953_;
            if !((_e809 == 0u)) {
                if !((_e809 == 5u)) {
                    phi_965_ = !(_e785);
                    phi_966_ = false;
                } else {
                    phi_965_ = bool();
                    phi_966_ = true;
                }
                let _e816 = phi_965_;
                let _e818 = phi_966_;
                phi_967_ = _e816;
                phi_968_ = _e818;
            } else {
                phi_967_ = bool();
                phi_968_ = true;
            }
            let _e820 = phi_967_;
            let _e822 = phi_968_;
            if _e822 {
                phi_972_ = false;
            } else {
                phi_972_ = _e820;
            }
            let _e824 = phi_972_;
            if _e785 {
                phi_978_ = ((0u & 4u) != 0u);
            } else {
                phi_978_ = _e243;
            }
            let _e828 = phi_978_;
            if _e824 {
                if _e243 {
                    phi_986_ = (2u | 1u);
                } else {
                    phi_986_ = 2u;
                }
                let _e831 = phi_986_;
                if false {
                    phi_991_ = (_e831 | 4u);
                } else {
                    phi_991_ = _e831;
                }
                let _e834 = phi_991_;
                phi_1011_ = _e834;
            } else {
                if (_e809 == 7u) {
                    if _e243 {
                        phi_1000_ = (2u | 1u);
                    } else {
                        phi_1000_ = 2u;
                    }
                    let _e838 = phi_1000_;
                    if _e828 {
                        phi_1005_ = (_e838 | 4u);
                    } else {
                        phi_1005_ = _e838;
                    }
                    let _e841 = phi_1005_;
                    phi_1010_ = _e841;
                } else {
                    if _e243 {
                        phi_1009_ = 1u;
                    } else {
                        phi_1009_ = 0u;
                    }
                    let _e843 = phi_1009_;
                    phi_1010_ = _e843;
                }
                let _e845 = phi_1010_;
                phi_1011_ = _e845;
            }
            let _e847 = phi_1011_;
            if _e828 {
                phi_1015_ = 0f;
            } else {
                phi_1015_ = 1f;
            }
            let _e849 = phi_1015_;
            phi_1017_ = mask_Masked(_e849, _e847, _e824);
        }
        let _e852 = phi_1017_;
        visibility.member[_e64.first_primitive] = _e852.visibility;
        let _e857 = p.member.light.number;
        let _e858 = (_e857 * 3u);
        let _e860 = (_e858 % 32u);
        let _e862 = p.member.light.mask_words;
        let _e864 = ((_e64.first_primitive * _e862) + (_e858 / 32u));
        let _e866 = bits.member[_e864];
        bits.member[_e864] = ((_e866 & ~((7u << bitcast<u32>((_e860 & 31u))))) | (_e852.bits << bitcast<u32>((_e860 & 31u))));
        if (_e860 > 29u) {
            let _e881 = bits.member[(_e864 + 1u)];
            let _e883 = (32u - _e860);
            bits.member[(_e864 + 1u)] = ((_e881 & ~((7u >> bitcast<u32>((_e883 & 31u))))) | (_e852.bits >> bitcast<u32>((_e883 & 31u))));
        }
        phi_1067_ = _e852.needs_ray;
        phi_1068_ = _e64.first_primitive;
    } else {
        phi_1067_ = false;
        phi_1068_ = 0u;
    }
    let _e897 = phi_1067_;
    let _e899 = phi_1068_;
    if (_e49 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e897 {
        let _e903 = atomicAdd((&shared_[0u]), 1u);
        phi_1079_ = _e903;
    } else {
        phi_1079_ = 0u;
    }
    let _e905 = phi_1079_;
    workgroupBarrier();
    if (_e49 == 0u) {
        let _e909 = atomicLoad((&shared_[0u]));
        let _e910 = atomicAdd((&list.member[3u]), _e909);
        atomicStore((&shared_[1u]), _e910);
    }
    workgroupBarrier();
    if _e897 {
        let _e913 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e913) + _e905)]), _e899);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
