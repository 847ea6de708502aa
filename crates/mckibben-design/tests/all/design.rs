//! The design search against brute force and against its own promises.

use mckibben_core::{
    analysis::{Allowed, Evaluation, FailureMode, Options},
    liquid::{Liquid, LiquidSupply},
    load::Load,
    model::{ForceModel, ThickWall, Workspace},
    muscle::{Braid, BraidStiffness, Direction, Muscle, Strands},
    units::Values,
};
use mckibben_design::{
    BraidChoice, Build, CERTAINTY, Check, Demand, JointDemand, Limit, Limits, Objective,
    OperatingPoint, Relaxation, SAFETY, SUPPLY_SHARE, Spec, SpecError, TorqueWanted,
    VALIDATED_STRAND_STRAIN, design, normal_deviations,
};
use std::sync::Arc;

fn thick(muscle: &Muscle) -> Result<Box<dyn ForceModel>, mckibben_core::model::ModelError> {
    Ok(Box::new(ThickWall::between_ends(muscle)))
}

fn spec(force_n: f64, contraction: f64) -> Spec {
    Spec {
        // As the brute force of these tests: by the model's own pull.
        built: false,
        certainty: None,
        direction: Direction::Mean,
        wall_mm: Values::Interval(1.0, 5.0),
        limits: Limits::default(),
        objective: Objective::Diameter,
        supply_share: 1.0,
        ..Spec::new(
            vec![OperatingPoint {
                force_n,
                contraction,
            }],
            0.25,
        )
    }
}

const BUILD: &Build<'_> = &thick;

/// The pressure to begin with is that at which the median of built muscles is what is wanted, more
/// than the model alone says; at the highest pressure the lower nine tenths pull enough, at most by
/// a step of the diameter.
#[test]
fn a_muscle_that_is_built_meets_the_requirement_with_its_chance() {
    let spec = Spec {
        built: true,
        certainty: Some(CERTAINTY),
        ..spec(150.0, 0.1)
    };
    let best = design(&spec, BUILD).unwrap().candidates.remove(0);
    let point = &best.points[0];
    let built = point.built.unwrap();
    assert!((built.predicted_n / 150.0 - 1.0).abs() < 1e-4, "{built:?}");
    let (model, w) = (ThickWall::between_ends(&best.muscle), &mut Workspace::new());
    let mut model = Evaluation::new(&model, w, Options::default());
    let alone = model.pressure_at(150.0, 0.1).unwrap();
    assert!(best.pressure_mpa > alone && point.response.force_n > 150.0);
    let force_n = model.force_n(best.highest_pressure_mpa, 0.1).unwrap();
    let (most, _) = model
        .predicted(best.highest_pressure_mpa, 0.1, force_n)
        .unwrap();
    // 1.2816 standard deviations are left by a tenth (Abramowitz and Stegun 1964, table 26.5).
    let lower_n = most.predicted_n - 1.2816 * most.half_n() / 1.96;
    assert!((150.0..165.0).contains(&lower_n), "{lower_n}");
    let (low, high) = (
        best.pressure_low_mpa.unwrap(),
        best.pressure_high_mpa.unwrap(),
    );
    assert!(low < best.pressure_mpa && best.pressure_mpa < high);
    assert!(high <= best.highest_pressure_mpa, "{high}");
    // Of those that do, 5 % do below the low end: z of 5 % of the chance, on the other side.
    let force_n = model.force_n(low, 0.1).unwrap();
    let (at_low, _) = model.predicted(low, 0.1, force_n).unwrap();
    let z = normal_deviations(0.05 * best.chance.unwrap());
    let pull_n = at_low.predicted_n - z * at_low.half_n() / 1.96;
    assert!((pull_n / 150.0 - 1.0).abs() < 1e-3, "{pull_n}");
}

