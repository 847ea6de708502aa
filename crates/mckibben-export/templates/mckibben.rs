#![no_std]
#![allow(dead_code, unused_attributes, unexpected_cfgs)]
#![allow(clippy::approx_constant, clippy::excessive_precision, clippy::neg_cmp_op_on_partial_ord)]
#![forbid(unsafe_code)]

/// Numbers in single precision.
#[cfg(any(mckibben_float, all(target_arch = "arm", target_os = "none", not(mckibben_double))))]
mod precision {
    pub type Real = f32;
    pub type Bits = u32;
    /// Holds the square of a root with one bit more.
    pub type Wide = u64;
    pub const STEP: Real = 1e-7;
    /// Parts of π/2: products of the first two with small whole numbers are exact.
    pub const RIGHT_ANGLE: [Real; 3] = [1.5703125, 4.837512969970703125e-4, 7.549789954891882e-8];
}

/// Numbers in double precision.
#[cfg(not(any(mckibben_float, all(target_arch = "arm", target_os = "none", not(mckibben_double)))))]
mod precision {
    pub type Real = f64;
    pub type Bits = u64;
    /// Holds the square of a root with one bit more.
    pub type Wide = u128;
    pub const STEP: Real = 1e-14;
    /// Parts of π/2: products of the first two with small whole numbers are exact.
    pub const RIGHT_ANGLE: [Real; 3] = [1.57079632673412561417, 6.07710050630396597660e-11, 2.02226624879595063154e-21];
}

pub use self::precision::Real;

/// Outside of the box each answer is that of its nearest point; what is not a number counts as the lower end. A status is a sum of these: the muscle would
/// have to push, and is slack. This alone is no error.
pub const SLACK: u32 = 1;
/// The pressure lies outside of the box, or is not a number.
pub const PRESSURE_OUTSIDE: u32 = 2;
/// The contraction lies outside of the box, or is not a number.
pub const CONTRACTION_OUTSIDE: u32 = 4;
/// Nothing in the box gives this pull.
pub const NO_ANSWER: u32 = 8;

/// No answer in the box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutOfRange<T = Real> {
    /// The answer at the nearest point of the box, or the nearest end of the box.
    pub nearest: T,
    /// Why: a sum of the constants.
    pub status: u32,
}

impl<T> core::fmt::Display for OutOfRange<T> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "outside of the range of the muscle (status {})", self.status)
    }
}

impl<T: core::fmt::Debug> core::error::Error for OutOfRange<T> {}

/// What a function answers.
pub type Answer<T = Real> = Result<T, OutOfRange<T>>;

fn answer<T>((nearest, status): (T, u32)) -> Answer<T> {
    if status & !SLACK == 0 {
        Ok(nearest)
    } else {
        Err(OutOfRange { nearest, status })
    }
}

/// The answer, or that at the nearest point of the box.
pub fn nearest<T>(answer: Answer<T>) -> T {
    answer.unwrap_or_else(|outside| outside.nearest)
}

/// How many functions of the pressure there are.
pub const FUNCTIONS: usize = 5;
/// A number for each function of the pressure.
pub type Functions = [Real; FUNCTIONS];
/// Shares of the supply between which the pull is of second degree in the pressure.
const PARTS: [(Real, Real); 3] = [(0.0, 0.15), (0.15, 0.45), (0.45, 1.0)];

/// The functions of the contraction at one contraction 1 − L/L0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Node {
    pub contraction: Real,
    pub value_n: Functions,
    /// dc/dε.
    pub slope_n: Functions,
}

static NONE: Node = Node { contraction: 0.0, value_n: [0.0; FUNCTIONS], slope_n: [0.0; FUNCTIONS] };

/// Branch of the hysteresis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Branch {
    Shortening,
    Mean,
    Lengthening,
}

/// The numbers of a muscle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Muscle<'a> {
    /// L0, at rest.
    pub length_m: Real,
    /// A rope or rod between the muscle and what it pulls; the length of each function is that of both.
    pub cord_m: Real,
    /// Upper end of the box of pressures.
    pub supply_pa: Real,
    /// The first and the last are the ends of the box of contractions.
    pub nodes: &'a [Node],
    pub volume_m3: Functions,
    /// Half the hysteresis is (f0 + f1 e + f2 e²) √q + (f3 + f4 e + f5 e²) q in N, e the contraction; it builds up over f6 in m.
    pub friction: [Real; 7],
    /// For simulators: pull and volume continue outside of the box along their tangents, with one potential.
    pub beyond: bool,
}

