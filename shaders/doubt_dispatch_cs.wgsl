struct type_3 {
    member: array<u32>,
}

var<private> _id_1: vec3<u32>;
@group(0) @binding(0) 
var<storage, read_write> list: type_3;

fn function_() {
    var phi_47_: u32;

    let _e10 = arrayLength((&list.member));
    if (3u < _e10) {
    } else {
        return;
    }
    let _e13 = list.member[3u];
    if (64u == 0u) {
        return;
    }
    let _e15 = (_e13 / 64u);
    if (64u == 0u) {
        return;
    }
    if ((_e13 % 64u) > 0u) {
        phi_47_ = (_e15 + 1u);
    } else {
        phi_47_ = _e15;
    }
    let _e21 = phi_47_;
    if (0u < _e10) {
    } else {
        return;
    }
    list.member[0u] = _e21;
    if (1u < _e10) {
    } else {
        return;
    }
    list.member[1u] = 1u;
    if (2u < _e10) {
    } else {
        return;
    }
    list.member[2u] = 1u;
    return;
}

@compute @workgroup_size(1, 1, 1) 
fn entry_doubt_doubt_dispatch_cs(@builtin(global_invocation_id) _id: vec3<u32>) {
    _id_1 = _id;
    function_();
}
