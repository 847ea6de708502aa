//! Validation against a measured muscle: B. Tondu, JIMSS 23 (2012) 225–253, Fig. 3, 20° muscle.

use mckibben::analysis::Options;
use mckibben::model::{ForceModel, Ideal, ThickWall, Workspace};
use mckibben::muscle::measures::END_FACTOR;
use mckibben::muscle::{Braid, BraidStiffness, Muscle, Rubber, Terminals, Tube};
use mckibben::rubber::{Law, NeoHookean};
use mckibben_fit::compare::compare;
use mckibben_fit::identify::{Parameter, Request, Target, identify};
use mckibben_fit::least_squares::Loss;
use mckibben_fit::measured::{DataPoint, MeasuredPoint, mean_of_branches, read_measured};

fn points() -> Vec<MeasuredPoint> {
    let text = include_bytes!("../../../../data/tondu2012/static_force_20deg.csv");
    mean_of_branches(&read_measured(&text[..]).unwrap())
}

/// D0 14, s 0.49, L0 300, 20°, rayon: strands that hardly stretch. The rubber is not stated.
fn muscle() -> Muscle {
    let rubber = Rubber::of(Law::NeoHookean(NeoHookean { mu_mpa: 0.5 }));
    let tube = Tube::new(14.0, 0.49, 300.0, rubber);
    let braid = Braid { angle_deg: 20.0, stiffness: BraidStiffness::Inextensible, ..Braid::paper() };
    Muscle::new(tube, braid, Terminals::default(), None).unwrap()
}

/// The documented finding: the ideal formula misses the mean of the branches by about 92–95 N rms.
#[test]
fn the_ideal_formula_misses_by_92_to_95_n_rms() {
    let error =
        compare(&Ideal::new(&muscle()), &mut Workspace::new(), &points(), Options::default()).unwrap();
    println!("{error:?}");
    assert!((91.5..95.5).contains(&error.rms_n), "{error:?}");
}

/// Thick-wall with one fitted modulus and one end factor: about 6 N rms, end factor 1.11.
#[test]
fn thick_wall_with_a_fitted_modulus_and_end_factor_misses_by_about_6_n_rms() {
    let build = |m: &Muscle| Ok(Box::new(ThickWall::new(m)) as Box<dyn ForceModel>);
    let points: Vec<DataPoint> = points().into_iter().map(DataPoint::of).collect();
    let free = [Target::Modulus, Target::Measure(&END_FACTOR)].map(Parameter::free);
    let muscle = muscle();
    let request = Request {
        muscle: &muscle,
        free: &free,
        fixed: &[],
        points: &points,
        loss: Loss::Squares,
        two_sided: true,
        history: false,
    };
    let best = identify(&request, &build).unwrap();
    println!("{:?} {}", best.parameters, best.rms_n);
    assert!((5.0..7.0).contains(&best.rms_n), "{:?} {}", best.parameters, best.rms_n);
    assert!((best.parameters[1].value - 1.11).abs() < 0.01, "{:?}", best.parameters);
}
