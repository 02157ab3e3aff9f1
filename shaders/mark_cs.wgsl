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

struct type_24 {
    member: array<vec4<f32>>,
}

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    pad0_: u32,
    pad1_: u32,
}

struct type_28 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct type_34 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_18;
@group(0) @binding(0) 
var<uniform> p: type_28;
@group(0) @binding(2) 
var<storage> list: type_9;
@group(0) @binding(3) 
var<storage> bits: type_9;
@group(0) @binding(4) 
var<storage> moving: type_24;
@group(0) @binding(5) 
var<storage, read_write> marks: type_34;

fn function_() {
    var phi_171_: u32;
    var phi_190_: u32;
    var phi_198_: u32;
    var phi_285_: bool;
    var phi_294_: bool;
    var phi_303_: bool;
    var phi_304_: bool;
    var phi_305_: bool;
    var phi_306_: bool;
    var phi_307_: bool;
    var phi_308_: bool;
    var phi_309_: bool;
    var phi_313_: bool;
    var phi_347_: f32;
    var phi_352_: f32;
    var phi_353_: bool;
    var phi_354_: f32;
    var phi_355_: bool;
    var phi_359_: f32;
    var phi_379_: f32;
    var phi_384_: f32;
    var phi_385_: bool;
    var phi_386_: f32;
    var phi_387_: bool;
    var phi_391_: f32;
    var phi_461_: bool;
    var phi_462_: bool;
    var phi_463_: bool;
    var phi_464_: bool;
    var phi_465_: bool;
    var phi_466_: bool;
    var phi_470_: bool;
    var phi_472_: bool;
    var phi_488_: u32;
    var phi_500_: i32;
    var phi_505_: i32;
    var phi_510_: i32;
    var phi_515_: i32;
    var phi_534_: i32;
    var phi_539_: i32;
    var phi_544_: i32;
    var phi_549_: i32;
    var phi_568_: i32;
    var phi_573_: i32;
    var phi_578_: i32;
    var phi_583_: i32;
    var phi_602_: i32;
    var phi_607_: i32;
    var phi_612_: i32;
    var phi_617_: i32;

    let _e38 = id_1;
    let _e45 = arrayLength((&list.member));
    let _e48 = arrayLength((&bits.member));
    let _e54 = arrayLength((&marks.member));
    let _e58 = ((_e38.y * 2097152u) + _e38.x);
    if (3u < _e45) {
    } else {
        return;
    }
    let _e61 = list.member[3u];
    if (_e58 < _e61) {
        let _e63 = (_e58 + 4u);
        if (_e63 < _e45) {
        } else {
            return;
        }
        let _e67 = list.member[(0u + _e63)];
        let _e68 = (_e67 & 2147483647u);
        let _e73 = p.member.light.number;
        let _e74 = (_e73 * 3u);
        let _e76 = (_e74 % 32u);
        let _e78 = p.member.light.mask_words;
        let _e80 = ((_e68 * _e78) + (_e74 / 32u));
        if (_e76 > 29u) {
            let _e82 = (_e80 + 1u);
            if (_e82 < _e48) {
            } else {
                return;
            }
            let _e86 = bits.member[(0u + _e82)];
            phi_171_ = _e86;
        } else {
            phi_171_ = 0u;
        }
        let _e88 = phi_171_;
        if (_e80 < _e48) {
        } else {
            return;
        }
        let _e92 = bits.member[(0u + _e80)];
        let _e95 = (_e92 >> bitcast<u32>((_e76 & 31u)));
        if (_e76 > 29u) {
            phi_190_ = (_e95 | (_e88 << bitcast<u32>(((32u - _e76) & 31u))));
        } else {
            phi_190_ = _e95;
        }
        let _e103 = phi_190_;
        if ((_e103 & 2u) == 0u) {
            phi_198_ = (_e103 & 1u);
        } else {
            phi_198_ = (_e103 & 7u);
        }
        let _e109 = phi_198_;
        if ((_e67 & 2147483648u) != 0u) {
            if (((_e109 & 1u) != 0u) != ((_e109 & 4u) != 0u)) {
                let _e116 = p.member.projection;
                if (_e68 < arrayLength((&samples.member))) {
                } else {
                    return;
                }
                let _e120 = lt_math_OneLevel(_e116);
                let _e122 = samples.member[(0u + _e68)].position;
                let _e140 = ((((_e120.projection.row_w.x * _e122.x) + (_e120.projection.row_w.y * _e122.y)) + (_e120.projection.row_w.z * _e122.z)) + (_e120.projection.row_w.w * 1f));
                let _e154 = (((((_e120.projection.row_x.x * _e122.x) + (_e120.projection.row_x.y * _e122.y)) + (_e120.projection.row_x.z * _e122.z)) + (_e120.projection.row_x.w * 1f)) / _e140);
                let _e168 = (((((_e120.projection.row_y.x * _e122.x) + (_e120.projection.row_y.y * _e122.y)) + (_e120.projection.row_y.z * _e122.z)) + (_e120.projection.row_y.w * 1f)) / _e140);
                let _e181 = ((((_e120.projection.row_z.x * _e122.x) + (_e120.projection.row_z.y * _e122.y)) + (_e120.projection.row_z.z * _e122.z)) + (_e120.projection.row_z.w * 1f));
                if (_e140 > 0f) {
                    if (_e154 >= 0f) {
                        phi_285_ = (_e154 <= 1f);
                    } else {
                        phi_285_ = false;
                    }
                    let _e186 = phi_285_;
                    if _e186 {
                        if (_e168 >= 0f) {
                            phi_294_ = (_e168 <= 1f);
                        } else {
                            phi_294_ = false;
                        }
                        let _e190 = phi_294_;
                        if _e190 {
                            if (_e181 >= 0f) {
                                phi_303_ = (_e181 <= 1f);
                            } else {
                                phi_303_ = false;
                            }
                            let _e194 = phi_303_;
                            phi_304_ = _e194;
                            phi_305_ = false;
                        } else {
                            phi_304_ = bool();
                            phi_305_ = true;
                        }
                        let _e196 = phi_304_;
                        let _e198 = phi_305_;
                        phi_306_ = _e196;
                        phi_307_ = _e198;
                    } else {
                        phi_306_ = bool();
                        phi_307_ = true;
                    }
                    let _e200 = phi_306_;
                    let _e202 = phi_307_;
                    phi_308_ = _e200;
                    phi_309_ = _e202;
                } else {
                    phi_308_ = bool();
                    phi_309_ = true;
                }
                let _e204 = phi_308_;
                let _e206 = phi_309_;
                if _e206 {
                    phi_313_ = false;
                } else {
                    phi_313_ = _e204;
                }
                let _e208 = phi_313_;
                let _e215 = lt_math_LightPoint(vec2<f32>(_e154, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
                let _e222 = lt_math_LightPoint(vec2<f32>(_e215.uv.x, _e168), _e215.depth, _e215.is_inside);
                let _e226 = lt_math_LightPoint(_e222.uv, _e181, _e222.is_inside);
                let _e231 = lt_math_LevelPoint(0u, lt_math_LightPoint(_e226.uv, _e226.depth, _e208));
                let _e239 = p.member.map_size;
                let _e240 = f32(_e239);
                let _e243 = ((_e231.point.uv.x * _e240) - 0.5f);
                let _e244 = ((_e231.point.uv.y * _e240) - 0.5f);
                if (_e243 > -8388608f) {
                    let _e256 = f32(select(0i, select(select(i32(_e243), i32(-2147483648), (_e243 < bitcast<f32>(3472883712u))), 2147483647i, (_e243 > bitcast<f32>(1325400063u))), (_e243 == _e243)));
                    if (_e256 > _e243) {
                        phi_347_ = 1f;
                    } else {
                        phi_347_ = 0f;
                    }
                    let _e259 = phi_347_;
                    if (_e243 < 8388608f) {
                        phi_352_ = (_e256 - _e259);
                        phi_353_ = false;
                    } else {
                        phi_352_ = f32();
                        phi_353_ = true;
                    }
                    let _e262 = phi_352_;
                    let _e264 = phi_353_;
                    phi_354_ = _e262;
                    phi_355_ = _e264;
                } else {
                    phi_354_ = f32();
                    phi_355_ = true;
                }
                let _e266 = phi_354_;
                let _e268 = phi_355_;
                if _e268 {
                    phi_359_ = _e243;
                } else {
                    phi_359_ = _e266;
                }
                let _e270 = phi_359_;
                if (_e244 > -8388608f) {
                    let _e282 = f32(select(0i, select(select(i32(_e244), i32(-2147483648), (_e244 < bitcast<f32>(3472883712u))), 2147483647i, (_e244 > bitcast<f32>(1325400063u))), (_e244 == _e244)));
                    if (_e282 > _e244) {
                        phi_379_ = 1f;
                    } else {
                        phi_379_ = 0f;
                    }
                    let _e285 = phi_379_;
                    if (_e244 < 8388608f) {
                        phi_384_ = (_e282 - _e285);
                        phi_385_ = false;
                    } else {
                        phi_384_ = f32();
                        phi_385_ = true;
                    }
                    let _e288 = phi_384_;
                    let _e290 = phi_385_;
                    phi_386_ = _e288;
                    phi_387_ = _e290;
                } else {
                    phi_386_ = f32();
                    phi_387_ = true;
                }
                let _e292 = phi_386_;
                let _e294 = phi_387_;
                if _e294 {
                    phi_391_ = _e244;
                } else {
                    phi_391_ = _e292;
                }
                let _e296 = phi_391_;
                let _e297 = (_e243 - _e270);
                let _e298 = (_e244 - _e296);
                let _e307 = select(0i, select(select(i32(_e270), i32(-2147483648), (_e270 < bitcast<f32>(3472883712u))), 2147483647i, (_e270 > bitcast<f32>(1325400063u))), (_e270 == _e270));
                let _e316 = select(0i, select(select(i32(_e296), i32(-2147483648), (_e296 < bitcast<f32>(3472883712u))), 2147483647i, (_e296 > bitcast<f32>(1325400063u))), (_e296 == _e296));
                if _e208 {
                    if (0u < arrayLength((&moving.member))) {
                    } else {
                        return;
                    }
                    let _e334 = moving.member[(0u + 0u)];
                    let _e336 = p.member.map_size;
                    let _e338 = (1f / f32(_e336));
                    if ((_e231.point.uv.x + _e338) >= _e334.x) {
                        if ((_e231.point.uv.y + _e338) >= _e334.y) {
                            if ((_e231.point.uv.x - _e338) <= _e334.z) {
                                phi_461_ = ((_e231.point.uv.y - _e338) <= _e334.w);
                                phi_462_ = false;
                            } else {
                                phi_461_ = bool();
                                phi_462_ = true;
                            }
                            let _e352 = phi_461_;
                            let _e354 = phi_462_;
                            phi_463_ = _e352;
                            phi_464_ = _e354;
                        } else {
                            phi_463_ = bool();
                            phi_464_ = true;
                        }
                        let _e356 = phi_463_;
                        let _e358 = phi_464_;
                        phi_465_ = _e356;
                        phi_466_ = _e358;
                    } else {
                        phi_465_ = bool();
                        phi_466_ = true;
                    }
                    let _e360 = phi_465_;
                    let _e362 = phi_466_;
                    if _e362 {
                        phi_470_ = false;
                    } else {
                        phi_470_ = _e360;
                    }
                    let _e364 = phi_470_;
                    phi_472_ = !(_e364);
                } else {
                    phi_472_ = _e208;
                }
                let _e367 = phi_472_;
                if _e367 {
                    if ((_e109 & 1u) != 0u) {
                        phi_488_ = 2u;
                    } else {
                        phi_488_ = 1u;
                    }
                    let _e371 = phi_488_;
                    let _e373 = p.member.map_size;
                    let _e375 = (bitcast<i32>(_e373) - 1i);
                    if (_e307 > 0i) {
                        phi_500_ = _e307;
                    } else {
                        phi_500_ = 0i;
                    }
                    let _e378 = phi_500_;
                    if (_e316 > 0i) {
                        phi_505_ = _e316;
                    } else {
                        phi_505_ = 0i;
                    }
                    let _e381 = phi_505_;
                    if (_e378 < _e375) {
                        phi_510_ = _e378;
                    } else {
                        phi_510_ = _e375;
                    }
                    let _e384 = phi_510_;
                    if (_e381 < _e375) {
                        phi_515_ = _e381;
                    } else {
                        phi_515_ = _e375;
                    }
                    let _e387 = phi_515_;
                    let _e388 = bitcast<u32>(_e384);
                    let _e395 = ((((0u * _e373) + bitcast<u32>(_e387)) * (_e373 / 16u)) + (_e388 / 16u));
                    let _e398 = (_e307 + 1i);
                    let _e399 = (_e316 + 0i);
                    let _e401 = (bitcast<i32>(_e373) - 1i);
                    if (_e398 > 0i) {
                        phi_534_ = _e398;
                    } else {
                        phi_534_ = 0i;
                    }
                    let _e404 = phi_534_;
                    if (_e399 > 0i) {
                        phi_539_ = _e399;
                    } else {
                        phi_539_ = 0i;
                    }
                    let _e407 = phi_539_;
                    if (_e404 < _e401) {
                        phi_544_ = _e404;
                    } else {
                        phi_544_ = _e401;
                    }
                    let _e410 = phi_544_;
                    if (_e407 < _e401) {
                        phi_549_ = _e407;
                    } else {
                        phi_549_ = _e401;
                    }
                    let _e413 = phi_549_;
                    let _e414 = bitcast<u32>(_e410);
                    let _e421 = ((((0u * _e373) + bitcast<u32>(_e413)) * (_e373 / 16u)) + (_e414 / 16u));
                    let _e424 = (_e307 + 0i);
                    let _e425 = (_e316 + 1i);
                    let _e427 = (bitcast<i32>(_e373) - 1i);
                    if (_e424 > 0i) {
                        phi_568_ = _e424;
                    } else {
                        phi_568_ = 0i;
                    }
                    let _e430 = phi_568_;
                    if (_e425 > 0i) {
                        phi_573_ = _e425;
                    } else {
                        phi_573_ = 0i;
                    }
                    let _e433 = phi_573_;
                    if (_e430 < _e427) {
                        phi_578_ = _e430;
                    } else {
                        phi_578_ = _e427;
                    }
                    let _e436 = phi_578_;
                    if (_e433 < _e427) {
                        phi_583_ = _e433;
                    } else {
                        phi_583_ = _e427;
                    }
                    let _e439 = phi_583_;
                    let _e440 = bitcast<u32>(_e436);
                    let _e447 = ((((0u * _e373) + bitcast<u32>(_e439)) * (_e373 / 16u)) + (_e440 / 16u));
                    let _e450 = (_e307 + 1i);
                    let _e451 = (_e316 + 1i);
                    let _e453 = (bitcast<i32>(_e373) - 1i);
                    if (_e450 > 0i) {
                        phi_602_ = _e450;
                    } else {
                        phi_602_ = 0i;
                    }
                    let _e456 = phi_602_;
                    if (_e451 > 0i) {
                        phi_607_ = _e451;
                    } else {
                        phi_607_ = 0i;
                    }
                    let _e459 = phi_607_;
                    if (_e456 < _e453) {
                        phi_612_ = _e456;
                    } else {
                        phi_612_ = _e453;
                    }
                    let _e462 = phi_612_;
                    if (_e459 < _e453) {
                        phi_617_ = _e459;
                    } else {
                        phi_617_ = _e453;
                    }
                    let _e465 = phi_617_;
                    let _e466 = bitcast<u32>(_e462);
                    let _e473 = ((((0u * _e373) + bitcast<u32>(_e465)) * (_e373 / 16u)) + (_e466 / 16u));
                    if (_e395 < _e54) {
                    } else {
                        return;
                    }
                    let _e482 = atomicOr((&marks.member[(0u + _e395)]), (_e371 << bitcast<u32>((((_e388 % 16u) * 2u) & 31u))));
                    if (_e421 < _e54) {
                    } else {
                        return;
                    }
                    let _e489 = atomicOr((&marks.member[(0u + _e421)]), (_e371 << bitcast<u32>((((_e414 % 16u) * 2u) & 31u))));
                    if (_e447 < _e54) {
                    } else {
                        return;
                    }
                    let _e496 = atomicOr((&marks.member[(0u + _e447)]), (_e371 << bitcast<u32>((((_e440 % 16u) * 2u) & 31u))));
                    if (_e473 < _e54) {
                    } else {
                        return;
                    }
                    let _e503 = atomicOr((&marks.member[(0u + _e473)]), (_e371 << bitcast<u32>((((_e466 % 16u) * 2u) & 31u))));
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_marks_mark_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
