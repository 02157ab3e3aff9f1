//! A camera's way as keyframes in a small text file.

use std::path::Path;

use lt_math::glam::Vec3;

use crate::{Camera, SceneError};

/// Largest file read, bytes: days of keyframes.
const MAX_FILE_BYTES: u64 = 16 << 20;
/// Largest magnitude of a number, and least step between moments in seconds: curves between them then stay finite.
const MAX_NUMBER: f32 = 1.0e9;
const MIN_STEP_S: f32 = 1.0e-3;

/// Cameras at moments, with a smooth way between them.
///
/// As text, a line for each keyframe in order of time: the moment in seconds, the eye, the target, and the vertical field of view
/// in degrees, which may be left out to keep the last one's (first: that of the camera that the path replaces):
///
/// ```text
/// # seconds   eye            target        degrees
/// 0           0 1.7 20       0 1.5 0       55
/// 2.5         4 1.7 12       0 1.5 0
/// ```
///
/// Numbers are parted by blanks or commas; what follows a `#` is a remark.
#[derive(Clone, Debug, PartialEq)]
pub struct Keyframes {
    keys: Vec<Key>,
    /// Which way is up, and a name.
    base: Camera,
}

/// One camera.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Key {
    time_s: f32,
    eye: Vec3,
    target: Vec3,
    fov_y_rad: f32,
}

impl Keyframes {
    /// Reads a file; `base` gives what keyframes do not tell: up, and the first field of view if that is left out.
    ///
    /// # Errors
    /// [`SceneError::Io`] for a file that cannot be read, [`SceneError::Malformed`] naming line, problem and remedy for one that
    /// holds no path.
    pub fn open(path: &Path, base: Camera) -> Result<Self, SceneError> {
        let bytes = crate::file::read(path, MAX_FILE_BYTES)
            .map_err(|source| SceneError::Io { path: path.into(), source })?;
        let text = std::str::from_utf8(&bytes).map_err(|e| format!("no text: {e}"));
        text.and_then(|text| Self::parse(text, base)).map_err(|problem| SceneError::Malformed {
            path: path.into(),
            place: "keyframes".to_owned(),
            problem,
        })
    }

    /// Reads keyframes from text.
    ///
    /// # Errors
    /// In words, the line, what is wrong and what would be right.
    pub fn parse(text: &str, base: Camera) -> Result<Self, String> {
        let mut keys: Vec<Key> = Vec::new();
        // Some editors begin a file with a byte order mark.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        for (number, line) in text.lines().enumerate() {
            let line = line.split('#').next().unwrap_or_default();
            let words: Vec<&str> =
                line.split(|c: char| c.is_whitespace() || c == ',').filter(|w| !w.is_empty()).collect();
            if words.is_empty() {
                continue;
            }
            let usual_fov = keys.last().map_or(base.fov_y_rad, |k| k.fov_y_rad);
            let key = key(&words, usual_fov).and_then(|key| match keys.last() {
                Some(last) if key.time_s - last.time_s < MIN_STEP_S => Err(format!(
                    "its moment {} does not follow {}: times must ascend by {MIN_STEP_S} s or more",
                    key.time_s, last.time_s
                )),
                _ => Ok(key),
            });
            keys.push(key.map_err(|problem| format!("line {}: {problem}", number + 1))?);
        }
        if keys.is_empty() {
            return Err(
                "it holds no keyframe: write lines of seconds, eye, target: 0  0 1.7 20  0 1.5 0".into()
            );
        }
        Ok(Self { keys, base })
    }

    /// The camera at this many seconds after the first keyframe's moment; before it and after the last one, that one's.
    ///
    /// Between keyframes, eye, target and field of view follow cubic curves (Catmull and Rom's, for moments at any distance from
    /// each other) through all of them.
    pub fn at(&self, seconds: f32) -> Camera {
        let keys = &self.keys;
        let time = keys[0].time_s + seconds;
        let next = keys.partition_point(|k| k.time_s <= time);
        if next == 0 || next == keys.len() {
            return self.camera(&keys[next.saturating_sub(1)]);
        }
        let around =
            [next.saturating_sub(2), next - 1, next, (next + 1).min(keys.len() - 1)].map(|i| keys[i]);
        let times = around.map(|k| k.time_s);
        let along = |of: [f32; 4]| between(times, of, time);
        let point = |of: [Vec3; 4]| Vec3::from_array(std::array::from_fn(|axis| along(of.map(|v| v[axis]))));
        let fov_y_rad = along(around.map(|k| k.fov_y_rad));
        self.camera(&Key {
            time_s: time,
            eye: point(around.map(|k| k.eye)),
            target: point(around.map(|k| k.target)),
            // A curve may swing past its keyframes; a field of view must not leave its range.
            fov_y_rad: fov_y_rad.clamp(1e-3, std::f32::consts::PI - 1e-3),
        })
    }

    /// Seconds from the first keyframe to the last.
    pub fn duration_s(&self) -> f32 {
        self.keys[self.keys.len() - 1].time_s - self.keys[0].time_s
    }

    fn camera(&self, key: &Key) -> Camera {
        Camera { eye: key.eye, target: key.target, fov_y_rad: key.fov_y_rad, ..self.base.clone() }
    }
}

