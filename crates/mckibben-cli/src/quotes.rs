//! A missing quote around a number and its unit.

use crate::Problem;
use mckibben_core::units::{Dimension, parse_values};
use std::path::Path;

/// A quantity whose unit is a separate argument, because a quote is missing: `-p 2 bar`. Only where
/// that argument is no file, so that the command line would be refused anyway, with a stranger
/// reason.
pub fn check_quotes(args: &[String]) -> Result<(), Problem> {
    let bare =
        |text: &str| text.parse::<f64>().is_ok() || parse_values(text, Dimension::Ratio).is_ok();
    for (i, words) in args.windows(3).enumerate() {
        let [flag, number, unit] = words else {
            continue;
        };
        if !flag.starts_with('-') || flag.contains('=') || !bare(number) || Path::new(unit).exists()
        {
            continue;
        }
        // Units may be several words, such as `N s/m`.
        let behind = &args[i + 2..];
        let written = (1..=behind.len().min(4))
            .rev()
            .map(|n| behind[..n].join(" "));
        let known = |unit: &String| Dimension::all().any(|d| d.unit(unit).is_some());
        let Some(unit) = written.into_iter().find(known) else {
            continue;
        };
        let message =
            format!("{flag} {number} {unit}: a quote is missing around the number and its unit");
        let short = if unit.contains(' ') {
            String::new()
        } else {
            format!("{flag} {number}{unit} or ")
        };
        return Err(Problem::usage(
            message,
            format!("write {short}{flag} '{number} {unit}'"),
        ));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::as_text;
    use mckibben_app::Units;

    fn args(line: &str) -> Vec<String> {
        line.split(' ').map(str::to_owned).collect()
    }

    #[test]
    fn a_unit_by_itself_behind_a_number_is_a_missing_quote() {
        let said = |line: &str| as_text(&check_quotes(&args(line)).unwrap_err(), &Units::default());
        let text = said("force -p 2 bar");
        assert!(text.contains("-p 2 bar: a quote is missing"), "{text}");
        assert!(text.contains("write -p 2bar or -p '2 bar'"), "{text}");
        assert!(said("joint x.toml --torque 2 N m").contains("write --torque '2 N m'"));
        assert!(said("curve isobaric -p 0..2.5:0.1 bar -e 0").contains("'0..2.5:0.1 bar'"));
        for line in [
            "force -p 2bar",
            "force -p 2 my.toml",
            "rubber x.csv --terms 2",
            "force --top 5 -p 1",
        ] {
            assert!(check_quotes(&args(line)).is_ok(), "{line}");
        }
    }
}
