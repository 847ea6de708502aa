use super::*;
use crate::{
    model::{ForceModel, FormulaModel, ModelKind, Workspace},
    muscle::Muscle,
};
use std::sync::Arc;

fn summary() -> ErrorSummary {
    ErrorSummary {
        points: 460,
        rms: 0.01,
        p95: 0.02,
        max: 0.03,
        max_n: 12.5,
        max_12: 0.1,
    }
}

fn formula(body: Body) -> Formula {
    Formula {
        name: "mine".into(),
        body,
        made_for: Made::from_muscle(&Muscle::prototype()),
        range: FormulaRange {
            outer_diameter_mm: (30.0, 50.0),
            wall_mm: (1.0, 5.0),
            pressure_mpa: (0.05, 0.25),
            contraction: (0.0, 0.2),
        },
        errors: FormulaErrors {
            against: "axisymmetric finite elements".into(),
            fit: summary(),
            regions: vec![RegionErrors {
                quantity: "wall_mm".into(),
                value: 1.0,
                errors: summary(),
            }],
            held_out: Some(HeldOut {
                outer_diameters_mm: vec![35.0],
                errors: ErrorSummary {
                    p95: 0.025,
                    ..summary()
                },
            }),
        },
        provenance: Provenance {
            method: "global".into(),
            points: 500,
            data_hash: "0123456789abcdef".into(),
            table: None,
            plan_hash: Some("ab".into()),
            seed: Some(7),
            ..Provenance::default()
        },
    }
}

fn global() -> Formula {
    let scales = Scales {
        wall_ratio: 0.1,
        pressure_mpa: 0.25,
        contraction: 0.2,
        outer_diameter_mm: 40.0,
    };
    let term = |a, b, c, d, value| Term {
        powers: [a, b, c, d],
        value,
    };
    let terms = vec![
        term(0, 1, 0, 0, 1.1),
        term(0, 1, 1, 0, -0.1 - 0.2),
        term(1, 0, 2, 0, -1.0 / 3.0),
        term(2, 2, 1, 1, 0.07),
        term(1, 0, 0, 0, -0.01),
    ];
    formula(Body::Global(GlobalTerms { scales, terms }))
}

#[test]
fn files_round_trip_to_the_bit() {
    for f in [
        formula(Body::Paper(Box::new(*Coefficients::published()))),
        global(),
    ] {
        assert_eq!(
            Document::parse(&f.to_json()).unwrap(),
            Document::Section(f.into())
        );
    }
}

/// Of every flipped bit either the file is refused, or it says the same: a digest of all that it
/// says is in it. Without the digest it is a file that somebody edited.
#[test]
fn a_flipped_bit_of_a_file_is_refused_or_harmless() {
    let formula = global();
    let text = formula.to_json();
    let mut random = crate::random::Random(19);
    let tries = std::env::var("FLIPS").map_or(200, |n| n.parse().unwrap());
    let mut refused = 0;
    for _ in 0..tries {
        let mut bytes = text.clone().into_bytes();
        let at = random.between(0.0, 8.0 * bytes.len() as f64) as usize;
        bytes[at / 8] ^= 1 << (at % 8);
        match String::from_utf8(bytes)
            .ok()
            .map(|text| Document::parse(&text))
        {
            Some(Ok(read)) => assert_eq!(read, Document::Section(formula.clone().into())),
            _ => refused += 1,
        }
    }
    assert!(refused * 20 > tries * 19, "{refused} of {tries}");
    let edited = text.replace("1.1", "1.2");
    let error = Document::parse(&edited).unwrap_err().to_string();
    assert!(error.contains("`digest`"), "{error}");
    let lines: Vec<&str> = edited.lines().filter(|l| !l.contains("digest")).collect();
    let without = lines.join("\n").replace("},\n}", "}\n}");
    assert!(Document::parse(&without).is_ok());
    // However it is laid out.
    let value: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert!(Document::parse(&value.to_string()).is_ok());
}

#[test]
fn the_published_numbers_as_a_file_answer_like_the_model_paper() {
    let published = formula(Body::Paper(Box::new(*Coefficients::published()))).to_json();
    let Document::Section(f) = Document::parse(&published).unwrap() else {
        panic!("{published}")
    };
    let f: Arc<Formula> = f.into();
    assert_eq!(
        serde_json::to_value(&*f).unwrap()["terms"]
            .as_array()
            .unwrap()
            .len(),
        48
    );
    for (d, s) in [(30.0, 5.0), (41.3, 2.2), (50.0, 1.0)] {
        let m = Muscle::prototype().with_section(d, s).unwrap();
        let ours = FormulaModel::between_ends(&f, &m);
        let paper = FormulaModel::paper(&m);
        for (p, e) in [(0.05, 0.0), (0.13, 0.11), (0.25, 0.2)] {
            assert_eq!(
                ours.response(&mut Workspace::new(), p, e).unwrap(),
                paper.response(&mut Workspace::new(), p, e).unwrap()
            );
        }
    }
}

