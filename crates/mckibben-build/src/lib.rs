//! From a muscle to what a workshop needs: a drawing (SVG, PDF), two plugs (STL), a cut list, a
//! bill of materials, steps with the numbers of this muscle, and a sheet for its first test, which
//! `identify` reads back.
//!
//! [`Plan::new`] makes all numbers from the muscle and from the results of a model ([`Operating`]);
//! [`files`] writes them down. A choice of practice that no source states is a constant with a
//! comment.
//!
//! Units: mm, MPa, N.

#![warn(clippy::print_stdout, clippy::print_stderr)]

mod clamps;
mod cut;
mod drawing;
mod frame;
mod material;
mod mesh;
mod plan;
mod plug;
mod plug_drawing;
mod safety;
mod steps;
mod test_points;
mod text;
mod view;

pub use clamps::Clamps;
pub use cut::{Cut, SleeveCut, SleeveLength};
pub use plug::{AirPlug, EyePlug, Fitting, Stem, UnknownFitting};

/// The program, in the first line of a file.
const MARK: &str = "mckibben build";
pub use material::BuildPart;
pub use mesh::Mesh;
pub use plan::{Plan, Wishes};
pub use safety::{Operating, Safety, ToMeasure, highest_mpa, proof_mpa, relief_mpa};
pub use test_points::TestPoint;

pub use mckibben_io::files::{Content, File};
use mckibben_report::FigureError;

/// The drawing of the muscle as SVG.
pub fn drawing_svg(plan: &Plan) -> Result<String, FigureError> {
    drawing::on_paper(plan).to_svg()
}

/// All files: the steps first, which link to the others.
pub fn files(plan: &Plan) -> Result<Vec<File>, FigureError> {
    let drawing = drawing::on_paper(plan);
    let plugs = plug_drawing::on_paper(plan);
    let text = File::text;
    let bytes = File::bytes;
    let air = plan.air_plug.mesh();
    let eye = plan.eye_plug.mesh();
    let mut out = vec![
        text("drawing.svg", "drawing of the muscle", drawing.to_svg()?),
        #[cfg(feature = "pdf")]
        bytes(
            "drawing.pdf",
            "the same for printing, A4",
            mckibben_report::to_pdf(std::slice::from_ref(&drawing), "drawing")?,
        ),
        text("plugs.svg", "drawing of both plugs", plugs.to_svg()?),
        #[cfg(feature = "pdf")]
        bytes(
            "plugs.pdf",
            "the same for printing, A4",
            mckibben_report::to_pdf(std::slice::from_ref(&plugs), "plugs")?,
        ),
        bytes(
            "air-plug.stl",
            "plug with the air passage, for the printer",
            air.to_stl(MARK),
        ),
        bytes(
            "eye-plug.stl",
            "closed plug with the eye, for the printer",
            eye.to_stl(MARK),
        ),
        text(
            "test.csv",
            "what to measure, and the sheet for it; `identify` reads it",
            test_points::csv(plan),
        ),
        text(
            "muscle.toml",
            "the muscle itself",
            mckibben_core::muscle::file::to_toml(&plan.muscle),
        ),
    ];
    let readme = steps::markdown(plan, &out);
    out.insert(
        0,
        text("README.md", "cut list, bill of materials, steps", readme),
    );
    Ok(out)
}
