//! Bounds-checked random access to accessor elements, sparse ones included (glTF 2.0 specification, 3.6.2).
//!
//! An accessor is checked once, when first opened; reading an element then allocates nothing, so that a huge `count`
//! over little data costs nothing either.

use std::cell::OnceCell;

use super::{
    buffers::Buffers,
    fault::{Fault, pick},
    json::{self, Root},
};

/// Type of one component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    /// Any type an attribute may have once quantised (KHR_mesh_quantization).
    pub(super) const NUMBERS: &[Self] = &[Self::I8, Self::U8, Self::I16, Self::U16, Self::F32];
    /// Types of vertex and joint indices.
    pub(super) const INDICES: &[Self] = &[Self::U8, Self::U16, Self::U32];

    fn from_code(code: u32) -> Option<Self> {
        Some(match code {
            5120 => Self::I8,
            5121 => Self::U8,
            5122 => Self::I16,
            5123 => Self::U16,
            5125 => Self::U32,
            5126 => Self::F32,
            _ => return None,
        })
    }

    fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }
}

/// Elements of one accessor.
pub(super) struct Accessor<'a> {
    index: usize,
    /// From the first element on; none where all elements are zero.
    data: Option<&'a [u8]>,
    stride: usize,
    component: Component,
    components: usize,
    is_normalized: bool,
    count: usize,
    sparse: Option<Sparse<'a>>,
}

/// Elements that replace others.
struct Sparse<'a> {
    /// Ascending.
    indices: Vec<u32>,
    values: &'a [u8],
}

impl Accessor<'_> {
    /// Number of elements.
    pub(super) fn count(&self) -> usize {
        self.count
    }

    /// Number of components of an element.
    pub(super) fn components(&self) -> usize {
        self.components
    }

    /// How messages call it.
    pub(super) fn name(&self) -> String {
        format!("accessors[{}]", self.index)
    }

    /// Element `i` as finite floats, missing components zero; integers are scaled if the accessor is normalized.
    pub(super) fn finite<const N: usize>(&self, i: usize) -> Result<[f32; N], Fault> {
        let values = self.floats(i);
        if values.iter().all(|v| v.is_finite()) {
            return Ok(values);
        }
        let problem = format!("element {i} is not finite: {values:?}; repair the model and re-export");
        Err(Fault::at(self.name(), problem))
    }

    /// Element `i` as floats, which may be anything.
    pub(super) fn floats<const N: usize>(&self, i: usize) -> [f32; N] {
        let mut values = [0.0; N];
        if let Some(element) = self.element(i) {
            let parts = element.chunks_exact(self.component.size());
            for (value, bytes) in values.iter_mut().zip(parts) {
                *value = self.float(bytes);
            }
        }
        values
    }

    /// Element `i` as unsigned integers, missing components zero.
    pub(super) fn integers<const N: usize>(&self, i: usize) -> [u32; N] {
        let mut values = [0; N];
        if let Some(element) = self.element(i) {
            let parts = element.chunks_exact(self.component.size());
            for (value, bytes) in values.iter_mut().zip(parts) {
                *value = integer(bytes);
            }
        }
        values
    }

    /// The bytes of element `i`, none if it is zero or past the end.
    fn element(&self, i: usize) -> Option<&[u8]> {
        let size = self.components * self.component.size();
        if let Some(sparse) = &self.sparse
            && let Ok(slot) = sparse.indices.binary_search(&u32::try_from(i).ok()?)
        {
            return sparse.values.get(slot * size..(slot + 1) * size);
        }
        let start = i.checked_mul(self.stride)?;
        self.data?.get(start..start.checked_add(size)?)
    }

    /// Conversions of section 3.6.2.2.
    fn float(&self, bytes: &[u8]) -> f32 {
        let signed = |v: f32, max: f32| if self.is_normalized { (v / max).max(-1.0) } else { v };
        match (self.component, bytes) {
            (Component::I8, &[a]) => signed(f32::from(a as i8), 127.0),
            (Component::U8, &[a]) => signed(f32::from(a), 255.0),
            (Component::I16, &[a, b]) => signed(f32::from(i16::from_le_bytes([a, b])), 32767.0),
            (Component::U16, &[a, b]) => signed(f32::from(u16::from_le_bytes([a, b])), 65535.0),
            (Component::F32, &[a, b, c, d]) => f32::from_le_bytes([a, b, c, d]),
            _ => integer(bytes) as f32,
        }
    }
}

/// A little-endian unsigned integer of up to four bytes.
fn integer(bytes: &[u8]) -> u32 {
    bytes.iter().rev().fold(0, |value, &b| value << 8 | u32::from(b))
}

/// What the user of an accessor can read.
pub(super) struct Wanted<'a> {
    /// Names the reference to the accessor, e.g. `meshes[0].primitives[0].indices`.
    pub(super) place: &'a str,
    /// Permitted element types.
    pub(super) kinds: &'a [&'a str],
    /// Permitted component types.
    pub(super) components: &'a [Component],
}

/// All accessors of an asset.
pub(super) struct Accessors<'a> {
    root: &'a Root,
    buffers: &'a Buffers<'a>,
    opened: Vec<OnceCell<Accessor<'a>>>,
}

