//! The residual rays of a hybrid: the pixels nearest to a shadow edge.

use super::rays::RayList;

/// Share of the rays that is kept.
const SHARE: f64 = 0.05;

/// Positions of the 5 % of the rays whose pixels lie nearest to an edge, in the order of the list.
///
/// An edge pixel has one of its four neighbours on the list with another answer. Distances are Euclidean between
/// pixel centres. Of those equally far as the last one taken, every so many-th is taken, evenly over the list. None
/// without any edge.
pub fn nearest_to_edges(list: &RayList, is_blocked: &[bool]) -> Vec<usize> {
    let (width, height) = (list.size.x as usize, list.size.y as usize);
    // 0: not on the list; 1: lit; 2: blocked.
    let mut answers = vec![0u8; width * height];
    let at = |i: usize| list.pixels[i].y as usize * width + list.pixels[i].x as usize;
    for (i, &blocked) in is_blocked.iter().enumerate() {
        answers[at(i)] = 1 + u8::from(blocked);
    }
    let differs = |a: u8, b: u8| a != 0 && b != 0 && a != b;
    let mut squared = vec![u32::MAX; width * height];
    for y in 0..height {
        for x in 0..width {
            let p = y * width + x;
            if x + 1 < width && differs(answers[p], answers[p + 1]) {
                (squared[p], squared[p + 1]) = (0, 0);
            }
            if y + 1 < height && differs(answers[p], answers[p + width]) {
                (squared[p], squared[p + width]) = (0, 0);
            }
        }
    }
    if !squared.contains(&0) {
        return Vec::new();
    }
    distances(&mut squared, width, height);
    let wanted = (list.rays.len() as f64 * SHARE).round() as usize;
    let mut sorted: Vec<u32> = (0..list.rays.len()).map(|i| squared[at(i)]).collect();
    let Some((nearer, limit)) = cut(&mut sorted, wanted) else { return Vec::new() };
    let tied = sorted.iter().filter(|d| **d == limit).count();
    let (mut seen, mut kept) = (0, Vec::with_capacity(wanted));
    for i in 0..list.rays.len() {
        let distance = squared[at(i)];
        let is_chosen_tie = distance == limit && {
            seen += 1;
            // Steps exactly wanted − nearer times over the tied ones.
            seen * (wanted - nearer) / tied != (seen - 1) * (wanted - nearer) / tied
        };
        if distance < limit || is_chosen_tie {
            kept.push(i);
        }
    }
    kept
}

/// How many of the `wanted` smallest are below the largest of them, and that largest one.
fn cut(values: &mut [u32], wanted: usize) -> Option<(usize, u32)> {
    let last = wanted.checked_sub(1)?;
    values.sort_unstable();
    let limit = *values.get(last)?;
    Some((values.partition_point(|v| *v < limit), limit))
}

/// Squared distance of every pixel to the nearest one that holds 0, of a picture in which all others hold `u32::MAX`:
/// columns first, then rows by the lower envelope of parabolas (Felzenszwalb & Huttenlocher 2012).
fn distances(squared: &mut [u32], width: usize, height: usize) {
    // Beyond any distance in a picture of 16384², and far from overflow.
    const FAR: i64 = 1 << 30;
    for x in 0..width {
        let mut run = |ys: &mut dyn Iterator<Item = usize>| {
            let mut distance = FAR;
            for y in ys {
                let p = &mut squared[y * width + x];
                distance = if *p == 0 { 0 } else { distance + 1 };
                let square = if distance >= FAR { u32::MAX } else { (distance * distance) as u32 };
                *p = (*p).min(square);
            }
        };
        run(&mut (0..height));
        run(&mut (0..height).rev());
    }
    let mut row = vec![0i64; width];
    let mut hull: Vec<(usize, f64)> = Vec::with_capacity(width);
    for y in 0..height {
        let line = &mut squared[y * width..(y + 1) * width];
        for (to, from) in row.iter_mut().zip(line.iter()) {
            *to = i64::from(*from);
        }
        hull.clear();
        for x in (0..width).filter(|&x| row[x] < i64::from(u32::MAX)) {
            let start = loop {
                let Some(&(last, begin)) = hull.last() else { break f64::NEG_INFINITY };
                let lift = (row[x] + (x * x) as i64) - (row[last] + (last * last) as i64);
                let meet = lift as f64 / (2 * (x - last)) as f64;
                if meet > begin {
                    break meet;
                }
                hull.pop();
            };
            hull.push((x, start));
        }
        let mut at = 0;
        for (x, out) in line.iter_mut().enumerate() {
            while at + 1 < hull.len() && hull[at + 1].1 <= x as f64 {
                at += 1;
            }
            if let Some(&(centre, _)) = hull.get(at) {
                let along = x as i64 - centre as i64;
                *out = (along * along + row[centre]) as u32;
            }
        }
    }
}
