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

struct type_17 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_35 {
    member: array<vec4<f32>>,
}

struct abi_ShadeParams {
    camera: abi_CameraParams,
    light: vec4<f32>,
    light_color: vec4<f32>,
}

struct type_39 {
    member: abi_ShadeParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_39;
@group(0) @binding(2) 
var<storage> visibility: type_17;
@group(0) @binding(3) 
var<storage, read_write> picture: type_13;
@group(0) @binding(4) 
var<storage> tints: type_35;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_135_: lt_bvh_traverse_Tree;
    var phi_136_: bool;
    var phi_137_: lt_bvh_traverse_Tree;
    var phi_138_: bool;
    var phi_143_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_135_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_136_ = false;
        } else {
            phi_135_ = lt_bvh_traverse_Tree();
            phi_136_ = true;
        }
        let _e63 = phi_135_;
        let _e65 = phi_136_;
        phi_137_ = _e63;
        phi_138_ = _e65;
    } else {
        phi_137_ = lt_bvh_traverse_Tree();
        phi_138_ = true;
    }
    let _e67 = phi_137_;
    let _e69 = phi_138_;
    if _e69 {
        phi_143_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_143_ = _e67;
    }
    let _e74 = phi_143_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn function_() {
    var phi_277_: bool;
    var phi_278_: bool;
    var phi_279_: bool;
    var phi_280_: bool;
    var phi_284_: bool;
    var phi_344_: vec3<f32>;
    var phi_470_: f32;
    var phi_471_: f32;
    var phi_491_: f32;
    var phi_492_: f32;
    var phi_501_: f32;
    var phi_502_: f32;
    var phi_522_: f32;
    var phi_523_: f32;
    var phi_532_: f32;
    var phi_533_: f32;
    var phi_553_: f32;
    var phi_554_: f32;
    var phi_591_: f32;
    var phi_620_: f32;
    var phi_621_: f32;
    var phi_641_: f32;
    var phi_642_: f32;
    var phi_651_: f32;
    var phi_652_: f32;
    var phi_672_: f32;
    var phi_673_: f32;
    var phi_682_: f32;
    var phi_683_: f32;
    var phi_703_: f32;
    var phi_704_: f32;
    var phi_737_: u32;

    let _e50 = id_1;
    let _e67 = p.member.camera.size[0u];
    let _e69 = p.member.camera.size[1u];
    let _e70 = lt_shaders_entry_pixel_index(_e50, _e67, _e69);
    if (bitcast<i32>(_e70.root) != 0i) {
        if (_e70.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        if (_e70.first_primitive < arrayLength((&tints.member))) {
        } else {
            return;
        }
        let _e83 = tints.member[(0u + _e70.first_primitive)];
        if (_e70.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        let _e90 = visibility.member[(0u + _e70.first_primitive)];
        let _e99 = p.member.camera.size[0u];
        let _e103 = ((((f32(_e50.x) + 0.5f) / f32(_e99)) * 2f) - 1f);
        let _e108 = p.member.camera.size[1u];
        let _e112 = (1f - (((f32(_e50.y) + 0.5f) / f32(_e108)) * 2f));
        let _e114 = p.member.camera.forward;
        let _e116 = p.member.camera.right;
        let _e130 = p.member.camera.up;
        let _e137 = ((_e114.x + (_e116.x * _e103)) + (_e130.x * _e112));
        let _e138 = ((_e114.y + (_e116.y * _e103)) + (_e130.y * _e112));
        let _e139 = ((_e114.z + (_e116.z * _e103)) + (_e130.z * _e112));
        let _e146 = (1f / sqrt((((_e137 * _e137) + (_e138 * _e138)) + (_e139 * _e139))));
        let _e148 = (_e138 * _e146);
        let _e152 = samples.member[(0u + _e70.first_primitive)].normal[0u];
        let _e154 = global[0u];
        if (_e152 == _e154) {
            let _e157 = samples.member[(0u + _e70.first_primitive)].normal[1u];
            let _e159 = global[1u];
            if (_e157 == _e159) {
                let _e162 = samples.member[(0u + _e70.first_primitive)].normal[2u];
                let _e164 = global[2u];
                phi_277_ = (_e162 == _e164);
                phi_278_ = false;
            } else {
                phi_277_ = bool();
                phi_278_ = true;
            }
            let _e167 = phi_277_;
            let _e169 = phi_278_;
            phi_279_ = _e167;
            phi_280_ = _e169;
        } else {
            phi_279_ = bool();
            phi_280_ = true;
        }
        let _e171 = phi_279_;
        let _e173 = phi_280_;
        if _e173 {
            phi_284_ = false;
        } else {
            phi_284_ = _e171;
        }
        let _e175 = phi_284_;
        if !(_e175) {
            let _e178 = samples.member[(0u + _e70.first_primitive)].shading_normal;
            let _e180 = p.member.light;
            let _e185 = samples.member[(0u + _e70.first_primitive)].position;
            let _e188 = p.member.light[3u];
            let _e195 = (_e180.x - (_e185.x * _e188));
            let _e196 = (_e180.y - (_e185.y * _e188));
            let _e197 = (_e180.z - (_e185.z * _e188));
            let _e204 = (1f / sqrt((((_e195 * _e195) + (_e196 * _e196)) + (_e197 * _e197))));
            let _e215 = (((_e178.x * (_e195 * _e204)) + (_e178.y * (_e196 * _e204))) + (_e178.z * (_e197 * _e204)));
            if (_e215 > 0f) {
                let _e218 = p.member.light_color;
                phi_344_ = vec3<f32>((_e218.x * ((_e83.x * _e90) * _e215)), (_e218.y * ((_e83.y * _e90) * _e215)), (_e218.z * ((_e83.z * _e90) * _e215)));
            } else {
                phi_344_ = vec3<f32>(0f, 0f, 0f);
            }
            let _e230 = phi_344_;
            let _e233 = (0.5f + (0.5f * _e178.y));
            let _e234 = (1f - 0.4f);
            let _e253 = (1f - _e233);
            let _e279 = (0.8f + (0.2f * abs((((_e178.x * -((_e137 * _e146))) + (_e178.y * -(_e148))) + (_e178.z * -((_e139 * _e146)))))));
            let _e281 = samples.member[(0u + _e70.first_primitive)].albedo;
            let _e292 = (1f / 255f);
            let _e293 = (f32((_e281 & 255u)) * _e292);
            let _e294 = (f32(((_e281 >> bitcast<u32>(8i)) & 255u)) * _e292);
            let _e295 = (f32(((_e281 >> bitcast<u32>(16i)) & 255u)) * _e292);
            let _e312 = samples.member[(0u + _e70.first_primitive)].position;
            let _e315 = p.member.camera.eye;
            let _e318 = (_e312.x - _e315.x);
            let _e321 = (_e312.y - _e315.y);
            let _e324 = (_e312.z - _e315.z);
            let _e333 = p.member.light_color[3u];
            let _e337 = (1f - (1f / (1f + (sqrt((((_e318 * _e318) + (_e321 * _e321)) + (_e324 * _e324))) * _e333))));
            let _e338 = (1f - _e337);
            let _e348 = ((((_e293 * _e293) * (_e230.x + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e234) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * 0.4f)) * _e233) + (vec3<f32>(0.16f, 0.14f, 0.12f).x * _e253)) * 0.42f) * _e279))) * _e338) + (vec3<f32>(0.72f, 0.8f, 0.9f).x * _e337));
            let _e349 = ((((_e294 * _e294) * (_e230.y + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e234) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * 0.4f)) * _e233) + (vec3<f32>(0.16f, 0.14f, 0.12f).y * _e253)) * 0.42f) * _e279))) * _e338) + (vec3<f32>(0.72f, 0.8f, 0.9f).y * _e337));
            let _e350 = ((((_e295 * _e295) * (_e230.z + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e234) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * 0.4f)) * _e233) + (vec3<f32>(0.16f, 0.14f, 0.12f).z * _e253)) * 0.42f) * _e279))) * _e338) + (vec3<f32>(0.72f, 0.8f, 0.9f).z * _e337));
            if (_e348 > 0f) {
                if (_e348 < 1f) {
                    phi_470_ = _e348;
                } else {
                    phi_470_ = 1f;
                }
                let _e354 = phi_470_;
                phi_471_ = _e354;
            } else {
                phi_471_ = 0f;
            }
            let _e356 = phi_471_;
            let _e359 = sqrt(sqrt(_e356));
            let _e367 = ((((0.6620027f * sqrt(_e356)) + (0.6841221f * _e359)) - (0.3235836f * sqrt(_e359))) - (0.022541147f * _e356));
            if (_e367 > 0f) {
                if (_e367 < 1f) {
                    phi_491_ = _e367;
                } else {
                    phi_491_ = 1f;
                }
                let _e371 = phi_491_;
                phi_492_ = _e371;
            } else {
                phi_492_ = 0f;
            }
            let _e373 = phi_492_;
            if (_e349 > 0f) {
                if (_e349 < 1f) {
                    phi_501_ = _e349;
                } else {
                    phi_501_ = 1f;
                }
                let _e377 = phi_501_;
                phi_502_ = _e377;
            } else {
                phi_502_ = 0f;
            }
            let _e379 = phi_502_;
            let _e382 = sqrt(sqrt(_e379));
            let _e390 = ((((0.6620027f * sqrt(_e379)) + (0.6841221f * _e382)) - (0.3235836f * sqrt(_e382))) - (0.022541147f * _e379));
            if (_e390 > 0f) {
                if (_e390 < 1f) {
                    phi_522_ = _e390;
                } else {
                    phi_522_ = 1f;
                }
                let _e394 = phi_522_;
                phi_523_ = _e394;
            } else {
                phi_523_ = 0f;
            }
            let _e396 = phi_523_;
            if (_e350 > 0f) {
                if (_e350 < 1f) {
                    phi_532_ = _e350;
                } else {
                    phi_532_ = 1f;
                }
                let _e400 = phi_532_;
                phi_533_ = _e400;
            } else {
                phi_533_ = 0f;
            }
            let _e402 = phi_533_;
            let _e405 = sqrt(sqrt(_e402));
            let _e413 = ((((0.6620027f * sqrt(_e402)) + (0.6841221f * _e405)) - (0.3235836f * sqrt(_e405))) - (0.022541147f * _e402));
            if (_e413 > 0f) {
                if (_e413 < 1f) {
                    phi_553_ = _e413;
                } else {
                    phi_553_ = 1f;
                }
                let _e417 = phi_553_;
                phi_554_ = _e417;
            } else {
                phi_554_ = 0f;
            }
            let _e419 = phi_554_;
            let _e421 = ((_e373 * 255f) + 0.5f);
            let _e430 = ((_e396 * 255f) + 0.5f);
            let _e442 = ((_e419 * 255f) + 0.5f);
            phi_737_ = (((select(select(u32(_e421), 0u, (_e421 < bitcast<f32>(0u))), 4294967295u, (_e421 > bitcast<f32>(1333788671u))) | (select(select(u32(_e430), 0u, (_e430 < bitcast<f32>(0u))), 4294967295u, (_e430 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e442), 0u, (_e442 < bitcast<f32>(0u))), 4294967295u, (_e442 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
        } else {
            if (_e148 > 0f) {
                phi_591_ = _e148;
            } else {
                phi_591_ = 0f;
            }
            let _e456 = phi_591_;
            let _e460 = (1f - ((1f - _e456) * (1f - _e456)));
            let _e461 = (1f - _e460);
            let _e474 = ((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e461) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * _e460));
            let _e475 = ((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e461) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * _e460));
            let _e476 = ((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e461) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * _e460));
            if (_e474 > 0f) {
                if (_e474 < 1f) {
                    phi_620_ = _e474;
                } else {
                    phi_620_ = 1f;
                }
                let _e480 = phi_620_;
                phi_621_ = _e480;
            } else {
                phi_621_ = 0f;
            }
            let _e482 = phi_621_;
            let _e485 = sqrt(sqrt(_e482));
            let _e493 = ((((0.6620027f * sqrt(_e482)) + (0.6841221f * _e485)) - (0.3235836f * sqrt(_e485))) - (0.022541147f * _e482));
            if (_e493 > 0f) {
                if (_e493 < 1f) {
                    phi_641_ = _e493;
                } else {
                    phi_641_ = 1f;
                }
                let _e497 = phi_641_;
                phi_642_ = _e497;
            } else {
                phi_642_ = 0f;
            }
            let _e499 = phi_642_;
            if (_e475 > 0f) {
                if (_e475 < 1f) {
                    phi_651_ = _e475;
                } else {
                    phi_651_ = 1f;
                }
                let _e503 = phi_651_;
                phi_652_ = _e503;
            } else {
                phi_652_ = 0f;
            }
            let _e505 = phi_652_;
            let _e508 = sqrt(sqrt(_e505));
            let _e516 = ((((0.6620027f * sqrt(_e505)) + (0.6841221f * _e508)) - (0.3235836f * sqrt(_e508))) - (0.022541147f * _e505));
            if (_e516 > 0f) {
                if (_e516 < 1f) {
                    phi_672_ = _e516;
                } else {
                    phi_672_ = 1f;
                }
                let _e520 = phi_672_;
                phi_673_ = _e520;
            } else {
                phi_673_ = 0f;
            }
            let _e522 = phi_673_;
            if (_e476 > 0f) {
                if (_e476 < 1f) {
                    phi_682_ = _e476;
                } else {
                    phi_682_ = 1f;
                }
                let _e526 = phi_682_;
                phi_683_ = _e526;
            } else {
                phi_683_ = 0f;
            }
            let _e528 = phi_683_;
            let _e531 = sqrt(sqrt(_e528));
            let _e539 = ((((0.6620027f * sqrt(_e528)) + (0.6841221f * _e531)) - (0.3235836f * sqrt(_e531))) - (0.022541147f * _e528));
            if (_e539 > 0f) {
                if (_e539 < 1f) {
                    phi_703_ = _e539;
                } else {
                    phi_703_ = 1f;
                }
                let _e543 = phi_703_;
                phi_704_ = _e543;
            } else {
                phi_704_ = 0f;
            }
            let _e545 = phi_704_;
            let _e547 = ((_e499 * 255f) + 0.5f);
            let _e556 = ((_e522 * 255f) + 0.5f);
            let _e568 = ((_e545 * 255f) + 0.5f);
            phi_737_ = (((select(select(u32(_e547), 0u, (_e547 < bitcast<f32>(0u))), 4294967295u, (_e547 > bitcast<f32>(1333788671u))) | (select(select(u32(_e556), 0u, (_e556 < bitcast<f32>(0u))), 4294967295u, (_e556 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e568), 0u, (_e568 < bitcast<f32>(0u))), 4294967295u, (_e568 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
        }
        let _e581 = phi_737_;
        if (_e70.first_primitive < arrayLength((&picture.member))) {
        } else {
            return;
        }
        picture.member[(0u + _e70.first_primitive)] = _e581;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_shade_shade_tinted_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
