//! Trace or trust: the leak tracing test corrected by last frame's neighbourhood (Kern et al. 2024, §3.1.1–3.1.3).

use crate::bits::MaskBits;
use lt_math::{float, needs_ray};

/// The paper's limit of visibility below which the shadow test says shadow (eq. 4).
pub const SHADOW_TEST_THRESHOLD: f32 = 0.5;

/// How far depths of two frames may differ, relative to the larger, and count as the same surface.
///
/// 10 % as in the paper's reference program.
pub const DEPTH_CONSISTENCY_TOLERANCE: f32 = 0.1;

/// ST (eq. 4): whether a visibility counts as shadow; a NaN does not.
#[inline]
pub fn is_test_shadowed(visibility: f32) -> bool {
    visibility < SHADOW_TEST_THRESHOLD
}

/// ER of one neighbour (eq. 6): (M_LTT ∧ (M_RS ⊕ ST)) ∨ (M_ST ⊕ ST).
///
/// Its ray disagreed with this pixel's shadow test, or its shadow test did.
#[inline]
pub fn expands_ray(neighbour: MaskBits, is_test_shadowed: bool) -> bool {
    (neighbour.is_traced() && neighbour.is_ray_hit() != is_test_shadowed)
        || neighbour.is_test_shadowed() != is_test_shadowed
}

/// RR of one neighbour (eq. 8): (ST = M_ST) ∧ (¬M_LTT ∨ (ST = M_RS)).
///
/// Its shadow test agrees with this pixel's, and so does its ray if there was one.
#[inline]
pub fn removes_ray(neighbour: MaskBits, is_test_shadowed: bool) -> bool {
    neighbour.is_test_shadowed() == is_test_shadowed
        && (!neighbour.is_traced() || neighbour.is_ray_hit() == is_test_shadowed)
}

/// Which neighbours make a trusted pixel trace.
///
/// A `u32` in a coat, so that it may cross to the GPU as a parameter. Unknown numbers act as [`Expansion::PUBLISHED`]. The narrower rules
/// spend their rays where the map is known to be wrong, and are worth a wider [`crate::Pattern`]; what they leave out are edges that
/// shadow tests agree about, which the published rule traces on both sides in every frame.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Expansion(u32);

impl Expansion {
    /// ER as published (eq. 6): [`expands_ray`]. The one that heals a map that was drawn anew, whose shadow tests differ from
    /// the last frame's.
    pub const PUBLISHED: Self = Self(0);
    /// The first half of eq. 6, M_LTT ∧ (M_RS ⊕ ST): its ray disagreed with this pixel's shadow test.
    pub const RAYS: Self = Self(1);
    /// M_LTT ∧ (M_RS ⊕ M_ST) ∧ (M_RS ⊕ ST): its ray found its map wrong, and would find this pixel's wrong as well.
    pub const LEAKS: Self = Self(2);

    /// Every rule, the widest first.
    pub const ALL: [Self; 3] = [Self::PUBLISHED, Self::RAYS, Self::LEAKS];

    /// The rule with this number, as [`Expansion::to_index`] gave it.
    #[inline]
    pub fn from_index(index: u32) -> Self {
        Self(index)
    }

    /// The rule's number.
    #[inline]
    pub fn to_index(self) -> u32 {
        self.0
    }

    /// ER of one neighbour by this rule.
    #[inline]
    pub fn asks(self, neighbour: MaskBits, is_test_shadowed: bool) -> bool {
        let ray_disagrees = neighbour.is_traced() && neighbour.is_ray_hit() != is_test_shadowed;
        match self.0 {
            1 => ray_disagrees,
            2 => ray_disagrees && neighbour.is_ray_hit() != neighbour.is_test_shadowed(),
            _ => expands_ray(neighbour, is_test_shadowed),
        }
    }
}

/// Whether two depths of one surface in successive frames agree within `tolerance`, relative to the larger; NaN does not.
#[inline]
pub fn is_depth_consistent(depth: f32, previous_depth: f32, tolerance: f32) -> bool {
    let difference = (depth - previous_depth).abs();
    let larger = float::max(depth.abs(), previous_depth.abs());
    difference <= tolerance * larger
}

