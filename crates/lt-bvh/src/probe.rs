//! Counters that a traversal may carry and that vanish when it carries none.

/// Told of every box node and every triangle that a traversal tests.
pub trait Probe {
    /// One eight-wide node was tested.
    fn node(&mut self);
    /// One triangle was tested.
    fn triangle(&mut self);
}

/// Counts nothing and costs nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoProbe;

impl Probe for NoProbe {
    #[inline(always)]
    fn node(&mut self) {}
    #[inline(always)]
    fn triangle(&mut self) {}
}

/// How much work a ray was.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Eight-wide nodes tested, TLAS and BLAS together.
    pub nodes: u32,
    /// Triangles tested.
    pub triangles: u32,
}

impl Probe for Counts {
    #[inline(always)]
    fn node(&mut self) {
        self.nodes += 1;
    }
    #[inline(always)]
    fn triangle(&mut self) {
        self.triangles += 1;
    }
}
