//! What to look at and under which light.

use lt_mask::MAX_LIGHTS;
use lt_math::glam::{UVec2, Vec3};
use lt_scene::{Camera, Light, LightKind, Scene};
use lt_shaders::abi::Sample;

use crate::{Packing, RenderError, SampleGrid, Upkeep, technique::MAX_MAP_SIZE};

/// View, light and map resolution of a session.
#[derive(Clone, Debug)]
pub struct Setup {
    /// Picture size in pixels, each side 1 to 16384.
    pub size: UVec2,
    /// Samples of a pixel; those of all pixels and layers are [`MAX_SAMPLES`] at most.
    pub samples: SampleGrid,
    /// Who looks.
    pub camera: Camera,
    /// What shines.
    pub light: Light,
    /// What else shines; [`lt_mask::MAX_LIGHTS`] in all at most. Every light has maps, rays and history of its own.
    pub more_lights: Vec<Light>,
    /// Default map resolution, a multiple of 64.
    pub map_size: u32,
    /// How the scene is packed.
    pub packing: Packing,
    /// What every frame does to the structures that it traces with, as part of its time.
    pub upkeep: Upkeep,
}

/// Most samples of a picture: 1920 × 1080 pixels of 32, and a little more, which take about 8 GiB on the CPU.
pub const MAX_SAMPLES: u64 = 1 << 26;
/// Most layers of what the camera sees.
const MAX_LAYERS: u64 = 16;
/// What a sample takes at least on the CPU: twice the visible sample (in tiles and in rows), and twice its shadow.
const BYTES_PER_SAMPLE: u64 =
    2 * size_of::<Sample>() as u64 + 2 * (size_of::<f32>() + size_of::<bool>()) as u64;

/// Map resolution unless told otherwise (the leak tracing paper's).
const DEFAULT_MAP_SIZE: u32 = 2048;
/// Where the sun comes from when a scene has no directional light.
const DEFAULT_SUN: Vec3 = Vec3::new(-0.5, -1.0, -0.35);

impl Setup {
    /// The scene's first camera (else one that frames its bounds) and first directional light (else its first light, else a
    /// default sun).
    pub fn for_scene(scene: &Scene, width: u32, height: u32) -> Self {
        let camera = scene.cameras.first().cloned().unwrap_or_else(|| framing_camera(scene));
        let is_sun = |l: &&Light| matches!(l.kind, LightKind::Directional { .. });
        let light = scene.lights.iter().find(is_sun).or(scene.lights.first());
        let light = light.cloned().unwrap_or_else(|| Light::sun(DEFAULT_SUN));
        Self {
            size: UVec2::new(width, height),
            samples: SampleGrid::ONE,
            camera,
            light,
            more_lights: Vec::new(),
            map_size: DEFAULT_MAP_SIZE,
            packing: Packing::default(),
            upkeep: Upkeep::Kept,
        }
    }

    /// Refuses what cannot be drawn.
    ///
    /// # Errors
    /// [`RenderError::BadSetup`] naming the field, the value and the range.
    pub fn check(&self) -> Result<(), RenderError> {
        let bad = |problem: String| Err(RenderError::BadSetup(problem));
        if self.size.min_element() == 0 || self.size.max_element() > 16384 {
            return bad(format!(
                "picture size {}×{}: each side must be 1 to 16384",
                self.size.x, self.size.y
            ));
        }
        let layers = 1 + u64::from(self.packing.layers_behind);
        if layers > MAX_LAYERS || (layers > 1 && !self.packing.traces_translucency) {
            return bad(format!(
                "{layers} layers: must be 1 to {MAX_LAYERS}, and more than 1 only where translucency is traced (--translucent)"
            ));
        }
        let (pixels, each) =
            (u64::from(self.size.x) * u64::from(self.size.y), u64::from(self.samples.count()) * layers);
        let most = MAX_SAMPLES / each;
        if pixels > most {
            let gib = (pixels * each * BYTES_PER_SAMPLE) as f64 / f64::from(1 << 30);
            return bad(format!(
                "picture size {}×{} at {} samples per pixel in {layers} layers needs {gib:.1} GiB for its samples: with so many, a \
                 picture may have up to {most} pixels; make it smaller or take fewer samples",
                self.size.x, self.size.y, self.samples
            ));
        }
        let c = &self.camera;
        if !(c.eye.is_finite() && c.target.is_finite()) || (c.target - c.eye).try_normalize().is_none() {
            return bad(format!(
                "camera at {} looking at {}: they must be finite and differ, and their distance must be 1e-19 to 1e19",
                c.eye, c.target
            ));
        }
        if !(c.fov_y_rad > 0.0 && c.fov_y_rad < std::f32::consts::PI) {
            return bad(format!("field of view {} rad: must lie between 0 and π", c.fov_y_rad));
        }
        if self.map_size == 0 || !self.map_size.is_multiple_of(64) || self.map_size > MAX_MAP_SIZE {
            return bad(format!("map size {}: must be a multiple of 64 up to {MAX_MAP_SIZE}", self.map_size));
        }
        let count = self.lights().count();
        if count > MAX_LIGHTS as usize {
            return bad(format!("{count} lights: at most {MAX_LIGHTS}"));
        }
        self.lights().try_for_each(|light| check_light(&light.kind))
    }

