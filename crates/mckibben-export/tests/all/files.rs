//! The files: what each names, and what a C compiler and Python make of them.

use super::exported;
use mckibben_core::muscle::{Friction, Muscle};
use mckibben_export::{Content, ExportError, ExportTarget, ExportedMuscle, Form, OK, Point};
use std::{fmt::Write as _, io::Read as _, path::Path, process::Command, sync::LazyLock};

pub static PROTOTYPE: LazyLock<ExportedMuscle> =
    LazyLock::new(|| exported(&Muscle::prototype(), 0.25).unwrap());
/// With a rope, which adds to each length.
pub static ROPED: LazyLock<ExportedMuscle> = LazyLock::new(|| {
    let mut muscle = PROTOTYPE.clone();
    muscle.cord_m = 0.06;
    muscle
});

pub fn write(muscle: &ExportedMuscle, target: &str, folder: &Path) {
    for file in muscle
        .to(ExportTarget::named(target).unwrap())
        .unwrap()
        .files
    {
        std::fs::write(folder.join(file.name), file.content.bytes()).unwrap();
    }
}

/// What a program prints, compiled in a folder as C99 without a warning.
pub fn compiled_and_run(folder: &Path, main: &str, arguments: &[&str]) -> String {
    std::fs::write(folder.join("main.c"), main).unwrap();
    let strict = [
        "-std=c99",
        "-Wall",
        "-Wextra",
        "-Wconversion",
        "-pedantic",
        "-Werror",
        "-o",
        "main",
        "main.c",
    ];
    let done = Command::new("cc")
        .args(strict)
        .args(arguments)
        .arg("-lm")
        .current_dir(folder)
        .output()
        .unwrap();
    assert!(
        done.status.success(),
        "{}",
        String::from_utf8_lossy(&done.stderr)
    );
    let out = Command::new(folder.join("main")).output().unwrap();
    assert!(
        out.status.success(),
        "{}",
        String::from_utf8_lossy(&out.stderr)
    );
    String::from_utf8(out.stdout).unwrap()
}

/// What a script prints, where Python has a module.
pub fn python(folder: &Path, module: &str, script: &str) -> Option<Vec<Vec<f64>>> {
    let run = |script: &str| {
        Command::new("python3")
            .args(["-c", script])
            .current_dir(folder)
            .output()
    };
    run(&format!("import {module}"))
        .ok()
        .filter(|out| out.status.success())?;
    let out = run(script).unwrap();
    assert!(
        out.status.success(),
        "{module}: {}",
        String::from_utf8_lossy(&out.stderr)
    );
    Some(numbers(&String::from_utf8(out.stdout).unwrap()))
}

pub fn numbers(text: &str) -> Vec<Vec<f64>> {
    text.lines()
        .map(|line| line.split(' ').map(|v| v.parse().unwrap()).collect())
        .collect()
}

/// Whether a program is there. On Linux it is: no test passes there without its check.
pub fn runs(program: &str) -> bool {
    let version = Command::new(program).arg("--version").output();
    let runs = version.is_ok_and(|o| o.status.success());
    assert!(
        runs || !cfg!(target_os = "linux"),
        "this test needs {program}"
    );
    runs
}

/// Points in the box, outside of it, and slack.
pub fn points() -> Vec<(f64, f64)> {
    let form = &PROTOTYPE.form;
    let mut out = vec![];
    for i in -1..=11 {
        for k in -1..=13 {
            // Not on the ends of the box, where rounding decides.
            let share = (f64::from(k) + 1e-4) / 12.0;
            let e = form.contraction_low + (form.contraction_high - form.contraction_low) * share;
            out.push((
                f64::from(i) * 0.1 * form.supply_pa,
                (1.0 - e) * form.length_m,
            ));
        }
    }
    out
}

