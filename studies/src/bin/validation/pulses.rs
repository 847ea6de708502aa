//! How much air a muscle holds, counted by the pulses of a valve: volumes that constrain the angle
//! of a braid without any pull.
//!
//! A muscle is held at ε and vented by pulses through a valve. With choked outflow at an even
//! temperature each pulse lets out the mass ρ k, ρ the density of the air in the muscle, k (mm³)
//! the volume of a pulse. The mass ρ (V + Vd) of the air in the muscle, V (mm³), and in hose and
//! fittings, Vd (mm³), falls by that. From p1 to p2 (absolute, MPa) it takes
//!
//!   n = (1/k) [ ∫ V dp/p + V(p1) − V(p2) + Vd ln(p1/p2) ],  the integral from p2 to p1,
//!
//! pulses. This is linear in 1/k and Vd/k, which the muscles at their rest lengths give by least
//! squares; the contracted muscles are predicted.
//!
//! Source: valve pulses of a Festo DMSP-10 hose in three lengths (data/volume). Range: above 0.1
//! MPa, where the outflow is choked, and muscles that pull.

use crate::{
    Result,
    bounds::Row,
    case::{CaseFit, MuscleCase},
    fit::fitted,
};
use mckibben_core::{
    analysis::{ATMOSPHERE_MPA, Evaluation},
    model::Workspace,
    muscle::{Direction, Muscle},
    threads,
};
use mckibben_fit::{
    identify::Build,
    least_squares::{Errors, Line},
    measured::{Section, mean_of_data},
};

const TABLE: &str =
    include_str!("../../../../crates/mckibben-fit/data/volume/festo-dmsp-10-pulses.csv");
/// Gauge pressures in MPa between which pulses are counted.
const BETWEEN: (f64, f64) = (0.3, 0.5);
/// Steps of Simpson's rule for the integral over the pressure.
const STEPS: usize = 8;
/// Contractions whose muscles pull at both pressures are below this.
const TAUT: f64 = 0.05;

/// Pulses that were counted on a muscle at one contraction, the mean of its tests.
#[derive(Debug, Clone, Copy)]
pub struct Counted {
    /// L0 in mm.
    pub length_mm: f64,
    /// ε.
    pub contraction: f64,
    /// n.
    pub pulses: f64,
}

/// Pulses predicted by the volumes of a muscle.
#[derive(Debug, Clone, Copy)]
pub struct Predicted {
    /// Vd in mm³.
    pub dead_volume_mm3: f64,
    /// rms error of the pulses of the muscles at their rest lengths, over their mean.
    pub rms_at_rest: f64,
    /// Mean of the pulses of the contracted muscles.
    pub measured: f64,
    pub predicted: f64,
}

impl Predicted {
    /// Predicted over measured pulses, less 1: above zero where the muscle holds too much air.
    pub fn bias(&self) -> f64 {
        self.predicted / self.measured - 1.0
    }
}

/// A row of the table: L0, ε, test, gauge pressure.
type Vented = (f64, f64, f64, f64);

fn vented(line: &str) -> Option<Vented> {
    let cells: Vec<&str> = line.split(',').collect();
    let number = |i: usize| cells.get(i).and_then(|cell| cell.parse::<f64>().ok());
    (cells.get(5) == Some(&"vent")).then_some((number(1)?, number(3)?, number(4)?, number(7)?))
}

/// The pulses between 0.3 and 0.5 MPa of every length and contraction whose muscle pulls.
pub fn counted() -> Vec<Counted> {
    let rows: Vec<Vented> = TABLE.lines().filter_map(vented).collect();
    let mut out: Vec<Counted> = vec![];
    for group in rows.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
        let length_mm = group[0].0;
        let contraction = group[0].1;
        let counts: Vec<f64> = group
            .chunk_by(|a, b| a.2 == b.2)
            .filter_map(|test| {
                let pressures: Vec<f64> = test.iter().map(|r| r.3).collect();
                Some(pulses_until(&pressures, BETWEEN.0)? - pulses_until(&pressures, BETWEEN.1)?)
            })
            .collect();
        if contraction < TAUT && !counts.is_empty() {
            out.push(Counted {
                length_mm,
                contraction,
                pulses: Errors::new(counts).mean,
            });
        }
    }
    out
}

/// After how many pulses a falling pressure reaches a value; between two it falls evenly in its
/// logarithm.
fn pulses_until(pressures: &[f64], gauge_mpa: f64) -> Option<f64> {
    let log = |p: f64| (p + ATMOSPHERE_MPA).ln();
    let i = pressures
        .windows(2)
        .position(|w| w[0] >= gauge_mpa && w[1] < gauge_mpa)?;
    Some(
        i as f64
            + (log(pressures[i]) - log(gauge_mpa)) / (log(pressures[i]) - log(pressures[i + 1])),
    )
}

