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

struct lt_mask_Neighbourhood {
    any_expands: bool,
    all_remove: bool,
}

struct type_40 {
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
var<storage, read_write> list: type_40;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_142_: lt_bvh_traverse_Tree;
    var phi_143_: bool;
    var phi_144_: lt_bvh_traverse_Tree;
    var phi_145_: bool;
    var phi_150_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_142_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_143_ = false;
        } else {
            phi_142_ = lt_bvh_traverse_Tree();
            phi_143_ = true;
        }
        let _e52 = phi_142_;
        let _e54 = phi_143_;
        phi_144_ = _e52;
        phi_145_ = _e54;
    } else {
        phi_144_ = lt_bvh_traverse_Tree();
        phi_145_ = true;
    }
    let _e56 = phi_144_;
    let _e58 = phi_145_;
    if _e58 {
        phi_150_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_150_ = _e56;
    }
    let _e63 = phi_150_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_168_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_168_ = vec2(0i);
            break;
        }
        case 1: {
            phi_168_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_168_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_168_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_168_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e48 = phi_168_;
    return vec2<i32>(_e48.x, _e48.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_186_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_186_ = vec2(0i);
            break;
        }
        case 1: {
            phi_186_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_186_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_186_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_186_ = vec2(1i);
            break;
        }
    }
    let _e48 = phi_186_;
    return vec2<i32>(_e48.x, _e48.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_205_: vec2<i32>;

    if (param_6 == 0u) {
        let _e42 = lt_mask_pattern_plus(param_5);
        phi_205_ = vec2<i32>(_e42.x, _e42.y);
    } else {
        let _e46 = lt_mask_pattern_cross(param_5);
        phi_205_ = vec2<i32>(_e46.x, _e46.y);
    }
    let _e51 = phi_205_;
    return vec2<i32>(_e51.x, _e51.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_230_: vec2<i32>;

    let _e40 = (param_7 % 13u);
    switch bitcast<i32>(_e40) {
        case 9: {
            phi_230_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_230_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_230_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_230_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_230_ = vec2<i32>((bitcast<i32>((_e40 % 3u)) - 1i), (bitcast<i32>(((_e40 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e55 = phi_230_;
    return vec2<i32>(_e55.x, _e55.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_251_: u32;
    var phi_252_: u32;

    let _e43 = (bitcast<i32>(param_8) + param_9);
    if (_e43 < 0i) {
        phi_252_ = 0u;
    } else {
        if (_e43 >= bitcast<i32>(param_10)) {
            phi_251_ = (param_10 - 1u);
        } else {
            phi_251_ = bitcast<u32>(_e43);
        }
        let _e50 = phi_251_;
        phi_252_ = _e50;
    }
    let _e52 = phi_252_;
    return _e52;
}

fn function_() {
    var phi_313_: bool;
    var phi_314_: bool;
    var phi_315_: bool;
    var phi_316_: bool;
    var phi_320_: bool;
    var phi_364_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_368_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_381_: bool;
    var phi_402_: bool;
    var phi_413_: bool;
    var phi_414_: bool;
    var phi_415_: bool;
    var phi_416_: bool;
    var phi_417_: bool;
    var phi_418_: bool;
    var phi_422_: bool;
    var phi_427_: bool;
    var phi_441_: u32;
    var phi_443_: u32;
    var phi_446_: lt_mask_Neighbourhood;
    var phi_458_: bool;
    var phi_459_: bool;
    var phi_468_: u32;
    var phi_469_: u32;
    var phi_529_: vec2<i32>;
    var phi_549_: vec2<i32>;
    var phi_572_: u32;
    var phi_589_: bool;
    var phi_590_: bool;
    var phi_597_: bool;
    var phi_598_: bool;
    var phi_616_: bool;
    var phi_617_: bool;
    var phi_618_: bool;
    var phi_444_: u32;
    var phi_447_: lt_mask_Neighbourhood;
    var phi_621_: lt_mask_Neighbourhood;
    var phi_622_: lt_mask_Neighbourhood;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_670_: u32;
    var phi_671_: u32;
    var phi_672_: u32;
    var phi_673_: u32;
    var phi_674_: u32;
    var phi_682_: bool;
    var phi_690_: u32;
    var phi_695_: u32;
    var phi_699_: u32;
    var phi_700_: u32;
    var phi_704_: f32;
    var phi_706_: mask_Masked;
    var phi_712_: bool;
    var phi_713_: u32;
    var phi_724_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e39 = id_1;
    let _e40 = local_2;
    let _e52 = p.member.current.size[0u];
    let _e54 = p.member.current.size[1u];
    let _e55 = lt_shaders_entry_pixel_index(_e39, _e52, _e54);
    if (bitcast<i32>(_e55.root) != 0i) {
        let _e63 = p.member.current.size[0u];
        let _e68 = visibility.member[_e55.first_primitive];
        let _e72 = p.member.light;
        let _e75 = samples.member[_e55.first_primitive].normal[0u];
        let _e77 = global[0u];
        if (_e75 == _e77) {
            let _e80 = samples.member[_e55.first_primitive].normal[1u];
            let _e82 = global[1u];
            if (_e80 == _e82) {
                let _e85 = samples.member[_e55.first_primitive].normal[2u];
                let _e87 = global[2u];
                phi_313_ = (_e85 == _e87);
                phi_314_ = false;
            } else {
                phi_313_ = bool();
                phi_314_ = true;
            }
            let _e90 = phi_313_;
            let _e92 = phi_314_;
            phi_315_ = _e90;
            phi_316_ = _e92;
        } else {
            phi_315_ = bool();
            phi_316_ = true;
        }
        let _e94 = phi_315_;
        let _e96 = phi_316_;
        if _e96 {
            phi_320_ = false;
        } else {
            phi_320_ = _e94;
        }
        let _e98 = phi_320_;
        if !(_e98) {
            let _e101 = samples.member[_e55.first_primitive].normal;
            let _e103 = samples.member[_e55.first_primitive].position;
            if ((((_e101.x * (_e72.x - (_e103.x * _e72.w))) + (_e101.y * (_e72.y - (_e103.y * _e72.w)))) + (_e101.z * (_e72.z - (_e103.z * _e72.w)))) > 0f) {
                let _e127 = samples.member[_e55.first_primitive].flags;
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e135.unnamed.visibility, false), _e135.unnamed_1);
                phi_364_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e141.unnamed, ((_e127 & 1u) == 0u));
            } else {
                let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e150.unnamed.visibility, false), _e150.unnamed_1);
                phi_364_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e156.unnamed, true);
            }
            let _e161 = phi_364_;
            phi_368_ = _e161;
        } else {
            let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
            phi_368_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, true);
        }
        let _e178 = phi_368_;
        if _e178.unnamed_1 {
            phi_706_ = mask_Masked(_e178.unnamed.visibility, 0u, false);
        } else {
            let _e183 = (_e68 < 0.5f);
            if (_e68 > 0f) {
                phi_381_ = (_e68 < 1f);
            } else {
                phi_381_ = false;
            }
            let _e187 = phi_381_;
            let _e189 = p.member.flags;
            let _e191 = ((_e189 & 1u) != 0u);
            let _e193 = p.member.flags;
            if false {
                let _e197 = p.member.flags;
                phi_402_ = ((_e197 & 4u) == 0u);
            } else {
                phi_402_ = false;
            }
            let _e201 = phi_402_;
            if ((_e193 & 2u) != 0u) {
                if false {
                    phi_415_ = bool();
                    phi_416_ = true;
                } else {
                    if true {
                        phi_413_ = !(_e201);
                        phi_414_ = false;
                    } else {
                        phi_413_ = bool();
                        phi_414_ = true;
                    }
                    let _e204 = phi_413_;
                    let _e206 = phi_414_;
                    phi_415_ = _e204;
                    phi_416_ = _e206;
                }
                let _e208 = phi_415_;
                let _e210 = phi_416_;
                phi_417_ = _e208;
                phi_418_ = _e210;
            } else {
                phi_417_ = bool();
                phi_418_ = true;
            }
            let _e212 = phi_417_;
            let _e214 = phi_418_;
            if _e214 {
                phi_422_ = false;
            } else {
                phi_422_ = _e212;
            }
            let _e216 = phi_422_;
            let _e217 = lt_mask_Neighbourhood(false, true);
            if _e187 {
                phi_427_ = _e216;
            } else {
                phi_427_ = false;
            }
            let _e219 = phi_427_;
            if _e219 {
                if _e191 {
                    if false {
                        let _e221 = p.member.moving_pattern;
                        phi_441_ = _e221;
                    } else {
                        let _e223 = p.member.still_pattern;
                        phi_441_ = _e223;
                    }
                    let _e225 = phi_441_;
                    phi_443_ = 0u;
                    phi_446_ = _e217;
                    loop {
                        let _e227 = phi_443_;
                        let _e229 = phi_446_;
                        local_1 = _e229;
                        if (1u <= _e225) {
                            if (_e225 <= 4u) {
                                phi_458_ = false;
                            } else {
                                phi_458_ = true;
                            }
                            let _e233 = phi_458_;
                            phi_459_ = _e233;
                        } else {
                            phi_459_ = true;
                        }
                        let _e235 = phi_459_;
                        if _e235 {
                            switch bitcast<i32>(_e225) {
                                case 5: {
                                    phi_468_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_468_ = 25u;
                                    break;
                                }
                                case 7: {
                                    phi_468_ = 13u;
                                    break;
                                }
                                default: {
                                    phi_468_ = 9u;
                                    break;
                                }
                            }
                            let _e238 = phi_468_;
                            phi_469_ = _e238;
                        } else {
                            phi_469_ = 5u;
                        }
                        let _e240 = phi_469_;
                        let _e241 = (_e227 < _e240);
                        if _e241 {
                            let _e243 = p.member.frame;
                            let _e247 = p.member.current.size[0u];
                            let _e249 = p.member.current.size[1u];
                            switch bitcast<i32>(_e225) {
                                case 1: {
                                    let _e259 = lt_mask_pattern_plus(_e227);
                                    phi_549_ = vec2<i32>(_e259.x, _e259.y);
                                    break;
                                }
                                case 2: {
                                    let _e263 = lt_mask_pattern_cross(_e227);
                                    phi_549_ = vec2<i32>(_e263.x, _e263.y);
                                    break;
                                }
                                case 3: {
                                    let _e269 = lt_mask_pattern_plus_or_cross(_e227, ((_e39.x + _e39.y) & 1u));
                                    phi_549_ = vec2<i32>(_e269.x, _e269.y);
                                    break;
                                }
                                case 4: {
                                    let _e274 = lt_mask_pattern_plus_or_cross(_e227, (_e243 & 1u));
                                    phi_549_ = vec2<i32>(_e274.x, _e274.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e243 & 3u)) {
                                        case 0: {
                                            phi_529_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_529_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_529_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_529_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e285 = phi_529_;
                                    phi_549_ = (_e285 + vec2<i32>(bitcast<i32>((_e227 & 1u)), bitcast<i32>(((_e227 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_549_ = vec2<i32>((bitcast<i32>((_e227 % 5u)) - 2i), (bitcast<i32>(((_e227 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                case 7: {
                                    let _e302 = lt_mask_pattern_diamond(_e227);
                                    phi_549_ = vec2<i32>(_e302.x, _e302.y);
                                    break;
                                }
                                default: {
                                    phi_549_ = vec2<i32>((bitcast<i32>((_e227 % 3u)) - 1i), (bitcast<i32>(((_e227 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e307 = phi_549_;
                            let _e310 = lt_mask_pattern_step_clamped(_e39.x, _e307.x, _e247);
                            let _e311 = lt_mask_pattern_step_clamped(_e39.y, _e307.y, _e249);
                            let _e313 = ((_e311 * _e63) + _e310);
                            if (_e313 < arrayLength((&last_bits.member))) {
                            } else {
                                return;
                            }
                            let _e317 = last_bits.member[(0u + _e313)];
                            if ((_e317 & 2u) == 0u) {
                                phi_572_ = (_e317 & 1u);
                            } else {
                                phi_572_ = (_e317 & 7u);
                            }
                            let _e323 = phi_572_;
                            if _e229.any_expands {
                                phi_598_ = true;
                            } else {
                                if ((_e323 & 2u) != 0u) {
                                    if (((_e323 & 4u) != 0u) != _e183) {
                                        phi_589_ = false;
                                    } else {
                                        phi_589_ = true;
                                    }
                                    let _e332 = phi_589_;
                                    phi_590_ = _e332;
                                } else {
                                    phi_590_ = true;
                                }
                                let _e334 = phi_590_;
                                if _e334 {
                                    phi_597_ = (((_e323 & 1u) != 0u) != _e183);
                                } else {
                                    phi_597_ = true;
                                }
                                let _e339 = phi_597_;
                                phi_598_ = _e339;
                            }
                            let _e341 = phi_598_;
                            if _e229.all_remove {
                                if (((_e323 & 1u) != 0u) == _e183) {
                                    if ((_e323 & 2u) != 0u) {
                                        phi_616_ = (((_e323 & 4u) != 0u) == _e183);
                                    } else {
                                        phi_616_ = true;
                                    }
                                    let _e351 = phi_616_;
                                    phi_617_ = _e351;
                                } else {
                                    phi_617_ = false;
                                }
                                let _e353 = phi_617_;
                                phi_618_ = _e353;
                            } else {
                                phi_618_ = false;
                            }
                            let _e355 = phi_618_;
                            phi_444_ = (_e227 + 1u);
                            phi_447_ = lt_mask_Neighbourhood(_e341, _e355);
                        } else {
                            phi_444_ = u32();
                            phi_447_ = lt_mask_Neighbourhood();
                        }
                        let _e359 = phi_444_;
                        let _e361 = phi_447_;
                        continue;
                        continuing {
                            phi_443_ = _e359;
                            phi_446_ = _e361;
                            break if !(_e241);
                        }
                    }
                    let _e475 = local_1;
                    phi_621_ = _e475;
                } else {
                    phi_621_ = _e217;
                }
                let _e364 = phi_621_;
                phi_622_ = _e364;
            } else {
                phi_622_ = _e217;
            }
            let _e366 = phi_622_;
            if (_e68 != 0.5f) {
                if _e191 {
                    if _e187 {
                        phi_648_ = true;
                    } else {
                        if _e366.any_expands {
                            phi_647_ = false;
                        } else {
                            phi_647_ = true;
                        }
                        let _e371 = phi_647_;
                        phi_648_ = _e371;
                    }
                    let _e373 = phi_648_;
                    if _e373 {
                        if _e187 {
                            if _e216 {
                                if _e366.all_remove {
                                    phi_661_ = false;
                                } else {
                                    phi_661_ = true;
                                }
                                let _e375 = phi_661_;
                                phi_662_ = _e375;
                            } else {
                                phi_662_ = true;
                            }
                            let _e377 = phi_662_;
                            phi_663_ = _e377;
                        } else {
                            phi_663_ = true;
                        }
                        let _e379 = phi_663_;
                        if _e379 {
                            if _e187 {
                                phi_670_ = 1u;
                            } else {
                                phi_670_ = 0u;
                            }
                            let _e381 = phi_670_;
                            phi_671_ = _e381;
                        } else {
                            phi_671_ = 5u;
                        }
                        let _e383 = phi_671_;
                        phi_672_ = _e383;
                    } else {
                        phi_672_ = 4u;
                    }
                    let _e385 = phi_672_;
                    phi_673_ = _e385;
                } else {
                    phi_673_ = 3u;
                }
                let _e387 = phi_673_;
                phi_674_ = _e387;
            } else {
                phi_674_ = 2u;
            }
            let _e389 = phi_674_;
            if !((_e389 == 0u)) {
                phi_682_ = !((_e389 == 5u));
            } else {
                phi_682_ = false;
            }
            let _e395 = phi_682_;
            if _e395 {
                if _e183 {
                    phi_690_ = (2u | 1u);
                } else {
                    phi_690_ = 2u;
                }
                let _e398 = phi_690_;
                if false {
                    phi_695_ = (_e398 | 4u);
                } else {
                    phi_695_ = _e398;
                }
                let _e401 = phi_695_;
                phi_700_ = _e401;
            } else {
                if _e183 {
                    phi_699_ = 1u;
                } else {
                    phi_699_ = 0u;
                }
                let _e403 = phi_699_;
                phi_700_ = _e403;
            }
            let _e405 = phi_700_;
            if _e183 {
                phi_704_ = 0f;
            } else {
                phi_704_ = 1f;
            }
            let _e407 = phi_704_;
            phi_706_ = mask_Masked(_e407, _e405, _e395);
        }
        let _e410 = phi_706_;
        visibility.member[_e55.first_primitive] = _e410.visibility;
        bits.member[_e55.first_primitive] = _e410.bits;
        phi_712_ = _e410.needs_ray;
        phi_713_ = _e55.first_primitive;
    } else {
        phi_712_ = false;
        phi_713_ = 0u;
    }
    let _e417 = phi_712_;
    let _e419 = phi_713_;
    if (_e40 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e417 {
        let _e423 = atomicAdd((&shared_[0u]), 1u);
        phi_724_ = _e423;
    } else {
        phi_724_ = 0u;
    }
    let _e425 = phi_724_;
    workgroupBarrier();
    if (_e40 == 0u) {
        let _e429 = atomicLoad((&shared_[0u]));
        let _e430 = atomicAdd((&list.member[3u]), _e429);
        atomicStore((&shared_[1u]), _e430);
    }
    workgroupBarrier();
    if _e417 {
        let _e433 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e433) + _e425)]), _e419);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
