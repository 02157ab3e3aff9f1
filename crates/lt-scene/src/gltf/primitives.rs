//! Reads a primitive: its triangles, only the vertices they use, and what deforms them.

use std::collections::BTreeMap;

use lt_math::glam::{Vec2, Vec3, Vec4};

use super::{
    accessors::{Accessor, Accessors, Component, Wanted},
    budget::Budget,
    fault::{Fault, pick},
    json::{self, Root},
    materials::{Surface, UvUse},
    morph::Target,
    skin::Influences,
    triangles::{Mode, is_degenerate},
};
use crate::{Bounds, Mesh, Repairs};

/// Characters kept of a mesh's name.
const MAX_NAME_CHARS: usize = 100;

/// A primitive at rest.
#[derive(Clone, Debug)]
pub(super) struct Primitive {
    /// Its material is an index into the file's materials, or their count for the default one.
    pub(super) mesh: Mesh,
    /// Of `mesh`.
    pub(super) bounds: Bounds,
    pub(super) targets: Vec<Target>,
    pub(super) influences: Option<Influences>,
}

/// What reading a primitive needs and counts.
pub(super) struct PrimitiveReader<'s, 'a> {
    pub(super) root: &'s Root,
    pub(super) accessors: &'s Accessors<'a>,
    pub(super) surfaces: &'s [Surface],
    pub(super) budget: Budget,
    pub(super) repairs: Repairs,
}

impl PrimitiveReader<'_, '_> {
    /// All triangle primitives of a mesh; points, lines and empty ones are counted and left out.
    pub(super) fn mesh(&mut self, index: usize) -> Result<Vec<Primitive>, Fault> {
        let json = &self.root.meshes[index];
        // Cut: every primitive repeats it.
        let name = json.name.as_ref().map(|name| name.chars().take(MAX_NAME_CHARS).collect());
        let base: String = name.unwrap_or_else(|| format!("meshes[{index}]"));
        let mut primitives = Vec::new();
        for (p, primitive) in json.primitives.iter().enumerate() {
            let place = format!("meshes[{index}].primitives[{p}]");
            let name = if json.primitives.len() > 1 { format!("{base}/{p}") } else { base.clone() };
            primitives.extend(self.primitive(primitive, &place, name)?);
        }
        Ok(primitives)
    }

    fn primitive(
        &mut self,
        json: &json::Primitive,
        place: &str,
        name: String,
    ) -> Result<Option<Primitive>, Fault> {
        let mode = match json.mode.unwrap_or(4) {
            4 => Mode::Triangles,
            5 => Mode::Strip,
            6 => Mode::Fan,
            0..4 => {
                self.repairs.non_triangle_primitives += 1;
                return Ok(None);
            }
            other => {
                return Err(Fault::at(format!("{place}.mode"), format!("{other} is not a mode (0 to 6)")));
            }
        };
        let accessors = self.accessors;
        let Some(position) = attribute(accessors, &json.attributes, place, &POSITION)? else {
            self.repairs.notes.push(format!("{place} has no POSITION and was skipped"));
            return Ok(None);
        };
        let material = match json.material {
            Some(i) => {
                pick(self.surfaces, i, "materials", || format!("{place}.material"))?;
                i
            }
            None => self.surfaces.len(),
        };
        let is_deformable = !json.targets.is_empty() || json.attributes.contains_key("JOINTS_0");
        let corners = self.triangles(json, mode, position, is_deformable, place)?;
        if corners.is_empty() {
            return Ok(None);
        }
        let mut used = corners.clone();
        used.sort_unstable();
        used.dedup();
        let vertices = Vertices { accessors, used: &used, count: position.count(), place };
        let slot = |corner| used.binary_search(corner).map_or(0, |i| i as u32);
        let indices = corners.iter().map(slot).collect();
        let positions = vertices.read(position, |v: [f32; 3]| Vec3::from(v))?;
        let normals = self.normals(&vertices, &json.attributes)?;
        let uv = self.surfaces.get(material).and_then(|s| s.uv);
        let uvs = self.uvs(&vertices, &json.attributes, uv)?;
        let colors = colors(&vertices, &json.attributes)?;
        let per_vertex = 2 * json.targets.len() as u64 + 4 * json.attributes.len() as u64;
        self.budget.charge(per_vertex.saturating_mul(used.len() as u64), || place.to_owned())?;
        let targets = Target::read_all(&json.targets, &vertices)?;
        let influences = Influences::read(&json.attributes, &vertices, &mut self.repairs)?;
        let bounds = positions.iter().fold(Bounds::EMPTY, |b, &p| b.including(p));
        let mesh = Mesh { name, positions, normals, uvs, colors, indices, material: material as u32 };
        Ok(Some(Primitive { mesh, bounds, targets, influences }))
    }

