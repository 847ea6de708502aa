//! Cases and their rows: each of our values must be within a tolerance of its reference.
//!
//! Where `MCKIBBEN_VERIFICATION` names a folder, each case writes its rows into a file there:
//! `cargo xtask book` makes the list of `docs/verified.md` from them.

use std::{
    env,
    fmt::{Display, Write},
    fs,
    path::Path,
};

/// The rows of a case, with the source of those that come next.
pub struct Rows {
    pub source: &'static str,
    list: String,
    wrong: Vec<String>,
}

impl Rows {
    /// A row with the largest error that passes: relative, or absolute where the reference is zero.
    /// Without a reference or a value it does not pass.
    pub fn add(
        &mut self,
        name: impl Display,
        reference: impl Into<Option<f64>>,
        ours: impl Into<Option<f64>>,
        tolerance: f64,
    ) {
        let reference = reference.into().unwrap_or(f64::NAN);
        let ours = ours.into().unwrap_or(f64::NAN);
        let scale = if reference == 0.0 {
            1.0
        } else {
            reference.abs()
        };
        let error = (ours - reference).abs() / scale;
        let [value, of] = [reference, ours].map(|x| digits(x, 9));
        let [off, allowed] = [error, tolerance].map(|x| digits(x, 2));
        let row = format!("{value:>15} {of:>15} {off:>8} {allowed:>8}  {name}");
        writeln!(self.list, "{}\t{row}", self.source).unwrap();
        let holds = error <= tolerance;
        self.wrong.extend(Some(row).filter(|_| !holds));
    }
}

/// A number rounded to so many digits.
fn digits(x: f64, digits: usize) -> String {
    let rounded: f64 = format!("{x:.*e}", digits - 1).parse().unwrap();
    if rounded == 0.0 || (1e-4..1e9).contains(&rounded.abs()) {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

/// Asserts the rows of a case.
pub fn check(case: &str, source: &'static str, add_rows: fn(&mut Rows)) {
    let mut rows = Rows {
        source,
        list: String::new(),
        wrong: vec![],
    };
    add_rows(&mut rows);
    let Rows { list, wrong, .. } = rows;
    assert!(
        !list.is_empty() && wrong.is_empty(),
        "reference, ours, error, allowed: {wrong:#?}"
    );
    if let Some(folder) = env::var_os("MCKIBBEN_VERIFICATION") {
        fs::write(Path::new(&folder).join(case), list).unwrap();
    }
}

/// A test for each case: its name, the source of its reference, and what adds its rows.
macro_rules! cases {
    ($($name:ident: $source:expr => $add_rows:expr;)*) => {
        $(
            #[test]
            fn $name() {
                crate::verification::rows::check(stringify!($name), $source, $add_rows);
            }
        )*
    };
}
pub(crate) use cases;
