//! An engine with its own device, textures and encoder: frames planned by `FramePlanner` and recorded by `gpu::Recorder`.

use lt_math::glam::UVec2;
use lt_render::gpu::{FrameBuffers, GBuffer, GpuScene, Recorder, open};
use lt_render::{
    FrameJob, FramePlanner, PackedScene, RenderError, Sample, Sequence, Setup, Technique, places_of,
};
use lt_scene::{Light, LightKind, Scene};
use lt_tests::textures::{download, upload, visibility_texture};
use lt_tests::{REQUIRE_GPU, builtin, count_different, gpu_session};

const SIZE: UVec2 = UVec2::new(192, 108);

/// What an engine has.
struct Engine {
    device: wgpu::Device,
    queue: wgpu::Queue,
    recorder: Recorder,
    scene: GpuScene,
    frame: FrameBuffers,
}

impl Engine {
    /// `None` (said on stderr) where there is no adapter.
    fn new(scene: &PackedScene) -> Option<Self> {
        let Ok((_, device, queue)) = open() else {
            assert!(std::env::var_os(REQUIRE_GPU).is_none(), "no adapter");
            eprintln!("skipped: no GPU adapter");
            return None;
        };
        let recorder = Recorder::new(&device);
        let scene = recorder.upload(scene).expect("fits");
        let frame = recorder.frame_buffers(SIZE).expect("fits");
        Some(Self { device, queue, recorder, scene, frame })
    }

    /// Imports a G-buffer and records a light's passes; its visibility.
    fn draw(&mut self, samples: &[Sample], is_moving: bool, job: &FrameJob) -> Result<Vec<f32>, RenderError> {
        let texture = |of: &dyn Fn(&Sample) -> [f32; 4]| {
            upload(&self.device, &self.queue, SIZE, &samples.iter().map(of).collect::<Vec<_>>())
        };
        let positions = texture(&|s| s.position.extend(s.magnitude).to_array());
        let normals =
            texture(&|s| s.normal.extend(if s.flags & Sample::RECEIVES == 0 { 1.0 } else { 0.0 }).to_array());
        let last_positions = is_moving.then_some(&positions);
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let gbuffer = GBuffer { positions: &positions, normals: &normals, last_positions };
        self.recorder.import_gbuffer(&mut encoder, &mut self.frame, gbuffer)?;
        self.recorder.prepare(&mut self.frame, job)?;
        for kind in job.passes() {
            self.recorder.pass(&mut encoder, &self.scene, &self.frame, kind, job)?;
        }
        let target = visibility_texture(&self.device, SIZE.x, SIZE.y);
        let view = target.create_view(&wgpu::TextureViewDescriptor::default());
        self.recorder.export_visibility(&mut encoder, &self.frame, &view)?;
        Ok(download(&self.device, &self.queue, encoder, &target))
    }
}

/// A setup with a lamp beside the sun.
fn two_lights(scene: &Scene) -> Setup {
    let setup = Setup { map_size: 256, ..Setup::for_scene(scene, SIZE.x, SIZE.y) };
    let bounds = scene.bounds();
    let middle = bounds.min.lerp(bounds.max, 0.5).with_y(bounds.min.lerp(bounds.max, 0.8).y);
    let lamp =
        Light { kind: LightKind::Point { position: middle, range: f32::INFINITY }, ..setup.light.clone() };
    Setup { more_lights: vec![lamp], ..setup }
}

/// Frame after frame as a session of the same device draws them: kept maps, masks that learn, several lights; with and without last
/// positions of what, as it turns out, does not move.
#[test]
fn frames_recorded_one_after_the_other_are_the_session_s() {
    let scene = builtin("street:4");
    let packed = PackedScene::new(&scene).expect("packed");
    for (id, is_moving) in
        [("lt-evsm", false), ("lt-evsm", true), ("ltt-msm", false), ("lt-vsm:cascades=1", true)]
    {
        let technique: Technique = id.parse().expect("an id");
        let setup = two_lights(&scene);
        let Some(mut session) = gpu_session(&scene, setup.clone()) else { return };
        let Some(mut engine) = Engine::new(&packed) else { return };
        let mut planner = FramePlanner::new(&packed, setup.clone()).expect("a setup");
        let sequence = Sequence { is_played: true, camera_moves: true, ..Sequence::default() };
        session.play(sequence);
        planner.play(Sequence { objects_move: is_moving, ..sequence });
        let (mut camera, step) = (setup.camera.clone(), scene.bounds().max.x * 0.002);
        let (mut draws, mut lit) = (0, 0);
        for number in 0..4 {
            // The last frame is the one before, once more.
            if number > 0 {
                camera.eye.x += if number < 3 { step } else { 0.0 };
                session.look(&camera).expect("a view");
                planner.look(&camera).expect("a view");
            }
            let truth = session.render(&technique).expect("frame");
            planner.see(places_of(session.samples(), SIZE.x as usize).collect());
            let jobs = planner.next_frame(&technique);
            assert_eq!(jobs.len(), 2);
            for (job, truth) in jobs.iter().zip(truth.each_light()) {
                let recorded = engine.draw(session.samples(), is_moving, job).expect("recorded");
                let different = count_different(&truth.visibility, &recorded, 0.0);
                assert_eq!(different, 0, "{id} moving {is_moving} frame {number}");
                draws += job.map_draws();
                lit += recorded.iter().filter(|v| **v == 1.0).count();
            }
        }
        let levels: u32 = if id.contains("cascades=1") { 1 } else { 3 };
        assert_eq!(draws, levels + 6, "{id}: maps are drawn once");
        assert!(lit > 10_000, "{id}: {lit} lit");
    }
}

/// What a plan needs and an engine has not given is an error, not a picture of something else.
#[test]
fn a_frame_that_lacks_where_things_were_says_so() {
    let scene = builtin("cornell");
    let packed = PackedScene::new(&scene).expect("packed");
    let Some(mut engine) = Engine::new(&packed) else { return };
    let setup = Setup { map_size: 64, ..Setup::for_scene(&scene, SIZE.x, SIZE.y) };
    let Some(session) = gpu_session(&scene, setup.clone()) else { return };
    let mut planner = FramePlanner::new(&packed, setup.clone()).expect("a setup");
    planner.play(Sequence { is_played: true, objects_move: true, ..Sequence::default() });
    let technique: Technique = "lt-evsm".parse().expect("an id");
    // The first frame has no past to miss.
    let first = planner.next_frame(&technique).remove(0);
    engine.draw(session.samples(), false, &first).expect("recorded");
    planner.repose(&packed);
    planner.look(&setup.camera).expect("a view");
    let second = planner.next_frame(&technique).remove(0);
    let error = engine.draw(session.samples(), false, &second).expect_err("no last positions");
    assert!(error.to_string().contains("last_positions"), "{error}");
    engine.draw(session.samples(), true, &second).expect("recorded");
    // A cleared history is none to be followed.
    planner.play(Sequence { is_played: true, objects_move: true, starts_cold: true, ..Sequence::default() });
    let cold = planner.next_frame(&technique).remove(0);
    engine.draw(session.samples(), false, &cold).expect("recorded");
}
