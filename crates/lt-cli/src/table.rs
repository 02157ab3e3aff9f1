//! Text tables with aligned columns.

/// Which edge a column's cells share.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// Left edge, for words.
    Left,
    /// Right edge, for numbers.
    Right,
}

/// Lays out rows under their headings, two spaces apart, no trailing spaces. A heading may span several lines.
///
/// Cells missing at the end of a row stay empty; width counts characters.
pub fn render(columns: &[(&str, Align)], rows: &[Vec<String>]) -> String {
    let heading_lines = columns.iter().map(|c| c.0.lines().count()).max().unwrap_or(0);
    let heading_line = |line: usize| -> Vec<String> {
        let cell = |title: &str| {
            let blank = heading_lines - title.lines().count();
            line.checked_sub(blank).and_then(|l| title.lines().nth(l)).unwrap_or_default().to_owned()
        };
        columns.iter().map(|c| cell(c.0)).collect()
    };
    let headings: Vec<Vec<String>> = (0..heading_lines).map(heading_line).collect();
    let cell = |row: &[String], i: usize| row.get(i).cloned().unwrap_or_default();
    let width_of =
        |i: usize| headings.iter().chain(rows).map(|r| cell(r, i).chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns.len()).map(width_of).collect();
    let mut text = String::new();
    let mut add_line = |row: &[String]| {
        let cells = columns.iter().zip(&widths).enumerate().map(|(i, ((_, align), &width))| match align {
            Align::Left => format!("{:<width$}", cell(row, i)),
            Align::Right => format!("{:>width$}", cell(row, i)),
        });
        text.push_str(cells.collect::<Vec<_>>().join("  ").trim_end());
        text.push('\n');
    };
    headings.iter().for_each(|row| add_line(row));
    add_line(&widths.iter().map(|&w| "─".repeat(w)).collect::<Vec<_>>());
    rows.iter().for_each(|row| add_line(row));
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(row: &[&str]) -> Vec<String> {
        row.iter().map(|c| (*c).to_owned()).collect()
    }

    #[test]
    fn columns_align_by_characters() {
        let columns = [("name", Align::Left), ("false-lit\nppm", Align::Right), ("×", Align::Right)];
        let text = render(&columns, &[cells(&["ray", "0", "1.00×"]), cells(&["ltt-evsm", "12 345", "–"])]);
        let expected = "          false-lit\n\
                        name            ppm      ×\n\
                        ────────  ─────────  ─────\n\
                        ray               0  1.00×\n\
                        ltt-evsm     12 345      –\n";
        assert_eq!(text, expected);
    }

    #[test]
    fn short_rows_and_no_rows_are_fine() {
        assert_eq!(render(&[("a", Align::Left), ("b", Align::Right)], &[cells(&["x"])]), "a  b\n─  ─\nx\n");
        assert_eq!(render(&[], &[]), "\n");
    }
}
