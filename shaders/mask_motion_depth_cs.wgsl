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
    var phi_704_: bool;
    var phi_706_: lt_mask_Reprojection;
    var phi_707_: lt_mask_Reprojection;
    var phi_708_: lt_mask_Reprojection;
    var phi_709_: bool;
    var phi_710_: bool;
    var phi_711_: lt_mask_Reprojection;
    var phi_712_: lt_mask_Reprojection;
    var phi_713_: lt_mask_Reprojection;
    var phi_714_: bool;
    var phi_715_: bool;
    var phi_770_: bool;
    var phi_774_: f32;
    var phi_778_: lt_mask_Reprojection;
    var phi_779_: bool;
    var phi_791_: bool;
    var phi_792_: bool;
    var phi_793_: bool;
    var phi_794_: lt_mask_Reprojection;
    var phi_795_: bool;
    var phi_799_: bool;
    var phi_800_: lt_mask_Reprojection;
    var phi_838_: u32;
    var phi_887_: u32;
    var phi_892_: u32;
    var phi_893_: u32;
    var phi_894_: u32;
    var phi_895_: bool;
    var phi_896_: u32;
    var phi_897_: bool;
    var phi_898_: bool;
    var phi_899_: u32;
    var phi_900_: bool;
    var phi_901_: bool;
    var phi_905_: bool;
    var phi_909_: u32;
    var phi_914_: bool;
    var phi_946_: u32;
    var phi_975_: lt_mask_Neighbourhood;
    var phi_976_: lt_mask_Neighbourhood;
    var phi_977_: lt_mask_Neighbourhood;
    var phi_1009_: bool;
    var phi_1010_: bool;
    var phi_1032_: bool;
    var phi_1033_: bool;
    var phi_1034_: bool;
    var phi_1038_: bool;
    var phi_1060_: bool;
    var phi_1061_: bool;
    var phi_1074_: bool;
    var phi_1075_: bool;
    var phi_1076_: bool;
    var phi_1083_: u32;
    var phi_1084_: u32;
    var phi_1085_: u32;
    var phi_1086_: u32;
    var phi_1087_: u32;
    var phi_1088_: u32;
    var phi_1089_: u32;
    var phi_1101_: bool;
    var phi_1102_: bool;
    var phi_1103_: bool;
    var phi_1104_: bool;
    var phi_1108_: bool;
    var phi_1114_: bool;
    var phi_1122_: u32;
    var phi_1127_: u32;
    var phi_1136_: u32;
    var phi_1141_: u32;
    var phi_1145_: u32;
    var phi_1146_: u32;
    var phi_1147_: u32;
    var phi_1151_: f32;
    var phi_1160_: bool;
    var phi_1161_: bool;
    var phi_1163_: mask_Masked;
    var phi_1235_: bool;
    var phi_1236_: bool;
    var phi_1237_: bool;
    var phi_1238_: bool;
    var phi_1242_: bool;
    var phi_1270_: f32;
    var phi_1275_: doubt_Listed;
    var phi_1276_: bool;
    var phi_1289_: u32;
    var phi_1306_: u32;

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
            phi_1163_ = mask_Masked(_e242.unnamed.visibility, 0u, false, false);
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
                phi_711_ = lt_mask_Reprojection(_e269.pixel, _e269.is_valid, false);
                phi_712_ = lt_mask_Reprojection();
                phi_713_ = lt_mask_Reprojection();
                phi_714_ = true;
                phi_715_ = false;
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
                        phi_541_ = 1f;
                    } else {
                        phi_541_ = 0f;
                    }
                    let _e435 = phi_541_;
                    if (_e420 < 8388608f) {
                        phi_546_ = (_e432 - _e435);
                        phi_547_ = false;
                    } else {
                        phi_546_ = f32();
                        phi_547_ = true;
                    }
                    let _e438 = phi_546_;
                    let _e440 = phi_547_;
                    phi_548_ = _e438;
                    phi_549_ = _e440;
                } else {
                    phi_548_ = f32();
                    phi_549_ = true;
                }
                let _e442 = phi_548_;
                let _e444 = phi_549_;
                if _e444 {
                    phi_553_ = _e420;
                } else {
                    phi_553_ = _e442;
                }
                let _e446 = phi_553_;
                let _e447 = (_e324 + _e412);
                if (_e447 > -8388608f) {
                    let _e459 = f32(select(0i, select(select(i32(_e447), i32(-2147483648), (_e447 < bitcast<f32>(3472883712u))), 2147483647i, (_e447 > bitcast<f32>(1325400063u))), (_e447 == _e447)));
                    if (_e459 > _e447) {
                        phi_574_ = 1f;
                    } else {
                        phi_574_ = 0f;
                    }
                    let _e462 = phi_574_;
                    if (_e447 < 8388608f) {
                        phi_579_ = (_e459 - _e462);
                        phi_580_ = false;
                    } else {
                        phi_579_ = f32();
                        phi_580_ = true;
                    }
                    let _e465 = phi_579_;
                    let _e467 = phi_580_;
                    phi_581_ = _e465;
                    phi_582_ = _e467;
                } else {
                    phi_581_ = f32();
                    phi_582_ = true;
                }
                let _e469 = phi_581_;
                let _e471 = phi_582_;
                if _e471 {
                    phi_586_ = _e447;
                } else {
                    phi_586_ = _e469;
                }
                let _e473 = phi_586_;
                if (_e446 >= 0f) {
                    if (_e473 >= 0f) {
                        if (_e446 < f32(_e416)) {
                            let _e479 = (_e473 < f32(_e418));
                            if (_e411 == 0f) {
                                phi_607_ = (_e412 == 0f);
                            } else {
                                phi_607_ = false;
                            }
                            let _e483 = phi_607_;
                            if _e479 {
                                phi_626_ = vec2<u32>(select(select(u32(_e446), 0u, (_e446 < bitcast<f32>(0u))), 4294967295u, (_e446 > bitcast<f32>(1333788671u))), select(select(u32(_e473), 0u, (_e473 < bitcast<f32>(0u))), 4294967295u, (_e473 > bitcast<f32>(1333788671u))));
                                phi_627_ = false;
                            } else {
                                phi_626_ = vec2<u32>();
                                phi_627_ = true;
                            }
                            let _e500 = phi_626_;
                            let _e502 = phi_627_;
                            phi_628_ = _e483;
                            phi_629_ = _e479;
                            phi_630_ = _e500;
                            phi_631_ = _e483;
                            phi_632_ = _e479;
                            phi_633_ = false;
                            phi_634_ = _e502;
                        } else {
                            phi_628_ = bool();
                            phi_629_ = bool();
                            phi_630_ = vec2<u32>();
                            phi_631_ = bool();
                            phi_632_ = bool();
                            phi_633_ = true;
                            phi_634_ = false;
                        }
                        let _e504 = phi_628_;
                        let _e506 = phi_629_;
                        let _e508 = phi_630_;
                        let _e510 = phi_631_;
                        let _e512 = phi_632_;
                        let _e514 = phi_633_;
                        let _e516 = phi_634_;
                        phi_635_ = _e504;
                        phi_636_ = _e506;
                        phi_637_ = _e508;
                        phi_638_ = _e510;
                        phi_639_ = _e512;
                        phi_640_ = _e514;
                        phi_641_ = _e516;
                    } else {
                        phi_635_ = bool();
                        phi_636_ = bool();
                        phi_637_ = vec2<u32>();
                        phi_638_ = bool();
                        phi_639_ = bool();
                        phi_640_ = true;
                        phi_641_ = false;
                    }
                    let _e518 = phi_635_;
                    let _e520 = phi_636_;
                    let _e522 = phi_637_;
                    let _e524 = phi_638_;
                    let _e526 = phi_639_;
                    let _e528 = phi_640_;
                    let _e530 = phi_641_;
                    phi_642_ = _e518;
                    phi_643_ = _e520;
                    phi_644_ = _e522;
                    phi_645_ = _e524;
                    phi_646_ = _e526;
                    phi_647_ = _e528;
                    phi_648_ = _e530;
                } else {
                    phi_642_ = bool();
                    phi_643_ = bool();
                    phi_644_ = vec2<u32>();
                    phi_645_ = bool();
                    phi_646_ = bool();
                    phi_647_ = true;
                    phi_648_ = false;
                }
                let _e532 = phi_642_;
                let _e534 = phi_643_;
                let _e536 = phi_644_;
                let _e538 = phi_645_;
                let _e540 = phi_646_;
                let _e542 = phi_647_;
                let _e544 = phi_648_;
                if _e542 {
                    if (_e411 == 0f) {
                        phi_657_ = (_e412 == 0f);
                    } else {
                        phi_657_ = false;
                    }
                    let _e548 = phi_657_;
                    phi_658_ = _e548;
                    phi_659_ = false;
                    phi_660_ = true;
                } else {
                    phi_658_ = _e538;
                    phi_659_ = _e540;
                    phi_660_ = _e544;
                }
                let _e550 = phi_658_;
                let _e552 = phi_659_;
                let _e554 = phi_660_;
                if _e554 {
                    phi_664_ = _e550;
                    phi_665_ = _e552;
                    phi_666_ = vec2<u32>(_e55.x, _e55.y);
                } else {
                    phi_664_ = _e532;
                    phi_665_ = _e534;
                    phi_666_ = _e536;
                }
                let _e556 = phi_664_;
                let _e558 = phi_665_;
                let _e560 = phi_666_;
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
                        phi_704_ = false;
                    } else {
                        phi_704_ = true;
                    }
                    let _e614 = phi_704_;
                    phi_706_ = _e612;
                    phi_707_ = _e612;
                    phi_708_ = lt_mask_Reprojection();
                    phi_709_ = _e608;
                    phi_710_ = _e614;
                } else {
                    phi_706_ = lt_mask_Reprojection();
                    phi_707_ = lt_mask_Reprojection();
                    phi_708_ = lt_mask_Reprojection(_e585.pixel, false, _e585.has_moved);
                    phi_709_ = false;
                    phi_710_ = false;
                }
                let _e620 = phi_706_;
                let _e622 = phi_707_;
                let _e624 = phi_708_;
                let _e626 = phi_709_;
                let _e628 = phi_710_;
                phi_711_ = _e620;
                phi_712_ = _e622;
                phi_713_ = _e624;
                phi_714_ = _e626;
                phi_715_ = _e628;
            }
            let _e630 = phi_711_;
            let _e632 = phi_712_;
            let _e634 = phi_713_;
            let _e636 = phi_714_;
            let _e638 = phi_715_;
            if _e636 {
                let _e641 = p.member.previous.eye;
                let _e652 = p.member.previous.forward;
                let _e660 = ((((_e87.x - _e641.x) * _e652.x) + ((_e87.y - _e641.y) * _e652.y)) + ((_e87.z - _e641.z) * _e652.z));
                let _e666 = ((_e630.pixel.y * _e84) + _e630.pixel.x);
                if (_e666 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e670 = last_depths.member[(0u + _e666)];
                let _e672 = p.member.depth_tolerance;
                let _e675 = abs(_e660);
                let _e676 = abs(_e670);
                if ((bitcast<u32>(_e676) & 2147483647u) > 2139095040u) {
                    phi_770_ = true;
                } else {
                    let _e680 = (_e676 > _e675);
                    if _e680 {
                    }
                    phi_770_ = _e680;
                }
                let _e682 = phi_770_;
                if _e682 {
                    phi_774_ = _e676;
                } else {
                    phi_774_ = _e675;
                }
                let _e684 = phi_774_;
                phi_778_ = lt_mask_Reprojection(_e630.pixel, (abs((_e660 - _e670)) <= (_e672 * _e684)), _e630.has_moved);
                phi_779_ = true;
            } else {
                phi_778_ = _e632;
                phi_779_ = _e638;
            }
            let _e692 = phi_778_;
            let _e694 = phi_779_;
            if _e694 {
                if _e692.is_valid {
                    let _e697 = p.member.flags;
                    phi_791_ = ((_e697 & 1u) != 0u);
                    phi_792_ = false;
                } else {
                    phi_791_ = bool();
                    phi_792_ = true;
                }
                let _e701 = phi_791_;
                let _e703 = phi_792_;
                phi_793_ = _e701;
                phi_794_ = _e692;
                phi_795_ = _e703;
            } else {
                phi_793_ = bool();
                phi_794_ = _e634;
                phi_795_ = true;
            }
            let _e705 = phi_793_;
            let _e707 = phi_794_;
            let _e709 = phi_795_;
            if _e709 {
                phi_799_ = false;
                phi_800_ = _e707;
            } else {
                phi_799_ = _e705;
                phi_800_ = _e692;
            }
            let _e711 = phi_799_;
            let _e713 = phi_800_;
            let _e717 = lt_mask_Reprojection(_e713.pixel, _e711, _e713.has_moved);
            let _e719 = p.member.flags;
            let _e721 = ((_e719 & 2u) != 0u);
            let _e723 = p.member.flags;
            if ((_e723 & 4u) == 0u) {
                phi_899_ = u32();
                phi_900_ = true;
                phi_901_ = false;
            } else {
                if _e711 {
                    if !(_e717.has_moved) {
                        if (32u == 0u) {
                            return;
                        }
                        let _e729 = (_e84 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e84 % 32u) > 0u) {
                            phi_838_ = (_e729 + 1u);
                        } else {
                            phi_838_ = _e729;
                        }
                        let _e735 = phi_838_;
                        let _e740 = ((((_e55.y * _e735) + (_e55.x / 32u)) * 6u) + 4u);
                        if (_e740 < _e61) {
                        } else {
                            return;
                        }
                        let _e744 = heard.member[(0u + _e740)];
                        if (((_e744 >> bitcast<u32>(((_e55.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e755 = ((((_e55.y * _e735) + (_e55.x / 32u)) * 6u) + 5u);
                            if (_e755 < _e61) {
                            } else {
                                return;
                            }
                            let _e759 = heard.member[(0u + _e755)];
                            if false {
                                phi_887_ = (2u | 1u);
                            } else {
                                phi_887_ = 2u;
                            }
                            let _e768 = phi_887_;
                            if (((_e759 >> bitcast<u32>(((_e55.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_892_ = (_e768 | 4u);
                            } else {
                                phi_892_ = _e768;
                            }
                            let _e771 = phi_892_;
                            phi_893_ = _e771;
                        } else {
                            phi_893_ = 0u;
                        }
                        let _e773 = phi_893_;
                        phi_894_ = _e773;
                        phi_895_ = false;
                    } else {
                        phi_894_ = u32();
                        phi_895_ = true;
                    }
                    let _e775 = phi_894_;
                    let _e777 = phi_895_;
                    phi_896_ = _e775;
                    phi_897_ = false;
                    phi_898_ = _e777;
                } else {
                    phi_896_ = u32();
                    phi_897_ = true;
                    phi_898_ = false;
                }
                let _e779 = phi_896_;
                let _e781 = phi_897_;
                let _e783 = phi_898_;
                phi_899_ = _e779;
                phi_900_ = _e781;
                phi_901_ = _e783;
            }
            let _e785 = phi_899_;
            let _e787 = phi_900_;
            let _e789 = phi_901_;
            if _e787 {
                phi_905_ = true;
            } else {
                phi_905_ = _e789;
            }
            let _e791 = phi_905_;
            if _e791 {
                phi_909_ = 0u;
            } else {
                phi_909_ = _e785;
            }
            let _e793 = phi_909_;
            let _e794 = lt_mask_Neighbourhood(false, true);
            if _e251 {
                phi_914_ = _e721;
            } else {
                phi_914_ = true;
            }
            let _e796 = phi_914_;
            if _e796 {
                if _e711 {
                    if ((_e793 & 2u) != 0u) {
                        phi_975_ = _e794;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e805 = (_e84 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e84 % 32u) > 0u) {
                            phi_946_ = (_e805 + 1u);
                        } else {
                            phi_946_ = _e805;
                        }
                        let _e811 = phi_946_;
                        let _e821 = ((((_e717.pixel.y * _e811) + (_e717.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e247) | (select(0u, 1u, _e717.has_moved) << bitcast<u32>(1i))));
                        if (_e821 < _e61) {
                        } else {
                            return;
                        }
                        let _e825 = heard.member[(0u + _e821)];
                        let _e831 = (((_e825 >> bitcast<u32>(((_e717.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_975_ = lt_mask_Neighbourhood(_e831, !(_e831));
                    }
                    let _e835 = phi_975_;
                    phi_976_ = _e835;
                } else {
                    phi_976_ = _e794;
                }
                let _e837 = phi_976_;
                phi_977_ = _e837;
            } else {
                phi_977_ = _e794;
            }
            let _e839 = phi_977_;
            let _e842 = p.member.frame;
            let _e844 = p.member.refresh;
            if (_e844 == 0u) {
                phi_1010_ = false;
            } else {
                if (_e844 == 0u) {
                    return;
                }
                let _e853 = ((_e55.x + (_e55.y * (((_e844 * 5u) / 8u) | 1u))) + (_e842 % _e844));
                if (_e844 == 0u) {
                    phi_1009_ = (_e853 == 0u);
                } else {
                    if (_e844 == 0u) {
                        return;
                    }
                    phi_1009_ = ((_e853 % _e844) == 0u);
                }
                let _e860 = phi_1009_;
                phi_1010_ = _e860;
            }
            let _e862 = phi_1010_;
            if _e711 {
                if _e862 {
                    phi_1032_ = bool();
                } else {
                    phi_1032_ = ((_e793 & 2u) != 0u);
                }
                let _e868 = phi_1032_;
                phi_1033_ = _e868;
                phi_1034_ = _e862;
            } else {
                phi_1033_ = bool();
                phi_1034_ = true;
            }
            let _e870 = phi_1033_;
            let _e872 = phi_1034_;
            if _e872 {
                phi_1038_ = false;
            } else {
                phi_1038_ = _e870;
            }
            let _e874 = phi_1038_;
            if _e874 {
                phi_1089_ = 7u;
            } else {
                if (_e89 != 0.5f) {
                    if _e711 {
                        if _e862 {
                            phi_1086_ = 6u;
                        } else {
                            if _e251 {
                                phi_1061_ = true;
                            } else {
                                if _e839.any_expands {
                                    phi_1060_ = false;
                                } else {
                                    phi_1060_ = true;
                                }
                                let _e876 = phi_1060_;
                                phi_1061_ = _e876;
                            }
                            let _e878 = phi_1061_;
                            if _e878 {
                                if _e251 {
                                    if _e721 {
                                        if _e839.all_remove {
                                            phi_1074_ = false;
                                        } else {
                                            phi_1074_ = true;
                                        }
                                        let _e880 = phi_1074_;
                                        phi_1075_ = _e880;
                                    } else {
                                        phi_1075_ = true;
                                    }
                                    let _e882 = phi_1075_;
                                    phi_1076_ = _e882;
                                } else {
                                    phi_1076_ = true;
                                }
                                let _e884 = phi_1076_;
                                if _e884 {
                                    if _e251 {
                                        phi_1083_ = 1u;
                                    } else {
                                        phi_1083_ = 0u;
                                    }
                                    let _e886 = phi_1083_;
                                    phi_1084_ = _e886;
                                } else {
                                    phi_1084_ = 5u;
                                }
                                let _e888 = phi_1084_;
                                phi_1085_ = _e888;
                            } else {
                                phi_1085_ = 4u;
                            }
                            let _e890 = phi_1085_;
                            phi_1086_ = _e890;
                        }
                        let _e892 = phi_1086_;
                        phi_1087_ = _e892;
                    } else {
                        phi_1087_ = 3u;
                    }
                    let _e894 = phi_1087_;
                    phi_1088_ = _e894;
                } else {
                    phi_1088_ = 2u;
                }
                let _e896 = phi_1088_;
                phi_1089_ = _e896;
            }
            let _e898 = phi_1089_;
            if !((_e898 == 0u)) {
                if !((_e898 == 5u)) {
                    phi_1101_ = !(_e874);
                    phi_1102_ = false;
                } else {
                    phi_1101_ = bool();
                    phi_1102_ = true;
                }
                let _e905 = phi_1101_;
                let _e907 = phi_1102_;
                phi_1103_ = _e905;
                phi_1104_ = _e907;
            } else {
                phi_1103_ = bool();
                phi_1104_ = true;
            }
            let _e909 = phi_1103_;
            let _e911 = phi_1104_;
            if _e911 {
                phi_1108_ = false;
            } else {
                phi_1108_ = _e909;
            }
            let _e913 = phi_1108_;
            if _e874 {
                phi_1114_ = ((_e793 & 4u) != 0u);
            } else {
                phi_1114_ = _e247;
            }
            let _e917 = phi_1114_;
            if _e913 {
                if _e247 {
                    phi_1122_ = (2u | 1u);
                } else {
                    phi_1122_ = 2u;
                }
                let _e920 = phi_1122_;
                if false {
                    phi_1127_ = (_e920 | 4u);
                } else {
                    phi_1127_ = _e920;
                }
                let _e923 = phi_1127_;
                phi_1147_ = _e923;
            } else {
                if (_e898 == 7u) {
                    if _e247 {
                        phi_1136_ = (2u | 1u);
                    } else {
                        phi_1136_ = 2u;
                    }
                    let _e927 = phi_1136_;
                    if _e917 {
                        phi_1141_ = (_e927 | 4u);
                    } else {
                        phi_1141_ = _e927;
                    }
                    let _e930 = phi_1141_;
                    phi_1146_ = _e930;
                } else {
                    if _e247 {
                        phi_1145_ = 1u;
                    } else {
                        phi_1145_ = 0u;
                    }
                    let _e932 = phi_1145_;
                    phi_1146_ = _e932;
                }
                let _e934 = phi_1146_;
                phi_1147_ = _e934;
            }
            let _e936 = phi_1147_;
            if _e917 {
                phi_1151_ = 0f;
            } else {
                phi_1151_ = 1f;
            }
            let _e938 = phi_1151_;
            if _e251 {
                if (_e89 == 0.99999994f) {
                    phi_1160_ = true;
                } else {
                    phi_1160_ = (_e89 == 0.000000059604645f);
                }
                let _e942 = phi_1160_;
                phi_1161_ = _e942;
            } else {
                phi_1161_ = true;
            }
            let _e944 = phi_1161_;
            phi_1163_ = mask_Masked(_e938, _e936, _e913, _e944);
        }
        let _e947 = phi_1163_;
        visibility.member[_e76.first_primitive] = _e947.visibility;
        let _e952 = p.member.light.number;
        let _e953 = (_e952 * 3u);
        let _e955 = (_e953 % 32u);
        let _e957 = p.member.light.mask_words;
        let _e959 = ((_e76.first_primitive * _e957) + (_e953 / 32u));
        let _e961 = bits.member[_e959];
        bits.member[_e959] = ((_e961 & ~((7u << bitcast<u32>((_e955 & 31u))))) | (_e947.bits << bitcast<u32>((_e955 & 31u))));
        if (_e955 > 29u) {
            let _e976 = bits.member[(_e959 + 1u)];
            let _e978 = (32u - _e955);
            bits.member[(_e959 + 1u)] = ((_e976 & ~((7u >> bitcast<u32>((_e978 & 31u))))) | (_e947.bits >> bitcast<u32>((_e978 & 31u))));
        }
        let _e993 = samples.member[_e76.first_primitive].normal[0u];
        let _e995 = global[0u];
        if (_e993 == _e995) {
            let _e998 = samples.member[_e76.first_primitive].normal[1u];
            let _e1000 = global[1u];
            if (_e998 == _e1000) {
                let _e1003 = samples.member[_e76.first_primitive].normal[2u];
                let _e1005 = global[2u];
                phi_1235_ = (_e1003 == _e1005);
                phi_1236_ = false;
            } else {
                phi_1235_ = bool();
                phi_1236_ = true;
            }
            let _e1008 = phi_1235_;
            let _e1010 = phi_1236_;
            phi_1237_ = _e1008;
            phi_1238_ = _e1010;
        } else {
            phi_1237_ = bool();
            phi_1238_ = true;
        }
        let _e1012 = phi_1237_;
        let _e1014 = phi_1238_;
        if _e1014 {
            phi_1242_ = false;
        } else {
            phi_1242_ = _e1012;
        }
        let _e1016 = phi_1242_;
        if !(_e1016) {
            let _e1019 = samples.member[_e76.first_primitive].position;
            let _e1021 = p.member.current.eye;
            let _e1032 = p.member.current.forward;
            phi_1270_ = ((((_e1019.x - _e1021.x) * _e1032.x) + ((_e1019.y - _e1021.y) * _e1032.y)) + ((_e1019.z - _e1021.z) * _e1032.z));
        } else {
            phi_1270_ = 0f;
        }
        let _e1042 = phi_1270_;
        depths.member[_e76.first_primitive] = _e1042;
        phi_1275_ = doubt_Listed(_e76.first_primitive, _e947.is_trusted);
        phi_1276_ = _e947.needs_ray;
    } else {
        phi_1275_ = doubt_Listed(0u, false);
        phi_1276_ = false;
    }
    let _e1048 = phi_1275_;
    let _e1050 = phi_1276_;
    if (_e56 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1050 {
        let _e1056 = atomicAdd((&shared_[0u]), 1u);
        phi_1289_ = _e1056;
    } else {
        phi_1289_ = 0u;
    }
    let _e1058 = phi_1289_;
    workgroupBarrier();
    if (_e56 == 0u) {
        let _e1062 = atomicLoad((&shared_[0u]));
        let _e1063 = atomicAdd((&list.member[3u]), _e1062);
        atomicStore((&shared_[1u]), _e1063);
    }
    workgroupBarrier();
    if _e1050 {
        if _e1048.is_trusted {
            phi_1306_ = (_e1048.pixel | 2147483648u);
        } else {
            phi_1306_ = _e1048.pixel;
        }
        let _e1067 = phi_1306_;
        let _e1069 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1069) + _e1058)]), _e1067);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
