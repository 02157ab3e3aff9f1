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
    var phi_170_: lt_bvh_traverse_Tree;
    var phi_171_: bool;
    var phi_172_: lt_bvh_traverse_Tree;
    var phi_173_: bool;
    var phi_178_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_170_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_171_ = false;
        } else {
            phi_170_ = lt_bvh_traverse_Tree();
            phi_171_ = true;
        }
        let _e65 = phi_170_;
        let _e67 = phi_171_;
        phi_172_ = _e65;
        phi_173_ = _e67;
    } else {
        phi_172_ = lt_bvh_traverse_Tree();
        phi_173_ = true;
    }
    let _e69 = phi_172_;
    let _e71 = phi_173_;
    if _e71 {
        phi_178_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_178_ = _e69;
    }
    let _e76 = phi_178_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn function_() {
    var phi_250_: bool;
    var phi_251_: bool;
    var phi_252_: bool;
    var phi_253_: bool;
    var phi_257_: bool;
    var phi_327_: bool;
    var phi_328_: bool;
    var phi_339_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_340_: bool;
    var phi_341_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_342_: bool;
    var phi_349_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_353_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_366_: bool;
    var phi_394_: bool;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_397_: bool;
    var phi_401_: bool;
    var phi_402_: bool;
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
    var phi_761_: bool;
    var phi_765_: f32;
    var phi_769_: lt_mask_Reprojection;
    var phi_770_: bool;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_785_: lt_mask_Reprojection;
    var phi_786_: bool;
    var phi_790_: bool;
    var phi_791_: lt_mask_Reprojection;
    var phi_797_: bool;
    var phi_829_: u32;
    var phi_858_: lt_mask_Neighbourhood;
    var phi_859_: lt_mask_Neighbourhood;
    var phi_860_: lt_mask_Neighbourhood;
    var phi_892_: bool;
    var phi_893_: bool;
    var phi_915_: bool;
    var phi_916_: bool;
    var phi_917_: bool;
    var phi_921_: bool;
    var phi_943_: bool;
    var phi_944_: bool;
    var phi_957_: bool;
    var phi_958_: bool;
    var phi_959_: bool;
    var phi_966_: u32;
    var phi_967_: u32;
    var phi_968_: u32;
    var phi_969_: u32;
    var phi_970_: u32;
    var phi_971_: u32;
    var phi_972_: u32;
    var phi_984_: bool;
    var phi_985_: bool;
    var phi_986_: bool;
    var phi_987_: bool;
    var phi_991_: bool;
    var phi_997_: bool;
    var phi_1005_: u32;
    var phi_1010_: u32;
    var phi_1019_: u32;
    var phi_1024_: u32;
    var phi_1028_: u32;
    var phi_1029_: u32;
    var phi_1030_: u32;
    var phi_1034_: f32;
    var phi_1036_: mask_Masked;
    var phi_1108_: bool;
    var phi_1109_: bool;
    var phi_1110_: bool;
    var phi_1111_: bool;
    var phi_1115_: bool;
    var phi_1143_: f32;
    var phi_1146_: bool;
    var phi_1147_: u32;
    var phi_1158_: u32;

    let _e52 = id_1;
    let _e53 = local_1;
    let _e70 = p.member.current.size[0u];
    let _e72 = p.member.current.size[1u];
    let _e73 = lt_shaders_entry_pixel_index(_e52, _e70, _e72);
    if (bitcast<i32>(_e73.root) != 0i) {
        let _e81 = p.member.current.size[0u];
        let _e84 = past.member[_e73.first_primitive];
        let _e89 = visibility.member[_e73.first_primitive];
        let _e95 = samples.member[_e73.first_primitive].normal[0u];
        let _e97 = global[0u];
        if (_e95 == _e97) {
            let _e100 = samples.member[_e73.first_primitive].normal[1u];
            let _e102 = global[1u];
            if (_e100 == _e102) {
                let _e105 = samples.member[_e73.first_primitive].normal[2u];
                let _e107 = global[2u];
                phi_250_ = (_e105 == _e107);
                phi_251_ = false;
            } else {
                phi_250_ = bool();
                phi_251_ = true;
            }
            let _e110 = phi_250_;
            let _e112 = phi_251_;
            phi_252_ = _e110;
            phi_253_ = _e112;
        } else {
            phi_252_ = bool();
            phi_253_ = true;
        }
        let _e114 = phi_252_;
        let _e116 = phi_253_;
        if _e116 {
            phi_257_ = false;
        } else {
            phi_257_ = _e114;
        }
        let _e118 = phi_257_;
        if !(_e118) {
            let _e121 = samples.member[_e73.first_primitive].position;
            let _e123 = p.member.light.place;
            let _e129 = p.member.light.place[3u];
            let _e136 = (_e123.x - (_e121.x * _e129));
            let _e137 = (_e123.y - (_e121.y * _e129));
            let _e138 = (_e123.z - (_e121.z * _e129));
            let _e140 = samples.member[_e73.first_primitive].normal;
            if ((((_e140.x * _e136) + (_e140.y * _e137)) + (_e140.z * _e138)) > 0f) {
                let _e154 = (((_e136 * _e136) + (_e137 * _e137)) + (_e138 * _e138));
                let _e156 = p.member.light.axis;
                let _e168 = p.member.light.place[3u];
                if (_e168 == 0f) {
                    phi_328_ = true;
                } else {
                    let _e171 = p.member.light.range_squared;
                    if (_e154 <= _e171) {
                        let _e174 = p.member.light.cos_outer;
                        phi_327_ = (-((((_e136 * _e156.x) + (_e137 * _e156.y)) + (_e138 * _e156.z))) >= (_e174 * sqrt(_e154)));
                    } else {
                        phi_327_ = false;
                    }
                    let _e179 = phi_327_;
                    phi_328_ = _e179;
                }
                let _e181 = phi_328_;
                if _e181 {
                    let _e183 = samples.member[_e73.first_primitive].flags;
                    let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                    phi_339_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, ((_e183 & 1u) == 0u));
                    phi_340_ = false;
                } else {
                    phi_339_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_340_ = true;
                }
                let _e202 = phi_339_;
                let _e204 = phi_340_;
                phi_341_ = _e202;
                phi_342_ = _e204;
            } else {
                phi_341_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_342_ = true;
            }
            let _e206 = phi_341_;
            let _e208 = phi_342_;
            if _e208 {
                let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e214.unnamed.visibility, false), _e214.unnamed_1);
                phi_349_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e220.unnamed, true);
            } else {
                phi_349_ = _e206;
            }
            let _e225 = phi_349_;
            phi_353_ = _e225;
        } else {
            let _e231 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e237 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e231.unnamed.visibility, false), _e231.unnamed_1);
            phi_353_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e237.unnamed, true);
        }
        let _e242 = phi_353_;
        if _e242.unnamed_1 {
            phi_1036_ = mask_Masked(_e242.unnamed.visibility, 0u, false);
        } else {
            let _e247 = (_e89 < 0.5f);
            if (_e89 > 0f) {
                phi_366_ = (_e89 < 1f);
            } else {
                phi_366_ = false;
            }
            let _e251 = phi_366_;
            let _e258 = lt_mask_Reprojection(vec2<u32>(_e52.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e265 = lt_mask_Reprojection(vec2<u32>(_e258.pixel.x, _e52.y), _e258.is_valid, _e258.has_moved);
            let _e269 = lt_mask_Reprojection(_e265.pixel, true, _e265.has_moved);
            let _e275 = p.member.flags;
            if ((_e275 & 16u) == 0u) {
                phi_402_ = false;
            } else {
                let _e280 = samples.member[_e73.first_primitive].position[0u];
                if (_e84.x == _e280) {
                    let _e283 = samples.member[_e73.first_primitive].position[1u];
                    if (_e84.y == _e283) {
                        let _e286 = samples.member[_e73.first_primitive].position[2u];
                        phi_394_ = (_e84.z == _e286);
                        phi_395_ = false;
                    } else {
                        phi_394_ = bool();
                        phi_395_ = true;
                    }
                    let _e289 = phi_394_;
                    let _e291 = phi_395_;
                    phi_396_ = _e289;
                    phi_397_ = _e291;
                } else {
                    phi_396_ = bool();
                    phi_397_ = true;
                }
                let _e293 = phi_396_;
                let _e295 = phi_397_;
                if _e295 {
                    phi_401_ = false;
                } else {
                    phi_401_ = _e293;
                }
                let _e297 = phi_401_;
                phi_402_ = _e297;
            }
            let _e299 = phi_402_;
            if _e299 {
                phi_705_ = lt_mask_Reprojection(_e269.pixel, _e269.is_valid, false);
                phi_706_ = lt_mask_Reprojection();
                phi_707_ = lt_mask_Reprojection();
                phi_708_ = true;
                phi_709_ = false;
            } else {
                let _e303 = p.member.current.grid[0u];
                let _e305 = p.member.current.grid[1u];
                let _e319 = (f32(_e52.x) + ((f32((_e52.y & (_e305 - 1u))) + 0.5f) / f32(_e305)));
                let _e321 = (f32(_e52.y) + ((f32((_e52.x & (_e303 - 1u))) + 0.5f) / f32(_e303)));
                let _e324 = p.member.previous.eye;
                let _e326 = (_e84.x - _e324.x);
                let _e328 = (_e84.y - _e324.y);
                let _e330 = (_e84.z - _e324.z);
                let _e332 = p.member.previous.forward;
                let _e340 = (((_e326 * _e332.x) + (_e328 * _e332.y)) + (_e330 * _e332.z));
                let _e342 = p.member.previous.right;
                let _e352 = p.member.previous.right;
                let _e367 = p.member.previous.up;
                let _e377 = p.member.previous.up;
                let _e394 = p.member.previous.size[0u];
                let _e401 = p.member.previous.size[1u];
                let _e405 = (((((((_e326 * _e342.x) + (_e328 * _e342.y)) + (_e330 * _e342.z)) / ((((_e352.x * _e352.x) + (_e352.y * _e352.y)) + (_e352.z * _e352.z)) * _e340)) + 1f) * (0.5f * f32(_e394))) - _e319);
                let _e406 = (((1f - ((((_e326 * _e367.x) + (_e328 * _e367.y)) + (_e330 * _e367.z)) / ((((_e377.x * _e377.x) + (_e377.y * _e377.y)) + (_e377.z * _e377.z)) * _e340))) * (0.5f * f32(_e401))) - _e321);
                let _e410 = p.member.current.size[0u];
                let _e412 = p.member.current.size[1u];
                let _e414 = (_e319 + _e405);
                if (_e414 > -8388608f) {
                    let _e426 = f32(select(0i, select(select(i32(_e414), i32(-2147483648), (_e414 < bitcast<f32>(3472883712u))), 2147483647i, (_e414 > bitcast<f32>(1325400063u))), (_e414 == _e414)));
                    if (_e426 > _e414) {
                        phi_538_ = 1f;
                    } else {
                        phi_538_ = 0f;
                    }
                    let _e429 = phi_538_;
                    if (_e414 < 8388608f) {
                        phi_543_ = (_e426 - _e429);
                        phi_544_ = false;
                    } else {
                        phi_543_ = f32();
                        phi_544_ = true;
                    }
                    let _e432 = phi_543_;
                    let _e434 = phi_544_;
                    phi_545_ = _e432;
                    phi_546_ = _e434;
                } else {
                    phi_545_ = f32();
                    phi_546_ = true;
                }
                let _e436 = phi_545_;
                let _e438 = phi_546_;
                if _e438 {
                    phi_550_ = _e414;
                } else {
                    phi_550_ = _e436;
                }
                let _e440 = phi_550_;
                let _e441 = (_e321 + _e406);
                if (_e441 > -8388608f) {
                    let _e453 = f32(select(0i, select(select(i32(_e441), i32(-2147483648), (_e441 < bitcast<f32>(3472883712u))), 2147483647i, (_e441 > bitcast<f32>(1325400063u))), (_e441 == _e441)));
                    if (_e453 > _e441) {
                        phi_571_ = 1f;
                    } else {
                        phi_571_ = 0f;
                    }
                    let _e456 = phi_571_;
                    if (_e441 < 8388608f) {
                        phi_576_ = (_e453 - _e456);
                        phi_577_ = false;
                    } else {
                        phi_576_ = f32();
                        phi_577_ = true;
                    }
                    let _e459 = phi_576_;
                    let _e461 = phi_577_;
                    phi_578_ = _e459;
                    phi_579_ = _e461;
                } else {
                    phi_578_ = f32();
                    phi_579_ = true;
                }
                let _e463 = phi_578_;
                let _e465 = phi_579_;
                if _e465 {
                    phi_583_ = _e441;
                } else {
                    phi_583_ = _e463;
                }
                let _e467 = phi_583_;
                if (_e440 >= 0f) {
                    if (_e467 >= 0f) {
                        if (_e440 < f32(_e410)) {
                            let _e473 = (_e467 < f32(_e412));
                            if (_e405 == 0f) {
                                phi_604_ = (_e406 == 0f);
                            } else {
                                phi_604_ = false;
                            }
                            let _e477 = phi_604_;
                            if _e473 {
                                phi_623_ = vec2<u32>(select(select(u32(_e440), 0u, (_e440 < bitcast<f32>(0u))), 4294967295u, (_e440 > bitcast<f32>(1333788671u))), select(select(u32(_e467), 0u, (_e467 < bitcast<f32>(0u))), 4294967295u, (_e467 > bitcast<f32>(1333788671u))));
                                phi_624_ = false;
                            } else {
                                phi_623_ = vec2<u32>();
                                phi_624_ = true;
                            }
                            let _e494 = phi_623_;
                            let _e496 = phi_624_;
                            phi_625_ = _e477;
                            phi_626_ = _e473;
                            phi_627_ = _e494;
                            phi_628_ = _e477;
                            phi_629_ = _e473;
                            phi_630_ = false;
                            phi_631_ = _e496;
                        } else {
                            phi_625_ = bool();
                            phi_626_ = bool();
                            phi_627_ = vec2<u32>();
                            phi_628_ = bool();
                            phi_629_ = bool();
                            phi_630_ = true;
                            phi_631_ = false;
                        }
                        let _e498 = phi_625_;
                        let _e500 = phi_626_;
                        let _e502 = phi_627_;
                        let _e504 = phi_628_;
                        let _e506 = phi_629_;
                        let _e508 = phi_630_;
                        let _e510 = phi_631_;
                        phi_632_ = _e498;
                        phi_633_ = _e500;
                        phi_634_ = _e502;
                        phi_635_ = _e504;
                        phi_636_ = _e506;
                        phi_637_ = _e508;
                        phi_638_ = _e510;
                    } else {
                        phi_632_ = bool();
                        phi_633_ = bool();
                        phi_634_ = vec2<u32>();
                        phi_635_ = bool();
                        phi_636_ = bool();
                        phi_637_ = true;
                        phi_638_ = false;
                    }
                    let _e512 = phi_632_;
                    let _e514 = phi_633_;
                    let _e516 = phi_634_;
                    let _e518 = phi_635_;
                    let _e520 = phi_636_;
                    let _e522 = phi_637_;
                    let _e524 = phi_638_;
                    phi_639_ = _e512;
                    phi_640_ = _e514;
                    phi_641_ = _e516;
                    phi_642_ = _e518;
                    phi_643_ = _e520;
                    phi_644_ = _e522;
                    phi_645_ = _e524;
                } else {
                    phi_639_ = bool();
                    phi_640_ = bool();
                    phi_641_ = vec2<u32>();
                    phi_642_ = bool();
                    phi_643_ = bool();
                    phi_644_ = true;
                    phi_645_ = false;
                }
                let _e526 = phi_639_;
                let _e528 = phi_640_;
                let _e530 = phi_641_;
                let _e532 = phi_642_;
                let _e534 = phi_643_;
                let _e536 = phi_644_;
                let _e538 = phi_645_;
                if _e536 {
                    if (_e405 == 0f) {
                        phi_654_ = (_e406 == 0f);
                    } else {
                        phi_654_ = false;
                    }
                    let _e542 = phi_654_;
                    phi_655_ = _e542;
                    phi_656_ = false;
                    phi_657_ = true;
                } else {
                    phi_655_ = _e532;
                    phi_656_ = _e534;
                    phi_657_ = _e538;
                }
                let _e544 = phi_655_;
                let _e546 = phi_656_;
                let _e548 = phi_657_;
                if _e548 {
                    phi_661_ = _e544;
                    phi_662_ = _e546;
                    phi_663_ = vec2<u32>(_e52.x, _e52.y);
                } else {
                    phi_661_ = _e526;
                    phi_662_ = _e528;
                    phi_663_ = _e530;
                }
                let _e550 = phi_661_;
                let _e552 = phi_662_;
                let _e554 = phi_663_;
                let _e564 = lt_mask_Reprojection(vec2<u32>(_e554.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e571 = lt_mask_Reprojection(vec2<u32>(_e564.pixel.x, _e554.y), _e564.is_valid, _e564.has_moved);
                let _e575 = lt_mask_Reprojection(_e571.pixel, _e552, _e571.has_moved);
                let _e579 = lt_mask_Reprojection(_e575.pixel, _e575.is_valid, !(_e550));
                if _e552 {
                    let _e582 = p.member.previous.eye;
                    let _e590 = p.member.previous.forward;
                    let _e599 = (((((_e84.x - _e582.x) * _e590.x) + ((_e84.y - _e582.y) * _e590.y)) + ((_e84.z - _e582.z) * _e590.z)) > 0f);
                    let _e603 = lt_mask_Reprojection(_e579.pixel, _e599, _e579.has_moved);
                    if _e599 {
                        phi_698_ = false;
                    } else {
                        phi_698_ = true;
                    }
                    let _e605 = phi_698_;
                    phi_700_ = _e603;
                    phi_701_ = _e603;
                    phi_702_ = lt_mask_Reprojection();
                    phi_703_ = _e599;
                    phi_704_ = _e605;
                } else {
                    phi_700_ = lt_mask_Reprojection();
                    phi_701_ = lt_mask_Reprojection();
                    phi_702_ = lt_mask_Reprojection(_e579.pixel, false, _e579.has_moved);
                    phi_703_ = false;
                    phi_704_ = false;
                }
                let _e611 = phi_700_;
                let _e613 = phi_701_;
                let _e615 = phi_702_;
                let _e617 = phi_703_;
                let _e619 = phi_704_;
                phi_705_ = _e611;
                phi_706_ = _e613;
                phi_707_ = _e615;
                phi_708_ = _e617;
                phi_709_ = _e619;
            }
            let _e621 = phi_705_;
            let _e623 = phi_706_;
            let _e625 = phi_707_;
            let _e627 = phi_708_;
            let _e629 = phi_709_;
            if _e627 {
                let _e632 = p.member.previous.eye;
                let _e640 = p.member.previous.forward;
                let _e648 = ((((_e84.x - _e632.x) * _e640.x) + ((_e84.y - _e632.y) * _e640.y)) + ((_e84.z - _e632.z) * _e640.z));
                let _e654 = ((_e621.pixel.y * _e81) + _e621.pixel.x);
                if (_e654 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e658 = last_depths.member[(0u + _e654)];
                let _e660 = p.member.depth_tolerance;
                let _e663 = abs(_e648);
                let _e664 = abs(_e658);
                if ((bitcast<u32>(_e664) & 2147483647u) > 2139095040u) {
                    phi_761_ = true;
                } else {
                    let _e668 = (_e664 > _e663);
                    if _e668 {
                    }
                    phi_761_ = _e668;
                }
                let _e670 = phi_761_;
                if _e670 {
                    phi_765_ = _e664;
                } else {
                    phi_765_ = _e663;
                }
                let _e672 = phi_765_;
                phi_769_ = lt_mask_Reprojection(_e621.pixel, (abs((_e648 - _e658)) <= (_e660 * _e672)), _e621.has_moved);
                phi_770_ = true;
            } else {
                phi_769_ = _e623;
                phi_770_ = _e629;
            }
            let _e680 = phi_769_;
            let _e682 = phi_770_;
            if _e682 {
                if _e680.is_valid {
                    let _e685 = p.member.flags;
                    phi_782_ = ((_e685 & 1u) != 0u);
                    phi_783_ = false;
                } else {
                    phi_782_ = bool();
                    phi_783_ = true;
                }
                let _e689 = phi_782_;
                let _e691 = phi_783_;
                phi_784_ = _e689;
                phi_785_ = _e680;
                phi_786_ = _e691;
            } else {
                phi_784_ = bool();
                phi_785_ = _e625;
                phi_786_ = true;
            }
            let _e693 = phi_784_;
            let _e695 = phi_785_;
            let _e697 = phi_786_;
            if _e697 {
                phi_790_ = false;
                phi_791_ = _e695;
            } else {
                phi_790_ = _e693;
                phi_791_ = _e680;
            }
            let _e699 = phi_790_;
            let _e701 = phi_791_;
            let _e705 = lt_mask_Reprojection(_e701.pixel, _e699, _e701.has_moved);
            let _e706 = lt_mask_Neighbourhood(false, true);
            if _e251 {
                phi_797_ = false;
            } else {
                phi_797_ = true;
            }
            let _e708 = phi_797_;
            if _e708 {
                if _e699 {
                    if ((0u & 2u) != 0u) {
                        phi_858_ = _e706;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e717 = (_e81 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e81 % 32u) > 0u) {
                            phi_829_ = (_e717 + 1u);
                        } else {
                            phi_829_ = _e717;
                        }
                        let _e723 = phi_829_;
                        let _e733 = ((((_e705.pixel.y * _e723) + (_e705.pixel.x / 32u)) * 6u) + (select(0u, 1u, _e247) | (select(0u, 1u, _e705.has_moved) << bitcast<u32>(1i))));
                        if (_e733 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e737 = heard.member[(0u + _e733)];
                        let _e743 = (((_e737 >> bitcast<u32>(((_e705.pixel.x % 32u) & 31u))) & 1u) != 0u);
                        phi_858_ = lt_mask_Neighbourhood(_e743, !(_e743));
                    }
                    let _e747 = phi_858_;
                    phi_859_ = _e747;
                } else {
                    phi_859_ = _e706;
                }
                let _e749 = phi_859_;
                phi_860_ = _e749;
            } else {
                phi_860_ = _e706;
            }
            let _e751 = phi_860_;
            let _e754 = p.member.frame;
            let _e756 = p.member.refresh;
            if (_e756 == 0u) {
                phi_893_ = false;
            } else {
                if (_e756 == 0u) {
                    return;
                }
                let _e765 = ((_e52.x + (_e52.y * (((_e756 * 5u) / 8u) | 1u))) + (_e754 % _e756));
                if (_e756 == 0u) {
                    phi_892_ = (_e765 == 0u);
                } else {
                    if (_e756 == 0u) {
                        return;
                    }
                    phi_892_ = ((_e765 % _e756) == 0u);
                }
                let _e772 = phi_892_;
                phi_893_ = _e772;
            }
            let _e774 = phi_893_;
            if _e699 {
                if _e774 {
                    phi_915_ = bool();
                } else {
                    phi_915_ = ((0u & 2u) != 0u);
                }
                let _e780 = phi_915_;
                phi_916_ = _e780;
                phi_917_ = _e774;
            } else {
                phi_916_ = bool();
                phi_917_ = true;
            }
            let _e782 = phi_916_;
            let _e784 = phi_917_;
            if _e784 {
                phi_921_ = false;
            } else {
                phi_921_ = _e782;
            }
            let _e786 = phi_921_;
            if _e786 {
                phi_972_ = 7u;
            } else {
                if (_e89 != 0.5f) {
                    if _e699 {
                        if _e774 {
                            phi_969_ = 6u;
                        } else {
                            if _e251 {
                                phi_944_ = true;
                            } else {
                                if _e751.any_expands {
                                    phi_943_ = false;
                                } else {
                                    phi_943_ = true;
                                }
                                let _e788 = phi_943_;
                                phi_944_ = _e788;
                            }
                            let _e790 = phi_944_;
                            if _e790 {
                                if _e251 {
                                    if false {
                                        if _e751.all_remove {
                                            phi_957_ = false;
                                        } else {
                                            phi_957_ = true;
                                        }
                                        let _e792 = phi_957_;
                                        phi_958_ = _e792;
                                    } else {
                                        phi_958_ = true;
                                    }
                                    let _e794 = phi_958_;
                                    phi_959_ = _e794;
                                } else {
                                    phi_959_ = true;
                                }
                                let _e796 = phi_959_;
                                if _e796 {
                                    if _e251 {
                                        phi_966_ = 1u;
                                    } else {
                                        phi_966_ = 0u;
                                    }
                                    let _e798 = phi_966_;
                                    phi_967_ = _e798;
                                } else {
                                    phi_967_ = 5u;
                                }
                                let _e800 = phi_967_;
                                phi_968_ = _e800;
                            } else {
                                phi_968_ = 4u;
                            }
                            let _e802 = phi_968_;
                            phi_969_ = _e802;
                        }
                        let _e804 = phi_969_;
                        phi_970_ = _e804;
                    } else {
                        phi_970_ = 3u;
                    }
                    let _e806 = phi_970_;
                    phi_971_ = _e806;
                } else {
                    phi_971_ = 2u;
                }
                let _e808 = phi_971_;
                phi_972_ = _e808;
            }
            let _e810 = phi_972_;
            if !((_e810 == 0u)) {
                if !((_e810 == 5u)) {
                    phi_984_ = !(_e786);
                    phi_985_ = false;
                } else {
                    phi_984_ = bool();
                    phi_985_ = true;
                }
                let _e817 = phi_984_;
                let _e819 = phi_985_;
                phi_986_ = _e817;
                phi_987_ = _e819;
            } else {
                phi_986_ = bool();
                phi_987_ = true;
            }
            let _e821 = phi_986_;
            let _e823 = phi_987_;
            if _e823 {
                phi_991_ = false;
            } else {
                phi_991_ = _e821;
            }
            let _e825 = phi_991_;
            if _e786 {
                phi_997_ = ((0u & 4u) != 0u);
            } else {
                phi_997_ = _e247;
            }
            let _e829 = phi_997_;
            if _e825 {
                if _e247 {
                    phi_1005_ = (2u | 1u);
                } else {
                    phi_1005_ = 2u;
                }
                let _e832 = phi_1005_;
                if false {
                    phi_1010_ = (_e832 | 4u);
                } else {
                    phi_1010_ = _e832;
                }
                let _e835 = phi_1010_;
                phi_1030_ = _e835;
            } else {
                if (_e810 == 7u) {
                    if _e247 {
                        phi_1019_ = (2u | 1u);
                    } else {
                        phi_1019_ = 2u;
                    }
                    let _e839 = phi_1019_;
                    if _e829 {
                        phi_1024_ = (_e839 | 4u);
                    } else {
                        phi_1024_ = _e839;
                    }
                    let _e842 = phi_1024_;
                    phi_1029_ = _e842;
                } else {
                    if _e247 {
                        phi_1028_ = 1u;
                    } else {
                        phi_1028_ = 0u;
                    }
                    let _e844 = phi_1028_;
                    phi_1029_ = _e844;
                }
                let _e846 = phi_1029_;
                phi_1030_ = _e846;
            }
            let _e848 = phi_1030_;
            if _e829 {
                phi_1034_ = 0f;
            } else {
                phi_1034_ = 1f;
            }
            let _e850 = phi_1034_;
            phi_1036_ = mask_Masked(_e850, _e848, _e825);
        }
        let _e853 = phi_1036_;
        visibility.member[_e73.first_primitive] = _e853.visibility;
        let _e858 = p.member.light.number;
        let _e859 = (_e858 * 3u);
        let _e861 = (_e859 % 32u);
        let _e863 = p.member.light.mask_words;
        let _e865 = ((_e73.first_primitive * _e863) + (_e859 / 32u));
        let _e867 = bits.member[_e865];
        bits.member[_e865] = ((_e867 & ~((7u << bitcast<u32>((_e861 & 31u))))) | (_e853.bits << bitcast<u32>((_e861 & 31u))));
        if (_e861 > 29u) {
            let _e882 = bits.member[(_e865 + 1u)];
            let _e884 = (32u - _e861);
            bits.member[(_e865 + 1u)] = ((_e882 & ~((7u >> bitcast<u32>((_e884 & 31u))))) | (_e853.bits >> bitcast<u32>((_e884 & 31u))));
        }
        let _e899 = samples.member[_e73.first_primitive].normal[0u];
        let _e901 = global[0u];
        if (_e899 == _e901) {
            let _e904 = samples.member[_e73.first_primitive].normal[1u];
            let _e906 = global[1u];
            if (_e904 == _e906) {
                let _e909 = samples.member[_e73.first_primitive].normal[2u];
                let _e911 = global[2u];
                phi_1108_ = (_e909 == _e911);
                phi_1109_ = false;
            } else {
                phi_1108_ = bool();
                phi_1109_ = true;
            }
            let _e914 = phi_1108_;
            let _e916 = phi_1109_;
            phi_1110_ = _e914;
            phi_1111_ = _e916;
        } else {
            phi_1110_ = bool();
            phi_1111_ = true;
        }
        let _e918 = phi_1110_;
        let _e920 = phi_1111_;
        if _e920 {
            phi_1115_ = false;
        } else {
            phi_1115_ = _e918;
        }
        let _e922 = phi_1115_;
        if !(_e922) {
            let _e925 = samples.member[_e73.first_primitive].position;
            let _e927 = p.member.current.eye;
            let _e938 = p.member.current.forward;
            phi_1143_ = ((((_e925.x - _e927.x) * _e938.x) + ((_e925.y - _e927.y) * _e938.y)) + ((_e925.z - _e927.z) * _e938.z));
        } else {
            phi_1143_ = 0f;
        }
        let _e948 = phi_1143_;
        depths.member[_e73.first_primitive] = _e948;
        phi_1146_ = _e853.needs_ray;
        phi_1147_ = _e73.first_primitive;
    } else {
        phi_1146_ = false;
        phi_1147_ = 0u;
    }
    let _e952 = phi_1146_;
    let _e954 = phi_1147_;
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e952 {
        let _e958 = atomicAdd((&shared_[0u]), 1u);
        phi_1158_ = _e958;
    } else {
        phi_1158_ = 0u;
    }
    let _e960 = phi_1158_;
    workgroupBarrier();
    if (_e53 == 0u) {
        let _e964 = atomicLoad((&shared_[0u]));
        let _e965 = atomicAdd((&list.member[3u]), _e964);
        atomicStore((&shared_[1u]), _e965);
    }
    workgroupBarrier();
    if _e952 {
        let _e968 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e968) + _e960)]), _e954);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