/// The text of a file; of an archive that of all its files.
fn text_of(bytes: &[u8]) -> String {
    let Ok(mut archive) = zip::ZipArchive::new(std::io::Cursor::new(bytes)) else {
        return String::from_utf8_lossy(bytes).into_owned();
    };
    let mut all = vec![];
    for i in 0..archive.len() {
        archive.by_index(i).unwrap().read_to_end(&mut all).unwrap();
    }
    String::from_utf8_lossy(&all).into_owned()
}

/// Files that are the same for all muscles, so that two muscles of one folder share them.
fn is_shared(name: &str) -> bool {
    ["mckibben.h", "mckibben.c", "mckibben_air.h"].contains(&name)
}

/// Files that stand beside the one with the facts: examples, the source of a plugin, a scene.
fn is_beside(name: &str) -> bool {
    let ends = ["_example.c", "_loop.ino", "_plugin.c", "prototype.xml"];
    ends.iter().any(|end| name.ends_with(end))
}

#[test]
fn every_file_names_muscle_version_hash_and_error() {
    for target in ExportTarget::ALL {
        let made = PROTOTYPE.to(target).unwrap();
        let target = target.name;
        assert!(!made.files.is_empty());
        for file in made.files {
            let text = text_of(file.content.bytes());
            let facts = [
                &PROTOTYPE.hash,
                "prototype",
                "exported by mckibben",
                "% worst",
                "Allowed pressure",
            ];
            let facts = if is_shared(&file.name) || is_beside(&file.name) {
                &[][..]
            } else {
                &facts
            };
            assert!(text.contains(env!("CARGO_PKG_VERSION")));
            for word in facts {
                assert!(text.contains(word), "{target:?} {}: {word}", file.name);
            }
            assert!(
                is_shared(&file.name) || file.name.starts_with("muscle_prototype"),
                "{}",
                file.name
            );
            assert!(
                !text.contains(&usize::MAX.to_string()),
                "{target:?}: a variable that fmu2.c does not have"
            );
            let is_text = matches!(file.content, Content::Text(_));
            assert!(
                !is_text || !text.contains("@{"),
                "{target:?} {}: a place without a value",
                file.name
            );
            let numbers = file.name.ends_with(".xml") || file.name == "muscle_prototype.h";
            assert!(
                !numbers || !text.contains("NaN") && !text.contains("inf,"),
                "{target:?} {}",
                file.name
            );
        }
    }
}

#[test]
fn an_unknown_target_is_named_with_those_that_there_are() {
    let error = ExportTarget::named("csv").unwrap_err();
    assert!(matches!(error, ExportError::Target { .. }));
    assert!(
        error.to_string().contains("c, rust, python, mjcf, fmu"),
        "{error}"
    );
    let gone = ExportTarget::named("opensim").unwrap_err();
    assert!(gone.to_string().contains("take fmu or python"), "{gone}");
}

/// `checks/fmu-binaries.sh` writes the hashes: a source that was changed needs it again.
#[test]
fn libraries_of_the_fmu_have_the_hashes_recorded_with_those_of_their_sources() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut names = vec![];
    for line in std::fs::read_to_string(folder.join("binaries/hashes.txt"))
        .unwrap()
        .lines()
    {
        let (recorded, name) = line.split_once("  ").unwrap();
        let digest = hmac_sha256::Hash::hash(&std::fs::read(folder.join(name)).unwrap());
        let hash: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
        assert_eq!(hash, recorded, "{name}: run checks/fmu-binaries.sh");
        names.push(name.to_owned());
    }
    let templates = ["air.c", "fmu2.c", "fmu3.c", "mckibben.c", "mckibben.h"]
        .map(|name| format!("templates/{name}"));
    let libraries = [
        "aarch64-darwin",
        "aarch64-linux",
        "x86_64-darwin",
        "x86_64-linux",
        "x86_64-windows",
    ];
    assert_eq!(
        names,
        [
            &templates[..],
            &libraries.map(|name| format!("binaries/{name}"))[..]
        ]
        .concat()
    );
    let size: u64 = libraries
        .iter()
        .map(|name| folder.join("binaries").join(name).metadata().unwrap().len())
        .sum();
    assert!(size <= 200_000, "{size} bytes");
}

