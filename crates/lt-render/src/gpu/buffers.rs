//! Buffers: a scene's, a frame's, and reading them back.

use bytemuck::{Pod, Zeroable};
use lt_irregular::PackedLightBvh;
use lt_mask::marks_words;
use lt_math::glam::{UVec2, Vec4};
use lt_shaders::{
    abi::{Sample, Sight},
    doubt::list_words,
    neighbours::{HEARD_WORDS, row_words},
};
use wgpu::BufferUsages as Usage;

use crate::packed::Culling;
use crate::{DrawRange, PackedScene, RenderError};

/// A scene on the device. Buffers of effects that the scene does not call for do not exist.
pub struct GpuScene {
    pub(super) nodes: wgpu::Buffer,
    pub(super) triangles: wgpu::Buffer,
    pub(super) vertices: wgpu::Buffer,
    pub(super) materials: wgpu::Buffer,
    pub(super) instances: Option<wgpu::Buffer>,
    pub(super) alpha_texels: Option<wgpu::Buffer>,
    pub(super) color_texels: Option<wgpu::Buffer>,
    pub(super) previous_positions: Option<wgpu::Buffer>,
    /// Which of the draws a map sees.
    pub(super) culling: Culling,
    pub(super) draws: Vec<DrawRange>,
    /// The parts of `draws` that stand still in every pose, and that move.
    pub(super) still_draws: Vec<DrawRange>,
    pub(super) moving_draws: Vec<DrawRange>,
    /// Nodes and triangles of translucent casters.
    pub(super) translucent: Option<[wgpu::Buffer; 2]>,
    /// Trees in the spaces of lights, by the light's number.
    pub(super) light_trees: Vec<Option<LightTree>>,
}

/// All casters in the space of one light.
pub(super) struct LightTree {
    /// Homogeneous place of the light.
    pub light: Vec4,
    pub rows: wgpu::Buffer,
    pub space: wgpu::Buffer,
}

/// Per-sample buffers of a view, and what techniques keep between frames.
pub struct FrameBuffers {
    /// In samples.
    pub(super) size: UVec2,
    pub(super) samples: wgpu::Buffer,
    /// Where each sample was in the last frame; only while things in the scene move.
    pub(super) past: Option<wgpu::Buffer>,
    pub(super) visibility: wgpu::Buffer,
    /// Tint of the light at each pixel; only where translucent casters are traced.
    pub(super) tints: Option<wgpu::Buffer>,
    /// What the lights added so far give to each pixel; only while a picture is shaded.
    pub(super) light: Option<wgpu::Buffer>,
    /// Front to back, where the camera sees several layers; `samples` and `past` are then those of one of them.
    pub(super) layers: Vec<LayerBuffers>,
    /// Which one.
    pub(super) layer: usize,
    /// Colours of the layers added so far; only while a picture of several is shaded.
    pub(super) colors: Option<wgpu::Buffer>,
    pub(super) doubt: Option<DoubtBuffers>,
    /// By [`crate::FrameJob::slot`].
    pub(super) slots: Vec<SlotBuffers>,
    /// Blurred rows between the passes of a pre-filter, which no slot keeps; as many as the largest map of all slots.
    pub(super) blurred_rows: Option<wgpu::Buffer>,
}

/// One layer of what the camera sees.
pub(super) struct LayerBuffers {
    pub samples: wgpu::Buffer,
    /// What lies before each sample.
    pub sights: wgpu::Buffer,
    pub past: Option<wgpu::Buffer>,
}

impl FrameBuffers {
    /// Lets passes run on this layer, if there are several.
    pub fn show_layer(&mut self, layer: u32) {
        if let Some(shown) = self.layers.get(layer as usize) {
            (self.samples, self.past) = (shown.samples.clone(), shown.past.clone());
            self.layer = layer as usize;
        }
    }
}

/// One technique's map and history.
#[derive(Default)]
pub(super) struct SlotBuffers {
    pub map: Option<MapBuffers>,
    pub history: Option<HistoryBuffers>,
}

