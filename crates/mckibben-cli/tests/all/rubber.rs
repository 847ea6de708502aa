//! `rubber`: what it prints and writes, and what it refuses.

use crate::common::{assert_finite, folder, json, mckibben, number, root, run_in};
use serde_json::Value;

const TRELOAR: &str = "rubber data/treloar/tension.csv";
const SILICONE: &str = "rubber data/silicones/dragon_skin_30.csv --up-to 200%";

fn law<'a>(found: &'a Value, name: &str, constrained: bool) -> &'a Value {
    let laws = found["laws"].as_array().unwrap();
    laws.iter().find(|l| l["name"] == name && l["constrained"] == constrained).unwrap()
}

/// X. Li, Y. Wei (2015): C10 0.1789, C20 −0.001219, C30 3.678e-5 MPa, one unit of the last digit allowed.
#[test]
fn yeoh_of_treloars_rubber_is_the_published_one() {
    let found = json(&format!("{TRELOAR} --law yeoh --relative"));
    let parameters = found["parameters"].as_array().unwrap();
    let published = [("c10", 0.1789, 1e-4), ("c20", -0.001219, 1e-6), ("c30", 3.678e-5, 1e-8)];
    for (p, (name, value, unit)) in parameters.iter().zip(published) {
        assert_eq!((&p["name"], &p["unit"], &p["identifiable"]), (&name.into(), &"MPa".into(), &true.into()));
        assert!((number(p, "value") - value).abs() < unit, "{p}");
        assert!(number(p, "standard_error") > 0.0);
    }
    assert_eq!(found["recommended"], "yeoh");
    assert_eq!(number(&found, "fitted_to_stretch"), 7.6362);
    assert_eq!((number(&found, "points"), number(&found, "left_out")), (54.0, 3.0), "{found}");
    assert_eq!(found["laws"][0]["modes"].as_array().unwrap().len(), 3);
}

#[test]
fn a_negative_c01_is_warned_of_and_the_held_law_stands_beside_with_its_r_squared() {
    let found = json(SILICONE);
    let (free, held) = (law(&found, "mooney-rivlin", false), law(&found, "mooney-rivlin", true));
    assert!(number(&free["parameters"][1], "value") < 0.0 && free["stable"] == false);
    assert!(number(&held["parameters"][1], "value").abs() < 1e-12 && held["stable"] == true);
    assert_eq!(number(held, "free_r_squared"), number(free, "r_squared"));
    let warnings = found["warnings"].to_string();
    assert!(warnings.contains("negative C01") && warnings.contains("uniaxial tests alone"), "{warnings}");
    assert_eq!(found["recommended"], "yeoh", "uniaxial tests: a law of I1");
    let only = json(&format!("{SILICONE} --law mooney-rivlin --stable"));
    assert_eq!(only["laws"].as_array().unwrap().len(), 1);
    assert_eq!(&only["laws"][0]["parameters"], &held["parameters"]);
    let text = mckibben(&format!("{SILICONE} --law mooney-rivlin --stable")).ok();
    assert!(text.text().contains("with C01 not below 0: R²"), "{}", text.text());
}

/// The written muscle carries the law to the last bit, and `force` answers with it.
#[test]
fn the_written_muscle_is_read_by_force() {
    let dir = folder();
    let data = root().join("data/silicones/dragon_skin_30.csv");
    let data = data.to_str().unwrap();
    let fit = ["rubber", data, "--up-to", "3", "-o", "m.toml", "--name", "my silicone", "--plot", "f.svg"];
    run_in(dir.path(), &fit).ok();
    assert!(std::fs::read_to_string(dir.path().join("f.svg")).unwrap().contains("no points"));
    let text = std::fs::read_to_string(dir.path().join("m.toml")).unwrap();
    assert!(
        text.contains("name = \"my silicone\"") && text.contains("fitted_to_stretch = 2.9545 "),
        "{text}"
    );
    let shown = run_in(dir.path(), &["check", "m.toml", "--format", "json"]).ok().json();
    let found = json(&format!("{SILICONE} --law yeoh"));
    for p in found["parameters"].as_array().unwrap() {
        assert_eq!(number(&shown["constants_mpa"], p["name"].as_str().unwrap()), number(p, "value"));
    }
    let force =
        run_in(dir.path(), &["force", "--muscle", "m.toml", "-p", "2bar", "-e", "10%", "--format", "json"]);
    assert!(number(&force.ok().json(), "force_n") > 0.0);
}

