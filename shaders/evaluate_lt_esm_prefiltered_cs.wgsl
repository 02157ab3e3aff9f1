struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
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

struct type_15 {
    member: array<abi_Sample>,
}

struct type_19 {
    member: array<f32>,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct type_31 {
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

struct type_35 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(2) 
var<storage> map: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_150_: lt_bvh_traverse_Tree;
    var phi_151_: bool;
    var phi_152_: lt_bvh_traverse_Tree;
    var phi_153_: bool;
    var phi_158_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_150_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_151_ = false;
        } else {
            phi_150_ = lt_bvh_traverse_Tree();
            phi_151_ = true;
        }
        let _e62 = phi_150_;
        let _e64 = phi_151_;
        phi_152_ = _e62;
        phi_153_ = _e64;
    } else {
        phi_152_ = lt_bvh_traverse_Tree();
        phi_153_ = true;
    }
    let _e66 = phi_152_;
    let _e68 = phi_153_;
    if _e68 {
        phi_158_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_158_ = _e66;
    }
    let _e73 = phi_158_;
    return lt_bvh_traverse_Tree(_e73.root, _e73.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_183_: f32;
    var phi_184_: f32;
    var phi_185_: f32;
    var phi_198_: bool;
    var phi_202_: f32;
    var phi_215_: f32;
    var phi_220_: f32;
    var phi_242_: f32;
    var phi_247_: f32;
    var phi_248_: bool;
    var phi_249_: f32;
    var phi_250_: bool;
    var phi_254_: f32;
    var phi_292_: f32;
    var phi_308_: f32;
    var phi_309_: f32;
    var phi_310_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_185_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_184_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_183_ = 1f;
            } else {
                phi_183_ = param_6;
            }
            let _e58 = phi_183_;
            phi_184_ = _e58;
        }
        let _e60 = phi_184_;
        phi_185_ = _e60;
    }
    let _e62 = phi_185_;
    let _e64 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_198_ = true;
    } else {
        let _e68 = (84f < _e64);
        if _e68 {
        }
        phi_198_ = _e68;
    }
    let _e70 = phi_198_;
    if _e70 {
        phi_202_ = 84f;
    } else {
        phi_202_ = _e64;
    }
    let _e72 = phi_202_;
    let _e74 = (_e72 * (1f - _e62));
    if ((bitcast<u32>(_e74) & 2147483647u) > 2139095040u) {
        phi_292_ = _e74;
    } else {
        if (_e74 < -87f) {
            phi_215_ = -87f;
        } else {
            phi_215_ = _e74;
        }
        let _e80 = phi_215_;
        if (_e80 > 88f) {
            phi_220_ = 88f;
        } else {
            phi_220_ = _e80;
        }
        let _e83 = phi_220_;
        let _e85 = ((_e83 * 1.442695f) + 0.5f);
        if (_e85 > -8388608f) {
            let _e97 = f32(select(0i, select(select(i32(_e85), i32(-2147483648), (_e85 < bitcast<f32>(3472883712u))), 2147483647i, (_e85 > bitcast<f32>(1325400063u))), (_e85 == _e85)));
            if (_e97 > _e85) {
                phi_242_ = 1f;
            } else {
                phi_242_ = 0f;
            }
            let _e100 = phi_242_;
            if (_e85 < 8388608f) {
                phi_247_ = (_e97 - _e100);
                phi_248_ = false;
            } else {
                phi_247_ = f32();
                phi_248_ = true;
            }
            let _e103 = phi_247_;
            let _e105 = phi_248_;
            phi_249_ = _e103;
            phi_250_ = _e105;
        } else {
            phi_249_ = f32();
            phi_250_ = true;
        }
        let _e107 = phi_249_;
        let _e109 = phi_250_;
        if _e109 {
            phi_254_ = _e85;
        } else {
            phi_254_ = _e107;
        }
        let _e111 = phi_254_;
        let _e115 = ((_e83 - (_e111 * 0.69314575f)) - (_e111 * 0.0000014286068f));
        phi_292_ = ((((((((((((((((1f / 5040f) * _e115) + (1f / 720f)) * _e115) + (1f / 120f)) * _e115) + (1f / 24f)) * _e115) + (1f / 6f)) * _e115) + 0.5f) * _e115) + 1f) * _e115) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e111), i32(-2147483648), (_e111 < bitcast<f32>(3472883712u))), 2147483647i, (_e111 > bitcast<f32>(1325400063u))), (_e111 == _e111)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e151 = phi_292_;
    let _e152 = (param_5.x * _e151);
    if ((bitcast<u32>(_e152) & 2147483647u) > 2139095040u) {
        phi_310_ = _e152;
    } else {
        if (_e152 < 0f) {
            phi_309_ = 0f;
        } else {
            if (_e152 > 1f) {
                phi_308_ = 1f;
            } else {
                phi_308_ = _e152;
            }
            let _e159 = phi_308_;
            phi_309_ = _e159;
        }
        let _e161 = phi_309_;
        phi_310_ = _e161;
    }
    let _e163 = phi_310_;
    return _e163;
}

