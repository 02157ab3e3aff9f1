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
    var phi_164_: lt_bvh_traverse_Tree;
    var phi_165_: bool;
    var phi_166_: lt_bvh_traverse_Tree;
    var phi_167_: bool;
    var phi_172_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_164_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_165_ = false;
        } else {
            phi_164_ = lt_bvh_traverse_Tree();
            phi_165_ = true;
        }
        let _e63 = phi_164_;
        let _e65 = phi_165_;
        phi_166_ = _e63;
        phi_167_ = _e65;
    } else {
        phi_166_ = lt_bvh_traverse_Tree();
        phi_167_ = true;
    }
    let _e67 = phi_166_;
    let _e69 = phi_167_;
    if _e69 {
        phi_172_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_172_ = _e67;
    }
    let _e74 = phi_172_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn function_() {
    var phi_218_: u32;
    var phi_255_: bool;
    var phi_256_: bool;
    var phi_257_: bool;
    var phi_258_: bool;
    var phi_262_: bool;
    var phi_332_: bool;
    var phi_333_: bool;
    var phi_344_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_345_: bool;
    var phi_346_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_347_: bool;
    var phi_354_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_358_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_371_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_401_: bool;
    var phi_402_: bool;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_615_: f32;
    var phi_620_: f32;
    var phi_621_: bool;
    var phi_622_: f32;
    var phi_623_: bool;
    var phi_627_: f32;
    var phi_648_: f32;
    var phi_653_: f32;
    var phi_654_: bool;
    var phi_655_: f32;
    var phi_656_: bool;
    var phi_660_: f32;
    var phi_681_: bool;
    var phi_700_: vec2<u32>;
    var phi_701_: bool;
    var phi_702_: bool;
    var phi_703_: bool;
    var phi_704_: vec2<u32>;
    var phi_705_: bool;
    var phi_706_: bool;
    var phi_707_: bool;
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_710_: bool;
    var phi_711_: vec2<u32>;
    var phi_712_: bool;
    var phi_713_: bool;
    var phi_714_: bool;
    var phi_715_: bool;
    var phi_716_: bool;
    var phi_717_: bool;
    var phi_718_: vec2<u32>;
    var phi_719_: bool;
    var phi_720_: bool;
    var phi_721_: bool;
    var phi_722_: bool;
    var phi_731_: bool;
    var phi_732_: bool;
    var phi_733_: bool;
    var phi_734_: bool;
    var phi_738_: bool;
    var phi_739_: bool;
    var phi_740_: vec2<u32>;
    var phi_775_: bool;
    var phi_777_: lt_mask_Reprojection;
    var phi_778_: lt_mask_Reprojection;
    var phi_779_: bool;
    var phi_783_: bool;
    var phi_784_: lt_mask_Reprojection;
    var phi_785_: lt_mask_Reprojection;
    var phi_786_: bool;
    var phi_794_: bool;
    var phi_795_: lt_mask_Reprojection;
    var phi_861_: u32;
    var phi_866_: u32;
    var phi_867_: u32;
    var phi_868_: u32;
    var phi_869_: bool;
    var phi_870_: u32;
    var phi_871_: bool;
    var phi_872_: bool;
    var phi_873_: u32;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_879_: bool;
    var phi_883_: u32;
    var phi_888_: bool;
    var phi_928_: lt_mask_Neighbourhood;
    var phi_929_: lt_mask_Neighbourhood;
    var phi_930_: lt_mask_Neighbourhood;
    var phi_962_: bool;
    var phi_963_: bool;
    var phi_985_: bool;
    var phi_986_: bool;
    var phi_987_: bool;
    var phi_991_: bool;
    var phi_1013_: bool;
    var phi_1014_: bool;
    var phi_1027_: bool;
    var phi_1028_: bool;
    var phi_1029_: bool;
    var phi_1036_: u32;
    var phi_1037_: u32;
    var phi_1038_: u32;
    var phi_1039_: u32;
    var phi_1040_: u32;
    var phi_1041_: u32;
    var phi_1042_: u32;
    var phi_1054_: bool;
    var phi_1055_: bool;
    var phi_1056_: bool;
    var phi_1057_: bool;
    var phi_1061_: bool;
    var phi_1067_: bool;
    var phi_1075_: u32;
    var phi_1080_: u32;
    var phi_1089_: u32;
    var phi_1094_: u32;
    var phi_1098_: u32;
    var phi_1099_: u32;
    var phi_1100_: u32;
    var phi_1104_: f32;
    var phi_1106_: mask_Masked;
    var phi_1156_: bool;
    var phi_1157_: u32;
    var phi_1168_: u32;

    let _e50 = id_1;
    let _e51 = local_1;
    let _e56 = arrayLength((&heard.member));
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
            phi_218_ = (_e77 + 1u);
        } else {
            phi_218_ = _e77;
        }
        let _e83 = phi_218_;
        let _e86 = past.member[_e67.first_primitive];
        let _e91 = visibility.member[_e67.first_primitive];
        let _e97 = samples.member[_e67.first_primitive].normal[0u];
        let _e99 = global[0u];
        if (_e97 == _e99) {
            let _e102 = samples.member[_e67.first_primitive].normal[1u];
            let _e104 = global[1u];
            if (_e102 == _e104) {
                let _e107 = samples.member[_e67.first_primitive].normal[2u];
                let _e109 = global[2u];
                phi_255_ = (_e107 == _e109);
                phi_256_ = false;
            } else {
                phi_255_ = bool();
                phi_256_ = true;
            }
            let _e112 = phi_255_;
            let _e114 = phi_256_;
            phi_257_ = _e112;
            phi_258_ = _e114;
        } else {
            phi_257_ = bool();
            phi_258_ = true;
        }
        let _e116 = phi_257_;
        let _e118 = phi_258_;
        if _e118 {
            phi_262_ = false;
        } else {
            phi_262_ = _e116;
        }
        let _e120 = phi_262_;
        if !(_e120) {
            let _e123 = samples.member[_e67.first_primitive].position;
            let _e125 = p.member.light.place;
            let _e131 = p.member.light.place[3u];
            let _e138 = (_e125.x - (_e123.x * _e131));
            let _e139 = (_e125.y - (_e123.y * _e131));
            let _e140 = (_e125.z - (_e123.z * _e131));
            let _e142 = samples.member[_e67.first_primitive].normal;
            if ((((_e142.x * _e138) + (_e142.y * _e139)) + (_e142.z * _e140)) > 0f) {
                let _e156 = (((_e138 * _e138) + (_e139 * _e139)) + (_e140 * _e140));
                let _e158 = p.member.light.axis;
                let _e170 = p.member.light.place[3u];
                if (_e170 == 0f) {
                    phi_333_ = true;
                } else {
                    let _e173 = p.member.light.range_squared;
                    if (_e156 <= _e173) {
                        let _e176 = p.member.light.cos_outer;
                        phi_332_ = (-((((_e138 * _e158.x) + (_e139 * _e158.y)) + (_e140 * _e158.z))) >= (_e176 * sqrt(_e156)));
                    } else {
                        phi_332_ = false;
                    }
                    let _e181 = phi_332_;
                    phi_333_ = _e181;
                }
                let _e183 = phi_333_;
                if _e183 {
                    let _e185 = samples.member[_e67.first_primitive].flags;
                    let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e199 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e193.unnamed.visibility, false), _e193.unnamed_1);
                    phi_344_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e199.unnamed, ((_e185 & 1u) == 0u));
                    phi_345_ = false;
                } else {
                    phi_344_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_345_ = true;
                }
                let _e204 = phi_344_;
                let _e206 = phi_345_;
                phi_346_ = _e204;
                phi_347_ = _e206;
            } else {
                phi_346_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_347_ = true;
            }
            let _e208 = phi_346_;
            let _e210 = phi_347_;
            if _e210 {
                let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e216.unnamed.visibility, false), _e216.unnamed_1);
                phi_354_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e222.unnamed, true);
            } else {
                phi_354_ = _e208;
            }
            let _e227 = phi_354_;
            phi_358_ = _e227;
        } else {
            let _e233 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e239 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e233.unnamed.visibility, false), _e233.unnamed_1);
            phi_358_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e239.unnamed, true);
        }
        let _e244 = phi_358_;
        if _e244.unnamed_1 {
            phi_1106_ = mask_Masked(_e244.unnamed.visibility, 0u, false);
        } else {
            let _e249 = (_e91 < 0.5f);
            if (_e91 > 0f) {
                phi_371_ = (_e91 < 1f);
            } else {
                phi_371_ = false;
            }
            let _e253 = phi_371_;
            let _e260 = lt_mask_Reprojection(vec2<u32>(_e50.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e267 = lt_mask_Reprojection(vec2<u32>(_e260.pixel.x, _e50.y), _e260.is_valid, _e260.has_moved);
            let _e271 = lt_mask_Reprojection(_e267.pixel, true, _e267.has_moved);
            let _e277 = p.member.flags;
            if ((_e277 & 16u) == 0u) {
                phi_407_ = false;
            } else {
                let _e282 = samples.member[_e67.first_primitive].position[0u];
                if (_e86.x == _e282) {
                    let _e285 = samples.member[_e67.first_primitive].position[1u];
                    if (_e86.y == _e285) {
                        let _e288 = samples.member[_e67.first_primitive].position[2u];
                        phi_399_ = (_e86.z == _e288);
                        phi_400_ = false;
                    } else {
                        phi_399_ = bool();
                        phi_400_ = true;
                    }
                    let _e291 = phi_399_;
                    let _e293 = phi_400_;
                    phi_401_ = _e291;
                    phi_402_ = _e293;
                } else {
                    phi_401_ = bool();
                    phi_402_ = true;
                }
                let _e295 = phi_401_;
                let _e297 = phi_402_;
                if _e297 {
                    phi_406_ = false;
                } else {
                    phi_406_ = _e295;
                }
                let _e299 = phi_406_;
                phi_407_ = _e299;
            }
            let _e301 = phi_407_;
            if _e301 {
                phi_784_ = lt_mask_Reprojection(_e271.pixel, _e271.is_valid, false);
                phi_785_ = lt_mask_Reprojection();
                phi_786_ = true;
            } else {
                let _e303 = samples.member[_e67.first_primitive].position;
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
                let _e488 = ((f32(_e50.x) + ((f32((_e50.y & (_e464 - 1u))) + 0.5f) / f32(_e464))) + _e452);
                if (_e488 > -8388608f) {
                    let _e500 = f32(select(0i, select(select(i32(_e488), i32(-2147483648), (_e488 < bitcast<f32>(3472883712u))), 2147483647i, (_e488 > bitcast<f32>(1325400063u))), (_e488 == _e488)));
                    if (_e500 > _e488) {
                        phi_615_ = 1f;
                    } else {
                        phi_615_ = 0f;
                    }
                    let _e503 = phi_615_;
                    if (_e488 < 8388608f) {
                        phi_620_ = (_e500 - _e503);
                        phi_621_ = false;
                    } else {
                        phi_620_ = f32();
                        phi_621_ = true;
                    }
                    let _e506 = phi_620_;
                    let _e508 = phi_621_;
                    phi_622_ = _e506;
                    phi_623_ = _e508;
                } else {
                    phi_622_ = f32();
                    phi_623_ = true;
                }
                let _e510 = phi_622_;
                let _e512 = phi_623_;
                if _e512 {
                    phi_627_ = _e488;
                } else {
                    phi_627_ = _e510;
                }
                let _e514 = phi_627_;
                let _e515 = ((f32(_e50.y) + ((f32((_e50.x & (_e462 - 1u))) + 0.5f) / f32(_e462))) + _e458);
                if (_e515 > -8388608f) {
                    let _e527 = f32(select(0i, select(select(i32(_e515), i32(-2147483648), (_e515 < bitcast<f32>(3472883712u))), 2147483647i, (_e515 > bitcast<f32>(1325400063u))), (_e515 == _e515)));
                    if (_e527 > _e515) {
                        phi_648_ = 1f;
                    } else {
                        phi_648_ = 0f;
                    }
                    let _e530 = phi_648_;
                    if (_e515 < 8388608f) {
                        phi_653_ = (_e527 - _e530);
                        phi_654_ = false;
                    } else {
                        phi_653_ = f32();
                        phi_654_ = true;
                    }
                    let _e533 = phi_653_;
                    let _e535 = phi_654_;
                    phi_655_ = _e533;
                    phi_656_ = _e535;
                } else {
                    phi_655_ = f32();
                    phi_656_ = true;
                }
                let _e537 = phi_655_;
                let _e539 = phi_656_;
                if _e539 {
                    phi_660_ = _e515;
                } else {
                    phi_660_ = _e537;
                }
                let _e541 = phi_660_;
                if (_e514 >= 0f) {
                    if (_e541 >= 0f) {
                        if (_e514 < f32(_e484)) {
                            let _e547 = (_e541 < f32(_e486));
                            if (_e452 == 0f) {
                                phi_681_ = (_e458 == 0f);
                            } else {
                                phi_681_ = false;
                            }
                            let _e551 = phi_681_;
                            if _e547 {
                                phi_700_ = vec2<u32>(select(select(u32(_e514), 0u, (_e514 < bitcast<f32>(0u))), 4294967295u, (_e514 > bitcast<f32>(1333788671u))), select(select(u32(_e541), 0u, (_e541 < bitcast<f32>(0u))), 4294967295u, (_e541 > bitcast<f32>(1333788671u))));
                                phi_701_ = false;
                            } else {
                                phi_700_ = vec2<u32>();
                                phi_701_ = true;
                            }
                            let _e568 = phi_700_;
                            let _e570 = phi_701_;
                            phi_702_ = _e551;
                            phi_703_ = _e547;
                            phi_704_ = _e568;
                            phi_705_ = _e551;
                            phi_706_ = _e547;
                            phi_707_ = false;
                            phi_708_ = _e570;
                        } else {
                            phi_702_ = bool();
                            phi_703_ = bool();
                            phi_704_ = vec2<u32>();
                            phi_705_ = bool();
                            phi_706_ = bool();
                            phi_707_ = true;
                            phi_708_ = false;
                        }
                        let _e572 = phi_702_;
                        let _e574 = phi_703_;
                        let _e576 = phi_704_;
                        let _e578 = phi_705_;
                        let _e580 = phi_706_;
                        let _e582 = phi_707_;
                        let _e584 = phi_708_;
                        phi_709_ = _e572;
                        phi_710_ = _e574;
                        phi_711_ = _e576;
                        phi_712_ = _e578;
                        phi_713_ = _e580;
                        phi_714_ = _e582;
                        phi_715_ = _e584;
                    } else {
                        phi_709_ = bool();
                        phi_710_ = bool();
                        phi_711_ = vec2<u32>();
                        phi_712_ = bool();
                        phi_713_ = bool();
                        phi_714_ = true;
                        phi_715_ = false;
                    }
                    let _e586 = phi_709_;
                    let _e588 = phi_710_;
                    let _e590 = phi_711_;
                    let _e592 = phi_712_;
                    let _e594 = phi_713_;
                    let _e596 = phi_714_;
                    let _e598 = phi_715_;
                    phi_716_ = _e586;
                    phi_717_ = _e588;
                    phi_718_ = _e590;
                    phi_719_ = _e592;
                    phi_720_ = _e594;
                    phi_721_ = _e596;
                    phi_722_ = _e598;
                } else {
                    phi_716_ = bool();
                    phi_717_ = bool();
                    phi_718_ = vec2<u32>();
                    phi_719_ = bool();
                    phi_720_ = bool();
                    phi_721_ = true;
                    phi_722_ = false;
                }
                let _e600 = phi_716_;
                let _e602 = phi_717_;
                let _e604 = phi_718_;
                let _e606 = phi_719_;
                let _e608 = phi_720_;
                let _e610 = phi_721_;
                let _e612 = phi_722_;
                if _e610 {
                    if (_e452 == 0f) {
                        phi_731_ = (_e458 == 0f);
                    } else {
                        phi_731_ = false;
                    }
                    let _e616 = phi_731_;
                    phi_732_ = _e616;
                    phi_733_ = false;
                    phi_734_ = true;
                } else {
                    phi_732_ = _e606;
                    phi_733_ = _e608;
                    phi_734_ = _e612;
                }
                let _e618 = phi_732_;
                let _e620 = phi_733_;
                let _e622 = phi_734_;
                if _e622 {
                    phi_738_ = _e618;
                    phi_739_ = _e620;
                    phi_740_ = vec2<u32>(_e50.x, _e50.y);
                } else {
                    phi_738_ = _e600;
                    phi_739_ = _e602;
                    phi_740_ = _e604;
                }
                let _e624 = phi_738_;
                let _e626 = phi_739_;
                let _e628 = phi_740_;
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
                        phi_775_ = false;
                    } else {
                        phi_775_ = true;
                    }
                    let _e679 = phi_775_;
                    phi_777_ = _e677;
                    phi_778_ = _e677;
                    phi_779_ = _e679;
                } else {
                    phi_777_ = lt_mask_Reprojection();
                    phi_778_ = lt_mask_Reprojection(_e653.pixel, false, _e653.has_moved);
                    phi_779_ = true;
                }
                let _e685 = phi_777_;
                let _e687 = phi_778_;
                let _e689 = phi_779_;
                if _e689 {
                    phi_783_ = false;
                } else {
                    phi_783_ = true;
                }
                let _e691 = phi_783_;
                phi_784_ = _e685;
                phi_785_ = _e687;
                phi_786_ = _e691;
            }
            let _e693 = phi_784_;
            let _e695 = phi_785_;
            let _e697 = phi_786_;
            if _e697 {
                let _e699 = p.member.flags;
                phi_794_ = ((_e699 & 1u) != 0u);
                phi_795_ = _e693;
            } else {
                phi_794_ = false;
                phi_795_ = _e695;
            }
            let _e703 = phi_794_;
            let _e705 = phi_795_;
            let _e709 = lt_mask_Reprojection(_e705.pixel, _e703, _e705.has_moved);
            let _e711 = p.member.flags;
            let _e713 = ((_e711 & 2u) != 0u);
            let _e715 = p.member.flags;
            if ((_e715 & 4u) == 0u) {
                phi_873_ = u32();
                phi_874_ = true;
                phi_875_ = false;
            } else {
                if _e703 {
                    if !(_e709.has_moved) {
                        let _e724 = ((((_e50.y * _e83) + (_e50.x / 32u)) * 6u) + 4u);
                        if (_e724 < _e56) {
                        } else {
                            return;
                        }
                        let _e728 = heard.member[(0u + _e724)];
                        if (((_e728 >> bitcast<u32>(((_e50.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e739 = ((((_e50.y * _e83) + (_e50.x / 32u)) * 6u) + 5u);
                            if (_e739 < _e56) {
                            } else {
                                return;
                            }
                            let _e743 = heard.member[(0u + _e739)];
                            if false {
                                phi_861_ = (2u | 1u);
                            } else {
                                phi_861_ = 2u;
                            }
                            let _e752 = phi_861_;
                            if (((_e743 >> bitcast<u32>(((_e50.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_866_ = (_e752 | 4u);
                            } else {
                                phi_866_ = _e752;
                            }
                            let _e755 = phi_866_;
                            phi_867_ = _e755;
                        } else {
                            phi_867_ = 0u;
                        }
                        let _e757 = phi_867_;
                        phi_868_ = _e757;
                        phi_869_ = false;
                    } else {
                        phi_868_ = u32();
                        phi_869_ = true;
                    }
                    let _e759 = phi_868_;
                    let _e761 = phi_869_;
                    phi_870_ = _e759;
                    phi_871_ = false;
                    phi_872_ = _e761;
                } else {
                    phi_870_ = u32();
                    phi_871_ = true;
                    phi_872_ = false;
                }
                let _e763 = phi_870_;
                let _e765 = phi_871_;
                let _e767 = phi_872_;
                phi_873_ = _e763;
                phi_874_ = _e765;
                phi_875_ = _e767;
            }
            let _e769 = phi_873_;
            let _e771 = phi_874_;
            let _e773 = phi_875_;
            if _e771 {
                phi_879_ = true;
            } else {
                phi_879_ = _e773;
            }
            let _e775 = phi_879_;
            if _e775 {
                phi_883_ = 0u;
            } else {
                phi_883_ = _e769;
            }
            let _e777 = phi_883_;
            let _e778 = lt_mask_Neighbourhood(false, true);
            if _e253 {
                phi_888_ = _e713;
            } else {
                phi_888_ = true;
            }
            let _e780 = phi_888_;
            if _e780 {
                if _e703 {
                    if ((_e777 & 2u) != 0u) {
                        phi_928_ = _e778;
                    } else {
                        let _e797 = ((((_e709.pixel.y * _e83) + (_e709.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e249) | (select(0u, 1u, _e709.has_moved) << bitcast<u32>(1i))));
                        if (_e797 < _e56) {
                        } else {
                            return;
                        }
                        let _e801 = heard.member[(0u + _e797)];
                        let _e807 = (((_e801 >> bitcast<u32>(((_e709.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_928_ = lt_mask_Neighbourhood(_e807, !(_e807));
                    }
                    let _e811 = phi_928_;
                    phi_929_ = _e811;
                } else {
                    phi_929_ = _e778;
                }
                let _e813 = phi_929_;
                phi_930_ = _e813;
            } else {
                phi_930_ = _e778;
            }
            let _e815 = phi_930_;
            let _e818 = p.member.frame;
            let _e820 = p.member.refresh;
            if (_e820 == 0u) {
                phi_963_ = false;
            } else {
                if (_e820 == 0u) {
                    return;
                }
                let _e829 = ((_e50.x + (_e50.y * (((_e820 * 5u) / 8u) | 1u))) + (_e818 % _e820));
                if (_e820 == 0u) {
                    phi_962_ = (_e829 == 0u);
                } else {
                    if (_e820 == 0u) {
                        return;
                    }
                    phi_962_ = ((_e829 % _e820) == 0u);
                }
                let _e836 = phi_962_;
                phi_963_ = _e836;
            }
            let _e838 = phi_963_;
            if _e703 {
                if _e838 {
                    phi_985_ = bool();
                } else {
                    phi_985_ = ((_e777 & 2u) != 0u);
                }
                let _e844 = phi_985_;
                phi_986_ = _e844;
                phi_987_ = _e838;
            } else {
                phi_986_ = bool();
                phi_987_ = true;
            }
            let _e846 = phi_986_;
            let _e848 = phi_987_;
            if _e848 {
                phi_991_ = false;
            } else {
                phi_991_ = _e846;
            }
            let _e850 = phi_991_;
            if _e850 {
                phi_1042_ = 7u;
            } else {
                if (_e91 != 0.5f) {
                    if _e703 {
                        if _e838 {
                            phi_1039_ = 6u;
                        } else {
                            if _e253 {
                                phi_1014_ = true;
                            } else {
                                if _e815.any_expands {
                                    phi_1013_ = false;
                                } else {
                                    phi_1013_ = true;
                                }
                                let _e852 = phi_1013_;
                                phi_1014_ = _e852;
                            }
                            let _e854 = phi_1014_;
                            if _e854 {
                                if _e253 {
                                    if _e713 {
                                        if _e815.all_remove {
                                            phi_1027_ = false;
                                        } else {
                                            phi_1027_ = true;
                                        }
                                        let _e856 = phi_1027_;
                                        phi_1028_ = _e856;
                                    } else {
                                        phi_1028_ = true;
                                    }
                                    let _e858 = phi_1028_;
                                    phi_1029_ = _e858;
                                } else {
                                    phi_1029_ = true;
                                }
                                let _e860 = phi_1029_;
                                if _e860 {
                                    if _e253 {
                                        phi_1036_ = 1u;
                                    } else {
                                        phi_1036_ = 0u;
                                    }
                                    let _e862 = phi_1036_;
                                    phi_1037_ = _e862;
                                } else {
                                    phi_1037_ = 5u;
                                }
                                let _e864 = phi_1037_;
                                phi_1038_ = _e864;
                            } else {
                                phi_1038_ = 4u;
                            }
                            let _e866 = phi_1038_;
                            phi_1039_ = _e866;
                        }
                        let _e868 = phi_1039_;
                        phi_1040_ = _e868;
                    } else {
                        phi_1040_ = 3u;
                    }
                    let _e870 = phi_1040_;
                    phi_1041_ = _e870;
                } else {
                    phi_1041_ = 2u;
                }
                let _e872 = phi_1041_;
                phi_1042_ = _e872;
            }
            let _e874 = phi_1042_;
            if !((_e874 == 0u)) {
                if !((_e874 == 5u)) {
                    phi_1054_ = !(_e850);
                    phi_1055_ = false;
                } else {
                    phi_1054_ = bool();
                    phi_1055_ = true;
                }
                let _e881 = phi_1054_;
                let _e883 = phi_1055_;
                phi_1056_ = _e881;
                phi_1057_ = _e883;
            } else {
                phi_1056_ = bool();
                phi_1057_ = true;
            }
            let _e885 = phi_1056_;
            let _e887 = phi_1057_;
            if _e887 {
                phi_1061_ = false;
            } else {
                phi_1061_ = _e885;
            }
            let _e889 = phi_1061_;
            if _e850 {
                phi_1067_ = ((_e777 & 4u) != 0u);
            } else {
                phi_1067_ = _e249;
            }
            let _e893 = phi_1067_;
            if _e889 {
                if _e249 {
                    phi_1075_ = (2u | 1u);
                } else {
                    phi_1075_ = 2u;
                }
                let _e896 = phi_1075_;
                if false {
                    phi_1080_ = (_e896 | 4u);
                } else {
                    phi_1080_ = _e896;
                }
                let _e899 = phi_1080_;
                phi_1100_ = _e899;
            } else {
                if (_e874 == 7u) {
                    if _e249 {
                        phi_1089_ = (2u | 1u);
                    } else {
                        phi_1089_ = 2u;
                    }
                    let _e903 = phi_1089_;
                    if _e893 {
                        phi_1094_ = (_e903 | 4u);
                    } else {
                        phi_1094_ = _e903;
                    }
                    let _e906 = phi_1094_;
                    phi_1099_ = _e906;
                } else {
                    if _e249 {
                        phi_1098_ = 1u;
                    } else {
                        phi_1098_ = 0u;
                    }
                    let _e908 = phi_1098_;
                    phi_1099_ = _e908;
                }
                let _e910 = phi_1099_;
                phi_1100_ = _e910;
            }
            let _e912 = phi_1100_;
            if _e893 {
                phi_1104_ = 0f;
            } else {
                phi_1104_ = 1f;
            }
            let _e914 = phi_1104_;
            phi_1106_ = mask_Masked(_e914, _e912, _e889);
        }
        let _e917 = phi_1106_;
        visibility.member[_e67.first_primitive] = _e917.visibility;
        let _e922 = p.member.light.number;
        let _e923 = (_e922 * 3u);
        let _e925 = (_e923 % 32u);
        let _e927 = p.member.light.mask_words;
        let _e929 = ((_e67.first_primitive * _e927) + (_e923 / 32u));
        let _e931 = bits.member[_e929];
        bits.member[_e929] = ((_e931 & ~((7u << bitcast<u32>((_e925 & 31u))))) | (_e917.bits << bitcast<u32>((_e925 & 31u))));
        if (_e925 > 29u) {
            let _e946 = bits.member[(_e929 + 1u)];
            let _e948 = (32u - _e925);
            bits.member[(_e929 + 1u)] = ((_e946 & ~((7u >> bitcast<u32>((_e948 & 31u))))) | (_e917.bits >> bitcast<u32>((_e948 & 31u))));
        }
        phi_1156_ = _e917.needs_ray;
        phi_1157_ = _e67.first_primitive;
    } else {
        phi_1156_ = false;
        phi_1157_ = 0u;
    }
    let _e962 = phi_1156_;
    let _e964 = phi_1157_;
    if (_e51 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e962 {
        let _e968 = atomicAdd((&shared_[0u]), 1u);
        phi_1168_ = _e968;
    } else {
        phi_1168_ = 0u;
    }
    let _e970 = phi_1168_;
    workgroupBarrier();
    if (_e51 == 0u) {
        let _e974 = atomicLoad((&shared_[0u]));
        let _e975 = atomicAdd((&list.member[3u]), _e974);
        atomicStore((&shared_[1u]), _e975);
    }
    workgroupBarrier();
    if _e962 {
        let _e978 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e978) + _e970)]), _e964);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
