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
    var phi_547_: f32;
    var phi_552_: f32;
    var phi_553_: bool;
    var phi_554_: f32;
    var phi_555_: bool;
    var phi_559_: f32;
    var phi_580_: f32;
    var phi_585_: f32;
    var phi_586_: bool;
    var phi_587_: f32;
    var phi_588_: bool;
    var phi_592_: f32;
    var phi_613_: bool;
    var phi_632_: vec2<u32>;
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
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_650_: vec2<u32>;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_666_: bool;
    var phi_670_: bool;
    var phi_671_: bool;
    var phi_672_: vec2<u32>;
    var phi_710_: bool;
    var phi_712_: lt_mask_Reprojection;
    var phi_713_: lt_mask_Reprojection;
    var phi_714_: lt_mask_Reprojection;
    var phi_715_: bool;
    var phi_716_: bool;
    var phi_717_: lt_mask_Reprojection;
    var phi_718_: lt_mask_Reprojection;
    var phi_719_: lt_mask_Reprojection;
    var phi_720_: bool;
    var phi_721_: bool;
    var phi_776_: bool;
    var phi_780_: f32;
    var phi_784_: lt_mask_Reprojection;
    var phi_785_: bool;
    var phi_797_: bool;
    var phi_798_: bool;
    var phi_799_: bool;
    var phi_800_: lt_mask_Reprojection;
    var phi_801_: bool;
    var phi_805_: bool;
    var phi_806_: lt_mask_Reprojection;
    var phi_812_: bool;
    var phi_844_: u32;
    var phi_873_: lt_mask_Neighbourhood;
    var phi_874_: lt_mask_Neighbourhood;
    var phi_875_: lt_mask_Neighbourhood;
    var phi_907_: bool;
    var phi_908_: bool;
    var phi_930_: bool;
    var phi_931_: bool;
    var phi_932_: bool;
    var phi_936_: bool;
    var phi_958_: bool;
    var phi_959_: bool;
    var phi_972_: bool;
    var phi_973_: bool;
    var phi_974_: bool;
    var phi_981_: u32;
    var phi_982_: u32;
    var phi_983_: u32;
    var phi_984_: u32;
    var phi_985_: u32;
    var phi_986_: u32;
    var phi_987_: u32;
    var phi_999_: bool;
    var phi_1000_: bool;
    var phi_1001_: bool;
    var phi_1002_: bool;
    var phi_1006_: bool;
    var phi_1012_: bool;
    var phi_1020_: u32;
    var phi_1025_: u32;
    var phi_1034_: u32;
    var phi_1039_: u32;
    var phi_1043_: u32;
    var phi_1044_: u32;
    var phi_1045_: u32;
    var phi_1049_: f32;
    var phi_1058_: bool;
    var phi_1059_: bool;
    var phi_1061_: mask_Masked;
    var phi_1133_: bool;
    var phi_1134_: bool;
    var phi_1135_: bool;
    var phi_1136_: bool;
    var phi_1140_: bool;
    var phi_1168_: f32;
    var phi_1173_: doubt_Listed;
    var phi_1174_: bool;
    var phi_1187_: u32;
    var phi_1204_: u32;

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
            phi_1061_ = mask_Masked(_e241.unnamed.visibility, 0u, false, false);
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
                phi_717_ = lt_mask_Reprojection(_e268.pixel, _e268.is_valid, false);
                phi_718_ = lt_mask_Reprojection();
                phi_719_ = lt_mask_Reprojection();
                phi_720_ = true;
                phi_721_ = false;
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
                let _e346 = (1f / (((_e329 * _e337.x) + (_e332 * _e337.y)) + (_e335 * _e337.z)));
                let _e348 = p.member.previous.right;
                let _e350 = p.member.previous.right;
                let _e362 = (1f / (((_e350.x * _e350.x) + (_e350.y * _e350.y)) + (_e350.z * _e350.z)));
                let _e370 = p.member.previous.up;
                let _e372 = p.member.previous.up;
                let _e384 = (1f / (((_e372.x * _e372.x) + (_e372.y * _e372.y)) + (_e372.z * _e372.z)));
                let _e406 = p.member.previous.size[0u];
                let _e413 = p.member.previous.size[1u];
                let _e417 = (((((((_e329 * (_e348.x * _e362)) + (_e332 * (_e348.y * _e362))) + (_e335 * (_e348.z * _e362))) * _e346) + 1f) * (0.5f * f32(_e406))) - _e321);
                let _e418 = (((1f - ((((_e329 * (_e370.x * _e384)) + (_e332 * (_e370.y * _e384))) + (_e335 * (_e370.z * _e384))) * _e346)) * (0.5f * f32(_e413))) - _e323);
                let _e422 = p.member.current.size[0u];
                let _e424 = p.member.current.size[1u];
                let _e426 = (_e321 + _e417);
                if (_e426 > -8388608f) {
                    let _e438 = f32(select(0i, select(select(i32(_e426), i32(-2147483648), (_e426 < bitcast<f32>(3472883712u))), 2147483647i, (_e426 > bitcast<f32>(1325400063u))), (_e426 == _e426)));
                    if (_e438 > _e426) {
                        phi_547_ = 1f;
                    } else {
                        phi_547_ = 0f;
                    }
                    let _e441 = phi_547_;
                    if (_e426 < 8388608f) {
                        phi_552_ = (_e438 - _e441);
                        phi_553_ = false;
                    } else {
                        phi_552_ = f32();
                        phi_553_ = true;
                    }
                    let _e444 = phi_552_;
                    let _e446 = phi_553_;
                    phi_554_ = _e444;
                    phi_555_ = _e446;
                } else {
                    phi_554_ = f32();
                    phi_555_ = true;
                }
                let _e448 = phi_554_;
                let _e450 = phi_555_;
                if _e450 {
                    phi_559_ = _e426;
                } else {
                    phi_559_ = _e448;
                }
                let _e452 = phi_559_;
                let _e453 = (_e323 + _e418);
                if (_e453 > -8388608f) {
                    let _e465 = f32(select(0i, select(select(i32(_e453), i32(-2147483648), (_e453 < bitcast<f32>(3472883712u))), 2147483647i, (_e453 > bitcast<f32>(1325400063u))), (_e453 == _e453)));
                    if (_e465 > _e453) {
                        phi_580_ = 1f;
                    } else {
                        phi_580_ = 0f;
                    }
                    let _e468 = phi_580_;
                    if (_e453 < 8388608f) {
                        phi_585_ = (_e465 - _e468);
                        phi_586_ = false;
                    } else {
                        phi_585_ = f32();
                        phi_586_ = true;
                    }
                    let _e471 = phi_585_;
                    let _e473 = phi_586_;
                    phi_587_ = _e471;
                    phi_588_ = _e473;
                } else {
                    phi_587_ = f32();
                    phi_588_ = true;
                }
                let _e475 = phi_587_;
                let _e477 = phi_588_;
                if _e477 {
                    phi_592_ = _e453;
                } else {
                    phi_592_ = _e475;
                }
                let _e479 = phi_592_;
                if (_e452 >= 0f) {
                    if (_e479 >= 0f) {
                        if (_e452 < f32(_e422)) {
                            let _e485 = (_e479 < f32(_e424));
                            if (_e417 == 0f) {
                                phi_613_ = (_e418 == 0f);
                            } else {
                                phi_613_ = false;
                            }
                            let _e489 = phi_613_;
                            if _e485 {
                                phi_632_ = vec2<u32>(select(select(u32(_e452), 0u, (_e452 < bitcast<f32>(0u))), 4294967295u, (_e452 > bitcast<f32>(1333788671u))), select(select(u32(_e479), 0u, (_e479 < bitcast<f32>(0u))), 4294967295u, (_e479 > bitcast<f32>(1333788671u))));
                                phi_633_ = false;
                            } else {
                                phi_632_ = vec2<u32>();
                                phi_633_ = true;
                            }
                            let _e506 = phi_632_;
                            let _e508 = phi_633_;
                            phi_634_ = _e489;
                            phi_635_ = _e485;
                            phi_636_ = _e506;
                            phi_637_ = _e489;
                            phi_638_ = _e485;
                            phi_639_ = false;
                            phi_640_ = _e508;
                        } else {
                            phi_634_ = bool();
                            phi_635_ = bool();
                            phi_636_ = vec2<u32>();
                            phi_637_ = bool();
                            phi_638_ = bool();
                            phi_639_ = true;
                            phi_640_ = false;
                        }
                        let _e510 = phi_634_;
                        let _e512 = phi_635_;
                        let _e514 = phi_636_;
                        let _e516 = phi_637_;
                        let _e518 = phi_638_;
                        let _e520 = phi_639_;
                        let _e522 = phi_640_;
                        phi_641_ = _e510;
                        phi_642_ = _e512;
                        phi_643_ = _e514;
                        phi_644_ = _e516;
                        phi_645_ = _e518;
                        phi_646_ = _e520;
                        phi_647_ = _e522;
                    } else {
                        phi_641_ = bool();
                        phi_642_ = bool();
                        phi_643_ = vec2<u32>();
                        phi_644_ = bool();
                        phi_645_ = bool();
                        phi_646_ = true;
                        phi_647_ = false;
                    }
                    let _e524 = phi_641_;
                    let _e526 = phi_642_;
                    let _e528 = phi_643_;
                    let _e530 = phi_644_;
                    let _e532 = phi_645_;
                    let _e534 = phi_646_;
                    let _e536 = phi_647_;
                    phi_648_ = _e524;
                    phi_649_ = _e526;
                    phi_650_ = _e528;
                    phi_651_ = _e530;
                    phi_652_ = _e532;
                    phi_653_ = _e534;
                    phi_654_ = _e536;
                } else {
                    phi_648_ = bool();
                    phi_649_ = bool();
                    phi_650_ = vec2<u32>();
                    phi_651_ = bool();
                    phi_652_ = bool();
                    phi_653_ = true;
                    phi_654_ = false;
                }
                let _e538 = phi_648_;
                let _e540 = phi_649_;
                let _e542 = phi_650_;
                let _e544 = phi_651_;
                let _e546 = phi_652_;
                let _e548 = phi_653_;
                let _e550 = phi_654_;
                if _e548 {
                    if (_e417 == 0f) {
                        phi_663_ = (_e418 == 0f);
                    } else {
                        phi_663_ = false;
                    }
                    let _e554 = phi_663_;
                    phi_664_ = _e554;
                    phi_665_ = false;
                    phi_666_ = true;
                } else {
                    phi_664_ = _e544;
                    phi_665_ = _e546;
                    phi_666_ = _e550;
                }
                let _e556 = phi_664_;
                let _e558 = phi_665_;
                let _e560 = phi_666_;
                if _e560 {
                    phi_670_ = _e556;
                    phi_671_ = _e558;
                    phi_672_ = vec2<u32>(_e54.x, _e54.y);
                } else {
                    phi_670_ = _e538;
                    phi_671_ = _e540;
                    phi_672_ = _e542;
                }
                let _e562 = phi_670_;
                let _e564 = phi_671_;
                let _e566 = phi_672_;
                let _e576 = lt_mask_Reprojection(vec2<u32>(_e566.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e583 = lt_mask_Reprojection(vec2<u32>(_e576.pixel.x, _e566.y), _e576.is_valid, _e576.has_moved);
                let _e587 = lt_mask_Reprojection(_e583.pixel, _e564, _e583.has_moved);
                let _e591 = lt_mask_Reprojection(_e587.pixel, _e587.is_valid, !(_e562));
                if _e564 {
                    let _e594 = p.member.previous.eye;
                    let _e605 = p.member.previous.forward;
                    let _e614 = (((((_e86.x - _e594.x) * _e605.x) + ((_e86.y - _e594.y) * _e605.y)) + ((_e86.z - _e594.z) * _e605.z)) > 0f);
                    let _e618 = lt_mask_Reprojection(_e591.pixel, _e614, _e591.has_moved);
                    if _e614 {
                        phi_710_ = false;
                    } else {
                        phi_710_ = true;
                    }
                    let _e620 = phi_710_;
                    phi_712_ = _e618;
                    phi_713_ = _e618;
                    phi_714_ = lt_mask_Reprojection();
                    phi_715_ = _e614;
                    phi_716_ = _e620;
                } else {
                    phi_712_ = lt_mask_Reprojection();
                    phi_713_ = lt_mask_Reprojection();
                    phi_714_ = lt_mask_Reprojection(_e591.pixel, false, _e591.has_moved);
                    phi_715_ = false;
                    phi_716_ = false;
                }
                let _e626 = phi_712_;
                let _e628 = phi_713_;
                let _e630 = phi_714_;
                let _e632 = phi_715_;
                let _e634 = phi_716_;
                phi_717_ = _e626;
                phi_718_ = _e628;
                phi_719_ = _e630;
                phi_720_ = _e632;
                phi_721_ = _e634;
            }
            let _e636 = phi_717_;
            let _e638 = phi_718_;
            let _e640 = phi_719_;
            let _e642 = phi_720_;
            let _e644 = phi_721_;
            if _e642 {
                let _e647 = p.member.previous.eye;
                let _e658 = p.member.previous.forward;
                let _e666 = ((((_e86.x - _e647.x) * _e658.x) + ((_e86.y - _e647.y) * _e658.y)) + ((_e86.z - _e647.z) * _e658.z));
                let _e672 = ((_e636.pixel.y * _e83) + _e636.pixel.x);
                if (_e672 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e676 = last_depths.member[(0u + _e672)];
                let _e678 = p.member.depth_tolerance;
                let _e681 = abs(_e666);
                let _e682 = abs(_e676);
                if ((bitcast<u32>(_e682) & 2147483647u) > 2139095040u) {
                    phi_776_ = true;
                } else {
                    let _e686 = (_e682 > _e681);
                    if _e686 {
                    }
                    phi_776_ = _e686;
                }
                let _e688 = phi_776_;
                if _e688 {
                    phi_780_ = _e682;
                } else {
                    phi_780_ = _e681;
                }
                let _e690 = phi_780_;
                phi_784_ = lt_mask_Reprojection(_e636.pixel, (abs((_e666 - _e676)) <= (_e678 * _e690)), _e636.has_moved);
                phi_785_ = true;
            } else {
                phi_784_ = _e638;
                phi_785_ = _e644;
            }
            let _e698 = phi_784_;
            let _e700 = phi_785_;
            if _e700 {
                if _e698.is_valid {
                    let _e703 = p.member.flags;
                    phi_797_ = ((_e703 & 1u) != 0u);
                    phi_798_ = false;
                } else {
                    phi_797_ = bool();
                    phi_798_ = true;
                }
                let _e707 = phi_797_;
                let _e709 = phi_798_;
                phi_799_ = _e707;
                phi_800_ = _e698;
                phi_801_ = _e709;
            } else {
                phi_799_ = bool();
                phi_800_ = _e640;
                phi_801_ = true;
            }
            let _e711 = phi_799_;
            let _e713 = phi_800_;
            let _e715 = phi_801_;
            if _e715 {
                phi_805_ = false;
                phi_806_ = _e713;
            } else {
                phi_805_ = _e711;
                phi_806_ = _e698;
            }
            let _e717 = phi_805_;
            let _e719 = phi_806_;
            let _e723 = lt_mask_Reprojection(_e719.pixel, _e717, _e719.has_moved);
            let _e724 = lt_mask_Neighbourhood(false, true);
            if _e250 {
                phi_812_ = false;
            } else {
                phi_812_ = true;
            }
            let _e726 = phi_812_;
            if _e726 {
                if _e717 {
                    if ((0u & 2u) != 0u) {
                        phi_873_ = _e724;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e735 = (_e83 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e83 % 32u) > 0u) {
                            phi_844_ = (_e735 + 1u);
                        } else {
                            phi_844_ = _e735;
                        }
                        let _e741 = phi_844_;
                        let _e751 = ((((_e723.pixel.y * _e741) + (_e723.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e246) | (select(0u, 1u, _e723.has_moved) << bitcast<u32>(1i))));
                        if (_e751 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e755 = heard.member[(0u + _e751)];
                        let _e761 = (((_e755 >> bitcast<u32>(((_e723.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_873_ = lt_mask_Neighbourhood(_e761, !(_e761));
                    }
                    let _e765 = phi_873_;
                    phi_874_ = _e765;
                } else {
                    phi_874_ = _e724;
                }
                let _e767 = phi_874_;
                phi_875_ = _e767;
            } else {
                phi_875_ = _e724;
            }
            let _e769 = phi_875_;
            let _e772 = p.member.frame;
            let _e774 = p.member.refresh;
            if (_e774 == 0u) {
                phi_908_ = false;
            } else {
                if (_e774 == 0u) {
                    return;
                }
                let _e783 = ((_e54.x + (_e54.y * (((_e774 * 5u) / 8u) | 1u))) + (_e772 % _e774));
                if (_e774 == 0u) {
                    phi_907_ = (_e783 == 0u);
                } else {
                    if (_e774 == 0u) {
                        return;
                    }
                    phi_907_ = ((_e783 % _e774) == 0u);
                }
                let _e790 = phi_907_;
                phi_908_ = _e790;
            }
            let _e792 = phi_908_;
            if _e717 {
                if _e792 {
                    phi_930_ = bool();
                } else {
                    phi_930_ = ((0u & 2u) != 0u);
                }
                let _e798 = phi_930_;
                phi_931_ = _e798;
                phi_932_ = _e792;
            } else {
                phi_931_ = bool();
                phi_932_ = true;
            }
            let _e800 = phi_931_;
            let _e802 = phi_932_;
            if _e802 {
                phi_936_ = false;
            } else {
                phi_936_ = _e800;
            }
            let _e804 = phi_936_;
            if _e804 {
                phi_987_ = 7u;
            } else {
                if (_e88 != 0.5f) {
                    if _e717 {
                        if _e792 {
                            phi_984_ = 6u;
                        } else {
                            if _e250 {
                                phi_959_ = true;
                            } else {
                                if _e769.any_expands {
                                    phi_958_ = false;
                                } else {
                                    phi_958_ = true;
                                }
                                let _e806 = phi_958_;
                                phi_959_ = _e806;
                            }
                            let _e808 = phi_959_;
                            if _e808 {
                                if _e250 {
                                    if false {
                                        if _e769.all_remove {
                                            phi_972_ = false;
                                        } else {
                                            phi_972_ = true;
                                        }
                                        let _e810 = phi_972_;
                                        phi_973_ = _e810;
                                    } else {
                                        phi_973_ = true;
                                    }
                                    let _e812 = phi_973_;
                                    phi_974_ = _e812;
                                } else {
                                    phi_974_ = true;
                                }
                                let _e814 = phi_974_;
                                if _e814 {
                                    if _e250 {
                                        phi_981_ = 1u;
                                    } else {
                                        phi_981_ = 0u;
                                    }
                                    let _e816 = phi_981_;
                                    phi_982_ = _e816;
                                } else {
                                    phi_982_ = 5u;
                                }
                                let _e818 = phi_982_;
                                phi_983_ = _e818;
                            } else {
                                phi_983_ = 4u;
                            }
                            let _e820 = phi_983_;
                            phi_984_ = _e820;
                        }
                        let _e822 = phi_984_;
                        phi_985_ = _e822;
                    } else {
                        phi_985_ = 3u;
                    }
                    let _e824 = phi_985_;
                    phi_986_ = _e824;
                } else {
                    phi_986_ = 2u;
                }
                let _e826 = phi_986_;
                phi_987_ = _e826;
            }
            let _e828 = phi_987_;
            if !((_e828 == 0u)) {
                if !((_e828 == 5u)) {
                    phi_999_ = !(_e804);
                    phi_1000_ = false;
                } else {
                    phi_999_ = bool();
                    phi_1000_ = true;
                }
                let _e835 = phi_999_;
                let _e837 = phi_1000_;
                phi_1001_ = _e835;
                phi_1002_ = _e837;
            } else {
                phi_1001_ = bool();
                phi_1002_ = true;
            }
            let _e839 = phi_1001_;
            let _e841 = phi_1002_;
            if _e841 {
                phi_1006_ = false;
            } else {
                phi_1006_ = _e839;
            }
            let _e843 = phi_1006_;
            if _e804 {
                phi_1012_ = ((0u & 4u) != 0u);
            } else {
                phi_1012_ = _e246;
            }
            let _e847 = phi_1012_;
            if _e843 {
                if _e246 {
                    phi_1020_ = (2u | 1u);
                } else {
                    phi_1020_ = 2u;
                }
                let _e850 = phi_1020_;
                if false {
                    phi_1025_ = (_e850 | 4u);
                } else {
                    phi_1025_ = _e850;
                }
                let _e853 = phi_1025_;
                phi_1045_ = _e853;
            } else {
                if (_e828 == 7u) {
                    if _e246 {
                        phi_1034_ = (2u | 1u);
                    } else {
                        phi_1034_ = 2u;
                    }
                    let _e857 = phi_1034_;
                    if _e847 {
                        phi_1039_ = (_e857 | 4u);
                    } else {
                        phi_1039_ = _e857;
                    }
                    let _e860 = phi_1039_;
                    phi_1044_ = _e860;
                } else {
                    if _e246 {
                        phi_1043_ = 1u;
                    } else {
                        phi_1043_ = 0u;
                    }
                    let _e862 = phi_1043_;
                    phi_1044_ = _e862;
                }
                let _e864 = phi_1044_;
                phi_1045_ = _e864;
            }
            let _e866 = phi_1045_;
            if _e847 {
                phi_1049_ = 0f;
            } else {
                phi_1049_ = 1f;
            }
            let _e868 = phi_1049_;
            if _e250 {
                if (_e88 == 0.99999994f) {
                    phi_1058_ = true;
                } else {
                    phi_1058_ = (_e88 == 0.000000059604645f);
                }
                let _e872 = phi_1058_;
                phi_1059_ = _e872;
            } else {
                phi_1059_ = true;
            }
            let _e874 = phi_1059_;
            phi_1061_ = mask_Masked(_e868, _e866, _e843, _e874);
        }
        let _e877 = phi_1061_;
        visibility.member[_e75.first_primitive] = _e877.visibility;
        let _e882 = p.member.light.number;
        let _e883 = (_e882 * 3u);
        let _e885 = (_e883 % 32u);
        let _e887 = p.member.light.mask_words;
        let _e889 = ((_e75.first_primitive * _e887) + (_e883 / 32u));
        let _e891 = bits.member[_e889];
        bits.member[_e889] = ((_e891 & ~((7u << bitcast<u32>((_e885 & 31u))))) | (_e877.bits << bitcast<u32>((_e885 & 31u))));
        if (_e885 > 29u) {
            let _e906 = bits.member[(_e889 + 1u)];
            let _e908 = (32u - _e885);
            bits.member[(_e889 + 1u)] = ((_e906 & ~((7u >> bitcast<u32>((_e908 & 31u))))) | (_e877.bits >> bitcast<u32>((_e908 & 31u))));
        }
        let _e923 = samples.member[_e75.first_primitive].normal[0u];
        let _e925 = global[0u];
        if (_e923 == _e925) {
            let _e928 = samples.member[_e75.first_primitive].normal[1u];
            let _e930 = global[1u];
            if (_e928 == _e930) {
                let _e933 = samples.member[_e75.first_primitive].normal[2u];
                let _e935 = global[2u];
                phi_1133_ = (_e933 == _e935);
                phi_1134_ = false;
            } else {
                phi_1133_ = bool();
                phi_1134_ = true;
            }
            let _e938 = phi_1133_;
            let _e940 = phi_1134_;
            phi_1135_ = _e938;
            phi_1136_ = _e940;
        } else {
            phi_1135_ = bool();
            phi_1136_ = true;
        }
        let _e942 = phi_1135_;
        let _e944 = phi_1136_;
        if _e944 {
            phi_1140_ = false;
        } else {
            phi_1140_ = _e942;
        }
        let _e946 = phi_1140_;
        if !(_e946) {
            let _e949 = samples.member[_e75.first_primitive].position;
            let _e951 = p.member.current.eye;
            let _e962 = p.member.current.forward;
            phi_1168_ = ((((_e949.x - _e951.x) * _e962.x) + ((_e949.y - _e951.y) * _e962.y)) + ((_e949.z - _e951.z) * _e962.z));
        } else {
            phi_1168_ = 0f;
        }
        let _e972 = phi_1168_;
        depths.member[_e75.first_primitive] = _e972;
        phi_1173_ = doubt_Listed(_e75.first_primitive, _e877.is_trusted);
        phi_1174_ = _e877.needs_ray;
    } else {
        phi_1173_ = doubt_Listed(0u, false);
        phi_1174_ = false;
    }
    let _e978 = phi_1173_;
    let _e980 = phi_1174_;
    if (_e55 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e980 {
        let _e986 = atomicAdd((&shared_[0u]), 1u);
        phi_1187_ = _e986;
    } else {
        phi_1187_ = 0u;
    }
    let _e988 = phi_1187_;
    workgroupBarrier();
    if (_e55 == 0u) {
        let _e992 = atomicLoad((&shared_[0u]));
        let _e993 = atomicAdd((&list.member[3u]), _e992);
        atomicStore((&shared_[1u]), _e993);
    }
    workgroupBarrier();
    if _e980 {
        if _e978.is_trusted {
            phi_1204_ = (_e978.pixel | 2147483648u);
        } else {
            phi_1204_ = _e978.pixel;
        }
        let _e997 = phi_1204_;
        let _e999 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e999) + _e988)]), _e997);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