/// Pull, stiffness, dF/dP, volume, pressure of the pull and status of C: of the box, or along the
/// tangents beyond it.
fn compare_with_c(flags: &[&str], tolerance: f64) {
    if !runs("cc") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    write(&ROPED, "c", folder.path());
    for (beyond, at) in [
        (0, Form::point_at as fn(&Form, f64, f64) -> Point),
        (1, Form::beyond),
    ] {
        let mut main = format!(
            "#include \"muscle_prototype.h\"\n#include <stdio.h>\nint main(void) {{\nunsigned \
             s;\nmckibben_muscle own = muscle_prototype;\nconst mckibben_muscle *m = \
             &own;\nown.beyond = {beyond};\n"
        );
        for (p, l) in points() {
            let _ = writeln!(
                main,
                "{{ mckibben_real p = (mckibben_real){p:e}, l = (mckibben_real){:e}, f = \
                 mckibben_force(m, p, l, &s);",
                l + ROPED.cord_m
            );
            main += "printf(\"%.17g %.17g %.17g %.17g %.17g %u\\n\", (double)f, \
                (double)mckibben_stiffness(m, p, l, 0), (double)mckibben_force_per_pressure(m, p, \
                l, 0), (double)mckibben_volume(m, p, l, 0), (double)mckibben_pressure(m, f, l, 0), \
                s); }\n";
        }
        main += "return 0; }\n";
        let arguments = [&["-ffp-contract=off", "-O1", "mckibben.c"], flags].concat();
        compare_rows(
            &numbers(&compiled_and_run(folder.path(), &main, &arguments)),
            tolerance,
            at,
        );
    }
}

pub fn compare_rows(rows: &[Vec<f64>], tolerance: f64, at: fn(&Form, f64, f64) -> Point) {
    let form = &PROTOTYPE.form;
    let full = form.point_at(form.supply_pa, 0.0);
    let scales = [
        full.force_n,
        full.stiffness_n_per_m,
        full.force_per_pressure_m2,
        full.volume_m3,
        form.supply_pa,
    ];
    assert_eq!(rows.len(), points().len());
    let mut largest = [0.0_f64; 5];
    for (row, (p, l)) in rows.iter().zip(points()) {
        let e = 1.0 - l / form.length_m;
        let point = at(form, p, e);
        // Derivatives jump where the muscle becomes slack: single precision may lie on the other
        // side.
        if tolerance > 1e-6 && form.two_sided_n(p, e).0.abs() < 1e-3 * full.force_n {
            continue;
        }
        let ours = [
            point.force_n,
            point.stiffness_n_per_m,
            point.force_per_pressure_m2,
            point.volume_m3,
            p,
        ];
        // The inverse returns the pressure of a pull, where there is one.
        let last = if point.status == OK { 5 } else { 4 };
        assert_eq!(row[5], f64::from(point.status), "{p} {e}");
        for (k, large) in largest.iter_mut().enumerate().take(last) {
            *large = large.max((row[k] - ours[k]).abs() / scales[k]);
        }
    }
    assert!(largest.iter().all(|e| *e < tolerance), "{largest:?}");
}

#[test]
fn c_in_double_precision_is_the_form_to_1e_12() {
    compare_with_c(&[], 1e-12);
}

#[test]
fn c_in_single_precision_errs_by_less_than_1e_4() {
    compare_with_c(&["-DMCKIBBEN_FLOAT"], 1e-4);
}

/// Writes the files of a unit of a muscle, of those of target `fmu` by its place, into one folder.
pub fn unpack_unit(muscle: &ExportedMuscle, place: usize, folder: &Path) {
    let files = muscle
        .to(ExportTarget::named("fmu").unwrap())
        .unwrap()
        .files;
    let bytes = files[place].content.bytes();
    let mut unit = zip::ZipArchive::new(std::io::Cursor::new(bytes)).unwrap();
    for i in 0..unit.len() {
        let mut file = unit.by_index(i).unwrap();
        let mut bytes = vec![];
        file.read_to_end(&mut bytes).unwrap();
        let name = Path::new(file.name()).file_name().unwrap().to_owned();
        std::fs::write(folder.join(name), bytes).unwrap();
    }
}

