//! Which instructions are used: the widest that the processor has, found at run time, or fewer on request.

#[cfg(all(feature = "std", target_arch = "x86_64"))]
use super::{Avx2, Avx512};
use super::{NodeLanes, Portable};

/// Instruction sets; answers are the same on all.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SimdLevel {
    /// What every processor of the target has.
    Portable,
    /// AVX2 and FMA, BMI1, BMI2, LZCNT and POPCNT.
    Avx2,
    /// AVX-512F and AVX-512VL besides.
    Avx512,
}

impl SimdLevel {
    /// Every level that this processor runs, the slowest first; never none. Without feature `std` the first only.
    pub fn available() -> impl Iterator<Item = Self> {
        [Self::Portable, Self::Avx2, Self::Avx512].into_iter().filter(|level| Chosen::new(*level).is_some())
    }

    /// The widest that this processor runs.
    pub fn best() -> Self {
        Self::available().last().unwrap_or(Self::Portable)
    }
}

/// Work that is compiled once per instruction set.
pub trait Work {
    /// What comes of it.
    type Output;
    /// Does it.
    fn run<L: NodeLanes>(self, lanes: L) -> Self::Output;
}

/// A level with the proof that the processor has it.
#[derive(Clone, Copy, Debug)]
pub enum Chosen {
    /// Nothing to prove.
    Portable,
    /// [`SimdLevel::Avx2`].
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    Avx2(Avx2),
    /// [`SimdLevel::Avx512`].
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    Avx512(Avx512),
}

impl Chosen {
    /// `None` where the processor lacks the level.
    pub fn new(level: SimdLevel) -> Option<Self> {
        match level {
            SimdLevel::Portable => Some(Chosen::Portable),
            #[cfg(all(feature = "std", target_arch = "x86_64"))]
            SimdLevel::Avx2 => Avx2::detect().map(Chosen::Avx2),
            #[cfg(all(feature = "std", target_arch = "x86_64"))]
            SimdLevel::Avx512 => Avx512::detect().map(Chosen::Avx512),
            #[cfg(not(all(feature = "std", target_arch = "x86_64")))]
            SimdLevel::Avx2 | SimdLevel::Avx512 => None,
        }
    }

    /// The widest that this processor has.
    pub fn best() -> Self {
        Self::new(SimdLevel::best()).unwrap_or(Chosen::Portable)
    }

    /// Does the work on these instructions.
    #[inline]
    pub fn run<W: Work>(self, work: W) -> W::Output {
        match self {
            Chosen::Portable => work.run(Portable),
            #[cfg(all(feature = "std", target_arch = "x86_64"))]
            // SAFETY: the token proves that the processor has the features enabled there.
            Chosen::Avx2(lanes) => unsafe { run_avx2(lanes, work) },
            #[cfg(all(feature = "std", target_arch = "x86_64"))]
            // SAFETY: the token proves that the processor has the features enabled there.
            Chosen::Avx512(lanes) => unsafe { run_avx512(lanes, work) },
        }
    }
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
fn run_avx2<W: Work>(lanes: Avx2, work: W) -> W::Output {
    work.run(lanes)
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[target_feature(enable = "avx512f,avx512vl,avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
fn run_avx512<W: Work>(lanes: Avx512, work: W) -> W::Output {
    work.run(lanes)
}
