//! The cases that the numerics page demands by name.

use lt_math::glam::{Vec2, Vec4};
use lt_math::{
    Esm, Evsm, LTT_EPSILON, MAX_EVSM_EXPONENT, MAX_EVSM_EXPONENT_F16, MsmHamburger, MsmHausdorff, Pcf,
    ShadowTest, Sm, Vsm, bilinear_footprint, needs_ray,
};

const QUARTERS: Vec4 = Vec4::splat(0.25);

/// The gather path of every kind: SM, PCF, VSM, ESM, EVSM, Hamburger, Hausdorff.
fn all(z: Vec4, w: Vec4, d: f32) -> [f32; 7] {
    [
        Sm::default().visibility_of_gather(z, w, d),
        Pcf::default().visibility_of_gather(z, w, d),
        Vsm::default().visibility_of_gather(z, w, d),
        Esm::default().visibility_of_gather(z, w, d),
        Evsm::default().visibility_of_gather(z, w, d),
        MsmHamburger::default().visibility_of_gather(z, w, d),
        MsmHausdorff::default().visibility_of_gather(z, w, d),
    ]
}

/// Lit, or honestly in doubt: never a confident shadow.
fn is_not_dark(v: f32) -> bool {
    v > 1.0 - LTT_EPSILON || needs_ray(v, LTT_EPSILON)
}

#[test]
fn a_receiver_in_its_own_caster_is_never_confidently_dark() {
    for i in 0..=1000 {
        let z = i as f32 / 1000.0;
        for d in [z, (z + 1e-7).min(1.0), z.next_up().min(1.0), z.next_down().max(0.0)] {
            let v = all(Vec4::splat(z), QUARTERS, d);
            assert!(v.iter().all(|&v| is_not_dark(v)), "{z} {d} {v:?}");
            // All know the depths exactly and are even sure of it.
            assert!(v.iter().all(|&v| v > 1.0 - LTT_EPSILON), "{z} {d} {v:?}");
        }
    }
}

#[test]
fn a_receiver_at_the_mean_or_nearer_is_lit() {
    let z = Vec4::new(0.25, 0.5, 0.75, 0.5);
    for d in [0.0, 0.25, 0.5] {
        let v = all(z, QUARTERS, d);
        assert_eq!((v[2], v[4] > 0.5), (1.0, true), "{d}");
    }
    assert!(all(z, QUARTERS, 0.0).iter().all(|&v| v > 1.0 - LTT_EPSILON));
}

#[test]
fn a_receiver_at_a_sample_counts_that_sample_as_lit() {
    let z = Vec4::new(0.2, 0.4, 0.6, 0.8);
    for (i, lit) in [1.0, 0.75, 0.5, 0.25].into_iter().enumerate() {
        let v = all(z, QUARTERS, z[i]);
        assert_eq!(Pcf { bias: 0.0 }.visibility_of_gather(z, QUARTERS, z[i]), lit);
        assert!(v[2..].iter().all(|&v| v >= lit - 1e-5), "{i} {v:?}");
    }
}

/// Two layers, one on an end of the range: no other distribution on the range has their moments, so the bound is the lit
/// fraction, however near to the end the receiver is.
#[test]
fn a_layer_on_an_end_of_the_range_is_known_exactly_beside_it() {
    let test = MsmHausdorff::default();
    for w in [0.003, 0.1, 0.4, 0.9] {
        let weights = Vec4::new(w, 0.5 * (1.0 - w), 0.3 * (1.0 - w), 0.2 * (1.0 - w));
        for layer in [0.05, 0.3, 0.53, 0.94] {
            for step in 0..60 {
                let gap = 10.0f32.powf(-5.0 + step as f32 / 15.0);
                let near = Vec4::new(0.0, layer, layer, layer);
                if gap < layer {
                    let v = test.visibility_of_gather(near, weights, gap);
                    assert!((v - (1.0 - w)).abs() < 4e-6, "{w} {layer} {gap}: {v}");
                }
                let far = Vec4::new(1.0, layer, layer, layer);
                if 1.0 - gap > layer + 1e-5 {
                    let v = test.visibility_of_gather(far, weights, 1.0 - gap);
                    assert!((v - w).abs() < 4e-6, "{w} {layer} 1-{gap}: {v}");
                }
            }
        }
    }
}

