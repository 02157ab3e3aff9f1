//! The options every subcommand shares: which scene, seen from where, under which light, run on what.

use clap::{Args, value_parser};
use lt_math::glam::{UVec2, Vec3};
use lt_render::{BackendKind, RenderError, SampleGrid, Session, Setup, Technique, Upkeep};
use lt_scene::{Camera, Light, LightKind, Scene, Source};

use crate::{
    failure::Usage,
    numbers::grouped,
    progress::spinner,
    values::{self, Cone, Defaults, Ground, Lights},
};

/// Options shared by `compare`, `render` and `plan`.
#[derive(Args, Clone, Debug)]
pub struct SceneArgs {
    /// Built-in scene (see `lt scenes`) or path of a .gltf or .glb file
    #[arg(default_value = "street")]
    pub scene: String,
    /// Picture size in pixels
    #[arg(long, value_name = "WxH", default_value = "1280x720", value_parser = values::size, help_heading = "View and light")]
    pub size: UVec2,
    /// Samples per pixel: 1, 2, 4, 8, 16 or 32. Shadows are found, and errors and rays counted, sample by sample; pictures are their
    /// mean
    #[arg(long, value_name = "N", default_value = "1", value_parser = values::samples, help_heading = "View and light")]
    pub samples: SampleGrid,
    /// Where to run: auto takes a GPU unless it is a software one, else the CPU
    #[arg(long, value_name = "cpu|gpu|auto", default_value = "auto", help_heading = "Machine")]
    pub backend: BackendKind,
    /// Index of the scene's camera to look through
    #[arg(long, value_name = "N", help_heading = "View and light")]
    pub camera: Option<usize>,
    /// Camera position
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = values::point, help_heading = "View and light")]
    pub eye: Option<Vec3>,
    /// Point the camera looks at
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = values::point, help_heading = "View and light")]
    pub target: Option<Vec3>,
    /// Vertical field of view in degrees
    #[arg(long, value_name = "DEG", allow_hyphen_values = true, value_parser = values::degrees, help_heading = "View and light")]
    pub fov: Option<f32>,
    /// Index of the scene's light to draw shadows for
    #[arg(long, value_name = "N", conflicts_with_all = ["light_dir", "light_pos"], help_heading = "View and light")]
    pub light: Option<usize>,
    /// Indices of the scene's lights to draw shadows for, all at once: 0,2 or all
    #[arg(long, value_name = "N,…|all", conflicts_with_all = ["light", "light_dir", "light_pos"], value_parser = values::lights, help_heading = "View and light")]
    pub lights: Option<Lights>,
    /// Position of a point light; give it again for each further one, all at once. With --light-dir they are spot lights that all
    /// shine that way; --cone and --light-range hold for each
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = values::point, help_heading = "View and light")]
    pub light_pos: Vec<Vec3>,
    /// Half-angles in degrees past which spot lights do not shine, and up to which they shine fully [default: 30]
    #[arg(long, value_name = "OUTER[,INNER]", requires = "light_pos", requires = "light_dir", value_parser = values::cone, help_heading = "View and light")]
    pub cone: Option<Cone>,
    /// Distance past which spot or point lights have no effect [default: unlimited]
    #[arg(long, value_name = "X", requires = "light_pos", value_parser = values::range, help_heading = "View and light")]
    pub light_range: Option<f32>,
    /// Direction in which the light travels: a sun's, or with --light-pos the spot lights'
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = values::direction, help_heading = "View and light")]
    pub light_dir: Option<Vec3>,
    /// Add a ground square at this height, half its side optional
    #[arg(long, value_name = "y[,half]", allow_hyphen_values = true, value_parser = values::ground, help_heading = "Scene")]
    pub ground: Option<Ground>,
    /// Moment at which the scene is posed, in seconds
    #[arg(long, value_name = "SECONDS", default_value = "0", allow_hyphen_values = true, value_parser = values::finite, help_heading = "Scene")]
    pub time: f32,
    /// Draw the scene this many times as large: geometry, ground, lights and cameras of its own
    #[arg(long, value_name = "X", value_parser = values::range, help_heading = "Scene")]
    pub scale: Option<f32>,
    /// Seed of a built-in scene
    #[arg(long, value_name = "N", default_value_t = 1, help_heading = "Scene")]
    pub seed: u64,
    /// Let translucent surfaces (blended, or with KHR_materials_transmission) tint the light; else they block it or not
    #[arg(long, help_heading = "Scene")]
    pub translucent: bool,
    /// See through translucent surfaces: so many layers of what lies behind one another, each with shadows of its own; the last one
    /// hides the rest [default: 1]
    #[arg(long, value_name = "N", requires = "translucent", value_parser = value_parser!(u32).range(1..=16), help_heading = "Scene")]
    pub layers: Option<u32>,
    /// Shadow map resolution, a multiple of 64 [default: 2048]
    #[arg(long, value_name = "N", value_parser = values::map_size, help_heading = "Techniques")]
    pub map_size: Option<u32>,
    /// ε of the leak tracing techniques whose id does not set it [default: 0.01]
    #[arg(long, value_name = "X", allow_hyphen_values = true, value_parser = values::epsilon, help_heading = "Techniques")]
    pub epsilon: Option<f32>,
    /// Levels of a directional light's map, for techniques whose id does not say [default: ltt- and lt- 4, others 1]
    #[arg(long, value_name = "N", value_parser = lt_render::parse_count, help_heading = "Techniques")]
    pub cascades: Option<u32>,
    /// CPU threads [default: all]
    #[arg(long, value_name = "N", value_parser = value_parser!(u16).range(1..=1024), help_heading = "Machine")]
    pub threads: Option<u16>,
}

