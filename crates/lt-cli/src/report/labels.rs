//! Greedy point labelling: each label takes the free place nearest its point.

/// An axis-aligned box in pixels: left, top, right, bottom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    /// Left edge.
    pub left: f64,
    /// Top edge.
    pub top: f64,
    /// Right edge.
    pub right: f64,
    /// Bottom edge.
    pub bottom: f64,
}

impl Rect {
    /// The box around a segment, a little fatter than the line drawn.
    pub fn around(from: (f64, f64), to: (f64, f64)) -> Self {
        const MARGIN: f64 = 3.0;
        Self {
            left: from.0.min(to.0) - MARGIN,
            top: from.1.min(to.1) - MARGIN,
            right: from.0.max(to.0) + MARGIN,
            bottom: from.1.max(to.1) + MARGIN,
        }
    }

    fn centered(at: (f64, f64), half_width: f64, half_height: f64) -> Self {
        Self {
            left: at.0 - half_width,
            top: at.1 - half_height,
            right: at.0 + half_width,
            bottom: at.1 + half_height,
        }
    }

    fn overlap(&self, other: &Self) -> f64 {
        let width = self.right.min(other.right) - self.left.max(other.left);
        let height = self.bottom.min(other.bottom) - self.top.max(other.top);
        width.max(0.0) * height.max(0.0)
    }

    fn is_within(&self, outer: &Self) -> bool {
        self.left >= outer.left
            && self.right <= outer.right
            && self.top >= outer.top
            && self.bottom <= outer.bottom
    }
}

/// Half the height of a label, pixels.
const HALF_HEIGHT: f64 = 8.0;
/// Room a point's own mark takes around its centre, pixels.
const MARK_RADIUS: f64 = 10.0;

/// Places a label of each width (pixels) near its point, all within `frame`; returns their boxes in the given order.
///
/// Earlier labels choose first. Labels avoid marks, `lines` and each other while there is room; after that they overlap as
/// little as possible.
pub fn place(points: &[(f64, f64)], widths: &[f64], lines: &[Rect], frame: Rect) -> Vec<Rect> {
    let marks = points.iter().map(|&p| Rect::centered(p, MARK_RADIUS, MARK_RADIUS));
    let taken: Vec<Rect> = marks.chain(lines.iter().copied()).collect();
    let mut placed: Vec<Rect> = Vec::new();
    for (&point, &width) in points.iter().zip(widths) {
        let cost =
            |label: &Rect| -> f64 { taken.iter().chain(&placed).map(|other| label.overlap(other)).sum() };
        let mut best = Rect::centered(point, width / 2.0, HALF_HEIGHT);
        let mut best_cost = f64::INFINITY;
        for label in candidates(point, width).filter(|label| label.is_within(&frame)) {
            let cost = cost(&label);
            if cost < best_cost {
                (best, best_cost) = (label, cost);
            }
            if cost == 0.0 {
                break;
            }
        }
        placed.push(best);
    }
    placed
}

/// Places on a grid around a point that clear its mark, near ones first, the right before the left.
fn candidates(point: (f64, f64), width: f64) -> impl Iterator<Item = Rect> {
    let half_width = width / 2.0;
    let columns = (-20..=20).map(|i| f64::from(i) / 20.0 * (half_width + 150.0)).collect::<Vec<_>>();
    let beside = half_width + MARK_RADIUS + 2.0;
    let offsets = (-22..=22).flat_map(|row| {
        let dy = f64::from(row) * (HALF_HEIGHT + 1.0);
        columns.iter().copied().chain([beside, -beside]).map(move |dx| (dx, dy)).collect::<Vec<_>>()
    });
    let distance = move |(dx, dy): (f64, f64)| {
        let gap = (dx.abs() - half_width).max(0.0).hypot((dy.abs() - HALF_HEIGHT).max(0.0));
        // Of two places equally near, the right one reads better, and the centred of two above.
        gap + if dx < 0.0 { 2.0 } else { 0.0 } + dy.abs() * 0.3 + dx.abs() * 0.01
    };
    let clears_mark = move |&(dx, dy): &(f64, f64)| {
        dx.abs() >= half_width + MARK_RADIUS || dy.abs() >= HALF_HEIGHT + MARK_RADIUS
    };
    let mut offsets: Vec<(f64, f64)> = offsets.filter(clears_mark).collect();
    offsets.sort_by(|&a, &b| distance(a).total_cmp(&distance(b)));
    offsets
        .into_iter()
        .map(move |(dx, dy)| Rect::centered((point.0 + dx, point.1 + dy), half_width, HALF_HEIGHT))
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Rect = Rect { left: 0.0, top: 0.0, right: 900.0, bottom: 500.0 };

    fn overlaps(labels: &[Rect]) -> usize {
        let pairs = (0..labels.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
        pairs.filter(|&(i, j)| labels[i].overlap(&labels[j]) > 0.0).count()
    }

    #[test]
    fn a_lone_label_stands_to_the_right() {
        let label = place(&[(100.0, 100.0)], &[60.0], &[], FRAME)[0];
        assert!(label.left > 100.0 && label.left < 115.0 && (label.top + label.bottom) / 2.0 == 100.0);
    }

    #[test]
    fn labels_keep_off_lines() {
        let line = Rect { left: 100.0, top: 98.0, right: 300.0, bottom: 102.0 };
        let label = place(&[(100.0, 100.0)], &[60.0], &[line], FRAME)[0];
        assert_eq!(label.overlap(&line), 0.0);
    }

    #[test]
    fn a_crowd_does_not_overlap() {
        let points: Vec<(f64, f64)> =
            (0..23).map(|i| (400.0 + f64::from(i % 5), 250.0 + f64::from(i / 5))).collect();
        let labels = place(&points, &[110.0; 23], &[], FRAME);
        assert_eq!(overlaps(&labels), 0);
        assert!(labels.iter().all(|l| l.is_within(&FRAME)));
    }

    #[test]
    fn labels_at_the_edge_stay_inside() {
        let corners = [(0.0, 0.0), (900.0, 0.0), (0.0, 500.0), (900.0, 500.0)];
        assert!(place(&corners, &[120.0; 4], &[], FRAME).iter().all(|l| l.is_within(&FRAME)));
    }

    #[test]
    fn no_room_at_all_still_ends() {
        let tiny = Rect { left: 0.0, top: 0.0, right: 10.0, bottom: 10.0 };
        assert_eq!(place(&[(5.0, 5.0); 3], &[50.0; 3], &[], tiny).len(), 3);
        assert!(place(&[], &[], &[], tiny).is_empty());
    }
}