#[test]
fn lists_of_stock_sizes_agree_with_brute_force() {
    for objective in [
        Objective::Diameter,
        Objective::Pressure,
        Objective::Chance,
        Objective::Air,
    ] {
        let mut spec = spec(300.0, 0.1);
        spec.objective = objective;
        let diameters: Vec<f64> = (20..=40).step_by(2).map(f64::from).collect();
        let walls = vec![1.0, 2.0, 3.0, 4.0];
        spec.outer_diameter_mm = Values::List(diameters.clone());
        spec.wall_mm = Values::List(walls.clone());
        let outcome = design(&spec, BUILD).unwrap();
        let best = &outcome.candidates[0];
        let mut fitting = 0;
        for &d0 in &diameters {
            for &s in &walls {
                let (model, w) = (
                    ThickWall::between_ends(&spec.base.with_section(d0, s).unwrap()),
                    &mut Workspace::new(),
                );
                let pull_n = model.force_n(w, 0.25, 0.1).unwrap();
                if pull_n < 300.0 {
                    continue;
                }
                fitting += 1;
                let mut evaluation = Evaluation::new(&model, w, Options::default());
                let p = evaluation.pressure_at(300.0, 0.1).unwrap();
                let (ours, other) = match objective {
                    Objective::Diameter => (best.muscle.outer_diameter_mm(), d0),
                    Objective::Pressure => (best.pressure_mpa, p),
                    Objective::Chance => (-best.chance.unwrap(), {
                        let (built, _) = evaluation.predicted(0.25, 0.1, pull_n).unwrap();
                        let z = (built.predicted_n - 300.0) / (built.half_n() / 1.96);
                        -mckibben_design::normal_share(z)
                    }),
                    Objective::BulgedDiameter | Objective::Length | Objective::Mass => {
                        unreachable!()
                    }
                    Objective::Air => {
                        let air = evaluation.air_per_stroke(p, 0.1).unwrap();
                        (
                            best.largest(|q| q.air_normal_litres).unwrap(),
                            air.normal_litres,
                        )
                    }
                };
                assert!(
                    ours <= other + 1e-12,
                    "{objective:?}: {ours} against {other} at {d0}, {s}"
                );
            }
        }
        assert_eq!(outcome.looked_at, (44, fitting));
    }
}

/// Oil with gas and a dead volume, for 300 N at 10 % of one muscle.
fn with_oil() -> Spec {
    let liquid = Liquid::named("oil", 0.02).unwrap();
    Spec {
        liquid: Some(LiquidSupply {
            liquid,
            dead_volume_mm3: 5000.0,
        }),
        outer_diameter_mm: Values::List(vec![30.0]),
        wall_mm: Values::List(vec![2.0]),
        ..spec(300.0, 0.1)
    }
}

/// The equation with cavities of the model: ΔV = (V + Vd)/φ − V0 − Vd, which is V − V0 of a liquid
/// that keeps its volume; its mass fills both.
#[test]
fn a_liquid_takes_the_place_of_the_air_and_its_volume_is_that_of_the_equation() {
    let mut spec = with_oil();
    let stiff = Liquid::named("water", 0.0)
        .unwrap()
        .with_bulk_modulus(1e12)
        .unwrap();
    for liquid in [
        spec.liquid.clone().unwrap(),
        LiquidSupply {
            liquid: stiff,
            dead_volume_mm3: 700.0,
        },
    ] {
        spec.liquid = Some(liquid.clone());
        let outcome = design(&spec, BUILD).unwrap();
        let (best, w) = (&outcome.candidates[0], &mut Workspace::new());
        let model = ThickWall::between_ends(&best.muscle);
        let mut cavity = |p: f64, e: f64| model.response(w, p, e).unwrap().volume_mm3.unwrap();
        let (there, rest, dead) = (
            cavity(best.pressure_mpa, 0.1),
            cavity(0.0, 0.0),
            liquid.dead_volume_mm3,
        );
        let l = &liquid.liquid;
        let shrunk = l.relative_volume(best.pressure_mpa);
        let pushed = if l.bulk_modulus_mpa == 1e12 {
            there - rest
        } else {
            (there + dead) / shrunk - rest - dead
        };
        let found = best.largest(|q| q.liquid_volume_mm3).unwrap();
        assert!((found / pushed - 1.0).abs() < 1e-9, "{found} {pushed}");
        assert!(best.largest(|q| q.air_normal_litres).is_none());
    }
}

