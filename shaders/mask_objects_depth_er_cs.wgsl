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
    var phi_551_: f32;
    var phi_556_: f32;
    var phi_557_: bool;
    var phi_558_: f32;
    var phi_559_: bool;
    var phi_563_: f32;
    var phi_584_: f32;
    var phi_589_: f32;
    var phi_590_: bool;
    var phi_591_: f32;
    var phi_592_: bool;
    var phi_596_: f32;
    var phi_617_: bool;
    var phi_636_: vec2<u32>;
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
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_654_: vec2<u32>;
    var phi_655_: bool;
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_674_: bool;
    var phi_675_: bool;
    var phi_676_: vec2<u32>;
    var phi_711_: bool;
    var phi_713_: lt_mask_Reprojection;
    var phi_714_: lt_mask_Reprojection;
    var phi_715_: lt_mask_Reprojection;
    var phi_716_: bool;
    var phi_717_: bool;
    var phi_718_: lt_mask_Reprojection;
    var phi_719_: lt_mask_Reprojection;
    var phi_720_: lt_mask_Reprojection;
    var phi_721_: bool;
    var phi_722_: bool;
    var phi_774_: bool;
    var phi_778_: f32;
    var phi_782_: lt_mask_Reprojection;
    var phi_783_: bool;
    var phi_795_: bool;
    var phi_796_: bool;
    var phi_797_: bool;
    var phi_798_: lt_mask_Reprojection;
    var phi_799_: bool;
    var phi_803_: bool;
    var phi_804_: lt_mask_Reprojection;
    var phi_810_: bool;
    var phi_842_: u32;
    var phi_871_: lt_mask_Neighbourhood;
    var phi_872_: lt_mask_Neighbourhood;
    var phi_873_: lt_mask_Neighbourhood;
    var phi_905_: bool;
    var phi_906_: bool;
    var phi_928_: bool;
    var phi_929_: bool;
    var phi_930_: bool;
    var phi_934_: bool;
    var phi_956_: bool;
    var phi_957_: bool;
    var phi_970_: bool;
    var phi_971_: bool;
    var phi_972_: bool;
    var phi_979_: u32;
    var phi_980_: u32;
    var phi_981_: u32;
    var phi_982_: u32;
    var phi_983_: u32;
    var phi_984_: u32;
    var phi_985_: u32;
    var phi_997_: bool;
    var phi_998_: bool;
    var phi_999_: bool;
    var phi_1000_: bool;
    var phi_1004_: bool;
    var phi_1010_: bool;
    var phi_1018_: u32;
    var phi_1023_: u32;
    var phi_1032_: u32;
    var phi_1037_: u32;
    var phi_1041_: u32;
    var phi_1042_: u32;
    var phi_1043_: u32;
    var phi_1047_: f32;
    var phi_1056_: bool;
    var phi_1057_: bool;
    var phi_1059_: mask_Masked;
    var phi_1131_: bool;
    var phi_1132_: bool;
    var phi_1133_: bool;
    var phi_1134_: bool;
    var phi_1138_: bool;
    var phi_1166_: f32;
    var phi_1171_: doubt_Listed;
    var phi_1172_: bool;
    var phi_1185_: u32;
    var phi_1202_: u32;

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
            phi_1059_ = mask_Masked(_e246.unnamed.visibility, 0u, false, false);
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
                phi_718_ = lt_mask_Reprojection(_e273.pixel, _e273.is_valid, false);
                phi_719_ = lt_mask_Reprojection();
                phi_720_ = lt_mask_Reprojection();
                phi_721_ = true;
                phi_722_ = false;
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
                let _e345 = (1f / (((_e330 * _e336.x) + (_e332 * _e336.y)) + (_e334 * _e336.z)));
                let _e347 = p.member.previous.right;
                let _e349 = p.member.previous.right;
                let _e361 = (1f / (((_e349.x * _e349.x) + (_e349.y * _e349.y)) + (_e349.z * _e349.z)));
                let _e369 = p.member.previous.up;
                let _e371 = p.member.previous.up;
                let _e383 = (1f / (((_e371.x * _e371.x) + (_e371.y * _e371.y)) + (_e371.z * _e371.z)));
                let _e405 = p.member.previous.size[0u];
                let _e412 = p.member.previous.size[1u];
                let _e416 = (((((((_e330 * (_e347.x * _e361)) + (_e332 * (_e347.y * _e361))) + (_e334 * (_e347.z * _e361))) * _e345) + 1f) * (0.5f * f32(_e405))) - _e323);
                let _e417 = (((1f - ((((_e330 * (_e369.x * _e383)) + (_e332 * (_e369.y * _e383))) + (_e334 * (_e369.z * _e383))) * _e345)) * (0.5f * f32(_e412))) - _e325);
                let _e421 = p.member.current.size[0u];
                let _e423 = p.member.current.size[1u];
                let _e425 = (_e323 + _e416);
                if (_e425 > -8388608f) {
                    let _e437 = f32(select(0i, select(select(i32(_e425), i32(-2147483648), (_e425 < bitcast<f32>(3472883712u))), 2147483647i, (_e425 > bitcast<f32>(1325400063u))), (_e425 == _e425)));
                    if (_e437 > _e425) {
                        phi_551_ = 1f;
                    } else {
                        phi_551_ = 0f;
                    }
                    let _e440 = phi_551_;
                    if (_e425 < 8388608f) {
                        phi_556_ = (_e437 - _e440);
                        phi_557_ = false;
                    } else {
                        phi_556_ = f32();
                        phi_557_ = true;
                    }
                    let _e443 = phi_556_;
                    let _e445 = phi_557_;
                    phi_558_ = _e443;
                    phi_559_ = _e445;
                } else {
                    phi_558_ = f32();
                    phi_559_ = true;
                }
                let _e447 = phi_558_;
                let _e449 = phi_559_;
                if _e449 {
                    phi_563_ = _e425;
                } else {
                    phi_563_ = _e447;
                }
                let _e451 = phi_563_;
                let _e452 = (_e325 + _e417);
                if (_e452 > -8388608f) {
                    let _e464 = f32(select(0i, select(select(i32(_e452), i32(-2147483648), (_e452 < bitcast<f32>(3472883712u))), 2147483647i, (_e452 > bitcast<f32>(1325400063u))), (_e452 == _e452)));
                    if (_e464 > _e452) {
                        phi_584_ = 1f;
                    } else {
                        phi_584_ = 0f;
                    }
                    let _e467 = phi_584_;
                    if (_e452 < 8388608f) {
                        phi_589_ = (_e464 - _e467);
                        phi_590_ = false;
                    } else {
                        phi_589_ = f32();
                        phi_590_ = true;
                    }
                    let _e470 = phi_589_;
                    let _e472 = phi_590_;
                    phi_591_ = _e470;
                    phi_592_ = _e472;
                } else {
                    phi_591_ = f32();
                    phi_592_ = true;
                }
                let _e474 = phi_591_;
                let _e476 = phi_592_;
                if _e476 {
                    phi_596_ = _e452;
                } else {
                    phi_596_ = _e474;
                }
                let _e478 = phi_596_;
                if (_e451 >= 0f) {
                    if (_e478 >= 0f) {
                        if (_e451 < f32(_e421)) {
                            let _e484 = (_e478 < f32(_e423));
                            if (_e416 == 0f) {
                                phi_617_ = (_e417 == 0f);
                            } else {
                                phi_617_ = false;
                            }
                            let _e488 = phi_617_;
                            if _e484 {
                                phi_636_ = vec2<u32>(select(select(u32(_e451), 0u, (_e451 < bitcast<f32>(0u))), 4294967295u, (_e451 > bitcast<f32>(1333788671u))), select(select(u32(_e478), 0u, (_e478 < bitcast<f32>(0u))), 4294967295u, (_e478 > bitcast<f32>(1333788671u))));
                                phi_637_ = false;
                            } else {
                                phi_636_ = vec2<u32>();
                                phi_637_ = true;
                            }
                            let _e505 = phi_636_;
                            let _e507 = phi_637_;
                            phi_638_ = _e488;
                            phi_639_ = _e484;
                            phi_640_ = _e505;
                            phi_641_ = _e488;
                            phi_642_ = _e484;
                            phi_643_ = false;
                            phi_644_ = _e507;
                        } else {
                            phi_638_ = bool();
                            phi_639_ = bool();
                            phi_640_ = vec2<u32>();
                            phi_641_ = bool();
                            phi_642_ = bool();
                            phi_643_ = true;
                            phi_644_ = false;
                        }
                        let _e509 = phi_638_;
                        let _e511 = phi_639_;
                        let _e513 = phi_640_;
                        let _e515 = phi_641_;
                        let _e517 = phi_642_;
                        let _e519 = phi_643_;
                        let _e521 = phi_644_;
                        phi_645_ = _e509;
                        phi_646_ = _e511;
                        phi_647_ = _e513;
                        phi_648_ = _e515;
                        phi_649_ = _e517;
                        phi_650_ = _e519;
                        phi_651_ = _e521;
                    } else {
                        phi_645_ = bool();
                        phi_646_ = bool();
                        phi_647_ = vec2<u32>();
                        phi_648_ = bool();
                        phi_649_ = bool();
                        phi_650_ = true;
                        phi_651_ = false;
                    }
                    let _e523 = phi_645_;
                    let _e525 = phi_646_;
                    let _e527 = phi_647_;
                    let _e529 = phi_648_;
                    let _e531 = phi_649_;
                    let _e533 = phi_650_;
                    let _e535 = phi_651_;
                    phi_652_ = _e523;
                    phi_653_ = _e525;
                    phi_654_ = _e527;
                    phi_655_ = _e529;
                    phi_656_ = _e531;
                    phi_657_ = _e533;
                    phi_658_ = _e535;
                } else {
                    phi_652_ = bool();
                    phi_653_ = bool();
                    phi_654_ = vec2<u32>();
                    phi_655_ = bool();
                    phi_656_ = bool();
                    phi_657_ = true;
                    phi_658_ = false;
                }
                let _e537 = phi_652_;
                let _e539 = phi_653_;
                let _e541 = phi_654_;
                let _e543 = phi_655_;
                let _e545 = phi_656_;
                let _e547 = phi_657_;
                let _e549 = phi_658_;
                if _e547 {
                    if (_e416 == 0f) {
                        phi_667_ = (_e417 == 0f);
                    } else {
                        phi_667_ = false;
                    }
                    let _e553 = phi_667_;
                    phi_668_ = _e553;
                    phi_669_ = false;
                    phi_670_ = true;
                } else {
                    phi_668_ = _e543;
                    phi_669_ = _e545;
                    phi_670_ = _e549;
                }
                let _e555 = phi_668_;
                let _e557 = phi_669_;
                let _e559 = phi_670_;
                if _e559 {
                    phi_674_ = _e555;
                    phi_675_ = _e557;
                    phi_676_ = vec2<u32>(_e55.x, _e55.y);
                } else {
                    phi_674_ = _e537;
                    phi_675_ = _e539;
                    phi_676_ = _e541;
                }
                let _e561 = phi_674_;
                let _e563 = phi_675_;
                let _e565 = phi_676_;
                let _e575 = lt_mask_Reprojection(vec2<u32>(_e565.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e582 = lt_mask_Reprojection(vec2<u32>(_e575.pixel.x, _e565.y), _e575.is_valid, _e575.has_moved);
                let _e586 = lt_mask_Reprojection(_e582.pixel, _e563, _e582.has_moved);
                let _e590 = lt_mask_Reprojection(_e586.pixel, _e586.is_valid, !(_e561));
                if _e563 {
                    let _e593 = p.member.previous.eye;
                    let _e601 = p.member.previous.forward;
                    let _e610 = (((((_e88.x - _e593.x) * _e601.x) + ((_e88.y - _e593.y) * _e601.y)) + ((_e88.z - _e593.z) * _e601.z)) > 0f);
                    let _e614 = lt_mask_Reprojection(_e590.pixel, _e610, _e590.has_moved);
                    if _e610 {
                        phi_711_ = false;
                    } else {
                        phi_711_ = true;
                    }
                    let _e616 = phi_711_;
                    phi_713_ = _e614;
                    phi_714_ = _e614;
                    phi_715_ = lt_mask_Reprojection();
                    phi_716_ = _e610;
                    phi_717_ = _e616;
                } else {
                    phi_713_ = lt_mask_Reprojection();
                    phi_714_ = lt_mask_Reprojection();
                    phi_715_ = lt_mask_Reprojection(_e590.pixel, false, _e590.has_moved);
                    phi_716_ = false;
                    phi_717_ = false;
                }
                let _e622 = phi_713_;
                let _e624 = phi_714_;
                let _e626 = phi_715_;
                let _e628 = phi_716_;
                let _e630 = phi_717_;
                phi_718_ = _e622;
                phi_719_ = _e624;
                phi_720_ = _e626;
                phi_721_ = _e628;
                phi_722_ = _e630;
            }
            let _e632 = phi_718_;
            let _e634 = phi_719_;
            let _e636 = phi_720_;
            let _e638 = phi_721_;
            let _e640 = phi_722_;
            if _e638 {
                let _e643 = p.member.previous.eye;
                let _e651 = p.member.previous.forward;
                let _e659 = ((((_e88.x - _e643.x) * _e651.x) + ((_e88.y - _e643.y) * _e651.y)) + ((_e88.z - _e643.z) * _e651.z));
                let _e665 = ((_e632.pixel.y * _e85) + _e632.pixel.x);
                if (_e665 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e669 = last_depths.member[(0u + _e665)];
                let _e671 = p.member.depth_tolerance;
                let _e674 = abs(_e659);
                let _e675 = abs(_e669);
                if ((bitcast<u32>(_e675) & 2147483647u) > 2139095040u) {
                    phi_774_ = true;
                } else {
                    let _e679 = (_e675 > _e674);
                    if _e679 {
                    }
                    phi_774_ = _e679;
                }
                let _e681 = phi_774_;
                if _e681 {
                    phi_778_ = _e675;
                } else {
                    phi_778_ = _e674;
                }
                let _e683 = phi_778_;
                phi_782_ = lt_mask_Reprojection(_e632.pixel, (abs((_e659 - _e669)) <= (_e671 * _e683)), _e632.has_moved);
                phi_783_ = true;
            } else {
                phi_782_ = _e634;
                phi_783_ = _e640;
            }
            let _e691 = phi_782_;
            let _e693 = phi_783_;
            if _e693 {
                if _e691.is_valid {
                    let _e696 = p.member.flags;
                    phi_795_ = ((_e696 & 1u) != 0u);
                    phi_796_ = false;
                } else {
                    phi_795_ = bool();
                    phi_796_ = true;
                }
                let _e700 = phi_795_;
                let _e702 = phi_796_;
                phi_797_ = _e700;
                phi_798_ = _e691;
                phi_799_ = _e702;
            } else {
                phi_797_ = bool();
                phi_798_ = _e636;
                phi_799_ = true;
            }
            let _e704 = phi_797_;
            let _e706 = phi_798_;
            let _e708 = phi_799_;
            if _e708 {
                phi_803_ = false;
                phi_804_ = _e706;
            } else {
                phi_803_ = _e704;
                phi_804_ = _e691;
            }
            let _e710 = phi_803_;
            let _e712 = phi_804_;
            let _e716 = lt_mask_Reprojection(_e712.pixel, _e710, _e712.has_moved);
            let _e717 = lt_mask_Neighbourhood(false, true);
            if _e255 {
                phi_810_ = false;
            } else {
                phi_810_ = true;
            }
            let _e719 = phi_810_;
            if _e719 {
                if _e710 {
                    if ((0u & 2u) != 0u) {
                        phi_871_ = _e717;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e728 = (_e85 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e85 % 32u) > 0u) {
                            phi_842_ = (_e728 + 1u);
                        } else {
                            phi_842_ = _e728;
                        }
                        let _e734 = phi_842_;
                        let _e744 = ((((_e716.pixel.y * _e734) + (_e716.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e251) | (select(0u, 1u, _e716.has_moved) << bitcast<u32>(1i))));
                        if (_e744 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e748 = heard.member[(0u + _e744)];
                        let _e754 = (((_e748 >> bitcast<u32>(((_e716.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_871_ = lt_mask_Neighbourhood(_e754, !(_e754));
                    }
                    let _e758 = phi_871_;
                    phi_872_ = _e758;
                } else {
                    phi_872_ = _e717;
                }
                let _e760 = phi_872_;
                phi_873_ = _e760;
            } else {
                phi_873_ = _e717;
            }
            let _e762 = phi_873_;
            let _e765 = p.member.frame;
            let _e767 = p.member.refresh;
            if (_e767 == 0u) {
                phi_906_ = false;
            } else {
                if (_e767 == 0u) {
                    return;
                }
                let _e776 = ((_e55.x + (_e55.y * (((_e767 * 5u) / 8u) | 1u))) + (_e765 % _e767));
                if (_e767 == 0u) {
                    phi_905_ = (_e776 == 0u);
                } else {
                    if (_e767 == 0u) {
                        return;
                    }
                    phi_905_ = ((_e776 % _e767) == 0u);
                }
                let _e783 = phi_905_;
                phi_906_ = _e783;
            }
            let _e785 = phi_906_;
            if _e710 {
                if _e785 {
                    phi_928_ = bool();
                } else {
                    phi_928_ = ((0u & 2u) != 0u);
                }
                let _e791 = phi_928_;
                phi_929_ = _e791;
                phi_930_ = _e785;
            } else {
                phi_929_ = bool();
                phi_930_ = true;
            }
            let _e793 = phi_929_;
            let _e795 = phi_930_;
            if _e795 {
                phi_934_ = false;
            } else {
                phi_934_ = _e793;
            }
            let _e797 = phi_934_;
            if _e797 {
                phi_985_ = 7u;
            } else {
                if (_e93 != 0.5f) {
                    if _e710 {
                        if _e785 {
                            phi_982_ = 6u;
                        } else {
                            if _e255 {
                                phi_957_ = true;
                            } else {
                                if _e762.any_expands {
                                    phi_956_ = false;
                                } else {
                                    phi_956_ = true;
                                }
                                let _e799 = phi_956_;
                                phi_957_ = _e799;
                            }
                            let _e801 = phi_957_;
                            if _e801 {
                                if _e255 {
                                    if false {
                                        if _e762.all_remove {
                                            phi_970_ = false;
                                        } else {
                                            phi_970_ = true;
                                        }
                                        let _e803 = phi_970_;
                                        phi_971_ = _e803;
                                    } else {
                                        phi_971_ = true;
                                    }
                                    let _e805 = phi_971_;
                                    phi_972_ = _e805;
                                } else {
                                    phi_972_ = true;
                                }
                                let _e807 = phi_972_;
                                if _e807 {
                                    if _e255 {
                                        phi_979_ = 1u;
                                    } else {
                                        phi_979_ = 0u;
                                    }
                                    let _e809 = phi_979_;
                                    phi_980_ = _e809;
                                } else {
                                    phi_980_ = 5u;
                                }
                                let _e811 = phi_980_;
                                phi_981_ = _e811;
                            } else {
                                phi_981_ = 4u;
                            }
                            let _e813 = phi_981_;
                            phi_982_ = _e813;
                        }
                        let _e815 = phi_982_;
                        phi_983_ = _e815;
                    } else {
                        phi_983_ = 3u;
                    }
                    let _e817 = phi_983_;
                    phi_984_ = _e817;
                } else {
                    phi_984_ = 2u;
                }
                let _e819 = phi_984_;
                phi_985_ = _e819;
            }
            let _e821 = phi_985_;
            if !((_e821 == 0u)) {
                if !((_e821 == 5u)) {
                    phi_997_ = !(_e797);
                    phi_998_ = false;
                } else {
                    phi_997_ = bool();
                    phi_998_ = true;
                }
                let _e828 = phi_997_;
                let _e830 = phi_998_;
                phi_999_ = _e828;
                phi_1000_ = _e830;
            } else {
                phi_999_ = bool();
                phi_1000_ = true;
            }
            let _e832 = phi_999_;
            let _e834 = phi_1000_;
            if _e834 {
                phi_1004_ = false;
            } else {
                phi_1004_ = _e832;
            }
            let _e836 = phi_1004_;
            if _e797 {
                phi_1010_ = ((0u & 4u) != 0u);
            } else {
                phi_1010_ = _e251;
            }
            let _e840 = phi_1010_;
            if _e836 {
                if _e251 {
                    phi_1018_ = (2u | 1u);
                } else {
                    phi_1018_ = 2u;
                }
                let _e843 = phi_1018_;
                if false {
                    phi_1023_ = (_e843 | 4u);
                } else {
                    phi_1023_ = _e843;
                }
                let _e846 = phi_1023_;
                phi_1043_ = _e846;
            } else {
                if (_e821 == 7u) {
                    if _e251 {
                        phi_1032_ = (2u | 1u);
                    } else {
                        phi_1032_ = 2u;
                    }
                    let _e850 = phi_1032_;
                    if _e840 {
                        phi_1037_ = (_e850 | 4u);
                    } else {
                        phi_1037_ = _e850;
                    }
                    let _e853 = phi_1037_;
                    phi_1042_ = _e853;
                } else {
                    if _e251 {
                        phi_1041_ = 1u;
                    } else {
                        phi_1041_ = 0u;
                    }
                    let _e855 = phi_1041_;
                    phi_1042_ = _e855;
                }
                let _e857 = phi_1042_;
                phi_1043_ = _e857;
            }
            let _e859 = phi_1043_;
            if _e840 {
                phi_1047_ = 0f;
            } else {
                phi_1047_ = 1f;
            }
            let _e861 = phi_1047_;
            if _e255 {
                if (_e93 == 0.99999994f) {
                    phi_1056_ = true;
                } else {
                    phi_1056_ = (_e93 == 0.000000059604645f);
                }
                let _e865 = phi_1056_;
                phi_1057_ = _e865;
            } else {
                phi_1057_ = true;
            }
            let _e867 = phi_1057_;
            phi_1059_ = mask_Masked(_e861, _e859, _e836, _e867);
        }
        let _e870 = phi_1059_;
        visibility.member[_e77.first_primitive] = _e870.visibility;
        let _e875 = p.member.light.number;
        let _e876 = (_e875 * 3u);
        let _e878 = (_e876 % 32u);
        let _e880 = p.member.light.mask_words;
        let _e882 = ((_e77.first_primitive * _e880) + (_e876 / 32u));
        let _e884 = bits.member[_e882];
        bits.member[_e882] = ((_e884 & ~((7u << bitcast<u32>((_e878 & 31u))))) | (_e870.bits << bitcast<u32>((_e878 & 31u))));
        if (_e878 > 29u) {
            let _e899 = bits.member[(_e882 + 1u)];
            let _e901 = (32u - _e878);
            bits.member[(_e882 + 1u)] = ((_e899 & ~((7u >> bitcast<u32>((_e901 & 31u))))) | (_e870.bits >> bitcast<u32>((_e901 & 31u))));
        }
        let _e916 = samples.member[_e77.first_primitive].normal[0u];
        let _e918 = global[0u];
        if (_e916 == _e918) {
            let _e921 = samples.member[_e77.first_primitive].normal[1u];
            let _e923 = global[1u];
            if (_e921 == _e923) {
                let _e926 = samples.member[_e77.first_primitive].normal[2u];
                let _e928 = global[2u];
                phi_1131_ = (_e926 == _e928);
                phi_1132_ = false;
            } else {
                phi_1131_ = bool();
                phi_1132_ = true;
            }
            let _e931 = phi_1131_;
            let _e933 = phi_1132_;
            phi_1133_ = _e931;
            phi_1134_ = _e933;
        } else {
            phi_1133_ = bool();
            phi_1134_ = true;
        }
        let _e935 = phi_1133_;
        let _e937 = phi_1134_;
        if _e937 {
            phi_1138_ = false;
        } else {
            phi_1138_ = _e935;
        }
        let _e939 = phi_1138_;
        if !(_e939) {
            let _e942 = samples.member[_e77.first_primitive].position;
            let _e944 = p.member.current.eye;
            let _e955 = p.member.current.forward;
            phi_1166_ = ((((_e942.x - _e944.x) * _e955.x) + ((_e942.y - _e944.y) * _e955.y)) + ((_e942.z - _e944.z) * _e955.z));
        } else {
            phi_1166_ = 0f;
        }
        let _e965 = phi_1166_;
        depths.member[_e77.first_primitive] = _e965;
        phi_1171_ = doubt_Listed(_e77.first_primitive, _e870.is_trusted);
        phi_1172_ = _e870.needs_ray;
    } else {
        phi_1171_ = doubt_Listed(0u, false);
        phi_1172_ = false;
    }
    let _e971 = phi_1171_;
    let _e973 = phi_1172_;
    if (_e56 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e973 {
        let _e979 = atomicAdd((&shared_[0u]), 1u);
        phi_1185_ = _e979;
    } else {
        phi_1185_ = 0u;
    }
    let _e981 = phi_1185_;
    workgroupBarrier();
    if (_e56 == 0u) {
        let _e985 = atomicLoad((&shared_[0u]));
        let _e986 = atomicAdd((&list.member[3u]), _e985);
        atomicStore((&shared_[1u]), _e986);
    }
    workgroupBarrier();
    if _e973 {
        if _e971.is_trusted {
            phi_1202_ = (_e971.pixel | 2147483648u);
        } else {
            phi_1202_ = _e971.pixel;
        }
        let _e990 = phi_1202_;
        let _e992 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e992) + _e981)]), _e990);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
