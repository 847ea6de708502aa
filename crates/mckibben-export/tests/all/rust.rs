//! The target `rust`: it compiles without `std`, does not panic, and its numbers are those of C and of the form.

use super::{
    files::{ROPED, compare_rows, compiled_and_run, numbers, points, runs, with_friction, write},
    joint::elbow_by_universal,
};
use mckibben_core::random::{Random, rounds};
use mckibben_export::{ExportedMuscle, Form};
use std::{fmt::Write as _, path::Path, process::Command};

/// Precisions: of Rust, of C.
const PRECISIONS: [(&str, &str); 2] = [
    ("mckibben_double", "-DMCKIBBEN_DOUBLE"),
    ("mckibben_float", "-DMCKIBBEN_FLOAT"),
];

/// Calls rustc in a folder; no warning is allowed.
pub fn rustc(folder: &Path, arguments: &[&str]) {
    let done = Command::new("rustc")
        .args(["-D", "warnings", "-O"])
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap();
    assert!(
        done.status.success(),
        "{arguments:?}: {}",
        String::from_utf8_lossy(&done.stderr)
    );
}

/// What a program of Rust prints that has the exported file as a module.
pub fn printed(folder: &Path, main: &str, precision: &str) -> String {
    std::fs::write(folder.join("main.rs"), main).unwrap();
    rustc(
        folder,
        &[
            "--edition",
            "2021",
            "main.rs",
            "-o",
            "main",
            "--cfg",
            precision,
        ],
    );
    let out = Command::new(folder.join("main")).output().unwrap();
    assert!(out.status.success(), "{out:?}");
    String::from_utf8(out.stdout).unwrap()
}

/// As of C: pull, stiffness, dF/dP, volume, pressure of the pull and status.
fn compare_with_rust(precision: &str, tolerance: f64) {
    if !runs("rustc") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    write(&ROPED, "rust", folder.path());
    for (beyond, at) in [
        (false, Form::point_at as fn(&Form, _, _) -> _),
        (true, Form::beyond),
    ] {
        let places = Vec::from_iter(points().iter().map(|(p, l)| [*p, l + ROPED.cord_m]));
        let main = format!(
            "mod muscle_prototype;\nuse muscle_prototype::*;\nfn main() {{\nlet m = &Muscle {{ \
             beyond: {beyond}, ..MUSCLE_PROTOTYPE }};\nfor [p, l] in {places:?} as [[Real; 2]; {}] \
             {{\nlet f = nearest(m.force_n(p, l));\nprintln!(\"{{:e}} {{:e}} {{:e}} {{:e}} {{:e}} \
             {{}}\", f, nearest(m.stiffness_n_per_m(p, l)), nearest(m.force_per_pressure_m2(p, l)), \
             nearest(m.volume_m3(p, l)), nearest(m.pressure_pa(f, l)), m.status(p, l));\n}}\n}}\n",
            places.len()
        );
        let rows = numbers(&printed(folder.path(), &main, precision));
        compare_rows(&rows, tolerance, at);
    }
}

#[test]
fn rust_in_double_precision_is_the_form_to_1e_12() {
    compare_with_rust("mckibben_double", 1e-12);
}

#[test]
fn rust_in_single_precision_errs_by_less_than_1e_4() {
    compare_with_rust("mckibben_float", 1e-4);
}

