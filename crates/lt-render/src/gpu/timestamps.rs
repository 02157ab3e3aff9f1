//! Times of passes from timestamps between them.

use wgpu::Features;

/// Passes that one frame may time.
const MOST_PASSES: u32 = 16;

/// A set of timestamps, two for every pass.
pub(super) struct Timestamps {
    set: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    period_ns: f64,
    used: u32,
}

impl Timestamps {
    /// `None` where the device cannot write timestamps between passes.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue) -> Option<Self> {
        if !device.features().contains(Features::TIMESTAMP_QUERY | Features::TIMESTAMP_QUERY_INSIDE_ENCODERS)
        {
            return None;
        }
        let count = MOST_PASSES * 2;
        Some(Self {
            set: device.create_query_set(&wgpu::QuerySetDescriptor {
                label: Some("timestamps"),
                ty: wgpu::QueryType::Timestamp,
                count,
            }),
            resolved: device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("timestamps"),
                size: u64::from(count) * 8,
                usage: wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            }),
            period_ns: f64::from(queue.get_timestamp_period()),
            used: 0,
        })
    }

    pub fn restart(&mut self) {
        self.used = 0;
    }

    /// Marks the start or the end of a pass.
    pub fn mark(&mut self, encoder: &mut wgpu::CommandEncoder) {
        if self.used < MOST_PASSES * 2 {
            encoder.write_timestamp(&self.set, self.used);
            self.used += 1;
        }
    }

    pub fn resolve(&self, encoder: &mut wgpu::CommandEncoder) {
        if self.used > 0 {
            encoder.resolve_query_set(&self.set, 0..self.used, &self.resolved, 0);
        }
    }

    /// The buffer to read back and its used bytes.
    pub fn buffer(&self) -> (&wgpu::Buffer, u64) {
        (&self.resolved, u64::from(self.used) * 8)
    }

    /// Time of each pass from the ticks read back.
    pub fn milliseconds(&self, ticks: &[u64]) -> Vec<f64> {
        ticks.chunks_exact(2).map(|t| t[1].saturating_sub(t[0]) as f64 * self.period_ns * 1e-6).collect()
    }
}
