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

struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
}

struct abi_MaskParams {
    current: abi_CameraParams,
    previous: abi_CameraParams,
    light: abi_LightParams,
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

struct type_44 {
    member: array<vec4<f32>>,
}

struct type_49 {
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
var<storage, read_write> list: type_49;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(6) 
var<storage> last_depths: type_21;
@group(0) @binding(7) 
var<storage, read_write> depths: type_21;
@group(0) @binding(8) 
var<storage> past: type_44;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_174_: lt_bvh_traverse_Tree;
    var phi_175_: bool;
    var phi_176_: lt_bvh_traverse_Tree;
    var phi_177_: bool;
    var phi_182_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_174_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_175_ = false;
        } else {
            phi_174_ = lt_bvh_traverse_Tree();
            phi_175_ = true;
        }
        let _e69 = phi_174_;
        let _e71 = phi_175_;
        phi_176_ = _e69;
        phi_177_ = _e71;
    } else {
        phi_176_ = lt_bvh_traverse_Tree();
        phi_177_ = true;
    }
    let _e73 = phi_176_;
    let _e75 = phi_177_;
    if _e75 {
        phi_182_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_182_ = _e73;
    }
    let _e80 = phi_182_;
    return lt_bvh_traverse_Tree(_e80.root, _e80.first_primitive);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_200_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_200_ = vec2(0i);
            break;
        }
        case 1: {
            phi_200_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_200_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_200_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_200_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e65 = phi_200_;
    return vec2<i32>(_e65.x, _e65.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_218_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_218_ = vec2(0i);
            break;
        }
        case 1: {
            phi_218_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_218_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_218_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_218_ = vec2(1i);
            break;
        }
    }
    let _e65 = phi_218_;
    return vec2<i32>(_e65.x, _e65.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_237_: vec2<i32>;

    if (param_6 == 0u) {
        let _e59 = lt_mask_pattern_plus(param_5);
        phi_237_ = vec2<i32>(_e59.x, _e59.y);
    } else {
        let _e63 = lt_mask_pattern_cross(param_5);
        phi_237_ = vec2<i32>(_e63.x, _e63.y);
    }
    let _e68 = phi_237_;
    return vec2<i32>(_e68.x, _e68.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_262_: vec2<i32>;

    let _e57 = (param_7 % 13u);
    switch bitcast<i32>(_e57) {
        case 9: {
            phi_262_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_262_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_262_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_262_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_262_ = vec2<i32>((bitcast<i32>((_e57 % 3u)) - 1i), (bitcast<i32>(((_e57 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e72 = phi_262_;
    return vec2<i32>(_e72.x, _e72.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_283_: u32;
    var phi_284_: u32;

    let _e60 = (bitcast<i32>(param_8) + param_9);
    if (_e60 < 0i) {
        phi_284_ = 0u;
    } else {
        if (_e60 >= bitcast<i32>(param_10)) {
            phi_283_ = (param_10 - 1u);
        } else {
            phi_283_ = bitcast<u32>(_e60);
        }
        let _e67 = phi_283_;
        phi_284_ = _e67;
    }
    let _e69 = phi_284_;
    return _e69;
}

fn function_() {
    var phi_353_: bool;
    var phi_354_: bool;
    var phi_355_: bool;
    var phi_356_: bool;
    var phi_360_: bool;
    var phi_430_: bool;
    var phi_431_: bool;
    var phi_442_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_443_: bool;
    var phi_444_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_445_: bool;
    var phi_452_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_456_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_469_: bool;
    var phi_655_: f32;
    var phi_660_: f32;
    var phi_661_: bool;
    var phi_662_: f32;
    var phi_663_: bool;
    var phi_667_: f32;
    var phi_690_: f32;
    var phi_695_: f32;
    var phi_696_: bool;
    var phi_697_: f32;
    var phi_698_: bool;
    var phi_702_: f32;
    var phi_723_: bool;
    var phi_742_: vec2<u32>;
    var phi_743_: bool;
    var phi_744_: bool;
    var phi_745_: bool;
    var phi_746_: vec2<u32>;
    var phi_747_: bool;
    var phi_748_: bool;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_752_: bool;
    var phi_753_: vec2<u32>;
    var phi_754_: bool;
    var phi_755_: bool;
    var phi_756_: bool;
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_760_: vec2<u32>;
    var phi_761_: bool;
    var phi_762_: bool;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_773_: bool;
    var phi_774_: bool;
    var phi_775_: bool;
    var phi_776_: bool;
    var phi_780_: bool;
    var phi_781_: bool;
    var phi_782_: vec2<u32>;
    var phi_865_: bool;
    var phi_869_: f32;
    var phi_873_: lt_mask_Reprojection;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_885_: bool;
    var phi_886_: lt_mask_Reprojection;
    var phi_887_: lt_mask_Reprojection;
    var phi_888_: bool;
    var phi_892_: bool;
    var phi_893_: lt_mask_Reprojection;
    var phi_921_: u32;
    var phi_923_: u32;
    var phi_926_: lt_mask_Neighbourhood;
    var phi_938_: bool;
    var phi_939_: bool;
    var phi_948_: u32;
    var phi_949_: u32;
    var phi_1009_: vec2<i32>;
    var phi_1029_: vec2<i32>;
    var phi_1052_: u32;
    var phi_1069_: bool;
    var phi_1070_: bool;
    var phi_1077_: bool;
    var phi_1078_: bool;
    var phi_1096_: bool;
    var phi_1097_: bool;
    var phi_1098_: bool;
    var phi_924_: u32;
    var phi_927_: lt_mask_Neighbourhood;
    var phi_1101_: lt_mask_Neighbourhood;
    var phi_1102_: lt_mask_Neighbourhood;
    var phi_1103_: lt_mask_Neighbourhood;
    var phi_1128_: bool;
    var phi_1129_: bool;
    var phi_1142_: bool;
    var phi_1143_: bool;
    var phi_1144_: bool;
    var phi_1151_: u32;
    var phi_1152_: u32;
    var phi_1153_: u32;
    var phi_1154_: u32;
    var phi_1155_: u32;
    var phi_1163_: bool;
    var phi_1171_: u32;
    var phi_1176_: u32;
    var phi_1180_: u32;
    var phi_1181_: u32;
    var phi_1185_: f32;
    var phi_1187_: mask_Masked;
    var phi_1215_: bool;
    var phi_1216_: bool;
    var phi_1217_: bool;
    var phi_1218_: bool;
    var phi_1222_: bool;
    var phi_1250_: f32;
    var phi_1253_: bool;
    var phi_1254_: u32;
    var phi_1265_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e56 = id_1;
    let _e57 = local_2;
    let _e74 = p.member.current.size[0u];
    let _e76 = p.member.current.size[1u];
    let _e77 = lt_shaders_entry_pixel_index(_e56, _e74, _e76);
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
                phi_353_ = (_e109 == _e111);
                phi_354_ = false;
            } else {
                phi_353_ = bool();
                phi_354_ = true;
            }
            let _e114 = phi_353_;
            let _e116 = phi_354_;
            phi_355_ = _e114;
            phi_356_ = _e116;
        } else {
            phi_355_ = bool();
            phi_356_ = true;
        }
        let _e118 = phi_355_;
        let _e120 = phi_356_;
        if _e120 {
            phi_360_ = false;
        } else {
            phi_360_ = _e118;
        }
        let _e122 = phi_360_;
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
                    phi_431_ = true;
                } else {
                    let _e175 = p.member.light.range_squared;
                    if (_e158 <= _e175) {
                        let _e178 = p.member.light.cos_outer;
                        phi_430_ = (-((((_e140 * _e160.x) + (_e141 * _e160.y)) + (_e142 * _e160.z))) >= (_e178 * sqrt(_e158)));
                    } else {
                        phi_430_ = false;
                    }
                    let _e183 = phi_430_;
                    phi_431_ = _e183;
                }
                let _e185 = phi_431_;
                if _e185 {
                    let _e187 = samples.member[_e77.first_primitive].flags;
                    let _e195 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e195.unnamed.visibility, false), _e195.unnamed_1);
                    phi_442_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e201.unnamed, ((_e187 & 1u) == 0u));
                    phi_443_ = false;
                } else {
                    phi_442_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_443_ = true;
                }
                let _e206 = phi_442_;
                let _e208 = phi_443_;
                phi_444_ = _e206;
                phi_445_ = _e208;
            } else {
                phi_444_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_445_ = true;
            }
            let _e210 = phi_444_;
            let _e212 = phi_445_;
            if _e212 {
                let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e224 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e218.unnamed.visibility, false), _e218.unnamed_1);
                phi_452_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e224.unnamed, true);
            } else {
                phi_452_ = _e210;
            }
            let _e229 = phi_452_;
            phi_456_ = _e229;
        } else {
            let _e235 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e241 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e235.unnamed.visibility, false), _e235.unnamed_1);
            phi_456_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e241.unnamed, true);
        }
        let _e246 = phi_456_;
        if _e246.unnamed_1 {
            phi_1187_ = mask_Masked(_e246.unnamed.visibility, 0u, false);
        } else {
            let _e251 = (_e93 < 0.5f);
            if (_e93 > 0f) {
                phi_469_ = (_e93 < 1f);
            } else {
                phi_469_ = false;
            }
            let _e255 = phi_469_;
            let _e257 = samples.member[_e77.first_primitive].position;
            let _e261 = p.member.previous.eye;
            let _e263 = (_e88.x - _e261.x);
            let _e265 = (_e88.y - _e261.y);
            let _e267 = (_e88.z - _e261.z);
            let _e269 = p.member.previous.forward;
            let _e277 = (((_e263 * _e269.x) + (_e265 * _e269.y)) + (_e267 * _e269.z));
            let _e279 = p.member.previous.right;
            let _e289 = p.member.previous.right;
            let _e304 = p.member.previous.up;
            let _e314 = p.member.previous.up;
            let _e329 = p.member.current.eye;
            let _e332 = (_e257.x - _e329.x);
            let _e335 = (_e257.y - _e329.y);
            let _e338 = (_e257.z - _e329.z);
            let _e340 = p.member.current.forward;
            let _e348 = (((_e332 * _e340.x) + (_e335 * _e340.y)) + (_e338 * _e340.z));
            let _e350 = p.member.current.right;
            let _e360 = p.member.current.right;
            let _e375 = p.member.current.up;
            let _e385 = p.member.current.up;
            let _e404 = p.member.current.size[0u];
            let _e406 = (((((((_e263 * _e279.x) + (_e265 * _e279.y)) + (_e267 * _e279.z)) / ((((_e289.x * _e289.x) + (_e289.y * _e289.y)) + (_e289.z * _e289.z)) * _e277)) - ((((_e332 * _e350.x) + (_e335 * _e350.y)) + (_e338 * _e350.z)) / ((((_e360.x * _e360.x) + (_e360.y * _e360.y)) + (_e360.z * _e360.z)) * _e348))) * 0.5f) * f32(_e404));
            let _e410 = p.member.current.size[1u];
            let _e412 = (((((((_e263 * _e304.x) + (_e265 * _e304.y)) + (_e267 * _e304.z)) / ((((_e314.x * _e314.x) + (_e314.y * _e314.y)) + (_e314.z * _e314.z)) * _e277)) - ((((_e332 * _e375.x) + (_e335 * _e375.y)) + (_e338 * _e375.z)) / ((((_e385.x * _e385.x) + (_e385.y * _e385.y)) + (_e385.z * _e385.z)) * _e348))) * -0.5f) * f32(_e410));
            let _e416 = p.member.current.size[0u];
            let _e418 = p.member.current.size[1u];
            let _e422 = ((f32(_e56.x) + 0.5f) + _e406);
            if (_e422 > -8388608f) {
                let _e434 = f32(select(0i, select(select(i32(_e422), i32(-2147483648), (_e422 < bitcast<f32>(3472883712u))), 2147483647i, (_e422 > bitcast<f32>(1325400063u))), (_e422 == _e422)));
                if (_e434 > _e422) {
                    phi_655_ = 1f;
                } else {
                    phi_655_ = 0f;
                }
                let _e437 = phi_655_;
                if (_e422 < 8388608f) {
                    phi_660_ = (_e434 - _e437);
                    phi_661_ = false;
                } else {
                    phi_660_ = f32();
                    phi_661_ = true;
                }
                let _e440 = phi_660_;
                let _e442 = phi_661_;
                phi_662_ = _e440;
                phi_663_ = _e442;
            } else {
                phi_662_ = f32();
                phi_663_ = true;
            }
            let _e444 = phi_662_;
            let _e446 = phi_663_;
            if _e446 {
                phi_667_ = _e422;
            } else {
                phi_667_ = _e444;
            }
            let _e448 = phi_667_;
            let _e451 = ((f32(_e56.y) + 0.5f) + _e412);
            if (_e451 > -8388608f) {
                let _e463 = f32(select(0i, select(select(i32(_e451), i32(-2147483648), (_e451 < bitcast<f32>(3472883712u))), 2147483647i, (_e451 > bitcast<f32>(1325400063u))), (_e451 == _e451)));
                if (_e463 > _e451) {
                    phi_690_ = 1f;
                } else {
                    phi_690_ = 0f;
                }
                let _e466 = phi_690_;
                if (_e451 < 8388608f) {
                    phi_695_ = (_e463 - _e466);
                    phi_696_ = false;
                } else {
                    phi_695_ = f32();
                    phi_696_ = true;
                }
                let _e469 = phi_695_;
                let _e471 = phi_696_;
                phi_697_ = _e469;
                phi_698_ = _e471;
            } else {
                phi_697_ = f32();
                phi_698_ = true;
            }
            let _e473 = phi_697_;
            let _e475 = phi_698_;
            if _e475 {
                phi_702_ = _e451;
            } else {
                phi_702_ = _e473;
            }
            let _e477 = phi_702_;
            if (_e448 >= 0f) {
                if (_e477 >= 0f) {
                    if (_e448 < f32(_e416)) {
                        let _e483 = (_e477 < f32(_e418));
                        if (_e406 == 0f) {
                            phi_723_ = (_e412 == 0f);
                        } else {
                            phi_723_ = false;
                        }
                        let _e487 = phi_723_;
                        if _e483 {
                            phi_742_ = vec2<u32>(select(select(u32(_e448), 0u, (_e448 < bitcast<f32>(0u))), 4294967295u, (_e448 > bitcast<f32>(1333788671u))), select(select(u32(_e477), 0u, (_e477 < bitcast<f32>(0u))), 4294967295u, (_e477 > bitcast<f32>(1333788671u))));
                            phi_743_ = false;
                        } else {
                            phi_742_ = vec2<u32>();
                            phi_743_ = true;
                        }
                        let _e504 = phi_742_;
                        let _e506 = phi_743_;
                        phi_744_ = _e487;
                        phi_745_ = _e483;
                        phi_746_ = _e504;
                        phi_747_ = _e487;
                        phi_748_ = _e483;
                        phi_749_ = false;
                        phi_750_ = _e506;
                    } else {
                        phi_744_ = bool();
                        phi_745_ = bool();
                        phi_746_ = vec2<u32>();
                        phi_747_ = bool();
                        phi_748_ = bool();
                        phi_749_ = true;
                        phi_750_ = false;
                    }
                    let _e508 = phi_744_;
                    let _e510 = phi_745_;
                    let _e512 = phi_746_;
                    let _e514 = phi_747_;
                    let _e516 = phi_748_;
                    let _e518 = phi_749_;
                    let _e520 = phi_750_;
                    phi_751_ = _e508;
                    phi_752_ = _e510;
                    phi_753_ = _e512;
                    phi_754_ = _e514;
                    phi_755_ = _e516;
                    phi_756_ = _e518;
                    phi_757_ = _e520;
                } else {
                    phi_751_ = bool();
                    phi_752_ = bool();
                    phi_753_ = vec2<u32>();
                    phi_754_ = bool();
                    phi_755_ = bool();
                    phi_756_ = true;
                    phi_757_ = false;
                }
                let _e522 = phi_751_;
                let _e524 = phi_752_;
                let _e526 = phi_753_;
                let _e528 = phi_754_;
                let _e530 = phi_755_;
                let _e532 = phi_756_;
                let _e534 = phi_757_;
                phi_758_ = _e522;
                phi_759_ = _e524;
                phi_760_ = _e526;
                phi_761_ = _e528;
                phi_762_ = _e530;
                phi_763_ = _e532;
                phi_764_ = _e534;
            } else {
                phi_758_ = bool();
                phi_759_ = bool();
                phi_760_ = vec2<u32>();
                phi_761_ = bool();
                phi_762_ = bool();
                phi_763_ = true;
                phi_764_ = false;
            }
            let _e536 = phi_758_;
            let _e538 = phi_759_;
            let _e540 = phi_760_;
            let _e542 = phi_761_;
            let _e544 = phi_762_;
            let _e546 = phi_763_;
            let _e548 = phi_764_;
            if _e546 {
                if (_e406 == 0f) {
                    phi_773_ = (_e412 == 0f);
                } else {
                    phi_773_ = false;
                }
                let _e552 = phi_773_;
                phi_774_ = _e552;
                phi_775_ = false;
                phi_776_ = true;
            } else {
                phi_774_ = _e542;
                phi_775_ = _e544;
                phi_776_ = _e548;
            }
            let _e554 = phi_774_;
            let _e556 = phi_775_;
            let _e558 = phi_776_;
            if _e558 {
                phi_780_ = _e554;
                phi_781_ = _e556;
                phi_782_ = vec2<u32>(_e56.x, _e56.y);
            } else {
                phi_780_ = _e536;
                phi_781_ = _e538;
                phi_782_ = _e540;
            }
            let _e560 = phi_780_;
            let _e562 = phi_781_;
            let _e564 = phi_782_;
            let _e574 = lt_mask_Reprojection(vec2<u32>(_e564.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e581 = lt_mask_Reprojection(vec2<u32>(_e574.pixel.x, _e564.y), _e574.is_valid, _e574.has_moved);
            let _e585 = lt_mask_Reprojection(_e581.pixel, _e562, _e581.has_moved);
            let _e589 = lt_mask_Reprojection(_e585.pixel, _e585.is_valid, !(_e560));
            if _e562 {
                let _e592 = p.member.previous.eye;
                let _e600 = p.member.previous.forward;
                let _e609 = (((((_e88.x - _e592.x) * _e600.x) + ((_e88.y - _e592.y) * _e600.y)) + ((_e88.z - _e592.z) * _e600.z)) > 0f);
                let _e613 = lt_mask_Reprojection(_e589.pixel, _e609, _e589.has_moved);
                if _e609 {
                    let _e616 = p.member.previous.eye;
                    let _e624 = p.member.previous.forward;
                    let _e632 = ((((_e88.x - _e616.x) * _e624.x) + ((_e88.y - _e616.y) * _e624.y)) + ((_e88.z - _e616.z) * _e624.z));
                    let _e634 = ((_e564.y * _e85) + _e564.x);
                    if (_e634 < arrayLength((&last_depths.member))) {
                    } else {
                        return;
                    }
                    let _e638 = last_depths.member[(0u + _e634)];
                    let _e640 = p.member.depth_tolerance;
                    let _e643 = abs(_e632);
                    let _e644 = abs(_e638);
                    if ((bitcast<u32>(_e644) & 2147483647u) > 2139095040u) {
                        phi_865_ = true;
                    } else {
                        let _e648 = (_e644 > _e643);
                        if _e648 {
                        }
                        phi_865_ = _e648;
                    }
                    let _e650 = phi_865_;
                    if _e650 {
                        phi_869_ = _e644;
                    } else {
                        phi_869_ = _e643;
                    }
                    let _e652 = phi_869_;
                    phi_873_ = lt_mask_Reprojection(_e613.pixel, (abs((_e632 - _e638)) <= (_e640 * _e652)), _e613.has_moved);
                } else {
                    phi_873_ = _e613;
                }
                let _e660 = phi_873_;
                if _e660.is_valid {
                    let _e663 = p.member.flags;
                    phi_882_ = ((_e663 & 1u) != 0u);
                    phi_883_ = false;
                } else {
                    phi_882_ = bool();
                    phi_883_ = true;
                }
                let _e667 = phi_882_;
                let _e669 = phi_883_;
                phi_885_ = _e667;
                phi_886_ = _e660;
                phi_887_ = _e660;
                phi_888_ = _e669;
            } else {
                phi_885_ = bool();
                phi_886_ = lt_mask_Reprojection();
                phi_887_ = lt_mask_Reprojection(_e589.pixel, false, _e589.has_moved);
                phi_888_ = true;
            }
            let _e675 = phi_885_;
            let _e677 = phi_886_;
            let _e679 = phi_887_;
            let _e681 = phi_888_;
            if _e681 {
                phi_892_ = false;
                phi_893_ = _e679;
            } else {
                phi_892_ = _e675;
                phi_893_ = _e677;
            }
            let _e683 = phi_892_;
            let _e685 = phi_893_;
            let _e689 = lt_mask_Reprojection(_e685.pixel, _e683, _e685.has_moved);
            if _e689.has_moved {
            }
            let _e695 = lt_mask_Neighbourhood(false, true);
            if _e255 {
                phi_1103_ = _e695;
            } else {
                if true {
                    if _e683 {
                        if _e689.has_moved {
                            let _e698 = p.member.moving_pattern;
                            phi_921_ = _e698;
                        } else {
                            let _e700 = p.member.still_pattern;
                            phi_921_ = _e700;
                        }
                        let _e702 = phi_921_;
                        phi_923_ = 0u;
                        phi_926_ = _e695;
                        loop {
                            let _e704 = phi_923_;
                            let _e706 = phi_926_;
                            local_1 = _e706;
                            if (1u <= _e702) {
                                if (_e702 <= 4u) {
                                    phi_938_ = false;
                                } else {
                                    phi_938_ = true;
                                }
                                let _e710 = phi_938_;
                                phi_939_ = _e710;
                            } else {
                                phi_939_ = true;
                            }
                            let _e712 = phi_939_;
                            if _e712 {
                                switch bitcast<i32>(_e702) {
                                    case 5: {
                                        phi_948_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_948_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_948_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_948_ = 9u;
                                        break;
                                    }
                                }
                                let _e715 = phi_948_;
                                phi_949_ = _e715;
                            } else {
                                phi_949_ = 5u;
                            }
                            let _e717 = phi_949_;
                            let _e718 = (_e704 < _e717);
                            if _e718 {
                                let _e724 = p.member.frame;
                                let _e728 = p.member.current.size[0u];
                                let _e730 = p.member.current.size[1u];
                                switch bitcast<i32>(_e702) {
                                    case 1: {
                                        let _e740 = lt_mask_pattern_plus(_e704);
                                        phi_1029_ = vec2<i32>(_e740.x, _e740.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e744 = lt_mask_pattern_cross(_e704);
                                        phi_1029_ = vec2<i32>(_e744.x, _e744.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e750 = lt_mask_pattern_plus_or_cross(_e704, ((_e689.pixel.x + _e689.pixel.y) & 1u));
                                        phi_1029_ = vec2<i32>(_e750.x, _e750.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e755 = lt_mask_pattern_plus_or_cross(_e704, (_e724 & 1u));
                                        phi_1029_ = vec2<i32>(_e755.x, _e755.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e724 & 3u)) {
                                            case 0: {
                                                phi_1009_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1009_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1009_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1009_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e766 = phi_1009_;
                                        phi_1029_ = (_e766 + vec2<i32>(bitcast<i32>((_e704 & 1u)), bitcast<i32>(((_e704 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1029_ = vec2<i32>((bitcast<i32>((_e704 % 5u)) - 2i), (bitcast<i32>(((_e704 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e783 = lt_mask_pattern_diamond(_e704);
                                        phi_1029_ = vec2<i32>(_e783.x, _e783.y);
                                        break;
                                    }
                                    default: {
                                        phi_1029_ = vec2<i32>((bitcast<i32>((_e704 % 3u)) - 1i), (bitcast<i32>(((_e704 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e788 = phi_1029_;
                                let _e791 = lt_mask_pattern_step_clamped(_e689.pixel.x, _e788.x, _e728);
                                let _e792 = lt_mask_pattern_step_clamped(_e689.pixel.y, _e788.y, _e730);
                                let _e794 = ((_e792 * _e85) + _e791);
                                if (_e794 < arrayLength((&last_bits.member))) {
                                } else {
                                    return;
                                }
                                let _e798 = last_bits.member[(0u + _e794)];
                                if ((_e798 & 2u) == 0u) {
                                    phi_1052_ = (_e798 & 1u);
                                } else {
                                    phi_1052_ = (_e798 & 7u);
                                }
                                let _e804 = phi_1052_;
                                if _e706.any_expands {
                                    phi_1078_ = true;
                                } else {
                                    if ((_e804 & 2u) != 0u) {
                                        if (((_e804 & 4u) != 0u) != _e251) {
                                            phi_1069_ = false;
                                        } else {
                                            phi_1069_ = true;
                                        }
                                        let _e813 = phi_1069_;
                                        phi_1070_ = _e813;
                                    } else {
                                        phi_1070_ = true;
                                    }
                                    let _e815 = phi_1070_;
                                    if _e815 {
                                        phi_1077_ = (((_e804 & 1u) != 0u) != _e251);
                                    } else {
                                        phi_1077_ = true;
                                    }
                                    let _e820 = phi_1077_;
                                    phi_1078_ = _e820;
                                }
                                let _e822 = phi_1078_;
                                if _e706.all_remove {
                                    if (((_e804 & 1u) != 0u) == _e251) {
                                        if ((_e804 & 2u) != 0u) {
                                            phi_1096_ = (((_e804 & 4u) != 0u) == _e251);
                                        } else {
                                            phi_1096_ = true;
                                        }
                                        let _e832 = phi_1096_;
                                        phi_1097_ = _e832;
                                    } else {
                                        phi_1097_ = false;
                                    }
                                    let _e834 = phi_1097_;
                                    phi_1098_ = _e834;
                                } else {
                                    phi_1098_ = false;
                                }
                                let _e836 = phi_1098_;
                                phi_924_ = (_e704 + 1u);
                                phi_927_ = lt_mask_Neighbourhood(_e822, _e836);
                            } else {
                                phi_924_ = u32();
                                phi_927_ = lt_mask_Neighbourhood();
                            }
                            let _e840 = phi_924_;
                            let _e842 = phi_927_;
                            continue;
                            continuing {
                                phi_923_ = _e840;
                                phi_926_ = _e842;
                                break if !(_e718);
                            }
                        }
                        let _e1063 = local_1;
                        phi_1101_ = _e1063;
                    } else {
                        phi_1101_ = _e695;
                    }
                    let _e845 = phi_1101_;
                    phi_1102_ = _e845;
                } else {
                    phi_1102_ = _e695;
                }
                let _e847 = phi_1102_;
                phi_1103_ = _e847;
            }
            let _e849 = phi_1103_;
            if (_e93 != 0.5f) {
                if _e683 {
                    if _e255 {
                        phi_1129_ = true;
                    } else {
                        if _e849.any_expands {
                            phi_1128_ = false;
                        } else {
                            phi_1128_ = true;
                        }
                        let _e854 = phi_1128_;
                        phi_1129_ = _e854;
                    }
                    let _e856 = phi_1129_;
                    if _e856 {
                        if _e255 {
                            if false {
                                if _e849.all_remove {
                                    phi_1142_ = false;
                                } else {
                                    phi_1142_ = true;
                                }
                                let _e858 = phi_1142_;
                                phi_1143_ = _e858;
                            } else {
                                phi_1143_ = true;
                            }
                            let _e860 = phi_1143_;
                            phi_1144_ = _e860;
                        } else {
                            phi_1144_ = true;
                        }
                        let _e862 = phi_1144_;
                        if _e862 {
                            if _e255 {
                                phi_1151_ = 1u;
                            } else {
                                phi_1151_ = 0u;
                            }
                            let _e864 = phi_1151_;
                            phi_1152_ = _e864;
                        } else {
                            phi_1152_ = 5u;
                        }
                        let _e866 = phi_1152_;
                        phi_1153_ = _e866;
                    } else {
                        phi_1153_ = 4u;
                    }
                    let _e868 = phi_1153_;
                    phi_1154_ = _e868;
                } else {
                    phi_1154_ = 3u;
                }
                let _e870 = phi_1154_;
                phi_1155_ = _e870;
            } else {
                phi_1155_ = 2u;
            }
            let _e872 = phi_1155_;
            if !((_e872 == 0u)) {
                phi_1163_ = !((_e872 == 5u));
            } else {
                phi_1163_ = false;
            }
            let _e878 = phi_1163_;
            if _e878 {
                if _e251 {
                    phi_1171_ = (2u | 1u);
                } else {
                    phi_1171_ = 2u;
                }
                let _e881 = phi_1171_;
                if false {
                    phi_1176_ = (_e881 | 4u);
                } else {
                    phi_1176_ = _e881;
                }
                let _e884 = phi_1176_;
                phi_1181_ = _e884;
            } else {
                if _e251 {
                    phi_1180_ = 1u;
                } else {
                    phi_1180_ = 0u;
                }
                let _e886 = phi_1180_;
                phi_1181_ = _e886;
            }
            let _e888 = phi_1181_;
            if _e251 {
                phi_1185_ = 0f;
            } else {
                phi_1185_ = 1f;
            }
            let _e890 = phi_1185_;
            phi_1187_ = mask_Masked(_e890, _e888, _e878);
        }
        let _e893 = phi_1187_;
        visibility.member[_e77.first_primitive] = _e893.visibility;
        bits.member[_e77.first_primitive] = _e893.bits;
        let _e901 = samples.member[_e77.first_primitive].normal[0u];
        let _e903 = global[0u];
        if (_e901 == _e903) {
            let _e906 = samples.member[_e77.first_primitive].normal[1u];
            let _e908 = global[1u];
            if (_e906 == _e908) {
                let _e911 = samples.member[_e77.first_primitive].normal[2u];
                let _e913 = global[2u];
                phi_1215_ = (_e911 == _e913);
                phi_1216_ = false;
            } else {
                phi_1215_ = bool();
                phi_1216_ = true;
            }
            let _e916 = phi_1215_;
            let _e918 = phi_1216_;
            phi_1217_ = _e916;
            phi_1218_ = _e918;
        } else {
            phi_1217_ = bool();
            phi_1218_ = true;
        }
        let _e920 = phi_1217_;
        let _e922 = phi_1218_;
        if _e922 {
            phi_1222_ = false;
        } else {
            phi_1222_ = _e920;
        }
        let _e924 = phi_1222_;
        if !(_e924) {
            let _e927 = samples.member[_e77.first_primitive].position;
            let _e929 = p.member.current.eye;
            let _e940 = p.member.current.forward;
            phi_1250_ = ((((_e927.x - _e929.x) * _e940.x) + ((_e927.y - _e929.y) * _e940.y)) + ((_e927.z - _e929.z) * _e940.z));
        } else {
            phi_1250_ = 0f;
        }
        let _e950 = phi_1250_;
        depths.member[_e77.first_primitive] = _e950;
        phi_1253_ = _e893.needs_ray;
        phi_1254_ = _e77.first_primitive;
    } else {
        phi_1253_ = false;
        phi_1254_ = 0u;
    }
    let _e954 = phi_1253_;
    let _e956 = phi_1254_;
    if (_e57 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e954 {
        let _e960 = atomicAdd((&shared_[0u]), 1u);
        phi_1265_ = _e960;
    } else {
        phi_1265_ = 0u;
    }
    let _e962 = phi_1265_;
    workgroupBarrier();
    if (_e57 == 0u) {
        let _e966 = atomicLoad((&shared_[0u]));
        let _e967 = atomicAdd((&list.member[3u]), _e966);
        atomicStore((&shared_[1u]), _e967);
    }
    workgroupBarrier();
    if _e954 {
        let _e970 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e970) + _e962)]), _e956);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
