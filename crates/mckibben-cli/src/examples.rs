//! Examples in the help.

/// Examples of a command, each without the name of the program; a long one goes on below.
pub fn examples(list: &[&str]) -> String {
    let one = |example: &&str| {
        let mut out = String::new();
        let mut width = 0;
        // A flag stays beside its value.
        for (i, part) in format!("mckibben {example}").split(" -").enumerate() {
            let space = match i {
                0 => "\n  ",
                _ if width + part.len() > 74 => " \\\n    -",
                _ => " -",
            };
            width = if space.contains('\n') { 5 } else { width + 2 } + part.len();
            out.extend([space, part]);
        }
        out
    };
    let all: String = list.iter().map(one).collect();
    let heading = if list.len() > 1 {
        "Examples:"
    } else {
        "Example:"
    };
    heading.to_owned() + &all
}