/// The volume that a muscle takes is the edge of the limit: a millionth more and it fits, a
/// millionth less and it is refused for it; what is promised to help does.
#[test]
fn the_largest_liquid_volume_binds_at_the_volume_that_is_found() {
    let mut spec = with_oil();
    let volume_mm3 = design(&spec, BUILD).unwrap().candidates[0]
        .largest(|q| q.liquid_volume_mm3)
        .unwrap();
    spec.limits.liquid_volume_mm3 = Some(volume_mm3 * (1.0 + 1e-6));
    let outcome = design(&spec, BUILD).unwrap();
    assert_eq!(outcome.candidates.len(), 1);
    assert_eq!(outcome.candidates[0].spare[0].limit, Limit::LiquidVolume);
    spec.limits.liquid_volume_mm3 = Some(volume_mm3 * (1.0 - 1e-6));
    let outcome = design(&spec, BUILD).unwrap();
    assert!(outcome.candidates.is_empty());
    let Check {
        limit,
        value: needs,
        bound: limit_mm3,
        ..
    } = outcome.rejected[0].check;
    assert_eq!(limit, Limit::LiquidVolume);
    assert!((needs / volume_mm3 - 1.0).abs() < 1e-12 && limit_mm3 < volume_mm3);
    // Without a liquid the limit has no meaning.
    spec.liquid = None;
    assert_eq!(
        design(&spec, BUILD).unwrap_err(),
        SpecError::NoLiquid(limit_mm3)
    );
}

/// Against all muscles of a list: none that pulls enough takes less liquid than the first.
#[test]
fn the_objective_air_with_a_liquid_finds_the_least_liquid_of_a_list() {
    let (diameters, walls) = (vec![24.0, 28.0, 32.0, 36.0], vec![1.0, 2.0, 3.0]);
    let spec = Spec {
        objective: Objective::Air,
        outer_diameter_mm: Values::List(diameters.clone()),
        wall_mm: Values::List(walls.clone()),
        ..with_oil()
    };
    let outcome = design(&spec, BUILD).unwrap();
    let best = outcome.candidates[0]
        .largest(|q| q.liquid_volume_mm3)
        .unwrap();
    let (w, mut least) = (&mut Workspace::new(), f64::INFINITY);
    for (d0, s) in diameters
        .iter()
        .flat_map(|d0| walls.iter().map(move |s| (*d0, *s)))
    {
        let model = ThickWall::between_ends(&spec.base.with_section(d0, s).unwrap());
        if model.force_n(w, 0.25, 0.1).unwrap() < 300.0 {
            continue;
        }
        let mut evaluation = Evaluation::new(&model, w, Options::default());
        let p = evaluation.pressure_at(300.0, 0.1).unwrap();
        let supply = spec.liquid.as_ref().unwrap();
        least = least.min(evaluation.liquid_per_stroke_mm3(supply, p, 0.1).unwrap());
    }
    assert!((best / least - 1.0).abs() < 1e-9, "{best} {least}");
}

/// By search, of muscles in lists: each change makes one of them fit, and none fits with 98 % of
/// it.
#[test]
fn every_change_makes_a_muscle_fit_and_none_is_larger_than_it_has_to_be() {
    let lists = |spec: Spec| Spec {
        outer_diameter_mm: Values::List((0..10).map(|i| 8.0 + 4.0 * f64::from(i)).collect()),
        wall_mm: Values::List(vec![1.0, 2.0, 4.0]),
        ..spec
    };
    let mut narrow = lists(spec(700.0, 0.15));
    narrow.limits.bulged_diameter_mm = Some(50.0);
    let mut stiff = lists(spec(100.0, 0.15));
    stiff.limits.stretch = Some(1.05);
    let load = Demand::Stroke {
        load: Load::Mass {
            mass_kg: 120.0,
            level: false,
        },
        stroke_mm: 57.0,
    };
    let specs = [
        lists(spec(1200.0, 0.2)),
        Spec {
            wanted: load,
            ..lists(spec(1.0, 0.1))
        },
        Spec {
            max_pressure_mpa: 2.0,
            ..lists(spec(12e3, 0.1))
        },
        narrow,
        stiff,
    ];
    let mut kinds = std::collections::BTreeSet::new();
    for spec in specs {
        let fit = |spec: &Spec| !design(spec, BUILD).unwrap().candidates.is_empty();
        let outcome = design(&spec, BUILD).unwrap();
        let changes = outcome.relaxations;
        assert!(!changes.is_empty(), "{:?}", outcome.rejected[0]);
        for change in &changes {
            let mut changed = spec.clone();
            change.apply(&mut changed);
            assert!(fit(&changed), "{change:?}");
            let towards = |new: f64, old: f64| old + 0.98 * (new - old);
            match change {
                Relaxation::MaxPressure { pressure_mpa, .. } => {
                    changed.max_pressure_mpa = towards(*pressure_mpa, spec.max_pressure_mpa);
                }
                Relaxation::Force { share, .. } => {
                    changed.wanted = spec.wanted.scaled(towards(*share, 1.0), 1.0)
                }
                Relaxation::MinBurstMargin { burst_margin } => {
                    changed.limits.burst_margin = Some(towards(*burst_margin, SAFETY));
                }
                Relaxation::MaxStrandStrain { strand_strain } => {
                    changed.limits.strand_strain =
                        Some(towards(*strand_strain, VALIDATED_STRAND_STRAIN));
                }
                Relaxation::MaxBulgedDiameter { bulged_diameter_mm } => {
                    changed.limits.bulged_diameter_mm = Some(towards(*bulged_diameter_mm, 50.0));
                }
                Relaxation::MaxStretch { max_stretch } => {
                    changed.limits.stretch = Some(towards(*max_stretch, 1.05))
                }
                Relaxation::Contraction { share } => {
                    // The whole way again, and the shorter one.
                    let back = towards(*share, 1.0) / share;
                    Relaxation::Contraction { share: back }.apply(&mut changed);
                }
                // No single one does.
                Relaxation::Together { .. } => {
                    assert_eq!(changes.len(), 1);
                    continue;
                }
                other => panic!("{other:?}"),
            }
            assert!(!fit(&changed), "{change:?}");
            kinds.insert(format!("{change:?}").split(' ').next().unwrap().to_owned());
        }
    }
    assert!(kinds.len() >= 5, "{kinds:?}");
}

