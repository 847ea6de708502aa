//! A joint: against `joint` of the program.

use super::{
    fe,
    files::{compiled_and_run, numbers, python, runs},
    rust::{printed, rustc},
};
use mckibben_core::{
    joint::{BoundJoint, Joint, Turning, parse_joint},
    model::ForceModel,
    model::ModelKind,
    muscle::{Muscle, file::parse_muscle},
    random::{Random, rounds},
};
use mckibben_export::{ExportTarget, ExportedJoint};
use std::sync::Arc;

/// Two muscles on pulleys with a weight; a muscle between two points against a spring on a rope;
/// one on a pulley against a torsion spring.
const JOINTS: [&str; 3] = [
    "[joint]\nradius = '25 mm'\nrange = '-60..60 deg'\n[link]\nmass = '1.2 kg'\ncentre = '150 \
     mm'\ninclination = '-70 deg'\npayload = '0.5 kg'\npayload_at = '300 mm'\n\
     [muscle_1]\nfile = 'm'\ncontraction_at_neutral = '12%'\n[muscle_2]\nfile = \
     'm'\ncontraction_at_neutral = '10%'\nradius = '20 mm'\n",
    "[joint]\nrange = '-20..30 deg'\n[link]\nmass = '0.4 kg'\ncentre = '90 mm'\n[muscle_1]\nfile = \
     'm'\norigin = ['-20 mm', '250 mm']\ninsertion = ['-35 mm', '5 mm']\ncontraction_at_neutral = \
     '9%'\n\
     [muscle_2]\nfile = 'm'\norigin = ['25 mm', '250 mm']\ninsertion = ['30 mm', '5 \
     mm']\ncontraction_at_neutral = '9%'\n[spring]\nrate = '2 N/mm'\npreload = '30 N'\norigin = \
     ['40 mm', '100 mm']\ninsertion = ['25 mm', '10 mm']\n",
    "[joint]\nradius = '15 mm'\nrange = '0..80 deg'\n[muscle_1]\nfile = \
     'm'\ncontraction_at_neutral = '2%'\n[spring]\nangular_rate = '2 N m/rad'\npreload_torque = \
     '0.7 N m'\n",
];
const SUPPLY_MPA: f64 = 0.3;

/// Torque, stiffness, slopes in the pressures, and least and largest torque; or pressures for a
/// torque and a stiffness, and whether there are some.
type Rows = [Vec<Vec<f64>>; 2];

fn by_c(folder: &std::path::Path, states: &[[f64; 3]], wanted: &[[f64; 3]]) -> Rows {
    let mut main = "#include \"joint_elbow.h\"\n#include <stdio.h>\nstatic void at(double a, \
        double p1, double p2) { double k, d[2] = {0}, t[2]; const double p[2] = {p1, p2}; unsigned \
        s; const double q = mckibben_joint_torque(&joint_elbow, p, a, &k, d, &s); \
        mckibben_joint_limits(&joint_elbow, a, t); printf(\"%.17g %.17g %.17g %.17g %.17g %.17g \
        %u\\n\", q, k, d[0], d[1], t[0], t[1], s); }\nstatic void sought(double a, double t, \
        double k) { double p[2]; unsigned s; mckibben_joint_pressures(&joint_elbow, a, t, k, p, 0, \
        &s); printf(\"%.17g %.17g %u\\n\", p[0], p[1], s); }\nint main(void) {\n"
        .to_owned();
    for (name, rows) in [("at", states), ("sought", wanted)] {
        main.extend(
            rows.iter()
                .map(|[a, b, c]| format!("{name}({a:e}, {b:e}, {c:e});\n")),
        );
    }
    let rows = numbers(&compiled_and_run(
        folder,
        &(main + "return 0; }\n"),
        &["-O1", "mckibben.c"],
    ));
    let (first, second) = rows.split_at(states.len());
    [first.to_vec(), second.to_vec()]
}

