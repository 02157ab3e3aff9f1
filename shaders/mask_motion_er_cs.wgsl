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

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_161_: lt_bvh_traverse_Tree;
    var phi_162_: bool;
    var phi_163_: lt_bvh_traverse_Tree;
    var phi_164_: bool;
    var phi_169_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_161_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_162_ = false;
        } else {
            phi_161_ = lt_bvh_traverse_Tree();
            phi_162_ = true;
        }
        let _e63 = phi_161_;
        let _e65 = phi_162_;
        phi_163_ = _e63;
        phi_164_ = _e65;
    } else {
        phi_163_ = lt_bvh_traverse_Tree();
        phi_164_ = true;
    }
    let _e67 = phi_163_;
    let _e69 = phi_164_;
    if _e69 {
        phi_169_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_169_ = _e67;
    }
    let _e74 = phi_169_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn function_() {
    var phi_215_: u32;
    var phi_249_: bool;
    var phi_250_: bool;
    var phi_251_: bool;
    var phi_252_: bool;
    var phi_256_: bool;
    var phi_326_: bool;
    var phi_327_: bool;
    var phi_338_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_339_: bool;
    var phi_340_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_341_: bool;
    var phi_348_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_352_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_365_: bool;
    var phi_396_: bool;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_403_: bool;
    var phi_404_: bool;
    var phi_543_: f32;
    var phi_548_: f32;
    var phi_549_: bool;
    var phi_550_: f32;
    var phi_551_: bool;
    var phi_555_: f32;
    var phi_576_: f32;
    var phi_581_: f32;
    var phi_582_: bool;
    var phi_583_: f32;
    var phi_584_: bool;
    var phi_588_: f32;
    var phi_609_: bool;
    var phi_628_: vec2<u32>;
    var phi_629_: bool;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_632_: vec2<u32>;
    var phi_633_: bool;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_636_: bool;
    var phi_637_: bool;
    var phi_638_: bool;
    var phi_639_: vec2<u32>;
    var phi_640_: bool;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_643_: bool;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: vec2<u32>;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_666_: bool;
    var phi_667_: bool;
    var phi_668_: vec2<u32>;
    var phi_706_: bool;
    var phi_708_: lt_mask_Reprojection;
    var phi_709_: lt_mask_Reprojection;
    var phi_710_: bool;
    var phi_714_: bool;
    var phi_715_: lt_mask_Reprojection;
    var phi_716_: lt_mask_Reprojection;
    var phi_717_: bool;
    var phi_725_: bool;
    var phi_726_: lt_mask_Reprojection;
    var phi_732_: bool;
    var phi_772_: lt_mask_Neighbourhood;
    var phi_773_: lt_mask_Neighbourhood;
    var phi_774_: lt_mask_Neighbourhood;
    var phi_806_: bool;
    var phi_807_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_835_: bool;
    var phi_857_: bool;
    var phi_858_: bool;
    var phi_871_: bool;
    var phi_872_: bool;
    var phi_873_: bool;
    var phi_880_: u32;
    var phi_881_: u32;
    var phi_882_: u32;
    var phi_883_: u32;
    var phi_884_: u32;
    var phi_885_: u32;
    var phi_886_: u32;
    var phi_898_: bool;
    var phi_899_: bool;
    var phi_900_: bool;
    var phi_901_: bool;
    var phi_905_: bool;
    var phi_911_: bool;
    var phi_919_: u32;
    var phi_924_: u32;
    var phi_933_: u32;
    var phi_938_: u32;
    var phi_942_: u32;
    var phi_943_: u32;
    var phi_944_: u32;
    var phi_948_: f32;
    var phi_957_: bool;
    var phi_958_: bool;
    var phi_960_: mask_Masked;
    var phi_1012_: doubt_Listed;
    var phi_1013_: bool;
    var phi_1026_: u32;
    var phi_1043_: u32;

    let _e50 = id_1;
    let _e51 = local_1;
    let _e64 = p.member.current.size[0u];
    let _e66 = p.member.current.size[1u];
    let _e67 = lt_shaders_entry_pixel_index(_e50, _e64, _e66);
    if (bitcast<i32>(_e67.root) != 0i) {
        let _e75 = p.member.current.size[0u];
        if (32u == 0u) {
            return;
        }
        let _e77 = (_e75 / 32u);
        if (32u == 0u) {
            return;
        }
        if ((_e75 % 32u) > 0u) {
            phi_215_ = (_e77 + 1u);
        } else {
            phi_215_ = _e77;
        }
        let _e83 = phi_215_;
        let _e86 = samples.member[_e67.first_primitive].position;
        let _e88 = visibility.member[_e67.first_primitive];
        let _e94 = samples.member[_e67.first_primitive].normal[0u];
        let _e96 = global[0u];
        if (_e94 == _e96) {
            let _e99 = samples.member[_e67.first_primitive].normal[1u];
            let _e101 = global[1u];
            if (_e99 == _e101) {
                let _e104 = samples.member[_e67.first_primitive].normal[2u];
                let _e106 = global[2u];
                phi_249_ = (_e104 == _e106);
                phi_250_ = false;
            } else {
                phi_249_ = bool();
                phi_250_ = true;
            }
            let _e109 = phi_249_;
            let _e111 = phi_250_;
            phi_251_ = _e109;
            phi_252_ = _e111;
        } else {
            phi_251_ = bool();
            phi_252_ = true;
        }
        let _e113 = phi_251_;
        let _e115 = phi_252_;
        if _e115 {
            phi_256_ = false;
        } else {
            phi_256_ = _e113;
        }
        let _e117 = phi_256_;
        if !(_e117) {
            let _e120 = samples.member[_e67.first_primitive].position;
            let _e122 = p.member.light.place;
            let _e128 = p.member.light.place[3u];
            let _e135 = (_e122.x - (_e120.x * _e128));
            let _e136 = (_e122.y - (_e120.y * _e128));
            let _e137 = (_e122.z - (_e120.z * _e128));
            let _e139 = samples.member[_e67.first_primitive].normal;
            if ((((_e139.x * _e135) + (_e139.y * _e136)) + (_e139.z * _e137)) > 0f) {
                let _e153 = (((_e135 * _e135) + (_e136 * _e136)) + (_e137 * _e137));
                let _e155 = p.member.light.axis;
                let _e167 = p.member.light.place[3u];
                if (_e167 == 0f) {
                    phi_327_ = true;
                } else {
                    let _e170 = p.member.light.range_squared;
                    if (_e153 <= _e170) {
                        let _e173 = p.member.light.cos_outer;
                        phi_326_ = (-((((_e135 * _e155.x) + (_e136 * _e155.y)) + (_e137 * _e155.z))) >= (_e173 * sqrt(_e153)));
                    } else {
                        phi_326_ = false;
                    }
                    let _e178 = phi_326_;
                    phi_327_ = _e178;
                }
                let _e180 = phi_327_;
                if _e180 {
                    let _e182 = samples.member[_e67.first_primitive].flags;
                    let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e190.unnamed.visibility, false), _e190.unnamed_1);
                    phi_338_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e196.unnamed, ((_e182 & 1u) == 0u));
                    phi_339_ = false;
                } else {
                    phi_338_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_339_ = true;
                }
                let _e201 = phi_338_;
                let _e203 = phi_339_;
                phi_340_ = _e201;
                phi_341_ = _e203;
            } else {
                phi_340_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_341_ = true;
            }
            let _e205 = phi_340_;
            let _e207 = phi_341_;
            if _e207 {
                let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
                phi_348_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
            } else {
                phi_348_ = _e205;
            }
            let _e224 = phi_348_;
            phi_352_ = _e224;
        } else {
            let _e230 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e236 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e230.unnamed.visibility, false), _e230.unnamed_1);
            phi_352_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e236.unnamed, true);
        }
        let _e241 = phi_352_;
        if _e241.unnamed_1 {
            phi_960_ = mask_Masked(_e241.unnamed.visibility, 0u, false, false);
        } else {
            let _e246 = (_e88 < 0.5f);
            if (_e88 > 0f) {
                phi_365_ = (_e88 < 1f);
            } else {
                phi_365_ = false;
            }
            let _e250 = phi_365_;
            let _e257 = lt_mask_Reprojection(vec2<u32>(_e50.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e264 = lt_mask_Reprojection(vec2<u32>(_e257.pixel.x, _e50.y), _e257.is_valid, _e257.has_moved);
            let _e268 = lt_mask_Reprojection(_e264.pixel, true, _e264.has_moved);
            let _e274 = p.member.flags;
            if ((_e274 & 16u) == 0u) {
                phi_404_ = false;
            } else {
                let _e280 = samples.member[_e67.first_primitive].position[0u];
                if (_e86.x == _e280) {
                    let _e284 = samples.member[_e67.first_primitive].position[1u];
                    if (_e86.y == _e284) {
                        let _e288 = samples.member[_e67.first_primitive].position[2u];
                        phi_396_ = (_e86.z == _e288);
                        phi_397_ = false;
                    } else {
                        phi_396_ = bool();
                        phi_397_ = true;
                    }
                    let _e291 = phi_396_;
                    let _e293 = phi_397_;
                    phi_398_ = _e291;
                    phi_399_ = _e293;
                } else {
                    phi_398_ = bool();
                    phi_399_ = true;
                }
                let _e295 = phi_398_;
                let _e297 = phi_399_;
                if _e297 {
                    phi_403_ = false;
                } else {
                    phi_403_ = _e295;
                }
                let _e299 = phi_403_;
                phi_404_ = _e299;
            }
            let _e301 = phi_404_;
            if _e301 {
                phi_715_ = lt_mask_Reprojection(_e268.pixel, _e268.is_valid, false);
                phi_716_ = lt_mask_Reprojection();
                phi_717_ = true;
            } else {
                let _e305 = p.member.current.grid[0u];
                let _e307 = p.member.current.grid[1u];
                let _e321 = (f32(_e50.x) + ((f32((_e50.y & (_e307 - 1u))) + 0.5f) / f32(_e307)));
                let _e323 = (f32(_e50.y) + ((f32((_e50.x & (_e305 - 1u))) + 0.5f) / f32(_e305)));
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
                        phi_543_ = 1f;
                    } else {
                        phi_543_ = 0f;
                    }
                    let _e434 = phi_543_;
                    if (_e419 < 8388608f) {
                        phi_548_ = (_e431 - _e434);
                        phi_549_ = false;
                    } else {
                        phi_548_ = f32();
                        phi_549_ = true;
                    }
                    let _e437 = phi_548_;
                    let _e439 = phi_549_;
                    phi_550_ = _e437;
                    phi_551_ = _e439;
                } else {
                    phi_550_ = f32();
                    phi_551_ = true;
                }
                let _e441 = phi_550_;
                let _e443 = phi_551_;
                if _e443 {
                    phi_555_ = _e419;
                } else {
                    phi_555_ = _e441;
                }
                let _e445 = phi_555_;
                let _e446 = (_e323 + _e411);
                if (_e446 > -8388608f) {
                    let _e458 = f32(select(0i, select(select(i32(_e446), i32(-2147483648), (_e446 < bitcast<f32>(3472883712u))), 2147483647i, (_e446 > bitcast<f32>(1325400063u))), (_e446 == _e446)));
                    if (_e458 > _e446) {
                        phi_576_ = 1f;
                    } else {
                        phi_576_ = 0f;
                    }
                    let _e461 = phi_576_;
                    if (_e446 < 8388608f) {
                        phi_581_ = (_e458 - _e461);
                        phi_582_ = false;
                    } else {
                        phi_581_ = f32();
                        phi_582_ = true;
                    }
                    let _e464 = phi_581_;
                    let _e466 = phi_582_;
                    phi_583_ = _e464;
                    phi_584_ = _e466;
                } else {
                    phi_583_ = f32();
                    phi_584_ = true;
                }
                let _e468 = phi_583_;
                let _e470 = phi_584_;
                if _e470 {
                    phi_588_ = _e446;
                } else {
                    phi_588_ = _e468;
                }
                let _e472 = phi_588_;
                if (_e445 >= 0f) {
                    if (_e472 >= 0f) {
                        if (_e445 < f32(_e415)) {
                            let _e478 = (_e472 < f32(_e417));
                            if (_e410 == 0f) {
                                phi_609_ = (_e411 == 0f);
                            } else {
                                phi_609_ = false;
                            }
                            let _e482 = phi_609_;
                            if _e478 {
                                phi_628_ = vec2<u32>(select(select(u32(_e445), 0u, (_e445 < bitcast<f32>(0u))), 4294967295u, (_e445 > bitcast<f32>(1333788671u))), select(select(u32(_e472), 0u, (_e472 < bitcast<f32>(0u))), 4294967295u, (_e472 > bitcast<f32>(1333788671u))));
                                phi_629_ = false;
                            } else {
                                phi_628_ = vec2<u32>();
                                phi_629_ = true;
                            }
                            let _e499 = phi_628_;
                            let _e501 = phi_629_;
                            phi_630_ = _e482;
                            phi_631_ = _e478;
                            phi_632_ = _e499;
                            phi_633_ = _e482;
                            phi_634_ = _e478;
                            phi_635_ = false;
                            phi_636_ = _e501;
                        } else {
                            phi_630_ = bool();
                            phi_631_ = bool();
                            phi_632_ = vec2<u32>();
                            phi_633_ = bool();
                            phi_634_ = bool();
                            phi_635_ = true;
                            phi_636_ = false;
                        }
                        let _e503 = phi_630_;
                        let _e505 = phi_631_;
                        let _e507 = phi_632_;
                        let _e509 = phi_633_;
                        let _e511 = phi_634_;
                        let _e513 = phi_635_;
                        let _e515 = phi_636_;
                        phi_637_ = _e503;
                        phi_638_ = _e505;
                        phi_639_ = _e507;
                        phi_640_ = _e509;
                        phi_641_ = _e511;
                        phi_642_ = _e513;
                        phi_643_ = _e515;
                    } else {
                        phi_637_ = bool();
                        phi_638_ = bool();
                        phi_639_ = vec2<u32>();
                        phi_640_ = bool();
                        phi_641_ = bool();
                        phi_642_ = true;
                        phi_643_ = false;
                    }
                    let _e517 = phi_637_;
                    let _e519 = phi_638_;
                    let _e521 = phi_639_;
                    let _e523 = phi_640_;
                    let _e525 = phi_641_;
                    let _e527 = phi_642_;
                    let _e529 = phi_643_;
                    phi_644_ = _e517;
                    phi_645_ = _e519;
                    phi_646_ = _e521;
                    phi_647_ = _e523;
                    phi_648_ = _e525;
                    phi_649_ = _e527;
                    phi_650_ = _e529;
                } else {
                    phi_644_ = bool();
                    phi_645_ = bool();
                    phi_646_ = vec2<u32>();
                    phi_647_ = bool();
                    phi_648_ = bool();
                    phi_649_ = true;
                    phi_650_ = false;
                }
                let _e531 = phi_644_;
                let _e533 = phi_645_;
                let _e535 = phi_646_;
                let _e537 = phi_647_;
                let _e539 = phi_648_;
                let _e541 = phi_649_;
                let _e543 = phi_650_;
                if _e541 {
                    if (_e410 == 0f) {
                        phi_659_ = (_e411 == 0f);
                    } else {
                        phi_659_ = false;
                    }
                    let _e547 = phi_659_;
                    phi_660_ = _e547;
                    phi_661_ = false;
                    phi_662_ = true;
                } else {
                    phi_660_ = _e537;
                    phi_661_ = _e539;
                    phi_662_ = _e543;
                }
                let _e549 = phi_660_;
                let _e551 = phi_661_;
                let _e553 = phi_662_;
                if _e553 {
                    phi_666_ = _e549;
                    phi_667_ = _e551;
                    phi_668_ = vec2<u32>(_e50.x, _e50.y);
                } else {
                    phi_666_ = _e531;
                    phi_667_ = _e533;
                    phi_668_ = _e535;
                }
                let _e555 = phi_666_;
                let _e557 = phi_667_;
                let _e559 = phi_668_;
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
                        phi_706_ = false;
                    } else {
                        phi_706_ = true;
                    }
                    let _e613 = phi_706_;
                    phi_708_ = _e611;
                    phi_709_ = _e611;
                    phi_710_ = _e613;
                } else {
                    phi_708_ = lt_mask_Reprojection();
                    phi_709_ = lt_mask_Reprojection(_e584.pixel, false, _e584.has_moved);
                    phi_710_ = true;
                }
                let _e619 = phi_708_;
                let _e621 = phi_709_;
                let _e623 = phi_710_;
                if _e623 {
                    phi_714_ = false;
                } else {
                    phi_714_ = true;
                }
                let _e625 = phi_714_;
                phi_715_ = _e619;
                phi_716_ = _e621;
                phi_717_ = _e625;
            }
            let _e627 = phi_715_;
            let _e629 = phi_716_;
            let _e631 = phi_717_;
            if _e631 {
                let _e633 = p.member.flags;
                phi_725_ = ((_e633 & 1u) != 0u);
                phi_726_ = _e627;
            } else {
                phi_725_ = false;
                phi_726_ = _e629;
            }
            let _e637 = phi_725_;
            let _e639 = phi_726_;
            let _e643 = lt_mask_Reprojection(_e639.pixel, _e637, _e639.has_moved);
            let _e644 = lt_mask_Neighbourhood(false, true);
            if _e250 {
                phi_732_ = false;
            } else {
                phi_732_ = true;
            }
            let _e646 = phi_732_;
            if _e646 {
                if _e637 {
                    if ((0u & 2u) != 0u) {
                        phi_772_ = _e644;
                    } else {
                        let _e663 = ((((_e643.pixel.y * _e83) + (_e643.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e246) | (select(0u, 1u, _e643.has_moved) << bitcast<u32>(1i))));
                        if (_e663 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e667 = heard.member[(0u + _e663)];
                        let _e673 = (((_e667 >> bitcast<u32>(((_e643.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_772_ = lt_mask_Neighbourhood(_e673, !(_e673));
                    }
                    let _e677 = phi_772_;
                    phi_773_ = _e677;
                } else {
                    phi_773_ = _e644;
                }
                let _e679 = phi_773_;
                phi_774_ = _e679;
            } else {
                phi_774_ = _e644;
            }
            let _e681 = phi_774_;
            let _e684 = p.member.frame;
            let _e686 = p.member.refresh;
            if (_e686 == 0u) {
                phi_807_ = false;
            } else {
                if (_e686 == 0u) {
                    return;
                }
                let _e695 = ((_e50.x + (_e50.y * (((_e686 * 5u) / 8u) | 1u))) + (_e684 % _e686));
                if (_e686 == 0u) {
                    phi_806_ = (_e695 == 0u);
                } else {
                    if (_e686 == 0u) {
                        return;
                    }
                    phi_806_ = ((_e695 % _e686) == 0u);
                }
                let _e702 = phi_806_;
                phi_807_ = _e702;
            }
            let _e704 = phi_807_;
            if _e637 {
                if _e704 {
                    phi_829_ = bool();
                } else {
                    phi_829_ = ((0u & 2u) != 0u);
                }
                let _e710 = phi_829_;
                phi_830_ = _e710;
                phi_831_ = _e704;
            } else {
                phi_830_ = bool();
                phi_831_ = true;
            }
            let _e712 = phi_830_;
            let _e714 = phi_831_;
            if _e714 {
                phi_835_ = false;
            } else {
                phi_835_ = _e712;
            }
            let _e716 = phi_835_;
            if _e716 {
                phi_886_ = 7u;
            } else {
                if (_e88 != 0.5f) {
                    if _e637 {
                        if _e704 {
                            phi_883_ = 6u;
                        } else {
                            if _e250 {
                                phi_858_ = true;
                            } else {
                                if _e681.any_expands {
                                    phi_857_ = false;
                                } else {
                                    phi_857_ = true;
                                }
                                let _e718 = phi_857_;
                                phi_858_ = _e718;
                            }
                            let _e720 = phi_858_;
                            if _e720 {
                                if _e250 {
                                    if false {
                                        if _e681.all_remove {
                                            phi_871_ = false;
                                        } else {
                                            phi_871_ = true;
                                        }
                                        let _e722 = phi_871_;
                                        phi_872_ = _e722;
                                    } else {
                                        phi_872_ = true;
                                    }
                                    let _e724 = phi_872_;
                                    phi_873_ = _e724;
                                } else {
                                    phi_873_ = true;
                                }
                                let _e726 = phi_873_;
                                if _e726 {
                                    if _e250 {
                                        phi_880_ = 1u;
                                    } else {
                                        phi_880_ = 0u;
                                    }
                                    let _e728 = phi_880_;
                                    phi_881_ = _e728;
                                } else {
                                    phi_881_ = 5u;
                                }
                                let _e730 = phi_881_;
                                phi_882_ = _e730;
                            } else {
                                phi_882_ = 4u;
                            }
                            let _e732 = phi_882_;
                            phi_883_ = _e732;
                        }
                        let _e734 = phi_883_;
                        phi_884_ = _e734;
                    } else {
                        phi_884_ = 3u;
                    }
                    let _e736 = phi_884_;
                    phi_885_ = _e736;
                } else {
                    phi_885_ = 2u;
                }
                let _e738 = phi_885_;
                phi_886_ = _e738;
            }
            let _e740 = phi_886_;
            if !((_e740 == 0u)) {
                if !((_e740 == 5u)) {
                    phi_898_ = !(_e716);
                    phi_899_ = false;
                } else {
                    phi_898_ = bool();
                    phi_899_ = true;
                }
                let _e747 = phi_898_;
                let _e749 = phi_899_;
                phi_900_ = _e747;
                phi_901_ = _e749;
            } else {
                phi_900_ = bool();
                phi_901_ = true;
            }
            let _e751 = phi_900_;
            let _e753 = phi_901_;
            if _e753 {
                phi_905_ = false;
            } else {
                phi_905_ = _e751;
            }
            let _e755 = phi_905_;
            if _e716 {
                phi_911_ = ((0u & 4u) != 0u);
            } else {
                phi_911_ = _e246;
            }
            let _e759 = phi_911_;
            if _e755 {
                if _e246 {
                    phi_919_ = (2u | 1u);
                } else {
                    phi_919_ = 2u;
                }
                let _e762 = phi_919_;
                if false {
                    phi_924_ = (_e762 | 4u);
                } else {
                    phi_924_ = _e762;
                }
                let _e765 = phi_924_;
                phi_944_ = _e765;
            } else {
                if (_e740 == 7u) {
                    if _e246 {
                        phi_933_ = (2u | 1u);
                    } else {
                        phi_933_ = 2u;
                    }
                    let _e769 = phi_933_;
                    if _e759 {
                        phi_938_ = (_e769 | 4u);
                    } else {
                        phi_938_ = _e769;
                    }
                    let _e772 = phi_938_;
                    phi_943_ = _e772;
                } else {
                    if _e246 {
                        phi_942_ = 1u;
                    } else {
                        phi_942_ = 0u;
                    }
                    let _e774 = phi_942_;
                    phi_943_ = _e774;
                }
                let _e776 = phi_943_;
                phi_944_ = _e776;
            }
            let _e778 = phi_944_;
            if _e759 {
                phi_948_ = 0f;
            } else {
                phi_948_ = 1f;
            }
            let _e780 = phi_948_;
            if _e250 {
                if (_e88 == 0.99999994f) {
                    phi_957_ = true;
                } else {
                    phi_957_ = (_e88 == 0.000000059604645f);
                }
                let _e784 = phi_957_;
                phi_958_ = _e784;
            } else {
                phi_958_ = true;
            }
            let _e786 = phi_958_;
            phi_960_ = mask_Masked(_e780, _e778, _e755, _e786);
        }
        let _e789 = phi_960_;
        visibility.member[_e67.first_primitive] = _e789.visibility;
        let _e794 = p.member.light.number;
        let _e795 = (_e794 * 3u);
        let _e797 = (_e795 % 32u);
        let _e799 = p.member.light.mask_words;
        let _e801 = ((_e67.first_primitive * _e799) + (_e795 / 32u));
        let _e803 = bits.member[_e801];
        bits.member[_e801] = ((_e803 & ~((7u << bitcast<u32>((_e797 & 31u))))) | (_e789.bits << bitcast<u32>((_e797 & 31u))));
        if (_e797 > 29u) {
            let _e818 = bits.member[(_e801 + 1u)];
            let _e820 = (32u - _e797);
            bits.member[(_e801 + 1u)] = ((_e818 & ~((7u >> bitcast<u32>((_e820 & 31u))))) | (_e789.bits >> bitcast<u32>((_e820 & 31u))));
        }
        phi_1012_ = doubt_Listed(_e67.first_primitive, _e789.is_trusted);
        phi_1013_ = _e789.needs_ray;
    } else {
        phi_1012_ = doubt_Listed(0u, false);
        phi_1013_ = false;
    }
    let _e836 = phi_1012_;
    let _e838 = phi_1013_;
    if (_e51 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e838 {
        let _e844 = atomicAdd((&shared_[0u]), 1u);
        phi_1026_ = _e844;
    } else {
        phi_1026_ = 0u;
    }
    let _e846 = phi_1026_;
    workgroupBarrier();
    if (_e51 == 0u) {
        let _e850 = atomicLoad((&shared_[0u]));
        let _e851 = atomicAdd((&list.member[3u]), _e850);
        atomicStore((&shared_[1u]), _e851);
    }
    workgroupBarrier();
    if _e838 {
        if _e836.is_trusted {
            phi_1043_ = (_e836.pixel | 2147483648u);
        } else {
            phi_1043_ = _e836.pixel;
        }
        let _e855 = phi_1043_;
        let _e857 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e857) + _e846)]), _e855);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
