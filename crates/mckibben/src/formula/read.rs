//! From JSON.

use super::Coefficients;
use super::error::{FormulaError, Problem};
use super::node::Node;
use super::universal::UniversalFormula;
use super::{
    Body, Document, ErrorSummary, Formula, FormulaErrors, FormulaRange, GlobalTerms, HeldOut, Made,
    MadeBraid, Provenance, RegionErrors, Scales, Term,
};

/// The word under `format`.
pub(super) const FORMAT: &str = "mckibben formula 1";
/// Keys of a term's powers, in the order of [`Term::powers`].
pub(super) const POWERS: [&str; 4] = ["wall_ratio", "pressure", "contraction", "outer_diameter"];
/// No power may be higher.
const HIGHEST: u64 = 20;

type Read<T> = Result<T, FormulaError>;

/// The value of a text that says it is a formula.
pub(super) fn value(text: &str) -> Read<serde_json::Value> {
    let value: serde_json::Value = serde_json::from_str(text).map_err(|e| Problem::Json(e.to_string()))?;
    let format = Node::root(&value).get("format")?;
    if format.text()? != FORMAT {
        return Err(format.wrong(format!("\"{FORMAT}\"")));
    }
    Ok(value)
}

/// A name that is not empty.
pub(super) fn name(root: &Node<'_>) -> Read<String> {
    let name = root.get("name")?;
    if name.text()?.trim().is_empty() {
        return Err(name.wrong("a name"));
    }
    Ok(name.text()?.to_owned())
}

impl Document {
    /// Reads a text.
    ///
    /// # Errors
    /// [`FormulaError`] names the key.
    pub fn parse(text: &str) -> Read<Self> {
        let value = value(text)?;
        let root = Node::root(&value);
        let kind = root.get("kind")?;
        match kind.text()? {
            "universal" => UniversalFormula::of(&root).map(Self::Universal),
            "paper" | "global" => Formula::of(&root).map(Self::Section),
            other => Err(kind.unknown(other, "paper, global, universal")),
        }
    }
}

impl Formula {
    /// Reads a text.
    ///
    /// # Errors
    /// [`FormulaError`] names the key.
    pub fn parse(text: &str) -> Read<Self> {
        Self::of(&Node::root(&value(text)?))
    }

    fn of(root: &Node<'_>) -> Read<Self> {
        let (kind, terms) = (root.get("kind")?, root.get("terms")?);
        let body = match kind.text()? {
            "paper" => Body::Paper(Box::new(paper(&terms)?)),
            "global" => {
                Body::Global(GlobalTerms { scales: scales(&root.get("scales")?)?, terms: global(&terms)? })
            }
            other => return Err(kind.unknown(other, "paper, global")),
        };
        Ok(Self {
            name: name(root)?,
            body,
            made_for: made(&root.get("made_for")?)?,
            range: range(&root.get("range")?)?,
            errors: errors(&root.get("errors")?)?,
            provenance: provenance(&root.get("provenance")?)?,
        })
    }
}

fn paper(terms: &Node<'_>) -> Read<Coefficients> {
    let mut found = [[[None; 3]; 6]; 3];
    for term in terms.list()? {
        let name = term.get("name")?;
        let (f, k, j) = place(name.text()?).ok_or_else(|| {
            name.text().map_or_else(|e| e, |text| name.unknown(text, "A11 … A63, B11 … B63, C11 … C62"))
        })?;
        if found[f][k][j].replace(term.get("value")?.number()?).is_some() {
            return Err(terms.twice(name.text()?.to_owned()));
        }
    }
    let mut x = [[[0.0; 3]; 6]; 3];
    for (f, letter) in ["A", "B", "C"].into_iter().enumerate() {
        for k in 0..6 {
            for j in 0..3 {
                let number = if f == 2 { j } else { j + 1 };
                let optional = f == 2 && j == 0;
                let missing = || Problem::Missing { key: format!("terms: {letter}{}{number}", k + 1) };
                x[f][k][j] = match found[f][k][j] {
                    None if optional => 0.0,
                    found => found.ok_or_else(missing)?,
                };
            }
        }
    }
    let [a, b, c] = x;
    Ok(Coefficients { a, b, c })
}

/// `A11` → family, k, column.
fn place(name: &str) -> Option<(usize, usize, usize)> {
    let letters: Vec<char> = name.chars().collect();
    let [letter, k, number] = letters.as_slice() else { return None };
    let family = ['A', 'B', 'C'].iter().position(|l| l == letter)?;
    let (k, number) = (k.to_digit(10)? as usize, number.to_digit(10)? as usize);
    let column = if family == 2 { number } else { number.checked_sub(1)? };
    ((1..=6).contains(&k) && column < 3).then(|| (family, k - 1, column))
}

fn scales(node: &Node<'_>) -> Read<Scales> {
    let of = |key| node.get(key)?.positive();
    Ok(Scales {
        wall_ratio: of("wall_ratio")?,
        pressure_mpa: of("pressure_mpa")?,
        contraction: of("contraction")?,
        outer_diameter_mm: of("outer_diameter_mm")?,
    })
}

