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
    var phi_552_: f32;
    var phi_557_: f32;
    var phi_558_: bool;
    var phi_559_: f32;
    var phi_560_: bool;
    var phi_564_: f32;
    var phi_585_: f32;
    var phi_590_: f32;
    var phi_591_: bool;
    var phi_592_: f32;
    var phi_593_: bool;
    var phi_597_: f32;
    var phi_618_: bool;
    var phi_637_: vec2<u32>;
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
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_655_: vec2<u32>;
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_668_: bool;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_671_: bool;
    var phi_675_: bool;
    var phi_676_: bool;
    var phi_677_: vec2<u32>;
    var phi_712_: bool;
    var phi_714_: lt_mask_Reprojection;
    var phi_715_: lt_mask_Reprojection;
    var phi_716_: lt_mask_Reprojection;
    var phi_717_: bool;
    var phi_718_: bool;
    var phi_719_: lt_mask_Reprojection;
    var phi_720_: lt_mask_Reprojection;
    var phi_721_: lt_mask_Reprojection;
    var phi_722_: bool;
    var phi_723_: bool;
    var phi_775_: bool;
    var phi_779_: f32;
    var phi_783_: lt_mask_Reprojection;
    var phi_784_: bool;
    var phi_796_: bool;
    var phi_797_: bool;
    var phi_798_: bool;
    var phi_799_: lt_mask_Reprojection;
    var phi_800_: bool;
    var phi_804_: bool;
    var phi_805_: lt_mask_Reprojection;
    var phi_843_: u32;
    var phi_892_: u32;
    var phi_897_: u32;
    var phi_898_: u32;
    var phi_899_: u32;
    var phi_900_: bool;
    var phi_901_: u32;
    var phi_902_: bool;
    var phi_903_: bool;
    var phi_904_: u32;
    var phi_905_: bool;
    var phi_906_: bool;
    var phi_910_: bool;
    var phi_914_: u32;
    var phi_919_: bool;
    var phi_951_: u32;
    var phi_980_: lt_mask_Neighbourhood;
    var phi_981_: lt_mask_Neighbourhood;
    var phi_982_: lt_mask_Neighbourhood;
    var phi_1014_: bool;
    var phi_1015_: bool;
    var phi_1037_: bool;
    var phi_1038_: bool;
    var phi_1039_: bool;
    var phi_1043_: bool;
    var phi_1065_: bool;
    var phi_1066_: bool;
    var phi_1079_: bool;
    var phi_1080_: bool;
    var phi_1081_: bool;
    var phi_1088_: u32;
    var phi_1089_: u32;
    var phi_1090_: u32;
    var phi_1091_: u32;
    var phi_1092_: u32;
    var phi_1093_: u32;
    var phi_1094_: u32;
    var phi_1106_: bool;
    var phi_1107_: bool;
    var phi_1108_: bool;
    var phi_1109_: bool;
    var phi_1113_: bool;
    var phi_1119_: bool;
    var phi_1127_: u32;
    var phi_1132_: u32;
    var phi_1141_: u32;
    var phi_1146_: u32;
    var phi_1150_: u32;
    var phi_1151_: u32;
    var phi_1152_: u32;
    var phi_1156_: f32;
    var phi_1165_: bool;
    var phi_1166_: bool;
    var phi_1168_: mask_Masked;
    var phi_1240_: bool;
    var phi_1241_: bool;
    var phi_1242_: bool;
    var phi_1243_: bool;
    var phi_1247_: bool;
    var phi_1275_: f32;
    var phi_1280_: doubt_Listed;
    var phi_1281_: bool;
    var phi_1294_: u32;
    var phi_1311_: u32;

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
            phi_1168_ = mask_Masked(_e247.unnamed.visibility, 0u, false, false);
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
                phi_719_ = lt_mask_Reprojection(_e274.pixel, _e274.is_valid, false);
                phi_720_ = lt_mask_Reprojection();
                phi_721_ = lt_mask_Reprojection();
                phi_722_ = true;
                phi_723_ = false;
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
                        phi_552_ = 1f;
                    } else {
                        phi_552_ = 0f;
                    }
                    let _e441 = phi_552_;
                    if (_e426 < 8388608f) {
                        phi_557_ = (_e438 - _e441);
                        phi_558_ = false;
                    } else {
                        phi_557_ = f32();
                        phi_558_ = true;
                    }
                    let _e444 = phi_557_;
                    let _e446 = phi_558_;
                    phi_559_ = _e444;
                    phi_560_ = _e446;
                } else {
                    phi_559_ = f32();
                    phi_560_ = true;
                }
                let _e448 = phi_559_;
                let _e450 = phi_560_;
                if _e450 {
                    phi_564_ = _e426;
                } else {
                    phi_564_ = _e448;
                }
                let _e452 = phi_564_;
                let _e453 = (_e326 + _e418);
                if (_e453 > -8388608f) {
                    let _e465 = f32(select(0i, select(select(i32(_e453), i32(-2147483648), (_e453 < bitcast<f32>(3472883712u))), 2147483647i, (_e453 > bitcast<f32>(1325400063u))), (_e453 == _e453)));
                    if (_e465 > _e453) {
                        phi_585_ = 1f;
                    } else {
                        phi_585_ = 0f;
                    }
                    let _e468 = phi_585_;
                    if (_e453 < 8388608f) {
                        phi_590_ = (_e465 - _e468);
                        phi_591_ = false;
                    } else {
                        phi_590_ = f32();
                        phi_591_ = true;
                    }
                    let _e471 = phi_590_;
                    let _e473 = phi_591_;
                    phi_592_ = _e471;
                    phi_593_ = _e473;
                } else {
                    phi_592_ = f32();
                    phi_593_ = true;
                }
                let _e475 = phi_592_;
                let _e477 = phi_593_;
                if _e477 {
                    phi_597_ = _e453;
                } else {
                    phi_597_ = _e475;
                }
                let _e479 = phi_597_;
                if (_e452 >= 0f) {
                    if (_e479 >= 0f) {
                        if (_e452 < f32(_e422)) {
                            let _e485 = (_e479 < f32(_e424));
                            if (_e417 == 0f) {
                                phi_618_ = (_e418 == 0f);
                            } else {
                                phi_618_ = false;
                            }
                            let _e489 = phi_618_;
                            if _e485 {
                                phi_637_ = vec2<u32>(select(select(u32(_e452), 0u, (_e452 < bitcast<f32>(0u))), 4294967295u, (_e452 > bitcast<f32>(1333788671u))), select(select(u32(_e479), 0u, (_e479 < bitcast<f32>(0u))), 4294967295u, (_e479 > bitcast<f32>(1333788671u))));
                                phi_638_ = false;
                            } else {
                                phi_637_ = vec2<u32>();
                                phi_638_ = true;
                            }
                            let _e506 = phi_637_;
                            let _e508 = phi_638_;
                            phi_639_ = _e489;
                            phi_640_ = _e485;
                            phi_641_ = _e506;
                            phi_642_ = _e489;
                            phi_643_ = _e485;
                            phi_644_ = false;
                            phi_645_ = _e508;
                        } else {
                            phi_639_ = bool();
                            phi_640_ = bool();
                            phi_641_ = vec2<u32>();
                            phi_642_ = bool();
                            phi_643_ = bool();
                            phi_644_ = true;
                            phi_645_ = false;
                        }
                        let _e510 = phi_639_;
                        let _e512 = phi_640_;
                        let _e514 = phi_641_;
                        let _e516 = phi_642_;
                        let _e518 = phi_643_;
                        let _e520 = phi_644_;
                        let _e522 = phi_645_;
                        phi_646_ = _e510;
                        phi_647_ = _e512;
                        phi_648_ = _e514;
                        phi_649_ = _e516;
                        phi_650_ = _e518;
                        phi_651_ = _e520;
                        phi_652_ = _e522;
                    } else {
                        phi_646_ = bool();
                        phi_647_ = bool();
                        phi_648_ = vec2<u32>();
                        phi_649_ = bool();
                        phi_650_ = bool();
                        phi_651_ = true;
                        phi_652_ = false;
                    }
                    let _e524 = phi_646_;
                    let _e526 = phi_647_;
                    let _e528 = phi_648_;
                    let _e530 = phi_649_;
                    let _e532 = phi_650_;
                    let _e534 = phi_651_;
                    let _e536 = phi_652_;
                    phi_653_ = _e524;
                    phi_654_ = _e526;
                    phi_655_ = _e528;
                    phi_656_ = _e530;
                    phi_657_ = _e532;
                    phi_658_ = _e534;
                    phi_659_ = _e536;
                } else {
                    phi_653_ = bool();
                    phi_654_ = bool();
                    phi_655_ = vec2<u32>();
                    phi_656_ = bool();
                    phi_657_ = bool();
                    phi_658_ = true;
                    phi_659_ = false;
                }
                let _e538 = phi_653_;
                let _e540 = phi_654_;
                let _e542 = phi_655_;
                let _e544 = phi_656_;
                let _e546 = phi_657_;
                let _e548 = phi_658_;
                let _e550 = phi_659_;
                if _e548 {
                    if (_e417 == 0f) {
                        phi_668_ = (_e418 == 0f);
                    } else {
                        phi_668_ = false;
                    }
                    let _e554 = phi_668_;
                    phi_669_ = _e554;
                    phi_670_ = false;
                    phi_671_ = true;
                } else {
                    phi_669_ = _e544;
                    phi_670_ = _e546;
                    phi_671_ = _e550;
                }
                let _e556 = phi_669_;
                let _e558 = phi_670_;
                let _e560 = phi_671_;
                if _e560 {
                    phi_675_ = _e556;
                    phi_676_ = _e558;
                    phi_677_ = vec2<u32>(_e56.x, _e56.y);
                } else {
                    phi_675_ = _e538;
                    phi_676_ = _e540;
                    phi_677_ = _e542;
                }
                let _e562 = phi_675_;
                let _e564 = phi_676_;
                let _e566 = phi_677_;
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
                        phi_712_ = false;
                    } else {
                        phi_712_ = true;
                    }
                    let _e617 = phi_712_;
                    phi_714_ = _e615;
                    phi_715_ = _e615;
                    phi_716_ = lt_mask_Reprojection();
                    phi_717_ = _e611;
                    phi_718_ = _e617;
                } else {
                    phi_714_ = lt_mask_Reprojection();
                    phi_715_ = lt_mask_Reprojection();
                    phi_716_ = lt_mask_Reprojection(_e591.pixel, false, _e591.has_moved);
                    phi_717_ = false;
                    phi_718_ = false;
                }
                let _e623 = phi_714_;
                let _e625 = phi_715_;
                let _e627 = phi_716_;
                let _e629 = phi_717_;
                let _e631 = phi_718_;
                phi_719_ = _e623;
                phi_720_ = _e625;
                phi_721_ = _e627;
                phi_722_ = _e629;
                phi_723_ = _e631;
            }
            let _e633 = phi_719_;
            let _e635 = phi_720_;
            let _e637 = phi_721_;
            let _e639 = phi_722_;
            let _e641 = phi_723_;
            if _e639 {
                let _e644 = p.member.previous.eye;
                let _e652 = p.member.previous.forward;
                let _e660 = ((((_e89.x - _e644.x) * _e652.x) + ((_e89.y - _e644.y) * _e652.y)) + ((_e89.z - _e644.z) * _e652.z));
                let _e666 = ((_e633.pixel.y * _e86) + _e633.pixel.x);
                if (_e666 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e670 = last_depths.member[(0u + _e666)];
                let _e672 = p.member.depth_tolerance;
                let _e675 = abs(_e660);
                let _e676 = abs(_e670);
                if ((bitcast<u32>(_e676) & 2147483647u) > 2139095040u) {
                    phi_775_ = true;
                } else {
                    let _e680 = (_e676 > _e675);
                    if _e680 {
                    }
                    phi_775_ = _e680;
                }
                let _e682 = phi_775_;
                if _e682 {
                    phi_779_ = _e676;
                } else {
                    phi_779_ = _e675;
                }
                let _e684 = phi_779_;
                phi_783_ = lt_mask_Reprojection(_e633.pixel, (abs((_e660 - _e670)) <= (_e672 * _e684)), _e633.has_moved);
                phi_784_ = true;
            } else {
                phi_783_ = _e635;
                phi_784_ = _e641;
            }
            let _e692 = phi_783_;
            let _e694 = phi_784_;
            if _e694 {
                if _e692.is_valid {
                    let _e697 = p.member.flags;
                    phi_796_ = ((_e697 & 1u) != 0u);
                    phi_797_ = false;
                } else {
                    phi_796_ = bool();
                    phi_797_ = true;
                }
                let _e701 = phi_796_;
                let _e703 = phi_797_;
                phi_798_ = _e701;
                phi_799_ = _e692;
                phi_800_ = _e703;
            } else {
                phi_798_ = bool();
                phi_799_ = _e637;
                phi_800_ = true;
            }
            let _e705 = phi_798_;
            let _e707 = phi_799_;
            let _e709 = phi_800_;
            if _e709 {
                phi_804_ = false;
                phi_805_ = _e707;
            } else {
                phi_804_ = _e705;
                phi_805_ = _e692;
            }
            let _e711 = phi_804_;
            let _e713 = phi_805_;
            let _e717 = lt_mask_Reprojection(_e713.pixel, _e711, _e713.has_moved);
            let _e719 = p.member.flags;
            let _e721 = ((_e719 & 2u) != 0u);
            let _e723 = p.member.flags;
            if ((_e723 & 4u) == 0u) {
                phi_904_ = u32();
                phi_905_ = true;
                phi_906_ = false;
            } else {
                if _e711 {
                    if !(_e717.has_moved) {
                        if (32u == 0u) {
                            return;
                        }
                        let _e729 = (_e86 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e86 % 32u) > 0u) {
                            phi_843_ = (_e729 + 1u);
                        } else {
                            phi_843_ = _e729;
                        }
                        let _e735 = phi_843_;
                        let _e740 = ((((_e56.y * _e735) + (_e56.x / 32u)) * 6u) + 4u);
                        if (_e740 < _e62) {
                        } else {
                            return;
                        }
                        let _e744 = heard.member[(0u + _e740)];
                        if (((_e744 >> bitcast<u32>(((_e56.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e755 = ((((_e56.y * _e735) + (_e56.x / 32u)) * 6u) + 5u);
                            if (_e755 < _e62) {
                            } else {
                                return;
                            }
                            let _e759 = heard.member[(0u + _e755)];
                            if false {
                                phi_892_ = (2u | 1u);
                            } else {
                                phi_892_ = 2u;
                            }
                            let _e768 = phi_892_;
                            if (((_e759 >> bitcast<u32>(((_e56.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_897_ = (_e768 | 4u);
                            } else {
                                phi_897_ = _e768;
                            }
                            let _e771 = phi_897_;
                            phi_898_ = _e771;
                        } else {
                            phi_898_ = 0u;
                        }
                        let _e773 = phi_898_;
                        phi_899_ = _e773;
                        phi_900_ = false;
                    } else {
                        phi_899_ = u32();
                        phi_900_ = true;
                    }
                    let _e775 = phi_899_;
                    let _e777 = phi_900_;
                    phi_901_ = _e775;
                    phi_902_ = false;
                    phi_903_ = _e777;
                } else {
                    phi_901_ = u32();
                    phi_902_ = true;
                    phi_903_ = false;
                }
                let _e779 = phi_901_;
                let _e781 = phi_902_;
                let _e783 = phi_903_;
                phi_904_ = _e779;
                phi_905_ = _e781;
                phi_906_ = _e783;
            }
            let _e785 = phi_904_;
            let _e787 = phi_905_;
            let _e789 = phi_906_;
            if _e787 {
                phi_910_ = true;
            } else {
                phi_910_ = _e789;
            }
            let _e791 = phi_910_;
            if _e791 {
                phi_914_ = 0u;
            } else {
                phi_914_ = _e785;
            }
            let _e793 = phi_914_;
            let _e794 = lt_mask_Neighbourhood(false, true);
            if _e256 {
                phi_919_ = _e721;
            } else {
                phi_919_ = true;
            }
            let _e796 = phi_919_;
            if _e796 {
                if _e711 {
                    if ((_e793 & 2u) != 0u) {
                        phi_980_ = _e794;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e805 = (_e86 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e86 % 32u) > 0u) {
                            phi_951_ = (_e805 + 1u);
                        } else {
                            phi_951_ = _e805;
                        }
                        let _e811 = phi_951_;
                        let _e821 = ((((_e717.pixel.y * _e811) + (_e717.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e252) | (select(0u, 1u, _e717.has_moved) << bitcast<u32>(1i))));
                        if (_e821 < _e62) {
                        } else {
                            return;
                        }
                        let _e825 = heard.member[(0u + _e821)];
                        let _e831 = (((_e825 >> bitcast<u32>(((_e717.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_980_ = lt_mask_Neighbourhood(_e831, !(_e831));
                    }
                    let _e835 = phi_980_;
                    phi_981_ = _e835;
                } else {
                    phi_981_ = _e794;
                }
                let _e837 = phi_981_;
                phi_982_ = _e837;
            } else {
                phi_982_ = _e794;
            }
            let _e839 = phi_982_;
            let _e842 = p.member.frame;
            let _e844 = p.member.refresh;
            if (_e844 == 0u) {
                phi_1015_ = false;
            } else {
                if (_e844 == 0u) {
                    return;
                }
                let _e853 = ((_e56.x + (_e56.y * (((_e844 * 5u) / 8u) | 1u))) + (_e842 % _e844));
                if (_e844 == 0u) {
                    phi_1014_ = (_e853 == 0u);
                } else {
                    if (_e844 == 0u) {
                        return;
                    }
                    phi_1014_ = ((_e853 % _e844) == 0u);
                }
                let _e860 = phi_1014_;
                phi_1015_ = _e860;
            }
            let _e862 = phi_1015_;
            if _e711 {
                if _e862 {
                    phi_1037_ = bool();
                } else {
                    phi_1037_ = ((_e793 & 2u) != 0u);
                }
                let _e868 = phi_1037_;
                phi_1038_ = _e868;
                phi_1039_ = _e862;
            } else {
                phi_1038_ = bool();
                phi_1039_ = true;
            }
            let _e870 = phi_1038_;
            let _e872 = phi_1039_;
            if _e872 {
                phi_1043_ = false;
            } else {
                phi_1043_ = _e870;
            }
            let _e874 = phi_1043_;
            if _e874 {
                phi_1094_ = 7u;
            } else {
                if (_e94 != 0.5f) {
                    if _e711 {
                        if _e862 {
                            phi_1091_ = 6u;
                        } else {
                            if _e256 {
                                phi_1066_ = true;
                            } else {
                                if _e839.any_expands {
                                    phi_1065_ = false;
                                } else {
                                    phi_1065_ = true;
                                }
                                let _e876 = phi_1065_;
                                phi_1066_ = _e876;
                            }
                            let _e878 = phi_1066_;
                            if _e878 {
                                if _e256 {
                                    if _e721 {
                                        if _e839.all_remove {
                                            phi_1079_ = false;
                                        } else {
                                            phi_1079_ = true;
                                        }
                                        let _e880 = phi_1079_;
                                        phi_1080_ = _e880;
                                    } else {
                                        phi_1080_ = true;
                                    }
                                    let _e882 = phi_1080_;
                                    phi_1081_ = _e882;
                                } else {
                                    phi_1081_ = true;
                                }
                                let _e884 = phi_1081_;
                                if _e884 {
                                    if _e256 {
                                        phi_1088_ = 1u;
                                    } else {
                                        phi_1088_ = 0u;
                                    }
                                    let _e886 = phi_1088_;
                                    phi_1089_ = _e886;
                                } else {
                                    phi_1089_ = 5u;
                                }
                                let _e888 = phi_1089_;
                                phi_1090_ = _e888;
                            } else {
                                phi_1090_ = 4u;
                            }
                            let _e890 = phi_1090_;
                            phi_1091_ = _e890;
                        }
                        let _e892 = phi_1091_;
                        phi_1092_ = _e892;
                    } else {
                        phi_1092_ = 3u;
                    }
                    let _e894 = phi_1092_;
                    phi_1093_ = _e894;
                } else {
                    phi_1093_ = 2u;
                }
                let _e896 = phi_1093_;
                phi_1094_ = _e896;
            }
            let _e898 = phi_1094_;
            if !((_e898 == 0u)) {
                if !((_e898 == 5u)) {
                    phi_1106_ = !(_e874);
                    phi_1107_ = false;
                } else {
                    phi_1106_ = bool();
                    phi_1107_ = true;
                }
                let _e905 = phi_1106_;
                let _e907 = phi_1107_;
                phi_1108_ = _e905;
                phi_1109_ = _e907;
            } else {
                phi_1108_ = bool();
                phi_1109_ = true;
            }
            let _e909 = phi_1108_;
            let _e911 = phi_1109_;
            if _e911 {
                phi_1113_ = false;
            } else {
                phi_1113_ = _e909;
            }
            let _e913 = phi_1113_;
            if _e874 {
                phi_1119_ = ((_e793 & 4u) != 0u);
            } else {
                phi_1119_ = _e252;
            }
            let _e917 = phi_1119_;
            if _e913 {
                if _e252 {
                    phi_1127_ = (2u | 1u);
                } else {
                    phi_1127_ = 2u;
                }
                let _e920 = phi_1127_;
                if false {
                    phi_1132_ = (_e920 | 4u);
                } else {
                    phi_1132_ = _e920;
                }
                let _e923 = phi_1132_;
                phi_1152_ = _e923;
            } else {
                if (_e898 == 7u) {
                    if _e252 {
                        phi_1141_ = (2u | 1u);
                    } else {
                        phi_1141_ = 2u;
                    }
                    let _e927 = phi_1141_;
                    if _e917 {
                        phi_1146_ = (_e927 | 4u);
                    } else {
                        phi_1146_ = _e927;
                    }
                    let _e930 = phi_1146_;
                    phi_1151_ = _e930;
                } else {
                    if _e252 {
                        phi_1150_ = 1u;
                    } else {
                        phi_1150_ = 0u;
                    }
                    let _e932 = phi_1150_;
                    phi_1151_ = _e932;
                }
                let _e934 = phi_1151_;
                phi_1152_ = _e934;
            }
            let _e936 = phi_1152_;
            if _e917 {
                phi_1156_ = 0f;
            } else {
                phi_1156_ = 1f;
            }
            let _e938 = phi_1156_;
            if _e256 {
                if (_e94 == 0.99999994f) {
                    phi_1165_ = true;
                } else {
                    phi_1165_ = (_e94 == 0.000000059604645f);
                }
                let _e942 = phi_1165_;
                phi_1166_ = _e942;
            } else {
                phi_1166_ = true;
            }
            let _e944 = phi_1166_;
            phi_1168_ = mask_Masked(_e938, _e936, _e913, _e944);
        }
        let _e947 = phi_1168_;
        visibility.member[_e78.first_primitive] = _e947.visibility;
        let _e952 = p.member.light.number;
        let _e953 = (_e952 * 3u);
        let _e955 = (_e953 % 32u);
        let _e957 = p.member.light.mask_words;
        let _e959 = ((_e78.first_primitive * _e957) + (_e953 / 32u));
        let _e961 = bits.member[_e959];
        bits.member[_e959] = ((_e961 & ~((7u << bitcast<u32>((_e955 & 31u))))) | (_e947.bits << bitcast<u32>((_e955 & 31u))));
        if (_e955 > 29u) {
            let _e976 = bits.member[(_e959 + 1u)];
            let _e978 = (32u - _e955);
            bits.member[(_e959 + 1u)] = ((_e976 & ~((7u >> bitcast<u32>((_e978 & 31u))))) | (_e947.bits >> bitcast<u32>((_e978 & 31u))));
        }
        let _e993 = samples.member[_e78.first_primitive].normal[0u];
        let _e995 = global[0u];
        if (_e993 == _e995) {
            let _e998 = samples.member[_e78.first_primitive].normal[1u];
            let _e1000 = global[1u];
            if (_e998 == _e1000) {
                let _e1003 = samples.member[_e78.first_primitive].normal[2u];
                let _e1005 = global[2u];
                phi_1240_ = (_e1003 == _e1005);
                phi_1241_ = false;
            } else {
                phi_1240_ = bool();
                phi_1241_ = true;
            }
            let _e1008 = phi_1240_;
            let _e1010 = phi_1241_;
            phi_1242_ = _e1008;
            phi_1243_ = _e1010;
        } else {
            phi_1242_ = bool();
            phi_1243_ = true;
        }
        let _e1012 = phi_1242_;
        let _e1014 = phi_1243_;
        if _e1014 {
            phi_1247_ = false;
        } else {
            phi_1247_ = _e1012;
        }
        let _e1016 = phi_1247_;
        if !(_e1016) {
            let _e1019 = samples.member[_e78.first_primitive].position;
            let _e1021 = p.member.current.eye;
            let _e1032 = p.member.current.forward;
            phi_1275_ = ((((_e1019.x - _e1021.x) * _e1032.x) + ((_e1019.y - _e1021.y) * _e1032.y)) + ((_e1019.z - _e1021.z) * _e1032.z));
        } else {
            phi_1275_ = 0f;
        }
        let _e1042 = phi_1275_;
        depths.member[_e78.first_primitive] = _e1042;
        phi_1280_ = doubt_Listed(_e78.first_primitive, _e947.is_trusted);
        phi_1281_ = _e947.needs_ray;
    } else {
        phi_1280_ = doubt_Listed(0u, false);
        phi_1281_ = false;
    }
    let _e1048 = phi_1280_;
    let _e1050 = phi_1281_;
    if (_e57 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1050 {
        let _e1056 = atomicAdd((&shared_[0u]), 1u);
        phi_1294_ = _e1056;
    } else {
        phi_1294_ = 0u;
    }
    let _e1058 = phi_1294_;
    workgroupBarrier();
    if (_e57 == 0u) {
        let _e1062 = atomicLoad((&shared_[0u]));
        let _e1063 = atomicAdd((&list.member[3u]), _e1062);
        atomicStore((&shared_[1u]), _e1063);
    }
    workgroupBarrier();
    if _e1050 {
        if _e1048.is_trusted {
            phi_1311_ = (_e1048.pixel | 2147483648u);
        } else {
            phi_1311_ = _e1048.pixel;
        }
        let _e1067 = phi_1311_;
        let _e1069 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1069) + _e1058)]), _e1067);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
