//! The measured muscles and rubbers that the crate carries are those of the repository.

use std::path::Path;

#[test]
fn the_crates_copies_are_the_files_in_data() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (measured, repository) = (here.join("data/measured"), here.join("../../data"));
    for (name, original) in [
        ("tondu2012", "tondu2012/static_force_20deg"),
        ("tondu2012-30", "tondu2012/static_force_30deg"),
        ("dmsp-20-300", "martens_boblan_2017/DMSP-20-300"),
        ("dmsp-10-250", "martens_boblan_2017/DMSP-10-250"),
        ("dmsp-10-hose", "festo_dmsp10/force_map"),
        ("rubber-treloar", "treloar/tension"),
        ("rubber-kawabata", "rubber_biaxial/kawabata_1981"),
        ("rubber-jones", "rubber_biaxial/jones_1975"),
        ("rubber-james", "rubber_biaxial/james_1975"),
        ("rubber-kawamura", "rubber_biaxial/kawamura_2001"),
        ("rubber-meunier", "rubber_biaxial/meunier_2008"),
        ("rubber-dragon-skin-30", "silicones/dragon_skin_30"),
        ("rubber-ecoflex-00-50", "silicones/ecoflex_00-50"),
        ("rubber-mold-star-20t", "silicones/mold_star_20t"),
        ("rubber-rtv615", "silicones/rtv615"),
        ("rubber-soloplast-150318", "silicones/soloplast_150318"),
        ("rubber-hnbr50", "hnbr50/stepwise_relaxation"),
    ] {
        let original = std::fs::read_to_string(repository.join(format!("{original}.csv"))).unwrap();
        let copy = std::fs::read_to_string(measured.join(name).join("points.csv")).unwrap();
        assert!(copy == original, "{name}");
    }
}
