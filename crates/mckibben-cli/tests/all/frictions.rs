//! What new users met, each with its command: units, flags, files and texts that did not fit what was typed.

use crate::common::{Ran, folder, mckibben, root, run_in};
use std::path::Path;

/// A muscle of the kind that is bought, with all of its strands stated.
const MUSCLE: &str = r#"
name = "my hose"
[tube]
outer_diameter = "14 mm"
wall_thickness = "2 mm"
length = "200 mm"
[tube.material]
law = "neo-hookean"
mu = "1.2 MPa"
[braid]
angle = "22 deg"
strands = 96
strand_diameter = "0.25 mm"
strand_modulus = "8.5 GPa"
strand_strength = "40 N"
[terminals]
insertion = "15 mm"
"#;

/// A joint with two of them.
const JOINT: &str = r#"
[joint]
radius = "20 mm"
range = "-45..45 deg"
[muscle_1]
file = "my.toml"
contraction_at_neutral = "8%"
[muscle_2]
file = "my.toml"
contraction_at_neutral = "8%"
"#;

fn muscle() -> tempfile::TempDir {
    let dir = folder();
    std::fs::write(dir.path().join("my.toml"), MUSCLE).unwrap();
    dir
}

/// Runs a line whose words may be in single quotes.
fn line(dir: &Path, line: &str) -> Ran {
    let mut words = vec![];
    for (i, part) in line.split('\'').enumerate() {
        if i % 2 == 1 {
            words.push(part.to_owned());
        } else {
            words.extend(part.split_whitespace().map(str::to_owned));
        }
    }
    run_in(dir, &words)
}

#[test]
fn a_file_is_what_its_ending_says() {
    let dir = muscle();
    for (words, said) in [
        ("report my.toml --model ideal -p 6bar -o rr.docx", "end it in .html or .htm"),
        ("report my.toml -p 6bar --pdf rr.html", "end it in .pdf"),
        ("report my.toml -p 6bar --format json -o rr.html", "end it in .json"),
        ("design -F 300N -e 10% -p 3bar -o x.png", "end it in .toml"),
        ("rubber t.csv -o x.json", "end it in .toml"),
        ("identify my.toml --data t.csv -o x.csv", "end it in .toml"),
        ("fit t.csv -o x.parquet", "end it in .json"),
        ("simulate my.toml --export-inp x.svg", "end it in .inp"),
        ("schema force -o x.toml", "end it in .json"),
        ("force my.toml -p 6bar -o table.xlsx", ".txt, .json, .csv and .parquet"),
        ("curve isobaric my.toml --model ideal --plot x.docx", ".svg, .png, .pdf or .html"),
    ] {
        let words = words.replace(" --model ideal -p", " -p");
        let ran = line(dir.path(), &words);
        assert_eq!(ran.code, 2, "{words}: {}", ran.err);
        assert!(ran.err.contains(said), "{words}: {}", ran.err);
        let there = std::fs::read_dir(dir.path()).unwrap().count();
        assert_eq!(there, 1, "{words} wrote a file");
    }
}

#[test]
fn a_report_named_pdf_is_a_pdf_or_is_refused() {
    let dir = muscle();
    let ran = line(dir.path(), "report my.toml -p 6bar -o rr.pdf");
    let file = dir.path().join("rr.pdf");
    match ran.code {
        0 => assert!(std::fs::read(&file).unwrap().starts_with(b"%PDF-")),
        _ => {
            assert_eq!(ran.code, 2);
            assert!(ran.err.contains("Chromium") && ran.err.contains("FILE.html"), "{}", ran.err);
            assert!(!file.exists());
        }
    }
}

