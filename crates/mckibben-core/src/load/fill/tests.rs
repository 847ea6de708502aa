use super::*;
use crate::{
    analysis::{ATMOSPHERE_MPA, Evaluation},
    liquid::{Liquid, LiquidSupply},
    model::{ForceModel, Ideal, ModelKind, ThickWall, Workspace, gauss},
    muscle::{Braid, BraidStiffness, Direction, Friction, Muscle, Rubber, Terminals, Tube},
    rubber::{Law, NeoHookean},
};

const WEIGHT: Load = Load::Force { force_n: 200.0 };

fn stiff() -> Liquid {
    Liquid::named("water", 0.0)
        .unwrap()
        .with_bulk_modulus(1e12)
        .unwrap()
}

fn filling(liquid: &Liquid, volume_mm3: f64) -> Filling<'_> {
    Filling {
        liquid,
        volume_mm3,
        dead_volume_mm3: 0.0,
        load: None,
        held_at: None,
    }
}

/// Closed form: a liquid that keeps its volume moves the ideal muscle to V(ε) = V0 + ΔV, where P =
/// F/A(ε); the pump lifts the weight and nothing else.
#[test]
fn the_ideal_muscle_goes_where_its_volume_is() {
    let model = Ideal::between_ends(&Muscle::prototype());
    let w = &mut Workspace::new();
    let liquid = stiff();
    for e in [0.02, 0.1, 0.2] {
        let volume_mm3 = model.volume(e) - model.volume(0.0);
        let given = Filling {
            load: Some(&WEIGHT),
            ..filling(&liquid, volume_mm3)
        };
        let fill = Evaluation::new(&model, w, Options::default())
            .fill(&given)
            .unwrap();
        let r = &fill.answer.response;
        let p = 200.0 / model.pull(1.0, e);
        assert!(
            (r.contraction - e).abs() < 1e-10 && (r.pressure_mpa / p - 1.0).abs() < 1e-9,
            "{fill:?}"
        );
        assert_eq!((fill.state, r.force_n), (FillState::Balanced, 200.0));
        let lifted = 1e-3 * 200.0 * 285.0 * e;
        assert!((fill.load_work_j / lifted - 1.0).abs() < 1e-9);
        assert!((fill.pump_work_j / lifted - 1.0).abs() < 1e-9, "{fill:?}");
        assert!(fill.muscle_energy_j.abs() < 1e-9 * lifted && fill.liquid_energy_j < 1e-9);
        // Without a load nothing makes a pressure.
        let free = Evaluation::new(&model, w, Options::default())
            .fill(&filling(&liquid, volume_mm3))
            .unwrap();
        assert!(
            (free.answer.response.contraction - e).abs() < 1e-10
                && free.answer.response.pressure_mpa == 0.0
        );
    }
}

/// Closed form: a liquid that keeps its volume takes V(ε) − V0 of the ideal muscle, whatever the
/// dead volume.
#[test]
fn a_stroke_with_a_stiff_liquid_takes_what_the_cavity_grows_by() {
    let model = Ideal::between_ends(&Muscle::prototype());
    let w = &mut Workspace::new();
    let supply = LiquidSupply {
        liquid: stiff(),
        dead_volume_mm3: 4000.0,
    };
    for e in [0.02, 0.1, 0.2] {
        let mut model_at = Evaluation::new(&model, w, Options::default());
        let pushed_mm3 = model_at.liquid_per_stroke_mm3(&supply, 0.2, e).unwrap();
        let there = model.volume(e);
        let rest = model.volume(0.0);
        assert!(
            (pushed_mm3 / (there - rest) - 1.0).abs() < 1e-9,
            "{pushed_mm3}"
        );
    }
}

