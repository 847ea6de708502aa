//! The keys of files, as `data/keys.txt` lists them: from one list follow the reader, the writer
//! and the JSON Schemas.

use crate::muscle::Measure;
use crate::muscle::measures::of_section;
use crate::rubber::{Constant, Law, LawKind};
use crate::units::Dimension;
use std::borrow::Cow;

const LIST: &str = include_str!("../../../data/keys.txt");

/// A key of a table.
#[derive(Debug, Clone)]
pub struct Key {
    /// Its name.
    pub name: &'static str,
    /// Its kind, as the head of the list describes it.
    pub kind: Cow<'static, str>,
    /// What it is.
    pub about: &'static str,
    /// Whether its table needs it.
    pub is_needed: bool,
    /// The measure of the muscle that it states.
    pub measure: Option<&'static Measure>,
    /// The comment behind it in files that this program writes.
    pub comment: &'static str,
}

/// The keys of sections of the list.
pub fn keys(sections: &str) -> Vec<Key> {
    sections.split(' ').flat_map(section).collect()
}

fn section(name: &str) -> impl Iterator<Item = Key> {
    let head = format!("[{name}]");
    let lines = LIST.lines().skip_while(move |line| *line != head).skip(1);
    lines.take_while(|line| !line.is_empty()).map(|line| {
        let mut parts = line.splitn(4, " : ");
        let [name, kind, about, comment] = [(); 4].map(|()| parts.next().unwrap_or_default());
        let key = name.trim_end_matches('*');
        let kind = if kind == "law" {
            format!("word {}", Law::names().join(" "))
        } else {
            kind.into()
        };
        Key {
            name: key,
            kind: kind.into(),
            about,
            is_needed: key != name,
            measure: None,
            comment,
        }
    })
}

impl Key {
    /// A key that a table of this program makes.
    fn made(name: &'static str, kind: impl Into<Cow<'static, str>>, about: &'static str) -> Self {
        Self {
            name,
            kind: kind.into(),
            about,
            is_needed: false,
            measure: None,
            comment: about,
        }
    }

    fn of_constant(constant: &'static Constant, law: &LawKind) -> Self {
        let one = if constant.is_modulus() {
            "pressure"
        } else {
            "number"
        };
        let kind = if law.is_sum {
            format!("list {one}").into()
        } else {
            Cow::Borrowed(one)
        };
        Self::made(constant.name, kind, constant.doc)
    }

    /// The keys of a rubber's table with the constants of some laws.
    pub(super) fn material(laws: &'static [LawKind]) -> Vec<Self> {
        let constants = laws
            .iter()
            .flat_map(|law| law.constants.iter().map(|c| Self::of_constant(c, law)));
        keys("law")
            .into_iter()
            .chain(constants)
            .chain(keys("material"))
            .collect()
    }

    /// The keys of the table that it names; of a rubber those of `law`, or of all laws.
    pub fn table(&self, law: Option<&str>) -> Option<Vec<Self>> {
        let (word, rest) = words(&self.kind);
        Some(match word {
            "table" => keys(rest),
            "end-factor" => keys("end-factor"),
            "measures" => of_section(rest).map(of_measure).chain(keys(rest)).collect(),
            "material" => {
                let law = law.and_then(|law| Law::kind_named(law.trim()));
                Self::material(law.map_or(Law::KINDS, std::slice::from_ref))
            }
            "varied" => {
                let varied = |m: &'static Measure| {
                    Self::made(
                        m.name(),
                        format!("values {} log", name_of(m.dimension)),
                        m.about,
                    )
                };
                of_section(rest)
                    .map(varied)
                    .chain(keys(&format!("varied-{rest}")))
                    .collect()
            }
            "constants" => {
                let mut all = keys("constants");
                for constant in Law::KINDS
                    .iter()
                    .filter(|kind| !kind.is_sum)
                    .flat_map(|k| k.constants)
                {
                    if all.iter().all(|known| known.name != constant.name) {
                        let kind = format!("values {} log", name_of(constant.dimension));
                        all.push(Self::made(constant.name, kind, constant.doc));
                    }
                }
                all
            }
            _ => return None,
        })
    }
}

/// The first word of a kind, and the rest.
pub(super) fn words(kind: &str) -> (&str, &str) {
    kind.split_once(' ').unwrap_or((kind, ""))
}

fn of_measure(measure: &'static Measure) -> Key {
    let kind = measure
        .kind
        .map_or_else(|| name_of(measure.dimension), Cow::Borrowed);
    let made = Key::made(measure.name(), kind, measure.about);
    Key {
        measure: Some(measure),
        comment: measure.comment,
        ..made
    }
}

/// Every key of sections with the tables in them, dotted; tells a key in the wrong table from one
/// that means nothing anywhere.
pub(super) fn dotted(path: &str, keys: Vec<Key>) -> Vec<String> {
    // Nobody writes the keys of [identified] by hand.
    let written = keys.into_iter().filter(|key| key.name != "identified");
    let one = |key: Key| {
        let name = join(path, key.name);
        let inner = key
            .table(None)
            .map_or_else(Vec::new, |table| dotted(&name, table));
        std::iter::once(name).chain(inner)
    };
    written.flat_map(one).collect()
}

/// The dotted name of a key in a table.
pub(super) fn join(path: &str, key: &str) -> String {
    if path.is_empty() {
        key.to_owned()
    } else {
        format!("{path}.{key}")
    }
}

/// The dimension of a name such as `angular-stiffness`.
pub fn dimension(name: &str) -> Option<Dimension> {
    mckibben_io::named(name)
}

/// The same the other way.
fn name_of(dimension: Dimension) -> Cow<'static, str> {
    let name = serde_json::to_value(dimension).ok();
    name.and_then(|name| name.as_str().map(str::to_owned))
        .unwrap_or_default()
        .into()
}
