//! What Kern, Brüll and Grosch (EGSR 2024) report: RTX 2080 SUPER, 1920×1080, one sun, three maps of 2048² and a traced last
//! level. Their scenes are not ours.

/// Average, least and largest of something.
pub type Spread = [f64; 3];

/// Table 2: speed-ups of LtEVSM over full ray tracing without shading, then with.
pub const SPEED_UPS: [(&str, Spread, Spread); 4] = [
    ("Bistro", [1.74, 1.21, 2.62], [1.36, 1.12, 1.76]),
    ("Emerald Square", [1.55, 0.90, 3.90], [1.34, 0.91, 2.88]),
    ("Medieval City", [1.57, 1.01, 4.17], [1.19, 0.92, 2.71]),
    ("Forest", [1.61, 1.24, 2.04], [1.30, 1.12, 1.52]),
];

/// Table 3: milliseconds along the path through Emerald Square, by our names.
pub const TIMES_MS: [(&str, Spread); 8] = [
    ("sm", [2.54, 1.29, 3.58]),
    ("vsm", [2.79, 1.57, 3.81]),
    ("msm", [3.39, 2.18, 4.40]),
    ("ray", [1.67, 0.56, 3.33]),
    ("lt-evsm", [1.31, 0.58, 2.41]),
    ("lt-evsm:no-rr", [1.38, 0.59, 2.60]),
    ("lt-evsm:no-reuse", [2.85, 1.34, 4.52]),
    ("ltt-evsm", [1.03, 0.49, 1.91]),
];

/// Figure 8: average speed-ups with shading in Bistro by picture size; the second is Table 2's.
pub const PICTURE_SIZES: [(&str, f64); 4] =
    [("1280x720", 1.21), ("1920x1080", 1.36), ("2560x1440", 1.44), ("3840x2160", 1.50)];

/// Figure 8: the same by map size.
pub const MAP_SIZES: [(u32, f64); 4] = [(512, 1.39), (1024, 1.37), (2048, 1.36), (4096, 1.24)];
