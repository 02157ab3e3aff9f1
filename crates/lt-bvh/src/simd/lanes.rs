//! Several f32 at once: the few operations that the wide traversals need, on AVX-512, AVX2, or plain arrays.
//!
//! Two widths serve two shapes of work. **Node lanes** are eight children or triangles under one ray; **ray lanes**
//! are eight or sixteen rays under one child or triangle.

/// Lanes and how to compute with them. Every operation rounds as the scalar one does, except that
/// [`Lanes::mul_add`] may or may not round in between.
pub(crate) trait Lanes: Copy {
    /// [`Lanes::WIDTH`] f32.
    type F: Copy;
    const WIDTH: usize;
    /// The first lanes' worth of `from`, which must be that long.
    fn load(self, from: &[f32]) -> Self::F;
    /// Writes to the start of `to`, which must be long enough.
    fn store(self, from: Self::F, to: &mut [f32]);
    fn splat(self, x: f32) -> Self::F;
    fn add(self, a: Self::F, b: Self::F) -> Self::F;
    fn sub(self, a: Self::F, b: Self::F) -> Self::F;
    fn mul(self, a: Self::F, b: Self::F) -> Self::F;
    fn div(self, a: Self::F, b: Self::F) -> Self::F;
    fn mul_add(self, a: Self::F, b: Self::F, c: Self::F) -> Self::F;
    /// `b` where either is NaN.
    fn min(self, a: Self::F, b: Self::F) -> Self::F;
    /// `b` where either is NaN.
    fn max(self, a: Self::F, b: Self::F) -> Self::F;
    /// A bit per lane where a ≤ b; clear where either is NaN.
    fn le(self, a: Self::F, b: Self::F) -> u32;
    /// A bit per lane where a < b; clear where either is NaN.
    fn lt(self, a: Self::F, b: Self::F) -> u32;
}

/// Eight lanes for the children of a node, with the ray lanes of the same processor.
pub(crate) trait NodeLanes: Lanes {
    type Rays: Lanes;
    fn rays(self) -> Self::Rays;

    /// Eight sets of up to 64 rays, one for each child.
    type Sets: Copy;
    /// All empty.
    fn no_sets(self) -> Self::Sets;
    /// Adds the ray of `bit` to the sets named by `mask`.
    fn add_to_sets(self, sets: Self::Sets, mask: u32, bit: u64) -> Self::Sets;
    /// The sets as masks.
    fn stored_sets(self, sets: Self::Sets) -> [u64; 8];

    /// Writes the `values` whose bit is set in `mask` to the start of `to`, in order. What follows them in `to`
    /// is unspecified.
    #[inline(always)]
    fn compress(self, mask: u32, values: &[u32; 8], to: &mut [u32; 8]) {
        let (mut mask, mut len) = (mask, 0);
        while mask != 0 {
            to[len & 7] = values[(mask.trailing_zeros() & 7) as usize];
            mask &= mask - 1;
            len += 1;
        }
    }
}

/// [`NodeLanes::add_to_sets`] on an array.
#[inline(always)]
fn add_to_sets(sets: [u64; 8], mask: u32, bit: u64) -> [u64; 8] {
    let mut sets = sets;
    for (i, set) in sets.iter_mut().enumerate() {
        *set |= bit & u64::from(mask >> i & 1).wrapping_neg();
    }
    sets
}

/// Plain arrays, for every processor.
#[derive(Clone, Copy)]
pub(crate) struct Portable;

#[inline(always)]
fn zip(a: [f32; 8], b: [f32; 8], f: impl Fn(f32, f32) -> f32) -> [f32; 8] {
    core::array::from_fn(|i| f(a[i], b[i]))
}

#[inline(always)]
fn bits(a: [f32; 8], b: [f32; 8], holds: impl Fn(f32, f32) -> bool) -> u32 {
    let mut mask = 0;
    for i in 0..8 {
        mask |= u32::from(holds(a[i], b[i])) << i;
    }
    mask
}

