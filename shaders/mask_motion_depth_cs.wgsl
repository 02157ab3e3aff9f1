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
@group(0) @binding(6) 
var<storage> last_depths: type_27;
@group(0) @binding(7) 
var<storage, read_write> depths: type_27;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_166_: lt_bvh_traverse_Tree;
    var phi_167_: bool;
    var phi_168_: lt_bvh_traverse_Tree;
    var phi_169_: bool;
    var phi_174_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_166_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_167_ = false;
        } else {
            phi_166_ = lt_bvh_traverse_Tree();
            phi_167_ = true;
        }
        let _e66 = phi_166_;
        let _e68 = phi_167_;
        phi_168_ = _e66;
        phi_169_ = _e68;
    } else {
        phi_168_ = lt_bvh_traverse_Tree();
        phi_169_ = true;
    }
    let _e70 = phi_168_;
    let _e72 = phi_169_;
    if _e72 {
        phi_174_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_174_ = _e70;
    }
    let _e77 = phi_174_;
    return lt_bvh_traverse_Tree(_e77.root, _e77.first_primitive);
}

fn function_() {
    var phi_242_: bool;
    var phi_243_: bool;
    var phi_244_: bool;
    var phi_245_: bool;
    var phi_249_: bool;
    var phi_319_: bool;
    var phi_320_: bool;
    var phi_331_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_332_: bool;
    var phi_333_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_334_: bool;
    var phi_341_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_345_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_358_: bool;
    var phi_389_: bool;
    var phi_390_: bool;
    var phi_391_: bool;
    var phi_392_: bool;
    var phi_396_: bool;
    var phi_397_: bool;
    var phi_608_: f32;
    var phi_613_: f32;
    var phi_614_: bool;
    var phi_615_: f32;
    var phi_616_: bool;
    var phi_620_: f32;
    var phi_641_: f32;
    var phi_646_: f32;
    var phi_647_: bool;
    var phi_648_: f32;
    var phi_649_: bool;
    var phi_653_: f32;
    var phi_674_: bool;
    var phi_693_: vec2<u32>;
    var phi_694_: bool;
    var phi_695_: bool;
    var phi_696_: bool;
    var phi_697_: vec2<u32>;
    var phi_698_: bool;
    var phi_699_: bool;
    var phi_700_: bool;
    var phi_701_: bool;
    var phi_702_: bool;
    var phi_703_: bool;
    var phi_704_: vec2<u32>;
    var phi_705_: bool;
    var phi_706_: bool;
    var phi_707_: bool;
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_710_: bool;
    var phi_711_: vec2<u32>;
    var phi_712_: bool;
    var phi_713_: bool;
    var phi_714_: bool;
    var phi_715_: bool;
    var phi_724_: bool;
    var phi_725_: bool;
    var phi_726_: bool;
    var phi_727_: bool;
    var phi_731_: bool;
    var phi_732_: bool;
    var phi_733_: vec2<u32>;
    var phi_771_: bool;
    var phi_773_: lt_mask_Reprojection;
    var phi_774_: lt_mask_Reprojection;
    var phi_775_: lt_mask_Reprojection;
    var phi_776_: bool;
    var phi_777_: bool;
    var phi_778_: lt_mask_Reprojection;
    var phi_779_: lt_mask_Reprojection;
    var phi_780_: lt_mask_Reprojection;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_837_: bool;
    var phi_841_: f32;
    var phi_845_: lt_mask_Reprojection;
    var phi_846_: bool;
    var phi_858_: bool;
    var phi_859_: bool;
    var phi_860_: bool;
    var phi_861_: lt_mask_Reprojection;
    var phi_862_: bool;
    var phi_866_: bool;
    var phi_867_: lt_mask_Reprojection;
    var phi_905_: u32;
    var phi_954_: u32;
    var phi_959_: u32;
    var phi_960_: u32;
    var phi_961_: u32;
    var phi_962_: bool;
    var phi_963_: u32;
    var phi_964_: bool;
    var phi_965_: bool;
    var phi_966_: u32;
    var phi_967_: bool;
    var phi_968_: bool;
    var phi_972_: bool;
    var phi_976_: u32;
    var phi_981_: bool;
    var phi_1013_: u32;
    var phi_1042_: lt_mask_Neighbourhood;
    var phi_1043_: lt_mask_Neighbourhood;
    var phi_1044_: lt_mask_Neighbourhood;
    var phi_1076_: bool;
    var phi_1077_: bool;
    var phi_1099_: bool;
    var phi_1100_: bool;
    var phi_1101_: bool;
    var phi_1105_: bool;
    var phi_1127_: bool;
    var phi_1128_: bool;
    var phi_1141_: bool;
    var phi_1142_: bool;
    var phi_1143_: bool;
    var phi_1150_: u32;
    var phi_1151_: u32;
    var phi_1152_: u32;
    var phi_1153_: u32;
    var phi_1154_: u32;
    var phi_1155_: u32;
    var phi_1156_: u32;
    var phi_1168_: bool;
    var phi_1169_: bool;
    var phi_1170_: bool;
    var phi_1171_: bool;
    var phi_1175_: bool;
    var phi_1181_: bool;
    var phi_1189_: u32;
    var phi_1194_: u32;
    var phi_1203_: u32;
    var phi_1208_: u32;
    var phi_1212_: u32;
    var phi_1213_: u32;
    var phi_1214_: u32;
    var phi_1218_: f32;
    var phi_1220_: mask_Masked;
    var phi_1292_: bool;
    var phi_1293_: bool;
    var phi_1294_: bool;
    var phi_1295_: bool;
    var phi_1299_: bool;
    var phi_1327_: f32;
    var phi_1330_: bool;
    var phi_1331_: u32;
    var phi_1342_: u32;

    let _e53 = id_1;
    let _e54 = local_1;
    let _e59 = arrayLength((&heard.member));
    let _e70 = p.member.current.size[0u];
    let _e72 = p.member.current.size[1u];
    let _e73 = lt_shaders_entry_pixel_index(_e53, _e70, _e72);
    if (bitcast<i32>(_e73.root) != 0i) {
        let _e81 = p.member.current.size[0u];
        let _e84 = samples.member[_e73.first_primitive].position;
        let _e86 = visibility.member[_e73.first_primitive];
        let _e92 = samples.member[_e73.first_primitive].normal[0u];
        let _e94 = global[0u];
        if (_e92 == _e94) {
            let _e97 = samples.member[_e73.first_primitive].normal[1u];
            let _e99 = global[1u];
            if (_e97 == _e99) {
                let _e102 = samples.member[_e73.first_primitive].normal[2u];
                let _e104 = global[2u];
                phi_242_ = (_e102 == _e104);
                phi_243_ = false;
            } else {
                phi_242_ = bool();
                phi_243_ = true;
            }
            let _e107 = phi_242_;
            let _e109 = phi_243_;
            phi_244_ = _e107;
            phi_245_ = _e109;
        } else {
            phi_244_ = bool();
            phi_245_ = true;
        }
        let _e111 = phi_244_;
        let _e113 = phi_245_;
        if _e113 {
            phi_249_ = false;
        } else {
            phi_249_ = _e111;
        }
        let _e115 = phi_249_;
        if !(_e115) {
            let _e118 = samples.member[_e73.first_primitive].position;
            let _e120 = p.member.light.place;
            let _e126 = p.member.light.place[3u];
            let _e133 = (_e120.x - (_e118.x * _e126));
            let _e134 = (_e120.y - (_e118.y * _e126));
            let _e135 = (_e120.z - (_e118.z * _e126));
            let _e137 = samples.member[_e73.first_primitive].normal;
            if ((((_e137.x * _e133) + (_e137.y * _e134)) + (_e137.z * _e135)) > 0f) {
                let _e151 = (((_e133 * _e133) + (_e134 * _e134)) + (_e135 * _e135));
                let _e153 = p.member.light.axis;
                let _e165 = p.member.light.place[3u];
                if (_e165 == 0f) {
                    phi_320_ = true;
                } else {
                    let _e168 = p.member.light.range_squared;
                    if (_e151 <= _e168) {
                        let _e171 = p.member.light.cos_outer;
                        phi_319_ = (-((((_e133 * _e153.x) + (_e134 * _e153.y)) + (_e135 * _e153.z))) >= (_e171 * sqrt(_e151)));
                    } else {
                        phi_319_ = false;
                    }
                    let _e176 = phi_319_;
                    phi_320_ = _e176;
                }
                let _e178 = phi_320_;
                if _e178 {
                    let _e180 = samples.member[_e73.first_primitive].flags;
                    let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e194 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e188.unnamed.visibility, false), _e188.unnamed_1);
                    phi_331_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e194.unnamed, ((_e180 & 1u) == 0u));
                    phi_332_ = false;
                } else {
                    phi_331_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_332_ = true;
                }
                let _e199 = phi_331_;
                let _e201 = phi_332_;
                phi_333_ = _e199;
                phi_334_ = _e201;
            } else {
                phi_333_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_334_ = true;
            }
            let _e203 = phi_333_;
            let _e205 = phi_334_;
            if _e205 {
                let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e211.unnamed.visibility, false), _e211.unnamed_1);
                phi_341_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e217.unnamed, true);
            } else {
                phi_341_ = _e203;
            }
            let _e222 = phi_341_;
            phi_345_ = _e222;
        } else {
            let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e234 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e228.unnamed.visibility, false), _e228.unnamed_1);
            phi_345_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e234.unnamed, true);
        }
        let _e239 = phi_345_;
        if _e239.unnamed_1 {
            phi_1220_ = mask_Masked(_e239.unnamed.visibility, 0u, false);
        } else {
            let _e244 = (_e86 < 0.5f);
            if (_e86 > 0f) {
                phi_358_ = (_e86 < 1f);
            } else {
                phi_358_ = false;
            }
            let _e248 = phi_358_;
            let _e255 = lt_mask_Reprojection(vec2<u32>(_e53.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e262 = lt_mask_Reprojection(vec2<u32>(_e255.pixel.x, _e53.y), _e255.is_valid, _e255.has_moved);
            let _e266 = lt_mask_Reprojection(_e262.pixel, true, _e262.has_moved);
            let _e272 = p.member.flags;
            if ((_e272 & 16u) == 0u) {
                phi_397_ = false;
            } else {
                let _e278 = samples.member[_e73.first_primitive].position[0u];
                if (_e84.x == _e278) {
                    let _e282 = samples.member[_e73.first_primitive].position[1u];
                    if (_e84.y == _e282) {
                        let _e286 = samples.member[_e73.first_primitive].position[2u];
                        phi_389_ = (_e84.z == _e286);
                        phi_390_ = false;
                    } else {
                        phi_389_ = bool();
                        phi_390_ = true;
                    }
                    let _e289 = phi_389_;
                    let _e291 = phi_390_;
                    phi_391_ = _e289;
                    phi_392_ = _e291;
                } else {
                    phi_391_ = bool();
                    phi_392_ = true;
                }
                let _e293 = phi_391_;
                let _e295 = phi_392_;
                if _e295 {
                    phi_396_ = false;
                } else {
                    phi_396_ = _e293;
                }
                let _e297 = phi_396_;
                phi_397_ = _e297;
            }
            let _e299 = phi_397_;
            if _e299 {
                phi_778_ = lt_mask_Reprojection(_e266.pixel, _e266.is_valid, false);
                phi_779_ = lt_mask_Reprojection();
                phi_780_ = lt_mask_Reprojection();
                phi_781_ = true;
                phi_782_ = false;
            } else {
                let _e301 = samples.member[_e73.first_primitive].position;
                let _e305 = p.member.previous.eye;
                let _e308 = (_e84.x - _e305.x);
                let _e311 = (_e84.y - _e305.y);
                let _e314 = (_e84.z - _e305.z);
                let _e316 = p.member.previous.forward;
                let _e324 = (((_e308 * _e316.x) + (_e311 * _e316.y)) + (_e314 * _e316.z));
                let _e326 = p.member.previous.right;
                let _e336 = p.member.previous.right;
                let _e351 = p.member.previous.up;
                let _e361 = p.member.previous.up;
                let _e376 = p.member.current.eye;
                let _e379 = (_e301.x - _e376.x);
                let _e382 = (_e301.y - _e376.y);
                let _e385 = (_e301.z - _e376.z);
                let _e387 = p.member.current.forward;
                let _e395 = (((_e379 * _e387.x) + (_e382 * _e387.y)) + (_e385 * _e387.z));
                let _e397 = p.member.current.right;
                let _e407 = p.member.current.right;
                let _e422 = p.member.current.up;
                let _e432 = p.member.current.up;
                let _e451 = p.member.current.size[0u];
                let _e453 = (((((((_e308 * _e326.x) + (_e311 * _e326.y)) + (_e314 * _e326.z)) / ((((_e336.x * _e336.x) + (_e336.y * _e336.y)) + (_e336.z * _e336.z)) * _e324)) - ((((_e379 * _e397.x) + (_e382 * _e397.y)) + (_e385 * _e397.z)) / ((((_e407.x * _e407.x) + (_e407.y * _e407.y)) + (_e407.z * _e407.z)) * _e395))) * 0.5f) * f32(_e451));
                let _e457 = p.member.current.size[1u];
                let _e459 = (((((((_e308 * _e351.x) + (_e311 * _e351.y)) + (_e314 * _e351.z)) / ((((_e361.x * _e361.x) + (_e361.y * _e361.y)) + (_e361.z * _e361.z)) * _e324)) - ((((_e379 * _e422.x) + (_e382 * _e422.y)) + (_e385 * _e422.z)) / ((((_e432.x * _e432.x) + (_e432.y * _e432.y)) + (_e432.z * _e432.z)) * _e395))) * -0.5f) * f32(_e457));
                let _e463 = p.member.current.grid[0u];
                let _e465 = p.member.current.grid[1u];
                let _e485 = p.member.current.size[0u];
                let _e487 = p.member.current.size[1u];
                let _e489 = ((f32(_e53.x) + ((f32((_e53.y & (_e465 - 1u))) + 0.5f) / f32(_e465))) + _e453);
                if (_e489 > -8388608f) {
                    let _e501 = f32(select(0i, select(select(i32(_e489), i32(-2147483648), (_e489 < bitcast<f32>(3472883712u))), 2147483647i, (_e489 > bitcast<f32>(1325400063u))), (_e489 == _e489)));
                    if (_e501 > _e489) {
                        phi_608_ = 1f;
                    } else {
                        phi_608_ = 0f;
                    }
                    let _e504 = phi_608_;
                    if (_e489 < 8388608f) {
                        phi_613_ = (_e501 - _e504);
                        phi_614_ = false;
                    } else {
                        phi_613_ = f32();
                        phi_614_ = true;
                    }
                    let _e507 = phi_613_;
                    let _e509 = phi_614_;
                    phi_615_ = _e507;
                    phi_616_ = _e509;
                } else {
                    phi_615_ = f32();
                    phi_616_ = true;
                }
                let _e511 = phi_615_;
                let _e513 = phi_616_;
                if _e513 {
                    phi_620_ = _e489;
                } else {
                    phi_620_ = _e511;
                }
                let _e515 = phi_620_;
                let _e516 = ((f32(_e53.y) + ((f32((_e53.x & (_e463 - 1u))) + 0.5f) / f32(_e463))) + _e459);
                if (_e516 > -8388608f) {
                    let _e528 = f32(select(0i, select(select(i32(_e516), i32(-2147483648), (_e516 < bitcast<f32>(3472883712u))), 2147483647i, (_e516 > bitcast<f32>(1325400063u))), (_e516 == _e516)));
                    if (_e528 > _e516) {
                        phi_641_ = 1f;
                    } else {
                        phi_641_ = 0f;
                    }
                    let _e531 = phi_641_;
                    if (_e516 < 8388608f) {
                        phi_646_ = (_e528 - _e531);
                        phi_647_ = false;
                    } else {
                        phi_646_ = f32();
                        phi_647_ = true;
                    }
                    let _e534 = phi_646_;
                    let _e536 = phi_647_;
                    phi_648_ = _e534;
                    phi_649_ = _e536;
                } else {
                    phi_648_ = f32();
                    phi_649_ = true;
                }
                let _e538 = phi_648_;
                let _e540 = phi_649_;
                if _e540 {
                    phi_653_ = _e516;
                } else {
                    phi_653_ = _e538;
                }
                let _e542 = phi_653_;
                if (_e515 >= 0f) {
                    if (_e542 >= 0f) {
                        if (_e515 < f32(_e485)) {
                            let _e548 = (_e542 < f32(_e487));
                            if (_e453 == 0f) {
                                phi_674_ = (_e459 == 0f);
                            } else {
                                phi_674_ = false;
                            }
                            let _e552 = phi_674_;
                            if _e548 {
                                phi_693_ = vec2<u32>(select(select(u32(_e515), 0u, (_e515 < bitcast<f32>(0u))), 4294967295u, (_e515 > bitcast<f32>(1333788671u))), select(select(u32(_e542), 0u, (_e542 < bitcast<f32>(0u))), 4294967295u, (_e542 > bitcast<f32>(1333788671u))));
                                phi_694_ = false;
                            } else {
                                phi_693_ = vec2<u32>();
                                phi_694_ = true;
                            }
                            let _e569 = phi_693_;
                            let _e571 = phi_694_;
                            phi_695_ = _e552;
                            phi_696_ = _e548;
                            phi_697_ = _e569;
                            phi_698_ = _e552;
                            phi_699_ = _e548;
                            phi_700_ = false;
                            phi_701_ = _e571;
                        } else {
                            phi_695_ = bool();
                            phi_696_ = bool();
                            phi_697_ = vec2<u32>();
                            phi_698_ = bool();
                            phi_699_ = bool();
                            phi_700_ = true;
                            phi_701_ = false;
                        }
                        let _e573 = phi_695_;
                        let _e575 = phi_696_;
                        let _e577 = phi_697_;
                        let _e579 = phi_698_;
                        let _e581 = phi_699_;
                        let _e583 = phi_700_;
                        let _e585 = phi_701_;
                        phi_702_ = _e573;
                        phi_703_ = _e575;
                        phi_704_ = _e577;
                        phi_705_ = _e579;
                        phi_706_ = _e581;
                        phi_707_ = _e583;
                        phi_708_ = _e585;
                    } else {
                        phi_702_ = bool();
                        phi_703_ = bool();
                        phi_704_ = vec2<u32>();
                        phi_705_ = bool();
                        phi_706_ = bool();
                        phi_707_ = true;
                        phi_708_ = false;
                    }
                    let _e587 = phi_702_;
                    let _e589 = phi_703_;
                    let _e591 = phi_704_;
                    let _e593 = phi_705_;
                    let _e595 = phi_706_;
                    let _e597 = phi_707_;
                    let _e599 = phi_708_;
                    phi_709_ = _e587;
                    phi_710_ = _e589;
                    phi_711_ = _e591;
                    phi_712_ = _e593;
                    phi_713_ = _e595;
                    phi_714_ = _e597;
                    phi_715_ = _e599;
                } else {
                    phi_709_ = bool();
                    phi_710_ = bool();
                    phi_711_ = vec2<u32>();
                    phi_712_ = bool();
                    phi_713_ = bool();
                    phi_714_ = true;
                    phi_715_ = false;
                }
                let _e601 = phi_709_;
                let _e603 = phi_710_;
                let _e605 = phi_711_;
                let _e607 = phi_712_;
                let _e609 = phi_713_;
                let _e611 = phi_714_;
                let _e613 = phi_715_;
                if _e611 {
                    if (_e453 == 0f) {
                        phi_724_ = (_e459 == 0f);
                    } else {
                        phi_724_ = false;
                    }
                    let _e617 = phi_724_;
                    phi_725_ = _e617;
                    phi_726_ = false;
                    phi_727_ = true;
                } else {
                    phi_725_ = _e607;
                    phi_726_ = _e609;
                    phi_727_ = _e613;
                }
                let _e619 = phi_725_;
                let _e621 = phi_726_;
                let _e623 = phi_727_;
                if _e623 {
                    phi_731_ = _e619;
                    phi_732_ = _e621;
                    phi_733_ = vec2<u32>(_e53.x, _e53.y);
                } else {
                    phi_731_ = _e601;
                    phi_732_ = _e603;
                    phi_733_ = _e605;
                }
                let _e625 = phi_731_;
                let _e627 = phi_732_;
                let _e629 = phi_733_;
                let _e639 = lt_mask_Reprojection(vec2<u32>(_e629.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e646 = lt_mask_Reprojection(vec2<u32>(_e639.pixel.x, _e629.y), _e639.is_valid, _e639.has_moved);
                let _e650 = lt_mask_Reprojection(_e646.pixel, _e627, _e646.has_moved);
                let _e654 = lt_mask_Reprojection(_e650.pixel, _e650.is_valid, !(_e625));
                if _e627 {
                    let _e657 = p.member.previous.eye;
                    let _e668 = p.member.previous.forward;
                    let _e677 = (((((_e84.x - _e657.x) * _e668.x) + ((_e84.y - _e657.y) * _e668.y)) + ((_e84.z - _e657.z) * _e668.z)) > 0f);
                    let _e681 = lt_mask_Reprojection(_e654.pixel, _e677, _e654.has_moved);
                    if _e677 {
                        phi_771_ = false;
                    } else {
                        phi_771_ = true;
                    }
                    let _e683 = phi_771_;
                    phi_773_ = _e681;
                    phi_774_ = _e681;
                    phi_775_ = lt_mask_Reprojection();
                    phi_776_ = _e677;
                    phi_777_ = _e683;
                } else {
                    phi_773_ = lt_mask_Reprojection();
                    phi_774_ = lt_mask_Reprojection();
                    phi_775_ = lt_mask_Reprojection(_e654.pixel, false, _e654.has_moved);
                    phi_776_ = false;
                    phi_777_ = false;
                }
                let _e689 = phi_773_;
                let _e691 = phi_774_;
                let _e693 = phi_775_;
                let _e695 = phi_776_;
                let _e697 = phi_777_;
                phi_778_ = _e689;
                phi_779_ = _e691;
                phi_780_ = _e693;
                phi_781_ = _e695;
                phi_782_ = _e697;
            }
            let _e699 = phi_778_;
            let _e701 = phi_779_;
            let _e703 = phi_780_;
            let _e705 = phi_781_;
            let _e707 = phi_782_;
            if _e705 {
                let _e710 = p.member.previous.eye;
                let _e721 = p.member.previous.forward;
                let _e729 = ((((_e84.x - _e710.x) * _e721.x) + ((_e84.y - _e710.y) * _e721.y)) + ((_e84.z - _e710.z) * _e721.z));
                let _e735 = ((_e699.pixel.y * _e81) + _e699.pixel.x);
                if (_e735 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e739 = last_depths.member[(0u + _e735)];
                let _e741 = p.member.depth_tolerance;
                let _e744 = abs(_e729);
                let _e745 = abs(_e739);
                if ((bitcast<u32>(_e745) & 2147483647u) > 2139095040u) {
                    phi_837_ = true;
                } else {
                    let _e749 = (_e745 > _e744);
                    if _e749 {
                    }
                    phi_837_ = _e749;
                }
                let _e751 = phi_837_;
                if _e751 {
                    phi_841_ = _e745;
                } else {
                    phi_841_ = _e744;
                }
                let _e753 = phi_841_;
                phi_845_ = lt_mask_Reprojection(_e699.pixel, (abs((_e729 - _e739)) <= (_e741 * _e753)), _e699.has_moved);
                phi_846_ = true;
            } else {
                phi_845_ = _e701;
                phi_846_ = _e707;
            }
            let _e761 = phi_845_;
            let _e763 = phi_846_;
            if _e763 {
                if _e761.is_valid {
                    let _e766 = p.member.flags;
                    phi_858_ = ((_e766 & 1u) != 0u);
                    phi_859_ = false;
                } else {
                    phi_858_ = bool();
                    phi_859_ = true;
                }
                let _e770 = phi_858_;
                let _e772 = phi_859_;
                phi_860_ = _e770;
                phi_861_ = _e761;
                phi_862_ = _e772;
            } else {
                phi_860_ = bool();
                phi_861_ = _e703;
                phi_862_ = true;
            }
            let _e774 = phi_860_;
            let _e776 = phi_861_;
            let _e778 = phi_862_;
            if _e778 {
                phi_866_ = false;
                phi_867_ = _e776;
            } else {
                phi_866_ = _e774;
                phi_867_ = _e761;
            }
            let _e780 = phi_866_;
            let _e782 = phi_867_;
            let _e786 = lt_mask_Reprojection(_e782.pixel, _e780, _e782.has_moved);
            let _e788 = p.member.flags;
            let _e790 = ((_e788 & 2u) != 0u);
            let _e792 = p.member.flags;
            if ((_e792 & 4u) == 0u) {
                phi_966_ = u32();
                phi_967_ = true;
                phi_968_ = false;
            } else {
                if _e780 {
                    if !(_e786.has_moved) {
                        if (32u == 0u) {
                            return;
                        }
                        let _e798 = (_e81 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e81 % 32u) > 0u) {
                            phi_905_ = (_e798 + 1u);
                        } else {
                            phi_905_ = _e798;
                        }
                        let _e804 = phi_905_;
                        let _e809 = ((((_e53.y * _e804) + (_e53.x / 32u)) * 6u) + 4u);
                        if (_e809 < _e59) {
                        } else {
                            return;
                        }
                        let _e813 = heard.member[(0u + _e809)];
                        if (((_e813 >> bitcast<u32>(((_e53.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e824 = ((((_e53.y * _e804) + (_e53.x / 32u)) * 6u) + 5u);
                            if (_e824 < _e59) {
                            } else {
                                return;
                            }
                            let _e828 = heard.member[(0u + _e824)];
                            if false {
                                phi_954_ = (2u | 1u);
                            } else {
                                phi_954_ = 2u;
                            }
                            let _e837 = phi_954_;
                            if (((_e828 >> bitcast<u32>(((_e53.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_959_ = (_e837 | 4u);
                            } else {
                                phi_959_ = _e837;
                            }
                            let _e840 = phi_959_;
                            phi_960_ = _e840;
                        } else {
                            phi_960_ = 0u;
                        }
                        let _e842 = phi_960_;
                        phi_961_ = _e842;
                        phi_962_ = false;
                    } else {
                        phi_961_ = u32();
                        phi_962_ = true;
                    }
                    let _e844 = phi_961_;
                    let _e846 = phi_962_;
                    phi_963_ = _e844;
                    phi_964_ = false;
                    phi_965_ = _e846;
                } else {
                    phi_963_ = u32();
                    phi_964_ = true;
                    phi_965_ = false;
                }
                let _e848 = phi_963_;
                let _e850 = phi_964_;
                let _e852 = phi_965_;
                phi_966_ = _e848;
                phi_967_ = _e850;
                phi_968_ = _e852;
            }
            let _e854 = phi_966_;
            let _e856 = phi_967_;
            let _e858 = phi_968_;
            if _e856 {
                phi_972_ = true;
            } else {
                phi_972_ = _e858;
            }
            let _e860 = phi_972_;
            if _e860 {
                phi_976_ = 0u;
            } else {
                phi_976_ = _e854;
            }
            let _e862 = phi_976_;
            let _e863 = lt_mask_Neighbourhood(false, true);
            if _e248 {
                phi_981_ = _e790;
            } else {
                phi_981_ = true;
            }
            let _e865 = phi_981_;
            if _e865 {
                if _e780 {
                    if ((_e862 & 2u) != 0u) {
                        phi_1042_ = _e863;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e874 = (_e81 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e81 % 32u) > 0u) {
                            phi_1013_ = (_e874 + 1u);
                        } else {
                            phi_1013_ = _e874;
                        }
                        let _e880 = phi_1013_;
                        let _e890 = ((((_e786.pixel.y * _e880) + (_e786.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e244) | (select(0u, 1u, _e786.has_moved) << bitcast<u32>(1i))));
                        if (_e890 < _e59) {
                        } else {
                            return;
                        }
                        let _e894 = heard.member[(0u + _e890)];
                        let _e900 = (((_e894 >> bitcast<u32>(((_e786.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_1042_ = lt_mask_Neighbourhood(_e900, !(_e900));
                    }
                    let _e904 = phi_1042_;
                    phi_1043_ = _e904;
                } else {
                    phi_1043_ = _e863;
                }
                let _e906 = phi_1043_;
                phi_1044_ = _e906;
            } else {
                phi_1044_ = _e863;
            }
            let _e908 = phi_1044_;
            let _e911 = p.member.frame;
            let _e913 = p.member.refresh;
            if (_e913 == 0u) {
                phi_1077_ = false;
            } else {
                if (_e913 == 0u) {
                    return;
                }
                let _e922 = ((_e53.x + (_e53.y * (((_e913 * 5u) / 8u) | 1u))) + (_e911 % _e913));
                if (_e913 == 0u) {
                    phi_1076_ = (_e922 == 0u);
                } else {
                    if (_e913 == 0u) {
                        return;
                    }
                    phi_1076_ = ((_e922 % _e913) == 0u);
                }
                let _e929 = phi_1076_;
                phi_1077_ = _e929;
            }
            let _e931 = phi_1077_;
            if _e780 {
                if _e931 {
                    phi_1099_ = bool();
                } else {
                    phi_1099_ = ((_e862 & 2u) != 0u);
                }
                let _e937 = phi_1099_;
                phi_1100_ = _e937;
                phi_1101_ = _e931;
            } else {
                phi_1100_ = bool();
                phi_1101_ = true;
            }
            let _e939 = phi_1100_;
            let _e941 = phi_1101_;
            if _e941 {
                phi_1105_ = false;
            } else {
                phi_1105_ = _e939;
            }
            let _e943 = phi_1105_;
            if _e943 {
                phi_1156_ = 7u;
            } else {
                if (_e86 != 0.5f) {
                    if _e780 {
                        if _e931 {
                            phi_1153_ = 6u;
                        } else {
                            if _e248 {
                                phi_1128_ = true;
                            } else {
                                if _e908.any_expands {
                                    phi_1127_ = false;
                                } else {
                                    phi_1127_ = true;
                                }
                                let _e945 = phi_1127_;
                                phi_1128_ = _e945;
                            }
                            let _e947 = phi_1128_;
                            if _e947 {
                                if _e248 {
                                    if _e790 {
                                        if _e908.all_remove {
                                            phi_1141_ = false;
                                        } else {
                                            phi_1141_ = true;
                                        }
                                        let _e949 = phi_1141_;
                                        phi_1142_ = _e949;
                                    } else {
                                        phi_1142_ = true;
                                    }
                                    let _e951 = phi_1142_;
                                    phi_1143_ = _e951;
                                } else {
                                    phi_1143_ = true;
                                }
                                let _e953 = phi_1143_;
                                if _e953 {
                                    if _e248 {
                                        phi_1150_ = 1u;
                                    } else {
                                        phi_1150_ = 0u;
                                    }
                                    let _e955 = phi_1150_;
                                    phi_1151_ = _e955;
                                } else {
                                    phi_1151_ = 5u;
                                }
                                let _e957 = phi_1151_;
                                phi_1152_ = _e957;
                            } else {
                                phi_1152_ = 4u;
                            }
                            let _e959 = phi_1152_;
                            phi_1153_ = _e959;
                        }
                        let _e961 = phi_1153_;
                        phi_1154_ = _e961;
                    } else {
                        phi_1154_ = 3u;
                    }
                    let _e963 = phi_1154_;
                    phi_1155_ = _e963;
                } else {
                    phi_1155_ = 2u;
                }
                let _e965 = phi_1155_;
                phi_1156_ = _e965;
            }
            let _e967 = phi_1156_;
            if !((_e967 == 0u)) {
                if !((_e967 == 5u)) {
                    phi_1168_ = !(_e943);
                    phi_1169_ = false;
                } else {
                    phi_1168_ = bool();
                    phi_1169_ = true;
                }
                let _e974 = phi_1168_;
                let _e976 = phi_1169_;
                phi_1170_ = _e974;
                phi_1171_ = _e976;
            } else {
                phi_1170_ = bool();
                phi_1171_ = true;
            }
            let _e978 = phi_1170_;
            let _e980 = phi_1171_;
            if _e980 {
                phi_1175_ = false;
            } else {
                phi_1175_ = _e978;
            }
            let _e982 = phi_1175_;
            if _e943 {
                phi_1181_ = ((_e862 & 4u) != 0u);
            } else {
                phi_1181_ = _e244;
            }
            let _e986 = phi_1181_;
            if _e982 {
                if _e244 {
                    phi_1189_ = (2u | 1u);
                } else {
                    phi_1189_ = 2u;
                }
                let _e989 = phi_1189_;
                if false {
                    phi_1194_ = (_e989 | 4u);
                } else {
                    phi_1194_ = _e989;
                }
                let _e992 = phi_1194_;
                phi_1214_ = _e992;
            } else {
                if (_e967 == 7u) {
                    if _e244 {
                        phi_1203_ = (2u | 1u);
                    } else {
                        phi_1203_ = 2u;
                    }
                    let _e996 = phi_1203_;
                    if _e986 {
                        phi_1208_ = (_e996 | 4u);
                    } else {
                        phi_1208_ = _e996;
                    }
                    let _e999 = phi_1208_;
                    phi_1213_ = _e999;
                } else {
                    if _e244 {
                        phi_1212_ = 1u;
                    } else {
                        phi_1212_ = 0u;
                    }
                    let _e1001 = phi_1212_;
                    phi_1213_ = _e1001;
                }
                let _e1003 = phi_1213_;
                phi_1214_ = _e1003;
            }
            let _e1005 = phi_1214_;
            if _e986 {
                phi_1218_ = 0f;
            } else {
                phi_1218_ = 1f;
            }
            let _e1007 = phi_1218_;
            phi_1220_ = mask_Masked(_e1007, _e1005, _e982);
        }
        let _e1010 = phi_1220_;
        visibility.member[_e73.first_primitive] = _e1010.visibility;
        let _e1015 = p.member.light.number;
        let _e1016 = (_e1015 * 3u);
        let _e1018 = (_e1016 % 32u);
        let _e1020 = p.member.light.mask_words;
        let _e1022 = ((_e73.first_primitive * _e1020) + (_e1016 / 32u));
        let _e1024 = bits.member[_e1022];
        bits.member[_e1022] = ((_e1024 & ~((7u << bitcast<u32>((_e1018 & 31u))))) | (_e1010.bits << bitcast<u32>((_e1018 & 31u))));
        if (_e1018 > 29u) {
            let _e1039 = bits.member[(_e1022 + 1u)];
            let _e1041 = (32u - _e1018);
            bits.member[(_e1022 + 1u)] = ((_e1039 & ~((7u >> bitcast<u32>((_e1041 & 31u))))) | (_e1010.bits >> bitcast<u32>((_e1041 & 31u))));
        }
        let _e1056 = samples.member[_e73.first_primitive].normal[0u];
        let _e1058 = global[0u];
        if (_e1056 == _e1058) {
            let _e1061 = samples.member[_e73.first_primitive].normal[1u];
            let _e1063 = global[1u];
            if (_e1061 == _e1063) {
                let _e1066 = samples.member[_e73.first_primitive].normal[2u];
                let _e1068 = global[2u];
                phi_1292_ = (_e1066 == _e1068);
                phi_1293_ = false;
            } else {
                phi_1292_ = bool();
                phi_1293_ = true;
            }
            let _e1071 = phi_1292_;
            let _e1073 = phi_1293_;
            phi_1294_ = _e1071;
            phi_1295_ = _e1073;
        } else {
            phi_1294_ = bool();
            phi_1295_ = true;
        }
        let _e1075 = phi_1294_;
        let _e1077 = phi_1295_;
        if _e1077 {
            phi_1299_ = false;
        } else {
            phi_1299_ = _e1075;
        }
        let _e1079 = phi_1299_;
        if !(_e1079) {
            let _e1082 = samples.member[_e73.first_primitive].position;
            let _e1084 = p.member.current.eye;
            let _e1095 = p.member.current.forward;
            phi_1327_ = ((((_e1082.x - _e1084.x) * _e1095.x) + ((_e1082.y - _e1084.y) * _e1095.y)) + ((_e1082.z - _e1084.z) * _e1095.z));
        } else {
            phi_1327_ = 0f;
        }
        let _e1105 = phi_1327_;
        depths.member[_e73.first_primitive] = _e1105;
        phi_1330_ = _e1010.needs_ray;
        phi_1331_ = _e73.first_primitive;
    } else {
        phi_1330_ = false;
        phi_1331_ = 0u;
    }
    let _e1109 = phi_1330_;
    let _e1111 = phi_1331_;
    if (_e54 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1109 {
        let _e1115 = atomicAdd((&shared_[0u]), 1u);
        phi_1342_ = _e1115;
    } else {
        phi_1342_ = 0u;
    }
    let _e1117 = phi_1342_;
    workgroupBarrier();
    if (_e54 == 0u) {
        let _e1121 = atomicLoad((&shared_[0u]));
        let _e1122 = atomicAdd((&list.member[3u]), _e1121);
        atomicStore((&shared_[1u]), _e1122);
    }
    workgroupBarrier();
    if _e1109 {
        let _e1125 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1125) + _e1117)]), _e1111);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
