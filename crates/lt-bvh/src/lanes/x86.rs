//! Lanes on x86-64 extensions.

use super::portable::{add_to_sets, filled};
use super::{Lanes, NodeLanes};
use core::arch::x86_64::*;
use lt_math::glam::Vec3;

/// Proof that the processor has AVX2, FMA, and the bit counting that came with them (BMI1, BMI2, LZCNT, POPCNT).
#[derive(Clone, Copy, Debug)]
pub struct Avx2(());

/// Proof that the processor has AVX-512F and AVX-512VL as well; eight lanes.
#[derive(Clone, Copy, Debug)]
pub struct Avx512(Avx2);

/// The same proof; sixteen lanes.
#[derive(Clone, Copy, Debug)]
pub struct Avx512Rays(Avx512);

impl Avx2 {
    /// The proof, if this processor has them.
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
    /// The proof, if this processor has them.
    pub fn detect() -> Option<Self> {
        let has = std::is_x86_feature_detected!("avx512f") && std::is_x86_feature_detected!("avx512vl");
        Avx2::detect().filter(|_| has).map(Avx512)
    }
}

/// For each mask of eight bits, the positions of its set bits: what AVX2 has in place of a compress instruction.
static ORDER: [[u32; 8]; 256] = order();

const fn order() -> [[u32; 8]; 256] {
    let mut table = [[0; 8]; 256];
    let mut mask = 0;
    while mask < 256 {
        let (mut bit, mut len) = (0, 0);
        while bit < 8 {
            if mask >> bit & 1 == 1 {
                table[mask][len] = bit;
                len += 1;
            }
            bit += 1;
        }
        mask += 1;
    }
    table
}

/// Where every third of 48 numbers lies, for each of the three: in the first two registers, then in what came of them and the third.
static THIRDS: [[[u32; 16]; 2]; 3] = thirds();

const fn thirds() -> [[[u32; 16]; 2]; 3] {
    let mut table = [[[0; 16]; 2]; 3];
    let mut i = 0;
    while i < 48 {
        let (axis, lane, at) = (i % 3, i / 3, i as u32);
        table[axis][0][lane] = at % 32;
        table[axis][1][lane] = if at < 32 { lane as u32 } else { at - 16 };
        i += 1;
    }
    table
}

/// A method of which the body is one or two instructions, safe because `self` proves that the processor has them.
macro_rules! instruction {
    ($name:ident($($argument:ident: $type:ty),*) -> $result:ty, $body:expr) => {
        #[inline(always)]
        fn $name(self, $($argument: $type),*) -> $result {
            // SAFETY: `self` proves that the processor has the instruction, which touches no memory.
            unsafe { $body }
        }
    };
}

/// What all three have in common.
macro_rules! common {
    (
        $register:ty, $width:literal, $load:ident, $store:ident, $splat:ident, $add:ident, $sub:ident, $mul:ident,
        $div:ident, $mul_add:ident, $neg_mul_add:ident, $min:ident, $max:ident
    ) => {
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
        instruction!(neg_mul_add(a: $register, b: $register, c: $register) -> $register, $neg_mul_add(a, b, c));
        instruction!(min(a: $register, b: $register) -> $register, $min(a, b));
        instruction!(max(a: $register, b: $register) -> $register, $max(a, b));
    };
}

macro_rules! eight {
    () => {
        common!(
            __m256, 8, _mm256_loadu_ps, _mm256_storeu_ps, _mm256_set1_ps, _mm256_add_ps, _mm256_sub_ps,
            _mm256_mul_ps, _mm256_div_ps, _mm256_fmadd_ps, _mm256_fnmadd_ps, _mm256_min_ps, _mm256_max_ps
        );
        instruction!(abs(a: __m256) -> __m256, _mm256_andnot_ps(_mm256_set1_ps(-0.0), a));
        #[inline(always)]
        fn least(self, a: __m256) -> f32 {
            // SAFETY: `self` proves the instructions, which touch no memory.
            unsafe {
                let four = _mm_min_ps(_mm256_castps256_ps128(a), _mm256_extractf128_ps::<1>(a));
                let two = _mm_min_ps(four, _mm_movehl_ps(four, four));
                _mm_cvtss_f32(_mm_min_ss(two, _mm_movehdup_ps(two)))
            }
        }
        #[inline(always)]
        fn most(self, a: __m256) -> f32 {
            // SAFETY: `self` proves the instructions, which touch no memory.
            unsafe {
                let four = _mm_max_ps(_mm256_castps256_ps128(a), _mm256_extractf128_ps::<1>(a));
                let two = _mm_max_ps(four, _mm_movehl_ps(four, four));
                _mm_cvtss_f32(_mm_max_ss(two, _mm_movehdup_ps(two)))
            }
        }
    };
}