/// What the neighbours of the reprojected pixel say, gathered one at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Neighbourhood {
    /// Any neighbour has ER.
    pub any_expands: bool,
    /// Every neighbour has RR; true of none.
    pub all_remove: bool,
}

impl Neighbourhood {
    /// No neighbour yet.
    pub const EMPTY: Self = Self { any_expands: false, all_remove: true };

    /// Also hears `neighbour`, against this pixel's shadow test; ER by `expansion`, RR by eq. 8.
    #[inline]
    pub fn with(self, neighbour: MaskBits, is_test_shadowed: bool, expansion: Expansion) -> Self {
        Self {
            any_expands: self.any_expands || expansion.asks(neighbour, is_test_shadowed),
            all_remove: self.all_remove && removes_ray(neighbour, is_test_shadowed),
        }
    }
}

/// Everything besides the estimate that bears on one pixel's decision.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Evidence {
    /// The receiver projects onto the light's map; outside, only a ray can tell.
    pub is_on_map: bool,
    /// The pixel was found in the last frame; if not, a ray is forced and `neighbourhood` unused.
    pub is_reprojected: bool,
    /// The rolling refresh traces this pixel in this frame: see [`crate::is_due`].
    pub is_due: bool,
    /// What the last frame says; [`Neighbourhood::EMPTY`] with `allows_removal` false switches the history off.
    pub neighbourhood: Neighbourhood,
    /// RR (eq. 8) is switched on and no guard forbids it here: no depth of the footprint came from a dynamic map (paper §3.4), and the
    /// temporal depth test passed where there is one (§3.1.2). The paper has no guard against motion, and wherever pixels
    /// move RR adds wrong ones; `known` needs no such guess.
    pub allows_removal: bool,
    /// What this very pixel learnt in the last frame, where camera, surface, light and casters have stood exactly still since; else
    /// [`MaskBits::BLACK`]. If a ray was traced, its answer is this frame's too, and none is traced again.
    pub known: MaskBits,
}

/// Which rule decided, for statistics and debug views.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reason(u32);

impl Reason {
    /// The estimate is confident and no rule objects: no ray.
    pub const CONFIDENT: Self = Self(0);
    /// The leak tracing test doubts the estimate: ray.
    pub const DOUBTED: Self = Self(1);
    /// Outside the light's map, or the estimate is NaN: ray.
    pub const UNKNOWN: Self = Self(2);
    /// Not found in the last frame: ray.
    pub const UNSEEN: Self = Self(3);
    /// Confident, but a neighbour's history contradicts: ray.
    pub const EXPANDED: Self = Self(4);
    /// Doubted, but all neighbours' histories confirm the shadow test: no ray.
    pub const REMOVED: Self = Self(5);
    /// Seen before, and its turn in the rolling refresh: ray.
    pub const REFRESHED: Self = Self(6);
    /// The last frame's ray answers, since nothing has moved: no ray.
    pub const KNOWN: Self = Self(7);

    /// A dense number 0…7, e.g. for counters.
    #[inline]
    pub fn to_index(self) -> u32 {
        self.0
    }
}

/// What to do at one pixel for one light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Decision {
    /// Trace a ray.
    pub needs_ray: bool,
    /// ST of this frame.
    pub is_test_shadowed: bool,
    /// The answer where no ray is traced: the last frame's ray's where that is known, else ST.
    pub is_shadowed: bool,
    /// The rule that decided.
    pub reason: Reason,
}

impl Decision {
    /// Visibility where no ray is traced: 0 or 1.
    ///
    /// The paper snaps removed rays only; confident estimates differ from 0 or 1 by at most ε, so we snap them too.
    #[inline]
    pub fn snapped_visibility(self) -> f32 {
        if self.is_shadowed { 0.0 } else { 1.0 }
    }