fn by_python(folder: &std::path::Path, states: &[[f64; 3]], wanted: &[[f64; 3]]) -> Option<Rows> {
    let script = format!(
        "import numpy as n, joint_elbow as j\na, *p = n.array({states:?}).T\np = \
         p[:len(j.MUSCLES)]\nd = [*j.torque_per_pressure(p, a), 0 * a][:2]\nfor r in \
         zip(j.torque(p, a), j.stiffness(p, a), *d, *j.limits(a), j.status(p, a)): \
         print(*map(float, r))\na, t, k = n.array({wanted:?}).T\nfor \
         r in zip(*[*j.pressures(a, t, k), 0 * a][:2], j.pressures_status(a, t, k)): \
         print(*map(float, r))\n"
    );
    let rows = python(folder, "numpy", &script)?;
    let (first, second) = rows.split_at(states.len());
    Some([first.to_vec(), second.to_vec()])
}

fn by_rust(
    folder: &std::path::Path,
    count: usize,
    states: &[[f64; 3]],
    wanted: &[[f64; 3]],
) -> Rows {
    let main = format!(
        "mod joint_elbow;\nuse joint_elbow::*;\nfn main() {{\nlet j = &JOINT_ELBOW;\nfor [a, p1, p2] in \
         {states:?} as [[f64; 3]; {}] {{\nlet p: [Real; {count}] = std::array::from_fn(|i| [p1, \
         p2][i]);\nlet d = nearest(j.torque_per_pressure_m3(p, a));\nlet l = \
         j.limits_nm(a);\nprintln!(\"{{}} {{}} {{}} {{}} {{}} {{}} {{}}\", nearest(j.torque_nm(p, a)), \
         nearest(j.stiffness_nm_per_rad(p, a)), d[0], d.get(1).unwrap_or(&0.0), l[0], l[1], \
         j.status(p, a));\n}}\nfor [a, t, k] in {wanted:?} as [[f64; 3]; {}] {{\nlet p = \
         j.pressures_pa(a, t, Some(k));\nlet s = p.err().map_or(0, |o| \
         o.status);\nlet p = nearest(p);\nprintln!(\"{{}} {{}} {{s}}\", p[0], \
         p.get(1).unwrap_or(&0.0));\n}}\n}}\n",
        states.len(),
        wanted.len(),
    );
    let rows = numbers(&printed(folder, &main, "mckibben_double"));
    let (first, second) = rows.split_at(states.len());
    [first.to_vec(), second.to_vec()]
}

