//! Which modifiers of a technique's id exclude one another, and what to write instead.
//!
//! An id means the same however its modifiers are ordered, so two that claim different things about one matter have no meaning:
//! whichever came last would win without a word.

/// Modifiers that name a resolver: one technique has one.
const RESOLVERS: [&str; 4] = ["light", "dac", "space", "alias-free"];

/// Two keys that exclude each other, with the remedy.
const PAIRS: [(&str, &str, &str); 7] = [
    ("cascades", "splits", "`splits` says how many levels there are: leave `cascades` out"),
    ("lambda", "splits", "`splits` says where levels meet: leave `lambda` out"),
    (
        "no-rr",
        "published",
        "`published` removes rays by eq. 8: for eq. 6 alone write `expand=published:no-rr`",
    ),
    ("expand", "published", "`published` has its own rule: leave `expand` out"),
    ("no-rr", "no-er", "together they leave no mask: use the ltt- technique"),
    ("no-er", "expand", "without expansion there is no rule of it: leave one of them out"),
    ("depth-test", "no-depth-test", "leave one of them out"),
];

/// A refusal that names the two modifiers that contradict or repeat each other, and the remedy; `None` where none do.
///
/// `words` are modifiers without their colons, `depth-test` or `eps=0.02`, in any order.
pub fn find(words: &[&str]) -> Option<String> {
    let pairs = words.iter().enumerate().flat_map(|(i, a)| words[i + 1..].iter().map(move |b| (*a, *b)));
    pairs.into_iter().find_map(|(a, b)| Some(format!("`{a}` and `{b}`: {}", remedy(key(a), key(b))?)))
}

/// What stands before a modifier's `=`.
pub fn key(word: &str) -> &str {
    word.split_once('=').map_or(word, |w| w.0)
}

fn remedy(a: &str, b: &str) -> Option<&'static str> {
    if a == b {
        return Some("one modifier, given twice: leave one of them out");
    }
    if RESOLVERS.contains(&a) && RESOLVERS.contains(&b) {
        return Some("both say what answers in place of rays: leave one of them out");
    }
    PAIRS.iter().find(|p| (p.0, p.1) == (a, b) || (p.0, p.1) == (b, a)).map(|p| p.2)
}