#[test]
fn derivatives_are_those_of_finite_differences() {
    let m = Muscle::prototype().with_section(43.0, 2.5).unwrap();
    for f in [
        formula(Body::Paper(Box::new(*Coefficients::published()))),
        global(),
    ] {
        let model = FormulaModel::between_ends(&f, &m);
        for (p, e) in [(0.05, 0.0), (0.0, 0.0), (0.11, 0.07), (0.25, 0.2)] {
            let h = 1e-5;
            let r = model.response(&mut Workspace::new(), p, e).unwrap();
            let difference = |dp: f64, de: f64| {
                let at = |k: f64| {
                    model
                        .force_n(&mut Workspace::new(), p + k * dp * h, e + k * de * h)
                        .unwrap()
                };
                (at(1.0) - at(-1.0)) / (2.0 * h)
            };
            let slope = -r.stiffness_n_per_mm.unwrap() * m.length_mm();
            assert!(
                (slope - difference(0.0, 1.0)).abs() < 1e-4 * slope.abs().max(1.0),
                "{p} {e}"
            );
            let slope = r.force_per_pressure_mm2.unwrap();
            assert!(
                (slope - difference(1.0, 0.0)).abs() < 1e-4 * slope.abs().max(1.0),
                "{p} {e}"
            );
            // Pull and volume have one potential: ∂V/∂ε = L0 ∂F/∂P.
            let volume = |e: f64| {
                let at = model.response(&mut Workspace::new(), p, e).unwrap();
                at.volume_mm3.unwrap()
            };
            let by_volume = (volume(e + h) - volume(e - h)) / (2.0 * h * m.length_mm());
            assert!((by_volume - slope).abs() < 1e-4 * slope, "{p} {e}");
        }
    }
}

#[test]
fn what_it_was_not_made_for_is_refused() {
    let f = Arc::new(global());
    let proto = Muscle::prototype();
    let check = |m: &Muscle, p, e| {
        FormulaModel::between_ends(&f, m)
            .info()
            .range
            .check("mine", p, e)
    };
    assert!(check(&proto, 0.25, 0.2).is_ok());
    let wide = proto.with_section(60.0, 0.5).unwrap();
    let text = check(&wide, 0.3, 0.25).unwrap_err().to_string();
    for part in [
        "outer_diameter 60",
        "wall_thickness 0.5",
        "pressure 0.3",
        "contraction 0.25",
        "mine",
    ] {
        assert!(text.contains(part), "{text}");
    }
    let braid = |b: crate::muscle::Braid| proto.with_braid(b).unwrap();
    let stiff = crate::muscle::BraidStiffness::Inextensible;
    let other = braid(crate::muscle::Braid {
        angle_deg: 25.0,
        stiffness: stiff,
        ..proto.braid().clone()
    });
    let text = check(&other, 0.2, 0.0).unwrap_err().to_string();
    assert!(
        text.contains("braid_angle 25") && text.contains("inextensible"),
        "{text}"
    );
    // The same stiffness said in another way is the same braid.
    let k = proto.family_stiffness_n_per_mm().unwrap();
    assert!(
        check(
            &braid(crate::muscle::Braid {
                stiffness: crate::muscle::BraidStiffness::NewtonPerMm(k),
                ..proto.braid().clone()
            }),
            0.2,
            0.0
        )
        .is_ok()
    );
    let mut tube = proto.tube().clone();
    tube.rubber.law = crate::rubber::Law::NeoHookean(crate::rubber::NeoHookean { mu_mpa: 0.2 });
    tube.rubber.name = None;
    let text = check(&proto.with_tube(tube).unwrap(), 0.2, 0.0)
        .unwrap_err()
        .to_string();
    assert!(
        text.contains("neo-hookean") && text.contains("c10_mpa 0.112"),
        "{text}"
    );
    assert!(
        FormulaModel::between_ends(&f, &proto)
            .force_n(&mut Workspace::new(), f64::NAN, 0.1)
            .is_err()
    );
    let accuracy = FormulaModel::between_ends(&f, &proto).info().accuracy;
    assert_eq!(accuracy.share_of_blocked, Some(0.025));
    assert_ne!(
        ModelKind::Paper.build(&proto).unwrap().info().accuracy,
        accuracy
    );
}

