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
@group(0) @binding(6) 
var<storage> last_depths: type_27;
@group(0) @binding(7) 
var<storage, read_write> depths: type_27;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_165_: lt_bvh_traverse_Tree;
    var phi_166_: bool;
    var phi_167_: lt_bvh_traverse_Tree;
    var phi_168_: bool;
    var phi_173_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_165_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_166_ = false;
        } else {
            phi_165_ = lt_bvh_traverse_Tree();
            phi_166_ = true;
        }
        let _e65 = phi_165_;
        let _e67 = phi_166_;
        phi_167_ = _e65;
        phi_168_ = _e67;
    } else {
        phi_167_ = lt_bvh_traverse_Tree();
        phi_168_ = true;
    }
    let _e69 = phi_167_;
    let _e71 = phi_168_;
    if _e71 {
        phi_173_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_173_ = _e69;
    }
    let _e76 = phi_173_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn function_() {
    var phi_241_: bool;
    var phi_242_: bool;
    var phi_243_: bool;
    var phi_244_: bool;
    var phi_248_: bool;
    var phi_318_: bool;
    var phi_319_: bool;
    var phi_330_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_331_: bool;
    var phi_332_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_333_: bool;
    var phi_340_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_344_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_357_: bool;
    var phi_388_: bool;
    var phi_389_: bool;
    var phi_390_: bool;
    var phi_391_: bool;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_607_: f32;
    var phi_612_: f32;
    var phi_613_: bool;
    var phi_614_: f32;
    var phi_615_: bool;
    var phi_619_: f32;
    var phi_640_: f32;
    var phi_645_: f32;
    var phi_646_: bool;
    var phi_647_: f32;
    var phi_648_: bool;
    var phi_652_: f32;
    var phi_673_: bool;
    var phi_692_: vec2<u32>;
    var phi_693_: bool;
    var phi_694_: bool;
    var phi_695_: bool;
    var phi_696_: vec2<u32>;
    var phi_697_: bool;
    var phi_698_: bool;
    var phi_699_: bool;
    var phi_700_: bool;
    var phi_701_: bool;
    var phi_702_: bool;
    var phi_703_: vec2<u32>;
    var phi_704_: bool;
    var phi_705_: bool;
    var phi_706_: bool;
    var phi_707_: bool;
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_710_: vec2<u32>;
    var phi_711_: bool;
    var phi_712_: bool;
    var phi_713_: bool;
    var phi_714_: bool;
    var phi_723_: bool;
    var phi_724_: bool;
    var phi_725_: bool;
    var phi_726_: bool;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_732_: vec2<u32>;
    var phi_770_: bool;
    var phi_772_: lt_mask_Reprojection;
    var phi_773_: lt_mask_Reprojection;
    var phi_774_: lt_mask_Reprojection;
    var phi_775_: bool;
    var phi_776_: bool;
    var phi_777_: lt_mask_Reprojection;
    var phi_778_: lt_mask_Reprojection;
    var phi_779_: lt_mask_Reprojection;
    var phi_780_: bool;
    var phi_781_: bool;
    var phi_836_: bool;
    var phi_840_: f32;
    var phi_844_: lt_mask_Reprojection;
    var phi_845_: bool;
    var phi_857_: bool;
    var phi_858_: bool;
    var phi_859_: bool;
    var phi_860_: lt_mask_Reprojection;
    var phi_861_: bool;
    var phi_865_: bool;
    var phi_866_: lt_mask_Reprojection;
    var phi_872_: bool;
    var phi_904_: u32;
    var phi_933_: lt_mask_Neighbourhood;
    var phi_934_: lt_mask_Neighbourhood;
    var phi_935_: lt_mask_Neighbourhood;
    var phi_967_: bool;
    var phi_968_: bool;
    var phi_990_: bool;
    var phi_991_: bool;
    var phi_992_: bool;
    var phi_996_: bool;
    var phi_1018_: bool;
    var phi_1019_: bool;
    var phi_1032_: bool;
    var phi_1033_: bool;
    var phi_1034_: bool;
    var phi_1041_: u32;
    var phi_1042_: u32;
    var phi_1043_: u32;
    var phi_1044_: u32;
    var phi_1045_: u32;
    var phi_1046_: u32;
    var phi_1047_: u32;
    var phi_1059_: bool;
    var phi_1060_: bool;
    var phi_1061_: bool;
    var phi_1062_: bool;
    var phi_1066_: bool;
    var phi_1072_: bool;
    var phi_1080_: u32;
    var phi_1085_: u32;
    var phi_1094_: u32;
    var phi_1099_: u32;
    var phi_1103_: u32;
    var phi_1104_: u32;
    var phi_1105_: u32;
    var phi_1109_: f32;
    var phi_1111_: mask_Masked;
    var phi_1183_: bool;
    var phi_1184_: bool;
    var phi_1185_: bool;
    var phi_1186_: bool;
    var phi_1190_: bool;
    var phi_1218_: f32;
    var phi_1221_: bool;
    var phi_1222_: u32;
    var phi_1233_: u32;

    let _e52 = id_1;
    let _e53 = local_1;
    let _e69 = p.member.current.size[0u];
    let _e71 = p.member.current.size[1u];
    let _e72 = lt_shaders_entry_pixel_index(_e52, _e69, _e71);
    if (bitcast<i32>(_e72.root) != 0i) {
        let _e80 = p.member.current.size[0u];
        let _e83 = samples.member[_e72.first_primitive].position;
        let _e85 = visibility.member[_e72.first_primitive];
        let _e91 = samples.member[_e72.first_primitive].normal[0u];
        let _e93 = global[0u];
        if (_e91 == _e93) {
            let _e96 = samples.member[_e72.first_primitive].normal[1u];
            let _e98 = global[1u];
            if (_e96 == _e98) {
                let _e101 = samples.member[_e72.first_primitive].normal[2u];
                let _e103 = global[2u];
                phi_241_ = (_e101 == _e103);
                phi_242_ = false;
            } else {
                phi_241_ = bool();
                phi_242_ = true;
            }
            let _e106 = phi_241_;
            let _e108 = phi_242_;
            phi_243_ = _e106;
            phi_244_ = _e108;
        } else {
            phi_243_ = bool();
            phi_244_ = true;
        }
        let _e110 = phi_243_;
        let _e112 = phi_244_;
        if _e112 {
            phi_248_ = false;
        } else {
            phi_248_ = _e110;
        }
        let _e114 = phi_248_;
        if !(_e114) {
            let _e117 = samples.member[_e72.first_primitive].position;
            let _e119 = p.member.light.place;
            let _e125 = p.member.light.place[3u];
            let _e132 = (_e119.x - (_e117.x * _e125));
            let _e133 = (_e119.y - (_e117.y * _e125));
            let _e134 = (_e119.z - (_e117.z * _e125));
            let _e136 = samples.member[_e72.first_primitive].normal;
            if ((((_e136.x * _e132) + (_e136.y * _e133)) + (_e136.z * _e134)) > 0f) {
                let _e150 = (((_e132 * _e132) + (_e133 * _e133)) + (_e134 * _e134));
                let _e152 = p.member.light.axis;
                let _e164 = p.member.light.place[3u];
                if (_e164 == 0f) {
                    phi_319_ = true;
                } else {
                    let _e167 = p.member.light.range_squared;
                    if (_e150 <= _e167) {
                        let _e170 = p.member.light.cos_outer;
                        phi_318_ = (-((((_e132 * _e152.x) + (_e133 * _e152.y)) + (_e134 * _e152.z))) >= (_e170 * sqrt(_e150)));
                    } else {
                        phi_318_ = false;
                    }
                    let _e175 = phi_318_;
                    phi_319_ = _e175;
                }
                let _e177 = phi_319_;
                if _e177 {
                    let _e179 = samples.member[_e72.first_primitive].flags;
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e187.unnamed.visibility, false), _e187.unnamed_1);
                    phi_330_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e193.unnamed, ((_e179 & 1u) == 0u));
                    phi_331_ = false;
                } else {
                    phi_330_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_331_ = true;
                }
                let _e198 = phi_330_;
                let _e200 = phi_331_;
                phi_332_ = _e198;
                phi_333_ = _e200;
            } else {
                phi_332_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_333_ = true;
            }
            let _e202 = phi_332_;
            let _e204 = phi_333_;
            if _e204 {
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e210.unnamed.visibility, false), _e210.unnamed_1);
                phi_340_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e216.unnamed, true);
            } else {
                phi_340_ = _e202;
            }
            let _e221 = phi_340_;
            phi_344_ = _e221;
        } else {
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e233 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e227.unnamed.visibility, false), _e227.unnamed_1);
            phi_344_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e233.unnamed, true);
        }
        let _e238 = phi_344_;
        if _e238.unnamed_1 {
            phi_1111_ = mask_Masked(_e238.unnamed.visibility, 0u, false);
        } else {
            let _e243 = (_e85 < 0.5f);
            if (_e85 > 0f) {
                phi_357_ = (_e85 < 1f);
            } else {
                phi_357_ = false;
            }
            let _e247 = phi_357_;
            let _e254 = lt_mask_Reprojection(vec2<u32>(_e52.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e261 = lt_mask_Reprojection(vec2<u32>(_e254.pixel.x, _e52.y), _e254.is_valid, _e254.has_moved);
            let _e265 = lt_mask_Reprojection(_e261.pixel, true, _e261.has_moved);
            let _e271 = p.member.flags;
            if ((_e271 & 16u) == 0u) {
                phi_396_ = false;
            } else {
                let _e277 = samples.member[_e72.first_primitive].position[0u];
                if (_e83.x == _e277) {
                    let _e281 = samples.member[_e72.first_primitive].position[1u];
                    if (_e83.y == _e281) {
                        let _e285 = samples.member[_e72.first_primitive].position[2u];
                        phi_388_ = (_e83.z == _e285);
                        phi_389_ = false;
                    } else {
                        phi_388_ = bool();
                        phi_389_ = true;
                    }
                    let _e288 = phi_388_;
                    let _e290 = phi_389_;
                    phi_390_ = _e288;
                    phi_391_ = _e290;
                } else {
                    phi_390_ = bool();
                    phi_391_ = true;
                }
                let _e292 = phi_390_;
                let _e294 = phi_391_;
                if _e294 {
                    phi_395_ = false;
                } else {
                    phi_395_ = _e292;
                }
                let _e296 = phi_395_;
                phi_396_ = _e296;
            }
            let _e298 = phi_396_;
            if _e298 {
                phi_777_ = lt_mask_Reprojection(_e265.pixel, _e265.is_valid, false);
                phi_778_ = lt_mask_Reprojection();
                phi_779_ = lt_mask_Reprojection();
                phi_780_ = true;
                phi_781_ = false;
            } else {
                let _e300 = samples.member[_e72.first_primitive].position;
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
                let _e488 = ((f32(_e52.x) + ((f32((_e52.y & (_e464 - 1u))) + 0.5f) / f32(_e464))) + _e452);
                if (_e488 > -8388608f) {
                    let _e500 = f32(select(0i, select(select(i32(_e488), i32(-2147483648), (_e488 < bitcast<f32>(3472883712u))), 2147483647i, (_e488 > bitcast<f32>(1325400063u))), (_e488 == _e488)));
                    if (_e500 > _e488) {
                        phi_607_ = 1f;
                    } else {
                        phi_607_ = 0f;
                    }
                    let _e503 = phi_607_;
                    if (_e488 < 8388608f) {
                        phi_612_ = (_e500 - _e503);
                        phi_613_ = false;
                    } else {
                        phi_612_ = f32();
                        phi_613_ = true;
                    }
                    let _e506 = phi_612_;
                    let _e508 = phi_613_;
                    phi_614_ = _e506;
                    phi_615_ = _e508;
                } else {
                    phi_614_ = f32();
                    phi_615_ = true;
                }
                let _e510 = phi_614_;
                let _e512 = phi_615_;
                if _e512 {
                    phi_619_ = _e488;
                } else {
                    phi_619_ = _e510;
                }
                let _e514 = phi_619_;
                let _e515 = ((f32(_e52.y) + ((f32((_e52.x & (_e462 - 1u))) + 0.5f) / f32(_e462))) + _e458);
                if (_e515 > -8388608f) {
                    let _e527 = f32(select(0i, select(select(i32(_e515), i32(-2147483648), (_e515 < bitcast<f32>(3472883712u))), 2147483647i, (_e515 > bitcast<f32>(1325400063u))), (_e515 == _e515)));
                    if (_e527 > _e515) {
                        phi_640_ = 1f;
                    } else {
                        phi_640_ = 0f;
                    }
                    let _e530 = phi_640_;
                    if (_e515 < 8388608f) {
                        phi_645_ = (_e527 - _e530);
                        phi_646_ = false;
                    } else {
                        phi_645_ = f32();
                        phi_646_ = true;
                    }
                    let _e533 = phi_645_;
                    let _e535 = phi_646_;
                    phi_647_ = _e533;
                    phi_648_ = _e535;
                } else {
                    phi_647_ = f32();
                    phi_648_ = true;
                }
                let _e537 = phi_647_;
                let _e539 = phi_648_;
                if _e539 {
                    phi_652_ = _e515;
                } else {
                    phi_652_ = _e537;
                }
                let _e541 = phi_652_;
                if (_e514 >= 0f) {
                    if (_e541 >= 0f) {
                        if (_e514 < f32(_e484)) {
                            let _e547 = (_e541 < f32(_e486));
                            if (_e452 == 0f) {
                                phi_673_ = (_e458 == 0f);
                            } else {
                                phi_673_ = false;
                            }
                            let _e551 = phi_673_;
                            if _e547 {
                                phi_692_ = vec2<u32>(select(select(u32(_e514), 0u, (_e514 < bitcast<f32>(0u))), 4294967295u, (_e514 > bitcast<f32>(1333788671u))), select(select(u32(_e541), 0u, (_e541 < bitcast<f32>(0u))), 4294967295u, (_e541 > bitcast<f32>(1333788671u))));
                                phi_693_ = false;
                            } else {
                                phi_692_ = vec2<u32>();
                                phi_693_ = true;
                            }
                            let _e568 = phi_692_;
                            let _e570 = phi_693_;
                            phi_694_ = _e551;
                            phi_695_ = _e547;
                            phi_696_ = _e568;
                            phi_697_ = _e551;
                            phi_698_ = _e547;
                            phi_699_ = false;
                            phi_700_ = _e570;
                        } else {
                            phi_694_ = bool();
                            phi_695_ = bool();
                            phi_696_ = vec2<u32>();
                            phi_697_ = bool();
                            phi_698_ = bool();
                            phi_699_ = true;
                            phi_700_ = false;
                        }
                        let _e572 = phi_694_;
                        let _e574 = phi_695_;
                        let _e576 = phi_696_;
                        let _e578 = phi_697_;
                        let _e580 = phi_698_;
                        let _e582 = phi_699_;
                        let _e584 = phi_700_;
                        phi_701_ = _e572;
                        phi_702_ = _e574;
                        phi_703_ = _e576;
                        phi_704_ = _e578;
                        phi_705_ = _e580;
                        phi_706_ = _e582;
                        phi_707_ = _e584;
                    } else {
                        phi_701_ = bool();
                        phi_702_ = bool();
                        phi_703_ = vec2<u32>();
                        phi_704_ = bool();
                        phi_705_ = bool();
                        phi_706_ = true;
                        phi_707_ = false;
                    }
                    let _e586 = phi_701_;
                    let _e588 = phi_702_;
                    let _e590 = phi_703_;
                    let _e592 = phi_704_;
                    let _e594 = phi_705_;
                    let _e596 = phi_706_;
                    let _e598 = phi_707_;
                    phi_708_ = _e586;
                    phi_709_ = _e588;
                    phi_710_ = _e590;
                    phi_711_ = _e592;
                    phi_712_ = _e594;
                    phi_713_ = _e596;
                    phi_714_ = _e598;
                } else {
                    phi_708_ = bool();
                    phi_709_ = bool();
                    phi_710_ = vec2<u32>();
                    phi_711_ = bool();
                    phi_712_ = bool();
                    phi_713_ = true;
                    phi_714_ = false;
                }
                let _e600 = phi_708_;
                let _e602 = phi_709_;
                let _e604 = phi_710_;
                let _e606 = phi_711_;
                let _e608 = phi_712_;
                let _e610 = phi_713_;
                let _e612 = phi_714_;
                if _e610 {
                    if (_e452 == 0f) {
                        phi_723_ = (_e458 == 0f);
                    } else {
                        phi_723_ = false;
                    }
                    let _e616 = phi_723_;
                    phi_724_ = _e616;
                    phi_725_ = false;
                    phi_726_ = true;
                } else {
                    phi_724_ = _e606;
                    phi_725_ = _e608;
                    phi_726_ = _e612;
                }
                let _e618 = phi_724_;
                let _e620 = phi_725_;
                let _e622 = phi_726_;
                if _e622 {
                    phi_730_ = _e618;
                    phi_731_ = _e620;
                    phi_732_ = vec2<u32>(_e52.x, _e52.y);
                } else {
                    phi_730_ = _e600;
                    phi_731_ = _e602;
                    phi_732_ = _e604;
                }
                let _e624 = phi_730_;
                let _e626 = phi_731_;
                let _e628 = phi_732_;
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
                        phi_770_ = false;
                    } else {
                        phi_770_ = true;
                    }
                    let _e682 = phi_770_;
                    phi_772_ = _e680;
                    phi_773_ = _e680;
                    phi_774_ = lt_mask_Reprojection();
                    phi_775_ = _e676;
                    phi_776_ = _e682;
                } else {
                    phi_772_ = lt_mask_Reprojection();
                    phi_773_ = lt_mask_Reprojection();
                    phi_774_ = lt_mask_Reprojection(_e653.pixel, false, _e653.has_moved);
                    phi_775_ = false;
                    phi_776_ = false;
                }
                let _e688 = phi_772_;
                let _e690 = phi_773_;
                let _e692 = phi_774_;
                let _e694 = phi_775_;
                let _e696 = phi_776_;
                phi_777_ = _e688;
                phi_778_ = _e690;
                phi_779_ = _e692;
                phi_780_ = _e694;
                phi_781_ = _e696;
            }
            let _e698 = phi_777_;
            let _e700 = phi_778_;
            let _e702 = phi_779_;
            let _e704 = phi_780_;
            let _e706 = phi_781_;
            if _e704 {
                let _e709 = p.member.previous.eye;
                let _e720 = p.member.previous.forward;
                let _e728 = ((((_e83.x - _e709.x) * _e720.x) + ((_e83.y - _e709.y) * _e720.y)) + ((_e83.z - _e709.z) * _e720.z));
                let _e734 = ((_e698.pixel.y * _e80) + _e698.pixel.x);
                if (_e734 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e738 = last_depths.member[(0u + _e734)];
                let _e740 = p.member.depth_tolerance;
                let _e743 = abs(_e728);
                let _e744 = abs(_e738);
                if ((bitcast<u32>(_e744) & 2147483647u) > 2139095040u) {
                    phi_836_ = true;
                } else {
                    let _e748 = (_e744 > _e743);
                    if _e748 {
                    }
                    phi_836_ = _e748;
                }
                let _e750 = phi_836_;
                if _e750 {
                    phi_840_ = _e744;
                } else {
                    phi_840_ = _e743;
                }
                let _e752 = phi_840_;
                phi_844_ = lt_mask_Reprojection(_e698.pixel, (abs((_e728 - _e738)) <= (_e740 * _e752)), _e698.has_moved);
                phi_845_ = true;
            } else {
                phi_844_ = _e700;
                phi_845_ = _e706;
            }
            let _e760 = phi_844_;
            let _e762 = phi_845_;
            if _e762 {
                if _e760.is_valid {
                    let _e765 = p.member.flags;
                    phi_857_ = ((_e765 & 1u) != 0u);
                    phi_858_ = false;
                } else {
                    phi_857_ = bool();
                    phi_858_ = true;
                }
                let _e769 = phi_857_;
                let _e771 = phi_858_;
                phi_859_ = _e769;
                phi_860_ = _e760;
                phi_861_ = _e771;
            } else {
                phi_859_ = bool();
                phi_860_ = _e702;
                phi_861_ = true;
            }
            let _e773 = phi_859_;
            let _e775 = phi_860_;
            let _e777 = phi_861_;
            if _e777 {
                phi_865_ = false;
                phi_866_ = _e775;
            } else {
                phi_865_ = _e773;
                phi_866_ = _e760;
            }
            let _e779 = phi_865_;
            let _e781 = phi_866_;
            let _e785 = lt_mask_Reprojection(_e781.pixel, _e779, _e781.has_moved);
            let _e786 = lt_mask_Neighbourhood(false, true);
            if _e247 {
                phi_872_ = false;
            } else {
                phi_872_ = true;
            }
            let _e788 = phi_872_;
            if _e788 {
                if _e779 {
                    if ((0u & 2u) != 0u) {
                        phi_933_ = _e786;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e797 = (_e80 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e80 % 32u) > 0u) {
                            phi_904_ = (_e797 + 1u);
                        } else {
                            phi_904_ = _e797;
                        }
                        let _e803 = phi_904_;
                        let _e813 = ((((_e785.pixel.y * _e803) + (_e785.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e243) | (select(0u, 1u, _e785.has_moved) << bitcast<u32>(1i))));
                        if (_e813 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e817 = heard.member[(0u + _e813)];
                        let _e823 = (((_e817 >> bitcast<u32>(((_e785.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_933_ = lt_mask_Neighbourhood(_e823, !(_e823));
                    }
                    let _e827 = phi_933_;
                    phi_934_ = _e827;
                } else {
                    phi_934_ = _e786;
                }
                let _e829 = phi_934_;
                phi_935_ = _e829;
            } else {
                phi_935_ = _e786;
            }
            let _e831 = phi_935_;
            let _e834 = p.member.frame;
            let _e836 = p.member.refresh;
            if (_e836 == 0u) {
                phi_968_ = false;
            } else {
                if (_e836 == 0u) {
                    return;
                }
                let _e845 = ((_e52.x + (_e52.y * (((_e836 * 5u) / 8u) | 1u))) + (_e834 % _e836));
                if (_e836 == 0u) {
                    phi_967_ = (_e845 == 0u);
                } else {
                    if (_e836 == 0u) {
                        return;
                    }
                    phi_967_ = ((_e845 % _e836) == 0u);
                }
                let _e852 = phi_967_;
                phi_968_ = _e852;
            }
            let _e854 = phi_968_;
            if _e779 {
                if _e854 {
                    phi_990_ = bool();
                } else {
                    phi_990_ = ((0u & 2u) != 0u);
                }
                let _e860 = phi_990_;
                phi_991_ = _e860;
                phi_992_ = _e854;
            } else {
                phi_991_ = bool();
                phi_992_ = true;
            }
            let _e862 = phi_991_;
            let _e864 = phi_992_;
            if _e864 {
                phi_996_ = false;
            } else {
                phi_996_ = _e862;
            }
            let _e866 = phi_996_;
            if _e866 {
                phi_1047_ = 7u;
            } else {
                if (_e85 != 0.5f) {
                    if _e779 {
                        if _e854 {
                            phi_1044_ = 6u;
                        } else {
                            if _e247 {
                                phi_1019_ = true;
                            } else {
                                if _e831.any_expands {
                                    phi_1018_ = false;
                                } else {
                                    phi_1018_ = true;
                                }
                                let _e868 = phi_1018_;
                                phi_1019_ = _e868;
                            }
                            let _e870 = phi_1019_;
                            if _e870 {
                                if _e247 {
                                    if false {
                                        if _e831.all_remove {
                                            phi_1032_ = false;
                                        } else {
                                            phi_1032_ = true;
                                        }
                                        let _e872 = phi_1032_;
                                        phi_1033_ = _e872;
                                    } else {
                                        phi_1033_ = true;
                                    }
                                    let _e874 = phi_1033_;
                                    phi_1034_ = _e874;
                                } else {
                                    phi_1034_ = true;
                                }
                                let _e876 = phi_1034_;
                                if _e876 {
                                    if _e247 {
                                        phi_1041_ = 1u;
                                    } else {
                                        phi_1041_ = 0u;
                                    }
                                    let _e878 = phi_1041_;
                                    phi_1042_ = _e878;
                                } else {
                                    phi_1042_ = 5u;
                                }
                                let _e880 = phi_1042_;
                                phi_1043_ = _e880;
                            } else {
                                phi_1043_ = 4u;
                            }
                            let _e882 = phi_1043_;
                            phi_1044_ = _e882;
                        }
                        let _e884 = phi_1044_;
                        phi_1045_ = _e884;
                    } else {
                        phi_1045_ = 3u;
                    }
                    let _e886 = phi_1045_;
                    phi_1046_ = _e886;
                } else {
                    phi_1046_ = 2u;
                }
                let _e888 = phi_1046_;
                phi_1047_ = _e888;
            }
            let _e890 = phi_1047_;
            if !((_e890 == 0u)) {
                if !((_e890 == 5u)) {
                    phi_1059_ = !(_e866);
                    phi_1060_ = false;
                } else {
                    phi_1059_ = bool();
                    phi_1060_ = true;
                }
                let _e897 = phi_1059_;
                let _e899 = phi_1060_;
                phi_1061_ = _e897;
                phi_1062_ = _e899;
            } else {
                phi_1061_ = bool();
                phi_1062_ = true;
            }
            let _e901 = phi_1061_;
            let _e903 = phi_1062_;
            if _e903 {
                phi_1066_ = false;
            } else {
                phi_1066_ = _e901;
            }
            let _e905 = phi_1066_;
            if _e866 {
                phi_1072_ = ((0u & 4u) != 0u);
            } else {
                phi_1072_ = _e243;
            }
            let _e909 = phi_1072_;
            if _e905 {
                if _e243 {
                    phi_1080_ = (2u | 1u);
                } else {
                    phi_1080_ = 2u;
                }
                let _e912 = phi_1080_;
                if false {
                    phi_1085_ = (_e912 | 4u);
                } else {
                    phi_1085_ = _e912;
                }
                let _e915 = phi_1085_;
                phi_1105_ = _e915;
            } else {
                if (_e890 == 7u) {
                    if _e243 {
                        phi_1094_ = (2u | 1u);
                    } else {
                        phi_1094_ = 2u;
                    }
                    let _e919 = phi_1094_;
                    if _e909 {
                        phi_1099_ = (_e919 | 4u);
                    } else {
                        phi_1099_ = _e919;
                    }
                    let _e922 = phi_1099_;
                    phi_1104_ = _e922;
                } else {
                    if _e243 {
                        phi_1103_ = 1u;
                    } else {
                        phi_1103_ = 0u;
                    }
                    let _e924 = phi_1103_;
                    phi_1104_ = _e924;
                }
                let _e926 = phi_1104_;
                phi_1105_ = _e926;
            }
            let _e928 = phi_1105_;
            if _e909 {
                phi_1109_ = 0f;
            } else {
                phi_1109_ = 1f;
            }
            let _e930 = phi_1109_;
            phi_1111_ = mask_Masked(_e930, _e928, _e905);
        }
        let _e933 = phi_1111_;
        visibility.member[_e72.first_primitive] = _e933.visibility;
        let _e938 = p.member.light.number;
        let _e939 = (_e938 * 3u);
        let _e941 = (_e939 % 32u);
        let _e943 = p.member.light.mask_words;
        let _e945 = ((_e72.first_primitive * _e943) + (_e939 / 32u));
        let _e947 = bits.member[_e945];
        bits.member[_e945] = ((_e947 & ~((7u << bitcast<u32>((_e941 & 31u))))) | (_e933.bits << bitcast<u32>((_e941 & 31u))));
        if (_e941 > 29u) {
            let _e962 = bits.member[(_e945 + 1u)];
            let _e964 = (32u - _e941);
            bits.member[(_e945 + 1u)] = ((_e962 & ~((7u >> bitcast<u32>((_e964 & 31u))))) | (_e933.bits >> bitcast<u32>((_e964 & 31u))));
        }
        let _e979 = samples.member[_e72.first_primitive].normal[0u];
        let _e981 = global[0u];
        if (_e979 == _e981) {
            let _e984 = samples.member[_e72.first_primitive].normal[1u];
            let _e986 = global[1u];
            if (_e984 == _e986) {
                let _e989 = samples.member[_e72.first_primitive].normal[2u];
                let _e991 = global[2u];
                phi_1183_ = (_e989 == _e991);
                phi_1184_ = false;
            } else {
                phi_1183_ = bool();
                phi_1184_ = true;
            }
            let _e994 = phi_1183_;
            let _e996 = phi_1184_;
            phi_1185_ = _e994;
            phi_1186_ = _e996;
        } else {
            phi_1185_ = bool();
            phi_1186_ = true;
        }
        let _e998 = phi_1185_;
        let _e1000 = phi_1186_;
        if _e1000 {
            phi_1190_ = false;
        } else {
            phi_1190_ = _e998;
        }
        let _e1002 = phi_1190_;
        if !(_e1002) {
            let _e1005 = samples.member[_e72.first_primitive].position;
            let _e1007 = p.member.current.eye;
            let _e1018 = p.member.current.forward;
            phi_1218_ = ((((_e1005.x - _e1007.x) * _e1018.x) + ((_e1005.y - _e1007.y) * _e1018.y)) + ((_e1005.z - _e1007.z) * _e1018.z));
        } else {
            phi_1218_ = 0f;
        }
        let _e1028 = phi_1218_;
        depths.member[_e72.first_primitive] = _e1028;
        phi_1221_ = _e933.needs_ray;
        phi_1222_ = _e72.first_primitive;
    } else {
        phi_1221_ = false;
        phi_1222_ = 0u;
    }
    let _e1032 = phi_1221_;
    let _e1034 = phi_1222_;
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1032 {
        let _e1038 = atomicAdd((&shared_[0u]), 1u);
        phi_1233_ = _e1038;
    } else {
        phi_1233_ = 0u;
    }
    let _e1040 = phi_1233_;
    workgroupBarrier();
    if (_e53 == 0u) {
        let _e1044 = atomicLoad((&shared_[0u]));
        let _e1045 = atomicAdd((&list.member[3u]), _e1044);
        atomicStore((&shared_[1u]), _e1045);
    }
    workgroupBarrier();
    if _e1032 {
        let _e1048 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1048) + _e1040)]), _e1034);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
