//! Which casters move: a kept map is drawn of those that stand still, and those that move are drawn into it every frame.

use std::ops::Range;

use lt_bvh::Triangle;
use lt_scene::Scene;

use super::{DrawRange, meshes::Group};

/// Draws of what stands still, and draws of what moves. Together they hold every triangle of `draws` once.
///
/// A tree mixes what is baked into it, so that a draw may fall into many pieces; its triangles' order is spatial, which
/// keeps them few.
pub fn split(
    draws: &[DrawRange],
    triangles: &[Triangle],
    moving_vertices: &[Range<u32>],
) -> (Vec<DrawRange>, Vec<DrawRange>) {
    let (mut still, mut moving) = (Vec::new(), Vec::new());
    let is_moving = |triangle: &Triangle| {
        let vertex = triangle.indices()[0];
        let after = moving_vertices.partition_point(|r| r.end <= vertex);
        moving_vertices.get(after).is_some_and(|r| r.contains(&vertex))
    };
    for draw in draws {
        let first = draw.first_triangle as usize;
        let mut at = draw.first_triangle;
        let all = &triangles[first..first + draw.triangles as usize];
        for run in all.chunk_by(|a, b| is_moving(a) == is_moving(b)) {
            let piece = DrawRange { first_triangle: at, triangles: run.len() as u32, ..*draw };
            if is_moving(&run[0]) {
                moving.push(piece)
            } else {
                still.push(piece)
            }
            at += run.len() as u32;
        }
    }
    (still, moving)
}

/// The vertices of what moves, ascending, in the order in which groups are packed.
pub fn moving_vertices(scene: &Scene, groups: &[Group]) -> Vec<Range<u32>> {
    let mut ranges: Vec<Range<u32>> = Vec::new();
    let mut at = 0;
    for group in groups {
        let members = if group.is_instanced { &group.members[..1] } else { &group.members[..] };
        for &member in members {
            let instance = &scene.instances[member];
            let end = at + scene.meshes[instance.mesh as usize].positions.len() as u32;
            match ranges.last_mut().filter(|r| r.end == at) {
                Some(last) if instance.is_dynamic => last.end = end,
                _ if instance.is_dynamic => ranges.push(at..end),
                _ => {}
            }
            at = end;
        }
    }
    ranges
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle(vertex: u32) -> Triangle {
        Triangle { i0: vertex, i1: vertex + 1, i2: vertex + 2, ..Triangle::default() }
    }

    #[test]
    fn every_triangle_is_drawn_once_by_one_side() {
        let triangles: Vec<Triangle> = [0, 3, 9, 6, 20, 12, 15].map(triangle).to_vec();
        let draw = |first_triangle, triangles| DrawRange {
            first_triangle,
            triangles,
            instance: first_triangle,
            has_holes: true,
        };
        let (still, moving) = split(&[draw(0, 4), draw(4, 3)], &triangles, &[6..12, 15..18]);
        let ranges = |draws: &[DrawRange]| -> Vec<_> {
            draws.iter().map(|d| (d.first_triangle, d.triangles, d.instance)).collect()
        };
        assert_eq!(ranges(&still), [(0, 2, 0), (4, 2, 4)]);
        assert_eq!(ranges(&moving), [(2, 2, 0), (6, 1, 4)]);
        let (still, moving) = split(&[draw(0, 7)], &triangles, &[]);
        assert_eq!((ranges(&still), ranges(&moving)), (vec![(0, 7, 0)], vec![]));
    }
}
