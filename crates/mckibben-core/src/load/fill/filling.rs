//! The liquid pushed into a muscle, and the load or length against which it is filled.

use crate::{liquid::Liquid, load::Load};

/// What is pushed into a muscle, and what holds it.
///
/// At the start the muscle has its length at rest and no pressure; muscle and dead volume are full
/// of liquid. With V the cavity, V0 that at the start, Vd the dead volume, φ the volume of the
/// liquid over that at atmospheric pressure ([`Liquid`]) and ΔV what is pushed in,
///
/// ```text
/// (V0 + Vd + ΔV) φ(P) = V(P, ε) + Vd
/// ```
///
/// Line and syringe are rigid. The muscle rests against a stop at its length at rest until it pulls
/// more than the load; then muscle and load are in balance, F(P, ε) = F_load(ε L0), up to the
/// contraction at which it is held, where there is one. All is slow.
#[derive(Debug, Clone, Copy)]
pub struct Filling<'a> {
    /// The liquid.
    pub liquid: &'a Liquid,
    /// ΔV in mm³ at atmospheric pressure: the stroke of the piston of a syringe that is empty at
    /// the end but for the dead volume.
    pub volume_mm3: f64,
    /// Vd in mm³: line, fittings, and what stays in the syringe.
    pub dead_volume_mm3: f64,
    /// What the muscle works against; none where it is free.
    pub load: Option<&'a Load>,
    /// The contraction at which it is held; none where nothing holds it.
    pub held_at: Option<f64>,
}
