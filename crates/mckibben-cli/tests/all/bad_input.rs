//! Input that is wrong: the exit code, the kind, and a message that says what to do.

use crate::common::{Ran, assert_finite, command, folder, mckibben, ran, root, run, run_in};
use std::path::Path;

/// Name, words, exit code, kind, part of the message or hint.
type Case = (&'static str, &'static str, i32, &'static str, &'static str);

/// No words in these hold spaces; `FILE` is replaced by the path of a written file, `DIR` by that of a folder.
const FLAGS: &[Case] = &[
    // Quantities.
    ("a length that is a pressure", "force -p 0.2 -D 30bar", 2, "quantity", "\"30bar\" is a pressure"),
    ("a pressure that is a length", "force -p 30mm", 2, "quantity", "--pressure: \"30mm\" is a length"),
    ("an angle that is a force", "force -p 0.2 --angle 28N", 2, "quantity", "expected an angle"),
    ("a force that is an angle", "pressure -F 28deg", 2, "quantity", "expected a force"),
    ("a ratio that is a length", "force -p 0.2 -e 30mm", 2, "quantity", "expected a ratio"),
    ("an unknown unit", "force -p 0.2 -L 3furlongs", 2, "quantity", "\"furlongs\""),
    (
        "millipascal or megapascal",
        "force -p 2.5mPa",
        2,
        "quantity",
        "\"mPa\" in \"2.5mPa\" is not a known unit",
    ),
    ("a word", "force -p much", 2, "quantity", "does not start with a number"),
    ("a decimal comma", "force -p 0,25", 2, "quantity", "write 0.25"),
    ("NaN", "force -p NaN", 2, "quantity", "not a finite number"),
    ("minus NaN", "force -p 0.2 -e -nan", 2, "quantity", "not a finite number"),
    ("infinite", "force -p inf", 2, "quantity", "not a finite number"),
    ("an infinite length", "force -p 0.2 -D -infinity", 2, "quantity", "not a finite number"),
    ("too large for a double", "force -p 1e999", 2, "quantity", "not a finite number"),
    ("too large after its unit", "force -p 0.2 -L 1e306m", 2, "quantity", "not a finite number"),
    (
        "a stiffness that is a word",
        "force -p 0.2 --stiffness soft",
        2,
        "quantity",
        "or `inextensible`, or `paper`",
    ),
    // Terminals.
    ("a terminal of wood", "force --model fe3d -p 0.2 --terminal wood", 2, "terminal", "aluminium:20mm:3mm"),
    (
        "a terminal with a fourth word",
        "force --model fe3d -p 0.2 --terminal rigid:1:2:3",
        2,
        "terminal",
        "is not a terminal",
    ),
    (
        "a terminal of another model",
        "force --model fe -p 0.2 --terminal rigid",
        2,
        "terminal",
        "only --model fe3d",
    ),
    ("a terminal without a model", "force -p 0.2 --terminal rigid", 2, "terminal", "only --model fe3d"),
    (
        "an elastic terminal outside",
        "force --model fe3d -p 0.2 --terminal aluminium:0",
        2,
        "mesh",
        "insertion in mm is 0",
    ),
    (
        "a nose wider than the bore",
        "force --model fe3d -p 0.2 --terminal rigid:1:50",
        2,
        "mesh",
        "nose in mm is 50",
    ),
    ("a length that is none", "force --model fe3d -p 0.2 --terminal rigid:wide", 2, "quantity", "--terminal"),
    (
        "a deck of a terminal",
        "simulate --model fe3d -p 0.2 -e 0 --terminal rigid --export-inp DIR/a.inp",
        2,
        "deck",
        "leave out --terminal",
    ),
    // Muscles.
    ("diameter below zero", "force -p 0.2 -D -30", 2, "muscle", "outer_diameter is -30 mm"),
    ("no diameter", "force -p 0.2 -D 0", 2, "muscle", "must be above zero"),
    ("wall below zero", "force -p 0.2 -s -1mm", 2, "muscle", "wall_thickness is -1 mm"),
    ("no wall", "force -p 0.2 -s 0", 2, "muscle", "must be above zero"),
    ("a wall without bore", "force -p 0.2 -s 15", 2, "muscle", "thinner than the radius"),
    ("a wall past the axis", "check -D 10 -s 6", 2, "muscle", "thinner than the radius"),
    ("no length", "force -p 0.2 -L 0", 2, "muscle", "length is 0 mm"),
    ("an angle that is too large", "force -p 0.2 --angle 80", 2, "muscle", "between 0 and 75"),
    ("no angle at all", "force -p 0.2 --angle 90", 2, "muscle", "between 0 and 75"),
    ("no angle", "force -p 0.2 --angle 0", 2, "muscle", "between 0 and 75"),
    ("an angle below zero", "force -p 0.2 --angle -28", 2, "muscle", "between 0 and 75"),
    ("no stiffness", "force -p 0.2 --stiffness 0", 2, "muscle", "braid.stiffness is 0 N/mm"),
    ("an end factor below zero", "force -p 0.2 --end-factor -1", 2, "muscle", "end_factor is -1"),
    ("no turns", "force -p 0.2 --strand-length 323 --turns 0", 2, "muscle", "turns is 0"),
    ("turns without strand length", "force -p 0.2 --turns 2", 2, "usage", "belong together"),
    (
        "an unknown rubber",
        "force -p 0.2 --rubber dragon-skin-3O",
        2,
        "rubber",
        "did you mean dragon-skin-30?",
    ),
    ("a rubber without that law", "parts show paper:yeoh", 2, "rubber", "it has mooney-rivlin"),
    ("no part", "parts show nothing-like-it-at-all", 2, "usage", "there is no part named"),
    ("an unknown sleeve", "force -p 0.2 --braid nfl19", 2, "braid", "did you mean nfl-19?"),
    ("no sleeve", "force -p 0.2 --braid nothing-like-it-at-all", 2, "braid", "known: s-muscle-13"),
    ("a tube too wide", "check -D 36 --braid nfl-19", 2, "braid", "fits tubes from 15 to 35 mm"),
    (
        "a tube too narrow",
        "force -p 0.2 -D 14 --braid nfl-19 --stiffness 300",
        2,
        "braid",
        "from 15 to 35 mm",
    ),
    ("a tube at which nothing contracts", "check -D 32 --braid nfl-19", 2, "braid", "below 54.7356 deg only"),
    (
        "an angle that the sleeve does not have",
        "force -p 0.2 -D 20 --braid nfl-19 --stiffness 300 --angle 28",
        2,
        "muscle",
        "nfl-19 has 31.68 deg",
    ),
    ("strands of no sleeve", "force -p 0.2 --strand-diameter 0.2", 2, "usage", "complete a named --braid"),
    (
        "strands below zero",
        "check -D 20 --braid nfl-19 --strand-diameter -1mm",
        2,
        "braid",
        "--strand-diameter is -1; it must be above zero",
    ),
    // Questions.
    ("no pressure", "force", 2, "usage", "--pressure is missing"),
    ("no force", "pressure -e 0.1", 2, "usage", "--force is missing"),
    ("no pressure for a contraction", "contraction -F 100", 2, "usage", "--pressure is missing"),
    ("pressure below zero", "force -p -1", 2, "out_of_range", "must be at least 0 MPa"),
    ("percent without its sign", "force -p 0.2 -e 15", 2, "quantity", "write 15% or 0.15"),
    ("far too many percent", "force -p 0.2 -e 1500%", 2, "quantity", "not a valid contraction ratio"),
    ("percent in an inverse", "pressure -F 100 -e 15", 2, "quantity", "write 15% or 0.15"),
    ("a push", "pressure -F -5 -e 0.1", 2, "quantity", "--two-sided"),
    ("a push at a pressure", "contraction -F -5 -p 0.2", 2, "quantity", "--two-sided"),
    ("pushes along curves", "curve isotonic -F -5,20", 2, "quantity", "--two-sided"),
    ("branch without friction", "force -p 0.2 --motion contraction", 2, "missing_input", "[friction]"),
    ("an unknown flag", "force -p 0.2 --colour red", 2, "usage", "'--colour'"),
    ("a flag twice", "force -p 0.2 -p 0.1", 2, "usage", "multiple times"),
    ("a flag without value", "force -p", 2, "usage", "--pressure <PRESSURE>"),
    ("an unknown command", "forces", 2, "usage", "forces"),
    ("an unknown unit to show", "force -p 0.2 --units stone", 2, "usage", "bar"),
    // Models.
    ("an unknown model", "force -p 0.2 --model ideel", 2, "model", "did you mean ideal?"),
    ("a model like no other", "compare --models ideal,x-y-z", 2, "model", "the models are ideal"),
    ("belforte without strand", "force -p 0.2 --model belforte", 2, "missing_input", "--strand-length"),
    (
        "tondu-lopez without factor",
        "force -p 0.2 --model tondu-lopez",
        2,
        "missing_input",
        "--end-factor 1.29",
    ),
    ("cones without factor", "force -p 0.2 --model conical-ends", 2, "missing_input", "--cone-factor 0.4"),
    ("paper: pressure", "force -p 3bar --model paper", 2, "out_of_range", "outside 0 to "),
    ("paper: contraction", "force -p 0.2 -e 0.3 --model paper", 2, "out_of_range", "outside 0 to 0.2"),
    (
        "paper: contraction below zero",
        "force -p 0.2 -e -1% --model paper",
        2,
        "out_of_range",
        "--extrapolate",
    ),
    ("paper: diameter", "force -p 0.2 -D 60 --model paper", 2, "out_of_range", "outside 30 to 50 mm"),
    ("paper: wall", "force -p 0.2 -s 6 --model paper", 2, "out_of_range", "outside 1 to 5 mm"),
    ("paper: angle", "force -p 0.2 --angle 25 --model paper", 2, "out_of_range", "28"),
    (
        "paper: rubber",
        "force -p 0.2 --rubber rtv615 --model paper",
        2,
        "out_of_range",
        "the rubber is rtv615",
    ),
    (
        "paper: pressure of an inverse",
        "contraction -p 3bar --model paper",
        2,
        "out_of_range",
        "--extrapolate",
    ),
    ("stretched past straight strands", "force -p 0.2 -e -0.5 --model thick-wall", 2, "out_of_range", "-0.5"),
    ("more pull than there is", "pressure -F 1e9 -e 0.1", 1, "no_answer", "the nearest"),
    ("more pull than blocked", "contraction -F 1e9 -p 0.2", 1, "no_answer", "the nearest"),
    ("a pressure that bursts all", "force -p 1e6 --model thick-wall", 1, "no_answer", "lower the pressure"),
    ("finite elements at such a pressure", "force -p 1e6", 3, "not_converged", "no equilibrium found"),
    // Ranges.
    ("an empty range", "curve isobaric -p ..", 2, "quantity", "--pressure"),
    ("half a range", "curve isobaric -p 0..", 2, "quantity", "the value is empty"),
    ("an empty list", "curve isobaric -p ,", 2, "quantity", "the value is empty"),
    ("a hole in a list", "curve isobaric -e 0,,0.1", 2, "quantity", "the value is empty"),
    ("a reversed range", "curve isobaric -p 0.2..0.1", 2, "range", "is reversed"),
    ("no step", "curve isobaric -p 0..0.2:0", 2, "range", "must be above zero"),
    ("a step back", "curve isobaric -p 0..0.2:-0.1", 2, "range", "must be above zero"),
    ("a step without range", "curve isobaric -p 0.2:0.1", 2, "range", "low..high:step"),
    ("a thousand million points", "curve isobaric -p 0..1:1e-9", 2, "range", "1.000e9 points"),
    ("points without end", "curve isobaric -p 0..1:1e-300", 2, "range", "take a larger step"),
    ("many times many", "curve isobaric -p 0..0.25:1e-5 -e 0..0.2:1e-5", 2, "range", "larger steps"),
    ("NaN in a range", "curve isobaric -p 0..NaN", 2, "quantity", "not a finite number"),
    ("mixed units", "curve isobaric -p 1bar,2,3bar", 2, "range", "put one unit after the last"),
    ("a wrong unit in a range", "curve isobaric -p 0..3:1mm", 2, "quantity", "a length"),
    ("percent in a curve", "curve isometric -e 0,5,10", 2, "quantity", "not a valid contraction ratio"),
    ("no test", "curve", 2, "usage", "<TEST>"),
    ("an unknown test", "curve isothermal", 2, "usage", "isobaric"),
    ("a test and a study", "curve isobaric --study thickness", 2, "usage", "cannot be used with"),
    ("a curve out of range", "curve isobaric -p 0.3,0.4 --model paper", 2, "out_of_range", ""),
    // Design.
    ("nothing wanted", "design", 2, "usage", "--force is missing"),
    ("design without pull", "design -e 10% -p 2.5bar", 2, "usage", "--force is missing"),
    ("design for no pull", "design -F 0N -e 10% -p 2.5bar", 2, "specification", "above 0 N"),
    ("design for a push", "design -F -300N -e 10% -p 2.5bar", 2, "specification", "above 0 N"),
    ("design without contraction", "design -F 300 -p 2.5bar", 2, "usage", "--stroke, such as 40 mm"),
    ("design without pressure", "design -F 300 -e 10%", 2, "usage", "--max-pressure is missing"),
    ("design without air", "design -F 300 -e 10% -p 0", 2, "specification", "must be above zero"),
    ("design for 15", "design -F 300 -e 15 -p 2.5bar", 2, "quantity", "write 15% or 0.15"),
    ("design for 15 at a point", "design --at 300N@15 -p 2.5bar", 2, "quantity", "write 15% or 0.15"),
    ("joint without an angle", "design --joint 8Nm -p 2.5bar", 2, "quantity", "8Nm@45deg"),
    (
        "joint past its range",
        "design --joint 8Nm@45deg --largest-angle 30deg -p 2.5bar",
        2,
        "specification",
        "±30°",
    ),
    ("joint without a torque", "design --joint 0Nm@45deg -p 2.5bar", 2, "specification", "above zero"),
    ("joint and a pull", "design --joint 8Nm@45deg -F 300 -p 2.5bar", 2, "usage", "--force"),
    ("radius without a joint", "design -F 300 -e 10% -p 2.5bar --radius 20mm", 2, "usage", "--joint"),
    ("load without a stroke", "design --load mass:20kg -p 2.5bar", 2, "usage", "--stroke"),
    ("load and a pull", "design --load mass:20kg -F 300 -e 10% -p 2.5bar", 2, "usage", "--load"),
    (
        "load without a pull",
        "design --load mass:2kg@level -e 10% -p 2.5bar",
        2,
        "specification",
        "a load that pulls",
    ),
    ("design for a stretch", "design -F 300 -e -10% -p 2.5bar", 2, "specification", "from 0 to below 1"),
    ("point without @", "design --at 700N15% -p 2.5bar", 2, "quantity", "such as 700N@15%"),
    ("no points", "design --at , -p 2.5bar", 2, "quantity", "not a valid operating point"),
    ("point of wrong units", "design --at 700mm@15% -p 2.5bar", 2, "quantity", "expected a force"),
    ("points twice", "design --at 1N@1% -F 3 -p 1bar", 2, "usage", "cannot be used with"),
    (
        "stroke below zero",
        "design -F 300 --stroke -4 -p 2.5bar",
        2,
        "specification",
        "--stroke: -4 mm; it must be above zero",
    ),
    (
        "stroke and length and contraction",
        "design -F 300 --stroke 40 -L 100 -e 10% -p 2.5bar",
        2,
        "specification",
        "leave out --stroke, --length",
    ),
    (
        "stroke longer than the muscle",
        "design -F 300 --stroke 400 -L 285 -p 2.5bar",
        2,
        "specification",
        "below 1",
    ),
    (
        "stroke without contraction",
        "design -F 300 -e 0 --stroke 5 -p 2.5bar",
        2,
        "specification",
        "above zero",
    ),
    (
        "burst margin without strength",
        "design -F 300 -e 10% -p 2.5bar --continuous --min-burst-margin 2",
        2,
        "specification",
        "strand_strength",
    ),
    ("no stretch", "design -F 300 -e 10% -p 2.5bar --max-stretch 0", 2, "specification", "above zero"),
    ("diameters below zero", "design -F 300 -e 10% -p 2.5bar -D -5..10", 2, "specification", "above zero"),
    (
        "walls without bore",
        "design -F 300 -e 10% -p 2.5bar -D 10 -s 7",
        2,
        "specification",
        "thinner than the radius",
    ),
    ("angles that lengthen", "design -F 300 -e 10% -p 2.5bar --angle 60", 2, "specification", "54.7356"),
    ("too many diameters", "design -F 300 -e 10% -p 2.5bar -D 0..1:1e-7", 2, "range", "take a larger step"),
    (
        "too many muscles",
        "design -F 300 -e 10% -p 2.5bar -D 5..80:0.01 -s 0.5..10:0.01",
        2,
        "specification",
        "combinations are too many",
    ),
    (
        "an interval of sleeves",
        "design -F 300 -e 10% -p 2.5bar --strand-length-per-turn 90..110",
        2,
        "range",
        "as a list",
    ),
    ("no candidates to show", "design -F 300 -e 10% -p 2.5bar --top 0", 2, "usage", "1..=1000"),
    (
        "a tolerance without value",
        "design -F 300 -e 10% -p 2.5bar --tolerance wall",
        2,
        "quantity",
        "wall=0.1mm",
    ),
    (
        "an unknown tolerance",
        "design -F 300 -e 10% -p 2.5bar --tolerance mood=1",
        2,
        "quantity",
        "wall=0.1mm",
    ),
    (
        "a tolerance of the wrong unit",
        "design -F 300 -e 10% -p 2.5bar --tolerance wall=1bar",
        2,
        "quantity",
        "is a pressure",
    ),
    (
        "a tolerance below zero",
        "design -F 300 -e 10% -p 2.5bar --tolerance wall=-1",
        2,
        "quantity",
        "a tolerance is a half-width of zero or above",
    ),
    (
        "a tolerance beyond the wall",
        "design -F 300 -e 10% -p 2.5bar --tolerance wall=20mm",
        2,
        "tolerance",
        "smaller tolerances",
    ),
    (
        "design with an unknown rubber",
        "design -F 300 -e 10% -p 2.5bar --rubber nope",
        2,
        "rubber",
        "there is no rubber",
    ),
    (
        "a largest liquid volume without a liquid",
        "design -F 300 -e 10% -p 2.5bar --max-liquid 20mL",
        2,
        "usage",
        "give --liquid",
    ),
    ("an unknown objective", "design -F 300 -e 10% -p 2.5bar --objective beauty", 2, "usage", "diameter"),
    // Comparisons.
    ("a fit without points", "compare --fit modulus", 2, "usage", "--data <FILE.csv>"),
    (
        "an unknown constant",
        "compare --data data/tondu2012/static_force_20deg.csv --fit taste",
        2,
        "usage",
        "modulus, end-factor",
    ),
    (
        "grid and points",
        "compare --data data/tondu2012/static_force_20deg.csv -p 1bar",
        2,
        "usage",
        "cannot be used with",
    ),
    ("a model and models", "compare --model ideal --models paper", 2, "usage", "cannot be used"),
    ("an unknown branch", "compare --branch up", 2, "usage", "elongation"),
    ("no points file", "compare --data DIR/none.csv", 2, "file", "cannot be read"),
    ("a folder of points", "compare --data DIR", 2, "file", "is a directory"),
    // Muscle files that are none.
    ("no muscle file", "check DIR/none.toml", 2, "file", "cannot be read"),
    ("a folder of muscles", "check DIR", 2, "file", "is a directory"),
    ("a folder as --muscle", "force -p 0.2 --muscle DIR", 2, "file", "is a directory"),
    // Output.
    ("result into a missing folder", "models -o DIR/none/x.json", 2, "output", "none does not exist"),
    ("result onto a folder", "models -o DIR", 2, "output", "is a directory"),
    (
        "table in a file of another kind",
        "curve isobaric -o DIR/lut.mat",
        2,
        "output",
        ".txt, .json, .csv and .parquet",
    ),
    (
        "winner into a missing folder",
        "design -F 300 -e 10% -p 2.5bar -o DIR/none/w.toml",
        2,
        "output",
        "does not exist",
    ),
    (
        "figure of an unknown kind",
        "curve isobaric --plot DIR/x.docx",
        2,
        "output",
        ".svg, .png, .pdf or .html",
    ),
    ("figure without kind", "curve isobaric --plot DIR/x", 2, "output", ".svg, .png, .pdf or .html"),
    ("figure into a missing folder", "curve isobaric --plot DIR/none/x.svg", 2, "output", "does not exist"),
];