/// A spot light's cone unless told otherwise.
const DEFAULT_CONE: Cone = Cone { outer_deg: 30.0, inner_deg: 25.0 };

/// A scene ready to be drawn.
pub struct Opened {
    /// Holds BVH and visible samples.
    pub session: Session,
    /// The scene's name.
    pub name: String,
    /// What can be posed at other moments.
    pub source: Source,
    /// The pose that the session shows.
    pub scene: Scene,
}

impl SceneArgs {
    /// Loads the scene, applies the options, builds the BVH and finds the visible samples, in such a way that
    /// `techniques` can run, with this upkeep in every frame.
    ///
    /// # Errors
    /// What names no scene, cannot be read, or cannot be drawn; [`Usage`] for an option that does not fit the scene.
    pub fn open(&self, techniques: &[Technique], upkeep: Upkeep) -> anyhow::Result<Opened> {
        let work = spinner(&format!("loading {}", self.scene));
        let source = Source::open(&self.scene, self.seed)?;
        let scene = self.pose(&source, self.time)?;
        if let Some(repairs) = scene.repairs.summary() {
            work.suspend(|| eprintln!("note: {}: {repairs}", self.scene));
        }
        let mut setup = self.setup(&scene)?;
        setup.packing.bakes_copies =
            upkeep != Upkeep::Kept || techniques.iter().any(|t| t.resolve.is_in_light_space());
        setup.upkeep = upkeep;
        work.set_message(format!("building the BVH of {} triangles", grouped(scene.triangle_count() as u64)));
        let session = Session::new(&scene, setup, self.backend).map_err(|e| self.explain(e))?;
        work.finish_and_clear();
        if let Some(problem) = nothing_seen(&scene, &session) {
            eprintln!("warning: {}: {problem}", self.scene);
        }
        Ok(Opened { session, name: scene.name.clone(), source, scene })
    }

    /// What the options say about techniques whose ids leave it open.
    pub fn technique_defaults(&self) -> Defaults {
        Defaults { epsilon: self.epsilon, cascades: self.cascades }
    }

    /// The scene at a moment, ground included, scaled as asked for. The ground's size is that of the pose at the moment asked for by `--time`.
    ///
    /// # Errors
    /// A glTF file whose data is malformed.
    pub fn pose(&self, source: &Source, time_s: f32) -> anyhow::Result<Scene> {
        let mut scene = source.pose(time_s)?;
        if let Some(ground) = self.ground {
            let half_size = match ground.half_size {
                Some(half_size) => half_size,
                None if time_s == self.time => fitting_half_size(&scene),
                None => fitting_half_size(&source.pose(self.time)?),
            };
            scene.add_ground(ground.y, half_size);
        }
        if let Some(factor) = self.scale {
            scene.scale(factor);
        }
        Ok(scene)
    }

    fn explain(&self, error: RenderError) -> anyhow::Error {
        anyhow::Error::from(error).context(format!("scene {}", self.scene))
    }

    fn setup(&self, scene: &Scene) -> Result<Setup, Usage> {
        let mut setup = Setup::for_scene(scene, self.size.x, self.size.y);
        setup.samples = self.samples;
        if let Some(index) = self.camera {
            setup.camera = pick("--camera", index, &scene.cameras)?;
        }
        let mut lights = self.lights(scene)?.into_iter();
        setup.light = lights.next().unwrap_or(setup.light);
        setup.more_lights = lights.collect();
        self.aim(&mut setup.camera)?;
        setup.packing.traces_translucency = self.translucent;
        setup.packing.layers_behind = self.layers.map_or(0, |layers| layers - 1);
        setup.map_size = self.map_size.unwrap_or(setup.map_size);
        Ok(setup)
    }