/// At random states (1000 with `MCKIBBEN_TIMES=10`) torque and stiffness of C, Rust and Python are those
/// of `joint` by finite elements within the stated errors, slopes in the pressures by differences;
/// the pressures for a torque and a stiffness give them in `joint`.
#[test]
fn c_rust_and_python_are_the_joint_of_the_program_within_the_stated_errors() {
    for (i, text) in JOINTS.iter().enumerate() {
        let muscle: Muscle =
            parse_muscle(include_str!("../../../../examples/biceps.toml")).unwrap();
        let file = parse_joint(text).unwrap();
        let joint: Joint = file
            .with_muscles(file.files().map(|_| muscle.clone()).collect())
            .unwrap();
        let model = fe(&muscle);
        let models: Vec<&dyn ForceModel> = joint.muscles().iter().map(|_| &*model).collect();
        let exported = ExportedJoint::fit(&joint, &models, "elbow", SUPPLY_MPA).unwrap();
        let shared = joint.muscles().iter().map(|_| Arc::from(fe(&muscle)));
        let core = BoundJoint::new(joint.clone(), shared.collect(), true).unwrap();
        let (folder, w) = (tempfile::tempdir().unwrap(), &mut core.workspaces());
        for target in ["c", "rust", "python"] {
            for file in exported
                .to(ExportTarget::named(target).unwrap())
                .unwrap()
                .files
            {
                std::fs::write(folder.path().join(file.name), file.content.bytes()).unwrap();
            }
        }
        let mut random = Random(i as u64);
        let (low, high) = joint.range_deg();
        let count = core.joint().muscles().len();
        let states = Vec::from_iter((0..rounds(100)).map(|_| {
            let p = [0, 1].map(|_| SUPPLY_MPA * random.between(0.0, 1.0));
            [
                random.between(low, high).to_radians(),
                1e6 * p[0],
                1e6 * p[1],
            ]
        }));
        let at = |[a, p1, p2]: [f64; 3], w: &mut _| {
            core.point_at(
                w,
                &[1e-6 * p1, 1e-6 * p2][..count],
                a.to_degrees(),
                Turning::Mean,
            )
            .unwrap()
        };
        let points = Vec::from_iter(states.iter().map(|state| at(*state, w)));
        // What is sought is what a state has, with one muscle its torque alone.
        let wanted = Vec::from_iter(states.iter().zip(&points).map(|(state, point)| {
            [
                state[0],
                point.torque_nm,
                if count == 1 {
                    0.0
                } else {
                    point.stiffness_nm_per_rad
                },
            ]
        }));
        let mut hosts = vec![];
        hosts.extend(runs("cc").then(|| by_c(folder.path(), &states, &wanted)));
        hosts.extend(runs("rustc").then(|| by_rust(folder.path(), count, &states, &wanted)));
        hosts.extend(by_python(folder.path(), &states, &wanted));
        let (torque_nm, stiffness) = (
            exported.torque_error_nm,
            exported.stiffness_error_nm_per_rad,
        );
        let blocked_n = exported.muscles[0].blocked_force_n;
        let smooth = |point: &mckibben_core::joint::JointPoint| {
            let pulls = |m: &mckibben_core::joint::MuscleState| {
                m.answer.slack || m.answer.response.force_n > 0.021 * blocked_n
            };
            point.muscles.iter().all(pulls)
        };
        for [rows, found] in hosts {
            let mut compared = [0; 2];
            for (k, (row, point)) in rows.iter().zip(&points).enumerate() {
                assert!(
                    (row[0] - point.torque_nm).abs() <= torque_nm,
                    "{i} {k}: {row:?} {}",
                    point.torque_nm
                );
                assert!(
                    row[4] <= row[0] + 1e-9 && row[0] <= row[5] + 1e-9,
                    "{i} {k}: {row:?}"
                );
                if smooth(point) {
                    let off = (row[1] - point.stiffness_nm_per_rad).abs();
                    assert!(off <= stiffness, "{i} {k}: {off} {stiffness} {row:?}");
                    compared[0] += 1;
                }
            }
            for (k, (row, [angle, torque, sought])) in found.iter().zip(&wanted).enumerate() {
                // What the program's joint does at the pressures. A torque at the edge of the reach
                // may lie beyond that of the form.
                let there = at([*angle, row[0], row[1]], w);
                if row[2] == 0.0 {
                    assert!(
                        (there.torque_nm - torque).abs() <= torque_nm,
                        "{i} {k}: {} {torque} {row:?}",
                        there.torque_nm
                    );
                    let off = (there.stiffness_nm_per_rad - sought).abs();
                    assert!(
                        count == 1 || !smooth(&there) || off <= stiffness,
                        "{i} {k}: {off} {row:?}"
                    );
                    compared[1] += 1;
                }
            }
            let least = states.len() / 2;
            assert!(
                rows.len() == states.len()
                    && found.len() == states.len()
                    && compared.iter().all(|n| *n > least),
                "{i}: {compared:?}"
            );
        }
    }
}

/// The elbow of the examples by its model `universal`, exported.
pub fn elbow_by_universal(
    supply_mpa: f64,
    targets: &[&str],
    test: impl Fn(&std::path::Path, &BoundJoint),
) {
    named_by_universal("elbow", supply_mpa, targets, test);
}

