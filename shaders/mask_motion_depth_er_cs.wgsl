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
        let _e64 = phi_164_;
        let _e66 = phi_165_;
        phi_166_ = _e64;
        phi_167_ = _e66;
    } else {
        phi_166_ = lt_bvh_traverse_Tree();
        phi_167_ = true;
    }
    let _e68 = phi_166_;
    let _e70 = phi_167_;
    if _e70 {
        phi_172_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_172_ = _e68;
    }
    let _e75 = phi_172_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn function_() {
    var phi_240_: bool;
    var phi_241_: bool;
    var phi_242_: bool;
    var phi_243_: bool;
    var phi_247_: bool;
    var phi_317_: bool;
    var phi_318_: bool;
    var phi_329_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_330_: bool;
    var phi_331_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_332_: bool;
    var phi_339_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_343_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_356_: bool;
    var phi_387_: bool;
    var phi_388_: bool;
    var phi_389_: bool;
    var phi_390_: bool;
    var phi_394_: bool;
    var phi_395_: bool;
    var phi_534_: f32;
    var phi_539_: f32;
    var phi_540_: bool;
    var phi_541_: f32;
    var phi_542_: bool;
    var phi_546_: f32;
    var phi_567_: f32;
    var phi_572_: f32;
    var phi_573_: bool;
    var phi_574_: f32;
    var phi_575_: bool;
    var phi_579_: f32;
    var phi_600_: bool;
    var phi_619_: vec2<u32>;
    var phi_620_: bool;
    var phi_621_: bool;
    var phi_622_: bool;
    var phi_623_: vec2<u32>;
    var phi_624_: bool;
    var phi_625_: bool;
    var phi_626_: bool;
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
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_659_: vec2<u32>;
    var phi_697_: bool;
    var phi_699_: lt_mask_Reprojection;
    var phi_700_: lt_mask_Reprojection;
    var phi_701_: lt_mask_Reprojection;
    var phi_702_: bool;
    var phi_703_: bool;
    var phi_704_: lt_mask_Reprojection;
    var phi_705_: lt_mask_Reprojection;
    var phi_706_: lt_mask_Reprojection;
    var phi_707_: bool;
    var phi_708_: bool;
    var phi_763_: bool;
    var phi_767_: f32;
    var phi_771_: lt_mask_Reprojection;
    var phi_772_: bool;
    var phi_784_: bool;
    var phi_785_: bool;
    var phi_786_: bool;
    var phi_787_: lt_mask_Reprojection;
    var phi_788_: bool;
    var phi_792_: bool;
    var phi_793_: lt_mask_Reprojection;
    var phi_799_: bool;
    var phi_831_: u32;
    var phi_860_: lt_mask_Neighbourhood;
    var phi_861_: lt_mask_Neighbourhood;
    var phi_862_: lt_mask_Neighbourhood;
    var phi_894_: bool;
    var phi_895_: bool;
    var phi_917_: bool;
    var phi_918_: bool;
    var phi_919_: bool;
    var phi_923_: bool;
    var phi_945_: bool;
    var phi_946_: bool;
    var phi_959_: bool;
    var phi_960_: bool;
    var phi_961_: bool;
    var phi_968_: u32;
    var phi_969_: u32;
    var phi_970_: u32;
    var phi_971_: u32;
    var phi_972_: u32;
    var phi_973_: u32;
    var phi_974_: u32;
    var phi_986_: bool;
    var phi_987_: bool;
    var phi_988_: bool;
    var phi_989_: bool;
    var phi_993_: bool;
    var phi_999_: bool;
    var phi_1007_: u32;
    var phi_1012_: u32;
    var phi_1021_: u32;
    var phi_1026_: u32;
    var phi_1030_: u32;
    var phi_1031_: u32;
    var phi_1032_: u32;
    var phi_1036_: f32;
    var phi_1038_: mask_Masked;
    var phi_1110_: bool;
    var phi_1111_: bool;
    var phi_1112_: bool;
    var phi_1113_: bool;
    var phi_1117_: bool;
    var phi_1145_: f32;
    var phi_1148_: bool;
    var phi_1149_: u32;
    var phi_1160_: u32;

    let _e51 = id_1;
    let _e52 = local_1;
    let _e68 = p.member.current.size[0u];
    let _e70 = p.member.current.size[1u];
    let _e71 = lt_shaders_entry_pixel_index(_e51, _e68, _e70);
    if (bitcast<i32>(_e71.root) != 0i) {
        let _e79 = p.member.current.size[0u];
        let _e82 = samples.member[_e71.first_primitive].position;
        let _e84 = visibility.member[_e71.first_primitive];
        let _e90 = samples.member[_e71.first_primitive].normal[0u];
        let _e92 = global[0u];
        if (_e90 == _e92) {
            let _e95 = samples.member[_e71.first_primitive].normal[1u];
            let _e97 = global[1u];
            if (_e95 == _e97) {
                let _e100 = samples.member[_e71.first_primitive].normal[2u];
                let _e102 = global[2u];
                phi_240_ = (_e100 == _e102);
                phi_241_ = false;
            } else {
                phi_240_ = bool();
                phi_241_ = true;
            }
            let _e105 = phi_240_;
            let _e107 = phi_241_;
            phi_242_ = _e105;
            phi_243_ = _e107;
        } else {
            phi_242_ = bool();
            phi_243_ = true;
        }
        let _e109 = phi_242_;
        let _e111 = phi_243_;
        if _e111 {
            phi_247_ = false;
        } else {
            phi_247_ = _e109;
        }
        let _e113 = phi_247_;
        if !(_e113) {
            let _e116 = samples.member[_e71.first_primitive].position;
            let _e118 = p.member.light.place;
            let _e124 = p.member.light.place[3u];
            let _e131 = (_e118.x - (_e116.x * _e124));
            let _e132 = (_e118.y - (_e116.y * _e124));
            let _e133 = (_e118.z - (_e116.z * _e124));
            let _e135 = samples.member[_e71.first_primitive].normal;
            if ((((_e135.x * _e131) + (_e135.y * _e132)) + (_e135.z * _e133)) > 0f) {
                let _e149 = (((_e131 * _e131) + (_e132 * _e132)) + (_e133 * _e133));
                let _e151 = p.member.light.axis;
                let _e163 = p.member.light.place[3u];
                if (_e163 == 0f) {
                    phi_318_ = true;
                } else {
                    let _e166 = p.member.light.range_squared;
                    if (_e149 <= _e166) {
                        let _e169 = p.member.light.cos_outer;
                        phi_317_ = (-((((_e131 * _e151.x) + (_e132 * _e151.y)) + (_e133 * _e151.z))) >= (_e169 * sqrt(_e149)));
                    } else {
                        phi_317_ = false;
                    }
                    let _e174 = phi_317_;
                    phi_318_ = _e174;
                }
                let _e176 = phi_318_;
                if _e176 {
                    let _e178 = samples.member[_e71.first_primitive].flags;
                    let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e186.unnamed.visibility, false), _e186.unnamed_1);
                    phi_329_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e192.unnamed, ((_e178 & 1u) == 0u));
                    phi_330_ = false;
                } else {
                    phi_329_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_330_ = true;
                }
                let _e197 = phi_329_;
                let _e199 = phi_330_;
                phi_331_ = _e197;
                phi_332_ = _e199;
            } else {
                phi_331_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_332_ = true;
            }
            let _e201 = phi_331_;
            let _e203 = phi_332_;
            if _e203 {
                let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e215 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e209.unnamed.visibility, false), _e209.unnamed_1);
                phi_339_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e215.unnamed, true);
            } else {
                phi_339_ = _e201;
            }
            let _e220 = phi_339_;
            phi_343_ = _e220;
        } else {
            let _e226 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e232 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e226.unnamed.visibility, false), _e226.unnamed_1);
            phi_343_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e232.unnamed, true);
        }
        let _e237 = phi_343_;
        if _e237.unnamed_1 {
            phi_1038_ = mask_Masked(_e237.unnamed.visibility, 0u, false);
        } else {
            let _e242 = (_e84 < 0.5f);
            if (_e84 > 0f) {
                phi_356_ = (_e84 < 1f);
            } else {
                phi_356_ = false;
            }
            let _e246 = phi_356_;
            let _e253 = lt_mask_Reprojection(vec2<u32>(_e51.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e260 = lt_mask_Reprojection(vec2<u32>(_e253.pixel.x, _e51.y), _e253.is_valid, _e253.has_moved);
            let _e264 = lt_mask_Reprojection(_e260.pixel, true, _e260.has_moved);
            let _e270 = p.member.flags;
            if ((_e270 & 16u) == 0u) {
                phi_395_ = false;
            } else {
                let _e276 = samples.member[_e71.first_primitive].position[0u];
                if (_e82.x == _e276) {
                    let _e280 = samples.member[_e71.first_primitive].position[1u];
                    if (_e82.y == _e280) {
                        let _e284 = samples.member[_e71.first_primitive].position[2u];
                        phi_387_ = (_e82.z == _e284);
                        phi_388_ = false;
                    } else {
                        phi_387_ = bool();
                        phi_388_ = true;
                    }
                    let _e287 = phi_387_;
                    let _e289 = phi_388_;
                    phi_389_ = _e287;
                    phi_390_ = _e289;
                } else {
                    phi_389_ = bool();
                    phi_390_ = true;
                }
                let _e291 = phi_389_;
                let _e293 = phi_390_;
                if _e293 {
                    phi_394_ = false;
                } else {
                    phi_394_ = _e291;
                }
                let _e295 = phi_394_;
                phi_395_ = _e295;
            }
            let _e297 = phi_395_;
            if _e297 {
                phi_704_ = lt_mask_Reprojection(_e264.pixel, _e264.is_valid, false);
                phi_705_ = lt_mask_Reprojection();
                phi_706_ = lt_mask_Reprojection();
                phi_707_ = true;
                phi_708_ = false;
            } else {
                let _e301 = p.member.current.grid[0u];
                let _e303 = p.member.current.grid[1u];
                let _e317 = (f32(_e51.x) + ((f32((_e51.y & (_e303 - 1u))) + 0.5f) / f32(_e303)));
                let _e319 = (f32(_e51.y) + ((f32((_e51.x & (_e301 - 1u))) + 0.5f) / f32(_e301)));
                let _e322 = p.member.previous.eye;
                let _e325 = (_e82.x - _e322.x);
                let _e328 = (_e82.y - _e322.y);
                let _e331 = (_e82.z - _e322.z);
                let _e333 = p.member.previous.forward;
                let _e341 = (((_e325 * _e333.x) + (_e328 * _e333.y)) + (_e331 * _e333.z));
                let _e343 = p.member.previous.right;
                let _e353 = p.member.previous.right;
                let _e368 = p.member.previous.up;
                let _e378 = p.member.previous.up;
                let _e395 = p.member.previous.size[0u];
                let _e402 = p.member.previous.size[1u];
                let _e406 = (((((((_e325 * _e343.x) + (_e328 * _e343.y)) + (_e331 * _e343.z)) / ((((_e353.x * _e353.x) + (_e353.y * _e353.y)) + (_e353.z * _e353.z)) * _e341)) + 1f) * (0.5f * f32(_e395))) - _e317);
                let _e407 = (((1f - ((((_e325 * _e368.x) + (_e328 * _e368.y)) + (_e331 * _e368.z)) / ((((_e378.x * _e378.x) + (_e378.y * _e378.y)) + (_e378.z * _e378.z)) * _e341))) * (0.5f * f32(_e402))) - _e319);
                let _e411 = p.member.current.size[0u];
                let _e413 = p.member.current.size[1u];
                let _e415 = (_e317 + _e406);
                if (_e415 > -8388608f) {
                    let _e427 = f32(select(0i, select(select(i32(_e415), i32(-2147483648), (_e415 < bitcast<f32>(3472883712u))), 2147483647i, (_e415 > bitcast<f32>(1325400063u))), (_e415 == _e415)));
                    if (_e427 > _e415) {
                        phi_534_ = 1f;
                    } else {
                        phi_534_ = 0f;
                    }
                    let _e430 = phi_534_;
                    if (_e415 < 8388608f) {
                        phi_539_ = (_e427 - _e430);
                        phi_540_ = false;
                    } else {
                        phi_539_ = f32();
                        phi_540_ = true;
                    }
                    let _e433 = phi_539_;
                    let _e435 = phi_540_;
                    phi_541_ = _e433;
                    phi_542_ = _e435;
                } else {
                    phi_541_ = f32();
                    phi_542_ = true;
                }
                let _e437 = phi_541_;
                let _e439 = phi_542_;
                if _e439 {
                    phi_546_ = _e415;
                } else {
                    phi_546_ = _e437;
                }
                let _e441 = phi_546_;
                let _e442 = (_e319 + _e407);
                if (_e442 > -8388608f) {
                    let _e454 = f32(select(0i, select(select(i32(_e442), i32(-2147483648), (_e442 < bitcast<f32>(3472883712u))), 2147483647i, (_e442 > bitcast<f32>(1325400063u))), (_e442 == _e442)));
                    if (_e454 > _e442) {
                        phi_567_ = 1f;
                    } else {
                        phi_567_ = 0f;
                    }
                    let _e457 = phi_567_;
                    if (_e442 < 8388608f) {
                        phi_572_ = (_e454 - _e457);
                        phi_573_ = false;
                    } else {
                        phi_572_ = f32();
                        phi_573_ = true;
                    }
                    let _e460 = phi_572_;
                    let _e462 = phi_573_;
                    phi_574_ = _e460;
                    phi_575_ = _e462;
                } else {
                    phi_574_ = f32();
                    phi_575_ = true;
                }
                let _e464 = phi_574_;
                let _e466 = phi_575_;
                if _e466 {
                    phi_579_ = _e442;
                } else {
                    phi_579_ = _e464;
                }
                let _e468 = phi_579_;
                if (_e441 >= 0f) {
                    if (_e468 >= 0f) {
                        if (_e441 < f32(_e411)) {
                            let _e474 = (_e468 < f32(_e413));
                            if (_e406 == 0f) {
                                phi_600_ = (_e407 == 0f);
                            } else {
                                phi_600_ = false;
                            }
                            let _e478 = phi_600_;
                            if _e474 {
                                phi_619_ = vec2<u32>(select(select(u32(_e441), 0u, (_e441 < bitcast<f32>(0u))), 4294967295u, (_e441 > bitcast<f32>(1333788671u))), select(select(u32(_e468), 0u, (_e468 < bitcast<f32>(0u))), 4294967295u, (_e468 > bitcast<f32>(1333788671u))));
                                phi_620_ = false;
                            } else {
                                phi_619_ = vec2<u32>();
                                phi_620_ = true;
                            }
                            let _e495 = phi_619_;
                            let _e497 = phi_620_;
                            phi_621_ = _e478;
                            phi_622_ = _e474;
                            phi_623_ = _e495;
                            phi_624_ = _e478;
                            phi_625_ = _e474;
                            phi_626_ = false;
                            phi_627_ = _e497;
                        } else {
                            phi_621_ = bool();
                            phi_622_ = bool();
                            phi_623_ = vec2<u32>();
                            phi_624_ = bool();
                            phi_625_ = bool();
                            phi_626_ = true;
                            phi_627_ = false;
                        }
                        let _e499 = phi_621_;
                        let _e501 = phi_622_;
                        let _e503 = phi_623_;
                        let _e505 = phi_624_;
                        let _e507 = phi_625_;
                        let _e509 = phi_626_;
                        let _e511 = phi_627_;
                        phi_628_ = _e499;
                        phi_629_ = _e501;
                        phi_630_ = _e503;
                        phi_631_ = _e505;
                        phi_632_ = _e507;
                        phi_633_ = _e509;
                        phi_634_ = _e511;
                    } else {
                        phi_628_ = bool();
                        phi_629_ = bool();
                        phi_630_ = vec2<u32>();
                        phi_631_ = bool();
                        phi_632_ = bool();
                        phi_633_ = true;
                        phi_634_ = false;
                    }
                    let _e513 = phi_628_;
                    let _e515 = phi_629_;
                    let _e517 = phi_630_;
                    let _e519 = phi_631_;
                    let _e521 = phi_632_;
                    let _e523 = phi_633_;
                    let _e525 = phi_634_;
                    phi_635_ = _e513;
                    phi_636_ = _e515;
                    phi_637_ = _e517;
                    phi_638_ = _e519;
                    phi_639_ = _e521;
                    phi_640_ = _e523;
                    phi_641_ = _e525;
                } else {
                    phi_635_ = bool();
                    phi_636_ = bool();
                    phi_637_ = vec2<u32>();
                    phi_638_ = bool();
                    phi_639_ = bool();
                    phi_640_ = true;
                    phi_641_ = false;
                }
                let _e527 = phi_635_;
                let _e529 = phi_636_;
                let _e531 = phi_637_;
                let _e533 = phi_638_;
                let _e535 = phi_639_;
                let _e537 = phi_640_;
                let _e539 = phi_641_;
                if _e537 {
                    if (_e406 == 0f) {
                        phi_650_ = (_e407 == 0f);
                    } else {
                        phi_650_ = false;
                    }
                    let _e543 = phi_650_;
                    phi_651_ = _e543;
                    phi_652_ = false;
                    phi_653_ = true;
                } else {
                    phi_651_ = _e533;
                    phi_652_ = _e535;
                    phi_653_ = _e539;
                }
                let _e545 = phi_651_;
                let _e547 = phi_652_;
                let _e549 = phi_653_;
                if _e549 {
                    phi_657_ = _e545;
                    phi_658_ = _e547;
                    phi_659_ = vec2<u32>(_e51.x, _e51.y);
                } else {
                    phi_657_ = _e527;
                    phi_658_ = _e529;
                    phi_659_ = _e531;
                }
                let _e551 = phi_657_;
                let _e553 = phi_658_;
                let _e555 = phi_659_;
                let _e565 = lt_mask_Reprojection(vec2<u32>(_e555.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e572 = lt_mask_Reprojection(vec2<u32>(_e565.pixel.x, _e555.y), _e565.is_valid, _e565.has_moved);
                let _e576 = lt_mask_Reprojection(_e572.pixel, _e553, _e572.has_moved);
                let _e580 = lt_mask_Reprojection(_e576.pixel, _e576.is_valid, !(_e551));
                if _e553 {
                    let _e583 = p.member.previous.eye;
                    let _e594 = p.member.previous.forward;
                    let _e603 = (((((_e82.x - _e583.x) * _e594.x) + ((_e82.y - _e583.y) * _e594.y)) + ((_e82.z - _e583.z) * _e594.z)) > 0f);
                    let _e607 = lt_mask_Reprojection(_e580.pixel, _e603, _e580.has_moved);
                    if _e603 {
                        phi_697_ = false;
                    } else {
                        phi_697_ = true;
                    }
                    let _e609 = phi_697_;
                    phi_699_ = _e607;
                    phi_700_ = _e607;
                    phi_701_ = lt_mask_Reprojection();
                    phi_702_ = _e603;
                    phi_703_ = _e609;
                } else {
                    phi_699_ = lt_mask_Reprojection();
                    phi_700_ = lt_mask_Reprojection();
                    phi_701_ = lt_mask_Reprojection(_e580.pixel, false, _e580.has_moved);
                    phi_702_ = false;
                    phi_703_ = false;
                }
                let _e615 = phi_699_;
                let _e617 = phi_700_;
                let _e619 = phi_701_;
                let _e621 = phi_702_;
                let _e623 = phi_703_;
                phi_704_ = _e615;
                phi_705_ = _e617;
                phi_706_ = _e619;
                phi_707_ = _e621;
                phi_708_ = _e623;
            }
            let _e625 = phi_704_;
            let _e627 = phi_705_;
            let _e629 = phi_706_;
            let _e631 = phi_707_;
            let _e633 = phi_708_;
            if _e631 {
                let _e636 = p.member.previous.eye;
                let _e647 = p.member.previous.forward;
                let _e655 = ((((_e82.x - _e636.x) * _e647.x) + ((_e82.y - _e636.y) * _e647.y)) + ((_e82.z - _e636.z) * _e647.z));
                let _e661 = ((_e625.pixel.y * _e79) + _e625.pixel.x);
                if (_e661 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e665 = last_depths.member[(0u + _e661)];
                let _e667 = p.member.depth_tolerance;
                let _e670 = abs(_e655);
                let _e671 = abs(_e665);
                if ((bitcast<u32>(_e671) & 2147483647u) > 2139095040u) {
                    phi_763_ = true;
                } else {
                    let _e675 = (_e671 > _e670);
                    if _e675 {
                    }
                    phi_763_ = _e675;
                }
                let _e677 = phi_763_;
                if _e677 {
                    phi_767_ = _e671;
                } else {
                    phi_767_ = _e670;
                }
                let _e679 = phi_767_;
                phi_771_ = lt_mask_Reprojection(_e625.pixel, (abs((_e655 - _e665)) <= (_e667 * _e679)), _e625.has_moved);
                phi_772_ = true;
            } else {
                phi_771_ = _e627;
                phi_772_ = _e633;
            }
            let _e687 = phi_771_;
            let _e689 = phi_772_;
            if _e689 {
                if _e687.is_valid {
                    let _e692 = p.member.flags;
                    phi_784_ = ((_e692 & 1u) != 0u);
                    phi_785_ = false;
                } else {
                    phi_784_ = bool();
                    phi_785_ = true;
                }
                let _e696 = phi_784_;
                let _e698 = phi_785_;
                phi_786_ = _e696;
                phi_787_ = _e687;
                phi_788_ = _e698;
            } else {
                phi_786_ = bool();
                phi_787_ = _e629;
                phi_788_ = true;
            }
            let _e700 = phi_786_;
            let _e702 = phi_787_;
            let _e704 = phi_788_;
            if _e704 {
                phi_792_ = false;
                phi_793_ = _e702;
            } else {
                phi_792_ = _e700;
                phi_793_ = _e687;
            }
            let _e706 = phi_792_;
            let _e708 = phi_793_;
            let _e712 = lt_mask_Reprojection(_e708.pixel, _e706, _e708.has_moved);
            let _e713 = lt_mask_Neighbourhood(false, true);
            if _e246 {
                phi_799_ = false;
            } else {
                phi_799_ = true;
            }
            let _e715 = phi_799_;
            if _e715 {
                if _e706 {
                    if ((0u & 2u) != 0u) {
                        phi_860_ = _e713;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e724 = (_e79 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e79 % 32u) > 0u) {
                            phi_831_ = (_e724 + 1u);
                        } else {
                            phi_831_ = _e724;
                        }
                        let _e730 = phi_831_;
                        let _e740 = ((((_e712.pixel.y * _e730) + (_e712.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e242) | (select(0u, 1u, _e712.has_moved) << bitcast<u32>(1i))));
                        if (_e740 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e744 = heard.member[(0u + _e740)];
                        let _e750 = (((_e744 >> bitcast<u32>(((_e712.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_860_ = lt_mask_Neighbourhood(_e750, !(_e750));
                    }
                    let _e754 = phi_860_;
                    phi_861_ = _e754;
                } else {
                    phi_861_ = _e713;
                }
                let _e756 = phi_861_;
                phi_862_ = _e756;
            } else {
                phi_862_ = _e713;
            }
            let _e758 = phi_862_;
            let _e761 = p.member.frame;
            let _e763 = p.member.refresh;
            if (_e763 == 0u) {
                phi_895_ = false;
            } else {
                if (_e763 == 0u) {
                    return;
                }
                let _e772 = ((_e51.x + (_e51.y * (((_e763 * 5u) / 8u) | 1u))) + (_e761 % _e763));
                if (_e763 == 0u) {
                    phi_894_ = (_e772 == 0u);
                } else {
                    if (_e763 == 0u) {
                        return;
                    }
                    phi_894_ = ((_e772 % _e763) == 0u);
                }
                let _e779 = phi_894_;
                phi_895_ = _e779;
            }
            let _e781 = phi_895_;
            if _e706 {
                if _e781 {
                    phi_917_ = bool();
                } else {
                    phi_917_ = ((0u & 2u) != 0u);
                }
                let _e787 = phi_917_;
                phi_918_ = _e787;
                phi_919_ = _e781;
            } else {
                phi_918_ = bool();
                phi_919_ = true;
            }
            let _e789 = phi_918_;
            let _e791 = phi_919_;
            if _e791 {
                phi_923_ = false;
            } else {
                phi_923_ = _e789;
            }
            let _e793 = phi_923_;
            if _e793 {
                phi_974_ = 7u;
            } else {
                if (_e84 != 0.5f) {
                    if _e706 {
                        if _e781 {
                            phi_971_ = 6u;
                        } else {
                            if _e246 {
                                phi_946_ = true;
                            } else {
                                if _e758.any_expands {
                                    phi_945_ = false;
                                } else {
                                    phi_945_ = true;
                                }
                                let _e795 = phi_945_;
                                phi_946_ = _e795;
                            }
                            let _e797 = phi_946_;
                            if _e797 {
                                if _e246 {
                                    if false {
                                        if _e758.all_remove {
                                            phi_959_ = false;
                                        } else {
                                            phi_959_ = true;
                                        }
                                        let _e799 = phi_959_;
                                        phi_960_ = _e799;
                                    } else {
                                        phi_960_ = true;
                                    }
                                    let _e801 = phi_960_;
                                    phi_961_ = _e801;
                                } else {
                                    phi_961_ = true;
                                }
                                let _e803 = phi_961_;
                                if _e803 {
                                    if _e246 {
                                        phi_968_ = 1u;
                                    } else {
                                        phi_968_ = 0u;
                                    }
                                    let _e805 = phi_968_;
                                    phi_969_ = _e805;
                                } else {
                                    phi_969_ = 5u;
                                }
                                let _e807 = phi_969_;
                                phi_970_ = _e807;
                            } else {
                                phi_970_ = 4u;
                            }
                            let _e809 = phi_970_;
                            phi_971_ = _e809;
                        }
                        let _e811 = phi_971_;
                        phi_972_ = _e811;
                    } else {
                        phi_972_ = 3u;
                    }
                    let _e813 = phi_972_;
                    phi_973_ = _e813;
                } else {
                    phi_973_ = 2u;
                }
                let _e815 = phi_973_;
                phi_974_ = _e815;
            }
            let _e817 = phi_974_;
            if !((_e817 == 0u)) {
                if !((_e817 == 5u)) {
                    phi_986_ = !(_e793);
                    phi_987_ = false;
                } else {
                    phi_986_ = bool();
                    phi_987_ = true;
                }
                let _e824 = phi_986_;
                let _e826 = phi_987_;
                phi_988_ = _e824;
                phi_989_ = _e826;
            } else {
                phi_988_ = bool();
                phi_989_ = true;
            }
            let _e828 = phi_988_;
            let _e830 = phi_989_;
            if _e830 {
                phi_993_ = false;
            } else {
                phi_993_ = _e828;
            }
            let _e832 = phi_993_;
            if _e793 {
                phi_999_ = ((0u & 4u) != 0u);
            } else {
                phi_999_ = _e242;
            }
            let _e836 = phi_999_;
            if _e832 {
                if _e242 {
                    phi_1007_ = (2u | 1u);
                } else {
                    phi_1007_ = 2u;
                }
                let _e839 = phi_1007_;
                if false {
                    phi_1012_ = (_e839 | 4u);
                } else {
                    phi_1012_ = _e839;
                }
                let _e842 = phi_1012_;
                phi_1032_ = _e842;
            } else {
                if (_e817 == 7u) {
                    if _e242 {
                        phi_1021_ = (2u | 1u);
                    } else {
                        phi_1021_ = 2u;
                    }
                    let _e846 = phi_1021_;
                    if _e836 {
                        phi_1026_ = (_e846 | 4u);
                    } else {
                        phi_1026_ = _e846;
                    }
                    let _e849 = phi_1026_;
                    phi_1031_ = _e849;
                } else {
                    if _e242 {
                        phi_1030_ = 1u;
                    } else {
                        phi_1030_ = 0u;
                    }
                    let _e851 = phi_1030_;
                    phi_1031_ = _e851;
                }
                let _e853 = phi_1031_;
                phi_1032_ = _e853;
            }
            let _e855 = phi_1032_;
            if _e836 {
                phi_1036_ = 0f;
            } else {
                phi_1036_ = 1f;
            }
            let _e857 = phi_1036_;
            phi_1038_ = mask_Masked(_e857, _e855, _e832);
        }
        let _e860 = phi_1038_;
        visibility.member[_e71.first_primitive] = _e860.visibility;
        let _e865 = p.member.light.number;
        let _e866 = (_e865 * 3u);
        let _e868 = (_e866 % 32u);
        let _e870 = p.member.light.mask_words;
        let _e872 = ((_e71.first_primitive * _e870) + (_e866 / 32u));
        let _e874 = bits.member[_e872];
        bits.member[_e872] = ((_e874 & ~((7u << bitcast<u32>((_e868 & 31u))))) | (_e860.bits << bitcast<u32>((_e868 & 31u))));
        if (_e868 > 29u) {
            let _e889 = bits.member[(_e872 + 1u)];
            let _e891 = (32u - _e868);
            bits.member[(_e872 + 1u)] = ((_e889 & ~((7u >> bitcast<u32>((_e891 & 31u))))) | (_e860.bits >> bitcast<u32>((_e891 & 31u))));
        }
        let _e906 = samples.member[_e71.first_primitive].normal[0u];
        let _e908 = global[0u];
        if (_e906 == _e908) {
            let _e911 = samples.member[_e71.first_primitive].normal[1u];
            let _e913 = global[1u];
            if (_e911 == _e913) {
                let _e916 = samples.member[_e71.first_primitive].normal[2u];
                let _e918 = global[2u];
                phi_1110_ = (_e916 == _e918);
                phi_1111_ = false;
            } else {
                phi_1110_ = bool();
                phi_1111_ = true;
            }
            let _e921 = phi_1110_;
            let _e923 = phi_1111_;
            phi_1112_ = _e921;
            phi_1113_ = _e923;
        } else {
            phi_1112_ = bool();
            phi_1113_ = true;
        }
        let _e925 = phi_1112_;
        let _e927 = phi_1113_;
        if _e927 {
            phi_1117_ = false;
        } else {
            phi_1117_ = _e925;
        }
        let _e929 = phi_1117_;
        if !(_e929) {
            let _e932 = samples.member[_e71.first_primitive].position;
            let _e934 = p.member.current.eye;
            let _e945 = p.member.current.forward;
            phi_1145_ = ((((_e932.x - _e934.x) * _e945.x) + ((_e932.y - _e934.y) * _e945.y)) + ((_e932.z - _e934.z) * _e945.z));
        } else {
            phi_1145_ = 0f;
        }
        let _e955 = phi_1145_;
        depths.member[_e71.first_primitive] = _e955;
        phi_1148_ = _e860.needs_ray;
        phi_1149_ = _e71.first_primitive;
    } else {
        phi_1148_ = false;
        phi_1149_ = 0u;
    }
    let _e959 = phi_1148_;
    let _e961 = phi_1149_;
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e959 {
        let _e965 = atomicAdd((&shared_[0u]), 1u);
        phi_1160_ = _e965;
    } else {
        phi_1160_ = 0u;
    }
    let _e967 = phi_1160_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e971 = atomicLoad((&shared_[0u]));
        let _e972 = atomicAdd((&list.member[3u]), _e971);
        atomicStore((&shared_[1u]), _e972);
    }
    workgroupBarrier();
    if _e959 {
        let _e975 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e975) + _e967)]), _e961);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