/// 88 mm are 249.45 points.
#[test]
fn a_figure_named_pdf_is_a_pdf_with_the_width_of_a_column() {
    let dir = muscle();
    let words = "curve isobaric my.toml --model ideal --plot f.pdf --overwrite";
    let page = |more: &str| {
        line(dir.path(), &format!("{words}{more}")).ok();
        let pdf = std::fs::read(dir.path().join("f.pdf")).unwrap();
        assert!(pdf.starts_with(b"%PDF-1.4") && pdf.ends_with(b"%%EOF\n"));
        let text = String::from_utf8_lossy(&pdf).into_owned();
        let size = text.split("/MediaBox [0 0 ").nth(1).unwrap().split(' ').next().unwrap();
        size.parse::<f64>().unwrap()
    };
    assert!((page("") - 160.0 * 72.0 / 25.4).abs() < 0.01);
    assert!((page(" --plot-width 88mm") - 249.45).abs() < 0.01);
    let wide = line(dir.path(), &format!("{words} --plot-width 8m"));
    assert!(wide.code == 2 && wide.err.contains("20 to 2000 mm"), "{}", wide.err);
    assert_eq!(line(dir.path(), "curve isobaric my.toml --plot-width 88mm").code, 2);
}

#[test]
fn the_joint_file_of_a_design_names_the_muscle_file_that_was_written() {
    let dir = folder();
    let words = "design --joint 3Nm@30deg -p 4bar --length 250 --rubber dragon-skin-30 --model thick-wall --verify none";
    let ran = line(dir.path(), &format!("{words} -o el.toml")).ok();
    assert!(ran.text().contains("file = \"el.toml\""), "{}", ran.text());
    assert!(!ran.text().contains("winner.toml"), "{}", ran.text());
    // What is printed is a joint file that works beside the muscle file.
    let text = ran.text().split("[joint]").nth(1).unwrap();
    let end = text.find("\n\n\n").or(text.find("\nThe winner")).unwrap_or(text.len());
    let joint = text[..end].lines().take_while(|l| !l.starts_with("Near") && !l.contains(" │ "));
    let joint: Vec<&str> = joint.filter(|l| l.is_empty() || l.contains('=') || l.starts_with('[')).collect();
    std::fs::write(dir.path().join("joint.toml"), format!("[joint]{}", joint.join("\n"))).unwrap();
    line(dir.path(), "joint joint.toml -p 2bar,2bar --angle 0 --model thick-wall").ok();
}

#[test]
fn what_people_read_is_in_the_unit_of_the_first_pressure_that_was_typed() {
    let dir = muscle();
    std::fs::write(dir.path().join("jt.toml"), JOINT).unwrap();
    let muscle = "--muscle my.toml --load mass:5kg";
    let motion = "--valve '0.5 L/(s bar)' --damping '200 N s/m' --model thick-wall";
    for words in [
        "force my.toml -p 2bar -e 10% --model thick-wall",
        "force my.toml -p 90bar --model universal",
        "force my.toml -p 500bar --model thick-wall",
        "pressure my.toml -F 9999lbf -e 10% --model thick-wall --units bar",
        "contraction my.toml -p 2bar -F 99999N --model thick-wall",
        "contraction my.toml -p 2bar --load force:99999N --model thick-wall",
        "joint jt.toml --max-pressure 2bar --angle 0 --torque 999Nm --model thick-wall",
        "joint jt.toml -p -2bar,1bar --angle 0 --model thick-wall",
        &format!("motion {muscle} -p 3bar --supply 2bar {motion}"),
        &format!("motion {muscle} -p 2bar {motion}"),
        "curve isobaric my.toml -p 2,4bar --model thick-wall",
        "check my.toml -p 60bar --model thick-wall",
        "simulate my.toml -p -1,2bar",
        "design my.toml -F 700N -e 15% -p 6bar --model thick-wall --verify none",
        "design my.toml -F 700N -e 15% -p -6bar",
    ] {
        let ran = line(dir.path(), words);
        let said = format!("{}{}", String::from_utf8_lossy(&ran.out), ran.err);
        let lines = said.lines().filter(|l| {
            // Moduli have their own unit, and so has a power law of the pressure.
            !(l.contains("modul")
                || l.contains("1.2 MPa")
                || l.contains("law ")
                || l.contains("neo-hookean")
                || l.contains("P/MPa"))
        });
        let wrong: Vec<&str> = lines.filter(|l| l.contains("MPa")).collect();
        assert!(wrong.is_empty(), "{words}: {wrong:?}");
    }
    // The first that was typed decides; --units before it; programs get MPa as ever.
    let first = line(dir.path(), "joint jt.toml -p 30psi,20psi -p 2bar,1bar --angle 0 --model ideal").ok();
    assert!(first.text().contains("P1 [psi]") && !first.text().contains("[bar]"), "{}", first.text());
    let asked = line(dir.path(), "force my.toml -p 2bar --model ideal --units kpa").ok();
    assert!(asked.text().contains("200 kPa"), "{}", asked.text());
    let json = line(dir.path(), "force my.toml -p 500bar --model thick-wall --format json");
    assert!(!json.err.contains(" bar"), "{}", json.err);
}

