//! Several f32 at once: the few operations that traversals and light space need, on AVX-512, AVX2, or plain arrays.
//!
//! Two widths serve two shapes of work. **Node lanes** ([`NodeLanes`]) are eight children or triangles under one ray; **ray lanes**
//! ([`NodeLanes::Rays`]) are eight or sixteen rays under one child or triangle. A value of these types is the proof that the processor has
//! the instructions; [`Chosen::run`] compiles a [`Work`] for each of them and runs the one that the processor has. [`watertight`] is the
//! ray tracer's test of triangles on lanes of either kind.
//!
//! Functions over lanes are `#[inline(always)]` and have no closures that touch lanes: a closure does not inherit the instruction set that
//! its caller is compiled for.

mod chosen;
mod portable;
pub mod watertight;
#[cfg(all(feature = "std", target_arch = "x86_64"))]
mod x86;

pub use chosen::{Chosen, SimdLevel, Work};
use lt_math::glam::Vec3;
pub use portable::Portable;
#[cfg(all(feature = "std", target_arch = "x86_64"))]
pub use x86::{Avx2, Avx512, Avx512Rays};

/// Lanes and how to compute with them. Every operation rounds as the scalar one does, except that [`Lanes::mul_add`] and
/// [`Lanes::neg_mul_add`] may or may not round in between.
pub trait Lanes: Copy {
    /// [`Lanes::WIDTH`] f32.
    type F: Copy;
    /// How many there are: 8 or 16.
    const WIDTH: usize;
    /// All lanes' bits.
    const ALL: u32 = (1 << Self::WIDTH) - 1;
    /// The first lanes' worth of `from`, which must be that long.
    fn load(self, from: &[f32]) -> Self::F;
    /// Writes to the start of `to`, which must be long enough.
    fn store(self, from: Self::F, to: &mut [f32]);
    /// The same number in all lanes.
    fn splat(self, x: f32) -> Self::F;
    /// The x, y and z of the first lanes' worth of `from`, which must be that long.
    #[inline(always)]
    fn load_vectors(self, from: &[Vec3]) -> [Self::F; 3] {
        let mut rows = [[0.0; 16]; 3];
        for (i, v) in from[..Self::WIDTH].iter().enumerate() {
            (rows[0][i], rows[1][i], rows[2][i]) = (v.x, v.y, v.z);
        }
        [self.load(&rows[0]), self.load(&rows[1]), self.load(&rows[2])]
    }
    /// `a` where the lane's bit is set, `b` elsewhere.
    fn pick(self, mask: u32, a: Self::F, b: Self::F) -> Self::F;
    /// a + b.
    fn add(self, a: Self::F, b: Self::F) -> Self::F;
    /// a − b.
    fn sub(self, a: Self::F, b: Self::F) -> Self::F;
    /// a · b.
    fn mul(self, a: Self::F, b: Self::F) -> Self::F;
    /// a / b.
    fn div(self, a: Self::F, b: Self::F) -> Self::F;
    /// a · b + c, rounded once or twice.
    fn mul_add(self, a: Self::F, b: Self::F, c: Self::F) -> Self::F;
    /// −(a · b) + c, rounded once or twice.
    fn neg_mul_add(self, a: Self::F, b: Self::F, c: Self::F) -> Self::F;
    /// The lesser; `b` where either is NaN.
    fn min(self, a: Self::F, b: Self::F) -> Self::F;
    /// The greater; `b` where either is NaN.
    fn max(self, a: Self::F, b: Self::F) -> Self::F;
    /// Magnitudes.
    fn abs(self, a: Self::F) -> Self::F;
    /// The least lane; none may be NaN.
    fn least(self, a: Self::F) -> f32;
    /// The largest lane; none may be NaN.
    fn most(self, a: Self::F) -> f32;
    /// A bit per lane where a ≤ b; clear where either is NaN.
    fn le(self, a: Self::F, b: Self::F) -> u32;
    /// A bit per lane where a < b; clear where either is NaN.
    fn lt(self, a: Self::F, b: Self::F) -> u32;
    /// Writes the lanes whose bit is set to the start of `to`, in order; what follows them is unspecified. `to` holds
    /// [`Lanes::WIDTH`] at least.
    fn compress(self, mask: u32, from: Self::F, to: &mut [f32]);
    /// The same of the first [`Lanes::WIDTH`] words of `from`.
    fn compress_words(self, mask: u32, from: &[u32], to: &mut [u32]);
    /// Copies the words of `from` at the first [`Lanes::WIDTH`] places of `at` to the start of `to`, in order.
    ///
    /// # Panics
    /// If a place lies outside `from`.
    #[inline(always)]
    fn gather_words(self, from: &[u32], at: &[u32], to: &mut [u32]) {
        for (to, at) in to[..Self::WIDTH].iter_mut().zip(&at[..Self::WIDTH]) {
            *to = from[*at as usize];
        }
    }
}

/// Eight lanes for the children of a node or the triangles of a block, with the ray lanes of the same processor.
pub trait NodeLanes: Lanes {
    /// Lanes for rays, as many as the processor has.
    type Rays: Lanes;
    /// They.
    fn rays(self) -> Self::Rays;

    /// Eight sets of up to 64 rays, one for each child.
    type Sets: Copy;
    /// All empty.
    fn no_sets(self) -> Self::Sets;
    /// Adds the ray of `bit` to the sets named by `mask`.
    fn add_to_sets(self, sets: Self::Sets, mask: u32, bit: u64) -> Self::Sets;
    /// Which of the sets are not empty.
    fn filled(self, sets: Self::Sets) -> u32;
    /// The sets as masks.
    fn stored_sets(self, sets: Self::Sets) -> [u64; 8];
}

/// Starts to fetch a value from memory, where the processor can, that it may have come by the time it is needed.
#[inline(always)]
pub fn prefetch<T>(value: &T) {
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    x86::prefetch(value);
    #[cfg(not(all(feature = "std", target_arch = "x86_64")))]
    let _ = value;
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::*;

    /// [`Lanes::gather_words`] of both kinds of lanes.
    struct Gather<'a>(&'a [u32], &'a [u32]);

    impl Work for Gather<'_> {
        type Output = [(usize, [u32; 16]); 2];
        fn run<L: NodeLanes>(self, lanes: L) -> Self::Output {
            let mut words = [[0; 16]; 2];
            lanes.gather_words(self.0, self.1, &mut words[0]);
            lanes.rays().gather_words(self.0, self.1, &mut words[1]);
            [(L::WIDTH, words[0]), (L::Rays::WIDTH, words[1])]
        }
    }

    #[test]
    fn words_are_gathered_from_their_places_and_from_no_other() {
        let from: [u32; 1000] = core::array::from_fn(|i| i as u32 * 0x9e37 + 1);
        let at: [u32; 16] = core::array::from_fn(|i| (i as u32 * 377 + 999) % 1000);
        for level in SimdLevel::available() {
            let chosen = Chosen::new(level).expect("an available level");
            for (count, words) in chosen.run(Gather(&from, &at)) {
                assert!((0..count).all(|i| words[i] == from[at[i] as usize]), "{level:?}: {words:?}");
            }
            for outside in [1000, 1 << 31, u32::MAX] {
                let mut at = at;
                at[5] = outside;
                let gathered = std::panic::catch_unwind(|| chosen.run(Gather(&from, &at)));
                assert!(gathered.is_err(), "{level:?} reads place {outside} of {}", from.len());
            }
        }
    }
}
