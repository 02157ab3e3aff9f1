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
    var phi_907_: bool;
    var phi_918_: bool;
    var phi_919_: bool;
    var phi_920_: bool;
    var phi_921_: bool;
    var phi_922_: bool;
    var phi_923_: bool;
    var phi_927_: bool;
    var phi_932_: bool;
    var phi_947_: u32;
    var phi_949_: u32;
    var phi_952_: lt_mask_Neighbourhood;
    var phi_964_: bool;
    var phi_965_: bool;
    var phi_974_: u32;
    var phi_975_: u32;
    var phi_1035_: vec2<i32>;
    var phi_1055_: vec2<i32>;
    var phi_1078_: u32;
    var phi_1095_: bool;
    var phi_1096_: bool;
    var phi_1103_: bool;
    var phi_1104_: bool;
    var phi_1122_: bool;
    var phi_1123_: bool;
    var phi_1124_: bool;
    var phi_950_: u32;
    var phi_953_: lt_mask_Neighbourhood;
    var phi_1127_: lt_mask_Neighbourhood;
    var phi_1128_: lt_mask_Neighbourhood;
    var phi_1153_: bool;
    var phi_1154_: bool;
    var phi_1167_: bool;
    var phi_1168_: bool;
    var phi_1169_: bool;
    var phi_1176_: u32;
    var phi_1177_: u32;
    var phi_1178_: u32;
    var phi_1179_: u32;
    var phi_1180_: u32;
    var phi_1188_: bool;
    var phi_1196_: u32;
    var phi_1201_: u32;
    var phi_1205_: u32;
    var phi_1206_: u32;
    var phi_1210_: f32;
    var phi_1212_: mask_Masked;
    var phi_1240_: bool;
    var phi_1241_: bool;
    var phi_1242_: bool;
    var phi_1243_: bool;
    var phi_1247_: bool;
    var phi_1275_: f32;
    var phi_1278_: bool;
    var phi_1279_: u32;
    var phi_1290_: u32;
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
            phi_1212_ = mask_Masked(_e246.unnamed.visibility, 0u, false);
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
            let _e691 = p.member.flags;
            if _e689.has_moved {
                let _e696 = p.member.flags;
                phi_907_ = ((_e696 & 4u) == 0u);
            } else {
                phi_907_ = false;
            }
            let _e700 = phi_907_;
            if ((_e691 & 2u) != 0u) {
                if false {
                    phi_920_ = bool();
                    phi_921_ = true;
                } else {
                    if true {
                        phi_918_ = !(_e700);
                        phi_919_ = false;
                    } else {
                        phi_918_ = bool();
                        phi_919_ = true;
                    }
                    let _e703 = phi_918_;
                    let _e705 = phi_919_;
                    phi_920_ = _e703;
                    phi_921_ = _e705;
                }
                let _e707 = phi_920_;
                let _e709 = phi_921_;
                phi_922_ = _e707;
                phi_923_ = _e709;
            } else {
                phi_922_ = bool();
                phi_923_ = true;
            }
            let _e711 = phi_922_;
            let _e713 = phi_923_;
            if _e713 {
                phi_927_ = false;
            } else {
                phi_927_ = _e711;
            }
            let _e715 = phi_927_;
            let _e716 = lt_mask_Neighbourhood(false, true);
            if _e255 {
                phi_932_ = _e715;
            } else {
                phi_932_ = false;
            }
            let _e718 = phi_932_;
            if _e718 {
                if _e683 {
                    if _e689.has_moved {
                        let _e721 = p.member.moving_pattern;
                        phi_947_ = _e721;
                    } else {
                        let _e723 = p.member.still_pattern;
                        phi_947_ = _e723;
                    }
                    let _e725 = phi_947_;
                    phi_949_ = 0u;
                    phi_952_ = _e716;
                    loop {
                        let _e727 = phi_949_;
                        let _e729 = phi_952_;
                        local_1 = _e729;
                        if (1u <= _e725) {
                            if (_e725 <= 4u) {
                                phi_964_ = false;
                            } else {
                                phi_964_ = true;
                            }
                            let _e733 = phi_964_;
                            phi_965_ = _e733;
                        } else {
                            phi_965_ = true;
                        }
                        let _e735 = phi_965_;
                        if _e735 {
                            switch bitcast<i32>(_e725) {
                                case 5: {
                                    phi_974_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_974_ = 25u;
                                    break;
                                }
                                case 7: {
                                    phi_974_ = 13u;
                                    break;
                                }
                                default: {
                                    phi_974_ = 9u;
                                    break;
                                }
                            }
                            let _e738 = phi_974_;
                            phi_975_ = _e738;
                        } else {
                            phi_975_ = 5u;
                        }
                        let _e740 = phi_975_;
                        let _e741 = (_e727 < _e740);
                        if _e741 {
                            let _e747 = p.member.frame;
                            let _e751 = p.member.current.size[0u];
                            let _e753 = p.member.current.size[1u];
                            switch bitcast<i32>(_e725) {
                                case 1: {
                                    let _e763 = lt_mask_pattern_plus(_e727);
                                    phi_1055_ = vec2<i32>(_e763.x, _e763.y);
                                    break;
                                }
                                case 2: {
                                    let _e767 = lt_mask_pattern_cross(_e727);
                                    phi_1055_ = vec2<i32>(_e767.x, _e767.y);
                                    break;
                                }
                                case 3: {
                                    let _e773 = lt_mask_pattern_plus_or_cross(_e727, ((_e689.pixel.x + _e689.pixel.y) & 1u));
                                    phi_1055_ = vec2<i32>(_e773.x, _e773.y);
                                    break;
                                }
                                case 4: {
                                    let _e778 = lt_mask_pattern_plus_or_cross(_e727, (_e747 & 1u));
                                    phi_1055_ = vec2<i32>(_e778.x, _e778.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e747 & 3u)) {
                                        case 0: {
                                            phi_1035_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_1035_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_1035_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_1035_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e789 = phi_1035_;
                                    phi_1055_ = (_e789 + vec2<i32>(bitcast<i32>((_e727 & 1u)), bitcast<i32>(((_e727 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_1055_ = vec2<i32>((bitcast<i32>((_e727 % 5u)) - 2i), (bitcast<i32>(((_e727 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                case 7: {
                                    let _e806 = lt_mask_pattern_diamond(_e727);
                                    phi_1055_ = vec2<i32>(_e806.x, _e806.y);
                                    break;
                                }
                                default: {
                                    phi_1055_ = vec2<i32>((bitcast<i32>((_e727 % 3u)) - 1i), (bitcast<i32>(((_e727 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e811 = phi_1055_;
                            let _e814 = lt_mask_pattern_step_clamped(_e689.pixel.x, _e811.x, _e751);
                            let _e815 = lt_mask_pattern_step_clamped(_e689.pixel.y, _e811.y, _e753);
                            let _e817 = ((_e815 * _e85) + _e814);
                            if (_e817 < arrayLength((&last_bits.member))) {
                            } else {
                                return;
                            }
                            let _e821 = last_bits.member[(0u + _e817)];
                            if ((_e821 & 2u) == 0u) {
                                phi_1078_ = (_e821 & 1u);
                            } else {
                                phi_1078_ = (_e821 & 7u);
                            }
                            let _e827 = phi_1078_;
                            if _e729.any_expands {
                                phi_1104_ = true;
                            } else {
                                if ((_e827 & 2u) != 0u) {
                                    if (((_e827 & 4u) != 0u) != _e251) {
                                        phi_1095_ = false;
                                    } else {
                                        phi_1095_ = true;
                                    }
                                    let _e836 = phi_1095_;
                                    phi_1096_ = _e836;
                                } else {
                                    phi_1096_ = true;
                                }
                                let _e838 = phi_1096_;
                                if _e838 {
                                    phi_1103_ = (((_e827 & 1u) != 0u) != _e251);
                                } else {
                                    phi_1103_ = true;
                                }
                                let _e843 = phi_1103_;
                                phi_1104_ = _e843;
                            }
                            let _e845 = phi_1104_;
                            if _e729.all_remove {
                                if (((_e827 & 1u) != 0u) == _e251) {
                                    if ((_e827 & 2u) != 0u) {
                                        phi_1122_ = (((_e827 & 4u) != 0u) == _e251);
                                    } else {
                                        phi_1122_ = true;
                                    }
                                    let _e855 = phi_1122_;
                                    phi_1123_ = _e855;
                                } else {
                                    phi_1123_ = false;
                                }
                                let _e857 = phi_1123_;
                                phi_1124_ = _e857;
                            } else {
                                phi_1124_ = false;
                            }
                            let _e859 = phi_1124_;
                            phi_950_ = (_e727 + 1u);
                            phi_953_ = lt_mask_Neighbourhood(_e845, _e859);
                        } else {
                            phi_950_ = u32();
                            phi_953_ = lt_mask_Neighbourhood();
                        }
                        let _e863 = phi_950_;
                        let _e865 = phi_953_;
                        continue;
                        continuing {
                            phi_949_ = _e863;
                            phi_952_ = _e865;
                            break if !(_e741);
                        }
                    }
                    let _e1093 = local_1;
                    phi_1127_ = _e1093;
                } else {
                    phi_1127_ = _e716;
                }
                let _e868 = phi_1127_;
                phi_1128_ = _e868;
            } else {
                phi_1128_ = _e716;
            }
            let _e870 = phi_1128_;
            if (_e93 != 0.5f) {
                if _e683 {
                    if _e255 {
                        phi_1154_ = true;
                    } else {
                        if _e870.any_expands {
                            phi_1153_ = false;
                        } else {
                            phi_1153_ = true;
                        }
                        let _e875 = phi_1153_;
                        phi_1154_ = _e875;
                    }
                    let _e877 = phi_1154_;
                    if _e877 {
                        if _e255 {
                            if _e715 {
                                if _e870.all_remove {
                                    phi_1167_ = false;
                                } else {
                                    phi_1167_ = true;
                                }
                                let _e879 = phi_1167_;
                                phi_1168_ = _e879;
                            } else {
                                phi_1168_ = true;
                            }
                            let _e881 = phi_1168_;
                            phi_1169_ = _e881;
                        } else {
                            phi_1169_ = true;
                        }
                        let _e883 = phi_1169_;
                        if _e883 {
                            if _e255 {
                                phi_1176_ = 1u;
                            } else {
                                phi_1176_ = 0u;
                            }
                            let _e885 = phi_1176_;
                            phi_1177_ = _e885;
                        } else {
                            phi_1177_ = 5u;
                        }
                        let _e887 = phi_1177_;
                        phi_1178_ = _e887;
                    } else {
                        phi_1178_ = 4u;
                    }
                    let _e889 = phi_1178_;
                    phi_1179_ = _e889;
                } else {
                    phi_1179_ = 3u;
                }
                let _e891 = phi_1179_;
                phi_1180_ = _e891;
            } else {
                phi_1180_ = 2u;
            }
            let _e893 = phi_1180_;
            if !((_e893 == 0u)) {
                phi_1188_ = !((_e893 == 5u));
            } else {
                phi_1188_ = false;
            }
            let _e899 = phi_1188_;
            if _e899 {
                if _e251 {
                    phi_1196_ = (2u | 1u);
                } else {
                    phi_1196_ = 2u;
                }
                let _e902 = phi_1196_;
                if false {
                    phi_1201_ = (_e902 | 4u);
                } else {
                    phi_1201_ = _e902;
                }
                let _e905 = phi_1201_;
                phi_1206_ = _e905;
            } else {
                if _e251 {
                    phi_1205_ = 1u;
                } else {
                    phi_1205_ = 0u;
                }
                let _e907 = phi_1205_;
                phi_1206_ = _e907;
            }
            let _e909 = phi_1206_;
            if _e251 {
                phi_1210_ = 0f;
            } else {
                phi_1210_ = 1f;
            }
            let _e911 = phi_1210_;
            phi_1212_ = mask_Masked(_e911, _e909, _e899);
        }
        let _e914 = phi_1212_;
        visibility.member[_e77.first_primitive] = _e914.visibility;
        bits.member[_e77.first_primitive] = _e914.bits;
        let _e922 = samples.member[_e77.first_primitive].normal[0u];
        let _e924 = global[0u];
        if (_e922 == _e924) {
            let _e927 = samples.member[_e77.first_primitive].normal[1u];
            let _e929 = global[1u];
            if (_e927 == _e929) {
                let _e932 = samples.member[_e77.first_primitive].normal[2u];
                let _e934 = global[2u];
                phi_1240_ = (_e932 == _e934);
                phi_1241_ = false;
            } else {
                phi_1240_ = bool();
                phi_1241_ = true;
            }
            let _e937 = phi_1240_;
            let _e939 = phi_1241_;
            phi_1242_ = _e937;
            phi_1243_ = _e939;
        } else {
            phi_1242_ = bool();
            phi_1243_ = true;
        }
        let _e941 = phi_1242_;
        let _e943 = phi_1243_;
        if _e943 {
            phi_1247_ = false;
        } else {
            phi_1247_ = _e941;
        }
        let _e945 = phi_1247_;
        if !(_e945) {
            let _e948 = samples.member[_e77.first_primitive].position;
            let _e950 = p.member.current.eye;
            let _e961 = p.member.current.forward;
            phi_1275_ = ((((_e948.x - _e950.x) * _e961.x) + ((_e948.y - _e950.y) * _e961.y)) + ((_e948.z - _e950.z) * _e961.z));
        } else {
            phi_1275_ = 0f;
        }
        let _e971 = phi_1275_;
        depths.member[_e77.first_primitive] = _e971;
        phi_1278_ = _e914.needs_ray;
        phi_1279_ = _e77.first_primitive;
    } else {
        phi_1278_ = false;
        phi_1279_ = 0u;
    }
    let _e975 = phi_1278_;
    let _e977 = phi_1279_;
    if (_e57 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e975 {
        let _e981 = atomicAdd((&shared_[0u]), 1u);
        phi_1290_ = _e981;
    } else {
        phi_1290_ = 0u;
    }
    let _e983 = phi_1290_;
    workgroupBarrier();
    if (_e57 == 0u) {
        let _e987 = atomicLoad((&shared_[0u]));
        let _e988 = atomicAdd((&list.member[3u]), _e987);
        atomicStore((&shared_[1u]), _e988);
    }
    workgroupBarrier();
    if _e975 {
        let _e991 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e991) + _e983)]), _e977);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