/// The functions of the contraction at a contraction, and the part between two nodes with the place in it.
struct Spline {
    c: Functions,
    slope: Functions,
    part: usize,
    t: Real,
    h: Real,
    beyond: Real,
}

/// A muscle at a pressure and a contraction; the pull is negative where it would have to push.
pub(crate) struct State {
    spline: Spline,
    phi: Functions,
    by_q: Functions,
    pub pull: Real,
    pub status: u32,
}

impl State {
    /// The slope of the pull in the contraction.
    pub(crate) fn slope_in_contraction(&self) -> Real {
        sum_of(&self.spline.slope, &self.phi)
    }

    /// Its slope in the pressure over the supply.
    pub(crate) fn slope_in_q(&self) -> Real {
        sum_of(&self.spline.c, &self.by_q)
    }
}

/// The nearest number from `low` to `high`; `low` of what is not a number.
fn within(value: Real, low: Real, high: Real) -> Real {
    if value > high {
        high
    } else if value >= low {
        value
    } else {
        low
    }
}

fn sum_of(c: &Functions, phi: &Functions) -> Real {
    c.iter().zip(phi).fold(0.0, |sum, (c, phi)| sum + c * phi)
}

/// The functions of the pressure, and their slopes.
pub(crate) fn functions(q: Real) -> (Functions, Functions) {
    let (mut phi, mut slope) = ([1.0, q, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0, 0.0]);
    let later = phi.iter_mut().zip(&mut slope).skip(2);
    for ((phi, slope), (knot, _)) in later.zip(PARTS) {
        let t = if q <= knot {
            0.0
        } else if q <= 1.0 {
            q - knot
        } else {
            1.0 - knot
        };
        *phi = t * (t + if q > 1.0 { 2.0 * (q - 1.0) } else { 0.0 });
        *slope = 2.0 * t;
    }
    (phi, slope)
}

/// Values and slopes at both ends of a part, with these weights.
fn weighted([v0, v1, v2, v3]: [Real; 4], from: &Node, to: &Node) -> Functions {
    let mut all = [0.0; FUNCTIONS];
    let ends = from.value_n.iter().zip(&from.slope_n).zip(to.value_n.iter().zip(&to.slope_n));
    for (one, ((a0, b0), (a1, b1))) in all.iter_mut().zip(ends) {
        *one = v0 * a0 + v1 * b0 + v2 * a1 + v3 * b1;
    }
    all
}

/// The weights of the integral over a share of a part.
fn areas(t: Real, h: Real) -> [Real; 4] {
    let (s3, s4) = (t * t * t, t * t * t * t);
    [h * (t - s3 + 0.5 * s4), h * h * (0.5 * t * t - 2.0 / 3.0 * s3 + 0.25 * s4), h * (s3 - 0.5 * s4), h * h * (0.25 * s4 - s3 / 3.0)]
}

/// Square root, rounded to the nearest number as IEEE 754 asks (the core library has none).
fn root(value: Real) -> Real {
    const DIGITS: i32 = Real::MANTISSA_DIGITS as i32;
    if !(value > 0.0 && value < Real::INFINITY) {
        return if value < 0.0 { Real::NAN } else { value };
    }
    if value < Real::MIN_POSITIVE {
        return root(value / Real::EPSILON / Real::EPSILON) * Real::EPSILON;
    }
    // value = digits 2^exponent; the root of digits 2^shift has one bit more than a number, and is never half between two.
    let bits = value.to_bits();
    let exponent = (bits >> (DIGITS - 1)) as i32 + Real::MIN_EXP - 1 - DIGITS;
    let shift = DIGITS + 1 + ((exponent + DIGITS + 1) & 1);
    let digits = (bits & ((1 << (DIGITS - 1)) - 1)) | (1 << (DIGITS - 1));
    let whole = ((precision::Wide::from(digits) << shift).isqrt() + 1) >> 1;
    let power = (exponent - shift) / 2 + 1 + Real::MAX_EXP - 1;
    whole as Real * Real::from_bits((power as precision::Bits) << (DIGITS - 1))
}

