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
    var phi_175_: lt_bvh_traverse_Tree;
    var phi_176_: bool;
    var phi_177_: lt_bvh_traverse_Tree;
    var phi_178_: bool;
    var phi_183_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_175_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_176_ = false;
        } else {
            phi_175_ = lt_bvh_traverse_Tree();
            phi_176_ = true;
        }
        let _e68 = phi_175_;
        let _e70 = phi_176_;
        phi_177_ = _e68;
        phi_178_ = _e70;
    } else {
        phi_177_ = lt_bvh_traverse_Tree();
        phi_178_ = true;
    }
    let _e72 = phi_177_;
    let _e74 = phi_178_;
    if _e74 {
        phi_183_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_183_ = _e72;
    }
    let _e79 = phi_183_;
    return lt_bvh_traverse_Tree(_e79.root, _e79.first_primitive);
}

fn function_() {
    var phi_256_: bool;
    var phi_257_: bool;
    var phi_258_: bool;
    var phi_259_: bool;
    var phi_263_: bool;
    var phi_333_: bool;
    var phi_334_: bool;
    var phi_345_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_346_: bool;
    var phi_347_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_348_: bool;
    var phi_355_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_359_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_372_: bool;
    var phi_400_: bool;
    var phi_401_: bool;
    var phi_402_: bool;
    var phi_403_: bool;
    var phi_407_: bool;
    var phi_408_: bool;
    var phi_544_: f32;
    var phi_549_: f32;
    var phi_550_: bool;
    var phi_551_: f32;
    var phi_552_: bool;
    var phi_556_: f32;
    var phi_577_: f32;
    var phi_582_: f32;
    var phi_583_: bool;
    var phi_584_: f32;
    var phi_585_: bool;
    var phi_589_: f32;
    var phi_610_: bool;
    var phi_629_: vec2<u32>;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_632_: bool;
    var phi_633_: vec2<u32>;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_636_: bool;
    var phi_637_: bool;
    var phi_638_: bool;
    var phi_639_: bool;
    var phi_640_: vec2<u32>;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_643_: bool;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: vec2<u32>;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_669_: vec2<u32>;
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
    var phi_767_: bool;
    var phi_771_: f32;
    var phi_775_: lt_mask_Reprojection;
    var phi_776_: bool;
    var phi_788_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_791_: lt_mask_Reprojection;
    var phi_792_: bool;
    var phi_796_: bool;
    var phi_797_: lt_mask_Reprojection;
    var phi_803_: bool;
    var phi_835_: u32;
    var phi_864_: lt_mask_Neighbourhood;
    var phi_865_: lt_mask_Neighbourhood;
    var phi_866_: lt_mask_Neighbourhood;
    var phi_898_: bool;
    var phi_899_: bool;
    var phi_921_: bool;
    var phi_922_: bool;
    var phi_923_: bool;
    var phi_927_: bool;
    var phi_949_: bool;
    var phi_950_: bool;
    var phi_963_: bool;
    var phi_964_: bool;
    var phi_965_: bool;
    var phi_972_: u32;
    var phi_973_: u32;
    var phi_974_: u32;
    var phi_975_: u32;
    var phi_976_: u32;
    var phi_977_: u32;
    var phi_978_: u32;
    var phi_990_: bool;
    var phi_991_: bool;
    var phi_992_: bool;
    var phi_993_: bool;
    var phi_997_: bool;
    var phi_1003_: bool;
    var phi_1011_: u32;
    var phi_1016_: u32;
    var phi_1025_: u32;
    var phi_1030_: u32;
    var phi_1034_: u32;
    var phi_1035_: u32;
    var phi_1036_: u32;
    var phi_1040_: f32;
    var phi_1049_: bool;
    var phi_1050_: bool;
    var phi_1052_: mask_Masked;
    var phi_1124_: bool;
    var phi_1125_: bool;
    var phi_1126_: bool;
    var phi_1127_: bool;
    var phi_1131_: bool;
    var phi_1159_: f32;
    var phi_1164_: doubt_Listed;
    var phi_1165_: bool;
    var phi_1178_: u32;
    var phi_1195_: u32;

    let _e55 = id_1;
    let _e56 = local_1;
    let _e74 = p.member.current.size[0u];
    let _e76 = p.member.current.size[1u];
    let _e77 = lt_shaders_entry_pixel_index(_e55, _e74, _e76);
    if (bitcast<i32>(_e77.root) != 0i) {
        let _e85 = p.member.current.size[0u];
        let _e88 = past.member[_e77.first_primitive];
        let _e93 = visibility.member[_e77.first_primitive];
        let _e99 = samples.member[_e77.first_primitive].normal[0u];
        let _e101 = global[0u];
        if (_e99 == _e101) {
            let _e104 = samples.member[_e77.first_primitive].normal[1u];
            let _e106 = global[1u];
            if (_e104 == _e106) {
                let _e109 = samples.member[_e77.first_primitive].normal[2u];
                let _e111 = global[2u];
                phi_256_ = (_e109 == _e111);
                phi_257_ = false;
            } else {
                phi_256_ = bool();
                phi_257_ = true;
            }
            let _e114 = phi_256_;
            let _e116 = phi_257_;
            phi_258_ = _e114;
            phi_259_ = _e116;
        } else {
            phi_258_ = bool();
            phi_259_ = true;
        }
        let _e118 = phi_258_;
        let _e120 = phi_259_;
        if _e120 {
            phi_263_ = false;
        } else {
            phi_263_ = _e118;
        }
        let _e122 = phi_263_;
        if !(_e122) {
            let _e125 = samples.member[_e77.first_primitive].position;
            let _e127 = p.member.light.place;
            let _e133 = p.member.light.place[3u];
            let _e140 = (_e127.x - (_e125.x * _e133));
            let _e141 = (_e127.y - (_e125.y * _e133));
            let _e142 = (_e127.z - (_e125.z * _e133));
            let _e144 = samples.member[_e77.first_primitive].normal;
            if ((((_e144.x * _e140) + (_e144.y * _e141)) + (_e144.z * _e142)) > 0f) {
                let _e158 = (((_e140 * _e140) + (_e141 * _e141)) + (_e142 * _e142));
                let _e160 = p.member.light.axis;
                let _e172 = p.member.light.place[3u];
                if (_e172 == 0f) {
                    phi_334_ = true;
                } else {
                    let _e175 = p.member.light.range_squared;
                    if (_e158 <= _e175) {
                        let _e178 = p.member.light.cos_outer;
                        phi_333_ = (-((((_e140 * _e160.x) + (_e141 * _e160.y)) + (_e142 * _e160.z))) >= (_e178 * sqrt(_e158)));
                    } else {
                        phi_333_ = false;
                    }
                    let _e183 = phi_333_;
                    phi_334_ = _e183;
                }
                let _e185 = phi_334_;
                if _e185 {
                    let _e187 = samples.member[_e77.first_primitive].flags;
                    let _e195 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e195.unnamed.visibility, false), _e195.unnamed_1);
                    phi_345_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e201.unnamed, ((_e187 & 1u) == 0u));
                    phi_346_ = false;
                } else {
                    phi_345_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_346_ = true;
                }
                let _e206 = phi_345_;
                let _e208 = phi_346_;
                phi_347_ = _e206;
                phi_348_ = _e208;
            } else {
                phi_347_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_348_ = true;
            }
            let _e210 = phi_347_;
            let _e212 = phi_348_;
            if _e212 {
                let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e224 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e218.unnamed.visibility, false), _e218.unnamed_1);
                phi_355_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e224.unnamed, true);
            } else {
                phi_355_ = _e210;
            }
            let _e229 = phi_355_;
            phi_359_ = _e229;
        } else {
            let _e235 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e241 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e235.unnamed.visibility, false), _e235.unnamed_1);
            phi_359_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e241.unnamed, true);
        }
        let _e246 = phi_359_;
        if _e246.unnamed_1 {
            phi_1052_ = mask_Masked(_e246.unnamed.visibility, 0u, false, false);
        } else {
            let _e251 = (_e93 < 0.5f);
            if (_e93 > 0f) {
                phi_372_ = (_e93 < 1f);
            } else {
                phi_372_ = false;
            }
            let _e255 = phi_372_;
            let _e262 = lt_mask_Reprojection(vec2<u32>(_e55.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e269 = lt_mask_Reprojection(vec2<u32>(_e262.pixel.x, _e55.y), _e262.is_valid, _e262.has_moved);
            let _e273 = lt_mask_Reprojection(_e269.pixel, true, _e269.has_moved);
            let _e279 = p.member.flags;
            if ((_e279 & 16u) == 0u) {
                phi_408_ = false;
            } else {
                let _e284 = samples.member[_e77.first_primitive].position[0u];
                if (_e88.x == _e284) {
                    let _e287 = samples.member[_e77.first_primitive].position[1u];
                    if (_e88.y == _e287) {
                        let _e290 = samples.member[_e77.first_primitive].position[2u];
                        phi_400_ = (_e88.z == _e290);
                        phi_401_ = false;
                    } else {
                        phi_400_ = bool();
                        phi_401_ = true;
                    }
                    let _e293 = phi_400_;
                    let _e295 = phi_401_;
                    phi_402_ = _e293;
                    phi_403_ = _e295;
                } else {
                    phi_402_ = bool();
                    phi_403_ = true;
                }
                let _e297 = phi_402_;
                let _e299 = phi_403_;
                if _e299 {
                    phi_407_ = false;
                } else {
                    phi_407_ = _e297;
                }
                let _e301 = phi_407_;
                phi_408_ = _e301;
            }
            let _e303 = phi_408_;
            if _e303 {
                phi_711_ = lt_mask_Reprojection(_e273.pixel, _e273.is_valid, false);
                phi_712_ = lt_mask_Reprojection();
                phi_713_ = lt_mask_Reprojection();
                phi_714_ = true;
                phi_715_ = false;
            } else {
                let _e307 = p.member.current.grid[0u];
                let _e309 = p.member.current.grid[1u];
                let _e323 = (f32(_e55.x) + ((f32((_e55.y & (_e309 - 1u))) + 0.5f) / f32(_e309)));
                let _e325 = (f32(_e55.y) + ((f32((_e55.x & (_e307 - 1u))) + 0.5f) / f32(_e307)));
                let _e328 = p.member.previous.eye;
                let _e330 = (_e88.x - _e328.x);
                let _e332 = (_e88.y - _e328.y);
                let _e334 = (_e88.z - _e328.z);
                let _e336 = p.member.previous.forward;
                let _e344 = (((_e330 * _e336.x) + (_e332 * _e336.y)) + (_e334 * _e336.z));
                let _e346 = p.member.previous.right;
                let _e356 = p.member.previous.right;
                let _e371 = p.member.previous.up;
                let _e381 = p.member.previous.up;
                let _e398 = p.member.previous.size[0u];
                let _e405 = p.member.previous.size[1u];
                let _e409 = (((((((_e330 * _e346.x) + (_e332 * _e346.y)) + (_e334 * _e346.z)) / ((((_e356.x * _e356.x) + (_e356.y * _e356.y)) + (_e356.z * _e356.z)) * _e344)) + 1f) * (0.5f * f32(_e398))) - _e323);
                let _e410 = (((1f - ((((_e330 * _e371.x) + (_e332 * _e371.y)) + (_e334 * _e371.z)) / ((((_e381.x * _e381.x) + (_e381.y * _e381.y)) + (_e381.z * _e381.z)) * _e344))) * (0.5f * f32(_e405))) - _e325);
                let _e414 = p.member.current.size[0u];
                let _e416 = p.member.current.size[1u];
                let _e418 = (_e323 + _e409);
                if (_e418 > -8388608f) {
                    let _e430 = f32(select(0i, select(select(i32(_e418), i32(-2147483648), (_e418 < bitcast<f32>(3472883712u))), 2147483647i, (_e418 > bitcast<f32>(1325400063u))), (_e418 == _e418)));
                    if (_e430 > _e418) {
                        phi_544_ = 1f;
                    } else {
                        phi_544_ = 0f;
                    }
                    let _e433 = phi_544_;
                    if (_e418 < 8388608f) {
                        phi_549_ = (_e430 - _e433);
                        phi_550_ = false;
                    } else {
                        phi_549_ = f32();
                        phi_550_ = true;
                    }
                    let _e436 = phi_549_;
                    let _e438 = phi_550_;
                    phi_551_ = _e436;
                    phi_552_ = _e438;
                } else {
                    phi_551_ = f32();
                    phi_552_ = true;
                }
                let _e440 = phi_551_;
                let _e442 = phi_552_;
                if _e442 {
                    phi_556_ = _e418;
                } else {
                    phi_556_ = _e440;
                }
                let _e444 = phi_556_;
                let _e445 = (_e325 + _e410);
                if (_e445 > -8388608f) {
                    let _e457 = f32(select(0i, select(select(i32(_e445), i32(-2147483648), (_e445 < bitcast<f32>(3472883712u))), 2147483647i, (_e445 > bitcast<f32>(1325400063u))), (_e445 == _e445)));
                    if (_e457 > _e445) {
                        phi_577_ = 1f;
                    } else {
                        phi_577_ = 0f;
                    }
                    let _e460 = phi_577_;
                    if (_e445 < 8388608f) {
                        phi_582_ = (_e457 - _e460);
                        phi_583_ = false;
                    } else {
                        phi_582_ = f32();
                        phi_583_ = true;
                    }
                    let _e463 = phi_582_;
                    let _e465 = phi_583_;
                    phi_584_ = _e463;
                    phi_585_ = _e465;
                } else {
                    phi_584_ = f32();
                    phi_585_ = true;
                }
                let _e467 = phi_584_;
                let _e469 = phi_585_;
                if _e469 {
                    phi_589_ = _e445;
                } else {
                    phi_589_ = _e467;
                }
                let _e471 = phi_589_;
                if (_e444 >= 0f) {
                    if (_e471 >= 0f) {
                        if (_e444 < f32(_e414)) {
                            let _e477 = (_e471 < f32(_e416));
                            if (_e409 == 0f) {
                                phi_610_ = (_e410 == 0f);
                            } else {
                                phi_610_ = false;
                            }
                            let _e481 = phi_610_;
                            if _e477 {
                                phi_629_ = vec2<u32>(select(select(u32(_e444), 0u, (_e444 < bitcast<f32>(0u))), 4294967295u, (_e444 > bitcast<f32>(1333788671u))), select(select(u32(_e471), 0u, (_e471 < bitcast<f32>(0u))), 4294967295u, (_e471 > bitcast<f32>(1333788671u))));
                                phi_630_ = false;
                            } else {
                                phi_629_ = vec2<u32>();
                                phi_630_ = true;
                            }
                            let _e498 = phi_629_;
                            let _e500 = phi_630_;
                            phi_631_ = _e481;
                            phi_632_ = _e477;
                            phi_633_ = _e498;
                            phi_634_ = _e481;
                            phi_635_ = _e477;
                            phi_636_ = false;
                            phi_637_ = _e500;
                        } else {
                            phi_631_ = bool();
                            phi_632_ = bool();
                            phi_633_ = vec2<u32>();
                            phi_634_ = bool();
                            phi_635_ = bool();
                            phi_636_ = true;
                            phi_637_ = false;
                        }
                        let _e502 = phi_631_;
                        let _e504 = phi_632_;
                        let _e506 = phi_633_;
                        let _e508 = phi_634_;
                        let _e510 = phi_635_;
                        let _e512 = phi_636_;
                        let _e514 = phi_637_;
                        phi_638_ = _e502;
                        phi_639_ = _e504;
                        phi_640_ = _e506;
                        phi_641_ = _e508;
                        phi_642_ = _e510;
                        phi_643_ = _e512;
                        phi_644_ = _e514;
                    } else {
                        phi_638_ = bool();
                        phi_639_ = bool();
                        phi_640_ = vec2<u32>();
                        phi_641_ = bool();
                        phi_642_ = bool();
                        phi_643_ = true;
                        phi_644_ = false;
                    }
                    let _e516 = phi_638_;
                    let _e518 = phi_639_;
                    let _e520 = phi_640_;
                    let _e522 = phi_641_;
                    let _e524 = phi_642_;
                    let _e526 = phi_643_;
                    let _e528 = phi_644_;
                    phi_645_ = _e516;
                    phi_646_ = _e518;
                    phi_647_ = _e520;
                    phi_648_ = _e522;
                    phi_649_ = _e524;
                    phi_650_ = _e526;
                    phi_651_ = _e528;
                } else {
                    phi_645_ = bool();
                    phi_646_ = bool();
                    phi_647_ = vec2<u32>();
                    phi_648_ = bool();
                    phi_649_ = bool();
                    phi_650_ = true;
                    phi_651_ = false;
                }
                let _e530 = phi_645_;
                let _e532 = phi_646_;
                let _e534 = phi_647_;
                let _e536 = phi_648_;
                let _e538 = phi_649_;
                let _e540 = phi_650_;
                let _e542 = phi_651_;
                if _e540 {
                    if (_e409 == 0f) {
                        phi_660_ = (_e410 == 0f);
                    } else {
                        phi_660_ = false;
                    }
                    let _e546 = phi_660_;
                    phi_661_ = _e546;
                    phi_662_ = false;
                    phi_663_ = true;
                } else {
                    phi_661_ = _e536;
                    phi_662_ = _e538;
                    phi_663_ = _e542;
                }
                let _e548 = phi_661_;
                let _e550 = phi_662_;
                let _e552 = phi_663_;
                if _e552 {
                    phi_667_ = _e548;
                    phi_668_ = _e550;
                    phi_669_ = vec2<u32>(_e55.x, _e55.y);
                } else {
                    phi_667_ = _e530;
                    phi_668_ = _e532;
                    phi_669_ = _e534;
                }
                let _e554 = phi_667_;
                let _e556 = phi_668_;
                let _e558 = phi_669_;
                let _e568 = lt_mask_Reprojection(vec2<u32>(_e558.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e575 = lt_mask_Reprojection(vec2<u32>(_e568.pixel.x, _e558.y), _e568.is_valid, _e568.has_moved);
                let _e579 = lt_mask_Reprojection(_e575.pixel, _e556, _e575.has_moved);
                let _e583 = lt_mask_Reprojection(_e579.pixel, _e579.is_valid, !(_e554));
                if _e556 {
                    let _e586 = p.member.previous.eye;
                    let _e594 = p.member.previous.forward;
                    let _e603 = (((((_e88.x - _e586.x) * _e594.x) + ((_e88.y - _e586.y) * _e594.y)) + ((_e88.z - _e586.z) * _e594.z)) > 0f);
                    let _e607 = lt_mask_Reprojection(_e583.pixel, _e603, _e583.has_moved);
                    if _e603 {
                        phi_704_ = false;
                    } else {
                        phi_704_ = true;
                    }
                    let _e609 = phi_704_;
                    phi_706_ = _e607;
                    phi_707_ = _e607;
                    phi_708_ = lt_mask_Reprojection();
                    phi_709_ = _e603;
                    phi_710_ = _e609;
                } else {
                    phi_706_ = lt_mask_Reprojection();
                    phi_707_ = lt_mask_Reprojection();
                    phi_708_ = lt_mask_Reprojection(_e583.pixel, false, _e583.has_moved);
                    phi_709_ = false;
                    phi_710_ = false;
                }
                let _e615 = phi_706_;
                let _e617 = phi_707_;
                let _e619 = phi_708_;
                let _e621 = phi_709_;
                let _e623 = phi_710_;
                phi_711_ = _e615;
                phi_712_ = _e617;
                phi_713_ = _e619;
                phi_714_ = _e621;
                phi_715_ = _e623;
            }
            let _e625 = phi_711_;
            let _e627 = phi_712_;
            let _e629 = phi_713_;
            let _e631 = phi_714_;
            let _e633 = phi_715_;
            if _e631 {
                let _e636 = p.member.previous.eye;
                let _e644 = p.member.previous.forward;
                let _e652 = ((((_e88.x - _e636.x) * _e644.x) + ((_e88.y - _e636.y) * _e644.y)) + ((_e88.z - _e636.z) * _e644.z));
                let _e658 = ((_e625.pixel.y * _e85) + _e625.pixel.x);
                if (_e658 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e662 = last_depths.member[(0u + _e658)];
                let _e664 = p.member.depth_tolerance;
                let _e667 = abs(_e652);
                let _e668 = abs(_e662);
                if ((bitcast<u32>(_e668) & 2147483647u) > 2139095040u) {
                    phi_767_ = true;
                } else {
                    let _e672 = (_e668 > _e667);
                    if _e672 {
                    }
                    phi_767_ = _e672;
                }
                let _e674 = phi_767_;
                if _e674 {
                    phi_771_ = _e668;
                } else {
                    phi_771_ = _e667;
                }
                let _e676 = phi_771_;
                phi_775_ = lt_mask_Reprojection(_e625.pixel, (abs((_e652 - _e662)) <= (_e664 * _e676)), _e625.has_moved);
                phi_776_ = true;
            } else {
                phi_775_ = _e627;
                phi_776_ = _e633;
            }
            let _e684 = phi_775_;
            let _e686 = phi_776_;
            if _e686 {
                if _e684.is_valid {
                    let _e689 = p.member.flags;
                    phi_788_ = ((_e689 & 1u) != 0u);
                    phi_789_ = false;
                } else {
                    phi_788_ = bool();
                    phi_789_ = true;
                }
                let _e693 = phi_788_;
                let _e695 = phi_789_;
                phi_790_ = _e693;
                phi_791_ = _e684;
                phi_792_ = _e695;
            } else {
                phi_790_ = bool();
                phi_791_ = _e629;
                phi_792_ = true;
            }
            let _e697 = phi_790_;
            let _e699 = phi_791_;
            let _e701 = phi_792_;
            if _e701 {
                phi_796_ = false;
                phi_797_ = _e699;
            } else {
                phi_796_ = _e697;
                phi_797_ = _e684;
            }
            let _e703 = phi_796_;
            let _e705 = phi_797_;
            let _e709 = lt_mask_Reprojection(_e705.pixel, _e703, _e705.has_moved);
            let _e710 = lt_mask_Neighbourhood(false, true);
            if _e255 {
                phi_803_ = false;
            } else {
                phi_803_ = true;
            }
            let _e712 = phi_803_;
            if _e712 {
                if _e703 {
                    if ((0u & 2u) != 0u) {
                        phi_864_ = _e710;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e721 = (_e85 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e85 % 32u) > 0u) {
                            phi_835_ = (_e721 + 1u);
                        } else {
                            phi_835_ = _e721;
                        }
                        let _e727 = phi_835_;
                        let _e737 = ((((_e709.pixel.y * _e727) + (_e709.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e251) | (select(0u, 1u, _e709.has_moved) << bitcast<u32>(1i))));
                        if (_e737 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e741 = heard.member[(0u + _e737)];
                        let _e747 = (((_e741 >> bitcast<u32>(((_e709.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_864_ = lt_mask_Neighbourhood(_e747, !(_e747));
                    }
                    let _e751 = phi_864_;
                    phi_865_ = _e751;
                } else {
                    phi_865_ = _e710;
                }
                let _e753 = phi_865_;
                phi_866_ = _e753;
            } else {
                phi_866_ = _e710;
            }
            let _e755 = phi_866_;
            let _e758 = p.member.frame;
            let _e760 = p.member.refresh;
            if (_e760 == 0u) {
                phi_899_ = false;
            } else {
                if (_e760 == 0u) {
                    return;
                }
                let _e769 = ((_e55.x + (_e55.y * (((_e760 * 5u) / 8u) | 1u))) + (_e758 % _e760));
                if (_e760 == 0u) {
                    phi_898_ = (_e769 == 0u);
                } else {
                    if (_e760 == 0u) {
                        return;
                    }
                    phi_898_ = ((_e769 % _e760) == 0u);
                }
                let _e776 = phi_898_;
                phi_899_ = _e776;
            }
            let _e778 = phi_899_;
            if _e703 {
                if _e778 {
                    phi_921_ = bool();
                } else {
                    phi_921_ = ((0u & 2u) != 0u);
                }
                let _e784 = phi_921_;
                phi_922_ = _e784;
                phi_923_ = _e778;
            } else {
                phi_922_ = bool();
                phi_923_ = true;
            }
            let _e786 = phi_922_;
            let _e788 = phi_923_;
            if _e788 {
                phi_927_ = false;
            } else {
                phi_927_ = _e786;
            }
            let _e790 = phi_927_;
            if _e790 {
                phi_978_ = 7u;
            } else {
                if (_e93 != 0.5f) {
                    if _e703 {
                        if _e778 {
                            phi_975_ = 6u;
                        } else {
                            if _e255 {
                                phi_950_ = true;
                            } else {
                                if _e755.any_expands {
                                    phi_949_ = false;
                                } else {
                                    phi_949_ = true;
                                }
                                let _e792 = phi_949_;
                                phi_950_ = _e792;
                            }
                            let _e794 = phi_950_;
                            if _e794 {
                                if _e255 {
                                    if false {
                                        if _e755.all_remove {
                                            phi_963_ = false;
                                        } else {
                                            phi_963_ = true;
                                        }
                                        let _e796 = phi_963_;
                                        phi_964_ = _e796;
                                    } else {
                                        phi_964_ = true;
                                    }
                                    let _e798 = phi_964_;
                                    phi_965_ = _e798;
                                } else {
                                    phi_965_ = true;
                                }
                                let _e800 = phi_965_;
                                if _e800 {
                                    if _e255 {
                                        phi_972_ = 1u;
                                    } else {
                                        phi_972_ = 0u;
                                    }
                                    let _e802 = phi_972_;
                                    phi_973_ = _e802;
                                } else {
                                    phi_973_ = 5u;
                                }
                                let _e804 = phi_973_;
                                phi_974_ = _e804;
                            } else {
                                phi_974_ = 4u;
                            }
                            let _e806 = phi_974_;
                            phi_975_ = _e806;
                        }
                        let _e808 = phi_975_;
                        phi_976_ = _e808;
                    } else {
                        phi_976_ = 3u;
                    }
                    let _e810 = phi_976_;
                    phi_977_ = _e810;
                } else {
                    phi_977_ = 2u;
                }
                let _e812 = phi_977_;
                phi_978_ = _e812;
            }
            let _e814 = phi_978_;
            if !((_e814 == 0u)) {
                if !((_e814 == 5u)) {
                    phi_990_ = !(_e790);
                    phi_991_ = false;
                } else {
                    phi_990_ = bool();
                    phi_991_ = true;
                }
                let _e821 = phi_990_;
                let _e823 = phi_991_;
                phi_992_ = _e821;
                phi_993_ = _e823;
            } else {
                phi_992_ = bool();
                phi_993_ = true;
            }
            let _e825 = phi_992_;
            let _e827 = phi_993_;
            if _e827 {
                phi_997_ = false;
            } else {
                phi_997_ = _e825;
            }
            let _e829 = phi_997_;
            if _e790 {
                phi_1003_ = ((0u & 4u) != 0u);
            } else {
                phi_1003_ = _e251;
            }
            let _e833 = phi_1003_;
            if _e829 {
                if _e251 {
                    phi_1011_ = (2u | 1u);
                } else {
                    phi_1011_ = 2u;
                }
                let _e836 = phi_1011_;
                if false {
                    phi_1016_ = (_e836 | 4u);
                } else {
                    phi_1016_ = _e836;
                }
                let _e839 = phi_1016_;
                phi_1036_ = _e839;
            } else {
                if (_e814 == 7u) {
                    if _e251 {
                        phi_1025_ = (2u | 1u);
                    } else {
                        phi_1025_ = 2u;
                    }
                    let _e843 = phi_1025_;
                    if _e833 {
                        phi_1030_ = (_e843 | 4u);
                    } else {
                        phi_1030_ = _e843;
                    }
                    let _e846 = phi_1030_;
                    phi_1035_ = _e846;
                } else {
                    if _e251 {
                        phi_1034_ = 1u;
                    } else {
                        phi_1034_ = 0u;
                    }
                    let _e848 = phi_1034_;
                    phi_1035_ = _e848;
                }
                let _e850 = phi_1035_;
                phi_1036_ = _e850;
            }
            let _e852 = phi_1036_;
            if _e833 {
                phi_1040_ = 0f;
            } else {
                phi_1040_ = 1f;
            }
            let _e854 = phi_1040_;
            if _e255 {
                if (_e93 == 0.99999994f) {
                    phi_1049_ = true;
                } else {
                    phi_1049_ = (_e93 == 0.000000059604645f);
                }
                let _e858 = phi_1049_;
                phi_1050_ = _e858;
            } else {
                phi_1050_ = true;
            }
            let _e860 = phi_1050_;
            phi_1052_ = mask_Masked(_e854, _e852, _e829, _e860);
        }
        let _e863 = phi_1052_;
        visibility.member[_e77.first_primitive] = _e863.visibility;
        let _e868 = p.member.light.number;
        let _e869 = (_e868 * 3u);
        let _e871 = (_e869 % 32u);
        let _e873 = p.member.light.mask_words;
        let _e875 = ((_e77.first_primitive * _e873) + (_e869 / 32u));
        let _e877 = bits.member[_e875];
        bits.member[_e875] = ((_e877 & ~((7u << bitcast<u32>((_e871 & 31u))))) | (_e863.bits << bitcast<u32>((_e871 & 31u))));
        if (_e871 > 29u) {
            let _e892 = bits.member[(_e875 + 1u)];
            let _e894 = (32u - _e871);
            bits.member[(_e875 + 1u)] = ((_e892 & ~((7u >> bitcast<u32>((_e894 & 31u))))) | (_e863.bits >> bitcast<u32>((_e894 & 31u))));
        }
        let _e909 = samples.member[_e77.first_primitive].normal[0u];
        let _e911 = global[0u];
        if (_e909 == _e911) {
            let _e914 = samples.member[_e77.first_primitive].normal[1u];
            let _e916 = global[1u];
            if (_e914 == _e916) {
                let _e919 = samples.member[_e77.first_primitive].normal[2u];
                let _e921 = global[2u];
                phi_1124_ = (_e919 == _e921);
                phi_1125_ = false;
            } else {
                phi_1124_ = bool();
                phi_1125_ = true;
            }
            let _e924 = phi_1124_;
            let _e926 = phi_1125_;
            phi_1126_ = _e924;
            phi_1127_ = _e926;
        } else {
            phi_1126_ = bool();
            phi_1127_ = true;
        }
        let _e928 = phi_1126_;
        let _e930 = phi_1127_;
        if _e930 {
            phi_1131_ = false;
        } else {
            phi_1131_ = _e928;
        }
        let _e932 = phi_1131_;
        if !(_e932) {
            let _e935 = samples.member[_e77.first_primitive].position;
            let _e937 = p.member.current.eye;
            let _e948 = p.member.current.forward;
            phi_1159_ = ((((_e935.x - _e937.x) * _e948.x) + ((_e935.y - _e937.y) * _e948.y)) + ((_e935.z - _e937.z) * _e948.z));
        } else {
            phi_1159_ = 0f;
        }
        let _e958 = phi_1159_;
        depths.member[_e77.first_primitive] = _e958;
        phi_1164_ = doubt_Listed(_e77.first_primitive, _e863.is_trusted);
        phi_1165_ = _e863.needs_ray;
    } else {
        phi_1164_ = doubt_Listed(0u, false);
        phi_1165_ = false;
    }
    let _e964 = phi_1164_;
    let _e966 = phi_1165_;
    if (_e56 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e966 {
        let _e972 = atomicAdd((&shared_[0u]), 1u);
        phi_1178_ = _e972;
    } else {
        phi_1178_ = 0u;
    }
    let _e974 = phi_1178_;
    workgroupBarrier();
    if (_e56 == 0u) {
        let _e978 = atomicLoad((&shared_[0u]));
        let _e979 = atomicAdd((&list.member[3u]), _e978);
        atomicStore((&shared_[1u]), _e979);
    }
    workgroupBarrier();
    if _e966 {
        if _e964.is_trusted {
            phi_1195_ = (_e964.pixel | 2147483648u);
        } else {
            phi_1195_ = _e964.pixel;
        }
        let _e983 = phi_1195_;
        let _e985 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e985) + _e974)]), _e983);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
