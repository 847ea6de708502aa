//! How an end holds tube and sleeve, by the load that it carries in the proof test.
//!
//! | ends | load | what holds |
//! |---|---|---|
//! | tied | to half of what the ties hold by estimate, about 200 N | cable ties in grooves |
//! | clamped | to 1000 N, and to what one or two clamps hold at best | hose clamps behind barbs |
//! | crimped | above | the sleeve pressed on a metal shoulder beyond the tube: by a ferrule, from 40 mm on by clamps with a bolt; a hose clamp seals the tube |
//!
//! The limits are choices: no pull-off force of a clamp on a muscle was found in any source. So
//! every end is proved.

use crate::sold::first;
use mckibben_core::{
    by_number::ByNumber,
    muscle::EndsMade::{self, Crimped, Tied},
};
use std::f64::consts::PI;

/// Ties with their least loop strength (QB/T 4494-2013). The stems are a choice: a narrow tie bends
/// to a small circle more evenly.
const TIES: [Tie; 4] = [
    Tie::new(2.5, 80.0, 6.0),
    Tie::new(3.6, 130.0, 15.0),
    Tie::new(4.8, 180.0, 40.0),
    Tie::new(7.6, 450.0, f64::INFINITY),
];
/// A tie that is tightened by hand has this share of its strength (a choice).
const TIGHTENED: f64 = 1.0 / 3.0;
/// Friction of a sleeve on a tube under a band (an estimate).
const FRICTION: f64 = 0.3;
/// Ties at an end at most.
const MOST_TIES: usize = 3;

/// What ties hold over the load of the proof test (a choice: they creep).
const TIES_TO_PROOF: f64 = 2.0;
/// Largest load in N of an end with hose clamps (a choice).
const CLAMPED_TO_N: f64 = 1000.0;
/// Hose clamps at an end at most.
const MOST_CLAMPS: f64 = 2.0;
/// Bands of hose clamps (DIN 3017-1) in mm; the wider one from this diameter on, from which on
/// clamps with a bolt take the place of ferrules too: few presses close on more.
const BANDS_MM: [f64; 2] = [9.0, 12.0];
const WIDE_FROM_MM: f64 = 40.0;
/// Few hose clamps close on less, in mm: there a tie seals a crimped end (a choice).
const CLAMPS_FROM_MM: f64 = 8.0;
/// By this share a clamp squeezes the wall of the tube (a choice).
pub const SQUEEZE: f64 = 0.25;

/// Clamps with a T-bolt (DIN 3017-3): band and bolt in mm, and torque in N m (choices).
pub const BOLT_BAND_MM: f64 = 25.0;
pub const BOLT_MM: f64 = 8.0;
pub const BOLT_NM: f64 = 15.0;
/// Torque of a bolt over its tension and diameter (Budynas & Nisbett 2011 \[budynas2011\], table
/// 8-15, zinc-plated).
const NUT_FACTOR: f64 = 0.2;
/// Friction of a sleeve on metal at least, and at most: choices, half of [`FRICTION`] and that.
const ON_METAL: [f64; 2] = [0.5 * FRICTION, FRICTION];

/// Precision steel tubes (EN 10305-1): outer diameters and walls in mm.
const STEEL_MM: [u16; 20] = [
    6, 8, 10, 12, 14, 15, 16, 18, 20, 22, 25, 28, 30, 32, 35, 38, 40, 42, 45, 50,
];
const STEEL_WALLS_MM: [f64; 4] = [2.5, 2.0, 1.5, 1.0];
/// Yield strength in MPa of their steel E235, normalized (+N; EN 10305-1).
const STEEL_YIELDS_MPA: f64 = 235.0;
/// Play in mm of a ferrule on the sleeve before it is pressed, and its length, at least (choices).
const FERRULE_PLAY_MM: f64 = 0.3;
const FERRULE_MM: f64 = 12.0;
/// Room in mm before a ferrule, and behind it up to the head, for the edge of the dies (a choice).
pub const FERRULE_ROOM_MM: [f64; 2] = [1.0, 3.0];

/// What presses the sleeve on a shoulder beyond the tube.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Press {
    Ferrule(Ferrule),
    /// So many clamps with a bolt.
    BoltClamps(usize),
}

/// A ferrule: a piece of precision steel tube.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ferrule {
    /// Outer diameter and wall of the tube.
    pub outer_mm: f64,
    pub wall_mm: f64,
    pub length_mm: f64,
    /// Outer diameter once it is pressed.
    pub pressed_mm: f64,
}

