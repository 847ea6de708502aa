//! Friction with memory in exported files, against the core's elements that stick and slip.

use super::files::{compiled_and_run, numbers, runs, unpack_unit, with_friction, write};
use mckibben_core::{
    muscle::Presliding,
    random::{Random, rounds},
};
use mckibben_export::ExportedMuscle;
use std::fmt::Write as _;

/// An identity: what friction adds in C is −F_c z of the core's elements that stick and slip in
/// parallel, over a random way with loops in loops.
#[test]
fn friction_with_memory_in_c_is_that_of_a_motion() {
    if !runs("cc") {
        return;
    }
    let (muscle, folder) = (with_friction(), tempfile::tempdir().unwrap());
    write(&muscle, "c", folder.path());
    let (form, pressure_pa) = (&muscle.form, 0.16 * muscle.form.supply_pa);
    let mut memory = Presliding::new(1e3 * form.presliding_m, 0.0, 0.0);
    let (mut main, mut given) = (String::new(), vec![]);
    for i in 0..200 {
        let way_mm = ((0.618 * f64::from(i * i)).fract() - 0.5) * f64::from(1 + i / 20 % 3);
        let length_m = 0.95 * form.length_m - 1e-3 * way_mm;
        let _ = writeln!(main, "at({length_m:e});");
        let half_n = super::half_n(form, pressure_pa, 0.05);
        given.push(-half_n * memory.travel(way_mm));
    }
    let main = format!(
        "#include \"muscle_prototype.h\"\n#include \
         <stdio.h>\nstatic mckibben_memory memory;\nstatic void at(double l) {{ \
         printf(\"%.17g\\n\", mckibben_friction_after(&muscle_prototype, &memory, {pressure_pa:e}, \
         l, 0)); mckibben_moved(&muscle_prototype, &memory, {pressure_pa:e}, l, 0); }}\nint main(void) {{ \
         mckibben_rest(&memory, {:e});\n{main}return 0; }}\n",
        0.95 * form.length_m
    );
    let rows = numbers(&compiled_and_run(
        folder.path(),
        &main,
        &["-O1", "mckibben.c"],
    ));
    for (row, wanted) in rows.iter().zip(&given) {
        assert!((row[0] - wanted).abs() < 1e-7, "{row:?} {wanted}");
    }
    assert!(
        rows.len() == given.len()
            && given.iter().any(|n| *n > 5.0)
            && given.iter().any(|n| *n < -5.0)
    );
}

/// Half the hysteresis of the form at a pressure, in N.
fn limit_n(muscle: &ExportedMuscle, pressure_pa: f64) -> f64 {
    super::half_n(&muscle.form, pressure_pa, 0.05)
}

/// Loops in each other.
const LOOPS: usize = 150;

/// Ways of length (in presliding lengths from the start) and pressure (in supplies), in which the
/// muscle is taut: random ones, and loops in each other at pressures that fall.
fn paths() -> Vec<Vec<(f64, f64)>> {
    let mut random = Random(69);
    let mut all = Vec::from_iter([0.1, 0.7, 2.0, 6.0].map(|size| {
        Vec::from_iter((0..400).map(|_| {
            let way = size * random.between(-1.0, 1.0);
            (way, random.between(0.05, 1.0))
        }))
    }));
    all.push(Vec::from_iter((0..2 * LOOPS).map(|i| {
        let sign = if i % 2 == 0 { 1.0 } else { -1.0 };
        let left = 1.0 - i as f64 / (2 * LOOPS) as f64;
        (2.0 * sign * left, 0.5 + 0.5 * left)
    })));
    all
}

