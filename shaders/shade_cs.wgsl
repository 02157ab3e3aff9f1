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
    var phi_133_: lt_bvh_traverse_Tree;
    var phi_134_: bool;
    var phi_135_: lt_bvh_traverse_Tree;
    var phi_136_: bool;
    var phi_141_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_133_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_134_ = false;
        } else {
            phi_133_ = lt_bvh_traverse_Tree();
            phi_134_ = true;
        }
        let _e63 = phi_133_;
        let _e65 = phi_134_;
        phi_135_ = _e63;
        phi_136_ = _e65;
    } else {
        phi_135_ = lt_bvh_traverse_Tree();
        phi_136_ = true;
    }
    let _e67 = phi_135_;
    let _e69 = phi_136_;
    if _e69 {
        phi_141_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_141_ = _e67;
    }
    let _e74 = phi_141_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn function_() {
    var phi_280_: bool;
    var phi_281_: bool;
    var phi_282_: bool;
    var phi_283_: bool;
    var phi_287_: bool;
    var phi_413_: f32;
    var phi_435_: vec3<f32>;
    var phi_445_: f32;
    var phi_446_: f32;
    var phi_466_: f32;
    var phi_467_: f32;
    var phi_477_: f32;
    var phi_478_: f32;
    var phi_498_: f32;
    var phi_499_: f32;
    var phi_509_: f32;
    var phi_510_: f32;
    var phi_530_: f32;
    var phi_531_: f32;

    let _e50 = id_1;
    let _e64 = p.member.camera.size[0u];
    let _e66 = p.member.camera.size[1u];
    let _e67 = lt_shaders_entry_pixel_index(_e50, _e64, _e66);
    if (bitcast<i32>(_e67.root) != 0i) {
        if (_e67.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        if (_e67.first_primitive < arrayLength((&light.member))) {
        } else {
            return;
        }
        let _e80 = light.member[(0u + _e67.first_primitive)];
        let _e87 = p.member.camera.grid[0u];
        let _e89 = p.member.camera.grid[1u];
        let _e108 = p.member.camera.size[0u];
        let _e112 = ((((f32(_e50.x) + ((f32((_e50.y & (_e89 - 1u))) + 0.5f) / f32(_e89))) / f32(_e108)) * 2f) - 1f);
        let _e115 = p.member.camera.size[1u];
        let _e119 = (1f - (((f32(_e50.y) + ((f32((_e50.x & (_e87 - 1u))) + 0.5f) / f32(_e87))) / f32(_e115)) * 2f));
        let _e121 = p.member.camera.forward;
        let _e123 = p.member.camera.right;
        let _e137 = p.member.camera.up;
        let _e144 = ((_e121.x + (_e123.x * _e112)) + (_e137.x * _e119));
        let _e145 = ((_e121.y + (_e123.y * _e112)) + (_e137.y * _e119));
        let _e146 = ((_e121.z + (_e123.z * _e112)) + (_e137.z * _e119));
        let _e153 = (1f / sqrt((((_e144 * _e144) + (_e145 * _e145)) + (_e146 * _e146))));
        let _e155 = (_e145 * _e153);
        let _e159 = samples.member[(0u + _e67.first_primitive)].normal[0u];
        let _e161 = global[0u];
        if (_e159 == _e161) {
            let _e164 = samples.member[(0u + _e67.first_primitive)].normal[1u];
            let _e166 = global[1u];
            if (_e164 == _e166) {
                let _e169 = samples.member[(0u + _e67.first_primitive)].normal[2u];
                let _e171 = global[2u];
                phi_280_ = (_e169 == _e171);
                phi_281_ = false;
            } else {
                phi_280_ = bool();
                phi_281_ = true;
            }
            let _e174 = phi_280_;
            let _e176 = phi_281_;
            phi_282_ = _e174;
            phi_283_ = _e176;
        } else {
            phi_282_ = bool();
            phi_283_ = true;
        }
        let _e178 = phi_282_;
        let _e180 = phi_283_;
        if _e180 {
            phi_287_ = false;
        } else {
            phi_287_ = _e178;
        }
        let _e182 = phi_287_;
        if !(_e182) {
            let _e185 = samples.member[(0u + _e67.first_primitive)].shading_normal;
            let _e188 = (0.5f + (0.5f * _e185.y));
            let _e189 = (1f - 0.4f);
            let _e208 = (1f - _e188);
            let _e234 = (0.8f + (0.2f * abs((((_e185.x * -((_e144 * _e153))) + (_e185.y * -(_e155))) + (_e185.z * -((_e146 * _e153)))))));
            let _e236 = samples.member[(0u + _e67.first_primitive)].albedo;
            let _e247 = (1f / 255f);
            let _e248 = (f32((_e236 & 255u)) * _e247);
            let _e249 = (f32(((_e236 >> bitcast<u32>(8i)) & 255u)) * _e247);
            let _e250 = (f32(((_e236 >> bitcast<u32>(16i)) & 255u)) * _e247);
            let _e264 = samples.member[(0u + _e67.first_primitive)].position;
            let _e267 = p.member.camera.eye;
            let _e270 = (_e264.x - _e267.x);
            let _e273 = (_e264.y - _e267.y);
            let _e276 = (_e264.z - _e267.z);
            let _e285 = p.member.light_color[3u];
            let _e289 = (1f - (1f / (1f + (sqrt((((_e270 * _e270) + (_e273 * _e273)) + (_e276 * _e276))) * _e285))));
            let _e290 = (1f - _e289);
            phi_435_ = vec3<f32>(((((_e248 * _e248) * (_e80.x + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e189) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * 0.4f)) * _e188) + (vec3<f32>(0.16f, 0.14f, 0.12f).x * _e208)) * 0.42f) * _e234))) * _e290) + (vec3<f32>(0.72f, 0.8f, 0.9f).x * _e289)), ((((_e249 * _e249) * (_e80.y + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e189) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * 0.4f)) * _e188) + (vec3<f32>(0.16f, 0.14f, 0.12f).y * _e208)) * 0.42f) * _e234))) * _e290) + (vec3<f32>(0.72f, 0.8f, 0.9f).y * _e289)), ((((_e250 * _e250) * (_e80.z + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e189) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * 0.4f)) * _e188) + (vec3<f32>(0.16f, 0.14f, 0.12f).z * _e208)) * 0.42f) * _e234))) * _e290) + (vec3<f32>(0.72f, 0.8f, 0.9f).z * _e289)));
        } else {
            if (_e155 > 0f) {
                phi_413_ = _e155;
            } else {
                phi_413_ = 0f;
            }
            let _e306 = phi_413_;
            let _e310 = (1f - ((1f - _e306) * (1f - _e306)));
            let _e311 = (1f - _e310);
            phi_435_ = vec3<f32>(((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e311) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * _e310)), ((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e311) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * _e310)), ((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e311) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * _e310)));
        }
        let _e329 = phi_435_;
        if (_e329.x > 0f) {
            if (_e329.x < 1f) {
                phi_445_ = _e329.x;
            } else {
                phi_445_ = 1f;
            }
            let _e334 = phi_445_;
            phi_446_ = _e334;
        } else {
            phi_446_ = 0f;
        }
        let _e336 = phi_446_;
        let _e339 = sqrt(sqrt(_e336));
        let _e347 = ((((0.6620027f * sqrt(_e336)) + (0.6841221f * _e339)) - (0.3235836f * sqrt(_e339))) - (0.022541147f * _e336));
        if (_e347 > 0f) {
            if (_e347 < 1f) {
                phi_466_ = _e347;
            } else {
                phi_466_ = 1f;
            }
            let _e351 = phi_466_;
            phi_467_ = _e351;
        } else {
            phi_467_ = 0f;
        }
        let _e353 = phi_467_;
        if (_e329.y > 0f) {
            if (_e329.y < 1f) {
                phi_477_ = _e329.y;
            } else {
                phi_477_ = 1f;
            }
            let _e358 = phi_477_;
            phi_478_ = _e358;
        } else {
            phi_478_ = 0f;
        }
        let _e360 = phi_478_;
        let _e363 = sqrt(sqrt(_e360));
        let _e371 = ((((0.6620027f * sqrt(_e360)) + (0.6841221f * _e363)) - (0.3235836f * sqrt(_e363))) - (0.022541147f * _e360));
        if (_e371 > 0f) {
            if (_e371 < 1f) {
                phi_498_ = _e371;
            } else {
                phi_498_ = 1f;
            }
            let _e375 = phi_498_;
            phi_499_ = _e375;
        } else {
            phi_499_ = 0f;
        }
        let _e377 = phi_499_;
        if (_e329.z > 0f) {
            if (_e329.z < 1f) {
                phi_509_ = _e329.z;
            } else {
                phi_509_ = 1f;
            }
            let _e382 = phi_509_;
            phi_510_ = _e382;
        } else {
            phi_510_ = 0f;
        }
        let _e384 = phi_510_;
        let _e387 = sqrt(sqrt(_e384));
        let _e395 = ((((0.6620027f * sqrt(_e384)) + (0.6841221f * _e387)) - (0.3235836f * sqrt(_e387))) - (0.022541147f * _e384));
        if (_e395 > 0f) {
            if (_e395 < 1f) {
                phi_530_ = _e395;
            } else {
                phi_530_ = 1f;
            }
            let _e399 = phi_530_;
            phi_531_ = _e399;
        } else {
            phi_531_ = 0f;
        }
        let _e401 = phi_531_;
        let _e403 = ((_e353 * 255f) + 0.5f);
        let _e412 = ((_e377 * 255f) + 0.5f);
        let _e424 = ((_e401 * 255f) + 0.5f);
        if (_e67.first_primitive < arrayLength((&picture.member))) {
        } else {
            return;
        }
        picture.member[(0u + _e67.first_primitive)] = (((select(select(u32(_e403), 0u, (_e403 < bitcast<f32>(0u))), 4294967295u, (_e403 > bitcast<f32>(1333788671u))) | (select(select(u32(_e412), 0u, (_e412 < bitcast<f32>(0u))), 4294967295u, (_e412 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e424), 0u, (_e424 < bitcast<f32>(0u))), 4294967295u, (_e424 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_shade_shade_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