impl Ferrule {
    /// The smallest one that goes over the sleeve on a shoulder, as long as a load in N asks; a
    /// millimetre of its diameter is worth 10 mm of its length (a choice).
    pub fn new(over: Clamped, load_n: f64) -> Self {
        let all = STEEL_MM.iter().flat_map(|outer_mm| {
            STEEL_WALLS_MM.map(|wall_mm| Self::of([f64::from(*outer_mm), wall_mm], over, load_n))
        });
        let fits = all.filter(|f| f.bore_mm() >= over.diameter_mm + FERRULE_PLAY_MM);
        fits.min_by_number(|f| f.outer_mm + 0.1 * f.length_mm)
            .unwrap_or_else(|| Self::of([over.diameter_mm.ceil() + 6.0, 2.5], over, load_n))
    }

    /// Of a tube. Pressed it squeezes the sleeve by [`SQUEEZE`]; its cross-section stays what it was.
    fn of([outer_mm, wall_mm]: [f64; 2], over: Clamped, load_n: f64) -> Self {
        let closed_mm = over.diameter_mm - 2.0 * SQUEEZE * over.sleeve_mm;
        let each_mm = belted_n(STEEL_YIELDS_MPA * wall_mm)[0];
        Self {
            outer_mm,
            wall_mm,
            length_mm: (load_n / each_mm).ceil().max(FERRULE_MM),
            pressed_mm: closed_mm.hypot((4.0 * wall_mm * (outer_mm - wall_mm)).sqrt()),
        }
    }

    fn bore_mm(&self) -> f64 {
        self.outer_mm - 2.0 * self.wall_mm
    }

    /// What it holds in N: 2π μ T, T = σy t w its hoop tension, with little and with much friction.
    pub fn holds_n(&self) -> [f64; 2] {
        belted_n(STEEL_YIELDS_MPA * self.wall_mm * self.length_mm)
    }
}

/// A cable tie.
#[derive(Clone, Copy)]
struct Tie {
    width_mm: f64,
    /// Least loop strength.
    strength_n: f64,
    /// Largest diameter of a stem.
    stem_mm: f64,
}

impl Tie {
    const fn new(width_mm: f64, strength_n: f64, stem_mm: f64) -> Self {
        Self {
            width_mm,
            strength_n,
            stem_mm,
        }
    }

    /// The tie for a stem.
    fn around(stem_mm: f64) -> Self {
        first(&TIES, |tie| stem_mm <= tie.stem_mm)
    }

    /// Its holding force in N by friction: 2π μ T.
    fn holds_n(self) -> f64 {
        2.0 * PI * FRICTION * TIGHTENED * self.strength_n
    }
}

/// The tube in its clamps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clamped {
    /// Bore, and wall.
    pub bore_mm: f64,
    pub wall_mm: f64,
    /// Thickness of the sleeve.
    pub sleeve_mm: f64,
    /// Shear modulus of the rubber.
    pub mu_mpa: f64,
    /// Diameter over tube and sleeve on the plug.
    pub diameter_mm: f64,
}

/// What holds tube and sleeve at each end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ends {
    pub made: EndsMade,
    /// Width in mm of a tie, or of the band of a clamp.
    pub band_mm: f64,
    /// Ties or clamps at each end.
    pub at_each_end: usize,
    /// Whether bands are cable ties; else they are hose clamps.
    pub has_ties: bool,
    /// Of crimped ends, which also have a band that seals: what presses the sleeve.
    pub press: Option<Press>,
    /// What they hold by estimate in N, from and to: of a hose clamp if the rubber flows out under
    /// it, and if none does; of ferrules and clamps with a bolt with little friction and with much.
    pub holds_n: [f64; 2],
}

impl Ends {
    /// Thickness of ties, bands and ferrules in mm.
    pub const CLAMP_MM: f64 = 1.5;