/// An identity: friction of the exported functions, in double and in single precision, is that of
/// the core's elements while length and pressure change at once. Of 150 loops in each other C
/// forgets bends, and errs by less than 0.5 % of the largest friction.
#[test]
fn identity_friction_of_c_is_that_of_the_program_on_paths_of_length_and_pressure() {
    if !runs("cc") {
        return;
    }
    let (muscle, folder) = (with_friction(), tempfile::tempdir().unwrap());
    write(&muscle, "c", folder.path());
    let (form, start_m) = (&muscle.form, muscle.form.length_m);
    let largest_n = limit_n(&muscle, form.supply_pa);
    let (mut main, mut given) = (String::new(), vec![]);
    for path in paths() {
        let mut memory = Presliding::new(1e3 * form.presliding_m, 0.0, 0.0);
        let _ = writeln!(main, "mckibben_rest(&memory, (mckibben_real){start_m:e});");
        for (way, q) in path {
            let (way_m, pressure_pa) = (way * form.presliding_m, q * form.supply_pa);
            let length_m = start_m + way_m;
            let _ = writeln!(
                main,
                "at((mckibben_real){pressure_pa:e}, (mckibben_real){length_m:e});"
            );
            given.push(memory.go(1e3 * way_m, limit_n(&muscle, pressure_pa)));
        }
    }
    let main = format!(
        "#include \"muscle_prototype.h\"\n#include \
         <stdio.h>\nstatic mckibben_memory memory;\nstatic void at(mckibben_real p, mckibben_real \
         l) {{ printf(\"%.17g\\n\", (double)mckibben_friction_after(&muscle_prototype, &memory, \
         p, l, 0)); mckibben_moved(&muscle_prototype, &memory, p, l, 0); }}\nint main(void) \
         {{\n{main}return 0; }}\n"
    );
    for (flag, tolerance) in [("-DMCKIBBEN_DOUBLE", 1e-11), ("-DMCKIBBEN_FLOAT", 2e-4)] {
        let rows = numbers(&compiled_and_run(
            folder.path(),
            &main,
            &["-O1", "mckibben.c", flag],
        ));
        assert_eq!(rows.len(), given.len());
        let off = |(row, wanted): (&Vec<f64>, &f64)| (row[0] - wanted).abs() / largest_n;
        let off = Vec::from_iter(rows.iter().zip(&given).map(off));
        let (random, loops) = off.split_at(given.len() - 2 * LOOPS);
        let worst = |off: &[f64]| off.iter().copied().fold(0.0, f64::max);
        let both = [worst(random), worst(loops)];
        assert!(both[0] < tolerance && both[1] < 5e-3, "{flag}: {both:?}");
    }
}

/// Closed cycles of length and pressure of random amplitudes and phases, the pressure at once, twice
/// or three times the frequency: friction takes work. In steps of the pressure at a length, and of
/// the length at a pressure: on these the trapezoid of elements that stick and slip is never below
/// the work that they lose.
#[test]
fn bound_no_cycle_of_length_and_pressure_in_c_gives_work() {
    if !runs("cc") {
        return;
    }
    let (muscle, folder) = (with_friction(), tempfile::tempdir().unwrap());
    write(&muscle, "c", folder.path());
    let (mut random, mut main) = (Random(2), String::new());
    let cycles = rounds(400);
    for _ in 0..cycles {
        let stroke_m = muscle.form.presliding_m * 10f64.powf(random.between(-2.0, 0.5));
        let (swing, phase) = (random.between(0.0, 0.96), random.between(0.0, 6.3));
        let times = random.one_of(&[1, 2, 3]);
        let _ = writeln!(main, "cycles({stroke_m:e}, {swing:e}, {phase:e}, {times});");
    }
    let functions = r#"#include "muscle_prototype.h"
#include <stdio.h>
static double at(mckibben_memory *memory, double pressure, double length) {
    const double friction = mckibben_friction_after(&muscle_prototype, memory, pressure, length, 0);
    mckibben_moved(&muscle_prototype, memory, pressure, length, 0);
    return friction;
}
static void cycles(double stroke, double swing, double phase, int times) {
    const mckibben_muscle *m = &muscle_prototype;
    double before = m->length, work = 0.0, moved = 0.0;
    mckibben_memory memory;
    mckibben_rest(&memory, before);
    for (int i = 0; i < 3 * STEPS; i++) {
        const double turn = 6.283185307179586 / STEPS * (i % STEPS), length = m->length + stroke * sin(turn);
        const double pressure = 0.5 * m->supply * (1.0 + swing * sin(times * turn + phase));
        const double first = at(&memory, pressure, before), second = at(&memory, pressure, length);
        const double part = 0.5 * (first + second) * (length - before);
        work = i % STEPS ? work + part : part;
        moved = i % STEPS ? moved + fabs(part) : fabs(part);
        before = length;
    }
    printf("%.17g %.17g\n", work, moved);
}
"#;
    let main = format!("{functions}int main(void) {{\n{main}return 0; }}\n");
    let rows = numbers(&compiled_and_run(
        folder.path(),
        &main,
        &["-O1", "-DSTEPS=200", "mckibben.c"],
    ));
    let gives = Vec::from_iter(rows.iter().filter(|row| row[0] < -1e-9 * row[1]));
    assert!(
        rows.len() == cycles && gives.is_empty(),
        "{} of {cycles} give work: {gives:?}",
        gives.len()
    );
}

