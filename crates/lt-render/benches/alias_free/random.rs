//! Random triangles: the paper's Table 1 and the close-ups of its Figure 3.

use lt_bvh::{BuildQuality, Bvh, Opaque, Ray, Simd, Tracer, Triangle};
use lt_irregular::{Bounds, Casters, Counters, Options as MapOptions, PointOrder, SampleMap, View};
use lt_math::glam::{UVec2, Vec3, Vec4};
use lt_render::{BackendKind, PackedScene, Session, Setup, Technique, Trees};
use lt_scene::Source;
use rayon::prelude::*;

use super::options::Options;
use super::rays::RayList;
use super::{Outcome, median, timed};

/// The paper's picture.
const SIZE: UVec2 = UVec2::new(1024, 768);
/// Rays that a thread traces at a time.
const BATCH: usize = 1024;

/// One scene's figures; times in milliseconds, medians.
pub struct Row {
    pub name: String,
    pub triangles: u32,
    pub samples: usize,
    /// Of the paper's one tree of medians.
    pub nodes: usize,
    pub counters: Counters,
    /// One thread: samples into light space, with the tree of medians, and all triangles drawn.
    pub transform: f64,
    pub medians: Phases,
    /// One thread: Morton order.
    pub morton: Phases,
    /// All threads: medians in parts.
    pub medians_all: Phases,
    /// One thread, and all of them: building the ray tracer's tree, and tracing.
    pub rays: Phases,
    pub rays_all: Phases,
}

/// What is done before the triangles, or rays, and then.
#[derive(Clone, Copy)]
pub struct Phases {
    pub build: f64,
    pub run: f64,
}

impl Phases {
    pub fn total(&self) -> f64 {
        self.build + self.run
    }
}

struct Input<'a> {
    /// In the order of the scene's meshes: what puts them in the order of a tree's leaves has built that tree.
    triangles: &'a [Triangle],
    /// The same as an indexed mesh.
    positions: Vec<Vec3>,
    indices: Vec<[u32; 3]>,
    light: Vec4,
    origins: Vec<Vec3>,
    rays: Vec<Ray>,
    domain: Bounds,
    truth: Vec<bool>,
}

/// Measures one scene, from its own camera or through a narrower field of view.
pub fn measure(count: u32, fov_deg: Option<f32>, options: &Options) -> Outcome<Row> {
    let scene = Source::open(&format!("random:{count}"), 1)?.pose(0.0)?;
    let mut setup = Setup::for_scene(&scene, SIZE.x, SIZE.y);
    if let Some(fov) = fov_deg {
        setup.camera.fov_y_rad = fov.to_radians();
    }
    let session = Session::new(&scene, setup, BackendKind::Cpu)?;
    let light = session.job(&Technique::RAY).shadow.light;
    let rays = RayList::of_picture(session.samples(), SIZE, &light).rays;
    drop(session);
    let packed = PackedScene::new(&scene)?;
    let Trees::Flat(bvh) = packed.trees() else { return Err("random scenes are baked".into()) };
    let origins: Vec<Vec3> = rays.iter().map(|r| r.origin).collect();
    let mut order: Vec<usize> = (0..bvh.triangles().len()).collect();
    order.sort_unstable_by_key(|&i| bvh.sources()[i]);
    let triangles: Vec<Triangle> = order.into_iter().map(|i| bvh.triangles()[i]).collect();
    let positions: Vec<Vec3> = triangles.iter().flat_map(|t| [t.v0, t.v1, t.v2]).collect();
    let domain = positions.iter().chain(&origins).fold(Bounds::EMPTY, |all, p| all.with(*p));
    let indices = (0..triangles.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let (truth, triangles) = (trace(bvh, &rays), &triangles[..]);
    let input = Input { triangles, positions, indices, light: light.place, origins, rays, domain, truth };
    let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    let paper = MapOptions { order: PointOrder::Median, part_levels: 0, ..MapOptions::default() };
    let (mut nodes, mut counters) = (0, Counters::default());
    let mut times: [Vec<Phases>; 5] = Default::default();
    let mut transform = Vec::new();
    for _ in 0..options.repeats {
        alone.install(|| -> Outcome<()> {
            transform.push(input.transform());
            let (map, phases) = input.draw(paper)?;
            (nodes, counters) = (map.0, map.1);
            times[0].push(phases);
            times[1].push(input.draw(MapOptions { order: PointOrder::Morton, ..MapOptions::default() })?.1);
            times[3].push(input.rays()?);
            Ok(())
        })?;
        times[2].push(input.draw(MapOptions::default())?.1);
        times[4].push(input.rays()?);
    }
    let [medians, morton, medians_all, rays, rays_all] = times.map(|t| Phases {
        build: median(t.iter().map(|p| p.build).collect()),
        run: median(t.iter().map(|p| p.run).collect()),
    });
    let name = fov_deg.map_or(format!("random:{count}"), |fov| format!("random:{count} within {fov}°"));
    Ok(Row {
        name,
        triangles: count,
        samples: input.origins.len(),
        nodes,
        counters,
        transform: median(transform),
        medians,
        morton,
        medians_all,
        rays,
        rays_all,
    })
}

impl Input<'_> {
    /// The samples into light space, and no more.
    fn transform(&self) -> f64 {
        let root = Casters::of(self.triangles).root;
        let (points, ms) = timed(|| {
            let views = View::of_light(self.light, self.domain, root);
            let point = |view: &View, ray: &Ray| view.takes(ray).then(|| view.point(ray));
            views.map(|view| self.rays.iter().filter_map(|r| point(&view, r)).collect::<Vec<_>>()).collect()
        });
        let points: Vec<Vec<_>> = points;
        std::hint::black_box(points);
        ms
    }

    /// An alias-free map: nodes, counters and times.
    fn draw(&self, options: MapOptions) -> Outcome<((usize, Counters), Phases)> {
        let ((casters, mut map), build) = timed(|| {
            let casters = Casters::of(self.triangles);
            (casters, SampleMap::build(self.light, self.domain, casters, &self.origins, options))
        });
        let mut found = vec![false; self.origins.len()];
        let (counters, run) = timed(|| map.occluded(casters, &self.origins, Opaque, &mut found));
        self.judge(&found)?;
        Ok(((map.node_count(), counters), Phases { build, run }))
    }

    /// The ray tracer, its tree built anew.
    fn rays(&self) -> Outcome<Phases> {
        let build = || {
            let bvh = Bvh::build(&self.positions, &self.indices, |_| true, BuildQuality::Fast);
            bvh.inspect(|bvh| Simd::new(bvh).occluded_batch(&[Ray::default()], Opaque, &mut [false]))
        };
        let (bvh, build) = timed(build);
        let bvh = bvh?;
        let (found, run) = timed(|| trace(&bvh, &self.rays));
        self.judge(&found)?;
        Ok(Phases { build, run })
    }

    /// Refuses answers that are not the ray tracer's.
    fn judge(&self, found: &[bool]) -> Outcome<()> {
        match found.iter().zip(&self.truth).filter(|(a, b)| a != b).count() {
            0 => Ok(()),
            n => Err(format!("{n} answers of {} differ from the ray tracer's", found.len()).into()),
        }
    }
}

fn trace(bvh: &Bvh, rays: &[Ray]) -> Vec<bool> {
    let tracer = Simd::new(bvh);
    let mut out = vec![false; rays.len()];
    out.par_chunks_mut(BATCH)
        .zip(rays.par_chunks(BATCH))
        .for_each(|(out, rays)| tracer.occluded_batch(rays, Opaque, out));
    out
}