#[test]
fn a_weight_of_one_sees_one_texel_only() {
    let z = Vec4::new(0.1, 0.3, 0.6, 0.9);
    for i in 0..4 {
        let front = all(z, Vec4::AXES[i], z[i] - 0.09);
        let behind = all(z, Vec4::AXES[i], z[i] + 0.09);
        assert!(front.iter().all(|&v| v > 1.0 - LTT_EPSILON), "{i} {front:?}");
        assert!(behind.iter().all(|&v| v <= LTT_EPSILON), "{i} {behind:?}");
    }
}

#[test]
fn two_layers_one_ulp_apart_are_one_surface() {
    for z in [1e-3f32, 0.1, 0.5, 0.999] {
        let (near, far) = (z, z.next_up());
        let layers = Vec4::new(near, far, near, far);
        for d in [near, far] {
            let v = all(layers, QUARTERS, d);
            assert!(v.iter().all(|&v| is_not_dark(v)), "{z} {v:?}");
        }
        // The pure bound is exact even here: half the footprint is lit at the far layer.
        let pure = Vsm { min_variance: 0.0 }.visibility_of_gather(layers, QUARTERS, far);
        assert_eq!(pure, 0.5, "{z}");
    }
}

#[test]
fn half_a_footprint_of_background_is_in_doubt_not_confidently_lit() {
    for clear in [1.0, 3.4, f32::INFINITY, f32::MAX] {
        let v = all(Vec4::new(0.3, 0.3, clear, clear), QUARTERS, 0.6);
        for (i, v) in v.into_iter().enumerate() {
            match i {
                0 => assert_eq!(v, 0.0),
                2 | 3 => assert_eq!(v, 1.0, "VSM (in front of the mean) and ESM are blind here: {clear}"),
                _ => assert!(needs_ray(v, LTT_EPSILON), "{i} {clear} {v}"),
            }
        }
    }
}

#[test]
fn a_footprint_of_background_is_lit_and_one_of_near_plane_is_shadowed() {
    for d in [1e-3, 0.3, 0.9, 1.0] {
        let lit = all(Vec4::ONE, QUARTERS, d);
        assert!(lit.iter().all(|&v| v > 1.0 - LTT_EPSILON), "{d} {lit:?}");
    }
    for d in [0.1, 0.3, 0.9, 1.0] {
        let dark = all(Vec4::ZERO, QUARTERS, d);
        assert!(dark.iter().all(|&v| v <= LTT_EPSILON), "{d} {dark:?}");
    }
}

#[test]
fn depths_outside_the_range_count_as_its_ends() {
    let w = Vec4::new(0.4, 0.3, 0.2, 0.1);
    let (wild, tame) = (Vec4::new(-5.0, 0.4, 3.4, f32::INFINITY), Vec4::new(0.0, 0.4, 1.0, 1.0));
    for (wild_d, tame_d) in [(0.5, 0.5), (-1.0, 0.0), (2.0, 1.0)] {
        let (a, b) = (all(wild, w, wild_d), all(tame, w, tame_d));
        for (i, (a, b)) in a.into_iter().zip(b).enumerate() {
            assert!(a == b || (a.is_nan() && b.is_nan()), "{i} {a} {b}");
        }
    }
}