    /// The lights that the options ask for, of a scene in any pose; at least one.
    ///
    /// # Errors
    /// [`Usage`] for an index that the scene does not have.
    pub fn lights(&self, scene: &Scene) -> Result<Vec<Light>, Usage> {
        let described = self.light_kinds();
        if !described.is_empty() {
            let of = |kind| Light { kind, ..Light::sun(Vec3::NEG_Y) };
            return Ok(described.into_iter().map(of).collect());
        }
        match (self.light, &self.lights) {
            (Some(index), _) => Ok(vec![pick("--light", index, &scene.lights)?]),
            (_, Some(Lights::Some(indices))) => {
                indices.iter().map(|&index| pick("--lights", index, &scene.lights)).collect()
            }
            (_, Some(Lights::All)) if !scene.lights.is_empty() => Ok(scene.lights.clone()),
            (_, Some(Lights::All)) => {
                Err(Usage("--lights all: the scene has none; leave the option out".into()))
            }
            (_, None) => Ok(vec![Setup::for_scene(scene, 1, 1).light]),
        }
    }

    /// Whether the lights are the scene's own, which its animation may move.
    pub fn lights_are_the_scenes(&self) -> bool {
        self.light_kinds().is_empty()
    }

    /// The lights that the options describe: a sun, or spot or point lights, or none.
    fn light_kinds(&self) -> Vec<LightKind> {
        let range = self.light_range.unwrap_or(f32::INFINITY);
        let direction = self.light_dir.map(Vec3::normalize);
        let cone = self.cone.unwrap_or(DEFAULT_CONE);
        let lamp = |&position: &Vec3| match direction {
            None => LightKind::Point { position, range },
            Some(direction) => LightKind::Spot {
                position,
                direction,
                inner_cone_rad: cone.inner_deg.to_radians(),
                outer_cone_rad: cone.outer_deg.to_radians(),
                range,
            },
        };
        match direction.filter(|_| self.light_pos.is_empty()) {
            Some(direction) => vec![LightKind::Directional { direction }],
            None => self.light_pos.iter().map(lamp).collect(),
        }
    }

    fn aim(&self, camera: &mut Camera) -> Result<(), Usage> {
        camera.eye = self.eye.unwrap_or(camera.eye);
        camera.target = self.target.unwrap_or(camera.target);
        camera.fov_y_rad = self.fov.map_or(camera.fov_y_rad, f32::to_radians);
        if camera.eye == camera.target {
            return Err(Usage(format!("--eye and --target are both {}; move one of them", camera.eye)));
        }
        Ok(())
    }
}

fn pick<T: Clone>(option: &str, index: usize, from: &[T]) -> Result<T, Usage> {
    from.get(index).cloned().ok_or_else(|| {
        Usage(match from.len() {
            0 => format!("{option} {index}: the scene has none; leave the option out"),
            1 => format!("{option} {index}: the scene has only number 0"),
            n => format!("{option} {index}: the scene has numbers 0 to {}", n - 1),
        })
    })
}

/// Why the picture is empty, if it is, and what to do about it.
fn nothing_seen(scene: &Scene, session: &Session) -> Option<String> {
    if scene.triangle_count() == 0 {
        let problem = "no triangles: no node of the scene that the file shows has a mesh of them (points and lines are not drawn); export \
                       meshes, or add --ground 0";
        return Some(problem.to_owned());
    }
    let sees = session.valid_samples().iter().flatten().any(|is_valid| *is_valid);
    let (camera, bounds) = (&session.setup().camera, scene.bounds());
    (!sees).then(|| {
        format!(
            "the camera at {} looking at {} sees none of it: it lies from {} to {}; aim with --eye and --target",
            words(camera.eye),
            words(camera.target),
            words(bounds.min),
            words(bounds.max)
        )
    })
}

/// A point as options take it.
fn words(p: Vec3) -> String {
    format!("{},{},{}", p.x, p.y, p.z)
}

