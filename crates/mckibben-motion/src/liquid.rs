//! A liquid in the place of the air: its balance, and what a valve, a line, a pump or a syringe
//! lets through.

use crate::{
    ATMOSPHERE_MPA, Flow, Hose, Result, ValveKind, air::Cavity, error::within, fluid::Medium,
};
use mckibben_core::{analysis::find_root, liquid::Liquid};
use std::f64::consts::PI;

/// The pressure difference of a flow coefficient, 1 bar, in MPa, and its liquid's density (water)
/// in kg/m³.
const RATED_MPA: f64 = 0.1;
const RATED_KG_PER_M3: f64 = 1000.0;
/// The flow up to which a restriction is laminar rather than turbulent, over its flow at 1 bar.
const LAMINAR_SHARE: f64 = 1e-3;
/// The share of the supply's pressure over which a relief valve opens, and a pump that runs empty
/// ends.
const RELIEF_SHARE: f64 = 0.01;
/// Absolute pressure in MPa at which a liquid boils, about that of water at 20 °C.
const VAPOUR_MPA: f64 = 2.3e-3;

/// The liquid in and beside a muscle.
///
/// ```text
/// ṗ (V_P + N c(P)) = Ṅ φ(P) + V̇_s − V_ε ε̇,   N = V/φ(P),   c = −dφ/dP
///
/// φ  volume at gauge pressure P over that at atmospheric pressure ([`Liquid`])
/// V  cavity, dead volume and line, mm³;  V_P, V_ε its derivatives
/// N  the same liquid at atmospheric pressure, mm³
/// V̇_s  speed of the syringe's piston times its area, mm³/s
/// ```
///
/// The temperature is constant, and so is the pressure from the valve to the muscle's far end: the
/// inertia of the liquid in the line is omitted, which makes a line of length L and section A swing
/// with the muscle at a period of 2π √(ρ L V_P/A). Source: \[merritt1967\], ch. 3.
#[derive(Debug, Clone, PartialEq)]
pub struct LiquidFill {
    /// The liquid.
    pub liquid: Liquid,
    /// Its temperature in K, which is reported.
    pub temperature_k: f64,
    /// Volume outside of the cavity in mm³, without line and syringe.
    pub dead_volume_mm3: f64,
}

impl LiquidFill {
    /// Volume of a mass at atmospheric pressure in mm³.
    pub fn volume_mm3(&self, mass_g: f64) -> f64 {
        mass_g / self.liquid.mass_g(1.0)
    }

    fn flow(&self, volume_mm3_per_s: f64) -> Flow {
        Flow {
            mass_g_per_s: self.liquid.mass_g(volume_mm3_per_s),
            temperature_k: self.temperature_k,
        }
    }

    /// φ at an absolute pressure.
    fn relative_volume(&self, absolute_mpa: f64) -> f64 {
        self.liquid.relative_volume(absolute_mpa - ATMOSPHERE_MPA)
    }

    /// V_P + N c(P) in mm³/MPa.
    fn compliance_mm3_per_mpa(&self, cavity: &Cavity) -> f64 {
        let gauge = cavity.absolute_mpa - ATMOSPHERE_MPA;
        let share = self.liquid.compliance_per_mpa(gauge) / self.liquid.relative_volume(gauge);
        cavity.volume_per_pressure_mm3_per_mpa + cavity.volume_mm3 * share
    }

    /// −∫ p dφ from atmospheric pressure, p absolute, in mJ for each mm³ at atmospheric pressure.
    fn stored_mpa(&self, absolute_mpa: f64) -> f64 {
        self.liquid.energy_mpa(absolute_mpa - ATMOSPHERE_MPA)
            + ATMOSPHERE_MPA * (1.0 - self.relative_volume(absolute_mpa))
    }
}

impl Medium for LiquidFill {
    fn dead_volume_mm3(&self) -> f64 {
        self.dead_volume_mm3
    }

    fn wall_temperature_k(&self) -> f64 {
        self.temperature_k
    }

    fn temperature_k(&self, _: f64, _: f64, _: f64) -> f64 {
        self.temperature_k
    }

    fn mass_g(&self, absolute_mpa: f64, volume_mm3: f64) -> f64 {
        self.liquid
            .mass_g(volume_mm3 / self.relative_volume(absolute_mpa))
    }