/// The unit on a valve, with laws by hand: the choked flow C p ρ0 √(T0/T), p Vⁿ constant while the
/// valve is closed, T = p V/(m R), and the pressure of the supply at the end of filling.
#[test]
fn the_fmu_on_a_valve_obeys_the_laws_of_the_gas() {
    if !runs("cc") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    unpack_unit(&PROTOTYPE, 2, folder.path());
    let main = r#"#include "fmu2.c"
int main(void) {
    const unsigned set[] = {COMMAND, LENGTH, DEAD_VOLUME, POLYTROPIC_EXPONENT, TEMPERATURE};
    const unsigned out[] = {PRESSURE, VOLUME, AIR_MASS, AIR_FLOW, AIR_TEMPERATURE};
    double in[] = {0.5, 0.29, 1e-5, 1.25, 300.0}, v[5];
    void *c = fmi2Instantiate("unit", fmi2CoSimulation, "TOKEN", "file:FOLDER", 0, 0, 0);
    if (!c || fmi2SetReal(c, set, 5, in) || fmi2ExitInitializationMode(c))
        return 1;
#define SHOW (void)fmi2GetReal(c, out, 5, v), (void)printf("%.17g %.17g %.17g %.17g %.17g\n", v[0], v[1], v[2], v[3], v[4])
    SHOW;
    if (fmi2DoStep(c, 0.0, 0.3, 1)) return 2;
    in[0] = 0.0;
    (void)fmi2SetReal(c, set, 1, in);
    SHOW;
    in[1] = 0.27;
    (void)fmi2SetReal(c, set, 2, in);
    if (fmi2DoStep(c, 0.3, 0.1, 1)) return 3;
    SHOW;
    in[0] = 1.0;
    (void)fmi2SetReal(c, set, 1, in);
    if (fmi2DoStep(c, 0.4, 20.0, 1)) return 4;
    SHOW;
    in[0] = 1.0 / 0.0;
    return fmi2SetReal(c, set, 1, in) == fmi2Error ? 0 : 5;
}
"#;
    let token = format!("{{mckibben-air-{}}}", PROTOTYPE.hash);
    let main = main
        .replace("TOKEN", &token)
        .replace("FOLDER", &folder.path().to_string_lossy());
    let rows = numbers(&compiled_and_run(folder.path(), &main, &["-O1"]));
    let [start, filled, moved, full] = &rows[..] else {
        panic!("{rows:?}")
    };
    let (p0, supply_pa) = (101_325.0, PROTOTYPE.form.supply_pa);
    let near = |a: f64, b: f64, share: f64| assert!((a / b - 1.0).abs() < share, "{a} {b}");
    // Choked: 101325 Pa are less than 0.3 of the supply of 351325 Pa only nearly; so the shape ψ of
    // ISO 6358 at this ratio.
    let (ratio, b) = (p0 / (p0 + supply_pa), 0.3_f64);
    let shape = if ratio <= b {
        1.0
    } else {
        (1.0 - ((ratio - b) / (1.0 - b)).powi(2)).sqrt()
    };
    near(
        start[3],
        0.5 * 5e-9 * (p0 + supply_pa) * 1.185 * (293.15_f64 / 300.0).sqrt() * shape,
        1e-9,
    );
    near(start[4], 300.0, 1e-12);
    for row in [start, filled, moved, full] {
        near(
            row[4],
            (p0 + row[0]) * (row[1] + 1e-5) / (row[2] * 287.05),
            1e-12,
        );
    }
    assert!(filled[0] > 1e4 && moved[1] > filled[1], "{rows:?}");
    near(moved[2], filled[2], 1e-15);
    let of_state = |row: &[f64]| (p0 + row[0]) * (row[1] + 1e-5).powf(1.25);
    near(of_state(moved), of_state(filled), 1e-12);
    near(full[0], supply_pa, 1e-6);
}

