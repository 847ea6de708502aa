//! Every field of a specification × values that are none: an error that says so, or an answer whose
//! numbers are finite; never a panic, an endless loop, or a NaN that is taken for a bound.

use mckibben_core::{
    liquid::{Liquid, LiquidSupply},
    load::Load,
    model::{ForceModel, Ideal, ModelError},
    muscle::Muscle,
    units::{
        Values,
        typed::{Pressure, Ratio},
    },
};
use mckibben_design::{
    BraidChoice, Build, Demand, JointDemand, OperatingPoint, Spec, TorqueWanted, design,
};

const NUMBERS: [f64; 12] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.0,
    -0.0,
    -1.0,
    5e-324,
    1e-9,
    1e9,
    1e300,
    -1e300,
    f64::MAX,
];
const COUNTS: [u32; 12] = [
    0,
    1,
    2,
    6,
    7,
    8,
    100,
    10_000,
    1 << 20,
    1 << 31,
    u32::MAX - 1,
    u32::MAX,
];

const BUILD: &Build<'_> = &|muscle: &Muscle| -> Result<Box<dyn ForceModel>, ModelError> {
    Ok(Box::new(Ideal::between_ends(muscle)))
};

fn spec() -> Spec {
    Spec {
        outer_diameter_mm: Values::List(vec![20.0, 30.0]),
        wall_mm: Values::List(vec![2.0]),
        ..Spec::pull(300.0, Ratio(0.1), Pressure(0.3)).length_mm(200.0)
    }
}

fn list(value: f64) -> Values {
    Values::List(vec![value])
}

type Change = fn(&mut Spec, f64);

/// Fields that may be below zero, and those that `Spec::check` does not look at yet: they answer
/// finite numbers whatever they hold.
const NOT_CHECKED: [&str; 5] = [
    "angle",
    "liquid",
    "longer_mm",
    "longer_mm first",
    "least_slenderness",
];

/// What holds a NaN is refused: no comparison with it says anything.
const FIELDS: &[(&str, Change)] = &[
    ("force", |s, v| {
        s.wanted = points(OperatingPoint {
            force_n: v,
            contraction: 0.1,
        })
    }),
    ("contraction", |s, v| {
        s.wanted = points(OperatingPoint {
            force_n: 300.0,
            contraction: v,
        })
    }),
    ("load", |s, v| {
        s.wanted = Demand::Stroke {
            load: Load::Force { force_n: v },
            stroke_mm: 10.0,
        }
    }),
    ("stroke", |s, v| {
        s.wanted = Demand::Stroke {
            load: Load::Force { force_n: 100.0 },
            stroke_mm: v,
        }
    }),
    ("way", |s, v| {
        s.wanted = Demand::Contraction {
            load: Load::Force { force_n: 100.0 },
            contraction: v,
        }
    }),
    ("torque", |s, v| s.wanted = joint([v, 10.0, 30.0, 25.0])),
    ("angle", |s, v| s.wanted = joint([2.0, v, 30.0, 25.0])),
    ("largest angle", |s, v| {
        s.wanted = joint([2.0, 10.0, v, 25.0])
    }),
    ("radius", |s, v| s.wanted = joint([2.0, 10.0, 30.0, v])),
    ("pitch_mm", |s, v| s.pitch_mm = Some(v)),
    ("max_pressure_mpa", |s, v| s.max_pressure_mpa = v),
    ("supply_share", |s, v| s.supply_share = v),
    ("liquid", |s, v| {
        s.liquid = Some(LiquidSupply {
            liquid: Liquid::named("water", 0.0).unwrap(),
            dead_volume_mm3: v,
        });
    }),
    ("outer_diameter_mm", |s, v| s.outer_diameter_mm = list(v)),
    ("outer_diameter_mm to", |s, v| {
        s.outer_diameter_mm = Values::Interval(10.0, v)
    }),
    ("outer_diameter_mm from", |s, v| {
        s.outer_diameter_mm = Values::Interval(v, 30.0)
    }),
    ("wall_mm", |s, v| s.wall_mm = list(v)),
    ("wall_mm to", |s, v| s.wall_mm = Values::Interval(1.0, v)),
    ("wall_mm from", |s, v| s.wall_mm = Values::Interval(v, 3.0)),
    ("length_mm", |s, v| s.length_mm = Some(list(v))),
    ("length_mm to", |s, v| {
        s.length_mm = Some(Values::Interval(100.0, v))
    }),
    ("longer_mm", |s, v| s.longer_mm = vec![v]),
    ("longer_mm first", |s, v| s.longer_mm = vec![v, 400.0]),
    ("least_slenderness", |s, v| s.least_slenderness = v),
    ("angle of the braid", |s, v| {
        s.braid = BraidChoice::Angle(list(v))
    }),
    ("strand length", |s, v| {
        s.braid = BraidChoice::StrandLengthPerTurn(vec![v])
    }),
    ("bulged_diameter_mm", |s, v| {
        s.limits.bulged_diameter_mm = Some(v)
    }),
    ("envelope_mm", |s, v| s.limits.envelope_mm = Some(v)),
    ("mass_g", |s, v| s.limits.mass_g = Some(v)),
    ("burst_margin", |s, v| s.limits.burst_margin = Some(v)),
    ("tube_margin", |s, v| s.limits.tube_margin = Some(v)),
    ("stretch", |s, v| s.limits.stretch = Some(v)),
    ("strand_strain", |s, v| s.limits.strand_strain = Some(v)),
    ("liquid_volume_mm3", |s, v| {
        s.liquid = Some(LiquidSupply {
            liquid: Liquid::named("water", 0.0).unwrap(),
            dead_volume_mm3: 100.0,
        });
        s.limits.liquid_volume_mm3 = Some(v);
    }),
    ("certainty", |s, v| s.certainty = Some(v)),
];

