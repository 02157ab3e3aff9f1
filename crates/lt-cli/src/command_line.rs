//! The command that is running, as it can be typed again.

/// This process's arguments, quoted for a shell, starting with `lt`.
pub fn current() -> String {
    let words = std::env::args_os().skip(1).map(|word| quoted(&word.to_string_lossy()));
    std::iter::once("lt".to_owned()).chain(words).collect::<Vec<_>>().join(" ")
}

/// A word in single quotes if a POSIX shell would read it otherwise.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_=.,:/+@%".contains(c);
    match !word.is_empty() && word.chars().all(is_plain) {
        true => word.to_owned(),
        false => format!("'{}'", word.replace('\'', r"'\''")),
    }
}

#[cfg(test)]
mod tests {
    use super::quoted;

    #[test]
    fn words_survive_a_shell() {
        assert_eq!(quoted("ltt-evsm:eps=0.02,ray"), "ltt-evsm:eps=0.02,ray");
        assert_eq!(quoted("my scene.glb"), "'my scene.glb'");
        assert_eq!(quoted("it's"), r"'it'\''s'");
        assert_eq!(quoted(""), "''");
    }
}
