//! What the modifiers of a technique's id mean, in words.

use crate::Technique;

impl Technique {
    /// The modifiers an id may carry, with a line each.
    pub fn modifiers() -> [(&'static str, &'static str); 22] {
        [
            ("prefiltered", "blur a map of depth vectors instead of gathering plain depths"),
            ("eps=X", "LTT's ε, 0 < X < 0.5 (default 0.01)"),
            (
                "light",
                "ray, ltt-, lt-: the rays' answers from a tree in the light's own space, kept while light and \
                 casters stand still",
            ),
            ("dac", "ray, ltt-, lt-: the same by dividing points and triangles together, nothing kept (CPU)"),
            (
                "space",
                "ray, ltt-, lt-: `light` where light and casters stand still over several frames, else `dac`; on \
                 the GPU `light`",
            ),
            (
                "alias-free",
                "ltt-, lt-, and a technique by itself: the same by drawing triangles at the points, nothing kept (CPU)",
            ),
            ("map=N", "map resolution, a multiple of 64 up to 16384"),
            (
                "cascades=N",
                "levels of a directional light's map, 1 to 16 (default: ltt- and lt- 4, others 1)",
            ),
            ("lambda=X", "share of logarithmic against linear splits, 0 to 1 (default 0.85)"),
            ("splits=A/B/…", "view depths where levels meet, instead of cascades= and lambda="),
            (
                "far=map|ray",
                "what answers in the last level: a map, or rays for all of it (default: ltt- and lt- ray)",
            ),
            ("no-reuse", "over several frames: draw the map every frame instead of keeping it while it fits"),
            ("no-rr", "lt-: keep no answers where nothing moves"),
            ("no-er", "lt-: expand no rays"),
            (
                "expand=R",
                "lt-: whose neighbours trace: published (eq. 6), rays (those whose ray contradicts), leaks (whose \
                 ray found the map wrong); default leaks, rays where casters have holes; published in frames \
                 that draw a map anew",
            ),
            (
                "published",
                "lt-: the paper's rules as published: eq. 6, rays removed by eq. 8 where pixels move too, one \
                 pattern for all",
            ),
            (
                "pattern=P",
                "lt-: neighbours asked where pixels stand still: 3x3, plus, cross, checkerboard, alternating, \
                 gather (default: a 2×2 jittered over 4 frames), 5x5, diamond (13 within two steps)",
            ),
            (
                "moving=P",
                "lt-: neighbours asked where pixels or casters move: the same names (default 5x5; diamond where casters have no holes and there are marks)",
            ),
            (
                "refresh=N",
                "lt-: trace every pixel once in N frames, 2 to 256, on a rolling pattern (default: never)",
            ),
            (
                "depth-test",
                "lt-: a pixel that the last frame saw at another depth counts as new (default: esm, msm)",
            ),
            ("no-depth-test", "lt-: without it"),
            (
                "no-marks",
                "lt-: rays that contradict a map leave no marks in it (default: they do while it is kept, and the texels are doubted from then on)",
            ),
        ]
    }
}