#[test]
fn python_with_numpy_is_the_form_to_1e_12() {
    let folder = tempfile::tempdir().unwrap();
    write(&ROPED, "python", folder.path());
    let (p, l): (Vec<f64>, Vec<f64>) = points().into_iter().unzip();
    let script = format!(
        "import numpy as n, muscle_prototype as m\np, l = n.array({p:?}), n.array({l:?}) + \
         m.CORD\nf = m.force(p, l)\nfor row in zip(f, m.stiffness(p, l), m.force_per_pressure(p, \
         l), m.volume(p, l), m.pressure(f, l), m.status(p, l)): print(*(repr(float(v)) for v in \
         row))\n"
    );
    if let Some(rows) = python(folder.path(), "numpy", &script) {
        compare_rows(&rows, 1e-12, Form::point_at);
    }
}

/// An identity: at the pressure of a branch, by C and Python where they run here, the pull with the
/// friction is the given one; a pull that the supply does not give on the branch of shortening has
/// none.
#[test]
fn pressures_on_a_branch_give_the_pull_on_it_in_c_and_python() {
    let friction = Friction {
        lever_mm: 0.8,
        ..Friction::power_law(20.0, 0.7)
    };
    let muscle = Muscle::prototype().with_friction(Some(friction)).unwrap();
    let muscle = exported(&muscle, 0.25).unwrap();
    let (form, folder) = (&muscle.form, tempfile::tempdir().unwrap());
    for target in ["c", "python"] {
        write(&muscle, target, folder.path());
    }
    let (mut main, mut script, mut given) = (String::new(), String::new(), vec![]);
    for sign in [-1, 0, 1] {
        for (force, e) in [(100.0, 0.0), (400.0, 0.05), (150.0, 0.15)] {
            let length = (1.0 - e) * form.length_m;
            let _ = writeln!(
                main,
                "p = mckibben_pressure_on(&muscle_prototype, {force:e}, {length:e}, {sign}, &s); \
                 printf(\"%.17g %u\\n\", p, s);"
            );
            let _ = writeln!(
                script,
                "print(repr(float(m.pressure_on({force:e}, {length:e}, {sign}))))"
            );
            given.push((force, e, f64::from(sign)));
        }
    }
    let gives = |printed: &[f64], (force_n, e, sign): (f64, f64, f64)| {
        let pressure_pa = printed[0];
        let half_n = super::half_n(form, pressure_pa, e);
        let pull_n = form.point_at(pressure_pa, e).force_n + sign * half_n;
        let (off_n, status) = ((pull_n - force_n).abs(), printed.get(1).unwrap_or(&0.0));
        assert!(
            off_n < 1e-6 && *status == 0.0,
            "{force_n} {e} {sign}: {pull_n} {printed:?}"
        );
    };
    // What the supply gives in the mean of both branches, and not while the muscle shortens.
    let most_n =
        form.point_at(form.supply_pa, 0.0).force_n - 0.5 * super::half_n(form, form.supply_pa, 0.0);
    if runs("cc") {
        let main = format!(
            "#include \"muscle_prototype.h\"\n#include \
             <stdio.h>\nint main(void) {{ double p; unsigned \
             s;\n{main}(void)mckibben_pressure_on(&muscle_prototype, {most_n:e}, \
             muscle_prototype.length, -1, &s); return s == MCKIBBEN_NO_ANSWER ? 0 : 1; }}\n"
        );
        let rows = numbers(&compiled_and_run(
            folder.path(),
            &main,
            &["-O1", "mckibben.c"],
        ));
        assert_eq!(rows.len(), given.len());
        rows.iter()
            .zip(&given)
            .for_each(|(row, given)| gives(row, *given));
    }
    let script = format!(
        "import muscle_prototype as m\n{script}assert m.pressure_on({most_n:e}, m.LENGTH, -1) == \
         m.SUPPLY\nassert m.pressure_status({most_n:e}, m.LENGTH, -1) == m.NO_ANSWER\n"
    );
    if let Some(rows) = python(folder.path(), "numpy", &script) {
        assert_eq!(rows.len(), given.len());
        rows.iter()
            .zip(given)
            .for_each(|(row, given)| gives(row, given));
    }
}

