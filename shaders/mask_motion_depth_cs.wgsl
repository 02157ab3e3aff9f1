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
@group(0) @binding(6) 
var<storage> last_depths: type_27;
@group(0) @binding(7) 
var<storage, read_write> depths: type_27;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_170_: lt_bvh_traverse_Tree;
    var phi_171_: bool;
    var phi_172_: lt_bvh_traverse_Tree;
    var phi_173_: bool;
    var phi_178_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_170_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_171_ = false;
        } else {
            phi_170_ = lt_bvh_traverse_Tree();
            phi_171_ = true;
        }
        let _e68 = phi_170_;
        let _e70 = phi_171_;
        phi_172_ = _e68;
        phi_173_ = _e70;
    } else {
        phi_172_ = lt_bvh_traverse_Tree();
        phi_173_ = true;
    }
    let _e72 = phi_172_;
    let _e74 = phi_173_;
    if _e74 {
        phi_178_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_178_ = _e72;
    }
    let _e79 = phi_178_;
    return lt_bvh_traverse_Tree(_e79.root, _e79.first_primitive);
}

fn function_() {
    var phi_247_: bool;
    var phi_248_: bool;
    var phi_249_: bool;
    var phi_250_: bool;
    var phi_254_: bool;
    var phi_324_: bool;
    var phi_325_: bool;
    var phi_336_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_337_: bool;
    var phi_338_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_339_: bool;
    var phi_346_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_350_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_363_: bool;
    var phi_394_: bool;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_397_: bool;
    var phi_401_: bool;
    var phi_402_: bool;
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
    var phi_711_: bool;
    var phi_713_: lt_mask_Reprojection;
    var phi_714_: lt_mask_Reprojection;
    var phi_715_: lt_mask_Reprojection;
    var phi_716_: bool;
    var phi_717_: bool;
    var phi_718_: lt_mask_Reprojection;
    var phi_719_: lt_mask_Reprojection;
    var phi_720_: lt_mask_Reprojection;
    var phi_721_: bool;
    var phi_722_: bool;
    var phi_777_: bool;
    var phi_781_: f32;
    var phi_785_: lt_mask_Reprojection;
    var phi_786_: bool;
    var phi_798_: bool;
    var phi_799_: bool;
    var phi_800_: bool;
    var phi_801_: lt_mask_Reprojection;
    var phi_802_: bool;
    var phi_806_: bool;
    var phi_807_: lt_mask_Reprojection;
    var phi_845_: u32;
    var phi_894_: u32;
    var phi_899_: u32;
    var phi_900_: u32;
    var phi_901_: u32;
    var phi_902_: bool;
    var phi_903_: u32;
    var phi_904_: bool;
    var phi_905_: bool;
    var phi_906_: u32;
    var phi_907_: bool;
    var phi_908_: bool;
    var phi_912_: bool;
    var phi_916_: u32;
    var phi_921_: bool;
    var phi_953_: u32;
    var phi_982_: lt_mask_Neighbourhood;
    var phi_983_: lt_mask_Neighbourhood;
    var phi_984_: lt_mask_Neighbourhood;
    var phi_1016_: bool;
    var phi_1017_: bool;
    var phi_1039_: bool;
    var phi_1040_: bool;
    var phi_1041_: bool;
    var phi_1045_: bool;
    var phi_1067_: bool;
    var phi_1068_: bool;
    var phi_1081_: bool;
    var phi_1082_: bool;
    var phi_1083_: bool;
    var phi_1090_: u32;
    var phi_1091_: u32;
    var phi_1092_: u32;
    var phi_1093_: u32;
    var phi_1094_: u32;
    var phi_1095_: u32;
    var phi_1096_: u32;
    var phi_1108_: bool;
    var phi_1109_: bool;
    var phi_1110_: bool;
    var phi_1111_: bool;
    var phi_1115_: bool;
    var phi_1121_: bool;
    var phi_1129_: u32;
    var phi_1134_: u32;
    var phi_1143_: u32;
    var phi_1148_: u32;
    var phi_1152_: u32;
    var phi_1153_: u32;
    var phi_1154_: u32;
    var phi_1158_: f32;
    var phi_1167_: bool;
    var phi_1168_: bool;
    var phi_1170_: mask_Masked;
    var phi_1242_: bool;
    var phi_1243_: bool;
    var phi_1244_: bool;
    var phi_1245_: bool;
    var phi_1249_: bool;
    var phi_1277_: f32;
    var phi_1282_: doubt_Listed;
    var phi_1283_: bool;
    var phi_1296_: u32;
    var phi_1313_: u32;

    let _e55 = id_1;
    let _e56 = local_1;
    let _e61 = arrayLength((&heard.member));
    let _e73 = p.member.current.size[0u];
    let _e75 = p.member.current.size[1u];
    let _e76 = lt_shaders_entry_pixel_index(_e55, _e73, _e75);
    if (bitcast<i32>(_e76.root) != 0i) {
        let _e84 = p.member.current.size[0u];
        let _e87 = samples.member[_e76.first_primitive].position;
        let _e89 = visibility.member[_e76.first_primitive];
        let _e95 = samples.member[_e76.first_primitive].normal[0u];
        let _e97 = global[0u];
        if (_e95 == _e97) {
            let _e100 = samples.member[_e76.first_primitive].normal[1u];
            let _e102 = global[1u];
            if (_e100 == _e102) {
                let _e105 = samples.member[_e76.first_primitive].normal[2u];
                let _e107 = global[2u];
                phi_247_ = (_e105 == _e107);
                phi_248_ = false;
            } else {
                phi_247_ = bool();
                phi_248_ = true;
            }
            let _e110 = phi_247_;
            let _e112 = phi_248_;
            phi_249_ = _e110;
            phi_250_ = _e112;
        } else {
            phi_249_ = bool();
            phi_250_ = true;
        }
        let _e114 = phi_249_;
        let _e116 = phi_250_;
        if _e116 {
            phi_254_ = false;
        } else {
            phi_254_ = _e114;
        }
        let _e118 = phi_254_;
        if !(_e118) {
            let _e121 = samples.member[_e76.first_primitive].position;
            let _e123 = p.member.light.place;
            let _e129 = p.member.light.place[3u];
            let _e136 = (_e123.x - (_e121.x * _e129));
            let _e137 = (_e123.y - (_e121.y * _e129));
            let _e138 = (_e123.z - (_e121.z * _e129));
            let _e140 = samples.member[_e76.first_primitive].normal;
            if ((((_e140.x * _e136) + (_e140.y * _e137)) + (_e140.z * _e138)) > 0f) {
                let _e154 = (((_e136 * _e136) + (_e137 * _e137)) + (_e138 * _e138));
                let _e156 = p.member.light.axis;
                let _e168 = p.member.light.place[3u];
                if (_e168 == 0f) {
                    phi_325_ = true;
                } else {
                    let _e171 = p.member.light.range_squared;
                    if (_e154 <= _e171) {
                        let _e174 = p.member.light.cos_outer;
                        phi_324_ = (-((((_e136 * _e156.x) + (_e137 * _e156.y)) + (_e138 * _e156.z))) >= (_e174 * sqrt(_e154)));
                    } else {
                        phi_324_ = false;
                    }
                    let _e179 = phi_324_;
                    phi_325_ = _e179;
                }
                let _e181 = phi_325_;
                if _e181 {
                    let _e183 = samples.member[_e76.first_primitive].flags;
                    let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                    phi_336_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, ((_e183 & 1u) == 0u));
                    phi_337_ = false;
                } else {
                    phi_336_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_337_ = true;
                }
                let _e202 = phi_336_;
                let _e204 = phi_337_;
                phi_338_ = _e202;
                phi_339_ = _e204;
            } else {
                phi_338_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_339_ = true;
            }
            let _e206 = phi_338_;
            let _e208 = phi_339_;
            if _e208 {
                let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e214.unnamed.visibility, false), _e214.unnamed_1);
                phi_346_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e220.unnamed, true);
            } else {
                phi_346_ = _e206;
            }
            let _e225 = phi_346_;
            phi_350_ = _e225;
        } else {
            let _e231 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e237 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e231.unnamed.visibility, false), _e231.unnamed_1);
            phi_350_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e237.unnamed, true);
        }
        let _e242 = phi_350_;
        if _e242.unnamed_1 {
            phi_1170_ = mask_Masked(_e242.unnamed.visibility, 0u, false, false);
        } else {
            let _e247 = (_e89 < 0.5f);
            if (_e89 > 0f) {
                phi_363_ = (_e89 < 1f);
            } else {
                phi_363_ = false;
            }
            let _e251 = phi_363_;
            let _e258 = lt_mask_Reprojection(vec2<u32>(_e55.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e265 = lt_mask_Reprojection(vec2<u32>(_e258.pixel.x, _e55.y), _e258.is_valid, _e258.has_moved);
            let _e269 = lt_mask_Reprojection(_e265.pixel, true, _e265.has_moved);
            let _e275 = p.member.flags;
            if ((_e275 & 16u) == 0u) {
                phi_402_ = false;
            } else {
                let _e281 = samples.member[_e76.first_primitive].position[0u];
                if (_e87.x == _e281) {
                    let _e285 = samples.member[_e76.first_primitive].position[1u];
                    if (_e87.y == _e285) {
                        let _e289 = samples.member[_e76.first_primitive].position[2u];
                        phi_394_ = (_e87.z == _e289);
                        phi_395_ = false;
                    } else {
                        phi_394_ = bool();
                        phi_395_ = true;
                    }
                    let _e292 = phi_394_;
                    let _e294 = phi_395_;
                    phi_396_ = _e292;
                    phi_397_ = _e294;
                } else {
                    phi_396_ = bool();
                    phi_397_ = true;
                }
                let _e296 = phi_396_;
                let _e298 = phi_397_;
                if _e298 {
                    phi_401_ = false;
                } else {
                    phi_401_ = _e296;
                }
                let _e300 = phi_401_;
                phi_402_ = _e300;
            }
            let _e302 = phi_402_;
            if _e302 {
                phi_718_ = lt_mask_Reprojection(_e269.pixel, _e269.is_valid, false);
                phi_719_ = lt_mask_Reprojection();
                phi_720_ = lt_mask_Reprojection();
                phi_721_ = true;
                phi_722_ = false;
            } else {
                let _e306 = p.member.current.grid[0u];
                let _e308 = p.member.current.grid[1u];
                let _e322 = (f32(_e55.x) + ((f32((_e55.y & (_e308 - 1u))) + 0.5f) / f32(_e308)));
                let _e324 = (f32(_e55.y) + ((f32((_e55.x & (_e306 - 1u))) + 0.5f) / f32(_e306)));
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
                        phi_548_ = 1f;
                    } else {
                        phi_548_ = 0f;
                    }
                    let _e442 = phi_548_;
                    if (_e427 < 8388608f) {
                        phi_553_ = (_e439 - _e442);
                        phi_554_ = false;
                    } else {
                        phi_553_ = f32();
                        phi_554_ = true;
                    }
                    let _e445 = phi_553_;
                    let _e447 = phi_554_;
                    phi_555_ = _e445;
                    phi_556_ = _e447;
                } else {
                    phi_555_ = f32();
                    phi_556_ = true;
                }
                let _e449 = phi_555_;
                let _e451 = phi_556_;
                if _e451 {
                    phi_560_ = _e427;
                } else {
                    phi_560_ = _e449;
                }
                let _e453 = phi_560_;
                let _e454 = (_e324 + _e419);
                if (_e454 > -8388608f) {
                    let _e466 = f32(select(0i, select(select(i32(_e454), i32(-2147483648), (_e454 < bitcast<f32>(3472883712u))), 2147483647i, (_e454 > bitcast<f32>(1325400063u))), (_e454 == _e454)));
                    if (_e466 > _e454) {
                        phi_581_ = 1f;
                    } else {
                        phi_581_ = 0f;
                    }
                    let _e469 = phi_581_;
                    if (_e454 < 8388608f) {
                        phi_586_ = (_e466 - _e469);
                        phi_587_ = false;
                    } else {
                        phi_586_ = f32();
                        phi_587_ = true;
                    }
                    let _e472 = phi_586_;
                    let _e474 = phi_587_;
                    phi_588_ = _e472;
                    phi_589_ = _e474;
                } else {
                    phi_588_ = f32();
                    phi_589_ = true;
                }
                let _e476 = phi_588_;
                let _e478 = phi_589_;
                if _e478 {
                    phi_593_ = _e454;
                } else {
                    phi_593_ = _e476;
                }
                let _e480 = phi_593_;
                if (_e453 >= 0f) {
                    if (_e480 >= 0f) {
                        if (_e453 < f32(_e423)) {
                            let _e486 = (_e480 < f32(_e425));
                            if (_e418 == 0f) {
                                phi_614_ = (_e419 == 0f);
                            } else {
                                phi_614_ = false;
                            }
                            let _e490 = phi_614_;
                            if _e486 {
                                phi_633_ = vec2<u32>(select(select(u32(_e453), 0u, (_e453 < bitcast<f32>(0u))), 4294967295u, (_e453 > bitcast<f32>(1333788671u))), select(select(u32(_e480), 0u, (_e480 < bitcast<f32>(0u))), 4294967295u, (_e480 > bitcast<f32>(1333788671u))));
                                phi_634_ = false;
                            } else {
                                phi_633_ = vec2<u32>();
                                phi_634_ = true;
                            }
                            let _e507 = phi_633_;
                            let _e509 = phi_634_;
                            phi_635_ = _e490;
                            phi_636_ = _e486;
                            phi_637_ = _e507;
                            phi_638_ = _e490;
                            phi_639_ = _e486;
                            phi_640_ = false;
                            phi_641_ = _e509;
                        } else {
                            phi_635_ = bool();
                            phi_636_ = bool();
                            phi_637_ = vec2<u32>();
                            phi_638_ = bool();
                            phi_639_ = bool();
                            phi_640_ = true;
                            phi_641_ = false;
                        }
                        let _e511 = phi_635_;
                        let _e513 = phi_636_;
                        let _e515 = phi_637_;
                        let _e517 = phi_638_;
                        let _e519 = phi_639_;
                        let _e521 = phi_640_;
                        let _e523 = phi_641_;
                        phi_642_ = _e511;
                        phi_643_ = _e513;
                        phi_644_ = _e515;
                        phi_645_ = _e517;
                        phi_646_ = _e519;
                        phi_647_ = _e521;
                        phi_648_ = _e523;
                    } else {
                        phi_642_ = bool();
                        phi_643_ = bool();
                        phi_644_ = vec2<u32>();
                        phi_645_ = bool();
                        phi_646_ = bool();
                        phi_647_ = true;
                        phi_648_ = false;
                    }
                    let _e525 = phi_642_;
                    let _e527 = phi_643_;
                    let _e529 = phi_644_;
                    let _e531 = phi_645_;
                    let _e533 = phi_646_;
                    let _e535 = phi_647_;
                    let _e537 = phi_648_;
                    phi_649_ = _e525;
                    phi_650_ = _e527;
                    phi_651_ = _e529;
                    phi_652_ = _e531;
                    phi_653_ = _e533;
                    phi_654_ = _e535;
                    phi_655_ = _e537;
                } else {
                    phi_649_ = bool();
                    phi_650_ = bool();
                    phi_651_ = vec2<u32>();
                    phi_652_ = bool();
                    phi_653_ = bool();
                    phi_654_ = true;
                    phi_655_ = false;
                }
                let _e539 = phi_649_;
                let _e541 = phi_650_;
                let _e543 = phi_651_;
                let _e545 = phi_652_;
                let _e547 = phi_653_;
                let _e549 = phi_654_;
                let _e551 = phi_655_;
                if _e549 {
                    if (_e418 == 0f) {
                        phi_664_ = (_e419 == 0f);
                    } else {
                        phi_664_ = false;
                    }
                    let _e555 = phi_664_;
                    phi_665_ = _e555;
                    phi_666_ = false;
                    phi_667_ = true;
                } else {
                    phi_665_ = _e545;
                    phi_666_ = _e547;
                    phi_667_ = _e551;
                }
                let _e557 = phi_665_;
                let _e559 = phi_666_;
                let _e561 = phi_667_;
                if _e561 {
                    phi_671_ = _e557;
                    phi_672_ = _e559;
                    phi_673_ = vec2<u32>(_e55.x, _e55.y);
                } else {
                    phi_671_ = _e539;
                    phi_672_ = _e541;
                    phi_673_ = _e543;
                }
                let _e563 = phi_671_;
                let _e565 = phi_672_;
                let _e567 = phi_673_;
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
                        phi_711_ = false;
                    } else {
                        phi_711_ = true;
                    }
                    let _e621 = phi_711_;
                    phi_713_ = _e619;
                    phi_714_ = _e619;
                    phi_715_ = lt_mask_Reprojection();
                    phi_716_ = _e615;
                    phi_717_ = _e621;
                } else {
                    phi_713_ = lt_mask_Reprojection();
                    phi_714_ = lt_mask_Reprojection();
                    phi_715_ = lt_mask_Reprojection(_e592.pixel, false, _e592.has_moved);
                    phi_716_ = false;
                    phi_717_ = false;
                }
                let _e627 = phi_713_;
                let _e629 = phi_714_;
                let _e631 = phi_715_;
                let _e633 = phi_716_;
                let _e635 = phi_717_;
                phi_718_ = _e627;
                phi_719_ = _e629;
                phi_720_ = _e631;
                phi_721_ = _e633;
                phi_722_ = _e635;
            }
            let _e637 = phi_718_;
            let _e639 = phi_719_;
            let _e641 = phi_720_;
            let _e643 = phi_721_;
            let _e645 = phi_722_;
            if _e643 {
                let _e648 = p.member.previous.eye;
                let _e659 = p.member.previous.forward;
                let _e667 = ((((_e87.x - _e648.x) * _e659.x) + ((_e87.y - _e648.y) * _e659.y)) + ((_e87.z - _e648.z) * _e659.z));
                let _e673 = ((_e637.pixel.y * _e84) + _e637.pixel.x);
                if (_e673 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e677 = last_depths.member[(0u + _e673)];
                let _e679 = p.member.depth_tolerance;
                let _e682 = abs(_e667);
                let _e683 = abs(_e677);
                if ((bitcast<u32>(_e683) & 2147483647u) > 2139095040u) {
                    phi_777_ = true;
                } else {
                    let _e687 = (_e683 > _e682);
                    if _e687 {
                    }
                    phi_777_ = _e687;
                }
                let _e689 = phi_777_;
                if _e689 {
                    phi_781_ = _e683;
                } else {
                    phi_781_ = _e682;
                }
                let _e691 = phi_781_;
                phi_785_ = lt_mask_Reprojection(_e637.pixel, (abs((_e667 - _e677)) <= (_e679 * _e691)), _e637.has_moved);
                phi_786_ = true;
            } else {
                phi_785_ = _e639;
                phi_786_ = _e645;
            }
            let _e699 = phi_785_;
            let _e701 = phi_786_;
            if _e701 {
                if _e699.is_valid {
                    let _e704 = p.member.flags;
                    phi_798_ = ((_e704 & 1u) != 0u);
                    phi_799_ = false;
                } else {
                    phi_798_ = bool();
                    phi_799_ = true;
                }
                let _e708 = phi_798_;
                let _e710 = phi_799_;
                phi_800_ = _e708;
                phi_801_ = _e699;
                phi_802_ = _e710;
            } else {
                phi_800_ = bool();
                phi_801_ = _e641;
                phi_802_ = true;
            }
            let _e712 = phi_800_;
            let _e714 = phi_801_;
            let _e716 = phi_802_;
            if _e716 {
                phi_806_ = false;
                phi_807_ = _e714;
            } else {
                phi_806_ = _e712;
                phi_807_ = _e699;
            }
            let _e718 = phi_806_;
            let _e720 = phi_807_;
            let _e724 = lt_mask_Reprojection(_e720.pixel, _e718, _e720.has_moved);
            let _e726 = p.member.flags;
            let _e728 = ((_e726 & 2u) != 0u);
            let _e730 = p.member.flags;
            if ((_e730 & 4u) == 0u) {
                phi_906_ = u32();
                phi_907_ = true;
                phi_908_ = false;
            } else {
                if _e718 {
                    if !(_e724.has_moved) {
                        if (32u == 0u) {
                            return;
                        }
                        let _e736 = (_e84 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e84 % 32u) > 0u) {
                            phi_845_ = (_e736 + 1u);
                        } else {
                            phi_845_ = _e736;
                        }
                        let _e742 = phi_845_;
                        let _e747 = ((((_e55.y * _e742) + (_e55.x / 32u)) * 6u) + 4u);
                        if (_e747 < _e61) {
                        } else {
                            return;
                        }
                        let _e751 = heard.member[(0u + _e747)];
                        if (((_e751 >> bitcast<u32>(((_e55.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e762 = ((((_e55.y * _e742) + (_e55.x / 32u)) * 6u) + 5u);
                            if (_e762 < _e61) {
                            } else {
                                return;
                            }
                            let _e766 = heard.member[(0u + _e762)];
                            if false {
                                phi_894_ = (2u | 1u);
                            } else {
                                phi_894_ = 2u;
                            }
                            let _e775 = phi_894_;
                            if (((_e766 >> bitcast<u32>(((_e55.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_899_ = (_e775 | 4u);
                            } else {
                                phi_899_ = _e775;
                            }
                            let _e778 = phi_899_;
                            phi_900_ = _e778;
                        } else {
                            phi_900_ = 0u;
                        }
                        let _e780 = phi_900_;
                        phi_901_ = _e780;
                        phi_902_ = false;
                    } else {
                        phi_901_ = u32();
                        phi_902_ = true;
                    }
                    let _e782 = phi_901_;
                    let _e784 = phi_902_;
                    phi_903_ = _e782;
                    phi_904_ = false;
                    phi_905_ = _e784;
                } else {
                    phi_903_ = u32();
                    phi_904_ = true;
                    phi_905_ = false;
                }
                let _e786 = phi_903_;
                let _e788 = phi_904_;
                let _e790 = phi_905_;
                phi_906_ = _e786;
                phi_907_ = _e788;
                phi_908_ = _e790;
            }
            let _e792 = phi_906_;
            let _e794 = phi_907_;
            let _e796 = phi_908_;
            if _e794 {
                phi_912_ = true;
            } else {
                phi_912_ = _e796;
            }
            let _e798 = phi_912_;
            if _e798 {
                phi_916_ = 0u;
            } else {
                phi_916_ = _e792;
            }
            let _e800 = phi_916_;
            let _e801 = lt_mask_Neighbourhood(false, true);
            if _e251 {
                phi_921_ = _e728;
            } else {
                phi_921_ = true;
            }
            let _e803 = phi_921_;
            if _e803 {
                if _e718 {
                    if ((_e800 & 2u) != 0u) {
                        phi_982_ = _e801;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e812 = (_e84 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e84 % 32u) > 0u) {
                            phi_953_ = (_e812 + 1u);
                        } else {
                            phi_953_ = _e812;
                        }
                        let _e818 = phi_953_;
                        let _e828 = ((((_e724.pixel.y * _e818) + (_e724.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e247) | (select(0u, 1u, _e724.has_moved) << bitcast<u32>(1i))));
                        if (_e828 < _e61) {
                        } else {
                            return;
                        }
                        let _e832 = heard.member[(0u + _e828)];
                        let _e838 = (((_e832 >> bitcast<u32>(((_e724.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_982_ = lt_mask_Neighbourhood(_e838, !(_e838));
                    }
                    let _e842 = phi_982_;
                    phi_983_ = _e842;
                } else {
                    phi_983_ = _e801;
                }
                let _e844 = phi_983_;
                phi_984_ = _e844;
            } else {
                phi_984_ = _e801;
            }
            let _e846 = phi_984_;
            let _e849 = p.member.frame;
            let _e851 = p.member.refresh;
            if (_e851 == 0u) {
                phi_1017_ = false;
            } else {
                if (_e851 == 0u) {
                    return;
                }
                let _e860 = ((_e55.x + (_e55.y * (((_e851 * 5u) / 8u) | 1u))) + (_e849 % _e851));
                if (_e851 == 0u) {
                    phi_1016_ = (_e860 == 0u);
                } else {
                    if (_e851 == 0u) {
                        return;
                    }
                    phi_1016_ = ((_e860 % _e851) == 0u);
                }
                let _e867 = phi_1016_;
                phi_1017_ = _e867;
            }
            let _e869 = phi_1017_;
            if _e718 {
                if _e869 {
                    phi_1039_ = bool();
                } else {
                    phi_1039_ = ((_e800 & 2u) != 0u);
                }
                let _e875 = phi_1039_;
                phi_1040_ = _e875;
                phi_1041_ = _e869;
            } else {
                phi_1040_ = bool();
                phi_1041_ = true;
            }
            let _e877 = phi_1040_;
            let _e879 = phi_1041_;
            if _e879 {
                phi_1045_ = false;
            } else {
                phi_1045_ = _e877;
            }
            let _e881 = phi_1045_;
            if _e881 {
                phi_1096_ = 7u;
            } else {
                if (_e89 != 0.5f) {
                    if _e718 {
                        if _e869 {
                            phi_1093_ = 6u;
                        } else {
                            if _e251 {
                                phi_1068_ = true;
                            } else {
                                if _e846.any_expands {
                                    phi_1067_ = false;
                                } else {
                                    phi_1067_ = true;
                                }
                                let _e883 = phi_1067_;
                                phi_1068_ = _e883;
                            }
                            let _e885 = phi_1068_;
                            if _e885 {
                                if _e251 {
                                    if _e728 {
                                        if _e846.all_remove {
                                            phi_1081_ = false;
                                        } else {
                                            phi_1081_ = true;
                                        }
                                        let _e887 = phi_1081_;
                                        phi_1082_ = _e887;
                                    } else {
                                        phi_1082_ = true;
                                    }
                                    let _e889 = phi_1082_;
                                    phi_1083_ = _e889;
                                } else {
                                    phi_1083_ = true;
                                }
                                let _e891 = phi_1083_;
                                if _e891 {
                                    if _e251 {
                                        phi_1090_ = 1u;
                                    } else {
                                        phi_1090_ = 0u;
                                    }
                                    let _e893 = phi_1090_;
                                    phi_1091_ = _e893;
                                } else {
                                    phi_1091_ = 5u;
                                }
                                let _e895 = phi_1091_;
                                phi_1092_ = _e895;
                            } else {
                                phi_1092_ = 4u;
                            }
                            let _e897 = phi_1092_;
                            phi_1093_ = _e897;
                        }
                        let _e899 = phi_1093_;
                        phi_1094_ = _e899;
                    } else {
                        phi_1094_ = 3u;
                    }
                    let _e901 = phi_1094_;
                    phi_1095_ = _e901;
                } else {
                    phi_1095_ = 2u;
                }
                let _e903 = phi_1095_;
                phi_1096_ = _e903;
            }
            let _e905 = phi_1096_;
            if !((_e905 == 0u)) {
                if !((_e905 == 5u)) {
                    phi_1108_ = !(_e881);
                    phi_1109_ = false;
                } else {
                    phi_1108_ = bool();
                    phi_1109_ = true;
                }
                let _e912 = phi_1108_;
                let _e914 = phi_1109_;
                phi_1110_ = _e912;
                phi_1111_ = _e914;
            } else {
                phi_1110_ = bool();
                phi_1111_ = true;
            }
            let _e916 = phi_1110_;
            let _e918 = phi_1111_;
            if _e918 {
                phi_1115_ = false;
            } else {
                phi_1115_ = _e916;
            }
            let _e920 = phi_1115_;
            if _e881 {
                phi_1121_ = ((_e800 & 4u) != 0u);
            } else {
                phi_1121_ = _e247;
            }
            let _e924 = phi_1121_;
            if _e920 {
                if _e247 {
                    phi_1129_ = (2u | 1u);
                } else {
                    phi_1129_ = 2u;
                }
                let _e927 = phi_1129_;
                if false {
                    phi_1134_ = (_e927 | 4u);
                } else {
                    phi_1134_ = _e927;
                }
                let _e930 = phi_1134_;
                phi_1154_ = _e930;
            } else {
                if (_e905 == 7u) {
                    if _e247 {
                        phi_1143_ = (2u | 1u);
                    } else {
                        phi_1143_ = 2u;
                    }
                    let _e934 = phi_1143_;
                    if _e924 {
                        phi_1148_ = (_e934 | 4u);
                    } else {
                        phi_1148_ = _e934;
                    }
                    let _e937 = phi_1148_;
                    phi_1153_ = _e937;
                } else {
                    if _e247 {
                        phi_1152_ = 1u;
                    } else {
                        phi_1152_ = 0u;
                    }
                    let _e939 = phi_1152_;
                    phi_1153_ = _e939;
                }
                let _e941 = phi_1153_;
                phi_1154_ = _e941;
            }
            let _e943 = phi_1154_;
            if _e924 {
                phi_1158_ = 0f;
            } else {
                phi_1158_ = 1f;
            }
            let _e945 = phi_1158_;
            if _e251 {
                if (_e89 == 0.99999994f) {
                    phi_1167_ = true;
                } else {
                    phi_1167_ = (_e89 == 0.000000059604645f);
                }
                let _e949 = phi_1167_;
                phi_1168_ = _e949;
            } else {
                phi_1168_ = true;
            }
            let _e951 = phi_1168_;
            phi_1170_ = mask_Masked(_e945, _e943, _e920, _e951);
        }
        let _e954 = phi_1170_;
        visibility.member[_e76.first_primitive] = _e954.visibility;
        let _e959 = p.member.light.number;
        let _e960 = (_e959 * 3u);
        let _e962 = (_e960 % 32u);
        let _e964 = p.member.light.mask_words;
        let _e966 = ((_e76.first_primitive * _e964) + (_e960 / 32u));
        let _e968 = bits.member[_e966];
        bits.member[_e966] = ((_e968 & ~((7u << bitcast<u32>((_e962 & 31u))))) | (_e954.bits << bitcast<u32>((_e962 & 31u))));
        if (_e962 > 29u) {
            let _e983 = bits.member[(_e966 + 1u)];
            let _e985 = (32u - _e962);
            bits.member[(_e966 + 1u)] = ((_e983 & ~((7u >> bitcast<u32>((_e985 & 31u))))) | (_e954.bits >> bitcast<u32>((_e985 & 31u))));
        }
        let _e1000 = samples.member[_e76.first_primitive].normal[0u];
        let _e1002 = global[0u];
        if (_e1000 == _e1002) {
            let _e1005 = samples.member[_e76.first_primitive].normal[1u];
            let _e1007 = global[1u];
            if (_e1005 == _e1007) {
                let _e1010 = samples.member[_e76.first_primitive].normal[2u];
                let _e1012 = global[2u];
                phi_1242_ = (_e1010 == _e1012);
                phi_1243_ = false;
            } else {
                phi_1242_ = bool();
                phi_1243_ = true;
            }
            let _e1015 = phi_1242_;
            let _e1017 = phi_1243_;
            phi_1244_ = _e1015;
            phi_1245_ = _e1017;
        } else {
            phi_1244_ = bool();
            phi_1245_ = true;
        }
        let _e1019 = phi_1244_;
        let _e1021 = phi_1245_;
        if _e1021 {
            phi_1249_ = false;
        } else {
            phi_1249_ = _e1019;
        }
        let _e1023 = phi_1249_;
        if !(_e1023) {
            let _e1026 = samples.member[_e76.first_primitive].position;
            let _e1028 = p.member.current.eye;
            let _e1039 = p.member.current.forward;
            phi_1277_ = ((((_e1026.x - _e1028.x) * _e1039.x) + ((_e1026.y - _e1028.y) * _e1039.y)) + ((_e1026.z - _e1028.z) * _e1039.z));
        } else {
            phi_1277_ = 0f;
        }
        let _e1049 = phi_1277_;
        depths.member[_e76.first_primitive] = _e1049;
        phi_1282_ = doubt_Listed(_e76.first_primitive, _e954.is_trusted);
        phi_1283_ = _e954.needs_ray;
    } else {
        phi_1282_ = doubt_Listed(0u, false);
        phi_1283_ = false;
    }
    let _e1055 = phi_1282_;
    let _e1057 = phi_1283_;
    if (_e56 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1057 {
        let _e1063 = atomicAdd((&shared_[0u]), 1u);
        phi_1296_ = _e1063;
    } else {
        phi_1296_ = 0u;
    }
    let _e1065 = phi_1296_;
    workgroupBarrier();
    if (_e56 == 0u) {
        let _e1069 = atomicLoad((&shared_[0u]));
        let _e1070 = atomicAdd((&list.member[3u]), _e1069);
        atomicStore((&shared_[1u]), _e1070);
    }
    workgroupBarrier();
    if _e1057 {
        if _e1055.is_trusted {
            phi_1313_ = (_e1055.pixel | 2147483648u);
        } else {
            phi_1313_ = _e1055.pixel;
        }
        let _e1074 = phi_1313_;
        let _e1076 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1076) + _e1065)]), _e1074);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
