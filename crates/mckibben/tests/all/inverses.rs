//! Inverses against the function that they invert, looked at on a fine grid.

use mckibben::analysis::{Options, pressure_at};
use mckibben::model::{ModelKind, Workspace};
use mckibben::muscle::{Braid, BraidStiffness, Muscle, Tube};
use mckibben::random::Random;

/// Soft strands let the pull rise and fall again with the pressure. A pull just below its largest has a pressure, and it is the one
/// where the pull still rises.
#[test]
fn pulls_just_below_the_largest_are_found_where_the_pull_still_rises() {
    let (mut r, mut peaks) = (Random(11), 0);
    for _ in 0..400 {
        let d0 = r.between(10.0, 50.0);
        let tube = Tube {
            outer_diameter_mm: d0,
            wall_mm: d0 * r.between(0.02, 0.12),
            length_mm: d0 * r.between(6.0, 20.0),
            ..Muscle::prototype().tube().clone()
        };
        let stiffness = BraidStiffness::NewtonPerMm(r.log(20.0, 200.0));
        let braid = Braid { angle_deg: r.between(20.0, 30.0), stiffness, ..Braid::paper() };
        let muscle = Muscle::prototype().with_tube(tube).unwrap().with_braid(braid).unwrap();
        let contraction = r.between(0.05, 0.25);
        for kind in [ModelKind::Universal, ModelKind::ThickWall] {
            let (model, w) = (kind.build(&muscle).unwrap(), &mut Workspace::new());
            let pulls = (1..=600).map(|i| 0.002 * f64::from(i));
            let pulls: Vec<(f64, f64)> =
                pulls.map_while(|p| Some((p, model.force_n(w, p, contraction).ok()?))).collect();
            let Some(&(top, most)) = pulls.iter().max_by(|a, b| a.1.total_cmp(&b.1)) else { continue };
            if most < 1.0 || pulls.last().is_none_or(|last| last.1 > 0.98 * most) {
                continue;
            }
            peaks += 1;
            let wanted = 0.9995 * most;
            let options = Options { extrapolate: true, ..Options::default() };
            let found = pressure_at(model.as_ref(), w, wanted, contraction, options);
            let p = found.unwrap_or_else(|e| panic!("{kind:?}, {muscle:?}, {contraction}: {e}"));
            let pull = model.force_n(w, p, contraction).unwrap();
            assert!((pull - wanted).abs() < 1e-6 * wanted, "{pull} and {wanted}");
            assert!(p < top, "{p} lies beyond the largest pull at {top}");
        }
    }
    assert!(peaks > 50, "{peaks}");
}
