//! Whatever is in a flag: an answer or an error, never a panic.

use crate::common::{assert_finite, command, ran, root};
use proptest::prelude::*;

/// Texts that nearly are quantities, ranges or lists, and some that are nothing.
fn words() -> impl Strategy<Value = String> {
    prop_oneof![
        4 => r"[+-]?[0-9]{0,4}[.]?[0-9]{0,3}(e[+-]?[0-9]{1,3})?(mm|cm|m|in|bar|MPa|mPa|kPa|psi|deg|rad|N|kN|%|N/mm)?",
        2 => r"-?[0-9.]{0,5}[.][.]-?[0-9.]{0,5}(:-?[0-9.e-]{0,5})?(mm|bar|%|N)?",
        1 => r"[-0-9.,:@=%e]{0,12}",
        1 => r"(nan|NaN|inf|-inf|infinity|1e308|-1e308|1e-308|5e-324|0|-0|0x10|1_000|１２|∞|½|°|µm|)",
        1 => "\\PC{0,12}",
    ]
}

const FLAGS: [(&str, &str); 17] = [
    ("force -e 0.1", "--pressure"),
    ("force -p 0.2", "--contraction"),
    ("force -p 0.2", "--outer-diameter"),
    ("force -p 0.2", "--wall"),
    ("force -p 0.2", "--length"),
    ("force -p 0.2", "--angle"),
    ("force -p 0.2 --model thick-wall", "--stiffness"),
    (
        "force -p 0.2 --model thick-wall",
        "--with=terminals.seating",
    ),
    ("force -p 0.2 --model thick-wall", "--with=terminals.slip"),
    ("force -p 0.2 --model thick-wall", "--with=terminals.grip"),
    (
        "force -p 0.2 --model tondu-lopez",
        "--with=terminals.end_factor",
    ),
    (
        "force -p 0.2 --model belforte --with braid.turns=1.5",
        "--with=braid.strand_length",
    ),
    ("pressure -e 0.1 --extrapolate", "--force"),
    ("contraction -p 0.2 --two-sided --extrapolate", "--force"),
    ("curve isometric -e 0,0.1", "--pressure"),
    ("curve isobaric -p 0.1,0.2 --extrapolate", "--contraction"),
    ("design -p 0.25 -D 30,40 -s 2", "--at"),
];

proptest! {
    #![proptest_config(ProptestConfig { cases: mckibben_core::random::rounds(60) as u32, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn flags_never_panic((line, flag) in prop::sample::select(&FLAGS[..]), word in words()) {
        let value = format!("{flag}={word}");
        let mut command = command(&root());
        let result = ran(command.args(line.split(' ')).args([&value, "--format", "json"]).output().unwrap());
        prop_assert!((0..=3).contains(&result.code), "{line} {value}: {result:?}");
        if result.code == 0 {
            assert_finite(result.text());
            result.json();
        } else if result.out.is_empty() {
            prop_assert!(result.error()["kind"].is_string());
        }
    }
}
