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
    var phi_165_: lt_bvh_traverse_Tree;
    var phi_166_: bool;
    var phi_167_: lt_bvh_traverse_Tree;
    var phi_168_: bool;
    var phi_173_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_165_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_166_ = false;
        } else {
            phi_165_ = lt_bvh_traverse_Tree();
            phi_166_ = true;
        }
        let _e65 = phi_165_;
        let _e67 = phi_166_;
        phi_167_ = _e65;
        phi_168_ = _e67;
    } else {
        phi_167_ = lt_bvh_traverse_Tree();
        phi_168_ = true;
    }
    let _e69 = phi_167_;
    let _e71 = phi_168_;
    if _e71 {
        phi_173_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_173_ = _e69;
    }
    let _e76 = phi_173_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn function_() {
    var phi_241_: bool;
    var phi_242_: bool;
    var phi_243_: bool;
    var phi_244_: bool;
    var phi_248_: bool;
    var phi_318_: bool;
    var phi_319_: bool;
    var phi_330_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_331_: bool;
    var phi_332_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_333_: bool;
    var phi_340_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_344_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_357_: bool;
    var phi_388_: bool;
    var phi_389_: bool;
    var phi_390_: bool;
    var phi_391_: bool;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_535_: f32;
    var phi_540_: f32;
    var phi_541_: bool;
    var phi_542_: f32;
    var phi_543_: bool;
    var phi_547_: f32;
    var phi_568_: f32;
    var phi_573_: f32;
    var phi_574_: bool;
    var phi_575_: f32;
    var phi_576_: bool;
    var phi_580_: f32;
    var phi_601_: bool;
    var phi_620_: vec2<u32>;
    var phi_621_: bool;
    var phi_622_: bool;
    var phi_623_: bool;
    var phi_624_: vec2<u32>;
    var phi_625_: bool;
    var phi_626_: bool;
    var phi_627_: bool;
    var phi_628_: bool;
    var phi_629_: bool;
    var phi_630_: bool;
    var phi_631_: vec2<u32>;
    var phi_632_: bool;
    var phi_633_: bool;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_636_: bool;
    var phi_637_: bool;
    var phi_638_: vec2<u32>;
    var phi_639_: bool;
    var phi_640_: bool;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_660_: vec2<u32>;
    var phi_698_: bool;
    var phi_700_: lt_mask_Reprojection;
    var phi_701_: lt_mask_Reprojection;
    var phi_702_: lt_mask_Reprojection;
    var phi_703_: bool;
    var phi_704_: bool;
    var phi_705_: lt_mask_Reprojection;
    var phi_706_: lt_mask_Reprojection;
    var phi_707_: lt_mask_Reprojection;
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_764_: bool;
    var phi_768_: f32;
    var phi_772_: lt_mask_Reprojection;
    var phi_773_: bool;
    var phi_785_: bool;
    var phi_786_: bool;
    var phi_787_: bool;
    var phi_788_: lt_mask_Reprojection;
    var phi_789_: bool;
    var phi_793_: bool;
    var phi_794_: lt_mask_Reprojection;
    var phi_832_: u32;
    var phi_881_: u32;
    var phi_886_: u32;
    var phi_887_: u32;
    var phi_888_: u32;
    var phi_889_: bool;
    var phi_890_: u32;
    var phi_891_: bool;
    var phi_892_: bool;
    var phi_893_: u32;
    var phi_894_: bool;
    var phi_895_: bool;
    var phi_899_: bool;
    var phi_903_: u32;
    var phi_908_: bool;
    var phi_940_: u32;
    var phi_969_: lt_mask_Neighbourhood;
    var phi_970_: lt_mask_Neighbourhood;
    var phi_971_: lt_mask_Neighbourhood;
    var phi_1003_: bool;
    var phi_1004_: bool;
    var phi_1026_: bool;
    var phi_1027_: bool;
    var phi_1028_: bool;
    var phi_1032_: bool;
    var phi_1054_: bool;
    var phi_1055_: bool;
    var phi_1068_: bool;
    var phi_1069_: bool;
    var phi_1070_: bool;
    var phi_1077_: u32;
    var phi_1078_: u32;
    var phi_1079_: u32;
    var phi_1080_: u32;
    var phi_1081_: u32;
    var phi_1082_: u32;
    var phi_1083_: u32;
    var phi_1095_: bool;
    var phi_1096_: bool;
    var phi_1097_: bool;
    var phi_1098_: bool;
    var phi_1102_: bool;
    var phi_1108_: bool;
    var phi_1116_: u32;
    var phi_1121_: u32;
    var phi_1130_: u32;
    var phi_1135_: u32;
    var phi_1139_: u32;
    var phi_1140_: u32;
    var phi_1141_: u32;
    var phi_1145_: f32;
    var phi_1147_: mask_Masked;
    var phi_1219_: bool;
    var phi_1220_: bool;
    var phi_1221_: bool;
    var phi_1222_: bool;
    var phi_1226_: bool;
    var phi_1254_: f32;
    var phi_1257_: bool;
    var phi_1258_: u32;
    var phi_1269_: u32;

    let _e52 = id_1;
    let _e53 = local_1;
    let _e58 = arrayLength((&heard.member));
    let _e69 = p.member.current.size[0u];
    let _e71 = p.member.current.size[1u];
    let _e72 = lt_shaders_entry_pixel_index(_e52, _e69, _e71);
    if (bitcast<i32>(_e72.root) != 0i) {
        let _e80 = p.member.current.size[0u];
        let _e83 = samples.member[_e72.first_primitive].position;
        let _e85 = visibility.member[_e72.first_primitive];
        let _e91 = samples.member[_e72.first_primitive].normal[0u];
        let _e93 = global[0u];
        if (_e91 == _e93) {
            let _e96 = samples.member[_e72.first_primitive].normal[1u];
            let _e98 = global[1u];
            if (_e96 == _e98) {
                let _e101 = samples.member[_e72.first_primitive].normal[2u];
                let _e103 = global[2u];
                phi_241_ = (_e101 == _e103);
                phi_242_ = false;
            } else {
                phi_241_ = bool();
                phi_242_ = true;
            }
            let _e106 = phi_241_;
            let _e108 = phi_242_;
            phi_243_ = _e106;
            phi_244_ = _e108;
        } else {
            phi_243_ = bool();
            phi_244_ = true;
        }
        let _e110 = phi_243_;
        let _e112 = phi_244_;
        if _e112 {
            phi_248_ = false;
        } else {
            phi_248_ = _e110;
        }
        let _e114 = phi_248_;
        if !(_e114) {
            let _e117 = samples.member[_e72.first_primitive].position;
            let _e119 = p.member.light.place;
            let _e125 = p.member.light.place[3u];
            let _e132 = (_e119.x - (_e117.x * _e125));
            let _e133 = (_e119.y - (_e117.y * _e125));
            let _e134 = (_e119.z - (_e117.z * _e125));
            let _e136 = samples.member[_e72.first_primitive].normal;
            if ((((_e136.x * _e132) + (_e136.y * _e133)) + (_e136.z * _e134)) > 0f) {
                let _e150 = (((_e132 * _e132) + (_e133 * _e133)) + (_e134 * _e134));
                let _e152 = p.member.light.axis;
                let _e164 = p.member.light.place[3u];
                if (_e164 == 0f) {
                    phi_319_ = true;
                } else {
                    let _e167 = p.member.light.range_squared;
                    if (_e150 <= _e167) {
                        let _e170 = p.member.light.cos_outer;
                        phi_318_ = (-((((_e132 * _e152.x) + (_e133 * _e152.y)) + (_e134 * _e152.z))) >= (_e170 * sqrt(_e150)));
                    } else {
                        phi_318_ = false;
                    }
                    let _e175 = phi_318_;
                    phi_319_ = _e175;
                }
                let _e177 = phi_319_;
                if _e177 {
                    let _e179 = samples.member[_e72.first_primitive].flags;
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e187.unnamed.visibility, false), _e187.unnamed_1);
                    phi_330_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e193.unnamed, ((_e179 & 1u) == 0u));
                    phi_331_ = false;
                } else {
                    phi_330_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_331_ = true;
                }
                let _e198 = phi_330_;
                let _e200 = phi_331_;
                phi_332_ = _e198;
                phi_333_ = _e200;
            } else {
                phi_332_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_333_ = true;
            }
            let _e202 = phi_332_;
            let _e204 = phi_333_;
            if _e204 {
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e210.unnamed.visibility, false), _e210.unnamed_1);
                phi_340_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e216.unnamed, true);
            } else {
                phi_340_ = _e202;
            }
            let _e221 = phi_340_;
            phi_344_ = _e221;
        } else {
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e233 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e227.unnamed.visibility, false), _e227.unnamed_1);
            phi_344_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e233.unnamed, true);
        }
        let _e238 = phi_344_;
        if _e238.unnamed_1 {
            phi_1147_ = mask_Masked(_e238.unnamed.visibility, 0u, false);
        } else {
            let _e243 = (_e85 < 0.5f);
            if (_e85 > 0f) {
                phi_357_ = (_e85 < 1f);
            } else {
                phi_357_ = false;
            }
            let _e247 = phi_357_;
            let _e254 = lt_mask_Reprojection(vec2<u32>(_e52.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e261 = lt_mask_Reprojection(vec2<u32>(_e254.pixel.x, _e52.y), _e254.is_valid, _e254.has_moved);
            let _e265 = lt_mask_Reprojection(_e261.pixel, true, _e261.has_moved);
            let _e271 = p.member.flags;
            if ((_e271 & 16u) == 0u) {
                phi_396_ = false;
            } else {
                let _e277 = samples.member[_e72.first_primitive].position[0u];
                if (_e83.x == _e277) {
                    let _e281 = samples.member[_e72.first_primitive].position[1u];
                    if (_e83.y == _e281) {
                        let _e285 = samples.member[_e72.first_primitive].position[2u];
                        phi_388_ = (_e83.z == _e285);
                        phi_389_ = false;
                    } else {
                        phi_388_ = bool();
                        phi_389_ = true;
                    }
                    let _e288 = phi_388_;
                    let _e290 = phi_389_;
                    phi_390_ = _e288;
                    phi_391_ = _e290;
                } else {
                    phi_390_ = bool();
                    phi_391_ = true;
                }
                let _e292 = phi_390_;
                let _e294 = phi_391_;
                if _e294 {
                    phi_395_ = false;
                } else {
                    phi_395_ = _e292;
                }
                let _e296 = phi_395_;
                phi_396_ = _e296;
            }
            let _e298 = phi_396_;
            if _e298 {
                phi_705_ = lt_mask_Reprojection(_e265.pixel, _e265.is_valid, false);
                phi_706_ = lt_mask_Reprojection();
                phi_707_ = lt_mask_Reprojection();
                phi_708_ = true;
                phi_709_ = false;
            } else {
                let _e302 = p.member.current.grid[0u];
                let _e304 = p.member.current.grid[1u];
                let _e318 = (f32(_e52.x) + ((f32((_e52.y & (_e304 - 1u))) + 0.5f) / f32(_e304)));
                let _e320 = (f32(_e52.y) + ((f32((_e52.x & (_e302 - 1u))) + 0.5f) / f32(_e302)));
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
                        phi_535_ = 1f;
                    } else {
                        phi_535_ = 0f;
                    }
                    let _e431 = phi_535_;
                    if (_e416 < 8388608f) {
                        phi_540_ = (_e428 - _e431);
                        phi_541_ = false;
                    } else {
                        phi_540_ = f32();
                        phi_541_ = true;
                    }
                    let _e434 = phi_540_;
                    let _e436 = phi_541_;
                    phi_542_ = _e434;
                    phi_543_ = _e436;
                } else {
                    phi_542_ = f32();
                    phi_543_ = true;
                }
                let _e438 = phi_542_;
                let _e440 = phi_543_;
                if _e440 {
                    phi_547_ = _e416;
                } else {
                    phi_547_ = _e438;
                }
                let _e442 = phi_547_;
                let _e443 = (_e320 + _e408);
                if (_e443 > -8388608f) {
                    let _e455 = f32(select(0i, select(select(i32(_e443), i32(-2147483648), (_e443 < bitcast<f32>(3472883712u))), 2147483647i, (_e443 > bitcast<f32>(1325400063u))), (_e443 == _e443)));
                    if (_e455 > _e443) {
                        phi_568_ = 1f;
                    } else {
                        phi_568_ = 0f;
                    }
                    let _e458 = phi_568_;
                    if (_e443 < 8388608f) {
                        phi_573_ = (_e455 - _e458);
                        phi_574_ = false;
                    } else {
                        phi_573_ = f32();
                        phi_574_ = true;
                    }
                    let _e461 = phi_573_;
                    let _e463 = phi_574_;
                    phi_575_ = _e461;
                    phi_576_ = _e463;
                } else {
                    phi_575_ = f32();
                    phi_576_ = true;
                }
                let _e465 = phi_575_;
                let _e467 = phi_576_;
                if _e467 {
                    phi_580_ = _e443;
                } else {
                    phi_580_ = _e465;
                }
                let _e469 = phi_580_;
                if (_e442 >= 0f) {
                    if (_e469 >= 0f) {
                        if (_e442 < f32(_e412)) {
                            let _e475 = (_e469 < f32(_e414));
                            if (_e407 == 0f) {
                                phi_601_ = (_e408 == 0f);
                            } else {
                                phi_601_ = false;
                            }
                            let _e479 = phi_601_;
                            if _e475 {
                                phi_620_ = vec2<u32>(select(select(u32(_e442), 0u, (_e442 < bitcast<f32>(0u))), 4294967295u, (_e442 > bitcast<f32>(1333788671u))), select(select(u32(_e469), 0u, (_e469 < bitcast<f32>(0u))), 4294967295u, (_e469 > bitcast<f32>(1333788671u))));
                                phi_621_ = false;
                            } else {
                                phi_620_ = vec2<u32>();
                                phi_621_ = true;
                            }
                            let _e496 = phi_620_;
                            let _e498 = phi_621_;
                            phi_622_ = _e479;
                            phi_623_ = _e475;
                            phi_624_ = _e496;
                            phi_625_ = _e479;
                            phi_626_ = _e475;
                            phi_627_ = false;
                            phi_628_ = _e498;
                        } else {
                            phi_622_ = bool();
                            phi_623_ = bool();
                            phi_624_ = vec2<u32>();
                            phi_625_ = bool();
                            phi_626_ = bool();
                            phi_627_ = true;
                            phi_628_ = false;
                        }
                        let _e500 = phi_622_;
                        let _e502 = phi_623_;
                        let _e504 = phi_624_;
                        let _e506 = phi_625_;
                        let _e508 = phi_626_;
                        let _e510 = phi_627_;
                        let _e512 = phi_628_;
                        phi_629_ = _e500;
                        phi_630_ = _e502;
                        phi_631_ = _e504;
                        phi_632_ = _e506;
                        phi_633_ = _e508;
                        phi_634_ = _e510;
                        phi_635_ = _e512;
                    } else {
                        phi_629_ = bool();
                        phi_630_ = bool();
                        phi_631_ = vec2<u32>();
                        phi_632_ = bool();
                        phi_633_ = bool();
                        phi_634_ = true;
                        phi_635_ = false;
                    }
                    let _e514 = phi_629_;
                    let _e516 = phi_630_;
                    let _e518 = phi_631_;
                    let _e520 = phi_632_;
                    let _e522 = phi_633_;
                    let _e524 = phi_634_;
                    let _e526 = phi_635_;
                    phi_636_ = _e514;
                    phi_637_ = _e516;
                    phi_638_ = _e518;
                    phi_639_ = _e520;
                    phi_640_ = _e522;
                    phi_641_ = _e524;
                    phi_642_ = _e526;
                } else {
                    phi_636_ = bool();
                    phi_637_ = bool();
                    phi_638_ = vec2<u32>();
                    phi_639_ = bool();
                    phi_640_ = bool();
                    phi_641_ = true;
                    phi_642_ = false;
                }
                let _e528 = phi_636_;
                let _e530 = phi_637_;
                let _e532 = phi_638_;
                let _e534 = phi_639_;
                let _e536 = phi_640_;
                let _e538 = phi_641_;
                let _e540 = phi_642_;
                if _e538 {
                    if (_e407 == 0f) {
                        phi_651_ = (_e408 == 0f);
                    } else {
                        phi_651_ = false;
                    }
                    let _e544 = phi_651_;
                    phi_652_ = _e544;
                    phi_653_ = false;
                    phi_654_ = true;
                } else {
                    phi_652_ = _e534;
                    phi_653_ = _e536;
                    phi_654_ = _e540;
                }
                let _e546 = phi_652_;
                let _e548 = phi_653_;
                let _e550 = phi_654_;
                if _e550 {
                    phi_658_ = _e546;
                    phi_659_ = _e548;
                    phi_660_ = vec2<u32>(_e52.x, _e52.y);
                } else {
                    phi_658_ = _e528;
                    phi_659_ = _e530;
                    phi_660_ = _e532;
                }
                let _e552 = phi_658_;
                let _e554 = phi_659_;
                let _e556 = phi_660_;
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
                        phi_698_ = false;
                    } else {
                        phi_698_ = true;
                    }
                    let _e610 = phi_698_;
                    phi_700_ = _e608;
                    phi_701_ = _e608;
                    phi_702_ = lt_mask_Reprojection();
                    phi_703_ = _e604;
                    phi_704_ = _e610;
                } else {
                    phi_700_ = lt_mask_Reprojection();
                    phi_701_ = lt_mask_Reprojection();
                    phi_702_ = lt_mask_Reprojection(_e581.pixel, false, _e581.has_moved);
                    phi_703_ = false;
                    phi_704_ = false;
                }
                let _e616 = phi_700_;
                let _e618 = phi_701_;
                let _e620 = phi_702_;
                let _e622 = phi_703_;
                let _e624 = phi_704_;
                phi_705_ = _e616;
                phi_706_ = _e618;
                phi_707_ = _e620;
                phi_708_ = _e622;
                phi_709_ = _e624;
            }
            let _e626 = phi_705_;
            let _e628 = phi_706_;
            let _e630 = phi_707_;
            let _e632 = phi_708_;
            let _e634 = phi_709_;
            if _e632 {
                let _e637 = p.member.previous.eye;
                let _e648 = p.member.previous.forward;
                let _e656 = ((((_e83.x - _e637.x) * _e648.x) + ((_e83.y - _e637.y) * _e648.y)) + ((_e83.z - _e637.z) * _e648.z));
                let _e662 = ((_e626.pixel.y * _e80) + _e626.pixel.x);
                if (_e662 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e666 = last_depths.member[(0u + _e662)];
                let _e668 = p.member.depth_tolerance;
                let _e671 = abs(_e656);
                let _e672 = abs(_e666);
                if ((bitcast<u32>(_e672) & 2147483647u) > 2139095040u) {
                    phi_764_ = true;
                } else {
                    let _e676 = (_e672 > _e671);
                    if _e676 {
                    }
                    phi_764_ = _e676;
                }
                let _e678 = phi_764_;
                if _e678 {
                    phi_768_ = _e672;
                } else {
                    phi_768_ = _e671;
                }
                let _e680 = phi_768_;
                phi_772_ = lt_mask_Reprojection(_e626.pixel, (abs((_e656 - _e666)) <= (_e668 * _e680)), _e626.has_moved);
                phi_773_ = true;
            } else {
                phi_772_ = _e628;
                phi_773_ = _e634;
            }
            let _e688 = phi_772_;
            let _e690 = phi_773_;
            if _e690 {
                if _e688.is_valid {
                    let _e693 = p.member.flags;
                    phi_785_ = ((_e693 & 1u) != 0u);
                    phi_786_ = false;
                } else {
                    phi_785_ = bool();
                    phi_786_ = true;
                }
                let _e697 = phi_785_;
                let _e699 = phi_786_;
                phi_787_ = _e697;
                phi_788_ = _e688;
                phi_789_ = _e699;
            } else {
                phi_787_ = bool();
                phi_788_ = _e630;
                phi_789_ = true;
            }
            let _e701 = phi_787_;
            let _e703 = phi_788_;
            let _e705 = phi_789_;
            if _e705 {
                phi_793_ = false;
                phi_794_ = _e703;
            } else {
                phi_793_ = _e701;
                phi_794_ = _e688;
            }
            let _e707 = phi_793_;
            let _e709 = phi_794_;
            let _e713 = lt_mask_Reprojection(_e709.pixel, _e707, _e709.has_moved);
            let _e715 = p.member.flags;
            let _e717 = ((_e715 & 2u) != 0u);
            let _e719 = p.member.flags;
            if ((_e719 & 4u) == 0u) {
                phi_893_ = u32();
                phi_894_ = true;
                phi_895_ = false;
            } else {
                if _e707 {
                    if !(_e713.has_moved) {
                        if (32u == 0u) {
                            return;
                        }
                        let _e725 = (_e80 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e80 % 32u) > 0u) {
                            phi_832_ = (_e725 + 1u);
                        } else {
                            phi_832_ = _e725;
                        }
                        let _e731 = phi_832_;
                        let _e736 = ((((_e52.y * _e731) + (_e52.x / 32u)) * 6u) + 4u);
                        if (_e736 < _e58) {
                        } else {
                            return;
                        }
                        let _e740 = heard.member[(0u + _e736)];
                        if (((_e740 >> bitcast<u32>(((_e52.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e751 = ((((_e52.y * _e731) + (_e52.x / 32u)) * 6u) + 5u);
                            if (_e751 < _e58) {
                            } else {
                                return;
                            }
                            let _e755 = heard.member[(0u + _e751)];
                            if false {
                                phi_881_ = (2u | 1u);
                            } else {
                                phi_881_ = 2u;
                            }
                            let _e764 = phi_881_;
                            if (((_e755 >> bitcast<u32>(((_e52.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_886_ = (_e764 | 4u);
                            } else {
                                phi_886_ = _e764;
                            }
                            let _e767 = phi_886_;
                            phi_887_ = _e767;
                        } else {
                            phi_887_ = 0u;
                        }
                        let _e769 = phi_887_;
                        phi_888_ = _e769;
                        phi_889_ = false;
                    } else {
                        phi_888_ = u32();
                        phi_889_ = true;
                    }
                    let _e771 = phi_888_;
                    let _e773 = phi_889_;
                    phi_890_ = _e771;
                    phi_891_ = false;
                    phi_892_ = _e773;
                } else {
                    phi_890_ = u32();
                    phi_891_ = true;
                    phi_892_ = false;
                }
                let _e775 = phi_890_;
                let _e777 = phi_891_;
                let _e779 = phi_892_;
                phi_893_ = _e775;
                phi_894_ = _e777;
                phi_895_ = _e779;
            }
            let _e781 = phi_893_;
            let _e783 = phi_894_;
            let _e785 = phi_895_;
            if _e783 {
                phi_899_ = true;
            } else {
                phi_899_ = _e785;
            }
            let _e787 = phi_899_;
            if _e787 {
                phi_903_ = 0u;
            } else {
                phi_903_ = _e781;
            }
            let _e789 = phi_903_;
            let _e790 = lt_mask_Neighbourhood(false, true);
            if _e247 {
                phi_908_ = _e717;
            } else {
                phi_908_ = true;
            }
            let _e792 = phi_908_;
            if _e792 {
                if _e707 {
                    if ((_e789 & 2u) != 0u) {
                        phi_969_ = _e790;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e801 = (_e80 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e80 % 32u) > 0u) {
                            phi_940_ = (_e801 + 1u);
                        } else {
                            phi_940_ = _e801;
                        }
                        let _e807 = phi_940_;
                        let _e817 = ((((_e713.pixel.y * _e807) + (_e713.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e243) | (select(0u, 1u, _e713.has_moved) << bitcast<u32>(1i))));
                        if (_e817 < _e58) {
                        } else {
                            return;
                        }
                        let _e821 = heard.member[(0u + _e817)];
                        let _e827 = (((_e821 >> bitcast<u32>(((_e713.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_969_ = lt_mask_Neighbourhood(_e827, !(_e827));
                    }
                    let _e831 = phi_969_;
                    phi_970_ = _e831;
                } else {
                    phi_970_ = _e790;
                }
                let _e833 = phi_970_;
                phi_971_ = _e833;
            } else {
                phi_971_ = _e790;
            }
            let _e835 = phi_971_;
            let _e838 = p.member.frame;
            let _e840 = p.member.refresh;
            if (_e840 == 0u) {
                phi_1004_ = false;
            } else {
                if (_e840 == 0u) {
                    return;
                }
                let _e849 = ((_e52.x + (_e52.y * (((_e840 * 5u) / 8u) | 1u))) + (_e838 % _e840));
                if (_e840 == 0u) {
                    phi_1003_ = (_e849 == 0u);
                } else {
                    if (_e840 == 0u) {
                        return;
                    }
                    phi_1003_ = ((_e849 % _e840) == 0u);
                }
                let _e856 = phi_1003_;
                phi_1004_ = _e856;
            }
            let _e858 = phi_1004_;
            if _e707 {
                if _e858 {
                    phi_1026_ = bool();
                } else {
                    phi_1026_ = ((_e789 & 2u) != 0u);
                }
                let _e864 = phi_1026_;
                phi_1027_ = _e864;
                phi_1028_ = _e858;
            } else {
                phi_1027_ = bool();
                phi_1028_ = true;
            }
            let _e866 = phi_1027_;
            let _e868 = phi_1028_;
            if _e868 {
                phi_1032_ = false;
            } else {
                phi_1032_ = _e866;
            }
            let _e870 = phi_1032_;
            if _e870 {
                phi_1083_ = 7u;
            } else {
                if (_e85 != 0.5f) {
                    if _e707 {
                        if _e858 {
                            phi_1080_ = 6u;
                        } else {
                            if _e247 {
                                phi_1055_ = true;
                            } else {
                                if _e835.any_expands {
                                    phi_1054_ = false;
                                } else {
                                    phi_1054_ = true;
                                }
                                let _e872 = phi_1054_;
                                phi_1055_ = _e872;
                            }
                            let _e874 = phi_1055_;
                            if _e874 {
                                if _e247 {
                                    if _e717 {
                                        if _e835.all_remove {
                                            phi_1068_ = false;
                                        } else {
                                            phi_1068_ = true;
                                        }
                                        let _e876 = phi_1068_;
                                        phi_1069_ = _e876;
                                    } else {
                                        phi_1069_ = true;
                                    }
                                    let _e878 = phi_1069_;
                                    phi_1070_ = _e878;
                                } else {
                                    phi_1070_ = true;
                                }
                                let _e880 = phi_1070_;
                                if _e880 {
                                    if _e247 {
                                        phi_1077_ = 1u;
                                    } else {
                                        phi_1077_ = 0u;
                                    }
                                    let _e882 = phi_1077_;
                                    phi_1078_ = _e882;
                                } else {
                                    phi_1078_ = 5u;
                                }
                                let _e884 = phi_1078_;
                                phi_1079_ = _e884;
                            } else {
                                phi_1079_ = 4u;
                            }
                            let _e886 = phi_1079_;
                            phi_1080_ = _e886;
                        }
                        let _e888 = phi_1080_;
                        phi_1081_ = _e888;
                    } else {
                        phi_1081_ = 3u;
                    }
                    let _e890 = phi_1081_;
                    phi_1082_ = _e890;
                } else {
                    phi_1082_ = 2u;
                }
                let _e892 = phi_1082_;
                phi_1083_ = _e892;
            }
            let _e894 = phi_1083_;
            if !((_e894 == 0u)) {
                if !((_e894 == 5u)) {
                    phi_1095_ = !(_e870);
                    phi_1096_ = false;
                } else {
                    phi_1095_ = bool();
                    phi_1096_ = true;
                }
                let _e901 = phi_1095_;
                let _e903 = phi_1096_;
                phi_1097_ = _e901;
                phi_1098_ = _e903;
            } else {
                phi_1097_ = bool();
                phi_1098_ = true;
            }
            let _e905 = phi_1097_;
            let _e907 = phi_1098_;
            if _e907 {
                phi_1102_ = false;
            } else {
                phi_1102_ = _e905;
            }
            let _e909 = phi_1102_;
            if _e870 {
                phi_1108_ = ((_e789 & 4u) != 0u);
            } else {
                phi_1108_ = _e243;
            }
            let _e913 = phi_1108_;
            if _e909 {
                if _e243 {
                    phi_1116_ = (2u | 1u);
                } else {
                    phi_1116_ = 2u;
                }
                let _e916 = phi_1116_;
                if false {
                    phi_1121_ = (_e916 | 4u);
                } else {
                    phi_1121_ = _e916;
                }
                let _e919 = phi_1121_;
                phi_1141_ = _e919;
            } else {
                if (_e894 == 7u) {
                    if _e243 {
                        phi_1130_ = (2u | 1u);
                    } else {
                        phi_1130_ = 2u;
                    }
                    let _e923 = phi_1130_;
                    if _e913 {
                        phi_1135_ = (_e923 | 4u);
                    } else {
                        phi_1135_ = _e923;
                    }
                    let _e926 = phi_1135_;
                    phi_1140_ = _e926;
                } else {
                    if _e243 {
                        phi_1139_ = 1u;
                    } else {
                        phi_1139_ = 0u;
                    }
                    let _e928 = phi_1139_;
                    phi_1140_ = _e928;
                }
                let _e930 = phi_1140_;
                phi_1141_ = _e930;
            }
            let _e932 = phi_1141_;
            if _e913 {
                phi_1145_ = 0f;
            } else {
                phi_1145_ = 1f;
            }
            let _e934 = phi_1145_;
            phi_1147_ = mask_Masked(_e934, _e932, _e909);
        }
        let _e937 = phi_1147_;
        visibility.member[_e72.first_primitive] = _e937.visibility;
        let _e942 = p.member.light.number;
        let _e943 = (_e942 * 3u);
        let _e945 = (_e943 % 32u);
        let _e947 = p.member.light.mask_words;
        let _e949 = ((_e72.first_primitive * _e947) + (_e943 / 32u));
        let _e951 = bits.member[_e949];
        bits.member[_e949] = ((_e951 & ~((7u << bitcast<u32>((_e945 & 31u))))) | (_e937.bits << bitcast<u32>((_e945 & 31u))));
        if (_e945 > 29u) {
            let _e966 = bits.member[(_e949 + 1u)];
            let _e968 = (32u - _e945);
            bits.member[(_e949 + 1u)] = ((_e966 & ~((7u >> bitcast<u32>((_e968 & 31u))))) | (_e937.bits >> bitcast<u32>((_e968 & 31u))));
        }
        let _e983 = samples.member[_e72.first_primitive].normal[0u];
        let _e985 = global[0u];
        if (_e983 == _e985) {
            let _e988 = samples.member[_e72.first_primitive].normal[1u];
            let _e990 = global[1u];
            if (_e988 == _e990) {
                let _e993 = samples.member[_e72.first_primitive].normal[2u];
                let _e995 = global[2u];
                phi_1219_ = (_e993 == _e995);
                phi_1220_ = false;
            } else {
                phi_1219_ = bool();
                phi_1220_ = true;
            }
            let _e998 = phi_1219_;
            let _e1000 = phi_1220_;
            phi_1221_ = _e998;
            phi_1222_ = _e1000;
        } else {
            phi_1221_ = bool();
            phi_1222_ = true;
        }
        let _e1002 = phi_1221_;
        let _e1004 = phi_1222_;
        if _e1004 {
            phi_1226_ = false;
        } else {
            phi_1226_ = _e1002;
        }
        let _e1006 = phi_1226_;
        if !(_e1006) {
            let _e1009 = samples.member[_e72.first_primitive].position;
            let _e1011 = p.member.current.eye;
            let _e1022 = p.member.current.forward;
            phi_1254_ = ((((_e1009.x - _e1011.x) * _e1022.x) + ((_e1009.y - _e1011.y) * _e1022.y)) + ((_e1009.z - _e1011.z) * _e1022.z));
        } else {
            phi_1254_ = 0f;
        }
        let _e1032 = phi_1254_;
        depths.member[_e72.first_primitive] = _e1032;
        phi_1257_ = _e937.needs_ray;
        phi_1258_ = _e72.first_primitive;
    } else {
        phi_1257_ = false;
        phi_1258_ = 0u;
    }
    let _e1036 = phi_1257_;
    let _e1038 = phi_1258_;
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1036 {
        let _e1042 = atomicAdd((&shared_[0u]), 1u);
        phi_1269_ = _e1042;
    } else {
        phi_1269_ = 0u;
    }
    let _e1044 = phi_1269_;
    workgroupBarrier();
    if (_e53 == 0u) {
        let _e1048 = atomicLoad((&shared_[0u]));
        let _e1049 = atomicAdd((&list.member[3u]), _e1048);
        atomicStore((&shared_[1u]), _e1049);
    }
    workgroupBarrier();
    if _e1036 {
        let _e1052 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1052) + _e1044)]), _e1038);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
