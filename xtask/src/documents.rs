//! Pages under docs/results: what a measuring program wrote goes between two marks, the rest is written by hand.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};

use crate::files;

/// Replaces what lies between the marks of `page` by what the file `part` holds.
///
/// # Errors
/// A file that cannot be read or written, or a page without the marks.
pub fn renew(page: &Path, part: &Path, marks: [&str; 2]) -> Result<()> {
    let renewed = splice(&read(page)?, &read(part)?, marks)
        .with_context(|| format!("{} cannot be renewed", page.display()))?;
    files::replace(page, renewed.as_bytes()).map(drop)
}

/// Copies a file, whole or not at all.
///
/// # Errors
/// A file that cannot be read or written.
pub fn copy(from: &Path, to: &Path) -> Result<()> {
    let content = fs::read(from).with_context(|| format!("cannot read {}", from.display()))?;
    files::replace(to, &content).map(drop)
}

fn read(path: &Path) -> Result<String> {
    fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))
}

fn splice(page: &str, part: &str, [begin, end]: [&str; 2]) -> Result<String> {
    let (before, rest) = page.split_once(begin).with_context(|| format!("it lacks the line {begin}"))?;
    let (_, after) = rest.split_once(end).with_context(|| format!("it lacks the line {end}"))?;
    ensure!(!part.contains(begin) && !part.contains(end), "the new part contains a mark");
    Ok(format!("{before}{begin}\n\n{}\n\n{end}{after}", part.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    const MARKS: [&str; 2] = ["<!-- begin -->", "<!-- end -->"];

    #[test]
    fn only_what_is_between_the_marks_changes() {
        let page = format!("top\n{}\nold\n{}\nbottom\n", MARKS[0], MARKS[1]);
        let renewed = splice(&page, "new\n", MARKS).unwrap();
        assert_eq!(renewed, format!("top\n{}\n\nnew\n\n{}\nbottom\n", MARKS[0], MARKS[1]));
        assert_eq!(splice(&renewed, "new", MARKS).unwrap(), renewed);
        assert!(splice("no marks", "new", MARKS).is_err());
        assert!(splice(MARKS[0], "new", MARKS).is_err());
        assert!(splice(&page, MARKS[1], MARKS).is_err());
    }
}
