//! Which instructions are used: the widest that the processor has, found at run time, or fewer on request.

use crate::lanes::{Level, Portable};
use alloc::vec::Vec;

/// Instruction sets; the answers are the same on all.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Instructions {
    /// What every processor of the target has.
    Portable,
    /// AVX2 and FMA, BMI1, BMI2 and POPCNT.
    Avx2,
    /// AVX-512F and AVX-512VL besides.
    Avx512,
}

impl Instructions {
    /// Every set that this processor runs, the slowest first; never empty. Without feature `std` the first only.
    pub fn available() -> Vec<Self> {
        let all = [Self::Portable, Self::Avx2, Self::Avx512];
        all.into_iter().filter(|i| Chosen::new(*i).is_some()).collect()
    }

    /// The widest set that this processor runs.
    pub fn best() -> Self {
        [Self::Avx512, Self::Avx2].into_iter().find(|i| Chosen::new(*i).is_some()).unwrap_or(Self::Portable)
    }
}

/// Work that is compiled once per instruction set.
pub(crate) trait Work {
    type Output;
    fn run<L: Level>(self, level: L) -> Self::Output;
}

/// A set with the proof that the processor has it.
#[derive(Clone, Copy)]
pub(crate) enum Chosen {
    Portable,
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    Avx2(crate::lanes::x86::Avx2),
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    Avx512(crate::lanes::x86::Avx512),
}

impl Chosen {
    pub fn new(instructions: Instructions) -> Option<Self> {
        match instructions {
            Instructions::Portable => Some(Chosen::Portable),
            #[cfg(all(feature = "std", target_arch = "x86_64"))]
            Instructions::Avx2 => crate::lanes::x86::Avx2::detect().map(Chosen::Avx2),
            #[cfg(all(feature = "std", target_arch = "x86_64"))]
            Instructions::Avx512 => crate::lanes::x86::Avx512::detect().map(Chosen::Avx512),
            #[cfg(not(all(feature = "std", target_arch = "x86_64")))]
            Instructions::Avx2 | Instructions::Avx512 => None,
        }
    }

    #[inline]
    pub fn run<W: Work>(self, work: W) -> W::Output {
        match self {
            Chosen::Portable => work.run(Portable),
            #[cfg(all(feature = "std", target_arch = "x86_64"))]
            // SAFETY: the token proves that the processor has the features enabled there.
            Chosen::Avx2(level) => unsafe { run_avx2(level, work) },
            #[cfg(all(feature = "std", target_arch = "x86_64"))]
            // SAFETY: the token proves that the processor has the features enabled there.
            Chosen::Avx512(level) => unsafe { run_avx512(level, work) },
        }
    }
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[target_feature(enable = "avx2,fma,bmi1,bmi2,popcnt")]
fn run_avx2<W: Work>(level: crate::lanes::x86::Avx2, work: W) -> W::Output {
    work.run(level)
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[target_feature(enable = "avx512f,avx512vl,avx2,fma,bmi1,bmi2,popcnt")]
fn run_avx512<W: Work>(level: crate::lanes::x86::Avx512, work: W) -> W::Output {
    work.run(level)
}
