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

struct type_13 {
    member: array<abi_Sample>,
}

struct type_21 {
    member: array<vec4<f32>>,
}

struct type_24 {
    member: abi_CameraParams,
}

var<private> id_1: vec3<u32>;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_24;
@group(0) @binding(1) 
var positions: texture_2d<f32>;
@group(0) @binding(2) 
var normals: texture_2d<f32>;
@group(0) @binding(4) 
var<storage, read_write> samples: type_13;
@group(0) @binding(5) 
var<storage, read_write> past: type_21;
@group(0) @binding(3) 
var last_positions: texture_2d<f32>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_91_: lt_bvh_traverse_Tree;
    var phi_92_: bool;
    var phi_93_: lt_bvh_traverse_Tree;
    var phi_94_: bool;
    var phi_99_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_91_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_92_ = false;
        } else {
            phi_91_ = lt_bvh_traverse_Tree();
            phi_92_ = true;
        }
        let _e35 = phi_91_;
        let _e37 = phi_92_;
        phi_93_ = _e35;
        phi_94_ = _e37;
    } else {
        phi_93_ = lt_bvh_traverse_Tree();
        phi_94_ = true;
    }
    let _e39 = phi_93_;
    let _e41 = phi_94_;
    if _e41 {
        phi_99_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_99_ = _e39;
    }
    let _e46 = phi_99_;
    return lt_bvh_traverse_Tree(_e46.root, _e46.first_primitive);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_3: f32, param_4: f32) -> f32 {
    var phi_110_: f32;

    if (param_3 > param_4) {
        phi_110_ = param_3;
    } else {
        phi_110_ = param_4;
    }
    let _e26 = phi_110_;
    return _e26;
}

fn _glam_f32_scalar_vec4_Vec4_u0020_as_u0020_spirv_std_vector_VectorTruncateInto_glam_f32_scalar_vec4_Vec4_truncate_into(param_5: vec4<f32>) -> vec4<f32> {
    return param_5;
}

fn function_() {
    var phi_166_: f32;
    var phi_176_: u32;
    var phi_195_: bool;
    var phi_196_: bool;
    var phi_197_: bool;
    var phi_198_: bool;
    var phi_202_: bool;
    var phi_210_: vec3<f32>;

    let _e22 = id_1;
    let _e32 = p.member.size[0u];
    let _e34 = p.member.size[1u];
    let _e35 = lt_shaders_entry_pixel_index(_e22, _e32, _e34);
    if (bitcast<i32>(_e35.root) != 0i) {
        let _e43 = textureLoad(positions, vec2<u32>(_e22.x, _e22.y), 0u);
        let _e44 = _glam_f32_scalar_vec4_Vec4_u0020_as_u0020_spirv_std_vector_VectorTruncateInto_glam_f32_scalar_vec4_Vec4_truncate_into(_e43);
        let _e48 = textureLoad(normals, vec2<u32>(_e22.x, _e22.y), 0u);
        let _e49 = _glam_f32_scalar_vec4_Vec4_u0020_as_u0020_spirv_std_vector_VectorTruncateInto_glam_f32_scalar_vec4_Vec4_truncate_into(_e48);
        let _e53 = textureLoad(last_positions, vec2<u32>(_e22.x, _e22.y), 0u);
        let _e54 = _glam_f32_scalar_vec4_Vec4_u0020_as_u0020_spirv_std_vector_VectorTruncateInto_glam_f32_scalar_vec4_Vec4_truncate_into(_e53);
        let _e62 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e44.y), abs(_e44.z));
        let _e63 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e44.x), _e62);
        if (_e44.w > _e63) {
            phi_166_ = _e44.w;
        } else {
            phi_166_ = _e63;
        }
        let _e68 = phi_166_;
        if (_e49.w == 0f) {
            phi_176_ = 1u;
        } else {
            phi_176_ = 0u;
        }
        let _e76 = phi_176_;
        let _e81 = global[0u];
        if (_e49.x == _e81) {
            let _e84 = global[1u];
            if (_e49.y == _e84) {
                let _e87 = global[2u];
                phi_195_ = (_e49.z == _e87);
                phi_196_ = false;
            } else {
                phi_195_ = bool();
                phi_196_ = true;
            }
            let _e90 = phi_195_;
            let _e92 = phi_196_;
            phi_197_ = _e90;
            phi_198_ = _e92;
        } else {
            phi_197_ = bool();
            phi_198_ = true;
        }
        let _e94 = phi_197_;
        let _e96 = phi_198_;
        if _e96 {
            phi_202_ = false;
        } else {
            phi_202_ = _e94;
        }
        let _e98 = phi_202_;
        if _e98 {
            phi_210_ = vec3<f32>(0f, 1f, 0f);
        } else {
            phi_210_ = vec3<f32>(_e49.x, _e49.y, _e49.z);
        }
        let _e104 = phi_210_;
        if (_e35.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e35.first_primitive)] = abi_Sample(vec3<f32>(_e44.x, _e44.y, _e44.z), _e68, vec3<f32>(_e49.x, _e49.y, _e49.z), _e76, _e104, 16777215u);
        if (_e35.first_primitive < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e35.first_primitive)] = _e54;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_gbuffer_gbuffer_import_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
