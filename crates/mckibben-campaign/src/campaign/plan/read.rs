//! Text → plan.

use super::{
    Plan, Testing,
    axis::{Axis, PlanRubber, RUBBER},
    keys::{OfSampling, OfTest, PlanKeys},
    sampling::{Design, MOST_MUSCLES, Sampling, SamplingMethod},
    table::{self, OwnSamples},
    vary,
};
use mckibben_core::{
    extremes::peak,
    muscle::{
        Rubber,
        file::{FileError, MuscleFile, Source},
    },
    rubber::library,
    units::typed::{Choice, Quantity},
};
use mckibben_fem::elements::Elements;

/// A higher pressure has its unit, lest bars were meant.
const HIGHEST_BARE_MPA: f64 = 2.0;
/// Muscles of a plan whose reach is looked at.
const REACHES: u64 = 10_000;
/// The most points of one muscle.
const MOST_POINTS: usize = 100_000;

impl Plan {
    /// Reads the text of a plan.
    pub fn parse(text: &str) -> Result<Self, FileError> {
        Self::parse_with(text, None)
    }

    fn parse_with(text: &str, table: Option<&str>) -> Result<Self, FileError> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let source = Source::parse(text)?;
        if source.text_at("sampling.method") == Some("latin-hypercube") {
            return Err(source.error(
                "sampling.method",
                "is gone: take \"sobol\", which more samples extend",
            ));
        }
        let keys: PlanKeys = source.read()?;
        let stated = source.part::<MuscleFile>(keys.muscle)?.stated(&source)?;
        let mut sampling = sampling(&keys.sampling, &source)?;
        let mut axes = keys.vary.axes(&source)?;
        let mut values = vec![];
        if let Some(table) = table {
            let own = own_samples(table, &source)?;
            (axes, values) = (own.axes, own.values);
            (sampling.method, sampling.samples) = (SamplingMethod::Table, own.muscles);
        }
        let rubber = stated.rubber.clone().unwrap_or_else(Rubber::paper);
        vary::check_all(&axes, &source, &rubber.law, sampling.method)?;
        let testing = testing(keys.test, &source)?;
        if rubber.is_conditioned() {
            return Err(source.error(
                "tube.material.conditioned",
                "is not possible in a campaign, whose muscles are on their first inflation: \
                leave it out",
            ));
        }
        let method = sampling.method;
        if method != SamplingMethod::Factorial && axes.is_empty() {
            return Err(source.error(
                "sampling.method",
                format!("a {method} plan needs something to vary: add [vary]"),
            ));
        }
        let design = Design::new(sampling, &axes, values);
        if design.muscles > MOST_MUSCLES {
            return Err(source.error(
                "vary",
                format!("makes {} muscles, more than {MOST_MUSCLES}", design.muscles),
            ));
        }
        let mut plan = Plan {
            rubbers: rubbers(rubber, &axes).map_err(|why| source.error("vary.tube.rubber", why))?,
            text: text_with(text, table),
            stated,
            axes,
            design,
            testing,
        };
        plan.take_laws()
            .map_err(|why| source.error("tube.rubber", why))?;
        some_muscle(&plan, &source)?;
        Ok(plan)
    }

    /// All mistakes of a text, or the plan; with a table of muscles, these stand in place of
    /// `[sampling]` and `[vary]`. Where a value is wrong, the rest is judged without it.
    ///
    /// # Errors
    /// Every [`FileError`] that does not follow from another one.
    pub fn check(text: &str, samples: Option<&str>) -> Result<Self, Vec<FileError>> {
        let mut left = text.to_owned();
        let mut mistakes: Vec<FileError> = vec![];
        loop {
            let error = match Self::parse_with(&left, samples) {
                Ok(plan) if mistakes.is_empty() => return Ok(plan),
                Ok(_) => return Err(mistakes),
                Err(error) => error,
            };
            let key = error.key.clone().unwrap_or_default();
            let rest = Source::parse(&left).ok().and_then(|s| s.without(&key));
            if !mistakes.iter().any(|known| follows(&error, known)) {
                mistakes.push(error);
            }
            match rest {
                Some(rest) => left = rest,
                None => return Err(mistakes),
            }
        }
    }

    /// One law for all muscles of a named rubber whose law follows the muscle: that for the largest
    /// reach among them, of larger plans among [`REACHES`] of them.
    fn take_laws(&mut self) -> Result<(), String> {
        let follows = |of_plan: &PlanRubber| library::follows(&of_plan.rubber);
        if self.rubbers.iter().any(follows) {
            let reach = peak(self.spread(REACHES).map(|muscle| muscle.reach()));
            for of_plan in &mut self.rubbers {
                let name = of_plan.rubber.name.clone();
                let Some(name) = name.filter(|_| library::follows(&of_plan.rubber)) else {
                    continue;
                };
                *of_plan = PlanRubber::of(
                    library::find_for(&name, reach).map_err(|error| error.to_string())?,
                );
            }
        }
        Ok(())
    }
}

