struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    pad0_: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    pad3_: vec2<u32>,
}

struct abi_MaskParams {
    current: abi_CameraParams,
    previous: abi_CameraParams,
    light: vec4<f32>,
    frame: u32,
    still_pattern: u32,
    moving_pattern: u32,
    flags: u32,
    depth_tolerance: f32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_9 {
    member: abi_MaskParams,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_13 {
    member: array<abi_Sample>,
}

struct type_17 {
    member: array<u32>,
}

struct type_21 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
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

struct type_42 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(0) 
var<uniform> p: type_9;
@group(0) @binding(1) 
var<storage> samples: type_13;
@group(0) @binding(2) 
var<storage> last_bits: type_17;
@group(0) @binding(3) 
var<storage, read_write> bits: type_17;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_21;
@group(0) @binding(5) 
var<storage, read_write> list: type_42;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_154_: lt_bvh_traverse_Tree;
    var phi_155_: bool;
    var phi_156_: lt_bvh_traverse_Tree;
    var phi_157_: bool;
    var phi_162_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_154_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_155_ = false;
        } else {
            phi_154_ = lt_bvh_traverse_Tree();
            phi_155_ = true;
        }
        let _e62 = phi_154_;
        let _e64 = phi_155_;
        phi_156_ = _e62;
        phi_157_ = _e64;
    } else {
        phi_156_ = lt_bvh_traverse_Tree();
        phi_157_ = true;
    }
    let _e66 = phi_156_;
    let _e68 = phi_157_;
    if _e68 {
        phi_162_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_162_ = _e66;
    }
    let _e73 = phi_162_;
    return lt_bvh_traverse_Tree(_e73.root, _e73.first_primitive);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_180_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_180_ = vec2(0i);
            break;
        }
        case 1: {
            phi_180_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_180_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_180_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_180_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e58 = phi_180_;
    return vec2<i32>(_e58.x, _e58.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_198_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_198_ = vec2(0i);
            break;
        }
        case 1: {
            phi_198_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_198_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_198_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_198_ = vec2(1i);
            break;
        }
    }
    let _e58 = phi_198_;
    return vec2<i32>(_e58.x, _e58.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_217_: vec2<i32>;

    if (param_6 == 0u) {
        let _e52 = lt_mask_pattern_plus(param_5);
        phi_217_ = vec2<i32>(_e52.x, _e52.y);
    } else {
        let _e56 = lt_mask_pattern_cross(param_5);
        phi_217_ = vec2<i32>(_e56.x, _e56.y);
    }
    let _e61 = phi_217_;
    return vec2<i32>(_e61.x, _e61.y);
}

fn lt_mask_pattern_step_clamped(param_7: u32, param_8: i32, param_9: u32) -> u32 {
    var phi_238_: u32;
    var phi_239_: u32;

    let _e53 = (bitcast<i32>(param_7) + param_8);
    if (_e53 < 0i) {
        phi_239_ = 0u;
    } else {
        if (_e53 >= bitcast<i32>(param_9)) {
            phi_238_ = (param_9 - 1u);
        } else {
            phi_238_ = bitcast<u32>(_e53);
        }
        let _e60 = phi_238_;
        phi_239_ = _e60;
    }
    let _e62 = phi_239_;
    return _e62;
}

