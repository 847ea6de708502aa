//! The tables of tubes.

use mckibben_design::tubes::{can_be_cast, catalogue, find, of_size, read};

#[test]
fn the_catalogue_is_read_and_every_tube_can_be_bought_or_cast() {
    let all = catalogue().unwrap();
    assert!(all.len() > 100, "{}", all.len());
    for tube in all.iter().filter(|t| t.is_cast) {
        assert!(
            can_be_cast(tube.inner_diameter_mm, tube.wall_mm),
            "{}",
            tube.name
        );
    }
    assert!(find(all, "cast-24x30").unwrap().is_cast);
    // 1/4 x 3/8 in: a wall of 1/16 in.
    let latex = find(all, "latex-1/4x3/8in").unwrap();
    assert!(
        (latex.wall_mm - 25.4 / 16.0).abs() < 1e-9 && latex.rubber.name.as_deref() == Some("latex")
    );
    let mut names: Vec<&str> = all.iter().map(|t| t.name.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), all.len());
    let error = find(all, "latex-1/4x3/8").unwrap_err().to_string();
    assert!(error.contains("did you mean latex-1/4x3/8in"), "{error}");
    // Of a rubber that the list leaves out.
    assert_eq!(
        find(all, "cast-8x12-rtv615")
            .unwrap()
            .rubber
            .name
            .as_deref(),
        Some("rtv615")
    );
    assert!(find(all, "cast-8x12-no-such-rubber").is_err());
    let sized = of_size("8x12mm", "latex").unwrap().unwrap();
    assert_eq!((sized.name.as_str(), sized.wall_mm), ("8x12-latex", 2.0));
    assert!(of_size("latex-5x8", "latex").is_none() && of_size("12x8", "latex").unwrap().is_err());
}

#[test]
fn a_table_of_ones_own_is_read_and_slips_are_named() {
    let text =
        "[[tube]]\nname = \"mine\"\ninner = 8\nouter = 12.0\nrubber = \"shore:35A:natural\"\n";
    let own = read(text).unwrap();
    assert_eq!(
        (own[0].wall_mm, own[0].source.as_str()),
        (2.0, "not stated")
    );
    let message = |text: &str| read(text).unwrap_err().to_string();
    assert!(message("tube = ").contains("the table of tubes"));
    assert!(message("").contains("[[tube]] or [[cast]]"));
    let misspelt = message(&text.replace("[[tube]]", "[[tubes]]"));
    assert!(misspelt.contains("did you mean tube"), "{misspelt}");
    assert!(
        message(&text.replace("inner", "iner"))
            .contains("line 3, column 1: tube.1.iner: unknown key (did you mean inner?)")
    );
    assert!(message(&text.replace("12.0", "7")).contains("mine: the inner diameter"));
    assert!(
        message(&text.replace("outer = 12.0", ""))
            .contains("line 1, column 1: tube.1: tube.1.outer is missing; expected a length")
    );
    assert!(
        message(&text.replace("8", "-8"))
            .contains("inner = -8: is -8\u{a0}mm; it must be above zero")
    );
    assert!(message(&text.replace("shore:35A:natural", "latx")).contains("did you mean latex"));
}