#[test]
#[allow(clippy::too_many_lines)] // a table of cases
fn wrong_files_are_named_with_their_key() {
    let paper = formula(Body::Paper(Box::new(*Coefficients::published()))).to_json();
    let global = global().to_json();
    let cases = [
        (
            "truncated",
            global[..global.len() / 2].to_owned(),
            "is not valid JSON",
        ),
        ("NaN", global.replace("1.1", "NaN"), "is not valid JSON"),
        (
            "infinite",
            global.replace("1.1", "1e999"),
            "is not valid JSON",
        ),
        (
            "null",
            global.replace("1.1", "null"),
            "`terms[0].value`: invalid type: null, expected a number at line",
        ),
        (
            "a text",
            global.replace("1.1", "\"1.1\""),
            "`terms[0].value`",
        ),
        (
            "kind",
            global.replace("\"global\",", "\"cubic\","),
            "`kind`: unknown variant `cubic`, expected one of `paper`",
        ),
        (
            "format",
            global.replace("formula 1", "formula 9"),
            "`format`",
        ),
        (
            "no kind",
            global.replacen("\"kind\"", "\"kinds\"", 1),
            "the key `kind` is missing",
        ),
        (
            "no range",
            global.replace("\"wall_mm\": [", "\"wall\": ["),
            "`range.wall_mm` is missing",
        ),
        (
            "a power",
            global.replacen("\"pressure\": 1", "\"presure\": 1", 1),
            "`terms[0].powers.presure`: unknown field `presure`, expected one of `wall_ratio`",
        ),
        (
            "half a power",
            global.replacen("\"pressure\": 1", "\"pressure\": 1.5", 1),
            "`terms[0].powers.pressure`",
        ),
        (
            "scale",
            global.replace("\"wall_ratio\": 0.1", "\"wall_ratio\": 0"),
            "`scales.wall_ratio`",
        ),
        (
            "errors",
            global.replace("\"max_n\"", "\"max\""),
            "max_n` is missing",
        ),
        (
            "a term",
            paper.replace("\"A11\"", "\"D11\""),
            "`terms[0].name` is `D11`; expected one of A11",
        ),
        (
            "a term too many",
            paper.replace("\"A11\"", "\"A12\""),
            "A12 is given twice",
        ),
        (
            "a term too few",
            paper.replace("\"A63\"", "\"C10\""),
            "`terms: A63` is missing",
        ),
        (
            "a list",
            "[1]".to_owned(),
            "`the file`: invalid type: sequence, expected an object",
        ),
    ];
    for (name, text, part) in cases {
        let error = Document::parse(&text).expect_err(name).to_string();
        assert!(error.contains(part), "{name}: {error}");
    }
    let path = Path::new("no/such/formula.json");
    let error = read_text(path).unwrap_err().in_file(path);
    assert_eq!(error.file.as_deref(), Some(path));
}

#[test]
fn a_file_that_was_edited_answers_and_other_keys_are_passed_over() {
    let mut file: serde_json::Value = serde_json::to_value(global()).unwrap();
    file["terms"][0]["value"] = 1.2.into();
    file["note"] = "of mine".into();
    let Ok(Document::Section(read)) = Document::parse(&file.to_string()) else {
        panic!("{file}")
    };
    let Body::Global(terms) = read.body else {
        panic!("{file}")
    };
    assert_eq!(terms.terms[0].value, 1.2);
}

#[test]
fn latex_is_balanced_and_has_every_term() {
    for (f, count) in [
        (
            formula(Body::Paper(Box::new(*Coefficients::published()))),
            48,
        ),
        (global(), 5),
    ] {
        let text = f.to_latex();
        for (open, close) in [('{', '}'), ('(', ')')] {
            assert_eq!(
                text.matches(open).count(),
                text.matches(close).count(),
                "{text}"
            );
        }
        let numbers = text.split(|c: char| !(c.is_ascii_digit() || c == '.'));
        assert_eq!(numbers.filter(|n| n.len() == 7).count(), count, "{text}");
        is_a_display(&text);
    }
    is_a_display(&UniversalFormula::large().unwrap().to_latex());
}

/// A display of amsmath has an environment of its own, its last line no line break, and a line of
/// text holds no more than a few terms.
fn is_a_display(text: &str) {
    let inner = text.strip_prefix("\\begin{align*}\n");
    let inner = inner.and_then(|t| t.strip_suffix("\n\\end{align*}\n"));
    let inner = inner.unwrap_or_else(|| panic!("{text}"));
    let breaks = inner.lines().filter(|l| l.ends_with("\\\\")).count();
    assert_eq!(breaks + 1, inner.lines().count(), "{text}");
    assert!(inner.lines().all(|l| l.matches('&').count() == 1), "{text}");
    assert!(inner.lines().all(|l| l.len() <= 200), "{text}");
}