#[test]
fn a_drive_file_in_bar_is_answered_in_bar() {
    let ran = line(&root(), "motion examples/drive.toml --model thick-wall").ok();
    assert!(ran.text().contains(" bar\n") && !ran.text().contains(" MPa\n"), "{}", ran.text());
}

#[test]
fn typing_slips_are_named_with_what_was_meant() {
    let dir = muscle();
    for (words, said) in [
        ("force my.toml -p 36 --model thick-wall", "36 MPa = 360 bar; was psi meant? write 36psi"),
        ("force my.toml -p 36", "was psi meant? write 36psi"),
        ("force my.toml -p 2,5bar", "write 2.5bar"),
        ("force my.toml -p 2bar -D 1,250mm", "write 1.250mm or 1250mm"),
        ("force my.toml -p 2 bar", "a quote is missing"),
        ("force -p 2 bar", "write -p 2bar or -p '2 bar'"),
        ("joint my.toml --torque 2 N m", "write --torque '2 N m'"),
    ] {
        let ran = line(dir.path(), words);
        assert!(ran.err.contains(said), "{words}: {}", ran.err);
    }
    let json = line(dir.path(), "force -p 2 bar --format json");
    assert_eq!((json.code, json.error()["kind"].as_str()), (2, Some("usage")));
}

#[test]
fn tables_have_the_same_columns_whatever_the_values() {
    let dir = muscle();
    std::fs::write(dir.path().join("jt.toml"), JOINT).unwrap();
    std::fs::write(
        dir.path().join("bench.csv"),
        "pressure_bar,contraction,force_n\n1,0,150\n1,0.05,100\n2,0,310\n2,0.05,250\n2,0.1,150\n",
    )
    .unwrap();
    for group in [
        &[
            "force my.toml -p 4bar -e 10%",
            "force my.toml -p 6bar",
            "force my.toml -p 0bar -e 20%",
            "force my.toml -p 2bar --model ideal",
            "force -p 2bar -e 5% --model paper -D 40 -s 2",
        ][..],
        &["pressure my.toml -F 100N --model ideal", "pressure my.toml -F 0N -e 5% --model thick-wall"],
        &[
            "contraction my.toml -p 2bar --model ideal",
            "contraction my.toml -p 2bar --load mass:5kg --model thick-wall",
        ],
        &[
            "curve isobaric my.toml -p 1bar -e 0,5% --model ideal",
            "curve isobaric my.toml -p 1bar -e 0,39% --model thick-wall",
            "curve isotonic my.toml -p 1bar -F 20,90000N --model thick-wall",
        ],
        &[
            "compare my.toml --models ideal,thick-wall -p 1bar -e 0,5%",
            "compare my.toml --models ideal,thick-wall --data bench.csv --fit modulus",
        ],
        &["check my.toml", "check my.toml -p 2bar --model ideal", "check -D 40 -s 2"],
        &["parts show nfl-19", "parts show s-muscle-20"],
        &[
            "design -F 300N -e 10% -p 4bar --model thick-wall --verify none",
            "design my.toml -F 100N -e 5% -p 4bar -D 14,16 -s 1 --model thick-wall --verify none",
        ],
        &[
            "joint jt.toml -p 2bar,1bar --model ideal",
            "joint jt.toml -p 2bar,1bar --angle 0 --model ideal",
            "joint jt.toml --angle 5deg --torque 1Nm --model ideal",
        ],
    ] {
        let heads: Vec<String> = group
            .iter()
            .map(|words| {
                let ran = line(dir.path(), &format!("{words} --format csv")).ok();
                ran.text().lines().next().unwrap_or_default().to_owned()
            })
            .collect();
        // Constants of a rubber's law are columns of their own.
        let law = |head: &String| -> Vec<String> {
            let own = |c: &&str| !["c10", "c01", "mu"].contains(c);
            head.split(',').filter(own).map(str::to_owned).collect()
        };
        for (words, head) in group.iter().zip(&heads) {
            assert_eq!(law(head), law(&heads[0]), "{words}");
        }
    }
}