    /// The cavity's swept volume is less that of the piston.
    fn pressure_rate_mpa_per_s(&self, cavity: &Cavity, flows: &[Flow]) -> f64 {
        let entering: f64 = flows.iter().map(|f| self.volume_mm3(f.mass_g_per_s)).sum();
        (entering * self.relative_volume(cavity.absolute_mpa) - cavity.swept_mm3_per_s)
            / self.compliance_mm3_per_mpa(cavity)
    }

    fn flow_for_rate(&self, rate_mpa_per_s: f64, cavity: &Cavity, _: f64) -> Flow {
        let swelling =
            rate_mpa_per_s * self.compliance_mm3_per_mpa(cavity) + cavity.swept_mm3_per_s;
        self.flow(swelling / self.relative_volume(cavity.absolute_mpa))
    }

    /// Stored energy and p V at the muscle's pressure.
    fn enthalpy_mw(&self, flow: Flow, absolute_mpa: f64) -> f64 {
        let share = self.relative_volume(absolute_mpa);
        self.volume_mm3(flow.mass_g_per_s) * (self.stored_mpa(absolute_mpa) + absolute_mpa * share)
    }

    /// Against atmospheric pressure.
    fn internal_mj(&self, absolute_mpa: f64, volume_mm3: f64) -> f64 {
        volume_mm3 / self.relative_volume(absolute_mpa) * self.stored_mpa(absolute_mpa)
    }

    fn boils(&self, absolute_mpa: f64) -> bool {
        absolute_mpa < VAPOUR_MPA
    }
}

/// A restriction of a liquid by its flow coefficient.
///
/// ```text
/// Δp = 1 bar · ρ/(1000 kg/m³) · (Q/Kv)² (1 + 0.001 Kv/Q)
/// ```
///
/// Q flow, Kv the flow of water at a pressure difference of 1 bar. The second term makes small
/// flows laminar, as they are, and the slope at none finite; it takes 0.05 % of the flow at 1 bar.
/// Source: IEC 60534-2-1 \[iec2011\].
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Restriction {
    /// Kv in mm³/s at 1 bar.
    pub kv_mm3_per_s: f64,
}

impl Restriction {
    /// A restriction of a flow coefficient Kv, in mm³/s of water at 1 bar (1 m³/h is 277,778
    /// mm³/s).
    ///
    /// # Errors
    /// [`MotionError::Refused`](crate::MotionError::Refused) unless 1e-3 ≤ Kv ≤ 1e10 mm³/s.
    pub fn new(kv_mm3_per_s: f64) -> Result<Self> {
        within(
            "the flow coefficient in mm³/s at 1 bar",
            kv_mm3_per_s,
            1e-3,
            1e10,
        )?;
        Ok(Self { kv_mm3_per_s })
    }
}

/// Δp = a Q² + b Q + max(R Q, c Q^1.75) of a restriction and the line behind it: Hagen and
/// Poiseuille's R, and Blasius's friction of a smooth pipe.
///
/// They meet at a Reynolds number of 1190; between there and 2300 a flow without disturbance may be
/// larger. Source: \[white2011\], ch. 6.
#[derive(Default)]
struct Losses {
    square: f64,
    linear: f64,
    laminar: f64,
    turbulent: f64,
}

impl Losses {
    fn in_series(
        restriction: Option<Restriction>,
        share: f64,
        line: Option<Hose>,
        liquid: &Liquid,
    ) -> Self {
        let density = liquid.density_kg_per_m3 * (1.0 - liquid.gas_share);
        let mut out = Self::default();
        if let Some(r) = restriction {
            let kv = share * r.kv_mm3_per_s;
            out.square = RATED_MPA * density / RATED_KG_PER_M3 / (kv * kv);
            out.linear = out.square * LAMINAR_SHARE * kv;
        }
        if let Some(line) = line {
            let d = 1e-3 * line.inner_diameter_mm;
            let l = 1e-3 * line.length_mm;
            let viscosity = liquid.viscosity_pa_s;
            // Pa s/m³ to MPa s/mm³, and Pa (s/m³)^1.75 likewise.
            out.laminar = 1e-15 * 128.0 * viscosity * l / (PI * d.powi(4));
            let speed = 4.0 / (PI * d * d);
            let reynolds = density * speed * d / viscosity;
            let blasius = 0.3164 * reynolds.powf(-0.25);
            out.turbulent =
                blasius * (l / d) * 0.5 * density * speed * speed * 1e-6 * 1e-9_f64.powf(1.75);
        }
        out
    }

