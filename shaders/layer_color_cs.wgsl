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

struct type_14 {
    member: array<abi_Sample>,
}

struct type_27 {
    member: array<vec4<f32>>,
}

struct abi_ShadeParams {
    camera: abi_CameraParams,
    light: abi_LightParams,
    light_color: vec4<f32>,
}

struct type_31 {
    member: abi_ShadeParams,
}

struct abi_Sight {
    kept: vec3<f32>,
    t: f32,
}

struct type_35 {
    member: array<abi_Sight>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_14;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> light: type_27;
@group(0) @binding(3) 
var<storage> sights: type_35;
@group(0) @binding(4) 
var<storage, read_write> colors: type_27;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_132_: lt_bvh_traverse_Tree;
    var phi_133_: bool;
    var phi_134_: lt_bvh_traverse_Tree;
    var phi_135_: bool;
    var phi_140_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_132_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_133_ = false;
        } else {
            phi_132_ = lt_bvh_traverse_Tree();
            phi_133_ = true;
        }
        let _e60 = phi_132_;
        let _e62 = phi_133_;
        phi_134_ = _e60;
        phi_135_ = _e62;
    } else {
        phi_134_ = lt_bvh_traverse_Tree();
        phi_135_ = true;
    }
    let _e64 = phi_134_;
    let _e66 = phi_135_;
    if _e66 {
        phi_140_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_140_ = _e64;
    }
    let _e71 = phi_140_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn function_() {
    var phi_220_: bool;
    var phi_221_: bool;
    var phi_222_: bool;
    var phi_223_: bool;
    var phi_227_: bool;
    var phi_237_: f32;
    var phi_344_: bool;
    var phi_345_: bool;
    var phi_346_: bool;
    var phi_347_: bool;
    var phi_351_: bool;
    var phi_477_: f32;
    var phi_499_: vec3<f32>;

    let _e47 = id_1;
    let _e64 = p.member.camera.size[0u];
    let _e66 = p.member.camera.size[1u];
    let _e67 = lt_shaders_entry_pixel_index(_e47, _e64, _e66);
    if (bitcast<i32>(_e67.root) != 0i) {
        if (_e67.first_primitive < arrayLength((&colors.member))) {
        } else {
            return;
        }
        if (_e67.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        if (_e67.first_primitive < arrayLength((&sights.member))) {
        } else {
            return;
        }
        if (_e67.first_primitive < arrayLength((&light.member))) {
        } else {
            return;
        }
        let _e86 = light.member[(0u + _e67.first_primitive)];
        let _e92 = samples.member[(0u + _e67.first_primitive)].normal[0u];
        let _e94 = global[0u];
        if (_e92 == _e94) {
            let _e97 = samples.member[(0u + _e67.first_primitive)].normal[1u];
            let _e99 = global[1u];
            if (_e97 == _e99) {
                let _e102 = samples.member[(0u + _e67.first_primitive)].normal[2u];
                let _e104 = global[2u];
                phi_220_ = (_e102 == _e104);
                phi_221_ = false;
            } else {
                phi_220_ = bool();
                phi_221_ = true;
            }
            let _e107 = phi_220_;
            let _e109 = phi_221_;
            phi_222_ = _e107;
            phi_223_ = _e109;
        } else {
            phi_222_ = bool();
            phi_223_ = true;
        }
        let _e111 = phi_222_;
        let _e113 = phi_223_;
        if _e113 {
            phi_227_ = false;
        } else {
            phi_227_ = _e111;
        }
        let _e115 = phi_227_;
        if !(_e115) {
            let _e118 = samples.member[(0u + _e67.first_primitive)].flags;
            phi_237_ = (f32((_e118 >> bitcast<u32>(16u))) / 65535f);
        } else {
            phi_237_ = 1f;
        }
        let _e124 = phi_237_;
        let _e126 = sights.member[(0u + _e67.first_primitive)].kept;
        let _e139 = p.member.camera.grid[0u];
        let _e141 = p.member.camera.grid[1u];
        let _e160 = p.member.camera.size[0u];
        let _e164 = ((((f32(_e47.x) + ((f32((_e47.y & (_e141 - 1u))) + 0.5f) / f32(_e141))) / f32(_e160)) * 2f) - 1f);
        let _e167 = p.member.camera.size[1u];
        let _e171 = (1f - (((f32(_e47.y) + ((f32((_e47.x & (_e139 - 1u))) + 0.5f) / f32(_e139))) / f32(_e167)) * 2f));
        let _e173 = p.member.camera.forward;
        let _e175 = p.member.camera.right;
        let _e189 = p.member.camera.up;
        let _e196 = ((_e173.x + (_e175.x * _e164)) + (_e189.x * _e171));
        let _e197 = ((_e173.y + (_e175.y * _e164)) + (_e189.y * _e171));
        let _e198 = ((_e173.z + (_e175.z * _e164)) + (_e189.z * _e171));
        let _e205 = (1f / sqrt((((_e196 * _e196) + (_e197 * _e197)) + (_e198 * _e198))));
        let _e207 = (_e197 * _e205);
        let _e211 = samples.member[(0u + _e67.first_primitive)].normal[0u];
        let _e213 = global[0u];
        if (_e211 == _e213) {
            let _e216 = samples.member[(0u + _e67.first_primitive)].normal[1u];
            let _e218 = global[1u];
            if (_e216 == _e218) {
                let _e221 = samples.member[(0u + _e67.first_primitive)].normal[2u];
                let _e223 = global[2u];
                phi_344_ = (_e221 == _e223);
                phi_345_ = false;
            } else {
                phi_344_ = bool();
                phi_345_ = true;
            }
            let _e226 = phi_344_;
            let _e228 = phi_345_;
            phi_346_ = _e226;
            phi_347_ = _e228;
        } else {
            phi_346_ = bool();
            phi_347_ = true;
        }
        let _e230 = phi_346_;
        let _e232 = phi_347_;
        if _e232 {
            phi_351_ = false;
        } else {
            phi_351_ = _e230;
        }
        let _e234 = phi_351_;
        if !(_e234) {
            let _e237 = samples.member[(0u + _e67.first_primitive)].shading_normal;
            let _e240 = (0.5f + (0.5f * _e237.y));
            let _e241 = (1f - 0.4f);
            let _e260 = (1f - _e240);
            let _e286 = (0.8f + (0.2f * abs((((_e237.x * -((_e196 * _e205))) + (_e237.y * -(_e207))) + (_e237.z * -((_e198 * _e205)))))));
            let _e288 = samples.member[(0u + _e67.first_primitive)].albedo;
            let _e299 = (1f / 255f);
            let _e300 = (f32((_e288 & 255u)) * _e299);
            let _e301 = (f32(((_e288 >> bitcast<u32>(8i)) & 255u)) * _e299);
            let _e302 = (f32(((_e288 >> bitcast<u32>(16i)) & 255u)) * _e299);
            let _e316 = samples.member[(0u + _e67.first_primitive)].position;
            let _e319 = p.member.camera.eye;
            let _e322 = (_e316.x - _e319.x);
            let _e325 = (_e316.y - _e319.y);
            let _e328 = (_e316.z - _e319.z);
            let _e337 = p.member.light_color[3u];
            let _e341 = (1f - (1f / (1f + (sqrt((((_e322 * _e322) + (_e325 * _e325)) + (_e328 * _e328))) * _e337))));
            let _e342 = (1f - _e341);
            phi_499_ = vec3<f32>(((((_e300 * _e300) * (_e86.x + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e241) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * 0.4f)) * _e240) + (vec3<f32>(0.16f, 0.14f, 0.12f).x * _e260)) * 0.42f) * _e286))) * _e342) + (vec3<f32>(0.72f, 0.8f, 0.9f).x * _e341)), ((((_e301 * _e301) * (_e86.y + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e241) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * 0.4f)) * _e240) + (vec3<f32>(0.16f, 0.14f, 0.12f).y * _e260)) * 0.42f) * _e286))) * _e342) + (vec3<f32>(0.72f, 0.8f, 0.9f).y * _e341)), ((((_e302 * _e302) * (_e86.z + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e241) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * 0.4f)) * _e240) + (vec3<f32>(0.16f, 0.14f, 0.12f).z * _e260)) * 0.42f) * _e286))) * _e342) + (vec3<f32>(0.72f, 0.8f, 0.9f).z * _e341)));
        } else {
            if (_e207 > 0f) {
                phi_477_ = _e207;
            } else {
                phi_477_ = 0f;
            }
            let _e358 = phi_477_;
            let _e362 = (1f - ((1f - _e358) * (1f - _e358)));
            let _e363 = (1f - _e362);
            phi_499_ = vec3<f32>(((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e363) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * _e362)), ((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e363) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * _e362)), ((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e363) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * _e362)));
        }
        let _e381 = phi_499_;
        let _e392 = colors.member[(0u + _e67.first_primitive)][0u];
        colors.member[(0u + _e67.first_primitive)][0u] = (_e392 + ((vec3<f32>(1f, 1f, 1f).x - _e126.x) * (_e381.x * _e124)));
        let _e395 = colors.member[(0u + _e67.first_primitive)][1u];
        colors.member[(0u + _e67.first_primitive)][1u] = (_e395 + ((vec3<f32>(1f, 1f, 1f).y - _e126.y) * (_e381.y * _e124)));
        let _e398 = colors.member[(0u + _e67.first_primitive)][2u];
        colors.member[(0u + _e67.first_primitive)][2u] = (_e398 + ((vec3<f32>(1f, 1f, 1f).z - _e126.z) * (_e381.z * _e124)));
        let _e401 = colors.member[(0u + _e67.first_primitive)][3u];
        colors.member[(0u + _e67.first_primitive)][3u] = (_e401 + 0f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_shade_layer_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
