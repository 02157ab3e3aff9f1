//! Buffers as one-layer OpenEXR files of 32-bit float channels.

use std::io::{Seek, Write};

use anyhow::Context;
use exr::prelude::{AnyChannel, AnyChannels, Encoding, FlatSamples, Image, WritableImage};

/// Writes channels of `size` values each, row by row from the top, under exactly these names.
///
/// # Errors
/// What the writer reports.
pub fn write(to: impl Write + Seek, size: [u32; 2], channels: Vec<(&str, Vec<f32>)>) -> anyhow::Result<()> {
    let channels = channels.into_iter().map(|(name, values)| AnyChannel::new(name, FlatSamples::F32(values)));
    let channels = AnyChannels::sort(channels.collect());
    let size = (size[0] as usize, size[1] as usize);
    let image = Image::from_encoded_channels(size, Encoding::SMALL_FAST_LOSSLESS, channels);
    image.write().to_buffered(to).context("EXR encoding")
}

/// A yes-no buffer as 1 and 0.
pub fn as_floats(flags: &[bool]) -> Vec<f32> {
    flags.iter().map(|&f| f32::from(u8::from(f))).collect()
}

#[cfg(test)]
mod tests {
    use exr::prelude::*;

    #[test]
    fn channels_keep_their_names_and_bits() {
        let depth = vec![1.5, -0.0, f32::MIN_POSITIVE, 3.0, f32::INFINITY, 1e-40];
        let doubt = super::as_floats(&[true, false, false, true, true, false]);
        let mut bytes = std::io::Cursor::new(Vec::new());
        super::write(&mut bytes, [3, 2], vec![("position.X", depth.clone()), ("doubt.Y", doubt.clone())])
            .unwrap();
        bytes.set_position(0);
        let image = read()
            .no_deep_data()
            .largest_resolution_level()
            .all_channels()
            .first_valid_layer()
            .all_attributes();
        let layer = image.from_buffered(bytes).unwrap().layer_data;
        assert_eq!(layer.size, Vec2(3, 2));
        let found: Vec<(String, Vec<u32>)> = layer
            .channel_data
            .list
            .iter()
            .map(|c| (c.name.to_string(), c.sample_data.values_as_f32().map(f32::to_bits).collect()))
            .collect();
        let bits = |values: Vec<f32>| values.into_iter().map(f32::to_bits).collect();
        assert_eq!(found, [("doubt.Y".into(), bits(doubt)), ("position.X".into(), bits(depth))]);
    }
}
