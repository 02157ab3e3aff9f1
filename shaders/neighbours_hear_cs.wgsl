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

struct lt_mask_Window_5_ {
    low: array<u32, 5>,
    high: array<u32, 5>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> p: type_8;
@group(0) @binding(1) 
var<storage> rows: type_16;
@group(0) @binding(2) 
var<storage, read_write> words: type_12;

fn function_() {
    var local: array<u32, 1>;
    var local_1: array<u32, 1>;
    var local_2: array<u32, 1>;
    var local_3: array<u32, 1>;
    var local_4: array<u32, 1>;
    var local_5: array<u32, 1>;
    var local_6: array<u32, 1>;
    var local_7: array<u32, 1>;
    var local_8: array<u32, 1>;
    var local_9: array<u32, 1>;
    var local_10: array<u32, 1>;
    var local_11: array<u32, 1>;
    var local_12: array<u32, 1>;
    var local_13: array<u32, 1>;
    var local_14: array<u32, 1>;
    var local_15: array<u32, 1>;
    var local_16: lt_mask_Window_5_;
    var local_17: lt_mask_Window_5_;
    var phi_119_: u32;
    var phi_126_: bool;
    var phi_152_: u32;
    var phi_158_: u32;
    var phi_172_: u32;
    var phi_178_: u32;
    var phi_205_: u32;
    var phi_234_: u32;
    var phi_274_: u32;
    var phi_275_: u32;
    var phi_292_: u32;
    var phi_293_: u32;
    var phi_328_: u32;
    var phi_329_: u32;
    var phi_346_: u32;
    var phi_347_: u32;
    var phi_159_: u32;
    var phi_381_: u32;
    var phi_391_: u32;
    var phi_410_: u32;
    var phi_411_: u32;
    var phi_392_: u32;
    var phi_382_: u32;
    var phi_466_: u32;
    var phi_476_: u32;
    var phi_495_: u32;
    var phi_496_: u32;
    var phi_477_: u32;
    var phi_467_: u32;
    var phi_545_: u32;
    var phi_546_: u32;
    var phi_588_: u32;
    var phi_598_: u32;
    var phi_617_: u32;
    var phi_618_: u32;
    var phi_599_: u32;
    var phi_589_: u32;
    var phi_673_: u32;
    var phi_683_: u32;
    var phi_702_: u32;
    var phi_703_: u32;
    var phi_684_: u32;
    var phi_674_: u32;
    var phi_752_: u32;
    var phi_753_: u32;
    var phi_797_: bool;
    var phi_805_: u32;
    var phi_815_: u32;
    var phi_834_: u32;
    var phi_835_: u32;
    var phi_816_: u32;
    var phi_806_: u32;
    var phi_890_: u32;
    var phi_900_: u32;
    var phi_919_: u32;
    var phi_920_: u32;
    var phi_901_: u32;
    var phi_891_: u32;
    var phi_969_: u32;
    var phi_970_: u32;
    var phi_1012_: u32;
    var phi_1022_: u32;
    var phi_1041_: u32;
    var phi_1042_: u32;
    var phi_1023_: u32;
    var phi_1013_: u32;
    var phi_1097_: u32;
    var phi_1107_: u32;
    var phi_1126_: u32;
    var phi_1127_: u32;
    var phi_1108_: u32;
    var phi_1098_: u32;
    var phi_1176_: u32;
    var phi_1177_: u32;
    var phi_1217_: vec4<u32>;
    var phi_1236_: u32;

    let _e42 = id_1;
    let _e46 = arrayLength((&rows.member));
    let _e49 = arrayLength((&words.member));
    let _e53 = p.member.current.size[0u];
    let _e57 = p.member.current.size[1u];
    if (32u == 0u) {
        return;
    }
    let _e60 = (_e53 / 32u);
    if (32u == 0u) {
        return;
    }
    if ((_e53 % 32u) > 0u) {
        phi_119_ = (_e60 + 1u);
    } else {
        phi_119_ = _e60;
    }
    let _e66 = phi_119_;
    if (_e42.x < _e66) {
        phi_126_ = (_e42.y < _e57);
    } else {
        phi_126_ = false;
    }
    let _e71 = phi_126_;
    if _e71 {
        let _e79 = p.member.current.size[0u];
        if (32u == 0u) {
            return;
        }
        let _e81 = (_e79 / 32u);
        if (32u == 0u) {
            return;
        }
        if ((_e79 % 32u) > 0u) {
            phi_152_ = (_e81 + 1u);
        } else {
            phi_152_ = _e81;
        }
        let _e87 = phi_152_;
        let _e91 = p.member.current.size[1u];
        let _e92 = (_e91 - 1u);
        local_16 = lt_mask_Window_5_(array<u32, 5>(0u, 0u, 0u, 0u, 0u), array<u32, 5>(0u, 0u, 0u, 0u, 0u));
        local_17 = lt_mask_Window_5_(array<u32, 5>(0u, 0u, 0u, 0u, 0u), array<u32, 5>(0u, 0u, 0u, 0u, 0u));
        phi_158_ = 0u;
        loop {
            let _e94 = phi_158_;
            let _e95 = (_e94 <= 4u);
            if _e95 {
                let _e96 = (_e42.y + _e94);
                if (2u < _e96) {
                    phi_172_ = _e96;
                } else {
                    phi_172_ = 2u;
                }
                let _e99 = phi_172_;
                let _e100 = (_e99 - 2u);
                if (_e92 < _e100) {
                    phi_178_ = _e92;
                } else {
                    phi_178_ = _e100;
                }
                let _e103 = phi_178_;
                let _e104 = (_e103 * _e87);
                let _e105 = (_e104 + _e42.x);
                if (_e105 < _e46) {
                } else {
                    return;
                }
                let _e110 = rows.member[(0u + _e105)][0u];
                let _e114 = rows.member[(0u + _e105)][1u];
                if (1u < _e42.x) {
                    phi_205_ = _e42.x;
                } else {
                    phi_205_ = 1u;
                }
                let _e125 = phi_205_;
                let _e127 = ((_e104 + _e125) - 1u);
                if (_e127 < _e46) {
                } else {
                    return;
                }
                let _e132 = rows.member[(0u + _e127)][0u];
                let _e136 = rows.member[(0u + _e127)][1u];
                let _e145 = (_e42.x + 1u);
                let _e146 = (_e87 - 1u);
                if (_e146 < _e145) {
                    phi_234_ = _e146;
                } else {
                    phi_234_ = _e145;
                }
                let _e149 = phi_234_;
                let _e150 = (_e104 + _e149);
                if (_e150 < _e46) {
                } else {
                    return;
                }
                let _e155 = rows.member[(0u + _e150)][0u];
                let _e159 = rows.member[(0u + _e150)][1u];
                let _e168 = (_e42.x == 0u);
                let _e170 = ((_e42.x + 1u) == _e87);
                if _e168 {
                    let _e173 = (4294967294u << bitcast<u32>((0u & 31u)));
                    if (((_e132 >> bitcast<u32>((0u & 31u))) & 1u) == 0u) {
                        phi_274_ = (_e132 & ~(_e173));
                    } else {
                        phi_274_ = (_e132 | _e173);
                    }
                    let _e183 = phi_274_;
                    phi_275_ = _e183;
                } else {
                    phi_275_ = _e132;
                }
                let _e185 = phi_275_;
                if _e170 {
                    let _e187 = (_e155 >> bitcast<u32>(31i));
                    let _e190 = (4294967294u << bitcast<u32>((0u & 31u)));
                    if (((_e187 >> bitcast<u32>((0u & 31u))) & 1u) == 0u) {
                        phi_292_ = (_e187 & ~(_e190));
                    } else {
                        phi_292_ = (_e187 | _e190);
                    }
                    let _e200 = phi_292_;
                    phi_293_ = _e200;
                } else {
                    phi_293_ = _e155;
                }
                let _e202 = phi_293_;
                if (_e94 < 5u) {
                } else {
                    return;
                }
                local_16.low[(0u + _e94)] = ((_e110 << bitcast<u32>(2u)) | (_e185 >> bitcast<u32>(30u)));
                if (_e94 < 5u) {
                } else {
                    return;
                }
                local_16.high[(0u + _e94)] = ((_e110 >> bitcast<u32>(30u)) | (_e202 << bitcast<u32>(2u)));
                if _e168 {
                    let _e223 = (4294967294u << bitcast<u32>((0u & 31u)));
                    if (((_e136 >> bitcast<u32>((0u & 31u))) & 1u) == 0u) {
                        phi_328_ = (_e136 & ~(_e223));
                    } else {
                        phi_328_ = (_e136 | _e223);
                    }
                    let _e233 = phi_328_;
                    phi_329_ = _e233;
                } else {
                    phi_329_ = _e136;
                }
                let _e235 = phi_329_;
                if _e170 {
                    let _e237 = (_e159 >> bitcast<u32>(31i));
                    let _e240 = (4294967294u << bitcast<u32>((0u & 31u)));
                    if (((_e237 >> bitcast<u32>((0u & 31u))) & 1u) == 0u) {
                        phi_346_ = (_e237 & ~(_e240));
                    } else {
                        phi_346_ = (_e237 | _e240);
                    }
                    let _e250 = phi_346_;
                    phi_347_ = _e250;
                } else {
                    phi_347_ = _e159;
                }
                let _e252 = phi_347_;
                if (_e94 < 5u) {
                } else {
                    return;
                }
                local_17.low[(0u + _e94)] = ((_e114 << bitcast<u32>(2u)) | (_e235 >> bitcast<u32>(30u)));
                if (_e94 < 5u) {
                } else {
                    return;
                }
                local_17.high[(0u + _e94)] = ((_e114 >> bitcast<u32>(30u)) | (_e252 << bitcast<u32>(2u)));
                phi_159_ = (_e94 + 1u);
            } else {
                phi_159_ = u32();
            }
            let _e273 = phi_159_;
            continue;
            continuing {
                phi_158_ = _e273;
                break if !(_e95);
            }
        }
        let _e277 = p.member.still[0u];
        let _e279 = p.member.still[1u];
        let _e282 = p.member.moving[0u];
        let _e284 = p.member.moving[1u];
        local_15[0u] = array<u32, 1>(0u)[0];
        phi_381_ = 0u;
        loop {
            let _e288 = phi_381_;
            let _e289 = (_e288 < 5u);
            if _e289 {
                phi_391_ = 0u;
                loop {
                    let _e291 = phi_391_;
                    let _e292 = (_e291 < 5u);
                    if _e292 {
                        if (((_e277 >> bitcast<u32>((((_e288 * 5u) + _e291) & 31u))) & 1u) == 0u) {
                        } else {
                            phi_410_ = 0u;
                            loop {
                                let _e301 = phi_410_;
                                let _e302 = (_e301 < 1u);
                                if _e302 {
                                    let _e303 = (_e301 + _e288);
                                    if (_e303 < 5u) {
                                    } else {
                                        return;
                                    }
                                    let _e308 = local_16.low[(0u + _e303)];
                                    let _e309 = (_e301 + _e288);
                                    if (_e309 < 5u) {
                                    } else {
                                        return;
                                    }
                                    let _e314 = local_16.high[(0u + _e309)];
                                    if (_e301 < 1u) {
                                    } else {
                                        return;
                                    }
                                    let _e330 = local_15[(0u + _e301)];
                                    local_15[(0u + _e301)] = (_e330 | ((_e308 >> bitcast<u32>((_e291 & 31u))) | ((_e314 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e291) & 31u)))));
                                    phi_411_ = (_e301 + 1u);
                                } else {
                                    phi_411_ = u32();
                                }
                                let _e334 = phi_411_;
                                continue;
                                continuing {
                                    phi_410_ = _e334;
                                    break if !(_e302);
                                }
                            }
                        }
                        phi_392_ = (_e291 + 1u);
                    } else {
                        phi_392_ = u32();
                    }
                    let _e338 = phi_392_;
                    continue;
                    continuing {
                        phi_391_ = _e338;
                        break if !(_e292);
                    }
                }
                phi_382_ = (_e288 + 1u);
            } else {
                phi_382_ = u32();
            }
            let _e342 = phi_382_;
            continue;
            continuing {
                phi_381_ = _e342;
                break if !(_e289);
            }
        }
        let _e345 = local_15[0u];
        local_13[0u] = _e345;
        if (_e277 != _e279) {
            local_12[0u] = array<u32, 1>(0u)[0];
            phi_466_ = 0u;
            loop {
                let _e351 = phi_466_;
                let _e352 = (_e351 < 5u);
                if _e352 {
                    phi_476_ = 0u;
                    loop {
                        let _e354 = phi_476_;
                        let _e355 = (_e354 < 5u);
                        if _e355 {
                            if (((_e279 >> bitcast<u32>((((_e351 * 5u) + _e354) & 31u))) & 1u) == 0u) {
                            } else {
                                phi_495_ = 0u;
                                loop {
                                    let _e364 = phi_495_;
                                    let _e365 = (_e364 < 1u);
                                    if _e365 {
                                        let _e366 = (_e364 + _e351);
                                        if (_e366 < 5u) {
                                        } else {
                                            return;
                                        }
                                        let _e371 = local_16.low[(0u + _e366)];
                                        let _e372 = (_e364 + _e351);
                                        if (_e372 < 5u) {
                                        } else {
                                            return;
                                        }
                                        let _e377 = local_16.high[(0u + _e372)];
                                        if (_e364 < 1u) {
                                        } else {
                                            return;
                                        }
                                        let _e393 = local_12[(0u + _e364)];
                                        local_12[(0u + _e364)] = (_e393 | ((_e371 >> bitcast<u32>((_e354 & 31u))) | ((_e377 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e354) & 31u)))));
                                        phi_496_ = (_e364 + 1u);
                                    } else {
                                        phi_496_ = u32();
                                    }
                                    let _e397 = phi_496_;
                                    continue;
                                    continuing {
                                        phi_495_ = _e397;
                                        break if !(_e365);
                                    }
                                }
                            }
                            phi_477_ = (_e354 + 1u);
                        } else {
                            phi_477_ = u32();
                        }
                        let _e401 = phi_477_;
                        continue;
                        continuing {
                            phi_476_ = _e401;
                            break if !(_e355);
                        }
                    }
                    phi_467_ = (_e351 + 1u);
                } else {
                    phi_467_ = u32();
                }
                let _e405 = phi_467_;
                continue;
                continuing {
                    phi_466_ = _e405;
                    break if !(_e352);
                }
            }
            let _e408 = local_12[0u];
            local_14[0u] = _e408;
            phi_545_ = 0u;
            loop {
                let _e411 = phi_545_;
                let _e412 = (_e411 < 1u);
                if _e412 {
                    let _e417 = (1431655765u << bitcast<u32>((((_e42.y + _e411) & 1u) & 31u)));
                    if (_e411 < 1u) {
                    } else {
                        return;
                    }
                    let _e421 = local_13[(0u + _e411)];
                    if (_e411 < 1u) {
                    } else {
                        return;
                    }
                    let _e426 = local_14[(0u + _e411)];
                    if (_e411 < 1u) {
                    } else {
                        return;
                    }
                    local_13[(0u + _e411)] = ((_e421 & _e417) | (_e426 & ~(_e417)));
                    phi_546_ = (_e411 + 1u);
                } else {
                    phi_546_ = u32();
                }
                let _e435 = phi_546_;
                continue;
                continuing {
                    phi_545_ = _e435;
                    break if !(_e412);
                }
            }
        }
        let _e438 = local_13[0u];
        local_11[0u] = array<u32, 1>(0u)[0];
        phi_588_ = 0u;
        loop {
            let _e442 = phi_588_;
            let _e443 = (_e442 < 5u);
            if _e443 {
                phi_598_ = 0u;
                loop {
                    let _e445 = phi_598_;
                    let _e446 = (_e445 < 5u);
                    if _e446 {
                        if (((_e277 >> bitcast<u32>((((_e442 * 5u) + _e445) & 31u))) & 1u) == 0u) {
                        } else {
                            phi_617_ = 0u;
                            loop {
                                let _e455 = phi_617_;
                                let _e456 = (_e455 < 1u);
                                if _e456 {
                                    let _e457 = (_e455 + _e442);
                                    if (_e457 < 5u) {
                                    } else {
                                        return;
                                    }
                                    let _e462 = local_17.low[(0u + _e457)];
                                    let _e463 = (_e455 + _e442);
                                    if (_e463 < 5u) {
                                    } else {
                                        return;
                                    }
                                    let _e468 = local_17.high[(0u + _e463)];
                                    if (_e455 < 1u) {
                                    } else {
                                        return;
                                    }
                                    let _e484 = local_11[(0u + _e455)];
                                    local_11[(0u + _e455)] = (_e484 | ((_e462 >> bitcast<u32>((_e445 & 31u))) | ((_e468 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e445) & 31u)))));
                                    phi_618_ = (_e455 + 1u);
                                } else {
                                    phi_618_ = u32();
                                }
                                let _e488 = phi_618_;
                                continue;
                                continuing {
                                    phi_617_ = _e488;
                                    break if !(_e456);
                                }
                            }
                        }
                        phi_599_ = (_e445 + 1u);
                    } else {
                        phi_599_ = u32();
                    }
                    let _e492 = phi_599_;
                    continue;
                    continuing {
                        phi_598_ = _e492;
                        break if !(_e446);
                    }
                }
                phi_589_ = (_e442 + 1u);
            } else {
                phi_589_ = u32();
            }
            let _e496 = phi_589_;
            continue;
            continuing {
                phi_588_ = _e496;
                break if !(_e443);
            }
        }
        let _e499 = local_11[0u];
        local_9[0u] = _e499;
        if (_e277 != _e279) {
            local_8[0u] = array<u32, 1>(0u)[0];
            phi_673_ = 0u;
            loop {
                let _e505 = phi_673_;
                let _e506 = (_e505 < 5u);
                if _e506 {
                    phi_683_ = 0u;
                    loop {
                        let _e508 = phi_683_;
                        let _e509 = (_e508 < 5u);
                        if _e509 {
                            if (((_e279 >> bitcast<u32>((((_e505 * 5u) + _e508) & 31u))) & 1u) == 0u) {
                            } else {
                                phi_702_ = 0u;
                                loop {
                                    let _e518 = phi_702_;
                                    let _e519 = (_e518 < 1u);
                                    if _e519 {
                                        let _e520 = (_e518 + _e505);
                                        if (_e520 < 5u) {
                                        } else {
                                            return;
                                        }
                                        let _e525 = local_17.low[(0u + _e520)];
                                        let _e526 = (_e518 + _e505);
                                        if (_e526 < 5u) {
                                        } else {
                                            return;
                                        }
                                        let _e531 = local_17.high[(0u + _e526)];
                                        if (_e518 < 1u) {
                                        } else {
                                            return;
                                        }
                                        let _e547 = local_8[(0u + _e518)];
                                        local_8[(0u + _e518)] = (_e547 | ((_e525 >> bitcast<u32>((_e508 & 31u))) | ((_e531 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e508) & 31u)))));
                                        phi_703_ = (_e518 + 1u);
                                    } else {
                                        phi_703_ = u32();
                                    }
                                    let _e551 = phi_703_;
                                    continue;
                                    continuing {
                                        phi_702_ = _e551;
                                        break if !(_e519);
                                    }
                                }
                            }
                            phi_684_ = (_e508 + 1u);
                        } else {
                            phi_684_ = u32();
                        }
                        let _e555 = phi_684_;
                        continue;
                        continuing {
                            phi_683_ = _e555;
                            break if !(_e509);
                        }
                    }
                    phi_674_ = (_e505 + 1u);
                } else {
                    phi_674_ = u32();
                }
                let _e559 = phi_674_;
                continue;
                continuing {
                    phi_673_ = _e559;
                    break if !(_e506);
                }
            }
            let _e562 = local_8[0u];
            local_10[0u] = _e562;
            phi_752_ = 0u;
            loop {
                let _e565 = phi_752_;
                let _e566 = (_e565 < 1u);
                if _e566 {
                    let _e571 = (1431655765u << bitcast<u32>((((_e42.y + _e565) & 1u) & 31u)));
                    if (_e565 < 1u) {
                    } else {
                        return;
                    }
                    let _e575 = local_9[(0u + _e565)];
                    if (_e565 < 1u) {
                    } else {
                        return;
                    }
                    let _e580 = local_10[(0u + _e565)];
                    if (_e565 < 1u) {
                    } else {
                        return;
                    }
                    local_9[(0u + _e565)] = ((_e575 & _e571) | (_e580 & ~(_e571)));
                    phi_753_ = (_e565 + 1u);
                } else {
                    phi_753_ = u32();
                }
                let _e589 = phi_753_;
                continue;
                continuing {
                    phi_752_ = _e589;
                    break if !(_e566);
                }
            }
        }
        let _e592 = local_9[0u];
        if (_e277 == _e282) {
            phi_797_ = (_e279 == _e284);
        } else {
            phi_797_ = false;
        }
        let _e596 = phi_797_;
        if _e596 {
            phi_1217_ = vec4<u32>(_e438, _e592, _e438, _e592);
        } else {
            local_7[0u] = array<u32, 1>(0u)[0];
            phi_805_ = 0u;
            loop {
                let _e601 = phi_805_;
                let _e602 = (_e601 < 5u);
                if _e602 {
                    phi_815_ = 0u;
                    loop {
                        let _e604 = phi_815_;
                        let _e605 = (_e604 < 5u);
                        if _e605 {
                            if (((_e282 >> bitcast<u32>((((_e601 * 5u) + _e604) & 31u))) & 1u) == 0u) {
                            } else {
                                phi_834_ = 0u;
                                loop {
                                    let _e614 = phi_834_;
                                    let _e615 = (_e614 < 1u);
                                    if _e615 {
                                        let _e616 = (_e614 + _e601);
                                        if (_e616 < 5u) {
                                        } else {
                                            return;
                                        }
                                        let _e621 = local_16.low[(0u + _e616)];
                                        let _e622 = (_e614 + _e601);
                                        if (_e622 < 5u) {
                                        } else {
                                            return;
                                        }
                                        let _e627 = local_16.high[(0u + _e622)];
                                        if (_e614 < 1u) {
                                        } else {
                                            return;
                                        }
                                        let _e643 = local_7[(0u + _e614)];
                                        local_7[(0u + _e614)] = (_e643 | ((_e621 >> bitcast<u32>((_e604 & 31u))) | ((_e627 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e604) & 31u)))));
                                        phi_835_ = (_e614 + 1u);
                                    } else {
                                        phi_835_ = u32();
                                    }
                                    let _e647 = phi_835_;
                                    continue;
                                    continuing {
                                        phi_834_ = _e647;
                                        break if !(_e615);
                                    }
                                }
                            }
                            phi_816_ = (_e604 + 1u);
                        } else {
                            phi_816_ = u32();
                        }
                        let _e651 = phi_816_;
                        continue;
                        continuing {
                            phi_815_ = _e651;
                            break if !(_e605);
                        }
                    }
                    phi_806_ = (_e601 + 1u);
                } else {
                    phi_806_ = u32();
                }
                let _e655 = phi_806_;
                continue;
                continuing {
                    phi_805_ = _e655;
                    break if !(_e602);
                }
            }
            let _e658 = local_7[0u];
            local_5[0u] = _e658;
            if (_e282 != _e284) {
                local_4[0u] = array<u32, 1>(0u)[0];
                phi_890_ = 0u;
                loop {
                    let _e664 = phi_890_;
                    let _e665 = (_e664 < 5u);
                    if _e665 {
                        phi_900_ = 0u;
                        loop {
                            let _e667 = phi_900_;
                            let _e668 = (_e667 < 5u);
                            if _e668 {
                                if (((_e284 >> bitcast<u32>((((_e664 * 5u) + _e667) & 31u))) & 1u) == 0u) {
                                } else {
                                    phi_919_ = 0u;
                                    loop {
                                        let _e677 = phi_919_;
                                        let _e678 = (_e677 < 1u);
                                        if _e678 {
                                            let _e679 = (_e677 + _e664);
                                            if (_e679 < 5u) {
                                            } else {
                                                return;
                                            }
                                            let _e684 = local_16.low[(0u + _e679)];
                                            let _e685 = (_e677 + _e664);
                                            if (_e685 < 5u) {
                                            } else {
                                                return;
                                            }
                                            let _e690 = local_16.high[(0u + _e685)];
                                            if (_e677 < 1u) {
                                            } else {
                                                return;
                                            }
                                            let _e706 = local_4[(0u + _e677)];
                                            local_4[(0u + _e677)] = (_e706 | ((_e684 >> bitcast<u32>((_e667 & 31u))) | ((_e690 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e667) & 31u)))));
                                            phi_920_ = (_e677 + 1u);
                                        } else {
                                            phi_920_ = u32();
                                        }
                                        let _e710 = phi_920_;
                                        continue;
                                        continuing {
                                            phi_919_ = _e710;
                                            break if !(_e678);
                                        }
                                    }
                                }
                                phi_901_ = (_e667 + 1u);
                            } else {
                                phi_901_ = u32();
                            }
                            let _e714 = phi_901_;
                            continue;
                            continuing {
                                phi_900_ = _e714;
                                break if !(_e668);
                            }
                        }
                        phi_891_ = (_e664 + 1u);
                    } else {
                        phi_891_ = u32();
                    }
                    let _e718 = phi_891_;
                    continue;
                    continuing {
                        phi_890_ = _e718;
                        break if !(_e665);
                    }
                }
                let _e721 = local_4[0u];
                local_6[0u] = _e721;
                phi_969_ = 0u;
                loop {
                    let _e724 = phi_969_;
                    let _e725 = (_e724 < 1u);
                    if _e725 {
                        let _e730 = (1431655765u << bitcast<u32>((((_e42.y + _e724) & 1u) & 31u)));
                        if (_e724 < 1u) {
                        } else {
                            return;
                        }
                        let _e734 = local_5[(0u + _e724)];
                        if (_e724 < 1u) {
                        } else {
                            return;
                        }
                        let _e739 = local_6[(0u + _e724)];
                        if (_e724 < 1u) {
                        } else {
                            return;
                        }
                        local_5[(0u + _e724)] = ((_e734 & _e730) | (_e739 & ~(_e730)));
                        phi_970_ = (_e724 + 1u);
                    } else {
                        phi_970_ = u32();
                    }
                    let _e748 = phi_970_;
                    continue;
                    continuing {
                        phi_969_ = _e748;
                        break if !(_e725);
                    }
                }
            }
            let _e751 = local_5[0u];
            local_3[0u] = array<u32, 1>(0u)[0];
            phi_1012_ = 0u;
            loop {
                let _e755 = phi_1012_;
                let _e756 = (_e755 < 5u);
                if _e756 {
                    phi_1022_ = 0u;
                    loop {
                        let _e758 = phi_1022_;
                        let _e759 = (_e758 < 5u);
                        if _e759 {
                            if (((_e282 >> bitcast<u32>((((_e755 * 5u) + _e758) & 31u))) & 1u) == 0u) {
                            } else {
                                phi_1041_ = 0u;
                                loop {
                                    let _e768 = phi_1041_;
                                    let _e769 = (_e768 < 1u);
                                    if _e769 {
                                        let _e770 = (_e768 + _e755);
                                        if (_e770 < 5u) {
                                        } else {
                                            return;
                                        }
                                        let _e775 = local_17.low[(0u + _e770)];
                                        let _e776 = (_e768 + _e755);
                                        if (_e776 < 5u) {
                                        } else {
                                            return;
                                        }
                                        let _e781 = local_17.high[(0u + _e776)];
                                        if (_e768 < 1u) {
                                        } else {
                                            return;
                                        }
                                        let _e797 = local_3[(0u + _e768)];
                                        local_3[(0u + _e768)] = (_e797 | ((_e775 >> bitcast<u32>((_e758 & 31u))) | ((_e781 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e758) & 31u)))));
                                        phi_1042_ = (_e768 + 1u);
                                    } else {
                                        phi_1042_ = u32();
                                    }
                                    let _e801 = phi_1042_;
                                    continue;
                                    continuing {
                                        phi_1041_ = _e801;
                                        break if !(_e769);
                                    }
                                }
                            }
                            phi_1023_ = (_e758 + 1u);
                        } else {
                            phi_1023_ = u32();
                        }
                        let _e805 = phi_1023_;
                        continue;
                        continuing {
                            phi_1022_ = _e805;
                            break if !(_e759);
                        }
                    }
                    phi_1013_ = (_e755 + 1u);
                } else {
                    phi_1013_ = u32();
                }
                let _e809 = phi_1013_;
                continue;
                continuing {
                    phi_1012_ = _e809;
                    break if !(_e756);
                }
            }
            let _e812 = local_3[0u];
            local_1[0u] = _e812;
            if (_e282 != _e284) {
                local[0u] = array<u32, 1>(0u)[0];
                phi_1097_ = 0u;
                loop {
                    let _e818 = phi_1097_;
                    let _e819 = (_e818 < 5u);
                    if _e819 {
                        phi_1107_ = 0u;
                        loop {
                            let _e821 = phi_1107_;
                            let _e822 = (_e821 < 5u);
                            if _e822 {
                                if (((_e284 >> bitcast<u32>((((_e818 * 5u) + _e821) & 31u))) & 1u) == 0u) {
                                } else {
                                    phi_1126_ = 0u;
                                    loop {
                                        let _e831 = phi_1126_;
                                        let _e832 = (_e831 < 1u);
                                        if _e832 {
                                            let _e833 = (_e831 + _e818);
                                            if (_e833 < 5u) {
                                            } else {
                                                return;
                                            }
                                            let _e838 = local_17.low[(0u + _e833)];
                                            let _e839 = (_e831 + _e818);
                                            if (_e839 < 5u) {
                                            } else {
                                                return;
                                            }
                                            let _e844 = local_17.high[(0u + _e839)];
                                            if (_e831 < 1u) {
                                            } else {
                                                return;
                                            }
                                            let _e860 = local[(0u + _e831)];
                                            local[(0u + _e831)] = (_e860 | ((_e838 >> bitcast<u32>((_e821 & 31u))) | ((_e844 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e821) & 31u)))));
                                            phi_1127_ = (_e831 + 1u);
                                        } else {
                                            phi_1127_ = u32();
                                        }
                                        let _e864 = phi_1127_;
                                        continue;
                                        continuing {
                                            phi_1126_ = _e864;
                                            break if !(_e832);
                                        }
                                    }
                                }
                                phi_1108_ = (_e821 + 1u);
                            } else {
                                phi_1108_ = u32();
                            }
                            let _e868 = phi_1108_;
                            continue;
                            continuing {
                                phi_1107_ = _e868;
                                break if !(_e822);
                            }
                        }
                        phi_1098_ = (_e818 + 1u);
                    } else {
                        phi_1098_ = u32();
                    }
                    let _e872 = phi_1098_;
                    continue;
                    continuing {
                        phi_1097_ = _e872;
                        break if !(_e819);
                    }
                }
                let _e875 = local[0u];
                local_2[0u] = _e875;
                phi_1176_ = 0u;
                loop {
                    let _e878 = phi_1176_;
                    let _e879 = (_e878 < 1u);
                    if _e879 {
                        let _e884 = (1431655765u << bitcast<u32>((((_e42.y + _e878) & 1u) & 31u)));
                        if (_e878 < 1u) {
                        } else {
                            return;
                        }
                        let _e888 = local_1[(0u + _e878)];
                        if (_e878 < 1u) {
                        } else {
                            return;
                        }
                        let _e893 = local_2[(0u + _e878)];
                        if (_e878 < 1u) {
                        } else {
                            return;
                        }
                        local_1[(0u + _e878)] = ((_e888 & _e884) | (_e893 & ~(_e884)));
                        phi_1177_ = (_e878 + 1u);
                    } else {
                        phi_1177_ = u32();
                    }
                    let _e902 = phi_1177_;
                    continue;
                    continuing {
                        phi_1176_ = _e902;
                        break if !(_e879);
                    }
                }
            }
            let _e905 = local_1[0u];
            phi_1217_ = vec4<u32>(_e438, _e592, _e751, _e905);
        }
        let _e908 = phi_1217_;
        let _e912 = p.member.current.size[0u];
        if (32u == 0u) {
            return;
        }
        let _e914 = (_e912 / 32u);
        if (32u == 0u) {
            return;
        }
        if ((_e912 % 32u) > 0u) {
            phi_1236_ = (_e914 + 1u);
        } else {
            phi_1236_ = _e914;
        }
        let _e920 = phi_1236_;
        let _e922 = ((_e42.y * _e920) + _e42.x);
        if (_e922 < _e46) {
        } else {
            return;
        }
        let _e935 = rows.member[(0u + _e922)][2u];
        let _e939 = rows.member[(0u + _e922)][3u];
        let _e940 = (_e922 * 6u);
        if (_e940 < _e49) {
        } else {
            return;
        }
        words.member[(0u + _e940)] = _e908.x;
        let _e946 = (_e940 + 1u);
        if (_e946 < _e49) {
        } else {
            return;
        }
        words.member[(0u + _e946)] = _e908.y;
        let _e951 = (_e940 + 2u);
        if (_e951 < _e49) {
        } else {
            return;
        }
        words.member[(0u + _e951)] = _e908.z;
        let _e956 = (_e940 + 3u);
        if (_e956 < _e49) {
        } else {
            return;
        }
        words.member[(0u + _e956)] = _e908.w;
        let _e960 = (_e940 + 4u);
        if (_e960 < _e49) {
        } else {
            return;
        }
        words.member[(0u + _e960)] = _e935;
        let _e964 = (_e940 + 5u);
        if (_e964 < _e49) {
        } else {
            return;
        }
        words.member[(0u + _e964)] = _e939;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_neighbours_neighbours_hear_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
