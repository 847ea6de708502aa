//! The plugs in OpenSCAD: the measures of this muscle as variables, the geometry from them.

use crate::fitting::Fitting;
use crate::mesh::FACETS;
use crate::plan::Plan;
use crate::plug::Stem;
use crate::text::{fixed, mm};

fn n(value: f64) -> String {
    fixed(value, 4)
}

/// The stem's variables.
fn variables(plan: &Plan, stem: &Stem, what: &str) -> String {
    let starts: Vec<String> = stem.groove_starts_mm().into_iter().map(n).collect();
    let (bevel, _) = stem.bevel_mm();
    format!(
        "// {mark}: {what} for a tube with a bore of {bore} mm. All lengths in mm.\n\n\
         bore = {exact};            // inner diameter of the tube\n\
         interference = {interference};    // the stem is so much wider than the bore\n\
         stem_length = {length};     // length in the tube\n\
         bevel = {bevel};           // of the inner end\n\
         groove_starts = [{starts}]; // from the inner end\n\
         groove_width = {width};\n\
         groove_depth = {depth};\n\
         collar_diameter = {collar};\n\
         collar = {thickness};          // thickness\n",
        mark = crate::MARK,
        bore = mm(stem.diameter_mm - stem.interference_mm),
        exact = n(stem.diameter_mm - stem.interference_mm),
        interference = n(stem.interference_mm),
        length = n(plan.muscle.terminals().insertion_mm()),
        bevel = n(bevel),
        starts = starts.join(", "),
        width = n(stem.groove_width_mm),
        depth = n(stem.groove_depth_mm),
        collar = n(stem.collar_diameter_mm),
        thickness = n(stem.collar_mm),
    )
}

/// The stem's geometry.
const STEM: &str = "
stem_diameter = bore + interference;
top = stem_length + collar;

module groove(start) {
  r = stem_diameter / 2;
  d = groove_depth;
  e = 0.01;
  rotate_extrude()
    polygon([[r + e, start - e], [r - d, start + d], [r - d, start + groove_width - d], [r + e, start + groove_width + e]]);
}

module stem() {
  difference() {
    union() {
      cylinder(h = bevel, d1 = stem_diameter - bevel, d2 = stem_diameter);
      translate([0, 0, bevel]) cylinder(h = stem_length - bevel, d = stem_diameter);
      translate([0, 0, stem_length]) cylinder(h = collar, d = collar_diameter);
    }
    for (start = groove_starts) groove(start);
  }
}
";

/// The plug with the air passage.
pub(crate) fn air_plug(plan: &Plan) -> String {
    let plug = &plan.air_plug;
    let mut out = variables(plan, &plug.stem, "air plug");
    let passage = n(plug.passage_mm);
    out.push_str(&format!("passage = {passage};         // diameter of the air passage\n"));
    match (plug.fitting, plug.fitting.thread_mm()) {
        (Fitting::Barb { bore_mm }, _) => {
            out.push_str(&format!(
                "hose = {};               // bore of the hose\n$fn = {FACETS};\n{STEM}",
                n(bore_mm)
            ));
            out.push_str(
                "
difference() {
  union() {
    stem();
    translate([0, 0, top]) cylinder(h = 1.5 * hose, d = hose);
    translate([0, 0, top + 1.5 * hose]) cylinder(h = hose, d1 = 1.2 * hose, d2 = 0.9 * hose);
  }
  translate([0, 0, -1]) cylinder(h = top + 2.5 * hose + 2, d = passage);
}
",
            );
        }
        (fitting, Some((drill, depth, boss))) => {
            out.push_str(&format!(
                "tap_hole = {};           // hole for the tap {fitting}\nthread_depth = {};\nboss_diameter = {};\n$fn = {FACETS};\n{STEM}",
                n(drill),
                n(depth),
                n(boss)
            ));
            out.push_str(
                "
cone = min((tap_hole - passage) / 2, collar);
difference() {
  union() {
    stem();
    translate([0, 0, top]) cylinder(h = thread_depth, d = boss_diameter);
  }
  translate([0, 0, -1]) cylinder(h = top + 1, d = passage);
  translate([0, 0, top - cone]) cylinder(h = cone, d1 = passage, d2 = tap_hole);
  translate([0, 0, top]) cylinder(h = thread_depth + 1, d = tap_hole);
}
",
            );
        }
        // Every fitting without a thread is a barb.
        _ => {}
    }
    out
}

/// The closed plug with the eye.
pub(crate) fn eye_plug(plan: &Plan) -> String {
    let plug = &plan.eye_plug;
    let mut out = variables(plan, &plug.stem, "eye plug");
    out.push_str(&format!(
        "hole = {};               // for a bolt M{}\neye_thickness = {};\neye_width = {};\neye_centre = {};         // above the collar\n$fn = {FACETS};\n{STEM}",
        n(plug.hole_mm),
        mm(plug.bolt_mm),
        n(plug.thickness_mm),
        n(plug.width_mm),
        n(plug.centre_mm)
    ));
    out.push_str(
        "
stem();
translate([0, eye_thickness / 2, top])
  rotate([90, 0, 0])
    linear_extrude(eye_thickness)
      difference() {
        union() {
          // A little below the collar's face, so that both are one body.
          translate([-eye_width / 2, -collar / 2]) square([eye_width, eye_centre + collar / 2]);
          translate([0, eye_centre]) circle(d = eye_width);
        }
        translate([0, eye_centre]) circle(d = hole);
      }
",
    );
    out
}