/// Each file is a crate of its own and a module of one, in every edition, without a warning, and
/// tests itself; its code holds no call of a panic.
#[test]
fn files_of_rust_need_no_std_test_themselves_and_do_not_panic() {
    if !runs("rustc") {
        return;
    }
    let check = |folder: &Path, file: &str, calls: &str| {
        let name = file.strip_suffix(".rs").unwrap();
        std::fs::write(
            folder.join("firmware.rs"),
            format!("#![no_std]\nmod {name};\nuse {name}::*;\n{calls}"),
        )
        .unwrap();
        for (precision, _) in PRECISIONS {
            for edition in ["2015", "2021", "2024"] {
                for root in [file, "firmware.rs"] {
                    let library = [
                        "--edition",
                        edition,
                        "--cfg",
                        precision,
                        "--crate-type",
                        "lib",
                    ];
                    let arguments = [&library[..], &["--emit", "metadata", root]].concat();
                    rustc(folder, &arguments);
                }
            }
            rustc(folder, &["--test", file, "-o", "tests", "--cfg", precision]);
            let tested = Command::new(folder.join("tests")).output().unwrap();
            let said = String::from_utf8_lossy(&tested.stdout).into_owned();
            assert!(
                tested.status.success() && said.contains("1 passed"),
                "{said}"
            );
            let library = ["--crate-type", "lib", "--emit", "asm", "-o", "firmware.s"];
            for root in [file, "firmware.rs"] {
                rustc(
                    folder,
                    &[&library[..], &["--cfg", precision, root]].concat(),
                );
                let code = std::fs::read_to_string(folder.join("firmware.s")).unwrap();
                assert!(!code.contains("panic"), "{root} {precision}");
            }
        }
    };
    let folder = tempfile::tempdir().unwrap();
    write(&with_friction(), "rust", folder.path());
    check(
        folder.path(),
        "muscle_prototype.rs",
        "pub fn use_it(p: Real, l: Real) -> Answer { MUSCLE_PROTOTYPE.force_n(p, l) }\n",
    );
    elbow_by_universal(0.3, &["rust"], |folder, _| {
        let calls = "pub fn use_it(a: Real, t: Real, k: Real) -> [Real; 2] { let p = \
            nearest(JOINT_ELBOW.pressures_pa(a, t, Some(k))); [nearest(JOINT_ELBOW.torque_nm(p, \
            a)), nearest(JOINT_ELBOW.stiffness_nm_per_rad(p, a))] }\npub fn rest(p: [Real; 2], a: \
            Real) -> [Real; 4] { let [c, d] = nearest(JOINT_ELBOW.reached_nm_per_rad(a, \
            p[0])); let [e, _] = JOINT_ELBOW.limits_nm(a); let [f, _] = \
            nearest(JOINT_ELBOW.torque_per_pressure_m3(p, a)); [c, d, e, f + \
            nearest(JOINT_ELBOW.friction_nm(p, a, 1.0, 0.1))] }\n";
        check(folder, "joint_elbow.rs", calls);
    });
}

/// What both print: bits of numbers, where there is one, and a status.
const C_SAYS: &str = r#"
#include <string.h>
#include <stdio.h>
#include <math.h>
static unsigned s;
static void say(mckibben_real value) {
    unsigned long long bits = 0;
    memcpy(&bits, &value, sizeof value);
    if (value <= 0 && value >= 0) bits = 0; /* of both zeros one */
    if (value != value) printf("none %u\n", s); else printf("%llx %u\n", bits, s);
    s = 0;
}
"#;
const RUST_SAYS: &str = r#"
fn say(answer: Answer) {
    let status = answer.err().map_or(0, |o| o.status);
    let value = nearest(answer);
    let bits = if value == 0.0 { 0 } else { value.to_bits() };
    if value.is_nan() { println!("none {status}") } else { println!("{bits:x} {status}") }
}
"#;

