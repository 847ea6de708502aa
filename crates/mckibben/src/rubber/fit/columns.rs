//! Which column of a tension test means what.
//!
//! A heading is compared in lower case, with everything that is no letter or digit as an underscore and `%` as
//! `percent`: `Nominal stress [MPa]`, `nominal_stress_MPa` and `nominal-stress-mpa` are the same.

/// What the numbers of the column of stretches are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StretchKind {
    /// L/L0.
    Stretch,
    /// ΔL/L0 times this.
    Strain(f64),
    /// ln(L/L0).
    TrueStrain,
    /// ΔL in mm; needs the gauge length.
    ExtensionMm,
}

/// What the numbers of the column of stresses are; the factor turns them into MPa or N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StressKind {
    /// Force over the area at rest.
    Nominal(f64),
    /// Force over the area now.
    True(f64),
    /// Force; needs the area at rest.
    Force(f64),
}

/// Headings of stretches, the best liked first.
const STRETCH: [(&str, StretchKind); 22] = [
    ("stretch", StretchKind::Stretch),
    ("stretch_ratio", StretchKind::Stretch),
    ("extension_ratio", StretchKind::Stretch),
    ("lambda", StretchKind::Stretch),
    ("λ", StretchKind::Stretch),
    ("engineering_strain", StretchKind::Strain(1.0)),
    ("nominal_strain", StretchKind::Strain(1.0)),
    ("eng_strain", StretchKind::Strain(1.0)),
    ("strain", StretchKind::Strain(1.0)),
    ("strain_mm_mm", StretchKind::Strain(1.0)),
    ("strain_percent", StretchKind::Strain(0.01)),
    ("engineering_strain_percent", StretchKind::Strain(0.01)),
    ("nominal_strain_percent", StretchKind::Strain(0.01)),
    ("eng_strain_percent", StretchKind::Strain(0.01)),
    ("tensile_strain_percent", StretchKind::Strain(0.01)),
    ("elongation_percent", StretchKind::Strain(0.01)),
    ("true_strain", StretchKind::TrueStrain),
    ("log_strain", StretchKind::TrueStrain),
    ("logarithmic_strain", StretchKind::TrueStrain),
    ("extension_mm", StretchKind::ExtensionMm),
    ("displacement_mm", StretchKind::ExtensionMm),
    ("elongation_mm", StretchKind::ExtensionMm),
];

const NOMINAL: [&str; 7] =
    ["nominal_stress", "engineering_stress", "eng_stress", "pk1_stress", "tensile_stress", "stress", "p"];
const TRUE: [&str; 2] = ["true_stress", "cauchy_stress"];
const FORCE: [&str; 3] = ["force", "load", "f"];
const MODE: [&str; 4] = ["mode", "test", "loading", "deformation"];

/// Units of stress, in MPa.
const UNITS: [(&str, f64); 8] = [
    ("mpa", 1.0),
    ("n_mm2", 1.0),
    ("n_mm", 1.0),
    ("kpa", 1e-3),
    ("pa", 1e-6),
    ("bar", 0.1),
    ("psi", 0.006_894_757_293_168_361),
    ("gpa", 1e3),
];

/// A heading in plain form.
pub(super) fn plain(heading: &str) -> String {
    let mut out = String::new();
    for c in heading.trim_start_matches('\u{feff}').trim().to_lowercase().replace('%', " percent ").chars() {
        match c {
            '²' => out.push('2'),
            c if c.is_alphanumeric() => out.push(c),
            _ if out.ends_with('_') || out.is_empty() => {}
            _ => out.push('_'),
        }
    }
    out.trim_end_matches('_').to_owned()
}

/// The column of stretches.
pub(super) fn stretch(headings: &[String]) -> Option<(usize, StretchKind)> {
    STRETCH.iter().find_map(|&(name, kind)| Some((headings.iter().position(|h| h == name)?, kind)))
}

/// The column of stresses or forces; `Err` with its position where it has no unit.
pub(super) fn stress(headings: &[String]) -> Option<Result<(usize, StressKind), usize>> {
    let with_unit = |names: &[&str], units: &[(&str, f64)]| {
        names.iter().find_map(|name| {
            units.iter().find_map(|(unit, factor)| {
                Some((headings.iter().position(|h| *h == format!("{name}_{unit}"))?, *factor))
            })
        })
    };
    let found = with_unit(&NOMINAL, &UNITS)
        .map(|(i, k)| (i, StressKind::Nominal(k)))
        .or_else(|| with_unit(&TRUE, &UNITS).map(|(i, k)| (i, StressKind::True(k))))
        .or_else(|| with_unit(&FORCE, &[("n", 1.0), ("kn", 1e3)]).map(|(i, k)| (i, StressKind::Force(k))));
    let bare = || {
        let names = NOMINAL.iter().chain(&TRUE).chain(&FORCE);
        names.into_iter().find_map(|name| headings.iter().position(|h| h == name))
    };
    found.map(Ok).or_else(|| bare().map(Err))
}

/// The column of modes.
pub(super) fn mode(headings: &[String]) -> Option<usize> {
    MODE.iter().find_map(|name| headings.iter().position(|h| h == name))
}