/// A sleeve as sold keeps its strand length per turn: sinθ0 = π D0/ℓ.
#[test]
fn a_bought_sleeve_takes_its_angle_from_the_diameter() {
    let mut spec = spec(300.0, 0.1);
    spec.braid = BraidChoice::StrandLengthPerTurn(vec![200.0]);
    for candidate in design(&spec, BUILD).unwrap().candidates {
        let turn = candidate.muscle.strand_length_per_turn_mm();
        assert!((turn - 200.0).abs() < 1e-9, "{turn}");
    }
}

/// By hand: the allowed pressure is the least failure over its factor, and a muscle is used no
/// further.
#[test]
fn a_muscle_is_used_up_to_its_allowed_pressure() {
    let mut spec = spec(300.0, 0.1);
    spec.supply_share = SUPPLY_SHARE;
    spec.limits.burst_margin = Some(3.0);
    let braid = Braid {
        stiffness: BraidStiffness::OfStrands,
        strands: Some(Strands::new(96, Some((0.3, 2500.0)), Some(60.0))),
        ..Braid::paper()
    };
    spec.base = spec.base.with_braid(braid).unwrap();
    for supply_mpa in [0.25, 2.5] {
        spec.max_pressure_mpa = supply_mpa;
        let outcome = design(&spec, BUILD).unwrap();
        assert!(!outcome.candidates.is_empty());
        for c in &outcome.candidates {
            // With room for the relief valve, and for the regulator.
            let allowed_mpa = c.burst.pressure_mpa().unwrap() / 3.0;
            let highest_mpa = (allowed_mpa / 1.1).min(0.95 * supply_mpa);
            assert!(c.pressure_mpa <= c.highest_pressure_mpa);
            assert!((c.highest_pressure_mpa / highest_mpa - 1.0).abs() < 1e-9);
        }
    }
    spec.limits.burst_margin = Some(300.0);
    let outcome = design(&spec, BUILD).unwrap();
    assert!(outcome.candidates.is_empty());
    assert!(matches!(
        outcome.rejected[0].check.by,
        Some(Allowed {
            by: FailureMode::Strands,
            ..
        })
    ));
}

#[test]
fn the_answer_does_not_depend_on_the_number_of_threads() {
    let spec = spec(700.0, 0.15);
    let run = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        format!("{:?}", pool.install(|| design(&spec, BUILD).unwrap()))
    };
    assert_eq!(run(1), run(4));
}

#[test]
fn combinations_that_are_no_muscle_say_why() {
    let mut spec = spec(700.0, 0.15);
    spec.outer_diameter_mm = Values::List(vec![5.0]);
    spec.wall_mm = Values::List(vec![3.0]);
    let error = design(&spec, BUILD).unwrap_err().to_string();
    assert!(
        error.contains("the wall must be thinner than the radius"),
        "{error}"
    );
}

