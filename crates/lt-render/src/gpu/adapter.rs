//! Finding a GPU, and saying what it can do.

use wgpu::{Adapter, DeviceType, Features};

use crate::RenderError;

/// Features used when present: timestamps around every pass.
pub const OPTIONAL_FEATURES: Features =
    Features::TIMESTAMP_QUERY.union(Features::TIMESTAMP_QUERY_INSIDE_ENCODERS);

/// Storage buffers that the largest kernel variant binds (instances or a tree in light space, alpha
/// test, a doubt list and a mask).
pub const STORAGE_BUFFERS: u32 = 10;

/// What `lt doctor` prints of an adapter.
#[derive(Clone, Debug)]
pub struct AdapterReport {
    /// Name.
    pub name: String,
    /// Driver and its version.
    pub driver: String,
    /// Vulkan, Metal or Dx12.
    pub backend: String,
    /// Discrete, integrated, virtual or software.
    pub kind: String,
    /// Features this program uses, and whether they are there.
    pub features: Vec<(String, bool)>,
    /// Limits this program may meet.
    pub limits: Vec<(String, u64)>,
}

/// What adapters are looked for in.
const BACKENDS: wgpu::Backends = wgpu::Backends::PRIMARY;

/// Of the backends that are looked at alone, unless the environment (`WGPU_BACKEND`) names others: nothing starts GL, whose adapters are
/// not listed.
fn instance() -> wgpu::Instance {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = BACKENDS;
    wgpu::Instance::new(descriptor.with_env())
}

fn adapters_of(instance: &wgpu::Instance) -> Vec<Adapter> {
    pollster::block_on(instance.enumerate_adapters(BACKENDS))
}

/// All adapters.
pub fn adapters() -> Vec<AdapterReport> {
    adapters_of(&instance()).iter().map(report).collect()
}

/// Whether there is an adapter that is not a software driver.
pub fn has_hardware_adapter() -> bool {
    adapters_of(&instance()).iter().any(|a| rank(a) < 3)
}

/// The best adapter's device: discrete before integrated before virtual before software.
///
/// # Errors
/// [`RenderError::NoAdapter`] when there is none that suffices, saying what each lacks.
pub fn open() -> Result<(Adapter, wgpu::Device, wgpu::Queue), RenderError> {
    let mut adapters = adapters_of(&instance());
    adapters.sort_by_key(rank);
    let mut reasons = Vec::new();
    for adapter in adapters {
        let limits = adapter.limits();
        let name = adapter.get_info().name;
        if limits.max_storage_buffers_per_shader_stage < STORAGE_BUFFERS {
            reasons.push(format!(
                "{name} binds {} storage buffers a stage, {STORAGE_BUFFERS} are needed",
                limits.max_storage_buffers_per_shader_stage
            ));
            continue;
        }
        let request = wgpu::DeviceDescriptor {
            label: Some("lt"),
            required_features: adapter.features() & OPTIONAL_FEATURES,
            required_limits: limits,
            ..wgpu::DeviceDescriptor::default()
        };
        match pollster::block_on(adapter.request_device(&request)) {
            Ok((device, queue)) => return Ok((adapter, device, queue)),
            Err(e) => reasons.push(format!("{name}: {e}")),
        }
    }
    let reason = if reasons.is_empty() { "none found".to_owned() } else { reasons.join("; ") };
    Err(RenderError::NoAdapter(reason))
}

fn rank(adapter: &Adapter) -> u32 {
    match adapter.get_info().device_type {
        DeviceType::DiscreteGpu => 0,
        DeviceType::IntegratedGpu => 1,
        DeviceType::VirtualGpu => 2,
        DeviceType::Other | DeviceType::Cpu => 3,
    }
}

fn report(adapter: &Adapter) -> AdapterReport {
    let (info, limits, features) = (adapter.get_info(), adapter.limits(), adapter.features());
    let has = |f: Features, name: &str| (name.to_owned(), features.contains(f));
    AdapterReport {
        name: info.name,
        driver: format!("{} {}", info.driver, info.driver_info).trim().to_owned(),
        backend: info.backend.to_string(),
        kind: match info.device_type {
            DeviceType::Cpu => "software".to_owned(),
            other => format!("{other:?}"),
        },
        features: vec![
            has(Features::TIMESTAMP_QUERY, "timestamps"),
            has(Features::TIMESTAMP_QUERY_INSIDE_ENCODERS, "timestamps between passes"),
        ],
        limits: vec![
            ("storage buffers per stage".to_owned(), limits.max_storage_buffers_per_shader_stage.into()),
            ("storage buffer bytes".to_owned(), limits.max_storage_buffer_binding_size),
            ("buffer bytes".to_owned(), limits.max_buffer_size),
            ("texture side".to_owned(), limits.max_texture_dimension_2d.into()),
        ],
    }
}