fn points(one: OperatingPoint) -> Demand {
    Demand::Points { points: vec![one] }
}

fn joint([torque_nm, angle_deg, largest_angle_deg, radius_mm]: [f64; 4]) -> Demand {
    Demand::Joint(JointDemand {
        torques: vec![TorqueWanted {
            torque_nm,
            angle_deg,
        }],
        largest_angle_deg,
        radii_mm: list(radius_mm),
        beside: true,
    })
}

/// An answer of finite numbers, or an error in words.
#[track_caller]
fn answered(what: &str, spec: &Spec) -> bool {
    match design(spec, BUILD) {
        Ok(outcome) => {
            for one in &outcome.candidates {
                let muscle = &one.muscle;
                let numbers = [
                    one.pressure_mpa,
                    muscle.outer_diameter_mm(),
                    muscle.wall_mm(),
                    muscle.length_mm(),
                ];
                assert!(numbers.iter().all(|n| n.is_finite()), "{what}: {numbers:?}");
                assert!(one.chance.is_none_or(f64::is_finite), "{what}");
            }
            true
        }
        Err(error) => {
            assert!(error.to_string().len() > 10, "{what}: {error}");
            false
        }
    }
}

#[test]
fn every_field_with_values_that_are_none_is_refused_or_answered() {
    assert!(answered("as it is", &spec()));
    let mut taken = vec![];
    for (name, change) in FIELDS {
        for value in NUMBERS {
            let mut spec = spec();
            change(&mut spec, value);
            let begun = std::time::Instant::now();
            let is_answered = answered(&format!("{name} {value:e}"), &spec);
            assert!(
                begun.elapsed().as_secs() < 20,
                "{name} {value:e} takes long"
            );
            // Of bounds and shares what is no number, below zero or without end says nothing.
            if is_answered && (value.is_nan() || value < 0.0) && !NOT_CHECKED.contains(name) {
                taken.push(format!("{name} {value:e}"));
            }
        }
    }
    assert!(taken.is_empty(), "{taken:#?}");
}

#[test]
fn every_count_ends() {
    for count in COUNTS {
        for change in [
            (|s, n| s.count = n) as fn(&mut Spec, u32),
            |s, n| s.most_side_by_side = n,
            |s, n| s.top = n as usize,
            |s, n| s.top = usize::MAX - n as usize,
        ] {
            let mut spec = spec();
            change(&mut spec, count);
            answered(&count.to_string(), &spec);
        }
    }
    for length in [0, 1, 2, 2_000_000] {
        for change in [
            (|s, list| s.outer_diameter_mm = Values::List(list)) as fn(&mut Spec, Vec<f64>),
            |s, list| s.wall_mm = Values::List(list),
            |s, list| s.length_mm = Some(Values::List(list)),
            |s, list| s.braid = BraidChoice::StrandLengthPerTurn(list),
        ] {
            let mut spec = spec();
            change(&mut spec, vec![300.0; length]);
            answered(&format!("a list of {length}"), &spec);
        }
    }
}
