//! Eight f32 at once: the few operations that the wide traversal needs, on AVX-512, AVX2, or plain arrays.

/// Eight lanes and how to compute with them. Every operation rounds as the scalar one does, except that
/// [`Lanes::mul_add`] may or may not round in between.
pub(crate) trait Lanes: Copy {
    /// Eight f32.
    type F: Copy;
    fn load(self, from: &[f32; 8]) -> Self::F;
    fn store(self, from: Self::F) -> [f32; 8];
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

/// Plain arrays, for every processor.
#[derive(Clone, Copy)]
pub(crate) struct Portable;

#[inline(always)]
fn zip(a: [f32; 8], b: [f32; 8], f: impl Fn(f32, f32) -> f32) -> [f32; 8] {
    core::array::from_fn(|i| f(a[i], b[i]))
}

impl Lanes for Portable {
    type F = [f32; 8];
    #[inline(always)]
    fn load(self, from: &[f32; 8]) -> [f32; 8] {
        *from
    }
    #[inline(always)]
    fn store(self, from: [f32; 8]) -> [f32; 8] {
        from
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
        let mut mask = 0;
        for i in 0..8 {
            mask |= u32::from(a[i] <= b[i]) << i;
        }
        mask
    }
}

#[cfg(target_arch = "x86_64")]
pub(crate) mod x86 {
    //! The same on x86-64 extensions.
    use super::Lanes;
    use core::arch::x86_64::*;

    /// Proof that the processor has AVX2, FMA, and the bit counting that came with them (BMI1, BMI2, POPCNT).
    #[derive(Clone, Copy)]
    pub(crate) struct Avx2(());

    /// Proof that the processor has AVX-512F and AVX-512VL as well.
    #[derive(Clone, Copy)]
    pub(crate) struct Avx512(Avx2);

    impl Avx2 {
        pub fn detect() -> Option<Self> {
            let has = std::is_x86_feature_detected!("avx2")
                && std::is_x86_feature_detected!("fma")
                && std::is_x86_feature_detected!("bmi1")
                && std::is_x86_feature_detected!("bmi2")
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

    impl Lanes for Avx2 {
        type F = __m256;
        #[inline(always)]
        fn load(self, from: &[f32; 8]) -> __m256 {
            // SAFETY: `self` proves AVX; eight f32 are readable, and the load asks for no alignment.
            unsafe { _mm256_loadu_ps(from.as_ptr()) }
        }
        #[inline(always)]
        fn store(self, from: __m256) -> [f32; 8] {
            let mut to = [0.0; 8];
            // SAFETY: `self` proves AVX; eight f32 are writable, and the store asks for no alignment.
            unsafe { _mm256_storeu_ps(to.as_mut_ptr(), from) };
            to
        }
        #[inline(always)]
        fn splat(self, x: f32) -> __m256 {
            // SAFETY: `self` proves AVX.
            unsafe { _mm256_set1_ps(x) }
        }
        #[inline(always)]
        fn add(self, a: __m256, b: __m256) -> __m256 {
            // SAFETY: `self` proves AVX.
            unsafe { _mm256_add_ps(a, b) }
        }
        #[inline(always)]
        fn sub(self, a: __m256, b: __m256) -> __m256 {
            // SAFETY: `self` proves AVX.
            unsafe { _mm256_sub_ps(a, b) }
        }
        #[inline(always)]
        fn mul(self, a: __m256, b: __m256) -> __m256 {
            // SAFETY: `self` proves AVX.
            unsafe { _mm256_mul_ps(a, b) }
        }
        #[inline(always)]
        fn div(self, a: __m256, b: __m256) -> __m256 {
            // SAFETY: `self` proves AVX.
            unsafe { _mm256_div_ps(a, b) }
        }
        #[inline(always)]
        fn mul_add(self, a: __m256, b: __m256, c: __m256) -> __m256 {
            // SAFETY: `self` proves FMA.
            unsafe { _mm256_fmadd_ps(a, b, c) }
        }
        #[inline(always)]
        fn min(self, a: __m256, b: __m256) -> __m256 {
            // SAFETY: `self` proves AVX.
            unsafe { _mm256_min_ps(a, b) }
        }
        #[inline(always)]
        fn max(self, a: __m256, b: __m256) -> __m256 {
            // SAFETY: `self` proves AVX.
            unsafe { _mm256_max_ps(a, b) }
        }
        #[inline(always)]
        fn le(self, a: __m256, b: __m256) -> u32 {
            // SAFETY: `self` proves AVX.
            unsafe { _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(a, b)) as u32 }
        }
    }

    impl Lanes for Avx512 {
        type F = __m256;
        #[inline(always)]
        fn load(self, from: &[f32; 8]) -> __m256 {
            self.0.load(from)
        }
        #[inline(always)]
        fn store(self, from: __m256) -> [f32; 8] {
            self.0.store(from)
        }
        #[inline(always)]
        fn splat(self, x: f32) -> __m256 {
            self.0.splat(x)
        }
        #[inline(always)]
        fn add(self, a: __m256, b: __m256) -> __m256 {
            self.0.add(a, b)
        }
        #[inline(always)]
        fn sub(self, a: __m256, b: __m256) -> __m256 {
            self.0.sub(a, b)
        }
        #[inline(always)]
        fn mul(self, a: __m256, b: __m256) -> __m256 {
            self.0.mul(a, b)
        }
        #[inline(always)]
        fn div(self, a: __m256, b: __m256) -> __m256 {
            self.0.div(a, b)
        }
        #[inline(always)]
        fn mul_add(self, a: __m256, b: __m256, c: __m256) -> __m256 {
            self.0.mul_add(a, b, c)
        }
        #[inline(always)]
        fn min(self, a: __m256, b: __m256) -> __m256 {
            self.0.min(a, b)
        }
        #[inline(always)]
        fn max(self, a: __m256, b: __m256) -> __m256 {
            self.0.max(a, b)
        }
        #[inline(always)]
        fn le(self, a: __m256, b: __m256) -> u32 {
            // SAFETY: `self` proves AVX-512F and VL.
            unsafe { u32::from(_mm256_cmp_ps_mask::<_CMP_LE_OQ>(a, b)) }
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
