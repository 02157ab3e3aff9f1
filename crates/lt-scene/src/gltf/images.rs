//! Decodes PNG and JPEG images, in parallel, to 8-bit RGBA.

use std::{io::Cursor, sync::Arc};

use image::{ImageDecoder, ImageReader, Limits};
use rayon::prelude::*;

use super::{buffers::Buffers, fault::Fault, files::Files, json::Root};
use crate::Texture;

/// Largest width and height.
const MAX_SIZE: u32 = 16384;
/// Most bytes that one image may decode to.
const MAX_BYTES: u64 = 512 << 20;
/// Most texels over all images of an asset: 2 GiB of RGBA.
const MAX_TEXELS: u64 = 1 << 29;

enum Encoded<'a> {
    View(&'a [u8]),
    Fetched(Arc<[u8]>),
}

impl Encoded<'_> {
    fn bytes(&self) -> &[u8] {
        match self {
            Self::View(bytes) => bytes,
            Self::Fetched(bytes) => bytes,
        }
    }
}

/// Decodes the images with these indices.
pub(super) fn decode(
    root: &Root,
    wanted: &[usize],
    buffers: &Buffers<'_>,
    files: &mut Files,
) -> Result<Vec<Texture>, Fault> {
    let mut texels = 0;
    let mut encoded = Vec::with_capacity(wanted.len());
    for &index in wanted {
        let image = locate(root, index, buffers, files)?;
        texels += texel_count(image.bytes(), &place(root, index))?;
        if texels > MAX_TEXELS {
            let problem =
                format!("the images up to here have {texels} texels, more than {MAX_TEXELS}: shrink them");
            return Err(Fault::at(place(root, index), problem));
        }
        encoded.push((index, image));
    }
    let decode_one = |(index, image): &(usize, Encoded<'_>)| texture(root, *index, image.bytes());
    let decoded: Vec<Result<Texture, Fault>> = encoded.par_iter().map(decode_one).collect();
    decoded.into_iter().collect()
}

/// Names an image for people: its index, and its name or file where it has one.
fn place(root: &Root, index: usize) -> String {
    let image = &root.images[index];
    let file = image.uri.as_ref().filter(|u| !u.starts_with("data:"));
    match image.name.as_ref().or(file) {
        Some(name) => format!("images[{index}] ({name})"),
        None => format!("images[{index}]"),
    }
}

fn locate<'a>(
    root: &Root,
    index: usize,
    buffers: &'a Buffers<'_>,
    files: &mut Files,
) -> Result<Encoded<'a>, Fault> {
    let image = &root.images[index];
    let name = place(root, index);
    match (image.buffer_view, &image.uri) {
        (Some(view), _) => Ok(Encoded::View(buffers.view(view, || format!("{name}.bufferView"))?)),
        (None, Some(uri)) => Ok(Encoded::Fetched(files.fetch(uri, &format!("{name}.uri"))?)),
        (None, None) => Err(Fault::at(name, "has neither a uri nor a bufferView")),
    }
}

fn reader(bytes: &[u8]) -> Result<ImageReader<Cursor<&[u8]>>, image::ImageError> {
    let mut reader = ImageReader::new(Cursor::new(bytes)).with_guessed_format()?;
    let mut limits = Limits::default();
    limits.max_image_width = Some(MAX_SIZE);
    limits.max_image_height = Some(MAX_SIZE);
    limits.max_alloc = Some(MAX_BYTES);
    reader.limits(limits);
    Ok(reader)
}

fn broken(place: &str, error: &image::ImageError) -> Fault {
    Fault::at(
        place,
        format!("{error}; images must be sound PNG or JPEG up to {MAX_SIZE} pixels wide and high"),
    )
}

/// Texels by the image's header alone, within the limits.
fn texel_count(bytes: &[u8], place: &str) -> Result<u64, Fault> {
    let decoder = reader(bytes).and_then(ImageReader::into_decoder).map_err(|e| broken(place, &e))?;
    let (width, height) = decoder.dimensions();
    let texels = u64::from(width) * u64::from(height);
    if texels == 0 || width.max(height) > MAX_SIZE || texels * 4 > MAX_BYTES {
        let problem =
            format!("{width}×{height} pixels; expected 1 to {MAX_SIZE} a side, {MAX_BYTES} bytes decoded");
        return Err(Fault::at(place, problem));
    }
    Ok(texels)
}

fn texture(root: &Root, index: usize, bytes: &[u8]) -> Result<Texture, Fault> {
    let name = place(root, index);
    let decoded = reader(bytes).and_then(ImageReader::decode).map_err(|e| broken(&name, &e))?;
    let rgba = decoded.into_rgba8();
    let (width, height) = rgba.dimensions();
    let texels = rgba.as_raw().as_chunks::<4>().0.into();
    Ok(Texture { name, width, height, texels })
}
