//! The mesh of bricks with its loads, as in the paper's Figure 2.

use mckibben_core::extremes::peak;
use mckibben_fem::output::{Shape, vtu::Grid};
use mckibben_report::{Axis, Panel, Series};

/// Two faces of a brick in one line, by VTK's order of its corners; its neighbours have the others.
const FACES: [usize; 8] = [0, 1, 5, 4, 0, 3, 7, 4];

/// Cells in space: z to the right, x upwards, y to the back; between them the line has gaps.
fn cells(grid: &Grid, corners: usize, path: &[usize]) -> Vec<(f64, f64)> {
    let mut out = vec![];
    for cell in grid.connectivity.chunks(corners) {
        for &corner in path {
            let [x, y, z] = grid.points[cell[corner] as usize];
            out.push((z + 0.5 * y, x + 0.5 * y));
        }
        out.push((f64::NAN, f64::NAN));
    }
    out
}

/// One eighth of a muscle: bricks, terminal, trusses, a pressure on the wall, the pull.
pub fn mesh(
    title: &str,
    Shape {
        tube, braid, plug, ..
    }: &Shape,
) -> Panel {
    let end = peak(tube.points.iter().map(|p| p[2]));
    let inner = tube.points[0][0];
    let plug = plug.iter().flat_map(|plug| cells(plug, 8, &FACES));
    let lines = [
        ("", cells(braid, 2, &[0, 1])),
        ("P", vec![(0.3 * end, 0.0), (0.3 * end, inner)]),
        ("F/4", vec![(end, 0.0), (1.2 * end, 0.0)]),
        ("", plug.collect()),
        ("", cells(tube, 8, &FACES)),
    ];
    let panel = Panel::new(Axis::new("z [mm]"), Axis::new("x [mm]")).title(title);
    lines.into_iter().fold(panel, |panel, (label, line)| {
        panel.series(Series::line("", line).end_label(label))
    })
}
