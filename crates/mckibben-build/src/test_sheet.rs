//! The sheet for the first test: pressures and lengths to set, the force to fill in. `identify` reads it as it is.

use crate::plan::Plan;
use crate::text::{fixed, mm};
use mckibben::muscle::Direction;

pub(crate) fn csv(plan: &Plan) -> String {
    let length_mm = plan.muscle.length_mm();
    let mut out = format!(
        "# {}: first test of a muscle with L0 {} mm. Fill in force_n (N) in each row; leave rows out that you do not measure.\n\
         # Set the distance between the clamps, then the pressure, row by row, without going back: contraction is while the pressure rises,\n\
         # elongation while it falls. The pressure stays at or below {}.\n\
         # Then: mckibben identify muscle.toml --data test.csv -o found.toml\n\
         pressure_mpa,contraction,force_n,branch,distance between the clamps (mm)\n",
        crate::MARK,
        mm(length_mm),
        plan.operating.pressure(plan.operating.pressure_mpa)
    );
    for point in &plan.test {
        let branch = match point.branch {
            Direction::Elongation => "elongation",
            Direction::Contraction | Direction::Mean => "contraction",
        };
        let (p, e) = (fixed(point.pressure_mpa, 5), fixed(point.contraction, 4));
        let distance = fixed(length_mm * (1.0 - point.contraction), 1);
        out.push_str(&format!("{p},{e},,{branch},{distance}\n"));
    }
    out
}