    /// The history to store where no ray was traced.
    #[inline]
    pub fn mask_without_ray(self) -> MaskBits {
        if self.reason == Reason::KNOWN {
            MaskBits::traced(self.is_test_shadowed, self.is_shadowed)
        } else {
            MaskBits::untraced(self.is_test_shadowed)
        }
    }

    /// The history to store after tracing a ray.
    #[inline]
    pub fn mask_with_ray(self, is_ray_hit: bool) -> MaskBits {
        MaskBits::traced(self.is_test_shadowed, is_ray_hit)
    }
}

/// Decides a pixel that faces the light, in the paper's order: LTT, failed reprojection (or its turn in the rolling refresh, which
/// is not the paper's) forces a ray, ER if LTT was false, RR if LTT was true. What is known goes before all but those two.
///
/// A receiver outside the map and a NaN estimate always get a ray: RR cannot remove what no shadow test has judged.
/// For surfaces facing away store [`MaskBits::FACING_AWAY`] instead.
pub fn decide(visibility: f32, epsilon: f32, evidence: Evidence) -> Decision {
    let known = Evidence { is_on_map: evidence.is_on_map && !float::is_nan(visibility), ..evidence };
    decide_doubt(is_test_shadowed(visibility), needs_ray(visibility, epsilon), known)
}