fn check(name: &str, result: &Ran, exit: i32, fragment: &str) {
    assert_eq!(result.code, exit, "{name}: {}", result.err);
    assert!(result.err.starts_with("error: "), "{name}: {}", result.err);
    assert!(result.err.contains(fragment), "{name}: {fragment} is not in: {}", result.err);
    assert!(result.out.is_empty(), "{name}: {}", result.text());
    assert!(result.err.len() < 1200, "{name}: a long message: {}", result.err);
}

fn check_json(name: &str, result: &Ran, exit: i32, kind: &str, fragment: &str) {
    assert_eq!(result.code, exit, "{name}: {}", result.err);
    if !result.out.is_empty() {
        // Curves carry the cause point by point.
        assert_finite(result.text());
        assert!(
            result.json()["points"].as_array().is_some_and(|p| p.iter().all(|q| q["status"] == kind)),
            "{name}"
        );
        return;
    }
    let error = result.error();
    assert_eq!(error["kind"], kind, "{name}: {error}");
    let said = format!("{} {}", error["message"].as_str().unwrap(), error["hint"].as_str().unwrap());
    assert!(said.contains(fragment), "{name}: {fragment} is not in: {said}");
}

fn both(name: &str, args: &[&str], exit: i32, kind: &str, fragment: &str) {
    check(name, &run(args), exit, fragment);
    let args: Vec<&str> = args.iter().copied().chain(["--format", "json"]).collect();
    check_json(name, &run(&args), exit, kind, fragment);
}

