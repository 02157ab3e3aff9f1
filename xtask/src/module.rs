//! Judges one SPIR-V module as wgpu would, with naga's default capabilities, and translates it to WGSL.

use anyhow::{Context, Result, ensure};
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{Module, ShaderStage};

/// What a valid module says about itself.
#[derive(Debug)]
pub struct Inspected {
    /// The entry point's name in the SPIR-V module.
    pub entry_point: String,
    /// `compute`, `vertex` or `fragment`.
    pub stage: &'static str,
    /// Invocations per workgroup along x, y and z; zeros unless the stage is `compute`.
    pub workgroup_size: [u32; 3],
    /// The same module in WGSL, itself parsed and validated.
    pub wgsl: String,
    /// The entry point's name in the WGSL module, where `::` cannot stand.
    pub wgsl_entry_point: String,
}

/// Parses, validates and translates a SPIR-V module that has exactly one entry point.
///
/// # Errors
/// naga refuses the module or the WGSL it wrote itself, or the number of entry points is not 1.
pub fn inspect(spirv: &[u8]) -> Result<Inspected> {
    // wgpu's own options for `ShaderSource::SpirV`; the flip of y belongs to its backends.
    let options = naga::front::spv::Options {
        adjust_coordinate_space: false,
        strict_capabilities: true,
        block_ctx_dump_prefix: None,
    };
    let module =
        naga::front::spv::parse_u8_slice(spirv, &options).context("naga cannot read the SPIR-V module")?;
    let info = validate(&module).context("naga refuses the SPIR-V module")?;
    ensure!(module.entry_points.len() == 1, "{} entry points instead of 1", module.entry_points.len());
    let entry = &module.entry_points[0];

    let wgsl = naga::back::wgsl::write_string(&module, &info, naga::back::wgsl::WriterFlags::empty())
        .context("naga cannot write the module as WGSL")?;
    let again = naga::front::wgsl::parse_str(&wgsl)
        .map_err(|error| anyhow::anyhow!("naga cannot read its own WGSL: {}", error.emit_to_string(&wgsl)))?;
    validate(&again).context("naga refuses its own WGSL")?;
    ensure!(again.entry_points.len() == 1, "WGSL has {} entry points instead of 1", again.entry_points.len());

    Ok(Inspected {
        entry_point: entry.name.clone(),
        stage: stage_name(entry.stage)?,
        workgroup_size: entry.workgroup_size,
        wgsl_entry_point: again.entry_points[0].name.clone(),
        wgsl,
    })
}

/// Validates everything naga can, allowing only what every wgpu device offers without optional features.
fn validate(module: &Module) -> Result<ModuleInfo> {
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::default());
    validator.validate(module).map_err(|error| {
        // The outer error names the function, its sources the expression.
        anyhow::anyhow!(error.into_inner())
    })
}

fn stage_name(stage: ShaderStage) -> Result<&'static str> {
    match stage {
        ShaderStage::Compute => Ok("compute"),
        ShaderStage::Vertex => Ok("vertex"),
        ShaderStage::Fragment => Ok("fragment"),
        other => anyhow::bail!("no pass of this project has the stage {other:?}"),
    }
}

#[cfg(test)]
pub mod tests {
    use super::*;

    /// The least compute shader: an empty `main` with 8 x 4 x 1 invocations.
    pub fn minimal() -> Vec<u8> {
        let main = u32::from_le_bytes(*b"main");
        let words: &[&[u32]] = &[
            &[0x0723_0203, 0x0001_0300, 0, 5, 0],
            &[0x0002_0011, 1],              // OpCapability Shader
            &[0x0003_000e, 0, 1],           // OpMemoryModel Logical GLSL450
            &[0x0005_000f, 5, 3, main, 0],  // OpEntryPoint GLCompute %3 "main"
            &[0x0006_0010, 3, 17, 8, 4, 1], // OpExecutionMode %3 LocalSize 8 4 1
            &[0x0002_0013, 1],              // %1 = OpTypeVoid
            &[0x0003_0021, 2, 1],           // %2 = OpTypeFunction %1
            &[0x0005_0036, 1, 3, 0, 2],     // %3 = OpFunction %1 None %2
            &[0x0002_00f8, 4],              // %4 = OpLabel
            &[0x0001_00fd],                 // OpReturn
            &[0x0001_0038],                 // OpFunctionEnd
        ];
        words.concat().iter().flat_map(|word| word.to_le_bytes()).collect()
    }

    #[test]
    fn a_valid_module_is_described_and_translated() {
        let inspected = inspect(&minimal()).unwrap();
        assert_eq!(inspected.entry_point, "main");
        assert_eq!(inspected.stage, "compute");
        assert_eq!(inspected.workgroup_size, [8, 4, 1]);
        assert!(inspected.wgsl.contains("@workgroup_size(8, 4, 1)"));
        assert!(inspected.wgsl.contains(&format!("fn {}(", inspected.wgsl_entry_point)));
    }

    #[test]
    fn invalid_modules_are_refused() {
        assert!(inspect(&[]).is_err());
        assert!(inspect(&minimal()[..60]).is_err(), "cut off");
        let mut empty_workgroup = minimal();
        // The first size operand of OpExecutionMode: word 5 + 2 + 3 + 5 + 3.
        empty_workgroup[18 * 4] = 0;
        assert!(inspect(&empty_workgroup).is_err(), "a workgroup of no invocations");
    }
}