/// The pressure at which the muscle at rest pulls so: by halvings.
fn nearest_pressure(form: &Form, force_n: f64) -> f64 {
    let mut ends = [0.0, form.supply_pa];
    for _ in 0..60 {
        let middle = 0.5 * (ends[0] + ends[1]);
        let below = form.point_at(middle, form.contraction_low).force_n < force_n;
        ends[usize::from(!below)] = middle;
    }
    ends[0]
}

pub fn with_friction() -> ExportedMuscle {
    let muscle = Muscle::prototype()
        .with_friction(Some(Friction::power_law(71.5, 0.56)))
        .unwrap();
    exported(&muscle, 0.25).unwrap()
}

/// Outside of the box, of numbers that are none and of pulls that cannot be: never above the
/// supply, and a status that says so.
#[test]
fn no_answer_lies_outside_of_the_box_and_each_has_a_status() {
    if !runs("cc") {
        return;
    }
    let muscle = with_friction();
    let folder = tempfile::tempdir().unwrap();
    write(&muscle, "c", folder.path());
    let main = r#"#include "muscle_prototype.h"
#include <math.h>
#include <stdio.h>
#define SAY(value) do { s = 99u; const double v = (value); printf("%.17g %u\n", v, s); } while (0)
int main(void) {
    unsigned s;
    const mckibben_muscle *m = &muscle_prototype;
    const double l = m->length, p = m->supply;
    SAY(mckibben_pressure(m, 276.5, 0.7 * l, &s)); SAY(mckibben_pressure(m, NAN, l, &s)); SAY(mckibben_pressure(m, 200.0, NAN, &s));
    SAY(mckibben_pressure(m, -5.0, 0.95 * l, &s)); SAY(mckibben_pressure(m, INFINITY, l, &s)); SAY(mckibben_pressure(m, 200.0, 0.95 * l, &s));
    SAY(mckibben_pressure_on(m, NAN, l, -1, &s)); SAY(mckibben_pressure_on(m, -5.0, l, 1, &s)); SAY(mckibben_pressure_on(m, 1e9, l, 1, &s));
    SAY(mckibben_contraction(m, 1e9, p, &s)); SAY(mckibben_contraction(m, NAN, p, &s)); SAY(mckibben_contraction(m, -5.0, 0.5 * p, &s)); SAY(mckibben_contraction(m, 200.0, 2.0 * p, &s));
    SAY(mckibben_contraction(m, 200.0, 0.6 * p, &s));
    SAY(mckibben_force(m, NAN, l, &s)); SAY(mckibben_volume(m, 3.0 * p, l, &s)); SAY(mckibben_stiffness(m, p, 0.5 * l, &s)); SAY(mckibben_force_per_pressure(m, -1.0, l, &s));
    const double pull = mckibben_force(m, 30e3, 0.88 * l, 0);
    SAY(pull + mckibben_friction(m, 30e3, 0.88 * l, -1.0, 0.0, &s));
    return 0;
}
"#;
    let rows = numbers(&compiled_and_run(
        folder.path(),
        main,
        &["-O1", "mckibben.c"],
    ));
    let answers: Vec<(f64, u32)> = rows.iter().map(|row| (row[0], row[1] as u32)).collect();
    let (form, near) = (&muscle.form, |a: f64, b: f64| {
        (a - b).abs() < 1e-9 * b.abs().max(1.0)
    });
    let (supply, low) = (form.supply_pa, form.contraction_low);
    let (pull, free) = (
        form.point_at(supply, 0.0),
        form.contraction(0.0, 0.5 * supply),
    );
    let in_box = |value: f64, low: f64, high: f64| value > low && value < high;
    // Status: 1 slack, 2 pressure outside, 4 contraction outside, 8 no answer.
    let at_rest = nearest_pressure(form, 200.0);
    let expected = [(supply, 12), (0.0, 8), (at_rest, 4), (0.0, 8), (supply, 8)];
    for (k, (value, status)) in expected
        .into_iter()
        .chain([
            (f64::NAN, 0),
            (0.0, 8),
            (0.0, 8),
            (supply, 8),
            (low, 8),
            (low, 8),
            (free, 8),
        ])
        .enumerate()
    {
        assert!(
            answers[k].1 == status && (value.is_nan() || near(answers[k].0, value)),
            "{k}: {:?}",
            answers[k]
        );
    }
    assert!(
        in_box(answers[5].0, 0.0, supply) && answers[12] == (form.contraction(200.0, supply), 2),
        "{answers:?}"
    );
    assert!(
        in_box(answers[13].0, 0.0, form.contraction_high) && answers[13].1 == 0,
        "{answers:?}"
    );
    assert!(
        answers[14] == (form.point_at(0.0, 0.0).force_n, 3)
            && near(answers[15].0, pull.volume_m3)
            && answers[15].1 == 2,
        "{answers:?}"
    );
    assert!(
        answers[16].1 & 4 == 4 && answers[17].1 & 2 == 2,
        "{answers:?}"
    );
    assert_eq!(answers[18], (0.0, 1));
}