/// Virtual work: the muscles that a design finds for torques, put on the pulley that it names, give
/// these torques by the joint's own equations; a grid of radii holds no smaller muscle.
#[test]
fn a_joint_that_was_designed_has_its_torques_and_no_radius_has_a_smaller_muscle() {
    use mckibben_core::joint::{BoundJoint, Joint, JointMuscle, Link, Path, Turning};
    let torque = |(torque_nm, angle_deg)| TorqueWanted {
        torque_nm,
        angle_deg,
    };
    let torques = [(8.0, 45.0), (3.0, 60.0)].map(torque).to_vec();
    let joint = |radii_mm: Values| JointDemand {
        torques: torques.clone(),
        largest_angle_deg: 60.0,
        radii_mm,
        beside: false,
    };
    let spec = Spec {
        max_pressure_mpa: 0.6,
        limits: Limits {
            bulged_diameter_mm: Some(50.0),
            ..Limits::default()
        },
        ..spec(1.0, 0.0)
    };
    let on_radii = |radii: Values| {
        let spec = Spec {
            wanted: Demand::Joint(joint(radii)),
            ..spec.clone()
        };
        design(&spec, BUILD).unwrap()
    };
    let outcome = on_radii(Values::Interval(5.0, 40.0));
    let best = &outcome.candidates[0];
    let radius_mm = best.radius_mm;
    let on = |radius_mm: f64| JointMuscle {
        muscle: best.muscle.clone(),
        path: Path::Pulley { radius_mm },
        contraction_at_neutral: radius_mm.abs() * 60f64.to_radians() / best.muscle.length_mm(),
    };
    let built = Joint::new(
        vec![on(radius_mm), on(-radius_mm)],
        None,
        Link::default(),
        (-60.0, 60.0),
    )
    .unwrap();
    let model: Arc<dyn ForceModel> = Arc::new(ThickWall::between_ends(&best.muscle));
    let model = BoundJoint::new(built, vec![model.clone(), model], true).unwrap();
    let w = &mut [Workspace::new(), Workspace::new()][..];
    let least = torques.iter().map(
        |&TorqueWanted {
             torque_nm: torque,
             angle_deg: angle,
         }| {
            let there = model
                .point_at(w, &[0.6, 0.0], angle, Turning::Mean)
                .unwrap();
            assert!(there.muscles[1].answer.response.force_n.abs() < 1e-9);
            there.torque_nm / torque
        },
    );
    let least = least.fold(f64::INFINITY, f64::min);
    // A step of D0 is worth a tenth of the pull.
    assert!((1.0..1.1).contains(&least), "{least}");
    for i in 0..36 {
        let other = on_radii(Values::List(vec![5.0 + f64::from(i)]));
        if let Some(other) = other.candidates.first() {
            assert!(best.muscle.outer_diameter_mm() <= other.muscle.outer_diameter_mm() + 1e-9);
        }
    }
}

/// What cannot be searched is refused with its value, and is no panic and no "nothing fits".
#[test]
fn a_specification_that_is_none_is_refused_with_its_field() {
    let refused = |field: &str, change: &dyn Fn(&mut Spec)| {
        let mut spec = spec(300.0, 0.1);
        change(&mut spec);
        match design(&spec, BUILD) {
            Err(SpecError::Refused(blamed, said)) => {
                assert_eq!(blamed, field, "{said}");
                assert!(said.starts_with(&format!("`{field}` is ")), "{said}");
                said
            }
            other => panic!("{field}: {other:?}"),
        }
    };
    refused("top", &|spec| spec.top = 0);
    refused("count", &|spec| spec.count = u32::MAX);
    let reversed = || Values::Interval(80.0, 5.0);
    let said = refused("outer_diameter_mm", &|spec| {
        spec.outer_diameter_mm = reversed()
    });
    assert!(said.contains("80"), "{said}");
    refused("wall_mm", &|spec| {
        spec.wall_mm = Values::List(vec![f64::NAN])
    });
    refused("max_pressure_mpa", &|spec| spec.max_pressure_mpa = -0.6);
    refused("supply_share", &|spec| spec.supply_share = f64::NAN);
    refused("certainty", &|spec| spec.certainty = Some(0.2));
    refused("min_burst_margin", &|spec| {
        spec.limits.burst_margin = Some(1.0)
    });
    refused("max_stretch", &|spec| {
        spec.limits.stretch = Some(f64::INFINITY)
    });
    let said = refused("max_mass_kg", &|spec| spec.limits.mass_g = Some(-50.0));
    assert!(said.contains("-0.05"), "{said}");
}