impl PlanRubber {
    /// With stated constants, which a muscle of the plan leaves as they are.
    fn of(rubber: Rubber) -> Self {
        Self {
            data_to_stretch: rubber.fitted_to_stretch,
            rubber: Rubber {
                fitted_to_stretch: None,
                ..rubber
            },
        }
    }
}

/// The rubbers of the muscles: those of an axis, or the stated one alone.
fn rubbers(stated: Rubber, axes: &[Axis]) -> Result<Vec<PlanRubber>, String> {
    // As the library has it, so that its law may follow the muscles.
    let as_found = |rubber: Rubber| PlanRubber {
        data_to_stretch: rubber.fitted_to_stretch,
        rubber,
    };
    let named = |name: &String| match library::find(name) {
        Ok(rubber) => Ok(as_found(rubber)),
        Err(error) => Err(error.to_string()),
    };
    match axes.iter().find(|axis| axis.key == RUBBER) {
        None => Ok(vec![as_found(stated)]),
        Some(axis) => axis.names.iter().map(named).collect(),
    }
}

/// The muscles of a table; what varies is stated there alone.
fn own_samples(table: &str, source: &Source<'_>) -> Result<OwnSamples, FileError> {
    for key in ["vary", "sampling"] {
        if source.has(key) {
            return Err(source.error(
                key,
                "is stated, and `samples` gives the muscles: leave one of them out",
            ));
        }
    }
    table::read(table).map_err(|error| FileError {
        key: Some("samples".into()),
        problem: error.to_string(),
        ..FileError::default()
    })
}

/// The text of a plan with a mark of the table that its muscles are in, so that another table is
/// another plan.
fn text_with(text: &str, table: Option<&str>) -> String {
    let Some(table) = table else {
        return text.to_owned();
    };
    let hash = mckibben_core::hash::hex(table);
    format!(
        "{}\n# its muscles are a table with sha256 {hash}\n",
        text.trim_end()
    )
}

/// Whether a mistake is that a wrong value, which was taken out, is missing now.
fn follows(error: &FileError, known: &FileError) -> bool {
    let wrong = known.key.as_deref().unwrap_or_default();
    let table = wrong.split('.').next().unwrap_or_default();
    let name = wrong.rsplit('.').next().unwrap_or_default();
    let problem = &error.problem;
    error.key.as_deref() == Some(wrong)
        || problem.contains(name)
        || problem.contains(&format!("[{table}]"))
}

/// A plan none of whose first thousand muscles is one is a slip, not a campaign.
fn some_muscle(plan: &Plan, source: &Source<'_>) -> Result<(), FileError> {
    let mut muscles = (0..plan.muscles().min(1000)).map(|number| plan.inputs(number).muscle());
    match muscles.next() {
        Some(Err(first)) if plan.axes.is_empty() => Err(source.refused(&first)),
        Some(Err(first)) if !muscles.any(|muscle| muscle.is_ok()) => {
            Err(source.error("vary", format!("makes no muscle; the first: {first}")))
        }
        _ => Ok(()),
    }
}