/// The temporal mask's memory for all lights: the last frame's and this one's take turns.
pub(super) struct HistoryBuffers {
    /// Words of a pixel, three bits a light.
    pub words: u32,
    pub bits: [wgpu::Buffer; 2],
    /// One light's last frame as words, and what they ask for around each pixel: written and read within its mask pass.
    pub rows: wgpu::Buffer,
    pub heard: wgpu::Buffer,
    /// Depths along the view axis, for the temporal depth test.
    pub depths: Option<[wgpu::Buffer; 2]>,
    /// Which of the two is this frame's.
    pub current: usize,
}

/// The maps of one light.
pub(super) struct MapBuffers {
    pub size: u32,
    pub levels: u32,
    /// Target of one level after another.
    pub texture: wgpu::TextureView,
    /// What stands still, where maps are kept under casters that move.
    pub still: Option<StillMaps>,
    /// Level after level.
    pub depths: wgpu::Buffer,
    /// Blurred vectors, of a pre-filtered map.
    pub vectors: Option<wgpu::Buffer>,
    pub marks: Option<MarkBuffers>,
}

/// Marks of a light's maps, level after level ([`lt_mask::MarksPlace`]): those that a frame reads and those that it leaves, which are its own and what it
/// adds, take turns, so that a frame may be run again and gives what it gave before.
pub(super) struct MarkBuffers {
    words: [wgpu::Buffer; 2],
    current: usize,
}

impl MarkBuffers {
    /// Begins a frame: what the last one left is what this one reads.
    pub fn turn(&mut self) {
        self.current = 1 - self.current;
    }

    /// What this frame reads.
    pub fn read(&self) -> &wgpu::Buffer {
        &self.words[self.current]
    }

    /// What this frame leaves.
    pub fn left(&self) -> &wgpu::Buffer {
        &self.words[1 - self.current]
    }
}

/// Bytes of a texel's depth.
pub(super) const DEPTH_BYTES: u64 = 4;
/// Bytes of a word of marks.
pub(super) const WORD_BYTES: u64 = 4;
/// Bytes of a depth vector, and of a row of the blur's first pass.
pub(super) const VECTOR_BYTES: u64 = 16;

/// The depths of what stands still, over which what moves is drawn anew in every frame.
pub(super) struct StillMaps {
    /// A layer a level.
    pub texture: wgpu::Texture,
    /// Which layers hold what the level's present projection sees.
    pub is_drawn: Vec<bool>,
}

/// The list of doubted pixels and the dispatch made from it.
pub(super) struct DoubtBuffers {
    pub list: wgpu::Buffer,
    pub dispatch: wgpu::Buffer,
}

impl MapBuffers {
    /// Texels of all levels.
    pub fn texels(&self) -> u64 {
        u64::from(self.size) * u64::from(self.size) * u64::from(self.levels)
    }

    /// A level's part of a buffer that holds all levels first, with so many bytes to a texel.
    pub fn part<'a>(&self, of: &'a wgpu::Buffer, level: u32, texel_bytes: u64) -> wgpu::BindingResource<'a> {
        let bytes = u64::from(self.size) * u64::from(self.size) * texel_bytes;
        wgpu::BindingResource::Buffer(wgpu::BufferBinding {
            buffer: of,
            offset: bytes * u64::from(level),
            size: std::num::NonZeroU64::new(bytes),
        })
    }

    /// Bytes the technique needs for its maps: depths (the raster target is a copy of one of them), those of what stands still, and
    /// vectors with as many blurred rows, which are lent to it, and marks.
    pub fn bytes(&self) -> u64 {
        self.depths.size() * if self.still.is_some() { 2 } else { 1 }
            + self.vectors.as_ref().map_or(0, |vectors| 2 * vectors.size())
            + self.marks.as_ref().map_or(0, |marks| 2 * marks.read().size())
    }
}

