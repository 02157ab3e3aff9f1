//! Buffers and the views into them.

use std::sync::Arc;

use super::{
    fault::{Fault, pick},
    files::Files,
    json::Root,
};

/// All buffers of an asset, each at least as long as it claims.
pub(super) struct Buffers<'a> {
    root: &'a Root,
    data: Vec<Source<'a>>,
    total_bytes: usize,
}

enum Source<'a> {
    Chunk(&'a [u8]),
    Fetched(Arc<[u8]>),
}

impl Source<'_> {
    fn bytes(&self) -> &[u8] {
        match self {
            Self::Chunk(bytes) => bytes,
            Self::Fetched(bytes) => bytes,
        }
    }
}

impl<'a> Buffers<'a> {
    /// Fetches them; `chunk` is the binary chunk of a GLB.
    pub(super) fn load(root: &'a Root, chunk: Option<&'a [u8]>, files: &mut Files) -> Result<Self, Fault> {
        let mut data = Vec::with_capacity(root.buffers.len());
        for (i, buffer) in root.buffers.iter().enumerate() {
            let place = format!("buffers[{i}]");
            let source = match (&buffer.uri, chunk) {
                (Some(uri), _) => Source::Fetched(files.fetch(uri, &format!("{place}.uri"))?),
                (None, Some(chunk)) if i == 0 => Source::Chunk(chunk),
                (None, _) => return Err(Fault::at(place, "has neither a uri nor the GLB's binary chunk")),
            };
            let found = source.bytes().len();
            if found < buffer.byte_length {
                let problem = format!("expected {} bytes, found {found}: truncated", buffer.byte_length);
                return Err(Fault::at(place, problem));
            }
            data.push(source);
        }
        Ok(Self { root, data, total_bytes: files.total_bytes() + chunk.map_or(0, <[u8]>::len) })
    }

    /// Bytes over all buffers; a file that several of them share counts once.
    pub(super) fn total_bytes(&self) -> usize {
        self.total_bytes
    }

    /// The bytes of view `index`, named by `place`.
    pub(super) fn view(&self, index: usize, place: impl FnOnce() -> String) -> Result<&[u8], Fault> {
        let view = pick(&self.root.buffer_views, index, "bufferViews", place)?;
        let name = || format!("bufferViews[{index}]");
        let buffer = pick(&self.root.buffers, view.buffer, "buffers", || format!("{}.buffer", name()))?;
        let end = view.byte_offset.checked_add(view.byte_length).filter(|&end| end <= buffer.byte_length);
        let bytes = end.and_then(|end| self.data[view.buffer].bytes().get(view.byte_offset..end));
        bytes.ok_or_else(|| {
            Fault::at(
                name(),
                format!(
                    "byteOffset {} + byteLength {} lies outside buffers[{}] of {} bytes",
                    view.byte_offset, view.byte_length, view.buffer, buffer.byte_length
                ),
            )
        })
    }

    /// The stride that view `index` prescribes.
    pub(super) fn stride(&self, index: usize) -> Option<usize> {
        self.root.buffer_views.get(index)?.byte_stride
    }
}