impl Lanes for Avx2 {
    eight!();
    #[inline(always)]
    fn pick(self, mask: u32, a: __m256, b: __m256) -> __m256 {
        // SAFETY: `self` proves AVX2, which touches no memory here.
        unsafe {
            let bits = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
            let set = _mm256_and_si256(_mm256_set1_epi32(mask as i32), bits);
            _mm256_blendv_ps(b, a, _mm256_castsi256_ps(_mm256_cmpeq_epi32(set, bits)))
        }
    }
    instruction!(le(a: __m256, b: __m256) -> u32, _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(a, b)) as u32);
    instruction!(lt(a: __m256, b: __m256) -> u32, _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LT_OQ>(a, b)) as u32);
    #[inline(always)]
    fn compress(self, mask: u32, from: __m256, to: &mut [f32]) {
        let to = &mut to[..8];
        // SAFETY: `self` proves AVX2; a row of the table is eight words, and eight f32 of `to` are writable.
        unsafe {
            let order = _mm256_loadu_si256(ORDER[mask as usize & 255].as_ptr().cast());
            _mm256_storeu_ps(to.as_mut_ptr(), _mm256_permutevar8x32_ps(from, order));
        }
    }
    #[inline(always)]
    fn compress_words(self, mask: u32, from: &[u32], to: &mut [u32]) {
        let (from, to) = (&from[..8], &mut to[..8]);
        // SAFETY: `self` proves AVX2; a row of the table is eight words, and so many are readable and writable.
        unsafe {
            let order = _mm256_loadu_si256(ORDER[mask as usize & 255].as_ptr().cast());
            let packed = _mm256_permutevar8x32_epi32(_mm256_loadu_si256(from.as_ptr().cast()), order);
            _mm256_storeu_si256(to.as_mut_ptr().cast(), packed);
        }
    }
}

impl Lanes for Avx512 {
    eight!();
    instruction!(pick(mask: u32, a: __m256, b: __m256) -> __m256, _mm256_mask_blend_ps(mask as u8, b, a));
    instruction!(le(a: __m256, b: __m256) -> u32, u32::from(_mm256_cmp_ps_mask::<_CMP_LE_OQ>(a, b)));
    instruction!(lt(a: __m256, b: __m256) -> u32, u32::from(_mm256_cmp_ps_mask::<_CMP_LT_OQ>(a, b)));
    #[inline(always)]
    fn compress(self, mask: u32, from: __m256, to: &mut [f32]) {
        let to = &mut to[..8];
        // SAFETY: `self` proves the instructions; eight f32 are writable. Compressing to memory is several times slower.
        unsafe { _mm256_storeu_ps(to.as_mut_ptr(), _mm256_maskz_compress_ps(mask as u8, from)) }
    }
    #[inline(always)]
    fn compress_words(self, mask: u32, from: &[u32], to: &mut [u32]) {
        let (from, to) = (&from[..8], &mut to[..8]);
        // SAFETY: `self` proves the instructions; eight words are readable and writable.
        unsafe {
            let packed = _mm256_maskz_compress_epi32(mask as u8, _mm256_loadu_si256(from.as_ptr().cast()));
            _mm256_storeu_si256(to.as_mut_ptr().cast(), packed);
        }
    }
}

