//! What serde says of a value, in the words of a file's messages.

/// What is expected, for messages.
pub const PLAIN: &str = "a number without unit, such as 0.8";
pub const TEXT: &str = "a text in quotes";
pub const LIST: &str = "a list";
/// The only tuples in files.
pub const PAIR: &str = "a pair";
/// The words of an enum come behind it.
pub const ONE_OF: &str = "one of ";

/// What serde expects, by its first letters, and what it is called in files.
const EXPECTED: [(&str, &str); 9] = [
    ("a string", TEXT),
    ("f64", PLAIN),
    ("u", "a whole number, zero or above"),
    ("a boolean", "true or false, without quotes"),
    ("a sequence", LIST),
    ("a tuple", PAIR),
    ("string or map", ONE_OF),
    ("struct ", "a table of keys"),
    ("a map", "a table of keys"),
];

const GIVEN: [(&str, &str); 7] = [
    ("string", "a text"),
    ("integer", "a number"),
    ("floating", "a number"),
    ("boolean", "true or false"),
    ("sequence", LIST),
    ("length", LIST),
    ("map", "a table"),
];

/// `invalid type: integer 3, expected a string` → `is a number; expected a text in quotes`; other
/// sentences as they are.
pub fn in_our_words(said: &str) -> String {
    let wrong = said.strip_prefix("invalid ");
    let Some((given, expected)) = wrong.and_then(|wrong| wrong.rsplit_once(", expected ")) else {
        return said.to_owned();
    };
    let given = given.split_once(": ").map_or(given, |(_, given)| given);
    let ours = |words: &[(&str, &'static str)], theirs: &str| {
        words
            .iter()
            .find(|(begin, _)| theirs.starts_with(begin))
            .map(|(_, ours)| *ours)
    };
    let given = ours(&GIVEN, given).unwrap_or("something else");
    let expected = ours(&EXPECTED, expected).unwrap_or(expected);
    format!("is {given}; expected {expected}")
}
