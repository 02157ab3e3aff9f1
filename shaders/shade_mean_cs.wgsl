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

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_9 {
    member: array<abi_Sample>,
}

struct type_13 {
    member: array<u32>,
}

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
}

struct type_29 {
    member: array<vec4<f32>>,
}

struct abi_ShadeParams {
    camera: abi_CameraParams,
    light: abi_LightParams,
    light_color: vec4<f32>,
}

struct type_35 {
    member: abi_ShadeParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(2) 
var<storage> light: type_29;
@group(0) @binding(3) 
var<storage, read_write> picture: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_144_: lt_mask_LightPlace;
    var phi_145_: bool;
    var phi_146_: lt_mask_LightPlace;
    var phi_147_: bool;
    var phi_152_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_144_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_145_ = false;
        } else {
            phi_144_ = lt_mask_LightPlace();
            phi_145_ = true;
        }
        let _e65 = phi_144_;
        let _e67 = phi_145_;
        phi_146_ = _e65;
        phi_147_ = _e67;
    } else {
        phi_146_ = lt_mask_LightPlace();
        phi_147_ = true;
    }
    let _e69 = phi_146_;
    let _e71 = phi_147_;
    if _e71 {
        phi_152_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_152_ = _e69;
    }
    let _e76 = phi_152_;
    return lt_mask_LightPlace(_e76.word, _e76.shift);
}

fn _lt_shaders_abi_Sample_is_valid(param_3: ptr<function, abi_Sample>) -> bool {
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_669_: bool;

    let _e55 = (*param_3).normal[0u];
    let _e57 = global[0u];
    if (_e55 == _e57) {
        let _e60 = (*param_3).normal[1u];
        let _e62 = global[1u];
        if (_e60 == _e62) {
            let _e65 = (*param_3).normal[2u];
            let _e67 = global[2u];
            phi_662_ = (_e65 == _e67);
            phi_663_ = false;
        } else {
            phi_662_ = bool();
            phi_663_ = true;
        }
        let _e70 = phi_662_;
        let _e72 = phi_663_;
        phi_664_ = _e70;
        phi_665_ = _e72;
    } else {
        phi_664_ = bool();
        phi_665_ = true;
    }
    let _e74 = phi_664_;
    let _e76 = phi_665_;
    if _e76 {
        phi_669_ = false;
    } else {
        phi_669_ = _e74;
    }
    let _e78 = phi_669_;
    return !(_e78);
}

