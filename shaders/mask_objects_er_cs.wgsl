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
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_164_: lt_bvh_traverse_Tree;
    var phi_165_: bool;
    var phi_170_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_162_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_163_ = false;
        } else {
            phi_162_ = lt_bvh_traverse_Tree();
            phi_163_ = true;
        }
        let _e61 = phi_162_;
        let _e63 = phi_163_;
        phi_164_ = _e61;
        phi_165_ = _e63;
    } else {
        phi_164_ = lt_bvh_traverse_Tree();
        phi_165_ = true;
    }
    let _e65 = phi_164_;
    let _e67 = phi_165_;
    if _e67 {
        phi_170_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_170_ = _e65;
    }
    let _e72 = phi_170_;
    return lt_bvh_traverse_Tree(_e72.root, _e72.first_primitive);
}

fn function_() {
    var phi_216_: u32;
    var phi_253_: bool;
    var phi_254_: bool;
    var phi_255_: bool;
    var phi_256_: bool;
    var phi_260_: bool;
    var phi_330_: bool;
    var phi_331_: bool;
    var phi_342_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_343_: bool;
    var phi_344_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_345_: bool;
    var phi_352_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_356_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_369_: bool;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_541_: f32;
    var phi_546_: f32;
    var phi_547_: bool;
    var phi_548_: f32;
    var phi_549_: bool;
    var phi_553_: f32;
    var phi_574_: f32;
    var phi_579_: f32;
    var phi_580_: bool;
    var phi_581_: f32;
    var phi_582_: bool;
    var phi_586_: f32;
    var phi_607_: bool;
    var phi_626_: vec2<u32>;
    var phi_627_: bool;
    var phi_628_: bool;
    var phi_629_: bool;
    var phi_630_: vec2<u32>;
    var phi_631_: bool;
    var phi_632_: bool;
    var phi_633_: bool;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_636_: bool;
    var phi_637_: vec2<u32>;
    var phi_638_: bool;
    var phi_639_: bool;
    var phi_640_: bool;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_643_: bool;
    var phi_644_: vec2<u32>;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_666_: vec2<u32>;
    var phi_701_: bool;
    var phi_703_: lt_mask_Reprojection;
    var phi_704_: lt_mask_Reprojection;
    var phi_705_: bool;
    var phi_709_: bool;
    var phi_710_: lt_mask_Reprojection;
    var phi_711_: lt_mask_Reprojection;
    var phi_712_: bool;
    var phi_720_: bool;
    var phi_721_: lt_mask_Reprojection;
    var phi_727_: bool;
    var phi_767_: lt_mask_Neighbourhood;
    var phi_768_: lt_mask_Neighbourhood;
    var phi_769_: lt_mask_Neighbourhood;
    var phi_801_: bool;
    var phi_802_: bool;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_830_: bool;
    var phi_852_: bool;
    var phi_853_: bool;
    var phi_866_: bool;
    var phi_867_: bool;
    var phi_868_: bool;
    var phi_875_: u32;
    var phi_876_: u32;
    var phi_877_: u32;
    var phi_878_: u32;
    var phi_879_: u32;
    var phi_880_: u32;
    var phi_881_: u32;
    var phi_893_: bool;
    var phi_894_: bool;
    var phi_895_: bool;
    var phi_896_: bool;
    var phi_900_: bool;
    var phi_906_: bool;
    var phi_914_: u32;
    var phi_919_: u32;
    var phi_928_: u32;
    var phi_933_: u32;
    var phi_937_: u32;
    var phi_938_: u32;
    var phi_939_: u32;
    var phi_943_: f32;
    var phi_945_: mask_Masked;
    var phi_995_: bool;
    var phi_996_: u32;
    var phi_1007_: u32;

    let _e48 = id_1;
    let _e49 = local_1;
    let _e62 = p.member.current.size[0u];
    let _e64 = p.member.current.size[1u];
    let _e65 = lt_shaders_entry_pixel_index(_e48, _e62, _e64);
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
            phi_216_ = (_e75 + 1u);
        } else {
            phi_216_ = _e75;
        }
        let _e81 = phi_216_;
        let _e84 = past.member[_e65.first_primitive];
        let _e89 = visibility.member[_e65.first_primitive];
        let _e95 = samples.member[_e65.first_primitive].normal[0u];
        let _e97 = global[0u];
        if (_e95 == _e97) {
            let _e100 = samples.member[_e65.first_primitive].normal[1u];
            let _e102 = global[1u];
            if (_e100 == _e102) {
                let _e105 = samples.member[_e65.first_primitive].normal[2u];
                let _e107 = global[2u];
                phi_253_ = (_e105 == _e107);
                phi_254_ = false;
            } else {
                phi_253_ = bool();
                phi_254_ = true;
            }
            let _e110 = phi_253_;
            let _e112 = phi_254_;
            phi_255_ = _e110;
            phi_256_ = _e112;
        } else {
            phi_255_ = bool();
            phi_256_ = true;
        }
        let _e114 = phi_255_;
        let _e116 = phi_256_;
        if _e116 {
            phi_260_ = false;
        } else {
            phi_260_ = _e114;
        }
        let _e118 = phi_260_;
        if !(_e118) {
            let _e121 = samples.member[_e65.first_primitive].position;
            let _e123 = p.member.light.place;
            let _e129 = p.member.light.place[3u];
            let _e136 = (_e123.x - (_e121.x * _e129));
            let _e137 = (_e123.y - (_e121.y * _e129));
            let _e138 = (_e123.z - (_e121.z * _e129));
            let _e140 = samples.member[_e65.first_primitive].normal;
            if ((((_e140.x * _e136) + (_e140.y * _e137)) + (_e140.z * _e138)) > 0f) {
                let _e154 = (((_e136 * _e136) + (_e137 * _e137)) + (_e138 * _e138));
                let _e156 = p.member.light.axis;
                let _e168 = p.member.light.place[3u];
                if (_e168 == 0f) {
                    phi_331_ = true;
                } else {
                    let _e171 = p.member.light.range_squared;
                    if (_e154 <= _e171) {
                        let _e174 = p.member.light.cos_outer;
                        phi_330_ = (-((((_e136 * _e156.x) + (_e137 * _e156.y)) + (_e138 * _e156.z))) >= (_e174 * sqrt(_e154)));
                    } else {
                        phi_330_ = false;
                    }
                    let _e179 = phi_330_;
                    phi_331_ = _e179;
                }
                let _e181 = phi_331_;
                if _e181 {
                    let _e183 = samples.member[_e65.first_primitive].flags;
                    let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                    phi_342_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, ((_e183 & 1u) == 0u));
                    phi_343_ = false;
                } else {
                    phi_342_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_343_ = true;
                }
                let _e202 = phi_342_;
                let _e204 = phi_343_;
                phi_344_ = _e202;
                phi_345_ = _e204;
            } else {
                phi_344_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_345_ = true;
            }
            let _e206 = phi_344_;
            let _e208 = phi_345_;
            if _e208 {
                let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e214.unnamed.visibility, false), _e214.unnamed_1);
                phi_352_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e220.unnamed, true);
            } else {
                phi_352_ = _e206;
            }
            let _e225 = phi_352_;
            phi_356_ = _e225;
        } else {
            let _e231 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e237 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e231.unnamed.visibility, false), _e231.unnamed_1);
            phi_356_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e237.unnamed, true);
        }
        let _e242 = phi_356_;
        if _e242.unnamed_1 {
            phi_945_ = mask_Masked(_e242.unnamed.visibility, 0u, false);
        } else {
            let _e247 = (_e89 < 0.5f);
            if (_e89 > 0f) {
                phi_369_ = (_e89 < 1f);
            } else {
                phi_369_ = false;
            }
            let _e251 = phi_369_;
            let _e258 = lt_mask_Reprojection(vec2<u32>(_e48.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e265 = lt_mask_Reprojection(vec2<u32>(_e258.pixel.x, _e48.y), _e258.is_valid, _e258.has_moved);
            let _e269 = lt_mask_Reprojection(_e265.pixel, true, _e265.has_moved);
            let _e275 = p.member.flags;
            if ((_e275 & 16u) == 0u) {
                phi_405_ = false;
            } else {
                let _e280 = samples.member[_e65.first_primitive].position[0u];
                if (_e84.x == _e280) {
                    let _e283 = samples.member[_e65.first_primitive].position[1u];
                    if (_e84.y == _e283) {
                        let _e286 = samples.member[_e65.first_primitive].position[2u];
                        phi_397_ = (_e84.z == _e286);
                        phi_398_ = false;
                    } else {
                        phi_397_ = bool();
                        phi_398_ = true;
                    }
                    let _e289 = phi_397_;
                    let _e291 = phi_398_;
                    phi_399_ = _e289;
                    phi_400_ = _e291;
                } else {
                    phi_399_ = bool();
                    phi_400_ = true;
                }
                let _e293 = phi_399_;
                let _e295 = phi_400_;
                if _e295 {
                    phi_404_ = false;
                } else {
                    phi_404_ = _e293;
                }
                let _e297 = phi_404_;
                phi_405_ = _e297;
            }
            let _e299 = phi_405_;
            if _e299 {
                phi_710_ = lt_mask_Reprojection(_e269.pixel, _e269.is_valid, false);
                phi_711_ = lt_mask_Reprojection();
                phi_712_ = true;
            } else {
                let _e303 = p.member.current.grid[0u];
                let _e305 = p.member.current.grid[1u];
                let _e319 = (f32(_e48.x) + ((f32((_e48.y & (_e305 - 1u))) + 0.5f) / f32(_e305)));
                let _e321 = (f32(_e48.y) + ((f32((_e48.x & (_e303 - 1u))) + 0.5f) / f32(_e303)));
                let _e324 = p.member.previous.eye;
                let _e326 = (_e84.x - _e324.x);
                let _e328 = (_e84.y - _e324.y);
                let _e330 = (_e84.z - _e324.z);
                let _e332 = p.member.previous.forward;
                let _e340 = (((_e326 * _e332.x) + (_e328 * _e332.y)) + (_e330 * _e332.z));
                let _e342 = p.member.previous.right;
                let _e352 = p.member.previous.right;
                let _e367 = p.member.previous.up;
                let _e377 = p.member.previous.up;
                let _e394 = p.member.previous.size[0u];
                let _e401 = p.member.previous.size[1u];
                let _e405 = (((((((_e326 * _e342.x) + (_e328 * _e342.y)) + (_e330 * _e342.z)) / ((((_e352.x * _e352.x) + (_e352.y * _e352.y)) + (_e352.z * _e352.z)) * _e340)) + 1f) * (0.5f * f32(_e394))) - _e319);
                let _e406 = (((1f - ((((_e326 * _e367.x) + (_e328 * _e367.y)) + (_e330 * _e367.z)) / ((((_e377.x * _e377.x) + (_e377.y * _e377.y)) + (_e377.z * _e377.z)) * _e340))) * (0.5f * f32(_e401))) - _e321);
                let _e410 = p.member.current.size[0u];
                let _e412 = p.member.current.size[1u];
                let _e414 = (_e319 + _e405);
                if (_e414 > -8388608f) {
                    let _e426 = f32(select(0i, select(select(i32(_e414), i32(-2147483648), (_e414 < bitcast<f32>(3472883712u))), 2147483647i, (_e414 > bitcast<f32>(1325400063u))), (_e414 == _e414)));
                    if (_e426 > _e414) {
                        phi_541_ = 1f;
                    } else {
                        phi_541_ = 0f;
                    }
                    let _e429 = phi_541_;
                    if (_e414 < 8388608f) {
                        phi_546_ = (_e426 - _e429);
                        phi_547_ = false;
                    } else {
                        phi_546_ = f32();
                        phi_547_ = true;
                    }
                    let _e432 = phi_546_;
                    let _e434 = phi_547_;
                    phi_548_ = _e432;
                    phi_549_ = _e434;
                } else {
                    phi_548_ = f32();
                    phi_549_ = true;
                }
                let _e436 = phi_548_;
                let _e438 = phi_549_;
                if _e438 {
                    phi_553_ = _e414;
                } else {
                    phi_553_ = _e436;
                }
                let _e440 = phi_553_;
                let _e441 = (_e321 + _e406);
                if (_e441 > -8388608f) {
                    let _e453 = f32(select(0i, select(select(i32(_e441), i32(-2147483648), (_e441 < bitcast<f32>(3472883712u))), 2147483647i, (_e441 > bitcast<f32>(1325400063u))), (_e441 == _e441)));
                    if (_e453 > _e441) {
                        phi_574_ = 1f;
                    } else {
                        phi_574_ = 0f;
                    }
                    let _e456 = phi_574_;
                    if (_e441 < 8388608f) {
                        phi_579_ = (_e453 - _e456);
                        phi_580_ = false;
                    } else {
                        phi_579_ = f32();
                        phi_580_ = true;
                    }
                    let _e459 = phi_579_;
                    let _e461 = phi_580_;
                    phi_581_ = _e459;
                    phi_582_ = _e461;
                } else {
                    phi_581_ = f32();
                    phi_582_ = true;
                }
                let _e463 = phi_581_;
                let _e465 = phi_582_;
                if _e465 {
                    phi_586_ = _e441;
                } else {
                    phi_586_ = _e463;
                }
                let _e467 = phi_586_;
                if (_e440 >= 0f) {
                    if (_e467 >= 0f) {
                        if (_e440 < f32(_e410)) {
                            let _e473 = (_e467 < f32(_e412));
                            if (_e405 == 0f) {
                                phi_607_ = (_e406 == 0f);
                            } else {
                                phi_607_ = false;
                            }
                            let _e477 = phi_607_;
                            if _e473 {
                                phi_626_ = vec2<u32>(select(select(u32(_e440), 0u, (_e440 < bitcast<f32>(0u))), 4294967295u, (_e440 > bitcast<f32>(1333788671u))), select(select(u32(_e467), 0u, (_e467 < bitcast<f32>(0u))), 4294967295u, (_e467 > bitcast<f32>(1333788671u))));
                                phi_627_ = false;
                            } else {
                                phi_626_ = vec2<u32>();
                                phi_627_ = true;
                            }
                            let _e494 = phi_626_;
                            let _e496 = phi_627_;
                            phi_628_ = _e477;
                            phi_629_ = _e473;
                            phi_630_ = _e494;
                            phi_631_ = _e477;
                            phi_632_ = _e473;
                            phi_633_ = false;
                            phi_634_ = _e496;
                        } else {
                            phi_628_ = bool();
                            phi_629_ = bool();
                            phi_630_ = vec2<u32>();
                            phi_631_ = bool();
                            phi_632_ = bool();
                            phi_633_ = true;
                            phi_634_ = false;
                        }
                        let _e498 = phi_628_;
                        let _e500 = phi_629_;
                        let _e502 = phi_630_;
                        let _e504 = phi_631_;
                        let _e506 = phi_632_;
                        let _e508 = phi_633_;
                        let _e510 = phi_634_;
                        phi_635_ = _e498;
                        phi_636_ = _e500;
                        phi_637_ = _e502;
                        phi_638_ = _e504;
                        phi_639_ = _e506;
                        phi_640_ = _e508;
                        phi_641_ = _e510;
                    } else {
                        phi_635_ = bool();
                        phi_636_ = bool();
                        phi_637_ = vec2<u32>();
                        phi_638_ = bool();
                        phi_639_ = bool();
                        phi_640_ = true;
                        phi_641_ = false;
                    }
                    let _e512 = phi_635_;
                    let _e514 = phi_636_;
                    let _e516 = phi_637_;
                    let _e518 = phi_638_;
                    let _e520 = phi_639_;
                    let _e522 = phi_640_;
                    let _e524 = phi_641_;
                    phi_642_ = _e512;
                    phi_643_ = _e514;
                    phi_644_ = _e516;
                    phi_645_ = _e518;
                    phi_646_ = _e520;
                    phi_647_ = _e522;
                    phi_648_ = _e524;
                } else {
                    phi_642_ = bool();
                    phi_643_ = bool();
                    phi_644_ = vec2<u32>();
                    phi_645_ = bool();
                    phi_646_ = bool();
                    phi_647_ = true;
                    phi_648_ = false;
                }
                let _e526 = phi_642_;
                let _e528 = phi_643_;
                let _e530 = phi_644_;
                let _e532 = phi_645_;
                let _e534 = phi_646_;
                let _e536 = phi_647_;
                let _e538 = phi_648_;
                if _e536 {
                    if (_e405 == 0f) {
                        phi_657_ = (_e406 == 0f);
                    } else {
                        phi_657_ = false;
                    }
                    let _e542 = phi_657_;
                    phi_658_ = _e542;
                    phi_659_ = false;
                    phi_660_ = true;
                } else {
                    phi_658_ = _e532;
                    phi_659_ = _e534;
                    phi_660_ = _e538;
                }
                let _e544 = phi_658_;
                let _e546 = phi_659_;
                let _e548 = phi_660_;
                if _e548 {
                    phi_664_ = _e544;
                    phi_665_ = _e546;
                    phi_666_ = vec2<u32>(_e48.x, _e48.y);
                } else {
                    phi_664_ = _e526;
                    phi_665_ = _e528;
                    phi_666_ = _e530;
                }
                let _e550 = phi_664_;
                let _e552 = phi_665_;
                let _e554 = phi_666_;
                let _e564 = lt_mask_Reprojection(vec2<u32>(_e554.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e571 = lt_mask_Reprojection(vec2<u32>(_e564.pixel.x, _e554.y), _e564.is_valid, _e564.has_moved);
                let _e575 = lt_mask_Reprojection(_e571.pixel, _e552, _e571.has_moved);
                let _e579 = lt_mask_Reprojection(_e575.pixel, _e575.is_valid, !(_e550));
                if _e552 {
                    let _e582 = p.member.previous.eye;
                    let _e590 = p.member.previous.forward;
                    let _e599 = (((((_e84.x - _e582.x) * _e590.x) + ((_e84.y - _e582.y) * _e590.y)) + ((_e84.z - _e582.z) * _e590.z)) > 0f);
                    let _e603 = lt_mask_Reprojection(_e579.pixel, _e599, _e579.has_moved);
                    if _e599 {
                        phi_701_ = false;
                    } else {
                        phi_701_ = true;
                    }
                    let _e605 = phi_701_;
                    phi_703_ = _e603;
                    phi_704_ = _e603;
                    phi_705_ = _e605;
                } else {
                    phi_703_ = lt_mask_Reprojection();
                    phi_704_ = lt_mask_Reprojection(_e579.pixel, false, _e579.has_moved);
                    phi_705_ = true;
                }
                let _e611 = phi_703_;
                let _e613 = phi_704_;
                let _e615 = phi_705_;
                if _e615 {
                    phi_709_ = false;
                } else {
                    phi_709_ = true;
                }
                let _e617 = phi_709_;
                phi_710_ = _e611;
                phi_711_ = _e613;
                phi_712_ = _e617;
            }
            let _e619 = phi_710_;
            let _e621 = phi_711_;
            let _e623 = phi_712_;
            if _e623 {
                let _e625 = p.member.flags;
                phi_720_ = ((_e625 & 1u) != 0u);
                phi_721_ = _e619;
            } else {
                phi_720_ = false;
                phi_721_ = _e621;
            }
            let _e629 = phi_720_;
            let _e631 = phi_721_;
            let _e635 = lt_mask_Reprojection(_e631.pixel, _e629, _e631.has_moved);
            let _e636 = lt_mask_Neighbourhood(false, true);
            if _e251 {
                phi_727_ = false;
            } else {
                phi_727_ = true;
            }
            let _e638 = phi_727_;
            if _e638 {
                if _e629 {
                    if ((0u & 2u) != 0u) {
                        phi_767_ = _e636;
                    } else {
                        let _e655 = ((((_e635.pixel.y * _e81) + (_e635.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e247) | (select(0u, 1u, _e635.has_moved) << bitcast<u32>(1i))));
                        if (_e655 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e659 = heard.member[(0u + _e655)];
                        let _e665 = (((_e659 >> bitcast<u32>(((_e635.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_767_ = lt_mask_Neighbourhood(_e665, !(_e665));
                    }
                    let _e669 = phi_767_;
                    phi_768_ = _e669;
                } else {
                    phi_768_ = _e636;
                }
                let _e671 = phi_768_;
                phi_769_ = _e671;
            } else {
                phi_769_ = _e636;
            }
            let _e673 = phi_769_;
            let _e676 = p.member.frame;
            let _e678 = p.member.refresh;
            if (_e678 == 0u) {
                phi_802_ = false;
            } else {
                if (_e678 == 0u) {
                    return;
                }
                let _e687 = ((_e48.x + (_e48.y * (((_e678 * 5u) / 8u) | 1u))) + (_e676 % _e678));
                if (_e678 == 0u) {
                    phi_801_ = (_e687 == 0u);
                } else {
                    if (_e678 == 0u) {
                        return;
                    }
                    phi_801_ = ((_e687 % _e678) == 0u);
                }
                let _e694 = phi_801_;
                phi_802_ = _e694;
            }
            let _e696 = phi_802_;
            if _e629 {
                if _e696 {
                    phi_824_ = bool();
                } else {
                    phi_824_ = ((0u & 2u) != 0u);
                }
                let _e702 = phi_824_;
                phi_825_ = _e702;
                phi_826_ = _e696;
            } else {
                phi_825_ = bool();
                phi_826_ = true;
            }
            let _e704 = phi_825_;
            let _e706 = phi_826_;
            if _e706 {
                phi_830_ = false;
            } else {
                phi_830_ = _e704;
            }
            let _e708 = phi_830_;
            if _e708 {
                phi_881_ = 7u;
            } else {
                if (_e89 != 0.5f) {
                    if _e629 {
                        if _e696 {
                            phi_878_ = 6u;
                        } else {
                            if _e251 {
                                phi_853_ = true;
                            } else {
                                if _e673.any_expands {
                                    phi_852_ = false;
                                } else {
                                    phi_852_ = true;
                                }
                                let _e710 = phi_852_;
                                phi_853_ = _e710;
                            }
                            let _e712 = phi_853_;
                            if _e712 {
                                if _e251 {
                                    if false {
                                        if _e673.all_remove {
                                            phi_866_ = false;
                                        } else {
                                            phi_866_ = true;
                                        }
                                        let _e714 = phi_866_;
                                        phi_867_ = _e714;
                                    } else {
                                        phi_867_ = true;
                                    }
                                    let _e716 = phi_867_;
                                    phi_868_ = _e716;
                                } else {
                                    phi_868_ = true;
                                }
                                let _e718 = phi_868_;
                                if _e718 {
                                    if _e251 {
                                        phi_875_ = 1u;
                                    } else {
                                        phi_875_ = 0u;
                                    }
                                    let _e720 = phi_875_;
                                    phi_876_ = _e720;
                                } else {
                                    phi_876_ = 5u;
                                }
                                let _e722 = phi_876_;
                                phi_877_ = _e722;
                            } else {
                                phi_877_ = 4u;
                            }
                            let _e724 = phi_877_;
                            phi_878_ = _e724;
                        }
                        let _e726 = phi_878_;
                        phi_879_ = _e726;
                    } else {
                        phi_879_ = 3u;
                    }
                    let _e728 = phi_879_;
                    phi_880_ = _e728;
                } else {
                    phi_880_ = 2u;
                }
                let _e730 = phi_880_;
                phi_881_ = _e730;
            }
            let _e732 = phi_881_;
            if !((_e732 == 0u)) {
                if !((_e732 == 5u)) {
                    phi_893_ = !(_e708);
                    phi_894_ = false;
                } else {
                    phi_893_ = bool();
                    phi_894_ = true;
                }
                let _e739 = phi_893_;
                let _e741 = phi_894_;
                phi_895_ = _e739;
                phi_896_ = _e741;
            } else {
                phi_895_ = bool();
                phi_896_ = true;
            }
            let _e743 = phi_895_;
            let _e745 = phi_896_;
            if _e745 {
                phi_900_ = false;
            } else {
                phi_900_ = _e743;
            }
            let _e747 = phi_900_;
            if _e708 {
                phi_906_ = ((0u & 4u) != 0u);
            } else {
                phi_906_ = _e247;
            }
            let _e751 = phi_906_;
            if _e747 {
                if _e247 {
                    phi_914_ = (2u | 1u);
                } else {
                    phi_914_ = 2u;
                }
                let _e754 = phi_914_;
                if false {
                    phi_919_ = (_e754 | 4u);
                } else {
                    phi_919_ = _e754;
                }
                let _e757 = phi_919_;
                phi_939_ = _e757;
            } else {
                if (_e732 == 7u) {
                    if _e247 {
                        phi_928_ = (2u | 1u);
                    } else {
                        phi_928_ = 2u;
                    }
                    let _e761 = phi_928_;
                    if _e751 {
                        phi_933_ = (_e761 | 4u);
                    } else {
                        phi_933_ = _e761;
                    }
                    let _e764 = phi_933_;
                    phi_938_ = _e764;
                } else {
                    if _e247 {
                        phi_937_ = 1u;
                    } else {
                        phi_937_ = 0u;
                    }
                    let _e766 = phi_937_;
                    phi_938_ = _e766;
                }
                let _e768 = phi_938_;
                phi_939_ = _e768;
            }
            let _e770 = phi_939_;
            if _e751 {
                phi_943_ = 0f;
            } else {
                phi_943_ = 1f;
            }
            let _e772 = phi_943_;
            phi_945_ = mask_Masked(_e772, _e770, _e747);
        }
        let _e775 = phi_945_;
        visibility.member[_e65.first_primitive] = _e775.visibility;
        let _e780 = p.member.light.number;
        let _e781 = (_e780 * 3u);
        let _e783 = (_e781 % 32u);
        let _e785 = p.member.light.mask_words;
        let _e787 = ((_e65.first_primitive * _e785) + (_e781 / 32u));
        let _e789 = bits.member[_e787];
        bits.member[_e787] = ((_e789 & ~((7u << bitcast<u32>((_e783 & 31u))))) | (_e775.bits << bitcast<u32>((_e783 & 31u))));
        if (_e783 > 29u) {
            let _e804 = bits.member[(_e787 + 1u)];
            let _e806 = (32u - _e783);
            bits.member[(_e787 + 1u)] = ((_e804 & ~((7u >> bitcast<u32>((_e806 & 31u))))) | (_e775.bits >> bitcast<u32>((_e806 & 31u))));
        }
        phi_995_ = _e775.needs_ray;
        phi_996_ = _e65.first_primitive;
    } else {
        phi_995_ = false;
        phi_996_ = 0u;
    }
    let _e820 = phi_995_;
    let _e822 = phi_996_;
    if (_e49 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e820 {
        let _e826 = atomicAdd((&shared_[0u]), 1u);
        phi_1007_ = _e826;
    } else {
        phi_1007_ = 0u;
    }
    let _e828 = phi_1007_;
    workgroupBarrier();
    if (_e49 == 0u) {
        let _e832 = atomicLoad((&shared_[0u]));
        let _e833 = atomicAdd((&list.member[3u]), _e832);
        atomicStore((&shared_[1u]), _e833);
    }
    workgroupBarrier();
    if _e820 {
        let _e836 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e836) + _e828)]), _e822);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
