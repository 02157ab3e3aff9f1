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

struct type_32 {
    member: array<lt_math_LightProjection>,
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

struct type_38 {
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
var<storage, read_write> marks: type_38;
@group(0) @binding(6) 
var<storage> levels: type_32;

fn function_() {
    var phi_182_: u32;
    var phi_201_: u32;
    var phi_209_: u32;
    var phi_244_: lt_math_LightPoint;
    var phi_247_: u32;
    var phi_249_: lt_math_LevelPoint;
    var phi_335_: bool;
    var phi_344_: bool;
    var phi_353_: bool;
    var phi_354_: bool;
    var phi_355_: bool;
    var phi_356_: bool;
    var phi_357_: bool;
    var phi_358_: bool;
    var phi_359_: bool;
    var phi_363_: bool;
    var phi_390_: bool;
    var phi_391_: bool;
    var phi_392_: bool;
    var phi_393_: bool;
    var phi_394_: bool;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_397_: bool;
    var phi_401_: bool;
    var phi_410_: lt_math_LightPoint;
    var phi_411_: u32;
    var phi_412_: lt_math_LevelPoint;
    var phi_413_: bool;
    var phi_245_: lt_math_LightPoint;
    var phi_248_: u32;
    var phi_250_: lt_math_LevelPoint;
    var phi_414_: bool;
    var local: lt_math_LevelPoint;
    var local_1: lt_math_LevelPoint;
    var phi_443_: f32;
    var phi_448_: f32;
    var phi_449_: bool;
    var phi_450_: f32;
    var phi_451_: bool;
    var phi_455_: f32;
    var phi_475_: f32;
    var phi_480_: f32;
    var phi_481_: bool;
    var phi_482_: f32;
    var phi_483_: bool;
    var phi_487_: f32;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var local_4: lt_math_LevelPoint;
    var local_5: lt_math_LevelPoint;
    var phi_559_: bool;
    var phi_560_: bool;
    var phi_561_: bool;
    var phi_562_: bool;
    var phi_563_: bool;
    var phi_564_: bool;
    var phi_568_: bool;
    var phi_570_: bool;
    var local_6: lt_math_LevelPoint;
    var phi_587_: u32;
    var phi_599_: i32;
    var phi_604_: i32;
    var phi_609_: i32;
    var phi_614_: i32;
    var phi_633_: i32;
    var phi_638_: i32;
    var phi_643_: i32;
    var phi_648_: i32;
    var phi_667_: i32;
    var phi_672_: i32;
    var phi_677_: i32;
    var phi_682_: i32;
    var phi_701_: i32;
    var phi_706_: i32;
    var phi_711_: i32;
    var phi_716_: i32;

    let _e41 = id_1;
    let _e48 = arrayLength((&list.member));
    let _e51 = arrayLength((&bits.member));
    let _e57 = arrayLength((&marks.member));
    let _e64 = ((_e41.y * 2097152u) + _e41.x);
    if (3u < _e48) {
    } else {
        return;
    }
    let _e67 = list.member[3u];
    if (_e64 < _e67) {
        let _e69 = (_e64 + 4u);
        if (_e69 < _e48) {
        } else {
            return;
        }
        let _e73 = list.member[(0u + _e69)];
        let _e74 = (_e73 & 2147483647u);
        let _e79 = p.member.light.number;
        let _e80 = (_e79 * 3u);
        let _e82 = (_e80 % 32u);
        let _e84 = p.member.light.mask_words;
        let _e86 = ((_e74 * _e84) + (_e80 / 32u));
        if (_e82 > 29u) {
            let _e88 = (_e86 + 1u);
            if (_e88 < _e51) {
            } else {
                return;
            }
            let _e92 = bits.member[(0u + _e88)];
            phi_182_ = _e92;
        } else {
            phi_182_ = 0u;
        }
        let _e94 = phi_182_;
        if (_e86 < _e51) {
        } else {
            return;
        }
        let _e98 = bits.member[(0u + _e86)];
        let _e101 = (_e98 >> bitcast<u32>((_e82 & 31u)));
        if (_e82 > 29u) {
            phi_201_ = (_e101 | (_e94 << bitcast<u32>(((32u - _e82) & 31u))));
        } else {
            phi_201_ = _e101;
        }
        let _e109 = phi_201_;
        if ((_e109 & 2u) == 0u) {
            phi_209_ = (_e109 & 1u);
        } else {
            phi_209_ = (_e109 & 7u);
        }
        let _e115 = phi_209_;
        if ((_e73 & 2147483648u) != 0u) {
            if (((_e115 & 1u) != 0u) != ((_e115 & 4u) != 0u)) {
                let _e122 = p.member.level_count;
                if (_e74 < arrayLength((&samples.member))) {
                } else {
                    return;
                }
                let _e127 = samples.member[(0u + _e74)].position;
                let _e129 = p.member.map_size;
                let _e131 = (0.5f / f32(_e129));
                let _e138 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
                let _e145 = lt_math_LightPoint(vec2<f32>(_e138.uv.x, 0f), _e138.depth, _e138.is_inside);
                let _e149 = lt_math_LightPoint(_e145.uv, 0f, _e145.is_inside);
                phi_244_ = lt_math_LightPoint();
                phi_247_ = 0u;
                phi_249_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e149.uv, _e149.depth, false));
                loop {
                    let _e156 = phi_244_;
                    let _e158 = phi_247_;
                    let _e160 = phi_249_;
                    local = _e160;
                    local_1 = _e160;
                    local_2 = _e160;
                    local_3 = _e160;
                    local_4 = _e160;
                    local_5 = _e160;
                    local_6 = _e160;
                    if (_e158 < _e122) {
                        if _e160.point.is_inside {
                            phi_410_ = lt_math_LightPoint();
                            phi_411_ = u32();
                            phi_412_ = lt_math_LevelPoint();
                            phi_413_ = false;
                        } else {
                            if (_e158 < arrayLength((&levels.member))) {
                            } else {
                                return;
                            }
                            let _e171 = levels.member[(0u + _e158)].row_w;
                            let _e182 = ((((_e171.x * _e127.x) + (_e171.y * _e127.y)) + (_e171.z * _e127.z)) + (_e171.w * 1f));
                            let _e184 = levels.member[(0u + _e158)].row_x;
                            let _e196 = (((((_e184.x * _e127.x) + (_e184.y * _e127.y)) + (_e184.z * _e127.z)) + (_e184.w * 1f)) / _e182);
                            let _e198 = levels.member[(0u + _e158)].row_y;
                            let _e210 = (((((_e198.x * _e127.x) + (_e198.y * _e127.y)) + (_e198.z * _e127.z)) + (_e198.w * 1f)) / _e182);
                            let _e212 = levels.member[(0u + _e158)].row_z;
                            let _e223 = ((((_e212.x * _e127.x) + (_e212.y * _e127.y)) + (_e212.z * _e127.z)) + (_e212.w * 1f));
                            if (_e182 > 0f) {
                                if (_e196 >= 0f) {
                                    phi_335_ = (_e196 <= 1f);
                                } else {
                                    phi_335_ = false;
                                }
                                let _e228 = phi_335_;
                                if _e228 {
                                    if (_e210 >= 0f) {
                                        phi_344_ = (_e210 <= 1f);
                                    } else {
                                        phi_344_ = false;
                                    }
                                    let _e232 = phi_344_;
                                    if _e232 {
                                        if (_e223 >= 0f) {
                                            phi_353_ = (_e223 <= 1f);
                                        } else {
                                            phi_353_ = false;
                                        }
                                        let _e236 = phi_353_;
                                        phi_354_ = _e236;
                                        phi_355_ = false;
                                    } else {
                                        phi_354_ = bool();
                                        phi_355_ = true;
                                    }
                                    let _e238 = phi_354_;
                                    let _e240 = phi_355_;
                                    phi_356_ = _e238;
                                    phi_357_ = _e240;
                                } else {
                                    phi_356_ = bool();
                                    phi_357_ = true;
                                }
                                let _e242 = phi_356_;
                                let _e244 = phi_357_;
                                phi_358_ = _e242;
                                phi_359_ = _e244;
                            } else {
                                phi_358_ = bool();
                                phi_359_ = true;
                            }
                            let _e246 = phi_358_;
                            let _e248 = phi_359_;
                            if _e248 {
                                phi_363_ = false;
                            } else {
                                phi_363_ = _e246;
                            }
                            let _e250 = phi_363_;
                            if _e250 {
                                if (_e196 >= _e131) {
                                    if (_e196 <= (1f - _e131)) {
                                        if (_e210 >= _e131) {
                                            phi_390_ = (_e210 <= (1f - _e131));
                                            phi_391_ = false;
                                        } else {
                                            phi_390_ = bool();
                                            phi_391_ = true;
                                        }
                                        let _e258 = phi_390_;
                                        let _e260 = phi_391_;
                                        phi_392_ = _e258;
                                        phi_393_ = _e260;
                                    } else {
                                        phi_392_ = bool();
                                        phi_393_ = true;
                                    }
                                    let _e262 = phi_392_;
                                    let _e264 = phi_393_;
                                    phi_394_ = _e262;
                                    phi_395_ = _e264;
                                } else {
                                    phi_394_ = bool();
                                    phi_395_ = true;
                                }
                                let _e266 = phi_394_;
                                let _e268 = phi_395_;
                                phi_396_ = _e266;
                                phi_397_ = _e268;
                            } else {
                                phi_396_ = bool();
                                phi_397_ = true;
                            }
                            let _e270 = phi_396_;
                            let _e272 = phi_397_;
                            if _e272 {
                                phi_401_ = false;
                            } else {
                                phi_401_ = _e270;
                            }
                            let _e274 = phi_401_;
                            let _e281 = lt_math_LightPoint(vec2<f32>(_e196, _e156.uv.y), _e156.depth, _e156.is_inside);
                            let _e288 = lt_math_LightPoint(vec2<f32>(_e281.uv.x, _e210), _e281.depth, _e281.is_inside);
                            let _e292 = lt_math_LightPoint(_e288.uv, _e223, _e288.is_inside);
                            let _e296 = lt_math_LightPoint(_e292.uv, _e292.depth, _e274);
                            phi_410_ = _e296;
                            phi_411_ = (_e158 + 1u);
                            phi_412_ = lt_math_LevelPoint(_e158, _e296);
                            phi_413_ = true;
                        }
                        let _e300 = phi_410_;
                        let _e302 = phi_411_;
                        let _e304 = phi_412_;
                        let _e306 = phi_413_;
                        phi_245_ = _e300;
                        phi_248_ = _e302;
                        phi_250_ = _e304;
                        phi_414_ = _e306;
                    } else {
                        phi_245_ = lt_math_LightPoint();
                        phi_248_ = u32();
                        phi_250_ = lt_math_LevelPoint();
                        phi_414_ = false;
                    }
                    let _e308 = phi_245_;
                    let _e310 = phi_248_;
                    let _e312 = phi_250_;
                    let _e314 = phi_414_;
                    continue;
                    continuing {
                        phi_244_ = _e308;
                        phi_247_ = _e310;
                        phi_249_ = _e312;
                        break if !(_e314);
                    }
                }
                let _e317 = local;
                let _e322 = local_1;
                let _e327 = p.member.map_size;
                let _e328 = f32(_e327);
                let _e331 = ((_e317.point.uv.x * _e328) - 0.5f);
                let _e332 = ((_e322.point.uv.y * _e328) - 0.5f);
                if (_e331 > -8388608f) {
                    let _e344 = f32(select(0i, select(select(i32(_e331), i32(-2147483648), (_e331 < bitcast<f32>(3472883712u))), 2147483647i, (_e331 > bitcast<f32>(1325400063u))), (_e331 == _e331)));
                    if (_e344 > _e331) {
                        phi_443_ = 1f;
                    } else {
                        phi_443_ = 0f;
                    }
                    let _e347 = phi_443_;
                    if (_e331 < 8388608f) {
                        phi_448_ = (_e344 - _e347);
                        phi_449_ = false;
                    } else {
                        phi_448_ = f32();
                        phi_449_ = true;
                    }
                    let _e350 = phi_448_;
                    let _e352 = phi_449_;
                    phi_450_ = _e350;
                    phi_451_ = _e352;
                } else {
                    phi_450_ = f32();
                    phi_451_ = true;
                }
                let _e354 = phi_450_;
                let _e356 = phi_451_;
                if _e356 {
                    phi_455_ = _e331;
                } else {
                    phi_455_ = _e354;
                }
                let _e358 = phi_455_;
                if (_e332 > -8388608f) {
                    let _e370 = f32(select(0i, select(select(i32(_e332), i32(-2147483648), (_e332 < bitcast<f32>(3472883712u))), 2147483647i, (_e332 > bitcast<f32>(1325400063u))), (_e332 == _e332)));
                    if (_e370 > _e332) {
                        phi_475_ = 1f;
                    } else {
                        phi_475_ = 0f;
                    }
                    let _e373 = phi_475_;
                    if (_e332 < 8388608f) {
                        phi_480_ = (_e370 - _e373);
                        phi_481_ = false;
                    } else {
                        phi_480_ = f32();
                        phi_481_ = true;
                    }
                    let _e376 = phi_480_;
                    let _e378 = phi_481_;
                    phi_482_ = _e376;
                    phi_483_ = _e378;
                } else {
                    phi_482_ = f32();
                    phi_483_ = true;
                }
                let _e380 = phi_482_;
                let _e382 = phi_483_;
                if _e382 {
                    phi_487_ = _e332;
                } else {
                    phi_487_ = _e380;
                }
                let _e384 = phi_487_;
                let _e385 = (_e331 - _e358);
                let _e386 = (_e332 - _e384);
                let _e395 = select(0i, select(select(i32(_e358), i32(-2147483648), (_e358 < bitcast<f32>(3472883712u))), 2147483647i, (_e358 > bitcast<f32>(1325400063u))), (_e358 == _e358));
                let _e404 = select(0i, select(select(i32(_e384), i32(-2147483648), (_e384 < bitcast<f32>(3472883712u))), 2147483647i, (_e384 > bitcast<f32>(1325400063u))), (_e384 == _e384));
                let _e414 = local_2;
                if _e414.point.is_inside {
                    let _e418 = local_3;
                    let _e423 = local_4;
                    let _e428 = local_5;
                    if (_e428.level < arrayLength((&moving.member))) {
                    } else {
                        return;
                    }
                    let _e433 = moving.member[(0u + _e428.level)];
                    let _e435 = p.member.map_size;
                    let _e437 = (1f / f32(_e435));
                    if ((_e418.point.uv.x + _e437) >= _e433.x) {
                        if ((_e423.point.uv.y + _e437) >= _e433.y) {
                            if ((_e418.point.uv.x - _e437) <= _e433.z) {
                                phi_559_ = ((_e423.point.uv.y - _e437) <= _e433.w);
                                phi_560_ = false;
                            } else {
                                phi_559_ = bool();
                                phi_560_ = true;
                            }
                            let _e451 = phi_559_;
                            let _e453 = phi_560_;
                            phi_561_ = _e451;
                            phi_562_ = _e453;
                        } else {
                            phi_561_ = bool();
                            phi_562_ = true;
                        }
                        let _e455 = phi_561_;
                        let _e457 = phi_562_;
                        phi_563_ = _e455;
                        phi_564_ = _e457;
                    } else {
                        phi_563_ = bool();
                        phi_564_ = true;
                    }
                    let _e459 = phi_563_;
                    let _e461 = phi_564_;
                    if _e461 {
                        phi_568_ = false;
                    } else {
                        phi_568_ = _e459;
                    }
                    let _e463 = phi_568_;
                    phi_570_ = !(_e463);
                } else {
                    phi_570_ = _e414.point.is_inside;
                }
                let _e466 = phi_570_;
                let _e468 = local_6;
                if _e466 {
                    if ((_e115 & 1u) != 0u) {
                        phi_587_ = 2u;
                    } else {
                        phi_587_ = 1u;
                    }
                    let _e473 = phi_587_;
                    let _e475 = p.member.map_size;
                    let _e477 = (bitcast<i32>(_e475) - 1i);
                    if (_e395 > 0i) {
                        phi_599_ = _e395;
                    } else {
                        phi_599_ = 0i;
                    }
                    let _e480 = phi_599_;
                    if (_e404 > 0i) {
                        phi_604_ = _e404;
                    } else {
                        phi_604_ = 0i;
                    }
                    let _e483 = phi_604_;
                    if (_e480 < _e477) {
                        phi_609_ = _e480;
                    } else {
                        phi_609_ = _e477;
                    }
                    let _e486 = phi_609_;
                    if (_e483 < _e477) {
                        phi_614_ = _e483;
                    } else {
                        phi_614_ = _e477;
                    }
                    let _e489 = phi_614_;
                    let _e490 = bitcast<u32>(_e486);
                    let _e497 = ((((_e468.level * _e475) + bitcast<u32>(_e489)) * (_e475 / 16u)) + (_e490 / 16u));
                    let _e500 = (_e395 + 1i);
                    let _e501 = (_e404 + 0i);
                    let _e503 = (bitcast<i32>(_e475) - 1i);
                    if (_e500 > 0i) {
                        phi_633_ = _e500;
                    } else {
                        phi_633_ = 0i;
                    }
                    let _e506 = phi_633_;
                    if (_e501 > 0i) {
                        phi_638_ = _e501;
                    } else {
                        phi_638_ = 0i;
                    }
                    let _e509 = phi_638_;
                    if (_e506 < _e503) {
                        phi_643_ = _e506;
                    } else {
                        phi_643_ = _e503;
                    }
                    let _e512 = phi_643_;
                    if (_e509 < _e503) {
                        phi_648_ = _e509;
                    } else {
                        phi_648_ = _e503;
                    }
                    let _e515 = phi_648_;
                    let _e516 = bitcast<u32>(_e512);
                    let _e523 = ((((_e468.level * _e475) + bitcast<u32>(_e515)) * (_e475 / 16u)) + (_e516 / 16u));
                    let _e526 = (_e395 + 0i);
                    let _e527 = (_e404 + 1i);
                    let _e529 = (bitcast<i32>(_e475) - 1i);
                    if (_e526 > 0i) {
                        phi_667_ = _e526;
                    } else {
                        phi_667_ = 0i;
                    }
                    let _e532 = phi_667_;
                    if (_e527 > 0i) {
                        phi_672_ = _e527;
                    } else {
                        phi_672_ = 0i;
                    }
                    let _e535 = phi_672_;
                    if (_e532 < _e529) {
                        phi_677_ = _e532;
                    } else {
                        phi_677_ = _e529;
                    }
                    let _e538 = phi_677_;
                    if (_e535 < _e529) {
                        phi_682_ = _e535;
                    } else {
                        phi_682_ = _e529;
                    }
                    let _e541 = phi_682_;
                    let _e542 = bitcast<u32>(_e538);
                    let _e549 = ((((_e468.level * _e475) + bitcast<u32>(_e541)) * (_e475 / 16u)) + (_e542 / 16u));
                    let _e552 = (_e395 + 1i);
                    let _e553 = (_e404 + 1i);
                    let _e555 = (bitcast<i32>(_e475) - 1i);
                    if (_e552 > 0i) {
                        phi_701_ = _e552;
                    } else {
                        phi_701_ = 0i;
                    }
                    let _e558 = phi_701_;
                    if (_e553 > 0i) {
                        phi_706_ = _e553;
                    } else {
                        phi_706_ = 0i;
                    }
                    let _e561 = phi_706_;
                    if (_e558 < _e555) {
                        phi_711_ = _e558;
                    } else {
                        phi_711_ = _e555;
                    }
                    let _e564 = phi_711_;
                    if (_e561 < _e555) {
                        phi_716_ = _e561;
                    } else {
                        phi_716_ = _e555;
                    }
                    let _e567 = phi_716_;
                    let _e568 = bitcast<u32>(_e564);
                    let _e575 = ((((_e468.level * _e475) + bitcast<u32>(_e567)) * (_e475 / 16u)) + (_e568 / 16u));
                    if (_e497 < _e57) {
                    } else {
                        return;
                    }
                    let _e584 = atomicOr((&marks.member[(0u + _e497)]), (_e473 << bitcast<u32>((((_e490 % 16u) * 2u) & 31u))));
                    if (_e523 < _e57) {
                    } else {
                        return;
                    }
                    let _e591 = atomicOr((&marks.member[(0u + _e523)]), (_e473 << bitcast<u32>((((_e516 % 16u) * 2u) & 31u))));
                    if (_e549 < _e57) {
                    } else {
                        return;
                    }
                    let _e598 = atomicOr((&marks.member[(0u + _e549)]), (_e473 << bitcast<u32>((((_e542 % 16u) * 2u) & 31u))));
                    if (_e575 < _e57) {
                    } else {
                        return;
                    }
                    let _e605 = atomicOr((&marks.member[(0u + _e575)]), (_e473 << bitcast<u32>((((_e568 % 16u) * 2u) & 31u))));
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_marks_mark_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