/// The same under another name.
fn named_by_universal(
    name: &str,
    supply_mpa: f64,
    targets: &[&str],
    test: impl Fn(&std::path::Path, &BoundJoint),
) {
    let muscle: Muscle = parse_muscle(include_str!("../../../../examples/biceps.toml")).unwrap();
    let file = parse_joint(include_str!("../../../../examples/elbow.toml")).unwrap();
    let joint = file.with_muscles(vec![muscle.clone(); 2]).unwrap();
    let model: Arc<dyn ForceModel> = ModelKind::Universal.build(&muscle).unwrap().into();
    let models: Vec<&dyn ForceModel> = vec![&*model; 2];
    let exported = ExportedJoint::fit(&joint, &models, name, supply_mpa).unwrap();
    let core = BoundJoint::new(joint.clone(), vec![model.clone(); 2], true).unwrap();
    let folder = tempfile::tempdir().unwrap();
    for target in targets {
        for file in exported
            .to(ExportTarget::named(target).unwrap())
            .unwrap()
            .files
        {
            std::fs::write(folder.path().join(file.name), file.content.bytes()).unwrap();
        }
    }
    test(folder.path(), &core);
}

/// Both muscles pull from 10.8 N m/rad on and one is slack at 5.8, as the joint of the program has
/// it: between the two the stiffness jumps, and no pressures give what lies there. Of any answer
/// the stiffness of the form itself at its pressures is that which was sought.
#[test]
fn identity_what_the_inverse_answers_the_joint_does_and_a_jump_is_no_answer() {
    elbow_by_universal(0.3, &["c", "python"], |folder, _| {
        let mut random = Random(68);
        let mut wanted = vec![[-1.03, -1.4, 9.0], [-1.03, -1.4, 8.0], [-1.03, -1.4, 11.0]];
        wanted.extend((0..rounds(1500)).map(|_| {
            [
                random.between(-1.04, 1.04),
                random.between(-6.0, 6.0),
                random.between(2.0, 20.0),
            ]
        }));
        let mut main = "#include \"joint_elbow.h\"\n#include <stdio.h>\n#include <math.h>\nstatic \
            double nearest(double a, double t, double k) { double best = 1e9; for (int i = 0; i < \
            400; i++) { mckibben_real p[2] = {(mckibben_real)(1e5 * i / 133.0), 0}, low = 0, high = \
            (mckibben_real)3e5, there, q = 0; for (int n = 0; n < 40; n++) { p[1] = \
            MCKIBBEN_R(0.5) * (low + high); q = mckibben_joint_torque(&joint_elbow, p, \
            (mckibben_real)a, &there, 0, 0); if ((double)q > t) low = p[1]; else high = p[1]; } if \
            (fabs((double)q - t) < 1e-3) best = fmin(best, fabs((double)there - k)); } return best; \
            }\nstatic void at(double a, double t, double k) { mckibben_real p[2], r[2], there; \
            unsigned s; \
            mckibben_joint_pressures(&joint_elbow, (mckibben_real)a, (mckibben_real)t, \
            (mckibben_real)k, p, r, &s); const mckibben_real q = \
            mckibben_joint_torque(&joint_elbow, p, (mckibben_real)a, &there, 0, 0); \
            printf(\"%.17g %.17g %u %.17g %.17g %.17g %.17g %.17g\\n\", (double)p[0], (double)p[1], s, \
            (double)q, (double)there, (double)r[0], (double)r[1], s ? nearest(a, t, k) : 0.0); }\nint main(void) {\n"
            .to_owned();
        main.extend(
            wanted
                .iter()
                .map(|[a, t, k]| format!("at({a:e}, {t:e}, {k:e});\n")),
        );
        main += "return 0; }\n";
        let script = format!(
            "import numpy as n, joint_elbow as j\na, t, k = n.array({wanted:?}).T\np = \
             j.pressures(a, t, k)\nfor r in zip(*p, j.pressures_status(a, t, k), j.torque(p, a), \
             j.stiffness(p, a)): print(*map(float, r))\n"
        );
        let mut hosts = vec![];
        if runs("cc") {
            let single = ["-O1", "-DMCKIBBEN_FLOAT", "mckibben.c"];
            hosts.push((
                1e-3,
                numbers(&compiled_and_run(folder, &main, &["-O1", "mckibben.c"])),
            ));
            hosts.push((1e-2, numbers(&compiled_and_run(folder, &main, &single))));
        }
        hosts.extend(python(folder, "numpy", &script).map(|rows| (1e-3, rows)));
        for (near, rows) in hosts {
            assert_eq!(rows.len(), wanted.len());
            assert_eq!((rows[0][2], rows[1][2], rows[2][2]), (8.0, 8.0, 0.0));
            // The command line reaches 10.8 to 11.46 there; the form is smoother at the jump.
            if let [least, most, _] = rows[0][5..] {
                assert!(least > 10.0 && (most - 11.46).abs() < 0.1, "{least} {most}");
            }
            let mut answered = 0;
            for (row, [angle, torque, stiffness]) in rows.iter().zip(&wanted) {
                if row[2] == 0.0 {
                    let met = (row[4] - stiffness).abs() <= 1.01 * near * stiffness
                        && (row[3] - torque).abs() <= 0.1 * near.max(5e-3) * (1.0 + torque.abs());
                    assert!(met, "{angle} {torque} {stiffness}: {row:?}");
                    answered += 1;
                    continue;
                }
                // Nor has the form it at any of 400 pressures of the first muscle.
                let beside = row.get(7).is_none_or(|nearest| *nearest > 1e-3 * stiffness);
                assert!(beside, "{angle} {torque} {stiffness}: {row:?}");
            }
            assert!(answered > wanted.len() / 5, "{answered}");
        }
    });
}

