//! The first page of the folder: the job, the verdict, what to heed, the order of work.

use crate::{
    Plan,
    safety::PullAt,
    text::{percent, significant},
};
use mckibben_core::{
    analysis::{PROOF_TO_WORKING, STRETCH},
    clean, joined,
    units::rounded,
};
use mckibben_io::files::File;

impl Plan {
    /// What the muscle is for and what it does, in sentences.
    pub(crate) fn verdict(&self) -> Vec<String> {
        let (operating, shown) = (&self.operating, &self.shown);
        let at_rest = format!(
            "By the model alone ({}, {}) it is blocked at {} at {}, and contracts by {} ({}) \
             without load.",
            operating.model,
            operating.branch.motion(),
            shown.force(operating.blocked_force_n),
            shown.pressure(operating.pressure_mpa),
            percent(operating.free_contraction),
            shown.length((operating.free_contraction * self.muscle.length_mm()).round())
        );
        let pull = |at: &PullAt| {
            let place = format!(
                "{} and {}",
                shown.pressure(at.pressure_mpa),
                percent(at.contraction)
            );
            let job = self.muscle.pressure_to_set_mpa();
            let other = job.filter(|mpa| *mpa != at.pressure_mpa);
            let other = other.map_or_else(String::new, |mpa| {
                format!(", by its job at {}", shown.pressure(mpa))
            });
            let required = at
                .required_n
                .map(|n| format!("; {} is required{other}", shown.force(n)));
            let [low, median, high] = at.range_n().map(|n| shown.force(n));
            let built = at.built.map_or(median.clone(), |built| {
                let way = built.way();
                format!("{median} ({low} to {high}, 95 %, as built){way}")
            });
            format!(
                "At {place} it pulls {built}{}.",
                required.unwrap_or_default()
            )
        };
        let count = self.count();
        let required_n = operating.pulls.first().and_then(|at| at.required_n);
        let together = match (self.of_joint(), required_n) {
            (Some((radius_mm, contraction)), _) => format!(
                "on both sides of a pulley with a radius of {}, mounted with the inner faces of the \
                 heads {} apart at the neutral angle",
                shown.length(radius_mm),
                shown.length(self.faces_mm(contraction))
            ),
            (None, Some(n)) => {
                format!(
                    "side by side, which pull {}",
                    shown.force(f64::from(count) * n)
                )
            }
            _ => "side by side".to_owned(),
        };
        let count = (count > 1).then(|| {
            format!(
                "It is one of {count} equal muscles {together}: build {count}; all numbers are those \
                 of one."
            )
        });
        let pulls = operating.pulls.iter().map(pull);
        pulls.chain([at_rest]).chain(count).collect()
    }

    /// The energy that it stores, in sentences.
    pub fn energy(&self) -> String {
        let count = self.count();
        let joules = |j: f64| format!("{} J", significant(f64::from(count) * j, 2));
        let all = match count {
            1 => String::new(),
            count => format!(" of all {count}"),
        };
        let air = joules(self.operating.air_energy_j());
        let wall = joules(self.safety.wall_energy_j);
        let stored = if self.liquid {
            format!(
                "Rubber and strands{all} store up to {wall} at the working pressure, and the liquid hardly \
                 any. With air in it, it would store {air} more: bleed it."
            )
        } else {
            format!(
                "At the working pressure the air{all} stores up to {air}, rubber and strands up to {wall}."
            )
        };
        stored
            + " An end that slips flies off with it: keep everyone out of the line of the muscle."
    }

    /// What people must heed.
    pub(crate) fn stops(&self) -> Vec<String> {
        let (safety, shown) = (&self.safety, &self.shown);
        let highest_mpa = self.operating.highest_mpa;
        let times = safety.proof_pressure_mpa / highest_mpa;
        let least = match times < PROOF_TO_WORKING {
            true => ", as far as burst pressure and strands allow",
            false => "",
        };
        let order = format!(
            "First the proof test with water, {} ({} times {}, the highest that is set{least}), \
             stretched by {}; never with air. In use never above {}.",
            shown.pressure(safety.proof_pressure_mpa),
            significant(times, 3),
            shown.pressure(highest_mpa),
            percent(STRETCH),
            shown.pressure(self.highest_mpa())
        );
        let limits = &self.operating.limits;
        let raised = limits.allowed_pressure_mpa.filter(|_| limits.overpressure);
        let raised = raised.map(|mpa| {
            format!(
                "Overpressure: the allowed pressure was raised to {}. The muscle keeps no usual \
                 distance from its burst.",
                shown.pressure(rounded(mpa, 3, f64::floor))
            )
        });
        let unknown = limits.burst_pressure_mpa.is_none().then(|| {
            "The burst pressure is NOT KNOWN, because number or strength of the strands are not \
             stated: keep away from the muscle whenever it is under pressure."
                .to_owned()
        });
        let warnings = self.warnings();
        let warnings = warnings.into_iter().map(|text| format!("Warning: {text}."));
        unknown
            .into_iter()
            .chain(raised)
            .chain(warnings)
            .chain([self.energy(), order])
            .collect()
    }
}

/// The page in Markdown, with links to the other files.
pub fn markdown(plan: &Plan, files: &[File]) -> String {
    let plain = |text: String| clean::markdown(&text);
    let title = plain(plan.title());
    let verdict = plain(plan.verdict().join(" "));
    let stops = plan.stops().into_iter();
    let stops = joined(stops.map(|text| format!("> - {}", plain(text))), "\n");
    let link = |file: &File| format!("[{0}]({0}): {1}", file.name, file.about);
    let files = joined(files.iter().map(link), "; ");
    format!(
        "# {title}\n\n{verdict}\n\n> **STOP**\n{stops}\n\n{files}.\n\n\
         Then `mckibben identify muscle.toml --data test.csv -o found.toml` writes the muscle as built.\n"
    )
}