#[test]
fn flags() {
    let dir = folder();
    let path = dir.path().to_str().unwrap();
    for (name, words, exit, kind, fragment) in FLAGS {
        let words: Vec<String> = words.split(' ').map(|w| w.replace("DIR", path)).collect();
        let mut words: Vec<&str> = words.iter().map(String::as_str).collect();
        // A value that is missing must stay the last word.
        if *name == "a flag without value" {
            check(name, &run(&words), *exit, fragment);
            words.splice(1..1, ["--format", "json"]);
            check_json(name, &run(&words), *exit, kind, fragment);
        } else {
            both(name, &words, *exit, kind, fragment);
        }
    }
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 0, "a failed command leaves nothing behind");
}

/// Name, bytes of the file, kind, part of the message.
type File = (&'static str, &'static [u8], &'static str, &'static str);

const MUSCLES: &[File] = &[
    ("not UTF-8", b"[tube]\nlength = \"28\xff mm\"\n", "file", "not UTF-8"),
    ("UTF-16", b"\xff\xfe[\0t\0u\0b\0e\0]\0", "file", "UTF-16"),
    ("cut off", b"[tube]\nlength = \"285 m", "file", "not valid TOML"),
    ("cut off in a header", b"[tube", "file", "not valid TOML"),
    ("an unknown key", b"[tube]\nouter_diamter = 30\n", "file", "did you mean outer_diameter?"),
    ("an unknown table", b"[tubes]\nlength = 30\n", "file", "did you mean tube?"),
    ("a wrong type", b"[tube]\nlength = true\n", "file", "tube.length = true"),
    ("a list for a length", b"[tube]\nlength = [1, 2]\n", "file", "is a list"),
    ("a quantity without quotes", b"[tube]\nlength = 30 mm\n", "file", "in quotes"),
    ("a wrong unit", b"[tube]\nlength = \"30 bar\"\n", "file", "is a pressure"),
    ("NaN", b"[tube]\nlength = nan\n", "file", "not a finite number"),
    ("a key twice", b"[tube]\nlength = 1\nlength = 2\n", "file", "duplicate"),
    ("a wall without bore", b"[tube]\nwall_thickness = 16\n", "file", "thinner than the radius"),
    ("a steep braid", b"[braid]\nangle = 80\n", "file", "between 0 and 75"),
    ("an unknown rubber", b"[tube]\nrubber = \"dragonskin30\"\n", "file", "did you mean dragon-skin-30?"),
    ("an unknown law", b"[tube.material]\nlaw = \"neohookean\"\nmu = 1\n", "file", "neo-hookean"),
    ("half a friction", b"[friction]\ncoefficient = 3\n", "file", "exponent is missing"),
];