#[test]
fn errors_name_the_flag_that_was_typed() {
    let dir = muscle();
    for (words, said, not) in [
        ("design -F 300N -e 10% -p 3bar --continuous --safety 3", "--safety", "--min-burst-margin"),
        ("design -F 300N -e 10% -p 3bar --continuous --min-burst-margin 3", "--min-burst-margin", "--safety"),
        ("force my.toml -p 2bar --both", "--both", "--branch"),
        ("force my.toml -p 2bar --branch contraction", "--branch", "--both"),
        ("curve isobaric my.toml --both", "--both", "--branch"),
    ] {
        let ran = line(dir.path(), words);
        assert_eq!(ran.code, 2, "{words}: {}", ran.err);
        assert!(ran.err.contains(said) && !ran.err.contains(not), "{words}: {}", ran.err);
    }
}

#[test]
fn what_would_be_ignored_is_refused_and_both_are_named() {
    let dir = muscle();
    std::fs::write(dir.path().join("t.csv"), "stretch,nominal_stress_mpa\n1.0,0\n1.5,0.2\n2,0.35\n2.5,0.5\n")
        .unwrap();
    let root = root();
    for (words, first, second) in [
        ("curve isobaric my.toml -F 100N", "--force", "isobaric"),
        ("curve isometric my.toml -F 100N", "--force", "--contraction"),
        ("curve isotonic my.toml -e 10%", "--contraction", "--force"),
        ("simulate my.toml -F 100N", "--force", "isometric"),
        ("simulate my.toml --test isotonic -e 10%", "--contraction", "--force"),
        ("simulate my.toml --test isotonic --of-largest", "--of-largest", "isotonic"),
        ("curve --study thickness -D 40", "--outer-diameter", "study"),
        ("curve --study thickness -e 10%", "--study", "--contraction"),
        ("design -F 300N -e 15% --stroke 40mm --length 285 -p 3bar", "--stroke", "--length"),
        ("joint JOINT -p 2bar,1bar --angle 0 --torque 3Nm", "--torque", "--angle"),
        ("joint JOINT -p 2bar,1bar --angle 0 --stiffness 3", "--stiffness", "--pressure"),
        ("joint JOINT -p 2bar,1bar --max-pressure 3bar", "--max-pressure", "--pressure"),
        ("joint JOINT -p 2bar,1bar --branch contraction", "--branch", "unexpected"),
        ("motion DRIVE --two-sided", "--two-sided", "unexpected"),
        ("motion DRIVE --extrapolate", "--extrapolate", "unexpected"),
        ("force my.toml -p 2bar --model ideal --mesh 8", "--mesh", "fe"),
        ("force my.toml -p 2bar --match angle", "--match", "fe3d"),
        ("compare my.toml --models ideal,thick-wall --mesh 8", "--mesh", "fe"),
        ("compare my.toml --models ideal --columns pressure=P1", "--columns", "--data"),
        ("compare my.toml --models ideal --branch contraction", "--branch", "friction"),
        ("rubber t.csv --law yeoh --terms 2", "--terms", "--law"),
        ("rubber t.csv --area 8mm2", "--area", "force"),
        ("rubber t.csv --gauge-length 25mm", "--gauge-length", "extension"),
        ("fit data/campaign/paper.csv --method global --thin-rule whole", "--thin-rule", "--method"),
        ("fit --report --hold-out 35", "--report", "--hold-out"),
        ("build my.toml -p 4bar -e 10%", "--contraction", "report"),
    ] {
        let at_root = words.starts_with("fit ") || words.contains("JOINT") || words.contains("DRIVE");
        let words = words.replace("JOINT", "examples/elbow.toml").replace("DRIVE", "examples/drive.toml");
        let ran = line(if at_root { &root } else { dir.path() }, &words);
        assert_eq!(ran.code, 2, "{words}: {} {}", ran.err, ran.text());
        assert!(ran.err.contains(first) && ran.err.contains(second), "{words}: {}", ran.err);
    }
}