/// By hand: in a cavity that stays, what is pushed in is compressed: P = K ln(1 + ΔV/(V0 + Vd)),
/// and with 2 % of gas at 3 atmospheres over the first φ = 0.98 exp(−3 pa/K) + 0.005.
#[test]
fn a_held_ideal_muscle_compresses_the_liquid() {
    let model = Ideal::between_ends(&Muscle::prototype());
    let w = &mut Workspace::new();
    let water = Liquid::named("water", 0.0).unwrap();
    let dead = 5000.0;
    let whole = model.volume(0.0) + dead;
    let held = |liquid, volume| Filling {
        dead_volume_mm3: dead,
        held_at: Some(0.0),
        ..filling(liquid, volume)
    };
    let fill = Evaluation::new(&model, w, Options::default())
        .fill(&held(&water, 50.0))
        .unwrap();
    let p = 2179.0 * (50.0 / whole).ln_1p();
    assert!(
        (fill.answer.response.pressure_mpa / p - 1.0).abs() < 1e-9,
        "{fill:?} {p}"
    );
    assert!(
        (fill.compressed_volume_mm3 / 50.0 - 1.0).abs() < 1e-9 && fill.state == FillState::Held
    );
    // ½ P ΔV but for the third power.
    assert!((fill.pump_work_j / (0.5e-3 * p * 50.0) - 1.0).abs() < 1e-3 && fill.load_work_j == 0.0);
    let foam = Liquid::named("water", 0.02).unwrap();
    let p = 3.0 * ATMOSPHERE_MPA;
    let volume = whole * (1.0 / (0.98 * (-p / 2179.0).exp() + 0.005) - 1.0);
    let fill = Evaluation::new(&model, w, Options::default())
        .fill(&held(&foam, volume))
        .unwrap();
    assert!(
        (fill.answer.response.pressure_mpa / p - 1.0).abs() < 1e-9,
        "{fill:?}"
    );
}

/// Against an independent script: the energy of a neo-Hookean wall in strands that keep their
/// length by quadrature of SciPy, P = (F L0 + dW/dε)/(dV/dε), and the root of the balance of
/// volume; the stiffness from slopes by differences of fourth order.
#[test]
fn the_thick_wall_goes_where_an_independent_script_has_it() {
    let rubber = Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa: 0.3 }));
    let braid = Braid {
        angle_deg: 25.0,
        stiffness: BraidStiffness::Inextensible,
        ..Braid::paper()
    };
    let muscle = Muscle::new(
        Tube::new(30.0, 2.0, 200.0, rubber),
        braid,
        Terminals::default(),
        None,
    )
    .unwrap();
    let model = ThickWall::between_ends(&muscle);
    let w = &mut Workspace::new();
    let load = Load::Force { force_n: 500.0 };
    let water = Liquid::named("water", 0.01).unwrap();
    let given = Filling {
        dead_volume_mm3: 10_000.0,
        load: Some(&load),
        ..filling(&water, 60_000.0)
    };
    let fill = Evaluation::new(&model, w, Options::default())
        .fill(&given)
        .unwrap();
    for (name, value, wanted) in [
        (
            "contraction",
            fill.answer.response.contraction,
            0.056_094_952_848_545,
        ),
        (
            "pressure",
            fill.answer.response.pressure_mpa,
            0.133_407_048_303_24,
        ),
        (
            "energy of the muscle",
            fill.muscle_energy_j,
            0.924_388_333_938_2,
        ),
        (
            "energy of the liquid",
            fill.liquid_energy_j,
            0.049_229_445_031_11,
        ),
        ("work on the load", fill.load_work_j, 5.609_495_284_854_5),
        ("work of the pump", fill.pump_work_j, 6.583_113_063_823_8),
    ] {
        assert!(
            (value / wanted - 1.0).abs() < 1e-7,
            "{name}: {value} {wanted}"
        );
    }
    assert!(
        (fill.shut_stiffness_n_per_mm / 6_759.676_899 - 1.0).abs() < 1e-7,
        "{fill:?}"
    );
}