#[test]
fn everything_that_is_printed_is_a_number() {
    for line in [
        TRELOAR,
        SILICONE,
        "rubber data/treloar/tension.csv --balance --relative --up-to 3 --weights equibiaxial=2",
        "rubber data/silicones/ecoflex_00-50.csv --mode equibiaxial --relative",
        "rubber data/silicones/rtv615.csv --stable --hoop-stretch 2",
    ] {
        for format in ["text", "json", "csv"] {
            assert_finite(mckibben(&format!("{line} --format {format}")).ok().text());
        }
    }
    let csv = mckibben(&format!("{TRELOAR} --law gent --format csv")).ok();
    assert!(
        csv.text()
            .starts_with("law,constrained,recommended,constant,value,unit,standard_error,identifiable,")
    );
}

/// Words, exit code, kind, part of message or hint.
const REFUSED: &[(&str, i32, &str, &str)] = &[
    ("--law yeo", 2, "rubber", "known: neo-hookean"),
    ("--law yeoh --terms 2 --law-x", 2, "usage", "--law-x"),
    ("--up-to 0.5", 2, "fit", "the largest stretch is 0.5"),
    ("--up-to 3mm", 2, "quantity", "--up-to"),
    ("--up-to 0.1%", 2, "fit", "a modulus of 0 MPa"),
    ("--law ogden-3 --up-to 1.2", 2, "fit", "a law with fewer constants"),
    ("--weights planar", 2, "usage", "has no ="),
    ("--weights bent=1", 2, "usage", "expected one of"),
    ("--weights planar=1,planar=2", 2, "usage", "is given twice"),
    ("--weights planar=-1", 2, "fit", "a weight is -1"),
    ("--hoop-stretch 0.9", 2, "fit", "the hoop stretch is 0.9"),
    ("--area 0mm2", 2, "quantity", "must be above zero"),
    ("--muscle nothing.toml", 2, "file", "nothing.toml"),
    ("--plot f.gif", 2, "output", "f.gif"),
];

#[test]
fn wrong_words_are_refused_with_what_to_do() {
    for &(words, code, kind, fragment) in REFUSED {
        let result = mckibben(&format!("{TRELOAR} {words} --format json"));
        assert_eq!(result.code, code, "{words}: {}", result.err);
        if kind == "usage" && words.contains("-x") {
            continue;
        }
        let error = result.error();
        assert_eq!(error["kind"], kind, "{words}: {error}");
        assert!(error.to_string().contains(fragment), "{words}: {error}");
    }
}

/// Content of a file, exit code, kind, part of the message.
const FILES: &[(&[u8], i32, &str, &str)] = &[
    (b"", 2, "data", "no column of stretches"),
    (b"stretch,stress_mpa\n", 2, "data", "no points"),
    (b"stretch,stress_mpa\n1,0\n1.5,NaN\n", 2, "data", "line 3, column stress_mpa"),
    (b"stretch,stress_mpa\n1,0\n1.5\n", 2, "data", "as many fields"),
    (b"stretch,stress_mpa\n1,0\n0,0.1\n", 2, "data", "name the column engineering_strain"),
    (b"strain,stress_mpa\n0,0\n150,0.1\n", 2, "data", "name the column strain_percent"),
    (b"strain,stress\n0,0\n", 2, "data", "stress does not state its unit"),
    (b"stretch,stress_mpa\n1,0\n1.5,-0.3\n2,-0.5\n", 2, "fit", "columns and their signs"),
    (b"stretch,stress_mpa\n1,0\n1.5,0.3\n", 2, "fit", "too few"),
    (b"\xff\xfe\x00\x01", 2, "data", "no column"),
];

#[test]
fn files_that_are_no_tests_are_refused_with_line_and_column() {
    let dir = folder();
    for &(content, code, kind, fragment) in FILES {
        std::fs::write(dir.path().join("t.csv"), content).unwrap();
        let result = run_in(dir.path(), &["rubber", "t.csv", "--format", "json", "-o", "m.toml"]);
        let shown = String::from_utf8_lossy(content);
        assert_eq!(result.code, code, "{shown}: {}", result.err);
        let error = result.error();
        assert_eq!(error["kind"], kind, "{shown}: {error}");
        assert!(error.to_string().contains(fragment), "{shown}: {error}");
        assert!(!dir.path().join("m.toml").exists());
    }
    let missing = run_in(dir.path(), &["rubber", "no.csv", "--format", "json"]);
    assert_eq!((missing.code, &missing.error()["kind"]), (2, &"file".into()));
    let folder = run_in(dir.path(), &["rubber", ".", "--format", "json"]);
    assert_eq!(folder.code, 2, "{}", folder.err);
}