#[test]
fn tables_of_tension_machines_are_read() {
    // Zwick's export: a line of the specimen, travel and force under their German names, a line of units.
    let zwick = line(
        &root(),
        "rubber crates/mckibben-cli/tests/tension/zwick.csv --gauge-length 25mm --area 8mm2 --law yeoh",
    );
    let zwick = zwick.ok();
    assert!(zwick.text().contains("14 points"), "{}", zwick.text());
    assert!(zwick.text().contains("Standardweg → extension (mm"), "{}", zwick.text());
    assert!(zwick.text().contains("Standardkraft → force (N"), "{}", zwick.text());
    // Columns by blanks, and blanks within the headings.
    let astm = line(&root(), "rubber crates/mckibben-cli/tests/tension/blanks.txt --law yeoh").ok();
    assert!(astm.text().contains("Elongation (%) → strain (%)"), "{}", astm.text());
    assert!(astm.text().contains("Engineering Stress (psi) → nominal_stress (psi)"), "{}", astm.text());
}

#[test]
fn what_rounding_leaves_is_zero_and_no_muscle_is_half_as_long_again() {
    let dir = muscle();
    let slack = mckibben("joint examples/forearm.toml -p 4bar,0bar --angle -60..60:60deg").ok();
    assert!(!slack.text().contains(" 0.0000") && !slack.text().contains("e-"), "{}", slack.text());
    let hair = mckibben("joint examples/forearm.toml -p 4bar,0bar --angle -60..60:30deg --model thick-wall");
    assert!(!hair.err.contains("contraction -0,") && !hair.err.contains("contraction 0,"), "{}", hair.err);
    let starts = line(dir.path(), "pressure my.toml -F 0N -e 0 --units bar --model ideal").ok();
    assert!(!starts.text().contains("e-"), "{}", starts.text());
    let far = line(dir.path(), "force my.toml -p 6bar -e -50%");
    assert_eq!(far.code, 2, "{}", far.text());
    assert!(far.err.contains("outside the range of the fe model: contraction -0.5"), "{}", far.err);
    // 1 − 1/cos 22°.
    assert!(
        far.err.contains("the strands of this braid are straight at a contraction of -7.9 %"),
        "{}",
        far.err
    );
    // arccos(1/√3)/22°: 1 − cos 54.7°/cos 22° = 37.7 %.
    let beyond = line(dir.path(), "force my.toml -p 2bar -e 60% --model thick-wall").ok();
    assert!(beyond.err.contains("it contracts by 37.7 % at most"), "{}", beyond.err);
    let none = line(dir.path(), "pressure my.toml -F 0N -e 45% --model thick-wall");
    assert!(none.code == 1 && none.err.contains("contracts by 37.7 % at most"), "{}", none.err);
    // A load stretches it a little all the same.
    line(dir.path(), "force my.toml -p 6bar -e -3%").ok();
}

#[test]
fn an_answer_ends_at_the_second_digit_of_its_uncertainty() {
    let dir = muscle();
    for (words, name) in [
        ("force my.toml -p 6bar --model thick-wall", "pull"),
        ("pressure my.toml -F 100N --units bar --model thick-wall", "pressure"),
        ("contraction my.toml -F 50N -p 4bar --model thick-wall", "contraction"),
    ] {
        let ran = line(dir.path(), words).ok();
        let row = ran.text().lines().find(|l| l.trim_start().starts_with(&format!("{name} "))).unwrap();
        let (value, half) = row.split_once(" ± ").unwrap();
        let value = value.rsplit(' ').next().unwrap();
        let half = half.split(' ').next().unwrap();
        let decimals = |text: &str| text.split_once('.').map_or(0, |(_, behind)| behind.len());
        assert_eq!(decimals(value), decimals(half), "{row}");
        let digits = half.trim_start_matches(['0', '.']).chars().filter(char::is_ascii_digit);
        let significant = digits.collect::<String>();
        assert!(significant.trim_end_matches('0').len() <= 2, "{row}");
    }
    let air = line(dir.path(), "check my.toml -p 4bar --model thick-wall").ok();
    assert!(air.text().contains("L (ANR)") && !air.text().contains("nL"), "{}", air.text());
}