/// [`decide`] for any doubt: `is_test_shadowed` is ST, `is_doubted` whatever test stands in LTT's place.
///
/// With `evidence.is_on_map` false the estimate has judged nothing, and a ray is certain.
#[inline]
pub fn decide_doubt(is_test_shadowed: bool, is_doubted: bool, evidence: Evidence) -> Decision {
    let history = evidence.neighbourhood;
    let is_kept = evidence.is_reprojected && !evidence.is_due && evidence.known.is_traced();
    let reason = if is_kept {
        Reason::KNOWN
    } else if !evidence.is_on_map {
        Reason::UNKNOWN
    } else if !evidence.is_reprojected {
        Reason::UNSEEN
    } else if evidence.is_due {
        Reason::REFRESHED
    } else if !is_doubted && history.any_expands {
        Reason::EXPANDED
    } else if is_doubted && evidence.allows_removal && history.all_remove {
        Reason::REMOVED
    } else if is_doubted {
        Reason::DOUBTED
    } else {
        Reason::CONFIDENT
    };
    let needs_ray = reason != Reason::CONFIDENT && reason != Reason::REMOVED && !is_kept;
    let is_shadowed = if is_kept { evidence.known.is_ray_hit() } else { is_test_shadowed };
    Decision { needs_ray, is_test_shadowed, is_shadowed, reason }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lt_math::LTT_EPSILON;
    use std::vec::Vec;

    const STATES: [MaskBits; 6] = [
        MaskBits::BLACK,
        MaskBits::GREEN,
        MaskBits::WHITE,
        MaskBits::PURPLE,
        MaskBits::RED,
        MaskBits::YELLOW,
    ];

    const BOTH: [bool; 2] = [false, true];

    /// The neighbour states (in the order of `STATES`) for which the paper's words and equations ask for ER and for RR.
    const ER_IF_LIT: [bool; 6] = [false, true, true, true, false, true];
    const ER_IF_SHADOWED: [bool; 6] = [true, false, false, true, true, true];
    const RR_IF_LIT: [bool; 6] = [true, false, false, false, true, false];
    const RR_IF_SHADOWED: [bool; 6] = [false, true, true, false, false, false];

    #[test]
    fn er_truth_table() {
        for (i, state) in STATES.into_iter().enumerate() {
            assert_eq!(expands_ray(state, false), ER_IF_LIT[i], "{state:?}");
            assert_eq!(expands_ray(state, true), ER_IF_SHADOWED[i], "{state:?}");
        }
    }

    /// By rule and ST, the states that make a pixel trace.
    #[test]
    fn narrower_rules_ask_less() {
        let asking = |rule: Expansion, st: bool| -> Vec<MaskBits> {
            STATES.into_iter().filter(|state| rule.asks(*state, st)).collect()
        };
        for st in BOTH {
            let published = STATES.into_iter().filter(|state| expands_ray(*state, st)).collect::<Vec<_>>();
            assert_eq!(asking(Expansion::PUBLISHED, st), published);
            assert_eq!(asking(Expansion::from_index(9), st), published);
        }
        assert_eq!(asking(Expansion::RAYS, false), [MaskBits::WHITE, MaskBits::PURPLE]);
        assert_eq!(asking(Expansion::RAYS, true), [MaskBits::RED, MaskBits::YELLOW]);
        assert_eq!(asking(Expansion::LEAKS, false), [MaskBits::PURPLE]);
        assert_eq!(asking(Expansion::LEAKS, true), [MaskBits::YELLOW]);
    }

    #[test]
    fn rr_truth_table() {
        for (i, state) in STATES.into_iter().enumerate() {
            assert_eq!(removes_ray(state, false), RR_IF_LIT[i], "{state:?}");
            assert_eq!(removes_ray(state, true), RR_IF_SHADOWED[i], "{state:?}");
        }
    }

    /// Eqs. 6 and 8 negate each other over every state that occurs.
    #[test]
    fn er_and_rr_are_complements() {
        for state in STATES {
            for st in BOTH {
                assert_ne!(expands_ray(state, st), removes_ray(state, st), "{state:?} {st}");
            }
        }
    }

    #[test]
    fn a_neighbourhood_is_any_er_and_all_rr() {
        for a in STATES {
            for b in STATES {
                for st in BOTH {
                    for rule in Expansion::ALL {
                        let n = Neighbourhood::EMPTY.with(a, st, rule).with(b, st, rule);
                        assert_eq!(n.any_expands, rule.asks(a, st) || rule.asks(b, st));
                        assert_eq!(n.all_remove, removes_ray(a, st) && removes_ray(b, st));
                    }
                }
            }
        }
    }

    /// Every combination of inputs against the paper's list of steps, written out as it stands in §3.1.3.
    #[test]
    fn the_whole_decision_follows_the_steps_of_the_paper() {
        let mut cases = 0;
        for visibility in [0.0, 0.005, 0.01, 0.02, 0.49, 0.5, 0.75, 0.98, 0.99, 0.995, 1.0, f32::NAN] {
            for bits in 0..128 {
                let flag = |i: u32| bits >> i & 1 == 1;
                let evidence = Evidence {
                    is_on_map: flag(0),
                    is_reprojected: flag(1),
                    neighbourhood: Neighbourhood { any_expands: flag(2), all_remove: flag(3) },
                    allows_removal: flag(4),
                    is_due: flag(5),
                    known: if flag(6) { MaskBits::PURPLE } else { MaskBits::GREEN },
                };
                let original_ltt = visibility.is_nan() || (visibility > 0.01 && visibility < 0.99);
                let mut ltt = original_ltt;
                if !evidence.is_reprojected || evidence.is_due {
                    ltt = true;
                } else {
                    if !original_ltt && evidence.neighbourhood.any_expands {
                        ltt = true;
                    }
                    if original_ltt && evidence.allows_removal && evidence.neighbourhood.all_remove {
                        ltt = false;
                    }
                }
                if !evidence.is_on_map || visibility.is_nan() {
                    ltt = true;
                }
                // Not the paper's: a ray of this very pixel that still holds.
                let is_known = flag(6) && evidence.is_reprojected && !evidence.is_due;
                ltt &= !is_known;
                let decision = decide(visibility, LTT_EPSILON, evidence);
                assert_eq!(decision.needs_ray, ltt, "{visibility} {evidence:?}");
                assert_eq!(decision.is_test_shadowed, visibility < 0.5);
                let is_lit = visibility.is_nan() || visibility >= 0.5;
                let expected = if is_lit && !is_known { 1.0 } else { 0.0 };
                assert_eq!(decision.snapped_visibility(), expected);
                assert_eq!(decision.mask_without_ray().is_traced(), is_known);
                cases += 1;
            }
        }
        assert_eq!(cases, 12 * 128);
    }

    fn seen(neighbourhood: Neighbourhood, allows_removal: bool) -> Evidence {
        Evidence {
            is_on_map: true,
            is_reprojected: true,
            is_due: false,
            neighbourhood,
            allows_removal,
            known: MaskBits::BLACK,
        }
    }

    #[test]
    fn reasons_name_the_rule() {
        let quiet = Neighbourhood::EMPTY;
        let contradicting = Neighbourhood { any_expands: true, all_remove: false };
        let reason = |v: f32, e: Evidence| decide(v, LTT_EPSILON, e).reason;
        assert_eq!(reason(1.0, seen(quiet, true)), Reason::CONFIDENT);
        assert_eq!(reason(0.6, seen(contradicting, true)), Reason::DOUBTED);
        assert_eq!(reason(0.6, seen(quiet, false)), Reason::DOUBTED);
        assert_eq!(reason(0.6, seen(quiet, true)), Reason::REMOVED);
        assert_eq!(reason(1.0, seen(contradicting, true)), Reason::EXPANDED);
        assert_eq!(reason(1.0, Evidence { is_reprojected: false, ..seen(quiet, true) }), Reason::UNSEEN);
        assert_eq!(reason(1.0, Evidence { is_on_map: false, ..seen(quiet, true) }), Reason::UNKNOWN);
        assert_eq!(reason(f32::NAN, seen(quiet, true)), Reason::UNKNOWN);
        assert_eq!(reason(1.0, Evidence { is_due: true, ..seen(quiet, true) }), Reason::REFRESHED);
        assert_eq!(reason(0.6, Evidence { is_due: true, ..seen(quiet, true) }), Reason::REFRESHED);
    }

    #[test]
    fn a_known_answer_is_kept_whatever_the_map_says() {
        for st in [0.0, 0.4, 1.0] {
            for hit in BOTH {
                let contradicting = Neighbourhood { any_expands: true, all_remove: false };
                let known = MaskBits::traced(!hit, hit);
                let decision = decide(st, LTT_EPSILON, Evidence { known, ..seen(contradicting, true) });
                assert_eq!((decision.needs_ray, decision.reason), (false, Reason::KNOWN));
                assert_eq!(decision.snapped_visibility(), if hit { 0.0 } else { 1.0 });
                assert_eq!(decision.mask_without_ray(), MaskBits::traced(st < 0.5, hit));
            }
        }
    }

    #[test]
    fn masks_record_what_happened() {
        for st in [0.0, 1.0] {
            let decision = decide(st, LTT_EPSILON, seen(Neighbourhood::EMPTY, true));
            assert!(!decision.mask_without_ray().is_traced());
            assert_eq!(decision.mask_without_ray().is_test_shadowed(), st == 0.0);
            for hit in BOTH {
                let mask = decision.mask_with_ray(hit);
                assert_eq!((mask.is_traced(), mask.is_ray_hit()), (true, hit));
                assert_eq!(mask.is_test_shadowed(), st == 0.0);
            }
        }
    }

    #[test]
    fn depth_consistency_is_relative_symmetric_and_nan_safe() {
        assert!(is_depth_consistent(10.0, 10.9, DEPTH_CONSISTENCY_TOLERANCE));
        assert!(is_depth_consistent(10.9, 10.0, DEPTH_CONSISTENCY_TOLERANCE));
        assert!(!is_depth_consistent(10.0, 11.5, DEPTH_CONSISTENCY_TOLERANCE));
        assert!(is_depth_consistent(1e-6, 1.05e-6, DEPTH_CONSISTENCY_TOLERANCE));
        assert!(is_depth_consistent(0.0, 0.0, DEPTH_CONSISTENCY_TOLERANCE));
        assert!(!is_depth_consistent(f32::NAN, 1.0, DEPTH_CONSISTENCY_TOLERANCE));
        assert!(!is_depth_consistent(1.0, f32::NAN, DEPTH_CONSISTENCY_TOLERANCE));
        assert!(!is_depth_consistent(f32::INFINITY, f32::INFINITY, DEPTH_CONSISTENCY_TOLERANCE));
    }
}
