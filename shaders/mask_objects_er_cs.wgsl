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
    var phi_163_: lt_bvh_traverse_Tree;
    var phi_164_: bool;
    var phi_165_: lt_bvh_traverse_Tree;
    var phi_166_: bool;
    var phi_171_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_163_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_164_ = false;
        } else {
            phi_163_ = lt_bvh_traverse_Tree();
            phi_164_ = true;
        }
        let _e62 = phi_163_;
        let _e64 = phi_164_;
        phi_165_ = _e62;
        phi_166_ = _e64;
    } else {
        phi_165_ = lt_bvh_traverse_Tree();
        phi_166_ = true;
    }
    let _e66 = phi_165_;
    let _e68 = phi_166_;
    if _e68 {
        phi_171_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_171_ = _e66;
    }
    let _e73 = phi_171_;
    return lt_bvh_traverse_Tree(_e73.root, _e73.first_primitive);
}

fn function_() {
    var phi_217_: u32;
    var phi_254_: bool;
    var phi_255_: bool;
    var phi_256_: bool;
    var phi_257_: bool;
    var phi_261_: bool;
    var phi_331_: bool;
    var phi_332_: bool;
    var phi_343_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_344_: bool;
    var phi_345_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_346_: bool;
    var phi_353_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_357_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_370_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_401_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_614_: f32;
    var phi_619_: f32;
    var phi_620_: bool;
    var phi_621_: f32;
    var phi_622_: bool;
    var phi_626_: f32;
    var phi_647_: f32;
    var phi_652_: f32;
    var phi_653_: bool;
    var phi_654_: f32;
    var phi_655_: bool;
    var phi_659_: f32;
    var phi_680_: bool;
    var phi_699_: vec2<u32>;
    var phi_700_: bool;
    var phi_701_: bool;
    var phi_702_: bool;
    var phi_703_: vec2<u32>;
    var phi_704_: bool;
    var phi_705_: bool;
    var phi_706_: bool;
    var phi_707_: bool;
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_710_: vec2<u32>;
    var phi_711_: bool;
    var phi_712_: bool;
    var phi_713_: bool;
    var phi_714_: bool;
    var phi_715_: bool;
    var phi_716_: bool;
    var phi_717_: vec2<u32>;
    var phi_718_: bool;
    var phi_719_: bool;
    var phi_720_: bool;
    var phi_721_: bool;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_732_: bool;
    var phi_733_: bool;
    var phi_737_: bool;
    var phi_738_: bool;
    var phi_739_: vec2<u32>;
    var phi_774_: bool;
    var phi_776_: lt_mask_Reprojection;
    var phi_777_: lt_mask_Reprojection;
    var phi_778_: bool;
    var phi_782_: bool;
    var phi_783_: lt_mask_Reprojection;
    var phi_784_: lt_mask_Reprojection;
    var phi_785_: bool;
    var phi_793_: bool;
    var phi_794_: lt_mask_Reprojection;
    var phi_800_: bool;
    var phi_840_: lt_mask_Neighbourhood;
    var phi_841_: lt_mask_Neighbourhood;
    var phi_842_: lt_mask_Neighbourhood;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_897_: bool;
    var phi_898_: bool;
    var phi_899_: bool;
    var phi_903_: bool;
    var phi_925_: bool;
    var phi_926_: bool;
    var phi_939_: bool;
    var phi_940_: bool;
    var phi_941_: bool;
    var phi_948_: u32;
    var phi_949_: u32;
    var phi_950_: u32;
    var phi_951_: u32;
    var phi_952_: u32;
    var phi_953_: u32;
    var phi_954_: u32;
    var phi_966_: bool;
    var phi_967_: bool;
    var phi_968_: bool;
    var phi_969_: bool;
    var phi_973_: bool;
    var phi_979_: bool;
    var phi_987_: u32;
    var phi_992_: u32;
    var phi_1001_: u32;
    var phi_1006_: u32;
    var phi_1010_: u32;
    var phi_1011_: u32;
    var phi_1012_: u32;
    var phi_1016_: f32;
    var phi_1018_: mask_Masked;
    var phi_1068_: bool;
    var phi_1069_: u32;
    var phi_1080_: u32;

    let _e49 = id_1;
    let _e50 = local_1;
    let _e63 = p.member.current.size[0u];
    let _e65 = p.member.current.size[1u];
    let _e66 = lt_shaders_entry_pixel_index(_e49, _e63, _e65);
    if (bitcast<i32>(_e66.root) != 0i) {
        let _e74 = p.member.current.size[0u];
        if (32u == 0u) {
            return;
        }
        let _e76 = (_e74 / 32u);
        if (32u == 0u) {
            return;
        }
        if ((_e74 % 32u) > 0u) {
            phi_217_ = (_e76 + 1u);
        } else {
            phi_217_ = _e76;
        }
        let _e82 = phi_217_;
        let _e85 = past.member[_e66.first_primitive];
        let _e90 = visibility.member[_e66.first_primitive];
        let _e96 = samples.member[_e66.first_primitive].normal[0u];
        let _e98 = global[0u];
        if (_e96 == _e98) {
            let _e101 = samples.member[_e66.first_primitive].normal[1u];
            let _e103 = global[1u];
            if (_e101 == _e103) {
                let _e106 = samples.member[_e66.first_primitive].normal[2u];
                let _e108 = global[2u];
                phi_254_ = (_e106 == _e108);
                phi_255_ = false;
            } else {
                phi_254_ = bool();
                phi_255_ = true;
            }
            let _e111 = phi_254_;
            let _e113 = phi_255_;
            phi_256_ = _e111;
            phi_257_ = _e113;
        } else {
            phi_256_ = bool();
            phi_257_ = true;
        }
        let _e115 = phi_256_;
        let _e117 = phi_257_;
        if _e117 {
            phi_261_ = false;
        } else {
            phi_261_ = _e115;
        }
        let _e119 = phi_261_;
        if !(_e119) {
            let _e122 = samples.member[_e66.first_primitive].position;
            let _e124 = p.member.light.place;
            let _e130 = p.member.light.place[3u];
            let _e137 = (_e124.x - (_e122.x * _e130));
            let _e138 = (_e124.y - (_e122.y * _e130));
            let _e139 = (_e124.z - (_e122.z * _e130));
            let _e141 = samples.member[_e66.first_primitive].normal;
            if ((((_e141.x * _e137) + (_e141.y * _e138)) + (_e141.z * _e139)) > 0f) {
                let _e155 = (((_e137 * _e137) + (_e138 * _e138)) + (_e139 * _e139));
                let _e157 = p.member.light.axis;
                let _e169 = p.member.light.place[3u];
                if (_e169 == 0f) {
                    phi_332_ = true;
                } else {
                    let _e172 = p.member.light.range_squared;
                    if (_e155 <= _e172) {
                        let _e175 = p.member.light.cos_outer;
                        phi_331_ = (-((((_e137 * _e157.x) + (_e138 * _e157.y)) + (_e139 * _e157.z))) >= (_e175 * sqrt(_e155)));
                    } else {
                        phi_331_ = false;
                    }
                    let _e180 = phi_331_;
                    phi_332_ = _e180;
                }
                let _e182 = phi_332_;
                if _e182 {
                    let _e184 = samples.member[_e66.first_primitive].flags;
                    let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e198 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e192.unnamed.visibility, false), _e192.unnamed_1);
                    phi_343_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e198.unnamed, ((_e184 & 1u) == 0u));
                    phi_344_ = false;
                } else {
                    phi_343_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_344_ = true;
                }
                let _e203 = phi_343_;
                let _e205 = phi_344_;
                phi_345_ = _e203;
                phi_346_ = _e205;
            } else {
                phi_345_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_346_ = true;
            }
            let _e207 = phi_345_;
            let _e209 = phi_346_;
            if _e209 {
                let _e215 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e215.unnamed.visibility, false), _e215.unnamed_1);
                phi_353_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e221.unnamed, true);
            } else {
                phi_353_ = _e207;
            }
            let _e226 = phi_353_;
            phi_357_ = _e226;
        } else {
            let _e232 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e238 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e232.unnamed.visibility, false), _e232.unnamed_1);
            phi_357_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e238.unnamed, true);
        }
        let _e243 = phi_357_;
        if _e243.unnamed_1 {
            phi_1018_ = mask_Masked(_e243.unnamed.visibility, 0u, false);
        } else {
            let _e248 = (_e90 < 0.5f);
            if (_e90 > 0f) {
                phi_370_ = (_e90 < 1f);
            } else {
                phi_370_ = false;
            }
            let _e252 = phi_370_;
            let _e259 = lt_mask_Reprojection(vec2<u32>(_e49.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e266 = lt_mask_Reprojection(vec2<u32>(_e259.pixel.x, _e49.y), _e259.is_valid, _e259.has_moved);
            let _e270 = lt_mask_Reprojection(_e266.pixel, true, _e266.has_moved);
            let _e276 = p.member.flags;
            if ((_e276 & 16u) == 0u) {
                phi_406_ = false;
            } else {
                let _e281 = samples.member[_e66.first_primitive].position[0u];
                if (_e85.x == _e281) {
                    let _e284 = samples.member[_e66.first_primitive].position[1u];
                    if (_e85.y == _e284) {
                        let _e287 = samples.member[_e66.first_primitive].position[2u];
                        phi_398_ = (_e85.z == _e287);
                        phi_399_ = false;
                    } else {
                        phi_398_ = bool();
                        phi_399_ = true;
                    }
                    let _e290 = phi_398_;
                    let _e292 = phi_399_;
                    phi_400_ = _e290;
                    phi_401_ = _e292;
                } else {
                    phi_400_ = bool();
                    phi_401_ = true;
                }
                let _e294 = phi_400_;
                let _e296 = phi_401_;
                if _e296 {
                    phi_405_ = false;
                } else {
                    phi_405_ = _e294;
                }
                let _e298 = phi_405_;
                phi_406_ = _e298;
            }
            let _e300 = phi_406_;
            if _e300 {
                phi_783_ = lt_mask_Reprojection(_e270.pixel, _e270.is_valid, false);
                phi_784_ = lt_mask_Reprojection();
                phi_785_ = true;
            } else {
                let _e302 = samples.member[_e66.first_primitive].position;
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
                let _e487 = ((f32(_e49.x) + ((f32((_e49.y & (_e463 - 1u))) + 0.5f) / f32(_e463))) + _e451);
                if (_e487 > -8388608f) {
                    let _e499 = f32(select(0i, select(select(i32(_e487), i32(-2147483648), (_e487 < bitcast<f32>(3472883712u))), 2147483647i, (_e487 > bitcast<f32>(1325400063u))), (_e487 == _e487)));
                    if (_e499 > _e487) {
                        phi_614_ = 1f;
                    } else {
                        phi_614_ = 0f;
                    }
                    let _e502 = phi_614_;
                    if (_e487 < 8388608f) {
                        phi_619_ = (_e499 - _e502);
                        phi_620_ = false;
                    } else {
                        phi_619_ = f32();
                        phi_620_ = true;
                    }
                    let _e505 = phi_619_;
                    let _e507 = phi_620_;
                    phi_621_ = _e505;
                    phi_622_ = _e507;
                } else {
                    phi_621_ = f32();
                    phi_622_ = true;
                }
                let _e509 = phi_621_;
                let _e511 = phi_622_;
                if _e511 {
                    phi_626_ = _e487;
                } else {
                    phi_626_ = _e509;
                }
                let _e513 = phi_626_;
                let _e514 = ((f32(_e49.y) + ((f32((_e49.x & (_e461 - 1u))) + 0.5f) / f32(_e461))) + _e457);
                if (_e514 > -8388608f) {
                    let _e526 = f32(select(0i, select(select(i32(_e514), i32(-2147483648), (_e514 < bitcast<f32>(3472883712u))), 2147483647i, (_e514 > bitcast<f32>(1325400063u))), (_e514 == _e514)));
                    if (_e526 > _e514) {
                        phi_647_ = 1f;
                    } else {
                        phi_647_ = 0f;
                    }
                    let _e529 = phi_647_;
                    if (_e514 < 8388608f) {
                        phi_652_ = (_e526 - _e529);
                        phi_653_ = false;
                    } else {
                        phi_652_ = f32();
                        phi_653_ = true;
                    }
                    let _e532 = phi_652_;
                    let _e534 = phi_653_;
                    phi_654_ = _e532;
                    phi_655_ = _e534;
                } else {
                    phi_654_ = f32();
                    phi_655_ = true;
                }
                let _e536 = phi_654_;
                let _e538 = phi_655_;
                if _e538 {
                    phi_659_ = _e514;
                } else {
                    phi_659_ = _e536;
                }
                let _e540 = phi_659_;
                if (_e513 >= 0f) {
                    if (_e540 >= 0f) {
                        if (_e513 < f32(_e483)) {
                            let _e546 = (_e540 < f32(_e485));
                            if (_e451 == 0f) {
                                phi_680_ = (_e457 == 0f);
                            } else {
                                phi_680_ = false;
                            }
                            let _e550 = phi_680_;
                            if _e546 {
                                phi_699_ = vec2<u32>(select(select(u32(_e513), 0u, (_e513 < bitcast<f32>(0u))), 4294967295u, (_e513 > bitcast<f32>(1333788671u))), select(select(u32(_e540), 0u, (_e540 < bitcast<f32>(0u))), 4294967295u, (_e540 > bitcast<f32>(1333788671u))));
                                phi_700_ = false;
                            } else {
                                phi_699_ = vec2<u32>();
                                phi_700_ = true;
                            }
                            let _e567 = phi_699_;
                            let _e569 = phi_700_;
                            phi_701_ = _e550;
                            phi_702_ = _e546;
                            phi_703_ = _e567;
                            phi_704_ = _e550;
                            phi_705_ = _e546;
                            phi_706_ = false;
                            phi_707_ = _e569;
                        } else {
                            phi_701_ = bool();
                            phi_702_ = bool();
                            phi_703_ = vec2<u32>();
                            phi_704_ = bool();
                            phi_705_ = bool();
                            phi_706_ = true;
                            phi_707_ = false;
                        }
                        let _e571 = phi_701_;
                        let _e573 = phi_702_;
                        let _e575 = phi_703_;
                        let _e577 = phi_704_;
                        let _e579 = phi_705_;
                        let _e581 = phi_706_;
                        let _e583 = phi_707_;
                        phi_708_ = _e571;
                        phi_709_ = _e573;
                        phi_710_ = _e575;
                        phi_711_ = _e577;
                        phi_712_ = _e579;
                        phi_713_ = _e581;
                        phi_714_ = _e583;
                    } else {
                        phi_708_ = bool();
                        phi_709_ = bool();
                        phi_710_ = vec2<u32>();
                        phi_711_ = bool();
                        phi_712_ = bool();
                        phi_713_ = true;
                        phi_714_ = false;
                    }
                    let _e585 = phi_708_;
                    let _e587 = phi_709_;
                    let _e589 = phi_710_;
                    let _e591 = phi_711_;
                    let _e593 = phi_712_;
                    let _e595 = phi_713_;
                    let _e597 = phi_714_;
                    phi_715_ = _e585;
                    phi_716_ = _e587;
                    phi_717_ = _e589;
                    phi_718_ = _e591;
                    phi_719_ = _e593;
                    phi_720_ = _e595;
                    phi_721_ = _e597;
                } else {
                    phi_715_ = bool();
                    phi_716_ = bool();
                    phi_717_ = vec2<u32>();
                    phi_718_ = bool();
                    phi_719_ = bool();
                    phi_720_ = true;
                    phi_721_ = false;
                }
                let _e599 = phi_715_;
                let _e601 = phi_716_;
                let _e603 = phi_717_;
                let _e605 = phi_718_;
                let _e607 = phi_719_;
                let _e609 = phi_720_;
                let _e611 = phi_721_;
                if _e609 {
                    if (_e451 == 0f) {
                        phi_730_ = (_e457 == 0f);
                    } else {
                        phi_730_ = false;
                    }
                    let _e615 = phi_730_;
                    phi_731_ = _e615;
                    phi_732_ = false;
                    phi_733_ = true;
                } else {
                    phi_731_ = _e605;
                    phi_732_ = _e607;
                    phi_733_ = _e611;
                }
                let _e617 = phi_731_;
                let _e619 = phi_732_;
                let _e621 = phi_733_;
                if _e621 {
                    phi_737_ = _e617;
                    phi_738_ = _e619;
                    phi_739_ = vec2<u32>(_e49.x, _e49.y);
                } else {
                    phi_737_ = _e599;
                    phi_738_ = _e601;
                    phi_739_ = _e603;
                }
                let _e623 = phi_737_;
                let _e625 = phi_738_;
                let _e627 = phi_739_;
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
                        phi_774_ = false;
                    } else {
                        phi_774_ = true;
                    }
                    let _e678 = phi_774_;
                    phi_776_ = _e676;
                    phi_777_ = _e676;
                    phi_778_ = _e678;
                } else {
                    phi_776_ = lt_mask_Reprojection();
                    phi_777_ = lt_mask_Reprojection(_e652.pixel, false, _e652.has_moved);
                    phi_778_ = true;
                }
                let _e684 = phi_776_;
                let _e686 = phi_777_;
                let _e688 = phi_778_;
                if _e688 {
                    phi_782_ = false;
                } else {
                    phi_782_ = true;
                }
                let _e690 = phi_782_;
                phi_783_ = _e684;
                phi_784_ = _e686;
                phi_785_ = _e690;
            }
            let _e692 = phi_783_;
            let _e694 = phi_784_;
            let _e696 = phi_785_;
            if _e696 {
                let _e698 = p.member.flags;
                phi_793_ = ((_e698 & 1u) != 0u);
                phi_794_ = _e692;
            } else {
                phi_793_ = false;
                phi_794_ = _e694;
            }
            let _e702 = phi_793_;
            let _e704 = phi_794_;
            let _e708 = lt_mask_Reprojection(_e704.pixel, _e702, _e704.has_moved);
            let _e709 = lt_mask_Neighbourhood(false, true);
            if _e252 {
                phi_800_ = false;
            } else {
                phi_800_ = true;
            }
            let _e711 = phi_800_;
            if _e711 {
                if _e702 {
                    if ((0u & 2u) != 0u) {
                        phi_840_ = _e709;
                    } else {
                        let _e728 = ((((_e708.pixel.y * _e82) + (_e708.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e248) | (select(0u, 1u, _e708.has_moved) << bitcast<u32>(1i))));
                        if (_e728 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e732 = heard.member[(0u + _e728)];
                        let _e738 = (((_e732 >> bitcast<u32>(((_e708.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_840_ = lt_mask_Neighbourhood(_e738, !(_e738));
                    }
                    let _e742 = phi_840_;
                    phi_841_ = _e742;
                } else {
                    phi_841_ = _e709;
                }
                let _e744 = phi_841_;
                phi_842_ = _e744;
            } else {
                phi_842_ = _e709;
            }
            let _e746 = phi_842_;
            let _e749 = p.member.frame;
            let _e751 = p.member.refresh;
            if (_e751 == 0u) {
                phi_875_ = false;
            } else {
                if (_e751 == 0u) {
                    return;
                }
                let _e760 = ((_e49.x + (_e49.y * (((_e751 * 5u) / 8u) | 1u))) + (_e749 % _e751));
                if (_e751 == 0u) {
                    phi_874_ = (_e760 == 0u);
                } else {
                    if (_e751 == 0u) {
                        return;
                    }
                    phi_874_ = ((_e760 % _e751) == 0u);
                }
                let _e767 = phi_874_;
                phi_875_ = _e767;
            }
            let _e769 = phi_875_;
            if _e702 {
                if _e769 {
                    phi_897_ = bool();
                } else {
                    phi_897_ = ((0u & 2u) != 0u);
                }
                let _e775 = phi_897_;
                phi_898_ = _e775;
                phi_899_ = _e769;
            } else {
                phi_898_ = bool();
                phi_899_ = true;
            }
            let _e777 = phi_898_;
            let _e779 = phi_899_;
            if _e779 {
                phi_903_ = false;
            } else {
                phi_903_ = _e777;
            }
            let _e781 = phi_903_;
            if _e781 {
                phi_954_ = 7u;
            } else {
                if (_e90 != 0.5f) {
                    if _e702 {
                        if _e769 {
                            phi_951_ = 6u;
                        } else {
                            if _e252 {
                                phi_926_ = true;
                            } else {
                                if _e746.any_expands {
                                    phi_925_ = false;
                                } else {
                                    phi_925_ = true;
                                }
                                let _e783 = phi_925_;
                                phi_926_ = _e783;
                            }
                            let _e785 = phi_926_;
                            if _e785 {
                                if _e252 {
                                    if false {
                                        if _e746.all_remove {
                                            phi_939_ = false;
                                        } else {
                                            phi_939_ = true;
                                        }
                                        let _e787 = phi_939_;
                                        phi_940_ = _e787;
                                    } else {
                                        phi_940_ = true;
                                    }
                                    let _e789 = phi_940_;
                                    phi_941_ = _e789;
                                } else {
                                    phi_941_ = true;
                                }
                                let _e791 = phi_941_;
                                if _e791 {
                                    if _e252 {
                                        phi_948_ = 1u;
                                    } else {
                                        phi_948_ = 0u;
                                    }
                                    let _e793 = phi_948_;
                                    phi_949_ = _e793;
                                } else {
                                    phi_949_ = 5u;
                                }
                                let _e795 = phi_949_;
                                phi_950_ = _e795;
                            } else {
                                phi_950_ = 4u;
                            }
                            let _e797 = phi_950_;
                            phi_951_ = _e797;
                        }
                        let _e799 = phi_951_;
                        phi_952_ = _e799;
                    } else {
                        phi_952_ = 3u;
                    }
                    let _e801 = phi_952_;
                    phi_953_ = _e801;
                } else {
                    phi_953_ = 2u;
                }
                let _e803 = phi_953_;
                phi_954_ = _e803;
            }
            let _e805 = phi_954_;
            if !((_e805 == 0u)) {
                if !((_e805 == 5u)) {
                    phi_966_ = !(_e781);
                    phi_967_ = false;
                } else {
                    phi_966_ = bool();
                    phi_967_ = true;
                }
                let _e812 = phi_966_;
                let _e814 = phi_967_;
                phi_968_ = _e812;
                phi_969_ = _e814;
            } else {
                phi_968_ = bool();
                phi_969_ = true;
            }
            let _e816 = phi_968_;
            let _e818 = phi_969_;
            if _e818 {
                phi_973_ = false;
            } else {
                phi_973_ = _e816;
            }
            let _e820 = phi_973_;
            if _e781 {
                phi_979_ = ((0u & 4u) != 0u);
            } else {
                phi_979_ = _e248;
            }
            let _e824 = phi_979_;
            if _e820 {
                if _e248 {
                    phi_987_ = (2u | 1u);
                } else {
                    phi_987_ = 2u;
                }
                let _e827 = phi_987_;
                if false {
                    phi_992_ = (_e827 | 4u);
                } else {
                    phi_992_ = _e827;
                }
                let _e830 = phi_992_;
                phi_1012_ = _e830;
            } else {
                if (_e805 == 7u) {
                    if _e248 {
                        phi_1001_ = (2u | 1u);
                    } else {
                        phi_1001_ = 2u;
                    }
                    let _e834 = phi_1001_;
                    if _e824 {
                        phi_1006_ = (_e834 | 4u);
                    } else {
                        phi_1006_ = _e834;
                    }
                    let _e837 = phi_1006_;
                    phi_1011_ = _e837;
                } else {
                    if _e248 {
                        phi_1010_ = 1u;
                    } else {
                        phi_1010_ = 0u;
                    }
                    let _e839 = phi_1010_;
                    phi_1011_ = _e839;
                }
                let _e841 = phi_1011_;
                phi_1012_ = _e841;
            }
            let _e843 = phi_1012_;
            if _e824 {
                phi_1016_ = 0f;
            } else {
                phi_1016_ = 1f;
            }
            let _e845 = phi_1016_;
            phi_1018_ = mask_Masked(_e845, _e843, _e820);
        }
        let _e848 = phi_1018_;
        visibility.member[_e66.first_primitive] = _e848.visibility;
        let _e853 = p.member.light.number;
        let _e854 = (_e853 * 3u);
        let _e856 = (_e854 % 32u);
        let _e858 = p.member.light.mask_words;
        let _e860 = ((_e66.first_primitive * _e858) + (_e854 / 32u));
        let _e862 = bits.member[_e860];
        bits.member[_e860] = ((_e862 & ~((7u << bitcast<u32>((_e856 & 31u))))) | (_e848.bits << bitcast<u32>((_e856 & 31u))));
        if (_e856 > 29u) {
            let _e877 = bits.member[(_e860 + 1u)];
            let _e879 = (32u - _e856);
            bits.member[(_e860 + 1u)] = ((_e877 & ~((7u >> bitcast<u32>((_e879 & 31u))))) | (_e848.bits >> bitcast<u32>((_e879 & 31u))));
        }
        phi_1068_ = _e848.needs_ray;
        phi_1069_ = _e66.first_primitive;
    } else {
        phi_1068_ = false;
        phi_1069_ = 0u;
    }
    let _e893 = phi_1068_;
    let _e895 = phi_1069_;
    if (_e50 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e893 {
        let _e899 = atomicAdd((&shared_[0u]), 1u);
        phi_1080_ = _e899;
    } else {
        phi_1080_ = 0u;
    }
    let _e901 = phi_1080_;
    workgroupBarrier();
    if (_e50 == 0u) {
        let _e905 = atomicLoad((&shared_[0u]));
        let _e906 = atomicAdd((&list.member[3u]), _e905);
        atomicStore((&shared_[1u]), _e906);
    }
    workgroupBarrier();
    if _e893 {
        let _e909 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e909) + _e901)]), _e895);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