/// Programs of C and of Rust that print each function of a muscle at places of pressure, length,
/// pull and velocity.
fn mains(muscle: &ExportedMuscle, places: &[[f64; 4]]) -> [String; 2] {
    let id = muscle.identifier();
    let mut table = [String::new(), String::new()];
    for place in places {
        let c = place.map(|v| format!("MCKIBBEN_R({v:e})").replace("inf", "INFINITY"));
        let rust = place.map(|v| format!("{v:e}").replace("inf", "Real::INFINITY"));
        let _ = writeln!(table[0], "{{{}}},", c.join(", ").replace("NaN", "NAN"));
        let _ = writeln!(
            table[1],
            "[{}],",
            rust.join(", ").replace("NaN", "Real::NAN")
        );
    }
    let count = places.len();
    // Slack alone is no error in Rust.
    let c = format!(
        "#include \"{id}.h\"\n{C_SAYS}#define SAY(call) do {{ const mckibben_real found = (call); s = \
         s == 1u ? 0u : s; say(found); }} while (0)\nint main(void) {{\nstatic const mckibben_real \
         places[{count}][4] = {{\n{}}};\nfor (int beyond = 0; beyond < 2; beyond++) \
         {{\nmckibben_muscle own = {id};\nconst mckibben_muscle *m = &own;\nown.beyond = \
         beyond;\nfor (int i = 0; i < {count}; i++) {{\nconst mckibben_real p = places[i][0], l = \
         places[i][1], f = places[i][2], v = places[i][3];\nSAY(mckibben_force(m, p, l, &s)); \
         SAY(mckibben_stiffness(m, p, l, &s)); SAY(mckibben_force_per_pressure(m, p, l, &s)); \
         SAY(mckibben_volume(m, p, l, &s)); SAY(mckibben_pressure(m, f, l, &s)); \
         SAY(mckibben_contraction(m, f, p, &s)); SAY(mckibben_friction(m, p, l, v, \
         MCKIBBEN_R(0.001), &s)); SAY(mckibben_pressure_on(m, f, l, -1, &s)); \
         SAY(mckibben_pressure_on(m, f, l, 0, &s)); SAY(mckibben_pressure_on(m, f, l, 1, \
         &s));\n}}\n}}\nreturn 0;\n}}\n",
        table[0]
    );
    let rust = format!(
        "mod {id};\nuse {id}::*;\n{RUST_SAYS}static PLACES: [[Real; 4]; {count}] = [\n{}];\nfn \
         main() {{\nfor beyond in [false, true] {{\nlet m = &Muscle {{ beyond, ..{} }};\nfor [p, l, \
         f, v] in PLACES {{\nsay(m.force_n(p, l)); say(m.stiffness_n_per_m(p, l)); \
         say(m.force_per_pressure_m2(p, l)); say(m.volume_m3(p, l)); say(m.pressure_pa(f, l)); \
         say(m.contraction(f, p)); say(m.friction_n(p, l, v, 0.001)); \
         say(m.pressure_on_branch_pa(f, l, Branch::Shortening)); say(m.pressure_on_branch_pa(f, l, \
         Branch::Mean)); say(m.pressure_on_branch_pa(f, l, Branch::Lengthening));\n}}\n}}\n}}\n",
        table[1],
        id.to_ascii_uppercase()
    );
    [c, rust]
}

/// An identity: each function has the bits of C, in both precisions, in the box, outside of it and
/// of what is not a number; of a muscle with friction and a cord.
#[test]
fn identity_rust_has_the_bits_of_c() {
    if !runs("rustc") || !runs("cc") {
        return;
    }
    let mut muscle = with_friction();
    muscle.cord_m = 0.06;
    let (form, folder) = (&muscle.form, tempfile::tempdir().unwrap());
    for target in ["c", "rust"] {
        write(&muscle, target, folder.path());
    }
    let mut random = Random(11);
    let mut places = Vec::from_iter((0..rounds(400)).map(|_| {
        let low = form.contraction_low - 0.03;
        let contraction = random.between(low, form.contraction_high + 0.05);
        [
            form.supply_pa * random.between(-0.2, 1.2),
            muscle.cord_m + (1.0 - contraction) * form.length_m,
            muscle.blocked_force_n * random.between(-0.1, 1.3),
            random.between(-0.01, 0.01),
        ]
    }));
    let wrong = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, 1e-320];
    for (i, value) in (0..4).flat_map(|i| wrong.map(|value| (i, value))) {
        let mut place = places[i];
        place[i] = value;
        places.push(place);
    }
    let [c, rust] = mains(&muscle, &places);
    for (precision, flag) in PRECISIONS {
        let arguments = [
            "-ffp-contract=off",
            "-O1",
            "-Wno-float-conversion",
            "mckibben.c",
            flag,
        ];
        let by_c = compiled_and_run(folder.path(), &c, &arguments);
        let by_rust = printed(folder.path(), &rust, precision);
        assert_eq!(by_c.lines().count(), 20 * places.len());
        for (i, (wanted, found)) in by_c.lines().zip(by_rust.lines()).enumerate() {
            let place = places[i / 10 % places.len()];
            assert_eq!(
                found,
                wanted,
                "{precision}: function {} at {place:?}",
                i % 10
            );
        }
        assert_eq!(by_c.len(), by_rust.len());
    }
}