/// ∫ V dp/p + V(p1) − V(p2) in mm³ of a muscle at ε.
fn let_out(build: &Build<'_>, muscle: &Muscle, at: &Counted) -> Result<f64> {
    let section = Section {
        length_mm: Some(at.length_mm),
        ..Section::default()
    };
    let model = build(&section.apply(muscle)?)?;
    let workspace = &mut Workspace::new();
    let mut model = Evaluation::new(&*model, workspace, Direction::Mean);
    let mut volume = |gauge_mpa: f64| -> Result<f64> {
        let response = model.response(gauge_mpa, at.contraction)?;
        Ok(response.volume_mm3.ok_or("no volume")?)
    };
    let absolute = (BETWEEN.0 + ATMOSPHERE_MPA, BETWEEN.1 + ATMOSPHERE_MPA);
    // Even steps in ln p.
    let step = (absolute.1 / absolute.0).ln() / STEPS as f64;
    let mut integral = 0.0;
    for i in 0..=STEPS {
        let weight = if i == 0 || i == STEPS {
            1.0
        } else {
            [2.0, 4.0][i % 2]
        };
        let pressure = absolute.0 * (step * i as f64).exp() - ATMOSPHERE_MPA;
        integral += weight * step / 3.0 * volume(pressure)?;
    }
    Ok(integral + volume(BETWEEN.1)? - volume(BETWEEN.0)?)
}

/// k and Vd from the muscles at their rest lengths, and what they predict of the contracted ones.
pub fn predict(build: &Build<'_>, muscle: &Muscle) -> Result<Predicted> {
    let counted = counted();
    let (rest, contracted): (Vec<Counted>, Vec<Counted>) =
        counted.iter().partition(|c| c.contraction == 0.0);
    let log = ((BETWEEN.1 + ATMOSPHERE_MPA) / (BETWEEN.0 + ATMOSPHERE_MPA)).ln();
    let volumes = |list: &[Counted]| -> Result<Vec<f64>> {
        list.iter().map(|c| let_out(build, muscle, c)).collect()
    };
    let at_rest = volumes(&rest)?;
    let at_contraction = volumes(&contracted)?;
    // n = a A + b: a = 1/k, b = Vd ln(p1/p2)/k.
    let pulses = |list: &[Counted]| -> Vec<f64> { list.iter().map(|c| c.pulses).collect() };
    let points: Vec<(f64, f64)> = at_rest.into_iter().zip(pulses(&rest)).collect();
    let line = Line::through(&points);
    let off = Errors::new(points.iter().map(|(volume, n)| line.at(*volume) - n));
    let predicted = at_contraction.into_iter().map(|volume| line.at(volume));
    Ok(Predicted {
        dead_volume_mm3: (line.mean_y / line.slope - line.mean_x) / log,
        rms_at_rest: off.rms / line.mean_y,
        measured: Errors::new(pulses(&contracted)).mean,
        predicted: Errors::new(predicted).mean,
    })
}

/// The fits of the hose whose volumes are compared with the pulses.
const FITS: [&str; 3] = ["modulus, angle", "modulus, angle, slip", "modulus, slip"];
/// Pulses are counted to ± 0.1 of 4 to 5, and a share of as much is known of the dead volume.
const TOLERANCE: f64 = 0.03;

/// Rows of the fits: only the first, whose ends do not slip, must predict the pulses; the errors of
/// the others speak against them.
pub fn rows(cases: &[&MuscleCase], build: &Build<'_>) -> Result<Vec<Row>> {
    let case = cases.iter().find(|case| case.name == "dmsp-10-hose");
    let case = case.ok_or("no hose")?;
    let means = mean_of_data(&case.points);
    let row = |fit: &&CaseFit| {
        let (muscle, _) = fitted(build, fit, &means)?;
        let pulses = predict(build, &muscle)?;
        let about = format!(
            "{:.1}°, dead volume {:.0} mL, rms at rest {:.1} %",
            muscle.braid().angle_deg,
            1e-3 * pulses.dead_volume_mm3,
            100.0 * pulses.rms_at_rest
        );
        Ok(Row {
            name: format!("{}: pulses, {} ({about})", case.facts.title, fit.name),
            reference: pulses.measured,
            computed: pulses.predicted,
            error: pulses.bias().abs(),
            allowed: if fit.name == FITS[0] { TOLERANCE } else { 0.1 },
        })
    };
    let named = |name: &&str| case.fits.iter().find(|f| f.name == **name);
    let fits: Vec<&CaseFit> = FITS.iter().filter_map(named).collect();
    threads::map(&fits, row).into_iter().collect()
}