impl Lanes for Avx512Rays {
    common!(
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
        _mm512_fnmadd_ps,
        _mm512_min_ps,
        _mm512_max_ps
    );
    #[inline(always)]
    fn load_vectors(self, from: &[Vec3]) -> [__m512; 3] {
        let from = from[..16].as_ptr().cast::<f32>();
        let mut rows = [self.splat(0.0); 3];
        // SAFETY: `self` proves the instructions; 16 vectors are 48 f32, as `Vec3` is three of them in C's layout.
        unsafe {
            let registers =
                [_mm512_loadu_ps(from), _mm512_loadu_ps(from.add(16)), _mm512_loadu_ps(from.add(32))];
            for (row, order) in rows.iter_mut().zip(&THIRDS) {
                let [first, last] = order.each_ref().map(|o| _mm512_loadu_si512(o.as_ptr().cast()));
                let begun = _mm512_permutex2var_ps(registers[0], first, registers[1]);
                *row = _mm512_permutex2var_ps(begun, last, registers[2]);
            }
        }
        rows
    }
    instruction!(abs(a: __m512) -> __m512, _mm512_abs_ps(a));
    instruction!(least(a: __m512) -> f32, _mm512_reduce_min_ps(a));
    instruction!(most(a: __m512) -> f32, _mm512_reduce_max_ps(a));
    instruction!(pick(mask: u32, a: __m512, b: __m512) -> __m512, _mm512_mask_blend_ps(mask as u16, b, a));
    instruction!(le(a: __m512, b: __m512) -> u32, u32::from(_mm512_cmp_ps_mask::<_CMP_LE_OQ>(a, b)));
    instruction!(lt(a: __m512, b: __m512) -> u32, u32::from(_mm512_cmp_ps_mask::<_CMP_LT_OQ>(a, b)));
    #[inline(always)]
    fn compress(self, mask: u32, from: __m512, to: &mut [f32]) {
        let to = &mut to[..16];
        // SAFETY: `self` proves the instructions; sixteen f32 are writable. Compressing to memory is several times slower.
        unsafe { _mm512_storeu_ps(to.as_mut_ptr(), _mm512_maskz_compress_ps(mask as u16, from)) }
    }
    #[inline(always)]
    fn compress_words(self, mask: u32, from: &[u32], to: &mut [u32]) {
        let (from, to) = (&from[..16], &mut to[..16]);
        // SAFETY: `self` proves the instructions; sixteen words are readable and writable.
        unsafe {
            let packed = _mm512_maskz_compress_epi32(mask as u16, _mm512_loadu_si512(from.as_ptr().cast()));
            _mm512_storeu_si512(to.as_mut_ptr().cast(), packed);
        }
    }
    /// In one instruction, by which the street's maps are evaluated in a twelfth less time. (AVX2's gather was not tried: it loads one by one.)
    #[inline(always)]
    fn gather_words(self, from: &[u32], at: &[u32], to: &mut [u32]) {
        let (at, to) = (&at[..16], &mut to[..16]);
        // Places beyond this would be negative ones.
        let len = from.len().min(i32::MAX as usize) as i32;
        // SAFETY: `self` proves the instructions; sixteen words of `at` are readable and of `to` writable; every place is asserted to lie in `from`
        // before it is read.
        unsafe {
            let at = _mm512_loadu_si512(at.as_ptr().cast());
            let outside = _mm512_cmpge_epu32_mask(at, _mm512_set1_epi32(len));
            assert!(outside == 0, "a place outside of {len} words");
            _mm512_storeu_si512(
                to.as_mut_ptr().cast(),
                _mm512_i32gather_epi32::<4>(at, from.as_ptr().cast()),
            );
        }
    }
}

/// Bytes to a line of the cache.
const LINE: usize = 64;

/// [`super::prefetch`].
#[inline(always)]
pub(super) fn prefetch<T>(value: &T) {
    let start = core::ptr::from_ref(value).cast::<i8>();
    for line in 0..size_of::<T>().div_ceil(LINE) {
        // SAFETY: every x86-64 processor has the instruction; it faults nowhere, and this lies within the value.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(start.add(line * LINE)) }
    }
}

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
    fn filled(self, sets: [u64; 8]) -> u32 {
        filled(&sets)
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
    instruction!(filled(sets: __m512i) -> u32, u32::from(_mm512_test_epi64_mask(sets, sets)));
    #[inline(always)]
    fn stored_sets(self, sets: __m512i) -> [u64; 8] {
        let mut to = [0u64; 8];
        // SAFETY: `self` proves AVX-512F; eight u64 are writable, and the store asks for no alignment.
        unsafe { _mm512_storeu_si512(to.as_mut_ptr().cast(), sets) };
        to
    }
}
