//! The command as a user meets it: exit codes, messages, files.
#![allow(clippy::unwrap_used, reason = "helpers of tests are tests too")]

use std::{
    path::Path,
    process::{Command, Output},
};

fn lt(words: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_lt")).args(words).output().unwrap()
}

fn code_and_stderr(output: &Output) -> (i32, String) {
    (output.status.code().unwrap(), String::from_utf8_lossy(&output.stderr).into_owned())
}

fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// A Cornell box that takes no time.
const SMALL: [&str; 7] = ["cornell", "--size", "64x48", "--backend", "cpu", "--map-size", "64"];

#[test]
fn bad_usage_exits_with_2_and_names_option_and_value() {
    for (words, expected) in [
        (&["compare", "--size", "12"][..], "--size"),
        (&["compare", "--techniques", "foo"], "foo"),
        (&["compare", "--fov", "nan"], "--fov"),
        (&["compare", "--repeats", "0"], "--repeats"),
        (&["compare", "atlantis"], "atlantis"),
        (&["compare", "cornell", "--size", "8x8", "--map-size", "100"], "--map-size"),
        (&["render", "cornell", "--camera", "99"], "--camera 99"),
        (&["render", "cornell", "--out", "a.jpg"], "--out"),
        (&["dance"], "dance"),
    ] {
        let dir = tempfile::tempdir().unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_lt"));
        let output = command.args(words).current_dir(dir.path()).output().unwrap();
        let (code, stderr) = code_and_stderr(&output);
        assert_eq!(code, 2, "{words:?}: {stderr}");
        assert!(stderr.contains(expected), "{words:?}: {stderr}");
    }
}

#[test]
fn a_missing_file_exits_with_1_and_is_named() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let (code, stderr) = code_and_stderr(&lt(&["compare", "nowhere.glb", "--out", out.to_str().unwrap()]));
    assert_eq!(code, 1, "{stderr}");
    assert!(stderr.contains("nowhere.glb"), "{stderr}");
}

#[test]
fn a_folder_that_cannot_be_made_exits_with_1_before_any_work() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("taken"), b"x").unwrap();
    let out = dir.path().join("taken/out");
    let (code, stderr) = code_and_stderr(&lt(&["compare", "cornell", "--out", out.to_str().unwrap()]));
    assert_eq!(code, 1, "{stderr}");
    assert!(stderr.contains("taken"), "{stderr}");
}

#[test]
fn lists_are_printed() {
    for (words, expected) in [
        (&["scenes"][..], &["street", "hairball", "random"][..]),
        (
            &["compare", "--list"],
            &[
                "ray",
                "msm-hausdorff",
                "ltt-evsm",
                "prefiltered",
                "\nalias-free",
                "\nray:light",
                "\nray:dac",
                "\nray:space",
            ],
        ),
        (&["doctor"], &["CPU threads"]),
        (&["plan", "cornell", "--size", "16x16", "--backend", "cpu"], &["alpha test", "rays"]),
    ] {
        let output = lt(words);
        let text = stdout(&output);
        assert!(output.status.success(), "{words:?}: {:?}", code_and_stderr(&output));
        assert!(expected.iter().all(|word| text.contains(word)), "{words:?}: {text}");
    }
}

#[test]
fn a_plan_for_several_frames_has_what_they_call_for() {
    let plan = |extra: &[&str]| {
        let words = [&["plan"], &SMALL[..], &["--technique", "lt-evsm"], extra].concat();
        let output = lt(&words);
        assert!(output.status.success(), "{extra:?}: {:?}", code_and_stderr(&output));
        stdout(&output)
    };
    let is_on = |text: &str, effect: &str| {
        let row = text.lines().find(|line| line.starts_with(effect)).unwrap();
        row[effect.len()..].trim_start().starts_with("on ")
    };
    for (extra, reuse, motion) in [
        (&[][..], false, false),
        (&["--frames", "8"], true, true),
        (&["--frames", "8", "--still"], true, false),
    ] {
        let text = plan(extra);
        assert_eq!(is_on(&text, "static map reuse"), reuse, "{text}");
        assert_eq!(is_on(&text, "motion vectors"), motion, "{text}");
        assert!(!is_on(&text, "several lights"), "{text}");
    }
    assert!(plan(&["--frames", "8", "--light-spin", "1"]).contains("what moves: the camera, lights"));
}

#[test]
fn looking_for_a_gpu_where_there_is_no_desktop_prints_no_error() {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lt"));
    let output = command.arg("doctor").env_remove("XDG_RUNTIME_DIR").env_remove("WGPU_BACKEND").output();
    let (code, stderr) = code_and_stderr(&output.unwrap());
    assert_eq!((code, stderr.as_str()), (0, ""));
}

