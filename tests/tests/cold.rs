//! From a cleared history: what is never found again, what a rolling refresh finds in time, and CPU like GPU.

use lt_render::{BackendKind, Frame, Sequence, Session, Setup, Technique};
use lt_tests::{builtin, gpu_session, ppm, twin_ppm};

const COLD: Sequence = Sequence {
    is_played: true,
    camera_moves: false,
    objects_move: false,
    lights_move: false,
    starts_cold: true,
};

fn technique(id: &str) -> Technique {
    id.parse().expect("a known id")
}

/// Pixels that two frames put on different sides.
fn other_side(a: &Frame, b: &Frame) -> usize {
    a.visibility.iter().zip(&b.visibility).filter(|(a, b)| (**a >= 0.5) != (**b >= 0.5)).count()
}

#[test]
fn a_refresh_heals_a_cleared_history_in_one_period() {
    let mut left_without = 0;
    for place in ["street:6", "square:8", "forest:20", "fence:12"] {
        let scene = builtin(place);
        let setup = Setup { map_size: 256, ..Setup::for_scene(&scene, 240, 136) };
        let mut session = Session::new(&scene, setup, BackendKind::Cpu).expect("session");
        session.play(COLD);
        let truth = session.render(&Technique::RAY).expect("frame");
        for id in ["lt-evsm", "lt-msm"] {
            for (period, is_settled) in [(8, true), (16, true), (100, false)] {
                let with = technique(&format!("{id}:refresh={period}"));
                let frames: Vec<Frame> = (0..18).map(|_| session.render(&with).expect("frame")).collect();
                for (i, frame) in frames.iter().enumerate() {
                    let wrong = other_side(&truth, frame);
                    assert!(wrong == 0 || !is_settled || i + 1 < period, "{place} {with} frame {i}: {wrong}");
                    assert!(frame.rays < truth.rays, "{place} {with} frame {i} traces everything");
                }
                assert!(other_side(&truth, &frames[0]) > 0, "{place} {with}: nothing to heal");
            }
            let without: Vec<Frame> =
                (0..18).map(|_| session.render(&technique(id)).expect("frame")).collect();
            left_without += other_side(&truth, &without[17]);
        }
    }
    assert!(left_without > 0, "without a refresh something stays wrong, else this shows nothing");
}

#[test]
fn cold_starts_and_refreshes_are_the_same_on_cpu_and_gpu() {
    for place in ["street:4", "forest:12"] {
        let scene = builtin(place);
        let setup = Setup { map_size: 256, ..Setup::for_scene(&scene, 320, 200) };
        let Some(mut gpu) = gpu_session(&scene, setup.clone()) else { return };
        let mut cpu = Session::new(&scene, setup, BackendKind::Cpu).expect("session");
        for id in ["lt-evsm", "lt-msm", "lt-evsm:refresh=5"] {
            // Twice: what the first run left in the buffers must not be what the second one starts from.
            for _ in 0..2 {
                cpu.play(COLD);
                gpu.play(COLD);
                for i in 0..4 {
                    let [a, b] = [&mut cpu, &mut gpu].map(|s| s.render(&technique(id)).expect("frame"));
                    let masks = a.mask.iter().zip(&b.mask).filter(|(a, b)| a != b).count();
                    let pixels = a.mask.len();
                    // ER hands a difference on to its neighbours: a few times the bound of one frame.
                    assert!(ppm(masks, pixels) <= 4.0 * twin_ppm(), "{place} {id} frame {i}: {masks}");
                    assert!(ppm(other_side(&a, &b), pixels) <= twin_ppm(), "{place} {id} frame {i}");
                }
            }
        }
    }
}
