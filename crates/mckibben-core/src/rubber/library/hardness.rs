//! Rubbers by one number of a data sheet: Shore A hardness, or the nominal stress at 100 %.
//!
//! ```text
//! shore:40A            cast silicone, 10 A to 40 A:  E = 0.1025 exp(0.0552 S) MPa      scatter 1.20
//! shore:35A:natural    unfilled natural rubber:      E of Gent 1958                    within about 1.5
//! shore:50A:filled     filled NBR and the like:      0.6 E of Gent 1958                one compound
//! s100:0.6MPa          stress at 100 %:              μ = s100/1.75
//! ```
//!
//! E Young's modulus and μ = E/3 shear modulus of a neo-Hookean rubber, S Shore A; E of Gent 1958
//! \[gent1958\] = 0.0981 (56 + 7.62336 S)/(0.137505 (254 − 2.54 S)) MPa, for 20 A to 80 A. The
//! first relation is a fit to nine casting silicones with measured curves (`data/silicones`), 0 to
//! 50 % strain; formulas for other rubbers give 1.4 to 3 times as much for them. Hardness itself is
//! ± 5 A, a factor of 1.32 in E; both together are the factor within which the stiffness is known,
//! and the ± of a pull carries it. Data sheets of six casting silicones state stresses at 100 %
//! that are 1.06 to 3.7 times those measured.

use super::LibraryError;
use crate::{
    rubber::{Law, NeoHookean, Rubber},
    units::{Dimension, parse_quantity},
};

/// Factor of the relation for cast silicones, of those for other rubbers, and of ± 5 A.
const SILICONE: f64 = 1.20;
const OTHERS: f64 = 1.5;
const HARDNESS: f64 = 1.32;
/// Factor of a stress at 100 %.
const STRESS: f64 = 2.0;

/// A rubber by its data sheet, and the factor within which its stiffness is known; `None` where the
/// name is another one.
pub fn find(name: &str) -> Option<Result<(Rubber, f64), LibraryError>> {
    let lower = name.trim().to_lowercase();
    let wrong = |problem| {
        LibraryError(format!(
            "\"{name:.60}\" is not a rubber by its data sheet: {problem}"
        ))
    };
    let modulus = if let Some(rest) = lower.strip_prefix("shore:") {
        by_hardness(rest).map_err(wrong)
    } else if lower.starts_with("shore") {
        Err(wrong("write shore:30A for a hardness of 30 Shore A"))
    } else {
        by_stress(lower.strip_prefix("s100:")?).map_err(wrong)
    };
    Some(modulus.map(|(mu_mpa, factor)| {
        let law = Law::NeoHookean(NeoHookean { mu_mpa });
        (
            Rubber {
                name: Some(lower.clone()),
                ..Rubber::new(law)
            },
            factor,
        )
    }))
}

fn by_hardness(text: &str) -> Result<(f64, f64), &'static str> {
    let (hardness, family) = text.split_once(':').unwrap_or((text, "silicone"));
    let hardness = hardness.trim().strip_suffix('a').unwrap_or(hardness).trim();
    let s: f64 = hardness
        .parse()
        .map_err(|_| "write a hardness on the scale A, such as shore:40A")?;
    let gent = 0.0981 * (56.0 + 7.62336 * s) / (0.137505 * (254.0 - 2.54 * s));
    let (least, most, young_mpa, relation, outside) = match family.trim() {
        "silicone" => (
            10.0,
            40.0,
            0.1025 * (0.0552 * s).exp(),
            SILICONE,
            "casting silicones were compared from 10 A to 40 A; name a rubber, or state the stress \
             at 100 % (s100:0.6MPa)",
        ),
        "natural" => (
            20.0,
            60.0,
            gent,
            OTHERS,
            "unfilled natural rubber has 20 A to 60 A",
        ),
        "filled" => (
            20.0,
            80.0,
            0.6 * gent,
            OTHERS,
            "filled rubber has 20 A to 80 A here",
        ),
        _ => return Err("the families are silicone, natural and filled, such as shore:50A:filled"),
    };
    if !(least..=most).contains(&s) {
        return Err(outside);
    }
    Ok((young_mpa / 3.0, together(relation, HARDNESS)))
}

fn by_stress(text: &str) -> Result<(f64, f64), &'static str> {
    const EXPECTED: &str =
        "write the nominal stress at 100 % with its unit, such as s100:0.6MPa or s100:90psi";
    let stress = parse_quantity(text, Dimension::Pressure).map_err(|_| EXPECTED)?;
    if !(0.01..=10.0).contains(&stress) {
        return Err("the stress at 100 % of a rubber is from 0.01 to 10 MPa");
    }
    Ok((stress / 1.75, STRESS))
}

/// Two independent factors as one: their logarithms add as squares.
fn together(a: f64, b: f64) -> f64 {
    a.ln().hypot(b.ln()).exp()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rubber::RubberLaw;

    fn mu(name: &str) -> f64 {
        find(name).unwrap().unwrap().0.law.shear_modulus_mpa()
    }

    /// By hand: 0.1025 exp(0.0552·30)/3 = 0.17896; Gent at 35 A 1.39496/3 = 0.46499; 0.6·2.45582/3
    /// at 50 A = 0.49116; 0.7/1.75 = 0.4.
    #[test]
    fn moduli_are_those_of_the_relations_by_hand() {
        for (name, expected) in [
            ("shore:30A", 0.178_96),
            ("Shore:35a:natural", 0.464_99),
            ("shore:50A:filled", 0.491_16),
            ("s100:0.7MPa", 0.4),
        ] {
            assert!(
                (mu(name) / expected - 1.0).abs() < 2e-4,
                "{name} {}",
                mu(name)
            );
        }
        // ln 1.20 = 0.1823, ln 1.32 = 0.2776: exp 0.3321.
        assert!((find("shore:30A").unwrap().unwrap().1 - 1.3939).abs() < 1e-3);
    }

    #[test]
    fn what_was_not_compared_is_refused_and_other_names_are_left_alone() {
        for (name, word) in [
            ("shore:60A", "10 A to 40 A"),
            ("shore:x", "scale A"),
            ("Shore A 30", "write shore:30A"),
            ("shore:30A:wood", "families"),
            ("s100:x", "unit"),
            ("s100:90", "10 MPa"),
        ] {
            let error = find(name).unwrap().unwrap_err().to_string();
            assert!(error.contains(word), "{name}: {error}");
        }
        assert!(find("dragon-skin-30:yeoh").is_none());
    }
}