/// Twice the scene's largest extent: shadows of a low sun still fall on it.
fn fitting_half_size(scene: &Scene) -> f32 {
    let bounds = scene.bounds();
    match bounds.is_empty() {
        true => 10.0,
        false => (bounds.max - bounds.min).max_element().max(1e-3) * 2.0,
    }
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::*;

    #[derive(Parser)]
    struct Line {
        #[command(flatten)]
        args: SceneArgs,
    }

    fn parse(words: &[&str]) -> Result<SceneArgs, clap::Error> {
        Line::try_parse_from(["lt"].iter().chain(words)).map(|l| l.args)
    }

    #[test]
    fn the_default_is_the_street_in_720p() {
        let args = parse(&[]).unwrap();
        assert_eq!((args.scene.as_str(), args.size), ("street", UVec2::new(1280, 720)));
    }

    #[test]
    fn values_may_begin_with_a_minus() {
        let args = parse(&["--eye", "-1,2,3", "--light-dir", "-1,-2,0", "--ground", "-3,4", "--time", "-1"])
            .unwrap();
        assert_eq!(args.eye, Some(Vec3::new(-1.0, 2.0, 3.0)));
        assert_eq!(args.light_dir, Some(Vec3::new(-0.5, -1.0, 0.0)));
        assert_eq!(args.ground, Some(Ground { y: -3.0, half_size: Some(4.0) }));
        assert_eq!(args.time, -1.0);
    }

    #[test]
    fn nonsense_is_refused() {
        for words in [
            ["--size", "12"],
            ["--eye", "1,2,nan"],
            ["--fov", "180"],
            ["--threads", "0"],
            ["--backend", "tpu"],
            ["--epsilon", "0.5"],
            ["--time", "inf"],
            ["--light-dir", "0,0,0"],
            ["--samples", "3"],
            ["--samples", "64"],
        ] {
            assert!(parse(&words).is_err(), "{words:?}");
        }
        assert!(parse(&["--layers", "2"]).is_err() && parse(&["--layers", "17", "--translucent"]).is_err());
        assert!(parse(&["--light", "0", "--light-dir", "0,-1,0"]).is_err());
        assert!(parse(&["--light", "0", "--lights", "all"]).is_err());
        assert!(parse(&["--light", "0", "--light-pos", "0,-1,0"]).is_err());
        assert!(parse(&["--light-pos", "0,1,0", "--cone", "20"]).is_err());
        assert!(parse(&["--light-dir", "0,-1,0", "--light-range", "2"]).is_err());
    }

    #[test]
    fn an_index_past_the_end_names_the_range() {
        assert_eq!(pick("--camera", 2, &[7, 8]).unwrap_err().0, "--camera 2: the scene has numbers 0 to 1");
        assert_eq!(
            pick::<u8>("--light", 0, &[]).unwrap_err().0,
            "--light 0: the scene has none; leave the option out"
        );
        assert_eq!(pick("--camera", 1, &[7, 8]).unwrap(), 8);
    }

    #[test]
    fn several_lights_are_picked_in_the_order_asked_for() {
        let suns = [Vec3::NEG_Y, Vec3::NEG_X, Vec3::NEG_Z].map(Light::sun);
        let scene = Scene { lights: suns.to_vec(), ..Scene::default() };
        let lights = |words: &[&str]| parse(words).unwrap().lights(&scene);
        assert_eq!(lights(&["--lights", "2,0"]).unwrap(), [suns[2].clone(), suns[0].clone()]);
        assert_eq!(lights(&["--lights", "all"]).unwrap(), suns);
        assert_eq!(lights(&["--light", "1"]).unwrap(), [suns[1].clone()]);
        assert_eq!(lights(&[]).unwrap(), [suns[0].clone()]);
        assert!(lights(&["--lights", "0,3"]).unwrap_err().0.contains("numbers 0 to 2"));
        assert!(parse(&["--lights", "all"]).unwrap().lights(&Scene::default()).is_err());
        let setup = parse(&["--lights", "1,2"]).unwrap().setup(&scene).unwrap();
        assert_eq!((setup.light, setup.more_lights), (suns[1].clone(), vec![suns[2].clone()]));
    }

    #[test]
    fn places_and_direction_make_the_lights() {
        let kinds = |words: &[&str]| parse(words).unwrap().light_kinds();
        assert!(kinds(&[]).is_empty());
        assert_eq!(kinds(&["--light-dir", "0,-2,0"]), [LightKind::Directional { direction: Vec3::NEG_Y }]);
        let point = |x: f32| LightKind::Point { position: Vec3::new(x, 2.0, 3.0), range: 7.0 };
        let words = ["--light-pos", "1,2,3", "--light-range", "7", "--light-pos", "-4,2,3"];
        assert_eq!(kinds(&words[..4]), [point(1.0)]);
        assert_eq!(kinds(&words), [point(1.0), point(-4.0)]);
        let setup = parse(&words).unwrap().setup(&Scene::default()).unwrap();
        assert_eq!((setup.light.kind, setup.more_lights[0].kind), (point(1.0), point(-4.0)));
        let words =
            ["--light-pos", "1,2,3", "--light-dir", "0,-1,0", "--cone", "60,45", "--light-pos", "0,2,0"];
        let spots = kinds(&words);
        assert_eq!(spots.len(), 2);
        for spot in spots {
            let LightKind::Spot { direction, inner_cone_rad, outer_cone_rad, range, .. } = spot else {
                panic!("{spot:?}")
            };
            let cone_deg = (inner_cone_rad.to_degrees().round(), outer_cone_rad.to_degrees().round());
            assert_eq!((direction, cone_deg, range), (Vec3::NEG_Y, (45.0, 60.0), f32::INFINITY));
        }
    }

    #[test]
    fn a_camera_cannot_look_at_itself() {
        let args = parse(&["--eye", "0,5,0", "--target", "0,5,0"]).unwrap();
        assert!(args.setup(&Scene::default()).is_err());
    }
}
