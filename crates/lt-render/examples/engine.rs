//! Leak tracing inside an engine: its own device, its own rasterised G-buffer, its own encoder, frame after frame.
//!
//! ```sh
//! cargo run --release -p lt-render --example engine            # writes engine.png: the last frame's shadows
//! ```
//!
//! The engine here draws world positions and normals of a built-in street by a pipeline of its own. Leak tracing gets these two
//! textures and gives back one of visibility. What it needs in each frame, which maps are drawn anew and what history is followed,
//! comes from [`FramePlanner`]. Full ray tracing of the same G-buffer is recorded beside it, and the two are compared.

use std::error::Error;

use lt_math::glam::{UVec2, Vec4};
use lt_render::gpu::{FrameBuffers, GBuffer, GpuScene, Recorder, open};
use lt_render::{FramePlanner, PackedScene, Sequence, Setup, Technique};
use lt_scene::Source;
use lt_shaders::abi::CameraParams;
use wgpu::util::DeviceExt;

const SIZE: UVec2 = UVec2::new(640, 384);
const FRAMES: u32 = 8;
/// What is recorded: leak tracing, and the truth.
const TECHNIQUES: [&str; 2] = ["lt-evsm", "ray"];

fn main() -> Result<(), Box<dyn Error>> {
    let scene = Source::open("street", 1)?.pose(0.0)?;
    let packed = PackedScene::new(&scene)?;
    let setup = Setup::for_scene(&scene, SIZE.x, SIZE.y);
    let mut camera = setup.camera.clone();
    let mut planner = FramePlanner::new(&packed, setup)?;
    planner.play(Sequence { is_played: true, camera_moves: true, ..Sequence::default() });

    let (_, device, queue) = open()?;
    let engine = Engine::new(&device, &packed);
    let mut recorder = Recorder::new(&device);
    let gpu_scene = recorder.upload(&packed)?;
    // Each technique keeps its maps and its history in buffers of its own.
    let mut frames = [recorder.frame_buffers(SIZE)?, recorder.frame_buffers(SIZE)?];
    let targets = TECHNIQUES.map(|_| texture(&device, wgpu::TextureFormat::R32Float, Usage::STORAGE_BINDING));

    for number in 0..FRAMES {
        camera.eye.x += 0.01;
        planner.look(&camera)?;
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        engine.draw(&device, &mut encoder, planner.camera());
        for ((id, frame), target) in TECHNIQUES.iter().zip(&mut frames).zip(&targets) {
            let technique: Technique = id.parse()?;
            record(&mut recorder, &mut encoder, (&gpu_scene, frame), &engine, (&mut planner, &technique))?;
            recorder.export_visibility(&mut encoder, frame, &target.create_view(&Default::default()))?;
        }
        queue.submit([encoder.finish()]);
        // An engine would shade now. To look at it here, visibilities are read back.
        let [ours, truth] = [read(&device, &queue, &targets[0])?, read(&device, &queue, &targets[1])?];
        let wrong = ours.iter().zip(&truth).filter(|(a, b)| a != b).count();
        println!("frame {number}: {wrong} of {} pixels differ from full ray tracing", truth.len());
        if number + 1 == FRAMES {
            let bytes = ours.iter().map(|v| (v * 255.0) as u8).collect();
            let picture =
                image::GrayImage::from_raw(SIZE.x, SIZE.y, bytes).ok_or("a picture of another size")?;
            picture.save("engine.png")?;
        }
    }
    Ok(())
}

/// Records a technique's next frame: what an engine does for shadows.
fn record(
    recorder: &mut Recorder,
    encoder: &mut wgpu::CommandEncoder,
    (scene, frame): (&GpuScene, &mut FrameBuffers),
    engine: &Engine,
    (planner, technique): (&mut FramePlanner, &Technique),
) -> Result<(), lt_render::RenderError> {
    let views = [&engine.positions, &engine.normals].map(|t| t.create_view(&Default::default()));
    let gbuffer = GBuffer { positions: &views[0], normals: &views[1], last_positions: None };
    recorder.import_gbuffer(encoder, frame, gbuffer)?;
    // One job for each light; there is one.
    for job in planner.next_frame(technique) {
        recorder.prepare(frame, &job)?;
        for kind in job.passes() {
            recorder.pass(encoder, scene, frame, kind, &job)?;
        }
    }
    Ok(())
}

/// What any engine has: vertices and a pass that fills a G-buffer.
struct Engine {
    vertices: wgpu::Buffer,
    count: u32,
    pipeline: wgpu::RenderPipeline,
    positions: wgpu::Texture,
    normals: wgpu::Texture,
    depth: wgpu::Texture,
}

use wgpu::TextureUsages as Usage;