/// Identities: the work of the pump is ∫ (P φ + ψ) dΔV over many fillings, ψ the work on the
/// liquid; it is stored or lifts the load. What the muscle stores does not depend on the way:
/// inflated at its length at rest, then shortened at constant pressure.
#[test]
fn the_work_of_the_pump_is_stored_or_lifts_the_load() {
    let muscle = Muscle::prototype();
    let w = &mut Workspace::new();
    let model = ThickWall::between_ends(&muscle);
    let length = muscle.length_mm();
    let spring = Load::Spring {
        rate_n_per_mm: 6.0,
        preload_n: 80.0,
    };
    let oil = Liquid::named("oil", 0.01).unwrap();
    let most = 40_000.0;
    let given = |volume: f64| Filling {
        dead_volume_mm3: 8000.0,
        load: Some(&spring),
        ..filling(&oil, volume)
    };
    let fill = Evaluation::new(&model, w, Options::default())
        .fill(&given(most))
        .unwrap();
    let p = fill.answer.response.pressure_mpa;
    let e = fill.answer.response.contraction;
    assert!(fill.state == FillState::Balanced && e > 0.02, "{fill:?}");
    // The slope of P(ΔV) breaks where the load is lifted.
    let lifted = Evaluation::new(&model, w, Options::default())
        .pressure_at(80.0, 0.0)
        .unwrap();
    let cavity =
        |p: f64, e: f64, w: &mut Workspace| model.response(w, p, e).unwrap().volume_mm3.unwrap();
    let rest = cavity(0.0, 0.0, w);
    let at_lift = (cavity(lifted, 0.0, w) + 8000.0) / oil.relative_volume(lifted) - rest - 8000.0;
    let mut pump = 0.0;
    for (from, to) in [(0.0, at_lift), (at_lift, most)] {
        for &(x, weight) in gauss(12) {
            let volume = from + 0.5 * (to - from) * (1.0 + x);
            let p = Evaluation::new(&model, w, Options::default())
                .fill(&given(volume))
                .unwrap()
                .answer
                .response
                .pressure_mpa;
            pump +=
                0.5e-3 * (to - from) * weight * (p * oil.relative_volume(p) + oil.energy_mpa(p));
        }
    }
    assert!(
        (fill.pump_work_j / pump - 1.0).abs() < 1e-5,
        "{fill:?} {pump}"
    );
    let sum = fill.muscle_energy_j + fill.liquid_energy_j + fill.load_work_j;
    assert!((sum / fill.pump_work_j - 1.0).abs() < 1e-12 && fill.friction_work_j.is_none());
    let mut stored = p * (cavity(p, e, w) - cavity(p, 0.0, w));
    for &(x, weight) in gauss(40) {
        let at = 0.5 * (1.0 + x);
        let share = 0.5 * weight;
        let grown = model
            .response(w, p * at, 0.0)
            .unwrap()
            .volume_per_pressure_mm3_per_mpa
            .unwrap();
        stored += share * p * p * at * grown;
        stored -= share
            * e
            * length
            * Evaluation::new(&model, w, Direction::Mean)
                .force_n(p, e * at)
                .unwrap();
    }
    assert!(
        (1e-3 * stored / fill.muscle_energy_j - 1.0).abs() < 1e-6,
        "{fill:?} {stored}"
    );
}

/// Against differences: the pull of the same volume at two contractions; on a branch with what
/// friction adds to it.
#[test]
fn shut_in_the_muscle_has_the_slope_of_its_pull_at_constant_volume() {
    let friction = Friction::power_law(10.0, 0.7);
    let muscle = Muscle::prototype().with_friction(Some(friction)).unwrap();
    let model = ThickWall::between_ends(&muscle);
    let w = &mut Workspace::new();
    for (gas, direction) in [
        (0.0, Direction::Mean),
        (0.03, Direction::Mean),
        (0.01, Direction::Contraction),
    ] {
        let water = Liquid::named("water", gas).unwrap();
        let h = 1e-6;
        let options = Options {
            direction,
            ..Options::default()
        };
        let mut at = |e: f64| {
            let given = Filling {
                dead_volume_mm3: 2000.0,
                held_at: Some(e),
                ..filling(&water, 100_000.0)
            };
            Evaluation::new(&model, w, options).fill(&given).unwrap()
        };
        let fill = at(0.08);
        let pull = |f: &Fill| f.answer.response.force_n;
        let slope = (pull(&at(0.08 - h)) - pull(&at(0.08 + h))) / (2.0 * h * 285.0);
        assert!(
            (fill.shut_stiffness_n_per_mm / slope - 1.0).abs() < 1e-5,
            "{fill:?} {slope}"
        );
        assert!(fill.state == FillState::Held && fill.stroke_mm == 0.08 * 285.0);
        assert_eq!(fill.friction_work_j.is_some(), !direction.is_mean());
    }
}

/// The load is lifted at the pressure that `pressure_at` gives, and below it the muscle rests.
#[test]
fn a_small_volume_does_not_lift_the_load() {
    let model = ThickWall::between_ends(&Muscle::prototype());
    let w = &mut Workspace::new();
    let water = Liquid::named("water", 0.0).unwrap();
    let given = Filling {
        load: Some(&WEIGHT),
        ..filling(&water, 300.0)
    };
    let fill = Evaluation::new(&model, w, Options::default())
        .fill(&given)
        .unwrap();
    let lifted = Evaluation::new(&model, w, Options::default())
        .pressure_at(200.0, 0.0)
        .unwrap();
    assert_eq!(
        (fill.state, fill.stroke_mm, fill.load_work_j),
        (FillState::NotLifted, 0.0, 0.0)
    );
    assert!(fill.answer.response.pressure_mpa < lifted && fill.answer.response.force_n < 200.0);
}

