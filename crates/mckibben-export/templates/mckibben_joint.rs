
/// The angle lies outside of the range of the joint, or is not a number.
pub const ANGLE_OUTSIDE: u32 = 16;
/// Pulls among which a stiffness is looked for.
const PULLS: u32 = 24;

/// The radius of a pulley (below zero: wound on the other side), or, where it is 0, a straight line: x and y of a point of the fixed link and of one of
/// the moving link, in m from the axis at the neutral angle.
pub type Path = [Real; 5];

/// A joint of one or two muscles. Angles are counterclockwise from the neutral angle. The torque is what muscles, spring and weight exert on the
/// surroundings together. Pressures of each function lie between 0 and the supply of each muscle, angles in `range_rad`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joint<const N: usize> {
    pub muscles: [&'static Muscle<'static>; N],
    /// Of the muscles, and of a spring on a rope.
    pub paths: [Path; 3],
    /// A spring on a rope pulls with rope0 + rope1 length, N and N/m, never below 0.
    pub rope: [Real; 2],
    /// A torsion spring turns with −(torsion0 + torsion1 angle), N m and N m/rad.
    pub torsion: [Real; 2],
    /// The weight turns with −weight0 cos(angle + weight1), N m and rad.
    pub weight: [Real; 2],
    pub range_rad: [Real; 2],
}

/// A path at an angle: length (of a pulley from that at the neutral angle), arm −d length/d angle, and the slope of the arm.
struct At {
    length: Real,
    arm: Real,
    slope: Real,
}

/// A muscle at an angle, with its pulls without pressure and at the supply.
struct Held {
    at: At,
    least: Real,
    most: Real,
}

/// A joint at an angle: torque that its muscles must give, and stiffness of spring and weight.
struct Place<const N: usize> {
    held: [Held; N],
    needed: Real,
    passive: Real,
}

/// Pressures at which the first muscle pulls with a given force and the second does the rest.
struct Pulled<const N: usize> {
    pressures: [Real; N],
    stiffness: Real,
    is_slack: bool,
}

/// What a search among the pulls of the first muscle found.
struct Found {
    best: Real,
    is_met: bool,
    reached: [Real; 2],
}

fn size_of(value: Real) -> Real {
    value.max(-value)
}

