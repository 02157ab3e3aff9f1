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
    var phi_544_: f32;
    var phi_549_: f32;
    var phi_550_: bool;
    var phi_551_: f32;
    var phi_552_: bool;
    var phi_556_: f32;
    var phi_577_: f32;
    var phi_582_: f32;
    var phi_583_: bool;
    var phi_584_: f32;
    var phi_585_: bool;
    var phi_589_: f32;
    var phi_610_: bool;
    var phi_629_: vec2<u32>;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_632_: bool;
    var phi_633_: vec2<u32>;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_636_: bool;
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
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_669_: vec2<u32>;
    var phi_707_: bool;
    var phi_709_: lt_mask_Reprojection;
    var phi_710_: lt_mask_Reprojection;
    var phi_711_: bool;
    var phi_715_: bool;
    var phi_716_: lt_mask_Reprojection;
    var phi_717_: lt_mask_Reprojection;
    var phi_718_: bool;
    var phi_726_: bool;
    var phi_727_: lt_mask_Reprojection;
    var phi_793_: u32;
    var phi_798_: u32;
    var phi_799_: u32;
    var phi_800_: u32;
    var phi_801_: bool;
    var phi_802_: u32;
    var phi_803_: bool;
    var phi_804_: bool;
    var phi_805_: u32;
    var phi_806_: bool;
    var phi_807_: bool;
    var phi_811_: bool;
    var phi_815_: u32;
    var phi_820_: bool;
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
    var phi_1045_: bool;
    var phi_1046_: bool;
    var phi_1048_: mask_Masked;
    var phi_1100_: doubt_Listed;
    var phi_1101_: bool;
    var phi_1114_: u32;
    var phi_1131_: u32;

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
            phi_1048_ = mask_Masked(_e242.unnamed.visibility, 0u, false, false);
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
                phi_716_ = lt_mask_Reprojection(_e269.pixel, _e269.is_valid, false);
                phi_717_ = lt_mask_Reprojection();
                phi_718_ = true;
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
                let _e346 = (((_e330 * _e338.x) + (_e333 * _e338.y)) + (_e336 * _e338.z));
                let _e348 = p.member.previous.right;
                let _e358 = p.member.previous.right;
                let _e373 = p.member.previous.up;
                let _e383 = p.member.previous.up;
                let _e400 = p.member.previous.size[0u];
                let _e407 = p.member.previous.size[1u];
                let _e411 = (((((((_e330 * _e348.x) + (_e333 * _e348.y)) + (_e336 * _e348.z)) / ((((_e358.x * _e358.x) + (_e358.y * _e358.y)) + (_e358.z * _e358.z)) * _e346)) + 1f) * (0.5f * f32(_e400))) - _e322);
                let _e412 = (((1f - ((((_e330 * _e373.x) + (_e333 * _e373.y)) + (_e336 * _e373.z)) / ((((_e383.x * _e383.x) + (_e383.y * _e383.y)) + (_e383.z * _e383.z)) * _e346))) * (0.5f * f32(_e407))) - _e324);
                let _e416 = p.member.current.size[0u];
                let _e418 = p.member.current.size[1u];
                let _e420 = (_e322 + _e411);
                if (_e420 > -8388608f) {
                    let _e432 = f32(select(0i, select(select(i32(_e420), i32(-2147483648), (_e420 < bitcast<f32>(3472883712u))), 2147483647i, (_e420 > bitcast<f32>(1325400063u))), (_e420 == _e420)));
                    if (_e432 > _e420) {
                        phi_544_ = 1f;
                    } else {
                        phi_544_ = 0f;
                    }
                    let _e435 = phi_544_;
                    if (_e420 < 8388608f) {
                        phi_549_ = (_e432 - _e435);
                        phi_550_ = false;
                    } else {
                        phi_549_ = f32();
                        phi_550_ = true;
                    }
                    let _e438 = phi_549_;
                    let _e440 = phi_550_;
                    phi_551_ = _e438;
                    phi_552_ = _e440;
                } else {
                    phi_551_ = f32();
                    phi_552_ = true;
                }
                let _e442 = phi_551_;
                let _e444 = phi_552_;
                if _e444 {
                    phi_556_ = _e420;
                } else {
                    phi_556_ = _e442;
                }
                let _e446 = phi_556_;
                let _e447 = (_e324 + _e412);
                if (_e447 > -8388608f) {
                    let _e459 = f32(select(0i, select(select(i32(_e447), i32(-2147483648), (_e447 < bitcast<f32>(3472883712u))), 2147483647i, (_e447 > bitcast<f32>(1325400063u))), (_e447 == _e447)));
                    if (_e459 > _e447) {
                        phi_577_ = 1f;
                    } else {
                        phi_577_ = 0f;
                    }
                    let _e462 = phi_577_;
                    if (_e447 < 8388608f) {
                        phi_582_ = (_e459 - _e462);
                        phi_583_ = false;
                    } else {
                        phi_582_ = f32();
                        phi_583_ = true;
                    }
                    let _e465 = phi_582_;
                    let _e467 = phi_583_;
                    phi_584_ = _e465;
                    phi_585_ = _e467;
                } else {
                    phi_584_ = f32();
                    phi_585_ = true;
                }
                let _e469 = phi_584_;
                let _e471 = phi_585_;
                if _e471 {
                    phi_589_ = _e447;
                } else {
                    phi_589_ = _e469;
                }
                let _e473 = phi_589_;
                if (_e446 >= 0f) {
                    if (_e473 >= 0f) {
                        if (_e446 < f32(_e416)) {
                            let _e479 = (_e473 < f32(_e418));
                            if (_e411 == 0f) {
                                phi_610_ = (_e412 == 0f);
                            } else {
                                phi_610_ = false;
                            }
                            let _e483 = phi_610_;
                            if _e479 {
                                phi_629_ = vec2<u32>(select(select(u32(_e446), 0u, (_e446 < bitcast<f32>(0u))), 4294967295u, (_e446 > bitcast<f32>(1333788671u))), select(select(u32(_e473), 0u, (_e473 < bitcast<f32>(0u))), 4294967295u, (_e473 > bitcast<f32>(1333788671u))));
                                phi_630_ = false;
                            } else {
                                phi_629_ = vec2<u32>();
                                phi_630_ = true;
                            }
                            let _e500 = phi_629_;
                            let _e502 = phi_630_;
                            phi_631_ = _e483;
                            phi_632_ = _e479;
                            phi_633_ = _e500;
                            phi_634_ = _e483;
                            phi_635_ = _e479;
                            phi_636_ = false;
                            phi_637_ = _e502;
                        } else {
                            phi_631_ = bool();
                            phi_632_ = bool();
                            phi_633_ = vec2<u32>();
                            phi_634_ = bool();
                            phi_635_ = bool();
                            phi_636_ = true;
                            phi_637_ = false;
                        }
                        let _e504 = phi_631_;
                        let _e506 = phi_632_;
                        let _e508 = phi_633_;
                        let _e510 = phi_634_;
                        let _e512 = phi_635_;
                        let _e514 = phi_636_;
                        let _e516 = phi_637_;
                        phi_638_ = _e504;
                        phi_639_ = _e506;
                        phi_640_ = _e508;
                        phi_641_ = _e510;
                        phi_642_ = _e512;
                        phi_643_ = _e514;
                        phi_644_ = _e516;
                    } else {
                        phi_638_ = bool();
                        phi_639_ = bool();
                        phi_640_ = vec2<u32>();
                        phi_641_ = bool();
                        phi_642_ = bool();
                        phi_643_ = true;
                        phi_644_ = false;
                    }
                    let _e518 = phi_638_;
                    let _e520 = phi_639_;
                    let _e522 = phi_640_;
                    let _e524 = phi_641_;
                    let _e526 = phi_642_;
                    let _e528 = phi_643_;
                    let _e530 = phi_644_;
                    phi_645_ = _e518;
                    phi_646_ = _e520;
                    phi_647_ = _e522;
                    phi_648_ = _e524;
                    phi_649_ = _e526;
                    phi_650_ = _e528;
                    phi_651_ = _e530;
                } else {
                    phi_645_ = bool();
                    phi_646_ = bool();
                    phi_647_ = vec2<u32>();
                    phi_648_ = bool();
                    phi_649_ = bool();
                    phi_650_ = true;
                    phi_651_ = false;
                }
                let _e532 = phi_645_;
                let _e534 = phi_646_;
                let _e536 = phi_647_;
                let _e538 = phi_648_;
                let _e540 = phi_649_;
                let _e542 = phi_650_;
                let _e544 = phi_651_;
                if _e542 {
                    if (_e411 == 0f) {
                        phi_660_ = (_e412 == 0f);
                    } else {
                        phi_660_ = false;
                    }
                    let _e548 = phi_660_;
                    phi_661_ = _e548;
                    phi_662_ = false;
                    phi_663_ = true;
                } else {
                    phi_661_ = _e538;
                    phi_662_ = _e540;
                    phi_663_ = _e544;
                }
                let _e550 = phi_661_;
                let _e552 = phi_662_;
                let _e554 = phi_663_;
                if _e554 {
                    phi_667_ = _e550;
                    phi_668_ = _e552;
                    phi_669_ = vec2<u32>(_e51.x, _e51.y);
                } else {
                    phi_667_ = _e532;
                    phi_668_ = _e534;
                    phi_669_ = _e536;
                }
                let _e556 = phi_667_;
                let _e558 = phi_668_;
                let _e560 = phi_669_;
                let _e570 = lt_mask_Reprojection(vec2<u32>(_e560.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e577 = lt_mask_Reprojection(vec2<u32>(_e570.pixel.x, _e560.y), _e570.is_valid, _e570.has_moved);
                let _e581 = lt_mask_Reprojection(_e577.pixel, _e558, _e577.has_moved);
                let _e585 = lt_mask_Reprojection(_e581.pixel, _e581.is_valid, !(_e556));
                if _e558 {
                    let _e588 = p.member.previous.eye;
                    let _e599 = p.member.previous.forward;
                    let _e608 = (((((_e87.x - _e588.x) * _e599.x) + ((_e87.y - _e588.y) * _e599.y)) + ((_e87.z - _e588.z) * _e599.z)) > 0f);
                    let _e612 = lt_mask_Reprojection(_e585.pixel, _e608, _e585.has_moved);
                    if _e608 {
                        phi_707_ = false;
                    } else {
                        phi_707_ = true;
                    }
                    let _e614 = phi_707_;
                    phi_709_ = _e612;
                    phi_710_ = _e612;
                    phi_711_ = _e614;
                } else {
                    phi_709_ = lt_mask_Reprojection();
                    phi_710_ = lt_mask_Reprojection(_e585.pixel, false, _e585.has_moved);
                    phi_711_ = true;
                }
                let _e620 = phi_709_;
                let _e622 = phi_710_;
                let _e624 = phi_711_;
                if _e624 {
                    phi_715_ = false;
                } else {
                    phi_715_ = true;
                }
                let _e626 = phi_715_;
                phi_716_ = _e620;
                phi_717_ = _e622;
                phi_718_ = _e626;
            }
            let _e628 = phi_716_;
            let _e630 = phi_717_;
            let _e632 = phi_718_;
            if _e632 {
                let _e634 = p.member.flags;
                phi_726_ = ((_e634 & 1u) != 0u);
                phi_727_ = _e628;
            } else {
                phi_726_ = false;
                phi_727_ = _e630;
            }
            let _e638 = phi_726_;
            let _e640 = phi_727_;
            let _e644 = lt_mask_Reprojection(_e640.pixel, _e638, _e640.has_moved);
            let _e646 = p.member.flags;
            let _e648 = ((_e646 & 2u) != 0u);
            let _e650 = p.member.flags;
            if ((_e650 & 4u) == 0u) {
                phi_805_ = u32();
                phi_806_ = true;
                phi_807_ = false;
            } else {
                if _e638 {
                    if !(_e644.has_moved) {
                        let _e659 = ((((_e51.y * _e84) + (_e51.x / 32u)) * 6u) + 4u);
                        if (_e659 < _e57) {
                        } else {
                            return;
                        }
                        let _e663 = heard.member[(0u + _e659)];
                        if (((_e663 >> bitcast<u32>(((_e51.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e674 = ((((_e51.y * _e84) + (_e51.x / 32u)) * 6u) + 5u);
                            if (_e674 < _e57) {
                            } else {
                                return;
                            }
                            let _e678 = heard.member[(0u + _e674)];
                            if false {
                                phi_793_ = (2u | 1u);
                            } else {
                                phi_793_ = 2u;
                            }
                            let _e687 = phi_793_;
                            if (((_e678 >> bitcast<u32>(((_e51.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_798_ = (_e687 | 4u);
                            } else {
                                phi_798_ = _e687;
                            }
                            let _e690 = phi_798_;
                            phi_799_ = _e690;
                        } else {
                            phi_799_ = 0u;
                        }
                        let _e692 = phi_799_;
                        phi_800_ = _e692;
                        phi_801_ = false;
                    } else {
                        phi_800_ = u32();
                        phi_801_ = true;
                    }
                    let _e694 = phi_800_;
                    let _e696 = phi_801_;
                    phi_802_ = _e694;
                    phi_803_ = false;
                    phi_804_ = _e696;
                } else {
                    phi_802_ = u32();
                    phi_803_ = true;
                    phi_804_ = false;
                }
                let _e698 = phi_802_;
                let _e700 = phi_803_;
                let _e702 = phi_804_;
                phi_805_ = _e698;
                phi_806_ = _e700;
                phi_807_ = _e702;
            }
            let _e704 = phi_805_;
            let _e706 = phi_806_;
            let _e708 = phi_807_;
            if _e706 {
                phi_811_ = true;
            } else {
                phi_811_ = _e708;
            }
            let _e710 = phi_811_;
            if _e710 {
                phi_815_ = 0u;
            } else {
                phi_815_ = _e704;
            }
            let _e712 = phi_815_;
            let _e713 = lt_mask_Neighbourhood(false, true);
            if _e251 {
                phi_820_ = _e648;
            } else {
                phi_820_ = true;
            }
            let _e715 = phi_820_;
            if _e715 {
                if _e638 {
                    if ((_e712 & 2u) != 0u) {
                        phi_860_ = _e713;
                    } else {
                        let _e732 = ((((_e644.pixel.y * _e84) + (_e644.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e247) | (select(0u, 1u, _e644.has_moved) << bitcast<u32>(1i))));
                        if (_e732 < _e57) {
                        } else {
                            return;
                        }
                        let _e736 = heard.member[(0u + _e732)];
                        let _e742 = (((_e736 >> bitcast<u32>(((_e644.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_860_ = lt_mask_Neighbourhood(_e742, !(_e742));
                    }
                    let _e746 = phi_860_;
                    phi_861_ = _e746;
                } else {
                    phi_861_ = _e713;
                }
                let _e748 = phi_861_;
                phi_862_ = _e748;
            } else {
                phi_862_ = _e713;
            }
            let _e750 = phi_862_;
            let _e753 = p.member.frame;
            let _e755 = p.member.refresh;
            if (_e755 == 0u) {
                phi_895_ = false;
            } else {
                if (_e755 == 0u) {
                    return;
                }
                let _e764 = ((_e51.x + (_e51.y * (((_e755 * 5u) / 8u) | 1u))) + (_e753 % _e755));
                if (_e755 == 0u) {
                    phi_894_ = (_e764 == 0u);
                } else {
                    if (_e755 == 0u) {
                        return;
                    }
                    phi_894_ = ((_e764 % _e755) == 0u);
                }
                let _e771 = phi_894_;
                phi_895_ = _e771;
            }
            let _e773 = phi_895_;
            if _e638 {
                if _e773 {
                    phi_917_ = bool();
                } else {
                    phi_917_ = ((_e712 & 2u) != 0u);
                }
                let _e779 = phi_917_;
                phi_918_ = _e779;
                phi_919_ = _e773;
            } else {
                phi_918_ = bool();
                phi_919_ = true;
            }
            let _e781 = phi_918_;
            let _e783 = phi_919_;
            if _e783 {
                phi_923_ = false;
            } else {
                phi_923_ = _e781;
            }
            let _e785 = phi_923_;
            if _e785 {
                phi_974_ = 7u;
            } else {
                if (_e89 != 0.5f) {
                    if _e638 {
                        if _e773 {
                            phi_971_ = 6u;
                        } else {
                            if _e251 {
                                phi_946_ = true;
                            } else {
                                if _e750.any_expands {
                                    phi_945_ = false;
                                } else {
                                    phi_945_ = true;
                                }
                                let _e787 = phi_945_;
                                phi_946_ = _e787;
                            }
                            let _e789 = phi_946_;
                            if _e789 {
                                if _e251 {
                                    if _e648 {
                                        if _e750.all_remove {
                                            phi_959_ = false;
                                        } else {
                                            phi_959_ = true;
                                        }
                                        let _e791 = phi_959_;
                                        phi_960_ = _e791;
                                    } else {
                                        phi_960_ = true;
                                    }
                                    let _e793 = phi_960_;
                                    phi_961_ = _e793;
                                } else {
                                    phi_961_ = true;
                                }
                                let _e795 = phi_961_;
                                if _e795 {
                                    if _e251 {
                                        phi_968_ = 1u;
                                    } else {
                                        phi_968_ = 0u;
                                    }
                                    let _e797 = phi_968_;
                                    phi_969_ = _e797;
                                } else {
                                    phi_969_ = 5u;
                                }
                                let _e799 = phi_969_;
                                phi_970_ = _e799;
                            } else {
                                phi_970_ = 4u;
                            }
                            let _e801 = phi_970_;
                            phi_971_ = _e801;
                        }
                        let _e803 = phi_971_;
                        phi_972_ = _e803;
                    } else {
                        phi_972_ = 3u;
                    }
                    let _e805 = phi_972_;
                    phi_973_ = _e805;
                } else {
                    phi_973_ = 2u;
                }
                let _e807 = phi_973_;
                phi_974_ = _e807;
            }
            let _e809 = phi_974_;
            if !((_e809 == 0u)) {
                if !((_e809 == 5u)) {
                    phi_986_ = !(_e785);
                    phi_987_ = false;
                } else {
                    phi_986_ = bool();
                    phi_987_ = true;
                }
                let _e816 = phi_986_;
                let _e818 = phi_987_;
                phi_988_ = _e816;
                phi_989_ = _e818;
            } else {
                phi_988_ = bool();
                phi_989_ = true;
            }
            let _e820 = phi_988_;
            let _e822 = phi_989_;
            if _e822 {
                phi_993_ = false;
            } else {
                phi_993_ = _e820;
            }
            let _e824 = phi_993_;
            if _e785 {
                phi_999_ = ((_e712 & 4u) != 0u);
            } else {
                phi_999_ = _e247;
            }
            let _e828 = phi_999_;
            if _e824 {
                if _e247 {
                    phi_1007_ = (2u | 1u);
                } else {
                    phi_1007_ = 2u;
                }
                let _e831 = phi_1007_;
                if false {
                    phi_1012_ = (_e831 | 4u);
                } else {
                    phi_1012_ = _e831;
                }
                let _e834 = phi_1012_;
                phi_1032_ = _e834;
            } else {
                if (_e809 == 7u) {
                    if _e247 {
                        phi_1021_ = (2u | 1u);
                    } else {
                        phi_1021_ = 2u;
                    }
                    let _e838 = phi_1021_;
                    if _e828 {
                        phi_1026_ = (_e838 | 4u);
                    } else {
                        phi_1026_ = _e838;
                    }
                    let _e841 = phi_1026_;
                    phi_1031_ = _e841;
                } else {
                    if _e247 {
                        phi_1030_ = 1u;
                    } else {
                        phi_1030_ = 0u;
                    }
                    let _e843 = phi_1030_;
                    phi_1031_ = _e843;
                }
                let _e845 = phi_1031_;
                phi_1032_ = _e845;
            }
            let _e847 = phi_1032_;
            if _e828 {
                phi_1036_ = 0f;
            } else {
                phi_1036_ = 1f;
            }
            let _e849 = phi_1036_;
            if _e251 {
                if (_e89 == 0.99999994f) {
                    phi_1045_ = true;
                } else {
                    phi_1045_ = (_e89 == 0.000000059604645f);
                }
                let _e853 = phi_1045_;
                phi_1046_ = _e853;
            } else {
                phi_1046_ = true;
            }
            let _e855 = phi_1046_;
            phi_1048_ = mask_Masked(_e849, _e847, _e824, _e855);
        }
        let _e858 = phi_1048_;
        visibility.member[_e68.first_primitive] = _e858.visibility;
        let _e863 = p.member.light.number;
        let _e864 = (_e863 * 3u);
        let _e866 = (_e864 % 32u);
        let _e868 = p.member.light.mask_words;
        let _e870 = ((_e68.first_primitive * _e868) + (_e864 / 32u));
        let _e872 = bits.member[_e870];
        bits.member[_e870] = ((_e872 & ~((7u << bitcast<u32>((_e866 & 31u))))) | (_e858.bits << bitcast<u32>((_e866 & 31u))));
        if (_e866 > 29u) {
            let _e887 = bits.member[(_e870 + 1u)];
            let _e889 = (32u - _e866);
            bits.member[(_e870 + 1u)] = ((_e887 & ~((7u >> bitcast<u32>((_e889 & 31u))))) | (_e858.bits >> bitcast<u32>((_e889 & 31u))));
        }
        phi_1100_ = doubt_Listed(_e68.first_primitive, _e858.is_trusted);
        phi_1101_ = _e858.needs_ray;
    } else {
        phi_1100_ = doubt_Listed(0u, false);
        phi_1101_ = false;
    }
    let _e905 = phi_1100_;
    let _e907 = phi_1101_;
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e907 {
        let _e913 = atomicAdd((&shared_[0u]), 1u);
        phi_1114_ = _e913;
    } else {
        phi_1114_ = 0u;
    }
    let _e915 = phi_1114_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e919 = atomicLoad((&shared_[0u]));
        let _e920 = atomicAdd((&list.member[3u]), _e919);
        atomicStore((&shared_[1u]), _e920);
    }
    workgroupBarrier();
    if _e907 {
        if _e905.is_trusted {
            phi_1131_ = (_e905.pixel | 2147483648u);
        } else {
            phi_1131_ = _e905.pixel;
        }
        let _e924 = phi_1131_;
        let _e926 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e926) + _e915)]), _e924);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
