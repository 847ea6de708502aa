//! A core rod in every model.

use crate::models::complete;
use mckibben::analysis::{Options, contraction_at, free_contraction, pressure_at, unloaded_contraction};
use mckibben::model::{ModelKind, Workspace};
use mckibben::muscle::{EndFactor, Muscle, Terminals};

/// Virtual work: a rod through a seal adds P A to the pull of any model and takes A (La − ε L0) off its volume, A = π 8²/4 mm² by hand 50.26548; a rod that ends inside
/// leaves the pull and takes A l; L0 ∂F/∂P = ∂V/∂ε and both slopes go on by differences, with ends that slip under F + (π Ri² − A) P.
#[test]
fn a_core_rod_is_virtual_work_in_every_model() {
    const AREA_MM2: f64 = 50.265_482_457_436_69;
    for kind in ModelKind::ALL {
        let plain = complete(EndFactor::Constant(1.1));
        let length = plain.length_mm();
        let slips = Terminals { slip_mm_per_n: Some(1e-3), grip_mm: Some(2.0), ..plain.terminals().clone() };
        for m in [plain.clone(), plain.with_terminals(slips).unwrap()] {
            let with = |rod_length_mm| {
                let ends = Terminals { rod_diameter_mm: Some(8.0), rod_length_mm, ..m.terminals().clone() };
                kind.build(&m.with_terminals(ends).unwrap()).unwrap()
            };
            let rod_mm = 0.4 * length;
            let (without, through, inside) = (kind.build(&m).unwrap(), with(None), with(Some(rod_mm)));
            let w = &mut Workspace::new();
            let range = &without.info().range;
            let (p, e) = (range.pressure_mpa.1.min(0.25), 0.5 * range.contraction.1.min(0.2));
            let (a, b, c) = (
                without.response(w, p, e).unwrap(),
                through.response(w, p, e).unwrap(),
                inside.response(w, p, e).unwrap(),
            );
            assert!((b.force_n - a.force_n - p * AREA_MM2).abs() < 1e-9 * a.force_n.abs(), "{kind}");
            assert!((through.force_n(w, p, e).unwrap() - b.force_n).abs() < 1e-9 * b.force_n.abs(), "{kind}");
            assert!((c.force_n - a.force_n).abs() < 1e-9 * a.force_n.abs(), "{kind}");
            let between = m.ends().active_mm() - e * length;
            let close = |x: Option<f64>, y: Option<f64>| match (x, y) {
                (Some(x), Some(y)) => assert!((x - y).abs() < 1e-9 * y.abs().max(1.0), "{kind} {x} {y}"),
                (x, y) => assert_eq!(x, y, "{kind}"),
            };
            close(b.volume_mm3, a.volume_mm3.map(|v| v - AREA_MM2 * between));
            close(c.volume_mm3, a.volume_mm3.map(|v| v - AREA_MM2 * rod_mm));
            close(b.force_per_pressure_mm2, a.force_per_pressure_mm2.map(|f| f + AREA_MM2));
            close(b.volume_per_contraction_mm3, a.volume_per_contraction_mm3.map(|v| v + AREA_MM2 * length));
            close(b.volume_per_pressure_mm3_per_mpa, a.volume_per_pressure_mm3_per_mpa);
            close(b.stiffness_n_per_mm, a.stiffness_n_per_mm);
            close(c.volume_per_contraction_mm3, a.volume_per_contraction_mm3);
            // Inverses return what was put in.
            let options = Options { two_sided: true, ..Options::default() };
            let pressure = pressure_at(&*through, w, b.force_n, e, options).unwrap();
            assert!((pressure - p).abs() < 1e-6, "{kind} {pressure}");
            let contraction = contraction_at(&*through, w, b.force_n, p, options).unwrap();
            assert!((contraction - e).abs() < 1e-6, "{kind} {contraction}");
        }
    }
}

/// The ideal muscle by hand: with a rod through a seal it is free where cos²θ = (1 − A sin²θ0/(π Ro²))/3, 0.378962 of the prototype with a rod of 20 mm and 0.346106
/// without; one that ends inside, 200 of 285 mm long, holds it at 85/285, with words of its own.
#[test]
fn a_core_rod_moves_the_free_contraction_or_stops_the_muscle() {
    let of = |rod_length_mm| {
        let ends = Terminals { rod_diameter_mm: Some(20.0), rod_length_mm, ..Terminals::default() };
        ModelKind::Ideal.build(&Muscle::prototype().with_terminals(ends).unwrap()).unwrap()
    };
    let (w, options) = (&mut Workspace::new(), Options::default());
    let free = free_contraction(&*of(None), w, 0.2, options).unwrap();
    assert!((free - 0.378_962).abs() < 1e-6, "{free}");
    let inside = of(Some(200.0));
    let stop = 85.0 / 285.0;
    assert_eq!(inside.info().range.stop, Some(stop));
    let refused = free_contraction(&*inside, w, 0.2, options).unwrap_err().to_string();
    assert!(refused.contains("29.82 %, where its core rod meets the other plug"), "{refused}");
    assert_eq!(unloaded_contraction(&*inside, w, 0.2, options).unwrap(), stop);
    let beyond = mckibben::answer::force(&*inside, w, 0.2, 0.3, options).unwrap_err().to_string();
    assert!(beyond.contains("the core rod meets the other plug at a contraction of 29.8 %"), "{beyond}");
    let (wide, thin) = (of(Some(200.0)), ModelKind::Ideal.build(&Muscle::prototype()).unwrap());
    assert_eq!(wide.force_n(w, 0.2, 0.2).unwrap(), thin.force_n(w, 0.2, 0.2).unwrap());
}