/// A test machine's file goes on after the specimen broke.
#[test]
fn points_after_a_rupture_are_left_out() {
    let dir = folder();
    let mut text = String::from("strain_percent,stress_kpa\n");
    for i in 0..=20 {
        let l = 1.0 + 0.1 * f64::from(i);
        text.push_str(&format!("{},{}\n", 100.0 * (l - 1.0), 300.0 * (l - l.powi(-2))));
    }
    text.push_str("205,100\n206,2\n210,0\n");
    std::fs::write(dir.path().join("t.csv"), text).unwrap();
    let words = ["rubber", "t.csv", "--law", "neo-hookean", "--format", "json"];
    let found = run_in(dir.path(), &words).ok().json();
    assert_eq!((number(&found, "points"), number(&found, "left_out")), (21.0, 3.0));
    assert!((number(&found["parameters"][0], "value") - 0.3).abs() < 1e-9, "{found}");
    assert!(found["warnings"].to_string().contains("the specimen failed; 3 points"));
}

/// Softens ever more: the free Yeoh law is unstable, its stable neighbour is what goes into the muscle.
#[test]
fn a_law_that_is_not_stable_is_not_written_but_its_neighbour_is() {
    let dir = folder();
    let mut text = String::from("stretch,stress_mpa\n");
    for i in 0..20 {
        let l = 1.0 + 0.05 * f64::from(i);
        text.push_str(&format!("{l},{}\n", 0.3 * (l - 1.0) - 0.05 * (l - 1.0f64).powi(2)));
    }
    std::fs::write(dir.path().join("t.csv"), text).unwrap();
    let words = ["rubber", "t.csv", "--law", "yeoh", "--format", "json", "-o", "m.toml"];
    let found = run_in(dir.path(), &words).ok().json();
    assert_eq!(law(&found, "yeoh", false)["stable"], false);
    let held = law(&found, "yeoh", true);
    assert_eq!((&held["stable"], &held["parameters"]), (&true.into(), &found["parameters"]));
    let shown = run_in(dir.path(), &["check", "m.toml", "--format", "json"]).ok().json();
    assert_eq!(number(&shown["constants_mpa"], "c20"), number(&held["parameters"][1], "value"));
}

/// What docs/rubber.md prints of Yeoh's law and of the extended tube, fitted to Treloar's uniaxial test: a regression.
#[test]
fn modes_that_are_held_out_say_how_far_a_law_is_off() {
    let found = json(&format!("{TRELOAR} --up-to 3 --fit-mode uniaxial"));
    assert_eq!((number(&found, "points"), number(&found, "held_out")), (9.0, 19.0));
    for (name, off, stiffer) in [("yeoh", 0.1126, -0.1002), ("extended-tube", 0.0430, 0.0132)] {
        let held = law(&found, name, false)["held_out"].as_array().unwrap();
        let modes: Vec<Option<&str>> = held.iter().map(|e| e["mode"].as_str()).collect();
        assert_eq!(modes, [Some("planar"), Some("equibiaxial"), None]);
        assert!((number(&held[2], "relative") - off).abs() < 2e-4, "{held:?}");
        assert!((number(&held[2], "stiffer") - stiffer).abs() < 2e-4, "{held:?}");
    }
    let text = mckibben(&format!("{TRELOAR} --up-to 3 --fit-mode uniaxial")).ok();
    assert!(text.text().contains("Held out: rms of the differences"), "{}", text.text());
    let bent = mckibben(&format!("{TRELOAR} --fit-mode bent --format json"));
    assert!(bent.code == 2 && bent.error().to_string().contains("possible values: uniaxial"));
}

/// General biaxial points of all sets, and their figure.
#[test]
fn sheets_are_fitted_with_all_other_modes() {
    let dir = folder();
    for name in ["kawabata_1981", "jones_1975", "james_1975", "kawamura_2001", "meunier_2008"] {
        let data = root().join(format!("data/rubber_biaxial/{name}.csv"));
        let words = [
            "rubber",
            "fit",
            data.to_str().unwrap(),
            "--up-to",
            "3",
            "--format",
            "json",
            "--plot",
            "f.svg",
            "--overwrite",
        ];
        let found = run_in(dir.path(), &words).ok().json();
        assert!(number(law(&found, "extended-tube", false), "r_squared") > 0.989, "{name}");
        assert!(
            number(law(&found, "extended-tube", false), "aicc")
                < number(law(&found, "gent", false), "aicc") + 3.0
        );
    }
}