#[test]
fn compare_writes_table_results_images_and_report() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("a/b");
    let words =
        [&["compare"], &SMALL[..], &["--techniques", "ray,sm,ltt-evsm:eps=0.02", "--repeats", "1", "--out"]]
            .concat();
    let output = lt(&[&words[..], &[out.to_str().unwrap()]].concat());
    assert!(output.status.success(), "{:?}", code_and_stderr(&output));
    assert!(output.stderr.is_empty(), "quiet when not a terminal: {:?}", code_and_stderr(&output));
    assert!(stdout(&output).contains("ltt-evsm:eps=0.02"));

    let json: serde_json::Value =
        serde_json::from_slice(&std::fs::read(out.join("results.json")).unwrap()).unwrap();
    assert_eq!((&json["schema"], &json["backend"]), (&1.into(), &"cpu".into()));
    assert_eq!(json["size"], serde_json::json!([64, 48]));
    let rows = json["rows"].as_array().unwrap();
    assert_eq!(
        rows.iter().map(|r| r["technique"].as_str().unwrap()).collect::<Vec<_>>(),
        ["ray", "sm", "ltt-evsm:eps=0.02"]
    );
    assert_eq!(
        (rows[0]["false_lit_ppm"].as_f64(), rows[0]["false_shadowed_ppm"].as_f64()),
        (Some(0.0), Some(0.0))
    );
    assert_eq!(rows[0]["flips_per_frame"], 0, "the CPU backend is deterministic");
    assert!(rows[2]["rays_per_pixel"].as_f64() < rows[0]["rays_per_pixel"].as_f64());

    for name in ["ray", "sm", "ltt-evsm_eps_0.02"] {
        for ending in ["png", "errors.png", "rays.png", "exr"] {
            assert!(out.join(format!("{name}.{ending}")).is_file(), "{name}.{ending}");
        }
    }
    assert!(out.join("reference.png").is_file());
    let report = std::fs::read_to_string(out.join("report.html")).unwrap();
    assert!(report.contains("t-ltt-evsm_eps_0.02") && report.len() < 20_000_000);
    assert_eq!(leftovers(&out), 0);
}

#[test]
fn render_dumps_the_buffers_under_their_names() {
    let dir = tempfile::tempdir().unwrap();
    let (picture, dump) = (dir.path().join("shadow.png"), dir.path().join("dump"));
    let words =
        [&["render"], &SMALL[..], &["--technique", "ltt-msm", "--out", picture.to_str().unwrap()]].concat();
    let output = lt(&[&words[..], &["--dump", dump.to_str().unwrap()]].concat());
    assert!(output.status.success(), "{:?}", code_and_stderr(&output));
    assert_eq!(image::image_dimensions(&picture).unwrap(), (64, 48));

    use exr::prelude::*;
    let file =
        read().no_deep_data().largest_resolution_level().all_channels().first_valid_layer().all_attributes();
    let channels = file.from_file(dump.join("frame.exr")).unwrap().layer_data.channel_data.list;
    let mut names: Vec<String> = channels.iter().map(|c| c.name.to_string()).collect();
    names.sort();
    let axes = |what: &str| ["X", "Y", "Z"].map(|axis| format!("{what}.{axis}"));
    let mut expected = [&axes("position")[..], &axes("normal")].concat();
    expected.extend(["visibility.Y", "reference.Y", "doubt.Y"].map(String::from));
    expected.sort();
    assert_eq!(names, expected);
    assert!(channels.iter().all(|c| matches!(c.sample_data, FlatSamples::F32(_))));

    let camera: serde_json::Value =
        serde_json::from_slice(&std::fs::read(dump.join("camera.json")).unwrap()).unwrap();
    for key in ["eye", "target", "light_dir"] {
        assert_eq!(camera[key].as_array().unwrap().len(), 3, "{key}");
    }
    assert!(camera["fov_deg"].as_f64().unwrap() > 0.0);
}

#[test]
fn options_reach_the_picture() {
    let dir = tempfile::tempdir().unwrap();
    let path = |name: &str| dir.path().join(name);
    let draw = |name: &str, extra: &[&str]| {
        let words = [&["render"], &SMALL[..], &["--technique", "ray", "--out"]].concat();
        let output = lt(&[&words[..], &[path(name).to_str().unwrap()], extra].concat());
        assert!(output.status.success(), "{:?}", code_and_stderr(&output));
        std::fs::read(path(name)).unwrap()
    };
    let plain = draw("plain.png", &[]);
    assert_eq!(plain, draw("again.png", &["--threads", "1"]), "threads change no pixel");
    assert_ne!(plain, draw("moved.png", &["--fov", "20"]));
    assert_ne!(plain, draw("lit.png", &["--light-dir", "-0.2,-1,-0.1"]));
}