#[test]
fn muscle_files() {
    let dir = folder();
    let path = dir.path().join("bad.toml");
    let word = path.to_str().unwrap();
    for (name, bytes, kind, fragment) in MUSCLES {
        std::fs::write(&path, bytes).unwrap();
        both(name, &["check", word], 2, kind, fragment);
        both(name, &["force", "-p", "0.2", "--muscle", word], 2, kind, fragment);
        both(
            name,
            &["design", "-F", "300", "-e", "10%", "-p", "2.5bar", "--muscle", word],
            2,
            kind,
            fragment,
        );
    }
}

const POINTS: &[File] = &[
    ("empty", b"", "data", "no column of pressures"),
    ("no column of pressures", b"contraction,force_n\n0,1\n", "data", "no column of pressures"),
    ("no column of pulls", b"pressure_mpa,contraction\n0.1,0\n", "data", "no column of forces"),
    ("NaN", b"pressure_mpa,contraction,force_n\n0.1,NaN,3\n", "data", "line 2, column contraction"),
    ("infinite", b"pressure_mpa,contraction,force_n\n0.1,0,3\n0.1,0,inf\n", "data", "line 3, column force_n"),
    ("text", b"pressure_mpa,contraction,force_n\n0.1,0,lots\n", "data", "\"lots\""),
    ("an empty field", b"pressure_mpa,contraction,force_n\n0.1,,3\n", "data", "\"\""),
    ("no points", b"pressure_mpa,contraction,force_n\n", "data", "no points"),
    (
        "only points without answer",
        b"pressure_mpa,contraction,force_n,status\n0.1,0,,no_answer\n",
        "data",
        "no points",
    ),
    ("percent", b"pressure_mpa,contraction,force_n\n0.1,15,3\n", "data", "write 0.15 for 15 %"),
    (
        "kPa as MPa",
        b"pressure_mpa,contraction,force_n\n0.1,0,3\n250,0,3\n",
        "data",
        "line 3, column pressure_mpa: 250",
    ),
    (
        "a pressure of 1e308",
        b"pressure_kpa,contraction,force_n\n1e308,0,3\n",
        "data",
        "1e308 is too high for a muscle",
    ),
    (
        "a pull of 1e308",
        b"pressure_mpa,contraction,force_n\n0.1,0,1e308\n",
        "data",
        "line 2, column force_n: 1e308",
    ),
    (
        "a contraction of 1e308",
        b"pressure_mpa,contraction,force_n\n0.1,1e308,3\n",
        "data",
        "column contraction: 1e308",
    ),
    (
        "a wall of 1e308",
        b"pressure_mpa,contraction,force_n,wall_mm\n0.1,0,3,1e308\n",
        "data",
        "column wall_mm: 1e308",
    ),
    (
        "a weight of 1e308",
        b"pressure_mpa,contraction,force_n,weight\n0.1,0,3,1e308\n",
        "data",
        "column weight: 1e308",
    ),
    (
        "a column twice",
        b"pressure_mpa,pressure_mpa,contraction,force_n\n0.1,0.2,0,3\n",
        "data",
        "could all be pressure",
    ),
    (
        "two decimal marks",
        b"pressure_mpa;contraction;force_n\n0,1;0.05;3\n",
        "data",
        "can be read in two ways",
    ),
    ("pressure below zero", b"pressure_mpa,contraction,force_n\n-0.1,0,3\n", "data", "below zero"),
    ("a short line", b"pressure_mpa,contraction,force_n\n0.1,0\n", "data", "2 fields"),
    ("not a number", b"pressure_mpa,contraction,force_n\n0.1,0,\xff\n", "data", "line 2, column force_n"),
    ("an unknown branch", b"pressure_mpa,contraction,force_n,branch\n0.1,0,3,up\n", "data", "neither"),
    ("an unknown unit", b"Pressure [ell],contraction,force_n\n30,0,3\n", "data", "--columns pressure="),
];