const GBUFFER_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Float;
const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// World positions with w = the largest coordinate of the triangle, and geometric normals that face the camera. Depth is near / distance.
const GBUFFER_WGSL: &str = "
struct Camera { eye: vec4f, right: vec4f, up: vec4f, forward: vec4f }
@group(0) @binding(0) var<uniform> camera: Camera;
struct Corner { @builtin(position) clip: vec4f, @location(0) position: vec4f, @location(1) @interpolate(flat) normal: vec4f }
@vertex fn corner(@location(0) position: vec4f, @location(1) normal: vec4f) -> Corner {
    let to = position.xyz - camera.eye.xyz;
    let right = dot(to, camera.right.xyz) / dot(camera.right.xyz, camera.right.xyz);
    let up = dot(to, camera.up.xyz) / dot(camera.up.xyz, camera.up.xyz);
    return Corner(vec4f(right, up, 0.01, dot(to, camera.forward.xyz)), position, normal);
}
struct Texels { @location(0) position: vec4f, @location(1) normal: vec4f }
@fragment fn texels(corner: Corner) -> Texels {
    let faces = dot(corner.normal.xyz, camera.eye.xyz - corner.position.xyz) > 0.0;
    return Texels(corner.position, select(-corner.normal, corner.normal, faces));
}";

impl Engine {
    fn new(device: &wgpu::Device, scene: &PackedScene) -> Self {
        let corners: Vec<[Vec4; 2]> = scene
            .triangles()
            .iter()
            .flat_map(|t| {
                let normal = (t.v1 - t.v0).cross(t.v2 - t.v0).normalize_or_zero().extend(0.0);
                let magnitude = t.v0.abs().max(t.v1.abs()).max(t.v2.abs()).max_element();
                [t.v0, t.v1, t.v2].map(|v| [v.extend(magnitude), normal])
            })
            .collect();
        let vertices = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some("corners"),
            contents: bytemuck::cast_slice(&corners),
            usage: wgpu::BufferUsages::VERTEX,
        });
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("G-buffer"),
            source: wgpu::ShaderSource::Wgsl(GBUFFER_WGSL.into()),
        });
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("G-buffer"),
            layout: None,
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("corner"),
                compilation_options: Default::default(),
                buffers: &[Some(wgpu::VertexBufferLayout {
                    array_stride: size_of::<[Vec4; 2]>() as u64,
                    step_mode: wgpu::VertexStepMode::Vertex,
                    attributes: &wgpu::vertex_attr_array![0 => Float32x4, 1 => Float32x4],
                })],
            },
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("texels"),
                compilation_options: Default::default(),
                targets: &[Some(GBUFFER_FORMAT.into()), Some(GBUFFER_FORMAT.into())],
            }),
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(true),
                depth_compare: Some(wgpu::CompareFunction::Greater),
                stencil: Default::default(),
                bias: Default::default(),
            }),
            multisample: wgpu::MultisampleState::default(),
            multiview_mask: None,
            cache: None,
        });
        let gbuffer = |format| texture(device, format, Usage::RENDER_ATTACHMENT | Usage::TEXTURE_BINDING);
        Self {
            vertices,
            count: corners.len() as u32,
            pipeline,
            positions: gbuffer(GBUFFER_FORMAT),
            normals: gbuffer(GBUFFER_FORMAT),
            depth: gbuffer(DEPTH_FORMAT),
        }
    }

    fn draw(&self, device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder, camera: &CameraParams) {
        let rows = [camera.eye, camera.right, camera.up, camera.forward].map(|v| v.extend(0.0));
        let uniform = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some("camera"),
            contents: bytemuck::cast_slice(&rows),
            usage: wgpu::BufferUsages::UNIFORM,
        });
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &self.pipeline.get_bind_group_layout(0),
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: uniform.as_entire_binding() }],
        });
        let views = [&self.positions, &self.normals, &self.depth].map(|t| t.create_view(&Default::default()));
        // A normal of zero: nothing is visible.
        let cleared = wgpu::Operations {
            load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
            store: wgpu::StoreOp::Store,
        };
        let target = |view| {
            Some(wgpu::RenderPassColorAttachment {
                view,
                depth_slice: None,
                resolve_target: None,
                ops: cleared,
            })
        };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("G-buffer"),
            color_attachments: &[target(&views[0]), target(&views[1])],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &views[2],
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.draw(0..self.count, 0..1);
    }
}

fn texture(device: &wgpu::Device, format: wgpu::TextureFormat, usage: Usage) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width: SIZE.x, height: SIZE.y, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: usage | Usage::COPY_SRC,
        view_formats: &[],
    })
}

/// A texture of one float channel.
fn read(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    texture: &wgpu::Texture,
) -> Result<Vec<f32>, Box<dyn Error>> {
    let row = SIZE.x * 4;
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: u64::from(row * SIZE.y),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    encoder.copy_texture_to_buffer(
        texture.as_image_copy(),
        wgpu::TexelCopyBufferInfo {
            buffer: &buffer,
            layout: wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row), rows_per_image: None },
        },
        texture.size(),
    );
    queue.submit([encoder.finish()]);
    buffer.map_async(wgpu::MapMode::Read, .., |_| {});
    device.poll(wgpu::PollType::wait_indefinitely())?;
    let view = buffer.get_mapped_range(..)?;
    Ok(view.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect())
}
