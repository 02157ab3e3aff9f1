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

struct type_9 {
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

struct type_18 {
    member: array<abi_Sample>,
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
var<storage> samples: type_18;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(2) 
var<storage> light: type_31;
@group(0) @binding(3) 
var<storage, read_write> picture: type_9;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_139_: lt_bvh_traverse_Tree;
    var phi_140_: bool;
    var phi_141_: lt_bvh_traverse_Tree;
    var phi_142_: bool;
    var phi_147_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_139_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_140_ = false;
        } else {
            phi_139_ = lt_bvh_traverse_Tree();
            phi_140_ = true;
        }
        let _e65 = phi_139_;
        let _e67 = phi_140_;
        phi_141_ = _e65;
        phi_142_ = _e67;
    } else {
        phi_141_ = lt_bvh_traverse_Tree();
        phi_142_ = true;
    }
    let _e69 = phi_141_;
    let _e71 = phi_142_;
    if _e71 {
        phi_147_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_147_ = _e69;
    }
    let _e76 = phi_147_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn function_() {
    var phi_201_: vec3<f32>;
    var phi_204_: u32;
    var phi_347_: bool;
    var phi_348_: bool;
    var phi_349_: bool;
    var phi_350_: bool;
    var phi_354_: bool;
    var phi_480_: f32;
    var phi_502_: vec3<f32>;
    var phi_202_: vec3<f32>;
    var phi_205_: u32;
    var local: vec3<f32>;
    var local_1: vec3<f32>;
    var local_2: vec3<f32>;
    var phi_531_: f32;
    var phi_532_: f32;
    var phi_552_: f32;
    var phi_553_: f32;
    var phi_562_: f32;
    var phi_563_: f32;
    var phi_583_: f32;
    var phi_584_: f32;
    var phi_593_: f32;
    var phi_594_: f32;
    var phi_614_: f32;
    var phi_615_: f32;

    let _e52 = id_1;
    let _e66 = p.member.camera.size[0u];
    let _e68 = p.member.camera.size[1u];
    let _e72 = p.member.camera.grid[0u];
    let _e74 = p.member.camera.grid[1u];
    if (_e72 == 0u) {
        return;
    }
    if (_e74 == 0u) {
        return;
    }
    let _e79 = lt_shaders_entry_pixel_index(_e52, (_e66 / _e72), (_e68 / _e74));
    if (bitcast<i32>(_e79.root) != 0i) {
        let _e89 = p.member.camera.grid[0u];
        let _e91 = p.member.camera.grid[1u];
        phi_201_ = vec3<f32>(0f, 0f, 0f);
        phi_204_ = 0u;
        loop {
            let _e93 = phi_201_;
            let _e95 = phi_204_;
            local = _e93;
            local_1 = _e93;
            local_2 = _e93;
            let _e97 = (_e95 < (_e89 * _e91));
            if _e97 {
                if (_e89 == 0u) {
                    return;
                }
                if (_e89 == 0u) {
                    return;
                }
                let _e104 = ((_e52.x * _e89) + (_e95 % _e89));
                let _e105 = ((_e52.y * _e91) + (_e95 / _e89));
                let _e109 = p.member.camera.size[0u];
                let _e111 = ((_e105 * _e109) + _e104);
                if (_e111 < arrayLength((&samples.member))) {
                } else {
                    return;
                }
                if (_e111 < arrayLength((&light.member))) {
                } else {
                    return;
                }
                let _e118 = light.member[(0u + _e111)];
                let _e125 = p.member.camera.grid[0u];
                let _e127 = p.member.camera.grid[1u];
                let _e146 = p.member.camera.size[0u];
                let _e150 = ((((f32(_e104) + ((f32((_e105 & (_e127 - 1u))) + 0.5f) / f32(_e127))) / f32(_e146)) * 2f) - 1f);
                let _e153 = p.member.camera.size[1u];
                let _e157 = (1f - (((f32(_e105) + ((f32((_e104 & (_e125 - 1u))) + 0.5f) / f32(_e125))) / f32(_e153)) * 2f));
                let _e159 = p.member.camera.forward;
                let _e161 = p.member.camera.right;
                let _e175 = p.member.camera.up;
                let _e182 = ((_e159.x + (_e161.x * _e150)) + (_e175.x * _e157));
                let _e183 = ((_e159.y + (_e161.y * _e150)) + (_e175.y * _e157));
                let _e184 = ((_e159.z + (_e161.z * _e150)) + (_e175.z * _e157));
                let _e191 = (1f / sqrt((((_e182 * _e182) + (_e183 * _e183)) + (_e184 * _e184))));
                let _e193 = (_e183 * _e191);
                let _e197 = samples.member[(0u + _e111)].normal[0u];
                let _e199 = global[0u];
                if (_e197 == _e199) {
                    let _e202 = samples.member[(0u + _e111)].normal[1u];
                    let _e204 = global[1u];
                    if (_e202 == _e204) {
                        let _e207 = samples.member[(0u + _e111)].normal[2u];
                        let _e209 = global[2u];
                        phi_347_ = (_e207 == _e209);
                        phi_348_ = false;
                    } else {
                        phi_347_ = bool();
                        phi_348_ = true;
                    }
                    let _e212 = phi_347_;
                    let _e214 = phi_348_;
                    phi_349_ = _e212;
                    phi_350_ = _e214;
                } else {
                    phi_349_ = bool();
                    phi_350_ = true;
                }
                let _e216 = phi_349_;
                let _e218 = phi_350_;
                if _e218 {
                    phi_354_ = false;
                } else {
                    phi_354_ = _e216;
                }
                let _e220 = phi_354_;
                if !(_e220) {
                    let _e223 = samples.member[(0u + _e111)].shading_normal;
                    let _e226 = (0.5f + (0.5f * _e223.y));
                    let _e227 = (1f - 0.4f);
                    let _e246 = (1f - _e226);
                    let _e272 = (0.8f + (0.2f * abs((((_e223.x * -((_e182 * _e191))) + (_e223.y * -(_e193))) + (_e223.z * -((_e184 * _e191)))))));
                    let _e274 = samples.member[(0u + _e111)].albedo;
                    let _e285 = (1f / 255f);
                    let _e286 = (f32((_e274 & 255u)) * _e285);
                    let _e287 = (f32(((_e274 >> bitcast<u32>(8i)) & 255u)) * _e285);
                    let _e288 = (f32(((_e274 >> bitcast<u32>(16i)) & 255u)) * _e285);
                    let _e302 = samples.member[(0u + _e111)].position;
                    let _e305 = p.member.camera.eye;
                    let _e308 = (_e302.x - _e305.x);
                    let _e311 = (_e302.y - _e305.y);
                    let _e314 = (_e302.z - _e305.z);
                    let _e323 = p.member.light_color[3u];
                    let _e327 = (1f - (1f / (1f + (sqrt((((_e308 * _e308) + (_e311 * _e311)) + (_e314 * _e314))) * _e323))));
                    let _e328 = (1f - _e327);
                    phi_502_ = vec3<f32>(((((_e286 * _e286) * (_e118.x + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e227) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * 0.4f)) * _e226) + (vec3<f32>(0.16f, 0.14f, 0.12f).x * _e246)) * 0.42f) * _e272))) * _e328) + (vec3<f32>(0.72f, 0.8f, 0.9f).x * _e327)), ((((_e287 * _e287) * (_e118.y + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e227) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * 0.4f)) * _e226) + (vec3<f32>(0.16f, 0.14f, 0.12f).y * _e246)) * 0.42f) * _e272))) * _e328) + (vec3<f32>(0.72f, 0.8f, 0.9f).y * _e327)), ((((_e288 * _e288) * (_e118.z + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e227) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * 0.4f)) * _e226) + (vec3<f32>(0.16f, 0.14f, 0.12f).z * _e246)) * 0.42f) * _e272))) * _e328) + (vec3<f32>(0.72f, 0.8f, 0.9f).z * _e327)));
                } else {
                    if (_e193 > 0f) {
                        phi_480_ = _e193;
                    } else {
                        phi_480_ = 0f;
                    }
                    let _e344 = phi_480_;
                    let _e348 = (1f - ((1f - _e344) * (1f - _e344)));
                    let _e349 = (1f - _e348);
                    phi_502_ = vec3<f32>(((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e349) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * _e348)), ((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e349) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * _e348)), ((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e349) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * _e348)));
                }
                let _e367 = phi_502_;
                let _e374 = vec3<f32>((_e93.x + _e367.x), _e93.y, _e93.z);
                phi_202_ = (vec3<f32>(_e93.x, _e374.y, vec3<f32>(_e374.x, (_e374.y + _e367.y), _e374.z).z) + _e367);
                phi_205_ = (_e95 + 1u);
            } else {
                phi_202_ = vec3<f32>();
                phi_205_ = u32();
            }
            let _e387 = phi_202_;
            let _e389 = phi_205_;
            continue;
            continuing {
                phi_201_ = _e387;
                phi_204_ = _e389;
                break if !(_e97);
            }
        }
        let _e392 = f32((_e89 * _e91));
        let _e394 = local;
        let _e396 = (_e394.x / _e392);
        let _e398 = local_1;
        let _e400 = (_e398.y / _e392);
        let _e402 = local_2;
        let _e404 = (_e402.z / _e392);
        if (_e396 > 0f) {
            if (_e396 < 1f) {
                phi_531_ = _e396;
            } else {
                phi_531_ = 1f;
            }
            let _e408 = phi_531_;
            phi_532_ = _e408;
        } else {
            phi_532_ = 0f;
        }
        let _e410 = phi_532_;
        let _e413 = sqrt(sqrt(_e410));
        let _e421 = ((((0.6620027f * sqrt(_e410)) + (0.6841221f * _e413)) - (0.3235836f * sqrt(_e413))) - (0.022541147f * _e410));
        if (_e421 > 0f) {
            if (_e421 < 1f) {
                phi_552_ = _e421;
            } else {
                phi_552_ = 1f;
            }
            let _e425 = phi_552_;
            phi_553_ = _e425;
        } else {
            phi_553_ = 0f;
        }
        let _e427 = phi_553_;
        if (_e400 > 0f) {
            if (_e400 < 1f) {
                phi_562_ = _e400;
            } else {
                phi_562_ = 1f;
            }
            let _e431 = phi_562_;
            phi_563_ = _e431;
        } else {
            phi_563_ = 0f;
        }
        let _e433 = phi_563_;
        let _e436 = sqrt(sqrt(_e433));
        let _e444 = ((((0.6620027f * sqrt(_e433)) + (0.6841221f * _e436)) - (0.3235836f * sqrt(_e436))) - (0.022541147f * _e433));
        if (_e444 > 0f) {
            if (_e444 < 1f) {
                phi_583_ = _e444;
            } else {
                phi_583_ = 1f;
            }
            let _e448 = phi_583_;
            phi_584_ = _e448;
        } else {
            phi_584_ = 0f;
        }
        let _e450 = phi_584_;
        if (_e404 > 0f) {
            if (_e404 < 1f) {
                phi_593_ = _e404;
            } else {
                phi_593_ = 1f;
            }
            let _e454 = phi_593_;
            phi_594_ = _e454;
        } else {
            phi_594_ = 0f;
        }
        let _e456 = phi_594_;
        let _e459 = sqrt(sqrt(_e456));
        let _e467 = ((((0.6620027f * sqrt(_e456)) + (0.6841221f * _e459)) - (0.3235836f * sqrt(_e459))) - (0.022541147f * _e456));
        if (_e467 > 0f) {
            if (_e467 < 1f) {
                phi_614_ = _e467;
            } else {
                phi_614_ = 1f;
            }
            let _e471 = phi_614_;
            phi_615_ = _e471;
        } else {
            phi_615_ = 0f;
        }
        let _e473 = phi_615_;
        let _e475 = ((_e427 * 255f) + 0.5f);
        let _e484 = ((_e450 * 255f) + 0.5f);
        let _e496 = ((_e473 * 255f) + 0.5f);
        if (_e79.first_primitive < arrayLength((&picture.member))) {
        } else {
            return;
        }
        picture.member[(0u + _e79.first_primitive)] = (((select(select(u32(_e475), 0u, (_e475 < bitcast<f32>(0u))), 4294967295u, (_e475 > bitcast<f32>(1333788671u))) | (select(select(u32(_e484), 0u, (_e484 < bitcast<f32>(0u))), 4294967295u, (_e484 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e496), 0u, (_e496 < bitcast<f32>(0u))), 4294967295u, (_e496 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_shade_shade_mean_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