#[test]
fn measured_points() {
    let dir = folder();
    let path = dir.path().join("bad.csv");
    let word = path.to_str().unwrap();
    for (name, bytes, kind, fragment) in POINTS {
        std::fs::write(&path, bytes).unwrap();
        both(name, &["compare", "--models", "ideal", "--data", word], 2, kind, fragment);
        both(name, &["identify", "--data", word], 2, kind, fragment);
    }
    std::fs::write(&path, "pressure_mpa,contraction,force_n\n0.1,0,100\n0.2,0,210\n").unwrap();
    let few = ["compare", "--models", "thick-wall", "--data", word, "--fit", "modulus"];
    both("too few points", &few, 2, "fit", "2 points");
    let branch = ["compare", "--models", "ideal", "--data", word, "--branch", "elongation"];
    both("no such branch", &branch, 2, "data", "no points of that branch");
}

#[cfg(unix)]
#[test]
fn devices_are_no_files() {
    for device in ["/dev/null", "/dev/zero"] {
        if !Path::new(device).exists() {
            continue;
        }
        both(device, &["check", device], 2, "file", "regular file");
        both(device, &["force", "-p", "0.2", "--muscle", device], 2, "file", "regular file");
        both(device, &["compare", "--data", device], 2, "file", "regular file");
    }
}