/// Makes buffers and refuses those that the device cannot bind.
#[derive(Clone)]
pub(super) struct Allocator {
    device: wgpu::Device,
    name: String,
}

impl Allocator {
    pub fn new(device: &wgpu::Device) -> Self {
        Self { device: device.clone(), name: device.adapter_info().name }
    }

    pub fn error(&self, problem: String) -> RenderError {
        RenderError::Gpu { device: self.name.clone(), problem }
    }

    fn check(&self, what: &str, bytes: u64) -> Result<(), RenderError> {
        let limits = self.device.limits();
        let most = limits.max_storage_buffer_binding_size.min(limits.max_buffer_size);
        if bytes > most {
            return Err(self.error(format!(
                "{what} need {bytes} bytes in one buffer, the device allows {most}: use a smaller scene, picture or map, \
                 fewer samples per pixel, or --backend cpu"
            )));
        }
        Ok(())
    }

    pub fn empty(&self, what: &str, bytes: u64, usage: Usage) -> Result<wgpu::Buffer, RenderError> {
        self.check(what, bytes)?;
        Ok(self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(what),
            size: bytes.max(16),
            usage,
            mapped_at_creation: false,
        }))
    }

    /// A buffer with this content; empty content becomes one zeroed element, because a binding cannot be empty.
    pub fn filled<T: Pod + Zeroable>(
        &self,
        what: &str,
        data: &[T],
        usage: Usage,
    ) -> Result<wgpu::Buffer, RenderError> {
        let zero = [T::zeroed()];
        let bytes: &[u8] = bytemuck::cast_slice(if data.is_empty() { &zero } else { data });
        self.check(what, bytes.len() as u64)?;
        use wgpu::util::{BufferInitDescriptor, DeviceExt};
        Ok(self.device.create_buffer_init(&BufferInitDescriptor {
            label: Some(what),
            contents: bytes,
            usage,
        }))
    }

    pub fn scene(&self, scene: &PackedScene) -> Result<GpuScene, RenderError> {
        let used = |data: &[u32], what| match data {
            [] => Ok(None),
            _ => self.filled(what, data, Usage::STORAGE).map(Some),
        };
        Ok(GpuScene {
            nodes: self.filled("BVH nodes", scene.nodes(), Usage::STORAGE)?,
            triangles: self.filled("triangles", scene.triangles(), Usage::STORAGE)?,
            vertices: self.filled("vertices", scene.vertices(), Usage::STORAGE)?,
            materials: self.filled("materials", scene.materials(), Usage::STORAGE)?,
            instances: match scene.instances() {
                [] => None,
                all => Some(self.filled("instances", all, Usage::STORAGE)?),
            },
            alpha_texels: match scene.stats().masked_triangles {
                0 => None,
                _ => Some(self.filled("coverage texels", scene.alpha_texels(), Usage::STORAGE)?),
            },
            color_texels: used(scene.color_texels(), "colour texels")?,
            previous_positions: match scene.previous_positions() {
                [] => None,
                all => Some(self.filled("last positions", all, Usage::STORAGE)?),
            },
            culling: scene.culling(),
            draws: scene.draws().to_vec(),
            still_draws: scene.still_draws().to_vec(),
            moving_draws: scene.moving_draws().to_vec(),
            translucent: match scene.translucent() {
                None => None,
                Some(bvh) => Some([
                    self.filled("translucent casters' BVH nodes", bvh.nodes(), Usage::STORAGE)?,
                    self.filled("translucent casters' triangles", bvh.triangles(), Usage::STORAGE)?,
                ]),
            },
            light_trees: Vec::new(),
        })
    }

    pub fn light_tree(&self, light: Vec4, tree: &PackedLightBvh) -> Result<LightTree, RenderError> {
        Ok(LightTree {
            light,
            rows: self.filled("the tree in light space", &tree.rows, Usage::STORAGE)?,
            space: self.filled("light space", &[tree.space], Usage::UNIFORM)?,
        })
    }

    pub fn frame(&self, size: UVec2) -> Result<FrameBuffers, RenderError> {
        let pixels = u64::from(size.x) * u64::from(size.y);
        Ok(FrameBuffers {
            size,
            samples: self.samples(size)?,
            layers: Vec::new(),
            layer: 0,
            colors: None,
            visibility: self.empty(
                "visibility",
                pixels * 4,
                Usage::STORAGE | Usage::COPY_SRC | Usage::COPY_DST,
            )?,
            tints: None,
            light: None,
            past: None,
            doubt: None,
            slots: Vec::new(),
            blurred_rows: None,
        })
    }

    pub fn map(
        &self,
        size: u32,
        levels: u32,
        (is_prefiltered, has_marks): (bool, bool),
    ) -> Result<MapBuffers, RenderError> {
        let most = self.device.limits().max_texture_dimension_2d;
        if size > most {
            return Err(self.error(format!(
                "a map of {size}² texels exceeds the device's {most}²: use --map-size {most}"
            )));
        }
        let texels = u64::from(size) * u64::from(size) * u64::from(levels);
        let uses = wgpu::TextureUsages::COPY_SRC | wgpu::TextureUsages::COPY_DST;
        let texture = self.depths("depth map", (size, 1), uses | wgpu::TextureUsages::RENDER_ATTACHMENT);
        Ok(MapBuffers {
            size,
            levels,
            texture: texture.create_view(&wgpu::TextureViewDescriptor::default()),
            still: None,
            depths: self.empty("depths", texels * DEPTH_BYTES, Usage::STORAGE | Usage::COPY_DST)?,
            vectors: match is_prefiltered {
                true => Some(self.empty("blurred vectors", texels * VECTOR_BYTES, Usage::STORAGE)?),
                false => None,
            },
            marks: match has_marks {
                true => {
                    let usage = Usage::STORAGE | Usage::COPY_SRC | Usage::COPY_DST;
                    let words = || self.empty("marks", marks_words(texels) * WORD_BYTES, usage);
                    Some(MarkBuffers { words: [words()?, words()?], current: 0 })
                }
                false => None,
            },
        })
    }

    /// Room for the blurred rows of maps with so many texels.
    pub fn blurred_rows(&self, texels: u64) -> Result<wgpu::Buffer, RenderError> {
        self.empty("blurred rows", texels * VECTOR_BYTES, Usage::STORAGE)
    }

    /// Room for what stands still in maps of `size`² texels.
    pub fn still_maps(&self, size: u32, levels: u32) -> StillMaps {
        let uses = wgpu::TextureUsages::COPY_SRC | wgpu::TextureUsages::COPY_DST;
        StillMaps {
            texture: self.depths("what stands still", (size, levels), uses),
            is_drawn: vec![false; levels as usize],
        }
    }

    /// A texture of depths with so many texels along its side, and layers.
    fn depths(&self, label: &str, (side, layers): (u32, u32), usage: wgpu::TextureUsages) -> wgpu::Texture {
        self.device.create_texture(&wgpu::TextureDescriptor {
            label: Some(label),
            size: wgpu::Extent3d { width: side, height: side, depth_or_array_layers: layers },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Depth32Float,
            usage,
            view_formats: &[],
        })
    }

    pub fn tints(&self, size: UVec2) -> Result<wgpu::Buffer, RenderError> {
        let pixels = u64::from(size.x) * u64::from(size.y);
        self.empty("tints", pixels * 16, Usage::STORAGE | Usage::COPY_SRC | Usage::COPY_DST)
    }

    fn samples(&self, size: UVec2) -> Result<wgpu::Buffer, RenderError> {
        let bytes = u64::from(size.x) * u64::from(size.y) * size_of::<Sample>() as u64;
        self.empty("samples", bytes, Usage::STORAGE | Usage::COPY_SRC)
    }

    /// Light or colours: four numbers a sample, zero at first.
    pub fn light(&self, size: UVec2) -> Result<wgpu::Buffer, RenderError> {
        let pixels = u64::from(size.x) * u64::from(size.y);
        self.empty("light", pixels * 16, Usage::STORAGE)
    }

    pub fn sights(&self, size: UVec2) -> Result<wgpu::Buffer, RenderError> {
        let bytes = u64::from(size.x) * u64::from(size.y) * size_of::<Sight>() as u64;
        self.empty("sights", bytes, Usage::STORAGE | Usage::COPY_SRC | Usage::COPY_DST)
    }

    pub fn layer(&self, size: UVec2, object_motion: bool) -> Result<LayerBuffers, RenderError> {
        Ok(LayerBuffers {
            samples: self.samples(size)?,
            sights: self.sights(size)?,
            past: if object_motion { Some(self.past(size)?) } else { None },
        })
    }

    pub fn past(&self, size: UVec2) -> Result<wgpu::Buffer, RenderError> {
        let pixels = u64::from(size.x) * u64::from(size.y);
        self.empty("last positions of samples", pixels * 16, Usage::STORAGE)
    }

    pub fn history(&self, size: UVec2, words: u32, has_depths: bool) -> Result<HistoryBuffers, RenderError> {
        let bytes = u64::from(size.x) * u64::from(size.y) * 4;
        let usage = Usage::STORAGE | Usage::COPY_SRC | Usage::COPY_DST;
        let bits = || self.empty("mask", bytes * u64::from(words), usage);
        let depths = || self.empty("last depths", bytes, Usage::STORAGE);
        let rows = u64::from(row_words(size.x)) * u64::from(size.y);
        Ok(HistoryBuffers {
            words,
            bits: [bits()?, bits()?],
            rows: self.empty("mask rows", rows * 16, Usage::STORAGE)?,
            heard: self.empty("neighbours", rows * u64::from(HEARD_WORDS) * 4, Usage::STORAGE)?,
            depths: match has_depths {
                true => Some([depths()?, depths()?]),
                false => None,
            },
            current: 0,
        })
    }

    pub fn doubt(&self, size: UVec2) -> Result<DoubtBuffers, RenderError> {
        let words = u64::from(list_words(size.x * size.y));
        Ok(DoubtBuffers {
            list: self.empty("doubt list", words * 4, Usage::STORAGE | Usage::COPY_SRC | Usage::COPY_DST)?,
            dispatch: self.empty("dispatch", 16, Usage::INDIRECT | Usage::COPY_DST)?,
        })
    }

    /// Waits for everything submitted.
    pub fn wait(&self) -> Result<(), RenderError> {
        let status = self.device.poll(wgpu::PollType::wait_indefinitely());
        status.map(|_| ()).map_err(|e| self.error(format!("waiting for the device failed: {e}")))
    }

    /// Copies a buffer to the host and waits for it.
    pub fn read<T: Pod>(
        &self,
        queue: &wgpu::Queue,
        source: &wgpu::Buffer,
        bytes: u64,
    ) -> Result<Vec<T>, RenderError> {
        let staging = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("read back"),
            size: bytes,
            usage: Usage::MAP_READ | Usage::COPY_DST,
            mapped_at_creation: false,
        });
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encoder.copy_buffer_to_buffer(source, 0, &staging, 0, bytes);
        queue.submit([encoder.finish()]);
        staging.map_async(wgpu::MapMode::Read, .., |_| {});
        self.wait()?;
        let view =
            staging.get_mapped_range(..).map_err(|e| self.error(format!("reading back failed: {e}")))?;
        // The mapping is aligned to 8 bytes at least; `Pod` types here need 4 or 16, so copy bytewise.
        let mut values = vec![T::zeroed(); bytes as usize / size_of::<T>()];
        bytemuck::cast_slice_mut::<T, u8>(&mut values).copy_from_slice(&view);
        Ok(values)
    }
}