/// An identity: the root of the file is that of IEEE 754, to the last bit, of numbers of all sizes;
/// its sine and cosine are those of the standard library in double precision within the distance of
/// neighbouring numbers at 1.
#[test]
fn identity_root_sine_and_cosine_of_rust() {
    if !runs("rustc") {
        return;
    }
    let main = "mod joint_elbow;\nuse joint_elbow::*;\nfn main() {\nlet mut state = \
        0x9e37_79b9_7f4a_7c15_u64;\nlet mut next = || { state ^= state << 13; state ^= state >> 7; \
        state ^= state << 17; state };\nlet special = [0.0, 1.0, 2.0, 4.0, Real::MIN_POSITIVE, \
        Real::MAX, Real::INFINITY, 1.0 - Real::EPSILON / 2.0, 1.0 + Real::EPSILON];\nfor i in \
        0..300_000 {\nlet value = special.get(i).copied().unwrap_or_else(|| Real::from_bits(next() \
        as _)).abs();\nassert!(root_of(value).to_bits() == value.sqrt().to_bits() || \
        value.is_nan() && root_of(value).is_nan(), \"{value:e}\");\n}\n\
        assert!(root_of(-1.0).is_nan());\nlet mut most = 0.0_f64;\nfor i in -300_000..=300_000 \
        {\nlet angle = i as Real / 3e3;\nlet (s, c) = turned(angle);\nlet (sine, cosine) = (angle as \
        f64).sin_cos();\nmost = most.max((s as f64 - sine).abs()).max((c as f64 - \
        cosine).abs());\n}\nassert!(turned(Real::INFINITY).0.is_nan());\nprintln!(\"{}\", most / \
        Real::EPSILON as f64);\n}\n";
    elbow_by_universal(0.3, &["rust"], |folder, _| {
        let file = folder.join("joint_elbow.rs");
        let text = std::fs::read_to_string(&file).unwrap()
            + "pub fn root_of(value: Real) -> Real { root(value) }\npub fn turned(angle: Real) -> (Real, \
               Real) { sine_and_cosine(angle) }\n";
        std::fs::write(file, text).unwrap();
        for (precision, _) in PRECISIONS {
            let most: f64 = printed(folder, main, precision).trim().parse().unwrap();
            println!("{precision}: sine and cosine within {most} units in the last place of 1");
            assert!(most <= 1.0, "{precision}: {most}");
        }
    });
}

