//! What a page needs beyond the commands of a terminal: shapes, typed texts, bytes, tables in
//! memory, documents.

use super::reply;
use mckibben_app::{ProblemKind, ask, ask_packed};
use mckibben_core::progress::Silent;
use mckibben_report::Part;
use serde_json::{Value, json};

fn list(value: &Value, name: &str) -> Vec<f64> {
    value["arrays"][name]
        .as_array()
        .unwrap()
        .iter()
        .map(|v| v.as_f64().unwrap())
        .collect()
}

/// Identities: the outline ends at half the length, a strand turns by Z tanθ0/Ro, and the cavity of
/// the outline is the one of the virtual work (straight pieces between the stations cost 1.5e-4 of
/// it here).
#[test]
fn a_shape_keeps_length_turns_and_cavity() {
    for (pressure, contraction) in [(0.25, 0.0), (0.25, 0.15), (0.1, -0.02)] {
        let answer = reply(
            "shape",
            json!({ "muscle": { "outer_diameter_mm": 38, "wall_mm": 1 }, "pressure_mpa": pressure, "contraction": contraction }),
        );
        let (stations, across) = (
            answer["stations"].as_u64().unwrap() as usize,
            answer["across"].as_u64().unwrap() as usize,
        );
        let (r, z) = (list(&answer, "r_mm"), list(&answer, "z_mm"));
        assert_eq!((r.len(), z.len()), (stations * across, stations * across));
        let length = 285.0 * (1.0 - contraction);
        assert!((2.0 * z[(stations - 1) * across] / length - 1.0).abs() < 1e-12);
        assert!((answer["length_mm"].as_f64().unwrap() / length - 1.0).abs() < 1e-12);
        let turn = list(&answer, "strand_turn_rad")[stations - 1];
        assert!(
            (turn / (142.5 * 28.0_f64.to_radians().tan() / 19.0) - 1.0).abs() < 1e-12,
            "{turn}"
        );
        // Frustums between the stations of the inner surface, twice the half.
        let frustum = |j: usize| {
            let ((a, b), h) = (
                (r[j * across], r[(j + 1) * across]),
                z[(j + 1) * across] - z[j * across],
            );
            2.0 * std::f64::consts::PI / 3.0 * h * (a * a + a * b + b * b)
        };
        let volume: f64 = (0..stations - 1).map(frustum).sum();
        assert!(
            (volume / answer["volume_mm3"].as_f64().unwrap() - 1.0).abs() < 3e-4,
            "{volume}"
        );
    }
}