#[test]
fn what_has_no_answer_is_told_with_its_numbers() {
    let model = ThickWall::between_ends(&Muscle::prototype());
    let w = &mut Workspace::new();
    let water = Liquid::named("water", 0.0).unwrap();
    let much = Evaluation::new(&model, w, Options::default())
        .fill(&filling(&water, 1e7))
        .unwrap_err();
    let FillError::TooLarge {
        largest_mm3,
        contraction,
        ..
    } = much
    else {
        panic!("{much}")
    };
    assert!(contraction > 0.2, "{much}");
    let less = Evaluation::new(&model, w, Options::default())
        .fill(&filling(&water, 0.99 * largest_mm3))
        .unwrap();
    assert!((less.answer.response.contraction / contraction - 1.0).abs() < 0.1);
    let behind = Filling {
        held_at: Some(-0.05),
        ..filling(&water, 1e4)
    };
    let error = Evaluation::new(&model, w, Options::default())
        .fill(&behind)
        .unwrap_err();
    assert!(matches!(error, FillError::Refused(refused) if refused.fields == ["contraction"]));
}

/// Every model with a cavity, at a weight and held: the volume that is in is the one that was
/// pushed in, by the equation itself.
#[test]
fn every_model_with_a_volume_takes_what_is_pushed_in() {
    let muscle = Muscle::prototype();
    let w = &mut Workspace::new();
    let foam = Liquid::named("water", 0.3).unwrap();
    let mut count = 0;
    for kind in ModelKind::ALL {
        let Ok(model) = kind.build(&muscle) else {
            continue;
        };
        let Ok(Some(rest)) = model.response(w, 0.0, 0.0).map(|r| r.volume_mm3) else {
            continue;
        };
        for held_at in [None, Some(0.06)] {
            let given = Filling {
                dead_volume_mm3: 3000.0,
                load: Some(&WEIGHT).filter(|_| held_at.is_none()),
                held_at,
                ..filling(&foam, 90_000.0)
            };
            let fill = Evaluation::new(&*model, w, Options::default())
                .fill(&given)
                .unwrap_or_else(|e| panic!("{}: {e}", model.info().name));
            let r = &fill.answer.response;
            let inside = (rest + 3000.0 + 90_000.0) * foam.relative_volume(r.pressure_mpa);
            let error = inside / (r.volume_mm3.unwrap() + 3000.0) - 1.0;
            assert!(
                error.abs() < 1e-7,
                "{}: {error} {fill:?}",
                model.info().name
            );
            let way = if held_at.is_some() {
                r.contraction - 0.06
            } else {
                r.force_n - 200.0
            };
            assert!(way.abs() < 1e-6, "{}: {fill:?}", model.info().name);
            count += 1;
        }
    }
    assert!(count >= 12, "{count}");
}

/// A muscle that extends grows longer, and its free end takes no work but that of its rubber.
#[test]
fn a_muscle_that_extends_grows_longer() {
    let braid = Braid {
        angle_deg: 65.0,
        ..Braid::paper()
    };
    let muscle = Muscle::prototype().with_braid(braid).unwrap();
    let model = ThickWall::between_ends(&muscle);
    let w = &mut Workspace::new();
    let liquid = stiff();
    let given = filling(&liquid, 20_000.0);
    let fill = Evaluation::new(&model, w, Options::default())
        .fill(&given)
        .unwrap();
    assert!(
        fill.stroke_mm < -1.0 && fill.state == FillState::Balanced,
        "{fill:?}"
    );
    assert!(fill.answer.response.force_n.abs() < 1e-6 && fill.muscle_energy_j > 0.0);
    assert!((fill.pump_work_j / fill.muscle_energy_j - 1.0).abs() < 1e-6);
    let given = Filling {
        load: Some(&WEIGHT),
        ..given
    };
    let error = Evaluation::new(&model, w, Options::default())
        .fill(&given)
        .unwrap_err();
    assert!(matches!(error, FillError::Refused(refused) if refused.fields == ["load"]));
}