fn function_() {
    var phi_300_: bool;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_303_: bool;
    var phi_307_: bool;
    var phi_351_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_355_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_368_: bool;
    var phi_557_: f32;
    var phi_562_: f32;
    var phi_563_: bool;
    var phi_564_: f32;
    var phi_565_: bool;
    var phi_569_: f32;
    var phi_592_: f32;
    var phi_597_: f32;
    var phi_598_: bool;
    var phi_599_: f32;
    var phi_600_: bool;
    var phi_604_: f32;
    var phi_625_: bool;
    var phi_644_: vec2<u32>;
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
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_662_: vec2<u32>;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_666_: bool;
    var phi_675_: bool;
    var phi_676_: bool;
    var phi_677_: bool;
    var phi_678_: bool;
    var phi_682_: bool;
    var phi_683_: bool;
    var phi_684_: vec2<u32>;
    var phi_726_: bool;
    var phi_727_: bool;
    var phi_729_: bool;
    var phi_730_: lt_mask_Reprojection;
    var phi_731_: lt_mask_Reprojection;
    var phi_732_: bool;
    var phi_736_: bool;
    var phi_737_: lt_mask_Reprojection;
    var phi_765_: u32;
    var phi_767_: u32;
    var phi_770_: lt_mask_Neighbourhood;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_791_: u32;
    var phi_792_: u32;
    var phi_851_: vec2<i32>;
    var phi_867_: vec2<i32>;
    var phi_890_: u32;
    var phi_907_: bool;
    var phi_908_: bool;
    var phi_915_: bool;
    var phi_916_: bool;
    var phi_934_: bool;
    var phi_935_: bool;
    var phi_936_: bool;
    var phi_768_: u32;
    var phi_771_: lt_mask_Neighbourhood;
    var phi_939_: lt_mask_Neighbourhood;
    var phi_940_: lt_mask_Neighbourhood;
    var phi_941_: lt_mask_Neighbourhood;
    var phi_966_: bool;
    var phi_967_: bool;
    var phi_980_: bool;
    var phi_981_: bool;
    var phi_982_: bool;
    var phi_989_: u32;
    var phi_990_: u32;
    var phi_991_: u32;
    var phi_992_: u32;
    var phi_993_: u32;
    var phi_1001_: bool;
    var phi_1009_: u32;
    var phi_1014_: u32;
    var phi_1018_: u32;
    var phi_1019_: u32;
    var phi_1023_: f32;
    var phi_1025_: mask_Masked;
    var phi_1031_: bool;
    var phi_1032_: u32;
    var phi_1043_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e49 = id_1;
    let _e50 = local_2;
    let _e62 = p.member.current.size[0u];
    let _e64 = p.member.current.size[1u];
    let _e65 = lt_shaders_entry_pixel_index(_e49, _e62, _e64);
    if (bitcast<i32>(_e65.root) != 0i) {
        let _e73 = p.member.current.size[0u];
        let _e76 = samples.member[_e65.first_primitive].position;
        let _e78 = visibility.member[_e65.first_primitive];
        let _e82 = p.member.light;
        let _e85 = samples.member[_e65.first_primitive].normal[0u];
        let _e87 = global[0u];
        if (_e85 == _e87) {
            let _e90 = samples.member[_e65.first_primitive].normal[1u];
            let _e92 = global[1u];
            if (_e90 == _e92) {
                let _e95 = samples.member[_e65.first_primitive].normal[2u];
                let _e97 = global[2u];
                phi_300_ = (_e95 == _e97);
                phi_301_ = false;
            } else {
                phi_300_ = bool();
                phi_301_ = true;
            }
            let _e100 = phi_300_;
            let _e102 = phi_301_;
            phi_302_ = _e100;
            phi_303_ = _e102;
        } else {
            phi_302_ = bool();
            phi_303_ = true;
        }
        let _e104 = phi_302_;
        let _e106 = phi_303_;
        if _e106 {
            phi_307_ = false;
        } else {
            phi_307_ = _e104;
        }
        let _e108 = phi_307_;
        if !(_e108) {
            let _e111 = samples.member[_e65.first_primitive].normal;
            let _e113 = samples.member[_e65.first_primitive].position;
            if ((((_e111.x * (_e82.x - (_e113.x * _e82.w))) + (_e111.y * (_e82.y - (_e113.y * _e82.w)))) + (_e111.z * (_e82.z - (_e113.z * _e82.w)))) > 0f) {
                let _e137 = samples.member[_e65.first_primitive].flags;
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e145.unnamed.visibility, false), _e145.unnamed_1);
                phi_351_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e151.unnamed, ((_e137 & 1u) == 0u));
            } else {
                let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e160.unnamed.visibility, false), _e160.unnamed_1);
                phi_351_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e166.unnamed, true);
            }
            let _e171 = phi_351_;
            phi_355_ = _e171;
        } else {
            let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e183 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e177.unnamed.visibility, false), _e177.unnamed_1);
            phi_355_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e183.unnamed, true);
        }
        let _e188 = phi_355_;
        if _e188.unnamed_1 {
            phi_1025_ = mask_Masked(_e188.unnamed.visibility, 0u, false);
        } else {
            let _e193 = (_e78 < 0.5f);
            if (_e78 > 0f) {
                phi_368_ = (_e78 < 1f);
            } else {
                phi_368_ = false;
            }
            let _e197 = phi_368_;
            let _e199 = samples.member[_e65.first_primitive].position;
            let _e203 = p.member.previous.eye;
            let _e206 = (_e76.x - _e203.x);
            let _e209 = (_e76.y - _e203.y);
            let _e212 = (_e76.z - _e203.z);
            let _e214 = p.member.previous.forward;
            let _e222 = (((_e206 * _e214.x) + (_e209 * _e214.y)) + (_e212 * _e214.z));
            let _e224 = p.member.previous.right;
            let _e234 = p.member.previous.right;
            let _e249 = p.member.previous.up;
            let _e259 = p.member.previous.up;
            let _e274 = p.member.current.eye;
            let _e277 = (_e199.x - _e274.x);
            let _e280 = (_e199.y - _e274.y);
            let _e283 = (_e199.z - _e274.z);
            let _e285 = p.member.current.forward;
            let _e293 = (((_e277 * _e285.x) + (_e280 * _e285.y)) + (_e283 * _e285.z));
            let _e295 = p.member.current.right;
            let _e305 = p.member.current.right;
            let _e320 = p.member.current.up;
            let _e330 = p.member.current.up;
            let _e349 = p.member.current.size[0u];
            let _e351 = (((((((_e206 * _e224.x) + (_e209 * _e224.y)) + (_e212 * _e224.z)) / ((((_e234.x * _e234.x) + (_e234.y * _e234.y)) + (_e234.z * _e234.z)) * _e222)) - ((((_e277 * _e295.x) + (_e280 * _e295.y)) + (_e283 * _e295.z)) / ((((_e305.x * _e305.x) + (_e305.y * _e305.y)) + (_e305.z * _e305.z)) * _e293))) * 0.5f) * f32(_e349));
            let _e355 = p.member.current.size[1u];
            let _e357 = (((((((_e206 * _e249.x) + (_e209 * _e249.y)) + (_e212 * _e249.z)) / ((((_e259.x * _e259.x) + (_e259.y * _e259.y)) + (_e259.z * _e259.z)) * _e222)) - ((((_e277 * _e320.x) + (_e280 * _e320.y)) + (_e283 * _e320.z)) / ((((_e330.x * _e330.x) + (_e330.y * _e330.y)) + (_e330.z * _e330.z)) * _e293))) * -0.5f) * f32(_e355));
            let _e361 = p.member.current.size[0u];
            let _e363 = p.member.current.size[1u];
            let _e367 = ((f32(_e49.x) + 0.5f) + _e351);
            if (_e367 > -8388608f) {
                let _e379 = f32(select(0i, select(select(i32(_e367), i32(-2147483648), (_e367 < bitcast<f32>(3472883712u))), 2147483647i, (_e367 > bitcast<f32>(1325400063u))), (_e367 == _e367)));
                if (_e379 > _e367) {
                    phi_557_ = 1f;
                } else {
                    phi_557_ = 0f;
                }
                let _e382 = phi_557_;
                if (_e367 < 8388608f) {
                    phi_562_ = (_e379 - _e382);
                    phi_563_ = false;
                } else {
                    phi_562_ = f32();
                    phi_563_ = true;
                }
                let _e385 = phi_562_;
                let _e387 = phi_563_;
                phi_564_ = _e385;
                phi_565_ = _e387;
            } else {
                phi_564_ = f32();
                phi_565_ = true;
            }
            let _e389 = phi_564_;
            let _e391 = phi_565_;
            if _e391 {
                phi_569_ = _e367;
            } else {
                phi_569_ = _e389;
            }
            let _e393 = phi_569_;
            let _e396 = ((f32(_e49.y) + 0.5f) + _e357);
            if (_e396 > -8388608f) {
                let _e408 = f32(select(0i, select(select(i32(_e396), i32(-2147483648), (_e396 < bitcast<f32>(3472883712u))), 2147483647i, (_e396 > bitcast<f32>(1325400063u))), (_e396 == _e396)));
                if (_e408 > _e396) {
                    phi_592_ = 1f;
                } else {
                    phi_592_ = 0f;
                }
                let _e411 = phi_592_;
                if (_e396 < 8388608f) {
                    phi_597_ = (_e408 - _e411);
                    phi_598_ = false;
                } else {
                    phi_597_ = f32();
                    phi_598_ = true;
                }
                let _e414 = phi_597_;
                let _e416 = phi_598_;
                phi_599_ = _e414;
                phi_600_ = _e416;
            } else {
                phi_599_ = f32();
                phi_600_ = true;
            }
            let _e418 = phi_599_;
            let _e420 = phi_600_;
            if _e420 {
                phi_604_ = _e396;
            } else {
                phi_604_ = _e418;
            }
            let _e422 = phi_604_;
            if (_e393 >= 0f) {
                if (_e422 >= 0f) {
                    if (_e393 < f32(_e361)) {
                        let _e428 = (_e422 < f32(_e363));
                        if (_e351 == 0f) {
                            phi_625_ = (_e357 == 0f);
                        } else {
                            phi_625_ = false;
                        }
                        let _e432 = phi_625_;
                        if _e428 {
                            phi_644_ = vec2<u32>(select(select(u32(_e393), 0u, (_e393 < bitcast<f32>(0u))), 4294967295u, (_e393 > bitcast<f32>(1333788671u))), select(select(u32(_e422), 0u, (_e422 < bitcast<f32>(0u))), 4294967295u, (_e422 > bitcast<f32>(1333788671u))));
                            phi_645_ = false;
                        } else {
                            phi_644_ = vec2<u32>();
                            phi_645_ = true;
                        }
                        let _e449 = phi_644_;
                        let _e451 = phi_645_;
                        phi_646_ = _e432;
                        phi_647_ = _e428;
                        phi_648_ = _e449;
                        phi_649_ = _e432;
                        phi_650_ = _e428;
                        phi_651_ = false;
                        phi_652_ = _e451;
                    } else {
                        phi_646_ = bool();
                        phi_647_ = bool();
                        phi_648_ = vec2<u32>();
                        phi_649_ = bool();
                        phi_650_ = bool();
                        phi_651_ = true;
                        phi_652_ = false;
                    }
                    let _e453 = phi_646_;
                    let _e455 = phi_647_;
                    let _e457 = phi_648_;
                    let _e459 = phi_649_;
                    let _e461 = phi_650_;
                    let _e463 = phi_651_;
                    let _e465 = phi_652_;
                    phi_653_ = _e453;
                    phi_654_ = _e455;
                    phi_655_ = _e457;
                    phi_656_ = _e459;
                    phi_657_ = _e461;
                    phi_658_ = _e463;
                    phi_659_ = _e465;
                } else {
                    phi_653_ = bool();
                    phi_654_ = bool();
                    phi_655_ = vec2<u32>();
                    phi_656_ = bool();
                    phi_657_ = bool();
                    phi_658_ = true;
                    phi_659_ = false;
                }
                let _e467 = phi_653_;
                let _e469 = phi_654_;
                let _e471 = phi_655_;
                let _e473 = phi_656_;
                let _e475 = phi_657_;
                let _e477 = phi_658_;
                let _e479 = phi_659_;
                phi_660_ = _e467;
                phi_661_ = _e469;
                phi_662_ = _e471;
                phi_663_ = _e473;
                phi_664_ = _e475;
                phi_665_ = _e477;
                phi_666_ = _e479;
            } else {
                phi_660_ = bool();
                phi_661_ = bool();
                phi_662_ = vec2<u32>();
                phi_663_ = bool();
                phi_664_ = bool();
                phi_665_ = true;
                phi_666_ = false;
            }
            let _e481 = phi_660_;
            let _e483 = phi_661_;
            let _e485 = phi_662_;
            let _e487 = phi_663_;
            let _e489 = phi_664_;
            let _e491 = phi_665_;
            let _e493 = phi_666_;
            if _e491 {
                if (_e351 == 0f) {
                    phi_675_ = (_e357 == 0f);
                } else {
                    phi_675_ = false;
                }
                let _e497 = phi_675_;
                phi_676_ = _e497;
                phi_677_ = false;
                phi_678_ = true;
            } else {
                phi_676_ = _e487;
                phi_677_ = _e489;
                phi_678_ = _e493;
            }
            let _e499 = phi_676_;
            let _e501 = phi_677_;
            let _e503 = phi_678_;
            if _e503 {
                phi_682_ = _e499;
                phi_683_ = _e501;
                phi_684_ = vec2<u32>(_e49.x, _e49.y);
            } else {
                phi_682_ = _e481;
                phi_683_ = _e483;
                phi_684_ = _e485;
            }
            let _e505 = phi_682_;
            let _e507 = phi_683_;
            let _e509 = phi_684_;
            let _e519 = lt_mask_Reprojection(vec2<u32>(_e509.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e526 = lt_mask_Reprojection(vec2<u32>(_e519.pixel.x, _e509.y), _e519.is_valid, _e519.has_moved);
            let _e530 = lt_mask_Reprojection(_e526.pixel, _e507, _e526.has_moved);
            let _e534 = lt_mask_Reprojection(_e530.pixel, _e530.is_valid, !(_e505));
            if _e507 {
                let _e537 = p.member.previous.eye;
                let _e548 = p.member.previous.forward;
                let _e557 = (((((_e76.x - _e537.x) * _e548.x) + ((_e76.y - _e537.y) * _e548.y)) + ((_e76.z - _e537.z) * _e548.z)) > 0f);
                let _e561 = lt_mask_Reprojection(_e534.pixel, _e557, _e534.has_moved);
                if _e557 {
                    let _e563 = p.member.flags;
                    phi_726_ = ((_e563 & 1u) != 0u);
                    phi_727_ = false;
                } else {
                    phi_726_ = bool();
                    phi_727_ = true;
                }
                let _e567 = phi_726_;
                let _e569 = phi_727_;
                phi_729_ = _e567;
                phi_730_ = _e561;
                phi_731_ = _e561;
                phi_732_ = _e569;
            } else {
                phi_729_ = bool();
                phi_730_ = lt_mask_Reprojection();
                phi_731_ = lt_mask_Reprojection(_e534.pixel, false, _e534.has_moved);
                phi_732_ = true;
            }
            let _e575 = phi_729_;
            let _e577 = phi_730_;
            let _e579 = phi_731_;
            let _e581 = phi_732_;
            if _e581 {
                phi_736_ = false;
                phi_737_ = _e579;
            } else {
                phi_736_ = _e575;
                phi_737_ = _e577;
            }
            let _e583 = phi_736_;
            let _e585 = phi_737_;
            let _e589 = lt_mask_Reprojection(_e585.pixel, _e583, _e585.has_moved);
            if _e589.has_moved {
            }
            let _e595 = lt_mask_Neighbourhood(false, true);
            if _e197 {
                phi_941_ = _e595;
            } else {
                if true {
                    if _e583 {
                        if _e589.has_moved {
                            let _e598 = p.member.moving_pattern;
                            phi_765_ = _e598;
                        } else {
                            let _e600 = p.member.still_pattern;
                            phi_765_ = _e600;
                        }
                        let _e602 = phi_765_;
                        phi_767_ = 0u;
                        phi_770_ = _e595;
                        loop {
                            let _e604 = phi_767_;
                            let _e606 = phi_770_;
                            local_1 = _e606;
                            if (1u <= _e602) {
                                if (_e602 <= 4u) {
                                    phi_782_ = false;
                                } else {
                                    phi_782_ = true;
                                }
                                let _e610 = phi_782_;
                                phi_783_ = _e610;
                            } else {
                                phi_783_ = true;
                            }
                            let _e612 = phi_783_;
                            if _e612 {
                                switch bitcast<i32>(_e602) {
                                    case 5: {
                                        phi_791_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_791_ = 25u;
                                        break;
                                    }
                                    default: {
                                        phi_791_ = 9u;
                                        break;
                                    }
                                }
                                let _e615 = phi_791_;
                                phi_792_ = _e615;
                            } else {
                                phi_792_ = 5u;
                            }
                            let _e617 = phi_792_;
                            let _e618 = (_e604 < _e617);
                            if _e618 {
                                let _e624 = p.member.frame;
                                let _e628 = p.member.current.size[0u];
                                let _e630 = p.member.current.size[1u];
                                switch bitcast<i32>(_e602) {
                                    case 1: {
                                        let _e640 = lt_mask_pattern_plus(_e604);
                                        phi_867_ = vec2<i32>(_e640.x, _e640.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e644 = lt_mask_pattern_cross(_e604);
                                        phi_867_ = vec2<i32>(_e644.x, _e644.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e650 = lt_mask_pattern_plus_or_cross(_e604, ((_e589.pixel.x + _e589.pixel.y) & 1u));
                                        phi_867_ = vec2<i32>(_e650.x, _e650.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e655 = lt_mask_pattern_plus_or_cross(_e604, (_e624 & 1u));
                                        phi_867_ = vec2<i32>(_e655.x, _e655.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e624 & 3u)) {
                                            case 0: {
                                                phi_851_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_851_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_851_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_851_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e666 = phi_851_;
                                        phi_867_ = (_e666 + vec2<i32>(bitcast<i32>((_e604 & 1u)), bitcast<i32>(((_e604 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_867_ = vec2<i32>((bitcast<i32>((_e604 % 5u)) - 2i), (bitcast<i32>(((_e604 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    default: {
                                        phi_867_ = vec2<i32>((bitcast<i32>((_e604 % 3u)) - 1i), (bitcast<i32>(((_e604 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e684 = phi_867_;
                                let _e687 = lt_mask_pattern_step_clamped(_e589.pixel.x, _e684.x, _e628);
                                let _e688 = lt_mask_pattern_step_clamped(_e589.pixel.y, _e684.y, _e630);
                                let _e690 = ((_e688 * _e73) + _e687);
                                if (_e690 < arrayLength((&last_bits.member))) {
                                } else {
                                    return;
                                }
                                let _e694 = last_bits.member[(0u + _e690)];
                                if ((_e694 & 2u) == 0u) {
                                    phi_890_ = (_e694 & 1u);
                                } else {
                                    phi_890_ = (_e694 & 7u);
                                }
                                let _e700 = phi_890_;
                                if _e606.any_expands {
                                    phi_916_ = true;
                                } else {
                                    if ((_e700 & 2u) != 0u) {
                                        if (((_e700 & 4u) != 0u) != _e193) {
                                            phi_907_ = false;
                                        } else {
                                            phi_907_ = true;
                                        }
                                        let _e709 = phi_907_;
                                        phi_908_ = _e709;
                                    } else {
                                        phi_908_ = true;
                                    }
                                    let _e711 = phi_908_;
                                    if _e711 {
                                        phi_915_ = (((_e700 & 1u) != 0u) != _e193);
                                    } else {
                                        phi_915_ = true;
                                    }
                                    let _e716 = phi_915_;
                                    phi_916_ = _e716;
                                }
                                let _e718 = phi_916_;
                                if _e606.all_remove {
                                    if (((_e700 & 1u) != 0u) == _e193) {
                                        if ((_e700 & 2u) != 0u) {
                                            phi_934_ = (((_e700 & 4u) != 0u) == _e193);
                                        } else {
                                            phi_934_ = true;
                                        }
                                        let _e728 = phi_934_;
                                        phi_935_ = _e728;
                                    } else {
                                        phi_935_ = false;
                                    }
                                    let _e730 = phi_935_;
                                    phi_936_ = _e730;
                                } else {
                                    phi_936_ = false;
                                }
                                let _e732 = phi_936_;
                                phi_768_ = (_e604 + 1u);
                                phi_771_ = lt_mask_Neighbourhood(_e718, _e732);
                            } else {
                                phi_768_ = u32();
                                phi_771_ = lt_mask_Neighbourhood();
                            }
                            let _e736 = phi_768_;
                            let _e738 = phi_771_;
                            continue;
                            continuing {
                                phi_767_ = _e736;
                                phi_770_ = _e738;
                                break if !(_e618);
                            }
                        }
                        let _e896 = local_1;
                        phi_939_ = _e896;
                    } else {
                        phi_939_ = _e595;
                    }
                    let _e741 = phi_939_;
                    phi_940_ = _e741;
                } else {
                    phi_940_ = _e595;
                }
                let _e743 = phi_940_;
                phi_941_ = _e743;
            }
            let _e745 = phi_941_;
            if (_e78 != 0.5f) {
                if _e583 {
                    if _e197 {
                        phi_967_ = true;
                    } else {
                        if _e745.any_expands {
                            phi_966_ = false;
                        } else {
                            phi_966_ = true;
                        }
                        let _e750 = phi_966_;
                        phi_967_ = _e750;
                    }
                    let _e752 = phi_967_;
                    if _e752 {
                        if _e197 {
                            if false {
                                if _e745.all_remove {
                                    phi_980_ = false;
                                } else {
                                    phi_980_ = true;
                                }
                                let _e754 = phi_980_;
                                phi_981_ = _e754;
                            } else {
                                phi_981_ = true;
                            }
                            let _e756 = phi_981_;
                            phi_982_ = _e756;
                        } else {
                            phi_982_ = true;
                        }
                        let _e758 = phi_982_;
                        if _e758 {
                            if _e197 {
                                phi_989_ = 1u;
                            } else {
                                phi_989_ = 0u;
                            }
                            let _e760 = phi_989_;
                            phi_990_ = _e760;
                        } else {
                            phi_990_ = 5u;
                        }
                        let _e762 = phi_990_;
                        phi_991_ = _e762;
                    } else {
                        phi_991_ = 4u;
                    }
                    let _e764 = phi_991_;
                    phi_992_ = _e764;
                } else {
                    phi_992_ = 3u;
                }
                let _e766 = phi_992_;
                phi_993_ = _e766;
            } else {
                phi_993_ = 2u;
            }
            let _e768 = phi_993_;
            if !((_e768 == 0u)) {
                phi_1001_ = !((_e768 == 5u));
            } else {
                phi_1001_ = false;
            }
            let _e774 = phi_1001_;
            if _e774 {
                if _e193 {
                    phi_1009_ = (2u | 1u);
                } else {
                    phi_1009_ = 2u;
                }
                let _e777 = phi_1009_;
                if false {
                    phi_1014_ = (_e777 | 4u);
                } else {
                    phi_1014_ = _e777;
                }
                let _e780 = phi_1014_;
                phi_1019_ = _e780;
            } else {
                if _e193 {
                    phi_1018_ = 1u;
                } else {
                    phi_1018_ = 0u;
                }
                let _e782 = phi_1018_;
                phi_1019_ = _e782;
            }
            let _e784 = phi_1019_;
            if _e193 {
                phi_1023_ = 0f;
            } else {
                phi_1023_ = 1f;
            }
            let _e786 = phi_1023_;
            phi_1025_ = mask_Masked(_e786, _e784, _e774);
        }
        let _e789 = phi_1025_;
        visibility.member[_e65.first_primitive] = _e789.visibility;
        bits.member[_e65.first_primitive] = _e789.bits;
        phi_1031_ = _e789.needs_ray;
        phi_1032_ = _e65.first_primitive;
    } else {
        phi_1031_ = false;
        phi_1032_ = 0u;
    }
    let _e796 = phi_1031_;
    let _e798 = phi_1032_;
    if (_e50 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e796 {
        let _e802 = atomicAdd((&shared_[0u]), 1u);
        phi_1043_ = _e802;
    } else {
        phi_1043_ = 0u;
    }
    let _e804 = phi_1043_;
    workgroupBarrier();
    if (_e50 == 0u) {
        let _e808 = atomicLoad((&shared_[0u]));
        let _e809 = atomicAdd((&list.member[3u]), _e808);
        atomicStore((&shared_[1u]), _e809);
    }
    workgroupBarrier();
    if _e796 {
        let _e812 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e812) + _e804)]), _e798);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
