struct type_5 {
    member: array<u32>,
}

var<private> _id_1: vec3<u32>;
@group(0) @binding(0) 
var<storage, read_write> list: type_5;

fn function_() {
    var phi_49_: u32;
    var phi_54_: u32;
    var phi_70_: u32;

    let _e11 = arrayLength((&list.member));
    if (3u < _e11) {
    } else {
        return;
    }
    let _e14 = list.member[3u];
    if (64u == 0u) {
        return;
    }
    let _e16 = (_e14 / 64u);
    if (64u == 0u) {
        return;
    }
    if ((_e14 % 64u) > 0u) {
        phi_49_ = (_e16 + 1u);
    } else {
        phi_49_ = _e16;
    }
    let _e22 = phi_49_;
    if (32768u < _e22) {
        phi_54_ = 32768u;
    } else {
        phi_54_ = _e22;
    }
    let _e25 = phi_54_;
    if (32768u == 0u) {
        return;
    }
    let _e27 = (_e22 / 32768u);
    if (32768u == 0u) {
        return;
    }
    if ((_e22 % 32768u) > 0u) {
        phi_70_ = (_e27 + 1u);
    } else {
        phi_70_ = _e27;
    }
    let _e33 = phi_70_;
    if (0u < _e11) {
    } else {
        return;
    }
    list.member[0u] = _e25;
    if (1u < _e11) {
    } else {
        return;
    }
    list.member[1u] = _e33;
    if (2u < _e11) {
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
