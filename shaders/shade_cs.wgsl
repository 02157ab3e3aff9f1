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

struct type_31 {
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
var<storage> light: type_31;
@group(0) @binding(3) 
var<storage, read_write> picture: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_131_: lt_mask_LightPlace;
    var phi_132_: bool;
    var phi_133_: lt_mask_LightPlace;
    var phi_134_: bool;
    var phi_139_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_131_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_132_ = false;
        } else {
            phi_131_ = lt_mask_LightPlace();
            phi_132_ = true;
        }
        let _e62 = phi_131_;
        let _e64 = phi_132_;
        phi_133_ = _e62;
        phi_134_ = _e64;
    } else {
        phi_133_ = lt_mask_LightPlace();
        phi_134_ = true;
    }
    let _e66 = phi_133_;
    let _e68 = phi_134_;
    if _e68 {
        phi_139_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_139_ = _e66;
    }
    let _e73 = phi_139_;
    return lt_mask_LightPlace(_e73.word, _e73.shift);
}

fn function_() {
    var phi_261_: bool;
    var phi_262_: bool;
    var phi_263_: bool;
    var phi_264_: bool;
    var phi_268_: bool;
    var phi_397_: f32;
    var phi_398_: f32;
    var phi_418_: f32;
    var phi_419_: f32;
    var phi_428_: f32;
    var phi_429_: f32;
    var phi_449_: f32;
    var phi_450_: f32;
    var phi_459_: f32;
    var phi_460_: f32;
    var phi_480_: f32;
    var phi_481_: f32;
    var phi_518_: f32;
    var phi_547_: f32;
    var phi_548_: f32;
    var phi_568_: f32;
    var phi_569_: f32;
    var phi_578_: f32;
    var phi_579_: f32;
    var phi_599_: f32;
    var phi_600_: f32;
    var phi_609_: f32;
    var phi_610_: f32;
    var phi_630_: f32;
    var phi_631_: f32;
    var phi_664_: u32;

    let _e49 = id_1;
    let _e63 = p.member.camera.size[0u];
    let _e65 = p.member.camera.size[1u];
    let _e66 = lt_shaders_entry_pixel_index(_e49, _e63, _e65);
    if (bitcast<i32>(_e66.word) != 0i) {
        if (_e66.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        if (_e66.shift < arrayLength((&light.member))) {
        } else {
            return;
        }
        let _e79 = light.member[(0u + _e66.shift)];
        let _e88 = p.member.camera.size[0u];
        let _e92 = ((((f32(_e49.x) + 0.5f) / f32(_e88)) * 2f) - 1f);
        let _e97 = p.member.camera.size[1u];
        let _e101 = (1f - (((f32(_e49.y) + 0.5f) / f32(_e97)) * 2f));
        let _e103 = p.member.camera.forward;
        let _e105 = p.member.camera.right;
        let _e119 = p.member.camera.up;
        let _e126 = ((_e103.x + (_e105.x * _e92)) + (_e119.x * _e101));
        let _e127 = ((_e103.y + (_e105.y * _e92)) + (_e119.y * _e101));
        let _e128 = ((_e103.z + (_e105.z * _e92)) + (_e119.z * _e101));
        let _e135 = (1f / sqrt((((_e126 * _e126) + (_e127 * _e127)) + (_e128 * _e128))));
        let _e137 = (_e127 * _e135);
        let _e141 = samples.member[(0u + _e66.shift)].normal[0u];
        let _e143 = global[0u];
        if (_e141 == _e143) {
            let _e146 = samples.member[(0u + _e66.shift)].normal[1u];
            let _e148 = global[1u];
            if (_e146 == _e148) {
                let _e151 = samples.member[(0u + _e66.shift)].normal[2u];
                let _e153 = global[2u];
                phi_261_ = (_e151 == _e153);
                phi_262_ = false;
            } else {
                phi_261_ = bool();
                phi_262_ = true;
            }
            let _e156 = phi_261_;
            let _e158 = phi_262_;
            phi_263_ = _e156;
            phi_264_ = _e158;
        } else {
            phi_263_ = bool();
            phi_264_ = true;
        }
        let _e160 = phi_263_;
        let _e162 = phi_264_;
        if _e162 {
            phi_268_ = false;
        } else {
            phi_268_ = _e160;
        }
        let _e164 = phi_268_;
        if !(_e164) {
            let _e167 = samples.member[(0u + _e66.shift)].shading_normal;
            let _e170 = (0.5f + (0.5f * _e167.y));
            let _e171 = (1f - 0.4f);
            let _e190 = (1f - _e170);
            let _e216 = (0.8f + (0.2f * abs((((_e167.x * -((_e126 * _e135))) + (_e167.y * -(_e137))) + (_e167.z * -((_e128 * _e135)))))));
            let _e218 = samples.member[(0u + _e66.shift)].albedo;
            let _e229 = (1f / 255f);
            let _e230 = (f32((_e218 & 255u)) * _e229);
            let _e231 = (f32(((_e218 >> bitcast<u32>(8i)) & 255u)) * _e229);
            let _e232 = (f32(((_e218 >> bitcast<u32>(16i)) & 255u)) * _e229);
            let _e246 = samples.member[(0u + _e66.shift)].position;
            let _e249 = p.member.camera.eye;
            let _e252 = (_e246.x - _e249.x);
            let _e255 = (_e246.y - _e249.y);
            let _e258 = (_e246.z - _e249.z);
            let _e267 = p.member.light_color[3u];
            let _e271 = (1f - (1f / (1f + (sqrt((((_e252 * _e252) + (_e255 * _e255)) + (_e258 * _e258))) * _e267))));
            let _e272 = (1f - _e271);
            let _e282 = ((((_e230 * _e230) * (_e79.x + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e171) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * 0.4f)) * _e170) + (vec3<f32>(0.16f, 0.14f, 0.12f).x * _e190)) * 0.42f) * _e216))) * _e272) + (vec3<f32>(0.72f, 0.8f, 0.9f).x * _e271));
            let _e283 = ((((_e231 * _e231) * (_e79.y + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e171) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * 0.4f)) * _e170) + (vec3<f32>(0.16f, 0.14f, 0.12f).y * _e190)) * 0.42f) * _e216))) * _e272) + (vec3<f32>(0.72f, 0.8f, 0.9f).y * _e271));
            let _e284 = ((((_e232 * _e232) * (_e79.z + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e171) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * 0.4f)) * _e170) + (vec3<f32>(0.16f, 0.14f, 0.12f).z * _e190)) * 0.42f) * _e216))) * _e272) + (vec3<f32>(0.72f, 0.8f, 0.9f).z * _e271));
            if (_e282 > 0f) {
                if (_e282 < 1f) {
                    phi_397_ = _e282;
                } else {
                    phi_397_ = 1f;
                }
                let _e288 = phi_397_;
                phi_398_ = _e288;
            } else {
                phi_398_ = 0f;
            }
            let _e290 = phi_398_;
            let _e293 = sqrt(sqrt(_e290));
            let _e301 = ((((0.6620027f * sqrt(_e290)) + (0.6841221f * _e293)) - (0.3235836f * sqrt(_e293))) - (0.022541147f * _e290));
            if (_e301 > 0f) {
                if (_e301 < 1f) {
                    phi_418_ = _e301;
                } else {
                    phi_418_ = 1f;
                }
                let _e305 = phi_418_;
                phi_419_ = _e305;
            } else {
                phi_419_ = 0f;
            }
            let _e307 = phi_419_;
            if (_e283 > 0f) {
                if (_e283 < 1f) {
                    phi_428_ = _e283;
                } else {
                    phi_428_ = 1f;
                }
                let _e311 = phi_428_;
                phi_429_ = _e311;
            } else {
                phi_429_ = 0f;
            }
            let _e313 = phi_429_;
            let _e316 = sqrt(sqrt(_e313));
            let _e324 = ((((0.6620027f * sqrt(_e313)) + (0.6841221f * _e316)) - (0.3235836f * sqrt(_e316))) - (0.022541147f * _e313));
            if (_e324 > 0f) {
                if (_e324 < 1f) {
                    phi_449_ = _e324;
                } else {
                    phi_449_ = 1f;
                }
                let _e328 = phi_449_;
                phi_450_ = _e328;
            } else {
                phi_450_ = 0f;
            }
            let _e330 = phi_450_;
            if (_e284 > 0f) {
                if (_e284 < 1f) {
                    phi_459_ = _e284;
                } else {
                    phi_459_ = 1f;
                }
                let _e334 = phi_459_;
                phi_460_ = _e334;
            } else {
                phi_460_ = 0f;
            }
            let _e336 = phi_460_;
            let _e339 = sqrt(sqrt(_e336));
            let _e347 = ((((0.6620027f * sqrt(_e336)) + (0.6841221f * _e339)) - (0.3235836f * sqrt(_e339))) - (0.022541147f * _e336));
            if (_e347 > 0f) {
                if (_e347 < 1f) {
                    phi_480_ = _e347;
                } else {
                    phi_480_ = 1f;
                }
                let _e351 = phi_480_;
                phi_481_ = _e351;
            } else {
                phi_481_ = 0f;
            }
            let _e353 = phi_481_;
            let _e355 = ((_e307 * 255f) + 0.5f);
            let _e364 = ((_e330 * 255f) + 0.5f);
            let _e376 = ((_e353 * 255f) + 0.5f);
            phi_664_ = (((select(select(u32(_e355), 0u, (_e355 < bitcast<f32>(0u))), 4294967295u, (_e355 > bitcast<f32>(1333788671u))) | (select(select(u32(_e364), 0u, (_e364 < bitcast<f32>(0u))), 4294967295u, (_e364 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e376), 0u, (_e376 < bitcast<f32>(0u))), 4294967295u, (_e376 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
        } else {
            if (_e137 > 0f) {
                phi_518_ = _e137;
            } else {
                phi_518_ = 0f;
            }
            let _e390 = phi_518_;
            let _e394 = (1f - ((1f - _e390) * (1f - _e390)));
            let _e395 = (1f - _e394);
            let _e408 = ((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e395) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * _e394));
            let _e409 = ((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e395) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * _e394));
            let _e410 = ((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e395) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * _e394));
            if (_e408 > 0f) {
                if (_e408 < 1f) {
                    phi_547_ = _e408;
                } else {
                    phi_547_ = 1f;
                }
                let _e414 = phi_547_;
                phi_548_ = _e414;
            } else {
                phi_548_ = 0f;
            }
            let _e416 = phi_548_;
            let _e419 = sqrt(sqrt(_e416));
            let _e427 = ((((0.6620027f * sqrt(_e416)) + (0.6841221f * _e419)) - (0.3235836f * sqrt(_e419))) - (0.022541147f * _e416));
            if (_e427 > 0f) {
                if (_e427 < 1f) {
                    phi_568_ = _e427;
                } else {
                    phi_568_ = 1f;
                }
                let _e431 = phi_568_;
                phi_569_ = _e431;
            } else {
                phi_569_ = 0f;
            }
            let _e433 = phi_569_;
            if (_e409 > 0f) {
                if (_e409 < 1f) {
                    phi_578_ = _e409;
                } else {
                    phi_578_ = 1f;
                }
                let _e437 = phi_578_;
                phi_579_ = _e437;
            } else {
                phi_579_ = 0f;
            }
            let _e439 = phi_579_;
            let _e442 = sqrt(sqrt(_e439));
            let _e450 = ((((0.6620027f * sqrt(_e439)) + (0.6841221f * _e442)) - (0.3235836f * sqrt(_e442))) - (0.022541147f * _e439));
            if (_e450 > 0f) {
                if (_e450 < 1f) {
                    phi_599_ = _e450;
                } else {
                    phi_599_ = 1f;
                }
                let _e454 = phi_599_;
                phi_600_ = _e454;
            } else {
                phi_600_ = 0f;
            }
            let _e456 = phi_600_;
            if (_e410 > 0f) {
                if (_e410 < 1f) {
                    phi_609_ = _e410;
                } else {
                    phi_609_ = 1f;
                }
                let _e460 = phi_609_;
                phi_610_ = _e460;
            } else {
                phi_610_ = 0f;
            }
            let _e462 = phi_610_;
            let _e465 = sqrt(sqrt(_e462));
            let _e473 = ((((0.6620027f * sqrt(_e462)) + (0.6841221f * _e465)) - (0.3235836f * sqrt(_e465))) - (0.022541147f * _e462));
            if (_e473 > 0f) {
                if (_e473 < 1f) {
                    phi_630_ = _e473;
                } else {
                    phi_630_ = 1f;
                }
                let _e477 = phi_630_;
                phi_631_ = _e477;
            } else {
                phi_631_ = 0f;
            }
            let _e479 = phi_631_;
            let _e481 = ((_e433 * 255f) + 0.5f);
            let _e490 = ((_e456 * 255f) + 0.5f);
            let _e502 = ((_e479 * 255f) + 0.5f);
            phi_664_ = (((select(select(u32(_e481), 0u, (_e481 < bitcast<f32>(0u))), 4294967295u, (_e481 > bitcast<f32>(1333788671u))) | (select(select(u32(_e490), 0u, (_e490 < bitcast<f32>(0u))), 4294967295u, (_e490 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e502), 0u, (_e502 < bitcast<f32>(0u))), 4294967295u, (_e502 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
        }
        let _e515 = phi_664_;
        if (_e66.shift < arrayLength((&picture.member))) {
        } else {
            return;
        }
        picture.member[(0u + _e66.shift)] = _e515;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_shade_shade_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
