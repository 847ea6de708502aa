//! `rubber`: laws from tension tests.

mod text;

use crate::{Asked, Bar, Failure, Format, check_ending, in_flags, save, warn};
use mckibben_app::{ConstantRow, RubberFitRequest, rubber_fit};
use schemars::JsonSchema;
use serde::Serialize;

pub const TEXT: &str =
    "rubber: Rubber laws from tension tests: constants with their errors, range of stability
Question: :data<FILE>!
@columns
laws=law mode area_mm2 gauge_length_mm
up_to_stretch=up-to<STRETCH> | Leave out points beyond this stretch (3) or strain (200%)
relaxation<N:1..8> softening
Muscle: muscle name
Advanced: terms<N:1..3>* fit_modes=fit-mode* relative* balance* weights<LIST>* stable* hoop_stretch*
@plot
Output:
o/output<FILE> | Write a muscle file with the recommended law
Examples:
  mckibben rubber data/treloar/tension.csv --law yeoh --relative
  mckibben rubber data/silicones/dragon_skin_30.csv --up-to 200% \\
    --plot rubber.svg -o silicone.toml
  mckibben force --muscle silicone.toml -p 2bar -e 10%";

/// The constants of all laws, as a table.
#[derive(Serialize, JsonSchema)]
struct Constants {
    constants: Vec<ConstantRow>,
}

pub fn run(asked: &Asked) -> Result<u8, Failure> {
    let target = asked.path("output");
    check_ending(target.as_deref(), &["toml"])?;
    let request: RubberFitRequest = asked.request()?;
    let mut answer = rubber_fit(&request, &Bar::hidden())?;
    if target.is_some() {
        save(target.as_deref(), answer.muscle_file(&request)?.as_bytes())?;
    }
    asked.draw(&mut answer.figure)?;
    if asked.format == Format::Csv {
        return asked.print(&Constants { constants: answer.constants() }, "constants", String::new);
    }
    asked.print(&answer, "", || {
        answer.warnings.iter().chain(&answer.failed).for_each(|w| warn(in_flags(w)));
        text::of(&answer, &request, target.as_deref())
    })
}