fn function_() {
    var local: f32;
    var phi_366_: bool;
    var phi_367_: bool;
    var phi_368_: bool;
    var phi_369_: bool;
    var phi_373_: bool;
    var phi_443_: bool;
    var phi_444_: bool;
    var phi_455_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_456_: bool;
    var phi_457_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_458_: bool;
    var phi_465_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_469_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_543_: bool;
    var phi_552_: bool;
    var phi_561_: bool;
    var phi_562_: bool;
    var phi_563_: bool;
    var phi_564_: bool;
    var phi_565_: bool;
    var phi_566_: bool;
    var phi_567_: bool;
    var phi_571_: bool;
    var phi_661_: f32;
    var phi_664_: f32;
    var phi_693_: f32;
    var phi_698_: f32;
    var phi_699_: bool;
    var phi_700_: f32;
    var phi_701_: bool;
    var phi_705_: f32;
    var phi_725_: f32;
    var phi_730_: f32;
    var phi_731_: bool;
    var phi_732_: f32;
    var phi_733_: bool;
    var phi_737_: f32;
    var phi_785_: i32;
    var phi_790_: i32;
    var phi_795_: i32;
    var phi_800_: i32;
    var phi_809_: i32;
    var phi_814_: i32;
    var phi_819_: i32;
    var phi_824_: i32;
    var phi_921_: bool;
    var phi_929_: bool;
    var phi_941_: bool;
    var phi_942_: bool;
    var phi_946_: f32;
    var phi_952_: f32;
    var phi_954_: evaluate_Verdict;
    var phi_964_: u32;
    var phi_973_: f32;
    var phi_975_: evaluate_Verdict;
    var phi_976_: bool;
    var phi_977_: evaluate_Verdict;
    var phi_978_: bool;
    var phi_983_: evaluate_Verdict;
    var phi_988_: evaluate_Verdict;
    var phi_989_: evaluate_Verdict;

    let _e50 = id_1;
    let _e57 = arrayLength((&map.member));
    let _e63 = p.member.size[0u];
    let _e65 = p.member.size[1u];
    let _e66 = lt_shaders_entry_pixel_index(_e50, _e63, _e65);
    if (bitcast<i32>(_e66.root) != 0i) {
        let _e72 = p.member.projection;
        if (_e66.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e76 = lt_math_OneLevel(_e72);
        let _e80 = samples.member[(0u + _e66.first_primitive)].normal[0u];
        let _e82 = global[0u];
        if (_e80 == _e82) {
            let _e85 = samples.member[(0u + _e66.first_primitive)].normal[1u];
            let _e87 = global[1u];
            if (_e85 == _e87) {
                let _e90 = samples.member[(0u + _e66.first_primitive)].normal[2u];
                let _e92 = global[2u];
                phi_366_ = (_e90 == _e92);
                phi_367_ = false;
            } else {
                phi_366_ = bool();
                phi_367_ = true;
            }
            let _e95 = phi_366_;
            let _e97 = phi_367_;
            phi_368_ = _e95;
            phi_369_ = _e97;
        } else {
            phi_368_ = bool();
            phi_369_ = true;
        }
        let _e99 = phi_368_;
        let _e101 = phi_369_;
        if _e101 {
            phi_373_ = false;
        } else {
            phi_373_ = _e99;
        }
        let _e103 = phi_373_;
        if !(_e103) {
            let _e106 = samples.member[(0u + _e66.first_primitive)].position;
            let _e108 = p.member.light.place;
            let _e114 = p.member.light.place[3u];
            let _e121 = (_e108.x - (_e106.x * _e114));
            let _e122 = (_e108.y - (_e106.y * _e114));
            let _e123 = (_e108.z - (_e106.z * _e114));
            let _e125 = samples.member[(0u + _e66.first_primitive)].normal;
            if ((((_e125.x * _e121) + (_e125.y * _e122)) + (_e125.z * _e123)) > 0f) {
                let _e139 = (((_e121 * _e121) + (_e122 * _e122)) + (_e123 * _e123));
                let _e141 = p.member.light.axis;
                let _e153 = p.member.light.place[3u];
                if (_e153 == 0f) {
                    phi_444_ = true;
                } else {
                    let _e156 = p.member.light.range_squared;
                    if (_e139 <= _e156) {
                        let _e159 = p.member.light.cos_outer;
                        phi_443_ = (-((((_e121 * _e141.x) + (_e122 * _e141.y)) + (_e123 * _e141.z))) >= (_e159 * sqrt(_e139)));
                    } else {
                        phi_443_ = false;
                    }
                    let _e164 = phi_443_;
                    phi_444_ = _e164;
                }
                let _e166 = phi_444_;
                if _e166 {
                    let _e168 = samples.member[(0u + _e66.first_primitive)].flags;
                    let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e182 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e176.unnamed.visibility, false), _e176.unnamed_1);
                    phi_455_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e182.unnamed, ((_e168 & 1u) == 0u));
                    phi_456_ = false;
                } else {
                    phi_455_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_456_ = true;
                }
                let _e187 = phi_455_;
                let _e189 = phi_456_;
                phi_457_ = _e187;
                phi_458_ = _e189;
            } else {
                phi_457_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_458_ = true;
            }
            let _e191 = phi_457_;
            let _e193 = phi_458_;
            if _e193 {
                let _e199 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e199.unnamed.visibility, false), _e199.unnamed_1);
                phi_465_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e205.unnamed, true);
            } else {
                phi_465_ = _e191;
            }
            let _e210 = phi_465_;
            phi_469_ = _e210;
        } else {
            let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e216.unnamed.visibility, false), _e216.unnamed_1);
            phi_469_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e222.unnamed, true);
        }
        let _e227 = phi_469_;
        if _e227.unnamed_1 {
            phi_989_ = evaluate_Verdict(_e227.unnamed.visibility, _e227.unnamed.is_doubted);
        } else {
            let _e235 = samples.member[(0u + _e66.first_primitive)].position;
            let _e253 = ((((_e76.projection.row_w.x * _e235.x) + (_e76.projection.row_w.y * _e235.y)) + (_e76.projection.row_w.z * _e235.z)) + (_e76.projection.row_w.w * 1f));
            let _e267 = (((((_e76.projection.row_x.x * _e235.x) + (_e76.projection.row_x.y * _e235.y)) + (_e76.projection.row_x.z * _e235.z)) + (_e76.projection.row_x.w * 1f)) / _e253);
            let _e281 = (((((_e76.projection.row_y.x * _e235.x) + (_e76.projection.row_y.y * _e235.y)) + (_e76.projection.row_y.z * _e235.z)) + (_e76.projection.row_y.w * 1f)) / _e253);
            let _e294 = ((((_e76.projection.row_z.x * _e235.x) + (_e76.projection.row_z.y * _e235.y)) + (_e76.projection.row_z.z * _e235.z)) + (_e76.projection.row_z.w * 1f));
            if (_e253 > 0f) {
                if (_e267 >= 0f) {
                    phi_543_ = (_e267 <= 1f);
                } else {
                    phi_543_ = false;
                }
                let _e299 = phi_543_;
                if _e299 {
                    if (_e281 >= 0f) {
                        phi_552_ = (_e281 <= 1f);
                    } else {
                        phi_552_ = false;
                    }
                    let _e303 = phi_552_;
                    if _e303 {
                        if (_e294 >= 0f) {
                            phi_561_ = (_e294 <= 1f);
                        } else {
                            phi_561_ = false;
                        }
                        let _e307 = phi_561_;
                        phi_562_ = _e307;
                        phi_563_ = false;
                    } else {
                        phi_562_ = bool();
                        phi_563_ = true;
                    }
                    let _e309 = phi_562_;
                    let _e311 = phi_563_;
                    phi_564_ = _e309;
                    phi_565_ = _e311;
                } else {
                    phi_564_ = bool();
                    phi_565_ = true;
                }
                let _e313 = phi_564_;
                let _e315 = phi_565_;
                phi_566_ = _e313;
                phi_567_ = _e315;
            } else {
                phi_566_ = bool();
                phi_567_ = true;
            }
            let _e317 = phi_566_;
            let _e319 = phi_567_;
            if _e319 {
                phi_571_ = false;
            } else {
                phi_571_ = _e317;
            }
            let _e321 = phi_571_;
            if _e321 {
                if (0f > 0f) {
                    let _e324 = samples.member[(0u + _e66.first_primitive)].normal;
                    let _e326 = p.member.map_size;
                    let _e396 = ((abs(((((_e72.row_x.x * _e324.x) + (_e72.row_x.y * _e324.y)) + (_e72.row_x.z * _e324.z)) / (((_e72.row_x.x * _e72.row_x.x) + (_e72.row_x.y * _e72.row_x.y)) + (_e72.row_x.z * _e72.row_x.z)))) + abs(((((_e72.row_y.x * _e324.x) + (_e72.row_y.y * _e324.y)) + (_e72.row_y.z * _e324.z)) / (((_e72.row_y.x * _e72.row_y.x) + (_e72.row_y.y * _e72.row_y.y)) + (_e72.row_y.z * _e72.row_y.z))))) / (abs(((((_e72.row_z.x * _e324.x) + (_e72.row_z.y * _e324.y)) + (_e72.row_z.z * _e324.z)) / (((_e72.row_z.x * _e72.row_z.x) + (_e72.row_z.y * _e72.row_z.y)) + (_e72.row_z.z * _e72.row_z.z)))) * f32(_e326)));
                    if (_e396 < 0.002f) {
                        phi_661_ = _e396;
                    } else {
                        phi_661_ = 0.002f;
                    }
                    let _e399 = phi_661_;
                    phi_664_ = (_e294 - (0f * _e399));
                } else {
                    phi_664_ = _e294;
                }
                let _e403 = phi_664_;
                let _e405 = p.member.map_size;
                let _e406 = f32(_e405);
                let _e409 = ((_e267 * _e406) - 0.5f);
                let _e410 = ((_e281 * _e406) - 0.5f);
                if (_e409 > -8388608f) {
                    let _e422 = f32(select(0i, select(select(i32(_e409), i32(-2147483648), (_e409 < bitcast<f32>(3472883712u))), 2147483647i, (_e409 > bitcast<f32>(1325400063u))), (_e409 == _e409)));
                    if (_e422 > _e409) {
                        phi_693_ = 1f;
                    } else {
                        phi_693_ = 0f;
                    }
                    let _e425 = phi_693_;
                    if (_e409 < 8388608f) {
                        phi_698_ = (_e422 - _e425);
                        phi_699_ = false;
                    } else {
                        phi_698_ = f32();
                        phi_699_ = true;
                    }
                    let _e428 = phi_698_;
                    let _e430 = phi_699_;
                    phi_700_ = _e428;
                    phi_701_ = _e430;
                } else {
                    phi_700_ = f32();
                    phi_701_ = true;
                }
                let _e432 = phi_700_;
                let _e434 = phi_701_;
                if _e434 {
                    phi_705_ = _e409;
                } else {
                    phi_705_ = _e432;
                }
                let _e436 = phi_705_;
                if (_e410 > -8388608f) {
                    let _e448 = f32(select(0i, select(select(i32(_e410), i32(-2147483648), (_e410 < bitcast<f32>(3472883712u))), 2147483647i, (_e410 > bitcast<f32>(1325400063u))), (_e410 == _e410)));
                    if (_e448 > _e410) {
                        phi_725_ = 1f;
                    } else {
                        phi_725_ = 0f;
                    }
                    let _e451 = phi_725_;
                    if (_e410 < 8388608f) {
                        phi_730_ = (_e448 - _e451);
                        phi_731_ = false;
                    } else {
                        phi_730_ = f32();
                        phi_731_ = true;
                    }
                    let _e454 = phi_730_;
                    let _e456 = phi_731_;
                    phi_732_ = _e454;
                    phi_733_ = _e456;
                } else {
                    phi_732_ = f32();
                    phi_733_ = true;
                }
                let _e458 = phi_732_;
                let _e460 = phi_733_;
                if _e460 {
                    phi_737_ = _e410;
                } else {
                    phi_737_ = _e458;
                }
                let _e462 = phi_737_;
                let _e463 = (_e409 - _e436);
                let _e464 = (_e410 - _e462);
                let _e473 = select(0i, select(select(i32(_e436), i32(-2147483648), (_e436 < bitcast<f32>(3472883712u))), 2147483647i, (_e436 > bitcast<f32>(1325400063u))), (_e436 == _e436));
                let _e482 = select(0i, select(select(i32(_e462), i32(-2147483648), (_e462 < bitcast<f32>(3472883712u))), 2147483647i, (_e462 > bitcast<f32>(1325400063u))), (_e462 == _e462));
                let _e485 = ((1f - _e463) * (1f - _e464));
                let _e487 = (_e463 * (1f - _e464));
                let _e489 = ((1f - _e463) * _e464);
                let _e490 = (_e463 * _e464);
                let _e492 = p.member.test;
                let _e493 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e492);
                let _e495 = p.member.map_size;
                local = _e493;
                let _e497 = ((0u * _e495) * _e495);
                let _e499 = (bitcast<i32>(_e495) - 1i);
                if (_e473 > 0i) {
                    phi_785_ = _e473;
                } else {
                    phi_785_ = 0i;
                }
                let _e502 = phi_785_;
                if (_e482 > 0i) {
                    phi_790_ = _e482;
                } else {
                    phi_790_ = 0i;
                }
                let _e505 = phi_790_;
                if (_e502 < _e499) {
                    phi_795_ = _e502;
                } else {
                    phi_795_ = _e499;
                }
                let _e508 = phi_795_;
                if (_e505 < _e499) {
                    phi_800_ = _e505;
                } else {
                    phi_800_ = _e499;
                }
                let _e511 = phi_800_;
                let _e512 = bitcast<u32>(_e508);
                let _e514 = (_e473 + 1i);
                let _e515 = (_e482 + 1i);
                if (_e514 > 0i) {
                    phi_809_ = _e514;
                } else {
                    phi_809_ = 0i;
                }
                let _e518 = phi_809_;
                if (_e515 > 0i) {
                    phi_814_ = _e515;
                } else {
                    phi_814_ = 0i;
                }
                let _e521 = phi_814_;
                if (_e518 < _e499) {
                    phi_819_ = _e518;
                } else {
                    phi_819_ = _e499;
                }
                let _e524 = phi_819_;
                if (_e521 < _e499) {
                    phi_824_ = _e521;
                } else {
                    phi_824_ = _e499;
                }
                let _e527 = phi_824_;
                let _e528 = bitcast<u32>(_e524);
                let _e530 = (bitcast<u32>(_e511) * _e495);
                let _e531 = (bitcast<u32>(_e527) * _e495);
                let _e536 = ((_e530 + _e512) + _e497);
                let _e537 = ((_e530 + _e528) + _e497);
                let _e538 = ((_e531 + _e512) + _e497);
                let _e539 = ((_e531 + _e528) + _e497);
                if (_e536 < _e57) {
                } else {
                    return;
                }
                let _e543 = map.member[(0u + _e536)];
                if (_e537 < _e57) {
                } else {
                    return;
                }
                let _e555 = map.member[(0u + _e537)];
                if (_e538 < _e57) {
                } else {
                    return;
                }
                let _e571 = map.member[(0u + _e538)];
                if (_e539 < _e57) {
                } else {
                    return;
                }
                let _e587 = map.member[(0u + _e539)];
                let _e601 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e543.x * _e485) + (_e555.x * _e487)) + (_e571.x * _e489)) + (_e587.x * _e490)), ((((_e543.y * _e485) + (_e555.y * _e487)) + (_e571.y * _e489)) + (_e587.y * _e490)), ((((_e543.z * _e485) + (_e555.z * _e487)) + (_e571.z * _e489)) + (_e587.z * _e490)), ((((_e543.w * _e485) + (_e555.w * _e487)) + (_e571.w * _e489)) + (_e587.w * _e490))), _e403);
                let _e605 = p.member.epsilon;
                if (_e601 <= _e605) {
                    phi_921_ = true;
                } else {
                    phi_921_ = (_e601 >= (1f - _e605));
                }
                let _e610 = phi_921_;
                if ((bitcast<u32>(_e601) & 2147483647u) > 2139095040u) {
                    phi_929_ = true;
                } else {
                    phi_929_ = !(_e610);
                }
                let _e616 = phi_929_;
                if _e616 {
                    if (_e601 > 0f) {
                        if (_e601 < 1f) {
                            phi_941_ = false;
                        } else {
                            phi_941_ = true;
                        }
                        let _e620 = phi_941_;
                        phi_942_ = _e620;
                    } else {
                        phi_942_ = true;
                    }
                    let _e622 = phi_942_;
                    if _e622 {
                        phi_946_ = 0.5f;
                    } else {
                        phi_946_ = _e601;
                    }
                    let _e624 = phi_946_;
                    phi_954_ = evaluate_Verdict(_e624, true);
                } else {
                    if (_e601 > 0.5f) {
                        phi_952_ = 1f;
                    } else {
                        phi_952_ = 0f;
                    }
                    let _e628 = phi_952_;
                    phi_954_ = evaluate_Verdict(_e628, false);
                }
                let _e631 = phi_954_;
                let _e634 = (_e631.visibility < 0.5f);
                if _e631.is_doubted {
                    phi_977_ = evaluate_Verdict();
                    phi_978_ = true;
                } else {
                    if _e634 {
                        phi_964_ = 2u;
                    } else {
                        phi_964_ = 1u;
                    }
                    let _e636 = phi_964_;
                    if ((0u & _e636) != 0u) {
                        if _e634 {
                            phi_973_ = 0.000000059604645f;
                        } else {
                            phi_973_ = 0.99999994f;
                        }
                        let _e640 = phi_973_;
                        phi_975_ = evaluate_Verdict(_e640, true);
                        phi_976_ = false;
                    } else {
                        phi_975_ = evaluate_Verdict();
                        phi_976_ = true;
                    }
                    let _e643 = phi_975_;
                    let _e645 = phi_976_;
                    phi_977_ = _e643;
                    phi_978_ = _e645;
                }
                let _e647 = phi_977_;
                let _e649 = phi_978_;
                if _e649 {
                    phi_983_ = evaluate_Verdict(_e631.visibility, _e631.is_doubted);
                } else {
                    phi_983_ = _e647;
                }
                let _e652 = phi_983_;
                phi_988_ = evaluate_Verdict(_e652.visibility, _e652.is_doubted);
            } else {
                phi_988_ = evaluate_Verdict(0.5f, true);
            }
            let _e658 = phi_988_;
            phi_989_ = _e658;
        }
        let _e660 = phi_989_;
        if (_e66.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e66.first_primitive)] = _e660.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
