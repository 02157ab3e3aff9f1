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

struct type_12 {
    member: array<abi_Sample>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_19 {
    member: abi_CameraParams,
}

var<private> id_1: vec3<u32>;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_19;
@group(0) @binding(3) 
var<storage, read_write> samples: type_12;
@group(0) @binding(1) 
var positions: texture_2d<f32>;
@group(0) @binding(2) 
var normals: texture_2d<f32>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_86_: lt_bvh_traverse_Tree;
    var phi_87_: bool;
    var phi_88_: lt_bvh_traverse_Tree;
    var phi_89_: bool;
    var phi_94_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_86_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_87_ = false;
        } else {
            phi_86_ = lt_bvh_traverse_Tree();
            phi_87_ = true;
        }
        let _e33 = phi_86_;
        let _e35 = phi_87_;
        phi_88_ = _e33;
        phi_89_ = _e35;
    } else {
        phi_88_ = lt_bvh_traverse_Tree();
        phi_89_ = true;
    }
    let _e37 = phi_88_;
    let _e39 = phi_89_;
    if _e39 {
        phi_94_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_94_ = _e37;
    }
    let _e44 = phi_94_;
    return lt_bvh_traverse_Tree(_e44.root, _e44.first_primitive);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_3: f32, param_4: f32) -> f32 {
    var phi_105_: f32;

    if (param_3 > param_4) {
        phi_105_ = param_3;
    } else {
        phi_105_ = param_4;
    }
    let _e24 = phi_105_;
    return _e24;
}

fn lt_shaders_gbuffer_sample_from_texels(param_5: vec4<f32>, param_6: vec4<f32>) -> abi_Sample {
    var phi_163_: f32;
    var phi_186_: bool;
    var phi_187_: bool;
    var phi_188_: bool;
    var phi_189_: bool;
    var phi_193_: bool;
    var phi_201_: vec3<f32>;

    let _e29 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(param_5.y), abs(param_5.z));
    let _e30 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(param_5.x), _e29);
    if (param_5.w > _e30) {
        phi_163_ = param_5.w;
    } else {
        phi_163_ = _e30;
    }
    let _e35 = phi_163_;
    let _e44 = global[0u];
    if (param_6.x == _e44) {
        let _e47 = global[1u];
        if (param_6.y == _e47) {
            let _e50 = global[2u];
            phi_186_ = (param_6.z == _e50);
            phi_187_ = false;
        } else {
            phi_186_ = bool();
            phi_187_ = true;
        }
        let _e53 = phi_186_;
        let _e55 = phi_187_;
        phi_188_ = _e53;
        phi_189_ = _e55;
    } else {
        phi_188_ = bool();
        phi_189_ = true;
    }
    let _e57 = phi_188_;
    let _e59 = phi_189_;
    if _e59 {
        phi_193_ = false;
    } else {
        phi_193_ = _e57;
    }
    let _e61 = phi_193_;
    if _e61 {
        phi_201_ = vec3<f32>(0f, 1f, 0f);
    } else {
        phi_201_ = vec3<f32>(param_6.x, param_6.y, param_6.z);
    }
    let _e67 = phi_201_;
    return abi_Sample(vec3<f32>(param_5.x, param_5.y, param_5.z), _e35, vec3<f32>(param_6.x, param_6.y, param_6.z), 1u, _e67, 16777215u);
}

fn _glam_f32_scalar_vec4_Vec4_u0020_as_u0020_spirv_std_vector_VectorTruncateInto_glam_f32_scalar_vec4_Vec4_truncate_into(param_7: vec4<f32>) -> vec4<f32> {
    return param_7;
}

fn function_() {
    let _e20 = id_1;
    let _e27 = p.member.size[0u];
    let _e29 = p.member.size[1u];
    let _e30 = lt_shaders_entry_pixel_index(_e20, _e27, _e29);
    if (bitcast<i32>(_e30.root) != 0i) {
        let _e38 = textureLoad(positions, vec2<u32>(_e20.x, _e20.y), 0u);
        let _e39 = _glam_f32_scalar_vec4_Vec4_u0020_as_u0020_spirv_std_vector_VectorTruncateInto_glam_f32_scalar_vec4_Vec4_truncate_into(_e38);
        let _e43 = textureLoad(normals, vec2<u32>(_e20.x, _e20.y), 0u);
        let _e44 = _glam_f32_scalar_vec4_Vec4_u0020_as_u0020_spirv_std_vector_VectorTruncateInto_glam_f32_scalar_vec4_Vec4_truncate_into(_e43);
        let _e45 = lt_shaders_gbuffer_sample_from_texels(_e39, _e44);
        if (_e30.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e30.first_primitive)] = _e45;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_gbuffer_gbuffer_import_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
