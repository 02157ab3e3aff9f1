//! `lt doctor`: what this machine offers and what this build contains.

use std::io::Write;

/// Runs the command. A machine without a GPU is healthy: the CPU backend needs none.
///
/// # Errors
/// Only if stdout cannot be written.
pub fn run() -> anyhow::Result<()> {
    let mut out = std::io::stdout().lock();
    writeln!(out, "lt {}", env!("CARGO_PKG_VERSION"))?;
    writeln!(out, "system: {} {}", std::env::consts::OS, std::env::consts::ARCH)?;
    writeln!(out, "CPU threads: {}", rayon::current_num_threads())?;
    writeln!(out, "CPU features: {}", list_or(&cpu_features(), "none that matter"))?;
    gpu(&mut out)
}

fn list_or(words: &[&str], otherwise: &str) -> String {
    if words.is_empty() { otherwise.to_owned() } else { words.join(", ") }
}

#[cfg(any(target_arch = "x86_64", target_arch = "x86"))]
fn cpu_features() -> Vec<&'static str> {
    use std::arch::is_x86_feature_detected as has;
    let known = [
        ("sse4.1", has!("sse4.1")),
        ("avx", has!("avx")),
        ("avx2", has!("avx2")),
        ("fma", has!("fma")),
        ("avx512f", has!("avx512f")),
    ];
    known.into_iter().filter(|f| f.1).map(|f| f.0).collect()
}

#[cfg(target_arch = "aarch64")]
fn cpu_features() -> Vec<&'static str> {
    let known = [
        ("neon", std::arch::is_aarch64_feature_detected!("neon")),
        ("sve", std::arch::is_aarch64_feature_detected!("sve")),
    ];
    known.into_iter().filter(|f| f.1).map(|f| f.0).collect()
}

#[cfg(not(any(target_arch = "x86_64", target_arch = "x86", target_arch = "aarch64")))]
fn cpu_features() -> Vec<&'static str> {
    Vec::new()
}

#[cfg(not(feature = "gpu"))]
fn gpu(out: &mut impl Write) -> anyhow::Result<()> {
    writeln!(out, "GPU backend: not built in (build with `--features gpu`)")?;
    Ok(())
}

#[cfg(feature = "gpu")]
fn gpu(out: &mut impl Write) -> anyhow::Result<()> {
    let adapters = lt_render::gpu::adapters();
    match adapters.len() {
        0 => writeln!(
            out,
            "\nGPU adapters: none; the CPU backend serves\n  for one: a Vulkan driver (Debian: apt-get install mesa-vulkan-drivers)"
        )?,
        n => writeln!(out, "\nGPU adapters: {n}")?,
    }
    for adapter in adapters {
        writeln!(out, "  {} · {} · {} · {}", adapter.name, adapter.kind, adapter.backend, adapter.driver)?;
        for (name, is_there) in &adapter.features {
            writeln!(out, "    {name}: {}", if *is_there { "yes" } else { "no" })?;
        }
        for (name, value) in &adapter.limits {
            writeln!(out, "    {name}: {}", crate::numbers::grouped(*value))?;
        }
    }
    let modules = lt_render::gpu::MODULES;
    writeln!(out, "\nshader modules: {}", modules.len())?;
    for module in modules {
        let bytes = crate::numbers::grouped(module.spirv.len() as u64);
        writeln!(out, "  {} · {} · {bytes} bytes", module.name, module.entry_point)?;
    }
    Ok(())
}
