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
    var phi_555_: f32;
    var phi_560_: f32;
    var phi_561_: bool;
    var phi_562_: f32;
    var phi_563_: bool;
    var phi_567_: f32;
    var phi_588_: f32;
    var phi_593_: f32;
    var phi_594_: bool;
    var phi_595_: f32;
    var phi_596_: bool;
    var phi_600_: f32;
    var phi_621_: bool;
    var phi_640_: vec2<u32>;
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
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_658_: vec2<u32>;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_673_: bool;
    var phi_674_: bool;
    var phi_678_: bool;
    var phi_679_: bool;
    var phi_680_: vec2<u32>;
    var phi_715_: bool;
    var phi_717_: lt_mask_Reprojection;
    var phi_718_: lt_mask_Reprojection;
    var phi_719_: bool;
    var phi_723_: bool;
    var phi_724_: lt_mask_Reprojection;
    var phi_725_: lt_mask_Reprojection;
    var phi_726_: bool;
    var phi_734_: bool;
    var phi_735_: lt_mask_Reprojection;
    var phi_801_: u32;
    var phi_806_: u32;
    var phi_807_: u32;
    var phi_808_: u32;
    var phi_809_: bool;
    var phi_810_: u32;
    var phi_811_: bool;
    var phi_812_: bool;
    var phi_813_: u32;
    var phi_814_: bool;
    var phi_815_: bool;
    var phi_819_: bool;
    var phi_823_: u32;
    var phi_828_: bool;
    var phi_868_: lt_mask_Neighbourhood;
    var phi_869_: lt_mask_Neighbourhood;
    var phi_870_: lt_mask_Neighbourhood;
    var phi_902_: bool;
    var phi_903_: bool;
    var phi_925_: bool;
    var phi_926_: bool;
    var phi_927_: bool;
    var phi_931_: bool;
    var phi_953_: bool;
    var phi_954_: bool;
    var phi_967_: bool;
    var phi_968_: bool;
    var phi_969_: bool;
    var phi_976_: u32;
    var phi_977_: u32;
    var phi_978_: u32;
    var phi_979_: u32;
    var phi_980_: u32;
    var phi_981_: u32;
    var phi_982_: u32;
    var phi_994_: bool;
    var phi_995_: bool;
    var phi_996_: bool;
    var phi_997_: bool;
    var phi_1001_: bool;
    var phi_1007_: bool;
    var phi_1015_: u32;
    var phi_1020_: u32;
    var phi_1029_: u32;
    var phi_1034_: u32;
    var phi_1038_: u32;
    var phi_1039_: u32;
    var phi_1040_: u32;
    var phi_1044_: f32;
    var phi_1053_: bool;
    var phi_1054_: bool;
    var phi_1056_: mask_Masked;
    var phi_1108_: doubt_Listed;
    var phi_1109_: bool;
    var phi_1122_: u32;
    var phi_1139_: u32;

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
            phi_1056_ = mask_Masked(_e247.unnamed.visibility, 0u, false, false);
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
                phi_724_ = lt_mask_Reprojection(_e274.pixel, _e274.is_valid, false);
                phi_725_ = lt_mask_Reprojection();
                phi_726_ = true;
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
                let _e346 = (1f / (((_e331 * _e337.x) + (_e333 * _e337.y)) + (_e335 * _e337.z)));
                let _e348 = p.member.previous.right;
                let _e350 = p.member.previous.right;
                let _e362 = (1f / (((_e350.x * _e350.x) + (_e350.y * _e350.y)) + (_e350.z * _e350.z)));
                let _e370 = p.member.previous.up;
                let _e372 = p.member.previous.up;
                let _e384 = (1f / (((_e372.x * _e372.x) + (_e372.y * _e372.y)) + (_e372.z * _e372.z)));
                let _e406 = p.member.previous.size[0u];
                let _e413 = p.member.previous.size[1u];
                let _e417 = (((((((_e331 * (_e348.x * _e362)) + (_e333 * (_e348.y * _e362))) + (_e335 * (_e348.z * _e362))) * _e346) + 1f) * (0.5f * f32(_e406))) - _e324);
                let _e418 = (((1f - ((((_e331 * (_e370.x * _e384)) + (_e333 * (_e370.y * _e384))) + (_e335 * (_e370.z * _e384))) * _e346)) * (0.5f * f32(_e413))) - _e326);
                let _e422 = p.member.current.size[0u];
                let _e424 = p.member.current.size[1u];
                let _e426 = (_e324 + _e417);
                if (_e426 > -8388608f) {
                    let _e438 = f32(select(0i, select(select(i32(_e426), i32(-2147483648), (_e426 < bitcast<f32>(3472883712u))), 2147483647i, (_e426 > bitcast<f32>(1325400063u))), (_e426 == _e426)));
                    if (_e438 > _e426) {
                        phi_555_ = 1f;
                    } else {
                        phi_555_ = 0f;
                    }
                    let _e441 = phi_555_;
                    if (_e426 < 8388608f) {
                        phi_560_ = (_e438 - _e441);
                        phi_561_ = false;
                    } else {
                        phi_560_ = f32();
                        phi_561_ = true;
                    }
                    let _e444 = phi_560_;
                    let _e446 = phi_561_;
                    phi_562_ = _e444;
                    phi_563_ = _e446;
                } else {
                    phi_562_ = f32();
                    phi_563_ = true;
                }
                let _e448 = phi_562_;
                let _e450 = phi_563_;
                if _e450 {
                    phi_567_ = _e426;
                } else {
                    phi_567_ = _e448;
                }
                let _e452 = phi_567_;
                let _e453 = (_e326 + _e418);
                if (_e453 > -8388608f) {
                    let _e465 = f32(select(0i, select(select(i32(_e453), i32(-2147483648), (_e453 < bitcast<f32>(3472883712u))), 2147483647i, (_e453 > bitcast<f32>(1325400063u))), (_e453 == _e453)));
                    if (_e465 > _e453) {
                        phi_588_ = 1f;
                    } else {
                        phi_588_ = 0f;
                    }
                    let _e468 = phi_588_;
                    if (_e453 < 8388608f) {
                        phi_593_ = (_e465 - _e468);
                        phi_594_ = false;
                    } else {
                        phi_593_ = f32();
                        phi_594_ = true;
                    }
                    let _e471 = phi_593_;
                    let _e473 = phi_594_;
                    phi_595_ = _e471;
                    phi_596_ = _e473;
                } else {
                    phi_595_ = f32();
                    phi_596_ = true;
                }
                let _e475 = phi_595_;
                let _e477 = phi_596_;
                if _e477 {
                    phi_600_ = _e453;
                } else {
                    phi_600_ = _e475;
                }
                let _e479 = phi_600_;
                if (_e452 >= 0f) {
                    if (_e479 >= 0f) {
                        if (_e452 < f32(_e422)) {
                            let _e485 = (_e479 < f32(_e424));
                            if (_e417 == 0f) {
                                phi_621_ = (_e418 == 0f);
                            } else {
                                phi_621_ = false;
                            }
                            let _e489 = phi_621_;
                            if _e485 {
                                phi_640_ = vec2<u32>(select(select(u32(_e452), 0u, (_e452 < bitcast<f32>(0u))), 4294967295u, (_e452 > bitcast<f32>(1333788671u))), select(select(u32(_e479), 0u, (_e479 < bitcast<f32>(0u))), 4294967295u, (_e479 > bitcast<f32>(1333788671u))));
                                phi_641_ = false;
                            } else {
                                phi_640_ = vec2<u32>();
                                phi_641_ = true;
                            }
                            let _e506 = phi_640_;
                            let _e508 = phi_641_;
                            phi_642_ = _e489;
                            phi_643_ = _e485;
                            phi_644_ = _e506;
                            phi_645_ = _e489;
                            phi_646_ = _e485;
                            phi_647_ = false;
                            phi_648_ = _e508;
                        } else {
                            phi_642_ = bool();
                            phi_643_ = bool();
                            phi_644_ = vec2<u32>();
                            phi_645_ = bool();
                            phi_646_ = bool();
                            phi_647_ = true;
                            phi_648_ = false;
                        }
                        let _e510 = phi_642_;
                        let _e512 = phi_643_;
                        let _e514 = phi_644_;
                        let _e516 = phi_645_;
                        let _e518 = phi_646_;
                        let _e520 = phi_647_;
                        let _e522 = phi_648_;
                        phi_649_ = _e510;
                        phi_650_ = _e512;
                        phi_651_ = _e514;
                        phi_652_ = _e516;
                        phi_653_ = _e518;
                        phi_654_ = _e520;
                        phi_655_ = _e522;
                    } else {
                        phi_649_ = bool();
                        phi_650_ = bool();
                        phi_651_ = vec2<u32>();
                        phi_652_ = bool();
                        phi_653_ = bool();
                        phi_654_ = true;
                        phi_655_ = false;
                    }
                    let _e524 = phi_649_;
                    let _e526 = phi_650_;
                    let _e528 = phi_651_;
                    let _e530 = phi_652_;
                    let _e532 = phi_653_;
                    let _e534 = phi_654_;
                    let _e536 = phi_655_;
                    phi_656_ = _e524;
                    phi_657_ = _e526;
                    phi_658_ = _e528;
                    phi_659_ = _e530;
                    phi_660_ = _e532;
                    phi_661_ = _e534;
                    phi_662_ = _e536;
                } else {
                    phi_656_ = bool();
                    phi_657_ = bool();
                    phi_658_ = vec2<u32>();
                    phi_659_ = bool();
                    phi_660_ = bool();
                    phi_661_ = true;
                    phi_662_ = false;
                }
                let _e538 = phi_656_;
                let _e540 = phi_657_;
                let _e542 = phi_658_;
                let _e544 = phi_659_;
                let _e546 = phi_660_;
                let _e548 = phi_661_;
                let _e550 = phi_662_;
                if _e548 {
                    if (_e417 == 0f) {
                        phi_671_ = (_e418 == 0f);
                    } else {
                        phi_671_ = false;
                    }
                    let _e554 = phi_671_;
                    phi_672_ = _e554;
                    phi_673_ = false;
                    phi_674_ = true;
                } else {
                    phi_672_ = _e544;
                    phi_673_ = _e546;
                    phi_674_ = _e550;
                }
                let _e556 = phi_672_;
                let _e558 = phi_673_;
                let _e560 = phi_674_;
                if _e560 {
                    phi_678_ = _e556;
                    phi_679_ = _e558;
                    phi_680_ = vec2<u32>(_e52.x, _e52.y);
                } else {
                    phi_678_ = _e538;
                    phi_679_ = _e540;
                    phi_680_ = _e542;
                }
                let _e562 = phi_678_;
                let _e564 = phi_679_;
                let _e566 = phi_680_;
                let _e576 = lt_mask_Reprojection(vec2<u32>(_e566.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e583 = lt_mask_Reprojection(vec2<u32>(_e576.pixel.x, _e566.y), _e576.is_valid, _e576.has_moved);
                let _e587 = lt_mask_Reprojection(_e583.pixel, _e564, _e583.has_moved);
                let _e591 = lt_mask_Reprojection(_e587.pixel, _e587.is_valid, !(_e562));
                if _e564 {
                    let _e594 = p.member.previous.eye;
                    let _e602 = p.member.previous.forward;
                    let _e611 = (((((_e89.x - _e594.x) * _e602.x) + ((_e89.y - _e594.y) * _e602.y)) + ((_e89.z - _e594.z) * _e602.z)) > 0f);
                    let _e615 = lt_mask_Reprojection(_e591.pixel, _e611, _e591.has_moved);
                    if _e611 {
                        phi_715_ = false;
                    } else {
                        phi_715_ = true;
                    }
                    let _e617 = phi_715_;
                    phi_717_ = _e615;
                    phi_718_ = _e615;
                    phi_719_ = _e617;
                } else {
                    phi_717_ = lt_mask_Reprojection();
                    phi_718_ = lt_mask_Reprojection(_e591.pixel, false, _e591.has_moved);
                    phi_719_ = true;
                }
                let _e623 = phi_717_;
                let _e625 = phi_718_;
                let _e627 = phi_719_;
                if _e627 {
                    phi_723_ = false;
                } else {
                    phi_723_ = true;
                }
                let _e629 = phi_723_;
                phi_724_ = _e623;
                phi_725_ = _e625;
                phi_726_ = _e629;
            }
            let _e631 = phi_724_;
            let _e633 = phi_725_;
            let _e635 = phi_726_;
            if _e635 {
                let _e637 = p.member.flags;
                phi_734_ = ((_e637 & 1u) != 0u);
                phi_735_ = _e631;
            } else {
                phi_734_ = false;
                phi_735_ = _e633;
            }
            let _e641 = phi_734_;
            let _e643 = phi_735_;
            let _e647 = lt_mask_Reprojection(_e643.pixel, _e641, _e643.has_moved);
            let _e649 = p.member.flags;
            let _e651 = ((_e649 & 2u) != 0u);
            let _e653 = p.member.flags;
            if ((_e653 & 4u) == 0u) {
                phi_813_ = u32();
                phi_814_ = true;
                phi_815_ = false;
            } else {
                if _e641 {
                    if !(_e647.has_moved) {
                        let _e662 = ((((_e52.y * _e86) + (_e52.x / 32u)) * 6u) + 4u);
                        if (_e662 < _e58) {
                        } else {
                            return;
                        }
                        let _e666 = heard.member[(0u + _e662)];
                        if (((_e666 >> bitcast<u32>(((_e52.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e677 = ((((_e52.y * _e86) + (_e52.x / 32u)) * 6u) + 5u);
                            if (_e677 < _e58) {
                            } else {
                                return;
                            }
                            let _e681 = heard.member[(0u + _e677)];
                            if false {
                                phi_801_ = (2u | 1u);
                            } else {
                                phi_801_ = 2u;
                            }
                            let _e690 = phi_801_;
                            if (((_e681 >> bitcast<u32>(((_e52.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_806_ = (_e690 | 4u);
                            } else {
                                phi_806_ = _e690;
                            }
                            let _e693 = phi_806_;
                            phi_807_ = _e693;
                        } else {
                            phi_807_ = 0u;
                        }
                        let _e695 = phi_807_;
                        phi_808_ = _e695;
                        phi_809_ = false;
                    } else {
                        phi_808_ = u32();
                        phi_809_ = true;
                    }
                    let _e697 = phi_808_;
                    let _e699 = phi_809_;
                    phi_810_ = _e697;
                    phi_811_ = false;
                    phi_812_ = _e699;
                } else {
                    phi_810_ = u32();
                    phi_811_ = true;
                    phi_812_ = false;
                }
                let _e701 = phi_810_;
                let _e703 = phi_811_;
                let _e705 = phi_812_;
                phi_813_ = _e701;
                phi_814_ = _e703;
                phi_815_ = _e705;
            }
            let _e707 = phi_813_;
            let _e709 = phi_814_;
            let _e711 = phi_815_;
            if _e709 {
                phi_819_ = true;
            } else {
                phi_819_ = _e711;
            }
            let _e713 = phi_819_;
            if _e713 {
                phi_823_ = 0u;
            } else {
                phi_823_ = _e707;
            }
            let _e715 = phi_823_;
            let _e716 = lt_mask_Neighbourhood(false, true);
            if _e256 {
                phi_828_ = _e651;
            } else {
                phi_828_ = false;
            }
            let _e718 = phi_828_;
            if _e718 {
                if _e641 {
                    if ((_e715 & 2u) != 0u) {
                        phi_868_ = _e716;
                    } else {
                        let _e735 = ((((_e647.pixel.y * _e86) + (_e647.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e252) | (select(0u, 1u, _e647.has_moved) << bitcast<u32>(1i))));
                        if (_e735 < _e58) {
                        } else {
                            return;
                        }
                        let _e739 = heard.member[(0u + _e735)];
                        let _e745 = (((_e739 >> bitcast<u32>(((_e647.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_868_ = lt_mask_Neighbourhood(_e745, !(_e745));
                    }
                    let _e749 = phi_868_;
                    phi_869_ = _e749;
                } else {
                    phi_869_ = _e716;
                }
                let _e751 = phi_869_;
                phi_870_ = _e751;
            } else {
                phi_870_ = _e716;
            }
            let _e753 = phi_870_;
            let _e756 = p.member.frame;
            let _e758 = p.member.refresh;
            if (_e758 == 0u) {
                phi_903_ = false;
            } else {
                if (_e758 == 0u) {
                    return;
                }
                let _e767 = ((_e52.x + (_e52.y * (((_e758 * 5u) / 8u) | 1u))) + (_e756 % _e758));
                if (_e758 == 0u) {
                    phi_902_ = (_e767 == 0u);
                } else {
                    if (_e758 == 0u) {
                        return;
                    }
                    phi_902_ = ((_e767 % _e758) == 0u);
                }
                let _e774 = phi_902_;
                phi_903_ = _e774;
            }
            let _e776 = phi_903_;
            if _e641 {
                if _e776 {
                    phi_925_ = bool();
                } else {
                    phi_925_ = ((_e715 & 2u) != 0u);
                }
                let _e782 = phi_925_;
                phi_926_ = _e782;
                phi_927_ = _e776;
            } else {
                phi_926_ = bool();
                phi_927_ = true;
            }
            let _e784 = phi_926_;
            let _e786 = phi_927_;
            if _e786 {
                phi_931_ = false;
            } else {
                phi_931_ = _e784;
            }
            let _e788 = phi_931_;
            if _e788 {
                phi_982_ = 7u;
            } else {
                if (_e94 != 0.5f) {
                    if _e641 {
                        if _e776 {
                            phi_979_ = 6u;
                        } else {
                            if _e256 {
                                phi_954_ = true;
                            } else {
                                if _e753.any_expands {
                                    phi_953_ = false;
                                } else {
                                    phi_953_ = true;
                                }
                                let _e790 = phi_953_;
                                phi_954_ = _e790;
                            }
                            let _e792 = phi_954_;
                            if _e792 {
                                if _e256 {
                                    if _e651 {
                                        if _e753.all_remove {
                                            phi_967_ = false;
                                        } else {
                                            phi_967_ = true;
                                        }
                                        let _e794 = phi_967_;
                                        phi_968_ = _e794;
                                    } else {
                                        phi_968_ = true;
                                    }
                                    let _e796 = phi_968_;
                                    phi_969_ = _e796;
                                } else {
                                    phi_969_ = true;
                                }
                                let _e798 = phi_969_;
                                if _e798 {
                                    if _e256 {
                                        phi_976_ = 1u;
                                    } else {
                                        phi_976_ = 0u;
                                    }
                                    let _e800 = phi_976_;
                                    phi_977_ = _e800;
                                } else {
                                    phi_977_ = 5u;
                                }
                                let _e802 = phi_977_;
                                phi_978_ = _e802;
                            } else {
                                phi_978_ = 4u;
                            }
                            let _e804 = phi_978_;
                            phi_979_ = _e804;
                        }
                        let _e806 = phi_979_;
                        phi_980_ = _e806;
                    } else {
                        phi_980_ = 3u;
                    }
                    let _e808 = phi_980_;
                    phi_981_ = _e808;
                } else {
                    phi_981_ = 2u;
                }
                let _e810 = phi_981_;
                phi_982_ = _e810;
            }
            let _e812 = phi_982_;
            if !((_e812 == 0u)) {
                if !((_e812 == 5u)) {
                    phi_994_ = !(_e788);
                    phi_995_ = false;
                } else {
                    phi_994_ = bool();
                    phi_995_ = true;
                }
                let _e819 = phi_994_;
                let _e821 = phi_995_;
                phi_996_ = _e819;
                phi_997_ = _e821;
            } else {
                phi_996_ = bool();
                phi_997_ = true;
            }
            let _e823 = phi_996_;
            let _e825 = phi_997_;
            if _e825 {
                phi_1001_ = false;
            } else {
                phi_1001_ = _e823;
            }
            let _e827 = phi_1001_;
            if _e788 {
                phi_1007_ = ((_e715 & 4u) != 0u);
            } else {
                phi_1007_ = _e252;
            }
            let _e831 = phi_1007_;
            if _e827 {
                if _e252 {
                    phi_1015_ = (2u | 1u);
                } else {
                    phi_1015_ = 2u;
                }
                let _e834 = phi_1015_;
                if false {
                    phi_1020_ = (_e834 | 4u);
                } else {
                    phi_1020_ = _e834;
                }
                let _e837 = phi_1020_;
                phi_1040_ = _e837;
            } else {
                if (_e812 == 7u) {
                    if _e252 {
                        phi_1029_ = (2u | 1u);
                    } else {
                        phi_1029_ = 2u;
                    }
                    let _e841 = phi_1029_;
                    if _e831 {
                        phi_1034_ = (_e841 | 4u);
                    } else {
                        phi_1034_ = _e841;
                    }
                    let _e844 = phi_1034_;
                    phi_1039_ = _e844;
                } else {
                    if _e252 {
                        phi_1038_ = 1u;
                    } else {
                        phi_1038_ = 0u;
                    }
                    let _e846 = phi_1038_;
                    phi_1039_ = _e846;
                }
                let _e848 = phi_1039_;
                phi_1040_ = _e848;
            }
            let _e850 = phi_1040_;
            if _e831 {
                phi_1044_ = 0f;
            } else {
                phi_1044_ = 1f;
            }
            let _e852 = phi_1044_;
            if _e256 {
                if (_e94 == 0.99999994f) {
                    phi_1053_ = true;
                } else {
                    phi_1053_ = (_e94 == 0.000000059604645f);
                }
                let _e856 = phi_1053_;
                phi_1054_ = _e856;
            } else {
                phi_1054_ = true;
            }
            let _e858 = phi_1054_;
            phi_1056_ = mask_Masked(_e852, _e850, _e827, _e858);
        }
        let _e861 = phi_1056_;
        visibility.member[_e70.first_primitive] = _e861.visibility;
        let _e866 = p.member.light.number;
        let _e867 = (_e866 * 3u);
        let _e869 = (_e867 % 32u);
        let _e871 = p.member.light.mask_words;
        let _e873 = ((_e70.first_primitive * _e871) + (_e867 / 32u));
        let _e875 = bits.member[_e873];
        bits.member[_e873] = ((_e875 & ~((7u << bitcast<u32>((_e869 & 31u))))) | (_e861.bits << bitcast<u32>((_e869 & 31u))));
        if (_e869 > 29u) {
            let _e890 = bits.member[(_e873 + 1u)];
            let _e892 = (32u - _e869);
            bits.member[(_e873 + 1u)] = ((_e890 & ~((7u >> bitcast<u32>((_e892 & 31u))))) | (_e861.bits >> bitcast<u32>((_e892 & 31u))));
        }
        phi_1108_ = doubt_Listed(_e70.first_primitive, _e861.is_trusted);
        phi_1109_ = _e861.needs_ray;
    } else {
        phi_1108_ = doubt_Listed(0u, false);
        phi_1109_ = false;
    }
    let _e908 = phi_1108_;
    let _e910 = phi_1109_;
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e910 {
        let _e916 = atomicAdd((&shared_[0u]), 1u);
        phi_1122_ = _e916;
    } else {
        phi_1122_ = 0u;
    }
    let _e918 = phi_1122_;
    workgroupBarrier();
    if (_e53 == 0u) {
        let _e922 = atomicLoad((&shared_[0u]));
        let _e923 = atomicAdd((&list.member[3u]), _e922);
        atomicStore((&shared_[1u]), _e923);
    }
    workgroupBarrier();
    if _e910 {
        if _e908.is_trusted {
            phi_1139_ = (_e908.pixel | 2147483648u);
        } else {
            phi_1139_ = _e908.pixel;
        }
        let _e927 = phi_1139_;
        let _e929 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e929) + _e918)]), _e927);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
