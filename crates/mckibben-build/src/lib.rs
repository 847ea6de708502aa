//! From a muscle to what a workshop needs: drawings of the muscle and of its plugs, the plugs as
//! bodies, a mould for a cast tube, a bill of materials, a build sheet with steps to tick, a test
//! record, and a sheet for its first test, which `identify` reads back.
//!
//! [`Plan::new`] makes all numbers from the muscle and from the results of a model ([`Operating`]);
//! [`files`] writes them down. A choice of practice that no source states is a constant with a
//! comment.
//!
//! Units: mm, MPa, N.

#![warn(clippy::print_stdout, clippy::print_stderr)]

mod body;
mod cut;
mod drawing;
#[doc(hidden)]
pub mod ends;
mod fitting;
#[doc(hidden)]
pub mod frame;
mod material;
mod mesh;
#[doc(hidden)]
pub mod mould;
mod paper;
mod plan;
mod plug;
mod readme;
mod safety;
mod sheets;
mod shown;
mod sold;
mod stem;
mod step;
mod test_points;
mod text;
mod view;

pub use cut::{Cut, SleeveCut, SleeveLength};
pub use drawing::drawing;
pub use ends::Ends;
pub use fitting::{Fitting, Thread, UnknownFitting};
pub use material::BuildPart;
pub use mesh::Mesh;
pub use paper::paper;
pub use plan::{EndParts, Plan, USUAL_PROOF, Wishes};
pub use plug::{Bolt, Material, Plug, Port, Stress};
#[doc(hidden)]
pub use safety::energy_j;
pub use safety::{EndLoads, Operating, PullAt, Safety, ToMeasure, relief_mpa};
pub use shown::Shown;
pub use stem::Stem;
pub use test_points::{TestPoint, is_blank_sheet};

pub use mckibben_io::files::{Content, File};
pub use mckibben_report::FigureError;

/// The program, in the first line of a file.
const MARK: &str = "mckibben build";

/// All files, the first page first, which links to the others.
pub fn files(plan: &Plan) -> Result<Vec<File>, FigureError> {
    let about = "order, cut list, drawings, steps, record";
    #[cfg(feature = "pdf")]
    let paper = File::bytes("build.pdf", about, paper(plan).to_pdf()?);
    #[cfg(not(feature = "pdf"))]
    let paper = File::text("build.html", about, paper(plan).to_html("")?);
    let bill = material::csv(plan).map_err(|e| FigureError::Drawing(e.to_string()))?;
    let mut out = vec![paper, File::text("bom.csv", "what to buy", bill)];
    let port = format!("{}-plug", plan.fluid());
    for (name, plug) in [(&*port, &plan.air_plug), ("eye-plug", &plan.eye_plug)] {
        out.push(match plug.is_printed() {
            true => File::bytes(
                format!("bodies/{name}.stl"),
                "plug as it lies on the printer",
                plug.printed().to_stl(MARK),
            ),
            false => File::text(
                format!("bodies/{name}.step"),
                "plug to be turned and milled",
                step::text(plug, name),
            ),
        });
    }
    if plan.is_cast() {
        let cap = mould::cap(&plan.cut).to_stl(MARK);
        out.push(File::bytes(
            "bodies/mould-cap.stl",
            "cap of the mould, twice",
            cap,
        ));
    }
    let muscle = mckibben_core::muscle::file::to_toml(&plan.muscle);
    out.extend([
        File::text(
            "test.csv",
            "the sheet of the first test",
            test_points::csv(plan),
        ),
        File::text("muscle.toml", "the muscle itself", muscle),
    ]);
    let readme = readme::markdown(plan, &out);
    out.insert(0, File::text("README.md", "where to begin", readme));
    Ok(out)
}
