//! To JSON and back.

use super::{Deficit, Form, HIGHEST, UniversalRange, UniversalTerm};
use super::{UniversalErrors, UniversalFormula, UniversalSummary};
use crate::formula::FormulaError;
use crate::formula::node::Node;
use crate::formula::read::{FORMAT, name, provenance, value};
use crate::formula::write;
use serde_json::{Map, Value, json};

type Read<T> = Result<T, FormulaError>;

impl UniversalFormula {
    /// Reads a text.
    ///
    /// # Errors
    /// [`FormulaError`] names the key.
    pub fn parse(text: &str) -> Read<Self> {
        let value = value(text)?;
        let root = Node::root(&value);
        let kind = root.get("kind")?;
        match kind.text()? {
            "universal" => Self::of(&root),
            other => Err(kind.unknown(other, "universal")),
        }
    }

    pub(in crate::formula) fn of(root: &Node<'_>) -> Read<Self> {
        let word = root.get("form")?;
        let known = || Form::ALL.map(Form::name).join(", ");
        let text = word.text()?;
        let form = Form::ALL.into_iter().find(|f| f.name() == text);
        let form = form.ok_or_else(|| word.unknown(text, known()))?;
        let errors = root.get("errors")?;
        let formula = Self {
            name: name(root)?,
            deficit: Deficit { form, terms: vec![] },
            range: range(&root.get("range")?)?,
            errors: UniversalErrors {
                against: errors.get("against")?.text()?.to_owned(),
                fit: summary(&errors.get("fit")?)?,
                left_out: summary(&errors.get("left_out")?)?,
            },
            provenance: provenance(&root.get("provenance")?)?,
        };
        let terms = terms(&formula, &root.get("terms")?)?;
        Ok(Self { deficit: Deficit { form, terms }, ..formula })
    }

    /// The formula as its file holds it, with a newline at the end. Reading it back gives the same formula to the bit.
    pub fn to_json(&self) -> String {
        format!("{:#}\n", self.to_value())
    }

    /// The formula as a JSON value.
    pub fn to_value(&self) -> Value {
        let words = self.deficit.form.variables();
        let term = |t: &UniversalTerm| {
            let powers = words.iter().zip(t.powers).filter(|p| p.1 > 0);
            let powers: Map<String, Value> = powers.map(|(key, n)| ((*key).to_owned(), json!(n))).collect();
            json!({ "name": self.term_name(t), "powers": powers, "unit": "1", "value": t.value })
        };
        let r = &self.range;
        let pair =
            |(low, high): (f64, f64)| json!([low, if high.is_finite() { json!(high) } else { Value::Null }]);
        json!({
            "format": FORMAT,
            "name": self.name,
            "kind": "universal",
            "equation": self.equation(),
            "form": self.deficit.form.name(),
            "terms": self.deficit.terms.iter().map(term).collect::<Vec<_>>(),
            "range": {
                "wall_ratio": pair(r.wall_ratio),
                "length_ratio": pair(r.length_ratio),
                "angle_deg": pair(r.angle_deg),
                "pressure_per_modulus": pair(r.pressure_per_modulus),
                "strand_strain": r.strand_strain,
                "contraction_of_ideal": pair(r.contraction_of_ideal),
            },
            "errors": {
                "against": self.errors.against,
                "fit": written(&self.errors.fit),
                "left_out": written(&self.errors.left_out),
            },
            "provenance": write::provenance(&self.provenance),
        })
    }
}

fn terms(formula: &UniversalFormula, list: &Node<'_>) -> Read<Vec<UniversalTerm>> {
    let words = formula.deficit.form.variables();
    let mut out: Vec<UniversalTerm> = vec![];
    for node in list.list()? {
        let mut term = UniversalTerm { powers: [0; 5], value: node.get("value")?.number()? };
        let powers = node.get("powers")?;
        for (key, power) in powers.entries()? {
            let i = words.iter().position(|k| *k == key);
            let i = i.ok_or_else(|| powers.unknown(key, words.join(", ")))?;
            let n = power.count().ok().and_then(|n| u8::try_from(n).ok()).filter(|n| *n <= HIGHEST);
            term.powers[i] = n.ok_or_else(|| power.wrong(format!("a whole number from 0 to {HIGHEST}")))?;
        }
        if out.iter().any(|t| t.powers == term.powers) {
            return Err(list.twice(formula.term_name(&term)));
        }
        out.push(term);
    }
    Ok(out)
}

fn range(node: &Node<'_>) -> Read<UniversalRange> {
    let of = |key| node.get(key)?.interval();
    let length = node.get("length_ratio")?;
    let length_ratio = match length.list()?.as_slice() {
        [low, high] if high.is_null() => (low.positive()?, f64::INFINITY),
        _ => length.interval()?,
    };
    Ok(UniversalRange {
        wall_ratio: of("wall_ratio")?,
        length_ratio,
        angle_deg: of("angle_deg")?,
        pressure_per_modulus: of("pressure_per_modulus")?,
        strand_strain: node.get("strand_strain")?.positive()?,
        contraction_of_ideal: of("contraction_of_ideal")?,
    })
}

fn summary(node: &Node<'_>) -> Read<UniversalSummary> {
    let of = |key| node.get(key)?.share();
    let count = |key| Read::Ok(usize::try_from(node.get(key)?.count()?).unwrap_or(usize::MAX));
    Ok(UniversalSummary {
        points: count("points")?,
        muscles: count("muscles")?,
        rms: of("rms_of_blocked")?,
        p95: of("p95_of_blocked")?,
        p99: of("p99_of_blocked")?,
        max: of("max_of_blocked")?,
    })
}

fn written(s: &UniversalSummary) -> Value {
    json!({
        "points": s.points,
        "muscles": s.muscles,
        "rms_of_blocked": s.rms,
        "p95_of_blocked": s.p95,
        "p99_of_blocked": s.p99,
        "max_of_blocked": s.max,
    })
}
