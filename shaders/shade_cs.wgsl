struct type_7 {
    member: array<u32>,
}

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

struct abi_ShadeParams {
    camera: abi_CameraParams,
    light: vec4<f32>,
    light_color: vec4<f32>,
}

struct type_19 {
    member: abi_ShadeParams,
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

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> p: type_19;
@group(0) @binding(1) 
var<storage> samples: type_23;
@group(0) @binding(2) 
var<storage> visibility: type_27;
@group(0) @binding(3) 
var<storage, read_write> picture: type_7;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);

fn lt_shaders_texture_unorm_bytes(param: u32) -> vec4<f32> {
    let _e64 = (1f / 255f);
    return vec4<f32>((f32((param & 255u)) * _e64), (f32(((param >> bitcast<u32>(8i)) & 255u)) * _e64), (f32(((param >> bitcast<u32>(16i)) & 255u)) * _e64), (f32((param >> bitcast<u32>(24i))) * _e64));
}

fn lt_shaders_shade_sky(param_1: vec3<f32>) -> vec3<f32> {
    var phi_564_: f32;

    if (param_1.y > 0f) {
        phi_564_ = param_1.y;
    } else {
        phi_564_ = 0f;
    }
    let _e55 = phi_564_;
    let _e59 = (1f - ((1f - _e55) * (1f - _e55)));
    let _e60 = (1f - _e59);
    return vec3<f32>(((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e60) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * _e59)), ((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e60) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * _e59)), ((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e60) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * _e59)));
}

