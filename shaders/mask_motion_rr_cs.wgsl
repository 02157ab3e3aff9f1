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
        let _e64 = phi_162_;
        let _e66 = phi_163_;
        phi_164_ = _e64;
        phi_165_ = _e66;
    } else {
        phi_164_ = lt_bvh_traverse_Tree();
        phi_165_ = true;
    }
    let _e68 = phi_164_;
    let _e70 = phi_165_;
    if _e70 {
        phi_170_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_170_ = _e68;
    }
    let _e75 = phi_170_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn function_() {
    var phi_216_: u32;
    var phi_250_: bool;
    var phi_251_: bool;
    var phi_252_: bool;
    var phi_253_: bool;
    var phi_257_: bool;
    var phi_327_: bool;
    var phi_328_: bool;
    var phi_339_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_340_: bool;
    var phi_341_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_342_: bool;
    var phi_349_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_353_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_366_: bool;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_551_: f32;
    var phi_556_: f32;
    var phi_557_: bool;
    var phi_558_: f32;
    var phi_559_: bool;
    var phi_563_: f32;
    var phi_584_: f32;
    var phi_589_: f32;
    var phi_590_: bool;
    var phi_591_: f32;
    var phi_592_: bool;
    var phi_596_: f32;
    var phi_617_: bool;
    var phi_636_: vec2<u32>;
    var phi_637_: bool;
    var phi_638_: bool;
    var phi_639_: bool;
    var phi_640_: vec2<u32>;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_643_: bool;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: vec2<u32>;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_654_: vec2<u32>;
    var phi_655_: bool;
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_674_: bool;
    var phi_675_: bool;
    var phi_676_: vec2<u32>;
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
    var phi_800_: u32;
    var phi_805_: u32;
    var phi_806_: u32;
    var phi_807_: u32;
    var phi_808_: bool;
    var phi_809_: u32;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_812_: u32;
    var phi_813_: bool;
    var phi_814_: bool;
    var phi_818_: bool;
    var phi_822_: u32;
    var phi_827_: bool;
    var phi_867_: lt_mask_Neighbourhood;
    var phi_868_: lt_mask_Neighbourhood;
    var phi_869_: lt_mask_Neighbourhood;
    var phi_901_: bool;
    var phi_902_: bool;
    var phi_924_: bool;
    var phi_925_: bool;
    var phi_926_: bool;
    var phi_930_: bool;
    var phi_952_: bool;
    var phi_953_: bool;
    var phi_966_: bool;
    var phi_967_: bool;
    var phi_968_: bool;
    var phi_975_: u32;
    var phi_976_: u32;
    var phi_977_: u32;
    var phi_978_: u32;
    var phi_979_: u32;
    var phi_980_: u32;
    var phi_981_: u32;
    var phi_993_: bool;
    var phi_994_: bool;
    var phi_995_: bool;
    var phi_996_: bool;
    var phi_1000_: bool;
    var phi_1006_: bool;
    var phi_1014_: u32;
    var phi_1019_: u32;
    var phi_1028_: u32;
    var phi_1033_: u32;
    var phi_1037_: u32;
    var phi_1038_: u32;
    var phi_1039_: u32;
    var phi_1043_: f32;
    var phi_1052_: bool;
    var phi_1053_: bool;
    var phi_1055_: mask_Masked;
    var phi_1107_: doubt_Listed;
    var phi_1108_: bool;
    var phi_1121_: u32;
    var phi_1138_: u32;

    let _e51 = id_1;
    let _e52 = local_1;
    let _e57 = arrayLength((&heard.member));
    let _e65 = p.member.current.size[0u];
    let _e67 = p.member.current.size[1u];
    let _e68 = lt_shaders_entry_pixel_index(_e51, _e65, _e67);
    if (bitcast<i32>(_e68.root) != 0i) {
        let _e76 = p.member.current.size[0u];
        if (32u == 0u) {
            return;
        }
        let _e78 = (_e76 / 32u);
        if (32u == 0u) {
            return;
        }
        if ((_e76 % 32u) > 0u) {
            phi_216_ = (_e78 + 1u);
        } else {
            phi_216_ = _e78;
        }
        let _e84 = phi_216_;
        let _e87 = samples.member[_e68.first_primitive].position;
        let _e89 = visibility.member[_e68.first_primitive];
        let _e95 = samples.member[_e68.first_primitive].normal[0u];
        let _e97 = global[0u];
        if (_e95 == _e97) {
            let _e100 = samples.member[_e68.first_primitive].normal[1u];
            let _e102 = global[1u];
            if (_e100 == _e102) {
                let _e105 = samples.member[_e68.first_primitive].normal[2u];
                let _e107 = global[2u];
                phi_250_ = (_e105 == _e107);
                phi_251_ = false;
            } else {
                phi_250_ = bool();
                phi_251_ = true;
            }
            let _e110 = phi_250_;
            let _e112 = phi_251_;
            phi_252_ = _e110;
            phi_253_ = _e112;
        } else {
            phi_252_ = bool();
            phi_253_ = true;
        }
        let _e114 = phi_252_;
        let _e116 = phi_253_;
        if _e116 {
            phi_257_ = false;
        } else {
            phi_257_ = _e114;
        }
        let _e118 = phi_257_;
        if !(_e118) {
            let _e121 = samples.member[_e68.first_primitive].position;
            let _e123 = p.member.light.place;
            let _e129 = p.member.light.place[3u];
            let _e136 = (_e123.x - (_e121.x * _e129));
            let _e137 = (_e123.y - (_e121.y * _e129));
            let _e138 = (_e123.z - (_e121.z * _e129));
            let _e140 = samples.member[_e68.first_primitive].normal;
            if ((((_e140.x * _e136) + (_e140.y * _e137)) + (_e140.z * _e138)) > 0f) {
                let _e154 = (((_e136 * _e136) + (_e137 * _e137)) + (_e138 * _e138));
                let _e156 = p.member.light.axis;
                let _e168 = p.member.light.place[3u];
                if (_e168 == 0f) {
                    phi_328_ = true;
                } else {
                    let _e171 = p.member.light.range_squared;
                    if (_e154 <= _e171) {
                        let _e174 = p.member.light.cos_outer;
                        phi_327_ = (-((((_e136 * _e156.x) + (_e137 * _e156.y)) + (_e138 * _e156.z))) >= (_e174 * sqrt(_e154)));
                    } else {
                        phi_327_ = false;
                    }
                    let _e179 = phi_327_;
                    phi_328_ = _e179;
                }
                let _e181 = phi_328_;
                if _e181 {
                    let _e183 = samples.member[_e68.first_primitive].flags;
                    let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                    phi_339_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, ((_e183 & 1u) == 0u));
                    phi_340_ = false;
                } else {
                    phi_339_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_340_ = true;
                }
                let _e202 = phi_339_;
                let _e204 = phi_340_;
                phi_341_ = _e202;
                phi_342_ = _e204;
            } else {
                phi_341_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_342_ = true;
            }
            let _e206 = phi_341_;
            let _e208 = phi_342_;
            if _e208 {
                let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e214.unnamed.visibility, false), _e214.unnamed_1);
                phi_349_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e220.unnamed, true);
            } else {
                phi_349_ = _e206;
            }
            let _e225 = phi_349_;
            phi_353_ = _e225;
        } else {
            let _e231 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e237 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e231.unnamed.visibility, false), _e231.unnamed_1);
            phi_353_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e237.unnamed, true);
        }
        let _e242 = phi_353_;
        if _e242.unnamed_1 {
            phi_1055_ = mask_Masked(_e242.unnamed.visibility, 0u, false, false);
        } else {
            let _e247 = (_e89 < 0.5f);
            if (_e89 > 0f) {
                phi_366_ = (_e89 < 1f);
            } else {
                phi_366_ = false;
            }
            let _e251 = phi_366_;
            let _e258 = lt_mask_Reprojection(vec2<u32>(_e51.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e265 = lt_mask_Reprojection(vec2<u32>(_e258.pixel.x, _e51.y), _e258.is_valid, _e258.has_moved);
            let _e269 = lt_mask_Reprojection(_e265.pixel, true, _e265.has_moved);
            let _e275 = p.member.flags;
            if ((_e275 & 16u) == 0u) {
                phi_405_ = false;
            } else {
                let _e281 = samples.member[_e68.first_primitive].position[0u];
                if (_e87.x == _e281) {
                    let _e285 = samples.member[_e68.first_primitive].position[1u];
                    if (_e87.y == _e285) {
                        let _e289 = samples.member[_e68.first_primitive].position[2u];
                        phi_397_ = (_e87.z == _e289);
                        phi_398_ = false;
                    } else {
                        phi_397_ = bool();
                        phi_398_ = true;
                    }
                    let _e292 = phi_397_;
                    let _e294 = phi_398_;
                    phi_399_ = _e292;
                    phi_400_ = _e294;
                } else {
                    phi_399_ = bool();
                    phi_400_ = true;
                }
                let _e296 = phi_399_;
                let _e298 = phi_400_;
                if _e298 {
                    phi_404_ = false;
                } else {
                    phi_404_ = _e296;
                }
                let _e300 = phi_404_;
                phi_405_ = _e300;
            }
            let _e302 = phi_405_;
            if _e302 {
                phi_723_ = lt_mask_Reprojection(_e269.pixel, _e269.is_valid, false);
                phi_724_ = lt_mask_Reprojection();
                phi_725_ = true;
            } else {
                let _e306 = p.member.current.grid[0u];
                let _e308 = p.member.current.grid[1u];
                let _e322 = (f32(_e51.x) + ((f32((_e51.y & (_e308 - 1u))) + 0.5f) / f32(_e308)));
                let _e324 = (f32(_e51.y) + ((f32((_e51.x & (_e306 - 1u))) + 0.5f) / f32(_e306)));
                let _e327 = p.member.previous.eye;
                let _e330 = (_e87.x - _e327.x);
                let _e333 = (_e87.y - _e327.y);
                let _e336 = (_e87.z - _e327.z);
                let _e338 = p.member.previous.forward;
                let _e347 = (1f / (((_e330 * _e338.x) + (_e333 * _e338.y)) + (_e336 * _e338.z)));
                let _e349 = p.member.previous.right;
                let _e351 = p.member.previous.right;
                let _e363 = (1f / (((_e351.x * _e351.x) + (_e351.y * _e351.y)) + (_e351.z * _e351.z)));
                let _e371 = p.member.previous.up;
                let _e373 = p.member.previous.up;
                let _e385 = (1f / (((_e373.x * _e373.x) + (_e373.y * _e373.y)) + (_e373.z * _e373.z)));
                let _e407 = p.member.previous.size[0u];
                let _e414 = p.member.previous.size[1u];
                let _e418 = (((((((_e330 * (_e349.x * _e363)) + (_e333 * (_e349.y * _e363))) + (_e336 * (_e349.z * _e363))) * _e347) + 1f) * (0.5f * f32(_e407))) - _e322);
                let _e419 = (((1f - ((((_e330 * (_e371.x * _e385)) + (_e333 * (_e371.y * _e385))) + (_e336 * (_e371.z * _e385))) * _e347)) * (0.5f * f32(_e414))) - _e324);
                let _e423 = p.member.current.size[0u];
                let _e425 = p.member.current.size[1u];
                let _e427 = (_e322 + _e418);
                if (_e427 > -8388608f) {
                    let _e439 = f32(select(0i, select(select(i32(_e427), i32(-2147483648), (_e427 < bitcast<f32>(3472883712u))), 2147483647i, (_e427 > bitcast<f32>(1325400063u))), (_e427 == _e427)));
                    if (_e439 > _e427) {
                        phi_551_ = 1f;
                    } else {
                        phi_551_ = 0f;
                    }
                    let _e442 = phi_551_;
                    if (_e427 < 8388608f) {
                        phi_556_ = (_e439 - _e442);
                        phi_557_ = false;
                    } else {
                        phi_556_ = f32();
                        phi_557_ = true;
                    }
                    let _e445 = phi_556_;
                    let _e447 = phi_557_;
                    phi_558_ = _e445;
                    phi_559_ = _e447;
                } else {
                    phi_558_ = f32();
                    phi_559_ = true;
                }
                let _e449 = phi_558_;
                let _e451 = phi_559_;
                if _e451 {
                    phi_563_ = _e427;
                } else {
                    phi_563_ = _e449;
                }
                let _e453 = phi_563_;
                let _e454 = (_e324 + _e419);
                if (_e454 > -8388608f) {
                    let _e466 = f32(select(0i, select(select(i32(_e454), i32(-2147483648), (_e454 < bitcast<f32>(3472883712u))), 2147483647i, (_e454 > bitcast<f32>(1325400063u))), (_e454 == _e454)));
                    if (_e466 > _e454) {
                        phi_584_ = 1f;
                    } else {
                        phi_584_ = 0f;
                    }
                    let _e469 = phi_584_;
                    if (_e454 < 8388608f) {
                        phi_589_ = (_e466 - _e469);
                        phi_590_ = false;
                    } else {
                        phi_589_ = f32();
                        phi_590_ = true;
                    }
                    let _e472 = phi_589_;
                    let _e474 = phi_590_;
                    phi_591_ = _e472;
                    phi_592_ = _e474;
                } else {
                    phi_591_ = f32();
                    phi_592_ = true;
                }
                let _e476 = phi_591_;
                let _e478 = phi_592_;
                if _e478 {
                    phi_596_ = _e454;
                } else {
                    phi_596_ = _e476;
                }
                let _e480 = phi_596_;
                if (_e453 >= 0f) {
                    if (_e480 >= 0f) {
                        if (_e453 < f32(_e423)) {
                            let _e486 = (_e480 < f32(_e425));
                            if (_e418 == 0f) {
                                phi_617_ = (_e419 == 0f);
                            } else {
                                phi_617_ = false;
                            }
                            let _e490 = phi_617_;
                            if _e486 {
                                phi_636_ = vec2<u32>(select(select(u32(_e453), 0u, (_e453 < bitcast<f32>(0u))), 4294967295u, (_e453 > bitcast<f32>(1333788671u))), select(select(u32(_e480), 0u, (_e480 < bitcast<f32>(0u))), 4294967295u, (_e480 > bitcast<f32>(1333788671u))));
                                phi_637_ = false;
                            } else {
                                phi_636_ = vec2<u32>();
                                phi_637_ = true;
                            }
                            let _e507 = phi_636_;
                            let _e509 = phi_637_;
                            phi_638_ = _e490;
                            phi_639_ = _e486;
                            phi_640_ = _e507;
                            phi_641_ = _e490;
                            phi_642_ = _e486;
                            phi_643_ = false;
                            phi_644_ = _e509;
                        } else {
                            phi_638_ = bool();
                            phi_639_ = bool();
                            phi_640_ = vec2<u32>();
                            phi_641_ = bool();
                            phi_642_ = bool();
                            phi_643_ = true;
                            phi_644_ = false;
                        }
                        let _e511 = phi_638_;
                        let _e513 = phi_639_;
                        let _e515 = phi_640_;
                        let _e517 = phi_641_;
                        let _e519 = phi_642_;
                        let _e521 = phi_643_;
                        let _e523 = phi_644_;
                        phi_645_ = _e511;
                        phi_646_ = _e513;
                        phi_647_ = _e515;
                        phi_648_ = _e517;
                        phi_649_ = _e519;
                        phi_650_ = _e521;
                        phi_651_ = _e523;
                    } else {
                        phi_645_ = bool();
                        phi_646_ = bool();
                        phi_647_ = vec2<u32>();
                        phi_648_ = bool();
                        phi_649_ = bool();
                        phi_650_ = true;
                        phi_651_ = false;
                    }
                    let _e525 = phi_645_;
                    let _e527 = phi_646_;
                    let _e529 = phi_647_;
                    let _e531 = phi_648_;
                    let _e533 = phi_649_;
                    let _e535 = phi_650_;
                    let _e537 = phi_651_;
                    phi_652_ = _e525;
                    phi_653_ = _e527;
                    phi_654_ = _e529;
                    phi_655_ = _e531;
                    phi_656_ = _e533;
                    phi_657_ = _e535;
                    phi_658_ = _e537;
                } else {
                    phi_652_ = bool();
                    phi_653_ = bool();
                    phi_654_ = vec2<u32>();
                    phi_655_ = bool();
                    phi_656_ = bool();
                    phi_657_ = true;
                    phi_658_ = false;
                }
                let _e539 = phi_652_;
                let _e541 = phi_653_;
                let _e543 = phi_654_;
                let _e545 = phi_655_;
                let _e547 = phi_656_;
                let _e549 = phi_657_;
                let _e551 = phi_658_;
                if _e549 {
                    if (_e418 == 0f) {
                        phi_667_ = (_e419 == 0f);
                    } else {
                        phi_667_ = false;
                    }
                    let _e555 = phi_667_;
                    phi_668_ = _e555;
                    phi_669_ = false;
                    phi_670_ = true;
                } else {
                    phi_668_ = _e545;
                    phi_669_ = _e547;
                    phi_670_ = _e551;
                }
                let _e557 = phi_668_;
                let _e559 = phi_669_;
                let _e561 = phi_670_;
                if _e561 {
                    phi_674_ = _e557;
                    phi_675_ = _e559;
                    phi_676_ = vec2<u32>(_e51.x, _e51.y);
                } else {
                    phi_674_ = _e539;
                    phi_675_ = _e541;
                    phi_676_ = _e543;
                }
                let _e563 = phi_674_;
                let _e565 = phi_675_;
                let _e567 = phi_676_;
                let _e577 = lt_mask_Reprojection(vec2<u32>(_e567.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e584 = lt_mask_Reprojection(vec2<u32>(_e577.pixel.x, _e567.y), _e577.is_valid, _e577.has_moved);
                let _e588 = lt_mask_Reprojection(_e584.pixel, _e565, _e584.has_moved);
                let _e592 = lt_mask_Reprojection(_e588.pixel, _e588.is_valid, !(_e563));
                if _e565 {
                    let _e595 = p.member.previous.eye;
                    let _e606 = p.member.previous.forward;
                    let _e615 = (((((_e87.x - _e595.x) * _e606.x) + ((_e87.y - _e595.y) * _e606.y)) + ((_e87.z - _e595.z) * _e606.z)) > 0f);
                    let _e619 = lt_mask_Reprojection(_e592.pixel, _e615, _e592.has_moved);
                    if _e615 {
                        phi_714_ = false;
                    } else {
                        phi_714_ = true;
                    }
                    let _e621 = phi_714_;
                    phi_716_ = _e619;
                    phi_717_ = _e619;
                    phi_718_ = _e621;
                } else {
                    phi_716_ = lt_mask_Reprojection();
                    phi_717_ = lt_mask_Reprojection(_e592.pixel, false, _e592.has_moved);
                    phi_718_ = true;
                }
                let _e627 = phi_716_;
                let _e629 = phi_717_;
                let _e631 = phi_718_;
                if _e631 {
                    phi_722_ = false;
                } else {
                    phi_722_ = true;
                }
                let _e633 = phi_722_;
                phi_723_ = _e627;
                phi_724_ = _e629;
                phi_725_ = _e633;
            }
            let _e635 = phi_723_;
            let _e637 = phi_724_;
            let _e639 = phi_725_;
            if _e639 {
                let _e641 = p.member.flags;
                phi_733_ = ((_e641 & 1u) != 0u);
                phi_734_ = _e635;
            } else {
                phi_733_ = false;
                phi_734_ = _e637;
            }
            let _e645 = phi_733_;
            let _e647 = phi_734_;
            let _e651 = lt_mask_Reprojection(_e647.pixel, _e645, _e647.has_moved);
            let _e653 = p.member.flags;
            let _e655 = ((_e653 & 2u) != 0u);
            let _e657 = p.member.flags;
            if ((_e657 & 4u) == 0u) {
                phi_812_ = u32();
                phi_813_ = true;
                phi_814_ = false;
            } else {
                if _e645 {
                    if !(_e651.has_moved) {
                        let _e666 = ((((_e51.y * _e84) + (_e51.x / 32u)) * 6u) + 4u);
                        if (_e666 < _e57) {
                        } else {
                            return;
                        }
                        let _e670 = heard.member[(0u + _e666)];
                        if (((_e670 >> bitcast<u32>(((_e51.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e681 = ((((_e51.y * _e84) + (_e51.x / 32u)) * 6u) + 5u);
                            if (_e681 < _e57) {
                            } else {
                                return;
                            }
                            let _e685 = heard.member[(0u + _e681)];
                            if false {
                                phi_800_ = (2u | 1u);
                            } else {
                                phi_800_ = 2u;
                            }
                            let _e694 = phi_800_;
                            if (((_e685 >> bitcast<u32>(((_e51.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_805_ = (_e694 | 4u);
                            } else {
                                phi_805_ = _e694;
                            }
                            let _e697 = phi_805_;
                            phi_806_ = _e697;
                        } else {
                            phi_806_ = 0u;
                        }
                        let _e699 = phi_806_;
                        phi_807_ = _e699;
                        phi_808_ = false;
                    } else {
                        phi_807_ = u32();
                        phi_808_ = true;
                    }
                    let _e701 = phi_807_;
                    let _e703 = phi_808_;
                    phi_809_ = _e701;
                    phi_810_ = false;
                    phi_811_ = _e703;
                } else {
                    phi_809_ = u32();
                    phi_810_ = true;
                    phi_811_ = false;
                }
                let _e705 = phi_809_;
                let _e707 = phi_810_;
                let _e709 = phi_811_;
                phi_812_ = _e705;
                phi_813_ = _e707;
                phi_814_ = _e709;
            }
            let _e711 = phi_812_;
            let _e713 = phi_813_;
            let _e715 = phi_814_;
            if _e713 {
                phi_818_ = true;
            } else {
                phi_818_ = _e715;
            }
            let _e717 = phi_818_;
            if _e717 {
                phi_822_ = 0u;
            } else {
                phi_822_ = _e711;
            }
            let _e719 = phi_822_;
            let _e720 = lt_mask_Neighbourhood(false, true);
            if _e251 {
                phi_827_ = _e655;
            } else {
                phi_827_ = false;
            }
            let _e722 = phi_827_;
            if _e722 {
                if _e645 {
                    if ((_e719 & 2u) != 0u) {
                        phi_867_ = _e720;
                    } else {
                        let _e739 = ((((_e651.pixel.y * _e84) + (_e651.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e247) | (select(0u, 1u, _e651.has_moved) << bitcast<u32>(1i))));
                        if (_e739 < _e57) {
                        } else {
                            return;
                        }
                        let _e743 = heard.member[(0u + _e739)];
                        let _e749 = (((_e743 >> bitcast<u32>(((_e651.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_867_ = lt_mask_Neighbourhood(_e749, !(_e749));
                    }
                    let _e753 = phi_867_;
                    phi_868_ = _e753;
                } else {
                    phi_868_ = _e720;
                }
                let _e755 = phi_868_;
                phi_869_ = _e755;
            } else {
                phi_869_ = _e720;
            }
            let _e757 = phi_869_;
            let _e760 = p.member.frame;
            let _e762 = p.member.refresh;
            if (_e762 == 0u) {
                phi_902_ = false;
            } else {
                if (_e762 == 0u) {
                    return;
                }
                let _e771 = ((_e51.x + (_e51.y * (((_e762 * 5u) / 8u) | 1u))) + (_e760 % _e762));
                if (_e762 == 0u) {
                    phi_901_ = (_e771 == 0u);
                } else {
                    if (_e762 == 0u) {
                        return;
                    }
                    phi_901_ = ((_e771 % _e762) == 0u);
                }
                let _e778 = phi_901_;
                phi_902_ = _e778;
            }
            let _e780 = phi_902_;
            if _e645 {
                if _e780 {
                    phi_924_ = bool();
                } else {
                    phi_924_ = ((_e719 & 2u) != 0u);
                }
                let _e786 = phi_924_;
                phi_925_ = _e786;
                phi_926_ = _e780;
            } else {
                phi_925_ = bool();
                phi_926_ = true;
            }
            let _e788 = phi_925_;
            let _e790 = phi_926_;
            if _e790 {
                phi_930_ = false;
            } else {
                phi_930_ = _e788;
            }
            let _e792 = phi_930_;
            if _e792 {
                phi_981_ = 7u;
            } else {
                if (_e89 != 0.5f) {
                    if _e645 {
                        if _e780 {
                            phi_978_ = 6u;
                        } else {
                            if _e251 {
                                phi_953_ = true;
                            } else {
                                if _e757.any_expands {
                                    phi_952_ = false;
                                } else {
                                    phi_952_ = true;
                                }
                                let _e794 = phi_952_;
                                phi_953_ = _e794;
                            }
                            let _e796 = phi_953_;
                            if _e796 {
                                if _e251 {
                                    if _e655 {
                                        if _e757.all_remove {
                                            phi_966_ = false;
                                        } else {
                                            phi_966_ = true;
                                        }
                                        let _e798 = phi_966_;
                                        phi_967_ = _e798;
                                    } else {
                                        phi_967_ = true;
                                    }
                                    let _e800 = phi_967_;
                                    phi_968_ = _e800;
                                } else {
                                    phi_968_ = true;
                                }
                                let _e802 = phi_968_;
                                if _e802 {
                                    if _e251 {
                                        phi_975_ = 1u;
                                    } else {
                                        phi_975_ = 0u;
                                    }
                                    let _e804 = phi_975_;
                                    phi_976_ = _e804;
                                } else {
                                    phi_976_ = 5u;
                                }
                                let _e806 = phi_976_;
                                phi_977_ = _e806;
                            } else {
                                phi_977_ = 4u;
                            }
                            let _e808 = phi_977_;
                            phi_978_ = _e808;
                        }
                        let _e810 = phi_978_;
                        phi_979_ = _e810;
                    } else {
                        phi_979_ = 3u;
                    }
                    let _e812 = phi_979_;
                    phi_980_ = _e812;
                } else {
                    phi_980_ = 2u;
                }
                let _e814 = phi_980_;
                phi_981_ = _e814;
            }
            let _e816 = phi_981_;
            if !((_e816 == 0u)) {
                if !((_e816 == 5u)) {
                    phi_993_ = !(_e792);
                    phi_994_ = false;
                } else {
                    phi_993_ = bool();
                    phi_994_ = true;
                }
                let _e823 = phi_993_;
                let _e825 = phi_994_;
                phi_995_ = _e823;
                phi_996_ = _e825;
            } else {
                phi_995_ = bool();
                phi_996_ = true;
            }
            let _e827 = phi_995_;
            let _e829 = phi_996_;
            if _e829 {
                phi_1000_ = false;
            } else {
                phi_1000_ = _e827;
            }
            let _e831 = phi_1000_;
            if _e792 {
                phi_1006_ = ((_e719 & 4u) != 0u);
            } else {
                phi_1006_ = _e247;
            }
            let _e835 = phi_1006_;
            if _e831 {
                if _e247 {
                    phi_1014_ = (2u | 1u);
                } else {
                    phi_1014_ = 2u;
                }
                let _e838 = phi_1014_;
                if false {
                    phi_1019_ = (_e838 | 4u);
                } else {
                    phi_1019_ = _e838;
                }
                let _e841 = phi_1019_;
                phi_1039_ = _e841;
            } else {
                if (_e816 == 7u) {
                    if _e247 {
                        phi_1028_ = (2u | 1u);
                    } else {
                        phi_1028_ = 2u;
                    }
                    let _e845 = phi_1028_;
                    if _e835 {
                        phi_1033_ = (_e845 | 4u);
                    } else {
                        phi_1033_ = _e845;
                    }
                    let _e848 = phi_1033_;
                    phi_1038_ = _e848;
                } else {
                    if _e247 {
                        phi_1037_ = 1u;
                    } else {
                        phi_1037_ = 0u;
                    }
                    let _e850 = phi_1037_;
                    phi_1038_ = _e850;
                }
                let _e852 = phi_1038_;
                phi_1039_ = _e852;
            }
            let _e854 = phi_1039_;
            if _e835 {
                phi_1043_ = 0f;
            } else {
                phi_1043_ = 1f;
            }
            let _e856 = phi_1043_;
            if _e251 {
                if (_e89 == 0.99999994f) {
                    phi_1052_ = true;
                } else {
                    phi_1052_ = (_e89 == 0.000000059604645f);
                }
                let _e860 = phi_1052_;
                phi_1053_ = _e860;
            } else {
                phi_1053_ = true;
            }
            let _e862 = phi_1053_;
            phi_1055_ = mask_Masked(_e856, _e854, _e831, _e862);
        }
        let _e865 = phi_1055_;
        visibility.member[_e68.first_primitive] = _e865.visibility;
        let _e870 = p.member.light.number;
        let _e871 = (_e870 * 3u);
        let _e873 = (_e871 % 32u);
        let _e875 = p.member.light.mask_words;
        let _e877 = ((_e68.first_primitive * _e875) + (_e871 / 32u));
        let _e879 = bits.member[_e877];
        bits.member[_e877] = ((_e879 & ~((7u << bitcast<u32>((_e873 & 31u))))) | (_e865.bits << bitcast<u32>((_e873 & 31u))));
        if (_e873 > 29u) {
            let _e894 = bits.member[(_e877 + 1u)];
            let _e896 = (32u - _e873);
            bits.member[(_e877 + 1u)] = ((_e894 & ~((7u >> bitcast<u32>((_e896 & 31u))))) | (_e865.bits >> bitcast<u32>((_e896 & 31u))));
        }
        phi_1107_ = doubt_Listed(_e68.first_primitive, _e865.is_trusted);
        phi_1108_ = _e865.needs_ray;
    } else {
        phi_1107_ = doubt_Listed(0u, false);
        phi_1108_ = false;
    }
    let _e912 = phi_1107_;
    let _e914 = phi_1108_;
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e914 {
        let _e920 = atomicAdd((&shared_[0u]), 1u);
        phi_1121_ = _e920;
    } else {
        phi_1121_ = 0u;
    }
    let _e922 = phi_1121_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e926 = atomicLoad((&shared_[0u]));
        let _e927 = atomicAdd((&list.member[3u]), _e926);
        atomicStore((&shared_[1u]), _e927);
    }
    workgroupBarrier();
    if _e914 {
        if _e912.is_trusted {
            phi_1138_ = (_e912.pixel | 2147483648u);
        } else {
            phi_1138_ = _e912.pixel;
        }
        let _e931 = phi_1138_;
        let _e933 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e933) + _e922)]), _e931);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
