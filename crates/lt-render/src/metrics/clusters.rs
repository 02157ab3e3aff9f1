//! The largest connected blob of marked pixels, by flood fill with an explicit stack.

/// Pixels in the largest 8-connected cluster of `true` in a picture of `[width, height]` pixels, row by row.
///
/// 0 if nothing is marked. Pixels past the end of `is_marked` are unmarked. Time and memory are linear in the pixels.
pub fn largest_cluster(size: [u32; 2], is_marked: &[bool]) -> u32 {
    let [width, height] = size.map(|s| s as usize);
    let mut is_open: Vec<bool> = is_marked.iter().copied().take(width * height).collect();
    is_open.resize(width * height, false);
    let mut largest = 0;
    let mut stack = Vec::new();
    for seed in 0..is_open.len() {
        if !std::mem::replace(&mut is_open[seed], false) {
            continue;
        }
        let mut count = 0;
        stack.push(seed);
        while let Some(at) = stack.pop() {
            count += 1;
            let (x, y) = (at % width, at / width);
            for ny in y.saturating_sub(1)..(y + 2).min(height) {
                for nx in x.saturating_sub(1)..(x + 2).min(width) {
                    if std::mem::replace(&mut is_open[ny * width + nx], false) {
                        stack.push(ny * width + nx);
                    }
                }
            }
        }
        largest = largest.max(count);
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;

    fn largest(rows: &[&str]) -> u32 {
        let marked: Vec<bool> = rows.iter().flat_map(|r| r.bytes().map(|b| b == b'#')).collect();
        largest_cluster([rows[0].len() as u32, rows.len() as u32], &marked)
    }

    #[test]
    fn corners_connect() {
        assert_eq!(largest(&["#..", ".#.", "..#"]), 3);
        assert_eq!(largest(&["..#", ".#.", "#.."]), 3);
    }

    #[test]
    fn rows_do_not_wrap_around() {
        assert_eq!(largest(&["..#", "#..", "..."]), 1);
        assert_eq!(largest(&["...#", "....", "#..."]), 1);
    }

    #[test]
    fn the_larger_cluster_wins_wherever_it_lies() {
        assert_eq!(largest(&["##...", ".....", "..###"]), 3);
        assert_eq!(largest(&["###..", ".....", "...##"]), 3);
    }

    #[test]
    fn branches_of_one_cluster_are_counted_once() {
        assert_eq!(largest(&["#.#", "#.#", "###"]), 7);
    }

    #[test]
    fn nothing_and_everything() {
        assert_eq!(largest_cluster([0, 0], &[]), 0);
        assert_eq!(largest_cluster([4, 3], &[]), 0, "missing pixels are unmarked");
        assert_eq!(largest_cluster([2, 2], &[true; 9]), 4, "surplus pixels are ignored");
        assert_eq!(
            largest_cluster([700, 700], &vec![true; 490_000]),
            490_000,
            "deep fills need no call stack"
        );
    }
}
