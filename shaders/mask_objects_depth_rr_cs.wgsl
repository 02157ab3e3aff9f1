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
var<storage> last_depths: type_27;
@group(0) @binding(7) 
var<storage, read_write> depths: type_27;
@group(0) @binding(8) 
var<storage> past: type_43;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_176_: lt_bvh_traverse_Tree;
    var phi_177_: bool;
    var phi_178_: lt_bvh_traverse_Tree;
    var phi_179_: bool;
    var phi_184_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_176_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_177_ = false;
        } else {
            phi_176_ = lt_bvh_traverse_Tree();
            phi_177_ = true;
        }
        let _e69 = phi_176_;
        let _e71 = phi_177_;
        phi_178_ = _e69;
        phi_179_ = _e71;
    } else {
        phi_178_ = lt_bvh_traverse_Tree();
        phi_179_ = true;
    }
    let _e73 = phi_178_;
    let _e75 = phi_179_;
    if _e75 {
        phi_184_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_184_ = _e73;
    }
    let _e80 = phi_184_;
    return lt_bvh_traverse_Tree(_e80.root, _e80.first_primitive);
}

fn function_() {
    var phi_257_: bool;
    var phi_258_: bool;
    var phi_259_: bool;
    var phi_260_: bool;
    var phi_264_: bool;
    var phi_334_: bool;
    var phi_335_: bool;
    var phi_346_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_347_: bool;
    var phi_348_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_349_: bool;
    var phi_356_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_360_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_373_: bool;
    var phi_401_: bool;
    var phi_402_: bool;
    var phi_403_: bool;
    var phi_404_: bool;
    var phi_408_: bool;
    var phi_409_: bool;
    var phi_545_: f32;
    var phi_550_: f32;
    var phi_551_: bool;
    var phi_552_: f32;
    var phi_553_: bool;
    var phi_557_: f32;
    var phi_578_: f32;
    var phi_583_: f32;
    var phi_584_: bool;
    var phi_585_: f32;
    var phi_586_: bool;
    var phi_590_: f32;
    var phi_611_: bool;
    var phi_630_: vec2<u32>;
    var phi_631_: bool;
    var phi_632_: bool;
    var phi_633_: bool;
    var phi_634_: vec2<u32>;
    var phi_635_: bool;
    var phi_636_: bool;
    var phi_637_: bool;
    var phi_638_: bool;
    var phi_639_: bool;
    var phi_640_: bool;
    var phi_641_: vec2<u32>;
    var phi_642_: bool;
    var phi_643_: bool;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_648_: vec2<u32>;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_668_: bool;
    var phi_669_: bool;
    var phi_670_: vec2<u32>;
    var phi_705_: bool;
    var phi_707_: lt_mask_Reprojection;
    var phi_708_: lt_mask_Reprojection;
    var phi_709_: lt_mask_Reprojection;
    var phi_710_: bool;
    var phi_711_: bool;
    var phi_712_: lt_mask_Reprojection;
    var phi_713_: lt_mask_Reprojection;
    var phi_714_: lt_mask_Reprojection;
    var phi_715_: bool;
    var phi_716_: bool;
    var phi_768_: bool;
    var phi_772_: f32;
    var phi_776_: lt_mask_Reprojection;
    var phi_777_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_791_: bool;
    var phi_792_: lt_mask_Reprojection;
    var phi_793_: bool;
    var phi_797_: bool;
    var phi_798_: lt_mask_Reprojection;
    var phi_836_: u32;
    var phi_885_: u32;
    var phi_890_: u32;
    var phi_891_: u32;
    var phi_892_: u32;
    var phi_893_: bool;
    var phi_894_: u32;
    var phi_895_: bool;
    var phi_896_: bool;
    var phi_897_: u32;
    var phi_898_: bool;
    var phi_899_: bool;
    var phi_903_: bool;
    var phi_907_: u32;
    var phi_912_: bool;
    var phi_944_: u32;
    var phi_973_: lt_mask_Neighbourhood;
    var phi_974_: lt_mask_Neighbourhood;
    var phi_975_: lt_mask_Neighbourhood;
    var phi_1007_: bool;
    var phi_1008_: bool;
    var phi_1030_: bool;
    var phi_1031_: bool;
    var phi_1032_: bool;
    var phi_1036_: bool;
    var phi_1058_: bool;
    var phi_1059_: bool;
    var phi_1072_: bool;
    var phi_1073_: bool;
    var phi_1074_: bool;
    var phi_1081_: u32;
    var phi_1082_: u32;
    var phi_1083_: u32;
    var phi_1084_: u32;
    var phi_1085_: u32;
    var phi_1086_: u32;
    var phi_1087_: u32;
    var phi_1099_: bool;
    var phi_1100_: bool;
    var phi_1101_: bool;
    var phi_1102_: bool;
    var phi_1106_: bool;
    var phi_1112_: bool;
    var phi_1120_: u32;
    var phi_1125_: u32;
    var phi_1134_: u32;
    var phi_1139_: u32;
    var phi_1143_: u32;
    var phi_1144_: u32;
    var phi_1145_: u32;
    var phi_1149_: f32;
    var phi_1158_: bool;
    var phi_1159_: bool;
    var phi_1161_: mask_Masked;
    var phi_1233_: bool;
    var phi_1234_: bool;
    var phi_1235_: bool;
    var phi_1236_: bool;
    var phi_1240_: bool;
    var phi_1268_: f32;
    var phi_1273_: doubt_Listed;
    var phi_1274_: bool;
    var phi_1287_: u32;
    var phi_1304_: u32;

    let _e56 = id_1;
    let _e57 = local_1;
    let _e62 = arrayLength((&heard.member));
    let _e75 = p.member.current.size[0u];
    let _e77 = p.member.current.size[1u];
    let _e78 = lt_shaders_entry_pixel_index(_e56, _e75, _e77);
    if (bitcast<i32>(_e78.root) != 0i) {
        let _e86 = p.member.current.size[0u];
        let _e89 = past.member[_e78.first_primitive];
        let _e94 = visibility.member[_e78.first_primitive];
        let _e100 = samples.member[_e78.first_primitive].normal[0u];
        let _e102 = global[0u];
        if (_e100 == _e102) {
            let _e105 = samples.member[_e78.first_primitive].normal[1u];
            let _e107 = global[1u];
            if (_e105 == _e107) {
                let _e110 = samples.member[_e78.first_primitive].normal[2u];
                let _e112 = global[2u];
                phi_257_ = (_e110 == _e112);
                phi_258_ = false;
            } else {
                phi_257_ = bool();
                phi_258_ = true;
            }
            let _e115 = phi_257_;
            let _e117 = phi_258_;
            phi_259_ = _e115;
            phi_260_ = _e117;
        } else {
            phi_259_ = bool();
            phi_260_ = true;
        }
        let _e119 = phi_259_;
        let _e121 = phi_260_;
        if _e121 {
            phi_264_ = false;
        } else {
            phi_264_ = _e119;
        }
        let _e123 = phi_264_;
        if !(_e123) {
            let _e126 = samples.member[_e78.first_primitive].position;
            let _e128 = p.member.light.place;
            let _e134 = p.member.light.place[3u];
            let _e141 = (_e128.x - (_e126.x * _e134));
            let _e142 = (_e128.y - (_e126.y * _e134));
            let _e143 = (_e128.z - (_e126.z * _e134));
            let _e145 = samples.member[_e78.first_primitive].normal;
            if ((((_e145.x * _e141) + (_e145.y * _e142)) + (_e145.z * _e143)) > 0f) {
                let _e159 = (((_e141 * _e141) + (_e142 * _e142)) + (_e143 * _e143));
                let _e161 = p.member.light.axis;
                let _e173 = p.member.light.place[3u];
                if (_e173 == 0f) {
                    phi_335_ = true;
                } else {
                    let _e176 = p.member.light.range_squared;
                    if (_e159 <= _e176) {
                        let _e179 = p.member.light.cos_outer;
                        phi_334_ = (-((((_e141 * _e161.x) + (_e142 * _e161.y)) + (_e143 * _e161.z))) >= (_e179 * sqrt(_e159)));
                    } else {
                        phi_334_ = false;
                    }
                    let _e184 = phi_334_;
                    phi_335_ = _e184;
                }
                let _e186 = phi_335_;
                if _e186 {
                    let _e188 = samples.member[_e78.first_primitive].flags;
                    let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                    phi_346_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, ((_e188 & 1u) == 0u));
                    phi_347_ = false;
                } else {
                    phi_346_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_347_ = true;
                }
                let _e207 = phi_346_;
                let _e209 = phi_347_;
                phi_348_ = _e207;
                phi_349_ = _e209;
            } else {
                phi_348_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_349_ = true;
            }
            let _e211 = phi_348_;
            let _e213 = phi_349_;
            if _e213 {
                let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e225 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e219.unnamed.visibility, false), _e219.unnamed_1);
                phi_356_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e225.unnamed, true);
            } else {
                phi_356_ = _e211;
            }
            let _e230 = phi_356_;
            phi_360_ = _e230;
        } else {
            let _e236 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e242 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e236.unnamed.visibility, false), _e236.unnamed_1);
            phi_360_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e242.unnamed, true);
        }
        let _e247 = phi_360_;
        if _e247.unnamed_1 {
            phi_1161_ = mask_Masked(_e247.unnamed.visibility, 0u, false, false);
        } else {
            let _e252 = (_e94 < 0.5f);
            if (_e94 > 0f) {
                phi_373_ = (_e94 < 1f);
            } else {
                phi_373_ = false;
            }
            let _e256 = phi_373_;
            let _e263 = lt_mask_Reprojection(vec2<u32>(_e56.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e270 = lt_mask_Reprojection(vec2<u32>(_e263.pixel.x, _e56.y), _e263.is_valid, _e263.has_moved);
            let _e274 = lt_mask_Reprojection(_e270.pixel, true, _e270.has_moved);
            let _e280 = p.member.flags;
            if ((_e280 & 16u) == 0u) {
                phi_409_ = false;
            } else {
                let _e285 = samples.member[_e78.first_primitive].position[0u];
                if (_e89.x == _e285) {
                    let _e288 = samples.member[_e78.first_primitive].position[1u];
                    if (_e89.y == _e288) {
                        let _e291 = samples.member[_e78.first_primitive].position[2u];
                        phi_401_ = (_e89.z == _e291);
                        phi_402_ = false;
                    } else {
                        phi_401_ = bool();
                        phi_402_ = true;
                    }
                    let _e294 = phi_401_;
                    let _e296 = phi_402_;
                    phi_403_ = _e294;
                    phi_404_ = _e296;
                } else {
                    phi_403_ = bool();
                    phi_404_ = true;
                }
                let _e298 = phi_403_;
                let _e300 = phi_404_;
                if _e300 {
                    phi_408_ = false;
                } else {
                    phi_408_ = _e298;
                }
                let _e302 = phi_408_;
                phi_409_ = _e302;
            }
            let _e304 = phi_409_;
            if _e304 {
                phi_712_ = lt_mask_Reprojection(_e274.pixel, _e274.is_valid, false);
                phi_713_ = lt_mask_Reprojection();
                phi_714_ = lt_mask_Reprojection();
                phi_715_ = true;
                phi_716_ = false;
            } else {
                let _e308 = p.member.current.grid[0u];
                let _e310 = p.member.current.grid[1u];
                let _e324 = (f32(_e56.x) + ((f32((_e56.y & (_e310 - 1u))) + 0.5f) / f32(_e310)));
                let _e326 = (f32(_e56.y) + ((f32((_e56.x & (_e308 - 1u))) + 0.5f) / f32(_e308)));
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
                        phi_545_ = 1f;
                    } else {
                        phi_545_ = 0f;
                    }
                    let _e434 = phi_545_;
                    if (_e419 < 8388608f) {
                        phi_550_ = (_e431 - _e434);
                        phi_551_ = false;
                    } else {
                        phi_550_ = f32();
                        phi_551_ = true;
                    }
                    let _e437 = phi_550_;
                    let _e439 = phi_551_;
                    phi_552_ = _e437;
                    phi_553_ = _e439;
                } else {
                    phi_552_ = f32();
                    phi_553_ = true;
                }
                let _e441 = phi_552_;
                let _e443 = phi_553_;
                if _e443 {
                    phi_557_ = _e419;
                } else {
                    phi_557_ = _e441;
                }
                let _e445 = phi_557_;
                let _e446 = (_e326 + _e411);
                if (_e446 > -8388608f) {
                    let _e458 = f32(select(0i, select(select(i32(_e446), i32(-2147483648), (_e446 < bitcast<f32>(3472883712u))), 2147483647i, (_e446 > bitcast<f32>(1325400063u))), (_e446 == _e446)));
                    if (_e458 > _e446) {
                        phi_578_ = 1f;
                    } else {
                        phi_578_ = 0f;
                    }
                    let _e461 = phi_578_;
                    if (_e446 < 8388608f) {
                        phi_583_ = (_e458 - _e461);
                        phi_584_ = false;
                    } else {
                        phi_583_ = f32();
                        phi_584_ = true;
                    }
                    let _e464 = phi_583_;
                    let _e466 = phi_584_;
                    phi_585_ = _e464;
                    phi_586_ = _e466;
                } else {
                    phi_585_ = f32();
                    phi_586_ = true;
                }
                let _e468 = phi_585_;
                let _e470 = phi_586_;
                if _e470 {
                    phi_590_ = _e446;
                } else {
                    phi_590_ = _e468;
                }
                let _e472 = phi_590_;
                if (_e445 >= 0f) {
                    if (_e472 >= 0f) {
                        if (_e445 < f32(_e415)) {
                            let _e478 = (_e472 < f32(_e417));
                            if (_e410 == 0f) {
                                phi_611_ = (_e411 == 0f);
                            } else {
                                phi_611_ = false;
                            }
                            let _e482 = phi_611_;
                            if _e478 {
                                phi_630_ = vec2<u32>(select(select(u32(_e445), 0u, (_e445 < bitcast<f32>(0u))), 4294967295u, (_e445 > bitcast<f32>(1333788671u))), select(select(u32(_e472), 0u, (_e472 < bitcast<f32>(0u))), 4294967295u, (_e472 > bitcast<f32>(1333788671u))));
                                phi_631_ = false;
                            } else {
                                phi_630_ = vec2<u32>();
                                phi_631_ = true;
                            }
                            let _e499 = phi_630_;
                            let _e501 = phi_631_;
                            phi_632_ = _e482;
                            phi_633_ = _e478;
                            phi_634_ = _e499;
                            phi_635_ = _e482;
                            phi_636_ = _e478;
                            phi_637_ = false;
                            phi_638_ = _e501;
                        } else {
                            phi_632_ = bool();
                            phi_633_ = bool();
                            phi_634_ = vec2<u32>();
                            phi_635_ = bool();
                            phi_636_ = bool();
                            phi_637_ = true;
                            phi_638_ = false;
                        }
                        let _e503 = phi_632_;
                        let _e505 = phi_633_;
                        let _e507 = phi_634_;
                        let _e509 = phi_635_;
                        let _e511 = phi_636_;
                        let _e513 = phi_637_;
                        let _e515 = phi_638_;
                        phi_639_ = _e503;
                        phi_640_ = _e505;
                        phi_641_ = _e507;
                        phi_642_ = _e509;
                        phi_643_ = _e511;
                        phi_644_ = _e513;
                        phi_645_ = _e515;
                    } else {
                        phi_639_ = bool();
                        phi_640_ = bool();
                        phi_641_ = vec2<u32>();
                        phi_642_ = bool();
                        phi_643_ = bool();
                        phi_644_ = true;
                        phi_645_ = false;
                    }
                    let _e517 = phi_639_;
                    let _e519 = phi_640_;
                    let _e521 = phi_641_;
                    let _e523 = phi_642_;
                    let _e525 = phi_643_;
                    let _e527 = phi_644_;
                    let _e529 = phi_645_;
                    phi_646_ = _e517;
                    phi_647_ = _e519;
                    phi_648_ = _e521;
                    phi_649_ = _e523;
                    phi_650_ = _e525;
                    phi_651_ = _e527;
                    phi_652_ = _e529;
                } else {
                    phi_646_ = bool();
                    phi_647_ = bool();
                    phi_648_ = vec2<u32>();
                    phi_649_ = bool();
                    phi_650_ = bool();
                    phi_651_ = true;
                    phi_652_ = false;
                }
                let _e531 = phi_646_;
                let _e533 = phi_647_;
                let _e535 = phi_648_;
                let _e537 = phi_649_;
                let _e539 = phi_650_;
                let _e541 = phi_651_;
                let _e543 = phi_652_;
                if _e541 {
                    if (_e410 == 0f) {
                        phi_661_ = (_e411 == 0f);
                    } else {
                        phi_661_ = false;
                    }
                    let _e547 = phi_661_;
                    phi_662_ = _e547;
                    phi_663_ = false;
                    phi_664_ = true;
                } else {
                    phi_662_ = _e537;
                    phi_663_ = _e539;
                    phi_664_ = _e543;
                }
                let _e549 = phi_662_;
                let _e551 = phi_663_;
                let _e553 = phi_664_;
                if _e553 {
                    phi_668_ = _e549;
                    phi_669_ = _e551;
                    phi_670_ = vec2<u32>(_e56.x, _e56.y);
                } else {
                    phi_668_ = _e531;
                    phi_669_ = _e533;
                    phi_670_ = _e535;
                }
                let _e555 = phi_668_;
                let _e557 = phi_669_;
                let _e559 = phi_670_;
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
                        phi_705_ = false;
                    } else {
                        phi_705_ = true;
                    }
                    let _e610 = phi_705_;
                    phi_707_ = _e608;
                    phi_708_ = _e608;
                    phi_709_ = lt_mask_Reprojection();
                    phi_710_ = _e604;
                    phi_711_ = _e610;
                } else {
                    phi_707_ = lt_mask_Reprojection();
                    phi_708_ = lt_mask_Reprojection();
                    phi_709_ = lt_mask_Reprojection(_e584.pixel, false, _e584.has_moved);
                    phi_710_ = false;
                    phi_711_ = false;
                }
                let _e616 = phi_707_;
                let _e618 = phi_708_;
                let _e620 = phi_709_;
                let _e622 = phi_710_;
                let _e624 = phi_711_;
                phi_712_ = _e616;
                phi_713_ = _e618;
                phi_714_ = _e620;
                phi_715_ = _e622;
                phi_716_ = _e624;
            }
            let _e626 = phi_712_;
            let _e628 = phi_713_;
            let _e630 = phi_714_;
            let _e632 = phi_715_;
            let _e634 = phi_716_;
            if _e632 {
                let _e637 = p.member.previous.eye;
                let _e645 = p.member.previous.forward;
                let _e653 = ((((_e89.x - _e637.x) * _e645.x) + ((_e89.y - _e637.y) * _e645.y)) + ((_e89.z - _e637.z) * _e645.z));
                let _e659 = ((_e626.pixel.y * _e86) + _e626.pixel.x);
                if (_e659 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e663 = last_depths.member[(0u + _e659)];
                let _e665 = p.member.depth_tolerance;
                let _e668 = abs(_e653);
                let _e669 = abs(_e663);
                if ((bitcast<u32>(_e669) & 2147483647u) > 2139095040u) {
                    phi_768_ = true;
                } else {
                    let _e673 = (_e669 > _e668);
                    if _e673 {
                    }
                    phi_768_ = _e673;
                }
                let _e675 = phi_768_;
                if _e675 {
                    phi_772_ = _e669;
                } else {
                    phi_772_ = _e668;
                }
                let _e677 = phi_772_;
                phi_776_ = lt_mask_Reprojection(_e626.pixel, (abs((_e653 - _e663)) <= (_e665 * _e677)), _e626.has_moved);
                phi_777_ = true;
            } else {
                phi_776_ = _e628;
                phi_777_ = _e634;
            }
            let _e685 = phi_776_;
            let _e687 = phi_777_;
            if _e687 {
                if _e685.is_valid {
                    let _e690 = p.member.flags;
                    phi_789_ = ((_e690 & 1u) != 0u);
                    phi_790_ = false;
                } else {
                    phi_789_ = bool();
                    phi_790_ = true;
                }
                let _e694 = phi_789_;
                let _e696 = phi_790_;
                phi_791_ = _e694;
                phi_792_ = _e685;
                phi_793_ = _e696;
            } else {
                phi_791_ = bool();
                phi_792_ = _e630;
                phi_793_ = true;
            }
            let _e698 = phi_791_;
            let _e700 = phi_792_;
            let _e702 = phi_793_;
            if _e702 {
                phi_797_ = false;
                phi_798_ = _e700;
            } else {
                phi_797_ = _e698;
                phi_798_ = _e685;
            }
            let _e704 = phi_797_;
            let _e706 = phi_798_;
            let _e710 = lt_mask_Reprojection(_e706.pixel, _e704, _e706.has_moved);
            let _e712 = p.member.flags;
            let _e714 = ((_e712 & 2u) != 0u);
            let _e716 = p.member.flags;
            if ((_e716 & 4u) == 0u) {
                phi_897_ = u32();
                phi_898_ = true;
                phi_899_ = false;
            } else {
                if _e704 {
                    if !(_e710.has_moved) {
                        if (32u == 0u) {
                            return;
                        }
                        let _e722 = (_e86 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e86 % 32u) > 0u) {
                            phi_836_ = (_e722 + 1u);
                        } else {
                            phi_836_ = _e722;
                        }
                        let _e728 = phi_836_;
                        let _e733 = ((((_e56.y * _e728) + (_e56.x / 32u)) * 6u) + 4u);
                        if (_e733 < _e62) {
                        } else {
                            return;
                        }
                        let _e737 = heard.member[(0u + _e733)];
                        if (((_e737 >> bitcast<u32>(((_e56.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e748 = ((((_e56.y * _e728) + (_e56.x / 32u)) * 6u) + 5u);
                            if (_e748 < _e62) {
                            } else {
                                return;
                            }
                            let _e752 = heard.member[(0u + _e748)];
                            if false {
                                phi_885_ = (2u | 1u);
                            } else {
                                phi_885_ = 2u;
                            }
                            let _e761 = phi_885_;
                            if (((_e752 >> bitcast<u32>(((_e56.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_890_ = (_e761 | 4u);
                            } else {
                                phi_890_ = _e761;
                            }
                            let _e764 = phi_890_;
                            phi_891_ = _e764;
                        } else {
                            phi_891_ = 0u;
                        }
                        let _e766 = phi_891_;
                        phi_892_ = _e766;
                        phi_893_ = false;
                    } else {
                        phi_892_ = u32();
                        phi_893_ = true;
                    }
                    let _e768 = phi_892_;
                    let _e770 = phi_893_;
                    phi_894_ = _e768;
                    phi_895_ = false;
                    phi_896_ = _e770;
                } else {
                    phi_894_ = u32();
                    phi_895_ = true;
                    phi_896_ = false;
                }
                let _e772 = phi_894_;
                let _e774 = phi_895_;
                let _e776 = phi_896_;
                phi_897_ = _e772;
                phi_898_ = _e774;
                phi_899_ = _e776;
            }
            let _e778 = phi_897_;
            let _e780 = phi_898_;
            let _e782 = phi_899_;
            if _e780 {
                phi_903_ = true;
            } else {
                phi_903_ = _e782;
            }
            let _e784 = phi_903_;
            if _e784 {
                phi_907_ = 0u;
            } else {
                phi_907_ = _e778;
            }
            let _e786 = phi_907_;
            let _e787 = lt_mask_Neighbourhood(false, true);
            if _e256 {
                phi_912_ = _e714;
            } else {
                phi_912_ = false;
            }
            let _e789 = phi_912_;
            if _e789 {
                if _e704 {
                    if ((_e786 & 2u) != 0u) {
                        phi_973_ = _e787;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e798 = (_e86 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e86 % 32u) > 0u) {
                            phi_944_ = (_e798 + 1u);
                        } else {
                            phi_944_ = _e798;
                        }
                        let _e804 = phi_944_;
                        let _e814 = ((((_e710.pixel.y * _e804) + (_e710.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e252) | (select(0u, 1u, _e710.has_moved) << bitcast<u32>(1i))));
                        if (_e814 < _e62) {
                        } else {
                            return;
                        }
                        let _e818 = heard.member[(0u + _e814)];
                        let _e824 = (((_e818 >> bitcast<u32>(((_e710.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_973_ = lt_mask_Neighbourhood(_e824, !(_e824));
                    }
                    let _e828 = phi_973_;
                    phi_974_ = _e828;
                } else {
                    phi_974_ = _e787;
                }
                let _e830 = phi_974_;
                phi_975_ = _e830;
            } else {
                phi_975_ = _e787;
            }
            let _e832 = phi_975_;
            let _e835 = p.member.frame;
            let _e837 = p.member.refresh;
            if (_e837 == 0u) {
                phi_1008_ = false;
            } else {
                if (_e837 == 0u) {
                    return;
                }
                let _e846 = ((_e56.x + (_e56.y * (((_e837 * 5u) / 8u) | 1u))) + (_e835 % _e837));
                if (_e837 == 0u) {
                    phi_1007_ = (_e846 == 0u);
                } else {
                    if (_e837 == 0u) {
                        return;
                    }
                    phi_1007_ = ((_e846 % _e837) == 0u);
                }
                let _e853 = phi_1007_;
                phi_1008_ = _e853;
            }
            let _e855 = phi_1008_;
            if _e704 {
                if _e855 {
                    phi_1030_ = bool();
                } else {
                    phi_1030_ = ((_e786 & 2u) != 0u);
                }
                let _e861 = phi_1030_;
                phi_1031_ = _e861;
                phi_1032_ = _e855;
            } else {
                phi_1031_ = bool();
                phi_1032_ = true;
            }
            let _e863 = phi_1031_;
            let _e865 = phi_1032_;
            if _e865 {
                phi_1036_ = false;
            } else {
                phi_1036_ = _e863;
            }
            let _e867 = phi_1036_;
            if _e867 {
                phi_1087_ = 7u;
            } else {
                if (_e94 != 0.5f) {
                    if _e704 {
                        if _e855 {
                            phi_1084_ = 6u;
                        } else {
                            if _e256 {
                                phi_1059_ = true;
                            } else {
                                if _e832.any_expands {
                                    phi_1058_ = false;
                                } else {
                                    phi_1058_ = true;
                                }
                                let _e869 = phi_1058_;
                                phi_1059_ = _e869;
                            }
                            let _e871 = phi_1059_;
                            if _e871 {
                                if _e256 {
                                    if _e714 {
                                        if _e832.all_remove {
                                            phi_1072_ = false;
                                        } else {
                                            phi_1072_ = true;
                                        }
                                        let _e873 = phi_1072_;
                                        phi_1073_ = _e873;
                                    } else {
                                        phi_1073_ = true;
                                    }
                                    let _e875 = phi_1073_;
                                    phi_1074_ = _e875;
                                } else {
                                    phi_1074_ = true;
                                }
                                let _e877 = phi_1074_;
                                if _e877 {
                                    if _e256 {
                                        phi_1081_ = 1u;
                                    } else {
                                        phi_1081_ = 0u;
                                    }
                                    let _e879 = phi_1081_;
                                    phi_1082_ = _e879;
                                } else {
                                    phi_1082_ = 5u;
                                }
                                let _e881 = phi_1082_;
                                phi_1083_ = _e881;
                            } else {
                                phi_1083_ = 4u;
                            }
                            let _e883 = phi_1083_;
                            phi_1084_ = _e883;
                        }
                        let _e885 = phi_1084_;
                        phi_1085_ = _e885;
                    } else {
                        phi_1085_ = 3u;
                    }
                    let _e887 = phi_1085_;
                    phi_1086_ = _e887;
                } else {
                    phi_1086_ = 2u;
                }
                let _e889 = phi_1086_;
                phi_1087_ = _e889;
            }
            let _e891 = phi_1087_;
            if !((_e891 == 0u)) {
                if !((_e891 == 5u)) {
                    phi_1099_ = !(_e867);
                    phi_1100_ = false;
                } else {
                    phi_1099_ = bool();
                    phi_1100_ = true;
                }
                let _e898 = phi_1099_;
                let _e900 = phi_1100_;
                phi_1101_ = _e898;
                phi_1102_ = _e900;
            } else {
                phi_1101_ = bool();
                phi_1102_ = true;
            }
            let _e902 = phi_1101_;
            let _e904 = phi_1102_;
            if _e904 {
                phi_1106_ = false;
            } else {
                phi_1106_ = _e902;
            }
            let _e906 = phi_1106_;
            if _e867 {
                phi_1112_ = ((_e786 & 4u) != 0u);
            } else {
                phi_1112_ = _e252;
            }
            let _e910 = phi_1112_;
            if _e906 {
                if _e252 {
                    phi_1120_ = (2u | 1u);
                } else {
                    phi_1120_ = 2u;
                }
                let _e913 = phi_1120_;
                if false {
                    phi_1125_ = (_e913 | 4u);
                } else {
                    phi_1125_ = _e913;
                }
                let _e916 = phi_1125_;
                phi_1145_ = _e916;
            } else {
                if (_e891 == 7u) {
                    if _e252 {
                        phi_1134_ = (2u | 1u);
                    } else {
                        phi_1134_ = 2u;
                    }
                    let _e920 = phi_1134_;
                    if _e910 {
                        phi_1139_ = (_e920 | 4u);
                    } else {
                        phi_1139_ = _e920;
                    }
                    let _e923 = phi_1139_;
                    phi_1144_ = _e923;
                } else {
                    if _e252 {
                        phi_1143_ = 1u;
                    } else {
                        phi_1143_ = 0u;
                    }
                    let _e925 = phi_1143_;
                    phi_1144_ = _e925;
                }
                let _e927 = phi_1144_;
                phi_1145_ = _e927;
            }
            let _e929 = phi_1145_;
            if _e910 {
                phi_1149_ = 0f;
            } else {
                phi_1149_ = 1f;
            }
            let _e931 = phi_1149_;
            if _e256 {
                if (_e94 == 0.99999994f) {
                    phi_1158_ = true;
                } else {
                    phi_1158_ = (_e94 == 0.000000059604645f);
                }
                let _e935 = phi_1158_;
                phi_1159_ = _e935;
            } else {
                phi_1159_ = true;
            }
            let _e937 = phi_1159_;
            phi_1161_ = mask_Masked(_e931, _e929, _e906, _e937);
        }
        let _e940 = phi_1161_;
        visibility.member[_e78.first_primitive] = _e940.visibility;
        let _e945 = p.member.light.number;
        let _e946 = (_e945 * 3u);
        let _e948 = (_e946 % 32u);
        let _e950 = p.member.light.mask_words;
        let _e952 = ((_e78.first_primitive * _e950) + (_e946 / 32u));
        let _e954 = bits.member[_e952];
        bits.member[_e952] = ((_e954 & ~((7u << bitcast<u32>((_e948 & 31u))))) | (_e940.bits << bitcast<u32>((_e948 & 31u))));
        if (_e948 > 29u) {
            let _e969 = bits.member[(_e952 + 1u)];
            let _e971 = (32u - _e948);
            bits.member[(_e952 + 1u)] = ((_e969 & ~((7u >> bitcast<u32>((_e971 & 31u))))) | (_e940.bits >> bitcast<u32>((_e971 & 31u))));
        }
        let _e986 = samples.member[_e78.first_primitive].normal[0u];
        let _e988 = global[0u];
        if (_e986 == _e988) {
            let _e991 = samples.member[_e78.first_primitive].normal[1u];
            let _e993 = global[1u];
            if (_e991 == _e993) {
                let _e996 = samples.member[_e78.first_primitive].normal[2u];
                let _e998 = global[2u];
                phi_1233_ = (_e996 == _e998);
                phi_1234_ = false;
            } else {
                phi_1233_ = bool();
                phi_1234_ = true;
            }
            let _e1001 = phi_1233_;
            let _e1003 = phi_1234_;
            phi_1235_ = _e1001;
            phi_1236_ = _e1003;
        } else {
            phi_1235_ = bool();
            phi_1236_ = true;
        }
        let _e1005 = phi_1235_;
        let _e1007 = phi_1236_;
        if _e1007 {
            phi_1240_ = false;
        } else {
            phi_1240_ = _e1005;
        }
        let _e1009 = phi_1240_;
        if !(_e1009) {
            let _e1012 = samples.member[_e78.first_primitive].position;
            let _e1014 = p.member.current.eye;
            let _e1025 = p.member.current.forward;
            phi_1268_ = ((((_e1012.x - _e1014.x) * _e1025.x) + ((_e1012.y - _e1014.y) * _e1025.y)) + ((_e1012.z - _e1014.z) * _e1025.z));
        } else {
            phi_1268_ = 0f;
        }
        let _e1035 = phi_1268_;
        depths.member[_e78.first_primitive] = _e1035;
        phi_1273_ = doubt_Listed(_e78.first_primitive, _e940.is_trusted);
        phi_1274_ = _e940.needs_ray;
    } else {
        phi_1273_ = doubt_Listed(0u, false);
        phi_1274_ = false;
    }
    let _e1041 = phi_1273_;
    let _e1043 = phi_1274_;
    if (_e57 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1043 {
        let _e1049 = atomicAdd((&shared_[0u]), 1u);
        phi_1287_ = _e1049;
    } else {
        phi_1287_ = 0u;
    }
    let _e1051 = phi_1287_;
    workgroupBarrier();
    if (_e57 == 0u) {
        let _e1055 = atomicLoad((&shared_[0u]));
        let _e1056 = atomicAdd((&list.member[3u]), _e1055);
        atomicStore((&shared_[1u]), _e1056);
    }
    workgroupBarrier();
    if _e1043 {
        if _e1041.is_trusted {
            phi_1304_ = (_e1041.pixel | 2147483648u);
        } else {
            phi_1304_ = _e1041.pixel;
        }
        let _e1060 = phi_1304_;
        let _e1062 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1062) + _e1051)]), _e1060);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