    /// Vertex numbers of the corners, three per triangle that has an area. What is going to be deformed may gain one
    /// it does not have at rest.
    fn triangles(
        &mut self,
        json: &json::Primitive,
        mode: Mode,
        position: &Accessor<'_>,
        is_deformable: bool,
        place: &str,
    ) -> Result<Vec<u32>, Fault> {
        let place = format!("{place}.indices");
        let wanted = Wanted { place: &place, kinds: &["SCALAR"], components: Component::INDICES };
        let indices = json.indices.map(|i| self.accessors.open(i, &wanted)).transpose()?;
        let count = indices.map_or(position.count(), Accessor::count);
        let triangle_count = mode.triangle_count(count);
        if mode == Mode::Triangles && count % 3 != 0 {
            self.repairs
                .notes
                .push(format!("{place}: {} indices after the last triangle ignored", count % 3));
        }
        self.budget.charge((triangle_count as u64).saturating_mul(3), || place.clone())?;
        let vertex = |i: usize| -> Result<u32, Fault> {
            let [vertex] = indices.map_or([i as u32], |indices| indices.integers::<1>(i));
            if (vertex as usize) < position.count() {
                return Ok(vertex);
            }
            let accessor = indices.map_or(String::new(), Accessor::name);
            let problem =
                format!("element {i} of {accessor} is {vertex}, but there are {} vertices", position.count());
            Err(Fault::at(place.clone(), problem))
        };
        let mut corners = Vec::new();
        for triangle in 0..triangle_count {
            let [i, j, k] = mode.corners(triangle);
            let t = [vertex(i)?, vertex(j)?, vertex(k)?];
            let is_collapsed = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
            let place_of = |v: u32| position.finite::<3>(v as usize).map(Vec3::from);
            let points = [place_of(t[0])?, place_of(t[1])?, place_of(t[2])?];
            if is_collapsed || (!is_deformable && is_degenerate(points)) {
                self.repairs.degenerate_triangles += 1;
            } else {
                corners.extend(t);
            }
        }
        Ok(corners)
    }

    fn normals(
        &mut self,
        vertices: &Vertices<'_, '_>,
        attributes: &BTreeMap<String, usize>,
    ) -> Result<Vec<Vec3>, Fault> {
        let Some(accessor) = vertices.attribute(attributes, &NORMAL)? else { return Ok(Vec::new()) };
        let normals =
            vertices.used.iter().map(|&v| Vec3::from(accessor.floats::<3>(v as usize)).try_normalize());
        let normals: Vec<Option<Vec3>> = normals.collect();
        let bad = normals.iter().filter(|n| n.is_none()).count();
        self.repairs.bad_normals += bad;
        Ok(if bad == 0 { normals.into_iter().flatten().collect() } else { Vec::new() })
    }

