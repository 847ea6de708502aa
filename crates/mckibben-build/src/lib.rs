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

mod build_sheet;
mod cut;
mod drawing;
#[doc(hidden)]
pub mod ends;
mod fitting;
mod frame;
mod material;
mod mesh;
#[doc(hidden)]
pub mod mould;
mod plan;
mod plug;
mod plug_drawing;
mod readme;
mod record;
mod safety;
mod shown;
mod sketch;
mod stem;
mod step;
mod test_points;
mod text;
mod view;

pub use cut::{Cut, SleeveCut, SleeveLength};
pub use ends::Ends;
pub use fitting::{Fitting, Thread, UnknownFitting};
pub use material::BuildPart;
pub use mesh::Mesh;
pub use plan::{EndParts, Plan, Wishes};
pub use plug::{Bolt, Material, Plug, Port, Stress};
#[doc(hidden)]
pub use safety::energy_j;
pub use safety::{EndLoads, Operating, PullAt, Safety, ToMeasure, relief_mpa};
pub use shown::Shown;
pub use stem::Stem;
pub use test_points::{TestPoint, is_blank_sheet};

pub use mckibben_io::files::{Content, File};
pub use mckibben_report::FigureError;

use mckibben_report::{Document, DrawingSheet};

/// The program, in the first line of a file.
const MARK: &str = "mckibben build";

/// The drawings: the muscle, and a sheet for each plug.
pub fn drawings(plan: &Plan) -> [DrawingSheet; 3] {
    [
        drawing::on_paper(plan),
        plug_drawing::on_paper(plan, "Air plug", &plan.air_plug, 2),
        plug_drawing::on_paper(plan, "Eye plug", &plan.eye_plug, 3),
    ]
}

/// The build sheet and the test record.
pub fn papers(plan: &Plan) -> [Document; 2] {
    [build_sheet::document(plan), record::document(plan)]
}

/// All files, the first page first, which links to the others.
pub fn files(plan: &Plan) -> Result<Vec<File>, FigureError> {
    let sheets = drawings(plan);
    let [build_sheet, record] = papers(plan);
    let bill = material::csv(plan).map_err(|e| FigureError::Drawing(e.to_string()))?;
    let mut out = vec![
        document(
            "build-sheet",
            "tools, cut list, steps to tick",
            &build_sheet,
        )?,
        File::text("bom.csv", "what to buy", bill),
    ];
    out.extend(drawn(&sheets)?);
    if plan.air_plug.is_printed() {
        for (name, plug) in [
            ("air-plug.stl", &plan.air_plug),
            ("eye-plug.stl", &plan.eye_plug),
        ] {
            let about = "plug as it lies on the printer";
            out.push(File::bytes(name, about, plug.printed().to_stl(MARK)));
        }
    } else {
        for (name, plug) in [("air-plug", &plan.air_plug), ("eye-plug", &plan.eye_plug)] {
            let about = "plug to be turned and milled, with its drawing";
            out.push(File::text(
                format!("{name}.step"),
                about,
                step::text(plug, name),
            ));
        }
    }
    if plan.is_cast() {
        let cap = mould::cap(&plan.cut).to_stl(MARK);
        out.push(File::bytes("mould-cap.stl", "cap of the mould, twice", cap));
    }
    out.extend([
        document("test-record", "proof, leak and first test", &record)?,
        File::text(
            "test.csv",
            "the sheet of the first test for `identify`",
            test_points::csv(plan),
        ),
        File::text(
            "muscle.toml",
            "the muscle itself",
            mckibben_core::muscle::file::to_toml(&plan.muscle),
        ),
    ]);
    let readme = readme::markdown(plan, &out);
    out.insert(0, File::text("README.md", "where to begin", readme));
    Ok(out)
}

/// A document as PDF, or as a page where there is no PDF.
fn document(name: &str, about: &'static str, document: &Document) -> Result<File, FigureError> {
    #[cfg(feature = "pdf")]
    return Ok(File::bytes(
        format!("{name}.pdf"),
        about,
        document.to_pdf()?,
    ));
    #[cfg(not(feature = "pdf"))]
    return Ok(File::text(
        format!("{name}.html"),
        about,
        document.to_html("")?,
    ));
}

/// The drawings: one PDF, or each as SVG where there is no PDF.
fn drawn(sheets: &[DrawingSheet]) -> Result<Vec<File>, FigureError> {
    #[cfg(feature = "pdf")]
    {
        let about = "the muscle, and a sheet for each plug";
        let pdf = mckibben_report::to_pdf(sheets, "McKibben muscle")?;
        Ok(vec![File::bytes("drawing.pdf", about, pdf)])
    }
    #[cfg(not(feature = "pdf"))]
    {
        let names = ["drawing.svg", "air-plug.svg", "eye-plug.svg"];
        let file =
            |(name, sheet): (&str, &DrawingSheet)| Ok(File::text(name, "drawing", sheet.to_svg()?));
        names.into_iter().zip(sheets).map(file).collect()
    }
}