#[test]
fn exponents_beyond_the_range_are_clamped_and_stay_finite() {
    let ends = Vec4::new(0.0, 1.0, 0.0, 1.0);
    for exponent in [80.0, 88.0, 160.0, 1e9, f32::INFINITY] {
        let evsm = Evsm { positive_exponent: exponent, negative_exponent: exponent, ..Evsm::default() };
        let esm = Esm { exponent };
        for z in [0.0, 0.5, 1.0] {
            assert!(evsm.depth_vector(z).is_finite() && esm.depth_vector(z).is_finite(), "{exponent} {z}");
            assert!(esm.depth_vector(z).x.is_normal(), "{exponent} {z}");
        }
        for d in [0.0, 0.25, 0.5, 1.0] {
            for v in [
                evsm.visibility_of_gather(ends, QUARTERS, d),
                evsm.visibility(0.5 * (evsm.depth_vector(0.0) + evsm.depth_vector(1.0)), d),
                esm.visibility_of_gather(ends, QUARTERS, d),
                esm.visibility(0.5 * (esm.depth_vector(0.0) + esm.depth_vector(1.0)), d),
            ] {
                assert!((0.5..=1.0).contains(&v), "{exponent} {d} {v}");
            }
        }
    }
}

#[test]
fn exponent_limits_are_what_the_formats_bear() {
    assert!((2.0 * f64::from(MAX_EVSM_EXPONENT)).exp() < f64::from(f32::MAX));
    assert!((2.0 * f64::from(MAX_EVSM_EXPONENT_F16)).exp() < 65504.0);
    // The published false friend: 10 overflows 16 bits.
    assert!((2.0f64 * 10.0).exp() > 65504.0);
}

#[test]
fn doubt_behind_a_flat_blocker_is_as_wide_as_published() {
    let width = |v: &dyn Fn(f32) -> f32| {
        let last = (1..200_000).map(|i| i as f32 * 1e-6).take_while(|&t| v(t) > LTT_EPSILON);
        last.last().unwrap_or(0.0)
    };
    let flat = Vec4::splat(0.5);
    let vsm = width(&|t| Vsm::default().visibility_of_gather(flat, QUARTERS, 0.5 + t));
    let evsm = width(&|t| Evsm::default().visibility_of_gather(flat, QUARTERS, 0.5 + t));
    let esm = width(&|t| Esm::default().visibility_of_gather(flat, QUARTERS, 0.5 + t));
    assert!((0.9e-4..1.1e-4).contains(&vsm), "{vsm}");
    assert!((0.9e-4..1.1e-4).contains(&evsm), "{evsm}");
    assert!((0.055..0.060).contains(&esm), "{esm}");
}

#[test]
fn footprints_sit_on_texel_centres() {
    let at = |x, y| bilinear_footprint(Vec2::new(x, y));
    assert_eq!(at(3.5, 7.5).weights, Vec4::X);
    assert_eq!(at(3.5, 7.5).texel.to_array(), [3, 7]);
    assert_eq!(at(4.0, 8.0).weights, QUARTERS);
    assert_eq!(at(4.0, 8.0).texel.to_array(), [3, 7]);
    assert_eq!(at(4.25, 7.5).weights, Vec4::new(0.25, 0.75, 0.0, 0.0));
    assert_eq!(at(3.5, 8.25).weights, Vec4::new(0.25, 0.0, 0.75, 0.0));
    assert_eq!(at(0.0, 0.0).texel.to_array(), [-1, -1]);
    assert!(at(f32::NAN, 0.0).weights.is_nan());
}

#[test]
fn sm_takes_the_heaviest_texel_and_of_equals_the_first() {
    let sm = Sm { bias: 0.0 };
    for i in 0..4 {
        let mut z = Vec4::ZERO;
        z[i] = 1.0;
        let mut w = Vec4::splat(0.2);
        w[i] = 0.4;
        assert_eq!(sm.visibility_of_gather(z, w, 0.5), 1.0, "{i}");
        assert_eq!(sm.visibility_of_gather(z, QUARTERS, 0.5), if i == 0 { 1.0 } else { 0.0 });
    }
}
