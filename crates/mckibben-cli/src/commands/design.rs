//! `design`: the main job.

mod text;

use crate::{Asked, Bar, Failure, Format, NO_ANSWER, burst_first, check_ending, emit, place, save, shown};

pub const TEXT: &str = "design: Find muscles that meet a specification, ranked (the main command)
Question:
F/force_n | Required pull; below zero: the push of a muscle that extends
e/contraction | Contraction ratio ΔL/L0 with that pull; below zero: an extension
points=at<F@E,…>^force_n,contraction | Several operating points: 700N@15%,1200N@5%
@load
torques=joint<T@ANGLE,…>^force_n,contraction,points,load,stroke_mm | Required torques of a joint: 8Nm@45deg,3Nm@60deg. At angles to either side. Two equal opposed muscles on a pulley, one of them without pressure.
largest_angle_deg*&torques
stroke_mm | Stroke. With --contraction it sets the length, with --length the contraction.
p/max_pressure_mpa=max-pressure|pressure | Supply pressure
liquid gas_share=gas<SHARE> dead_volume_mm3 liquid_bulk_modulus_mpa=bulk-modulus<MODULUS>*
guaranteed<SHARE?95%> | The lower end of the ± meets it [95%]. The muscle whose pull less its ± meets the requirement; another share, such as --guaranteed 99%, widens the ± accordingly.
bundle | Equal muscles side by side that share the requirement [1]. The candidates are one of them; the bundle of the best one is shown below.
objective
Limits: max_bulged_diameter_mm max_envelope_mm pitch_mm*&bundle
max_liquid_volume_mm3=max-liquid | Largest liquid volume up to the operating points: what the syringe or pump gives. Of a bundle to all its muscles together. It needs --liquid.
min_burst_margin=safety|min-burst-margin | Least pressure at which strands break or clamps let go, over the supply pressure [4]. The tube, which leaks, has half of it. 0 for none. The strength of the strands must be known.
max_stretch<STRETCH>* max_strand_strain* guided*
Muscle:
:file=muscle<MUSCLE.toml>^muscle | Muscle file, for what is not searched. Flags override it. `paper` is the muscle of the paper, lib:NAME one of the library.
muscle* | Muscle file, same as [MUSCLE.toml]
tubes=tube | Tubes as sold or cast (`mckibben parts list`) [all]
parts<FILE.toml>* | Tubes of your own: a file of the catalogue's form
continuous^tubes,parts | Free sizes instead of parts as sold. Diameters and walls are free, with the paper's rubber and braid, or those that are given. So they are with -D, -s, --angle, --stiffness or a muscle file.
D/outer_diameter_mm | Outer diameters: a value, list or range [parts]. At rest; also a stepped range, 20..40:5.
s/wall_mm | Wall thicknesses at rest [parts]
L/length_mm | Lengths between the terminals at rest [285mm]
angle_deg | Braid angles to the axis at rest [those of the sleeves]
rubbers=rubber | Rubbers, by name [those of the tubes]
braids=braid^angle_deg,strand_length_per_turn_mm | Sleeves, by name (`mckibben parts list sleeves`) [all]. The diameter of the tube then sets angle and stiffness.
@strands
strand_length_per_turn_mm*^angle_deg radius_mm*&torques
Advanced:
model | Force model [fe; the search uses universal within its range]
mesh<N_or_MxN:G>* extrapolate* verify*
tolerance<LIST>* | Spread of the pull of the best muscle for ± tolerances of pressure, modulus, stiffness and dimensions (named as their flags): wall=0.1mm,angle=1deg,modulus=10%
Output:
top<N:1..1000> | Number of candidates to show [5]
@units @plot
o/output<FILE.toml> | Write the best muscle as a muscle file
Examples:
  mckibben design --force 700N --contraction 15% --max-pressure 2.5bar
  mckibben design --at 700N@15%,1200N@5% --max-pressure 2.5bar \\
    --max-bulged-diameter 80mm --plot muscle.svg
  mckibben design -F 300N --stroke 40mm --length 285 --max-pressure 3bar \\
    -D 20..40:5 -s 1,1.5,2 --rubber dragon-skin-30
  mckibben design --force 700N --contraction 15% --max-pressure 2.5bar \\
    --tolerance wall=0.1mm,pressure=0.1bar -o winner.toml
  mckibben design --load mass:20kg --stroke 40mm --length 285 \\
    --max-pressure 3bar
  mckibben design --force 700N --contraction 15% --max-pressure 2.5bar \\
    --bundle 7 --max-envelope 80mm
  mckibben design -F 50N -e 15% --max-pressure 2.5bar --length 200 \\
    --liquid water --max-liquid 20mL
  mckibben design --joint 8Nm@45deg,3Nm@60deg --max-pressure 6bar \\
    --length 250 --max-bulged-diameter 40mm --rubber dragon-skin-30";

pub fn run(asked: &Asked) -> Result<u8, Failure> {
    let target = asked.path("output");
    check_ending(target.as_deref(), &["toml"])?;
    let mut answer = mckibben_app::design(&asked.request()?, &Bar::new("muscles"))?;
    let winner = answer.muscle_files.first();
    if let Some(winner) = winner {
        save(target.as_deref(), winner.text.as_bytes())?;
    }
    let text = || burst_first(&answer.warnings) + &text::of(&answer, target.as_deref(), &shown::units());
    asked.print(&answer, "candidates", text)?;
    if let (Some(path), Some(_), Format::Text) = (&target, winner, asked.format) {
        emit(format!("\nThe winner is in {}.\n", place(path)), None)?;
    }
    asked.draw(&mut answer.figure)?;
    Ok(if answer.candidates.is_empty() { NO_ANSWER } else { 0 })
}