    /// The picture's size in samples.
    pub fn size_in_samples(&self) -> UVec2 {
        self.size * self.samples.size()
    }

    /// All lights, the first one first.
    pub fn lights(&self) -> impl Iterator<Item = &Light> {
        std::iter::once(&self.light).chain(&self.more_lights)
    }
}

fn check_light(light: &LightKind) -> Result<(), RenderError> {
    let bad = |problem: String| Err(RenderError::BadSetup(problem));
    match *light {
        LightKind::Directional { direction } => check_direction(direction),
        LightKind::Point { position, range } => check_lamp(position, range),
        LightKind::Spot { position, direction, inner_cone_rad, outer_cone_rad, range } => {
            check_direction(direction)?;
            let right_angle = std::f32::consts::FRAC_PI_2;
            let is_ordered = inner_cone_rad >= 0.0 && inner_cone_rad <= outer_cone_rad;
            let is_open = outer_cone_rad > 0.0 && outer_cone_rad < right_angle;
            if !(is_ordered && is_open) {
                return bad(format!(
                    "cone of {inner_cone_rad} to {outer_cone_rad} rad: must be 0 ≤ inner ≤ outer < π/2"
                ));
            }
            check_lamp(position, range)
        }
    }
}

/// Whether a direction has a length to be divided by: squares of components beyond 1e19 overflow, those below 1e-19 vanish.
fn check_direction(direction: Vec3) -> Result<(), RenderError> {
    match direction.try_normalize() {
        Some(_) => Ok(()),
        None => Err(RenderError::BadSetup(format!(
            "light direction {direction}: must be finite, and 1e-19 to 1e19 long"
        ))),
    }
}

fn check_lamp(position: Vec3, range: f32) -> Result<(), RenderError> {
    // Vectors from what is seen to the light are normalised.
    if position.length_squared().is_finite() && range > 0.0 {
        return Ok(());
    }
    Err(RenderError::BadSetup(format!(
        "light at {position} of range {range}: the place must be within 1e19 of the origin, the range above 0"
    )))
}

fn framing_camera(scene: &Scene) -> Camera {
    let bounds = scene.bounds();
    let (center, radius) = match bounds.is_empty() {
        true => (Vec3::ZERO, 1.0),
        false => ((bounds.min + bounds.max) * 0.5, ((bounds.max - bounds.min).length() * 0.5).max(1e-6)),
    };
    Camera {
        name: "framing".to_owned(),
        eye: center + Vec3::new(0.55, 0.45, 0.9).normalize() * radius * 2.2,
        target: center,
        up: Vec3::Y,
        fov_y_rad: 55f32.to_radians(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn setup() -> Setup {
        Setup::for_scene(&Scene::default(), 8, 8)
    }

    fn problem(setup: &Setup) -> String {
        setup.check().expect_err("refused").to_string()
    }

    #[test]
    fn the_usual_setup_is_accepted() {
        assert!(setup().check().is_ok());
    }

    #[test]
    fn a_camera_whose_distance_overflows_or_vanishes_is_refused() {
        for (eye, target) in [
            (Vec3::new(2e19, 0.0, 0.0), Vec3::ZERO),
            (Vec3::new(1e-30, 0.0, 0.0), Vec3::ZERO),
            (Vec3::ONE, Vec3::ONE),
            (Vec3::NAN, Vec3::ZERO),
        ] {
            let mut setup = setup();
            (setup.camera.eye, setup.camera.target) = (eye, target);
            assert!(problem(&setup).contains("their distance must be"), "{eye} {target}");
        }
    }

    #[test]
    fn directions_and_places_that_cannot_be_normalised_are_refused() {
        let shine = |kind: LightKind| {
            let mut setup = setup();
            setup.light.kind = kind;
            setup
        };
        for length in [0.0, 1e-30, 2e19, f32::INFINITY, f32::NAN] {
            let direction = Vec3::new(0.0, -length, 0.0);
            assert!(problem(&shine(LightKind::Directional { direction })).contains("light direction"));
            let (inner_cone_rad, outer_cone_rad, range) = (0.1, 0.2, 1.0);
            let spot =
                LightKind::Spot { position: Vec3::ZERO, direction, inner_cone_rad, outer_cone_rad, range };
            assert!(problem(&shine(spot)).contains("light direction"));
        }
        assert!(shine(LightKind::Directional { direction: Vec3::new(0.0, -1e18, 0.0) }).check().is_ok());
        for x in [2e19, f32::INFINITY, f32::NAN] {
            let kind = LightKind::Point { position: Vec3::new(x, 0.0, 0.0), range: 1.0 };
            assert!(problem(&shine(kind)).contains("within 1e19"), "{x}");
        }
    }
}