/// An identity: a stiffness of 0 asks for none in every language, whose pressures are the lowest ones
/// for the torque, so that one muscle of the pair need not pull.
#[test]
fn identity_a_stiffness_of_zero_asks_for_none() {
    elbow_by_universal(0.3, &["c", "rust", "python"], |folder, _| {
        let states = [[0.0, 1e5, 1e5]];
        let wanted = [[-0.5, 1.0, 0.0], [0.3, -0.7, 0.0], [0.0, 0.2, 0.0]];
        let mut hosts = vec![];
        hosts.extend(runs("cc").then(|| by_c(folder, &states, &wanted)));
        hosts.extend(runs("rustc").then(|| by_rust(folder, 2, &states, &wanted)));
        hosts.extend(by_python(folder, &states, &wanted));
        for [_, rows] in &hosts {
            for (row, expected) in rows.iter().zip(&hosts[0][1]) {
                assert!(row[2] == 0.0 && row[0].min(row[1]) == 0.0, "{row:?}");
                let off_pa = (row[0] - expected[0])
                    .abs()
                    .max((row[1] - expected[1]).abs());
                assert!(off_pa < 1e-3, "{row:?} {expected:?}");
            }
        }
    });
}

/// As of one muscle: no pressure of what is not a number, and a status.
#[test]
fn identity_what_is_not_a_number_gives_no_pressure() {
    elbow_by_universal(0.3, &["c", "rust", "python"], |folder, _| {
        let wrong = ["NAN", "INFINITY", "-INFINITY"];
        let mut main = "#include \"joint_elbow.h\"\n#include <stdio.h>\n#include <math.h>\nstatic \
            void at(double a, double t, double k) { double p[2], r[2]; unsigned s; \
            mckibben_joint_pressures(&joint_elbow, a, t, k, p, r, &s); printf(\"%.17g %.17g %u\\n\", \
            p[0], p[1], s & 8u); }\nint main(void) {\n"
            .to_owned();
        for value in wrong {
            main += &format!(
                "at({value}, 1.0, 0.0); at(0.3, {value}, 0.0); at(0.3, {value}, 9.0); at(0.3, 1.0, \
                 {value});\n"
            );
        }
        main += "return 0; }\n";
        let rust = "mod joint_elbow;\nuse joint_elbow::*;\nfn main() {\nlet at = |a, t, k| match \
            JOINT_ELBOW.pressures_pa(a, t, k) { Ok(p) => println!(\"{} {} 0\", p[0], p[1]), Err(o) => \
            println!(\"{} {} {}\", o.nearest[0], o.nearest[1], o.status & NO_ANSWER) };\nfor v in \
            [Real::NAN, Real::INFINITY, -Real::INFINITY] { at(v, 1.0, None); at(0.3, v, None); at(0.3, \
            v, Some(9.0)); at(0.3, 1.0, Some(v)); }\n}\n";
        let script = "import numpy as n, joint_elbow as j\nfor v in (n.nan, n.inf, -n.inf):\n for a, \
            t, k in ((v, 1., None), (.3, v, None), (.3, v, 9.), (.3, 1., v)):\n  print(*(float(x[0]) \
            for x in j.pressures(n.array([a]), n.array([t]), k and n.array([k]))), \
            float(j.pressures_status(n.array([a]), n.array([t]), k and n.array([k]))[0] & 8))\n";
        let script = format!("import warnings\nwarnings.simplefilter('ignore')\n{script}");
        let mut hosts = vec![];
        hosts.extend(
            runs("cc").then(|| numbers(&compiled_and_run(folder, &main, &["-O1", "mckibben.c"]))),
        );
        hosts.extend(runs("rustc").then(|| numbers(&printed(folder, rust, "mckibben_double"))));
        hosts.extend(python(folder, "numpy", &script));
        for rows in hosts {
            assert_eq!(rows, vec![vec![0.0, 0.0, 8.0]; 12]);
        }
    });
}

