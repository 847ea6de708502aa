//! Liquids that fill a muscle: their compression under pressure, with the gas that is in them.

use crate::{analysis::ATMOSPHERE_MPA, refused::Refused};
use serde::Serialize;

/// The liquids that have a name, at 20 °C and without gas. Water: ρ and K (isothermal) by
/// \[kell1975\], its η and all of oil and glycol by \[white2011\], table A.3. Oils of one class
/// differ by 20 % in K; half glycol and half water lies between both.
pub const LIQUIDS: [Liquid; 3] = [
    entry("water", 998.2, 2179.0, 1.00e-3),
    // Mineral oil SAE 10W.
    entry("oil", 870.0, 1310.0, 1.04e-1),
    // Ethylene glycol.
    entry("glycol", 1117.0, 3050.0, 2.14e-2),
];

const fn entry(
    name: &'static str,
    density_kg_per_m3: f64,
    bulk_modulus_mpa: f64,
    viscosity_pa_s: f64,
) -> Liquid {
    Liquid {
        name,
        density_kg_per_m3,
        bulk_modulus_mpa,
        viscosity_pa_s,
        gas_share: 0.0,
    }
}

/// A liquid with bubbles of gas.
///
/// ```text
/// φ(P) = (1 − α) exp(−P/K) + α pa/(pa + P)      volume at P over that at atmospheric pressure
///
/// P    gauge pressure                                MPa, 0 and above
/// K    bulk modulus of the liquid, K = ρ dP/dρ       MPa
/// α    gas by volume, at atmospheric pressure        –, 0 to 0.9
/// pa   atmospheric pressure, 0.101325                MPa
/// ```
///
/// The gas is ideal, stays at its temperature (slow changes) and does not dissolve; in fact some of
/// it dissolves under pressure, and the liquid is stiffer then. At 1 bar 1 % of gas is compressed
/// 54 times as much as the water around it. Source: \[merritt1967\], effective bulk modulus.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Liquid {
    /// Its name.
    pub name: &'static str,
    /// Density in kg/m³ without gas.
    pub density_kg_per_m3: f64,
    /// Bulk modulus K in MPa without gas.
    pub bulk_modulus_mpa: f64,
    /// Dynamic viscosity in Pa s without gas.
    pub viscosity_pa_s: f64,
    /// Gas by volume at atmospheric pressure, α.
    pub gas_share: f64,
}

/// A liquid, and what it fills besides the muscle.
#[derive(Debug, Clone, PartialEq)]
pub struct LiquidSupply {
    /// The liquid.
    pub liquid: Liquid,
    /// Vd in mm³: line, fittings, and what stays in the syringe.
    pub dead_volume_mm3: f64,
}

impl Liquid {
    /// A liquid of the table with a share of gas.
    pub fn named(name: &str, gas_share: f64) -> Result<Self, Refused> {
        let liquid = LIQUIDS.into_iter().find(|liquid| liquid.name == name);
        let liquid = liquid.ok_or_else(|| {
            let names = LIQUIDS.map(|liquid| liquid.name).join(", ");
            Refused::new(
                ["liquid", "name"],
                format!("there is no liquid \"{name}\"; the liquids are {names}"),
            )
        })?;
        Self {
            gas_share,
            ..liquid
        }
        .validated()
    }

    /// The same with another bulk modulus in MPa.
    pub fn with_bulk_modulus(self, bulk_modulus_mpa: f64) -> Result<Self, Refused> {
        Self {
            bulk_modulus_mpa,
            ..self
        }
        .validated()
    }

    fn validated(self) -> Result<Self, Refused> {
        let k = self.bulk_modulus_mpa;
        if !(k > 0.0 && k.is_finite()) {
            let message =
                format!("the bulk modulus of the liquid is {k} MPa; it must be above zero");
            return Err(Refused::new(
                ["liquid_bulk_modulus_mpa", "bulk_modulus"],
                message,
            ));
        }
        if !(0.0..=0.9).contains(&self.gas_share) {
            return Err(Refused::new(
                ["gas_share"; 2],
                format!(
                    "the share of gas is {}; it must lie between 0 and 0.9",
                    self.gas_share
                ),
            ));
        }
        Ok(self)
    }

    /// φ: the volume at a gauge pressure in MPa over that at atmospheric pressure.
    pub fn relative_volume(&self, pressure_mpa: f64) -> f64 {
        let gas = ATMOSPHERE_MPA / (ATMOSPHERE_MPA + pressure_mpa);
        (1.0 - self.gas_share) * (-pressure_mpa / self.bulk_modulus_mpa).exp()
            + self.gas_share * gas
    }

    /// ΔV in mm³ at atmospheric pressure that is pushed in while the cavity grows from V0 without
    /// pressure to V at a gauge pressure in MPa: (V + Vd)/φ(P) − V0 − Vd.
    pub fn pushed_mm3(
        &self,
        (rest_mm3, cavity_mm3): (f64, f64),
        dead_volume_mm3: f64,
        pressure_mpa: f64,
    ) -> f64 {
        (cavity_mm3 + dead_volume_mm3) / self.relative_volume(pressure_mpa)
            - rest_mm3
            - dead_volume_mm3
    }

