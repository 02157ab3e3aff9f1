//! Lists the committed shader modules of `shaders/manifest.json` so that the GPU backend can embed them.

use std::{env, fmt::Write as _, fs, path::Path};

fn main() {
    println!("cargo::rerun-if-changed=../../shaders/manifest.json");
    if env::var_os("CARGO_FEATURE_GPU").is_none() {
        return;
    }
    // Asked at run time: a target folder copied from another checkout would name that one's shaders.
    let crate_dir = env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets CARGO_MANIFEST_DIR");
    let folder = Path::new(&crate_dir).join("../../shaders");
    let manifest = fs::read_to_string(folder.join("manifest.json"))
        .expect("shaders/manifest.json is committed; if it is missing run `cargo xtask build-shaders`");
    let manifest: serde_json::Value = serde_json::from_str(&manifest).expect("the manifest is JSON");
    let mut table = String::from("&[\n");
    for entry in manifest["entries"].as_array().expect("the manifest lists entries") {
        let text = |key: &str| entry[key].as_str().expect("a manifest entry has its fields");
        let path = folder.join(text("file"));
        let (name, entry_point) = (text("name"), text("entry_point"));
        writeln!(
            table,
            "ShaderModule {{ name: {name:?}, entry_point: {entry_point:?}, spirv: include_bytes!({path:?}) }},"
        )
        .expect("writing to a string");
        println!("cargo::rerun-if-changed={}", path.display());
    }
    table.push(']');
    let out = env::var_os("OUT_DIR").expect("cargo sets OUT_DIR");
    fs::write(Path::new(&out).join("modules.rs"), table).expect("OUT_DIR is writable");
}
