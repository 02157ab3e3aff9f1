//! Marks in maps that are kept: fewer wrong pixels for fewer rays, none where they cannot be trusted, the same on CPU and GPU.

use lt_math::glam::{Vec3, Vec4Swizzles};
use lt_render::metrics::{Verdict, verdict};
use lt_render::{BackendKind, Frame, PackedScene, Sequence, Session, Setup, Technique, way_per_frame};
use lt_scene::Source;
use lt_shaders::depth::{corner, placed_corner};
use lt_shaders::marks::is_stirred;
use lt_tests::gpu_session;

const MOVING: Sequence = Sequence {
    is_played: true,
    camera_moves: true,
    objects_move: false,
    lights_move: false,
    starts_cold: false,
};

fn technique(id: &str) -> Technique {
    id.parse().expect("a known id")
}

fn wrong(truth: &Frame, frame: &Frame) -> usize {
    let pixels = truth.visibility.iter().zip(&frame.visibility);
    pixels.filter(|(t, v)| verdict(**t, **v) != Verdict::Right).count()
}

/// A session that walks along a place's own path.
struct Walk {
    source: Source,
    session: Session,
    setup: Setup,
    /// Of the path, a frame.
    way: f32,
}

impl Walk {
    fn open(name: &str, open: impl Fn(&lt_scene::Scene, Setup) -> Option<Session>) -> Option<Self> {
        let source = Source::open(name, 1).expect("a place");
        let scene = source.pose(0.0).expect("a pose");
        let setup = Setup { map_size: 512, ..Setup::for_scene(&scene, 320, 180) };
        let mut session = open(&scene, setup.clone())?;
        let way = way_per_frame(&session, &source.camera_path(setup.camera.clone()), 1.0);
        session.play(MOVING);
        Some(Self { source, session, setup, way })
    }

    fn on_cpu(name: &str) -> Self {
        let open = |scene: &_, setup| Some(Session::new(scene, setup, BackendKind::Cpu).expect("a session"));
        Self::open(name, open).expect("a CPU")
    }

    fn step(&mut self, frame: usize) {
        if frame > 0 {
            let path = self.source.camera_path(self.setup.camera.clone());
            self.session.look(&path.at(self.way * frame as f32)).expect("a view");
        }
    }

    fn draw(&mut self, id: &str) -> Frame {
        self.session.render(&technique(id)).expect("a frame")
    }
}

/// With the same neighbours asked.
#[test]
fn a_map_that_remembers_errs_less_the_longer_it_is_kept() {
    const ASKS: &str = "lt-evsm:expand=leaks:moving=diamond";
    for name in ["street:6", "town:40", "random:3000", "square:8"] {
        let mut walk = Walk::on_cpu(name);
        // With marks, and without: wrong pixels of the walk's halves, and rays; not of the first frame.
        let (mut wrongs, mut rays) = ([[0; 2]; 2], [0; 2]);
        for i in 0..16 {
            walk.step(i);
            let truth = walk.draw("ray");
            for (which, id) in [ASKS.to_owned(), format!("{ASKS}:no-marks")].iter().enumerate() {
                let frame = walk.draw(id);
                if i > 0 {
                    wrongs[which][i / 8] += wrong(&truth, &frame);
                    rays[which] += frame.rays;
                }
            }
        }
        let [with, without] = wrongs;
        assert!(with[0] < without[0], "{name}: {with:?} wrong, {without:?} without marks");
        assert!(with[1] * 4 < without[1] * 3, "{name}: {with:?} wrong, {without:?} without marks");
        assert!(rays[0] * 2 < rays[1] * 3, "{name}: {rays:?} rays");
    }
}

/// A level that is drawn anew has no marks, and what is not kept never has.
#[test]
fn marks_go_with_the_map() {
    let mut walk = Walk::on_cpu("street:6");
    for i in 0..4 {
        walk.step(i);
        let [marked, plain] = ["lt-evsm:no-reuse", "lt-evsm:no-reuse:no-marks"].map(|id| walk.draw(id));
        assert_eq!((marked.rays, &marked.mask), (plain.rays, &plain.mask), "frame {i}");
    }
}