fn global(terms: &Node<'_>) -> Read<Vec<Term>> {
    let mut out: Vec<Term> = vec![];
    for node in terms.list()? {
        let mut term = Term { powers: [0; 4], value: node.get("value")?.number()? };
        let powers = node.get("powers")?;
        for (key, power) in powers.entries()? {
            let i = POWERS.iter().position(|k| *k == key);
            let i = i.ok_or_else(|| powers.unknown(key, POWERS.join(", ")))?;
            let n = power.count().ok().filter(|n| *n <= HIGHEST);
            let n = n.ok_or_else(|| power.wrong(format!("a whole number from 0 to {HIGHEST}")))?;
            term.powers[i] = u8::try_from(n).unwrap_or(0);
        }
        if out.iter().any(|t| t.powers == term.powers) {
            return Err(terms.twice(term.name()));
        }
        out.push(term);
    }
    if out.is_empty() { Err(terms.wrong("a list of at least one term")) } else { Ok(out) }
}

fn made(node: &Node<'_>) -> Read<Made> {
    let (rubber, braid) = (node.get("rubber")?, node.get("braid")?);
    let constants = rubber.get("constants")?.entries()?;
    let constants = constants.into_iter().map(|(k, v)| Ok((k.to_owned(), v.number()?)));
    let text = |n: Option<Node<'_>>| n.map(|n| n.text().map(str::to_owned)).transpose();
    let word = braid.maybe("stiffness")?;
    let braid = match (&word, braid.maybe("stiffness_n_per_mm")?, braid.maybe("stiffness_times_diameter_n")?)
    {
        (Some(word), ..) => match word.text()? {
            "paper" => MadeBraid::Paper,
            "inextensible" => MadeBraid::Inextensible,
            other => return Err(word.unknown(other, "paper, inextensible")),
        },
        (None, Some(k), _) => MadeBraid::Stiffness(k.positive()?),
        (None, None, Some(k)) => MadeBraid::TimesDiameter(k.positive()?),
        (None, None, None) => return Err(Problem::Missing { key: "made_for.braid.stiffness".into() }.into()),
    };
    Ok(Made {
        length_mm: node.get("length_mm")?.positive()?,
        angle_deg: node.get("angle_deg")?.positive()?,
        rubber: text(rubber.maybe("name")?)?,
        law: rubber.get("law")?.text()?.to_owned(),
        constants: constants.collect::<Read<_>>()?,
        bulk_modulus_mpa: rubber.maybe("bulk_modulus_mpa")?.map(|n| n.positive()).transpose()?,
        braid,
    })
}

fn range(node: &Node<'_>) -> Read<FormulaRange> {
    let of = |key| node.get(key)?.interval();
    Ok(FormulaRange {
        outer_diameter_mm: of("outer_diameter_mm")?,
        wall_mm: of("wall_mm")?,
        pressure_mpa: of("pressure_mpa")?,
        contraction: of("contraction")?,
    })
}

fn summary(node: &Node<'_>) -> Read<ErrorSummary> {
    let of = |key| node.get(key)?.share();
    Ok(ErrorSummary {
        points: usize::try_from(node.get("points")?.count()?).unwrap_or(usize::MAX),
        rms: of("rms_of_blocked")?,
        p95: of("p95_of_blocked")?,
        max: of("max_of_blocked")?,
        max_n: of("max_n")?,
        max_12: of("max_of_isobar")?,
    })
}

fn errors(node: &Node<'_>) -> Read<FormulaErrors> {
    let region = |n: Node<'_>| {
        let quantity = n.get("quantity")?.text()?.to_owned();
        Read::Ok(RegionErrors { quantity, value: n.get("value")?.number()?, errors: summary(&n)? })
    };
    let held_out = |n: Node<'_>| {
        let list = n.get("outer_diameters_mm")?.list()?;
        let outer_diameters_mm = list.iter().map(Node::number).collect::<Read<_>>()?;
        Read::Ok(HeldOut { outer_diameters_mm, errors: summary(&n)? })
    };
    Ok(FormulaErrors {
        against: node.get("against")?.text()?.to_owned(),
        fit: summary(&node.get("fit")?)?,
        regions: node.get("regions")?.list()?.into_iter().map(region).collect::<Read<_>>()?,
        held_out: node.maybe("held_out")?.map(held_out).transpose()?,
    })
}

pub(super) fn provenance(node: &Node<'_>) -> Read<Provenance> {
    let text = |key| Ok::<_, FormulaError>(node.get(key)?.text()?.to_owned());
    let maybe = |key| node.maybe(key)?.map(|n| n.text().map(str::to_owned)).transpose();
    Ok(Provenance {
        version: text("version")?,
        method: text("method")?,
        points: usize::try_from(node.get("points")?.count()?).unwrap_or(usize::MAX),
        data_hash: text("data_hash")?,
        table: maybe("table")?,
        plan_hash: maybe("plan_hash")?,
        seed: node.maybe("seed")?.map(|n| n.count()).transpose()?,
    })
}
