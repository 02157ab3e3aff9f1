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
    var phi_168_: lt_bvh_traverse_Tree;
    var phi_169_: bool;
    var phi_170_: lt_bvh_traverse_Tree;
    var phi_171_: bool;
    var phi_176_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_168_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_169_ = false;
        } else {
            phi_168_ = lt_bvh_traverse_Tree();
            phi_169_ = true;
        }
        let _e65 = phi_168_;
        let _e67 = phi_169_;
        phi_170_ = _e65;
        phi_171_ = _e67;
    } else {
        phi_170_ = lt_bvh_traverse_Tree();
        phi_171_ = true;
    }
    let _e69 = phi_170_;
    let _e71 = phi_171_;
    if _e71 {
        phi_176_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_176_ = _e69;
    }
    let _e76 = phi_176_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn function_() {
    var phi_223_: u32;
    var phi_260_: bool;
    var phi_261_: bool;
    var phi_262_: bool;
    var phi_263_: bool;
    var phi_267_: bool;
    var phi_337_: bool;
    var phi_338_: bool;
    var phi_349_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_350_: bool;
    var phi_351_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_352_: bool;
    var phi_359_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_363_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_376_: bool;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_411_: bool;
    var phi_412_: bool;
    var phi_548_: f32;
    var phi_553_: f32;
    var phi_554_: bool;
    var phi_555_: f32;
    var phi_556_: bool;
    var phi_560_: f32;
    var phi_581_: f32;
    var phi_586_: f32;
    var phi_587_: bool;
    var phi_588_: f32;
    var phi_589_: bool;
    var phi_593_: f32;
    var phi_614_: bool;
    var phi_633_: vec2<u32>;
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
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_651_: vec2<u32>;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_655_: bool;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_666_: bool;
    var phi_667_: bool;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_673_: vec2<u32>;
    var phi_708_: bool;
    var phi_710_: lt_mask_Reprojection;
    var phi_711_: lt_mask_Reprojection;
    var phi_712_: bool;
    var phi_716_: bool;
    var phi_717_: lt_mask_Reprojection;
    var phi_718_: lt_mask_Reprojection;
    var phi_719_: bool;
    var phi_727_: bool;
    var phi_728_: lt_mask_Reprojection;
    var phi_794_: u32;
    var phi_799_: u32;
    var phi_800_: u32;
    var phi_801_: u32;
    var phi_802_: bool;
    var phi_803_: u32;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_806_: u32;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_812_: bool;
    var phi_816_: u32;
    var phi_821_: bool;
    var phi_861_: lt_mask_Neighbourhood;
    var phi_862_: lt_mask_Neighbourhood;
    var phi_863_: lt_mask_Neighbourhood;
    var phi_895_: bool;
    var phi_896_: bool;
    var phi_918_: bool;
    var phi_919_: bool;
    var phi_920_: bool;
    var phi_924_: bool;
    var phi_946_: bool;
    var phi_947_: bool;
    var phi_960_: bool;
    var phi_961_: bool;
    var phi_962_: bool;
    var phi_969_: u32;
    var phi_970_: u32;
    var phi_971_: u32;
    var phi_972_: u32;
    var phi_973_: u32;
    var phi_974_: u32;
    var phi_975_: u32;
    var phi_987_: bool;
    var phi_988_: bool;
    var phi_989_: bool;
    var phi_990_: bool;
    var phi_994_: bool;
    var phi_1000_: bool;
    var phi_1008_: u32;
    var phi_1013_: u32;
    var phi_1022_: u32;
    var phi_1027_: u32;
    var phi_1031_: u32;
    var phi_1032_: u32;
    var phi_1033_: u32;
    var phi_1037_: f32;
    var phi_1046_: bool;
    var phi_1047_: bool;
    var phi_1049_: mask_Masked;
    var phi_1101_: doubt_Listed;
    var phi_1102_: bool;
    var phi_1115_: u32;
    var phi_1132_: u32;

    let _e52 = id_1;
    let _e53 = local_1;
    let _e58 = arrayLength((&heard.member));
    let _e67 = p.member.current.size[0u];
    let _e69 = p.member.current.size[1u];
    let _e70 = lt_shaders_entry_pixel_index(_e52, _e67, _e69);
    if (bitcast<i32>(_e70.root) != 0i) {
        let _e78 = p.member.current.size[0u];
        if (32u == 0u) {
            return;
        }
        let _e80 = (_e78 / 32u);
        if (32u == 0u) {
            return;
        }
        if ((_e78 % 32u) > 0u) {
            phi_223_ = (_e80 + 1u);
        } else {
            phi_223_ = _e80;
        }
        let _e86 = phi_223_;
        let _e89 = past.member[_e70.first_primitive];
        let _e94 = visibility.member[_e70.first_primitive];
        let _e100 = samples.member[_e70.first_primitive].normal[0u];
        let _e102 = global[0u];
        if (_e100 == _e102) {
            let _e105 = samples.member[_e70.first_primitive].normal[1u];
            let _e107 = global[1u];
            if (_e105 == _e107) {
                let _e110 = samples.member[_e70.first_primitive].normal[2u];
                let _e112 = global[2u];
                phi_260_ = (_e110 == _e112);
                phi_261_ = false;
            } else {
                phi_260_ = bool();
                phi_261_ = true;
            }
            let _e115 = phi_260_;
            let _e117 = phi_261_;
            phi_262_ = _e115;
            phi_263_ = _e117;
        } else {
            phi_262_ = bool();
            phi_263_ = true;
        }
        let _e119 = phi_262_;
        let _e121 = phi_263_;
        if _e121 {
            phi_267_ = false;
        } else {
            phi_267_ = _e119;
        }
        let _e123 = phi_267_;
        if !(_e123) {
            let _e126 = samples.member[_e70.first_primitive].position;
            let _e128 = p.member.light.place;
            let _e134 = p.member.light.place[3u];
            let _e141 = (_e128.x - (_e126.x * _e134));
            let _e142 = (_e128.y - (_e126.y * _e134));
            let _e143 = (_e128.z - (_e126.z * _e134));
            let _e145 = samples.member[_e70.first_primitive].normal;
            if ((((_e145.x * _e141) + (_e145.y * _e142)) + (_e145.z * _e143)) > 0f) {
                let _e159 = (((_e141 * _e141) + (_e142 * _e142)) + (_e143 * _e143));
                let _e161 = p.member.light.axis;
                let _e173 = p.member.light.place[3u];
                if (_e173 == 0f) {
                    phi_338_ = true;
                } else {
                    let _e176 = p.member.light.range_squared;
                    if (_e159 <= _e176) {
                        let _e179 = p.member.light.cos_outer;
                        phi_337_ = (-((((_e141 * _e161.x) + (_e142 * _e161.y)) + (_e143 * _e161.z))) >= (_e179 * sqrt(_e159)));
                    } else {
                        phi_337_ = false;
                    }
                    let _e184 = phi_337_;
                    phi_338_ = _e184;
                }
                let _e186 = phi_338_;
                if _e186 {
                    let _e188 = samples.member[_e70.first_primitive].flags;
                    let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                    phi_349_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, ((_e188 & 1u) == 0u));
                    phi_350_ = false;
                } else {
                    phi_349_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_350_ = true;
                }
                let _e207 = phi_349_;
                let _e209 = phi_350_;
                phi_351_ = _e207;
                phi_352_ = _e209;
            } else {
                phi_351_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_352_ = true;
            }
            let _e211 = phi_351_;
            let _e213 = phi_352_;
            if _e213 {
                let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e225 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e219.unnamed.visibility, false), _e219.unnamed_1);
                phi_359_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e225.unnamed, true);
            } else {
                phi_359_ = _e211;
            }
            let _e230 = phi_359_;
            phi_363_ = _e230;
        } else {
            let _e236 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e242 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e236.unnamed.visibility, false), _e236.unnamed_1);
            phi_363_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e242.unnamed, true);
        }
        let _e247 = phi_363_;
        if _e247.unnamed_1 {
            phi_1049_ = mask_Masked(_e247.unnamed.visibility, 0u, false, false);
        } else {
            let _e252 = (_e94 < 0.5f);
            if (_e94 > 0f) {
                phi_376_ = (_e94 < 1f);
            } else {
                phi_376_ = false;
            }
            let _e256 = phi_376_;
            let _e263 = lt_mask_Reprojection(vec2<u32>(_e52.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e270 = lt_mask_Reprojection(vec2<u32>(_e263.pixel.x, _e52.y), _e263.is_valid, _e263.has_moved);
            let _e274 = lt_mask_Reprojection(_e270.pixel, true, _e270.has_moved);
            let _e280 = p.member.flags;
            if ((_e280 & 16u) == 0u) {
                phi_412_ = false;
            } else {
                let _e285 = samples.member[_e70.first_primitive].position[0u];
                if (_e89.x == _e285) {
                    let _e288 = samples.member[_e70.first_primitive].position[1u];
                    if (_e89.y == _e288) {
                        let _e291 = samples.member[_e70.first_primitive].position[2u];
                        phi_404_ = (_e89.z == _e291);
                        phi_405_ = false;
                    } else {
                        phi_404_ = bool();
                        phi_405_ = true;
                    }
                    let _e294 = phi_404_;
                    let _e296 = phi_405_;
                    phi_406_ = _e294;
                    phi_407_ = _e296;
                } else {
                    phi_406_ = bool();
                    phi_407_ = true;
                }
                let _e298 = phi_406_;
                let _e300 = phi_407_;
                if _e300 {
                    phi_411_ = false;
                } else {
                    phi_411_ = _e298;
                }
                let _e302 = phi_411_;
                phi_412_ = _e302;
            }
            let _e304 = phi_412_;
            if _e304 {
                phi_717_ = lt_mask_Reprojection(_e274.pixel, _e274.is_valid, false);
                phi_718_ = lt_mask_Reprojection();
                phi_719_ = true;
            } else {
                let _e308 = p.member.current.grid[0u];
                let _e310 = p.member.current.grid[1u];
                let _e324 = (f32(_e52.x) + ((f32((_e52.y & (_e310 - 1u))) + 0.5f) / f32(_e310)));
                let _e326 = (f32(_e52.y) + ((f32((_e52.x & (_e308 - 1u))) + 0.5f) / f32(_e308)));
                let _e329 = p.member.previous.eye;
                let _e331 = (_e89.x - _e329.x);
                let _e333 = (_e89.y - _e329.y);
                let _e335 = (_e89.z - _e329.z);
                let _e337 = p.member.previous.forward;
                let _e345 = (((_e331 * _e337.x) + (_e333 * _e337.y)) + (_e335 * _e337.z));
                let _e347 = p.member.previous.right;
                let _e357 = p.member.previous.right;
                let _e372 = p.member.previous.up;
                let _e382 = p.member.previous.up;
                let _e399 = p.member.previous.size[0u];
                let _e406 = p.member.previous.size[1u];
                let _e410 = (((((((_e331 * _e347.x) + (_e333 * _e347.y)) + (_e335 * _e347.z)) / ((((_e357.x * _e357.x) + (_e357.y * _e357.y)) + (_e357.z * _e357.z)) * _e345)) + 1f) * (0.5f * f32(_e399))) - _e324);
                let _e411 = (((1f - ((((_e331 * _e372.x) + (_e333 * _e372.y)) + (_e335 * _e372.z)) / ((((_e382.x * _e382.x) + (_e382.y * _e382.y)) + (_e382.z * _e382.z)) * _e345))) * (0.5f * f32(_e406))) - _e326);
                let _e415 = p.member.current.size[0u];
                let _e417 = p.member.current.size[1u];
                let _e419 = (_e324 + _e410);
                if (_e419 > -8388608f) {
                    let _e431 = f32(select(0i, select(select(i32(_e419), i32(-2147483648), (_e419 < bitcast<f32>(3472883712u))), 2147483647i, (_e419 > bitcast<f32>(1325400063u))), (_e419 == _e419)));
                    if (_e431 > _e419) {
                        phi_548_ = 1f;
                    } else {
                        phi_548_ = 0f;
                    }
                    let _e434 = phi_548_;
                    if (_e419 < 8388608f) {
                        phi_553_ = (_e431 - _e434);
                        phi_554_ = false;
                    } else {
                        phi_553_ = f32();
                        phi_554_ = true;
                    }
                    let _e437 = phi_553_;
                    let _e439 = phi_554_;
                    phi_555_ = _e437;
                    phi_556_ = _e439;
                } else {
                    phi_555_ = f32();
                    phi_556_ = true;
                }
                let _e441 = phi_555_;
                let _e443 = phi_556_;
                if _e443 {
                    phi_560_ = _e419;
                } else {
                    phi_560_ = _e441;
                }
                let _e445 = phi_560_;
                let _e446 = (_e326 + _e411);
                if (_e446 > -8388608f) {
                    let _e458 = f32(select(0i, select(select(i32(_e446), i32(-2147483648), (_e446 < bitcast<f32>(3472883712u))), 2147483647i, (_e446 > bitcast<f32>(1325400063u))), (_e446 == _e446)));
                    if (_e458 > _e446) {
                        phi_581_ = 1f;
                    } else {
                        phi_581_ = 0f;
                    }
                    let _e461 = phi_581_;
                    if (_e446 < 8388608f) {
                        phi_586_ = (_e458 - _e461);
                        phi_587_ = false;
                    } else {
                        phi_586_ = f32();
                        phi_587_ = true;
                    }
                    let _e464 = phi_586_;
                    let _e466 = phi_587_;
                    phi_588_ = _e464;
                    phi_589_ = _e466;
                } else {
                    phi_588_ = f32();
                    phi_589_ = true;
                }
                let _e468 = phi_588_;
                let _e470 = phi_589_;
                if _e470 {
                    phi_593_ = _e446;
                } else {
                    phi_593_ = _e468;
                }
                let _e472 = phi_593_;
                if (_e445 >= 0f) {
                    if (_e472 >= 0f) {
                        if (_e445 < f32(_e415)) {
                            let _e478 = (_e472 < f32(_e417));
                            if (_e410 == 0f) {
                                phi_614_ = (_e411 == 0f);
                            } else {
                                phi_614_ = false;
                            }
                            let _e482 = phi_614_;
                            if _e478 {
                                phi_633_ = vec2<u32>(select(select(u32(_e445), 0u, (_e445 < bitcast<f32>(0u))), 4294967295u, (_e445 > bitcast<f32>(1333788671u))), select(select(u32(_e472), 0u, (_e472 < bitcast<f32>(0u))), 4294967295u, (_e472 > bitcast<f32>(1333788671u))));
                                phi_634_ = false;
                            } else {
                                phi_633_ = vec2<u32>();
                                phi_634_ = true;
                            }
                            let _e499 = phi_633_;
                            let _e501 = phi_634_;
                            phi_635_ = _e482;
                            phi_636_ = _e478;
                            phi_637_ = _e499;
                            phi_638_ = _e482;
                            phi_639_ = _e478;
                            phi_640_ = false;
                            phi_641_ = _e501;
                        } else {
                            phi_635_ = bool();
                            phi_636_ = bool();
                            phi_637_ = vec2<u32>();
                            phi_638_ = bool();
                            phi_639_ = bool();
                            phi_640_ = true;
                            phi_641_ = false;
                        }
                        let _e503 = phi_635_;
                        let _e505 = phi_636_;
                        let _e507 = phi_637_;
                        let _e509 = phi_638_;
                        let _e511 = phi_639_;
                        let _e513 = phi_640_;
                        let _e515 = phi_641_;
                        phi_642_ = _e503;
                        phi_643_ = _e505;
                        phi_644_ = _e507;
                        phi_645_ = _e509;
                        phi_646_ = _e511;
                        phi_647_ = _e513;
                        phi_648_ = _e515;
                    } else {
                        phi_642_ = bool();
                        phi_643_ = bool();
                        phi_644_ = vec2<u32>();
                        phi_645_ = bool();
                        phi_646_ = bool();
                        phi_647_ = true;
                        phi_648_ = false;
                    }
                    let _e517 = phi_642_;
                    let _e519 = phi_643_;
                    let _e521 = phi_644_;
                    let _e523 = phi_645_;
                    let _e525 = phi_646_;
                    let _e527 = phi_647_;
                    let _e529 = phi_648_;
                    phi_649_ = _e517;
                    phi_650_ = _e519;
                    phi_651_ = _e521;
                    phi_652_ = _e523;
                    phi_653_ = _e525;
                    phi_654_ = _e527;
                    phi_655_ = _e529;
                } else {
                    phi_649_ = bool();
                    phi_650_ = bool();
                    phi_651_ = vec2<u32>();
                    phi_652_ = bool();
                    phi_653_ = bool();
                    phi_654_ = true;
                    phi_655_ = false;
                }
                let _e531 = phi_649_;
                let _e533 = phi_650_;
                let _e535 = phi_651_;
                let _e537 = phi_652_;
                let _e539 = phi_653_;
                let _e541 = phi_654_;
                let _e543 = phi_655_;
                if _e541 {
                    if (_e410 == 0f) {
                        phi_664_ = (_e411 == 0f);
                    } else {
                        phi_664_ = false;
                    }
                    let _e547 = phi_664_;
                    phi_665_ = _e547;
                    phi_666_ = false;
                    phi_667_ = true;
                } else {
                    phi_665_ = _e537;
                    phi_666_ = _e539;
                    phi_667_ = _e543;
                }
                let _e549 = phi_665_;
                let _e551 = phi_666_;
                let _e553 = phi_667_;
                if _e553 {
                    phi_671_ = _e549;
                    phi_672_ = _e551;
                    phi_673_ = vec2<u32>(_e52.x, _e52.y);
                } else {
                    phi_671_ = _e531;
                    phi_672_ = _e533;
                    phi_673_ = _e535;
                }
                let _e555 = phi_671_;
                let _e557 = phi_672_;
                let _e559 = phi_673_;
                let _e569 = lt_mask_Reprojection(vec2<u32>(_e559.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e576 = lt_mask_Reprojection(vec2<u32>(_e569.pixel.x, _e559.y), _e569.is_valid, _e569.has_moved);
                let _e580 = lt_mask_Reprojection(_e576.pixel, _e557, _e576.has_moved);
                let _e584 = lt_mask_Reprojection(_e580.pixel, _e580.is_valid, !(_e555));
                if _e557 {
                    let _e587 = p.member.previous.eye;
                    let _e595 = p.member.previous.forward;
                    let _e604 = (((((_e89.x - _e587.x) * _e595.x) + ((_e89.y - _e587.y) * _e595.y)) + ((_e89.z - _e587.z) * _e595.z)) > 0f);
                    let _e608 = lt_mask_Reprojection(_e584.pixel, _e604, _e584.has_moved);
                    if _e604 {
                        phi_708_ = false;
                    } else {
                        phi_708_ = true;
                    }
                    let _e610 = phi_708_;
                    phi_710_ = _e608;
                    phi_711_ = _e608;
                    phi_712_ = _e610;
                } else {
                    phi_710_ = lt_mask_Reprojection();
                    phi_711_ = lt_mask_Reprojection(_e584.pixel, false, _e584.has_moved);
                    phi_712_ = true;
                }
                let _e616 = phi_710_;
                let _e618 = phi_711_;
                let _e620 = phi_712_;
                if _e620 {
                    phi_716_ = false;
                } else {
                    phi_716_ = true;
                }
                let _e622 = phi_716_;
                phi_717_ = _e616;
                phi_718_ = _e618;
                phi_719_ = _e622;
            }
            let _e624 = phi_717_;
            let _e626 = phi_718_;
            let _e628 = phi_719_;
            if _e628 {
                let _e630 = p.member.flags;
                phi_727_ = ((_e630 & 1u) != 0u);
                phi_728_ = _e624;
            } else {
                phi_727_ = false;
                phi_728_ = _e626;
            }
            let _e634 = phi_727_;
            let _e636 = phi_728_;
            let _e640 = lt_mask_Reprojection(_e636.pixel, _e634, _e636.has_moved);
            let _e642 = p.member.flags;
            let _e644 = ((_e642 & 2u) != 0u);
            let _e646 = p.member.flags;
            if ((_e646 & 4u) == 0u) {
                phi_806_ = u32();
                phi_807_ = true;
                phi_808_ = false;
            } else {
                if _e634 {
                    if !(_e640.has_moved) {
                        let _e655 = ((((_e52.y * _e86) + (_e52.x / 32u)) * 6u) + 4u);
                        if (_e655 < _e58) {
                        } else {
                            return;
                        }
                        let _e659 = heard.member[(0u + _e655)];
                        if (((_e659 >> bitcast<u32>(((_e52.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e670 = ((((_e52.y * _e86) + (_e52.x / 32u)) * 6u) + 5u);
                            if (_e670 < _e58) {
                            } else {
                                return;
                            }
                            let _e674 = heard.member[(0u + _e670)];
                            if false {
                                phi_794_ = (2u | 1u);
                            } else {
                                phi_794_ = 2u;
                            }
                            let _e683 = phi_794_;
                            if (((_e674 >> bitcast<u32>(((_e52.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_799_ = (_e683 | 4u);
                            } else {
                                phi_799_ = _e683;
                            }
                            let _e686 = phi_799_;
                            phi_800_ = _e686;
                        } else {
                            phi_800_ = 0u;
                        }
                        let _e688 = phi_800_;
                        phi_801_ = _e688;
                        phi_802_ = false;
                    } else {
                        phi_801_ = u32();
                        phi_802_ = true;
                    }
                    let _e690 = phi_801_;
                    let _e692 = phi_802_;
                    phi_803_ = _e690;
                    phi_804_ = false;
                    phi_805_ = _e692;
                } else {
                    phi_803_ = u32();
                    phi_804_ = true;
                    phi_805_ = false;
                }
                let _e694 = phi_803_;
                let _e696 = phi_804_;
                let _e698 = phi_805_;
                phi_806_ = _e694;
                phi_807_ = _e696;
                phi_808_ = _e698;
            }
            let _e700 = phi_806_;
            let _e702 = phi_807_;
            let _e704 = phi_808_;
            if _e702 {
                phi_812_ = true;
            } else {
                phi_812_ = _e704;
            }
            let _e706 = phi_812_;
            if _e706 {
                phi_816_ = 0u;
            } else {
                phi_816_ = _e700;
            }
            let _e708 = phi_816_;
            let _e709 = lt_mask_Neighbourhood(false, true);
            if _e256 {
                phi_821_ = _e644;
            } else {
                phi_821_ = true;
            }
            let _e711 = phi_821_;
            if _e711 {
                if _e634 {
                    if ((_e708 & 2u) != 0u) {
                        phi_861_ = _e709;
                    } else {
                        let _e728 = ((((_e640.pixel.y * _e86) + (_e640.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e252) | (select(0u, 1u, _e640.has_moved) << bitcast<u32>(1i))));
                        if (_e728 < _e58) {
                        } else {
                            return;
                        }
                        let _e732 = heard.member[(0u + _e728)];
                        let _e738 = (((_e732 >> bitcast<u32>(((_e640.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_861_ = lt_mask_Neighbourhood(_e738, !(_e738));
                    }
                    let _e742 = phi_861_;
                    phi_862_ = _e742;
                } else {
                    phi_862_ = _e709;
                }
                let _e744 = phi_862_;
                phi_863_ = _e744;
            } else {
                phi_863_ = _e709;
            }
            let _e746 = phi_863_;
            let _e749 = p.member.frame;
            let _e751 = p.member.refresh;
            if (_e751 == 0u) {
                phi_896_ = false;
            } else {
                if (_e751 == 0u) {
                    return;
                }
                let _e760 = ((_e52.x + (_e52.y * (((_e751 * 5u) / 8u) | 1u))) + (_e749 % _e751));
                if (_e751 == 0u) {
                    phi_895_ = (_e760 == 0u);
                } else {
                    if (_e751 == 0u) {
                        return;
                    }
                    phi_895_ = ((_e760 % _e751) == 0u);
                }
                let _e767 = phi_895_;
                phi_896_ = _e767;
            }
            let _e769 = phi_896_;
            if _e634 {
                if _e769 {
                    phi_918_ = bool();
                } else {
                    phi_918_ = ((_e708 & 2u) != 0u);
                }
                let _e775 = phi_918_;
                phi_919_ = _e775;
                phi_920_ = _e769;
            } else {
                phi_919_ = bool();
                phi_920_ = true;
            }
            let _e777 = phi_919_;
            let _e779 = phi_920_;
            if _e779 {
                phi_924_ = false;
            } else {
                phi_924_ = _e777;
            }
            let _e781 = phi_924_;
            if _e781 {
                phi_975_ = 7u;
            } else {
                if (_e94 != 0.5f) {
                    if _e634 {
                        if _e769 {
                            phi_972_ = 6u;
                        } else {
                            if _e256 {
                                phi_947_ = true;
                            } else {
                                if _e746.any_expands {
                                    phi_946_ = false;
                                } else {
                                    phi_946_ = true;
                                }
                                let _e783 = phi_946_;
                                phi_947_ = _e783;
                            }
                            let _e785 = phi_947_;
                            if _e785 {
                                if _e256 {
                                    if _e644 {
                                        if _e746.all_remove {
                                            phi_960_ = false;
                                        } else {
                                            phi_960_ = true;
                                        }
                                        let _e787 = phi_960_;
                                        phi_961_ = _e787;
                                    } else {
                                        phi_961_ = true;
                                    }
                                    let _e789 = phi_961_;
                                    phi_962_ = _e789;
                                } else {
                                    phi_962_ = true;
                                }
                                let _e791 = phi_962_;
                                if _e791 {
                                    if _e256 {
                                        phi_969_ = 1u;
                                    } else {
                                        phi_969_ = 0u;
                                    }
                                    let _e793 = phi_969_;
                                    phi_970_ = _e793;
                                } else {
                                    phi_970_ = 5u;
                                }
                                let _e795 = phi_970_;
                                phi_971_ = _e795;
                            } else {
                                phi_971_ = 4u;
                            }
                            let _e797 = phi_971_;
                            phi_972_ = _e797;
                        }
                        let _e799 = phi_972_;
                        phi_973_ = _e799;
                    } else {
                        phi_973_ = 3u;
                    }
                    let _e801 = phi_973_;
                    phi_974_ = _e801;
                } else {
                    phi_974_ = 2u;
                }
                let _e803 = phi_974_;
                phi_975_ = _e803;
            }
            let _e805 = phi_975_;
            if !((_e805 == 0u)) {
                if !((_e805 == 5u)) {
                    phi_987_ = !(_e781);
                    phi_988_ = false;
                } else {
                    phi_987_ = bool();
                    phi_988_ = true;
                }
                let _e812 = phi_987_;
                let _e814 = phi_988_;
                phi_989_ = _e812;
                phi_990_ = _e814;
            } else {
                phi_989_ = bool();
                phi_990_ = true;
            }
            let _e816 = phi_989_;
            let _e818 = phi_990_;
            if _e818 {
                phi_994_ = false;
            } else {
                phi_994_ = _e816;
            }
            let _e820 = phi_994_;
            if _e781 {
                phi_1000_ = ((_e708 & 4u) != 0u);
            } else {
                phi_1000_ = _e252;
            }
            let _e824 = phi_1000_;
            if _e820 {
                if _e252 {
                    phi_1008_ = (2u | 1u);
                } else {
                    phi_1008_ = 2u;
                }
                let _e827 = phi_1008_;
                if false {
                    phi_1013_ = (_e827 | 4u);
                } else {
                    phi_1013_ = _e827;
                }
                let _e830 = phi_1013_;
                phi_1033_ = _e830;
            } else {
                if (_e805 == 7u) {
                    if _e252 {
                        phi_1022_ = (2u | 1u);
                    } else {
                        phi_1022_ = 2u;
                    }
                    let _e834 = phi_1022_;
                    if _e824 {
                        phi_1027_ = (_e834 | 4u);
                    } else {
                        phi_1027_ = _e834;
                    }
                    let _e837 = phi_1027_;
                    phi_1032_ = _e837;
                } else {
                    if _e252 {
                        phi_1031_ = 1u;
                    } else {
                        phi_1031_ = 0u;
                    }
                    let _e839 = phi_1031_;
                    phi_1032_ = _e839;
                }
                let _e841 = phi_1032_;
                phi_1033_ = _e841;
            }
            let _e843 = phi_1033_;
            if _e824 {
                phi_1037_ = 0f;
            } else {
                phi_1037_ = 1f;
            }
            let _e845 = phi_1037_;
            if _e256 {
                if (_e94 == 0.99999994f) {
                    phi_1046_ = true;
                } else {
                    phi_1046_ = (_e94 == 0.000000059604645f);
                }
                let _e849 = phi_1046_;
                phi_1047_ = _e849;
            } else {
                phi_1047_ = true;
            }
            let _e851 = phi_1047_;
            phi_1049_ = mask_Masked(_e845, _e843, _e820, _e851);
        }
        let _e854 = phi_1049_;
        visibility.member[_e70.first_primitive] = _e854.visibility;
        let _e859 = p.member.light.number;
        let _e860 = (_e859 * 3u);
        let _e862 = (_e860 % 32u);
        let _e864 = p.member.light.mask_words;
        let _e866 = ((_e70.first_primitive * _e864) + (_e860 / 32u));
        let _e868 = bits.member[_e866];
        bits.member[_e866] = ((_e868 & ~((7u << bitcast<u32>((_e862 & 31u))))) | (_e854.bits << bitcast<u32>((_e862 & 31u))));
        if (_e862 > 29u) {
            let _e883 = bits.member[(_e866 + 1u)];
            let _e885 = (32u - _e862);
            bits.member[(_e866 + 1u)] = ((_e883 & ~((7u >> bitcast<u32>((_e885 & 31u))))) | (_e854.bits >> bitcast<u32>((_e885 & 31u))));
        }
        phi_1101_ = doubt_Listed(_e70.first_primitive, _e854.is_trusted);
        phi_1102_ = _e854.needs_ray;
    } else {
        phi_1101_ = doubt_Listed(0u, false);
        phi_1102_ = false;
    }
    let _e901 = phi_1101_;
    let _e903 = phi_1102_;
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e903 {
        let _e909 = atomicAdd((&shared_[0u]), 1u);
        phi_1115_ = _e909;
    } else {
        phi_1115_ = 0u;
    }
    let _e911 = phi_1115_;
    workgroupBarrier();
    if (_e53 == 0u) {
        let _e915 = atomicLoad((&shared_[0u]));
        let _e916 = atomicAdd((&list.member[3u]), _e915);
        atomicStore((&shared_[1u]), _e916);
    }
    workgroupBarrier();
    if _e903 {
        if _e901.is_trusted {
            phi_1132_ = (_e901.pixel | 2147483648u);
        } else {
            phi_1132_ = _e901.pixel;
        }
        let _e920 = phi_1132_;
        let _e922 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e922) + _e911)]), _e920);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