impl Lanes for Portable {
    type F = [f32; 8];
    const WIDTH: usize = 8;
    #[inline(always)]
    fn load(self, from: &[f32]) -> [f32; 8] {
        let mut lanes = [0.0; 8];
        lanes.copy_from_slice(&from[..8]);
        lanes
    }
    #[inline(always)]
    fn store(self, from: [f32; 8], to: &mut [f32]) {
        to[..8].copy_from_slice(&from);
    }
    #[inline(always)]
    fn splat(self, x: f32) -> [f32; 8] {
        [x; 8]
    }
    #[inline(always)]
    fn add(self, a: [f32; 8], b: [f32; 8]) -> [f32; 8] {
        zip(a, b, |a, b| a + b)
    }
    #[inline(always)]
    fn sub(self, a: [f32; 8], b: [f32; 8]) -> [f32; 8] {
        zip(a, b, |a, b| a - b)
    }
    #[inline(always)]
    fn mul(self, a: [f32; 8], b: [f32; 8]) -> [f32; 8] {
        zip(a, b, |a, b| a * b)
    }
    #[inline(always)]
    fn div(self, a: [f32; 8], b: [f32; 8]) -> [f32; 8] {
        zip(a, b, |a, b| a / b)
    }
    #[inline(always)]
    fn mul_add(self, a: [f32; 8], b: [f32; 8], c: [f32; 8]) -> [f32; 8] {
        self.add(self.mul(a, b), c)
    }
    #[inline(always)]
    fn min(self, a: [f32; 8], b: [f32; 8]) -> [f32; 8] {
        zip(a, b, |a, b| if a < b { a } else { b })
    }
    #[inline(always)]
    fn max(self, a: [f32; 8], b: [f32; 8]) -> [f32; 8] {
        zip(a, b, |a, b| if a > b { a } else { b })
    }
    #[inline(always)]
    fn le(self, a: [f32; 8], b: [f32; 8]) -> u32 {
        bits(a, b, |a, b| a <= b)
    }
    #[inline(always)]
    fn lt(self, a: [f32; 8], b: [f32; 8]) -> u32 {
        bits(a, b, |a, b| a < b)
    }
}

impl NodeLanes for Portable {
    type Rays = Portable;
    #[inline(always)]
    fn rays(self) -> Portable {
        self
    }
    type Sets = [u64; 8];
    #[inline(always)]
    fn no_sets(self) -> [u64; 8] {
        [0; 8]
    }
    #[inline(always)]
    fn add_to_sets(self, sets: [u64; 8], mask: u32, bit: u64) -> [u64; 8] {
        add_to_sets(sets, mask, bit)
    }
    #[inline(always)]
    fn stored_sets(self, sets: [u64; 8]) -> [u64; 8] {
        sets
    }
}

#[cfg(target_arch = "x86_64")]
pub(crate) mod x86 {
    //! The same on x86-64 extensions.
    use super::{Lanes, NodeLanes, add_to_sets};
    use core::arch::x86_64::*;

    /// Proof that the processor has AVX2, FMA, and the bit counting that came with them (BMI1, BMI2, LZCNT, POPCNT).
    #[derive(Clone, Copy)]
    pub(crate) struct Avx2(());

    /// Proof that the processor has AVX-512F and AVX-512VL as well; eight lanes.
    #[derive(Clone, Copy)]
    pub(crate) struct Avx512(Avx2);

    /// The same proof; sixteen lanes.
    #[derive(Clone, Copy)]
    pub(crate) struct Avx512Rays(Avx512);

    impl Avx2 {
        pub fn detect() -> Option<Self> {
            let has = std::is_x86_feature_detected!("avx2")
                && std::is_x86_feature_detected!("fma")
                && std::is_x86_feature_detected!("bmi1")
                && std::is_x86_feature_detected!("bmi2")
                && std::is_x86_feature_detected!("lzcnt")
                && std::is_x86_feature_detected!("popcnt");
            has.then_some(Avx2(()))
        }
    }

    impl Avx512 {
        pub fn detect() -> Option<Self> {
            let has = std::is_x86_feature_detected!("avx512f") && std::is_x86_feature_detected!("avx512vl");
            Avx2::detect().filter(|_| has).map(Avx512)
        }
    }

    /// A method of which the body is one instruction, safe because `self` proves that the processor has it.
    macro_rules! instruction {
        ($name:ident($($argument:ident: $type:ty),*) -> $result:ty, $body:expr) => {
            #[inline(always)]
            fn $name(self, $($argument: $type),*) -> $result {
                // SAFETY: `self` proves that the processor has the instruction, which touches no memory.
                unsafe { $body }
            }
        };
    }

    /// All of [`Lanes`] for one proof and one register.
    macro_rules! lanes {
        (
            $proof:ty, $register:ty, $width:literal, $load:ident, $store:ident, $splat:ident, $add:ident, $sub:ident,
            $mul:ident, $div:ident, $mul_add:ident, $min:ident, $max:ident, $le:ident, $lt:ident
        ) => {
            impl Lanes for $proof {
                type F = $register;
                const WIDTH: usize = $width;
                #[inline(always)]
                fn load(self, from: &[f32]) -> $register {
                    let from: &[f32] = &from[..$width];
                    // SAFETY: `self` proves the instruction; so many f32 are readable, and it asks for no alignment.
                    unsafe { $load(from.as_ptr()) }
                }
                #[inline(always)]
                fn store(self, from: $register, to: &mut [f32]) {
                    let to: &mut [f32] = &mut to[..$width];
                    // SAFETY: `self` proves the instruction; so many f32 are writable, and it asks for no alignment.
                    unsafe { $store(to.as_mut_ptr(), from) }
                }
                instruction!(splat(x: f32) -> $register, $splat(x));
                instruction!(add(a: $register, b: $register) -> $register, $add(a, b));
                instruction!(sub(a: $register, b: $register) -> $register, $sub(a, b));
                instruction!(mul(a: $register, b: $register) -> $register, $mul(a, b));
                instruction!(div(a: $register, b: $register) -> $register, $div(a, b));
                instruction!(mul_add(a: $register, b: $register, c: $register) -> $register, $mul_add(a, b, c));
                instruction!(min(a: $register, b: $register) -> $register, $min(a, b));
                instruction!(max(a: $register, b: $register) -> $register, $max(a, b));
                instruction!(le(a: $register, b: $register) -> u32, $le(a, b));
                instruction!(lt(a: $register, b: $register) -> u32, $lt(a, b));
            }
        };
    }