/// The point of a shape is the one of `force`; where the muscle is slack it hangs at its free
/// contraction.
#[test]
fn a_shape_says_what_force_says() {
    let state = json!({ "pressure_mpa": 0.2, "contraction": 0.1 });
    let (shape, force) = (reply("shape", state.clone()), reply("force", state));
    for key in [
        "model",
        "force_n",
        "uncertainty_n",
        "stiffness_n_per_mm",
        "bulged_diameter_mm",
        "warnings",
    ] {
        assert_eq!(shape[key], force[key], "{key}");
    }
    // On the branch of the muscle file's job.
    let lowers = json!({
        "pressure_mpa": 0.2,
        "contraction": 0.1,
        "muscle": { "with": ["job.branch=elongation", "job.pressure=2bar"] },
    });
    let (branch, said) = (reply("shape", lowers.clone()), reply("force", lowers));
    assert_eq!(branch["force_n"], said["force_n"]);
    assert!(branch["force_n"].as_f64() > shape["force_n"].as_f64());
    let slack = reply("shape", json!({ "pressure_mpa": 0.1, "contraction": 0.3 }));
    assert_eq!(
        (&slack["slack"], &slack["force_n"]),
        (&json!(true), &json!(0.0))
    );
    assert_eq!(slack["shape_contraction"], slack["free_contraction"]);
    // By its load: ε(F, P).
    let lifted = reply("shape", json!({ "pressure_mpa": 0.2, "force_n": 150 }));
    let point = reply(
        "contraction",
        json!({ "pressure_mpa": 0.2, "force_n": 150 }),
    );
    assert!(
        (lifted["contraction"].as_f64().unwrap() - point["contraction"].as_f64().unwrap()).abs()
            < 1e-9
    );
    let refused = ask("shape", r#"{"pressure_mpa": -0.1}"#, &Silent).unwrap_err();
    assert_eq!(
        (refused.kind, refused.field.as_deref()),
        (ProblemKind::OutOfRange, Some("pressure_mpa"))
    );
}

#[test]
fn packed_answers_hold_the_same_numbers_in_32_bits() {
    let request = json!({ "pressure_mpa": 0.2, "contraction": 0.1 });
    let plain = reply("shape", request.clone());
    let packed = ask_packed("shape", &request.to_string(), &Silent).unwrap();
    let length = u32::from_le_bytes(packed[..4].try_into().unwrap()) as usize;
    assert!(length.is_multiple_of(4));
    let head: Value = serde_json::from_slice(&packed[4..4 + length]).unwrap();
    let mut at = 4 + length;
    for (name, count) in head["arrays"].as_object().unwrap() {
        for exact in list(&plain, name) {
            let number = f32::from_le_bytes(packed[at..at + 4].try_into().unwrap());
            assert_eq!(number, exact as f32, "{name}");
            at += 4;
        }
        assert_eq!(count.as_u64().unwrap() as usize, list(&plain, name).len());
    }
    assert_eq!(at, packed.len());
    // An answer without numbers to pack is its JSON.
    let force = ask_packed("force", &request.to_string(), &Silent).unwrap();
    let text = ask("force", &request.to_string(), &Silent).unwrap();
    assert_eq!(std::str::from_utf8(&force[4..]).unwrap().trim_end(), text);
}

/// 1 psi is 6.894 757 kPa, 1 in 25.4 mm (NIST SP 811).
#[test]
fn typed_texts_are_quantities_or_say_why_not() {
    let answer = reply(
        "quantities",
        json!({ "texts": [
            { "text": "36psi", "kind": "pressure" }, { "text": "1.5 in", "kind": "length" }, { "text": "15%", "kind": "ratio" },
            { "text": "0..2:1bar", "kind": "pressure", "list": true }, { "text": "3 bar", "kind": "length" }, { "text": "NaN", "kind": "force" },
            { "text": "10..30 mm", "kind": "length", "list": true },
        ] }),
    );
    let readings = answer["readings"].as_array().unwrap();
    assert!((readings[0]["value"].as_f64().unwrap() - 36.0 * 6.894_757_293_168e-3).abs() < 1e-12);
    assert_eq!(
        (&readings[1]["value"], &readings[2]["value"]),
        (&json!(38.1), &json!(0.15))
    );
    assert_eq!(readings[3]["values"], json!([0.0, 0.1, 0.2]));
    for reading in &readings[4..6] {
        assert_eq!(reading["problem"]["kind"], "quantity", "{reading}");
    }
    // An interval without a step has its ends too; a range with one has none.
    assert_eq!(
        (&readings[6]["interval"], &readings[3]["interval"]),
        (&json!([10.0, 30.0]), &json!(null))
    );
    assert_eq!(readings[6]["values"].as_array().unwrap().len(), 21);
    let units = reply("units", json!({}));
    let pressure = units["kinds"]
        .as_array()
        .unwrap()
        .iter()
        .find(|k| k["kind"] == "pressure")
        .unwrap();
    let bar = pressure["units"]
        .as_array()
        .unwrap()
        .iter()
        .find(|u| u["name"] == "bar")
        .unwrap();
    assert_eq!(
        (&bar["multiply"], &bar["divide"]),
        (&json!(10.0), &json!(1.0))
    );
}

const PLAN: &str = "name = \"two\"\n[tube]\nlength = \"285 mm\"\nrubber \
    = \"paper\"\n[braid]\nangle = \"28 deg\"\n[sampling]\nmethod = \"factorial\"\n\
    [vary]\ntube.outer_diameter = \"30,40 mm\"\ntube.wall_thickness = \"2 \
    mm\"\n[test]\ncontractions = \"0,0.1\"\npressures = \"0.1,0.2 MPa\"\n";

#[test]
fn a_plan_in_memory_is_a_table_of_what_fe_says() {
    let answer = reply(
        "plan",
        json!({ "plan": { "name": "two.toml", "text": PLAN } }),
    );
    assert_eq!(
        (&answer["muscles"], &answer["points"], &answer["failed"]),
        (&json!(2), &json!(8), &json!(0))
    );
    let text = answer["table"]["text"].as_str().unwrap();
    let last: Vec<&str> = text.lines().last().unwrap().split(',').collect();
    let number = |i: usize| last[i].parse::<f64>().unwrap();
    let force = reply(
        "force",
        json!({ "muscle": { "outer_diameter_mm": number(0), "wall_mm": number(1) }, "pressure_mpa": number(4), "contraction": number(5), "two_sided": true }),
    );
    assert!((number(6) / force["force_n"].as_f64().unwrap() - 1.0).abs() < 1e-9);
    let large = PLAN
        .replace("30,40 mm", "30..50:0.001 mm")
        .replace("0.1,0.2", "0..0.2:0.001");
    let refused = ask(
        "plan",
        &json!({ "plan": { "name": "large.toml", "text": large } }).to_string(),
        &Silent,
    );
    assert_eq!(refused.unwrap_err().kind, ProblemKind::Range);
}

#[test]
fn what_names_files_of_the_machine_is_known() {
    let touches = |name: &str, request: Value| {
        mckibben_app::COMMANDS
            .iter()
            .find(|c| c.name == name)
            .unwrap()
            .touches_disk(&request)
    };
    for name in ["campaign", "campaign-show", "campaign-merge"] {
        assert!(touches(name, json!({})), "{name}");
    }
    assert!(touches("fit", json!({ "campaign": "/etc/passwd" })));
    assert!(!touches(
        "fit",
        json!({ "campaign": null, "table": { "name": "a.csv", "text": "" } })
    ));
    assert!(!touches("force", json!({ "pressure_mpa": 0.2 })) && !touches("plan", json!({})));
}

#[test]
fn a_report_holds_the_answers_of_its_commands() {
    let request = json!({ "muscle": { "outer_diameter_mm": 38, "wall_mm": 1 }, "pressure_mpa": 0.2, "contraction": 0.1, "units": "bar", "report": true });
    let request = serde_json::from_value(request).unwrap();
    let report = mckibben_app::build(&request, &Silent)
        .unwrap()
        .document
        .unwrap();
    let force = reply(
        "force",
        json!({ "muscle": { "outer_diameter_mm": 38, "wall_mm": 1 }, "pressure_mpa": 0.2, "contraction": 0.1 }),
    );
    let row = |part: &Part| match part {
        Part::Table { rows, .. } => Some(rows[0][1].clone()),
        _ => None,
    };
    let pull = report.parts.iter().find_map(row).unwrap();
    let shown: f64 = pull.split_whitespace().next().unwrap().parse().unwrap();
    let off = shown - force["predicted_n"].as_f64().unwrap();
    assert!(off.abs() <= 5.0 && !pull.contains('±'), "{pull}");
    let heading = |part: &Part| match part {
        Part::Heading(text) => Some(text.clone()),
        _ => None,
    };
    let headings: Vec<String> = report.parts.iter().filter_map(heading).collect();
    assert_eq!(
        headings,
        [
            "Performance",
            "Margins of safety",
            "Curves",
            "Assumptions and limits"
        ]
    );
    assert!(report.footer.contains("SHA-256"));
}

/// Identity: the file that `check` writes of a file and fields is the same muscle again, and pulls
/// the same.
#[test]
fn a_written_muscle_file_is_file_and_fields_in_one() {
    let file = "[tube]\nouter_diameter = \"20 mm\"\nwall_thickness = \"1.5 mm\"\nlength = \"150 \
        mm\"\n[tube.material]\n\
                law = \"neo-hookean\"\nmu = \"0.4 MPa\"\n[braid]\nname = \"nfl-19\"\nstiffness = \
                400\n[terminals]\nseating = 0.5\nslip = \"1 mm/kN\"\n";
    let fields = json!({ "muscle": { "file": { "name": "mine.toml", "text": file }, "length_mm": 160.2, "grip_mm": 2 } });
    let shown = |mut request: Value| {
        request["muscle_file"] = true.into();
        request["only_data"] = true.into();
        reply("check", request)
    };
    let first = shown(fields.clone());
    let written = first["muscle_file"].clone();
    let again = json!({ "muscle": { "file": { "name": "again.toml", "text": written } } });
    assert_eq!(shown(again.clone()), first);
    assert_eq!(
        [
            &first["sleeve"],
            &first["length_mm"],
            &first["seating_mm"],
            &first["grip_mm"]
        ],
        [&json!("nfl-19"), &json!(160.2), &json!(0.5), &json!(2.0)]
    );
    let pull = |muscle: &Value| {
        let mut request = muscle.clone();
        request["pressure_mpa"] = 0.2.into();
        request["contraction"] = 0.05.into();
        reply("force", request)["force_n"].as_f64().unwrap()
    };
    assert!((pull(&again) / pull(&fields) - 1.0).abs() < 1e-12);
    // Where nobody asks for it, there is none.
    assert!(reply("check", fields).get("muscle_file").is_none());
}

/// Identity: each isobaric curve names its free contraction from its first slack point on, and no
/// pull is left there.
#[test]
fn an_isobaric_curve_names_its_free_contraction_at_its_first_slack_point() {
    let request = json!({ "test": "isobaric", "model": "thick-wall", "pressures_mpa": [0.05, 0.25], "contractions": [0.0, 0.1, 0.2, 0.33] });
    let answer = reply("curve", request);
    let points = answer["points"].as_array().unwrap();
    for curve in points.chunks(4) {
        let slack = curve.iter().find(|q| q["slack"] == true).unwrap();
        let free = slack["free_contraction"].as_f64().unwrap();
        let at =
            json!({ "model": "thick-wall", "pressure_mpa": slack["pressure_mpa"], "force_n": 0 });
        assert!((reply("contraction", at)["contraction"].as_f64().unwrap() - free).abs() < 1e-9);
    }
}