#[cfg(unix)]
#[test]
fn a_full_disk_is_an_error_and_no_panic() {
    if !Path::new("/dev/full").exists() {
        return;
    }
    let full = || std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    for line in
        ["parts list models", "force -p 0.2", "curve isobaric", "completions bash", "completions fish"]
    {
        let mut command = command(&root());
        let result = ran(command.args(line.split(' ')).stdout(full()).output().unwrap());
        check(line, &result, 2, "cannot write to standard output");
    }
    both(
        "into /dev/full",
        &["parts", "list", "models", "-o", "/dev/full"],
        2,
        "output",
        "cannot write /dev/full",
    );
    // Warnings that nobody can read do not spoil the result.
    let mut silent = command(&root());
    let args = "force -p 0.3 --model paper --extrapolate".split(' ');
    assert_eq!(silent.args(args).stderr(full()).output().unwrap().status.code(), Some(0));
}

#[cfg(unix)]
#[test]
fn a_reader_that_goes_away_is_no_failure() {
    use std::process::Stdio;
    for line in ["completions bash", "curve isobaric -p 0..0.25:0.001 -e 0..0.2:0.001 --format json"] {
        let mut child = command(&root())
            .args(line.split(' '))
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let result = ran(child.wait_with_output().unwrap());
        assert_eq!((result.code, result.err.as_str()), (0, ""), "{line}");
    }
}

#[cfg(unix)]
#[test]
fn bytes_that_are_no_text_are_refused() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let args = [OsStr::new("force"), OsStr::new("-p"), OsStr::from_bytes(b"0.2\xff")];
    assert_eq!(run(&args).code, 2);
    let args = [&args[..], &[OsStr::new("--format"), OsStr::new("json")]].concat();
    assert_eq!(run(&args).error()["kind"], "usage");
}

#[test]
fn figures_onto_folders_are_refused() {
    let dir = folder();
    std::fs::create_dir(dir.path().join("x.svg")).unwrap();
    let result = run_in(dir.path(), &["curve", "isobaric", "--plot", "x.svg"]);
    check("figure onto a folder", &result, 2, "cannot write x.svg");
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 1);
}

#[test]
fn an_unknown_format_is_refused() {
    let result = mckibben("models --format xml");
    check("format", &result, 2, "[possible values: text, json, csv]");
}

#[test]
fn a_range_of_many_points_is_refused_at_once() {
    let from = std::time::Instant::now();
    mckibben("curve isobaric -p 0..1:1e-9");
    assert!(from.elapsed().as_secs() < 5);
}
