//! The cap that centres rod and pipe of a mould.

use crate::{Cut, mesh::Mesh};

/// Play of rod and pipe, spigot, flange and its width beyond the pipe, in mm (choices).
const PLAY_MM: f64 = 0.2;
const SPIGOT_MM: f64 = 8.0;
const FLANGE_MM: (f64, f64) = (4.0, 5.0);

/// The cap, on its flange.
pub fn cap(cut: &Cut) -> Mesh {
    let outer = 0.5 * (cut.tube_outer_diameter_mm - PLAY_MM);
    let bore = 0.5 * (cut.tube_outer_diameter_mm + PLAY_MM) - cut.tube_wall_mm;
    let (thick, wide) = FLANGE_MM;
    let mut mesh = Mesh::default();
    let profile = [
        [outer + wide, 0.0],
        [outer + wide, thick],
        [outer, thick],
        [outer, thick + SPIGOT_MM],
        [bore, thick + SPIGOT_MM],
        [bore, 0.0],
    ];
    if let Some((first, last)) = mesh.bands(&profile) {
        mesh.band(&last, &first);
    }
    mesh
}