    /// The ends for a load in N in the proof test, and the most that it may be as built, which steel
    /// must hold; `made` is how they are held, where that is stated.
    pub fn new([load_n, most_n]: [f64; 2], tube: Clamped, made: Option<EndsMade>) -> Self {
        let tie = Tie::around(tube.bore_mm);
        let ties = (TIES_TO_PROOF * load_n / tie.holds_n()).ceil().max(2.0);
        let is_narrow = tube.diameter_mm < CLAMPS_FROM_MM;
        let is_wide = tube.diameter_mm >= WIDE_FROM_MM;
        let clamp_mm = BANDS_MM[usize::from(is_wide)];
        let squeezed = squeezed_n(tube, clamp_mm);
        let clamps = (load_n / squeezed[1]).ceil().max(1.0);
        let usual = match load_n {
            _ if ties <= MOST_TIES as f64 => Tied,
            _ if is_narrow => Crimped,
            load_n if load_n <= CLAMPED_TO_N && clamps <= MOST_CLAMPS => EndsMade::Clamped,
            _ => Crimped,
        };
        let made = made.unwrap_or(usual);
        let has_ties = made == Tied || (made == Crimped && is_narrow);
        let at_each_end = match made {
            Tied => ties.min(MOST_TIES as f64) as usize,
            EndsMade::Clamped => clamps.min(MOST_CLAMPS) as usize,
            Crimped => 1,
        };
        let press = (made == Crimped).then(|| match is_wide {
            true => Press::BoltClamps((most_n / bolted_n()[0]).ceil().max(1.0) as usize),
            false => Press::Ferrule(Ferrule::new(tube, most_n)),
        });
        let (count, each_n) = match press {
            Some(Press::BoltClamps(count)) => (count, bolted_n()),
            Some(Press::Ferrule(ferrule)) => (1, ferrule.holds_n()),
            None if has_ties => (at_each_end, [tie.holds_n(); 2]),
            None => (at_each_end, squeezed),
        };
        Self {
            made,
            band_mm: if has_ties { tie.width_mm } else { clamp_mm },
            at_each_end,
            has_ties,
            press,
            holds_n: each_n.map(|n| count as f64 * n),
        }
    }

    /// What closes on the tube.
    pub fn band(&self) -> &'static str {
        if self.has_ties {
            "cable tie"
        } else {
            "hose clamp"
        }
    }

    /// What presses the sleeve on a shoulder.
    pub fn pressed_by(&self) -> &'static str {
        match self.press {
            Some(Press::BoltClamps(_)) => "clamps with a bolt",
            _ => "ferrule",
        }
    }

    /// Least length in mm of tube and sleeve on the plug.
    pub fn least_mm(&self) -> f64 {
        match self.made {
            Tied => self.at_each_end as f64 * (self.band_mm + 2.0),
            EndsMade::Clamped => self.at_each_end as f64 * (self.band_mm + 3.0),
            Crimped => self.band_mm + 3.0 + self.pressed_mm(),
        }
    }

    /// Least length in mm of a shoulder.
    fn pressed_mm(&self) -> f64 {
        match self.press {
            Some(Press::BoltClamps(count)) => 2.0 + count as f64 * (BOLT_BAND_MM + 2.0),
            Some(Press::Ferrule(ferrule)) => {
                FERRULE_ROOM_MM[0] + ferrule.length_mm + FERRULE_ROOM_MM[1]
            }
            None => 0.0,
        }
    }

    /// Whether they hold a load in N of the proof test by their estimate, at best; of ties with their
    /// factor.
    pub fn bear(&self, load_n: f64) -> bool {
        let [low, high] = self.holds_n;
        match self.made {
            Tied => low >= TIES_TO_PROOF * load_n,
            _ => high >= load_n,
        }
    }
}

/// What a hose clamp holds in N by friction, as it squeezes the wall of the tube by a share q: 0.3 π
/// D w p, with the stress p = (4/3) E q of a long strip between plates that slide, and (4/3) E q (1 +
/// S²) of one that is bonded to them, S = w/2s (Gent & Lindley 1959 \[gent1959\]).
fn squeezed_n(tube: Clamped, band_mm: f64) -> [f64; 2] {
    let flows_mpa = 4.0 * tube.mu_mpa * SQUEEZE;
    let shape = band_mm / (2.0 * tube.wall_mm);
    let held_mpa = flows_mpa * (1.0 + shape * shape);
    [flows_mpa, held_mpa].map(|p| FRICTION * PI * tube.diameter_mm * band_mm * p)
}

/// What a clamp with a bolt holds in N, with T = M/(K d).
pub fn bolted_n() -> [f64; 2] {
    belted_n(1e3 * BOLT_NM / (NUT_FACTOR * BOLT_MM))
}

/// What a belt under a tension T in N holds on metal by friction: 2π μ T in N.
fn belted_n(tension_n: f64) -> [f64; 2] {
    ON_METAL.map(|friction| 2.0 * PI * friction * tension_n)
}