/// Every name and every target: its examples compile and run, its modules are imported and its
/// scenes read, where a compiler, Python or MuJoCo is there. "joint" is the default of Python.
#[test]
fn joints_of_every_name_compile_for_every_target() {
    let names = [
        "joint",
        "muscle",
        "mckibben",
        "example",
        "joint_h",
        "main",
        "int",
        "",
        "1",
        "Gelenk ä",
        "a name that is longer than what identifiers of muscles hold",
    ];
    for name in names {
        let targets = ["c", "rust", "python", "mjcf", "fmu"];
        named_by_universal(name, 0.3, &targets, |folder, _| {
            let files = std::fs::read_dir(folder).unwrap();
            let mut files =
                Vec::from_iter(files.map(|file| file.unwrap().file_name().into_string().unwrap()));
            files.sort();
            let numbers_of = |word: &str| {
                let own = files
                    .iter()
                    .filter(|f| f.starts_with(word) && f.ends_with(".h"));
                own.count()
            };
            assert_eq!(
                (numbers_of("joint"), numbers_of("muscle")),
                (1, 2),
                "{files:?}"
            );
            for file in &files {
                let text = std::fs::read_to_string(folder.join(file)).unwrap_or_default();
                if file.starts_with("joint") && file.ends_with("_example.c") && runs("cc") {
                    let said = compiled_and_run(folder, &text, &["mckibben.c"]);
                    assert!(said.contains("status 0"), "{name}: {said}");
                }
                if file.ends_with(".rs") && runs("rustc") {
                    rustc(folder, &["--crate-type", "lib", file]);
                }
                let module = file
                    .strip_suffix(".py")
                    .filter(|file| file.starts_with("joint"));
                if let Some(module) = module {
                    let script =
                        format!("import {module}\nprint({module}.torque((1e5, 1e5), 0.1))");
                    assert!(python(folder, "math", &script).is_none_or(|rows| rows.len() == 1));
                }
                if file.starts_with("joint") && file.ends_with(".xml") {
                    let read = "import xml.dom.minidom as x";
                    let script = format!("{read}\nx.parse('{file}')\nprint(0)");
                    assert!(python(folder, "math", &script).is_none_or(|rows| rows.len() == 1));
                }
            }
        });
    }
}