/// GPU and CPU mark the same texels: what is traced and what is found stays the same over a walk, up to a texel that rounding puts
/// elsewhere.
#[test]
fn both_backends_mark_alike() {
    for name in ["town:40", "square:8"] {
        let Some(mut gpu) = Walk::open(name, gpu_session) else { return };
        let mut cpu = Walk::on_cpu(name);
        for id in ["lt-evsm", "lt-evsm:cascades=1", "lt-vsm:prefiltered:cascades=2"] {
            let mut draws = 0;
            for i in 0..6 {
                cpu.step(i);
                gpu.step(i);
                if i == 0 || i == 3 {
                    // Maps are drawn anew, and marks that were left in them would be rays more.
                    let sun = cpu.setup.light.turned(Vec3::ZERO, 0.001 * (i / 3) as f32);
                    for walk in [&mut cpu, &mut gpu] {
                        walk.session.relight(std::slice::from_ref(&sun)).expect("a light");
                    }
                    draws = 0;
                }
                let (truth, on_cpu, on_gpu) = (cpu.draw("ray"), cpu.draw(id), gpu.draw(id));
                let pixels = on_cpu.mask.iter().zip(&on_gpu.mask);
                let differ = pixels.filter(|(a, b)| a != b).count();
                assert!(differ * 400 < on_cpu.mask.len(), "{name} {id} frame {i}: {differ}");
                let rays = on_cpu.rays.abs_diff(on_gpu.rays);
                assert!(rays * 50 <= on_cpu.rays, "{name} {id} frame {i}: {} {}", on_cpu.rays, on_gpu.rays);
                assert!(i == 0 || on_cpu.rays < truth.rays);
                draws += on_cpu.map_draws;
            }
            assert!(draws > 0, "{name} {id}: no map was drawn under the sun that moved");
        }
    }
}

/// What a creature's shadow does to a place is gone when it has passed: nothing is marked where it may be.
#[test]
fn the_part_of_a_map_where_things_move_holds_all_that_moves_and_not_the_whole_map() {
    let source = Source::open("forest:40", 1).expect("a place");
    let scene = source.pose(0.3).expect("a pose");
    let packed = PackedScene::new(&scene).expect("packs");
    let setup = Setup::for_scene(&scene, 320, 180);
    let mut session = Session::new(&scene, setup, BackendKind::Cpu).expect("a session");
    session.play(Sequence { objects_move: true, ..MOVING });
    let map = session.job(&technique("lt-evsm")).map.expect("maps");
    assert_eq!(map.moving.len(), map.levels.len());
    let mut seen = 0;
    for (level, moving) in map.levels.iter().zip(&map.moving) {
        for draw in packed.moving_draws() {
            let all = draw.first_triangle as usize..(draw.first_triangle + draw.triangles) as usize;
            for triangle in &packed.triangles()[all] {
                for i in 0..3 {
                    let world = match packed.instances().get(draw.instance as usize) {
                        Some(placed) => placed_corner(triangle, i, placed),
                        None => corner(triangle, i),
                    };
                    assert!(is_stirred(level.projection.project(world).uv, *moving, 2048), "{world}");
                    seen += 1;
                }
            }
        }
    }
    assert!(seen > 1000, "{seen} corners of things that move");
    let [.., coarsest] = &map.moving[..] else { panic!("levels") };
    let size = coarsest.zw() - coarsest.xy();
    assert!(size.x * size.y < 0.2, "{coarsest} of the coarsest map");
    session.play(MOVING);
    assert!(session.job(&technique("ltt-evsm")).map.expect("maps").moving.is_empty());
    assert!(session.job(&technique("lt-evsm:no-marks")).map.expect("maps").moving.is_empty());
}
