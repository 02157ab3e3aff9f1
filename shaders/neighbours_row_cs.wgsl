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

struct abi_MaskParams {
    current: abi_CameraParams,
    previous: abi_CameraParams,
    light: abi_LightParams,
    still: vec2<u32>,
    moving: vec2<u32>,
    frame: u32,
    flags: u32,
    depth_tolerance: f32,
    refresh: u32,
    expansion: u32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_8 {
    member: abi_MaskParams,
}

struct type_12 {
    member: array<u32>,
}

struct type_16 {
    member: array<vec4<u32>>,
}

struct texture_TextureView {
    offset: u32,
    size: u32,
    flags: u32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> p: type_8;
@group(0) @binding(1) 
var<storage> bits: type_12;
@group(0) @binding(2) 
var<storage, read_write> rows: type_16;

fn function_() {
    var phi_98_: u32;
    var phi_105_: bool;
    var phi_134_: u32;
    var phi_137_: texture_TextureView;
    var phi_140_: u32;
    var phi_167_: u32;
    var phi_186_: u32;
    var phi_194_: u32;
    var phi_138_: texture_TextureView;
    var phi_141_: u32;
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: texture_TextureView;
    var local_3: texture_TextureView;
    var local_4: texture_TextureView;
    var local_5: texture_TextureView;
    var phi_233_: u32;
    var phi_234_: u32;
    var local_6: texture_TextureView;
    var local_7: texture_TextureView;
    var phi_244_: u32;
    var phi_258_: u32;
    var local_8: texture_TextureView;
    var local_9: texture_TextureView;
    var local_10: texture_TextureView;
    var local_11: texture_TextureView;
    var local_12: texture_TextureView;
    var local_13: texture_TextureView;
    var phi_272_: u32;
    var phi_273_: u32;
    var local_14: texture_TextureView;
    var local_15: texture_TextureView;
    var phi_283_: u32;
    var phi_297_: u32;
    var local_16: texture_TextureView;
    var local_17: texture_TextureView;
    var phi_320_: u32;

    let _e22 = id_1;
    let _e26 = arrayLength((&bits.member));
    let _e33 = p.member.current.size[0u];
    let _e37 = p.member.current.size[1u];
    if (32u == 0u) {
        return;
    }
    let _e40 = (_e33 / 32u);
    if (32u == 0u) {
        return;
    }
    if ((_e33 % 32u) > 0u) {
        phi_98_ = (_e40 + 1u);
    } else {
        phi_98_ = _e40;
    }
    let _e46 = phi_98_;
    if (_e22.x < _e46) {
        phi_105_ = (_e22.y < _e37);
    } else {
        phi_105_ = false;
    }
    let _e51 = phi_105_;
    if _e51 {
        let _e56 = p.member.light.number;
        let _e57 = (_e56 * 3u);
        let _e59 = (_e57 % 32u);
        let _e61 = p.member.light.mask_words;
        let _e65 = p.member.current.size[0u];
        let _e70 = (_e22.x * 32u);
        let _e71 = (_e65 - _e70);
        if (32u < _e71) {
            phi_134_ = 32u;
        } else {
            phi_134_ = _e71;
        }
        let _e74 = phi_134_;
        phi_137_ = texture_TextureView(0u, 0u, 0u);
        phi_140_ = 0u;
        loop {
            let _e77 = phi_137_;
            let _e79 = phi_140_;
            local = _e77;
            local_1 = _e77;
            local_2 = _e77;
            local_3 = _e77;
            local_4 = _e77;
            local_5 = _e77;
            local_6 = _e77;
            local_7 = _e77;
            local_8 = _e77;
            local_9 = _e77;
            local_10 = _e77;
            local_11 = _e77;
            local_12 = _e77;
            local_13 = _e77;
            local_14 = _e77;
            local_15 = _e77;
            local_16 = _e77;
            local_17 = _e77;
            let _e80 = (_e79 < _e74);
            if _e80 {
                let _e85 = (((((_e22.y * _e65) + _e70) + _e79) * _e61) + (_e57 / 32u));
                if (_e59 > 29u) {
                    let _e87 = (_e85 + 1u);
                    if (_e87 < _e26) {
                    } else {
                        return;
                    }
                    let _e91 = bits.member[(0u + _e87)];
                    phi_167_ = _e91;
                } else {
                    phi_167_ = 0u;
                }
                let _e93 = phi_167_;
                if (_e85 < _e26) {
                } else {
                    return;
                }
                let _e97 = bits.member[(0u + _e85)];
                let _e100 = (_e97 >> bitcast<u32>((_e59 & 31u)));
                if (_e59 > 29u) {
                    phi_186_ = (_e100 | (_e93 << bitcast<u32>(((32u - _e59) & 31u))));
                } else {
                    phi_186_ = _e100;
                }
                let _e108 = phi_186_;
                if ((_e108 & 2u) == 0u) {
                    phi_194_ = (_e108 & 1u);
                } else {
                    phi_194_ = (_e108 & 7u);
                }
                let _e114 = phi_194_;
                phi_138_ = texture_TextureView((_e77.offset | (select(0u, 1u, ((_e114 & 1u) != 0u)) << bitcast<u32>((_e79 & 31u)))), (_e77.size | (select(0u, 1u, ((_e114 & 2u) != 0u)) << bitcast<u32>((_e79 & 31u)))), (_e77.flags | (select(0u, 1u, ((_e114 & 4u) != 0u)) << bitcast<u32>((_e79 & 31u)))));
                phi_141_ = (_e79 + 1u);
            } else {
                phi_138_ = texture_TextureView();
                phi_141_ = u32();
            }
            let _e142 = phi_138_;
            let _e144 = phi_141_;
            continue;
            continuing {
                phi_137_ = _e142;
                phi_140_ = _e144;
                break if !(_e80);
            }
        }
        let _e147 = p.member.expansion;
        if false {
            let _e149 = local;
            let _e152 = local_1;
            let _e157 = local_2;
            phi_233_ = ~(_e157.offset);
            phi_234_ = (_e149.size & ~(_e152.flags));
        } else {
            let _e161 = local_3;
            let _e164 = local_4;
            let _e168 = local_5;
            phi_233_ = _e168.offset;
            phi_234_ = (_e161.size & _e164.flags);
        }
        let _e171 = phi_233_;
        let _e173 = phi_234_;
        switch bitcast<i32>(_e147) {
            case 1: {
                phi_244_ = _e173;
                break;
            }
            case 2: {
                let _e177 = local_6;
                let _e180 = local_7;
                phi_244_ = (_e173 & (_e177.flags ^ _e180.offset));
                break;
            }
            default: {
                phi_244_ = (_e173 | _e171);
                break;
            }
        }
        let _e185 = phi_244_;
        let _e186 = (_e74 - 1u);
        let _e189 = (4294967294u << bitcast<u32>((_e186 & 31u)));
        if (((_e185 >> bitcast<u32>((_e186 & 31u))) & 1u) == 0u) {
            phi_258_ = (_e185 & ~(_e189));
        } else {
            phi_258_ = (_e185 | _e189);
        }
        let _e199 = phi_258_;
        if true {
            let _e201 = local_8;
            let _e204 = local_9;
            let _e209 = local_10;
            phi_272_ = ~(_e209.offset);
            phi_273_ = (_e201.size & ~(_e204.flags));
        } else {
            let _e213 = local_11;
            let _e216 = local_12;
            let _e220 = local_13;
            phi_272_ = _e220.offset;
            phi_273_ = (_e213.size & _e216.flags);
        }
        let _e223 = phi_272_;
        let _e225 = phi_273_;
        switch bitcast<i32>(_e147) {
            case 1: {
                phi_283_ = _e225;
                break;
            }
            case 2: {
                let _e229 = local_14;
                let _e232 = local_15;
                phi_283_ = (_e225 & (_e229.flags ^ _e232.offset));
                break;
            }
            default: {
                phi_283_ = (_e225 | _e223);
                break;
            }
        }
        let _e237 = phi_283_;
        let _e238 = (_e74 - 1u);
        let _e241 = (4294967294u << bitcast<u32>((_e238 & 31u)));
        if (((_e237 >> bitcast<u32>((_e238 & 31u))) & 1u) == 0u) {
            phi_297_ = (_e237 & ~(_e241));
        } else {
            phi_297_ = (_e237 | _e241);
        }
        let _e251 = phi_297_;
        let _e253 = local_16;
        let _e256 = local_17;
        let _e263 = p.member.current.size[0u];
        if (32u == 0u) {
            return;
        }
        let _e265 = (_e263 / 32u);
        if (32u == 0u) {
            return;
        }
        if ((_e263 % 32u) > 0u) {
            phi_320_ = (_e265 + 1u);
        } else {
            phi_320_ = _e265;
        }
        let _e271 = phi_320_;
        let _e274 = ((_e22.y * _e271) + _e22.x);
        if (_e274 < arrayLength((&rows.member))) {
        } else {
            return;
        }
        rows.member[(0u + _e274)] = vec4<u32>(_e199, _e251, _e253.size, _e256.flags);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_neighbours_neighbours_row_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