#[test]
fn no_answer_is_said_in_words_of_the_muscle_and_not_of_the_solver() {
    let dir = muscle();
    for (words, said) in [
        ("pressure -F 300N -e 40%", "this braid contracts by 34.6 % at most"),
        ("pressure my.toml -F 300N -e 40%", "this braid contracts by 37.7 % at most"),
        ("force my.toml -p 36", "take stiffer strands"),
        ("design -F 700N -e 15% -p 100bar -D 20..40:10 -s 1,2", "strands"),
    ] {
        let ran = line(dir.path(), words);
        let text = format!("{}{}", ran.text(), ran.err);
        assert!(ran.code != 0 && text.contains(said), "{words}: {text}");
        for word in ["residual", "iteration", "J ", "converge", "diverge", "Newton", "solver", "too long"] {
            assert!(!text.contains(word), "{words}: {word} in {text}");
        }
    }
}

#[test]
fn a_joint_of_many_angles_has_a_row_of_each() {
    let dir = folder();
    let words = "joint examples/forearm.toml -p 4bar,0bar --angle -60..60:5deg";
    let text = mckibben(words).ok();
    assert_eq!(text.text().lines().filter(|l| l.contains("slack") || l.ends_with(" 0")).count(), 25);
    // Programs get P′ as well, each of opposite angles once.
    let path = dir.path().join("points.json").display().to_string();
    mckibben(&format!("{words} -o {path}")).ok();
    let points: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
    let points = points["points"].as_array().unwrap().clone();
    let start = |i: usize, muscle: u8| points[i][format!("start_pressure_{muscle}_mpa")].as_f64().unwrap();
    for i in 0..points.len() {
        assert_eq!(start(i, 1), start(points.len() - 1 - i, 2), "{i}");
    }
    let alone = mckibben("force examples/forearm-muscle.toml -p 4bar -e 0.084614 --format json").ok();
    let alone = alone.json()["start_pressure_mpa"].as_f64().unwrap();
    assert!((start(12, 1) / alone - 1.0).abs() < 1e-6, "{} {alone}", start(12, 1));
}

#[test]
fn no_message_has_digits_that_nobody_reads() {
    let dir = muscle();
    for words in [
        "force my.toml -p 1e300 --model thick-wall",
        "force my.toml -p 2bar -e 1e300",
        "force my.toml -p 2bar -e -1e300 --model ideal",
        "contraction my.toml -p 2bar -F 1e300 --model thick-wall",
        "pressure my.toml -F -1e300",
        "design -F 1e300 -e 10% -p 3bar --model thick-wall --verify none",
        "force -D 1e300 -s 1 -p 2bar",
    ] {
        let ran = line(dir.path(), words);
        let said = format!("{}{}", String::from_utf8_lossy(&ran.out), ran.err);
        assert!(!said.contains("0000000000000000") && !said.contains("Some("), "{words}: {said}");
    }
}

#[test]
fn a_design_says_what_it_assumed_and_that_a_stiffer_sleeve_would_do() {
    let dir = folder();
    let words = "design -F 700N -e 15% -p 6bar -D 28,30 -s 1,2,3";
    let ran = line(dir.path(), words);
    assert_eq!(ran.code, 1, "{}", ran.err);
    for said in [
        "rubber paper, braid paper",
        "Assumed: the rubber is that of the paper",
        "--rubber",
        "Safety: strands stretched by at most 6 %",
        "Use a stiffer sleeve: with ",
        "--braid",
        "--stiffness",
    ] {
        assert!(ran.text().contains(said), "{said}: {}", ran.text());
    }
    // It would: the stiffness that is named fits.
    let at = ran.text().find("stiffer sleeve: with ").unwrap() + "stiffer sleeve: with ".len();
    let k = ran.text()[at..].split(' ').next().unwrap();
    let stiff = line(dir.path(), &format!("{words} --stiffness {k} --verify none")).ok();
    assert!(!stiff.text().contains("the braid is that of the paper"), "{}", stiff.text());
}