/// The same by Python; and derivatives by JAX, where it runs here, by differences of what they are
/// the derivatives of.
#[test]
fn python_has_the_same_statuses_and_its_inverses_have_derivatives() {
    let folder = tempfile::tempdir().unwrap();
    write(&with_friction(), "python", folder.path());
    let same = r#"
import muscle_prototype as m
n, L, S = float("nan"), m.LENGTH, m.SUPPLY
pairs = [(m.pressure(276.5, .7 * L), S, m.pressure_status(276.5, .7 * L), 12), (m.pressure(n, L), 0, m.pressure_status(n, L), 8), (m.pressure(200., n), m.pressure(200., L), m.pressure_status(200., n), 4),
    (m.pressure(-5., .95 * L), 0, m.pressure_status(-5., .95 * L), 8), (m.pressure_on(1e9, L, 1), S, m.pressure_status(1e9, L, 1), 8), (m.pressure_on(n, L, -1), 0, m.pressure_status(n, L, -1), 8),
    (m.contraction(1e9, S), m.LOW, m.contraction_status(1e9, S), 8), (m.contraction(n, S), m.LOW, m.contraction_status(n, S), 8), (m.contraction(200., 2 * S), m.contraction(200., S), m.contraction_status(200., 2 * S), 2)]
for k, (value, wanted, status, said) in enumerate(pairs):
    assert abs(value - wanted) <= 1e-9 * (1 + abs(wanted)) and status == said, (k, value, wanted, status, said)
assert m.status(n, L) == 3 and m.force(float('inf'), L) == m.force(S, L) and m.force(S, n) == m.force(S, L) and m.status(S, n) == 4 and m.pressure_status(200., .95 * L) == 0 and m.contraction_status(200., .6 * S) == 0
assert m.force(30e3, .88 * L) + m.friction(30e3, .88 * L, -1.) == 0
"#;
    let slopes = r#"
import jax
jax.config.update("jax_enable_x64", True)
import muscle_prototype as m
L, S = m.LENGTH, m.SUPPLY
on = lambda force, length: m.pressure_on(force, length, -1)
for f, at in [(m.contraction, (200., 1.5e5)), (m.pressure, (200., .26)), (on, (200., .26)), (m.volume, (5e4, .24)), (m.volume, (1.5e5, .27))]:
    for k in (0, 1):
        step = 1e-6 * at[k]
        up, down = [f(*(x + s * (i == k) for i, x in enumerate(at))) for s in (step, -step)]
        wanted, found = (up - down) / (2 * step), jax.grad(f, k)(*at)
        assert abs(found - wanted) <= 1e-4 * abs(wanted) + 1e-15, (f, at, k, found, wanted)
assert abs(jax.grad(m.contraction)(200., 1.5e5) + 4.888e-4) < 1e-5 and abs(jax.grad(m.pressure)(200., .26) - 382.7) < 4 and abs(jax.grad(m.volume)(5e4, .24) - 1.97e-9) < 1e-10
"#;
    for (module, script) in [("numpy", same), ("jax", slopes)] {
        python(folder.path(), module, script);
    }
}

