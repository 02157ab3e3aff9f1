//! The paper's pictures: the zoom of its Figure 3, and the tree over the samples in the light's plane, its Figure 4.

use image::{Rgb, RgbImage};
use lt_irregular::{Bounds, Casters, LightPoint, Options as MapOptions, Rect, SampleMap, View};
use lt_math::glam::{UVec2, Vec3};
use lt_render::{BackendKind, PackedScene, Session, Setup, Technique, Trees};
use lt_scene::{Camera, Scene, Source};

use super::Outcome;
use super::rays::RayList;

/// The scene of both.
const SCENE: &str = "random:1000";
/// The paper's picture.
const SIZE: UVec2 = UVec2::new(1024, 768);
/// One picture of the zoom.
const FRAME: UVec2 = UVec2::new(320, 240);
/// Fields of view of the zoom as shares of the first one's.
const ZOOM: [f32; 3] = [1.0, 0.125, 0.0156_25];
/// Rows of the zoom. The map is fitted to what each view sees.
const TECHNIQUES: [&str; 2] = ["sm:map=1024", "alias-free"];
/// Samples in a leaf of the tree at most, and which part of the samples is drawn, as in the paper.
const LEAF: usize = 256;
const DRAWN: usize = 64;
/// Side of one of the tree's pictures.
const PLANE: u32 = 480;
/// Gap between pictures.
const GAP: u32 = 8;

const PAPER: Rgb<u8> = Rgb([255; 3]);
const INK: Rgb<u8> = Rgb([20, 40, 90]);
const LINE: Rgb<u8> = Rgb([60, 110, 190]);

fn scene() -> Outcome<Scene> {
    Ok(Source::open(SCENE, 1)?.pose(0.0)?)
}

/// Shadows of a map of 1024² texels above, alias-free shadows below, ever closer from left to right.
///
/// # Errors
/// Whatever the session reports, or a view without a shadow's edge.
pub fn zoom() -> Outcome<RgbImage> {
    let scene = scene()?;
    let whole = Setup::for_scene(&scene, FRAME.x, FRAME.y);
    let mut session = Session::new(&scene, whole.clone(), BackendKind::Cpu)?;
    let target = edge(&mut session)?;
    let at = |i: u32| i * (FRAME.x + GAP);
    let mut sheet = RgbImage::from_pixel(at(ZOOM.len() as u32) - GAP, 2 * FRAME.y + GAP, PAPER);
    for (row, id) in TECHNIQUES.iter().enumerate() {
        for (column, share) in ZOOM.iter().enumerate() {
            let fov_y_rad = 2.0 * ((whole.camera.fov_y_rad * 0.5).tan() * share).atan();
            session.look(&Camera { target, fov_y_rad, ..whole.camera.clone() })?;
            let frame = session.render(&id.parse::<Technique>()?)?;
            let corner = (at(column as u32), row as u32 * (FRAME.y + GAP));
            for (i, [r, g, b, _]) in session.shade(&frame)?.into_iter().enumerate() {
                let (x, y) = (i as u32 % FRAME.x, i as u32 / FRAME.x);
                sheet.put_pixel(corner.0 + x, corner.1 + y, Rgb([r, g, b]));
            }
        }
    }
    Ok(sheet)
}

/// The point on a shadow's edge that is seen nearest to the middle of the picture, on one surface.
fn edge(session: &mut Session) -> Outcome<Vec3> {
    let frame = session.render(&Technique::RAY)?;
    let (width, samples) = (FRAME.x as usize, session.samples());
    let is_edge = |&i: &usize| {
        let (a, b) = (&samples[i], &samples[i + 1]);
        i % width + 1 < width
            && a.is_valid()
            && a.normal == b.normal
            && frame.visibility[i] != frame.visibility[i + 1]
            && frame.doubt[i]
            && frame.doubt[i + 1]
    };
    let from_middle = |i: &usize| {
        let (x, y) = ((i % width).abs_diff(width / 2), (i / width).abs_diff(FRAME.y as usize / 2));
        x * x + y * y
    };
    let nearest = (0..samples.len() - 1).filter(is_edge).min_by_key(from_middle);
    Ok(nearest.map(|i| samples[i].position).ok_or("no shadow's edge is seen")?)
}

/// The samples in the light's plane, one in 64, and the leaves of the tree over all of them.
///
/// # Errors
/// Whatever the session reports.
pub fn tree() -> Outcome<RgbImage> {
    let scene = scene()?;
    let session = Session::new(&scene, Setup::for_scene(&scene, SIZE.x, SIZE.y), BackendKind::Cpu)?;
    let light = session.job(&Technique::RAY).shadow.light;
    let rays = RayList::of_picture(session.samples(), SIZE, &light).rays;
    let packed = PackedScene::new(&scene)?;
    let Trees::Flat(bvh) = packed.trees() else { return Err("random scenes are baked".into()) };
    let casters = Casters::of_tree(&bvh.nodes()[0], bvh.triangles());
    let origins: Vec<Vec3> = rays.iter().map(|r| r.origin).collect();
    let corners = bvh.triangles().iter().flat_map(|t| [t.v0, t.v1, t.v2]);
    let domain = corners.chain(origins.iter().copied()).fold(Bounds::EMPTY, Bounds::with);
    let options = MapOptions { leaf: LEAF + 1, part_levels: 0, ..MapOptions::default() };
    let map = SampleMap::build(light.place, domain, casters, &origins, options);
    let view = View::of_light(light.place, domain, casters.root).next().ok_or("the light has no view")?;
    let points: Vec<LightPoint> =
        rays.iter().filter(|r| view.takes(r)).step_by(DRAWN).map(|r| view.point(r)).collect();
    let leaves: Vec<Rect> = map.leaves().collect();
    let all = leaves.iter().fold(Rect::EMPTY, |all, leaf| all.union(leaf));
    let scale = (PLANE - 1) as f32 / (all.x1 - all.x0).max(all.y1 - all.y0);
    let pixel = |x: f32, y: f32| (((x - all.x0) * scale) as u32, ((all.y1 - y) * scale) as u32);
    let height = pixel(all.x1, all.y0).1 + 1;
    let mut sheet = RgbImage::from_pixel(2 * PLANE + GAP, height, PAPER);
    for point in points {
        let (x, y) = pixel(point.x, point.y);
        sheet.put_pixel(x.min(PLANE - 1), y.min(height - 1), INK);
    }
    for leaf in leaves {
        let ((left, top), (right, bottom)) = (pixel(leaf.x0, leaf.y1), pixel(leaf.x1, leaf.y0));
        let (right, bottom) = (right.min(PLANE - 1), bottom.min(height - 1));
        for x in left..=right {
            [top, bottom].into_iter().for_each(|y| sheet.put_pixel(PLANE + GAP + x, y, LINE));
        }
        for y in top..=bottom {
            [left, right].into_iter().for_each(|x| sheet.put_pixel(PLANE + GAP + x, y, LINE));
        }
    }
    Ok(sheet)
}