impl Muscle<'_> {
    /// Lower end of the box of contractions.
    pub fn contraction_low(&self) -> Real {
        self.nodes.first().map_or(0.0, |node| node.contraction)
    }

    /// Upper end of the box of contractions.
    pub fn contraction_high(&self) -> Real {
        self.nodes.last().map_or(0.0, |node| node.contraction)
    }

    fn contraction_of(&self, length_m: Real) -> Real {
        1.0 - (length_m - self.cord_m) / self.length_m
    }

    fn outside(&self, pressure_pa: Real, contraction: Real) -> u32 {
        let pressure = if pressure_pa >= 0.0 && pressure_pa <= self.supply_pa { 0 } else { PRESSURE_OUTSIDE };
        let is_inside = contraction >= self.contraction_low() && contraction <= self.contraction_high();
        pressure | if is_inside { 0 } else { CONTRACTION_OUTSIDE }
    }

    fn spline(&self, contraction: Real) -> Spline {
        let inside = within(contraction, self.contraction_low(), self.contraction_high());
        let (mut part, mut from, mut to) = (0, &NONE, &NONE);
        for (n, pair) in self.nodes.windows(2).enumerate() {
            match pair {
                [a, b] if n == 0 || inside >= a.contraction => (part, from, to) = (n, a, b),
                _ => {}
            }
        }
        let h = to.contraction - from.contraction;
        let t = (inside - from.contraction) / h;
        let s = 1.0 - t;
        let beyond = if self.beyond && contraction.is_finite() { contraction - inside } else { 0.0 };
        let values = [(1.0 + 2.0 * t) * s * s, h * t * s * s, t * t * (3.0 - 2.0 * t), -h * t * t * s];
        let slopes = [-6.0 * t * s / h, s * (1.0 - 3.0 * t), 6.0 * t * s / h, t * (3.0 * t - 2.0)];
        let slope = weighted(slopes, from, to);
        let mut c = weighted(values, from, to);
        for (c, slope) in c.iter_mut().zip(&slope) {
            *c += slope * beyond;
        }
        Spline { c, slope, part, t, h, beyond }
    }

    /// The integrals of the functions of the contraction from the lower end of the box.
    fn integrals(&self, k: &Spline) -> Functions {
        let mut sums = [0.0; FUNCTIONS];
        for (sum, (c, slope)) in sums.iter_mut().zip(k.c.iter().zip(&k.slope)) {
            *sum = k.beyond * (c - 0.5 * slope * k.beyond);
        }
        for (n, pair) in self.nodes.windows(2).take(k.part + 1).enumerate() {
            if let [from, to] = pair {
                let (t, h) = if n < k.part { (1.0, to.contraction - from.contraction) } else { (k.t, k.h) };
                for (sum, more) in sums.iter_mut().zip(weighted(areas(t, h), from, to)) {
                    *sum += more;
                }
            }
        }
        sums
    }

    pub(crate) fn state(&self, pressure_pa: Real, contraction: Real) -> State {
        let q = pressure_pa / self.supply_pa;
        let (phi, by_q) = functions(if self.beyond && q.is_finite() { q } else { within(q, 0.0, 1.0) });
        let spline = self.spline(contraction);
        let pull = sum_of(&spline.c, &phi);
        let status = self.outside(pressure_pa, contraction) | if pull <= 0.0 { SLACK } else { 0 };
        State { spline, phi, by_q, pull, status }
    }

    fn state_at(&self, pressure_pa: Real, length_m: Real) -> State {
        self.state(pressure_pa, self.contraction_of(length_m))
    }

    /// 0, or a sum of [`SLACK`], [`PRESSURE_OUTSIDE`] and [`CONTRACTION_OUTSIDE`].
    pub fn status(&self, pressure_pa: Real, length_m: Real) -> u32 {
        self.state_at(pressure_pa, length_m).status
    }

    /// Pull, 0 where the muscle is slack. The box: pressures from 0 to `supply_pa`, contractions from [`Muscle::contraction_low`] to
    /// [`Muscle::contraction_high`]; as of all functions.
    pub fn force_n(&self, pressure_pa: Real, length_m: Real) -> Answer {
        let state = self.state_at(pressure_pa, length_m);
        answer((if state.pull <= 0.0 { 0.0 } else { state.pull }, state.status))
    }

    /// dF/dL at constant pressure; 0 where the muscle is slack.
    pub fn stiffness_n_per_m(&self, pressure_pa: Real, length_m: Real) -> Answer {
        let state = self.state_at(pressure_pa, length_m);
        let slope = -state.slope_in_contraction() / self.length_m;
        answer((if state.pull <= 0.0 { 0.0 } else { slope }, state.status))
    }

    /// dF/dP at constant length; 0 where the muscle is slack.
    pub fn force_per_pressure_m2(&self, pressure_pa: Real, length_m: Real) -> Answer {
        let state = self.state_at(pressure_pa, length_m);
        let slope = state.slope_in_q() / self.supply_pa;
        answer((if state.pull <= 0.0 { 0.0 } else { slope }, state.status))
    }

    /// Volume of the cavity; of a slack muscle that at its free contraction.
    pub fn volume_m3(&self, pressure_pa: Real, length_m: Real) -> Answer {
        let volume = self.volume_of(pressure_pa, self.contraction_of(length_m));
        answer((volume, self.status(pressure_pa, length_m)))
    }

    pub(crate) fn volume_of(&self, pressure_pa: Real, contraction: Real) -> Real {
        // Slack without pressure at the lower end of the box, its volume is nowhere that of a longer muscle.
        let least = match self.nodes {
            [low, ..] if low.value_n[0] < 0.0 => low.contraction,
            _ => Real::NEG_INFINITY,
        };
        let state = self.state(pressure_pa, contraction.max(least));
        let free = || self.spline(self.contraction_and_status(0.0, pressure_pa).0.max(least));
        let integrals = if state.pull <= 0.0 { self.integrals(&free()) } else { self.integrals(&state.spline) };
        let parts = integrals.iter().zip(&state.by_q).skip(1);
        let sum = parts.fold(0.0, |sum, (integral, by_q)| sum + integral * by_q);
        sum_of(&self.volume_m3, &state.phi) + self.length_m / self.supply_pa * sum
    }

    /// Pressure at which the muscle pulls with `force_n` at a length, in closed form. [`NO_ANSWER`] and 0 where it pulls more without pressure, where it
    /// would have to push, and of what is not a number; the supply where that is too low.
    pub fn pressure_pa(&self, force_n: Real, length_m: Real) -> Answer {
        answer(self.pressure_and_status(force_n, length_m))
    }

    fn pressure_and_status(&self, force_n: Real, length_m: Real) -> (Real, u32) {
        let contraction = self.contraction_of(length_m);
        let [mut pull, mut slope, curves @ ..] = self.spline(contraction).c;
        let mut curve = 0.0;
        let status = self.outside(0.0, contraction);
        if !(force_n >= 0.0 && force_n >= pull) {
            return (0.0, status | NO_ANSWER);
        }
        if force_n <= pull {
            return (0.0, status);
        }
        // Between two knots the pull is of second degree in the pressure.
        for (&(knot, next), more) in PARTS.iter().zip(&curves) {
            let width = next - knot;
            let missing = if force_n > pull { force_n - pull } else { 0.0 };
            curve += more;
            let square = slope * slope + 4.0 * curve * missing;
            let below = if square > 0.0 { slope + root(square) } else { 0.0 };
            if below > 0.0 && 2.0 * missing < below * width {
                return ((knot + 2.0 * missing / below) * self.supply_pa, status);
            }
            pull += width * (slope + curve * width);
            slope += 2.0 * curve * width;
        }
        // Within a millionth the supply gives its own pull.
        let is_reached = force_n <= 1.000001 * pull;
        (self.supply_pa, status | if is_reached { 0 } else { NO_ANSWER })
    }

    /// The same on a branch of the hysteresis, by 40 halvings: while the muscle shortens, while it lengthens, or in the mean of both.
    pub fn pressure_on_branch_pa(&self, force_n: Real, length_m: Real, branch: Branch) -> Answer {
        let (mean, mut status) = self.pressure_and_status(force_n, length_m);
        let velocity = match branch {
            Branch::Shortening => -1.0,
            Branch::Mean => return answer((mean, status)),
            Branch::Lengthening => 1.0,
        };
        // Without pressure there is no friction: what has no answer there has none on a branch.
        if status & NO_ANSWER != 0 && mean <= 0.0 {
            return answer((mean, status));
        }
        status |= NO_ANSWER;
        let (mut low, mut high, mut middle) = (0.0, self.supply_pa, self.supply_pa);
        for _ in 0..41 {
            let friction = nearest(self.friction_n(middle, length_m, velocity, 0.0));
            if nearest(self.force_n(middle, length_m)) + friction < force_n {
                low = middle;
            } else {
                high = middle;
                status &= !NO_ANSWER;
            }
            middle = 0.5 * (low + high);
        }
        answer((high, status))
    }

    /// Contraction 1 − L/L0 at which the muscle pulls with `force_n` at a pressure. [`NO_ANSWER`] where no contraction of the box has this pull, and the
    /// lower end of the box of what is not a number.
    pub fn contraction(&self, force_n: Real, pressure_pa: Real) -> Answer {
        answer(self.contraction_and_status(force_n, pressure_pa))
    }

    /// By Newton's method between bounds.
    pub(crate) fn contraction_and_status(&self, force_n: Real, pressure_pa: Real) -> (Real, u32) {
        let (mut low, mut high) = (self.contraction_low(), self.contraction_high());
        let mut status = self.outside(pressure_pa, low) | if force_n >= 0.0 { 0 } else { NO_ANSWER };
        let force_n = if force_n < 0.0 { 0.0 } else { force_n };
        let (mut next, mut at) = (0.5 * (low + high), low);
        let (mut miss, mut slope) = (0.0, 0.0);
        for _ in 0..60 {
            at = next;
            let state = self.state(pressure_pa, at);
            miss = state.pull - force_n;
            slope = state.slope_in_contraction();
            if miss > 0.0 {
                low = at;
            } else {
                high = at;
            }
            next = at - miss / if slope < 0.0 { slope } else { -1.0 };
            if !(next > low && next < high) {
                next = 0.5 * (low + high);
            }
            if !(next - at > precision::STEP || at - next > precision::STEP) {
                break;
            }
        }
        // An end of the box, and more than a thousandth from the answer.
        if !(miss <= -1e-3 * slope && miss >= 1e-3 * slope) {
            status |= NO_ANSWER;
        }
        if self.beyond && slope < 0.0 {
            next = at - miss / slope;
        }
        (next, status)
    }

    /// What friction adds to the pull while the length changes by a velocity (positive: longer); smooth at rest over `smoothing_m_per_s`; 0 at a velocity that is not finite. With it the
    /// muscle pulls or is slack: it never pushes.
    pub fn friction_n(&self, pressure_pa: Real, length_m: Real, velocity_m_per_s: Real, smoothing_m_per_s: Real) -> Answer {
        let state = self.state_at(pressure_pa, length_m);
        let (pull, [_, q, ..]) = (state.pull, state.phi);
        let q = if q > 0.0 { q } else { 0.0 };
        let size = root(velocity_m_per_s * velocity_m_per_s + smoothing_m_per_s * smoothing_m_per_s);
        let [r0, r1, r2, q0, q1, q2, _] = self.friction;
        let e = within(self.contraction_of(length_m), self.contraction_low(), self.contraction_high());
        let half = (r0 + e * (r1 + e * r2)) * root(q) + (q0 + e * (q1 + e * q2)) * q;
        let half = if half > 0.0 { half } else { 0.0 };
        let share = if size > 0.0 && size.is_finite() { velocity_m_per_s / size } else { 0.0 };
        let moving = pull + half * share;
        let friction = (if moving > 0.0 { moving } else { 0.0 }) - if pull > 0.0 { pull } else { 0.0 };
        answer((friction, state.status))
    }
}
