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
    var phi_167_: lt_bvh_traverse_Tree;
    var phi_168_: bool;
    var phi_169_: lt_bvh_traverse_Tree;
    var phi_170_: bool;
    var phi_175_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_167_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_168_ = false;
        } else {
            phi_167_ = lt_bvh_traverse_Tree();
            phi_168_ = true;
        }
        let _e64 = phi_167_;
        let _e66 = phi_168_;
        phi_169_ = _e64;
        phi_170_ = _e66;
    } else {
        phi_169_ = lt_bvh_traverse_Tree();
        phi_170_ = true;
    }
    let _e68 = phi_169_;
    let _e70 = phi_170_;
    if _e70 {
        phi_175_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_175_ = _e68;
    }
    let _e75 = phi_175_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn function_() {
    var phi_222_: u32;
    var phi_259_: bool;
    var phi_260_: bool;
    var phi_261_: bool;
    var phi_262_: bool;
    var phi_266_: bool;
    var phi_336_: bool;
    var phi_337_: bool;
    var phi_348_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_349_: bool;
    var phi_350_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_351_: bool;
    var phi_358_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_362_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_375_: bool;
    var phi_403_: bool;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_410_: bool;
    var phi_411_: bool;
    var phi_554_: f32;
    var phi_559_: f32;
    var phi_560_: bool;
    var phi_561_: f32;
    var phi_562_: bool;
    var phi_566_: f32;
    var phi_587_: f32;
    var phi_592_: f32;
    var phi_593_: bool;
    var phi_594_: f32;
    var phi_595_: bool;
    var phi_599_: f32;
    var phi_620_: bool;
    var phi_639_: vec2<u32>;
    var phi_640_: bool;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_643_: vec2<u32>;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_650_: vec2<u32>;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_655_: bool;
    var phi_656_: bool;
    var phi_657_: vec2<u32>;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_670_: bool;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_673_: bool;
    var phi_677_: bool;
    var phi_678_: bool;
    var phi_679_: vec2<u32>;
    var phi_714_: bool;
    var phi_716_: lt_mask_Reprojection;
    var phi_717_: lt_mask_Reprojection;
    var phi_718_: bool;
    var phi_722_: bool;
    var phi_723_: lt_mask_Reprojection;
    var phi_724_: lt_mask_Reprojection;
    var phi_725_: bool;
    var phi_733_: bool;
    var phi_734_: lt_mask_Reprojection;
    var phi_740_: bool;
    var phi_780_: lt_mask_Neighbourhood;
    var phi_781_: lt_mask_Neighbourhood;
    var phi_782_: lt_mask_Neighbourhood;
    var phi_814_: bool;
    var phi_815_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_843_: bool;
    var phi_865_: bool;
    var phi_866_: bool;
    var phi_879_: bool;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_888_: u32;
    var phi_889_: u32;
    var phi_890_: u32;
    var phi_891_: u32;
    var phi_892_: u32;
    var phi_893_: u32;
    var phi_894_: u32;
    var phi_906_: bool;
    var phi_907_: bool;
    var phi_908_: bool;
    var phi_909_: bool;
    var phi_913_: bool;
    var phi_919_: bool;
    var phi_927_: u32;
    var phi_932_: u32;
    var phi_941_: u32;
    var phi_946_: u32;
    var phi_950_: u32;
    var phi_951_: u32;
    var phi_952_: u32;
    var phi_956_: f32;
    var phi_965_: bool;
    var phi_966_: bool;
    var phi_968_: mask_Masked;
    var phi_1020_: doubt_Listed;
    var phi_1021_: bool;
    var phi_1034_: u32;
    var phi_1051_: u32;

    let _e51 = id_1;
    let _e52 = local_1;
    let _e66 = p.member.current.size[0u];
    let _e68 = p.member.current.size[1u];
    let _e69 = lt_shaders_entry_pixel_index(_e51, _e66, _e68);
    if (bitcast<i32>(_e69.root) != 0i) {
        let _e77 = p.member.current.size[0u];
        if (32u == 0u) {
            return;
        }
        let _e79 = (_e77 / 32u);
        if (32u == 0u) {
            return;
        }
        if ((_e77 % 32u) > 0u) {
            phi_222_ = (_e79 + 1u);
        } else {
            phi_222_ = _e79;
        }
        let _e85 = phi_222_;
        let _e88 = past.member[_e69.first_primitive];
        let _e93 = visibility.member[_e69.first_primitive];
        let _e99 = samples.member[_e69.first_primitive].normal[0u];
        let _e101 = global[0u];
        if (_e99 == _e101) {
            let _e104 = samples.member[_e69.first_primitive].normal[1u];
            let _e106 = global[1u];
            if (_e104 == _e106) {
                let _e109 = samples.member[_e69.first_primitive].normal[2u];
                let _e111 = global[2u];
                phi_259_ = (_e109 == _e111);
                phi_260_ = false;
            } else {
                phi_259_ = bool();
                phi_260_ = true;
            }
            let _e114 = phi_259_;
            let _e116 = phi_260_;
            phi_261_ = _e114;
            phi_262_ = _e116;
        } else {
            phi_261_ = bool();
            phi_262_ = true;
        }
        let _e118 = phi_261_;
        let _e120 = phi_262_;
        if _e120 {
            phi_266_ = false;
        } else {
            phi_266_ = _e118;
        }
        let _e122 = phi_266_;
        if !(_e122) {
            let _e125 = samples.member[_e69.first_primitive].position;
            let _e127 = p.member.light.place;
            let _e133 = p.member.light.place[3u];
            let _e140 = (_e127.x - (_e125.x * _e133));
            let _e141 = (_e127.y - (_e125.y * _e133));
            let _e142 = (_e127.z - (_e125.z * _e133));
            let _e144 = samples.member[_e69.first_primitive].normal;
            if ((((_e144.x * _e140) + (_e144.y * _e141)) + (_e144.z * _e142)) > 0f) {
                let _e158 = (((_e140 * _e140) + (_e141 * _e141)) + (_e142 * _e142));
                let _e160 = p.member.light.axis;
                let _e172 = p.member.light.place[3u];
                if (_e172 == 0f) {
                    phi_337_ = true;
                } else {
                    let _e175 = p.member.light.range_squared;
                    if (_e158 <= _e175) {
                        let _e178 = p.member.light.cos_outer;
                        phi_336_ = (-((((_e140 * _e160.x) + (_e141 * _e160.y)) + (_e142 * _e160.z))) >= (_e178 * sqrt(_e158)));
                    } else {
                        phi_336_ = false;
                    }
                    let _e183 = phi_336_;
                    phi_337_ = _e183;
                }
                let _e185 = phi_337_;
                if _e185 {
                    let _e187 = samples.member[_e69.first_primitive].flags;
                    let _e195 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e195.unnamed.visibility, false), _e195.unnamed_1);
                    phi_348_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e201.unnamed, ((_e187 & 1u) == 0u));
                    phi_349_ = false;
                } else {
                    phi_348_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_349_ = true;
                }
                let _e206 = phi_348_;
                let _e208 = phi_349_;
                phi_350_ = _e206;
                phi_351_ = _e208;
            } else {
                phi_350_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_351_ = true;
            }
            let _e210 = phi_350_;
            let _e212 = phi_351_;
            if _e212 {
                let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e224 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e218.unnamed.visibility, false), _e218.unnamed_1);
                phi_358_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e224.unnamed, true);
            } else {
                phi_358_ = _e210;
            }
            let _e229 = phi_358_;
            phi_362_ = _e229;
        } else {
            let _e235 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e241 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e235.unnamed.visibility, false), _e235.unnamed_1);
            phi_362_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e241.unnamed, true);
        }
        let _e246 = phi_362_;
        if _e246.unnamed_1 {
            phi_968_ = mask_Masked(_e246.unnamed.visibility, 0u, false, false);
        } else {
            let _e251 = (_e93 < 0.5f);
            if (_e93 > 0f) {
                phi_375_ = (_e93 < 1f);
            } else {
                phi_375_ = false;
            }
            let _e255 = phi_375_;
            let _e262 = lt_mask_Reprojection(vec2<u32>(_e51.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e269 = lt_mask_Reprojection(vec2<u32>(_e262.pixel.x, _e51.y), _e262.is_valid, _e262.has_moved);
            let _e273 = lt_mask_Reprojection(_e269.pixel, true, _e269.has_moved);
            let _e279 = p.member.flags;
            if ((_e279 & 16u) == 0u) {
                phi_411_ = false;
            } else {
                let _e284 = samples.member[_e69.first_primitive].position[0u];
                if (_e88.x == _e284) {
                    let _e287 = samples.member[_e69.first_primitive].position[1u];
                    if (_e88.y == _e287) {
                        let _e290 = samples.member[_e69.first_primitive].position[2u];
                        phi_403_ = (_e88.z == _e290);
                        phi_404_ = false;
                    } else {
                        phi_403_ = bool();
                        phi_404_ = true;
                    }
                    let _e293 = phi_403_;
                    let _e295 = phi_404_;
                    phi_405_ = _e293;
                    phi_406_ = _e295;
                } else {
                    phi_405_ = bool();
                    phi_406_ = true;
                }
                let _e297 = phi_405_;
                let _e299 = phi_406_;
                if _e299 {
                    phi_410_ = false;
                } else {
                    phi_410_ = _e297;
                }
                let _e301 = phi_410_;
                phi_411_ = _e301;
            }
            let _e303 = phi_411_;
            if _e303 {
                phi_723_ = lt_mask_Reprojection(_e273.pixel, _e273.is_valid, false);
                phi_724_ = lt_mask_Reprojection();
                phi_725_ = true;
            } else {
                let _e307 = p.member.current.grid[0u];
                let _e309 = p.member.current.grid[1u];
                let _e323 = (f32(_e51.x) + ((f32((_e51.y & (_e309 - 1u))) + 0.5f) / f32(_e309)));
                let _e325 = (f32(_e51.y) + ((f32((_e51.x & (_e307 - 1u))) + 0.5f) / f32(_e307)));
                let _e328 = p.member.previous.eye;
                let _e330 = (_e88.x - _e328.x);
                let _e332 = (_e88.y - _e328.y);
                let _e334 = (_e88.z - _e328.z);
                let _e336 = p.member.previous.forward;
                let _e345 = (1f / (((_e330 * _e336.x) + (_e332 * _e336.y)) + (_e334 * _e336.z)));
                let _e347 = p.member.previous.right;
                let _e349 = p.member.previous.right;
                let _e361 = (1f / (((_e349.x * _e349.x) + (_e349.y * _e349.y)) + (_e349.z * _e349.z)));
                let _e369 = p.member.previous.up;
                let _e371 = p.member.previous.up;
                let _e383 = (1f / (((_e371.x * _e371.x) + (_e371.y * _e371.y)) + (_e371.z * _e371.z)));
                let _e405 = p.member.previous.size[0u];
                let _e412 = p.member.previous.size[1u];
                let _e416 = (((((((_e330 * (_e347.x * _e361)) + (_e332 * (_e347.y * _e361))) + (_e334 * (_e347.z * _e361))) * _e345) + 1f) * (0.5f * f32(_e405))) - _e323);
                let _e417 = (((1f - ((((_e330 * (_e369.x * _e383)) + (_e332 * (_e369.y * _e383))) + (_e334 * (_e369.z * _e383))) * _e345)) * (0.5f * f32(_e412))) - _e325);
                let _e421 = p.member.current.size[0u];
                let _e423 = p.member.current.size[1u];
                let _e425 = (_e323 + _e416);
                if (_e425 > -8388608f) {
                    let _e437 = f32(select(0i, select(select(i32(_e425), i32(-2147483648), (_e425 < bitcast<f32>(3472883712u))), 2147483647i, (_e425 > bitcast<f32>(1325400063u))), (_e425 == _e425)));
                    if (_e437 > _e425) {
                        phi_554_ = 1f;
                    } else {
                        phi_554_ = 0f;
                    }
                    let _e440 = phi_554_;
                    if (_e425 < 8388608f) {
                        phi_559_ = (_e437 - _e440);
                        phi_560_ = false;
                    } else {
                        phi_559_ = f32();
                        phi_560_ = true;
                    }
                    let _e443 = phi_559_;
                    let _e445 = phi_560_;
                    phi_561_ = _e443;
                    phi_562_ = _e445;
                } else {
                    phi_561_ = f32();
                    phi_562_ = true;
                }
                let _e447 = phi_561_;
                let _e449 = phi_562_;
                if _e449 {
                    phi_566_ = _e425;
                } else {
                    phi_566_ = _e447;
                }
                let _e451 = phi_566_;
                let _e452 = (_e325 + _e417);
                if (_e452 > -8388608f) {
                    let _e464 = f32(select(0i, select(select(i32(_e452), i32(-2147483648), (_e452 < bitcast<f32>(3472883712u))), 2147483647i, (_e452 > bitcast<f32>(1325400063u))), (_e452 == _e452)));
                    if (_e464 > _e452) {
                        phi_587_ = 1f;
                    } else {
                        phi_587_ = 0f;
                    }
                    let _e467 = phi_587_;
                    if (_e452 < 8388608f) {
                        phi_592_ = (_e464 - _e467);
                        phi_593_ = false;
                    } else {
                        phi_592_ = f32();
                        phi_593_ = true;
                    }
                    let _e470 = phi_592_;
                    let _e472 = phi_593_;
                    phi_594_ = _e470;
                    phi_595_ = _e472;
                } else {
                    phi_594_ = f32();
                    phi_595_ = true;
                }
                let _e474 = phi_594_;
                let _e476 = phi_595_;
                if _e476 {
                    phi_599_ = _e452;
                } else {
                    phi_599_ = _e474;
                }
                let _e478 = phi_599_;
                if (_e451 >= 0f) {
                    if (_e478 >= 0f) {
                        if (_e451 < f32(_e421)) {
                            let _e484 = (_e478 < f32(_e423));
                            if (_e416 == 0f) {
                                phi_620_ = (_e417 == 0f);
                            } else {
                                phi_620_ = false;
                            }
                            let _e488 = phi_620_;
                            if _e484 {
                                phi_639_ = vec2<u32>(select(select(u32(_e451), 0u, (_e451 < bitcast<f32>(0u))), 4294967295u, (_e451 > bitcast<f32>(1333788671u))), select(select(u32(_e478), 0u, (_e478 < bitcast<f32>(0u))), 4294967295u, (_e478 > bitcast<f32>(1333788671u))));
                                phi_640_ = false;
                            } else {
                                phi_639_ = vec2<u32>();
                                phi_640_ = true;
                            }
                            let _e505 = phi_639_;
                            let _e507 = phi_640_;
                            phi_641_ = _e488;
                            phi_642_ = _e484;
                            phi_643_ = _e505;
                            phi_644_ = _e488;
                            phi_645_ = _e484;
                            phi_646_ = false;
                            phi_647_ = _e507;
                        } else {
                            phi_641_ = bool();
                            phi_642_ = bool();
                            phi_643_ = vec2<u32>();
                            phi_644_ = bool();
                            phi_645_ = bool();
                            phi_646_ = true;
                            phi_647_ = false;
                        }
                        let _e509 = phi_641_;
                        let _e511 = phi_642_;
                        let _e513 = phi_643_;
                        let _e515 = phi_644_;
                        let _e517 = phi_645_;
                        let _e519 = phi_646_;
                        let _e521 = phi_647_;
                        phi_648_ = _e509;
                        phi_649_ = _e511;
                        phi_650_ = _e513;
                        phi_651_ = _e515;
                        phi_652_ = _e517;
                        phi_653_ = _e519;
                        phi_654_ = _e521;
                    } else {
                        phi_648_ = bool();
                        phi_649_ = bool();
                        phi_650_ = vec2<u32>();
                        phi_651_ = bool();
                        phi_652_ = bool();
                        phi_653_ = true;
                        phi_654_ = false;
                    }
                    let _e523 = phi_648_;
                    let _e525 = phi_649_;
                    let _e527 = phi_650_;
                    let _e529 = phi_651_;
                    let _e531 = phi_652_;
                    let _e533 = phi_653_;
                    let _e535 = phi_654_;
                    phi_655_ = _e523;
                    phi_656_ = _e525;
                    phi_657_ = _e527;
                    phi_658_ = _e529;
                    phi_659_ = _e531;
                    phi_660_ = _e533;
                    phi_661_ = _e535;
                } else {
                    phi_655_ = bool();
                    phi_656_ = bool();
                    phi_657_ = vec2<u32>();
                    phi_658_ = bool();
                    phi_659_ = bool();
                    phi_660_ = true;
                    phi_661_ = false;
                }
                let _e537 = phi_655_;
                let _e539 = phi_656_;
                let _e541 = phi_657_;
                let _e543 = phi_658_;
                let _e545 = phi_659_;
                let _e547 = phi_660_;
                let _e549 = phi_661_;
                if _e547 {
                    if (_e416 == 0f) {
                        phi_670_ = (_e417 == 0f);
                    } else {
                        phi_670_ = false;
                    }
                    let _e553 = phi_670_;
                    phi_671_ = _e553;
                    phi_672_ = false;
                    phi_673_ = true;
                } else {
                    phi_671_ = _e543;
                    phi_672_ = _e545;
                    phi_673_ = _e549;
                }
                let _e555 = phi_671_;
                let _e557 = phi_672_;
                let _e559 = phi_673_;
                if _e559 {
                    phi_677_ = _e555;
                    phi_678_ = _e557;
                    phi_679_ = vec2<u32>(_e51.x, _e51.y);
                } else {
                    phi_677_ = _e537;
                    phi_678_ = _e539;
                    phi_679_ = _e541;
                }
                let _e561 = phi_677_;
                let _e563 = phi_678_;
                let _e565 = phi_679_;
                let _e575 = lt_mask_Reprojection(vec2<u32>(_e565.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e582 = lt_mask_Reprojection(vec2<u32>(_e575.pixel.x, _e565.y), _e575.is_valid, _e575.has_moved);
                let _e586 = lt_mask_Reprojection(_e582.pixel, _e563, _e582.has_moved);
                let _e590 = lt_mask_Reprojection(_e586.pixel, _e586.is_valid, !(_e561));
                if _e563 {
                    let _e593 = p.member.previous.eye;
                    let _e601 = p.member.previous.forward;
                    let _e610 = (((((_e88.x - _e593.x) * _e601.x) + ((_e88.y - _e593.y) * _e601.y)) + ((_e88.z - _e593.z) * _e601.z)) > 0f);
                    let _e614 = lt_mask_Reprojection(_e590.pixel, _e610, _e590.has_moved);
                    if _e610 {
                        phi_714_ = false;
                    } else {
                        phi_714_ = true;
                    }
                    let _e616 = phi_714_;
                    phi_716_ = _e614;
                    phi_717_ = _e614;
                    phi_718_ = _e616;
                } else {
                    phi_716_ = lt_mask_Reprojection();
                    phi_717_ = lt_mask_Reprojection(_e590.pixel, false, _e590.has_moved);
                    phi_718_ = true;
                }
                let _e622 = phi_716_;
                let _e624 = phi_717_;
                let _e626 = phi_718_;
                if _e626 {
                    phi_722_ = false;
                } else {
                    phi_722_ = true;
                }
                let _e628 = phi_722_;
                phi_723_ = _e622;
                phi_724_ = _e624;
                phi_725_ = _e628;
            }
            let _e630 = phi_723_;
            let _e632 = phi_724_;
            let _e634 = phi_725_;
            if _e634 {
                let _e636 = p.member.flags;
                phi_733_ = ((_e636 & 1u) != 0u);
                phi_734_ = _e630;
            } else {
                phi_733_ = false;
                phi_734_ = _e632;
            }
            let _e640 = phi_733_;
            let _e642 = phi_734_;
            let _e646 = lt_mask_Reprojection(_e642.pixel, _e640, _e642.has_moved);
            let _e647 = lt_mask_Neighbourhood(false, true);
            if _e255 {
                phi_740_ = false;
            } else {
                phi_740_ = true;
            }
            let _e649 = phi_740_;
            if _e649 {
                if _e640 {
                    if ((0u & 2u) != 0u) {
                        phi_780_ = _e647;
                    } else {
                        let _e666 = ((((_e646.pixel.y * _e85) + (_e646.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e251) | (select(0u, 1u, _e646.has_moved) << bitcast<u32>(1i))));
                        if (_e666 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e670 = heard.member[(0u + _e666)];
                        let _e676 = (((_e670 >> bitcast<u32>(((_e646.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_780_ = lt_mask_Neighbourhood(_e676, !(_e676));
                    }
                    let _e680 = phi_780_;
                    phi_781_ = _e680;
                } else {
                    phi_781_ = _e647;
                }
                let _e682 = phi_781_;
                phi_782_ = _e682;
            } else {
                phi_782_ = _e647;
            }
            let _e684 = phi_782_;
            let _e687 = p.member.frame;
            let _e689 = p.member.refresh;
            if (_e689 == 0u) {
                phi_815_ = false;
            } else {
                if (_e689 == 0u) {
                    return;
                }
                let _e698 = ((_e51.x + (_e51.y * (((_e689 * 5u) / 8u) | 1u))) + (_e687 % _e689));
                if (_e689 == 0u) {
                    phi_814_ = (_e698 == 0u);
                } else {
                    if (_e689 == 0u) {
                        return;
                    }
                    phi_814_ = ((_e698 % _e689) == 0u);
                }
                let _e705 = phi_814_;
                phi_815_ = _e705;
            }
            let _e707 = phi_815_;
            if _e640 {
                if _e707 {
                    phi_837_ = bool();
                } else {
                    phi_837_ = ((0u & 2u) != 0u);
                }
                let _e713 = phi_837_;
                phi_838_ = _e713;
                phi_839_ = _e707;
            } else {
                phi_838_ = bool();
                phi_839_ = true;
            }
            let _e715 = phi_838_;
            let _e717 = phi_839_;
            if _e717 {
                phi_843_ = false;
            } else {
                phi_843_ = _e715;
            }
            let _e719 = phi_843_;
            if _e719 {
                phi_894_ = 7u;
            } else {
                if (_e93 != 0.5f) {
                    if _e640 {
                        if _e707 {
                            phi_891_ = 6u;
                        } else {
                            if _e255 {
                                phi_866_ = true;
                            } else {
                                if _e684.any_expands {
                                    phi_865_ = false;
                                } else {
                                    phi_865_ = true;
                                }
                                let _e721 = phi_865_;
                                phi_866_ = _e721;
                            }
                            let _e723 = phi_866_;
                            if _e723 {
                                if _e255 {
                                    if false {
                                        if _e684.all_remove {
                                            phi_879_ = false;
                                        } else {
                                            phi_879_ = true;
                                        }
                                        let _e725 = phi_879_;
                                        phi_880_ = _e725;
                                    } else {
                                        phi_880_ = true;
                                    }
                                    let _e727 = phi_880_;
                                    phi_881_ = _e727;
                                } else {
                                    phi_881_ = true;
                                }
                                let _e729 = phi_881_;
                                if _e729 {
                                    if _e255 {
                                        phi_888_ = 1u;
                                    } else {
                                        phi_888_ = 0u;
                                    }
                                    let _e731 = phi_888_;
                                    phi_889_ = _e731;
                                } else {
                                    phi_889_ = 5u;
                                }
                                let _e733 = phi_889_;
                                phi_890_ = _e733;
                            } else {
                                phi_890_ = 4u;
                            }
                            let _e735 = phi_890_;
                            phi_891_ = _e735;
                        }
                        let _e737 = phi_891_;
                        phi_892_ = _e737;
                    } else {
                        phi_892_ = 3u;
                    }
                    let _e739 = phi_892_;
                    phi_893_ = _e739;
                } else {
                    phi_893_ = 2u;
                }
                let _e741 = phi_893_;
                phi_894_ = _e741;
            }
            let _e743 = phi_894_;
            if !((_e743 == 0u)) {
                if !((_e743 == 5u)) {
                    phi_906_ = !(_e719);
                    phi_907_ = false;
                } else {
                    phi_906_ = bool();
                    phi_907_ = true;
                }
                let _e750 = phi_906_;
                let _e752 = phi_907_;
                phi_908_ = _e750;
                phi_909_ = _e752;
            } else {
                phi_908_ = bool();
                phi_909_ = true;
            }
            let _e754 = phi_908_;
            let _e756 = phi_909_;
            if _e756 {
                phi_913_ = false;
            } else {
                phi_913_ = _e754;
            }
            let _e758 = phi_913_;
            if _e719 {
                phi_919_ = ((0u & 4u) != 0u);
            } else {
                phi_919_ = _e251;
            }
            let _e762 = phi_919_;
            if _e758 {
                if _e251 {
                    phi_927_ = (2u | 1u);
                } else {
                    phi_927_ = 2u;
                }
                let _e765 = phi_927_;
                if false {
                    phi_932_ = (_e765 | 4u);
                } else {
                    phi_932_ = _e765;
                }
                let _e768 = phi_932_;
                phi_952_ = _e768;
            } else {
                if (_e743 == 7u) {
                    if _e251 {
                        phi_941_ = (2u | 1u);
                    } else {
                        phi_941_ = 2u;
                    }
                    let _e772 = phi_941_;
                    if _e762 {
                        phi_946_ = (_e772 | 4u);
                    } else {
                        phi_946_ = _e772;
                    }
                    let _e775 = phi_946_;
                    phi_951_ = _e775;
                } else {
                    if _e251 {
                        phi_950_ = 1u;
                    } else {
                        phi_950_ = 0u;
                    }
                    let _e777 = phi_950_;
                    phi_951_ = _e777;
                }
                let _e779 = phi_951_;
                phi_952_ = _e779;
            }
            let _e781 = phi_952_;
            if _e762 {
                phi_956_ = 0f;
            } else {
                phi_956_ = 1f;
            }
            let _e783 = phi_956_;
            if _e255 {
                if (_e93 == 0.99999994f) {
                    phi_965_ = true;
                } else {
                    phi_965_ = (_e93 == 0.000000059604645f);
                }
                let _e787 = phi_965_;
                phi_966_ = _e787;
            } else {
                phi_966_ = true;
            }
            let _e789 = phi_966_;
            phi_968_ = mask_Masked(_e783, _e781, _e758, _e789);
        }
        let _e792 = phi_968_;
        visibility.member[_e69.first_primitive] = _e792.visibility;
        let _e797 = p.member.light.number;
        let _e798 = (_e797 * 3u);
        let _e800 = (_e798 % 32u);
        let _e802 = p.member.light.mask_words;
        let _e804 = ((_e69.first_primitive * _e802) + (_e798 / 32u));
        let _e806 = bits.member[_e804];
        bits.member[_e804] = ((_e806 & ~((7u << bitcast<u32>((_e800 & 31u))))) | (_e792.bits << bitcast<u32>((_e800 & 31u))));
        if (_e800 > 29u) {
            let _e821 = bits.member[(_e804 + 1u)];
            let _e823 = (32u - _e800);
            bits.member[(_e804 + 1u)] = ((_e821 & ~((7u >> bitcast<u32>((_e823 & 31u))))) | (_e792.bits >> bitcast<u32>((_e823 & 31u))));
        }
        phi_1020_ = doubt_Listed(_e69.first_primitive, _e792.is_trusted);
        phi_1021_ = _e792.needs_ray;
    } else {
        phi_1020_ = doubt_Listed(0u, false);
        phi_1021_ = false;
    }
    let _e839 = phi_1020_;
    let _e841 = phi_1021_;
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e841 {
        let _e847 = atomicAdd((&shared_[0u]), 1u);
        phi_1034_ = _e847;
    } else {
        phi_1034_ = 0u;
    }
    let _e849 = phi_1034_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e853 = atomicLoad((&shared_[0u]));
        let _e854 = atomicAdd((&list.member[3u]), _e853);
        atomicStore((&shared_[1u]), _e854);
    }
    workgroupBarrier();
    if _e841 {
        if _e839.is_trusted {
            phi_1051_ = (_e839.pixel | 2147483648u);
        } else {
            phi_1051_ = _e839.pixel;
        }
        let _e858 = phi_1051_;
        let _e860 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e860) + _e849)]), _e858);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