/// Cubic through the values 1 and 2, with the slopes of the chords around them (one-sided where a neighbour is missing, which
/// its time repeats).
fn between(times: [f32; 4], values: [f32; 4], time: f32) -> f32 {
    let slope = |a: usize, b: usize| (values[b] - values[a]) / (times[b] - times[a]);
    let (first, last) = (if times[0] < times[1] { 0 } else { 1 }, if times[2] < times[3] { 3 } else { 2 });
    let width = times[2] - times[1];
    let (start, end) = (slope(first, 2) * width, slope(1, last) * width);
    let t = (time - times[1]) / width;
    let (t2, t3) = (t * t, t * t * t);
    values[1] * (2.0 * t3 - 3.0 * t2 + 1.0)
        + start * (t3 - 2.0 * t2 + t)
        + values[2] * (3.0 * t2 - 2.0 * t3)
        + end * (t3 - t2)
}

fn key(words: &[&str], usual_fov: f32) -> Result<Key, String> {
    let number = |word: &&str| {
        let parsed = word.parse::<f32>().ok().filter(|n| n.abs() <= MAX_NUMBER);
        parsed.ok_or_else(|| format!("`{word}` is no number of at most {MAX_NUMBER} in magnitude"))
    };
    let n: Vec<f32> = words.iter().map(number).collect::<Result<_, _>>()?;
    let (fov_y_rad, n) = match n.len() {
        7 => (usual_fov, n),
        8 => (n[7].to_radians(), n),
        found => {
            return Err(format!(
                "{found} numbers: write 7 or 8: seconds, eye x y z, target x y z, degrees if wanted"
            ));
        }
    };
    if !(fov_y_rad > 0.0 && fov_y_rad < std::f32::consts::PI) {
        let degrees = fov_y_rad.to_degrees();
        return Err(format!("a field of view of {degrees} degrees: it must lie between 0 and 180"));
    }
    let (eye, target) = (Vec3::new(n[1], n[2], n[3]), Vec3::new(n[4], n[5], n[6]));
    if eye == target {
        return Err(format!("eye and target are both {eye}: move one of them"));
    }
    Ok(Key { time_s: n[0], eye, target, fov_y_rad })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn base() -> Camera {
        Camera { name: String::new(), eye: Vec3::ZERO, target: Vec3::NEG_Z, up: Vec3::Y, fov_y_rad: 1.0 }
    }

    #[test]
    fn a_path_runs_through_its_keyframes() {
        let text = "# a walk\n1 0 0 0  0,0,-9 60\n\n2 4 0 0 0 0 -9 # on\n5 4 2 1 1 0 -9 90\n";
        let path = Keyframes::parse(text, base()).unwrap();
        assert_eq!(path.duration_s(), 4.0);
        for (seconds, eye, degrees) in [
            (-1.0, Vec3::ZERO, 60.0f32),
            (0.0, Vec3::ZERO, 60.0),
            (1.0, Vec3::new(4.0, 0.0, 0.0), 60.0),
            (4.0, Vec3::new(4.0, 2.0, 1.0), 90.0),
            (9.0, Vec3::new(4.0, 2.0, 1.0), 90.0),
        ] {
            let camera = path.at(seconds);
            assert!((camera.eye - eye).length() < 1e-5, "{seconds}: {}", camera.eye);
            assert!((camera.fov_y_rad.to_degrees() - degrees).abs() < 1e-3);
            assert_eq!(camera.up, Vec3::Y);
        }
        let near = path.at(1.0 - 1e-3).eye.distance(path.at(1.0 + 1e-3).eye);
        assert!(near < 0.02, "no step at a keyframe: {near}");
    }

    #[test]
    fn steady_motion_stays_steady() {
        let path = Keyframes::parse("0 0 0 0 0 0 -1\n1 1 0 0 1 0 -1\n3 3 0 0 3 0 -1\n", base()).unwrap();
        for i in 0..=30 {
            let time = i as f32 * 0.1;
            assert!((path.at(time).eye.x - time).abs() < 1e-5, "{time}");
            assert_eq!(path.at(time).fov_y_rad, 1.0);
        }
    }

    #[cfg(unix)]
    #[test]
    fn a_file_without_end_is_refused() {
        let problem = Keyframes::open(Path::new("/dev/zero"), base()).unwrap_err().to_string();
        assert!(problem.contains("not a regular file"), "{problem}");
    }

    #[test]
    fn what_is_no_path_is_refused_by_line() {
        for (text, line) in [
            ("", "no keyframe"),
            ("# only\n", "no keyframe"),
            ("0 0 0 0 0 0\n", "line 1: 6 numbers"),
            ("0 0 0 0 0 0 1\n0 0 0 0 0 0 1\n", "line 2: its moment"),
            ("0 0 0 0 0 0 x\n", "`x`"),
            ("0 0 0 0 0 0 nan\n", "`nan`"),
            ("0 0 0 0 0 0 1e38\n", "`1e38`"),
            ("0 0 0 0 0 0 1\n1e-9 0 0 0 0 0 1\n", "line 2: its moment"),
            ("1e6 0 0 0 0 0 1\n1e6 0 0 0 0 0 1\n", "line 2: its moment"),
            ("0 1 2 3 1 2 3\n", "line 1: eye and target"),
            ("0 0 0 0 0 0 1 180\n", "180"),
        ] {
            let problem = Keyframes::parse(text, base()).unwrap_err();
            assert!(problem.contains(line), "{text:?}: {problem}");
        }
    }
}