    /// Mass in g of a volume in mm³ at atmospheric pressure, without that of its gas.
    pub fn mass_g(&self, volume_mm3: f64) -> f64 {
        1e-6 * self.density_kg_per_m3 * (1.0 - self.gas_share) * volume_mm3
    }

    /// −dφ/dP in 1/MPa.
    pub fn compliance_per_mpa(&self, pressure_mpa: f64) -> f64 {
        let k = self.bulk_modulus_mpa;
        let absolute = ATMOSPHERE_MPA + pressure_mpa;
        (1.0 - self.gas_share) * (-pressure_mpa / k).exp() / k
            + self.gas_share * ATMOSPHERE_MPA / (absolute * absolute)
    }

    /// The bulk modulus of liquid and gas together in MPa, φ/(−dφ/dP).
    pub fn effective_bulk_modulus_mpa(&self, pressure_mpa: f64) -> f64 {
        self.relative_volume(pressure_mpa) / self.compliance_per_mpa(pressure_mpa)
    }

    /// ∫ P (−dφ/dP) dP from 0, in N mm for each mm³ at atmospheric pressure: the work of a pump on
    /// the liquid itself.
    pub fn energy_mpa(&self, pressure_mpa: f64) -> f64 {
        let x = pressure_mpa / self.bulk_modulus_mpa;
        // 1 − (1 + x) e^(−x), by its series where that cancels.
        let stored = if x.abs() < 0.05 {
            x * x
                * (1.0 / 2.0
                    - x * (1.0 / 3.0
                        - x * (1.0 / 8.0
                            - x * (1.0 / 30.0
                                - x * (1.0 / 144.0 - x * (1.0 / 840.0 - x / 5760.0))))))
        } else {
            1.0 - (1.0 + x) * (-x).exp()
        };
        let y = pressure_mpa / ATMOSPHERE_MPA;
        (1.0 - self.gas_share) * self.bulk_modulus_mpa * stored
            + self.gas_share * ATMOSPHERE_MPA * (y.ln_1p() - y / (1.0 + y))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: 1 % of gas at four times the atmospheric pressure has a quarter of its volume: 0.99
    /// exp(−0.303975/2179) + 0.0025.
    #[test]
    fn gas_keeps_pressure_times_volume() {
        let water = Liquid::named("water", 0.01).unwrap();
        let p = 3.0 * ATMOSPHERE_MPA;
        assert!(
            (water.relative_volume(p) - (0.99 * (-0.303_975_f64 / 2179.0).exp() + 0.0025)).abs()
                < 1e-15
        );
        // 0.01 · 0.101325/0.4053² = 6.168e-3 per MPa of gas beside 4.543e-4 of water.
        assert!((water.compliance_per_mpa(p) - (6.168_270e-3 + 4.542_735e-4)).abs() < 1e-9);
    }

    #[test]
    fn the_compliance_is_the_slope_of_the_volume_and_the_energy_its_integral() {
        for (name, gas) in [("water", 0.0), ("oil", 0.02), ("glycol", 0.3)] {
            for k in [60.0, 2000.0] {
                let liquid = Liquid::named(name, gas)
                    .unwrap()
                    .with_bulk_modulus(k)
                    .unwrap();
                for p in [0.05, 0.4, 2.5, 10.0] {
                    let h = 1e-4 * p;
                    let slope =
                        (liquid.relative_volume(p - h) - liquid.relative_volume(p + h)) / (2.0 * h);
                    assert!(
                        (slope / liquid.compliance_per_mpa(p) - 1.0).abs() < 1e-7,
                        "{liquid:?} {p}"
                    );
                    let power = (liquid.energy_mpa(p + h) - liquid.energy_mpa(p - h)) / (2.0 * h);
                    assert!((power / (p * slope) - 1.0).abs() < 1e-6, "{liquid:?} {p}");
                }
                assert_eq!(
                    (liquid.relative_volume(0.0), liquid.energy_mpa(0.0)),
                    (1.0, 0.0)
                );
            }
        }
    }

    #[test]
    fn what_is_no_liquid_is_told() {
        let error = Liquid::named("watr", 0.0).unwrap_err();
        assert_eq!(
            error.to_string(),
            "there is no liquid \"watr\"; the liquids are water, oil, glycol"
        );
        for gas in [-0.1, 1.0, f64::NAN] {
            assert_eq!(
                Liquid::named("oil", gas).unwrap_err().fields[1],
                "gas_share"
            );
        }
        let water = Liquid::named("water", 0.0).unwrap();
        assert_eq!(
            water.with_bulk_modulus(0.0).unwrap_err().fields[1],
            "bulk_modulus"
        );
    }
}