/// Sine and cosine (the core library has none): up to 100 rad they err by less than the distance of neighbouring numbers at 1. Beyond 8192 rad, to which
/// no joint turns, they are not numbers.
fn sine_and_cosine(angle: Real) -> (Real, Real) {
    if !(size_of(angle) <= 8192.0) {
        return (Real::NAN, Real::NAN);
    }
    let turns = angle * 0.6366197723675814;
    let whole = (turns + if turns < 0.0 { -0.5 } else { 0.5 }) as i32;
    let [first, second, third] = precision::RIGHT_ANGLE;
    let count = whole as Real;
    let x = angle - count * first - count * second - count * third;
    let z = x * x;
    let odd = [
        1.58969099521155010221e-10, -2.50507602534068634195e-8, 2.75573137070700676789e-6, -1.98412698298579493134e-4, 8.33333333332248946124e-3,
        -1.66666666666666324348e-1,
    ];
    let even = [
        -1.13596475577881948265e-11, 2.08757232129817482790e-9, -2.75573143513906633035e-7, 2.48015872894767294178e-5, -1.38888888888741095749e-3,
        4.16666666666666019037e-2,
    ];
    let sum = |terms: [Real; 6]| terms.iter().fold(0.0, |sum, term| sum * z + term);
    let sine = x + x * z * sum(odd);
    let most = 1.0 - 0.5 * z;
    let cosine = most + ((1.0 - most - 0.5 * z) + z * z * sum(even));
    match whole & 3 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

impl Held {
    /// The pull that it has of one that is wanted.
    fn pull(&self, wanted: Real) -> Real {
        wanted.max(self.least).min(self.most)
    }
}

fn path_at([radius, a0, a1, b0, b1]: Path, angle: Real) -> At {
    if radius != 0.0 {
        return At { length: -radius * angle, arm: radius, slope: 0.0 };
    }
    let (s, c) = sine_and_cosine(angle);
    let (x, y) = (c * b0 - s * b1, s * b0 + c * b1);
    let length = root((a0 - x) * (a0 - x) + (a1 - y) * (a1 - y));
    let arm = (a1 * x - a0 * y) / length;
    At { length, arm, slope: (arm * arm - a0 * x - a1 * y) / length }
}

impl<const N: usize> Joint<N> {
    /// The nearest angle of the range; its lower end of what is not a number.
    fn nearest_angle(&self, angle: Real) -> Real {
        let [low, high] = self.range_rad;
        angle.max(low).min(high)
    }

    /// Torque of spring and weight, and its −d/d angle.
    fn passive(&self, angle: Real) -> (Real, Real) {
        let angle = self.nearest_angle(angle);
        let ([weight, inclination], [torsion, rate]) = (self.weight, self.torsion);
        let (sine, cosine) = sine_and_cosine(angle + inclination);
        let mut torque = -weight * cosine - torsion - rate * angle;
        let mut stiffness = rate - weight * sine;
        let [rope, rope_rate] = self.rope;
        let [_, _, path] = self.paths;
        let at = path_at(path, angle);
        let force = rope + rope_rate * at.length;
        if force > 0.0 {
            torque += force * at.arm;
            stiffness += rope_rate * at.arm * at.arm - force * at.slope;
        }
        (torque, stiffness)
    }

    fn outside(&self, angle: Real) -> u32 {
        let [low, high] = self.range_rad;
        if angle >= low && angle <= high { 0 } else { ANGLE_OUTSIDE }
    }

    /// Each muscle with its pressure and its path.
    fn each(&self, pressures_pa: [Real; N], angle: Real) -> impl Iterator<Item = (&'static Muscle<'static>, Real, At)> {
        let angle = self.nearest_angle(angle);
        let muscles = IntoIterator::into_iter(self.muscles).zip(IntoIterator::into_iter(self.paths));
        muscles.zip(pressures_pa).map(move |((muscle, path), pressure)| (muscle, pressure, path_at(path, angle)))
    }

    /// 0, or a sum of [`ANGLE_OUTSIDE`] and of those of the muscles.
    pub fn status(&self, pressures_pa: [Real; N], angle_rad: Real) -> u32 {
        let muscles = self.each(pressures_pa, angle_rad);
        muscles.fold(self.outside(angle_rad), |all, (muscle, pressure, at)| all | muscle.status(pressure, at.length))
    }

    /// Torque at the pressure of each muscle.
    pub fn torque_nm(&self, pressures_pa: [Real; N], angle_rad: Real) -> Answer {
        let muscles = self.each(pressures_pa, angle_rad);
        let torque = muscles.fold(self.passive(angle_rad).0, |sum, (muscle, pressure, at)| {
            sum + nearest(muscle.force_n(pressure, at.length)) * at.arm
        });
        answer((torque, self.status(pressures_pa, angle_rad)))
    }

    /// −d torque/d angle at constant pressures.
    pub fn stiffness_nm_per_rad(&self, pressures_pa: [Real; N], angle_rad: Real) -> Answer {
        let muscles = self.each(pressures_pa, angle_rad);
        let stiffness = muscles.fold(self.passive(angle_rad).1, |sum, (muscle, pressure, at)| {
            let force = nearest(muscle.force_n(pressure, at.length));
            sum + (nearest(muscle.stiffness_n_per_m(pressure, at.length)) * at.arm * at.arm - force * at.slope)
        });
        answer((stiffness, self.status(pressures_pa, angle_rad)))
    }

    /// Slope of the torque in each pressure, N m/Pa.
    pub fn torque_per_pressure_m3(&self, pressures_pa: [Real; N], angle_rad: Real) -> Answer<[Real; N]> {
        let mut slopes = [0.0; N];
        for (slope, (muscle, pressure, at)) in slopes.iter_mut().zip(self.each(pressures_pa, angle_rad)) {
            *slope = at.arm * nearest(muscle.force_per_pressure_m2(pressure, at.length));
        }
        answer((slopes, self.status(pressures_pa, angle_rad)))
    }

    /// Least and largest torque at an angle, with pressures from 0 to the supply.
    pub fn limits_nm(&self, angle_rad: Real) -> [Real; 2] {
        let [mut low, mut high] = [self.passive(angle_rad).0; 2];
        for (muscle, none, at) in self.each([0.0; N], angle_rad) {
            let least = at.arm * nearest(muscle.force_n(none, at.length));
            let most = at.arm * nearest(muscle.force_n(muscle.supply_pa, at.length));
            let is_up = at.arm > 0.0;
            low += if is_up { least } else { most };
            high += if is_up { most } else { least };
        }
        [low, high]
    }

    /// What friction of the muscles adds to the torque while the joint turns; smooth at rest over `smoothing_rad_per_s`.
    pub fn friction_nm(&self, pressures_pa: [Real; N], angle_rad: Real, rate_rad_per_s: Real, smoothing_rad_per_s: Real) -> Answer {
        let muscles = self.each(pressures_pa, angle_rad);
        let torque = muscles.fold(0.0, |sum, (muscle, pressure, at)| {
            let friction = muscle.friction_n(pressure, at.length, -at.arm * rate_rad_per_s, at.arm * smoothing_rad_per_s);
            sum + at.arm * nearest(friction)
        });
        answer((torque, self.status(pressures_pa, angle_rad)))
    }

    fn place(&self, angle: Real, torque: Real) -> Place<N> {
        let (own, passive) = self.passive(angle);
        let mut paths = self.paths.iter();
        let held = self.muscles.map(|muscle| {
            let at = path_at(paths.next().copied().unwrap_or([0.0; 5]), self.nearest_angle(angle));
            let least = nearest(muscle.force_n(0.0, at.length));
            let most = nearest(muscle.force_n(muscle.supply_pa, at.length));
            Held { at, least, most }
        });
        // Of an angle that is not finite nothing is known.
        Place { held, needed: torque - own + (angle - angle), passive }
    }

    /// 0 of a muscle that need not pull (a millionth of its pull at the supply is rounding).
    fn pulled(&self, place: &Place<N>, first: Real) -> Pulled<N> {
        let rest = match place.held.as_slice() {
            [one, other] => (place.needed - first * one.at.arm) / other.at.arm,
            _ => 0.0,
        };
        let mut all = Pulled { pressures: [0.0; N], stiffness: place.passive, is_slack: false };
        let muscles = self.muscles.iter().zip(&place.held).zip([first, rest]);
        for (pressure, ((muscle, held), pull)) in all.pressures.iter_mut().zip(muscles) {
            let force = held.pull(pull);
            let at = &held.at;
            if pull > 1e-6 * held.most {
                *pressure = nearest(muscle.pressure_pa(pull, at.length));
            }
            let stiffness = nearest(muscle.stiffness_n_per_m(*pressure, at.length));
            all.stiffness += stiffness * at.arm * at.arm - force * at.slope;
            all.is_slack |= muscle.status(*pressure, at.length) & SLACK != 0;
        }
        all
    }

    /// The pulls of the first muscle at which the second can do the rest, and [`NO_ANSWER`] where there are none.
    fn pulls(&self, place: &Place<N>) -> ([Real; 2], u32) {
        let (first, [a, b]) = match place.held.as_slice() {
            [one] => (one, [place.needed / one.at.arm; 2]),
            [one, other] => (one, [other.least, other.most].map(|pull| (place.needed - pull * other.at.arm) / one.at.arm)),
            _ => return ([0.0; 2], NO_ANSWER),
        };
        let (low, high) = (a.min(b), a.max(b));
        let rounding = 1e-6 * first.most;
        let is_there = low <= first.most + rounding && high >= first.least - rounding;
        let low = first.pull(low);
        let high = high.max(low).min(first.most);
        ([low, high], if is_there { 0 } else { NO_ANSWER })
    }

    /// Where between two pulls the stiffness is the one that is sought, and the stiffness there.
    fn halved(&self, place: &Place<N>, [mut from, mut to]: [Real; 2], sought: Real, is_below: bool) -> (Real, Real) {
        let (mut middle, mut there) = (to, sought);
        for _ in 0..40 {
            middle = 0.5 * (from + to);
            there = self.pulled(place, middle).stiffness;
            if (there - sought < 0.0) == is_below {
                from = middle;
            } else {
                to = middle;
            }
        }
        (middle, there)
    }

    fn search(&self, place: &Place<N>, [low, high]: [Real; 2], sought: Real) -> Found {
        let enough = 1e-3 * size_of(sought);
        let stiffness = self.pulled(place, low).stiffness;
        let (mut best, mut closest, mut reached) = (low, size_of(stiffness - sought), [stiffness; 2]);
        let (mut is_met, mut is_any) = (closest <= enough, false);
        // Both muscles are taut at the ends.
        let taut = match place.held.as_slice() {
            [one, other] => 1e-5 * (one.most + other.most * size_of(other.at.arm / one.at.arm)),
            _ => 0.0,
        }
        .min(0.5 * (high - low));
        let mut before: Option<(Real, Real)> = None;
        for i in 0..=PULLS {
            let pull = low + taut + (high - low - 2.0 * taut) * i as Real / PULLS as Real;
            let here = self.pulled(place, pull);
            if here.is_slack {
                before = None;
                continue;
            }
            let [least, most] = reached;
            let stiffness = here.stiffness;
            reached = if is_any { [least.min(stiffness), most.max(stiffness)] } else { [stiffness; 2] };
            is_any = true;
            let miss = stiffness - sought;
            match before {
                Some((from, earlier)) if !is_met && (miss < 0.0) != (earlier < 0.0) => {
                    let (middle, there) = self.halved(place, [from, pull], sought, earlier < 0.0);
                    // Where it jumps, no side has it.
                    is_met = size_of(there - sought) <= enough;
                    best = if is_met { middle } else { best };
                }
                _ => {}
            }
            before = Some((pull, miss));
            if !is_met && size_of(miss) < closest {
                closest = size_of(miss);
                best = pull;
            }
        }
        let last = size_of(self.pulled(place, high).stiffness - sought);
        if !is_met && last < closest {
            closest = last;
            best = high;
        }
        Found { best, is_met: is_met || closest <= enough, reached }
    }

    /// Pressures, from 0 to the supply, for a torque and a stiffness at an angle: the lowest ones for the torque where no stiffness, or 0, is sought, and of
    /// those that give the stiffness the lowest. With one muscle the stiffness is ignored. Where nothing gives what is wanted, [`NO_ANSWER`] and pressures that
    /// come near it; of what is not a finite number they are 0.
    pub fn pressures_pa(&self, angle_rad: Real, torque_nm: Real, stiffness_nm_per_rad: Option<Real>) -> Answer<[Real; N]> {
        let place = self.place(angle_rad, torque_nm);
        let (pulls, missing) = self.pulls(&place);
        let status = self.outside(angle_rad) | missing;
        let sought = stiffness_nm_per_rad.filter(|sought| N > 1 && *sought != 0.0);
        if !(place.needed + sought.unwrap_or(0.0)).is_finite() {
            return answer(([0.0; N], status | NO_ANSWER));
        }
        match sought {
            Some(sought) if status & NO_ANSWER == 0 => {
                let found = self.search(&place, pulls, sought);
                let status = status | if found.is_met { 0 } else { NO_ANSWER };
                answer((self.pulled(&place, found.best).pressures, status))
            }
            _ => answer((self.pulled(&place, pulls[0]).pressures, status)),
        }
    }

    /// Least and largest stiffness with a torque while both muscles pull; with one of them slack there may be one more value below, with nothing between.
    pub fn reached_nm_per_rad(&self, angle_rad: Real, torque_nm: Real) -> Answer<[Real; 2]> {
        let place = self.place(angle_rad, torque_nm);
        let (pulls, missing) = self.pulls(&place);
        let status = self.outside(angle_rad) | missing;
        if !place.needed.is_finite() {
            return answer(([0.0; 2], status | NO_ANSWER));
        }
        if N < 2 || status & NO_ANSWER != 0 {
            return answer(([self.pulled(&place, pulls[0]).stiffness; 2], status));
        }
        answer((self.search(&place, pulls, 0.0).reached, status))
    }
}