#[test]
fn walls_that_nobody_makes_are_warned_of() {
    let dir = folder();
    let words = "design -F 100N -e 5% -p 2bar -D 40 -s WALL --model thick-wall --verify none";
    let thin = line(dir.path(), &words.replace("WALL", "0.5")).ok();
    assert!(thin.err.contains("a wall of 0.5 mm on a tube of 40 mm is rarely available"), "{}", thin.err);
    let usual = line(dir.path(), &words.replace("WALL", "1.5")).ok();
    assert!(!usual.err.contains("rarely available"), "{}", usual.err);
}

/// Every flag of a question, with a value and with the question in which it counts: the answer becomes another one, or the flag is
/// refused.
const COUNTS: &[(&str, &str, &str)] = &[
    ("outer-diameter", "15mm", ""),
    ("wall", "1.5mm", ""),
    ("length", "210mm", ""),
    ("density", "930kg/m3", ""),
    ("prestretch", "1.1", ""),
    ("angle", "24deg", ""),
    ("rubber", "dragon-skin-30", ""),
    ("braid", "nfl-19", ""),
    ("strand-diameter", "0.2mm", ""),
    ("strand-modulus", "3GPa", ""),
    ("stiffness", "300", ""),
    ("seating", "1mm", ""),
    ("slip", "4mm/kN", ""),
    ("grip", "5mm", ""),
    ("pull-off", "100N", ""),
    ("rated-pressure", "1bar", ""),
    ("end-factor", "1.2", ""),
    ("cone-factor", "0.4", "--model conical-ends"),
    ("strand-length", "216mm", "--model belforte --turns 1.84"),
    ("turns", "1.84", "--model belforte --strand-length 216mm"),
    ("model", "ideal", ""),
    ("muscle", "my.toml", ""),
    ("extrapolate", "", "--model paper"),
    ("two-sided", "", "-e 45%"),
    ("mesh", "8", ""),
    ("match", "angle", ""),
    ("terminal", "rigid", ""),
    ("branch", "contraction", ""),
    ("pressure", "3bar", ""),
    ("contraction", "6%", ""),
    ("both", "", ""),
];

/// Flags that say how an answer is shown, not what is asked.
const SHOWS: &[&str] = &["format", "units", "output", "overwrite", "help"];

#[test]
fn every_flag_of_a_question_counts_or_is_refused() {
    let dir = muscle();
    let help = mckibben("force --help").ok();
    let flags = help.text().lines().filter_map(|l| {
        let words =
            l.trim_start().split_once("--").filter(|(short, _)| short.is_empty() || short.len() == 4)?;
        Some(words.1.split([' ', '=']).next()?.to_owned())
    });
    let flags: Vec<String> = flags.filter(|f| !SHOWS.contains(&f.as_str())).collect();
    assert!(flags.len() > 20, "{flags:?}");
    for flag in flags {
        let known = COUNTS.iter().find(|c| c.0 == flag);
        let (_, value, with) = known.unwrap_or_else(|| panic!("say in which question --{flag} counts"));
        let mut base: Vec<&str> = vec!["force", "my.toml", "--format", "json"];
        base.extend(with.split_whitespace());
        for (own, usual) in [
            ("pressure", ["-p", "2bar"]),
            ("contraction", ["-e", "5%"]),
            ("model", ["--model", "thick-wall"]),
        ] {
            if flag != own && !with.contains(usual[0]) {
                base.extend(usual);
            }
        }
        let asked = format!("--{flag}");
        let more: Vec<&str> =
            base.iter().copied().chain([asked.as_str()]).chain(value.split_whitespace()).collect();
        let (without, with) = (run_in(dir.path(), &base), run_in(dir.path(), &more));
        let counts = with.code == 2 || (with.code == 0 && with.out != without.out);
        assert!(counts, "--{flag} {value} changes nothing: {more:?}");
    }
}
