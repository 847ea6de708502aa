//! A prestretch from measured pulls.

use mckibben::model::{ForceModel, ThickWall, Workspace};
use mckibben::muscle::measures::PRESTRETCH;
use mckibben::muscle::{Braid, BraidStiffness, Direction, Muscle, Rubber, Terminals, Tube};
use mckibben::rubber::{Law, MooneyRivlin};
use mckibben_fit::identify::{Parameter, Request, Target, identify};
use mckibben_fit::measured::{DataPoint, MeasuredPoint};

fn prestretched(wall_mm: f64, mu_mpa: f64, stiffness: BraidStiffness, prestretch: f64) -> Muscle {
    let rubber = Rubber::new(Law::MooneyRivlin(MooneyRivlin { c10_mpa: 0.5 * mu_mpa, c01_mpa: 0.0 }));
    let braid = Braid { angle_deg: 25.0, stiffness, ..Braid::paper() };
    let tube = Tube::new(19.0, wall_mm, 200.0, rubber);
    Muscle::new(tube, braid, Terminals::default(), None).unwrap().with(&PRESTRETCH, prestretch).unwrap()
}

#[test]
fn a_prestretch_is_identified_from_pulls_and_a_wrong_one_refused() {
    let truth = prestretched(1.5, 0.4, BraidStiffness::NewtonPerMm(300.0), 1.15);
    let model = ThickWall::new(&truth);
    let mut points: Vec<DataPoint> = vec![];
    for p in [0.1, 0.2, 0.3] {
        for e in [0.0, 0.05, 0.1, 0.15] {
            let force_n = model.force_n(&mut Workspace::new(), p, e).unwrap();
            let branch = Some(Direction::Mean);
            points.push(DataPoint::new(MeasuredPoint { pressure_mpa: p, contraction: e, force_n, branch }));
        }
    }
    let start = truth.with(&PRESTRETCH, 1.0).unwrap();
    let free = [Parameter::free(Target::parse("tube.prestretch", &start).unwrap())];
    let request = Request::new(&start, &free, &points, &|m| Ok(Box::new(ThickWall::new(m))));
    let result = identify(&request).unwrap();
    let value = result.muscle.tube().prestretch;
    assert!((value - 1.15).abs() < 1e-6 && result.parameters[0].identifiable, "{value}");
    let refused = start.with(&PRESTRETCH, 3.0).unwrap_err().to_string();
    assert_eq!(refused, "tube.prestretch is 3; it must lie between 0.5 and 2");
    assert_ne!(truth.digest(), start.digest());
    // 200 mm of it were 200/1.15 mm before, and 20 mm on each plug.
    assert!((truth.build_sheet().tube_cut_mm - (200.0 / 1.15 + 40.0)).abs() < 1e-12);
}