/// S. Lee's test of nitrile rubber: shares below one, moduli at once and after long in their ratio.
#[test]
fn relaxation_says_the_law_at_once_and_after_a_long_time() {
    let found = json("rubber data/hnbr50/stepwise_relaxation.csv --law yeoh --relaxation 3");
    let relaxation = &found["relaxation"];
    let shares: f64 = relaxation["branches"].as_array().unwrap().iter().map(|b| number(b, "share")).sum();
    assert!(shares > 0.0 && shares < 1.0, "{relaxation}");
    let ratio = number(&relaxation["long_time"], "c10_mpa") / number(&relaxation["instantaneous"], "c10_mpa");
    assert!((ratio - (1.0 - shares)).abs() < 1e-9, "{relaxation}");
    assert!(number(relaxation, "rms_mpa") < 0.2 * number(relaxation, "elastic_rms_mpa"), "{relaxation}");
    let dir = folder();
    let data = root().join("data/hnbr50/stepwise_relaxation.csv");
    let words = ["rubber", data.to_str().unwrap(), "--law", "yeoh", "--relaxation", "3", "-o", "m.toml"];
    run_in(dir.path(), &words).ok();
    let written =
        mckibben::muscle::file::read_muscle(dir.path().join("m.toml")).unwrap().tube().rubber.clone();
    let kept = written.prony.unwrap().branches;
    for (kept, branch) in kept.iter().zip(relaxation["branches"].as_array().unwrap()) {
        assert_eq!(
            (kept.share, kept.time_constant_s),
            (number(branch, "share"), number(branch, "time_constant_s"))
        );
    }
    let mckibben::rubber::Law::Yeoh(law) = written.law else { panic!("no Yeoh") };
    assert_eq!((kept.len(), law.c10_mpa), (3, number(&relaxation["instantaneous"], "c10_mpa")));
    let text = mckibben("rubber data/hnbr50/stepwise_relaxation.csv --law yeoh --relaxation 1").ok();
    assert!(text.text().contains("after long"), "{}", text.text());
    let without = mckibben(&format!("{TRELOAR} --relaxation 2 --format json"));
    assert!(
        without.code == 2 && without.error().to_string().contains("no column of times"),
        "{}",
        without.err
    );
}

/// Neo-Hookean strip, W0 = (μ/2)(λ² + 2/λ − 3), stress μ (λ − λ⁻²) times Ogden and Roxburgh's η of the largest energy so far.
#[test]
fn softening_is_found_from_a_test_with_its_first_loading() {
    use mckibben::rubber::over_time::erf;
    let (mu, r, m, beta) = (0.4, 1.5, 0.04, 0.1);
    let mut text = String::from("time_s,stretch,nominal_stress_mpa\n");
    let (mut time, mut largest) = (0.0, 0.0_f64);
    for (from, to) in [(1.0, 1.7), (1.7, 1.0), (1.0, 2.2), (2.2, 1.0)] {
        for i in 0..25 {
            let l: f64 = from + (to - from) * f64::from(i) / 25.0;
            let energy = 0.5 * mu * (l * l + 2.0 / l - 3.0);
            largest = largest.max(energy);
            let eta =
                if energy < largest { 1.0 - erf((largest - energy) / (m + beta * largest)) / r } else { 1.0 };
            text.push_str(&format!("{time},{l},{}\n", eta * mu * (l - l.powi(-2))));
            time += 1.0;
        }
    }
    let dir = folder();
    std::fs::write(dir.path().join("t.csv"), text).unwrap();
    let words = ["rubber", "t.csv", "--law", "neo-hookean", "--softening", "--format", "json"];
    let found = run_in(dir.path(), &words).ok().json();
    let softening = &found["softening"];
    for (name, value) in [("r", r), ("m_mpa", m), ("beta", beta)] {
        assert!((number(softening, name) / value - 1.0).abs() < 0.01, "{softening}");
    }
    assert!((number(&softening["first_loading"], "mu_mpa") - mu).abs() < 1e-9, "{softening}");
    let shown = run_in(dir.path(), &words[..6]).ok();
    assert!(shown.text().contains("Softening of neo-hookean"), "{}", shown.text());
    let written = ["rubber", "t.csv", "--law", "neo-hookean", "--softening", "-o", "m.toml"];
    run_in(dir.path(), &written).ok();
    let rubber =
        mckibben::muscle::file::read_muscle(dir.path().join("m.toml")).unwrap().tube().rubber.clone();
    let kept = rubber.softening.unwrap();
    for (kept, name) in [(kept.r, "r"), (kept.m_mpa, "m_mpa"), (kept.beta, "beta")] {
        assert_eq!(kept, number(softening, name));
    }
    let mckibben::rubber::Law::NeoHookean(law) = rubber.law else { panic!("{rubber:?}") };
    assert_eq!(law.mu_mpa, number(&softening["first_loading"], "mu_mpa"));
}