impl<'a> Accessors<'a> {
    pub(super) fn new(root: &'a Root, buffers: &'a Buffers<'a>) -> Self {
        Self { root, buffers, opened: root.accessors.iter().map(|_| OnceCell::new()).collect() }
    }

    /// Checks accessor `index` and that it is of a type its user can read.
    pub(super) fn open(&self, index: usize, wanted: &Wanted<'_>) -> Result<&Accessor<'a>, Fault> {
        let json = pick(&self.root.accessors, index, "accessors", || wanted.place.to_owned())?;
        let cell = &self.opened[index];
        let accessor = match cell.get() {
            Some(accessor) => accessor,
            None => {
                let checked = self.check(index, json)?;
                cell.get_or_init(|| checked)
            }
        };
        let is_readable = wanted.kinds.contains(&json.kind.as_str())
            && wanted.components.contains(&accessor.component)
            && !(accessor.is_normalized && accessor.component == Component::U32);
        if is_readable {
            return Ok(accessor);
        }
        let problem = format!(
            "accessors[{index}] holds {} of {:?}, expected {} of {:?}",
            json.kind,
            accessor.component,
            wanted.kinds.join(" or "),
            wanted.components
        );
        Err(Fault::at(wanted.place, problem))
    }

    fn check(&self, index: usize, json: &json::Accessor) -> Result<Accessor<'a>, Fault> {
        let name = || format!("accessors[{index}]");
        let component = component(json.component_type, &name())?;
        let components = match json.kind.as_str() {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            "VEC4" => 4,
            "MAT4" => 16,
            other => {
                return Err(Fault::at(
                    name(),
                    format!("type {other:?} is not one that is used for geometry"),
                ));
            }
        };
        let size = components * component.size();
        let stride = json.buffer_view.and_then(|v| self.buffers.stride(v)).unwrap_or(size);
        if stride < size {
            let problem =
                format!("byteStride {stride} of its view is smaller than an element of {size} bytes");
            return Err(Fault::at(name(), problem));
        }
        let data = match json.buffer_view {
            None => None,
            Some(view) => {
                let bytes = self.buffers.view(view, || format!("{}.bufferView", name()))?;
                Some(region(bytes, json.byte_offset, json.count, stride, size, &name())?)
            }
        };
        let sparse = match &json.sparse {
            None => None,
            Some(sparse) => Some(self.check_sparse(sparse, json.count, size, &name())?),
        };
        let is_normalized = json.normalized && component != Component::F32;
        Ok(Accessor { index, data, stride, component, components, is_normalized, count: json.count, sparse })
    }

    fn check_sparse(
        &self,
        json: &json::Sparse,
        count: usize,
        size: usize,
        name: &str,
    ) -> Result<Sparse<'a>, Fault> {
        let place = format!("{name}.sparse.indices");
        let component = component(json.indices.component_type, &place)?;
        if !Component::INDICES.contains(&component) {
            return Err(Fault::at(place, format!("holds {component:?}, expected unsigned integers")));
        }
        let bytes = self.buffers.view(json.indices.buffer_view, || format!("{place}.bufferView"))?;
        let width = component.size();
        let bytes = region(bytes, json.indices.byte_offset, json.count, width, width, &place)?;
        let indices: Vec<u32> = bytes.chunks_exact(width).take(json.count).map(integer).collect();
        if let Some(i) = indices.windows(2).position(|w| w[0] >= w[1]) {
            return Err(Fault::at(place, format!("element {} does not exceed the one before it", i + 1)));
        }
        if let Some(&last) = indices.last().filter(|&&last| last as usize >= count) {
            return Err(Fault::at(place, format!("replaces element {last} of an accessor of {count}")));
        }
        let place = format!("{name}.sparse.values");
        let bytes = self.buffers.view(json.values.buffer_view, || format!("{place}.bufferView"))?;
        let values = region(bytes, json.values.byte_offset, json.count, size, size, &place)?;
        Ok(Sparse { indices, values })
    }
}

fn component(code: u32, place: &str) -> Result<Component, Fault> {
    Component::from_code(code)
        .ok_or_else(|| Fault::at(place, format!("componentType {code} is not a glTF type")))
}

/// The bytes from `offset` on if `count` elements of `size` bytes, `stride` apart, fit into them.
fn region<'b>(
    bytes: &'b [u8],
    offset: usize,
    count: usize,
    stride: usize,
    size: usize,
    place: &str,
) -> Result<&'b [u8], Fault> {
    let needed = match count.checked_sub(1) {
        None => Some(0),
        Some(steps) => steps.checked_mul(stride).and_then(|n| n.checked_add(size)),
    };
    let rest = bytes.get(offset..);
    if let (Some(needed), Some(rest)) = (needed, rest)
        && needed <= rest.len()
    {
        return Ok(rest);
    }
    let needed = needed.map_or("more than can be counted".to_owned(), |n| n.to_string());
    Err(Fault::at(
        place,
        format!(
            "{count} elements, {stride} bytes apart from byteOffset {offset} on, need {needed} bytes; the view has \
             {} in all",
            bytes.len()
        ),
    ))
}