    /// Q in mm³/s at a pressure difference in MPa, with its sign.
    fn flow(&self, difference_mpa: f64) -> f64 {
        let p = difference_mpa.abs();
        let flow_with = |linear: f64| {
            let root = (linear * linear + 4.0 * self.square * p).sqrt();
            if p > 0.0 {
                2.0 * p / (linear + root)
            } else {
                0.0
            }
        };
        let laminar = flow_with(self.linear + self.laminar);
        let pipe = |q: f64| self.turbulent * q.powf(1.75);
        let size = if pipe(laminar) <= self.laminar * laminar {
            laminar
        } else {
            // Less than the laminar flow and more than none.
            let excess =
                |q: f64| Ok::<f64, ()>(self.square * q * q + self.linear * q + pipe(q) - p);
            find_root(excess, 0.0, laminar, 1e-13 * laminar)
                .ok()
                .flatten()
                .unwrap_or(laminar)
        };
        size.copysign(difference_mpa)
    }
}

/// A valve for a liquid: from the supply into the muscle, and from the muscle into a tank at
/// atmospheric pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LiquidValve {
    /// How it moves.
    pub kind: ValveKind,
    /// Into the muscle.
    pub supply: Restriction,
    /// Out of the muscle.
    pub tank: Restriction,
    /// The line between valve and muscle.
    pub line: Option<Hose>,
}

/// A pump of constant displacement between a tank at atmospheric pressure and the muscle, which
/// runs both ways; a relief valve keeps its outlet at the supply's pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pump {
    /// How it is driven: the opening is the share of its flow.
    pub kind: ValveKind,
    /// Largest flow in mm³/s.
    pub flow_mm3_per_s: f64,
    /// The line between pump and muscle.
    pub line: Option<Hose>,
}

/// A syringe whose piston follows the commanded volume with a first-order lag. At the start it is
/// full, and the muscle is without pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Syringe {
    /// What it holds, in mm³.
    pub volume_mm3: f64,
    /// Lag in s.
    pub time_constant_s: f64,
}

impl LiquidValve {
    /// Flow in mm³/s at atmospheric pressure at an opening from −1 to 1 other than 0, in the
    /// direction of the pressure difference in MPa.
    pub fn flow(&self, opening: f64, difference_mpa: f64, liquid: &Liquid) -> f64 {
        let restriction = if opening > 0.0 {
            self.supply
        } else {
            self.tank
        };
        Losses::in_series(Some(restriction), opening.abs().min(1.0), self.line, liquid)
            .flow(difference_mpa)
    }
}

impl Pump {
    /// The same; none against the difference, which a relief valve and an empty inlet do not let
    /// pass. `supply_mpa` is the relief valve's pressure.
    pub fn flow(&self, opening: f64, difference_mpa: f64, supply_mpa: f64, liquid: &Liquid) -> f64 {
        if opening * difference_mpa <= 0.0 {
            return 0.0;
        }
        let band = RELIEF_SHARE * supply_mpa.max(f64::MIN_POSITIVE);
        let share = (difference_mpa.abs() / band).min(1.0) * opening.abs().min(1.0);
        let through = self.line.map_or(f64::INFINITY, |line| {
            Losses::in_series(None, 1.0, Some(line), liquid)
                .flow(difference_mpa)
                .abs()
        });
        (share * self.flow_mm3_per_s).min(through).copysign(opening)
    }
}

impl LiquidFill {
    /// Flow from the supply and flow from the muscle's other side (negative: out of it) at an
    /// opening from −1 to 1, for gauge pressures; `volume` gives it in mm³/s for a pressure
    /// difference in MPa.
    #[doc(hidden)]
    pub fn flows(
        &self,
        opening: f64,
        (supply_mpa, muscle_mpa): (f64, f64),
        volume: impl FnOnce(f64) -> f64,
    ) -> (Flow, Flow) {
        let into = opening > 0.0;
        let difference = if into {
            supply_mpa - muscle_mpa
        } else {
            -muscle_mpa
        };
        let flow = self.flow(if opening == 0.0 {
            0.0
        } else {
            volume(difference)
        });
        if into {
            (flow, self.flow(0.0))
        } else {
            (self.flow(0.0), flow)
        }
    }
}