/// What there is to see of it is one node without a mesh.
const EMPTY: &str = r#"{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"name": "nothing"}]}"#;

#[test]
fn a_picture_of_nothing_is_warned_of_with_a_remedy() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("empty.gltf");
    std::fs::write(&file, EMPTY).unwrap();
    let out = dir.path().join("out");
    let run = |scene: &str, extra: &[&str]| {
        let words = [
            &["compare", scene, "--techniques", "ray,sm", "--no-flip", "--brief", "--repeats", "1"],
            &SMALL[1..],
            extra,
            &["--out", out.to_str().unwrap()],
        ];
        code_and_stderr(&lt(&words.concat()))
    };
    let (code, stderr) = run(file.to_str().unwrap(), &[]);
    assert!(code == 0 && stderr.contains("warning") && stderr.contains("no triangles"), "{code} {stderr}");
    assert!(stderr.contains("--ground"), "{stderr}");
    let (code, stderr) = run("cornell", &["--eye", "0,90,0", "--target", "0,99,-9"]);
    assert!(code == 0 && stderr.contains("sees none of it") && stderr.contains("--eye"), "{code} {stderr}");
    assert_eq!(run("cornell", &[]), (0, String::new()));
}

fn leftovers(dir: &Path) -> usize {
    let is_temporary = |e: &std::fs::DirEntry| e.file_name().to_string_lossy().ends_with(".tmp");
    std::fs::read_dir(dir).unwrap().filter_map(Result::ok).filter(is_temporary).count()
}

/// A floor, something above it, and a lamp that is elsewhere for less than two hundredths of a second.
const FLASH: &str = r#"{
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
    "extensionsUsed": ["KHR_lights_punctual"],
    "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point"}]}},
    "nodes": [{"mesh": 0}, {"translation": [0, 4, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "animations": [{"channels": [{"sampler": 0, "target": {"node": 1, "path": "translation"}}],
        "samplers": [{"input": 1, "output": 2, "interpolation": "STEP"}]}],
    "buffers": [{"uri": "flash.bin", "byteLength": 136}],
    "bufferViews": [{"buffer": 0, "byteLength": 72}, {"buffer": 0, "byteOffset": 72, "byteLength": 16},
        {"buffer": 0, "byteOffset": 88, "byteLength": 48}],
    "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 6, "type": "VEC3", "min": [-9, 0, -9], "max": [9, 1, 9]},
        {"bufferView": 1, "componentType": 5126, "count": 4, "type": "SCALAR", "min": [0], "max": [9]},
        {"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC3"}]
}"#;

#[test]
fn a_lamp_that_flashes_between_frames_is_seen_to_move() {
    let dir = tempfile::tempdir().unwrap();
    let corners = [-9, 0, -9, 0, 0, 9, 9, 0, -9, -1, 1, -1, 0, 1, 1, 1, 1, -1].map(|x| x as f32);
    let (times, places) =
        ([0.0, 0.03, 0.045, 9.0], [0.0, 4.0, 0.0, 3.0, 4.0, 0.0, 0.0, 4.0, 0.0, 0.0, 4.0, 0.0]);
    let bytes: Vec<u8> =
        corners.iter().chain(&times).chain(&places).flat_map(|x: &f32| x.to_le_bytes()).collect();
    std::fs::write(dir.path().join("flash.bin"), bytes).unwrap();
    let file = dir.path().join("flash.gltf");
    std::fs::write(&file, FLASH).unwrap();
    let out = dir.path().join("out");
    let output = lt(&[
        &["compare", file.to_str().unwrap(), "--frames", "6", "--techniques", "ray,ltt-vsm"][..],
        &["--size", "64x48", "--backend", "cpu", "--map-size", "64", "--no-flip"],
        &["--out", out.to_str().unwrap()],
    ]
    .concat());
    let text = stdout(&output);
    assert!(text.contains("lights move"), "{text}{}", code_and_stderr(&output).1);
    let json: serde_json::Value =
        serde_json::from_slice(&std::fs::read(out.join("results.json")).unwrap()).unwrap();
    let frames = json["rows"][1]["path"]["frames"].as_array().unwrap();
    let draws: Vec<u64> = frames.iter().map(|f| f["map_draws"].as_u64().unwrap()).collect();
    assert!(draws[2] > 0 && draws[3] > 0 && draws[4] == 0, "away for one frame, and back: {draws:?}");
}
