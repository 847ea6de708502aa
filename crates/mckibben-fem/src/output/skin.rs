//! The surface of a body of hexahedra: the faces that belong to one cell only.

use super::vtu::Grid;
use std::collections::HashMap;

/// The faces of a hexahedron in VTK's order of corners, counter-clockwise from outside.
const FACES: [[usize; 4]; 6] =
    [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

/// Corners of each face of the surface of those cells that `kept` agrees to, in the order of the cells.
pub fn skin(grid: &Grid, kept: impl Fn(&[usize; 8]) -> bool) -> Vec<[usize; 4]> {
    let cells = grid.connectivity.chunks_exact(8).map(|c| std::array::from_fn(|k| c[k] as usize));
    let faces: Vec<[usize; 4]> =
        cells.filter(|c| kept(c)).flat_map(|c: [usize; 8]| FACES.map(|f| f.map(|k| c[k]))).collect();
    let name = |f: &[usize; 4]| {
        let mut sorted = *f;
        sorted.sort_unstable();
        sorted
    };
    let mut count: HashMap<[usize; 4], u32> = HashMap::with_capacity(faces.len());
    for face in &faces {
        *count.entry(name(face)).or_default() += 1;
    }
    faces.into_iter().filter(|f| count.get(&name(f)) == Some(&1)).collect()
}

#[cfg(test)]
mod tests {
    use super::super::vtu::Grid;
    use super::skin;

    /// Two cubes side by side: ten faces, 10 mm² in all, and their outward areas sum to nothing (a closed surface).
    #[test]
    fn surface_of_two_cubes_is_closed_and_has_ten_faces() {
        let points: Vec<[f64; 3]> =
            (0..12).map(|i| [f64::from(i % 3), f64::from(i / 3 % 2), f64::from(i / 6)]).collect();
        let cube = |x: i64| [x, x + 1, x + 4, x + 3, x + 6, x + 7, x + 10, x + 9];
        let grid = Grid::of_hexahedra(points, [cube(0), cube(1)].concat(), vec![]);
        let faces = skin(&grid, |_| true);
        assert_eq!(faces.len(), 10);
        let mut volume = 0.0;
        let mut sum = [0.0; 3];
        for f in &faces {
            let p = f.map(|i| grid.points[i]);
            let d = |a: usize, b: usize| [0, 1, 2].map(|k| p[b][k] - p[a][k]);
            let (u, v) = (d(0, 2), d(1, 3));
            let area = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
            for k in 0..3 {
                sum[k] += 0.5 * area[k];
                volume += 0.5 * area[k] * p.iter().map(|q| q[k]).sum::<f64>() / 12.0;
            }
        }
        assert_eq!(sum, [0.0; 3]);
        // Gauss's theorem: outward normals give + 2.
        assert!((volume - 2.0).abs() < 1e-12, "{volume}");
    }
}
