//! The measured muscles that the crate carries are those of the repository.

use mckibben_fem::validation::case::built_in;
use std::path::Path;

#[test]
fn the_crates_copies_are_the_files_in_data() {
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    for (name, original) in [
        ("tondu2012", "tondu2012/static_force_20deg"),
        ("dmsp-20-300", "martens_boblan_2017/DMSP-20-300"),
        ("dmsp-10-250", "martens_boblan_2017/DMSP-10-250"),
        ("dmsp-10-hose", "festo_dmsp10/force_map"),
    ] {
        let original = std::fs::read_to_string(repository.join(format!("{original}.csv"))).unwrap();
        assert!(built_in().iter().any(|f| f.name == name && f.points == original), "{name}");
    }
}
