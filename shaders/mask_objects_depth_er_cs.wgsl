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
    var phi_171_: lt_bvh_traverse_Tree;
    var phi_172_: bool;
    var phi_173_: lt_bvh_traverse_Tree;
    var phi_174_: bool;
    var phi_179_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_171_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_172_ = false;
        } else {
            phi_171_ = lt_bvh_traverse_Tree();
            phi_172_ = true;
        }
        let _e66 = phi_171_;
        let _e68 = phi_172_;
        phi_173_ = _e66;
        phi_174_ = _e68;
    } else {
        phi_173_ = lt_bvh_traverse_Tree();
        phi_174_ = true;
    }
    let _e70 = phi_173_;
    let _e72 = phi_174_;
    if _e72 {
        phi_179_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_179_ = _e70;
    }
    let _e77 = phi_179_;
    return lt_bvh_traverse_Tree(_e77.root, _e77.first_primitive);
}

fn function_() {
    var phi_251_: bool;
    var phi_252_: bool;
    var phi_253_: bool;
    var phi_254_: bool;
    var phi_258_: bool;
    var phi_328_: bool;
    var phi_329_: bool;
    var phi_340_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_341_: bool;
    var phi_342_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_343_: bool;
    var phi_350_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_354_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_367_: bool;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_402_: bool;
    var phi_403_: bool;
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
    var phi_771_: bool;
    var phi_773_: lt_mask_Reprojection;
    var phi_774_: lt_mask_Reprojection;
    var phi_775_: lt_mask_Reprojection;
    var phi_776_: bool;
    var phi_777_: bool;
    var phi_778_: lt_mask_Reprojection;
    var phi_779_: lt_mask_Reprojection;
    var phi_780_: lt_mask_Reprojection;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_834_: bool;
    var phi_838_: f32;
    var phi_842_: lt_mask_Reprojection;
    var phi_843_: bool;
    var phi_855_: bool;
    var phi_856_: bool;
    var phi_857_: bool;
    var phi_858_: lt_mask_Reprojection;
    var phi_859_: bool;
    var phi_863_: bool;
    var phi_864_: lt_mask_Reprojection;
    var phi_870_: bool;
    var phi_902_: u32;
    var phi_931_: lt_mask_Neighbourhood;
    var phi_932_: lt_mask_Neighbourhood;
    var phi_933_: lt_mask_Neighbourhood;
    var phi_965_: bool;
    var phi_966_: bool;
    var phi_988_: bool;
    var phi_989_: bool;
    var phi_990_: bool;
    var phi_994_: bool;
    var phi_1016_: bool;
    var phi_1017_: bool;
    var phi_1030_: bool;
    var phi_1031_: bool;
    var phi_1032_: bool;
    var phi_1039_: u32;
    var phi_1040_: u32;
    var phi_1041_: u32;
    var phi_1042_: u32;
    var phi_1043_: u32;
    var phi_1044_: u32;
    var phi_1045_: u32;
    var phi_1057_: bool;
    var phi_1058_: bool;
    var phi_1059_: bool;
    var phi_1060_: bool;
    var phi_1064_: bool;
    var phi_1070_: bool;
    var phi_1078_: u32;
    var phi_1083_: u32;
    var phi_1092_: u32;
    var phi_1097_: u32;
    var phi_1101_: u32;
    var phi_1102_: u32;
    var phi_1103_: u32;
    var phi_1107_: f32;
    var phi_1109_: mask_Masked;
    var phi_1181_: bool;
    var phi_1182_: bool;
    var phi_1183_: bool;
    var phi_1184_: bool;
    var phi_1188_: bool;
    var phi_1216_: f32;
    var phi_1219_: bool;
    var phi_1220_: u32;
    var phi_1231_: u32;

    let _e53 = id_1;
    let _e54 = local_1;
    let _e71 = p.member.current.size[0u];
    let _e73 = p.member.current.size[1u];
    let _e74 = lt_shaders_entry_pixel_index(_e53, _e71, _e73);
    if (bitcast<i32>(_e74.root) != 0i) {
        let _e82 = p.member.current.size[0u];
        let _e85 = past.member[_e74.first_primitive];
        let _e90 = visibility.member[_e74.first_primitive];
        let _e96 = samples.member[_e74.first_primitive].normal[0u];
        let _e98 = global[0u];
        if (_e96 == _e98) {
            let _e101 = samples.member[_e74.first_primitive].normal[1u];
            let _e103 = global[1u];
            if (_e101 == _e103) {
                let _e106 = samples.member[_e74.first_primitive].normal[2u];
                let _e108 = global[2u];
                phi_251_ = (_e106 == _e108);
                phi_252_ = false;
            } else {
                phi_251_ = bool();
                phi_252_ = true;
            }
            let _e111 = phi_251_;
            let _e113 = phi_252_;
            phi_253_ = _e111;
            phi_254_ = _e113;
        } else {
            phi_253_ = bool();
            phi_254_ = true;
        }
        let _e115 = phi_253_;
        let _e117 = phi_254_;
        if _e117 {
            phi_258_ = false;
        } else {
            phi_258_ = _e115;
        }
        let _e119 = phi_258_;
        if !(_e119) {
            let _e122 = samples.member[_e74.first_primitive].position;
            let _e124 = p.member.light.place;
            let _e130 = p.member.light.place[3u];
            let _e137 = (_e124.x - (_e122.x * _e130));
            let _e138 = (_e124.y - (_e122.y * _e130));
            let _e139 = (_e124.z - (_e122.z * _e130));
            let _e141 = samples.member[_e74.first_primitive].normal;
            if ((((_e141.x * _e137) + (_e141.y * _e138)) + (_e141.z * _e139)) > 0f) {
                let _e155 = (((_e137 * _e137) + (_e138 * _e138)) + (_e139 * _e139));
                let _e157 = p.member.light.axis;
                let _e169 = p.member.light.place[3u];
                if (_e169 == 0f) {
                    phi_329_ = true;
                } else {
                    let _e172 = p.member.light.range_squared;
                    if (_e155 <= _e172) {
                        let _e175 = p.member.light.cos_outer;
                        phi_328_ = (-((((_e137 * _e157.x) + (_e138 * _e157.y)) + (_e139 * _e157.z))) >= (_e175 * sqrt(_e155)));
                    } else {
                        phi_328_ = false;
                    }
                    let _e180 = phi_328_;
                    phi_329_ = _e180;
                }
                let _e182 = phi_329_;
                if _e182 {
                    let _e184 = samples.member[_e74.first_primitive].flags;
                    let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e198 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e192.unnamed.visibility, false), _e192.unnamed_1);
                    phi_340_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e198.unnamed, ((_e184 & 1u) == 0u));
                    phi_341_ = false;
                } else {
                    phi_340_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_341_ = true;
                }
                let _e203 = phi_340_;
                let _e205 = phi_341_;
                phi_342_ = _e203;
                phi_343_ = _e205;
            } else {
                phi_342_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_343_ = true;
            }
            let _e207 = phi_342_;
            let _e209 = phi_343_;
            if _e209 {
                let _e215 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e215.unnamed.visibility, false), _e215.unnamed_1);
                phi_350_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e221.unnamed, true);
            } else {
                phi_350_ = _e207;
            }
            let _e226 = phi_350_;
            phi_354_ = _e226;
        } else {
            let _e232 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e238 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e232.unnamed.visibility, false), _e232.unnamed_1);
            phi_354_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e238.unnamed, true);
        }
        let _e243 = phi_354_;
        if _e243.unnamed_1 {
            phi_1109_ = mask_Masked(_e243.unnamed.visibility, 0u, false);
        } else {
            let _e248 = (_e90 < 0.5f);
            if (_e90 > 0f) {
                phi_367_ = (_e90 < 1f);
            } else {
                phi_367_ = false;
            }
            let _e252 = phi_367_;
            let _e259 = lt_mask_Reprojection(vec2<u32>(_e53.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e266 = lt_mask_Reprojection(vec2<u32>(_e259.pixel.x, _e53.y), _e259.is_valid, _e259.has_moved);
            let _e270 = lt_mask_Reprojection(_e266.pixel, true, _e266.has_moved);
            let _e276 = p.member.flags;
            if ((_e276 & 16u) == 0u) {
                phi_403_ = false;
            } else {
                let _e281 = samples.member[_e74.first_primitive].position[0u];
                if (_e85.x == _e281) {
                    let _e284 = samples.member[_e74.first_primitive].position[1u];
                    if (_e85.y == _e284) {
                        let _e287 = samples.member[_e74.first_primitive].position[2u];
                        phi_395_ = (_e85.z == _e287);
                        phi_396_ = false;
                    } else {
                        phi_395_ = bool();
                        phi_396_ = true;
                    }
                    let _e290 = phi_395_;
                    let _e292 = phi_396_;
                    phi_397_ = _e290;
                    phi_398_ = _e292;
                } else {
                    phi_397_ = bool();
                    phi_398_ = true;
                }
                let _e294 = phi_397_;
                let _e296 = phi_398_;
                if _e296 {
                    phi_402_ = false;
                } else {
                    phi_402_ = _e294;
                }
                let _e298 = phi_402_;
                phi_403_ = _e298;
            }
            let _e300 = phi_403_;
            if _e300 {
                phi_778_ = lt_mask_Reprojection(_e270.pixel, _e270.is_valid, false);
                phi_779_ = lt_mask_Reprojection();
                phi_780_ = lt_mask_Reprojection();
                phi_781_ = true;
                phi_782_ = false;
            } else {
                let _e302 = samples.member[_e74.first_primitive].position;
                let _e306 = p.member.previous.eye;
                let _e308 = (_e85.x - _e306.x);
                let _e310 = (_e85.y - _e306.y);
                let _e312 = (_e85.z - _e306.z);
                let _e314 = p.member.previous.forward;
                let _e322 = (((_e308 * _e314.x) + (_e310 * _e314.y)) + (_e312 * _e314.z));
                let _e324 = p.member.previous.right;
                let _e334 = p.member.previous.right;
                let _e349 = p.member.previous.up;
                let _e359 = p.member.previous.up;
                let _e374 = p.member.current.eye;
                let _e377 = (_e302.x - _e374.x);
                let _e380 = (_e302.y - _e374.y);
                let _e383 = (_e302.z - _e374.z);
                let _e385 = p.member.current.forward;
                let _e393 = (((_e377 * _e385.x) + (_e380 * _e385.y)) + (_e383 * _e385.z));
                let _e395 = p.member.current.right;
                let _e405 = p.member.current.right;
                let _e420 = p.member.current.up;
                let _e430 = p.member.current.up;
                let _e449 = p.member.current.size[0u];
                let _e451 = (((((((_e308 * _e324.x) + (_e310 * _e324.y)) + (_e312 * _e324.z)) / ((((_e334.x * _e334.x) + (_e334.y * _e334.y)) + (_e334.z * _e334.z)) * _e322)) - ((((_e377 * _e395.x) + (_e380 * _e395.y)) + (_e383 * _e395.z)) / ((((_e405.x * _e405.x) + (_e405.y * _e405.y)) + (_e405.z * _e405.z)) * _e393))) * 0.5f) * f32(_e449));
                let _e455 = p.member.current.size[1u];
                let _e457 = (((((((_e308 * _e349.x) + (_e310 * _e349.y)) + (_e312 * _e349.z)) / ((((_e359.x * _e359.x) + (_e359.y * _e359.y)) + (_e359.z * _e359.z)) * _e322)) - ((((_e377 * _e420.x) + (_e380 * _e420.y)) + (_e383 * _e420.z)) / ((((_e430.x * _e430.x) + (_e430.y * _e430.y)) + (_e430.z * _e430.z)) * _e393))) * -0.5f) * f32(_e455));
                let _e461 = p.member.current.grid[0u];
                let _e463 = p.member.current.grid[1u];
                let _e483 = p.member.current.size[0u];
                let _e485 = p.member.current.size[1u];
                let _e487 = ((f32(_e53.x) + ((f32((_e53.y & (_e463 - 1u))) + 0.5f) / f32(_e463))) + _e451);
                if (_e487 > -8388608f) {
                    let _e499 = f32(select(0i, select(select(i32(_e487), i32(-2147483648), (_e487 < bitcast<f32>(3472883712u))), 2147483647i, (_e487 > bitcast<f32>(1325400063u))), (_e487 == _e487)));
                    if (_e499 > _e487) {
                        phi_611_ = 1f;
                    } else {
                        phi_611_ = 0f;
                    }
                    let _e502 = phi_611_;
                    if (_e487 < 8388608f) {
                        phi_616_ = (_e499 - _e502);
                        phi_617_ = false;
                    } else {
                        phi_616_ = f32();
                        phi_617_ = true;
                    }
                    let _e505 = phi_616_;
                    let _e507 = phi_617_;
                    phi_618_ = _e505;
                    phi_619_ = _e507;
                } else {
                    phi_618_ = f32();
                    phi_619_ = true;
                }
                let _e509 = phi_618_;
                let _e511 = phi_619_;
                if _e511 {
                    phi_623_ = _e487;
                } else {
                    phi_623_ = _e509;
                }
                let _e513 = phi_623_;
                let _e514 = ((f32(_e53.y) + ((f32((_e53.x & (_e461 - 1u))) + 0.5f) / f32(_e461))) + _e457);
                if (_e514 > -8388608f) {
                    let _e526 = f32(select(0i, select(select(i32(_e514), i32(-2147483648), (_e514 < bitcast<f32>(3472883712u))), 2147483647i, (_e514 > bitcast<f32>(1325400063u))), (_e514 == _e514)));
                    if (_e526 > _e514) {
                        phi_644_ = 1f;
                    } else {
                        phi_644_ = 0f;
                    }
                    let _e529 = phi_644_;
                    if (_e514 < 8388608f) {
                        phi_649_ = (_e526 - _e529);
                        phi_650_ = false;
                    } else {
                        phi_649_ = f32();
                        phi_650_ = true;
                    }
                    let _e532 = phi_649_;
                    let _e534 = phi_650_;
                    phi_651_ = _e532;
                    phi_652_ = _e534;
                } else {
                    phi_651_ = f32();
                    phi_652_ = true;
                }
                let _e536 = phi_651_;
                let _e538 = phi_652_;
                if _e538 {
                    phi_656_ = _e514;
                } else {
                    phi_656_ = _e536;
                }
                let _e540 = phi_656_;
                if (_e513 >= 0f) {
                    if (_e540 >= 0f) {
                        if (_e513 < f32(_e483)) {
                            let _e546 = (_e540 < f32(_e485));
                            if (_e451 == 0f) {
                                phi_677_ = (_e457 == 0f);
                            } else {
                                phi_677_ = false;
                            }
                            let _e550 = phi_677_;
                            if _e546 {
                                phi_696_ = vec2<u32>(select(select(u32(_e513), 0u, (_e513 < bitcast<f32>(0u))), 4294967295u, (_e513 > bitcast<f32>(1333788671u))), select(select(u32(_e540), 0u, (_e540 < bitcast<f32>(0u))), 4294967295u, (_e540 > bitcast<f32>(1333788671u))));
                                phi_697_ = false;
                            } else {
                                phi_696_ = vec2<u32>();
                                phi_697_ = true;
                            }
                            let _e567 = phi_696_;
                            let _e569 = phi_697_;
                            phi_698_ = _e550;
                            phi_699_ = _e546;
                            phi_700_ = _e567;
                            phi_701_ = _e550;
                            phi_702_ = _e546;
                            phi_703_ = false;
                            phi_704_ = _e569;
                        } else {
                            phi_698_ = bool();
                            phi_699_ = bool();
                            phi_700_ = vec2<u32>();
                            phi_701_ = bool();
                            phi_702_ = bool();
                            phi_703_ = true;
                            phi_704_ = false;
                        }
                        let _e571 = phi_698_;
                        let _e573 = phi_699_;
                        let _e575 = phi_700_;
                        let _e577 = phi_701_;
                        let _e579 = phi_702_;
                        let _e581 = phi_703_;
                        let _e583 = phi_704_;
                        phi_705_ = _e571;
                        phi_706_ = _e573;
                        phi_707_ = _e575;
                        phi_708_ = _e577;
                        phi_709_ = _e579;
                        phi_710_ = _e581;
                        phi_711_ = _e583;
                    } else {
                        phi_705_ = bool();
                        phi_706_ = bool();
                        phi_707_ = vec2<u32>();
                        phi_708_ = bool();
                        phi_709_ = bool();
                        phi_710_ = true;
                        phi_711_ = false;
                    }
                    let _e585 = phi_705_;
                    let _e587 = phi_706_;
                    let _e589 = phi_707_;
                    let _e591 = phi_708_;
                    let _e593 = phi_709_;
                    let _e595 = phi_710_;
                    let _e597 = phi_711_;
                    phi_712_ = _e585;
                    phi_713_ = _e587;
                    phi_714_ = _e589;
                    phi_715_ = _e591;
                    phi_716_ = _e593;
                    phi_717_ = _e595;
                    phi_718_ = _e597;
                } else {
                    phi_712_ = bool();
                    phi_713_ = bool();
                    phi_714_ = vec2<u32>();
                    phi_715_ = bool();
                    phi_716_ = bool();
                    phi_717_ = true;
                    phi_718_ = false;
                }
                let _e599 = phi_712_;
                let _e601 = phi_713_;
                let _e603 = phi_714_;
                let _e605 = phi_715_;
                let _e607 = phi_716_;
                let _e609 = phi_717_;
                let _e611 = phi_718_;
                if _e609 {
                    if (_e451 == 0f) {
                        phi_727_ = (_e457 == 0f);
                    } else {
                        phi_727_ = false;
                    }
                    let _e615 = phi_727_;
                    phi_728_ = _e615;
                    phi_729_ = false;
                    phi_730_ = true;
                } else {
                    phi_728_ = _e605;
                    phi_729_ = _e607;
                    phi_730_ = _e611;
                }
                let _e617 = phi_728_;
                let _e619 = phi_729_;
                let _e621 = phi_730_;
                if _e621 {
                    phi_734_ = _e617;
                    phi_735_ = _e619;
                    phi_736_ = vec2<u32>(_e53.x, _e53.y);
                } else {
                    phi_734_ = _e599;
                    phi_735_ = _e601;
                    phi_736_ = _e603;
                }
                let _e623 = phi_734_;
                let _e625 = phi_735_;
                let _e627 = phi_736_;
                let _e637 = lt_mask_Reprojection(vec2<u32>(_e627.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e644 = lt_mask_Reprojection(vec2<u32>(_e637.pixel.x, _e627.y), _e637.is_valid, _e637.has_moved);
                let _e648 = lt_mask_Reprojection(_e644.pixel, _e625, _e644.has_moved);
                let _e652 = lt_mask_Reprojection(_e648.pixel, _e648.is_valid, !(_e623));
                if _e625 {
                    let _e655 = p.member.previous.eye;
                    let _e663 = p.member.previous.forward;
                    let _e672 = (((((_e85.x - _e655.x) * _e663.x) + ((_e85.y - _e655.y) * _e663.y)) + ((_e85.z - _e655.z) * _e663.z)) > 0f);
                    let _e676 = lt_mask_Reprojection(_e652.pixel, _e672, _e652.has_moved);
                    if _e672 {
                        phi_771_ = false;
                    } else {
                        phi_771_ = true;
                    }
                    let _e678 = phi_771_;
                    phi_773_ = _e676;
                    phi_774_ = _e676;
                    phi_775_ = lt_mask_Reprojection();
                    phi_776_ = _e672;
                    phi_777_ = _e678;
                } else {
                    phi_773_ = lt_mask_Reprojection();
                    phi_774_ = lt_mask_Reprojection();
                    phi_775_ = lt_mask_Reprojection(_e652.pixel, false, _e652.has_moved);
                    phi_776_ = false;
                    phi_777_ = false;
                }
                let _e684 = phi_773_;
                let _e686 = phi_774_;
                let _e688 = phi_775_;
                let _e690 = phi_776_;
                let _e692 = phi_777_;
                phi_778_ = _e684;
                phi_779_ = _e686;
                phi_780_ = _e688;
                phi_781_ = _e690;
                phi_782_ = _e692;
            }
            let _e694 = phi_778_;
            let _e696 = phi_779_;
            let _e698 = phi_780_;
            let _e700 = phi_781_;
            let _e702 = phi_782_;
            if _e700 {
                let _e705 = p.member.previous.eye;
                let _e713 = p.member.previous.forward;
                let _e721 = ((((_e85.x - _e705.x) * _e713.x) + ((_e85.y - _e705.y) * _e713.y)) + ((_e85.z - _e705.z) * _e713.z));
                let _e727 = ((_e694.pixel.y * _e82) + _e694.pixel.x);
                if (_e727 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e731 = last_depths.member[(0u + _e727)];
                let _e733 = p.member.depth_tolerance;
                let _e736 = abs(_e721);
                let _e737 = abs(_e731);
                if ((bitcast<u32>(_e737) & 2147483647u) > 2139095040u) {
                    phi_834_ = true;
                } else {
                    let _e741 = (_e737 > _e736);
                    if _e741 {
                    }
                    phi_834_ = _e741;
                }
                let _e743 = phi_834_;
                if _e743 {
                    phi_838_ = _e737;
                } else {
                    phi_838_ = _e736;
                }
                let _e745 = phi_838_;
                phi_842_ = lt_mask_Reprojection(_e694.pixel, (abs((_e721 - _e731)) <= (_e733 * _e745)), _e694.has_moved);
                phi_843_ = true;
            } else {
                phi_842_ = _e696;
                phi_843_ = _e702;
            }
            let _e753 = phi_842_;
            let _e755 = phi_843_;
            if _e755 {
                if _e753.is_valid {
                    let _e758 = p.member.flags;
                    phi_855_ = ((_e758 & 1u) != 0u);
                    phi_856_ = false;
                } else {
                    phi_855_ = bool();
                    phi_856_ = true;
                }
                let _e762 = phi_855_;
                let _e764 = phi_856_;
                phi_857_ = _e762;
                phi_858_ = _e753;
                phi_859_ = _e764;
            } else {
                phi_857_ = bool();
                phi_858_ = _e698;
                phi_859_ = true;
            }
            let _e766 = phi_857_;
            let _e768 = phi_858_;
            let _e770 = phi_859_;
            if _e770 {
                phi_863_ = false;
                phi_864_ = _e768;
            } else {
                phi_863_ = _e766;
                phi_864_ = _e753;
            }
            let _e772 = phi_863_;
            let _e774 = phi_864_;
            let _e778 = lt_mask_Reprojection(_e774.pixel, _e772, _e774.has_moved);
            let _e779 = lt_mask_Neighbourhood(false, true);
            if _e252 {
                phi_870_ = false;
            } else {
                phi_870_ = true;
            }
            let _e781 = phi_870_;
            if _e781 {
                if _e772 {
                    if ((0u & 2u) != 0u) {
                        phi_931_ = _e779;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e790 = (_e82 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e82 % 32u) > 0u) {
                            phi_902_ = (_e790 + 1u);
                        } else {
                            phi_902_ = _e790;
                        }
                        let _e796 = phi_902_;
                        let _e806 = ((((_e778.pixel.y * _e796) + (_e778.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e248) | (select(0u, 1u, _e778.has_moved) << bitcast<u32>(1i))));
                        if (_e806 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e810 = heard.member[(0u + _e806)];
                        let _e816 = (((_e810 >> bitcast<u32>(((_e778.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_931_ = lt_mask_Neighbourhood(_e816, !(_e816));
                    }
                    let _e820 = phi_931_;
                    phi_932_ = _e820;
                } else {
                    phi_932_ = _e779;
                }
                let _e822 = phi_932_;
                phi_933_ = _e822;
            } else {
                phi_933_ = _e779;
            }
            let _e824 = phi_933_;
            let _e827 = p.member.frame;
            let _e829 = p.member.refresh;
            if (_e829 == 0u) {
                phi_966_ = false;
            } else {
                if (_e829 == 0u) {
                    return;
                }
                let _e838 = ((_e53.x + (_e53.y * (((_e829 * 5u) / 8u) | 1u))) + (_e827 % _e829));
                if (_e829 == 0u) {
                    phi_965_ = (_e838 == 0u);
                } else {
                    if (_e829 == 0u) {
                        return;
                    }
                    phi_965_ = ((_e838 % _e829) == 0u);
                }
                let _e845 = phi_965_;
                phi_966_ = _e845;
            }
            let _e847 = phi_966_;
            if _e772 {
                if _e847 {
                    phi_988_ = bool();
                } else {
                    phi_988_ = ((0u & 2u) != 0u);
                }
                let _e853 = phi_988_;
                phi_989_ = _e853;
                phi_990_ = _e847;
            } else {
                phi_989_ = bool();
                phi_990_ = true;
            }
            let _e855 = phi_989_;
            let _e857 = phi_990_;
            if _e857 {
                phi_994_ = false;
            } else {
                phi_994_ = _e855;
            }
            let _e859 = phi_994_;
            if _e859 {
                phi_1045_ = 7u;
            } else {
                if (_e90 != 0.5f) {
                    if _e772 {
                        if _e847 {
                            phi_1042_ = 6u;
                        } else {
                            if _e252 {
                                phi_1017_ = true;
                            } else {
                                if _e824.any_expands {
                                    phi_1016_ = false;
                                } else {
                                    phi_1016_ = true;
                                }
                                let _e861 = phi_1016_;
                                phi_1017_ = _e861;
                            }
                            let _e863 = phi_1017_;
                            if _e863 {
                                if _e252 {
                                    if false {
                                        if _e824.all_remove {
                                            phi_1030_ = false;
                                        } else {
                                            phi_1030_ = true;
                                        }
                                        let _e865 = phi_1030_;
                                        phi_1031_ = _e865;
                                    } else {
                                        phi_1031_ = true;
                                    }
                                    let _e867 = phi_1031_;
                                    phi_1032_ = _e867;
                                } else {
                                    phi_1032_ = true;
                                }
                                let _e869 = phi_1032_;
                                if _e869 {
                                    if _e252 {
                                        phi_1039_ = 1u;
                                    } else {
                                        phi_1039_ = 0u;
                                    }
                                    let _e871 = phi_1039_;
                                    phi_1040_ = _e871;
                                } else {
                                    phi_1040_ = 5u;
                                }
                                let _e873 = phi_1040_;
                                phi_1041_ = _e873;
                            } else {
                                phi_1041_ = 4u;
                            }
                            let _e875 = phi_1041_;
                            phi_1042_ = _e875;
                        }
                        let _e877 = phi_1042_;
                        phi_1043_ = _e877;
                    } else {
                        phi_1043_ = 3u;
                    }
                    let _e879 = phi_1043_;
                    phi_1044_ = _e879;
                } else {
                    phi_1044_ = 2u;
                }
                let _e881 = phi_1044_;
                phi_1045_ = _e881;
            }
            let _e883 = phi_1045_;
            if !((_e883 == 0u)) {
                if !((_e883 == 5u)) {
                    phi_1057_ = !(_e859);
                    phi_1058_ = false;
                } else {
                    phi_1057_ = bool();
                    phi_1058_ = true;
                }
                let _e890 = phi_1057_;
                let _e892 = phi_1058_;
                phi_1059_ = _e890;
                phi_1060_ = _e892;
            } else {
                phi_1059_ = bool();
                phi_1060_ = true;
            }
            let _e894 = phi_1059_;
            let _e896 = phi_1060_;
            if _e896 {
                phi_1064_ = false;
            } else {
                phi_1064_ = _e894;
            }
            let _e898 = phi_1064_;
            if _e859 {
                phi_1070_ = ((0u & 4u) != 0u);
            } else {
                phi_1070_ = _e248;
            }
            let _e902 = phi_1070_;
            if _e898 {
                if _e248 {
                    phi_1078_ = (2u | 1u);
                } else {
                    phi_1078_ = 2u;
                }
                let _e905 = phi_1078_;
                if false {
                    phi_1083_ = (_e905 | 4u);
                } else {
                    phi_1083_ = _e905;
                }
                let _e908 = phi_1083_;
                phi_1103_ = _e908;
            } else {
                if (_e883 == 7u) {
                    if _e248 {
                        phi_1092_ = (2u | 1u);
                    } else {
                        phi_1092_ = 2u;
                    }
                    let _e912 = phi_1092_;
                    if _e902 {
                        phi_1097_ = (_e912 | 4u);
                    } else {
                        phi_1097_ = _e912;
                    }
                    let _e915 = phi_1097_;
                    phi_1102_ = _e915;
                } else {
                    if _e248 {
                        phi_1101_ = 1u;
                    } else {
                        phi_1101_ = 0u;
                    }
                    let _e917 = phi_1101_;
                    phi_1102_ = _e917;
                }
                let _e919 = phi_1102_;
                phi_1103_ = _e919;
            }
            let _e921 = phi_1103_;
            if _e902 {
                phi_1107_ = 0f;
            } else {
                phi_1107_ = 1f;
            }
            let _e923 = phi_1107_;
            phi_1109_ = mask_Masked(_e923, _e921, _e898);
        }
        let _e926 = phi_1109_;
        visibility.member[_e74.first_primitive] = _e926.visibility;
        let _e931 = p.member.light.number;
        let _e932 = (_e931 * 3u);
        let _e934 = (_e932 % 32u);
        let _e936 = p.member.light.mask_words;
        let _e938 = ((_e74.first_primitive * _e936) + (_e932 / 32u));
        let _e940 = bits.member[_e938];
        bits.member[_e938] = ((_e940 & ~((7u << bitcast<u32>((_e934 & 31u))))) | (_e926.bits << bitcast<u32>((_e934 & 31u))));
        if (_e934 > 29u) {
            let _e955 = bits.member[(_e938 + 1u)];
            let _e957 = (32u - _e934);
            bits.member[(_e938 + 1u)] = ((_e955 & ~((7u >> bitcast<u32>((_e957 & 31u))))) | (_e926.bits >> bitcast<u32>((_e957 & 31u))));
        }
        let _e972 = samples.member[_e74.first_primitive].normal[0u];
        let _e974 = global[0u];
        if (_e972 == _e974) {
            let _e977 = samples.member[_e74.first_primitive].normal[1u];
            let _e979 = global[1u];
            if (_e977 == _e979) {
                let _e982 = samples.member[_e74.first_primitive].normal[2u];
                let _e984 = global[2u];
                phi_1181_ = (_e982 == _e984);
                phi_1182_ = false;
            } else {
                phi_1181_ = bool();
                phi_1182_ = true;
            }
            let _e987 = phi_1181_;
            let _e989 = phi_1182_;
            phi_1183_ = _e987;
            phi_1184_ = _e989;
        } else {
            phi_1183_ = bool();
            phi_1184_ = true;
        }
        let _e991 = phi_1183_;
        let _e993 = phi_1184_;
        if _e993 {
            phi_1188_ = false;
        } else {
            phi_1188_ = _e991;
        }
        let _e995 = phi_1188_;
        if !(_e995) {
            let _e998 = samples.member[_e74.first_primitive].position;
            let _e1000 = p.member.current.eye;
            let _e1011 = p.member.current.forward;
            phi_1216_ = ((((_e998.x - _e1000.x) * _e1011.x) + ((_e998.y - _e1000.y) * _e1011.y)) + ((_e998.z - _e1000.z) * _e1011.z));
        } else {
            phi_1216_ = 0f;
        }
        let _e1021 = phi_1216_;
        depths.member[_e74.first_primitive] = _e1021;
        phi_1219_ = _e926.needs_ray;
        phi_1220_ = _e74.first_primitive;
    } else {
        phi_1219_ = false;
        phi_1220_ = 0u;
    }
    let _e1025 = phi_1219_;
    let _e1027 = phi_1220_;
    if (_e54 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1025 {
        let _e1031 = atomicAdd((&shared_[0u]), 1u);
        phi_1231_ = _e1031;
    } else {
        phi_1231_ = 0u;
    }
    let _e1033 = phi_1231_;
    workgroupBarrier();
    if (_e54 == 0u) {
        let _e1037 = atomicLoad((&shared_[0u]));
        let _e1038 = atomicAdd((&list.member[3u]), _e1037);
        atomicStore((&shared_[1u]), _e1038);
    }
    workgroupBarrier();
    if _e1025 {
        let _e1041 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1041) + _e1033)]), _e1027);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