/// An identity: torque, stiffness, slopes, limits, friction and pressures of a joint are those of C
/// at random states, as near as rounding of sine and cosine lets them.
#[test]
fn identity_joints_of_rust_are_those_of_c() {
    if !runs("rustc") || !runs("cc") {
        return;
    }
    let mut random = Random(12);
    let states = Vec::from_iter((0..rounds(300)).map(|_| {
        [
            random.between(-1.2, 1.2),
            random.between(-1e4, 3.2e5),
            random.between(-1e4, 3.2e5),
            random.between(-6.0, 6.0),
        ]
    }));
    let table = |open: &str, close: &str| {
        let row = |s: &[f64; 4]| {
            format!(
                "{open}{:e}, {:e}, {:e}, {:e}{close}",
                s[0], s[1], s[2], s[3]
            )
        };
        states.iter().map(row).collect::<Vec<_>>().join(",\n")
    };
    let count = states.len();
    let c = format!(
        "#include \"joint_elbow.h\"\n#include <stdio.h>\nstatic const double states[{count}][4] = \
         {{{}}};\nint main(void) {{\nfor (int i = 0; i < {count}; i++) {{\nconst mckibben_joint *j = \
         &joint_elbow;\nconst mckibben_real a = MCKIBBEN_R(states[i][0]), p[2] = \
         {{MCKIBBEN_R(states[i][1]), MCKIBBEN_R(states[i][2])}}, t = \
         MCKIBBEN_R(states[i][3]);\nmckibben_real k, d[2], l[2], q[2], r[2];\nunsigned s, \
         u;\nconst mckibben_real torque = mckibben_joint_torque(j, p, a, &k, d, \
         &s);\nmckibben_joint_limits(j, a, l);\nmckibben_joint_pressures(j, a, t, MCKIBBEN_R(9), q, r, \
         &u);\nprintf(\"%.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %u %u\\n\", \
         (double)torque, (double)k, 1e6 * (double)d[0], 1e6 * (double)d[1], (double)l[0], \
         (double)l[1], (double)mckibben_joint_friction(j, p, a, MCKIBBEN_R(1), MCKIBBEN_R(0.1)), 1e-5 \
         * (double)q[0], 1e-5 * (double)q[1], (double)r[1], s & ~1u, u & ~1u);\n}}\nreturn 0;\n}}\n",
        table("{", "}")
    );
    let rust = format!(
        "mod joint_elbow;\nuse joint_elbow::*;\nstatic STATES: [[f64; 4]; {count}] = [{}];\nfn main() \
         {{\nlet j = &JOINT_ELBOW;\nlet why = |a: Answer<[Real; 2]>| a.err().map_or(0, |o| \
         o.status & !1);\nfor s in STATES {{\nlet [a, p, q, t] = s.map(|v| v as Real);\nlet p = [p, \
         q];\nlet [d, e] = nearest(j.torque_per_pressure_m3(p, a)).map(f64::from);\nlet l = \
         j.limits_nm(a);\nlet q = j.pressures_pa(a, t, Some(9.0));\nlet [v, w] = \
         nearest(q).map(f64::from);\nprintln!(\"{{}} {{}} {{}} {{}} {{}} {{}} {{}} {{}} {{}} {{}} {{}} \
         {{}}\", nearest(j.torque_nm(p, a)), nearest(j.stiffness_nm_per_rad(p, a)), 1e6 * d, 1e6 * e, \
         l[0], l[1], nearest(j.friction_nm(p, a, 1.0, 0.1)), 1e-5 * v, 1e-5 * w, \
         nearest(j.reached_nm_per_rad(a, t))[1], j.status(p, a) & !1, why(q));\n}}\n}}\n",
        table("[", "]")
    );
    elbow_by_universal(0.3, &["c", "rust"], |folder, _| {
        // With a friction that the example does not state.
        let list = |numbers: [&str; 7]| numbers.map(|n| format!("MCKIBBEN_R({n})")).join(", ");
        let none = list(["0e0", "0e0", "0e0", "0e0", "0e0", "0e0", "5e-4"]);
        let some = list(["30", "0", "0", "5", "0", "0", "5e-4"]);
        for (name, from, to) in [
            ("muscle_elbow_1.h", none.as_str(), some.as_str()),
            ("muscle_elbow_2.h", none.as_str(), some.as_str()),
            (
                "joint_elbow.rs",
                "friction: [0e0, 0e0, 0e0, 0e0, 0e0, 0e0, 5e-4]",
                "friction: [30.0, 0.0, 0.0, 5.0, 0.0, 0.0, 5e-4]",
            ),
        ] {
            let text = std::fs::read_to_string(folder.join(name)).unwrap();
            assert!(text.contains(from));
            std::fs::write(folder.join(name), text.replace(from, to)).unwrap();
        }
        for ((precision, flag), near) in PRECISIONS.into_iter().zip([1e-13, 1e-5]) {
            let arguments = ["-ffp-contract=off", "-O1", "mckibben.c", flag];
            let by_c = numbers(&compiled_and_run(folder, &c, &arguments));
            let by_rust = numbers(&printed(folder, &rust, precision));
            assert!(by_c.len() == count && by_rust.len() == count);
            let mut most = [0.0_f64; 12];
            for ((wanted, found), state) in by_c.iter().zip(&by_rust).zip(&states) {
                for (most, (a, b)) in most.iter_mut().zip(wanted.iter().zip(found)) {
                    *most = most.max((a - b).abs());
                }
                assert_eq!(wanted[10..], found[10..], "{precision} {state:?}");
            }
            assert!(by_rust.iter().any(|row| row[6].abs() > 0.1));
            println!("{precision}: {most:?}");
            assert!(most.iter().all(|off| *off <= near), "{precision}: {most:?}");
        }
    });
}
