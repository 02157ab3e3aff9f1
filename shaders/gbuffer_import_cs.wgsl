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

struct type_19 {
    member: abi_CameraParams,
}

var<private> id_1: vec3<u32>;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_19;
@group(0) @binding(3) 
var<storage, read_write> samples: type_13;
@group(0) @binding(1) 
var positions: texture_2d<f32>;
@group(0) @binding(2) 
var normals: texture_2d<f32>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_84_: lt_bvh_traverse_Tree;
    var phi_85_: bool;
    var phi_86_: lt_bvh_traverse_Tree;
    var phi_87_: bool;
    var phi_92_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_84_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_85_ = false;
        } else {
            phi_84_ = lt_bvh_traverse_Tree();
            phi_85_ = true;
        }
        let _e33 = phi_84_;
        let _e35 = phi_85_;
        phi_86_ = _e33;
        phi_87_ = _e35;
    } else {
        phi_86_ = lt_bvh_traverse_Tree();
        phi_87_ = true;
    }
    let _e37 = phi_86_;
    let _e39 = phi_87_;
    if _e39 {
        phi_92_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_92_ = _e37;
    }
    let _e44 = phi_92_;
    return lt_bvh_traverse_Tree(_e44.root, _e44.first_primitive);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_3: f32, param_4: f32) -> f32 {
    var phi_103_: f32;

    if (param_3 > param_4) {
        phi_103_ = param_3;
    } else {
        phi_103_ = param_4;
    }
    let _e24 = phi_103_;
    return _e24;
}

fn _glam_f32_scalar_vec4_Vec4_u0020_as_u0020_spirv_std_vector_VectorTruncateInto_glam_f32_scalar_vec4_Vec4_truncate_into(param_5: vec4<f32>) -> vec4<f32> {
    return param_5;
}

fn function_() {
    var phi_149_: f32;
    var phi_159_: u32;
    var phi_178_: bool;
    var phi_179_: bool;
    var phi_180_: bool;
    var phi_181_: bool;
    var phi_185_: bool;
    var phi_193_: vec3<f32>;

    let _e20 = id_1;
    let _e27 = p.member.size[0u];
    let _e29 = p.member.size[1u];
    let _e30 = lt_shaders_entry_pixel_index(_e20, _e27, _e29);
    if (bitcast<i32>(_e30.root) != 0i) {
        let _e38 = textureLoad(positions, vec2<u32>(_e20.x, _e20.y), 0u);
        let _e39 = _glam_f32_scalar_vec4_Vec4_u0020_as_u0020_spirv_std_vector_VectorTruncateInto_glam_f32_scalar_vec4_Vec4_truncate_into(_e38);
        let _e43 = textureLoad(normals, vec2<u32>(_e20.x, _e20.y), 0u);
        let _e44 = _glam_f32_scalar_vec4_Vec4_u0020_as_u0020_spirv_std_vector_VectorTruncateInto_glam_f32_scalar_vec4_Vec4_truncate_into(_e43);
        let _e52 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e39.y), abs(_e39.z));
        let _e53 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e39.x), _e52);
        if (_e39.w > _e53) {
            phi_149_ = _e39.w;
        } else {
            phi_149_ = _e53;
        }
        let _e58 = phi_149_;
        if (_e44.w == 0f) {
            phi_159_ = 1u;
        } else {
            phi_159_ = 0u;
        }
        let _e66 = phi_159_;
        let _e71 = global[0u];
        if (_e44.x == _e71) {
            let _e74 = global[1u];
            if (_e44.y == _e74) {
                let _e77 = global[2u];
                phi_178_ = (_e44.z == _e77);
                phi_179_ = false;
            } else {
                phi_178_ = bool();
                phi_179_ = true;
            }
            let _e80 = phi_178_;
            let _e82 = phi_179_;
            phi_180_ = _e80;
            phi_181_ = _e82;
        } else {
            phi_180_ = bool();
            phi_181_ = true;
        }
        let _e84 = phi_180_;
        let _e86 = phi_181_;
        if _e86 {
            phi_185_ = false;
        } else {
            phi_185_ = _e84;
        }
        let _e88 = phi_185_;
        if _e88 {
            phi_193_ = vec3<f32>(0f, 1f, 0f);
        } else {
            phi_193_ = vec3<f32>(_e44.x, _e44.y, _e44.z);
        }
        let _e94 = phi_193_;
        if (_e30.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e30.first_primitive)] = abi_Sample(vec3<f32>(_e39.x, _e39.y, _e39.z), _e58, vec3<f32>(_e44.x, _e44.y, _e44.z), _e66, _e94, 16777215u);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_gbuffer_gbuffer_import_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
