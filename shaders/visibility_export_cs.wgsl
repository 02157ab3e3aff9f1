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

struct type_12 {
    member: array<f32>,
}

struct type_16 {
    member: abi_CameraParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> p: type_16;
@group(0) @binding(1) 
var<storage> visibility: type_12;
@group(0) @binding(2) 
var target_: texture_storage_2d<r32float,read_write>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_62_: lt_bvh_traverse_Tree;
    var phi_63_: bool;
    var phi_64_: lt_bvh_traverse_Tree;
    var phi_65_: bool;
    var phi_70_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_62_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_63_ = false;
        } else {
            phi_62_ = lt_bvh_traverse_Tree();
            phi_63_ = true;
        }
        let _e24 = phi_62_;
        let _e26 = phi_63_;
        phi_64_ = _e24;
        phi_65_ = _e26;
    } else {
        phi_64_ = lt_bvh_traverse_Tree();
        phi_65_ = true;
    }
    let _e28 = phi_64_;
    let _e30 = phi_65_;
    if _e30 {
        phi_70_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_70_ = _e28;
    }
    let _e35 = phi_70_;
    return lt_bvh_traverse_Tree(_e35.root, _e35.first_primitive);
}

fn function_() {
    let _e11 = id_1;
    let _e18 = p.member.size[0u];
    let _e20 = p.member.size[1u];
    let _e21 = lt_shaders_entry_pixel_index(_e11, _e18, _e20);
    if (bitcast<i32>(_e21.root) != 0i) {
        if (_e21.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        let _e31 = visibility.member[(0u + _e21.first_primitive)];
        textureStore(target_, vec2<u32>(_e11.x, _e11.y), vec4(_e31));
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_gbuffer_visibility_export_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