    /// A comparison as a mask of bits. Functions and not closures: those would not inherit the instruction set.
    macro_rules! comparison {
        ($name:ident, $register:ty, |$a:ident, $b:ident| $body:expr) => {
            /// # Safety
            /// The processor has the instruction.
            #[inline(always)]
            unsafe fn $name($a: $register, $b: $register) -> u32 {
                // SAFETY: as the caller proves.
                unsafe { $body }
            }
        };
    }

    comparison!(le_256, __m256, |a, b| _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(a, b)) as u32);
    comparison!(lt_256, __m256, |a, b| _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LT_OQ>(a, b)) as u32);
    comparison!(le_256_mask, __m256, |a, b| u32::from(_mm256_cmp_ps_mask::<_CMP_LE_OQ>(a, b)));
    comparison!(lt_256_mask, __m256, |a, b| u32::from(_mm256_cmp_ps_mask::<_CMP_LT_OQ>(a, b)));
    comparison!(le_512_mask, __m512, |a, b| u32::from(_mm512_cmp_ps_mask::<_CMP_LE_OQ>(a, b)));
    comparison!(lt_512_mask, __m512, |a, b| u32::from(_mm512_cmp_ps_mask::<_CMP_LT_OQ>(a, b)));

    lanes!(
        Avx2,
        __m256,
        8,
        _mm256_loadu_ps,
        _mm256_storeu_ps,
        _mm256_set1_ps,
        _mm256_add_ps,
        _mm256_sub_ps,
        _mm256_mul_ps,
        _mm256_div_ps,
        _mm256_fmadd_ps,
        _mm256_min_ps,
        _mm256_max_ps,
        le_256,
        lt_256
    );
    lanes!(
        Avx512,
        __m256,
        8,
        _mm256_loadu_ps,
        _mm256_storeu_ps,
        _mm256_set1_ps,
        _mm256_add_ps,
        _mm256_sub_ps,
        _mm256_mul_ps,
        _mm256_div_ps,
        _mm256_fmadd_ps,
        _mm256_min_ps,
        _mm256_max_ps,
        le_256_mask,
        lt_256_mask
    );
    lanes!(
        Avx512Rays,
        __m512,
        16,
        _mm512_loadu_ps,
        _mm512_storeu_ps,
        _mm512_set1_ps,
        _mm512_add_ps,
        _mm512_sub_ps,
        _mm512_mul_ps,
        _mm512_div_ps,
        _mm512_fmadd_ps,
        _mm512_min_ps,
        _mm512_max_ps,
        le_512_mask,
        lt_512_mask
    );

    impl NodeLanes for Avx2 {
        type Rays = Avx2;
        #[inline(always)]
        fn rays(self) -> Avx2 {
            self
        }
        type Sets = [u64; 8];
        #[inline(always)]
        fn no_sets(self) -> [u64; 8] {
            [0; 8]
        }
        #[inline(always)]
        fn add_to_sets(self, sets: [u64; 8], mask: u32, bit: u64) -> [u64; 8] {
            add_to_sets(sets, mask, bit)
        }
        #[inline(always)]
        fn stored_sets(self, sets: [u64; 8]) -> [u64; 8] {
            sets
        }
    }

    impl NodeLanes for Avx512 {
        type Rays = Avx512Rays;
        #[inline(always)]
        fn rays(self) -> Avx512Rays {
            Avx512Rays(self)
        }
        type Sets = __m512i;
        instruction!(no_sets() -> __m512i, _mm512_setzero_si512());
        instruction!(
            add_to_sets(sets: __m512i, mask: u32, bit: u64) -> __m512i,
            _mm512_mask_or_epi64(sets, mask as u8, sets, _mm512_set1_epi64(bit as i64))
        );
        #[inline(always)]
        fn stored_sets(self, sets: __m512i) -> [u64; 8] {
            let mut to = [0u64; 8];
            // SAFETY: `self` proves AVX-512F; eight u64 are writable, and the store asks for no alignment.
            unsafe { _mm512_storeu_si512(to.as_mut_ptr().cast(), sets) };
            to
        }
        #[inline(always)]
        fn compress(self, mask: u32, values: &[u32; 8], to: &mut [u32; 8]) {
            // SAFETY: `self` proves AVX-512F and VL; eight u32 are readable and writable, and neither the load
            // nor the store asks for alignment.
            unsafe {
                let all = _mm256_loadu_si256(values.as_ptr().cast());
                let packed = _mm256_maskz_compress_epi32(mask as u8, all);
                _mm256_storeu_si256(to.as_mut_ptr().cast(), packed);
            }
        }
    }
}