    fn uvs(
        &mut self,
        vertices: &Vertices<'_, '_>,
        attributes: &BTreeMap<String, usize>,
        uv: Option<UvUse>,
    ) -> Result<Vec<Vec2>, Fault> {
        let Some(uv) = uv else { return Ok(Vec::new()) };
        let name = format!("TEXCOORD_{}", uv.set);
        let spec = AttributeSpec { name: &name, kinds: &["VEC2"], components: Component::NUMBERS };
        let Some(accessor) = vertices.attribute(attributes, &spec)? else {
            let place = vertices.place;
            self.repairs.notes.push(format!("{place} lacks {name}, which its base colour texture needs"));
            return Ok(Vec::new());
        };
        let mut bad = 0_usize;
        let mut transformed = |&v: &u32| {
            let uv = uv.transform.matrix * Vec2::from(accessor.floats::<2>(v as usize)) + uv.transform.offset;
            if uv.is_finite() {
                return uv;
            }
            bad += 1;
            Vec2::ZERO
        };
        let uvs = vertices.used.iter().map(&mut transformed).collect();
        if bad > 0 {
            self.repairs
                .notes
                .push(format!("{}.{name}: {bad} coordinates not finite, set to 0", vertices.place));
        }
        Ok(uvs)
    }
}

/// The used vertices of one primitive.
pub(super) struct Vertices<'s, 'a> {
    pub(super) accessors: &'s Accessors<'a>,
    /// Ascending vertex numbers.
    pub(super) used: &'s [u32],
    /// Elements of POSITION.
    pub(super) count: usize,
    pub(super) place: &'s str,
}

impl<'s, 'a> Vertices<'s, 'a> {
    /// The accessor of an attribute if the primitive has it; it must not be shorter than POSITION.
    pub(super) fn attribute(
        &self,
        attributes: &BTreeMap<String, usize>,
        spec: &AttributeSpec<'_>,
    ) -> Result<Option<&'s Accessor<'a>>, Fault> {
        let accessor = attribute(self.accessors, attributes, self.place, spec)?;
        if let Some(a) = accessor.filter(|a| a.count() < self.count) {
            let problem = format!("{} has {} elements, POSITION {}", a.name(), a.count(), self.count);
            return Err(Fault::at(format!("{}.{}", self.place, spec.name), problem));
        }
        Ok(accessor)
    }

    /// Every used element, finite.
    pub(super) fn read<const N: usize, T>(
        &self,
        accessor: &Accessor<'_>,
        convert: impl Fn([f32; N]) -> T,
    ) -> Result<Vec<T>, Fault> {
        self.used.iter().map(|&v| accessor.finite(v as usize).map(&convert)).collect()
    }
}

/// What an attribute is called and may hold.
pub(super) struct AttributeSpec<'a> {
    pub(super) name: &'a str,
    pub(super) kinds: &'a [&'a str],
    pub(super) components: &'a [Component],
}

pub(super) const POSITION: AttributeSpec<'_> =
    AttributeSpec { name: "POSITION", kinds: &["VEC3"], components: Component::NUMBERS };
pub(super) const NORMAL: AttributeSpec<'_> =
    AttributeSpec { name: "NORMAL", kinds: &["VEC3"], components: Component::NUMBERS };
const COLOR: AttributeSpec<'_> =
    AttributeSpec { name: "COLOR_0", kinds: &["VEC3", "VEC4"], components: Component::NUMBERS };

fn attribute<'s, 'a>(
    accessors: &'s Accessors<'a>,
    attributes: &BTreeMap<String, usize>,
    place: &str,
    spec: &AttributeSpec<'_>,
) -> Result<Option<&'s Accessor<'a>>, Fault> {
    let Some(&index) = attributes.get(spec.name) else { return Ok(None) };
    let place = format!("{place}.{}", spec.name);
    accessors.open(index, &Wanted { place: &place, kinds: spec.kinds, components: spec.components }).map(Some)
}

fn colors(vertices: &Vertices<'_, '_>, attributes: &BTreeMap<String, usize>) -> Result<Vec<[u8; 4]>, Fault> {
    let Some(accessor) = vertices.attribute(attributes, &COLOR)? else { return Ok(Vec::new()) };
    let is_opaque = accessor.components() == 3;
    let quantize = |v: [f32; 4]| {
        let color = Vec4::from(v).clamp(Vec4::ZERO, Vec4::ONE) * 255.0;
        let [r, g, b, a] = color.round().to_array().map(|c| c as u8);
        [r, g, b, if is_opaque { 255 } else { a }]
    };
    vertices.read(accessor, quantize)
}
