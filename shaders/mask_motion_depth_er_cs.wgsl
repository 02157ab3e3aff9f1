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
    var phi_169_: lt_bvh_traverse_Tree;
    var phi_170_: bool;
    var phi_171_: lt_bvh_traverse_Tree;
    var phi_172_: bool;
    var phi_177_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_169_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_170_ = false;
        } else {
            phi_169_ = lt_bvh_traverse_Tree();
            phi_170_ = true;
        }
        let _e67 = phi_169_;
        let _e69 = phi_170_;
        phi_171_ = _e67;
        phi_172_ = _e69;
    } else {
        phi_171_ = lt_bvh_traverse_Tree();
        phi_172_ = true;
    }
    let _e71 = phi_171_;
    let _e73 = phi_172_;
    if _e73 {
        phi_177_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_177_ = _e71;
    }
    let _e78 = phi_177_;
    return lt_bvh_traverse_Tree(_e78.root, _e78.first_primitive);
}

fn function_() {
    var phi_246_: bool;
    var phi_247_: bool;
    var phi_248_: bool;
    var phi_249_: bool;
    var phi_253_: bool;
    var phi_323_: bool;
    var phi_324_: bool;
    var phi_335_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_336_: bool;
    var phi_337_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_338_: bool;
    var phi_345_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_349_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_362_: bool;
    var phi_393_: bool;
    var phi_394_: bool;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_400_: bool;
    var phi_401_: bool;
    var phi_540_: f32;
    var phi_545_: f32;
    var phi_546_: bool;
    var phi_547_: f32;
    var phi_548_: bool;
    var phi_552_: f32;
    var phi_573_: f32;
    var phi_578_: f32;
    var phi_579_: bool;
    var phi_580_: f32;
    var phi_581_: bool;
    var phi_585_: f32;
    var phi_606_: bool;
    var phi_625_: vec2<u32>;
    var phi_626_: bool;
    var phi_627_: bool;
    var phi_628_: bool;
    var phi_629_: vec2<u32>;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_632_: bool;
    var phi_633_: bool;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_636_: vec2<u32>;
    var phi_637_: bool;
    var phi_638_: bool;
    var phi_639_: bool;
    var phi_640_: bool;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_643_: vec2<u32>;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_665_: vec2<u32>;
    var phi_703_: bool;
    var phi_705_: lt_mask_Reprojection;
    var phi_706_: lt_mask_Reprojection;
    var phi_707_: lt_mask_Reprojection;
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_710_: lt_mask_Reprojection;
    var phi_711_: lt_mask_Reprojection;
    var phi_712_: lt_mask_Reprojection;
    var phi_713_: bool;
    var phi_714_: bool;
    var phi_769_: bool;
    var phi_773_: f32;
    var phi_777_: lt_mask_Reprojection;
    var phi_778_: bool;
    var phi_790_: bool;
    var phi_791_: bool;
    var phi_792_: bool;
    var phi_793_: lt_mask_Reprojection;
    var phi_794_: bool;
    var phi_798_: bool;
    var phi_799_: lt_mask_Reprojection;
    var phi_805_: bool;
    var phi_837_: u32;
    var phi_866_: lt_mask_Neighbourhood;
    var phi_867_: lt_mask_Neighbourhood;
    var phi_868_: lt_mask_Neighbourhood;
    var phi_900_: bool;
    var phi_901_: bool;
    var phi_923_: bool;
    var phi_924_: bool;
    var phi_925_: bool;
    var phi_929_: bool;
    var phi_951_: bool;
    var phi_952_: bool;
    var phi_965_: bool;
    var phi_966_: bool;
    var phi_967_: bool;
    var phi_974_: u32;
    var phi_975_: u32;
    var phi_976_: u32;
    var phi_977_: u32;
    var phi_978_: u32;
    var phi_979_: u32;
    var phi_980_: u32;
    var phi_992_: bool;
    var phi_993_: bool;
    var phi_994_: bool;
    var phi_995_: bool;
    var phi_999_: bool;
    var phi_1005_: bool;
    var phi_1013_: u32;
    var phi_1018_: u32;
    var phi_1027_: u32;
    var phi_1032_: u32;
    var phi_1036_: u32;
    var phi_1037_: u32;
    var phi_1038_: u32;
    var phi_1042_: f32;
    var phi_1051_: bool;
    var phi_1052_: bool;
    var phi_1054_: mask_Masked;
    var phi_1126_: bool;
    var phi_1127_: bool;
    var phi_1128_: bool;
    var phi_1129_: bool;
    var phi_1133_: bool;
    var phi_1161_: f32;
    var phi_1166_: doubt_Listed;
    var phi_1167_: bool;
    var phi_1180_: u32;
    var phi_1197_: u32;

    let _e54 = id_1;
    let _e55 = local_1;
    let _e72 = p.member.current.size[0u];
    let _e74 = p.member.current.size[1u];
    let _e75 = lt_shaders_entry_pixel_index(_e54, _e72, _e74);
    if (bitcast<i32>(_e75.root) != 0i) {
        let _e83 = p.member.current.size[0u];
        let _e86 = samples.member[_e75.first_primitive].position;
        let _e88 = visibility.member[_e75.first_primitive];
        let _e94 = samples.member[_e75.first_primitive].normal[0u];
        let _e96 = global[0u];
        if (_e94 == _e96) {
            let _e99 = samples.member[_e75.first_primitive].normal[1u];
            let _e101 = global[1u];
            if (_e99 == _e101) {
                let _e104 = samples.member[_e75.first_primitive].normal[2u];
                let _e106 = global[2u];
                phi_246_ = (_e104 == _e106);
                phi_247_ = false;
            } else {
                phi_246_ = bool();
                phi_247_ = true;
            }
            let _e109 = phi_246_;
            let _e111 = phi_247_;
            phi_248_ = _e109;
            phi_249_ = _e111;
        } else {
            phi_248_ = bool();
            phi_249_ = true;
        }
        let _e113 = phi_248_;
        let _e115 = phi_249_;
        if _e115 {
            phi_253_ = false;
        } else {
            phi_253_ = _e113;
        }
        let _e117 = phi_253_;
        if !(_e117) {
            let _e120 = samples.member[_e75.first_primitive].position;
            let _e122 = p.member.light.place;
            let _e128 = p.member.light.place[3u];
            let _e135 = (_e122.x - (_e120.x * _e128));
            let _e136 = (_e122.y - (_e120.y * _e128));
            let _e137 = (_e122.z - (_e120.z * _e128));
            let _e139 = samples.member[_e75.first_primitive].normal;
            if ((((_e139.x * _e135) + (_e139.y * _e136)) + (_e139.z * _e137)) > 0f) {
                let _e153 = (((_e135 * _e135) + (_e136 * _e136)) + (_e137 * _e137));
                let _e155 = p.member.light.axis;
                let _e167 = p.member.light.place[3u];
                if (_e167 == 0f) {
                    phi_324_ = true;
                } else {
                    let _e170 = p.member.light.range_squared;
                    if (_e153 <= _e170) {
                        let _e173 = p.member.light.cos_outer;
                        phi_323_ = (-((((_e135 * _e155.x) + (_e136 * _e155.y)) + (_e137 * _e155.z))) >= (_e173 * sqrt(_e153)));
                    } else {
                        phi_323_ = false;
                    }
                    let _e178 = phi_323_;
                    phi_324_ = _e178;
                }
                let _e180 = phi_324_;
                if _e180 {
                    let _e182 = samples.member[_e75.first_primitive].flags;
                    let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e190.unnamed.visibility, false), _e190.unnamed_1);
                    phi_335_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e196.unnamed, ((_e182 & 1u) == 0u));
                    phi_336_ = false;
                } else {
                    phi_335_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_336_ = true;
                }
                let _e201 = phi_335_;
                let _e203 = phi_336_;
                phi_337_ = _e201;
                phi_338_ = _e203;
            } else {
                phi_337_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_338_ = true;
            }
            let _e205 = phi_337_;
            let _e207 = phi_338_;
            if _e207 {
                let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
                phi_345_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
            } else {
                phi_345_ = _e205;
            }
            let _e224 = phi_345_;
            phi_349_ = _e224;
        } else {
            let _e230 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e236 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e230.unnamed.visibility, false), _e230.unnamed_1);
            phi_349_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e236.unnamed, true);
        }
        let _e241 = phi_349_;
        if _e241.unnamed_1 {
            phi_1054_ = mask_Masked(_e241.unnamed.visibility, 0u, false, false);
        } else {
            let _e246 = (_e88 < 0.5f);
            if (_e88 > 0f) {
                phi_362_ = (_e88 < 1f);
            } else {
                phi_362_ = false;
            }
            let _e250 = phi_362_;
            let _e257 = lt_mask_Reprojection(vec2<u32>(_e54.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e264 = lt_mask_Reprojection(vec2<u32>(_e257.pixel.x, _e54.y), _e257.is_valid, _e257.has_moved);
            let _e268 = lt_mask_Reprojection(_e264.pixel, true, _e264.has_moved);
            let _e274 = p.member.flags;
            if ((_e274 & 16u) == 0u) {
                phi_401_ = false;
            } else {
                let _e280 = samples.member[_e75.first_primitive].position[0u];
                if (_e86.x == _e280) {
                    let _e284 = samples.member[_e75.first_primitive].position[1u];
                    if (_e86.y == _e284) {
                        let _e288 = samples.member[_e75.first_primitive].position[2u];
                        phi_393_ = (_e86.z == _e288);
                        phi_394_ = false;
                    } else {
                        phi_393_ = bool();
                        phi_394_ = true;
                    }
                    let _e291 = phi_393_;
                    let _e293 = phi_394_;
                    phi_395_ = _e291;
                    phi_396_ = _e293;
                } else {
                    phi_395_ = bool();
                    phi_396_ = true;
                }
                let _e295 = phi_395_;
                let _e297 = phi_396_;
                if _e297 {
                    phi_400_ = false;
                } else {
                    phi_400_ = _e295;
                }
                let _e299 = phi_400_;
                phi_401_ = _e299;
            }
            let _e301 = phi_401_;
            if _e301 {
                phi_710_ = lt_mask_Reprojection(_e268.pixel, _e268.is_valid, false);
                phi_711_ = lt_mask_Reprojection();
                phi_712_ = lt_mask_Reprojection();
                phi_713_ = true;
                phi_714_ = false;
            } else {
                let _e305 = p.member.current.grid[0u];
                let _e307 = p.member.current.grid[1u];
                let _e321 = (f32(_e54.x) + ((f32((_e54.y & (_e307 - 1u))) + 0.5f) / f32(_e307)));
                let _e323 = (f32(_e54.y) + ((f32((_e54.x & (_e305 - 1u))) + 0.5f) / f32(_e305)));
                let _e326 = p.member.previous.eye;
                let _e329 = (_e86.x - _e326.x);
                let _e332 = (_e86.y - _e326.y);
                let _e335 = (_e86.z - _e326.z);
                let _e337 = p.member.previous.forward;
                let _e345 = (((_e329 * _e337.x) + (_e332 * _e337.y)) + (_e335 * _e337.z));
                let _e347 = p.member.previous.right;
                let _e357 = p.member.previous.right;
                let _e372 = p.member.previous.up;
                let _e382 = p.member.previous.up;
                let _e399 = p.member.previous.size[0u];
                let _e406 = p.member.previous.size[1u];
                let _e410 = (((((((_e329 * _e347.x) + (_e332 * _e347.y)) + (_e335 * _e347.z)) / ((((_e357.x * _e357.x) + (_e357.y * _e357.y)) + (_e357.z * _e357.z)) * _e345)) + 1f) * (0.5f * f32(_e399))) - _e321);
                let _e411 = (((1f - ((((_e329 * _e372.x) + (_e332 * _e372.y)) + (_e335 * _e372.z)) / ((((_e382.x * _e382.x) + (_e382.y * _e382.y)) + (_e382.z * _e382.z)) * _e345))) * (0.5f * f32(_e406))) - _e323);
                let _e415 = p.member.current.size[0u];
                let _e417 = p.member.current.size[1u];
                let _e419 = (_e321 + _e410);
                if (_e419 > -8388608f) {
                    let _e431 = f32(select(0i, select(select(i32(_e419), i32(-2147483648), (_e419 < bitcast<f32>(3472883712u))), 2147483647i, (_e419 > bitcast<f32>(1325400063u))), (_e419 == _e419)));
                    if (_e431 > _e419) {
                        phi_540_ = 1f;
                    } else {
                        phi_540_ = 0f;
                    }
                    let _e434 = phi_540_;
                    if (_e419 < 8388608f) {
                        phi_545_ = (_e431 - _e434);
                        phi_546_ = false;
                    } else {
                        phi_545_ = f32();
                        phi_546_ = true;
                    }
                    let _e437 = phi_545_;
                    let _e439 = phi_546_;
                    phi_547_ = _e437;
                    phi_548_ = _e439;
                } else {
                    phi_547_ = f32();
                    phi_548_ = true;
                }
                let _e441 = phi_547_;
                let _e443 = phi_548_;
                if _e443 {
                    phi_552_ = _e419;
                } else {
                    phi_552_ = _e441;
                }
                let _e445 = phi_552_;
                let _e446 = (_e323 + _e411);
                if (_e446 > -8388608f) {
                    let _e458 = f32(select(0i, select(select(i32(_e446), i32(-2147483648), (_e446 < bitcast<f32>(3472883712u))), 2147483647i, (_e446 > bitcast<f32>(1325400063u))), (_e446 == _e446)));
                    if (_e458 > _e446) {
                        phi_573_ = 1f;
                    } else {
                        phi_573_ = 0f;
                    }
                    let _e461 = phi_573_;
                    if (_e446 < 8388608f) {
                        phi_578_ = (_e458 - _e461);
                        phi_579_ = false;
                    } else {
                        phi_578_ = f32();
                        phi_579_ = true;
                    }
                    let _e464 = phi_578_;
                    let _e466 = phi_579_;
                    phi_580_ = _e464;
                    phi_581_ = _e466;
                } else {
                    phi_580_ = f32();
                    phi_581_ = true;
                }
                let _e468 = phi_580_;
                let _e470 = phi_581_;
                if _e470 {
                    phi_585_ = _e446;
                } else {
                    phi_585_ = _e468;
                }
                let _e472 = phi_585_;
                if (_e445 >= 0f) {
                    if (_e472 >= 0f) {
                        if (_e445 < f32(_e415)) {
                            let _e478 = (_e472 < f32(_e417));
                            if (_e410 == 0f) {
                                phi_606_ = (_e411 == 0f);
                            } else {
                                phi_606_ = false;
                            }
                            let _e482 = phi_606_;
                            if _e478 {
                                phi_625_ = vec2<u32>(select(select(u32(_e445), 0u, (_e445 < bitcast<f32>(0u))), 4294967295u, (_e445 > bitcast<f32>(1333788671u))), select(select(u32(_e472), 0u, (_e472 < bitcast<f32>(0u))), 4294967295u, (_e472 > bitcast<f32>(1333788671u))));
                                phi_626_ = false;
                            } else {
                                phi_625_ = vec2<u32>();
                                phi_626_ = true;
                            }
                            let _e499 = phi_625_;
                            let _e501 = phi_626_;
                            phi_627_ = _e482;
                            phi_628_ = _e478;
                            phi_629_ = _e499;
                            phi_630_ = _e482;
                            phi_631_ = _e478;
                            phi_632_ = false;
                            phi_633_ = _e501;
                        } else {
                            phi_627_ = bool();
                            phi_628_ = bool();
                            phi_629_ = vec2<u32>();
                            phi_630_ = bool();
                            phi_631_ = bool();
                            phi_632_ = true;
                            phi_633_ = false;
                        }
                        let _e503 = phi_627_;
                        let _e505 = phi_628_;
                        let _e507 = phi_629_;
                        let _e509 = phi_630_;
                        let _e511 = phi_631_;
                        let _e513 = phi_632_;
                        let _e515 = phi_633_;
                        phi_634_ = _e503;
                        phi_635_ = _e505;
                        phi_636_ = _e507;
                        phi_637_ = _e509;
                        phi_638_ = _e511;
                        phi_639_ = _e513;
                        phi_640_ = _e515;
                    } else {
                        phi_634_ = bool();
                        phi_635_ = bool();
                        phi_636_ = vec2<u32>();
                        phi_637_ = bool();
                        phi_638_ = bool();
                        phi_639_ = true;
                        phi_640_ = false;
                    }
                    let _e517 = phi_634_;
                    let _e519 = phi_635_;
                    let _e521 = phi_636_;
                    let _e523 = phi_637_;
                    let _e525 = phi_638_;
                    let _e527 = phi_639_;
                    let _e529 = phi_640_;
                    phi_641_ = _e517;
                    phi_642_ = _e519;
                    phi_643_ = _e521;
                    phi_644_ = _e523;
                    phi_645_ = _e525;
                    phi_646_ = _e527;
                    phi_647_ = _e529;
                } else {
                    phi_641_ = bool();
                    phi_642_ = bool();
                    phi_643_ = vec2<u32>();
                    phi_644_ = bool();
                    phi_645_ = bool();
                    phi_646_ = true;
                    phi_647_ = false;
                }
                let _e531 = phi_641_;
                let _e533 = phi_642_;
                let _e535 = phi_643_;
                let _e537 = phi_644_;
                let _e539 = phi_645_;
                let _e541 = phi_646_;
                let _e543 = phi_647_;
                if _e541 {
                    if (_e410 == 0f) {
                        phi_656_ = (_e411 == 0f);
                    } else {
                        phi_656_ = false;
                    }
                    let _e547 = phi_656_;
                    phi_657_ = _e547;
                    phi_658_ = false;
                    phi_659_ = true;
                } else {
                    phi_657_ = _e537;
                    phi_658_ = _e539;
                    phi_659_ = _e543;
                }
                let _e549 = phi_657_;
                let _e551 = phi_658_;
                let _e553 = phi_659_;
                if _e553 {
                    phi_663_ = _e549;
                    phi_664_ = _e551;
                    phi_665_ = vec2<u32>(_e54.x, _e54.y);
                } else {
                    phi_663_ = _e531;
                    phi_664_ = _e533;
                    phi_665_ = _e535;
                }
                let _e555 = phi_663_;
                let _e557 = phi_664_;
                let _e559 = phi_665_;
                let _e569 = lt_mask_Reprojection(vec2<u32>(_e559.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e576 = lt_mask_Reprojection(vec2<u32>(_e569.pixel.x, _e559.y), _e569.is_valid, _e569.has_moved);
                let _e580 = lt_mask_Reprojection(_e576.pixel, _e557, _e576.has_moved);
                let _e584 = lt_mask_Reprojection(_e580.pixel, _e580.is_valid, !(_e555));
                if _e557 {
                    let _e587 = p.member.previous.eye;
                    let _e598 = p.member.previous.forward;
                    let _e607 = (((((_e86.x - _e587.x) * _e598.x) + ((_e86.y - _e587.y) * _e598.y)) + ((_e86.z - _e587.z) * _e598.z)) > 0f);
                    let _e611 = lt_mask_Reprojection(_e584.pixel, _e607, _e584.has_moved);
                    if _e607 {
                        phi_703_ = false;
                    } else {
                        phi_703_ = true;
                    }
                    let _e613 = phi_703_;
                    phi_705_ = _e611;
                    phi_706_ = _e611;
                    phi_707_ = lt_mask_Reprojection();
                    phi_708_ = _e607;
                    phi_709_ = _e613;
                } else {
                    phi_705_ = lt_mask_Reprojection();
                    phi_706_ = lt_mask_Reprojection();
                    phi_707_ = lt_mask_Reprojection(_e584.pixel, false, _e584.has_moved);
                    phi_708_ = false;
                    phi_709_ = false;
                }
                let _e619 = phi_705_;
                let _e621 = phi_706_;
                let _e623 = phi_707_;
                let _e625 = phi_708_;
                let _e627 = phi_709_;
                phi_710_ = _e619;
                phi_711_ = _e621;
                phi_712_ = _e623;
                phi_713_ = _e625;
                phi_714_ = _e627;
            }
            let _e629 = phi_710_;
            let _e631 = phi_711_;
            let _e633 = phi_712_;
            let _e635 = phi_713_;
            let _e637 = phi_714_;
            if _e635 {
                let _e640 = p.member.previous.eye;
                let _e651 = p.member.previous.forward;
                let _e659 = ((((_e86.x - _e640.x) * _e651.x) + ((_e86.y - _e640.y) * _e651.y)) + ((_e86.z - _e640.z) * _e651.z));
                let _e665 = ((_e629.pixel.y * _e83) + _e629.pixel.x);
                if (_e665 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e669 = last_depths.member[(0u + _e665)];
                let _e671 = p.member.depth_tolerance;
                let _e674 = abs(_e659);
                let _e675 = abs(_e669);
                if ((bitcast<u32>(_e675) & 2147483647u) > 2139095040u) {
                    phi_769_ = true;
                } else {
                    let _e679 = (_e675 > _e674);
                    if _e679 {
                    }
                    phi_769_ = _e679;
                }
                let _e681 = phi_769_;
                if _e681 {
                    phi_773_ = _e675;
                } else {
                    phi_773_ = _e674;
                }
                let _e683 = phi_773_;
                phi_777_ = lt_mask_Reprojection(_e629.pixel, (abs((_e659 - _e669)) <= (_e671 * _e683)), _e629.has_moved);
                phi_778_ = true;
            } else {
                phi_777_ = _e631;
                phi_778_ = _e637;
            }
            let _e691 = phi_777_;
            let _e693 = phi_778_;
            if _e693 {
                if _e691.is_valid {
                    let _e696 = p.member.flags;
                    phi_790_ = ((_e696 & 1u) != 0u);
                    phi_791_ = false;
                } else {
                    phi_790_ = bool();
                    phi_791_ = true;
                }
                let _e700 = phi_790_;
                let _e702 = phi_791_;
                phi_792_ = _e700;
                phi_793_ = _e691;
                phi_794_ = _e702;
            } else {
                phi_792_ = bool();
                phi_793_ = _e633;
                phi_794_ = true;
            }
            let _e704 = phi_792_;
            let _e706 = phi_793_;
            let _e708 = phi_794_;
            if _e708 {
                phi_798_ = false;
                phi_799_ = _e706;
            } else {
                phi_798_ = _e704;
                phi_799_ = _e691;
            }
            let _e710 = phi_798_;
            let _e712 = phi_799_;
            let _e716 = lt_mask_Reprojection(_e712.pixel, _e710, _e712.has_moved);
            let _e717 = lt_mask_Neighbourhood(false, true);
            if _e250 {
                phi_805_ = false;
            } else {
                phi_805_ = true;
            }
            let _e719 = phi_805_;
            if _e719 {
                if _e710 {
                    if ((0u & 2u) != 0u) {
                        phi_866_ = _e717;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e728 = (_e83 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e83 % 32u) > 0u) {
                            phi_837_ = (_e728 + 1u);
                        } else {
                            phi_837_ = _e728;
                        }
                        let _e734 = phi_837_;
                        let _e744 = ((((_e716.pixel.y * _e734) + (_e716.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e246) | (select(0u, 1u, _e716.has_moved) << bitcast<u32>(1i))));
                        if (_e744 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e748 = heard.member[(0u + _e744)];
                        let _e754 = (((_e748 >> bitcast<u32>(((_e716.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_866_ = lt_mask_Neighbourhood(_e754, !(_e754));
                    }
                    let _e758 = phi_866_;
                    phi_867_ = _e758;
                } else {
                    phi_867_ = _e717;
                }
                let _e760 = phi_867_;
                phi_868_ = _e760;
            } else {
                phi_868_ = _e717;
            }
            let _e762 = phi_868_;
            let _e765 = p.member.frame;
            let _e767 = p.member.refresh;
            if (_e767 == 0u) {
                phi_901_ = false;
            } else {
                if (_e767 == 0u) {
                    return;
                }
                let _e776 = ((_e54.x + (_e54.y * (((_e767 * 5u) / 8u) | 1u))) + (_e765 % _e767));
                if (_e767 == 0u) {
                    phi_900_ = (_e776 == 0u);
                } else {
                    if (_e767 == 0u) {
                        return;
                    }
                    phi_900_ = ((_e776 % _e767) == 0u);
                }
                let _e783 = phi_900_;
                phi_901_ = _e783;
            }
            let _e785 = phi_901_;
            if _e710 {
                if _e785 {
                    phi_923_ = bool();
                } else {
                    phi_923_ = ((0u & 2u) != 0u);
                }
                let _e791 = phi_923_;
                phi_924_ = _e791;
                phi_925_ = _e785;
            } else {
                phi_924_ = bool();
                phi_925_ = true;
            }
            let _e793 = phi_924_;
            let _e795 = phi_925_;
            if _e795 {
                phi_929_ = false;
            } else {
                phi_929_ = _e793;
            }
            let _e797 = phi_929_;
            if _e797 {
                phi_980_ = 7u;
            } else {
                if (_e88 != 0.5f) {
                    if _e710 {
                        if _e785 {
                            phi_977_ = 6u;
                        } else {
                            if _e250 {
                                phi_952_ = true;
                            } else {
                                if _e762.any_expands {
                                    phi_951_ = false;
                                } else {
                                    phi_951_ = true;
                                }
                                let _e799 = phi_951_;
                                phi_952_ = _e799;
                            }
                            let _e801 = phi_952_;
                            if _e801 {
                                if _e250 {
                                    if false {
                                        if _e762.all_remove {
                                            phi_965_ = false;
                                        } else {
                                            phi_965_ = true;
                                        }
                                        let _e803 = phi_965_;
                                        phi_966_ = _e803;
                                    } else {
                                        phi_966_ = true;
                                    }
                                    let _e805 = phi_966_;
                                    phi_967_ = _e805;
                                } else {
                                    phi_967_ = true;
                                }
                                let _e807 = phi_967_;
                                if _e807 {
                                    if _e250 {
                                        phi_974_ = 1u;
                                    } else {
                                        phi_974_ = 0u;
                                    }
                                    let _e809 = phi_974_;
                                    phi_975_ = _e809;
                                } else {
                                    phi_975_ = 5u;
                                }
                                let _e811 = phi_975_;
                                phi_976_ = _e811;
                            } else {
                                phi_976_ = 4u;
                            }
                            let _e813 = phi_976_;
                            phi_977_ = _e813;
                        }
                        let _e815 = phi_977_;
                        phi_978_ = _e815;
                    } else {
                        phi_978_ = 3u;
                    }
                    let _e817 = phi_978_;
                    phi_979_ = _e817;
                } else {
                    phi_979_ = 2u;
                }
                let _e819 = phi_979_;
                phi_980_ = _e819;
            }
            let _e821 = phi_980_;
            if !((_e821 == 0u)) {
                if !((_e821 == 5u)) {
                    phi_992_ = !(_e797);
                    phi_993_ = false;
                } else {
                    phi_992_ = bool();
                    phi_993_ = true;
                }
                let _e828 = phi_992_;
                let _e830 = phi_993_;
                phi_994_ = _e828;
                phi_995_ = _e830;
            } else {
                phi_994_ = bool();
                phi_995_ = true;
            }
            let _e832 = phi_994_;
            let _e834 = phi_995_;
            if _e834 {
                phi_999_ = false;
            } else {
                phi_999_ = _e832;
            }
            let _e836 = phi_999_;
            if _e797 {
                phi_1005_ = ((0u & 4u) != 0u);
            } else {
                phi_1005_ = _e246;
            }
            let _e840 = phi_1005_;
            if _e836 {
                if _e246 {
                    phi_1013_ = (2u | 1u);
                } else {
                    phi_1013_ = 2u;
                }
                let _e843 = phi_1013_;
                if false {
                    phi_1018_ = (_e843 | 4u);
                } else {
                    phi_1018_ = _e843;
                }
                let _e846 = phi_1018_;
                phi_1038_ = _e846;
            } else {
                if (_e821 == 7u) {
                    if _e246 {
                        phi_1027_ = (2u | 1u);
                    } else {
                        phi_1027_ = 2u;
                    }
                    let _e850 = phi_1027_;
                    if _e840 {
                        phi_1032_ = (_e850 | 4u);
                    } else {
                        phi_1032_ = _e850;
                    }
                    let _e853 = phi_1032_;
                    phi_1037_ = _e853;
                } else {
                    if _e246 {
                        phi_1036_ = 1u;
                    } else {
                        phi_1036_ = 0u;
                    }
                    let _e855 = phi_1036_;
                    phi_1037_ = _e855;
                }
                let _e857 = phi_1037_;
                phi_1038_ = _e857;
            }
            let _e859 = phi_1038_;
            if _e840 {
                phi_1042_ = 0f;
            } else {
                phi_1042_ = 1f;
            }
            let _e861 = phi_1042_;
            if _e250 {
                if (_e88 == 0.99999994f) {
                    phi_1051_ = true;
                } else {
                    phi_1051_ = (_e88 == 0.000000059604645f);
                }
                let _e865 = phi_1051_;
                phi_1052_ = _e865;
            } else {
                phi_1052_ = true;
            }
            let _e867 = phi_1052_;
            phi_1054_ = mask_Masked(_e861, _e859, _e836, _e867);
        }
        let _e870 = phi_1054_;
        visibility.member[_e75.first_primitive] = _e870.visibility;
        let _e875 = p.member.light.number;
        let _e876 = (_e875 * 3u);
        let _e878 = (_e876 % 32u);
        let _e880 = p.member.light.mask_words;
        let _e882 = ((_e75.first_primitive * _e880) + (_e876 / 32u));
        let _e884 = bits.member[_e882];
        bits.member[_e882] = ((_e884 & ~((7u << bitcast<u32>((_e878 & 31u))))) | (_e870.bits << bitcast<u32>((_e878 & 31u))));
        if (_e878 > 29u) {
            let _e899 = bits.member[(_e882 + 1u)];
            let _e901 = (32u - _e878);
            bits.member[(_e882 + 1u)] = ((_e899 & ~((7u >> bitcast<u32>((_e901 & 31u))))) | (_e870.bits >> bitcast<u32>((_e901 & 31u))));
        }
        let _e916 = samples.member[_e75.first_primitive].normal[0u];
        let _e918 = global[0u];
        if (_e916 == _e918) {
            let _e921 = samples.member[_e75.first_primitive].normal[1u];
            let _e923 = global[1u];
            if (_e921 == _e923) {
                let _e926 = samples.member[_e75.first_primitive].normal[2u];
                let _e928 = global[2u];
                phi_1126_ = (_e926 == _e928);
                phi_1127_ = false;
            } else {
                phi_1126_ = bool();
                phi_1127_ = true;
            }
            let _e931 = phi_1126_;
            let _e933 = phi_1127_;
            phi_1128_ = _e931;
            phi_1129_ = _e933;
        } else {
            phi_1128_ = bool();
            phi_1129_ = true;
        }
        let _e935 = phi_1128_;
        let _e937 = phi_1129_;
        if _e937 {
            phi_1133_ = false;
        } else {
            phi_1133_ = _e935;
        }
        let _e939 = phi_1133_;
        if !(_e939) {
            let _e942 = samples.member[_e75.first_primitive].position;
            let _e944 = p.member.current.eye;
            let _e955 = p.member.current.forward;
            phi_1161_ = ((((_e942.x - _e944.x) * _e955.x) + ((_e942.y - _e944.y) * _e955.y)) + ((_e942.z - _e944.z) * _e955.z));
        } else {
            phi_1161_ = 0f;
        }
        let _e965 = phi_1161_;
        depths.member[_e75.first_primitive] = _e965;
        phi_1166_ = doubt_Listed(_e75.first_primitive, _e870.is_trusted);
        phi_1167_ = _e870.needs_ray;
    } else {
        phi_1166_ = doubt_Listed(0u, false);
        phi_1167_ = false;
    }
    let _e971 = phi_1166_;
    let _e973 = phi_1167_;
    if (_e55 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e973 {
        let _e979 = atomicAdd((&shared_[0u]), 1u);
        phi_1180_ = _e979;
    } else {
        phi_1180_ = 0u;
    }
    let _e981 = phi_1180_;
    workgroupBarrier();
    if (_e55 == 0u) {
        let _e985 = atomicLoad((&shared_[0u]));
        let _e986 = atomicAdd((&list.member[3u]), _e985);
        atomicStore((&shared_[1u]), _e986);
    }
    workgroupBarrier();
    if _e973 {
        if _e971.is_trusted {
            phi_1197_ = (_e971.pixel | 2147483648u);
        } else {
            phi_1197_ = _e971.pixel;
        }
        let _e990 = phi_1197_;
        let _e992 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e992) + _e981)]), _e990);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