fn function_() {
    var local: abi_Sample;
    var phi_210_: vec3<f32>;
    var phi_213_: u32;
    var phi_464_: f32;
    var phi_486_: vec3<f32>;
    var phi_211_: vec3<f32>;
    var phi_214_: u32;
    var local_1: vec3<f32>;
    var local_2: vec3<f32>;
    var local_3: vec3<f32>;
    var phi_515_: f32;
    var phi_516_: f32;
    var phi_536_: f32;
    var phi_537_: f32;
    var phi_546_: f32;
    var phi_547_: f32;
    var phi_567_: f32;
    var phi_568_: f32;
    var phi_577_: f32;
    var phi_578_: f32;
    var phi_598_: f32;
    var phi_599_: f32;

    let _e53 = id_1;
    let _e67 = p.member.camera.size[0u];
    let _e69 = p.member.camera.size[1u];
    let _e73 = p.member.camera.grid[0u];
    let _e75 = p.member.camera.grid[1u];
    if (_e73 == 0u) {
        return;
    }
    if (_e75 == 0u) {
        return;
    }
    let _e80 = lt_shaders_entry_pixel_index(_e53, (_e67 / _e73), (_e69 / _e75));
    if (bitcast<i32>(_e80.word) != 0i) {
        let _e90 = p.member.camera.size[0u];
        let _e94 = p.member.camera.grid[0u];
        let _e96 = p.member.camera.grid[1u];
        phi_210_ = vec3<f32>(0f, 0f, 0f);
        phi_213_ = 0u;
        loop {
            let _e98 = phi_210_;
            let _e100 = phi_213_;
            local_1 = _e98;
            local_2 = _e98;
            local_3 = _e98;
            let _e102 = (_e100 < (_e94 * _e96));
            if _e102 {
                if (_e94 == 0u) {
                    return;
                }
                if (_e94 == 0u) {
                    return;
                }
                let _e109 = ((_e53.x * _e94) + (_e100 % _e94));
                let _e110 = ((_e53.y * _e96) + (_e100 / _e94));
                let _e112 = ((_e110 * _e90) + _e109);
                if (_e112 < arrayLength((&samples.member))) {
                } else {
                    return;
                }
                let _e116 = samples.member[(0u + _e112)];
                if (_e112 < arrayLength((&light.member))) {
                } else {
                    return;
                }
                let _e120 = light.member[(0u + _e112)];
                local = abi_Sample(_e116.position, _e116.magnitude, _e116.normal, _e116.flags, _e116.shading_normal, _e116.albedo);
                let _e134 = p.member.camera.grid[0u];
                let _e136 = p.member.camera.grid[1u];
                let _e155 = p.member.camera.size[0u];
                let _e159 = ((((f32(_e109) + ((f32((_e110 & (_e136 - 1u))) + 0.5f) / f32(_e136))) / f32(_e155)) * 2f) - 1f);
                let _e162 = p.member.camera.size[1u];
                let _e166 = (1f - (((f32(_e110) + ((f32((_e109 & (_e134 - 1u))) + 0.5f) / f32(_e134))) / f32(_e162)) * 2f));
                let _e168 = p.member.camera.forward;
                let _e170 = p.member.camera.right;
                let _e184 = p.member.camera.up;
                let _e191 = ((_e168.x + (_e170.x * _e159)) + (_e184.x * _e166));
                let _e192 = ((_e168.y + (_e170.y * _e159)) + (_e184.y * _e166));
                let _e193 = ((_e168.z + (_e170.z * _e159)) + (_e184.z * _e166));
                let _e200 = (1f / sqrt((((_e191 * _e191) + (_e192 * _e192)) + (_e193 * _e193))));
                let _e202 = (_e192 * _e200);
                let _e204 = _lt_shaders_abi_Sample_is_valid((&local));
                if _e204 {
                    let _e206 = local.shading_normal;
                    let _e209 = (0.5f + (0.5f * _e206.y));
                    let _e210 = (1f - 0.4f);
                    let _e229 = (1f - _e209);
                    let _e255 = (0.8f + (0.2f * abs((((_e206.x * -((_e191 * _e200))) + (_e206.y * -(_e202))) + (_e206.z * -((_e193 * _e200)))))));
                    let _e257 = local.albedo;
                    let _e268 = (1f / 255f);
                    let _e269 = (f32((_e257 & 255u)) * _e268);
                    let _e270 = (f32(((_e257 >> bitcast<u32>(8i)) & 255u)) * _e268);
                    let _e271 = (f32(((_e257 >> bitcast<u32>(16i)) & 255u)) * _e268);
                    let _e285 = local.position;
                    let _e288 = p.member.camera.eye;
                    let _e291 = (_e285.x - _e288.x);
                    let _e294 = (_e285.y - _e288.y);
                    let _e297 = (_e285.z - _e288.z);
                    let _e306 = p.member.light_color[3u];
                    let _e310 = (1f - (1f / (1f + (sqrt((((_e291 * _e291) + (_e294 * _e294)) + (_e297 * _e297))) * _e306))));
                    let _e311 = (1f - _e310);
                    phi_486_ = vec3<f32>(((((_e269 * _e269) * (_e120.x + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e210) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * 0.4f)) * _e209) + (vec3<f32>(0.16f, 0.14f, 0.12f).x * _e229)) * 0.42f) * _e255))) * _e311) + (vec3<f32>(0.72f, 0.8f, 0.9f).x * _e310)), ((((_e270 * _e270) * (_e120.y + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e210) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * 0.4f)) * _e209) + (vec3<f32>(0.16f, 0.14f, 0.12f).y * _e229)) * 0.42f) * _e255))) * _e311) + (vec3<f32>(0.72f, 0.8f, 0.9f).y * _e310)), ((((_e271 * _e271) * (_e120.z + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e210) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * 0.4f)) * _e209) + (vec3<f32>(0.16f, 0.14f, 0.12f).z * _e229)) * 0.42f) * _e255))) * _e311) + (vec3<f32>(0.72f, 0.8f, 0.9f).z * _e310)));
                } else {
                    if (_e202 > 0f) {
                        phi_464_ = _e202;
                    } else {
                        phi_464_ = 0f;
                    }
                    let _e327 = phi_464_;
                    let _e331 = (1f - ((1f - _e327) * (1f - _e327)));
                    let _e332 = (1f - _e331);
                    phi_486_ = vec3<f32>(((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e332) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * _e331)), ((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e332) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * _e331)), ((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e332) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * _e331)));
                }
                let _e350 = phi_486_;
                let _e357 = vec3<f32>((_e98.x + _e350.x), _e98.y, _e98.z);
                phi_211_ = (vec3<f32>(_e98.x, _e357.y, vec3<f32>(_e357.x, (_e357.y + _e350.y), _e357.z).z) + _e350);
                phi_214_ = (_e100 + 1u);
            } else {
                phi_211_ = vec3<f32>();
                phi_214_ = u32();
            }
            let _e370 = phi_211_;
            let _e372 = phi_214_;
            continue;
            continuing {
                phi_210_ = _e370;
                phi_213_ = _e372;
                break if !(_e102);
            }
        }
        let _e375 = f32((_e94 * _e96));
        let _e377 = local_1;
        let _e379 = (_e377.x / _e375);
        let _e381 = local_2;
        let _e383 = (_e381.y / _e375);
        let _e385 = local_3;
        let _e387 = (_e385.z / _e375);
        if (_e379 > 0f) {
            if (_e379 < 1f) {
                phi_515_ = _e379;
            } else {
                phi_515_ = 1f;
            }
            let _e391 = phi_515_;
            phi_516_ = _e391;
        } else {
            phi_516_ = 0f;
        }
        let _e393 = phi_516_;
        let _e396 = sqrt(sqrt(_e393));
        let _e404 = ((((0.6620027f * sqrt(_e393)) + (0.6841221f * _e396)) - (0.3235836f * sqrt(_e396))) - (0.022541147f * _e393));
        if (_e404 > 0f) {
            if (_e404 < 1f) {
                phi_536_ = _e404;
            } else {
                phi_536_ = 1f;
            }
            let _e408 = phi_536_;
            phi_537_ = _e408;
        } else {
            phi_537_ = 0f;
        }
        let _e410 = phi_537_;
        if (_e383 > 0f) {
            if (_e383 < 1f) {
                phi_546_ = _e383;
            } else {
                phi_546_ = 1f;
            }
            let _e414 = phi_546_;
            phi_547_ = _e414;
        } else {
            phi_547_ = 0f;
        }
        let _e416 = phi_547_;
        let _e419 = sqrt(sqrt(_e416));
        let _e427 = ((((0.6620027f * sqrt(_e416)) + (0.6841221f * _e419)) - (0.3235836f * sqrt(_e419))) - (0.022541147f * _e416));
        if (_e427 > 0f) {
            if (_e427 < 1f) {
                phi_567_ = _e427;
            } else {
                phi_567_ = 1f;
            }
            let _e431 = phi_567_;
            phi_568_ = _e431;
        } else {
            phi_568_ = 0f;
        }
        let _e433 = phi_568_;
        if (_e387 > 0f) {
            if (_e387 < 1f) {
                phi_577_ = _e387;
            } else {
                phi_577_ = 1f;
            }
            let _e437 = phi_577_;
            phi_578_ = _e437;
        } else {
            phi_578_ = 0f;
        }
        let _e439 = phi_578_;
        let _e442 = sqrt(sqrt(_e439));
        let _e450 = ((((0.6620027f * sqrt(_e439)) + (0.6841221f * _e442)) - (0.3235836f * sqrt(_e442))) - (0.022541147f * _e439));
        if (_e450 > 0f) {
            if (_e450 < 1f) {
                phi_598_ = _e450;
            } else {
                phi_598_ = 1f;
            }
            let _e454 = phi_598_;
            phi_599_ = _e454;
        } else {
            phi_599_ = 0f;
        }
        let _e456 = phi_599_;
        let _e458 = ((_e410 * 255f) + 0.5f);
        let _e467 = ((_e433 * 255f) + 0.5f);
        let _e479 = ((_e456 * 255f) + 0.5f);
        if (_e80.shift < arrayLength((&picture.member))) {
        } else {
            return;
        }
        picture.member[(0u + _e80.shift)] = (((select(select(u32(_e458), 0u, (_e458 < bitcast<f32>(0u))), 4294967295u, (_e458 > bitcast<f32>(1333788671u))) | (select(select(u32(_e467), 0u, (_e467 < bitcast<f32>(0u))), 4294967295u, (_e467 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e479), 0u, (_e479 < bitcast<f32>(0u))), 4294967295u, (_e479 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_shade_shade_mean_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