/// What is not a number is not remembered: the friction after it is that before.
#[test]
fn identity_what_is_not_a_number_leaves_the_memory_in_c() {
    if !runs("cc") {
        return;
    }
    let (muscle, folder) = (with_friction(), tempfile::tempdir().unwrap());
    write(&muscle, "c", folder.path());
    let main = r#"#include "muscle_prototype.h"
#include <stdio.h>
int main(void) {
    const mckibben_muscle *m = &muscle_prototype;
    const double bad[][2] = {{NAN, 0.0}, {0.0, NAN}, {INFINITY, 0.0}, {0.0, -INFINITY}, {NAN, NAN}};
    mckibben_memory memory;
    unsigned status = 99u;
    mckibben_rest(&memory, 0.98 * m->length);
    mckibben_moved(m, &memory, 0.5 * m->supply, 0.98 * m->length + 2e-4, &status);
    printf("%u %.17g\n", status, mckibben_friction_after(m, &memory, 0.4 * m->supply, 0.98 * m->length, 0));
    for (int i = 0; i < 5; i++) {
        mckibben_moved(m, &memory, 0.5 * m->supply + bad[i][0], 0.98 * m->length + bad[i][1], &status);
        printf("%u %.17g\n", status, mckibben_friction_after(m, &memory, 0.4 * m->supply, 0.98 * m->length, 0));
    }
    return 0;
}
"#;
    let rows = numbers(&compiled_and_run(folder.path(), main, &["mckibben.c"]));
    // 2: the pressure is outside or not a number, and counts as 0; 4: the length, and counts as that
    // at rest; 1: it is slack there.
    let said = Vec::from_iter(rows.iter().map(|row| row[0]));
    assert_eq!(said, [0.0, 3.0, 4.0, 2.0, 5.0, 7.0], "{rows:?}");
    assert!(
        rows.len() == 6 && rows[0][1] != 0.0 && rows.iter().all(|row| row[1] == rows[0][1]),
        "{rows:?}"
    );
}

/// The unit of FMI: its friction on a path of length and pressure is that of the program, and after
/// a state is restored, in bytes as in memory, it is again what it was.
#[test]
fn identity_friction_of_the_fmu_is_that_of_the_program_and_its_state_is_restored() {
    if !runs("cc") {
        return;
    }
    let (muscle, folder) = (with_friction(), tempfile::tempdir().unwrap());
    unpack_unit(&muscle, 0, folder.path());
    let (form, start_m) = (&muscle.form, muscle.form.length_m);
    let mut memory = Presliding::new(1e3 * form.presliding_m, 0.0, 0.0);
    let (mut main, mut given) = (String::new(), vec![]);
    let path = Vec::from_iter(paths()[1][..120].iter().map(|&(way, q)| (way, q.min(0.99))));
    let mut go = |part: &[(f64, f64)], given: &mut Vec<f64>| {
        for (way, q) in part {
            let (way_m, pressure_pa) = (way * form.presliding_m, q * form.supply_pa);
            let length_m = start_m + way_m;
            let _ = writeln!(main, "if (at(c, {pressure_pa:e}, {length_m:e})) return 1;");
            given.push(memory.go(1e3 * way_m, limit_n(&muscle, pressure_pa)));
        }
    };
    go(&path[..60], &mut given);
    go(&path[60..], &mut given);
    let (before, after) = main.split_at(main.match_indices('\n').nth(59).unwrap().0);
    let main = r#"#include "fmu2.c"
static int at(void *c, double p, double l) {
    const unsigned set[] = {PRESSURE, LENGTH}, out = FORCE;
    const double in[] = {p, l};
    double force;
    if (fmi2SetReal(c, set, 2, in) || fmi2GetReal(c, &out, 1, &force))
        return 1;
    printf("%.17g\n", force - mckibben_force(((instance *)c)->muscle, p, l, 0));
    return fmi2DoStep(c, 0.0, 0.1, 1) != fmi2OK;
}
int main(void) {
    void *c = fmi2Instantiate("unit", fmi2CoSimulation, "TOKEN", "file:FOLDER", 0, 0, 0), *saved = 0, *other = 0;
    const unsigned set[] = {PRESSURE, LENGTH};
    const double start[] = {0.0, START};
    size_t size;
    char *bytes;
    if (!c || fmi2SetReal(c, set, 2, start) || fmi2ExitInitializationMode(c))
        return 2;
    BEFORE
    if (fmi2GetFMUstate(c, &saved) || fmi2SerializedFMUstateSize(c, saved, &size))
        return 3;
    bytes = malloc(size);
    if (fmi2SerializeFMUstate(c, saved, bytes, size))
        return 4;
    AFTER
    if (fmi2DeSerializeFMUstate(c, bytes, size, &other) || fmi2SetFMUstate(c, other))
        return 5;
    AFTER
    return fmi2SetFMUstate(c, saved) == fmi2OK ? 0 : 6;
}
"#
    .replace("BEFORE", before)
    .replace("AFTER", after)
    .replace("START", &format!("{start_m:e}"))
    .replace("TOKEN", &format!("{{mckibben-{}}}", muscle.hash))
    .replace("FOLDER", &folder.path().to_string_lossy());
    let rows = numbers(&compiled_and_run(folder.path(), &main, &["-O1"]));
    given.extend_from_within(60..);
    assert_eq!(rows.len(), given.len());
    for (i, (row, wanted)) in rows.iter().zip(&given).enumerate() {
        assert!((row[0] - wanted).abs() < 1e-6, "{i}: {row:?} {wanted}");
    }
}