fn sampling(keys: &OfSampling, source: &Source<'_>) -> Result<Sampling, FileError> {
    const SAMPLES: &str = "sampling.samples";
    const SEED: &str = "sampling.seed";
    for (key, value, most) in [
        (SAMPLES, keys.samples, MOST_MUSCLES),
        (SEED, keys.seed, u64::from(u32::MAX)),
    ] {
        if value.is_some_and(|value| value > most) {
            return Err(source.error(key, format!("must be a whole number up to {most}")));
        }
        if value.is_some() && keys.method == SamplingMethod::Factorial {
            return Err(source.error(
                key,
                "a factorial plan takes every level with every other: it has neither \
                samples nor a seed",
            ));
        }
    }
    if keys.method == SamplingMethod::Factorial {
        return Ok(Sampling::default());
    }
    let needs = "it is the number of random muscles";
    let samples = keys
        .samples
        .ok_or_else(|| source.missing(SAMPLES, "sampling.method", needs))?;
    if samples == 0 {
        return Err(source.error(SAMPLES, "must be above zero"));
    }
    Ok(Sampling {
        method: keys.method,
        samples,
        seed: Some(keys.seed.unwrap_or(1) as u32),
    })
}

fn testing(keys: OfTest, source: &Source<'_>) -> Result<Testing, FileError> {
    const CONTRACTIONS: &str = "test.contractions";
    const PRESSURES: &str = "test.pressures";
    let contractions = levels(keys.contractions, CONTRACTIONS, source)?;
    let pressures_mpa = levels(keys.pressures, PRESSURES, source)?;
    let most = if keys.of_ideal { 1.2 } else { 0.9 };
    if let Some(e) = contractions.iter().find(|e| !(0.0..=most).contains(*e)) {
        return Err(source.error(
            CONTRACTIONS,
            format!("contains {e}; contractions must lie between 0 and {most}"),
        ));
    }
    if let Some(p) = pressures_mpa.iter().find(|p| **p < 0.0) {
        return Err(source.error(
            PRESSURES,
            format!("contains {p}\u{a0}MPa; a pressure must not be below zero"),
        ));
    }
    let top = peak(pressures_mpa.iter().copied());
    let text = source.text_at(PRESSURES).unwrap_or_default();
    if top > HIGHEST_BARE_MPA && !text.contains(char::is_alphabetic) {
        let bar = 10.0 * top;
        let why =
            format!("reaches {top} MPa = {bar} bar without a unit: write MPa or bar behind it");
        return Err(source.error(PRESSURES, why));
    }
    let points = contractions.len().saturating_mul(pressures_mpa.len());
    if points > MOST_POINTS {
        let why =
            format!("make {points} points a muscle with the contractions, more than {MOST_POINTS}");
        return Err(source.error(PRESSURES, why));
    }
    let elements = elements(keys.model, keys.mesh, source)?;
    if keys.sensitivities && matches!(elements, Elements::ThreeDimensional(_)) {
        return Err(source.error(
            "test.sensitivities",
            "is true, and fe3d has none: take model = \"fe\", or leave it out",
        ));
    }
    Ok(Testing {
        contractions,
        of_ideal: keys.of_ideal,
        pressures_mpa,
        elements,
        sensitivities: keys.sensitivities,
    })
}

fn levels<Q: Quantity>(
    values: Choice<Q>,
    key: &str,
    source: &Source<'_>,
) -> Result<Vec<f64>, FileError> {
    match values {
        Choice::One(one) => Ok(vec![one.into()]),
        Choice::Several(list) if !list.is_empty() => {
            let list: Vec<f64> = list.into_iter().map(Into::into).collect();
            vary::distinct(&list).map_err(|why| source.error(key, why))?;
            Ok(list)
        }
        Choice::Several(_) => Err(source.error(key, "is an empty list")),
        Choice::Between { .. } => {
            Err(source.error(key, "is a range without a step: write low..high:step"))
        }
    }
}

fn elements(
    model: Option<String>,
    mesh: Option<String>,
    source: &Source<'_>,
) -> Result<Elements, FileError> {
    let word = model.as_deref().unwrap_or(Elements::ENTRIES[0].name);
    let unknown = |_| {
        source.error(
            "test.model",
            "is not known; expected a finite-element model: fe or fe3d",
        )
    };
    let elements: Elements = word.parse().map_err(unknown)?;
    let Some(mesh) = mesh else {
        return Ok(elements);
    };
    elements
        .with_mesh(&mesh)
        .map_err(|error| source.error("test.mesh", error.to_string()))
}
