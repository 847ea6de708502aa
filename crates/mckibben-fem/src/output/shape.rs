//! A muscle as bodies in space: the tube as hexahedra, the strands as lines, with numbers at their points.

use super::vtu::Grid;
use super::{helices, revolve, skin};
use crate::axisymmetric::Section;

/// Tube and strands of one equilibrium.
#[derive(Debug, Clone)]
pub struct Shape {
    /// Hexahedra.
    pub tube: Grid,
    /// Lines.
    pub braid: Grid,
    /// The terminals as hexahedra, where they are bodies.
    pub plug: Option<Grid>,
}

/// What is seen of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct Seen {
    /// Corners of each face in mm, counter-clockwise from outside, and the number at each.
    pub faces: Vec<([[f64; 3]; 4], [f64; 4])>,
    /// Points of the strands in mm.
    pub threads: Vec<Vec<[f64; 3]>>,
    /// Corners of each face of the terminals.
    pub plug: Vec<[[f64; 3]; 4]>,
}

impl Shape {
    /// The whole muscle from the half section of the axisymmetric model.
    pub fn of_section(section: &Section) -> Self {
        Self { tube: revolve::tube(section), braid: helices::braid(section), plug: None }
    }

    /// Names of the single numbers at the points of the tube.
    pub fn names(&self) -> Vec<&'static str> {
        self.tube.data.iter().filter(|d| d.components == 1).map(|d| d.name).collect()
    }

    /// Its surface with the numbers of one name, and its strands; `cut` leaves out the quarter x > 0, y > 0, so that wall and
    /// inner surface show. `None` where no number has that name.
    pub fn seen(&self, name: &str, cut: bool) -> Option<Seen> {
        let data = self.tube.data.iter().find(|d| d.name == name && d.components == 1)?;
        let points = &self.tube.points;
        let kept = |middle: [f64; 3]| !(cut && middle[0] > 0.0 && middle[1] > 0.0);
        let faces = skin::skin(&self.tube, |corners| kept(middle(corners.iter().map(|&i| points[i]))));
        let faces = faces.into_iter().map(|f| (f.map(|i| points[i]), f.map(|i| data.values[i]))).collect();
        let mut threads = vec![];
        let mut start = 0;
        for &end in &self.braid.offsets {
            let line: Vec<[f64; 3]> = self.braid.connectivity[start..end as usize]
                .iter()
                .map(|&i| self.braid.points[i as usize])
                .collect();
            start = end as usize;
            // Runs of the problem that are kept.
            let mut run: Vec<[f64; 3]> = vec![];
            for pair in line.windows(2) {
                if kept(middle(pair.iter().copied())) {
                    if run.is_empty() {
                        run.push(pair[0]);
                    }
                    run.push(pair[1]);
                } else if !run.is_empty() {
                    threads.push(std::mem::take(&mut run));
                }
            }
            if !run.is_empty() {
                threads.push(run);
            }
        }
        let plug = self.plug.iter().flat_map(|grid| {
            let at = |i: usize| grid.points[i];
            let faces = skin::skin(grid, |corners| kept(middle(corners.iter().map(|&i| at(i)))));
            faces.into_iter().map(|f| f.map(at)).collect::<Vec<_>>()
        });
        Some(Seen { plug: plug.collect(), faces, threads })
    }
}

fn middle(points: impl ExactSizeIterator<Item = [f64; 3]>) -> [f64; 3] {
    let n = points.len() as f64;
    points.fold([0.0; 3], |m, p| std::array::from_fn(|k| m[k] + p[k] / n))
}
