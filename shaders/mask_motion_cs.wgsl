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
    var phi_157_: lt_bvh_traverse_Tree;
    var phi_158_: bool;
    var phi_159_: lt_bvh_traverse_Tree;
    var phi_160_: bool;
    var phi_165_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_157_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_158_ = false;
        } else {
            phi_157_ = lt_bvh_traverse_Tree();
            phi_158_ = true;
        }
        let _e61 = phi_157_;
        let _e63 = phi_158_;
        phi_159_ = _e61;
        phi_160_ = _e63;
    } else {
        phi_159_ = lt_bvh_traverse_Tree();
        phi_160_ = true;
    }
    let _e65 = phi_159_;
    let _e67 = phi_160_;
    if _e67 {
        phi_165_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_165_ = _e65;
    }
    let _e72 = phi_165_;
    return lt_bvh_traverse_Tree(_e72.root, _e72.first_primitive);
}

fn function_() {
    var phi_210_: u32;
    var phi_244_: bool;
    var phi_245_: bool;
    var phi_246_: bool;
    var phi_247_: bool;
    var phi_251_: bool;
    var phi_321_: bool;
    var phi_322_: bool;
    var phi_333_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_334_: bool;
    var phi_335_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_336_: bool;
    var phi_343_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_347_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_360_: bool;
    var phi_391_: bool;
    var phi_392_: bool;
    var phi_393_: bool;
    var phi_394_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_538_: f32;
    var phi_543_: f32;
    var phi_544_: bool;
    var phi_545_: f32;
    var phi_546_: bool;
    var phi_550_: f32;
    var phi_571_: f32;
    var phi_576_: f32;
    var phi_577_: bool;
    var phi_578_: f32;
    var phi_579_: bool;
    var phi_583_: f32;
    var phi_604_: bool;
    var phi_623_: vec2<u32>;
    var phi_624_: bool;
    var phi_625_: bool;
    var phi_626_: bool;
    var phi_627_: vec2<u32>;
    var phi_628_: bool;
    var phi_629_: bool;
    var phi_630_: bool;
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
    var phi_654_: bool;
    var phi_655_: bool;
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_663_: vec2<u32>;
    var phi_701_: bool;
    var phi_703_: lt_mask_Reprojection;
    var phi_704_: lt_mask_Reprojection;
    var phi_705_: bool;
    var phi_709_: bool;
    var phi_710_: lt_mask_Reprojection;
    var phi_711_: lt_mask_Reprojection;
    var phi_712_: bool;
    var phi_720_: bool;
    var phi_721_: lt_mask_Reprojection;
    var phi_787_: u32;
    var phi_792_: u32;
    var phi_793_: u32;
    var phi_794_: u32;
    var phi_795_: bool;
    var phi_796_: u32;
    var phi_797_: bool;
    var phi_798_: bool;
    var phi_799_: u32;
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_805_: bool;
    var phi_809_: u32;
    var phi_814_: bool;
    var phi_854_: lt_mask_Neighbourhood;
    var phi_855_: lt_mask_Neighbourhood;
    var phi_856_: lt_mask_Neighbourhood;
    var phi_888_: bool;
    var phi_889_: bool;
    var phi_911_: bool;
    var phi_912_: bool;
    var phi_913_: bool;
    var phi_917_: bool;
    var phi_939_: bool;
    var phi_940_: bool;
    var phi_953_: bool;
    var phi_954_: bool;
    var phi_955_: bool;
    var phi_962_: u32;
    var phi_963_: u32;
    var phi_964_: u32;
    var phi_965_: u32;
    var phi_966_: u32;
    var phi_967_: u32;
    var phi_968_: u32;
    var phi_980_: bool;
    var phi_981_: bool;
    var phi_982_: bool;
    var phi_983_: bool;
    var phi_987_: bool;
    var phi_993_: bool;
    var phi_1001_: u32;
    var phi_1006_: u32;
    var phi_1015_: u32;
    var phi_1020_: u32;
    var phi_1024_: u32;
    var phi_1025_: u32;
    var phi_1026_: u32;
    var phi_1030_: f32;
    var phi_1032_: mask_Masked;
    var phi_1082_: bool;
    var phi_1083_: u32;
    var phi_1094_: u32;

    let _e48 = id_1;
    let _e49 = local_1;
    let _e54 = arrayLength((&heard.member));
    let _e61 = p.member.current.size[0u];
    let _e63 = p.member.current.size[1u];
    let _e64 = lt_shaders_entry_pixel_index(_e48, _e61, _e63);
    if (bitcast<i32>(_e64.root) != 0i) {
        let _e72 = p.member.current.size[0u];
        if (32u == 0u) {
            return;
        }
        let _e74 = (_e72 / 32u);
        if (32u == 0u) {
            return;
        }
        if ((_e72 % 32u) > 0u) {
            phi_210_ = (_e74 + 1u);
        } else {
            phi_210_ = _e74;
        }
        let _e80 = phi_210_;
        let _e83 = samples.member[_e64.first_primitive].position;
        let _e85 = visibility.member[_e64.first_primitive];
        let _e91 = samples.member[_e64.first_primitive].normal[0u];
        let _e93 = global[0u];
        if (_e91 == _e93) {
            let _e96 = samples.member[_e64.first_primitive].normal[1u];
            let _e98 = global[1u];
            if (_e96 == _e98) {
                let _e101 = samples.member[_e64.first_primitive].normal[2u];
                let _e103 = global[2u];
                phi_244_ = (_e101 == _e103);
                phi_245_ = false;
            } else {
                phi_244_ = bool();
                phi_245_ = true;
            }
            let _e106 = phi_244_;
            let _e108 = phi_245_;
            phi_246_ = _e106;
            phi_247_ = _e108;
        } else {
            phi_246_ = bool();
            phi_247_ = true;
        }
        let _e110 = phi_246_;
        let _e112 = phi_247_;
        if _e112 {
            phi_251_ = false;
        } else {
            phi_251_ = _e110;
        }
        let _e114 = phi_251_;
        if !(_e114) {
            let _e117 = samples.member[_e64.first_primitive].position;
            let _e119 = p.member.light.place;
            let _e125 = p.member.light.place[3u];
            let _e132 = (_e119.x - (_e117.x * _e125));
            let _e133 = (_e119.y - (_e117.y * _e125));
            let _e134 = (_e119.z - (_e117.z * _e125));
            let _e136 = samples.member[_e64.first_primitive].normal;
            if ((((_e136.x * _e132) + (_e136.y * _e133)) + (_e136.z * _e134)) > 0f) {
                let _e150 = (((_e132 * _e132) + (_e133 * _e133)) + (_e134 * _e134));
                let _e152 = p.member.light.axis;
                let _e164 = p.member.light.place[3u];
                if (_e164 == 0f) {
                    phi_322_ = true;
                } else {
                    let _e167 = p.member.light.range_squared;
                    if (_e150 <= _e167) {
                        let _e170 = p.member.light.cos_outer;
                        phi_321_ = (-((((_e132 * _e152.x) + (_e133 * _e152.y)) + (_e134 * _e152.z))) >= (_e170 * sqrt(_e150)));
                    } else {
                        phi_321_ = false;
                    }
                    let _e175 = phi_321_;
                    phi_322_ = _e175;
                }
                let _e177 = phi_322_;
                if _e177 {
                    let _e179 = samples.member[_e64.first_primitive].flags;
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e187.unnamed.visibility, false), _e187.unnamed_1);
                    phi_333_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e193.unnamed, ((_e179 & 1u) == 0u));
                    phi_334_ = false;
                } else {
                    phi_333_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_334_ = true;
                }
                let _e198 = phi_333_;
                let _e200 = phi_334_;
                phi_335_ = _e198;
                phi_336_ = _e200;
            } else {
                phi_335_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_336_ = true;
            }
            let _e202 = phi_335_;
            let _e204 = phi_336_;
            if _e204 {
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e210.unnamed.visibility, false), _e210.unnamed_1);
                phi_343_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e216.unnamed, true);
            } else {
                phi_343_ = _e202;
            }
            let _e221 = phi_343_;
            phi_347_ = _e221;
        } else {
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e233 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e227.unnamed.visibility, false), _e227.unnamed_1);
            phi_347_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e233.unnamed, true);
        }
        let _e238 = phi_347_;
        if _e238.unnamed_1 {
            phi_1032_ = mask_Masked(_e238.unnamed.visibility, 0u, false);
        } else {
            let _e243 = (_e85 < 0.5f);
            if (_e85 > 0f) {
                phi_360_ = (_e85 < 1f);
            } else {
                phi_360_ = false;
            }
            let _e247 = phi_360_;
            let _e254 = lt_mask_Reprojection(vec2<u32>(_e48.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e261 = lt_mask_Reprojection(vec2<u32>(_e254.pixel.x, _e48.y), _e254.is_valid, _e254.has_moved);
            let _e265 = lt_mask_Reprojection(_e261.pixel, true, _e261.has_moved);
            let _e271 = p.member.flags;
            if ((_e271 & 16u) == 0u) {
                phi_399_ = false;
            } else {
                let _e277 = samples.member[_e64.first_primitive].position[0u];
                if (_e83.x == _e277) {
                    let _e281 = samples.member[_e64.first_primitive].position[1u];
                    if (_e83.y == _e281) {
                        let _e285 = samples.member[_e64.first_primitive].position[2u];
                        phi_391_ = (_e83.z == _e285);
                        phi_392_ = false;
                    } else {
                        phi_391_ = bool();
                        phi_392_ = true;
                    }
                    let _e288 = phi_391_;
                    let _e290 = phi_392_;
                    phi_393_ = _e288;
                    phi_394_ = _e290;
                } else {
                    phi_393_ = bool();
                    phi_394_ = true;
                }
                let _e292 = phi_393_;
                let _e294 = phi_394_;
                if _e294 {
                    phi_398_ = false;
                } else {
                    phi_398_ = _e292;
                }
                let _e296 = phi_398_;
                phi_399_ = _e296;
            }
            let _e298 = phi_399_;
            if _e298 {
                phi_710_ = lt_mask_Reprojection(_e265.pixel, _e265.is_valid, false);
                phi_711_ = lt_mask_Reprojection();
                phi_712_ = true;
            } else {
                let _e302 = p.member.current.grid[0u];
                let _e304 = p.member.current.grid[1u];
                let _e318 = (f32(_e48.x) + ((f32((_e48.y & (_e304 - 1u))) + 0.5f) / f32(_e304)));
                let _e320 = (f32(_e48.y) + ((f32((_e48.x & (_e302 - 1u))) + 0.5f) / f32(_e302)));
                let _e323 = p.member.previous.eye;
                let _e326 = (_e83.x - _e323.x);
                let _e329 = (_e83.y - _e323.y);
                let _e332 = (_e83.z - _e323.z);
                let _e334 = p.member.previous.forward;
                let _e342 = (((_e326 * _e334.x) + (_e329 * _e334.y)) + (_e332 * _e334.z));
                let _e344 = p.member.previous.right;
                let _e354 = p.member.previous.right;
                let _e369 = p.member.previous.up;
                let _e379 = p.member.previous.up;
                let _e396 = p.member.previous.size[0u];
                let _e403 = p.member.previous.size[1u];
                let _e407 = (((((((_e326 * _e344.x) + (_e329 * _e344.y)) + (_e332 * _e344.z)) / ((((_e354.x * _e354.x) + (_e354.y * _e354.y)) + (_e354.z * _e354.z)) * _e342)) + 1f) * (0.5f * f32(_e396))) - _e318);
                let _e408 = (((1f - ((((_e326 * _e369.x) + (_e329 * _e369.y)) + (_e332 * _e369.z)) / ((((_e379.x * _e379.x) + (_e379.y * _e379.y)) + (_e379.z * _e379.z)) * _e342))) * (0.5f * f32(_e403))) - _e320);
                let _e412 = p.member.current.size[0u];
                let _e414 = p.member.current.size[1u];
                let _e416 = (_e318 + _e407);
                if (_e416 > -8388608f) {
                    let _e428 = f32(select(0i, select(select(i32(_e416), i32(-2147483648), (_e416 < bitcast<f32>(3472883712u))), 2147483647i, (_e416 > bitcast<f32>(1325400063u))), (_e416 == _e416)));
                    if (_e428 > _e416) {
                        phi_538_ = 1f;
                    } else {
                        phi_538_ = 0f;
                    }
                    let _e431 = phi_538_;
                    if (_e416 < 8388608f) {
                        phi_543_ = (_e428 - _e431);
                        phi_544_ = false;
                    } else {
                        phi_543_ = f32();
                        phi_544_ = true;
                    }
                    let _e434 = phi_543_;
                    let _e436 = phi_544_;
                    phi_545_ = _e434;
                    phi_546_ = _e436;
                } else {
                    phi_545_ = f32();
                    phi_546_ = true;
                }
                let _e438 = phi_545_;
                let _e440 = phi_546_;
                if _e440 {
                    phi_550_ = _e416;
                } else {
                    phi_550_ = _e438;
                }
                let _e442 = phi_550_;
                let _e443 = (_e320 + _e408);
                if (_e443 > -8388608f) {
                    let _e455 = f32(select(0i, select(select(i32(_e443), i32(-2147483648), (_e443 < bitcast<f32>(3472883712u))), 2147483647i, (_e443 > bitcast<f32>(1325400063u))), (_e443 == _e443)));
                    if (_e455 > _e443) {
                        phi_571_ = 1f;
                    } else {
                        phi_571_ = 0f;
                    }
                    let _e458 = phi_571_;
                    if (_e443 < 8388608f) {
                        phi_576_ = (_e455 - _e458);
                        phi_577_ = false;
                    } else {
                        phi_576_ = f32();
                        phi_577_ = true;
                    }
                    let _e461 = phi_576_;
                    let _e463 = phi_577_;
                    phi_578_ = _e461;
                    phi_579_ = _e463;
                } else {
                    phi_578_ = f32();
                    phi_579_ = true;
                }
                let _e465 = phi_578_;
                let _e467 = phi_579_;
                if _e467 {
                    phi_583_ = _e443;
                } else {
                    phi_583_ = _e465;
                }
                let _e469 = phi_583_;
                if (_e442 >= 0f) {
                    if (_e469 >= 0f) {
                        if (_e442 < f32(_e412)) {
                            let _e475 = (_e469 < f32(_e414));
                            if (_e407 == 0f) {
                                phi_604_ = (_e408 == 0f);
                            } else {
                                phi_604_ = false;
                            }
                            let _e479 = phi_604_;
                            if _e475 {
                                phi_623_ = vec2<u32>(select(select(u32(_e442), 0u, (_e442 < bitcast<f32>(0u))), 4294967295u, (_e442 > bitcast<f32>(1333788671u))), select(select(u32(_e469), 0u, (_e469 < bitcast<f32>(0u))), 4294967295u, (_e469 > bitcast<f32>(1333788671u))));
                                phi_624_ = false;
                            } else {
                                phi_623_ = vec2<u32>();
                                phi_624_ = true;
                            }
                            let _e496 = phi_623_;
                            let _e498 = phi_624_;
                            phi_625_ = _e479;
                            phi_626_ = _e475;
                            phi_627_ = _e496;
                            phi_628_ = _e479;
                            phi_629_ = _e475;
                            phi_630_ = false;
                            phi_631_ = _e498;
                        } else {
                            phi_625_ = bool();
                            phi_626_ = bool();
                            phi_627_ = vec2<u32>();
                            phi_628_ = bool();
                            phi_629_ = bool();
                            phi_630_ = true;
                            phi_631_ = false;
                        }
                        let _e500 = phi_625_;
                        let _e502 = phi_626_;
                        let _e504 = phi_627_;
                        let _e506 = phi_628_;
                        let _e508 = phi_629_;
                        let _e510 = phi_630_;
                        let _e512 = phi_631_;
                        phi_632_ = _e500;
                        phi_633_ = _e502;
                        phi_634_ = _e504;
                        phi_635_ = _e506;
                        phi_636_ = _e508;
                        phi_637_ = _e510;
                        phi_638_ = _e512;
                    } else {
                        phi_632_ = bool();
                        phi_633_ = bool();
                        phi_634_ = vec2<u32>();
                        phi_635_ = bool();
                        phi_636_ = bool();
                        phi_637_ = true;
                        phi_638_ = false;
                    }
                    let _e514 = phi_632_;
                    let _e516 = phi_633_;
                    let _e518 = phi_634_;
                    let _e520 = phi_635_;
                    let _e522 = phi_636_;
                    let _e524 = phi_637_;
                    let _e526 = phi_638_;
                    phi_639_ = _e514;
                    phi_640_ = _e516;
                    phi_641_ = _e518;
                    phi_642_ = _e520;
                    phi_643_ = _e522;
                    phi_644_ = _e524;
                    phi_645_ = _e526;
                } else {
                    phi_639_ = bool();
                    phi_640_ = bool();
                    phi_641_ = vec2<u32>();
                    phi_642_ = bool();
                    phi_643_ = bool();
                    phi_644_ = true;
                    phi_645_ = false;
                }
                let _e528 = phi_639_;
                let _e530 = phi_640_;
                let _e532 = phi_641_;
                let _e534 = phi_642_;
                let _e536 = phi_643_;
                let _e538 = phi_644_;
                let _e540 = phi_645_;
                if _e538 {
                    if (_e407 == 0f) {
                        phi_654_ = (_e408 == 0f);
                    } else {
                        phi_654_ = false;
                    }
                    let _e544 = phi_654_;
                    phi_655_ = _e544;
                    phi_656_ = false;
                    phi_657_ = true;
                } else {
                    phi_655_ = _e534;
                    phi_656_ = _e536;
                    phi_657_ = _e540;
                }
                let _e546 = phi_655_;
                let _e548 = phi_656_;
                let _e550 = phi_657_;
                if _e550 {
                    phi_661_ = _e546;
                    phi_662_ = _e548;
                    phi_663_ = vec2<u32>(_e48.x, _e48.y);
                } else {
                    phi_661_ = _e528;
                    phi_662_ = _e530;
                    phi_663_ = _e532;
                }
                let _e552 = phi_661_;
                let _e554 = phi_662_;
                let _e556 = phi_663_;
                let _e566 = lt_mask_Reprojection(vec2<u32>(_e556.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e573 = lt_mask_Reprojection(vec2<u32>(_e566.pixel.x, _e556.y), _e566.is_valid, _e566.has_moved);
                let _e577 = lt_mask_Reprojection(_e573.pixel, _e554, _e573.has_moved);
                let _e581 = lt_mask_Reprojection(_e577.pixel, _e577.is_valid, !(_e552));
                if _e554 {
                    let _e584 = p.member.previous.eye;
                    let _e595 = p.member.previous.forward;
                    let _e604 = (((((_e83.x - _e584.x) * _e595.x) + ((_e83.y - _e584.y) * _e595.y)) + ((_e83.z - _e584.z) * _e595.z)) > 0f);
                    let _e608 = lt_mask_Reprojection(_e581.pixel, _e604, _e581.has_moved);
                    if _e604 {
                        phi_701_ = false;
                    } else {
                        phi_701_ = true;
                    }
                    let _e610 = phi_701_;
                    phi_703_ = _e608;
                    phi_704_ = _e608;
                    phi_705_ = _e610;
                } else {
                    phi_703_ = lt_mask_Reprojection();
                    phi_704_ = lt_mask_Reprojection(_e581.pixel, false, _e581.has_moved);
                    phi_705_ = true;
                }
                let _e616 = phi_703_;
                let _e618 = phi_704_;
                let _e620 = phi_705_;
                if _e620 {
                    phi_709_ = false;
                } else {
                    phi_709_ = true;
                }
                let _e622 = phi_709_;
                phi_710_ = _e616;
                phi_711_ = _e618;
                phi_712_ = _e622;
            }
            let _e624 = phi_710_;
            let _e626 = phi_711_;
            let _e628 = phi_712_;
            if _e628 {
                let _e630 = p.member.flags;
                phi_720_ = ((_e630 & 1u) != 0u);
                phi_721_ = _e624;
            } else {
                phi_720_ = false;
                phi_721_ = _e626;
            }
            let _e634 = phi_720_;
            let _e636 = phi_721_;
            let _e640 = lt_mask_Reprojection(_e636.pixel, _e634, _e636.has_moved);
            let _e642 = p.member.flags;
            let _e644 = ((_e642 & 2u) != 0u);
            let _e646 = p.member.flags;
            if ((_e646 & 4u) == 0u) {
                phi_799_ = u32();
                phi_800_ = true;
                phi_801_ = false;
            } else {
                if _e634 {
                    if !(_e640.has_moved) {
                        let _e655 = ((((_e48.y * _e80) + (_e48.x / 32u)) * 6u) + 4u);
                        if (_e655 < _e54) {
                        } else {
                            return;
                        }
                        let _e659 = heard.member[(0u + _e655)];
                        if (((_e659 >> bitcast<u32>(((_e48.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e670 = ((((_e48.y * _e80) + (_e48.x / 32u)) * 6u) + 5u);
                            if (_e670 < _e54) {
                            } else {
                                return;
                            }
                            let _e674 = heard.member[(0u + _e670)];
                            if false {
                                phi_787_ = (2u | 1u);
                            } else {
                                phi_787_ = 2u;
                            }
                            let _e683 = phi_787_;
                            if (((_e674 >> bitcast<u32>(((_e48.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_792_ = (_e683 | 4u);
                            } else {
                                phi_792_ = _e683;
                            }
                            let _e686 = phi_792_;
                            phi_793_ = _e686;
                        } else {
                            phi_793_ = 0u;
                        }
                        let _e688 = phi_793_;
                        phi_794_ = _e688;
                        phi_795_ = false;
                    } else {
                        phi_794_ = u32();
                        phi_795_ = true;
                    }
                    let _e690 = phi_794_;
                    let _e692 = phi_795_;
                    phi_796_ = _e690;
                    phi_797_ = false;
                    phi_798_ = _e692;
                } else {
                    phi_796_ = u32();
                    phi_797_ = true;
                    phi_798_ = false;
                }
                let _e694 = phi_796_;
                let _e696 = phi_797_;
                let _e698 = phi_798_;
                phi_799_ = _e694;
                phi_800_ = _e696;
                phi_801_ = _e698;
            }
            let _e700 = phi_799_;
            let _e702 = phi_800_;
            let _e704 = phi_801_;
            if _e702 {
                phi_805_ = true;
            } else {
                phi_805_ = _e704;
            }
            let _e706 = phi_805_;
            if _e706 {
                phi_809_ = 0u;
            } else {
                phi_809_ = _e700;
            }
            let _e708 = phi_809_;
            let _e709 = lt_mask_Neighbourhood(false, true);
            if _e247 {
                phi_814_ = _e644;
            } else {
                phi_814_ = true;
            }
            let _e711 = phi_814_;
            if _e711 {
                if _e634 {
                    if ((_e708 & 2u) != 0u) {
                        phi_854_ = _e709;
                    } else {
                        let _e728 = ((((_e640.pixel.y * _e80) + (_e640.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e243) | (select(0u, 1u, _e640.has_moved) << bitcast<u32>(1i))));
                        if (_e728 < _e54) {
                        } else {
                            return;
                        }
                        let _e732 = heard.member[(0u + _e728)];
                        let _e738 = (((_e732 >> bitcast<u32>(((_e640.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_854_ = lt_mask_Neighbourhood(_e738, !(_e738));
                    }
                    let _e742 = phi_854_;
                    phi_855_ = _e742;
                } else {
                    phi_855_ = _e709;
                }
                let _e744 = phi_855_;
                phi_856_ = _e744;
            } else {
                phi_856_ = _e709;
            }
            let _e746 = phi_856_;
            let _e749 = p.member.frame;
            let _e751 = p.member.refresh;
            if (_e751 == 0u) {
                phi_889_ = false;
            } else {
                if (_e751 == 0u) {
                    return;
                }
                let _e760 = ((_e48.x + (_e48.y * (((_e751 * 5u) / 8u) | 1u))) + (_e749 % _e751));
                if (_e751 == 0u) {
                    phi_888_ = (_e760 == 0u);
                } else {
                    if (_e751 == 0u) {
                        return;
                    }
                    phi_888_ = ((_e760 % _e751) == 0u);
                }
                let _e767 = phi_888_;
                phi_889_ = _e767;
            }
            let _e769 = phi_889_;
            if _e634 {
                if _e769 {
                    phi_911_ = bool();
                } else {
                    phi_911_ = ((_e708 & 2u) != 0u);
                }
                let _e775 = phi_911_;
                phi_912_ = _e775;
                phi_913_ = _e769;
            } else {
                phi_912_ = bool();
                phi_913_ = true;
            }
            let _e777 = phi_912_;
            let _e779 = phi_913_;
            if _e779 {
                phi_917_ = false;
            } else {
                phi_917_ = _e777;
            }
            let _e781 = phi_917_;
            if _e781 {
                phi_968_ = 7u;
            } else {
                if (_e85 != 0.5f) {
                    if _e634 {
                        if _e769 {
                            phi_965_ = 6u;
                        } else {
                            if _e247 {
                                phi_940_ = true;
                            } else {
                                if _e746.any_expands {
                                    phi_939_ = false;
                                } else {
                                    phi_939_ = true;
                                }
                                let _e783 = phi_939_;
                                phi_940_ = _e783;
                            }
                            let _e785 = phi_940_;
                            if _e785 {
                                if _e247 {
                                    if _e644 {
                                        if _e746.all_remove {
                                            phi_953_ = false;
                                        } else {
                                            phi_953_ = true;
                                        }
                                        let _e787 = phi_953_;
                                        phi_954_ = _e787;
                                    } else {
                                        phi_954_ = true;
                                    }
                                    let _e789 = phi_954_;
                                    phi_955_ = _e789;
                                } else {
                                    phi_955_ = true;
                                }
                                let _e791 = phi_955_;
                                if _e791 {
                                    if _e247 {
                                        phi_962_ = 1u;
                                    } else {
                                        phi_962_ = 0u;
                                    }
                                    let _e793 = phi_962_;
                                    phi_963_ = _e793;
                                } else {
                                    phi_963_ = 5u;
                                }
                                let _e795 = phi_963_;
                                phi_964_ = _e795;
                            } else {
                                phi_964_ = 4u;
                            }
                            let _e797 = phi_964_;
                            phi_965_ = _e797;
                        }
                        let _e799 = phi_965_;
                        phi_966_ = _e799;
                    } else {
                        phi_966_ = 3u;
                    }
                    let _e801 = phi_966_;
                    phi_967_ = _e801;
                } else {
                    phi_967_ = 2u;
                }
                let _e803 = phi_967_;
                phi_968_ = _e803;
            }
            let _e805 = phi_968_;
            if !((_e805 == 0u)) {
                if !((_e805 == 5u)) {
                    phi_980_ = !(_e781);
                    phi_981_ = false;
                } else {
                    phi_980_ = bool();
                    phi_981_ = true;
                }
                let _e812 = phi_980_;
                let _e814 = phi_981_;
                phi_982_ = _e812;
                phi_983_ = _e814;
            } else {
                phi_982_ = bool();
                phi_983_ = true;
            }
            let _e816 = phi_982_;
            let _e818 = phi_983_;
            if _e818 {
                phi_987_ = false;
            } else {
                phi_987_ = _e816;
            }
            let _e820 = phi_987_;
            if _e781 {
                phi_993_ = ((_e708 & 4u) != 0u);
            } else {
                phi_993_ = _e243;
            }
            let _e824 = phi_993_;
            if _e820 {
                if _e243 {
                    phi_1001_ = (2u | 1u);
                } else {
                    phi_1001_ = 2u;
                }
                let _e827 = phi_1001_;
                if false {
                    phi_1006_ = (_e827 | 4u);
                } else {
                    phi_1006_ = _e827;
                }
                let _e830 = phi_1006_;
                phi_1026_ = _e830;
            } else {
                if (_e805 == 7u) {
                    if _e243 {
                        phi_1015_ = (2u | 1u);
                    } else {
                        phi_1015_ = 2u;
                    }
                    let _e834 = phi_1015_;
                    if _e824 {
                        phi_1020_ = (_e834 | 4u);
                    } else {
                        phi_1020_ = _e834;
                    }
                    let _e837 = phi_1020_;
                    phi_1025_ = _e837;
                } else {
                    if _e243 {
                        phi_1024_ = 1u;
                    } else {
                        phi_1024_ = 0u;
                    }
                    let _e839 = phi_1024_;
                    phi_1025_ = _e839;
                }
                let _e841 = phi_1025_;
                phi_1026_ = _e841;
            }
            let _e843 = phi_1026_;
            if _e824 {
                phi_1030_ = 0f;
            } else {
                phi_1030_ = 1f;
            }
            let _e845 = phi_1030_;
            phi_1032_ = mask_Masked(_e845, _e843, _e820);
        }
        let _e848 = phi_1032_;
        visibility.member[_e64.first_primitive] = _e848.visibility;
        let _e853 = p.member.light.number;
        let _e854 = (_e853 * 3u);
        let _e856 = (_e854 % 32u);
        let _e858 = p.member.light.mask_words;
        let _e860 = ((_e64.first_primitive * _e858) + (_e854 / 32u));
        let _e862 = bits.member[_e860];
        bits.member[_e860] = ((_e862 & ~((7u << bitcast<u32>((_e856 & 31u))))) | (_e848.bits << bitcast<u32>((_e856 & 31u))));
        if (_e856 > 29u) {
            let _e877 = bits.member[(_e860 + 1u)];
            let _e879 = (32u - _e856);
            bits.member[(_e860 + 1u)] = ((_e877 & ~((7u >> bitcast<u32>((_e879 & 31u))))) | (_e848.bits >> bitcast<u32>((_e879 & 31u))));
        }
        phi_1082_ = _e848.needs_ray;
        phi_1083_ = _e64.first_primitive;
    } else {
        phi_1082_ = false;
        phi_1083_ = 0u;
    }
    let _e893 = phi_1082_;
    let _e895 = phi_1083_;
    if (_e49 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e893 {
        let _e899 = atomicAdd((&shared_[0u]), 1u);
        phi_1094_ = _e899;
    } else {
        phi_1094_ = 0u;
    }
    let _e901 = phi_1094_;
    workgroupBarrier();
    if (_e49 == 0u) {
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
fn entry_mask_mask_motion_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