fn lt_shaders_shade_pack_bytes(param_2: vec3<f32>) -> u32 {
    let _e53 = ((param_2.x * 255f) + 0.5f);
    let _e63 = ((param_2.y * 255f) + 0.5f);
    let _e76 = ((param_2.z * 255f) + 0.5f);
    return ((select(select(u32(_e53), 0u, (_e53 < bitcast<f32>(0u))), 4294967295u, (_e53 > bitcast<f32>(1333788671u))) | (select(select(u32(_e63), 0u, (_e63 < bitcast<f32>(0u))), 4294967295u, (_e63 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e76), 0u, (_e76 < bitcast<f32>(0u))), 4294967295u, (_e76 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i)));
}

fn lt_shaders_shade_sqrt(param_3: f32) -> f32 {
    return sqrt(param_3);
}

fn lt_shaders_shade_unit(param_4: f32) -> f32 {
    var phi_515_: f32;
    var phi_516_: f32;

    if (param_4 > 0f) {
        if (param_4 < 1f) {
            phi_515_ = param_4;
        } else {
            phi_515_ = 1f;
        }
        let _e54 = phi_515_;
        phi_516_ = _e54;
    } else {
        phi_516_ = 0f;
    }
    let _e56 = phi_516_;
    return _e56;
}

fn lt_shaders_shade_srgb(param_5: f32) -> f32 {
    let _e51 = lt_shaders_shade_unit(param_5);
    let _e52 = lt_shaders_shade_sqrt(_e51);
    let _e53 = lt_shaders_shade_sqrt(_e51);
    let _e54 = lt_shaders_shade_sqrt(_e53);
    let _e58 = lt_shaders_shade_sqrt(_e54);
    let _e63 = lt_shaders_shade_unit(((((0.6620027f * _e52) + (0.6841221f * _e54)) - (0.3235836f * _e58)) - (0.022541147f * _e51)));
    return _e63;
}

fn lt_shaders_shade_pack_srgb(param_6: vec3<f32>) -> u32 {
    let _e52 = lt_shaders_shade_srgb(param_6.x);
    let _e54 = lt_shaders_shade_srgb(param_6.y);
    let _e56 = lt_shaders_shade_srgb(param_6.z);
    let _e58 = lt_shaders_shade_pack_bytes(vec3<f32>(_e52, _e54, _e56));
    return (_e58 | 4278190080u);
}

fn lt_shaders_shade_unpack_albedo(param_7: u32) -> vec3<f32> {
    let _e51 = lt_shaders_texture_unorm_bytes(param_7);
    return vec3<f32>((_e51.x * _e51.x), (_e51.y * _e51.y), (_e51.z * _e51.z));
}

fn lt_shaders_entry_pixel_index(param_8: vec3<u32>, param_9: u32, param_10: u32) -> lt_bvh_traverse_Tree {
    var phi_457_: lt_bvh_traverse_Tree;
    var phi_458_: bool;
    var phi_459_: lt_bvh_traverse_Tree;
    var phi_460_: bool;
    var phi_465_: lt_bvh_traverse_Tree;

    if (param_8.x < param_9) {
        if (param_8.y < param_10) {
            phi_457_ = lt_bvh_traverse_Tree(1u, ((param_8.y * param_9) + param_8.x));
            phi_458_ = false;
        } else {
            phi_457_ = lt_bvh_traverse_Tree();
            phi_458_ = true;
        }
        let _e63 = phi_457_;
        let _e65 = phi_458_;
        phi_459_ = _e63;
        phi_460_ = _e65;
    } else {
        phi_459_ = lt_bvh_traverse_Tree();
        phi_460_ = true;
    }
    let _e67 = phi_459_;
    let _e69 = phi_460_;
    if _e69 {
        phi_465_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_465_ = _e67;
    }
    let _e74 = phi_465_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn function_() {
    var phi_259_: bool;
    var phi_260_: bool;
    var phi_261_: bool;
    var phi_262_: bool;
    var phi_266_: bool;
    var phi_320_: f32;
    var phi_431_: u32;

    let _e50 = id_1;
    let _e64 = p.member.camera.size[0u];
    let _e66 = p.member.camera.size[1u];
    let _e67 = lt_shaders_entry_pixel_index(_e50, _e64, _e66);
    if (bitcast<i32>(_e67.root) != 0i) {
        if (_e67.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        if (_e67.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        let _e80 = visibility.member[(0u + _e67.first_primitive)];
        let _e86 = p.member.camera.size[0u];
        let _e90 = ((((f32(_e50.x) + 0.5f) / f32(_e86)) * 2f) - 1f);
        let _e95 = p.member.camera.size[1u];
        let _e99 = (1f - (((f32(_e50.y) + 0.5f) / f32(_e95)) * 2f));
        let _e101 = p.member.camera.forward;
        let _e103 = p.member.camera.right;
        let _e117 = p.member.camera.up;
        let _e124 = ((_e101.x + (_e103.x * _e90)) + (_e117.x * _e99));
        let _e125 = ((_e101.y + (_e103.y * _e90)) + (_e117.y * _e99));
        let _e126 = ((_e101.z + (_e103.z * _e90)) + (_e117.z * _e99));
        let _e133 = (1f / sqrt((((_e124 * _e124) + (_e125 * _e125)) + (_e126 * _e126))));
        let _e134 = (_e124 * _e133);
        let _e135 = (_e125 * _e133);
        let _e136 = (_e126 * _e133);
        let _e140 = samples.member[(0u + _e67.first_primitive)].normal[0u];
        let _e142 = global[0u];
        if (_e140 == _e142) {
            let _e145 = samples.member[(0u + _e67.first_primitive)].normal[1u];
            let _e147 = global[1u];
            if (_e145 == _e147) {
                let _e150 = samples.member[(0u + _e67.first_primitive)].normal[2u];
                let _e152 = global[2u];
                phi_259_ = (_e150 == _e152);
                phi_260_ = false;
            } else {
                phi_259_ = bool();
                phi_260_ = true;
            }
            let _e155 = phi_259_;
            let _e157 = phi_260_;
            phi_261_ = _e155;
            phi_262_ = _e157;
        } else {
            phi_261_ = bool();
            phi_262_ = true;
        }
        let _e159 = phi_261_;
        let _e161 = phi_262_;
        if _e161 {
            phi_266_ = false;
        } else {
            phi_266_ = _e159;
        }
        let _e163 = phi_266_;
        if !(_e163) {
            let _e166 = samples.member[(0u + _e67.first_primitive)].shading_normal;
            let _e168 = p.member.light;
            let _e173 = samples.member[(0u + _e67.first_primitive)].position;
            let _e176 = p.member.light[3u];
            let _e183 = (_e168.x - (_e173.x * _e176));
            let _e184 = (_e168.y - (_e173.y * _e176));
            let _e185 = (_e168.z - (_e173.z * _e176));
            let _e192 = (1f / sqrt((((_e183 * _e183) + (_e184 * _e184)) + (_e185 * _e185))));
            let _e203 = (((_e166.x * (_e183 * _e192)) + (_e166.y * (_e184 * _e192))) + (_e166.z * (_e185 * _e192)));
            let _e205 = p.member.light_color;
            if (_e203 > 0f) {
                phi_320_ = (_e203 * _e80);
            } else {
                phi_320_ = 0f;
            }
            let _e212 = phi_320_;
            let _e218 = (0.5f + (0.5f * _e166.y));
            let _e219 = (1f - 0.4f);
            let _e238 = (1f - _e218);
            let _e264 = (0.8f + (0.2f * abs((((_e166.x * -(_e134)) + (_e166.y * -(_e135))) + (_e166.z * -(_e136))))));
            let _e266 = samples.member[(0u + _e67.first_primitive)].albedo;
            let _e267 = lt_shaders_shade_unpack_albedo(_e266);
            let _e281 = samples.member[(0u + _e67.first_primitive)].position;
            let _e284 = p.member.camera.eye;
            let _e287 = (_e281.x - _e284.x);
            let _e290 = (_e281.y - _e284.y);
            let _e293 = (_e281.z - _e284.z);
            let _e302 = p.member.light_color[3u];
            let _e306 = (1f - (1f / (1f + (sqrt((((_e287 * _e287) + (_e290 * _e290)) + (_e293 * _e293))) * _e302))));
            let _e307 = (1f - _e306);
            let _e321 = lt_shaders_shade_pack_srgb(vec3<f32>((((_e267.x * ((_e205.x * _e212) + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e219) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * 0.4f)) * _e218) + (vec3<f32>(0.16f, 0.14f, 0.12f).x * _e238)) * 0.42f) * _e264))) * _e307) + (vec3<f32>(0.72f, 0.8f, 0.9f).x * _e306)), (((_e267.y * ((_e205.y * _e212) + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e219) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * 0.4f)) * _e218) + (vec3<f32>(0.16f, 0.14f, 0.12f).y * _e238)) * 0.42f) * _e264))) * _e307) + (vec3<f32>(0.72f, 0.8f, 0.9f).y * _e306)), (((_e267.z * ((_e205.z * _e212) + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e219) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * 0.4f)) * _e218) + (vec3<f32>(0.16f, 0.14f, 0.12f).z * _e238)) * 0.42f) * _e264))) * _e307) + (vec3<f32>(0.72f, 0.8f, 0.9f).z * _e306))));
            phi_431_ = _e321;
        } else {
            let _e322 = lt_shaders_shade_sky(vec3<f32>(_e134, _e135, _e136));
            let _e323 = lt_shaders_shade_pack_srgb(_e322);
            phi_431_ = _e323;
        }
        let _e325 = phi_431_;
        if (_e67.first_primitive < arrayLength((&picture.member))) {
        } else {
            return;
        }
        picture.member[(0u + _e67.first_primitive)] = _e325;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_shade_shade_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