/// Names that would be code in each of the languages: every file is read by its language, and none
/// of them is there.
#[test]
fn names_are_code_in_no_language() {
    const NAME: &str = "x\"\"\";import os;os.mkdir('ran')\n*/ #error ran\n/* --> \
        <script>ran</script> \u{202e}${y} \\ '#";
    let mut hostile = PROTOTYPE.clone();
    (hostile.name, hostile.model, hostile.muscle_file) = (NAME.into(), NAME.into(), NAME.into());
    for target in ExportTarget::ALL {
        let folder = tempfile::tempdir().unwrap();
        write(&hostile, target.name, folder.path());
        for file in hostile.to(target).unwrap().files {
            let text = text_of(file.content.bytes());
            for code in [";import", "#error", "<script", "\u{202e}", "${"] {
                assert!(
                    !text.contains(code),
                    "{} {}: {code}",
                    target.name,
                    file.name
                );
            }
            let reads = "import sys,xml.dom.minidom as x,zipfile as z\nf=sys.argv[1]\nif \
                f.endswith('.py'): compile(open(f).read(),f,'exec'); __import__(f[:-3])\nelif \
                f.endswith('.fmu'): \
                x.parseString(z.ZipFile(f).read('modelDescription.xml'))\nelse: x.parse(f)";
            let read = |program: &str, words: &[&str]| {
                let mut command = Command::new(program);
                let done = command
                    .args(words)
                    .arg(&file.name)
                    .current_dir(folder.path())
                    .output()
                    .unwrap();
                assert!(
                    done.status.success(),
                    "{}: {}",
                    file.name,
                    String::from_utf8_lossy(&done.stderr)
                );
            };
            match Path::new(&file.name)
                .extension()
                .and_then(|ending| ending.to_str())
            {
                Some("c") if !text.contains("mujoco/") && runs("cc") => {
                    read("cc", &["-std=c99", "-fsyntax-only"])
                }
                Some("rs") if runs("rustc") => read(
                    "rustc",
                    &[
                        "-D",
                        "warnings",
                        "--crate-type",
                        "lib",
                        "--emit",
                        "metadata",
                    ],
                ),
                Some("py" | "fmu" | "xml" | "osim") if runs("python3") => {
                    read("python3", &["-c", reads])
                }
                _ => {}
            }
        }
        assert!(!folder.path().join("ran").exists());
    }
}

/// Names that C, its library, Rust or Python has: behind a prefix they are none.
#[test]
fn names_of_languages_and_libraries_are_names_of_muscles() {
    if !runs("cc") {
        return;
    }
    for name in [
        "default", "length", "force", "new", "main", "linux", "sqrt", "N", "", "1", "muscle", "own",
    ] {
        let mut muscle = PROTOTYPE.clone();
        muscle.name = name.into();
        let folder = tempfile::tempdir().unwrap();
        write(&muscle, "c", folder.path());
        let example = format!("{}_example.c", muscle.identifier());
        let main = std::fs::read_to_string(folder.path().join(example)).unwrap();
        let text = compiled_and_run(folder.path(), &main, &["mckibben.c"]);
        assert!(text.contains("status 0"), "{name}");
        if runs("rustc") {
            write(&muscle, "rust", folder.path());
            let file = muscle.identifier() + ".rs";
            super::rust::rustc(folder.path(), &["--crate-type", "lib", &file]);
        }
    }
}
