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
    var phi_539_: f32;
    var phi_544_: f32;
    var phi_545_: bool;
    var phi_546_: f32;
    var phi_547_: bool;
    var phi_551_: f32;
    var phi_572_: f32;
    var phi_577_: f32;
    var phi_578_: bool;
    var phi_579_: f32;
    var phi_580_: bool;
    var phi_584_: f32;
    var phi_605_: bool;
    var phi_624_: vec2<u32>;
    var phi_625_: bool;
    var phi_626_: bool;
    var phi_627_: bool;
    var phi_628_: vec2<u32>;
    var phi_629_: bool;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_632_: bool;
    var phi_633_: bool;
    var phi_634_: bool;
    var phi_635_: vec2<u32>;
    var phi_636_: bool;
    var phi_637_: bool;
    var phi_638_: bool;
    var phi_639_: bool;
    var phi_640_: bool;
    var phi_641_: bool;
    var phi_642_: vec2<u32>;
    var phi_643_: bool;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_655_: bool;
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_664_: vec2<u32>;
    var phi_699_: bool;
    var phi_701_: lt_mask_Reprojection;
    var phi_702_: lt_mask_Reprojection;
    var phi_703_: lt_mask_Reprojection;
    var phi_704_: bool;
    var phi_705_: bool;
    var phi_706_: lt_mask_Reprojection;
    var phi_707_: lt_mask_Reprojection;
    var phi_708_: lt_mask_Reprojection;
    var phi_709_: bool;
    var phi_710_: bool;
    var phi_762_: bool;
    var phi_766_: f32;
    var phi_770_: lt_mask_Reprojection;
    var phi_771_: bool;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_785_: bool;
    var phi_786_: lt_mask_Reprojection;
    var phi_787_: bool;
    var phi_791_: bool;
    var phi_792_: lt_mask_Reprojection;
    var phi_830_: u32;
    var phi_879_: u32;
    var phi_884_: u32;
    var phi_885_: u32;
    var phi_886_: u32;
    var phi_887_: bool;
    var phi_888_: u32;
    var phi_889_: bool;
    var phi_890_: bool;
    var phi_891_: u32;
    var phi_892_: bool;
    var phi_893_: bool;
    var phi_897_: bool;
    var phi_901_: u32;
    var phi_906_: bool;
    var phi_938_: u32;
    var phi_967_: lt_mask_Neighbourhood;
    var phi_968_: lt_mask_Neighbourhood;
    var phi_969_: lt_mask_Neighbourhood;
    var phi_1001_: bool;
    var phi_1002_: bool;
    var phi_1024_: bool;
    var phi_1025_: bool;
    var phi_1026_: bool;
    var phi_1030_: bool;
    var phi_1052_: bool;
    var phi_1053_: bool;
    var phi_1066_: bool;
    var phi_1067_: bool;
    var phi_1068_: bool;
    var phi_1075_: u32;
    var phi_1076_: u32;
    var phi_1077_: u32;
    var phi_1078_: u32;
    var phi_1079_: u32;
    var phi_1080_: u32;
    var phi_1081_: u32;
    var phi_1093_: bool;
    var phi_1094_: bool;
    var phi_1095_: bool;
    var phi_1096_: bool;
    var phi_1100_: bool;
    var phi_1106_: bool;
    var phi_1114_: u32;
    var phi_1119_: u32;
    var phi_1128_: u32;
    var phi_1133_: u32;
    var phi_1137_: u32;
    var phi_1138_: u32;
    var phi_1139_: u32;
    var phi_1143_: f32;
    var phi_1145_: mask_Masked;
    var phi_1217_: bool;
    var phi_1218_: bool;
    var phi_1219_: bool;
    var phi_1220_: bool;
    var phi_1224_: bool;
    var phi_1252_: f32;
    var phi_1255_: bool;
    var phi_1256_: u32;
    var phi_1267_: u32;

    let _e53 = id_1;
    let _e54 = local_1;
    let _e59 = arrayLength((&heard.member));
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
            phi_1145_ = mask_Masked(_e243.unnamed.visibility, 0u, false);
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
                phi_706_ = lt_mask_Reprojection(_e270.pixel, _e270.is_valid, false);
                phi_707_ = lt_mask_Reprojection();
                phi_708_ = lt_mask_Reprojection();
                phi_709_ = true;
                phi_710_ = false;
            } else {
                let _e304 = p.member.current.grid[0u];
                let _e306 = p.member.current.grid[1u];
                let _e320 = (f32(_e53.x) + ((f32((_e53.y & (_e306 - 1u))) + 0.5f) / f32(_e306)));
                let _e322 = (f32(_e53.y) + ((f32((_e53.x & (_e304 - 1u))) + 0.5f) / f32(_e304)));
                let _e325 = p.member.previous.eye;
                let _e327 = (_e85.x - _e325.x);
                let _e329 = (_e85.y - _e325.y);
                let _e331 = (_e85.z - _e325.z);
                let _e333 = p.member.previous.forward;
                let _e341 = (((_e327 * _e333.x) + (_e329 * _e333.y)) + (_e331 * _e333.z));
                let _e343 = p.member.previous.right;
                let _e353 = p.member.previous.right;
                let _e368 = p.member.previous.up;
                let _e378 = p.member.previous.up;
                let _e395 = p.member.previous.size[0u];
                let _e402 = p.member.previous.size[1u];
                let _e406 = (((((((_e327 * _e343.x) + (_e329 * _e343.y)) + (_e331 * _e343.z)) / ((((_e353.x * _e353.x) + (_e353.y * _e353.y)) + (_e353.z * _e353.z)) * _e341)) + 1f) * (0.5f * f32(_e395))) - _e320);
                let _e407 = (((1f - ((((_e327 * _e368.x) + (_e329 * _e368.y)) + (_e331 * _e368.z)) / ((((_e378.x * _e378.x) + (_e378.y * _e378.y)) + (_e378.z * _e378.z)) * _e341))) * (0.5f * f32(_e402))) - _e322);
                let _e411 = p.member.current.size[0u];
                let _e413 = p.member.current.size[1u];
                let _e415 = (_e320 + _e406);
                if (_e415 > -8388608f) {
                    let _e427 = f32(select(0i, select(select(i32(_e415), i32(-2147483648), (_e415 < bitcast<f32>(3472883712u))), 2147483647i, (_e415 > bitcast<f32>(1325400063u))), (_e415 == _e415)));
                    if (_e427 > _e415) {
                        phi_539_ = 1f;
                    } else {
                        phi_539_ = 0f;
                    }
                    let _e430 = phi_539_;
                    if (_e415 < 8388608f) {
                        phi_544_ = (_e427 - _e430);
                        phi_545_ = false;
                    } else {
                        phi_544_ = f32();
                        phi_545_ = true;
                    }
                    let _e433 = phi_544_;
                    let _e435 = phi_545_;
                    phi_546_ = _e433;
                    phi_547_ = _e435;
                } else {
                    phi_546_ = f32();
                    phi_547_ = true;
                }
                let _e437 = phi_546_;
                let _e439 = phi_547_;
                if _e439 {
                    phi_551_ = _e415;
                } else {
                    phi_551_ = _e437;
                }
                let _e441 = phi_551_;
                let _e442 = (_e322 + _e407);
                if (_e442 > -8388608f) {
                    let _e454 = f32(select(0i, select(select(i32(_e442), i32(-2147483648), (_e442 < bitcast<f32>(3472883712u))), 2147483647i, (_e442 > bitcast<f32>(1325400063u))), (_e442 == _e442)));
                    if (_e454 > _e442) {
                        phi_572_ = 1f;
                    } else {
                        phi_572_ = 0f;
                    }
                    let _e457 = phi_572_;
                    if (_e442 < 8388608f) {
                        phi_577_ = (_e454 - _e457);
                        phi_578_ = false;
                    } else {
                        phi_577_ = f32();
                        phi_578_ = true;
                    }
                    let _e460 = phi_577_;
                    let _e462 = phi_578_;
                    phi_579_ = _e460;
                    phi_580_ = _e462;
                } else {
                    phi_579_ = f32();
                    phi_580_ = true;
                }
                let _e464 = phi_579_;
                let _e466 = phi_580_;
                if _e466 {
                    phi_584_ = _e442;
                } else {
                    phi_584_ = _e464;
                }
                let _e468 = phi_584_;
                if (_e441 >= 0f) {
                    if (_e468 >= 0f) {
                        if (_e441 < f32(_e411)) {
                            let _e474 = (_e468 < f32(_e413));
                            if (_e406 == 0f) {
                                phi_605_ = (_e407 == 0f);
                            } else {
                                phi_605_ = false;
                            }
                            let _e478 = phi_605_;
                            if _e474 {
                                phi_624_ = vec2<u32>(select(select(u32(_e441), 0u, (_e441 < bitcast<f32>(0u))), 4294967295u, (_e441 > bitcast<f32>(1333788671u))), select(select(u32(_e468), 0u, (_e468 < bitcast<f32>(0u))), 4294967295u, (_e468 > bitcast<f32>(1333788671u))));
                                phi_625_ = false;
                            } else {
                                phi_624_ = vec2<u32>();
                                phi_625_ = true;
                            }
                            let _e495 = phi_624_;
                            let _e497 = phi_625_;
                            phi_626_ = _e478;
                            phi_627_ = _e474;
                            phi_628_ = _e495;
                            phi_629_ = _e478;
                            phi_630_ = _e474;
                            phi_631_ = false;
                            phi_632_ = _e497;
                        } else {
                            phi_626_ = bool();
                            phi_627_ = bool();
                            phi_628_ = vec2<u32>();
                            phi_629_ = bool();
                            phi_630_ = bool();
                            phi_631_ = true;
                            phi_632_ = false;
                        }
                        let _e499 = phi_626_;
                        let _e501 = phi_627_;
                        let _e503 = phi_628_;
                        let _e505 = phi_629_;
                        let _e507 = phi_630_;
                        let _e509 = phi_631_;
                        let _e511 = phi_632_;
                        phi_633_ = _e499;
                        phi_634_ = _e501;
                        phi_635_ = _e503;
                        phi_636_ = _e505;
                        phi_637_ = _e507;
                        phi_638_ = _e509;
                        phi_639_ = _e511;
                    } else {
                        phi_633_ = bool();
                        phi_634_ = bool();
                        phi_635_ = vec2<u32>();
                        phi_636_ = bool();
                        phi_637_ = bool();
                        phi_638_ = true;
                        phi_639_ = false;
                    }
                    let _e513 = phi_633_;
                    let _e515 = phi_634_;
                    let _e517 = phi_635_;
                    let _e519 = phi_636_;
                    let _e521 = phi_637_;
                    let _e523 = phi_638_;
                    let _e525 = phi_639_;
                    phi_640_ = _e513;
                    phi_641_ = _e515;
                    phi_642_ = _e517;
                    phi_643_ = _e519;
                    phi_644_ = _e521;
                    phi_645_ = _e523;
                    phi_646_ = _e525;
                } else {
                    phi_640_ = bool();
                    phi_641_ = bool();
                    phi_642_ = vec2<u32>();
                    phi_643_ = bool();
                    phi_644_ = bool();
                    phi_645_ = true;
                    phi_646_ = false;
                }
                let _e527 = phi_640_;
                let _e529 = phi_641_;
                let _e531 = phi_642_;
                let _e533 = phi_643_;
                let _e535 = phi_644_;
                let _e537 = phi_645_;
                let _e539 = phi_646_;
                if _e537 {
                    if (_e406 == 0f) {
                        phi_655_ = (_e407 == 0f);
                    } else {
                        phi_655_ = false;
                    }
                    let _e543 = phi_655_;
                    phi_656_ = _e543;
                    phi_657_ = false;
                    phi_658_ = true;
                } else {
                    phi_656_ = _e533;
                    phi_657_ = _e535;
                    phi_658_ = _e539;
                }
                let _e545 = phi_656_;
                let _e547 = phi_657_;
                let _e549 = phi_658_;
                if _e549 {
                    phi_662_ = _e545;
                    phi_663_ = _e547;
                    phi_664_ = vec2<u32>(_e53.x, _e53.y);
                } else {
                    phi_662_ = _e527;
                    phi_663_ = _e529;
                    phi_664_ = _e531;
                }
                let _e551 = phi_662_;
                let _e553 = phi_663_;
                let _e555 = phi_664_;
                let _e565 = lt_mask_Reprojection(vec2<u32>(_e555.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e572 = lt_mask_Reprojection(vec2<u32>(_e565.pixel.x, _e555.y), _e565.is_valid, _e565.has_moved);
                let _e576 = lt_mask_Reprojection(_e572.pixel, _e553, _e572.has_moved);
                let _e580 = lt_mask_Reprojection(_e576.pixel, _e576.is_valid, !(_e551));
                if _e553 {
                    let _e583 = p.member.previous.eye;
                    let _e591 = p.member.previous.forward;
                    let _e600 = (((((_e85.x - _e583.x) * _e591.x) + ((_e85.y - _e583.y) * _e591.y)) + ((_e85.z - _e583.z) * _e591.z)) > 0f);
                    let _e604 = lt_mask_Reprojection(_e580.pixel, _e600, _e580.has_moved);
                    if _e600 {
                        phi_699_ = false;
                    } else {
                        phi_699_ = true;
                    }
                    let _e606 = phi_699_;
                    phi_701_ = _e604;
                    phi_702_ = _e604;
                    phi_703_ = lt_mask_Reprojection();
                    phi_704_ = _e600;
                    phi_705_ = _e606;
                } else {
                    phi_701_ = lt_mask_Reprojection();
                    phi_702_ = lt_mask_Reprojection();
                    phi_703_ = lt_mask_Reprojection(_e580.pixel, false, _e580.has_moved);
                    phi_704_ = false;
                    phi_705_ = false;
                }
                let _e612 = phi_701_;
                let _e614 = phi_702_;
                let _e616 = phi_703_;
                let _e618 = phi_704_;
                let _e620 = phi_705_;
                phi_706_ = _e612;
                phi_707_ = _e614;
                phi_708_ = _e616;
                phi_709_ = _e618;
                phi_710_ = _e620;
            }
            let _e622 = phi_706_;
            let _e624 = phi_707_;
            let _e626 = phi_708_;
            let _e628 = phi_709_;
            let _e630 = phi_710_;
            if _e628 {
                let _e633 = p.member.previous.eye;
                let _e641 = p.member.previous.forward;
                let _e649 = ((((_e85.x - _e633.x) * _e641.x) + ((_e85.y - _e633.y) * _e641.y)) + ((_e85.z - _e633.z) * _e641.z));
                let _e655 = ((_e622.pixel.y * _e82) + _e622.pixel.x);
                if (_e655 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e659 = last_depths.member[(0u + _e655)];
                let _e661 = p.member.depth_tolerance;
                let _e664 = abs(_e649);
                let _e665 = abs(_e659);
                if ((bitcast<u32>(_e665) & 2147483647u) > 2139095040u) {
                    phi_762_ = true;
                } else {
                    let _e669 = (_e665 > _e664);
                    if _e669 {
                    }
                    phi_762_ = _e669;
                }
                let _e671 = phi_762_;
                if _e671 {
                    phi_766_ = _e665;
                } else {
                    phi_766_ = _e664;
                }
                let _e673 = phi_766_;
                phi_770_ = lt_mask_Reprojection(_e622.pixel, (abs((_e649 - _e659)) <= (_e661 * _e673)), _e622.has_moved);
                phi_771_ = true;
            } else {
                phi_770_ = _e624;
                phi_771_ = _e630;
            }
            let _e681 = phi_770_;
            let _e683 = phi_771_;
            if _e683 {
                if _e681.is_valid {
                    let _e686 = p.member.flags;
                    phi_783_ = ((_e686 & 1u) != 0u);
                    phi_784_ = false;
                } else {
                    phi_783_ = bool();
                    phi_784_ = true;
                }
                let _e690 = phi_783_;
                let _e692 = phi_784_;
                phi_785_ = _e690;
                phi_786_ = _e681;
                phi_787_ = _e692;
            } else {
                phi_785_ = bool();
                phi_786_ = _e626;
                phi_787_ = true;
            }
            let _e694 = phi_785_;
            let _e696 = phi_786_;
            let _e698 = phi_787_;
            if _e698 {
                phi_791_ = false;
                phi_792_ = _e696;
            } else {
                phi_791_ = _e694;
                phi_792_ = _e681;
            }
            let _e700 = phi_791_;
            let _e702 = phi_792_;
            let _e706 = lt_mask_Reprojection(_e702.pixel, _e700, _e702.has_moved);
            let _e708 = p.member.flags;
            let _e710 = ((_e708 & 2u) != 0u);
            let _e712 = p.member.flags;
            if ((_e712 & 4u) == 0u) {
                phi_891_ = u32();
                phi_892_ = true;
                phi_893_ = false;
            } else {
                if _e700 {
                    if !(_e706.has_moved) {
                        if (32u == 0u) {
                            return;
                        }
                        let _e718 = (_e82 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e82 % 32u) > 0u) {
                            phi_830_ = (_e718 + 1u);
                        } else {
                            phi_830_ = _e718;
                        }
                        let _e724 = phi_830_;
                        let _e729 = ((((_e53.y * _e724) + (_e53.x / 32u)) * 6u) + 4u);
                        if (_e729 < _e59) {
                        } else {
                            return;
                        }
                        let _e733 = heard.member[(0u + _e729)];
                        if (((_e733 >> bitcast<u32>(((_e53.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e744 = ((((_e53.y * _e724) + (_e53.x / 32u)) * 6u) + 5u);
                            if (_e744 < _e59) {
                            } else {
                                return;
                            }
                            let _e748 = heard.member[(0u + _e744)];
                            if false {
                                phi_879_ = (2u | 1u);
                            } else {
                                phi_879_ = 2u;
                            }
                            let _e757 = phi_879_;
                            if (((_e748 >> bitcast<u32>(((_e53.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_884_ = (_e757 | 4u);
                            } else {
                                phi_884_ = _e757;
                            }
                            let _e760 = phi_884_;
                            phi_885_ = _e760;
                        } else {
                            phi_885_ = 0u;
                        }
                        let _e762 = phi_885_;
                        phi_886_ = _e762;
                        phi_887_ = false;
                    } else {
                        phi_886_ = u32();
                        phi_887_ = true;
                    }
                    let _e764 = phi_886_;
                    let _e766 = phi_887_;
                    phi_888_ = _e764;
                    phi_889_ = false;
                    phi_890_ = _e766;
                } else {
                    phi_888_ = u32();
                    phi_889_ = true;
                    phi_890_ = false;
                }
                let _e768 = phi_888_;
                let _e770 = phi_889_;
                let _e772 = phi_890_;
                phi_891_ = _e768;
                phi_892_ = _e770;
                phi_893_ = _e772;
            }
            let _e774 = phi_891_;
            let _e776 = phi_892_;
            let _e778 = phi_893_;
            if _e776 {
                phi_897_ = true;
            } else {
                phi_897_ = _e778;
            }
            let _e780 = phi_897_;
            if _e780 {
                phi_901_ = 0u;
            } else {
                phi_901_ = _e774;
            }
            let _e782 = phi_901_;
            let _e783 = lt_mask_Neighbourhood(false, true);
            if _e252 {
                phi_906_ = _e710;
            } else {
                phi_906_ = true;
            }
            let _e785 = phi_906_;
            if _e785 {
                if _e700 {
                    if ((_e782 & 2u) != 0u) {
                        phi_967_ = _e783;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e794 = (_e82 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e82 % 32u) > 0u) {
                            phi_938_ = (_e794 + 1u);
                        } else {
                            phi_938_ = _e794;
                        }
                        let _e800 = phi_938_;
                        let _e810 = ((((_e706.pixel.y * _e800) + (_e706.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e248) | (select(0u, 1u, _e706.has_moved) << bitcast<u32>(1i))));
                        if (_e810 < _e59) {
                        } else {
                            return;
                        }
                        let _e814 = heard.member[(0u + _e810)];
                        let _e820 = (((_e814 >> bitcast<u32>(((_e706.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_967_ = lt_mask_Neighbourhood(_e820, !(_e820));
                    }
                    let _e824 = phi_967_;
                    phi_968_ = _e824;
                } else {
                    phi_968_ = _e783;
                }
                let _e826 = phi_968_;
                phi_969_ = _e826;
            } else {
                phi_969_ = _e783;
            }
            let _e828 = phi_969_;
            let _e831 = p.member.frame;
            let _e833 = p.member.refresh;
            if (_e833 == 0u) {
                phi_1002_ = false;
            } else {
                if (_e833 == 0u) {
                    return;
                }
                let _e842 = ((_e53.x + (_e53.y * (((_e833 * 5u) / 8u) | 1u))) + (_e831 % _e833));
                if (_e833 == 0u) {
                    phi_1001_ = (_e842 == 0u);
                } else {
                    if (_e833 == 0u) {
                        return;
                    }
                    phi_1001_ = ((_e842 % _e833) == 0u);
                }
                let _e849 = phi_1001_;
                phi_1002_ = _e849;
            }
            let _e851 = phi_1002_;
            if _e700 {
                if _e851 {
                    phi_1024_ = bool();
                } else {
                    phi_1024_ = ((_e782 & 2u) != 0u);
                }
                let _e857 = phi_1024_;
                phi_1025_ = _e857;
                phi_1026_ = _e851;
            } else {
                phi_1025_ = bool();
                phi_1026_ = true;
            }
            let _e859 = phi_1025_;
            let _e861 = phi_1026_;
            if _e861 {
                phi_1030_ = false;
            } else {
                phi_1030_ = _e859;
            }
            let _e863 = phi_1030_;
            if _e863 {
                phi_1081_ = 7u;
            } else {
                if (_e90 != 0.5f) {
                    if _e700 {
                        if _e851 {
                            phi_1078_ = 6u;
                        } else {
                            if _e252 {
                                phi_1053_ = true;
                            } else {
                                if _e828.any_expands {
                                    phi_1052_ = false;
                                } else {
                                    phi_1052_ = true;
                                }
                                let _e865 = phi_1052_;
                                phi_1053_ = _e865;
                            }
                            let _e867 = phi_1053_;
                            if _e867 {
                                if _e252 {
                                    if _e710 {
                                        if _e828.all_remove {
                                            phi_1066_ = false;
                                        } else {
                                            phi_1066_ = true;
                                        }
                                        let _e869 = phi_1066_;
                                        phi_1067_ = _e869;
                                    } else {
                                        phi_1067_ = true;
                                    }
                                    let _e871 = phi_1067_;
                                    phi_1068_ = _e871;
                                } else {
                                    phi_1068_ = true;
                                }
                                let _e873 = phi_1068_;
                                if _e873 {
                                    if _e252 {
                                        phi_1075_ = 1u;
                                    } else {
                                        phi_1075_ = 0u;
                                    }
                                    let _e875 = phi_1075_;
                                    phi_1076_ = _e875;
                                } else {
                                    phi_1076_ = 5u;
                                }
                                let _e877 = phi_1076_;
                                phi_1077_ = _e877;
                            } else {
                                phi_1077_ = 4u;
                            }
                            let _e879 = phi_1077_;
                            phi_1078_ = _e879;
                        }
                        let _e881 = phi_1078_;
                        phi_1079_ = _e881;
                    } else {
                        phi_1079_ = 3u;
                    }
                    let _e883 = phi_1079_;
                    phi_1080_ = _e883;
                } else {
                    phi_1080_ = 2u;
                }
                let _e885 = phi_1080_;
                phi_1081_ = _e885;
            }
            let _e887 = phi_1081_;
            if !((_e887 == 0u)) {
                if !((_e887 == 5u)) {
                    phi_1093_ = !(_e863);
                    phi_1094_ = false;
                } else {
                    phi_1093_ = bool();
                    phi_1094_ = true;
                }
                let _e894 = phi_1093_;
                let _e896 = phi_1094_;
                phi_1095_ = _e894;
                phi_1096_ = _e896;
            } else {
                phi_1095_ = bool();
                phi_1096_ = true;
            }
            let _e898 = phi_1095_;
            let _e900 = phi_1096_;
            if _e900 {
                phi_1100_ = false;
            } else {
                phi_1100_ = _e898;
            }
            let _e902 = phi_1100_;
            if _e863 {
                phi_1106_ = ((_e782 & 4u) != 0u);
            } else {
                phi_1106_ = _e248;
            }
            let _e906 = phi_1106_;
            if _e902 {
                if _e248 {
                    phi_1114_ = (2u | 1u);
                } else {
                    phi_1114_ = 2u;
                }
                let _e909 = phi_1114_;
                if false {
                    phi_1119_ = (_e909 | 4u);
                } else {
                    phi_1119_ = _e909;
                }
                let _e912 = phi_1119_;
                phi_1139_ = _e912;
            } else {
                if (_e887 == 7u) {
                    if _e248 {
                        phi_1128_ = (2u | 1u);
                    } else {
                        phi_1128_ = 2u;
                    }
                    let _e916 = phi_1128_;
                    if _e906 {
                        phi_1133_ = (_e916 | 4u);
                    } else {
                        phi_1133_ = _e916;
                    }
                    let _e919 = phi_1133_;
                    phi_1138_ = _e919;
                } else {
                    if _e248 {
                        phi_1137_ = 1u;
                    } else {
                        phi_1137_ = 0u;
                    }
                    let _e921 = phi_1137_;
                    phi_1138_ = _e921;
                }
                let _e923 = phi_1138_;
                phi_1139_ = _e923;
            }
            let _e925 = phi_1139_;
            if _e906 {
                phi_1143_ = 0f;
            } else {
                phi_1143_ = 1f;
            }
            let _e927 = phi_1143_;
            phi_1145_ = mask_Masked(_e927, _e925, _e902);
        }
        let _e930 = phi_1145_;
        visibility.member[_e74.first_primitive] = _e930.visibility;
        let _e935 = p.member.light.number;
        let _e936 = (_e935 * 3u);
        let _e938 = (_e936 % 32u);
        let _e940 = p.member.light.mask_words;
        let _e942 = ((_e74.first_primitive * _e940) + (_e936 / 32u));
        let _e944 = bits.member[_e942];
        bits.member[_e942] = ((_e944 & ~((7u << bitcast<u32>((_e938 & 31u))))) | (_e930.bits << bitcast<u32>((_e938 & 31u))));
        if (_e938 > 29u) {
            let _e959 = bits.member[(_e942 + 1u)];
            let _e961 = (32u - _e938);
            bits.member[(_e942 + 1u)] = ((_e959 & ~((7u >> bitcast<u32>((_e961 & 31u))))) | (_e930.bits >> bitcast<u32>((_e961 & 31u))));
        }
        let _e976 = samples.member[_e74.first_primitive].normal[0u];
        let _e978 = global[0u];
        if (_e976 == _e978) {
            let _e981 = samples.member[_e74.first_primitive].normal[1u];
            let _e983 = global[1u];
            if (_e981 == _e983) {
                let _e986 = samples.member[_e74.first_primitive].normal[2u];
                let _e988 = global[2u];
                phi_1217_ = (_e986 == _e988);
                phi_1218_ = false;
            } else {
                phi_1217_ = bool();
                phi_1218_ = true;
            }
            let _e991 = phi_1217_;
            let _e993 = phi_1218_;
            phi_1219_ = _e991;
            phi_1220_ = _e993;
        } else {
            phi_1219_ = bool();
            phi_1220_ = true;
        }
        let _e995 = phi_1219_;
        let _e997 = phi_1220_;
        if _e997 {
            phi_1224_ = false;
        } else {
            phi_1224_ = _e995;
        }
        let _e999 = phi_1224_;
        if !(_e999) {
            let _e1002 = samples.member[_e74.first_primitive].position;
            let _e1004 = p.member.current.eye;
            let _e1015 = p.member.current.forward;
            phi_1252_ = ((((_e1002.x - _e1004.x) * _e1015.x) + ((_e1002.y - _e1004.y) * _e1015.y)) + ((_e1002.z - _e1004.z) * _e1015.z));
        } else {
            phi_1252_ = 0f;
        }
        let _e1025 = phi_1252_;
        depths.member[_e74.first_primitive] = _e1025;
        phi_1255_ = _e930.needs_ray;
        phi_1256_ = _e74.first_primitive;
    } else {
        phi_1255_ = false;
        phi_1256_ = 0u;
    }
    let _e1029 = phi_1255_;
    let _e1031 = phi_1256_;
    if (_e54 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1029 {
        let _e1035 = atomicAdd((&shared_[0u]), 1u);
        phi_1267_ = _e1035;
    } else {
        phi_1267_ = 0u;
    }
    let _e1037 = phi_1267_;
    workgroupBarrier();
    if (_e54 == 0u) {
        let _e1041 = atomicLoad((&shared_[0u]));
        let _e1042 = atomicAdd((&list.member[3u]), _e1041);
        atomicStore((&shared_[1u]), _e1042);
    }
    workgroupBarrier();
    if _e1029 {
        let _e1045 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1045) + _e1037)]), _e1031);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
